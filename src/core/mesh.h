/* All boxes of one width as an array, and the particles sorted by box. Searches use it if the particles are of similar
 * size and fill their surroundings; other searches use grid.h, or test all pairs of a few particles.
 *
 * The particles of neighbouring boxes of a row follow each other, so a search reads memory in sequence. The coordinates
 * of boxes are those of grid.h, so that both searches find the same pairs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "vec.h"

/* The data of a particle, or of an image of a particle outside the periodic cell, that the search reads. */
struct nb_mesh_item {
  struct nb_vec x; /* m */
  double radius;   /* m */
  int slot;        /* of the particle; -1 - slot for an image */
  int box;         /* index of its box */
};
static inline bool nb_mesh_is_image(int slot) { return slot < 0; }
static inline int nb_mesh_particle(int slot) { return slot < 0 ? -1 - slot : slot; }

/* The points that are sorted into the boxes. */
struct nb_mesh_points {
  const struct nb_vec *x; /* m */
  const int *slot;        /* as in an item; NULL: point k is the particle in slot k */
  size_t count;
};

struct nb_mesh {
  size_t count; /* number of items; 0: the search needs grid.h, because of too many boxes or too large coordinates */
  int row;      /* number of boxes of a row; the first and the last box and the first and the last row are empty */
  int *start;   /* for each box, the index of its first item; one element more than there are boxes */
  struct nb_mesh_item *item;
};

struct nb_model;
/* Sorts the points into boxes of this width, m. False: out of memory. */
bool nb_mesh_create(struct nb_mesh *mesh, const struct nb_model *model, struct nb_mesh_points points, double width);
void nb_mesh_free(struct nb_mesh *mesh);
