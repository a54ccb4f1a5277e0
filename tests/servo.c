/* The servo on an assembly with known stiffness: six discs in a ring around a seventh. [R89 sec. 4.1]
 *
 * All particles follow the strain, so a recursion gives the radius R of the ring after each cycle. The discs of the
 * ring are a boundary, so there is no force between two of them. k is the stiffness of the springs between the ring and
 * the middle disc, r the radius of a disc, M the mass of all discs and A the area of the hexagon. The force F of a
 * spring, the stress p, and the servo's bulk stiffness B and time T (docs/METHOD.md) are
 *
 *   F = k (2r - R), A = 3 sqrt(3)/2 R^2, p = 3 F R/A, B = 3 k R^2/(2 A), T = 2 R (M/(A B))^(1/2)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "loading/loading.h"
#include "measure/boundary.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define RING                                                                                                           \
  "units none\nmaterial m density 2 kn 1000\nstep 0.0125\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\n"                  \
  "disc 1 1.7320508075688775 radius 1 m\ndisc -1 1.7320508075688775 radius 1 m\ndisc -2 0 radius 1 m\n"                \
  "disc -1 -1.7320508075688775 radius 1 m\ndisc 1 -1.7320508075688775 radius 1 m\nboundary circle 0 0 radius 2\n"      \
  "record boundary.radius boundary.stress.mean boundary.stress.xx boundary.stress.yy boundary.stress.xy cycle\n"

static double pressure(double radius) {
  const double force = 1000 * (2 - radius), area = 1.5 * sqrt(3) * radius * radius;
  return force > 0 ? 3 * force * radius / area : 0;
}

/* Returns the strain that the servo imposes in one cycle on a ring of this radius. `wanted` is the target of the
 * stress, `most` the largest strain of a cycle, and `every` the number of cycles between two measurements. *gathered is
 * the integral part Z of the strain rate (docs/METHOD.md) times the step; NAN before the first measurement. */
static double strain(double radius, double wanted, double most, int every, double *gathered) {
  const double pi = 3.14159265358979323846, mass = 7 * 2 * pi, area = 1.5 * sqrt(3) * radius * radius, dt = 0.0125;
  const double stiffness = radius < 2 ? 1.5 * 1000 * radius * radius / area : 0;
  const double time = 2 * radius * sqrt(mass / (area * stiffness));
  const double off = pressure(radius) - wanted, requested = off / (2 * stiffness * time) * dt;
  const bool limited = !(stiffness > 0 && fabs(requested) <= most);
  const double p = limited ? copysign(most, off) : requested, rate = p + *gathered;
  const bool anew = limited || !(fabs(rate) <= most);
  *gathered = anew ? -(1 - sqrt(3) / 2) / 2 * p : *gathered + p * every * dt / (16 * time);
  return anew ? p + *gathered : rate;
}

static void run(struct nb_result *result, const char *stage) {
  struct words page = {0};
  struct written it;
  words_add(&page, RING "%s", stage);
  written_scene(&it, &page);
  written_run(result, &it, NULL);
  written_free(&it);
}

/* The error is the largest difference of a controlled component from its target, over the largest target. The stress of
 * the ring is isotropic. Components that are not controlled do not count. If all targets are 0, the error is 0. The
 * springs do not carry tension. So with a target in tension the stress stays 0, and the error is 1. */
static void the_error_is_relative(void) {
  static const struct {
    const char *servo;
    double target[2]; /* in x and y, NAN: not controlled; equal for the mean */
    const char *ramp; /* a ramp begins at another stress, but its error is that from the final target */
  } rows[] = {{"isotropic 12", {12, 12}, "ramp "},
              {"xx 6 yy 12", {6, 12}, "ramp "},
              {"isotropic 12", {12, 12}},
              {"mean 5", {5, 5}},
              {"xx 12", {12, NAN}},
              {"xx 6 yy 12", {6, 12}},
              {"yy 3", {NAN, 3}},
              {"xx 0", {0, NAN}},
              {"isotropic -12", {-12, -12}},
              {"xx 0.25", {0.25, NAN}}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              RING
              "stage s\n%sservo %s on boundary through boundary at most 1e-4 per cycle\ncycles 90\nstage t\ncycles 1\n",
              rows[k].ramp ? rows[k].ramp : "", rows[k].servo);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 70);
    const struct nb_tensor now = nb_boundary_stress(model);
    const double off[] = {fabs(now.xx - rows[k].target[0]), fabs(now.yy - rows[k].target[1])};
    const double largest = fmax(fabs(rows[k].target[0]), fabs(rows[k].target[1])); /* fmax ignores NAN */
    CU_ASSERT_DOUBLE_EQUAL(nb_servo_error(model), largest > 0 ? fmax(off[0], off[1]) / largest : 0, 1e-9);
    CU_ASSERT(!(largest > 0) || nb_servo_error(model) > 0.01);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    CU_ASSERT_EQUAL(nb_servo_error(model), 0); /* a stage without a servo */
    nb_model_free(model);
    written_free(&it);
  }
}

