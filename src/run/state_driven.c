/* A saved state, as to what moves an assembly from outside: the cell, what carries bodies along, the boundary, rotation.
 *
 * Strain rates are those of the step behind: the row that the next stage begins with still sees them. What the page asks of
 * each carrier lasts until a stage asks for something else. What a servo has added ends with its stage. Where bodies were at the
 * last search, and which may cross the boundary before the next one, is looked for anew and changes nothing.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "state.h"

#include <stdlib.h>

/* ---- from a model ---- */

static bool take_carry(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_carry *carry = model->carry;
  const struct nb_bodies *bodies = &model->bodies;
  saved->centre = carry->centre;
  for (int c = 0; c < NB_CARRIERS; c++)
    saved->carriers[c] = (struct nb_saved_carrier){carry->asked[c], carry->rate[c], !(carry->remembered[c] > 0)};
  saved->carried = calloc(bodies->count + 1, sizeof *saved->carried);
  if (!saved->carried)
    return false;
  saved->carried_count = bodies->count;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    saved->carried[k] = (struct nb_saved_carried){(enum nb_carrier)carry->by[i], bodies->carried[i]};
  }
  return true;
}

static bool take_ring(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_drive *drive = model->drive;
  const struct nb_ring *ring = &drive->ring;
  saved->ring = (struct nb_saved_ring){.is = true,
                                       .held = ring->held,
                                       .pressing = model->bodies.pressed != NULL,
                                       .radius = ring->radius,
                                       .shape = ring->shape,
                                       .stress = drive->stress};
  saved->ring.members = calloc(ring->count + 1, sizeof *saved->ring.members);
  if (!saved->ring.members)
    return false;
  saved->ring.member_count = ring->count;
  for (size_t k = 0; k < ring->count; k++)
    saved->ring.members[k] = model->bodies.number[ring->member[k]] - 1;
  return true;
}

enum nb_status nb_saved_take_driven(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error) {
  saved->inward = model->inward;
  saved->turns = !model->drive || model->drive->turns;
  if (model->cell)
    saved->cell = (struct nb_saved_cell){true, model->cell->h, model->cell->parting};
  if ((model->carry && !take_carry(saved, model)) ||
      (model->drive && model->drive->ring.begun && !take_ring(saved, model)))
    return nb_error_memory(error);
  return NB_OK;
}

/* ---- into a model ---- */

static void put_carry(struct nb_model *model, const struct nb_saved *saved) {
  struct nb_carry *carry = model->carry;
  struct nb_bodies *bodies = &model->bodies;
  carry->centre = saved->centre;
  for (int c = 0; c < NB_CARRIERS; c++) {
    carry->asked[c] = saved->carriers[c].asked;
    carry->rate[c] = carry->level[c] = saved->carriers[c].rate;
    carry->remembered[c] = saved->carriers[c].literal ? 0 : 1;
  }
  for (size_t k = 0; k < saved->carried_count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    nb_carry_by(carry, i, saved->carried[k].by);
    bodies->carried[i] = saved->carried[k].along;
    if (carry->by[i] == NB_CARRIER_BOUNDARY)
      bodies->inverse_mass[i] = bodies->inverse_inertia[i] = 0;
  }
}

static void put_ring(struct nb_model *model, const struct nb_saved_ring *saved) {
  struct nb_drive *drive = model->drive;
  struct nb_ring *ring = &drive->ring;
  ring->begun = true, ring->held = saved->held;
  ring->radius = saved->radius, ring->shape = saved->shape;
  ring->count = saved->member_count;
  for (size_t k = 0; k < ring->count; k++)
    ring->member[k] = model->bodies.slot[saved->members[k]];
  drive->stress = saved->stress;
  model->bodies.pressed = saved->pressing ? drive->pressed : NULL;
  if (model->bodies.pressed)
    nb_ring_press(model);
}

enum nb_status nb_saved_put_driven(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error) {
  struct nb_bodies *bodies = &model->bodies;
  const bool fits = (saved->carried_count == 0 || saved->carried_count == bodies->count) &&
                    saved->cell.is == (model->cell != NULL) && (model->carry || saved->carried_count == 0) &&
                    (model->drive || (!saved->ring.is && saved->turns)) &&
                    !(saved->ring.pressing && !model->drive->pressed);
  if (!fits)
    return nb_error_set(error, NB_BAD_USE, "the state has a cell or a boundary otherwise than the page");
  model->inward = saved->inward;
  if (saved->cell.is)
    model->cell->h = saved->cell.h, model->cell->parting = saved->cell.parting;
  if (saved->carried_count > 0)
    put_carry(model, saved);
  if (saved->ring.is)
    put_ring(model, &saved->ring);
  if (model->drive)
    model->drive->turns = saved->turns;
  for (size_t i = 0; i < bodies->count && !saved->turns; i++)
    bodies->inverse_inertia[i] = 0;
  return NB_OK;
}
