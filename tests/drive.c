/* Imposed affine motion and the particles of a boundary, compared with the solution of the equations [R89 4.41-4.44,
 * 6.4.1].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/names.h"
#include "../src/loading/loading.h"
#include "chance.h"
#include "measure/boundary.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double dt = 0.125;

/* Runs a page with these statements. Returns the last value of the quantity `name`. */
static double after(const char *statements, const char *name) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\n%s", statements);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double value = written_last(&result, name);
  nb_result_free(&result);
  written_free(&it);
  return value;
}

#define ONE                                                                                                            \
  "disc 13 -6 radius 1 m velocity 7 5 spin 3\nmonitor D disc 1\nrecord D.x D.y D.vx D.vy D.angle boundary.particles\n"

/* A particle of the boundary moves as x_N - c = (1 + L dt)^N (x_0 - c) to rounding, with the centre c of the circle and
 * any velocity gradient L. Its initial velocity has no effect, and it does not rotate. */
static void the_boundary_follows_exactly(void) {
  const struct nb_tensor rate = tensor(-0.01, 0.03, 0.005, 0.02);
  const char *page = ONE "boundary circle 3 4 radius 14\nstage s\naffine strain 0.3 0.4\n"
                         "boundary strain -0.01 0.02 c12 0.03 c21 0.005\ncycles 200\n";
  struct nb_vec x = vec(10, -10);
  for (int n = 0; n < 200; n++)
    x = vec_add(x, vec_scale(dt, tensor_times(rate, x)));
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.x"), 3 + x.x, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.y"), 4 + x.y, 1e-12);
  CU_ASSERT_EQUAL(after(page, "D.angle"), 0);
  CU_ASSERT_EQUAL(after(page, "boundary.particles"), 1);
  /* The velocity at t_N is the mean of the imposed velocities before and after it. */
  const struct nb_vec before = tensor_times(tensor_inverse(tensor_add(tensor(1, 0, 0, 1), tensor_scale(dt, rate))), x);
  const struct nb_vec v = tensor_times(rate, vec_scale(0.5, vec_add(before, x)));
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.vx"), v.x, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.vy"), v.y, 1e-13);
}

/* The boundary and a particle inside have different velocity gradients. */
static void each_has_its_own_gradient(void) {
  const char *page = ONE "disc 2 6 radius 1 m\nmonitor E disc 2\nrecord E.x E.y\nboundary circle 3 4 radius 14\n"
                         "stage s\naffine strain 0.03 -0.04\nboundary strain -0.01 0.02\ncycles 40\n";
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.x"), 3 + 10 * pow(1 - 0.01 * dt, 40), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.y"), 4 - 10 * pow(1 + 0.02 * dt, 40), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "E.x"), 3 - pow(1 + 0.03 * dt, 40), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "E.y"), 4 + 2 * pow(1 - 0.04 * dt, 40), 1e-12);
}

/* After a stage with a stress, in which the particles of the boundary move freely, a strain holds them again: they move
 * exactly with L, and the ellipse of the boundary is the circle of their mean distance from the centre. Before a
 * boundary is defined, the quantities of the boundary are 0. The boundary has one or four discs. */
static void held_again(int discs) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 5 0 radius 1 m velocity 0.8 0\n%s",
            discs > 1 ? "disc -5 0 radius 1 m velocity 0 0.4\ndisc 0 5 radius 1 m\ndisc 0 -5 radius 1 m\n" : "");
  words_add(&page,
            "monitor D disc 1\nrecord D.x D.y boundary.particles boundary.radius boundary.area boundary.roughness "
            "boundary.stress.xx boundary.stress.xy boundary.stress.yx boundary.stress.yy boundary.stress.residual\n"
            "stage a\ncycles 1\nstage b\nboundary circle 0 0 radius 4.5\nboundary strain 0 0\ncycles 1\n"
            "stage c\nboundary stress 1 2\ncycles 8\nstage d\nboundary strain -0.01 0.02 c12 0.03\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (int s = 0; s < 4; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    for (size_t c = 2; c < it.scene.column_count && s == 0; c++)
      CU_ASSERT_EQUAL(nb_quantity_now(it.scene.columns[c].quantity, model), 0);
    if (s < 3)
      written_cycles(model, (int)it.scene.stages[s].cycles);
  }
  const double radius = written_now(model, "boundary.radius");
  CU_ASSERT_EQUAL(written_now(model, "boundary.particles"), discs);
  CU_ASSERT(fabs(radius - 5) > 0.01);
  CU_ASSERT_DOUBLE_EQUAL(model->boundary->ring.radius, radius, 1e-14);
  const struct nb_tensor rate = tensor(-0.01, 0.03, 0, 0.02);
  struct nb_vec x = vec(written_now(model, "D.x"), written_now(model, "D.y"));
  for (int n = 0; n < 3; n++)
    x = vec_add(x, vec_scale(dt, tensor_times(rate, x)));
  written_cycles(model, 3);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.x"), x.x, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.y"), x.y, 1e-13);
  nb_model_free(model);
  written_free(&it);
}

