/* Advice: the cheapest setting with which the error of one quantity is within a tolerance, found by running the page.
 *
 * An error is the difference of a result from the limit that the page, with its own laws and values, approaches when
 * the step goes to zero. The anchor of estimate.c approximates this limit. The reference solution of the page is not
 * used, because for a variant with other laws it would return another solution. A setting consists of a variant and a
 * level. A variant is the page with other laws, softer contacts, centred dashpots or other values of the names in its
 * `trade` statements. At a level the variant is run with its step divided by 2^level (advise.h). Each setting is run in
 * several trials (trials.c).
 *
 * The estimated error of a setting needs the results at its level, at the next two finer levels, and an anchor that is
 * at least two levels finer. Levels are tried from the coarsest one on; the first level within the tolerance is the
 * cheapest of its variant. A variant is left out if the page or its reference solution refuses it, if it gives the
 * values of another variant, or if its values differ from the anchor by more than twice the tolerance. Softer contacts
 * that give the values of another variant are kept, because they allow a longer step. For this comparison of values one
 * trial of the variant is run, at the level that was found for the page's own laws and values. If the variant cannot be
 * run at this level, the trial is run at the first finer level at which it can.
 *
 * With realizations only the error of their mean is estimated. The anchor is then the page with half its step, and no
 * setting has a shorter step than the page. No variant is left out because its values are equal to others or too far
 * from the anchor. The guaranteed stable step differs between realizations, so a setting is left out if the stability
 * check could abort a realization that was not run. This is the case if
 *
 *   s + t d (1 + 1/m)^(1/2) > 1
 *
 * Each realization has a largest ratio of the step to the stable step. s is the mean and d the standard deviation of
 * this ratio over the m realizations. t is the quantile of Student's distribution for one realization in a thousand.
 * For the page's own laws, values and step this is not required.
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
#include "student.h"

enum { PARTICLES_MAX = 50 };
static const double anchor_fraction = 0.5; /* largest uncertainty of the anchor, as a fraction of the tolerance */
static const double variant_distance = 2;  /* largest distance of a variant from the anchor, over the tolerance */
static const double confidence = 0.95;     /* confidence level of a mean over realizations */
/* two-sided confidence level that a further realization is not aborted: at most one in a thousand is */
static const double run_confidence = 0.998;
static const double softer[] = {10, 100, 1000};
/* numbers of updates that differ by less than this fraction are nearly equal */
static const double equal_fraction = 0.1;

/* Runs `count` of the trials, evenly spaced. */
static bool run_trials(struct nb_advice *advice, struct nb_variant *variant, int level, size_t count) {
  return level <= NB_LEVEL_HIGH && nb_trials_run(advice, variant, level, 0, advice->trials / count, count);
}

/* ---- the anchor and the estimated error ---- */

static bool is_mean(const struct nb_advice *advice) { return advice->query->over != NULL; }

static size_t anchor_trials(const struct nb_advice *advice) {
  return is_mean(advice) ? advice->trials : advice->trials > 1 ? 2 : 1;
}

static bool run_anchor(struct nb_advice *advice, int level) {
  return run_trials(advice, &advice->variants[0], level - 1, anchor_trials(advice)) &&
         run_trials(advice, &advice->variants[0], level, anchor_trials(advice));
}

/* The estimated error of the mean over realizations at `point`. *difference receives the difference between this mean
 * and the mean at the anchor. */
static double error_of_mean(double *difference, const struct nb_advice *advice, const struct nb_point *point,
                            size_t run) {
  const struct nb_point *fine = &advice->variants[0].points[advice->anchor - NB_LEVEL_LOW];
  return nb_estimate_mean(difference, point->values + run * NB_TRIALS, fine->values + run * NB_TRIALS, advice->trials,
                          student_quantile((double)advice->trials, confidence));
}

