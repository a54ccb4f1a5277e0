/* A box whose walls follow a strain rate or a servo.
 *
 * A disc of radius 1, mass M and stiffness k is in the middle of a square box of side W. The force at each wall is F =
 * k (1 - W/2), so the stress is p = F/W. The distance from the centre to a wall is W/2. So the servo has the bulk
 * stiffness B = 4 k (W/2)^2/(4 W^2) = k/4 and the time T = W (M/(W^2 B))^(1/2) (docs/METHOD.md). The disc does not
 * move, so W follows a recursion.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "core/affine.h"
#include "core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define DISC                                                                                                           \
  "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 1 m\nwall shelf 5 5 to 6 5 m\nbox -1 -1 to " \
  "1 1 m\nwall rail 5 7 to 6 7 m\n"

static void run(struct nb_result *result, const char *page) {
  struct words words = {0};
  struct written it;
  words_add(&words, "%s", page);
  written_scene(&it, &words);
  written_run(result, &it, NULL);
  written_free(&it);
}

static const double *row(const struct nb_result *result, size_t n) {
  return result->table.values + n * result->table.column_count;
}

static void the_servo_follows_the_recursion(void) {
  const double pi = 3.14159265358979323846, dt = 0.0125, most = 1e-4, wanted = 7;
  const double b = 1000 / 4., t = sqrt(2 * pi / b);
  struct nb_result result;
  run(&result, DISC "record box.width box.height box.stress.xx box.stress.yy cycle\nstage s\n"
                    "servo isotropic 7 on box through box at most 1e-4 per cycle every 3 cycles\ncycles 1500\n");
  double side = 2, rate = 0, gathered = NAN;
  int limited = 0;
  for (int n = 0; n <= 1500; n++) {
    const double p = 1000 * (1 - side / 2) / side;
    CU_ASSERT_DOUBLE_EQUAL(row(&result, (size_t)n)[0], side, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, (size_t)n)[1], side, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, (size_t)n)[2], p, 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, (size_t)n)[3], p, 1e-9);
    const double requested = p > 0 ? (p - wanted) / (2 * b * t) * dt : -INFINITY;
    if (n % 3 == 0) { /* the recursion of tests/servo.c */
      const bool fast = !(fabs(requested) <= most);
      const double first = fast ? copysign(most, requested) : requested;
      const bool anew = fast || !(fabs(first + gathered) <= most);
      rate = anew ? first * (1 - (1 - sqrt(0.75)) / 2) : first + gathered;
      gathered = anew ? -(1 - sqrt(0.75)) / 2 * first : gathered + first * 3 * dt / (16 * t);
    }
    limited += fabs(rate) > 0.9 * most;
    side *= 1 + rate;
  }
  CU_ASSERT(limited > 10 && limited < 300);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "box.stress.xx"), wanted, 0.005 * wanted);
  nb_result_free(&result);
}

/* The sum of the proportional and the integral part stays within `at most`: if it would exceed this limit, the integral
 * part begins again. With an error of 0.19 in the stress the proportional part is 0.19/(2 B T) = 0.0024 1/s. This is
 * 0.3 of the limit of 1e-4 per cycle, which is 0.008 1/s. The integral part is set to 0.6 and to 0.9 of the limit. */
static void both_parts_of_the_servo_stay_within_the_limit(void) {
  static const double integrals[] = {0.6, 0.9};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(
        &page, DISC
        "record time\nstage s\nservo isotropic 7 on box through box at most 1e-4 per cycle every 1 cycle\ncycles 1500\n"
        "stage t\nservo isotropic 7.19 on box through box at most 1e-4 per cycle every 1 cycle\ncycles 9\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1500);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    written_cycles(model, 1);
    const double most = 1e-4 / model->step, z = integrals[k] * most;
    struct nb_tensor *integral = &model->affine->servo_state.integral;
    *integral = tensor(-z, 0, 0, -z);
    written_cycles(model, 1);
    const struct nb_tensor added = model->affine->rate[NB_AFFINE_BOX];
    const double p = k ? added.xx / (1 - (1 - sqrt(0.75)) / 2) : added.xx + z;
    CU_ASSERT(p < -0.25 * most && p > -0.35 * most); /* so that both sides of the limit occur */
    CU_ASSERT(tensor_largest(added) <= most);
    CU_ASSERT_DOUBLE_EQUAL(added.yy, added.xx, 1e-9 * most);
    CU_ASSERT_EQUAL(integral->xx < -z, k == 0); /* the integral grows, or begins again with the other sign */
    CU_ASSERT_EQUAL(integral->xx > 0, k == 1);
    CU_ASSERT_EQUAL(model->affine->servo_state.phase, NB_SERVO_FREE); /* it has been below the limit before */
    nb_model_free(model);
    written_free(&it);
  }
}

