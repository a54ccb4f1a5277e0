/* Calibration of `nineball advise`, run by `make accuracy`: how often the true error of the advice is within the
 * tolerance, and what the advice costs.
 *
 * Usage: accuracy FOLDER [-o DOCUMENT ROWS] PAGE… [--means PAGE…]. For each page the program makes several draws. In a
 * draw it chooses a quantity, one run of the sweep or all runs, and a tolerance at random, asks for advice, and computes
 *   - the true error: the largest difference, over all phases and runs, between the values of the advised setting and
 *     those of the page in the limit of small steps;
 *   - the cheapest setting whose true error is within the tolerance, in a grid of variants and steps. The variants are
 *     the page itself, other pairs of laws, contacts that are softer by a factor of 10, 100 or 1000, and centred
 *     dashpots; each with all values of the statements `trade`. The steps differ by factors of 2^(1/2);
 *   - the true error and the cost of the settings that the negative controls choose: estimators from which a part is
 *     missing.
 * The results of a page are stored in FOLDER, so a run that was interrupted can be continued. After the last page the
 * program writes docs/ACCURACY.md and the rows of its table of errors to the files that -o names (without -o, it prints
 * the document), and prints the criteria that do not hold. If a criterion does not hold, the exit status is 1. Pages
 * after --means are assemblies; their draws are about means over realizations. A draw depends only on the name of the
 * page and the number of the draw.
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
#include "calibration/results.h"
#include "calibration/runs.h"

/* Replaces the function of the C library: all budgets then count the processor time of this process, so that other
 * programs on the machine change no result. */
int timespec_get(struct timespec *time, int base) { return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, time) ? 0 : base; }

/* ---- the error of a step ---- */

/* The number of steps that the shortest collision of the run takes; infinite: unknown. */
static double steps_of(struct nb_outcome *page, size_t run) {
  struct nb_error error;
  const struct nb_options options = {.threads = 1};
  struct nb_model *model = nb_model_create(&page->runs[run].scene, &options, &error);
  struct nb_collision shortest;
  const double steps =
      model && !nb_step_collision(&shortest, model, &error) ? shortest.duration / model->step : INFINITY;
  nb_model_free(model);
  return steps;
}

/* Writes a row for each run and coarse step of the page: the bin of the number of steps per collision, and the relative
 * error at one phase. */
static void write_step_errors(FILE *out, struct nb_advice *advice, const struct truth *truth) {
  for (size_t r = 0; r < advice->runs; r++) {
    const double steps = steps_of(&advice->page, r);
    for (int level = NB_LEVEL_LOW; level < TRUTH_FIRST - 1 && isfinite(steps) && truth->values[r] != 0; level++) {
      const double bin = floor(log2(steps * exp2(level) / first_bin));
      if (bin >= 0 && bin < BINS && run_one(advice, &advice->variants[0], level, 0))
        fprintf(out, "error\t%g\t%.9g\n", bin,
                fabs(value_of(&advice->variants[0], level, r, 0) / truth->values[r] - 1));
    }
  }
}

/* ---- one draw ---- */

/* The question of a draw. */
struct question {
  char texts[SETTINGS_MAX][3 * NB_NAME_SIZE], within[64], label[256];
  const char *settings[SETTINGS_MAX + 2], *quantity;
  double tolerance;
};

/* True if the true error of some step is within the tolerance, with the laws of the page. */
static bool is_met(struct nb_advice *advice, const struct truth *truth) {
  for (int level = NB_LEVEL_LOW; level <= FINEST; level++)
    if (true_error(advice, truth, &advice->variants[0], level, 1) <= 1)
      return true;
  return false;
}

/* Computes errors and costs of the advice and of the negative controls. The controls are not asked if there is no
 * advice. The true error of the control that takes the finest step is computed at one phase only, because this control
 * need only fail the criterion for the cost. */