static struct nb_anchor anchor_of(const struct nb_advice *advice, int level, size_t run) {
  const size_t count = anchor_trials(advice), stride = advice->trials / count;
  const struct nb_point *fine = &advice->variants[0].points[level - NB_LEVEL_LOW], *coarse = fine - 1;
  double at[NB_TRIALS], at_double_step[NB_TRIALS];
  for (size_t k = 0; k < count; k++) {
    at[k] = fine->values[run * NB_TRIALS + k * stride];
    at_double_step[k] = coarse->values[run * NB_TRIALS + k * stride];
  }
  struct nb_anchor anchor = nb_estimate_anchor(at, at_double_step, count);
  if (is_mean(advice))
    anchor.uncertainty = error_of_mean(&(double){0}, advice, coarse, run);
  return anchor;
}

/* Sets the tolerance of each run from the anchor at this level. Returns the largest ratio of the anchor's uncertainty
 * to the tolerance of the run; *worst receives the run with this ratio. */
static double anchor_ratio(struct nb_advice *advice, int level, size_t *worst) {
  double largest = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    const struct nb_anchor anchor = anchor_of(advice, level, r);
    advice->allowed[r] = advice->tolerance.value * (advice->tolerance.kind == NB_ABSOLUTE ? 1 : fabs(anchor.value));
    /* NaN (0/0) if the value and its uncertainty are 0, because a percentage of 0 allows no error */
    const double ratio = anchor.uncertainty / advice->allowed[r];
    if (!isnan(largest) && !(ratio <= largest))
      largest = ratio, *worst = r;
  }
  return largest;
}

/* Refuses the query, because the value is known only to within `ratio` times the tolerance. */
static enum nb_status refuse(const struct nb_advice *advice, double ratio, size_t worst, struct nb_error *error) {
  const char *label = advice->page.runs[worst].label, *in_run = label[0] ? ", in run " : "";
  if (is_mean(advice))
    return nb_error_set(
        error, NB_FAILED,
        "`%s`: the mean over %zu realizations is not known well enough: the mean with half the step differs from it by "
        "up to %.2g times the tolerance%s%s. Choose more --realizations, at most %d, or a larger tolerance",
        advice->text, advice->trials, ratio, in_run, label, NB_TRIALS);
  char reason[2 * NB_NAME_SIZE];
  if (isnan(ratio))
    snprintf(reason, sizeof reason, "the value is 0, and a percentage of 0 allows no error");
  else
    snprintf(reason, sizeof reason, "with the step divided by %g its uncertainty is %.2g times the tolerance",
             exp2(advice->anchor - 1), ratio);
  return nb_error_set(error, NB_FAILED,
                      "`%s`: the value is not known well enough: %s%s%s. Choose a larger tolerance, an absolute "
                      "tolerance if the value is near 0, or a larger --budget",
                      advice->text, reason, in_run, label);
}

static enum nb_status find_anchor(struct nb_advice *advice, struct nb_error *error) {
  size_t worst = 0;
  double ratio = 0;
  const int highest = is_mean(advice) ? 1 : NB_LEVEL_HIGH;
  for (advice->anchor = 1; advice->anchor <= highest && run_anchor(advice, advice->anchor); advice->anchor++)
    if ((ratio = anchor_ratio(advice, advice->anchor, &worst)) <= (is_mean(advice) ? 1 : anchor_fraction))
      return NB_OK;
  const struct nb_point *first = &advice->variants[0].points[-NB_LEVEL_LOW];
  if (advice->anchor > 1)
    return refuse(advice, ratio, worst, error);
  return nb_error_set(error, NB_FAILED, "the page cannot be run with its own step and with half of it: %.400s",
                      first[0].reason[0]   ? first[0].reason
                      : first[1].reason[0] ? first[1].reason
                                           : "the budget is too small; choose a larger --budget");
}

/* True if the stability check is unlikely to stop a realization that the search has not run; otherwise point->reason
 * has the reason. The page as it is needs no such margin. */
