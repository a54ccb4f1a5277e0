/* The exact contact in an oblique impact with dashpots: the springs of impact_springs.c, with a damped approach.
 *
 *   xi''  = -(5/4) xi^(3/2) - (15/2)^(1/2) beta xi^(1/4) xi'                                           [R89 4.13, 5.6]
 *   psi'  = -(5/2) chi (f + g),     g = (8/5) (15 kappa/8)^(1/2) beta xi^(1/4) psi; 0 in gross sliding       [R89 4.19]
 *
 * in the units of impact_springs.h. The damping coefficients are 2 beta (M* k)^(1/2), with k = dN/d(alpha) = 2 E* a in
 * the normal direction and k = 8 G* a = 2 E* a/kappa in the tangential one. Friction limits f to the elastic force
 * xi^(3/2). hertz_motion.c integrates the approach. g acts during a whole step or not at all, also when sliding begins
 * or ends within the step. The error is therefore of first order in the step, so an impact is divided into many steps.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>

#include "hertz_motion.h"
#include "impact_springs.h"

/* Duration of the contact in units of alpha_max/V_N; NAN: it does not end, or GSL failed. */
static double duration(double beta) {
  double y[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT, deepest[HERTZ_UNKNOWNS];
  const double longest = 1000; /* 2.94 without damping, 10 for beta = 0.8, 141 for beta = 0.9 */
  return hertz_rebound(y, beta, 0, longest, deepest) && !(y[HERTZ_OVERLAP] > 0) ? y[HERTZ_TIME] : NAN;
}

/* Returns psi2. Spring i touches while xi > depth[i]; its deflection u[i] must be 0 at first. INFINITY: the contact
 * does not end, or GSL failed. */
static double rebound(double chi, double kappa, double beta, double psi1, int steps, double *u, const double *depth,
                      int springs) {
  const double dashpot = 1.6 * sqrt(15 * kappa / 8) * beta, dt = duration(beta) / steps;
  double psi = psi1, f = 0, y[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT;
  bool slides = false;
  for (int k = 0; dt > 0 && k < steps; k++) {
    const double xi = y[HERTZ_OVERLAP] > 0 ? y[HERTZ_OVERLAP] : 0, kick = k ? dt : dt / 2;
    /* half of the relative change of psi by g; g uses the mean of psi before and after the step */
    const double half = slides ? 0 : 1.25 * chi * dashpot * sqrt(sqrt(xi)) * kick;
    double sliding;
    psi = (psi * (1 - half) - 2.5 * chi * f * kick) / (1 + half);
    if (!hertz_integrate(y, beta, HERTZ_TIME, (k + 1) * dt))
      return INFINITY;
    const double next = y[HERTZ_OVERLAP] > 0 && k + 1 < steps ? y[HERTZ_OVERLAP] : 0;
    f = impact_press(u, depth, springs, xi, next, psi * dt, &sliding);
    if (xi > depth[0] && next > depth[0])
      slides = fabs(sliding) > 0;
    else if (next > xi) /* before the first spring touches */
      slides = fabs(psi) * dt > next - xi;
  }
  return dt > 0 && isfinite(psi) ? psi : INFINITY;
}

double impact_damped(double chi, double kappa, double beta, double psi1, int steps) {
  const int springs = steps / 4;
  double *u = calloc((size_t)springs, sizeof *u), *depth = calloc((size_t)springs, sizeof *depth), psi2 = NAN;
  for (int i = 0; depth && i < springs; i++)
    depth[i] = (i + 0.5) / springs * ((i + 0.5) / springs);
  if (u && depth)
    psi2 = rebound(chi, kappa, beta, psi1, steps, u, depth, springs);
  free(u), free(depth);
  return psi2;
}
