/* Advice: the cheapest step and contact laws whose error in one quantity is within a tolerance, found by
 * running the page.
 *
 * Errors are relative to the limit of the page for a step towards zero, with its own laws; the anchor of estimate.c
 * approximates it. The reference of the page is not used, because for a candidate with other laws it would return
 * another solution. A setting is a pair of laws and a level: the page with --set refine=2^level. Each setting is run at
 * several phases, which are moments of first touch within a step. `impact` sets them; a page whose stages all end by
 * `until` is run with slightly different steps instead. Any other page has one phase.
 *
 * The estimated error of a setting needs the results at its level, at the two finer ones, and an anchor that is at least
 * two levels finer. Levels are tried from the coarsest one on; the first one within the tolerance is the cheapest of
 * its pair of laws. A pair is left out if the page or its reference refuses it, if it gives the values of another pair,
 * or if they differ from the anchor by more than twice the tolerance at the level that was found for the page's own
 * laws.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clock.h"
#include "input/reader.h"
#include "laws/law.h"

enum { PARTICLES_MAX = 50, SETTINGS_EXTRA = 4 };
static const double anchor_share = 0.5; /* largest uncertainty of the anchor, as a fraction of the tolerance */
static const double phase_spread =
    0.08; /* of a page without `impact`: largest relative difference of the steps of two phases */
static const double law_distance = 2; /* over the tolerance: a pair of laws farther from the anchor is left out */

/* ---- one run of the page ---- */

/* Memory that ran out ends the search; other reasons belong to the candidate. */
static bool fail_memory(struct nb_advice *advice) {
  advice->no_memory = advice->exhausted = true;
  return false;
}

static bool fail(struct nb_point *point, const char *text) {
  const size_t length = strcspn(text, "\n");
  snprintf(point->reason, sizeof point->reason, "%.*s", (int)(length < 240 ? length : 240), text);
  return false;
}

/* `phase`: a fraction of a step, 0 to 1. */
static void set_phase(struct nb_scene *scene, double phase) {
  if (scene->impact.line) {
    scene->impact.phase = fmod(scene->impact.phase + phase, 1);
    return;
  }
  scene->step.value /= 1 + phase_spread * phase;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    scene->stages[s].step.value /= 1 + phase_spread * phase;
}

/* Reads the page with the settings of the caller and then those of the candidate, and sets the phase. */
static void read_candidate(struct nb_outcome *outcome, const struct nb_advice *advice, const struct nb_law_pair *pair,
                           int level, size_t phase, const char **settings, char texts[][2 * NB_NAME_SIZE]) {
  const struct nb_scene *page = &advice->page.runs[0].scene;
  size_t count = 0;
  while (advice->query->settings[count])
    settings[count] = advice->query->settings[count], count++;
  snprintf(texts[0], sizeof texts[0], "refine=%.17g", page->refine * exp2(level));
  snprintf(texts[1], sizeof texts[1], "normal=%s", pair->normal);
  snprintf(texts[2], sizeof texts[2], "shear=%s", pair->shear);
  settings[count++] = texts[0];
  if (pair->normal[0])
    settings[count++] = texts[1], settings[count++] = texts[2];
  settings[count] = NULL;
  nb_outcome_read(outcome, advice->query->path, settings);
  nb_references_prepare();
  for (size_t r = 0; r < outcome->run_count; r++)
    set_phase(&outcome->runs[r].scene, (double)phase / NB_PHASES);
}

/* Whether the reference of the page covers the laws; otherwise `nineball run` would refuse the setting. The runs of the
 * search use no reference. */
static bool take_references(struct nb_advice *advice, struct nb_point *point, struct nb_law_pair *pair,
                            struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    struct nb_page_run *run = &outcome->runs[r];
    const struct nb_reference *reference = run->expectations.reference;
    run->expectations.reference = NULL;
    if (pair->covered || !reference)
      continue;
    const enum nb_status status = nb_reference_solve(reference, &run->solution, &run->scene, &run->error);
    solution_free(&run->solution);
    if (status)
      return status == NB_NO_MEMORY ? fail_memory(advice) : fail(point, run->error.text);
  }
  pair->covered = true;
  return true;
}