static bool keeps_margin(const struct nb_advice *advice, const struct nb_variant *variant, int level) {
  struct nb_point *point = (struct nb_point *)&variant->points[level - NB_LEVEL_LOW];
  const double m = (double)advice->trials, mean = nb_estimate_average(point->stability, advice->trials);
  const double margin =
      student_quantile(m, run_confidence) * nb_estimate_scatter(point->stability, advice->trials) * sqrt(1 + 1 / m);
  if ((variant == advice->variants && level >= 0) || mean + margin <= 1)
    return true;
  snprintf(point->reason, sizeof point->reason,
           "its step is %.2g of the guaranteed stable step in the mean, and this ratio scatters between realizations: "
           "another realization may be aborted",
           mean);
  return false;
}

/* Runs the trials that the estimated error of a setting needs. False: the error cannot be estimated. */
static bool run_setting(struct nb_advice *advice, struct nb_variant *variant, int level) {
  if (is_mean(advice))
    return run_trials(advice, variant, level, advice->trials) && keeps_margin(advice, variant, level);
  for (int k = 0; k < 3; k++)
    if (!run_trials(advice, variant, level + k, advice->trials))
      return false;
  return run_anchor(advice, level + 2 > advice->anchor ? level + 2 : advice->anchor);
}

/* The estimated error of a run of the page. *step receives the part that is due to the step; for a mean over
 * realizations, the difference of the means. */
static double error_of(double *step, const struct nb_advice *advice, const struct nb_point *point, int level,
                       size_t run) {
  if (is_mean(advice))
    return error_of_mean(step, advice, point, run);
  return nb_estimate_error(step, point[0].values + run * NB_TRIALS, point[1].values + run * NB_TRIALS,
                           point[2].values + run * NB_TRIALS, advice->trials, nb_level_ratios(advice, level),
                           anchor_of(advice, level + 2 > advice->anchor ? level + 2 : advice->anchor, run));
}

/* Adds variant number `index` at this level to the list of settings, with its estimated error. False: the error cannot
 * be estimated. */
static bool add_setting(struct nb_advice *advice, size_t index, int level) {
  struct nb_setting setting = {.variant = index, .level = level};
  if (!run_setting(advice, &advice->variants[index], level))
    return false;
  for (size_t r = 0; r < advice->runs; r++) {
    double step;
    const double estimated = error_of(&step, advice, nb_point_at(advice, &setting), level, r);
    const double ratio = estimated / advice->allowed[r];
    if (!(ratio <= setting.ratio))
      setting.ratio = ratio, setting.step_ratio = step / advice->allowed[r], setting.worst = r;
  }
  struct nb_setting *added = NB_ARRAY_APPEND(advice->settings, advice->setting_count);
  if (!added)
    return nb_advice_no_memory(advice);
  *added = setting;
  return true;
}

/* ---- the search ---- */

bool nb_setting_cheaper(const struct nb_advice *advice, const struct nb_setting *a, const struct nb_setting *b) {
  const double updates = nb_point_at(advice, a)->updates, others = nb_point_at(advice, b)->updates;
  const struct nb_variant *one = &advice->variants[a->variant], *other = &advice->variants[b->variant];
  if (fabs(updates - others) > equal_fraction * others)
    return updates < others;
  return one->soften != other->soften ? one->soften < other->soften : one->history < other->history;
}

/* Notes why a variant has no result: it cannot be run even at the highest level, or the budget was used up before. */
static void leave_out(const struct nb_advice *advice, struct nb_variant *variant, int highest) {
  variant->too_late = advice->exhausted;
  snprintf(variant->reason, sizeof variant->reason, "%s",
           variant->too_late ? "the budget was used up" : variant->points[highest - NB_LEVEL_LOW].reason);
}

