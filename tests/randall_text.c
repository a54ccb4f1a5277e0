/* The law of R89 as its subroutine FORD and its function THETA are printed, compared with the corrected law: the values
 * in which the two laws differ. The last tests are for functions that both laws share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <string.h>

#include "../src/laws/randall.h"
#include "chance.h"
#include "spheres.h"
#include "suites.h"

/* theta of the last step. */
static double theta_of(const struct contact *it) { return it->s.stiffness / (8 * G * sqrt(R * it->overlap)); }

static void theta_of_first_steps(void) {
  const double a = slope() * deep(N), h = 1e-4 * a;
  struct contact text = contact_of("randall_literal"), best = contact_of("randall");
  struct contact *both[] = {&text, &best};
  for (int k = 0; k < 2; k++) {
    go(both[k], deep(N), 0);
    lead(both[k], deep(N), 0.7 * a, 2000);
  }
  CU_ASSERT(fabs(text.s.force - best.s.force) == 0); /* virgin loading at constant N does not differ */
  const double t = text.s.force / (mu * N);
  go(&text, deep(N), -h), go(&best, deep(N), -h);
  CU_ASSERT(fabs(theta_of(&text) - cbrt(1 + t / 2)) < 1e-12 &&
            fabs(theta_of(&text) - 1.1234) < 1e-4); /* T* has no value yet */
  CU_ASSERT_EQUAL(theta_of(&best), 1);
  for (int k = 0; k < 2; k++) {
    lead(both[k], deep(N), -0.6 * a, 2000);
    go(both[k], deep(N), h);
  }
  const double back = (text.m[2] - text.m[3]) / (mu * N); /* T* - T** */
  CU_ASSERT(fabs(theta_of(&text) - cbrt(1 + back / 2)) < 1e-12 &&
            fabs(theta_of(&text) - 1.1225) < 1e-4); /* [R89 4.24] has T* in place of T** */
  CU_ASSERT_EQUAL(theta_of(&best), 1);
}

/* ---- the printed law, one step at a time ---- */

/* What a step does to T* or T**: it has no value; it becomes T; it changes by mu dN; it does not change; it becomes 0. */
enum fate { NONE, SET, MOVED, KEPT, CLEARED };

/* The state of a contact with CDF = 1: T, T* and T** in units of mu N, and DD in units of A = mu kappa alpha. A step: ds
 * in units of A, and dN in units of N. The result by the printed equations: THE1, which selects the formula of theta;
 * UFL, which is 1 for loading and -1 for unloading; the equation that changes DD (417 is [R89 4.17], 418 is [R89 4.18],
 * 0 is none); and what happens to T* and T**. */
struct text_step {
  double t, star, star2, deficit, slip, more;
  int the1, ufl, dd;
  enum fate star_, star2_;
};

