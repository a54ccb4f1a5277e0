/* Trials for `nineball advise`. A trial runs the page with the laws and values of a variant, with the step of a level,
 * and with one of several phases or realizations.
 *
 * A phase is a moment of first touch within a step. `impact` sets this moment. A page whose stages all end by `until`,
 * and in which nothing is given per cycle, is run with slightly different steps instead. Any other page has one phase.
 * `--over NAME` runs the page with NAME = 1, 2, …, such as the seed of a random packing; each value is a realization.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "advise.h"
#include "core/block.h"
#include "core/clock.h"

enum { SETTINGS_EXTRA = NB_TRADES + 7, SETTING_SIZE = 3 * NB_NAME_SIZE };
/* Phase p, 0 to 1, has the step divided by 1 + phase_spread p, for a page without `impact`. */
static const double phase_spread = 0.08;

bool nb_advice_no_memory(struct nb_advice *advice) {
  advice->no_memory = advice->exhausted = true;
  return false;
}

static bool fail(struct nb_point *point, const char *text) {
  const size_t length = strcspn(text, "\n");
  snprintf(point->reason, sizeof point->reason, "%.*s", (int)(length < 400 ? length : 400), text);
  return false;
}

/* ---- phases ---- */

static bool acts_per_cycle(const struct nb_stage *stage) {
  return stage->damping.global_kind >= NB_GLOBAL_CON1_CS79 || stage->boundary.strain.per_cycle ||
         stage->affine.strain.per_cycle || stage->cell.per_cycle || stage->box.per_cycle || stage->servo.per_cycle;
}

/* Number of phases of a page. Slightly different steps are possible only if no duration, strain or damping depends on a
 * number of cycles. */
size_t nb_phase_count(const struct nb_scene *scene) {
  if (scene->impact.line)
    return NB_PHASES;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    if (scene->stages[s].condition_count == 0 || acts_per_cycle(&scene->stages[s]))
      return 1;
  return NB_PHASES;
}

/* Sets the phase of a scene, a fraction of a step, 0 to 1. */
static void set_phase(struct nb_scene *scene, double phase) {
  if (scene->impact.line) {
    scene->impact.phase = fmod(scene->impact.phase + phase, 1);
    return;
  }
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    scene->stages[s].step.value /= 1 + phase_spread * phase;
}

/* ---- one trial ---- */

/* The data of one trial; owned. */
struct trial {
  size_t index;
  const char **settings;
  char texts[SETTINGS_EXTRA][SETTING_SIZE];
  struct nb_outcome outcome;
};

static void add_setting(struct trial *trial, size_t *count, size_t *text, const char *name, const char *value) {
  snprintf(trial->texts[*text], SETTING_SIZE, "%s=%s", name, value);
  trial->settings[(*count)++] = trial->texts[(*text)++];
}

/* Reads the page with the settings of the caller, and then those of the variant, the level and the realization. False:
 * no memory. */
static bool read_trial(struct trial *trial, const struct nb_advice *advice, const struct nb_variant *variant,
                       int level) {
  const struct nb_scene *page = &advice->page.runs[0].scene;
  char value[NB_NAME_SIZE];
  size_t count = 0, text = 0;
  while (advice->query->settings[count])
    count++;
  trial->settings = calloc(count + SETTINGS_EXTRA, sizeof *trial->settings);
  if (!trial->settings)
    return false;
  memcpy(trial->settings, advice->query->settings, count * sizeof *trial->settings);
  snprintf(value, sizeof value, "%.17g", page->refine * nb_level_refine(advice, level));
  add_setting(trial, &count, &text, "refine", value);
  snprintf(value, sizeof value, "%.17g", page->soften * variant->soften);
  if (variant->soften > 0)
    add_setting(trial, &count, &text, "soften", value);
  if (variant->centred)
    add_setting(trial, &count, &text, "damping", "centred");
  if (variant->normal[0]) {
    add_setting(trial, &count, &text, "normal", variant->normal);
    add_setting(trial, &count, &text, "shear", variant->shear);
  }
  for (size_t k = 0; k < page->trade_count; k++)
    if (variant->value[k])
      add_setting(trial, &count, &text, page->trades[k].name, page->trades[k].values[variant->value[k] - 1]);
  if (advice->query->over) {
    snprintf(value, sizeof value, "%zu", trial->index + 1);
    add_setting(trial, &count, &text, advice->query->over, value);
  }
  nb_outcome_read(&trial->outcome, advice->query->path, trial->settings);
  for (size_t r = 0; r < trial->outcome.run_count && !advice->query->over; r++)
    set_phase(&trial->outcome.runs[r].scene, (double)trial->index / NB_PHASES);
  return true;
}

/* Finds out whether the reference solution of the page accepts the variant. If it does not, `nineball run` would refuse
 * the setting. The trials use no reference solution. */
static bool take_references(struct nb_advice *advice, struct nb_point *point, struct nb_variant *variant,
                            struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    struct nb_page_run *run = &outcome->runs[r];
    const struct nb_reference *reference = run->expectations.reference;
    run->expectations.reference = NULL;
    if (variant->covered || !reference)
      continue;
    const enum nb_status status = nb_reference_solve(reference, &run->solution, &run->scene, &run->error);
    solution_free(&run->solution);
    if (status)
      return status == NB_NO_MEMORY ? nb_advice_no_memory(advice) : fail(point, run->error.text);
  }
  variant->covered = true;
  return true;
}

/* True if the trial can be run; otherwise point->reason has the reason. */
static bool check_trial(struct nb_advice *advice, struct nb_variant *variant, struct nb_point *point,
                        struct nb_outcome *outcome) {
  if (outcome->status == NB_NO_MEMORY)
    return nb_advice_no_memory(advice);
  if (outcome->status)
    return fail(point, outcome->mistakes.text ? outcome->mistakes.text : outcome->error.text);
  if (outcome->run_count != advice->runs)
    return fail(point, "the page has another number of runs with this setting");
  return take_references(advice, point, variant, outcome);
}