/* Tries the levels of a variant from the coarsest one on, up to the first level within the tolerance. The search also
 * stops when the next level, which usually has twice the updates, would have more updates than the chosen setting. A
 * level with nearly as many updates is still tried, because the laws of the variant may store less per contact. */
static void search_levels(struct nb_advice *advice, size_t index, int highest) {
  struct nb_variant *variant = &advice->variants[index];
  const size_t before = advice->setting_count;
  for (int level = NB_LEVEL_LOW; level <= highest && !advice->exhausted; level++) {
    if (!add_setting(advice, index, level))
      continue;
    const struct nb_setting *last = &advice->settings[advice->setting_count - 1];
    const struct nb_setting *chosen = advice->chosen < 0 ? NULL : &advice->settings[advice->chosen];
    if (last->ratio <= 1 && (!chosen || nb_setting_cheaper(advice, last, chosen)))
      advice->chosen = (int)advice->setting_count - 1;
    if (last->ratio <= 1 ||
        (chosen && nb_level_ratios(advice, level).first * (1 - equal_fraction) * nb_point_at(advice, last)->updates >
                       nb_point_at(advice, chosen)->updates))
      return;
  }
  if (advice->setting_count == before)
    leave_out(advice, variant, highest);
}

/* The first variant before this one that gives the same values at this level, to the last bit and in each run. Two
 * variants are equal if the scene does not use the property in which they differ. NULL: there is none. */
static const struct nb_variant *equal_variant(const struct nb_advice *advice, const struct nb_variant *variant,
                                              int level) {
  const struct nb_point *point = &variant->points[level - NB_LEVEL_LOW];
  for (const struct nb_variant *other = advice->variants; other < variant; other++) {
    const struct nb_point *before = &other->points[level - NB_LEVEL_LOW];
    bool same = before->done & 1;
    for (size_t r = 0; r < advice->runs && same; r++)
      same = point->values[r * NB_TRIALS] == before->values[r * NB_TRIALS];
    if (same)
      return other;
  }
  return NULL;
}

/* True if the variant is near enough to the anchor to be tried. One trial is run at this level, or at the first finer
 * level at which the variant can be run. False: variant->reason has the reason. With realizations every variant that
 * can be run counts as near. The mean is known only after all trials, and the values of a single trial, such as numbers
 * of contacts, can be equal by chance. Softer contacts that change nothing are not left out, because they allow a
 * longer step. */
static bool is_near(struct nb_advice *advice, struct nb_variant *variant, int level, int highest) {
  while (!nb_trials_run(advice, variant, level, 0, 1, 1) && level < highest && !advice->exhausted)
    level++;
  const struct nb_point *point = &variant->points[level - NB_LEVEL_LOW];
  if (!point->done) {
    leave_out(advice, variant, highest);
    return false;
  }
  const struct nb_variant *other =
      is_mean(advice) || variant->soften > 0 ? NULL : equal_variant(advice, variant, level);
  if (other) {
    snprintf(variant->reason, sizeof variant->reason, "it gives the same values as %s",
             other == advice->variants ? "the page" : "a variant before it");
    variant->equal = true;
    return false;
  }
  size_t worst = 0;
  double largest = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    const double error = fabs(point->values[r * NB_TRIALS] - anchor_of(advice, advice->anchor, r).value);
    if (error > largest * advice->allowed[r])
      largest = error / advice->allowed[r], worst = r;
  }
  if (largest <= variant_distance || is_mean(advice))
    return true;
  const char *label = advice->page.runs[worst].label;
  variant->distance = largest;
  snprintf(variant->reason, sizeof variant->reason,
           "its value differs from that of the page by %.2g times the tolerance%s%s", largest,
           label[0] ? ", in run " : "", label);
  return false;
}

