/* Which pairs can touch.                                             [CS79; R89 4.3.1, TOL]
 *
 * All pairs closer than the skin are listed, touching or not. As long as no body and no wall is farther than half the skin
 * from where it was then, a pair that is not listed cannot touch. A scene in which nothing travels is searched once, when it
 * is made.
 *
 * Bodies are put into square cells as wide as the largest disc and the skin; a cell is found by a hash of its whole-number
 * co-ordinates, so a scene may lie anywhere and have no edge. A contact that was listed before keeps its memory.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "near.h"

struct cells {
  double width;
  size_t mask;      /* buckets - 1, a power of two less one */
  int64_t *cx, *cy; /* per slot: its cell */
  size_t *first;    /* per bucket: first of its bodies in `member` */
  int *member;      /* slots, bucket by bucket, in the order of their numbers */
};

static size_t bucket_of(const struct cells *cells, int64_t cx, int64_t cy) {
  uint64_t h = (uint64_t)cx * 0x9e3779b97f4a7c15u ^ ((uint64_t)cy * 0xc2b2ae3d27d4eb4fu);
  h ^= h >> 29;
  return (size_t)h & cells->mask;
}

static void cells_free(struct cells *cells) {
  free(cells->cx), free(cells->cy), free(cells->first), free(cells->member);
}

/* Farther out than whole numbers go in a double, the last cell takes all: they are still in order, and compared by distance. */
static int64_t cell_at(double widths) {
  const double last = 9007199254740992;
  return (int64_t)(widths < -last ? -last : widths > last ? last : floor(widths));
}

static bool cells_fill(struct cells *cells, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  const size_t n = bodies->count;
  double largest = 0;
  for (size_t i = 0; i < n; i++)
    largest = bodies->rim[i].x > largest ? bodies->rim[i].x : largest;
  size_t buckets = 16;
  while (buckets < 2 * n)
    buckets *= 2;
  *cells = (struct cells){.width = 2 * largest + model->skin, .mask = buckets - 1};
  cells->cx = nb_array(n, sizeof *cells->cx), cells->cy = nb_array(n, sizeof *cells->cy);
  cells->first = nb_array(buckets + 2, sizeof *cells->first), cells->member = nb_array(n, sizeof *cells->member);
  if (!cells->cx || !cells->cy || !cells->first || !cells->member)
    return false;
  for (size_t i = 0; i < n; i++) {
    cells->cx[i] = cell_at(bodies->position[i].x / cells->width);
    cells->cy[i] = cell_at(bodies->position[i].y / cells->width);
    cells->first[bucket_of(cells, cells->cx[i], cells->cy[i]) + 2]++;
  }
  for (size_t b = 2; b < buckets + 2; b++)
    cells->first[b] += cells->first[b - 1];
  for (size_t k = 0; k < n; k++) { /* in the order of numbers */
    const int i = bodies->slot[k];
    cells->member[cells->first[bucket_of(cells, cells->cx[i], cells->cy[i]) + 1]++] = i;
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

/* The bodies of one cell that are near body i and have a larger number, put in the order of their numbers. */
static bool near_in_cell(struct nb_near_pairs *pairs, const struct nb_model *model, const struct cells *cells, int i,
                         int64_t cx, int64_t cy) {
  const struct nb_bodies *bodies = &model->bodies;
  const size_t bucket = bucket_of(cells, cx, cy);
  for (size_t k = cells->first[bucket]; k < cells->first[bucket + 1]; k++) {
    const int j = cells->member[k];
    if (cells->cx[j] != cx || cells->cy[j] != cy || bodies->number[j] <= bodies->number[i])
      continue;
    const struct nb_vec apart = vec_sub(bodies->position[j], bodies->position[i]);
    if (!(vec_length(apart) < bodies->rim[i].x + bodies->rim[j].x + model->skin))
      continue;
    if (!(bodies->inverse_mass[i] > 0 || bodies->inverse_mass[j] > 0))
      continue; /* both are fixed */
    if (!pairs_add(pairs, i, j, pairing_of(model, bodies->material[i], bodies->material[j], false)))
      return false;
  }
  return true;
}

static bool near_walls(struct nb_near_pairs *pairs, const struct nb_model *model, int i) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t w = 0; w < walls->count; w++) {
    const struct nb_vec from_p = vec_sub(bodies->position[i], walls->point[w]);
    const double s = vec_dot(from_p, walls->along[w]);
    const double on = s < walls->h1[w] ? walls->h1[w] : s > walls->h2[w] ? walls->h2[w] : s;
    const struct nb_vec apart = vec_sub(from_p, vec_scale(on, walls->along[w]));
    if (!(vec_length(apart) < bodies->rim[i].x + model->skin) || !(bodies->inverse_mass[i] > 0))
      continue;
    if (!pairs_add(pairs, i, (int)w, pairing_of(model, bodies->material[i], model->scene->walls[w].material, true)))
      return false;
  }
  return true;
}

int nb_near_order(const struct nb_model *model, struct nb_near_pair p, struct nb_near_pair q) {
  const int *number = model->bodies.number;
  if (p.pairing != q.pairing)
    return p.pairing < q.pairing ? -1 : 1;
  if (p.a != q.a)
    return number[p.a] < number[q.a] ? -1 : 1;
  if (p.b == q.b)
    return 0;
  return (model->pairings[p.pairing].wall ? p.b < q.b : number[p.b] < number[q.b]) ? -1 : 1;
}

/* All near pairs: body by body in the order of numbers, the few of each put in order, then stably by pairing. */
static bool pairs_find(struct nb_near_pairs *pairs, const struct nb_model *model, const struct cells *cells) {
  struct nb_near_pairs found = {0};
  for (size_t k = 0; k < model->bodies.count; k++) {
    const int i = model->bodies.slot[k];
    const size_t from = found.count;
    bool room = true;
    for (int64_t dy = -1; dy <= 1; dy++)
      for (int64_t dx = -1; dx <= 1; dx++)
        room = room && near_in_cell(&found, model, cells, i, cells->cx[i] + dx, cells->cy[i] + dy);
    room = room && near_walls(&found, model, i);
    if (!room) {
      free(found.list);
      return false;
    }
    for (size_t p = from + 1; p < found.count; p++) {
      const struct nb_near_pair it = found.list[p];
      size_t q = p;
      for (; q > from && nb_near_order(model, it, found.list[q - 1]) < 0; q--)
        found.list[q] = found.list[q - 1];
      found.list[q] = it;
    }
  }
  pairs->list = malloc((found.count + 1) * sizeof *pairs->list);
  if (pairs->list)
    for (int p = 0; p < (int)model->pairing_count; p++)
      for (size_t k = 0; k < found.count; k++)
        if (found.list[k].pairing == p)
          pairs->list[pairs->count++] = found.list[k];
  free(found.list);
  return pairs->list != NULL;
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
  if (find_lost(model, error))
    return error->status;
  struct nb_near_pairs pairs = {0};
  struct cells cells = {0};
  const bool found = cells_fill(&cells, model) && pairs_find(&pairs, model, &cells);
  cells_free(&cells);
  const bool made = found && nb_contacts_renew(model, &pairs);
  free(pairs.list);
  if (!made)
    return nb_error_set(error, NB_BROKEN, "out of memory while searching for contacts");
  memcpy(model->bodies.searched, model->bodies.position, model->bodies.count * sizeof(struct nb_vec));
  memcpy(model->walls.searched, model->walls.point, model->walls.count * sizeof(struct nb_vec));
  model->searches++;
  return nb_plan_views(model, error);
}
