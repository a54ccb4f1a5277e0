/* The verdict on several runs: trends and orders, at both edges of the tolerance.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "planted.h"
#include "suites.h"

#define NEXT 1e-12

static void trends(void) {
  static const struct planted_sweep list[] = {
      {"sweep v 1 2 3", "A.x increases with v", {1, 2, 3}, NB_PASS, "computed 1 at v = 1, 2 at 2, 3 at 3"},
      {"sweep v 1 2 3", "A.x increases with v", {1, 1 + NEXT, 3}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x increases with v", {1, 1, 3}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x increases with v", {1, 3, 3}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x increases with v", {2, 1, 3}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x increases with v", {1, 3, 2}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x increases with v", {-3, -2, -1}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {3, 2, 1}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {3, 3 - NEXT, 1}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {3, 3, 1}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {3, 1, 2}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {2, 3, 1}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x decreases with v", {1, 2, 3}, NB_FAIL, ""},
      {"sweep v with w  1 5   2 4   3 3",
       "A.x decreases with w",
       {1, 2, 3},
       NB_PASS,
       "computed 3 at w = 3, 2 at 4, 1 at 5"},
      {"sweep v 3 1 2", "A.x increases with v", {3, 1, 2}, NB_PASS, "computed 1 at v = 1, 2 at 2, 3 at 3"},
      {"sweep v 3 1 2", "A.x increases with v", {1, 2, 3}, NB_FAIL, ""},
      {"sweep v 1e2 9", "A.x increases with v", {2, 1}, NB_PASS, ""},
      {"sweep v -1 -2", "A.x decreases with v", {1, 2}, NB_PASS, ""},
      {"sweep v two one", "A.x increases with v", {1, 2}, NB_PASS, "computed 1 at v = two, 2 at one"},
      {"let a = 1\nsweep v 1 2\nlet b = v", "A.x increases with v", {1, 2}, NB_PASS, "computed 1 at v = 1, 2 at 2"},
      {"sweep v one two", "A.x increases with v", {1, 2}, NB_PASS, "computed 1 at v = one, 2 at two"},
      {"sweep v 1 2 3", "A.x increases with v", {1, NAN, 3}, NB_FAIL, "it is nan"},
      {"sweep v with w  1 p  1 q  2 p", /* equal values keep the order of the runs */
       "A.x increases with v",
       {5, 4, 6},
       NB_FAIL,
       "computed 5 at v = 1, 4 at 1, 6 at 2"},
      {"sweep v 1 2 3", "A.x decreases with v", {3, 2, -INFINITY}, NB_FAIL, "it is -inf"},
  };
  planted_sweeps(list, COUNT(list));
}

