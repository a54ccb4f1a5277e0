/* The changes that stages make to gravity, materials, pairs and velocities, with and without ramps, and the effect of
 * these changes on contact forces and histories.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* The last value of a column, after all stages. */
static double after(const char *statements, const char *column) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\n%s", statements);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double last = written_last(&result, column);
  nb_result_free(&result);
  written_free(&it);
  return last;
}

/* The value of a column in this row. */
static double row_of(const char *statements, const char *column, size_t row) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\n%s", statements);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_FATAL(row < result.table.row_count);
  result.table.row_count = row + 1;
  const double value = written_last(&result, column);
  nb_result_free(&result);
  written_free(&it);
  return value;
}

/* Steps and values are powers of two, so the results are exact. */
#define FLIGHT                                                                                                         \
  "material m density 1 kn 1\ndisc 0 0 radius 3 m velocity 1 0\ndisc 19 0 radius 3 m fixed velocity 0 1\nmonitor D "   \
  "disc "                                                                                                              \
  "1\nmonitor F disc 2\nrecord D.x D.y D.vx D.vy D.fy F.y F.vy\nstep 0.25\n"

static void a_particle_falls(void) {
  const char *falls = FLIGHT "gravity 0 -2\nstage a\ncycles 8\n";
  CU_ASSERT_EQUAL(after(falls, "D.y"), -4); /* -g t^2/2, t = 2 */
  CU_ASSERT_EQUAL(after(falls, "D.vy"), -4);
  CU_ASSERT_EQUAL(after(falls, "D.x"), 2);
  CU_ASSERT_EQUAL(after(falls, "D.fy"), 0); /* the sum of contact forces */
  CU_ASSERT_EQUAL(after(falls, "F.y"), 2);  /* a fixed particle keeps its velocity */
  CU_ASSERT_EQUAL(after(falls, "F.vy"), 1);
  const char *damped = FLIGHT "gravity 0 -2\ndamping mass 0.5\nstage a\ncycles 8\n";
  CU_ASSERT_EQUAL(after(damped, "F.y"), 2); /* damping does not act on a fixed particle either */
  CU_ASSERT_EQUAL(after(damped, "F.vy"), 1);
}

/* A negative acceleration acts away from its point, constant or in a ramp. It has the same effect as the positive one
 * towards the opposite point. */
static void gravity_acts_away_from_a_point(void) {
#define AT_REST "material m density 1 kn 1\ndisc 0 0 radius 3 m\nmonitor D disc 1\nrecord D.y\nstep 0.25\nstage a\n"
  CU_ASSERT_EQUAL(after(AT_REST "gravity centripetal -2 about 0 8\ncycles 8\n", "D.y"), -4);
  CU_ASSERT_EQUAL(after(AT_REST "gravity centripetal 2 about 0 -8\ncycles 8\n", "D.y"), -4);
  CU_ASSERT(after(AT_REST "ramp gravity centripetal -2 about 0 8\ncycles 8\n", "D.y") < -1);
  CU_ASSERT_EQUAL(after(AT_REST "ramp gravity centripetal -2 about 0 8\ncycles 8\n", "D.y"),
                  after(AT_REST "ramp gravity centripetal 2 about 0 -8\ncycles 8\n", "D.y"));
}

