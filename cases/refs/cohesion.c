/* Reference: the shear force at which a disc slips between two plates, which press the disc and then push it against a
 * frictionless stop.
 *
 * A plate that has approached by d exerts F_n = k_n d/2, because two equal springs are in series. Then both plates move
 * by s = v t in x, the direction along which they extend. Each exerts F_s = k_s (s - u), where u is the displacement of
 * the disc into the stop, k_stop u = 2 F_s. The two moments cancel:
 *
 *   F_s = min(k_s s/(1 + 2 k_s/k_stop),  F_n tan phi + c)        c, tan phi: the smaller ones of both materials
 *                                                                [CS79 19]
 *
 * After the second plate has separated from the disc, it exerts F_n = F_s = 0 for any c.
 *
 * Returns, for L and U that monitor the contacts with the first (lower) and second (upper) wall:
 *   L.normal, L.shear, U.normal, U.shear in the stage that moves both plates; the two F_s have opposite signs
 *   U.normal, U.shear in the last stage
 * Accepts one free disc. The first two walls lie along x, one below and one above the disc, and just touch it. The
 * third wall lies along y, just touches the disc, and has neither friction nor cohesion. The stages are, in this order:
 * one that moves the second wall only, any number that move nothing, one that moves the first two walls equally along
 * x, one that moves the second wall away. The positions of the walls are not checked. Error: inertia is neglected; its
 * effect is small when the motion is slow.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

static bool wall_motion(const struct nb_stage *stage, int wall, double *vx, double *vy) {
  for (size_t k = 0; k < stage->motion_count; k++)
    if (stage->motions[k].wall == wall) {
      *vx = stage->motions[k].vx, *vy = stage->motions[k].vy;
      return true;
    }
  return false;
}

static double step_of(const struct nb_scene *scene) {
  return scene->step.kind == NB_STEP_TIME ? scene->step.value : NAN;
}

struct loading {
  double approach, travel; /* d and s, in m */
  int shear_stage;         /* index of the stage that moves both plates */
};

/* Reads the motion of the walls, stage by stage. False: the reference does not cover it. */
static bool read_stages(struct loading *loading, const struct nb_scene *scene) {
  double vx = 0, vy = 0, low = 0;
  loading->shear_stage = -1;
  for (size_t s = 0; s + 1 < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    double zero;
    wall_motion(stage, 1, &vx, &vy);
    wall_motion(stage, 0, &low, &zero);
    const double time = step_of(scene) * (double)stage->cycles;
    if (low != vx || (vx != 0 && vy != 0))
      return false;
    loading->approach -= vy * time;
    loading->travel += vx * time;
    if (vx != 0)
      loading->shear_stage = (int)s;
  }
  const struct nb_stage *last = &scene->stages[scene->stage_count - 1];
  return loading->shear_stage >= 0 && wall_motion(last, 1, &vx, &vy) &&
         vy * step_of(scene) * (double)last->cycles > loading->approach;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct loading loading = {0};
  if (scene->particle_count != 1 || scene->wall_count != 3 || !read_stages(&loading, scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `cohesion` is for one disc, a stop, and two plates that press, shear and then leave the disc");
  const int particle = scene->particles[0].material;
  const struct matter_pair pair = matter_pair(scene, particle, scene->walls[0].material);
  const struct matter_pair stop = matter_pair(scene, particle, scene->walls[2].material);
  if (stop.friction > 0 || stop.cohesion > 0)
    return nb_error_set(error, NB_BAD_USE, "the reference `cohesion` is for a stop with neither friction nor cohesion");
  const double normal = pair.kn * loading.approach / 2, limit = normal * pair.friction + pair.cohesion;
  const double sticking = pair.ks * loading.travel / (1 + 2 * pair.ks / stop.kn);
  const double shear = fabs(sticking) < limit ? sticking : copysign(limit, sticking);
  const char *stage = scene->stages[loading.shear_stage].name, *last = scene->stages[scene->stage_count - 1].name;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_PARTICLE_WALL || monitor->b > 1)
      continue;
    /* e points down at the first wall and up at the second, so t points in -x and in +x. The plates move in +x past the
     * disc, so the displacement of the disc along t relative to the plate is positive below and negative above. */
    single_add(solution, monitor->name, "normal", stage, normal);
    single_add(solution, monitor->name, "shear", stage, monitor->b == 0 ? shear : -shear);
    if (monitor->b == 1) {
      single_add(solution, monitor->name, "normal", last, 0);
      single_add(solution, monitor->name, "shear", last, 0);
    }
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_cohesion = {
    .name = "cohesion",
    .title = "a disc sheared by two plates: it slips at F_n tan(phi) + c",
    .source = "[CS79 19]",
    .accepts = {HAS_DISCS, HAS_MOVING_WALLS, HAS_FRICTION, HAS_COHESION, HAS_CONTACT_DAMPING},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
