/* The hooks of a cycle: a scene has exactly those that it uses, in order, as long as it uses them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "../src/run/plan.h"
#include "suites.h"
#include "written.h"

#define DISC "units none\nmaterial m density 1 kn 100\nstep 0.01\ndisc 4 4 radius 1 m\nmonitor D disc 1\n"
#define SPHERES                                                                                                        \
  "units none\nmaterial m density 1 young 100 friction 0.3\nnormal hertz\nshear mindlin\nstep 1e-3\nsphere 4 4 "       \
  "radius 1 m\nsphere 6 4 radius 1 m\n"
#define RING DISC "disc 6 4 radius 1 m\nboundary circle 5 4 radius 0.5\n"

/* All hooks in order, each with its place in the cycle: "3 stability check". */
static void list(char *text, size_t size, const struct nb_model *model) {
  text[0] = 0;
  for (int when = 0; when < NB_WHENS; when++)
    for (size_t h = 0; h < model->hooks[when].count; h++) {
      const size_t length = strlen(text);
      snprintf(text + length, size - length, "%s%d %s", length ? ", " : "", when, model->hooks[when].list[h].name);
    }
}

static void is(const struct nb_model *model, const char *expected) {
  char text[1024];
  list(text, sizeof text, model);
  if (strcmp(text, expected) != 0)
    printf("# %s\n# but expected: %s\n", text, expected);
  CU_ASSERT_STRING_EQUAL(text, expected);
}

static void a_scene_has_what_it_uses(void) {
  static const struct {
    const char *scene, *hooks;
  } rows[] = {
      {DISC "record D.x\nstage a\ncycles 4\n", "3 stability check"},
      {DISC "record D.x\nwall w 0 0 to 9 0 m\nstage a\nramp wall w velocity 0 1\ncycles 4\n",
       "0 walls ramp, 3 stability check"},
      {DISC "record D.x\nstage a\ngravity 0 -1\ncycles 4\n", "2 changes of the stage, 3 stability check"},
      {DISC "record energy.residual\nstage a\ncycles 4\n",
       "0 energy balance, 1 energy balance, 3 stability check, 4 energy balance"},
      {DISC "record step.fracc\nstage a\ncycles 4\n", "3 stability check, 4 FRACC"},
      {SPHERES "record cycle\nstage a\ncycles 4\n",
       "3 stability check, 4 stability check of stiffening contacts, 4 count of deep overlaps"},
      {DISC "record D.x\nbox 0 0 to 8 8 m\nstage a\nbox strain 0.1 0.1\ncycles 4\n",
       "0 walls of the box follow its strain rate, 0 affine motion, 3 stability check"},
      {DISC "record D.x\nstage a\naffine strain 0.1 0.1\ncycles 4\n", "0 affine motion, 3 stability check"},
      {RING "record D.x\nstage a\nboundary strain 0.1 0.1\ncycles 4\n",
       "0 boundary takes in particles, 0 affine motion, 1 stress on the boundary, 3 stability check"},
      {DISC "record D.x\nstage a\nsnapshot from a\ncycles 4\n", "3 stability check, 4 sliding since a stage"},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "%s", rows[r].scene);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    is(model, rows[r].hooks);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Gravity that ramps over four cycles changes in each of them and in no later one, until another stage changes it. */
static void hooks_end_with_their_work(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, DISC "record D.x\nstage a\nramp gravity 0 -1\ncycles 4\nstage b\ncycles 4\nstage c\ngravity 0 0\n"
                        "cycles 4\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  is(model, "3 stability check");
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int cycle = 0; cycle < 4; cycle++) {
    is(model, "2 changes of the stage, 3 stability check");
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
  }
  is(model, "3 stability check");
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  is(model, "3 stability check");
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[2], &error), NB_OK);
  is(model, "2 changes of the stage, 3 stability check");
  CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
  is(model, "3 stability check");
  nb_model_free(model);
  written_free(&it);
}

void suite_hooks(void) {
  CU_pSuite suite = CU_add_suite("hooks", NULL, NULL);
  CU_add_test(suite, "a scene has what it uses", a_scene_has_what_it_uses);
  CU_add_test(suite, "hooks end with their work", hooks_end_with_their_work);
}