static void compare(struct draw *draw, struct nb_advice *advice, struct nb_advise_query *query, struct truth *truth) {
  struct chosen chosen[ESTIMATORS];
  double most = INFINITY;
  allow_time(advice, query, grid_time);
  if (advice->chosen < 0) {
    draw->met = is_met(advice, truth);
    return;
  }
  for (int e = 0; e < ESTIMATORS; e++) {
    chosen[e] = choose(advice, (enum estimator)e);
    if (!chosen[e].variant)
      continue;
    const double error =
        true_error(advice, truth, chosen[e].variant, chosen[e].level, e == ALWAYS_FINE ? -1 : INFINITY);
    if (!advice->exhausted)
      draw->choices[e].error = error;
    if (error <= 1)
      most = fmin(most, point_of(chosen[e].variant, chosen[e].level)->updates);
  }
  const double fewest = cheapest(advice, truth, most);
  draw->met = isfinite(fewest);
  const bool exhaustive = !advice->exhausted;
  /* The error of the advice is known if it is at least truth_margin times the last change of the true value. Until
   * then, the true value is computed with smaller steps. */
  const double coarse_change = truth->change;
  for (int level = truth->level + 1;
       level <= NB_LEVEL_HIGH && draw->choices[WHOLE].error < truth_margin * truth->change; level++) {
    const double before = truth->change;
    allow_time(advice, query, truth_time);
    if (!take_truth(truth, advice, level))
      break;
    draw->choices[WHOLE].error = true_error(advice, truth, chosen[WHOLE].variant, chosen[WHOLE].level, INFINITY);
    if (truth->change > before)
      break; /* the value is known as well as rounding allows */
  }
  for (int e = 0; e < ESTIMATORS; e++) {
    struct choice *choice = &draw->choices[e];
    if (!chosen[e].variant)
      continue;
    if (exhaustive)
      choice->cost = point_of(chosen[e].variant, chosen[e].level)->updates / fewest;
    if (choice->error >= truth_margin * (e == WHOLE ? truth->change : coarse_change) && choice->error > 0)
      choice->claim = chosen[e].ratio / choice->error;
  }
}

/* Writes the values of the sweeps in this run into the settings of the question, so that the question is about this run
 * alone. Returns the number of settings. */
static size_t fix_condition(const struct nb_page_run *run, struct question *question) {
  size_t count = 0;
  for (size_t k = 0; k < run->scene.binding_count && count + 2 < SETTINGS_MAX; k++)
    if (run->scene.bindings[k].sweep >= 0) {
      snprintf(question->texts[count], sizeof *question->texts, "%s=%s", run->scene.bindings[k].name,
               run->scene.bindings[k].text);
      question->settings[count] = question->texts[count];
      count++;
    }
  return count;
}

/* Lists the measures of the expectations of a page, without curves and residuals. Returns their number, at most
 * `most`. */
static size_t list_quantities(const struct nb_page_run *run, const char *quantities[], size_t most) {
  size_t count = 0;
  for (size_t k = 0; k < run->expectations.count && count < most; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    if (e->kind != NB_VERSUS && !e->measure.is_residual)
      quantities[count++] = e->measure.label;
  }
  return count;
}

/* The kind of a page: `contact test`, or the name of the folder of the page; `-` if the path has no folder. */
static void kind_of(char kind[64], const char *path, const struct nb_scene *scene) {
  const char *slash = strrchr(path, '/'), *from = slash;
  while (from && from > path && from[-1] != '/')
    from--;
  if (scene->contact_test)
    snprintf(kind, 64, "contact test");
  else
    snprintf(kind, 64, "%.*s", slash ? (int)(slash - from) : 1, slash ? from : "-");
}

/* Draws a question. False: the page has no quantities. */
static bool draw_question(struct question *question, const struct nb_outcome *page, gsl_rng *random) {
  const char *quantities[256];
  const size_t quantity_count = list_quantities(&page->runs[0], quantities, sizeof quantities / sizeof *quantities);
  const struct nb_page_run *run = &page->runs[0];
  size_t count = 0;
  if (quantity_count == 0)
    return false;
  question->quantity = quantities[gsl_rng_uniform_int(random, quantity_count)];
  snprintf(question->label, sizeof question->label, "all runs");
  if (page->run_count > 1 && gsl_rng_uniform(random) < 0.7) {
    run = &page->runs[gsl_rng_uniform_int(random, page->run_count)];
    count = fix_condition(run, question);
    snprintf(question->label, sizeof question->label, "%s", run->label);
  }
  question->tolerance = lowest_tolerance * pow(highest_tolerance / lowest_tolerance, gsl_rng_uniform(random));
  snprintf(question->within, sizeof question->within, "%.9g %%", 100 * question->tolerance);
  question->settings[count] = NULL;
  return true;
}

/* Writes the row of a draw: the question, the result, and the three numbers of each choice. */
static void write_draw(FILE *out, const struct draw *draw, const struct question *question, const char *result) {
  fprintf(out, "draw\t%s\t%s\t%s\t%d\t%.3f", draw->page, draw->kind, result, draw->met, draw->seconds);
  for (int e = 0; e < ESTIMATORS; e++)
    fprintf(out, "\t%.6g\t%.6g\t%.6g", draw->choices[e].error, draw->choices[e].cost, draw->choices[e].claim);
  fprintf(out, "\t%s\t%s\t%.3g\n", question->quantity, question->label, question->tolerance);
}

