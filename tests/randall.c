/* The law of R89: the curves at constant normal force N, the slip front, N and the shear force T rising and falling, the
 * stored history.
 *
 * Expected values are sums over the rings of the contact circle: T = mu Int D dN, and the tangential displacement is
 * delta = mu kappa Int D dx (docs/CONTACT.md, equation (i)). D is the traction of a ring over its friction limit, and x
 * is the overlap at which the ring was added. With constant N these are [R89 3.25, 3.40, 3.50]. The law is of first
 * order: its error halves with the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "spheres.h"
#include "suites.h"

/* ---- rings ---- */

/* A contact whose rings have slipped in alternating directions. fronts[] are overlaps, from inside to outside: D = 0
 * inside fronts[0], 1 up to fronts[1], then -1, and so on. */
struct rings {
  double alpha, fronts[4];
  int count;
};

/* T = mu Int D dN. */
static double force(const struct rings *r) {
  double t = 0, side = 1;
  for (int k = 0; k < r->count; k++, side = -side)
    t += side * (press(k + 1 < r->count ? r->fronts[k + 1] : r->alpha) - press(r->fronts[k]));
  return mu * t;
}

/* Advances to this overlap and this total displacement. The last front is the only unknown, as long as it does not pass
 * another front. */
static void slip_to(struct rings *r, double alpha, double delta) {
  double inner = 0, side = 1;
  for (int k = 0; k + 1 < r->count; k++, side = -side)
    inner += side * (r->fronts[k + 1] - r->fronts[k]);
  double *front = &r->fronts[r->count - 1], *before = r->count > 1 ? front - 1 : NULL;
  /* delta/(mu kappa) = others - side (front - before) + side (alpha - front). The rings up to the front `before` give
   * `others`. The ring between `before` and the last front has slipped in the other direction. */
  const double others = before ? inner - -side * (*front - *before) : 0, want = delta / slope();
  *front = before ? (want - others - side * alpha - side * *before) / (-2 * side) : alpha - want;
  r->alpha = alpha;
}

/* The shear force after these segments, each of which begins with a reversal. */
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

/* The error of T after these segments, over mu N, if each segment has this number of steps. */
static double error_of(const char *law, const struct segment *segments, int count, int steps) {
  struct contact it = contact_of(law);
  const double alpha = deep(N);
  go(&it, alpha, 0);
  for (int k = 0; k < count; k++)
    lead(&it, segments[k].alpha * alpha, segments[k].slip * slope() * alpha, steps);
  return (it.s.force - shear_force(alpha, segments, count)) / (mu * N);
}

/* The error is of first order: below 2e-3 mu N with 500 steps a segment, and half of it with twice as many. */
static void expect_first_order(const struct segment *segments, int count) {
  const double coarse = error_of("randall", segments, count, 500), fine = error_of("randall", segments, count, 1000);
  CU_ASSERT(fabs(coarse) < 2e-3 && fabs(fine - coarse / 2) < 0.05 * fabs(coarse) + 1e-7);
}

/* ---- constant N ---- */

/* shear_force() equals [R89 3.25, 3.40, 3.50], solved for T, to rounding. */
static void curves_of_constant_normal_force(void) {
  static const struct segment segments[] = {{1, 0.7}, {1, -0.9}, {1, 0.6}};
  const double t1 = 1 - pow(1 - 0.7, 1.5), t2 = t1 - 2 * (1 - pow(1 - 0.9 / 2, 1.5));
  const double t3 = t2 + 2 * (1 - pow(1 - 0.6 / 2, 1.5)), t[] = {t1, t2, t3};
  for (int k = 0; k < 3; k++) {
    CU_ASSERT(fabs(shear_force(deep(N), segments, k + 1) - t[k] * mu * N) < 1e-13 * N);
    expect_first_order(segments, k + 1);
  }
}

/* A cycle between T* and -T* loses (24/5 (1 - (1-x)^(5/3)) - 4 x (1 + (1-x)^(2/3))) mu N A, with x = T* / (mu N) and
 * A = mu kappa alpha. This is the area between the curve [R89 3.40] and its mirror image. */
