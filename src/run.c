/* A scene from its first stage to its last.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "clock.h"
#include "observe.h"

struct run {
  struct nb_result *result;
  const struct nb_scene *scene;
  struct nb_model *model;
  const struct nb_progress *progress;
  double began, told; /* s */
  unsigned long
      until_clock;       /* cycles to go before the clock is read again: reading it costs as much as a small cycle */
  unsigned long planned; /* cycles of all stages, at most */
};

static enum nb_status out_of_memory(struct nb_error *error) {
  return nb_error_set(error, NB_BROKEN, "out of memory while recording");
}

static void tell(struct run *run, const struct nb_stage *stage) {
  if (!run->progress || run->until_clock-- > 0)
    return;
  run->until_clock = 100000 / (run->model->contacts.count + 20);
  const double t = nb_clock();
  if (t - run->told < 0.1)
    return;
  run->told = t;
  run->progress->call(run->progress->data, stage->name, (double)run->model->cycle / (double)run->planned,
                      t - run->began);
}

/* Looked at every so many cycles, and at the last one there may be. */
static bool holds(const struct nb_stage *stage, const struct nb_model *model) {
  if (model->stage_cycle % stage->look != 0 && model->stage_cycle < stage->cycles)
    return false;
  for (size_t k = 0; k < stage->condition_count; k++) {
    const struct nb_condition *condition = &stage->conditions[k];
    const double value = nb_quantity_value(condition->quantity, model);
    if (!(condition->relation == NB_BELOW ? value < condition->value : value > condition->value))
      return false;
  }
  return stage->condition_count > 0;
}

static enum nb_status never_ended(const struct nb_stage *stage, const struct nb_model *model, struct nb_error *error) {
  char text[256] = "";
  for (size_t k = 0; k < stage->condition_count; k++) {
    const struct nb_condition *condition = &stage->conditions[k];
    const size_t length = strlen(text);
    snprintf(text + length, sizeof text - length, "%s%s is %g and should be %s %g", k ? ", " : "", condition->name,
             nb_quantity_value(condition->quantity, model), condition->relation == NB_BELOW ? "below" : "above",
             condition->value);
  }
  return nb_error_set(error, NB_BROKEN, "stage `%s` (line %d) did not end within %lu cycles: %s", stage->name,
                      stage->line, stage->cycles, text);
}

static enum nb_status run_stage(struct run *run, int index, struct nb_error *error) {
  const struct nb_stage *stage = &run->scene->stages[index];
  struct nb_model *model = run->model;
  struct nb_result *result = run->result;
  enum nb_status status = nb_stage_begin(model, stage, error);
  bool ended = false;
  while (!status && !ended) {
    status = nb_cycle(model, error);
    if (status)
      break;
    ended = stage->condition_count ? holds(stage, model) : model->stage_cycle >= stage->cycles;
    if (stage->record && (model->stage_cycle % stage->record == 0 || ended))
      if (!nb_observe(&result->table, model, index))
        status = out_of_memory(error);
    if (!ended && model->stage_cycle >= stage->cycles)
      status = never_ended(stage, model, error);
    tell(run, stage);
  }
  result->stage_cycles[index] = model->stage_cycle;
  if (!status && stage->snapshot) {
    struct nb_snapshot *more = realloc(result->snapshots, (result->snapshot_count + 1) * sizeof *more);
    if (!more)
      return out_of_memory(error);
    result->snapshots = more;
    if (!nb_snapshot_take(&more[result->snapshot_count++], model, index))
      status = out_of_memory(error);
  }
  return status;
}

enum nb_status nb_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_options *options,
                      const struct nb_progress *progress, struct nb_error *error) {
  if (scene->path)
    return nb_bench_run(result, scene, progress, error);
  *result = (struct nb_result){0};
  struct run run = {.result = result, .scene = scene, .progress = progress, .began = nb_clock()};
  for (size_t s = 0; s < scene->stage_count; s++)
    run.planned += scene->stages[s].cycles;
  result->stage_cycles = calloc(scene->stage_count + 1, sizeof *result->stage_cycles);
  if (!result->stage_cycles || !nb_observe_begin(&result->table, scene))
    return out_of_memory(error);
  run.model = nb_model_create(scene, options, error);
  if (!run.model)
    return error->status;
  enum nb_status status = NB_OK;
  if (scene->stages[0].record && !nb_observe(&result->table, run.model, 0))
    status = out_of_memory(error);
  for (size_t s = 0; s < scene->stage_count && !status; s++)
    status = run_stage(&run, (int)s, error);
  result->cycles = run.model->cycle;
  result->updates = run.model->updates;
  result->searches = run.model->searches;
  result->deep = nb_deep_count(run.model);
  snprintf(result->deep_first, sizeof result->deep_first, "%s", run.model->deep.first);
  result->seconds = nb_clock() - run.began;
  nb_model_free(run.model);
  return status;
}

void nb_result_free(struct nb_result *result) {
  nb_table_free(&result->table);
  for (size_t s = 0; s < result->snapshot_count; s++)
    nb_snapshot_free(&result->snapshots[s]);
  free(result->snapshots);
  free(result->stage_cycles);
  *result = (struct nb_result){0};
}
