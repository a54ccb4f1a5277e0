/* A state that fits the page is restored completely; all others are refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "continued.h"
#include "run/plan.h"
#include "state_text.h"
#include "suites.h"

/* The rules that `pair` statements of a stage make are in the state, which fits the page. A state with more rules than
 * the page can make does not fit. */
static void rules_of_stages_fit(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 100 ks 50 friction 0.3\nshear linear\ndisc 0 0 radius 1 m\n"
                   "record time\nstep 0.01\nstage a\npair m m friction 0.1\ncycles 1\nstage b\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  CU_ASSERT_EQUAL(saved.rule_count, 1);
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  it.scene.start.stages = 1;
  struct nb_model *next = nb_model_resume(&it.scene, NULL, &saved, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(next);
  CU_ASSERT(next->properties.rule_count == 1 && next->properties.rules[0].friction == 0.1);
  CU_ASSERT(isnan(next->properties.rules[0].kn) && next->material_pairs[0].values.friction == 0.1);
  it.scene.start.stages = 0;
  saved.rule_count++;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  nb_saved_free(&saved);
  nb_model_free(next), nb_model_free(model);
  written_free(&it);
}

/* Reads a scene of two stages, and captures the state at the end of the first one. */
static void capture(struct nb_saved *saved, struct written *it, const char *statements) {
  struct words page = {0};
  struct nb_error error;
  words_add(&page, "units none\n%srecord time\nstep 0.01\nstage a\ncycles 1\nstage b\ncycles 1\n", statements);
  written_scene(it, &page);
  struct nb_model *model = written_model(it, &(struct nb_options){.keep_all = true, .threads = 1});
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(saved, model, &error), NB_OK);
  CU_ASSERT_EQUAL(nb_saved_fits(saved, &it->scene, "a", &error), NB_OK);
  nb_model_free(model);
}

/* A state with other particles is refused: another radius, shape, material or mobility, one at a time. */
static void other_particles_do_not_fit(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  capture(&saved, &it,
          "material m density 1 kn 100\nmaterial n density 1 kn 100\ndisc 0 0 radius 1 m\ndisc 5 0 radius 1 n fixed\n");
  const struct nb_saved_particle was = saved.particles[1];
  struct nb_saved_particle others[4] = {was, was, was, was};
  others[0].radius = nextafter(1, 2), others[1].shape = NB_SPHERE, others[2].material = 0, others[3].mobility = NB_FREE;
  for (int k = 0; k < 4; k++) {
    saved.particles[1] = others[k];
    CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  }
  saved.particles[1] = was, saved.particles[0].radius = 2;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  saved.particles[0].radius = 1;
  saved.particles[1].mobility = NB_REMOVED; /* allowed only if the page removes particles */
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  it.scene.stages[1].removal_count = 1;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  it.scene.stages[1].removal_count = 0, saved.particles[1] = was;
  struct written fewer;
  struct nb_saved of_fewer;
  capture(&of_fewer, &fewer, "material m density 1 kn 100\nmaterial n density 1 kn 100\ndisc 0 0 radius 1 m\n");
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &fewer.scene, "a", &error), NB_BAD_USE);
  CU_ASSERT_EQUAL(nb_saved_fits(&of_fewer, &it.scene, "a", &error), NB_BAD_USE);
  nb_saved_free(&of_fewer), nb_saved_free(&saved);
  written_free(&fewer), written_free(&it);
}

/* A state is refused if a material or a wall has another name, or if a wall or a material is missing. */
static void other_names_do_not_fit(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  capture(&saved, &it,
          "material m density 1 kn 100\nmaterial n density 1 kn 100\ndisc 0 5 radius 1 m\nwall v -1 0 to 1 0 n\nwall w "
          "-1 -9 to 1 -9 n\n");
  char *const names[] = {saved.materials[0].name, saved.materials[1].name, saved.walls[0].name, saved.walls[1].name};
  for (int k = 0; k < 4; k++) {
    const char was = names[k][0];
    names[k][0] = 'x';
    CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
    names[k][0] = was;
  }
  saved.wall_count = 1;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  saved.wall_count = 2, saved.material_count = 1;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_BAD_USE);
  saved.material_count = 2;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  nb_saved_free(&saved);
  written_free(&it);
}

