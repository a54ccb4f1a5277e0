/* The list of contacts, built anew after each search, and the contacts of each particle.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "hertz_impact.h"
#include "model.h"

static bool pair_exists(struct nb_neighbour_pair pair, const struct nb_model *model) {
  if (pair.material_pair < 0 || pair.material_pair >= (int)model->material_pair_count)
    return false;
  const bool wall = model->material_pairs[pair.material_pair].wall;
  return pair.a >= 0 && pair.a < (int)model->particles.count && pair.b >= 0 &&
         pair.b < (int)(wall ? model->walls.count : model->particles.count);
}

void nb_pairs_store(struct nb_store *store, const char *name, struct nb_neighbour_pairs *pairs,
                    const struct nb_model *model) {
  enum { INTEGERS = sizeof *pairs->list / sizeof(int) };
  const size_t count = nb_store_length(store, name, pairs->count * INTEGERS) / INTEGERS;
  if (store->restoring) {
    free(pairs->list);
    pairs->list = nb_array(count, sizeof *pairs->list), pairs->count = pairs->list ? count : 0;
  }
  NB_STORE_INTEGERS(store, name, (int *)pairs->list, pairs->count * INTEGERS);
  for (size_t p = 0; store->restoring && p < pairs->count; p++)
    store->failed = store->failed || !pair_exists(pairs->list[p], model);
}

static void keep_doubles(double now[], const double old[], const int from[], size_t count) {
  for (size_t c = 0; c < count && now && old; c++)
    now[c] = from[c] >= 0 ? old[from[c]] : now[c];
}

/* The fields that a contact takes over from the old list. If forces are kept, these are all except M*. M* changes when a
 * particle becomes part of a boundary, because the mass of the particle is then infinite. The roots that contain M* are
 * computed again in each new block (pass/dashpots.c). If forces are not kept, these are the values of the last step
 * that the energy balance reads. */
static unsigned fields_that_stay(const struct nb_model *model) {
  if (model->search.keep_forces)
    return (NB_BIT(NB_FIELDS) - 1) & ~NB_BIT(NB_MASS);
  return model->plan.requested & NB_REQUEST_ENERGY
             ? NB_BIT(NB_OVERLAP) | NB_BIT(NB_SHEAR_BEFORE) | NB_BIT(NB_SHEAR_STIFFNESS_BEFORE)
             : 0;
}

static void keep_fields(struct nb_contacts *now, const struct nb_contacts *old, const int from[],
                        const struct nb_model *model) {
  const unsigned fields = fields_that_stay(model);
  for (size_t c = 0; c < now->count && model->search.keep_forces; c++)
    if (from[c] >= 0)
      now->force[c] = old->force[from[c]];
  for (int f = 0; f < NB_FIELDS; f++)
    if (fields & NB_BIT(f))
      keep_doubles(now->kept[f], old->kept[f], from, now->count);
}

/* Sets from[c] to the old index of contact c, or to -1 if the contact is new. Both lists have the same order, so one
 * pass through both is enough. */
static void find_old(int from[], const struct nb_model *model, const struct nb_contacts *old,
                     const struct nb_contacts *now) {
  size_t o = 0;
  for (size_t c = 0; c < now->count; c++) {
    const struct nb_neighbour_pair here = {now->a[c], now->b[c], now->material_pair[c]};
    int order = -1;
    for (; o < old->count && order < 0; o += order <= 0) {
      const struct nb_neighbour_pair there = {old->a[o], old->b[o], old->material_pair[o]};
      order = nb_contacts_order(model, there, here);
    }
    from[c] = order == 0 ? (int)o - 1 : -1;
  }
}

static void copy_histories(const struct nb_model *model, const struct nb_contacts *old, struct nb_contacts *now,
                           const int from[]) {
  for (size_t c = 0; c < now->count && now->suppressed && old->suppressed; c++)
    now->suppressed[c] = from[c] >= 0 ? old->suppressed[from[c]] : now->suppressed[c];
  keep_fields(now, old, from, model);
  nb_history_keep(&now->normal_history, &old->normal_history, from, now->count);
  nb_history_keep(&now->shear_history, &old->shear_history, from, now->count);
  nb_history_keep(&now->slip_sum, &old->slip_sum, from, now->count);
}

