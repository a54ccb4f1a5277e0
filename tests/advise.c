/* The search for advice: the runs that it makes, and the results that it computes from their values. These tests
 * compute the same values from pages whose statements give the phase, the step and the laws of a candidate.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/core/clock.h"
#include "../src/report/advise.h"
#include "suites.h"
#include "written.h"

/* An oblique impact of a sphere on a fixed one. */
#define IMPACT                                                                                                         \
  "units none\n%smaterial soft density 1 young 1000 poisson 0.3 friction 0.5\nnormal hertz\nshear %s\n"                \
  "sphere 0 0 radius 1 soft\nsphere 0 2 radius 1 soft fixed\nmonitor C sphere 1 with sphere 2\n"                       \
  "impact C speed %s angle 0.4 phase %.17g\nrecord impact.psi2\nstep %.17g\n"                                          \
  "stage a\nuntil impact.time above 1.02 at most 100000 cycles\n"

static bool run_trial(struct nb_advice *advice, size_t variant, int level, size_t trial) {
  return nb_trials_run(advice, &advice->variants[variant], level, trial, 1, 1);
}

/* A page with this scene, in a file that `finish` removes. */
struct page {
  char path[64];
};
static struct page write_page(const char *scene) {
  struct page page = {"/tmp/nineball-advise-XXXXXX.md"};
  const int descriptor = mkstemps(page.path, 3);
  CU_ASSERT_FATAL(descriptor >= 0);
  FILE *file = fdopen(descriptor, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fprintf(file, "# A page\n\n```scene\n%s```\n", scene);
  fclose(file);
  return page;
}

/* The last value of a column of a scene. */
static double value_of(const char *scene, const char *column) {
  struct words words = {0};
  struct written written;
  struct nb_result result;
  words_add(&words, "%s", scene);
  written_scene(&written, &words);
  written_run(&result, &written, NULL);
  const double value = written_last(&result, column);
  nb_result_free(&result);
  written_free(&written);
  return value;
}

/* Writes the scene of the impact. With the speed `$v` it has a sweep over two speeds. */
static void impact_scene(char *text, size_t size, const char *speed, const char *shear, double phase, double step) {
  snprintf(text, size, IMPACT, speed[0] == '$' ? "sweep v 0.3 0.6\n" : "", shear, speed, phase, step);
}

static const char *const no_settings[] = {NULL};
static const double step_of_page = 0.02, phase_of_page = 0.3;

/* Advice on the impact, at two speeds, with this tolerance. */
static void begin(struct nb_advice *advice, struct nb_advise_query *query, struct page *page, const char *within) {
  char scene[2048];
  struct nb_error error = {0};
  impact_scene(scene, sizeof scene, "$v", "mindlin_deresiewicz", phase_of_page, step_of_page);
  *page = write_page(scene);
  *query = (struct nb_advise_query){.path = page->path,
                                    .settings = no_settings,
                                    .options = {.threads = 1, .jobs = 1},
                                    .quantity = "impact.psi2",
                                    .within = within,
                                    .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(advice, query, &error), NB_OK);
  CU_ASSERT_EQUAL_FATAL(advice->runs, 2);
  CU_ASSERT_EQUAL_FATAL(advice->trials, NB_PHASES);
}

static void finish(struct nb_advice *advice, const struct page *page) {
  nb_advice_free(advice);
  unlink(page->path);
}

static const char *const speeds[] = {"0.3", "0.6"};

static void a_phase_of_an_impact_is_a_moment_of_first_touch(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  char scene[2048];
  begin(&advice, &query, &page, "1 %");
  const struct nb_point *point = &advice.variants[0].points[1 - NB_LEVEL_LOW];
  for (size_t phase = 0; phase < NB_PHASES; phase++)
    for (size_t r = 0; r < 2; r++) {
      CU_ASSERT_FATAL(run_trial(&advice, 0, 1, phase));
      impact_scene(scene, sizeof scene, speeds[r], "mindlin_deresiewicz",
                   fmod(phase_of_page + (double)phase / NB_PHASES, 1), step_of_page / 2);
      CU_ASSERT_EQUAL(point->values[r * NB_TRIALS + phase], value_of(scene, "impact.psi2"));
    }
  NEAR(point->step, step_of_page / 2, 1e-12);
  finish(&advice, &page);
}

/* The anchor of a run is the value with the page's own laws and a fine step; errors are measured relative to it. Here
 * it is the mean over its two phases. */
static double anchor(const struct nb_advice *advice, size_t run) {
  const double *values = advice->variants[0].points[advice->anchor - NB_LEVEL_LOW].values + run * NB_TRIALS;
  return (values[0] + values[NB_PHASES / 2]) / 2;
}

/* The tolerance and the estimated errors (claims), computed a second time from the values of the trials alone. */
static void claims_follow_from_the_values(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin(&advice, &query, &page, "1 %");
  const struct nb_point *own = advice.variants[0].points;
  for (size_t r = 0; r < 2; r++)
    NEAR(advice.allowed[r], 0.01 * fabs(anchor(&advice, r)), 1e-12);
  CU_ASSERT(advice.setting_count > 2);
  CU_ASSERT_FATAL(advice.chosen >= 0);
  for (size_t k = 0; k < advice.setting_count; k++) {
    const struct nb_setting *setting = &advice.settings[k];
    const struct nb_point *point = nb_point_at(&advice, setting);
    const int level = setting->level + 2 > advice.anchor ? setting->level + 2 : advice.anchor;
    double worst = 0, step_of_worst = 0;
    for (size_t r = 0; r < 2; r++) {
      double at[2], before[2], step;
      for (size_t j = 0; j < 2; j++) {
        at[j] = own[level - NB_LEVEL_LOW].values[r * NB_TRIALS + j * NB_PHASES / 2];
        before[j] = own[level - 1 - NB_LEVEL_LOW].values[r * NB_TRIALS + j * NB_PHASES / 2];
      }
      const double claim = nb_estimate_error(
          &step, point[0].values + r * NB_TRIALS, point[1].values + r * NB_TRIALS, point[2].values + r * NB_TRIALS,
          NB_PHASES, nb_level_ratios(&advice, setting->level), nb_estimate_anchor(at, before, 2));
      if (claim / advice.allowed[r] > worst)
        worst = claim / advice.allowed[r], step_of_worst = step / advice.allowed[r];
    }
    NEAR(setting->ratio, worst, 1e-12);
    NEAR(setting->step_ratio, step_of_worst, 1e-12);
    if (setting->ratio <= 1)
      CU_ASSERT(nb_point_at(&advice, &advice.settings[advice.chosen])->updates <= 1.1 * point->updates);
  }
  CU_ASSERT(advice.settings[advice.chosen].ratio <= 1);
  finish(&advice, &page);
}

/* The anchor of a setting is at least two levels finer. The quantity is the step itself, whose limit is 0 and which has
 * an error of first order. Let x be the step of level 3; the tolerance is 6.2 x. A claim, the estimated error, is 5/4
 * of the difference from the anchor, plus the uncertainty of the anchor, which is 3 times its step here. Level 1, with
 * its anchor at level 3, exceeds the tolerance: 5/4 (4 x - x) + 3 x = 6.75 x. Level 2, with its anchor at level 4, does
 * not: 5/4 (2 x - x/2) + 3 x/2 = 3.375 x. */
static void the_anchor_is_two_levels_finer(void) {
  struct nb_advice advice;
  struct nb_error error = {0};
  const double x = 0.002;
  const struct page page = write_page("units none\nmaterial m density 1 kn 1000\ndisc 0 0 radius 1 m\n"
                                      "disc 9 0 radius 1 m\nrecord step\nstep 0.016\nstage a\ncycles 64\n");
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = "step",
                                        .within = "0.0124",
                                        .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
  CU_ASSERT_EQUAL(advice.anchor, 3);
  CU_ASSERT_FATAL(advice.chosen > 0);
  const struct nb_setting *chosen = &advice.settings[advice.chosen];
  CU_ASSERT_EQUAL(chosen->level, 2);
  NEAR(chosen->ratio, 3.375 * x / 0.0124, 1e-12);
  NEAR(chosen[-1].ratio, 6.75 * x / 0.0124, 1e-12);
  finish(&advice, &page);
}

/* Two laws are equal only if they give the same values in every run. In the first run, which is head-on, there is no
 * shear force; the second run is oblique. */
static void laws_are_equal_in_every_run(void) {
  char scene[2048];
  struct nb_advice advice;
  struct nb_error error = {0};
  snprintf(scene, sizeof scene, IMPACT, "sweep a 0 0.4\n", "mindlin_deresiewicz", "0.3", phase_of_page, step_of_page);
  char *const angle = strstr(scene, "angle 0.4");
  CU_ASSERT_PTR_NOT_NULL_FATAL(angle);
  memcpy(angle, "angle $a ", strlen("angle $a "));
  const struct page page = write_page(scene);
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = "impact.psi2",
                                        .within = "0.05",
                                        .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
  int others = 0;
  for (size_t k = 1; k < advice.variant_count; k++) {
    const struct nb_variant *variant = &advice.variants[k];
    if (strcmp(variant->normal, "hertz") != 0 ||
        (strcmp(variant->shear, "mindlin") != 0 && strcmp(variant->shear, "none") != 0))
      continue;
    CU_ASSERT_EQUAL(variant->equal,
                    strcmp(variant->shear, "none") == 0); /* equal to `linear`, which has no stiffness here */
    others++;
  }
  CU_ASSERT_EQUAL(others, 2);
  finish(&advice, &page);
}

/* A variant stores as many doubles per contact as `nineball laws` states for its normal law and its shear law together.
 * With the `memory 12` of the page mindlin_deresiewicz stores 5 doubles for each of 12 pieces, and 12 others. A variant
 * without names of laws has the laws of the page. */
static void a_variant_stores_what_both_its_laws_store(void) {
  static const struct {
    const char *normal, *shear;
    int history;
  } rows[] = {{"", "", 72},
              {"hertz", "none", 0},
              {"hertz", "mindlin", 1},
              {"hertz", "randall", 7},
              {"hertz_increment", "none", 1},
              {"hertz_increment", "mindlin_scaled", 3},
              {"hertz_increment", "mindlin_deresiewicz", 73}};
  char scene[2048];
  struct nb_advice advice;
  struct nb_error error = {0};
  snprintf(scene, sizeof scene, IMPACT, "trade soften 1 10\n", "mindlin_deresiewicz memory 12", "0.3", phase_of_page,
           step_of_page);
  const struct page page = write_page(scene);
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = "impact.psi2",
                                        .within = "0.05",
                                        .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    size_t found = 0;
    for (size_t k = 0; k < advice.variant_count; k++)
      if (strcmp(advice.variants[k].normal, rows[r].normal) == 0 &&
          strcmp(advice.variants[k].shear, rows[r].shear) == 0) {
        CU_ASSERT_EQUAL(advice.variants[k].history, rows[r].history);
        found++;
      }
    CU_ASSERT(found >= 2); /* with and without softer contacts */
  }
  finish(&advice, &page);
}

