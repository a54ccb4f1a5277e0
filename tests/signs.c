/* The signs of forces and moments. The signs on a pair of discs are compared with [CS79], and assemblies with their
 * mirrored and rotated copies.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "chance.h"
#include "suites.h"
#include "written.h"

/* The force on the first disc is -(F_n e + F_s t), with the contact normal e and the contact tangent t, and the force
 * on the second disc is the opposite force. The moment on each disc is F_s times the radius of the disc,
 * counterclockwise. [CS79, The force-displacement law] */
static void forces_on_a_pair(void) {
  struct words page = {0};
  struct written it;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 1000 ks 700 friction 5\nshear linear\nstep 0.001\n"
      "disc 0 0 radius 1 m spin 2\ndisc 1.8 2.4 radius 2.1 m\nmonitor A disc 1\nmonitor B disc 2\nmonitor C disc 1 "
      "with disc 2\n"
      "record A.fx A.fy A.moment B.fx B.fy B.moment C.normal C.shear A.x A.y B.x B.y A.spin.half B.spin.half\n"
      "stage s\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (int cycle = 0; cycle < 20; cycle++) {
    written_cycles(model, 1);
    const double dx = written_now(model, "B.x") - written_now(model, "A.x");
    const double dy = written_now(model, "B.y") - written_now(model, "A.y"), d = hypot(dx, dy), e1 = dx / d,
                 e2 = dy / d;
    const double fn = written_now(model, "C.normal"), fs = written_now(model, "C.shear");
    CU_ASSERT(fn > 0 && fs < 0); /* the surface of A moves against t, so the slip is negative */
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fx"), -(fn * e1 + fs * e2), 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fy"), -(fn * e2 - fs * e1), 1e-12);
    CU_ASSERT(written_now(model, "A.fx") + written_now(model, "B.fx") == 0);
    CU_ASSERT(written_now(model, "A.fy") + written_now(model, "B.fy") == 0);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.moment"), fs, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "B.moment"), 2.1 * fs, 1e-13);
  }
  /* Like gear wheels: A slows down, and B rotates the other way. */
  CU_ASSERT(written_now(model, "A.spin.half") < 2 && written_now(model, "B.spin.half") < 0);
  nb_model_free(model);
  written_free(&it);
}

/* A disc rotates counterclockwise on the floor. So the floor pushes the disc in -x, and the disc pushes the floor in
 * +x. */
static void force_on_a_wall(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1000 ks 700 friction 0.5\nshear linear\nstep 0.001\n"
                   "disc 0 0.99 radius 1 m spin 2\nwall floor -9 0 to 9 0 m\nmonitor A disc 1\nmonitor F wall floor\n"
                   "record A.fx A.fy A.moment F.fx F.fy\nstage s\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 3);
  CU_ASSERT(written_now(model, "A.fx") < 0 && written_now(model, "A.fy") > 0 && written_now(model, "A.moment") < 0);
  CU_ASSERT(written_now(model, "F.fx") == -written_now(model, "A.fx"));
  CU_ASSERT(written_now(model, "F.fy") == -written_now(model, "A.fy"));
  nb_model_free(model);
  written_free(&it);
}

/* ---- assemblies ---- */

enum { DISCS = 40, CYCLES = 400 };

/* The transformation (x, y) -> (xx x + xy y, yx x + yy y); a negative determinant changes the sign of angular
 * velocities. */
struct turn {
  double xx, xy, yx, yy;
};
static double turned_x(struct turn t, double x, double y) { return t.xx * x + t.xy * y; }
static double turned_y(struct turn t, double x, double y) { return t.yx * x + t.yy * y; }

