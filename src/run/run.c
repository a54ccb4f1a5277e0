/* Runs a scene from its first stage, or from a saved state or a checkpoint, to its last stage.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "checkpoint.h"
#include "contact_test.h"
#include "core/clean.h"
#include "core/clock.h"
#include "core/names.h"
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/region.h"
#include "measure/snapshot.h"
#include "measure/step.h"
#include "plan.h"
#include "result.h"

struct run {
  struct nb_result *result;
  const struct nb_scene *scene;
  struct nb_model *model;
  struct nb_reporter reporter;
  unsigned long first_cycle;  /* number of cycles done before this run */
  unsigned long until_report; /* cycles until the clock is read; a reading costs as much as a cycle of a few contacts */
  unsigned long planned;      /* sum of the numbers of cycles that the stages may take */
  struct nb_checkpoint checkpoint;
  unsigned long stop_at;      /* for tests: cycle after which the run stops; 0: none */
  unsigned long long updates; /* contact updates before the stage */
  bool stage_ended;           /* the checkpoint was saved at the end of a stage */
  bool tracks;                /* the stage updates the extremes of tracked columns in each cycle */
  bool met_before;            /* the conditions of the stage were met when it began */
};

static bool is_trial(const struct run *run) {
  return run->reporter.progress && run->reporter.progress->stage_seconds > 0;
}

enum { CONTINUES, ENDED, EXHAUSTED };

/* Reports progress. Ends the stage of a trial that has used up its time. */
static void report_progress(struct run *run, const struct nb_stage *stage, int *outcome) {
  if (run->until_report-- > 0)
    return;
  const unsigned long done = run->model->stage_cycle, most = 100000 / (run->model->contacts.count + 20);
  run->until_report = is_trial(run) && done < most ? done : most;
  const double fraction = (double)(run->model->cycle - run->first_cycle) / (double)run->planned;
  if (!nb_reporter_update(&run->reporter, stage->name, fraction) && *outcome == CONTINUES)
    *outcome = ENDED, run->result->shortened = true;
}

bool nb_condition_met(const struct nb_condition *condition, const struct nb_model *model) {
  const double value = nb_quantity_value(condition->quantity, model);
  return condition->relation == NB_BELOW ? value < condition->value : value > condition->value;
}

/* True if all conditions of the stage hold; false if it has none. */
static bool conditions_met(const struct nb_stage *stage, const struct nb_model *model) {
  for (size_t k = 0; k < stage->condition_count; k++)
    if (!nb_condition_met(&stage->conditions[k], model))
      return false;
  return stage->condition_count > 0;
}

/* True if the stage ends now; `last`: this is its last cycle. Conditions are evaluated every check_interval cycles and
 * at the last cycle. */
static bool stage_ends(const struct nb_stage *stage, const struct nb_model *model, bool last) {
  return stage->condition_count == 0
             ? last
             : (last || model->stage_cycle % stage->check_interval == 0) && conditions_met(stage, model);
}

/* Writes the conditions of the stage with the present values: "time is 2 s JOINED above 1 s, ...". */
static void list_conditions(char *text, size_t size, const struct nb_stage *stage, const struct nb_model *model,
                            const char *joined) {
  text[0] = '\0';
  for (size_t k = 0; k < stage->condition_count; k++) {
    const struct nb_condition *condition = &stage->conditions[k];
    const char *const unit = nb_quantity_unit(condition->quantity);
    const bool none = model->scene->unitless || strcmp(unit, "1") == 0;
    const char *const space = none ? "" : " ", *const shown = none ? "" : unit;
    nb_append(text, size, "%s%s is %g%s%s%s %s %g%s%s", k ? ", " : "", condition->name,
              nb_quantity_value(condition->quantity, model), space, shown, joined,
              condition->relation == NB_BELOW ? "below" : "above", condition->value, space, shown);
  }
}

/* Writes "; its servo (line 12) ran at the largest rate in all cycles: raise `at most`" to `text` and returns it;
 * writes an empty text if the stage has no such servo. */
