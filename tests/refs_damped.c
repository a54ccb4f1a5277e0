/* impact_damped, which the reference `rebound` uses for the exact contact with dashpots. It replaces the contact by many
 * springs. The tests compare it with known results without damping and in gross sliding, and check its convergence.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../cases/refs/hertz.h"
#include "../cases/refs/impact_springs.h"
#include "suites.h"

static const double chi = 1.4411764705882353, kappa = 1.2142857142857142; /* nu = 0.3 */

/* Without damping the error is of second order in the step: at most 1e-5 with 8000 steps. */
static void without_damping(void) {
  for (double psi1 = 0.5; psi1 < 6; psi1 += 0.9) {
    struct impact_path path;
    CU_ASSERT(impact_exact(&path, chi, psi1, 2000));
    CU_ASSERT_DOUBLE_EQUAL(impact_damped(chi, kappa, 0, psi1, 8000), path.psi2, 1e-5);
    impact_path_free(&path);
  }
}

/* The impulse of the normal dashpot is 0, because its force is a function of the overlap times the rate of the overlap,
 * and the overlap is 0 at both ends. So the impulse of N is (1 + e) M V_N, and the impulse of T is mu times that. */
static void gross_sliding(void) {
  for (double e = 0.2; e < 1; e += 0.2)
    for (int sign = -1; sign <= 1; sign += 2)
      CU_ASSERT_DOUBLE_EQUAL(sign * impact_damped(chi, kappa, hertz_ratio(e), 7 * sign, 4000), 7 - 2 * chi * (1 + e),
                             1e-6);
}

/* With half as many steps psi2 changes by at most the error that rebound.c states; and damping has an effect. */
static void converges(void) {
  static const struct {
    double e, error, effect; /* effect: smallest change of psi2 by the damping */
  } rows[] = {{0.5, 5e-4, 0.05}, {0.98, 2e-5, 5e-4}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (double psi1 = 0.5; psi1 < 4; psi1 += 0.7) {
      const double beta = hertz_ratio(rows[k].e), fine = impact_damped(chi, kappa, beta, psi1, 8000);
      CU_ASSERT_DOUBLE_EQUAL(impact_damped(chi, kappa, beta, psi1, 4000), fine, rows[k].error);
      CU_ASSERT(fabs(impact_damped(chi, kappa, 0, psi1, 4000) - fine) > rows[k].effect);
    }
}

void suite_refs_damped(void) {
  CU_pSuite suite = CU_add_suite("refs_damped", NULL, NULL);
  CU_add_test(suite, "without damping psi2 is that of the exact contact", without_damping);
  CU_add_test(suite, "in gross sliding psi2 equals the closed form", gross_sliding);
  CU_add_test(suite, "psi2 converges with the number of steps", converges);
}
