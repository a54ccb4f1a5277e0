/* Springs that are there all at once: of two bodies of a boundary that let go of them, which overlap but were on no list.
 *
 * At t_N they have overlapped by alpha without a force; at t_(N+1) they push with F_n(alpha'). The force of the step is the mean of none
 * and that, so what is put in from outside is the mean of what the spring would have held at the two ends:
 *
 *   energy.changed += (U_n(alpha) + U_n(alpha'))/2
 *
 * Shear springs begin with nothing, and what they hold is work from the first step on.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "balance.h"

/* U_n of contact c at an overlap, of a law that remembers nothing yet. */
static double held_at(const struct nb_model *model, size_t c, double overlap) {
  const struct nb_pairing *pairing = &model->pairings[model->contacts.pairing[c]];
  const struct nb_pair values = nb_contacts_values(model, c, pairing->values);
  double memory[NB_MEMORY] = {0};
  if (!(overlap > 0) || !pairing->normal->stored)
    return 0;
  struct nb_normal n = pairing->normal->normal(values, overlap, 0, memory);
  n.overlap = overlap;
  return pairing->normal->stored(values, n, memory);
}

static double overlap_of(const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec *rim = model->bodies.rim;
  return rim[contacts->a[c]].x + rim[contacts->b[c]].x - vec_length(nb_contacts_branch(model, c));
}

enum nb_status nb_balance_entered(struct nb_model *model, struct nb_error *error) {
  struct nb_balance *b = model->balance;
  const struct nb_contacts *contacts = &model->contacts;
  if (!b->energies)
    return NB_OK;
  free(b->entered);
  b->entered_count = 0;
  b->entered = nb_array(contacts->count, sizeof *b->entered);
  if (!b->entered)
    return nb_error_memory(error);
  for (size_t c = 0; c < contacts->count; c++) {
    if (model->pairings[contacts->pairing[c]].wall || contacts->kept[NB_OVERLAP][c] > 0)
      continue;
    const double overlap = overlap_of(model, c);
    if (!(overlap > 0))
      continue;
    nb_sum_add(&b->terms[NB_TERM_CHANGED], held_at(model, c, overlap) / 2);
    b->entered[b->entered_count++] = (struct nb_entered){contacts->a[c], contacts->b[c]};
  }
  return NB_OK;
}

void nb_balance_entry_ends(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  for (size_t k = 0; k < b->entered_count; k++) {
    const long c = nb_contacts_find(model, b->entered[k].a, b->entered[k].b, false);
    if (c >= 0)
      nb_sum_add(&b->terms[NB_TERM_CHANGED], held_at(model, (size_t)c, model->contacts.kept[NB_OVERLAP][c]) / 2);
  }
  b->entered_count = 0;
}
