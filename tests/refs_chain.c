/* The reference `chain`, compared with the calculation cycle of every disc, and with Bessel functions.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdbool.h>

#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

enum { N = 40 };

/* Writes a page with a row of n discs between two walls, of which either may be the first one. The mass of a disc and the
 * stiffness of a contact are 1. `step` is a fraction of the single-contact step, and `more` has the stages. */
static void row_of(struct written *it, int n, const char *step, const char *more, bool east_first) {
  struct words page = {0};
  const double x[2] = {0, 1.75 * n - 0.25};
  words_add(&page,
            "units none\nmaterial m density 0.3183098861837907 kn 1\ndisc 0.75 0 radius 1 m velocity 1e-3 0\n"
            "lattice discs %d by 1 from 2.5 0 radius 1 spacing 1.75 m\n",
            n - 1);
  for (int k = 0; k < 2; k++) {
    const bool east = (k == 0) == east_first;
    words_add(&page, "wall %s %.17g -1 to %.17g 1 m\n", east ? "e" : "w", x[east], x[east]);
  }
  words_add(&page,
            "monitor W disc 1 with wall w\nmonitor E disc %d with wall e\nmonitor D disc 3\n"
            "monitor C disc 3 with disc 2\nstep %s of single-contact\n%s",
            n, step, more);
  written_scene(it, &page);
}
static void row(struct written *it, int n, const char *step, const char *more) { row_of(it, n, step, more, false); }

static const struct nb_solution_curve *curve(const struct nb_solution *solution, const char *name) {
  const struct nb_solution_curve *found = solution_find_curve(solution, name, "cycle");
  CU_ASSERT_PTR_NOT_NULL_FATAL(found);
  return found;
}

/* Compares the reference with the calculation cycle of seven discs. dt is the time of `step`. */
static void check_cycle(const char *step, double dt, bool east_first) {
  struct written it;
  struct refs_scene scene;
  row_of(&it, 7, step, "stage s\ncycles 100\n", east_first);
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("chain", &scene);
  const struct nb_solution_curve *w = curve(&solution, "W.normal"), *e = curve(&solution, "E.normal"),
                                 *c = curve(&solution, "C.normal");
  const struct nb_solution_curve *x = curve(&solution, "D.x"), *v = curve(&solution, "D.vx.half");
  double u[9] = {0}, speed[9] = {0}, worst = 0, size = 0;
  speed[1] = 1e-3;
  for (int n = 1; n <= 100; n++) {
    double now[9];
    for (int l = 1; l <= 7; l++)
      speed[l] += dt * (u[l - 1] - 2 * u[l] + u[l + 1]);
    for (int l = 1; l <= 7; l++)
      now[l] = u[l] + dt * speed[l];
    for (int l = 1; l <= 7; l++) {
      u[l] = now[l];
      size = fmax(size, fabs(u[l]));
    }
    worst = fmax(worst, fabs(w->at(w->data, n) - (0.25 - u[1])));
    worst = fmax(worst, fabs(e->at(e->data, n) - (0.25 + u[7])));
    worst = fmax(worst, fabs(c->at(c->data, n) - (0.25 + u[2] - u[3])));
    worst = fmax(worst, fabs(x->at(x->data, n) - (0.75 + 2 * 1.75 + u[3])));
    worst = fmax(worst, dt * fabs(v->at(v->data, n) - speed[3]));
  }
  CU_ASSERT(worst < 1e-10 * fmax(size, 1e-3));
  solution_free(&solution);
  written_free(&it);
}

static void modes_equal_the_cycle(void) {
  check_cycle("0.05", 0.1, false);
  check_cycle("0.45", 0.9, true);
  check_cycle("0.53", 1.06, false); /* cos(pi/16) dt > 1: one mode grows */
}

/* Disc 1, which is at a wall, has an initial velocity. Until the reflection at the other wall arrives, the velocity of
 * disc l is J_(2l-2)(2t) - J_(2l+2)(2t) times the initial one, with Bessel functions J. */
static void impulse_gives_bessel_functions(void) {
  struct written it;
  struct refs_scene scene;
  row(&it, N, "0.001", "stage s\nuntil D.vx.half above 1e-4 at most 5000 cycles\n");
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("chain", &scene);
  const struct nb_solution_curve *v = curve(&solution, "D.vx.half");
  double worst = 0, first = 0;
  for (int n = 1; n <= 15000; n += 7) {
    const double t = 0.002 * (n - 0.5);
    worst = fmax(worst, fabs(v->at(v->data, n) / 1e-3 - gsl_sf_bessel_Jn(4, 2 * t) + gsl_sf_bessel_Jn(8, 2 * t)));
  }
  CU_ASSERT(worst < 1e-5); /* the relative error of the phase is (omega dt)^2/24 */
  for (int n = 1; first == 0; n++)
    if (gsl_sf_bessel_Jn(4, 0.004 * (n - 0.5)) - gsl_sf_bessel_Jn(8, 0.004 * (n - 0.5)) > 0.1)
      first = 0.002 * n;
  REFS_NEAR(refs_value(&solution, "time in s"), first, 1e-12, first);
  solution_free(&solution);
  written_free(&it);
}

/* A stage that lasts until a quantity is below a value has no time in the reference. */
static void other_ends_have_no_time(void) {
  for (int k = 0; k < 2; k++) {
    struct written it;
    struct refs_scene scene;
    row(&it, N, "0.001",
        k ? "stage s\nuntil D.vx.half below 1e-4 at most 5000 cycles\n"
          : "stage s\nuntil D.vx.half above 1e-4 at most 5000 cycles\n");
    scene.scene = it.scene;
    struct nb_solution solution = refs_solution("chain", &scene);
    CU_ASSERT_EQUAL(solution_find(&solution, "time in s") == NULL, k);
    solution_free(&solution);
    written_free(&it);
  }
}

void suite_refs_chain(void) {
  CU_pSuite suite = CU_add_suite("refs_chain", NULL, NULL);
  CU_add_test(suite, "the sum of modes equals the calculation cycle", modes_equal_the_cycle);
  CU_add_test(suite, "an impulse gives Bessel functions", impulse_gives_bessel_functions);
  CU_ADD_TEST(suite, other_ends_have_no_time);
}