static void draw_one(FILE *out, const char *path, struct nb_outcome *page, gsl_rng *random) {
  static struct question question;
  struct draw draw = {.met = false};
  if (!draw_question(&question, page, random))
    return;
  struct nb_advise_query query = {.path = path,
                                  .settings = question.settings,
                                  .options = {.threads = 1, .jobs = 1},
                                  .quantity = question.quantity,
                                  .within = question.within,
                                  .budget = search_time};
  struct nb_advice advice;
  struct nb_error error = {0};
  for (int e = 0; e < ESTIMATORS; e++)
    draw.choices[e] = (struct choice){NAN, NAN, NAN};
  snprintf(draw.page, sizeof draw.page, "%s", page->page.name);
  kind_of(draw.kind, path, &page->runs[0].scene);
  const enum nb_status status = nb_advise(&advice, &query, &error);
  draw.seconds = nb_clock() - advice.began;
  const char *result = "refused";
  if (status <= NB_FAILED && advice.variants) {
    struct truth truth = {.values = calloc(advice.runs, sizeof *truth.values), .tolerance = question.tolerance};
    allow_time(&advice, &query, truth_time);
    result = "unresolved";
    if (truth.values && find_truth(&truth, &advice)) {
      compare(&draw, &advice, &query, &truth);
      write_step_errors(out, &advice, &truth);
      result = isnan(draw.choices[WHOLE].error) ? "no advice" : "answered";
    }
    free(truth.values);
  }
  write_draw(out, &draw, &question, result);
  nb_advice_free(&advice);
}

/* ---- a page, and its file of results ---- */

void seed_draw(gsl_rng *random, const char *page, int number) {
  gsl_rng_set(random, (unsigned long)nb_hash(NB_HASH_BEGIN, page, strlen(page)) + (unsigned long)number);
}

static void draw_page(FILE *out, const char *path, gsl_rng *random, bool is_mean) {
  static const char *const none[] = {NULL};
  const char *quantities[256];
  struct nb_outcome page;
  const bool good = !nb_outcome_read(&page, path, none) && page.run_count > 0;
  if (good && is_mean)
    draw_means(out, path, &page, random, quantities,
               list_quantities(&page.runs[0], quantities, sizeof quantities / sizeof *quantities));
  for (int k = 0; k < DRAWS && good && !is_mean; k++) {
    seed_draw(random, page.page.name, k);
    draw_one(out, path, &page, random);
  }
  nb_outcome_free(&page);
}

/* Adds the results of a page from its file in the folder. If there is no file, makes the draws and writes it.
 * `is_mean`: the draws are about means over realizations. False: the file cannot be written or read. */
static bool take_page(struct results *results, const char *folder, const char *path, gsl_rng *random, bool is_mean) {
  char file_name[512], part_name[520], row[2048];
  const char *slash = strrchr(path, '/');
  snprintf(file_name, sizeof file_name, "%s/%s.tsv", folder, slash ? slash + 1 : path);
  snprintf(part_name, sizeof part_name, "%s.part", file_name);
  FILE *file = fopen(file_name, "r");
  if (!file) {
    const double began = nb_clock();
    FILE *part = fopen(part_name, "w");
    if (!part)
      return false;
    draw_page(part, path, random, is_mean);
    if (fclose(part) || rename(part_name, file_name))
      return false;
    printf("%s: %.0f s\n", file_name, nb_clock() - began);
    fflush(stdout);
    file = fopen(file_name, "r");
  }
  while (file && fgets(row, sizeof row, file)) {
    row[strcspn(row, "\n")] = 0;
    take_row(results, row);
  }
  return file && fclose(file) == 0;
}

int main(int count, char **words) {
  static struct results results;
  const char *document = NULL, *rows = NULL;
  bool means = false, good = count > 1;
  nb_references_prepare();
  gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
  if (!random)
    return 1;
  for (int k = 2; k < count && good; k++)
    if (strcmp(words[k], "-o") == 0 && k + 2 < count)
      document = words[++k], rows = words[++k];
    else if (strcmp(words[k], "--means") == 0)
      means = true;
    else
      good = take_page(&results, words[1], words[k], random, means), results.pages += !means;
  gsl_rng_free(random);
  FILE *out = fopen(document ? document : "/dev/stdout", "w"), *header = fopen(rows ? rows : "/dev/null", "w");
  if (!good || !out || !header)
    return 1;
  good = write_document(out, header, &results);
  const int closed = fclose(header);
  return fclose(out) || closed || !good;
}
