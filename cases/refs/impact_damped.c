/* The exact contact in an oblique impact with dashpots: the springs of impact_springs.c, on an approach that is damped.
 *
 *   xi''  = -(5/4) xi^(3/2) - (15/2)^(1/2) beta xi^(1/4) xi'                                           [R89 4.13, 5.6]
 *   psi'  = -(5/2) chi (f + g),     g = (8/5) (15 kappa/8)^(1/2) beta xi^(1/4) psi, 0 while it slides as a whole   [R89 4.19]
 *
 * in the scale of impact_springs.h; c = 2 beta (M k)^(1/2) with k = dN/d(alpha) = 2 E* a across and k = 8 G* a = 2 E* a/kappa
 * along. Friction takes the limit of f from the elastic force, xi^(3/2). GSL's Runge-Kutta of order 8 for the approach, whose end
 * is found with xi as what is integrated along (Henon 1982). A step in which sliding begins or ends has g for all of it or none,
 * which makes the whole of first order; so an impact is cut into many.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>

#include "impact_springs.h"

enum { TIME, WAY, SPEED, UNKNOWNS };

struct motion {
  double drag;
  int along; /* what it is integrated along: TIME or WAY */
};

static int slope(double x, const double y[], double dydx[], void *data) {
  const struct motion *motion = data;
  const double xi = y[WAY] > 0 ? y[WAY] : 0, root = sqrt(xi);
  const double rate[UNKNOWNS] = {1, y[SPEED], -1.25 * xi * root - motion->drag * sqrt(root) * y[SPEED]};
  (void)x;
  for (int k = 0; k < UNKNOWNS; k++)
    dydx[k] = rate[k] / rate[motion->along];
  return 0;
}

static void go(double y[], struct motion motion, double to) {
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, &motion};
  double x = y[motion.along];
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, copysign(1e-4, to - x), 1e-13, 0);
  if (!driver || gsl_odeiv2_driver_set_nmax(driver, 100000) ||
      gsl_odeiv2_driver_apply(driver, &x, to, y) != GSL_SUCCESS)
    y[TIME] = y[WAY] = y[SPEED] = NAN;
  if (driver)
    gsl_odeiv2_driver_free(driver);
}

/* Duration of the overlap, s; NAN: it has no end, or it cannot be solved. */
static double duration(double drag) {
  double y[UNKNOWNS] = {0, 0, 1}, before[UNKNOWNS];
  while ((y[WAY] > 0 || y[TIME] == 0) && y[TIME] < 1000) { /* near critical damping a few times that without */
    for (int k = 0; k < UNKNOWNS; k++)
      before[k] = y[k];
    go(y, (struct motion){drag, TIME}, y[TIME] + 0.1);
  }
  if (y[WAY] > 0)
    return NAN;
  go(before, (struct motion){drag, WAY}, 0);
  return before[TIME];
}

double impact_damped(double chi, double kappa, double beta, double psi1, int steps) {
  const double drag = sqrt(7.5) * beta, brake = 1.6 * sqrt(15 * kappa / 8) * beta, dt = duration(drag) / steps;
  const int springs = steps / 4;
  double *u = calloc((size_t)springs, sizeof *u), *depth = calloc((size_t)springs, sizeof *depth);
  double psi = psi1, f = 0, y[UNKNOWNS] = {0, 0, 1};
  bool slides = false;
  for (int i = 0; u && depth && i < springs; i++)
    depth[i] = (i + 0.5) / springs * ((i + 0.5) / springs);
  for (int k = 0; u && depth && dt > 0 && k < steps; k++) {
    const double xi = y[WAY] > 0 ? y[WAY] : 0, fraction = k ? dt : dt / 2;
    const double half = slides ? 0 : 1.25 * chi * brake * sqrt(sqrt(xi)) * fraction; /* g with psi in the middle */
    double slipped;
    psi = (psi * (1 - half) - 2.5 * chi * f * fraction) / (1 + half);
    go(y, (struct motion){drag, TIME}, (k + 1) * dt);
    const double to = y[WAY] > 0 && k + 1 < steps ? y[WAY] : 0;
    f = impact_press(u, depth, springs, xi, to, psi * dt, &slipped);
    if (xi > depth[0] && to > depth[0])
      slides = fabs(slipped) > 0;
    else if (to > xi) /* before the first spring touches */
      slides = fabs(psi) * dt > to - xi;
  }
  const bool made = u && depth;
  free(u), free(depth);
  return !made ? NAN : dt > 0 && isfinite(psi) ? psi : INFINITY;
}