static void loss_of_a_closed_loop(void) {
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

/* The contact at constant N after two tangential displacements, in units of A = mu kappa alpha. */
static struct contact contact_after(double first, double second, int steps) {
  const double a = slope() * deep(N);
  struct contact it = contact_of("randall");
  go(&it, deep(N), 0);
  lead(&it, deep(N), first * a, steps);
  lead(&it, deep(N), second * a, steps);
  return it;
}

/* Unloading beyond -T* is virgin loading in the other sense [R89 3.25]. */
static void unloading_beyond_the_mirror_image_is_virgin(void) {
  double errors[2];
  for (int k = 0; k < 2; k++)
    errors[k] = contact_after(0.3, -1, k ? 1000 : 500).s.force / (mu * N) + (1 - pow(1 - 0.7, 1.5));
  CU_ASSERT(fabs(errors[0]) < 3e-3 && fabs(errors[1] - errors[0] / 2) < 0.1 * fabs(errors[0]));
}

/* Unloading again retraces the reloading curve without loss, which is R89's approximation [R89 sec. 3.3]. */
static void unloading_again_retraces_reloading(void) {
  double errors[2];
  for (int k = 0; k < 2; k++) {
    const int steps = k ? 1000 : 500;
    const double a = slope() * deep(N);
    struct contact it = contact_after(0.8, -1.2, steps);
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
  static const double alpha[3][2] = {{0.3, -0.15}, {0.2, -0.1}, {0.15, -0.05}}; /* increase if N rises; if N falls */
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

/* [R89 3.86] is printed with the prefactor mu (p0 + dp0)/c; it should be mu (p0 + dp0)/a1. p0 is the largest pressure.
 *
 * The test has N = 1, mu = 0.3 and T = 0.2 mu N. While N falls to N1 = 0.9 at constant T, the contact radius becomes a1,
 * and the front moves from c to c1. The ring between c1 and c must take the force mu |dN| = 0.03. With the prefactor
 * mu (p0 + dp0)/a1 its force is mu N1 (c^3 - c1^3)/a1^3, which is 0.03. The printed prefactor gives 0.0312. The fronts of
 * the law follow from its dT/ds = 8 G* c. */
static void slip_front_while_N_falls(void) {
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

/* ---- the history ---- */

enum { M_N, M_T, M_STAR, M_STAR2, M_DEFICIT, M_CDF, M_BRANCH };

static bool near(double is, double should, double scale) { return fabs(is - should) <= 1e-13 * fabs(scale); }

/* Makes one step and tests T, T* and T**. dT must follow from `theta` and from `ufl`, which is 1 for loading and -1 for
 * unloading. T* and T** must change by mu dN [R89 4.20, 4.21]. */
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

/* Step by step through all branches, with loading in both directions. */
static void the_history(void) {
  for (int side = -1; side <= 1; side += 2) {
    struct contact it = contact_of("randall");
    const double *m = it.m, a = side * slope() * deep(N), x[] = {deep(N), 1.01 * deep(N), 1.02 * deep(N)};
    double critical[3]; /* mu dN/(8 G* a) of the steps x[0] to x[1], x[1] to x[2], x[2] to x[1] */
    for (int k = 0; k < 3; k++)
      critical[k] = side * mu * (press(x[k == 1 ? 2 : 1]) - press(x[k])) / (8 * G * sqrt(R * x[k == 1 ? 2 : 1]));
    go(&it, x[0], 0); /* normal force alone: the contact sticks and has no loading direction yet */
    CU_ASSERT(near(it.s.stiffness, 8 * G * sqrt(R * x[0]), 8 * G * R) && m[M_CDF] == 0);
    expect_step(&it, x[0], 0.2 * a, 1, 1);
    CU_ASSERT(m[M_CDF] == side && m[M_BRANCH] == 0 && m[M_DEFICIT] == 0);
    /* rings that stick: slip below ds_c, then no slip */
    expect_step(&it, x[1], 0.25 * critical[0], 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]), a));
    expect_step(&it, x[2], 0, 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]) + fabs(critical[1]), a));
    /* N falls while the slip is reversed: DD becomes DD + ds_c - ds, with negative ds_c and ds. */
    expect_step(&it, x[1], 0.1 * critical[2], 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[0]) + fabs(critical[1]) - 0.9 * fabs(critical[2]), a));
    const double made_up = side * m[M_DEFICIT];
    expect_step(&it, x[1], 0.4 * made_up, 1, 1);
    CU_ASSERT(near(m[M_DEFICIT], 0.6 * fabs(made_up), a));
    double theta = cbrt(1 - side * m[M_T] / (mu * press(x[1])));
    expect_step(&it, x[1], 0.6003 * made_up, theta, 1); /* enough for the front to move inwards */
    CU_ASSERT(m[M_DEFICIT] == 0 && m[M_BRANCH] == 0);
    /* a reversal; dN moves T* in the same step */
    double before = m[M_T];
    expect_step(&it, x[2], -0.25 * critical[1], 1, -1);
    CU_ASSERT(m[M_BRANCH] == 1 && near(m[M_STAR], before + side * mu * (press(x[2]) - press(x[1])), N));
    CU_ASSERT(near(m[M_DEFICIT], 0.75 * fabs(critical[1]), a));
    expect_step(&it, x[2], -0.05 * a, cbrt(1 - side * (m[M_STAR] - m[M_T]) / (2 * mu * press(x[2]))), -1);
    CU_ASSERT(m[M_DEFICIT] == 0 && m[M_BRANCH] == 1);
    theta = cbrt(1 - (side * (m[M_STAR] - m[M_T]) + 2 * mu * (press(x[1]) - press(x[2]))) / (2 * mu * press(x[1])));
    expect_step(&it, x[1], -0.05 * a, theta, -1);
    /* The motion is reversed, but N falls so fast that slip continues. When N rises again, there is a reversal. */
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
    /* Beyond T* there is virgin loading, and then sliding, which erases the history. With less friction T exceeds the
     * limit, and there is no front. */
    lead(&it, x[1], 0.5 * a, 100);
    CU_ASSERT(m[M_BRANCH] == 0 && m[M_CDF] == side && it.s.sliding == 0);
    lead(&it, x[1], a, 100);
    CU_ASSERT(it.s.sliding == 1 && near(m[M_T], side * mu * press(x[1]), N) && m[M_BRANCH] == 0 && m[M_DEFICIT] == 0);
    it.pair.friction = mu / 2;
    go(&it, x[1], 0.01 * a);
    CU_ASSERT(it.s.sliding == 1 && it.s.stiffness == 0 && near(m[M_T], side * mu / 2 * press(x[1]), N));
    go(&it, x[1], -0.01 * a); /* unloading */
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

