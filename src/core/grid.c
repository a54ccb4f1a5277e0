/* A grid with several levels of boxes: creation and insertion.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "grid.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"

bool nb_grid_create(struct nb_grid *grid, size_t items, double largest_width) {
  size_t buckets = 16;
  while (buckets < 2 * items)
    buckets *= 2;
  *grid = (struct nb_grid){.mask = buckets - 1,
                           .first = nb_array(buckets, sizeof *grid->first),
                           .entry = nb_array(items, sizeof *grid->entry)};
  for (int l = 0; l < NB_GRID_LEVELS; l++, largest_width /= 2)
    grid->width[l] = largest_width;
  if (grid->first)
    memset(grid->first, -1, buckets * sizeof *grid->first); /* all bits set: each entry is -1 */
  return grid->first && grid->entry;
}

void nb_grid_free(struct nb_grid *grid) { free(grid->first), free(grid->entry); }

void nb_grid_add(struct nb_grid *grid, int item, struct nb_vec at, double width) {
  int level = 0;
  while (level + 1 < NB_GRID_LEVELS && grid->width[level + 1] >= width)
    level++;
  const struct nb_box box = {level, nb_grid_place(grid, level, at.x), nb_grid_place(grid, level, at.y)};
  int *first = &grid->first[nb_grid_bucket(grid, box)];
  grid->entry[item] = (struct nb_grid_entry){box, *first};
  *first = item;
  grid->count[level]++;
}
