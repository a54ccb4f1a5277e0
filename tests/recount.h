/* An assembly whose measures the tests compute again from its snapshot: spheres of several sizes, walls, a fixed
 * particle, a removed particle, contacts that slide and contacts that stick.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "written.h"

static const double pi = 3.14159265358979323846;
enum { PARTICLES = 40 };
/* Centre and radius of the region B, a circle. It contains contacts with a wall, and its edge cuts contacts of equal
 * and of unequal spheres. */
static const double at_x = 3.4, at_y = 4.4, reach = 3.2;

/* The value of a column in this row. */
static inline double of(const struct nb_table *table, size_t row, const char *name) {
  for (size_t c = 0; c < table->column_count; c++)
    if (strcmp(table->names[c], name) == 0)
      return table->values[row * table->column_count + c];
  printf("# no column %s\n", name);
  CU_FAIL("no such column");
  return NAN;
}

#define TENSOR(stem) "B." stem ".xx B." stem ".xy B." stem ".yx B." stem ".yy "
#define SPREAD(stem) "B." stem ".mean B." stem ".max B." stem ".min B." stem ".std "
#define FOURTH(stem)                                                                                                   \
  "B." stem ".fourth.xxxx B." stem ".fourth.xxxy B." stem ".fourth.xxyy B." stem ".fourth.xyyy B." stem ".fourth."     \
  "yyyy "

/* Runs the assembly. It has two stages and a snapshot at the end. */
static inline void made(struct written *it, struct nb_result *result) {
  struct words page = {0};
  words_add(
      &page,
      "units none\nmaterial m density 3 young 50000 poisson 0.25 friction 0.2\nnormal hertz\nshear mindlin\n"
      "box 0 0 to 9.85 9.9 m\nlattice spheres 5 by 5 m radius 0.98 spacing 1.97 from 0.99 1\n"
      "sphere 1.98 1.99 radius 0.45 m\nsphere 5.92 3.96 radius 0.45 m fixed\nsphere 3.95 5.93 radius 0.4 m\n"
      "sphere 3.95 3.96 radius 0.43 m\ngravity 3 -9\nstep 0.001\n"
      "region B circle 3.4 4.4 radius 3.2\nrecord " TENSOR("stress") TENSOR("stress.contacts") TENSOR("stress.normal")
          TENSOR("stress.shear") TENSOR("stress.fabric") TENSOR("stress.variation") TENSOR("fabric") TENSOR(
              "fabric.normal") TENSOR("fabric.shear") TENSOR("fabric.sliding") FOURTH("fabric") FOURTH("fabric.sliding")
              SPREAD("normal") SPREAD("shear") SPREAD("contact_stress") SPREAD("contact_shear") SPREAD("contact_ratio")
                  SPREAD("obliquity") "B.stress.mean B.stress.sinphi "
                                      "B.stress.normal.fraction B.stress.shear.fraction "
                                      "B.stress.fabric.fraction "
                                      "B.stress.variation.fraction B.anisotropy.contacts "
                                      "B.anisotropy.normal B.anisotropy.shear B.anisotropy.sinphi B.modulus.bulk "
                                      "B.modulus.bulk.lower "
                                      "B.modulus.shear B.constraint_ratio B.fabric.kk B.sliding B.sliding.near "
                                      "B.unbalanced.mean "
                                      "B.unbalanced.force B.particles "
                                      "B.contacts B.coordination B.area B.speed.mean "
                                      "B.speed.max\n"
                                      "stage a\nwall west velocity 0.3 0.2\nrecord every 400 cycles\ncycles 400\n"
                                      "stage b\nremove sphere 7\ncycles 150\nrecord every 150 cycles\nsnapshot\n");
  written_scene(it, &page);
  written_run(result, it, NULL);
}

struct particle {
  bool there, inside, fixed;        /* not removed; centre in the region */
  double x, y, r, fx, fy, touching; /* r: radius; touching: number of contacts */
};
struct particles {
  struct particle of[PARTICLES]; /* by their numbers */
  double thickness;              /* mean diameter of all particles */
  double radius, count, free; /* mean radius of the particles inside, their number, and that of the free ones of them */
};

static inline void read_particles(struct particles *all, const struct nb_table *table) {
  double there = 0;
  *all = (struct particles){.count = 0};
  for (size_t k = 0; k < table->row_count; k++, there++) {
    struct particle *b = &all->of[(int)of(table, k, "particle")];
    *b = (struct particle){true,
                           false,
                           of(table, k, "fixed") > 0,
                           of(table, k, "x"),
                           of(table, k, "y"),
                           of(table, k, "radius"),
                           of(table, k, "fx"),
                           of(table, k, "fy"),
                           of(table, k, "contacts")};
    b->inside = hypot(b->x - at_x, b->y - at_y) <= reach;
    all->thickness += 2 * b->r;
    all->radius += b->inside ? b->r : 0, all->count += b->inside, all->free += b->inside && !b->fixed;
  }
  all->thickness /= there, all->radius /= all->count;
}
