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
  saved.particles[1] = was;
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
  static const char *const ends[] = {"particle 1 with particle 3", "particle 1 with wall 1"};
  for (int wall = 0; wall < 2; wall++) {
    saved.contacts[0].wall = wall, saved.contacts[0].b = wall ? 0 : 2;
    CU_ASSERT_PTR_NULL(nb_model_resume(&it.scene, &(struct nb_options){.threads = 1}, &saved, &error));
    CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
    CU_ASSERT(strstr(error.text, ends[wall]) != NULL);
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

/* Small scenes whose states together contain every kind of record. Most stages are followed by a stage that changes little
 * but the step, so the state must have everything that the first of the two stages has set. */
static const struct {
  const char *what, *page;
} small[] = {
    {"a boundary",
     "units none\nmaterial m density 3 kn 4000 ks 3000 friction 0.3\nshear linear\n"
     "lattice discs 3 by 3 m radius 1 spacing 1.99 from -2 -2\nboundary circle 0 0 radius 2.5\nstep 0.001\n"
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
               "lattice discs 3 by 3 m radius 1 spacing 1.99 from 0.1 0.2\ncell 0 0 to 5.97 5.97\nstep 0.001\n"
               "record time cell.xy cell.stress.xy energy.kinetic\n"
               "stage a\ncell strain 0.1 -0.1 c12 0.3 c21 0.02\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"
               "stage b\nreverse velocities\ncycles 10\nstage b-on\nstep 0.001\ncycles 10\n"},
    {"a box",
     "units none\nmaterial m density 3 kn 4000 ks 3000 friction 0.3\nshear linear\nbox 0 0 to 3.98 3.97 m\n"
     "lattice discs 2 by 2 m radius 1 spacing 1.985 from 1 0.99\nstep 0.001\nrecord time box.width box.stress.xx\n"
     "stage a\nbox strain 0.1 -0.2\ncycles 20\nstage a-on\nstep 0.0008\ncycles 10\n"
     "stage b\nservo mean 20 on box through box at most 1e-5 per cycle\ncycles 10\nstage b-on\nstep 0.001\ncycles "
     "10\n"},
    {"walls, properties and a change of the law",
     "units none\nmaterial m density 3 friction 0.3 young 5000 poisson 0.2\nmaterial n density 2 friction 0.4 young "
     "7000 poisson 0.3\npair m n friction 0.2\nnormal hertz\nshear mindlin\ndamping ratio 0.1\ndamping centred\n"
     "wall w -5 0 to 5 0 m about 1 0.1 spin 0.02 velocity 0.1 0.2\nwall v -1 -9 to -1 9 n\n"
     "lattice spheres 2 by 2 m radius 1 spacing 1.99 from -0.01 0.995\nsphere 7 1 radius 0.7 n velocity 0.3 -1 spin 2\n"
     "sphere 9 9 radius 1 m fixed velocity 0.1 0.2 spin 1\ngravity 1 -1\nstep 0.001\nmonitor D sphere 5\n"
     "record time D.angle D.spin energy.kinetic\n"
     "stage a\nmaterial m friction 0.35\npair n n friction 0.15\ncycles 10\nstage a-on\nstep 0.0008\ncycles 10\n"
     "stage b\nshear mindlin_deresiewicz memory 3\nremove sphere 4\nramp gravity 2 -2\nramp wall w velocity 0.3 -0.1\n"
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
  CU_ADD_TEST(suite, small_scenes_are_restored);
}
