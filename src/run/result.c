/* The table of a result, and reports of progress.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clock.h"
#include "core/names.h"

unsigned nb_fields_requested(const struct nb_scene *scene) {
  unsigned fields = 0;
  for (size_t c = 0; c < scene->column_count; c++)
    fields |= scene->columns[c].quantity.kind->fields;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    for (size_t k = 0; k < stage->condition_count; k++)
      fields |= stage->conditions[k].quantity.kind->fields;
    for (int k = 0; k < 4 && stage->servo.line; k++)
      fields |= stage->servo.quantity[k].kind->fields | NB_BIT(NB_OVERLAP) | NB_BIT(NB_STIFFNESS);
    if (stage->snapshot)
      fields |= NB_BIT(NB_OVERLAP) | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_NORMAL) | NB_BIT(NB_SHEAR) |
                NB_BIT(NB_SLIDING) | NB_BIT(NB_RADIUS) |
                (stage->snapshot_from >= 0 ? NB_BIT(NB_TANGENTIAL_INCREMENT) : 0);
  }
  return fields;
}

void nb_result_forget_extremes(struct nb_result *result, const struct nb_scene *scene) {
  for (size_t k = 0; k < scene->stage_count * scene->column_count; k++)
    if (!scene->columns[k % scene->column_count].tracked)
      result->extremes[k] = (struct nb_extremes){-INFINITY, INFINITY};
}

static bool extremes_create(struct nb_result *result, const struct nb_scene *scene) {
  const size_t count = scene->stage_count * scene->column_count;
  result->extremes = nb_array(count, sizeof *result->extremes);
  if (!result->extremes)
    return false;
  for (size_t k = 0; k < count; k++)
    result->extremes[k] = (struct nb_extremes){INFINITY, -INFINITY};
  nb_result_forget_extremes(result, scene);
  return true;
}

bool nb_result_begin(struct nb_result *result, const struct nb_scene *scene) {
  struct nb_table *table = &result->table;
  result->stages = calloc(scene->stage_count + 1, sizeof *result->stages);
  if (!result->stages || !nb_table_create(table, scene->column_count))
    return false;
  for (size_t c = 0; c < scene->column_count; c++) {
    memcpy(table->names[c], scene->columns[c].name, sizeof table->names[c]);
    table->units[c] = scene->unitless ? "-" : nb_quantity_unit(scene->columns[c].quantity);
  }
  return extremes_create(result, scene);
}

void nb_result_track(struct nb_result *result, const struct nb_model *model, int stage) {
  const struct nb_scene *const scene = model->scene;
  struct nb_extremes *const of_stage = result->extremes + (size_t)stage * scene->column_count;
  for (size_t c = 0; c < scene->column_count; c++) {
    if (!scene->columns[c].tracked)
      continue;
    const double value = nb_quantity_value(scene->columns[c].quantity, model);
    of_stage[c].smallest = fmin(of_stage[c].smallest, value);
    of_stage[c].largest = fmax(of_stage[c].largest, value);
  }
}

bool nb_result_add_row(struct nb_table *table, const struct nb_model *model, int stage) {
  double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_quantity_value(model->scene->columns[c].quantity, model);
  return true;
}

double nb_processor_clock(void) {
  struct timespec t = {0};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct nb_reporter nb_reporter_begin(const struct nb_progress *progress) {
  const double now = nb_clock();
  return (struct nb_reporter){progress, now, 0, nb_processor_clock()};
}

bool nb_reporter_update(struct nb_reporter *reporter, const char *stage, double fraction) {
  const struct nb_progress *progress = reporter->progress;
  if (!progress)
    return true;
  const double now = nb_clock();
  if (progress->call && now - reporter->last_call >= 0.1) {
    reporter->last_call = now;
    progress->call(progress->data, stage, fraction, now - reporter->began);
  }
  return progress->stage_seconds <= 0 || nb_processor_clock() - reporter->stage_began < progress->stage_seconds;
}
