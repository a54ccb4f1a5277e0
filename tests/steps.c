/* The step of a page as a share of what, and the watch that stops a run whose step is not safe any more.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "suites.h"
#include "written.h"

/* ---- the step of a page ---- */

#define PAIR "units none\nmaterial m density 0.31830988618379067 kn 8\n" /* a disc of radius 1 has the mass 1 */

static double step_of(const char *statements) {
  struct words page = {0};
  struct written it;
  words_add(&page, "%srecord step\nstage s\ncycles 1\n", statements);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const double step = written_now(model, "step");
  nb_model_free(model);
  written_free(&it);
  return step;
}

static void a_step_is_a_share(void) {
  /* omega^2 = 2 k/m = 16 */
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 m\nstep 50 % of stable\n"), 0.25, 1e-15);
  /* near, though not touching, counts; two that are far apart count as if they met, and so does a wall alone */
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 spacing 2.09 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 spacing 5 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "disc 0 5 radius 1 m\nwall w -3 0 to 3 0 m\nstep 0.5 of stable\n"), sqrt(0.125), 1e-15);
  /* pi sqrt(M/k): two equal masses, and two of which one is heavy; the lightest two of three; at a wall */
  const double pi = 3.14159265358979323846;
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 spacing 5 m\nstep 0.5 of collision\n"), pi / 8, 1e-15);
  NEAR(step_of(PAIR "disc 0 0 radius 1 m\ndisc 9 0 radius 3 m\nstep 1 of collision\n"), pi * sqrt(0.9 / 8), 1e-15);
  NEAR(step_of(PAIR "disc 9 0 radius 3 m\nlattice discs 2 by 1 radius 1 m\nstep 1 of collision\n"), pi / 4, 1e-15);
  NEAR(
      step_of(PAIR "disc 9 0 radius 3 m\nlattice discs 2 by 1 radius 1 m\ndisc 30 0 radius 2 m\nstep 1 of collision\n"),
      pi / 4, 1e-15);
  NEAR(step_of(PAIR "disc 9 0 radius 3 m\ndisc 0 0 radius 1 m\nstep 1 of collision\n"), pi * sqrt(0.9 / 8), 1e-15);
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 m\ndisc 30 0 radius 2 m\nstep 1 of collision\n"), pi / 4, 1e-15);
  NEAR(step_of(PAIR "disc 0 5 radius 1 m\nwall w -3 0 to 3 0 m\nstep 1 of collision\n"), pi / sqrt(8), 1e-15);
  /* a lighter particle of another material does not stand for those of the pair */
  NEAR(step_of(PAIR
               "material b density 0.01 kn 8\npair m b kn 1e-6\npair b b kn 1e-6\nmaterial s kn 8\npair b s kn 1e-6\n"
               "disc 0 5 radius 1 m\ndisc 9 5 radius 1 b\nwall w -3 0 to 3 0 s\nstep 1 of collision\n"),
       pi / sqrt(8), 1e-15);
  /* nor does one particle make a pair of its own */
  NEAR(step_of(PAIR
               "material s kn 8\npair m s kn 1e-4\ndisc 0 5 radius 1 m\nwall w -3 0 to 3 0 s\nstep 1 of collision\n"),
       pi * 100, 1e-15);
  /* and the critical one, of springs however soft */
  NEAR(step_of("units none\nmaterial m density 0.31830988618379067 kn 1e-4\ndisc 0 0 radius 1 m\nstep 0.5 of "
               "single-contact\n"),
       100., 1e-15);
  NEAR(step_of("units none\nmaterial m density 0.31830988618379067 kn 1e-4\nlattice discs 2 by 1 radius 1 m\nstep 1 of "
               "collision\n"),
       pi * sqrt(0.5e4), 1e-15);
}

/* ---- elastic spheres: how long they stay together goes with their speed ---- */

/* E* = 1/2 of two unlike rigid and E = 1/2, nu = 0; of like ones E/2. A sphere of radius 1 has the mass 1. */
#define SPHERES                                                                                                        \
  "units none\nnormal hertz\nmaterial m density 0.238732414637843 young 1 poisson 0\nmaterial r density "              \
  "0.238732414637843 rigid\nmaterial w density 0.238732414637843 young 0.5 poisson 0\n"

