/* Calibration of `nineball advise`, run by `make accuracy`: how often the true error of the advice is within the tolerance.
 *
 * accuracy [-o DOCUMENT ROWS] PAGE… [--means PAGE…]  draws a quantity, a condition and a tolerance for each page several times, asks for advice, and computes the
 * true error: the largest difference, over all phases and runs, from the limit of the page for a small step. It prints one
 * row for each draw, then writes docs/ACCURACY.md and the rows of its table of errors to the files that -o names. Pages after
 * --means are assemblies; their draws are about means over realizations. Draws depend on the name of the page and the number of
 * the draw only.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/clock.h"
#include "../src/core/model.h"
#include "../src/input/hash.h"
#include "../src/input/reader.h"
#include "../src/measure/step.h"
#include "../src/report/advise.h"

enum { DRAWS = 4, KINDS = 16, TRUTH_FIRST = 5, DRAWS_MAX = 4000, SETTINGS_MAX = 64, FINEST = 4 };
static const double budget = 20, lowest_tolerance = 1e-5, highest_tolerance = 0.3;
static const double truth_share = 0.05; /* of the tolerance: largest change of the truth when its step is halved */

/* What is chosen instead by an estimator that lacks something; the first one is the whole estimator. */
enum control { WHOLE, ONE_PHASE, NO_ANCHOR, TWO_STEPS, OWN_REFERENCE, ALWAYS_FINE, CONTROLS };
static const char *const control_names[] = {"the whole estimator",
                                            "one phase",
                                            "no anchor",
                                            "difference of two steps",
                                            "the reference of each candidate, without shear forces first",
                                            "always a sixteenth of the page's step"};

struct draw {
  char kind[64];
  bool answered, met;       /* there is advice; some setting that was tried has a true error within the tolerance */
  double kept[CONTROLS];    /* true error over the tolerance of what is chosen; NAN: nothing */
  double cost_of[CONTROLS]; /* as `cost` */
  double claim_over_true;   /* of the advice */
  double cost;    /* updates of the advice over those of the cheapest setting that is truly within the tolerance */
  double seconds; /* of the search */
};
static struct draw draws[DRAWS_MAX];
static size_t draw_count, unresolved;

/* ---- random numbers ---- */

static gsl_rng *generator;
static double uniform(void) { return gsl_rng_uniform(generator); }
static size_t below(size_t count) { return gsl_rng_uniform_int(generator, count); }

/* ---- the truth ---- */

static const struct nb_point *point_of(const struct nb_advice *advice, size_t pair, int level) {
  return &advice->variants[pair].points[level - NB_LEVEL_LOW];
}

/* The limit for a small step, for each run; false: it is not known well enough. */
static bool find_truth(struct nb_advice *advice, double *truth, double share) {
  for (int level = TRUTH_FIRST; level <= NB_LEVEL_HIGH; level++) {
    bool enough = nb_advice_run(advice, 0, level - 1, 0) && nb_advice_run(advice, 0, level, 0);
    if (!enough)
      return false;
    for (size_t r = 0; r < advice->runs; r++) {
      truth[r] = point_of(advice, 0, level)->values[r * NB_TRIALS];
      enough = enough && fabs(truth[r] - point_of(advice, 0, level - 1)->values[r * NB_TRIALS]) <=
                             share * truth_share * fabs(truth[r]);
    }
    if (enough)
      return true;
  }
  return false;
}

/* The largest error of a setting over all runs and phases, over the tolerance; NAN: it cannot be run. */
static double true_error(struct nb_advice *advice, size_t pair, int level, const double *truth, double tolerance) {
  double largest = 0;
  for (size_t phase = 0; phase < NB_PHASES; phase += NB_PHASES / advice->trials) {
    if (!nb_advice_run(advice, pair, level, phase))
      return NAN;
    for (size_t r = 0; r < advice->runs; r++)
      largest = fmax(largest, fabs(point_of(advice, pair, level)->values[r * NB_TRIALS + phase] - truth[r]) /
                                  (tolerance * fabs(truth[r])));
  }
  return largest;
}

/* ---- negative controls: estimators that lack something, on the same runs ---- */

