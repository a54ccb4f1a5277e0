/* Bodies that are carried along.                                     [R89 4.5.2]
 *
 *   u = v + c,   c = L (x - x_0)                                                   [R89 4.41]
 *
 *   u    velocity of a body, m/s          v    its own part of it, which forces and damping change (motion.c)
 *   L    strain rate, 1/s                 x_0  the centre of the cell, of the boundary, or the origin of the page, m
 *
 * All bodies of a periodic cell have the cell's L (cell.c). Where there is none, the boundary's bodies have the boundary's, and no
 * v while it holds them (boundary.c); all others that are free have the continuum's. What is carried with v at rest stays so, as in
 * a continuum; v is damped as everything is. When L jumps at the begin of a stage, v stays what it was.
 *
 * R89 writes x' = x' + c_11 x + c_12 y [R89 4.43] and keeps the sum as the new velocity (`accumulated`): then c is added again in
 * every cycle, and is an acceleration L (x - x_0)/dt, under which what is at rest moves away as exp(sqrt(L/dt) t).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "loading.h"

static bool wanted(const struct nb_scene *scene) {
  bool carries = scene->cell.line || scene->circle.line;
  for (size_t s = 0; s < scene->stage_count; s++)
    carries = carries || scene->stages[s].circle.line || scene->stages[s].boundary.line ||
              scene->stages[s].continuum.line || scene->stages[s].box_line || scene->stages[s].servo.box;
  return carries;
}

enum nb_status nb_carry_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  struct nb_bodies *bodies = &model->bodies;
  if (!wanted(scene))
    return NB_OK;
  struct nb_carry *carry = model->carry = nb_own(&model->owner, 1, sizeof *carry);
  unsigned char *by = nb_own(&model->owner, bodies->count, sizeof *by);
  bodies->carried = nb_own(&model->owner, bodies->count, sizeof *bodies->carried);
  if (model->owner.failed)
    return nb_error_memory(error);
  carry->by = by;
  carry->free_before = true; /* not known */
  carry->centre = model->cell ? model->cell->centre : vec(scene->origin_x, scene->origin_y);
  for (int c = 0; c < NB_CARRIERS; c++)
    carry->remembered[c] = 1;
  for (size_t i = 0; i < bodies->count; i++)
    nb_carry_by(carry, i,
                model->cell                   ? NB_CARRIER_CELL
                : bodies->inverse_mass[i] > 0 ? NB_CARRIER_CONTINUUM
                                              : NB_CARRIER_NONE);
  return NB_OK;
}

/* In 1/s, with the step of this stage. */
static struct nb_tensor rate_of(const struct nb_model *model, const struct nb_strain_rate *strain) {
  return tensor_scale(strain->per_cycle ? 1 / model->step : 1, tensor(strain->xx, strain->xy, strain->yx, strain->yy));
}

void nb_carry_begin(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_carry *carry = model->carry;
  struct nb_strain_rate *asked = carry->asked, *cell = &asked[NB_CARRIER_CELL];
  if (stage->reverse)
    cell->xx *= -1, cell->xy *= -1, cell->yx *= -1, cell->yy *= -1;
  if (stage->cell_line)
    *cell = stage->cell;
  if (stage->box_line)
    asked[NB_CARRIER_BOX] = stage->box;
  else if (!nb_box_follows(model->scene, (size_t)(stage - model->scene->stages)))
    asked[NB_CARRIER_BOX] = (struct nb_strain_rate){.xx = 0};
  if (stage->boundary.line)
    asked[NB_CARRIER_BOUNDARY] = stage->boundary.strain;
  if (stage->continuum.line) {
    asked[NB_CARRIER_CONTINUUM] = stage->continuum.strain;
    carry->remembered[NB_CARRIER_CONTINUUM] = stage->continuum.literal ? 0 : 1;
  }
  for (int c = 0; c < NB_CARRIERS; c++)
    carry->rate[c] = carry->level[c] = rate_of(model, &asked[c]);
}

/* Whether one rate, and one way to remember it, stands for those of all that are carried. */
static bool alike(const struct nb_carry *carry, enum nb_carrier one) {
  for (int c = 0; c < NB_CARRIERS; c++)
    if (carry->carries[c] && (tensor_largest(tensor_sub(carry->rate[c], carry->rate[one])) != 0 ||
                              carry->remembered[c] != carry->remembered[one]))
      return false;
  return true;
}

bool nb_carry_step(struct nb_model *model) {
  struct nb_carry *carry = model->carry;
  const bool free = tensor_largest(carry->rate[NB_CARRIER_CONTINUUM]) > 0 || model->cell;
  carry->all = free || carry->free_before;
  carry->free_before = free;
  carry->alike = alike(carry, model->cell ? NB_CARRIER_CELL : NB_CARRIER_CONTINUUM);
  return carry->all;
}

void nb_carry_still(struct nb_model *model) {
  memset(model->bodies.carried, 0, model->bodies.count * sizeof *model->bodies.carried);
}

void nb_carry_drop(struct nb_model *model, size_t slot) {
  nb_carry_by(model->carry, slot, NB_CARRIER_NONE);
  model->bodies.carried[slot] = vec(0, 0);
}
