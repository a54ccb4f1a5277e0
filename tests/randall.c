/* R89's law: the curves of constant N, its fronts, all four ways of N and T, and what the text as it stands makes of them.
 *
 * What it should be comes from the rings of the contact, T = mu Int D dN and delta = mu kappa Int D dx (docs/CONTACT.md, i), of
 * which [R89 3.25, 3.40, 3.50] are the cases of constant N. The law is of first order: an error halves with the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "spheres.h"
#include "suites.h"

/* ---- rings ---- */

/* The contact whose rings slipped to one side and the other: fronts[0] the innermost, outside of it D = sign, and so on. */
struct rings {
  double alpha, fronts[4];
  int count;
};

static double force(const struct rings *r) {
  double t = 0, side = 1;
  for (int k = 0; k < r->count; k++, side = -side)
    t += side * (press(k + 1 < r->count ? r->fronts[k + 1] : r->alpha) - press(r->fronts[k]));
  return mu * t;
}

/* To this overlap and slip (in all), while the last front goes in or is overtaken by no other: it is the one unknown. */
static void slip_to(struct rings *r, double alpha, double delta) {
  double inner = 0, side = 1;
  for (int k = 0; k + 1 < r->count; k++, side = -side)
    inner += side * (r->fronts[k + 1] - r->fronts[k]);
  double *front = &r->fronts[r->count - 1], *before = r->count > 1 ? front - 1 : NULL;
  /* delta/(mu kappa) = inner' + side (alpha - front), the ring before it ends at the front */
  const double others = before ? inner - -side * (*front - *before) : 0, want = delta / slope();
  *front = before ? (want - others - side * alpha - side * *before) / (-2 * side) : alpha - want;
  r->alpha = alpha;
}

/* After these segments, each of which is a reversal. */
static double shear_force(double alpha, const struct segment *segments, int count) {
  const double a = slope() * alpha;
  struct rings r = {alpha, {alpha}, 0};
  double delta = 0;
  for (int k = 0; k < count; k++) {
    r.fronts[r.count++] = r.alpha;
    delta += segments[k].slip * a;
    slip_to(&r, segments[k].alpha * alpha, delta);
  }
  return force(&r);
}

static double error_of(const char *law, const struct segment *segments, int count, int steps) {
  struct contact it = contact_of(law);
  const double alpha = deep(N);
  go(&it, alpha, 0);
  for (int k = 0; k < count; k++)
    lead(&it, segments[k].alpha * alpha, segments[k].slip * slope() * alpha, steps);
  return (it.s.force - shear_force(alpha, segments, count)) / (mu * N);
}

/* First order, and small: at 500 steps a segment it is below 1e-3 of mu N, at twice as many half of it. */
static void expect_first_order(const struct segment *segments, int count) {
  const double coarse = error_of("randall", segments, count, 500), fine = error_of("randall", segments, count, 1000);
  CU_ASSERT(fabs(coarse) < 2e-3 && fabs(fine - coarse / 2) < 0.05 * fabs(coarse) + 1e-7);
}

/* ---- constant N ---- */

/* [R89 3.25, 3.40, 3.50] solved for T; shear_force() returns the same, to rounding. */
static void curves_of_constant_normal_force(void) {
  static const struct segment segments[] = {{1, 0.7}, {1, -0.9}, {1, 0.6}};
  const double t1 = 1 - pow(1 - 0.7, 1.5), t2 = t1 - 2 * (1 - pow(1 - 0.9 / 2, 1.5));
  const double t3 = t2 + 2 * (1 - pow(1 - 0.6 / 2, 1.5)), t[] = {t1, t2, t3};
  for (int k = 0; k < 3; k++) {
    CU_ASSERT(fabs(shear_force(deep(N), segments, k + 1) - t[k] * mu * N) < 1e-13 * N);
    expect_first_order(segments, k + 1);
  }
}

/* Between T* and -T* a cycle loses  (24/5 (1 - (1-x)^(5/3)) - 4 x (1 + (1-x)^(2/3))) mu N A,  x = T*'/mu N: the area between 3.40 and its
 * mirror image. */
