/* The time step of a page relative to a limit, and the stability check that stops a run whose step is above the
 * limit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "measure/step.h"
#include "run/plan.h"
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

static void a_step_relative_to_a_limit(void) {
  /* omega^2 = 2 k/m = 16 */
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 m\nstep 50 % of stable\n"), 0.25, 1e-15);
  /* the pair with the shorter stable step counts, even if the steps of two pairs differ by a 2000th only */
  NEAR(step_of(PAIR "material h density 0.31830988618379067 kn 8.008\nlattice discs 2 by 1 radius 1 m\n"
                    "lattice discs 2 by 1 from 0 9 radius 1 h\nstep 0.5 of stable\n"),
       0.25 / sqrt(1.001), 1e-15);
  /* pairs within the skin count; particles far apart count as if they touched, and so does a wall */
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 spacing 2.09 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "lattice discs 2 by 1 radius 1 spacing 5 m\nstep 0.5 of stable\n"), 0.25, 1e-15);
  NEAR(step_of(PAIR "disc 0 5 radius 1 m\nwall w -3 0 to 3 0 m\nstep 0.5 of stable\n"), sqrt(0.125), 1e-15);
  /* pi sqrt(M/k) with the reduced mass M: two equal masses; a light and a heavy one; the lightest two of several; at a
   * wall */
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
  /* a lighter particle of another material does not count for the pair of m and the wall */
  NEAR(step_of(PAIR
               "material b density 0.01 kn 8\npair m b kn 1e-6\npair b b kn 1e-6\nmaterial s kn 8\npair b s kn 1e-6\n"
               "disc 0 5 radius 1 m\ndisc 9 5 radius 1 b\nwall w -3 0 to 3 0 s\nstep 1 of collision\n"),
       pi / sqrt(8), 1e-15);
  /* a single particle is no pair */
  NEAR(step_of(PAIR
               "material s kn 8\npair m s kn 1e-4\ndisc 0 5 radius 1 m\nwall w -3 0 to 3 0 s\nstep 1 of collision\n"),
       pi * 100, 1e-15);
  /* the single-contact step and the duration of a collision of very soft springs */
  NEAR(step_of("units none\nmaterial m density 0.31830988618379067 kn 1e-4\ndisc 0 0 radius 1 m\nstep 0.5 of "
               "single-contact\n"),
       100., 1e-15);
  NEAR(step_of("units none\nmaterial m density 0.31830988618379067 kn 1e-4\nlattice discs 2 by 1 radius 1 m\nstep 1 of "
               "collision\n"),
       pi * sqrt(0.5e4), 1e-15);
}

/* The lightest particle of each material of a pair; of equally light ones that with the smallest number. One particle
 * cannot be both. A fixed particle counts only if there is no free one, and a removed particle does not count. */