static void refused(const struct nb_saved *saved, const struct written *it, const char *text) {
  struct nb_error error;
  CU_ASSERT_EQUAL(nb_saved_fits(saved, &it->scene, "a", &error), NB_BAD_USE);
  CU_ASSERT_STRING_EQUAL(error.text, text);
}

/* A state is refused if its normal law, its shear law or its memory size is not that of the page at the end of the
 * saved stage. */
static void other_laws_do_not_fit(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  capture(&saved, &it,
          "material m density 1 young 100 poisson 0.2 friction 0.5\nnormal hertz\nshear mindlin_deresiewicz memory 5\n"
          "sphere 0 0 radius 1 m\n");
  strcpy(saved.normal, "hertz_increment");
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz_increment and shear mindlin_deresiewicz");
  strcpy(saved.normal, "hertz"), strcpy(saved.shear, "mindlin");
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz and shear mindlin");
  strcpy(saved.shear, "mindlin_deresiewicz"), saved.pieces = 6;
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz and shear mindlin_deresiewicz");
  saved.pieces = 5;
  strcpy(it.scene.stages[0].laws.shear, "randall");
  strcpy(it.scene.normal, "glue");
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz and shear mindlin_deresiewicz");
  strcpy(it.scene.normal, "hertz"), strcpy(it.scene.shear, "glue");
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz and shear mindlin_deresiewicz");
  strcpy(it.scene.shear, "mindlin_deresiewicz");
  /* With start.stages = 0 the laws before stage `a` count. */
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  it.scene.start.stages = 1;
  refused(&saved, &it, "a: expected the laws of the page, found normal hertz and shear mindlin_deresiewicz");
  it.scene.start.stages = 0;
  nb_saved_free(&saved);
  written_free(&it);
}

/* The message has the numbers of particles, walls and materials of the page. A state with an impact does not fit a page
 * without one. */
static void messages_about_states(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  capture(&saved, &it,
          "material m density 1 kn 100\nmaterial n density 1 kn 100\ndisc 0 5 radius 1 m\ndisc 4 5 radius 1 m\n"
          "disc 8 5 radius 1 m\nwall w -1 0 to 1 0 n\n");
  saved.particle_count--;
  refused(&saved, &it,
          "a: expected the state of 3 particles, 1 walls and 2 materials like those of the page, found another one");
  saved.particle_count++, saved.walls[0].name[0] = 'x';
  refused(
      &saved, &it,
      "a: expected the state of 3 particles, 1 walls and 2 materials with the names of the page, found another one");
  saved.walls[0].name[0] = 'w', saved.impact.is = true;
  refused(&saved, &it, "a: expected the state of a page without `impact`, found one with");
  saved.impact.is = false, it.scene.impact.line = 1;
  refused(&saved, &it, "a: expected the state of a page with `impact`, found one without");
  it.scene.impact.line = 0;
  struct nb_scene before = {.impact.line = 0}; /* the page from which this page starts */
  it.scene.start.scene = &before;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  struct nb_scene first = {.impact.line = 1}; /* the page from which that one starts */
  before.start.scene = &first;
  refused(&saved, &it, "a: expected the state of a page with `impact`, found one without");
  before.start.scene = NULL, before.impact.line = 1;
  refused(&saved, &it, "a: expected the state of a page with `impact`, found one without");
  it.scene.start.scene = NULL;
  nb_saved_free(&saved);
  written_free(&it);
}