static const char *servo_limit(char *text, size_t size, const struct nb_model *model) {
  text[0] = '\0';
  if (model->stage->servo.line && model->affine->servo_state.phase == NB_SERVO_LIMITED)
    snprintf(text, size,
             "; its servo (line %d) ran at the largest rate in all cycles: raise `at most RATE` of the servo, or the "
             "number of cycles",
             model->stage->servo.line);
  return text;
}

static bool has_contact_force(const struct nb_model *model) {
  for (size_t c = 0; c < model->contacts.count; c++)
    if (model->contacts.force[c].x != 0 || model->contacts.force[c].y != 0)
      return true;
  return false;
}

/* True if no contact has a force, and a condition is not met because its quantity is 0, as a stress then is. */
static bool waits_for_contacts(const struct nb_stage *stage, const struct nb_model *model) {
  bool waits = false;
  for (size_t k = 0; k < stage->condition_count; k++)
    waits = waits || (!nb_condition_met(&stage->conditions[k], model) &&
                      nb_quantity_value(stage->conditions[k].quantity, model) == 0);
  return waits && !has_contact_force(model);
}

static enum nb_status conditions_not_met(const struct nb_stage *stage, const struct nb_model *model,
                                         struct nb_error *error) {
  char text[512], servo[160];
  list_conditions(text, sizeof text, stage, model, " and should be");
  return nb_error_set(error, NB_BROKEN, "stage `%s` (line %d) did not end within %lu cycles: %s%s%s", stage->name,
                      stage->line, stage->cycles, text, servo_limit(servo, sizeof servo, model),
                      waits_for_contacts(stage, model)
                          ? "; no contact has a force now: do gravity, walls and velocities bring the particles "
                            "together, or apart?"
                          : "");
}

/* Notes a change of a law, because the history of the old law is discarded. */
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
    if (shear && next->shear == before->shear) { /* only the number of pieces of its memory changes */
      snprintf(memory, sizeof memory, " memory %g", next->pieces);
      snprintf(old, sizeof old, "memory %g", before->pieces);
    }
    snprintf(text, sizeof text,
             "stage `%s` begins with empty histories of the %s force, because its law is `%s %s%s` instead of `%s`",
             stage->name, shear ? "shear" : "normal", shear ? "shear" : "normal", law->name, memory, old);
    progress->note(progress->data, text);
  }
}

/* The name of the unbalanced force in a condition of the stage, if no contact has a force. Such a condition waits for
 * equilibrium, but it also holds where no force acts: the unbalanced force is then 0. NULL: there is no such condition,
 * or there are contact forces. */
static const char *met_without_contact(const struct nb_model *model, const struct nb_stage *stage) {
  for (size_t k = 0; k < stage->condition_count; k++) {
    const char *const name = stage->conditions[k].quantity.kind->name;
    if (strncmp(name, "unbalanced.", strlen("unbalanced.")) == 0 && !has_contact_force(model))
      return name;
  }
  return NULL;
}

/* The part of a warning that says why a condition may have been met before the stage: its quantity counts from an
 * earlier time. Empty if no quantity does. */
static const char *counts_from(const struct nb_stage *stage) {
  static const char strain[] = "strain";
  for (size_t k = 0; k < stage->condition_count; k++) {
    const char *const name = stage->conditions[k].quantity.kind->name, *const part = strstr(name, strain);
    if (strcmp(name, "time") == 0)
      return "; `time` counts from the start of the run, `stage.time` from the start of the stage";
    if (part == name)
      return "; this strain counts from the start of the run, or with `region … from STAGE` from the start of STAGE; "
             "`stage.time` counts from the start of each stage";
    if (part)
      return "; this strain counts from time 0, `stage.time` from the start of the stage";
  }
  return "";
}

/* If the largest difference of a controlled stress from its target, over the largest target, is above this, the end of
 * a stage is doubtful. This ratio is 1 if all stresses are 0. */
static const double servo_tolerance = 0.1;

