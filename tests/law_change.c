/* Laws that change between stages. Two spheres overlap by alpha = 0.5; one is fixed and one too heavy to move, so every
 * force and energy is known.
 *
 *   hertz   E* = 500, R* = 0.5:  F_n = (4/3) E* (R* alpha^3)^(1/2) = 500/3,  U_n = (2/5) F_n alpha = 100/3
 *   linear  k_n = 100:           F_n = 50,                                   U_n = 12.5
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "suites.h"
#include "written.h"

static void the_force_jumps_and_the_energy_is_counted(void) {
  static const double wanted[][3] = {/* F_n, energy.stored, energy.changed */
                                     {500.0 / 3, 100.0 / 3, 0},
                                     {500.0 / 3, 100.0 / 3, 0},
                                     {50, 12.5, 12.5 - 100.0 / 3},
                                     {50, 12.5, 12.5 - 100.0 / 3},
                                     {500.0 / 3, 100.0 / 3, 0}};
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0\npair m m kn 100\nnormal hertz\n"
                   "sphere 0 0 radius 1 m fixed\nsphere 1.5 0 radius 1 m\n"
                   "monitor C sphere 1 with sphere 2\nstep 0.001\nrecord C.normal energy.stored energy.changed\n"
                   "stage a\ncycles 1\nstage b\nnormal linear\ncycles 2\nstage c\nnormal hertz\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 5);
  for (size_t row = 0; row < 5; row++)
    for (size_t k = 0; k < 3; k++)
      CU_ASSERT_DOUBLE_EQUAL(result.table.values[row * result.table.column_count + k], wanted[row][k], 1e-12);
  nb_result_free(&result);
  written_free(&it);
}

/* A new shear law begins without displacement. The spring energy F_s^2/(2 k_s) of the old law is lost, and in the
 * first half of the step the old force F_s still does the work F_s ds/2, which the new law does not store. `shear
 * mindlin` has no stored energy, so its work counts in `energy.shear` alone. Friction that begins later begins
 * without a force. A wall slides past a sphere that is too heavy to move: ds = 0.5 0.001. */
static void a_new_shear_law_begins_without_displacement(void) {
  static const char *const laws[][3] = {{"linear", "1e6", "shear mindlin"},
                                        {"mindlin", "1e6", "shear linear"},
                                        {"linear", "0", "material m friction 1e6"}}; /* before: no shear force */
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0.25 ks 200 friction %s\nnormal hertz\n"
              "shear %s\nsphere 0 0.5 radius 1 m\nwall w -9 0 to 9 0 m velocity 0.5 0\nmonitor C sphere 1 with wall w\n"
              "step 0.001\nrecord C.shear energy.shear energy.changed energy.residual\n"
              "stage a\ncycles 4\nstage b\n%s\ncycles 3\n",
              laws[k][1], laws[k][0], laws[k][2]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const struct nb_table *table = &result.table;
    CU_ASSERT_EQUAL_FATAL(table->row_count, 8);
    const double ds = 0.5 * 0.001, before = fabs(written_cell(table, 4, "C.shear"));
    CU_ASSERT((before > 0.1) == (k < 2));
    CU_ASSERT(fabs(written_cell(table, 7, "C.shear")) > 0.1);
    if (k == 0)
      CU_ASSERT_DOUBLE_EQUAL(before, 200 * 4 * ds, 1e-12);
    for (size_t row = 1; row < 8; row++) {
      const double old = fabs(written_cell(table, row - 1, "C.shear")), now = fabs(written_cell(table, row, "C.shear"));
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.shear") - written_cell(table, row - 1, "energy.shear"),
                             (old + now) / 2 * ds, 1e-13);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.changed"),
                             k == 0 && row > 4 ? -before * before / 400 - before * ds / 2 : 0, 1e-13);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.residual"), 0, 1e-12);
    }
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A normal law that sums increments gets the normal increment from the geometry pass, even if no shear law and no
 * dashpot needs it. */
static void increments_without_a_shear_law(void) {
  static const char *const shears[] = {"none", "mindlin"};
  double force[2];
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 young 1000 poisson 0.3 friction 0.5\nnormal hertz_increment\nshear %s\n"
              "sphere 0 0 radius 1 m velocity 0.1 0\nsphere 2.001 0 radius 1 m fixed\n"
              "monitor C sphere 1 with sphere 2\nrecord C.normal\nstep 0.001\nstage a\ncycles 100\n",
              shears[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    force[k] = written_last(&result, "C.normal");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT(force[0] > 0);
  CU_ASSERT_EQUAL(force[0], force[1]);
}

/* If a stage changes the law or its number of pieces, contacts begin again without a history. If a stage states the
 * same law and the same number, contacts keep their history.
 *
 * The heavy sphere moves at a constant tangential velocity, d = 1e-5 per cycle. In each cycle the shear force T grows
 * by k d with k = 8 G* a. Here G* = 1000/(2 (1 + 0) 4) = 125 and a = (R* alpha)^(1/2) = 1/2, so k = 500, which is also
 * k_s. Micro-slip reduces T by a fraction of the order of T/(mu N), which is below 4e-5 because N = 500/3.
 *
 * The law with micro-slip treats a contact without a history as if its overlap and its tangential displacement had
 * grown in proportion, from 0 to alpha and to d. So T is the integral of 8 G* (R* x)^(1/2) d/alpha over the overlap x
 * from 0 to alpha, which is 2/3 k d. With `shear mindlin`, T is k d. */
static void another_law_has_no_history(void) {
  static const struct {
    const char *first, *second;
    double force;
  } rows[] = {{"mindlin_deresiewicz memory 8", "", 0.055},
              {"mindlin_deresiewicz memory 8", "shear mindlin_deresiewicz memory 8\n", 0.055},
              {"mindlin_deresiewicz memory 8", "shear mindlin_deresiewicz memory 9\n", 0.01 / 3},
              {"linear", "shear mindlin\n", 0.005}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 ks 500 young 1000 poisson 0 friction 10\nnormal hertz\n"
              "shear %s\nsphere 0 0 radius 1 m fixed\n"
              "sphere 1.5 0 radius 1 m velocity 0 1e-3\nmonitor C sphere 1 with sphere 2\nstep 0.01\n"
              "record C.shear\nstage a\ncycles 10\nstage b\n%scycles 1\n",
              rows[k].first, rows[k].second);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(fabs(written_cell(&result.table, 10, "C.shear")), 0.05, 1e-4 * 0.05);
    CU_ASSERT_DOUBLE_EQUAL(fabs(written_last(&result, "C.shear")), rows[k].force, 1e-4 * rows[k].force);
    nb_result_free(&result);
    written_free(&it);
  }
}

void suite_law_change(void) {
  CU_pSuite suite = CU_add_suite("law_change", NULL, NULL);
  CU_ADD_TEST(suite, a_new_shear_law_begins_without_displacement);
  CU_add_test(suite, "force of the new law, difference of the stored energies",
              the_force_jumps_and_the_energy_is_counted);
  CU_add_test(suite, "increments without a shear law", increments_without_a_shear_law);
  CU_add_test(suite, "another law or memory begins without a history", another_law_has_no_history);
}