/* A state is refused if it has a contact between two particles, or a particle and a wall, that are far apart. */
static void contacts_that_are_apart_do_not_fit(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  capture(&saved, &it,
          "material m density 1 kn 100\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\ndisc 9 0 radius 1 m\nwall w 50 -9 "
          "to 50 9 m\n");
  CU_ASSERT_EQUAL_FATAL(saved.contact_count, 1);
  it.scene.start.stages = 1;
  static const char *const texts[] = {
      "the state has a contact of particle 1 with particle 3, but these two do not touch",
      "the state has a contact of particle 1 with wall 1, but these two do not touch"};
  for (int wall = 0; wall < 2; wall++) {
    saved.contacts[0].wall = wall, saved.contacts[0].b = wall ? 0 : 2;
    CU_ASSERT_PTR_NULL(nb_model_resume(&it.scene, &(struct nb_options){.threads = 1}, &saved, &error));
    CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
    CU_ASSERT_STRING_EQUAL(error.text, texts[wall]);
  }
  saved.contacts[0].wall = false, saved.contacts[0].b = 2, saved.contacts[0].field[NB_OVERLAP] = 0; /* it has ended */
  struct nb_model *model = nb_model_resume(&it.scene, &(struct nb_options){.threads = 1}, &saved, &error);
  CU_ASSERT_PTR_NOT_NULL(model);
  nb_model_free(model);
  nb_saved_free(&saved);
  it.scene.start.stages = 0;
  written_free(&it);
}

/* Resumes the page from a state that differs from the page and must be refused. `drop` selects the difference: 0 none
 * (the state must be accepted), 1 and 2 the imposed motion, 3 the cell, 4 the boundary, 5 the rotation, 6 the pressure
 * on the boundary. */
static void resume_with_difference(const char *statements, int drop) {
  struct words words = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  const struct nb_options options = {.threads = 1};
  words_add(&words, "%s", statements);
  written_scene(&it, &words);
  struct nb_model *model = written_model(&it, &options);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 20);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  nb_model_free(model);
  const struct nb_saved whole = saved;
  struct nb_saved_imposed some[9] = {{.by = NB_AFFINE_NONE}};
  saved.imposed = some;
  saved.imposed_count = drop == 1 ? 1 : drop == 2 ? saved.particle_count : whole.imposed_count;
  saved.cell.is = saved.cell.is != (drop == 3);
  saved.ring.is = saved.ring.is || drop == 4;
  saved.rotates = saved.rotates && drop != 5;
  saved.ring.pressing = drop == 6;
  it.scene.start.stages = 1;
  model = nb_model_resume(&it.scene, &options, &saved, &error);
  if (drop ? model != NULL : model == NULL)
    printf("# %d: %s\n", drop, error.text);
  CU_ASSERT_EQUAL(error.status, drop ? NB_BAD_USE : NB_OK);
  if (drop)
    CU_ASSERT_STRING_EQUAL(
        error.text,
        "expected a state with the cell, the boundary, the imposed motion and the rotation of the page, found "
        "another one");
  nb_model_free(model);
  saved = whole;
  nb_saved_free(&saved);
  written_free(&it);
}

static void others_are_refused(void) {
  for (int drop = 0; drop <= 5; drop++)
    resume_with_difference(state_plain, drop);
  const int of_cells[] = {0, 1, 3}, of_rings[] = {0, 1, 3, 6};
  for (size_t k = 0; k < sizeof of_cells / sizeof *of_cells; k++)
    resume_with_difference(state_cell, of_cells[k]);
  for (size_t k = 0; k < sizeof of_rings / sizeof *of_rings; k++)
    resume_with_difference(state_ring, of_rings[k]);
}

/* Centred dashpots use the velocity at the time of the force. So a continued run needs the surface speed, spin times
 * radius, before its first step. The radius is not 1, so a missing factor would be found. */
static void centred_dashpots(void) {
  static const char *const dampings[] = {"ratio 0.2", "stiffness 0.004"};
  for (size_t k = 0; k < sizeof dampings / sizeof *dampings; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.9\nshear linear\ndamping %s\n"
              "damping centred\nlattice discs 2 by 2 m radius 0.5 spacing 0.99 from 0 0\nwall w -3 -0.49 to 3 -0.49 m\n"
              "gravity 0.2 -2\nstep 0.002\nrecord time energy.kinetic\nstage a\ncycles 15\nstage b\nstep "
              "0.0015\ncycles 10\n",
              dampings[k]);
    written_scene(&it, &page);
    continued_same(&it, dampings[k]);
    written_free(&it);
  }
}

