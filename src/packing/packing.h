/* Bodies that are added to a scene: on a lattice, and at random.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_PACKING_H
#define NB_PACKING_H

#include "nineball.h"

/* Adds bodies row by row from the south-west; false when there is no memory. */
struct nb_lattice {
  size_t nx, ny;
  double x, y, spacing; /* m, centre of the first and pitch */
  bool hexagonal;       /* else square */
};
bool nb_fill_lattice(struct nb_scene *scene, struct nb_lattice lattice, struct nb_particle first);
/* Adds bodies at random, largest first, and counts in `fill` and in the sizes of its grading what became of them. */
enum nb_fill_result { NB_FILL_DONE, NB_FILL_STOPPED, NB_FILL_NO_MEMORY };
enum nb_fill_result nb_fill_random(struct nb_scene *scene, struct nb_fill *fill, struct nb_particle like);

#endif