static void a_boundary_is_held_again(void) { held_again(1), held_again(4); }

/* A new circle is a circle, although the old boundary has been strained to an ellipse: a disc at 5 is outside the radius
 * 4.5, and a disc at 4 is inside. */
static void a_new_boundary_is_not_strained(void) {
  static const char *const rates[] = {"0", "-4", "4"}; /* 1/s, for one step of 1/8 s: sides times 1, 1/2 and 3/2 */
  for (size_t k = 0; k < sizeof rates / sizeof *rates; k++) {
    char page[512];
    snprintf(page, sizeof page,
             "disc 5 0 radius 1 m\ndisc 0 4 radius 1 m\nrecord boundary.particles\nboundary circle 0 0 radius 9\n"
             "stage s\nboundary strain %s %s\ncycles 1\nstage t\nboundary circle 0 0 radius 4.5\n"
             "boundary strain 0 0\ncycles 1\n",
             rates[k], rates[k]);
    CU_ASSERT_EQUAL(after(page, "boundary.particles"), 1);
  }
}

/* Positions are rounded: a disc inside the circle by 1e-13 of its radius is on the circle, one inside by 1e-9 is not. */
static void on_the_circle_but_for_rounding(void) {
  CU_ASSERT_EQUAL(after("disc 4.9999999999995 0 radius 1 m\ndisc 0 4.999999995 radius 1 m\ndisc -5 0 radius 1 m\n"
                        "record boundary.particles\nboundary circle 0 0 radius 5\nstage s\nboundary strain 0 0\n"
                        "cycles 1\n",
                        "boundary.particles"),
                  2);
}

/* A circle that has all particles inside: every quantity of the boundary is 0. */
static void a_boundary_without_particles(void) {
  static const char *const names[] = {"particles", "radius", "area", "roughness", "stress.xx", "stress.residual"};
  for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
    char page[512], name[64];
    snprintf(name, sizeof name, "boundary.%s", names[k]);
    snprintf(page, sizeof page,
             "disc 1 0 radius 1 m\ndisc 2.9 0 radius 1 m\nboundary circle 0 0 radius 9\nrecord %s\n"
             "stage s\nboundary strain 0 0\ncycles 1\n",
             name);
    CU_ASSERT_EQUAL(after(page, name), 0);
  }
}

/* A boundary that begins with the first or the second stage has its particles from this stage on. */
static void a_boundary_that_begins_with_a_stage(void) {
  CU_ASSERT_EQUAL(after("disc 5 0 radius 1 m\ndisc 2 0 radius 1 m\nrecord boundary.particles\nstage a\n"
                        "boundary circle 0 0 radius 4\ncycles 1\nstage b\ncycles 1\n",
                        "boundary.particles"),
                  1);
  CU_ASSERT_EQUAL(after("disc 5 0 radius 1 m\ndisc 2 0 radius 1 m\nrecord boundary.particles\nstage a\ncycles 1\n"
                        "stage b\nboundary circle 0 0 radius 4\ncycles 1\n",
                        "boundary.particles"),
                  1);
}

/* A boundary without particles that is held again keeps its circle: a disc that reaches the circle joins it. */
static void an_empty_boundary_is_held_again(void) {
  const char *const page = "disc 8 0 radius 1 m velocity 1 0\nrecord boundary.particles\nboundary circle 0 0 radius 9\n"
                           "stage a\nboundary strain 0 0\ncycles 1\nstage b\nboundary stress 1 1\ncycles 1\n"
                           "stage c\nboundary strain 0 0\ncycles %d\n";
  for (int n = 5; n <= 9; n += 4) { /* the disc has moved by 7/8, or by 11/8 */
    char text[512];
    snprintf(text, sizeof text, page, n);
    CU_ASSERT_EQUAL(after(text, "boundary.particles"), n == 9);
  }
}

/* `per cycle` gives the strain of one cycle, whatever the step, in later stages too. */
static void per_cycle(void) {
  const char *page = ONE "boundary circle 3 4 radius 14\nstage s\nboundary strain -0.01 per cycle 0.02 per cycle\n"
                         "cycles 3\nstage t\nstep 0.5\ncycles 2\n";
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.x"), 3 + 10 * pow(0.99, 5), 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.y"), 4 - 10 * pow(1.02, 5), 1e-14);
}

