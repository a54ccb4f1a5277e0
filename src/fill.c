/* Packings: lattices.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "scene.h"

/* Square, numbered row by row from the south-west: 1 .. nx to the east, then the next row north. Each centre comes from
 * the first one by a product, not by sums, so that rounding does not grow along a row. */
bool nb_fill_lattice(struct nb_scene *scene, struct nb_lattice lattice, struct nb_body first) {
  struct nb_body *bodies = nb_room(scene->bodies, scene->body_count, lattice.nx * lattice.ny, sizeof *bodies);
  if (!bodies)
    return false;
  scene->bodies = bodies;
  for (size_t row = 0; row < lattice.ny; row++) {
    for (size_t column = 0; column < lattice.nx; column++) {
      struct nb_body *body = &bodies[scene->body_count++];
      *body = first;
      body->x = lattice.x + (double)column * lattice.spacing;
      body->y = lattice.y + (double)row * lattice.spacing;
    }
  }
  return true;
}
