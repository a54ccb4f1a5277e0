/* Reference: Hertz's impact of two elastic spheres, or of a sphere on a wall: quadrature and its inverse.
 * The symbols are those of hertz.h.
 *
 *   alpha* = (5 m* V_N^2/(4 K))^(2/5),   N* = K alpha*^(3/2)                                    [R89 5.5, 5.9]
 *   t = (alpha* / V_N) Int_0^(alpha/alpha*) ds/(1 - s^(5/2))^(1/2)   up to alpha*                [R89 5.10]
 *   T_c = 2.9432751843247047 alpha* / V_N                                                        [R89 5.12]
 *
 * Unloading mirrors loading in time. The integrand is singular at the largest overlap. With
 * (alpha/alpha*)^(5/4) = sin(theta), and the same substitution for s, the time becomes
 *
 *   t = (4/5) (alpha* / V_N) Int_0^theta x^(-1/5) (x/sin(x))^(1/5) dx,     theta up to pi/2,
 *
 * the integral of a weight times a smooth function, which a Gauss-Jacobi rule of twenty points computes exactly, up to
 * rounding. Brent's method inverts t(theta), which gives alpha(t).
 *
 * Returns, for C that monitors the contact:
 *   C.overlap max, C.normal max;   C.normal versus C.overlap;   C.overlap, C.normal versus time
 *   C.overlap, C.normal in STAGE   at the end of each stage before the first with a condition or with another step; for
 *                                  the stage with the largest overlap also C.overlap max, C.normal max in STAGE
 *   impact.duration = T_c,  impact.restitution = 1
 * Exact in continuous time.
 *
 * Source   Hertz (1882) in [R89 5.1-5.12].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include "hertz.h"

enum { POINTS = 20 };

struct instant {
  const gsl_integration_fixed_workspace *rule; /* on 0 to 1 with the weight x^(-1/5) */
  double time;                                 /* t V_N/alpha* */
};

/* t V_N/alpha* of loading up to theta, minus `time` of the instant `data`. */
static double time_difference(double theta, void *data) {
  const struct instant *instant = data;
  const double *x = gsl_integration_fixed_nodes(instant->rule), *w = gsl_integration_fixed_weights(instant->rule);
  double sum = 0;
  for (int k = 0; k < POINTS; k++)
    sum += w[k] * (theta > 0 ? pow(theta * x[k] / sin(theta * x[k]), 0.2) : 1);
  return 0.8 * pow(theta, 0.8) * sum - instant->time;
}

static double root(struct instant *instant) {
  gsl_function f = {time_difference, instant};
  gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  if (!solver)
    return NAN;
  const bool set = gsl_root_fsolver_set(solver, &f, 0, M_PI / 2) == GSL_SUCCESS;
  for (int n = 0; set && n < 100; n++)
    if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS ||
        gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 1e-15, 1e-15) ==
            GSL_SUCCESS)
      break;
  const double theta = set ? gsl_root_fsolver_root(solver) : NAN;
  gsl_root_fsolver_free(solver);
  return theta;
}

/* alpha/alpha* at the time t since first contact; `time` is t V_N/alpha*. */
static double relative_overlap(double time) {
  const double whole = hertz_duration_factor();
  struct instant instant = {.time = time > whole / 2 ? whole - time : time};
  if (!(instant.time > 0))
    return 0;
  gsl_integration_fixed_workspace *rule =
      gsl_integration_fixed_alloc(gsl_integration_fixed_jacobi, POINTS, 0, 1, 0, -0.2);
  if (!rule)
    return NAN;
  instant.rule = rule;
  const double theta = time_difference(M_PI / 2, &instant) > 0 ? root(&instant) : M_PI / 2;
  gsl_integration_fixed_free(rule);
  return pow(sin(theta), 0.8);
}

static double overlap_at(const void *data, double t) {
  const struct hertz *hertz = data;
  return hertz->depth * relative_overlap((t - hertz->begin) / hertz->unit);
}
static double normal_at(const void *data, double t) { return hertz_force(data, overlap_at(data, t)); }

static double normal_on(const void *data, double overlap) { return hertz_force(data, overlap); }

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_read(&hertz, scene, "hertz_impact", error))
    return error->status;
  hertz_curve(solution, &hertz, "overlap", "time", overlap_at, &hertz, sizeof hertz);
  hertz_curve(solution, &hertz, "normal", "time", normal_at, &hertz, sizeof hertz);
  hertz_curve(solution, &hertz, "normal", "overlap", normal_on, &hertz, sizeof hertz);
  hertz_add_stages(solution, &hertz, overlap_at, &hertz, hertz.depth, hertz.begin + hertz.duration / 2);
  solution_value(solution, hertz.duration, "impact.duration");
  solution_value(solution, 1, "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_impact = {
    .name = "hertz_impact",
    .title = "two elastic spheres, or a sphere and a wall, head-on: alpha(t) by quadrature and its inverse",
    .source = "[R89 5.5-5.12]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL},
    .normal = "hertz hertz_increment", /* R89's sum of increments is expected to deviate */
    .shear = "none",
    .solve = solve,
};
