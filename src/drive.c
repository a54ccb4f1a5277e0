/* Bodies that are carried along.                                     [R89 4.5.2]
 *
 *   u = v + c,   c = L (x - x_0)                                                   [R89 4.41]
 *
 *   u    velocity of a body, m/s          v    its own part of it, which forces and damping change (motion.c)
 *   L    strain rate, 1/s                 x_0  the centre of the boundary, or the origin of the page, m
 *
 * The boundary's bodies have the boundary's L and no v: their mass counts as infinite, they do not turn, and there is no
 * force between two of them. With x at the step's begin their centres go as x_(N+1) - x_0 = (1 + L dt)(x_N - x_0).
 * All other bodies that are free have the continuum's L. What is carried with v at rest stays so, as in a continuum; v is
 * damped as everything is.
 *
 * R89 writes x' = x' + c_11 x + c_12 y [R89 4.43] and keeps the sum as the new velocity (`literal`): then c is added again in
 * every cycle, and is an acceleration L (x - x_0)/dt, under which what is at rest moves away as exp(sqrt(L/dt) t).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "drive.h"
#include "energy.h"
#include "servo.h"

static bool stage_drives(const struct nb_stage *stage) {
  return stage->circle.line || stage->boundary.line || stage->continuum.line || stage->rotation_line;
}

bool nb_drive_wanted(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (stage_drives(&scene->stages[s]))
      return true;
  return scene->circle.line > 0;
}

static bool presses(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].boundary.line && scene->stages[s].boundary.control == NB_CONTROL_STRESS)
      return true;
  return false;
}

enum nb_status nb_drive_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  const struct nb_bodies *bodies = &model->bodies;
  if (!nb_drive_wanted(scene))
    return NB_OK;
  struct nb_drive *drive = model->drive = calloc(1, sizeof *drive);
  if (drive) {
    *drive = (struct nb_drive){.centre = vec(scene->origin_x, scene->origin_y), .turns = true};
    drive->carrier = nb_array(bodies->count, sizeof *drive->carrier);
    drive->carried = nb_array(bodies->count, sizeof *drive->carried);
    drive->pressed = presses(scene) ? nb_array(bodies->count, sizeof *drive->pressed) : NULL;
    drive->ring.member = nb_array(bodies->count, sizeof *drive->ring.member);
    drive->ring.rim = nb_array(bodies->count, sizeof *drive->ring.rim);
  }
  if (!drive || !drive->carrier || !drive->carried || !drive->ring.member || !drive->ring.rim ||
      (presses(scene) && !drive->pressed))
    return nb_error_set(error, NB_BROKEN, "out of memory for what carries %zu bodies along", bodies->count);
  for (size_t i = 0; i < bodies->count; i++)
    drive->carrier[i] = bodies->inverse_mass[i] > 0 ? NB_CARRIER_CONTINUUM : NB_CARRIER_NONE;
  drive->remembered[NB_CARRIER_CONTINUUM] = drive->remembered[NB_CARRIER_BOUNDARY] = 1;
  if (scene->circle.line)
    nb_ring_begin(model, &scene->circle);
  return NB_OK;
}

void nb_drive_free(struct nb_drive *drive) {
  if (!drive)
    return;
  free(drive->carrier), free(drive->carried), free(drive->pressed);
  free(drive->ring.member), free(drive->ring.rim);
  free(drive);
}

/* ---- one body ---- */

static void set_spin(struct nb_bodies *bodies, size_t i, double spin) {
  if (bodies->spin)
    bodies->spin[i] = spin;
  bodies->rim[i].y = spin * bodies->rim[i].x;
}

void nb_drive_hold(struct nb_model *model, size_t i) {
  struct nb_drive *drive = model->drive;
  drive->carrier[i] = NB_CARRIER_BOUNDARY;
  drive->carried[i] = model->bodies.velocity[i] = nb_carried_at(drive, i, model->bodies.position[i]);
  model->bodies.inverse_mass[i] = model->bodies.inverse_inertia[i] = 0;
  set_spin(&model->bodies, i, 0);
}

void nb_drive_let_go(struct nb_model *model, size_t i) {
  struct nb_drive *drive = model->drive;
  struct nb_bodies *bodies = &model->bodies;
  drive->carrier[i] = NB_CARRIER_CONTINUUM;
  drive->carried[i] = vec_scale(drive->remembered[NB_CARRIER_CONTINUUM], nb_carried_at(drive, i, bodies->position[i]));
  bodies->inverse_mass[i] = 1 / bodies->mass[i];
  bodies->inverse_inertia[i] = drive->turns ? 1 / bodies->inertia[i] : 0;
}

void nb_drive_still(struct nb_model *model) {
  memset(model->drive->carried, 0, model->bodies.count * sizeof *model->drive->carried);
}

/* ---- a stage ---- */

/* In 1/s, with the step of this stage. */
static struct nb_tensor rate_of(const struct nb_model *model, const struct nb_strain_rate *strain) {
  return tensor_scale(strain->per_cycle ? 1 / model->step : 1, tensor(strain->xx, strain->xy, strain->yx, strain->yy));
}

