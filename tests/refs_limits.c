/* References at the limits of what they cover, and on further scenes without symmetry: changed_law, free_fall,
 * boxed_lattice, fracc_touch, cohesion, and the functions and references of Hertz's impact with a dashpot.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_sf_gamma.h>
#include <math.h>
#include <string.h>

#include "../cases/refs/hertz.h"
#include "../cases/refs/hertz_motion.h"
#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

/* A heavy sphere of radius 2 at (5, 6.99), pressed by 0.01 against a wall below it, at y = 5, or above it, at y = 8.98.
 * k_n = 15, k_s = 6, E* = 2/0.9375, G* = 1.6/3.5 and the friction is 0.8. */
#define SLIDES(wall, speed, stages)                                                                                    \
  "material g density 1e30 young 4 poisson 0.25 kn 30 ks 12 friction 0.8\n"                                            \
  "material w kn 10 ks 4 young 4 poisson 0.25 friction 0.9\nnormal linear\nshear linear\nsphere 5 6.99 radius 2 g\n"   \
  "wall f " wall " w velocity " speed " 0\nmonitor D sphere 1\nmonitor C sphere 1 with wall f\nstep 0.1\n" stages
#define LONG "a wall so long that the sphere stays on it"
#define STICKS                                                                                                         \
  "up to 32 stages, a wall that moves tangentially at a constant velocity, steps given as times, and a contact that "  \
  "does not slide"
/* The shear force of mindlin_deresiewicz per 8 G* a. With x = alpha z^2, the springs with the overlap x have dK = K dz.
 * They stick up to z, where s - s_1 z^2 = A alpha (1 - z^2). */