/* The distance of a variant is the difference between its value and the anchor of the page, divided by the tolerance:
 * the largest one over the runs. The value is that of the first level at which the variant was run. */
static void laws_have_a_distance_from_the_anchor(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  char scene[2048];
  size_t left_out = 0;
  begin(&advice, &query, &page, "0.01 %");
  for (size_t k = 1; k < advice.variant_count; k++) {
    const struct nb_variant *pair = &advice.variants[k];
    if (!(pair->distance > 0) || strcmp(pair->normal, "hertz") != 0)
      continue;
    int level = NB_LEVEL_LOW;
    while (!pair->points[level - NB_LEVEL_LOW].done)
      level++;
    double largest = 0;
    for (size_t r = 0; r < 2; r++) {
      impact_scene(scene, sizeof scene, speeds[r], pair->shear, phase_of_page, step_of_page / exp2(level));
      largest = fmax(largest, fabs(value_of(scene, "impact.psi2") - anchor(&advice, r)) / advice.allowed[r]);
    }
    NEAR(pair->distance, largest, 1e-12);
    CU_ASSERT(pair->distance > 2);
    left_out++;
  }
  CU_ASSERT(left_out >= 3);
  finish(&advice, &page);
}

/* The cost counts contacts and particles of all runs. */
static void the_cost_is_counted(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin(&advice, &query, &page, "1 %");
  double updates = 0, recorded = 0;
  for (size_t r = 0; r < 2; r++) {
    char scene[2048];
    struct words words = {0};
    struct written written;
    struct nb_result result;
    impact_scene(scene, sizeof scene, speeds[r], "mindlin_deresiewicz", phase_of_page, step_of_page);
    words_add(&words, "%s", scene);
    written_scene(&written, &words);
    written_run(&result, &written, NULL);
    updates += (double)result.updates + 2 * (double)result.cycles;
    recorded += (double)result.table.row_count; /* one column */
    nb_result_free(&result);
    written_free(&written);
  }
  CU_ASSERT(run_trial(&advice, 0, 0, 0));
  CU_ASSERT_DOUBLE_EQUAL(advice.variants[0].points[-NB_LEVEL_LOW].updates, updates,
                         40); /* the mean over the phases differs by a few cycles */
  CU_ASSERT_DOUBLE_EQUAL(advice.variants[0].points[-NB_LEVEL_LOW].recorded, recorded, 20);
  finish(&advice, &page);
}

/* On a page without `impact` the phases have different steps: in phase k of 8 the step of every stage is divided by 1 +
 * 0.08 k/8. */