/* The message has the points in metres, whatever their units on the page. */
static void the_points_of_central_gravity_in_metres(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  words_add(&page, "material m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 3 m m\nstep 1 s\nrecord time\nstage a\n"
                   "gravity centripetal 2 m/s2 about 0.5 m -8 mm\ncycles 1\nstage b\n"
                   "gravity centripetal 1 m/s2 about 0.5 m 7 m\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BAD_USE);
  CU_ASSERT_STRING_EQUAL(error.text,
                         "line 10: the point of central gravity moves from (0.5, -0.008) to (0.5, 7) m. Expected the "
                         "same point, or a stage in between with `gravity` and two zeros");
  nb_result_free(&result);
  written_free(&it);
}

/* A stage cannot move the point of central gravity, because the change of the velocities at the beginning of the stage
 * would need the directions to both points. After a stage with zero gravity, a stage can give another point. */
static void the_point_of_central_gravity_stays(void) {
  static const struct {
    const char *between;
    const char *point;
    bool refused;
  } of[] = {{"", "0 -8", true},     {"", "8 8", true},
            {"", "0 8", false},     {"stage b\ngravity 0 0\ncycles 1\n", "0 -8", false},
            {"ramp ", "1 8", true}, {"ramp ", "0 8", false}};
  for (size_t n = 0; n < sizeof of / sizeof *of; n++) {
    const bool ramp = strcmp(of[n].between, "ramp ") == 0;
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(&page, "units none\n" AT_REST "gravity centripetal 2 about 0 8\ncycles 8\n%sstage c\n",
              ramp ? "" : of[n].between);
    words_add(&page, "%sgravity centripetal 1 about %s\ncycles 8\n", ramp ? "ramp " : "", of[n].point);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), of[n].refused ? NB_BAD_USE : NB_OK);
    CU_ASSERT_EQUAL(strstr(error.text, "the point of central gravity moves") != NULL, of[n].refused);
    if (n == 4)
      CU_ASSERT_STRING_EQUAL(error.text,
                             "line 12: the point of central gravity moves from (0, 8) to (1, 8). Expected the same "
                             "point, or a stage in between with `gravity` and two zeros");
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The kick around the start of a stage has the mean of the old and the new gravity, weighted with the halves of the two
 * steps. The next kick has the new one. */
static void the_first_kick_has_the_mean_gravity(void) {
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "units none\n" AT_REST);
    words_add(&page, k ? "gravity centripetal 2 about 0 8\n" : "gravity 2 -4\n");
    words_add(&page, "cycles 1\nstage b\nstep 0.75\n%s\ncycles 2\n",
              k ? "gravity centripetal 6 about 0 8" : "gravity 6 8");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    const double *const now = k ? &model->central.acceleration : &model->gravity.x;
    CU_ASSERT_DOUBLE_EQUAL(*now, 0.25 * 2 + 0.75 * 6, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(model->gravity.y, k ? 0 : -0.25 * 4 + 0.75 * 8, 1e-15);
    written_cycles(model, 1);
    CU_ASSERT(*now == 6 && model->gravity.y == (k ? 0 : 8));
    nb_model_free(model);
    written_free(&it);
  }
}

static void gravity_pulls_along_any_axis(void) {
  static const struct {
    const char *words;
    double x, y;
  } to[] = {{"1 0", 1, 0}, {"0 1", 0, 1}, {"-2 0", -2, 0}, {"0.5 -0.25", 0.5, -0.25}};
  for (size_t k = 0; k < sizeof to / sizeof *to; k++) {
    char text[512];
    snprintf(text, sizeof text, FLIGHT "gravity %s\nstage a\ncycles 8\n", to[k].words);
    CU_ASSERT_EQUAL(after(text, "D.vx"), 1 + 2 * to[k].x);
    CU_ASSERT_EQUAL(after(text, "D.vy"), 2 * to[k].y);
    CU_ASSERT_EQUAL(after(text, "D.y"), 2 * to[k].y);
  }
}

