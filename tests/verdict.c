/* The verdict on one run: every expectation at both edges of its tolerance. At the edge the expectation passes; 1e-12
 * beyond the edge it fails. The numbers are chosen so that the edge itself is exact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "planted.h"
#include "suites.h"

/* The given values x are exactly at the tolerance, and the expectation passes. With x[which] changed by 1e-12 in the
 * direction `outwards` the expectation fails. */
struct edge {
  const char *expectation;
  double reference[6]; /* of A.x; for a curve, one per row */
  int count;
  double x[6];
  int which, outwards;
};

static void edges(const struct edge *list, size_t count) {
  for (size_t k = 0; k < count; k++)
    for (int beyond = 0; beyond < 2; beyond++) {
      struct nb_outcome outcome;
      double x[6];
      memcpy(x, list[k].x, sizeof x);
      x[list[k].which] += beyond * list[k].outwards * 1e-12;
      planted_page(&outcome, "", list[k].expectation);
      planted_rows(&outcome, 0, list[k].count, x);
      planted_curve(&outcome, list[k].count, list[k].reference);
      const struct nb_measure *measure = &outcome.runs[0].expectations.list[0].measure;
      if (!measure->is_residual)
        planted_solution(&outcome, measure->label, list[k].reference[0]);
      planted_is(&outcome, beyond ? NB_FAIL : NB_PASS);
      nb_outcome_free(&outcome);
    }
}

static void within(void) {
  static const struct edge list[] = {
      {"A.x within 0.5", {8}, 1, {8.5}, 0, 1},
      {"A.x within 0.5", {8}, 1, {7.5}, 0, -1},
      {"A.x within 0.5", {-8}, 1, {-8.5}, 0, -1},
      {"A.x within 0.5", {0}, 1, {0.5}, 0, 1},
      {"A.x within 0", {8}, 1, {8}, 0, 1},
      {"A.x within 0", {8}, 1, {8}, 0, -1},
      {"A.x within 25 %", {8}, 1, {10}, 0, 1},
      {"A.x within 25 %", {8}, 1, {6}, 0, -1},
      {"A.x within 25 %", {-8}, 1, {-10}, 0, -1},
      {"A.x within 25 %", {-8}, 1, {-6}, 0, 1},
      {"A.x within 250000 ppm", {8}, 1, {10}, 0, 1},
      {"A.x within 25 % of peak", {-8}, 1, {-10}, 0, -1},
      {"A.x within 25 % of A.y max", {8}, 3, {0, 0, 9}, 2, 1}, /* A.y max is 4 */
      {"A.x within 25 % of A.y max", {8}, 3, {0, 0, 7}, 2, -1},
      {"A.x within 0.25 of A.y max", {8}, 3, {0, 0, 9}, 2, 1},
      {"A.x within 25 % of A.vx", {8}, 1, {9}, 0, 1}, /* A.vx is -4: a fraction of its magnitude */
      {"A.x max within 0.5", {8}, 3, {1, 8.5, 3}, 1, 1},
      {"A.x max within 0.5", {8}, 3, {1, 7.5, 3}, 1, -1},
      {"A.x min within 0.5", {-8}, 3, {1, -8.5, 3}, 1, -1},
      {"A.x min within 0.5", {-8}, 3, {1, -7.5, 3}, 1, 1},
      {"A.x mean within 0.5", {2}, 3, {4.5, 1, 2}, 0, 1},
      {"A.x mean within 0.5", {2}, 3, {1, 2, 1.5}, 2, -1},
      {"A.x amplitude within 0.5", {3}, 3, {0, 7, 3}, 1, 1},
      {"A.x amplitude within 0.5", {3}, 3, {0, 7, 3}, 0, -1},
      {"A.x frequency in all within 0.25", {0.25}, 6, {-1, 1, -1, 1, -1, 1}, 4, 1},
      {"energy.balance within 0.5", {0}, 1, {0.5}, 0, 1},
      {"energy.balance within 0.5", {0}, 1, {-0.5}, 0, -1},
      {"energy.balance max within 25 % of A.y max", {0}, 3, {0, 1, 0}, 1, 1},
  };
  edges(list, COUNT(list));
}

