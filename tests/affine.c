/* Affine motion imposed by a cell, by a boundary and by `affine strain`. A cell and `affine strain` give the same
 * motion. The energy residuals are of second order in the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/affine.h"
#include "../src/core/model.h"
#include "loading/loading.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* Runs the page. Returns the last value of the quantity `name`. */
static double ends(struct words *page, const char *name) {
  struct written it;
  struct nb_result result;
  written_scene(&it, page);
  written_run(&result, &it, NULL);
  const double value = written_last(&result, name);
  nb_result_free(&result);
  written_free(&it);
  return value;
}

/* Two colliding discs under gravity and damping: the same bits with `cell strain` and with `affine strain` about the
 * same point. */
static void cell_and_affine_strain_agree(void) {
  static const char *const carries[] = {"cell", "affine"};
  static const char *const names[] = {
      "A.x", "B.vy", "A.vx.half", "B.angle", "energy.kinetic", "energy.gravity", "energy.damped"};
  for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
    double value[2];
    for (int c = 0; c < 2; c++) {
      struct words page = {0};
      words_add(
          &page,
          "units none\nmaterial m density 1 kn 1000 ks 700 friction 0.3\nshear linear\nstep 1e-3\ngravity 0.4 -0.3\n"
          "damping ratio 0.1\ndamping con1 0.999 as velocity\n"
          "disc -3 0.5 radius 1 m velocity 4 0\ndisc 1 0 radius 1.1 m velocity -2 1\n%smonitor A disc 1\nmonitor B "
          "disc "
          "2\n"
          "record %s\nstage s\n%s strain 0.2 -0.1 c12 0.3 c21 0.05\ncycles 700\n"
          "stage t\n%s strain -0.5 0.1\ncycles 300\n",
          c ? "" : "periodic cell -40 -40 to 40 40\n", names[n], carries[c], carries[c]);
      value[c] = ends(&page, names[n]);
    }
    CU_ASSERT_EQUAL(value[0], value[1]);
    CU_ASSERT(value[0] != 0);
  }
}

/* After N cycles with the strain rate L and N cycles with -L, the components of the sides of the cell have their first
 * values again. The error is about 80 |L|^2 dt^2 N, which is less than 1e-3; 80 is the length of a side, and dt is the
 * step. */
static void a_reversed_strain_restores_the_cell(void) {
  static const char *const names[] = {"cell.xx", "cell.xy", "cell.yx", "cell.yy"};
  static const double first[] = {80, 0, 0, 80};
  for (size_t n = 0; n < 4; n++) {
    struct words page = {0};
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 1000\nstep 1e-3\ndisc 0 0 radius 1 m\nperiodic cell -40 -40 to 40 40\n"
        "record %s\nstage s\ncell strain 0.2 -0.1 c12 0.15 c21 0.05\ncycles 100\nstage t\nreverse "
        "velocities\ncycles 100\n",
        names[n]);
    CU_ASSERT_DOUBLE_EQUAL(ends(&page, names[n]), first[n], 1e-3);
  }
}

/* Runs frictionless discs with dashpots under gravity, which are compressed and sheared, and then strained at another
 * rate. Returns the energy residual, and sets *driven to the imposed energy. `which`: 0 for a boundary and affine
 * motion, 1 for a cell; dt: the step. */
static double residual(int which, double dt, double *driven) {
  static const char *const before[] = {"boundary circle 0 0 radius 4.6\n", "periodic cell -5 -5 to 5 5\n"};
  static const char *const strain[] = {"affine strain -0.1 -0.12 shear 0.02\nboundary strain -0.1 -0.12 shear 0.02\n",
                                       "cell strain -0.1 -0.12 c12 0.05 c21 -0.01\n"};
  static const char *const back[] = {"boundary strain 0.03 -0.02\naffine none\n", "cell strain 0.03 0.01\n"};
  double value[2];
  for (int k = 0; k < 2; k++) {
    static const char *const names[] = {"energy.balance", "energy.imposed"};
    struct words page = {0};
    words_add(&page,
              "units none\nmaterial m density 2 kn 4000\nstep %g\ngravity 2 -3\n"
              "damping stiffness 0.002\ndamping mass 0.3\nlattice discs 10 by 10 m radius 0.501 spacing 1 from "
              "-4.5 -4.5\n"
              "%srecord %s\nstage a\n%scycles %d\nstage b\n%scycles %d\n",
              dt, before[which], names[k], strain[which], (int)round(0.1 / dt), back[which], (int)round(0.05 / dt));
    value[k] = ends(&page, names[k]);
  }
  *driven = value[1];
  return value[0];
}

