/* Whether a body has gone through a wall in a step: by chance, and close to what decides it.
 *
 * A step is drawn in the frame of the wall, where the answer is plain: the centre comes from (x0, y0) to (x1, y1), through the
 * wall's line at x0 + (x1 - x0) y0/(y0 - y1). Then wall and body are put somewhere, and move and turn as they like.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/model.h"
#include "chance.h"
#include "suites.h"
#include "written.h"

/* By about one, or by hardly anything, to either side. */
static double by(struct chance *chance) {
  const double sign = chance_between(chance, -1, 1) < 0 ? -1 : 1;
  return sign * chance_between(chance, 0.2, 1) * (chance_between(chance, 0, 1) < 0.5 ? 1 : 2e-4);
}

/* A point of the wall's frame, where the wall is at p and at this angle. */
static struct nb_vec place(struct nb_vec p, double angle, double h0, double x, double y) {
  const double c = cos(angle), s = sin(angle);
  return vec(p.x + c * x - s * (y + h0), p.y + s * x + c * (y + h0));
}

static void through_or_not(void) {
  struct words page = {0};
  struct written it;
  struct chance chance = chance_begin(7);
  int crossings = 0;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 1\nstep 1\ndisc 0 9 radius 1 m\nwall w -3 0 to 3 0 m\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_walls *walls = &model->walls;
  model->cycle = 1;
  for (int trial = 0; trial < 4000; trial++) {
    const double dt = model->previous_step = chance_scale(&chance, 1e-2, 10);
    const double size = chance_scale(&chance, 0.1, 10), angle = chance_between(&chance, -3, 3);
    const double spin = trial % 3 ? chance_between(&chance, -0.6, 0.6) / dt : trial % 2;
    const double h0 = walls->h0[0] = trial % 5 ? size * chance_between(&chance, -1, 1) : 0;
    const double h1 = walls->h1[0] = -size * chance_between(&chance, 0.5, 2), h2 = walls->h2[0] = h1 + 3 * size;
    /* Where it goes through the line, about one of the ends; and from how far above it to how far below, or not so far. */
    const double at = (chance_between(&chance, 0, 1) < 0.5 ? h1 : h2) + size * by(&chance);
    const double y0 = size * by(&chance), y1 = size * by(&chance), drift = size * by(&chance);
    const double share = y0 / (y0 - y1), x0 = at - share * drift, x1 = x0 + drift;
    const bool wanted = (y0 > 0) != (y1 > 0) && at >= h1 && at <= h2;
    const struct nb_vec p = vec(chance_between(&chance, -9, 9), chance_between(&chance, -9, 9));
    const struct nb_vec v = vec(chance_between(&chance, -9, 9), chance_between(&chance, -9, 9));
    const struct nb_vec now = place(p, angle, h0, x1, y1);
    const struct nb_vec before = place(vec_sub(p, vec_scale(dt, v)), angle - spin * dt, h0, x0, y0);
    walls->pivot[0] = p, walls->velocity[0] = v, walls->spin[0] = spin, walls->along[0] = vec(cos(angle), sin(angle));
    walls->point[0] = place(p, angle, h0, 0, 0);
    model->bodies.position[0] = now, model->bodies.velocity[0] = vec_scale(1 / dt, vec_sub(now, before));
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(nb_walls_crossed(model, true, &error), wanted ? NB_BROKEN : NB_OK);
    crossings += wanted;
  }
  CU_ASSERT(crossings > 700 && crossings < 3300);
  nb_model_free(model);
  written_free(&it);
}

void suite_through(void) {
  CU_pSuite suite = CU_add_suite("through", NULL, NULL);
  CU_add_test(suite, "through a wall or not, by chance", through_or_not);
}
