/* All boxes of one width as an array, and the particles sorted by box: for searches where the particles are of similar
 * size and fill their surroundings. Other searches use grid.h.
 *
 * The particles of neighbouring boxes of a row follow each other, so a search reads memory in sequence. The coordinates
 * of boxes are those of grid.h, so that both find the same pairs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MESH_H
#define NB_MESH_H

#include <stdbool.h>
#include <stddef.h>

#include "vec.h"

/* A particle, with what the search reads of it. */
struct nb_mesh_item {
  struct nb_vec x; /* m */
  double radius;   /* m */
  int slot, box;
};

struct nb_mesh {
  size_t count; /* of items; 0: the boxes are too many, or the items too few */
  int row;      /* boxes of a row; the first and the last are empty, and so are the first and the last row */
  int *start;   /* for each box: its first item; one more than boxes */
  struct nb_mesh_item *item;
};

struct nb_model;
/* With boxes of this width, m. False: out of memory. */
bool nb_mesh_create(struct nb_mesh *mesh, const struct nb_model *model, double width);
void nb_mesh_free(struct nb_mesh *mesh);

#endif