static void search(struct nb_advice *advice) {
  const int highest = is_mean(advice) ? 0 : advice->anchor;
  search_levels(advice, 0, highest);
  const int own = advice->chosen < 0 ? highest : advice->settings[advice->chosen].level;
  for (size_t k = 1; k < advice->variant_count; k++)
    if (is_near(advice, &advice->variants[k], own, highest))
      search_levels(advice, k, highest);
}

/* ---- the page ---- */

static bool trades_laws(const struct nb_advice *advice) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  if (scene->trade_laws != NB_TRADE_LAWS_DEFAULT)
    return scene->trade_laws == NB_TRADE_LAWS_ALL;
  return !is_mean(advice) && NB_FIND(scene->bindings, scene->binding_count, "normal") < 0 &&
         NB_FIND(scene->bindings, scene->binding_count, "shear") < 0; /* the page does not sweep its laws */
}

/* Adds a variant, a copy of variant number `of`. NULL: there are too many. */
static struct nb_variant *copy_variant(struct nb_advice *advice, size_t of) {
  if (advice->variant_count == NB_VARIANTS_MAX)
    return NULL;
  struct nb_variant *variant = &advice->variants[advice->variant_count++];
  *variant = advice->variants[of];
  return variant;
}

/* Adds the page with each other pair of laws. False: there are too many. */
static bool list_laws(struct nb_advice *advice) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  for (const struct nb_law *const *normal = nb_laws(); *normal; normal++)
    for (const struct nb_law *const *shear = nb_laws(); *shear; shear++) {
      if (strcmp((*normal)->kind, "normal") != 0 || strcmp((*shear)->kind, "shear") != 0 ||
          (strcmp((*normal)->name, scene->normal) == 0 && strcmp((*shear)->name, scene->shear) == 0))
        continue;
      struct nb_variant *variant = copy_variant(advice, 0);
      if (!variant)
        return false;
      snprintf(variant->normal, sizeof variant->normal, "%s", (*normal)->name);
      snprintf(variant->shear, sizeof variant->shear, "%s", (*shear)->name);
    }
  return true;
}

/* Number of doubles that the laws of a variant store per contact. */
static int history_of(const struct nb_scene *scene, const struct nb_variant *variant) {
  const bool own = !variant->normal[0];
  const struct nb_law *normal = nb_law_find("normal", own ? scene->normal : variant->normal);
  const struct nb_law *shear = nb_law_find("shear", own ? scene->shear : variant->shear);
  const struct nb_pair pair = {.pieces = nb_law_pieces(shear, scene->pieces)};
  return nb_law_history(normal, pair) + nb_law_history(shear, pair);
}

/* Adds a copy of every variant so far for each value of a `trade`. False: there are too many. */
static bool list_values(struct nb_advice *advice, size_t trade) {
  const size_t before = advice->variant_count;
  for (size_t value = 1; value <= advice->page.runs[0].scene.trades[trade].count; value++)
    for (size_t of = 0; of < before; of++) {
      struct nb_variant *variant = copy_variant(advice, of);
      if (!variant)
        return false;
      variant->value[trade] = value;
    }
  return true;
}

/* True if the page has dashpots and, in the stages with dashpots, neither `damping centred` nor `damping late`. Such
 * dashpots use the velocity of half a step before. A `damping none` of another stage sets the time of its velocity, too. */
static bool has_late_dashpots(const struct nb_advice *advice) {
  bool dashpots = false, timing = false;
  for (size_t r = 0; r < advice->runs; r++)
    for (size_t s = 0; s < advice->page.runs[r].scene.stage_count; s++) {
      const struct nb_damping *damping = &advice->page.runs[r].scene.stages[s].damping;
      const bool damped = nb_damping_contact_line(damping) > 0;
      dashpots = dashpots || damped, timing = timing || (damped && damping->centred_line);
    }
  return dashpots && !timing;
}

bool nb_advice_softness_is_useless(const struct nb_advice *advice) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  bool per_collision = !is_mean(advice) && scene->impact.line;
  for (size_t s = 0; s < scene->stage_count; s++)
    per_collision = per_collision && scene->stages[s].step.kind == NB_STEP_COLLISION;
  return per_collision;
}

