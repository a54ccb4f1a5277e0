/* Every source and sink of energy has its own term in the energy balance. A scene has none, one or several sources and
 * sinks: their terms are not 0, and all other terms are exactly 0. Energy that the same contact dissipates at two
 * separations is counted both times.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "suites.h"
#include "written.h"

enum { GRAVITY, WALLS, DAMPED, FRICTIONAL, SLIDING, SHEAR, CHANGED, DRIVEN, REMOVED, TERMS };
static const char *const names[TERMS] = {"energy.gravity",  "energy.walls",   "energy.damped",
                                         "energy.friction", "energy.sliding", "energy.shear",
                                         "energy.changed",  "energy.imposed", "energy.removed"};
#define RECORD                                                                                                         \
  "record energy.gravity energy.walls energy.damped energy.friction energy.sliding energy.shear energy.changed "       \
  "energy.imposed energy.removed energy.kinetic energy.stored energy.balance\n"
#define BIT(term) (1u << (term))

/* Two discs that collide, and one without contacts. */
#define MEET                                                                                                           \
  "disc 0 0 radius 1 m velocity 0.4 0 spin 0.2\ndisc 1.99 0.1 radius 1 m velocity -0.4 0.1\n"                          \
  "disc 0 9 radius 1 m velocity 0.3 0.2 spin 0.5\n"
#define SPRINGS "material m density 1 kn 900\n"
#define HAS_FRICTION "material m density 1 kn 900 ks 700 friction 0.005\nshear linear\n"
/* Discs without friction collide; the material with friction touches nothing. */
#define SMOOTH                                                                                                         \
  "material m density 1 kn 900 ks 700\n" MEET                                                                          \
  "material rough density 1 kn 900 ks 700 friction 0.005\nshear linear\ndisc 40 0 radius 1 rough\n"
#define CIRCLE "boundary circle 0 0 radius 0.5\n"
#define FOUR                                                                                                           \
  "disc 1 1 radius 1 m velocity -1 0\ndisc -0.99 1 radius 1 m\ndisc 1 -1 radius 1 m\ndisc -1 -0.99 radius 1 "          \
  "m\n" CIRCLE
#define CELL "periodic cell 0 0 to 9 9\ndisc 1 1 radius 1 m velocity 0.1 0\ndisc 3 1.1 radius 1 m\n"

static void each_energy_source_has_its_term(void) {
  static const struct {
    const char *head, *first, *second;
    unsigned terms;
  } ways[] = {
      {SPRINGS MEET, "", "", 0},
      {SPRINGS MEET "gravity 0.1 -1\n", "", "", BIT(GRAVITY)},
      {SPRINGS MEET, "", "gravity 0.1 -1\n", BIT(GRAVITY)},
      {SPRINGS MEET, "", "ramp gravity 0.1 -1\n", BIT(GRAVITY)},
      {SPRINGS MEET "wall w -9 -0.995 to 9 -0.995 m\n", "", "wall w velocity 0 0.2\n", BIT(WALLS)},
      {SPRINGS MEET "disc 0 -1.99 radius 1 m fixed velocity 0 0.3\n", "", "", BIT(WALLS)},
      {SPRINGS MEET, "", "damping stiffness 0.01\n", BIT(DAMPED)},
      {SPRINGS MEET, "", "damping mass 0.3\n", BIT(DAMPED)},
      {SPRINGS MEET, "", "damping con1 0.99 as cs79\n", BIT(DAMPED)},
      {SPRINGS MEET, "damping con1 0.99 as cs79\n", "", BIT(DAMPED)},
      {HAS_FRICTION MEET, "", "", BIT(FRICTIONAL) | BIT(SLIDING) | BIT(SHEAR)},
      {SMOOTH, "", "", 0},
      {SMOOTH, "", "material m friction 0.005\n", BIT(FRICTIONAL) | BIT(SLIDING) | BIT(SHEAR)},
      {SPRINGS MEET, "", "zero velocities\n", BIT(CHANGED)},
      {SPRINGS MEET, "", "reverse velocities\n", 0},
      {SPRINGS MEET, "", "rotation off\n", BIT(CHANGED)},
      {SPRINGS MEET, "", "material m kn 1200\n", BIT(CHANGED)},
      {SPRINGS MEET, "", "ramp material m kn 600\n", BIT(CHANGED)},
      {SPRINGS MEET, "", "remove disc 1\n", BIT(REMOVED)},
      {SPRINGS MEET, "", "remove disc 3\n", BIT(REMOVED)},
      {SPRINGS MEET, "", CIRCLE, BIT(REMOVED)},
      {SPRINGS "disc 0 0 radius 1 m\ndisc 1.99 0 radius 1 m\ndisc 0 9 radius 1 m\n", "rotation off\n",
       "boundary circle 0 0 radius 8\n", 0}, /* the springs of particles that do not rotate stay */
      {SPRINGS MEET, CIRCLE, "boundary strain 0.02 0.01\n", BIT(REMOVED) | BIT(DRIVEN)},
      {SPRINGS MEET, CIRCLE "boundary strain 0.02 0.01\n", "boundary none\n", BIT(REMOVED) | BIT(DRIVEN)},
      {SPRINGS FOUR, "", "boundary stress 20 10\n", BIT(DRIVEN) | BIT(CHANGED)},
      {SPRINGS CELL, "", "cell strain 0.1 0.02\n", BIT(DRIVEN)},
  };
  for (size_t n = 0; n < sizeof ways / sizeof *ways; n++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page, "units none\n%sstep 0.0005\n" RECORD "stage a\n%scycles 60\nstage b\n%scycles 60\n", ways[n].head,
              ways[n].first, ways[n].second);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    for (int t = 0; t < TERMS; t++) {
      const double value = written_last(&result, names[t]);
      if ((value != 0) != (ways[n].terms >> t & 1))
        printf("# %s%s then %s: %s is %g\n", ways[n].head, ways[n].first, ways[n].second, names[t], value);
      CU_ASSERT_EQUAL(value != 0, ways[n].terms >> t & 1);
      CU_ASSERT_EQUAL(written_cell(&result.table, 0, names[t]), 0);
    }
    nb_result_free(&result), written_free(&it);
  }
}

