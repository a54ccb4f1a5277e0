/* References of lattices and rings of equal particles (boxed_lattice, servo_lattice, ring_strain, stress_ring,
 * lattice_waves, lattice_moduli, literal_field, lattice_stress), compared with other formulas, and what they refuse.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"

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
        {"box 1 5 to 13 17 b\n" SIX "disc 3 15 radius 2 a\n", LATTICE},
        {"box 1 5 to 13 13 b\nwall w 1 5 to 1 13 b\n" SIX, LATTICE});
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

/* A seventh disc outside the box, at the place that a seventh disc of the lattice has. */
static void boxed_lattice_and_a_disc(void) {
  PARTS("boxed_lattice",
        "material a density 1 kn 50\nnormal linear\nshear none\nbox 1 5 to 13 13 a\n"
        "lattice discs 3 by 2 from 3 7 radius 2 spacing 4 a\n@step 0.1\nstage s\ncycles 1\n",
        {"", NULL}, {"disc 3 15 radius 2 a\n", "one `lattice discs` of touching discs in a box of the same stiffness"});
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
   * k = g/(2 - g). The inner sphere is at (1.5, 1) from the centre and has the mass 8 pi/3. The
   * velocity of a sphere of the boundary has no effect. */
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
         "material m density 2 kn 9\nnormal linear\nsphere 2.5 3 radius 1 m velocity 0.3 -0.1\nsphere 9 2 radius 1 m "
         "velocity 0 2\n"
         "sphere 1 10 radius 1 m\nsphere -7 2 radius 1 m\nsphere 1 -6 radius 1 m\nboundary circle 1 2 radius 8\n"
         "monitor D sphere 1\nmonitor E sphere 2\nmonitor C sphere 1 with sphere 2\nstep 0.1\ndamping con1 0.9 as "
         "cs79\n" BOTH(STRAIN, ""),
         1, {"D.x", 1 + x, "cycle", 3}, {"D.y", 2 + y, "cycle", 3}, {"E.x", 1 + ox, "cycle", 3},
         {"E.y", 2 + oy, "cycle", 3}, {"boundary.area", area, "cycle", 3}, {"energy.kinetic", energy, "cycle", 3},
         {"energy.kinetic", mass / 2 * 0.1, "cycle", 0}, {"boundary.area", 128, "cycle", 0}, {"D.x", 2.5, "cycle", 0});
  /* The sphere keeps 3/4 of its velocity, and the strain in y leaves 3/4 of the position. */
  double y4 = 1, v4 = -0.1;
  for (int n = 0; n < 3; n++)
    v4 *= 0.75, y4 = 0.75 * y4 + 0.1 * v4;
  VALUES("ring_strain",
         "material m density 2 kn 9\nnormal linear\nsphere 2.5 3 radius 1 m velocity 0 -0.1\nsphere 9 2 radius 1 m\n"
         "sphere 1 10 radius 1 m\nsphere -7 2 radius 1 m\nsphere 1 -6 radius 1 m\nboundary circle 1 2 radius 8\n"
         "monitor D sphere 1\nstep 0.1\ndamping con1 0.75 as velocity\n" BOTH("0 per cycle -0.25 per cycle", ""),
         1, {"D.x", 2.5, "cycle", 3}, {"D.y", 2 + y4, "cycle", 3}, {"D.y", 3, "cycle", 0},
         {"boundary.area", 128 * pow(0.75, 3), "cycle", 3},
         {"energy.kinetic", mass / 2 * 0.01 * pow(0.75, 6) * pow(1.75 / 2, 2), "cycle", 3});
  /* `accumulated`: every cycle adds L x to u, and u to x. The boundary keeps to the strain. */
  const double rates[][3] = {{0.02, -0.03, 0.01}, {0.02, 0, 0}, {-0.01, 0.02, 0}};
  for (int k = 0; k < 3; k++) {
    const double rxx = rates[k][0], ryy = rates[k][1], rxy = rates[k][2];
    double ux = 0, uy = 0;
    x = 1.5, y = 1, ox = 8, oy = 0, area = 128;
    for (int n = 0; n < 9; n++) {
      ux += rxx * x + rxy * y, uy += rxy * x + ryy * y, x += ux, y += uy, area *= (1 + rxx) * (1 + ryy) - rxy * rxy;
      const double px = ox + rxx * ox + rxy * oy, py = oy + rxy * ox + ryy * oy;
      ox = px, oy = py;
    }
    char page[1024];
    snprintf(page, sizeof page,
             "material m density 2 kn 9\nnormal linear\nsphere 2.5 3 radius 1 m\nsphere 9 2 radius 1 m\n"
             "sphere 1 10 radius 1 m\nsphere -7 2 radius 1 m\nsphere 1 -6 radius 1 m\nboundary circle 1 2 radius 8\n"
             "monitor E sphere 2\nmonitor D sphere 1\nstep 0.1\nstage s\n"
             "boundary strain %.17g per cycle %.17g per cycle shear %.17g per cycle\n"
             "affine strain %.17g per cycle %.17g per cycle shear %.17g per cycle accumulated\ncycles 9\n",
             rxx, ryy, rxy, rxx, ryy, rxy);
    VALUES("ring_strain", page, 1, {"D.x", 1 + x, "cycle", 9}, {"D.y", 2 + y, "cycle", 9}, {"D.x", 2.5, "cycle", 0},
           {"E.x", 1 + ox, "cycle", 9}, {"E.y", 2 + oy, "cycle", 9}, {"boundary.area", area, "cycle", 9});
  }
