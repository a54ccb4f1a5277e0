/* What makes the two balances jump: `still`, `reverse`, `remove`, bodies that a boundary holds or lets go, and a state that a page starts from.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "balance.h"

/* Kinetic energy that is there or gone without a force does not count as work; what was read before is read after. */
void nb_balance_remove(struct nb_model *model, bool before) {
  struct nb_balance *b = model->balance;
  const double sign = before ? -1 : 1;
  b->kinetic += sign * nb_energy_kinetic_half(model);
  if (!b->energies)
    return;
  struct nb_sum behind[NB_TERMS] = {{0}};
  nb_balance_tail(behind, model);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&b->terms[t], -sign * behind[t].sum);
}

/* It is put in from outside. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before) {
  nb_balance_remove(model, before);
  if (model->balance->energies)
    nb_sum_add(&model->balance->terms[term], (before ? -1 : 1) * nb_energy_kinetic(model));
}

void nb_balance_removed(struct nb_model *model, size_t slot) {
  if (model->balance->energies)
    nb_sum_add(&model->balance->terms[NB_TERM_REMOVED], nb_energy_of_body(model, slot));
}

/* Pairs of bodies that are both held are about to leave the list, with what their springs hold. */
void nb_balance_dropped(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *inverse = model->bodies.inverse_mass;
  if (!model->balance->energies)
    return;
  for (size_t c = 0; c < contacts->count; c++)
    if (!model->pairings[contacts->pairing[c]].wall && inverse[contacts->a[c]] == 0 && inverse[contacts->b[c]] == 0)
      nb_sum_add(&model->balance->terms[NB_TERM_REMOVED], nb_energy_of_contact(model, c));
}

/* What is held has no kinetic energy in the account. */
void nb_balance_held(struct nb_model *model, size_t slot, bool held) {
  if (model->balance->energies)
    nb_sum_add(&model->balance->terms[NB_TERM_REMOVED], (held ? 1 : -1) * nb_energy_of_motion(model, slot));
}

/* The half of the last kick that lies behind t_N: it is no part of what comes. */
void nb_balance_since(struct nb_model *model) {
  struct nb_sum behind[NB_TERMS] = {{0}};
  nb_balance_tail(behind, model);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&model->balance->terms[t], -behind[t].sum);
}
