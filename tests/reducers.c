/* Reducers, which compute one number from rows: every reducer, and measures that cannot be computed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "planted.h"
#include "suites.h"

static void reducers(void) {
  static const struct {
    const char *measure;
    double value;
    int count;
    double x[6];
  } rows[] = {
      {"A.x", 3, 3, {1, 2, 3}},
      {"A.x last", 3, 3, {1, 2, 3}},
      {"A.x", 6, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x in one", 3, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x in two", 6, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x mean", 9, 4, {1, 2, 3, 9}}, /* the last stage has one row */
      {"A.x max", 5, 3, {5, 2, 3}},
      {"A.x max", 5, 3, {2, 5, 3}},
      {"A.x max", 5, 3, {2, 3, 5}},
      {"A.x max", -2, 3, {-5, -2, -3}},
      {"A.x max", 5, 6, {9, 9, 9, 4, 5, 3}},
      {"A.x max in one", 5, 6, {5, 2, 3, 9, 9, 9}},
      {"A.x max in all", 8, 6, {5, 8, 3, 4, 5, 3}},
      {"A.x min", 2, 3, {2, 5, 3}},
      {"A.x min", 2, 3, {5, 2, 3}},
      {"A.x min", 2, 3, {5, 3, 2}},
      {"A.x min in one", 2, 6, {3, 2, 4, 1, 1, 1}},
      {"A.x mean", 4, 3, {1, 2, 9}},
      {"A.x mean", 5, 6, {9, 9, 9, 1, 2, 12}},
      {"A.x mean in one", 4, 6, {1, 2, 9, 7, 7, 7}},
      {"A.x mean in all", 6, 6, {1, 2, 9, 1, 2, 21}},
      {"A.x mean", 7, 1, {7}},
      {"A.x amplitude", 3.5, 3, {-3, 1, 4}},
      {"A.x amplitude in all", 6, 6, {-3, 1, 4, 0, 9, 0}},
      {"A.x frequency in all", 0.5, 6, {-1, 1, -1, 1, -1, 1}},
      {"A.x frequency in all", 1. / 3, 6, {-1, 0, 1, -1, 0, 1}},   /* a row equals the mean */
      {"A.x frequency in all", 2 / 3.5, 6, {-1, 0, -1, 2, -1, 1}}, /* the mean is 0: crossings at 1, 7/3 and 4.5 */
      {"A.x frequency in all", 0.5, 6, {1, -1, 1, -1, 1, -1}},
      {"A.x frequency in all", 1 / 2.75, 6, {-3, 1, 1, -1, 1, 1}}, /* crossings at 0.75 and 3.5 only */
      {"A.x frequency in all", 1. / 3, 6, {-1, -1, 1, -1, -1, 1}}, /* successive rows below the mean */
      {"A.x frequency in all", 1 / 2.75, 6, {5, 9, 9, 7, 9, 9}},   /* the mean is 8: crossings at 0.75 and 3.5 only */
      {"A.x at 10 cycles", 4, 3, {1, 4, 3}},
      {"A.x at 0 cycle", 1, 3, {1, 4, 3}},
      {"A.x at 0 cycles", 1, 3, {1, 4, 3}},
      {"A.x at 40 cycles", 5, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 10 cycles in one", 2, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 1", 4, 3, {1, 4, 3}},
      {"A.x at 0", 1, 3, {1, 4, 3}},
      {"A.x at 2", 3, 3, {1, 4, 3}},
      {"A.x at 0.25", 2, 3, {1, 5, 3}},
      {"A.x at 1.25", 4.5, 3, {1, 5, 3}},
      {"A.x at 2.5", 3.5, 6, {1, 2, 3, 4, 5, 6}}, /* between two stages */
      {"A.x at 4.5 in two", 5.5, 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 1", 4, 3, {NAN, 4, 3}}, /* the row of that time, and no other */
      {"A.x at 1", 4, 3, {1, 4, NAN}},
      {"A.x at 1.5", 5, 6, {NAN, 4, 6, NAN, 5, 6}}, /* the two rows around it, and no other */
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[256];
    double seen;
    snprintf(text, sizeof text, "%s within 1\nreport %s", rows[k].measure, rows[k].measure);
    planted_page(&outcome, "", text);
    planted_rows(&outcome, 0, rows[k].count, rows[k].x);
    for (int e = 0; e < 2; e++) {
      const struct nb_measure *measure = &outcome.runs[0].expectations.list[e].measure;
      CU_ASSERT(nb_measure_value(&seen, measure, &outcome.runs[0].result.table, &error));
      if (!(fabs(seen - rows[k].value) < 1e-15))
        printf("# %s: %.17g\n", rows[k].measure, seen);
      CU_ASSERT_DOUBLE_EQUAL(seen, rows[k].value, 1e-15);
      CU_ASSERT_STRING_EQUAL(measure->unit, strstr(rows[k].measure, "frequency") ? "1/s" : "m");
    }
    nb_outcome_free(&outcome);
  }
}