#undef SAME
#undef DAMPED
#undef BOTH
#undef STRAIN
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
  /* contacts cannot pull */
  refs_check_error("stress_ring", SEVEN("stage u\nboundary stress -0.02 -0.02\ncycles 1\n"),
                   "the reference `stress_ring` finds no equilibrium of these spheres under this stress");
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
           "monitor C disc 1 with disc 2\nmonitor D disc 3\nstep 0.1\nstage s\nrotation off\ncycles 1\n",
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
      {CELL_OF("7.8", "7.8", "1e9") "lattice discs 4 by 4 from 1 1 radius 1 spacing 1.95 a\n"
                                    "perturb wave 1e-3 0 periods 2 1\nmonitor D disc 2\nstep 0.1\nstage s\ncycles 1\n",
       NULL},
      {LATTICE("5.85", "5.8501", "3 by 3 from 1 1 radius 1 spacing 1.95"), NEAREST},
      {CELL_OF("5.85", "5.85", "1e9") EIGHT "disc 4.9 4.9 radius 1 a\nmonitor D disc 2\nstep 0.1\nstage s\ncycles 1\n",
       SINE});
  /* Without rotation a wave along x with displacements in y grows if k_s < F/s = 9*0.05/1.95 = 0.23077. */
  PARTS("lattice_waves",
        "material a density 1 kn 9 ks @ friction 1e9\nnormal linear\nshear linear\nperiodic cell 0 0 to 5.85 5.85\n"
        "lattice discs 3 by 3 from 1 1 radius 1 spacing 1.95 a\nperturb wave 1e-3 2e-3 periods 1 0\nmonitor D disc 2\n"
        "step 0.1\nstage s\nrotation off\ncycles 1\n",
        {"0.2308", NULL},
        {"0.2307", "a stable lattice: this wave grows, because k_s is too small for the force of the contacts"});
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
  /* Strains add up, also if a stage keeps the rate of the one before. Without friction there is no k_s. The cell with
   * friction is wide, the other one is high. */
  for (int hexagonal = 0; hexagonal < 2; hexagonal++)
    for (int friction = 0; friction < 2; friction++) {
      const int nx = friction ? 8 : 4, ny = friction ? 4 : 10;
      char page[1024];
      snprintf(
          page, sizeof page,
          "material a density 1 kn 9 ks 4 friction %d\nnormal linear\nshear linear\n"
          "lattice spheres %d by %d %s from 1 1 radius 1 spacing 1.95 a\nperiodic cell 0 0 to %.17g %.17g\nstep 0.1\n"
          "stage s\ncell strain -1e-3 per cycle -2e-3 per cycle shear 3e-4 per cycle\ncycles 2\n"
          "stage t\ncycles 3\nstage u\ncell strain 1e-2 4e-2 shear -5e-2\ncycles 4\n",
          friction, nx, ny, hexagonal ? "hexagonal" : "", 1.95 * nx, 1.95 * ny * (hexagonal ? sqrt(0.75) : 1));
      const double kn = 9. / 2, ks = friction * 4. / 2, b = sqrt(3) / 4, first = kn * 0.05 / 1.95; /* 2R = 2 thick */
      const double along = hexagonal ? b * (3 * kn + ks) : kn, across = hexagonal ? b * (kn - ks) : 0,
                   turned = hexagonal ? along - across : ks, rest = hexagonal ? 4 * b * first : first;
      const double e[3][3] = {{-2e-3, -4e-3, 6e-4}, {-5e-3, -1e-2, 1.5e-3}, {-1e-3, 6e-3, -1.85e-2}};
      double xx[3], yy[3], xy[3];
      for (int s = 0; s < 3; s++)
        xx[s] = rest - along * e[s][0] - across * e[s][1], yy[s] = rest - across * e[s][0] - along * e[s][1],
        xy[s] = -turned * e[s][2];
#define STRESS(in, s)                                                                                                  \
  {"cell.stress.xx" in, xx[s]}, {"cell.stress.yy" in, yy[s]}, {"cell.stress.xy" in, xy[s]},                            \
      {"cell.stress.yx" in, xy[s]}, {"cell.stress.mean" in, (xx[s] + yy[s]) / 2}
      VALUES("lattice_moduli", page, 1, STRESS(" in s", 0), STRESS(" in t", 1), STRESS(" in u", 2), STRESS("", 2));
#undef STRESS
    }
}

