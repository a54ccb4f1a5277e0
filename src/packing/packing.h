/* Adds particles to a scene, on a lattice or at random.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "nineball.h"

struct nb_lattice {
  size_t nx, ny;        /* particles in a row; rows */
  double x, y, spacing; /* centre of the first particle; distance of neighbours in a row, m */
  bool hexagonal;       /* else square */
};
/* Adds copies of `prototype`, row by row: x increases within a row, y from row to row. False: out of memory. */
bool nb_fill_lattice(struct nb_scene *scene, struct nb_lattice lattice, struct nb_particle prototype);
/* nb_fill_random adds copies of `prototype` with the sizes of the grading at random positions, largest first. It counts
 * the attempts in fill->attempts_made. In each size of the grading it counts the requested and the placed particles.
 * NB_FILL_STOPPED: a particle found no place, and the page says `else stop`. */
enum nb_fill_result { NB_FILL_DONE, NB_FILL_STOPPED, NB_FILL_NO_MEMORY };
enum nb_fill_result nb_fill_random(struct nb_scene *scene, struct nb_fill *fill, struct nb_particle prototype);