static double springs(double s, double first, double most) {
  const double z = sqrt((most - s) / (most - first));
  return s * z - first * z * z * z / 3 + most * (2. / 3 - z + z * z * z / 3);
}
static void changed_law(void) {
  /* In 1.8 s the wall moves by 0.018. */
#define MOVES(wall, speed) SLIDES(wall, speed, "stage s\ncycles 10\nstage t\ncycles 8\n")
  PARTS("changed_law", "@", {MOVES("4.981 5 to 9 5", "0.01"), NULL}, {MOVES("4.983 5 to 9 5", "0.01"), LONG},
        {MOVES("-9 5 to 5.001 5", "0.01"), NULL}, {MOVES("-9 5 to 4.999 5", "0.01"), LONG},
        {MOVES("9 5 to 4.981 5", "0.01"), NULL}, {MOVES("9 5 to 4.983 5", "0.01"), LONG},
        {MOVES("5.001 5 to -9 5", "0.01"), NULL}, {MOVES("4.999 5 to -9 5", "0.01"), LONG},
        {MOVES("-9 5 to 5.019 5", "-0.01"), NULL}, {MOVES("-9 5 to 5.017 5", "-0.01"), LONG},
        {MOVES("4.999 5 to 9 5", "-0.01"), NULL}, {MOVES("5.001 5 to 9 5", "-0.01"), LONG},
        {MOVES("4.981 8.98 to 9 8.98", "0.01"), NULL}, {MOVES("4.983 8.98 to 9 8.98", "0.01"), LONG},
        {MOVES("9 8.98 to 4.999 8.98", "-0.01"), NULL}, {MOVES("9 8.98 to 5.001 8.98", "-0.01"), LONG},
        {MOVES("5.019 8.98 to -9 8.98", "-0.01"), NULL}, {MOVES("5.017 8.98 to -9 8.98", "-0.01"), LONG});
  /* T = 6 * 0.01 t reaches mu N = 0.8 * 0.15 at t = 2. */
#define WIDE(speed, stages) SLIDES("-9 5 to 9 5", speed, stages)
  PARTS("changed_law", "@", {WIDE("0.01", "stage s\ncycles 19\n"), NULL},
        {WIDE("0.01", "stage s\ncycles 21\n"), STICKS}, {WIDE("-0.01", "stage s\ncycles 19\n"), NULL},
        {WIDE("-0.01", "stage s\ncycles 21\n"), STICKS},
        {WIDE("0.01", "stage s\ncycles 21\nstage t\nshear none\ncycles 1\n"), STICKS},
        {WIDE("0.01", "stage s\ncycles 19\nstage t\nshear none\ncycles 9\n"), NULL},
        {WIDE("0.01", "stage s\ncycles 1\nstage t\nnormal hertz_increment\ncycles 1\n"), STICKS},
        {WIDE("0.01", "stage s\ncycles 1\nstage t\nnormal hertz_increment\nshear none\ncycles 1\n"), NULL});
  for (int n = 32; n < 34; n++) {
    char page[4096] = WIDE("0.01", "");
    for (int k = 0; k < n; k++)
      snprintf(page + strlen(page), sizeof page - strlen(page), "stage s%d\nshear none\ncycles 1\n", k);
    check_message("changed_law", page, n == 32 ? NULL : STICKS);
  }
  /* The wall is below and moves to -x: the sphere moves along t = (-1, 0) by -0.002 t, relative to it. */
  const double v = 0.002, overlap = 0.01, ka = 8 * 1.6 / 3.5 * sqrt(2 * overlap);
  const double hertz = 4. / 3 * 2 / 0.9375 * sqrt(2) * pow(overlap, 1.5), most = 1.5 * 0.8 * hertz / ka;
  VALUES("changed_law",
         WIDE("-0.002",
              "stage a\ncycles 1\nstage b\nnormal hertz\ncycles 1\nstage m\nstep 0.2\nshear mindlin\n"
              "cycles 5\nstage e\nstep 0.1\nshear mindlin_deresiewicz\ncycles 10\nstage r\nstep 0.05\nshear "
              "mindlin_deresiewicz\ncycles 6\nstage p\nshear mindlin_deresiewicz memory 6\ncycles 8\nstage i\n"
              "normal hertz_increment\nshear none\ncycles 5\n"),
         0, {"C.normal", 15 * overlap, "time", 0.1}, {"C.normal", hertz, "time", 0.2}, {"C.normal", hertz, "time", 2.9},
         {"C.normal", 0, "time", 3}, {"C.shear", -6 * v * 0.1, "time", 0.1}, {"C.shear", -6 * v * 0.2, "time", 0.2},
         {"C.shear", -ka * v * 0.2, "time", 0.4}, {"C.shear", -ka * v * 1, "time", 1.2},
         {"C.shear", -ka * springs(v * 0.1, v * 0.1, most), "time", 1.3},
         {"C.shear", -ka * springs(v * 1, v * 0.1, most), "time", 2.2},
         {"C.shear", -ka * springs(v * 1.3, v * 0.1, most), "time", 2.5},
         {"C.shear", -ka * springs(v * 0.05, v * 0.05, most), "time", 2.55},
         {"C.shear", -ka * springs(v * 0.4, v * 0.05, most), "time", 2.9}, {"C.shear", 0, "time", 3});
#undef MOVES
#undef WIDE
}

/* A disc of mass 5 on a spring of k = 20 falls from the height 1 with g = 0.5: it flies for 2, 4, 4, … and touches for
 * pi - atan(4) each time. The 128th contact ends at 2 + 127*4 + 128*1.8158 = 742.4. */
static void free_fall(void) {
#define FALLS(g, y, step, stages)                                                                                      \
  "material m density (5/(4*pi)) kn 20\nnormal linear\ngravity 0 " g "\ndisc 7 " y " radius 2 m\nwall f 9 3 to 5 3 "   \
  "m\nmonitor D disc 1\nallow unstable\nstep " step "\n" stages
#define LAST "a run with at most 128 contacts"
  PARTS("free_fall", "@", {FALLS("-0.5", "6", "1", "stage s\ncycles 700\nstage t\ncycles 42\n"), NULL},
        {FALLS("-0.5", "6", "1", "stage s\ncycles 700\nstage t\ncycles 43\n"), LAST},
        {FALLS("-0.5", "6", "2 of single-contact", "stage s\ncycles 371\n"), NULL}, /* 2 (m/k)^(1/2) = 1 */
        {FALLS("-0.5", "6", "2 of single-contact", "stage s\ncycles 372\n"), LAST},
        {FALLS("0.5", "6", "1", "stage s\ncycles 9999\n"), NULL},
        {FALLS("-0.5", "5", "1", "stage s\ncycles 9999\n"), NULL});
#undef LAST
#undef FALLS
}

