/* nb_walls_crossed, which finds out whether a particle has crossed a wall in a step: random steps, many of them close
 * to the limits.
 *
 * A step is drawn in the frame of the wall, where the result is obvious: the centre moves from (x0, y0) to (x1, y1)
 * and crosses the line of the wall at x0 + (x1 - x0) y0/(y0 - y1). Then wall and particle get random positions,
 * velocities and rotations.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/model.h"
#include "chance.h"
#include "suites.h"
#include "written.h"

/* A random distance of about 1 or about 1e-4, with a random sign. */
static double by(struct chance *chance) {
  const double sign = chance_between(chance, -1, 1) < 0 ? -1 : 1;
  return sign * chance_between(chance, 0.2, 1) * (chance_between(chance, 0, 1) < 0.5 ? 1 : 2e-4);
}

/* The place of the point (x, y) of the wall's frame. The pivot of the wall is at p, and the line of the wall has this
 * angle and the distance h0 from the pivot. */
static struct nb_vec place(struct nb_vec p, double angle, double h0, double x, double y) {
  const double c = cos(angle), s = sin(angle);
  return vec(p.x + c * x - s * (y + h0), p.y + s * x + c * (y + h0));
}

static void random_steps(void) {
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
    /* The crossing point is near one of the ends. The heights before and after the step are on the same side of the
     * wall or on both sides. */
    const double at = (chance_between(&chance, 0, 1) < 0.5 ? h1 : h2) + size * by(&chance);
    const double y0 = size * by(&chance), y1 = size * by(&chance), drift = size * by(&chance);
    const double fraction = y0 / (y0 - y1), x0 = at - fraction * drift, x1 = x0 + drift;
    const bool wanted = (y0 > 0) != (y1 > 0) && at >= h1 && at <= h2;
    const struct nb_vec p = vec(chance_between(&chance, -9, 9), chance_between(&chance, -9, 9));
    const struct nb_vec v = vec(chance_between(&chance, -9, 9), chance_between(&chance, -9, 9));
    const struct nb_vec now = place(p, angle, h0, x1, y1);
    const struct nb_vec before = place(vec_sub(p, vec_scale(dt, v)), angle - spin * dt, h0, x0, y0);
    walls->pivot[0] = p, walls->velocity[0] = v, walls->spin[0] = spin, walls->along[0] = vec(cos(angle), sin(angle));
    walls->point[0] = place(p, angle, h0, 0, 0);
    model->particles.position[0] = now, model->particles.velocity[0] = vec_scale(1 / dt, vec_sub(now, before));
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(nb_walls_crossed(model, true, &error), wanted ? NB_BROKEN : NB_OK);
    crossings += wanted;
  }
  CU_ASSERT(crossings > 700 && crossings < 3300);
  nb_model_free(model);
  written_free(&it);
}

/* A wall of length 2 on the x axis from h1 to h1 + 2, so that one of its ends can be at the origin, where
 * coordinates have the finest resolution. A disc of radius 1 is at (x, y) after a time step of 1 in which it moved by
 * (dx, dy). Returns the message of *error, or "" if the disc has not crossed the wall. */
static const char *crossing(struct nb_error *error, double h1, bool fixed, double x, double y, double dx, double dy) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\nstep 1\ndisc 0 9 radius 1 m %s\nwall w -1 0 to 1 0 m\nstage s\n"
            "cycles 1\n",
            fixed ? "fixed" : "");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  model->cycle = 1, model->previous_step = 1;
  model->walls.h1[0] = h1, model->walls.h2[0] = h1 + 2;
  model->particles.position[0] = vec(x, y), model->particles.velocity[0] = vec(dx, dy);
  *error = (struct nb_error){0};
  const enum nb_status status = nb_walls_crossed(model, true, error);
  CU_ASSERT((status == NB_BROKEN) == (error->text[0] != 0));
  nb_model_free(model);
  written_free(&it);
  return error->text;
}
static bool crosses(double h1, double x, double y, double dx, double dy) {
  struct nb_error error;
  return crossing(&error, h1, false, x, y, dx, dy)[0];
}

/* nb_walls_crossed makes walls longer by 1e-12 of their length at each end, 2e-12 here, so that no particle passes
 * between two walls with a common end. */
static void at_an_end(void) {
  static const double slack = 2e-12;
  CU_ASSERT(crosses(-2, 0.9995 * slack, -0.25, 0, -0.5));
  CU_ASSERT_FALSE(crosses(-2, 1.0005 * slack, -0.25, 0, -0.5));
  CU_ASSERT(crosses(0, -0.9995 * slack, -0.25, 0, -0.5));
  CU_ASSERT_FALSE(crosses(0, -1.0005 * slack, -0.25, 0, -0.5));
  CU_ASSERT(crosses(0, 2 + 0.9 * slack, 0.25, 0, 0.5));
  CU_ASSERT_FALSE(crosses(0, 2 + 1.1 * slack, 0.25, 0, 0.5));
  CU_ASSERT(crosses(-2, -2 - 0.9 * slack, 0.25, 0, 0.5));
  CU_ASSERT_FALSE(crosses(-2, -2 - 1.1 * slack, 0.25, 0, 0.5));
}

/* A centre that arrives on the line has crossed it; a centre that leaves the line has not crossed it. */
static void on_the_line(void) {
  CU_ASSERT(crosses(-2, 0, 0, 1, -1));
  CU_ASSERT_FALSE(crosses(-2, 0.01, 0, 1, -1));
  CU_ASSERT(crosses(0, 0, 0, -1, 1));
  CU_ASSERT_FALSE(crosses(-1, 0, 0.5, 0, 0.5));
  CU_ASSERT_FALSE(crosses(-1, 0, -0.5, 0, -0.5));
  CU_ASSERT(crosses(-1, 0, 0, 0.5, 0)); /* it moves along the line */
}

/* The message names the radius. It advises a smaller step if the displacement exceeds half the radius, otherwise a
 * stiffer wall. Fixed particles may cross. */
static void the_message(void) {
  struct nb_error error;
  CU_ASSERT_PTR_NOT_NULL(strstr(crossing(&error, -1, false, 0, -0.25, 0, -0.5001), "try a smaller step"));
  CU_ASSERT_PTR_NOT_NULL(strstr(crossing(&error, -1, false, 0, -0.25, 0, -0.4999), "try a stiffer wall"));
  CU_ASSERT_PTR_NOT_NULL(
      strstr(error.text,
             "The limit of the overlap with a wall is the particle's radius, 1; in this step of 1 it moved 0.4999"));
  CU_ASSERT_STRING_EQUAL(crossing(&error, -1, true, 0, -0.25, 0, -0.5), "");
}

void suite_through(void) {
  CU_pSuite suite = CU_add_suite("through", NULL, NULL);
  CU_add_test(suite, "random steps across a wall or not", random_steps);
  CU_add_test(suite, "at an end of the wall", at_an_end);
  CU_add_test(suite, "on the line of the wall", on_the_line);
  CU_add_test(suite, "the message about a crossing", the_message);
}