static void expected_values(void) {
  static const struct edge list[] = {
      {"A.x expected 8 within 0.5 [t]", {0}, 1, {8.5}, 0, 1},
      {"A.x expected 8 within 0.5 [t]", {0}, 1, {7.5}, 0, -1},
      {"A.x expected -8 within 25 % [t]", {0}, 1, {-10}, 0, -1},
      {"A.x expected -8 within 25 % [t]", {0}, 1, {-6}, 0, 1},
      {"A.x expected 8 within 25 % of A.y max [t]", {0}, 3, {0, 0, 9}, 2, 1},
      {"A.x expected 2 of A.y max within 0.5 [t]", {0}, 3, {0, 0, 10}, 2, 1}, /* 2.5 times 4 */
      {"A.x expected 2 of A.y max within 0.5 [t]", {0}, 3, {0, 0, 6}, 2, -1},
      {"A.x expected 200 % of A.y max within 25 % [t]", {0}, 3, {0, 0, 10}, 2, 1},
      {"A.x expected 0 within 0.5 [t]", {0}, 1, {-0.5}, 0, -1},
  };
  edges(list, COUNT(list));
}

static void below_and_above(void) {
  static const double two = 2;
  planted_one("A.x below A.y", NULL, 0, 2, (double[]){0, 2 - 1e-12}, NB_PASS, "and 2");
  planted_one("A.x below A.y", NULL, 0, 2, (double[]){0, two}, NB_FAIL, "computed 2 and 2");
  planted_one("A.x below A.y", NULL, 0, 2, (double[]){0, 2 + 1e-12}, NB_FAIL, "and 2");
  planted_one("A.x above A.y", NULL, 0, 2, (double[]){0, 2 + 1e-12}, NB_PASS, "and 2");
  planted_one("A.x above A.y", NULL, 0, 2, (double[]){0, two}, NB_FAIL, "computed 2 and 2");
  planted_one("A.x above A.y", NULL, 0, 2, (double[]){0, 2 - 1e-12}, NB_FAIL, "and 2");
  /* Both numbers have enough digits for the difference, 17 at most. */
  planted_one("A.x below A.y", NULL, 0, 2, (double[]){0, 2 - 1e-9}, NB_PASS, "computed 1.999999999 and 2");
  planted_one("A.x above A.y", NULL, 0, 2, (double[]){0, 2 + 1e-9}, NB_PASS, "computed 2.000000001 and 2");
  planted_one("A.y above A.x", NULL, 0, 2, (double[]){0, 2 - 1e-9}, NB_PASS, "computed 2 and 1.999999999");
  planted_one("A.y above A.x", NULL, 0, 2, (double[]){0, nextafter(2, 3)}, NB_FAIL,
              "computed 2 and 2.0000000000000004");
  planted_one("A.x above A.y", NULL, 0, 2, (double[]){0, nextafter(2, 3)}, NB_PASS,
              "computed 2.0000000000000004 and 2");
  planted_one("A.y above A.x", NULL, 0, 2, (double[]){0, 2.0 / 3}, NB_PASS, "computed 2 and 0.666667");
  /* If the difference is 1.0005e-5 of the larger number, seven digits show two digits of the difference. If it is
   * 0.9995e-5 of the larger number, eight digits are needed. */
  planted_one("A.x below 1.2345678", NULL, 0, 1, (double[]){1.2345678 * (1 - 1.0005e-5)}, NB_PASS, " and 1.234568");
  planted_one("A.x below 1.2345678", NULL, 0, 1, (double[]){1.2345678 * (1 - 0.9995e-5)}, NB_PASS, " and 1.2345678");
  planted_one("A.x above 1.2345678", NULL, 0, 1, (double[]){1.2345678 / (1 - 1.0005e-5)}, NB_PASS, " and 1.234568");
  planted_one("A.x above 1.2345678", NULL, 0, 1, (double[]){1.2345678 / (1 - 0.9995e-5)}, NB_PASS, " and 1.2345678");
}

