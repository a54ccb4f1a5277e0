/* Relaxation without time: equilibria that have a closed form, and what it changes.
 *
 * A triangular lattice of 16 discs in a cell, spacing d, radius 1: F = k (2 - d), and the mean stress is p = sqrt(3) F/d
 * in a plane 1 m thick, so d = 2/(1 + p/(sqrt(3) k)).
 *
 * Six discs in a ring of radius R around a seventh: in the region within R/2, p = 6 F/(pi R) with F = k (2 - R), so
 * R = 2/(1 + pi p/(6 k)).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "loading/loading.h"
#include "measure/boundary.h"
#include "measure/energy.h"
#include "measure/region.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

enum { ROWS = 4, DISCS = ROWS * ROWS };
static const double kn = 1000, pressure = 12, root3 = 1.7320508075688772;

/* A page of the lattice with the given spacing, with small displacements, in a cell of other sides. */
static void add_lattice(struct words *page, const char *before, double spacing, double distortion) {
  unsigned random = 1;
  words_add(page, "units none\nmaterial m density 2 kn %g\nstep 0.001\n%s", kn, before);
  for (int k = 0; k < DISCS; k++) {
    double off[2];
    for (int c = 0; c < 2; c++)
      random = random * 1103515245u + 12345u, off[c] = distortion * ((double)(random >> 16 & 0x7fff) / 0x7fff - 0.5);
    const double x = (k % ROWS + 0.5 * (k / ROWS % 2)) * spacing, y = k / ROWS * root3 / 2 * spacing;
    words_add(page, "disc %.17g %.17g radius 1 m\n", x + off[0], y + off[1]);
  }
  const double side = ROWS * spacing, height = ROWS * root3 / 2 * spacing;
  words_add(page, "cell 0 0 to %.17g %.17g\nregion A all\nrecord cycle time A.stress.xx\n",
            side * (1 + 0.1 * distortion), height * (1 - 0.1 * distortion));
}

static void relax(struct words *page, unsigned long most) {
  words_add(page, "stage s\nrelax isotropic %g on A through cell at most %lu cycles\n", pressure, most);
}

/* Relaxes far beyond the end of the stage. */
static struct nb_model *relaxed(struct written *it, struct words *page, int cycles) {
  struct nb_error error = {NB_OK, ""};
  written_scene(it, page);
  struct nb_model *model = written_model(it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it->scene.stages[0], &error), NB_OK);
  bool ended = false;
  for (int k = 0; k < cycles; k++) {
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
    ended = nb_relaxation_ends(model) || ended;
  }
  CU_ASSERT(ended);
  return model;
}

static double enthalpy(const struct nb_model *model) {
  return nb_energy_stored(model) + pressure * nb_cell_area(model->cell);
}

static void a_lattice_in_a_cell(void) {
  struct words page = {0};
  struct written it;
  add_lattice(&page, "", 2.01, 0.05);
  relax(&page, 10000);
  struct nb_model *model = relaxed(&it, &page, 6000);
  const double spacing = 2 / (1 + pressure / (root3 * kn));
  size_t touching = 0;
  for (size_t c = 0; c < model->contacts.count; c++) {
    touching += nb_touches(&model->contacts, c);
    if (nb_touches(&model->contacts, c))
      CU_ASSERT_DOUBLE_EQUAL(nb_overlap(model, c), 2 - spacing, 1e-10);
  }
  CU_ASSERT_EQUAL(touching, 3 * DISCS);
  CU_ASSERT_DOUBLE_EQUAL(nb_cell_area(model->cell), DISCS * root3 / 2 * spacing * spacing, 1e-10);
  nb_relaxation_end(model);
  CU_ASSERT(model->step == 0.001 && model->previous_step == 0.001);
  nb_model_free(model);
  written_free(&it);
}

/* A perfect lattice has one variable, its spacing, and each cycle follows from the one before. With one variable v has
 * the direction of F whenever P > 0, so turning it changes nothing. */
static void each_cycle_follows_the_recursion(void) {
  const double length = sqrt(8. * DISCS), g = 1.44 / (12 * kn);
  double spacing = 1.99, v = 0, dt = 0.1;
  int downhill = 0, stops = 0;
  struct words page = {0};
  struct written it;
  struct nb_error error = {NB_OK, ""};
  add_lattice(&page, "", spacing, 0);
  relax(&page, 10000);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int k = 0; k < 200; k++) {
    const double volume = DISCS * root3 / 2 * spacing * spacing, stress = root3 * kn * (2 - spacing) / spacing;
    const double force = volume * (stress - pressure) / length;
    if (force * v > 0)
      dt = ++downhill > 5 ? fmin(1.1 * dt, 1) : dt;
    else
      v = 0, dt /= 2, downhill = 0, stops++;
    v += dt * g * force;
    v = fabs(dt * v / length) > 2e-4 ? copysign(2e-4 * length / dt, v) : v;
    spacing *= 1 + dt * v / length;
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
    CU_ASSERT_DOUBLE_EQUAL(nb_cell_area(model->cell), DISCS * root3 / 2 * spacing * spacing, 1e-9);
  }
  CU_ASSERT(stops > 3 && dt > 0);
  nb_model_free(model);
  written_free(&it);
}

