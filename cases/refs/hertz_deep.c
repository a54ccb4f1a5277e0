/* Reference: Hertz's impact with a dashpot that is critical while the overlap is deep: the equation of motion by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - 2 beta (m* 2 E* a)^(1/2) alpha',   beta = 1 where alpha > f 2 min(R_1, R_2)     [R89 4.13, 6.4.3]
 *
 * and what the page says elsewhere. Solved piece by piece in s = alpha/alpha* by hertz_motion.c; where s crosses the limit, or
 * ends, along s.
 *
 * Known, where C is the watched contact:  C.overlap max;  impact.duration, impact.restitution.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "hertz.h"
#include "hertz_motion.h"

/* Through the deepest point, which is told, and out to s = `end`. */
static bool turn(double y[], double beta, double end, double lowest[]) {
  const double tick = 0.02, far = 50;
  while (y[HERTZ_TIME] < far) {
    double before[HERTZ_UNKNOWNS];
    memcpy(before, y, sizeof before);
    if (!hertz_tick(y, beta, tick, lowest))
      return false;
    if (y[HERTZ_SPEED] < 0 && !(y[HERTZ_WAY] > end)) {
      memcpy(y, before, sizeof before);
      return hertz_go(y, beta, HERTZ_WAY, end);
    }
  }
  return false;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_of(&hertz, scene, "hertz_deep", error))
    return error->status;
  const struct nb_particle *a = hertz.particles[0], *b = hertz.particles[1];
  const double smaller = b && b->radius < a->radius ? b->radius : a->radius;
  const double limit = scene->damping.deep * 2 * smaller / hertz.depth, beta = hertz.damping;
  double y[HERTZ_UNKNOWNS] = HERTZ_TOUCH, lowest[HERTZ_UNKNOWNS] = {0};
  if (!(limit > 0))
    return nb_error_set(error, NB_BAD_USE, "hertz_deep is for `damping critical beyond overlap`");
  double trial[HERTZ_UNKNOWNS] = HERTZ_TOUCH;
  bool solved = turn(trial, beta, 0, lowest);
  if (solved && lowest[HERTZ_WAY] > limit)
    solved = hertz_go(y, beta, HERTZ_WAY, limit) && turn(y, 1, limit, lowest) && turn(y, beta, 0, lowest);
  else
    memcpy(y, trial, sizeof y);
  if (!solved)
    return nb_error_set(error, NB_BROKEN, "hertz_deep: the equation of motion could not be solved");
  hertz_add(solution, &hertz, "overlap max", lowest[HERTZ_WAY] * hertz.depth);
  solution_value(solution, y[HERTZ_TIME] * hertz.unit, "impact.duration");
  solution_value(solution, -y[HERTZ_SPEED], "impact.restitution");
  return solution_full(solution, error);
}

const struct nb_reference reference_hertz_deep = {
    .name = "hertz_deep",
    .title = "Hertz's impact, damped critically where it is deep: ODE by GSL at 1e-13",
    .source = "[R89 4.13, 6.4.3]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL,
                HAS_CONTACT_RATIO, HAS_WALL_DAMPING},
    .needs = {HAS_DEEP_DAMPING},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
