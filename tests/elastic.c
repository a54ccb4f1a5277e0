/* The simple laws of elastic spheres, compared with known results: the energy that R89's incremental Hertz law
 * loses, the energy that a contact without slip creates or dissipates around a rectangle in (N, tangential
 * displacement), and the order of both in the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/laws/law.h"
#include "suites.h"

static const struct nb_pair pair = {.young = 3e10, .shear = 7e9, .radius = 0.02, .friction = 1e6};

static struct nb_normal normal(const char *law, double overlap, double dn, double m[]) {
  return nb_law_find("normal", law)->normal(pair, overlap, dn, m);
}
static struct nb_normal increment(double overlap, double dn, double m[]) {
  return normal("hertz_increment", overlap, dn, m);
}

/* ---- R89's increments ---- */

/* The impact of a mass with a normal law; `steps` is the number of steps in the duration of Hertz's impact. Returns the
 * speed after the impact over the speed before. *left: overlap when the force ends, over the largest overlap of Hertz's
 * impact. */
static double rebound(const char *law, int steps, double *left) {
  const double mass = 0.1, speed = 2;
  const double depth = pow(15 * mass * speed * speed / (16 * sqrt(pair.radius) * pair.young), 0.4);
  const double dt = 2.9432751843247047 * depth / speed / steps;
  double v = speed, overlap = 0, m[NB_HISTORY] = {0};
  *left = 0;
  for (int k = 0; k < 2 * steps; k++) {
    overlap += v * dt;
    const double force = normal(law, overlap > 0 ? overlap : 0, v * dt, m).force;
    if (force == 0 && *left == 0)
      *left = overlap / depth;
    v -= force / mass * dt;
  }
  return -v / speed;
}

/* Expected values from the recursion [R89 4.11, 4.12, 4.14], computed apart from the law, to five digits, for a
 * first touch at the beginning of a step. If the first touch is later in the step, they are up to 0.0012 smaller. */
static void increments_lose_speed(void) {
  static const struct {
    int steps;
    double kept, within;
  } expected[] = {
      {30, 0.97069, 5e-6}, {35, 0.97463, 5e-6}, {40, 0.97764, 5e-6}, {80, 0.98857, 5e-6}, {400, 0.99769, 5e-6}};
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    double left;
    CU_ASSERT_DOUBLE_EQUAL(rebound("hertz_increment", expected[k].steps, &left), expected[k].kept, expected[k].within);
    if (expected[k].steps <= 40)
      CU_ASSERT_DOUBLE_EQUAL(left, 0.10, 0.01); /* the recursion: 0.109, 0.100, 0.093 */
  }
}

/* The loss is proportional to the step; Hertz's force loses nothing. */
static void increments_are_of_first_order(void) {
  double left;
  const double few = 1 - rebound("hertz_increment", 400, &left), many = 1 - rebound("hertz_increment", 1600, &left);
  CU_ASSERT_DOUBLE_EQUAL(log(few / many) / log(4), 1, 0.01);
  CU_ASSERT_DOUBLE_EQUAL(rebound("hertz", 40, &left), 1, 1e-3);
}

/* The first increment is [R89 4.11], whatever fraction of the step it took; the others are [R89 4.12, 4.14]. */
static void increments_as_printed(void) {
  double m[NB_HISTORY] = {0};
  const double first = 4. / 3 * pair.young * sqrt(pair.radius * pow(1e-6, 3));
  struct nb_normal n = increment(1e-6, 5e-6, m);
  CU_ASSERT_DOUBLE_EQUAL(n.force, first, 1e-14 * first);
  CU_ASSERT_DOUBLE_EQUAL(n.radius, sqrt(pair.radius * 1e-6), 1e-14 * n.radius);
  CU_ASSERT_DOUBLE_EQUAL(n.stiffness, 2 * pair.young * n.radius, 1e-14 * n.stiffness);
  const double second = first + 2 * 2e-6 * pair.young * n.radius;
  n = increment(3e-6, 2e-6, m);
  CU_ASSERT_DOUBLE_EQUAL(n.force, second, 1e-14 * second);
  CU_ASSERT_DOUBLE_EQUAL(n.radius, cbrt(3 * second * pair.radius / (4 * pair.young)), 1e-14 * n.radius);
  CU_ASSERT_EQUAL(increment(3e-6, 0, m).force, n.force);
}

/* [R89 sec. 4.3.1]: the contact data are deleted when the force ends, although the particles still overlap. */
static void increments_separate_before_the_surfaces(void) {
  double m[NB_HISTORY] = {0}, shear[NB_HISTORY] = {0};
  const struct nb_law *mindlin = nb_law_find("shear", "mindlin");
  CU_ASSERT(mindlin->shear(pair, increment(4e-6, 4e-6, m), 1e-7, shear).force > 0);
  struct nb_normal n = increment(1e-6, -3e-6, m);
  CU_ASSERT(n.force == 0 && n.stiffness == 0 && n.radius == 0);
  CU_ASSERT_EQUAL(mindlin->shear(pair, n, 1e-7, shear).force, 0);
  CU_ASSERT_EQUAL(shear[0], 0);
  n = increment(0.5e-6, -0.5e-6, m);
  CU_ASSERT(n.force == 0 && n.stiffness == 0 && n.radius == 0);
  n = increment(0.7e-6, 0.2e-6, m); /* as if they had just touched */
  const double anew = 4. / 3 * pair.young * sqrt(pair.radius * pow(0.2e-6, 3));
  CU_ASSERT_DOUBLE_EQUAL(n.force, anew, 1e-13 * anew);
}

/* ---- a contact that does not slip ---- */

struct stuck {
  const struct nb_law *law;
  double radius, force, work; /* m; N; J, the work of the shear force */
  double m[NB_HISTORY];
};