/* True if the servo of the next stage goes on towards the same target, or ramps its target from the present stress. */
static bool servo_goes_on(const struct run *run, const struct nb_stage *stage) {
  const struct nb_servo *const now = &stage->servo, *const next = &stage[1].servo;
  if (stage == &run->scene->stages[run->scene->stage_count - 1] || !next->line)
    return false;
  return next->ramp ||
         (next->quantity->kind == now->quantity->kind && next->quantity->monitor == now->quantity->monitor &&
          memcmp(next->stress, now->stress, sizeof now->stress) == 0);
}

/* Warns of a stage that ended without the loading that its author had in mind. */
static void warn_of_end(const struct run *run, const struct nb_stage *stage) {
  struct nb_model *model = run->model;
  const char *const unbalanced = met_without_contact(model, stage);
  char text[512], servo[160];
  if (unbalanced) {
    const bool controlled = nb_servo_condition(text, sizeof text, run->scene, &stage->servo, run->scene->unitless);
    nb_warn(&model->warnings, stage->line,
            "stage `%s` ended in cycle %lu without a contact force, where `%s` is 0; add a condition such as `and %s`",
            stage->name, model->stage_cycle, unbalanced, controlled ? text : "contacts above 0");
  } else if (run->met_before && model->stage_cycle <= stage->check_interval) {
    list_conditions(text, sizeof text, stage, model, ",");
    nb_warn(&model->warnings, stage->line,
            "stage `%s` ended in cycle %lu, because its condition was met before the stage began: %s%s", stage->name,
            model->stage_cycle, text, counts_from(stage));
  } else if (nb_servo_error(model) > servo_tolerance && !servo_goes_on(run, stage)) {
    nb_warn(&model->warnings, stage->line,
            "stage `%s` ended while a controlled stress differed from the target of the servo by %.3g %%; %s a "
            "condition on this stress%s",
            stage->name, 100 * nb_servo_error(model), stage->condition_count > 0 ? "add" : "end it by",
            servo_limit(servo, sizeof servo, model));
  }
}

/* Warns of a recorded porosity or void ratio that is below 0. */
static void warn_of_porosity(struct nb_model *model, const struct nb_stage *stage) {
  const struct nb_scene *scene = model->scene;
  for (size_t c = 0; c < scene->column_count; c++) {
    const struct nb_column *column = &scene->columns[c];
    const char *const kind = column->quantity.kind->name;
    const bool of_pores = strstr(kind, "porosity") || strstr(kind, "void_ratio");
    const double value = of_pores ? nb_quantity_value(column->quantity, model) : 0;
    if (value < 0)
      nb_warn(&model->warnings, 0,
              "`%s` is negative: %.3f at the end of stage `%s`, because the overlaps of particles count twice",
              column->name, value, stage->name);
  }
}

/* Runs one cycle and records a row if one is due. Sets *outcome, which says whether the stage continues, unless the
 * cycle fails. */
static enum nb_status run_cycle(struct run *run, int index, int *outcome, struct nb_error *error) {
  const struct nb_stage *stage = &run->scene->stages[index];
  struct nb_model *model = run->model;
  if (nb_cycle(model, error))
    return error->status;
  if (run->tracks)
    nb_result_track(run->result, model, index);
  const bool over = model->stage_cycle >= stage->cycles;
  *outcome = stage_ends(stage, model, over) ? ENDED : over ? EXHAUSTED : CONTINUES;
  const bool due =
      stage->record_interval && (model->stage_cycle % stage->record_interval == 0 || *outcome != CONTINUES);
  if (due && !nb_result_add_row(&run->result->table, model, index))
    return nb_error_memory(error);
  return *outcome == EXHAUSTED ? conditions_not_met(stage, model, error) : NB_OK;
}

/* ---- checkpoints ---- */

/* Saves or restores a table. The stages of restored rows must be stages of the scene. */
static void store_table(struct nb_store *store, const struct run *run, struct nb_table *table) {
  nb_store_table(store, table);
  for (size_t k = 0; k < table->row_count && store->restoring; k++)
    store->failed = store->failed || table->stage[k] < 0 || table->stage[k] >= (int)run->scene->stage_count;
}

