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
  CU_add_test(suite, "total forces without dashpots", contact_forces_without_dashpots);
  CU_add_test(suite, "properties of contacts in the last step are in the state", contacts_of_the_last_step_continue);
  CU_add_test(suite, "a history that begins with 0", a_history_that_begins_with_0);
  CU_ADD_TEST(suite, the_single_contact_step_at_the_start);
}