static double claim_of(const struct nb_advice *advice, enum control control, int level, size_t r) {
  const struct nb_point *point = point_of(advice, 0, level);
  const double *n = point[0].values + r * NB_TRIALS, *n2 = point[1].values + r * NB_TRIALS,
               *n4 = point[2].values + r * NB_TRIALS;
  const int finer = level + 2 > advice->anchor ? level + 2 : advice->anchor;
  const double *fine = point_of(advice, 0, finer)->values + r * NB_TRIALS,
               *coarse = point_of(advice, 0, finer - 1)->values + r * NB_TRIALS;
  double step;
  if (control == TWO_STEPS)
    return fabs(n[0] - n2[0]);
  if (control == ONE_PHASE)
    return nb_estimate_claim(&step, n, n2, n4, 1, nb_estimate_anchor(fine, coarse, 1));
  nb_estimate_claim(&step, n, n2, n4, advice->trials, (struct nb_anchor){n[0], 0});
  return step;
}

/* The coarsest level that the control takes for good enough. */
static int choose(const struct nb_advice *advice, enum control control, int highest) {
  for (int level = NB_LEVEL_LOW; level <= highest; level++) {
    bool known = true, within = true;
    for (int k = 0; k < 3; k++)
      known = known && point_of(advice, 0, level + k)->done & 1;
    for (size_t r = 0; r < advice->runs && known; r++)
      within = within && claim_of(advice, control, level, r) <= advice->allowed[r];
    if (known && within)
      return level;
  }
  return highest;
}

/* Whether the last run of the page, with these laws and this level, agrees with its own reference. */
static bool agrees_with_reference(const struct nb_advice *advice, const struct nb_variant *variant, int level) {
  const char *settings[SETTINGS_MAX + 4];
  char texts[3][3 * NB_NAME_SIZE];
  size_t count = 0;
  while (advice->query->settings[count])
    settings[count] = advice->query->settings[count], count++;
  snprintf(texts[0], sizeof texts[0], "refine=%.17g", advice->page.runs[0].scene.refine * exp2(level));
  snprintf(texts[1], sizeof texts[1], "normal=%s", variant->normal);
  snprintf(texts[2], sizeof texts[2], "shear=%s", variant->shear);
  for (int k = 0; k < (variant->normal[0] ? 3 : 1); k++)
    settings[count++] = texts[k];
  settings[count] = NULL;
  struct nb_outcome outcome;
  const enum nb_status status = nb_outcome_make(&outcome, advice->query->path, settings, &advice->query->options, NULL);
  bool agrees = status <= NB_FAILED;
  for (size_t r = 0; r < outcome.run_count && agrees; r++) {
    struct nb_expectation wanted;
    struct nb_error error;
    double value;
    const struct nb_page_run *run = &outcome.runs[r];
    agrees = !nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &outcome.mistakes) &&
             nb_measure_value(&value, &wanted.measure, &run->result.table, &error);
    const double *solution = agrees ? nb_measure_solution(&wanted.measure, &run->solution) : NULL;
    agrees = solution && fabs(value - *solution) <= advice->tolerance.value * fabs(*solution);
  }
  nb_outcome_free(&outcome);
  return agrees;
}

/* The coarsest setting that agrees with its own reference; of each level first that without shear forces. False: none. */
static bool choose_by_reference(const struct nb_advice *advice, int highest, size_t *variant, int *level) {
  size_t none = 0;
  for (size_t k = 1; k < advice->variant_count; k++)
    if (strcmp(advice->variants[k].shear, "none") == 0 &&
        strcmp(advice->variants[k].normal, advice->page.runs[0].scene.normal) == 0)
      none = k;
  for (*level = NB_LEVEL_LOW; *level <= highest; ++*level)
    for (int own = 0; own < 2; own++) {
      *variant = own ? 0 : none;
      if (agrees_with_reference(advice, &advice->variants[*variant], *level))
        return true;
    }
  return false;
}

/* ---- the error of a step ---- */