/* An assembly that is at rest in an accumulated strain. */
static void literal_field(void) {
#define SPHERES(b)                                                                                                     \
  "material a density 3 young 7 poisson 0.2\nmaterial b density 3 young 7 poisson 0.2\nnormal hertz\n"                 \
  "shear mindlin\nsphere 0 0 radius 1 a\nsphere 5 0 radius 2 a\nsphere 0 5 radius 1 " b "\nregion R box 0 0 to 9 9\n"  \
  "region S circle 1 2 radius 3\nregion T circle 0 0 radius 4\nmonitor D sphere 1\nstep 0.1 of rayleigh-fit-mean\n"
#define LAST                                                                                                           \
  "a last stage with `affine strain E -E accumulated` per cycle, and a step that is a fraction of rayleigh-fit-mean"
#define STRAIN(e) "stage s\naffine strain " e " accumulated\ncycles 1\n"
  const double mass = 3 * 4 * pi / 3 * 10 / 3, radius = 4. / 3, shear = 7 / 2.4;
  const double step = 0.25 * pi * radius * sqrt(3 / shear) / (0.1631 * 0.2 + 0.876605);
  VALUES("literal_field",
         SPHERES("a") STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 0.25 of rayleigh-fit-mean\naffine strain "
                                                               "-2e-6 per cycle 2e-6 per cycle accumulated\ncycles 1\n",
         0, {"S.unbalanced.force in t", mass * 2 / 3 * 3 * 2e-6 / (step * step)},
         {"T.unbalanced.force in t", mass * 2 / 3 * 4 * 2e-6 / (step * step)});
  PARTS("literal_field", SPHERES("a") "@", {STRAIN("1e-6 per cycle -1e-6 per cycle"), NULL},
        {STRAIN("1e-6 per cycle -1.1e-6 per cycle"), LAST}, {STRAIN("1e-6 per cycle 1e-6 per cycle"), LAST},
        {STRAIN("1e-6 -1e-6"), LAST}, {STRAIN("1e-6 per cycle -1e-6 per cycle c12 1e-9 per cycle"), LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle c21 -1e-9 per cycle"), LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\naffine strain 1e-6 per cycle -1e-6 per cycle\ncycles 1\n",
         LAST},
        {"stage r\naffine strain 1e-6 per cycle -2e-6 per cycle\ncycles 1\n" STRAIN("1e-6 per cycle -1e-6 per cycle"),
         NULL},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 0.1 of rayleigh-fit\naffine strain 1e-6 per cycle "
                                                  "-1e-6 per cycle accumulated\ncycles 1\n",
         LAST},
        {STRAIN("1e-6 per cycle -1e-6 per cycle") "stage t\nstep 1e-3\naffine strain 1e-6 per cycle -1e-6 per cycle "
                                                  "accumulated\ncycles 1\n",
         LAST});
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
#define REGION(area)                                                                                                   \
  {"R.stress.xx at 0 cycles", sigma[0]}, {"R.stress.xy at 0 cycles", sigma[1]}, {"R.stress.yy at 0 cycles", sigma[2]}, \
      {"R.stress.mean at 0 cycles", (sigma[0] + sigma[2]) / 2},                                                        \
      {"R.stress.sinphi at 0 cycles",                                                                                  \
       sqrt(pow(sigma[0] - sigma[2], 2) + 4 * sigma[1] * sigma[1]) / (sigma[0] + sigma[2])},                           \
      {"R.fabric.xx at 0 cycles", phi[0] / z}, {"R.fabric.xy at 0 cycles", phi[1] / z},                                \
      {"R.fabric.yy at 0 cycles", phi[2] / z}, {"R.fabric.fourth.xxxx at 0 cycles", fourth[0] / z},                    \
      {"R.fabric.fourth.xxyy at 0 cycles", fourth[1] / z}, {"R.fabric.fourth.yyyy at 0 cycles", fourth[2] / z},        \
      {"R.fabric.kk at 0 cycles", 2 * z / (area)}, {"R.coordination at 0 cycles", 2 * z},                              \
      {"R.porosity at 0 cycles", 1 - pi / (area)}
  VALUES("lattice_stress", ROWS(FIRST, FOURTH, BOX), 0, REGION(s * h));
  VALUES("lattice_stress", ROWS(FOURTH, FIRST, BOX), 0, REGION(s * h)); /* from top to bottom: a_2 points down */
  /* Five neighbours on each side, at multiples of 0.375, and a row at the distance 2 that just touches. */
  double stress = 0;
  for (int k = 1; k <= 5; k++)
    stress += 9 * (2 - 0.375 * k) * 0.375 * k / (0.375 * 2);
  sigma[1] = phi[1] = fourth[1] = 0, z = 5;
  for (int upright = 0; upright < 2; upright++) {
    for (int k = 0; k < 2; k++)
      sigma[2 * k] = k == upright ? stress : 0, phi[2 * k] = fourth[2 * k] = k == upright ? z : 0;
    VALUES("lattice_stress",
           upright
               ? "material a density 1 kn 9\nnormal linear\nlattice discs 2 by 1 from 0 0 radius 1 spacing 2 a\n"
                 "lattice discs 2 by 1 from 0 0.375 radius 1 spacing 2 a\nregion R box 1 1 to 3 1.375\n"
                 "step 1\nstage s\ncycles 1\n"
               : "material a density 1 kn 9\nnormal linear\nlattice discs 3 by 1 from 0 0 radius 1 spacing 0.375 a\n"
                 "lattice discs 3 by 1 from 0 2 radius 1 spacing 0.375 a\nregion R box 1 1 to 1.375 3\n"
                 "step 1\nstage s\ncycles 1\n",
           1, REGION(0.375 * 2));
  }
