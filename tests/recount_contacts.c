/* The contacts of a snapshot, computed again from its particles: directions, overlaps, Hertz's forces, and their
 * sums; and the force chains of a region, found again from these contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "recount.h"
#include "suites.h"

/* Tests a value of the contact in this row. Overlaps of 1e-2 are differences of coordinates, with rounding errors of
 * 1e-15. */
static void is(const struct nb_table *table, size_t row, const char *name, double wanted) {
  const double seen = of(table, row, name);
  if (!(fabs(seen - wanted) <= 1e-9 * (1 + fabs(wanted)))) {
    printf("# contact %zu, %s: %.17g, wanted %.17g\n", row, name, seen, wanted);
    CU_FAIL("a contact does not follow from its particles");
  }
}

/* Direction, overlap and Hertz's force of each contact follow from its two particles, or from its particle and its
 * wall; the force on each particle is the sum over its contacts. */
static void contacts_follow_from_particles(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  double fx[PARTICLES] = {0}, fy[PARTICLES] = {0}, touching[PARTICLES] = {0};
  made(&it, &result);
  const struct nb_table *table = &result.snapshots[0].contacts;
  const double ends[] = {0, 9.85, 9.9, 0}; /* y of south, x of east, y of north; west moves */
  read_particles(&all, &result.snapshots[0].particles);
  CU_ASSERT_EQUAL(result.snapshots[0].particles.row_count, 28);
  for (size_t k = 0; k < result.snapshots[0].walls.row_count; k++)
    CU_ASSERT_EQUAL(of(&result.snapshots[0].walls, k, "wall"), (double)k + 1);
  CU_ASSERT(table->row_count > 30);
  for (size_t c = 0; c < table->row_count; c++) {
    const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b"), wall = (int)of(table, c, "wall");
    const struct particle *one = &all.of[a], *two = &all.of[b];
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
  for (int k = 1; k < PARTICLES; k++) {
    CU_ASSERT_DOUBLE_EQUAL(all.of[k].fx, fx[k], 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(all.of[k].fy, fy[k], 1e-9);
    CU_ASSERT_EQUAL(all.of[k].touching, touching[k]);
  }
  nb_result_free(&result), written_free(&it);
}

/* ---- force chains ---- */

/* A particle, and the chain that it belongs to. */
struct chained {
  double r, volume, stress[3]; /* xx, xy, yy */
  bool free, inside, strong;
  int chain; /* the number of one particle of the chain */
};

static double major(const double s[3]) { return (s[0] + s[2]) / 2 + hypot((s[0] - s[2]) / 2, s[1]); }

/* True if a direction is within 45 degrees of the major principal axis of the stress s, by their angles. */
static bool along_axis(const double s[3], double ex, double ey) {
  const double off = atan2(ey, ex) - atan2(2 * s[1], s[0] - s[2]) / 2;
  return fabs(remainder(off, pi)) < pi / 4;
}

/* Discs and spheres with large friction, one of them fixed, compressed and sheared. */
static void run_assembly(struct written *it, struct nb_result *result, int seed) {
  struct words page = {0};
  words_add(
      &page,
      "units none\nmaterial m density 3 kn 3000 ks 2500 friction 0.9\nshear linear\ndamping mass 2\nstep 0.004\n"
      "disc 6 6 radius 0.5 m fixed\nbox 0 0 to 12 12 m\ngrading g 0.9 8 0.7 12\ngrading h 0.8 10 0.6 15\n"
      "fill discs box 0.1 0.1 to 11.9 11.9 g m seed %d attempts 20000 else skip\n"
      "fill spheres box 0.1 0.1 to 11.9 11.9 h m seed %d attempts 20000 else skip\n"
      "region B circle 6 6 radius 4.2\nrecord B.chains B.chains.length B.chains.fraction B.chains.bend B.particles\n"
      "stage press\nbox strain -5e-5 per cycle -5e-5 per cycle\ncycles 6200\nrecord none\n"
      "stage shear\nbox strain 4e-5 per cycle -6e-5 per cycle\ncycles 1500\nrecord every 1500 cycles\nsnapshot\n",
      seed, seed + 100);
  written_scene(it, &page);
  written_run(result, it, NULL);
}

/* Particles are strong if they are free and inside the region, and if their major principal stress is above the mean.
 * Two strong particles in contact are linked if the contact is along the major axes of both. Three or more linked
 * particles are a chain. */
static void force_chains(void) {
  enum { MOST = 100, LINKS = 12 };
  double found = 0, turned = 0; /* sums over all seeds */
  for (int seed = 1; seed <= 16; seed++) {
    struct written it;
    struct nb_result result;
    struct chained all[MOST] = {{0}};
    double ahead[MOST][LINKS][2], particles = 0, sum = 0, rotates = 0, pairs = 0, chains = 0, members = 0;
    int links[MOST] = {0};
    run_assembly(&it, &result, seed);
    const struct nb_table *table = &result.snapshots[0].contacts, *places = &result.snapshots[0].particles;
    CU_ASSERT_FATAL(places->row_count < MOST);
    for (size_t k = 0; k < places->row_count; k++) {
      const int n = (int)of(places, k, "particle");
      struct chained *particle = &all[n];
      const double r = of(places, k, "radius");
      particle->r = r, particle->free = of(places, k, "fixed") == 0, particle->chain = n;
      particle->inside = hypot(of(places, k, "x") - 6, of(places, k, "y") - 6) <= 4.2;
      particle->volume = it.scene.particles[n - 1].shape == NB_SPHERE ? 4 * pi / 3 * r * r * r : pi * r * r;
    }
    for (size_t c = 0; c < table->row_count; c++)
      for (int second = 0; second < 2; second++) {
        struct chained *particle = &all[(int)of(table, c, second ? "b" : "a")];
        const double ex = of(table, c, "ex"), ey = of(table, c, "ey"), overlap = of(table, c, "overlap");
        const double total_normal = of(table, c, "normal"), total_shear = of(table, c, "shear"); /* for both ends */
        const double per = (particle->r - (of(table, c, "wall") > 0 ? overlap : overlap / 2)) / particle->volume;
        const double fx = total_normal * ex + total_shear * ey, fy = total_normal * ey - total_shear * ex;
        particle->stress[0] += per * fx * ex, particle->stress[1] += per * (fx * ey + fy * ex) / 2,
            particle->stress[2] += per * fy * ey;
      }
    for (int n = 1; n < MOST; n++)
      if (all[n].inside && all[n].free)
        particles++, sum += major(all[n].stress);
    for (int n = 1; n < MOST; n++)
      all[n].strong = all[n].inside && all[n].free && major(all[n].stress) > sum / particles;
    for (size_t c = 0; c < table->row_count; c++) {
      const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b");
      const double ex = of(table, c, "ex"), ey = of(table, c, "ey");
      if (!b || !all[a].strong || !all[b].strong || !along_axis(all[a].stress, ex, ey) ||
          !along_axis(all[b].stress, ex, ey))
        continue;
      CU_ASSERT_FATAL(links[a] < LINKS && links[b] < LINKS);
      ahead[a][links[a]][0] = ex, ahead[a][links[a]++][1] = ey;
      ahead[b][links[b]][0] = -ex, ahead[b][links[b]++][1] = -ey;
      for (int n = 1, of_b = all[b].chain; n < MOST; n++)
        all[n].chain = all[n].chain == of_b ? all[a].chain : all[n].chain;
    }
    for (int n = 1; n < MOST; n++) {
      int length = 0;
      for (int m = 1; m < MOST; m++)
        length += all[m].chain == n;
      chains += length > 2, members += length > 2 ? length : 0;
      for (int k = 0; k < links[n]; k++)
        for (int l = 0; l < k; l++) {
          const double on = -(ahead[n][k][0] * ahead[n][l][0] + ahead[n][k][1] * ahead[n][l][1]);
          pairs += on > 0, rotates += on > 0 ? acos(fmin(on, 1)) : 0;
        }
    }
    found += chains, turned += pairs;
    CU_ASSERT_EQUAL(written_last(&result, "B.chains"), chains);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "B.chains.length"), chains > 0 ? members / chains : 0, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "B.chains.fraction"), members / particles, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "B.chains.bend"), pairs > 0 ? rotates / pairs : 0,
                           1e-6); /* near 1 the error of acos is the square root of the rounding error */
    nb_result_free(&result), written_free(&it);
  }
  CU_ASSERT(found >= 5 && turned >= 10);
}

void suite_recount_contacts(void) {
  CU_pSuite suite = CU_add_suite("recount_contacts", NULL, NULL);
  CU_ADD_TEST(suite, contacts_follow_from_particles);
  CU_ADD_TEST(suite, force_chains);
}
