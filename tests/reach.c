/* The criterion for a new search: a particle, or the end of a wall, is farther than half the skin from its place at the
 * last search; in a periodic cell, a particle is farther than the travel limit of the cell. The tests use hundreds of distances within 1/2000 of this limit. The strain of a periodic cell reduces
 * the limit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "chance.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double half_skin = 0.25;

/* A place at about half the skin from `at`; *out is increased by 1 if the place is farther than half the skin. */
static struct nb_vec found_near(struct nb_vec at, struct chance *chance, int *out) {
  const double away = half_skin * (1 + chance_between(chance, -5e-4, 5e-4)), turn = chance_between(chance, 0, 6.283);
  *out += away > half_skin;
  return vec(at.x - away * cos(turn), at.y - away * sin(turn));
}

static void particles_in(bool cell) {
  enum { PARTICLES = 600, PARTS = 3 };
  struct words page = {0};
  struct written it;
  struct chance chance = chance_begin(5);
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.5\n");
  for (int k = 0; k < PARTICLES; k++)
    words_add(&page, "disc %d %d radius 1 m velocity %.17g %.17g%s\n", 40 + 9 * (k % 25), 30 + 9 * (k / 25),
              chance_between(&chance, -1, 1), chance_between(&chance, -1, 1), k % 5 ? "" : " fixed");
  words_add(&page, "%sstage s\ncycles 1\n", cell ? "periodic cell 0 0 to 400 400\n" : "");
  written_scene(&it, &page);
  for (int parts = 1; parts <= PARTS; parts += PARTS - 1) {
    struct nb_model *model = written_model(&it, NULL);
    int wanted = 0, seen = 0;
    model->search.skin = cell ? 3 * half_skin : 2 * half_skin;
    if (cell)
      model->cell->travel_limit = half_skin;
    for (size_t i = 0; i < PARTICLES; i++)
      model->particles.search_position[i] = found_near(
          vec_add(model->particles.position[i], vec_scale(0.5, model->particles.velocity[i])), &chance, &wanted);
    for (int part = 0; part < parts; part++)
      seen += nb_motion_part(model, part, parts);
    CU_ASSERT(wanted > PARTICLES / 3 && wanted < 2 * PARTICLES / 3);
    CU_ASSERT_EQUAL(seen, wanted);
    nb_model_free(model);
  }
  written_free(&it);
}

static void particles(void) {
  particles_in(false);
  particles_in(true);
}

/* One end of each wall is near the limit, and the other has not moved, so every end is tested alone. */
static void walls(void) {
  enum { WALLS = 200 };
  struct words page = {0};
  struct written it;
  struct chance chance = chance_begin(6);
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.5\ndisc -9 -9 radius 3 m\n");
  for (int k = 0; k < WALLS; k++)
    words_add(&page, "wall w%d %d %d to %d %d m velocity %.17g %.17g spin %.17g\n", k, 9 * (k % 20), 9 * (k / 20),
              9 * (k % 20) + 3, 9 * (k / 20) + 4, chance_between(&chance, -1, 1), chance_between(&chance, -1, 1),
              chance_between(&chance, -0.5, 0.5));
  words_add(&page, "stage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *moved = written_model(&it, NULL), *model = written_model(&it, NULL);
  int wanted = 0;
  nb_motion_walls(moved);
  model->search.skin = 2 * half_skin;
  for (int w = 0; w < WALLS; w++)
    for (int end = 0; end < 2; end++) {
      const struct nb_vec there = nb_wall_end(&moved->walls, w, end);
      model->walls.search_position[2 * w + end] = end == w % 2 ? there : found_near(there, &chance, &wanted);
    }
  CU_ASSERT(wanted > WALLS / 3 && wanted < 2 * WALLS / 3);
  CU_ASSERT_EQUAL(nb_motion_walls(model), wanted);
  nb_model_free(moved), nb_model_free(model);
  written_free(&it);
}

/* In a periodic cell with the largest radius R and the skin s, the strain F since the last search reduces the travel
 * limit of the particles to (s - |F| (2 R + s))/2, where |F| is the Frobenius norm. Each component of F is tested alone,
 * xy and yx together, and all four together. */
static void cells(void) {
  static const struct {
    const char *strain;
    double xx, xy, yx, yy; /* 1/s */
  } cases[] = {{"-0.02 0", -0.02, 0, 0, 0},
               {"0 0.02", 0, 0, 0, 0.02},
               {"0 0 c12 0.02", 0, 0.02, 0, 0},
               {"0 0 c12 -0.02", 0, -0.02, 0, 0},
               {"0 0 c21 0.02", 0, 0, 0.02, 0},
               {"0 0 shear 0.02", 0, 0.02, 0.02, 0},
               {"0.01 -0.02 c12 0.03 c21 -0.015", 0.01, 0.03, -0.015, -0.02}};
  const double largest = 0.75, skin = 0.5, dt = 0.01;
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\nskin 0.5\nstep 0.01\nperiodic cell 0 0 to 9 9\n"
              "disc 1 1 radius %g m\ndisc 5 5 radius %g m\nstage s\ncell strain %s\ncycles 1\n",
              k % 2 ? 0.5 : 0.75, k % 2 ? 0.75 : 0.5, cases[k].strain);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT_EQUAL(model->cell->travel_limit, skin / 2);
    const unsigned long searches = model->search.count;
    double xx = 1, xy = 0, yx = 0, yy = 1; /* the deformation since the search */
    int cycles = 0;
    for (double left = skin; left > 0 && cycles < 2000; cycles++) {
      const double a = cases[k].xx * dt, b = cases[k].xy * dt, c = cases[k].yx * dt, d = cases[k].yy * dt;
      const double one = xx + a * xx + b * yx, two = xy + a * xy + b * yy, three = yx + c * xx + d * yx;
      yy += c * xy + d * yy, xx = one, xy = two, yx = three;
      left = skin - sqrt((xx - 1) * (xx - 1) + xy * xy + yx * yx + (yy - 1) * (yy - 1)) * (2 * largest + skin);
      written_cycles(model, 1);
      /* left <= 0: a new search has restored the travel limit. */
      CU_ASSERT_DOUBLE_EQUAL(model->cell->travel_limit, left > 0 ? left / 2 : skin / 2, 1e-13);
      CU_ASSERT_EQUAL(model->search.count - searches, left <= 0);
    }
    CU_ASSERT(cycles > 500 && cycles < 1500);
    nb_model_free(model);
    written_free(&it);
  }
}

void suite_reach(void) {
  CU_pSuite suite = CU_add_suite("reach", NULL, NULL);
  CU_add_test(suite, "particles that require a search", particles);
  CU_add_test(suite, "walls that require a search", walls);
  CU_add_test(suite, "the strain of a periodic cell reduces the travel limit", cells);
}