/* A seventh disc outside the box, at the place that a seventh disc of the lattice has. */
static void boxed_lattice(void) {
  PARTS("boxed_lattice",
        "material a density 1 kn 50\nnormal linear\nshear none\nbox 1 5 to 13 13 a\n"
        "lattice discs 3 by 2 from 3 7 radius 2 spacing 4 a\n@step 0.1\nstage s\ncycles 1\n",
        {"", NULL}, {"disc 3 15 radius 2 a\n", "one `lattice discs` of touching discs in a box of the same stiffness"});
}

/* The first disc moves by 1/32 in each step; it touches at first, or crosses a gap just below 3/32 in three steps. */
static void fracc_touch(void) {
#define AT(x)                                                                                                          \
  "material m density (5/(4*pi)) kn 20\ndisc 3 2 radius 2 m velocity 4 0\ndisc " x " 2 radius 2 m\nstep (1/128) of "   \
  "single-contact\nstage s\ncycles 9\n"
  const double dt = 1. / 128;
  double force = 20. / 32;
  VALUES("fracc_touch", AT("7"), 0, {"step.fracc max", sqrt(20 * (4 - 2 * force * dt / 5) * dt / force) / 2});
  force = 20. / 16384;
  VALUES("fracc_touch", AT("(7 + 3/32 - 1/16384)"), 0,
         {"step.fracc max", sqrt(20 * (4 - 2 * force * dt / 5) * dt / force) / 2});
  force = 20 * (1. / 32 - 1. / 16384);
  VALUES("fracc_touch", AT("(7 + 3/32 + 1/16384)"), 0,
         {"step.fracc max", sqrt(20 * (4 - 2 * force * dt / 5) * dt / force) / 2});
#undef AT
}

/* The upper plate moves from the start, approaches by 0.02 + 0.012 and moves in x while the stop is at the right. */
static void cohesion(void) {
  const double normal = 15 * 0.032 / 2, sticks = 6 * 0.006 / (1 + 2 * 6 / 7.5);
  VALUES("cohesion",
         "material d density 1 kn 10 ks 4 friction 0.7 cohesion 0.03\nmaterial p kn 30 ks 12 friction 0.5 cohesion "
         "0.02\nmaterial s kn 6\nnormal linear\nshear linear\ndisc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\n"
         "wall high 0 9 to 9 9 p velocity 0 -0.01\nwall stop 7 6 to 7 8 s\nmonitor U disc 1 with wall high\nstep 0.1\n"
         "stage press\ncycles 20\nstage more\nwall high velocity 0 -0.03\ncycles 4\n"
         "stage drag\nwall low velocity 0.02 0\nwall high velocity 0.02 0\ncycles 3\n"
         "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.33\ncycles 1\n",
         0, {"U.normal in drag", normal}, {"U.shear in drag", -sticks}, {"U.normal in leave", 0},
         {"U.shear in leave", 0});
}

/* t V_N/alpha* at which loading without damping reaches s alpha*: an incomplete beta function. */
static double loading(double s) { return hertz_duration_factor() / 2 * gsl_sf_beta_inc(0.4, 0.5, pow(s, 2.5)); }
/* The rate of s by the energy: s'^2 = 1 - s^(5/2). */
static double rate(double s) { return sqrt(1 - pow(s, 2.5)); }

