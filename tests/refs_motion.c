/* References of the motion of one particle or of two (one_contact, incline, many_bounces, free_fall, slide_to_roll,
 * rotation_off, wedge, rigid_impact, rebound, time_reversal, wall_end): values on scenes without symmetry, and the edges
 * of what they cover.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
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
        /* exactly at the beginning and at the end of the wall */
        {HEAVY STICKS LINEAR "wall w 0 0 to 8 0 h\nsphere 0 1.99 radius 2 h\n" CYCLES("1"), end},
        {HEAVY STICKS LINEAR "wall w 0 0 to 8 0 h\nsphere 8 1.99 radius 2 h\n" CYCLES("1"), end},
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
  /* a light sphere above the wall, whose dashpots have no effect */
  const double m = pi * 32 / 3;
  VALUES("one_contact",
         "material h density 1 kn 10 ks 7" STICKS LINEAR "damping stiffness 0.5\nwall w -9 0 to 9 0 h\n"
         "sphere 3 2.25 radius 2 h spin 0.25 velocity -1 -0.25\nmonitor A sphere 1\nmonitor C sphere 1 with wall "
         "w\n" CYCLES("50"),
         1, {"A.x", 2.5}, {"A.y", 2.125}, {"A.angle", 0.125}, {"A.vx", -1}, {"A.vy", -0.25}, {"A.spin", 0.25},
         {"C.overlap", 0}, {"C.normal", 0}, {"C.shear", 0}, {"energy.stored", 0}, {"energy.balance", 0},
         {"energy.kinetic", m * (1 + 0.0625 + 1.6 * 0.0625) / 2}, {"momentum.x", -m}, {"momentum.y", -0.25 * m},
         {"momentum.angular", m * (2.5 * -0.25 + 2.125 + 1.6 * 0.25)});
}

/* Without friction, and without a shear law, a light sphere keeps its tangential velocity and its spin: the shear dashpot
 * has no effect, either. */
static void one_contact_without_shear(void) {
  static const char *const pages[] = {"density 1 kn 10 ks 7\nnormal linear\nshear linear\n",
                                      "density 1 kn 10 ks 7 friction 1\nnormal linear\nshear none\n"};
  for (int k = 0; k < 2; k++) {
    struct nb_solution solution;
    struct nb_error error = {0};
    char page[512];
    snprintf(
        page, sizeof page,
        "material h %sdamping stiffness 0.5\nwall w -9 0 to 9 0 h\n"
        "sphere 0 1.9 radius 2 h velocity 0.25 0 spin 0.5\nmonitor A sphere 1\nmonitor C sphere 1 with wall w\n" CYCLES(
            "50"),
        pages[k]);
    CU_ASSERT_EQUAL_FATAL(refs_solve(&solution, "one_contact", page, &error), NB_OK);
    CU_ASSERT_EQUAL(refs_value(&solution, "A.vx"), 0.25);
    CU_ASSERT_EQUAL(refs_value(&solution, "A.spin"), 0.5);
    CU_ASSERT_EQUAL(refs_value(&solution, "C.shear"), 0);
    solution_free(&solution);
  }
}

/* A sphere of m = 32 pi/3 on a spring of k = 10 oscillates in a run so long that a thousandth of it needs more steps of
 * (m/k)^(1/2)/5, or shorter, than the method may use. */
static void one_contact_that_lasts_too_long(void) {
  static const char beyond[] = "the equations of motion could not be solved beyond ";
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "one_contact",
                             "material h density 1 kn 10\n" LINEAR "wall w -9 0 to 9 0 h\nsphere 0 1.9 radius 2 h "
                             "velocity 0 -0.1\nstep 1\nstage s\ncycles 1000000000\n",
                             &error),
                  NB_BROKEN);
  CU_ASSERT_FATAL(strncmp(error.text, beyond, strlen(beyond)) == 0);
  char *end;
  const double time = strtod(error.text + strlen(beyond), &end), longest = 1e5 * sqrt(32 * pi / 30) / 5;
  CU_ASSERT_STRING_EQUAL(end, " s");
  CU_ASSERT(time > longest / 5 && time <= longest);
  solution_free(&solution);
}

/* A particle that is fixed moves on and has no momentum; `shear none` leaves friction without effect; a wall may have
 * dashpots of its own. */