/* The rows are not at 0, 1, 2, …: the reducers use the times of the table. */
static void times_of_rows(void) {
  static const double times[] = {10, 12, 15, 16, 20, 22};
  static const struct {
    const char *measure;
    double value, x[6];
  } rows[] = {
      {"A.x at 13", 3, {1, 2, 5, 4, 5, 6}},
      {"A.x at 10.5", 2, {1, 5, 5, 4, 5, 6}},
      {"A.x at 21 in two", 8, {1, 2, 5, 4, 6, 10}},
      {"A.x frequency in all", 0.2, {-1, 1, -1, 1, -1, 1}},     /* crossings at 11, 15.5 and 21 */
      {"A.x frequency in all", 1 / 10.5, {-1, 1, 2, 0, -3, 1}}, /* the mean is 0: crossings at 11 and 21.5 */
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[64];
    double seen;
    snprintf(text, sizeof text, "report %s", rows[k].measure);
    planted_page(&outcome, "", text);
    planted_rows(&outcome, 0, 6, rows[k].x);
    struct nb_table *const table = &outcome.runs[0].result.table;
    memcpy(table->time, times, sizeof times);
    CU_ASSERT(nb_measure_value(&seen, &outcome.runs[0].expectations.list[0].measure, table, &error));
    if (!(fabs(seen - rows[k].value) < 1e-15))
      printf("# %s: %.17g\n", rows[k].measure, seen);
    CU_ASSERT_DOUBLE_EQUAL(seen, rows[k].value, 1e-15);
    nb_outcome_free(&outcome);
  }
}

/* A reference may return a value for a stage (`A.x max in one`) and a value without a stage (`A.x max`). An expectation
 * for a stage uses the first one if there is one, and otherwise the second one. */
static void the_value_for_the_stage_is_preferred(void) {
  static const struct {
    const char *expectation;
    double reference;
  } rows[] = {{"A.x max in one within 1e-9", 5}, {"A.x max in two within 1e-9", 9}, {"A.x max within 1e-9", 9}};
  for (size_t k = 0; k < COUNT(rows); k++)
    for (int turn = 0; turn < 2; turn++) {
      struct nb_outcome outcome;
      planted_page(&outcome, "", rows[k].expectation);
      planted_rows(&outcome, 0, 6, (const double[]){5, 2, 3, 9, 1, 1});
      planted_solution(&outcome, turn ? "A.x max" : "A.x max in one", turn ? 9 : 5);
      planted_solution(&outcome, turn ? "A.x max in one" : "A.x max", turn ? 5 : 9);
      const double *value =
          nb_measure_solution(&outcome.runs[0].expectations.list[0].measure, &outcome.runs[0].solution);
      CU_ASSERT_PTR_NOT_NULL_FATAL(value);
      CU_ASSERT_EQUAL(*value, rows[k].reference);
      planted_is(&outcome, NB_PASS);
      nb_outcome_free(&outcome);
    }
}

