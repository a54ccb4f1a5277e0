/* References on scenes without symmetry, compared with other formulas, and the whole message of each scene that they
 * refuse. The expected values come from theory; none is a number that a program computed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"
#include "written.h"

/* Three spheres of two densities about the point (2, 3). Region Q is off the centre by a hundred-millionth of its radius,
 * region U by a ten-thousandth of that. */
#define HEAP                                                                                                           \
  "material a density 3 young 1 poisson 0.2\nmaterial b density 7 young 1 poisson 0.2\nnormal hertz\n"                 \
  "sphere 5 1 radius 2 a\nsphere 1 6 radius 1 b\nsphere -3 2 radius 0.5 a\nregion B box 0 1 to 4 5\nregion R circle "  \
  "2 3 radius 1.5\n"                                                                                                   \
  "region Q circle (2 + 2e-8) 3 radius 2\nregion V circle 2 (3 - 2e-8) radius 2\nregion U circle (2 + 2e-12) 3 "       \
  "radius 2\nmonitor D sphere 1\nstep 1\nrecord R.stress.mean\n"
static void centripetal(void) {
  const double mass = 4 * pi / 3 * (3 * 8.125 + 7), thickness = 7. / 3, radius = sqrt(5.25 / 0.845);
  const double p0 = 5 * mass / (pi * radius * thickness);
  VALUES("centripetal",
         HEAP "stage s\ngravity centripetal 4 about 2 3\ncycles 1\nstage n\ngravity 0 0\ncycles 1\nstage t\n"
              "gravity centripetal 5 about 2 3\ncycles 1\nstage u\ncycles 1\n",
         p0, {"R.stress.mean in u", p0 * (1 - 1 / radius)}, {"U.stress.mean in u", p0 * (1 - 4 / (3 * radius))});
  refs_check_message("centripetal",
                     HEAP "stage s\ngravity centripetal 4 about 2 3\ncycles 1\nstage t\ngravity 0 0\ncycles 1\n",
                     "`gravity centripetal` in the last stage");
  refs_check_message("centripetal", HEAP "stage s\ngravity centripetal -4 about 2 3\ncycles 1\n",
                     "`gravity centripetal` in the last stage");
}

/* A disc between two plates. The springs of the plates have k_n = 15 and k_s = 6, since those of the disc are 10 and 4
 * and those of the plates 30 and 12; the stop has k_n = 60/8. */
#define PRESSED                                                                                                        \
  "material d density 1 kn 10 ks 4 friction 0.5 cohesion 0.02\nmaterial p kn 30 ks 12 friction 0.7 cohesion 0.03\n"    \
  "material q kn 30 ks 12 friction 0.7 cohesion 0.03\nmaterial s kn 6\nnormal linear\nshear linear\n"
#define PLATES(side)                                                                                                   \
  PRESSED "disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\nwall stop " side " s\n"
#define WATCHED                                                                                                        \
  "monitor L disc 1 with wall low\nmonitor U disc 1 with wall high\nmonitor S disc 1 with wall stop\n"                 \
  "monitor D disc 1\nmonitor W wall high\n"
#define PRESS                                                                                                          \
  "step 0.1\nstage press\nwall high velocity 0 -0.01\ncycles 20\nstage rest\nwall high velocity 0 0\ncycles 7\n"
#define LEAVE "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.3\ncycles 1\n"
static void cohesion(void) {
  const double normal = 15 * 0.02 / 2, stop = 7.5, limit = 0.5 * normal + 0.02;
  const double sticks = 6 * 0.006 / (1 + 12 / stop);
  CU_ASSERT(sticks < 0.5 * limit);
  VALUES("cohesion",
         PLATES("7 6 to 7 8") WATCHED PRESS
         "stage drag\nwall low velocity 0.02 0\nwall high velocity 0.02 0\ncycles 3\n" LEAVE,
         0, {"L.normal in drag", normal}, {"L.shear in drag", sticks}, {"U.normal in drag", normal},
         {"U.shear in drag", -sticks}, {"U.normal in leave", 0}, {"U.shear in leave", 0});
  VALUES("cohesion",
         PLATES("3 6 to 3 8") WATCHED PRESS
         "stage drag\nwall low velocity -0.02 0\nwall high velocity -0.02 0\ncycles 300\n" LEAVE,
         0, {"L.normal in drag", normal}, {"L.shear in drag", -limit}, {"U.normal in drag", normal},
         {"U.shear in drag", limit}, {"U.normal in leave", 0}, {"U.shear in leave", 0});
#define KIND "one disc, a stop, and two plates that press, shear and then leave the disc"
#define DRAG "stage drag\nwall low velocity 0.02 0\nwall high velocity 0.02 0\ncycles 3\n"
  PARTS("cohesion", PLATES("7 6 to 7 8") "@", {PRESS DRAG LEAVE, NULL},
        {PRESS DRAG "stage wait\nwall low velocity 0 0\nwall high velocity 0 0\ncycles 1\n" LEAVE, NULL},
        {PRESS DRAG "stage again\ncycles 1\n" LEAVE, KIND}, {PRESS DRAG, KIND}, {PRESS LEAVE, KIND},
        {"step 0.1\n" DRAG LEAVE, KIND}, {"step 0.1\nstage s\ncycles 1\n" DRAG LEAVE, KIND},
        {"step 0.1\n" DRAG "stage press\nwall low velocity 0 0\nwall high velocity 0 -0.01\ncycles 20\n" LEAVE, KIND},
        {PRESS DRAG "stage more\nwall low velocity 0 0\nwall high velocity 0 -0.01\ncycles 2\n" LEAVE, KIND},
        {"step 0.1 of single-contact\nstage press\nwall high velocity 0 -0.01\ncycles 20\n" DRAG LEAVE, KIND},
        {PRESS DRAG "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.19\ncycles 1\n", KIND},
        {PRESS DRAG "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.21\ncycles 1\n", NULL},
        {PRESS DRAG "stage leave\nwall high velocity 0 0.3\ncycles 1\n", KIND},
        {PRESS DRAG "stage leave\nwall low velocity 0 -0.1\nwall high velocity 0 0.3\ncycles 1\n", KIND},
        {PRESS DRAG "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.3\nwall stop velocity 1 0\ncycles 1\n",
         KIND},
        {PRESS DRAG "stage leave\nwall low velocity 0 0\nwall high velocity 0 0.3\nwall stop velocity 0 1\ncycles 1\n",
         KIND},
        {PRESS "stage drag\nwall low velocity -0.02 0\nwall high velocity -0.02 0\ncycles 3\n" LEAVE, KIND},
        {PRESS "stage drag\nwall low velocity 0.01 0\nwall high velocity 0.02 0\ncycles 3\n" LEAVE, KIND},
        {PRESS "stage drag\nwall low velocity 0.02 0\nwall high velocity 0.02 -0.01\ncycles 3\n" LEAVE, KIND});
  PARTS("cohesion", PRESSED "@" PRESS DRAG LEAVE,
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 q\nwall stop 7 6 to 7 8 s\n",
         "plates of one material"},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 p\n",
         "a stop with neither friction nor cohesion"},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n"
         "pair d s friction 0 cohesion 1\n",
         "a stop with neither friction nor cohesion"},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p velocity 0.02 0\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p velocity 0 0.1\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 4.95 to 9 5.05 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 8.95 to 9 9.05 p\nwall stop 7 6 to 7 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\nwall stop 6.95 6 to 7.05 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 (5 - 1e-8) to 9 (5 - 1e-8) p\nwall high 0 9 to 9 9 p\n"
         "wall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 (5 + 1e-8) to 9 (5 + 1e-8) p\nwall high 0 9 to 9 9 p\n"
         "wall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 (5 + 1e-10) to 9 (5 + 1e-10) p\nwall high 0 (9 - 1e-10) to 9 (9 - 1e-10) p\n"
         "wall stop (7 - 1e-10) 6 to (7 - 1e-10) 8 s\n",
         NULL},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 (9 + 1e-8) to 9 (9 + 1e-8) p\n"
         "wall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\n"
         "wall stop (7 + 1e-8) 6 to (7 + 1e-8) 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 9 to 9 9 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 5 to 9 5 p\nwall stop 7 6 to 7 8 s\n", KIND});
#undef KIND
#undef DRAG
}