/* Under `affine strain` the particle keeps its own velocity v, and damping by the factor lambda = 0.9 acts only on v:
 * x_(N+1) = (1 + L dt) x_N + lambda^(N+1) v dt. */
static void damping_acts_on_own_velocity(void) {
  const char *page = ONE "damping con1 0.9 as velocity\nstage s\naffine strain -0.02 0.04 shear 0.01\ncycles 50\n";
  struct nb_vec x = vec(13, -6), v = vec(7, 5);
  for (int n = 0; n < 50; n++) {
    v = vec_scale(0.9, v);
    x = vec_add(x, vec_scale(dt, vec_add(v, vec(-0.02 * x.x + 0.01 * x.y, 0.01 * x.x + 0.04 * x.y))));
  }
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.x"), x.x, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.y"), x.y, 1e-12);
  /* `affine none` in the second stage does not change v. */
  const char *left = ONE "stage s\naffine strain -0.02 0.04\ncycles 50\nstage t\naffine none\ncycles 1\n";
  CU_ASSERT_DOUBLE_EQUAL(after(left, "D.vx"), 7, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(after(left, "D.vy"), 5, 1e-13);
}

/* `accumulated`, as R89 codes the equations: x_(N+1) - (2 + L dt) x_N + x_(N-1) = 0, with the solution x_N = x_0
 * (sinh((N + 1) q) - sinh(N q))/sinh(q), cosh q = 1 + L dt/2. A particle of a boundary with the same strain rate does
 * not accumulate. */
static void accumulated_strain_grows(void) {
  const char *page = "disc 13 -6 radius 1 m\nmonitor D disc 1\nrecord D.x D.y\nstage s\n"
                     "affine strain 0.008 -0.016 accumulated\ncycles 100\n";
  const double q = acosh(1 + 0.008 * dt / 2), p = acos(1 - 0.016 * dt / 2);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.x"), 13 * (sinh(101 * q) - sinh(100 * q)) / sinh(q), 1e-9);
  CU_ASSERT_DOUBLE_EQUAL(after(page, "D.y"), -6 * (sin(101 * p) - sin(100 * p)) / sin(p), 1e-9);
  const char *both = "disc 13 -6 radius 1 m\ndisc 30 0 radius 1 m\nmonitor D disc 1\nmonitor E disc 2\nrecord D.x E.x\n"
                     "boundary circle 0 0 radius 25\nstage s\naffine strain 0.008 -0.016 accumulated\n"
                     "boundary strain 0.008 -0.016\ncycles 20\n";
  CU_ASSERT_DOUBLE_EQUAL(after(both, "D.x"), 13 * (sinh(21 * q) - sinh(20 * q)) / sinh(q), 1e-9);
  CU_ASSERT_DOUBLE_EQUAL(after(both, "E.x"), 30 * pow(1 + 0.008 * dt, 20), 1e-9);
}

/* Dashpots between two particles without own velocities, under imposed affine motion, have the relative velocity L z,
 * where z is the vector between the centres. Their forces are beta k_n e.L z and beta k_s t.L z [R89 4.42]. */
static void dashpots_see_the_strain(void) {
  static const char *const pairs[] = {"stage s\naffine strain -0.3 0.1 shear 0.2\n",
                                      "boundary circle 1 2 radius 3\nstage s\naffine strain -0.3 0.1 shear 0.2\n"
                                      "boundary strain -0.3 0.1 shear 0.2\n"};
  for (size_t k = 0; k < 2; k++) { /* both with affine motion; one of them in the boundary */
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 100 ks 60 friction 1e9\nshear linear\nstep 1e-8\n"
              "damping stiffness 0.5\ndisc 2 3 radius 1 m\ndisc 3.5 4 radius 1 m\nmonitor P disc 1 with disc 2\n"
              "record P.dashpot.normal P.dashpot.shear boundary.particles\n%scycles 1\n",
              pairs[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double length = hypot(1.5, 1), ex = 1.5 / length, ey = 1 / length;
    const double vx = -0.3 * 1.5 + 0.2 * 1, vy = 0.2 * 1.5 + 0.1 * 1; /* of the second particle relative to the first */
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "P.dashpot.normal"), -0.5 * 100 * (vx * ex + vy * ey), 1e-5);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "P.dashpot.shear"), -0.5 * 60 * (vx * ey - vy * ex), 1e-5);
    CU_ASSERT_EQUAL(written_last(&result, "boundary.particles"), (double)k);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A circle shrinks to a fifth of its size. A disc joins it in the first cycle that begins with the centre of the disc
 * on the circle or outside. This cycle must not depend on the size of the circle at the last search. So a search must
 * list the discs that are closer than the skin to the circle at its present size. */
