/* Summaries of snapshots: averages, what each size contributes, porosity ring by ring.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/areas.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

static double cell(const struct nb_table *table, size_t row, const char *column) {
  size_t c = 0;
  while (c < table->column_count && strcmp(table->names[c], column) != 0)
    c++;
  CU_ASSERT_FATAL(c < table->column_count && row < table->row_count);
  return table->values[row * table->column_count + c];
}

/* A large sphere between two small ones, one of which is of another material; a fourth that touches nothing. */
static void run(struct nb_result *result, struct written *it) {
  struct words page = {0};
  words_add(&page, "units none\nmaterial a density 1 young 1000 poisson 0.25\nmaterial b density 1 young 1000 poisson "
                   "0.25\npair a b friction 0.5\nnormal hertz\nshear mindlin\nstep 1e-9\n"
                   "sphere 0 0 radius 2 a\nsphere 2.99 0 radius 1 a fixed spin 3\nsphere 0 2.98 radius 1 b fixed\n"
                   "sphere -9 0 radius 1 a velocity 0 -2\nregion A circle 0 0 radius 3.5 rings 7\nregion B all\n"
                   "record time\nstage s\ncycles 1\nsnapshot\n");
  written_scene(it, &page);
  written_run(result, it, NULL);
}

static void averages(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it);
  const struct nb_table *bodies = &result.snapshots[0].body_averages, *contacts = &result.snapshots[0].contact_averages;
  CU_ASSERT(bodies->row_count == 3 && contacts->row_count == 3);
  CU_ASSERT(cell(bodies, 0, "contacts") == 2 && cell(bodies, 1, "contacts") == 0 && cell(bodies, 2, "contacts") == 1);
  CU_ASSERT_DOUBLE_EQUAL(cell(bodies, 0, "spin"), 3, 1e-8);
  CU_ASSERT_DOUBLE_EQUAL(cell(bodies, 1, "spin"), 0, 1e-8); /* the large one has begun to turn and to move */
  CU_ASSERT_DOUBLE_EQUAL(cell(bodies, 2, "spin"), 0.75, 1e-8);
  CU_ASSERT(cell(bodies, 0, "vy") == 0 && cell(bodies, 1, "vy") == -2);
  CU_ASSERT_DOUBLE_EQUAL(cell(bodies, 2, "vy"), -0.5, 1e-8);
  CU_ASSERT(cell(bodies, 2, "fixed") == 0.5);
  /* Hertz: N = 4/3 E* sqrt(R* alpha) alpha, a = sqrt(R* alpha), R* = 2/3, E* = E/2(1 - nu^2) */
  const double E = 1000 / (2 * (1 - 0.0625)), a1 = sqrt(2. / 3 * 0.01), a2 = sqrt(2. / 3 * 0.02);
  const double n1 = 4. / 3 * E * a1 * 0.01, n2 = 4. / 3 * E * a2 * 0.02;
  const struct {
    const char *name;
    double one, two;
  } rows[] = {{"overlap", 0.01, 0.02}, {"normal", n1, n2},
              {"radius", a1, a2},      {"normal_stress", n1 / (pi * a1 * a1), n2 / (pi * a2 * a2)},
              {"ratio", a1, a2},       {"angle", 0, pi / 2}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    CU_ASSERT_DOUBLE_EQUAL(cell(contacts, 0, rows[k].name), rows[k].two, 1e-12 * rows[k].two);
    CU_ASSERT_DOUBLE_EQUAL(cell(contacts, 1, rows[k].name), rows[k].one, 1e-12 * rows[k].two);
    CU_ASSERT_DOUBLE_EQUAL(cell(contacts, 2, rows[k].name), (rows[k].one + rows[k].two) / 2, 1e-12 * rows[k].two);
  }
  CU_ASSERT(cell(contacts, 1, "limit") == 0); /* a does not rub on a */
  CU_ASSERT_DOUBLE_EQUAL(cell(contacts, 0, "limit"), 0.5 * n2, 1e-12 * n2);
  nb_result_free(&result);
  written_free(&it);
}

static void types(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it);
  const struct nb_table *table = &result.snapshots[0].types;
  const double wanted[][8] = {
      /* region, material, radius, bodies, ends, share, coordination, rattlers */
      {1, 1, 2, 1, 2, 0.5, 2, 0}, {1, 1, 1, 1, 1, 0.25, 1, 0},   {1, 2, 1, 1, 1, 0.25, 1, 0},
      {2, 1, 2, 1, 2, 0.5, 2, 0}, {2, 1, 1, 2, 1, 0.25, 0.5, 1}, {2, 2, 1, 1, 1, 0.25, 1, 0},
  };
  static const char *const names[] = {"region", "material", "radius",       "bodies",
                                      "ends",   "share",    "coordination", "rattlers"};
  CU_ASSERT_EQUAL_FATAL(table->row_count, 6);
  for (size_t r = 0; r < 6; r++)
    for (size_t c = 0; c < 8; c++)
      CU_ASSERT_DOUBLE_EQUAL(cell(table, r, names[c]), wanted[r][c], 1e-15);
  CU_ASSERT(cell(table, 4, "loaded") == 1); /* of the one that is no rattler */
  nb_result_free(&result);
  written_free(&it);
}

/* Two that touch nothing: the free one is a rattler, what is fixed is not. */
static void what_is_fixed_is_no_rattler(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 2 m fixed\ndisc 9 0 radius 1 m\nregion A all\n"
            "step 0.1\nrecord A.rattlers\nstage s\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const struct nb_table *table = &result.snapshots[0].types;
  CU_ASSERT_EQUAL_FATAL(table->row_count, 2);
  CU_ASSERT(cell(table, 0, "radius") == 2 && cell(table, 0, "rattlers") == 0);
  CU_ASSERT(cell(table, 1, "radius") == 1 && cell(table, 1, "rattlers") == 1);
  CU_ASSERT_EQUAL(written_last(&result, "A.rattlers"), 1);
  nb_result_free(&result);
  written_free(&it);
}

static void rings(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it);
  const struct nb_table *table = &result.snapshots[0].rings;
  CU_ASSERT_EQUAL_FATAL(table->row_count, 7);
  for (size_t k = 0; k < 7; k++) {
    const double inner = 0.5 * (double)k, outer = inner + 0.5, all = pi * outer * outer;
    double area[2];
    for (int e = 0; e < 2; e++) {
      const double r = e ? outer : inner;
      area[e] = pi * fmin(4, r * r) + nb_area_of_lens(1, r, 2.99) + nb_area_of_lens(1, r, 2.98);
    }
    CU_ASSERT_DOUBLE_EQUAL(cell(table, k, "inner"), inner, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(cell(table, k, "outer"), outer, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(cell(table, k, "within"), 1 - area[1] / all, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(cell(table, k, "porosity"), 1 - (area[1] - area[0]) / (all - pi * inner * inner), 1e-14);
  }
  CU_ASSERT_DOUBLE_EQUAL(cell(table, 3, "porosity"), 0, 0.02); /* but for two slivers it is the large one's rim */
  nb_result_free(&result);
  written_free(&it);
}

void suite_summary(void) {
  CU_pSuite suite = CU_add_suite("summary", NULL, NULL);
  CU_add_test(suite, "the largest, the smallest and the mean of all bodies and contacts", averages);
  CU_add_test(suite, "what each size and material contributes", types);
  CU_add_test(suite, "porosity ring by ring", rings);
  CU_add_test(suite, "what is fixed is no rattler", what_is_fixed_is_no_rattler);
}