static void below_and_above_a_number(void) {
  static const double two = 2;
  planted_one("A.x below 2", NULL, 0, 2, (double[]){0, 2 - 1e-12}, NB_PASS, "and 2");
  planted_one("A.x below 2", NULL, 0, 2, (double[]){0, two}, NB_FAIL, "computed 2 and 2");
  planted_one("A.x below 2", NULL, 0, 2, (double[]){0, 2 + 1e-12}, NB_FAIL, "and 2");
  planted_one("A.x above 2", NULL, 0, 2, (double[]){0, 2 + 1e-12}, NB_PASS, "and 2");
  planted_one("A.x above 2", NULL, 0, 2, (double[]){0, two}, NB_FAIL, "computed 2 and 2");
  planted_one("A.x above 2", NULL, 0, 2, (double[]){0, 2 - 1e-12}, NB_FAIL, "and 2");
  planted_one("A.x above -2", NULL, 0, 2, (double[]){0, -2}, NB_FAIL, "computed -2 and -2");
  planted_one("A.x max below 2", NULL, 0, 2, (double[]){2, 0}, NB_FAIL, "computed 2 and 2");
  planted_one("cycle below 1001 %", NULL, 0, 2, (double[]){0, 0}, NB_PASS, "computed 10 and 10.01");
  planted_one("cycle below 1000 %", NULL, 0, 2, (double[]){0, 0}, NB_FAIL, "computed 10 and 10");
  planted_one("A.x below 2", NULL, 0, 2, (double[]){0, NAN}, NB_FAIL, "it is nan at cycle");
  planted_one("A.x above 2", NULL, 0, 2, (double[]){0, NAN}, NB_FAIL, "it is nan at cycle");
  planted_one("A.x below 2", NULL, 0, 2, (double[]){0, -INFINITY}, NB_FAIL, "it is -inf at cycle");
}

static void versus(void) {
  static const struct edge list[] = {
      {"A.x versus time within 0.5", {1, 5, 2}, 3, {1.5, 5, 2}, 0, 1},
      {"A.x versus time within 0.5", {1, 5, 2}, 3, {1, 4.5, 2}, 1, -1},
      {"A.x versus time within 0.5", {1, 5, 2}, 3, {1, 5, 2.5}, 2, 1},
      {"A.x versus time within 25 %", {0, 8, -4}, 3, {0, 10, -4}, 1, 1},
      {"A.x versus time within 25 %", {0, 8, -4}, 3, {0, 8, -5}, 2, -1},
      {"A.x versus time within 25 %", {0, 8, -4}, 3, {0, 8, -4}, 0, 1}, /* at the reference 0 no error is allowed */
      {"A.x versus time within 25 % of peak", {0, 8, 2}, 3, {2, 8, 2}, 0, 1},
      {"A.x versus time within 25 % of peak",
       {0, 8, 2},
       3,
       {0, 10, 2},
       1,
       1}, /* peak of the reference, not of the computed rows */
      {"A.x versus time within 25 % of peak", {0, -8, 2}, 3, {0, -8, 4}, 2, 1},
      {"A.x versus time within 25 % of peak", {8, 1, 2}, 3, {8, 3, 2}, 1, 1},
      {"A.x versus time within 25 % of A.y max", {0, 8, 2}, 3, {0, 9, 2}, 1, 1},
      {"A.x versus time in one within 0.5", {0, 8, 2, 9, 9, 9}, 6, {0, 8, 2.5, 0, 0, 0}, 2, 1},
      /* the peak is that of the stage */
      {"A.x versus time in one within 25 % of peak", {0, 8, 2, 90, 90, 90}, 6, {0, 8, 4, 0, 0, 0}, 2, 1},
      {"A.x versus time within 25 % of peak", {90, 90, 90, 0, 8, 2}, 6, {0, 0, 0, 2, 8, 2}, 3, 1},
      {"A.x versus time in all within 25 % of peak", {0, 8, 2, 16, 1, 2}, 6, {0, 8, 6, 16, 1, 2}, 2, 1},
      {"A.x versus time within 0.5", {9, 9, 9, 1, 2, 3}, 6, {0, 0, 0, 1.5, 2, 3}, 3, 1},
      {"A.x versus time in all within 0.5", {9, 9, 9, 1, 2, 3}, 6, {9, 9, 9, 1, 2, 3.5}, 5, 1},
  };
  edges(list, COUNT(list));
}