static void phases_of_pages_without_impact_have_different_steps(void) {
#define FLIGHT                                                                                                         \
  "units none\nmaterial m density 1 kn 1000\ndisc 0 3 radius 1 m\nwall w -9 0 to 9 0 m\ngravity 0 -1\n"                \
  "monitor D disc 1\nrecord D.y D.vy\nstep %.17g\nstage a\nuntil D.vy above 0 at most 100000 cycles\nstage b\n"        \
  "step %.17g\nuntil D.vy below 0 at most 100000 cycles\n"
  char text[1024];
  struct nb_advice advice;
  struct nb_error error = {0};
  snprintf(text, sizeof text, FLIGHT, 0.01, 0.005);
  const struct page page = write_page(text);
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = "D.y",
                                        .within = "5 %",
                                        .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
  CU_ASSERT_EQUAL(advice.trials, NB_PHASES);
  for (size_t phase = 0; phase < NB_PHASES; phase++) {
    const double by = 1 + 0.08 * (double)phase / NB_PHASES;
    snprintf(text, sizeof text, FLIGHT, 0.01 / by, 0.005 / by);
    CU_ASSERT_FATAL(run_trial(&advice, 0, 0, phase));
    CU_ASSERT_EQUAL(advice.variants[0].points[-NB_LEVEL_LOW].values[phase], value_of(text, "D.y"));
  }
  finish(&advice, &page);
}

/* A page with a strain per cycle, a number of cycles, or a damping per cycle has one phase, because such a page with
 * another step is another case. */
static void pages_whose_case_depends_on_the_step_have_one_phase(void) {
#define MATERIAL "units none\nmaterial m density 3 kn 100\n"
#define LATTICE "lattice discs 4 by 4 from 1 1 radius 1 spacing 2 m\n"
#define RUN "record time\nstep 0.001\nstage a\n"
#define UNTIL "until time above 0.01 at most 1000 cycles\n"
  static const char *const scenes[] = {
      MATERIAL LATTICE RUN "cycles 100\n",
      MATERIAL LATTICE RUN UNTIL "stage b\ncycles 100\n",
      MATERIAL "box 0 0 to 8 8 m\n" LATTICE RUN "box strain -1e-5 per cycle 0 per cycle\n" UNTIL,
      MATERIAL "periodic cell 0 0 to 8 8\n" LATTICE RUN "cell strain -1e-5 per cycle 0 per cycle\n" UNTIL,
      MATERIAL LATTICE RUN "affine strain -1e-5 per cycle 0 per cycle\n" UNTIL,
      MATERIAL "boundary circle 4 4 radius 4\n" LATTICE RUN "boundary strain -1e-5 per cycle 0 per cycle\n" UNTIL,
      MATERIAL "box 0 0 to 8 8 m\n" LATTICE RUN "servo mean 1 on box through box at most 1e-6 per cycle\n" UNTIL,
      MATERIAL LATTICE RUN "damping con1 0.9 as velocity\n" UNTIL,
      MATERIAL LATTICE RUN "damping con1 0.9 as cs79\n" UNTIL,
      MATERIAL "box 0 0 to 8 8 m\n" LATTICE RUN "box strain -0.01 0\ndamping mass 1\n" UNTIL,
  };
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
    const bool last = k + 1 == sizeof scenes / sizeof *scenes; /* the only one in which nothing acts per cycle */
    struct nb_advice advice;
    struct nb_error error = {0};
    const struct page page = write_page(scenes[k]);
    const struct nb_advise_query query = {.path = page.path,
                                          .settings = no_settings,
                                          .options = {.threads = 1, .jobs = 1},
                                          .quantity = "time",
                                          .within = "5 %",
                                          .budget = 6000};
    CU_ASSERT_EQUAL(nb_advise(&advice, &query, &error), NB_OK);
    CU_ASSERT_EQUAL(advice.trials, last ? NB_PHASES : 1);
    finish(&advice, &page);
  }
}

/* A trial is expected to take as long as earlier trials of its level; if there are none, twice as long as the trials of
 * the next coarser level. Here the earlier trials took 400 s. A trial that would end after the budget is not run. The
 * search has already taken 100 s. */
static void a_trial_that_would_end_after_the_budget(void) {
  static const struct {
    bool done; /* true: a trial of this level has been run; false: one of the next coarser level */
    double budget;
    bool runs;
  } rows[] = {{true, 490, false}, {true, 510, true}, {false, 890, false}, {false, 910, true}};
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin(&advice, &query, &page, "1000 %");
  struct nb_point *point = &advice.variants[0].points[-NB_LEVEL_LOW];
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    point[-1].done = !rows[k].done, point->done = rows[k].done;
    point[-1].seconds = rows[k].done ? 0 : 400, point->seconds = rows[k].done ? 400 : 0;
    query.budget = rows[k].budget;
    advice.began = nb_clock() - 100, advice.exhausted = false, advice.measured = 0;
    CU_ASSERT_EQUAL(run_trial(&advice, 0, 0, 1), rows[k].runs);
    CU_ASSERT_EQUAL(advice.exhausted, !rows[k].runs);
    CU_ASSERT_EQUAL(advice.measured, rows[k].runs);
    CU_ASSERT_EQUAL(point->done, (rows[k].done ? 1U : 0) | (rows[k].runs ? 2U : 0));
    CU_ASSERT(!rows[k].runs || (point->seconds > 0 && point->seconds < 100)); /* of the shortest trial */
  }
  point->seconds = 1e-12;
  CU_ASSERT(run_trial(&advice, 0, 0, 2) && point->seconds == 1e-12);
  finish(&advice, &page);
}

/* Counts the trials. When trial number `last` begins, sets the budget to 0, so that no later trial is run. */
struct end {
  struct nb_advise_query *query;
  unsigned trials, last;
};
static void end_the_budget(void *data, const char *stage, double fraction, double seconds) {
  struct end *end = data;
  CU_ASSERT_STRING_EQUAL(stage, "search");
  CU_ASSERT(end->query->budget == 0 || fraction == seconds / end->query->budget);
  if (++end->trials == end->last)
    end->query->budget = 0;
}

/* A search that ends before its last trial. Variants that it has not reached are not counted among those that cannot be
 * run. The variants with `normal linear` cannot be run, because the material has no `kn`. */
static void variants_after_the_budget(void) {
  struct nb_advice advice[2];
  struct nb_advise_query query;
  struct nb_error error = {0};
  struct page page;
  struct end end = {.query = &query};
  struct nb_left_out out[2];
  size_t late = 0;
  begin(&advice[0], &query, &page, "1 %");
  nb_advice_free(&advice[0]);
  query.progress.call = end_the_budget, query.progress.data = &end;
  for (int k = 0; k < 2; k++) {
    CU_ASSERT_EQUAL_FATAL(nb_advise(&advice[k], &query, &error), NB_OK);
    out[k] = nb_advice_left_out(&advice[k]);
    end.last = end.trials / 2, end.trials = 0;
  }
  CU_ASSERT(!advice[0].exhausted && advice[1].exhausted);
  CU_ASSERT_EQUAL(out[0].too_late, 0);
  CU_ASSERT(out[0].refused > 0);
  for (size_t k = 1; k < advice[1].variant_count; k++) {
    const struct nb_variant *variant = &advice[1].variants[k];
    const bool refused = variant->reason[0] && !variant->equal && !variant->too_late && !(variant->distance > 0);
    CU_ASSERT_EQUAL(variant->too_late, strcmp(variant->reason, "the budget was used up") == 0);
    CU_ASSERT(!refused || strcmp(variant->reason, advice[0].variants[k].reason) == 0);
    late += variant->too_late;
  }
  CU_ASSERT(late > 0);
  CU_ASSERT_EQUAL(out[1].too_late, late);
  nb_advice_free(&advice[0]);
  finish(&advice[1], &page);
}

