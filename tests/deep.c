/* Dashpots of elastic spheres, `damping walls`, and deep contacts, which are counted, named and damped critically.
 * [R89 4.13, 4.19, sec. 6.4.3]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/step.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static struct nb_model *model_of(struct written *it, const char *first, const char *second) {
  struct words page = {0};
  words_add(&page, "units none\n%s%s", first, second);
  written_scene(it, &page);
  return written_model(it, NULL);
}

/* E* = 1/2, G* = 1/8 between like spheres; mass 1. */
#define SPHERE "material m density 0.238732414637843 young 1 poisson 0 friction 9\nnormal hertz\n"
#define RECORD                                                                                                         \
  "monitor A sphere 1\nmonitor B sphere 2\nmonitor C sphere 1 with sphere 2\nrecord A.vx.half B.vx.half A.vy.half "    \
  "B.vy.half "                                                                                                         \
  "C.overlap C.dashpot.normal C.dashpot.shear C.sliding contacts.deep\nstage s\ncycles 9\n"

/* c = 2 ratio (M* k)^(1/2), with k = 2 E* a and 8 G* a, a^2 = R* overlap. */
static void elastic_coefficients(void) {
  for (int slides = 0; slides < 2; slides++) {
    struct written it;
    struct nb_model *model =
        model_of(&it, SPHERE,
                 slides ? "shear mindlin\npair m m friction 1e-9\n"
                          "sphere 0 0 radius 1 m velocity 0.1 0.3\nsphere 1.9 0 radius 1 m\ndamping "
                          "ratio 0.2\nstep 1e-4\n" RECORD
                        : "shear mindlin\nsphere 0 0 radius 1 m velocity 0.1 0.3\nsphere 1.9 0 radius 1 m\n"
                          "damping ratio 0.2\nstep 1e-4\n" RECORD);
    written_cycles(model, 1);
    const double a = sqrt(0.5 * written_now(model, "C.overlap"));
    const double dn = written_now(model, "A.vx.half") - written_now(model, "B.vx.half");
    const double slip = written_now(model, "A.vy.half") - written_now(model, "B.vy.half");
    NEAR(written_now(model, "C.dashpot.normal"), 0.4 * sqrt(0.5 * 2 * 0.5 * a) * dn,
         1e-3); /* the contact normal has rotated by 1e-5 */
    CU_ASSERT_EQUAL(written_now(model, "C.sliding"), slides);
    const double shear = slides ? 0 : 0.4 * sqrt(0.5 * 8 * 0.125 * a) * fabs(slip);
    CU_ASSERT(fabs(fabs(written_now(model, "C.dashpot.shear")) - shear) <= 1e-3 * shear);
    nb_model_free(model);
    written_free(&it);
  }
}

/* ---- damping walls ---- */

#define DISCS                                                                                                          \
  "material m density 0.31830988618379067 kn 8\ndisc 0 0.9 radius 1 m velocity 0 -0.5\ndisc 0 2.7 radius 1 m "         \
  "velocity "                                                                                                          \
  "0 -2\nwall w -9 0 to 9 0 m\nmonitor A disc 1\nmonitor B disc 2\nmonitor W disc 1 with wall w\nmonitor C disc 1 "    \
  "with disc "                                                                                                         \
  "2\n"                                                                                                                \
  "step 1e-4\nrecord A.vy.half B.vy.half W.dashpot.normal C.dashpot.normal step.stable\n"

