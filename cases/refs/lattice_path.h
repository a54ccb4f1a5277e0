/* A network of springs under slow motion of its walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "lattice.h"

/* Called for each point of the path, at `fraction` (0 to 1) of a stage, with the forces F_n, F_s of each contact in
 * turn, N. */
typedef void lattice_path_point(void *data, size_t stage, double fraction, const gsl_vector *forces);

/* Follows the path and calls add_point(data, …). NB_BAD_USE when the states of the contacts cannot be found. */
enum nb_status lattice_path(const struct lattice *lattice, lattice_path_point *add_point, void *data,
                            struct nb_error *error);
