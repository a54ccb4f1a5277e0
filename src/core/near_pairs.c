/* Which pairs of bodies, and of bodies and walls, are nearer than the skin.
 *
 * Bodies are put into square boxes; a box is found by a hash of its whole-number co-ordinates, so a scene may lie anywhere and
 * have no edge. There are levels of boxes, each half as wide as the one before: a body lives on the finest level whose boxes
 * are as wide as it is and the skin. So a few large bodies among many small ones cost the small ones nothing: a body looks at
 * the nine boxes around it on its own level, and on those of larger bodies, as far as there are any. Scenes of a few bodies
 * have no boxes.
 *
 * In a periodic cell (cell.c) bodies count as where their copy in the cell is. Whichever of its copies comes near the cell
 * looks around as well, and that finds every pair once.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdint.h>
#include <stdlib.h>

#include "near.h"

enum {
  LEVELS = 24,
  FEW = 16
}; /* radii from 1 to 2^-23: the last level takes all that are smaller; bodies without boxes */

struct grid {
  double width[LEVELS];
  size_t count[LEVELS]; /* bodies on each level */
  size_t mask;          /* buckets - 1, a power of two less one */
  int *level;           /* per slot */
  int64_t *cx, *cy;     /* per slot: its box on its level */
  size_t *first;        /* per bucket: first of its bodies in `member` */
  int *member;          /* slots, bucket by bucket, in the order of their numbers */
  struct nb_wrap wrap;  /* of the periodic cell that bodies are in; */
  struct nb_vec *place; /* per slot: where its copy in the cell is, m; NULL without a cell */
};

static size_t bucket_of(const struct grid *grid, int level, int64_t cx, int64_t cy) {
  uint64_t h =
      (uint64_t)cx * 0x9e3779b97f4a7c15u ^ (uint64_t)cy * 0xc2b2ae3d27d4eb4fu ^ (uint64_t)level * 0x165667b19e3779f9u;
  h ^= h >> 29;
  return (size_t)h & grid->mask;
}

static void grid_free(struct grid *grid) {
  free(grid->level), free(grid->cx), free(grid->cy), free(grid->first), free(grid->member), free(grid->place);
}

/* Farther out than whole numbers go in a double, the last box takes all: they are still in order, and compared by distance. */
static int64_t box_at(double widths) {
  const double last = 9007199254740992;
  return (int64_t)(widths < -last ? -last : widths > last ? last : floor(widths));
}

static void choose_levels(struct grid *grid, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  double largest = 0;
  for (size_t i = 0; i < bodies->count; i++)
    largest = bodies->rim[i].x > largest ? bodies->rim[i].x : largest;
  for (int l = 0; l < LEVELS; l++)
    grid->width[l] = l ? grid->width[l - 1] / 2 : 2 * largest + model->search.skin;
  for (size_t i = 0; i < bodies->count; i++) {
    int level = 0;
    while (level + 1 < LEVELS && grid->width[level + 1] >= 2 * bodies->rim[i].x + model->search.skin)
      level++;
    grid->level[i] = level;
    grid->count[level]++;
  }
}

static bool wrap_places(struct grid *grid, const struct nb_model *model) {
  const size_t n = model->bodies.count;
  grid->place = nb_array(n, sizeof *grid->place);
  grid->wrap = nb_cell_wrap(model->cell);
  for (size_t i = 0; i < n && grid->place; i++)
    grid->place[i] = nb_wrapped(&grid->wrap, model->bodies.position[i]);
  return grid->place != NULL;
}

static inline struct nb_vec place_of(const struct grid *grid, const struct nb_model *model, int i) {
  return grid->place ? grid->place[i] : model->bodies.position[i];
}

static bool grid_fill(struct grid *grid, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  const size_t n = bodies->count;
  size_t buckets = 16;
  while (buckets < 2 * n)
    buckets *= 2;
  *grid = (struct grid){.mask = buckets - 1, .level = nb_array(n, sizeof *grid->level)};
  grid->cx = nb_array(n, sizeof *grid->cx), grid->cy = nb_array(n, sizeof *grid->cy);
  grid->first = nb_array(buckets + 2, sizeof *grid->first), grid->member = nb_array(n, sizeof *grid->member);
  if (!grid->level || !grid->cx || !grid->cy || !grid->first || !grid->member)
    return false;
  choose_levels(grid, model);
  if (model->cell && !wrap_places(grid, model))
    return false;
  for (size_t i = 0; i < n; i++) {
    const struct nb_vec x = place_of(grid, model, (int)i);
    grid->cx[i] = box_at(x.x / grid->width[grid->level[i]]);
    grid->cy[i] = box_at(x.y / grid->width[grid->level[i]]);
    grid->first[bucket_of(grid, grid->level[i], grid->cx[i], grid->cy[i]) + 2]++;
  }
  for (size_t b = 2; b < buckets + 2; b++)
    grid->first[b] += grid->first[b - 1];
  for (size_t k = 0; k < n; k++) { /* in the order of numbers */
    const int i = bodies->slot[k];
    grid->member[grid->first[bucket_of(grid, grid->level[i], grid->cx[i], grid->cy[i]) + 1]++] = i;
  }
  return true;
}

static bool pairs_add(struct nb_near_pairs *pairs, int a, int b, int pairing) {
  if (pairs->count == pairs->capacity) {
    const size_t capacity = pairs->capacity ? 2 * pairs->capacity : 256;
    struct nb_near_pair *list = realloc(pairs->list, capacity * sizeof *list);
    if (!list)
      return false;
    pairs->list = list, pairs->capacity = capacity;
  }
  pairs->list[pairs->count++] = (struct nb_near_pair){a, b, pairing};
  return true;
}

