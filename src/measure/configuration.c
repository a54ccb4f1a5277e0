/* Changes since the beginning of a stage, for snapshots with `from`.                       [R89 sec. 4.2, figure 6.35]
 *
 *   displacement, rotation   of a particle: current position, m, and angle, rad, minus those when the stage began
 *   slip                     of a contact: sum of |ds| over the steps at whose end the contact slides, m, since the
 *                            stage began or, if later, since the contact closed; |ds| of the step in which sliding
 *                            begins includes the elastic displacement
 *   lattice                  the space lattice that is equivalent to the assembly: lines between the centres of
 *                            particles in contact, or from a centre to the nearest point of a wall, at the current
 *                            positions. kind: 0 for a contact that exists at both times, 1 for a new contact, -1 for a
 *                            lost one
 *
 * A contact that opens and closes again in between is not lost; its slip counts from the last closing. The slip of a
 * contact is kept beside the history of its laws, one number for each stage that a `from` names, and a search keeps
 * both. A scene without `snapshot from` has no such data.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "configuration.h"

#include <stdlib.h>
#include <string.h>

struct reference {
  int stage;
  bool begun;
  struct nb_vec *position; /* per slot, m */
  double *angle;           /* per slot, rad; 0 in a scene without rotation */
  struct nb_neighbour_pairs touching;
};
struct nb_configuration {
  size_t count;
  struct reference *list;
};

size_t nb_configuration_count(const struct nb_configuration *configuration) {
  return configuration ? configuration->count : 0;
}

/* Index of the reference that belongs to a stage; `count` if there is none. */
static size_t index_of(const struct nb_configuration *configuration, int stage) {
  size_t r = 0;
  while (r < configuration->count && configuration->list[r].stage != stage)
    r++;
  return r;
}

bool nb_configuration_create(struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const int from = scene->stages[s].snapshot_from;
    if (from < 0)
      continue;
    struct nb_configuration *configuration = model->configuration =
        model->configuration ? model->configuration : calloc(1, sizeof *configuration);
    if (!configuration ||
        (!configuration->list && !(configuration->list = calloc(scene->stage_count, sizeof *configuration->list))))
      return false;
    if (index_of(configuration, from) < configuration->count)
      continue;
    struct reference *reference = &configuration->list[configuration->count++];
    reference->stage = from;
    reference->position = nb_array(model->particles.count, sizeof *reference->position);
    reference->angle = nb_array(model->particles.count, sizeof *reference->angle);
    if (!reference->position || !reference->angle)
      return false;
  }
  return true;
}

void nb_configuration_free(struct nb_configuration *configuration) {
  for (size_t r = 0; r < nb_configuration_count(configuration); r++)
    free(configuration->list[r].position), free(configuration->list[r].angle),
        free(configuration->list[r].touching.list);
  if (configuration)
    free(configuration->list);
  free(configuration);
}

void nb_configuration_store(struct nb_store *store, struct nb_model *model) {
  for (size_t r = 0; r < nb_configuration_count(model->configuration); r++) {
    struct reference *reference = &model->configuration->list[r];
    NB_STORE_INTEGERS(store, "reference", &reference->begun, 1);
    NB_STORE(store, "reference.position", reference->position, model->particles.count);
    NB_STORE(store, "reference.angle", reference->angle, model->particles.count);
    nb_pairs_store(store, "reference.touching", &reference->touching, model);
  }
}

/* Pointer to the slip of a contact since the reference with the index r, m. */
static double *slid(const struct nb_contacts *contacts, size_t r, size_t contact) {
  const struct nb_history *history = &contacts->slip_sum;
  return history->rows ? &history->rows[contact * (size_t)history->doubles + r] : &history->field[r][contact];
}

static struct nb_neighbour_pair pair_of(const struct nb_contacts *contacts, size_t c) {
  return (struct nb_neighbour_pair){contacts->a[c], contacts->b[c], contacts->material_pair[c]};
}

bool nb_touching_pairs(struct nb_neighbour_pairs *touching, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  free(touching->list);
  *touching = (struct nb_neighbour_pairs){.list = nb_array(contacts->count, sizeof *touching->list)};
  for (size_t c = 0; touching->list && c < contacts->count; c++)
    if (nb_touches(contacts, c))
      touching->list[touching->count++] = pair_of(contacts, c);
  return touching->list;
}

