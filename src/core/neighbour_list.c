/* The list of pairs that may come to touch.                              [CS79; R89 4.3.1, TOL]
 *
 * All pairs closer than the skin are listed, touching or not. As long as no body and no wall is farther than half the skin
 * from where it was then, a pair that is not listed cannot touch. A scene in which nothing travels is searched once, when it
 * is made; one in which nothing is free to touch anything has an infinite skin and is never searched. A contact that was
 * listed before keeps its memory. Which pairs these are: neighbour_search.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "neighbours.h"

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

enum nb_status nb_near(struct nb_model *model, struct nb_error *error) {
  if (nb_guard_positions(model, error) || nb_walls_crossed(model, true, error) || nb_guard_motion(model, error))
    return error->status;
  struct nb_near_pairs pairs = {0};
  const bool searching = model->search.skin < INFINITY;
  if (model->cell && searching && nb_cell_wide(model, error))
    return error->status;
  model->search.pressed = model->search.squeezed = false;
  const bool found = !searching || (nb_near_find(&pairs, model) && pairs_sort(&pairs, model));
  const bool made = found && nb_contacts_renew(model, &pairs) && nb_joints_find(model);
  free(pairs.list);
  if (!made)
    return nb_error_memory(error);
  memcpy(model->bodies.searched, model->bodies.position, model->bodies.count * sizeof(struct nb_vec));
  nb_walls_searched(&model->walls);
  if (model->cell)
    nb_cell_searched(model->cell, model->search.skin);
  model->search.count += searching;
  model->search.made = model->cycle;
  if (model->search.squeezed && nb_guard_pairs(model, error))
    return error->status;
  return nb_blocks_cut(model, error);
}
