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
 *   NAME.vx, NAME.vy                             of a watched body, at the end: two like spheres that meet head-on exchange
 *                                                their velocities. For bodies 1 and 2, 3 and 4, ...
 * The steps are exact to rounding; velocities in continuous time.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_poly.h>
#include <math.h>
#include <string.h>

#include "reference.h"

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

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct grain mean = {0};
  double shortest[2] = {INFINITY, INFINITY};
  const double share = 1 / (double)scene->body_count;
  for (size_t k = 0; k < scene->body_count; k++) {
    const struct nb_body *body = &scene->bodies[k];
    const struct nb_material *of = &scene->materials[body->material];
    if (body->fixed || !(of->young > 0) || isinf(of->young))
      return nb_error_set(error, NB_BAD_USE, "reference rayleigh_step is for elastic bodies that are free");
    const struct grain grain = {body->radius, of->density, of->young / (2 + 2 * of->poisson), of->poisson};
    for (int fit = 0; fit < 2; fit++)
      shortest[fit] = fmin(shortest[fit], half_round(grain, fit));
    mean.radius += share * grain.radius, mean.density += share * grain.density;
    mean.shear += share * grain.shear, mean.poisson += share * grain.poisson;
  }
  known_value(known, shortest[0], "step.rayleigh");
  known_value(known, shortest[1], "step.rayleigh-fit");
  known_value(known, half_round(mean, false), "step.rayleigh-mean");
  known_value(known, half_round(mean, true), "step.rayleigh-fit-mean");
  for (size_t w = 0; w < scene->watch_count; w++) {
    const struct nb_watch *watch = &scene->watches[w];
    const size_t other = (size_t)watch->a ^ 1u;
    char name[3 * NB_NAME_SIZE];
    if (watch->kind != NB_WATCH_BODY || other >= scene->body_count)
      continue;
    snprintf(name, sizeof name, "%s.vx", watch->name);
    known_value(known, scene->bodies[other].vx, name);
    snprintf(name, sizeof name, "%s.vy", watch->name);
    known_value(known, scene->bodies[other].vy, name);
  }
  return known_full(known, error);
}

const struct nb_reference reference_rayleigh_step = {
    .name = "rayleigh_step",
    .title = "R89's step, the wave's speed from the cubic; two like spheres that meet head-on",
    .source = "[R89 4.29-4.34]",
    .know = know,
};
