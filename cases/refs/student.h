/* Student's t distribution, for confidence intervals of means.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

/* The half width of the confidence interval of the mean of n values, in units of s/sqrt(n), where s is the standard
 * deviation of the values. `confidence` is the probability, below 1, that the interval contains the mean. INFINITY: n
 * is at most 1. */
double student_quantile(double n, double confidence);
