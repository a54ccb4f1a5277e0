/* The stability limit of a stage before any contact has formed: pairs that are far apart count as if they touched.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "suites.h"
#include "written.h"

#define PAIR "units none\nmaterial m density 0.31830988618379067 kn 8\n" /* a disc of radius 1 has the mass 1 */

static double step; /* the first column at the end of the last run */

/* Runs a page with these statements. Returns the status; sets *error, `step`, and *cycles, the number of cycles. */
static enum nb_status ends(const char *statements, unsigned long *cycles, struct nb_error *error) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "%s", statements);
  written_scene(&it, &page);
  *error = (struct nb_error){0};
  const enum nb_status status = nb_run(&result, &it.scene, NULL, NULL, error);
  const struct nb_table *table = &result.table;
  *cycles = result.cycles;
  step = table->row_count > 0 ? table->values[(table->row_count - 1) * table->column_count] : 0;
  nb_result_free(&result);
  written_free(&it);
  return status;
}

/* Particles that are far apart may touch later. So the lightest two particles of each pair of materials count as if they
 * touched. The stable step is 2/omega, with omega^2 = k (1/m_1 + 1/m_2): 16 for two discs of radius 1, and 8 (1 + 1/9)
 * for the radii 1 and 3. */
static void pairs_that_may_meet(void) {
  static const struct {
    const char *statements;
    bool stops;
  } cases[] = {
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m\nstep 0.5\n", false},
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m\nstep 0.50001\n", true},
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m\nstep 0.6\nallow unstable\n", false},
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m fixed\nstep 0.7\n", false}, /* 2/8^(1/2) */
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m fixed\nstep 0.708\n", true},
      {"disc 0 0 radius 1 m\nwall w 90 -9 to 90 9 m\nstep 0.7\n", false},
      {"disc 0 0 radius 1 m\nwall w 90 -9 to 90 9 m\nstep 0.708\n", true},
      {"disc 0 0 radius 3 m\ndisc 6 0 radius 3 m\ndisc 90 0 radius 1 m\nstep 0.67\n", false}, /* the heavy ones touch */
      {"disc 0 0 radius 3 m\ndisc 6 0 radius 3 m\ndisc 90 0 radius 1 m\nstep 0.671\n", true},
      {"disc 0 0 radius 1 m\ndisc 90 0 radius 1 m\nstep 0.5\ndamping ratio 0.1\n", true},
      {"disc 0 0 radius 1 m\nstep 99\n", false}, /* a single disc */
  };
  unsigned long cycles;
  struct nb_error error;
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[512];
    snprintf(text, sizeof text, PAIR "%srecord time\nstage a\ncycles 2\n", cases[k].statements);
    CU_ASSERT_EQUAL(ends(text, &cycles, &error), cases[k].stops ? NB_BROKEN : NB_OK);
    CU_ASSERT_EQUAL(cycles, cases[k].stops ? 0 : 2);
    CU_ASSERT(!cases[k].stops || strstr(error.text, ", as if they touched: write `step "));
  }
