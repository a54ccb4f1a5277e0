/* The verdict on samples: trends at the edges of the confidence interval, and the percentile of an expected value among
 * the runs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "planted.h"
#include "suites.h"

/* The differences of four pairs of runs are m - 1 or m + 1, with the standard deviation s = sqrt(4/3). By Student's t
 * with 3 degrees of freedom, the 95 % confidence interval of the mean difference is m +- HALF, where HALF is
 * t s/sqrt(4). t: Abramowitz and Stegun, table 26.10. */
static const double HALF = 3.182446305284263 * 1.1547005383792515 / 2;

/* Tests an expectation over a sample: T is 1 and 2, seed 1 to 4. The mean of all runs is `level`, and `m` is the mean
 * difference of the pairs. The runs scatter much more than these differences. */
static void pairs(const char *expectation, double m, double level, enum nb_mark mark) {
  struct planted_sweep it = {
      "sweep T 1 2\nsweep seed 1 2 3 4", expectation, {0}, mark, "from 1 to 2: mean difference "};
  for (int seed = 0; seed < 4; seed++) {
    it.x[seed] = level + 10 * seed - 15 - m / 2;
    it.x[4 + seed] = it.x[seed] + m + (seed % 2 ? 1 : -1);
  }
  planted_sweeps(&it, 1);
}

static void samples(void) {
  const double near = 1e-9;
  pairs("A.x increases with T over seed", HALF + near, 0, NB_PASS);
  pairs("A.x increases with T over seed", HALF - near, 0, NB_FAIL);
  pairs("A.x increases with T over seed", -HALF - near, 0, NB_FAIL);
  pairs("A.x decreases with T over seed", -HALF - near, 0, NB_PASS);
  pairs("A.x decreases with T over seed", -HALF + near, 0, NB_FAIL);
  pairs("A.x decreases with T over seed", HALF + near, 0, NB_FAIL);
  pairs("A.x constant with T over seed within 3", 3 - HALF - near, 0, NB_PASS);
  pairs("A.x constant with T over seed within 3", 3 - HALF + near, 0, NB_FAIL);
  pairs("A.x constant with T over seed within 3", HALF - 3 + near, 0, NB_PASS);
  pairs("A.x constant with T over seed within 3", HALF - 3 - near, 0, NB_FAIL);
  pairs("A.x constant with T over seed within 25 %", 3 - HALF - near, 12, NB_PASS); /* 3 is 25 % of the level 12 */
  pairs("A.x constant with T over seed within 25 %", 3 - HALF + near, 12, NB_FAIL);
  pairs("A.x constant with T over seed within 25 %", HALF - 3 + near, -12, NB_PASS);
  pairs("A.x constant with T over seed within 25 %", HALF - 3 - near, -12, NB_FAIL);
  static const struct planted_sweep list[] = {
      {"sweep T 1 2 3\nsweep s 1 2",
       "A.x increases with T over s",
       {0, 10, 1, 11, 2, 12},
       NB_PASS,
       "from 1 to 2: mean difference +1, 95 % confidence 1 to 1, mean 5.5; from 2 to 3: mean difference +1, 95 % "
       "confidence 1 to 1, mean 6.5"},
      {"sweep T 1 2 3\nsweep s 1 2", /* the differences after one that fails are shown, too */
       "A.x increases with T over s",
       {0, 10, -1, 9, 2, 12},
       NB_FAIL,
       "; from 2 to 3: mean difference +3,"},
      {"sweep T 1 2\nsweep s 1 2", "A.x increases with T over s", {0, 10, 0, 10}, NB_FAIL, "confidence 0 to 0"},
      {"sweep T 1 2\nsweep s 1 2", "A.x decreases with T over s", {0, 10, 0, 10}, NB_FAIL, "confidence 0 to 0"},
      {"sweep T hot cold\nsweep s 1 2", "A.x decreases with T over s", {0, 10, 1, 11.1}, NB_FAIL, "from hot to cold"},
      {"sweep T hot cold\nsweep s 1 2", "A.x increases with T over s", {0, 10, 1, 11.1}, NB_PASS, "from hot to cold"},
      {"sweep T 1 2 3\nsweep s 1 2", "A.x increases with T over s", {0, 10, 1, 11, 0, 10}, NB_FAIL, ""},
      {"sweep T 2 1 3\nsweep s 1 2", "A.x increases with T over s", {1, 11.1, 0, 10, 2, 12.2}, NB_PASS, "from 1 to 2"},
      {"sweep T 2 1 3\nsweep s 1 2", "A.x increases with T over s", {0, 10, 1, 11.1, 2, 12.2}, NB_FAIL, "from 1 to 2"},
      {"sweep T 2 1 3\nsweep s 1 2", "A.x decreases with T over s", {1, 11.1, 2, 12.2, 0, 10}, NB_PASS, "from 2 to 3"},
      /* `constant` compares every two values, not only neighbours */
      {"sweep T 1 2 3\nsweep s 1 2",
       "A.x constant with T over s within 1",
       {0, 10, 1, 11, 2, 12},
       NB_FAIL,
       "; from 1 to 3: mean difference +2,"},
      {"sweep T 1 2 3\nsweep s 1 2",
       "A.x constant with T over s within 2",
       {0, 10, 1, 11, 2, 12},
       NB_PASS,
       "; from 2 to 3: mean difference +1,"},
      {"sweep T 1 2 3\nsweep s 1 2",
       "A.x constant with T over s within 1e300",
       {0, 10, 1, NAN, 2, 12},
       NB_FAIL,
       "it is nan"},
      {"sweep T 1 2\nsweep s 1 2", "A.x increases with T over s", {0, INFINITY, 1, 11}, NB_FAIL, "it is inf"},
      /* NaN in the first of several pairs, in the first or the second run of the pair */
      {"sweep T 1 2\nsweep s 1 2 3", "A.x increases with T over s", {NAN, 10, 20, 1, 11, 21}, NB_FAIL, "it is nan"},
      {"sweep T 1 2\nsweep s 1 2 3", "A.x increases with T over s", {0, 10, 20, NAN, 11, 21}, NB_FAIL, "it is nan"},
      {"sweep T 1 2\nsweep s 1 2\nlet b = T",
       "A.x increases with T over s",
       {0, 10, 1, 11},
       NB_PASS,
       "from 1 to 2: mean difference +1,"},
      {"sweep T 1 2\nsweep s 1 2 3 4", /* 3 -+ HALF */
       "A.x increases with T over s",
       {-4.5, 5.5, 15.5, 25.5, -2.5, 9.5, 17.5, 29.5},
       NB_PASS,
       "from 1 to 2: mean difference +3, 95 % confidence 1.163 to 4.837, mean 12"},
      {"sweep s 1 2\nsweep T 1 2",
       "A.x increases with T over s",
       {0, 1, 10, 11},
       NB_PASS,
       "from 1 to 2: mean difference +1, 95 % confidence 1 to 1, mean 5.5"},
  };
  planted_sweeps(list, COUNT(list));
  struct nb_outcome outcome; /* after an undefined value no difference is computed */
  planted_page(&outcome, "sweep T 1 2 3\nsweep s 1 2", "A.x increases with T over s");
  planted_runs(&outcome, (double[]){NAN, 10, 1, 11, 2, 12});
  planted_is(&outcome, NB_FAIL);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message, "`A.x` cannot be computed: it is nan at cycle 0");
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].label, "A.x increases with T over s"); /* about all values of T */
  nb_outcome_free(&outcome);
}