/* The time of a setting that the page refuses is NaN, so that no message calls it fast. */
static void the_time_of_a_setting_that_cannot_run(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin(&advice, &query, &page, "1000 %");
  CU_ASSERT(nb_trials_time(&advice, &advice.variants[0], 0) > 0);
  struct nb_variant refused = {.normal = "linear", .shear = "linear"}; /* the material has no `kn` */
  CU_ASSERT(isnan(nb_trials_time(&advice, &refused, 0)));
  finish(&advice, &page);
}

/* Softer contacts save nothing in single runs of an impact in which every stage takes its step from the collision. */
static void when_softer_contacts_save_nothing(void) {
  for (int k = 0; k < 32; k++) {
    struct nb_stage stages[3] = {{.cycles = 1}};
    struct nb_page_run run = {.scene = {.stages = stages, .stage_count = 3, .impact = {.line = k & 8 ? 4 : 0}}};
    const struct nb_advise_query query = {.over = k & 16 ? "seed" : NULL};
    const struct nb_advice advice = {.query = &query, .page = {.runs = &run, .run_count = 1}};
    for (int s = 0; s < 3; s++)
      stages[s].step.kind = k & 1 << s ? NB_STEP_COLLISION : NB_STEP_STABLE;
    CU_ASSERT_EQUAL(nb_advice_softness_is_useless(&advice), k == 15);
  }
}

/* ---- means over realizations ---- */

/* Random discs at rest in a periodic cell that shrinks. In some realizations discs collide. */
#define GAS                                                                                                            \
  "units none\n%s%smaterial m density 1 kn 1000 ks 500 friction 0.5\nnormal linear\nshear %s\nperiodic cell 0 0 to 9 " \
  "9\n"                                                                                                                \
  "grading g 1 6 0.7 8\nfill discs cell g m seed %s attempts 10000 else skip\nregion A all\nrecord "                   \
  "A.porosity energy.kinetic\nstep %.17g\nstage a\ncell strain (-%s) -0.01\nuntil time above %s at most 100000 "       \
  "cycles\n"

static void gas_scene(char *text, size_t size, const char *names, const char *trade, const char *shear,
                      const char *seed, double step, const char *rate, const char *time) {
  snprintf(text, size, GAS, names, trade, shear, seed, step, rate, time);
}

static const char *const times[] = {"2", "3"}, *const rates[] = {"0.01", "0.02"};
static const double gas_step = 0.004;

static void begin_mean(struct nb_advice *advice, struct nb_advise_query *query, struct page *page, const char *trade) {
  char scene[2048];
  struct nb_error error = {0};
  gas_scene(scene, sizeof scene, "sweep seed 1 2 3\nlet rate = 0.01\nsweep T 2 3\n", trade, "linear", "$seed", gas_step,
            "rate", "$T");
  *page = write_page(scene);
  *query = (struct nb_advise_query){.path = page->path,
                                    .settings = no_settings,
                                    .options = {.threads = 1, .jobs = 2},
                                    .quantity = "energy.kinetic",
                                    .within = "1000 %",
                                    .over = "seed",
                                    .realizations = 9,
                                    .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(advice, query, &error), NB_OK);
  CU_ASSERT_EQUAL_FATAL(advice->runs, 2);
  CU_ASSERT_EQUAL_FATAL(advice->trials, 9);
}

static double energy_of(const struct nb_variant *variant, size_t run, size_t trial, int level) {
  char scene[2048], seed[8];
  snprintf(seed, sizeof seed, "%zu", trial + 1);
  gas_scene(scene, sizeof scene, "", "", variant->shear[0] ? variant->shear : "linear", seed, gas_step / exp2(level),
            rates[variant->value[0]], times[run]);
  return value_of(scene, "energy.kinetic");
}

/* Trial k is the page with the seed k + 1, for each value of the other sweep, T, and for each variant. */
static void a_trial_of_a_mean_is_a_realization(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin_mean(&advice, &query, &page, "trade rate 0.02\n");
  CU_ASSERT_EQUAL_FATAL(advice.variant_count, 2);
  for (size_t v = 0; v < 2; v++)
    for (size_t trial = 0; trial < 9; trial += 4)
      for (size_t r = 0; r < 2; r++) {
        CU_ASSERT_FATAL(run_trial(&advice, v, 0, trial));
        CU_ASSERT_EQUAL(advice.variants[v].points[-NB_LEVEL_LOW].values[r * NB_TRIALS + trial],
                        energy_of(&advice.variants[v], r, trial, 0));
      }
  finish(&advice, &page);
}

/* For a mean over realizations, the tolerance is relative to the mean of the anchor. The claim is the magnitude of the
 * mean of the differences from the anchor, realization by realization, plus half the width of its 95 % confidence
 * interval. */
static void claims_of_a_mean_follow_from_its_realizations(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin_mean(&advice, &query, &page, "trade rate 0.02\n");
  const double *fine = advice.variants[0].points[1 - NB_LEVEL_LOW].values;
  CU_ASSERT_EQUAL(advice.anchor, 1);
  for (size_t r = 0; r < 2; r++)
    NEAR(advice.allowed[r], 10 * gsl_stats_mean(fine + r * NB_TRIALS, 1, 9), 1e-12);
  size_t of_variant[2] = {0};
  for (size_t k = 0; k < advice.setting_count; k++) {
    const struct nb_setting *setting = &advice.settings[k];
    double worst = 0, difference = 0;
    for (size_t r = 0; r < 2; r++) {
      double d[9];
      for (size_t i = 0; i < 9; i++)
        d[i] = nb_point_at(&advice, setting)->values[r * NB_TRIALS + i] - fine[r * NB_TRIALS + i];
      const double mean = fabs(gsl_stats_mean(d, 1, 9)),
                   claim = mean + gsl_cdf_tdist_Pinv(0.975, 8) * gsl_stats_sd(d, 1, 9) / 3;
      if (claim / advice.allowed[r] > worst)
        worst = claim / advice.allowed[r], difference = mean / advice.allowed[r];
    }
    NEAR(setting->ratio, worst, 1e-10);
    NEAR(setting->step_ratio, difference, 1e-10);
    CU_ASSERT(setting->level <= 0);
    of_variant[setting->variant]++;
  }
  CU_ASSERT(of_variant[0] > 0 && of_variant[1] > 0);
  finish(&advice, &page);
}

