/* Estimates of the error of a quantity Q that was computed with several time steps.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

enum { NB_PHASES = 8, NB_TRIALS = 32 }; /* NB_TRIALS: largest number of realizations */

/* Ratios of three time steps: the first over the second, and the second over the third. Each is above 1 and at most
 * 2. */
struct nb_ratios {
  double first, second;
};

/* The estimate G of the error of Q(n) that is due to the step, from Q(n), Q(2n) and Q(4n), where n is the number of
 * steps per unit of time (estimate.c). Infinite if one of the three results is not finite. */
double nb_estimate_step(double n, double n2, double n4, struct nb_ratios ratios);

/* The anchor: the value from which the error of a setting is measured, and its uncertainty. */
struct nb_anchor {
  double value, uncertainty;
};
/* Computes the anchor from Q at the phases with the anchor's step, and from Q at the phases with twice this step. */
struct nb_anchor nb_estimate_anchor(const double at_anchor[], const double at_double_step[], size_t phases);

/* The estimated error of a setting, from Q(n), Q(2n) and Q(4n), each at `phases` phases, and from the anchor. *step
 * receives the largest G. Infinite if the anchor is not finite; *step is then 0. */
double nb_estimate_error(double *step, const double n[], const double n2[], const double n4[], size_t phases,
                         struct nb_ratios ratios, struct nb_anchor anchor);

/* The mean, and the standard deviation of at least two values. */
double nb_estimate_average(const double values[], size_t count);
double nb_estimate_scatter(const double values[], size_t count);
/* The estimated error of the mean over realizations, from the result of each realization and from the result of the
 * same realization at the anchor. `quantile` is the quantile of Student's distribution for `count` values. *difference
 * receives the magnitude of the difference of the two means. Infinite if a result is not finite. */
double nb_estimate_mean(double *difference, const double n[], const double anchor[], size_t count, double quantile);
