/* Reference: stress in frictionless spheres at rest under central gravity G [R89 sec. 6.4.2].
 *
 * Without friction the stress is isotropic, p(r), and radial equilibrium at distance r from the centre is
 *
 *   dp/dr = -G M/(pi R^2 t),   p = p_0 (1 - r/R),   p_0 = G M/(pi R t)
 *
 * so its mean over a circle of radius a about the centre is p_0 (1 - 2 a/(3 R)).
 *
 *   G   acceleration, m/s2     M   total mass, kg     t   mean diameter, taken as the thickness of the layer, m
 *   R   radius of the assembly, m:   pi R^2 (1 - n) = sum pi r_i^2,   n its areal porosity
 *
 * n = 0.155 is assumed, the middle of the range 0.14 to 0.17 of random frictionless packings.
 *
 * Returns   A.stress.mean in the last stage, Pa, for each monitor A of a circle about the centre of the central gravity
 * Error     p_0 is proportional to (1 - n)^(1/2): an error of 0.015 in n gives 0.9 %
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  static const double pi = 3.14159265358979323846, porosity = 0.155;
  const struct nb_gravity *gravity = &scene->stages[0].gravity; /* it is a statement of stages only */
  double mass = 0, diameter = 0, area = 0;
  for (size_t s = 1; s < scene->stage_count; s++)
    if (scene->stages[s].gravity.line)
      gravity = &scene->stages[s].gravity;
  if (!(gravity->central > 0))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `centripetal` is for `gravity centripetal` in the last stage");
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    mass += matter_mass(scene, particle);
    diameter += 2 * particle->radius;
    area += pi * particle->radius * particle->radius;
  }
  const double R = sqrt(area / (1 - porosity) / pi);
  const double p0 = gravity->central * mass / (pi * R * diameter / (double)scene->particle_count);
  const struct nb_stage *last = &scene->stages[scene->stage_count - 1];
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_REGION || scene->regions[monitor->a].kind != NB_REGION_CIRCLE)
      continue;
    const struct nb_region *region = &scene->regions[monitor->a];
    if (hypot(region->x - gravity->about_x, region->y - gravity->about_y) > 1e-9 * region->radius)
      continue;
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%s.stress.mean in %s", monitor->name, last->name);
    solution_value(solution, p0 * (1 - 2 * region->radius / (3 * R)), name);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_centripetal = {
    .name = "centripetal",
    .title = "stress in frictionless spheres at rest under central gravity, from radial equilibrium",
    .source = "[R89 sec. 6.4.2]",
    .accepts = {HAS_SPHERES, HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_GRAVITY_CHANGE, HAS_UNTIL},
    .needs = {HAS_CENTRIPETAL_GRAVITY},
    .normal = NB_ANY_LAW,
    .shear = "none",
    .solve = solve,
};