/* The variants are the page with its own values and with each value of `trade`. If the page asks for other laws, they
 * are all combinations of these values with the laws. */
static void variants_are_all_combinations(void) {
  static const struct {
    const char *trade;
    size_t count;
  } rows[] = {{"", 1}, {"trade rate 0.02 0.03\n", 3}, {"trade laws none\ntrade rate 0.02\n", 2}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_advice advice;
    struct nb_advise_query query;
    struct page page;
    begin_mean(&advice, &query, &page, rows[k].trade);
    CU_ASSERT_EQUAL(advice.variant_count, rows[k].count);
    finish(&advice, &page);
  }
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  begin_mean(&advice, &query, &page, "trade laws all\ntrade rate 0.02\n");
  const size_t pairs = advice.variant_count / 2;
  CU_ASSERT_EQUAL(advice.variant_count, 2 * pairs);
  CU_ASSERT(pairs > 10);
  for (size_t k = 0; k < advice.variant_count; k++) { /* each pair of laws with each value, once */
    CU_ASSERT_EQUAL(advice.variants[k].value[0], k / pairs);
    for (size_t j = 0; j < k; j++)
      CU_ASSERT(strcmp(advice.variants[j].normal, advice.variants[k].normal) != 0 ||
                strcmp(advice.variants[j].shear, advice.variants[k].shear) != 0 || j + pairs == k);
  }
  finish(&advice, &page);
}

/* Softer contacts and centred dashpots are variants with the laws of the page. */
static void variants_with_the_laws_of_the_page(void) {
  static const struct {
    const char *more, *step;
    size_t soft, centred;
  } rows[] = {
      {"", "step 0.01", 3, 0},
      {"damping ratio 0.1\n", "step 0.01", 3, 1},
      {"damping mass 0.1\n", "step 0.01", 3, 0},
      {"damping ratio 0.1\ndamping late\n", "step 0.01", 3, 0},
      {"damping ratio 0.1\n", "step 1000 per collision", 0, 1},
      {"trade laws none\ndamping ratio 0.1\n", "step 0.01", 0, 0},
      {"", "step 0.01\nstage z\ndamping ratio 0.1\ncycles 1\nstage y\ndamping none\ncycles 1", 3, 1},
      {"", "step 0.01\nstage z\ndamping ratio 0.1\ndamping late\ncycles 1\nstage y\ndamping none\ncycles 1", 3, 0},
      {"sweep shear none mindlin\nshear $shear\n", "step 0.01", 0, 0}, /* its own laws are swept */
      {"let normal = 0.01\n", "step $normal", 0, 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[1024];
    struct nb_advice advice;
    struct nb_error error = {0};
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 young 1000 poisson 0.3\nnormal hertz\n%ssphere 0 0 radius 1 m\n"
             "sphere 0 2 radius 1 m fixed\nmonitor C sphere 1 with sphere 2\nimpact C speed 0.1 angle 0\n"
             "record C.normal\n%s\nstage a\nuntil C.normal above 0 at most 9 cycles\n",
             rows[k].more, rows[k].step);
    const struct page page = write_page(text);
    const struct nb_advise_query query = {.path = page.path,
                                          .settings = no_settings,
                                          .options = {.threads = 1, .jobs = 1},
                                          .quantity = "C.normal",
                                          .within = "1 %",
                                          .budget = 1e-6};
    size_t soft = 0, centred = 0;
    double softness = 0;
    nb_advise(&advice, &query, &error);
    for (size_t v = 1; v < advice.variant_count; v++) {
      const struct nb_variant *variant = &advice.variants[v];
      soft += variant->soften > 0 && !variant->normal[0] && !variant->centred, softness += variant->soften;
      centred += variant->centred && !variant->normal[0] && variant->soften == 0;
    }
    CU_ASSERT_EQUAL(soft, rows[k].soft);
    CU_ASSERT_EQUAL(softness, soft ? 10 + 100 + 1000 : 0);
    CU_ASSERT_EQUAL(centred, rows[k].centred);
    CU_ASSERT_EQUAL(nb_advice_softness_is_useless(&advice), strstr(rows[k].step, "collision") != NULL);
    finish(&advice, &page);
  }
}

/* A page that starts from another one has no variants with softer contacts, because the other page has computed the
 * contacts. */
static void no_softer_contacts_after_a_start(void) {
  const struct page other = write_page("units none\nmaterial m density 1 young 1000 poisson 0.3\nnormal hertz\n"
                                       "sphere 0 0 radius 1 m velocity 0 1\nsphere 0 2 radius 1 m fixed\n"
                                       "step 0.01\nrecord time\nstage a\ncycles 1\n");
  char text[1024];
  struct nb_advice advice;
  struct nb_error error = {0};
  snprintf(text, sizeof text, "start %.500s stage a\nrecord energy.kinetic\nstage b\ncycles 9\n", other.path);
  const struct page page = write_page(text);
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .quantity = "energy.kinetic",
                                        .within = "1 %",
                                        .budget = 1e-6};
  nb_advise(&advice, &query, &error);
  CU_ASSERT(advice.variant_count > 0);
  for (size_t v = 0; v < advice.variant_count; v++)
    CU_ASSERT_EQUAL(advice.variants[v].soften, 0);
  finish(&advice, &page);
  unlink(other.path);
}

/* Each realization has two discs in contact, whose stiffness depends on the seed. The ratio of the step to the stable
 * step is dt (k_n/(2 m))^(1/2), because the shear stiffness is 0. A setting is left out if a bound for this ratio is
 * above 1. By Student's distribution the ratio of another realization exceeds the bound with the probability 0.001. The
 * page as it is needs no such margin. */
