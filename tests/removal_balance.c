/* The energy balance of stages that remove a particle and make another change at the same time.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* Six discs in a box, of which discs 2 and 5 touch each other, and a fixed disc that moves. */
#define SCENE                                                                                                          \
  "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.3 cohesion 0.1\nshear linear\nbox 0 0 to 6 4 m\n"       \
  "lattice discs 3 by 2 m radius 0.98 spacing 1.95 from 1 1\ndisc 6.84 1.1 radius 0.9 m fixed velocity -0.1 0 spin "   \
  "0.5\ngravity 0.1 -0.4\nstep 0.002\nrecord energy.balance work.balance energy.removed\n"

/* With sixteen times as many steps the residual of the energy is at most an eighth. That of the work is 0 except for
 * rounding. */
static void removal_with_other_changes(void) {
  static const char *const jumps[] = {"zero velocities\n", "reverse velocities\n", "gravity 1 0\n",
                                      "material m kn 6000 ks 900\n"};
  for (size_t n = 0; n < sizeof jumps / sizeof *jumps; n++) {
    double residual[2], work[2], removed[2];
    for (int fine = 0; fine < 2; fine++) {
      struct words page = {0};
      struct written it;
      struct nb_result result;
      words_add(&page,
                SCENE "stage a\nstep %g\nwall west velocity 0.2 0.1\ncycles %d\nstage b\n%sremove disc 5\n"
                      "cycles %d\n",
                fine ? 0.0001 : 0.0016, fine ? 6400 : 400, jumps[n], fine ? 6400 : 400);
      written_scene(&it, &page);
      written_run(&result, &it, NULL);
      residual[fine] = fabs(written_last(&result, "energy.balance"));
      work[fine] = fabs(written_last(&result, "work.balance"));
      removed[fine] = written_last(&result, "energy.removed");
      nb_result_free(&result);
      written_free(&it);
    }
    CU_ASSERT(residual[1] < residual[0] / 8);
    CU_ASSERT(work[0] < 1e-11 && work[1] < 1e-11);
    CU_ASSERT(removed[0] > 0 && fabs(removed[0] - removed[1]) < 0.01 * removed[1]);
  }
}

/* A boundary that begins ends the contacts between two of its particles, and those of its particles with walls. The energy
 * of their springs counts as removed, and that of the contacts with free particles does not. */
static void springs_of_a_boundary(void) {
  static const char *const pages[] = {
      "disc 5 0 radius 1 m\ndisc 3.05 0 radius 1 m\ndisc -5 0 radius 1 m\ndisc -5 1.9 radius 1 m\n"
      "wall w 5.8 -9 to 5.8 9 m\nwall v -9 2.8 to 0 2.8 m\n", /* 0.2, 0.1 and 0.1; 0.05 to the free disc 2 */
      "disc 0 3.05 radius 1 m\ndisc 0 5 radius 1 m\ndisc 0.5 0 radius 1 m\nwall w -9 -0.95 to 9 -0.95 m\n"};
  static const double wanted[] = {400 * (0.2 * 0.2 + 0.1 * 0.1 + 0.1 * 0.1) / 2, 0};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 3 kn 400\nstep 0.001\n%srecord energy.removed\nstage s\n"
              "boundary circle 0 0 radius 4\ncycles 1\n",
              pages[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.removed"), wanted[k], 1e-12);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A stage removes what it names, whatever walls it moves besides, before or after. */
static void removal_and_wall_motions(void) {
  static const char *const stages[] = {"remove disc 1\nwall w velocity 0 0\n", "wall w velocity 0 0\nremove disc 1\n",
                                       "remove wall v\nwall w velocity 0 0\n", "wall w velocity 0 0\nremove wall v\n"};
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 3 kn 400\nstep 0.001\ndisc 0 0.9 radius 1 m\nwall v -9 0 to 9 0 m\n"
              "wall w -9 9 to 9 9 m\nmonitor D disc 1\nrecord D.fy contacts\nstage s\n%scycles 1\n",
              stages[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(written_now(model, "contacts"), 1);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT_EQUAL(written_now(model, "contacts"), 0);
    CU_ASSERT_EQUAL(written_now(model, "D.fy"), 0);
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_removal_balance(void) {
  CU_pSuite suite = CU_add_suite("removal_balance", NULL, NULL);
  CU_add_test(suite, "removal with other changes of the stage", removal_with_other_changes);
  CU_ADD_TEST(suite, springs_of_a_boundary);
  CU_ADD_TEST(suite, removal_and_wall_motions);
}