static void constant(void) {
  static const struct planted_sweep list[] = {
      {"sweep v 1 2 3", "A.x constant with v within 1", {1, 2, 1.5}, NB_PASS, "computed 1 at v = 1, 2 at 2, 1.5 at 3"},
      {"sweep v 1 2 3", "A.x constant with v within 1", {1, 2 + NEXT, 1.5}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x constant with v within 1", {2, 1.5, 1}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x constant with v within 1", {2, 1.5, 1 - NEXT}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x constant with v within 1", {-1, -1.5, -2}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x constant with v within 1", {-1, -1.5, -2 - NEXT}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x constant with v within 0", {7, 7, 7}, NB_PASS, ""},
      {"sweep v b a", "A.x constant with v within 0", {7, 8}, NB_FAIL, "computed 7 at v = b, 8 at a"},
      {"sweep v 1 2 3", "A.x constant with v within 0", {7, 7 + NEXT, 7}, NB_FAIL, ""},
      {"sweep v 1 2 3",
       "A.x constant with v within 50 %",
       {3, 5, 4},
       NB_PASS,
       ", largest difference 50 %, tolerance 50 %"}, /* 2 of a mean of 4 */
      {"sweep v 1 2 3", /* percentages that would be rounded to other digits if they were a thousandth larger */
       "A.x constant with v within 24.945 %",
       {3.7011, 4.2989, 4},
       NB_PASS,
       "computed 3.7011 at v = 1, 4.2989 at 2, 4 at 3, largest difference 14.9 %, tolerance 24.9 %"},
      {"sweep v 1 2 3", "A.x constant with v within 50 %", {3, 5 + NEXT, 4}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x constant with v within 50 %", {-3, -5, -4}, NB_PASS, ""},
      {"sweep v 1 2 3", "A.x constant with v within 50 %", {-3, -5 - NEXT, -4}, NB_FAIL, ""},
      {"sweep v 1 2 3", "A.x constant with v within 1e300", {1, NAN, 1}, NB_FAIL, "it is nan"},
      {"sweep v 1 2 3", "A.x constant with v within 1e300", {1, 1, INFINITY}, NB_FAIL, "it is inf"},
      {"sweep v 1 2 3",
       "A.x constant with v within 1e20 %",
       {1e308, 1e308, 1e308},
       NB_FAIL,
       ""}, /* their sum is not finite */
      {"sweep v 1 2", "A.x max in two constant with v within 1", {1, 1}, NB_FAIL, "cannot be computed"},
  };
  planted_sweeps(list, COUNT(list));
}

/* Errors h^s at h = 1, 2, 4. Because of rounding, s is not exactly at the edge but 1e-9 inside or outside. */
#define ERRORS(s)                                                                                                      \
  { 1, exp2(s), exp2(2 * (s)) }

static void orders(void) {
  const struct planted_sweep list[] = {
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(2), NB_PASS,
       "computed order 2, expected 2, error 0, tolerance 0.5: errors 1 at h = 1, 4 at 2, 16 at 4"},
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(2.5 - 1e-9), NB_PASS, "computed order 2.5"},
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(2.4994), NB_PASS, "error 0.499, tolerance 0.5"},
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(2.5 + 1e-9), NB_FAIL, ""},
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(1.5 + 1e-9), NB_PASS, ""},
      {"sweep h 1 2 4", "A.x order 2 in h within 0.5", ERRORS(1.5 - 1e-9), NB_FAIL, "computed order 1.5"},
      {"sweep h 1 2 4", "A.x order -2 in h within 25 %", ERRORS(-2.5 + 1e-9), NB_PASS, ""},
      {"sweep h 1 2 4", "A.x order 2 in h within 25 %", ERRORS(2.2), NB_PASS, "error 10 %, tolerance 25 %"},
      {"sweep n 1 2 4", "A.x order 2 in n within 0.5", ERRORS(-2), NB_FAIL,
       "; the error falls as `n` grows: write `A.x order -2 in n within 0.5`"},
      {"sweep h 1 2 4", "A.x order -2 in h within 0.5", ERRORS(2), NB_FAIL,
       "; the error grows as `h` grows: write `A.x order 2 in h within 0.5`"},
      {"sweep h 1 2 4", "A.x order -1 in h within 0.5", ERRORS(2), NB_FAIL, "write `A.x order 1 in h within 0.5`"},
      {"sweep h 1 2 4", "A.x order -2 in h within 25 %", ERRORS(-2.5 - 1e-9), NB_FAIL, ""},
      {"sweep h 1 2 4", "A.x order 0 in h within 0.5", ERRORS(1), NB_FAIL, "; a contact that begins or ends between"},
      {"sweep h 1 2 4", "A.x order 2 in h within 1e-9", {-1, 4, -16}, NB_PASS, ""}, /* an error has no sign */
      {"sweep h 3 1 2", "A.x order 1 in h within 1e-9", {6, 2, 4}, NB_PASS, ""},
      /* log2 of the errors is 0, 1, 4 at log2(h) = 0, 1, 2: the best line has the slope 2 and passes through none of
       * the points */
      {"sweep h 1 2 4", "A.x order 2 in h within 1e-9", {1, 2, 16}, NB_PASS, ""},
      {"sweep h 1 2 4", "energy.balance order 2 in h within 1e-9", {1, 4, 16}, NB_PASS, ""},
      {"sweep h 1 2 4",
       "A.x order 2 in h within 9",
       {1, 0, 16},
       NB_FAIL,
       "the error at 2 is 0, so it has no logarithm"},
      {"sweep h 1 2 4", "A.x order 2 in h within 9", {1, INFINITY, 16}, NB_FAIL, "it is inf"},
      {"sweep h 1 2 4", "A.y order 2 in h within 9", {1, 4, 16}, NB_FAIL, "the reference does not return `A.y`"},
      {"sweep h 1 0 4", "A.x order 2 in h within 9", {1, 4, 16}, NB_FAIL, "`0` is not a number above 0"},
      {"sweep h 1 -2 4", "A.x order 2 in h within 9", {1, 4, 16}, NB_FAIL, "`-2` is not a number above 0"},
      {"sweep h one two four", "A.x order 2 in h within 9", {1, 4, 16}, NB_FAIL, "`one` is not a number above 0"},
      {"sweep h 1 2", "A.x order 1 in h within 9", {1.4945, 2.4945}, NB_PASS, ": errors 1.49 at h = 1, 2.49 at 2"},
      {"sweep h 1 ppm 2 ppm 4 ppm", "A.x order 2 in h within 1e-9", {1, 4, 16}, NB_PASS, "4 at 2 ppm"},
      {"sweep h 1 ppm 0.1 %", "A.x order 1 in h within 1e-9", {1, 1000}, NB_PASS, "1e+03 at 0.001"},
  };
  planted_sweeps(list, COUNT(list));
  struct nb_outcome outcome; /* the error of each run is from its own reference */
  planted_page(&outcome, "sweep h 1 2 4", "A.x order 1 in h within 1e-9");
  planted_runs(&outcome, (double[]){11, 22, 34});
  for (size_t r = 0; r < 3; r++)
    solution_value(&outcome.runs[r].solution, 10 * (double)(r + 1), "A.x");
  planted_is(&outcome, NB_PASS);
  nb_outcome_free(&outcome);
  planted_page(&outcome, "sweep w 5 6\nsweep h 1 2", "A.x order 1 in h within 1e-9"); /* for each w separately */
  planted_runs(&outcome, (double[]){1, 2, 1, 4});
  planted_solution(&outcome, "A.x", 0);
  planted_is(&outcome, NB_PASS);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 2);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message,
                         "computed order 1, expected 1, error 0, tolerance 1e-09: errors 1 at h = 1, 2 at 2");
  CU_ASSERT_STRING_EQUAL(
      outcome.checks[1].message,
      "computed order 2, expected 1, error 1, tolerance 1e-09: errors 1 at h = 1, 4 at 2; a contact that "
      "begins or ends between two steps adds an error without an order: let the particles touch from the "
      "start to the end of the run");
  CU_ASSERT_EQUAL(outcome.checks[1].mark, NB_FAIL);
  nb_outcome_free(&outcome);
  planted_page(&outcome, "sweep h 1 2 4", "A.x order 1 in h within 1e300");
  planted_runs(&outcome, (double[]){11, 22, 34});
  planted_solution(&outcome, "A.x", NAN);
  planted_is(&outcome, NB_FAIL);
  planted_says(&outcome, "the error at 1 is nan");
  nb_outcome_free(&outcome);
}