/* Makes one step: changes the contact radius to this value, then adds the tangential displacement `slip`. */
static void stuck_go(struct stuck *it, double radius, double slip) {
  it->radius = radius;
  const double overlap = radius * radius / pair.radius, before = it->force;
  struct nb_normal n = normal("hertz", overlap, 0, NULL);
  n.overlap = overlap;
  const struct nb_shear s = it->law->shear(pair, n, slip, it->m);
  CU_ASSERT_DOUBLE_EQUAL(s.stiffness, 8 * pair.shear * radius, 1e-14 * s.stiffness);
  it->force = s.force, it->work += (before + s.force) / 2 * slip;
}

/* Around a rectangle: N up (contact radius a2), tangential displacement by s, N down (radius a1), displacement back. If
 * the shear force is kept while N falls, the contact does 4 G* (a2 - a1) s^2 more work than is done on it. If the shear
 * force shrinks with the radius, the contact dissipates this energy. If the rectangle is followed in the other
 * direction, both contacts dissipate it. */
static void rectangles(void) {
  const double low = 1e-3, high = 3e-3, slip = 2e-6, size = 4 * pair.shear * (high - low) * slip * slip;
  for (int scaled = 0; scaled < 2; scaled++)
    for (int way = 0; way < 2; way++) {
      struct stuck it = {.law = nb_law_find("shear", scaled ? "mindlin_scaled" : "mindlin")};
      stuck_go(&it, low, 0);
      stuck_go(&it, way ? low : high, 0);
      stuck_go(&it, it.radius, slip);
      stuck_go(&it, way ? high : low, 0);
      CU_ASSERT_DOUBLE_EQUAL(it.force, 8 * pair.shear * (way || scaled ? low : high) * slip, 1e-13 * it.force);
      stuck_go(&it, it.radius, -slip);
      stuck_go(&it, low, 0);
      CU_ASSERT_DOUBLE_EQUAL(it.work, scaled || way ? size : -size, 1e-12 * size);
    }
}

/* Tangential displacement while the overlap grows from a quarter to its full value: T = 8 G* Int a ds. The law uses the
 * radius at the end of each step. The error of T at the end of the path is 8 G* (a_end - a_begin) ds/2 plus a term of
 * second order, with the radii a_begin and a_end at both ends of the path and the displacement ds of a step. */
static void stuck_is_of_first_order(void) {
  const double depth = 1e-4, slip = 1e-6, a = sqrt(pair.radius * depth);
  const double exact = 8 * pair.shear * a * (2. / 3) * (1 - 0.125) / 0.75 * slip;
  static const char *const laws[] = {"mindlin", "mindlin_scaled"};
  for (int law = 0; law < 2; law++)
    for (int steps = 100; steps <= 400; steps *= 2) {
      struct stuck it = {.law = nb_law_find("shear", laws[law])};
      stuck_go(&it, a / 2, 0);
      for (int k = 1; k <= steps; k++)
        stuck_go(&it, sqrt(pair.radius * depth * (0.25 + 0.75 * k / steps)), slip / steps);
      const double off = 8 * pair.shear * (a / 2) * (slip / steps) / 2;
      CU_ASSERT_DOUBLE_EQUAL(it.force - exact, off, off / steps);
    }
}

/* At 0.9999 of the friction limit T = 8 G* a s. At 1.0001 of it T is equal to the limit. */
static void stuck_up_to_the_limit(void) {
  const double radius = 1e-3, limit = pair.friction * normal("hertz", radius * radius / pair.radius, 0, NULL).force;
  static const char *const laws[] = {"mindlin", "mindlin_scaled"};
  for (int law = 0; law < 2; law++)
    for (int above = 0; above < 2; above++) {
      struct stuck it = {.law = nb_law_find("shear", laws[law])};
      const double fraction = above ? 1.0001 : 0.9999;
      stuck_go(&it, radius, 0);
      stuck_go(&it, radius, fraction * limit / (8 * pair.shear * radius));
      CU_ASSERT_DOUBLE_EQUAL(it.force, above ? limit : fraction * limit, 1e-12 * limit);
    }
}

/* T shrinks with the radius, in one step or in many, and does not change when the radius grows. */
static void scaled_shrinks_with_the_radius(void) {
  struct stuck it = {.law = nb_law_find("shear", "mindlin_scaled")};
  stuck_go(&it, 2e-3, 1e-6);
  const double force = it.force;
  stuck_go(&it, 3e-3, 0);
  CU_ASSERT_EQUAL(it.force, force);
  for (int k = 1; k <= 10; k++)
    stuck_go(&it, 3e-3 - k * 1e-4, 0);
  CU_ASSERT_DOUBLE_EQUAL(it.force, force * 2 / 3, 1e-14 * force);
  stuck_go(&it, 2e-3, 1e-6);
  CU_ASSERT_DOUBLE_EQUAL(it.force, force * 5 / 3, 1e-14 * force);
}

void suite_elastic(void) {
  CU_pSuite suite = CU_add_suite("elastic", NULL, NULL);
  CU_add_test(suite, "increments lose speed", increments_lose_speed);
  CU_add_test(suite, "increments are of first order", increments_are_of_first_order);
  CU_add_test(suite, "increments are those of R89 4.11, 4.12 and 4.14", increments_as_printed);
  CU_add_test(suite, "increments separate before the surfaces do", increments_separate_before_the_surfaces);
  CU_add_test(suite, "without slip: energy around a rectangle", rectangles);
  CU_add_test(suite, "without slip: first order while N changes", stuck_is_of_first_order);
  CU_add_test(suite, "without slip: up to the limit", stuck_up_to_the_limit);
  CU_add_test(suite, "scaled: T shrinks with the radius", scaled_shrinks_with_the_radius);
}
