/* Draws (tests/accuracy.c) about means over realizations, and the controls that choose a setting from the same runs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "results.h"
#include "runs.h"

enum { MEAN_LEVELS = 2, QUANTITIES_MAX = 16, MEANS_MAX = 64, TRUTH_BLOCK = 1000, TRUTH_REFINE = 2 };

/* For each setting, the values of all quantities of a page in many realizations that the advice has not used. */
struct means {
  size_t quantity_count;
  const char *quantities[QUANTITIES_MAX];
  struct mean {
    char setting[3 * NB_NAME_SIZE];
    double values[QUANTITIES_MAX][TRUTH_REALIZATIONS];
    bool stopped; /* some realization cannot be run */
  } list[MEANS_MAX];
  size_t count;
};

/* Runs the page with these settings, and stores its values as realization `index` of *mean. */
static void run_realization(struct mean *mean, int index, const struct means *means, const char *path,
                            const char *settings[]) {
  struct nb_outcome outcome;
  const struct nb_options options = {.threads = 1, .jobs = 1};
  mean->stopped = nb_outcome_read(&outcome, path, settings) || nb_outcome_run(&outcome, &options, NULL);
  for (size_t q = 0; q < means->quantity_count && !mean->stopped; q++) {
    struct nb_expectation wanted;
    struct nb_error error;
    char text[512];
    snprintf(text, sizeof text, "%s within 1 %%", means->quantities[q]);
    mean->stopped = nb_expectation_read(&wanted, "quantity", text, &outcome.runs[0].scene, &outcome.mistakes) ||
                    !nb_measure_value(&mean->values[q][index], &wanted.measure, &outcome.runs[0].result.table, &error);
  }
  nb_outcome_free(&outcome);
}

/* Returns the realizations of the variant with the step divided by `refine`. Computes them if they are not in the list
 * `means` yet. */
static const struct mean *realizations(struct means *means, const struct nb_scene *page, const char *path,
                                       const struct nb_variant *variant, double refine) {
  char texts[3 + NB_TRADES][3 * NB_NAME_SIZE], setting[3 * NB_NAME_SIZE];
  const char *settings[4 + NB_TRADES];
  size_t count = 2;
  snprintf(texts[0], sizeof *texts, "block=%d", TRUTH_BLOCK);
  size_t length = (size_t)snprintf(setting, sizeof setting, "refine=%.17g", refine);
  snprintf(texts[count++], sizeof *texts, "%s", setting);
  for (size_t t = 0; t < page->trade_count; t++)
    if (variant->value[t]) {
      snprintf(texts[count], sizeof *texts, "%s=%s", page->trades[t].name,
               page->trades[t].values[variant->value[t] - 1]);
      length += (size_t)snprintf(setting + length, sizeof setting - length, " %s", texts[count++]);
    }
  for (size_t k = 0; k < means->count; k++)
    if (strcmp(means->list[k].setting, setting) == 0)
      return &means->list[k];
  for (size_t t = 0; t < count; t++)
    settings[t] = texts[t];
  settings[count] = NULL;
  struct mean *mean = &means->list[means->count < MEANS_MAX ? means->count++ : 0];
  mean->stopped = false;
  snprintf(mean->setting, sizeof mean->setting, "%s", setting);
  for (int k = 0; k < TRUTH_REALIZATIONS && !mean->stopped; k++) {
    snprintf(texts[1], sizeof *texts, "seed=%d", k + 1);
    run_realization(mean, k, means, path, settings);
  }
  return mean;
}

/* The error of the mean with a setting, relative to the mean with half the step of the page. *uncertainty receives the
 * standard error of this difference. Infinite: a realization cannot be run. */
static double mean_error(double *uncertainty, struct means *means, const struct nb_scene *page, const char *path,
                         size_t quantity, const struct nb_variant *variant, double refine) {
  const struct nb_variant own = {.value = {0}};
  const struct mean *truth = realizations(means, page, path, &own, TRUTH_REFINE),
                    *with = realizations(means, page, path, variant, refine);
  double differences[TRUTH_REALIZATIONS];
  const double average = fabs(nb_estimate_average(truth->values[quantity], TRUTH_REALIZATIONS));
  *uncertainty = INFINITY;
  if (truth->stopped || with->stopped)
    return INFINITY;
  for (size_t k = 0; k < TRUTH_REALIZATIONS; k++)
    differences[k] = with->values[quantity][k] - truth->values[quantity][k];
  *uncertainty = nb_estimate_scatter(differences, TRUTH_REALIZATIONS) / sqrt(TRUTH_REALIZATIONS) / average;
  return fabs(nb_estimate_average(differences, TRUTH_REALIZATIONS)) / average;
}

