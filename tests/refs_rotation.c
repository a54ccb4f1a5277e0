/* The reference rotation_off: stages that end after the disc has stopped sliding, with and without rotation.
 *
 * A disc with R = 1 slides on a floor. It starts with v = 4 and without spin. The deceleration by friction is mu g = 1,
 * and q = m R^2/I = 2.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

static void slide_in(struct written *it, struct refs_scene *scene, const char *stages) {
  struct words page = {0};
  words_add(&page,
            "units none\nmaterial m density 1 kn 1e9 ks 1e9 friction 0.5\nnormal linear\nshear linear\ngravity 0 -2\n"
            "disc 0 1 radius 1 m velocity 4 0\nwall floor -9 0 to 99 0 m\nmonitor D disc 1\n"
            "monitor C disc 1 with wall floor\nstep 0.5\n%s",
            stages);
  written_scene(it, &page);
  scene->scene = it->scene;
}

static void a_disc_that_cannot_rotate_slides_until_it_stops(void) {
  struct written it;
  struct refs_scene scene;
  slide_in(&it, &scene,
           "stage stiff\nrotation off\ncycles 2\nstage stop\nuntil C.sliding below 0.5 at most 999 cycles\n"
           "stage rest\ncycles 10\n");
  struct nb_solution solution = refs_solution("rotation_off", &scene);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx in stiff"), 3, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "time in stop"), 4, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx in stop"), 0, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx in rest"), 0, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.spin in rest"), 0, 1e-15);
  solution_free(&solution);
  written_free(&it);
}

static void a_disc_that_can_rotate_slides_until_it_rolls(void) {
  struct written it;
  struct refs_scene scene;
  slide_in(&it, &scene, "stage free\nuntil C.sliding below 0.5 at most 999 cycles\nstage roll\ncycles 2\n");
  struct nb_solution solution = refs_solution("rotation_off", &scene);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "time in free"), 4. / 3, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx in roll"), 8. / 3, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.spin in roll"), -8. / 3, 1e-14);
  solution_free(&solution);
  written_free(&it);
}

static void other_conditions_are_refused(void) {
  static const char *const conditions[] = {"D.vx below 3", "C.sliding above 0.5"};
  for (int k = 0; k < 2; k++) {
    struct written it;
    struct refs_scene scene;
    char stages[128];
    snprintf(stages, sizeof stages, "stage s\nuntil %s at most 999 cycles\n", conditions[k]);
    slide_in(&it, &scene, stages);
    CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("rotation_off", &scene).text, "sliding below"));
    written_free(&it);
  }
}

void suite_refs_rotation(void) {
  CU_pSuite suite = CU_add_suite("refs_rotation", NULL, NULL);
  CU_add_test(suite, "a disc that cannot rotate slides until it stops",
              a_disc_that_cannot_rotate_slides_until_it_stops);
  CU_add_test(suite, "a disc that can rotate slides until it rolls", a_disc_that_can_rotate_slides_until_it_rolls);
  CU_add_test(suite, "other conditions of `until` are refused", other_conditions_are_refused);
}
