/* Reference: Hertz's impact with a dashpot of the share beta of critical damping: the equation of motion by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - c alpha',   c = 2 beta (m* 2 E* a)^(1/2),   a^2 = R* alpha        [R89 4.13, 5.6]
 *
 * With s = alpha/alpha*, t in alpha* / V_N, alpha* that of no damping, nothing is left of the pair but beta:
 *
 *   s'' = -(5/4) s^(3/2) - (15/2)^(1/2) beta s^(1/4) s',     s(0) = 0, s'(0) = 1
 *
 * solved with the eighth-order method of Prince and Dormand at 1e-13. The deepest point is found with s' as what is
 * integrated along, the end with s, so that neither has to be sought (Henon 1982).
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
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <string.h>

#include "hertz.h"

enum { TIME, WAY, SPEED, UNKNOWNS }; /* t, s, s' */
enum { NODES = 256 };                /* kept on the way, to start from when the curve is asked for */

struct impact {
  struct hertz hertz;
  double end, rebound;          /* when s is 0 again, and -s' then; infinite and 0: never */
  double deepest, stopped;      /* largest s, and when */
  double reach;                 /* up to where the nodes go, t */
  double node[NODES][UNKNOWNS]; /* at equal distances of t, from 0 */
};

struct motion {
  double drag; /* (15/2)^(1/2) beta */
  int along;   /* which unknown is integrated along */
};

static int slope(double x, const double y[], double dydx[], void *data) {
  const struct motion *motion = data;
  const double s = y[WAY] > 0 ? y[WAY] : 0, root = sqrt(s);
  const double rate[UNKNOWNS] = {1, y[SPEED], -1.25 * s * root - motion->drag * sqrt(root) * y[SPEED]};
  (void)x;
  for (int k = 0; k < UNKNOWNS; k++)
    dydx[k] = rate[k] / rate[motion->along];
  return GSL_SUCCESS;
}

/* From y along one of its own unknowns to a value of that. */
static bool go(double y[], double drag, int along, double to) {
  struct motion motion = {drag, along};
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, &motion};
  double x = y[along];
  if (x == to)
    return true;
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, copysign(1e-6, to - x), 1e-13, 0);
  const bool gone = driver && gsl_odeiv2_driver_apply(driver, &x, to, y) == GSL_SUCCESS;
  if (driver)
    gsl_odeiv2_driver_free(driver);
  y[along] = to;
  return gone;
}

static double drag_of(double beta) { return sqrt(7.5) * beta; }

/* Down to the deepest point, and out until the outlines part; above critical damping they do not. */
static bool solve(struct impact *impact, double beta) {
  const double drag = drag_of(beta), far = 20, tick = 0.05;
  double y[UNKNOWNS] = {0, 0, 1}, before[UNKNOWNS];
  impact->end = INFINITY, impact->rebound = 0, impact->reach = far;
  while (y[TIME] < far && isinf(impact->end)) {
    memcpy(before, y, sizeof y);
    if (!go(y, drag, TIME, y[TIME] + tick))
      return false;
    if (before[SPEED] > 0 && !(y[SPEED] > 0)) {
      double lowest[UNKNOWNS];
      memcpy(lowest, before, sizeof lowest);
      if (!go(lowest, drag, SPEED, 0))
        return false;
      impact->deepest = lowest[WAY], impact->stopped = lowest[TIME];
    }
    if (!(y[WAY] > 0)) {
      if (!go(before, drag, WAY, 0))
        return false;
      impact->end = impact->reach = before[TIME], impact->rebound = -before[SPEED];
    }
  }
  memcpy(impact->node[0], (double[]){0, 0, 1}, sizeof y);
  for (int k = 1; k < NODES; k++) {
    memcpy(impact->node[k], impact->node[k - 1], sizeof y);
    if (!go(impact->node[k], drag, TIME, impact->reach * k / NODES))
      return false;
  }
  return true;
}

/* The state at a time of the run, from the node before it; all 0 while nothing touches. */
static void state_at(const struct impact *impact, double t, double y[]) {
  const double time = (t - impact->hertz.begin) / impact->hertz.unit;
  memset(y, 0, UNKNOWNS * sizeof *y);
  if (!(time > 0) || !(time < impact->end))
    return;
  const int k = (int)(time / impact->reach * NODES), last = NODES - 1;
  memcpy(y, impact->node[k < last ? k : last], UNKNOWNS * sizeof *y);
  if (!go(y, drag_of(impact->hertz.damping), TIME, time))
    y[WAY] = y[SPEED] = NAN;
}

static double overlap_at(const void *data, double t) {
  const struct impact *impact = data;
  double y[UNKNOWNS];
  state_at(impact, t, y);
  return impact->hertz.depth * y[WAY];
}
static double normal_at(const void *data, double t) {
  const struct impact *impact = data;
  return hertz_force(&impact->hertz, overlap_at(impact, t));
}
/* c alpha': what the dashpot adds, below 0 where it pulls. */
static double dashpot_at(const void *data, double t) {
  const struct impact *impact = data;
  const struct hertz *hertz = &impact->hertz;
  double y[UNKNOWNS];
  state_at(impact, t, y);
  const double a = sqrt(hertz->radius * hertz->depth * y[WAY]);
  return 2 * hertz->damping * sqrt(hertz->mass * 2 * hertz->young * a) * hertz->speed * y[SPEED];
}

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct impact impact;
  struct hertz *hertz = &impact.hertz;
  if (hertz_of(hertz, scene, "hertz_damped", error))
    return error->status;
  if (!solve(&impact, hertz->damping))
    return nb_error_set(error, NB_BROKEN, "hertz_damped: the equation of motion could not be solved");
  hertz_curve(known, hertz, "overlap", "time", overlap_at, &impact, sizeof impact);
  hertz_curve(known, hertz, "normal", "time", normal_at, &impact, sizeof impact);
  hertz_curve(known, hertz, "dashpot.normal", "time", dashpot_at, &impact, sizeof impact);
  hertz_tell_stages(known, hertz, overlap_at, &impact, hertz->depth * impact.deepest,
                    hertz->begin + hertz->unit * impact.stopped);
  if (isfinite(impact.end))
    known_value(known, impact.end * hertz->unit, "impact.duration");
  known_value(known, impact.rebound, "impact.restitution");
  return known_full(known, error);
}

const struct nb_reference reference_hertz_damped = {
    .name = "hertz_damped",
    .title = "Hertz's impact with a dashpot of constant share of critical damping: ODE by GSL at 1e-13",
    .source = "[R89 4.13, 5.6]",
    .know = know,
};