static void nothing_to_reduce(void) {
  static const struct {
    const char *expectation, *words;
    int count;
    double x[6];
  } rows[] = {
      {"A.x within 9", "`A.x` cannot be computed: no row was recorded there", 0, {0}},
      {"A.x in two within 9", "`A.x in two` cannot be computed: no row was recorded there", 3, {1, 2, 3}},
      {"A.x at 15 cycles within 9", "at that moment, only in other cycles from cycle 0 to 20", 3, {1, 2, 3}},
      {"A.x at 30 cycles within 9", "no row was recorded at that moment, only from cycle 0 to 20", 3, {1, 2, 3}},
      {"A.x at 2.5 within 9", "no row was recorded at that moment, only from time 0 to 2", 3, {1, 2, 3}},
      {"A.x at 2.5 in two within 9", "no row was recorded at that moment", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 10 cycles in two within 9",
       "`A.x at 10 cycles in two` cannot be computed: no row was recorded at that moment, only from cycle 30 to 50",
       6,
       {1, 2, 3, 4, 5, 6}},
      {"A.x at 2 in two within 9",
       "`A.x at 2 in two` cannot be computed: no row was recorded at that moment, only from time 3 to 5",
       6,
       {1, 2, 3, 4, 5, 6}},
      /* the rows of another stage do not count, not even the next one */
      {"A.x at 30 cycles in one within 9", "at that moment, only from cycle 0 to 20", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 40 cycles in one within 9", "at that moment, only from cycle 0 to 20", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 3 in one within 9", "at that moment, only from time 0 to 2", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 2.5 in one within 9", "at that moment, only from time 0 to 2", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 20 cycles in two within 9", "at that moment, only from cycle 30 to 50", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 51 cycles in two within 9", "at that moment, only from cycle 30 to 50", 6, {1, 2, 3, 4, 5, 6}},
      {"A.x at 45 cycles in two within 9",
       "at that moment, only in other cycles from cycle 30 to 50",
       6,
       {1, 2, 3, 4, 5, 6}},
      {"A.x frequency within 9", "it rises through its mean less than twice", 3, {-1, 1, 1}},
      {"A.x frequency within 9", "it rises through its mean less than twice", 3, {1, 1, 1}},
      {"A.x frequency in one within 9", "it rises through its mean less than twice", 6, {-1, 1, -1, 9, 0, 0}},
      {"A.x frequency in two within 9", "it rises through its mean less than twice", 6, {0, 0, -9, 1, -1, 1}},
      {"A.x mean within 9", "the result is not a finite number", 3, {1e308, 1e308, 1e308}},
      {"A.x amplitude within 9", "the result is not a finite number", 3, {-1e308, 0, 1e308}},
      {"A.x within 9 % of A.y in two", "`A.y in two` cannot be computed", 3, {1, 2, 3}},
      {"A.x expected 1 of A.y in two within 1 [t]", "`A.y in two` cannot be computed", 3, {1, 2, 3}},
      {"A.x in two expected 1 of A.y within 1 [t]", "`A.x in two` cannot be computed", 3, {1, 2, 3}},
      {"A.x below A.y in two", "`A.y in two` cannot be computed", 3, {1, 2, 3}},
      {"A.x in two above A.y", "`A.x in two` cannot be computed", 3, {1, 2, 3}},
      {"A.y versus time within 9", "no curve of `A.y` versus `time`, but `A.x versus time`", 3, {1, 2, 3}},
      {"A.x versus time in two within 9", "no rows were recorded", 3, {1, 2, 3}},
      {"A.x versus time within 9 % of A.y in two", "`A.y in two` cannot be computed", 3, {1, 2, 3}},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, "", rows[k].expectation);
    planted_rows(&outcome, 0, rows[k].count, rows[k].x);
    planted_curve(&outcome, rows[k].count, rows[k].x);
    planted_solution(&outcome, outcome.runs[0].expectations.list[0].measure.label, 1);
    planted_is(&outcome, NB_FAIL);
    planted_says(&outcome, rows[k].words);
    double value = 0;
    struct nb_error error;
    const struct nb_measure *measure = &outcome.runs[0].expectations.list[0].measure;
    CU_ASSERT(nb_measure_value(&value, measure, &outcome.runs[0].result.table, &error) || !isfinite(value));
    nb_outcome_free(&outcome);
  }
  planted_one("A.x within 9", "A.y", 1, 1, &rows[0].x[0], NB_FAIL, "the reference does not return `A.x`");
  planted_one("A.x versus time within 9", NULL, 0, 1, &rows[0].x[0], NB_FAIL,
              "the reference returns no curve of `A.x`");
  struct nb_outcome outcome;
  planted_page(&outcome, "", "A.y versus time within 9");
  planted_rows(&outcome, 0, 1, (double[]){1});
  planted_curve(&outcome, 1, (double[]){1}), planted_curve(&outcome, 1, (double[]){1});
  strcpy(outcome.runs[0].solution.curves[1].name, "A.vx");
  strcpy(outcome.runs[0].solution.curves[1].along, "cycle");
  planted_is(&outcome, NB_FAIL);
  CU_ASSERT_STRING_EQUAL(
      outcome.checks[0].message,
      "the reference returns no curve of `A.y` versus `time`, but `A.x versus time`, `A.vx versus cycle`");
  nb_outcome_free(&outcome);
}

