/* The references of the motion of one particle or of two (one_contact, incline, many_bounces): values on scenes without
 * symmetry, and the edges of what they cover.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

/* Spheres so heavy that no force changes their velocities. */
#define HEAVY "material h density 1e30 kn 10 ks 7"
#define STICKS " friction 1 cohesion 1e9\n"
#define LINEAR "normal linear\nshear linear\n"
#define CYCLES(n) "step 0.01\nstage s\ncycles " n "\n"

/* A sphere on a level wall: overlap 0.01, so the normal force is 0.1. */
#define ON_WALL(law, velocity)                                                                                         \
  HEAVY law "\n" LINEAR "wall w -9 0 to 9 0 h\nsphere 0 1.99 radius 2 h velocity " velocity "\n"
/* A sphere at the left side of a wall of length 10 with the direction (3, 4)/5. The foot of the perpendicular is at the
 * distance `s` from the beginning of the wall. */
#define INCLINED(s, velocity, more)                                                                                    \
  HEAVY STICKS LINEAR "wall w 1 2 to 7 10 h" more "\nsphere (1 + 0.6*(" s ") - 0.8*1.99) (2 + 0.8*(" s                 \
                      ") + 0.6*1.99) radius 2 h velocity " velocity "\n"
/* A sphere at the other side of the same line; the wall has the opposite direction, and `s` is the distance from its
 * end. */
#define OPPOSITE(s, velocity, more)                                                                                    \
  HEAVY STICKS LINEAR "wall w 7 10 to 1 2 h" more "\nsphere (1 + 0.6*(" s ") + 0.8*1.99) (2 + 0.8*(" s                 \
                      ") - 0.6*1.99) radius 2 h velocity " velocity "\n"

static void one_contact_covers(void) {
  static const char two[] = "two particles, or a particle and a wall", slides[] = "a contact that does not slide",
                    opens[] =
                        "a contact that opens only with an undeformed shear spring: let the last stage end before "
                        "the contact opens",
                    end[] = "a wall so long that the contact does not reach its end",
                    time[] = "a step given as a time, and a wall whose velocity no stage changes";
  /* F_s = 7 times 0.02 t has the limit 0.5 times 0.1 plus 0.02 at t = 0.5. */
#define LIMIT " friction 0.5 cohesion 0.02"
  PARTS("one_contact", "@", {ON_WALL(LIMIT, "0.02 0") CYCLES("49"), NULL},
        {ON_WALL(LIMIT, "0.02 0") CYCLES("51"), slides}, {ON_WALL(LIMIT, "-0.02 0") CYCLES("49"), NULL},
        {ON_WALL(LIMIT, "-0.02 0") CYCLES("51"), slides}, {ON_WALL(" friction 0.7", "0.02 0") CYCLES("49"), NULL},
        {ON_WALL(" friction 0.7", "0.02 0") CYCLES("51"), slides},
        {ON_WALL(" cohesion 0.07", "0.02 0") CYCLES("49"), NULL},
        {ON_WALL(" cohesion 0.07", "0.02 0") CYCLES("51"), slides}, {ON_WALL("", "0.02 0") CYCLES("51"), NULL},
        {ON_WALL("", "0.02 0.02") CYCLES("51"), NULL},
        /* the contact opens at t = 0.5 */
        {ON_WALL(STICKS, "0.02 0.02") CYCLES("49"), NULL}, {ON_WALL(STICKS, "0.02 0.02") CYCLES("51"), opens},
        {ON_WALL(STICKS, "-0.02 0.02") CYCLES("51"), opens}, {ON_WALL(STICKS, "0 0.02") CYCLES("51"), NULL},
        {ON_WALL(STICKS, "0 0") "sphere 20 20 radius 1 h\n" CYCLES("1"), two},
        {ON_WALL(STICKS, "0 0") "wall v -9 -9 to 9 -9 h\n" CYCLES("1"), two},
        {HEAVY STICKS LINEAR "sphere 0 0 radius 2 h\n" CYCLES("1"), two},
        {ON_WALL(STICKS, "0 0") "step 0.01\nstage s\nwall w velocity 0 0\ncycles 1\n", time},
        {ON_WALL(STICKS, "0 0") CYCLES("1") "stage t\nwall w velocity 0 0.01\ncycles 1\n", time},
        {ON_WALL(STICKS, "0 0") "step 0.1 of stable\nstage s\ncycles 1\n", time});
#undef LIMIT
  /* The foot of the perpendicular stays 0.01 away from the ends of the wall, or it does not. */
  PARTS("one_contact", "@", {INCLINED("0.01", "0 0", "") CYCLES("1"), NULL},
        {INCLINED("-0.01", "0 0", "") CYCLES("1"), end}, {INCLINED("9.99", "0 0", "") CYCLES("1"), NULL},
        {INCLINED("10.01", "0 0", "") CYCLES("1"), end}, {OPPOSITE("0.01", "0 0", "") CYCLES("1"), NULL},
        {OPPOSITE("-0.01", "0 0", "") CYCLES("1"), end}, {OPPOSITE("9.99", "0 0", "") CYCLES("1"), NULL},
        {OPPOSITE("10.01", "0 0", "") CYCLES("1"), end}, {INCLINED("5", "3 4", "") CYCLES("99"), NULL},
        {INCLINED("5", "3 4", "") CYCLES("101"), end}, {INCLINED("5", "-3 -4", "") CYCLES("99"), NULL},
        {INCLINED("5", "-3 -4", "") CYCLES("101"), end}, {INCLINED("5", "0 0", " velocity 3 4") CYCLES("99"), NULL},
        {INCLINED("5", "0 0", " velocity 3 4") CYCLES("101"), end},
        {INCLINED("5", "0 0", " velocity -3 -4") CYCLES("101"), end},
        {INCLINED("5", "3 4", " velocity 3 4") CYCLES("900"), NULL});
#undef INCLINED
#undef OPPOSITE
}

