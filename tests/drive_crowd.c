/* A boundary of many discs: storage order, threads and instruction sets change no bit, the work balances, and the stress of
 * the boundary agrees with that of the contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/names.h"
#include "../src/loading/loading.h"
#include "measure/boundary.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* Discs inside a boundary of discs, with friction, dashpots and CON1. `more`: the stages. With SQUEEZE the discs are
 * compressed and sheared, and many of them join the boundary. */
static void crowd(struct words *page, const char *more) {
  words_add(
      page,
      "units none\nmaterial m density 2 kn 4000 ks 3000 friction 0.4\nshear linear\nstep 0.001\n"
      "damping stiffness 0.0005\ndamping con1 0.999 as velocity\n"
      "lattice discs 9 by 9 m radius 0.5 spacing 1.05 from -4.2 -4.2\nmonitor D disc 41\nmonitor E disc 30\n"
      "boundary circle 0 0 radius 5.3\n"
      "record cycle D.x D.y D.angle E.x E.y boundary.particles boundary.area boundary.stress.xx boundary.stress.xy "
      "boundary.stress.yx boundary.stress.yy work.balance energy.imposed energy.walls energy.removed energy.balance "
      "energy.kinetic energy.stored contacts\n%s",
      more);
}

#define SQUEEZE                                                                                                        \
  "stage a\nboundary strain -0.6 -0.5 shear 0.02\naffine strain -0.1 -0.2 shear 0.05\ncycles 500\n"                    \
  "stage b\nboundary fixed\naffine none\ncycles 100\n"

static void squeeze(struct nb_result *result, const struct nb_options *options, const char *more) {
  struct words page = {0};
  struct written it;
  crowd(&page, more);
  written_scene(&it, &page);
  written_run(result, &it, options);
  written_free(&it);
}

/* Storage order, threads and instruction sets change no bit. */
static void the_same_bits(void) {
  const struct nb_options all[] = {{.threads = 1, .isa = "plain"}, {.threads = 3}, {.threads = 1, .shuffle = true}};
  struct nb_result first, other;
  squeeze(&first, &all[0], SQUEEZE);
  for (size_t k = 1; k < 3; k++) {
    squeeze(&other, &all[k], SQUEEZE);
    CU_ASSERT_EQUAL_FATAL(first.table.row_count, other.table.row_count);
    const size_t n = first.table.row_count * first.table.column_count;
    CU_ASSERT(memcmp(first.table.values, other.table.values, n * sizeof(double)) == 0);
    nb_result_free(&other);
  }
  CU_ASSERT_EQUAL(first.table.values[6], 4);
  CU_ASSERT(written_last(&first, "boundary.particles") > 20);
  nb_result_free(&first);
}

/* The largest magnitude in a column. */
static double largest(const struct nb_result *result, const char *name) {
  size_t c = 0;
  double most = 0;
  while (strcmp(result->table.names[c], name) != 0)
    c++;
  for (size_t r = 0; r < result->table.row_count; r++)
    most = fmax(most, fabs(result->table.values[r * result->table.column_count + c]));
  return most;
}

/* The work of the imposed motion, of the boundary and of all forces equals the kinetic energy to rounding, while
 * particles join the boundary. */
static void the_work_balances(void) {
  struct nb_result result;
  squeeze(&result, NULL, SQUEEZE);
  const double whole = largest(&result, "energy.kinetic") + largest(&result, "energy.imposed");
  CU_ASSERT(largest(&result, "energy.imposed") > 1 && largest(&result, "energy.removed") > 1);
  CU_ASSERT(largest(&result, "work.balance") < 1e-12 * whole);
  /* The energies balance except for the error of the step; without `energy.removed` the residual would be as large
   * as that term. */
  CU_ASSERT(largest(&result, "energy.balance") < 1e-2 * largest(&result, "energy.removed"));
  nb_result_free(&result);
}

/* The largest component of sum F_i X_j/A over the particles inside. boundary.stress.residual should have this value. */
static double out_of_balance(const struct nb_model *model) {
  struct nb_tensor sum = tensor(0, 0, 0, 0);
  for (size_t i = 0; i < model->particles.count; i++)
    if (model->particles.inverse_mass[i] > 0)
      sum = tensor_add(
          sum, tensor_outer(nb_force_on(model, i).force, vec_sub(model->particles.position[i], model->affine->centre)));
  return fmax(fmax(fabs(sum.xx), fabs(sum.xy)), fmax(fabs(sum.yx), fabs(sum.yy))) / nb_boundary_area(model);
}

