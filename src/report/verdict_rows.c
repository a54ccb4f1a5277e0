/* Warnings of checks that would have another verdict with the values of all cycles than with those of the rows.
 *
 * `max`, `min` and `amplitude` use the rows of the table. With `record every N cycles` a whole collision may lie between
 * two rows. A run tracks the largest and the smallest value of all cycles for the columns of such checks (struct
 * nb_extremes).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/error.h"
#include "verdict.h"

/* Extends the smallest and the largest value of the rows of a measure by the tracked values of its stages. */
static struct nb_extremes extend(struct nb_extremes rows, const struct nb_page_run *run,
                                 const struct nb_measure *measure) {
  const struct nb_table *const table = nb_run_table(run);
  const int stage = measure->stage == -1 ? table->stage[table->row_count - 1] : measure->stage;
  for (size_t s = 0; s < run->scene.stage_count; s++) {
    const struct nb_extremes *const all = &run->result.extremes[s * run->scene.column_count + measure->column];
    if (stage != NB_STAGE_ALL && (int)s != stage)
      continue;
    rows.smallest = fmin(rows.smallest, all->smallest);
    rows.largest = fmax(rows.largest, all->largest);
  }
  return rows;
}

static double reduce(enum nb_reducer reducer, struct nb_extremes values) {
  return reducer == NB_MAX   ? values.largest
         : reducer == NB_MIN ? values.smallest
                             : (values.largest - values.smallest) / 2;
}

void nb_check_rows(struct nb_warnings *warnings, const struct nb_page_run *run, const struct nb_expectation *e,
                   const struct nb_check *check) {
  const enum nb_reducer reducer = e->measure.reducer;
  struct nb_measure least = e->measure, most = e->measure;
  struct nb_extremes rows;
  struct nb_error error;
  if (!run->result.extremes || !nb_is_extreme(reducer))
    return;
  least.reducer = NB_MIN, most.reducer = NB_MAX;
  if (!nb_measure_value(&rows.smallest, &least, nb_run_table(run), &error) ||
      !nb_measure_value(&rows.largest, &most, nb_run_table(run), &error))
    return;
  const double recorded = reduce(reducer, rows), value = reduce(reducer, extend(rows, run, &e->measure));
  const bool passes = check->mark == NB_PASS;
  struct nb_check all_cycles = {0};
  struct nb_expectation bare = *e;
  char unit[NB_NAME_SIZE];
  const int digits = nb_digit_count(recorded, value, 4);
  bare.has_scale = false;
  nb_check_unit(unit, run, &bare);
  nb_check_run(&all_cycles, run, e, &value);
  if (isfinite(value) && all_cycles.mark != check->mark)
    nb_warn(warnings, e->line,
            "`%s`: it is %.*g%s in the recorded rows and %.*g%s in all cycles, so this check %s only because `record "
            "every N cycles` leaves cycles out%s%s%s",
            e->measure.label, digits, recorded, unit, digits, value, unit, passes ? "passes" : "fails",
            run->label[0] ? " (run " : "", run->label, run->label[0] ? ")" : "");
}