/* Two heavy spheres of the radii 1 and 2 that move along straight lines. The slip has s' = v.t - 1 w_1 - 2 w_2 with the
 * tangent of each time. Its integral and that of energy.balance follow by Simpson's rule. */
static void one_contact_values(void) {
  static const double mass[2] = {1e30 * 4 / 3, 8e30 * 4 / 3}; /* over pi */
  const double x0 = -1, y0 = 3, x1 = x0 + 0.6 * 2.9, y1 = y0 - 0.8 * 2.9;
  const double vx[2] = {0.03, -0.02}, vy[2] = {0.05, 0.09}, w[2] = {0.07, -0.05}, end = 0.5;
  const double vxr = vx[0] - vx[1], vyr = vy[0] - vy[1];
  double shear = 0, residual = 0;
  enum { N = 400 }; /* intervals of two steps */
  double distance = 0;
  for (int k = 0; k < N; k++) {
    double slip[5], product[3], force[3];
    for (int j = 0; j < 5; j++) {
      const double t = end * (k + j / 4.) / N, x = x1 - x0 - vxr * t, y = y1 - y0 - vyr * t;
      distance = hypot(x, y);
      const double along = (vxr * y - vyr * x) / distance;
      slip[j] = along - w[0] - 2 * w[1];
      if (j % 2 == 0)
        product[j / 2] = along * (vxr * x + vyr * y) / distance / distance;
    }
    force[0] = shear;
    force[1] = shear + 7 * end / N / 2 * (slip[0] + 4 * slip[1] + slip[2]) / 6;
    force[2] = force[1] + 7 * end / N / 2 * (slip[2] + 4 * slip[3] + slip[4]) / 6;
    residual += end / N * (force[0] * product[0] + 4 * force[1] * product[1] + force[2] * product[2]) / 6;
    shear = force[2];
  }
  const double overlap = 3 - distance, m0 = pi * mass[0], m1 = pi * mass[1];
  const double i0 = 0.4 * m0, i1 = 0.4 * m1 * 4;
  VALUES("one_contact",
         HEAVY STICKS LINEAR "sphere -1 3 radius 1 h spin 0.07 velocity 0.03 0.05\n"
                             "sphere (-1 + 0.6*2.9) (3 - 0.8*2.9) radius 2 h spin -0.05 velocity -0.02 0.09\n"
                             "monitor A sphere 1\nmonitor B sphere 2\nmonitor C sphere 2 with sphere 1\n" CYCLES(
                                 "20") "stage t\ncycles 30\n",
         1, {"A.x", x0 + vx[0] * end}, {"A.y", y0 + vy[0] * end}, {"A.angle", w[0] * end}, {"A.vx", vx[0]},
         {"A.vy", vy[0]}, {"A.spin", w[0]}, {"B.x", x1 + vx[1] * end}, {"B.y", y1 + vy[1] * end},
         {"B.angle", w[1] * end}, {"B.vx", vx[1]}, {"B.vy", vy[1]}, {"B.spin", w[1]}, {"C.overlap", overlap},
         {"C.normal", 10 * overlap}, {"C.shear", shear},
         {"energy.stored", 10 * overlap * overlap / 2 + shear * shear / 14}, {"energy.balance", 0.01 / 2 * residual},
         {"energy.kinetic", (m0 * (vx[0] * vx[0] + vy[0] * vy[0]) + i0 * w[0] * w[0] +
                             m1 * (vx[1] * vx[1] + vy[1] * vy[1]) + i1 * w[1] * w[1]) /
                                2},
         {"momentum.x", m0 * vx[0] + m1 * vx[1]}, {"momentum.y", m0 * vy[0] + m1 * vy[1]},
         {"momentum.angular", m0 * (x0 * vy[0] - y0 * vx[0]) + i0 * w[0] + m1 * (x1 * vy[1] - y1 * vx[1]) + i1 * w[1]});
  /* a wall: no energy.balance; and without a shear stiffness, no shear force */
  static const char *const stiffness[] = {"ks 7", ""};
  for (int k = 0; k < 2; k++) {
    const double m = 1e30 * pi * 32 / 3, force = -7 * 0.5 * (0.02 - 2 * 0.04) * (k ? 0 : -1);
    char page[1024];
    snprintf(page, sizeof page,
             "material h density 1e30 kn 10 %s friction 1 cohesion 1e9\n" LINEAR
             "wall w -9 0 to 9 0 h velocity 0.01 -0.04\nsphere 3 1.99 radius 2 h spin 0.04 velocity -0.01 -0.06\n"
             "monitor A sphere 1\nmonitor C sphere 1 with wall w\n" CYCLES("50"),
             stiffness[k]);
    VALUES("one_contact", page, 1, {"A.x", 2.995}, {"A.y", 1.96}, {"A.angle", 0.02}, {"A.vx", -0.01}, {"A.vy", -0.06},
           {"A.spin", 0.04}, {"C.overlap", 0.02}, {"C.normal", 0.2}, {"C.shear", force},
           {"energy.stored", 0.002 + force * force / 14}, {"energy.balance", 0},
           {"energy.kinetic", m * (0.01 * 0.01 + 0.06 * 0.06 + 1.6 * 0.04 * 0.04) / 2}, {"momentum.x", -0.01 * m},
           {"momentum.y", -0.06 * m}, {"momentum.angular", m * (3 * -0.06 + 1.99 * 0.01 + 1.6 * 0.04)});
  }
}
#undef HEAVY
#undef STICKS
#undef LINEAR
#undef ON_WALL
#undef CYCLES

