/* The motion of Hertz's impact with a dashpot, and the references of it (hertz_impact, hertz_increment, hertz_damped,
 * hertz_deep), on further scenes.
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
  CU_ASSERT_EQUAL(refs_solve(&solution, "hertz_impact", HITS("none", WALL WATCHED, "stage s\ncycles 9\n"), &error),
                  NB_OK);
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
  CU_ASSERT_EQUAL(refs_solve(&solution, "hertz_damped", HITS("ratio 0.3", WALL WATCHED, "stage s\ncycles 9\n"), &error),
                  NB_OK);
  double low = 2, high = 2 + 2 * unit; /* of the largest overlap, by thirds */
  for (int n = 0; n < 60; n++) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (at(&solution, "C.overlap", "time", a) < at(&solution, "C.overlap", "time", b))
      low = a;
    else
      high = b;
  }
  NEAR(*solution_find(&solution, "C.overlap max"), at(&solution, "C.overlap", "time", low), 1e-11);
  solution_free(&solution);
  const int cycles = (int)floor(low / 0.001);
  for (int s = 0; s < 2; s++) {
    snprintf(page, sizeof page, HITS("ratio 0.3", WALL WATCHED, "stage s\ncycles %d\nstage t\ncycles 9\n"),
             cycles + 2 * s - 1);
    CU_ASSERT_EQUAL(refs_solve(&solution, "hertz_damped", page, &error), NB_OK);
    CU_ASSERT_EQUAL(!solution_find(&solution, "C.overlap max in s"), s == 0);
    CU_ASSERT_EQUAL(!solution_find(&solution, "C.overlap max in t"), s == 1);
    NEAR(*solution_find(&solution, "C.overlap in s"), at(&solution, "C.overlap", "time", 0.001 * (cycles + 2 * s - 1)),
         1e-12);
    solution_free(&solution);
  }
}

/* An overdamped contact lasts: the overlap is computed up to 100*20 alpha* / V_N after first contact. hertz_deep
 * refuses it. */
static void impacts_without_rebound(void) {
  struct nb_solution solution;
  struct nb_error error = {0};
  const double unit = depth_at_wall() / 0.5;
  CU_ASSERT_EQUAL(refs_solve(&solution, "hertz_damped", HITS("ratio 1", WALL WATCHED, "stage s\ncycles 9\n"), &error),
                  NB_OK);
  CU_ASSERT(at(&solution, "C.overlap", "time", 2 + 1999 * unit) > 0);
  CU_ASSERT(at(&solution, "C.normal", "time", 2 + 1999 * unit) > 0);
  CU_ASSERT(isnan(at(&solution, "C.overlap", "time", 2 + 2001 * unit)));
  CU_ASSERT(isnan(at(&solution, "C.dashpot.normal", "time", 2 + 2001 * unit)));
  CU_ASSERT(at(&solution, "C.overlap", "time", 1.999) == 0);
  solution_free(&solution);
  /* e = 0 from the ratio (5/6)^(1/2) = 0.91287 on. An impact with the ratio 0.88 lasts 34 alpha* / V_N, and one with 0.9
   * lasts 141; hertz_deep computes 50. No overlap reaches 0.9 of the diameter. */
#define DEEP(ratio, overlap)                                                                                           \
  HITS("ratio " ratio "\ndamping critical beyond overlap " overlap, WALL WATCHED, "stage s\ncycles 9\n")
#define ENDS "an impact that ends, with dashpots well below critical damping"
  PARTS("hertz_deep", "@", {DEEP("0.8", "0.001"), NULL}, {DEEP("0.91288", "0.001"), ENDS}, {DEEP("1", "0.001"), ENDS},
        {DEEP("0.88", "0.9"), NULL}, {DEEP("0.9", "0.9"), ENDS}, {DEEP("0.1", "1e-9"), ENDS});
#undef DEEP
#undef ENDS
}

void suite_refs_hertz_motion(void) {
  CU_pSuite suite = CU_add_suite("refs_hertz_motion", NULL, refs_released);
  CU_ADD_TEST(suite, motion_without_damping);
  CU_ADD_TEST(suite, impacts_and_monitors);
  CU_ADD_TEST(suite, impacts_without_rebound);
}
