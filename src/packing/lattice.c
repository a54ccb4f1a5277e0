/* Packings: lattices, square or hexagonal.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/array.h"
#include "packing.h"

/* Numbered row by row from the south-west: 1 .. nx to the east, then the next row north. In a hexagonal one every second
 * row is half a spacing to the east, and rows are sqrt(3)/2 of it apart, so that all six neighbours are equally far. Each
 * centre comes from the first one by a product, not by sums, so that rounding does not grow along a row. */
bool nb_fill_lattice(struct nb_scene *scene, struct nb_lattice lattice, struct nb_body first) {
  struct nb_body *bodies = nb_room(scene->bodies, scene->body_count, lattice.nx * lattice.ny, sizeof *bodies);
  if (!bodies)
    return false;
  scene->bodies = bodies;
  const double up = lattice.hexagonal ? sqrt(3) / 2 : 1, aside = lattice.hexagonal ? 0.5 : 0;
  for (size_t row = 0; row < lattice.ny; row++) {
    for (size_t column = 0; column < lattice.nx; column++) {
      struct nb_body *body = &bodies[scene->body_count++];
      *body = first;
      body->x = lattice.x + ((double)column + (double)(row % 2) * aside) * lattice.spacing;
      body->y = lattice.y + (double)row * up * lattice.spacing;
    }
  }
  return true;
}