/* A disc of radius 0.8 on a plane with mu = 0.5: it slides while p > 1.5 n. */
#define PLANE(gravity, stages)                                                                                         \
  "material m density 1 kn 1e6 ks 1e6 friction 0.7\nmaterial w kn 1e6 ks 1e6 friction 0.5\nnormal linear\nshear "      \
  "linear\ngravity " gravity "\nwall w -9 0 to 9 0 w\ndisc 0 0.8 radius 0.8 m\nmonitor D disc 1\nstep 0.01\n" stages
static void incline(void) {
  /* Rolling has v' = 2 p/3 and R w' = -2 p/3; sliding has v' = p - n/2 and R w' = -n. In stage b, which begins at 0.5,
   * p = 3 + 6 f and n = 4 - 2 f: it slides from f = 1/3. In stage c it slides with p = 9 and n = 2. */
  const double rolls = 2 * 0.5, third = rolls + 2 / 3. * (3 / 3. + 3 / 9.);
#define DOWN(f) (third + (f) + 3.5 * (f) * (f)-1 / 3. - 3.5 / 9)
#define TURN(f) (-(third + 4 * (f) - (f) * (f)-4 / 3. + 1 / 9.) / 0.8)
#define SECOND(f) (rolls + 2 / 3. * (3 * (f) + 3 * (f) * (f)))
  VALUES("incline", PLANE("3 -4", "stage a\ncycles 50\nstage b\nramp gravity 9 -2\ncycles 100\nstage c\ncycles 25\n"),
         1, {"D.vx in a", rolls}, {"D.spin in a", -rolls / 0.8}, {"D.vx in b", DOWN(1)}, {"D.spin in b", TURN(1)},
         {"D.vx in c", DOWN(1) + 2}, {"D.spin in c", TURN(1) - 0.5 / 0.8}, {"D.vx", 0, "time", 0},
         {"D.vx", 0.5, "time", 0.25}, {"D.spin", -0.5 / 0.8, "time", 0.25}, {"D.vx", SECOND(0.2), "time", 0.7},
         {"D.spin", -SECOND(0.2) / 0.8, "time", 0.7}, {"D.vx", DOWN(0.7), "time", 1.2},
         {"D.spin", TURN(0.7), "time", 1.2}, {"D.vx", DOWN(1) + 0.8, "time", 1.6},
         {"D.spin", TURN(1) - 0.2 / 0.8, "time", 1.6});
#undef DOWN
#undef TURN
#undef SECOND
  /* p = 3 + 3.6 f slides from f = 5/6, where the speed is 2.5. */
  VALUES("incline", PLANE("3 -4", "stage a\nramp gravity 6.6 -4\ncycles 100\n"), 1,
         {"D.vx in a", 2.5 + 2.8 - 5 / 6. - 1.25}, {"D.spin in a", -(2.5 + 4 / 6.) / 0.8}, {"D.vx", 0, "time", 0},
         {"D.spin", 0, "time", 0});
}
#undef PLANE

