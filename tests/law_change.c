/* Laws that change between stages. Two spheres overlap by alpha = 0.5; one is fixed and one too heavy to move, so every
 * force and energy is known.
 *
 *   hertz   E* = 500, R* = 0.5:  F_n = (4/3) E* (R* alpha^3)^(1/2) = 500/3,  U_n = (2/5) F_n alpha = 100/3
 *   linear  k_n = 100:           F_n = 50,                                   U_n = 12.5
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/laws/laws_now.h"
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

/* Hertz's law by increments stores U = (2/5) N a^2/R with a = (3 N R/(4 E*))^(1/3), where N is its sum of increments; in
 * a step N grows by 2 E* a dn. Hertz's law stores (2/5) F_n alpha, where F_n = (4/3) E* (R alpha^3)^(1/2). A change from
 * the first law to the second one supplies the mean of the differences at the two ends of the step. A wall moves by 0.005
 * per step and stops at the overlap 0.05, or moves on. */
static void from_increments_to_hertz(void) {
  for (int moves = 0; moves < 2; moves++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0\nnormal hertz_increment\n"
              "sphere 0 2 radius 2 m\nwall w -9 0 to 9 0 m velocity 0 0.5\nmonitor C sphere 1 with wall w\n"
              "step 0.01\nrecord C.normal energy.stored energy.changed\n"
              "stage a\ncycles 10\nstage b\n%snormal hertz\ncycles 2\n",
              moves ? "" : "walls stop\n");
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    double sum = written_cell(&result.table, 10, "C.normal"), changed = 0;
    CU_ASSERT(sum > 1);
    for (int end = 0; end < 2; end++) {
      const double a = cbrt(0.75 * sum * 2 / 500), overlap = 0.05 + 0.005 * moves * end;
      const double before = 0.4 * sum * a * a / 2, after = 0.4 * 4 / 3 * 500 * sqrt(2 * overlap) * overlap * overlap;
      if (end == 0)
        CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, 10, "energy.stored"), before, 1e-12);
      changed += (after - before) / 2;
      sum += 2 * 500 * a * 0.005 * moves;
    }
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.changed"), changed, 1e-12);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Another stiffness or law changes the energy of the springs that exist: one where a sphere overlaps by 0.1 with the
 * vertex of two walls, and none between spheres with a gap of 0.05. */
static void springs_that_change(void) {
  const double hertz = 0.4 * 4 / 3 * 500 * sqrt(0.1) * 0.1 * 0.1; /* E* is 500, R 1 */
  static const char *const laws[][2] = {{"linear", "material m kn 700"}, {"hertz", "normal linear"}};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 400 young 1000 poisson 0\nnormal %s\nsphere 0 0.9 radius 1 m\n"
              "wall w -9 -1 to 0 0 m\nwall v 0 0 to 9 -1 m\nsphere 2.05 0.9 radius 1 m\nstep 0.01\n"
              "record energy.stored energy.changed\nstage a\ncycles 1\nstage b\n%s\ncycles 1\n",
              laws[k][0], laws[k][1]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, 0, "energy.stored"), k ? hertz : 2, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.changed"), k ? 2 - hertz : 3.5 - 2, 1e-12);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A new shear law begins without displacement. The spring energy F_s^2/(2 k_s) of the old law is lost, and in the
 * first half of the step the old force F_s still does the work F_s ds/2, which the new law does not store. `shear
 * mindlin` has no stored energy, so its work counts in `energy.shear` alone. Friction that begins later begins
 * without a force. A shear law also ends if the stage removes friction. A wall slides past a sphere that is too heavy to move: ds = 0.5 0.001. */
