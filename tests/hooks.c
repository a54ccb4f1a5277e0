/* The hooks of a cycle: a scene has exactly those that it uses, in order, as long as it uses them. The passes of
 * material pairs are tested in the same way.
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
      {DISC "record energy.balance\nstage a\ncycles 4\n",
       "0 energy balance, 1 energy balance, 3 stability check, 4 energy balance"},
      {DISC "record step.fracc\nstage a\ncycles 4\n", "3 stability check, 4 FRACC"},
      {SPHERES "record cycle\nstage a\ncycles 4\n",
       "3 stability check, 4 stability check of stiffening contacts, 4 count of deep overlaps"},
      {"units none\nmaterial m density 1 young 100\nnormal hertz\nstep 1e-3\nsphere 4 4 radius 1 m\n"
       "sphere 6 4 radius 1 m\nrecord cycle\nstage a\ncycles 4\n",
       "3 stability check, 4 stability check of stiffening contacts, 4 count of deep overlaps"},
      {"units none\nmaterial m density 1 young 100 ks 1\nnormal hertz\nshear linear\nstep 1e-3\nsphere 4 4 radius 1 m\n"
       "sphere 6 4 radius 1 m\nrecord cycle\nstage a\ncycles 4\n",
       "3 stability check, 4 count of deep overlaps"},
      {"units none\nmaterial m density 1 young 100\nnormal hertz_increment\nstep 1e-3\nsphere 4 4 radius 1 m\n"
       "sphere 6 4 radius 1 m\nrecord cycle\nstage a\ncycles 4\n",
       "3 stability check, 4 count of deep overlaps"},
      {DISC "record D.x\nbox 0 0 to 8 8 m\nstage a\nbox strain 0.1 0.1\ncycles 4\n",
       "0 walls of the box follow its strain rate, 3 stability check"},
      {DISC "record D.x\nbox 0 0 to 8 8 m\nstage a\nservo mean 1 on box through box at most 0.1\ncycles 4\n",
       "0 servo, 0 walls of the box follow its strain rate, 3 stability check"},
      {DISC "record D.x\nbox 0 0 to 8 8 m\nstage a\ncycles 4\nstage b\nbox strain 0.1 0.1\ncycles 4\n",
       "3 stability check"},
      {DISC "record D.x\nperiodic cell 0 0 to 9 9\nstage a\ncycles 4\n", "3 stability check"},
      {DISC "record D.x\nperiodic cell 0 0 to 9 9\nstage a\ncell strain 0.1 0.1\ncycles 4\n",
       "0 affine motion, 3 stability check"},
      {DISC "record D.x\nperiodic cell 0 0 to 9 9\nstage a\nservo mean 1 on cell through cell at most 0.1\ncycles 4\n",
       "0 servo, 0 affine motion, 3 stability check"},
      {DISC "record D.x\nstage a\ncycles 4\nstage b\naffine strain 0.1 0.1\ncycles 4\n", "3 stability check"},
      {DISC "record D.x\nstage a\ncycles 4\nstage b\nboundary circle 5 4 radius 0.5\ncycles 4\n", "3 stability check"},
      {RING "record D.x\nstage a\ncycles 4\n", "0 boundary takes in particles, 3 stability check"},
      {RING "record D.x\nstage a\nboundary stress 1 1\ncycles 4\n",
       "1 strain and stress of the boundary, 3 stability check"},
      {DISC "record D.x\nstage a\nrotation off\ncycles 4\n", "3 stability check"},
      {DISC "record D.x\nstage a\naffine strain 0.1 0.1\ncycles 4\n", "0 affine motion, 3 stability check"},
      {RING "record D.x\nstage a\nboundary strain 0.1 0.1\ncycles 4\n",
       "0 boundary takes in particles, 0 affine motion, 1 strain and stress of the boundary, 3 stability check"},
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
  words_add(
      &page, DISC
      "wall w 0 0 to 9 0 m\nrecord D.x\nstage a\nramp gravity 0 -1\ncycles 4\nstage b\ncycles 4\nstage c\ngravity 0 0\n"
      "cycles 4\nstage d\nramp wall w velocity 0 1\ncycles 1\nstage e\ncycles 1\n");
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
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[3], &error), NB_OK);
  is(model, "0 walls ramp, 3 stability check");
  CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[4], &error), NB_OK);
  is(model, "3 stability check");
  nb_model_free(model);
  written_free(&it);
}

/* The passes of every material pair, in their order, each with the line of the page that requires it. */
static void list_passes(char *text, size_t size, const struct nb_model *model) {
  text[0] = 0;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_material_pair *pair = &model->material_pairs[p];
    size_t length = strlen(text);
    snprintf(text + length, size - length, "%s%d-%s%d:", p ? "; " : "", pair->a, pair->wall ? "wall " : "", pair->b);
    for (int k = 0; k < pair->pass_count; k++) {
      length = strlen(text);
      snprintf(text + length, size - length, "%s %s %d", k ? "," : "", pair->passes[k].name, pair->passes[k].line);
    }
  }
}