static const struct text_step text_steps[] = {
    /* N constant: virgin loading, unloading (first and later steps), reloading (first and later steps), unloading
     * again and past T** */
    {0.5, 0, 0, 0, 0.1, 0, 1, 1, 0, NONE, NONE},
    {0.5, 0, 0, 0, -0.1, 0, 2, -1, 417, SET, NONE},
    {0.2, 0.6, 0, 0, -0.1, 0, 2, -1, 417, KEPT, NONE},
    {0.2, 0.6, 0, 0, 0.1, 0, 3, 1, 0, KEPT, SET},
    {0.3, 0.6, 0.1, 0, 0.05, 0, 3, 1, 0, KEPT, KEPT},
    {0.3, 0.6, 0.1, 0, -0.05, 0, 3, -1, 417, KEPT, KEPT},
    {0.3, 0.6, 0.1, 0, -0.2, 0, 3, -1, 417, KEPT, CLEARED},
    {0.05, 0.6, 0.1, 0, -0.05, 0, 2, -1, 417, KEPT, CLEARED},
    {-0.3, 0.6, -0.4, 0, -0.03, 0, 3, -1, 417, KEPT, KEPT},
    /* |T| near |T*|, and T near T** */
    {0.5995, 0.6, 0.1, 0, 1e-4, 0, 3, 1, 0, KEPT, KEPT},
    {0.6005, 0.6, 0.1, 0, 1e-4, 0, 1, 1, 0, CLEARED, CLEARED},
    {-0.5995, 0.6, -0.7, 0, 1e-4, 0, 3, 1, 0, KEPT, KEPT},
    {-0.6005, 0.6, -0.7, 0, 1e-4, 0, 1, 1, 0, CLEARED, CLEARED},
    {0.1001, 0.6, 0.1, 0, -2e-5, 0, 3, -1, 417, KEPT, KEPT},
    {0.0999, 0.6, 0.1, 0, -2e-5, 0, 2, -1, 417, KEPT, CLEARED},
    {0.599, 0.6, 0.1, 0, 0.1, 0, 3, 1, 0, CLEARED, CLEARED},
    {-0.5, 0.6, 0, 0, -0.2, 0, 2, -1, 417, CLEARED, NONE},
    /* N rises by 1 %: ds_c = 0.0066 A; THE1 = 4 up to the slip mu ds_c + DD */
    {0.5, 0, 0, 0, 0.1, 0.01, 1, 1, 0, NONE, NONE},
    {0.5, 0, 0, 0, 0.004, 0.01, 1, 1, 417, NONE, NONE},
    {0.5, 0, 0, 0, 0.001, 0.01, 4, 1, 417, NONE, NONE},
    {0.5, 0, 0, 0.05, 0.1, 0.01, 1, 1, 417, NONE, NONE},
    {0.5, 0, 0, 0.05, 0.05131, 0.01, 4, 1, 417, NONE, NONE}, /* ds_c is 0.006645 A, mu ds_c 0.001329 A */
    {0.5, 0, 0, 0.05, 0.05135, 0.01, 1, 1, 417, NONE, NONE},
    {0.5, 0, 0, 0, 0.006642, 0.01, 1, 1, 417, NONE, NONE}, /* dT is 0.9997 mu dN */
    {0.5, 0, 0, 0, 0.006648, 0.01, 1, 1, 0, NONE, NONE},
    {0.5, 0, 0, -0.05, 0.1, 0.01, 1, 1, 0, NONE, NONE},
    {0.5, 0, 0, -0.05, 0.004, 0.01, 1, 1, 417, NONE, NONE},
    {0.5, 0, 0, 0, -0.1, 0.01, 4, -1, 417, SET, NONE},
    {0.5, 0, 0, -0.2, -0.1, 0.01, 2, -1, 417, SET, NONE},
    {0.2, 0.6, 0, -0.2, -0.1, 0.01, 2, -1, 417, MOVED, NONE},
    {0.2, 0.6, 0, 0, 0.1, 0.01, 3, 1, 0, KEPT, SET},
    {0.2, 0.6, 0.1, 0, 0.1, 0.01, 3, 1, 0, MOVED, MOVED},
    {0.2, 0.6, 0.1, 0, -0.03, 0.01, 4, -1, 417, MOVED, MOVED},
    {0.2, 0.6, 0.1, -0.2, -0.03, 0.01, 3, -1, 417, MOVED, MOVED},
    {0.2, 0.6, 0.1, 0, 0, 0.01, 0, 1, 0, MOVED, MOVED},
    /* N falls: of ds only the sign matters for THE1 and UFL, not its size */
    {0.5, 0, 0, 0, 0.1, -0.01, 1, 1, 418, NONE, NONE},
    {0.5, 0, 0, 0.3, 0.1, -0.01, 1, 1, 418, NONE, NONE},
    {0.5, 0, 0, 0, -0.001, -0.01, 2, -1, 418, SET, NONE},
    {0.2, 0.6, 0, 0.1, -0.1, -0.01, 2, -1, 418, MOVED, NONE},
    {0.2, 0.6, 0, 0.1, 0.1, -0.01, 3, 1, 418, KEPT, SET},
    {0.2, 0.6, 0.1, 0.1, 0.1, -0.01, 3, 1, 418, MOVED, MOVED},
    {0.2, 0.6, 0.1, 0.1, -0.03, -0.01, 3, -1, 418, MOVED, MOVED},
    {0.2, 0.6, 0.1, 0.1, 0, -0.01, 0, 1, 0, MOVED, MOVED},
    /* sliding at mu N in both directions */
    {0.9, 0, 0, 0, 2, 0, 1, 1, 0, NONE, NONE},
    {-0.5, 0.6, 0, 0, -1, 0, 2, -1, 417, CLEARED, NONE},
};