/* The ends of each wall are the corners of the box, also after `transform`. */
static void corners_stay_closed(void) {
  static const char *const places[] = {"", "transform mirror x rotate 0.52359877559829882 translate 0.5 -0.25\n"};
  static const double angles[] = {0, 30 * 3.14159265358979323846 / 180};
  for (int k = 0; k < 2; k++) {
    struct words words = {0};
    struct written it;
    struct nb_result result;
    words_add(&words,
              "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 0.5 m\nbox -3 -2 to 3 2 m\n%s"
              "record box.width box.height box.strain.width box.strain.height\nstage s\n"
              "box strain 1e-4 per cycle -2e-4 per cycle\ncycles 500\nsnapshot\n",
              places[k]);
    written_scene(&it, &words);
    written_run(&result, &it, NULL);
    const double wide = 6 * pow(1 + 1e-4, 500), high = 4 * pow(1 - 2e-4, 500);
    const double x[] = {-wide / 2, wide / 2, wide / 2, -wide / 2}, y[] = {-high / 2, -high / 2, high / 2, high / 2};
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 500)[0], wide, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 500)[1], high, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 500)[2], wide / 6 - 1, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 500)[3], high / 4 - 1, 1e-12);
    for (int w = 0; w < 4; w++) {
      const double *wall = result.snapshots[0].walls.values + 5 * w;
      for (int end = 0; end < 2; end++) {
        const int corner = (w + end) % 4;
        const double px = k ? -x[corner] : x[corner], c = cos(angles[k]), s = sin(angles[k]);
        CU_ASSERT_DOUBLE_EQUAL(wall[1 + 2 * end], c * px - s * y[corner] + 0.5 * k, 1e-12);
        CU_ASSERT_DOUBLE_EQUAL(wall[2 + 2 * end], s * px + c * y[corner] - 0.25 * k, 1e-12);
      }
    }
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The walls follow the strain rate of the box until a stage gives them other velocities. They follow it again when a
 * stage strains the box or a servo controls it. */
static void walls_follow_until_they_are_moved(void) {
  static const double wanted[] = {4 * 1.001, 4 * 1.001 * 1.001, 4 * 1.001 * 1.001, 4 * 1.001 * 1.001 - 0.025,
                                  4 * 1.001 * 1.001 - 0.025};
  struct nb_result result;
  run(&result, "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 0.5 m\nbox -2 -2 to 2 2 m\nwall "
               "rail 5 7 to 6 7 m\n"
               "record box.width box.height\nstage a\nbox strain 1e-3 per cycle 0 per cycle\ncycles 1\n"
               "stage b\nstep 0.025\nwall rail velocity 1 0\ncycles 1\nstage c\nwalls stop\ncycles 1\nstage d\nwalls "
               "inward 1\nstep 0.0125\n"
               "cycles 1\nstage e\nbox strain 0 per cycle 1e-3 per cycle\ncycles 1\n"
               "stage f\nwalls inward -1\ncycles 1\n"
               "stage g\nservo mean 1 on box through box at most 1e-3 per cycle\ncycles 1\n");
  for (size_t n = 0; n < 5; n++)
    CU_ASSERT_DOUBLE_EQUAL(row(&result, n + 1)[0], wanted[n], 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 4)[1], 4 - 0.025, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 5)[1], (4 - 0.025) * 1.001, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 6)[0], wanted[4] + 0.025, 1e-12);
  CU_ASSERT(row(&result, 7)[0] < row(&result, 6)[0]); /* the servo has ended the motions of the stages e and f */
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 7)[1] / row(&result, 6)[1], row(&result, 7)[0] / row(&result, 6)[0], 1e-12);
  nb_result_free(&result);
}

