/* Random packings: the published numbers of the generator; particles that do not overlap, lie inside, are uniformly
 * distributed and are placed in the order of size; the same bits on every machine.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../src/core/model.h"
#include "../src/packing/random_numbers.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define ROCK "units none\nmaterial rock density 1 kn 1\n"
#define GRADED "grading g 0.92 30 0.31 30 0.76 138 0.46 230 0.61 172\n" /* R89's, mm, in no order */
#define WIDE "grading w 10 3 1 200 0.1 2000 0.01 500\n"
#define END "step 1e-3\nrecord cycle\nstage go\ncycles 1\n"

static void make(struct written *it, const char *statements) {
  struct words page = {0};
  words_add(&page, "%s", statements);
  words_add(&page, END);
  written_scene(it, &page);
}

/* The first five numbers of seed 1234567 as many sources print them, such as Rosetta Code, Pseudo-random
 * numbers/Splitmix64. */
static void published_numbers(void) {
  static const uint64_t expected[] = {UINT64_C(6457827717110365317), UINT64_C(3203168211198807973),
                                      UINT64_C(9817491932198370423), UINT64_C(4593380528125082431),
                                      UINT64_C(16408922859458223821)};
  struct nb_random bits = {1234567}, fractions = {1234567};
  for (int k = 0; k < 5; k++) {
    CU_ASSERT(nb_random_bits(&bits) == expected[k]);
    CU_ASSERT(nb_random_fraction(&fractions) == ldexp((double)(expected[k] >> 11), -53));
  }
}

/* Chi-squared test of uniformity. A uniform generator fails it once in a million times on either side. */
static void is_uniform(const int *counts, int cells, int total) {
  const double expected = (double)total / cells;
  double chi = 0;
  for (int c = 0; c < cells; c++)
    chi += (counts[c] - expected) * (counts[c] - expected) / expected;
  CU_ASSERT(chi < gsl_cdf_chisq_Qinv(1e-6, cells - 1));
  CU_ASSERT(chi > gsl_cdf_chisq_Pinv(1e-6, cells - 1)); /* not more uniform than random numbers either */
}

/* The first numbers of the seeds 1, 2, 3, ... are uniform, and those of successive seeds are independent. */
static void seeds_are_independent(void) {
  enum { SEEDS = 20000 };
  int counts[100] = {0}, pairs[100] = {0};
  for (int seed = 1; seed <= SEEDS; seed++) {
    struct nb_random one = {(uint64_t)seed}, next = {(uint64_t)seed + 1};
    const double a = nb_random_fraction(&one), b = nb_random_fraction(&next);
    counts[(int)(100 * a)]++;
    pairs[10 * (int)(10 * a) + (int)(10 * b)]++;
  }
  is_uniform(counts, 100, SEEDS);
  is_uniform(pairs, 100, SEEDS);
}

/* Particles so small that they exclude less than 1e-7 of the area: one attempt per particle is enough. */
#define TINY ROCK "grading dust 1e-6 20000\n"
enum { DUST = 20000 };

static void uniform_in_a_circle(void) {
  for (int seed = 1; seed <= 3; seed++) {
    struct written it;
    char page[256];
    int counts[80] = {0}; /* ten rings of equal area by eight octants */
    snprintf(page, sizeof page, TINY "fill discs circle 3 -2 radius 1 dust rock seed %d attempts 1 else stop\n", seed);
    make(&it, page);
    CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, DUST);
    for (size_t k = 0; k < DUST; k++) {
      const double x = it.scene.particles[k].x - 3, y = it.scene.particles[k].y + 2;
      const int ring = (int)(10 * (x * x + y * y)), octant = (x > 0) + 2 * (y > 0) + 4 * (fabs(x) > fabs(y));
      counts[8 * (ring < 10 ? ring : 9) + octant]++;
    }
    is_uniform(counts, 80, DUST);
    written_free(&it);
  }
}

static void uniform_in_a_box(void) {
  struct written it;
  int counts[100] = {0};
  make(&it, TINY "fill discs box -1 4 to 9 5 dust rock seed 7 attempts 1 else stop\n");
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, DUST);
  for (size_t k = 0; k < DUST; k++)
    counts[10 * (int)(it.scene.particles[k].x + 1) + (int)(10 * (it.scene.particles[k].y - 4))]++;
  is_uniform(counts, 100, DUST);
  written_free(&it);
}

