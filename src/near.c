/* Which pairs can touch.                                             [CS79; R89 4.3.1, TOL]
 *
 * All pairs closer than the skin are listed, touching or not. As long as no body and no wall is farther than half the skin
 * from where it was then, a pair that is not listed cannot touch. A scene in which nothing travels is searched once, when it
 * is made; one in which nothing is free to touch anything has an infinite skin and is never searched.
 *
 * Bodies are put into square cells; a cell is found by a hash of its whole-number co-ordinates, so a scene may lie anywhere and
 * have no edge. There are levels of cells, each half as wide as the one before: a body lives on the finest level whose cells
 * are as wide as it is and the skin. So a few large bodies among many small ones cost the small ones nothing: a body looks at
 * the nine cells around it on its own level, and on those of larger bodies, as far as there are any. Scenes of a few bodies
 * have no cells. A contact that was listed before keeps its memory.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "near.h"

enum {
  LEVELS = 24,
  FEW = 16
}; /* radii from 1 to 2^-23: the last level takes all that are smaller; bodies without cells */

struct cells {
  double width[LEVELS];
  size_t count[LEVELS]; /* bodies on each level */
  size_t mask;          /* buckets - 1, a power of two less one */
  int *level;           /* per slot */
  int64_t *cx, *cy;     /* per slot: its cell on its level */
  size_t *first;        /* per bucket: first of its bodies in `member` */
  int *member;          /* slots, bucket by bucket, in the order of their numbers */
};

static size_t bucket_of(const struct cells *cells, int level, int64_t cx, int64_t cy) {
  uint64_t h =
      (uint64_t)cx * 0x9e3779b97f4a7c15u ^ (uint64_t)cy * 0xc2b2ae3d27d4eb4fu ^ (uint64_t)level * 0x165667b19e3779f9u;
  h ^= h >> 29;
  return (size_t)h & cells->mask;
}

static void cells_free(struct cells *cells) {
  free(cells->level), free(cells->cx), free(cells->cy), free(cells->first), free(cells->member);
}

/* Farther out than whole numbers go in a double, the last cell takes all: they are still in order, and compared by distance. */
static int64_t cell_at(double widths) {
  const double last = 9007199254740992;
  return (int64_t)(widths < -last ? -last : widths > last ? last : floor(widths));
}

static void choose_levels(struct cells *cells, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  double largest = 0;
  for (size_t i = 0; i < bodies->count; i++)
    largest = bodies->rim[i].x > largest ? bodies->rim[i].x : largest;
  for (int l = 0; l < LEVELS; l++)
    cells->width[l] = l ? cells->width[l - 1] / 2 : 2 * largest + model->skin;
  for (size_t i = 0; i < bodies->count; i++) {
    int level = 0;
    while (level + 1 < LEVELS && cells->width[level + 1] >= 2 * bodies->rim[i].x + model->skin)
      level++;
    cells->level[i] = level;
    cells->count[level]++;
  }
}

static bool cells_fill(struct cells *cells, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  const size_t n = bodies->count;
  size_t buckets = 16;
  while (buckets < 2 * n)
    buckets *= 2;
  *cells = (struct cells){.mask = buckets - 1, .level = nb_array(n, sizeof *cells->level)};
  cells->cx = nb_array(n, sizeof *cells->cx), cells->cy = nb_array(n, sizeof *cells->cy);
  cells->first = nb_array(buckets + 2, sizeof *cells->first), cells->member = nb_array(n, sizeof *cells->member);
  if (!cells->level || !cells->cx || !cells->cy || !cells->first || !cells->member)
    return false;
  choose_levels(cells, model);
  for (size_t i = 0; i < n; i++) {
    cells->cx[i] = cell_at(bodies->position[i].x / cells->width[cells->level[i]]);
    cells->cy[i] = cell_at(bodies->position[i].y / cells->width[cells->level[i]]);
    cells->first[bucket_of(cells, cells->level[i], cells->cx[i], cells->cy[i]) + 2]++;
  }
  for (size_t b = 2; b < buckets + 2; b++)
    cells->first[b] += cells->first[b - 1];
  for (size_t k = 0; k < n; k++) { /* in the order of numbers */
    const int i = bodies->slot[k];
    cells->member[cells->first[bucket_of(cells, cells->level[i], cells->cx[i], cells->cy[i]) + 1]++] = i;
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

/* Bodies i and j are listed when they are near, the one with the smaller number first. */
static bool near_pair(struct nb_near_pairs *pairs, struct nb_model *model, int i, int j) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct nb_vec apart = vec_sub(bodies->position[j], bodies->position[i]);
  model->candidates++;
  if (!(vec_length(apart) < bodies->rim[i].x + bodies->rim[j].x + model->skin))
    return true;
  if (!(bodies->inverse_mass[i] > 0 || bodies->inverse_mass[j] > 0))
    return true; /* both are fixed */
  if (nb_gone(model, (size_t)i) || nb_gone(model, (size_t)j))
    return true;
  const int a = bodies->number[i] < bodies->number[j] ? i : j, b = a == i ? j : i;
  return pairs_add(pairs, a, b, pairing_of(model, bodies->material[a], bodies->material[b], false));
}

/* The bodies of one cell on a level: all of them when they are larger than i, those with larger numbers on its own. */
static bool near_in_cell(struct nb_near_pairs *pairs, struct nb_model *model, const struct cells *cells, int i,
                         int level, int64_t cx, int64_t cy) {
  const int *number = model->bodies.number;
  const size_t bucket = bucket_of(cells, level, cx, cy);
  for (size_t k = cells->first[bucket]; k < cells->first[bucket + 1]; k++) {
    const int j = cells->member[k];
    if (cells->cx[j] != cx || cells->cy[j] != cy || cells->level[j] != level)
      continue;
    if (level == cells->level[i] && number[j] <= number[i])
      continue;
    if (!near_pair(pairs, model, i, j))
      return false;
  }
  return true;
}

static bool near_in_cells(struct nb_near_pairs *pairs, struct nb_model *model, const struct cells *cells, int i) {
  for (int level = cells->level[i]; level >= 0; level--) {
    if (!cells->count[level])
      continue;
    const int64_t cx = cell_at(model->bodies.position[i].x / cells->width[level]);
    const int64_t cy = cell_at(model->bodies.position[i].y / cells->width[level]);
    for (int64_t dy = -1; dy <= 1; dy++)
      for (int64_t dx = -1; dx <= 1; dx++)
        if (!near_in_cell(pairs, model, cells, i, level, cx + dx, cy + dy))
          return false;
  }
  return true;
}

static bool near_walls(struct nb_near_pairs *pairs, struct nb_model *model, int i) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t w = 0; w < walls->count; w++) {
    const double apart = vec_length(nb_wall_apart(walls, (int)w, bodies->position[i]));
    if (!(apart < bodies->rim[i].x + model->skin) || !(bodies->inverse_mass[i] > 0))
      continue;
    model->pressed = model->pressed || !(apart > model->skin);
    if (!pairs_add(pairs, i, (int)w, pairing_of(model, bodies->material[i], model->scene->walls[w].material, true)))
      return false;
  }
  return true;
}