static void settings_of_a_mean_have_a_margin_of_stability(void) {
  static const double spreads[] = {0.001, 0.01, 0.015, 0.02}, step_of_mean = 0.0713; /* ratios from 0.9 to 0.97 */
  for (size_t k = 0; k < sizeof spreads / sizeof *spreads; k++) {
    char text[1024];
    double ratios[8];
    struct nb_advice advice;
    struct nb_error error = {0};
    snprintf(text, sizeof text,
             "units none\nlet seed = 1\nlet soft = 1\ntrade soft 4\nlet k = 1000*(1 + %g*seed)/soft\n"
             "material m density 1 kn $k\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\nmonitor D disc 1\nrecord D.x\n"
             "step %.17g\nstage a\nuntil time above 0.5 at most 1000 cycles\n",
             spreads[k], step_of_mean);
    const struct page page = write_page(text);
    const struct nb_advise_query query = {.path = page.path,
                                          .settings = no_settings,
                                          .options = {.threads = 1, .jobs = 1},
                                          .quantity = "D.x",
                                          .within = "1",
                                          .over = "seed",
                                          .realizations = 8,
                                          .budget = 6000};
    CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
    size_t left_out = 0, kept = 0;
    for (size_t v = 0; v < 2; v++)
      for (int level = -3; level <= 0; level++) {
        const struct nb_point *point = &advice.variants[v].points[level - NB_LEVEL_LOW];
        const double mass = acos(-1);
        for (size_t i = 0; i < 8; i++)
          ratios[i] =
              step_of_mean / exp2(level) / 2 * sqrt(1000 * (1 + spreads[k] * (double)(i + 1)) / (v ? 4 : 1) * 2 / mass);
        const double most = gsl_stats_max(ratios, 1, 8),
                     bound = gsl_stats_mean(ratios, 1, 8) +
                             gsl_cdf_tdist_Pinv(0.999, 7) * gsl_stats_sd(ratios, 1, 8) * sqrt(1 + 1.0 / 8);
        if (most > 1 || point->done != 0xff)
          continue;
        for (size_t i = 0; i < 8; i++)
          NEAR(point->stability[i], ratios[i], 1e-9);
        const bool good = bound <= 1 || (v == 0 && level == 0);
        CU_ASSERT_EQUAL(point->reason[0] == 0, good);
        char reason[64];
        snprintf(reason, sizeof reason, "its step is %.2g of the guaranteed", gsl_stats_mean(ratios, 1, 8));
        CU_ASSERT(good || strncmp(point->reason, reason, strlen(reason)) == 0);
        good ? kept++ : left_out++;
      }
    CU_ASSERT(kept > 0);
    CU_ASSERT_EQUAL(left_out > 0, k > 1);
    finish(&advice, &page);
  }
}

/* ---- text about the result, from made-up settings ---- */

enum { SETTINGS = 6 };
struct made_up {
  struct nb_advice advice;
  struct nb_variant variants[SETTINGS];
  struct nb_setting settings[SETTINGS];
};

/* Setting k is variant k at the level of the page, with these updates, history variables, and estimated error over the
 * tolerance (`ratio`). */
static void make_up(struct made_up *it, const double updates[SETTINGS], const int history[SETTINGS],
                    const double ratio[SETTINGS]) {
  memset(it, 0, sizeof *it);
  it->advice.variants = it->variants, it->advice.variant_count = SETTINGS;
  it->advice.settings = it->settings, it->advice.setting_count = SETTINGS;
  for (size_t k = 0; k < SETTINGS; k++) {
    it->settings[k] = (struct nb_setting){.variant = k, .ratio = ratio[k]};
    it->variants[k].points[-NB_LEVEL_LOW].updates = updates[k];
    it->variants[k].history = history[k];
  }
}

/* The setting with fewer updates is the cheaper one if the numbers differ by more than 10 %; otherwise, the one whose
 * laws store fewer doubles. Measured times never decide. */
static void the_cheaper_of_two_settings(void) {
  static const double updates[SETTINGS] = {100, 111, 110, 100, 50, 91};
  static const int history[SETTINGS] = {4, 1, 1, 4, 9, 5};
  static const bool cheaper[SETTINGS][SETTINGS] = {{0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 1, 0, 0},
                                                   {0, 0, 0, 0, 0, 1}, {1, 1, 1, 1, 0, 1}, {0, 1, 1, 0, 0, 0}};
  struct made_up it;
  make_up(&it, updates, history, updates);
  for (size_t k = 0; k < SETTINGS; k++)
    it.variants[k].points[-NB_LEVEL_LOW].seconds = 1 / (double)(k + 1);
  for (size_t a = 0; a < SETTINGS; a++)
    for (size_t b = 0; b < SETTINGS; b++)
      CU_ASSERT_EQUAL(nb_setting_cheaper(&it.advice, &it.settings[a], &it.settings[b]), cheaper[a][b]);
}

/* With nearly as many updates, softer contacts are not cheaper, however little their laws store. With fewer updates
 * they are cheaper. */
static void softer_contacts_must_save_updates(void) {
  static const double updates[SETTINGS] = {100, 95, 80, 100, 100, 100};
  static const int history[SETTINGS] = {4, 1, 4, 1, 9, 9};
  struct made_up it;
  make_up(&it, updates, history, updates);
  it.variants[1].soften = it.variants[2].soften = it.variants[3].soften = 10, it.variants[4].soften = 100;
  const struct nb_setting *s = it.settings;
  CU_ASSERT_FALSE(nb_setting_cheaper(&it.advice, s + 1, s));
  CU_ASSERT_TRUE(nb_setting_cheaper(&it.advice, s, s + 1));
  CU_ASSERT_TRUE(nb_setting_cheaper(&it.advice, s + 2, s));
  CU_ASSERT_FALSE(nb_setting_cheaper(&it.advice, s, s + 2));
  CU_ASSERT_TRUE(nb_setting_cheaper(&it.advice, s + 3, s + 4));
  CU_ASSERT_TRUE(nb_setting_cheaper(&it.advice, s + 5, s + 3));
}

static void the_next_cheaper_and_the_most_accurate_setting(void) {
  static const double updates[SETTINGS] = {100, 50, 50, 50, 25, 100};
  static const int history[SETTINGS] = {0};
  static const double ratio[SETTINGS] = {0.7, 2, 1.5, 1.5, 1.1, 0.7};
  /* of the settings with fewer updates that miss the tolerance, the one with the most updates; of equal ones the most
   * accurate, then the first */
  static const int next[SETTINGS] = {2, 4, 4, 4, -1, 2};
  struct made_up it;
  make_up(&it, updates, history, ratio);
  for (size_t k = 0; k < SETTINGS; k++)
    CU_ASSERT_PTR_EQUAL(nb_advice_cheaper(&it.advice, &it.settings[k]), next[k] < 0 ? NULL : &it.settings[next[k]]);
  it.variants[1].points[-NB_LEVEL_LOW].updates = 95, it.settings[1].ratio = 0.9; /* it meets the tolerance */
  CU_ASSERT_PTR_EQUAL(nb_advice_cheaper(&it.advice, &it.settings[0]), &it.settings[2]);
  CU_ASSERT_PTR_EQUAL(nb_advice_most_accurate(&it.advice), &it.settings[0]);
  it.settings[4].ratio = 0.2;
  CU_ASSERT_PTR_EQUAL(nb_advice_most_accurate(&it.advice), &it.settings[4]);
  it.advice.setting_count = 0;
  CU_ASSERT_PTR_NULL(nb_advice_most_accurate(&it.advice));
}

/* A level divides the page's step by 2^level, rounded up to a multiple of 1/30, so that all numbers of cycles stay
 * whole: 120 and 90 cycles, and an expectation at cycle 60, have the common divisor 30. The levels below -5 have the
 * step of level -5. */