static void a_new_shear_law_begins_without_displacement(void) {
  static const char *const laws[][3] = {{"linear", "1e6", "shear mindlin"},
                                        {"mindlin", "1e6", "shear linear"},
                                        {"linear", "0", "material m friction 1e6"}, /* before: no shear force */
                                        {"linear", "1e6", "material m friction 0"},
                                        {"linear", "1e6", "shear none"},
                                        {"mindlin", "1e6", "shear none"}};
  for (int k = 0; k < 6; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0.25 ks 200 friction %s\nnormal hertz\n"
              "shear %s\nsphere 0 0.5 radius 1 m\nwall w -9 0 to 9 0 m velocity 0.5 0\nmonitor C sphere 1 with wall w\n"
              "material n density 1 kn 1 young 1000 poisson 0.25 ks 200 friction 1\nsphere 50 50 radius 1 n\n"
              "step 0.001\nrecord C.shear energy.shear energy.changed energy.balance\n"
              "stage a\ncycles 4\nstage b\n%s\ncycles 3\n",
              laws[k][1], laws[k][0], laws[k][2]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const struct nb_table *table = &result.table;
    CU_ASSERT_EQUAL_FATAL(table->row_count, 8);
    const double ds = 0.5 * 0.001, before = fabs(written_cell(table, 4, "C.shear"));
    const bool stored = k == 0 || k == 3 || k == 4;
    CU_ASSERT((before > 0.1) == (k != 2));
    CU_ASSERT((fabs(written_cell(table, 7, "C.shear")) > 0.1) == (k < 3));
    if (stored)
      CU_ASSERT_DOUBLE_EQUAL(before, 200 * 4 * ds, 1e-12);
    for (size_t row = 1; row < 8; row++) {
      const double old = fabs(written_cell(table, row - 1, "C.shear")), now = fabs(written_cell(table, row, "C.shear"));
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.shear") - written_cell(table, row - 1, "energy.shear"),
                             (old + now) / 2 * ds, 1e-13);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.changed"),
                             stored && row > 4 ? -before * before / 400 - before * ds / 2 : 0, 1e-13);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "energy.balance"), 0, 1e-12);
    }
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The same holds if the law of micro-slip gets another memory: contacts begin again without a history. */
static void another_memory_loses_the_stored_energy(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0.25 friction 10\nnormal hertz\n"
                   "shear mindlin_deresiewicz memory 8\nsphere 0 0.5 radius 1 m\nwall w -9 0 to 9 0 m velocity 0.5 0\n"
                   "monitor C sphere 1 with wall w\nstep 0.001\nrecord C.shear energy.stored energy.changed\n"
                   "stage a\ncycles 4\nstage b\nshear mindlin_deresiewicz memory 9\ncycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double stored =
      written_cell(&result.table, 4, "energy.stored") - written_cell(&result.table, 0, "energy.stored");
  const double work = fabs(written_cell(&result.table, 4, "C.shear")) * 0.5 * 0.001 / 2;
  CU_ASSERT(stored > 1e-3 && work > 1e-4);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.changed"), -stored - work, 1e-12);
  nb_result_free(&result);
  written_free(&it);
}

/* The same loss if the partner of the heavy sphere is a wall or a sphere that moves and rotates, or the image of a
 * sphere in a cell that deforms. The surfaces move relative to each other by ds per step, with the tangent (0, -1). The
 * spheres move by less than 1e-3 in all, so that e keeps its direction. */
