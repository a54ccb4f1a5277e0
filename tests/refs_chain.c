/* The reference `chain`, compared with the calculation cycle of every particle, with
 * Bessel functions, and on rows between walls of other materials.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdbool.h>

#include "refs_scenes.h"
#include "refs_tables.h"
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

/* Spheres of radius 2 and mass 6, k = 30. The overlap of all contacts is 0.25. The step is 0.05. */
#define ROW(moves, spheres, walls)                                                                                     \
  "material m density (6/(32*pi/3)) kn 30\nmaterial w kn 10\nmaterial v kn 30\npair m w kn 30\nnormal linear\nshear "  \
  "none\nsphere 5 7 radius 2 m " moves "\n" spheres walls
#define LEFT "wall l 3.25 -9 to 3.25 9 w\n"
#define RIGHT(x) "wall r " x " 9 to " x " -9 v\n"
#define THREE "sphere 8.75 7 radius 2 m velocity -0.03 0\nsphere 12.5 7 radius 2 m velocity 0.07 0\n"
#define STEP "step 0.05\nstage s\ncycles 1\n"

/* The calculation cycle of n spheres: displacements u and velocities v, whose first and last are those of the walls. */
static void cycle(int n, double u[], double v[]) {
  for (int l = 1; l <= n; l++)
    v[l] += 0.05 * 30. / 6 * (u[l - 1] - 2 * u[l] + u[l + 1]);
  for (int l = 1; l <= n; l++)
    u[l] += 0.05 * v[l];
}

/* Stage t lasts until sphere 2 is beyond 8.7501, stage v until the force of B is above 7.6. Nobody knows a time of the
 * stages after w, which has two conditions. */