static void one_contact_of_other_kinds(void) {
  const double m = 1e30 * pi * 4 / 3, overlap = 0.005;
  VALUES("one_contact",
         HEAVY STICKS
         "normal linear\nshear none\ndamping stiffness 1\nsphere 3 -2 radius 2 h velocity 0.01 0.02 spin 0.03 fixed\n"
         "sphere 3 0.99 radius 1 h velocity 0.01 0.03 spin 0.05\nmonitor A sphere 1\nmonitor B sphere 2\n"
         "monitor C sphere 1 with sphere 2\n" CYCLES("50"),
         1, {"A.x", 3.005}, {"A.y", -1.99}, {"A.angle", 0.015}, {"A.vx", 0.01}, {"A.vy", 0.02}, {"A.spin", 0.03},
         {"B.x", 3.005}, {"B.y", 1.005}, {"B.angle", 0.025}, {"B.vx", 0.01}, {"B.vy", 0.03}, {"B.spin", 0.05},
         {"C.overlap", overlap}, {"C.normal", 10 * overlap}, {"C.shear", 0}, {"energy.stored", 5 * overlap * overlap},
         {"energy.balance", 0}, {"energy.kinetic", m * (0.01 * 0.01 + 0.03 * 0.03 + 0.4 * 0.0025) / 2},
         {"momentum.x", 0.01 * m}, {"momentum.y", 0.03 * m},
         {"momentum.angular", m * (3.005 * 0.03 - 1.005 * 0.01 + 0.4 * 0.05)});
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
  /* Both components change at once at 0.5: it slides with p = 9 and n = 2. */
  VALUES("incline", PLANE("3 -4", "stage a\ncycles 50\nstage b\ngravity 9 -2\ncycles 100\n"), 1, {"D.vx in a", rolls},
         {"D.spin in a", -rolls / 0.8}, {"D.vx in b", rolls + 8}, {"D.spin in b", -(rolls + 2) / 0.8},
         {"D.vx", rolls + 4, "time", 1}, {"D.spin", -(rolls + 1) / 0.8, "time", 1});
}
#undef PLANE

/* The overlap q(t) of an impact with the speed v, with weight: q'' = g - (c/m) q' - (k/m) q. Returns the speed of
 * separation. Runge-Kutta of fourth order, with a last step that ends at q = 0. */
static double rebound_speed(double square, double rate, double g, double v) {
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
    const double v = rebound_speed(k / m, 2 * ratio * sqrt(k / m), g, sqrt(2 * g * e));
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
  const double low = rebound_speed(k / m, 2 * 0.005 * sqrt(k / m), g, sqrt(2 * g * 0.003));
  VALUES("many_bounces", DROP("0 -9", "-0.497", "ratio 0.005"), 1, {"D.y in b", -0.5 + low * low / (2 * g)});
  VALUES("many_bounces", DROP("0 -9", "-0.499997", "none"), 1, {"D.y in b", -0.499997});
#undef DROP
#undef UNTIL
#undef FALLS
}

/* A disc of mass 5 on a spring of k = 20 falls from the height 1 with g = 0.5: it flies for 2, 4, 4, … and touches for
 * pi - atan(4) each time. The 128th contact ends at 2 + 127*4 + 128*1.8158 = 742.4. */