static void a_shear_law_ends_anywhere(void) {
  static const struct {
    const char *scene, *motion;
    double speed; /* |ds|/dt, m/s */
  } rows[] = {{"wall w 0.5 9 to 0.5 -9 m velocity 0 0.5", "", 0.5},
              {"wall w 0.5 9 to 0.5 -9 m velocity 0 0.5 spin 0.4 about -2.5 0", "", 0.5 + 0.4 * 3},
              {"sphere 1.5 0 radius 1 m fixed velocity 0 0.5", "", 0.5},
              {"sphere 1 0 radius 0.5 m fixed velocity 0 0.5 spin 0.3", "", 0.5 - 0.3 * 0.5},
              {"sphere -1.5 0 radius 1 m fixed velocity 0 0.5 spin 0.3", "", 0.5 + 0.3},
              {"periodic cell -5 -5 to 3 5\nsphere -6.5 0 radius 1 m", "cell strain 0 0 c21 0.4\n", 0.4 * 1.5}};
  static const char *const ends[] = {"material m friction 0", "shear none", "shear mindlin"};
  for (size_t k = 0; k < 3 * sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0.25 ks 200 friction 1e6\nnormal hertz\n"
              "shear linear\nsphere 0 0 radius 1 m\n%s\nstep 1e-4\nrecord energy.changed\n",
              rows[k / 3].scene);
    /* the work of an earlier change, which ends no law, is not part of the loss */
    words_add(&page, "stage a\n%scycles 3\nstage again\n%smaterial m ks 200\ncycles 1\nstage b\n%s%s\ncycles 3\n",
              rows[k / 3].motion, rows[k / 3].motion, rows[k / 3].motion, ends[k % 3]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double ds = rows[k / 3].speed * 1e-4, force = 200 * 4 * ds, lost = force * force / 400 + force * ds / 2;
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.changed"), -lost, 1e-3 * lost);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A normal law that sums increments gets the normal increment from the geometry pass, even if no shear law and no
 * dashpot needs it. It keeps its sum when a stage changes the shear law alone. */
static void increments_without_a_shear_law(void) {
  static const char *const shears[][2] = {{"none", "none"}, {"mindlin", "mindlin"}, {"none", "mindlin"}};
  double force[3];
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 young 1000 poisson 0.3 friction 0.5\nnormal hertz_increment\nshear %s\n"
              "sphere 0 0 radius 1 m velocity 0.1 0\nsphere 2.001 0 radius 1 m fixed\n"
              "monitor C sphere 1 with sphere 2\nrecord C.normal\nstep 0.001\nstage a\ncycles 50\n"
              "stage b\nshear %s\ncycles 50\n",
              shears[k][0], shears[k][1]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    force[k] = written_last(&result, "C.normal");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT(force[0] > 0);
  CU_ASSERT_EQUAL(force[0], force[1]);
  CU_ASSERT_EQUAL(force[0], force[2]);
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

/* The memory before a change of the law has no effect after it. The wall moves to and fro by less each time, so the law
 * needs more than two or three pieces for the last motion, which goes beyond the earlier ones. */
static void another_memory_is_used_at_once(void) {
  double force[3];
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn 1 young 1000 poisson 0 friction 0.01\nnormal hertz\n"
              "shear mindlin_deresiewicz memory %d\nsphere 0 0.5 radius 1 m\nwall w -9 0 to 9 0 m\n"
              "monitor C sphere 1 with wall w\nstep 0.01\nrecord C.shear\nstage a\ncycles 1\nstage b\n"
              "shear mindlin_deresiewicz memory %d\nwall w velocity 0.25 0\ncycles 1\n",
              k == 1 ? 3 : 2, k == 2 ? 2 : 64);
    for (int turn = 0; turn < 6; turn++)
      words_add(&page, "stage s%d\nwall w velocity %g 0\ncycles 1\n", turn,
                turn == 5 ? 0.08 : (turn % 2 ? 1 : -1) * (0.2 - 0.03 * turn));
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    force[k] = written_last(&result, "C.shear");
    nb_result_free(&result);
    written_free(&it);
  }
  CU_ASSERT_EQUAL(force[0], force[1]);
  CU_ASSERT(fabs(force[2] - force[0]) > 1e-3 * fabs(force[0])); /* two pieces are too few */
}

/* Whether a scene has friction or a shear law at some time, and its first law without stored energy that is not that of
 * the start, or that begins to act only when a stage sets friction. */
static void laws_of_all_stages(void) {
  static const struct {
    const char *statements;
    bool friction, shear;
    const char *unstored;
  } rows[] = {
      {"material m density 1 kn 1\nstage a\ncycles 1\nstage b\ncycles 1", false, false, NULL},
      {"material m density 1 kn 1 friction 0.5\nstage a\ncycles 1\nstage b\ncycles 1", true, false, NULL},
      {"material m density 1 kn 1 ks 1 cohesion 2\nshear linear\nstage a\ncycles 1\nstage b\ncycles 1", true, true,
       NULL},
      {"material n density 1 kn 1\nmaterial m density 1 kn 1\npair n m friction 0.5\nstage a\ncycles 1", true, false,
       NULL},
      {"material n density 1 kn 1\nmaterial m density 1 kn 1\npair n m cohesion 2\nstage a\ncycles 1", true, false,
       NULL},
      {"material m density 1 kn 1\nstage a\ncycles 1\nstage b\nmaterial m friction 0.5\ncycles 1", true, false, NULL},
      {"material m density 1 kn 1\nstage a\nmaterial m cohesion 2\ncycles 1\nstage b\ncycles 1", true, false, NULL},
      {"material m density 1 kn 1\nstage a\nmaterial m friction 0\ncycles 1", false, false, NULL},
      {"material m density 1 kn 1 ks 1\nstage a\ncycles 1\nstage b\nshear linear\ncycles 1", false, true, NULL},
      {"material m density 1 kn 1 ks 1\nshear linear\nstage a\nshear none\ncycles 1", false, true, NULL},
      {"material m density 1 kn 1 young 1 poisson 0\nstage a\ncycles 1\nstage b\nnormal hertz\ncycles 1", false, false,
       NULL},
      {"material m density 1 young 1 poisson 0\nnormal hertz\nshear mindlin\nstage a\ncycles 1", false, true, NULL},
      {"material m density 1 young 1 poisson 0\nnormal hertz\nshear mindlin\nstage a\nmaterial m friction 1\ncycles 1",
       true, true, "mindlin"},
      {"material m density 1 young 1 poisson 0\nnormal hertz\nshear mindlin_deresiewicz\nstage a\nmaterial m friction "
       "1\ncycles 1\nstage b\nshear randall\ncycles 1",
       true, true, "randall"},
      {"material m density 1 young 1 poisson 0 friction 1\nnormal hertz\nshear mindlin\nstage a\nshear "
       "mindlin_scaled\ncycles 1\nstage b\nshear randall\ncycles 1",
       true, true, "mindlin_scaled"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    const char *stage = strstr(rows[k].statements, "stage");
    words_add(&page, "units none\n%.*ssphere 0 0 radius 1 m\nstep 1e-3\nrecord time\n%s\n",
              (int)(stage - rows[k].statements), rows[k].statements, stage);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_laws_friction(&it.scene), rows[k].friction);
    CU_ASSERT_EQUAL(nb_laws_shear(&it.scene), rows[k].shear);
    CU_ASSERT_EQUAL(nb_laws_elastic(&it.scene), strstr(rows[k].statements, "normal hertz") != NULL);
    const struct nb_law *law = nb_laws_unstored(&it.scene, false);
    CU_ASSERT(rows[k].unstored ? law && strcmp(law->name, rows[k].unstored) == 0 : !law);
    CU_ASSERT_PTR_NULL(nb_laws_unstored(&it.scene, true)); /* all normal laws store energy */
    written_free(&it);
  }
}

/* The number of pieces of a stage: the given one, the default of a law that the stage names without a number, and without
 * a shear law in the stage the number so far. */
static void pieces_of_a_stage(void) {
  static const struct {
    struct nb_laws laws;
    double pieces;
  } rows[] = {{{.shear = "mindlin_deresiewicz"}, 64},
              {{.shear = "mindlin_deresiewicz", .pieces = 16}, 16},
              {{.shear = "mindlin"}, 0},
              {{.normal = "hertz"}, 8}};
  const struct nb_active_laws before = {
      .normal = nb_law_find("normal", "hertz"), .shear = nb_law_find("shear", "mindlin_deresiewicz"), .pieces = 8};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const struct nb_stage stage = {.laws = rows[k].laws};
    CU_ASSERT_EQUAL(nb_laws_of(&stage, before).pieces, rows[k].pieces);
  }
}