/* The step changes from 1/4 to 1/2 while gravity jumps: the motion stays exact. */
static void gravity_jumps(void) {
  const char *jumps = FLIGHT "gravity 0 -2\nstage a\ncycles 8\nstage b\nstep 0.5\ngravity 2 1\ncycles 4\n";
  CU_ASSERT_DOUBLE_EQUAL(after(jumps, "D.vy"), -4 + 2, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(after(jumps, "D.y"), -4 - 8 + 2, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(after(jumps, "D.vx"), 1 + 4, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(after(jumps, "D.x"), 2 + 2 + 4, 1e-14);
  /* Gravity of the first stage acts from time 0; the next stage keeps it. */
  CU_ASSERT_EQUAL(after(FLIGHT "stage a\ngravity 0 -2\ncycles 4\nstage b\ncycles 4\n", "D.y"), -4);
}

/* g = -2 t gives v = -t^2; the trapezoidal rule is exact for a linear g. */
static void gravity_ramps(void) {
  const char *ramps = FLIGHT "stage a\nramp gravity 0 -4\ncycles 8\n";
  CU_ASSERT_DOUBLE_EQUAL(after(ramps, "D.vy"), -4, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(row_of(ramps, "D.vy", 4), -1, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(after(FLIGHT "stage a\nramp gravity 0 -4\ncycles 8\nstage b\ncycles 4\n", "D.vy"), -8, 1e-15);
}

/* At the end of a ramp gravity is exactly that of the statement, although 0.7 + (0.1 - 0.7) is not 0.1 when rounded. */
static void a_ramp_ends_exactly(void) {
  static const char *const scenes[] = {"gravity 0 -0.7\n", "gravity -0.7 0\n"};
  static const char *const ramps[] = {"gravity 0 -0.1", "gravity -0.1 0"};
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "units none\n" FLIGHT "%sstage a\n%scycles 1\nstage b\nramp %s\ncycles 3\n",
              k < 2 ? scenes[k] : "", k < 2 ? "" : "gravity centripetal 0.7 about 1 2\n",
              k < 2 ? ramps[k] : "gravity centripetal 0.1 about 1 2");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int s = 0; s < 2; s++) {
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      written_cycles(model, s ? 3 : 1);
    }
    CU_ASSERT_EQUAL(model->gravity.x, k == 1 ? -0.1 : 0);
    CU_ASSERT_EQUAL(model->gravity.y, k == 0 ? -0.1 : 0);
    CU_ASSERT_EQUAL(model->central.acceleration, k == 2 ? 0.1 : 0);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stage can have several ramps, in any order. A heavy disc slides along a wall without friction. */
static void two_ramps(void) {
  static const char *const ramps[] = {"ramp gravity 4 0\nramp material m kn 3\n",
                                      "ramp material m kn 3\nramp gravity 4 0\n"};
  for (size_t k = 0; k < 2; k++) {
    char page[512];
    snprintf(page, sizeof page,
             "material m density 1e30 kn 1\ndisc 0 0.75 radius 1 m\nwall w -9 0 to 99 0 m\n"
             "monitor C disc 1 with wall w\nmonitor D disc 1\nrecord C.normal D.vx\nstep 0.25\nstage a\n%scycles 8\n",
             ramps[k]);
    CU_ASSERT_EQUAL(row_of(page, "C.normal", 4), 0.25 * 2);
    CU_ASSERT_EQUAL(row_of(page, "D.vx", 4), 1);
  }
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\nperiodic cell 0 0 to 9 9\ndisc 1 1 radius 1 m\nstep 0.1\nrecord "
            "time\nstage a\nramp servo xx 5 on cell through cell at most 1\nramp material m kn 2\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT(it.scene.stages[0].servo.ramp && it.scene.stages[0].changes[0].ramp);
  written_free(&it);
}

#define WALL                                                                                                           \
  "material m density 1 kn 1\ndisc 0 0 radius 1 m\nwall w 5 -1 to 5 1 m velocity 1 0\nmonitor W wall w\nmonitor D "    \
  "disc "                                                                                                              \
  "1\nrecord W.x D.x\nstep 0.25\n"

static void a_wall_ramps(void) {
  CU_ASSERT_EQUAL(after(WALL "stage a\nramp wall w velocity 3 0\ncycles 8\n", "W.x"), 5 + 2 * 2);
  CU_ASSERT_EQUAL(row_of(WALL "stage a\nramp wall w velocity 3 0\ncycles 8\n", "W.x", 4), 5 + 1.5);
  CU_ASSERT_EQUAL(after(WALL "stage a\nramp wall w velocity 3 0\ncycles 8\nstage b\ncycles 4\n", "W.x"), 5 + 4 + 3);
  CU_ASSERT_EQUAL(
      after(WALL "stage a\nramp wall w velocity 3 0\ncycles 8\nstage b\nramp walls stop\ncycles 8\n", "W.x"),
      5 + 4 + 3);
}

/* Each of two stages has 8 cycles of 1/4. In one stage all walls ramp: wall k from rest to the velocity k, which
 * displaces it by k. In the other stage only wall 1 ramps, and a statement gives wall 2 the velocity that it has. If
 * this is the second stage, wall 1 ramps from 1 to 0, and the other walls move on by 2 k. If it is the first stage,
 * wall 1 ramps from 0 to 1 and keeps this velocity. */
static void many_walls_ramp(void) {
  enum { WALLS = 40 };
  for (int first = 0; first < 2; first++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc -90 0 radius 1 m\nstep 0.25\n");
    for (int k = 1; k <= WALLS; k++)
      words_add(&page, "wall w%d %d 0 to %d 5 m\nmonitor W%d wall w%d\n", k, 5 * k, 5 * k, k, k);
    for (int k = 1; k <= WALLS; k++)
      words_add(&page, "record W%d.x\n", k);
    for (int stage = 0; stage < 2; stage++) {
      words_add(&page, "stage s%d\n", stage);
      for (int k = 1; k <= WALLS && stage == first; k++)
        words_add(&page, "ramp wall w%d velocity %d 0\n", k, k);
      if (stage != first)
        words_add(&page, "ramp wall w1 velocity %d 0\nwall w2 velocity %d 0\n", first, stage ? 2 : 0);
      words_add(&page, "cycles 8\n");
    }
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    for (int k = 1; k <= WALLS; k++) {
      char name[16];
      snprintf(name, sizeof name, "W%d.x", k);
      CU_ASSERT_EQUAL(written_last(&result, name), 5 * k + (k == 1 ? 2 + first : first ? k : 3 * k));
    }
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Discs so heavy that they do not move, each with the overlap 1/4 at a wall. */
#define DEEP                                                                                                           \
  "material m density 1e30 kn 8 ks 4\nmaterial n density 1e30 kn 8 ks 4\ndisc 0 0.75 radius 1 m\nwall w -9 0 to 9 0 "  \
  "n\ndisc 0 20 radius 1 m\nwall v -9 19.25 to 9 19.25 m\nmonitor C disc 1 with wall w\nmonitor O disc 2 with wall "   \
  "v\n"                                                                                                                \
  "record C.normal O.normal\nstep 0.25\n"

static void materials_change(void) {
  const char *jumps = DEEP "stage a\ncycles 2\nstage b\nmaterial m kn 16\ncycles 2\n";
  CU_ASSERT_EQUAL(row_of(jumps, "O.normal", 2), 2);
  CU_ASSERT_EQUAL(row_of(jumps, "O.normal", 3), 4);                              /* from the stage's first forces on */
  CU_ASSERT_DOUBLE_EQUAL(after(jumps, "C.normal"), 2 * 16 * 8 / 24. / 4, 1e-15); /* 2ab/(a + b) of two materials */
  const char *ramps = DEEP "stage a\nramp material m kn 24\ncycles 4\nstage b\ncycles 1\n";
  CU_ASSERT_EQUAL(row_of(ramps, "O.normal", 1), 3);
  CU_ASSERT_EQUAL(row_of(ramps, "O.normal", 3), 5);
  CU_ASSERT_EQUAL(row_of(ramps, "O.normal", 4), 6);
  CU_ASSERT_EQUAL(after(ramps, "O.normal"), 6);
}

/* Two ramps from different values and a jump after them. Two materials of k_1 and k_2 have the
 * contact force 2 k_1 k_2/(k_1 + k_2)/4 at the overlap 1/4. */
static void two_materials_ramp(void) {
  const char *ramps = DEEP "stage a\nmaterial n kn 16\ncycles 4\nstage b\nramp material m kn 24\n"
                           "ramp material n kn 48\nmaterial n ks 2\ncycles 4\n";
  for (size_t cycle = 1; cycle <= 4; cycle++) {
    const double m = 8 + 4. * (double)cycle, n = 16 + 8. * (double)cycle;
    CU_ASSERT_DOUBLE_EQUAL(row_of(ramps, "C.normal", 4 + cycle), 2 * m * n / (m + n) / 4, 1e-14);
    CU_ASSERT_EQUAL(row_of(ramps, "O.normal", 4 + cycle), m / 4);
  }
}

static void pairs_change(void) {
  const char *jumps = DEEP "stage a\npair m n kn 32\ncycles 2\nstage b\nmaterial m kn 16\ncycles 1\n";
  CU_ASSERT_EQUAL(row_of(jumps, "C.normal", 1), 8);
  CU_ASSERT_EQUAL(row_of(jumps, "O.normal", 2), 2);
  CU_ASSERT_EQUAL(after(jumps, "C.normal"), 8); /* `pair` takes precedence over the materials */
  CU_ASSERT_EQUAL(after(jumps, "O.normal"), 4);
  const char *ramps = DEEP "pair n m kn 16\nstage a\nramp pair m n kn 32\ncycles 4\n";
  CU_ASSERT_EQUAL(row_of(ramps, "C.normal", 1), 5);
  CU_ASSERT_EQUAL(after(ramps, "C.normal"), 8);
}

/* `zero velocities` stops every particle, fixed ones included; walls keep moving. The next change of velocities is that
 * of half a step, and dashpot forces are 0. */
static void zero_velocities_starts_from_rest(void) {
  const char *falls = FLIGHT "gravity 0 -2\nstage a\ncycles 8\nstage b\nzero velocities\ncycles 4\n";
  CU_ASSERT_EQUAL(after(falls, "D.y"), -4 - 1);
  CU_ASSERT_EQUAL(after(falls, "D.vy"), -2);
  CU_ASSERT_EQUAL(after(falls, "D.x"), 2);
  CU_ASSERT_EQUAL(after(falls, "F.y"), 2);
  CU_ASSERT_EQUAL(after(WALL "stage a\ncycles 4\nstage b\nzero velocities\ncycles 4\n", "W.x"), 7);
  const char *spins =
      "material m density 1 kn 1 friction 1\nshear linear\ndisc 0 0 radius 1 m spin 3\nstep 1\nmonitor D disc "
      "1\nrecord D.spin D.angle\nstage a\ncycles 2\nstage b\nzero velocities\ncycles 2\n";
  CU_ASSERT_EQUAL(after(spins, "D.spin"), 0);
  CU_ASSERT_EQUAL(after(spins, "D.angle"), 6);
  const char *damped =
      "material m density 1 kn 8\nwall w -9 0 to 9 0 m\ndisc 0 0.8 radius 1 m velocity 0 -1\nmonitor D disc 1\n"
      "record D.y D.vy.half\nstep 0.0078125\ndamping stiffness 0.5\nstage a\ncycles 2\nstage b\n"
      "zero velocities\ncycles 1\n";
  const double y = row_of(damped, "D.y", 2);
  CU_ASSERT_DOUBLE_EQUAL(after(damped, "D.vy.half"), 8 * (1 - y) / 3.14159265358979323846 * 0.0078125 / 2, 1e-15);
}

/* A disc slides on a floor under its weight, with another friction in each of three stages. A second disc keeps its
 * friction, so one contact always has a history. */
static struct nb_result slider(struct written *it, const char *a, const char *b, const char *c) {
  struct words page = {0};
  struct nb_result result;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 100 ks 80 friction %s\nshear linear\ngravity 0 -1\ndisc 0 0.98 radius 1 m "
      "velocity 1 0\nwall floor -9 0 to 99 0 m\nmaterial n density 1 kn 100 ks 80 friction 0.3\ndisc 0 9.98 radius 1 n "
      "velocity 1 0\n"
      "wall shelf -9 9 to 99 9 n\nmonitor D disc 1\nmonitor C disc 1 with wall floor\nmonitor O disc 2 with wall "
      "shelf\nstep "
      "0.01\n"
      "record D.vx D.spin D.moment C.shear O.shear\nstage a\ncycles 20\nstage b\nmaterial m friction %s\ncycles 20\n"
      "stage c\nmaterial m friction %s\ncycles 20\n",
      a, b, c);
  written_scene(it, &page);
  written_run(&result, it, NULL);
  return result;
}

/* Friction 0 removes the shear law from the plan, and 1e-30 does not. The results must agree, whenever friction is
 * switched on or off. */
static void friction_switches_shear(void) {
  static const char *const on[][3] = {{"0", "0.5", "0"}, {"0.5", "0", "0.5"}, {"0", "0", "0.5"}};
  for (size_t k = 0; k < sizeof on / sizeof *on; k++) {
    struct written planned, always;
    const char *small[3];
    for (int s = 0; s < 3; s++)
      small[s] = strcmp(on[k][s], "0") == 0 ? "1e-30" : on[k][s];
    struct nb_result here = slider(&planned, on[k][0], on[k][1], on[k][2]);
    struct nb_result there = slider(&always, small[0], small[1], small[2]);
    CU_ASSERT_EQUAL_FATAL(here.table.row_count, 61);
    double shear = 0;
    for (size_t n = 0; n < 61 * 5; n++) {
      CU_ASSERT_DOUBLE_EQUAL(here.table.values[n], there.table.values[n], 1e-14);
      shear += n % 5 == 3 ? fabs(here.table.values[n]) : 0;
    }
    CU_ASSERT(shear > 5);
    CU_ASSERT_EQUAL(here.table.values[40 * 5 + 3] == 0, strcmp(on[k][1], "0") == 0);
    nb_result_free(&here), nb_result_free(&there);
    written_free(&planned), written_free(&always);
  }
}

/* A disc slides on a floor without friction. From the first cycle of a ramp of the friction on, the shear force T rotates
 * it: the spin is dt/I (T_1 + ... + T_(n-1) + T_n/2) with I = pi/2. */
static void rotation_begins_with_the_friction(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100 ks 80\nshear linear\ngravity 0 -1\ndisc 0 0.98 radius 1 m "
            "velocity 1 0\nwall floor -9 0 to 99 0 m\nmonitor D disc 1\nmonitor C disc 1 with wall floor\n"
            "record D.spin C.shear\nstep 0.01\nstage a\ncycles 2\nstage b\nramp material m friction 0.5\ncycles 20\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  double sum = 0;
  for (size_t row = 0; row <= 22; row++) {
    const double shear = written_cell(&result.table, row, "C.shear");
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "D.spin"), 0.01 / (acos(-1) / 2) * (sum + shear / 2),
                           1e-12);
    sum += shear;
  }
  CU_ASSERT(sum < -10);
  nb_result_free(&result);
  written_free(&it);
}

/* When the contact opens, the normal and the shear force are 0, whatever the cohesion c is. At a very small normal
 * force the limit of the shear force is c. [CS79 19] */
static void cohesion_carries_no_tension(void) {
#define CLAY(velocity)                                                                                                 \
  "material m density 1e30 kn 8 ks 4 friction 0.5 cohesion 3\nshear linear\ndisc 0 0.75 radius 1 m\n"                  \
  "wall w -9 0 to 9 0 m velocity " velocity "\nmonitor C disc 1 with wall w\n"                                         \
  "record C.normal C.shear C.sliding\nstep 0.0625\n"
  const char *apart = CLAY("8 0") "stage a\ncycles 8\nstage b\nwall w velocity 0 -4\ncycles 4\n";
  CU_ASSERT_EQUAL(row_of(apart, "C.shear", 8), 0.25 * 8 * 0.5 + 3);
  CU_ASSERT_EQUAL(row_of(apart, "C.sliding", 8), 1);
  CU_ASSERT_EQUAL(row_of(apart, "C.shear", 9), 0);
  CU_ASSERT_EQUAL(after(apart, "C.normal"), 0);
  CU_ASSERT_EQUAL(after(apart, "C.shear"), 0);
  const char *grazing = CLAY("8 0") "stage a\ncycles 8\nstage b\nwall w velocity 0 -3.9996\ncycles 1\n";
  CU_ASSERT_DOUBLE_EQUAL(after(grazing, "C.shear"), 3, 2e-4);
  CU_ASSERT(after(grazing, "C.normal") > 0);
}

/* A step relative to a limit follows the stiffness. With a ramp the smaller of the limits at both ends is used. For a
 * disc between two walls without shear omega^2 = 2 k/m, so the guaranteed stable step is the single-contact step over
 * sqrt(2). */
static void the_step_follows(void) {
  static const char *const of[] = {"single-contact", "stable"};
  for (int k = 0; k < 2; k++) {
    const double step = 0.2 * sqrt(3.14159265358979323846 / (k + 1));
    char start[256], text[512];
    snprintf(start, sizeof start,
             "material m density 1 kn 1\ndisc 0 0.9 radius 1 m\nwall w -9 0 to 9 0 m\nwall v 9 1.8 to -9 1.8 m\nstep "
             "0.1 of %s\nrecord step\n",
             of[k]);
    snprintf(text, sizeof text, "%sstage a\nmaterial m kn 16\ncycles 1\n", start);
    CU_ASSERT_DOUBLE_EQUAL(after(text, "step"), step / 4, 1e-14);
    snprintf(text, sizeof text, "%sstage a\nramp material m kn 16\ncycles 2\n", start);
    CU_ASSERT_DOUBLE_EQUAL(row_of(text, "step", 1), step / 4, 1e-14);
    snprintf(text, sizeof text, "%sstage a\nramp material m kn 0.25\ncycles 2\nstage b\ncycles 1\n", start);
    CU_ASSERT_DOUBLE_EQUAL(row_of(text, "step", 1), step, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(after(text, "step"), 2 * step, 1e-14);
  }
}

/* A disc whose weight is borne by a floor, or by a fixed disc, is in equilibrium; without contacts it is not. */
static void weight_counts_in_the_balance(void) {
  const char *rests =
      "material m density 1 kn 8\ngravity 0 -0.6366197723675814\ndisc 0 0.75 radius 1 m\nwall w -9 0 to 9 "
      "0 m\nstep 0.01\nrecord unbalanced.max\nstage a\ncycles 4\nstage b\ngravity 0 0\ncycles 1\n";
  CU_ASSERT_DOUBLE_EQUAL(row_of(rests, "unbalanced.max", 0), 0, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(row_of(rests, "unbalanced.max", 4), 0, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(after(rests, "unbalanced.max"), 1, 1e-13);
  const char *borne = /* by a fixed disc, whose force sum does not count */
      "material m density 1 kn 8\ngravity 0 -0.6366197723675814\ndisc 0 1.75 radius 1 m\ndisc 0 0 radius 1 m fixed\n"
      "step 0.01\nrecord unbalanced.max\nstage a\ncycles 4\n";
  CU_ASSERT_DOUBLE_EQUAL(after(borne, "unbalanced.max"), 0, 1e-13);
  const char *falls =
      "material m density 1 kn 8\ngravity 0 -1\ndisc 0 0 radius 1 m\nstep 0.01\nrecord unbalanced.max\n";
  char text[256];
  snprintf(text, sizeof text, "%sstage a\ncycles 4\n", falls);
  CU_ASSERT_EQUAL(after(text, "unbalanced.max"), INFINITY); /* no contact balances the weight */
  CU_ASSERT_EQUAL(after("material m density 1\ndisc 0 0 radius 1 m\nstep 0.01\nrecord unbalanced.max\nstage a\ncycles "
                        "4\n",
                        "unbalanced.max"),
                  0); /* no force at all */
}

/* unbalanced.max is the largest force sum of all particles over the largest force of all contacts, wherever they stand
 * in the page. Three pairs with the overlaps 0.01, 0.02 and 0.03 have the force sums 8 times that. A disc that two fixed
 * ones press with the overlap 0.1 is in equilibrium, and its two contacts have the largest force. */
static void largest_of_all_forces(void) {
  static const double overlaps[] = {0.01, 0.03, 0.02, 0.01, 0.03};
  for (int n = 0; n < 12; n++) {
    char text[1024] = "material m density 1 kn 8\nstep 1e-6\nrecord unbalanced.max\n";
    for (int k = 0; k < 4; k++)
      if (k == n / 3)
        nb_append(text, sizeof text,
                  "disc 0 50 radius 1 m fixed\ndisc 1.9 50 radius 1 m\ndisc 3.8 50 radius 1 m fixed\n");
      else
        nb_append(text, sizeof text, "disc 0 %d radius 1 m\ndisc %g %d radius 1 m\n", 9 * k,
                  2 - overlaps[n % 3 + (k > n / 3 ? k - 1 : k)], 9 * k);
    nb_append(text, sizeof text, "stage a\ncycles 1\n");
    CU_ASSERT_DOUBLE_EQUAL(row_of(text, "unbalanced.max", 0), 0.03 / 0.1, 1e-13);
  }
}

/* `reverse velocities` also reverses velocity and spin of walls, so the walls return to their old positions. A velocity
 * or spin that the same stage or a later one gives to a wall replaces the reversed one. */
static void velocities_of_walls_reverse(void) {
#define DOOR                                                                                                           \
  "material m density 1 kn 1\ndisc 0 0 radius 1 m\nwall w 5 -1 to 5 1 m velocity 1 -2 spin 0.5\nmonitor W wall w\n"    \
  "record W.x W.y W.angle\nstep 0.25\nstage a\ncycles 4\n"
  CU_ASSERT_EQUAL(after(DOOR, "W.angle"), 0.5);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\ncycles 2\n", "W.angle"), 0.25);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\ncycles 4\n", "W.angle"), 0);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\ncycles 4\n", "W.x"), 5);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\ncycles 2\n", "W.y"), -1);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\nwall w spin 0.5\ncycles 4\n", "W.angle"), 1);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nreverse velocities\nwall w spin 0.5\ncycles 4\n", "W.x"), 5);
  CU_ASSERT_EQUAL(
      after(DOOR "stage b\nreverse velocities\ncycles 2\nstage c\nwall w velocity 0 0\ncycles 2\n", "W.angle"), 0);
}

