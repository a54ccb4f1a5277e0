/* Square boxes by which things in the plane are found again: for the search of near pairs and for random filling.
 *
 * A box is found by a hash of its whole-number co-ordinates, so a scene may lie anywhere and have no edge. There are levels of
 * boxes, each half as wide as the one before: a thing lives on the finest level whose boxes are as wide as it is. So a few
 * large things among many small ones cost the small ones nothing.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_GRID_H
#define NB_GRID_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "vec.h"

enum { NB_GRID_LEVELS = 24 }; /* the last one takes all that is smaller than 2^-23 of the widest */

struct nb_box {
  int level;
  int64_t x, y;
};

struct nb_grid {
  double width[NB_GRID_LEVELS]; /* of a level's boxes, m */
  size_t count[NB_GRID_LEVELS]; /* of the things on it */
  size_t mask;                  /* buckets - 1, a power of two less one */
  int *first;                   /* per bucket: the thing that came last, -1: none; */
  struct nb_grid_entry {
    struct nb_box box;
    int next; /* and the one that came before, of this bucket */
  } * entry;  /* per thing */
};

/* For so many things, of which the widest is so wide, m; false: no memory. */
bool nb_grid_create(struct nb_grid *grid, size_t items, double largest_width);
void nb_grid_free(struct nb_grid *grid);
void nb_grid_add(struct nb_grid *grid, int item, struct nb_vec at, double width);

/* Farther out than whole numbers go in a double, the last box takes all: they are still in order, and compared by distance. */
static inline int64_t nb_grid_place(const struct nb_grid *grid, int level, double x) {
  const double widths = x / grid->width[level], last = 9007199254740992;
  return (int64_t)(widths < -last ? -last : widths > last ? last : floor(widths));
}

static inline size_t nb_grid_bucket(const struct nb_grid *grid, struct nb_box box) {
  uint64_t h = (uint64_t)box.x * 0x9e3779b97f4a7c15u ^ (uint64_t)box.y * 0xc2b2ae3d27d4eb4fu ^
               (uint64_t)box.level * 0x165667b19e3779f9u;
  h ^= h >> 29;
  return (size_t)h & grid->mask;
}

/* Of the thing and those before it in its bucket the first one in that box; -1: none. */
static inline int nb_grid_next(const struct nb_grid *grid, int item, struct nb_box box) {
  while (item >= 0) {
    const struct nb_grid_entry *entry = &grid->entry[item];
    if (entry->box.x == box.x && entry->box.y == box.y && entry->box.level == box.level)
      break;
    item = entry->next;
  }
  return item;
}

/* All things in a box. */
#define NB_GRID_FOR_BOX(grid, item, where)                                                                             \
  for (int item = nb_grid_next(grid, (grid)->first[nb_grid_bucket(grid, where)], where); item >= 0;                    \
       item = nb_grid_next(grid, (grid)->entry[item].next, where))

#endif