/* hertz_integrate over each unknown, in both directions, without damping, compared with the integral of energy. */
static void motion_without_damping(void) {
  double y[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT, deepest[HERTZ_UNKNOWNS] = {0};
  CU_ASSERT(hertz_integrate(y, 0, HERTZ_OVERLAP, 0.6));
  CU_ASSERT(y[HERTZ_OVERLAP] == 0.6);
  NEAR(y[HERTZ_TIME], loading(0.6), 1e-11);
  NEAR(y[HERTZ_SPEED], rate(0.6), 1e-11);
  CU_ASSERT(hertz_integrate(y, 0, HERTZ_TIME, loading(0.3))); /* backward */
  NEAR(y[HERTZ_OVERLAP], 0.3, 1e-11);
  CU_ASSERT(hertz_integrate(y, 0, HERTZ_SPEED, -rate(0.8)));
  NEAR(y[HERTZ_OVERLAP], 0.8, 1e-11);
  NEAR(y[HERTZ_TIME], hertz_duration_factor() - loading(0.8), 1e-11);
  const double before[] = {y[0], y[1], y[2]};
  CU_ASSERT(hertz_integrate(y, 0, HERTZ_OVERLAP, y[HERTZ_OVERLAP])); /* nothing to integrate */
  CU_ASSERT(memcmp(before, y, sizeof before) == 0);
  double z[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT;
  CU_ASSERT(hertz_rebound(z, 0, 0.3, 20, deepest));
  CU_ASSERT(z[HERTZ_OVERLAP] == 0.3);
  NEAR(z[HERTZ_SPEED], -rate(0.3), 1e-11);
  NEAR(z[HERTZ_TIME], hertz_duration_factor() - loading(0.3), 1e-11);
  NEAR(deepest[HERTZ_OVERLAP], 1., 1e-11);
  NEAR(deepest[HERTZ_TIME], hertz_duration_factor() / 2, 1e-11);
  CU_ASSERT(deepest[HERTZ_SPEED] == 0);
  /* It stops after the longest time, before or after the largest overlap. */
  for (int k = 0; k < 2; k++) {
    double w[HERTZ_UNKNOWNS] = HERTZ_FIRST_CONTACT, none[] = {-1, -1, -1};
    const double longest = k ? 1.63 : 1.38;
    CU_ASSERT(hertz_rebound(w, 0, 0, longest, none));
    CU_ASSERT(w[HERTZ_TIME] >= longest && w[HERTZ_TIME] < longest + 0.0501 && w[HERTZ_OVERLAP] > 0.9);
    CU_ASSERT_EQUAL(none[HERTZ_OVERLAP] > 0, k == 1);
  }
}

/* A sphere of radius 2 hits a wall, or sphere 3 of radius 1, at the speed 0.5 after 2 s. */
#define HITS(damping, other, stages)                                                                                   \
  "material m density 3 young 400 poisson 0.25\nnormal hertz\ndamping " damping "\nsphere 1 7 radius 2 m velocity "    \
  "0.5 0\n" other "step 0.001\n" stages
#define WALL "wall w 4 0 to 4 9 m\n"
#define SMALL "sphere 5 7 radius 1 m\n"
#define WATCHED "monitor D sphere 1\nmonitor C sphere 1 with wall w\nmonitor W wall w\n"
static double depth_at_wall(void) {
  const double mass = 32 * pi, k = 4. / 3 * 400 / (2 * 0.9375) * sqrt(2);
  return pow(5 * mass * 0.25 / (4 * k), 0.4);
}
static double at(const struct nb_solution *solution, const char *name, const char *along, double x) {
  const struct nb_solution_curve *curve = solution_find_curve(solution, name, along);
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  return curve->at(curve->data, x);
}

/* The monitor of the contact may stand after others, and a scene may have none; the largest force is that of the first
 * stage (hertz_increment) and lies in the stage that contains the largest overlap (hertz_damped). */
static void impacts_and_monitors(void) {
  struct nb_solution solution;
  struct nb_error error = {0};
  const double deep = depth_at_wall(), k = 4. / 3 * 400 / (2 * 0.9375) * sqrt(2), unit = deep / 0.5;
  CU_ASSERT_EQUAL(solve(&solution, "hertz_impact", HITS("none", WALL WATCHED, "stage s\ncycles 9\n"), &error), NB_OK);
  NEAR(at(&solution, "C.normal", "C.overlap", 0.03), k * pow(0.03, 1.5), 1e-12);
  CU_ASSERT_EQUAL(at(&solution, "C.normal", "C.overlap", -0.03), 0);
  NEAR(at(&solution, "C.overlap", "time", 2 + unit * loading(0.4)), 0.4 * deep, 1e-11);
  solution_free(&solution);
  const double duration = hertz_duration_factor() * unit;
  VALUES("hertz_impact", HITS("none", SMALL "monitor D sphere 1\n", "stage s\ncycles 9\n"), 0,
         {"impact.duration", duration * pow((1. / 9) / sqrt(1. / 3), 0.4)}, {"impact.restitution", 1});
  char page[1024];
  snprintf(page, sizeof page, "%s", HITS("none", WALL WATCHED, "stage s\ncycles 9\nstage t\ncycles 9\n"));
  memcpy(strstr(page, "normal hertz\ndamping none\n"), "normal hertz_increment\n   \n", 26);
  const double lost = gsl_sf_beta(0.6, 1.5) * 0.001 / unit;
  VALUES("hertz_increment", page, 0, {"C.normal max in s", k * pow(deep, 1.5) * (1 - 0.15 * lost)},
         {"impact.restitution", 1 - lost / 4});

  /* hertz_damped: the time of the largest overlap divides stages. */
  CU_ASSERT_EQUAL(solve(&solution, "hertz_damped", HITS("ratio 0.3", WALL WATCHED, "stage s\ncycles 9\n"), &error),
                  NB_OK);
  double low = 2, high = 2 + 2 * unit; /* of the largest overlap, by thirds */
  for (int n = 0; n < 60; n++) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    *(at(&solution, "C.overlap", "time", a) < at(&solution, "C.overlap", "time", b) ? &low : &high) =
        at(&solution, "C.overlap", "time", a) < at(&solution, "C.overlap", "time", b) ? a : b;
  }
  NEAR(*solution_find(&solution, "C.overlap max"), at(&solution, "C.overlap", "time", low), 1e-11);
  solution_free(&solution);
  const int cycles = (int)floor(low / 0.001);
  for (int s = 0; s < 2; s++) {
    snprintf(page, sizeof page, HITS("ratio 0.3", WALL WATCHED, "stage s\ncycles %d\nstage t\ncycles 9\n"),
             cycles + 2 * s - 1);
    CU_ASSERT_EQUAL(solve(&solution, "hertz_damped", page, &error), NB_OK);
    CU_ASSERT_EQUAL(!solution_find(&solution, "C.overlap max in s"), s == 0);
    CU_ASSERT_EQUAL(!solution_find(&solution, "C.overlap max in t"), s == 1);
    NEAR(*solution_find(&solution, "C.overlap in s"), at(&solution, "C.overlap", "time", 0.001 * (cycles + 2 * s - 1)),
         1e-12);
    solution_free(&solution);
  }
}

/* An overdamped contact lasts: the overlap is computed up to 100*20 alpha* / V_N after first contact. Critical damping
 * beyond an overlap then has no rebound to compute. */
static void impacts_without_rebound(void) {
  struct nb_solution solution;
  struct nb_error error = {0};
  const double unit = depth_at_wall() / 0.5;
  CU_ASSERT_EQUAL(solve(&solution, "hertz_damped", HITS("ratio 1", WALL WATCHED, "stage s\ncycles 9\n"), &error),
                  NB_OK);
  CU_ASSERT(at(&solution, "C.overlap", "time", 2 + 1999 * unit) > 0);
  CU_ASSERT(at(&solution, "C.normal", "time", 2 + 1999 * unit) > 0);
  CU_ASSERT(isnan(at(&solution, "C.overlap", "time", 2 + 2001 * unit)));
  CU_ASSERT(isnan(at(&solution, "C.dashpot.normal", "time", 2 + 2001 * unit)));
  CU_ASSERT(at(&solution, "C.overlap", "time", 1.999) == 0);
  solution_free(&solution);
  CU_ASSERT_EQUAL(solve(&solution, "hertz_deep",
                        HITS("ratio 1\ndamping critical beyond overlap 0.001", WALL WATCHED, "stage s\ncycles 9\n"),
                        &error),
                  NB_BROKEN);
  CU_ASSERT_STRING_EQUAL(error.text, "hertz_deep: the equation of motion could not be solved");
  solution_free(&solution);
}

void suite_refs_limits(void) {
  CU_pSuite suite = CU_add_suite("refs_limits", NULL, released);
  CU_ADD_TEST(suite, changed_law);
  CU_ADD_TEST(suite, free_fall);
  CU_ADD_TEST(suite, boxed_lattice);
  CU_ADD_TEST(suite, fracc_touch);
  CU_ADD_TEST(suite, cohesion);
  CU_ADD_TEST(suite, motion_without_damping);
  CU_ADD_TEST(suite, impacts_and_monitors);
  CU_ADD_TEST(suite, impacts_without_rebound);
}