/* The boundary of discs that do not rotate may have a stress with xy and yx that differ: here the middle disc rotates,
 * and its friction turns the ring. A servo controls xy. */
static void the_error_of_a_stress_that_is_not_symmetric(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 2 kn 1000 ks 500 friction 0.5\nshear linear\nstep 0.0125\n"
                   "disc 0 0 radius 1.01 m spin 1\n");
  for (int k = 0; k < 6; k++)
    words_add(&page, "disc %.17g %.17g radius 1 m\n", 2 * cos(k * acos(0.5)), 2 * sin(k * acos(0.5)));
  words_add(&page, "boundary circle 0 0 radius 1.999\nrecord cycle\nstage s\n"
                   "servo xy 0.25 on boundary through boundary at most 1e-9 per cycle\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 9);
  const struct nb_tensor now = nb_boundary_stress(model);
  CU_ASSERT(now.xy * now.yx < 0 && fabs(now.xy - now.yx) > 1);
  CU_ASSERT_DOUBLE_EQUAL(nb_servo_error(model), fabs(now.xy - 0.25) / 0.25, 1e-9);
  /* The components in the axes n and m of a servo that is rotated by 30 degrees are n s n, m s m and n s m. */
  const struct nb_vec n = vec(cos(asin(0.5)), 0.5), m = vec(-0.5, n.x);
  const double rotated[] = {vec_dot(n, tensor_times(now, n)), vec_dot(m, tensor_times(now, m)),
                            vec_dot(n, tensor_times(now, m))};
  struct nb_servo *servo = &it.scene.stages[0].servo;
  servo->axis_x[0] = n.x, servo->axis_x[1] = n.y, servo->axis_y[0] = m.x, servo->axis_y[1] = m.y;
  for (int k = 0; k < 3; k++) {
    for (double target = -0.25; target < 0.5; target += 0.5) {
      for (int other = 0; other < 3; other++)
        servo->controlled[other] = other == k, servo->stress[other] = other == k ? target : 0;
      CU_ASSERT_DOUBLE_EQUAL(nb_servo_error(model), fabs(rotated[k] - target) / 0.25, 1e-9);
    }
  }
  nb_model_free(model);
  written_free(&it);
}

/* A servo counts as limited in all cycles until its rate is once below the limit. It does not count as limited after
 * that, even if its rate reaches the limit again. */
static void a_servo_that_was_once_below_its_limit(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page,
            RING "stage s\nservo isotropic 12 on boundary through boundary at most 1e-4 per cycle\ncycles 900\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 9);
  CU_ASSERT_EQUAL(model->affine->servo_state.phase, NB_SERVO_LIMITED);
  written_cycles(model, 400);
  CU_ASSERT_EQUAL(model->affine->servo_state.phase, NB_SERVO_FREE);
  const double radius = written_now(model, "boundary.radius");
  it.scene.stages[0].servo.stress[0] = it.scene.stages[0].servo.stress[1] = 1200;
  written_cycles(model, 9);
  CU_ASSERT(written_now(model, "boundary.radius") < radius * pow(1 - 0.9e-4, 8)); /* at the limit again */
  CU_ASSERT_EQUAL(model->affine->servo_state.phase, NB_SERVO_FREE);
  nb_model_free(model);
  written_free(&it);
}

/* The radius follows the recursion, with a measurement every fifth cycle. At first it changes at 0.93 of the largest
 * rate, because the integral part begins again at every measurement. In the end the stress is at its target. */
