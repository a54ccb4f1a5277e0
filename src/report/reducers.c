/* Reducers: the rows of a table become one number.
 *
 *   mean        sum of the rows divided by their number
 *   amplitude   half the difference of largest and smallest value
 *   frequency   number of upward crossings of the mean, minus one, divided by the time from the first to the last
 *               crossing; the time of a crossing is interpolated linearly between two rows. A value equal to the mean
 *               counts as above it
 *   at N cycles the row of that cycle
 *   at TIME     interpolated linearly between two rows
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "outcome.h"

static bool is_at(const struct nb_measure *measure) {
  return measure->reducer == NB_AT_CYCLE || measure->reducer == NB_AT_TIME;
}

void nb_measure_rows(const struct nb_measure *measure, const struct nb_table *table, size_t *from, size_t *to) {
  *from = 0, *to = table->row_count;
  if (table->row_count == 0 || measure->stage == NB_STAGE_ALL || (is_at(measure) && measure->stage < 0))
    return;
  const int stage = measure->stage < 0 ? table->stage[table->row_count - 1] : measure->stage;
  while (*from < *to && table->stage[*from] != stage)
    ++*from;
  while (*to > *from && table->stage[*to - 1] != stage)
    --*to;
}

struct column {
  const struct nb_table *table;
  size_t index, from, to;
};

static double value(const struct column *column, size_t row) {
  return column->table->values[row * column->table->column_count + column->index];
}

static double mean(const struct column *column) {
  double sum = 0;
  for (size_t r = column->from; r < column->to; r++)
    sum += value(column, r);
  return sum / (double)(column->to - column->from);
}

static double extreme(const struct column *column, double sign) {
  double largest = -INFINITY;
  for (size_t r = column->from; r < column->to; r++)
    largest = fmax(largest, sign * value(column, r));
  return sign * largest;
}

static double frequency(const struct column *column) {
  const double level = mean(column);
  double first = 0, last = 0, crossings = 0;
  for (size_t r = column->from + 1; r < column->to; r++) {
    const double before = value(column, r - 1) - level, after = value(column, r) - level;
    if (!(before < 0 && after >= 0))
      continue;
    const double *time = column->table->time;
    last = time[r - 1] + (time[r] - time[r - 1]) * before / (before - after);
    if (crossings++ == 0)
      first = last;
  }
  return crossings > 1 ? (crossings - 1) / (last - first) : NAN;
}

/* Restricts the column to the rows of the measure: the last one, the one at a given time, or the two around it. */
static void select_rows(struct column *column, const struct nb_measure *measure) {
  const bool by_time = measure->reducer == NB_AT_TIME;
  const double *abscissa = by_time ? column->table->time : column->table->cycle, target = measure->at;
  if (measure->reducer == NB_LAST)
    column->from = column->to - 1;
  if (!is_at(measure))
    return;
  size_t r = column->from;
  while (r < column->to && abscissa[r] < target)
    r++;
  const bool exact = r < column->to && abscissa[r] == target;
  const bool bracketed = by_time && r < column->to && r > column->from;
  column->from = exact || !bracketed ? r : r - 1;
  column->to = exact || bracketed ? r + 1 : r;
}

/* Interpolates linearly between two rows, or returns the only row. */
static double interpolate(const struct column *column, const double *abscissa, double target) {
  const size_t r = column->from;
  const double before = value(column, r);
  if (r + 1 == column->to)
    return before;
  return before + (value(column, r + 1) - before) * (target - abscissa[r]) / (abscissa[r + 1] - abscissa[r]);
}

static double reduce(const struct nb_measure *measure, const struct column *column) {
  switch (measure->reducer) {
  case NB_LAST:
    return value(column, column->from);
  case NB_MAX:
    return extreme(column, 1);
  case NB_MIN:
    return extreme(column, -1);
  case NB_MEAN:
    return mean(column);
  case NB_AMPLITUDE:
    return (extreme(column, 1) - extreme(column, -1)) / 2;
  case NB_FREQUENCY:
    return frequency(column);
  case NB_AT_CYCLE:
  case NB_AT_TIME:
    break;
  }
  return interpolate(column, column->table->time, measure->at);
}

static bool undefined(struct nb_error *error, const struct nb_measure *measure, const char *reason) {
  nb_error_set(error, NB_FAILED, "`%s` cannot be computed: %s", measure->label, reason);
  return false;
}

bool nb_measure_value(double *computed, const struct nb_measure *measure, const struct nb_table *table,
                      struct nb_error *error) {
  struct column column = {.table = table, .index = measure->column};
  const bool is_time = measure->reducer == NB_AT_TIME;
  const double *const abscissa = is_time ? table->time : table->cycle;
  char reason[2 * NB_NAME_SIZE];
  nb_measure_rows(measure, table, &column.from, &column.to);
  *computed = NAN;
  if (column.from == column.to)
    return undefined(error, measure, "no row was recorded there");
  const double first = abscissa[column.from], last = abscissa[column.to - 1];
  const bool between = measure->at >= first && measure->at <= last;
  snprintf(reason, sizeof reason, "no row was recorded at that moment, only %sfrom %s %g to %g%s",
           between ? "in other cycles " : "", is_time ? "time" : "cycle", first, last,
           is_time && table->units[0] && strcmp(table->units[0], "-") != 0 ? " s" : "");
  select_rows(&column, measure);
  if (column.from == column.to)
    return undefined(error, measure, reason);
  for (size_t r = column.from; r < column.to; r++)
    if (!isfinite(value(&column, r))) {
      snprintf(reason, sizeof reason, "it is %g at cycle %.0f", value(&column, r), table->cycle[r]);
      return undefined(error, measure, reason);
    }
  *computed = reduce(measure, &column);
  if (isfinite(*computed))
    return true;
  return undefined(error, measure,
                   isnan(*computed) ? "it rises through its mean less than twice"
                                    : "the result is not a finite number");
}

const double *nb_measure_solution(const struct nb_measure *measure, const struct nb_solution *solution) {
  const double *value = solution_find(solution, measure->label);
  char label[sizeof measure->label];
  snprintf(label, sizeof label, "%.*s", (int)measure->bare_length, measure->label);
  return value ? value : solution_find(solution, label);
}