/* Checks each particle from the index `first` on: it overlaps no particle before it, computed as in a cycle; it is not
 * across the edge, except by rounding; it is not larger than the particle before it. */
static void sound(const struct nb_scene *scene, size_t first) {
  const struct nb_fill *fill = &scene->fills[scene->fill_count - 1];
  size_t overlaps = 0, outside = 0;
  for (size_t i = first; i < scene->particle_count; i++) {
    const struct nb_particle *a = &scene->particles[i];
    for (size_t j = 0; j < i; j++) {
      const struct nb_particle *b = &scene->particles[j];
      const double dx = a->x - b->x, dy = a->y - b->y;
      overlaps += a->radius + b->radius - sqrt(dx * dx + dy * dy) > 0;
    }
    if (fill->circle)
      outside += hypot(a->x - fill->x, a->y - fill->y) + a->radius > fill->radius * (1 + 4e-16);
    else
      outside += a->x - a->radius < fill->x * (1 - 4e-16) || a->x + a->radius > fill->x1 * (1 + 4e-16) ||
                 a->y - a->radius < fill->y * (1 - 4e-16) || a->y + a->radius > fill->y1 * (1 + 4e-16);
    CU_ASSERT(i == first || a->radius <= a[-1].radius);
  }
  CU_ASSERT_EQUAL(overlaps, 0);
  CU_ASSERT_EQUAL(outside, 0);
}

/* The number placed of each size is the number of particles with this radius. */
static void counted(const struct nb_scene *scene) {
  size_t all = 0;
  for (size_t s = 0; s < scene->gradings[0].size_count; s++) {
    const struct nb_size *size = &scene->gradings[0].sizes[s];
    size_t there = 0;
    for (size_t k = 0; k < scene->particle_count; k++)
      there += scene->particles[k].radius == size->radius;
    CU_ASSERT_EQUAL(there, size->placed);
    CU_ASSERT(size->placed <= size->wanted && (s == 0 || size->radius < size[-1].radius));
    all += there;
  }
  CU_ASSERT_EQUAL(all, scene->particle_count);
}

static void no_overlap(void) {
  static const char *const fills[] = {
      GRADED "fill spheres circle 0 0 radius 19.5 g rock seed %d attempts 10000 else skip\n",
      GRADED "fill spheres circle 500 -300 radius 17 g rock seed %d attempts 1000 else skip\n",
      GRADED "fill discs box 20 30 to 70 48 g rock seed %d attempts 300 else skip\n",
      WIDE "fill discs circle -7 5 radius 27 w rock seed %d attempts 2000 else skip\n",
      WIDE "fill discs box 1 1 to 301 23 w rock seed %d attempts 500 else skip\n",
  };
  for (size_t f = 0; f < sizeof fills / sizeof *fills; f++)
    for (int seed = 1; seed <= 3; seed++) {
      struct written it;
      char page[512] = ROCK;
      snprintf(page + strlen(page), sizeof page - strlen(page), fills[f], seed);
      make(&it, page);
      CU_ASSERT(it.scene.particle_count > 300);
      sound(&it.scene, 0);
      counted(&it.scene);
      written_free(&it);
    }
}