/* Draws a tolerance between the errors of the best and of the worst setting, among the traded values and some steps.
 * The tolerance is at least twice the standard error of the change that half the step makes to the mean. The upper
 * end of the range is at least 8 times the lower end, because a search with 8 realizations resolves only larger
 * tolerances than these 64 realizations. */
static double draw_tolerance(struct means *means, const struct nb_scene *page, const char *path, size_t quantity,
                             gsl_rng *random) {
  static const double widest = 8;
  const struct nb_variant own = {.value = {0}};
  double low = INFINITY, high = 0, resolution, uncertainty;
  mean_error(&resolution, means, page, path, quantity, &own, 1);
  for (size_t value = 0; value <= page->trades[0].count; value++)
    for (int level = 0; level > -MEAN_LEVELS; level--) {
      const struct nb_variant variant = {.value = {value}};
      const double error = mean_error(&uncertainty, means, page, path, quantity, &variant, exp2(level));
      if (isfinite(error))
        low = fmin(low, error), high = fmax(high, error);
    }
  low = fmax(low, fmax(lowest_of_mean, 2 * resolution)), high = fmax(high, widest * low);
  return low * pow(high / low, gsl_rng_uniform(random));
}

/* The cheapest setting that the control accepts; -1: none. */
static int choose_mean(const struct nb_advice *advice, enum mean_control control) {
  const double *fine = point_of(&advice->variants[0], advice->anchor)->values;
  int chosen = -1;
  for (size_t k = 0; k < advice->setting_count && control != WITH_STUDENT; k++) {
    const struct nb_setting *setting = &advice->settings[k];
    const struct nb_point *point = nb_point_at(advice, setting);
    const double ratio = control == MEAN_ALONE
                             ? setting->step_ratio
                             : fabs(point->values[0] - fine[0]) / (advice->tolerance.value * fabs(fine[0]));
    if (ratio <= 1 && (chosen < 0 || point->updates < nb_point_at(advice, &advice->settings[chosen])->updates))
      chosen = (int)k;
  }
  return control == WITH_STUDENT ? advice->chosen : chosen;
}

static void draw_mean(FILE *out, const char *path, struct nb_outcome *page, struct means *means, gsl_rng *random,
                      int number) {
  char block[32], within[64];
  const struct nb_scene *scene = &page->runs[0].scene;
  const size_t quantity = gsl_rng_uniform_int(random, means->quantity_count);
  const double tolerance = draw_tolerance(means, scene, path, quantity, random);
  const char *settings[] = {block, NULL};
  const size_t realizations_of_draw = (size_t)NB_REALIZATIONS_MIN << gsl_rng_uniform_int(random, REALIZATIONS);
  snprintf(block, sizeof block, "block=%d", number);
  snprintf(within, sizeof within, "%.9g %%", 100 * tolerance);
  const struct nb_advise_query query = {.path = path,
                                        .settings = settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = means->quantities[quantity],
                                        .within = within,
                                        .over = "seed",
                                        .realizations = realizations_of_draw,
                                        .budget = 1e9};
  struct nb_advice advice;
  struct nb_error error = {0};
  double uncertainty;
  struct mean_draw draw = {.errors = {NAN, NAN, NAN}, .claim = NAN, .cost = NAN};
  const enum nb_status status = nb_advise(&advice, &query, &error);
  for (int control = 0; control < MEAN_CONTROLS && status == NB_OK; control++) {
    const int chosen = choose_mean(&advice, (enum mean_control)control);
    if (chosen < 0)
      continue;
    const struct nb_setting *setting = &advice.settings[chosen];
    draw.errors[control] = mean_error(&uncertainty, means, scene, path, quantity, &advice.variants[setting->variant],
                                      nb_level_refine(&advice, setting->level)) /
                           tolerance;
    if (control == WITH_STUDENT) {
      draw.claim = setting->ratio / draw.errors[control];
      draw.cost = nb_point_at(&advice, setting)->updates / point_of(&advice.variants[0], 0)->updates;
    }
  }
  fprintf(out, "mean\t%s\t%zu\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\t%s\t%.3g\n", page->page.name, realizations_of_draw,
          draw.errors[0], draw.errors[1], draw.errors[2], draw.claim, draw.cost, means->quantities[quantity],
          tolerance);
  nb_advice_free(&advice);
}

void draw_means(FILE *out, const char *path, struct nb_outcome *page, gsl_rng *random, const char *quantities[],
                size_t quantity_count) {
  static struct means means; /* static, because it is large */
  means.count = 0, means.quantity_count = quantity_count < QUANTITIES_MAX ? quantity_count : QUANTITIES_MAX;
  memcpy(means.quantities, quantities, means.quantity_count * sizeof *quantities);
  for (int k = 1; k <= MEAN_DRAWS && means.quantity_count > 0; k++) {
    seed_draw(random, page->page.name, k);
    draw_mean(out, path, page, &means, random, k);
  }
}
