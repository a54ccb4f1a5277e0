/* Reference: Hertz's impact with a dashpot of the damping ratio beta: the equation of motion, by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - c alpha',   c = 2 beta (m* 2 E* a)^(1/2),   a^2 = R* alpha        [R89 4.13, 5.6]
 *
 * in the symbols of hertz.h. hertz_motion.c solves it for s = alpha/alpha*. Integration with s' as the independent
 * variable finds the largest overlap, integration with s as the independent variable finds the end of the contact.
 *
 * The dashpot acts, and at the end pulls, while the overlap is positive, as in the simulator: the contact ends when the
 * overlap is 0 again. For beta >= (5/6)^(1/2) = 0.9129 the contact does not end. A contact longer than 20 alpha* / V_N
 * is treated like that: it has the restitution 0 and no duration. hertz_restitution computes the restitution in closed
 * form; a test compares the two.
 *
 * Returns, for C that monitors the contact:
 *   C.overlap max, C.normal max;   C.overlap, C.normal (elastic force) and C.dashpot.normal versus time
 *   C.overlap, C.normal in STAGE   at the end of each stage before the first with a condition or with another step; for
 *                                  the stage with the largest overlap also C.overlap max, C.normal max in STAGE
 *   impact.duration, impact.restitution
 * Error    1e-13, the tolerance of the integration.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "hertz.h"
#include "hertz_motion.h"

enum { NODES = 256 }; /* stored states, from which a point of a curve is integrated */

struct impact {
  struct hertz hertz;
  double end, rebound;                /* t at which s is 0 again, and -s' then; INFINITY and 0: no end up to t = 20 */
  double largest, largest_time;       /* the largest s, and the t at which it occurs */
  double last;                        /* t up to which there are nodes: the end of the contact, or 20 */
  double node[NODES][HERTZ_UNKNOWNS]; /* states at t = 0, last/NODES, 2 last/NODES, … */
};

/* Finds the largest overlap, the end of the contact, if it has one, and the nodes. */
static bool solve_equations(struct impact *impact, double beta) {
  const double longest = 20;
  double y[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT, deepest[HERTZ_UNKNOWNS] = {0};
  if (!hertz_rebound(y, beta, 0, longest, deepest))
    return false;
  const bool ends = !(y[HERTZ_OVERLAP] > 0);
  impact->end = ends ? y[HERTZ_TIME] : INFINITY;
  impact->rebound = ends ? -y[HERTZ_SPEED] : 0;
  impact->last = ends ? impact->end : longest;
  impact->largest = deepest[HERTZ_OVERLAP], impact->largest_time = deepest[HERTZ_TIME];
  memcpy(impact->node[0], (double[])HERTZ_FIRST_CONTACT, sizeof y);
  for (int k = 1; k < NODES; k++) {
    memcpy(impact->node[k], impact->node[k - 1], sizeof y);
    if (!hertz_integrate(impact->node[k], beta, HERTZ_TIME, impact->last * k / NODES))
      return false;
  }
  return true;
}

/* The state at a time of the run, integrated from the node before it; 0 without contact. */
static void state_at(const struct impact *impact, double t, double y[]) {
  const double time = (t - impact->hertz.begin) / impact->hertz.unit;
  memset(y, 0, HERTZ_UNKNOWNS * sizeof *y);
  if (!(time > 0) || !(time < impact->end))
    return;
  if (time > 100 * impact->last) { /* an overdamped contact never ends; its overlap is not computed so late */
    y[HERTZ_OVERLAP] = y[HERTZ_SPEED] = NAN;
    return;
  }
  const int k = (int)fmin(time / impact->last * NODES, NODES - 1);
  memcpy(y, impact->node[k], HERTZ_UNKNOWNS * sizeof *y);
  if (!hertz_integrate(y, impact->hertz.damping, HERTZ_TIME, time))
    y[HERTZ_OVERLAP] = y[HERTZ_SPEED] = NAN;
}

static double overlap_at(const void *data, double t) {
  const struct impact *impact = data;
  double y[HERTZ_UNKNOWNS];
  state_at(impact, t, y);
  return impact->hertz.depth * y[HERTZ_OVERLAP];
}
static double normal_at(const void *data, double t) {
  const struct impact *impact = data;
  return hertz_force(&impact->hertz, overlap_at(impact, t));
}
/* c alpha', negative where the dashpot pulls */
static double dashpot_at(const void *data, double t) {
  const struct impact *impact = data;
  const struct hertz *hertz = &impact->hertz;
  double y[HERTZ_UNKNOWNS];
  state_at(impact, t, y);
  const double a = sqrt(hertz->radius * hertz->depth * y[HERTZ_OVERLAP]);
  return 2 * hertz->damping * sqrt(hertz->mass * 2 * hertz->young * a) * hertz->speed * y[HERTZ_SPEED];
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct impact impact;
  struct hertz *hertz = &impact.hertz;
  if (hertz_read(hertz, scene, "hertz_damped", error))
    return error->status;
  if (!solve_equations(&impact, hertz->damping))
    return nb_error_set(error, NB_BROKEN, "hertz_damped: the equation of motion could not be solved");
  hertz_curve(solution, hertz, "overlap", "time", overlap_at, &impact, sizeof impact);
  hertz_curve(solution, hertz, "normal", "time", normal_at, &impact, sizeof impact);
  hertz_curve(solution, hertz, "dashpot.normal", "time", dashpot_at, &impact, sizeof impact);
  hertz_add_stages(solution, hertz, overlap_at, &impact, hertz->depth * impact.largest,
                   hertz->begin + hertz->unit * impact.largest_time);
  if (isfinite(impact.end))
    solution_value(solution, impact.end * hertz->unit, "impact.duration");
  solution_value(solution, impact.rebound, "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_damped = {
    .name = "hertz_damped",
    .title = "Hertz's impact with a dashpot of constant damping ratio: ODE by GSL at 1e-13",
    .source = "[R89 4.13, 5.6]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL,
                HAS_RATIO_DAMPING, HAS_WALL_DAMPING, HAS_CENTRED_DASHPOTS},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
