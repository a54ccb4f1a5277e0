/* Speeds of the particles of a region relative to the imposed motion, and the unbalanced force under centripetal
 * gravity.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const double pi = 3.14159265358979323846;

/* Speeds without the imposed motion, for `affine strain` with and without `accumulated`. The fixed particle does not
 * count. */
static void speeds(void) {
  static const char *const codings[] = {"apart", "accumulated"};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nstep 0.125\ndisc 3 4 radius 1 m velocity 0.3 -0.4\n"
              "disc -8 6 radius 1 m\ndisc 40 9 radius 2 m fixed velocity 7 7\ndisc 0 -30 radius 2 m velocity 9 9\n"
              "region A box -20 -20 to 60 20\nregion B all\n"
              "record A.speed.mean A.speed.max A.speed.imposed A.speed.ratio B.speed.max\n"
              "stage s\naffine strain 0.01 -0.02 %s\ncycles 1\n",
              codings[k]);
    written_scene(&it, &page);
    struct nb_result result;
    written_run(&result, &it, NULL);
    /* v is the velocity that the page gives, c the imposed velocity, u = v + c the total one. t_1 is the time after the
     * step. c_0 is c at the position at the start, c_1 is c at the position at t_1, and c at the time t_1 is the mean
     * of c_0 and c_1. The speeds at t_1 are the magnitudes of w = u - c. Without `accumulated` w is v. */
    const double more = k ? 0.5 : 0; /* fraction of c_0 in w */
    const double x = 3 + 0.125 * (0.3 + 0.03), y = 4 + 0.125 * (-0.4 - 0.08), x2 = -8 - 0.125 * 0.08,
                 y2 = 6 - 0.125 * 0.12;
    const double c1x = 0.01 * (3 + x) / 2, c1y = -0.02 * (4 + y) / 2;
    const double c2x = 0.01 * (-8 + x2) / 2, c2y = -0.02 * (6 + y2) / 2;
    /* With `accumulated` u at t_1 is (u- + u+)/2, where u- = v + c_0 and u+ = u- + c_1 are the velocities before and
     * after the kick at t_1. So w = v + c_0 + c_1/2 - (c_0 + c_1)/2 = v + c_0/2. */
    const double w1 = hypot(0.3 + more * 0.01 * 3, -0.4 - more * 0.02 * 4),
                 w2 = hypot(more * 0.01 * 8, more * 0.02 * 6);
    const double c = hypot(c1x, c1y) + hypot(c2x, c2y);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.speed.mean"), (w1 + w2) / 2, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.speed.max"), w1, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.speed.imposed"), c / 2, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.speed.ratio"), (w1 + w2) / c, 1e-13);
    CU_ASSERT(written_last(&result, "B.speed.max") > 12);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A particle has its imposed velocity as soon as the first stage has begun, before the first step. With
 * `accumulated` each step adds it, so it is not yet part of the velocity. Both have the same speeds without it. */
static void imposed_before_the_first_step(void) {
  for (int accumulated = 0; accumulated < 2; accumulated++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nstep 0.125\ndisc 3 4 radius 1 m velocity 0.3 -0.4\n"
              "monitor D disc 1\nregion A all\nrecord D.vx D.vy A.speed.mean A.speed.imposed\n"
              "stage s\naffine strain 0.01 -0.02 %s\ncycles 1\n",
              accumulated ? "accumulated" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.vx"), 0.3 + (accumulated ? 0 : 0.01 * 3), 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.vy"), -0.4 - (accumulated ? 0 : 0.02 * 4), 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.speed.mean"), 0.5, 1e-15);
    CU_ASSERT(accumulated || fabs(written_now(model, "A.speed.imposed") - hypot(0.03, 0.08)) < 1e-15);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The beginning of a stage changes no speed, even if the stage has another step than the stage before. */
static void a_stage_with_another_step(void) {
  static const char *const codings[] = {"apart", "accumulated"};
  static const char *const names[] = {"A.speed.mean", "A.speed.max", "A.speed.imposed", "A.speed.ratio"};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    double before[COUNT(names)];
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nstep 0.125\ndisc 3 4 radius 1 m velocity 0.3 -0.4\n"
              "disc -8 6 radius 1 m\nregion A all\nrecord A.speed.mean A.speed.max A.speed.imposed A.speed.ratio\n"
              "stage s\naffine strain 0.01 -0.02 %s\ncycles 3\nstage t\nstep 0.03125\ncycles 1\n",
              codings[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 3);
    for (size_t n = 0; n < COUNT(names); n++)
      before[n] = written_now(model, names[n]);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    for (size_t n = 0; n < COUNT(names); n++)
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, names[n]), before[n], 1e-14);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Centripetal gravity counts in the unbalanced force like a weight. Two discs have the acceleration 0.5 towards (0,
 * -7); one of them lies on a fixed disc. */
static void unbalanced_under_centripetal_gravity(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100\nstep 1e-9\ndisc 0 0 radius 1 m fixed\n"
            "disc 0 1.98 radius 1 m\ndisc 9 -7 radius 1 m\nregion A all\n"
            "record A.unbalanced.mean A.unbalanced.force\nstage s\ngravity centripetal 0.5 about 0 -7\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.unbalanced.force"), ((2 - pi / 2) + pi / 2) / 2, 1e-9);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.unbalanced.mean"), 0.5, 1e-9);
  nb_result_free(&result);
  written_free(&it);
}

/* Centripetal gravity has no direction at its point: a disc there stays at rest, and the disc beside it falls. */
/* At its point the acceleration is 0. A negative acceleration points away from it. */
static void at_the_point_of_centripetal_gravity(void) {
  for (int sign = -1; sign <= 1; sign += 2) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nstep 0.125\ndisc 3 -7 radius 1 m\ndisc 9 -7 radius 1 m\n"
              "monitor D disc 1\nmonitor E disc 2\nrecord D.x D.y D.vx D.vy E.vx\nstage s\n"
              "gravity centripetal %g about 3 -7\ncycles 2\n",
              sign * 0.5);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT(written_last(&result, "D.x") == 3 && written_last(&result, "D.y") == -7);
    CU_ASSERT(written_last(&result, "D.vx") == 0 && written_last(&result, "D.vy") == 0);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "E.vx"), -sign * 0.5 * 2 * 0.125, 1e-15);
    nb_result_free(&result);
    written_free(&it);
  }
}

void suite_speeds(void) {
  CU_pSuite suite = CU_add_suite("speeds", NULL, NULL);
  CU_add_test(suite, "speeds relative to the imposed motion", speeds);
  CU_add_test(suite, "imposed velocity before the first step", imposed_before_the_first_step);
  CU_add_test(suite, "a stage with another step changes no speed", a_stage_with_another_step);
  CU_ADD_TEST(suite, at_the_point_of_centripetal_gravity);
  CU_add_test(suite, "unbalanced force under centripetal gravity", unbalanced_under_centripetal_gravity);
}