static int pairing_of(const struct nb_model *model, int material_a, int material_b, bool wall) {
  for (size_t p = 0; p < model->pairing_count; p++) {
    const struct nb_pairing *q = &model->pairings[p];
    if (q->wall == wall &&
        ((q->a == material_a && q->b == material_b) || (!wall && q->a == material_b && q->b == material_a)))
      return (int)p;
  }
  return -1;
}

/* Bodies i and j, `apart` from each other, are listed when they are near, the one with the smaller number first. */
static bool near_pair(struct nb_near_pairs *pairs, struct nb_model *model, int i, int j, struct nb_vec apart) {
  const struct nb_bodies *bodies = &model->bodies;
  model->search.candidates++;
  const double distance = vec_length(apart), larger = fmax(bodies->rim[i].x, bodies->rim[j].x);
  if (!(distance < bodies->rim[i].x + bodies->rim[j].x + model->search.skin))
    return true;
  if (!(bodies->inverse_mass[i] > 0 || bodies->inverse_mass[j] > 0))
    return true; /* both are fixed */
  if (nb_gone(model, (size_t)i) || nb_gone(model, (size_t)j))
    return true;
  const int a = bodies->number[i] < bodies->number[j] ? i : j, b = a == i ? j : i;
  model->search.squeezed = model->search.squeezed || !(distance > larger + model->search.skin);
  return pairs_add(pairs, a, b, pairing_of(model, bodies->material[a], bodies->material[b], false));
}

/* Who looks around, and from where: it is at `from`, or a copy of it is. */
struct looking {
  int i;
  struct nb_vec from; /* m */
};

/* The bodies of one box on a level: all of them when they are larger than i, those with larger numbers on its own. */
static bool near_in_box(struct nb_near_pairs *pairs, struct nb_model *model, const struct grid *grid,
                        struct looking who, int level, int64_t cx, int64_t cy) {
  const int *number = model->bodies.number;
  const size_t bucket = bucket_of(grid, level, cx, cy);
  for (size_t k = grid->first[bucket]; k < grid->first[bucket + 1]; k++) {
    const int j = grid->member[k];
    if (grid->cx[j] != cx || grid->cy[j] != cy || grid->level[j] != level)
      continue;
    if (level == grid->level[who.i] && number[j] <= number[who.i])
      continue;
    if (!near_pair(pairs, model, who.i, j, vec_sub(place_of(grid, model, j), who.from)))
      return false;
  }
  return true;
}

static bool near_around(struct nb_near_pairs *pairs, struct nb_model *model, const struct grid *grid,
                        struct looking who) {
  for (int level = grid->level[who.i]; level >= 0; level--) {
    if (!grid->count[level])
      continue;
    const int64_t cx = box_at(who.from.x / grid->width[level]), cy = box_at(who.from.y / grid->width[level]);
    for (int64_t dy = -1; dy <= 1; dy++)
      for (int64_t dx = -1; dx <= 1; dx++)
        if (!near_in_box(pairs, model, grid, who, level, cx + dx, cy + dy))
          return false;
  }
  return true;
}

/* From each of the nine copies of i that lies in the cell, or no farther outside than a contact reaches. */
static bool near_copies(struct nb_near_pairs *pairs, struct nb_model *model, const struct grid *grid, int i) {
  const struct nb_wrap *wrap = &grid->wrap;
  const double edge = (0.5 + grid->width[0] / nb_wrap_width(wrap)) * (1 + 1e-12);
  for (int m = 0; m < 9; m++) {
    const struct nb_vec from = vec_add(grid->place[i], tensor_times(wrap->h, vec(m % 3 - 1, m / 3 - 1)));
    const struct nb_vec at = tensor_times(wrap->inverse, vec_sub(from, wrap->centre));
    if (fabs(at.x) <= edge && fabs(at.y) <= edge && !near_around(pairs, model, grid, (struct looking){i, from}))
      return false;
  }
  return true;
}

static bool near_walls(struct nb_near_pairs *pairs, struct nb_model *model, int i) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t w = 0; w < walls->count; w++) {
    const double apart = vec_length(nb_wall_apart(walls, (int)w, bodies->position[i]));
    if (!(apart < bodies->rim[i].x + model->search.skin) || !(bodies->inverse_mass[i] > 0))
      continue;
    model->search.pressed = model->search.pressed || !(apart > model->search.skin);
    if (!pairs_add(pairs, i, (int)w, pairing_of(model, bodies->material[i], model->scene->walls[w].material, true)))
      return false;
  }
  return true;
}

bool nb_near_find(struct nb_near_pairs *found, struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct nb_vec *x = bodies->position;
  const int n = (int)bodies->count;
  const bool all = n <= FEW && !model->cell;
  struct grid grid = {0};
  bool room = all || grid_fill(&grid, model);
  for (int k = 0; k < n && room; k++) {
    const int i = bodies->slot[k];
    if (model->cell)
      room = near_copies(found, model, &grid, i);
    else if (!all)
      room = near_around(found, model, &grid, (struct looking){i, x[i]});
    for (int l = k + 1; l < n && all && room; l++)
      room = near_pair(found, model, i, bodies->slot[l], vec_sub(x[bodies->slot[l]], x[i]));
    room = room && near_walls(found, model, i);
  }
  grid_free(&grid);
  return room;
}