/* The time of first touch, here after 0.4 of the first step, is part of the state: `impact.time` counts from it. */
static void an_impact_with_a_phase(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 young 1000 poisson 0.25\nnormal hertz\nsphere 0 1 radius 1 m\n"
                   "wall w -9 0 to 9 0 m\nmonitor C sphere 1 with wall w\nimpact C speed 0.1 angle 0.3 phase 0.4\n"
                   "step 40 per collision\nrecord C.overlap impact.time impact.slip\nstage a\ncycles 5\nstage b\n"
                   "cycles 5\n");
  written_scene(&it, &page);
  continued_same(&it, "impact with a phase");
  written_free(&it);
}

/* A disc slides over the common end of two walls, from wall a to wall b. Only one of its two contacts acts at a time;
 * the other one is suppressed. In one cycle the contact with b begins to act although it was suppressed in the previous
 * cycle. In a state a suppressed contact has no overlap. */
static void a_contact_that_begins_at_a_vertex(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  int passed = 0, suppressed = 0;
  words_add(&page, "units none\nmaterial m density 1 kn 100\nwall a -5 0 to 0 0 m\nwall b 0 0 to 5 -2 m\n"
                   "disc 0.3537 0.9248 radius 1 m velocity 0.928 -0.371\nrecord time\nstep 0.01\nstage a\ncycles 60\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int n = 0; n < 60; n++) {
    struct nb_saved saved;
    written_cycles(model, 1);
    CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
    for (size_t k = 0; k < saved.contact_count; k++) {
      CU_ASSERT(!saved.contacts[k].suppressed || saved.contacts[k].field[NB_OVERLAP] == 0);
      suppressed += saved.contacts[k].suppressed;
    }
    for (size_t c = 0; c < model->contacts.count; c++)
      passed += model->contacts.suppressed[c] && model->contacts.kept[NB_OVERLAP][c] > 0;
    nb_saved_free(&saved);
  }
  CU_ASSERT_EQUAL(passed, 1);
  CU_ASSERT(suppressed > 0);
  nb_model_free(model);
  written_free(&it);
}

/* The state contains properties of a contact in the last step: the shear stiffness, which the energy balance reads, and
 * which of two contacts at a wall vertex is suppressed. */
