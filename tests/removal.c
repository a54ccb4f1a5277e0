/* Particles that a stage removes. Their energy counts as removed, the other particles do not change, and no measure
 * counts removed particles.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/affine.h"
#include "../src/core/boundary.h"
#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define CLOSE(value, wanted, of) CU_ASSERT_DOUBLE_EQUAL(value, wanted, 1e-14 * (of))

/* Six discs in a box, of which discs 2 and 5 touch each other, and a fixed disc that moves. Stages that move a wall and
 * remove discs follow. */
#define BUSY                                                                                                           \
  "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.3 cohesion 0.1\nshear linear\nbox 0 0 to 6 4 m\n"       \
  "lattice discs 3 by 2 m radius 0.98 spacing 1.95 from 1 1\ndisc 6.84 1.1 radius 0.9 m fixed velocity -0.1 0 spin "   \
  "0.5\ngravity 0.1 -0.4\nstep 0.002\nmonitor A disc 1\nmonitor B disc 2\nmonitor C disc 3\nmonitor D disc "           \
  "4\nmonitor E disc "                                                                                                 \
  "5\nmonitor P disc 5 with disc 4\nmonitor S disc 1 with disc 2\nmonitor V disc 7\n"                                  \
  "record A.vx A.vy A.spin C.vx C.vy C.spin D.vx D.vy D.spin B.x B.y B.angle E.x B.vx B.vy B.spin B.fx B.moment "      \
  "P.normal P.shear S.normal P.overlap B.vx.half V.vx energy.kinetic energy.stored energy.friction energy.shear "      \
  "energy.damped energy.walls energy.gravity energy.changed energy.removed energy.balance work.balance\n"

enum { KEPT = 13, GONE = 23, ALL = 35 };
static const char *const names[ALL] = {
    /* unchanged by the removal */
    "A.vx", "A.vy", "A.spin", "C.vx", "C.vy", "C.spin", "D.vx", "D.vy", "D.spin", "B.x", "B.y", "B.angle", "E.x",
    /* 0 after the removal */
    "B.vx", "B.vy", "B.spin", "B.fx", "B.moment", "P.normal", "P.shear", "S.normal", "P.overlap", "B.vx.half",
    /* others */
    "V.vx", "energy.kinetic", "energy.stored", "energy.friction", "energy.shear", "energy.damped", "energy.walls",
    "energy.gravity", "energy.changed", "energy.removed", "energy.balance", "work.balance"};
enum { KINETIC = 24, STORED, FRICTIONAL, CHANGED = 31, REMOVED, RESIDUAL, WORK };

static void see(double values[ALL], const struct nb_model *model) {
  for (int k = 0; k < ALL; k++)
    values[k] = written_now(model, names[k]);
}

static const char *const dampings[] = {"",
                                       "damping stiffness 0.002\n",
                                       "damping mass 0.7\n",
                                       "damping con1 0.98 as cs79\n",
                                       "damping con1 0.98 as velocity\n",
                                       "damping con1 0.97 as all\n"};

/* With `ramp` the target of a servo begins at the stress of its region without the removed particles. Here this is the
 * contact force of the two remaining discs, times the distance of their centres, over the area of the box around them.
 * The area of the region, which was computed before the removal, must be computed again. */
static void a_servo_begins_without_the_removed(void) {
  static const char text[] =
      "units none\nmaterial m density 3 kn 1000\ndisc 0 0 radius 1 m fixed\ndisc 1.9 0 radius 1 m\n"
      "disc 3.7 0 radius 1 m\nbox -20 -20 to 20 20 m\nregion M all\nrecord M.stress.xx M.area\nstep 1e-6\n"
      "stage a\ncycles 1\nstage b\nremove disc 3\nramp servo xx 5 yy 5 on M through box at most 1\ncycles 10\n";
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, text);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "M.area"), 5.7 * 2, 1e-6);
  CU_ASSERT(written_now(model, "M.stress.xx") > 0);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  CU_ASSERT_DOUBLE_EQUAL(model->affine->servo_state.stress[0], 1000 * 0.1 * 1.9 / (3.9 * 2), 1e-6);
  CU_ASSERT_DOUBLE_EQUAL(model->affine->servo_state.stress[1], 0, 1e-6);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "M.area"), 3.9 * 2, 1e-6);
  nb_model_free(model);
  written_free(&it);
}