/* The spin of a wall ramps linearly from 1/2 to 5/2 in 2 s, or to 0. It begins at 1/2 whatever the angle is then, here
 * 0.5 or 1. */
static void a_spin_ramps(void) {
  CU_ASSERT_EQUAL(after(DOOR "stage c\ncycles 4\nstage b\nramp wall w spin 2.5\ncycles 8\n", "W.angle"), 1 + 3);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nramp wall w spin 2.5\ncycles 8\n", "W.angle"), 0.5 + 3);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nramp wall w spin 2.5\ncycles 8\nstage c\ncycles 4\n", "W.angle"), 3.5 + 2.5);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nramp walls stop\ncycles 8\n", "W.angle"), 0.5 + 0.5);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nwalls stop\ncycles 8\n", "W.angle"), 0.5);
  CU_ASSERT_EQUAL(after(DOOR "stage b\nwalls stop\ncycles 8\n", "W.y"), -2);
  /* The ramp begins with the spin of its own wall, also if this is not the first wall: from 3 to 5 in 2 s. */
  CU_ASSERT_EQUAL(after("material m density 1 kn 1\ndisc -90 0 radius 1 m\nwall u 9 0 to 9 1 m\n"
                        "wall w 5 0 to 5 1 m spin 3\nmonitor W wall w\nrecord W.angle\nstep 0.25\n"
                        "stage a\nramp wall w spin 5\ncycles 8\n",
                        "W.angle"),
                  8);
}

