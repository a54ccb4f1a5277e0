/* Tests that a rounding mode of the processor applies to the parts of a cycle that the options name, and in all
 * threads. Also tests the number of bits that two results have in common.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <fenv.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/report/bits.h"
#include "../src/run/restart.h"
#include "planted.h"
#include "suites.h"
#include "written.h"

static const int modes[NB_ROUNDINGS] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

static struct nb_options options_of(int mode, const char *part, int threads) {
  return (struct nb_options){.threads = threads, .rounding = {.mode = mode, .part = part}};
}

/* A free disc: x_(N+1) = x_N + v dt, where the product and the sum are rounded. The test computes the same sums in the
 * same mode. A mode that applies to the part `search` does not change the motion. */
static void motion_rounds_as_asked(void) {
  enum { CYCLES = 200 };
  static const char *const parts[] = {NULL, "motion", "search"};
  for (int mode = 0; mode < NB_ROUNDINGS; mode++)
    for (int part = 0; part < 3; part++) {
      struct written it;
      struct words page = {0};
      struct nb_result result;
      const struct nb_options options = options_of(mode, parts[part], 1);
      words_add(&page,
                "units none\nmaterial a density 1 kn 1\ndisc 0.1 -0.1 radius 1 a velocity 0.7 -0.7\nstep 0.01\n"
                "monitor A disc 1\nrecord A.x A.y\nstage s\ncycles %d\n",
                CYCLES);
      written_scene(&it, &page);
      written_run(&result, &it, &options);
      CU_ASSERT(fegetround() == FE_TONEAREST);
      volatile double x = 0.1, y = -0.1, dt = 0.01, v = 0.7;
      fesetround(modes[part == 2 ? 0 : mode]);
      for (int n = 0; n < CYCLES; n++)
        x += dt * v, y += dt * -v;
      fesetround(FE_TONEAREST);
      CU_ASSERT(written_last(&result, "A.x") == x);
      CU_ASSERT(written_last(&result, "A.y") == y);
      nb_result_free(&result), written_free(&it);
    }
}

/* A heap of discs that touch, with friction and gravity. It is so large that two or more threads have contacts. */
static void heap(struct written *it) {
  struct words page = {0};
  words_add(&page, "units none\nmaterial a density 1 kn 1000 ks 700 friction 0.3\nshear linear\nlattice discs 24 by 24 "
                   "from 1 1 radius 1 "
                   "spacing 1.99 a\ndisc 20.3 48.5 radius 1.1 a velocity 0.3 -0.8\ngravity 0 -0.1\ndamping ratio "
                   "0.1\nstep 0.01\nmonitor A disc 562\n"
                   "record A.x A.y A.spin A.vx energy.kinetic\nstage s\ncycles 60\nrecord every 5 cycles\n");
  written_scene(it, &page);
}

/* Each thread uses the mode: results in a mode differ from those with rounding to nearest, but they do not depend on
 * the number of threads. After the run all threads round to nearest again. */
static void all_threads_round(void) {
  struct written it;
  struct nb_result nearest, one, other;
  heap(&it);
  const struct nb_options plain = options_of(NB_TO_NEAREST, NULL, 1);
  written_run(&nearest, &it, &plain);
  for (int mode = NB_UPWARD; mode < NB_ROUNDINGS; mode++) {
    const struct nb_options single = options_of(mode, NULL, 1);
    written_run(&one, &it, &single);
    const size_t bytes = one.table.row_count * one.table.column_count * sizeof(double);
    CU_ASSERT(one.table.row_count == 13 && memcmp(one.table.values, nearest.table.values, bytes) != 0);
    for (int threads = 2; threads <= 4; threads++) {
      const struct nb_options several = options_of(mode, NULL, threads);
      written_run(&other, &it, &several);
      CU_ASSERT(memcmp(one.table.values, other.table.values, bytes) == 0);
      nb_result_free(&other);
    }
    int kept = 0;
#pragma omp parallel for num_threads(4) reduction(+ : kept)
    for (int thread = 0; thread < 4; thread++)
      kept += fegetround() != FE_TONEAREST;
    CU_ASSERT(kept == 0);
    nb_result_free(&one);
  }
  nb_result_free(&nearest), written_free(&it);
}