/* Errors of quantities at one phase, by the number of steps per collision, in bins of factors of two. */
enum { BINS = 10, ERRORS_MAX = 4000 };
static const double first_bin = 2;
static double errors[BINS][ERRORS_MAX];
static size_t error_count[BINS];

/* The number of steps that the shortest collision of the run takes; infinite: unknown. */
static double steps_of(struct nb_outcome *page, size_t run) {
  struct nb_error error;
  const struct nb_options options = {.threads = 1};
  struct nb_model *model = nb_model_create(&page->runs[run].scene, &options, &error);
  const double steps = model ? nb_step_collision(model) / model->step : INFINITY;
  nb_model_free(model);
  return steps;
}

static void collect_errors(struct nb_advice *advice, const double *truth) {
  for (size_t r = 0; r < advice->runs; r++) {
    const double steps = steps_of(&advice->page, r);
    for (int level = NB_LEVEL_LOW; level < TRUTH_FIRST - 1 && isfinite(steps) && truth[r] != 0; level++) {
      const double bin = floor(log2(steps * exp2(level) / first_bin));
      if (bin < 0 || bin >= BINS || error_count[(size_t)bin] == ERRORS_MAX || !nb_advice_run(advice, 0, level, 0))
        continue;
      const double value = point_of(advice, 0, level)->values[r * NB_TRIALS];
      errors[(size_t)bin][error_count[(size_t)bin]++] = fabs(value / truth[r] - 1);
    }
  }
}

/* ---- one draw ---- */

static double measure_cost(struct draw *draw, struct nb_advice *advice, const double *truth, double tolerance) {
  double cheapest = INFINITY;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const struct nb_setting *setting = &advice->settings[k];
    if (true_error(advice, setting->variant, setting->level, truth, tolerance) <= 1)
      cheapest = fmin(cheapest, nb_point_at(advice, setting)->updates);
  }
  draw->met = isfinite(cheapest);
  if (draw->answered)
    draw->cost = draw->cost_of[WHOLE] = nb_point_at(advice, &advice->settings[advice->chosen])->updates / cheapest;
  return cheapest;
}

static void measure_errors(struct draw *draw, struct nb_advice *advice, double tolerance) {
  double *truth = calloc(advice->runs, sizeof *truth);
  const struct nb_advise_query *asked = advice->query;
  struct nb_advise_query query = *asked;
  query.budget = 1e9; /* the truth may take longer than the advice */
  advice->query = &query;
  advice->exhausted = false;
  draw->answered = advice->chosen >= 0;
  if (!find_truth(advice, truth, tolerance)) {
    unresolved++;
    draw->kind[0] = 0;
  } else {
    const double cheapest = measure_cost(draw, advice, truth, tolerance);
    collect_errors(advice, truth);
    if (draw->answered) {
      const struct nb_setting *chosen = &advice->settings[advice->chosen];
      draw->kept[WHOLE] = true_error(advice, chosen->variant, chosen->level, truth, tolerance);
      draw->claim_over_true = chosen->ratio / draw->kept[WHOLE];
      int own = advice->anchor; /* the level that the whole estimator chose for the laws of the page */
      for (size_t k = 0; k < advice->setting_count; k++)
        if (advice->settings[k].variant == 0 && advice->settings[k].ratio <= 1)
          own = advice->settings[k].level;
      for (int control = ONE_PHASE; control < CONTROLS; control++) {
        size_t variant = 0;
        int level = FINEST;
        if (control == OWN_REFERENCE && !choose_by_reference(advice, own, &variant, &level))
          continue;
        if (control < OWN_REFERENCE)
          level = choose(advice, control, own);
        draw->kept[control] = true_error(advice, variant, level, truth, tolerance);
        draw->cost_of[control] = point_of(advice, variant, level)->updates / cheapest;
      }
    }
  }
  free(truth);
  advice->query = asked;
}

/* The settings of one run of a sweep. */
static size_t fix_condition(const struct nb_page_run *run, char texts[][3 * NB_NAME_SIZE], const char *settings[]) {
  size_t count = 0;
  for (size_t k = 0; k < run->scene.binding_count && count + 1 < SETTINGS_MAX; k++)
    if (run->scene.bindings[k].sweep >= 0) {
      snprintf(texts[count], sizeof texts[count], "%s=%s", run->scene.bindings[k].name, run->scene.bindings[k].text);
      settings[count] = texts[count];
      count++;
    }
  settings[count] = NULL;
  return count;
}