#define APART PAIR "disc 0 0 radius 1 m\ndisc 90 0 radius 1 m\nrecord time\nstep 0.5\nstage a\ncycles 2\nstage b\n"
  CU_ASSERT_EQUAL(ends(APART "material m kn 8\ncycles 2\n", &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(APART "material m kn 8.01\ncycles 2\n", &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 2);
  CU_ASSERT_EQUAL(ends(APART "ramp material m kn 8.01\ncycles 2\n", &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 2);
  CU_ASSERT_EQUAL(ends(APART "material m kn 9\nallow unstable\ncycles 2\nstage c\nramp material m kn 8\ncycles 2\n",
                       &cycles, &error),
                  NB_BROKEN); /* the stage begins above the limit */
  CU_ASSERT_EQUAL(cycles, 4);
  CU_ASSERT_EQUAL(ends(APART "ramp material m kn 8.01\nallow unstable\ncycles 2\n", &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(
      ends(PAIR "disc 0 0 radius 3 m\ndisc 6 0 radius 3 m\ndisc 90 0 radius 1 m\nrecord step\nstep 0.5 of stable\n"
                "stage a\ncycles 1\n",
           &cycles, &error),
      NB_OK);
  CU_ASSERT_DOUBLE_EQUAL(step, 1 / sqrt(80. / 9), 1e-15);
}

/* A removed particle counts in no pair, although it was the only one of its material. The two discs that are left have
 * omega^2 = 16. So their stable step is 1/2, and their collision lasts pi/4. */
static void a_removed_particle_collides_with_none(void) {
  static const struct {
    const char *step;
    double wanted;
  } rows[] = {{"step 0.5 of stable", 0.25}, {"step 0.1 of collision", 0.07853981633974483}};
  unsigned long cycles;
  struct nb_error error;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[512];
    snprintf(text, sizeof text,
             PAIR "material b density 1 kn 8\npair m b kn 800\ndisc 0 0 radius 1 m\ndisc 9 0 radius 1 b\n"
                  "disc 90 0 radius 1 m\nrecord step\nstep 0.001\nstage a\ncycles 1\nstage b\nremove disc 2\n%s\n"
                  "cycles 1\n",
             rows[k].step);
    CU_ASSERT_EQUAL(ends(text, &cycles, &error), NB_OK);
    CU_ASSERT_DOUBLE_EQUAL(step, rows[k].wanted, 1e-15);
  }
}

/* A removed wall counts in no pair, unless another wall of its material is left, before it or after it in the page: its
 * contact would have omega^2 = 800. */
static void a_removed_wall_collides_with_none(void) {
  static const struct {
    const char *step;
    double none, another;
  } rows[] = {{"step 0.5 of stable", 0.25, 0.03535533905932738},
              {"step 0.1 of collision", 0.07853981633974483, 0.011107207345395915}};
  unsigned long cycles;
  struct nb_error error;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int another = 0; another < 3; another++) {
      char text[512];
      snprintf(text, sizeof text,
               PAIR "material b density 1 kn 8\npair m b kn 800\ndisc 0 0 radius 1 m\n%swall w 9 0 to 9 1 b\n%s"
                    "disc 90 0 radius 1 m\nrecord step\nstep 0.001\nstage a\ncycles 1\nstage b\nremove wall w\n%s\n"
                    "cycles 1\n",
               another == 1 ? "wall v 19 0 to 19 1 b\n" : "", another == 2 ? "wall v 19 0 to 19 1 b\n" : "",
               rows[k].step);
      CU_ASSERT_EQUAL(ends(text, &cycles, &error), NB_OK);
      CU_ASSERT_DOUBLE_EQUAL(step, another ? rows[k].another : rows[k].none, 1e-15);
    }
}

/* A stage with a step `of stable` begins with a search. Disc 3 leaves disc 2 so slowly that the run has made no other
 * search; with it, omega^2 would be 3 k/m = 24 and not 16. */
static void a_stage_searches_for_its_step(void) {
  unsigned long cycles;
  struct nb_error error;
  CU_ASSERT_EQUAL(ends(PAIR "disc 0 0 radius 1 m\ndisc 2 0 radius 1 m\ndisc 4.095 0 radius 1 m velocity 0.5 0\n"
                            "record step\nstep 0.001\nstage a\ncycles 40\nstage b\nstep 0.5 of stable\ncycles 1\n",
                       &cycles, &error),
                  NB_OK);
  CU_ASSERT_DOUBLE_EQUAL(step, 0.25, 1e-15);
}

/* With the step that the message advises, the run continues. The advised step has the unit of the step in the page, or
 * the same words `of …` or `per collision`. */
static void the_advised_step_is_stable(void) {
  static const char springs[] =
      "material m density 0.3 kg/m3 kn 8 N/m\ndisc 0 m 0 m radius 1 m m\ndisc 1.9 m 0 m radius 1 m m\n";
  static const char bare[] = "units none\nmaterial m density 0.3 kn 8\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\n";
  static const char elastic[] =
      "units none\nmaterial m density 1 young 1000 poisson 0.25\nnormal hertz\nsphere 0 0 radius 1 m velocity 1e-3 0\n"
      "sphere 1.99 0 radius 1 m\n";
  static const struct {
    const char *head, *step, *small;
  } cases[] = {
      {springs, "step 5 s", "step 1 ms"},
      {bare, "step 5", "step 0.001"},
      {bare, "step 9 of single-contact", "step 0.001"},
      {bare, "step 9 of stable", "step 0.001"},
      {elastic, "step 99 of rayleigh", "step 0.001"},
      {elastic, "step 99 of rayleigh-mean", "step 0.001"},
      {elastic, "step 99 of rayleigh-fit", "step 0.001"},
      {elastic, "step 99 of rayleigh-fit-mean", "step 0.001"},
      {elastic, "step 1 per collision", "step 0.001"},
  };
  unsigned long cycles;
  struct nb_error error;
  for (size_t k = 0; k < 2 * sizeof cases / sizeof *cases; k++) {
    const bool later = k % 2;
    const char *const head = cases[k / 2].head, *const small = cases[k / 2].small;
    static const char *const format = "%s%s\nrecord time\nstage a\ncycles 2\nstage b\n%s\ncycles 2\n";
    char text[512], advice[64] = "";
    snprintf(text, sizeof text, format, head, later ? small : cases[k / 2].step, later ? cases[k / 2].step : "");
    CU_ASSERT_EQUAL(ends(text, &cycles, &error), NB_BROKEN);
    const char *const given = strstr(error.text, "write `step ");
    CU_ASSERT_FATAL(given && sscanf(given, "write `%63[^`]", advice) == 1);
    const char *const way = strpbrk(cases[k / 2].step + 5, " "), *const its = strpbrk(advice + 5, " ");
    CU_ASSERT(way && its ? strcmp(way, its) == 0 : way == its);
    snprintf(text, sizeof text, format, head, later ? small : advice, later ? advice : "");
    CU_ASSERT_EQUAL(ends(text, &cycles, &error), NB_OK);
  }
}

void suite_apart(void) {
  CU_pSuite suite = CU_add_suite("apart", NULL, NULL);
  CU_add_test(suite, "pairs that could collide later", pairs_that_may_meet);
  CU_ADD_TEST(suite, a_removed_particle_collides_with_none);
  CU_ADD_TEST(suite, a_removed_wall_collides_with_none);
  CU_ADD_TEST(suite, a_stage_searches_for_its_step);
  CU_ADD_TEST(suite, the_advised_step_is_stable);
}
