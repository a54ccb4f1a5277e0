/* Rows and columns of elastic spheres between walls (hertz_row, hertz_curve), compared with Hertz's formula.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

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
#define BETWEEN_OF(spheres, low, high)                                                                                 \
  "material a density 3 young 2 poisson 0.3\nmaterial b density 5 young 7 poisson 0.1\n"                               \
  "material l young 11 poisson 0.25\nmaterial r young 1.3 poisson 0.4\nnormal hertz\nshear none\n" spheres             \
  "wall low " low "\nwall high " high "\nmonitor L sphere 1 with wall low\nstep 0.001\n"
#define COLUMN(spheres, low, high)                                                                                     \
  BETWEEN_OF(spheres, "-9 -20 to 9 -20 l velocity 0 " low, "9 -14 to -9 -14 r velocity 0 " high)
#define BETWEEN(low, high) BETWEEN_OF(BALLS, low, high) ONCE
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
#define ONCE "stage s\ncycles 1\n"
#define SQUEEZE "stage s\ncycles 3\nstage t\nwall low velocity 0 0.1\nwall high velocity 0 -0.1\ncycles 1\n"
  VALUES("hertz_curve",
         COLUMN(BALLS, "0.2", "-0.2") "monitor B wall low\nmonitor H wall high\nmonitor C sphere 2 with sphere 1\n"
                                      "monitor U sphere 2 with wall high\nmonitor X sphere 2 with wall low\n"
                                      "monitor Y sphere 1 with wall high\nmonitor D sphere 1\n"
                                      "monitor V sphere 1 with sphere 2\n" SQUEEZE,
         1e-3, AT("L", 0), AT("C", 1), AT("U", 2), AT("V", 1), BEFORE("L"), BEFORE("C"), BEFORE("U"), BEFORE("V"));
  VALUES("hertz_curve", COLUMN(BALLS, "0.2", "-0.2") "monitor B wall low\nmonitor U sphere 2 with wall high\n" ONCE,
         1e-3, {"L.normal", f, "L.overlap", alpha[0]}, {"U.normal", f, "U.overlap", alpha[2]});
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
#define EQUAL "up to seven spheres between level walls, a lower and an upper one, that approach with equal speeds"
#define ORDER "spheres one above the other, in the order of the page"
#define TOUCH "walls and spheres that just touch at first"
#define SMALL(n) "sphere 3 " n " radius 0.5 a\n"
#define FIVE SMALL("-19.5") SMALL("-18.5") SMALL("-17.5") SMALL("-16.5") SMALL("-15.5")
  PARTS(
      "hertz_curve", "@", {COLUMN(BALLS, "0.2", "-0.2") SQUEEZE, NULL}, {COLUMN(BALLS, "0.2", "-0.3") ONCE, EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") "stage s\nwall low velocity 0 0.1\nwall high velocity 0 -0.2\ncycles 1\n", EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") ONCE "stage t\nwall high velocity 0 -0.1\ncycles 1\n", EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") "stage s\nwall low velocity 0.1 0.2\nwall high velocity 0 -0.2\ncycles 1\n", EQUAL},
      {COLUMN(BALLS, "0.2", "-0.2") "stage s\nwall low velocity 0 0.2\nwall high velocity -0.1 -0.2\ncycles 1\n",
       EQUAL},
      {BETWEEN("-9 -20 to 9 -20 l velocity 0.1 0.2", "9 -14 to -9 -14 r velocity 0 -0.2"), EQUAL},
      {BETWEEN("-9 -20 to 9 -20 l velocity 0 0.2", "9 -14 to -9 -14 r velocity 0.1 -0.2"), EQUAL},
      {BETWEEN("-9 -20 to 9 -19.99 l velocity 0 0.2", "9 -14 to -9 -14 r velocity 0 -0.2"), EQUAL},
      {BETWEEN("-9 -20 to 9 -20 l velocity 0 0.2", "9 -14 to -9 -14.01 r velocity 0 -0.2"), EQUAL},
      {BETWEEN("-9 -20 to 2.99 -20 l velocity 0 0.2", "2.99 -14 to -9 -14 r velocity 0 -0.2"), EQUAL},
      {BETWEEN("-9 -20 to 3.01 -20 l velocity 0 0.2", "3.01 -14 to -9 -14 r velocity 0 -0.2"), NULL},
      {BETWEEN("2.99 -20 to 9 -20 l velocity 0 0.2", "9 -14 to 3.01 -14 r velocity 0 -0.2"), EQUAL},
      {BETWEEN("3.01 -20 to 9 -20 l velocity 0 0.2", "9 -14 to 2.99 -14 r velocity 0 -0.2"), EQUAL},
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
  VALUES("hertz_curve",
         COLUMN(FIVE SMALL("-14.5"), "0.2", "-0.2") "monitor X sphere 1 with sphere 3\nmonitor Y sphere 4 with sphere "
                                                    "2\n" ONCE,
         1, {"L.normal", 0, "L.overlap", 0}); /* X and Y are no contacts */
#undef EQUAL
#undef ORDER
#undef TOUCH
#undef ONCE
#undef SMALL
#undef FIVE
#undef SQUEEZE
}
#undef BALLS
#undef BETWEEN_OF
#undef BETWEEN
#undef COLUMN

void suite_refs_hertz_rows(void) {
  CU_pSuite suite = CU_add_suite("refs_hertz_rows", NULL, refs_released);
  CU_ADD_TEST(suite, hertz_row);
  CU_ADD_TEST(suite, hertz_curve);
}
