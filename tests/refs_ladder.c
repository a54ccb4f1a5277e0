/* The reference contact_ladder, compared with the formulas of each branch and with its impacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../cases/refs/impact_springs.h"
#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

/* Solves contact_ladder for a sphere of radius 0.02 on a wall, with N = 8, mu = 0.5 and k_s = 16, and a slip to these
 * multiples of `unit` in the segments a, b, ..., each in one step. The springs of the law `linear` do not depend on
 * sizes, so a slip in +x is tried with a sphere in place of the wall. */
static struct nb_solution ladder(const char *law, double unit, const double *to, int count) {
  struct nb_solution solution;
  struct nb_error error = {0};
  char page[2048], *end = page;
  end += sprintf(end,
                 "path\nmaterial q young 2e6 poisson 0.3 kn 3 ks 40 friction 0.5\n"
                 "material w young 7e6 poisson 0.2 kn 5 ks 10 friction 0.6\n"
                 "contact sphere 0.02 q with %s w\nnormal hertz\nshear %s\nrecord step slip shear\n"
                 "segment press normal to 8 in 1 step\n",
                 strcmp(law, "linear") == 0 && unit > 0 ? "sphere 0.05" : "wall", law);
  for (int k = 0; k < count; k++)
    end += sprintf(end, "segment %c slip to %.17g in 1 step\n", 'a' + k, to[k] * unit);
  CU_ASSERT_EQUAL(refs_solve(&solution, "contact_ladder", page, &error), NB_OK);
  return solution;
}
/* Compares the shear force, in units of mu N = 4, and its work, in units of mu N times `unit`, at the end of each
 * segment. A NAN is not compared. */
