/* A run that continues from a saved state gives the same bits as the uninterrupted run, with every law and damping,
 * after every kind of change, and with other options after the state than before it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continued.h"
#include "run/plan.h"
#include "suites.h"

/* Twelve particles that are compressed and sheared; a wall that rotates and a wall whose velocity ramps; a fixed
 * particle that moves, a particle in flight with spin, and a free and a fixed particle that are removed. */
static const char scene[] =
    "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.3 young 5000 poisson 0.2\nmaterial p density 3 kn "
    "6000 "
    "ks 2000 friction 0.2 young 8000 poisson 0.3\npair m p friction 0.25\nnormal %s\nshear %s\nbox 0 0 to 8.1 6.1 p\n"
    "wall lid 1 7 to 6 8.5 p about 0 9 spin 0.05\nlattice %s 4 by 3 m radius 1 spacing 2.01 from 1.01 1.01\n%s 9.05 3 "
    "radius "
    "0.98 p fixed velocity -0.1 0 spin 0.5\n%s 3 7.4 radius 0.7 p velocity 0.3 -1 spin 2\ngravity 0.1 -0.4\n%s\nstep "
    "0.002\n"
    "monitor C %s 1 with %s 2\nmonitor D %s 5\nmonitor W wall lid\nrecord time C.normal C.shear C.sliding D.angle "
    "D.spin W.fx W.angle energy.kinetic\n"
    "stage a\nwall west velocity 0.2 0.1\nramp wall south velocity 0.1 0.15\nramp material m friction 0.4\nramp "
    "gravity 0.2 "
    "-0.5\ncycles %d\nstage b\nremove %s 7\nwall lid spin -0.05\ncycles %d\n"
    "stage c\nremove %s 13\nwalls stop\nwall east velocity -0.1 0.3\nmaterial p kn 5000 friction 0.35\ndamping ratio "
    "0.1\ngravity 0 -0.3\n"
    "cycles %d\nstage d\ncycles %d\n";

static void page_of(struct written *it, const char *normal, const char *shear, const char *damping) {
  struct words page = {0};
  const bool elastic = strncmp(normal, "hertz", 5) == 0;
  const char *one = elastic ? "sphere" : "disc", *many = elastic ? "spheres" : "discs";
  words_add(&page, scene, normal, shear, many, one, one, damping, one, one, one, 300, one, 200, one, 150, 100);
  written_scene(it, &page);
}

static void same_bits(const char *normal, const char *shear, const char *damping) {
  struct written it;
  char what[256];
  page_of(&it, normal, shear, damping);
  snprintf(what, sizeof what, "normal %s, shear %s, %s", normal, shear, damping);
  continued_same(&it, what);
  written_free(&it);
}

static void all_laws(void) {
  static const char *const shears[] = {
      "none", "linear", "mindlin", "mindlin_scaled", "mindlin_deresiewicz memory 5", "randall", "randall_literal"};
  for (size_t k = 0; k < sizeof shears / sizeof *shears; k++) {
    if (k < 2)
      same_bits("linear", shears[k], "");
    same_bits("hertz", shears[k], "");
    same_bits("hertz_increment", shears[k], "");
  }
}

