/* Cases in which a small error in one line changes a result. The comment of each test names the function with this
 * line.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/affine.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static void run(struct nb_result *result, struct written *it, const char *text) {
  struct words words = {0};
  words_add(&words, "%s", text);
  written_scene(it, &words);
  written_run(result, it, NULL);
}

/* measure/region.c, nb_region_position: in a cell the images nearest to the middle of the region count, not those
 * nearest to the middle of the cell. The middle of the region is a corner of the cell, where four discs touch each
 * other. */
static void a_region_at_the_corner_of_a_cell(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "units none\nmaterial m density 1 kn 100\nlattice discs 4 by 4 from 1 1 radius 1 spacing 2 m\nperiodic cell 0 0 "
      "to 8 8\n"
      "region R circle 0 0 radius 1.5\nrecord R.particles\nstep 0.001\nstage s\ncycles 1\n");
  CU_ASSERT_EQUAL(written_last(&result, "R.particles"), 4);
  nb_result_free(&result), written_free(&it);
}

/* value.c, read_count: rounding makes 1e-4/2e-7 larger than 500 and 0.3/0.1 smaller than 3. */
static void a_count_may_be_rounded(void) {
  struct words words = {0};
  struct written it;
  const volatile double large = 1e-4 / 2e-7, small = 0.3 / 0.1;
  CU_ASSERT(large > 500 && small < 3);
  words_add(&words, "%s",
            "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nstep 0.001\nrecord time\nstage s\n"
            "record every (0.3/0.1) cycles\ncycles (1e-4/2e-7)\n");
  written_scene(&it, &words);
  CU_ASSERT_EQUAL(it.scene.stages[0].cycles, 500);
  CU_ASSERT_EQUAL(it.scene.stages[0].record_interval, 3);
  written_free(&it);
}

/* cell.c, nb_cell_check_width: the height, the distance of opposite sides, must be at least 2 (2 + 0.1), twice the sum of
 * the largest diameter and the skin. The height is checked at each search; the strain requires a search after 5 %. A cell
 * of width 5 may shrink to 4.3, but not to 4. */
static void a_cell_stays_wide_enough_or_not(void) {
  for (int wide = 0; wide < 2; wide++) {
    struct words words = {0};
    struct written it;
    struct nb_result result = {0};
    struct nb_error error = {0};
    words_add(
        &words,
        "units none\nmaterial m density 1 kn 100\ndisc 1 1 radius 1 m\ndisc 1 5 radius 1 m\nperiodic cell 0 0 to 5 9\n"
        "skin 0.1\nrecord time\nstep 0.001\nstage r\ncycles 40\nstage s\n"
        "cell strain -1e-3 per cycle 0 per cycle\ncycles %d\n",
        wide ? 150 : 223);
    written_scene(&it, &words);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), wide ? NB_OK : NB_BROKEN);
    double width, time;
    unsigned long cycle;
    CU_ASSERT(wide || strstr(error.text, "the skin, 4.2"));
    CU_ASSERT_FATAL(wide ||
                    sscanf(error.text, "the cell is %lf wide at cycle %lu, at time %lf:", &width, &cycle, &time) == 3);
    /* after 40 cycles without a strain */
    CU_ASSERT(wide || fabs(width - 5 * pow(0.999, (double)cycle - 40)) < 1e-4);
    CU_ASSERT(wide || fabs(time - (double)cycle * 0.001) < 1e-5);
    nb_result_free(&result), written_free(&it);
  }
}

/* cell.c, nb_cell_move: after a strain s a particle may move by (skin - s (2 R + skin))/2 before a search. */
static void straining_reduces_the_travel_limit(void) {
  struct words words = {0};
  struct written it;
  struct nb_error error;
  words_add(&words,
            "units none\nmaterial m density 1 kn 100\ndisc 1 1 radius 0.5 m\ndisc 1 5 radius 0.5 m\nperiodic cell 0 0 "
            "to 9 9\nskin 0.4\n"
            "step 0.01\nstage s\ncell strain 0.3 0\ncycles 9\n");
  written_scene(&it, &words);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const struct nb_cell *cell = model->cell;
  written_cycles(model, 3);
  CU_ASSERT_DOUBLE_EQUAL(cell->travel_limit, (0.4 - (pow(1.003, 3) - 1) * (1 + 0.4)) / 2, 1e-14);
  nb_model_free(model), written_free(&it);
}

