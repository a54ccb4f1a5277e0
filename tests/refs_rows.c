/* The references of rows of particles (chain, hertz_row, hertz_curve) on scenes without symmetry, compared with other
 * formulas, and the scenes that they refuse.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

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
                                     "D.x above 5.001 every 2 cycles at most 8 cycles"};
  for (int k = 0; k < 3; k++) {
    struct nb_solution solution;
    struct nb_error error = {0};
    char page[2048];
    snprintf(page, sizeof page, "%s\nuntil %s\nstage t\nuntil D.x above 4.9 at most 9 cycles\n",
             TWO("0.3") "monitor D sphere 1\nstep 0.05\nstage s", ends[k]);
    CU_ASSERT_EQUAL(solve(&solution, "chain", page, &error), NB_OK);
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
    check_message("chain", parts[k].text, parts[k].message);
#undef ENDS
#undef SECOND
}
#undef ROW
#undef LEFT
#undef RIGHT
#undef THREE
#undef STEP

/* Three spheres and two walls of five materials. The force is given, so the overlaps and the distance of the walls
 * follow from Hertz's formula. */
static double hertz(double radius, double e1, double nu1, double e2, double nu2) {
  return 4. / 3 * sqrt(radius) / ((1 - nu1 * nu1) / e1 + (1 - nu2 * nu2) / e2);
}
static void hertz_row(void) {
  const double k[4] = {hertz(2, 11, 0.25, 2, 0.3), hertz(2. / 3, 2, 0.3, 7, 0.1), hertz(0.6, 7, 0.1, 5, 0.2),
                       hertz(1.5, 5, 0.2, 1.3, 0.4)};
  const double m[3] = {3 * 4 * pi / 3 * 8, 5 * 4 * pi / 3, 4 * 4 * pi / 3 * 3.375}, force = 0.05;
  double overlap[4], spring[4], distance = 9;
  for (int c = 0; c < 4; c++) {
    overlap[c] = pow(force / k[c], 2. / 3), distance -= overlap[c];
    spring[c] = 1.5 * force / overlap[c]; /* dF/d(alpha) */
  }
  const double s1 = (spring[0] + spring[1]) / m[0], s2 = (spring[1] + spring[2]) / m[1],
               s3 = (spring[2] + spring[3]) / m[2];
  CU_ASSERT(s2 + s3 > 1.1 * (s1 + s2));
  for (int mirrored = 0; mirrored < 2; mirrored++) {
    const double side = mirrored ? -1 : 1;
    double x[3] = {side * 2, side * 5, side * 7};
    char page[2048], *end = page;
    end += sprintf(end, "material a density 3 young 2 poisson 0.3\nmaterial b density 5 young 7 poisson 0.1\n"
                        "material c density 4 young 5 poisson 0.2\nmaterial l young 11 poisson 0.25\n"
                        "material r young 1.3 poisson 0.4\nnormal hertz\nshear none\n");
    for (int w = 0; w < 2; w++) {
      const bool far = w != mirrored;
      end += sprintf(end, "wall %s %.17g -9 to %.17g 9 %s\n", far ? "r" : "l", -4 + side * (far ? distance : 0),
                     -4 + side * (far ? distance : 0), far ? "r" : "l");
    }
    for (int i = 0; i < 3; i++) {
      const int n = mirrored ? 2 - i : i;
      end += sprintf(end, "sphere %.17g 3 radius %s\n", -4 + x[n], n == 0 ? "2 a" : n == 1 ? "1 b" : "1.5 c");
    }
    sprintf(end,
            "monitor A sphere 2 with sphere %d\nmonitor B sphere %d with sphere 2\nmonitor C sphere 1 with sphere 3\n"
            "monitor D sphere 1\nmonitor W sphere 1 with wall %s\nstep 0.001\nstage s\ncycles 1\n",
            mirrored ? 3 : 1, mirrored ? 1 : 3, mirrored ? "r" : "l");
    VALUES("hertz_row", page, 0, {"A.normal", force}, {"A.overlap", overlap[1]}, {"B.normal", force},
           {"B.overlap", overlap[2]}, {"step.stable", 2 / sqrt(s2 + s3)});
  }
#define KIND "a row of spheres along x, from a first wall to a second one"
#define LONGER "a row that is longer than the distance between its walls"
#define SPHERES(spheres, walls)                                                                                        \
  "material a density 3 young 2 poisson 0.3\nnormal hertz\nshear none\n" spheres "\n" walls                            \
  "\nstep 0.001\nstage s\ncycles 1\n"
#define PAIR "sphere 1 3 radius 2 a\nsphere 4 3 radius 2 a"
#define WALLS(x0, x1) "wall p " x0 " -9 to " x0 " 9 a\nwall q " x1 " -9 to " x1 " 9 a"
  PARTS("hertz_row", "@", {SPHERES(PAIR, WALLS("-1", "6.99")), NULL}, {SPHERES(PAIR, WALLS("-1", "7")), LONGER},
        {SPHERES(PAIR, WALLS("-1", "7.01")), LONGER}, {SPHERES(PAIR, WALLS("-1", "6") "\nwall r 0 9 to 5 9 a"), KIND},
        {SPHERES(PAIR, "wall p -1 -9 to -1 9 a"), KIND}, {SPHERES("sphere 1 3 radius 2 a", WALLS("-1", "2.9")), KIND},
        {SPHERES(PAIR, "wall p -1 -9 to -1.1 9 a\nwall q 6 -9 to 6 9 a"), KIND},
        {SPHERES(PAIR, "wall p -1 -9 to -1 9 a\nwall q 6 -9 to 6.1 9 a"), KIND},
        {SPHERES("sphere 1 3 radius 2 a\nsphere 4 3.01 radius 2 a", WALLS("-1", "6")), KIND},
        {SPHERES("sphere 4 3 radius 2 a\nsphere 1 3 radius 2 a", WALLS("-1", "6")), KIND},
        {SPHERES(PAIR, WALLS("1", "6")), KIND}, {SPHERES(PAIR, WALLS("0.99", "6")), NULL},
        {SPHERES(PAIR, WALLS("-1", "4")), KIND}, {SPHERES(PAIR, WALLS("-1", "4.01")), NULL},
        {SPHERES(PAIR, WALLS("6", "-1")), KIND});
#undef KIND
#undef LONGER
#undef SPHERES
#undef PAIR
#undef WALLS
}