static void loop_loses_what_it_should(void) {
  const double x = 0.8, a = slope() * deep(N), star = a * (1 - pow(1 - x, 2. / 3));
  const double expected = (4.8 * (1 - pow(1 - x, 5. / 3)) - 4 * x * (1 + pow(1 - x, 2. / 3))) * mu * N * a;
  double errors[2];
  for (int k = 0; k < 2; k++) {
    const int steps = k ? 2000 : 1000;
    struct contact it = contact_of("randall");
    go(&it, deep(N), 0);
    lead(&it, deep(N), star, steps);
    const double before = it.work;
    lead(&it, deep(N), -2 * star, 2 * steps);
    lead(&it, deep(N), 2 * star, 2 * steps);
    errors[k] = (it.work - before) / expected - 1;
  }
  CU_ASSERT(expected > 0 && fabs(errors[0]) < 5e-3 && fabs(errors[1] - errors[0] / 2) < 0.1 * fabs(errors[0]));
}

/* Re-unloading goes back along the reloading curve: elastic, R89's approximation [R89 3.3]. */
static void unloading_again_retraces_reloading(void) {
  double errors[2];
  for (int k = 0; k < 2; k++) {
    const int steps = k ? 1000 : 500;
    const double a = slope() * deep(N);
    struct contact it = contact_of("randall");
    go(&it, deep(N), 0);
    lead(&it, deep(N), 0.8 * a, steps);
    lead(&it, deep(N), -1.2 * a, steps);
    lead(&it, deep(N), 0.4 * a, steps);
    const double half = it.s.force, before = it.work;
    lead(&it, deep(N), 0.4 * a, steps);
    lead(&it, deep(N), -0.4 * a, steps);
    errors[k] = (it.s.force - half) / (mu * N);
    CU_ASSERT(fabs(it.work - before) < 1e-3 * mu * N * a);
  }
  CU_ASSERT(fabs(errors[0]) < 1e-3 && fabs(errors[1] - errors[0] / 2) < 0.05 * fabs(errors[0]));
}

/* ---- N and T together ---- */

/* Loading, unloading and reloading, each with N rising and falling. */
static void all_ways_of_normal_and_tangential_force(void) {
  static const double alpha[3][2] = {{0.3, -0.15}, {0.2, -0.1}, {0.15, -0.05}}; /* more overlap */
  static const double slip[3][2] = {{0.8, 0.3}, {-0.5, -0.4}, {0.3, 0.1}};
  for (int ways = 0; ways < 8; ways++) {
    struct segment segments[3];
    double at = 1;
    for (int k = 0; k < 3; k++) {
      const int falls = ways >> k & 1;
      segments[k] = (struct segment){at += alpha[k][falls], slip[k][falls]};
      expect_first_order(segments, k + 1);
    }
  }
}

/* [R89 3.86] has mu (p0 + dp0)/c for a prefactor. N = 1, mu = 0.3, T = 0.2 mu. While N falls by 0.1 at
 * that T the front goes from c to c1, and the ring between has taken mu |dN| = 0.03, which mu (p0 + dp0)/a1 makes of it:
 * mu N1 (c^3 - c1^3)/a1^3. With the printed one it is 0.0312. The law says its fronts in dT/ds = 8 G* c. */
static void front_takes_what_the_edge_gives_up(void) {
  double ring[2], printed = 0;
  for (int k = 0; k < 2; k++) {
    struct contact it = contact_of("randall");
    it.pair.friction = 0.3;
    const int steps = k ? 4000 : 2000;
    const double kappa = E / (4 * G), at = deep(1), from = 0.3 * kappa * at * (1 - pow(0.8, 2. / 3));
    go(&it, at, 0);
    lead(&it, at, from, steps);
    CU_ASSERT(fabs(it.s.force - 0.06) < 1e-4);
    go(&it, at, 1e-12 * from);
    const double c = it.s.stiffness / (8 * G), b = sqrt(R * at);
    /* delta of T at N: mu kappa alpha (1 - (1 - T/mu N)^(2/3)) [R89 3.25] */
    double was = from;
    for (int j = 1; j <= steps; j++) {
      const double n = 1 - 0.1 * j / steps, is = 0.3 * kappa * deep(n) * (1 - pow(1 - 0.2 / n, 2. / 3));
      go(&it, deep(n), is - was), was = is;
    }
    CU_ASSERT(fabs(it.s.force - 0.06) < 1e-4);
    go(&it, deep(0.9), 1e-12 * from);
    const double c1 = it.s.stiffness / (8 * G), a1 = sqrt(R * deep(0.9));
    CU_ASSERT(c < b && c1 < c);
    ring[k] = 0.3 * 0.9 * (pow(c / a1, 3) - pow(c1 / a1, 3));
    printed = ring[k] * a1 / c;
  }
  CU_ASSERT(fabs(ring[1] - 0.03) < 2e-5 && fabs(ring[1] - 0.03) < 0.6 * fabs(ring[0] - 0.03));
  CU_ASSERT(fabs(printed - 0.0312) < 5e-5);
}