static bool pairs_find(struct nb_near_pairs *found, struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  const int n = (int)bodies->count;
  struct cells cells = {0};
  bool room = n <= FEW || cells_fill(&cells, model);
  for (int k = 0; k < n && room; k++) {
    const int i = bodies->slot[k];
    if (n > FEW)
      room = near_in_cells(found, model, &cells, i);
    for (int l = k + 1; l < n && n <= FEW && room; l++)
      room = near_pair(found, model, i, bodies->slot[l]);
    room = room && near_walls(found, model, i);
  }
  cells_free(&cells);
  return room;
}

/* In order: counted out by the number of the first body, the few of each one by insertion, then stably by pairing. */
static bool pairs_sort(struct nb_near_pairs *pairs, const struct nb_model *model) {
  const size_t n = pairs->count, bodies = model->bodies.count;
  const int *number = model->bodies.number;
  struct nb_near_pair *found = pairs->list, *sorted = nb_array(n, sizeof *sorted);
  size_t *first = nb_array(bodies + 2, sizeof *first);
  if (sorted && first) {
    for (size_t p = 0; p < n; p++)
      first[number[found[p].a] + 1]++;
    for (size_t k = 1; k < bodies + 2; k++)
      first[k] += first[k - 1];
    for (size_t p = 0; p < n; p++) {
      const size_t from = first[number[found[p].a]]++;
      sorted[from] = found[p];
    }
    for (size_t p = 1; p < n; p++) {
      const struct nb_near_pair it = sorted[p];
      size_t q = p;
      for (; q > 0 && sorted[q - 1].a == it.a && nb_contacts_order(model, it, sorted[q - 1]) < 0; q--)
        sorted[q] = sorted[q - 1];
      sorted[q] = it;
    }
    size_t count = 0;
    for (int pairing = 0; pairing < (int)model->pairing_count; pairing++)
      for (size_t p = 0; p < n; p++)
        if (sorted[p].pairing == pairing)
          found[count++] = sorted[p];
  }
  const bool done = sorted && first;
  free(sorted), free(first);
  return done;
}

/* The first body whose position is not a number: infinity less itself is none either. */
static enum nb_status find_lost(const struct nb_model *model, struct nb_error *error) {
  for (size_t k = 0; k < model->bodies.count; k++) {
    const struct nb_vec x = model->bodies.position[model->bodies.slot[k]];
    if (x.x - x.x == 0 && x.y - x.y == 0)
      continue;
    return nb_error_set(
        error, NB_BROKEN,
        "body %zu (line %d) is nowhere: its position is not a number after cycle %lu, at %g s; the step is %g s, the "
        "critical one %g s: try a smaller step",
        k + 1, model->scene->bodies[k].line, model->cycle, model->time, model->step, model->critical);
  }
  return NB_OK;
}

enum nb_status nb_near(struct nb_model *model, struct nb_error *error) {
  if (find_lost(model, error) || nb_walls_crossed(model, true, error))
    return error->status;
  struct nb_near_pairs pairs = {0};
  const bool searching = model->skin < INFINITY;
  model->pressed = false;
  const bool found = !searching || (pairs_find(&pairs, model) && pairs_sort(&pairs, model));
  const bool made = found && nb_contacts_renew(model, &pairs) && nb_joints_find(model);
  free(pairs.list);
  if (!made)
    return nb_error_set(error, NB_BROKEN, "out of memory while searching for contacts");
  memcpy(model->bodies.searched, model->bodies.position, model->bodies.count * sizeof(struct nb_vec));
  nb_walls_searched(&model->walls);
  model->searches += searching;
  return nb_plan_views(model, error);
}