#undef REGION
#define THIRD(more) "disc 0.8 3.6 radius 1 a\n" more "\n"
  PARTS(
      "lattice_stress", "@", {ROWS(FIRST, "", BOX), NULL},
      {ROWS("disc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a\n", "", BOX), NULL}, {ROWS("", "", BOX), EQUAL},
      {ROWS("lattice discs 4 by 1 from -7.2 1.8 radius 1 spacing 1.9 a\n", "", BOX), EQUAL},
      {ROWS(FIRST, THIRD("disc 2.7 3.6 radius 1 a"), BOX), NULL},
      {ROWS(FIRST, THIRD("disc 2.7001 3.6 radius 1 a"), BOX), EQUAL},
      {ROWS(FIRST, THIRD("disc 2.7 3.6001 radius 1 a"), BOX), EQUAL},
      {ROWS(FIRST, THIRD("disc 2.74 3.78 radius 1 a"), BOX), EQUAL}, /* by a_2/10 */
      {"material a density 1 kn 9\nnormal linear\ndisc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a\n"
       "disc 0.4 1.8 radius 1 a\nregion R " BOX "\nstep 1\nstage s\ncycles 1\n",
       NULL},
      {"material a density 1 kn 9\nnormal linear\ndisc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a\nregion R " BOX
       "\nstep 1\nstage s\ncycles 1\n",
       EQUAL},
      {"material a density 1 kn 9\nnormal linear\ndisc 0 0 radius 1 a\nregion R " BOX "\nstep 1\nstage s\ncycles 1\n",
       EQUAL},
      {"material a density 1 kn 9\nnormal linear\ndisc 0 0 radius 1 a\ndisc 1.9 0.4 radius 1 a\ndisc 0 1.8 radius 1 a\n"
       "region R box 0.1 0.1 to 2 1.9\nstep 1\nstage s\ncycles 1\n",
       CELLS}, /* rows that are not along x */
      {ROWS(FIRST, "", BOX "\nregion S box 0.3 0.2 to 4.2 2"), CELLS},
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

void suite_refs_lattices(void) {
  CU_pSuite suite = CU_add_suite("refs_lattices", NULL, refs_released);
  CU_ADD_TEST(suite, boxed_lattice);
  CU_ADD_TEST(suite, boxed_lattice_and_a_disc);
  CU_ADD_TEST(suite, servo_lattice);
  CU_ADD_TEST(suite, ring_strain);
  CU_ADD_TEST(suite, stress_ring);
  CU_ADD_TEST(suite, lattice_waves);
  CU_ADD_TEST(suite, lattice_moduli);
  CU_ADD_TEST(suite, literal_field);
  CU_ADD_TEST(suite, lattice_stress);
}