/* A statement that gives a wall a velocity keeps its spin, and one that gives it a spin keeps its velocity. The second
 * statement takes effect at once, although the first one was a ramp. */
static void a_wall_keeps_its_other_motion(void) {
#define ROTATING                                                                                                       \
  "material m density 1 kn 1\nbox 0 0 to 8 8 m\ndisc 4 4 radius 1 m\nmonitor W wall west\nrecord W.x W.angle\n"        \
  "step 0.25\nstage a\nwall west spin 0.125\ncycles 4\n"
  CU_ASSERT_EQUAL(after(ROTATING "stage b\nwalls inward 0.5\ncycles 4\n", "W.angle"), 0.125 + 0.125);
  CU_ASSERT_EQUAL(after(ROTATING "stage b\nwalls inward 0.5\ncycles 4\n", "W.x"), 0.5);
  CU_ASSERT_EQUAL(after(ROTATING "stage b\nramp walls inward 0.5\ncycles 4\n", "W.angle"), 0.125 + 0.125);
  CU_ASSERT_EQUAL(after(ROTATING "stage b\nramp walls inward 0.5\ncycles 4\n", "W.x"), 0.25);
  const char *const then = DOOR "stage b\nramp wall w velocity 3 0\ncycles 8\nstage c\nwall w spin 1\ncycles 4\n";
  CU_ASSERT_EQUAL(after(then, "W.angle"), 0.5 + 1 + 1);
  CU_ASSERT_EQUAL(after(then, "W.x"), 5 + 1 + 4 + 3);
}

