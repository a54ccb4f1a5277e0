/* Reference: an assembly at rest in an affine strain that is accumulated in the velocities [R89 4.43].
 *
 * Every cycle adds L x to the velocity of a particle, where x is its position relative to the centre of the affine
 * motion. At rest the contact forces F on the particle cancel this change:
 *
 *   sum F = -m L x/dt,   mean |sum F| = <m> (2/3) R_A e/dt^2
 *
 *   e     strain of a cycle, of opposite sign along the two axes; L = e/dt is the strain rate
 *   R_A   radius of the region, a circle about the same centre, m; particles are spread evenly over it
 *   <m>   mean mass of all particles, kg
 *
 * With `step X of rayleigh-fit-mean`, dt is X times pi R sqrt(rho/G)/(0.1631 nu + 0.876605) [R89 4.33, 4.34],
 * with the mean radius R.
 *
 * Returns, for A that monitors a circular region:   A.unbalanced.force in the last stage, N
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *last = &scene->stages[scene->stage_count - 1];
  const struct nb_strain_rate *strain = &last->affine.strain;
  if (!last->affine.accumulated || !strain->per_cycle || strain->xx != -strain->yy || strain->xy != 0 ||
      strain->yx != 0 || last->step.kind != NB_STEP_RAYLEIGH_FIT_MEAN)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `literal_field` is for a last stage with `affine strain E -E accumulated` per "
                        "cycle, and a step that is a fraction of rayleigh-fit-mean");
  double mass = 0, radius = 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    if (scene->particles[k].material != scene->particles[0].material)
      return nb_error_set(error, NB_BAD_USE, "the reference `literal_field` is for particles of one material");
    mass += matter_mass(scene, &scene->particles[k]), radius += scene->particles[k].radius;
  }
  mass /= (double)scene->particle_count, radius /= (double)scene->particle_count;
  const struct nb_material *glass = &scene->materials[scene->particles[0].material];
  const double shear = glass->young / (2 * (1 + glass->poisson));
  const double step = last->step.value * 3.14159265358979323846 * radius * sqrt(glass->density / shear) /
                      (0.1631 * glass->poisson + 0.876605);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_REGION || scene->regions[monitor->a].kind != NB_REGION_CIRCLE)
      continue;
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%s.unbalanced.force in %s", monitor->name, last->name);
    solution_value(solution, mass * 2 / 3 * scene->regions[monitor->a].radius * fabs(strain->xx) / (step * step), name);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_literal_field = {
    .name = "literal_field",
    .title = "an assembly at rest in an affine strain that is accumulated in the velocities",
    .source = "[R89 4.43]",
    .accepts = {HAS_SPHERES, HAS_FRICTION, HAS_CONTACT_DAMPING, HAS_BOUNDARY, HAS_BOUNDARY_STRAIN, HAS_AFFINE_STRAIN,
                HAS_START, HAS_ZERO_VELOCITIES, HAS_UNTIL, HAS_STEP_CHANGE, HAS_MATERIAL_CHANGE},
    .needs = {HAS_AFFINE_ACCUMULATED},
    .normal = "hertz",
    .shear = "mindlin",
    .solve = solve,
};
