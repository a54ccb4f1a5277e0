/* Reference: Hertz's impact with a dashpot of the share beta of critical damping: the equation of motion by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - c alpha',   c = 2 beta (m* 2 E* a)^(1/2),   a^2 = R* alpha        [R89 4.13, 5.6]
 *
 * solved in s = alpha/alpha* by hertz_motion.c: the deepest point along s', the end along s.
 *
 * The dashpot acts, and at the end pulls, as long as the outlines overlap, as the simulator's does: the contact ends with the
 * overlap. From beta = (5/6)^(1/2) = 0.9129 on it does not end. hertz_restitution has the same e in closed form, for tests.
 *
 * Known, where C is the watched contact:
 *   C.overlap max, C.normal max;   C.overlap, C.normal (elastic) and C.dashpot.normal along time;  the first two in STAGE, at its
 *   end, where the page says its number of cycles
 *   impact.duration, impact.restitution
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "hertz.h"
#include "hertz_motion.h"

enum { NODES = 256 }; /* kept on the way, to start from when the curve is asked for */

struct impact {
  struct hertz hertz;
  double end, rebound;                /* when s is 0 again, and -s' then; infinite and 0: never */
  double deepest, stopped;            /* largest s, and when */
  double reach;                       /* up to where the nodes go, t */
  double node[NODES][HERTZ_UNKNOWNS]; /* at equal distances of t, from 0 */
};

/* Down to the deepest point, and out until the outlines part; above critical damping they do not. */
static bool solve_equations(struct impact *impact, double beta) {
  const double far = 20, tick = 0.05;
  double y[HERTZ_UNKNOWNS] = HERTZ_TOUCH, before[HERTZ_UNKNOWNS], lowest[HERTZ_UNKNOWNS] = {0};
  impact->end = INFINITY, impact->rebound = 0, impact->reach = far;
  while (y[HERTZ_TIME] < far && isinf(impact->end)) {
    memcpy(before, y, sizeof y);
    if (!hertz_tick(y, beta, tick, lowest))
      return false;
    if (!(y[HERTZ_WAY] > 0)) {
      if (!hertz_go(before, beta, HERTZ_WAY, 0))
        return false;
      impact->end = impact->reach = before[HERTZ_TIME], impact->rebound = -before[HERTZ_SPEED];
    }
  }
  impact->deepest = lowest[HERTZ_WAY], impact->stopped = lowest[HERTZ_TIME];
  memcpy(impact->node[0], (double[])HERTZ_TOUCH, sizeof y);
  for (int k = 1; k < NODES; k++) {
    memcpy(impact->node[k], impact->node[k - 1], sizeof y);
    if (!hertz_go(impact->node[k], beta, HERTZ_TIME, impact->reach * k / NODES))
      return false;
  }
  return true;
}

/* The state at a time of the run, from the node before it; all 0 while nothing touches. */
static void state_at(const struct impact *impact, double t, double y[]) {
  const double time = (t - impact->hertz.begin) / impact->hertz.unit;
  memset(y, 0, HERTZ_UNKNOWNS * sizeof *y);
  if (!(time > 0) || !(time < impact->end))
    return;
  if (time > 100 * impact->reach) { /* it never stops creeping, and following it takes as long */
    y[HERTZ_WAY] = y[HERTZ_SPEED] = NAN;
    return;
  }
  const int k = (int)fmin(time / impact->reach * NODES, NODES - 1);
  memcpy(y, impact->node[k], HERTZ_UNKNOWNS * sizeof *y);
  if (!hertz_go(y, impact->hertz.damping, HERTZ_TIME, time))
    y[HERTZ_WAY] = y[HERTZ_SPEED] = NAN;
}

static double overlap_at(const void *data, double t) {
  const struct impact *impact = data;
  double y[HERTZ_UNKNOWNS];
  state_at(impact, t, y);
  return impact->hertz.depth * y[HERTZ_WAY];
}
static double normal_at(const void *data, double t) {
  const struct impact *impact = data;
  return hertz_force(&impact->hertz, overlap_at(impact, t));
}
/* c alpha': what the dashpot adds, below 0 where it pulls. */
static double dashpot_at(const void *data, double t) {
  const struct impact *impact = data;
  const struct hertz *hertz = &impact->hertz;
  double y[HERTZ_UNKNOWNS];
  state_at(impact, t, y);
  const double a = sqrt(hertz->radius * hertz->depth * y[HERTZ_WAY]);
  return 2 * hertz->damping * sqrt(hertz->mass * 2 * hertz->young * a) * hertz->speed * y[HERTZ_SPEED];
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct impact impact;
  struct hertz *hertz = &impact.hertz;
  if (hertz_of(hertz, scene, "hertz_damped", error))
    return error->status;
  if (!solve_equations(&impact, hertz->damping))
    return nb_error_set(error, NB_BROKEN, "hertz_damped: the equation of motion could not be solved");
  hertz_curve(solution, hertz, "overlap", "time", overlap_at, &impact, sizeof impact);
  hertz_curve(solution, hertz, "normal", "time", normal_at, &impact, sizeof impact);
  hertz_curve(solution, hertz, "dashpot.normal", "time", dashpot_at, &impact, sizeof impact);
  hertz_add_stages(solution, hertz, overlap_at, &impact, hertz->depth * impact.deepest,
                   hertz->begin + hertz->unit * impact.stopped);
  if (isfinite(impact.end))
    solution_value(solution, impact.end * hertz->unit, "impact.duration");
  solution_value(solution, impact.rebound, "impact.restitution");
  return solution_full(solution, error);
}

const struct nb_reference reference_hertz_damped = {
    .name = "hertz_damped",
    .title = "Hertz's impact with a dashpot of constant share of critical damping: ODE by GSL at 1e-13",
    .source = "[R89 4.13, 5.6]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL,
                HAS_CONTACT_RATIO, HAS_WALL_DAMPING},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
