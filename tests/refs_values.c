/* References on scenes without symmetry, compared with other formulas, and the whole message of each scene that they
 * refuse. The expected values come from theory; none is a number that a program computed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
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
  "sphere 5 1 radius 2 a\nsphere 1 6 radius 1 b\nsphere -3 2 radius 0.5 a\nregion R circle 2 3 radius 1.5\n"           \
  "region Q circle (2 + 2e-8) 3 radius 2\nregion V circle 2 (3 - 2e-8) radius 2\nregion U circle (2 + 2e-12) 3 "       \
  "radius 2\nregion B box 0 1 to 4 5\nmonitor D sphere 1\nstep 1\nrecord R.stress.mean\n"
static void centripetal(void) {
  const double mass = 4 * pi / 3 * (3 * 8.125 + 7), thickness = 7. / 3, radius = sqrt(5.25 / 0.845);
  const double p0 = 5 * mass / (pi * radius * thickness);
  VALUES("centripetal",
         HEAP "stage s\ngravity centripetal 4 about 2 3\ncycles 1\nstage n\ngravity 0 0\ncycles 1\nstage t\n"
              "gravity centripetal 5 about 2 3\ncycles 1\nstage u\ncycles 1\n",
         p0, {"R.stress.mean in u", p0 * (1 - 1 / radius)}, {"U.stress.mean in u", p0 * (1 - 4 / (3 * radius))});
  check_message("centripetal",
                HEAP "stage s\ngravity centripetal 4 about 2 3\ncycles 1\nstage t\ngravity 0 0\ncycles 1\n",
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
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p velocity 0 0.1\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n",
         KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5.1 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9.1 p\nwall stop 7 6 to 7 8 s\n", KIND},
        {"disc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\nwall high 0 9 to 9 9 p\nwall stop 7 6 to 7.1 8 s\n", KIND},
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
         KIND});
#undef KIND
#undef DRAG
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
      {"\nwall n -9 1 to 9 1.1 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1 to 9 -1 m", REACH},
      {" velocity 0 0.4\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), REACH},
      {" velocity 0 -0.4\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), REACH},
      {" velocity 0 0.2\n" FOUR("1.8", "1.8", "-1.8", "-1.8"), NULL},
      {" velocity 0 0.4\n" FOUR("3", "1.8", "-1.8", "-3"), REACH},
      {" velocity 0 0.05\n" FOUR("3", "1.8", "-1.8", "-3"), NULL},
      {"\nwall n -9 1 to 9 1 m\nwall e 1.8 -9 to 1.8 9 o\nwall w -1.8 -9 to -1.8 9 m\nwall s -9 -1 to 9 -1 m",
       "walls of one stiffness"},
      {"\nwall n -9 1 to 9 1 m\nwall e 1.8 -9 to 1.8 9 m\nwall w -1.8 -9 to -1.8 9 m",
       "one disc between four walls, with `step F of single-contact`"},
      {"\ndisc 9 9 radius 1 m\n" FOUR("1", "1.8", "-1.8", "-1"),
       "one disc between four walls, with `step F of single-contact`"});
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
  PARTS("fracc_touch", STRIKE "disc 99 9 radius 2 m\n" SHARE "5\n", {"7.1", EQUAL});
#undef TOUCH
#undef EQUAL
#undef SHARE
#undef STRIKE
}

/* Two rows of three discs in a box of 12 by 8 at (1, 5). The two equations of the reference are iterated: they contract
 * by the fraction of the overlap. A servo that controls one length has a strain rate of the other. */
struct boxed {
  double w, h, sx, sy;
};
static struct boxed boxed_with(double sx, double sy, double w, double h) {
  struct boxed b = {isnan(w) ? 12 : w, isnan(h) ? 8 : h, sx, sy};
  for (int k = 0; k < 100; k++) {
    b.w = isnan(w) ? 12 - 4 * sx * b.h / (2 * 50.) : w;
    b.h = isnan(h) ? 8 - 3 * sy * b.w / (3 * 50.) : h;
  }
  if (isnan(sx))
    b.sx = 2 * 50 * (12 - b.w) / 4 / b.h;
  if (isnan(sy))
    b.sy = 3 * 50 * (8 - b.h) / 3 / b.w;
  return b;
}
#define AT_REST(stage, b)                                                                                              \
  {"box.width in " stage, (b).w}, {"box.height in " stage, (b).h}, {"box.stress.xx in " stage, (b).sx},                \
      {"box.stress.yy in " stage, (b).sy}, {"W.fx in " stage, -(b).sx * (b).h}, {"W.fy in " stage, 0},                 \
      {"E.fx in " stage, (b).sx * (b).h}, {"E.fy in " stage, 0}, {"S.fx in " stage, 0},                                \
      {"S.fy in " stage, -(b).sy * (b).w}, {"N.fx in " stage, 0}, {                                                    \
    "N.fy in " stage, (b).sy *(b).w                                                                                    \
  }
#define ROCK                                                                                                           \
  "material a density 1 kn 50\nmaterial b density 1 kn 50\nmaterial c density 1 kn 51\nnormal linear\nshear none\n"
#define SIX "lattice discs 3 by 2 from 3 7 radius 2 spacing 4 a\n"
#define SERVO(target, on) "servo " target " on " on " through box at most 1e-4 per cycle\n"
static void boxed_lattice(void) {
  const struct boxed s = boxed_with(NAN, NAN, 12 * pow(1 - 0.00025, 10), 8 * pow(1 - 0.0005, 10)),
                     t = boxed_with(NAN, NAN, s.w * pow(1 - 0.0005, 4), s.h * pow(1 - 0.001, 4)),
                     u = boxed_with(0.7, NAN, NAN, t.h * pow(1 - 0.001, 6)),
                     v = boxed_with(NAN, 0.4, u.w * pow(1 - 1e-4, 7), NAN), x = boxed_with(0.9, 0.9, NAN, NAN);
  struct boxed y = x, z;
  double low = 0.5, high = 1; /* fractions by which width and height change, such that the mean stress is 0.8 */
  for (int k = 0; k < 100; k++) {
    const double middle = (low + high) / 2 * 12 / x.w;
    y = boxed_with(NAN, NAN, middle * x.w, middle * x.h);
    *(y.sx + y.sy > 1.6 ? &low : &high) = (low + high) / 2;
  }
  z = boxed_with(NAN, NAN, y.w * pow(1 - 2e-4, 3), y.h * pow(1 - 2e-4, 3));
  VALUES(
      "boxed_lattice",
      ROCK
      "box 1 5 to 13 13 b\n" SIX
      "monitor W wall west\nmonitor D disc 1\nmonitor E wall east\nmonitor S wall south\nmonitor N wall north\n"
      "step 0.25\nstage s\nbox strain -0.001 -0.002\ncycles 10\nstage t\nstep 0.5\ncycles 4\nstage u\n" SERVO(
          "xx 0.7",
          "box") "cycles 6\nstage v\nbox strain -1e-4 per cycle -3e-4 per cycle\n" SERVO("yy 0.4",
                                                                                         "walls") "cycles 7\nstage "
                                                                                                  "x\n" SERVO(
                                                                                                      "isotropi"
                                                                                                      "c 0.9",
                                                                                                      "box") "c"
                                                                                                             "y"
                                                                                                             "c"
                                                                                                             "l"
                                                                                                             "e"
                                                                                                             "s"
                                                                                                             " "
                                                                                                             "5"
                                                                                                             "\nstage "
                                                                                                             "y\nbox "
                                                                                                             "strain "
                                                                                                             "-2e-4 "
                                                                                                             "per "
                                                                                                             "cycle "
                                                                                                             "-2e-4 "
                                                                                                             "per "
                                                                                                             "c"
                                                                                                             "y"
                                                                                                             "c"
                                                                                                             "l"
                                                                                                             "e"
                                                                                                             "\n" SERVO(
                                                                                                                 "mean "
                                                                                                                 "0.8",
                                                                                                                 "box") "cycles 5\nstage z\ncycles 3\n",
      1e-2, AT_REST("s", s), AT_REST("t", t), AT_REST("u", u), AT_REST("v", v), AT_REST("x", x), AT_REST("y", y),
      AT_REST("z", z));
#define LATTICE "one `lattice discs` of touching discs in a box of the same stiffness"
#define STAGES "stages that move walls by `box strain` and `servo ... on box through box` alone"
  PARTS("boxed_lattice", ROCK "@step 0.1\nstage s\nbox strain -1e-4 per cycle -1e-4 per cycle\ncycles 1\n",
        {"box 1 5 to 13 13 a\n" SIX, NULL}, {"box 1 5 to 13 13 c\n" SIX, LATTICE},
        {"box 1 5 to (13 + 1e-9) 13 b\n" SIX, NULL}, {"box 1 5 to (13 + 1e-8) 13 b\n" SIX, LATTICE},
        {"box 1 5 to (13 - 1e-8) 13 b\n" SIX, LATTICE}, {"box 1 5 to 13 (13 + 1e-8) b\n" SIX, LATTICE},
        {"box 1 5 to 13 (13 - 1e-8) b\n" SIX, LATTICE}, {"box 2 5 to 14 13 b\n" SIX, LATTICE},
        {"box 1 4 to 13 12 b\n" SIX, LATTICE},
        {"box 1 5 to 5 13 b\nlattice discs 1 by 2 from 3 7 radius 2 spacing 4 a\n", NULL},
        {"box 1 5 to 13 9 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\n", NULL},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\n", LATTICE},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\ndisc 3 11 radius 2 a\n"
         "disc 7 11 radius 2 a\ndisc 11 11 radius 2 b\n",
         LATTICE},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\ndisc 3 11 radius 2 a\n"
         "disc 7 11 radius 2 a\ndisc 11 11 radius 1.999 a\n",
         LATTICE},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\ndisc 3 11 radius 2 a\n"
         "disc (7 + 1e-10) 11 radius 2 a\ndisc 11 11 radius 2 a\n",
         LATTICE},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\ndisc 3 11 radius 2 a\n"
         "disc 7 (11 - 1e-10) radius 2 a\ndisc 11 11 radius 2 a\n",
         LATTICE},
        {"box 1 5 to 13 13 b\nlattice discs 3 by 1 from 3 7 radius 2 spacing 4 a\ndisc 3 11 radius 2 a\n"
         "disc (7 + 2e-12) 11 radius 2 a\ndisc 11 11 radius 2 a\n",
         NULL},
        {"box 1 5 to 13 17 b\n" SIX "disc 3 15 radius 2 a\n", LATTICE});
  PARTS("boxed_lattice", ROCK "box 1 5 to 13 13 b\n" SIX "region R box 2 6 to 8 9\nstep 0.1\nstage s\n@cycles 4\n",
        {"", NULL}, {"box strain 0 0\n", NULL}, {"box strain 1e-4 -1e-4\n", "compressed contacts"},
        {"box strain -1e-4 1e-4\n", "compressed contacts"}, {SERVO("xx 1", "R"), STAGES},
        {SERVO("xx 1", "walls"), NULL}, {"wall west velocity 0 0\n", STAGES},
        {"box strain 0 1e-4\n" SERVO("mean 1", "box"), STAGES}, {"box strain 1e-4 1e-4\n" SERVO("mean 1", "box"), NULL},
        {"step 0.1 of stable\n", NULL}, {"step 0.1 of stable\nbox strain -1e-4 -1e-4\n", STAGES},
        {"box strain -1e-4 per cycle -1e-4 per cycle\nstep 0.1 of stable\n", NULL});
#undef LATTICE
#undef STAGES
}

