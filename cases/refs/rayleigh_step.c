/* Reference: R89's time step, and pairs of equal spheres that collide head-on without damping.
 *
 *   t = pi R (rho/G)^(1/2) / alpha                                     [R89 4.33]
 *
 * alpha^2 = x is the root of Rayleigh's equation between 0.75 and 0.92. Squared [R89 4.32] and divided by x, the
 * equation is a cubic,
 *
 *   x^3 - 8 x^2 + (24 - 16 q) x - 16 (1 - q) = 0,   q = (1 - 2 nu)/(2 (1 - nu))
 *
 * solved in closed form. R89's fit is alpha = 0.1631 nu + 0.876605 [R89 4.34].
 *
 * Returns
 *   step.rayleigh, step.rayleigh-fit             of the particle for which it is shortest
 *   step.rayleigh-mean, step.rayleigh-fit-mean   of the means of R, rho, G and nu over the particles
 *   D.vx, D.vy                                   at the end, for D that monitors a particle: the equal spheres 1 and 2,
 *                                                3 and 4, ... exchange their velocities; the leading error of the run's
 *                                                time integration, n^(-5/2), is included (hertz_corner.h)
 * Error    `step.*`: rounding. Velocities: the next order, n^(-7/2), with n steps per collision.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_poly.h>
#include <math.h>
#include <string.h>

#include "hertz.h"
#include "hertz_corner.h"

static const double pi = 3.14159265358979323846;

/* alpha: the root of Rayleigh's equation, or R89's fit. */
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
  double radius, density, shear, poisson; /* R, m; rho, kg/m3; G, Pa; nu */
};

static double travel_time(struct grain grain, bool fit) {
  return pi * grain.radius * sqrt(grain.density / grain.shear) / wave(grain.poisson, fit);
}

/* The restitution e of two equal spheres that close the gap between them and collide head-on, in steps of dt. */
static double rebound(const struct nb_scene *scene, const struct nb_particle *a, const struct nb_particle *b,
                      double dt) {
  const double young = matter_pair(scene, a->material, b->material).young;
  const double mass = matter_mass(scene, a) / 2, speed = hypot(a->vx - b->vx, a->vy - b->vy);
  const double gap = hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius;
  const double depth = pow(15 * mass * speed * speed / (16 * young * sqrt(a->radius / 2)), 0.4); /* [R89 5.9] */
  const double unit = depth / speed;
  return 1 + hertz_restitution_error(dt / unit, gap / speed / dt, hertz_duration_factor() * unit / dt);
}

static bool collide_head_on(const struct nb_particle *a, const struct nb_particle *b) {
  const double x = b->x - a->x, y = b->y - a->y, vx = a->vx - b->vx, vy = a->vy - b->vy;
  return vx * x + vy * y > 0 && fabs(vx * y - vy * x) < 1e-9 * hypot(x, y) * hypot(vx, vy);
}

/* The step of the run, s; 0 if it is not one of R89's: then e = 1. `shortest` has step.rayleigh and
 * step.rayleigh-fit. */
static double step_of(const struct nb_scene *scene, const double shortest[2], struct grain mean) {
  const bool fit = scene->step.kind == NB_STEP_RAYLEIGH_FIT || scene->step.kind == NB_STEP_RAYLEIGH_FIT_MEAN;
  if (scene->step.kind == NB_STEP_RAYLEIGH || scene->step.kind == NB_STEP_RAYLEIGH_FIT)
    return scene->step.value * shortest[fit];
  if (scene->step.kind == NB_STEP_RAYLEIGH_MEAN || scene->step.kind == NB_STEP_RAYLEIGH_FIT_MEAN)
    return scene->step.value * travel_time(mean, fit);
  return 0;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct grain mean = {0};
  double shortest[2] = {INFINITY, INFINITY};
  const double fraction = 1 / (double)scene->particle_count;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const struct nb_material *of = &scene->materials[particle->material];
    if (isinf(of->young))
      return nb_error_set(error, NB_BAD_USE, "the reference `rayleigh_step` is for elastic particles");
    const struct grain grain = {particle->radius, of->density, of->young / (2 + 2 * of->poisson), of->poisson};
    for (int fit = 0; fit < 2; fit++)
      shortest[fit] = fmin(shortest[fit], travel_time(grain, fit));
    mean.radius += fraction * grain.radius, mean.density += fraction * grain.density;
    mean.shear += fraction * grain.shear, mean.poisson += fraction * grain.poisson;
  }
  solution_value(solution, shortest[0], "step.rayleigh");
  solution_value(solution, shortest[1], "step.rayleigh-fit");
  solution_value(solution, travel_time(mean, false), "step.rayleigh-mean");
  solution_value(solution, travel_time(mean, true), "step.rayleigh-fit-mean");
  const double dt = step_of(scene, shortest, mean);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const size_t other = (size_t)monitor->a ^ 1u;
    char name[3 * NB_NAME_SIZE];
    if (monitor->kind != NB_MONITOR_PARTICLE || other >= scene->particle_count)
      continue;
    const struct nb_particle *self = &scene->particles[monitor->a], *it = &scene->particles[other];
    if (self->radius != it->radius || self->material != it->material || !collide_head_on(self, it))
      continue;
    const double e = dt > 0 ? rebound(scene, self, it, dt) : 1;
    snprintf(name, sizeof name, "%s.vx", monitor->name);
    solution_value(solution, (self->vx + it->vx + e * (it->vx - self->vx)) / 2, name);
    snprintf(name, sizeof name, "%s.vy", monitor->name);
    solution_value(solution, (self->vy + it->vy + e * (it->vy - self->vy)) / 2, name);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_rayleigh_step = {
    .name = "rayleigh_step",
    .title = "R89's step, with the wave speed from the cubic; two equal spheres that collide head-on",
    .source = "[R89 4.29-4.34]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