static void check_ladder(const char *law, double unit, const double *to, const double *t, const double *work,
                         int count) {
  for (int side = -1; side <= 1; side += 2) {
    struct nb_solution solution = ladder(law, side * unit, to, count);
    for (int k = 0; k < count; k++) {
      char name[32];
      snprintf(name, sizeof name, "shear in %c", 'a' + k);
      const double found = refs_value(&solution, name);
      if (!(fabs(found - side * 4 * t[k]) < 1e-12))
        printf("# %s: %s to side %d is %.17g, expected %.17g\n", law, name, side, found, side * 4 * t[k]);
      CU_ASSERT(fabs(found - side * 4 * t[k]) < 1e-12);
      snprintf(name, sizeof name, "work.shear in %c", 'a' + k);
      CU_ASSERT(!work || isnan(work[k]) || fabs(refs_value(&solution, name) - work[k] * 4 * unit) < 1e-6 * unit);
    }
    CU_ASSERT_EQUAL(
        refs_value(&solution, "shear"),
        refs_value(&solution, (char[]){'s', 'h', 'e', 'a', 'r', ' ', 'i', 'n', ' ', (char)('a' + count - 1), 0}));
    solution_free(&solution);
  }
}
static double virgin(double d) { return 1 - pow(1 - d, 1.5); }
static double later(double d) { return 2 * (1 - pow(1 - d / 2, 1.5)); }
static void contact_ladder(void) {
  const double young = 1 / (0.91 / 2e6 + 0.96 / 7e6), g = 1 / (1.7 * 2.6 / 2e6 + 1.8 * 2.4 / 7e6);
  const double overlap = pow(8 / (4. / 3 * young * sqrt(0.02)), 2. / 3), stick = 8 * g * sqrt(0.02 * overlap);
  /* Springs: the slip in units of mu N/k. They slide in the second half of b and of d. */
  static const double to[] = {0.5, 1.5, 1, -2, -1.5}, t[] = {0.5, 1, 0.5, -1, -0.5};
  static const double worked[] = {0.125, 1, 0.625, 2.5, 2.125};
  static const char *const springs[] = {"linear", "mindlin", "mindlin_scaled"};
  for (int law = 0; law < 3; law++)
    check_ladder(springs[law], 4 / (law ? stick : 16), to, t, worked, 5);
  /* Micro-slip: the slip in units of A, at which the whole contact slides. */
  static const char *const laws[] = {"mindlin_deresiewicz", "randall", "randall_literal"};
  const double unit = 1.5 * 4 / stick;
  for (int law = 0; law < 3; law++) {
    /* Sliding, a reversal, sliding in the other direction beyond the end of the second branch, and back. */
    static const double slid[] = {0.3, 1, 1.7, 1.2, -0.3, -0.9, -0.5};
    const double sliding[] = {virgin(0.3), 1, 1, 1 - later(0.5), -1, -1, later(0.4) - 1};
    check_ladder(laws[law], unit, slid, sliding, NULL, 7);
    /* An unloading beyond the mirror image of the loading is virgin loading in the other direction. */
    static const double past[] = {0.6, -0.5, -0.7, -0.4, -0.8};
    const double mirrored[] = {virgin(0.6), virgin(0.6) - later(1.1), -virgin(0.7), later(0.3) - virgin(0.7),
                               -virgin(0.8)};
    check_ladder(laws[law], unit, past, mirrored, NULL, law < 2 ? 5 : 4);
    const double t2 = virgin(0.6) - later(0.5);
    if (law < 2) { /* a third branch, the return on it, a return to the second one, and to the first one */
      static const double nested[] = {0.6, 0.1, 0.4, 0.25, 0, 0.2, 0.7};
      const double third = t2 + later(0.3), t0 = virgin(0.6) - later(0.6);
      const double back = law ? t2 + later(0.15) : third - later(0.15);
      const double shear[] = {virgin(0.6), t2, third, back, t0, t0 + later(0.2), virgin(0.7)};
      check_ladder(laws[law], unit, nested, shear, NULL, 7);
    } else { /* The third branch ends at T*, and the first one goes on from there. */
      static const double nested[] = {0.6, 0.1, 0.2, 0.15, 0.05, 0.1, 0.7};
      const double u0 = virgin(0.6) - t2, end = 0.1 + 2 * (pow(1 + u0 / 2, 2. / 3) - 1);
#define THIRD(d) (virgin(0.6) - 2 * (pow(pow(1 + u0 / 2, 2. / 3) - ((d)-0.1) / 2, 1.5) - 1))
      const double shear[] = {virgin(0.6), t2, THIRD(0.2), THIRD(0.15), virgin(0.6) - later(0.55)};
      CU_ASSERT(end > 0.2 && end < 0.6);
      check_ladder(laws[law], unit, nested, shear, NULL, 5);
      static const double on[] = {0.6, 0.1, 0.57, 0.8};
      const double first[] = {virgin(0.6), t2, virgin(0.57 + 0.6 - end), virgin(0.8 + 0.6 - end)};
      CU_ASSERT(0.57 > end && 0.8 + 0.6 - end < 1);
      check_ladder(laws[law], unit, on, first, NULL, 4);
#undef THIRD
    }
    static const double once[] = {0.6, 0.2};
    const double forces[] = {virgin(0.6), virgin(0.6) - later(0.4)}, load = 0.6 - 0.4 * (1 - pow(0.4, 2.5)),
                 unload = -0.4 * (virgin(0.6) - 2) - 2 * 0.8 * (1 - pow(0.8, 2.5));
    const double works[] = {load, load + unload};
    check_ladder(laws[law], unit, once, forces, works, 2);
  }
  /* M-D: reversals within reversals */
  static const double nest[] = {0.8, -0.4, 0.5, -0.1, 0.3, 0, 0.2, -0.3};
  const double t2 = virgin(0.8) - later(1.2), t3 = t2 + later(0.9), t4 = t3 - later(0.6), t5 = t4 + later(0.4),
               t6 = t5 - later(0.3);
  const double nested[] = {virgin(0.8), t2, t3, t4, t5, t6, t6 + later(0.2), t3 - later(0.8)};
  check_ladder("mindlin_deresiewicz", unit, nest, nested, NULL, 8);
}

/* The largest error of psi2 in Maw's impact, with chi = 7/(4 kappa) and kappa = E* / (4 G*). */
static void psi2_error(void) {
  static const char *const laws[] = {"linear", "randall", "mindlin_deresiewicz", "randall_literal"};
  const double kappa = (1.7 * 2.6 / 2e6 + 1.8 * 2.4 / 7e6) / (0.91 / 2e6 + 0.96 / 7e6) / 4;
  for (int law = 0; law < 4; law++) {
    double most = 0;
    for (int k = 1; k <= 60 && law < 2; k++) {
      struct impact_path simple, exact;
      CU_ASSERT(impact_law(&simple, laws[law], 1.5, 1.75 / kappa, 0.1 * k, 4000));
      CU_ASSERT(impact_exact(&exact, 1.75 / kappa, 0.1 * k, 400));
      most = fmax(most, fabs(simple.psi2 - exact.psi2));
      impact_path_free(&simple), impact_path_free(&exact);
    }
    struct nb_solution solution = ladder(laws[law], 1, NULL, 0);
    const double *error = solution_find(&solution, "psi2 error");
    CU_ASSERT(law == 3 ? !error : error && fabs(*error - most) <= 1e-9 * most);
    solution_free(&solution);
  }
}

void suite_refs_ladder(void) {
  CU_pSuite suite = CU_add_suite("refs_ladder", NULL, refs_released);
  CU_ADD_TEST(suite, contact_ladder);
  CU_ADD_TEST(suite, psi2_error);
}