/* The verdict on an expected value over a sample is a note with its percentile among the runs. It fails only if a value
 * is not a finite number. */
static void among(void) {
  static const struct planted_sweep list[] = {
      {"sweep s 1 2 3 4",
       "A.x expected 3 over s [t]",
       {2, 5, 4, 3},
       NB_NOTE,
       "expected 3, within the range of 4 runs over s: 2 to 5, mean 3.5, standard deviation 1.3; percentile 38"},
      {"sweep s 1 2 3 4",
       "A.x expected 2 over s [t]",
       {3, 5, 4, 2},
       NB_NOTE, /* the percentile is 12.5, which is rounded to the even number */
       "within the range of 4 runs over s: 2 to 5, mean 3.5, standard deviation 1.3; percentile 12"},
      {"sweep s 1 2 3", /* values that would be rounded to other digits if they were a thousandth larger */
       "A.x expected 2 over s [t]",
       {2 - 1.2495, 2, 2 + 1.2495},
       NB_NOTE,
       "expected 2, within the range of 3 runs over s: 0.7505 to 3.25, mean 2, standard deviation 1.2; percentile 50"},
      {"sweep s 1 2 3 4",
       "A.x expected 5 over s [t]",
       {3, 5, 4, 2},
       NB_NOTE,
       "within the range of 4 runs over s: 2 to 5, mean 3.5"},
      {"sweep s 1 2 3 4",
       "A.x expected 1.999999 over s [t]",
       {3, 5, 4, 2},
       NB_NOTE,
       "outside the range of 4 runs over s"},
      {"sweep s 1 2 3 4", "A.x expected 5.000001 over s [t]", {3, 5, 4, 2}, NB_NOTE, "percentile 100"},
      {"sweep s 1 2 3 4",
       "A.x expected 5.000001 over s [t]",
       {3, 5, 4, 2},
       NB_NOTE,
       "outside the range of 4 runs over s"},
      {"sweep s 1 2 3 4", "A.x expected 1 over s [t]", {3, 5, 4, 2}, NB_NOTE, "percentile 0"},
      {"sweep s 1 2 3 4",
       "A.x expected -3 of A.vx over s [t]",
       {12, 20, 8, 4},
       NB_NOTE,
       "expected -3, within the range of 4 runs over s: -5 to -1, mean -2.75"},
      {"sweep s 1 2 3", "A.x expected 2 over s [t]", {1, 2, 3}, NB_NOTE, "mean 2, standard deviation 1; percentile 50"},
      {"sweep s 1 2 3", "A.x expected 2 over s [t]", {1, NAN, 3}, NB_FAIL, "it is nan"},
      {"sweep s 1 2 3", "A.y expected 2 of A.x over s [t]", {1, 0, 3}, NB_FAIL, "their ratio is not a finite number"},
  };
  planted_sweeps(list, COUNT(list));
  struct nb_outcome outcome;
  planted_page(&outcome, "sweep T 1 2\nsweep s 1 2", "A.x expected 2 over s [t]"); /* a sample for each T */
  planted_runs(&outcome, (double[]){1, 3, 5, 7});
  planted_is(&outcome, NB_NOTE);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 2);
  CU_ASSERT_STRING_EQUAL(outcome.checks[1].label, "A.x expected 2 over s [t] (T=2)");
  planted_says(&outcome, "within the range of 2 runs over s: 1 to 3, mean 2,");
  CU_ASSERT(strstr(outcome.checks[1].message, "outside the range of 2 runs over s: 5 to 7") != NULL);
  CU_ASSERT_EQUAL(outcome.mark_count[NB_NOTE], 2);
  nb_outcome_free(&outcome);
}

void suite_verdict_sample(void) {
  CU_pSuite suite = CU_add_suite("verdict_sample", NULL, NULL);
  CU_add_test(suite, "samples: the interval of 95 % confidence at its edges", samples);
  CU_add_test(suite, "an expected value over a sample is noted", among);
}