static void last_contact(void) {
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
  CU_ASSERT_EQUAL(refs_solve(&solution, "free_fall", page, &error), NB_OK);
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
  NEAR(fall("-0.5", "0", "5", "C.overlap max", 0), 2 * sag, 1e-12);
  NEAR(fall("-0.5", "0.9", "5.001", "D.y", 99), 5 - sag, 1e-12);
  for (double ratio = 0.05; ratio < 0.96; ratio += 0.05) { /* pressed from rest */
    char text[32];
    snprintf(text, sizeof text, "%g", ratio);
    NEAR(fall("-0.5", text, "5", "C.overlap max", 0), sag * (1 + exp(-pi * ratio / sqrt(1 - ratio * ratio))), 1e-12);
  }
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
  /* Only the first stage that ends below a value has a time. */
  for (int k = 0; k < 2; k++) {
    struct nb_solution solution;
    struct nb_error error = {0};
    strcpy(page, SLIDES_ON("step 0.01\n", "0.5", "4.9", "99 3 to -9 3",
                           "stage t\nuntil C.sliding below 0.5 at most 90 cycles\n"));
    if (k)
      memcpy(strstr(page, "below"), "above", strlen("above"));
    CU_ASSERT_EQUAL(refs_solve(&solution, "slide_to_roll", page, &error), NB_OK);
    CU_ASSERT_EQUAL(!solution_find(&solution, "time in s"), k == 1);
    CU_ASSERT_EQUAL(!solution_find(&solution, "time in t"), k == 0);
    solution_free(&solution);
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
    refs_check_message("slide_to_roll", page, k % 2 ? LONG : NULL);
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
#define OTHERS                                                                                                         \
  "a step given as a time, stages that change only `rotation` and the friction of the pair, and a contact point that " \
  "moves in +x"
#define LEVEL "one particle that moves in +x on a level floor, under gravity"
#define LONG "a floor so long that the particle does not reach its end"
  char page[1024];
  for (int k = 0; k < 4; k++) {
    snprintf(page, sizeof page, ROTATES("%.9g 3 to %.9g 3", RESUMES), k < 2 ? -9 : far + (k == 2 ? 1e-6 : -1e-6),
             k < 2 ? far + (k == 0 ? 1e-6 : -1e-6) : -9);
    refs_check_message("rotation_off", page, k % 2 ? LONG : NULL);
  }
  PARTS("rotation_off", ROTATES("@", ""), {"6.99 3 to 99 3", NULL}, {"7.01 3 to 99 3", LEVEL}, {"99 3 to 6.99 3", NULL},
        {"99 3 to 7.01 3", LEVEL}, {"9.94 3 to -9 3", LONG}, {"9.96 3 to -9 3", LONG}, {"-9 5 to 99 5", LEVEL});
  PARTS("rotation_off", ROTATES("-9 3 to 99 3", "stage c\n@ friction 0.5\ncycles 1\n"), {"pair m f", NULL},
        {"pair f m", NULL}, {"pair m m", OTHERS}, {"pair f f", OTHERS}, {"walls stop\npair m f", OTHERS});
#undef LEVEL
#undef LONG
#undef OTHERS
}

/* A disc of mass 5 and R = 2 in a right angle at (2, 1), with the unit normals n_1 = (0.6, 0.8) and n_2 = (-0.8, 0.6) and
 * the stiffnesses 30 and 120/13. The forces are -m g n_i, and c = P + (R - N_1/k_1) n_1 + (R - N_2/k_2) n_2. */
#define NESTS(gravity, one, two, stages)                                                                               \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ngravity " gravity            \
  "\ndisc 2 4 radius 2 m\nwall a " one " a\nwall b " two " b\nmonitor D disc 1\nmonitor A disc 1 with wall a\n"        \
  "monitor B disc 1 with wall b\nmonitor W wall a\nstep 0.01\n" stages
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
        refs_check_message("wedge", page, (more > 0) == end ? NULL : ON);
      }
  PARTS("wedge", NESTS("@", "2 1 to -6 7", "2 1 to 8 9", "stage s\ncycles 1\n"), {"-0.74 -1", NULL}, {"-0.76 -1", ON},
        {"1.33 -1", NULL}, {"1.34 -1", ON}, {"0 1", ON});
#undef REST
#undef ON
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
  refs_check_message("rigid_impact", STRIKES("-99 2 to 99 2 w\nwall v -99 -90 to 99 -90", "0.5"),
                     "one particle and one wall");
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