/* Measures of the page that have a value other than 0. */
static size_t list_quantities(const struct nb_page_run *run, const char *quantities[], size_t most) {
  size_t count = 0;
  for (size_t k = 0; k < run->expectations.count && count < most; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    if (e->kind != NB_VERSUS && !e->measure.is_residual)
      quantities[count++] = e->measure.label;
  }
  return count;
}

static void kind_of(char kind[64], const char *path, const struct nb_scene *scene) {
  const char *slash = strrchr(path, '/'), *from = slash;
  while (from && from > path && from[-1] != '/')
    from--;
  if (scene->contact_test)
    snprintf(kind, 64, "contact test");
  else
    snprintf(kind, 64, "%.*s", slash ? (int)(slash - from) : 1, slash ? from : "-");
}

static void draw_one(const char *path, struct nb_outcome *page) {
  static char texts[SETTINGS_MAX][3 * NB_NAME_SIZE];
  const char *settings[SETTINGS_MAX + 1] = {NULL}, *quantities[256];
  const size_t count = list_quantities(&page->runs[0], quantities, sizeof quantities / sizeof *quantities);
  char within[64], label[256] = "all runs";
  if (count == 0 || draw_count == DRAWS_MAX)
    return;
  const char *quantity = quantities[below(count)];
  if (page->run_count > 1 && uniform() < 0.7) {
    const struct nb_page_run *run = &page->runs[below(page->run_count)];
    fix_condition(run, texts, settings);
    snprintf(label, sizeof label, "%s", run->label);
  }
  const double tolerance = lowest_tolerance * pow(highest_tolerance / lowest_tolerance, uniform());
  snprintf(within, sizeof within, "%.9g %%", 100 * tolerance);
  struct nb_advise_query query = {.path = path,
                                  .settings = settings,
                                  .options = {.threads = 1, .jobs = 1},
                                  .quantity = quantity,
                                  .within = within,
                                  .budget = budget};
  struct nb_advice advice;
  struct nb_error error = {0};
  struct draw *draw = &draws[draw_count];
  *draw = (struct draw){.claim_over_true = NAN, .cost = NAN};
  for (int control = 0; control < CONTROLS; control++)
    draw->kept[control] = draw->cost_of[control] = NAN;
  const enum nb_status status = nb_advise(&advice, &query, &error);
  draw->seconds = nb_clock() - advice.began;
  if (status <= NB_FAILED && advice.variants) {
    kind_of(draw->kind, path, &page->runs[0].scene);
    if (status == NB_OK)
      measure_errors(draw, &advice, tolerance);
    printf("%s\t%s\t%s\t%.3g\t%s\t%.3g\t%.3g\t%.3g\t%.3g\t%.3g\t%.3g\t%.2f\n", advice.page.page.name, quantity, label,
           tolerance, draw->answered ? "answered" : "no advice", draw->kept[WHOLE], draw->kept[ONE_PHASE],
           draw->kept[NO_ANCHOR], draw->kept[TWO_STEPS], draw->claim_over_true, draw->cost, draw->seconds);
    fflush(stdout);
    draw_count += draw->kind[0] != 0;
  }
  nb_advice_free(&advice);
}

static void draw_page(const char *path) {
  static const char *const none[] = {NULL};
  struct nb_outcome page;
  if (!nb_outcome_read(&page, path, none) && page.run_count > 0)
    for (int k = 0; k < DRAWS; k++) {
      gsl_rng_set(generator,
                  (unsigned long)nb_hash(NB_HASH_BEGIN, page.page.name, strlen(page.page.name)) + (unsigned long)k);
      draw_one(path, &page);
    }
  nb_outcome_free(&page);
}

/* ---- means over realizations ---- */

