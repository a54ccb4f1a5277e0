/* The list of contacts, built anew after each search, and the contacts of each particle.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <limits.h>
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

int nb_partner_rank(const struct nb_model *model, struct nb_neighbour_pair pair) {
  return model->material_pairs[pair.material_pair].wall ? INT_MAX / 2 + pair.b : model->particles.number[pair.b];
}

int nb_contacts_order(const struct nb_model *model, struct nb_neighbour_pair p, struct nb_neighbour_pair q) {
  const int *number = model->particles.number;
  const int difference[] = {p.material_pair - q.material_pair, number[p.a] - number[q.a],
                            nb_partner_rank(model, p) - nb_partner_rank(model, q)};
  return difference[0] ? difference[0] : difference[1] ? difference[1] : difference[2];
}

/* Copies the fields whose values of the last step the energy balance still needs, from contact o to contact c. */
static void copy_energy_fields(struct nb_contacts *now, size_t c, const struct nb_contacts *old, size_t o) {
  static const enum nb_field fields[] = {NB_OVERLAP, NB_SHEAR_BEFORE, NB_SHEAR_STIFFNESS_BEFORE};
  for (size_t f = 0; f < sizeof fields / sizeof *fields; f++)
    if (now->kept[fields[f]] && old->kept[fields[f]])
      now->kept[fields[f]][c] = old->kept[fields[f]][o];
}

/* Copies all fields except M*, from contact o to contact c. M* changes when a particle becomes part of a boundary,
 * because its mass is then infinite. */
static void copy_all_fields(struct nb_contacts *now, size_t c, const struct nb_contacts *old, size_t o) {
  now->force[c] = old->force[o];
  for (int f = 0; f < NB_FIELDS; f++)
    if (now->kept[f] && f != NB_MASS)
      now->kept[f][c] = old->kept[f][o];
}

/* The old and the new list have the same order, so one pass through both finds the pairs that stay. */
static void copy_histories(const struct nb_model *model, const struct nb_contacts *old, struct nb_contacts *now) {
  size_t o = 0;
  for (size_t c = 0; c < now->count; c++) {
    const struct nb_neighbour_pair here = {now->a[c], now->b[c], now->material_pair[c]};
    for (; o < old->count; o++) {
      const struct nb_neighbour_pair there = {old->a[o], old->b[o], old->material_pair[o]};
      const int order = nb_contacts_order(model, there, here);
      if (order > 0)
        break;
      if (order < 0)
        continue;
      if (now->suppressed && old->suppressed)
        now->suppressed[c] = old->suppressed[o];
      if (model->search.keep_forces)
        copy_all_fields(now, c, old, o);
      else if (model->plan.requested & NB_REQUEST_ENERGY)
        copy_energy_fields(now, c, old, o);
      nb_history_copy(&now->normal_history, c, &old->normal_history, o);
      nb_history_copy(&now->shear_history, c, &old->shear_history, o);
      nb_history_copy(&now->slip_sum, c, &old->slip_sum, o);
    }
  }
}

/* Sets M* and R* of contact c. Fixed particles and walls have infinite mass, and walls an infinite radius. M* is finite
 * because at least one particle of a listed pair is free. */
static void find_constants(struct nb_contacts *contacts, size_t c, const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const int a = contacts->a[c], b = contacts->b[c];
  const bool wall = model->material_pairs[contacts->material_pair[c]].wall;
  const double radius = particles->surface[a].radius;
  contacts->kept[NB_RADIUS_SUM][c] = radius + (wall ? 0 : particles->surface[b].radius);
  if (contacts->kept[NB_MASS])
    contacts->kept[NB_MASS][c] = 1 / (particles->inverse_mass[a] + (wall ? 0 : particles->inverse_mass[b]));
  if (contacts->kept[NB_REDUCED])
    contacts->kept[NB_REDUCED][c] = wall ? radius : nb_reduced_radius(radius, particles->surface[b].radius);
}

/* Selects the nearest image of the second particle: the cell is so wide that no other one comes within the skin. */
static void find_images(struct nb_contacts *contacts, const struct nb_model *model) {
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  const struct nb_vec *x = model->particles.position;
  for (size_t c = 0; c < contacts->count; c++)
    contacts->image[c] = nb_wrap_image(&wrap, vec_sub(x[contacts->b[c]], x[contacts->a[c]]));
}

static void create_arrays(struct nb_contacts *contacts, const struct nb_model *model) {
  const size_t n = contacts->count;
  struct nb_owner *owner = &contacts->owner;
  contacts->a = nb_own(owner, n, sizeof(int)), contacts->b = nb_own(owner, n, sizeof(int));
  contacts->material_pair = nb_own(owner, n, sizeof(int)), contacts->force = nb_own(owner, n, sizeof *contacts->force);
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
  contacts->incidence.first = nb_own(owner, model->particles.count + 1, sizeof(int));
  contacts->incidence.middle = nb_own(owner, model->particles.count + 1, sizeof(int));
  contacts->incidence.entry = nb_own(owner, 2 * n, sizeof(int));
}