/* ---- what is remembered ---- */

enum { M_N, M_T, M_STAR, M_STAR2, M_DEFICIT, M_CDF, M_BRANCH };

static bool near(double is, double should, double scale) { return fabs(is - should) <= 1e-13 * fabs(scale); }

/* One step, and the T, T*, T** that it must lead to: dT is what comes after, the others move with N [R89 4.20, 4.21]. */
static void expect_step(struct contact *it, double overlap, double slip, double theta, double ufl) {
  double was[7];
  memcpy(was, it->m, sizeof was);
  go(it, overlap, slip);
  const double cdf = it->m[M_CDF], rise = mu * (press(overlap) - was[M_N]), push = 8 * G * sqrt(R * overlap) * slip;
  CU_ASSERT(near(it->m[M_N], press(overlap), N));
  CU_ASSERT(near(it->m[M_T] - was[M_T], theta * push + cdf * ufl * rise * (1 - theta), N));
  CU_ASSERT(near(it->s.stiffness, theta * 8 * G * sqrt(R * overlap), 8 * G * R));
  CU_ASSERT_EQUAL(it->s.force, it->m[M_T]);
  if (was[M_BRANCH] >= 1)
    CU_ASSERT(near(it->m[M_STAR] - was[M_STAR], cdf * rise, N));
  if (was[M_BRANCH] >= 2)
    CU_ASSERT(near(it->m[M_STAR2] - was[M_STAR2], -cdf * rise, N));
}