/* The message names the worst row, whatever rows come before it, even a row whose two values are both 0. */
static void worst_row(void) {
  static const struct {
    const char *expectation, *words;
    double reference[3], x[3];
  } rows[] = {
      {"A.x versus time within 1e-4 %",
       "computed 20, reference 10, error 100 %, tolerance 0.0001 %; the worst of 3 rows, at time = 2",
       {0, 4, 10},
       {0, 4, 20}},
      {"A.x versus time within 25 %",
       "computed 12, reference 8, error 50 %, tolerance 25 %; the worst of 3 rows, at time = 1",
       {4, 8, 20},
       {5.5, 12, 25}},
      {"A.x versus time within 1",
       "computed 13, reference 20, error 7, tolerance 1; the worst of 3 rows, at time = 2",
       {4, 8, 20},
       {9, 12, 13}},
      {"A.x versus time within 1",
       "computed 9, reference 4, error 5, tolerance 1; the worst of 3 rows, at time = 0",
       {4, 8, 20},
       {9, 12, 20}},
      {"A.x versus time within 1 % of peak",
       "error 50 %, tolerance 1 % of peak; the worst of 3 rows, at time = 1",
       {4, -8, 2},
       {4, -4, 2}},
      {"A.x versus time within 25 %", "error 1; a tolerance in % of 0 allows no error", {4, 0, 2}, {4, 1, 2}},
      {"A.x versus time within 25 % of peak", "error 1; a tolerance in % of 0 allows no error", {0}, {0, 1, 0}},
      {"A.x versus time within 1 % of A.y max",
       "error 25 %, tolerance 1 % of A.y max; the worst",
       {4, 8, 2},
       {4, 8, 3}},
      {"A.x versus time within 9",
       "computed nan, reference 8: not a finite number; the worst of 3 rows, at time = 1",
       {4, 8, 2},
       {4, NAN, 2}},
      {"A.x versus time within 9",
       "computed inf, reference 2: not a finite number; the worst of 3 rows, at time = 2",
       {4, 8, 2},
       {4, 8, INFINITY}},
      {"A.x versus time within 9 %", "computed 4, reference -inf: not a finite number", {-INFINITY, 8, 2}, {4, 8, 2}},
      {"A.x versus time within 9", "computed 2, reference nan: not a finite number", {4, 8, NAN}, {4, 8, 2}},
      {"A.x versus time within 100 %", /* near the largest double: the tolerance does not overflow */
       "error 200 %, tolerance 100 %; the worst of 3 rows, at time = 1",
       {1.797e308, 8, 2},
       {1.797e308, 24, 2}},
      {"A.x versus time within 9 % of peak",
       "a fraction of inf is not a finite tolerance",
       {4, 8, INFINITY},
       {4, 8, 2}},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, "", rows[k].expectation);
    planted_rows(&outcome, 0, 3, rows[k].x);
    planted_curve(&outcome, 3, rows[k].reference);
    planted_is(&outcome, NB_FAIL);
    planted_says(&outcome, rows[k].words);
    nb_outcome_free(&outcome);
  }
}

static void percentage_of_zero(void) {
  planted_one("A.x within 5 %", "A.x", 0, 1, (double[]){0}, NB_PASS,
              "computed 0, reference 0, error 0 %, tolerance 5 %");
  planted_one("A.x within 5 %", "A.x", 0, 1, (double[]){1e-300}, NB_FAIL,
              "error 1e-300; a tolerance in % of 0 allows no error");
  planted_one("A.x within 5 %", "A.x", 0, 1, (double[]){-0.14945}, NB_FAIL,
              "computed -0.14945, reference 0, error 0.149; a tolerance in % of 0 allows no error");
}

