/* Estimates of errors from several steps, on sequences whose limit and order are known.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>

#include "../src/report/estimate.h"
#include "report/cost.h"
#include "suites.h"

static const struct nb_ratios halved = {2, 2};

/* Q(n) = 5 - 3/n^p: the error of Q(n) is 3/n^p. */
static double term(double n, double order) { return 5 - 3 / pow(n, order); }

static void richardson_finds_the_error_of_a_power(void) {
  static const double orders[] = {0.5, 1, 1.5, 2};
  for (size_t k = 0; k < sizeof orders / sizeof *orders; k++) {
    const double p = orders[k];
    NEAR(nb_estimate_step(term(10, p), term(20, p), term(40, p), halved), 3 / pow(10, p), 1e-9);
    NEAR(nb_estimate_step(-term(10, p), -term(20, p), -term(40, p), halved), 3 / pow(10, p), 1e-9);
  }
}

/* Steps that are not halved. The estimate is never below the error. It is at most 1.71 times as large, namely for the
 * order 2 and three steps of the ratio 1.5. */
static void other_ratios_give_no_smaller_estimate(void) {
  for (double p = 0.5; p <= 2; p += 0.25)
    for (double first = 1.5; first <= 2; first += 0.125)
      for (double second = 1.5; second <= 2; second += 0.125) {
        const double n2 = 10 * first, n4 = n2 * second, error = 3 / pow(10, p);
        const double ratio =
            nb_estimate_step(term(10, p), term(n2, p), term(n4, p), (struct nb_ratios){first, second}) / error;
        CU_ASSERT(ratio >= 1 - 1e-9 && ratio <= 1.71);
      }
}

/* Each difference is divided by the logarithm of its ratio, with the base 2: d_1 = 1 and d_2 = 1/2 give the order 1. */
static void each_difference_has_its_ratio(void) {
  NEAR(nb_estimate_step(0, 1, 1.25, (struct nb_ratios){2, sqrt(2)}), 2.0, 1e-14);
  NEAR(nb_estimate_step(0, 0.5, 1, (struct nb_ratios){sqrt(2), 2}), 2.0, 1e-14);
}

/* The order follows from the differences d_1 = 1 and d_2 of successive values, within limits: order 3 counts as order
 * 2, and order 0.2 as order 0.5. */
static void the_order_is_limited(void) {
  NEAR(nb_estimate_step(0, 1, 1 + exp2(-3), halved), 4.0 / 3, 1e-14);
  NEAR(nb_estimate_step(0, 1, 1 + exp2(-0.2), halved), sqrt(2) / (sqrt(2) - 1), 1e-14);
}

static void differences_that_do_not_shrink(void) {
  CU_ASSERT_EQUAL(nb_estimate_step(0, 1, 2, halved), 3);
  CU_ASSERT_EQUAL(nb_estimate_step(0, 1, -1, halved), 6);
  CU_ASSERT_EQUAL(nb_estimate_step(4, 4, 3, halved), 3);
  CU_ASSERT_EQUAL(nb_estimate_step(7, 7, 7, halved), 0);
  NEAR(nb_estimate_step(8, 7, 7, halved), 4.0 / 3, 1e-14); /* d_2 = 0: the order is the highest one */
}

static void what_is_not_finite_has_no_estimate(void) {
  static const double bad[] = {NAN, INFINITY, -INFINITY};
  for (size_t k = 0; k < 3; k++) {
    double step;
    const double one[] = {1, 1}, with[] = {1, bad[k]};
    CU_ASSERT_EQUAL(nb_estimate_step(bad[k], 1, 1, halved), INFINITY);
    CU_ASSERT_EQUAL(nb_estimate_step(1, bad[k], 1, halved), INFINITY);
    CU_ASSERT_EQUAL(nb_estimate_step(1, 1, bad[k], halved), INFINITY);
    CU_ASSERT_EQUAL(nb_estimate_error(&step, with, one, one, 2, halved, (struct nb_anchor){1, 0}), INFINITY);
    CU_ASSERT_EQUAL(step, INFINITY);
    CU_ASSERT_EQUAL(nb_estimate_error(&step, one, one, one, 2, halved, (struct nb_anchor){bad[k], 0}), INFINITY);
    CU_ASSERT_EQUAL(nb_estimate_error(&step, one, one, one, 2, halved, (struct nb_anchor){1, fabs(bad[k])}), INFINITY);
    CU_ASSERT(!isfinite(nb_estimate_anchor(with, one, 2).uncertainty));
    CU_ASSERT(!isfinite(nb_estimate_anchor(one, with, 2).uncertainty));
  }
}

/* The mean over the phases is 1.5, with twice the step it is 3, and the phases differ by 2 - 1. The uncertainty is
 * U = 3 (3 - 1.5) + (2 - 1). */
static void the_anchor_has_an_uncertainty(void) {
  const double fine[] = {1, 2}, coarse[] = {2, 4};
  const struct nb_anchor anchor = nb_estimate_anchor(fine, coarse, 2);
  CU_ASSERT_EQUAL(anchor.value, 1.5);
  CU_ASSERT_EQUAL(anchor.uncertainty, 5.5);
  const struct nb_anchor first = nb_estimate_anchor(fine, coarse, 1);
  CU_ASSERT_EQUAL(first.value, 1);
  CU_ASSERT_EQUAL(first.uncertainty, 3);
}

