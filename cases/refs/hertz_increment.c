/* Reference: the error of Hertz's force by increments in an impact, to first order in the step.
 *
 *   N <- N + 2 E* a dn,   a = (3 N R* / (4 E*))^(1/3) with N before the step                         [R89 4.12, 4.14]
 *
 * in the symbols of hertz.h, with the normal force N, the overlap alpha, the contact radius a and the normal increment
 * dn. This is Euler's rule for dN/d(alpha) = c N^(1/3), c = 2 E* (3 R* / (4 E*))^(1/3). To the next order Euler's rule
 * solves another equation: with v = |alpha'|
 *
 *   dN/d(alpha) = c N^(1/3) -+ (dt v/2) (c^2/3) N^(-1/3)            - in loading, + in unloading
 *
 * At the same overlap the values of N^(2/3) in loading and unloading therefore differ by
 * (c dt/3) Int_alpha^alpha* (v/alpha) d(alpha). The work lost is the area of the loop,
 *
 *   (K/2) dt Int_0^alpha* alpha^(1/2) v d(alpha),    v = V_N (1 - (alpha/alpha*)^(5/2))^(1/2)
 *
 * which is the fraction (dt V_N/alpha*) B(3/5, 3/2)/2 of m* V_N^2/2, with Euler's beta function B. e is 1 minus half of
 * this fraction:
 *
 *   e = 1 - (1/4) B(3/5, 3/2) V_N dt/alpha* = 1 - 0.92797/n,        n = T_c/dt
 *
 * The work of loading, Int N d(alpha), is m* V_N^2/2 for any law. In loading d(alpha) = dN/(c N^(1/3)) + (dt v/6) dN/N,
 * so the largest force is lower than Hertz's N* by (dt/6) Int v dN, divided by d(work)/dN = (2/3) alpha*:
 *
 *   N_max = N* (1 - (3/20) B(3/5, 3/2) V_N dt/alpha*) = N* (1 - 0.55678/n)
 *
 * Returns impact.restitution and, for C that monitors the contact, C.normal max in the first stage, which must contain
 * the largest force. Errors of the largest overlap and of the duration are of the order log(n)/n, so neither is
 * returned. Error: of the order of 1/n^2.
 *
 * Source   [R89 4.11-4.14]; e and N_max derived here.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_sf_gamma.h>
#include <string.h>

#include "hertz.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_read(&hertz, scene, "hertz_increment", error))
    return error->status;
  const double fraction = gsl_sf_beta(0.6, 1.5) * hertz.step / hertz.unit;
  char what[2 * NB_NAME_SIZE];
  snprintf(what, sizeof what, "normal max in %s", scene->stages[0].name);
  hertz_add(solution, &hertz, what, hertz_force(&hertz, hertz.depth) * (1 - 0.15 * fraction));
  solution_value(solution, 1 - fraction / 4, "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_increment = {
    .name = "hertz_increment",
    .title = "energy lost by R89's increments of Hertz's force in an impact, to first order in the step",
    .source = "[R89 4.11-4.14]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL},
    .normal = "hertz_increment",
    .shear = "none",
    .solve = solve,
};