/* The upper plate moves from the start, approaches by 0.02 + 0.012 and moves in x while the stop is at the right. */
static void cohesion_in_two_presses(void) {
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

/* One disc of mass 5 between walls of k_n = 20: with w^2 = 2 k_n/m and sin(phi/2) = w dt/2 = h, the cycle gives
 * x_n = x_0 cos(n phi) and y_n = v_y dt sin(n phi)/sin(phi), or n v_y dt without walls in y. */
static void fracc_of(double x0, double vy, double h, bool tight, int cycles) {
  const double phi = 2 * asin(h), dt = 2 * h / sqrt(8);
  double x = x0, y = 0, largest = 0, most = x0;
  char page[1024];
  for (int n = 1; n <= cycles; n++) {
    const double u = x0 * cos(n * phi), v = vy * dt * (tight ? sin(n * phi) / sin(phi) : n);
    const double moved = hypot(u - x, v - y);
    largest = fmax(largest, moved > 0 ? h * sqrt(fabs(hypot(u, v) - hypot(x, y)) / moved) : 0);
    x = u, y = v, most = fmax(most, x);
  }
  snprintf(page, sizeof page,
           "material m density (5/(4*pi)) kn 30\nmaterial n kn 15\ndisc %.17g 0 radius 2 m velocity 0 %.17g\n"
           "wall n -9 %s to 9 %s n\nwall e 1.5 -9 to 1.5 9 n\nwall w -1.5 -9 to -1.5 9 n\nwall s -9 %s to 9 %s n\n"
           "monitor D disc 1\nstep (%.17g/sqrt(2)) of single-contact\nallow unstable\nstage s\ncycles %d\n",
           x0, vy, tight ? "1.5" : "2.5", tight ? "1.5" : "2.5", tight ? "-1.5" : "-2.5", tight ? "-1.5" : "-2.5", h,
           cycles);
  VALUES("fracc", page, 1, {"step.fracc max", largest}, {"D.x max", most});
}

#define BETWEEN                                                                                                        \
  "material m density 1 kn 20\nmaterial o kn 21\ndisc 0.1 0 radius 2 m@\nstep 0.1 of single-contact\nstage s\ncycles " \
  "60\n"
#define FOUR(n, e, w, s)                                                                                               \
  "wall n -9 " n " to 9 " n " m\nwall e " e " -9 to " e " 9 m\nwall w " w " -9 to " w " 9 m\nwall s -9 " s " to 9 " s  \
  " m"
static void fracc(void) {
  fracc_of(0.1, 0, 0.3, false, 4);
  fracc_of(-0.1, 0, 0.5, false, 2);
  fracc_of(-0.1, 0, 0.5, true, 3);
  fracc_of(0.01, 0.05, 0.3, true, 40);
  fracc_of(-0.01, 0.05, 0.3, false, 20);
  fracc_of(0, 0, 0.3, false, 3); /* at rest */
  fracc_of(0.01, 0.05, 0.3, true, 1);
#define REACH                                                                                                          \
  "two walls along y that the disc touches all the time and two along x that it touches all the time or never, at "    \
  "equal distances from the origin"
  PARTS(
      "fracc", BETWEEN, {"\n" FOUR("1", "1.8", "-1.8", "-1"), NULL}, {"\n" FOUR("3", "1.8", "-1.8", "-3"), NULL},
      {"\n" FOUR("1", "1.91", "-1.91", "-1"), REACH}, {"\n" FOUR("1", "1.89", "-1.89", "-1"), NULL},
      {"\n" FOUR("1", "1.8", "-1.81", "-1"), REACH}, {"\n" FOUR("1", "1.8", "-1.8", "-1.1"), REACH},
      {"\n" FOUR("1", "1.8", "1.8", "-1"), REACH}, {"\n" FOUR("1", "-1.8", "-1.8", "-1"), REACH},
      {"\n" FOUR("1", "1.8", "-1.8", "1"), REACH}, {"\n" FOUR("-1", "1.8", "-1.8", "-1"), REACH},
      {"\nwall n -9 0.95 to 9 1.05 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1 to 9 -1 m",
       REACH},
      {"\nwall n -9 1 to 9 1 m\nwall e 1.75 -9 to 1.85 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1 to 9 -1 m", REACH},
      {"\nwall n 1.8 -9 to 1.8 9 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -1.8 -9 to -1.8 9 m",
       REACH},
      {" velocity 0 0.4\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), REACH},
      {" velocity 0 -0.4\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), REACH},
      {" velocity 0 0.2\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), NULL},
      {" velocity 0 0.4\n" FOUR("3", "1.8", "-1.8", "-3"), REACH},
      {" velocity 0 0.05\n" FOUR("3", "1.8", "-1.8", "-3"), NULL},
      {" velocity 0 -0.4\n" FOUR("3", "1.8", "-1.8", "-3"), REACH},
      {"\nwall n -0.09999 1.8 to 9 1.8 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1.8 to 9 "
       "-1.8 m",
       REACH},
      /* x remains within 0.1, and y within 0.3 to 0.4: walls may end beyond that */
      {" velocity 0 0.2\nwall n -0.11 1.8 to 9 1.8 m\nwall e 1.8 -0.8 to 1.8 0.8 m\nwall w -1.8 9 to -1.8 -9 m\n"
       "wall s 0.11 -1.8 to -9 -1.8 m",
       NULL},
      {"\nwall n -0.09 1.8 to 9 1.8 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1.8 to 9 -1.8 "
       "m",
       REACH},
      {"\nwall n -9 1.8 to 9 1.8 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s 0.09 -1.8 to -9 -1.8 "
       "m",
       REACH},
      {" velocity 0 0.2\nwall n -9 1.8 to 9 1.8 m\nwall e 1.8 -0.01 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 "
       "-1.8 to 9 -1.8 m",
       REACH},
      {" velocity 0 0.2\nwall n -9 1.8 to 9 1.8 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 9 to -1.8 0.01 m\nwall s -9 "
       "-1.8 to 9 -1.8 m",
       REACH},
      {"\nwall n -9 1 to 9 1 m\nwall e 1.8 -9 to 1.8 9 o\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1 to 9 -1 m",
       "walls of one stiffness"},
      {"\nwall n -9 1 to 9 1 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m",
       "one disc between four walls, with `step F of single-contact`"},
      {"\ndisc 9 9 radius 1 m\n" FOUR("1", "1.8", "-1.8", "-1"),
       "one disc between four walls, with `step F of single-contact`"});
  /* For h = 1.1 x_n is 0.01 times 1, -1.42, 3.03, -7.19 and 17.4, since x_(n+1) = 2 x_n - x_(n-1) - 4 h^2 x_n. */
  PARTS("fracc",
        "material m density 1 kn 20\nstep (1.1/sqrt(2)) of single-contact\nallow unstable\n"
        "disc 0.01 0 radius 2 m\n@\nstage s\ncycles 3\n",
        {FOUR("1", "1.927", "-1.927", "-1"), NULL}, {FOUR("1", "1.929", "-1.929", "-1"), REACH});
#undef REACH
}

/* Two discs of mass 5 and k = 20, so the step is 0.01, in which the first disc moves by 0.03. It crosses the gap of 0.1
 * in the fourth step. */
static void fracc_touch(void) {
  const double overlap = 0.02, force = 20 * overlap, growth = 20 * (3 - 2 * force * 0.01 / 5) * 0.01;
#define STRIKE "material m density (5/(4*pi)) kn 20\ndisc 3 2 radius 2 m velocity 3 0\ndisc @ 2 radius 2 m\n"
  VALUES("fracc_touch",
         "material m density (5/(4*pi)) kn 20\ndisc 3 2 radius 2 m velocity 3 0\ndisc 7.1 2 radius 2 m\n"
         "step 0.01 of single-contact\nstage s\ncycles 2\nstage t\ncycles 3\n",
         0, {"step.fracc max", sqrt(growth / force) / 2});
#define TOUCH "discs that touch in the run, and not before it"
#define EQUAL                                                                                                          \
  "two equal discs, the first of which strikes the second head-on along x, and for `step F of single-contact`"
#define SHARE "step 0.01 of single-contact\nstage s\ncycles "
  PARTS("fracc_touch", STRIKE SHARE "5\n", {"7.1", NULL}, {"7", NULL}, {"6.99", TOUCH}, {"-1.1", TOUCH}, {"7.11", NULL},
        {"7.13", TOUCH});
  PARTS("fracc_touch",
        "material m density (5/(4*pi)) kn 20\ndisc 3 2 radius 2 m velocity 3 0\ndisc 7.1 2 radius 2 m\n@",
        {SHARE "4\n", TOUCH}, {"step 0.01\nstage s\ncycles 50\n", EQUAL});
  PARTS("fracc_touch",
        "material m density (5/(4*pi)) kn 20\ndisc 3 2 radius 2 m velocity 3 0\ndisc 7.1 2 radius 2 m@\n" SHARE "5\n",
        {"", NULL}, {" velocity 0 0.01", EQUAL}, {" velocity 0 -0.01", EQUAL});
  PARTS("fracc_touch", STRIKE "disc 99 9 radius 2 m\n" SHARE "5\n", {"7.1", EQUAL});
#undef TOUCH
#undef EQUAL
#undef SHARE
#undef STRIKE
}

/* The first disc moves by 1/32 in each step; it touches at first, or crosses a gap just below 3/32 in three steps. */
static void fracc_touch_in_few_steps(void) {
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

/* Two particles that do not touch, from rest in x_(N+1) = x_N + u_(N+1) dt with u <- K u + e x [R89 4.43]. */
static double accumulated(double from, double e, double keep, int cycles) {
  double x = from, u = 0;
  for (int n = 0; n < cycles; n++)
    u = keep * u + e * x, x += u;
  return x;
}
static void carried_with(const char *damping, double keep) {
  static const double e[][2] = {{0.01, -0.02}, {-0.5, 0.03}, {0, 0.01}, {-0.25, 0.02}};
  for (int k = 0; k < 4; k++) {
    const double ex = e[k][0], ey = e[k][1], fx = 3 * pow(1.004, 7), fy = -2 * pow(1 - 0.001, 7);
    char page[1024];
    snprintf(page, sizeof page,
             "material a density 1 kn 9\nnormal linear\ndamping %s\ndisc 90 70 radius 1 a\ndisc 3 -2 radius 0.5 a\n"
             "monitor D disc 2\nregion R all\nstep 0.1\nstage s\naffine strain 0.004 per cycle -0.001 per cycle\n"
             "cycles 7\nstage t\naffine strain %.17g per cycle %.17g per cycle accumulated\ncycles 9\n",
             damping, ex, ey);
    VALUES("carried", page, 1, {"D.x", 3, "cycle", 0}, {"D.x", 3 * pow(1.004, 3), "cycle", 3}, {"D.x", fx, "cycle", 7},
           {"D.x", accumulated(fx, ex, keep, 1), "cycle", 8}, {"D.x", accumulated(fx, ex, keep, 9), "cycle", 16},
           {"D.y", -2 * pow(1 - 0.001, 3), "cycle", 3}, {"D.y", accumulated(fy, ey, keep, 5), "cycle", 12});
  }
}
#define APART "material a density 1 kn 9\nnormal linear\ndisc 9 9 radius 1 a\ndisc @\nmonitor D disc 1\nstep 0.1\n"
static void carried(void) {
  carried_with("none", 1);
  carried_with("con1 0.6 as cs79", 0.6 / 1.4);
  carried_with("con1 0.6 as velocity", 0.6);
  carried_with("con1 0.25 as velocity", 0.25); /* a double root for e = -0.25 */
  carried_with("con1 0.7 as all", 0.7);
  VALUES("carried",
         "material a density 1 kn 9\nnormal linear\ndisc 3 -2 radius 0.5 a\nmonitor D disc 1\nstep 0.1\nstage s\n"
         "affine strain 0.004 per cycle -0.001 per cycle\ncycles 7\nstage t\naffine strain 0.02 per cycle -0.03 per "
         "cycle\n"
         "cycles 7\n",
         0, {"D.x", 3 * pow(1.004, 7) * pow(1.02, 5), "cycle", 12},
         {"D.y", -2 * pow(1 - 0.001, 7) * pow(1 - 0.03, 5), "cycle", 12});
  VALUES("carried",
         "material a density 1 kn 9\nnormal linear\ndisc 3 -2 radius 0.5 a\nmonitor D disc 1\nstep 0.1\nstage s\n"
         "affine strain 0.004 per cycle -0.001 per cycle\ncycles 7\n",
         0, {"D.x", 3 * pow(1.004, 5), "cycle", 5}, {"D.y", -2 * pow(1 - 0.001, 5), "cycle", 5});
#define TOUCH "particles that never touch"
#define AXES                                                                                                           \
  "an `affine strain` per cycle along the axes in one stage or two, with `accumulated` in the last stage only"
  PARTS("carried", APART "stage s\naffine strain -0.1 per cycle 0 per cycle\ncycles 2\n", {"6.5 9 radius 1 a", NULL},
        {"6.54 9 radius 1 a", TOUCH}, {"9 7 radius 1 a", TOUCH}, {"9 6.9 radius 1 a", NULL},
        {"9 6.9 radius 1.1 a", TOUCH}, {"10.05 9 radius 0.1 a", TOUCH}, {"11.46 9 radius 1 a", TOUCH},
        {"90 9 radius 1 a\ndisc 88.4 9 radius 1 a", TOUCH});
  PARTS("carried",
        APART "stage s\naffine strain -0.1 per cycle 0.1 per cycle\ncycles 1\nstage t\n"
              "affine strain -0.5 per cycle 0 per cycle accumulated\ncycles 3\n",
        {"3 9 radius 1 a", TOUCH}, {"3 12 radius 1 a", NULL});
  /* The distances are 3, 2.7, 2.43, 2.187 and 1.9683: the discs touch in the fourth cycle. */
  PARTS("carried",
        "material a density 1 kn 9\nnormal linear\ndisc 9 9 radius 1 a\ndisc 12 9 radius 1 a\nmonitor D disc 1\nstep "
        "0.1\n"
        "stage s\naffine strain -0.1 per cycle 0 per cycle\ncycles 2\nstage t\n"
        "affine strain -0.1 per cycle 0 per cycle\n@\n",
        {"cycles 1", NULL}, {"cycles 2", TOUCH});
  PARTS("carried",
        "material a density 1 kn 9\nnormal linear\ndisc 9 9 radius 1 a\nmonitor D disc 1\nstep 0.1\nstage s\n@",
        {"affine strain 0.1 0\ncycles 1\n", AXES},
        {"affine strain 0.1 per cycle 0 per cycle c12 0.1 per cycle\ncycles 1\n", AXES},
        {"affine strain 0.1 per cycle 0 per cycle c21 0.1 per cycle\ncycles 1\n", AXES},
        {"affine strain 0.1 per cycle 0 per cycle\ncycles 1\nstage t\ncycles 1\n", AXES});
#undef TOUCH
#undef AXES
}

/* Four discs of radius 2 in the direction (3, 4)/5, with the overlap 0.1, so the force is 20 and the walls are 15.4 apart.
 * The walls do not stand at the ends of the page's order. */
#define ROW_OF(disc4, walls)                                                                                           \
  "material m density 1 kn 200\nmaterial o density 1 kn 201\nnormal linear\n"                                          \
  "disc 1 2 radius 2 m\ndisc (1 + 2.34) (2 + 3.12) radius 2 m\ndisc (1 + 4.68) (2 + 6.24) radius 2 m\n" disc4          \
  "\n" walls "region C circle 1 2 radius 40\nregion L box 0 -2 to 12 16\nregion R box -3 -2 to 12 16\n"                \
  "region Q box -3 -2 to 9 16\nregion P box 0.5 -2 to 12 16\nregion B box -3 0.6 to 12 16\nregion T box -3 -2 to 12 "  \
  "12\n"                                                                                                               \
  "monitor D disc 1\nstep 0.01\nrecord R.stress.xx\nstage s\ncycles 1\n"
#define DISC4 "disc (1 + 7.02) (2 + 9.36) radius 2 m"
/* A wall at the distance d from the first disc along the row, and its direction. */
#define ACROSS(name, d, ex, ey, of)                                                                                    \
  "wall " name " (1 + " d "*0.6 - 9*(" ex ")) (2 + " d "*0.8 - 9*(" ey ")) to (1 + " d "*0.6 + 9*(" ex ")) (2 + " d    \
  "*0.8 + 9*(" ey ")) " of "\n"
static void force_chain(void) {
  const double s = 20 * 15.5 / (15 * 18), angle = atan2(4, 3);
  static const double u[] = {0.36, 0.48, 0.64};
#define TENSOR(of)                                                                                                     \
  {"R." of "xx at 0 cycles", s * u[0]}, {"R." of "xy at 0 cycles", s * u[1]}, {"R." of "yy at 0 cycles", s * u[2]},    \
      {"R." of "mean at 0 cycles", s / 2}, {"R." of "angle at 0 cycles", angle}
  VALUES("force_chain",
         ROW_OF(DISC4, ACROSS("top", "13.6", "0.8", "-0.6", "m") ACROSS("low", "-1.9", "0.8", "-0.6", "m")), 1,
         TENSOR("stress."), TENSOR("stress.contacts."), TENSOR("stress.fabric."), {"R.stress.sinphi at 0 cycles", 1},
         {"R.stress.fabric.fraction at 0 cycles", 1}, {"R.stress.variation.fraction at 0 cycles", 0},
         {"R.stress.shear.fraction at 0 cycles", 0}, {"R.fabric.xx at 0 cycles", 0.36},
         {"R.fabric.xy at 0 cycles", 0.48}, {"R.fabric.yy at 0 cycles", 0.64}, {"R.fabric.anisotropy at 0 cycles", 1},
         {"R.fabric.fourth.xxxx at 0 cycles", 0.1296}, {"R.coordination at 0 cycles", 2}, {"R.contacts at 0 cycles", 5},
         {"R.normal.mean at 0 cycles", 20});
#undef TENSOR
#define ENDS                                                                                                           \
  "walls normal to the row, one at each end, that overlap its end discs as much as the discs overlap each other, and " \
  "are as stiff"
#define EQUAL "equal discs at equal distances on a straight line"
#define LOW(d) ACROSS("low", d, "0.8", "-0.6", "m")
#define TOP(d) ACROSS("top", d, "0.8", "-0.6", "m")
  PARTS(
      "force_chain", ROW_OF(DISC4, "@"), {LOW("-1.9") TOP("13.6"), NULL}, {TOP("-1.9") LOW("13.6"), NULL},
      {LOW("-1.9") ACROSS("top", "13.6", "-0.8", "0.6", "m"), NULL}, {LOW("-1.9") TOP("-1.9"), ENDS},
      {LOW("13.6") TOP("13.6"), ENDS}, {LOW("-1.9") TOP("(13.6 + 2e-10)"), ENDS},
      {LOW("-1.9") TOP("(13.6 - 2e-10)"), ENDS}, {LOW("(-1.9 + 2e-10)") TOP("13.6"), ENDS},
      {LOW("(-1.9 - 2e-10)") TOP("13.6"), ENDS}, {LOW("(-1.9 + 5e-11)") TOP("(13.6 - 5e-11)"), NULL},
      {LOW("-1.9") ACROSS("top", "13.6", "0.8", "-0.6", "o"), ENDS},
      {ACROSS("low", "-1.9", "0.8", "-0.6", "o") TOP("13.6"), ENDS},
      {ACROSS("low", "-1.9", "0.8", "(-0.6 + 1e-10)", "m") TOP("13.6"), ENDS},
      {LOW("-1.9") "wall top (1 + 13.6*0.6) (2 + 13.6*0.8) to (1 + 13.6*0.6 + 8) (2 + 13.6*0.8 - 6) m\n", ENDS},
      {LOW("-1.9") "wall top (1 + 13.6*0.6 - 0.8) (2 + 13.6*0.8 + 0.6) to (1 + 13.6*0.6 + 8) (2 + 13.6*0.8 - 6) m\n",
       NULL},
      {LOW("-1.9") "wall top (1 + 13.6*0.6 - 8) (2 + 13.6*0.8 + 6) to (1 + 13.6*0.6 - 4) (2 + 13.6*0.8 + 3) m\n", ENDS},
      {LOW("-1.9"), "a row of discs between two walls"});
  PARTS("force_chain", ROW_OF("@", ACROSS("low", "-1.9", "0.8", "-0.6", "m") ACROSS("top", "13.6", "0.8", "-0.6", "m")),
        {"disc (1 + 7.02) (2 + 9.36 + 1e-6) radius 2 m", EQUAL}, {"disc (1 + 7.02) (2 + 9.36) radius 2.1 m", EQUAL},
        {"disc (1 + 7.02) (2 + 9.36) radius 2 o", EQUAL});
  PARTS("force_chain",
        "material m density 1 kn 200\nnormal linear\ndisc 1 2 radius 2 m\ndisc @ 2 radius 2 m\nwall a -1 -9 to -1 9 m\n"
        "wall b 7 -9 to 7 9 m\nstep 0.01\nstage s\ncycles 1\n",
        {"5", ENDS});
  /* The direction of the row, from the first disc of the page to the last, has no effect on the angle. */
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "force_chain",
                             "material m density 1 kn 200\nnormal linear\ndisc (1 + 2.34) (2 + 3.12) radius 2 m\n"
                             "disc 1 2 radius 2 m\n" LOW("-1.9") TOP("5.8") "region R box -9 -9 to 16 16\nstep 0.01\n"
                                                                            "record R.stress.xx\nstage s\ncycles 1\n",
                             &error),
                  NB_OK);
  REFS_NEAR(refs_value(&solution, "R.stress.angle at 0 cycles"), angle, 1e-12, angle);
  solution_free(&solution);
#undef LOW
#undef TOP
#undef ENDS
#undef EQUAL
}

/* A sphere of the stiffnesses k_n = 15 and k_s = 6, E* = 8/3 and G* with overlap 0.01 at a wall, which moves past it. */
#define SLIDES(density, friction, wall, stages)                                                                        \
  "material g density " density " young 4 poisson 0.25 kn 30 ks 12 friction " friction "\n"                            \
  "material w kn 10 ks 4 young 4 poisson 0.25 friction 0.9\nnormal linear\nshear linear\nsphere 5 6.99 radius 2 g\n"   \
  "wall f " wall " w velocity 0.01 0\nmonitor C sphere 1 with wall f\nmonitor D sphere 1\nstep 0.1\n" stages
static void changed_law(void) {
  /* Two lines precede the text: the fence and the units. */
  static const char laws[] = "material g density 1 young 4 poisson 0.25\nnormal hertz\nshear mindlin_scaled\n"
                             "sphere 5 6.99 radius 2 g\nwall f 0 5 to 9 5 g\nstep 0.1\nstage s\ncycles 1\n";
  refs_check_error(
      "changed_law", laws,
      "the reference `changed_law` does not cover `shear mindlin_scaled` (line 5); it covers `shear none`, "
      "`shear linear`, `shear mindlin`, `shear mindlin_deresiewicz`");
  refs_check_error("force_chain", laws,
                   "the reference `force_chain` does not cover `sphere` (line 6), `normal hertz` (line 4), `shear "
                   "mindlin_scaled` (line 5); it covers `normal linear`, `shear none`, `disc`, `wall`");
  const double kn = 15, overlap = 0.01, end = 1.8, least = kn * overlap * end * end / 2 / (1e-13 * overlap);
  char page[1024];
  CU_ASSERT(kn > 4. / 3 * (2 / 0.9375) * sqrt(2 * overlap)); /* the linear spring is the stiffer one */
  for (int k = 0; k < 2; k++) {
    snprintf(page, sizeof page, SLIDES("%.17g", "0.8", "-9 5 to 9 5", "stage s\ncycles 10\nstage t\ncycles 8\n"),
             least / (32 * pi / 3) * (k ? 1.0001 : 0.9999));
    refs_check_message("changed_law", page, k ? NULL : "a sphere so heavy that its contact does not move it");
  }
  /* Hertz's contact is stiffer than a linear spring of 0.1. */
  const double secant = 4. / 3 * (2 / 0.9375) * sqrt(2 * overlap);
  CU_ASSERT(secant > 0.1);
  for (int k = 0; k < 2; k++) {
    snprintf(page, sizeof page,
             SLIDES("%.17g", "0.8", "-9 5 to 9 5", "pair g w kn 0.1\nstage s\nshear none\ncycles 18\n"),
             secant * end * end / 2 / 1e-13 / (32 * pi / 3) * (k ? 1.0001 : 0.9999));
    refs_check_message("changed_law", page, k ? NULL : "a sphere so heavy that its contact does not move it");
  }
  /* The laws of a stage apply up to its end, t = 1, included: linear springs, without sliding.
   * The normal e = (0, -1) from the sphere to the wall gives t = (-1, 0), and the sphere moves along t by 0.01 t. */
  const double hertz = 4. / 3 * (2 / 0.9375) * sqrt(2) * pow(overlap, 1.5);
  VALUES("changed_law",
         SLIDES("1e30", "0.8", "-9 5 to 9 5", "stage s\ncycles 10\nstage t\nnormal hertz\nshear none\ncycles 8\n"), 0,
         {"C.normal", kn * overlap, "time", 0.9}, {"C.normal", kn * overlap, "time", 1},
         {"C.normal", hertz, "time", 1.1}, {"C.shear", 6 * 0.01 * 1, "time", 1}, {"C.shear", 0, "time", 1.1});
}
#undef SLIDES

/* A heavy sphere of radius 2 at (5, 6.99), pressed by 0.01 against a wall below it, at y = 5, or above it, at y = 8.98.
 * k_n = 15, k_s = 6, E* = 2/0.9375, G* = 1.6/3.5 and the friction is 0.8. */
#define SLIDES(wall, speed, stages) BEGINS("normal linear\nshear linear", wall, speed, stages)
#define BEGINS(laws, wall, speed, stages)                                                                              \
  "material g density 1e30 young 4 poisson 0.25 kn 30 ks 12 friction 0.8\n"                                            \
  "material w kn 10 ks 4 young 4 poisson 0.25 friction 0.9\n" laws "\nsphere 5 6.99 radius 2 g\nwall f " wall          \
  " w velocity " speed " 0\nmonitor D sphere 1\nmonitor C sphere 1 with wall f\nstep 0.1\n" stages
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
static void changed_law_of_a_heavy_sphere(void) {
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
        {WIDE("0.01", "stage s\ncycles 1\nstage t\nnormal hertz_increment\nshear none\ncycles 1\n"), NULL},
        {SLIDES("-9 4.98 to 9 4.98", "0.01", "stage s\nshear none\ncycles 1\n"), STICKS});
  for (int n = 32; n < 34; n++) {
    char page[4096] = WIDE("0.01", "");
    for (int k = 0; k < n; k++)
      snprintf(page + strlen(page), sizeof page - strlen(page), "stage s%d\nshear none\ncycles 1\n", k);
    refs_check_message("changed_law", page, n == 32 ? NULL : STICKS);
  }
  /* The wall is below and moves to -x: the sphere moves along t = (-1, 0) by -0.002 t, relative to it. */
  const double v = 0.002, overlap = 0.01, ka = 8 * 1.6 / 3.5 * sqrt(2 * overlap);
  const double hertz = 4. / 3 * 2 / 0.9375 * sqrt(2) * pow(overlap, 1.5), most = 1.5 * 0.8 * hertz / ka;
  VALUES("changed_law",
         WIDE("-0.002",
              "stage a\ncycles 1\nstage b\nnormal hertz\ncycles 1\nstage m\nstep 0.2\nshear mindlin\n"
              "cycles 5\nstage e\nstep 0.1\nshear mindlin_deresiewicz\ncycles 10\nstage r\nstep 0.05\nshear "
              "mindlin_deresiewicz\ncycles 6\nstage p\nshear mindlin_deresiewicz memory 6\ncycles 8\nstage o\n"
              "shear mindlin_deresiewicz memory 6\ncycles 2\nstage q\nshear mindlin_deresiewicz\ncycles 4\nstage i\n"
              "normal hertz_increment\nshear none\ncycles 5\n"),
         0, {"C.normal", 15 * overlap, "time", 0.1}, {"C.normal", hertz, "time", 0.2}, {"C.normal", hertz, "time", 3.2},
         {"C.normal", 0, "time", 3.25}, {"C.shear", -6 * v * 0.1, "time", 0.1}, {"C.shear", -6 * v * 0.2, "time", 0.2},
         {"C.shear", -ka * v * 0.2, "time", 0.4}, {"C.shear", -ka * v * 1, "time", 1.2},
         {"C.shear", -ka * springs(v * 0.1, v * 0.1, most), "time", 1.3},
         {"C.shear", -ka * springs(v * 1, v * 0.1, most), "time", 2.2},
         {"C.shear", -ka * springs(v * 1.3, v * 0.1, most), "time", 2.5},
         {"C.shear", -ka * springs(v * 0.05, v * 0.05, most), "time", 2.55},
         {"C.shear", -ka * springs(v * 0.4, v * 0.05, most), "time", 2.9},
         {"C.shear", -ka * springs(v * 0.5, v * 0.05, most), "time", 3},
         {"C.shear", -ka * springs(v * 0.2, v * 0.05, most), "time", 3.2}, {"C.shear", 0, "time", 3.25});
  /* The first step is that of the first stage. */
  VALUES("changed_law",
         BEGINS("normal hertz\nshear mindlin_deresiewicz", "-9 5 to 9 5", "-0.002",
                "stage a\nstep 0.3\ncycles 2\nstage b\nstep 0.1\ncycles 3\n"),
         0, {"C.normal", hertz, "time", 0.3}, {"C.shear", -ka * springs(v * 0.3, v * 0.3, most), "time", 0.3},
         {"C.shear", -ka * springs(v * 0.9, v * 0.3, most), "time", 0.9});
#undef MOVES
#undef WIDE
}

/* A zigzag of five discs at 20 degrees to y; the first and the last are fixed. A fourth free disc touches nothing. */
static void zigzag(void) {
  const double phi = pi / 9;
  char page[2048] = "material m density 1 kn 10\nnormal linear\nstep 0.001\nregion A all\nwall w -1 -9 to -1 9 m\n"
                    "disc 40 0 radius 1 m\n";
  for (int k = 0; k < 5; k++)
    snprintf(page + strlen(page), sizeof page - strlen(page), "disc %.17g %.17g radius 1 m%s\n",
             k % 2 ? 1.99 * sin(phi) : 0, 1.99 * k * cos(phi), k % 4 ? "" : " fixed");
  strcat(page, "monitor D disc 2\nstage s\ncycles 1\n");
  char without[sizeof page + 32];
  const char *const region = strstr(page, "region A all\n"), *const after = region + strlen("region A all\n");
  snprintf(without, sizeof without, "%.*s%s", (int)(region - page), page, after);
  refs_check_message("zigzag", without,
                     "a region and three or more free discs whose contacts all make the same angle with y");
  snprintf(without, sizeof without, "%.*sregion A all\nregion B box -5 -5 to 5 5\n%s", (int)(region - page), page,
           after);
  VALUES("zigzag", without, 1, {"A.chains", 1}, {"A.chains.length", 3}, {"A.chains.fraction", 0.75},
         {"A.chains.bend", 2 * phi}); /* a region that is not the whole assembly has no values */
  char steep[2048];
  strcpy(steep, "material m density 1 kn 10\nnormal linear\nstep 0.001\nregion A all\nwall w -1 -9 to -1 9 m\n");
  for (int k = 0; k < 5; k++)
    snprintf(steep + strlen(steep), sizeof steep - strlen(steep), "disc %.17g %.17g radius 1 m%s\n",
             k % 2 ? 1.99 * sin(pi / 3.6) : 0, 1.99 * k * cos(pi / 3.6), k % 4 ? "" : " fixed");
  strcat(steep, "stage s\ncycles 1\n");
  refs_check_message("zigzag", steep, "contacts at less than 45 degrees to y; here they are at 50");
}

/* A packing of three discs, and records of their state, which need not agree with it: the reference reads the numbers as
 * they are. The files end in no extension, and `.state`. Another particle is refused, and a packing without a state. */
static void packing(void) {
  char folder[] = "/tmp/nineball.packing-XXXXXX", list[64], state[64], page[1024];
  CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(folder));
  snprintf(list, sizeof list, "%s/three", folder), snprintf(state, sizeof state, "%s/three.state", folder);
  written_text(list, "x/-\ty/-\tradius/-\n0\t0\t1\n1.5\t0\t1\n9\t0\t2\n");
  written_text(state, "body 2 disc m free 0x1p+0 1.25 -0x1p-1 3 4 5 6\nbody 3 disc m free 2 9.5 0.25 3 4 5 6\n"
                      "contact 1 body 3 heard 9 8 0.5 0.6 0.7 0.8\nfields memory normals normal ex\n"
                      "contact 1 body 2 heard 9 8 0.1 0.2 0.3 0.4\ncontact 2 body 3 heard 9 8 0.5 0.6 0.9 0.8\n"
                      "contact 2 wall f heard 9 8 1.1 1.2 1.3 1.4\n");
#define READS                                                                                                          \
  "material m density 1 kn 1\nnormal linear\nwall f -9 -1 to 9 -1 m\npacking %s discs m\n%smonitor D disc 2\n"         \
  "monitor E disc 3\nmonitor C disc 2 with disc 1\nmonitor G disc 2 with disc 3\nmonitor W disc 2 with wall f\n"       \
  "monitor X disc 1 with wall f\nmonitor Y disc 1 with disc 3\nstep 0.1\nstage s\ncycles 1\n"
  char again[128];
  snprintf(again, sizeof again, "packing %s discs m\n", list);
  const char *const more[] = {"", "disc 30 9 radius 1 m\n", again};
  for (int k = 0; k < 3; k++) {
    snprintf(page, sizeof page, READS, list, more[k]);
    refs_check_message("packing", page, k ? "one `packing`, and no other particles" : NULL);
  }
  refs_check_message("packing",
                     "material m density 1 kn 1\nnormal linear\ndisc 0 0 radius 1 m\nstep 0.1\nstage s\ncycles 1\n",
                     "one `packing`, and no other particles");
  snprintf(page, sizeof page, READS, list, "");
  VALUES("packing", page, 0, {"D.x at 0 cycles", 1.25}, {"D.y at 0 cycles", -0.5}, {"E.x at 0 cycles", 9.5},
         {"E.y at 0 cycles", 0.25}, {"C.normal at 0 cycles", 0.3}, {"C.shear at 0 cycles", 0},
         {"G.normal at 0 cycles", 0.9}, {"G.shear at 0 cycles", 0}, {"W.normal at 0 cycles", 1.3},
         {"W.shear at 0 cycles", 0}, {"contacts at 0 cycles", 3});
#undef READS
  remove(state);
  struct nb_solution solution;
  struct nb_error error = {0};
  char text[256];
  CU_ASSERT_EQUAL(refs_solve(&solution, "packing", page, &error), NB_BAD_USE);
  snprintf(text, sizeof text,
           "the reference `packing` needs the state that belongs to %s: a file of the same name that ends in .state",
           list);
  CU_ASSERT_STRING_EQUAL(error.text, text);
  solution_free(&solution);
  remove(list), rmdir(folder);
}

/* Two of three spheres collide; the third one only contributes to the mean radius, which is 2. The cycle with absolute
 * positions needs `cycles` cycles until they have separated. */
#define COLLIDE                                                                                                        \
  "material g density 3 young 5000 poisson 0.2\nnormal hertz\nsphere %s 7 radius 1.5 g velocity 0.1 0\nsphere 4 7 "    \
  "radius "                                                                                                            \
  "0.5 g velocity -0.05 0\nsphere 40 7 radius 4 g\nmonitor A sphere 1\nmonitor B sphere 2\nmonitor F sphere 3\n"       \
  "monitor C sphere 1 with sphere 2\nstep 0.4 of rayleigh-fit-mean\nstage s\ncycles 5\nstage t\ncycles %lu\n"
static void rayleigh_cycle(void) {
  const double m[2] = {4 * pi * pow(1.5, 3), 4 * pi * pow(0.5, 3)};
  const double dt = 0.4 * pi * 2 * sqrt(3 / (5000 / 2.4)) / (0.1631 * 0.2 + 0.876605);
  const double k = 4. / 3 * 5000 / (2 * 0.96) * sqrt(1.5 * 0.5 / 2);
  double x[2] = {1.9, 4}, v[2] = {0.1, -0.05};
  unsigned long cycles = 0;
  for (; x[1] - x[0] < 2 || v[1] < v[0]; cycles++) {
    const double force = k * pow(fmax(2 - (x[1] - x[0]), 0), 1.5);
    v[0] -= force / m[0] * dt, v[1] += force / m[1] * dt;
    x[0] += v[0] * dt, x[1] += v[1] * dt;
  }
  CU_ASSERT_FATAL(cycles > 6);
  char page[1024], text[128];
  snprintf(page, sizeof page, COLLIDE, "1.9", cycles - 5);
  VALUES("rayleigh_cycle", page, 1, {"A.vx", v[0]}, {"B.vx", v[1]});
  snprintf(page, sizeof page, COLLIDE, "1.9", cycles - 6);
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "rayleigh_cycle", page, &error), NB_BAD_USE);
  snprintf(text, sizeof text, "the particles have not collided and separated within the %lu cycles of the scene",
           cycles - 1);
  CU_ASSERT_STRING_EQUAL(error.text, text);
  solution_free(&solution);
  for (int apart = 0; apart < 2; apart++) {
    snprintf(page, sizeof page, COLLIDE, apart ? "1.99" : "2.01", 900ul);
    refs_check_message("rayleigh_cycle", page,
                       apart ? NULL
                             : "two particles of one material that collide along x, and `step F of rayleigh-fit-mean`");
  }
}