/* With more damping than (5/6)^(1/2), or little less, an oblique impact does not end in a time of 1000 alpha_max/V_N. */
static void rebound_of_a_damped_sphere(void) {
#define DAMPED(ratio)                                                                                                  \
  "material a density 3 young 7 poisson 0.25 friction 0.3\nnormal hertz\nshear mindlin_deresiewicz\ndamping "          \
  "ratio " ratio                                                                                                       \
  "\nsphere 0 2 radius 2 a\nwall w -9 0 to 9 0 a\nmonitor C sphere 1 with wall w\nimpact C speed 0.01 angle 0.3\n"     \
  "step 100 per collision\nstage s\nuntil impact.time above 1.1 at most 999 cycles\n"
  PARTS("rebound", DAMPED("@"), {"0.1", NULL},
        {"0.9128", "an impact that ends, with dashpots well below critical damping"},
        {"0.913", "an impact that ends, with dashpots well below critical damping"});
#undef DAMPED
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
        refs_solve(&solution, "wall_end", end ? HITS("13", "0", "-0.3", "0") : HITS("-4", "0", "0.3", "0"), &error),
        NB_OK);
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
      {HITS("13", "1.99", "-0.01", "0"), NULL},    {HITS("13", "2.01", "-0.01", "0"), TOWARD},
      {HITS("13", "-1.99", "-0.01", "0"), NULL},   {HITS("13", "-2.01", "-0.01", "0"), TOWARD},
      {HITS("13", "0", "0.01", "0"), TOWARD},      {HITS("12.01", "0", "-0.01", "0"), NULL},
      {HITS("11.99", "0", "-0.01", "0"), TOWARD},  {HITS("-2.01", "0", "0.01", "0"), NULL},
      {HITS("-1.99", "0", "0.01", "0"), TOWARD},   {HITS("10.01", "4", "0", "-0.001"), NULL},
      {HITS("9.99", "4", "0", "-0.001"), BESIDE},  {HITS("-0.01", "-4", "0", "0.001"), NULL},
      {HITS("0.01", "-4", "0", "0.001"), BESIDE},  {HITS("10.1", "2.5", "0", "-2"), NULL},
      {HITS("10.5", "4", "-1", "-4"), BESIDE},     {HITS("0.5", "4", "-0.01", "-0.02"), NULL},
      {HITS("9.5", "4", "0.01", "-0.02"), NULL},   {HITS("2.5", "2.6", "-0.01", "-0.00236"), NULL},
      {HITS("9.45", "2.1", "0.5", "-0.1"), BESIDE}};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    refs_check_message("wall_end", parts[k].text, parts[k].message);
  refs_check_message("wall_end", HITS("13", "0", "-0.3", "0") "stage t\ncycles 1\n", NULL);
#undef TOWARD
#undef BESIDE
}
static void other_numbers_than_one_particle_and_one_wall(void) {
#define OTHER(more)                                                                                                    \
  "material m density 1 kn 20\nnormal linear\ndisc 13 9 radius 2 m velocity -1 0\nwall w 3 9 to 10 9 m\n" more         \
  "step 0.1\nstage s\ncycles 1\n"
  PARTS("wall_end", OTHER("@"), {"", NULL}, {"disc 30 9 radius 2 m\n", "one particle and one wall"},
        {"wall v 3 19 to 10 19 m\n", "one particle and one wall"});
#undef OTHER
}

/* A disc of m = 5, R = 2 and I = 10 touches, from the left, a wall of length 13 that turns with W = 0.5 about the point
 * P = (3, 4). The wall has the direction (0.6, 0.8) and is at the distance 4.5 to the right of P. The centre is at the
 * distances s along the wall and n = -2.5 to its left, from P. s = s_0 cosh(q t) with q = W (2/3)^(1/2). */
#define TURNS(disc, motion, spin, friction, step, stages)                                                              \
  "material m density (5/(4*pi)) kn 30 ks 12 friction 9\nmaterial b kn 15 ks 6 friction " friction "\nnormal linear\n" \
  "shear linear\nwall w (3 + 3.6 - 0.6*3) (4 - 2.7 - 0.8*3) to (3 + 3.6 + 0.6*10) (4 - 2.7 + 0.8*10) b about 3 4 "     \
  "spin " spin "\ndisc " disc " radius 2 m " motion                                                                    \
  "\nmonitor D disc 1\nmonitor C disc 1 with wall w\nmonitor W wall w\nstep " step "\n" stages
