/* Reference: R89's step, and pairs of like spheres that meet head-on without damping.
 *
 *   t = pi R (rho/G)^(1/2) / alpha                                     [R89 4.33]
 *
 * alpha^2 = x is the root of Rayleigh's equation between 0.75 and 0.92. Its square [R89 4.32], divided by x, is a cubic,
 *
 *   x^3 - 8 x^2 + (24 - 16 q) x - 16 (1 - q) = 0,   q = (1 - 2 nu)/(2 (1 - nu))
 *
 * solved in closed form. With R89's fit instead: alpha = 0.1631 nu + 0.876605 [R89 4.34].
 *
 * Known
 *   step.rayleigh, step.rayleigh-fit             of the body for which it is shortest
 *   step.rayleigh-mean, step.rayleigh-fit-mean   of the means of R, rho, G and nu over the bodies
 *   NAME.vx, NAME.vy                             of a watched body, at the end: two like spheres that meet head-on, bodies 1
 *                                                and 2, 3 and 4, ..., exchange their velocities but for what leapfrog gains
 *                                                at the corners of the contact by such a step (hertz_corner.h)
 * The steps are exact to rounding. Velocities to the order n^(-5/2), n steps in a contact: with few of them that is some
 * percent, and which it is follows from where in a step they touch.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_poly.h>
#include <math.h>
#include <string.h>

#include "hertz.h"
#include "hertz_corner.h"

static const double pi = 3.14159265358979323846;

static double wave(double nu, bool fit) {
  const double q = (1 - 2 * nu) / (2 * (1 - nu));
  double x[3] = {NAN, NAN, NAN};
  if (fit)
    return 0.1631 * nu + 0.876605;
  const int roots = gsl_poly_solve_cubic(-8, 24 - 16 * q, -16 * (1 - q), &x[0], &x[1], &x[2]);
  for (int k = 0; k < roots; k++)
    if (x[k] > 0.75 && x[k] < 0.92)
      return sqrt(x[k]);
  return NAN;
}

struct grain {
  double radius, density, shear, poisson;
};

static double half_round(struct grain grain, bool fit) {
  return pi * grain.radius * sqrt(grain.density / grain.shear) / wave(grain.poisson, fit);
}

/* e of two like spheres that meet head-on after flying through the gap between them, in steps of dt. */
static double rebound(const struct nb_scene *scene, const struct nb_particle *a, const struct nb_particle *b,
                      double dt) {
  const double young = matter_pair(scene, a->material, b->material).young;
  const double mass = matter_mass(scene, a) / 2, speed = hypot(a->vx - b->vx, a->vy - b->vy);
  const double gap = hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius;
  const double depth = pow(15 * mass * speed * speed / (16 * young * sqrt(a->radius / 2)), 0.4); /* [R89 5.9] */
  const double unit = depth / speed;
  return 1 + hertz_gain(dt / unit, gap / speed / dt, hertz_time() * unit / dt);
}

/* The step of the run; 0 where it is none of R89's, and then velocities are those of no step. */
static double step_of(const struct nb_scene *scene, const double shortest[2], struct grain mean) {
  const bool fit = scene->step.kind == NB_STEP_RAYLEIGH_FIT || scene->step.kind == NB_STEP_RAYLEIGH_FIT_MEAN;
  if (scene->step.kind == NB_STEP_RAYLEIGH || scene->step.kind == NB_STEP_RAYLEIGH_FIT)
    return scene->step.value * shortest[fit];
  if (scene->step.kind == NB_STEP_RAYLEIGH_MEAN || scene->step.kind == NB_STEP_RAYLEIGH_FIT_MEAN)
    return scene->step.value * half_round(mean, fit);
  return 0;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct grain mean = {0};
  double shortest[2] = {INFINITY, INFINITY};
  const double fraction = 1 / (double)scene->particle_count;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const struct nb_material *of = &scene->materials[particle->material];
    if (particle->fixed || !(of->young > 0) || isinf(of->young))
      return nb_error_set(error, NB_BAD_USE, "reference rayleigh_step is for elastic bodies that are free");
    const struct grain grain = {particle->radius, of->density, of->young / (2 + 2 * of->poisson), of->poisson};
    for (int fit = 0; fit < 2; fit++)
      shortest[fit] = fmin(shortest[fit], half_round(grain, fit));
    mean.radius += fraction * grain.radius, mean.density += fraction * grain.density;
    mean.shear += fraction * grain.shear, mean.poisson += fraction * grain.poisson;
  }
  solution_value(solution, shortest[0], "step.rayleigh");
  solution_value(solution, shortest[1], "step.rayleigh-fit");
  solution_value(solution, half_round(mean, false), "step.rayleigh-mean");
  solution_value(solution, half_round(mean, true), "step.rayleigh-fit-mean");
  const double dt = step_of(scene, shortest, mean);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const size_t other = (size_t)monitor->a ^ 1u;
    char name[3 * NB_NAME_SIZE];
    if (monitor->kind != NB_MONITOR_PARTICLE || other >= scene->particle_count)
      continue;
    const struct nb_particle *self = &scene->particles[monitor->a], *it = &scene->particles[other];
    const double e = dt > 0 ? rebound(scene, self, it, dt) : 1;
    snprintf(name, sizeof name, "%s.vx", monitor->name);
    solution_value(solution, (self->vx + it->vx + e * (it->vx - self->vx)) / 2, name);
    snprintf(name, sizeof name, "%s.vy", monitor->name);
    solution_value(solution, (self->vy + it->vy + e * (it->vy - self->vy)) / 2, name);
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_rayleigh_step = {
    .name = "rayleigh_step",
    .title = "R89's step, the wave's speed from the cubic; two like spheres that meet head-on",
    .source = "[R89 4.29-4.34]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