/* The overlap q(t) of an impact with the speed v, with weight: q'' = g - (c/m) q' - (k/m) q. Returns the speed of
 * separation. Runge-Kutta of fourth order, with a last step that ends at q = 0. */
static double rebound(double square, double rate, double g, double v) {
  const double h = 2e-4 / sqrt(square);
  double q[2] = {0, v};
  for (double step = h; fabs(step) > 1e-10 * h;) {
    double k[4][2], at[2];
    for (int i = 0; i < 4; i++) {
      const double part = i == 0 ? 0 : i == 3 ? step : step / 2;
      for (int j = 0; j < 2; j++)
        at[j] = q[j] + (i ? part * k[i - 1][j] : 0);
      k[i][0] = at[1], k[i][1] = g - rate * at[1] - square * at[0];
    }
    for (int j = 0; j < 2; j++)
      q[j] += step * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]) / 6;
    if (q[1] < 0 && q[0] < -q[1] * h) /* near the end: Newton */
      step = -q[0] / q[1];
  }
  return -q[1];
}

static void many_bounces(void) {
  /* A sphere of radius 0.5 and mass 3, k = 500 with the wall, is dropped from 2.5 above contact. */
  const double drop = 2.5, g = 9, k = 500, m = 3, ratio = 0.1;
  double rise[3], e = drop;
  for (int n = 0; n < 3; n++) {
    const double v = rebound(k / m, 2 * ratio * sqrt(k / m), g, sqrt(2 * g * e));
    rise[n] = e = v * v / (2 * g);
  }
#define DROP(damping, stages)                                                                                          \
  "material m density (3/(4/3*pi*0.125)) kn 500\nmaterial w kn 500\nnormal linear\ngravity 0 -9\ndamping " damping     \
  "\nwall w -9 -1 to 9 -1 w\nsphere 2 2 radius 0.5 m\nmonitor D sphere 1\nstep 0.01\n" stages
#define UNTIL(name, condition) "stage " name "\nuntil " condition " at most 900 cycles\n"
  VALUES("many_bounces",
         DROP("ratio 0.1",
              UNTIL("a", "D.vy above 0") UNTIL("b", "D.vy below 0") "stage c\ncycles 9\n" UNTIL("d", "D.vy above 0")
                  UNTIL("e", "D.vy below 0") UNTIL("f", "D.vy below 0 and D.y below "
                                                        "9") UNTIL("g", "D.vy below 0")),
         1, {"D.y in b", -0.5 + rise[0]}, {"D.y in e", -0.5 + rise[1]}, {"D.y in g", -0.5 + rise[2]});
  VALUES("many_bounces", DROP("none", UNTIL("b", "D.vy below 0")), 1, {"D.y in b", 2});
#undef DROP
#define DROP(gravity, y, damping)                                                                                      \
  "material m density (3/(4/3*pi*0.125)) kn 500\nnormal linear\ngravity " gravity "\ndamping " damping                 \
  "\nwall w -9 -1 to 9 -1 m\nsphere 2 " y " radius 0.5 m\nmonitor D sphere 1\nstep 0.01\n" UNTIL("b", "D.vy below 0")
#define FALLS "a particle dropped straight down, from rest, with less than critical damping"
  PARTS("many_bounces", "@", {DROP("0 -9", "2", "ratio 0.1"), NULL}, {DROP("1e-9 -9", "2", "ratio 0.1"), FALLS},
        {DROP("-1e-9 -9", "2", "ratio 0.1"), FALLS}, {DROP("0 9", "2", "ratio 0.1"), FALLS},
        {DROP("0 -9", "-0.3", "none"), NULL}, {DROP("0 -9", "-0.5", "none"), FALLS},
        {DROP("0 -9", "2", "ratio 1"), FALLS}, {DROP("0 -9", "2", "ratio 1.5"), FALLS},
        {DROP("0 -9", "-0.4999", "ratio 0.5"), "a particle that leaves the wall again"});
  /* A low drop: the contact lasts almost 2 pi/w, because eps = g/(w v) is 3 and 100. */
  const double low = rebound(k / m, 2 * 0.005 * sqrt(k / m), g, sqrt(2 * g * 0.003));
  VALUES("many_bounces", DROP("0 -9", "-0.497", "ratio 0.005"), 1, {"D.y in b", -0.5 + low * low / (2 * g)});
  VALUES("many_bounces", DROP("0 -9", "-0.499997", "none"), 1, {"D.y in b", -0.499997});
#undef DROP
#undef UNTIL
#undef FALLS
}

void suite_refs_motion(void) {
  CU_pSuite suite = CU_add_suite("refs_motion", NULL, released);
  CU_ADD_TEST(suite, one_contact_covers);
  CU_ADD_TEST(suite, one_contact_values);
  CU_ADD_TEST(suite, incline);
  CU_ADD_TEST(suite, many_bounces);
}
