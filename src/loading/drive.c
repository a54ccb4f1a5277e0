/* What stages do with an assembly's boundary, and with rotation.      [R89 6.4.1, 6.5.1]
 *
 * Bodies that a boundary holds have the boundary's strain rate (carry.c) and no velocity of their own: their mass counts as
 * infinite, they do not turn, and there is no force between two of them. With x at the step's begin their centres go as
 * x_(N+1) - x_0 = (1 + L dt)(x_N - x_0).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "drive.h"
#include "measure/energy.h"

static bool stage_drives(const struct nb_stage *stage) {
  return stage->circle.line || stage->boundary.line || stage->rotation_line;
}

static bool wanted(const struct nb_scene *scene) {
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
  if (!wanted(scene))
    return NB_OK;
  struct nb_drive *drive = model->drive = nb_own(&model->owner, 1, sizeof *drive);
  if (drive) {
    drive->turns = true;
    drive->pressed = presses(scene) ? nb_own(&model->owner, bodies->count, sizeof *drive->pressed) : NULL;
    drive->ring.member = nb_own(&model->owner, bodies->count, sizeof *drive->ring.member);
    drive->ring.rim = nb_own(&model->owner, bodies->count, sizeof *drive->ring.rim);
  }
  if (model->owner.failed)
    return nb_error_memory(error);
  if (scene->circle.line && scene->start.stages == 0) /* else it is as the state has it */
    nb_ring_begin(model, &scene->circle);
  return NB_OK;
}

/* ---- one body ---- */

static void set_spin(struct nb_bodies *bodies, size_t i, double spin) {
  if (bodies->spin)
    bodies->spin[i] = spin;
  bodies->rim[i].y = spin * bodies->rim[i].x;
}

void nb_drive_hold(struct nb_model *model, size_t i) {
  struct nb_bodies *bodies = &model->bodies;
  nb_carry_by(model->carry, i, NB_CARRIER_BOUNDARY);
  bodies->carried[i] = bodies->velocity[i] = nb_carried_at(model->carry, i, bodies->position[i]);
  bodies->inverse_mass[i] = bodies->inverse_inertia[i] = 0;
  set_spin(bodies, i, 0);
}

void nb_drive_let_go(struct nb_model *model, size_t i) {
  struct nb_bodies *bodies = &model->bodies;
  nb_carry_by(model->carry, i, NB_CARRIER_CONTINUUM);
  bodies->carried[i] = nb_carry_remembered(model->carry, i, bodies->position[i]);
  bodies->inverse_mass[i] = 1 / bodies->mass[i];
  bodies->inverse_inertia[i] = model->drive->turns ? 1 / bodies->inertia[i] : 0;
  nb_motion_begin(model, i, nb_velocity_half(model, i));
}

/* ---- a stage ---- */

/* All free bodies stop turning and stay so, or turn again. */
static void rotation_begin(struct nb_model *model, bool turns) {
  struct nb_bodies *bodies = &model->bodies;
  model->drive->turns = turns;
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  for (size_t i = 0; i < bodies->count; i++) {
    if (!(bodies->inverse_mass[i] > 0))
      continue;
    const struct nb_state now = nb_velocity_now(model, i);
    bodies->inverse_inertia[i] = turns ? 1 / bodies->inertia[i] : 0;
    if (turns)
      nb_motion_begin(model, i, now);
    else
      set_spin(bodies, i, 0);
  }
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* A stress begins or ends at t_0, and leaves the velocities of t_0 as they were. The half of the kick around t_0 that lies behind it
 * is without one that begins, and with one that ends. */
static void pressing(struct nb_model *model, bool on) {
  struct nb_drive *drive = model->drive;
  if (on)
    nb_ring_press(model);
  for (size_t i = 0; i < model->bodies.count && (on || model->bodies.pressed); i++)
    nb_motion_release(model, i, (struct nb_force){vec_scale(on ? -1 : 1, drive->pressed[i]), 0});
  model->bodies.pressed = on ? drive->pressed : NULL;
}

static void ring_begins(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_drive *drive = model->drive;
  const struct nb_boundary *to = &stage->boundary;
  pressing(model, false);
  if (stage->circle.line)
    nb_ring_begin(model, &stage->circle);
  if (!to->line)
    return;
  drive->stress = tensor(to->sxx, to->sxy, to->sxy, to->syy);
  if (to->control == NB_CONTROL_STRAIN && !drive->ring.held)
    nb_ring_hold(model);
  else if (to->control != NB_CONTROL_STRAIN)
    nb_ring_free(model, to->control == NB_CONTROL_NONE);
  if (to->control == NB_CONTROL_STRESS)
    pressing(model, true);
}

enum nb_status nb_drive_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  if (stage->rotation_line)
    rotation_begin(model, stage->rotation == NB_ROTATION_ON);
  if (!stage->circle.line && !stage->boundary.line)
    return NB_OK;
  nb_balance_remove(model, true);
  ring_begins(model, stage);
  const enum nb_status status = nb_drive_search(model, error);
  if (!status)
    nb_balance_remove(model, false);
  return status;
}

/* Pairs of bodies that are both held are about to leave the list, with what their springs hold. */
static void drop_held(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *inverse = model->bodies.inverse_mass;
  for (size_t c = 0; c < contacts->count; c++)
    if (!model->pairings[contacts->pairing[c]].wall && inverse[contacts->a[c]] == 0 && inverse[contacts->b[c]] == 0)
      nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_of_contact(model, c));
}

enum nb_status nb_drive_search(struct nb_model *model, struct nb_error *error) {
  if (model->terms)
    drop_held(model);
  model->search.keeping = true;
  const enum nb_status status = nb_near(model, error);
  model->search.keeping = false;
  return status ? status : nb_balance_entered(model, error);
}

/* ---- a cycle ---- */

enum nb_status nb_drive_before(struct nb_model *model, struct nb_error *error) {
  return model->drive->ring.held ? nb_ring_take_in(model, error) : NB_OK;
}

void nb_drive_after(struct nb_model *model) {
  struct nb_drive *drive = model->drive;
  struct nb_ring *ring = &drive->ring;
  if (ring->held) {
    const struct nb_tensor step = tensor_scale(model->step, model->carry->rate[NB_CARRIER_BOUNDARY]);
    ring->shape = tensor_add(ring->shape, tensor_product(step, ring->shape));
  }
  if (model->bodies.pressed)
    nb_ring_press(model);
}