/* A small sphere between two that are fixed and approach along x: each other velocity is refused. */
static void pinched(void) {
#define GLASS "material g density 1 young 1 poisson 0\nnormal hertz\n"
#define PINCHED                                                                                                        \
  "spheres of one material: two equal fixed ones that approach each other along x, and a third one at rest between "   \
  "them, above the line of their centres"
  PARTS("pinched",
        GLASS "sphere -3 0 radius 2 g velocity 0.1 @ fixed\nsphere 3 0 radius 2 g velocity -0.1 0 fixed\nsphere 0 0.5 "
              "radius 1 g\nstep 0.01\nstage s\ncycles 1\n",
        {"0", NULL}, {"0.01", PINCHED});
  PARTS("pinched",
        GLASS "sphere -3 0 radius 2 g velocity 0.1 0 fixed\nsphere 3 0 radius 2 g velocity -0.1 @ fixed\nsphere 0 0.5 "
              "radius 1 g\nstep 0.01\nstage s\ncycles 1\n",
        {"0", NULL}, {"0.01", PINCHED});
#undef GLASS
#undef PINCHED
}

/* A network of one or two discs of mass 5, R = 2: the limits of its single degree of freedom without coupling, where
 * dt^2 K/m + 2 dt C/m = 2 (1 + keep)/gain. `step max` is found by bisection. */