/* The value of T* or T** after a step: `was` is its value before the step, `before` is T, `drift` is its change by dN. */
static double fate(enum fate of, double was, double before, double drift) {
  return of == SET ? before : of == MOVED ? was + drift : of == KEPT ? was : 0;
}

/* Each step of the table, computed by [R89 4.15-4.25] as printed, for both signs of CDF. */
static void printed_law_step_by_step(void) {
  for (size_t k = 0; k < 2 * sizeof text_steps / sizeof *text_steps; k++) {
    const struct text_step *it = &text_steps[k / 2];
    const double cdf = k % 2 ? -1 : 1, f = mu * N * cdf, a = slope() * deep(N), n = (1 + it->more) * N;
    struct contact c = contact_of("randall_literal");
    const double was[5] = {press(deep(N)), it->t * f, it->star * f, it->star2 * f, it->deficit * a},
                 ds = it->slip * a * cdf;
    memcpy(c.m, was, sizeof was);
    go(&c, deep(n), ds);
    const double rise = mu * (press(deep(n)) - was[0]), limit = mu * press(deep(n)), stiff = 8 * G * sqrt(R * deep(n));
    const double t = was[1], star = was[2];
    const double theta = it->the1 == 1   ? cbrt(1 - (t * cdf + rise) / limit)
                         : it->the1 == 2 ? cbrt(1 - (star * cdf - t * cdf + 2 * rise) / (2 * limit))
                         : it->the1 == 3 ? cbrt(1 - (t * cdf - star * cdf + 2 * rise) / (2 * limit))
                                         : 1;
    const double dt = it->slip == 0 ? 0 : cdf * (theta * (stiff * ds * cdf - rise * it->ufl) + rise * it->ufl);
    const bool slides = fabs(t + dt) > limit;
    const double ends = slides ? copysign(limit, t + dt) : t + dt, critical = rise / stiff;
    const double dd = it->dd == 417 ? critical - ds * cdf : it->dd == 418 ? critical : 0;
    const double should[5] = {press(deep(n)), ends, fate(it->star_, star, t, cdf * rise),
                              fate(it->star2_, was[3], t, -cdf * rise), was[4] + dd};
    bool right = fabs(c.s.stiffness - theta * stiff) < 1e-13 * stiff && c.s.force == c.m[1] && c.s.sliding == slides;
    for (int m = 0; m < 5; m++)
      right = right && fabs(c.m[m] - should[m]) <= 1e-13 * (m == 4 ? a : N);
    CU_ASSERT(right);
    if (!right)
      printf("# step %zu of the table, CDF %g: theta %.6g for %.6g\n", k / 2 + 1, cdf, c.s.stiffness / stiff, theta);
  }
}

/* While N falls, [R89 4.18] subtracts |ds_c| from DD, although the contact has no ring that sticks and no deficit. With
 * this negative DD, slip begins too early when N rises again, while the new ring still sticks. */
static void deficit_while_N_falls(void) {
  struct contact text = contact_of("randall_literal"), best = contact_of("randall");
  const double a = slope() * deep(N);
  go(&text, deep(N), 0), go(&best, deep(N), 0);
  lead(&text, deep(0.8 * N), 0.5 * a, 100), lead(&best, deep(0.8 * N), 0.5 * a, 100);
  CU_ASSERT(fabs(text.m[4] / a + 0.1383) < 1e-4 && best.m[4] == 0);
}

/* The work of T in a cycle, over mu N A. In the cycle the normal force rises to 2 N, the contact slips by `way` times A,
 * the normal force falls to N, and the contact slips back. */
