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
 * third wall lies along y, just touches the disc in the direction of the shear, and has neither friction nor cohesion.
 * The stages are, in this order: some that move the second wall only, one that moves the first two walls equally along
 * x, one that moves the second wall away; between them, any number that move nothing. The disc stays between the ends
 * of the plates. Error: inertia is neglected; its effect is small when the motion is slow.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

static double step_of(const struct nb_scene *scene) {
  return scene->step.kind == NB_STEP_TIME ? scene->step.value : NAN;
}

struct loading {
  double approach, travel; /* d and s, in m */
  int shear_stage;         /* index of the stage that moves both plates */
};

/* Whether the walls touch the disc below, above and at the side. */
static bool just_touch(const struct nb_scene *scene) {
  const struct nb_particle *disc = &scene->particles[0];
  const struct nb_wall *low = &scene->walls[0], *high = &scene->walls[1], *stop = &scene->walls[2];
  const double r = disc->radius;
  return low->ey == 0 && high->ey == 0 && stop->ex == 0 && fabs(disc->y - low->y - r) < 1e-9 * r &&
         fabs(high->y - disc->y - r) < 1e-9 * r && fabs(fabs(stop->x - disc->x) - r) < 1e-9 * r;
}

/* Whether the disc stays between the ends of the plates while they move by `travel`, and faces the stop. The disc moves
 * by less than the plates. */
static bool stays_between_ends(const struct nb_scene *scene, double travel) {
  const struct nb_particle *disc = &scene->particles[0];
  bool between = single_faces(&scene->walls[2], disc->x, disc->y);
  for (int w = 0; w < 2; w++)
    between = between && single_faces(&scene->walls[w], disc->x, disc->y) &&
              single_faces(&scene->walls[w], disc->x - travel, disc->y);
  return between;
}

/* Updates the velocities of the walls. False: the motion is neither that of the second wall alone nor that of both
 * plates along x. */
static bool read_motion(double v[3][2], const struct nb_stage *stage) {
  for (size_t k = 0; k < stage->motion_count; k++) {
    const struct nb_wall_motion *motion = &stage->motions[k];
    v[motion->wall][0] = motion->vx, v[motion->wall][1] = motion->vy;
  }
  return v[2][0] == 0 && v[2][1] == 0 && v[0][1] == 0 && v[0][0] == v[1][0] && (v[1][0] == 0 || v[1][1] == 0);
}

/* Reads the motion of the walls, stage by stage. False: the reference does not cover it. */
static bool read_stages(struct loading *loading, const struct nb_scene *scene) {
  double v[3][2], time = 0;
  bool right = true;
  loading->shear_stage = -1;
  for (int w = 0; w < 3; w++)
    v[w][0] = scene->walls[w].vx, v[w][1] = scene->walls[w].vy;
  for (size_t s = 0; s < scene->stage_count; s++) {
    right = read_motion(v, &scene->stages[s]) && right;
    time = step_of(scene) * (double)scene->stages[s].cycles;
    if (s + 1 == scene->stage_count)
      break;
    right = right && (loading->shear_stage < 0 || (v[1][0] == 0 && v[1][1] == 0));
    if (v[1][0] != 0)
      loading->travel = v[1][0] * time, loading->shear_stage = (int)s;
    loading->approach -= v[1][1] * time;
  }
  return right && loading->approach > 0 && v[1][1] * time > loading->approach &&
         loading->travel * (scene->walls[2].x - scene->particles[0].x) > 0;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct loading loading = {0};
  if (scene->particle_count != 1 || scene->wall_count != 3 || !just_touch(scene) || !read_stages(&loading, scene) ||
      !stays_between_ends(scene, loading.travel))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `cohesion` is for one disc, a stop, and two plates that press, shear and then leave the disc");
  const int particle = scene->particles[0].material;
  const struct matter_pair pair = matter_pair(scene, particle, scene->walls[0].material);
  if (scene->walls[0].material != scene->walls[1].material)
    return nb_error_set(error, NB_BAD_USE, "the reference `cohesion` is for plates of one material");
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
