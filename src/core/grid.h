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
  struct nb_in_box {
    struct nb_box box;
    int next; /* and the one that came before, of this bucket */
  } * in;     /* per thing */
};

/* For so many things, of which the widest is so wide, m; false: no memory. */
bool nb_grid_create(struct nb_grid *grid, size_t things, double widest);
void nb_grid_free(struct nb_grid *grid);
void nb_grid_add(struct nb_grid *grid, int thing, struct nb_vec at, double width);

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
static inline int nb_grid_seek(const struct nb_grid *grid, int thing, struct nb_box box) {
  while (thing >= 0) {
    const struct nb_in_box *in = &grid->in[thing];
    if (in->box.x == box.x && in->box.y == box.y && in->box.level == box.level)
      break;
    thing = in->next;
  }
  return thing;
}

/* All things in a box. */
#define NB_IN_BOX(grid, thing, where)                                                                                  \
  for (int thing = nb_grid_seek(grid, (grid)->first[nb_grid_bucket(grid, where)], where); thing >= 0;                  \
       thing = nb_grid_seek(grid, (grid)->in[thing].next, where))

#endif