/* A removed particle stays where it was, even if it had an imposed motion when it was removed. */
static void a_removed_particle_ends_its_imposed_motion(void) {
  static const char text[] = "units none\nmaterial m density 3 kn 1000\ndisc 3 2 radius 1 m\ndisc -3 2 radius 1 m\n"
                             "monitor A disc 1\nmonitor B disc 2\nrecord A.x A.y B.x\nstep 0.01\n"
                             "stage a\naffine strain 0.1 -0.2\ncycles 5\nstage b\nremove disc 1\ncycles 9\n";
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, text);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 5);
  const double x = written_now(model, "A.x"), y = written_now(model, "A.y"), other = written_now(model, "B.x");
  CU_ASSERT(x > 3 && y < 2);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  written_cycles(model, 9);
  CU_ASSERT_EQUAL(written_now(model, "A.x"), x);
  CU_ASSERT_EQUAL(written_now(model, "A.y"), y);
  CU_ASSERT(written_now(model, "B.x") < other); /* the imposed motion of the other disc goes on */
  nb_model_free(model);
  written_free(&it);
}

/* Of four discs at the distance 5 on the axes, which are the boundary, one is removed. The other three are the boundary
 * then: their triangle has the area 25. A stress s on it presses the opposite disc inwards with 5 s, and the other two
 * with s (2.5^2 + 2.5^2)^(1/2); the removed disc has no such force. */