void suite_changes(void) {
  CU_pSuite suite = CU_add_suite("changes", NULL, NULL);
  CU_add_test(suite, "a particle falls", a_particle_falls);
  CU_add_test(suite, "many walls ramp", many_walls_ramp);
  CU_add_test(suite, "gravity jumps", gravity_jumps);
  CU_ADD_TEST(suite, the_first_kick_has_the_mean_gravity);
  CU_add_test(suite, "gravity pulls along any axis", gravity_pulls_along_any_axis);
  CU_add_test(suite, "gravity acts away from a point", gravity_acts_away_from_a_point);
  CU_ADD_TEST(suite, the_points_of_central_gravity_in_metres);
  CU_add_test(suite, "the point of central gravity stays", the_point_of_central_gravity_stays);
  CU_add_test(suite, "gravity ramps", gravity_ramps);
  CU_add_test(suite, "a ramp of gravity ends exactly", a_ramp_ends_exactly);
  CU_ADD_TEST(suite, two_ramps);
  CU_add_test(suite, "a wall ramps", a_wall_ramps);
  CU_add_test(suite, "materials change", materials_change);
  CU_ADD_TEST(suite, two_materials_ramp);
  CU_add_test(suite, "pairs change", pairs_change);
  CU_add_test(suite, "zero velocities is a start from rest", zero_velocities_starts_from_rest);
  CU_add_test(suite, "friction switches shear on and off", friction_switches_shear);
  CU_ADD_TEST(suite, rotation_begins_with_the_friction);
  CU_add_test(suite, "cohesion carries no tension", cohesion_carries_no_tension);
  CU_add_test(suite, "the step follows the stiffness", the_step_follows);
  CU_add_test(suite, "weight counts in unbalanced.max", weight_counts_in_the_balance);
  CU_add_test(suite, "unbalanced.max of several particles and contacts", largest_of_all_forces);
  CU_add_test(suite, "reverse velocities reverses walls", velocities_of_walls_reverse);
  CU_add_test(suite, "a spin ramps", a_spin_ramps);
  CU_ADD_TEST(suite, a_wall_keeps_its_other_motion);
}