/* Two particles that do not touch, from rest in x_(N+1) = x_N + u_(N+1) dt with u <- K u + e x [R89 4.43]. */
static double accumulated(double from, double e, double keep, int cycles) {
  double x = from, u = 0;
  for (int n = 0; n < cycles; n++)
    u = keep * u + e * x, x += u;
  return x;
}
static void carried_with(const char *damping, double keep) {
  static const double e[][2] = {{0.01, -0.02}, {-0.5, 0.03}, {0, 0.01}};
  for (int k = 0; k < 3; k++) {
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
        {"9 6.9 radius 1.1 a", TOUCH}, {"11.46 9 radius 1 a", TOUCH});
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
  "\n" walls "region R box -3 -2 to 12 16\nregion Q box -3 -2 to 9 16\nregion P box 0.5 -2 to 12 16\nregion C circle " \
  "1 2 radius 40\nregion L box 0 -2 to 12 16\nregion B box -3 0.6 to 12 16\nregion T box -3 -2 to 12 12\n"             \
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
#undef ENDS
#undef EQUAL
}

/* A sphere of the stiffnesses k_n = 15 and k_s = 6, E* = 8/3 and G* with overlap 0.01 at a wall, which moves past it. */
#define SLIDES(density, friction, wall, stages)                                                                        \
  "material g density " density " young 4 poisson 0.25 kn 30 ks 12 friction " friction "\n"                            \
  "material w kn 10 ks 4 young 4 poisson 0.25 friction 0.9\nnormal linear\nshear linear\nsphere 5 6.99 radius 2 g\n"   \
  "wall f " wall " w velocity 0.01 0\nmonitor C sphere 1 with wall f\nmonitor D sphere 1\nstep 0.1\n" stages
static void changed_law(void) {
  const double kn = 15, overlap = 0.01, end = 1.8, least = kn * overlap * end * end / 2 / (1e-13 * overlap);
  char page[1024];
  CU_ASSERT(kn > 4. / 3 * (2 / 0.9375) * sqrt(2 * overlap)); /* the linear spring is the stiffer one */
  for (int k = 0; k < 2; k++) {
    snprintf(page, sizeof page, SLIDES("%.17g", "0.8", "-9 5 to 9 5", "stage s\ncycles 10\nstage t\ncycles 8\n"),
             least / (32 * pi / 3) * (k ? 1.0001 : 0.9999));
    check_message("changed_law", page, k ? NULL : "a sphere so heavy that its contact does not move it");
  }
  /* The laws of a stage apply up to its end, t = 1, included: linear springs, without sliding.
   * The normal e = (0, -1) from the sphere to the wall gives t = (-1, 0), and the sphere moves along t by 0.01 t. */
  const double hertz = 4. / 3 * (2 / 0.9375) * sqrt(2) * pow(overlap, 1.5);
  VALUES("changed_law",
         SLIDES("1e30", "0.8", "-9 5 to 9 5", "stage s\ncycles 10\nstage t\nnormal hertz\nshear none\ncycles 8\n"), 0,
         {"C.normal", kn * overlap, "time", 0.9}, {"C.normal", kn * overlap, "time", 1},
         {"C.normal", hertz, "time", 1.1}, {"C.shear", 6 * 0.01 * 1, "time", 1}, {"C.shear", 0, "time", 1.1});
}

/* A zigzag of five discs at 20 degrees to y; the first and the last are fixed. A fourth free disc touches nothing. */
static void zigzag(void) {
  const double phi = pi / 9;
  char page[2048] = "material m density 1 kn 10\nnormal linear\nstep 0.001\nregion A all\nwall w -1 -9 to -1 9 m\n"
                    "disc 40 0 radius 1 m\n";
  for (int k = 0; k < 5; k++)
    snprintf(page + strlen(page), sizeof page - strlen(page), "disc %.17g %.17g radius 1 m%s\n",
             k % 2 ? 1.99 * sin(phi) : 0, 1.99 * k * cos(phi), k % 4 ? "" : " fixed");
  strcat(page, "stage s\ncycles 1\n");
  char without[sizeof page];
  const char *const region = strstr(page, "region A all\n"), *const after = region + strlen("region A all\n");
  snprintf(without, sizeof without, "%.*s%s", (int)(region - page), page, after);
  check_message("zigzag", without,
                "a region and three or more free discs whose contacts all make the same angle with y");
  VALUES("zigzag", page, 1, {"A.chains", 1}, {"A.chains.length", 3}, {"A.chains.fraction", 0.75},
         {"A.chains.bend", 2 * phi});
}

/* A packing of three discs, and records of their state, which need not agree with it: the reference reads the numbers as
 * they are. The files end in no extension, and `.state`. Another particle is refused, and a packing without a state. */