/* Runs that differ in another sweep are checked separately. */
static void groups(void) {
  struct nb_outcome outcome;
  planted_page(&outcome, "sweep w 5 6\nsweep v 1 2 3", "A.x increases with v\nA.x decreases with w");
  planted_runs(&outcome, (double[]){1, 2, 3, 0, 9, 1});
  planted_is(&outcome, NB_PASS);
  static const struct {
    const char *label, *words;
    enum nb_mark mark;
  } wanted[] = {
      {"A.x increases with v (w=5)", "computed 1 at v = 1, 2 at 2, 3 at 3", NB_PASS},
      {"A.x decreases with w (v=1)", "computed 1 at w = 5, 0 at 6", NB_PASS},
      {"A.x decreases with w (v=2)", "computed 2 at w = 5, 9 at 6", NB_FAIL},
      {"A.x decreases with w (v=3)", "computed 3 at w = 5, 1 at 6", NB_PASS},
      {"A.x increases with v (w=6)", "computed 0 at v = 1, 9 at 2, 1 at 3", NB_FAIL},
  };
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, COUNT(wanted));
  for (size_t k = 0; k < COUNT(wanted); k++) {
    CU_ASSERT_STRING_EQUAL(outcome.checks[k].label, wanted[k].label);
    CU_ASSERT_STRING_EQUAL(outcome.checks[k].message, wanted[k].words);
    CU_ASSERT_EQUAL(outcome.checks[k].mark, wanted[k].mark);
  }
  CU_ASSERT(outcome.mark_count[NB_PASS] == 3 && outcome.mark_count[NB_FAIL] == 2);
  nb_outcome_free(&outcome);
  planted_page(&outcome, "sweep w 5 6\nsweep v 1 2",
               "A.x expected 1 within 0 [t]"); /* and each run has its own checks */
  planted_runs(&outcome, (double[]){1, 1, 1, 2});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 4);
  CU_ASSERT_STRING_EQUAL(outcome.checks[3].label, "A.x expected 1 within 0 [t] (w=6, v=2)");
  CU_ASSERT(outcome.checks[2].mark == NB_PASS && outcome.checks[3].mark == NB_FAIL);
  nb_outcome_free(&outcome);
  planted_page(&outcome, "sweep w 5\nsweep v 1 2", /* a sweep of one value distinguishes no runs */
               "A.x increases with v\nA.x expected 1 within 0 [t]");
  planted_runs(&outcome, (double[]){1, 2});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 3);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].label, "A.x expected 1 within 0 [t] (v=1)");
  CU_ASSERT_STRING_EQUAL(outcome.checks[1].label, "A.x expected 1 within 0 [t] (v=2)");
  CU_ASSERT_STRING_EQUAL(outcome.checks[2].label, "A.x increases with v"); /* after all runs */
  CU_ASSERT_STRING_EQUAL(outcome.runs[1].label, "v=2");
  nb_outcome_free(&outcome);
}