/* boundary.c, detach: a particle that a boundary releases under `rotation off` does not rotate, although its contact
 * has friction. */
static void released_particles_do_not_rotate_under_rotation_off(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "units none\nmaterial m density 1 kn 100 ks 100 friction 1\nshear linear\nstep 0.01\ndisc 0 0.99 radius 1 m\n"
      "wall floor -9 0 to 9 0 m velocity 1 0\nboundary circle 0 3 radius 1\nmonitor D disc 1\nrecord D.spin D.vx\n"
      "stage a\nrotation off\ncycles 5\nstage b\nboundary none\ncycles 5\n");
  CU_ASSERT(written_last(&result, "D.vx") > 1e-4);
  CU_ASSERT_EQUAL(written_last(&result, "D.spin"), 0);
  nb_result_free(&result), written_free(&it);
}

/* boundary.c, may_join: a fixed particle is no part of a boundary, neither outside the circle at the start nor when it
 * crosses the circle. */
static void fixed_particles_are_no_part_of_a_boundary(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "units none\nmaterial m density 1 kn 100\nstep 0.001\ndisc 0 0 radius 0.1 m\ndisc 5 0 radius 0.1 m fixed\n"
      "disc 0 5 radius 0.1 m\ndisc -2 0 radius 0.1 m fixed velocity -1 0\nboundary circle 0 0 radius 2.05\nmonitor D "
      "disc 4\nrecord boundary.particles D.x\nstage a\ncycles 100\n");
  CU_ASSERT(written_last(&result, "D.x") < -2.09);
  for (size_t r = 0; r < result.table.row_count; r++)
    CU_ASSERT_EQUAL(result.table.values[r * result.table.column_count], 1);
  nb_result_free(&result), written_free(&it);
}

/* servo.c, nb_servo_apply: a servo that strains the box adds nothing to the strain rate of the boundary in the box. Each
 * cycle multiplies the sides of the boundary's square by 1 - 1e-4. */
static void a_servo_of_the_box_does_not_strain_a_boundary(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "units none\nmaterial m density 1 kn 100\nstep 0.001\nlattice discs 2 by 2 from 3 3 radius 0.5 spacing 4 m\n"
      "box 0 0 to 10 10 m\nboundary circle 5 5 radius 2\nrecord boundary.area box.width\n"
      "stage a\nboundary strain -1e-4 per cycle -1e-4 per cycle\nservo mean 1 on box through box at most 1e-3 per "
      "cycle\ncycles 20\n");
  CU_ASSERT(written_last(&result, "box.width") < 9.9);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.area"), 16 * pow(1 - 1e-4, 40), 1e-12);
  nb_result_free(&result), written_free(&it);
}

#define SOFT                                                                                                           \
  "path\nmaterial soft young 1 MPa poisson 0 friction 0.3\ncontact sphere 10 mm soft with sphere 10 mm soft\n"         \
  "normal hertz\n"

/* contact_test.c, run_segment: the last step of a segment has a row, whatever `record every` says. */
static void the_last_step_of_a_segment_is_recorded(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it, SOFT "record step\nsegment a overlap to 3 um in 5 steps\nrecord every 2 steps\n");
  static const double steps[] = {0, 2, 4, 5};
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 4);
  for (int k = 0; k < 4; k++)
    CU_ASSERT_EQUAL(result.table.values[k], steps[k]);
  nb_result_free(&result), written_free(&it);
}

/* contact_test.c, find_displacement: the search for a force goes up to an overlap of two radii. Here the overlap is
 * half a radius, with R* = 5 mm and E* = 0.5 MPa. */
static void a_force_deep_in_the_contact_is_found(void) {
  struct written it;
  struct nb_result result;
  struct words words = {0};
  const double overlap = 0.005;
  words_add(&words, SOFT "record overlap normal\nsegment a normal to %.17g N in 1 step\n",
            4. / 3 * 0.5e6 * sqrt(0.005) * overlap * sqrt(overlap));
  written_scene(&it, &words);
  written_run(&result, &it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "overlap"), overlap, 1e-12);
  nb_result_free(&result), written_free(&it);
}