/* Step by step through all that can happen, loading to either side. */
static void what_is_remembered(void) {
  for (int side = -1; side <= 1; side += 2) {
    struct contact it = contact_of("randall");
    const double *m = it.m, a = side * slope() * deep(N), x[] = {deep(N), 1.01 * deep(N), 1.02 * deep(N)};
    double critical[3]; /* mu dN/(8 G* a) of the way up to x[1], to x[2], and down to x[1] */
    for (int k = 0; k < 3; k++)
      critical[k] = side * mu * (press(x[k == 1 ? 2 : 1]) - press(x[k])) / (8 * G * sqrt(R * x[k == 1 ? 2 : 1]));
    go(&it, x[0], 0); /* square: all sticks, no sense yet */
    CU_ASSERT(near(it.s.stiffness, 8 * G * sqrt(R * x[0]), 8 * G * R) && m[M_CDF] == 0);
    expect_step(&it, x[0], 0.2 * a, 1, 1);
    CU_ASSERT(m[M_CDF] == side && m[M_BRANCH] == 0 && m[M_DEFICIT] == 0);
    /* rings that stick: slip below ds_c, and none */
    expect_step(&it, x[1], 0.25 * critical[0], 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]), a));
    expect_step(&it, x[2], 0, 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]) + fabs(critical[1]), a));
    expect_step(&it, x[1], 0.1 * critical[2], 1,
                1); /* one leaves, and slip goes back: DD + ds_c - ds with both negative */
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]) + fabs(critical[1]) - 0.9 * fabs(critical[2]), a));
    const double made_up = side * m[M_DEFICIT];
    expect_step(&it, x[1], 0.4 * made_up, 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.6 * fabs(made_up), a));
    double theta = cbrt(1 - side * m[M_T] / (mu * press(x[1])));
    expect_step(&it, x[1], 0.6003 * made_up, theta, 1); /* enough for the front to go in */
    CU_ASSERT(m[M_DEFICIT] == 0 && m[M_BRANCH] == 0);
    /* a reversal, at a T* that dN moves in the very step */
    double before = m[M_T];
    expect_step(&it, x[2], -0.25 * critical[1], 1, -1);
    CU_ASSERT(m[M_BRANCH] == 1 && near(m[M_STAR], before + side * mu * (press(x[2]) - press(x[1])), N));
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[1]), a));
    expect_step(&it, x[2], -0.05 * a, cbrt(1 - side * (m[M_STAR] - m[M_T]) / (2 * mu * press(x[2]))), -1);
    CU_ASSERT(m[M_DEFICIT] == 0 && m[M_BRANCH] == 1);
    theta = cbrt(1 - (side * (m[M_STAR] - m[M_T]) + 2 * mu * (press(x[1]) - press(x[2]))) / (2 * mu * press(x[1])));
    expect_step(&it, x[1], -0.05 * a, theta, -1);
    /* slip goes on while N falls faster than the motion turns; then N has come to rest, and it is a reversal */
    theta = cbrt(1 - (side * (m[M_STAR] - m[M_T]) + 2 * mu * (press(x[0]) - press(x[1]))) / (2 * mu * press(x[0])));
    expect_step(&it, x[0], 0.5 * side * fabs(critical[0]), theta, -1);
    CU_ASSERT(m[M_BRANCH] == 1);
    before = m[M_T];
    expect_step(&it, x[1], 0.5 * critical[0], 1, 1);
    CU_ASSERT(m[M_BRANCH] == 2 && near(m[M_STAR2], before - side * mu * (press(x[1]) - press(x[0])), N));
    expect_step(&it, x[1], 0.05 * a, cbrt(1 - side * (m[M_T] - m[M_STAR2]) / (2 * mu * press(x[1]))), 1);
    /* back along the reloading curve, N rising and falling */
    expect_step(&it, x[2], -0.5 * critical[1], 1, 1);
    CU_ASSERT(m[M_BRANCH] == 3 && near(m[M_DEFICIT], 0.5 * fabs(critical[1]), a));
    expect_step(&it, x[2], -0.01 * a, cbrt(1 - side * (m[M_T] - m[M_STAR2]) / (2 * mu * press(x[2]))), 1);
    theta = cbrt(1 - (side * (m[M_T] - m[M_STAR2]) + 2 * mu * (press(x[1]) - press(x[2]))) / (2 * mu * press(x[1])));
    expect_step(&it, x[1], 0, theta, 1);
    CU_ASSERT(m[M_BRANCH] == 3);
    expect_step(&it, x[1], 0.01 * a, cbrt(1 - side * (m[M_T] - m[M_STAR2]) / (2 * mu * press(x[1]))), 1);
    CU_ASSERT(m[M_BRANCH] == 2 && m[M_CDF] == side);
    /* up past T*: virgin loading; and sliding, which forgets all; with less friction T is above the limit, and no front is left */
    lead(&it, x[1], 0.5 * a, 100);
    CU_ASSERT(m[M_BRANCH] == 0 && m[M_CDF] == side && it.s.sliding == 0);
    lead(&it, x[1], a, 100);
    CU_ASSERT(it.s.sliding == 1 && near(m[M_T], side * mu * press(x[1]), N) && m[M_BRANCH] == 0 && m[M_DEFICIT] == 0);
    it.pair.friction = mu / 2;
    go(&it, x[1], 0.01 * a);
    CU_ASSERT(it.s.sliding == 1 && it.s.stiffness == 0 && near(m[M_T], side * mu / 2 * press(x[1]), N));
    go(&it, x[1], -0.01 * a); /* and back */
    CU_ASSERT(m[M_BRANCH] == 1 && it.s.sliding == 0);
    lead(&it, x[1], -2 * a, 200);
    CU_ASSERT(m[M_BRANCH] == 0 && m[M_CDF] == -side && it.s.sliding == 1);
    it.pair.friction = 0;
    go(&it, x[1], a);
    CU_ASSERT(it.s.force == 0 && it.s.sliding == 1 && m[M_CDF] == 0 && near(m[M_N], press(x[1]), N));
    go(&it, x[1], 0);
    CU_ASSERT(it.s.force == 0 && it.s.sliding == 0);
  }
}

void suite_randall(void) {
  CU_pSuite suite = CU_add_suite("randall", NULL, NULL);
  CU_add_test(suite, "constant N: loading, unloading, reloading", curves_of_constant_normal_force);
  CU_add_test(suite, "what is remembered", what_is_remembered);
  CU_add_test(suite, "a closed loop loses what it should", loop_loses_what_it_should);
  CU_add_test(suite, "re-unloading retraces reloading", unloading_again_retraces_reloading);
  CU_add_test(suite, "N and T rising and falling", all_ways_of_normal_and_tangential_force);
  CU_add_test(suite, "the front takes what the edge gives up", front_takes_what_the_edge_gives_up);
}