/* The coefficients c at the wall and between the discs, in the first and in the second stage. */
static void walls_separate(void) {
  static const struct {
    const char *scene, *stage;
    double wall[2], discs[2]; /* c, N s/m */
  } pages[] = {
      {"damping stiffness 0.1\n", "", {0.8, 0.8}, {0.8, 0.8}},
      {"damping stiffness 0.1\ndamping walls stiffness 0.3\n", "", {2.4, 2.4}, {0.8, 0.8}},
      {"damping walls stiffness 0.3\ndamping stiffness 0.1\n", "damping stiffness 0.2\n", {2.4, 2.4}, {0.8, 1.6}},
      {"damping walls stiffness 0.3\n", "damping none\n", {2.4, 0}, {0, 0}},
      {"damping walls stiffness 0.3\n", "damping mass 0\n", {2.4, 2.4}, {0, 0}}, /* `mass` is no damping of contacts */
      {"damping stiffness 0.1\ndamping walls none\n", "damping walls stiffness 0.4\n", {0, 3.2}, {0.8, 0.8}},
      {"damping none\n", "damping walls ratio 0.5\n", {0, 2.8284271247461903}, {0, 0}},
      {"damping walls none\n", "", {0, 0}, {0, 0}},
  };
  for (size_t n = 0; n < sizeof pages / sizeof *pages; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "units none\n" DISCS "%sstage a\ncycles 2\nstage b\n%scycles 2\n", pages[n].scene, pages[n].stage);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int s = 0; s < 2; s++) {
      CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      written_cycles(model, 2);
      const double a = written_now(model, "A.vy.half"), b = written_now(model, "B.vy.half");
      CU_ASSERT(fabs(written_now(model, "W.dashpot.normal") + pages[n].wall[s] * a) < 1e-12);
      CU_ASSERT(fabs(written_now(model, "C.dashpot.normal") - pages[n].discs[s] * (a - b)) < 1e-12);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* One disc at a wall. The stable step is 2/omega ((1 + xi^2)^(1/2) - xi); omega^2 = 8, and xi is the ratio of `damping
 * walls`. The ratio of contacts between particles has no effect. */
static void stable_step_with_damping_walls(void) {
  struct written it;
  struct nb_model *model =
      model_of(&it, "material m density 0.31830988618379067 kn 8\ndisc 0 0.9 radius 1 m\nwall w -9 0 to 9 0 m\n",
               "damping ratio 0.7\ndamping walls ratio 0.2\nstep 0.01\nrecord step.stable\nstage s\ncycles 1\n");
  NEAR(written_now(model, "step.stable"), 2 / sqrt(8) * (sqrt(1.04) - 0.2), 1e-12);
  nb_model_free(model);
  written_free(&it);
}

/* Two discs that are far apart count as if they touched, with the dashpot of their contact: omega^2 = 2 k/m, and xi is
 * the damping ratio. */
static void stable_step_of_discs_apart(void) {
  struct written it;
  struct nb_model *model = model_of(&it,
                                    "material m density 0.31830988618379067 kn 8\ndisc 0 0 radius 1 m\n"
                                    "disc 90 0 radius 1 m\n",
                                    "damping ratio 0.2\nstep 0.01\nrecord step.stable\nstage s\ncycles 1\n");
  NEAR(nb_stable_step_apart(model).step, 2 / sqrt(16) * (sqrt(1.04) - 0.2), 1e-12);
  nb_model_free(model);
  written_free(&it);
}

/* ---- deep contacts ---- */

static void overlaps_are_counted(void) {
  static const struct {
    const char *scene;
    double counted; /* at rest: at time 0 and after each of ten cycles */
    const char *first;
  } pages[] = {
      {"sphere 0 0 radius 1 m fixed\nsphere 1.86005 0 radius 1 m velocity 0 1e-9\n", 0, ""},
      {"sphere 0 0 radius 1 m fixed\nsphere 1.85995 0 radius 1 m velocity 0 1e-9\n", 11,
       "particle 1 and particle 2, in cycle 0, at time 0"},
      {"sphere 0 0 radius 3 m fixed\nsphere 3.86005 0 radius 1 m\n", 0, ""},
      {"sphere 0 0 radius 3 m fixed\nsphere 3.85995 0 radius 1 m\n", 11, "particle 1 and particle 2"},
      {"sphere 0 0 radius 1 m\nsphere 3.85995 0 radius 3 m fixed\nsphere 9 9 radius 0.1 m\n", 11,
       "particle 1 and particle 2"},
      {"sphere 0 0 radius 1 m\nsphere 3.7 0 radius 3 m fixed\nsphere 9 9 radius 0.1 m\ndamping critical beyond overlap "
       "0.16\n",
       0, ""},
      {"sphere 0 0 radius 1 m\nsphere 3.67 0 radius 3 m fixed\nsphere 9 9 radius 0.1 m\ndamping critical beyond "
       "overlap 0.16\n",
       11, ""},
      {"sphere 0 0.86005 radius 1 m\nwall w -9 0 to 9 0 m\nsphere 9 9 radius 0.1 m\n", 0, ""},
      {"sphere 0 0.85995 radius 1 m\nwall w -9 0 to 9 0 m\nsphere 9 9 radius 0.1 m\n", 11, "particle 1 and wall w"},
      /* in the fourth step of 1e-5 the overlap exceeds 0.14 */
      {"sphere 0 0.860035 radius 1 m velocity 0 -1e4\nwall w -9 0 to 9 0 m\nsphere 9 9 radius 0.1 m\n", 7,
       "particle 1 and wall w, in cycle 4, at time 4e-09"},
      {"sphere 0 0 radius 1 m fixed\nsphere 1.860035 0 radius 1 m velocity -1e4 0\n", 7,
       "particle 1 and particle 2, in cycle 4, at time 4e-09"},
      /* if several contacts are deep, the first one is named */
      {"sphere 0 0 radius 3 m\nsphere 3.86005 0 radius 1 m\nsphere 5.66 0 radius 1 m\n", 11,
       "particle 2 and particle 3"},
      {"sphere 0 0 radius 3 m\nsphere 3.85995 0 radius 1 m\nsphere 5.66 0 radius 1 m\n", 22,
       "particle 1 and particle 2"},
      {"sphere 0 0 radius 1 m\nsphere 3.86005 0 radius 3 m\nsphere 9.35 0 radius 3 m\n", 11,
       "particle 2 and particle 3"},
      {"sphere 0 0 radius 1 m\nsphere 3.85995 0 radius 3 m\nsphere 9.35 0 radius 3 m\n", 22,
       "particle 1 and particle 2"},
      {"sphere 0 0 radius 2 m\nsphere 3.719 0 radius 2 m\nsphere 7.3 0 radius 2 m\n", 22, "particle 1 and particle 2"},
      {"sphere 0 0 radius 2 m\nsphere 3.721 0 radius 2 m\nsphere 7.3 0 radius 2 m\n", 11, "particle 2 and particle 3"},
      {"sphere 0 0.86005 radius 1 m\nwall w -9 0 to 9 0 m\nsphere 8 0.8 radius 1 m\n", 11, "particle 2 and wall w"},
      {"sphere 0 0.85995 radius 1 m\nwall w -9 0 to 9 0 m\nsphere 8 0.8 radius 1 m\n", 22, "particle 1 and wall w"},
  };
  for (size_t n = 0; n < sizeof pages / sizeof *pages; n++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\n" SPHERE "%sstep 1e-9\nrecord contacts.deep\nstage r\ncycles 2\nstage s\n"
              "cycles 8\n",
              pages[n].scene);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL(written_last(&result, "contacts.deep"), pages[n].counted);
    CU_ASSERT_EQUAL((double)result.deep, pages[n].counted);
    CU_ASSERT(strncmp(result.deep_first, pages[n].first, strlen(pages[n].first)) == 0);
    CU_ASSERT((result.deep_first[0] != 0) == (pages[n].counted > 0));
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The count does not depend on the number of searches and threads. With linear springs it is 0. */
static void counts_go_on(void) {
  double counts[3];
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\n%slattice spheres 20 by 20 radius 1 spacing 1.85 m\nsphere 60 5 radius 1 m velocity -40 0\n"
              "step 1e-3\n%srecord contacts.deep contacts\nstage s\nrecord none\ncycles 100\nstage e\ncycles 1\n",
              k == 2 ? "material m density 1 kn 1\n" : SPHERE, k == 1 ? "skin 0.3\n" : "");
    written_scene(&it, &page);
    written_run(&result, &it, &(struct nb_options){.threads = 1 + k});
    CU_ASSERT(result.searches > 2);
    counts[k] = written_last(&result, "contacts.deep");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT_EQUAL(counts[0], 102 * 2 * 20 * 19); /* at the start and after each cycle, between neighbours */
  CU_ASSERT(counts[0] == counts[1] && counts[2] == 0);
}

/* The count is kept when a later stage has linear springs, which add nothing to it. */
static void counts_stay(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 young 1 poisson 0.3 kn 1\nnormal hertz\n"
                   "lattice spheres 20 by 20 radius 1 spacing 1.85 m\nstep 1e-9\nrecord contacts.deep\n"
                   "stage s\ncycles 10\nstage t\nnormal linear\ncycles 5\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(written_last(&result, "contacts.deep"), 11 * 2 * 20 * 19);
  nb_result_free(&result);
  written_free(&it);
}

/* Deep contacts are damped critically, other contacts as the page says. The guaranteed stable step takes both into
 * account. */
static void deep_ones_are_damped_critically(void) {
  for (int is_deep = 0; is_deep < 2; is_deep++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\n" SPHERE "damping critical beyond overlap 0.05\ndamping ratio 0.1\n"
              "sphere 0 0 radius 1 m velocity 0.1 0\nsphere %g 0 radius 1 m\nstep 1e-6\n" RECORD,
              is_deep ? 1.89995 : 1.90005);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    written_cycles(model, 1);
    const double a = sqrt(0.5 * written_now(model, "C.overlap")), ratio = is_deep ? 1 : 0.1;
    const double dn = written_now(model, "A.vx.half") - written_now(model, "B.vx.half");
    NEAR(written_now(model, "C.dashpot.normal"), 2 * ratio * sqrt(0.5 * a) * dn, 1e-12);
    CU_ASSERT_EQUAL(written_now(model, "contacts.deep"), is_deep ? 2 : 0);
    /* without shear 2/omega (sqrt(1 + xi^2) - xi), omega^2 = k/M* */
    NEAR(nb_stable_step(model).step, 2 / sqrt(a / 0.5) * (sqrt(1 + ratio * ratio) - ratio), 1e-5);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The marks of deep contacts end with the stage that asks for `damping critical`. */
static void marks_end_with_their_stage(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\n" SPHERE "damping critical beyond overlap 0.05\nsphere 0 0 radius 1 m velocity 0.1 0\n"
                   "sphere 1.8 0 radius 1 m\nstep 1e-6\nmonitor C sphere 1 with sphere 2\nrecord C.dashpot.normal\n"
                   "stage deep\ncycles 4\nstage free\ndamping none\ncycles 4\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 9);
  for (size_t row = 1; row < 9; row++)
    CU_ASSERT(row <= 4 ? result.table.values[row] > 1e-3 : result.table.values[row] == 0);
  nb_result_free(&result);
  written_free(&it);
}

/* A whole impact, compared with the recursion of the cycle: u <- u - dt/m* (N + c u), with N and c at the current
 * overlap x and the approach velocity u of the last half step, then x <- x + dt u. The jump of c, and its delay of half
 * a step, are the same in the run and in the recursion, so their results differ only by rounding. */
static void an_impact_follows_the_recursion(void) {
  enum { CYCLES = 400 };
  const double speed = 0.2, dt = 0.02, limit = 0.1, mass = 0.5;
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\n" SPHERE "damping critical beyond overlap 0.05\ndamping ratio 0.1\n"
            "sphere 0 0 radius 1 m velocity 0.2 0\nsphere 2 0 radius 1 m\nstep 0.02\nmonitor A sphere 1\n"
            "monitor B sphere 2\nmonitor C sphere 1 with sphere 2\nrecord C.overlap A.vx.half B.vx.half contacts.deep\n"
            "stage s\ncycles 400\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, CYCLES + 1);
  double x = 0, u = speed, deepest = 0, count = 0;
  for (int n = 1; n <= CYCLES; n++) {
    const double *row = result.table.values + (size_t)n * result.table.column_count;
    x += dt * u;
    CU_ASSERT_DOUBLE_EQUAL(row[0], x > 0 ? x : 0, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(row[1] - row[2], u, 1e-13);
    const double a = x > 0 ? sqrt(0.5 * x) : 0, ratio = x > limit ? 1 : 0.1;
    u -= dt / mass * (a > 0 ? 4. / 3 * 0.5 * a * x + 2 * ratio * sqrt(mass * a) * u : 0);
    deepest = fmax(deepest, x), count += x > limit;
    CU_ASSERT_EQUAL(row[3], count);
  }
  CU_ASSERT(deepest > 1.5 * limit && x < 0 && u < -0.2 * speed); /* the contact was deep and has opened */
  nb_result_free(&result);
  written_free(&it);
}

void suite_deep(void) {
  CU_pSuite suite = CU_add_suite("deep", NULL, NULL);
  CU_add_test(suite, "coefficients of elastic spheres", elastic_coefficients);
  CU_add_test(suite, "`damping walls` changes the coefficient at walls only", walls_separate);
  CU_add_test(suite, "the stable step uses the damping of walls", stable_step_with_damping_walls);
  CU_add_test(suite, "the stable step of discs apart uses their damping", stable_step_of_discs_apart);
  CU_add_test(suite, "deep contacts are counted", overlaps_are_counted);
  CU_add_test(suite, "counts do not depend on searches and threads", counts_go_on);
  CU_add_test(suite, "the count is kept when the law changes", counts_stay);
  CU_add_test(suite, "deep contacts are damped critically", deep_ones_are_damped_critically);
  CU_add_test(suite, "an impact follows the recursion", an_impact_follows_the_recursion);
  CU_add_test(suite, "critical damping of deep contacts ends with its stage", marks_end_with_their_stage);
}
