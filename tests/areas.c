/* The area that a disc has in common with another disc, and with a polygon, compared with numerical quadrature.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_integration.h>
#include <math.h>

#include "../src/measure/areas.h"
#include "chance.h"
#include "suites.h"

static const double pi = 3.14159265358979323846;

/* A disc about the origin, and a second disc or a box. The integrands of_circles and of_box are the length of the chord
 * at the height y that lies in both figures. */
struct pair {
  double r, R, d;                  /* radii of two circles, the second at the distance d in x */
  double west, east, south, north; /* sides of the box, instead of the second circle */
};

/* The length that the intervals a and b have in common. */
static double common(double from_a, double to_a, double from_b, double to_b) {
  const double length = fmin(to_a, to_b) - fmax(from_a, from_b);
  return length > 0 ? length : 0;
}
static double of_circles(double y, void *data) {
  const struct pair *p = data;
  const double a = sqrt(fmax(0, p->r * p->r - y * y)), b = sqrt(fmax(0, p->R * p->R - y * y));
  return common(-a, a, p->d - b, p->d + b);
}
static double of_box(double y, void *data) {
  const struct pair *p = data;
  const double a = sqrt(fmax(0, p->r * p->r - y * y));
  return common(-a, a, p->west, p->east);
}

/* The integral of the chord over y. The break points are the heights of the corners of the common area; between them
 * the integrand is smooth, with square roots at most at the ends. */
static double integral(double (*chord)(double, void *), struct pair *pair, double points[], size_t count) {
  gsl_integration_workspace *room = gsl_integration_workspace_alloc(1000);
  gsl_function f = {chord, pair};
  double sum = 0;
  for (size_t k = 0; k + 1 < count; k++) {
    double part, error;
    if (!(points[k + 1] > points[k]))
      continue;
    gsl_integration_qags(&f, points[k], points[k + 1], 1e-13, 1e-12, 1000, room, &part, &error);
    sum += part;
  }
  gsl_integration_workspace_free(room);
  return sum;
}

static void circles(void) {
  struct chance dice = chance_begin(4);
  int cut = 0;
  for (int n = 0; n < 300; n++) {
    struct pair p = {.r = chance_between(&dice, 0.2, 2), .R = chance_between(&dice, 0.2, 2)};
    p.d = chance_between(&dice, 0, p.r + p.R);
    const double least = fmin(p.r, p.R), x = (p.d * p.d + p.r * p.r - p.R * p.R) / (2 * p.d);
    const double corner = p.r * p.r > x * x ? fmin(sqrt(p.r * p.r - x * x), least) : 0;
    double points[] = {-least, -corner, corner, least};
    cut += p.d > fabs(p.r - p.R);
    CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(p.r, p.R, p.d), integral(of_circles, &p, points, 4), 1e-11);
    CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(p.R, p.r, p.d), nb_area_of_lens(p.r, p.R, p.d), 1e-14);
  }
  CU_ASSERT(cut > 150);
}

static void circles_that_barely_intersect(void) {
  CU_ASSERT(nb_area_of_lens(1, 2, 3) == 0 && nb_area_of_lens(1, 2, 4) == 0);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(1, 2, 0), pi, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(1, 1, 0), pi, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(1, 2, 1), pi, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(1, 1, 1), 2 * pi / 3 - sqrt(3) / 2, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(2, 2, 1e-30), 4 * pi, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(2, 2 + 1e-15, 3e-15), 4 * pi, 1e-13);
  /* The lens of thickness h that two circles of radius 1 have in common has the half-chord sqrt(h (1 - h/4)). To first
   * order in h its area is 4/3 h times the half-chord. */
  const double h = 1e-6, chord = sqrt(h * (1 - h / 4));
  CU_ASSERT_DOUBLE_EQUAL(nb_area_of_lens(1, 1, 2 - h) / (4. / 3 * h * chord), 1, 1e-5);
}

static void boxes(void) {
  struct chance dice = chance_begin(5);
  for (int n = 0; n < 300; n++) {
    struct pair p = {.r = 1, .west = chance_between(&dice, -2, 1), .south = chance_between(&dice, -2, 1)};
    p.east = p.west + chance_between(&dice, 0.1, 3), p.north = p.south + chance_between(&dice, 0.1, 3);
    const double low = fmax(-1, p.south), high = fmin(1, p.north);
    const double we = p.west * p.west < 1 ? sqrt(1 - p.west * p.west) : 1;
    const double ea = p.east * p.east < 1 ? sqrt(1 - p.east * p.east) : 1;
    const double least = fmin(we, ea), most = fmax(we, ea), breaks[] = {-1, -most, -least, least, most, 1};
    double points[6];
    for (int k = 0; k < 6; k++)
      points[k] = fmin(fmax(breaks[k], low), high);
    const double wanted = high > low ? integral(of_box, &p, points, 6) : 0;
    /* the same figures, translated and rotated */
    const double turn = chance_between(&dice, -3, 3), c = cos(turn), s = sin(turn);
    const struct nb_vec centre = vec(chance_between(&dice, -5, 5), 3);
    const double xs[] = {p.west, p.east, p.east, p.west}, ys[] = {p.south, p.south, p.north, p.north};
    struct nb_vec plain[4], turned[4];
    for (int k = 0; k < 4; k++) {
      plain[k] = vec(xs[k], ys[k]);
      turned[k] = vec_add(centre, vec(c * xs[k] - s * ys[k], s * xs[k] + c * ys[k]));
    }
    CU_ASSERT_DOUBLE_EQUAL(nb_area_in_polygon(vec(0, 0), 1, plain, 4), wanted, 1e-11);
    CU_ASSERT_DOUBLE_EQUAL(nb_area_in_polygon(centre, 1, turned, 4), wanted, 1e-11);
  }
}

/* Edges through the centre and edges tangent to the disc, a corner at the centre. */
static void boxes_at_their_limits(void) {
  const struct {
    double west, south, east, north, area;
  } rows[] = {{0, 0, 2, 2, pi / 4},
              {-2, 0, 2, 2, pi / 2},
              {-1, -1, 1, 1, pi},
              {1, -1, 2, 1, 0},
              {-2, -2, 2, 2, pi},
              {-0.5, -0.5, 0.5, 0.5, 1},
              {0, -2, 0.6, 2, asin(0.6) + 0.6 * 0.8}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const struct nb_vec corners[] = {vec(rows[k].west, rows[k].south), vec(rows[k].east, rows[k].south),
                                     vec(rows[k].east, rows[k].north), vec(rows[k].west, rows[k].north)};
    CU_ASSERT_DOUBLE_EQUAL(nb_area_in_polygon(vec(0, 0), 1, corners, 4), rows[k].area, 2e-15);
  }
}

void suite_areas(void) {
  CU_pSuite suite = CU_add_suite("areas", NULL, NULL);
  CU_add_test(suite, "two circles, against quadrature", circles);
  CU_add_test(suite, "two circles that barely intersect, or one inside the other", circles_that_barely_intersect);
  CU_add_test(suite, "a disc and a box, against quadrature", boxes);
  CU_add_test(suite, "a disc and a box, closed forms", boxes_at_their_limits);
}
