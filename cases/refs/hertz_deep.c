/* Reference: Hertz's impact with a dashpot that is critical while the overlap is deep: the equation of motion by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - 2 beta (m* 2 E* a)^(1/2) alpha',   beta = 1 where alpha > f 2 min(R_1, R_2)     [R89 4.13, 6.4.3]
 *
 * and what the page says elsewhere. With s = alpha/alpha*, t in alpha* / V_N, alpha* that of no damping,
 *
 *   s'' = -(5/4) s^(3/2) - (15/2)^(1/2) beta s^(1/4) s',     s(0) = 0, s'(0) = 1
 *
 * piece by piece with the eighth-order method of Prince and Dormand at 1e-13. Where s crosses the limit, or ends, it is what is
 * integrated along; where s' is 0, that (Henon 1982).
 *
 * Known, where C is the watched contact:  C.overlap max;  impact.duration, impact.restitution.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

#include "hertz.h"

enum { TIME, WAY, SPEED, UNKNOWNS };

struct motion {
  double beta;
  int along; /* which unknown is integrated along */
};

static int slope(double x, const double y[], double dydx[], void *data) {
  const struct motion *motion = data;
  const double s = y[WAY] > 0 ? y[WAY] : 0, root = sqrt(s);
  const double rate[UNKNOWNS] = {1, y[SPEED], -1.25 * s * root - sqrt(7.5) * motion->beta * sqrt(root) * y[SPEED]};
  (void)x;
  for (int k = 0; k < UNKNOWNS; k++)
    dydx[k] = rate[k] / rate[motion->along];
  return GSL_SUCCESS;
}

static bool go(double y[], double beta, int along, double to) {
  struct motion motion = {beta, along};
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, &motion};
  double x = y[along];
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, copysign(1e-6, to - x), 1e-13, 0);
  const bool gone = driver && gsl_odeiv2_driver_apply(driver, &x, to, y) == GSL_SUCCESS;
  if (driver)
    gsl_odeiv2_driver_free(driver);
  y[along] = to;
  return gone;
}

/* Through the deepest point, which is told, and out to s = `end`. */
static bool turn(double y[], double beta, double end, double *deepest) {
  const double tick = 0.02, far = 50;
  while (y[TIME] < far) {
    double before[UNKNOWNS];
    memcpy(before, y, sizeof before);
    if (!go(y, beta, TIME, y[TIME] + tick))
      return false;
    if (before[SPEED] > 0 && !(y[SPEED] > 0)) {
      double lowest[UNKNOWNS];
      memcpy(lowest, before, sizeof lowest);
      if (!go(lowest, beta, SPEED, 0))
        return false;
      *deepest = lowest[WAY];
    }
    if (y[SPEED] < 0 && !(y[WAY] > end)) {
      memcpy(y, before, sizeof before);
      return go(y, beta, WAY, end);
    }
  }
  return false;
}

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_of(&hertz, scene, "hertz_deep", error))
    return error->status;
  const struct nb_body *a = hertz.bodies[0], *b = hertz.bodies[1];
  const double smaller = b && b->radius < a->radius ? b->radius : a->radius;
  const double limit = scene->damping.deep * 2 * smaller / hertz.depth, beta = hertz.damping;
  double y[UNKNOWNS] = {0, 0, 1}, deepest = 0;
  if (!(limit > 0))
    return nb_error_set(error, NB_BAD_USE, "hertz_deep is for `damping critical above`");
  double trial[UNKNOWNS] = {0, 0, 1}, shallow = 0;
  bool solved = turn(trial, beta, 0, &shallow);
  if (solved && shallow > limit)
    solved = go(y, beta, WAY, limit) && turn(y, 1, limit, &deepest) && turn(y, beta, 0, &deepest);
  else
    memcpy(y, trial, sizeof y), deepest = shallow;
  if (!solved)
    return nb_error_set(error, NB_BROKEN, "hertz_deep: the equation of motion could not be solved");
  hertz_tell(known, &hertz, "overlap max", deepest * hertz.depth);
  known_value(known, y[TIME] * hertz.unit, "impact.duration");
  known_value(known, -y[SPEED], "impact.restitution");
  return known_full(known, error);
}

const struct nb_reference reference_hertz_deep = {
    .name = "hertz_deep",
    .title = "Hertz's impact, damped critically where it is deep: ODE by GSL at 1e-13",
    .source = "[R89 4.13, 6.4.3]",
    .know = know,
};