/* The ring is not round at first, and the middle disc not in the middle. */
static void a_ring_in_its_boundary(void) {
  const double radius = 2 / (1 + acos(-1) * pressure / (6 * kn)), now = 1.99;
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 2 kn %g\nstep 0.001\ndisc 0.003 -0.002 radius 1 m\n", kn);
  for (int k = 0; k < 6; k++)
    words_add(&page, "disc %.17g %.17g radius 1 m\n", now * cos(k * acos(0.5)), now * sin(k * acos(0.5)));
  words_add(&page, "boundary circle 0 0 radius 1.5\nregion A inside 0.5\nrecord cycle\n"
                   "stage s\nrelax isotropic 12 on A through boundary at most 1000 cycles\n");
  struct nb_model *model = relaxed(&it, &page, 3000);
  CU_ASSERT_DOUBLE_EQUAL(nb_boundary_radius(model), radius, 1e-10);
  CU_ASSERT_DOUBLE_EQUAL(nb_boundary_roughness(model), 0, 1e-10);
  CU_ASSERT_DOUBLE_EQUAL(vec_length(model->particles.position[0]), 0, 1e-10);
  CU_ASSERT_DOUBLE_EQUAL(model->boundary->ring.shape.xx, radius / now, 1e-10);
  CU_ASSERT_DOUBLE_EQUAL(model->boundary->ring.shape.yy, radius / now, 1e-10);
  nb_model_free(model);
  written_free(&it);
}

/* The enthalpy U + p A falls to its minimum. */
static void the_enthalpy_falls(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {NB_OK, ""};
  add_lattice(&page, "", 1.99, 0.05);
  relax(&page, 10000);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const double spacing = 2 / (1 + pressure / (root3 * kn)), before = enthalpy(model);
  const double least = DISCS * (1.5 * kn * (2 - spacing) * (2 - spacing) + pressure * root3 / 2 * spacing * spacing);
  for (int k = 0; k < 10000 && !nb_relaxation_ends(model); k++) {
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
    CU_ASSERT(enthalpy(model) >= least * (1 - 1e-12));
  }
  CU_ASSERT(before > least * (1 + 1e-3));
  CU_ASSERT_DOUBLE_EQUAL(enthalpy(model), least, 1e-8 * least);
  nb_model_free(model);
  written_free(&it);
}

/* Runs the page; the row of its end. */
static void run(struct nb_result *result, struct words *page) {
  struct written it;
  written_scene(&it, page);
  written_run(result, &it, NULL);
  written_free(&it);
}

/* Without contacts every cycle is a strain of 2e-4. */
static void without_contacts_the_strain_is_the_largest(void) {
  struct words page = {0};
  struct written it;
  add_lattice(&page, "", 2.03, 0);
  relax(&page, 10000);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_error error = {NB_OK, ""};
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  double area = nb_cell_area(model->cell);
  for (int k = 0; k < 70; k++) { /* 2.03 (1 - 2e-4)^74 is 2 */
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
    area *= (1 - 2e-4) * (1 - 2e-4);
    CU_ASSERT_DOUBLE_EQUAL(nb_cell_area(model->cell), area, 1e-12 * area);
  }
  for (int k = 0; k < 30; k++) {
    const double last = nb_cell_area(model->cell);
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
    CU_ASSERT(nb_cell_area(model->cell) >= last * (1 - 2e-4) * (1 - 2e-4) * (1 - 1e-12));
  }
  nb_model_free(model);
  written_free(&it);
}

/* Time stands still, velocities vanish, the stage ends by itself, and afterwards nothing moves. */
static void at_rest_in_the_end(void) {
  struct words page = {0};
  struct nb_result result;
  add_lattice(&page, "disc 1.005 0.58 radius 0.1 m velocity 1 1\n", 2.01, 0.05);
  words_add(&page, "record energy.kinetic A.speed.max step A.unbalanced.mean energy.residual energy.changed\n");
  words_add(&page, "stage first\ncycles 3\n");
  relax(&page, 10000);
  words_add(&page, "record every 20000 cycles\nstage rest\ncycles 100\nrecord every 1 cycle\n");
  run(&result, &page);
  const struct nb_table *table = &result.table;
  CU_ASSERT_EQUAL_FATAL(table->row_count, 4 + 1 + 100);
  CU_ASSERT(written_cell(table, 3, "energy.kinetic") > 0.01);
  CU_ASSERT_EQUAL(written_cell(table, 4, "time"), 0.003);
  CU_ASSERT(written_cell(table, 4, "cycle") > 103 && written_cell(table, 4, "cycle") < 10003);
  CU_ASSERT_EQUAL(written_cell(table, 4, "energy.kinetic"), 0);
  CU_ASSERT(fabs(written_cell(table, 4, "A.stress.xx") - pressure) <= 1e-4 * pressure);
  CU_ASSERT(written_cell(table, 4, "A.unbalanced.mean") < 1e-5);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(table, 5, "time"), 0.004, 1e-15);
  CU_ASSERT_EQUAL(written_last(&result, "step"), 0.001);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.stress.xx"), pressure, 1e-3 * pressure);
  const double before = written_cell(table, 3, "energy.residual"); /* of the three cycles */
  for (size_t row = 4; row < table->row_count; row++)
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.residual"), before, 1e-12);
  CU_ASSERT(written_last(&result, "energy.kinetic") < 1e-6);
  nb_result_free(&result);
}