static void store_snapshots(struct nb_store *store, struct run *run) {
  struct nb_result *result = run->result;
  size_t count = result->snapshot_count;
  NB_STORE_INTEGERS(store, "snapshots", &count, 1);
  for (size_t k = 0; k < count && !store->failed; k++) {
    int stage = k < result->snapshot_count ? result->snapshots[k].stage : 0;
    NB_STORE_INTEGERS(store, "snapshot", &stage, 1);
    if (store->restoring) { /* a snapshot of the current state gives the columns; its rows are replaced */
      struct nb_snapshot *new = NB_ARRAY_APPEND(result->snapshots, result->snapshot_count);
      const bool taken = stage >= 0 && stage < (int)run->scene->stage_count && run->scene->stages[stage].snapshot;
      if (!new || !taken || !nb_snapshot_take(new, run->model, stage)) {
        store->failed = true;
        return;
      }
    }
    struct nb_table *table;
    for (size_t t = 0; (table = nb_snapshot_table_at(&result->snapshots[k], t)); t++)
      store_table(store, run, table);
  }
}

/* Saves everything that the run keeps: its model, and what it has recorded; if store->restoring, restores it. */
static void store_run(struct nb_store *store, struct run *run) {
  double seconds = nb_clock() - run->reporter.began, stage_seconds = nb_processor_clock() - run->reporter.stage_began;
  nb_model_store(store, run->model);
  NB_STORE_INTEGERS(store, "stage_ended", &run->stage_ended, 1);
  NB_STORE_INTEGERS(store, "met_before", &run->met_before, 1);
  NB_STORE_INTEGERS(store, "first_cycle", &run->first_cycle, 1);
  NB_STORE_INTEGERS(store, "updates_before", &run->updates, 1);
  NB_STORE(store, "seconds", &seconds, 1);
  NB_STORE(store, "stage_seconds", &stage_seconds, 1);
  for (size_t s = 0; s < run->scene->stage_count; s++) {
    struct nb_stage_cost *cost = &run->result->stages[s];
    NB_STORE_INTEGERS(store, "cost", &cost->cycles, 1);
    NB_STORE_INTEGERS(store, "cost", &cost->updates, 1);
    NB_STORE(store, "cost", &cost->step, 1);
    NB_STORE(store, "cost", &cost->seconds, 1);
  }
  NB_STORE(store, "extremes", run->result->extremes, run->scene->stage_count * run->scene->column_count);
  if (store->restoring) /* expectations may have changed, and with them the columns that the run tracks */
    nb_result_forget_extremes(run->result, run->scene);
  store_table(store, run, &run->result->table);
  store_snapshots(store, run);
  if (store->restoring)
    run->reporter.began -= seconds, run->reporter.stage_began = nb_processor_clock() - stage_seconds;
}

static enum nb_status save_checkpoint(struct run *run, bool stage_ended, struct nb_error *error) {
  struct nb_store store = {0};
  run->stage_ended = stage_ended;
  store_run(&store, run);
  return nb_checkpoint_save(&run->checkpoint, run->model, &store, error);
}

/* Saves a checkpoint and stops the run. */
static enum nb_status stop(struct run *run, bool stage_ended, struct nb_error *error) {
  const double fraction = (double)(run->model->cycle - run->first_cycle) / (double)run->planned;
  const double left = (nb_clock() - run->reporter.began) * (1 - fraction) / fraction;
  struct nb_error cause;
  if (save_checkpoint(run, stage_ended, &cause))
    return nb_error_set(error, NB_BAD_USE, "stopped by a signal after cycle %lu, without a checkpoint: %.300s",
                        run->model->cycle, cause.text);
  return nb_error_set(error, NB_BROKEN,
                      "stopped by a signal after cycle %lu (%.0f %%, at most %.0f s left); the checkpoint is %.300s",
                      run->model->cycle, 100 * fraction, left, run->checkpoint.path);
}

