/* The law of R89 compared with the exact law, along random paths and in an impact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "../cases/refs/impact_springs.h"
#include "chance.h"
#include "spheres.h"
#include "suites.h"

/* A random segment that begins at the overlap `at`, with slip in the direction `side`: N is constant, N rises more
 * slowly than the slip, or N falls. While N falls, the slip may also be slower than the fall of N and in either
 * direction, except in the first segment of a direction. */
static struct segment segment_by(struct chance *chance, double at, double side, bool first) {
  const int kind = (int)chance_between(chance, 0, 4);
  const double slip = side * chance_between(chance, 0.05, 0.8);
  if (kind == 0)
    return (struct segment){at, slip};
  if (kind == 1)
    return (struct segment){at + fabs(slip) * chance_between(chance, 0.1, 0.9), slip};
  const double down = chance_between(chance, 0.02, 0.25) * at;
  if (kind == 2 || first) /* the slip is fast enough for a reversal */
    return (struct segment){at - down, side * (down * 1.1 + fabs(slip))};
  return (struct segment){at - down, side * chance_between(chance, -0.9, 0.5) * down};
}

/* The largest difference of T between both laws along these segments, over the initial mu N. */
static double largest_difference(const struct segment *segments, int count, int steps) {
  struct contact it = contact_of("randall"), exact = contact_of("mindlin_deresiewicz");
  const double alpha = deep(N), a = slope() * alpha;
  double most = 0;
  go(&it, alpha, 0), go(&exact, alpha, 0);
  for (int k = 0; k < count; k++) {
    const double from = it.overlap, to = segments[k].alpha * alpha;
    for (int j = 1; j <= steps; j++) {
      go(&it, from + (to - from) * j / steps, segments[k].slip * a / steps);
      go(&exact, it.overlap, segments[k].slip * a / steps);
      most = fmax(most, fabs(it.s.force - exact.s.force) / (mu * N));
      CU_ASSERT(it.s.stiffness >= 0 && it.s.stiffness <= 8 * G * sqrt(R * it.overlap));
    }
  }
  return most;
}

/* R89's law stores two reversals. With up to two reversals it is exact in the limit of small steps: on random paths the
 * error falls with the step. */
static void two_reversals_are_exact_in_the_limit(void) {
  struct chance chance = chance_begin(3);
  double most = 0, finest = 0, sum = 0, finer = 0;
  for (int path = 0; path < 300; path++) {
    struct segment segments[6];
    double at = 1;
    for (int k = 0; k < 6; k++) {
      segments[k] = segment_by(&chance, at, k / 2 == 1 ? -1 : 1, k % 2 == 0);
      at = segments[k].alpha;
    }
    const double coarse = largest_difference(segments, 6, 500), fine = largest_difference(segments, 6, 2000);
    most = fmax(most, coarse), finest = fmax(finest, fine), sum += coarse / 300, finer += fine / 300;
  }
  CU_ASSERT(most < 3e-3 && finest < most / 3 && finer < sum / 3.6);
}

/* More than two nested reversals at constant N: R89's law treats the inner ones as elastic. The largest error of T is
 * between 7 % and 9 % of mu N. */
static void more_reversals_have_an_error(void) {
  struct chance chance = chance_begin(4);
  double most[7] = {0};
  for (int path = 0; path < 300; path++) {
    struct segment segments[6];
    double slip = chance_between(&chance, 0.3, 1);
    for (int k = 0; k < 6; k++) {
      segments[k] = (struct segment){1, k % 2 ? -slip : slip};
      slip *= chance_between(&chance, 0.3, 0.98);
      most[k] = fmax(most[k], largest_difference(segments, k + 1, 1000));
    }
  }
  CU_ASSERT(most[2] < 3e-4 && most[3] > 0.07 && most[5] < 0.09);
}

/* ---- in an impact ---- */

static const double chi28 = 0.72 / 1.72 * 3.5; /* nu = 0.28 [R89 5.14] */

/* psi2 of Maw's impact with this law, in the units of impact_springs.h. */
static double rebound(const char *law, double friction, double psi1, int steps) {
  struct contact it = contact_of(law);
  const double dt = IMPACT_DURATION / steps, alpha = deep(N), a = friction * E / (4 * G) * alpha;
  double *xi = impact_approach(steps), psi = psi1;
  it.pair.friction = friction;
  CU_ASSERT_PTR_NOT_NULL_FATAL(xi);
  for (int k = 0; k < steps; k++) { /* leapfrog; the last step ends at separation */
    psi -= 2.5 * chi28 * it.s.force / (friction * N) * (k ? dt : dt / 2);
    if (k + 1 < steps)
      go(&it, xi[k + 1] * alpha, psi * dt * a);
  }
  free(xi);
  return psi;
}

/* The error of psi2 by the corrected law of R89 is at most 0.15, and less than 0.001 from psi1 = 3 on
 * (cases/4-oblique/oblique-impact-laws.md). */
static void known_error_in_an_impact(void) {
  double most = 0, where = 0, later = 0;
  for (double psi1 = 0.1; psi1 < 6; psi1 += 0.1) {
    struct impact_path path;
    CU_ASSERT(impact_exact(&path, chi28, psi1, 400));
    const double off = fabs(rebound("randall", mu, psi1, 4000) - path.psi2);
    where = off > most ? psi1 : where, most = fmax(most, off), later = psi1 > 2.95 ? fmax(later, off) : 0;
    impact_path_free(&path);
  }
  CU_ASSERT(fabs(most - 0.15) < 0.005 && fabs(where - 0.9) < 0.05 && later < 0.001);
}

/* The results of the law as printed depend on rounding. It has the factor mu twice in the critical displacement. So a
 * contact that should stick (psi1 < 1) slides from first touch, and T equals mu N to the last bit. If dT < mu dN, DD
 * grows and the contact sticks; the result of this comparison is random. With the friction coefficient 1/8, mu N has no
 * rounding error, and psi2 is 0.369. With a friction coefficient that is larger by the fraction 5e-16, psi2 is 0.195. The
 * exact value is 0.045. */
static void printed_law_depends_on_the_last_bit(void) {
  struct impact_path path;
  CU_ASSERT(impact_exact(&path, chi28, 0.7, 400));
  const double even = rebound("randall_literal", 0.125, 0.7, 20000);
  const double odd = rebound("randall_literal", 0.125 * (1 + 5e-16), 0.7, 20000);
  CU_ASSERT(fabs(even - 0.369) < 0.001 && fabs(odd - 0.195) < 0.001 && fabs(path.psi2 - 0.045) < 0.001);
  const double best = rebound("randall", 0.125, 0.7, 20000);
  CU_ASSERT(fabs(rebound("randall", 0.125 * (1 + 5e-16), 0.7, 20000) - best) < 1e-9);
  impact_path_free(&path);
}

void suite_randall_exact(void) {
  CU_pSuite suite = CU_add_suite("randall_exact", NULL, NULL);
  CU_add_test(suite, "two reversals are exact in the limit", two_reversals_are_exact_in_the_limit);
  CU_add_test(suite, "more than two reversals have an error", more_reversals_have_an_error);
  CU_add_test(suite, "known error in an impact", known_error_in_an_impact);
  CU_add_test(suite, "the printed law depends on the last bit", printed_law_depends_on_the_last_bit);
}