static void stress_follows_the_recursion(void) {
  struct nb_result result;
  run(&result,
      "stage s\nservo isotropic 12 on boundary through boundary at most 1e-4 per cycle every 5 cycles\ncycles 400\n");
  double radius = 2, now = 0, gathered = NAN;
  int limited = 0;
  for (int n = 0; n < 400; n++) {
    const double *row = result.table.values + (size_t)n * result.table.column_count;
    CU_ASSERT_DOUBLE_EQUAL(row[0], radius, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(row[1], pressure(radius), 1e-8);
    CU_ASSERT_DOUBLE_EQUAL(row[2], row[3], 1e-8);
    CU_ASSERT_DOUBLE_EQUAL(row[4], 0, 1e-8);
    if (n % 5 == 0)
      now = strain(radius, 12, 1e-4, 5, &gathered);
    limited += fabs(now) > 0.93e-4;
    radius *= 1 + now;
  }
  CU_ASSERT(limited > 10 && limited < 300);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 12, 0.005 * 12);
  nb_result_free(&result);
}

/* The target changes linearly from the stress at the beginning of the stage to the final value. */
static void a_ramp_is_followed(void) {
  struct nb_result result;
  run(&result,
      "stage s\nservo mean 6 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 300\n"
      "stage r\nramp servo mean 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 3000\n");
  double radius = 2, gathered = NAN;
  for (int n = 0; n < 300; n++)
    radius *= 1 + strain(radius, 6, 1e-3, 1, &gathered);
  const double from = pressure(radius);
  gathered = NAN;
  for (int n = 0; n < 3000; n++)
    radius *= 1 + strain(radius, from + (n + 1) / 3000. * (9 - from), 1e-3, 1, &gathered);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.radius"), radius, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 9, 0.005 * 9);
  nb_result_free(&result);
}

/* Under a steady dilatation no offset of the stress remains, and the error has the two decay rates of the theory. The
 * proportional part alone would leave the offset B T d, where d is the dilatation rate. */
static void no_offset_under_a_dilatation(void) {
  struct nb_result result;
  run(&result,
      "stage s\nservo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 8000\n"
      "stage d\nboundary strain 2e-6 per cycle 2e-6 per cycle\n"
      "servo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 8000\n");
  const double *row = result.table.values + 8000 * result.table.column_count, radius = row[0];
  const double pi = 3.14159265358979323846, dt = 0.0125, area = 1.5 * sqrt(3) * radius * radius;
  const double b = 1500 * radius * radius / area, t = 2 * radius * sqrt(14 * pi / (area * b)), d = 4e-6 / dt;
  /* e is the error of the stress, and y = 2 B Z with the integral part Z of the strain rate. They obey
   * e' = -(e/T + y) - B d and y' = e/(16 T^2). So e = -B d (exp(-s t) - exp(-f t))/(f - s), with the decay rates s
   * (slow) and f (fast). */
  const double slow = (1 - sqrt(0.75)) / 2 / t, fast = (1 + sqrt(0.75)) / 2 / t;
  double worst = 0;
  for (int n = 0; n <= 8000; n += 10) {
    const double *at = row + (size_t)n * result.table.column_count, time = n * dt;
    const double off = -b * d * (exp(-slow * time) - exp(-fast * time)) / (fast - slow);
    worst = fmax(worst, fabs(at[1] - 9 - off));
  }
  CU_ASSERT(b * t * d > 0.005 * 9);    /* the offset of the proportional part alone */
  CU_ASSERT(worst < 0.04 * b * t * d); /* the theory neglects dt/T = 0.036 and F/(k R) = 0.008 */
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 9, 1e-3 * b * t * d);
  nb_result_free(&result);
}

/* Under a servo that controls the mean stress, the strain rate of the stage changes the shape. Under a servo that
 * controls one component, the strain rate of the stage changes the other components. */
static void components_that_are_not_controlled(void) {
  struct nb_result result;
  run(&result,
      "stage s\nservo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 600\n"
      "stage m\nboundary strain 2e-6 per cycle -2e-6 per cycle\n"
      "servo mean 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 600\n");
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 9, 0.005 * 9);
  CU_ASSERT(written_last(&result, "boundary.stress.yy") > 1.02 * written_last(&result, "boundary.stress.xx"));
  nb_result_free(&result);
  run(&result,
      "stage s\nservo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 600\n"
      "stage y\nboundary strain 0 per cycle -2e-6 per cycle\n"
      "servo xx 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 600\n");
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.xx"), 9, 0.005 * 9);
  CU_ASSERT(written_last(&result, "boundary.stress.yy") > 9.1);
  nb_result_free(&result);
}