static double work_of_a_cycle(struct contact *it, double way) {
  const double a = slope() * deep(N), before = it->work;
  lead(it, deep(2 * N), 0, 2000), lead(it, deep(2 * N), way * a, 2000);
  lead(it, deep(N), 0, 2000), lead(it, deep(N), -way * a, 2000);
  return (it->work - before) / (mu * N * a);
}

/* Both laws declare that they may gain energy, which is a negative work. The corrected law gains energy in the second
 * cycle, the printed law already in the first one. */
static void gain_of_energy(void) {
  struct contact best = contact_of("randall"), text = contact_of("randall_literal");
  go(&best, deep(N), 0), go(&text, deep(N), 0);
  CU_ASSERT(fabs(work_of_a_cycle(&best, 0.2) - 0.0096) < 1e-4 && fabs(work_of_a_cycle(&best, 0.2) + 0.0074) < 1e-4);
  CU_ASSERT(fabs(work_of_a_cycle(&text, 0.2) + 0.0067) < 1e-4 && fabs(work_of_a_cycle(&text, 0.2) + 0.0113) < 1e-4);
  struct contact more = contact_of("randall_literal");
  go(&more, deep(N), 0);
  CU_ASSERT(work_of_a_cycle(&more, 0.4) < 0 && fabs(work_of_a_cycle(&more, 0.4) + 0.0471) < 1e-4);
}

/* ---- parts of both laws ---- */

static void cube_root_is_close(void) {
  struct chance chance = chance_begin(5);
  double most = 0;
  for (int k = 0; k < 100000; k++) {
    const double x = chance_scale(&chance, k % 2 ? 1e-300 : 1e-3, k % 2 ? 1e300 : 2), y = cbrt(x);
    most = fmax(most, fabs(cube_root(x) - y) / y);
    CU_ASSERT(cube_root(-x) == -cube_root(x));
  }
  CU_ASSERT(most < 4 * DBL_EPSILON && cube_root(0) == 0 && cube_root(1) == 1 && cube_root(8) == 2);
}

/* A contact may begin with only a normal force. Its history then has only N. At the first tangential
 * displacement the whole contact circle sticks, unless there is no friction. */
static void first_touch_without_slip(void) {
  static const char *const laws[] = {"randall", "randall_literal"};
  for (int k = 0; k < 2; k++) {
    struct contact it = contact_of(laws[k]);
    for (int j = 1; j < 8; j++)
      it.m[j] = 1e9; /* old values, which have no effect because m[0] = 0 */
    const double a = slope() * deep(N);
    go(&it, deep(N), 0);
    CU_ASSERT(it.s.force == 0 && it.s.sliding == 0 && it.m[0] > 0);
    lead(&it, deep(2 * N), 0, 10);
    CU_ASSERT_EQUAL(it.s.force, 0);
    go(&it, deep(2 * N), 1e-6 * a);
    CU_ASSERT(fabs(it.s.force / (8 * G * sqrt(R * deep(2 * N)) * 1e-6 * a) - 1) < 1e-12);
    struct contact smooth = contact_of(laws[k]);
    smooth.pair.friction = 0; /* the contact slides as soon as it moves */
    go(&smooth, deep(N), 0);
    CU_ASSERT(smooth.s.force == 0 && smooth.s.sliding == 0);
    go(&smooth, deep(N), 1e-6 * a);
    CU_ASSERT(smooth.s.force == 0 && smooth.s.sliding == 1);
  }
}

void suite_randall_text(void) {
  CU_pSuite suite = CU_add_suite("randall_text", NULL, NULL);
  CU_add_test(suite, "theta of first steps", theta_of_first_steps);
  CU_add_test(suite, "the printed law, one step at a time", printed_law_step_by_step);
  CU_add_test(suite, "DD while N falls", deficit_while_N_falls);
  CU_add_test(suite, "gain of energy", gain_of_energy);
  CU_add_test(suite, "the cube root", cube_root_is_close);
  CU_add_test(suite, "first touch without slip", first_touch_without_slip);
}