static void words(void) {
  planted_one("A.x within 25 %", "A.x", 8, 1, (double[]){9}, NB_PASS,
              "computed 9, reference 8, error 12.5 %, tolerance 25 %");
  planted_one("A.x within 2", "A.x", 8, 1, (double[]){9}, NB_PASS, "computed 9, reference 8, error 1, tolerance 2");
  planted_one("A.x expected 8 within 2 [t]", NULL, 0, 1, (double[]){9}, NB_PASS,
              "computed 9, expected 8, error 1, tolerance 2");
  planted_one("A.x within 0", "A.x", 1, 1, (double[]){1.000000002}, NB_FAIL, /* enough digits to see the difference */
              "computed 1.000000002, reference 1, error 2e-09");
  planted_one("A.x within 0", "A.x", -1, 1, (double[]){-1.0000000012}, NB_FAIL, /* two digits of the difference */
              "computed -1.0000000012, reference -1, error 1.2e-09");
  planted_one("A.x within 0", "A.x", 1, 1, (double[]){1.0000000012345}, NB_FAIL, /* not more than two */
              "computed 1.0000000012, reference 1, error 1.23");
  planted_one("A.x within 0", "A.x", 1.0000000012, 1, (double[]){1}, NB_FAIL,
              "computed 1, reference 1.0000000012, error 1.2e-09");
  planted_one("report A.x", NULL, 0, 1, (double[]){9}, NB_NOTE, "computed 9");
  planted_one("report A.x", NULL, 0, 1, (double[]){NAN}, NB_FAIL, "cannot be computed");
  planted_one("A.x within 1 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS, "error 25 %, tolerance 100 % of A.vx");
  /* below 1e-7 and above 1e7 a fraction is not written in per cent, which would be mostly zeros */
  planted_one("A.x within 1e300 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS, "error 0.25, tolerance 1e+300 of A.vx");
  planted_one("A.x within 1e-9 of A.vx", "A.x", 8, 1, (double[]){9}, NB_FAIL, "error 0.25, tolerance 1e-09 of A.vx");
  planted_one("A.x within 1e-6 of A.vx", "A.x", 8, 1, (double[]){9}, NB_FAIL, "error 25 %, tolerance 0.0001 % of A.vx");
  planted_one("A.x within 1e6 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS, "error 25 %, tolerance 1e+08 % of A.vx");
  planted_one("A.x within 2e7 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS, "error 0.25, tolerance 2e+07 of A.vx");
  planted_one("A.x within 5e-8 of A.vx", "A.x", 8, 1, (double[]){9}, NB_FAIL, "error 0.25, tolerance 5e-08 of A.vx");
  planted_one("A.x within 1e-7 of A.vx", "A.x", 8, 1, (double[]){9}, NB_FAIL, "error 25 %, tolerance 1e-05 % of A.vx");
  planted_one("A.x within 0.9993e-7 of A.vx", "A.x", 8, 1, (double[]){9}, NB_FAIL, "error 0.25, tolerance 9.99e-08 of");
  planted_one("A.x within 1e7 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS, "error 25 %, tolerance 1e+09 % of A.vx");
  planted_one("A.x within 1.0005e7 of A.vx", "A.x", 8, 1, (double[]){9}, NB_PASS,
              "error 0.25, tolerance 1e+07 of A.vx");
  struct nb_outcome outcome;
  planted_page(&outcome, "",
               "A.x versus time within 9"); /* the worst row only, although each is worse than the one before */
  planted_rows(&outcome, 0, 3, (double[]){1, 2, 3});
  planted_curve(&outcome, 3, (double[]){0, 0, 0});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message,
                         "computed 3, reference 0, error 3, tolerance 9; the worst of 3 rows, at time = 2");
  nb_outcome_free(&outcome);
  planted_page(&outcome, "", "A.x versus time within 9"); /* the rows of the last stage only */
  planted_rows(&outcome, 0, 5, (double[]){7, 8, 9, 4, 5});
  planted_curve(&outcome, 5, (double[]){0, 0, 0, 0, 0});
  planted_is(&outcome, NB_PASS);
  planted_says(&outcome, "computed 5, reference 0, error 5, tolerance 9; the worst of 2 rows, at time = 4");
  nb_outcome_free(&outcome);
  planted_page(&outcome, "", "A.x \t within\t 2  # of something");
  planted_rows(&outcome, 0, 1, (double[]){1});
  planted_solution(&outcome, "A.x", 1);
  planted_is(&outcome, NB_PASS);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].label, "A.x within 2");
  CU_ASSERT_EQUAL(outcome.page.lines[outcome.checks[0].line - 1][0], 'A');
  nb_outcome_free(&outcome);
  char text[400] = "A.x expected 1 within 0 ["; /* the label is cut at 255 characters, the expectation is not */
  memset(text + strlen(text), 'x', 300);
  strcat(text, "]");
  planted_page(&outcome, "", text);
  planted_rows(&outcome, 0, 1, (double[]){1});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT(strlen(outcome.checks[0].label) == 255 && memcmp(outcome.checks[0].label, text, 255) == 0);
  nb_outcome_free(&outcome);
}

/* The error of a failed check is printed with two significant digits of its difference from the tolerance, and that of
 * a passed one with three digits in all. */
static void digits_of_errors(void) {
  planted_one("A.x within 0.1 %", "A.x", 1, 1, (double[]){1.00100005}, NB_FAIL, "error 0.100005 %, tolerance 0.1 %");
  planted_one("A.x within 0.1 %", "A.x", 1, 1, (double[]){1.00099995}, NB_PASS, "error 0.1 %, tolerance 0.1 %");
  planted_one("A.x within 0.1", "A.x", 0, 1, (double[]){0.101234}, NB_FAIL, "error 0.1012, tolerance 0.1");
  planted_one("A.x within 0.1", "A.x", 0, 1, (double[]){0.151234}, NB_FAIL, "error 0.151, tolerance 0.1");
  planted_one("A.x within 0.1", "A.x", 0, 1, (double[]){0.091234}, NB_PASS, "error 0.0912, tolerance 0.1");
  planted_one("A.x within 0", "A.x", 0, 1, (double[]){0.151234}, NB_FAIL, "error 0.151, tolerance 0");
  /* two digits of the difference 1, relative to the larger number: 8 digits */
  planted_one("A.x within 2", "A.x", 100000.54, 1, (double[]){99999.54}, NB_PASS, "99999.54, reference 100000.54");
}

/* A reference solution may return a value for one stage only, or one that holds in all stages. */
static void reference_of_a_stage(void) {
  static const double x[] = {1, 2, 3, 4, 5, 6};
  planted_one("A.x in one within 0", "A.x in one", 3, 6, x, NB_PASS, "reference 3");
  planted_one("A.x in one within 0", "A.x", 3, 6, x, NB_PASS, "reference 3");
  planted_one("A.x at 500 within 0", "A.x", 6, 6, x, NB_FAIL,
              "does not return `A.x at 500`"); /* without a stage, nothing can be left out of the name */
  planted_one("A.x max in all within 0", "A.x max", 6, 6, x, NB_PASS, "reference 6");
  planted_one("A.x within 0", "A.x in one", 3, 6, x, NB_FAIL, "does not return `A.x`");
  planted_one("energy.balance in one within 0", "energy.balance", 3, 6, x, NB_PASS, "reference 3");
}

/* `MEASURE within TOLERANCE` outside of a page. The message names the text. */
static void expectation_outside_of_a_page(void) {
  static const struct {
    const char *text, *message; /* NULL: no mistake */
  } rows[] = {
      {"A.x within 1 %", NULL},
      {"A.x max in one within 2", NULL},
      {"energy.balance within 1", NULL},
      {"", "that: error: expected a quantity that the page records, found the end of the line\n"},
      {"# A.x within 1 %", "that: error: expected a quantity that the page records, found the end of the line\n"},
      {"A.x", "that: error: expected `within`"},
      {"A.x within", "that: error: expected a length as a number without a unit"},
      {"A.z within 1 %", "that: error: expected a quantity that the page records, found `A.z`"},
      {"A.x within 1 % of peak and", "that: error: expected the end of the text, found `and`\n"},
      {"energy.balance within 1 %", "that: error: expected an absolute tolerance, because the reference value is 0"},
  };
  struct nb_outcome outcome;
  planted_page(&outcome, "", "report A.x");
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_mistakes mistakes = {0};
    struct nb_expectation expectation;
    const enum nb_status status =
        nb_expectation_read(&expectation, "that", rows[k].text, &outcome.runs[0].scene, &mistakes);
    CU_ASSERT_EQUAL(status, rows[k].message ? NB_BAD_USE : NB_OK);
    const char *const said = mistakes.text ? mistakes.text : "";
    if (!strstr(said, rows[k].message ? rows[k].message : ""))
      printf("# `%s`: %s\n", rows[k].text, said);
    CU_ASSERT(strstr(said, rows[k].message ? rows[k].message : "") != NULL);
    if (k == 1)
      CU_ASSERT(expectation.measure.reducer == NB_MAX && expectation.measure.stage == 0 &&
                expectation.tolerance.kind == NB_ABSOLUTE && expectation.tolerance.value == 2);
    nb_mistakes_free(&mistakes);
  }
  nb_outcome_free(&outcome);
}

/* All checks of a page are counted, by their marks. */
static void counted(void) {
  struct nb_outcome outcome;
  planted_page(&outcome, "",
               "A.x expected 1 within 0 [t]\nA.x expected 2 within 0 [t]\nA.x expected 1 within 0 [t]\n"
               "A.x expected 1 within 0 [t]\nA.y expected 1 within 0 [t]");
  planted_rows(&outcome, 0, 1, (double[]){1});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT(outcome.check_count == 5 && outcome.mark_count[NB_PASS] == 4 && outcome.mark_count[NB_FAIL] == 1);
  CU_ASSERT(outcome.checks[1].mark == NB_FAIL && outcome.checks[4].mark == NB_PASS);
  CU_ASSERT(outcome.mark_count[NB_NOTE] == 0 && outcome.mark_count[NB_SKIP] == 0);
  nb_outcome_free(&outcome);
}

/* The parts of the message that the table of a report shows: computed, reference, error, tolerance. "" for a missing
 * part. */
static void parts_of_the_message(void) {
  static const struct {
    const char *expectation;
    double reference[3];
    int count;
    double x[3];
    const char *parts[NB_PARTS];
  } rows[] = {
      {"A.x within 0.5", {8}, 1, {8.25}, {"8.25", "8", "0.25", "0.5"}},
      {"A.x within 0.5", {8}, 1, {-8.75}, {"-8.75", "8", "16.8", "0.5"}},
      {"A.x within 25 %", {8}, 1, {9}, {"9", "8", "12.5 %", "25 %"}},
      /* errors and tolerances that would be rounded to other digits if they were a thousandth larger */
      {"A.x within 0.24945", {8}, 1, {8.14945}, {"8.14945", "8", "0.149", "0.249"}},
      {"A.x within 24.945 %", {8}, 1, {9.1956}, {"9.1956", "8", "14.9 %", "24.9 %"}},
      {"A.x within 24.945 % of A.vx", {8}, 1, {8.5978}, {"8.5978", "8", "14.9 %", "24.9 % of A.vx"}},
      {"A.x within 1e-9", {8}, 1, {8 + 5e-10}, {"8.0000000005", "8", "5e-10", "1e-09"}},
      {"A.x within 25 % of A.y max", {8}, 3, {0, 0, 8.5}, {"8.5", "8", "12.5 %", "25 % of A.y max"}},
      {"A.x within 1e9 of A.y max", {8}, 3, {0, 0, 10}, {"10", "8", "0.5", "1e+09 of A.y max"}},
      {"A.x within 1e-9 of A.y max", {8}, 3, {0, 0, 8}, {"8", "8", "0", "1e-09 of A.y max"}},
      {"A.x within 0 % of A.y max", {8}, 3, {0, 0, 8}, {"8", "8", "0 %", "0 % of A.y max"}},
      {"A.x expected 8 within 0.5 [t]", {0}, 1, {7.75}, {"7.75", "8", "0.25", "0.5"}},
      {"A.x expected 2 of A.y max within 25 % [t]", {0}, 3, {0, 0, 9}, {"2.25", "2", "12.5 %", "25 %"}},
      {"A.x versus time within 50 % of peak", {0, 8, 5}, 3, {0.5, 10.5, 5}, {"10.5", "8", "31.2 %", "50 % of peak"}},
      {"A.x versus time within 4", {0, 8, 5}, 3, {2, 8, 5.5}, {"2", "0", "2", "4"}},
      {"A.x within 0.5", {8}, 1, {INFINITY}, {"", "", "", ""}}, /* the measure cannot be computed */
      {"A.x versus time within 0.5", {8}, 1, {INFINITY}, {"inf", "8", "", ""}},
      {"A.x versus time within 0.5", {0, 8, 5}, 3, {2, INFINITY, 5}, {"inf", "8", "", ""}},
      {"A.x within 25 %", {0}, 1, {3}, {"3", "0", "", ""}},
      {"A.x below A.y", {0}, 1, {3}, {"", "", "", ""}},
      {"report A.x", {0}, 1, {3}, {"", "", "", ""}},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, "", rows[k].expectation);
    planted_rows(&outcome, 0, rows[k].count, rows[k].x);
    planted_curve(&outcome, rows[k].count, rows[k].reference);
    planted_solution(&outcome, "A.x", rows[k].reference[0]);
    nb_verdict(&outcome);
    CU_ASSERT_EQUAL_FATAL(outcome.check_count, 1);
    planted_parts(&outcome, rows[k].parts);
    nb_outcome_free(&outcome);
  }
}