/* What is chosen from the paired differences of the realizations. */
enum mean_control { WITH_STUDENT, MEAN_ALONE, ONE_REALIZATION, MEAN_CONTROLS };
static const char *const mean_control_names[] = {"the whole estimator", "difference of the means alone",
                                                 "difference of one realization"};
enum { MEAN_DRAWS = 10, TRUTH_REALIZATIONS = 64, TRUTH_BLOCK = 1000, TRUTH_REFINE = 4 };
static const double lowest_of_mean = 0.02, highest_of_mean = 0.5;
struct mean_draw {
  char page[64];
  bool answered;
  double kept[MEAN_CONTROLS]; /* true error over the tolerance; NAN: nothing */
  double claim_over_true, cost;
};
static struct mean_draw mean_draws[DRAWS_MAX];
static size_t mean_draw_count;

/* The mean of the quantity over many realizations that the advice has not seen: block 1000. NAN: one cannot be run. */
static double mean_of(const struct nb_advice *advice, const struct nb_variant *variant, double refine) {
  const struct nb_scene *page = &advice->page.runs[0].scene;
  double sum = 0;
  bool good = true;
#pragma omp parallel for reduction(+ : sum) schedule(dynamic, 1)
  for (int k = 1; k <= TRUTH_REALIZATIONS; k++) {
    char texts[3 + NB_TRADES][3 * NB_NAME_SIZE];
    const char *settings[4 + NB_TRADES];
    struct nb_outcome outcome;
    struct nb_expectation wanted;
    struct nb_error error;
    size_t count = 0;
    double value = NAN;
    snprintf(texts[count++], sizeof *texts, "block=%d", TRUTH_BLOCK);
    snprintf(texts[count++], sizeof *texts, "seed=%d", k);
    snprintf(texts[count++], sizeof *texts, "refine=%.17g", refine);
    for (size_t t = 0; t < page->trade_count; t++)
      if (variant->value[t])
        snprintf(texts[count++], sizeof *texts, "%s=%s", page->trades[t].name,
                 page->trades[t].values[variant->value[t] - 1]);
    for (size_t t = 0; t < count; t++)
      settings[t] = texts[t];
    settings[count] = NULL;
    if (!nb_outcome_read(&outcome, advice->query->path, settings) &&
        !nb_outcome_run(&outcome, &advice->query->options, NULL) &&
        !nb_expectation_read(&wanted, "quantity", advice->text, &outcome.runs[0].scene, &outcome.mistakes))
      nb_measure_value(&value, &wanted.measure, &outcome.runs[0].result.table, &error);
    if (!isfinite(value))
#pragma omp atomic write
      good = false;
    sum += value;
    nb_outcome_free(&outcome);
  }
  return good ? sum / TRUTH_REALIZATIONS : NAN;
}

/* The cheapest setting that the control takes for good enough; -1: none. */
static int choose_mean(const struct nb_advice *advice, enum mean_control control) {
  const double *fine = point_of(advice, 0, advice->anchor)->values;
  int chosen = -1;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const struct nb_setting *setting = &advice->settings[k];
    const struct nb_point *point = nb_point_at(advice, setting);
    const double ratio = control == MEAN_ALONE
                             ? setting->step_ratio
                             : fabs(point->values[0] - fine[0]) / (advice->tolerance.value * fabs(fine[0]));
    if (ratio <= 1 && (chosen < 0 || point->updates < nb_point_at(advice, &advice->settings[chosen])->updates))
      chosen = (int)k;
  }
  return chosen;
}

