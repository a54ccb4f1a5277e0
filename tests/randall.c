/* R89's law: the curves of constant N, its fronts, all four ways of N and T, and what the text as it stands makes of them.
 *
 * What it should be comes from the rings of the contact, T = mu Int D dN and delta = mu kappa Int D dx (ERRATA, section E), of
 * which [R89 3.25, 3.40, 3.50] are the cases of constant N. The law is of first order: an error halves with the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
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

/* After these legs, each of which is a reversal. */
static double known(double alpha, const struct leg *legs, int count) {
  const double a = slope() * alpha;
  struct rings r = {alpha, {alpha}, 0};
  double delta = 0;
  for (int k = 0; k < count; k++) {
    r.fronts[r.count++] = r.alpha;
    delta += legs[k].slip * a;
    slip_to(&r, legs[k].alpha * alpha, delta);
  }
  return force(&r);
}

static double error_of(const char *law, const struct leg *legs, int count, int steps) {
  struct contact it = contact_of(law);
  const double alpha = deep(N);
  go(&it, alpha, 0);
  for (int k = 0; k < count; k++)
    lead(&it, legs[k].alpha * alpha, legs[k].slip * slope() * alpha, steps);
  return (it.s.force - known(alpha, legs, count)) / (mu * N);
}

/* First order, and small: at 500 steps a leg it is below 1e-3 of mu N, at twice as many half of it. */
static void expect_first_order(const struct leg *legs, int count) {
  const double coarse = error_of("randall", legs, count, 500), fine = error_of("randall", legs, count, 1000);
  CU_ASSERT(fabs(coarse) < 2e-3 && fabs(fine - coarse / 2) < 0.05 * fabs(coarse) + 1e-7);
}

/* ---- constant N ---- */

/* [R89 3.25, 3.40, 3.50] solved for T; known() says the same, to rounding. */
static void curves_of_constant_normal_force(void) {
  static const struct leg legs[] = {{1, 0.7}, {1, -0.9}, {1, 0.6}};
  const double t1 = 1 - pow(1 - 0.7, 1.5), t2 = t1 - 2 * (1 - pow(1 - 0.9 / 2, 1.5));
  const double t3 = t2 + 2 * (1 - pow(1 - 0.6 / 2, 1.5)), t[] = {t1, t2, t3};
  for (int k = 0; k < 3; k++) {
    CU_ASSERT(fabs(known(deep(N), legs, k + 1) - t[k] * mu * N) < 1e-13 * N);
    expect_first_order(legs, k + 1);
  }
}

/* Between T* and -T* a cycle loses  (24/5 (1 - (1-x)^(5/3)) - 4 x (1 + (1-x)^(2/3))) mu N A,  x = T*'/mu N: the area between 3.40 and its
 * mirror image. */
static void loop_loses_what_it_should(void) {
  const double x = 0.8, a = slope() * deep(N), star = a * (1 - pow(1 - x, 2. / 3));
  const double known = (4.8 * (1 - pow(1 - x, 5. / 3)) - 4 * x * (1 + pow(1 - x, 2. / 3))) * mu * N * a;
  double errors[2];
  for (int k = 0; k < 2; k++) {
    const int steps = k ? 2000 : 1000;
    struct contact it = contact_of("randall");
    go(&it, deep(N), 0);
    lead(&it, deep(N), star, steps);
    const double before = it.work;
    lead(&it, deep(N), -2 * star, 2 * steps);
    lead(&it, deep(N), 2 * star, 2 * steps);
    errors[k] = (it.work - before) / known - 1;
  }
  CU_ASSERT(known > 0 && fabs(errors[0]) < 5e-3 && fabs(errors[1] - errors[0] / 2) < 0.1 * fabs(errors[0]));
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
    struct leg legs[3];
    double at = 1;
    for (int k = 0; k < 3; k++) {
      const int falls = ways >> k & 1;
      legs[k] = (struct leg){at += alpha[k][falls], slip[k][falls]};
      expect_first_order(legs, k + 1);
    }
  }
}

/* ERRATA A, to 3.86: N = 1, mu = 0.3, T = 0.2 mu. While N falls by 0.1 at that T the front goes from c to c1, and the ring between has
 * taken mu |dN| = 0.03, which the prefactor mu (p0 + dp0)/a1 makes of it: mu N1 (c^3 - c1^3)/a1^3. With the printed one it is
 * 0.0312. The law says its fronts in dT/ds = 8 G* c. */
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

void suite_randall(void) {
  CU_pSuite suite = CU_add_suite("randall", NULL, NULL);
  CU_add_test(suite, "constant N: loading, unloading, reloading", curves_of_constant_normal_force);
  CU_add_test(suite, "a closed loop loses what it should", loop_loses_what_it_should);
  CU_add_test(suite, "re-unloading retraces reloading", unloading_again_retraces_reloading);
  CU_add_test(suite, "N and T rising and falling", all_ways_of_normal_and_tangential_force);
  CU_add_test(suite, "the front takes what the edge gives up", front_takes_what_the_edge_gives_up);
}
