/* The exact contact in an oblique impact with dashpots: the springs of impact_springs.c, with damped approach.
 *
 *   xi''  = -(5/4) xi^(3/2) - (15/2)^(1/2) beta xi^(1/4) xi'                                           [R89 4.13, 5.6]
 *   psi'  = -(5/2) chi (f + g),     g = (8/5) (15 kappa/8)^(1/2) beta xi^(1/4) psi; 0 in gross sliding       [R89 4.19]
 *
 * in the units of impact_springs.h; c = 2 beta (M k)^(1/2) with k = dN/d(alpha) = 2 E* a normal and k = 8 G* a = 2 E*
 * a/kappa tangential. Friction limits f by the elastic force xi^(3/2). The approach is integrated by GSL's Runge-Kutta
 * method of order 8; its end is found by integrating over xi (Henon 1982). A step in which sliding begins or ends has g
 * in all of it or not at all, which makes the result first order in the step, so an impact is cut into many steps.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>

#include "impact_springs.h"

enum { TIME, XI, RATE, UNKNOWNS }; /* t, xi, xi' */

struct motion {
  double drag;
  int along; /* the unknown that it is integrated over: TIME or XI */
};

static int slope(double x, const double y[], double dydx[], void *data) {
  const struct motion *motion = data;
  const double xi = y[XI] > 0 ? y[XI] : 0, root = sqrt(xi);
  const double rate[UNKNOWNS] = {1, y[RATE], -1.25 * xi * root - motion->drag * sqrt(root) * y[RATE]};
  (void)x;
  for (int k = 0; k < UNKNOWNS; k++)
    dydx[k] = rate[k] / rate[motion->along];
  return 0;
}

static void integrate(double y[], struct motion motion, double to) {
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, &motion};
  double x = y[motion.along];
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, copysign(1e-4, to - x), 1e-13, 0);
  if (!driver || gsl_odeiv2_driver_set_nmax(driver, 100000) ||
      gsl_odeiv2_driver_apply(driver, &x, to, y) != GSL_SUCCESS)
    y[TIME] = y[XI] = y[RATE] = NAN;
  if (driver)
    gsl_odeiv2_driver_free(driver);
}

/* Duration of the contact in alpha_max/V_N; NAN: it does not end, or GSL gave up. */
static double duration(double drag) {
  double y[UNKNOWNS] = {0, 0, 1}, before[UNKNOWNS];
  while ((y[XI] > 0 || y[TIME] == 0) && y[TIME] < 1000) { /* near critical damping it is a few times the undamped one */
    for (int k = 0; k < UNKNOWNS; k++)
      before[k] = y[k];
    integrate(y, (struct motion){drag, TIME}, y[TIME] + 0.1);
  }
  if (y[XI] > 0)
    return NAN;
  integrate(before, (struct motion){drag, XI}, 0);
  return before[TIME];
}

double impact_damped(double chi, double kappa, double beta, double psi1, int steps) {
  const double drag = sqrt(7.5) * beta, dashpot = 1.6 * sqrt(15 * kappa / 8) * beta, dt = duration(drag) / steps;
  const int springs = steps / 4;
  double *u = calloc((size_t)springs, sizeof *u), *depth = calloc((size_t)springs, sizeof *depth);
  double psi = psi1, f = 0, y[UNKNOWNS] = {0, 0, 1};
  bool slides = false;
  for (int i = 0; u && depth && i < springs; i++)
    depth[i] = (i + 0.5) / springs * ((i + 0.5) / springs);
  for (int k = 0; u && depth && dt > 0 && k < steps; k++) {
    const double xi = y[XI] > 0 ? y[XI] : 0, fraction = k ? dt : dt / 2;
    const double half =
        slides ? 0 : 1.25 * chi * dashpot * sqrt(sqrt(xi)) * fraction; /* g, with psi at the middle of the step */
    double sliding;
    psi = (psi * (1 - half) - 2.5 * chi * f * fraction) / (1 + half);
    integrate(y, (struct motion){drag, TIME}, (k + 1) * dt);
    const double next = y[XI] > 0 && k + 1 < steps ? y[XI] : 0;
    f = impact_press(u, depth, springs, xi, next, psi * dt, &sliding);
    if (xi > depth[0] && next > depth[0])
      slides = fabs(sliding) > 0;
    else if (next > xi) /* before the first spring touches */
      slides = fabs(psi) * dt > next - xi;
  }
  const bool made = u && depth;
  free(u), free(depth);
  return !made ? NAN : dt > 0 && isfinite(psi) ? psi : INFINITY;
}
