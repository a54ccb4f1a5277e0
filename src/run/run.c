/* Runs a scene from its first stage to its last.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "contact_test.h"
#include "core/clock.h"
#include "laws/laws_now.h"
#include "measure/snapshot.h"
#include "plan.h"
#include "restart.h"
#include "result.h"

struct run {
  struct nb_result *result;
  const struct nb_scene *scene;
  struct nb_model *model;
  struct nb_reporter reporter;
  unsigned long first_cycle; /* number of cycles done before this run */
  unsigned long
      until_report;      /* cycles until the clock is read again; that costs as much as a cycle of a few contacts */
  unsigned long planned; /* largest number of cycles of all stages */
};

static bool is_trial(const struct run *run) {
  return run->reporter.progress && run->reporter.progress->stage_seconds > 0;
}

/* False: the stage of a trial has used up its time. */
static bool report_progress(struct run *run, const struct nb_stage *stage) {
  if (run->until_report-- > 0)
    return true;
  const unsigned long done = run->model->stage_cycle, most = 100000 / (run->model->contacts.count + 20);
  run->until_report = is_trial(run) && done < most ? done : most;
  return nb_reporter_update(&run->reporter, stage->name,
                            (double)(run->model->cycle - run->first_cycle) / (double)run->planned);
}

bool nb_condition_met(const struct nb_condition *condition, const struct nb_model *model) {
  const double value = nb_quantity_value(condition->quantity, model);
  return condition->relation == NB_BELOW ? value < condition->value : value > condition->value;
}

/* Conditions are evaluated every check_interval cycles and at the last cycle of the stage. */
static bool conditions_met(const struct nb_stage *stage, const struct nb_model *model) {
  if (model->stage_cycle % stage->check_interval != 0 && model->stage_cycle < stage->cycles)
    return false;
  for (size_t k = 0; k < stage->condition_count; k++)
    if (!nb_condition_met(&stage->conditions[k], model))
      return false;
  return stage->condition_count > 0;
}