static void draw_mean(const char *path, struct nb_outcome *page, int number) {
  char block[32], within[64];
  const char *settings[] = {block, NULL}, *quantities[64];
  const size_t count = list_quantities(&page->runs[0], quantities, sizeof quantities / sizeof *quantities);
  const char *quantity = quantities[below(count)];
  const double tolerance = lowest_of_mean * pow(highest_of_mean / lowest_of_mean, uniform());
  snprintf(block, sizeof block, "block=%d", number);
  snprintf(within, sizeof within, "%.9g %%", 100 * tolerance);
  const struct nb_advise_query query = {.path = path,
                                        .settings = settings,
                                        .options = {.threads = 1},
                                        .quantity = quantity,
                                        .within = within,
                                        .over = "seed",
                                        .realizations = NB_REALIZATIONS_MIN,
                                        .budget = 1e9};
  struct nb_advice advice;
  struct nb_error error = {0};
  struct mean_draw *draw = &mean_draws[mean_draw_count++];
  *draw = (struct mean_draw){.kept = {NAN, NAN, NAN}, .claim_over_true = NAN, .cost = NAN};
  snprintf(draw->page, sizeof draw->page, "%s", page->page.name);
  const enum nb_status status = nb_advise(&advice, &query, &error);
  draw->answered = status == NB_OK && advice.chosen >= 0;
  if (status == NB_OK) {
    const double truth = mean_of(&advice, &advice.variants[0], TRUTH_REFINE);
    for (int control = 0; control < MEAN_CONTROLS; control++) {
      const int chosen = control == WITH_STUDENT ? advice.chosen : choose_mean(&advice, (enum mean_control)control);
      if (chosen < 0)
        continue;
      const struct nb_setting *setting = &advice.settings[chosen];
      draw->kept[control] =
          fabs(mean_of(&advice, &advice.variants[setting->variant], exp2(setting->level)) / truth - 1) / tolerance;
      if (control == WITH_STUDENT) {
        draw->claim_over_true = setting->ratio / draw->kept[control];
        draw->cost = nb_point_at(&advice, setting)->updates / point_of(&advice, 0, 0)->updates;
      }
    }
  }
  printf("%s\t%s\tseed\t%.3g\t%s\t%.3g\t%.3g\t%.3g\t-\t%.3g\t%.3g\t-\n", draw->page, quantity, tolerance,
         draw->answered ? "answered" : "no advice", draw->kept[0], draw->kept[1], draw->kept[2], draw->claim_over_true,
         draw->cost);
  fflush(stdout);
  nb_advice_free(&advice);
}

static void draw_means(const char *path) {
  static const char *const none[] = {NULL};
  struct nb_outcome page;
  if (!nb_outcome_read(&page, path, none) && page.run_count > 0)
    for (int k = 1; k <= MEAN_DRAWS; k++) {
      gsl_rng_set(generator,
                  (unsigned long)nb_hash(NB_HASH_BEGIN, page.page.name, strlen(page.page.name)) + (unsigned long)k);
      draw_mean(path, &page, k);
    }
  nb_outcome_free(&page);
}

/* ---- docs/ACCURACY.md ---- */

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Quantile of the finite values; NAN: there are none. */
static double quantile(double *values, size_t count, double fraction) {
  size_t finite = 0;
  for (size_t k = 0; k < count; k++)
    if (isfinite(values[k]))
      values[finite++] = values[k];
  qsort(values, finite, sizeof *values, ascending);
  return finite ? values[(size_t)(fraction * (double)(finite - 1) + 0.5)] : NAN;
}

static void write_share(FILE *out, size_t part, size_t whole) {
  if (whole)
    fprintf(out, "%zu of %zu (%.0f %%)", part, whole, 100 * (double)part / (double)whole);
  else
    fputs("none", out);
}

static void write_kinds(FILE *out) {
  char kinds[KINDS][64];
  size_t kind_count = 0;
  fputs("| kind of page | draws | answered | true error within the tolerance |\n| --- | --- | --- | --- |\n", out);
  for (size_t k = 0; k <= draw_count; k++) {
    size_t same = 0;
    const char *kind = k < draw_count ? draws[k].kind : "all";
    while (same < kind_count && strcmp(kinds[same], kind) != 0)
      same++;
    if (same < kind_count || kind_count == KINDS)
      continue;
    snprintf(kinds[kind_count++], 64, "%.63s", kind);
    size_t all = 0, answered = 0, kept = 0;
    for (size_t d = 0; d < draw_count; d++)
      if (k == draw_count || strcmp(draws[d].kind, kind) == 0)
        all++, answered += draws[d].answered, kept += draws[d].kept[WHOLE] <= 1;
    fprintf(out, "| %s | %zu | ", kind, all);
    write_share(out, answered, all);
    fputs(" | ", out);
    write_share(out, kept, answered);
    fputs(" |\n", out);
  }
}