/* The phase with the largest error decides, whichever phase this is. */
static void a_claim_is_that_of_the_worst_phase(void) {
  double step;
  for (size_t worst = 0; worst < 3; worst++) {
    double n[] = {1, 1, 1}, n2[] = {1, 1, 1}, n4[] = {1, 1, 1};
    n[worst] = 0.5;
    CU_ASSERT_EQUAL(nb_estimate_error(&step, n, n2, n4, 3, halved, (struct nb_anchor){1, 0.125}),
                    0.75); /* 1.25 times the difference 0.5, plus 0.125 */
    NEAR(step, 0.5 * 4 / 3, 1e-14);
    CU_ASSERT_EQUAL(nb_estimate_error(&step, n, n2, n4, 3, halved, (struct nb_anchor){1, 0}), step);
    n[worst] = n2[worst] = 1, n4[worst] = 3;
    CU_ASSERT_EQUAL(nb_estimate_error(&step, n, n2, n4, 3, halved, (struct nb_anchor){1, 0}), 6); /* 3 |d_2| */
  }
  const double first[] = {term(10, 1)}, second[] = {term(20, 1)}, third[] = {term(40, 1)};
  NEAR(nb_estimate_error(&step, first, second, third, 1, halved, (struct nb_anchor){first[0], 0}), 0.3, 1e-14);
  const double two[] = {2, 2};
  CU_ASSERT_EQUAL(nb_estimate_error(&step, two, two, two, 2, halved, (struct nb_anchor){1, 0}), 1.25);
  CU_ASSERT_EQUAL(nb_estimate_error(&step, two, two, two, 2, halved, (struct nb_anchor){3, 0}), 1.25);
  CU_ASSERT_EQUAL(step, 0);
}

/* Differences 1, 3, 2, 6: mean 3, s^2 = 14/3, s/m^(1/2) = (7/6)^(1/2). */
static void the_error_of_a_mean(void) {
  const double n[] = {11, 23, 32, 46}, anchor[] = {10, 20, 30, 40};
  double difference;
  NEAR(nb_estimate_mean(&difference, n, anchor, 4, 2), 3 + 2 * sqrt(7.0 / 6), 1e-14);
  CU_ASSERT_EQUAL(difference, 3);
  NEAR(nb_estimate_mean(&difference, anchor, n, 4, 2), 3 + 2 * sqrt(7.0 / 6), 1e-14);
  CU_ASSERT_EQUAL(difference, 3);
  CU_ASSERT_EQUAL(nb_estimate_mean(&difference, n, n, 4, 2), 0);
  const double bad[] = {11, NAN, 32, 46};
  CU_ASSERT_EQUAL(nb_estimate_mean(&difference, bad, anchor, 4, 2), INFINITY);
  CU_ASSERT_EQUAL(nb_estimate_mean(&difference, n, bad, 4, 2), INFINITY);
}

/* Realizations that share most of their scatter, with a difference of 0.3 between the means. A claim holds if it is not
 * below this difference. The confidence interval is two-sided and a claim is one-sided, so at least 95 % of the claims
 * hold. The tolerance 0.004 is 2.6 standard errors of a fraction of 0.95 of 20000. */
static void most_claims_of_a_mean_hold(void) {
  enum { SAMPLES = 20000, COUNT = 8 };
  gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
  const double quantile = gsl_cdf_tdist_Pinv(0.975, COUNT - 1), shift = 0.3;
  size_t held = 0, held_by_mean_alone = 0;
  for (size_t k = 0; k < SAMPLES; k++) {
    double n[COUNT], anchor[COUNT], difference;
    for (size_t i = 0; i < COUNT; i++) {
      anchor[i] = gsl_ran_gaussian(random, 5);
      n[i] = anchor[i] + shift + gsl_ran_gaussian(random, 1);
    }
    held += nb_estimate_mean(&difference, n, anchor, COUNT, quantile) >= shift;
    held_by_mean_alone += difference >= shift;
  }
  CU_ASSERT((double)held >= (0.95 - 0.004) * SAMPLES);
  CU_ASSERT((double)held_by_mean_alone < 0.7 * SAMPLES);
  gsl_rng_free(random);
}

/* A time is mentioned if it is shorter or longer than the expected one by more than a fifth. */
static void a_time_that_differs(void) {
  static const double differ[] = {0, 3, 3.9, 6.1, 100}, agree[] = {4.1, 5, 5.9};
  for (size_t k = 0; k < 5; k++)
    CU_ASSERT(nb_time_differs(differ[k], 5));
  for (size_t k = 0; k < 3; k++)
    CU_ASSERT(!nb_time_differs(agree[k], 5));
}

void suite_estimate(void) {
  CU_pSuite suite = CU_add_suite("estimate", NULL, NULL);
  CU_ADD_TEST(suite, richardson_finds_the_error_of_a_power);
  CU_ADD_TEST(suite, other_ratios_give_no_smaller_estimate);
  CU_ADD_TEST(suite, each_difference_has_its_ratio);
  CU_ADD_TEST(suite, the_order_is_limited);
  CU_ADD_TEST(suite, differences_that_do_not_shrink);
  CU_ADD_TEST(suite, what_is_not_finite_has_no_estimate);
  CU_ADD_TEST(suite, the_anchor_has_an_uncertainty);
  CU_ADD_TEST(suite, a_claim_is_that_of_the_worst_phase);
  CU_ADD_TEST(suite, the_error_of_a_mean);
  CU_ADD_TEST(suite, most_claims_of_a_mean_hold);
  CU_ADD_TEST(suite, a_time_that_differs);
}