/* A mode that applies to only one part of the cycle changes the result if, and only if, this part computes positions or
 * forces. */
static void parts_round_alone(void) {
  static const struct {
    const char *part;
    bool changes;
  } rows[] = {{"motion", true},
              {"disc-disc, overlap and both increments", true},
              {"normal linear", true},
              {"shear linear", true},
              {"dashpots, damping ratio", true},
              {"resolve, normal and shear", true},
              {"search", false},
              {"stability check", false},
              {"no such part", false}};
  struct written it;
  struct nb_result nearest, one;
  heap(&it);
  const struct nb_options plain = options_of(NB_TO_NEAREST, NULL, 1);
  written_run(&nearest, &it, &plain);
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    const struct nb_options options = options_of(NB_UPWARD, rows[r].part, 1);
    written_run(&one, &it, &options);
    const bool changed = memcmp(one.table.values, nearest.table.values,
                                nearest.table.row_count * nearest.table.column_count * sizeof(double)) != 0;
    CU_ASSERT(changed == rows[r].changes);
    if (changed != rows[r].changes)
      printf("# %s\n", rows[r].part);
    nb_result_free(&one);
  }
  nb_result_free(&nearest), written_free(&it);
}

/* A mode applies to the steps of a contact test, and so to the work, which is a sum of products. */
static void contact_tests_round(void) {
  for (int mode = 0; mode < NB_ROUNDINGS; mode++) {
    struct written it;
    struct words page = {0};
    struct nb_result result;
    const struct nb_options options = options_of(mode, NULL, 1);
    words_add(&page, "path\nunits none\nmaterial a kn 0.7 ks 0.7 friction 1\ncontact disc 1 a with disc 1 a\n"
                     "normal linear\nrecord overlap normal work.normal\nsegment s overlap to 0.3 in 30 steps\n");
    written_scene(&it, &page);
    written_run(&result, &it, &options);
    CU_ASSERT(fegetround() == FE_TONEAREST);
    volatile double work = 0;
    for (size_t r = 1; r < result.table.row_count; r++) {
      const double before = written_cell(&result.table, r - 1, "overlap"),
                   now = written_cell(&result.table, r, "overlap");
      volatile double from = before, to = now, first = written_cell(&result.table, r - 1, "normal"),
                      force = written_cell(&result.table, r, "normal"), k = 0.7;
      fesetround(modes[mode]);
      CU_ASSERT(force == k * to);
      work += (first + force) / 2 * (to - from);
      fesetround(FE_TONEAREST);
    }
    CU_ASSERT(written_last(&result, "work.normal") == work);
    nb_result_free(&result), written_free(&it);
  }
}

/* A shear force of 2 at a normal force of 1 and a friction of 1 ends the run. The message is written with rounding to
 * nearest. */