/* names.c, touching_count, and contacts.h, nb_touches: particles and walls that only meet have no contact. */
static void an_overlap_of_0_is_no_contact(void) {
  static const char *const names[] = {"contacts", "R.contacts", "R.coordination"};
  for (int overlapping = 0; overlapping < 2; overlapping++) {
    struct words words = {0};
    struct written it;
    words_add(&words,
              "units none\nmaterial m density 1 kn 100\ndisc 0 1 radius 1 m\ndisc 2 1 radius %g m\n"
              "wall w -9 0 to 9 0 m\nregion R circle 0 1 radius 0.5\nstep 0.001\n"
              "record contacts R.contacts R.coordination\nstage s\ncycles 1\n",
              overlapping ? 1.25 : 1);
    written_scene(&it, &words);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(model->contacts.count, 3);
    CU_ASSERT_EQUAL(written_now(model, names[0]), overlapping ? 2 : 0);
    for (int k = 1; k < 3; k++)
      CU_ASSERT_EQUAL(written_now(model, names[k]), overlapping);
    nb_model_free(model), written_free(&it);
  }
}

/* velocity.c, nb_velocity_now: at time 0, before the first step, the velocities are those of the page. */
static void at_time_0_velocities_are_those_of_the_page(void) {
  static const char *const dampings[] = {"mass 0.7", "con1 0.9 as cs79", "con1 0.9 as velocity", "con1 0.9 as all"};
  for (size_t k = 0; k < sizeof dampings / sizeof *dampings; k++) {
    struct words words = {0};
    struct written it;
    struct nb_error error;
    words_add(&words,
              "units none\nmaterial m density 1 kn 100\ndisc 3 2 radius 1 m velocity 0.5 -0.25 spin 2\ngravity 1 -9\n"
              "damping %s\nstep 0.001\nmonitor A disc 1\nrecord A.vx A.vy A.spin\n"
              "stage s\naffine strain 0.3 -0.2 accumulated\ncycles 1\n",
              dampings[k]);
    written_scene(&it, &words);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, it.scene.stages, &error), NB_OK);
    CU_ASSERT_EQUAL(written_now(model, "A.vx"), 0.5);
    CU_ASSERT_EQUAL(written_now(model, "A.vy"), -0.25);
    CU_ASSERT_EQUAL(written_now(model, "A.spin"), 2);
    nb_model_free(model), written_free(&it);
  }
}

/* measure/strain.c: the strain at right angles to a line of particles is undefined, so the tensor is set to 0
 * in all components. */
static void particles_on_a_line_have_no_strain(void) {
  static const char *const names[] = {"A.strain.xx", "A.strain.xy", "A.strain.yy", "A.strain.rotation"};
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "units none\nmaterial m density 1 kn 1\nstep 0.1\ndisc 0 0 radius 1 m velocity 1 2\ndisc 9 0 radius 1 m velocity "
      "3 4\n"
      "disc 20 0 radius 1 m\nregion A all\nrecord A.strain.xx A.strain.xy A.strain.yy A.strain.rotation\n"
      "stage s\ncycles 2\n");
  for (int k = 0; k < 4; k++)
    CU_ASSERT_EQUAL(written_last(&result, names[k]), 0);
  nb_result_free(&result), written_free(&it);
}

void suite_edges(void) {
  CU_pSuite suite = CU_add_suite("edges", NULL, NULL);
  CU_ADD_TEST(suite, a_region_at_the_corner_of_a_cell);
  CU_ADD_TEST(suite, a_count_may_be_rounded);
  CU_ADD_TEST(suite, a_cell_stays_wide_enough_or_not);
  CU_ADD_TEST(suite, straining_reduces_the_travel_limit);
  CU_ADD_TEST(suite, released_particles_do_not_rotate_under_rotation_off);
  CU_ADD_TEST(suite, fixed_particles_are_no_part_of_a_boundary);
  CU_ADD_TEST(suite, a_servo_of_the_box_does_not_strain_a_boundary);
  CU_ADD_TEST(suite, the_last_step_of_a_segment_is_recorded);
  CU_ADD_TEST(suite, a_force_deep_in_the_contact_is_found);
  CU_ADD_TEST(suite, an_overlap_of_0_is_no_contact);
  CU_ADD_TEST(suite, at_time_0_velocities_are_those_of_the_page);
  CU_ADD_TEST(suite, particles_on_a_line_have_no_strain);
}