static void packing(void) {
  char folder[] = "/tmp/nineball.packing-XXXXXX", list[64], state[64], page[1024];
  CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(folder));
  snprintf(list, sizeof list, "%s/three", folder), snprintf(state, sizeof state, "%s/three.state", folder);
  written_text(list, "x/-\ty/-\tradius/-\n0\t0\t1\n1.5\t0\t1\n9\t0\t2\n");
  written_text(state, "body 2 disc m free 0x1p+0 1.25 -0x1p-1 3 4 5 6\nbody 3 disc m free 2 9.5 0.25 3 4 5 6\n"
                      "contact 1 body 3 heard 9 8 0.5 0.6 0.7 0.8\nfields overlap normals normal ex\n"
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
    check_message("packing", page, k ? "one `packing`, and no other particles" : NULL);
  }
  check_message("packing",
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
  CU_ASSERT_EQUAL(solve(&solution, "packing", page, &error), NB_BAD_USE);
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
  "step 0.4 of rayleigh-fit-mean\nstage s\ncycles 5\nstage t\ncycles %lu\n"
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
  CU_ASSERT_EQUAL(solve(&solution, "rayleigh_cycle", page, &error), NB_BAD_USE);
  snprintf(text, sizeof text, "the particles have not collided and separated within the %lu cycles of the scene",
           cycles - 1);
  CU_ASSERT_STRING_EQUAL(error.text, text);
  solution_free(&solution);
  for (int apart = 0; apart < 2; apart++) {
    snprintf(page, sizeof page, COLLIDE, apart ? "1.99" : "2.01", 900ul);
    check_message("rayleigh_cycle", page,
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

/* A disc of mass 5, k_n = 20 and k_s = 8 on a floor, of weight 2 with g = 0.4, which slides with mu = 0.5 from u0 = 1.
 * The shear spring has (1 + q) k_s/m = 4.8 and the deflection d_m = 1/8 while the disc slides. The single-contact step is
 * that of two such discs, k_n = 30. */
#define SLIDES_ON(extra, friction, y, wall, stages)                                                                    \
  "material m density (5/(4*pi)) kn 30 ks 12 friction 9\nmaterial f kn 15 ks 6 friction " friction "\n" extra          \
  "normal linear\nshear linear\ngravity 0 -0.4\ndisc 7 " y " radius 2 m velocity 1 0\nwall f " wall " f\n"             \
  "monitor D disc 1\nmonitor C disc 1 with wall f\nstage s\nuntil C.sliding below 0.5 at most 900 "                    \
  "cycles\n" stages
static void slide_to_roll(void) {
  const double m = 5, ks = 8, limit = 1. / 8, brake = 0.6, critical = 2 * sqrt(m / 30);
  const struct {
    const char *damping;
    double c; /* of the shear dashpot */
  } rows[] = {{"", 0},
              {"damping ratio 0.2\n", 0.2 * 2 * sqrt(m * ks)},
              {"damping stiffness 0.3\n", 0.3 * ks},
              {"damping r89-fraction 0.7\n", 0.7 * ks * critical / 2},
              {"damping ratio 0.2\ndamping walls stiffness 0.1\n", 0.1 * ks}};
  char page[1024];
  double far = 0;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const double b = 3 * rows[k].c / (2 * m), w = sqrt(4.8 - b * b);
    double low = 0, high = atan2(w, b) / w;
    for (int n = 0; n < 100; n++)
      *(exp(-b * (low + high) / 2) * sin(w * (low + high) / 2) / w < limit ? &low : &high) = (low + high) / 2;
    const double slip = exp(-b * low) * (cos(w * low) - b / w * sin(w * low)), slide = low + slip / brake;
    const double end = limit + slip * slip / (2 * brake), stick = exp(-b * 0.05) * sin(w * 0.05) / w;
    const double back = limit * (exp(-b) * (cos(w) + b / w * sin(w)) - 1); /* in one second of rolling */
    const double rate = -limit * exp(-b) * (w + b * b / w) * sin(w), t = slide + 1;
    snprintf(page, sizeof page, SLIDES_ON("step 0.01\n%s", "0.5", "4.9", "99 3 to -9 3", "stage t\ncycles 90\n"),
             rows[k].damping);
    VALUES("slide_to_roll", page, 1, {"D.x", 7 + (stick + 0.1) / 3, "time", 0.05},
           {"D.vx", (exp(-b * 0.05) * (cos(w * 0.05) - b / w * sin(w * 0.05)) + 2) / 3, "time", 0.05},
           {"D.vx", (slip - brake * 0.5 + 2) / 3, "time", low + 0.5},
           {"D.spin", -(1 - (slip - brake * 0.5 + 2) / 3), "time", low + 0.5},
           {"D.x", 7 + (limit + slip * 0.5 - brake * 0.125 + 2 * (low + 0.5)) / 3, "time", low + 0.5},
           {"D.x", 7 + (end + back + 2 * t) / 3, "time", t}, {"D.vx", (rate + 2) / 3, "time", t},
           {"D.spin", -(1 - (rate + 2) / 3), "time", t}, {"time in s", slide}, {"D.x in s", 7 + (end + 2 * slide) / 3},
           {"D.vx in t", 2. / 3});
    if (k == 0)
      far = 7 + (end + limit * (cos(0.9 * w) - 1) + 2 * (slide + 0.9)) / 3;
  }
#define LONG "a floor so long that the particle does not reach its end"
#define FORCE(n)                                                                                                       \
  "a particle that moves along the floor without spin, with an initial normal force equal to its weight of 2 N; the "  \
  "force is " n " N"
#define SLOW "a particle that slides, with less than critical damping"
  for (int k = 0; k < 8; k++) {
    snprintf(page, sizeof page, SLIDES_ON("step %s\n", "0.5", "4.9", "%.9g 3 to %.9g 3", "stage t\ncycles 90\n"),
             k < 4 ? "0.01" : "(0.01/(2*sqrt(5/30))) of single-contact", k % 4 < 2 ? -9 : far + (k % 2 ? -1e-6 : 1e-6),
             k % 4 < 2 ? far + (k % 2 ? -1e-6 : 1e-6) : -9);
    check_message("slide_to_roll", page, k % 2 ? LONG : NULL);
  }
  PARTS("slide_to_roll", SLIDES_ON("step 0.01\n", "0.5", "@", "-9 3 to 99 3", ""), {"(5 - 0.1*(1 - 0.9e-4))", NULL},
        {"(5 - 0.1*(1 + 0.9e-4))", NULL}, {"(5 - 0.1*1.1)", FORCE("2.2")}, {"(5 - 0.1*0.9)", FORCE("1.8")},
        {"(5 - 0.1*(1 + 1.1e-4))", FORCE("2.00022")}, {"(5 - 0.1*(1 - 1.1e-4))", FORCE("1.99978")});
  PARTS("slide_to_roll", SLIDES_ON("step 0.01\n@", "0.5", "4.9", "-9 3 to 99 3", ""), {"damping ratio 0.577\n", NULL},
        {"damping ratio 0.578\n", SLOW});
  PARTS("slide_to_roll", SLIDES_ON("step 0.01\n", "@", "4.9", "-9 3 to 99 3", ""), {"1.825", NULL}, {"1.826", SLOW});
  PARTS("slide_to_roll", SLIDES_ON("step 0.01\n", "0.5", "4.9", "@", ""), {"6.99 3 to 99 3", NULL},
        {"7.01 3 to 99 3", "a wall along x, below the particle"},
        {"-9 3 to 99 3.1", "a wall along x, below the particle"},
        {"-9 3 to 99 2.9", "a wall along x, below the particle"},
        {"-9 4.9 to 99 4.9", "a wall along x, below the particle"});
#undef LONG
#undef FORCE
#undef SLOW
}

/* A rigid disc of mass 5 and I = 10 with g = 0.4. It moves at v = 3, w = -0.5 on a floor with mu = 0.25, later 0.5. */
#define ROTATES(wall, stages)                                                                                          \
  "material m density (5/(4*pi)) kn 30 ks 12 friction 0.25\nmaterial f kn 15 ks 6 friction 0.8\nnormal linear\n"       \
  "shear linear\ngravity 0 -0.4\ndisc 7 4.9 radius 2 m velocity 3 0 spin -0.5\nwall f " wall " f\nmonitor D disc 1\n"  \
  "monitor C disc 1 with wall f\nstep 0.1\nstage a\ncycles 10\nstage b\nrotation off\ncycles 10\n" stages
#define RESUMES                                                                                                        \
  "stage c\nrotation on\npair m f friction 0.5\nuntil C.sliding below 0.5 at most 90 cycles\nstage d\ncycles 20\n"     \
  "stage e\nrotation off\nuntil C.sliding below 0.5 at most 900 cycles\nstage f\ncycles 5\n"
static void rotation_off(void) {
  const double roll = 2.8 / (3 * 0.2), v = 2.8 - 0.2 * roll, stop = v / 0.2, first = 5 * 0.6 * 0.6;
  const double second = first + 5 * v * v / 4, far = 7 + 2.95 + 2.85 + (2.8 + v) / 2 * roll + 2 * v + v / 2 * stop;
  VALUES("rotation_off", ROTATES("-9 3 to 99 3", RESUMES), 1, {"D.vx in a", 2.9}, {"D.spin in a", -0.6},
         {"energy.changed in a", 0}, {"D.vx in b", 2.8}, {"D.spin in b", 0}, {"energy.changed in b", -first},
         {"D.vx in c", v}, {"D.spin in c", -v / 2}, {"energy.changed in c", -first}, {"time in c", 2 + roll},
         {"D.vx in d", v}, {"D.spin in d", -v / 2}, {"energy.changed in d", -first}, {"D.vx in e", 0},
         {"D.spin in e", 0}, {"energy.changed in e", -second}, {"time in e", 4 + roll + stop}, {"D.vx in f", 0},
         {"D.spin in f", 0}, {"energy.changed in f", -second});
#define LEVEL "one particle that moves in +x on a level floor, under gravity"
#define LONG "a floor so long that the particle does not reach its end"
  char page[1024];
  for (int k = 0; k < 4; k++) {
    snprintf(page, sizeof page, ROTATES("%.9g 3 to %.9g 3", RESUMES), k < 2 ? -9 : far + (k == 2 ? 1e-6 : -1e-6),
             k < 2 ? far + (k == 0 ? 1e-6 : -1e-6) : -9);
    check_message("rotation_off", page, k % 2 ? LONG : NULL);
  }
  PARTS("rotation_off", ROTATES("@", ""), {"6.99 3 to 99 3", NULL}, {"7.01 3 to 99 3", LEVEL}, {"99 3 to 6.99 3", NULL},
        {"99 3 to 7.01 3", LEVEL}, {"9.94 3 to -9 3", LONG}, {"9.96 3 to -9 3", LONG}, {"-9 5 to 99 5", LEVEL});
#undef LEVEL
#undef LONG
}

/* A disc of mass 5 and R = 2 in a right angle at (2, 1), with the unit normals n_1 = (0.6, 0.8) and n_2 = (-0.8, 0.6) and
 * the stiffnesses 30 and 120/13. The forces are -m g n_i, and c = P + (R - N_1/k_1) n_1 + (R - N_2/k_2) n_2. */
#define NESTS(gravity, one, two, stages)                                                                               \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ngravity " gravity            \
  "\ndisc 2 4 radius 2 m\nwall a " one " a\nwall b " two " b\nmonitor D disc 1\nmonitor A disc 1 with wall a\n"        \
  "monitor B disc 1 with wall b\nstep 0.01\n" stages
static void wedge(void) {
  const double k1 = 30, k2 = 120. / 13, n1 = -5 * (0.6 * 0.1 - 0.8), n2 = -5 * (-0.8 * 0.1 - 0.6);
  const double d1 = 2 - n1 / k1, d2 = 2 - n2 / k2;
#define REST                                                                                                           \
  {"A.normal in s", n1}, {"A.overlap in s", n1 / k1}, {"B.normal in s", n2}, {"B.overlap in s", n2 / k2},              \
      {"D.x in s", 2 + d1 * 0.6 - d2 * 0.8}, {"D.y in s", 1 + d1 * 0.8 + d2 * 0.6},                                    \
      {"step.stable in s", 2 * sqrt(5 / (k1 + k2))}
#define ON "a particle that rests on the faces of both walls"
  VALUES("wedge", NESTS("0.1 -1", "2 1 to -6 7", "2 1 to 8 9", "stage s\ncycles 1\nstage t\ngravity 1 -3\ncycles 1\n"),
         1, REST);
  VALUES("wedge", NESTS("0 -9", "-6 7 to 2 1", "8 9 to 2 1", "stage s\ngravity 0.1 -1\ncycles 1\n"), 1, REST);
  char page[1024];
  for (int wall = 0; wall < 2; wall++)
    for (int end = 0; end < 2; end++)
      for (int more = -1; more < 2; more += 2) { /* the foot is d2 from P on wall 1, and d1 on wall 2 */
        const double foot = wall ? d1 : d2, low = end ? 0 : foot + 1e-6 * more, high = end ? foot + 1e-6 * more : 9;
        const double of[2][2] = {{wall ? 0 : low, wall ? 9 : high}, {wall ? low : 0, wall ? high : 9}};
        snprintf(page, sizeof page,
                 NESTS("0.1 -1", "%.17g %.17g to %.17g %.17g", "%.17g %.17g to %.17g %.17g", "stage s\ncycles 1\n"),
                 2 - 0.8 * of[0][0], 1 + 0.6 * of[0][0], 2 - 0.8 * of[0][1], 1 + 0.6 * of[0][1], 2 + 0.6 * of[1][0],
                 1 + 0.8 * of[1][0], 2 + 0.6 * of[1][1], 1 + 0.8 * of[1][1]);
        check_message("wedge", page, (more > 0) == end ? NULL : ON);
      }
  PARTS("wedge", NESTS("@", "2 1 to -6 7", "2 1 to 8 9", "stage s\ncycles 1\n"), {"-0.74 -1", NULL}, {"-0.76 -1", ON},
        {"1.33 -1", NULL}, {"1.34 -1", ON}, {"0 1", ON});
#undef REST
#undef ON
}

/* A network of one or two discs of mass 5, R = 2: the limits of its single degree of freedom without coupling, where
 * dt^2 K/m + 2 dt C/m = 2 (1 + keep)/gain. `step max` is found by bisection. */
static double step_of_limit(double k, double c, double m, double right) {
  return (sqrt(c * c + k * m * right) - c) / k;
}
static void limits(const char *page, double single, double stable, double longest) {
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(solve(&solution, "step_limit", page, &error), NB_OK);
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
    CU_ASSERT_EQUAL(solve(&solution, "step_limit",
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
  check_message("speed_of_loading", CLOSES("0.001", "0.01", "667"), NULL);
  check_message("speed_of_loading", CLOSES("0.001", "0.01", "666"), LASTS("19.98"));
#undef LASTS
}

/* A sphere strikes a wall at the angle 30 or 80 degrees with mu = 0.1 and q = 5/2. E* = 1/(0.84/7 + 0.9375/5) and
 * G* = 1/(1.6/(7/2.8) + 1.75/(5/2.5)) for the materials of sphere and wall. */
#define STRIKES(wall, angle)                                                                                           \
  "material g density 3 young 7 poisson 0.4 friction 0.1\nmaterial w young 5 poisson 0.25 friction 0.6\nnormal "       \
  "hertz\n"                                                                                                            \
  "shear mindlin_deresiewicz\nsphere 1 5 radius 2 g\nwall f " wall                                                     \
  " w\nmonitor C sphere 1 with wall f\nimpact C speed "                                                                \
  "0.01 angle " angle "\nstep 100 per collision\nstage s\nuntil impact.time above 1.1 at most 999 cycles\n"
static void rigid_impact(void) {
  const double mu = 0.1, young = 1 / (0.84 / 7 + 0.9375 / 5), shear = 1 / (1.6 / 2.5 + 1.75 / 2);
  const double kappa = young / (4 * shear), slides = atan(2 * mu * 3.5) * 180 / pi;
  static const char *const walls[] = {"-99 2 to 99 2", "99 2 to -99 2", "-1 99 to -1 -99",
                                      "(1 - 40) (5 + 20) to (1 + 30) (5 - 32)"};
  for (size_t k = 0; k < sizeof walls / sizeof *walls; k++)
    for (int sticks = 0; sticks < 2; sticks++) {
      char page[1024];
      const double degrees = slides + (sticks ? -5 : 5), angle = degrees * pi / 180;
      snprintf(page, sizeof page, STRIKES("%s", "(%.17g*pi/180)"), walls[k], degrees);
      const double slid = sqrt(1 - 2 * mu * sin(2 * angle) + 2 * mu * mu * (1 + cos(2 * angle)));
      VALUES("rigid_impact", page, 0, {"impact.psi2", sticks ? 0 : (tan(angle) - 2 * mu * 3.5) / (mu * kappa)},
             {"impact.restitution", sticks ? hypot(cos(angle), 5. / 7 * sin(angle)) : slid});
    }
}

/* Removed: disc 2 of a row along (0.6, 0.8), a sphere in flight, and the wall `gate`. Discs of radius 2 have the mass 5;
 * k_n is 20 between them, and 30 with walls, except 120/13 with the gate. Discs 1, 3 and 4 are pushed off by the springs of
 * the walls that stay. Discs 5 and 6, one beyond each end of the gate, and 8, which moves, are no such neighbours; nor are
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
  "1 m\nwall post 57 -0.1 to 57 0.1 a\nmonitor A disc 1\nmonitor B disc 2\nmonitor C disc 3\nmonitor D "               \
  "disc 4\n"                                                                                                           \
  "monitor E disc 8\nmonitor F disc 9\nmonitor G disc 10\nmonitor H disc 11\nmonitor I disc 13\nmonitor W wall "       \
  "low\nstep 0.01\nstage s\n" first "cycles 7\nstage t\n" second
#define GONE "remove disc 2\nremove sphere 7\nremove wall gate\n"
static void taken_out(void) {
  const double q = sqrt(6), q4 = sqrt(24), kb = 120. / 13, mass = 5. / (4 * pi) * 4 / 3 * pi * 8;
  /* the springs: two of disc 2, and those of the gate at its ends and with six discs of radius 1 */
  const double springs = 2 * 20 * 0.15 * 0.15 / 2 + kb * (0.5 * 0.5 + 0.5 * 0.5 + 6 * 0.1 * 0.1) / 2;
  const double removed = springs + mass * 25 / 2 + 0.4 * mass * 4 * 36 / 2;
  const double begin = 0.07, early = 0.1 * (1 - cos(0.3 * q)), late = 0.1 * (1 + q * 0.65 - pi / 2);
#define ALONG(name, x0, y0, dx, dy, early, late, v)                                                                    \
  {name ".x", (x0), "time", 0.05}, {name ".y", (y0), "time", begin},                                                   \
      {name ".x", (x0) + (dx) * (early), "time", begin + 0.3},                                                         \
      {name ".y", (y0) + (dy) * (early), "time", begin + 0.3},                                                         \
      {name ".x", (x0) + (dx) * (late), "time", begin + 0.65},                                                         \
      {name ".y", (y0) + (dy) * (late), "time", begin + 0.65}, {name ".vx", (dx) * (v)}, {name ".vy", (dy) * (v)}
  VALUES("taken_out", REMOVES("", GONE "cycles 65\n"), 1, {"energy.removed", removed},
         ALONG("A", 3 + 1.9 * 0.6, 4 + 1.9 * 0.8, 0.6, 0.8, early, late, 0.1 * q),
         ALONG("C", 3 + 9.6 * 0.6, 4 + 9.6 * 0.8, -0.6, -0.8, early, late, 0.1 * q),
         ALONG("D", 50, 0, 0, 1, 0.1 * (1 - cos(0.3 * q4)), 0.1 * (1 + q4 * 0.65 - pi / 2), 0.1 * q4));
  VALUES("taken_out", REMOVES("", GONE "cycles 64\n"), 1,
         {"energy.removed", removed}, /* A and C still touch their walls */
         ALONG("D", 50, 0, 0, 1, 0.1 * (1 - cos(0.3 * q4)), 0.1 * (1 + q4 * 0.65 - pi / 2), 0.1 * q4));
#undef ALONG
#define TWO "two stages, of which only the second removes something, and a step given as a time"
  check_message("taken_out", REMOVES("remove disc 1\n", GONE "cycles 65\n"), TWO);
  check_message("taken_out", REMOVES("remove wall low\n", GONE "cycles 65\n"), TWO);
  check_message("taken_out", REMOVES("", GONE "cycles 65\nstage u\ncycles 1\n"), TWO);
#undef TWO
}

/* Three stages before the reversal, one of them at rest, and two after it. */
#define REVERSED(first, more)                                                                                          \
  "material m density 2 kn 9\nnormal linear\ngravity 0.1 -0.2\ndisc 3 -4 radius 1 m velocity 2 -3 spin 5\n"            \
  "sphere -7 8 radius 2 m velocity -1 6 spin -9\nwall w -9 0 to 9 0.1 m\nmonitor D disc 1\nmonitor E sphere 2\n"       \
  "monitor W wall w\nstep 0.1\nstage a\n" first more
static void time_reversal(void) {
  VALUES("time_reversal",
         REVERSED("wall w velocity 1 2\n",
                  "cycles 3\nstage b\ncycles 4\nstage c\nreverse velocities\ncycles 5\nstage d\n"
                  "cycles 2\n"),
         0, {"D.x", 3}, {"D.y", -4}, {"D.angle", 0}, {"D.vx", -2}, {"D.vy", 3}, {"D.spin", -5}, {"E.x", -7}, {"E.y", 8},
         {"E.angle", 0}, {"E.vx", 1}, {"E.vy", -6}, {"E.spin", 9});
#define ONCE                                                                                                           \
  "one `reverse velocities`, as many cycles before it as after it, and walls whose motion is set only in the first "   \
  "stage"
  PARTS("time_reversal", REVERSED("cycles 3\n", "@"), {"stage b\nreverse velocities\ncycles 3\n", NULL},
        {"stage b\nreverse velocities\ncycles 2\n", ONCE}, {"stage b\nreverse velocities\ncycles 4\n", ONCE},
        {"stage b\nreverse velocities\nwall w velocity 0 1\ncycles 3\n", ONCE},
        {"stage b\nreverse velocities\ncycles 2\nstage c\nwall w velocity 0 1\ncycles 1\n", ONCE},
        {"stage b\nreverse velocities\ncycles 1\nstage c\nreverse velocities\ncycles 2\n", ONCE});
#undef ONCE
}

/* A disc of mass 5 and k_n = 20 hits an end of a wall head-on: it returns with the opposite relative velocity after an
 * overlap of v (m/k)^(1/2). The wall from P = (3, 4) along (0.6, 0.8) moves; its ends are at P and at 10 from it. */
#define HITS(x, y, vx, vy)                                                                                             \
  "material m density (5/(4*pi)) kn 20\nnormal linear\ndisc (3 + 0.6*(" x ") - 0.8*(" y ")) (4 + 0.8*(" x              \
  ") + 0.6*(" y ")) radius 2 m velocity (0.01 + 0.6*(" vx ") - 0.8*(" vy ")) (-0.02 + 0.8*(" vx ") + 0.6*(" vy         \
  "))\nwall w 3 4 to 9 12 m about 3 4 velocity 0.01 -0.02\nmonitor D disc 1\nmonitor C disc 1 with wall w\nmonitor W " \
  "wall w\n"                                                                                                           \
  "step 0.1\nstage s\ncycles 1\n"
static void wall_end(void) {
  for (int end = 0; end < 2; end++) {
    const double v = end ? -0.3 : 0.3, vx = 0.01 - 0.6 * v, vy = -0.02 - 0.8 * v;
    const double before = pow(0.01 + 0.6 * v, 2) + pow(-0.02 + 0.8 * v, 2);
    struct nb_solution solution;
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(
        solve(&solution, "wall_end", end ? HITS("13", "0", "-0.3", "0") : HITS("-4", "0", "0.3", "0"), &error), NB_OK);
    const struct expected expected[] = {
        {"D.vx", vx}, {"D.vy", vy}, {"C.overlap max", 0.15}, {"energy.walls", 2.5 * (vx * vx + vy * vy - before)}};
    CU_ASSERT_EQUAL(solution.value_count, 4);
    for (int k = 0; k < 4; k++) {
      const double *value = solution_find(&solution, expected[k].name);
      CU_ASSERT(value && fabs(*value - expected[k].value) <= 1e-9 * fabs(expected[k].value));
    }
    solution_free(&solution);
  }
#define TOWARD "a particle that moves toward the end of the wall"
#define BESIDE "a particle that touches the end only, not the wall beside it"
  static const struct part parts[] = {
      {HITS("13", "1.99", "-0.01", "0"), NULL},   {HITS("13", "2.01", "-0.01", "0"), TOWARD},
      {HITS("13", "-1.99", "-0.01", "0"), NULL},  {HITS("13", "-2.01", "-0.01", "0"), TOWARD},
      {HITS("13", "0", "0.01", "0"), TOWARD},     {HITS("12.01", "0", "-0.01", "0"), NULL},
      {HITS("11.99", "0", "-0.01", "0"), TOWARD}, {HITS("-2.01", "0", "0.01", "0"), NULL},
      {HITS("-1.99", "0", "0.01", "0"), TOWARD},  {HITS("10.01", "4", "0", "-0.001"), NULL},
      {HITS("9.99", "4", "0", "-0.001"), BESIDE}, {HITS("-0.01", "-4", "0", "0.001"), NULL},
      {HITS("0.01", "-4", "0", "0.001"), BESIDE}, {HITS("10.1", "2.5", "0", "-2"), NULL},
      {HITS("10.5", "4", "-1", "-4"), BESIDE},    {HITS("0.5", "4", "-0.01", "-0.02"), NULL},
      {HITS("9.5", "4", "0.01", "-0.02"), NULL},  {HITS("2.5", "2.6", "-0.01", "-0.00236"), NULL}};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    check_message("wall_end", parts[k].text, parts[k].message);
#undef TOWARD
#undef BESIDE
}

/* Nine discs of a square lattice with the spacing 1.999. */
#define SQUARE(disc, size, step, stages)                                                                               \
  "material m density 2 kn 9 ks 4 friction 1\nmaterial n density 2 kn 9 ks 4 friction 1\nnormal linear\nshear "        \
  "linear\n"                                                                                                           \
  "lattice discs 3 by 2 from 1 1 radius 1 spacing 1.999 m\nlattice discs 2 by 1 from 1 (1 + 2*1.999) radius 1 "        \
  "spacing "                                                                                                           \
  "1.999 m\ndisc " disc "\nperiodic cell 0 0 to " size "\nstep " step "\nstage s\n" stages
static void servo_lattice(void) {
#define AT "(1 + 2*1.999) (1 + 2*1.999) radius 1 m"
#define SIZE "5.997 5.997"
#define FITS                                                                                                           \
  "a square lattice of equal discs in a rectangular cell, a step given as a time, and stages that strain the cell "    \
  "without rotation, or control it with a servo, at rates in 1/s"
#define STRAINS "cell strain 0.01 0.02 shear 0.03\ncycles 1\n"
  PARTS("servo_lattice", SQUARE("@", SIZE, "0.1", STRAINS), {AT, NULL},
        {"(1 + 2*1.999) (1 + 2*1.999) radius 1.0001 m", FITS}, {"(1 + 2*1.999) (1 + 2*1.999) radius 0.9999 m", FITS},
        {"(1 + 2*1.999) (1 + 2*1.999) radius 1 n", FITS}, {"(1 + 2*1.999 + 2.1e-9) (1 + 2*1.999) radius 1 m", FITS},
        {"(1 + 2*1.999 + 1.9e-9) (1 + 2*1.999 - 1.9e-9) radius 1 m", NULL},
        {"(1 + 2*1.999) (1 + 2*1.999 - 2.1e-9) radius 1 m", FITS}, {AT "\ndisc 2 3 radius 0.1 m", FITS});
  PARTS("servo_lattice", SQUARE(AT, "@", "0.1", STRAINS), {"5.997 11.994", FITS}, {"11.994 5.997", FITS});
  PARTS("servo_lattice", SQUARE(AT, SIZE, "@", STRAINS), {"0.1", NULL}, {"0.1 of stable", FITS});
#define ISOTROPIC "servo isotropic 3 on cell through cell at most 0.1 "
  PARTS("servo_lattice", SQUARE(AT, SIZE, "0.1", "@"), {"cell strain 0.01 0.02 c12 0.03\ncycles 1\n", FITS},
        {"cell strain 0.01 0.02 c21 0.03\ncycles 1\n", FITS},
        {"cell strain 0.01 per cycle 0 per cycle\ncycles 1\n", FITS}, {ISOTROPIC "every 1 cycle\ncycles 1\n", NULL},
        {ISOTROPIC "per cycle every 1 cycle\ncycles 1\n", FITS},
        {STRAINS "stage t\n" ISOTROPIC "per cycle every 1 cycle\ncycles 1\n", FITS});
#undef AT
#undef SIZE
#undef FITS
#undef STRAINS
#undef ISOTROPIC
}

#define RING(own, stages)                                                                                              \
  "material m density 2 kn 9\nnormal linear\nsphere 1 2 radius 1 m" own                                                \
  "\nsphere 9 2 radius 1 m\nsphere 1 10 radius 1 m\n"                                                                  \
  "sphere -7 2 radius 1 m\nsphere 1 -6 radius 1 m\nboundary circle 1 2 radius 8\nmonitor D sphere 1\nstep "            \
  "0.1\n" stages
static void ring_strain(void) {
#define SAME                                                                                                           \
  "one stage with the same symmetric strain per cycle in `boundary strain` and `affine strain`, and a step given as "  \
  "a "                                                                                                                 \
  "time"
#define DAMPED                                                                                                         \
  "`damping con1` if particles have velocities, and for `accumulated` without damping and with particles at rest"
#define BOTH(of, more) "stage s\nboundary strain " of "\naffine strain " of more "\ncycles 3\n"
#define STRAIN "1e-3 per cycle -2e-3 per cycle shear 4e-4 per cycle"
  PARTS("ring_strain", RING("", "@"), {BOTH(STRAIN, ""), NULL}, {BOTH("1e-3 -2e-3 shear 4e-4", ""), SAME},
        {BOTH("1e-3 per cycle -2e-3 per cycle c12 4e-4 per cycle", ""), SAME},
        {BOTH("1e-3 per cycle -2e-3 per cycle c21 4e-4 per cycle", ""), SAME},
        {BOTH(STRAIN, "") "stage t\ncycles 1\n", SAME}, {BOTH(STRAIN, " accumulated"), NULL},
        {"damping con1 0.9 as velocity\n" BOTH(STRAIN, ""), NULL},
        {"damping con1 0.9 as velocity\n" BOTH(STRAIN, " accumulated"), DAMPED},
        {"damping con1 1 as velocity\n" BOTH(STRAIN, " accumulated"), NULL});
  PARTS("ring_strain", RING(" velocity 0 -1e-9", "@"), {BOTH(STRAIN, ""), DAMPED},
        {"damping con1 0.9 as cs79\n" BOTH(STRAIN, ""), NULL}, {BOTH(STRAIN, " accumulated"), DAMPED});
  /* From rest, a symmetric strain e per cycle: x_N = A^N x_0, and the area by det A. With CON1 of CS79 a velocity keeps
   * k = g/(2 - g). The inner sphere is at (1.5, 1) from the centre and has the mass 8 pi/3. */
  const double xx = 1e-3, yy = -2e-3, xy = 4e-4, keep = 0.9 / 1.1, mass = 8 * pi / 3;
  double x = 1.5, y = 1, ox = 8, oy = 0, vx = 0.3, vy = -0.1, area = 128;
  for (int n = 0; n < 3; n++) { /* the positions move by the strain and by the velocity over the step */
    vx *= keep, vy *= keep;
    const double nx = x + xx * x + xy * y + 0.1 * vx, ny = y + xy * x + yy * y + 0.1 * vy;
    x = nx, y = ny, area *= (1 + xx) * (1 + yy) - xy * xy;
    const double px = ox + xx * ox + xy * oy, py = oy + xy * ox + yy * oy;
    ox = px, oy = py;
  }
  const double energy = mass / 2 * (0.09 + 0.01) * pow(keep, 6) * pow((1 + keep) / 2, 2);
  VALUES("ring_strain",
         "material m density 2 kn 9\nnormal linear\nsphere 2.5 3 radius 1 m velocity 0.3 -0.1\nsphere 9 2 radius 1 m\n"
         "sphere 1 10 radius 1 m\nsphere -7 2 radius 1 m\nsphere 1 -6 radius 1 m\nboundary circle 1 2 radius 8\n"
         "monitor D sphere 1\nmonitor E sphere 2\nmonitor C sphere 1 with sphere 2\nstep 0.1\ndamping con1 0.9 as "
         "cs79\n" BOTH(STRAIN, ""),
         1, {"D.x", 1 + x, "cycle", 3}, {"D.y", 2 + y, "cycle", 3}, {"E.x", 1 + ox, "cycle", 3},
         {"E.y", 2 + oy, "cycle", 3}, {"boundary.area", area, "cycle", 3}, {"energy.kinetic", energy, "cycle", 3},
         {"energy.kinetic", mass / 2 * 0.1, "cycle", 0}, {"boundary.area", 128, "cycle", 0}, {"D.x", 2.5, "cycle", 0});
#undef SAME
#undef DAMPED
#undef BOTH
#undef STRAIN
}

/* A spinning sphere slides throughout its impact on a wall that rises along (0.8, 0.6), at psi1 = 4.5 chi: J_t = mu J_n, so
 * V_T decreases by 7/2 mu (1 + e) V_N. Its mass is 4 pi/3 R^3 rho, and I = 2/5 m R^2. The wall has no spin. */
#define REBOUNDS(angle)                                                                                                \
  "material a density 3 kn 8 ks 4 friction 0.1\nmaterial b kn 12 ks 9 friction 0.3\nnormal linear\nshear linear\n"     \
  "damping ratio 0.2\nsphere (7 - 0.6*5) (1 + 0.8*5) radius 2 a spin 0.05\nwall w (7 - 8) (1 - 6) to (7 + 8) (1 + 6) " \
  "b\n"                                                                                                                \
  "monitor D sphere 1\nmonitor C sphere 1 with wall w\nimpact C speed 0.3 angle " angle "\nstep 100 per collision\n"   \
  "stage s\nuntil impact.time above 1.1 at most 999 cycles\n"
static void rebound(void) {
  const double mu = 0.1, e = exp(-pi * 0.2 / sqrt(1 - 0.04)), mass = 4 * pi / 3 * 8 * 3, inertia = 0.4 * mass * 4;
  const double kappa = (1 / (1. / 16 + 1. / 24)) / (1 / (1. / 8 + 1. / 18)), chi = 3.5 / (2 * kappa);
  /* V_T = 0.3 sin(A) + R w is 1.125 7 mu V_N, and V_N = 0.3 cos(A) */
  double low = 0, high = pi / 2;
  for (int n = 0; n < 100; n++) {
    const double middle = (low + high) / 2;
    *(0.3 * sin(middle) + 2 * 0.05 < 1.125 * 7 * mu * 0.3 * cos(middle) ? &low : &high) = middle;
  }
  const double vt = 0.3 * sin(low), vn = 0.3 * cos(low), jt = mu * (1 + e) * vn; /* J_t/m */
  const double along = vt - jt, away = e * vn, spin = 0.05 - 2 * jt * mass / inertia;
  char page[1024];
  snprintf(page, sizeof page, REBOUNDS("%.17g"), low);
  VALUES("rebound", page, 1, {"D.vx", 0.8 * along - 0.6 * away}, {"D.vy", 0.6 * along + 0.8 * away}, {"D.spin", spin},
         {"impact.psi1", 4.5 * chi}, {"impact.psi2", 4.5 * chi - 2 * chi * (1 + e)},
         {"impact.restitution", hypot(along, away) / 0.3},
         {"energy.kinetic", (mass * (along * along + away * away) + inertia * spin * spin) / 2},
         {"energy.kinetic max", (mass * 0.09 + inertia * 0.0025) / 2});
}

/* Two discs in a row along (0.6, 0.8) between walls that move inward at 0.01. Displacements along the row, from disc 1 to
 * disc 2; the springs are 30, 20 and 120/13, and the masses 5 and 1.25. */
#define INCLINED_ROW(more)                                                                                             \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ndisc 3 4 radius 2 m\n"       \
  "disc (3 + 1.8) (4 + 2.4) radius 1 m\nwall p (3 - 1.2 - 8) (4 - 1.6 + 6) to (3 - 1.2 + 8) (4 - 1.6 - 6) a\n"         \
  "wall q (3 + 2.4 + 8) (4 + 3.2 - 6) to (3 + 2.4 - 8) (4 + 3.2 + 6) b\nmonitor D disc 1\nmonitor E disc 2\n"          \
  "monitor A disc 1 with wall p\nmonitor B disc 2 with disc 1\nmonitor C disc 2 with wall q\nmonitor W wall p\n"       \
  "step 0.1\nstage s\nwall p velocity 0.006 0.008\nwall q velocity -0.006 -0.008\ncycles 4\nstage t\nwalls stop\n"     \
  "cycles 9\n" more
static void two_walls(void) {
  const double k[3] = {30, 20, 120. / 13}, force = 2 * 0.04 * 0.1 / (1 / k[0] + 1 / k[1] + 1 / k[2]);
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(solve(&solution, "two_wall_compression", INCLINED_ROW(""), &error), NB_OK);
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
  VALUES("two_wall_statics", INCLINED_ROW(""), 0, {"A.normal", force}, {"A.normal mean", force},
         {"A.overlap", force / k[0]}, {"A.shear", 0}, {"B.normal", force}, {"B.normal mean", force},
         {"B.overlap", force / k[1]}, {"B.shear", 0}, {"C.normal", force}, {"C.normal mean", force},
         {"C.overlap", force / k[2]}, {"C.shear", 0});
}

/* Seven equal spheres of R = 1 and E* = 5/1.92: every contact has N = 3^(1/2)/4 p d h with h = 2, at the distance d. The
 * last of three stages counts. */
#define SEVEN(stages)                                                                                                  \
  "material g density 3 young 5 poisson 0.2\nnormal hertz\nsphere 0 0 radius 1 g\nsphere 2 0 radius 1 g\n"             \
  "sphere 1 (sqrt(3)) radius 1 g\nsphere -1 (sqrt(3)) radius 1 g\nsphere -2 0 radius 1 g\n"                            \
  "sphere -1 (-sqrt(3)) radius 1 g\nsphere 1 (-sqrt(3)) radius 1 g\nboundary circle 0 0 radius 1.5\n"                  \
  "monitor A sphere 1 with sphere 2\nmonitor B sphere 7 with sphere 2\nmonitor D sphere 1\nstep 0.1\n"                 \
  "stage s\nboundary stress 0.3 0.4\ncycles 1\nstage t\nboundary stress 0.05 0.05\ncycles 1\n" stages
static void stress_ring(void) {
  double low = 1, high = 2;
  for (int n = 0; n < 100; n++) {
    const double d = (low + high) / 2, overlap = 4. / 3 * 5 / 1.92 * sqrt(0.5) * pow(2 - d, 1.5);
    *(overlap > sqrt(3) / 4 * 0.02 * d * 2 ? &low : &high) = d;
  }
  const double force = sqrt(3) / 4 * 0.02 * low * 2;
  VALUES("stress_ring", SEVEN("stage u\nboundary stress 0.02 0.02\ncycles 1\n"), 100, {"A.normal in u", force},
         {"B.normal in u", force}, {"boundary.radius in u", low}, {"boundary.roughness in u", 0},
         {"boundary.area in u", 1.5 * sqrt(3) * low * low}, {"boundary.stress.mean in u", 0.02});
#define ISOTROPIC "six spheres of two sizes in turn around a seventh, and an isotropic boundary stress"
  PARTS("stress_ring", SEVEN("@"), {"", NULL}, {"stage u\nboundary stress 0.02 0.03\ncycles 1\n", ISOTROPIC},
        {"stage u\nboundary stress 0.02 0.02 shear -0.001\ncycles 1\n", ISOTROPIC}, {"stage u\ncycles 1\n", ISOTROPIC});
#undef ISOTROPIC
}

/* A contact of two spheres with R* = 1.2, mu = 0.8 and k_s = 15. */
#define TOUCHES(law, path)                                                                                             \
  "path\nmaterial a young 4 poisson 0.25 ks 30 friction 0.8\nmaterial b young 6 poisson 0.2 ks 10 friction 0.9\n"      \
  "contact sphere 2 a with sphere 3 b\nnormal hertz\nshear " law                                                       \
  "\nrecord step overlap slip normal shear work.shear\n"                                                               \
  "segment p overlap to 0.04 in 2 steps\n" path
static double hertz(double overlap) { return 4. / 3 / (0.9375 / 4 + 0.96 / 6) * sqrt(1.2) * pow(overlap, 1.5); }
/* 8 G* sqrt(R*), and mu kappa: the tangential displacement over the overlap at which a contact slides. */
static double mindlin_stiffness(void) { return 8 / (1.75 / 1.6 + 1.8 / 2.5) * sqrt(1.2); }
static double mindlin_limit(void) { return 0.8 * (1.75 / 1.6 + 1.8 / 2.5) / (0.9375 / 4 + 0.96 / 6) / 4; }

/* The stiffness is k_s, or 8 G* a. In segment r, alpha and delta change at once; in s the scaled law keeps T/a. */
static void path_no_slip(void) {
  static const char *const names[] = {"linear", "mindlin", "mindlin_scaled"};
  for (int law = 0; law < 3; law++) {
    char page[1024];
    const double k = mindlin_stiffness(), q = law ? k * sqrt(0.04) : 15, t = law ? k * sqrt(0.0625) : 15;
    const double mean = law ? k * 2 / 3 * (pow(0.09, 1.5) - pow(0.04, 1.5)) / 0.05 : 15;
    const double tq = -0.001 * q, tr = tq + mean * 0.003, ts = law == 2 ? tr * sqrt(0.0625 / 0.09) : tr, tt = -0.004;
    /* in segment r the force is T + c (alpha^(3/2) - 0.04^(3/2)) */
    const double c = k * 2 / 3 / 0.05 * 0.003;
    const double average =
        law ? tq - c * pow(0.04, 1.5) + c * 0.4 * (pow(0.09, 2.5) - pow(0.04, 2.5)) / 0.05 : (tq + tr) / 2;
    const double wq = tq * tq / q / 2, wr = wq + average * 0.003, wt = wr + (tt * tt - ts * ts) / t / 2;
    const double slip = 0.002 + (tt - ts) / t;
    snprintf(page, sizeof page,
             TOUCHES("%s", "segment q slip to -0.001 in 4 steps\nsegment r overlap to 0.09 slip by 0.003 in 1 step\n"
                           "segment s overlap to 0.0625 in 1 step\nsegment t shear to -0.004 hold normal in 2 steps\n"),
             names[law]);
    VALUES("path_no_slip", page, 1e3, {"slip in p", 0}, {"shear in p", 0}, {"work.shear in p", 0},
           {"slip in q", -0.001}, {"shear in q", tq}, {"work.shear in q", wq}, {"slip in r", 0.002}, {"shear in r", tr},
           {"work.shear in r", wr}, {"slip in s", 0.002}, {"shear in s", ts}, {"work.shear in s", wr},
           {"slip in t", slip}, {"shear in t", tt}, {"work.shear in t", wt}, {"slip", slip}, {"shear", tt},
           {"work.shear", wt}, {"slip", -0.00025, "step", 3}, {"shear", tq / 4, "step", 3},
           {"work.shear", wq / 16, "step", 2.6}, {"work.shear", wq / 16, "step", 3.4},
           {"shear", (ts + tt) / 2, "step", 9}, {"shear", 0, "step", 0});
    /* the limit is mu N, also for T < 0 */
    const double largest = 0.8 * hertz(0.04) / (law ? k * sqrt(0.04) : 15);
    for (int over = 0; over < 2; over++)
      for (int sign = -1; sign < 2; sign += 2) {
        snprintf(page, sizeof page, TOUCHES("%s", "segment q slip to %.17g in 3 steps\n"), names[law],
                 sign * largest * (over ? 1.0001 : 0.9999));
        check_message("path_no_slip", page, over ? "a path without sliding" : NULL);
      }
  }
}

/* Integral of 1 - (1 - x/L)^(3/2) from 0 to x. */
static double mindlin_work(double x, double length) { return x - 0.4 * length * (1 - pow(1 - x / length, 2.5)); }
static double mindlin_force(double x, double length) { return 1 - pow(1 - x / length, 1.5); }

/* Loading, unloading and reloading at constant N in Mindlin and Deresiewicz's closed form, and gross sliding. In loading
 * a part of the contact at the distance y from the middle slips against l = mu kappa (alpha - y^2/R*) and dissipates
 * 4 G* l (delta - l) dy. */
static void path_springs(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, d = 0.6 * length, back = 0.9 * length;
  const double tq = n * mindlin_force(d, length), wq = n * mindlin_work(d, length);
  const double tr = tq - 2 * n * mindlin_force(back, 2 * length);
  const double wr = wq - tq * back + 2 * n * mindlin_work(back, 2 * length);
  double lost = 0;
  for (int k = 0; k < 20000; k++) {
    const double y = sqrt(1.2 * 0.04) * (k + 0.5) / 20000, l = mindlin_limit() * (0.04 - y * y / 1.2);
    lost += l < d ? 2 * mindlin_stiffness() / sqrt(1.2) / 2 * l * (d - l) * sqrt(1.2 * 0.04) / 20000 : 0;
  }
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("mindlin_deresiewicz",
                   "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 5 steps\n"
                   "segment s shear to %.17g hold normal in 5 steps\n"
                   "segment t slip by %.17g in 5 steps\nsegment u overlap to -0.01 in 3 steps\n"),
           d, -back, tq, -9 * length);
#define AT(segment, delta, force, stored, dissipated)                                                                  \
  {"overlap in " segment, 0.04}, {"slip in " segment, delta}, {"normal in " segment, hertz(0.04)},                     \
      {"shear in " segment, force}, {"traction.force in " segment, force}, {"stored.shear in " segment, stored},       \
      {"dissipated in " segment, dissipated}, {                                                                        \
    "work.shear in " segment, (stored) + (dissipated)                                                                  \
  }
  /* unloading from T* dissipates the same as loading by half of it with twice the limits: the loop is that of twice lost */
  const double end = d - 9 * length;
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(solve(&solution, "path_springs", page, &error), NB_OK);
  const struct expected expected[] = {AT("p", 0, 0, 0, 0),     AT("q", d, tq, wq - lost, lost),
                                      {"slip in r", d - back}, {"shear in r", tr},
                                      {"work.shear in r", wr}, {"slip in s", d},
                                      {"shear in s", tq},      {"slip in t", end},
                                      {"shear in t", -n},      {"shear in u", 0},
                                      {"normal in u", 0},      {"overlap in u", 0},
                                      {"slip in u", end},      {"stored.shear in u", 0}};
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    const double *value = solution_find(&solution, expected[k].name);
    const bool right =
        value && fabs(*value - expected[k].value) <= 2e-6 * n * (strstr(expected[k].name, "shear") ? 1 : length);
    if (!right)
      printf("# %s is %.12g, expected %.12g\n", expected[k].name, value ? *value : NAN, expected[k].value);
    CU_ASSERT(right);
  }
  /* sliding at mu N: work and dissipation increase at the same rate, and the stored energy is that of full deflection */
  const struct nb_solution_curve *work = solution_find_curve(&solution, "work.shear", "step");
  const struct nb_solution_curve *dissipated = solution_find_curve(&solution, "dissipated", "step");
  const double slid = 9 * length / 5 * n;
  NEAR(work->at(work->data, 22) - work->at(work->data, 21), slid, 1e-6);
  NEAR(dissipated->at(dissipated->data, 22) - dissipated->at(dissipated->data, 21), slid, 1e-6);
  solution_free(&solution);
#undef AT
}

/* No slip leads to a shear force above mu N, so that segment has no values, and there is no curve. */
static void forces_above_the_limit(void) {
  for (int over = 0; over < 2; over++)
    for (int sign = -1; sign < 2; sign += 2) {
      struct nb_solution solution;
      struct nb_error error = {0};
      char page[1024];
      snprintf(page, sizeof page, TOUCHES("mindlin_deresiewicz", "segment q shear to %.17g hold normal in 3 steps\n"),
               sign * (over ? 1.001 : 0.999) * 0.8 * hertz(0.04));
      CU_ASSERT_EQUAL(solve(&solution, "path_springs", page, &error), NB_OK);
      CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "shear in p"));
      CU_ASSERT_EQUAL(solution_find(&solution, "shear in q") != NULL, !over);
      CU_ASSERT_EQUAL(solution_find(&solution, "shear") != NULL, !over);
      CU_ASSERT_EQUAL(solution_find_curve(&solution, "shear", "step") != NULL, !over);
      solution_free(&solution);
    }
}