static void chain(void) {
  static const char stages[] =
      "monitor A sphere 2 with sphere 1\nmonitor B sphere 2 with sphere 3\nmonitor L sphere 1 with wall l\n"
      "monitor R sphere 3 with wall r\nmonitor D sphere 2\nmonitor F sphere 1 with sphere 3\n"
      "monitor G sphere 1 with wall r\nmonitor H sphere 3 with wall l\nmonitor W wall l\nstep 0.05\nstage s\ncycles 4\n"
      "stage t\nuntil D.x above 8.7501 at most 900 cycles\nstage u\ncycles 3\n"
      "stage v\nuntil B.normal above 7.6 at most 900 cycles\n"
      "stage w\nuntil D.x above 8 and B.normal above 0 at most 900 cycles\nstage x\nuntil D.x above 8 at most 9 "
      "cycles\n";
  double u[5] = {0}, v[5] = {0, 0.1, -0.03, 0.07}, t = 0, w = 0;
  double force[4][20] = {{0}}, x[20], half[20];
  for (int n = 0, last = 0; (n < 20 || w == 0) && n < 900; n++, cycle(3, u, v)) {
    if (n < 20) {
      for (int c = 0; c < 4; c++)
        force[c][n] = 30 * (0.25 + u[c] - u[c + 1]);
      x[n] = 8.75 + u[2], half[n] = v[2];
    }
    if (n > 4 && t == 0 && 8.75 + u[2] > 8.7501)
      t = 0.05 * n, last = n;
    else if (t > 0 && w == 0 && n > last + 3 && 30 * (0.25 + u[2] - u[3]) > 7.6)
      w = 0.05 * n;
  }
  CU_ASSERT(t > 0.25 && w > t + 0.2);
  for (int k = 0; k < 2; k++) {
    char page[2048];
    snprintf(page, sizeof page, "%s%s",
             k ? ROW("velocity 0.1 0", THREE, RIGHT("14.25") LEFT) : ROW("velocity 0.1 0", THREE, LEFT RIGHT("14.25")),
             stages);
#define BOTH(name, array, n) {name, (array)[n], "cycle", n}, {name, (array)[n], "time", 0.05 * (n)}
    VALUES("chain", page, 8, BOTH("L.normal", force[0], 1), BOTH("L.normal", force[0], 17),
           BOTH("A.normal", force[1], 2), BOTH("A.normal", force[1], 19), BOTH("B.normal", force[2], 3),
           BOTH("B.normal", force[2], 18), BOTH("R.normal", force[3], 5), BOTH("R.normal", force[3], 16),
           BOTH("D.x", x, 0), BOTH("D.x", x, 15), BOTH("D.vx.half", half, 1), BOTH("D.vx.half", half, 14),
           {"time in t", t}, {"time in v", w}, {"step.stable", sqrt(6 / 30.)});
#undef BOTH
  }
  /* One sphere between two walls is an oscillator with 2 k/m = 10, of any position. So is the mode of two spheres that
   * move together, which has k/m = 5, and the mode of two that move in opposite directions, which has 3 k/m = 15. In
   * steps its phase grows by acos(1 - w^2 dt^2/2). */
#define FREQUENCY(w2) (acos(1 - (w2)*0.05 * 0.05 / 2) / (2 * pi * 0.05))
#define FIRST(force) {"L.normal", (force), "cycle", 1}, {"L.normal", (force), "time", 0.05}
#define KNOWN(w2)                                                                                                      \
  {"L.normal frequency", FREQUENCY(w2)}, { "L.normal mean", 7.5 }
  VALUES("chain", ROW("velocity -0.1 0", "", LEFT RIGHT("6.75")) "monitor L sphere 1 with wall l\n" STEP, 0,
         FIRST(7.5 + 30 * 0.1 * 0.05), KNOWN(10.));
  /* With w dt = 2 the two solutions of the recurrence coincide: s_n = (-1)^(n-1) n v dt. w dt/2 is exactly 1 here. */
  const double h = 2 / sqrt(10) + 1e-16;
  VALUES("chain",
         ROW("velocity -0.1 0", "", LEFT RIGHT("6.75")) "monitor L sphere 1 with wall l\nstep (2/sqrt(10) + 1e-16)\n"
                                                        "allow unstable\nstage s\ncycles 1\n",
         0, {"L.normal", 7.5 + 3 * h, "cycle", 1}, {"L.normal", 7.5 - 18 * h, "cycle", 6},
         {"L.normal", 7.5 + 57 * h, "cycle", 19}, {"L.normal", 7.5, "time", 0});
#define TWO(speed)                                                                                                     \
  ROW("velocity -0.1 0", "sphere 8.75 7 radius 2 m velocity " speed " 0\n", LEFT RIGHT("10.5"))                        \
  "monitor L sphere 1 with wall l\n"
  VALUES("chain", TWO("-0.1") STEP, 0, FIRST(7.65), KNOWN(5.), {"step.stable", sqrt(6 / 30.)});
  VALUES("chain", TWO("0.1") STEP, 0, FIRST(7.65), KNOWN(15.), {"step.stable", sqrt(6 / 30.)});
  VALUES("chain", TWO("-0.2") STEP, 0, FIRST(7.65), {"step.stable", sqrt(6 / 30.)});
  VALUES("chain", TWO("(0.1 + 1e-14)") STEP, 0, FIRST(7.65), KNOWN(15.), {"step.stable", sqrt(6 / 30.)});
  VALUES("chain", TWO("(0.1 + 2e-12)") STEP, 0, FIRST(7.65), {"step.stable", sqrt(6 / 30.)});
  /* A condition that holds already ends the stage after one cycle. */
  VALUES("chain",
         TWO("0.1") "monitor D sphere 1\nstep 0.05\nstage s\ncycles 4\nstage t\nuntil D.x above 4 at most 9 cycles\n",
         0, FIRST(7.65), KNOWN(15.), {"step.stable", sqrt(6 / 30.)}, {"time in t", 0.25}, {"D.x", 5, "cycle", 0},
         {"D.x", 5, "time", 0}, {"D.vx.half", -0.1, "cycle", 1}, {"D.vx.half", -0.1, "time", 0.05});
  /* The two spheres come back after pi/acos(1 - 15 dt^2/2) = 16.2 cycles. Stage t may last until cycle 7 + 10. */
  VALUES("chain",
         TWO("0.1") "monitor D sphere 1\nstep 0.05\nstage r\ncycles 4\nstage s\ncycles 3\nstage t\n"
                    "until D.x above 5 at most 10 cycles\n",
         0, FIRST(7.65), KNOWN(15.), {"step.stable", sqrt(6 / 30.)}, {"time in t", 17 * 0.05}, {"D.x", 5, "cycle", 0},
         {"D.x", 5, "time", 0}, {"D.vx.half", -0.1, "cycle", 1}, {"D.vx.half", -0.1, "time", 0.05});
  /* The mode with 3 k/m is unstable, that with k/m is not. w dt = 2.1 and w dt = 2.1/sqrt(3) */
  VALUES("chain", TWO("-0.1") "step (2.1/sqrt(15))\nallow unstable\nstage s\ncycles 1\n", 0,
         {"L.normal", 7.5 + 3 * 2.1 / sqrt(15), "cycle", 1},
         {"L.normal", 7.5 + 3 * 2.1 / sqrt(15), "time", 2.1 / sqrt(15)},
         {"L.normal frequency", acos(1 - 2.1 * 2.1 / 6) / (2 * pi * 2.1 / sqrt(15))}, {"L.normal mean", 7.5},
         {"step.stable", sqrt(6 / 30.)});
  VALUES("chain", TWO("0.1") "step (2.1/sqrt(15))\nallow unstable\nstage s\ncycles 1\n", 0,
         {"L.normal", 7.5 + 3 * 2.1 / sqrt(15), "cycle", 1},
         {"L.normal", 7.5 + 3 * 2.1 / sqrt(15) * (2 - 2.1 * 2.1), "cycle", 2},
         {"L.normal", 7.5 + 3 * 2.1 / sqrt(15), "time", 2.1 / sqrt(15)}, {"step.stable", sqrt(6 / 30.)});
  /* A stage whose end the reference does not know, and those after it, have no time. */
  static const char *const ends[] = {"D.x below 5 at most 9 cycles", "time above 0.1 at most 9 cycles",
                                     "D.x above 4.9 every 2 cycles at most 8 cycles", "D.x above 9 at most 9 cycles"};
  for (int k = 0; k < 4; k++) {
    struct nb_solution solution;
    struct nb_error error = {0};
    char page[2048];
    snprintf(page, sizeof page, "%s\nuntil %s\nstage t\nuntil D.x above 4.9 at most 9 cycles\n",
             TWO("0.3") "monitor D sphere 1\nstep 0.05\nstage s", ends[k]);
    CU_ASSERT_EQUAL(refs_solve(&solution, "chain", page, &error), NB_OK);
    CU_ASSERT_PTR_NULL(solution_find(&solution, "time in s"));
    CU_ASSERT_PTR_NULL(solution_find(&solution, "time in t"));
    solution_free(&solution);
  }
#undef TWO
#undef FIRST
#undef KNOWN
#undef FREQUENCY
}