/* When N rises without slip, the new rings stick, and DD grows. If T reaches T* before the slip has used up DD, virgin
 * loading begins, and the rest of DD is deleted. */
static void return_to_virgin_loading_deletes_DD(void) {
  enum { DEFICIT = 4, BRANCH = 6, RELOADING = 2 };
  struct contact it = contact_of("randall");
  const double a = slope() * deep(N), h = 1e-4 * a;
  double rest = 0;
  go(&it, deep(N), 0);
  lead(&it, deep(N), 0.7 * a, 200), lead(&it, deep(N), -0.2 * a, 200), lead(&it, deep(N), 0.199 * a, 200);
  lead(&it, deep(2 * N), 0, 200);
  CU_ASSERT(it.m[BRANCH] == RELOADING && it.m[DEFICIT] > 100 * h);
  for (int k = 0; k < 100000 && it.m[BRANCH] == RELOADING; k++) {
    rest = it.m[DEFICIT] - h;
    go(&it, deep(2 * N), h);
  }
  CU_ASSERT(rest > 10 * h);
  CU_ASSERT_EQUAL(it.m[BRANCH], 0);
  CU_ASSERT_EQUAL(it.m[DEFICIT], 0);
}

void suite_randall(void) {
  CU_pSuite suite = CU_add_suite("randall", NULL, NULL);
  CU_add_test(suite, "constant N: loading, unloading, reloading", curves_of_constant_normal_force);
  CU_add_test(suite, "T, T* and T** after each step", the_history);
  CU_add_test(suite, "loss of a closed loop", loss_of_a_closed_loop);
  CU_add_test(suite, "unloading beyond -T* is virgin loading", unloading_beyond_the_mirror_image_is_virgin);
  CU_add_test(suite, "re-unloading retraces reloading", unloading_again_retraces_reloading);
  CU_add_test(suite, "N and T rising and falling", all_ways_of_normal_and_tangential_force);
  CU_add_test(suite, "return to virgin loading deletes DD", return_to_virgin_loading_deletes_DD);
  CU_add_test(suite, "the slip front while N falls", slip_front_while_N_falls);
}