static void contacts_of_the_last_step_continue(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  int suppressed = 0, sheared = 0;
  words_add(&page, "units none\nmaterial m density 1 kn 100 ks 50 friction 0.3\nshear linear\n"
                   "disc 0.3 0.95 radius 1 m velocity 0.1 -0.2\ndisc -0.2 2.9 radius 1 m velocity 0.2 0\n"
                   "wall a -5 0 to 0 0 m\nwall b 0 0 to 5 -2 m\n"
                   "record energy.balance\nstep 0.01\nstage a\ncycles 3\nstage b\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  it.scene.start.stages = 1;
  struct nb_model *next = nb_model_resume(&it.scene, NULL, &saved, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(next);
  CU_ASSERT_EQUAL_FATAL(next->contacts.count, model->contacts.count);
  for (size_t c = 0; c < model->contacts.count; c++) {
    const double stiffness = model->contacts.kept[NB_SHEAR_STIFFNESS][c];
    CU_ASSERT_EQUAL(next->contacts.kept[NB_SHEAR_STIFFNESS_BEFORE][c], stiffness);
    CU_ASSERT_EQUAL(next->contacts.kept[NB_SHEAR_BEFORE][c], model->contacts.kept[NB_SHEAR][c]);
    CU_ASSERT_EQUAL(next->contacts.suppressed[c] & 1, model->contacts.suppressed[c] & 1);
    suppressed += model->contacts.suppressed[c] & 1, sheared += stiffness > 0;
  }
  CU_ASSERT_EQUAL(suppressed, 1);
  CU_ASSERT(sheared > 0);
  nb_saved_free(&saved);
  nb_model_free(next), nb_model_free(model);
  written_free(&it);
}

/* The whole history of a law is saved, even if its first variable is 0, as in a loaded contact that has not slipped.
 * Poisson's ratio has its largest value. */
static void a_history_that_begins_with_0(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 young 1000 poisson 0.5 friction 0.5\nnormal hertz\nshear "
                   "mindlin_scaled\nsphere 0 0 radius 1 m fixed\nsphere 1.99 0 radius 1 m\nstep 1e-4\nrecord time\n"
                   "stage a\ncycles 3\nstage b\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  CU_ASSERT_EQUAL_FATAL(saved.contact_count, 1);
  CU_ASSERT_EQUAL_FATAL(saved.contacts[0].shear.count, 2); /* T and a */
  CU_ASSERT(saved.history[saved.contacts[0].shear.at] == 0 && saved.history[saved.contacts[0].shear.at + 1] > 0);
  nb_saved_free(&saved);
  nb_model_free(model);
  continued_same(&it, "poisson 0.5");
  written_free(&it);
}

/* The first row of a continued run has the single-contact step 2 (m/k_n)^(1/2) of the present stiffness, m = 2 pi. */
static void the_single_contact_step_at_the_start(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  const struct nb_options options = {.keep_all = true, .threads = 1};
  words_add(&page, "units none\nmaterial m density 2 kn 100\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\nstep 1e-3\n"
                   "record step step.single-contact\nstage a\nmaterial m kn 400\ncycles 3\nstage b\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &options);
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  nb_model_free(model);
  it.scene.start.stages = 1;
  model = nb_model_resume(&it.scene, &options, &saved, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  CU_ASSERT_EQUAL(written_now(model, "step"), 1e-3);
  NEAR(written_now(model, "step.single-contact"), 2 * sqrt(2 * 3.14159265358979323846 / 400), 1e-15);
  nb_saved_free(&saved);
  nb_model_free(model);
  written_free(&it);
}

/* The laws of a checkpoint are those of its stage. */
static void checkpoints_of_stages(void) {
  static const struct {
    const char *stage, *shear;
    const char *error; /* NULL: the checkpoint fits */
  } rows[] = {{"a", "mindlin", NULL},
              {"b", "randall", NULL},
              {"a", "randall", "a: expected the laws of the page, found normal hertz and shear randall"},
              {"b", "mindlin", "a: expected the laws of the page, found normal hertz and shear mindlin"},
              {"x", "mindlin", "a: expected a stage of the page, found `x`"}};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  capture(
      &saved, &it,
      "material m density 1 young 100 poisson 0.2 friction 0.5\nnormal hertz\nshear mindlin\nsphere 0 0 radius 1 m\n");
  strcpy(it.scene.stages[1].laws.shear, "randall");
  saved.store.part_count = 1; /* this makes it a checkpoint */
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    strcpy(saved.stage, rows[k].stage), strcpy(saved.shear, rows[k].shear);
    if (rows[k].error)
      refused(&saved, &it, rows[k].error);
    else
      CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it.scene, "a", &error), NB_OK);
  }
  saved.store.part_count = 0;
  nb_saved_free(&saved);
  written_free(&it);
}

/* The state names the page and the stage; `-` stands for a page without a name and for the time before the first stage.
 * Walls and particles are those of the page. Without rotation spins and angles are 0. */
static void captured_values(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 100\nmaterial n density 1 kn 100\ndisc 0 5 radius 1 m\n"
                   "disc 9 5 radius 2 n fixed\nsphere 19 5 radius 3 n\nwall v -1 0 to 1 0 n\nwall w -1 -9 to 1 -9 m\n"
                   "record time\nstep 0.01\nstage a\nremove sphere 3\ncycles 1\n");
  written_scene(&it, &page);
  const struct nb_page *const own = it.scene.page;
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  it.scene.page = NULL;
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  CU_ASSERT_STRING_EQUAL(saved.page, "-");
  CU_ASSERT_STRING_EQUAL(saved.stage, "-");
  nb_saved_free(&saved);
  it.scene.page = own;
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  CU_ASSERT_STRING_EQUAL(saved.page, own->name);
  CU_ASSERT_STRING_EQUAL(saved.stage, "a");
  CU_ASSERT(saved.wall_count == 2 && saved.walls[0].material == 1 && saved.walls[1].material == 0);
  static const struct nb_saved_particle wanted[] = {
      {.shape = NB_DISC, .mobility = NB_FREE, .material = 0, .radius = 1, .position = {0, 5}},
      {.shape = NB_DISC, .mobility = NB_FIXED, .material = 1, .radius = 2, .position = {9, 5}},
      {.shape = NB_SPHERE, .mobility = NB_REMOVED, .material = 1, .radius = 3, .position = {19, 5}}};
  CU_ASSERT_EQUAL_FATAL(saved.particle_count, 3);
  for (int k = 0; k < 3; k++) {
    const struct nb_saved_particle *it_is = &saved.particles[k];
    CU_ASSERT(it_is->shape == wanted[k].shape && it_is->mobility == wanted[k].mobility);
    CU_ASSERT(it_is->material == wanted[k].material && it_is->radius == wanted[k].radius);
    CU_ASSERT(it_is->position.x == wanted[k].position.x && it_is->position.y == wanted[k].position.y);
    CU_ASSERT(it_is->spin == 0 && it_is->angle == 0);
  }
  nb_saved_free(&saved);
  nb_model_free(model);
  written_free(&it);
}