/* If a stage moves or removes one of the four walls, none of them follows the strain rate any more, and the others stop.
 * A wall that the page defines before the box or after it does not end the strain, and keeps its own velocity. */
static void any_wall_that_moves_ends_the_strain(void) {
  static const struct {
    const char *line;
    double width, height; /* change in the second stage, in which a wall moves by 0.001, 0.002 */
  } rows[] = {
      {"wall first velocity 0.08 0.16", 4 * 1.001 * 0.001, 4 * 1.001 * 0.001},
      {"wall last velocity 0.08 0.16", 4 * 1.001 * 0.001, 4 * 1.001 * 0.001},
      {"remove wall first", 4 * 1.001 * 0.001, 4 * 1.001 * 0.001},
      {"wall south velocity 0.08 0.16", 0, -0.002},
      {"wall north velocity 0.08 0.16", 0, 0.002},
      {"wall east velocity 0.08 0.16", 0.001, 0},
      {"wall west velocity 0.08 0.16", -0.001, 0},
      {"remove wall south", 0, 0},
      {"remove wall east", 0, 0},
      {"ramp wall east velocity 0 0", 0.16 / 2 * 0.0125, 0}, /* from the velocity 2 * 1e-3/0.0125 in stage a */
      {"ramp wall east velocity 0 0\nwall west velocity 0 0", 0.16 / 2 * 0.0125, 0},
      {"wall west velocity 0 0\nramp wall east velocity 0 0", 0.16 / 2 * 0.0125, 0},
      {"wall north spin 0", 0, 0}, /* without a velocity the wall has that of the lines before: 0 */
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 0.5 m\nwall first -9 7 to -8 7 m\n"
        "box -2 -2 to 2 2 m\nwall last 8 7 to 9 7 m velocity 1 0\nmonitor F wall first\nmonitor L wall last\n"
        "record box.width box.height F.x L.x\nstage a\nwall first velocity 2 0\nbox strain 1e-3 per cycle 1e-3 per "
        "cycle\ncycles 1\nstage b\n%s\ncycles 1\n",
        rows[k].line);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "box.width"), 4 * 1.001 + rows[k].width, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "box.height"), 4 * 1.001 + rows[k].height, 1e-12);
    const bool first = strstr(rows[k].line, "first"), last = strstr(rows[k].line, "last");
    const double f = written_last(&result, "F.x") - written_cell(&result.table, 1, "F.x"),
                 l = written_last(&result, "L.x") - written_cell(&result.table, 1, "L.x");
    CU_ASSERT(first || fabs(f - 2 * 0.0125) < 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(l, (last ? 0.08 : 1) * 0.0125, 1e-14);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Walls that the page defines before and after the box keep their own motion while the box is strained. */
static void other_walls_keep_their_motion(void) {
  struct nb_result result;
  run(&result,
      "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 0.5 m\nwall first -9 7 to -8 7 m\n"
      "box -2 -2 to 2 2 m\nwall last 8 7 to 9 7 m\nrecord box.width\nstage a\nbox strain 1e-3 per cycle 0 per "
      "cycle\nwall first velocity 1 2 spin 1\nwall last velocity -3 4 spin -1\ncycles 1\nsnapshot\n");
  const double *walls = result.snapshots[0].walls.values, far = 1e-3; /* tolerance: the wall also rotates by 0.0125 */
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 1)[0], 4 * 1.001, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL((walls[1] + walls[3]) / 2, -8.5 + 0.0125, far);
  CU_ASSERT_DOUBLE_EQUAL((walls[25 + 1] + walls[25 + 3]) / 2, 8.5 - 3 * 0.0125, far);
  CU_ASSERT_DOUBLE_EQUAL(walls[4] - walls[2], sin(0.0125), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(walls[25 + 4] - walls[25 + 2], -sin(0.0125), 1e-12);
  nb_result_free(&result);
}

/* F = 10 at each wall of the box. The second particle presses with 5 and 15 on two other walls, which do not count. The
 * thickness of a disc is 1, that of a sphere its diameter. */
static void box_stress_counts_the_four_walls(void) {
  static const double wanted[] = {5, 0, 0, 5}, thick[] = {1, 2.02};
  static const char *const shapes[] = {"disc", "sphere"};
  for (int shape = 0; shape < 2; shape++) {
    struct words words = {0};
    struct written it;
    struct nb_result result;
    words_add(&words,
              "units none\nmaterial m density 2 kn 1000\nstep 0.0125\nwall shelf 5 5 to 6 5 m\nbox -1 -1 to 1 1 m\n"
              "wall rail 5 7 to 6 7 m\n%s 0 0 radius 1.01 m\n%s 5.5 6.005 radius 1.01 m\n"
              "record box.stress.xx box.stress.xy box.stress.yx box.stress.yy walls.stress.xx walls.stress.xy "
              "walls.stress.yx walls.stress.yy walls.ratio walls.force.residual\nstage s\ncycles 1\n",
              shapes[shape], shapes[shape]);
    written_scene(&it, &words);
    written_run(&result, &it, NULL);
    for (size_t k = 0; k < 4; k++)
      for (size_t walls = 0; walls < 8; walls += 4)
        CU_ASSERT_DOUBLE_EQUAL(row(&result, 0)[walls + k], wanted[k] / thick[shape], 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 0)[8], 1, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(row(&result, 0)[9], 0, 1e-10);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The porosity of a box of 10 by 8 with three discs, one of which a stage removes; the box is then made narrower. */
static void porosity_of_the_box(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  const double pi = 3.14159265358979323846;
  words_add(&page, "units none\nmaterial m density 2 kn 1000\nstep 0.01\ndisc 0 0 radius 1 m\ndisc 2.5 0 radius 0.5 m\n"
                   "disc -3 1 radius 2 m\nbox -5 -4 to 5 4 m\nrecord box.porosity box.void_ratio\nstage one\ncycles 1\n"
                   "stage two\nremove disc 3\nbox strain -0.1 per cycle 0 per cycle\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double first = 1 - 5.25 * pi / 80, last = 1 - 1.25 * pi / 72;
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 1)[0], first, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(row(&result, 1)[1], first / (1 - first), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "box.porosity"), last, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "box.void_ratio"), last / (1 - last), 1e-11);
  nb_result_free(&result);
  written_free(&it);
}

/* Heavy discs press on the walls of a box of 10 by 8. The forces are 100 and 50 on south, at -3 and 2 from its middle
 * along the wall; 20 and 50 on east, at 2 and -2; 80 on north; 10 on west. Then east moves tangentially by 0.004, which
 * causes a shear force of 4 on each of its discs; friction would allow 10 and 25. The wall `free` is no wall of the
 * box. It carries 100 at 2 from its middle, and its moment is taken about the point (14, 3). */
static void forces_on_walls(void) {
  static const struct {
    const char *name;
    double wanted;
  } first[] = {{"S.fy", -150},
               {"S.moment", 200},
               {"S.eccentricity", -200. / 150 / 5},
               {"E.moment", 60},
               {"E.eccentricity", -60. / 70 / 4},
               {"N.eccentricity", 0.2},
               {"W.eccentricity", 0.75},
               {"E.obliquity", 0},
               {"free.eccentricity", 0.5},
               {"free.fx", 100},
               {"free.moment", -300},
               {"walls.stress.xx", 80. / 2 / 8},
               {"walls.stress.yy", 230. / 2 / 10},
               {"walls.stress.xy", 0},
               {"box.stress.xx", 80. / 2 / 8},
               {"box.stress.xy", (20 * 2 - 50 * 2 + 10 * 3) / 80.},
               {"walls.ratio", 80. / 230},
               {"walls.force.residual", 92.19544457292888}},
    last[] = {{"free.fy", -4},           {"free.moment", 2 * 4 - 2.996 * 100},
              {"E.obliquity", 0.4},      {"E.fy", -8},
              {"walls.stress.yx", -0.5}, {"walls.stress.xy", 0}};
  struct nb_result result;
  run(&result, "units none\nmaterial m density 2e15 kn 1000 ks 1000 friction 0.5\nstep 0.004\nbox 0 0 to 10 8 m\n"
               "wall free 12 0 to 12 8 m about 14 3\ndisc 11.5 6 radius 0.6 m\n"
               "disc 2 0.4 radius 0.5 m\ndisc 7 0.45 radius 0.5 m\ndisc 9.52 6 radius 0.5 m\ndisc 9.55 2 radius 0.5 m\n"
               "disc 4 7.58 radius 0.5 m\ndisc 0.49 1 radius 0.5 m\nmonitor S wall south\n"
               "monitor E wall east\nmonitor N wall north\nmonitor W wall west\nmonitor free wall free\n"
               "normal linear\nshear linear\nrecord S.fy S.moment S.eccentricity E.moment E.eccentricity E.obliquity\n"
               "record N.eccentricity W.eccentricity free.eccentricity free.fx free.moment walls.stress.xx "
               "walls.stress.yy walls.stress.xy\n"
               "record walls.stress.yx box.stress.xx box.stress.xy walls.ratio walls.force.residual E.fy free.fy\n"
               "stage s\nwall east velocity 0 1\nwall free velocity 0 1\ncycles 1\n");
  for (size_t k = 0; k < sizeof first / sizeof *first; k++)
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, 0, first[k].name), first[k].wanted, 1e-9);
  for (size_t k = 0; k < sizeof last / sizeof *last; k++)
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, last[k].name), last[k].wanted, 1e-9);
  nb_result_free(&result);
}