static double step_of_limit(double k, double c, double m, double right) {
  return (sqrt(c * c + k * m * right) - c) / k;
}
static void limits(const char *page, double single, double stable, double longest) {
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "step_limit", page, &error), NB_OK);
  const char *const names[] = {"step.single-contact", "step.stable", "step max"};
  const double expected[] = {single, stable, longest};
  for (int k = 0; k < 3; k++) {
    const double *value = solution_find(&solution, names[k]);
    const bool right = value && fabs(*value - expected[k]) <= (k < 2 ? 1e-12 : 2e-6) * expected[k];
    if (!right)
      printf("# %s is %.17g, expected %.17g: %s\n", names[k], value ? *value : NAN, expected[k], page);
    CU_ASSERT(right);
  }
  CU_ASSERT_EQUAL(solution.value_count, 3);
  solution_free(&solution);
}
#define HELD(shear, damping, particles)                                                                                \
  "material m density (5/(4*pi)) kn 20 ks 20 friction 1\nmaterial a kn 60 ks 180 friction 1\nmaterial b kn 6 ks 3 "    \
  "friction 1\nnormal linear\nshear " shear "\n" damping particles "step 0.01\nstage s\ncycles 1\n"
#define CORNER "disc 1 2 radius 2 m\nwall a -1 -9 to -1 9 a\nwall b -9 0 to 9 0 b\n"
#define GRIPPED "disc 1 2 radius 2 m\nwall a -1 -9 to -1 9 a\nwall b 3 -9 to 3 9 b\n"
#define PAIRED "disc 1 2 radius 2 m\ndisc 1 5 radius 1 m\ndisc 90 0 radius 9 m fixed\n"
/* A dashpot of k_n times 1e308 is infinite: no step is stable. */
static void no_stable_step(void) {
  nb_references_prepare();
  refs_check_error("step_limit",
                   "material m density 1 kn 9\nnormal linear\ndamping stiffness 1e308\ndisc 0 0 radius 1 m\n"
                   "disc 1.9 0 radius 1 m\nstep 0.1\nallow unstable\nstage s\ncycles 1\n",
                   "the reference `step_limit` finds no step at which these springs and dashpots are stable");
}