static void write_controls(FILE *out) {
  fputs("\n| what chooses the setting | true error within the tolerance | cost over that of the cheapest, median |\n"
        "| --- | --- | --- |\n",
        out);
  for (int control = 0; control < CONTROLS; control++) {
    static double cost[DRAWS_MAX];
    size_t kept = 0, count = 0;
    for (size_t d = 0; d < draw_count; d++) {
      kept += draws[d].kept[control] <= 1, count += !isnan(draws[d].kept[control]);
      cost[d] = draws[d].cost_of[control];
    }
    fprintf(out, "| %s | ", control_names[control]);
    write_share(out, kept, count);
    fprintf(out, " | %.2g |\n", quantile(cost, draw_count, 0.5));
  }
}

/* The errors by steps per collision: in the document, and for `nineball explain`. */
static void write_errors(FILE *out, FILE *header) {
  fputs("\n## The error of a step\n\n"
        "The relative errors of the quantities of all draws, at one phase, by the number of time steps during the\n"
        "shortest collision. `nineball explain` prints the row of a page.\n\n"
        "| steps per collision | errors | median | 90 % |\n| --- | --- | --- | --- |\n",
        out);
  if (header)
    fputs("/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.\n"
          " *\n * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */\n/* clang-format off */\n",
          header);
  for (size_t b = 0; b < BINS; b++) {
    const double from = first_bin * exp2((double)b);
    if (error_count[b] < 30)
      continue;
    const double half = quantile(errors[b], error_count[b], 0.5), most = quantile(errors[b], error_count[b], 0.9);
    fprintf(out, "| %g to %g | %zu | %.3g %% | %.3g %% |\n", from, 2 * from, error_count[b], 100 * half, 100 * most);
    if (header)
      fprintf(header, "{%g, %zu, %.3g, %.3g},\n", from, error_count[b], half, most);
  }
}

static void write_quantiles(FILE *out) {
  static double ratio[DRAWS_MAX], cost[DRAWS_MAX], seconds[DRAWS_MAX];
  size_t met = 0, met_answered = 0;
  for (size_t d = 0; d < draw_count; d++) {
    ratio[d] = draws[d].claim_over_true, cost[d] = draws[d].cost, seconds[d] = draws[d].seconds;
    met += draws[d].met, met_answered += draws[d].met && draws[d].answered;
  }
  fputs("\nOf the draws for which a setting that was tried is truly within the tolerance, ", out);
  write_share(out, met_answered, met);
  fputs(" are answered.\n\n| | 5 % | median | 90 % |\n| --- | --- | --- | --- |\n", out);
  double *const lists[] = {ratio, cost, seconds};
  static const char *const names[] = {"estimated error over true error",
                                      "cost over that of the cheapest setting that would do", "time of the search, s"};
  for (int k = 0; k < 3; k++) {
    static const double fractions[] = {0.05, 0.5, 0.9};
    fprintf(out, "| %s ", names[k]);
    for (int q = 0; q < 3; q++)
      fprintf(out, "| %.2g ", quantile(lists[k], draw_count, fractions[q]));
    fputs("|\n", out);
  }
}

