/* The contacts of a snapshot against the bodies of the same moment: directions, overlaps, forces by Hertz, and their sums.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "recount.h"
#include "suites.h"

/* Overlaps are differences of places: rounded to 1e-15 of 1e-2. */
static void is(const struct nb_table *table, size_t row, const char *name, double wanted) {
  const double seen = of(table, row, name);
  if (!(fabs(seen - wanted) <= 1e-9 * (1 + fabs(wanted)))) {
    printf("# contact %zu, %s: %.17g, wanted %.17g\n", row, name, seen, wanted);
    CU_FAIL("a contact is not what its bodies make of it");
  }
}

/* Each contact against its two bodies, or its wall: direction, overlap, force by Hertz; and what bodies feel in all. */
static void contacts_are_those_of_the_bodies(void) {
  struct written it;
  struct nb_result result;
  struct bodies all;
  double fx[BODIES] = {0}, fy[BODIES] = {0}, touching[BODIES] = {0};
  made(&it, &result);
  const struct nb_table *table = &result.snapshots[0].contacts;
  const double ends[] = {0, 9.85, 9.9, 0}; /* south y, east x, north y, west x but for its motion */
  read_bodies(&all, &result.snapshots[0].bodies);
  CU_ASSERT_EQUAL(result.snapshots[0].bodies.row_count, 28);
  for (size_t k = 0; k < result.snapshots[0].walls.row_count; k++)
    CU_ASSERT_EQUAL(of(&result.snapshots[0].walls, k, "wall"), (double)k + 1);
  CU_ASSERT(table->row_count > 30);
  for (size_t c = 0; c < table->row_count; c++) {
    const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b"), wall = (int)of(table, c, "wall");
    const struct body *one = &all.of[a], *two = &all.of[b];
    const double west = of(&result.snapshots[0].walls, 3, "x1");
    const double to_x = !wall ? two->x : wall == 2 ? ends[1] : wall == 4 ? west : one->x;
    const double to_y = !wall ? two->y : wall == 1 ? ends[0] : wall == 3 ? ends[2] : one->y;
    const double d = hypot(to_x - one->x, to_y - one->y), ex = (to_x - one->x) / d, ey = (to_y - one->y) / d;
    const double overlap = one->r + (wall ? 0 : two->r) - d;
    const double curved = wall ? one->r : one->r * two->r / (one->r + two->r), radius = sqrt(curved * overlap);
    const double force = 4. / 3 * (50000 / (2 * (1 - 0.0625))) * radius * overlap, shear = of(table, c, "shear");
    const double small = wall ? one->r : fmin(one->r, two->r), area = pi * radius * radius;
    is(table, c, "ex", ex), is(table, c, "ey", ey), is(table, c, "angle", atan2(ey, ex));
    is(table, c, "overlap", overlap), is(table, c, "radius", radius), is(table, c, "ratio", radius / small);
    is(table, c, "ra", one->r), is(table, c, "rb", wall ? 0 : two->r);
    is(table, c, "x", one->x + (one->r - overlap / 2) * ex), is(table, c, "y", one->y + (one->r - overlap / 2) * ey);
    is(table, c, "normal", force), is(table, c, "limit", 0.2 * force);
    is(table, c, "obliquity", fabs(shear) / (0.2 * force));
    is(table, c, "normal_stress", force / area), is(table, c, "shear_stress", fabs(shear) / area);
    is(table, c, "fx", -(force * ex + shear * ey)), is(table, c, "fy", -(force * ey - shear * ex));
    fx[a] += of(table, c, "fx"), fy[a] += of(table, c, "fy"), touching[a]++;
    fx[b] -= of(table, c, "fx"), fy[b] -= of(table, c, "fy"), touching[b]++; /* [0]: walls */
  }
  for (int k = 1; k < BODIES; k++) {
    CU_ASSERT_DOUBLE_EQUAL(all.of[k].fx, fx[k], 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(all.of[k].fy, fy[k], 1e-9);
    CU_ASSERT_EQUAL(all.of[k].touching, touching[k]);
  }
  nb_result_free(&result), written_free(&it);
}

void suite_recount_contacts(void) {
  CU_pSuite suite = CU_add_suite("recount contacts", NULL, NULL);
  CU_ADD_TEST(suite, contacts_are_those_of_the_bodies);
}