static void levels_divide_all_numbers_of_cycles(void) {
  static const double refine[] = {1 / 30.0, 1 / 30.0, 1 / 30.0, 2 / 30.0, 4 / 30.0, 8 / 30.0, 0.5, 1, 2, 4};
  struct nb_advice advice = {.divisor = 30};
  for (int level = NB_LEVEL_LOW; level <= 2; level++) {
    const double *r = refine + (level - NB_LEVEL_LOW);
    NEAR(nb_level_refine(&advice, level), r[0], 1e-14);
    if (level <= 0) {
      NEAR(nb_level_ratios(&advice, level).first, r[1] / r[0], 1e-14);
      NEAR(nb_level_ratios(&advice, level).second, r[2] / r[1], 1e-14);
    }
  }
  advice.divisor = 0;
  for (int level = NB_LEVEL_LOW; level <= NB_LEVEL_HIGH; level++)
    CU_ASSERT_EQUAL(nb_level_refine(&advice, level), exp2(level));
}

/* A falling disc. Its velocity has no error, so the cheapest step is the longest one with which all numbers of cycles
 * stay whole: the 120 and 90 cycles of the stages, and the 60 and 20 cycles of the expectations. It is 10 times as long
 * as that of the page. */
static void steps_that_do_not_halve_are_tried(void) {
  struct nb_advice advice;
  struct nb_error error = {0};
  const struct page page = write_page("units none\nmaterial m density 1 kn 0.001\ndisc 0 0 radius 1 m\n"
                                      "disc 9 0 radius 1 m\nmonitor D disc 1\ngravity 0 -1\nrecord D.vy\nstep 0.01\n"
                                      "stage a\ncycles 120\nstage b\ncycles 90\n```\n\n```expect\n"
                                      "D.vy at 60 cycles expected -0.6 within 1 % [x]\n"
                                      "D.vy at 20 cycles expected -0.2 within 1 % [x]\n");
  const struct nb_advise_query query = {.path = page.path,
                                        .settings = no_settings,
                                        .options = {.threads = 1, .jobs = 1},
                                        .within = "1 %",
                                        .budget = 6000};
  CU_ASSERT_EQUAL_FATAL(nb_advise(&advice, &query, &error), NB_OK);
  CU_ASSERT_EQUAL(advice.divisor, 10);
  CU_ASSERT_FATAL(advice.chosen >= 0);
  CU_ASSERT_EQUAL(advice.settings[advice.chosen].level, -4);
  NEAR(nb_point_at(&advice, &advice.settings[advice.chosen])->step, 0.1, 1e-12);
  finish(&advice, &page);
}

/* Advice on a scene that the budget ends before its first trial. Returns the status. */
static enum nb_status begin_without_trials(struct nb_advice *advice, struct nb_advise_query *query, struct page *page,
                                           const char *scene) {
  struct nb_error error = {0};
  *page = write_page(scene);
  *query = (struct nb_advise_query){.path = page->path,
                                    .settings = no_settings,
                                    .options = {.threads = 1, .jobs = 1},
                                    .quantity = "time",
                                    .within = "1 %",
                                    .budget = 1e-9};
  return nb_advise(advice, query, &error);
}

/* The numbers of cycles of all stages of this page and of all its runs count, and no other ones: not those of the page
 * from which it starts, and not the `at most` of a stage with conditions. */
static void the_divisor_is_that_of_all_cycles_of_the_page(void) {
#define DISC "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.01\n"
  const struct page other = write_page(DISC "record time\nstage a\ncycles 7\n");
  char start[256];
  snprintf(start, sizeof start, "start %.100s stage a\nrecord time\nstage b\ncycles 12\nstage c\ncycles 18\n",
           other.path);
  const struct {
    const char *scene;
    unsigned long divisor;
  } rows[] = {{DISC "record time\nstage a\ncycles 12\nstage b\ncycles 18\nstage c\ncycles 8\n", 2},
              {DISC "record time\nstage a\nuntil time above 1 at most 35 cycles\nstage b\ncycles 18\n", 18},
              {DISC "record time\nstage a\nuntil time above 1 at most 35 cycles\n", 0},
              {"sweep n 12 18 27\n" DISC "record time\nstage a\ncycles $n\n", 3},
              {"sweep n 27 18 12\n" DISC "record time\nstage a\ncycles $n\n", 3},
              {start, 6}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_advice advice;
    struct nb_advise_query query;
    struct page page;
    CU_ASSERT_EQUAL(begin_without_trials(&advice, &query, &page, rows[k].scene), NB_FAILED);
    CU_ASSERT_EQUAL(advice.divisor, rows[k].divisor);
    finish(&advice, &page);
  }
  unlink(other.path);
}

/* The largest numbers: 50 particles, 8 statements `trade`, and 500 combinations, here 10 10 5. */
static void the_largest_page_and_the_most_variants(void) {
  struct words eight = {0}, most = {0};
  for (int k = 0; k < 8; k++)
    words_add(&eight, "let a%d = 1\ntrade a%d 2\n", k, k);
  words_add(&most, "let a = 1\nlet b = 1\nlet c = 1\ntrade a 2 3 4 5 6 7 8 9 10\ntrade b 2 3 4 5 6 7 8 9 10\n"
                   "trade c 2 3 4 5\n");
  const struct {
    const char *trades;
    int particles;
    size_t variants; /* 0: the page is refused */
  } rows[] = {{"", 50, 1}, {"", 51, 0}, {eight.text, 1, 256}, {most.text, 1, 500}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_advice advice;
    struct nb_advise_query query;
    struct page page;
    struct words scene = {0};
    words_add(&scene,
              "units none\n%s\ntrade laws none\nmaterial m density 1 kn 1\n"
              "lattice discs %d by 1 from 1 1 radius 1 spacing 2 m\nstep 0.01\nrecord time\nstage a\ncycles 8\n",
              rows[k].trades, rows[k].particles);
    CU_ASSERT_EQUAL(begin_without_trials(&advice, &query, &page, scene.text),
                    rows[k].variants ? NB_FAILED : NB_BAD_USE);
    CU_ASSERT_EQUAL(advice.variant_count, rows[k].variants);
    finish(&advice, &page);
    free(scene.text);
  }
  free(eight.text), free(most.text);
}

/* A mean over realizations leaves out neither a variant with the values of the page nor one whose values are far from
 * its own: the kinetic energy increases with the square of the rate, so it is about 100 times as large, and the
 * tolerance 10 times the energy. */
static void a_mean_keeps_equal_and_distant_variants(void) {
  struct nb_advice advice;
  struct nb_advise_query query;
  struct page page;
  size_t of_variant[3] = {0};
  begin_mean(&advice, &query, &page, "trade rate 0.01 0.1\n");
  CU_ASSERT_EQUAL_FATAL(advice.variant_count, 3);
  for (size_t k = 0; k < advice.setting_count; k++)
    of_variant[advice.settings[k].variant]++;
  for (size_t v = 0; v < 3; v++) {
    CU_ASSERT(of_variant[v] > 0);
    CU_ASSERT(!advice.variants[v].equal && advice.variants[v].distance == 0);
  }
  const size_t setting = advice.setting_count - 1;
  CU_ASSERT(advice.settings[setting].variant == 2 && advice.settings[setting].ratio > 2);
  finish(&advice, &page);
}

