/* What straining a periodic cell does, for the energy balance.
 *
 *   K' + U' + losses = sum over contacts of f.(L l) = -V sigma_ij L_ij      sigma compression positive
 *
 *   f   force on the first body of a contact, N         l   from its centre to that of the copy it meets, m
 *
 * K is that of the bodies' own velocities v. Over the kick around t_N a contact is carried by L_(N-1/2) l_(N-1) for half the
 * step behind, and by L_(N+1/2) l_N for half the step ahead.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "balance.h"

bool nb_balance_cell_create(struct nb_balance *b, const struct nb_model *model) {
  return !model->cell || (b->along = nb_array(model->bodies.count, sizeof *b->along)) != NULL;
}

void nb_balance_carry(const struct nb_model *model, double behind, double ahead) {
  struct nb_balance *b = model->balance;
  const struct nb_cell *cell = model->cell;
  if (!cell)
    return;
  for (size_t i = 0; i < model->bodies.count; i++)
    b->along[i] = vec_add(vec_scale(behind, model->bodies.carried[i]),
                          vec_scale(ahead, nb_cell_carries(cell, model->bodies.position[i])));
  b->parted = tensor_add(tensor_scale(behind, cell->parting), tensor_scale(ahead, tensor_product(cell->rate, cell->h)));
}

struct nb_vec nb_balance_carried(const struct nb_model *model, size_t c) {
  const struct nb_balance *b = model->balance;
  const struct nb_contacts *contacts = &model->contacts;
  return vec_sub(vec_sub(b->along[contacts->a[c]], b->along[contacts->b[c]]),
                 tensor_times(b->parted, contacts->image[c]));
}
