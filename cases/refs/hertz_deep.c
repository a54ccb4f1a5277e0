/* Reference: Hertz's impact with critical damping beyond a given overlap: the equation of motion, by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - 2 beta (m* 2 E* a)^(1/2) alpha'     [R89 4.13, sec. 6.4.3]
 *
 * in the symbols of hertz.h, with beta = 1 where alpha > f 2 min(R_1, R_2) and the damping ratio of the page elsewhere.
 * f is the fraction in `damping critical beyond overlap`. hertz_motion.c solves the equation piece by piece for
 * s = alpha/alpha*. Integration with s as the independent variable finds the times at which s crosses the limit or is 0
 * again.
 *
 * Returns, for C that monitors the contact:  C.overlap max;  impact.duration, impact.restitution.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "hertz.h"
#include "hertz_motion.h"

/* Integrates y until s returns to `end` (hertz_rebound). False: GSL failed, or s does not return up to t = 50. */
static bool integrate_to_rebound(double y[], double beta, double end, double deepest[]) {
  return hertz_rebound(y, beta, end, 50, deepest) && !(y[HERTZ_OVERLAP] > end);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_read(&hertz, scene, "hertz_deep", error))
    return error->status;
  const struct nb_particle *a = hertz.particles[0], *b = hertz.particles[1];
  const double smaller = b && b->radius < a->radius ? b->radius : a->radius;
  const double limit = scene->damping.deep * 2 * smaller / hertz.depth, beta = hertz.damping;
  double y[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT, deepest[HERTZ_UNKNOWNS] = {0};
  double trial[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT;
  bool solved = integrate_to_rebound(trial, beta, 0, deepest);
  if (solved && deepest[HERTZ_OVERLAP] > limit)
    solved = hertz_integrate(y, beta, HERTZ_OVERLAP, limit) && integrate_to_rebound(y, 1, limit, deepest) &&
             integrate_to_rebound(y, beta, 0, deepest);
  else
    memcpy(y, trial, sizeof y);
  if (!solved)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `hertz_deep` is for an impact that ends, with dashpots well below critical "
                        "damping");
  hertz_add(solution, &hertz, "overlap max", deepest[HERTZ_OVERLAP] * hertz.depth);
  solution_value(solution, y[HERTZ_TIME] * hertz.unit, "impact.duration");
  solution_value(solution, -y[HERTZ_SPEED], "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_deep = {
    .name = "hertz_deep",
    .title = "Hertz's impact with critical damping beyond a given overlap: ODE by GSL at 1e-13",
    .source = "[R89 4.13, sec. 6.4.3]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL,
                HAS_RATIO_DAMPING, HAS_WALL_DAMPING},
    .needs = {HAS_CRITICAL_DAMPING},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