/* Called after a cycle, or at the end of a stage: stops the run if it has been asked to stop, or else saves a
 * checkpoint if one is due. If that checkpoint cannot be written, a note says so and the run continues. */
static enum nb_status check_in(struct run *run, bool stage_ended, struct nb_error *error) {
  const struct nb_model *model = run->model;
  const bool last = stage_ended && model->stage == &run->scene->stages[run->scene->stage_count - 1];
  struct nb_error cause;
  if ((nb_checkpoint_stops(&run->checkpoint) || model->cycle == run->stop_at) && !last)
    return stop(run, stage_ended, error);
  if (!stage_ended && run->checkpoint.until_check-- > 0)
    return NB_OK;
  run->checkpoint.until_check = 100000 / (model->contacts.count + 20);
  if (nb_checkpoint_is_due(&run->checkpoint, stage_ended) && save_checkpoint(run, stage_ended, &cause))
    nb_note(run->reporter.progress, cause.text);
  return NB_OK;
}

/* ---- stages ---- */

static enum nb_status take_snapshot(struct run *run, int index, struct nb_error *error) {
  struct nb_snapshot *snapshot = NB_ARRAY_APPEND(run->result->snapshots, run->result->snapshot_count);
  return snapshot && nb_snapshot_take(snapshot, run->model, index) ? NB_OK : nb_error_memory(error);
}

static enum nb_status begin_stage(struct run *run, const struct nb_stage *stage, struct nb_error *error) {
  const enum nb_status status = nb_stage_begin(run->model, stage, error);
  note_laws(run, stage);
  run->met_before = !status && conditions_met(stage, run->model);
  run->updates = run->model->updates;
  run->reporter.stage_began = nb_processor_clock(), run->until_report = is_trial(run) ? 0 : run->until_report;
  return status;
}

/* True if the stage records rows, but not in every cycle, and the run keeps the extremes of all cycles. */
static bool tracks_extremes(const struct run *run, const struct nb_stage *stage) {
  bool tracked = false;
  for (size_t c = 0; c < run->scene->column_count; c++)
    tracked = tracked || run->scene->columns[c].tracked;
  return tracked && stage->record_interval > 1;
}

/* Runs a stage. `resumed`: the run continues from a checkpoint inside the stage. */
static enum nb_status run_stage(struct run *run, int index, bool resumed, struct nb_error *error) {
  const struct nb_stage *stage = &run->scene->stages[index];
  enum nb_status status = resumed ? NB_OK : begin_stage(run, stage, error);
  int outcome = CONTINUES;
  run->tracks = tracks_extremes(run, stage);
  while (!status && outcome == CONTINUES) {
    status = run_cycle(run, index, &outcome, error);
    if (!status)
      report_progress(run, stage, &outcome);
    if (run->checkpoint.options && !status && outcome == CONTINUES)
      status = check_in(run, false, error);
  }
  run->result->stages[index] =
      (struct nb_stage_cost){run->model->stage_cycle, run->model->updates - run->updates, run->model->step,
                             nb_processor_clock() - run->reporter.stage_began};
  if (outcome == ENDED && !is_trial(run)) {
    warn_of_end(run, stage);
    nb_regions_warn(run->model, stage->name);
    warn_of_porosity(run->model, stage);
  }
  if (outcome == CONTINUES || !stage->snapshot)
    return status;
  struct nb_error snapshot_error;
  const enum nb_status snapshot_status = take_snapshot(run, index, status ? &snapshot_error : error);
  return status ? status : snapshot_status;
}