/* Two gradings in one circle, around discs that are already there. */
static void no_overlap_with_existing_particles(void) {
  struct written it;
  make(&it, ROCK "disc 0 0 radius 8 rock fixed\ndisc 30 0 radius 20 rock fixed\n" GRADED WIDE
                 "fill discs circle 0 0 radius 30 g rock seed 1 attempts 100 else skip\n"
                 "fill discs circle 0 0 radius 30 w rock seed 1 attempts 100 else skip\n");
  CU_ASSERT(it.scene.fills[0].count > 400 && it.scene.fills[1].count > 400);
  CU_ASSERT_EQUAL(it.scene.fills[1].first, 2 + it.scene.fills[0].count);
  sound(&it.scene, it.scene.fills[1].first);
  it.scene.fill_count = 1, it.scene.particle_count = it.scene.fills[1].first;
  sound(&it.scene, 2);
  it.scene.fill_count = 2;
  written_free(&it);
  /* the only disc that is already there is larger than all sizes of the grading */
  make(&it, ROCK "disc 5 0 radius 20 rock fixed\n" GRADED
                 "fill discs circle 0 0 radius 30 g rock seed 1 attempts 100 else skip\n");
  CU_ASSERT(it.scene.fills[0].count > 400);
  sound(&it.scene, 1);
  written_free(&it);
  /* Dust a thousandth as large as the largest grains of the next grading: on the level of the dust, such a grain covers
   * more search boxes than there are dust particles. */
  make(&it,
       ROCK "grading dust 0.01 300\n" WIDE "fill discs circle 0 0 radius 30 dust rock seed 1 attempts 9 else stop\n"
            "fill discs circle 0 0 radius 30 w rock seed 2 attempts 1000 else skip\n");
  CU_ASSERT(it.scene.fills[0].count == 300 && it.scene.fills[1].count > 1000);
  sound(&it.scene, it.scene.fills[1].first);
  written_free(&it);
}

/* The test uses the probability p that a random place is free when the fraction q of the plane is covered, in powers of
 * q [Schaaf and Talbot, J. Chem. Phys. 91 (1989) 4401]. The expected number of attempts for N particles is the sum of
 * 1/p. Centres lie in a square of side a. A disc near its edge blocks a smaller part of the square than another disc:
 * on average the fraction 1 - 8 d/(3 pi a) of pi d^2, d = 2 R. The number of attempts of one particle is geometrically
 * distributed with the variance (1 - p)/p^2; the tolerance is four standard deviations. The neglected terms, q^4 and
 * the edge in second order, are 0.2 %. */
static void expected_number_of_attempts(void) {
  enum { PARTICLES = 20000 };
  const double pi = acos(-1), side = 560, a = side - 2, edge = 1 - 8 * 2 / (3 * pi * a);
  double tries = 0, variance = 0;
  for (int k = 0; k < PARTICLES; k++) {
    const double q = k * pi / (a * a);
    const double p =
        1 - 4 * edge * q + 6 * sqrt(3) / pi * q * q + (40 / (sqrt(3) * pi) - 176 / (3 * pi * pi)) * q * q * q;
    tries += 1 / p, variance += (1 - p) / (p * p);
  }
  for (int seed = 1; seed <= 3; seed++) {
    struct written it;
    char page[256];
    snprintf(page, sizeof page,
             ROCK "grading g 1 %d\nfill discs box 0 0 to %g %g g rock seed %d attempts 1000 else stop\n", PARTICLES,
             side, side, seed);
    make(&it, page);
    CU_ASSERT_DOUBLE_EQUAL((double)it.scene.fills[0].attempts_made, tries, 4 * sqrt(variance) + 0.002 * tries);
    written_free(&it);
  }
}

/* The first particle leaves no room, so the rest of its size and the next size take all their attempts. A particle
 * larger than the circle takes no attempt. */
static void attempts_and_skipped_sizes(void) {
  struct written it;
  make(&it, ROCK "grading g 1 3 2 1 0.1 4\nfill discs circle 5 5 radius 1 g rock seed 9 attempts 77 else skip\n");
  const struct nb_size *sizes = it.scene.gradings[0].sizes;
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 1);
  CU_ASSERT(it.scene.particles[0].x == 5 && it.scene.particles[0].y == 5); /* the only place */
  CU_ASSERT_EQUAL(it.scene.fills[0].attempts_made, 1 + 77 + 77);
  CU_ASSERT(sizes[0].placed == 0 && sizes[1].placed == 1 && sizes[2].placed == 0);
  CU_ASSERT(sizes[0].wanted == 1 && sizes[1].wanted == 3 && sizes[2].wanted == 4);
  written_free(&it);
  make(&it, ROCK "grading g 1 2 0.1 3\nfill discs circle 5 5 radius 1.3 g rock seed 9 attempts 1000 else skip\n");
  CU_ASSERT_EQUAL(it.scene.particle_count, 4); /* the rest of the first size is skipped, the next size is placed */
  CU_ASSERT_EQUAL(it.scene.gradings[0].sizes[0].placed, 1);
  written_free(&it);
}

