/* Reference: particles without contacts in an affine strain of the rate L. The velocity L x of this strain moves the
 * particles in addition to their own velocities, or is accumulated in these velocities.
 *
 * x is the position along an axis of the strain, and x_N its value after N cycles. e = L dt is the strain of a cycle.
 * With `affine strain`, from rest:
 *
 *   x_N = (1 + e)^N x_0
 *
 * `accumulated` [R89 4.43]: u <- K u + L x,  x <- x + u dt  in each cycle, with the velocity u, so that
 *
 *   x_(N+1) - (1 + K + e) x_N + K x_(N-1) = 0,   x_N = A l_1^N + B l_2^N,   l^2 - (1 + K + e) l + K = 0
 *
 * K is the fraction of the velocity that damping leaves in one cycle: 1 without damping, X/(2 - X) with
 * `damping con1 X as cs79`, and X with `as velocity` or `as all`. The roots l_1 and l_2 are complex for sufficiently
 * negative e; then the particle oscillates. A + B = x_0; from rest, x_1 = (1 + e) x_0. If both roots are equal, x_N is
 * (A + B N) l^N.
 *
 * Returns, for D that monitors a particle:   D.x, D.y versus cycle, m
 * Accepts one or two stages with strains per cycle along the axes about the origin, one step and one damping; only the
 * last stage may be `accumulated`. Refuses scenes in which particles touch. Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

struct motion {
  double begin, from;  /* cycle at which the last stage begins; position of the particle then, m */
  double early, late;  /* e before that stage and in it */
  bool accumulated;    /* in that stage */
  double complex a, b; /* A and B, in m; of a double root: x_N = (A + B N) l_1^N */
  double complex l1, l2;
};

static double at(const void *data, double cycle) {
  const struct motion *motion = data;
  const double n = cycle - motion->begin;
  if (n < 0)
    return motion->from * pow(1 + motion->early, n);
  if (!motion->accumulated)
    return motion->from * pow(1 + motion->late, n);
  if (motion->l1 == motion->l2)
    return creal((motion->a + motion->b * n) * cpow(motion->l1, n));
  return creal(motion->a * cpow(motion->l1, n) + motion->b * cpow(motion->l2, n));
}

static void solve_equations(struct motion *motion, double keep) {
  const double e = motion->late;
  const double half = (1 + keep + e) / 2;
  /* half^2 - K, without subtracting two numbers near 1 */
  const double complex root = csqrt(((1 - keep) * (1 - keep) + 2 * (1 + keep) * e + e * e) / 4);
  motion->l1 = half + root, motion->l2 = half - root;
  const bool twice = motion->l1 == motion->l2;
  motion->a = twice ? motion->from : motion->from * (1 + e - motion->l2) / (motion->l1 - motion->l2);
  motion->b = twice ? motion->from * ((1 + e) / motion->l1 - 1) : motion->from - motion->a;
}

static double kept_fraction(const struct nb_damping *damping) {
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

/* The motion along an axis from the place x_0. */
static struct motion motion_from(const struct nb_scene *scene, double place, bool y) {
  const struct nb_stage *first = &scene->stages[0], *last = &scene->stages[scene->stage_count - 1];
  struct motion motion = {.early = y ? first->affine.strain.yy : first->affine.strain.xx,
                          .late = y ? last->affine.strain.yy : last->affine.strain.xx,
                          .accumulated = last->affine.accumulated,
                          .begin = last == first ? 0 : (double)first->cycles};
  motion.from = place * pow(1 + motion.early, motion.begin);
  solve_equations(&motion, kept_fraction(&scene->damping));
  return motion;
}

/* Whether two particles touch. All distances along an axis change by the same factor. */
static bool touch(const struct nb_scene *scene) {
  const struct motion x = motion_from(scene, 1, false), y = motion_from(scene, 1, true);
  unsigned long cycles = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    cycles += scene->stages[s].cycles;
  for (unsigned long n = 0; n <= cycles; n++) {
    const double along_x = at(&x, (double)n), along_y = at(&y, (double)n);
    for (size_t i = 0; i < scene->particle_count; i++)
      for (size_t j = 0; j < i; j++) {
        const struct nb_particle *a = &scene->particles[i], *b = &scene->particles[j];
        if (hypot((a->x - b->x) * along_x, (a->y - b->y) * along_y) <= a->radius + b->radius)
          return true;
      }
  }
  return false;
}

static bool add_value(struct nb_solution *solution, const struct nb_scene *scene, const struct nb_monitor *monitor,
                      bool y) {
  const struct nb_particle *particle = &scene->particles[monitor->a];
  struct motion *motion = malloc(sizeof *motion);
  char name[3 * NB_NAME_SIZE];
  if (!motion)
    return false;
  *motion = motion_from(scene, y ? particle->y : particle->x, y);
  snprintf(name, sizeof name, "%s.%s", monitor->name, y ? "y" : "x");
  solution_curve(solution, name, "cycle", at, motion);
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  bool right = scene->stage_count <= 2;
  for (size_t s = 0; s < scene->stage_count && right; s++) {
    const struct nb_affine_motion *it = &scene->stages[s].affine;
    right = it->strain.per_cycle && it->strain.xy == 0 && it->strain.yx == 0 &&
            (!it->accumulated || s + 1 == scene->stage_count);
  }
  if (!right)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `carried` is for an `affine strain` per cycle along the axes in one stage or two, "
        "with `accumulated` in the last stage only");
  if (touch(scene))
    return nb_error_set(error, NB_BAD_USE, "the reference `carried` is for particles that never touch");
  for (size_t k = 0; k < scene->monitor_count; k++)
    if (scene->monitors[k].kind == NB_MONITOR_PARTICLE && !(add_value(solution, scene, &scene->monitors[k], false) &&
                                                            add_value(solution, scene, &scene->monitors[k], true)))
      return nb_error_memory(error);
  return solution_status(solution, error);
}

const struct nb_reference reference_carried = {
    .name = "carried",
    .title = "particles without contacts in an affine strain: the recurrence solved",
    .source = "[R89 4.41, 4.43]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL, HAS_AFFINE_ACCUMULATED},
    .needs = {HAS_AFFINE_STRAIN},
    .normal = NB_ANY_LAW,
    .shear = "none",
    .solve = solve,
};
