/* A network led slowly along its walls' path.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LATTICE_PATH_H
#define NB_LATTICE_PATH_H

#include "lattice.h"

/* Called for every point of the path, `share` (0 to 1) of stage `stage`, with the forces k_n n, F_s of all contacts there. */
typedef void lattice_path_seen(void *data, size_t stage, double fraction, const gsl_vector *forces);

/* NB_BAD_USE when nobody can say who slides. */
enum nb_status lattice_path(const struct lattice *lattice, lattice_path_seen *seen, void *data, struct nb_error *error);

#endif
