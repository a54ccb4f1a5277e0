/* Scenes for the tests of references, built without reading a page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reference.h"

/* A scene and its arrays, which a test may change. There is nothing to free. */
struct refs_scene {
  struct nb_scene scene;
  struct nb_material materials[3];
  struct nb_pair_rule rules[3];
  struct nb_particle particles[9];
  struct nb_wall walls[4];
  struct nb_monitor monitors[32];
  struct nb_stage stages[2];
  struct nb_wall_motion motions[8];
};

/* Nine discs of radius 50 and density 1000 in a box [CS79 figure 5], with kn = 1.35e9 and the given ks and friction.
 * The walls south, east, north and west move inward at 0.12 for `load` cycles and are at rest for `rest` cycles. The
 * step is 0.12 of single-contact. The monitors are four contacts. C: disc 5 with disc 6; D: disc 1 with disc 2; S: disc
 * 1 with wall south; M: disc 2 with wall south. */
void refs_nine_discs(struct refs_scene *it, double ks, double friction, unsigned long load, unsigned long rest);

/* Two discs between walls west and east that move inward at v for `load` cycles and are at rest for `rest` cycles. Disc
 * 1 has radius 1, disc 2 radius 2. The monitors A, B, C are the contacts from west to east, with the stiffnesses `k`;
 * the monitors X, Y are the discs 1 and 2, with the masses `m`. `step` is in s. */
void refs_row(struct refs_scene *it, const double k[3], const double m[2], double v, double step, unsigned long load,
              unsigned long rest);

/* The solution of a reference; the test fails when the reference refuses the scene. Free it with solution_free. */
struct nb_solution refs_solution(const char *reference, const struct refs_scene *it);
/* The value with this name; NAN, and the test fails, when the solution has no such value. */
double refs_value(const struct nb_solution *solution, const char *name);
/* The error of a reference that refuses the scene; the test fails when the reference accepts the scene. */
struct nb_error refs_refused(const char *reference, const struct refs_scene *it);

/* Asserts |a - b| <= fraction * |scale|. */
#define REFS_NEAR(a, b, fraction, scale) CU_ASSERT(fabs((a) - (b)) <= (fraction)*fabs(scale))
