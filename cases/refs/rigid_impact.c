/* Reference: oblique impact in rigid-body theory, as used in event-driven codes.
 *
 *   V_N' = -V_N,   V_T' = V_T - mu (1 + q) 2 V_N   if this is >= 0: sliding throughout              psi2 = psi1 - 4 chi
 *                  V_T' = 0   otherwise: friction stops the sliding, without tangential restitution  psi2 = 0
 *
 * V_N and V_T are the normal and tangential velocity of the point of contact before the impact, V_N' and V_T' after it.
 * q is m R^2/I; impact_springs.h defines chi, psi1 and psi2. The theory agrees with an elastic contact that slides to
 * the end with V_T' >= 0, for psi1 >= 4 chi [R89 sec. 5.3.2]. Then the ratio e of the speeds of the centre after and
 * before the impact is given by
 *
 *   e^2 = 1 - 2 mu sin(2 theta) + 2 mu^2 (1 + cos(2 theta))
 *
 * with the angle of incidence theta of a sphere without spin; its smallest value is sqrt(1 + mu^2) - mu, at
 * tan(2 theta) = -1/mu. An elastic contact that slides to the end has the tangential impulse 2 mu m V_N for any sign of
 * V_T', so this e holds for it already for psi1 >= 4 chi - 1.
 *
 * Returns impact.psi2 and impact.restitution at the end, for a particle that strikes a wall at rest. Exact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return nb_error_set(error, NB_BAD_USE, "the reference `rigid_impact` is for one particle and one wall");
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  const struct matter_pair pair = matter_pair(scene, particle->material, wall->material);
  const double q = matter_mass(scene, particle) * particle->radius * particle->radius / matter_inertia(scene, particle);
  const double vt = fabs(particle->vx * wall->ex + particle->vy * wall->ey),
               vn = fabs(particle->vx * wall->ey - particle->vy * wall->ex);
  const double slides = vt - 2 * pair.friction * (1 + q) * vn, after = slides > 0 ? slides : 0;
  const double centre = vt - (vt - after) / (1 + q);
  solution_value(solution, after / (pair.friction * pair.young / (4 * pair.shear) * vn), "impact.psi2");
  solution_value(solution, hypot(vn, centre) / hypot(vn, vt), "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_rigid_impact = {
    .name = "rigid_impact",
    .title = "oblique impact in rigid-body theory: sliding throughout, or sticking",
    .source = "[R89 sec. 5.3.2]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .needs = {HAS_IMPACT, HAS_WALLS, HAS_FRICTION},
    .normal = "hertz",
    .shear = "mindlin_deresiewicz",
    .solve = solve,
};