/* A residual has both signs. If its largest value passes and its smallest one would not, the text says so, unless the
 * page also checks the smallest one of the same rows. The same holds for a smallest value that passes. Rows 0 to 2 are
 * those of stage one, rows 3 to 5 those of stage two. */
static void one_sign_of_a_residual(void) {
  static const struct {
    const char *expectation;
    double x[6];
    bool noted;
  } rows[] = {
      {"energy.balance max in one below 1", {-3, -2, 0}, true},
      {"energy.balance max in one below 1", {-0.5, -0.2, 0}, false},
      {"energy.balance max in one below 1", {-1.0001, -0.2, 0}, true},
      {"energy.balance max in one below 1", {-0.9999, -0.2, 0}, false},
      {"energy.balance max in one within 1", {-1.0001, -0.2, 0}, true},
      {"energy.balance min in one above -1", {0, 2, 0}, true},
      {"energy.balance min in one above -3", {0, 2, 0}, false},
      {"energy.balance max in one expected 0 within 1  [t]", {-3, -2, 0}, true},
      {"energy.balance max in one within 1", {-3, -2, 0}, true},
      {"energy.balance max in one within 1", {-1, 0.5, 0}, false},
      {"energy.balance max in one within 1\nenergy.balance min in one within 1", {-3, -2, 0}, false},
      {"energy.balance max in one within 1\nenergy.balance min in two within 1", {-3, -2, 0}, true},
      {"energy.balance max in one within 1\nenergy.balance min in all within 9", {-3, -2, 0}, true},
      {"energy.balance max in one within 1\nenergy.balance mean in one within 9", {-3, -2, 0}, true},
      {"energy.balance max in one within 1\nA.x min in one below 9", {-3, -2, 0}, true},
      {"energy.balance max within 1", {0, 0, 0, -3, -2, 0}, true},
      {"energy.balance max in one within 25 % of A.y max in one", {-3, -2, 0}, true}, /* 25 % of 4 */
      {"energy.balance max in one within 25 % of A.y max in one", {-0.5, -0.2, 0}, false},
      {"energy.balance max in one within 25 % of A.y max in one", {-1.0001, -0.2, 0}, true},
      {"energy.balance max in one within 25 % of A.y max in one", {-0.9999, -0.2, 0}, false},
      {"energy.balance max in one within 25 % of A.vx in one", {-1.0001, -0.2, 0}, true}, /* A.vx is -4 */
      {"energy.balance max in one within 25 % of A.vx in one", {-0.9999, -0.2, 0}, false},
      {"energy.balance min in one above -1", {0, 1.0001, 0}, true},
      {"energy.balance min in one above -1", {0, 0.9999, 0}, false},
      {"energy.balance mean in one within 1", {-3, 0.1, 2.9}, false}, /* a mean has no other sign */
      {"energy.balance max in one expected 1 within 1 [t]", {-3, -2, 0}, false},
      {"energy.balance max in one expected 0 of A.y max in one within 1 [t]", {-9, -2, 0}, false},
      {"A.x max in one below 1", {-3, -2, 0}, false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, "", rows[k].expectation);
    planted_rows(&outcome, 0, 6, rows[k].x);
    planted_is(&outcome, NB_PASS);
    const bool noted = strstr(outcome.checks[0].message, "; but a residual has both signs: `m");
    if (noted != rows[k].noted)
      printf("# %s: %s\n", rows[k].expectation, outcome.checks[0].message);
    CU_ASSERT_EQUAL(noted, rows[k].noted);
    nb_outcome_free(&outcome);
  }
  struct nb_outcome outcome; /* the check of the smallest value may come first */
  planted_page(&outcome, "", "energy.balance min in one within 9\nenergy.balance max in one within 1");
  planted_rows(&outcome, 0, 3, (double[]){-3, -2, 0});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT(strstr(outcome.checks[1].message, "both signs") == NULL);
  nb_outcome_free(&outcome);
  /* the note has the other extreme value; a value larger by a thousandth would have other digits */
  planted_one("energy.balance max in one below 1", NULL, 0, 6, (double[6]){-2.4945, -2, 0.5}, NB_PASS,
              "computed 0.5 and 1; but a residual has both signs: `min` is -2.49, check it too");
  planted_one("energy.balance min in one above -1", NULL, 0, 6, (double[6]){-0.5, 2.4945, 0.5}, NB_PASS,
              "computed -0.5 and -1; but a residual has both signs: `max` is 2.49, check it too");
}

void suite_verdict(void) {
  CU_pSuite suite = CU_add_suite("verdict", NULL, NULL);
  CU_add_test(suite, "within: both edges of every kind of tolerance", within);
  CU_add_test(suite, "expected: both edges, and fractions of another measure", expected_values);
  CU_add_test(suite, "below and above: equal is neither", below_and_above);
  CU_add_test(suite, "below and above a number: equal is neither, nor is NaN", below_and_above_a_number);
  CU_add_test(suite, "versus: the edge at the first, a middle and the last row", versus);
  CU_add_test(suite, "versus: the worst row is found after any other", worst_row);
  CU_add_test(suite, "a percentage of 0 is explained", percentage_of_zero);
  CU_add_test(suite, "the text of a check", words);
  CU_add_test(suite, "the parts of the text", parts_of_the_message);
  CU_add_test(suite, "digits of errors", digits_of_errors);
  CU_add_test(suite, "values of a reference for one stage", reference_of_a_stage);
  CU_add_test(suite, "a residual is checked with one sign only", one_sign_of_a_residual);
  CU_ADD_TEST(suite, expectation_outside_of_a_page);
  CU_add_test(suite, "checks are counted by their marks", counted);
}