/* A checkpoint may have only the forces of contacts. A contact is saved if its force is not 0. Without dashpots the total
 * normal force is that of the law; here k_n times the overlap 0.1. */
static void contacts_with_a_force_are_saved(void) {
  static const struct {
    const char *disc, *velocity, *damping;
    size_t count;
  } rows[] = {{"1.9 0", "-1 0", "", 1},
              {"0 1.9", "0 -1", "", 1},
              {"1.9 0", "-1 0", "damping stiffness 0.01\n", 1},
              {"2.05 0", "-1 0", "", 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int all = 0; all < 2; all++) {
      struct words page = {0};
      struct written it;
      struct nb_saved saved;
      struct nb_error error;
      words_add(&page,
                "units none\nmaterial m density 1 kn 100\n%sdisc 0 0 radius 1 m fixed\ndisc %s radius 1 m velocity "
                "%s\nrecord time\nskin 1\nstep 1e-6\nstage a\ncycles 1\n",
                rows[k].damping, rows[k].disc, rows[k].velocity);
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = all, .threads = 1});
      continued_stages(model, 0, 1);
      CU_ASSERT_EQUAL(model->contacts.count, 1);
      CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
      CU_ASSERT_EQUAL(saved.contact_count, rows[k].count);
      if (saved.contact_count == 1 && all) {
        const double *field = saved.contacts[0].field;
        CU_ASSERT_DOUBLE_EQUAL(field[NB_NORMAL], 10, 1e-3);
        /* the dashpot adds 0.01 times k_n times the speed of approach */
        CU_ASSERT_DOUBLE_EQUAL(field[NB_TOTAL_NORMAL] - field[NB_NORMAL], rows[k].damping[0] ? 1 : 0,
                               rows[k].damping[0] ? 1e-3 : 0);
      }
      nb_saved_free(&saved);
      nb_model_free(model);
      written_free(&it);
    }
}