/* Once the inner particles are at rest, sum F_i X_j/A over the boundary equals the stress of all contacts. Particles
 * that do not rotate bear moments, so xy and yx may differ. */
static void boundary_stress_equals_contact_stress(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  crowd(&page, SQUEEZE "stage c\ndamping stiffness 0.002\ndamping con1 0.9 as velocity\ncycles 20000\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_quantity residual;
  CU_ASSERT_FATAL(nb_quantity_find(&residual, &it.scene, "boundary.stress.residual"));
  for (size_t s = 0; s < it.scene.stage_count; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    written_cycles(model, (int)it.scene.stages[s].cycles);
    const double off = out_of_balance(model);
    CU_ASSERT(off > 0.1 || s + 1 == it.scene.stage_count);
    CU_ASSERT_DOUBLE_EQUAL(nb_quantity_value(residual, model), off, 1e-12 * (1 + off));
  }
  struct nb_tensor sum = tensor(0, 0, 0, 0);
  for (size_t c = 0; c < model->contacts.count; c++) {
    const int a = model->contacts.a[c], b = model->contacts.b[c];
    const struct nb_vec l = vec_sub(model->particles.position[a], model->particles.position[b]);
    sum = tensor_add(sum, tensor_outer(nb_contact_force(&model->contacts, c), l));
  }
  sum = tensor_scale(1 / nb_boundary_area(model), sum); /* discs are 1 thick */
  const struct nb_tensor ring = nb_boundary_stress(model);
  const double p = tensor_mean(sum);
  CU_ASSERT(p > 1);
  CU_ASSERT_DOUBLE_EQUAL(ring.xx, sum.xx, 1e-9 * p);
  CU_ASSERT_DOUBLE_EQUAL(ring.xy, sum.xy, 1e-9 * p);
  CU_ASSERT_DOUBLE_EQUAL(ring.yx, sum.yx, 1e-9 * p);
  CU_ASSERT_DOUBLE_EQUAL(ring.yy, sum.yy, 1e-9 * p);
  nb_model_free(model);
  written_free(&it);
}

/* The forces of a stress s on the boundary sum to 0, and sum F_i X_j = -s A. */
static void forces_of_a_boundary_stress(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  crowd(&page, "stage a\nboundary stress 5 3 shear -0.7\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  struct nb_tensor sum = tensor(0, 0, 0, 0);
  struct nb_vec force = vec(0, 0);
  for (size_t i = 0; i < model->particles.count; i++) {
    force = vec_add(force, model->boundary->boundary_force[i]);
    sum = tensor_add(sum, tensor_outer(model->boundary->boundary_force[i], model->particles.position[i]));
  }
  const double area = nb_boundary_area(model);
  CU_ASSERT(area > 50);
  CU_ASSERT(vec_length(force) < 1e-12 * area);
  CU_ASSERT_DOUBLE_EQUAL(sum.xx, -5 * area, 1e-11 * area);
  CU_ASSERT_DOUBLE_EQUAL(sum.xy, 0.7 * area, 1e-11 * area);
  CU_ASSERT_DOUBLE_EQUAL(sum.yx, 0.7 * area, 1e-11 * area);
  CU_ASSERT_DOUBLE_EQUAL(sum.yy, -3 * area, 1e-11 * area);
  for (size_t i = 0; i < model->particles.count; i++)
    CU_ASSERT(model->particles.inverse_mass[i] > 0);
  nb_model_free(model);
  written_free(&it);
}

void suite_drive_crowd(void) {
  CU_pSuite suite = CU_add_suite("drive_crowd", NULL, NULL);
  CU_add_test(suite, "storage, threads and instruction sets change no bit", the_same_bits);
  CU_add_test(suite, "the work balances", the_work_balances);
  CU_add_test(suite, "boundary stress equals the stress of the contacts", boundary_stress_equals_contact_stress);
  CU_add_test(suite, "forces of a boundary stress", forces_of_a_boundary_stress);
}
