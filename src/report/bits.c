/* The leading bits that two values of an expected quantity have in common.
 *
 * A value x and the value x_nearest of a run that rounds to nearest have floor(-log2(|x - x_nearest| / scale)) bits in
 * common, 53 if they are equal. The scale is |x_nearest|, or the measure of which the tolerance is a fraction. With an
 * absolute tolerance, and for a curve, the scale is the largest magnitude of the quantity in the run, because a force
 * that returns to 0 has no leading bits. For `expected NUMBER of MEASURE` x is the ratio of the two measures; with an
 * absolute tolerance its scale is |x_nearest|, too. Residuals, and quantities that stay within their absolute
 * tolerance, have no bits, because they consist of rounding errors.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bits.h"

#include <math.h>

#include "verdict.h"

int nb_common_bits(double value, double nearest, double scale) {
  const double difference = fabs(value - nearest);
  if (difference == 0)
    return NB_ALL_BITS;
  const double bits = floor(-log2(difference / scale)); /* NaN if a value is not finite; the result is then 0 */
  return bits > 0 ? bits < NB_ALL_BITS ? (int)bits : NB_ALL_BITS : 0;
}

static double largest(const struct nb_table *table, size_t column) {
  double peak = 0;
  for (size_t r = 0; r < table->row_count; r++)
    peak = fmax(peak, fabs(table->values[r * table->column_count + column]));
  return peak;
}

bool nb_expected_has_bits(const struct nb_page_run *nearest, size_t index) {
  const struct nb_expectation *e = &nearest->expectations.list[index];
  return !e->measure.is_residual && (e->tolerance.kind != NB_ABSOLUTE || e->has_scale || e->tolerance.value == 0 ||
                                     largest(&nearest->result.table, e->measure.column) > e->tolerance.value);
}

/* The bits of a curve: the smallest number of all rows of its stage. The result is 0 if the numbers of rows differ,
 * because `until` has ended a stage earlier in one of the runs. */
static int curve_bits(const struct nb_measure *measure, const struct nb_table *table, const struct nb_table *nearest) {
  size_t first, end, from, to;
  nb_measure_rows(measure, table, &first, &end);
  nb_measure_rows(measure, nearest, &from, &to);
  int bits = end - first == to - from ? NB_ALL_BITS : 0;
  const double peak = largest(nearest, measure->column);
  for (size_t r = 0; r < to - from && bits > 0; r++) {
    const double *row = table->values + (first + r) * table->column_count;
    const double *other = nearest->values + (from + r) * nearest->column_count;
    const int now = nb_common_bits(row[measure->column], other[measure->column], peak);
    bits = now < bits ? now : bits;
  }
  return bits;
}

int nb_expected_bits(const struct nb_page_run *run, const struct nb_page_run *nearest, size_t index) {
  const struct nb_expectation *e = &nearest->expectations.list[index];
  const struct nb_table *table = &nearest->result.table;
  struct nb_check unused;
  struct nb_error error;
  double value, reference;
  if (!nb_expected_has_bits(nearest, index))
    return NB_ALL_BITS;
  if (e->kind == NB_VERSUS)
    return curve_bits(&e->measure, &run->result.table, table);
  if (!nb_check_computed(&value, &unused, run, e) || !nb_check_computed(&reference, &unused, nearest, e))
    return 0;
  double scale = fabs(reference);
  if (e->tolerance.kind == NB_OF_MEASURE && !nb_measure_value(&scale, &e->tolerance.of, table, &error))
    return 0;
  if (e->tolerance.kind == NB_ABSOLUTE && !e->has_scale)
    scale = largest(table, e->measure.column);
  return nb_common_bits(value, reference, scale);
}