/* The quantities of a grading are sums over its sizes; the quantities of a size count only this size. The scene has two
 * gradings, one of which is placed twice. */
static void quantities_of_gradings(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial rock density 1 kn 1\ngrading g 1 3 0.1 4\ngrading w 2 1 0.5 2\n"
            "fill discs circle 5 5 radius 1 g rock seed 9 attempts 77 else skip\n"
            "fill discs circle 50 5 radius 9 w rock seed 1 attempts 200 else skip\n"
            "fill discs circle 80 5 radius 2 w rock seed 2 attempts 30 else skip\n"
            "monitor G grading g\nmonitor W grading w\nmonitor L grading w radius 2\nmonitor S grading g radius 0.1\n"
            "record G.wanted G.placed G.dropped G.attempts W.wanted W.placed W.dropped W.attempts L.wanted L.placed "
            "L.dropped S.wanted S.placed S.dropped\nstep 1e-3\nstage go\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const struct nb_fill *fills = it.scene.fills;
  CU_ASSERT(fills[1].attempts_made >= 3 && fills[2].attempts_made == 31);
  const struct {
    const char *name;
    double value;
  } wanted[] = {{"G.wanted", 7},  {"G.placed", 1},
                {"G.dropped", 6}, {"G.attempts", 1 + 77 + 77},
                {"W.wanted", 6},  {"W.placed", 4},
                {"W.dropped", 2}, {"W.attempts", (double)(fills[1].attempts_made + fills[2].attempts_made)},
                {"L.wanted", 2},  {"L.placed", 2},
                {"L.dropped", 0}, {"S.wanted", 4},
                {"S.placed", 0},  {"S.dropped", 4}};
  for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++)
    CU_ASSERT_EQUAL(written_now(model, wanted[k].name), wanted[k].value);
  nb_model_free(model);
  written_free(&it);
}

/* Boxes as wide, or as high, as the disc. The only place of its centre is x + r, and by rounding one of the two edges
 * is nearer than r by the last bit. This place is refused, whichever edge is nearer. */
static void across_the_edge_by_rounding(void) {
  static const struct {
    double from, radius, to;
    bool low; /* the lower edge is the nearer one */
  } cases[] = {{5, 0.27, 5.54, true}, {0.7, 0.61, 1.92, false}};
  for (size_t k = 0; k < 2; k++)
    for (int upright = 0; upright < 2; upright++) {
      const double from = cases[k].from, r = cases[k].radius, to = cases[k].to,
                   place = from + r + (to - from - 2 * r) / 2;
      char page[256];
      struct written it;
      CU_ASSERT(to - from >= 2 * r && (place - from < r) == cases[k].low && (to - place < r) != cases[k].low);
      snprintf(page, sizeof page,
               ROCK "disc 99 99 radius 1 rock\ngrading g %g 1\n"
                    "fill discs box %g %g to %g %g g rock seed 1 attempts 9 else skip\n",
               r, upright ? 0 : from, upright ? from : 0, upright ? 9 : to, upright ? to : 9);
      make(&it, page);
      CU_ASSERT_EQUAL(it.scene.gradings[0].sizes[0].placed, 0);
      CU_ASSERT_EQUAL(it.scene.fills[0].attempts_made, 9);
      written_free(&it);
    }
}

/* The centre of a disc that has the circle's radius except for 8e-14 can only be that of the circle: the next
 * representable number is farther away, by 1.1e-13. Such a place is refused. */
static void across_the_circle_by_rounding(void) {
  int placed = 0;
  for (int seed = 1; seed <= 40; seed++) {
    char page[256];
    struct written it;
    snprintf(page, sizeof page,
             ROCK
             "disc 99 99 radius 1 rock\ngrading g 1 1\nfill discs circle %s radius 1.00000000000008 g rock seed %d "
             "attempts 1 else skip\n",
             seed % 2 ? "1000 0" : "0 1000", seed);
    make(&it, page);
    placed += (int)it.scene.gradings[0].sizes[0].placed;
    for (size_t k = 1; k < it.scene.particle_count; k++)
      CU_ASSERT(hypot(it.scene.particles[k].x - (seed % 2 ? 1000 : 0),
                      it.scene.particles[k].y - (seed % 2 ? 0 : 1000)) < 8.1e-14);
    written_free(&it);
  }
  CU_ASSERT(placed > 4 && placed < 36);
}