static bool trades_softness(const struct nb_advice *advice) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  return !scene->contact_test && scene->start.stages == 0 && !nb_advice_softness_is_useless(advice);
}

/* Adds the variants that keep the page's laws: softer contacts and centred dashpots, where they can make the run
 * cheaper. */
static void list_own_laws(struct nb_advice *advice) {
  for (size_t k = 0; k < sizeof softer / sizeof *softer && trades_softness(advice); k++)
    copy_variant(advice, 0)->soften = softer[k];
  if (has_late_dashpots(advice))
    copy_variant(advice, 0)->centred = true;
}

/* Lists the variants. The first one is the page as it is. If the laws may change, the list also has the page with each
 * other pair of laws. Without realizations it then also has the page with softer contacts and with centred dashpots,
 * where they can make the run cheaper. Each of these is listed with all combinations of the values in `trade`
 * statements. */
static enum nb_status list_variants(struct nb_advice *advice, struct nb_error *error) {
  const size_t trades = advice->page.runs[0].scene.trade_count;
  advice->variant_count = 1;
  if (trades_laws(advice) && !is_mean(advice))
    list_own_laws(advice);
  bool few = trades <= NB_TRADES && (!trades_laws(advice) || list_laws(advice));
  for (size_t k = 0; k < trades && few; k++)
    few = list_values(advice, k);
  for (size_t k = 0; k < advice->variant_count; k++)
    advice->variants[k].history = history_of(&advice->page.runs[0].scene, &advice->variants[k]);
  if (few)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE, "expected at most %d statements `trade` and %d combinations of their values",
                      NB_TRADES, NB_VARIANTS_MAX);
}

/* Finds the quantity: the caller's, or the one of the first expectation of the page that has a single value. Reads the
 * tolerance. */
static enum nb_status find_quantity(struct nb_advice *advice, struct nb_error *error) {
  const struct nb_page_run *run = &advice->page.runs[0];
  const char *quantity = advice->query->quantity;
  for (size_t k = 0; k < run->expectations.count && !quantity; k++)
    if (run->expectations.list[k].kind != NB_VERSUS && run->expectations.list[k].kind != NB_REPORTED)
      quantity = run->expectations.list[k].measure.label;
  if (!quantity)
    return nb_error_set(
        error, NB_BAD_USE,
        "the page has no expectation of a single value: name a quantity that it records, by --quantity");
  struct nb_expectation wanted;
  snprintf(advice->text, sizeof advice->text, "%s within %s", quantity, advice->query->within);
  if (nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &advice->page.mistakes))
    return advice->page.status = error->status = NB_BAD_USE; /* page.mistakes has the message */
  advice->tolerance = wanted.tolerance, advice->unit = wanted.measure.unit;
  if (advice->tolerance.kind == NB_OF_PEAK || advice->tolerance.kind == NB_OF_MEASURE)
    return nb_error_set(error, NB_BAD_USE, "expected a tolerance like `1 %%`, or a number in the unit of the quantity");
  if (!(advice->tolerance.value > 0))
    return nb_error_set(error, NB_BAD_USE, "expected a tolerance above 0");
  return NB_OK;
}

static enum nb_status check_page(const struct nb_advice *advice, struct nb_error *error) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  if (scene->particle_count > PARTICLES_MAX && !is_mean(advice))
    return nb_error_set(
        error, NB_BAD_USE,
        "expected a page of at most %d particles, found %zu: the motion of many particles is chaotic, so the results "
        "of one run have no limit for a step towards zero. A mean over realizations has such a limit: name the seed "
        "of the random packing, `let seed = 1` and `seed $seed`, and add `--over seed`",
        PARTICLES_MAX, scene->particle_count);
  if (NB_FIND(scene->bindings, scene->binding_count, "refine") >= 0)
    return nb_error_set(error, NB_BAD_USE,
                        "the page has a value named `refine`, which hides --set refine=R: rename this value");
  return NB_OK;
}

