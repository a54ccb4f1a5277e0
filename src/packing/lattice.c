/* Lattice packings, square or hexagonal.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/array.h"
#include "packing.h"

/* Particles are numbered row by row: first the nx particles of the first row in the order of x, then the next row in y.
 * In a hexagonal lattice every second row is shifted by half a spacing in x, and rows are sqrt(3)/2 spacings apart, so
 * all six neighbours have the same distance. Each centre is the first centre plus a product, not a running sum, so
 * rounding errors do not grow along a row. */
bool nb_fill_lattice(struct nb_scene *scene, struct nb_lattice lattice, struct nb_particle prototype) {
  struct nb_particle *particles =
      nb_array_reserve(scene->particles, scene->particle_count, lattice.nx * lattice.ny, sizeof *particles);
  if (!particles)
    return false;
  scene->particles = particles;
  const double row_spacing = lattice.hexagonal ? sqrt(3) / 2 : 1, offset = lattice.hexagonal ? 0.5 : 0;
  for (size_t row = 0; row < lattice.ny; row++) {
    for (size_t column = 0; column < lattice.nx; column++) {
      struct nb_particle *particle = &particles[scene->particle_count++];
      *particle = prototype;
      particle->x = lattice.x + ((double)column + (double)(row % 2) * offset) * lattice.spacing;
      particle->y = lattice.y + (double)row * row_spacing * lattice.spacing;
    }
  }
  return true;
}