static void step_limit(void) {
  const double m = 5, ka = 30, kb = 120. / 13, single = 2 * sqrt(m / ka), both = 2 * sqrt(m / (ka + kb));
  limits(HELD("none", "", CORNER), single, both, single);
  limits(HELD("none", "", GRIPPED), single, both, both);
  const double k = ka + kb, ca = 2 * 0.3 * sqrt(m * ka), cb = 2 * 0.3 * sqrt(m * kb);
  limits(HELD("none", "damping ratio 0.3\n", GRIPPED), single, step_of_limit(k, ca + cb, m, 4),
         step_of_limit(k, ca + cb, m, 4));
  limits(HELD("none", "damping ratio 0.3\n", CORNER), single, step_of_limit(k, ca + cb, m, 4),
         fmin(step_of_limit(ka, ca, m, 4), step_of_limit(kb, cb, m, 4)));
  limits(HELD("none", "damping stiffness 0.2\n", GRIPPED), single, step_of_limit(k, 0.2 * k, m, 4),
         step_of_limit(k, 0.2 * k, m, 4));
  limits(HELD("none", "damping r89-fraction 0.2\n", GRIPPED), single, step_of_limit(k, 0.1 * k * single, m, 4),
         step_of_limit(k, 0.1 * k * single, m, 4));
  limits(HELD("none", "damping ratio 0.9\ndamping walls stiffness 0.2\n", GRIPPED), single,
         step_of_limit(k, 0.2 * k, m, 4), step_of_limit(k, 0.2 * k, m, 4));
  limits(HELD("none", "damping mass 3\n", GRIPPED), single, both, both);
  limits(HELD("none", "damping con1 0.8 as cs79\n", GRIPPED), single, both, both);
  limits(HELD("none", "damping con1 0.8 as velocity\n", GRIPPED), single, step_of_limit(k, 0, m, 3.6),
         step_of_limit(k, 0, m, 3.6));
  limits(HELD("none", "damping con1 0.8 as all\n", GRIPPED), single, step_of_limit(k, 0, m, 4.5),
         step_of_limit(k, 0, m, 4.5));
  limits(HELD("none", "damping con1 0.8 as all\ndamping ratio 0.3\n", GRIPPED), single,
         step_of_limit(k, ca + cb, m, 4.5), step_of_limit(k, ca + cb, m, 4.5));
  /* Two discs of the masses 5 and 5/4, k = 20: the reduced mass is 1. k_s = 20 acts on 1/m_1 + 1/m_2 plus twice as much
   * for the rotation of discs. One of them alone on a fixed disc has its own mass. */
  const double lightest = 2 * sqrt(1.25 / 20);
  limits(HELD("none", "", PAIRED), lightest, 2 * sqrt(1. / 20), 2 * sqrt(1. / 20));
  limits(HELD("none", "damping ratio 0.3\n", PAIRED), lightest, step_of_limit(20, 0.6 * sqrt(20), 1, 4),
         step_of_limit(20, 0.6 * sqrt(20), 1, 4));
  limits(HELD("linear", "", PAIRED), lightest, 2 * sqrt(1. / 60), 2 * sqrt(1. / 60));
  limits(HELD("linear", "damping ratio 0.3\n", PAIRED), lightest, step_of_limit(60, 3 * 0.6 * sqrt(20), 1, 4),
         step_of_limit(60, 3 * 0.6 * sqrt(20), 1, 4));
  limits(HELD("none", "", "disc 1 2 radius 2 m fixed\ndisc 1 5 radius 1 m\n"), lightest, lightest, lightest);
  limits(HELD("none", "damping ratio 0.3\n", "disc 1 2 radius 2 m\ndisc 1 5 radius 1 m fixed\n"), 1,
         step_of_limit(20, 0.6 * sqrt(5 * 20), 5, 4), step_of_limit(20, 0.6 * sqrt(5 * 20), 5, 4));
  limits(HELD("none", "damping ratio 0.3\n", "disc 1 2 radius 2 m fixed\ndisc 1 5 radius 1 m\n"), lightest,
         step_of_limit(20, 0.6 * sqrt(1.25 * 20), 1.25, 4), step_of_limit(20, 0.6 * sqrt(1.25 * 20), 1.25, 4));
  for (int far = 0; far < 2; far++) { /* a gap of 1e-9 of the first radius is a contact */
    struct nb_solution solution;
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(refs_solve(&solution, "step_limit",
                               far ? HELD("none", "", "disc 1 2 radius 2 m\ndisc 1 (5 + 2.1e-9) radius 1 m\n")
                                   : HELD("none", "", "disc 1 2 radius 2 m\ndisc 1 (5 + 1.9e-9) radius 1 m\n"),
                               &error),
                    far ? NB_BAD_USE : NB_OK);
    solution_free(&solution);
  }
}