/* Sets the sum of the radii, M* and R* of contact c. Fixed particles and walls have infinite mass, and walls an
 * infinite radius, which is left out of the sum. M* is finite because at least one particle of a listed pair is
 * free. */
static void find_constants(struct nb_contacts *contacts, size_t c, const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const int a = contacts->a[c], b = contacts->b[c];
  const bool wall = model->material_pairs[contacts->material_pair[c]].wall;
  const double radius = particles->radius[a];
  contacts->kept[NB_RADIUS_SUM][c] = radius + (wall ? 0 : particles->radius[b]);
  if (contacts->kept[NB_MASS])
    contacts->kept[NB_MASS][c] = nb_reduced_mass(particles, a, wall ? -1 : b);
  if (contacts->kept[NB_REDUCED])
    contacts->kept[NB_REDUCED][c] = wall ? radius : nb_reduced_radius(radius, particles->radius[b]);
}

/* Selects the nearest image of the second particle: the cell is so wide that no other image comes within the skin. */
static void find_images(struct nb_contacts *contacts, const struct nb_model *model) {
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  const struct nb_vec *x = model->particles.position;
  for (size_t c = 0; c < contacts->count; c++)
    contacts->image[c] = nb_wrap_image(&wrap, vec_sub(x[contacts->b[c]], x[contacts->a[c]]));
}

/* Creates all arrays except those of enter_pairs. */
static void create_arrays(struct nb_contacts *contacts, const struct nb_model *model) {
  const size_t n = contacts->count;
  struct nb_owner *owner = &contacts->owner;
  contacts->force = nb_own(owner, n + 1, sizeof *contacts->force); /* one more, because nb_lanes reads four numbers */
  if (model->cell)
    contacts->image = nb_own(owner, n, sizeof *contacts->image);
  if (model->vertices.any)
    contacts->suppressed = nb_own(owner, n, sizeof(int));
  for (int f = 0; f < NB_FIELDS; f++)
    if (model->plan.kept & NB_BIT(f))
      contacts->kept[f] = nb_own(owner, n, sizeof(double));
  contacts->normal_history = nb_history_create(owner, model->plan.history.normal, n);
  contacts->shear_history = nb_history_create(owner, model->plan.history.shear, n);
  contacts->slip_sum = nb_history_create(owner, model->plan.history.slip_sum, n);
}

/* Sets contact[p] to the index of the contact of pair p. Contacts are grouped by material pair; within a group they
 * keep the order of `pairs`. False: out of memory. */
static bool number_contacts(int contact[], const struct nb_neighbour_pairs *pairs, const struct nb_model *model) {
  int *next = nb_array(model->material_pair_count + 1, sizeof *next);
  if (!next)
    return false;
  for (size_t p = 0; p < pairs->count; p++)
    next[pairs->list[p].material_pair + 1]++;
  for (size_t k = 0; k < model->material_pair_count; k++)
    next[k + 1] += next[k];
  for (size_t p = 0; p < pairs->count; p++)
    contact[p] = next[pairs->list[p].material_pair]++;
  free(next);
  return true;
}

/* Begins the new list: sets the particles and the material pair of each contact, and contact[p] as number_contacts
 * does. False: out of memory, also if `contact` is NULL. */
static bool enter_pairs(struct nb_contacts *contacts, const struct nb_model *model,
                        const struct nb_neighbour_pairs *pairs, int contact[]) {
  const size_t n = pairs->count;
  struct nb_owner *owner = &contacts->owner;
  *contacts = (struct nb_contacts){.count = n};
  contacts->a = nb_own(owner, n, sizeof(int)), contacts->b = nb_own(owner, n, sizeof(int));
  contacts->material_pair = nb_own(owner, n, sizeof(int));
  if (owner->failed || !contact || !number_contacts(contact, pairs, model))
    return false;
  for (size_t p = 0; p < n; p++) {
    const struct nb_neighbour_pair *pair = &pairs->list[p];
    const int c = contact[p];
    contacts->a[c] = pair->a, contacts->b[c] = pair->b, contacts->material_pair[c] = pair->material_pair;
    contacts->wall_from += !model->material_pairs[pair->material_pair].wall;
  }
  return true;
}