static double hertz(double young, double radius, double mass, double speed) {
  const double pi = 3.14159265358979323846, beta = sqrt(pi) * tgamma(0.4) / tgamma(0.9);
  return 0.8 * beta * pow(15 * mass * speed * speed / (16 * young * sqrt(radius)), 0.4) / speed;
}

static void a_contact_of_spheres(void) {
  NEAR(hertz(1, 1, 1, 1) * pow(16. / 15, 0.4), 2.9432751843247047, 1e-15);
  /* two that fly at each other, one at a wall, a wall at one, in its first stage and before */
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 0.2 0\nsphere 5 0 radius 1 m velocity -0.1 0\nstep 0.1 of "
                       "collision\n"),
       0.1 * hertz(0.5, 0.5, 0.5, 0.3), 1e-14);
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity 2 -0.1\nwall w -90 0 to 90 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.1) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 0 -3 radius 1 m velocity 2 0.1\nwall w -90 0 to 90 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.1) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m\nwall w -90 0 to 90 0 r velocity 0 0.1\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.1) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 3 1.5 radius 1 m\nwall w -90 0 to 90 0 r spin 0.1\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.3) / 20, 1e-14);
  /* at an end of a wall, as at a point; what flies past it meets nothing, and what it leaves behind neither */
  const double bent = 0.2 * sqrt(1 - 0.36);
  NEAR(step_of(SPHERES "sphere 0.6 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, bent), 1e-14);
  NEAR(step_of(SPHERES "sphere -9.6 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, bent), 1e-14);
  NEAR(step_of(SPHERES "sphere 1.1 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nwall v -9 9 to 9 9 r\n"
                       "sphere 5 8.2 radius 0.1 m velocity 0 0.001\nstep 1 of collision\n"),
       hertz(1, 0.1, 0.001, 0.001), 1e-14);
  /* askew: they close along their centres when they touch, both ways round; the next one would be missed */
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 0.3 0\nsphere 5 0.8 radius 1 m\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.3 * sqrt(1 - 0.16)), 1e-14);
  NEAR(step_of(SPHERES "sphere 5 -0.8 radius 1 m\nsphere 0 0 radius 1 m velocity 0.3 0\nsphere 5 9 radius 1 m velocity "
                       "-9 0\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.3 * sqrt(1 - 0.16)), 1e-14);
  /* what touches already, at a wall and at each other: as fast as it closes now */
  NEAR(step_of(SPHERES "sphere 0 0.99 radius 1 m velocity 4 -0.1\nwall w -9 0 to 9 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, 0.1), 1e-14);
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 0.5 0\nsphere 1.2 1.59 radius 1 m\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.5 * 1.2 / hypot(1.2, 1.59)), 1e-14);
  /* of several the shortest: small, hard, fast ones; what is fixed weighs without end; two that are fixed do not count */
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 1 0\nsphere 5 0 radius 1 m\nsphere 0 9 radius 0.5 m velocity 1 "
                       "0\nsphere 5 9 radius 0.5 m\nstep 1 of collision\n"),
       hertz(0.5, 0.25, 0.0625, 1), 1e-14);
  NEAR(step_of(SPHERES
               "sphere 0 0 radius 1 m velocity 1 0\nsphere 5 0 radius 3 w fixed\nsphere 0 9 radius 0.1 r velocity "
               "9 0 fixed\nsphere 5 9 radius 0.1 m fixed\nstep 1 of collision\n"),
       hertz(1. / 3, 0.75, 1, 1), 1e-14);
}

/* Springs of no stiffness, or nothing that may move: no share of that is a step. */
static void a_step_without_end(void) {
  static const char *const particles[] = {"kn 0\ndisc 0 0 radius 1 m", "kn 8\ndisc 0 0 radius 1 m fixed"};
  for (size_t n = 0; n < 2; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page, "units none\nmaterial m density 1 %s\nstep 0.1 of single-contact\nstage s\ncycles 1\n",
              particles[n]);
    written_scene(&it, &page);
    CU_ASSERT_PTR_NULL(nb_model_create(&it.scene, NULL, &error));
    CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "the step is computed as inf:"));
    CU_ASSERT_EQUAL(error.line, 5);
    written_free(&it);
  }
}