/* The velocity and the spin of a disc at s = 1 that moves with the wall. */
#define ALONG(s) "(3 + 0.6*(" s ") + 0.8*2.5) (4 + 0.8*(" s ") - 0.6*2.5)"
#define WITH(w, s) "velocity (-(" w ")*(0.8*(" s ") - 0.6*2.5)) ((" w ")*(0.6*(" s ") + 0.8*2.5)) spin " w
static void turning_wall(void) {
  static const char *const pages[] = {
      TURNS(ALONG("1"), WITH("0.5", "1"), "0.5", "0.8", "0.1", "stage a\ncycles 5\nstage b\ncycles 4\n"),
      TURNS(ALONG("1"), WITH("(-0.5)", "1"), "-0.5", "0.8", "0.1", "stage a\ncycles 5\nstage b\ncycles 4\n")};
  for (int k = 0; k < 2; k++) {
    const double w = k ? -0.5 : 0.5, q = w * sqrt(2. / 3), n = -2.5, t = 0.7;
    const double s = cosh(q * t), ds = q * sinh(q * t), dds = q * q * s, ex = 0.6 * cos(w * t) - 0.8 * sin(w * t),
                 ey = 0.8 * cos(w * t) + 0.6 * sin(w * t);
    VALUES("turning_wall", pages[k], 1, {"D.x", 3 + 0.6 + 2, "time", 0}, {"D.y", 4 + 0.8 - 1.5, "time", 0},
           {"D.spin", w, "time", 0}, {"D.x", 3 + s * ex - n * ey, "time", t}, {"D.y", 4 + s * ey + n * ex, "time", t},
           {"D.spin", w - ds / 2, "time", t}, {"C.normal", 5 * (2 * w * ds - w * w * n), "time", t},
           {"C.shear", -10. / 4 * dds, "time", t});
  }
#define BEGINS "a particle that turns with the wall at first"
#define TOUCHES "a particle that just touches the wall"
#define STEADY "a wall whose motion no stage changes"
#define TIMED "a step given as a time, such as `step 1 us`"
#define SLIDES "a particle that does not slide on the wall until the end of the run"
#define LONG "a wall so long that the particle does not reach its end during the run"
#define RUN "stage a\ncycles 5\nstage b\ncycles 4\n"
  PARTS("turning_wall", TURNS(ALONG("1"), "@", "0.5", "0.8", "0.1", RUN), {WITH("0.5", "1"), NULL},
        {WITH("0.5", "1.00001"), BEGINS}, {WITH("-0.5", "1"), BEGINS},
        {"velocity (-0.5*(0.8 - 0.6*2.5)) (0.5*(0.6 + 0.8*2.5)) spin 0.4", BEGINS},
        {"velocity (-0.5*(0.8 - 0.6*2.5)) (0.5*(0.6 + 0.8*2.5) + 1e-8) spin 0.5", BEGINS},
        {"velocity (-0.5*(0.8 - 0.6*2.5) + 1e-8) (0.5*(0.6 + 0.8*2.5)) spin 0.5", BEGINS},
        {"velocity (-0.5*(0.8 - 0.6*2.5) + 1e-10) (0.5*(0.6 + 0.8*2.5) - 1e-10) spin 0.5", NULL});
  PARTS("turning_wall", TURNS(ALONG("1"), WITH("(-0.5)", "1"), "-0.5", "@", "0.1", RUN), {"0.8", NULL},
        {"0.1", SLIDES});
  /* at s_0 = 1: F = 5/12, N = 25/8 and F/N = 2/15; the ratio decreases with time */
  PARTS("turning_wall", TURNS(ALONG("1"), WITH("0.5", "1"), "0.5", "@", "0.1", "stage a\ncycles 1\n"),
        {"0.133", SLIDES}, {"0.14", NULL});
  PARTS("turning_wall", TURNS(ALONG("1"), WITH("0.5", "1"), "0.5", "0.8", "0.1", "@"), {RUN, NULL},
        {"stage a\ncycles 5\nstage b\nwall w spin 0.5\ncycles 4\n", STEADY},
        {"wall v 30 40 to 50 60 b\nstage s\ncycles 1\n", "one particle and one wall"},
        {"disc 30 40 radius 2 m\nstage s\ncycles 1\n", "one particle and one wall"});
  PARTS("turning_wall", TURNS(ALONG("1"), WITH("0.5", "1"), "0.5", "0.8", "@", RUN), {"0.1 of stable", TIMED});
  /* the distance of the centre from the line of the wall, to 1e-9 of the radius */
  PARTS("turning_wall", TURNS("@", WITH("0.5", "1"), "0.5", "0.8", "0.1", RUN),
        {"(3 + 0.6 + 0.8*(2.5 + 1e-9)) (4 + 0.8 - 0.6*(2.5 + 1e-9))", NULL},
        {"(3 + 0.6 + 0.8*(2.5 - 1e-9)) (4 + 0.8 - 0.6*(2.5 - 1e-9))", NULL},
        {"(3 + 0.6 + 0.8*(2.5 + 2.5e-9)) (4 + 0.8 - 0.6*(2.5 + 2.5e-9))", TOUCHES},
        {"(3 + 0.6 + 0.8*(2.5 - 2.5e-9)) (4 + 0.8 - 0.6*(2.5 - 2.5e-9))", TOUCHES});
  /* s = 1.0625 s_0 at the end; the ends of the wall are at -3 and 10 */
  const double grows = cosh(0.5 * sqrt(2. / 3) * 0.9);
  for (int k = 0; k < 4; k++) {
    char page[2048];
    const double s = (k < 2 ? -3 : 10) / grows * (k % 2 ? 1 + 1e-7 : 1 - 1e-7);
    snprintf(page, sizeof page, TURNS(ALONG("%.17g"), WITH("0.5", "%.17g"), "0.5", "9", "0.1", RUN), s, s, s, s);
    refs_check_message("turning_wall", page, k % 2 ? LONG : NULL);
  }
#undef BEGINS
#undef TOUCHES
#undef STEADY
#undef TIMED
#undef SLIDES
#undef LONG
#undef RUN
}
#undef ALONG
#undef WITH