/* Computes the contact index of each pair. Contacts are grouped by material pair; within a group they keep the order of
 * `pairs`. False: out of memory. */
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

/* Lists the contacts of each particle in the order of force summation: by the partners' numbers, walls last. Contacts
 * in which the particle is the second one come first, because their partners have smaller numbers. `pairs` is already
 * in this order. */
static void fill_incidence(struct nb_incidence *of, const struct nb_neighbour_pairs *pairs, const int contact[],
                           const struct nb_model *model) {
  for (size_t p = 0; p < pairs->count; p++) {
    of->first[pairs->list[p].a + 1]++;
    if (!model->material_pairs[pairs->list[p].material_pair].wall)
      of->first[pairs->list[p].b + 1]++;
  }
  for (size_t i = 0; i < model->particles.count; i++)
    of->first[i + 1] += of->first[i], of->middle[i] = of->first[i];
  for (size_t p = 0; p < pairs->count; p++)
    if (!model->material_pairs[pairs->list[p].material_pair].wall)
      of->entry[of->middle[pairs->list[p].b]++] = contact[p];
  for (size_t p = 0, at = 0; p < pairs->count; p++) {
    const int a = pairs->list[p].a;
    at = p > 0 && pairs->list[p - 1].a == a ? at + 1 : (size_t)of->middle[a];
    of->entry[at] = contact[p];
  }
}

static bool contacts_create(struct nb_contacts *contacts, const struct nb_model *model,
                            const struct nb_neighbour_pairs *pairs) {
  *contacts = (struct nb_contacts){.count = pairs->count};
  int *contact = nb_array(pairs->count, sizeof *contact);
  create_arrays(contacts, model);
  const bool made = contact && !contacts->owner.failed && number_contacts(contact, pairs, model);
  if (made)
    fill_incidence(&contacts->incidence, pairs, contact, model);
  for (size_t p = 0; p < pairs->count && made; p++) {
    const struct nb_neighbour_pair *pair = &pairs->list[p];
    const int c = contact[p];
    contacts->a[c] = pair->a, contacts->b[c] = pair->b, contacts->material_pair[c] = pair->material_pair;
    contacts->wall_from += !model->material_pairs[pair->material_pair].wall;
    find_constants(contacts, (size_t)c, model);
  }
  free(contact);
  if (made && model->cell)
    find_images(contacts, model);
  return made;
}

bool nb_contacts_renew(struct nb_model *model, const struct nb_neighbour_pairs *pairs) {
  struct nb_contacts now;
  const bool made = contacts_create(&now, model, pairs);
  if (made)
    copy_histories(model, &model->contacts, &now);
  nb_owner_free(made ? &model->contacts.owner : &now.owner);
  if (made)
    model->contacts = now;
  return made;
}

struct nb_vec nb_contacts_branch(const struct nb_model *model, size_t contact) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec *x = model->particles.position;
  const struct nb_vec branch = vec_sub(x[contacts->b[contact]], x[contacts->a[contact]]);
  return model->cell ? vec_add(branch, tensor_times(model->cell->h, contacts->image[contact])) : branch;
}

struct nb_tensor nb_contacts_virial(const struct nb_model *model) {
  struct nb_tensor sum = {0, 0, 0, 0};
  for (size_t c = 0; c < model->contacts.wall_from; c++)
    sum = tensor_sub(sum, tensor_outer(model->contacts.force[c], nb_contacts_branch(model, c)));
  return sum;
}

struct nb_pair nb_contact_constants(const struct nb_model *model, size_t contact, struct nb_pair values) {
  if (model->contacts.kept[NB_REDUCED])
    values.radius = model->contacts.kept[NB_REDUCED][contact];
  return values;
}

long nb_contacts_find(const struct nb_model *model, int a, int b, bool wall) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, (size_t)a);
  for (const int *entry = range.first; entry < range.end; entry++) {
    const int c = *entry;
    if (model->material_pairs[contacts->material_pair[c]].wall != wall)
      continue;
    if (contacts->b[c] == b || (!wall && contacts->a[c] == b))
      return c;
  }
  return -1;
}

double nb_overlap(const struct nb_model *model, size_t c) {
  const bool wall = model->material_pairs[model->contacts.material_pair[c]].wall;
  const struct nb_particles *particles = &model->particles;
  const int i = model->contacts.a[c], j = model->contacts.b[c];
  if (!wall)
    return particles->surface[i].radius + particles->surface[j].radius - vec_length(nb_contacts_branch(model, c));
  return particles->surface[i].radius - vec_length(nb_wall_separation(&model->walls, j, particles->position[i]));
}