static void no_step_for_spheres(void) {
  static const struct {
    const char *statements, *words;
    int line; /* 0: any */
  } pages[] = {
      {"sphere 0 3 radius 1 m\nsphere 9 3 radius 1 m velocity 1 0\nstep 1 of collision\n", "no pair approaches", 9},
      {"gravity 0 -9\nsphere 0 3 radius 1 m\nwall w -9 0 to 9 0 r\nstep 9 per collision\n", "no pair approaches", 10},
      {"sphere 0 3 radius 1 m\nstep 0.1 of stable\n", "the stable step follows from the stiffness", 8},
      {"lattice spheres 3 by 1 radius 1 m\nstep 0.1 of stable\n",
       "elastic spheres without overlap have none: write `N per collision`", 0},
      {"lattice spheres 2 by 1 radius 1 spacing 1.9 m\nstep 0.1 of single-contact\n",
       "elastic spheres have no single-contact step", 8},
  };
  for (size_t n = 0; n < sizeof pages / sizeof *pages; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page, "%s%sstage s\ncycles 1\n", SPHERES, pages[n].statements);
    written_scene(&it, &page);
    CU_ASSERT_PTR_NULL(nb_model_create(&it.scene, NULL, &error));
    CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
    CU_ASSERT_TRUE(!pages[n].line || error.line == pages[n].line);
    if (!strstr(error.text, pages[n].words))
      printf("# `%s` is not in: %s\n", pages[n].words, error.text);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, pages[n].words));
    written_free(&it);
  }
  /* pressed, they have one: 2/omega, omega^2 = k/M*, k = 2 E* (R* overlap)^(1/2) */
  NEAR(step_of(SPHERES "lattice spheres 2 by 1 radius 1 spacing 1.9 m\nstep 0.5 of stable\n"), sqrt(0.5 / sqrt(0.05)),
       1e-14);
  NEAR(step_of(SPHERES "lattice spheres 2 by 1 radius 1e-3 spacing 1.9999e-3 m\nstep 0.5 of stable\n"),
       sqrt(5e-10 / sqrt(5e-11)), 1e-10);
}

/* A stage that says nothing keeps the step, though nothing approaches any more; one that says it again looks again. */
static void the_step_of_a_contact_stays(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(
      &page,
      "%swall w -9 0 to 9 0 r\nsphere 0 1.1 radius 1 m velocity 0 -1\nstep 40 per collision\nrecord step\n"
      "stage hit\ncycles 1\nstage off\nreverse velocities\nrecord none\ncycles 1\nstage out\nrecord none\ncycles 2\n"
      "stage slow\nwall w velocity 0 3\nstep 40 "
      "per collision\ncycles 1\n",
      SPHERES);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(result.table.row_count, 3);
  for (size_t row = 0; row < result.table.row_count; row++)
    NEAR(result.table.values[row], hertz(1, 1, 1, row == 2 ? 2 : 1) / 40, 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* ---- the watch ---- */

/* How a run of these statements ends; its cycles, its last words. */
static enum nb_status ends(const char *statements, unsigned long *cycles, struct nb_error *error) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "%s", statements);
  written_scene(&it, &page);
  *error = (struct nb_error){0};
  const enum nb_status status = nb_run(&result, &it.scene, NULL, NULL, error);
  *cycles = result.cycles;
  nb_result_free(&result);
  written_free(&it);
  return status;
}

static void says(const struct nb_error *error, const char *words) {
  if (!strstr(error->text, words))
    printf("# `%s` is not in: %s\n", words, error->text);
  CU_ASSERT_PTR_NOT_NULL(strstr(error->text, words));
}

/* A third disc comes from 1 away; two that touch stand 0.5, three in a row 2/sqrt(24), 0.408. */
#define COMING(step, allow)                                                                                            \
  PAIR "lattice discs 2 by 1 radius 1 m\ndisc 6 1 radius 1 m velocity -0.025 0\nstep " step "\n" allow                 \
       "record time\nstage s\ncycles 200\n"

