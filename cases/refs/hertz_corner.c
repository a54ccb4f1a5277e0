/* The formulas of hertz_corner.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_sf_gamma.h>
#include <math.h>

#include "hertz_corner.h"

/* zeta(-3/2, a), a > 0: ten terms, and the rest by Euler-Maclaurin; error below 2e-8. */
static double zeta(double a) {
  enum { TERMS = 10 };
  double sum = 0;
  for (int k = 0; k < TERMS; k++)
    sum += pow(k + a, 1.5);
  const double x = TERMS + a;
  return sum - pow(x, 2.5) / 2.5 + pow(x, 1.5) / 2 - sqrt(x) / 8 - pow(x, -1.5) / 1920;
}

double hertz_shortening(double fraction) { return 11. / 96 * fraction * gsl_sf_beta(1.6, 0.5); }

double hertz_restitution_error(double fraction, double in, double steps) {
  const double out = in + steps - hertz_shortening(fraction);
  return 1.25 * pow(fraction, 2.5) * (zeta(out - floor(out)) - zeta(ceil(in) - in));
}