static void energies_balance(void) {
  for (int which = 0; which < 2; which++) {
    double driven, whole;
    const double coarse = residual(which, 1e-3, &whole), fine = residual(which, 5e-4, &driven);
    CU_ASSERT(fabs(driven) > 1);
    CU_ASSERT(fabs(coarse) < 1e-3 * fabs(driven));
    CU_ASSERT(fabs(fine) < 0.3 * fabs(coarse)); /* second order: 1/4, and some room for terms of higher order */
    CU_ASSERT(fabs(whole - driven) < 1e-2 * fabs(driven));
  }
}

/* After `zero velocities` dashpot forces and kinetic energy are 0, as at time 0. */
static void zero_velocities_is_as_at_time_0(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(
      &page,
      "units none\nmaterial m density 1e9 kn 1000\ndamping stiffness 0.1\nstep 1e-3\nperiodic cell -10 -10 to 10 10\n"
      "disc 9.4 0 radius 1 m\ndisc -9.4 0 radius 1 m\nmonitor P disc 1 with disc 2\nrecord P.dashpot.normal "
      "energy.kinetic\n"
      "stage s\ncell strain -0.1 0\ncycles 3\nstage t\nzero velocities\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 3);
  CU_ASSERT(written_now(model, "P.dashpot.normal") > 1);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  CU_ASSERT_EQUAL(written_now(model, "P.dashpot.normal"), 0);
  CU_ASSERT_EQUAL(written_now(model, "energy.kinetic"), 0);
  nb_model_free(model);
  written_free(&it);
}

/* The affine motion of the particles ends in the first cycle after a strain. The strain since the last search still
 * reduces the travel limit, the displacement after which a new search is needed. The norm of this strain is 1e-4, and
 * the largest diameter is 2. */
static void the_affine_motion_ends(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 1000\nstep 1e-3\nperiodic cell -10 -10 to 10 10\ndisc 0 0 radius 1 m\n"
      "disc 4 0 radius 1 m\nrecord time\nstage s\ncell strain -0.1 0\ncycles 1\nstage t\ncell strain 0 0\ncycles 2\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (size_t cycle = 0; cycle < 2; cycle++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[cycle], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT_EQUAL(model->all_affine, cycle == 0);
  }
  const double limit = model->search.skin - 1e-4 * (2 * 1 + model->search.skin); /* nb_cell_move */
  CU_ASSERT_DOUBLE_EQUAL(model->cell->travel_limit, limit / 2, 1e-15);
  nb_model_free(model);
  written_free(&it);
}

/* Fixed particles stay, or move with the velocity that the page gives them, whatever strain is imposed. A free particle
 * follows the strain. */
static void fixed_particles_are_not_strained(void) {
  static const char *const strains[] = {"boundary strain 0.5 0.3", "affine strain 0.5 0.3",
                                        "boundary strain 0.5 0.3\naffine strain 0.2 0.1"};
  static const char *const names[] = {"F.x", "F.y", "M.x", "M.y"};
  static const double at[] = {3, 2, -5 + 0.5 * 0.2, 4};
  for (size_t k = 0; k < 3; k++)
    for (size_t n = 0; n < 5; n++) {
      struct words page = {0};
      words_add(
          &page,
          "units none\nmaterial m density 1 kn 1\nstep 0.01\nboundary circle 0 0 radius 20\n"
          "disc 3 2 radius 0.5 m fixed\ndisc -5 4 radius 0.5 m fixed velocity 0.5 0\ndisc 21 1 radius 0.5 m\n"
          "disc 5 -6 radius 0.5 m\nmonitor F disc 1\nmonitor M disc 2\nmonitor %s\nrecord %s\nstage s\n%s\ncycles 20\n",
          k == 1 ? "C disc 4" : "C disc 3", n < 4 ? names[n] : "C.x", strains[k]);
      const double value = ends(&page, n < 4 ? names[n] : "C.x");
      if (n < 4)
        CU_ASSERT_DOUBLE_EQUAL(value, at[n], 1e-13);
      CU_ASSERT(n < 4 || fabs(value - (k == 1 ? 5 : 21)) > 0.1);
    }
}