/* The FNV-1a hash of the bits, which must be the same with every compiler, option and machine. */
static uint64_t bits_of(const struct nb_scene *scene) {
  uint64_t hash = UINT64_C(14695981039346656037);
  for (size_t k = 0; k < scene->particle_count; k++) {
    const double numbers[] = {scene->particles[k].x, scene->particles[k].y, scene->particles[k].radius};
    for (int n = 0; n < 3; n++) {
      uint64_t bits;
      memcpy(&bits, &numbers[n], sizeof bits);
      for (int b = 0; b < 64; b += 8)
        hash = (hash ^ (bits >> b & 255)) * UINT64_C(1099511628211);
    }
  }
  return hash;
}

static void the_same_bits(void) {
  struct written it;
  make(&it, ROCK GRADED "fill spheres circle 0 0 radius 19.5 g rock seed 1 attempts 10000 else skip\n"
                        "fill spheres box 30 0 to 70 41 g rock seed 2 attempts 10000 else skip\n");
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 1200);
  CU_ASSERT(bits_of(&it.scene) == UINT64_C(2551416825784825474)); /* as gcc and clang make it, with -O0 and -O3 */
  written_free(&it);
}

#define CELL ROCK "periodic cell -3 2 to 47 32\n" /* 50 by 30 */

/* No two images overlap, and centres are everywhere in the cell, also nearer than a radius to its edges. */
static void no_overlap_across_edges(void) {
  for (int seed = 1; seed <= 3; seed++) {
    struct written it;
    char page[512];
    size_t overlaps = 0, across_x = 0, across_y = 0, outside = 0;
    snprintf(page, sizeof page, CELL GRADED "fill spheres cell g rock seed %d attempts 3000 else skip\n", seed);
    make(&it, page);
    const struct nb_particle *at = it.scene.particles;
    CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 600);
    for (size_t i = 0; i < it.scene.particle_count; i++) {
      outside += !(at[i].x >= -3 && at[i].x < 47 && at[i].y >= 2 && at[i].y < 32);
      across_x += at[i].x - at[i].radius < -3 || at[i].x + at[i].radius > 47;
      across_y += at[i].y - at[i].radius < 2 || at[i].y + at[i].radius > 32;
      for (size_t j = 0; j <= i; j++)
        for (int x = -1; x <= 1; x++)
          for (int y = -1; y <= 1; y++)
            overlaps += (i != j || x || y) && hypot(at[i].x - at[j].x + 50 * x, at[i].y - at[j].y + 30 * y) <
                                                  at[i].radius + at[j].radius - 1e-14;
    }
    CU_ASSERT_EQUAL(overlaps, 0);
    CU_ASSERT_EQUAL(outside, 0);
    CU_ASSERT(across_x > 7 && across_y > 12); /* 600 times 2 R/50 and 2 R/30, mean radius 0.5875: 14.1 and 23.5 */
    counted(&it.scene);
    written_free(&it);
  }
}

/* No two images of large particles overlap, whichever side of the cell is longer, and whatever its size is. Their radii
 * are up to a sixth of its shorter side. */
static void no_overlap_of_large_particles(void) {
  int across[2] = {0, 0}; /* particles across an edge, in cells of both sizes */
  for (int seed = 1; seed <= 20; seed++) {
    const bool upright = seed % 2;
    const double size = seed > 10 ? 0x1p-10 : 1;
    const double width = size * (upright ? 30 : 50), height = size * (upright ? 50 : 30);
    struct written it;
    char page[512];
    size_t overlaps = 0;
    snprintf(page, sizeof page,
             ROCK "periodic cell %.17g %.17g to %.17g %.17g\ngrading g %.17g 6 %.17g 9\nfill discs cell g rock seed %d "
                  "attempts 3000 "
                  "else skip\n",
             -3 * size, 2 * size, width - 3 * size, height + 2 * size, 5 * size, 4 * size, seed);
    make(&it, page);
    const struct nb_particle *at = it.scene.particles;
    CU_ASSERT(it.scene.particle_count > 7);
    for (size_t i = 0; i < it.scene.particle_count; i++)
      for (size_t j = 0; j < i; j++)
        overlaps += hypot(remainder(at[i].x - at[j].x, width), remainder(at[i].y - at[j].y, height)) <
                    at[i].radius + at[j].radius - 1e-14 * size;
    for (size_t i = 0; i < it.scene.particle_count; i++)
      across[seed > 10] += at[i].x - at[i].radius < -3 * size || at[i].y - at[i].radius < 2 * size;
    CU_ASSERT_EQUAL(overlaps, 0);
    written_free(&it);
  }
  CU_ASSERT(across[0] > 9 && across[1] > 9);
}