/* Two discs are pressed by a box of 40 by 20. The ratio of the wall forces is the same in any direction of the box. */
static void the_ratio_of_a_transformed_box(void) {
  static const char *const transforms[] = {"none", "none rotate 1.5707963267948966", "none rotate 0.5", "x rotate 3.5"};
  for (size_t k = 0; k < sizeof transforms / sizeof *transforms; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\ndisc 10.5 11 radius 11 m\ndisc 29.5 9 radius 11 m\n"
              "box 0 0 to 40 20 m\ntransform mirror %s\nstep 1e-6\nrecord walls.ratio\nstage a\ncycles 1\n",
              transforms[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    /* overlaps: west 0.5, east 0.5, south 0 and 2, north 2 and 0 */
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "walls.ratio"), 0.5 / 2, 1e-9);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Without a force on the south and the north wall their ratio is 0. */
static void the_ratio_without_a_vertical_force(void) {
  struct nb_result result;
  run(&result, "units none\nmaterial m density 1 kn 1\ndisc 1 5 radius 1.1 m\nbox 0 0 to 2 10 m\nstep 1e-6\n"
               "record walls.ratio walls.stress.xx\nstage a\ncycles 1\n");
  CU_ASSERT_EQUAL(written_last(&result, "walls.ratio"), 0);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "walls.stress.xx"), 0.1 / 10, 1e-9);
  nb_result_free(&result);
}

void suite_box(void) {
  CU_pSuite suite = CU_add_suite("box", NULL, NULL);
  CU_add_test(suite, "porosity of the box", porosity_of_the_box);
  CU_add_test(suite, "a servo through the box follows the recursion", the_servo_follows_the_recursion);
  CU_add_test(suite, "both parts of the servo stay within the limit", both_parts_of_the_servo_stay_within_the_limit);
  CU_add_test(suite, "corners stay closed, also after transform", corners_stay_closed);
  CU_add_test(suite, "the stresses and forces of a box count its four walls only", box_stress_counts_the_four_walls);
  CU_add_test(suite, "forces on walls: traction, moment, eccentricity, obliquity", forces_on_walls);
  CU_add_test(suite, "ratio of the wall forces of a transformed box", the_ratio_of_a_transformed_box);
  CU_add_test(suite, "ratio of the wall forces without a vertical force", the_ratio_without_a_vertical_force);
  CU_add_test(suite, "walls follow the box until they are moved otherwise", walls_follow_until_they_are_moved);
  CU_add_test(suite, "any wall that moves ends the strain of the box", any_wall_that_moves_ends_the_strain);
  CU_add_test(suite, "other walls keep their own motion", other_walls_keep_their_motion);
}