/* `isotropic` keeps the shear stress at 0; under `mean` the shear stress follows the strain of the stage. */
static void isotropic_has_no_shear(void) {
  double shear[2];
  for (int mean = 0; mean < 2; mean++) {
    char stages[512];
    struct nb_result result;
    snprintf(
        stages, sizeof stages,
        "stage s\nservo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 600\n"
        "stage m\nboundary strain 0 per cycle 0 per cycle shear 1e-6 per cycle\n"
        "servo %s 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 4000\n",
        mean ? "mean" : "isotropic");
    run(&result, stages);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 9, 0.005 * 9);
    shear[mean] = written_last(&result, "boundary.stress.xy");
    nb_result_free(&result);
  }
  CU_ASSERT(fabs(shear[1]) > 0.5);
  CU_ASSERT(fabs(shear[0]) < 0.01 * fabs(shear[1]));
}

/* By default the stress is measured every tenth cycle. */
static void every_tenth_cycle(void) {
  static const char *const words[] = {"", "every 10 cycles", "every 1 cycle"};
  double radius[3];
  for (int k = 0; k < 3; k++) {
    char stage[256];
    struct nb_result result;
    snprintf(stage, sizeof stage,
             "stage s\nservo mean 9 on boundary through boundary at most 1e-4 per cycle %s\ncycles 95\n", words[k]);
    run(&result, stage);
    radius[k] = written_last(&result, "boundary.radius");
    nb_result_free(&result);
  }
  CU_ASSERT(radius[0] == radius[1] && radius[0] != radius[2]);
}

/* The servo does not count the mass of a removed disc: the ring moves as in a scene without this disc, to the last
 * bit. */