/* The centres are also uniformly distributed over the hundredths of the width and of the height. So an error that
 * leaves a strip of 1 % at an edge empty is found. */
static void uniform_in_a_cell(void) {
  struct written it;
  int counts[100] = {0}, columns[100] = {0}, rows[100] = {0};
  make(&it, TINY "periodic cell -1 4 to 9 5\nfill discs cell dust rock seed 7 attempts 1 else stop\n");
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, DUST);
  for (size_t k = 0; k < DUST; k++) {
    const double x = (it.scene.particles[k].x + 1) / 10, y = it.scene.particles[k].y - 4;
    CU_ASSERT_FATAL(x >= 0 && x < 1 && y >= 0 && y < 1);
    counts[10 * (int)(10 * x) + (int)(10 * y)]++, columns[(int)(100 * x)]++, rows[(int)(100 * y)]++;
  }
  is_uniform(counts, 100, DUST);
  is_uniform(columns, 100, DUST);
  is_uniform(rows, 100, DUST);
  written_free(&it);
}

/* Any image of an existing particle may be given; the packing is the same. */
static void any_copy_of_existing_particles(void) {
  static const char *const there[] = {"disc 1 30 radius 6 rock fixed\ndisc 25 10 radius 5 rock fixed\n",
                                      "disc 51 0 radius 6 rock fixed\ndisc 25 10 radius 5 rock fixed\n",
                                      "disc -1999 1230 radius 6 rock fixed\ndisc 2025 -1190 radius 5 rock fixed\n"};
  uint64_t first = 0;
  for (int k = 0; k < 3; k++) {
    struct written it;
    char page[512];
    snprintf(page, sizeof page, CELL "%s" GRADED "fill discs cell g rock seed 4 attempts 1000 else skip\n", there[k]);
    make(&it, page);
    CU_ASSERT_FATAL(it.scene.particle_count > 400);
    it.scene.particle_count -= 2;
    memmove(it.scene.particles, it.scene.particles + 2, it.scene.particle_count * sizeof *it.scene.particles);
    first = k ? first : bits_of(&it.scene);
    CU_ASSERT(bits_of(&it.scene) == first);
    written_free(&it);
  }
}

/* Two discs whose radii are 0.23 and 0.24 of the sides: the distance at which they overlap is nearly half of a side. */
static void two_that_nearly_fill_the_cell(void) {
  for (int seed = 1; seed <= 60; seed++) {
    struct written it;
    char page[512];
    snprintf(page, sizeof page,
             ROCK "skin 0.05\ndisc 5 5 radius 2.3 rock\nperiodic cell 0 0 to 10 10\ngrading g 2.4 1\nfill discs cell g "
                  "rock seed %d "
                  "attempts 1000 else stop\n",
             seed);
    make(&it, page);
    const struct nb_particle *at = it.scene.particles;
    CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 2);
    CU_ASSERT(hypot(remainder(at[1].x - 5, 10), remainder(at[1].y - 5, 10)) >= 4.7 - 1e-14);
    written_free(&it);
  }
}

/* A box exactly as wide or as high as the disc, in numbers without rounding: the disc is placed in its middle. */
static void a_box_as_wide_as_the_disc(void) {
  for (int upright = 0; upright < 2; upright++) {
    struct written it;
    make(&it, upright ? ROCK "grading g 1 1\nfill discs box 0 4 to 9 6 g rock seed 1 attempts 1 else skip\n"
                      : ROCK "grading g 1 1\nfill discs box 4 0 to 6 9 g rock seed 1 attempts 1 else skip\n");
    CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 1);
    CU_ASSERT_EQUAL(upright ? it.scene.particles[0].y : it.scene.particles[0].x, 5);
    written_free(&it);
  }
}