/* A column of two spheres that two walls compress, below the x axis. F is given, and y of the upper wall follows. */
#define COLUMN(spheres, low, high)                                                                                     \
  "material a density 3 young 2 poisson 0.3\nmaterial b density 5 young 7 poisson 0.1\n"                               \
  "material l young 11 poisson 0.25\nmaterial r young 1.3 poisson 0.4\nnormal hertz\nshear none\n" spheres             \
  "wall low -9 -20 to 9 -20 l velocity 0 " low "\nwall high 9 -14 to -9 -14 r velocity 0 " high "\n"                   \
  "monitor L sphere 1 with wall low\nstep 0.001\n"
#define BALLS "sphere 3 -18 radius 2 a\nsphere 3 -15 radius 1 b\n"
static void hertz_curve(void) {
  const double k[3] = {hertz(2, 11, 0.25, 2, 0.3), hertz(2. / 3, 2, 0.3, 7, 0.1), hertz(1, 7, 0.1, 1.3, 0.4)}, f = 1e-3;
  double alpha[3], s = 0;
  for (int c = 0; c < 3; c++)
    alpha[c] = pow(f / k[c], 2. / 3), s += alpha[c];
  const double y = -14 - s / 2;
#define AT(name, c)                                                                                                    \
  {name ".overlap", alpha[c], "H.y", y}, {name ".normal", f, "H.y", y}, {name ".normal", f, name ".overlap", alpha[c]}
#define BEFORE(name)                                                                                                   \
  {name ".overlap", 0, "H.y", -13.9}, {name ".normal", 0, "H.y", -13.9}, { name ".normal", 0, name ".overlap", 0 }
#define SQUEEZE "stage s\ncycles 3\nstage t\nwall low velocity 0 0.1\nwall high velocity 0 -0.1\ncycles 1\n"
  VALUES("hertz_curve",
         COLUMN(BALLS, "0.2", "-0.2") "monitor B wall low\nmonitor H wall high\nmonitor C sphere 2 with sphere 1\n"
                                      "monitor U sphere 2 with wall high\nmonitor X sphere 2 with wall low\n"
                                      "monitor Y sphere 1 with wall high\nmonitor D sphere 1\n" SQUEEZE,
         1e-3, AT("L", 0), AT("C", 1), AT("U", 2), BEFORE("L"), BEFORE("C"), BEFORE("U"));
  VALUES("hertz_curve", COLUMN(BALLS, "0.2", "-0.2") "monitor B wall low\nstage s\ncycles 1\n", 1e-3,
         {"L.normal", f, "L.overlap", alpha[0]});
  VALUES("hertz_curve",
         "path\nmaterial a young 2 poisson 0.3\nmaterial b young 7 poisson 0.1\ncontact sphere 2 a with sphere "
         "1 b\n"
         "normal hertz\nshear none\nrecord overlap normal\nsegment s overlap to 0.01 in 1 step\n",
         1e-3, {"normal", f, "overlap", alpha[1]});
  VALUES("hertz_curve",
         "path\nmaterial b young 7 poisson 0.1\nmaterial r young 1.3 poisson 0.4\ncontact sphere 1 b with wall r\n"
         "normal hertz\nshear none\nrecord overlap normal\nsegment s overlap to 0.01 in 1 step\n",
         1e-3, {"normal", f, "overlap", alpha[2]});
#undef AT
#undef BEFORE
#define EQUAL "up to seven spheres between a lower and an upper wall that approach with equal speeds"
#define ORDER "spheres one above the other, in the order of the page"
#define TOUCH "walls and spheres that just touch at first"
#define ONCE "stage s\ncycles 1\n"
#define SMALL(n) "sphere 3 " n " radius 0.5 a\n"
#define FIVE SMALL("-19.5") SMALL("-18.5") SMALL("-17.5") SMALL("-16.5") SMALL("-15.5")
  PARTS(
      "hertz_curve", "@", {COLUMN(BALLS, "0.2", "-0.2") SQUEEZE, NULL}, {COLUMN(BALLS, "0.2", "-0.3") ONCE, EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") "stage s\nwall low velocity 0 0.1\nwall high velocity 0 -0.2\ncycles 1\n", EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") ONCE "stage t\nwall high velocity 0 -0.1\ncycles 1\n", EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") "wall other 20 -20 to 20 -14 l\n" ONCE, EQUAL},
      {COLUMN("sphere 3 -18 radius 2 a\nsphere 3.001 -15 radius 1 b\n", "0.2", "-0.2") ONCE, ORDER},
      {COLUMN("sphere 3 -18 radius 2 a\nsphere 3 -15 radius (1 + 1e-12) b\n", "0.2", "-0.2") ONCE, NULL},
      {COLUMN("sphere 3 -18 radius 2 a\nsphere 3 -15 radius (1 + 1e-11) b\n", "0.2", "-0.2") ONCE, TOUCH},
      {COLUMN("sphere 3 -18 radius 2 a\nsphere 3 -15 radius (1 - 1e-11) b\n", "0.2", "-0.2") ONCE, TOUCH},
      {COLUMN(FIVE SMALL("-14.5"), "0.2", "-0.2") ONCE, NULL},
      {COLUMN(FIVE "sphere 3 -14.75 radius 0.25 a\nsphere 3 -14.25 radius 0.25 a\n", "0.2", "-0.2") ONCE, NULL},
      {COLUMN(FIVE "sphere 3 -14.75 radius 0.25 a\nsphere 3 -14.375 radius 0.125 a\nsphere 3 -14.125 radius 0.125 a\n",
              "0.2", "-0.2") ONCE,
       EQUAL});
#undef EQUAL
#undef ORDER
#undef TOUCH
#undef ONCE
#undef SMALL
#undef FIVE
#undef SQUEEZE
}
#undef BALLS
#undef COLUMN

void suite_refs_rows(void) {
  CU_pSuite suite = CU_add_suite("refs_rows", NULL, released);
  CU_ADD_TEST(suite, chain);
  CU_ADD_TEST(suite, other_chains);
  CU_ADD_TEST(suite, hertz_row);
  CU_ADD_TEST(suite, hertz_curve);
}