static void assembly(struct written *it, struct turn t) {
  struct words page = {0};
  struct chance chance = chance_begin(4);
  const double sense = t.xx * t.yy - t.xy * t.yx < 0 ? -1 : 1;
  static const double walls[][6] = {
      {-3, -1.5, 13, -1.5, 0.3, 1}, {11, -3, 12, 9, -1, 0}, {12, 8, -3, 9, 0, -1}, {-1, 9, -1, -3, 1, 0.2}};
  words_add(&page, "units none\nmaterial m density 1 kn 1e4 ks 7e3 friction 0.3\nshear linear\nstep 0.001\n"
                   "damping ratio 0.05\ndamping con1 0.999 as all\n");
  for (int w = 0; w < 4; w++)
    words_add(&page, "wall w%d %.17g %.17g to %.17g %.17g m velocity %.17g %.17g\n", w,
              turned_x(t, walls[w][0], walls[w][1]), turned_y(t, walls[w][0], walls[w][1]),
              turned_x(t, walls[w][2], walls[w][3]), turned_y(t, walls[w][2], walls[w][3]),
              turned_x(t, walls[w][4], walls[w][5]), turned_y(t, walls[w][4], walls[w][5]));
  for (int k = 0; k < DISCS; k++) {
    const double x = 1.5 * (k % 8) + chance_between(&chance, -0.3, 0.3),
                 y = 1.5 * (k / 8) + chance_between(&chance, -0.3, 0.3);
    const double vx = chance_between(&chance, -2, 2), vy = chance_between(&chance, -2, 2);
    words_add(&page, "disc %.17g %.17g radius %.17g m velocity %.17g %.17g spin %.17g\nmonitor D%d disc %d\n",
              turned_x(t, x, y), turned_y(t, x, y), chance_between(&chance, 0.6, 0.9), turned_x(t, vx, vy),
              turned_y(t, vx, vy), sense * chance_between(&chance, -3, 3), k, k + 1);
    words_add(&page, "record D%d.x D%d.y D%d.angle\n", k, k, k);
  }
  words_add(&page, "record contacts\nstage s\nrecord every %d cycles\ncycles %d\n", CYCLES, CYCLES);
  written_scene(it, &page);
}

/* Runs the assembly and its transformed copy. Compares the final positions and rotations of the copy with the
 * transformed ones of the assembly, and returns the largest difference. */
static double differ(struct turn t) {
  struct written straight, turned;
  struct nb_result a, b;
  assembly(&straight, (struct turn){1, 0, 0, 1}), assembly(&turned, t);
  written_run(&a, &straight, NULL), written_run(&b, &turned, NULL);
  const double *p = a.table.values + a.table.column_count, *q = b.table.values + b.table.column_count;
  const double sense = t.xx * t.yy - t.xy * t.yx < 0 ? -1 : 1;
  double most = 0;
  for (int k = 0; k < DISCS; k++, p += 3, q += 3) {
    most = fmax(most, fabs(q[0] - turned_x(t, p[0], p[1])));
    most = fmax(most, fabs(q[1] - turned_y(t, p[0], p[1])));
    most = fmax(most, fabs(q[2] - sense * p[2]));
  }
  CU_ASSERT(*p > DISCS / 2 && *p == *q); /* the number of contacts */
  nb_result_free(&a), nb_result_free(&b);
  written_free(&straight), written_free(&turned);
  return most;
}

/* Changes of sign, and of the order of two terms, do not change the rounding: no bit may differ. */
static void mirrors_and_rotations_by_90_degrees(void) {
  CU_ASSERT_EQUAL(differ((struct turn){-1, 0, 0, 1}), 0);
  CU_ASSERT_EQUAL(differ((struct turn){1, 0, 0, -1}), 0);
  CU_ASSERT_EQUAL(differ((struct turn){0, 1, 1, 0}), 0);
  CU_ASSERT_EQUAL(differ((struct turn){0, -1, 1, 0}), 0);
}

/* Other rotations and reflections change the rounding. Collisions amplify the difference, here to 6e-12. */
static void any_rotation(void) {
  CU_ASSERT(differ((struct turn){cos(0.5), -sin(0.5), sin(0.5), cos(0.5)}) < 1e-10);
  CU_ASSERT(differ((struct turn){cos(2), sin(2), sin(2), -cos(2)}) < 1e-10);
}

void suite_signs(void) {
  CU_pSuite suite = CU_add_suite("signs", NULL, NULL);
  CU_add_test(suite, "forces and moments on a pair", forces_on_a_pair);
  CU_add_test(suite, "force on a wall", force_on_a_wall);
  CU_add_test(suite, "mirrors and rotations by 90 degrees change no bit", mirrors_and_rotations_by_90_degrees);
  CU_add_test(suite, "other rotations change only the rounding", any_rotation);
}