/* A particle wider or higher than the cell would overlap its own image, so it is not placed. */
static void one_that_fills_the_cell(void) {
  static const char *const cells[] = {CELL, ROCK "periodic cell 2 -3 to 32 47\n"};
  for (int k = 0; k < 2; k++) {
    struct written it;
    char page[512];
    snprintf(page, sizeof page, "%sgrading g 15.1 1 15 1\nfill discs cell g rock seed 4 attempts 1000000 else skip\n",
             cells[k]);
    make(&it, page);
    CU_ASSERT_EQUAL(it.scene.particle_count, 1);
    CU_ASSERT_EQUAL(it.scene.gradings[0].sizes[1].placed, 1);
    CU_ASSERT_EQUAL(it.scene.fills[0].attempts_made, 1);
    written_free(&it);
  }
}

/* Two discs approach each other by less than the skin after the search, which has not listed them, because their gap was
 * above the skin. The gap counts this pair, whatever the numbers of its particles. */
static void gap_of_a_pair_that_is_not_listed(void) {
  static const char *const left = "disc 0 0 radius 1 rock velocity 1 0\n";
  static const char *const right = "disc 3.0625 0 radius 1 rock velocity -1 0\n";
  static const char *const far = "disc 20 0 radius 1 rock\n";
  const char *const orders[][3] = {{left, right, far}, {left, far, right}, {far, left, right}};
  for (size_t k = 0; k < sizeof orders / sizeof *orders; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, ROCK "%s%s%sskin 1\nstep 0.0625\nrecord gap\nstage go\ncycles 6\n", orders[k][0], orders[k][1],
              orders[k][2]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    written_cycles(model, 6);
    CU_ASSERT_EQUAL(model->contacts.count, 0);
    CU_ASSERT_EQUAL(written_now(model, "gap"), 1.0625 - 6 * 0.125);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The gap counts a pair if a force can act between its particles: not if both are fixed, or one has been removed. It is
 * the gap of the nearest images in a cell, is negative if particles overlap, and is at most the skin. */
static void pairs_that_count_in_the_gap(void) {
  static const struct {
    const char *scene, *stage;
    double gap;
  } rows[] = {
      {"disc 0 0 radius 1 rock\ndisc 2.125 0 radius 1 rock\ndisc 4.375 0 radius 1 rock\n", "", 0.125},
      {"disc 0 0 radius 1 rock fixed\ndisc 2.125 0 radius 1 rock\ndisc 4.375 0 radius 1 rock\n", "", 0.125},
      {"disc 0 0 radius 1 rock\ndisc 2.125 0 radius 1 rock fixed\ndisc 4.375 0 radius 1 rock\n", "", 0.125},
      {"disc 0 0 radius 1 rock fixed\ndisc 2.125 0 radius 1 rock fixed\ndisc 4.375 0 radius 1 rock\n", "", 0.25},
      {"disc 0 0 radius 1 rock\ndisc 2.125 0 radius 1 rock\ndisc 4.375 0 radius 1 rock\n", "remove disc 1\n", 0.25},
      {"disc 0 0 radius 1 rock\ndisc 2.25 0 radius 1 rock\ndisc 4.375 0 radius 1 rock\n", "remove disc 3\n", 0.25},
      {"disc 0 0 radius 1 rock\ndisc 1.9375 0 radius 1 rock\ndisc 4 0 radius 1 rock\n", "", -0.0625},
      {"disc 0 0 radius 1 rock\ndisc 2.75 0 radius 1 rock\ndisc 9 0 radius 1 rock\n", "", 0.5},
      {"disc 1.0625 5 radius 1 rock\ndisc 8.9375 5 radius 1 rock\nperiodic cell 0 0 to 10 10\n", "", 0.125},
      {"disc 7 5 radius 2.1875 rock\ndisc 2.5 5 radius 2.1875 rock\nperiodic cell 0 0 to 10 10\n", "", 0.125},
      {"disc 5 7 radius 2.1875 rock\ndisc 5 2.5 radius 2.1875 rock\nperiodic cell 0 0 to 10 10\n", "", 0.125},
      {"disc 5 1.0625 radius 1 rock\ndisc 5 8.9375 radius 1 rock\nperiodic cell 0 0 to 10 10\n", "", 0.125},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page, ROCK "%sskin 0.5\nstep 1e-9\nrecord gap\nstage go\n%scycles 1\n", rows[k].scene, rows[k].stage);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT_EQUAL(written_now(model, "gap"), rows[k].gap);
    nb_model_free(model);
    written_free(&it);
  }
}

static void square(void) {
  struct written it;
  make(&it, ROCK "lattice discs 3 by 4 from 10 20 radius 1 spacing 2.5 rock\n");
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 12);
  for (size_t k = 0; k < 12; k++) /* the rows are filled one after the other */
    CU_ASSERT(it.scene.particles[k].x == 10 + 2.5 * (double)(k % 3) &&
              it.scene.particles[k].y == 20 + 2.5 * (double)(k / 3));
  written_free(&it);
}