static void a_bound_that_is_crossed_stops_the_run(void) {
  unsigned long cycles;
  struct nb_error error;
  CU_ASSERT_EQUAL(ends(COMING("0.45", ""), &cycles, &error), NB_BROKEN);
  CU_ASSERT(cycles >= 80 && cycles <= 85); /* listed at a gap of 0.1, when something has gone half of that */
  says(&error, "particle 1 (line 4)");
  says(&error, "normal motion of particles 1 and 2");
  says(&error, "the step 0.45 is");
  says(&error, "one, 0.408248, which");
  char words[64];
  snprintf(words, sizeof words, "at cycle %lu, time %g,", cycles, 0.45 * (double)cycles);
  says(&error, words);
  CU_ASSERT_EQUAL(ends(COMING("0.35", ""), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(COMING("0.45", "allow unstable\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(cycles, 200);
}

static void a_stage_is_looked_at_as_it_begins(void) {
  unsigned long cycles;
  struct nb_error error;
#define STAGES(first, second)                                                                                          \
  PAIR "lattice discs 2 by 1 radius 1 m\nstep 0.4\nrecord time\nstage a\n" first "cycles 3\nstage b\n" second          \
       "cycles 5\n"
  CU_ASSERT_EQUAL(ends(STAGES("", ""), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "step 0.6\n"), &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 3);
  CU_ASSERT_EQUAL(ends(STAGES("", "step 0.6\nallow unstable\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("step 0.6\nallow unstable\n", ""), &cycles, &error), NB_BROKEN); /* b has that step too */
  CU_ASSERT_EQUAL(cycles, 3);
  CU_ASSERT_EQUAL(ends(STAGES("", "damping ratio 0.2\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "damping ratio 0.3\n"), &cycles, &error), NB_BROKEN);            /* 0.372 */
  CU_ASSERT_EQUAL(ends(STAGES("", "damping con1 0.2 as velocity\n"), &cycles, &error), NB_BROKEN); /* 0.387 */
  CU_ASSERT_EQUAL(ends(STAGES("", "material m kn 20\n"), &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(ends(STAGES("", "material m kn 20\nstep 1 of stable\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "ramp material m kn 20\nstep 1 of stable\n"), &cycles, &error), NB_OK);
}

/* Nothing is searched here. The bound of three in a row, 3 k = 4/0.4^2, is crossed at k = 8.33, after 2424 cycles: the next look
 * finds it. That of a pair, 2 k, is not, or the stage would not begin. */
static void it_looks_now_and_then(void) {
  unsigned long cycles;
  struct nb_error error;
  CU_ASSERT_EQUAL(ends(PAIR "lattice discs 3 by 1 radius 1 m\nstep 0.4\nrecord time\nstage a\nrecord none\n"
                            "ramp material m kn 8.55\ncycles 4000\n",
                       &cycles, &error),
                  NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 3000);
}

/* The watch reads, and writes nothing: the same bits with it and without it. */
static void the_watch_changes_no_bit(void) {
  double last[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nshear linear\nmaterial m density 1 kn 1000 ks 700 friction 0.3\nbox 0 0 to 8 8 m\n"
        "lattice discs 3 by 3 radius 1 spacing 2.2 m\ndisc 7 7 radius 0.8 m velocity -1 -0.7\n%s"
        "step 0.2 of stable\nmonitor D disc 10\nrecord D.x\nstage s\nrecord none\ncycles 3000\nstage e\ncycles 1\n",
        k ? "allow unstable\n" : "");
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT(result.searches > 3);
    last[k] = written_last(&result, "D.x");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT(last[0] == last[1]);
}

void suite_steps(void) {
  CU_pSuite suite = CU_add_suite("steps", NULL, NULL);
  CU_add_test(suite, "a step is a share", a_step_is_a_share);
  CU_add_test(suite, "a contact of spheres", a_contact_of_spheres);
  CU_add_test(suite, "no step for spheres", no_step_for_spheres);
  CU_add_test(suite, "the step of a contact stays", the_step_of_a_contact_stays);
  CU_add_test(suite, "a step without end", a_step_without_end);
  CU_add_test(suite, "a bound that is crossed stops the run", a_bound_that_is_crossed_stops_the_run);
  CU_add_test(suite, "a stage is looked at as it begins", a_stage_is_looked_at_as_it_begins);
  CU_add_test(suite, "it looks now and then", it_looks_now_and_then);
  CU_add_test(suite, "the watch changes no bit", the_watch_changes_no_bit);
}