static bool same(struct nb_tensor a, struct nb_tensor b) {
  return a.xx == b.xx && a.xy == b.xy && a.yx == b.yx && a.yy == b.yy;
}

/* Strain rates jump at t_0, and with them what carries every body along; its own velocity stays what it was. */
static void rates_begin(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_drive *drive = model->drive;
  struct nb_bodies *bodies = &model->bodies;
  const double remembered = drive->remembered[NB_CARRIER_CONTINUUM];
  if (stage->continuum.line) {
    drive->asked[NB_CARRIER_CONTINUUM] = stage->continuum.strain;
    drive->remembered[NB_CARRIER_CONTINUUM] = stage->continuum.literal ? 0 : 1;
  }
  if (stage->boundary.line)
    drive->asked[NB_CARRIER_BOUNDARY] = stage->boundary.strain;
  bool changed = remembered != drive->remembered[NB_CARRIER_CONTINUUM];
  for (int c = 0; c < NB_CARRIERS; c++)
    changed = changed || !same(drive->rate[c], rate_of(model, &drive->asked[c]));
  if (!changed)
    return;
  if (model->balance)
    nb_balance_jump(model, NB_TERM_DRIVEN, true);
  for (int c = 0; c < NB_CARRIERS; c++)
    drive->rate[c] = rate_of(model, &drive->asked[c]);
  for (size_t i = 0; i < bodies->count; i++) {
    const struct nb_vec own = vec_sub(bodies->velocity[i], drive->carried[i]);
    const struct nb_vec along = nb_carried_at(drive, i, bodies->position[i]);
    drive->carried[i] = vec_scale(drive->remembered[drive->carrier[i]], along);
    bodies->velocity[i] = vec_add(own, drive->carried[i]);
  }
  if (model->balance)
    nb_balance_jump(model, NB_TERM_DRIVEN, false);
}

/* All free bodies stop turning and stay so, or turn again. */
static void rotation_begin(struct nb_model *model, bool turns) {
  struct nb_bodies *bodies = &model->bodies;
  model->drive->turns = turns;
  if (model->balance)
    nb_balance_jump(model, NB_TERM_CHANGED, true);
  for (size_t i = 0; i < bodies->count; i++) {
    if (!(bodies->inverse_mass[i] > 0))
      continue;
    bodies->inverse_inertia[i] = turns ? 1 / bodies->inertia[i] : 0;
    if (!turns)
      set_spin(bodies, i, 0);
  }
  if (model->balance)
    nb_balance_jump(model, NB_TERM_CHANGED, false);
}

static void ring_begins(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_drive *drive = model->drive;
  const struct nb_boundary *to = &stage->boundary;
  if (stage->circle.line)
    nb_ring_begin(model, &stage->circle);
  if (!to->line)
    return;
  drive->pressing = to->control == NB_CONTROL_STRESS;
  drive->stress = tensor(to->sxx, to->sxy, to->sxy, to->syy);
  if (to->control == NB_CONTROL_STRAIN && !drive->ring.held)
    nb_ring_hold(model);
  else if (to->control != NB_CONTROL_STRAIN)
    nb_ring_free(model, to->control == NB_CONTROL_NONE);
  if (drive->pressing)
    nb_ring_press(model);
}

static enum nb_status begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  rates_begin(model, stage);
  if (stage->rotation_line)
    rotation_begin(model, stage->rotation == NB_ROTATION_ON);
  if (!stage->circle.line && !stage->boundary.line)
    return NB_OK;
  if (model->balance)
    nb_balance_remove(model, true);
  ring_begins(model, stage);
  const enum nb_status status = nb_drive_search(model, error);
  if (model->balance && !status)
    nb_balance_remove(model, false);
  return status;
}

enum nb_status nb_drive_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  const enum nb_status status = begin(model, stage, error);
  memcpy(model->drive->level, model->drive->rate, sizeof model->drive->level);
  if (!status && stage->servo.line)
    nb_servo_begin(model);
  return status;
}

enum nb_status nb_drive_search(struct nb_model *model, struct nb_error *error) {
  if (model->balance)
    nb_balance_dropped(model);
  model->keeping = true;
  const enum nb_status status = nb_near(model, error);
  model->keeping = false;
  return status;
}

/* ---- a cycle ---- */

enum nb_status nb_drive_before(struct nb_model *model, struct nb_error *error) {
  const enum nb_status status = model->drive->ring.held ? nb_ring_take_in(model, error) : NB_OK;
  if (!status && model->stage && model->stage->servo.line && model->drive->ring.held)
    nb_servo_set(model);
  return status;
}

void nb_drive_after(struct nb_model *model) {
  struct nb_drive *drive = model->drive;
  struct nb_ring *ring = &drive->ring;
  if (ring->held) {
    const struct nb_tensor step = tensor_scale(model->step, drive->rate[NB_CARRIER_BOUNDARY]);
    ring->shape = tensor_add(ring->shape, tensor_product(step, ring->shape));
  }
  if (drive->pressing)
    nb_ring_press(model);
}