/* A report draws a point for each run of a group. Its x is the swept value, or the position of this value if the values
 * are words. Its y is the computed value, or the error if the expectation is an order. */
static void points(void) {
  static const struct {
    const char *sweeps, *expectation;
    double x[6];
    size_t checks, count;
    double points[6]; /* of the last check */
    const char *parts[NB_PARTS];
  } rows[] = {
      {"sweep v 1 2 4", "A.x increases with v", {3, 5, 4}, 1, 3, {1, 3, 2, 5, 4, 4}, {"", "", "", ""}},
      {"sweep v 4 1 2", "A.x decreases with v", {4, 3, 5}, 1, 3, {1, 3, 2, 5, 4, 4}, {"", "", "", ""}},
      {"sweep v 4 1 2", "A.x constant with v within 1", {4, 3, 5}, 1, 3, {1, 3, 2, 5, 4, 4}, {"", "", "2", "1"}},
      {"sweep v b a", "A.x increases with v", {7, 9}, 1, 2, {0, 7, 1, 9}, {"", "", "", ""}},
      {"sweep v 3 2\nsweep w 1 2", "A.x increases with v", {1, 2, 5, 6}, 2, 2, {2, 6, 3, 2}, {"", "", "", ""}},
      {"sweep h 2 1", "A.x order 2 in h within 0.5", {-4, 1}, 1, 2, {2, 4, 1, 1}, {"", "", "0", "0.5"}},
      {"sweep v 1 2\nsweep seed 1 2", "A.x increases with v over seed", {1, 2, 3, 4}, 1, 0, {0}, {"", "", "", ""}},
      {"sweep seed 1 2", "A.x expected 1 over seed [t]", {1, 2}, 1, 0, {0}, {"", "", "", ""}},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, rows[k].sweeps, rows[k].expectation);
    planted_runs(&outcome, rows[k].x);
    planted_solution(&outcome, "A.x", 0);
    nb_verdict(&outcome);
    CU_ASSERT_EQUAL_FATAL(outcome.check_count, rows[k].checks);
    planted_parts(&outcome, rows[k].parts);
    const struct nb_check *check = &outcome.checks[rows[k].checks - 1];
    CU_ASSERT_EQUAL_FATAL(check->point_count, rows[k].count);
    for (size_t p = 0; p < 2 * check->point_count; p++)
      CU_ASSERT_EQUAL(check->points[p], rows[k].points[p]);
    nb_outcome_free(&outcome);
  }
}

