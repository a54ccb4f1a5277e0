/* Two discs between two walls: the hand calculation of CS79, the modes, and the static forces of springs in series.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "lattice.h"
#include "refs_scenes.h"
#include "suites.h"

static const double k[3] = {3e6, 5e6, 2e6}, m[2] = {4000, 9000};
static const double v = 0.05, step = 0.01;

/* The forces (1) and the increments (5)-(7) as CS79 prints them, added up. */
static void first_cycles_equal_cs79(void) {
  struct refs_scene it;
  double same[3] = {3e6, 3e6, 3e6};
  refs_row(&it, same, m, v, step, 6, 100);
  double f = same[0] * v * step, xdot = f / m[0] * step, ydot = -f / m[1] * step;
  struct nb_solution solution = refs_solution("two_wall_compression", &it);
  REFS_NEAR(refs_value(&solution, "A.normal at 1 cycles"), f, 1e-15, f);
  CU_ASSERT_EQUAL(refs_value(&solution, "B.normal at 1 cycles"), 0);
  REFS_NEAR(refs_value(&solution, "C.normal at 1 cycles"), f, 1e-15, f);
  REFS_NEAR(refs_value(&solution, "A.normal at 2 cycles"), f + same[0] * (v - xdot) * step, 1e-15, f);
  REFS_NEAR(refs_value(&solution, "B.normal at 2 cycles"), same[0] * (xdot - ydot) * step, 1e-15, f);
  REFS_NEAR(refs_value(&solution, "C.normal at 2 cycles"), f + same[0] * (ydot + v) * step, 1e-15, f);
  REFS_NEAR(refs_value(&solution, "A.overlap at 2 cycles"), v * step + (v - xdot) * step, 1e-15, v * step);
  REFS_NEAR(refs_value(&solution, "X.fx at 1 cycles"), f, 1e-15, f);
  REFS_NEAR(refs_value(&solution, "Y.fx at 1 cycles"), -f, 1e-15, f);
  CU_ASSERT_EQUAL(refs_value(&solution, "X.vx.half at 1 cycles"), 0);
  REFS_NEAR(refs_value(&solution, "X.vx.half at 2 cycles"), xdot, 1e-15, xdot);
  REFS_NEAR(refs_value(&solution, "Y.vx.half at 2 cycles"), ydot, 1e-15, ydot);
  CU_ASSERT_EQUAL(refs_value(&solution, "Y.vy.half at 2 cycles"), 0);
  solution_free(&solution);
}

static double refs_value_at(const struct nb_solution *solution, const char *name, int n) {
  char text[64];
  snprintf(text, sizeof text, "%s at %d cycles", name, n);
  return refs_value(solution, text);
}

/* Different springs and masses, all six cycles of loading: the hand calculation, the recursion in long double, and
 * the modes. */
static void hand_equals_recursion_and_modes(void) {
  struct refs_scene it;
  refs_row(&it, k, m, v, step, 6, 100);
  struct nb_solution solution = refs_solution("two_wall_compression", &it);
  long double x = 0, y = 0, vx = 0, vy = 0, unit = k[0] * v * step;
  static const char monitor[3] = {'A', 'B', 'C'};
  for (int n = 1; n <= 6; n++) {
    x += vx * step;
    y += vy * step;
    long double force[3] = {k[0] * (n * v * step - x), k[1] * (x - y), k[2] * (n * v * step + y)};
    REFS_NEAR(refs_value_at(&solution, "X.vx.half", n), (double)vx, 2e-15, v);
    REFS_NEAR(refs_value_at(&solution, "Y.vx.half", n), (double)vy, 2e-15, v);
    REFS_NEAR(refs_value_at(&solution, "Y.fx", n), (double)(force[1] - force[2]), 2e-15, (double)unit);
    vx += (force[0] - force[1]) / m[0] * step;
    vy += (force[1] - force[2]) / m[1] * step;
    for (int i = 0; i < 3; i++) {
      char name[32] = {monitor[i], 0};
      strcat(name, ".normal");
      const struct nb_solution_curve *curve = solution_find_curve(&solution, name, "cycle");
      double hand = refs_value_at(&solution, name, n);
      REFS_NEAR(hand, (double)force[i], 2e-15, (double)unit);
      CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
      REFS_NEAR(curve->at(curve->data, n), hand, 1e-13, (double)unit);
    }
  }
  CU_ASSERT_PTR_NULL(solution_find(&solution, "A.normal at 7 cycles"));
  solution_free(&solution);
}

/* The hand calculation returns values only for the cycles in which the walls keep their velocity. Curves are returned
 * only if nothing is damped and no contact opens. */
