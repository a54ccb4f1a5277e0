/* What a step is a share of.
 *
 *   critical   t_c = 2 sqrt(m/k)                                                  [CS79, Motion]
 *              with the smallest mass that is free to move and the largest normal stiffness between materials of the
 *              scene: the limit of one mass on one spring; a body between several contacts has less
 *   safe       what is sure to be stable with the contacts and the damping of the stage's begin, see stable.c
 *   contact    pi sqrt(M/k_n), how long two bodies stay together that meet head-on without damping: half a swing of
 *              their reduced mass M = m_x m_y/(m_x + m_y) on the spring; of any two materials the lightest bodies, and
 *              of those pairs the one that parts first: the shortest contact there can be, whichever comes first
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

static const double pi = 3.14159265358979323846;

double nb_step_critical(const struct nb_model *model) {
  double mass = INFINITY, stiffness = 0;
  for (size_t i = 0; i < model->bodies.count; i++)
    if (model->bodies.inverse_mass[i] > 0 && model->bodies.mass[i] < mass)
      mass = model->bodies.mass[i];
  for (size_t p = 0; p < model->pairing_count; p++) {
    const double kn = nb_properties_pair(&model->properties, model->pairings[p].a, model->pairings[p].b).kn;
    stiffness = kn > stiffness ? kn : stiffness;
  }
  return 2 * sqrt(mass / stiffness);
}

void nb_step_lightest(const struct nb_model *model, const struct nb_pairing *pairing, int lightest[2]) {
  const struct nb_bodies *bodies = &model->bodies;
  lightest[0] = lightest[1] = -1;
  for (int side = 0; side < (pairing->wall ? 1 : 2); side++)
    for (size_t k = 0; k < bodies->count; k++) {
      const int i = bodies->slot[k], least = lightest[side];
      if (bodies->material[i] == (side ? pairing->b : pairing->a) && i != lightest[0] &&
          (least < 0 || bodies->inverse_mass[i] > bodies->inverse_mass[least]))
        lightest[side] = i;
    }
}

double nb_step_contact(const struct nb_model *model) {
  const double *inverse = model->bodies.inverse_mass;
  double square = 0; /* the largest k_n/M */
  for (size_t p = 0; p < model->pairing_count; p++) {
    const struct nb_pairing *pairing = &model->pairings[p];
    int pair[2];
    nb_step_lightest(model, pairing, pair);
    if (pair[0] < 0 || (!pairing->wall && pair[1] < 0))
      continue;
    const double kn = nb_properties_pair(&model->properties, pairing->a, pairing->b).kn;
    const double here = kn * (inverse[pair[0]] + (pairing->wall ? 0 : inverse[pair[1]]));
    square = here > square ? here : square;
  }
  return pi / sqrt(square);
}

enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error) {
  double unit = 1;
  switch (step->kind) {
  case NB_STEP_TIME:
    break;
  case NB_STEP_CRITICAL:
    unit = model->critical;
    break;
  case NB_STEP_SAFE:
    unit = model->safe;
    break;
  case NB_STEP_CONTACT:
    unit = nb_step_contact(model);
    break;
  }
  model->step = step->value * unit;
  if (!(model->step > 0) || !isfinite(model->step))
    return nb_error_set(error, NB_BAD_USE,
                        "line %d: the step comes out as %g s: a share of a step needs a free mass and a stiffness",
                        step->line, model->step);
  return NB_OK;
}