/* Nine discs of mass 5 and k_n = 20 in a box of which each wall moves inward at v = 1e-3, with alpha = 3. */
#define CLOSES(v, step, cycles)                                                                                        \
  "material m density (5/(4*pi)) kn 20\nnormal linear\ndamping mass 3\nlattice discs 3 by 3 from 2 2 radius 2 "        \
  "spacing "                                                                                                           \
  "4 m\nbox 0 0 to 12 12 m\nstep " step "\nstage s\nwalls inward " v "\ncycles " cycles "\nstage t\ncycles 9\n"
static void speed_of_loading(void) {
  const double unbalanced = 3 * 5 * 1e-3 / sqrt(2), largest = 20 * 1e-3 * 7 / 2 + 3 * 5 * 1e-3 / 4;
  VALUES("speed_of_loading", CLOSES("0.001", "0.01", "700"), 0, {"unbalanced.max in s", unbalanced / largest});
  VALUES("speed_of_loading", CLOSES("0.001", "0.01 of single-contact", "700"), 0,
         {"unbalanced.max in s", unbalanced / largest});
#define LASTS(t) "a first stage that lasts longer than 20/alpha with `damping mass alpha`; it lasts " t "/alpha"
  refs_check_message("speed_of_loading", CLOSES("0.001", "0.01", "667"), NULL);
  refs_check_message("speed_of_loading", CLOSES("0.001", "0.01", "666"), LASTS("19.98"));
#undef LASTS
}

/* Removed: disc 2 of a row along (0.6, 0.8), a sphere in flight, and the wall `gate`. Discs of radius 2 have the mass 5;
 * k_n is 20 between them, and 30 with walls, except 120/13 with the gate. Discs 1, 3 and 4 are pushed off by the springs of
 * the walls that stay. Discs 5 and 6, one beyond each end of the gate, and 8 and 14, which move, are no such neighbours; nor are
 * discs 9 and 10, of which one touches only the gate and one only a wall that stays, nor 11 and 12, which touch each other,
 * nor 13, which touches two walls that stay. */