static void removed_particles_have_no_mass(void) {
  static const char *const pages[] = {RING "stage s\n", RING "disc 1 0.577 radius 0.1 m\nstage s\nremove disc 8\n"};
  double radius[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "%sservo isotropic 9 on boundary through boundary at most 1e-3 per cycle every 1 cycle\ncycles 100\n",
              pages[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    radius[k] = written_last(&result, "boundary.radius");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT(radius[0] < 2);
  CU_ASSERT_EQUAL(radius[1], radius[0]);
}

/* A servo `on` a region controls the stress of the region, not that of the boundary. All contacts are in the circle of
 * radius 2.5, so the stress of the circle is that of the boundary times A/(6.25 pi), with the area A of the
 * boundary. */
static void stress_of_a_region(void) {
  const double pi = 3.14159265358979323846;
  struct nb_result result;
  struct words page = {0};
  struct written it;
  words_add(&page, RING "region A circle 0 0 radius 2.5\nrecord A.stress.mean boundary.area\nstage s\n"
                        "servo isotropic 5 on A through boundary at most 1e-3 per cycle every 1 cycle\ncycles 3000\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double boundary = written_last(&result, "boundary.stress.mean") * written_last(&result, "boundary.area");
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.stress.mean"), 5, 0.025);
  CU_ASSERT_DOUBLE_EQUAL(boundary, 6.25 * pi * written_last(&result, "A.stress.mean"), 1e-9);
  nb_result_free(&result);
  written_free(&it);
}

/* With `through boundary affine` a disc without contacts moves like the ring. With `through boundary` this disc does
 * not move. */
static void servo_through_boundary_affine(void) {
  static const char *const by[] = {"boundary", "boundary affine"};
  for (int k = 0; k < 2; k++) {
    struct nb_result result;
    struct words page = {0};
    struct written it;
    words_add(&page,
              RING
              "material h density 500 kn 1000\ndisc 1 0.57 radius 0.1 h\nmonitor D disc 8\nrecord D.x D.y\nstage s\n"
              "servo isotropic 9 on boundary through %s at most 1e-3 per cycle every 1 cycle\ncycles 2000\n",
              by[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double shrunk = k ? written_last(&result, "boundary.radius") / 2 : 1;
    CU_ASSERT(written_last(&result, "boundary.radius") < 1.995);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.x"), shrunk, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.y"), 0.57 * shrunk, 1e-12);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A square lattice of discs in a cell. With the spacing s, the radius r, the stiffness k of the springs, the mass per
 * area rho and the side L of the cell, p = k (2r - s)/s, B = k/2 and T = L (rho/B)^(1/2). So a recursion gives the
 * sides after each cycle. The strain rate of the stage is added to that of the servo. */
static void servo_through_a_cell(void) {
  const double pi = 3.14159265358979323846, dt = 0.0125, shear = 1e-7;
  struct nb_result result;
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 2 kn 1000\nstep 0.0125\nlattice discs 6 by 6 m radius 1 from 1 1\n"
            "periodic cell 0 0 to 12 12\nrecord cell.xx cell.yy cell.stress.xx cell.stress.yy cycle "
            "cell.strain.volumetric\nstage s\ncell strain %g per cycle %g per cycle\n"
            "servo mean 5 on cell through cell at most 1e-4 per cycle every 4 cycles\ncycles 1500\n",
            shear, -shear);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  double x = 12, y = 12, rate = 0, gathered = NAN;
  int limited = 0;
  for (int n = 0; n < 1500; n++) {
    const double *row = result.table.values + (size_t)n * result.table.column_count;
    const double px = 1000 * (2 - x / 6) * (x / 6) / (x * y / 36), py = 1000 * (2 - y / 6) * (y / 6) / (x * y / 36);
    CU_ASSERT_DOUBLE_EQUAL(row[0], x, 1e-11);
    CU_ASSERT_DOUBLE_EQUAL(row[1], y, 1e-11);
    CU_ASSERT_DOUBLE_EQUAL(row[5], x * y / 144 - 1, 1e-12);
    if (n > 0) { /* no stress before the first contact */
      CU_ASSERT_DOUBLE_EQUAL(row[2], px, 1e-8);
      CU_ASSERT_DOUBLE_EQUAL(row[3], py, 1e-8);
    }
    if (n % 4 == 0) {
      const double area = x * y / 36, b = 1000 * (x * x + y * y) / 36 / (4 * area);
      const double wave = sqrt(x * y) * sqrt(2 * pi / (area * b)), off = (px + py) / 2 - 5;
      const double requested = n == 0 ? -1 : off / (2 * b * wave) * dt;
      const double p = fabs(requested) > 1e-4 ? copysign(1e-4, requested) : requested;
      const bool anew = p != requested || !(fabs(p + gathered) <= 1e-4);
      const double begin = -(1 - sqrt(3) / 2) / 2 * p;
      rate = p + (anew ? begin : gathered);
      gathered = anew ? begin : gathered + p * 4 * dt / (16 * wave);
      limited += anew;
    }
    x *= 1 + rate + shear, y *= 1 + rate - shear;
  }
  CU_ASSERT(limited > 0 && limited < 300);
  CU_ASSERT_DOUBLE_EQUAL((written_last(&result, "cell.stress.xx") + written_last(&result, "cell.stress.yy")) / 2, 5,
                         0.025);
  nb_result_free(&result);
  written_free(&it);
}

/* A servo of xx and yy does not change the shear, although the cell has a shear stress: its side along x stays parallel
 * to x. */
static void a_servo_without_shear(void) {
  struct nb_result result;
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 2 kn 1000\nstep 0.0125\nlattice discs 6 by 6 m radius 1.01 spacing 2 "
            "from 1 1\nperiodic cell 0 0 to 12 12\nrecord cell.yx cell.xx cell.stress.xy\nstage shear\n"
            "cell strain 0 per cycle 0 per cycle c12 1e-4 per cycle\ncycles 100\nstage press\ncell strain 0 0\n"
            "servo xx 30 yy 30 on cell through cell at most 1e-4 per cycle\ncycles 100\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT(fabs(written_last(&result, "cell.stress.xy")) > 0.1);
  CU_ASSERT(written_last(&result, "cell.xx") < 11.99);
  CU_ASSERT_EQUAL(written_last(&result, "cell.yx"), 0);
  nb_result_free(&result);
  written_free(&it);
}

/* With springs, densities and stresses multiplied by 1e-4 the motion is the same, although the bulk stiffness is below
 * 1. */
static void soft_springs_give_the_same_motion(void) {
  static const double scales[] = {1, 1e-4};
  double radius[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              RING "stage s\nmaterial m kn %.17g\nservo isotropic %.17g on boundary through boundary at most 1e-4 per "
                   "cycle every 5 cycles\ncycles 400\n",
              1000 * scales[k], 12 * scales[k]);
    char *density = strstr(page.text, "density 2 kn 1000");
    CU_ASSERT_PTR_NOT_NULL_FATAL(density);
    memcpy(density, k ? "density 2e-4 kn 1" : "density 2 kn 1000", strlen("density 2 kn 1000"));
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    radius[k] = written_last(&result, "boundary.radius");
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.stress.mean"), 12 * scales[k], 0.005 * 12 * scales[k]);
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT_DOUBLE_EQUAL(radius[0], radius[1], 1e-12);
}

/* With a ramp the target begins at the measured stress. Without a ramp the target has its final value from the
 * start. */
static void initial_targets(void) {
  for (int ramp = 0; ramp < 2; ramp++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              RING "stage s\nboundary strain -1e-5 per cycle -2e-5 per cycle shear 1e-5 per cycle\ncycles 200\n"
                   "stage r\n%sservo xx 9 yy 8 xy 1 on boundary through boundary at most 1e-4 per cycle\ncycles 100\n",
              ramp ? "ramp " : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 200);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    static const char *const parts[] = {"boundary.stress.xx", "boundary.stress.yy", "boundary.stress.xy"};
    static const double targets[] = {9, 8, 1};
    for (int k = 0; k < 3; k++) {
      const double now = written_now(model, parts[k]);
      CU_ASSERT(fabs(now) > 0.1);
      CU_ASSERT_DOUBLE_EQUAL(model->affine->servo_state.stress[k], ramp ? now : targets[k], 1e-12 * fabs(now));
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* Tests B and T for one particle between the lower and the upper wall of a box that is wider than high, with a stiff
 * spring and with a soft one. The thickness of a disc is 1, that of a sphere its diameter 2. Without a contact B is 0,
 * and T is infinite. If the servo acts through a boundary, and the scene has no boundary, B and T are 0. */
static void scales_of_a_box(void) {
  static const double springs[] = {1000, 1}, heights[] = {1.9, 2.1};
  const double pi = 3.14159265358979323846;
  for (int k = 0; k < 8; k++) {
    const bool sphere = k & 1, apart = k & 2;
    const double spring = springs[k / 4], height = heights[apart], area = 6 * height, volume = sphere ? 2 * area : area;
    struct words page = {0};
    struct written it;
    double b = 7, t = 7;
    words_add(&page,
              "units none\nmaterial m density 2 kn %g\nstep 0.001\nbox 0 0 to 6 %g m\n%s 3 %g radius 1 m\n"
              "record cycle\nstage s\nservo isotropic 12 on box through box at most 1e-4 per cycle\ncycles 1\n",
              spring, height, sphere ? "sphere" : "disc", height / 2);
    written_scene(&it, &page);
    CU_ASSERT_FALSE(it.scene.stages[0].servo.controlled[2]); /* no shear stress through walls, which do not rotate */
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(nb_servo_scales(model, &it.scene.stages[0].servo, &b, &t), !apart);
    const double expected = apart ? 0 : spring * 2 * 0.95 * 0.95 / (4 * volume), mass = 2 * pi * (sphere ? 4. / 3 : 1);
    CU_ASSERT_DOUBLE_EQUAL(b, expected, 1e-12 * expected);
    CU_ASSERT(apart ? t == INFINITY : fabs(t - sqrt(area) * sqrt(mass / volume / expected)) < 1e-12 * t);
    CU_ASSERT_FALSE(nb_servo_scales(model, &(struct nb_servo){.every = 1}, &b, &t));
    CU_ASSERT(b == 0 && t == 0);
    nb_model_free(model);
    written_free(&it);
  }
}

/* B and T are 0 as long as the boundary has not begun, although the discs touch. */
static void no_scales_before_the_boundary(void) {
  struct words page = {0};
  struct written it;
  double b = 7, t = 7;
  words_add(&page, "units none\nmaterial m density 2 kn 1000\nstep 0.001\nlattice discs 3 by 1 radius 1 spacing 1.9 m\n"
                   "record cycle\nstage a\ncycles 1\nstage b\nboundary circle 0 0 radius 1\n"
                   "servo isotropic 12 on boundary through boundary at most 1e-4 per cycle\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_FALSE(nb_servo_scales(model, &it.scene.stages[1].servo, &b, &t));
  CU_ASSERT(b == 0 && t == 0);
  nb_model_free(model);
  written_free(&it);
}

/* B of a boundary has no springs of walls: a wall that touches the disc in the middle changes neither B nor T, except that it moves the disc by 1e-8. */
static void walls_do_not_stiffen_a_boundary(void) {
  double b[2], t[2];
  for (int wall = 0; wall < 2; wall++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              RING
              "%sstage s\nboundary strain -0.01 -0.01\n"
              "cycles 9\nstage t\nservo isotropic 12 on boundary through boundary at most 1e-4 per cycle\ncycles 1\n",
              wall ? "wall w 0.2 0.999999 to -0.2 0.999999 m\n" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT(model->contacts.count > (wall ? 6 : 5));
    CU_ASSERT(nb_servo_scales(model, &it.scene.stages[1].servo, &b[wall], &t[wall]));
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT_DOUBLE_EQUAL(b[1], b[0], 1e-4 * b[0]);
  CU_ASSERT_DOUBLE_EQUAL(t[1], t[0], 1e-4 * t[0]);
}

/* A boundary that a stress has released follows a servo again as soon as a stage holds its particles. */
static void a_boundary_that_is_held_again(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page,
            RING "stage s\nboundary stress 1 1\ncycles 1\nstage t\nboundary fixed\nservo isotropic 12 on boundary "
                 "through boundary affine at most 1e-4 per cycle every 1 cycle\ncycles 2\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (int s = 0; s < 2; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    written_cycles(model, 1 + s);
  }
  CU_ASSERT_NOT_EQUAL(model->affine->rate[NB_AFFINE_FREE].xx, 0);
  CU_ASSERT_NOT_EQUAL(model->affine->rate[NB_AFFINE_BOUNDARY].xx, 0);
  nb_model_free(model);
  written_free(&it);
}

/* The servo adds its strain rate to that of the boundary, and with `affine` also to that of the particles inside. */
static void the_particles_inside_have_the_added_rate(void) {
  for (int affine = 0; affine < 2; affine++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              RING "stage s\nboundary strain 0.001 0\naffine strain 0 0.002\n"
                   "servo isotropic 12 on boundary through boundary%s at most 1e-4 per cycle\ncycles 9\n",
              affine ? " affine" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 2);
    const struct nb_tensor free = model->affine->rate[NB_AFFINE_FREE], ring = model->affine->rate[NB_AFFINE_BOUNDARY];
    CU_ASSERT(ring.yy != 0);
    CU_ASSERT_DOUBLE_EQUAL(ring.xx - ring.yy, 0.001, 1e-15); /* the added rate is isotropic */
    CU_ASSERT_DOUBLE_EQUAL(free.xx, affine ? ring.yy : 0, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(free.yy, affine ? ring.yy + 0.002 : 0.002, 1e-15);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A strain rate opposes a servo if it changes a component of the stress that the servo controls. A rotation opposes no
 * servo. */
static void rates_that_oppose(void) {
  static const struct {
    bool controlled[3], mean;
    struct nb_strain_rate rate;
    bool opposes;
  } rows[] = {
      {{true, false, false}, false, {.xx = 1}, true},
      {{true, false, false}, false, {.yy = 1}, false},
      {{false, true, false}, false, {.yy = -1}, true},
      {{false, true, false}, false, {.xx = 1}, false},
      {{false, false, true}, false, {.xy = 1}, true},
      {{false, false, true}, false, {.xy = 1, .yx = 1}, true},
      {{false, false, true}, false, {.xy = 1, .yx = -1}, false},
      {{true, true, false}, true, {.xx = 1, .yy = -1}, false},
      {{true, true, false}, true, {.xx = 1, .yy = 1}, true},
      {{true, true, false}, false, {.xy = 1, .yx = 1}, false},
      {{true, true, true}, false, {.xx = 0}, false},
      {{true, false, false}, false, {.xx = 1e-6}, true}, /* rounding is relative to the largest rate */
      {{true, false, false}, false, {.xx = 1e-4, .yy = 1e6}, false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_servo servo = {.axis_x = {1, 0}, .axis_y = {0, 1}, .mean = rows[k].mean};
    memcpy(servo.controlled, rows[k].controlled, sizeof servo.controlled);
    CU_ASSERT_EQUAL(nb_servo_opposes(&servo, &rows[k].rate), rows[k].opposes);
  }
  /* The axes of the servo are rotated by 30 degrees. An extension along one of them opposes a servo that controls this
   * component, and no servo that controls another one. */
  const double c = cos(asin(0.5)), s = 0.5, along[2][2] = {{c, s}, {-s, c}};
  for (int k = 0; k < 6; k++) {
    const double *n = along[k / 3];
    struct nb_servo servo = {.axis_x = {c, s}, .axis_y = {-s, c}};
    servo.controlled[k % 3] = true;
    const struct nb_strain_rate rate = {.xx = n[0] * n[0], .xy = n[0] * n[1], .yx = n[0] * n[1], .yy = n[1] * n[1]};
    CU_ASSERT_EQUAL(nb_servo_opposes(&servo, &rate), k / 3 == k % 3);
  }
}

/* A condition names each controlled component whose target is not 0, or the mean, with 0.99 of the target. */
static void conditions_near_the_target(void) {
  static const struct {
    const char *servo, *conditions[2]; /* NULL: there is none */
  } rows[] = {{"xx 8 yy 20", {"stress.xx above 7.92", "stress.yy above 19.8"}},
              {"xx 0 yy 20", {"stress.yy above 19.8", NULL}},
              {"yy 20", {"stress.yy above 19.8", NULL}},
              {"xx 0 yy 0 xy 10", {"stress.xy above 9.9", NULL}},
              {"yy 5 xy -10", {"stress.yy above 4.95", "stress.xy below -9.9"}},
              {"isotropic -20", {"stress.xx below -19.8", "stress.yy below -19.8"}},
              {"mean 20", {"stress.mean above 19.8", NULL}},
              {"yy 0.5", {"stress.yy above 0.495", NULL}},
              {"xx 0", {NULL, NULL}},
              {"isotropic 0", {NULL, NULL}}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int region = 0; region < 2; region++) {
      struct words page = {0};
      struct written it;
      const char *const place = region ? "A" : "boundary";
      words_add(&page,
                RING "region A circle 0 0 radius 2\nstage s\nservo %s on %s through boundary at most 1e-4 per cycle\n"
                     "cycles 1\n",
                rows[k].servo, place);
      written_scene(&it, &page);
      for (int unitless = 0; unitless < 2; unitless++) {
        char text[128] = "none", wanted[128] = "";
        for (int c = 0; c < 2 && rows[k].conditions[c]; c++)
          sprintf(wanted + strlen(wanted), "%s%s.%s%s", c ? " and " : "", place, rows[k].conditions[c],
                  unitless ? "" : " Pa");
        CU_ASSERT_EQUAL(nb_servo_condition(text, sizeof text, &it.scene, &it.scene.stages[0].servo, unitless),
                        rows[k].conditions[0] != NULL);
        CU_ASSERT_STRING_EQUAL(text, wanted);
      }
      written_free(&it);
    }
}

void suite_servo(void) {
  CU_pSuite suite = CU_add_suite("servo", NULL, NULL);
  CU_add_test(suite, "the error of the stress is relative to the largest target", the_error_is_relative);
  CU_add_test(suite, "the error of a stress that is not symmetric", the_error_of_a_stress_that_is_not_symmetric);
  CU_ADD_TEST(suite, a_servo_that_was_once_below_its_limit);
  CU_add_test(suite, "the stress follows the recursion to its target", stress_follows_the_recursion);
  CU_add_test(suite, "a ramp is followed", a_ramp_is_followed);
  CU_add_test(suite, "no offset under a dilatation", no_offset_under_a_dilatation);
  CU_add_test(suite, "servo through a cell", servo_through_a_cell);
  CU_add_test(suite, "a servo without shear", a_servo_without_shear);
  CU_add_test(suite, "a servo on a region controls the stress of the region", stress_of_a_region);
  CU_add_test(suite, "servo through boundary affine", servo_through_boundary_affine);
  CU_add_test(suite, "the particles inside have the added rate", the_particles_inside_have_the_added_rate);
  CU_add_test(suite, "rates that oppose a servo", rates_that_oppose);
  CU_ADD_TEST(suite, conditions_near_the_target);
  CU_add_test(suite, "the servo does not count the mass of removed particles", removed_particles_have_no_mass);
  CU_add_test(suite, "components that are not controlled", components_that_are_not_controlled);
  CU_add_test(suite, "isotropic has no shear stress", isotropic_has_no_shear);
  CU_add_test(suite, "the added rate is updated every tenth cycle by default", every_tenth_cycle);
  CU_add_test(suite, "bulk stiffness B and time T of a box", scales_of_a_box);
  CU_ADD_TEST(suite, no_scales_before_the_boundary);
  CU_ADD_TEST(suite, walls_do_not_stiffen_a_boundary);
  CU_ADD_TEST(suite, a_boundary_that_is_held_again);
  CU_add_test(suite, "soft springs give the same motion", soft_springs_give_the_same_motion);
  CU_add_test(suite, "a servo begins at its target, a ramp at the current stress", initial_targets);
}
