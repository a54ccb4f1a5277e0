/* The work of what carries bodies along, for the energy balance.
 *
 *   K' + U' + losses = -sum over bodies of (F + m g).c + sum over contacts of f.(L H m)
 *
 *   F   sum of a body's contact forces, N        c     what carries it along, m/s (carry.h)
 *   f   force on the first body of a contact, N  L H m what a copy of the second is faster by in a cell, m/s (cell.h)
 *
 * K is that of the bodies' own velocities v: what carries them bears what forces do along c. So it works on bodies that a
 * boundary holds just as on free ones; and in a cell, without gravity, the sum is that of f.(L l) over contacts, -V sigma_ij L_ij
 * with sigma compression positive and l from centre to centre. Over the kick around t_N a body is carried by c_(N-1/2) for half the
 * step behind, and by c_(N+1/2) for half the step ahead.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "balance.h"
#include "core/carry.h"

bool nb_balance_carry_create(struct nb_balance *b, const struct nb_model *model) {
  return !model->carry || (b->along = nb_array(model->bodies.count, sizeof *b->along)) != NULL;
}

void nb_balance_carry(const struct nb_model *model, double behind, double ahead) {
  struct nb_balance *b = model->balance;
  const struct nb_cell *cell = model->cell;
  for (size_t i = 0; i < model->bodies.count && model->carry; i++)
    b->along[i] = vec_add(vec_scale(behind, model->bodies.carried[i]),
                          vec_scale(ahead, nb_carry_remembered(model->carry, i, model->bodies.position[i])));
  if (cell)
    b->parted = tensor_add(tensor_scale(behind, cell->parting),
                           tensor_scale(ahead, tensor_product(model->carry->rate[NB_CARRIER_CELL], cell->h)));
}

struct nb_vec nb_balance_carried(const struct nb_model *model, size_t slot) {
  return model->carry ? model->balance->along[slot] : vec(0, 0);
}

struct nb_vec nb_balance_parted(const struct nb_model *model, size_t c) {
  return model->cell ? tensor_times(model->balance->parted, model->contacts.image[c]) : vec(0, 0);
}

void nb_balance_carrying(struct nb_sum terms[], const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t k = 0; k < bodies->count && model->carry; k++) {
    const size_t i = (size_t)bodies->slot[k];
    struct nb_vec force = nb_force_on(model, i).force;
    if (bodies->inverse_mass[i] > 0)
      force = vec_add(force, nb_weight(model, i, model->balance->position[i]));
    nb_sum_add(&terms[NB_TERM_DRIVEN], -vec_dot(force, model->balance->along[i]));
  }
  for (size_t c = 0; c < model->contacts.count && model->cell; c++)
    nb_sum_add(&terms[NB_TERM_DRIVEN], vec_dot(model->contacts.force[c], nb_balance_parted(model, c)));
}
