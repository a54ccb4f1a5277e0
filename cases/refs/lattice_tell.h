/* What the references tell of the contacts that a scene watches.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LATTICE_TELL_H
#define NB_LATTICE_TELL_H

#include "lattice.h"

/* Normal and shear force of every watch, as `rest` finds them after each stage. */
enum nb_status lattice_add_rest(struct nb_solution *solution, const struct nb_scene *scene,
                                enum nb_status (*rest)(const struct lattice *lattice, const gsl_vector *travel,
                                                       gsl_vector *forces, struct nb_error *error),
                                struct nb_error *error);

/* Force `row` as a curve along cycle and along time, named `quantity`. */
enum nb_status lattice_add_curves(struct nb_solution *solution, const struct lattice *lattice,
                                  const struct oscillation_modes *modes, const char *quantity, size_t row,
                                  struct nb_error *error);

/* Goes through all cycles of an undamped run: NB_BAD_USE when a contact would open or slip. */
enum nb_status lattice_stays(const struct lattice *lattice, const struct oscillation_modes *modes,
                             struct nb_error *error);

#endif