static void not_finite(void) {
  static const char *const reducers[] = {"",           " max",          " min",  " mean",   " amplitude",
                                         " frequency", " at 10 cycles", " at 1", " at 0.5", " at 1.5"};
  static const double bad[] = {NAN, INFINITY, -INFINITY};
  for (size_t k = 0; k < COUNT(reducers); k++)
    for (size_t b = 0; b < COUNT(bad); b++) {
      const double x[] = {-2, bad[b], 2, -1, 3, -3}, last[] = {bad[b]};
      char text[128], label[64];
      snprintf(label, sizeof label, "A.x%s", k ? reducers[k] : " in all");
      snprintf(text, sizeof text, "%s%s within 1e300", label, k ? " in one" : "");
      planted_one(text, label, 1, k ? 6 : 1, k ? x : last, NB_FAIL, "cannot be computed: it is ");
    }
  static const double one[] = {1}, huge[] = {1e300};
  for (size_t b = 0; b < COUNT(bad); b++) {
    planted_one("A.x within 1e300", "A.x", bad[b], 1, one, NB_FAIL, ": not a finite number");
    planted_one("A.x within 1e300 %", "A.x", bad[b], 1, one, NB_FAIL, ": not a finite number");
    planted_one("A.x below A.y", NULL, 0, 1, &bad[b], NB_FAIL, "it is ");
    planted_one("A.y within 5 % of A.x", "A.y", 1, 1, &bad[b], NB_FAIL, "`A.x` cannot be computed");
    planted_one("A.y expected 1 of A.x within 5 [t]", NULL, 0, 1, &bad[b], NB_FAIL, "`A.x` cannot be computed");
  }
  planted_one("A.x within 1e20 %", "A.x", 1e300, 1, huge, NB_FAIL, "a fraction of 1e+300 is not a finite tolerance");
  planted_one("A.y expected 1 of A.x within 5 [t]", NULL, 0, 1, (double[]){0}, NB_FAIL,
              "computed 1 and 0: their ratio is not a finite number");
  planted_one("A.vx expected 1 of A.x within 5 [t]", NULL, 0, 1, (double[]){1e-310}, NB_FAIL,
              "computed -4 and 1e-310: their ratio is not a finite number");
  planted_one("A.x max within 1e300", "A.x max", 0, 3, (double[]){-INFINITY, 0, 0}, NB_FAIL, "it is -inf at cycle 0");
  planted_one("A.x max within 1e300", "A.x max", 0, 3, (double[]){0, 0, NAN}, NB_FAIL, "it is nan at cycle 20");
  struct nb_outcome outcome;
  planted_page(&outcome, "", "A.x below 1");
  planted_rows(&outcome, 0, 1, (double[]){NAN});
  outcome.runs[0].result.table.cycle[0] = 123456;
  planted_is(&outcome, NB_FAIL);
  planted_says(&outcome, "it is nan at cycle 123456");
  nb_outcome_free(&outcome);
}

/* A number at the end of a line is a time, although the line above has the word `cycles` at the next place. */
static void a_time_at_the_end_of_a_line(void) {
  struct nb_outcome outcome;
  planted_page(&outcome, "", "report A.x at 20 cycles\nreport A.x at 1");
  planted_rows(&outcome, 0, 3, (double[]){1, 4, 3});
  planted_is(&outcome, NB_NOTE);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 2);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message, "computed 3");
  CU_ASSERT_STRING_EQUAL(outcome.checks[1].message, "computed 4");
  nb_outcome_free(&outcome);
}

void suite_reducers(void) {
  CU_pSuite suite = CU_add_suite("reducers", NULL, NULL);
  CU_add_test(suite, "every reducer over a stage, the last stage and all stages", reducers);
  CU_ADD_TEST(suite, times_of_rows);
  CU_add_test(suite, "a measure that cannot be computed fails, with the reason", nothing_to_reduce);
  CU_add_test(suite, "values that are not finite fail every check", not_finite);
  CU_add_test(suite, "the value for the stage is preferred", the_value_for_the_stage_is_preferred);
  CU_ADD_TEST(suite, a_time_at_the_end_of_a_line);
}