/* A setting is looser than the page if it has a longer step, another law or another value; the page itself with a
 * shorter step is not looser. */
static void checks_may_fail_with_a_looser_setting(void) {
  for (int level = -2; level <= 2; level++)
    for (size_t variant = 0; variant < 3; variant++) {
      const struct nb_setting setting = {.variant = variant, .level = level};
      CU_ASSERT_EQUAL(nb_setting_loosens(&setting), level < 0 || variant != 0);
    }
}

static void words_of_steps_of_times_and_of_failure(void) {
  static const struct {
    double refine;
    const char *text;
  } rows[] = {{1, "that of the page"},
              {0.5, "2 times as long as that of the page"},
              {1.0 / 128, "128 times as long as that of the page"},
              {4.0 / 7, "1.75 times as long as that of the page"},
              {8, "8 times as short as that of the page"}};
  char text[NB_NAME_SIZE];
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    nb_refine_text(text, sizeof text, rows[k].refine);
    CU_ASSERT_STRING_EQUAL(text, rows[k].text);
  }
  double five[] = {0.5, 0.125, 4, 0.25, 2}, same[] = {3, 3, 1};
  nb_times_text(text, sizeof text, five, 5);
  CU_ASSERT_STRING_EQUAL(text, "0.5 s (0.125 to 4)");
  nb_times_text(text, sizeof text, same, 3);
  CU_ASSERT_STRING_EQUAL(text, "3 s (1 to 3)");
  CU_ASSERT_STRING_EQUAL(nb_advice_remedy(&(struct nb_advice){.exhausted = false}), "choose a larger tolerance");
  CU_ASSERT_STRING_EQUAL(nb_advice_remedy(&(struct nb_advice){.exhausted = true}),
                         "the budget was used up: choose a larger --budget or a larger tolerance");
}

/* Three runs have the values 1, 2, 3, 4; 0, 0, 0, 6; and four zeros. Their sample standard deviations are (5/3)^(1/2),
 * 3 and 0. */
static void the_scatter_is_that_of_the_worst_run(void) {
  static const double zero[SETTINGS] = {0};
  double values[3 * NB_TRIALS] = {1, 2, 3, 4};
  struct made_up it;
  make_up(&it, zero, (const int[SETTINGS]){0}, zero);
  values[NB_TRIALS + 3] = 6;
  it.advice.trials = 4, it.variants[1].points[-NB_LEVEL_LOW].values = values;
  for (it.advice.runs = 1; it.advice.runs <= 3; it.advice.runs++)
    NEAR(nb_advice_scatter(&it.advice, &it.settings[1]), it.advice.runs > 1 ? 3 : sqrt(5.0 / 3), 1e-14);
}

static void variants_that_are_left_out(void) {
  static const double zero[SETTINGS] = {0};
  struct made_up it;
  make_up(&it, zero, (const int[SETTINGS]){0}, zero);
  CU_ASSERT_PTR_NULL(nb_advice_left_out(&it.advice).nearest);
  for (size_t k = 0; k < 5; k++) /* variant 0 is the page; variant 5 has settings, so no reason to leave it out */
    strcpy(it.variants[k].reason, "one");
  it.variants[0].distance = 1, it.variants[0].equal = true;
  it.variants[1].distance = 5, it.variants[2].distance = 3, it.variants[3].equal = true;
  const struct nb_left_out out = nb_advice_left_out(&it.advice);
  CU_ASSERT_EQUAL(out.equal, 1);
  CU_ASSERT_EQUAL(out.farther, 2);
  CU_ASSERT_EQUAL(out.refused, 1);
  CU_ASSERT_EQUAL(out.too_late, 0);
  CU_ASSERT_PTR_EQUAL(out.nearest, &it.variants[2]);
  it.variants[4].too_late = true;
  CU_ASSERT_EQUAL(nb_advice_left_out(&it.advice).refused, 0);
  CU_ASSERT_EQUAL(nb_advice_left_out(&it.advice).too_late, 1);
}

void suite_advise(void) {
  CU_pSuite suite = CU_add_suite("advise", NULL, NULL);
  CU_ADD_TEST(suite, the_cheaper_of_two_settings);
  CU_ADD_TEST(suite, softer_contacts_must_save_updates);
  CU_ADD_TEST(suite, the_next_cheaper_and_the_most_accurate_setting);
  CU_ADD_TEST(suite, checks_may_fail_with_a_looser_setting);
  CU_ADD_TEST(suite, words_of_steps_of_times_and_of_failure);
  CU_ADD_TEST(suite, levels_divide_all_numbers_of_cycles);
  CU_ADD_TEST(suite, the_scatter_is_that_of_the_worst_run);
  CU_ADD_TEST(suite, variants_that_are_left_out);
  CU_ADD_TEST(suite, variants_after_the_budget);
  CU_ADD_TEST(suite, laws_are_equal_in_every_run);
  CU_ADD_TEST(suite, a_variant_stores_what_both_its_laws_store);
  CU_ADD_TEST(suite, the_anchor_is_two_levels_finer);
  CU_ADD_TEST(suite, steps_that_do_not_halve_are_tried);
  CU_ADD_TEST(suite, a_phase_of_an_impact_is_a_moment_of_first_touch);
  CU_ADD_TEST(suite, claims_follow_from_the_values);
  CU_ADD_TEST(suite, laws_have_a_distance_from_the_anchor);
  CU_ADD_TEST(suite, the_cost_is_counted);
  CU_ADD_TEST(suite, phases_of_pages_without_impact_have_different_steps);
  CU_ADD_TEST(suite, pages_whose_case_depends_on_the_step_have_one_phase);
  CU_add_test(suite, "the time of a setting that cannot run", the_time_of_a_setting_that_cannot_run);
  CU_add_test(suite, "when softer contacts save nothing", when_softer_contacts_save_nothing);
  CU_add_test(suite, "a trial that would end after the budget", a_trial_that_would_end_after_the_budget);
  CU_ADD_TEST(suite, a_trial_of_a_mean_is_a_realization);
  CU_ADD_TEST(suite, claims_of_a_mean_follow_from_its_realizations);
  CU_ADD_TEST(suite, settings_of_a_mean_have_a_margin_of_stability);
  CU_ADD_TEST(suite, variants_are_all_combinations);
  CU_ADD_TEST(suite, variants_with_the_laws_of_the_page);
  CU_ADD_TEST(suite, no_softer_contacts_after_a_start);
  CU_ADD_TEST(suite, the_divisor_is_that_of_all_cycles_of_the_page);
  CU_ADD_TEST(suite, the_largest_page_and_the_most_variants);
  CU_ADD_TEST(suite, a_mean_keeps_equal_and_distant_variants);
}
