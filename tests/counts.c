/* The counts of the calibration of `nineball advise`, for draws whose fractions and quantiles are known.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "calibration/counts.h"
#include "suites.h"

static void the_quantile_has_the_nearest_rank(void) {
  double values[] = {5, NAN, 1, 4, INFINITY, 2, 3, NAN};
  CU_ASSERT_EQUAL(quantile(values, 8, 0), 1);
  CU_ASSERT_EQUAL(quantile(values, 8, 0.05), 1);
  CU_ASSERT_EQUAL(quantile(values, 8, 0.19), 2); /* rank 0.95 of 0 to 5 */
  CU_ASSERT_EQUAL(quantile(values, 8, 0.45), 3);
  CU_ASSERT_EQUAL(quantile(values, 8, 0.9), INFINITY);
  CU_ASSERT(isnan(quantile(values + 6, 2, 0.5)));
  CU_ASSERT(isnan(quantile(values, 0, 0.5)));
}

enum { COUNT = 100, PER_KIND = 20 };

/* Five kinds with twenty draws each. All errors are within the tolerance, all costs are 1, and all claims (estimated
 * over true error) are 2. */
static struct draw *make_draws(void) {
  struct draw *draws = calloc(COUNT, sizeof *draws);
  CU_ASSERT_PTR_NOT_NULL_FATAL(draws);
  for (size_t k = 0; k < COUNT; k++) {
    snprintf(draws[k].kind, sizeof draws[k].kind, "kind %zu", k / PER_KIND);
    draws[k].met = true;
    draws[k].held_out = k % 2 != 0;
    for (int e = 0; e < ESTIMATORS; e++)
      draws[k].choices[e] = (struct choice){0.5, 1, 2};
  }
  return draws;
}

/* A bit set of the criteria that do not hold for the whole estimator. */
static unsigned failures(const struct draw *draws) {
  const struct score score = score_of(draws, COUNT, WHOLE, BOTH_HALVES);
  unsigned set = 0;
  for (int k = 0; k < CRITERIA; k++)
    set |= criterion_holds(&score, (enum criterion)k) ? 0 : 1U << k;
  return set;
}

static struct choice *whole(struct draw *draw) { return &draw->choices[WHOLE]; }

static void all_criteria_hold(void) {
  struct draw *draws = make_draws();
  CU_ASSERT_EQUAL(failures(draws), 0);
  whole(draws)->cost = whole(draws + 1)->claim = whole(draws + 2)->claim = NAN;
  const struct score score = score_of(draws, COUNT, WHOLE, BOTH_HALVES);
  CU_ASSERT(score.answered == COUNT && score.costs == COUNT - 1 && score.claims == COUNT - 2);
  free(draws);
}

/* One answer in each of the five kinds misses the tolerance, so 95 of 100 are within it. Then one more misses it. */
static void within_in_95_percent(void) {
  struct draw *draws = make_draws();
  for (size_t k = 0; k < COUNT; k += PER_KIND)
    whole(&draws[k])->error = k ? 1.001 : INFINITY;
  CU_ASSERT_EQUAL(failures(draws), 0);
  whole(&draws[1])->error = 1.001;
  CU_ASSERT_EQUAL(failures(draws), 1U << WITHIN);
  whole(&draws[1])->error = 1; /* an error equal to the tolerance is within it */
  CU_ASSERT_EQUAL(failures(draws), 0);
  free(draws);
}

/* First two of the twenty draws of a kind miss the tolerance, then three. */
static void within_in_90_percent_of_each_kind(void) {
  struct draw *draws = make_draws();
  whole(&draws[40])->error = whole(&draws[41])->error = 2;
  CU_ASSERT_EQUAL(failures(draws), 0);
  whole(&draws[42])->error = 2;
  CU_ASSERT_EQUAL(failures(draws), 1U << WITHIN_KIND);
  const struct score score = score_of(draws, COUNT, WHOLE, BOTH_HALVES);
  CU_ASSERT_STRING_EQUAL(score.worst_kind, "kind 2");
  CU_ASSERT_EQUAL(score.worst_fraction, 17.0 / 20);
  CU_ASSERT_EQUAL(score_of(draws, COUNT, TWO_STEPS, BOTH_HALVES).worst_fraction, 1);
  const struct score kind = score_of_kind(draws, COUNT, "kind 2");
  CU_ASSERT(kind.draws == 20 && kind.answered == 20 && kind.within == 17);
  free(draws);
}

/* The fraction of answers is taken over the draws for which some setting meets the tolerance (`met`). A draw without an
 * answer lowers this fraction and no other. */
static void answers_to_70_percent(void) {
  struct draw *draws = make_draws();
  for (size_t k = 0; k < 30; k++)
    *whole(&draws[k]) = (struct choice){NAN, NAN, NAN};
  CU_ASSERT_EQUAL(failures(draws), 0);
  *whole(&draws[30]) = (struct choice){NAN, NAN, NAN};
  CU_ASSERT_EQUAL(failures(draws), 1U << ANSWERS);
  draws[30].met = draws[29].met = false;
  CU_ASSERT_EQUAL(failures(draws), 0);
  for (size_t k = 0; k < COUNT; k++)
    draws[k].met = false;
  CU_ASSERT_EQUAL(failures(draws), 1U << ANSWERS);
  free(draws);
}