bool nb_configuration_begin(struct nb_model *model, int stage) {
  const struct nb_particles *particles = &model->particles;
  const size_t r = index_of(model->configuration, stage);
  if (r == model->configuration->count)
    return true;
  struct reference *reference = &model->configuration->list[r];
  if (!nb_touching_pairs(&reference->touching, model))
    return false;
  memcpy(reference->position, particles->position, particles->count * sizeof *particles->position);
  if (particles->angle)
    memcpy(reference->angle, particles->angle, particles->count * sizeof *particles->angle);
  return reference->begun = true;
}

void nb_configuration_add_slip(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *ds = contacts->kept[NB_TANGENTIAL_INCREMENT], *sliding = contacts->kept[NB_SLIDING];
  for (size_t r = 0; r < model->configuration->count; r++)
    for (size_t c = 0; c < contacts->count && model->configuration->list[r].begun; c++) {
      double *sum = slid(contacts, r, c);
      *sum = nb_touches(contacts, c) ? *sum + sliding[c] * fabs(ds[c]) : 0;
    }
}

/* ---- values ---- */

static const struct reference *reference_of(const struct nb_model *model, int stage) {
  return &model->configuration->list[index_of(model->configuration, stage)];
}
struct nb_vec nb_configuration_displacement(const struct nb_model *model, int stage, size_t slot) {
  return vec_sub(model->particles.position[slot], reference_of(model, stage)->position[slot]);
}
double nb_configuration_rotation(const struct nb_model *model, int stage, size_t slot) {
  return model->particles.angle ? model->particles.angle[slot] - reference_of(model, stage)->angle[slot] : 0;
}
double nb_configuration_slip(const struct nb_model *model, int stage, size_t contact) {
  return *slid(&model->contacts, index_of(model->configuration, stage), contact);
}

/* ---- the lattice ---- */

static bool is_removed(const struct nb_model *model, struct nb_neighbour_pair pair) {
  const bool wall = model->material_pairs[pair.material_pair].wall;
  return nb_removed(model, (size_t)pair.a) ||
         (wall ? nb_wall_removed(&model->walls, (size_t)pair.b) : nb_removed(model, (size_t)pair.b));
}

struct nb_vec nb_pair_branch(const struct nb_model *model, struct nb_neighbour_pair pair) {
  const struct nb_vec *x = model->particles.position;
  if (model->material_pairs[pair.material_pair].wall)
    return vec_sub(nb_wall_nearest(&model->walls, pair.b, x[pair.a]), x[pair.a]);
  const struct nb_vec apart = vec_sub(x[pair.b], x[pair.a]);
  if (!model->cell)
    return apart;
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  return vec_add(apart, tensor_times(model->cell->h, nb_wrap_image(&wrap, apart)));
}

/* The current contacts and the pairs of the reference are in the same order, so the walk can merge them. */
bool nb_configuration_next(struct nb_configuration_walk *walk, struct nb_neighbour_pair *pair, int *kind) {
  const struct nb_contacts *contacts = &walk->model->contacts;
  while (walk->now < contacts->count && !nb_touches(contacts, walk->now))
    walk->now++;
  const bool has_now = walk->now < contacts->count, has_past = walk->past < walk->reference->count;
  if (!has_now && !has_past)
    return false;
  const struct nb_neighbour_pair now = has_now ? pair_of(contacts, walk->now) : walk->reference->list[walk->past];
  const struct nb_neighbour_pair past = has_past ? walk->reference->list[walk->past] : now;
  const int order = !has_now ? -1 : !has_past ? 1 : nb_contacts_order(walk->model, past, now);
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

bool nb_configuration_lattice(struct nb_table *table, const struct nb_model *model, int stage, int from) {
  static const struct nb_table_column columns[] = {LINE(NB_TABLE_COLUMN)};
  const int *number = model->particles.number;
  struct nb_configuration_walk walk = {.model = model, .reference = &reference_of(model, from)->touching};
  struct nb_neighbour_pair pair;
  bool complete = nb_snapshot_table(table, model->scene, columns, sizeof columns / sizeof *columns);
  for (int kind; complete && nb_configuration_next(&walk, &pair, &kind);) {
    if (is_removed(model, pair))
      continue;
    const bool wall = model->material_pairs[pair.material_pair].wall;
    const struct nb_vec x = nb_cell_wrapped_position(model, (size_t)pair.a),
                        to = vec_add(x, nb_pair_branch(model, pair));
    complete = nb_snapshot_row(table, model, stage, (const double[]){LINE(NB_VALUE)});
  }
  return complete;
}
