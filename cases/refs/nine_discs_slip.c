/* Reference: touching discs between walls that approach slowly, with friction: the forces in equilibrium [CS79 19].
 *
 * Returns forces under the names of nine_discs_statics, here in the equilibrium with sliding contacts. "Slowly" means
 * that oscillations cause no sliding that the growing load alone would not cause. The difference between a run and these
 * values is proportional to the speed of the walls, with damping or without. At finite speed the equilibrium depends on
 * the path.
 *
 * For nine equal discs, in the symbols of nine_discs_statics.c, with f = tan phi: the corner discs slide on the walls
 * when r d_c > f (1 - d_c) in the solution without sliding. Then
 *
 *   (1 - f) (1 - d_c) - d_c - r (d_c - d_m) = 0,   1 - 2 d_m - 2 r (d_m - d_c) = 0
 *
 * At phi = 15 degrees the centre contact carries the force 0.46999 k_n d if r = 1, and 0.47486 k_n d if r = 2/3. At 30
 * degrees nothing slides.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_values.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  return lattice_add_equilibria(solution, scene, lattice_equilibrium_sliding, error);
}

const struct nb_reference reference_nine_discs_slip = {
    .name = "nine_discs_slip",
    .title = "touching discs between walls, slowly loaded with friction: the network solved with sliding contacts",
    .source = "[CS79 16, 17, 19]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_OFFSET_WALLS,
                HAS_FRICTION, HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_STEP_CHANGE, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
