/* The contacts of each particle, in the order of force summation.
 *
 * A particle sums its contacts in the order of the partners' numbers, walls last. The contacts in which it is the
 * second particle come first, because in them the partner has the smaller number.
 *
 * The sums of different particles are independent, so the particles may have any order. The particles of a batch, up to
 * NB_BATCH_SIZE consecutive slots, are sorted into groups. All particles of a group have the same number of contacts in
 * which they are the second particle, and the same number in which they are the first. The loops over a group have
 * constant lengths, which the processor predicts. Without groups, wrong predictions of the ends of loops took two
 * fifths of the time of the motion of 70 000 particles (docs/PERFORMANCE.md).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

/* The sort treats all numbers of contacts above MOST as MOST. A group still begins wherever one of the numbers
 * changes. */
enum { MOST = 15, PLACES = (MOST + 1) * (MOST + 1) };

static bool with_wall(const struct nb_model *model, const struct nb_neighbour_pair *pair) {
  return model->material_pairs[pair->material_pair].wall;
}

/* Counts the entries of each slot: in `middle` those as the second particle, in `end` those as the first one. */
static void count_entries(struct nb_incidence *of, const struct nb_neighbour_pairs *pairs,
                          const struct nb_model *model) {
  for (size_t p = 0; p < pairs->count; p++) {
    of->end[pairs->list[p].a]++;
    if (!with_wall(model, &pairs->list[p]))
      of->middle[pairs->list[p].b]++;
  }
}

/* The place of a slot in the sort. */
static int place(const struct nb_incidence *of, size_t slot) {
  const int seconds = of->middle[slot], firsts = of->end[slot];
  return (seconds < MOST ? seconds : MOST) * (MOST + 1) + (firsts < MOST ? firsts : MOST);
}

/* Sorts the slots of a batch by the numbers of entries. */
static void sort_batch(struct nb_incidence *of, size_t from, size_t to) {
  size_t next[PLACES + 1] = {0};
  for (size_t i = from; i < to; i++)
    next[place(of, i) + 1]++;
  for (size_t k = 1; k <= PLACES; k++)
    next[k] += next[k - 1];
  for (size_t i = from; i < to; i++)
    of->order[from + next[place(of, i)]++] = (int)i;
}

/* True if position k of the order begins a group. */
static bool group_begins(const struct nb_incidence *of, size_t k) {
  if (k % of->batch_size == 0)
    return true;
  const int i = of->order[k], before = of->order[k - 1];
  return of->middle[i] != of->middle[before] || of->end[i] != of->end[before];
}

/* Divides the order into groups, and sets the first group of each batch. */
static void make_groups(struct nb_incidence *of, size_t particles) {
  int groups = 0;
  for (size_t k = 0; k < particles; k++) {
    if (k % of->batch_size == 0)
      of->batch[k / of->batch_size] = groups;
    if (group_begins(of, k))
      of->group[groups++] = (struct nb_incidence_group){0, of->middle[of->order[k]], of->end[of->order[k]]};
    of->group[groups - 1].particles++;
  }
  of->batch[of->batches] = groups;
}

/* Replaces the numbers in `middle` and `end`: by the index at which the entries of the slot as second particle begin,
 * and by the index at which its entries as first particle begin. */
static void place_entries(struct nb_incidence *of, size_t particles) {
  int at = 0;
  for (size_t k = 0; k < particles; k++) {
    const int i = of->order[k], seconds = of->middle[i], firsts = of->end[i];
    of->first[i] = of->middle[i] = at;
    of->end[i] = at + seconds;
    at += seconds + firsts;
  }
}

/* Writes the entries; contact[p] is the index of the contact of pair p, and the pairs are in the order of summation.
 * `middle` and `end` advance from the beginnings of their parts to the ends. */
static void enter_contacts(struct nb_incidence *of, const struct nb_neighbour_pairs *pairs, const int contact[],
                           const struct nb_model *model) {
  for (size_t p = 0; p < pairs->count; p++) {
    of->entry[of->end[pairs->list[p].a]++] = contact[p];
    if (!with_wall(model, &pairs->list[p]))
      of->entry[of->middle[pairs->list[p].b]++] = contact[p];
  }
}

bool nb_incidence_fill(struct nb_contacts *contacts, const struct nb_neighbour_pairs *pairs, const int contact[],
                       const struct nb_model *model) {
  struct nb_incidence *of = &contacts->incidence;
  struct nb_owner *owner = &contacts->owner;
  const size_t n = model->particles.count, share = n / nb_most_parts(&model->machine) + 1;
  of->batch_size = share < NB_BATCH_SIZE ? share : NB_BATCH_SIZE; /* few particles: about one batch for each part */
  of->batches = (n + of->batch_size - 1) / of->batch_size;
  of->first = nb_own(owner, n, sizeof(int)), of->middle = nb_own(owner, n, sizeof(int));
  of->end = nb_own(owner, n, sizeof(int)), of->order = nb_own(owner, n, sizeof(int));
  of->entry = nb_own(owner, 2 * pairs->count, sizeof(int)), of->batch = nb_own(owner, of->batches + 1, sizeof(int));
  if (owner->failed)
    return false;
  count_entries(of, pairs, model);
  for (size_t from = 0; from < n; from += of->batch_size)
    sort_batch(of, from, from + of->batch_size < n ? from + of->batch_size : n);
  size_t groups = 0;
  for (size_t k = 0; k < n; k++)
    groups += group_begins(of, k);
  of->group = nb_own(owner, groups, sizeof *of->group);
  if (owner->failed)
    return false;
  make_groups(of, n);
  place_entries(of, n);
  enter_contacts(of, pairs, contact, model);
  return true;
}