#define REMOVES(first, second)                                                                                         \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\n"                            \
  "wall w (3 + 8) (4 - 6) to (3 - 8) (4 + 6) a\n"                                                                      \
  "wall e (3 - 8 + 11.5*0.6) (4 + 6 + 11.5*0.8) to (3 + 8 + 11.5*0.6) (4 - 6 + 11.5*0.8) a\n"                          \
  "wall low 80 -0.9 to 40 -0.9 a\nwall gate 40 0.9 to 60 0.9 b\n"                                                      \
  "disc (3 + 1.9*0.6) (4 + 1.9*0.8) radius 2 m\ndisc (3 + 5.75*0.6) (4 + 5.75*0.8) radius 2 m\n"                       \
  "disc (3 + 9.6*0.6) (4 + 9.6*0.8) radius 2 m spin 9\ndisc 50 0 radius 1 m\ndisc 39.4 1.7 radius 1.5 m\n"             \
  "disc 60.3 1.3 radius 1 m\nsphere -70 7 radius 2 m velocity 3 -4 spin -6\ndisc 44 0 radius 1 m velocity 0 1e-9\n"    \
  "disc 54 1.8 radius 1 m\ndisc 72 0 radius 1 m\ndisc 46.03 0 radius 1 m\ndisc 47.98 0 radius 1 m\ndisc 57.95 0 "      \
  "radius "                                                                                                            \
  "1 m\ndisc 41.5 0 radius 1 m velocity 1e-9 0\nwall post 57 -0.1 to 57 0.1 a\nmonitor A disc 1\nmonitor B disc "      \
  "2\nmonitor C disc 3\nmonitor D "                                                                                    \
  "disc 4\n"                                                                                                           \
  "monitor E disc 8\nmonitor J disc 14\nmonitor F disc 9\nmonitor G disc 10\nmonitor H disc 11\nmonitor I disc "       \
  "13\nmonitor W wall "                                                                                                \
  "low\nstep 0.01\nstage s\n" first "cycles 7\nstage t\n" second
#define GONE "remove disc 2\nremove sphere 7\nremove wall gate\n"
static void taken_out(void) {
  const double q = sqrt(6), q4 = sqrt(24), kb = 120. / 13, mass = 5. / (4 * pi) * 4 / 3 * pi * 8;
  /* the springs: two of disc 2, and those of the gate at its ends and with seven discs of radius 1 */
  const double springs = 2 * 20 * 0.15 * 0.15 / 2 + kb * (0.5 * 0.5 + 0.5 * 0.5 + 7 * 0.1 * 0.1) / 2;
  const double removed = springs + mass * 25 / 2 + 0.4 * mass * 4 * 36 / 2;
  const double begin = 0.07, early = 0.1 * (1 - cos(0.3 * q)), late = 0.1 * (1 + q * 0.65 - pi / 2);
#define ALONG(name, x0, y0, dx, dy, early, late, v)                                                                    \
  {name ".x", (x0), "time", 0.05}, {name ".y", (y0), "time", begin},                                                   \
      {name ".x", (x0) + (dx) * (early), "time", begin + 0.3},                                                         \
      {name ".y", (y0) + (dy) * (early), "time", begin + 0.3},                                                         \
      {name ".x", (x0) + (dx) * (late), "time", begin + 0.65},                                                         \
      {name ".y", (y0) + (dy) * (late), "time", begin + 0.65}, {name ".vx", (dx) * (v)}, {name ".vy", (dy) * (v)}
  VALUES("taken_out", REMOVES("", GONE "wall low velocity 0 0\ncycles 65\n"), 1, {"energy.removed", removed},
         ALONG("A", 3 + 1.9 * 0.6, 4 + 1.9 * 0.8, 0.6, 0.8, early, late, 0.1 * q),
         ALONG("C", 3 + 9.6 * 0.6, 4 + 9.6 * 0.8, -0.6, -0.8, early, late, 0.1 * q),
         ALONG("D", 50, 0, 0, 1, 0.1 * (1 - cos(0.3 * q4)), 0.1 * (1 + q4 * 0.65 - pi / 2), 0.1 * q4));
  VALUES("taken_out", REMOVES("", GONE "cycles 64\n"), 1,
         {"energy.removed", removed}, /* A and C still touch their walls */
         ALONG("D", 50, 0, 0, 1, 0.1 * (1 - cos(0.3 * q4)), 0.1 * (1 + q4 * 0.65 - pi / 2), 0.1 * q4));
#undef ALONG
#define TWO "two stages, of which only the second removes something, and a step given as a time"
  refs_check_message("taken_out", REMOVES("remove disc 1\n", GONE "cycles 65\n"), TWO);
  refs_check_message("taken_out", REMOVES("remove wall low\n", GONE "cycles 65\n"), TWO);
  refs_check_message("taken_out", REMOVES("", GONE "cycles 65\nstage u\ncycles 1\n"), TWO);
#undef TWO
}

/* Two discs in a row along (0.6, 0.8) between walls that move inward at 0.01. Displacements along the row, from disc 1 to
 * disc 2; the springs are 30, 20 and 120/13, and the masses 5 and 1.25. */
#define INCLINED_ROW(step)                                                                                             \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ndisc 3 4 radius 2 m\n"       \
  "disc (3 + 1.8) (4 + 2.4) radius 1 m\nwall p (3 - 1.2 - 8) (4 - 1.6 + 6) to (3 - 1.2 + 8) (4 - 1.6 - 6) a\n"         \
  "wall q (3 + 2.4 + 8) (4 + 3.2 - 6) to (3 + 2.4 - 8) (4 + 3.2 + 6) b\nmonitor D disc 1\nmonitor E disc 2\n"          \
  "monitor A disc 1 with wall p\nmonitor B disc 2 with disc 1\nmonitor C disc 2 with wall q\nmonitor W wall p\n"       \
  "step " step                                                                                                         \
  "\nstage s\nwall p velocity 0.006 0.008\nwall q velocity -0.006 -0.008\ncycles 4\nstage t\nwalls stop\n"             \
  "cycles 9\n"
static void two_walls(void) {
  const double k[3] = {30, 20, 120. / 13}, force = 2 * 0.04 * 0.1 / (1 / k[0] + 1 / k[1] + 1 / k[2]);
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "two_wall_compression", INCLINED_ROW("0.1"), &error), NB_OK);
  double x = 0, y = 0, vx = 0, vy = 0;
  for (int n = 1; n <= 4; n++) {
    x += 0.1 * vx, y += 0.1 * vy;
    const double overlap[3] = {n * 0.001 - x, x - y, n * 0.001 + y};
    const double fx = k[0] * overlap[0] - k[1] * overlap[1], fy = k[1] * overlap[1] - k[2] * overlap[2];
    const struct expected expected[] = {{"A.overlap", overlap[0]},
                                        {"B.overlap", overlap[1]},
                                        {"C.overlap", overlap[2]},
                                        {"A.normal", k[0] * overlap[0]},
                                        {"B.normal", k[1] * overlap[1]},
                                        {"C.normal", k[2] * overlap[2]},
                                        {"D.fx", 0.6 * fx},
                                        {"D.fy", 0.8 * fx},
                                        {"E.fx", 0.6 * fy},
                                        {"E.fy", 0.8 * fy},
                                        {"D.vx.half", 0.6 * vx},
                                        {"D.vy.half", 0.8 * vx},
                                        {"E.vx.half", 0.6 * vy},
                                        {"E.vy.half", 0.8 * vy}};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
      char name[64];
      snprintf(name, sizeof name, "%s at %d cycles", expected[i].name, n);
      const double *value = solution_find(&solution, name);
      CU_ASSERT(value && fabs(*value - expected[i].value) <= 1e-12);
    }
    CU_ASSERT_EQUAL(solution.value_count, 4 * 14);
    vx += 0.1 * fx / 5, vy += 0.1 * fy / 1.25;
  }
  solution_free(&solution);
  VALUES("two_wall_statics", INCLINED_ROW("0.1"), 0, {"A.normal", force}, {"A.normal mean", force},
         {"A.overlap", force / k[0]}, {"A.shear", 0}, {"B.normal", force}, {"B.normal mean", force},
         {"B.overlap", force / k[1]}, {"B.shear", 0}, {"C.normal", force}, {"C.normal mean", force},
         {"C.overlap", force / k[2]}, {"C.shear", 0});
  /* With dt^2 = 0.16, p = 0.96, q + r = 3.2 and s = 1.18 give b_3 = (2 - q - r) (p + s) + p (2 - p) + s (2 - s) = -0.6. All
   * overlaps are positive again at t_4. */
  refs_check_error("two_wall_compression", INCLINED_ROW("0.4"),
                   "the contact of monitor B opens at cycle 3: use a shorter step, with which no contact opens in 6 "
                   "cycles");
}

/* Two equal spheres that collide head-on have velocities after the impact; spheres of two materials or radii have none. */
static void spheres_that_are_not_equal(void) {
  static const char *const seconds[] = {"radius 1 a", "radius 1 b", "radius 1.001 a"};
  for (int k = 0; k < 3; k++) {
    char page[1024];
    struct nb_solution solution;
    struct nb_error error = {0};
    snprintf(page, sizeof page,
             "material a density 1 young 1 poisson 0\nmaterial b density 2 young 1 poisson 0\nnormal hertz\n"
             "sphere 0 0 radius 1 a velocity 0.1 0\nsphere 3 0 %s velocity -0.1 0\nmonitor D sphere 1\n"
             "step 0.1 of rayleigh\nstage s\ncycles 1\n",
             seconds[k]);
    CU_ASSERT_EQUAL(refs_solve(&solution, "rayleigh_step", page, &error), NB_OK);
    CU_ASSERT_EQUAL(solution_find(&solution, "D.vx") != NULL, k == 0);
    solution_free(&solution);
  }
}