/* [R89 3.95-3.97] at constant N, then a constant T and a deficit while N increases, and N u = N(zeta) while it
 * decreases. */
static void path_randall(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, u = length / 10;
  const double tq = n * mindlin_force(5 * u, length), wq = n * mindlin_work(5 * u, length);
  const double tr = tq - 2 * n * mindlin_force(6 * u, 2 * length);
  const double wr = wq - tq * 6 * u + 2 * n * mindlin_work(6 * u, 2 * length);
  const double ts = tr + 2 * n * mindlin_force(3 * u, 2 * length);
  const double ws = wr + tr * 3 * u + 2 * n * mindlin_work(3 * u, 2 * length);
  const double tt = tr + 2 * n * mindlin_force(2 * u, 2 * length); /* re-unloading goes back along it */
  const double wt = wr + tr * 2 * u + 2 * n * mindlin_work(2 * u, 2 * length);
  const double stiff = mindlin_stiffness() * sqrt(0.05), deficit = mindlin_limit() * 0.01;
  const double tw = tq + stiff * deficit / 2, ww = wq + (tq + tw) / 2 * deficit / 2;
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment s slip by %.17g in 1 step\nsegment t slip by %.17g in 2 steps\n"),
           5 * u, -6 * u, 3 * u, -u);