/* Sets the constants and the images of the contacts, after their arrays have been created. */
static void set_constants(struct nb_contacts *contacts, const struct nb_model *model) {
  for (size_t c = 0; c < contacts->count; c++)
    find_constants(contacts, c, model);
  if (model->cell)
    find_images(contacts, model);
}

/* Writes the arrays of a history to `list`. Returns the length of the list. */
static size_t list_history(void *list[], const struct nb_history *history) {
  for (int m = 0; m < NB_HISTORY; m++)
    list[m] = history->field[m];
  list[NB_HISTORY] = history->rows;
  return NB_HISTORY + 1;
}

/* Frees the arrays of the old list, except those from which values are copied. */
static void free_unneeded(struct nb_contacts *old, const struct nb_model *model) {
  void *needed[NB_FIELDS + 2 + 3 * (NB_HISTORY + 1)];
  const unsigned fields = fields_that_stay(model);
  size_t n = 0;
  needed[n++] = old->suppressed;
  needed[n++] = model->search.keep_forces ? old->force : NULL;
  for (int f = 0; f < NB_FIELDS; f++)
    needed[n++] = fields & NB_BIT(f) ? old->kept[f] : NULL;
  n += list_history(needed + n, &old->normal_history);
  n += list_history(needed + n, &old->shear_history);
  n += list_history(needed + n, &old->slip_sum);
  nb_owner_keep(&old->owner, needed, n);
}

/* Makes the rest of the new list after enter_pairs. Frees pairs and old arrays as soon as they are not needed any more,
 * because a run needs the most memory here. `from`: memory for find_old. False: out of memory. */
static bool make_contacts(struct nb_contacts *now, struct nb_contacts *old, const struct nb_model *model,
                          struct nb_neighbour_pairs *pairs, int contact[], int from[]) {
  find_old(from, model, old, now);
  free_unneeded(old, model);
  if (!nb_incidence_fill(now, pairs, contact, model))
    return false;
  free(pairs->list);
  pairs->list = NULL;
  create_arrays(now, model);
  if (now->owner.failed)
    return false;
  set_constants(now, model);
  copy_histories(model, old, now, from);
  return true;
}

bool nb_contacts_renew(struct nb_model *model, struct nb_neighbour_pairs *pairs) {
  struct nb_contacts now;
  int *contact = nb_array(pairs->count, sizeof *contact), *from = nb_array(pairs->count, sizeof *from);
  const bool made = enter_pairs(&now, model, pairs, contact) && from &&
                    make_contacts(&now, &model->contacts, model, pairs, contact, from);
  free(contact), free(from);
  nb_owner_free(&model->contacts.owner);
  if (!made) {
    nb_owner_free(&now.owner);
    now = (struct nb_contacts){0};
    model->blocks.count = 0; /* the blocks belonged to the old list */
  }
  model->contacts = now;
  return made;
}

struct nb_tensor nb_contacts_virial(const struct nb_model *model) {
  struct nb_tensor sum = {0, 0, 0, 0};
  for (size_t c = 0; c < model->contacts.wall_from; c++)
    sum = tensor_sub(sum, tensor_outer(nb_contact_force(&model->contacts, c), nb_contacts_branch(model, c)));
  return sum;
}

long nb_contacts_find(const struct nb_model *model, int a, int b, bool wall) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, (size_t)a);
  for (const int *entry = range.first; entry < range.end; entry++) {
    const int c = *entry;
    if (nb_with_wall(model, c) != wall)
      continue;
    if (contacts->b[c] == b || (!wall && contacts->a[c] == b))
      return c;
  }
  return -1;
}