/* For nu = 0, alpha^2 = 3 - 5^(1/2) is the root of x^3 - 8 x^2 + 16 x - 8 = (x - 2) (x^2 - 6 x + 4). The error of the
 * velocities is known for R89's steps only. */
static void rayleigh_step(void) {
  const double fits = pi * sqrt(2) / 0.876605, step = pi * sqrt(2 / (3 - sqrt(5)));
#define OF(first, third)                                                                                               \
  "material a density 1 young 1 poisson 0\nmaterial r density 1 rigid\nnormal hertz\n"                                 \
  "sphere 0 0 radius 1 " first                                                                                         \
  " velocity 0.3 0.1\nsphere 3 1 radius 1 a velocity -0.3 -0.1\nsphere 9 9 radius 1 " third                            \
  "\nmonitor D sphere 1\nmonitor E sphere 2\nmonitor F sphere 3\nmonitor C sphere 1 with sphere 2\nstep 0.01\nstage "  \
  "s\ncycles 1\n"
  VALUES("rayleigh_step", OF("a", "a"), 0, {"step.rayleigh", step}, {"step.rayleigh-fit", fits},
         {"step.rayleigh-mean", step}, {"step.rayleigh-fit-mean", fits}, {"D.vx", -0.3}, {"D.vy", -0.1}, {"E.vx", 0.3},
         {"E.vy", 0.1});
  refs_check_message("rayleigh_step", OF("r", "a"), "elastic particles");
  refs_check_message("rayleigh_step", OF("a", "r"), "elastic particles");
#undef OF
}

/* A particle of mass 2 pi with the moment of inertia pi. In a cell its angular momentum has no value. */
static void momentum(void) {
#define MOVES                                                                                                          \
  "material a density 2 kn 9\nnormal linear\nshear none\ndisc 3 4 radius 1 a velocity 2 -3 spin 5\nstep 0.1\n"         \
  "stage s\ncycles 1\n"
#define EACH(name, value) {name, value}, {name " max", value}, {name " min", value}, {name " mean", value}
  VALUES("momentum", MOVES, 0, EACH("momentum.x", 4 * pi), EACH("momentum.y", -6 * pi),
         EACH("momentum.angular", 2 * pi * (3 * -3 - 4 * 2) + pi * 5));
  VALUES("momentum", "periodic cell 0 0 to 9 9\n" MOVES, 0, EACH("momentum.x", 4 * pi), EACH("momentum.y", -6 * pi));
#undef EACH
#undef MOVES
}

/* Two discs of radius 1 and three of radius 0.5 in a box. */
#define FILLED(more)                                                                                                   \
  "material m density 1 kn 9\nnormal linear\ngrading h 3 7\ngrading g 1 2 0.5 3\n" more                                \
  "fill discs box 1 2 to 11 8 g m seed 3 attempts 999 else stop\nmonitor S grading g radius 0.5\nmonitor G grading "   \
  "g\n"                                                                                                                \
  "monitor D disc 1\nregion R box 1 2 to 11 8\nregion X box 1.1 2 to 11.1 8\nregion Y box 1 2.1 to 11 8.1\n"           \
  "region XX box 0 2 to 12 8\nregion YY box 1 1 to 11 9\nregion XN box 2 2 to 10 8\nregion YN box 1 3 to 11 "          \
  "7\nregion C circle 6 5 radius 5\n"                                                                                  \
  "step 1\nrecord R.porosity\nstage s\ncycles 1\n"
static void filling(void) {
  VALUES(
      "filling",
      "material m density 1 kn 9\nnormal linear\ngrading g 1 1\nfill discs circle 3 4 radius 5 g m seed 3 attempts 9 "
      "else stop\nregion C circle 3 4 radius 5\nregion X circle 3.1 4 radius 5\nregion Y circle 3 4.1 radius 5\n"
      "region R circle 3 4 radius 5.1\nregion B box -2 -1 to 8 9\nstep 1\nrecord C.porosity\nstage s\ncycles 1\n",
      0, {"C.porosity", 1 - 1. / 25});
  /* Only one disc fits into the circle; the two smaller ones do not, and are skipped. */
  VALUES("filling",
         "material m density 1 kn 9\nnormal linear\ngrading g 4 1 3 2\nfill discs circle 3 4 radius 5 g m seed 3 "
         "attempts 99 else skip\nregion C circle 3 4 radius 5\nmonitor G grading g\nmonitor S grading g radius 3\n"
         "monitor L grading g radius 4\nstep 1\nrecord C.porosity\nstage s\ncycles 1\n",
         0, {"C.porosity", 1 - 16. / 25}, {"G.wanted", 3}, {"G.placed", 1}, {"G.dropped", 2}, {"S.wanted", 2},
         {"S.placed", 0}, {"S.dropped", 2}, {"L.wanted", 1}, {"L.placed", 1}, {"L.dropped", 0});
  PARTS(
      "filling", "@", {FILLED(""), NULL}, {FILLED("disc 90 90 radius 1 m\n"), "one `fill` and no other particles"},
      {FILLED("fill discs box 20 2 to 30 8 g m seed 4 attempts 999 else stop\n"), "one `fill` and no other particles"});
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page, "units none\n" FILLED(""));
  written_scene(&it, &page);
  scene.scene = it.scene;
  double gap = INFINITY;
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 5; j++) {
      const struct nb_particle *a = &it.scene.particles[i], *b = &it.scene.particles[j];
      gap = i == j ? gap : fmin(gap, sqrt(pow(a->x - b->x, 2) + pow(a->y - b->y, 2)) - (a->radius + b->radius));
    }
  VALUES("filling", FILLED(""), 0, {"S.wanted", 3}, {"S.placed", 3}, {"S.dropped", 0}, {"G.wanted", 5}, {"G.placed", 5},
         {"G.dropped", 0}, {"R.porosity", 1 - 2.75 * pi / 60}, {"gap", gap});
  it.scene.particle_count = 2;
  it.scene.fills[0].count = 2;
  it.scene.particles[1].radius = 0.75;
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("filling", &scene);
  const struct nb_particle *a = &it.scene.particles[0], *b = &it.scene.particles[1];
  REFS_NEAR(refs_value(&solution, "gap"), hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius, 1e-12, 1.);
  solution_free(&solution);
  written_free(&it);
}

/* A disc whose centre is on the edge of a region is in the region. Discs that just touch have no contact, so the disc
 * between two fixed ones is a rattler. A region that is neither a circle nor a box has no values. */
static void measures_at_edges(void) {
  static const struct {
    const char *name;
    double value;
  } expected[] = {{"C.particles", 2}, {"C.contacts", 0}, {"C.coordination", 0}, {"C.rattlers", 1},
                  {"B.particles", 1}, {"B.contacts", 0}, {"B.coordination", 0}, {"B.rattlers", 1}};
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL_FATAL(
      refs_solve(
          &solution, "measures",
          "material m density 1 kn 1\nnormal linear\ndisc 3 4 radius 0.5 m\ndisc 3.75 5 radius 0.75 m fixed\n"
          "disc 3.75 3 radius 0.75 m fixed\nregion C circle 0 0 radius 5\nregion B box -1 0 to 3 4\nregion A all\n"
          "step 1\nrecord C.particles B.particles A.particles\nstage s\ncycles 1\n",
          &error),
      NB_OK);
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    char name[64];
    snprintf(name, sizeof name, "%s at 0 cycles", expected[k].name);
    CU_ASSERT_EQUAL(refs_value(&solution, name), expected[k].value);
  }
  CU_ASSERT_PTR_NULL(solution_find(&solution, "A.particles at 0 cycles"));
  solution_free(&solution);
}

void suite_refs_values(void) {
  CU_pSuite suite = CU_add_suite("refs_values", NULL, refs_released);
  CU_ADD_TEST(suite, centripetal);
  CU_ADD_TEST(suite, cohesion);
  CU_ADD_TEST(suite, cohesion_in_two_presses);
  CU_ADD_TEST(suite, fracc);
  CU_ADD_TEST(suite, fracc_touch);
  CU_ADD_TEST(suite, fracc_touch_in_few_steps);
  CU_ADD_TEST(suite, carried);
  CU_ADD_TEST(suite, force_chain);
  CU_ADD_TEST(suite, changed_law);
  CU_ADD_TEST(suite, changed_law_of_a_heavy_sphere);
  CU_ADD_TEST(suite, zigzag);
  CU_ADD_TEST(suite, packing);
  CU_ADD_TEST(suite, rayleigh_cycle);
  CU_ADD_TEST(suite, pinched);
  CU_ADD_TEST(suite, no_stable_step);
  CU_ADD_TEST(suite, step_limit);
  CU_ADD_TEST(suite, speed_of_loading);
  CU_ADD_TEST(suite, taken_out);
  CU_ADD_TEST(suite, two_walls);
  CU_ADD_TEST(suite, spheres_that_are_not_equal);
  CU_ADD_TEST(suite, rayleigh_step);
  CU_ADD_TEST(suite, momentum);
  CU_ADD_TEST(suite, filling);
  CU_ADD_TEST(suite, measures_at_edges);
}