#define AT(segment, delta, force, work)                                                                                \
  {"slip in " segment, delta}, {"shear in " segment, force}, {"work.shear in " segment, work}
#define LAST(delta, force, work)                                                                                       \
  {"slip", delta}, {"shear", force}, {"work.shear", work}, {"slip", delta, "step", 13}, {"shear", force, "step", 13},  \
  {                                                                                                                    \
    "work.shear", work, "step", 13                                                                                     \
  }
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("s", 2 * u, ts, ws),
         AT("t", u, tt, wt), LAST(u, tt, wt));
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment v overlap to 0.05 in 4 steps\n"
                              "segment w slip by %.17g in 2 steps\n"),
           5 * u, deficit / 2);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("v", 5 * u, tq, wq),
         AT("w", 5 * u + deficit / 2, tw, ww), LAST(5 * u + deficit / 2, tw, ww));
  const double td = tt - stiff * deficit / 2, wd = wt - (tt + td) / 2 * deficit / 2; /* the same in re-unloading */
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment s slip by %.17g in 1 step\nsegment t slip by %.17g in 2 steps\n"
                              "segment v overlap to 0.05 in 1 step\nsegment w slip by %.17g in 1 step\n"),
           5 * u, -6 * u, 3 * u, -u, -deficit / 2);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("s", 2 * u, ts, ws),
         AT("t", u, tt, wt), AT("v", u, tt, wt), AT("w", u - deficit / 2, td, wd), {"slip", u - deficit / 2},
         {"shear", td}, {"work.shear", wd}, {"slip", u, "step", 14}, {"shear", tt, "step", 14},
         {"work.shear", wt, "step", 14});
  /* zeta decreases with alpha in loading, and by half as much in unloading */
  const double zeta = 0.04 * pow(1 - tq / n, 2. / 3) - 0.005;
  const double half = 0.04 * pow(1 - (tq - tr) / (2 * n), 2. / 3) - 0.0025;
  const double m = 0.8 * hertz(0.035), tx = m - 0.8 * hertz(zeta);
  const double ty = tq - (n - m) - 2 * (m - 0.8 * hertz(half)); /* T* decreases by mu |dN| */
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment x overlap to 0.035 in 6 steps\n"), 5 * u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("x", 5 * u, tx, wq),
         LAST(5 * u, tx, wq));
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment x overlap to 0.035 in 3 steps\n"),
           5 * u, -6 * u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("x", -u, ty, wr),
         LAST(-u, ty, wr));