static void a_contact_test_that_fails_ends_the_rounding(void) {
  struct written it;
  struct words page = {0};
  struct nb_result result;
  struct nb_error error;
  const struct nb_options options = options_of(NB_UPWARD, NULL, 1);
  words_add(&page, "path\nunits none\nmaterial a kn 1 ks 1 friction 1\ncontact disc 1 a with disc 1 a\nnormal linear\n"
                   "segment s normal to 1 in 1 steps\nsegment t shear to 2 hold normal in 1 steps\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, &options, NULL, &error), NB_BROKEN);
  CU_ASSERT(fegetround() == FE_TONEAREST);
  nb_result_free(&result), written_free(&it);
}

/* A saved state is made with rounding to nearest, whatever the mode of the run that needs it. */
static void states_do_not_depend_on_the_mode(void) {
  struct written it;
  struct nb_error error;
  heap(&it);
  struct nb_saved nearest = {0}, up = {0};
  const struct nb_options options[] = {options_of(NB_TO_NEAREST, NULL, 1), options_of(NB_UPWARD, NULL, 1)};
  CU_ASSERT(nb_run_to(&nearest, &it.scene, &options[0], NULL, &error) == NB_OK);
  CU_ASSERT(nb_run_to(&up, &it.scene, &options[1], NULL, &error) == NB_OK);
  CU_ASSERT(nearest.particle_count == 577 && memcmp(nearest.particles, up.particles, 577 * sizeof *up.particles) == 0);
  nb_saved_free(&nearest), nb_saved_free(&up), written_free(&it);
}

static void bits_are_counted(void) {
  CU_ASSERT(nb_common_bits(2, 2, 2) == 53 && nb_common_bits(0, 0, 0) == 53);
  CU_ASSERT(nb_common_bits(1 + 0x1p-10, 1, 1) == 10 && nb_common_bits(1 - 0x1p-10, 1, 1) == 10);
  CU_ASSERT(nb_common_bits(1 + 1.01 * 0x1p-10, 1, 1) == 9 && nb_common_bits(1 + 0.99 * 0x1p-10, 1, 1) == 10);
  CU_ASSERT(nb_common_bits(4 + 0x1p-10, 4, 4) == 12); /* relative to the scale 4 */
  CU_ASSERT(nb_common_bits(1 + 0x1p-52, 1, 1) == 52 && nb_common_bits(0x1p-70, 0, 1) == 53);
  CU_ASSERT(nb_common_bits(3, 1, 1) == 0 && nb_common_bits(1, 0, 0) == 0);
  CU_ASSERT(nb_common_bits(NAN, 1, 1) == 0 && nb_common_bits(1, 1.5, NAN) == 0 && nb_common_bits(INFINITY, 1, 1) == 0);
}

/* Rows 0 to 2 belong to stage one, rows 3 and 4 to stage two. In row k the two results of A.x, and of energy.balance,
 * which equals A.x (planted.h), differ by 2^-(k + 10). The number of common bits follows from the difference relative
 * to the scale of the tolerance. */
static void bits_of_expectations(void) {
  static const double x[] = {1, 2, 8, 2, 4};
  static const struct {
    const char *expectation;
    int bits; /* -1: the quantity has no bits to compare */
  } rows[] = {
      {"A.x versus time in one within 1 % of peak", 13}, /* 2^-10 in row 0, relative to the peak 8 */
      {"A.x versus time in two within 1 % of peak", 16}, /* 2^-13 in row 3, relative to the peak 8 */
      {"A.x within 1 %", 16},                            /* 2^-14 in the last row, relative to 4 */
      {"A.x at 10 cycles expected 2 within 1 % [t]", 12},
      {"A.x at 0 cycles expected 1 within 1 [t]", 13}, /* with an absolute tolerance, relative to the largest value */
      {"A.x within 1 % of A.x max in one", 17},        /* relative to 8 */
      {"A.x expected -1 of A.vx within 1 % [t]", 16},
      {"A.x expected -1 of A.vx within 0.01 [t]", 16}, /* a ratio is its own scale */
      {"A.x expected -1 of A.vx within 9 [t]", 16},    /* also if no value exceeds the tolerance of the ratio */
      {"A.x max in one above A.y max", 15},
      {"A.y max expected 4 within 1 % [t]", 53},
      {"A.x expected 0 within 8 [t]", -1}, /* no value differs from 0 by more than the tolerance */
      {"A.x expected 0 within 7 [t]", 17},
      {"A.vx expected 0 within 4 [t]", -1}, /* its largest magnitude is 4 */
      {"A.vx expected 0 within 3 [t]", 53},
      {"energy.balance within 1e-12 of A.x", -1},
      {"A.x in one within 1 % of A.x max in two", 14}, /* 2^-12 in row 2, relative to 4 */
  };
  struct words list = {0};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    words_add(&list, "%s\n", rows[k].expectation);
  struct nb_outcome nearest, other;
  double y[5];
  for (int r = 0; r < 5; r++)
    y[r] = x[r] - ldexp(1, -10 - r);
  planted_page(&nearest, "", list.text), planted_page(&other, "", list.text);
  planted_rows(&nearest, 0, 5, x), planted_rows(&other, 0, 5, y);
  CU_ASSERT_EQUAL_FATAL(nearest.runs[0].expectations.count, sizeof rows / sizeof *rows);
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const bool has = nb_expected_has_bits(&nearest.runs[0], k);
    const int bits = nb_expected_bits(&other.runs[0], &nearest.runs[0], k);
    CU_ASSERT(has == (rows[k].bits >= 0) && bits == (has ? rows[k].bits : 53));
    if (bits != rows[k].bits && has)
      printf("# %s: %d\n", rows[k].expectation, bits);
  }
  nb_outcome_free(&other);
  planted_page(&other, "", list.text), planted_rows(&other, 0, 4, x); /* stage two ends earlier in the other mode */
  CU_ASSERT(nb_expected_bits(&other.runs[0], &nearest.runs[0], 0) == 53);
  CU_ASSERT(nb_expected_bits(&other.runs[0], &nearest.runs[0], 1) == 0);
  CU_ASSERT(nb_expected_bits(&nearest.runs[0], &other.runs[0], 1) == 0); /* or ends later */
  nb_outcome_free(&other);
  static const double earlier[] = {1, 2, 2, 4}; /* stage one ends earlier, and stage two has the same rows */
  planted_page(&other, "", list.text), planted_rows(&other, 0, 4, earlier);
  other.runs[0].result.table.stage[2] = 1;
  CU_ASSERT(nb_expected_bits(&other.runs[0], &nearest.runs[0], 1) == 53);
  CU_ASSERT(nb_expected_bits(&nearest.runs[0], &other.runs[0], 1) == 53);
  nb_outcome_free(&other);
  planted_page(&other, "", list.text), planted_rows(&other, 0, 3, x); /* stage two records nothing */
  CU_ASSERT(nb_expected_bits(&other.runs[0], &nearest.runs[0], 3) == 53);
  CU_ASSERT(nb_expected_bits(&other.runs[0], &nearest.runs[0], 2) == 0);
  const size_t scaled = sizeof rows / sizeof *rows - 1; /* its scale cannot be computed */
  CU_ASSERT(nb_expected_bits(&nearest.runs[0], &other.runs[0], scaled) == 0);
  nb_outcome_free(&other), nb_outcome_free(&nearest);
  free(list.text);
}

