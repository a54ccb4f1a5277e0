/* The quantiles of Student's t distribution (1908), by GSL.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "student.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double student_quantile(double n, double confidence) {
  return n > 1 ? gsl_cdf_tdist_Pinv((1 + confidence) / 2, n - 1) : INFINITY;
}