static void hand_ends_with_the_first_motion(void) {
  struct refs_scene it;
  refs_row(&it, k, m, v, step, 3, 100);
  struct nb_solution solution = refs_solution("two_wall_compression", &it);
  CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "A.normal at 3 cycles"));
  CU_ASSERT_PTR_NULL(solution_find(&solution, "A.normal at 4 cycles"));
  solution_free(&solution);
  it.stages[1].motion_count = 0; /* the walls keep moving, in longer steps */
  it.stages[1].step.value = 2 * step;
  solution = refs_solution("two_wall_compression", &it);
  CU_ASSERT_PTR_NULL(solution_find_curve(&solution, "A.normal", "cycle")); /* the modes are for one step */
  CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "A.normal at 3 cycles"));
  CU_ASSERT_PTR_NULL(solution_find(&solution, "A.normal at 4 cycles"));
  solution_free(&solution);
  refs_row(&it, k, m, v, step, 6, 100);
  it.stages[1].damping.global_kind = NB_GLOBAL_MASS;
  solution = refs_solution("two_wall_compression", &it);
  CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "A.normal at 6 cycles"));
  CU_ASSERT_PTR_NULL(solution_find_curve(&solution, "A.normal", "cycle"));
  solution_free(&solution);
  refs_row(&it, k, m, v, step, 1, 100); /* after a short loading, contact B opens in the oscillation */
  solution = refs_solution("two_wall_compression", &it);
  CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "B.normal at 1 cycles"));
  CU_ASSERT_PTR_NULL(solution_find_curve(&solution, "B.normal", "cycle"));
  solution_free(&solution);
  it.motions[1].vx *= 1.5;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("two_wall_compression", &it).text, "equal speeds"));
  refs_row(&it, k, m, v, 6 * step, 6, 100); /* with so long a step, B opens: q + r = 6.5 in two_wall_compression.c */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("two_wall_compression", &it).text, "opens"));
}

static void static_forces_of_springs_in_series(void) {
  struct refs_scene it;
  refs_row(&it, k, m, v, step, 6, 100);
  struct nb_solution solution = refs_solution("two_wall_statics", &it);
  struct nb_solution network = refs_solution("nine_discs_statics", &it);
  double force = 2 * 6 * v * step * 30e6 / 31; /* 1/3 + 1/5 + 1/2 = 31/30 */
  REFS_NEAR(refs_value(&solution, "A.normal"), force, 1e-14, force);
  REFS_NEAR(refs_value(&solution, "C.normal mean"), force, 1e-14, force);
  REFS_NEAR(refs_value(&solution, "B.overlap"), force / k[1], 1e-14, force / k[1]);
  REFS_NEAR(refs_value(&network, "B.normal"), force, 1e-12, force);
  solution_free(&solution);
  solution_free(&network);
  it.stages[1].motion_count = 0; /* the walls keep moving */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("two_wall_statics", &it).text, "stop"));
}

/* The forces depend on where the walls are, not on the point P that the page uses to describe them: here P is `h` to the
 * right of each wall. */
static void walls_about_other_points(void) {
  static const char *const references[] = {"two_wall_compression", "two_wall_statics"};
  for (size_t r = 0; r < 2; r++)
    for (double h = -3; h < 4; h += 6) {
      struct refs_scene it;
      refs_row(&it, k, m, v, step, 6, 100);
      struct nb_solution on = refs_solution(references[r], &it);
      for (size_t w = 0; w < 2; w++)
        it.walls[w].h0 = h, it.walls[w].x += h * it.walls[w].ey, it.walls[w].y -= h * it.walls[w].ex;
      struct nb_solution off = refs_solution(references[r], &it);
      CU_ASSERT(on.value_count > 0 && on.value_count == off.value_count);
      for (size_t i = 0; i < on.value_count; i++)
        REFS_NEAR(refs_value(&off, on.values[i].name), on.values[i].value, 1e-12, on.values[i].value);
      solution_free(&on);
      solution_free(&off);
    }
}

void suite_refs_row(void) {
  CU_pSuite suite = CU_add_suite("refs_row", NULL, NULL);
  CU_add_test(suite, "first cycles equal the equations of CS79", first_cycles_equal_cs79);
  CU_add_test(suite, "the hand calculation equals recursion and modes", hand_equals_recursion_and_modes);
  CU_add_test(suite, "the hand calculation ends when the walls stop or damping begins",
              hand_ends_with_the_first_motion);
  CU_add_test(suite, "static forces are those of springs in series", static_forces_of_springs_in_series);
  CU_add_test(suite, "walls given by points off their lines", walls_about_other_points);
}
