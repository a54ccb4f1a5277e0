/* The calculation cycle [CS79, The calculation cycle].
 *
 *   Motion     Newton's second law gives, from the forces at t_N, the velocities at t_(N+1/2) and the positions at t_(N+1);
 *              walls move as they are told.
 *   Contacts   If something has moved far enough, the pairs that are near are looked for again.
 *   Forces     The force-displacement laws give the forces at t_(N+1) from the positions, and what the velocities did since.
 *
 * Forces and positions of one cycle belong to the same time. Blocks of contacts, then bodies, are shared out to the threads
 * in fixed parts; every contact and every body is worked out by one of them alone, so their number changes no bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "loading/box.h"
#include "loading/drive.h"
#include "loading/servo.h"
#include "measure/energy.h"
#include "measure/since.h"
#include "measure/step.h"

static void forces_of_block(const struct nb_model *model, const struct nb_view *view) {
  const struct nb_pairing *pairing = view->pairing;
  for (int p = 0; p < pairing->pass_count; p++)
    pairing->passes[p].run(model, view);
}

static void forces_part(const struct nb_model *model, int part, int parts) {
  const size_t n = model->view_count;
  for (size_t v = n * (size_t)part / (size_t)parts; v < n * ((size_t)part + 1) / (size_t)parts; v++)
    forces_of_block(model, &model->views[v]);
}

void nb_forces(struct nb_model *model) {
  const int threads = model->busy;
  if (model->joint_count)
    nb_joints_settle(model);
  if (threads == 1)
    forces_part(model, 0, 1);
  else {
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int part = 0; part < threads; part++)
      forces_part(model, part, threads);
  }
  model->updates += model->contacts.count;
}

/* Answers how many bodies and walls have gone too far for the list of contacts. */
static int motion(struct nb_model *model) {
  const int threads = model->busy;
  int out = nb_motion_walls(model);
  if (model->carry && !nb_carry_step(model) && model->drive)
    nb_ring_carry(model);
  if (model->cell)
    out += nb_cell_move(model);
  if (threads == 1)
    return out + nb_motion_part(model, 0, 1);
#pragma omp parallel for num_threads(threads) schedule(static, 1) reduction(+ : out)
  for (int part = 0; part < threads; part++)
    out += nb_motion_part(model, part, threads);
  return out;
}

static enum nb_status change(struct nb_model *model, bool *searched, struct nb_error *error) {
  if (model->balance)
    nb_balance_change(model, true);
  const enum nb_status status = nb_stage_change(model, searched, error);
  if (model->balance && !status)
    nb_balance_change(model, false);
  return status;
}

enum nb_status nb_cycle(struct nb_model *model, struct nb_error *error) {
  if (model->driven)
    nb_stage_drive(model);
  if (model->drive && nb_drive_before(model, error))
    return error->status;
  if (model->carry && model->stage && model->stage->servo.line)
    nb_servo_set(model);
  if (model->boxed)
    nb_box_drive(model);
  if (model->balance)
    nb_balance_before(model);
  const int out = motion(model);
  if (model->balance)
    nb_balance_kick(model);
  if (model->drive)
    nb_drive_after(model);
  model->cycle++;
  model->stage_cycle++;
  model->time = model->stage_time + (double)model->stage_cycle * model->step;
  model->previous_step = model->step;
  bool searched = false;
  if (model->changing && change(model, &searched, error))
    return error->status;
  const bool search = out && !searched;
  if (search ? nb_near(model, error) : nb_guard_cycle(model, error))
    return error->status;
  const bool look = out || searched || model->cycle % NB_WATCH_CYCLES == 0;
  if (look && nb_stable_watch(model, error))
    return error->status;
  if (look)
    nb_guard_digits(model);
  nb_forces(model);
  if (model->sure && !nb_sure_all(model) && nb_stable_watch(model, error))
    return error->status;
  if (model->deep.counts)
    nb_deep_look(model);
  if (model->fracc_before)
    nb_fracc_forces(model);
  if (model->since)
    nb_since_forces(model);
  if (model->balance)
    nb_balance_forces(model);
  return NB_OK;
}
