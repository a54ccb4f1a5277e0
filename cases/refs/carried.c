/* Reference: bodies that meet nothing, carried along with a strain rate, in either coding.
 *
 * `apart`, from rest:   x_N = (1 + e)^N x_0,   e = L dt
 *
 * `accumulated` [R89 4.43]: u' = K u + L x,  x' = x + u' dt, so that
 *
 *   x_(N+1) - (1 + K + e) x_N + K x_(N-1) = 0,   x_N = A l_1^N + B l_2^N,   l^2 - (1 + K + e) l + K = 0
 *
 * with K what global damping leaves of a velocity in a cycle: 1 without, X/(2 - X), X, X for the readings of CON1. The roots
 * are complex where e < 0 is strong enough: then the body swings. A + B = x_0; from rest, x_1 = (1 + e) x_0.
 *
 * Stages follow each other, each with its own strain rate and coding; a stage after one that is `accumulated` is not known.
 * Strain along the axes alone, about the origin; one step and one damping.
 *
 * Known: NAME.x along cycle, NAME.y along cycle of each body that is watched.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

struct way {
  double begin, from;  /* cycle at which the last stage begins, and where the body is then, m */
  double early, late;  /* e before it and in it */
  bool literal;        /* in it */
  double complex a, b; /* A, B, m */
  double complex l1, l2;
};

static double at(const void *data, double cycle) {
  const struct way *way = data;
  const double n = cycle - way->begin;
  if (n < 0)
    return way->from * pow(1 + way->early, n);
  if (!way->literal)
    return way->from * pow(1 + way->late, n);
  return creal(way->a * cpow(way->l1, n) + way->b * cpow(way->l2, n));
}

static void solve_equations(struct way *way, double keep) {
  const double e = way->late;
  const double half = (1 + keep + e) / 2;
  /* half^2 - K, without the difference of two numbers near 1 */
  const double complex root = csqrt(((1 - keep) * (1 - keep) + 2 * (1 + keep) * e + e * e) / 4);
  way->l1 = half + root, way->l2 = half - root;
  way->a = way->from * (1 + e - way->l2) / (way->l1 - way->l2);
  way->b = way->from - way->a;
}

static double kept(const struct nb_damping *damping) {
  const double x = damping->global;
  switch (damping->global_kind) {
  case NB_GLOBAL_CON1_CS79:
    return x / (2 - x);
  case NB_GLOBAL_CON1_VELOCITY:
  case NB_GLOBAL_CON1_ALL:
    return x;
  default:
    return 1;
  }
}

static bool add_value(struct nb_solution *solution, const struct nb_scene *scene, const struct nb_monitor *monitor,
                      bool y) {
  const struct nb_stage *first = &scene->stages[0], *last = &scene->stages[scene->stage_count - 1];
  const struct nb_particle *particle = &scene->particles[monitor->a];
  struct way *way = calloc(1, sizeof *way);
  char name[3 * NB_NAME_SIZE];
  if (!way)
    return false;
  way->early = y ? first->affine.strain.yy : first->affine.strain.xx;
  way->late = y ? last->affine.strain.yy : last->affine.strain.xx;
  way->literal = last->affine.accumulated;
  way->begin = last == first ? 0 : (double)first->cycles;
  way->from = (y ? particle->y : particle->x) * (last == first ? 1 : pow(1 + way->early, way->begin));
  solve_equations(way, kept(&scene->damping));
  snprintf(name, sizeof name, "%s.%s", monitor->name, y ? "y" : "x");
  solution_curve(solution, name, "cycle", at, way);
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  bool right = scene->stage_count >= 1 && scene->stage_count <= 2;
  for (size_t s = 0; s < scene->stage_count && right; s++) {
    const struct nb_affine_motion *it = &scene->stages[s].affine;
    right = it->line && it->strain.per_cycle && it->strain.xy == 0 && it->strain.yx == 0 &&
            (!it->accumulated || s + 1 == scene->stage_count);
  }
  if (!right)
    return nb_error_set(
        error, NB_BAD_USE,
        "carried wants an `affine strain` per cycle along the axes in one stage or two, `accumulated` in "
        "the last at most");
  for (size_t k = 0; k < scene->monitor_count; k++)
    if (scene->monitors[k].kind == NB_MONITOR_PARTICLE && !(add_value(solution, scene, &scene->monitors[k], false) &&
                                                            add_value(solution, scene, &scene->monitors[k], true)))
      return nb_error_memory(error);
  return solution_full(solution, error);
}

const struct nb_reference reference_carried = {
    .name = "carried",
    .title = "bodies that meet nothing, carried along with a strain rate: the recurrence solved",
    .source = "[R89 4.41, 4.43]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL, HAS_CONTINUUM_LITERAL},
    .needs = {HAS_CONTINUUM},
    .normal = NB_ANY_LAW,
    .shear = "none",
    .solve = solve,
};