/* Stores the quantity of each run, and the cost of the setting. */
static bool take_values(struct nb_advice *advice, struct nb_point *point, struct nb_outcome *outcome, size_t phase) {
  double seconds = 0, updates = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    struct nb_expectation wanted;
    struct nb_error error;
    if (nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &outcome->mistakes))
      return outcome->mistakes.text ? fail(point, outcome->mistakes.text) : fail_memory(advice);
    if (!nb_measure_value(&point->values[r * NB_PHASES + phase], &wanted.measure, &run->result.table, &error))
      return fail(point, error.text);
    seconds += run->result.seconds;
    updates += (double)run->result.updates + (double)run->result.cycles * (double)run->scene.particle_count;
  }
  const struct nb_result *first = &outcome->runs[0].result;
  if (first->cycles > 0 && first->table.row_count > 0)
    point->step = (first->table.time[first->table.row_count - 1] - first->table.time[0]) / (double)first->cycles;
  point->seconds = point->done ? fmin(point->seconds, seconds) : seconds;
  point->updates = updates;
  point->done |= 1U << phase;
  return true;
}

/* Whether the run would end within the budget, if it takes twice as long as the one of the next coarser level. */
static bool is_affordable(struct nb_advice *advice, const struct nb_law_pair *pair, int level) {
  const double now = nb_clock() - advice->began;
  const struct nb_point *point = &pair->points[level - NB_LEVEL_LOW];
  double expected = point->done ? point->seconds : 0;
  if (!point->done && level > NB_LEVEL_LOW && point[-1].done)
    expected = 2 * point[-1].seconds;
  if (now + expected > advice->query->budget)
    advice->exhausted = true;
  if (advice->query->progress.call)
    advice->query->progress.call(advice->query->progress.data, "search", now / advice->query->budget, now);
  return !advice->exhausted;
}

/* Runs all runs of a candidate that has been read, and stores their values. */
static bool run_candidate(struct nb_advice *advice, struct nb_law_pair *pair, struct nb_point *point,
                          struct nb_outcome *outcome, size_t phase) {
  if (!outcome->status && outcome->run_count != advice->runs)
    return fail(point, "the page has another number of runs with this setting");
  if (!outcome->status && !take_references(advice, point, pair, outcome))
    return false;
  if (!outcome->status)
    outcome->status = nb_outcome_run(outcome, &advice->query->options, NULL);
  if (outcome->status == NB_NO_MEMORY)
    return fail_memory(advice);
  if (outcome->status)
    return fail(point, outcome->mistakes.text ? outcome->mistakes.text : outcome->error.text);
  return take_values(advice, point, outcome, phase);
}

/* Runs a pair of laws at a level and a phase, unless it has been run. */
static bool run_phase(struct nb_advice *advice, struct nb_law_pair *pair, int level, size_t phase) {
  struct nb_point *point = &pair->points[level - NB_LEVEL_LOW];
  char texts[SETTINGS_EXTRA][2 * NB_NAME_SIZE];
  size_t count = 0;
  if (point->reason[0])
    return false;
  if (point->done & 1U << phase)
    return true;
  if (!is_affordable(advice, pair, level))
    return false;
  while (advice->query->settings[count])
    count++;
  const char **settings = calloc(count + SETTINGS_EXTRA, sizeof *settings);
  if (!point->values)
    point->values = calloc(advice->runs * NB_PHASES, sizeof *point->values);
  if (!settings || !point->values) {
    free(settings);
    return fail_memory(advice);
  }
  struct nb_outcome outcome;
  read_candidate(&outcome, advice, pair, level, phase, settings, texts);
  const bool done = run_candidate(advice, pair, point, &outcome, phase);
  advice->measured++;
  nb_outcome_free(&outcome);
  free(settings);
  return done;
}

/* Runs `phases` phases, evenly spaced. */
static bool run_phases(struct nb_advice *advice, struct nb_law_pair *pair, int level, size_t phases) {
  if (level > NB_LEVEL_HIGH)
    return false;
  for (size_t k = 0; k < phases; k++)
    if (!run_phase(advice, pair, level, k * (NB_PHASES / phases)))
      return false;
  return true;
}

/* ---- anchor and claim ---- */

static size_t anchor_phases(const struct nb_advice *advice) { return advice->phases > 1 ? 2 : 1; }

static bool run_anchor(struct nb_advice *advice, int level) {
  return run_phases(advice, &advice->pairs[0], level - 1, anchor_phases(advice)) &&
         run_phases(advice, &advice->pairs[0], level, anchor_phases(advice));
}

