/* What has changed since a stage began.                                               [R89 4.2, figure 6.35]
 *
 *   moved, turned   of a body: its place and angle less those of then
 *   slid            of a contact: sum of |ds| over the steps that it ends sliding, which are those since that stage began and
 *                   since the bodies came to touch; in a step in which sliding begins that includes what the spring took up
 *   lattice         lines from centre to centre of bodies that touch, or to where a wall is nearest: the space lattice that is
 *                   equivalent to the assembly. kind: 0 contacts of then and now, 1 new ones, -1 lost ones, between the
 *                   places of now
 *
 * One that parts and comes back between the two is kept; it has slid since it came back. What has slid stands beside what the
 * laws remember of a contact, one number for each such stage, and goes through searches with it. A scene without
 * `snapshot from` has none of this.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "since.h"

#include <stdlib.h>
#include <string.h>

struct reference {
  int stage;
  bool begun;
  struct nb_vec *position; /* per slot, m */
  double *angle;           /* per slot, rad; NULL in a scene without spin */
  struct nb_near_pairs touching;
};
struct nb_since {
  size_t count;
  struct reference *list;
};

size_t nb_since_count(const struct nb_since *since) { return since ? since->count : 0; }

static size_t index_of(const struct nb_since *since, int stage) {
  size_t r = 0;
  while (r < since->count && since->list[r].stage != stage)
    r++;
  return r;
}

bool nb_since_create(struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const int from = scene->stages[s].snapshot_from;
    if (from < 0)
      continue;
    struct nb_since *since = model->since = model->since ? model->since : calloc(1, sizeof *since);
    if (!since || (!since->list && !(since->list = calloc(scene->stage_count, sizeof *since->list))))
      return false;
    if (index_of(since, from) < since->count)
      continue;
    struct reference *reference = &since->list[since->count++];
    reference->stage = from;
    reference->position = nb_array(model->bodies.count, sizeof *reference->position);
    reference->angle = nb_array(model->bodies.count, sizeof *reference->angle);
    if (!reference->position || !reference->angle)
      return false;
  }
  return true;
}

void nb_since_free(struct nb_since *since) {
  for (size_t r = 0; r < nb_since_count(since); r++)
    free(since->list[r].position), free(since->list[r].angle), free(since->list[r].touching.list);
  if (since)
    free(since->list);
  free(since);
}

static double *slid(const struct nb_contacts *contacts, size_t r, size_t contact) {
  const struct nb_memory *memory = &contacts->slid;
  return memory->rows ? &memory->rows[contact * (size_t)memory->doubles + r] : &memory->field[r][contact];
}

static struct nb_near_pair pair_of(const struct nb_contacts *contacts, size_t c) {
  return (struct nb_near_pair){contacts->a[c], contacts->b[c], contacts->pairing[c]};
}

bool nb_since_touching(struct nb_near_pairs *touching, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  free(touching->list);
  *touching = (struct nb_near_pairs){.list = nb_array(contacts->count, sizeof *touching->list)};
  for (size_t c = 0; touching->list && c < contacts->count; c++)
    if (nb_touches(contacts, c))
      touching->list[touching->count++] = pair_of(contacts, c);
  return touching->list;
}

bool nb_since_begin(struct nb_model *model, int stage) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_bodies *bodies = &model->bodies;
  const size_t r = index_of(model->since, stage);
  if (r == model->since->count)
    return true;
  struct reference *reference = &model->since->list[r];
  if (!nb_since_touching(&reference->touching, model))
    return false;
  memcpy(reference->position, bodies->position, bodies->count * sizeof *bodies->position);
  if (bodies->angle)
    memcpy(reference->angle, bodies->angle, bodies->count * sizeof *bodies->angle);
  for (size_t c = 0; c < contacts->count; c++)
    *slid(contacts, r, c) = 0;
  return reference->begun = true;
}

void nb_since_forces(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *slip = contacts->kept[NB_SLIP], *sliding = contacts->kept[NB_SLIDING];
  for (size_t r = 0; r < model->since->count; r++)
    for (size_t c = 0; c < contacts->count && model->since->list[r].begun; c++) {
      double *sum = slid(contacts, r, c);
      *sum = nb_touches(contacts, c) ? *sum + sliding[c] * fabs(slip[c]) : 0;
    }
}

