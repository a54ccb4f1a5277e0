/* A path from its first leg to its last.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "bench.h"
#include "core/clock.h"
#include "observe.h"

static bool observe(struct nb_table *table, const struct nb_bench *bench, int stage) {
  double *row = nb_table_row(table, stage, (double)bench->step, 0);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_quantity_on_bench(bench->scene->columns[c].quantity, bench);
  return true;
}

static bool keep_snapshot(struct nb_result *result, const struct nb_bench *bench, int stage) {
  struct nb_snapshot *more = realloc(result->snapshots, (result->snapshot_count + 1) * sizeof *more);
  if (!more)
    return false;
  result->snapshots = more;
  return nb_bench_snapshot(&more[result->snapshot_count++], bench, stage);
}

static enum nb_status run_leg(struct nb_result *result, struct nb_bench *bench, int index, struct nb_error *error) {
  const struct nb_stage *stage = &bench->scene->stages[index];
  const struct nb_bench_leg leg = nb_bench_leg_begin(bench, stage);
  bool whole = true;
  for (unsigned long step = 1; step <= stage->cycles && whole; step++) {
    const enum nb_status status = nb_bench_leg_step(bench, &leg, step, error);
    if (status)
      return status;
    result->stage_cycles[index] = step;
    if (stage->record && (step % stage->record == 0 || step == stage->cycles))
      whole = observe(&result->table, bench, index);
  }
  if (whole && stage->snapshot)
    whole = keep_snapshot(result, bench, index);
  return whole ? NB_OK : nb_error_memory(error);
}

enum nb_status nb_bench_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_progress *progress,
                            struct nb_error *error) {
  const double began = nb_clock();
  double told = began;
  struct nb_bench bench;
  *result = (struct nb_result){0};
  result->stage_cycles = calloc(scene->stage_count + 1, sizeof *result->stage_cycles);
  if (!result->stage_cycles || !nb_observe_begin(&result->table, scene))
    return nb_error_memory(error);
  enum nb_status status = nb_bench_create(&bench, scene, error);
  if (status)
    return status;
  if (!observe(&result->table, &bench, 0))
    status = nb_error_memory(error);
  for (size_t s = 0; s < scene->stage_count && !status; s++) {
    status = run_leg(result, &bench, (int)s, error);
    if (progress && progress->call && nb_clock() - told > 0.1) {
      told = nb_clock();
      progress->call(progress->data, scene->stages[s].name, (double)(s + 1) / (double)scene->stage_count, told - began);
    }
  }
  result->cycles = result->updates = bench.step;
  result->seconds = nb_clock() - began;
  nb_bench_free(&bench);
  return status;
}