#undef LAST
#undef AT
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
    CU_ASSERT_EQUAL(solve(&solution, "rayleigh_step", page, &error), NB_OK);
    CU_ASSERT_EQUAL(solution_find(&solution, "D.vx") != NULL, k == 0);
    solution_free(&solution);
  }
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

/* A disc of mass 5 on a spring of k = 20 falls from the height 1 above the contact with g = 0.5, so w = 2 and it hits the
 * floor with the speed 1. */
#define FALLS                                                                                                          \
  "material m density (5/(4*pi)) kn 30\nmaterial f kn 15\nnormal linear\ngravity 0 %s\ndamping ratio %s\n"             \
  "disc 7 %s radius 2 m\nwall f 9 3 to 5 3 f\nmonitor D disc 1\nmonitor C disc 1 with wall f\nstep 0.001\nstage s\n"   \
  "cycles 1\n"
static double fall(const char *g, const char *ratio, const char *y, const char *name, double t) {
  struct nb_solution solution;
  struct nb_error error;
  char page[1024];
  snprintf(page, sizeof page, FALLS, g, ratio, y);
  CU_ASSERT_EQUAL(solve(&solution, "free_fall", page, &error), NB_OK);
  const struct nb_solution_curve *curve = solution_find_curve(&solution, name, "time");
  const double *value = solution_find(&solution, name);
  const double found = curve ? curve->at(curve->data, t) : value ? *value : NAN;
  solution_free(&solution);
  return found;
}
static void free_fall(void) {
  const double w = 2, g = 0.5, sag = g / (w * w), touch = 2, v = 1, lasts = 2 / w * (pi - atan(v * w / g));
  NEAR(fall("-0.5", "0", "6", "D.y", 1), 5.75, 1e-12);
  NEAR(fall("-0.5", "0", "6", "D.vy", 1), -0.5, 1e-12);
  NEAR(fall("-0.5", "0", "6", "C.overlap max", 0), sag + hypot(sag, v / w), 1e-12);
  NEAR(fall("-0.5", "0", "6", "D.y", touch + lasts / 2), 5 - sag - hypot(sag, v / w), 1e-12);
  NEAR(fall("-0.5", "0", "6", "D.vy", touch + lasts), v, 1e-9);
  NEAR(fall("-0.5", "0", "6", "D.y", 2 * touch + lasts), 6., 1e-12);
  NEAR(fall("-0.5", "0", "6", "D.y", 5 * (2 * touch + lasts) + 1), 5.75, 1e-12); /* after five bounces */
  NEAR(fall("0.5", "0", "6", "D.y", 4), 10., 1e-12);                             /* upward */
  CU_ASSERT(isnan(fall("0.5", "0", "6", "C.overlap max", 0)));
  NEAR(fall("-0.5", "0", "5", "D.y", pi / w), 5 - 2 * sag, 1e-12); /* it just touches, and does not separate */
  NEAR(fall("-0.5", "0", "5", "D.y", 2.5 * pi / w), 5 - sag, 1e-12);
  NEAR(fall("-0.5", "0.9", "5.001", "D.y", 99), 5 - sag, 1e-12);
  /* With a dashpot of a fifth of the critical damping: the contact by the midpoint rule, from u = 0 with the speed -1. */
  double u = 0, s = -v, low = 0, t = 0;
  const double dt = 1e-5, c = 2 * 0.2 * w;
  while (u <= 0 && t < 9) {
    const double um = u + dt / 2 * s, sm = s + dt / 2 * (-g - w * w * u - c * s);
    u += dt * sm, s += dt * (-g - w * w * um - c * sm), t += dt;
    low = fmin(low, u);
    if (fabs(t - 0.4) < dt / 2)
      NEAR(fall("-0.5", "0.2", "6", "D.y", touch + t), 5 + u, 1e-9);
  }
  NEAR(fall("-0.5", "0.2", "6", "C.overlap max", 0), -low, 1e-8);
  NEAR(fall("-0.5", "0.2", "6", "D.vy", touch + t + 0.01), s - g * 0.01, 1e-4);
  NEAR(fall("-0.5", "0.2", "6", "D.vy", touch + t - 0.01), s + (g + c * s) * 0.01, 1e-3);
#define KIND "a particle dropped straight down, from rest, above the wall"
#define ON_FLOOR(gx, y, ratio, wall)                                                                                   \
  "material m density 1 kn 20\nnormal linear\ngravity " gx " -0.5\ndamping ratio " ratio "\ndisc 7 " y                 \
  " radius 2 m\nwall f " wall " m\nstep 0.001\nstage s\ncycles 1\n"
  PARTS("free_fall", "@", {ON_FLOOR("0", "5", "0.5", "9 3 to 5 3"), NULL},
        {ON_FLOOR("0", "4.999", "0.5", "9 3 to 5 3"), KIND}, {ON_FLOOR("0.1", "6", "0.5", "9 3 to 5 3"), KIND},
        {ON_FLOOR("-0.1", "6", "0.5", "9 3 to 5 3"), KIND},
        {ON_FLOOR("0", "6", "1.001", "9 3 to 5 3"), "less than critical damping"},
        {ON_FLOOR("0", "6", "0.999", "9 3 to 5 3"), NULL},
        {ON_FLOOR("0", "6", "0.5", "6.99 3 to -9 3"), "a wall along x, below the particle"},
        {ON_FLOOR("0", "6", "0.5", "7.01 3 to -9 3"), NULL},
        {ON_FLOOR("0", "6", "0.5", "7.01 3 to 20 3"), "a wall along x, below the particle"},
        {ON_FLOOR("0", "6", "0.5", "6.99 3 to 20 3"), NULL});
#undef KIND
}