static struct nb_anchor anchor_of(const struct nb_advice *advice, int level, size_t run) {
  const struct nb_point *fine = &advice->pairs[0].points[level - NB_LEVEL_LOW], *coarse = fine - 1;
  double at[2], at_double_step[2];
  for (size_t k = 0; k < anchor_phases(advice); k++) {
    at[k] = fine->values[run * NB_PHASES + k * NB_PHASES / 2];
    at_double_step[k] = coarse->values[run * NB_PHASES + k * NB_PHASES / 2];
  }
  return nb_estimate_anchor(at, at_double_step, anchor_phases(advice));
}

/* Sets the tolerance of each run from the anchor; returns the largest uncertainty over tolerance, and the run where it
 * is. */
static double anchor_ratio(struct nb_advice *advice, int level, size_t *worst) {
  double largest = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    const struct nb_anchor anchor = anchor_of(advice, level, r);
    advice->allowed[r] = advice->tolerance.value * (advice->tolerance.kind == NB_ABSOLUTE ? 1 : fabs(anchor.value));
    /* a percentage of 0 allows no error: 0/0 */
    const double ratio =
        anchor.uncertainty == 0 && advice->allowed[r] > 0 ? 0 : anchor.uncertainty / advice->allowed[r];
    if (!(ratio <= largest))
      largest = ratio, *worst = r;
  }
  return largest;
}

static enum nb_status find_anchor(struct nb_advice *advice, struct nb_error *error) {
  size_t worst = 0;
  double ratio = INFINITY;
  for (advice->anchor = 1; advice->anchor <= NB_LEVEL_HIGH && run_anchor(advice, advice->anchor); advice->anchor++)
    if ((ratio = anchor_ratio(advice, advice->anchor, &worst)) <= anchor_share)
      return NB_OK;
  const struct nb_point *first = &advice->pairs[0].points[-NB_LEVEL_LOW];
  if (advice->anchor == 1)
    return nb_error_set(error, NB_FAILED, "the page cannot be run with its own step and with half of it: %.300s",
                        first[0].reason[0]   ? first[0].reason
                        : first[1].reason[0] ? first[1].reason
                                             : "the budget is too small; choose a larger --budget");
  const char *label = advice->page.runs[worst].label;
  return nb_error_set(
      error, NB_FAILED,
      "`%s`: the value is not known well enough: with the step divided by %g its uncertainty is %.2g "
      "times the tolerance%s%s. Choose a larger tolerance, an absolute one if the value is near 0, or a "
      "larger --budget",
      advice->text, exp2(advice->anchor - 1), ratio, label[0] ? ", in run " : "", label);
}

/* Adds the setting and its estimated error to the list; false: it has none. */
static bool add_claim(struct nb_advice *advice, size_t index, int level) {
  struct nb_law_pair *pair = &advice->pairs[index];
  struct nb_setting setting = {.pair = index, .level = level};
  const int anchor = level + 2 > advice->anchor ? level + 2 : advice->anchor;
  for (int k = 0; k < 3; k++)
    if (!run_phases(advice, pair, level + k, advice->phases))
      return false;
  if (!run_anchor(advice, anchor))
    return false;
  const struct nb_point *point = &pair->points[level - NB_LEVEL_LOW];
  for (size_t r = 0; r < advice->runs; r++) {
    double step;
    const double claim =
        nb_estimate_claim(&step, point[0].values + r * NB_PHASES, point[1].values + r * NB_PHASES,
                          point[2].values + r * NB_PHASES, advice->phases, anchor_of(advice, anchor, r));
    const double ratio = claim == 0 ? 0 : claim / advice->allowed[r];
    if (!(ratio <= setting.ratio))
      setting.ratio = ratio, setting.step_ratio = step / advice->allowed[r], setting.worst = r;
  }
  struct nb_setting *added = NB_ARRAY_APPEND(advice->settings, advice->setting_count);
  if (!added)
    return fail_memory(advice);
  *added = setting;
  return true;
}

/* ---- the search ---- */

/* The numbers of updates decide. If they are nearly equal, as those of different laws with the same step, the times of
 * computation do. */
