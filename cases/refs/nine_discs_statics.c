/* Reference: forces of touching discs in equilibrium, after the walls have moved and stopped. No contact slides, so the
 * contacts form a linear network [CS79 figures 5, 6].
 *
 * Returns the forces in equilibrium at the contact that C monitors, for the positions of the walls at the end:
 *   C.normal, C.shear              of the run;    if the walls are at rest at its end, also C.normal mean, C.shear mean
 *   C.normal, C.shear in STAGE     of a stage;    likewise
 *
 * For nine equal discs, each wall displaced inward by d, with r = k_s/k_n, the corner discs move by d_c along both
 * axes, and the discs in the middle of a side by d_m towards the centre, in units of d:
 *
 *   (2 + 2 r) d_c - r d_m = 1,   (2 + 2 r) d_m - 2 r d_c = 1
 *
 * In units of k_n d the normal forces are: centre contact d_m, corner with middle d_c, corner with wall 1 - d_c, middle
 * with wall 1 - d_m. For r = 1 they are 3/7, 5/14, 9/14 and 4/7; without shear force 1/2 everywhere.
 *
 * Error    about 0.01 (overlap / radius) of the forces, because the network neglects the change of geometry.
 * Damping does not change the values if nothing slides.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_values.h"

static enum nb_status equilibrium(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                  struct nb_error *error) {
  enum nb_status status = lattice_equilibrium(lattice, travel, forces, error);
  return status == NB_OK ? lattice_check_forces(lattice, forces, (double)lattice->cycles, error) : status;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  return lattice_add_equilibria(solution, scene, equilibrium, error);
}

const struct nb_reference reference_nine_discs_statics = {
    .name = "nine_discs_statics",
    .title = "touching discs between walls, at rest without slip: the linear network solved",
    .source = "[CS79 16, 17, figures 5, 6]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_OFFSET_WALLS,
                HAS_FRICTION, HAS_COHESION, HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_STEP_CHANGE, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
