/* Adds the normal and shear forces at monitored contacts to a solution, as values and as curves.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "lattice.h"

/* Adds both forces of every monitored contact in the equilibrium at the end of each stage and of the run. If the walls
 * are at rest from the beginning of a stage to the end of the run, the same forces are also added as the means over this
 * stage, and after the last stage as `mean` without a stage. `equilibrium` computes the forces, in N, from the
 * displacements `travel` of the walls. */
enum nb_status lattice_add_equilibria(struct nb_solution *solution, const struct nb_scene *scene,
                                      enum nb_status (*equilibrium)(const struct lattice *lattice,
                                                                    const gsl_vector *travel, gsl_vector *forces,
                                                                    struct nb_error *error),
                                      struct nb_error *error);

/* Adds the force in row `row` of lattice->stretch as two curves named `quantity`, against cycle and against time. */
enum nb_status lattice_add_curves(struct nb_solution *solution, const struct lattice *lattice,
                                  const struct oscillation_modes *modes, const char *quantity, size_t row,
                                  struct nb_error *error);

/* Checks every cycle of an undamped run. NB_BAD_USE: a contact opens or slips, so the lattice is not linear. */
enum nb_status lattice_check_run(const struct lattice *lattice, const struct oscillation_modes *modes,
                                 struct nb_error *error);