static bool is_cheaper(const struct nb_advice *advice, const struct nb_setting *a, const struct nb_setting *b) {
  const struct nb_point *one = nb_point_at(advice, a), *other = nb_point_at(advice, b);
  const double same = 0.1;
  return fabs(one->updates - other->updates) > same * other->updates ? one->updates < other->updates
                                                                     : one->seconds < other->seconds;
}

/* Tries the levels of a pair of laws from the coarsest one on, up to the first one within the tolerance. */
static void search_levels(struct nb_advice *advice, size_t pair, int highest) {
  for (int level = NB_LEVEL_LOW; level <= highest && !advice->exhausted; level++) {
    if (!add_claim(advice, pair, level))
      continue;
    const int last = (int)advice->setting_count - 1;
    if (!(advice->settings[last].ratio <= 1))
      continue;
    if (advice->chosen < 0 || is_cheaper(advice, &advice->settings[last], &advice->settings[advice->chosen]))
      advice->chosen = last;
    return;
  }
}

/* Whether a pair before this one gives the same values, to the last bit and in every run, because the scene does not
 * use what distinguishes the laws. */
static bool gives_same_values(const struct nb_advice *advice, const struct nb_law_pair *pair, int level) {
  const struct nb_point *point = &pair->points[level - NB_LEVEL_LOW];
  for (const struct nb_law_pair *other = advice->pairs; other < pair; other++) {
    const struct nb_point *before = &other->points[level - NB_LEVEL_LOW];
    bool same = before->done & 1;
    for (size_t r = 0; r < advice->runs && same; r++)
      same = point->values[r * NB_PHASES] == before->values[r * NB_PHASES];
    if (same)
      return true;
  }
  return false;
}

/* Whether the laws are near enough to the anchor to be tried. */
static bool is_near(struct nb_advice *advice, struct nb_law_pair *pair, int level) {
  const struct nb_point *point = &pair->points[level - NB_LEVEL_LOW];
  if (!run_phases(advice, pair, level, 1)) {
    snprintf(pair->reason, sizeof pair->reason, "%s", advice->exhausted ? "the budget was used up" : point->reason);
    return false;
  }
  if (gives_same_values(advice, pair, level)) {
    snprintf(pair->reason, sizeof pair->reason, "it gives the same values as a pair before it");
    pair->equal = true;
    return false;
  }
  size_t worst = 0;
  double largest = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    const double error = fabs(point->values[r * NB_PHASES] - anchor_of(advice, advice->anchor, r).value);
    if (error > largest * advice->allowed[r])
      largest = error / advice->allowed[r], worst = r;
  }
  if (largest <= law_distance)
    return true;
  const char *label = advice->page.runs[worst].label;
  pair->distance = largest;
  snprintf(pair->reason, sizeof pair->reason, "its value differs from that of the page by %.2g times the tolerance%s%s",
           largest, label[0] ? ", in run " : "", label);
  return false;
}

static void search(struct nb_advice *advice) {
  search_levels(advice, 0, advice->anchor);
  const int own = advice->chosen < 0 ? advice->anchor : advice->settings[advice->chosen].level;
  for (size_t k = 1; k < advice->pair_count; k++)
    if (is_near(advice, &advice->pairs[k], own))
      search_levels(advice, k, own);
}

/* ---- the page ---- */

/* The pairs of laws to try: that of the page, then all others, unless the page sweeps its laws. */
static bool list_pairs(struct nb_advice *advice) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  advice->pairs = calloc(NB_LAW_PAIRS, sizeof *advice->pairs);
  advice->pair_count = 1;
  if (!advice->pairs)
    return false;
  if (NB_FIND(scene->bindings, scene->binding_count, "normal") >= 0 ||
      NB_FIND(scene->bindings, scene->binding_count, "shear") >= 0)
    return true;
  for (const struct nb_law *const *normal = nb_laws(); *normal; normal++)
    for (const struct nb_law *const *shear = nb_laws(); *shear; shear++) {
      if (strcmp((*normal)->kind, "normal") != 0 || strcmp((*shear)->kind, "shear") != 0 ||
          (strcmp((*normal)->name, scene->normal) == 0 && strcmp((*shear)->name, scene->shear) == 0) ||
          advice->pair_count == NB_LAW_PAIRS)
        continue;
      struct nb_law_pair *pair = &advice->pairs[advice->pair_count++];
      snprintf(pair->normal, sizeof pair->normal, "%s", (*normal)->name);
      snprintf(pair->shear, sizeof pair->shear, "%s", (*shear)->name);
    }
  return true;
}

