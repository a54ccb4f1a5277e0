/* FRACC as R89 defines it, compared with hand calculations: for one particle, for the largest of several, and for a
 * force that rotates. [R89 4.35-4.40]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* [R89 4.36-4.40] as printed: |SF|, the magnitude of the force sum, before and after a step, and the velocity in it. */
static double by_hand(double mass, double dt, double before, double after, double vx, double vy) {
  const double way = hypot(vx, vy) * dt, critical = 2 * sqrt(mass * way / fabs(after - before));
  return dt / critical;
}

/* Disc A of mass 1 slides on a floor with k_n = 1, disc B of mass 4 stands on it with k_n = 2. Gravity acts on both; it
 * is not a contact force. Forces are k_n times the overlap. The first change of the velocity is that of half a step;
 * between two different steps it is that of their mean.
 *
 *       t       A: v_y        y          |SF|         B: v_y       y            |SF|
 *       0                 0.9         0.1                   0.75           0.5
 *       0.5   -0.1        0.85        0.15         0.00625      0.753125       0.49375
 *       1     -0.275      0.7125      0.2875      -0.18203125   0.662109375    0.67578125
 *       1.5   -0.38125    0.521875    0.478125    -0.34755859375
 *       1.75  -0.389453125  0.42451171875  0.57548828125
 *
 * B moves along its spring, so K = |dSF|/dx is k_n and FRACC = (dt/2) (k_n/M)^(1/2). The FRACC of B exceeds that of A
 * in the first step only. */
static void as_defined(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial light density 0.31830988618379067 kn 1\n"
                   "material heavy density 1.2732395447351628 kn 1\npair heavy light kn 2\ngravity 0 -0.5\n"
                   "wall floor -9 0 to 9 0 light\ndisc -4 0.9 radius 1 light velocity 0.3 0\n"
                   "disc 4 0.75 radius 1 heavy velocity 0 0.1\ndisc 0 4 radius 1 light fixed\n"
                   "step 0.5\nallow unstable\nrecord step.fracc\nstage a\ncycles 3\nstage b\nstep 0.25\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "step.fracc"), 0);
  const double light[] = {by_hand(1, 0.5, 0.1, 0.15, 0.3, -0.1), by_hand(1, 0.5, 0.15, 0.2875, 0.3, -0.275),
                          by_hand(1, 0.5, 0.2875, 0.478125, 0.3, -0.38125),
                          by_hand(1, 0.25, 0.478125, 0.57548828125, 0.3, -0.389453125)};
  const double heavy[] = {by_hand(4, 0.5, 0.5, 0.49375, 0, 0.00625),
                          by_hand(4, 0.5, 0.49375, 0.67578125, 0, -0.18203125), 0.25 * sqrt(0.5), 0.125 * sqrt(0.5)};
  NEAR(heavy[0], 0.25 * sqrt(0.5), 1e-13);
  NEAR(heavy[1], 0.25 * sqrt(0.5), 1e-13);
  for (int n = 0; n < 4; n++) {
    if (n % 3 == 0)
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[n / 3], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT((heavy[n] > light[n]) == (n == 0));
    NEAR(written_now(model, "step.fracc"), fmax(light[n], heavy[n]), 1e-12);
  }
  nb_model_free(model);
  written_free(&it);
}

/* In the step in which a disc at rest is hit, its force sum changes but it does not move, so it has no FRACC; the disc
 * that hits it has one. The moving disc has the speed 1, and the overlap is 0.02 after the first step, so dSF = 0.02
 * k_n. In the second step the overlap grows by 0.03 minus the distance by which the force moves the discs apart. */
static void no_displacement_no_fracc(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 0.31830988618379067 kn 1\ndisc 0 0 radius 1 m velocity 1 0\n"
                   "disc 2.01 0 radius 1 m\nstep 0.03\nrecord step.fracc\nstage s\ncycles 2\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 1);
  NEAR(written_now(model, "step.fracc"), by_hand(1, 0.03, 0, 0.02, 1, 0), 1e-12);
  /* F dt/M = 6e-4 for each: they approach at 1 - 12e-4; the disc that was hit moves at 6e-4. */
  written_cycles(model, 1);
  NEAR(written_now(model, "step.fracc"), by_hand(1, 0.03, 0.02, 0.02 + 0.03 * (1 - 12e-4), 6e-4, 0), 1e-11);
  nb_model_free(model);
  written_free(&it);
}

/* A disc in a box that presses on it from four sides, F = -2 k_n r. On the circular orbit of the scheme, x_n = r
 * cos(n phi) and y_n = r sin(n phi) with sin(phi/2) = h = w dt/2, the force rotates with constant magnitude. With
 * the change of the force as a vector FRACC would be h in every step. With the change of its magnitude FRACC is the
 * square root of a rounding error, an ulp of the coordinates over r. */
static void a_force_that_rotates_does_not_count(void) {
  static const double shares[] = {0.1, 0.5, 0.9, 0.999};
  for (int k = 0; k < 4; k++) {
    const double h = shares[k], dt = h * sqrt(2), r = 1e-3, phi = 2 * asin(h); /* w^2 = 2 k_n/m = 2 */
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 0.31830988618379067 kn 1\nbox -0.9 -0.9 to 0.9 0.9 m\n"
              "disc %.17g 0 radius 1 m velocity 0 %.17g\nmonitor D disc 1\nstep %.17g\nallow unstable\n"
              "record step.fracc D.x D.y D.vx.half D.vy.half\nstage s\ncycles 100\n",
              r, r * sin(phi) / dt, dt);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    for (int n = 1; n <= 100; n++) {
      written_cycles(model, 1);
      CU_ASSERT(fabs(written_now(model, "D.x") - r * cos(n * phi)) < 1e-9 * r);
      CU_ASSERT(fabs(written_now(model, "D.y") - r * sin(n * phi)) < 1e-9 * r);
      CU_ASSERT(written_now(model, "step.fracc") < 1e-5 * h);
      const double vx = written_now(model, "D.vx.half"), vy = written_now(model, "D.vy.half");
      const double change = 2 * hypot(vx, vy) * dt; /* |dF| of the vector */
      NEAR(by_hand(1, dt, 0, change, vx, vy), h, 1e-9);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_fracc(void) {
  CU_pSuite suite = CU_add_suite("fracc", NULL, NULL);
  CU_add_test(suite, "FRACC as R89 defines it", as_defined);
  CU_add_test(suite, "no displacement, no FRACC", no_displacement_no_fracc);
  CU_add_test(suite, "a force that rotates does not count", a_force_that_rotates_does_not_count);
}
