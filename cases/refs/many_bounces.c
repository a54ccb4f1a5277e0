/* Reference: a hard sphere that bounces and bounces.
 *
 *   h_k = r + (h - r) e^(2k)          height of the centre at the top of flight k
 *   e = exp(-pi b/sqrt(1 - b^2))      restitution of a spring and a dashpot of the share b of critical, without weight
 *
 * Known, where NAME watches the body: NAME.y in STAGE, for the k-th stage that ends when a body is at the top (`until NAME.vy
 * below 0`). A soft sphere departs from it by the order of g/(w v), w^2 = k/m, v the speed of impact: its weight bears on it
 * during the contact, and the contact takes time.
 *
 * Source   [MFiX DEM-02].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct single body;
  if (single_of(&body, scene, error) || single_changes(scene, false, error))
    return error->status;
  if (scene->gravity.x != 0 || scene->bodies[0].vx != 0 || scene->bodies[0].vy != 0 || body.height < body.radius)
    return nb_error_set(error, NB_BAD_USE, "many_bounces is for a body dropped straight down, from rest");
  const double b = body.cn / (2 * sqrt(body.pair.kn * body.m));
  const double e = exp(-3.14159265358979323846 * b / sqrt(1 - b * b));
  int k = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->condition_count != 1 || stage->conditions[0].relation != NB_BELOW)
      continue;
    k++;
    const double top = body.radius + (body.height - body.radius) * pow(e, 2 * k);
    single_tell(known, body.body, "y", stage->name, scene->walls[0].y + top);
  }
  return known_full(known, error);
}

const struct nb_reference reference_many_bounces = {
    .name = "many_bounces",
    .title = "the heights of a hard sphere's bounces",
    .source = "[MFiX DEM-02]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_CONTACT_DAMPING, HAS_UNTIL},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "none",
    .know = know,
};
