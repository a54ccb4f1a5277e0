/* Values and curves of the forces at monitored contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LATTICE_VALUES_H
#define NB_LATTICE_VALUES_H

#include "lattice.h"

/* Normal and shear force of every monitored contact in the equilibrium after each stage, as `equilibrium` finds it. */
enum nb_status lattice_add_equilibria(struct nb_solution *solution, const struct nb_scene *scene,
                                      enum nb_status (*equilibrium)(const struct lattice *lattice,
                                                                    const gsl_vector *travel, gsl_vector *forces,
                                                                    struct nb_error *error),
                                      struct nb_error *error);

/* Force `row` as curves along cycle and time, named `quantity`. */
enum nb_status lattice_add_curves(struct nb_solution *solution, const struct lattice *lattice,
                                  const struct oscillation_modes *modes, const char *quantity, size_t row,
                                  struct nb_error *error);

/* Checks all cycles of an undamped run: NB_BAD_USE when a contact opens or slips. */
enum nb_status lattice_check_run(const struct lattice *lattice, const struct oscillation_modes *modes,
                                 struct nb_error *error);

#endif