/* Stores the quantity of each run, and the cost of the setting. False: a value is missing. */
static bool take_values(struct nb_advice *advice, struct nb_point *point, struct trial *trial) {
  struct nb_outcome *outcome = &trial->outcome;
  double seconds = 0, updates = 0, recorded = 0, stability = 0;
  if (outcome->status)
    return outcome->status == NB_NO_MEMORY ? nb_advice_no_memory(advice) : fail(point, outcome->error.text);
  for (size_t r = 0; r < advice->runs; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    struct nb_expectation wanted;
    struct nb_error error;
    if (nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &outcome->mistakes))
      return outcome->mistakes.text ? fail(point, outcome->mistakes.text) : nb_advice_no_memory(advice);
    if (!nb_measure_value(&point->values[r * NB_TRIALS + trial->index], &wanted.measure, &run->result.table, &error))
      return fail(point, error.text);
    seconds += run->result.seconds;
    recorded += (double)run->result.table.row_count * (double)run->scene.column_count;
    stability = fmax(stability, run->result.stability);
    updates += (double)run->result.updates + (double)run->result.cycles * (double)run->scene.particle_count;
  }
  const struct nb_result *first = &outcome->runs[0].result;
  if (first->cycles > 0 && first->table.row_count > 0)
    point->step = (first->table.time[first->table.row_count - 1] - first->table.time[0]) / (double)first->cycles;
  point->seconds = point->done ? fmin(point->seconds, seconds) : seconds;
  point->recorded = recorded, point->stability[trial->index] = stability;
  point->done |= 1U << trial->index;
  point->updates += (updates - point->updates) / (double)nb_bit_count(point->done);
  return true;
}

static void free_trial(struct trial *trial) {
  if (trial->settings)
    nb_outcome_free(&trial->outcome);
  free(trial->settings);
}

/* ---- several trials at once ---- */

/* True if trials that run at once would end within the budget; if not, the search is exhausted. They are assumed to
 * take as long as earlier trials of the level, or twice as long as the trials of the next coarser level. */
static bool is_affordable(struct nb_advice *advice, const struct nb_point *point, int level) {
  const double now = nb_clock() - advice->began;
  const double expected = point->done || level == NB_LEVEL_LOW ? point->seconds : 2 * point[-1].seconds;
  if (now + expected > advice->query->budget)
    advice->exhausted = true;
  if (advice->query->progress.call)
    advice->query->progress.call(advice->query->progress.data, "search", now / advice->query->budget, now);
  return !advice->exhausted;
}

/* Runs the trials of a batch in parallel; none of them has been run. False: the budget is spent, or one of them has no
 * value. */
static bool run_batch(struct nb_advice *advice, struct nb_variant *variant, int level, struct trial *batch, int count) {
  struct nb_point *point = &variant->points[level - NB_LEVEL_LOW];
  bool good = true;
  if (!is_affordable(advice, point, level))
    return false;
  for (int k = 0; k < count && good; k++)
    good = read_trial(&batch[k], advice, variant, level) ? check_trial(advice, variant, point, &batch[k].outcome)
                                                         : nb_advice_no_memory(advice);
  nb_references_prepare();
#pragma omp parallel for num_threads(count) schedule(dynamic, 1) if (count > 1)
  for (int k = 0; k < (good ? count : 0); k++)
    batch[k].outcome.status = nb_outcome_run(&batch[k].outcome, &advice->query->options, NULL);
  for (int k = 0; k < count && good; k++)
    good = take_values(advice, point, &batch[k]), advice->measured++;
  return good;
}

bool nb_trials_run(struct nb_advice *advice, struct nb_variant *variant, int level, size_t first, size_t stride,
                   size_t count) {
  struct nb_point *point = &variant->points[level - NB_LEVEL_LOW];
  const int jobs = nb_job_count(&advice->query->options, NB_TRIALS);
  struct trial *batch;
  bool good = !point->reason[0];
  if (good && nb_level_ratios(advice, level).first == 1)
    return fail(point, "a longer step does not divide the stages of the page into whole numbers of cycles");
  if (!point->values)
    point->values = calloc(advice->runs * NB_TRIALS, sizeof *point->values);
  if (!point->values)
    return nb_advice_no_memory(advice);
  for (size_t k = 0; k < count && good;) {
    const int most = k == 0 ? 1 : jobs; /* the first trial runs alone: if it fails, the others are not run */
    int size = 0;
    batch = calloc((size_t)jobs, sizeof *batch);
    if (!batch)
      return nb_advice_no_memory(advice);
    for (; k < count && size < most; k++)
      if (!(point->done & 1U << (first + k * stride)))
        batch[size++].index = first + k * stride;
    good = size == 0 || run_batch(advice, variant, level, batch, size);
    for (int b = 0; b < jobs; b++)
      free_trial(&batch[b]);
    free(batch);
  }
  return good;
}

double nb_trials_time(struct nb_advice *advice, struct nb_variant *variant, int level) {
  struct trial trial = {.index = 0};
  double seconds = 0;
  struct nb_point discarded = {.done = 0};
  if (read_trial(&trial, advice, variant, level) && check_trial(advice, variant, &discarded, &trial.outcome) &&
      !nb_outcome_run(&trial.outcome, &advice->query->options, NULL))
    for (size_t r = 0; r < trial.outcome.run_count; r++)
      seconds += trial.outcome.runs[r].result.seconds;
  free_trial(&trial);
  return seconds > 0 ? seconds : NAN;
}
