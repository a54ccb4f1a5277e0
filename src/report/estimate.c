/* Estimates of the error of a quantity Q that was computed with several time steps.
 *
 * Q(n) is the result with n steps per unit of time. Its limit is Q, and p is the order of its error: Q(n) = Q + C/n^p.
 *
 *   d_1 = Q(n) - Q(2n),   d_2 = Q(2n) - Q(4n),   p = log2(|d_1|/|d_2|), limited to the range 0.5 to 2
 *   G = |d_1| 2^p/(2^p - 1)                  error of Q(n) by Richardson's extrapolation
 *   G = 3 max(|d_1|, |d_2|)                  if |d_2| >= |d_1|, because no order is visible
 *
 * The numbers of cycles of a page may allow no step of half the length, but only a step of the length 1/r with 1 < r <
 * 2. Then the difference d of the two results is replaced by d ln 2/ln r, as if the result changed in proportion to the
 * logarithm of the step.
 *
 * The moment of first touch within a step changes Q(n). So Q(n) is computed for several such moments, the phases, and
 * the largest G is used. The anchor is a result with the laws of the page and a smaller step:
 *
 *   Q_A                                      mean over the phases of the anchor
 *   U = 3 |Q_A - Q_A'| + spread              uncertainty of Q_A. Q_A': Q_A with twice the step; spread: largest minus
 *                                            smallest value over the phases of the anchor
 *   max(G, 1.25 max |Q(n) - Q_A| + U)        the estimated error; the inner maximum is over the phases
 *
 * The factors 3 and 1.25 are calibrated (make accuracy), not derived.
 *
 * An assembly is chaotic: only the mean over m realizations has a limit. Realization k begins with the same random
 * assembly in the run with n steps and in the run of the anchor. D is the mean and s the standard deviation of
 * D_k = Q_k(n) - Q_k(anchor):
 *
 *   |D| + t s/m^(1/2)                        the estimated error of the mean; t: quantile of Student's distribution
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "estimate.h"

#include <math.h>

static const double no_order_factor = 3, anchor_factor = 3, distance_factor = 1.25;
static const double lowest_order = 0.5, highest_order = 2;

double nb_estimate_step(double n, double n2, double n4, struct nb_ratios ratios) {
  const double d1 = fabs(n - n2) / log2(ratios.first), d2 = fabs(n2 - n4) / log2(ratios.second);
  if (!isfinite(d1) || !isfinite(d2))
    return INFINITY;
  if (!(d2 < d1))
    return no_order_factor * fmax(d1, d2);
  const double order = fmin(fmax(log2(d1 / d2), lowest_order), highest_order), ratio = exp2(order);
  return d1 * ratio / (ratio - 1);
}

double nb_estimate_average(const double values[], size_t count) {
  double sum = 0;
  for (size_t k = 0; k < count; k++)
    sum += values[k];
  return sum / (double)count;
}

struct nb_anchor nb_estimate_anchor(const double at_anchor[], const double at_double_step[], size_t phases) {
  double low = INFINITY, high = -INFINITY;
  for (size_t k = 0; k < phases; k++)
    low = fmin(low, at_anchor[k]), high = fmax(high, at_anchor[k]);
  const double value = nb_estimate_average(at_anchor, phases);
  return (struct nb_anchor){value,
                            anchor_factor * fabs(value - nb_estimate_average(at_double_step, phases)) + (high - low)};
}

double nb_estimate_error(double *step, const double n[], const double n2[], const double n4[], size_t phases,
                         struct nb_ratios ratios, struct nb_anchor anchor) {
  double distance = 0;
  *step = 0;
  if (!isfinite(anchor.value) || !isfinite(anchor.uncertainty))
    return INFINITY;
  for (size_t k = 0; k < phases; k++) {
    *step = fmax(*step, nb_estimate_step(n[k], n2[k], n4[k], ratios));
    distance = fmax(distance, fabs(n[k] - anchor.value));
  }
  return fmax(*step, distance_factor * distance + anchor.uncertainty);
}

double nb_estimate_scatter(const double values[], size_t count) {
  const double average = nb_estimate_average(values, count);
  double squares = 0;
  for (size_t k = 0; k < count; k++)
    squares += (values[k] - average) * (values[k] - average);
  return sqrt(squares / (double)(count - 1));
}

double nb_estimate_mean(double *difference, const double n[], const double anchor[], size_t count, double quantile) {
  double differences[NB_TRIALS];
  for (size_t k = 0; k < count; k++)
    differences[k] = n[k] - anchor[k];
  *difference = fabs(nb_estimate_average(differences, count));
  const double estimated = *difference + quantile * nb_estimate_scatter(differences, count) / sqrt((double)count);
  return isfinite(estimated) ? estimated : INFINITY;
}
