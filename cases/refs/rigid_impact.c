/* Reference: what the rigid-body theory makes of an oblique impact, as hard-particle codes use it.
 *
 *   V_N' = -V_N,   V_T' = V_T - mu (1 + q) 2 V_N   while that is not below 0: sliding throughout      psi2 = psi1 - 4 chi
 *   V_T' = 0       else: friction stops the contact and nothing throws it back                        psi2 = 0
 *
 * V_T of the point that touches, q = m R^2/I. It agrees with an elastic contact where that slides to the end with V_T' >= 0, from
 * psi1 = 4 chi on [R89 5.3.2]. There the speed comes back in the ratio
 *
 *   e^2 = 1 - 2 mu sin(2 theta) + 2 mu^2 (1 + cos(2 theta)),   least e = sqrt(1 + mu^2) - mu at tan(2 theta) = -1/mu
 *
 * theta the angle of a sphere without spin: an elastic contact that slides to the end loses neither more nor less, so this holds from
 * psi1 = 4 chi - 1 on.
 *
 * Known: impact.psi2, impact.restitution at the end, of a body that strikes a wall at rest. Exact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return nb_error_set(error, NB_BAD_USE, "rigid_impact is for a body that strikes a wall");
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  const struct matter_pair pair = matter_pair(scene, particle->material, wall->material);
  const double q = matter_mass(scene, particle) * particle->radius * particle->radius / matter_inertia(scene, particle);
  const double vx = particle->vx - wall->vx, vy = particle->vy - wall->vy;
  const double vt = fabs(vx * wall->ex + vy * wall->ey), vn = fabs(vx * wall->ey - vy * wall->ex);
  const double slides = vt - 2 * pair.friction * (1 + q) * vn, after = slides > 0 ? slides : 0;
  const double centre = vt - (vt - after) / (1 + q);
  solution_value(solution, after / (pair.friction * pair.young / (4 * pair.shear) * vn), "impact.psi2");
  solution_value(solution, hypot(vn, centre) / hypot(vn, vt), "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_rigid_impact = {
    .name = "rigid_impact",
    .title = "an oblique impact of rigid bodies: it slides throughout, or sticks for good",
    .source = "[R89 5.3.2]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .needs = {HAS_IMPACT, HAS_WALLS, HAS_FRICTION},
    .normal = "hertz",
    .shear = "mindlin_deresiewicz",
    .solve = solve,
};