/* Two discs of radius 1 and three of radius 0.5 in a box. */
#define FILLED(more)                                                                                                   \
  "material m density 1 kn 9\nnormal linear\ngrading g 1 2 0.5 3\n" more                                               \
  "fill discs box 1 2 to 11 8 g m seed 3 attempts 999 else stop\nmonitor S grading g radius 0.5\nmonitor G grading "   \
  "g\n"                                                                                                                \
  "monitor D disc 1\nregion R box 1 2 to 11 8\nregion X box 1.1 2 to 11 8\nregion Y box 1 2.1 to 11 8\n"               \
  "region XX box 0 2 to 12 8\nregion YY box 1 1 to 11 9\nregion C circle 6 5 radius 5\n"                               \
  "step 1\nrecord R.porosity\nstage s\ncycles 1\n"
static void filling(void) {
  VALUES(
      "filling",
      "material m density 1 kn 9\nnormal linear\ngrading g 1 1\nfill discs circle 3 4 radius 5 g m seed 3 attempts 9 "
      "else stop\nregion C circle 3 4 radius 5\nregion X circle 3.1 4 radius 5\nregion Y circle 3 4.1 radius 5\n"
      "region R circle 3 4 radius 5.1\nregion B box -2 -1 to 8 9\nstep 1\nrecord C.porosity\nstage s\ncycles 1\n",
      0, {"C.porosity", 1 - 1. / 25});
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
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("filling", &scene);
  const struct nb_particle *a = &it.scene.particles[0], *b = &it.scene.particles[1];
  REFS_NEAR(refs_value(&solution, "gap"), hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius, 1e-12, 1.);
  solution_free(&solution);
  written_free(&it);
}

/* Nine discs in a periodic cell. Only the last disc differs, or its velocity. */
#define CELL_OF(w, h, friction)                                                                                        \
  "material a density 1 kn 9 ks 4 friction " friction "\nmaterial b density 1 kn 8 ks 4 friction 1e9\n"                \
  "normal linear\nshear linear\nperiodic cell 0 0 to " w " " h "\n"
#define EIGHT                                                                                                          \
  "lattice discs 3 by 2 from 1 1 radius 1 spacing 1.95 a\nlattice discs 2 by 1 from 1 4.9 radius 1 spacing 1.95 a\n"
#define WAVE "perturb wave 1e-3 2e-3 periods 1 1\nmonitor D disc 2\nstep 0.1\nstage s\ncycles 1\n"
/* Without rotation a wave in a square lattice has the displacements in x and y as modes, see lattice_waves.c. Disc 3 is above
 * disc 1, which is at (1, 1) from the corner of the cell; the phase is 0 in its centre. */
static void waves_of(int nx, int ny) {
  char page[1024];
  const double s = 1.95, mass = pi, across = 4 - 9 * (2 - s) / s, x = 2 * (1 - cos(2 * pi * nx / 3.)),
               y = 2 * (1 - cos(2 * pi * ny / 3.));
  const double wave = sin(2 * pi * (nx * (1 - 1.5 * s) + ny * (1 + 0.5 * s)) / (3 * s)), t = 0.7;
  snprintf(page, sizeof page,
           "material a density 1 kn 9 ks 4 friction 1e9\nnormal linear\nshear linear\nperiodic cell 2 3 to 7.85 8.85\n"
           "lattice discs 1 by 3 from 3 4 radius 1 spacing 1.95 a\nlattice discs 1 by 3 from 4.95 4 radius 1 spacing "
           "1.95 a\n"
           "lattice discs 1 by 3 from 6.9 4 radius 1 spacing 1.95 a\nperturb wave 1e-3 2e-3 periods %d %d\n"
           "monitor D disc 3\nmonitor C disc 1 with disc 2\nstep 0.1\nstage s\nrotation off\ncycles 1\n",
           nx, ny);
  VALUES("lattice_waves", page, 1e-3, {"D.vx", 1e-3 * wave * cos(sqrt((9 * x + across * y) / mass) * t), "time", t},
         {"D.vy", 2e-3 * wave * cos(sqrt((9 * y + across * x) / mass) * t), "time", t}, {"D.spin", 0, "time", t});
}
static void lattice_waves(void) {
  waves_of(0, 1), waves_of(1, 0), waves_of(1, 1), waves_of(1, -1);

#define NINTH(disc) CELL_OF("5.85", "5.85", "1e6") EIGHT disc "\n" WAVE
#define NEAREST "a lattice in which every particle overlaps four or six others"
#define SINE "initial velocities that are one sine wave"
#define LATTICE(w, h, lattice) CELL_OF(w, h, "1e9") "lattice discs " lattice " a\n" WAVE
  PARTS(
      "lattice_waves", "@", {NINTH("disc 4.9 4.9 radius 1 a"), NULL},
      {NINTH("disc 4.9 4.9 radius 0.999 a"), "equal particles"}, {NINTH("disc 4.9 4.9 radius 1 b"), "equal particles"},
      {NINTH("sphere 4.9 4.9 radius 1 a"), "equal particles"}, {NINTH("disc 4.9 4.9 radius 1 a velocity 1e-9 0"), SINE},
      {NINTH("disc 4.9 4.9 radius 1 a velocity 0 1e-9"), SINE},
      {NINTH("disc 4.9 4.9 radius 1 a") "stage t\ncycles 1\n", "one stage"},
      {CELL_OF("5.85", "5.85", "9.9e5") EIGHT "disc 4.9 4.9 radius 1 a\n" WAVE,
       "a friction of at least 1e6, so that no contact slides"},
      {LATTICE("5.85", "5.85", "3 by 3 from 1 1 radius 1 spacing 1.95"), NULL},
      {LATTICE("6", "6", "3 by 3 from 1 1 radius 1 spacing 2"), NEAREST},
      {LATTICE("5.997", "5.997", "3 by 3 from 1 1 radius 1 spacing 1.999"), NULL},
      {LATTICE("7.8", "(7.8*sqrt(0.75))", "4 by 4 hexagonal from 1 1 radius 1 spacing 1.95"), NULL},
      {LATTICE("5.85", "5.8501", "3 by 3 from 1 1 radius 1 spacing 1.95"), NEAREST},
      {CELL_OF("5.85", "5.85", "1e9") EIGHT "disc 4.9 4.9 radius 1 a\nmonitor D disc 2\nstep 0.1\nstage s\ncycles 1\n",
       SINE});
#undef NINTH
#undef NEAREST
#undef SINE
#undef LATTICE
}