static void a_removed_particle_leaves_the_boundary(void) {
  const double s = 2;
  for (int gone = 0; gone < 4; gone++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(
        &page,
        "units none\nmaterial m density 3 kn 1000\ndisc 5 0 radius 1 m\ndisc 0 5 radius 1 m\ndisc -5 0 radius 1 m\n"
        "disc 0 -5 radius 1 m\nrecord boundary.particles boundary.area\nboundary circle 0 0 radius 5\nstep 0.001\n"
        "stage a\nboundary fixed\ncycles 1\nstage b\nremove disc %d\nboundary stress %g %g\ncycles 1\n",
        gone + 1, s, s);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT_EQUAL(written_now(model, "boundary.area"), 50);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    CU_ASSERT_EQUAL(written_now(model, "boundary.particles"), 3);
    CU_ASSERT_EQUAL(written_now(model, "boundary.area"), 25);
    for (int k = 0; k < 4; k++) {
      const struct nb_vec force = model->boundary->boundary_force[model->particles.slot[k]];
      CU_ASSERT_DOUBLE_EQUAL(vec_length(force), k == gone ? 0 : (k + gone) % 2 ? 2.5 * sqrt(2) * s : 5 * s, 1e-12);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* Compares values before a stage that removes discs 2 and 5 with values just after it has begun. The velocities and
 * forces of the removed discs become 0, and their energy counts as removed. The positions of the removed discs, the
 * velocities of the other discs, and the other terms of the energy balance stay the same. */
static void at_the_moment(void) {
  for (size_t n = 0; n < sizeof dampings / sizeof *dampings; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    double before[ALL], after[ALL];
    words_add(&page,
              BUSY "%sstage a\nwall west velocity 0.2 0.1\ncycles 300\nstage b\nremove discs 2 to 2\nremove disc 5\n"
                   "cycles 10\n",
              dampings[n]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 300);
    see(before, model);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    see(after, model);
    for (int k = 0; k < KEPT; k++)
      CLOSE(after[k], before[k], 1);
    for (int k = KEPT; k < GONE; k++) {
      CU_ASSERT_NOT_EQUAL(before[k], 0);
      CU_ASSERT_EQUAL(after[k], 0);
    }
    CU_ASSERT_EQUAL(after[GONE], before[GONE]); /* the fixed disc keeps its velocity */
    const double level = before[KINETIC] + before[STORED];
    for (int k = FRICTIONAL; k <= CHANGED; k++)
      CLOSE(after[k], before[k], level);
    CU_ASSERT_EQUAL(before[REMOVED], 0);
    CU_ASSERT(after[REMOVED] > 0.01 * level);
    CLOSE(after[REMOVED], level - after[KINETIC] - after[STORED], level);
    CLOSE(after[RESIDUAL], before[RESIDUAL], level);
    CLOSE(after[WORK], before[WORK], level);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Compares values before a stage that removes a wall of the box with values just after it has begun. Discs touch `south`
 * and `west`, and in some of the scenes `east`; `west` moves. The velocities of the discs and all terms of the balance stay the same, except the stored
 * energy: what the springs of the wall had stored counts as removed. The wall has no force then, and does not move. */
static void a_wall_at_the_moment(void) {
  static const char *const walls[] = {"south", "west", "east"};
  for (size_t n = 0; n < sizeof dampings / sizeof *dampings; n++)
    for (int k = 0; k < 3; k++) {
      struct words page = {0};
      struct written it;
      struct nb_error error;
      double before[ALL], after[ALL];
      words_add(&page,
                BUSY "monitor W wall %s\nrecord W.x W.fx W.fy W.angle\n%sstage a\nramp wall west velocity 0.2 0.1 spin "
                     "0.1\ncycles 300\nstage b\nremove wall %s\ncycles 10\n",
                walls[k], dampings[n], walls[k]);
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, NULL);
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
      written_cycles(model, 300);
      see(before, model);
      const double x = written_now(model, "W.x"), angle = written_now(model, "W.angle");
      const bool touched = written_now(model, "W.fx") != 0 || written_now(model, "W.fy") != 0;
      CU_ASSERT(touched || k == 2);
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
      see(after, model);
      const double level = before[KINETIC] + before[STORED];
      for (int c = 0; c < ALL; c++)
        if (strstr(names[c], ".v") || strstr(names[c], "spin") || c == KINETIC || (c >= FRICTIONAL && c != REMOVED))
          if (!strstr(names[c], ".half"))
            CLOSE(after[c], before[c], level);
      CU_ASSERT_EQUAL(before[REMOVED], 0);
      CU_ASSERT_EQUAL(after[REMOVED] > 1e-6 * level, touched);
      CLOSE(after[REMOVED], before[STORED] - after[STORED], level);
      CU_ASSERT(written_now(model, "W.fx") == 0 && written_now(model, "W.fy") == 0);
      written_cycles(model, 10);
      CU_ASSERT(written_now(model, "W.x") == x && written_now(model, "W.angle") == angle);
      CU_ASSERT(written_now(model, "W.fx") == 0 && written_now(model, "W.fy") == 0);
      nb_model_free(model);
      written_free(&it);
    }
}

/* A disc passes through the place of a removed wall, slowly or by a whole radius per step, and so does a wall that moves
 * with it. Without the removal the run would stop, because the wall is soft. */
static void the_place_of_a_removed_wall_is_free(void) {
  for (int removes = 0; removes < 2; removes++)
    for (int fast = 0; fast < 2; fast++) {
      struct words page = {0};
      struct written it;
      struct nb_error error;
      words_add(
          &page,
          "units none\nmaterial m density 1 kn 1e-9\ndisc 0 0 radius 1 m velocity %d 0\nwall gate 4.5 -3 to 4.5 3 "
          "m\nmonitor A disc 1\nrecord A.x\nstep %s\nstage a\ncycles 1\nstage b\n%scycles %d\n",
          fast ? 4 : 1, fast ? "0.25" : "0.01", removes ? "remove wall gate\n" : "", fast ? 9 : 899);
      written_scene(&it, &page);
      struct nb_result result;
      const enum nb_status status = nb_run(&result, &it.scene, NULL, NULL, &error);
      CU_ASSERT_EQUAL(status, removes ? NB_OK : NB_BROKEN);
      if (removes)
        CLOSE(written_last(&result, "A.x"), fast ? 10 : 9, 100);
      nb_result_free(&result);
      written_free(&it);
    }
}

/* A disc lies over the common end of two walls, nearest to the inside of one of them. The contact with the end of the
 * other wall is suppressed. When the first wall is removed, the end carries the disc: with the overlap d = R - |x - E|
 * its spring appears loaded, and its energy k d^2/2 counts as changed. Both balances hold. A third wall with this end has
 * no force, because only one contact at a vertex counts. */
static void the_other_wall_of_a_vertex(void) {
  for (int scene = 0; scene < 4; scene++) {
    const bool second = scene % 2, third = scene / 2;
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 3 kn 4000\nwall v -5 0 to 0 0 m\nwall w 0 0 to 5 0 m\n%s"
              "disc %s 0.98 radius 1 m\nmonitor A disc 1\nmonitor V wall v\nmonitor W wall w\n"
              "record energy.changed energy.removed energy.balance work.balance V.fy W.fy A.vy\n"
              "step 1e-5\nstage a\ncycles 1\nstage b\nremove wall %s\ncycles 9\n",
              third ? "wall u 0 -5 to 0 0 m\n" : "", second ? "0.1" : "-0.1", second ? "w" : "v");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const char *const gone = second ? "W.fy" : "V.fy", *const left = second ? "V.fy" : "W.fy";
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    CLOSE(written_now(model, gone), -4000 * 0.02, 1e11); /* the disc has moved by less than 1e-6 */
    CU_ASSERT_EQUAL(written_now(model, left), 0);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    written_cycles(model, 1);
    const double d = 1 - hypot(0.1, 0.98);
    CU_ASSERT_EQUAL(written_now(model, gone), 0);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, left), -4000 * d * 0.98 / (1 - d), 0.01);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.removed"), 4000 * 0.02 * 0.02 / 2, 1e-4);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.changed"), 4000 * d * d / 2, 1e-4);
    written_cycles(model, 8);
    CU_ASSERT(written_now(model, "A.vy") > 1e-4);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.balance"), 0, 1e-8);
    CLOSE(written_now(model, "work.balance"), 0, 1);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A particle removed at time 0 has no effect: the run gives the same bits as one without the particle. The test runs a
 * scene of 7 particles, and one of 37, which are so many that the search sorts them into boxes. */
static void removed_at_time_0(void) {
  for (int many = 0; many < 2; many++) {
    double seen[2][4];
    for (int with = 0; with < 2; with++) {
      struct words page = {0};
      struct written it;
      struct nb_result result;
      const struct nb_options options = {.threads = 1, .shuffle = with && many};
      words_add(&page, "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.3\nshear linear\nskin 0.1\n"
                       "box 0 0 to 12 12 m\ngravity 0.1 -0.4\n");
      words_add(&page, many ? "lattice discs 6 by 6 m radius 0.98 spacing 1.97 from 1 1\n"
                            : "lattice discs 3 by 2 m radius 0.98 spacing 1.95 from 1 1\n");
      if (with)
        words_add(&page, "disc 1.98 1.98 radius 0.6 m spin 3 velocity 0 -1\n");
      words_add(&page,
                "monitor A disc 2\nmonitor S wall south\nrecord A.x A.vy A.angle S.fy energy.removed\nstep 0.002\n"
                "stage a\n%scycles 300\n",
                with ? many ? "remove disc 37\n" : "remove disc 7\n" : "");
      written_scene(&it, &page);
      written_run(&result, &it, &options);
      static const char *const columns[] = {"A.x", "A.vy", "A.angle", "S.fy"};
      for (int k = 0; k < 4; k++)
        seen[with][k] = written_last(&result, columns[k]);
      CU_ASSERT_EQUAL(written_last(&result, "energy.removed") > 0, with);
      nb_result_free(&result);
      written_free(&it);
    }
    for (int k = 0; k < 4; k++)
      CU_ASSERT_EQUAL(seen[0][k], seen[1][k]);
  }
}

/* The thickness is the mean over the remaining particles: 1 for a disc, 4 for a sphere of radius 2, and 1 without any. */
static void thickness_without_removed_particles(void) {
  static const double wanted[] = {2.5, 1, 1};
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nsphere 9 0 radius 2 m\nstep 0.1\n"
                   "stage a\ncycles 1\nstage b\nremove sphere 2\ncycles 1\nstage c\nremove disc 1\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (int s = 0; s < 3; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT_EQUAL(nb_thickness(model), wanted[s]);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Without friction the spin of a disc does not change when its neighbour is removed. */
static void spins_do_not_change(void) {
  for (int first = 0; first < 2; first++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m spin 2\ndisc 1.9 0 radius 1 m spin 3\n"
              "monitor A disc 1\nmonitor B disc 2\nrecord A.spin B.spin\nstep 0.01\nstage a\ncycles 5\nstage b\n"
              "remove disc %d\ncycles 5\n",
              first ? 1 : 2);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL(written_last(&result, "A.spin"), first ? 0 : 2);
    CU_ASSERT_EQUAL(written_last(&result, "B.spin"), first ? 3 : 0);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* When one of two touching discs is removed, the spin of the other at this time does not change. The two discs have
 * different radii, so the moment on each must be computed with its own lever arm. */
static void different_radii(void) {
  for (int first = 0; first < 2; first++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.5\nshear linear\nstep 0.002\n"
              "disc 0 0 radius 1 m\ndisc 2.9 0 radius 2 m velocity 0 -0.1\nmonitor A disc %d\nrecord A.spin A.moment\n"
              "stage a\ncycles 10\nstage b\nremove disc %d\ncycles 1\n",
              first ? 2 : 1, first ? 1 : 2);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 10);
    const double before = written_now(model, "A.spin");
    CU_ASSERT_NOT_EQUAL(written_now(model, "A.moment"), 0);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    CLOSE(written_now(model, "A.spin"), before, fabs(before));
    nb_model_free(model);
    written_free(&it);
  }
}

/* No measure of a region counts a removed disc, wherever it was: the values are those of the scene without this disc.
 * The first of the three discs is inside the circle and the box; each of the other two would enlarge the region
 * `all`. */
static void regions_without_removed_particles(void) {
  static const char *const measures[] = {
      "area",      "porosity",       "porosity.volume",         "void_ratio", "particles",
      "contacts",  "coordination",   "coordination.mechanical", "rattlers",   "fabric.kk",
      "stress.xx", "normal.mean",    "unbalanced.mean",         "strain.xx",  "speed.mean",
      "speed.max", "chains.fraction"};
  static const char *const discs[] = {"", "disc 0.975 0.975 radius 0.5 m velocity 9 0\n",
                                      "disc -20 -9 radius 0.3 m velocity 9 0\n",
                                      "disc 2 30 radius 0.3 m velocity 9 0\n"};
  enum { NAMES = sizeof measures / sizeof *measures, DISCS = sizeof discs / sizeof *discs, REGIONS = 3 };
  double seen[DISCS][REGIONS][NAMES];
  for (int k = 0; k < DISCS; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 3 kn 4000\nlattice discs 3 by 3 m radius 1 spacing 1.95 from 0 0\n%s"
              "region A all\nregion B circle 2 2 radius 3\nregion C box 0 0 to 4 5\n",
              discs[k]);
    for (int r = 0; r < REGIONS; r++)
      for (int n = 0; n < NAMES; n++)
        words_add(&page, "record %c.%s\n", 'A' + r, measures[n]);
    words_add(&page, "step 0.002\nstage a\n%scycles 20\n", k ? "remove disc 10\n" : "");
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    for (int r = 0; r < REGIONS; r++)
      for (int n = 0; n < NAMES; n++) {
        char column[64];
        snprintf(column, sizeof column, "%c.%s", 'A' + r, measures[n]);
        seen[k][r][n] = written_last(&result, column);
        if (seen[k][r][n] != seen[0][r][n])
          printf("# %s with disc %d: %.17g instead of %.17g\n", column, k, seen[k][r][n], seen[0][r][n]);
        CU_ASSERT_EQUAL(seen[k][r][n], seen[0][r][n]);
      }
    CU_ASSERT(seen[k][0][4] == 9 && seen[k][0][0] > 0);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A disc passes through the places of two removed discs, one of which was fixed. Snapshots do not show the removed
 * discs. */
static void places_of_removed_particles_are_free(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\ndisc 10 0 radius 2 m\n"
                   "disc 20 0 radius 2 m fixed velocity 0 1\ndisc 20 9 radius 1 m\nmonitor A disc 1\nmonitor C disc 3\n"
                   "record A.x C.y C.vy\nstep 0.25\nstage a\ncycles 4\nsnapshot\nstage b\nremove discs 2 to 3\n"
                   "cycles 116\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(written_last(&result, "A.x"), 30);
  CU_ASSERT_EQUAL(written_last(&result, "C.y"), 1);
  CU_ASSERT_EQUAL(written_last(&result, "C.vy"), 0);
  CU_ASSERT_EQUAL_FATAL(result.snapshot_count, 2);
  CU_ASSERT_EQUAL(result.snapshots[0].particles.row_count, 4);
  const struct nb_table *particles = &result.snapshots[1].particles;
  CU_ASSERT_EQUAL_FATAL(particles->row_count, 2);
  CU_ASSERT_EQUAL(particles->values[0], 1);
  CU_ASSERT_EQUAL(particles->values[particles->column_count], 4); /* the disc keeps its number */
  nb_result_free(&result);
  written_free(&it);
}

/* A step relative to a limit depends only on the remaining particles. */
static void steps_count_remaining_particles(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 9\nmaterial light density 0.25 kn 9\ndisc 0 0 radius 1 m\n"
            "disc 9 0 radius 1 m\ndisc 18 0 radius 0.5 light\nrecord step step.single-contact energy.removed\n"
            "step 0.5 of collision\nstage a\ncycles 1\nstage b\nremove disc 3\nstep 0.5 of collision\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double pi = 3.14159265358979323846;
  CLOSE(written_last(&result, "step"), 0.5 * pi * sqrt(pi / 2 / 9), 1);
  CLOSE(written_last(&result, "step.single-contact"), 2 * sqrt(pi / 9), 1);
  CU_ASSERT_EQUAL(written_last(&result, "energy.removed"), 0);
  nb_result_free(&result);
  written_free(&it);
}

/* A sphere approaches two other spheres, one behind the other. The nearer one, which is much larger, is removed, so the
 * predicted collision is the one with the farther sphere. */
static void collision_prediction_without_removed_particles(void) {
  double steps[2];
  for (int with = 0; with < 2; with++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 young 9 poisson 0.3\nnormal hertz\n"
              "sphere 0 0 radius 1 m velocity 1 0\nsphere 240 0 radius 10 m\n%s\nrecord step\nstep 0.01\nstage a\n"
              "cycles 1\nstage b\n%s\nstep 0.01 of collision\ncycles 1\n",
              with ? "sphere 120 0 radius 100 m" : "", with ? "remove sphere 3" : "");
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    steps[with] = written_last(&result, "step");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT_EQUAL(steps[1], steps[0]);
}

void suite_removal(void) {
  CU_pSuite suite = CU_add_suite("removal", NULL, NULL);
  CU_add_test(suite, "values at the moment of removal", at_the_moment);
  CU_add_test(suite, "a servo begins without the removed particles", a_servo_begins_without_the_removed);
  CU_add_test(suite, "a removed particle ends its imposed motion", a_removed_particle_ends_its_imposed_motion);
  CU_add_test(suite, "a removed particle leaves the boundary", a_removed_particle_leaves_the_boundary);
  CU_add_test(suite, "removal at time 0", removed_at_time_0);
  CU_add_test(suite, "values at the moment when a wall is removed", a_wall_at_the_moment);
  CU_add_test(suite, "the place of a removed wall is free", the_place_of_a_removed_wall_is_free);
  CU_add_test(suite, "the other wall of a vertex carries the particle", the_other_wall_of_a_vertex);
  CU_add_test(suite, "removal of a disc beside one of another radius changes no spin", different_radii);
  CU_add_test(suite, "regions without removed particles", regions_without_removed_particles);
  CU_add_test(suite, "places of removed particles are free", places_of_removed_particles_are_free);
  CU_add_test(suite, "thickness without removed particles", thickness_without_removed_particles);
  CU_add_test(suite, "removal without friction changes no spin", spins_do_not_change);
  CU_add_test(suite, "steps count remaining particles", steps_count_remaining_particles);
  CU_add_test(suite, "collision prediction without removed particles", collision_prediction_without_removed_particles);
}
