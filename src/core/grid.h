/* A grid of square boxes on several levels, to find items near a point: for the neighbour search and for random
 * filling.
 *
 * A box is found by a hash of its integer coordinates, so the grid needs no origin and no extent. Each level has boxes
 * half as wide as the level above it. An item belongs to the finest level whose boxes are at least as wide as the item,
 * so a few large items do not slow down the search among many small ones.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "vec.h"

enum { NB_GRID_LEVELS = 24 }; /* the last level takes all items smaller than 2^-23 of the largest one */

struct nb_box {
  int level;
  int64_t x, y;
};

struct nb_grid {
  double width[NB_GRID_LEVELS]; /* width of the boxes of each level, m */
  size_t count[NB_GRID_LEVELS]; /* number of items on each level */
  size_t mask; /* number of buckets, a power of two, minus 1; the boxes of a bucket have the same hash */
  int *first;  /* for each bucket: the item added last, -1: none */
  struct nb_grid_entry {
    struct nb_box box;
    int next; /* the item added to this bucket before this one; -1: none */
  } * entry;  /* for each item */
};

/* Creates an empty grid for `items` items, the widest of which has the width `largest_width`, m. False: out of
 * memory. */
bool nb_grid_create(struct nb_grid *grid, size_t items, double largest_width);
void nb_grid_free(struct nb_grid *grid);
/* Adds an item with the position `at` and a width, m. `item`: its index, below `items`. */
void nb_grid_add(struct nb_grid *grid, int item, struct nb_vec at, double width);

/* The integer coordinate of the box of this level that contains the coordinate x, m. All coordinates beyond 2^53 box
 * widths, on one side of the origin, share the last box; the search still compares the distances of the items in it. */
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

/* The first item that is in `box`, among `item` and the items after it in the list of its bucket; -1: none. */
static inline int nb_grid_next(const struct nb_grid *grid, int item, struct nb_box box) {
  while (item >= 0) {
    const struct nb_grid_entry *entry = &grid->entry[item];
    if (entry->box.x == box.x && entry->box.y == box.y && entry->box.level == box.level)
      break;
    item = entry->next;
  }
  return item;
}

/* Loops over all items in the box `where`. */
#define NB_GRID_FOR_BOX(grid, item, where)                                                                             \
  for (int item = nb_grid_next(grid, (grid)->first[nb_grid_bucket(grid, where)], where); item >= 0;                    \
       item = nb_grid_next(grid, (grid)->entry[item].next, where))