static void costs_in_the_median_and_at_90_percent(void) {
  struct draw *draws = make_draws();
  for (size_t k = 0; k < COUNT; k++)
    whole(&draws[k])->cost = k < 60 ? 2 : k < 91 ? 4 : 40;
  CU_ASSERT_EQUAL(failures(draws), 0);
  for (size_t k = 0; k < 20; k++)
    whole(&draws[k])->cost = 2.5;
  CU_ASSERT_EQUAL(failures(draws), 1U << COST_MEDIAN);
  whole(&draws[80])->cost = whole(&draws[81])->cost = 4.1;
  CU_ASSERT_EQUAL(failures(draws), 1U << COST_MEDIAN | 1U << COST_MOST);
  free(draws);
}

static void claims_in_the_median_and_at_5_percent(void) {
  struct draw *draws = make_draws();
  for (size_t k = 0; k < COUNT; k++)
    whole(&draws[k])->claim = k < 5 ? 0.5 : k < 55 ? 1 : 9;
  CU_ASSERT_EQUAL(failures(draws), 0);
  whole(&draws[5])->claim = 0.9;
  CU_ASSERT_EQUAL(failures(draws), 1U << CLAIM_LEAST);
  for (size_t k = 6; k < 60; k++)
    whole(&draws[k])->claim = 3.1;
  CU_ASSERT_EQUAL(failures(draws), 1U << CLAIM_LEAST | 1U << CLAIM_MEDIAN);
  for (size_t k = 0; k < 60; k++)
    whole(&draws[k])->claim = 0.9;
  CU_ASSERT_EQUAL(failures(draws), 1U << CLAIM_LEAST | 1U << CLAIM_MEDIAN);
  for (size_t k = 0; k < COUNT; k++)
    whole(&draws[k])->claim = NAN; /* nothing is known */
  CU_ASSERT_EQUAL(failures(draws), 1U << CLAIM_LEAST | 1U << CLAIM_MEDIAN);
  free(draws);
}

static void halves_are_counted_apart(void) {
  struct draw *draws = make_draws();
  for (size_t k = 1; k < 13; k += 2)
    whole(&draws[k])->error = 3, whole(&draws[k])->cost = 7, whole(&draws[k])->claim = 0.7;
  const struct score tuned = score_of(draws, COUNT, WHOLE, TUNED), held = score_of(draws, COUNT, WHOLE, HELD_OUT);
  CU_ASSERT(tuned.draws == 50 && tuned.within == 50 && tuned.worst_fraction == 1);
  CU_ASSERT(held.draws == 50 && held.within == 44 && held.worst_fraction == 0.4);
  CU_ASSERT(tuned.cost[2] == 1 && held.cost[2] == 7);
  CU_ASSERT(tuned.claim[0] == 2 && held.claim[0] == 0.7);
  free(draws);
}

static void the_fraction_that_is_enough(void) {
  CU_ASSERT(is_enough(19, 20));
  CU_ASSERT(!is_enough(18, 19));
  CU_ASSERT(is_enough(0, 0));
}

/* About half of the names are held out. */
static void names_of_pages_decide_the_half(void) {
  size_t held = 0;
  for (int k = 0; k < 1000; k++) {
    char name[32];
    snprintf(name, sizeof name, "page-%d", k);
    held += is_held_out(name);
  }
  CU_ASSERT(held > 437 && held < 563); /* four standard deviations of the binomial distribution */
}

static void failures_are_written(void) {
  struct draw *draws = make_draws();
  char text[256] = "";
  for (size_t k = 0; k < 4; k++)
    whole(&draws[k])->error = 2;
  for (size_t k = 0; k < COUNT; k++)
    whole(&draws[k])->cost = 3;
  const struct score score = score_of(draws, COUNT, WHOLE, BOTH_HALVES);
  FILE *file = tmpfile();
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  CU_ASSERT_EQUAL(write_failures(file, &score), 2);
  rewind(file);
  CU_ASSERT_PTR_NOT_NULL(fgets(text, sizeof text, file));
  fclose(file);
  CU_ASSERT_STRING_EQUAL(text,
                         "within the tolerance in 90 % of each kind (kind 0: 80 %); cost at most 2 in the median");
  free(draws);
}

void suite_counts(void) {
  CU_pSuite suite = CU_add_suite("counts", NULL, NULL);
  CU_ADD_TEST(suite, the_quantile_has_the_nearest_rank);
  CU_ADD_TEST(suite, all_criteria_hold);
  CU_ADD_TEST(suite, within_in_95_percent);
  CU_ADD_TEST(suite, within_in_90_percent_of_each_kind);
  CU_ADD_TEST(suite, answers_to_70_percent);
  CU_ADD_TEST(suite, costs_in_the_median_and_at_90_percent);
  CU_ADD_TEST(suite, claims_in_the_median_and_at_5_percent);
  CU_ADD_TEST(suite, halves_are_counted_apart);
  CU_ADD_TEST(suite, the_fraction_that_is_enough);
  CU_ADD_TEST(suite, names_of_pages_decide_the_half);
  CU_ADD_TEST(suite, failures_are_written);
}