static void a_circle_that_has_shrunk_takes_in_a_disc(void) {
  enum { SHRINKS = 160, RESTS = 200 };
  for (int s = 0; s < 10; s++) {
    const double skin = 0.5 + 0.05 * s;
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 2 kn 100\nstep 0.125\nskin %g\ndisc 30 0 radius 1 m\n"
              "disc 0 -6 radius 1 m velocity 0 0.3\nrecord boundary.particles\nboundary circle 0 0 radius 20\n"
              "stage s\nboundary strain -0.08 -0.08\ncycles %d\nstage t\nboundary fixed\ncycles %d\n",
              skin, SHRINKS, RESTS);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    double y = -6, radius = 20;
    int n = 0; /* whole cycles after which the disc has reached the circle */
    for (; fabs(y) < radius; n++)
      y += 0.3 * dt, radius *= n < SHRINKS ? 1 - 0.08 * dt : 1;
    CU_ASSERT_FATAL(n > SHRINKS && n < SHRINKS + RESTS);
    CU_ASSERT_EQUAL(result.table.values[n], 1);
    CU_ASSERT_EQUAL(result.table.values[n + 1], 2);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The ellipse reaches discs at rest. The discs do not move, so no search lists again the discs near the boundary. The
 * boundary must list them itself when the ellipse has moved. Half the height of the ellipse is 20 (1 - 0.01 dt)^n after
 * n cycles. */
static void discs_at_rest_join_the_boundary(void) {
  static const char *const skins[] = {"", "skin 0.01\n", "skin 0.5\n"};
  for (size_t k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 2 kn 100\nstep 0.125\n%sdisc 30 0 radius 1 m\ndisc 0 15 radius 1 m\n"
              "disc 0 -12 radius 1 m\nrecord boundary.particles\nboundary circle 0 0 radius 20\nstage s\n"
              "boundary strain 0 -0.01\ncycles 500\n",
              skins[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    int n15 = 0, n12 = 0; /* whole cycles after which the ellipse has reached each disc */
    for (double b = 20; b > 15; n15++)
      b *= 1 - 0.01 * dt;
    for (double b = 20; b > 12; n12++)
      b *= 1 - 0.01 * dt;
    const double *members = result.table.values;
    CU_ASSERT_EQUAL_FATAL(result.table.column_count, 1);
    CU_ASSERT_EQUAL_FATAL(result.table.row_count, 501);
    for (int n = 0; n <= 500; n++)
      CU_ASSERT_EQUAL(members[n], 1 + (n > n15) + (n > n12));
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Four discs on the axes. The boundary lists them in their order round the centre, whatever their numbers and the size
 * of the boundary are, so its area is that of a square. */
static void any_order_of_numbers(void) {
  static const double at[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int order = 0; order < 768; order++) {
    const double size = order < 256 ? 5 : order < 512 ? 0.5 : 1;
    const int k[4] = {order & 3, order >> 2 & 3, order >> 4 & 3, order >> 6 & 3};
    if ((1 << k[0] | 1 << k[1] | 1 << k[2] | 1 << k[3]) != 15)
      continue;
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\n");
    for (int n = 0; n < 4; n++)
      words_add(&page, "disc %g %g radius 0.1 m\n", size * at[k[n]][0], size * at[k[n]][1]);
    words_add(&page, "record boundary.area\nboundary circle 0 0 radius %g\nstage s\nboundary fixed\ncycles 1\n", size);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(written_now(model, "boundary.area"), 2 * size * size);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Of the distances 5, 6, 5 and 8 the mean is 6, and the standard deviation is (3/2)^(1/2). Divided by the mean, it does
 * not depend on the size of the boundary. */
static void roughness_is_relative(void) {
  for (double size = 1; size < 9; size *= 2) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc %g 0 radius 0.1 m\ndisc 0 %g radius 0.1 m\n"
              "disc -%g 0 radius 0.1 m\ndisc 0 -%g radius 0.1 m\nrecord boundary.roughness boundary.radius\n"
              "boundary circle 0 0 radius %g\nstage s\nboundary fixed\ncycles 1\n",
              5 * size, 6 * size, 5 * size, 8 * size, 5 * size);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "boundary.radius"), 6 * size, 1e-14 * size);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "boundary.roughness"), sqrt(1.5) / 6, 1e-15);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A disc that moves outwards belongs to the boundary from the first cycle that begins with its centre on the circle
 * or outside, whatever the skin is; meanwhile the circle becomes an ellipse. */
static void particles_join_the_boundary(void) {
  static const char *const skins[] = {"skin 0.01\n", "skin 0.5\n", "skin 40\n"};
  for (size_t s = 0; s < 3; s++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 2 kn 100\nstep 0.125\n%sdisc 30 0 radius 1 m\ndisc 1 2 radius 1 m velocity 0.3 "
        "0.4\nmonitor D disc 2\nrecord cycle D.x D.y D.vx.half boundary.particles boundary.radius\n"
        "boundary circle 0 0 radius 20\nstage s\nboundary strain 0.001 -0.01\ncycles 1000\n",
        skins[s]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    double x = 1, y = 2, a = 20, b = 20;
    int n = 0;
    for (; x * x / (a * a) + y * y / (b * b) < 1; n++)
      x += 0.3 * dt, y += 0.4 * dt, a *= 1 + 0.001 * dt, b *= 1 - 0.01 * dt;
    const double *row = result.table.values + (size_t)n * result.table.column_count;
    CU_ASSERT_EQUAL(row[4], 1);
    CU_ASSERT_DOUBLE_EQUAL(row[2], y, 1e-12);
    row += result.table.column_count;
    CU_ASSERT_EQUAL(row[4], 2);
    CU_ASSERT_DOUBLE_EQUAL(row[3], 0.001 * x, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(row[2], y * (1 - 0.01 * dt), 1e-12);
    CU_ASSERT(n > 100 && n < 900);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A disc that moves outwards also joins the boundary if it is the only particle of a scene without walls. Such a scene
 * needs no search for contacts. */
static void the_only_particle_joins_the_boundary(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 0 0 radius 1 m velocity 8 0\n"
                   "record boundary.particles\nboundary circle 0 0 radius 4.5\nstage s\nboundary fixed\ncycles 9\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t n = 0; n <= 9; n++) /* the cycle that begins at x = 5 is the sixth one */
    CU_ASSERT_EQUAL(written_cell(&result.table, n, "boundary.particles"), n > 5 ? 1 : 0);
  nb_result_free(&result);
  written_free(&it);
}

/* The circle shrinks by the factor 1 - 0.01 dt in each cycle. A disc at rest belongs to the boundary from the first
 * cycle that begins with the disc on the circle or outside. The step doubles with stage b. Each disc lies halfway
 * between the circles of two successive cycles. */
static void a_shrinking_circle_takes_in_discs_at_rest(void) {
  enum { CYCLES = 8, CHANGE = 4 };
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\nboundary circle 0 0 radius 20\n");
  double circle = 20;
  for (int n = 0; n < CYCLES; n++) { /* disc n is inside circle n and outside circle n + 1 */
    const double next = circle * (1 - 0.01 * dt * (n < CHANGE ? 1 : 2)), between = (circle + next) / 2;
    words_add(&page, "disc %.17g %.17g radius 1 m\n", between * cos(0.7 * n), between * sin(0.7 * n));
    circle = next;
  }
  words_add(&page,
            "record boundary.particles\nstage a\nboundary strain -0.01 -0.01\ncycles %d\nstage b\nstep 0.25\n"
            "cycles %d\n",
            CHANGE, CYCLES - CHANGE);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t n = 0; n <= CYCLES; n++) /* the disc that the circle passes in cycle n joins at the next cycle */
    CU_ASSERT_EQUAL(written_cell(&result.table, n, "boundary.particles"), n > 0 ? (double)n - 1 : 0);
  nb_result_free(&result);
  written_free(&it);
}

/* Two particles press each other inside a boundary that they do not touch, at the beginning. So the stress of the
 * boundary is 0, and its difference from the stress of the contacts is k d l/(A h), with the overlap d, the distance l
 * of the centres, the area A and the thickness h. The result depends on the size L of the scene through h only. */
static void contacts_that_do_not_press_on_the_boundary(void) {
  static const double sizes[] = {1, 0.01};
  for (int k = 0; k < 4; k++) {
    const double size = sizes[k / 2];
    const bool sphere = k % 2;
    const char *const kind = sphere ? "sphere" : "disc";
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 1e-6\nrecord boundary.stress.residual\n");
    for (int n = 0; n < 4; n++)
      words_add(&page, "%s %g %g radius %g m\n", kind, 5 * size * (n % 2 ? 0 : n - 1), 5 * size * (n % 2 ? n - 2 : 0),
                size);
    words_add(&page, "%s %g 0 radius %g m\n%s %g 0 radius %g m\nboundary circle 0 0 radius %g\nstage s\n", kind,
              -0.95 * size, size, kind, 0.95 * size, size, 5 * size);
    words_add(&page, "boundary fixed\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const double thickness = sphere ? 2 * size : 1, wanted = 100 * 0.1 * 1.9 / 50 / thickness;
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "boundary.stress.residual"), wanted, 1e-12 * wanted);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stress on a new boundary acts on the particles of the new boundary only. A square of discs at the distance 9 from
 * the centre surrounds a square at the distance 5. The first circle includes both squares, the second one only the outer
 * square. The force on each disc of the outer square is then the stress times the distance, and on each other disc 0. For
 * spheres the force is the thickness, their diameter 2, times as large. */
static void own_forces_of_a_new_boundary(const char *kind, double thickness) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\n");
  for (int n = 0; n < 8; n++) {
    const double x = n < 4 ? 5 : 9, along = n % 2 ? -x : x;
    words_add(&page, "%s %g %g radius 1 m\n", kind, n / 2 % 2 ? 0 : along, n / 2 % 2 ? along : 0);
  }
  words_add(&page, "record cycle\nstage a\nboundary circle 0 0 radius 4.9\nboundary stress 3 3\ncycles 1\n"
                   "stage b\nboundary circle 0 0 radius 8\nboundary stress 3 3\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int n = 0; n < 4; n++)
    CU_ASSERT(vec_length(model->boundary->boundary_force[model->particles.slot[n]]) > 1);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  for (int n = 0; n < 8; n++) {
    const struct nb_vec force = model->boundary->boundary_force[model->particles.slot[n]];
    CU_ASSERT_DOUBLE_EQUAL(vec_length(force), n < 4 ? 0 : 3 * 9 * thickness, 1e-12);
  }
  nb_model_free(model);
  written_free(&it);
}

static void a_new_boundary_has_its_own_forces(void) {
  own_forces_of_a_new_boundary("disc", 1), own_forces_of_a_new_boundary("sphere", 2);
}

/* Four discs without contacts on a circle, at rest. A stress s presses each of them towards the centre with the force s
 * x, where x is its distance from the centre: the part of the square's sides that belongs to it has the width x across
 * its axis. The stress acts from t_0 to t_1, for one step. So x_1 = x_0 - s x_0/m dt^2/2, and the velocity after t_1 is
 * v = -s (x_0 + x_1)/m dt/2. */
static void a_stress_begins_and_ends_at_once(void) {
  const double pi = 3.14159265358979323846, rate = 3 / (2 * pi); /* s/m, 1/s2 */
  const double x1 = 5 - 5 * rate * dt * dt / 2, v = -rate * (5 + x1) * dt / 2;
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 5 0 radius 1 m\ndisc 0 5 radius 1 m\n"
                   "disc -5 0 radius 1 m\ndisc 0 -5 radius 1 m\nmonitor D disc 1\nrecord D.x\n"
                   "boundary circle 0 0 radius 4.9\nstage wait\nboundary fixed\ncycles 1\n"
                   "stage press\nboundary stress 3 3\ncycles 1\nstage fly\nboundary none\ncycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double x[] = {5, 5, x1, x1 + v * dt, x1 + 2 * v * dt, x1 + 3 * v * dt};
  for (size_t row = 0; row < 6; row++)
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "D.x"), x[row], 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* A stress stays until a stage ends it: two stages of one cycle are the same as one stage of two cycles. It causes no
 * rotation. */
static void a_stress_stays(void) {
  double x[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 5 0 radius 1 m spin 0.5\n"
                     "disc 0 5 radius 1 m\ndisc -5 0 radius 1 m\ndisc 0 -5 radius 1 m\nmonitor D disc 1\n"
                     "record D.x D.spin\nstage wait\nboundary circle 0 0 radius 4.9\nboundary fixed\ncycles 1\nstage "
                     "a\nboundary stress 3 3\ncycles ");
    words_add(&page, k ? "1\nstage b\ncycles 1\n" : "2\n");
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    x[k] = written_last(&result, "D.x");
    CU_ASSERT_EQUAL(written_last(&result, "D.spin"), 0); /* as of a particle that belongs to a boundary */
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT(x[0] < 5);
  CU_ASSERT_EQUAL(x[0], x[1]);
}

/* A disc at rest near the boundary is a candidate, but it does not join. So it causes no search. */
static void a_candidate_causes_no_search(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 5 0 radius 1 m\ndisc 0 4.9 radius 1 m\n"
                   "skin 0.5\nboundary circle 0 0 radius 5\nrecord cycle\nstage a\nboundary fixed\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const unsigned long before = model->search.count;
  written_cycles(model, 9);
  CU_ASSERT_EQUAL(model->boundary->ring.candidate_count, 1);
  CU_ASSERT_EQUAL(model->search.count, before);
  nb_model_free(model);
  written_free(&it);
}

/* Particles of a boundary may overlap by more than a radius as long as the boundary holds them. If a stage releases
 * them, it does not begin. */
static void released_too_deep(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 2 kn 100\nstep 0.125\ndisc 1 0 radius 1 m\ndisc -1 0 radius 1 m\n"
                   "boundary circle 0 0 radius 0.5\nrecord boundary.radius\nstage a\nboundary strain -1 0\ncycles 9\n"
                   "stage b\nboundary none\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 9);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_BROKEN);
  nb_model_free(model);
  written_free(&it);
}

/* The members of a boundary are in the order of their angles from the x axis, counterclockwise, whatever their numbers
 * are. Here disc n is at 30 degrees times n * stride; four discs are exactly on the axes. */
static void members_are_counterclockwise(void) {
  static const int strides[] = {1, 5, 7, 11};
  static const double half = 0.5, root = 0.86602540378443865;
  const double c[] = {1, root, half, 0, -half, -root, -1, -root, -half, 0, half, root};
  for (size_t s = 0; s < sizeof strides / sizeof *strides; s++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.1\nrecord cycle\n");
    for (int n = 0; n < 12; n++)
      words_add(&page, "disc %.17g %.17g radius 0.1 m\n", 5 * c[n * strides[s] % 12], 5 * c[(n * strides[s] + 9) % 12]);
    words_add(&page, "boundary circle 0 0 radius 4.9\nstage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const struct nb_ring *ring = &model->boundary->ring;
    CU_ASSERT_EQUAL_FATAL(ring->count, 12);
    for (int k = 0; k < 12; k++)
      CU_ASSERT_EQUAL((model->particles.number[ring->member[k]] - 1) * strides[s] % 12, k);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Members at the same angle are in the order of their numbers. */
static void members_at_the_same_angle(void) {
  for (int outer = 1; outer <= 2; outer++) { /* the number of the outer one of two discs */
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\nstep 0.1\nrecord cycle\ndisc 0 %d radius 0.1 m\ndisc 0 %d radius "
              "0.1 m\nboundary circle 0 0 radius 4\nstage s\ncycles 1\n",
              outer == 1 ? 6 : 5, outer == 2 ? 6 : 5);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const struct nb_ring *ring = &model->boundary->ring;
    CU_ASSERT_EQUAL_FATAL(ring->count, 2);
    for (int k = 0; k < 2; k++)
      CU_ASSERT_EQUAL(model->particles.number[ring->member[k]], k + 1);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The particles of a boundary that ends can move again. They rotate unless the stage has `rotation off`. */
static void an_ended_boundary_is_free(void) {
  for (int off = 0; off < 2; off++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 2 kn 100\ndisc 5 0 radius 1 m\ndisc 0 0 radius 2 m\n"
              "boundary circle 0 0 radius 4\nstep 0.01\nrecord cycle\nstage a\nboundary fixed\n%scycles 1\n"
              "stage b\nboundary none\ncycles 1\n",
              off ? "rotation off\n" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const struct nb_particles *particles = &model->particles;
    for (int s = 0; s < 2; s++) {
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      for (size_t i = 0; i < 2; i++) {
        const bool held = s == 0 && i == 0;
        CU_ASSERT_EQUAL(particles->inverse_mass[i], held ? 0 : 1 / particles->mass[i]);
        CU_ASSERT_EQUAL(particles->inverse_inertia[i], held || off ? 0 : 1 / particles->inertia[i]);
      }
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stress s on the boundary causes forces F with sum F_i x_j = -s_ij A h (boundary.c), here h = 1 and s is symmetric. */
static void forces_of_a_boundary_stress(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 1e-3\ndisc 5 1 radius 1 m\ndisc -3 4 radius 1 m\n"
                   "disc -4 -3 radius 1 m\ndisc 1 -6 radius 1 m\nboundary circle 0 0 radius 4\nrecord boundary.area\n"
                   "stage s\nboundary stress 7 3 shear 2\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const double area = written_now(model, "boundary.area");
  struct nb_tensor sum = {0, 0, 0, 0};
  for (size_t i = 0; i < 4; i++)
    sum = tensor_add(sum, tensor_outer(model->particles.boundary_force[i], model->particles.position[i]));
  CU_ASSERT_DOUBLE_EQUAL(sum.xx, -7 * area, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(sum.xy, -2 * area, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(sum.yx, -2 * area, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(sum.yy, -3 * area, 1e-12);
  nb_model_free(model);
  written_free(&it);
}

/* The stress from all contacts is that of contacts between particles: a free particle on a wall does not change
 * boundary.stress.residual. Each force calculation counts the listed contacts, also those with walls. */
static void contacts_with_walls_are_no_stress(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1e9 kn 100\nstep 1e-3\ndisc 5 1 radius 1 m\ndisc -3 4 radius 1 m\n"
            "disc -4 -3 radius 1 m\ndisc 0 0 radius 1 m\nwall v -1 -0.9 to 1 -0.9 m\nboundary circle 0 0 radius 4\n"
            "record boundary.stress.residual contacts\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "contacts"), 1);
  CU_ASSERT_EQUAL(written_now(model, "boundary.stress.residual"), 0);
  const unsigned long long before = model->updates;
  written_cycles(model, 3);
  CU_ASSERT_EQUAL(model->updates - before, 3);
  nb_model_free(model);
  written_free(&it);
}

/* A new circle frees the only particle, which is then inside. It falls in x and joins the boundary again when it reaches
 * the new circle. */
static void the_only_particle_joins_again(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\nstep 0.01\ndisc 5 0 radius 1 m\nboundary circle 0 0 radius 4\n"
            "monitor D disc 1\nrecord boundary.particles D.x\nstage a\ncycles 9\nstage b\n"
            "boundary circle 0 0 radius 6\ngravity 1 0\ncycles 400\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(written_last(&result, "boundary.particles"), 1);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.x"), 6, 0.03); /* it moves by up to 0.015 in a cycle */
  nb_result_free(&result);
  written_free(&it);
}

/* A servo of xx and yy in a cell adds no shear rate, although there is a shear stress. */
static void components_without_a_servo(void) {
  static const char *const servos[] = {"xx 1 yy 2", "xy 1"};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 100\nstep 1e-3\ndisc 3 3 radius 1 m\ndisc 4.5 4 radius 1 m\n"
        "periodic cell 0 0 to 9 9\nrecord cell.stress.xy\nstage s\nservo %s on cell through cell at most 1e-4 per "
        "cycle\ncycles 1\n",
        servos[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    const struct nb_tensor rate = model->affine->rate[NB_AFFINE_CELL];
    CU_ASSERT(fabs(written_now(model, "cell.stress.xy")) > 0.01);
    CU_ASSERT((rate.xx != 0) == (k == 0) && (rate.yy != 0) == (k == 0));
    CU_ASSERT((rate.xy != 0) == (k == 1) && rate.yx == rate.xy);
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_drive(void) {
  CU_pSuite suite = CU_add_suite("drive", NULL, NULL);
  CU_add_test(suite, "the boundary and a particle inside have their own gradients", each_has_its_own_gradient);
  CU_add_test(suite, "a boundary is held again", a_boundary_is_held_again);
  CU_add_test(suite, "a new boundary is not strained", a_new_boundary_is_not_strained);
  CU_ADD_TEST(suite, on_the_circle_but_for_rounding);
  CU_add_test(suite, "a boundary without particles", a_boundary_without_particles);
  CU_add_test(suite, "a boundary that begins with a stage", a_boundary_that_begins_with_a_stage);
  CU_add_test(suite, "a boundary without particles is held again", an_empty_boundary_is_held_again);
  CU_add_test(suite, "discs at rest join the boundary", discs_at_rest_join_the_boundary);
  CU_add_test(suite, "a circle that has shrunk takes in a disc", a_circle_that_has_shrunk_takes_in_a_disc);
  CU_add_test(suite, "a boundary with any order of numbers", any_order_of_numbers);
  CU_add_test(suite, "the roughness of a boundary is relative", roughness_is_relative);
  CU_add_test(suite, "the boundary follows exactly", the_boundary_follows_exactly);
  CU_add_test(suite, "a strain per cycle does not depend on the step", per_cycle);
  CU_add_test(suite, "damping does not act on the imposed velocity", damping_acts_on_own_velocity);
  CU_add_test(suite, "accumulated affine strain grows", accumulated_strain_grows);
  CU_add_test(suite, "dashpot forces include the imposed velocity", dashpots_see_the_strain);
  CU_add_test(suite, "particles that reach the boundary join it", particles_join_the_boundary);
  CU_ADD_TEST(suite, the_only_particle_joins_the_boundary);
  CU_add_test(suite, "a shrinking circle takes in discs at rest", a_shrinking_circle_takes_in_discs_at_rest);
  CU_add_test(suite, "contacts that do not press on the boundary", contacts_that_do_not_press_on_the_boundary);
  CU_add_test(suite, "a new boundary has its own forces", a_new_boundary_has_its_own_forces);
  CU_ADD_TEST(suite, a_stress_begins_and_ends_at_once);
  CU_ADD_TEST(suite, a_stress_stays);
  CU_ADD_TEST(suite, a_candidate_causes_no_search);
  CU_ADD_TEST(suite, released_too_deep);
  CU_ADD_TEST(suite, members_are_counterclockwise);
  CU_ADD_TEST(suite, members_at_the_same_angle);
  CU_ADD_TEST(suite, an_ended_boundary_is_free);
  CU_ADD_TEST(suite, forces_of_a_boundary_stress);
  CU_ADD_TEST(suite, contacts_with_walls_are_no_stress);
  CU_ADD_TEST(suite, the_only_particle_joins_again);
  CU_ADD_TEST(suite, components_without_a_servo);
}