static void hexagonal(void) {
  struct written it;
  make(&it, ROCK "lattice discs hexagonal 3 by 4 from 10 20 radius 1 spacing 2.5 rock\n");
  const struct nb_particle *at = it.scene.particles;
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 12);
  CU_ASSERT(at[0].x == 10 && at[0].y == 20 && at[2].x == 15 && at[3].x == 11.25 && at[6].x == 10 && at[9].x == 11.25);
  for (size_t k = 0; k < 12; k++) {
    int neighbours = 0;
    for (size_t j = 0; j < 12; j++)
      neighbours += j != k && fabs(hypot(at[j].x - at[k].x, at[j].y - at[k].y) - 2.5) < 1e-14;
    static const int expected[] = {2, 4, 3, 5, 6, 3, 3, 6, 5, 3, 4, 2}; /* counted on paper */
    CU_ASSERT_EQUAL(neighbours, expected[k]);
  }
  written_free(&it);
}

void suite_fill(void) {
  CU_pSuite suite = CU_add_suite("fill", NULL, NULL);
  CU_add_test(suite, "quantities of gradings and of their sizes", quantities_of_gradings);
  CU_add_test(suite, "SplitMix64 as published", published_numbers);
  CU_add_test(suite, "seeds are independent", seeds_are_independent);
  CU_add_test(suite, "uniform in a circle", uniform_in_a_circle);
  CU_add_test(suite, "uniform in a box", uniform_in_a_box);
  CU_add_test(suite, "no overlap", no_overlap);
  CU_add_test(suite, "no overlap with existing particles", no_overlap_with_existing_particles);
  CU_add_test(suite, "expected number of attempts", expected_number_of_attempts);
  CU_add_test(suite, "attempts and skipped sizes", attempts_and_skipped_sizes);
  CU_add_test(suite, "a place across the edge by rounding is refused", across_the_edge_by_rounding);
  CU_ADD_TEST(suite, across_the_circle_by_rounding);
  CU_add_test(suite, "a box as wide as the disc", a_box_as_wide_as_the_disc);
  CU_add_test(suite, "the same bits on every machine", the_same_bits);
  CU_add_test(suite, "in a cell no overlap across the edges", no_overlap_across_edges);
  CU_add_test(suite, "in a cell no overlap of large particles", no_overlap_of_large_particles);
  CU_add_test(suite, "in a cell uniform to the edges", uniform_in_a_cell);
  CU_add_test(suite, "in a cell any image of existing particles may be given", any_copy_of_existing_particles);
  CU_add_test(suite, "in a cell no particle overlaps its own image", one_that_fills_the_cell);
  CU_add_test(suite, "in a cell no overlap of two particles that nearly fill it", two_that_nearly_fill_the_cell);
  CU_add_test(suite, "gap of a pair that is not listed", gap_of_a_pair_that_is_not_listed);
  CU_ADD_TEST(suite, pairs_that_count_in_the_gap);
  CU_add_test(suite, "places in a square lattice", square);
  CU_add_test(suite, "places and neighbours in a hexagonal lattice", hexagonal);
}