static enum nb_status conditions_not_met(const struct nb_stage *stage, const struct nb_model *model,
                                         struct nb_error *error) {
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

/* Notes a change of law, since contacts lose the history of the old law. */
static void note_laws(const struct run *run, const struct nb_stage *stage) {
  const struct nb_model *model = run->model;
  const struct nb_progress *progress = run->reporter.progress;
  const struct nb_active_laws *before = &model->laws, *next = &model->next_laws;
  char text[6 * NB_NAME_SIZE], old[NB_NAME_SIZE], memory[NB_NAME_SIZE] = "";
  for (int shear = 0; shear < 2 && progress && progress->note; shear++) {
    if (!(shear ? nb_laws_shear_changes(model) : nb_laws_normal_changes(model)))
      continue;
    const struct nb_law *law = shear ? next->shear : next->normal;
    snprintf(old, sizeof old, "%s", (shear ? before->shear : before->normal)->name);
    if (shear && next->shear == before->shear) { /* only its memory size changes */
      snprintf(memory, sizeof memory, " memory %g", next->pieces);
      snprintf(old, sizeof old, "memory %g", before->pieces);
    }
    snprintf(text, sizeof text,
             "stage `%s` begins with empty contact histories, because its law is `%s %s%s` instead of `%s`",
             stage->name, shear ? "shear" : "normal", law->name, memory, old);
    progress->note(progress->data, text);
  }
}

enum { CONTINUES, ENDED, EXHAUSTED };

/* Runs one cycle and records a row if one is due. *outcome: whether the stage continues; unchanged if the cycle
 * fails. */
static enum nb_status run_cycle(struct run *run, int index, int *outcome, struct nb_error *error) {
  const struct nb_stage *stage = &run->scene->stages[index];
  struct nb_model *model = run->model;
  if (nb_cycle(model, error))
    return error->status;
  const bool over = model->stage_cycle >= stage->cycles;
  *outcome = (stage->condition_count ? conditions_met(stage, model) : over) ? ENDED : over ? EXHAUSTED : CONTINUES;
  const bool due =
      stage->record_interval && (model->stage_cycle % stage->record_interval == 0 || *outcome != CONTINUES);
  if (due && !nb_result_add_row(&run->result->table, model, index))
    return nb_error_memory(error);
  return *outcome == EXHAUSTED ? conditions_not_met(stage, model, error) : NB_OK;
}

static enum nb_status take_snapshot(struct run *run, int index, struct nb_error *error) {
  struct nb_snapshot *snapshot = NB_ARRAY_APPEND(run->result->snapshots, run->result->snapshot_count);
  return snapshot && nb_snapshot_take(snapshot, run->model, index) ? NB_OK : nb_error_memory(error);
}

static enum nb_status run_stage(struct run *run, int index, struct nb_error *error) {
  const struct nb_stage *stage = &run->scene->stages[index];
  enum nb_status status = nb_stage_begin(run->model, stage, error);
  note_laws(run, stage);
  int outcome = CONTINUES;
  const unsigned long long updates = run->model->updates;
  run->reporter.stage_began = nb_processor_clock(), run->until_report = is_trial(run) ? 0 : run->until_report;
  while (!status && outcome == CONTINUES) {
    status = run_cycle(run, index, &outcome, error);
    if (!report_progress(run, stage) && !status)
      outcome = ENDED;
  }
  run->result->stages[index] =
      (struct nb_stage_cost){run->model->stage_cycle, run->model->updates - updates, run->model->step,
                             nb_processor_clock() - run->reporter.stage_began};
  if (outcome == CONTINUES || !stage->snapshot)
    return status;
  struct nb_error snapshot_error;
  const enum nb_status snapshot_status = take_snapshot(run, index, status ? &snapshot_error : error);
  return status ? status : snapshot_status;
}

/* Runs all stages of the scene, or those after the stage of the state from which it starts. The result has what was
 * recorded, even after an error. *end receives the state at the end, unless `end` is NULL. */
static enum nb_status run_scene(struct run *run, const struct nb_options *options, struct nb_saved *end,
                                struct nb_error *error) {
  const struct nb_scene *scene = run->scene;
  struct nb_result *result = run->result;
  struct nb_saved start = {0};
  const size_t first = scene->start.stages;
  if (first > 0 && nb_start_obtain(&start, scene, options, run->reporter.progress, !is_trial(run), error)) {
    nb_saved_free(&start);
    return error->status;
  }
  run->reporter = nb_reporter_begin(run->reporter.progress); /* so that computing the state is not counted */
  for (size_t s = first; s < scene->stage_count; s++)
    run->planned += scene->stages[s].cycles;
  if (nb_result_begin(result, scene))
    run->model = nb_model_resume(scene, options, first > 0 ? &start : NULL, error);
  else
    nb_error_memory(error);
  nb_saved_free(&start);
  if (!run->model)
    return error->status;
  run->first_cycle = run->model->cycle;
  enum nb_status status = NB_OK;
  if (scene->stages[first].record_interval && !nb_result_add_row(&result->table, run->model, (int)first))
    status = nb_error_memory(error);
  for (size_t s = first; s < scene->stage_count && !status; s++)
    status = run_stage(run, (int)s, error);
  if (!status && end)
    status = nb_saved_capture(end, run->model, error);
  result->cycles = run->model->cycle - run->first_cycle;
  result->updates = run->model->updates;
  result->searches = run->model->search.count;
  result->deep = nb_deep_count(run->model);
  snprintf(result->deep_first, sizeof result->deep_first, "%s", run->model->deep.first);
  result->seconds = nb_clock() - run->reporter.began;
  result->warnings = run->model->warnings;
  nb_model_free(run->model);
  return status;
}

enum nb_status nb_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_options *options,
                      const struct nb_progress *progress, struct nb_error *error) {
  if (scene->contact_test)
    return nb_contact_test_run(result, scene, options, progress, error);
  *result = (struct nb_result){0};
  struct run run = {.result = result, .scene = scene, .reporter.progress = progress};
  return run_scene(&run, options, NULL, error);
}

enum nb_status nb_run_to(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                         const struct nb_progress *progress, struct nb_error *error) {
  struct nb_options whole = options ? *options : (struct nb_options){.threads = 1};
  struct nb_result result = {0};
  struct run run = {.result = &result, .scene = scene, .reporter.progress = progress};
  whole.keep_all = true;
  whole.rounding =
      (struct nb_rounding){NB_TO_NEAREST, NULL}; /* a saved state does not depend on the mode of its reader */
  const enum nb_status status = run_scene(&run, &whole, saved, error);
  nb_result_free(&result);
  return status;
}

void nb_result_free(struct nb_result *result) {
  nb_table_free(&result->table);
  for (size_t s = 0; s < result->snapshot_count; s++)
    nb_snapshot_free(&result->snapshots[s]);
  free(result->snapshots);
  free(result->stages);
  *result = (struct nb_result){0};
}