/* A perfect lattice is balanced at any spacing, so the stress alone ends the stage. */
static void the_stress_is_at_its_target(void) {
  struct words page = {0};
  struct nb_result result;
  add_lattice(&page, "", 1.99, 0);
  relax(&page, 10000);
  run(&result, &page);
  CU_ASSERT(fabs(written_last(&result, "A.stress.xx") - pressure) <= 1e-4 * pressure);
  nb_result_free(&result);
}

/* Dashpots change no bit. */
static void dashpots_do_not_act(void) {
  double cycles[2], stress[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct nb_result result;
    add_lattice(&page, k ? "damping stiffness 0.01\n" : "", 2.01, 0.05);
    relax(&page, 10000);
    run(&result, &page);
    cycles[k] = written_last(&result, "cycle"), stress[k] = written_last(&result, "A.stress.xx");
    nb_result_free(&result);
  }
  CU_ASSERT_EQUAL(cycles[0], cycles[1]);
  CU_ASSERT_EQUAL(stress[0], stress[1]);
}

/* Two stages are one run, and a strain of the cell from before the relaxation does not continue after it. */
static void the_cell_rests_afterwards(void) {
  struct words page = {0};
  struct nb_result result;
  add_lattice(&page, "", 1.99, 0);
  words_add(&page, "record A.area\nstage first\ncell strain 0.01 0\ncycles 10\n");
  relax(&page, 10000);
  words_add(&page, "stage rest\ncycles 10\n");
  run(&result, &page);
  const struct nb_table *table = &result.table;
  CU_ASSERT_EQUAL(written_cell(table, table->row_count - 11, "A.area"), written_last(&result, "A.area"));
  nb_result_free(&result);
}

static void a_relaxation_that_does_not_end_fails(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {NB_OK, ""};
  add_lattice(&page, "", 2.01, 0.05);
  relax(&page, 30);
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BROKEN);
  CU_ASSERT(strstr(error.text,
                   "stage `s` (line 24) did not come to rest within 30 cycles: the stress is off its target "
                   "by ") != NULL);
  CU_ASSERT_EQUAL(result.cycles, 30);
  nb_result_free(&result);
  written_free(&it);
}

/* A region keeps its particles while they are fixed, wherever they move. */
static void fixed_particles_of_a_region(void) {
  struct words page = {0};
  struct written it;
  bool member[DISCS];
  add_lattice(&page, "region B circle 0 0 radius 1.2\n", 1.99, 0);
  words_add(&page, "record B.particles\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "B.particles"), 1);
  nb_region_fix(model, 0, member);
  model->particles.position[0].x += 1.5;
  CU_ASSERT_EQUAL(written_now(model, "B.particles"), 1);
  nb_region_fix(model, 0, NULL);
  CU_ASSERT_EQUAL(written_now(model, "B.particles"), 0);
  nb_model_free(model);
  written_free(&it);
}

void suite_relax(void) {
  CU_pSuite suite = CU_add_suite("relax", NULL, NULL);
  CU_add_test(suite, "a lattice in a cell reaches its equilibrium", a_lattice_in_a_cell);
  CU_add_test(suite, "each cycle follows the recursion", each_cycle_follows_the_recursion);
  CU_add_test(suite, "a ring in its boundary reaches its equilibrium", a_ring_in_its_boundary);
  CU_add_test(suite, "the enthalpy falls to its minimum", the_enthalpy_falls);
  CU_add_test(suite, "without contacts the strain is the largest", without_contacts_the_strain_is_the_largest);
  CU_add_test(suite, "time stands still, and particles rest in the end", at_rest_in_the_end);
  CU_add_test(suite, "the stress is at its target in the end", the_stress_is_at_its_target);
  CU_add_test(suite, "dashpots do not act", dashpots_do_not_act);
  CU_add_test(suite, "the cell rests afterwards", the_cell_rests_afterwards);
  CU_add_test(suite, "a relaxation that does not end fails", a_relaxation_that_does_not_end_fails);
  CU_add_test(suite, "fixed particles of a region", fixed_particles_of_a_region);
}