/* Messages have the unit of each value with a dimension. A ratio has none. */
static void units_of_values(void) {
  static const struct {
    const char *sweeps, *expectation, *message;
    double x[4];
  } rows[] = {
      {"", "report A.x", "computed 3 m", {3}},
      {"", "A.x below A.y", "computed 3 m and 1 m", {3}},
      {"", "A.x within 5 %", "computed 3 m, reference 0 m, error 3 m; a tolerance in % of 0 allows no error", {3}},
      {"",
       "energy.balance max below 1",
       "computed -2.5 J and 1 J; but a residual has both signs: `min` is -2.5 J, check it too",
       {-2.5}},
      {"", "energy.balance max below 1", "computed 2.5 J and 1 J", {2.5}}, /* a failed check needs no note */
      {"", /* a fraction that is too small for a percentage has no unit; A.y is 1 */
       "A.x within 1e-9 of A.y",
       "computed 5e-10 m, reference 0 m, error 5e-10, tolerance 1e-09 of A.y",
       {5e-10}},
      {"sweep v 1 2", "A.x decreases with v", "computed 1 m at v = 1, 2 m at 2", {1, 2}},
      {"sweep v 1 2",
       "A.x constant with v within 1",
       "computed 1 m at v = 1, 2 m at 2, largest difference 1 m, tolerance 1 m",
       {1, 2}},
      {"sweep v 1 2",
       "A.x order 1 in v within 0.5",
       "computed order 1, expected 1, error 0, tolerance 0.5: errors 1 m at v = 1, 2 m at 2",
       {1, 2}},
      {"sweep v 1 2", /* the sample 1 and 2 has the standard deviation 2^(-1/2) */
       "A.x expected 1 over v [t]",
       "expected 1 m, within the range of 2 runs over v: 1 to 2, mean 1.5, standard deviation 0.71; percentile 25",
       {1, 2}},
      {"sweep v 1 2", /* A.y is 1 */
       "A.x expected 1 of A.y over v [t]",
       "expected 1, within the range of 2 runs over v: 1 to 2, mean 1.5, standard deviation 0.71; percentile 25",
       {1, 2}},
      {"sweep v 1 2\nsweep s 1 2",
       "A.x increases with v over s",
       "from 1 to 2: mean difference +1 m, 95 % confidence 1 to 1, mean 5.5",
       {0, 10, 1, 11}},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, rows[k].sweeps, rows[k].expectation);
    planted_runs(&outcome, rows[k].x);
    planted_solution(&outcome, "A.x", 0);
    for (size_t r = 0; r < outcome.run_count; r++)
      outcome.runs[r].scene.unitless = false;
    nb_verdict(&outcome);
    CU_ASSERT_EQUAL_FATAL(outcome.check_count, 1);
    CU_ASSERT_STRING_EQUAL(outcome.checks[0].message, rows[k].message);
    if (strcmp(outcome.checks[0].message, rows[k].message) != 0)
      printf("# %s: %s\n", rows[k].expectation, outcome.checks[0].message);
    nb_outcome_free(&outcome);
  }
}

void suite_verdict_sweep(void) {
  CU_pSuite suite = CU_add_suite("verdict_sweep", NULL, NULL);
  CU_add_test(suite, "increases and decreases: from each value to the next", trends);
  CU_add_test(suite, "constant: both edges", constant);
  CU_add_test(suite, "order: both edges of the slope", orders);
  CU_add_test(suite, "other sweeps are checked separately", groups);
  CU_add_test(suite, "the points of a trend", points);
  CU_add_test(suite, "the units of values in messages", units_of_values);
}