/* A contact with a history is saved, even if it has no force and its overlap is not kept. */
static void contacts_with_a_history_are_saved(void) {
  for (int kind = 0; kind < 3; kind++) {
    struct words page = {0};
    struct written it;
    struct nb_saved saved;
    struct nb_error error;
    words_add(&page, "units none\nmaterial m density 1 friction 0.3 young 5000 poisson 0.2\nnormal hertz_increment\n"
                     "shear mindlin_scaled\nsphere 0 0 radius 1 m\nsphere 2.05 0 radius 1 m\nrecord time\nskin 1\n"
                     "step 1e-6\nstage a\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    continued_stages(model, 0, 1);
    CU_ASSERT_EQUAL_FATAL(model->contacts.count, 1);
    if (kind > 0)
      (kind == 1 ? model->contacts.normal_history : model->contacts.shear_history).field[0][0] = 3;
    CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
    CU_ASSERT_EQUAL_FATAL(saved.contact_count, kind > 0);
    if (kind > 0) {
      const struct nb_saved_contact *contact = &saved.contacts[0];
      CU_ASSERT((contact->normal.count > 0) == (kind == 1) && (contact->shear.count > 0) == (kind == 2));
      CU_ASSERT_EQUAL(saved.history[0], 3);
    }
    nb_saved_free(&saved);
    nb_model_free(model);
    written_free(&it);
  }
}

/* An ended boundary is not saved. An empty one is saved without members. */
static void ended_and_empty_boundaries(void) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nboundary circle 0 0 radius 3\nrecord "
                   "time\nstep 0.01\nstage a\nboundary fixed\ncycles 1\nstage b\nboundary none\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (size_t s = 0; s < 2; s++) {
    continued_stages(model, s, s + 1);
    CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
    CU_ASSERT(saved.ring.is == (s == 0) && saved.ring.member_count == 0);
    nb_saved_free(&saved);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Small scenes whose states together contain every kind of record. Most stages are followed by a stage that changes little
 * but the step, so the state must have everything that the first of the two stages has set. */
static const struct {
  const char *what, *page;
} small[] = {
    {"a boundary",
     "units none\nmaterial m density 3 kn 4000 ks 3000 friction 0.3\nshear linear\n"
     "lattice discs 3 by 3 m radius 1 spacing 1.99 from -2 -2\nboundary circle 0.1 -0.2 radius 2.4\nstep 0.001\n"
     "record time boundary.radius boundary.stress.xy energy.kinetic\n"
     "stage a\nboundary strain 0.1 -0.1 c12 0.03 c21 0.01\naffine strain 1e-4 per cycle 2e-4 per cycle shear 3e-4 per "
     "cycle\nrotation off\ngravity centripetal 2 about 1 0.5\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"
     "stage b\naffine strain 1e-4 per cycle 0 per cycle accumulated\nrotation on\nboundary stress 3 2 shear 1\ncycles "
     "10\nstage b-on\nstep 0.001\ncycles 10\n"
     "stage c\nboundary strain 0.1 0.2\naffine strain 1e-4 per cycle 0 per cycle accumulated-twice\ncycles 10\n"
     "stage c-on\nstep 0.0009\ncycles 10\n"
     "stage d\nservo isotropic 20 on boundary through boundary affine at most 1e-5 per cycle every 3 cycles\ncycles "
     "10\n"
     "stage d-on\nstep 0.001\ncycles 10\nstage e\nremove discs 5 to 6\ncycles 10\nstage e-on\nstep 0.0008\ncycles 10\n"
     "stage f\nboundary none\naffine none\ncycles 10\nstage f-on\nstep 0.001\ncycles 10\n"},
    {"a cell", "units none\nmaterial m density 3 kn 4000 ks 3000 friction 0.3\nshear linear\n"
               "lattice discs 3 by 3 m radius 1 spacing 1.99 from 0.1 0.2\nperiodic cell 0 0 to 5.97 5.97\nstep 0.001\n"
               "record time cell.xy cell.stress.xy energy.kinetic\n"
               "stage a\ncell strain 0.1 -0.1 c12 0.3 c21 0.02\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"
               "stage b\nreverse velocities\nrotation off\ncycles 10\nstage b-on\nstep 0.001\ncycles 10\n"},
    {"a box",
     "units none\nmaterial m density 3 kn 4000 ks 3000 friction 0.3\nshear linear\nbox 0 0 to 3.98 3.97 m\n"
     "lattice discs 2 by 2 m radius 1 spacing 1.985 from 1 0.99\nstep 0.001\nrecord time box.width box.stress.xx\n"
     "stage a\nbox strain 0.1 -0.2\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"
     "stage b\nservo mean 20 on box through box at most 1e-5 per cycle\ndamping mass 2\ncycles 10\n"
     "stage b-on\ndamping mass 1\nstep 0.001\ncycles 10\n"},
    {"one particle",
     "units none\nmaterial m density 3 kn 4000\ndisc 1 0.99 radius 1 m\nwall w -5 0 to 5 0 m\nstep 0.001\nrecord "
     "time\nstage a\naffine strain 0.1 -0.2\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"},
    {"histories of both forces",
     "units none\nmaterial m density 3 friction 0.3 young 5000 poisson 0.2\nnormal hertz_increment\nshear "
     "mindlin_scaled\nwall w -5 0 to 5 0 m\nlattice spheres 2 by 1 m radius 1 spacing 1.99 from 0 0.995\n"
     "gravity 1 -1\nstep 0.001\nrecord time\nstage a\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"},
    {"walls, properties and a change of the law",
     "units none\nmaterial m density 3 friction 0.3 young 5000 poisson 0.2\nmaterial n density 2 friction 0.4 young "
     "7000 poisson 0.3\npair m n friction 0.2\nnormal hertz\nshear mindlin\ndamping ratio 0.1\ndamping centred\n"
     "wall w -5 0 to 5 0 m about 1 0.1 spin 0.02 velocity 0.1 0.2\nwall v -1 -9 to -1 9 n about -3 1\n"
     "lattice spheres 2 by 2 m radius 1 spacing 1.99 from -0.01 0.995\nsphere 7 1 radius 0.7 n velocity 0.3 -1 spin 2\n"
     "sphere 9 9 radius 1 m fixed velocity 0.1 0.2 spin 1\ngravity 1 -1\nstep 0.001\nmonitor D sphere 5\n"
     "record time D.angle D.spin energy.kinetic\n"
     "stage a\nshear mindlin_deresiewicz memory 5\nmaterial m friction 0.35\npair n n friction 0.15\ncycles 10\nstage "
     "a-on\nstep 0.0008\ncycles 10\n"
     "stage b\nshear mindlin_deresiewicz memory 3\nremove sphere 4\nremove wall v\nramp gravity 2 -2\nramp wall w "
     "velocity 0.3 -0.1\n"
     "cycles 20\nstage b-on\nstep 0.001\ncycles 10\nstage c\nshear mindlin_scaled\nnormal hertz_increment\ncycles 10\n"
     "stage c-on\nstep 0.0008\ncycles 10\n"},
    {"an impact", "units none\nmaterial m density 3 young 5000 poisson 0.2\nnormal hertz\nwall w -5 0 to 5 0 m\n"
                  "sphere 0 5 radius 1 m\nlattice spheres 3 by 1 m radius 0.3 spacing 0.59 from 2 0.29\nmonitor C "
                  "sphere 1 with wall "
                  "w\nimpact C speed 1 angle 0.5 phase 0.3\nrecord impact.time\nstep 0.001\nstage a\ncycles 20\nstage "
                  "b\ncycles 10\n"},
};

static void small_scenes_are_restored(void) {
  for (size_t k = 0; k < sizeof small / sizeof *small; k++) {
    struct words words = {0};
    struct written it;
    words_add(&words, "%s", small[k].page);
    written_scene(&it, &words);
    continued_same(&it, small[k].what);
    written_free(&it);
  }
}

void suite_state_fits(void) {
  CU_pSuite suite = CU_add_suite("state_fits", NULL, NULL);
  CU_add_test(suite, "pair rules of stages are in the state", rules_of_stages_fit);
  CU_add_test(suite, "other particles do not fit", other_particles_do_not_fit);
  CU_add_test(suite, "other names do not fit", other_names_do_not_fit);
  CU_add_test(suite, "other laws do not fit", other_laws_do_not_fit);
  CU_add_test(suite, "messages about states that do not fit", messages_about_states);
  CU_add_test(suite, "contacts that are apart do not fit", contacts_that_are_apart_do_not_fit);
  CU_add_test(suite, "a state with another cell or boundary than the page is refused", others_are_refused);
  CU_add_test(suite, "continued runs have the same bits with centred dashpots", centred_dashpots);
  CU_add_test(suite, "continued runs have the same bits in an impact with a phase", an_impact_with_a_phase);
  CU_add_test(suite, "a contact that begins at a vertex", a_contact_that_begins_at_a_vertex);
  CU_add_test(suite, "properties of contacts in the last step are in the state", contacts_of_the_last_step_continue);
  CU_add_test(suite, "a history that begins with 0", a_history_that_begins_with_0);
  CU_ADD_TEST(suite, the_single_contact_step_at_the_start);
  CU_ADD_TEST(suite, checkpoints_of_stages);
  CU_ADD_TEST(suite, captured_values);
  CU_ADD_TEST(suite, contacts_with_a_force_are_saved);
  CU_ADD_TEST(suite, contacts_with_a_history_are_saved);
  CU_ADD_TEST(suite, ended_and_empty_boundaries);
  CU_ADD_TEST(suite, small_scenes_are_restored);
}
