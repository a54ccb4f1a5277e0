/* The simple laws of elastic spheres, held to what is known of each: what R89's increments lose, what a contact that does not
 * slip makes or loses around a square, and the order of both.
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

/* A mass flies onto such a contact and back, `steps` of the duration of Hertz's contact; its speed after over that before.
 * *left: overlap when the force has gone, in units of the largest one. */
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

/* What the recursion of [R89 4.11, 4.12, 4.14] gives when it is worked out apart from the law, to five digits; the first touch
 * as a step begins. Later in the step it is up to 0.0012 less. */
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
      CU_ASSERT_DOUBLE_EQUAL(left, 0.10, 0.01); /* likewise: 0.109, 0.100, 0.093 */
  }
}

/* The loss goes with the step; Hertz's force loses nothing. */
static void increments_are_of_first_order(void) {
  double left;
  const double few = 1 - rebound("hertz_increment", 400, &left), many = 1 - rebound("hertz_increment", 1600, &left);
  CU_ASSERT_DOUBLE_EQUAL(log(few / many) / log(4), 1, 0.01);
  CU_ASSERT_DOUBLE_EQUAL(rebound("hertz", 40, &left), 1, 1e-3);
}

/* [R89 4.11] for the first one, whatever part of the step it took; [R89 4.12, 4.14] from there on. */
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

/* 4.3.1: with the force all of the contact's data is gone, though the surfaces still overlap. */
static void increments_part_before_the_outlines(void) {
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
  double radius, force, work; /* m, N, J of slip */
  double m[NB_HISTORY];
};

/* To this radius of the circle, then on by this slip. */
static void stuck_go(struct stuck *it, double radius, double slip) {
  it->radius = radius;
  const double overlap = radius * radius / pair.radius, before = it->force;
  struct nb_normal n = normal("hertz", overlap, 0, NULL);
  n.overlap = overlap;
  const struct nb_shear s = it->law->shear(pair, n, slip, it->m);
  CU_ASSERT_DOUBLE_EQUAL(s.stiffness, 8 * pair.shear * radius, 1e-14 * s.stiffness);
  it->force = s.force, it->work += (before + s.force) / 2 * slip;
}

/* Around the square in (N, slip), up to a2, out, down to a1, back. T that is kept makes 4 G* (a2 - a1) s^2, T that goes
 * with the radius loses as much; the other way round both lose it. */
static void squares(void) {
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

/* Slip while the overlap grows from a quarter to all: T = 8 G* Int a ds. With the radius at the end of each step it is wrong by
 * 8 G* (a_end - a_begin) ds/2 and a term of the second order. */
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

/* A ten-thousandth below its limit T is what the slip makes of it, above it the limit. */
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

/* T goes with the radius as it falls, in one step or in many, and stays as it is when it grows. */
static void scaled_goes_with_the_radius(void) {
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
  CU_add_test(suite, "increments as printed", increments_as_printed);
  CU_add_test(suite, "increments part before the surfaces do", increments_part_before_the_outlines);
  CU_add_test(suite, "without slip: energy around a square", squares);
  CU_add_test(suite, "without slip: first order while N changes", stuck_is_of_first_order);
  CU_add_test(suite, "without slip: up to the limit", stuck_up_to_the_limit);
  CU_add_test(suite, "scaled: T goes with the radius", scaled_goes_with_the_radius);
}
