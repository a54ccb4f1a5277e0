/* Measures of regions: sums that are computed in two ways, and measures that must add up to 1.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/region.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

extern const struct nb_quantity_kind nb_region_kinds[]; /* region_quantities.c */

#define CLOSE(model, name, wanted)                                                                                     \
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, name), wanted, 2e-14 * (1 + fabs((double)(wanted))))

#define NAMES                                                                                                          \
  "A.stress.xx A.stress.xy A.stress.yx A.stress.yy A.stress.residual A.stress.mean A.stress.sinphi "                   \
  "A.stress.normal.fraction A.stress.shear.fraction A.stress.fabric.fraction A.stress.variation.fraction "             \
  "A.stress.contacts.xx "                                                                                              \
  "A.fabric.xx A.fabric.yy A.fabric.normal.xx A.fabric.normal.yy A.fabric.shear.xx A.fabric.shear.yy A.sliding "       \
  "A.sliding.near A.obliquity.max A.unbalanced.mean A.porosity A.coordination.mechanical A.strain.volumetric "         \
  "B.stress.xx "                                                                                                       \
  "B.stress.residual B.stress.mean B.porosity C.stress.residual C.stress.mean C.stress.xx"

/* An assembly that is compressed, sheared, sliding and damped, with walls and with particles outside the regions. */
static void busy(struct words *page) {
  words_add(page, "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.2\nshear linear\nbox 0 0 to 12 12 m\n"
                  "lattice discs 6 by 6 m radius 0.98 spacing 1.95 from 1 1\ngravity 3 -9\nstep 0.002\n"
                  "damping ratio 0.1\nregion A all\nregion B circle 5 5 radius 3.3\nregion C box 2 1 to 7 8\n"
                  "record " NAMES "\nstage a\nwall west velocity 0.3 0.2\ncycles 900\n");
}

static void sums_agree(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  busy(&page);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int k = 0; k < 9; k++) {
    written_cycles(model, 100);
    static const char *const regions[] = {"A", "B", "C"};
    for (int r = 0; r < 3; r++) {
      char residual[32], mean[32];
      snprintf(residual, sizeof residual, "%s.stress.residual", regions[r]);
      snprintf(mean, sizeof mean, "%s.stress.mean", regions[r]);
      CU_ASSERT(written_now(model, mean) > 1);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, residual), 0, 1e-13 * written_now(model, mean));
    }
    CLOSE(model, "A.stress.contacts.xx", written_now(model, "A.stress.xx"));
    CLOSE(model, "A.stress.normal.fraction", 1 - written_now(model, "A.stress.shear.fraction"));
    CLOSE(model, "A.stress.fabric.fraction",
          written_now(model, "A.stress.normal.fraction") - written_now(model, "A.stress.variation.fraction"));
    CLOSE(model, "A.fabric.xx", 1 - written_now(model, "A.fabric.yy"));
    CLOSE(model, "A.fabric.normal.xx", 1 - written_now(model, "A.fabric.normal.yy"));
    CLOSE(model, "A.fabric.shear.xx", 1 - written_now(model, "A.fabric.shear.yy"));
    CU_ASSERT(written_now(model, "A.sliding.near") >= written_now(model, "A.sliding"));
    CU_ASSERT(written_now(model, "A.sliding") > 0);
    CLOSE(model, "A.obliquity.max", 1);
    CU_ASSERT(written_now(model, "A.stress.shear.fraction") != 0);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Storage order, threads and instruction sets change no bit. */
static void same_bits(void) {
  static const struct nb_options options[] = {
      {.threads = 1}, {.threads = 2}, {.threads = 1, .shuffle = true}, {.isa = "plain"}};
  double seen[4][40] = {{0}};
  for (size_t o = 0; o < 4; o++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    busy(&page);
    written_scene(&it, &page);
    written_run(&result, &it, &options[o]);
    const size_t count = result.table.column_count;
    memcpy(seen[o], result.table.values + (result.table.row_count - 1) * count, count * sizeof(double));
    nb_result_free(&result);
    written_free(&it);
    CU_ASSERT(memcmp(seen[o], seen[0], count * sizeof(double)) == 0 && seen[o][0] != 0);
  }
}

/* The recorded quantity of region A that a row names: of a family, one of its quantities. */
static void name_in_a(char name[2 * NB_NAME_SIZE], const struct nb_quantity_kind *kind) {
  static const char *const suffixes[] = {[NB_FOURTH] = ".xxxx", [NB_STATISTICS] = ".mean", [NB_TENSOR] = ".xx",
                                         [NB_STRESSES] = ".xx", [NB_FABRICS] = ".xx",      [NB_SCALAR] = ""};
  snprintf(name, 2 * NB_NAME_SIZE, "A.%s%s", kind->name, suffixes[kind->family]);
}

/* Compresses an assembly by a wall for 20 cycles, while the quantities of the rows from `first` to before `end` are
 * recorded. Writes the final value of each to `values`. `law`: 0 without shear forces, 1 linear springs, 2 elastic
 * spheres. */
static void values_in_a(double *values, int law, const struct nb_quantity_kind *first,
                        const struct nb_quantity_kind *end) {
  static const char *const shear[] = {"", "shear linear\n", "shear mindlin\n"};
  struct words page = {0};
  struct written it;
  char name[2 * NB_NAME_SIZE];
  words_add(&page, "units none\nmaterial m density 3 %s friction 0.2\n%s%s",
            law < 2 ? "kn 4000 ks 2500" : "young 5e4 poisson 0.2", law < 2 ? "" : "normal hertz\n", shear[law]);
  words_add(&page, "box 0 0 to 12 12 m\nlattice spheres 6 by 6 m radius 0.98 spacing 1.95 from 1 1\nstep 0.001\n"
                   "region A circle 6 6 radius 4\n");
  for (const struct nb_quantity_kind *kind = first; kind < end; kind++)
    name_in_a(name, kind), words_add(&page, "record %s\n", name);
  words_add(&page, "stage a\nwall west velocity 0.3 0.2\ncycles 20\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 20);
  for (const struct nb_quantity_kind *kind = first; kind < end; kind++)
    name_in_a(name, kind), *values++ = written_now(model, name);
  nb_model_free(model);
  written_free(&it);
}

/* A quantity that is recorded alone has the same finite value as beside all others, with friction and without. This
 * tests that it requests the fields of contacts that it reads, and has the measures computed that it needs. */
static void each_alone(void) {
  enum { CAPACITY = 200 };
  const struct nb_quantity_kind *end = nb_region_kinds;
  while (end->name)
    end++;
  CU_ASSERT_FATAL(end - nb_region_kinds < CAPACITY);
  for (int law = 0; law < 3; law++) {
    double all[CAPACITY], alone;
    values_in_a(all, law, nb_region_kinds, end);
    for (const struct nb_quantity_kind *kind = nb_region_kinds; kind < end; kind++) {
      values_in_a(&alone, law, kind, kind + 1);
      const double beside = all[kind - nb_region_kinds];
      const bool same = isfinite(alone) && memcmp(&alone, &beside, sizeof alone) == 0;
      if (!same)
        printf("# %s, law %d: %.17g alone, %.17g beside the others\n", kind->name, law, alone, beside);
      CU_ASSERT(same);
    }
  }
}

void suite_region_sums(void) {
  CU_pSuite suite = CU_add_suite("region_sums", NULL, NULL);
  CU_add_test(suite, "particles and contacts, parts and whole: to rounding", sums_agree);
  CU_add_test(suite, "each quantity alone", each_alone);
  CU_add_test(suite, "threads, storage and instruction sets change no bit", same_bits);
}