/* A lattice whose stress follows from its elastic moduli. */
static void lattice_moduli(void) {
#define SHEARED "step 0.1\nstage s\ncell strain -1e-3 -2e-3\ncycles 1\n"
#define NINTH(disc) CELL_OF("5.85", "5.85", "0") EIGHT disc "\n" SHEARED
#define EQUAL "equal particles"
#define LATTICE(w, h, lattice) CELL_OF(w, h, "1") "lattice discs " lattice " a\n" SHEARED
#define MOVING(strain) CELL_OF("5.85", "5.85", "1") EIGHT "disc 4.9 4.9 radius 1 a\n" strain
  PARTS("lattice_moduli", "@", {NINTH("disc 4.9 4.9 radius 1 a"), NULL}, {NINTH("disc 4.9 4.9 radius 0.999 a"), EQUAL},
        {NINTH("disc 4.9 4.9 radius 1 b"), EQUAL}, {NINTH("sphere 4.9 4.9 radius 1 a"), EQUAL},
        {LATTICE("6", "6", "3 by 3 from 1 1 radius 1 spacing 2"), NULL},
        {LATTICE("6.001", "6.001", "3 by 3 from 1 1 radius 1 spacing (2 + 1e-3/3)"),
         "a lattice in which every particle touches four or six others"},
        {LATTICE("5.8", "6.1", "3 by 3 from 1 1 radius 1 spacing 1.93333333"),
         "a lattice in which every particle touches four or six others"},
        {LATTICE("5.85", "5.8500001", "3 by 3 from 1 1 radius 1 spacing 1.95"), "a lattice that fills the cell"},
        {LATTICE("5.85", "5.8499999", "3 by 3 from 1 1 radius 1 spacing 1.95"), "a lattice that fills the cell"},
        {MOVING("step 0.1 of stable\nstage s\ncell strain 0 0\ncycles 1\n"),
         "steps given as times, and strain rates without rotation"},
        {MOVING("step 0.1\nstage s\ncell strain 0 0 c12 1e-3\ncycles 1\n"),
         "steps given as times, and strain rates without rotation"});
#undef NINTH
#undef EQUAL
#undef LATTICE
#undef SHEARED
#undef MOVING
}

/* An assembly that is at rest in an accumulated strain. */
static void literal_field(void) {
#define SPHERES(b)                                                                                                     \
  "material a density 3 young 7 poisson 0.2\nmaterial b density 3 young 7 poisson 0.2\nnormal hertz\n"                 \
  "shear mindlin\nsphere 0 0 radius 1 a\nsphere 5 0 radius 2 a\nsphere 0 5 radius 1 " b                                \
  "\nregion S circle 1 2 radius 3\n"                                                                                   \
  "region R box 0 0 to 9 9\nmonitor D sphere 1\nstep 0.1 of rayleigh-fit-mean\n"
#define LAST                                                                                                           \
  "a last stage with `affine strain E -E accumulated` per cycle, and a step that is a fraction of rayleigh-fit-mean"
#define STRAIN(e) "stage s\naffine strain " e " accumulated\ncycles 1\n"
  const double mass = 3 * 4 * pi / 3 * 10 / 3, radius = 4. / 3, shear = 7 / 2.4;
  const double step = 0.25 * pi * radius * sqrt(3 / shear) / (0.1631 * 0.2 + 0.876605);
  VALUES("literal_field",
         SPHERES("a") STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 0.25 of rayleigh-fit-mean\naffine strain "
                                                               "-2e-6 per cycle 2e-6 per cycle accumulated\ncycles 1\n",
         0, {"S.unbalanced.force in t", mass * 2 / 3 * 3 * 2e-6 / (step * step)});
  PARTS("literal_field", SPHERES("a") "@", {STRAIN("1e-6 per cycle -1e-6 per cycle"), NULL},
        {STRAIN("1e-6 per cycle -1.1e-6 per cycle"), LAST}, {STRAIN("1e-6 per cycle 1e-6 per cycle"), LAST},
        {STRAIN("1e-6 -1e-6"), LAST}, {STRAIN("1e-6 per cycle -1e-6 per cycle c12 1e-9 per cycle"), LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle c21 -1e-9 per cycle"), LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\naffine strain 1e-6 per cycle -1e-6 per cycle\ncycles 1\n",
         LAST},
        {"stage r\naffine strain 1e-6 per cycle -2e-6 per cycle\ncycles 1\n" STRAIN("1e-6 per cycle -1e-6 per cycle"),
         NULL},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 0.1 of rayleigh-fit\ncycles 1\n", LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 1e-3\ncycles 1\n", LAST});
  PARTS("literal_field", SPHERES("@") STRAIN("1e-6 per cycle -1e-6 per cycle"), {"a", NULL},
        {"b", "particles of one material"});
#undef SPHERES
#undef LAST
#undef STRAIN
}

/* Discs of radius 1 at (1.9 i + 0.4 j, 1.8 j). */
static void lattice_stress(void) {
#define ROWS(first, fourth, box)                                                                                       \
  "material a density 1 kn 9\nmaterial b density 1 kn 8\nnormal linear\n" first                                        \
  "lattice discs 3 by 1 from 0.4 1.8 radius 1 spacing 1.9 a\n" fourth "region R " box                                  \
  "\nmonitor D disc 1\nstep 1\nstage s\ncycles 1\n"
#define FIRST "lattice discs 3 by 1 from 0 0 radius 1 spacing 1.9 a\n"
#define FOURTH "lattice discs 3 by 1 from 0.8 3.6 radius 1 spacing 1.9 a\n"
#define BOX "box 0.3 0.2 to 4.1 2"
#define EQUAL "equal discs with linear springs in a lattice, without walls"
#define CELLS "regions that are boxes of whole cells"
  const double s = 1.9, h = 1.8, p[3][2] = {{1.9, 0}, {0.4, 1.8}, {-1.5, 1.8}};
  double sigma[3] = {0}, phi[3] = {0}, fourth[3] = {0};
  int z = 0;
  for (int k = 0; k < 3; k++) {
    const double d = hypot(p[k][0], p[k][1]), x = p[k][0] / d, y = p[k][1] / d, force = 9 * (2 - d) * d / (s * h);
    if (d >= 2)
      continue;
    sigma[0] += force * x * x, sigma[1] += force * x * y, sigma[2] += force * y * y;
    phi[0] += x * x, phi[1] += x * y, phi[2] += y * y, z++;
    fourth[0] += pow(x, 4), fourth[1] += x * x * y * y, fourth[2] += pow(y, 4);
  }
  VALUES("lattice_stress", ROWS(FIRST, FOURTH, BOX), 0, {"R.stress.xx at 0 cycles", sigma[0]},
         {"R.stress.xy at 0 cycles", sigma[1]}, {"R.stress.yy at 0 cycles", sigma[2]},
         {"R.stress.mean at 0 cycles", (sigma[0] + sigma[2]) / 2},
         {"R.stress.sinphi at 0 cycles",
          sqrt(pow(sigma[0] - sigma[2], 2) + 4 * sigma[1] * sigma[1]) / (sigma[0] + sigma[2])},
         {"R.fabric.xx at 0 cycles", phi[0] / z}, {"R.fabric.xy at 0 cycles", phi[1] / z},
         {"R.fabric.yy at 0 cycles", phi[2] / z}, {"R.fabric.fourth.xxxx at 0 cycles", fourth[0] / z},
         {"R.fabric.fourth.xxyy at 0 cycles", fourth[1] / z}, {"R.fabric.fourth.yyyy at 0 cycles", fourth[2] / z},
         {"R.fabric.kk at 0 cycles", 2 * z / (s * h)}, {"R.coordination at 0 cycles", 2 * z},
         {"R.porosity at 0 cycles", 1 - pi / (s * h)});
#define THIRD(more) "disc 0.8 3.6 radius 1 a\n" more "\n"
  PARTS("lattice_stress", "@", {ROWS(FIRST, "", BOX), NULL},
        {ROWS("disc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a\n", "", BOX), NULL}, {ROWS("", "", BOX), EQUAL},
        {ROWS("lattice discs 4 by 1 from -7.2 1.8 radius 1 spacing 1.9 a\n", "", BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.6 radius 1 a"), BOX), NULL},
        {ROWS(FIRST, THIRD("disc 2.7001 3.6 radius 1 a"), BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.6001 radius 1 a"), BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.5999 radius 1 a"), BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.6 radius 1.001 a"), BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.6 radius 0.999 a"), BOX), EQUAL},
        {ROWS(FIRST, THIRD("disc 2.7 3.6 radius 1 b"), BOX), EQUAL}, {ROWS(FIRST, "", "box 0.3 0.2 to 4.2 2"), CELLS},
        {ROWS(FIRST, "", "box 0.3 0.2 to 4 2"), CELLS}, {ROWS(FIRST, "", "box 0.3 0.2 to 4.1 2.1"), CELLS},
        {ROWS(FIRST, "", "box 0.3 0.2 to 4.1 1.9"), CELLS}, {ROWS(FIRST, "", "box 0.3 0.2 to 2.2 3.8"), NULL},
        {ROWS(FIRST, "", "circle 2 2 radius 1.9"), CELLS});
#undef ROWS
#undef FIRST
#undef FOURTH
#undef BOX
#undef EQUAL
#undef CELLS
#undef THIRD
}

void suite_refs_values(void) {
  CU_pSuite suite = CU_add_suite("refs_values", NULL, released);
  CU_ADD_TEST(suite, centripetal);
  CU_ADD_TEST(suite, cohesion);
  CU_ADD_TEST(suite, fracc);
  CU_ADD_TEST(suite, fracc_touch);
  CU_ADD_TEST(suite, changed_law);
  CU_ADD_TEST(suite, boxed_lattice);
  CU_ADD_TEST(suite, carried);
  CU_ADD_TEST(suite, force_chain);
  CU_ADD_TEST(suite, free_fall);
  CU_ADD_TEST(suite, filling);
  CU_ADD_TEST(suite, zigzag);
  CU_ADD_TEST(suite, momentum);
  CU_ADD_TEST(suite, packing);
  CU_ADD_TEST(suite, rayleigh_cycle);
  CU_ADD_TEST(suite, pinched);
  CU_ADD_TEST(suite, slide_to_roll);
  CU_ADD_TEST(suite, rotation_off);
  CU_ADD_TEST(suite, wedge);
  CU_ADD_TEST(suite, step_limit);
  CU_ADD_TEST(suite, speed_of_loading);
  CU_ADD_TEST(suite, rigid_impact);
  CU_ADD_TEST(suite, taken_out);
  CU_ADD_TEST(suite, time_reversal);
  CU_ADD_TEST(suite, wall_end);
  CU_ADD_TEST(suite, servo_lattice);
  CU_ADD_TEST(suite, ring_strain);
  CU_ADD_TEST(suite, rebound);
  CU_ADD_TEST(suite, stress_ring);
  CU_ADD_TEST(suite, two_walls);
  CU_ADD_TEST(suite, path_no_slip);
  CU_ADD_TEST(suite, path_springs);
  CU_ADD_TEST(suite, forces_above_the_limit);
  CU_ADD_TEST(suite, path_randall);
  CU_ADD_TEST(suite, spheres_that_are_not_equal);
  CU_ADD_TEST(suite, lattice_waves);
  CU_ADD_TEST(suite, lattice_moduli);
  CU_ADD_TEST(suite, literal_field);
  CU_ADD_TEST(suite, lattice_stress);
}
