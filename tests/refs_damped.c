/* The reference `rebound` of the exact contact with dashpots, which replaces the contact by many springs: without
 * damping, in gross sliding, and its convergence.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../cases/refs/hertz.h"
#include "../cases/refs/impact_springs.h"
#include "suites.h"

static const double chi = 1.4411764705882353, kappa = 1.2142857142857142; /* nu = 0.3 */

/* 4000 springs and leapfrog: the error is second order in the step, 1e-5 at most. */
static void without_damping(void) {
  for (double psi1 = 0.5; psi1 < 6; psi1 += 0.9) {
    struct impact_path path;
    CU_ASSERT(impact_exact(&path, chi, psi1, 2000));
    CU_ASSERT_DOUBLE_EQUAL(impact_damped(chi, kappa, 0, psi1, 8000), path.psi2, 1e-5);
    impact_path_free(&path);
  }
}

/* The impulse of the dashpot from overlap 0 to overlap 0 is zero, so the impulse of T is mu (1 + e) M V_N. */
static void gross_sliding(void) {
  for (double e = 0.2; e < 1; e += 0.2)
    CU_ASSERT_DOUBLE_EQUAL(impact_damped(chi, kappa, hertz_ratio(e), 7, 4000), 7 - 2 * chi * (1 + e), 1e-6);
}

/* With half as many steps psi2 changes by at most 5e-4, the error that rebound.c states; and damping has an effect. */
static void converges(void) {
  for (double psi1 = 0.5; psi1 < 4; psi1 += 0.7) {
    const double beta = hertz_ratio(0.5), fine = impact_damped(chi, kappa, beta, psi1, 8000);
    CU_ASSERT_DOUBLE_EQUAL(impact_damped(chi, kappa, beta, psi1, 4000), fine, 5e-4);
    CU_ASSERT(fabs(impact_damped(chi, kappa, 0, psi1, 4000) - fine) > 0.05);
  }
}

void suite_refs_damped(void) {
  CU_pSuite suite = CU_add_suite("refs_damped", NULL, NULL);
  CU_add_test(suite, "without damping it equals the undamped exact contact", without_damping);
  CU_add_test(suite, "gross sliding equals the closed form", gross_sliding);
  CU_add_test(suite, "it converges with the number of steps", converges);
}