/* Spheres of the radii 1 and 2 between walls. */
static void stacked(void) {
#define STACK(gravity, of)                                                                                             \
  "material m density 1 kn 20\nnormal linear\ngravity " gravity "\nwall a -3 0 to 9 0 m\nwall b -3 6 to 9 6 m\n" of    \
  "step 0.1\nstage s\ncycles 1\n"
#define TWO                                                                                                            \
  "two spheres without horizontal velocity, sphere 1 vertically below sphere 2, between two horizontal walls, first "  \
  "the floor, then the ceiling"
  PARTS("stacked", STACK("0 -1", "@"), {"sphere 1 1 radius 1 m\nsphere 1 4 radius 2 m velocity 0 -1\n", NULL},
        {"sphere 1 4 radius 2 m\nsphere 1 1 radius 1 m\n", TWO}, {"sphere 1 1 radius 1 m\n", TWO},
        {"sphere 1 1 radius 1 m\nsphere 1 4 radius 2 m\nsphere 30 4 radius 2 m\n", TWO},
        {"sphere 1 1 radius 1 m\nsphere 1 4 radius 2 m\nwall c -3 60 to 9 60 m\n", TWO},
        {"sphere 1 1 radius 1 m\nsphere 1.001 4 radius 2 m\n", TWO},
        {"sphere 1 1 radius 1 m velocity 0.1 0\nsphere 1 4 radius 2 m\n", TWO},
        {"sphere 1 1 radius 1 m\nsphere 1 4 radius 2 m velocity -0.1 0\n", TWO},
        {"sphere -3.1 1 radius 1 m\nsphere -3.1 4 radius 2 m\n", TWO});
  PARTS("stacked", STACK("@", "sphere 1 1 radius 1 m\nsphere 1 4 radius 2 m\n"), {"0 1", NULL},
        {"0.1 -1", "vertical gravity"}, {"-0.1 -1", "vertical gravity"});
#undef STACK
#undef TWO
}

void suite_refs_motion(void) {
  CU_pSuite suite = CU_add_suite("refs_motion", NULL, refs_released);
  CU_ADD_TEST(suite, one_contact_covers);
  CU_ADD_TEST(suite, one_contact_values);
  CU_ADD_TEST(suite, one_contact_of_other_kinds);
  CU_ADD_TEST(suite, one_contact_without_shear);
  CU_ADD_TEST(suite, one_contact_that_lasts_too_long);
  CU_ADD_TEST(suite, incline);
  CU_ADD_TEST(suite, many_bounces);
  CU_ADD_TEST(suite, last_contact);
  CU_ADD_TEST(suite, free_fall);
  CU_ADD_TEST(suite, slide_to_roll);
  CU_ADD_TEST(suite, rotation_off);
  CU_ADD_TEST(suite, wedge);
  CU_ADD_TEST(suite, rigid_impact);
  CU_ADD_TEST(suite, rebound);
  CU_ADD_TEST(suite, rebound_of_a_damped_sphere);
  CU_ADD_TEST(suite, time_reversal);
  CU_ADD_TEST(suite, wall_end);
  CU_ADD_TEST(suite, other_numbers_than_one_particle_and_one_wall);
  CU_ADD_TEST(suite, turning_wall);
  CU_ADD_TEST(suite, stacked);
}