static void other_chains(void) {
  static const char alike[] = "a straight row of equal particles that move along it",
                    stiff[] = "walls as stiff as the particles",
                    same[] = "a row in the order of x, with the same overlap at every contact",
                    steps[] = "a step given as a time or as a fraction of single-contact";
#define ENDS LEFT RIGHT("10.5")
#define SECOND "sphere 8.75 7 radius 2 m\n"
  const struct part parts[] = {
      {ROW("", SECOND, ENDS) STEP, NULL},
      {ROW("", SECOND, ENDS) "step 0.1 of single-contact\nstage s\ncycles 1\n", NULL},
      {ROW("", SECOND, ENDS) "step 0.1 of stable\nstage s\ncycles 1\n", steps},
      {ROW("", SECOND, LEFT) STEP, "two walls"},
      {ROW("", SECOND, ENDS "wall m -9 -9 to 9 -9 m\n") STEP, "two walls"},
      {ROW("", "sphere 8.75 7.01 radius 2 m\n", ENDS) STEP, alike},
      {ROW("", "sphere 8.75 7 radius 2 m velocity 0 0.01\n", ENDS) STEP, alike},
      {ROW("velocity 0 -0.01", SECOND, ENDS) STEP, alike},
      {ROW("", "sphere 8.75 7 radius (2 + 1e-9) m\n", ENDS) STEP, alike},
      {ROW("", "material o density 1 kn 30\nsphere 8.75 7 radius 2 o\n", ENDS) STEP, alike},
      {ROW("", SECOND, "material o kn 31\nwall l 3.25 -9 to 3.25 9 o\n" RIGHT("10.5")) STEP, stiff},
      {ROW("", SECOND, "material o kn 31\n" LEFT "wall r 10.5 -9 to 10.5 9 o\n") STEP, stiff},
      {ROW("", "sphere (8.75 + 1e-9) 7 radius 2 m\n", LEFT RIGHT("(10.5 + 1e-9)")) STEP, NULL},
      {ROW("", "sphere (8.75 + 3e-9) 7 radius 2 m\n", LEFT RIGHT("(10.5 + 3e-9)")) STEP, same},
      {ROW("", "sphere (8.75 - 3e-9) 7 radius 2 m\n", LEFT RIGHT("(10.5 - 3e-9)")) STEP, same},
      {ROW("", SECOND, LEFT RIGHT("(10.5 + 3e-9)")) STEP, same},
      {ROW("", SECOND, LEFT RIGHT("(10.5 - 3e-9)")) STEP, same},
      {ROW("", SECOND, LEFT RIGHT("(10.5 + 1e-9)")) STEP, NULL},
      {ROW("", "sphere 9 7 radius 2 m\n", "wall l 3 -9 to 3 9 w\n" RIGHT("11")) STEP, same},
      {ROW("", "sphere 8.999 7 radius 2 m\n", "wall l 3.001 -9 to 3.001 9 w\n" RIGHT("10.998")) STEP, NULL},
      {ROW("", "sphere 9.001 7 radius 2 m\n", "wall l 2.999 -9 to 2.999 9 w\n" RIGHT("11.002")) STEP, same},
      {ROW("", "sphere 1.25 7 radius 2 m\n", "wall l -0.5 -9 to -0.5 9 w\n" RIGHT("6.75")) STEP, same},
      {ROW("", SECOND, "wall l 3.25 -9 to 3.35 9 w\n" RIGHT("10.5")) STEP, same},
      {ROW("", SECOND, LEFT "wall r 10.5 -9 to 10.51 9 v\n") STEP, same},
  };
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    refs_check_message("chain", parts[k].text, parts[k].message);
#undef ENDS
#undef SECOND
}
#undef ROW
#undef LEFT
#undef RIGHT
#undef THREE
#undef STEP

void suite_refs_chain(void) {
  CU_pSuite suite = CU_add_suite("refs_chain", NULL, refs_released);
  CU_add_test(suite, "the sum of modes equals the calculation cycle", modes_equal_the_cycle);
  CU_add_test(suite, "an impulse gives Bessel functions", impulse_gives_bessel_functions);
  CU_ADD_TEST(suite, chain);
  CU_ADD_TEST(suite, other_chains);
}