static void has_passes(const struct nb_model *model, const char *expected) {
  char text[1024];
  list_passes(text, sizeof text, model);
  if (strcmp(text, expected) != 0)
    printf("# %s\n# but expected: %s\n", text, expected);
  CU_ASSERT_STRING_EQUAL(text, expected);
}

static void passes_and_their_lines(void) {
  static const struct {
    const char *scene, *passes;
  } rows[] = {
      {DISC "periodic cell 0 0 to 9 9\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-image, overlap 7, normal linear 0, resolve, normal 0"},
      {DISC "wall v 0 0 to 9 0 m\nwall w 9 0 to 9 9 m\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0; 0-wall 0: disc-wall, overlap 0, single contact "
       "at wall vertices 0, normal linear 0, resolve, normal 0"},
      {SPHERES "record cycle\ndamping ratio 0.1\nwall w 9 0 to 9 9 m\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap and both increments 0, normal hertz 4, shear mindlin 5, large overlaps 0, dashpots, "
       "damping ratio 10, resolve, normal and shear 0; 0-wall 0: disc-wall, overlap and both increments 0, normal "
       "hertz 4, shear mindlin 5, large overlaps 0, dashpots, damping ratio 10, resolve, normal and shear 0"},
      {SPHERES "record cycle\nstage a\ncycles 4\nstage b\ndamping critical beyond overlap 0.1\ncycles 4\n",
       "0-0: disc-disc, overlap and both increments 0, normal hertz 4, shear mindlin 5, large overlaps 0, resolve, "
       "normal "
       "and shear 0"},
      {SPHERES "record cycle\nstage a\ndamping critical beyond overlap 0.1\ncycles 4\n",
       "0-0: disc-disc, overlap and both increments 0, normal hertz 4, shear mindlin 5, large overlaps 11, dashpots, "
       "critical "
       "beyond overlap 11, resolve, normal and shear 0"},
      {DISC "damping ratio 0.1\nrecord cycle\nstage a\ncycles 4\nstage b\ndamping stiffness 0.1\ncycles 4\n",
       "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots, damping ratio 7, resolve, normal 0"},
      {DISC "record cycle\nstage a\ndamping ratio 0.1\ncycles 4\nstage b\ndamping stiffness 0.1\ncycles 4\n",
       "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots, damping ratio 9, resolve, normal 0"},
      {DISC "damping stiffness 0.1\ndamping walls ratio 0.1\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots, damping ratio 7, resolve, normal 0"},
      {DISC "damping walls ratio 0.1\ndamping none\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
      {DISC "damping ratio 0.1\ndamping walls none\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots, damping ratio 7, resolve, normal 0"},
      {DISC "damping walls none\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
      {DISC "damping mass 0.1\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
      {DISC "periodic cell 0 0 to 9 9\ndamping ratio 0.1\ndamping centred\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-image, overlap and normal increment 7, normal linear 0, dashpots, damping ratio, centred 8, resolve, "
       "normal 0"},
      {DISC "periodic cell 0 0 to 9 9\nshear linear\npair m m cohesion 2\ndamping stiffness 0.1\ndamping centred\n"
            "record cycle\nstage a\ncycles 4\n",
       "0-0: disc-image, overlap and both increments 7, normal linear 0, shear linear 8, dashpots, centred 10, "
       "resolve, "
       "normal and shear 0"},
      {SPHERES "record cycle\ndamping critical beyond overlap 0.1\ndamping centred\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap and both increments 0, normal hertz 4, shear mindlin 5, large overlaps 10, dashpots, "
       "critical beyond overlap, centred 10, resolve, normal and shear 0"},
      {DISC "shear linear\npair m m cohesion 2\nrecord cycle\nstage a\ncycles 4\n",
       "0-0: disc-disc, overlap and both increments 0, normal linear 0, shear linear 7, resolve, normal and shear 0"},
      {DISC "record cycle\nstage a\ncycles 4\nstage b\ndamping walls stiffness 0.1\ncycles 4\n",
       "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "%s", rows[r].scene);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    has_passes(model, rows[r].passes);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The forces at the time at which a stage begins are those of the previous stage. So the passes of the stage run from
 * its first cycle on. */
static void passes_of_a_stage(void) {
  static const struct {
    const char *hooks, *passes;
  } stages[] = {
      {"3 stability check", "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
      {"2 changes of the stage, 3 stability check",
       "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots 12, resolve, normal 0"},
      {"2 changes of the stage, 3 stability check", "0-0: disc-disc, overlap and normal increment 0, normal linear 0, "
                                                    "dashpots, damping ratio 15, resolve, normal 0"},
      {"3 stability check", "0-0: disc-disc, overlap and normal increment 0, normal linear 0, dashpots, damping ratio "
                            "15, resolve, normal 0"},
      {"2 changes of the stage, 3 stability check", "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0"},
  };
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, DISC "disc 5.9 4 radius 1 m\nrecord D.x\nstage a\ncycles 2\nstage b\ndamping stiffness 0.01\n"
                        "cycles 2\nstage c\ndamping ratio 0.1\ncycles 2\nstage d\ndamping mass 1\ncycles 2\n"
                        "stage e\ndamping none\ncycles 2\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  has_passes(model, stages[0].passes);
  for (size_t s = 0; s < sizeof stages / sizeof *stages; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    is(model, stages[s].hooks);
    for (int cycle = 0; cycle < 2; cycle++) {
      CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
      is(model, "3 stability check");
      has_passes(model, stages[s].passes);
    }
  }
  nb_model_free(model);
  written_free(&it);
}

/* The resolution of the coordinates is tested during the run, too. Two discs that overlap by 1.05e-9 move past the
 * coordinate 8192, beyond which the resolution is 1.8e-12 instead of 9e-13; the limit is a thousandth of the overlap. */
static void particles_that_move_too_far(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-9\nstep 1\ndisc 8191 0 radius 1 m velocity 0.04 0\n"
                   "disc 8191 1.99999999895 radius 1 m velocity 0.04 0\nrecord cycle\nstage a\ncycles 60\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 20);
  CU_ASSERT_EQUAL(model->warnings.count, 0);
  written_cycles(model, 40);
  CU_ASSERT_EQUAL_FATAL(model->warnings.count, 1);
  CU_ASSERT_PTR_NOT_NULL(strstr(model->warnings.list[0].text, "has a resolution (ulp) of 1.81899e-12"));
  nb_model_free(model);
  written_free(&it);
}

/* The affine motion is a hook during its stage, and in the first cycle of the next stage, in which the imposed velocity
 * is subtracted. */
static void affine_motion_of_a_stage(void) {
  static const char *const begin[] = {"3 stability check", "0 affine motion, 3 stability check",
                                      "0 affine motion, 2 changes of the stage, 3 stability check"};
  static const char *const scenes[] = {
      "stage a\ncycles 2\nstage b\naffine strain 0.1 0.1\ncycles 2\nstage c\naffine none\ncycles 2\n",
      "periodic cell 0 0 to 9 9\nstage a\ncycles 2\nstage b\ncell strain 0.1 0.1\ncycles 2\nstage c\ncell strain 0 0\n"
      "cycles 2\n"};
  for (int cell = 0; cell < 2; cell++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, DISC "record D.x\n%s", scenes[cell]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int s = 0; s < 3; s++) {
      const double x = model->particles.position[0].x;
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      is(model, begin[s]);
      written_cycles(model, 2);
      is(model, begin[s % 2]);
      CU_ASSERT_EQUAL(model->particles.position[0].x == x, s != 1);
    }
    CU_ASSERT_EQUAL(model->particles.velocity[0].x, 0);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Whether the model has memory for rotation, and whether it integrates rotation in each stage. */
static void rotation_of_a_stage(void) {
  static const struct {
    const char *scene;
    bool memory, rotates[3];
  } rows[] = {
      {"shear linear\nstage a\ncycles 2\n", false, {false}},
      {"pair m m friction 0.5\nstage a\ncycles 2\n", false, {false}},
      {"shear linear\npair m m friction 0.5\nstage a\ncycles 2\n", true, {true}},
      {"shear linear\npair m m cohesion 1\nstage a\ncycles 2\n", true, {true}},
      {"shear linear\nstage a\ncycles 2\nstage b\nmaterial m friction 1\ncycles 2\n", true, {false, true}},
      {"shear linear\nstage a\ncycles 2\nstage b\nmaterial m cohesion 1\ncycles 2\n", true, {false, true}},
      {"shear linear\nstage a\ncycles 2\nstage b\npair m m friction 1\ncycles 2\n", true, {false, true}},
      {"shear linear\nstage a\ncycles 2\nstage b\npair m m cohesion 1\ncycles 2\n", true, {false, true}},
      {"material n density 1 kn 100 friction 1\nshear linear\nstage a\ncycles 2\n", true, {false}},
      {"material n density 1 kn 100 cohesion 1\nshear linear\nstage a\ncycles 2\n", true, {false}},
      {"pair m m friction 1\nstage a\ncycles 2\nstage b\nshear linear\ncycles 2\n", true, {false, true}},
      {"shear linear\npair m m friction 1\nstage a\nrotation off\ncycles 2\n", false, {false}},
      {"shear linear\npair m m friction 1\nstage a\nrotation off\ncycles 2\nstage b\nrotation on\ncycles 2\n"
       "stage c\nrotation off\ncycles 2\n",
       true,
       {false, true, false}},
      {"disc 1 1 radius 1 m spin 1\nstage a\ncycles 2\nstage b\nrotation off\ncycles 2\n", true, {true, false}},
      {"disc 1 1 radius 1 m spin 1 fixed\nstage a\nrotation off\ncycles 2\n", true, {true}},
      {"disc 1 1 radius 1 m spin -1\nstage a\ncycles 2\n", true, {true}},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks 100\nstep 0.01\ndisc 4 4 radius 1 m\n"
              "disc 5.9 4 radius 1 m\nrecord cycle\n%s",
              rows[r].scene);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(model->particles.spin != NULL, rows[r].memory);
    for (size_t s = 0; s < it.scene.stage_count; s++) {
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
      written_cycles(model, 2);
      CU_ASSERT_EQUAL(model->plan.rotates, rows[r].rotates[s]);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* `accumulated-twice` adds a pass to the contacts between particles, if another pass reads the increments. */
static void passes_of_affine_motion_twice(void) {
  static const char *const scenes[] = {DISC, DISC "damping stiffness 0.1\n",
                                       DISC "shear linear\npair m m cohesion 2\n"};
  static const char *const passes[] = {
      "0-0: disc-disc, overlap 0, normal linear 0, resolve, normal 0; 0-wall 0: disc-wall, overlap 0, normal linear 0, "
      "resolve, normal 0",
      "0-0: disc-disc, overlap and normal increment 0, affine motion again, normal increment 0, normal linear 0, "
      "dashpots "
      "7, resolve, normal 0; 0-wall 0: disc-wall, overlap and normal increment 0, normal linear 0, dashpots 7, "
      "resolve, "
      "normal 0",
      "0-0: disc-disc, overlap and both increments 0, affine motion again, both increments 0, normal linear 0, shear "
      "linear 7, resolve, normal and shear 0; 0-wall 0: disc-wall, overlap and both increments 0, normal linear 0, "
      "shear "
      "linear 7, resolve, normal and shear 0"};
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, "%swall w 9 0 to 9 9 m\nrecord cycle\nstage a\naffine strain 0.1 0 accumulated-twice\ncycles 4\n",
              scenes[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 1);
    has_passes(model, passes[k]);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A plan keeps the sum of the radii, what something reads later, and what a pass computes from constants of the contact:
 * with dashpots by damping ratio the roots of M* k if k is constant, else M*; for elastic spheres R* and the overlap up to
 * which the step is stable. Without friction there is no field of the shear force before the step, and without a law with
 * micro-slip none of its dissipation. Without dashpots the total normal force is the normal force. */
static void fields_that_a_plan_keeps(void) {
  enum {
    REDUCED = NB_BIT(NB_REDUCED),
    ROOT = NB_BIT(NB_NORMAL_ROOT),
    STABLE = NB_BIT(NB_STABLE_OVERLAP),
    STORED = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_STIFFNESS) | NB_BIT(NB_RADIUS),
    BALANCE = STORED | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_TANGENTIAL_INCREMENT) | NB_BIT(NB_SHEAR) |
              NB_BIT(NB_SHEAR_STIFFNESS) | NB_BIT(NB_SLIDING),
    BEFORE = NB_BIT(NB_SHEAR_BEFORE) | NB_BIT(NB_SHEAR_STIFFNESS_BEFORE)
  };
#define ROUGH DISC "shear linear\npair m m cohesion 2\n"
#define MICRO                                                                                                          \
  "units none\nmaterial m density 1 young 100 friction 0.3\nnormal hertz\nstep 1e-3\nsphere 4 4 radius 1 m\n"
  static const struct {
    const char *scene;
    unsigned kept;     /* besides the sum of the radii */
    int normal, shear; /* doubles of contact history */
  } rows[] = {
      {DISC "record cycle\n", 0, 0, 0},
      {ROUGH "record cycle\n", 0, 0, 1},
      {DISC "damping stiffness 0.1\nrecord cycle\n", 0, 0, 0},
      {DISC "damping ratio 0.1\nrecord cycle\n", ROOT, 0, 0},
      {ROUGH "damping ratio 0.1\nrecord cycle\n", ROOT | NB_BIT(NB_SHEAR_ROOT), 0, 1},
      {SPHERES "record cycle\n", REDUCED | STABLE, 0, 1},
      {SPHERES "damping stiffness 0.1\nrecord cycle\n", REDUCED | STABLE, 0, 1},
      {SPHERES "damping ratio 0.1\nrecord cycle\n", REDUCED | STABLE | NB_BIT(NB_MASS), 0, 1},
      {SPHERES "damping critical beyond overlap 0.1\nrecord cycle\n", REDUCED | STABLE | NB_BIT(NB_MASS), 0, 1},
      {MICRO "record cycle\n", REDUCED | STABLE, 0, 0},
      {DISC "record energy.balance\n", BALANCE, 0, 0},
      {DISC "damping stiffness 0.1\nrecord energy.balance\n", BALANCE | NB_BIT(NB_TOTAL_NORMAL), 0, 0},
      {ROUGH "record energy.balance\n", BALANCE | BEFORE, 0, 1},
      {MICRO "shear mindlin_deresiewicz memory 8\nrecord energy.balance\n",
       BALANCE | BEFORE | NB_BIT(NB_DISSIPATED) | REDUCED | STABLE, 0, 12 + 5 * 8},
      {"units none\nmaterial m density 1 young 100\nnormal hertz_increment\nstep 1e-3\nsphere 4 4 radius 1 m\n"
       "record cycle\n",
       REDUCED, 1, 0},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "%sstage a\ncycles 4\n", rows[r].scene);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    if (model->plan.kept != (rows[r].kept | NB_BIT(NB_RADIUS_SUM)))
      printf("# %s: %x, expected %x\n", rows[r].scene, model->plan.kept, rows[r].kept | NB_BIT(NB_RADIUS_SUM));
    CU_ASSERT_EQUAL(model->plan.kept, (rows[r].kept | NB_BIT(NB_RADIUS_SUM)));
    CU_ASSERT_EQUAL(model->plan.history.normal, rows[r].normal);
    CU_ASSERT_EQUAL(model->plan.history.shear, rows[r].shear);
    CU_ASSERT_EQUAL(model->plan.history.slip_sum, 0);
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_hooks(void) {
  CU_pSuite suite = CU_add_suite("hooks", NULL, NULL);
  CU_add_test(suite, "a scene has exactly the hooks that it uses", a_scene_has_what_it_uses);
  CU_add_test(suite, "hooks end with their work", hooks_end_with_their_work);
  CU_add_test(suite, "passes of the material pairs, with their lines", passes_and_their_lines);
  CU_add_test(suite, "passes of a stage", passes_of_a_stage);
  CU_ADD_TEST(suite, passes_of_affine_motion_twice);
  CU_ADD_TEST(suite, fields_that_a_plan_keeps);
  CU_ADD_TEST(suite, particles_that_move_too_far);
  CU_add_test(suite, "affine motion of a stage", affine_motion_of_a_stage);
  CU_add_test(suite, "rotation of a stage", rotation_of_a_stage);
}