static unsigned long common_divisor(unsigned long a, unsigned long b) { return b ? common_divisor(b, a % b) : a; }

/* Finds the greatest common divisor of all numbers of cycles that the page gives, as lengths of stages and in
 * expectations. */
static void find_divisor(struct nb_advice *advice) {
  for (size_t r = 0; r < advice->runs; r++) {
    const struct nb_page_run *run = &advice->page.runs[r];
    for (size_t s = run->scene.start.stages; s < run->scene.stage_count; s++)
      if (run->scene.stages[s].condition_count == 0)
        advice->divisor = common_divisor(run->scene.stages[s].cycles, advice->divisor);
    for (size_t k = 0; k < run->expectations.count; k++)
      if (run->expectations.list[k].measure.reducer == NB_AT_CYCLE)
        advice->divisor = common_divisor((unsigned long)run->expectations.list[k].measure.at, advice->divisor);
  }
}

double nb_level_refine(const struct nb_advice *advice, int level) {
  const double wanted = exp2(level), divisor = (double)advice->divisor;
  return advice->divisor ? ceil(divisor * wanted) / divisor : wanted;
}

struct nb_ratios nb_level_ratios(const struct nb_advice *advice, int level) {
  const double next = nb_level_refine(advice, level + 1);
  return (struct nb_ratios){next / nb_level_refine(advice, level), nb_level_refine(advice, level + 2) / next};
}

/* Reports a name after --over that the page does not define. Without this function the message would call it a name
 * after --set. `count`: the index of its setting. */
static enum nb_status over_mistake(struct nb_advice *advice, size_t count, struct nb_error *error) {
  const char *const over = advice->query->over;
  struct nb_outcome without;
  char hint[NB_HINT_SIZE];
  advice->page_settings[count] = NULL;
  if (!nb_outcome_read(&without, advice->query->path, advice->page_settings)) {
    const struct nb_scene *const scene = &without.runs[0].scene;
    const char *const near = NB_NEAREST(hint, over, scene->bindings, scene->binding_count);
    if (NB_FIND(scene->bindings, scene->binding_count, over) < 0) {
      nb_outcome_free(&advice->page);
      nb_error_set(error, NB_BAD_USE,
                   "expected after --over a name that the page defines by `let` or `sweep`, found `%s`%s%s", over,
                   near ? "; " : "", near ? near : "");
    }
  }
  nb_outcome_free(&without);
  return error->status;
}

/* Reads the page, with the first realization. */
static enum nb_status read_page(struct nb_advice *advice, struct nb_error *error) {
  const struct nb_advise_query *query = advice->query;
  const size_t length = query->over ? strlen(query->over) : 0;
  size_t count = 0;
  for (; query->settings[count]; count++)
    if (query->over && strncmp(query->settings[count], query->over, length) == 0 &&
        query->settings[count][length] == '=')
      return nb_error_set(error, NB_BAD_USE, "--over %s and --set %s exclude each other: remove one of the two",
                          query->over, query->settings[count]);
  advice->page_settings = calloc(count + 2, sizeof *advice->page_settings);
  advice->variants = calloc(NB_VARIANTS_MAX, sizeof *advice->variants);
  if (!advice->page_settings || !advice->variants)
    return nb_error_memory(error);
  memcpy(advice->page_settings, query->settings, count * sizeof *advice->page_settings);
  if (query->over) {
    snprintf(advice->first_realization, sizeof advice->first_realization, "%s=1", query->over);
    advice->page_settings[count] = advice->first_realization;
  }
  if (nb_outcome_read(&advice->page, query->path, advice->page_settings))
    return query->over && over_mistake(advice, count, error)
               ? error->status
               : nb_error_set(error, advice->page.status, "%s", advice->page.error.text);
  advice->runs = advice->page.run_count;
  advice->trials = query->over ? query->realizations : nb_phase_count(&advice->page.runs[0].scene);
  advice->allowed = calloc(advice->runs, sizeof *advice->allowed);
  find_divisor(advice);
  return advice->allowed ? NB_OK : nb_error_memory(error);
}