/* A wall presses against a heavy disc, moves tangentially, and leaves the disc while the shear spring is stretched. It
 * does this twice. The shear force is F_s = k_s s, where s is the tangential displacement (m); its limit is the
 * cohesion of 6 N. At each separation F_s^2/(2 k_s) is dissipated. Before the second separation the contact slides by
 * 0.02 m. The disc of 3e12 kg moves by less than 2e-11 m, so the energies are exact to 1e-10 J. */
static void shear_energy_is_dissipated_at_each_separation(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1e12 kn 400 ks 200 friction 0 cohesion 6\nshear linear\n"
                   "disc 0 1 radius 1 m\nwall w -90 -0.1 to 90 -0.1 m\nstep 0.001\n" RECORD
                   "stage up\nrecord every 400 cycles\nwall w velocity 0 0.5\ncycles 400\nstage along\nrecord every "
                   "400 cycles\nwall w velocity 0.05 0\ncycles 400\n"
                   "stage down\nrecord every 400 cycles\nwall w velocity 0 -0.5\ncycles 400\n"
                   "stage up2\nrecord every 400 cycles\nwall w velocity 0 0.5\ncycles 400\nstage along2\nrecord every "
                   "400 cycles\nwall w velocity 0.125 0\ncycles 400\n"
                   "stage down2\nrecord every 400 cycles\nwall w velocity 0 -0.5\ncycles 400\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const struct nb_table *table = &result.table;
  static const double lost[] = {0, 0, 0, 0.04, 0.04, 0.04 + 6 * 0.02, 0.04 + 6 * 0.02 + 0.09};
  CU_ASSERT_EQUAL_FATAL(table->row_count, sizeof lost / sizeof *lost);
  for (size_t r = 0; r < table->row_count; r++) {
    const double *row = table->values + r * table->column_count;
    CU_ASSERT_DOUBLE_EQUAL(row[FRICTIONAL], lost[r], 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(row[SLIDING], r < 5 ? 0 : 0.12, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(row[TERMS + 2], 0, 1e-10);
  }
  nb_result_free(&result), written_free(&it);
}

/* A heavy disc leaves a wall obliquely, at 0.3 m/s along the wall and 0.2 m/s away from it. In the last step before the
 * contact is open, the overlap is 0.2 mm, the shear force F_s = 0.9 * 1000 N/m * 0.2 mm slides at its limit, and its
 * mean over the next step, F_s/2, acts over 0.3 mm. So this step dissipates F_s^2/(2 k_s) and F_s/2 times 0.3 mm, which
 * is no sliding, and then all work of the shear force has been dissipated. */
static void a_contact_that_opens_obliquely(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1e12 kn 1000 ks 700 friction 0.9\nshear linear\n"
                   "disc 0 0.99 radius 1 m velocity 0.3 0.2\nwall w -90 0 to 90 0 m\nstep 0.001\n" RECORD
                   "stage away\ncycles 60\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double friction = written_last(&result, "energy.friction"), force = 0.9 * 1000 * 2e-4;
  CU_ASSERT_DOUBLE_EQUAL(friction, written_last(&result, "energy.shear"), 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(friction - written_last(&result, "energy.sliding"),
                         force * force / (2 * 700) + force / 2 * 3e-4, 1e-12);
  nb_result_free(&result), written_free(&it);
}

void suite_accounts(void) {
  CU_pSuite suite = CU_add_suite("accounts", NULL, NULL);
  CU_ADD_TEST(suite, each_energy_source_has_its_term);
  CU_ADD_TEST(suite, shear_energy_is_dissipated_at_each_separation);
  CU_ADD_TEST(suite, a_contact_that_opens_obliquely);
}
