/* The equation of hertz_motion.h, integrated by GSL.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

#include "hertz_motion.h"

struct motion {
  double drag; /* (15/2)^(1/2) beta */
  int along;   /* the unknown that the equations are integrated over */
};

static int slope(double x, const double y[], double dydx[], void *data) {
  const struct motion *motion = data;
  const double s = y[HERTZ_OVERLAP] > 0 ? y[HERTZ_OVERLAP] : 0, root = sqrt(s), v = y[HERTZ_SPEED];
  const double rate[HERTZ_UNKNOWNS] = {1, v, -1.25 * s * root - motion->drag * sqrt(root) * v};
  (void)x;
  for (int k = 0; k < HERTZ_UNKNOWNS; k++)
    dydx[k] = rate[k] / rate[motion->along];
  return GSL_SUCCESS;
}

bool hertz_integrate(double y[], double beta, int along, double to) {
  struct motion motion = {sqrt(7.5) * beta, along};
  gsl_odeiv2_system system = {slope, NULL, HERTZ_UNKNOWNS, &motion};
  double x = y[along];
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, copysign(1e-6, to - x), 1e-13, 0);
  const bool solved = driver && !gsl_odeiv2_driver_set_nmax(driver, 100000) &&
                      gsl_odeiv2_driver_apply(driver, &x, to, y) == GSL_SUCCESS;
  if (driver)
    gsl_odeiv2_driver_free(driver);
  y[along] = to;
  return solved;
}

bool hertz_rebound(double y[], double beta, double end, double longest, double deepest[]) {
  const double tick = 0.05; /* short compared with the duration 2.94 of the impact, in units of alpha* / V_N */
  while (y[HERTZ_TIME] < longest) {
    double before[HERTZ_UNKNOWNS];
    memcpy(before, y, sizeof before);
    if (!hertz_integrate(y, beta, HERTZ_TIME, y[HERTZ_TIME] + tick))
      return false;
    if (before[HERTZ_SPEED] > 0 && !(y[HERTZ_SPEED] > 0)) {
      memcpy(deepest, before, sizeof before);
      if (!hertz_integrate(deepest, beta, HERTZ_SPEED, 0))
        return false;
    }
    if (y[HERTZ_SPEED] < 0 && !(y[HERTZ_OVERLAP] > end)) {
      memcpy(y, before, sizeof before);
      return hertz_integrate(y, beta, HERTZ_OVERLAP, end);
    }
  }
  return true;
}
