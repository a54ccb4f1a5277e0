/* The criterion for a new search: a particle, or the end of a wall, is farther than half the skin from its place at
 * the last search. Hundreds of distances within 1/2000 of this limit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "chance.h"
#include "suites.h"
#include "written.h"

static const double half_skin = 0.25;

/* A place at about half the skin from `at`; *out counts those that are farther. */
static struct nb_vec found_near(struct nb_vec at, struct chance *chance, int *out) {
  const double away = half_skin * (1 + chance_between(chance, -5e-4, 5e-4)), turn = chance_between(chance, 0, 6.283);
  *out += away > half_skin;
  return vec(at.x - away * cos(turn), at.y - away * sin(turn));
}

static void particles(void) {
  enum { PARTICLES = 600, PARTS = 3 };
  struct words page = {0};
  struct written it;
  struct chance chance = chance_begin(5);
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.5\n");
  for (int k = 0; k < PARTICLES; k++)
    words_add(&page, "disc %d %d radius 1 m velocity %.17g %.17g%s\n", 40 + 9 * (k % 25), 30 + 9 * (k / 25),
              chance_between(&chance, -1, 1), chance_between(&chance, -1, 1), k % 5 ? "" : " fixed");
  words_add(&page, "stage s\ncycles 1\n");
  written_scene(&it, &page);
  for (int parts = 1; parts <= PARTS; parts += PARTS - 1) {
    struct nb_model *model = written_model(&it, NULL);
    int wanted = 0, seen = 0;
    model->search.skin = 2 * half_skin;
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

void suite_reach(void) {
  CU_pSuite suite = CU_add_suite("reach", NULL, NULL);
  CU_add_test(suite, "particles", particles);
  CU_add_test(suite, "walls", walls);
}