enum nb_status nb_advise(struct nb_advice *advice, const struct nb_advise_query *query, struct nb_error *error) {
  *advice = (struct nb_advice){.query = query, .chosen = -1, .began = nb_clock()};
  if (read_page(advice, error) || check_page(advice, error) || find_quantity(advice, error) ||
      list_variants(advice, error))
    return error->status;
  enum nb_status status = find_anchor(advice, error);
  if (!status)
    search(advice);
  return advice->no_memory ? nb_error_memory(error) : status;
}

/* ---- text about the result ---- */

const struct nb_setting *nb_advice_cheaper(const struct nb_advice *advice, const struct nb_setting *setting) {
  const struct nb_setting *found = NULL;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const struct nb_setting *other = &advice->settings[k];
    const double updates = nb_point_at(advice, other)->updates;
    if (other->ratio > 1 && updates < nb_point_at(advice, setting)->updates &&
        (!found || updates > nb_point_at(advice, found)->updates ||
         (updates == nb_point_at(advice, found)->updates && other->ratio < found->ratio)))
      found = other;
  }
  return found;
}

const struct nb_setting *nb_advice_most_accurate(const struct nb_advice *advice) {
  const struct nb_setting *found = NULL;
  for (size_t k = 0; k < advice->setting_count; k++)
    if (!found || advice->settings[k].ratio < found->ratio)
      found = &advice->settings[k];
  return found;
}

double nb_advice_scatter(const struct nb_advice *advice, const struct nb_setting *setting) {
  double largest = 0;
  for (size_t r = 0; r < advice->runs; r++)
    largest = fmax(largest, nb_estimate_scatter(nb_point_at(advice, setting)->values + r * NB_TRIALS, advice->trials));
  return largest;
}

void nb_refine_text(char *text, size_t size, double refine) {
  if (refine == 1)
    snprintf(text, size, "that of the page");
  else
    snprintf(text, size, "%.3g times as %s as that of the page", refine < 1 ? 1 / refine : refine,
             refine < 1 ? "long" : "short");
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

void nb_times_text(char *text, size_t size, double times[], size_t count) {
  qsort(times, count, sizeof *times, ascending);
  snprintf(text, size, "%.3g s (%.3g to %.3g)", times[count / 2], times[0], times[count - 1]);
}

const char *nb_advice_remedy(const struct nb_advice *advice) {
  return advice->exhausted ? "the budget was used up: choose a larger --budget or a larger tolerance"
                           : "choose a larger tolerance";
}

struct nb_left_out nb_advice_left_out(const struct nb_advice *advice) {
  struct nb_left_out out = {.nearest = NULL};
  for (size_t k = 1; k < advice->variant_count; k++) {
    const struct nb_variant *variant = &advice->variants[k];
    out.equal += variant->equal, out.too_late += variant->too_late, out.farther += variant->distance > 0;
    out.refused += variant->reason[0] && !variant->equal && !variant->too_late && !(variant->distance > 0);
    if (variant->distance > 0 && (!out.nearest || variant->distance < out.nearest->distance))
      out.nearest = variant;
  }
  return out;
}

void nb_advice_free(struct nb_advice *advice) {
  for (size_t k = 0; k < advice->variant_count && advice->variants; k++)
    for (size_t l = 0; l < NB_LEVELS; l++)
      free(advice->variants[k].points[l].values);
  free(advice->variants), free(advice->settings), free(advice->allowed), free(advice->page_settings);
  nb_outcome_free(&advice->page);
}