static bool acts_per_cycle(const struct nb_stage *stage) {
  return stage->damping.global_kind >= NB_GLOBAL_CON1_CS79 || stage->boundary.strain.per_cycle ||
         stage->affine.strain.per_cycle || stage->cell.per_cycle || stage->box.per_cycle || stage->servo.per_cycle;
}

/* The number of phases. Slightly different steps are possible only if no duration, strain or damping depends on a number
 * of cycles. */
static size_t phase_count(const struct nb_scene *scene) {
  if (scene->impact.line)
    return NB_PHASES;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    if (scene->stages[s].condition_count == 0 || acts_per_cycle(&scene->stages[s]))
      return 1;
  return NB_PHASES;
}

/* The quantity of the caller, or that of the page's first expectation of one value. */
static enum nb_status find_quantity(struct nb_advice *advice, struct nb_error *error) {
  const struct nb_page_run *run = &advice->page.runs[0];
  const char *quantity = advice->query->quantity;
  for (size_t k = 0; k < run->expectations.count && !quantity; k++)
    if (run->expectations.list[k].kind != NB_VERSUS)
      quantity = run->expectations.list[k].measure.label;
  if (!quantity)
    return nb_error_set(
        error, NB_BAD_USE,
        "the page has no expectation of a single value: name a quantity that it records, by --quantity");
  struct nb_expectation wanted;
  snprintf(advice->text, sizeof advice->text, "%s within %s", quantity, advice->query->within);
  if (nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &advice->page.mistakes))
    return advice->page.status = NB_BAD_USE, nb_error_set(error, NB_BAD_USE, "see above");
  advice->tolerance = wanted.tolerance, advice->unit = wanted.measure.unit;
  if (advice->tolerance.kind == NB_OF_PEAK || advice->tolerance.kind == NB_OF_MEASURE)
    return nb_error_set(error, NB_BAD_USE, "expected a tolerance like `1 %%`, or a number in the unit of the quantity");
  if (!(advice->tolerance.value > 0))
    return nb_error_set(error, NB_BAD_USE, "expected a tolerance above 0");
  return NB_OK;
}

static enum nb_status check_page(const struct nb_advice *advice, struct nb_error *error) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  if (scene->particle_count > PARTICLES_MAX)
    return nb_error_set(error, NB_BAD_USE,
                        "expected a page of at most %d particles, found %zu: the motion of many particles is chaotic, "
                        "so the results of one run have no limit for a step towards zero",
                        PARTICLES_MAX, scene->particle_count);
  if (NB_FIND(scene->bindings, scene->binding_count, "refine") >= 0)
    return nb_error_set(error, NB_BAD_USE, "the page has a value `refine`, which hides --set refine=R: rename it");
  return NB_OK;
}

enum nb_status nb_advise(struct nb_advice *advice, const struct nb_advise_query *query, struct nb_error *error) {
  *advice = (struct nb_advice){.query = query, .chosen = -1, .began = nb_clock()};
  if (nb_outcome_read(&advice->page, query->path, query->settings))
    return nb_error_set(error, advice->page.status, "%s", advice->page.error.text);
  if (check_page(advice, error) || find_quantity(advice, error))
    return error->status;
  advice->runs = advice->page.run_count;
  advice->phases = phase_count(&advice->page.runs[0].scene);
  advice->allowed = calloc(advice->runs, sizeof *advice->allowed);
  if (!advice->allowed || !list_pairs(advice))
    return nb_error_memory(error);
  enum nb_status status = find_anchor(advice, error);
  if (!status) {
    run_phases(advice, &advice->pairs[0], 0, 1);
    search(advice);
  }
  return advice->no_memory ? nb_error_memory(error) : status;
}

bool nb_advice_run(struct nb_advice *advice, size_t pair, int level, size_t phase) {
  return run_phase(advice, &advice->pairs[pair], level, phase);
}

void nb_advice_free(struct nb_advice *advice) {
  for (size_t k = 0; k < advice->pair_count && advice->pairs; k++)
    for (size_t l = 0; l < NB_LEVELS; l++)
      free(advice->pairs[k].points[l].values);
  free(advice->pairs), free(advice->settings), free(advice->allowed);
  nb_outcome_free(&advice->page);
}
