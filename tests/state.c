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

/* The balances of a continued run count from the saved state on. From then on their terms and residuals change as in
 * the uninterrupted run. */
static void balances_begin_anew(void) {
  static const char *const balance[] = {"work.balance",  "energy.balance",  "energy.walls",
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
            "%.*senergy.kinetic energy.stored work.balance energy.balance energy.walls energy.damped energy.friction "
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
    double before[6], drift = written_now(model, "energy.balance");
    for (size_t k = 0; k < 6; k++) {
      CU_ASSERT_DOUBLE_EQUAL(written_now(next, balance[k]), 0, 1e-14 * level);
      before[k] = written_now(model, balance[k]);
    }
    continued_stages(model, 2, 4), continued_stages(next, 2, 4);
    drift = written_now(model, "energy.balance") - drift;
    for (size_t k = 0; k < 6; k++)
      CU_ASSERT_DOUBLE_EQUAL(written_now(next, balance[k]), written_now(model, balance[k]) - before[k], 1e-12 * level);
    CU_ASSERT_DOUBLE_EQUAL(written_now(next, "energy.balance"), drift, 1e-12 * level);
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

void suite_state(void) {
  CU_pSuite suite = CU_add_suite("state", NULL, NULL);
  CU_add_test(suite, "continued runs have the same bits with every law", all_laws);
  CU_add_test(suite, "continued runs have the same bits with every damping", all_dampings);
  CU_add_test(suite, "the balances count from the state on", balances_begin_anew);
  CU_add_test(suite, "total forces without dashpots", contact_forces_without_dashpots);
}