/* A shear force at its limit slides, in both directions; one below it sticks. A law in increments ends with the overlap. */
static void single_steps(void) {
  static const char *const laws[] = {"linear", "mindlin", "mindlin_scaled"};
  const struct nb_pair p = {.young = 1, .shear = 1, .radius = 1, .ks = 1, .friction = 0.5};
  const struct nb_normal n = {.force = 2, .stiffness = 1, .radius = 1, .overlap = 1};
  for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      double m[NB_HISTORY] = {0};
      const struct nb_law *law = nb_law_find("shear", laws[k]);
      CU_ASSERT_EQUAL(law->shear(p, n, sign * 0.01, m).sliding, 0);
      const struct nb_shear out = law->shear(p, n, sign * 10, m);
      CU_ASSERT(out.sliding == 1 && out.force == sign * 0.5 * 2);
    }
  double m[NB_HISTORY] = {1};
  const struct nb_normal end = nb_law_find("normal", "hertz_increment")->normal(p, 0, -1e-3, m);
  CU_ASSERT(end.force == 0 && end.stiffness == 0 && m[0] == 0);
}

void suite_law_change(void) {
  CU_pSuite suite = CU_add_suite("law_change", NULL, NULL);
  CU_ADD_TEST(suite, laws_of_all_stages);
  CU_ADD_TEST(suite, pieces_of_a_stage);
  CU_ADD_TEST(suite, single_steps);
  CU_ADD_TEST(suite, from_increments_to_hertz);
  CU_ADD_TEST(suite, springs_that_change);
  CU_ADD_TEST(suite, a_new_shear_law_begins_without_displacement);
  CU_ADD_TEST(suite, another_memory_loses_the_stored_energy);
  CU_ADD_TEST(suite, a_shear_law_ends_anywhere);
  CU_add_test(suite, "force of the new law, difference of the stored energies",
              the_force_jumps_and_the_energy_is_counted);
  CU_add_test(suite, "increments without a shear law", increments_without_a_shear_law);
  CU_add_test(suite, "another law or memory begins without a history", another_law_has_no_history);
  CU_ADD_TEST(suite, another_memory_is_used_at_once);
}