/* Makes the model from the checkpoint, from the state from which the scene starts, or at time 0. */
static enum nb_status make_model(struct run *run, const struct nb_options *options, struct nb_error *error) {
  const struct nb_scene *scene = run->scene;
  struct nb_saved start = {0};
  const bool starts = scene->start.stages > 0;
  enum nb_status status = nb_checkpoint_read(&start, &run->checkpoint, run->reporter.progress, error);
  const bool resumed = start.store.part_count > 0;
  if (!status && !resumed && starts)
    status = nb_start_obtain(&start, scene, options, run->reporter.progress, !is_trial(run), error);
  run->reporter = nb_reporter_begin(run->reporter.progress); /* the time for computing the state does not count */
  if (!status && !nb_result_begin(run->result, scene))
    status = nb_error_memory(error);
  if (!status && !(run->model = nb_model_resume(scene, options, resumed || starts ? &start : NULL, error)))
    status = error->status;
  if (!status)
    run->first_cycle = run->model->cycle;
  if (!status && resumed) {
    store_run(&start.store, run);
    if (start.store.failed)
      status = nb_error_set(error, NB_BAD_USE, "%.300s is not a checkpoint of this page", run->checkpoint.path);
  }
  nb_saved_free(&start);
  return status;
}

/* Runs all stages that are left: after a checkpoint, the rest of its stage and the stages after it. */
static enum nb_status run_stages(struct run *run, struct nb_error *error) {
  const struct nb_scene *scene = run->scene;
  const size_t first = scene->start.stages;
  const bool resumed = run->model->cycle > run->first_cycle;
  size_t s = resumed ? (size_t)(run->model->stage - scene->stages) + run->stage_ended : first;
  bool inside = resumed && !run->stage_ended;
  if (!resumed && scene->stages[first].record_interval &&
      !nb_result_add_row(&run->result->table, run->model, (int)first))
    return nb_error_memory(error);
  for (; s < scene->stage_count; s++, inside = false)
    if (run_stage(run, (int)s, inside, error) || (run->checkpoint.options && check_in(run, true, error)))
      return error->status;
  return NB_OK;
}

/* Runs all stages of the scene, or the stages after the state from which the scene starts. The result has everything
 * that was recorded, even after an error. *end receives the state at the end, unless `end` is NULL; it is not changed
 * if the run fails. */
static enum nb_status run_scene(struct run *run, const struct nb_options *options, struct nb_saved *end,
                                struct nb_error *error) {
  const struct nb_scene *scene = run->scene;
  struct nb_result *result = run->result;
  if (nb_checkpoint_begin(&run->checkpoint, scene, options, error))
    return error->status;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    run->planned += scene->stages[s].cycles;
  enum nb_status status = make_model(run, options, error);
  if (run->model) {
    run->stop_at = options && options->checkpoint.stop_after ? run->model->cycle + options->checkpoint.stop_after : 0;
    status = status ? status : run_stages(run, error);
    if (!status && end)
      status = nb_saved_capture(end, run->model, error);
    result->cycles = run->model->cycle - run->first_cycle;
    result->updates = run->model->updates;
    result->searches = run->model->search.count;
    result->stability = run->model->stability->largest;
    result->deep = nb_deep_count(run->model);
    snprintf(result->deep_first, sizeof result->deep_first, "%s", run->model->deep.first);
    result->seconds = nb_clock() - run->reporter.began;
    result->warnings = run->model->warnings;
    nb_model_free(run->model);
  }
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
  whole.rounding = (struct nb_rounding){
      NB_TO_NEAREST, NULL}; /* a saved state does not depend on the rounding mode of the run that reads it */
  /* This key is the same for all pages and runs that need the state. */
  whole.checkpoint.key = scene->stages[scene->stage_count - 1].hash;
  const enum nb_status status = run_scene(&run, &whole, saved, error);
  nb_result_free(&result);
  return status;
}

void nb_result_free_snapshots(struct nb_result *result) {
  for (size_t s = 0; s < result->snapshot_count; s++)
    nb_snapshot_free(&result->snapshots[s]);
  free(result->snapshots);
  result->snapshots = NULL, result->snapshot_count = 0;
}

void nb_result_free(struct nb_result *result) {
  nb_table_free(&result->table);
  nb_result_free_snapshots(result);
  free(result->stages);
  free(result->extremes);
  *result = (struct nb_result){0};
}