static void write_means(FILE *out) {
  static double ratio[DRAWS_MAX], cost[DRAWS_MAX];
  size_t answered = 0, pages = 0, stopped = 0;
  for (size_t d = 0; d < mean_draw_count; d++) {
    ratio[d] = mean_draws[d].claim_over_true, cost[d] = mean_draws[d].cost;
    answered += mean_draws[d].answered;
    pages += d == 0 || strcmp(mean_draws[d].page, mean_draws[d - 1].page) != 0;
  }
  fprintf(
      out,
      "\n## Means over realizations\n\n"
      "The same for `--over seed` on %zu pages of assemblies of about a hundred particles, with %d draws for each.\n"
      "Each draw has its own %d realizations. The pages trade a rate of loading or a stiffness. The truth is the mean\n"
      "over %d other realizations, with a quarter of the step, and the true error is that of the mean over these with\n"
      "the setting. The logarithm of the tolerance is uniform between %g and %g. Of %zu draws, ",
      pages, MEAN_DRAWS, NB_REALIZATIONS_MIN, TRUTH_REALIZATIONS, lowest_of_mean, highest_of_mean, mean_draw_count);
  write_share(out, answered, mean_draw_count);
  fputs(" are answered.\n\n| what chooses the setting | true error within the tolerance |\n| --- | --- |\n", out);
  for (int control = 0; control < MEAN_CONTROLS; control++) {
    size_t kept = 0, count = 0;
    for (size_t d = 0; d < mean_draw_count; d++)
      kept += mean_draws[d].kept[control] <= 1, count += !isnan(mean_draws[d].kept[control]);
    fprintf(out, "| %s | ", mean_control_names[control]);
    write_share(out, kept, count);
    fputs(" |\n", out);
  }
  for (size_t d = 0; d < mean_draw_count; d++)
    stopped += mean_draws[d].answered && isnan(mean_draws[d].kept[WITH_STUDENT]);
  fprintf(out,
          "\nWith the setting of %zu other draws one of the %d other realizations stops with an error, because the "
          "step is\n"
          "too long for it.\n",
          stopped, TRUTH_REALIZATIONS);
  fprintf(
      out,
      "\nThe estimated error over the true one is %.2g in the median, and %.2g at 5 %%. The advice costs %.2g of the\n"
      "page as it is, in the median.\n",
      quantile(ratio, mean_draw_count, 0.5), quantile(ratio, mean_draw_count, 0.05),
      quantile(cost, mean_draw_count, 0.5));
}

static void write_document(FILE *out, FILE *header, size_t pages) {
  fputs("# How far the advice can be trusted\n\n"
        "`make accuracy` writes this document ([tests/accuracy.c](../tests/accuracy.c)). A draw is a page, a\n"
        "quantity of its expectations, a condition (one run of the sweep, or all runs) and a relative tolerance.\n"
        "For each draw the program is asked for advice. The true error of the advice is the largest difference,\n"
        "over all runs and phases, from the limit of the page for small steps.\n"
        "[METHOD](METHOD.md#the-accuracy-of-a-step) defines the terms.\n\n",
        out);
  fprintf(out,
          "There are %d draws for each of %zu pages. The logarithm of the tolerance is uniform between %g and %g.\n"
          "The search may take %g s.\n\n",
          DRAWS, pages, lowest_tolerance, highest_tolerance, budget);
  write_kinds(out);
  fprintf(out,
          "\nThere is no advice where the anchor is not known well enough, or where no setting is within the\n"
          "tolerance. Of the other draws, the limit was not known well enough for %zu. %zu draws were refused, for\n"
          "pages of more than fifty particles and for quantities that cannot be computed.\n",
          unresolved, DRAWS * pages - draw_count - unresolved);
  write_quantiles(out);
  fputs("\nThe same draws with estimators that lack something:\n", out);
  write_controls(out);
  write_errors(out, header);
  if (mean_draw_count)
    write_means(out);
}

int main(int count, char **words) {
  const char *document = NULL, *rows = NULL;
  size_t pages = 0;
  bool means = false;
  nb_references_prepare();
  generator = gsl_rng_alloc(gsl_rng_mt19937);
  if (!generator)
    return 1;
  puts("page\tquantity\tcondition\ttolerance\tresult\ttrue/tolerance\tone phase\tno anchor\ttwo "
       "steps\tclaim/true\tcost\tseconds");
  for (int k = 1; k < count; k++)
    if (strcmp(words[k], "-o") == 0 && k + 2 < count)
      document = words[++k], rows = words[++k];
    else if (strcmp(words[k], "--means") == 0)
      means = true;
    else if (means)
      draw_means(words[k]);
    else
      draw_page(words[k]), pages++;
  gsl_rng_free(generator);
  FILE *out = document ? fopen(document, "w") : NULL, *header = rows ? fopen(rows, "w") : NULL;
  if (!document)
    return 0;
  if (!out || !header)
    return 1;
  write_document(out, header, pages);
  const int closed = fclose(header);
  return fclose(out) || closed;
}