/* A quantity that is exactly 0 has bits only if the tolerance is 0. */
static void bits_of_a_quantity_that_is_0(void) {
  static const double zeros[5] = {0}, tiny[5] = {0, 0, 0, 0, 1e-300};
  struct nb_outcome nearest, other;
  planted_page(&nearest, "", "A.x expected 0 within 0 [t]\nA.x expected 0 within 1 [t]\n");
  planted_page(&other, "", "A.x expected 0 within 0 [t]\nA.x expected 0 within 1 [t]\n");
  planted_rows(&nearest, 0, 5, zeros), planted_rows(&other, 0, 5, tiny);
  CU_ASSERT(nb_expected_has_bits(&nearest.runs[0], 0) && !nb_expected_has_bits(&nearest.runs[0], 1));
  CU_ASSERT_EQUAL(nb_expected_bits(&nearest.runs[0], &nearest.runs[0], 0), 53);
  CU_ASSERT_EQUAL(nb_expected_bits(&other.runs[0], &nearest.runs[0], 0), 0);
  nb_outcome_free(&other), nb_outcome_free(&nearest);
}

void suite_rounding(void) {
  CU_pSuite suite = CU_add_suite("rounding", NULL, NULL);
  CU_ADD_TEST(suite, motion_rounds_as_asked);
  CU_ADD_TEST(suite, all_threads_round);
  CU_ADD_TEST(suite, parts_round_alone);
  CU_ADD_TEST(suite, contact_tests_round);
  CU_ADD_TEST(suite, a_contact_test_that_fails_ends_the_rounding);
  CU_ADD_TEST(suite, states_do_not_depend_on_the_mode);
  CU_ADD_TEST(suite, bits_are_counted);
  CU_ADD_TEST(suite, bits_of_expectations);
  CU_ADD_TEST(suite, bits_of_a_quantity_that_is_0);
}