/* A disc starts at (10, 0) with the velocity 0.5 in y, in a cell that is strained in x at the rate L = 0.2. After N =
 * 100 steps `reverse velocities` reverses the velocity and the strain rate. After another 100 steps the disc is at y =
 * 0 again, and at x = 10 (1 - (L dt)^2)^N, because each pair of steps changes x by the factor (1 + L dt)(1 - L dt). */
static void a_reversed_particle_of_a_strained_cell_returns(void) {
  static const char *const names[] = {"A.x", "A.y"};
  const double wanted[] = {10 * pow(1 - 0.002 * 0.002, 100), 0};
  for (size_t k = 0; k < 2; k++) {
    struct words page = {0};
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 1\nstep 0.01\nperiodic cell -40 -40 to 40 40\n"
        "disc 10 0 radius 1 m velocity 0 0.5\nmonitor A disc 1\nrecord %s\nstage s\ncell strain 0.2 0\ncycles 100\n"
        "stage t\nreverse velocities\ncycles 100\n",
        names[k]);
    CU_ASSERT_DOUBLE_EQUAL(ends(&page, names[k]), wanted[k], 1e-12);
  }
}

/* The motion uses one strain rate if all particles have the same one, and store it in the same way. */
static void one_strain_rate_for_all(void) {
  static const struct {
    const char *statements; /* after two free discs, of which only the first is on or outside the circle of radius 4 */
    bool uniform;
  } rows[] = {
      {"stage s\naffine strain 0.1 -0.2\n", true},
      {"disc 9 9 radius 1 m fixed\nstage s\naffine strain 0.1 -0.2\n", false},
      {"stage s\naffine strain 0.1 -0.2 accumulated\n", true},
      {"periodic cell -9 -9 to 9 9\nstage s\ncell strain 0.1 -0.2\n", true},
      {"boundary circle 0 0 radius 4\nstage s\nboundary strain 0.1 -0.2\naffine strain 0.1 -0.2\n", true},
      {"boundary circle 0 0 radius 4\nstage s\nboundary strain 0.1 -0.2\naffine strain 0.1 -0.3\n", false},
      {"boundary circle 0 0 radius 4\nstage s\nboundary strain 0.1 -0.2\n", false},
      {"boundary circle 0 0 radius 4\nstage s\nboundary strain 0.1 -0.2\naffine strain 0.1 -0.2 accumulated\n", false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1000\nstep 1e-3\ndisc 5 0 radius 1 m\ndisc 1 0 radius 1 m\n"
              "record cycle\n%scycles 1\n",
              rows[k].statements);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    CU_ASSERT_EQUAL(model->affine->uniform, rows[k].uniform);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The earlier stage whose strain rate a stage inherits, and the line of this rate; -1: none, because the stage has a rate
 * of its own, because the rate is 0, or because a stage has moved a wall of the box. Each component counts. */
static void inherited_rates(void) {
  static const struct {
    const char *stages; /* from line 7 of the page on */
    enum nb_affine_source source;
    int from[3], line;
  } rows[] = {
      {"periodic cell 0 0 to 9 9\nstage a\ncell strain 0.1 0\n", NB_AFFINE_CELL, {-1, 0, 0}, 9},
      {"periodic cell 0 0 to 9 9\nstage a\ncell strain 0 0.1\n", NB_AFFINE_CELL, {-1, 0, 0}, 9},
      {"periodic cell 0 0 to 9 9\nstage a\ncell strain 0 0 c12 0.1\n", NB_AFFINE_CELL, {-1, 0, 0}, 9},
      {"periodic cell 0 0 to 9 9\nstage a\ncell strain 0 0 c21 0.1\n", NB_AFFINE_CELL, {-1, 0, 0}, 9},
      {"periodic cell 0 0 to 9 9\nstage a\ncell strain 0 0\n", NB_AFFINE_CELL, {-1, -1, -1}, 0},
      {"boundary circle 0 0 radius 4\nstage a\nboundary strain 0 0.1\n", NB_AFFINE_BOUNDARY, {-1, 0, 0}, 9},
      {"boundary circle 0 0 radius 4\nstage a\naffine strain 0 0.1\n", NB_AFFINE_BOUNDARY, {-1, -1, -1}, 0},
      {"boundary circle 0 0 radius 4\nstage a\naffine strain 0 0.1\n", NB_AFFINE_FREE, {-1, 0, 0}, 9},
      {"box 0 0 to 9 9 m\nstage a\nbox strain 0 0.1\n", NB_AFFINE_BOX, {-1, 0, 0}, 9},
  };
  static const struct {
    const char *second, *third;
    int from;
  } later[] = {{"box strain 0.2 0\n", "", 1},
               {"box strain 0 0\n", "", -1},
               {"wall east velocity 0.1 0\n", "", -1},
               {"wall east velocity 0.1 0\n", "servo mean 5 on box through box at most 1e-4 per cycle\n", -1},
               {"", "servo mean 5 on box through box at most 1e-4 per cycle\n", 0}};
  enum { ROWS = sizeof rows / sizeof *rows, LATER = sizeof later / sizeof *later };
  for (int k = 0; k < ROWS + LATER; k++) {
    const bool is_later = k >= ROWS;
    const int n = is_later ? k - ROWS : 0;
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1000\nstep 1e-3\ndisc 5 5 radius 1 m\nrecord time\n%scycles 1\n"
              "stage b\n%scycles 1\nstage c\n%scycles 1\n",
              rows[is_later ? ROWS - 1 : k].stages, is_later ? later[n].second : "", is_later ? later[n].third : "");
    written_scene(&it, &page);
    for (int s = 0; s < 3; s++) {
      int line = 0;
      const int from = nb_affine_inherited(&it.scene, (size_t)s, rows[is_later ? ROWS - 1 : k].source, &line);
      if (!is_later)
        CU_ASSERT_EQUAL(from, rows[k].from[s]);
      if (is_later && s == 2)
        CU_ASSERT_EQUAL(from, later[n].from);
      CU_ASSERT(from < 0 || is_later || line == rows[k].line);
    }
    written_free(&it);
  }
}

/* The rates that a model has in three stages. When a wall of a box is moved otherwise, the strain rate of the box ends for
 * good: a servo that moves the box later begins at the rate 0. `accumulated` ends `accumulated-twice`. */
static void rates_that_end(void) {
  static const struct {
    const char *page;
    double box[3];
    bool twice[3];
  } rows[] = {
      {"box 0 0 to 9 9 m\nstage a\nbox strain 0.1 0.2\ncycles 1\nstage b\nwall east velocity 0.1 0\ncycles 1\nstage c\n"
       "servo mean 5 on box through box at most 1e-4 per cycle\ncycles 1\n",
       {0.2, 0, 0},
       {false, false, false}},
      {"box 0 0 to 9 9 m\nstage a\nbox strain 0.1 0.2\ncycles 1\nstage b\ncycles 1\nstage c\n"
       "servo mean 5 on box through box at most 1e-4 per cycle\ncycles 1\n",
       {0.2, 0.2, 0.2},
       {false, false, false}},
      {"stage a\naffine strain 0.1 0.2 accumulated-twice\ncycles 1\nstage b\ncycles 1\nstage c\naffine strain 0.1 0.2 "
       "accumulated\ncycles 1\n",
       {0, 0, 0},
       {true, true, false}},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "units none\nmaterial m density 1 kn 1000\nstep 1e-3\ndisc 5 5 radius 1 m\nrecord time\n%s",
              rows[k].page);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int s = 0; s < 3; s++) {
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      CU_ASSERT_EQUAL(model->affine->base_rate[NB_AFFINE_BOX].yy, rows[k].box[s]);
      CU_ASSERT_EQUAL(model->affine->twice, rows[k].twice[s]);
      written_cycles(model, 1);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_affine(void) {
  CU_pSuite suite = CU_add_suite("affine", NULL, NULL);
  CU_add_test(suite, "cell strain and affine strain agree to the bit", cell_and_affine_strain_agree);
  CU_add_test(suite, "energies balance", energies_balance);
  CU_add_test(suite, "a reversed strain restores the cell", a_reversed_strain_restores_the_cell);
  CU_ADD_TEST(suite, a_reversed_particle_of_a_strained_cell_returns);
  CU_ADD_TEST(suite, fixed_particles_are_not_strained);
  CU_ADD_TEST(suite, the_affine_motion_ends);
  CU_add_test(suite, "after `zero velocities` dashpot forces and kinetic energy are 0",
              zero_velocities_is_as_at_time_0);
  CU_ADD_TEST(suite, one_strain_rate_for_all);
  CU_ADD_TEST(suite, inherited_rates);
  CU_ADD_TEST(suite, rates_that_end);
}
