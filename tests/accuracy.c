/* Calibration of `nineball advise`, run by `make accuracy`: how often the true error of the advice is within the tolerance.
 *
 * accuracy PAGE...  draws a quantity, a condition and a tolerance for each page several times, asks for advice, and computes the
 * true error: the largest difference, over all phases and runs, from the limit of the page for a small step. It prints one
 * row for each draw, then docs/ACCURACY.md to the file that -o names. Draws depend on the name of the page and the number of
 * the draw only.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/clock.h"
#include "../src/input/hash.h"
#include "../src/input/reader.h"
#include "../src/report/advise.h"

enum { DRAWS = 4, KINDS = 16, TRUTH_FIRST = 5, DRAWS_MAX = 4000, SETTINGS_MAX = 64 };
static const double budget = 20, lowest_tolerance = 1e-5, highest_tolerance = 0.3;
static const double truth_share = 0.05; /* of the tolerance: largest change of the truth when its step is halved */

/* What is chosen instead by an estimator that lacks something; the first one is the whole estimator. */
enum control { WHOLE, ONE_PHASE, NO_ANCHOR, TWO_STEPS, CONTROLS };
static const char *const control_names[] = {"the whole estimator", "one phase", "no anchor", "difference of two steps"};

struct draw {
  char kind[64];
  bool answered, met;     /* there is advice; some setting that was tried has a true error within the tolerance */
  double kept[CONTROLS];  /* true error over the tolerance of what is chosen; NAN: nothing */
  double claim_over_true; /* of the advice */
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

/* ---- one draw ---- */

static void measure_cost(struct draw *draw, struct nb_advice *advice, const double *truth, double tolerance) {
  double cheapest = INFINITY;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const struct nb_setting *setting = &advice->settings[k];
    if (true_error(advice, setting->variant, setting->level, truth, tolerance) <= 1)
      cheapest = fmin(cheapest, nb_point_at(advice, setting)->updates);
  }
  draw->met = isfinite(cheapest);
  if (draw->answered)
    draw->cost = nb_point_at(advice, &advice->settings[advice->chosen])->updates / cheapest;
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
    measure_cost(draw, advice, truth, tolerance);
    if (draw->answered) {
      const struct nb_setting *chosen = &advice->settings[advice->chosen];
      draw->kept[WHOLE] = true_error(advice, chosen->variant, chosen->level, truth, tolerance);
      draw->claim_over_true = chosen->ratio / draw->kept[WHOLE];
      int own = advice->anchor; /* the level that the whole estimator chose for the laws of the page */
      for (size_t k = 0; k < advice->setting_count; k++)
        if (advice->settings[k].variant == 0 && advice->settings[k].ratio <= 1)
          own = advice->settings[k].level;
      for (int control = ONE_PHASE; control < CONTROLS; control++)
        draw->kept[control] = true_error(advice, 0, choose(advice, control, own), truth, tolerance);
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
  struct nb_advise_query query = {path, settings, {.threads = 1}, quantity, within, budget, {NULL, NULL, NULL}};
  struct nb_advice advice;
  struct nb_error error = {0};
  struct draw *draw = &draws[draw_count];
  *draw = (struct draw){.kept = {NAN, NAN, NAN, NAN}, .claim_over_true = NAN, .cost = NAN};
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
    snprintf(kinds[kind_count++], 64, "%s", kind);
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
  fputs("\n| what chooses the step | true error within the tolerance |\n| --- | --- |\n", out);
  for (int control = 0; control < CONTROLS; control++) {
    size_t kept = 0, count = 0;
    for (size_t d = 0; d < draw_count; d++)
      kept += draws[d].kept[control] <= 1, count += !isnan(draws[d].kept[control]);
    fprintf(out, "| %s | ", control_names[control]);
    write_share(out, kept, count);
    fputs(" |\n", out);
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

static void write_document(FILE *out, size_t pages) {
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
}

int main(int count, char **words) {
  const int first = count > 2 && strcmp(words[1], "-o") == 0 ? 3 : 1;
  nb_references_prepare();
  generator = gsl_rng_alloc(gsl_rng_mt19937);
  if (!generator)
    return 1;
  puts("page\tquantity\tcondition\ttolerance\tresult\ttrue/tolerance\tone phase\tno anchor\ttwo "
       "steps\tclaim/true\tcost\tseconds");
  for (int k = first; k < count; k++)
    draw_page(words[k]);
  FILE *out = first == 3 ? fopen(words[2], "w") : NULL;
  if (out)
    write_document(out, (size_t)(count - first));
  if (out && fclose(out))
    return 1;
  gsl_rng_free(generator);
  return first == 3 && !out;
}