static void the_lightest_particles(void) {
  static const char *const pages[] = {"disc 0 0 radius 2 a\ndisc 9 0 radius 1 a\ndisc 19 0 radius 1 a\n"
                                      "disc 29 0 radius 1.5 a\ndisc 39 0 radius 9 b\n",
                                      "disc 0 0 radius 1 b\ndisc 9 0 radius 2 b\ndisc 19 0 radius 1.001 b\n"
                                      "disc 29 0 radius 1 a fixed\ndisc 39 0 radius 1 a fixed\n",
                                      "disc 0 0 radius 1 a\ndisc 29 0 radius 2 b fixed\ndisc 39 0 radius 5 b\n"};
  static const struct {
    size_t page;
    int a, b;
    bool wall, remove; /* the first particle is removed */
    int first, second; /* numbers; 0: none */
  } rows[] = {
      {0, 0, 0, false, false, 2, 3}, {0, 0, 1, false, false, 2, 5}, {0, 1, 1, false, false, 5, 0},
      {0, 1, 0, false, false, 5, 2}, {0, 0, 0, true, false, 2, 0},  {1, 0, 0, false, false, 4, 5},
      {1, 1, 1, false, false, 1, 3}, {1, 1, 1, false, true, 3, 2},  {1, 1, 0, false, false, 1, 4},
      {2, 0, 0, false, false, 1, 0}, {2, 0, 0, false, true, 0, 0},  {2, 1, 1, false, false, 3, 2},
      {0, 1, 1, true, false, 0, 0}, /* no wall is of material b */
  };
  for (size_t k = 0; k < 2 * sizeof rows / sizeof *rows; k++) {
    const size_t r = k / 2;
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    int lightest[2];
    words_add(&page,
              "units none\nmaterial a density 1 kn 1\nmaterial b density 1 kn 1\nwall w -99 -20 to 99 -20 a\n%sstep "
              "0.01\nstage s\n"
              "%scycles 1\n",
              pages[rows[r].page], rows[r].remove ? "remove disc 1\n" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, &(struct nb_options){.shuffle = k % 2});
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    const struct nb_material_pair pair = {.a = rows[r].a, .b = rows[r].b, .wall = rows[r].wall};
    nb_step_lightest(model, &pair, lightest);
    CU_ASSERT_EQUAL(lightest[0] < 0 ? 0 : model->particles.number[lightest[0]], rows[r].first);
    CU_ASSERT_EQUAL(lightest[1] < 0 ? 0 : model->particles.number[lightest[1]], rows[r].second);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The single-contact step has the smallest mass of a free particle and the largest stiffness between two materials of
 * the scene, also if they belong to different contacts. */
static void the_single_contact_step(void) {
  const double pi = 3.14159265358979323846;
  NEAR(step_of(
           "units none\nmaterial a density 3 kn 5\nmaterial b density 2 kn 7\npair a b kn 11\ndisc 0 0 radius 2 a\n"
           "disc 9 0 radius 1 b fixed\ndisc 19 0 radius 1.5 b\ndisc 29 0 radius 1.2 a\nstep 0.5 of single-contact\n"),
       sqrt(3 * pi * 1.44 / 11), 1e-14);
}

/* ---- elastic spheres: the duration of a collision depends on the speed ---- */

/* E* is 1/2 for m with m, 1 for m with r, 1/3 for m with w. A sphere of radius 1 has the mass 1. */
#define SPHERES                                                                                                        \
  "units none\nnormal hertz\nmaterial m density 0.238732414637843 young 1 poisson 0\nmaterial r density "              \
  "0.238732414637843 rigid\nmaterial w density 0.238732414637843 young 0.5 poisson 0\n"

static double hertz(double young, double radius, double mass, double speed) {
  const double pi = 3.14159265358979323846, beta = sqrt(pi) * tgamma(0.4) / tgamma(0.9);
  return 0.8 * beta * pow(15 * mass * speed * speed / (16 * young * sqrt(radius)), 0.4) / speed;
}

static void duration_of_collisions(void) {
  NEAR(hertz(1, 1, 1, 1) * pow(16. / 15, 0.4), 2.9432751843247047, 1e-15);
  /* two spheres that approach each other, a sphere that approaches a wall, a wall that approaches a sphere */
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
  /* the second wall counts with its own material: 1/E* = 1/1 + 1/0.5, while the first wall is rigid */
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity 0 -0.1\nwall v -90 9 to 90 9 r\nwall w -90 0 to 90 0 w\n"
                       "step 20 per collision\n"),
       hertz(1. / 3, 1, 1, 0.1) / 20, 1e-14);
  /* whether the face of a wall is hit depends on the place of the first touch, x = 7 or -7, not on where the centre
   * would reach the line */
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity 0.35 -0.1\nwall w -90 0 to 9 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.1) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity -0.35 -0.1\nwall w -9 0 to 90 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.1) / 20, 1e-14);
  /* the sphere reaches the height 1, its radius, at x = 1.5 or -1.5, beyond the end of the wall, so it hits this end */
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity 0.3 -0.4\nwall w -90 0 to 1.25 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.3) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 0 3 radius 1 m velocity -0.3 -0.4\nwall w -1.25 0 to 90 0 r\nstep 20 per collision\n"),
       hertz(1, 1, 1, 0.3) / 20, 1e-14);
  /* a wall that rotates about its middle: at first touch the foot of the sphere's centre has moved from 8 to 8.75 */
  NEAR(step_of(SPHERES "sphere 8 3 radius 1 m\nwall w -8.9 0 to 8.9 0 r spin 0.5\nstep 20 per collision\n"),
       hertz(1, 1, 1, 4) / 20, 1e-14);
  NEAR(step_of(SPHERES "sphere 8 3 radius 1 m\nwall w -8.3 0 to 8.3 0 r spin 0.5\nstep 20 per collision\n"),
       hertz(1, 1, 1, 4.15 * sqrt(1 - 0.09)) / 20, 1e-14);
  /* the end of a wall acts as a point; a sphere that passes it, or moves away from a wall, does not collide */
  const double bent = 0.2 * sqrt(1 - 0.36);
  NEAR(step_of(SPHERES "sphere 0.6 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, bent), 1e-14);
  NEAR(step_of(SPHERES "sphere -9.6 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, bent), 1e-14);
  NEAR(step_of(SPHERES "sphere 1.1 5 radius 1 m velocity 0 -0.2\nwall w -9 0 to 0 0 r\nwall v -9 9 to 9 9 r\n"
                       "sphere 5 8.2 radius 0.1 m velocity 0 0.001\nstep 1 of collision\n"),
       hertz(1, 0.1, 0.001, 0.001), 1e-14);
  /* of the ends of a wall that is nearly parallel to the path, the one that is touched first counts, also if the other one
   * would be hit faster: the distances of the path from the first end are 0.5 and 0.8 */
  static const struct {
    const char *wall;
    double v; /* over the speed */
  } nearly_parallel[] = {{"0 0.5 to 9 0.8", 0.866025403784438647},
                         {"9 0.8 to 0 0.5", 0.866025403784438647},
                         {"0 0.8 to 9 0.5", 0.6},
                         {"9 0.5 to 0 0.8", 0.6}};
  for (int k = 0; k < 4; k++) {
    char statements[500];
    snprintf(statements, sizeof statements,
             SPHERES "sphere -20 0 radius 1 m velocity 0.2 0\nwall w %s r\nstep 1 of collision\n",
             nearly_parallel[k].wall);
    NEAR(step_of(statements), hertz(1, 1, 1, 0.2 * nearly_parallel[k].v), 1e-14);
  }
  /* a path at the distance of the radius does not touch, one that is nearer by a millionth does: v^2 = w^2 (1 - d^2) */
  NEAR(step_of(SPHERES "sphere -20 0 radius 1 m velocity 0.5 0\nwall w 0 1 to 0 9 r\nsphere -20 90 radius 1 m velocity "
                       "1e-3 0\nsphere 9 90 radius 1 m\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 1e-3), 1e-14);
  NEAR(step_of(SPHERES "sphere -20 0 radius 1 m velocity 0.5 0\nwall w 0 0.999999 to 0 9 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, 0.5 * sqrt(1 - 0.999999 * 0.999999)), 1e-9);
  /* oblique: the speed along the line of centres at first touch counts, in both orders of the spheres; the third sphere
   * hits none */
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 0.3 0\nsphere 5 0.8 radius 1 m\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.3 * sqrt(1 - 0.16)), 1e-14);
  NEAR(step_of(SPHERES "sphere 5 -0.8 radius 1 m\nsphere 0 0 radius 1 m velocity 0.3 0\nsphere 5 9 radius 1 m velocity "
                       "-9 0\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.3 * sqrt(1 - 0.16)), 1e-14);
  /* in contacts that touch already the present approach speed counts */
  NEAR(step_of(SPHERES "sphere 0 0.99 radius 1 m velocity 4 -0.1\nwall w -9 0 to 9 0 r\nstep 1 of collision\n"),
       hertz(1, 1, 1, 0.1), 1e-14);
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 0.5 0\nsphere 1.2 1.59 radius 1 m\nstep 1 of collision\n"),
       hertz(0.5, 0.5, 0.5, 0.5 * 1.2 / hypot(1.2, 1.59)), 1e-14);
  /* the shortest of several collisions; a fixed particle has infinite mass; two fixed particles do not count */
  NEAR(step_of(SPHERES "sphere 0 0 radius 1 m velocity 1 0\nsphere 5 0 radius 1 m\nsphere 0 9 radius 0.5 m velocity 1 "
                       "0\nsphere 5 9 radius 0.5 m\nstep 1 of collision\n"),
       hertz(0.5, 0.25, 0.0625, 1), 1e-14);
  NEAR(step_of(SPHERES
               "sphere 0 0 radius 1 m velocity 1 0\nsphere 5 0 radius 3 w fixed\nsphere 0 9 radius 0.1 r velocity "
               "9 0 fixed\nsphere 5 9 radius 0.1 m fixed\nstep 1 of collision\n"),
       hertz(1. / 3, 0.75, 1, 1), 1e-14);
}

/* Of two collisions with the same duration, the one of the particles with the smaller numbers is kept. */
static void equal_collisions(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            SPHERES "sphere 0 0 radius 1 m velocity 1 0\nsphere 5 0 radius 1 m\nsphere 0 9 radius 1 m velocity 1 "
                    "0\nsphere 5 9 radius 1 m\nstep 1 of collision\nrecord step\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_collision first;
  CU_ASSERT_EQUAL_FATAL(nb_collision_shortest(&first, model, NULL), NB_OK);
  CU_ASSERT(!first.wall && model->particles.number[first.a] == 1 && model->particles.number[first.b] == 2);
  nb_model_free(model);
  written_free(&it);
}

/* A later stage predicts collisions with the velocities at the time at which the stage begins. The stored velocities
 * are those of half a step earlier. */
static void velocities_of_a_later_stage(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            SPHERES "gravity 0 -1\nwall w -9 0 to 9 0 r\nsphere 0 9 radius 1 m velocity 0 -1\nstep 0.1\n"
                    "record step\nstage fall\nrecord none\ncycles 1\nstage b\nstep 40 per collision\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 1);
  NEAR(result.table.values[0], hertz(1, 1, 1, 1.1) / 40, 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* The step of the scene uses the velocity and the spin that the first stage gives a wall. It does not use those of a
 * ramp, because a ramp begins at the wall's own motion. */
static void walls_of_the_first_stage(void) {
  static const struct {
    const char *motion;
    double speed; /* of approach, at the first touch */
  } rows[] = {{"", 0.2},
              {"wall w velocity 0 0.3\n", 0.5},
              {"wall w spin 0.1\n", 0.5}, /* 0.1 rad/s at the distance 3 */
              {"wall w velocity 0 0.4 spin 0.1\n", 0.9},
              {"ramp wall w velocity 0 0.3 spin 0.1\n", 0.2}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              SPHERES "sphere 3 1.5 radius 1 m velocity 0 -0.2\nwall w -90 0 to 90 0 r\nstep 20 per collision\n"
                      "record step\nstage a\n%scycles 1\n",
              rows[k].motion);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    NEAR(written_now(model, "step"), hertz(1, 1, 1, rows[k].speed) / 20, 1e-14);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stage that removes a particle predicts collisions without it, whether it approached others or others approached
 * it. */
static void removed_particles_do_not_collide(void) {
#define LINE "sphere 0 0 radius 1 m velocity 1 0\nsphere 6 0 radius 1 m\nsphere 12 0 radius 1 m velocity -0.5 0\n"
  static const struct {
    const char *spheres;
    int removed;
    double speed;
  } rows[] = {
      {LINE, 1, 0.5},
      {LINE, 2, 1.5},
      {LINE, 3, 1},
      {"sphere 0 0 radius 1 m velocity 1 0\nsphere 3 0 radius 1 m velocity 0.9 0\nsphere 12 0 radius 1 m\n", 3, 0.1}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              SPHERES "%sstep 1e-9\nrecord step\nstage a\ncycles 1\nstage b\nremove sphere %d\n"
                      "step 20 per collision\ncycles 1\n",
              rows[k].spheres, rows[k].removed);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    NEAR(written_last(&result, "step"), hertz(0.5, 0.5, 0.5, rows[k].speed) / 20, 1e-9);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A stage that removes a wall predicts collisions without it. The two spheres approach each other more slowly than
 * the wall, of which an end or the face is in the way. */
static void removed_walls_do_not_collide(void) {
  static const char *const walls[] = {"wall w -90 0 to 90 0 r", "wall w 0 0 to 90 0 r"};
  for (size_t k = 0; k < sizeof walls / sizeof *walls; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              SPHERES "sphere 0 3 radius 1 m velocity 0 -1\nsphere 0 9 radius 1 m velocity 0 -1.5\n%s\nstep 1e-9\n"
                      "record step\nstage a\ncycles 1\nstage b\nremove wall w\nstep 20 per collision\ncycles 1\n",
              walls[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    NEAR(written_last(&result, "step"), hertz(0.5, 0.5, 0.5, 0.5) / 20, 1e-9);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The limits of a later stage use the velocities that the walls have in this stage: velocities that the stage gives,
 * and velocities that walls keep from the previous stage. */
static void walls_of_a_later_stage(void) {
  static const struct {
    const char *stages;
    double speed; /* speed of the wall in the last stage */
  } rows[] = {
      {"wall w velocity 0 0.1\ncycles 1\nstage b\nwall w velocity 0 0.4\n", 0.4},
      {"wall w velocity 0 0.4\ncycles 1\nstage b\nwall w velocity 0 0.1\n", 0.1},
      {"wall w velocity 0 0.4\ncycles 1\nstage b\nwall w velocity 0 0.1\ncycles 1\nstage c\n", 0.1},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              SPHERES "sphere 0 3 radius 1 m\nwall w -90 0 to 90 0 r\nstep 1e-3\nrecord step\nstage a\n%sstep 20 per "
                      "collision\ncycles 1\n",
              rows[k].stages);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    NEAR(written_last(&result, "step"), hertz(1, 1, 1, rows[k].speed) / 20, 1e-14);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Without stiffness, or without free particles, the limit is infinite, and no fraction of it is a step. A fraction of
 * 1e-310 of the limit of 4e-16 s is less than the smallest number, so the step is 0. A step by `--set` has no line. */
static void an_infinite_limit(void) {
  static const struct {
    const char *particles, *settings[2], *words;
    int line;
  } rows[] = {
      {"density 1 kn 0\ndisc 0 0 radius 1 m", {NULL}, "the step has no limit:", 5},
      {"density 1 kn 8\ndisc 0 0 radius 1 m fixed", {NULL}, "the step has no limit:", 5},
      {"density 1 kn 0\ndisc 0 0 radius 1 m", {"step=0.2 of single-contact"}, "--set: the step has no limit:", 0},
      {"density 1e-20 kn 1e12\ndisc 0 0 radius 1 m", {"step=1e-310 of single-contact"}, "--set: the step is 0:", 0},
  };
  for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page, "units none\nmaterial m %s\nstep 0.1 of single-contact\nstage s\ncycles 1\n", rows[n].particles);
    written_scene_set(&it, &page, rows[n].settings);
    CU_ASSERT_PTR_NULL(nb_model_create(&it.scene, NULL, &error));
    CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
    CU_ASSERT_PTR_EQUAL(strstr(error.text, rows[n].words), error.text);
    CU_ASSERT_EQUAL(error.line, rows[n].line);
    written_free(&it);
  }
}

static void steps_that_spheres_do_not_have(void) {
  static const struct {
    const char *statements, *words;
    int line; /* 0: any */
  } pages[] = {
      {"sphere 0 3 radius 1 m\nsphere 9 3 radius 1 m velocity 1 0\nstep 1 of collision\n",
       "no pair approaches, so there is no collision: write a time, or `step 0.2 of rayleigh`", 9},
      {"gravity 0 -9\nsphere 0 3 radius 1 m\nwall w -9 0 to 9 0 r\nstep 9 per collision\n", "no pair approaches", 10},
      {"sphere 0 3 radius 1 m\nstep 0.1 of stable\n", "the stable step follows from the stiffness", 8},
      {"lattice spheres 3 by 1 radius 1 m\nstep 0.1 of stable\n",
       "elastic spheres without overlap have none: write `step 0.2 of rayleigh`", 0},
      {"lattice spheres 2 by 1 radius 1 spacing 1.9 m\nstep 0.1 of single-contact\n",
       "because their stiffness increases with the load: write `step 0.2 of rayleigh`, or with approaching pairs `step "
       "200",
       8},
      {"sphere 0 3 radius 1 m velocity 0 -1 fixed\nwall w -9 0 to 9 0 r\nstep 9 per collision\n", "no pair approaches",
       9},
      {"sphere 0 3 radius 1 m velocity 0 -1 fixed\nsphere 0 0 radius 1 m fixed\nstep 9 per collision\n",
       "no pair approaches", 9},
      {"periodic cell 0 0 to 9 9\nsphere 0 3 radius 1 m velocity 0 1\nsphere 0 6 radius 1 m\nstep 9 per collision\n",
       "not predicted in a periodic cell: write a time, or `step 0.2 of rayleigh`", 10},
      {"sphere 0 3 radius 1 r\nstep 0.1 of rayleigh\n", "there are no waves: write a time, or `step 0.2 of stable`", 8},
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
  /* in a periodic cell the other steps of elastic spheres are defined, and so are collisions of linear springs */
  CU_ASSERT(step_of(SPHERES "periodic cell 0 0 to 9 9\nsphere 1 1 radius 1 m\nstep 0.1 of rayleigh\n") > 0);
  NEAR(step_of(PAIR "periodic cell 0 0 to 9 9\nlattice discs 2 by 1 radius 1 spacing 4 m\nstep 1 of collision\n"),
       3.14159265358979323846 / 4, 1e-14);
  /* with an overlap elastic spheres have a limit: 2/omega, omega^2 = k/M*, k = 2 E* (R* overlap)^(1/2) */
  NEAR(step_of(SPHERES "lattice spheres 2 by 1 radius 1 spacing 1.9 m\nstep 0.5 of stable\n"), sqrt(0.5 / sqrt(0.05)),
       1e-14);
  NEAR(step_of(SPHERES "lattice spheres 2 by 1 radius 1e-3 spacing 1.9999e-3 m\nstep 0.5 of stable\n"),
       sqrt(5e-10 / sqrt(5e-11)), 1e-10);
}

/* An overlap of up to 1e-9 of the radius counts as rounding; an overlap of 2e-9 does not. */
static void an_overlap_of_rounding_is_none(void) {
  for (int overlaps = 0; overlaps < 2; overlaps++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page, "%slattice spheres 2 by 1 radius 2 spacing %.17g m\nstep 0.1 of stable\nstage s\ncycles 1\n",
              SPHERES, 4 - 2 * (overlaps ? 2e-9 : 0.75e-9));
    written_scene(&it, &page);
    struct nb_model *model = nb_model_create(&it.scene, NULL, &error);
    CU_ASSERT_EQUAL(model != NULL, overlaps == 1);
    CU_ASSERT(overlaps || strstr(error.text, "elastic spheres without overlap"));
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stage without `step` keeps the step, although no particles approach each other any more. A stage with `step`
 * computes the step again. */
static void a_collision_step_is_kept(void) {
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

/* `--set step=...` replaces every `step` of a page. So no stage computes the step again, not even stage `off`, which
 * has a `step`, and in which the sphere leaves the wall. */
static void a_collision_step_that_is_set_is_kept(void) {
  static const char *const settings[] = {"step=40 per collision", NULL};
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "%swall w -9 0 to 9 0 r\nsphere 0 1.1 radius 1 m velocity 0 -1\nstep 1\nrecord step\n"
            "stage hit\ncycles 60\nstage off\nstep 2\ncycles 1\n",
            SPHERES);
  written_scene_set(&it, &page, settings);
  written_run(&result, &it, NULL);
  for (size_t row = 0; row < result.table.row_count; row++)
    NEAR(result.table.values[row], hertz(1, 1, 1, 1) / 40, 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* ---- the stability check ---- */

/* Runs these statements and returns the status. *cycles becomes the number of cycles, and *error has the message. */
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

/* A third disc approaches two discs in contact; its gap is 1 at first. The limit is 0.5 for two discs in contact, and
 * 2/sqrt(24) = 0.408 for three in a row. */
#define COMING(step, allow)                                                                                            \
  PAIR "lattice discs 2 by 1 radius 1 m\ndisc 6 1 radius 1 m velocity -0.025 0\nstep " step "\n" allow                 \
       "record time\nstage s\ncycles 200\n"

/* A removed wall is no partner of a disc, so the step of a later stage has no limit. */
static void a_removed_wall_limits_no_step(void) {
  unsigned long cycles;
  struct nb_error error;
  ends(PAIR "disc 0 3 radius 1 m\nwall w -9 0 to 9 0 m\nstep 0.01\nrecord time\nstage a\ncycles 1\n"
            "stage b\nremove wall w\nstep 20 per collision\ncycles 1\n",
       &cycles, &error);
  CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
  says(&error, "the step has no limit:");
}

/* The message about a step that `--set` gives names no line. */
static void a_step_that_is_set_has_no_line(void) {
  static const char *const settings[] = {"step=0.1 of stable", NULL};
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page, "%ssphere 0 3 radius 1 m\nstep 1\nrecord step\nstage s\ncycles 1\n", SPHERES);
  written_scene_set(&it, &page, settings);
  CU_ASSERT_PTR_NULL(nb_model_create(&it.scene, NULL, &error));
  CU_ASSERT_EQUAL(strncmp(error.text, "--set: the stable step", 22), 0);
  CU_ASSERT_EQUAL(error.line, 0);
  written_free(&it);
}

static void a_step_above_the_limit_stops_the_run(void) {
  unsigned long cycles;
  struct nb_error error;
  CU_ASSERT_EQUAL(ends(COMING("0.45", ""), &cycles, &error), NB_BROKEN);
  CU_ASSERT(cycles >= 80 && cycles <= 85); /* the pair is listed at the first search with a gap below 0.1 */
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

static void a_stage_is_checked_as_it_begins(void) {
  unsigned long cycles;
  struct nb_error error;
#define STAGES(first, second)                                                                                          \
  PAIR "lattice discs 2 by 1 radius 1 m\nstep 0.4\nrecord time\nstage a\n" first "cycles 3\nstage b\n" second          \
       "cycles 5\n"
  CU_ASSERT_EQUAL(ends(STAGES("", ""), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "step 0.6\n"), &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 3);
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "at cycle 3, time 1.2, the step 0.6 is above")); /* since the start */
  CU_ASSERT_EQUAL(ends(STAGES("", "step 0.6\nallow unstable\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("step 0.6\nallow unstable\n", ""), &cycles, &error),
                  NB_BROKEN); /* stage b keeps the step, but `allow unstable` holds for stage a only */
  CU_ASSERT_EQUAL(cycles, 3);
  CU_ASSERT_EQUAL(ends(STAGES("", "damping ratio 0.2\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "damping ratio 0.3\n"), &cycles, &error), NB_BROKEN); /* the limit is 0.372 */
  CU_ASSERT_EQUAL(ends(STAGES("", "damping con1 0.2 as velocity\n"), &cycles, &error),
                  NB_BROKEN); /* the limit is 0.387 */
  CU_ASSERT_EQUAL(ends(STAGES("", "material m kn 20\n"), &cycles, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(ends(STAGES("", "material m kn 20\nstep 1 of stable\n"), &cycles, &error), NB_OK);
  CU_ASSERT_EQUAL(ends(STAGES("", "ramp material m kn 20\nstep 1 of stable\n"), &cycles, &error), NB_OK);
}

/* Before the first stage the model has the step of this stage, not the step that the scene gives above it. */
static void the_step_of_the_first_stage(void) {
  static const char *const steps[][2] = {{"step 0.25\n", ""}, {"step 0.25\n", "step 0.125\n"}, {"", "step 0.125\n"}};
  for (size_t k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, PAIR "disc 0 0 radius 1 m\n%srecord step\nstage a\n%scycles 1\n", steps[k][0], steps[k][1]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(written_now(model, "step"), k > 0 ? 0.125 : 0.25);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A run without searches. Three discs in a row have omega^2 = 3 k, and the step 0.4 requires omega^2 <= 4/0.4^2. This
 * limit is exceeded at k = 8.33, after 2424 cycles, and the next check finds it. A pair has omega^2 = 2 k, which stays
 * below the limit; otherwise the stage would not begin. */
static void a_check_every_1000_cycles(void) {
  unsigned long cycles;
  struct nb_error error;
  CU_ASSERT_EQUAL(ends(PAIR "lattice discs 3 by 1 radius 1 m\nstep 0.4\nrecord time\nstage a\nrecord none\n"
                            "ramp material m kn 8.55\ncycles 4000\n",
                       &cycles, &error),
                  NB_BROKEN);
  CU_ASSERT_EQUAL(cycles, 3000);
}

/* The check changes nothing: a run has the same bits with the check and without it. */
static void the_check_changes_no_bit(void) {
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
  CU_ADD_TEST(suite, the_lightest_particles);
  CU_ADD_TEST(suite, removed_particles_do_not_collide);
  CU_ADD_TEST(suite, removed_walls_do_not_collide);
  CU_ADD_TEST(suite, the_single_contact_step);
  CU_add_test(suite, "a step relative to a limit", a_step_relative_to_a_limit);
  CU_add_test(suite, "duration of collisions of elastic spheres", duration_of_collisions);
  CU_add_test(suite, "of equal collisions the first pair is kept", equal_collisions);
  CU_add_test(suite, "collisions in a later stage", velocities_of_a_later_stage);
  CU_add_test(suite, "walls of the first stage", walls_of_the_first_stage);
  CU_add_test(suite, "walls of a later stage", walls_of_a_later_stage);
  CU_add_test(suite, "steps that elastic spheres do not have", steps_that_spheres_do_not_have);
  CU_add_test(suite, "a collision step is kept", a_collision_step_is_kept);
  CU_ADD_TEST(suite, a_collision_step_that_is_set_is_kept);
  CU_ADD_TEST(suite, an_overlap_of_rounding_is_none);
  CU_add_test(suite, "an infinite limit", an_infinite_limit);
  CU_ADD_TEST(suite, a_removed_wall_limits_no_step);
  CU_ADD_TEST(suite, a_step_that_is_set_has_no_line);
  CU_add_test(suite, "a step above the limit stops the run", a_step_above_the_limit_stops_the_run);
  CU_add_test(suite, "the step of the first stage", the_step_of_the_first_stage);
  CU_add_test(suite, "a stage is checked as it begins", a_stage_is_checked_as_it_begins);
  CU_add_test(suite, "a check every 1000 cycles", a_check_every_1000_cycles);
  CU_add_test(suite, "the stability check changes no bit", the_check_changes_no_bit);
}