/* ---- what is asked ---- */

static const struct reference *reference_of(const struct nb_model *model, int stage) {
  return &model->since->list[index_of(model->since, stage)];
}
struct nb_vec nb_since_moved(const struct nb_model *model, int stage, size_t slot) {
  return vec_sub(model->bodies.position[slot], reference_of(model, stage)->position[slot]);
}
double nb_since_turned(const struct nb_model *model, int stage, size_t slot) {
  return model->bodies.angle ? model->bodies.angle[slot] - reference_of(model, stage)->angle[slot] : 0;
}
double nb_since_slid(const struct nb_model *model, int stage, size_t contact) {
  return *slid(&model->contacts, index_of(model->since, stage), contact);
}

/* ---- the lattice ---- */

static bool is_gone(const struct nb_model *model, struct nb_near_pair pair) {
  return nb_gone(model, (size_t)pair.a) || (!model->pairings[pair.pairing].wall && nb_gone(model, (size_t)pair.b));
}

struct nb_vec nb_since_line(const struct nb_model *model, struct nb_near_pair pair) {
  const struct nb_vec *x = model->bodies.position;
  if (model->pairings[pair.pairing].wall)
    return vec_sub(nb_wall_nearest(&model->walls, pair.b, x[pair.a]), x[pair.a]);
  const struct nb_vec apart = vec_sub(x[pair.b], x[pair.a]);
  if (!model->cell)
    return apart;
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  return vec_add(apart, tensor_times(model->cell->h, nb_wrap_image(&wrap, apart)));
}

/* Both lists are in the order of contacts: one walk along both. */
bool nb_since_next(struct nb_since_walk *walk, struct nb_near_pair *pair, int *kind) {
  const struct nb_contacts *contacts = &walk->model->contacts;
  while (walk->now < contacts->count && !nb_touches(contacts, walk->now))
    walk->now++;
  const bool is = walk->now < contacts->count, was = walk->past < walk->then->count;
  if (!is && !was)
    return false;
  const struct nb_near_pair now = is ? pair_of(contacts, walk->now) : walk->then->list[walk->past];
  const struct nb_near_pair past = was ? walk->then->list[walk->past] : now;
  const int order = !is ? -1 : !was ? 1 : nb_contacts_order(walk->model, past, now);
  *kind = (order > 0) - (order < 0);
  *pair = *kind < 0 ? past : now;
  walk->past += *kind <= 0, walk->now += *kind >= 0;
  return true;
}

#define LINE(COLUMN)                                                                                                   \
  COLUMN("a", "1", number[pair.a])                                                                                     \
  COLUMN("b", "1", wall ? 0 : number[pair.b])                                                                          \
  COLUMN("wall", "1", wall ? pair.b + 1 : 0)                                                                           \
  COLUMN("x1", "m", x.x)                                                                                               \
  COLUMN("y1", "m", x.y)                                                                                               \
  COLUMN("x2", "m", to.x)                                                                                              \
  COLUMN("y2", "m", to.y)                                                                                              \
  COLUMN("kind", "1", kind)

bool nb_since_lattice(struct nb_table *table, const struct nb_model *model, int stage, int from) {
  static const struct nb_head columns[] = {LINE(NB_HEAD)};
  const int *number = model->bodies.number;
  struct nb_since_walk walk = {.model = model, .then = &reference_of(model, from)->touching};
  struct nb_near_pair pair;
  bool whole = nb_snapshot_table(table, model->scene, columns, sizeof columns / sizeof *columns);
  for (int kind; whole && nb_since_next(&walk, &pair, &kind);) {
    if (is_gone(model, pair))
      continue;
    const bool wall = model->pairings[pair.pairing].wall;
    const struct nb_vec x = nb_cell_place(model, (size_t)pair.a), to = vec_add(x, nb_since_line(model, pair));
    whole = nb_snapshot_row(table, model, stage, (const double[]){LINE(NB_VALUE)});
  }
  return whole;
}
