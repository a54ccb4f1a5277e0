/* How large a step may be.
 *
 *   t_c = 2 sqrt(m/k)                                                  [CS79, Motion]
 *
 * with the smallest mass that is free to move and the largest normal stiffness between materials of the scene. It is the
 * limit of one mass on one spring; a body between several contacts has less, so a page takes a fraction of it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

double nb_step_critical(const struct nb_model *model) {
  double mass = INFINITY, stiffness = 0;
  for (size_t i = 0; i < model->bodies.count; i++)
    if (model->bodies.inverse_mass[i] > 0 && model->bodies.mass[i] < mass)
      mass = model->bodies.mass[i];
  for (size_t p = 0; p < model->pairing_count; p++)
    if (model->pairings[p].values.kn > stiffness)
      stiffness = model->pairings[p].values.kn;
  return 2 * sqrt(mass / stiffness);
}

enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error) {
  model->step = step->kind == NB_STEP_CRITICAL ? step->value * model->critical : step->value;
  if (!(model->step > 0) || !isfinite(model->step))
    return nb_error_set(error, NB_BAD_USE,
                        "line %d: the step comes out as %g s: a fraction of critical needs a free mass and a stiffness",
                        step->line, model->step);
  return NB_OK;
}
