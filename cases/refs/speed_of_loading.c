/* Reference: the unbalanced force of nine discs without friction while four walls approach with equal speeds, with
 * mass-proportional damping.
 *
 * Along each axis the middle disc of a row stays at rest and the outer discs follow their walls. With the inward
 * displacement x of an outer disc, v t of its wall, and the coefficient alpha of `damping mass`:
 *
 *   m x'' + alpha m x' + 2 k x = k v t
 *
 * The oscillation decays as e^(-alpha t/2). What remains is steady motion:
 *
 *   x' = v/2,    x = v t/2 - alpha m v/(4 k)
 *
 * so the unbalanced force on an outer disc is alpha m v/2 along an axis, and on a corner disc sqrt(2) times as large.
 * The largest contact force is that of the wall, k (v t - x). Their ratio, dF/F of [CS79 table 1], is
 *
 *   unbalanced.max = (alpha m v/sqrt(2)) / (k v t/2 + alpha m v/4) = sqrt(2) alpha m v/(k d + alpha m v/2),     d = v t
 *
 * which at a given d is proportional to the speed while the speed is low [CS79, Speed of loading]. The theory neglects
 * overlap over radius, which has no effect here, because all contacts lie along the axes.
 *
 * Returns `unbalanced.max in STAGE` for the first stage.
 * Accepts alpha t > 20 at the end of the first stage, so that e^(-alpha t/2) is small.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static enum nb_status refuse(struct nb_error *error) {
  return nb_error_set(error, NB_BAD_USE,
                      "the reference `speed_of_loading` is for nine equal discs without friction, three by three in a "
                      "box of the same material whose walls approach with equal speeds from the first stage on, with "
                      "`damping mass` only and a step given as a time or as a fraction of single-contact");
}

/* True: all discs are equal, and all walls, of the same material, move at the speed v towards the disc in the middle. */
static bool approaches(const struct nb_scene *scene, double v) {
  const struct nb_particle *middle = &scene->particles[4];
  for (int k = 0; k < 9; k++)
    if (scene->particles[k].radius != middle->radius || scene->particles[k].material != middle->material)
      return false;
  for (int k = 0; k < 4; k++) {
    if (scene->walls[k].material != middle->material)
      return false;
    const struct nb_wall_motion *motion = &scene->stages[0].motions[k];
    const double x = middle->x - scene->walls[motion->wall].x, y = middle->y - scene->walls[motion->wall].y;
    if (hypot(motion->vx, motion->vy) != v || motion->vx * x + motion->vy * y < (1 - 1e-9) * v * hypot(x, y))
      return false;
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (scene->particle_count != 9 || scene->wall_count != 4 || scene->stages[0].motion_count != 4 ||
      (scene->step.kind != NB_STEP_TIME && scene->step.kind != NB_STEP_SINGLE_CONTACT))
    return refuse(error);
  const struct matter_pair pair = matter_pair(scene, scene->particles[0].material, scene->walls[0].material);
  const double m = matter_mass(scene, &scene->particles[0]), critical = 2 * sqrt(m / pair.kn);
  const double v = hypot(scene->stages[0].motions[0].vx, scene->stages[0].motions[0].vy);
  if (!approaches(scene, v))
    return refuse(error);
  const double step = scene->step.value * (scene->step.kind == NB_STEP_SINGLE_CONTACT ? critical : 1);
  const double t = step * (double)scene->stages[0].cycles, alpha = scene->damping.global;
  if (!(alpha * t > 20))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `speed_of_loading` is for a first stage that lasts longer than 20/alpha with `damping mass "
        "alpha`; it lasts %g/alpha",
        alpha * t);
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "unbalanced.max in %s", scene->stages[0].name);
  solution_value(solution, sqrt(2) * alpha * m * v / (pair.kn * v * t + alpha * m * v / 2), name);
  return solution_status(solution, error);
}

const struct nb_reference reference_speed_of_loading = {
    .name = "speed_of_loading",
    .title = "unbalanced force of nine discs under loading at constant speed",
    .source = "[CS79, Speed of loading]",
    .accepts = {HAS_DISCS, HAS_MOVING_WALLS},
    .needs = {HAS_WALLS, HAS_MASS_DAMPING},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