static void all_dampings(void) {
  static const char *const dampings[] = {
      "damping stiffness 0.002",   "damping ratio 0.05\ndamping walls none", "damping mass 0.7",
      "damping con1 0.98 as cs79", "damping con1 0.98 as velocity",          "damping con1 0.97 as all"};
  for (size_t k = 0; k < sizeof dampings / sizeof *dampings; k++) {
    same_bits("linear", "linear", dampings[k]);
    same_bits("hertz", "mindlin_deresiewicz", dampings[k]);
  }
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

/* The balances of a continued run count from the saved state on. From then on their terms and residuals change as in
 * the uninterrupted run. */
static void balances_begin_anew(void) {
  static const char *const balance[] = {"work.residual", "energy.residual", "energy.walls",
                                        "energy.damped", "energy.friction", "energy.gravity"};
  static const char *const shears[] = {"linear", "mindlin_deresiewicz"};
  for (size_t l = 0; l < 2; l++) {
    struct words page = {0};
    struct written it;
    struct nb_saved saved;
    struct nb_error error;
    const char *normal = l ? "hertz" : "linear", *one = l ? "sphere" : "disc", *many = l ? "spheres" : "discs";
    words_add(&page, scene, normal, shears[l], many, one, one, "damping ratio 0.1", one, one, one, 300, one, 200, one,
              150, 100);
    char *columns = strstr(page.text, "energy.kinetic\n");
    char *text = malloc(strlen(page.text) + 256);
    sprintf(text,
            "%.*senergy.kinetic energy.stored work.residual energy.residual energy.walls energy.damped energy.friction "
            "energy.gravity\n%s",
            (int)(columns - page.text), page.text, columns + strlen("energy.kinetic\n"));
    free(page.text);
    page.text = text, page.length = strlen(text);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
    continued_stages(model, 0, 2);
    CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
    it.scene.start.stages = 2;
    struct nb_model *next = nb_model_resume(&it.scene, NULL, &saved, &error);
    CU_ASSERT_PTR_NOT_NULL_FATAL(next);
    nb_saved_free(&saved);
    const double level = written_now(model, "energy.kinetic") + written_now(model, "energy.stored");
    double before[6], drift = written_now(model, "energy.residual");
    for (size_t k = 0; k < 6; k++) {
      CU_ASSERT_DOUBLE_EQUAL(written_now(next, balance[k]), 0, 1e-14 * level);
      before[k] = written_now(model, balance[k]);
    }
    continued_stages(model, 2, 4), continued_stages(next, 2, 4);
    drift = written_now(model, "energy.residual") - drift;
    for (size_t k = 0; k < 6; k++)
      CU_ASSERT_DOUBLE_EQUAL(written_now(next, balance[k]), written_now(model, balance[k]) - before[k], 1e-12 * level);
    CU_ASSERT_DOUBLE_EQUAL(written_now(next, "energy.residual"), drift, 1e-12 * level);
    CU_ASSERT(fabs(written_now(next, "energy.walls")) > 0.01 * level);
    nb_model_free(next), nb_model_free(model);
    written_free(&it);
  }
}

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

/* Without dashpots the total forces are those of the laws. A page that continues the state with dashpots reads the
 * total forces. */
static void contact_forces_without_dashpots(void) {
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  int rubbing = 0;
  page_of(&it, "linear", "linear", "");
  it.scene.stage_count = 1; /* a later stage has dashpots */
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  CU_ASSERT_FALSE(model->plan.dashpots);
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  for (size_t c = 0; c < saved.contact_count; c++) {
    const double *field = saved.contacts[c].field;
    CU_ASSERT_EQUAL(field[NB_TOTAL_NORMAL], field[NB_NORMAL]);
    CU_ASSERT_EQUAL(field[NB_TOTAL_SHEAR], field[NB_SHEAR]);
    rubbing += field[NB_SHEAR] != 0;
  }
  CU_ASSERT(rubbing > 3);
  nb_saved_free(&saved);
  nb_model_free(model);
  it.scene.stage_count = 4;
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
                   "record energy.residual\nstep 0.01\nstage a\ncycles 3\nstage b\ncycles 3\n");
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
                   "record step.single-contact\nstage a\nmaterial m kn 400\ncycles 3\nstage b\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &options);
  continued_stages(model, 0, 1);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  nb_model_free(model);
  it.scene.start.stages = 1;
  model = nb_model_resume(&it.scene, &options, &saved, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  NEAR(written_now(model, "step.single-contact"), 2 * sqrt(2 * 3.14159265358979323846 / 400), 1e-15);
  nb_saved_free(&saved);
  nb_model_free(model);
  written_free(&it);
}

void suite_state(void) {
  CU_pSuite suite = CU_add_suite("state", NULL, NULL);
  CU_add_test(suite, "a contact that begins at a vertex", a_contact_that_begins_at_a_vertex);
  CU_add_test(suite, "continued runs have the same bits with every law", all_laws);
  CU_add_test(suite, "continued runs have the same bits with every damping", all_dampings);
  CU_add_test(suite, "continued runs have the same bits with centred dashpots", centred_dashpots);
  CU_add_test(suite, "continued runs have the same bits in an impact with a phase", an_impact_with_a_phase);
  CU_add_test(suite, "the balances count from the state on", balances_begin_anew);
  CU_add_test(suite, "pair rules of stages are in the state", rules_of_stages_fit);
  CU_add_test(suite, "other particles do not fit", other_particles_do_not_fit);
  CU_add_test(suite, "other names do not fit", other_names_do_not_fit);
  CU_add_test(suite, "other laws do not fit", other_laws_do_not_fit);
  CU_add_test(suite, "messages about states that do not fit", messages_about_states);
  CU_add_test(suite, "contacts that are apart do not fit", contacts_that_are_apart_do_not_fit);
  CU_add_test(suite, "total forces without dashpots", contact_forces_without_dashpots);
  CU_add_test(suite, "properties of contacts in the last step are in the state", contacts_of_the_last_step_continue);
  CU_add_test(suite, "a history that begins with 0", a_history_that_begins_with_0);
  CU_ADD_TEST(suite, the_single_contact_step_at_the_start);
}
