/* What a stage changes: at its begin, or with `ramp` little by little, along a straight line to its last cycle.
 *
 * The stage goes from its t_0 to its t_N. A ramp is n/N of its way from the old value to the new one
 *
 *   material, pair   in the forces at t_n
 *   gravity          in the kick around t_n
 *   wall             (n - 1/2)/N: over the step that ends at t_n, so that the wall's way is exact
 *
 * What does not ramp jumps at t_0. The forces at t_0 have been worked out with the old properties and laws by then; the new ones
 * hold for those at t_1. Half of the kick around t_0 lies before it, so gravity is there the mean of the old and the new one, each
 * for the time it lasts; global damping likewise (motion.h), and a stress on a boundary (boundary.c). `zero velocities` is a start from rest: the next kick lasts half a step, and dashpots have nothing to damp.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/configuration.h"
#include "measure/energy.h"
#include "measure/region.h"
#include "measure/step.h"
#include "plan.h"

/* What the stage changes little by little: from where, and whether there is still something to change. */
struct nb_changes {
  bool changing, driven;           /* properties, laws or gravity; velocities of walls */
  struct nb_pair *properties_from; /* per change, wall motion, and of gravity: what it was when the stage began */
  struct nb_velocities *walls_from;
  struct nb_vec gravity_from;
  struct nb_central central_from;
};

bool nb_changes_create(struct nb_model *model) {
  struct nb_changes *changes = model->changes = nb_own(&model->owner, 1, sizeof *changes);
  size_t most = 0, motions = 0;
  for (size_t s = 0; s < model->scene->stage_count; s++) {
    const struct nb_stage *stage = &model->scene->stages[s];
    most = stage->change_count > most ? stage->change_count : most;
    motions = stage->motion_count > motions ? stage->motion_count : motions;
  }
  if (changes) {
    changes->properties_from = nb_own(&model->owner, most, sizeof *changes->properties_from);
    changes->walls_from = nb_own(&model->owner, motions, sizeof *changes->walls_from);
  }
  return !model->owner.failed;
}

bool nb_stage_ramps_walls(const struct nb_model *model) { return model->changes->driven; }
bool nb_stage_changes(const struct nb_model *model) { return model->changes->changing; }

static struct nb_vec between(struct nb_vec from, struct nb_vec to, double fraction) {
  return vec_add(from, vec_scale(fraction, vec_sub(to, from)));
}

/* Bodies stop, those that are fixed too. */
static void stop_particles(struct nb_model *model) {
  struct nb_particles *particles = &model->particles;
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  for (size_t i = 0; i < particles->count; i++) {
    particles->velocity[i] = vec(0, 0);
    particles->surface[i].speed = 0;
    if (particles->spin)
      particles->spin[i] = 0;
  }
  if (model->affine)
    nb_affine_clear(model);
  model->previous_step = 0; /* as at time 0: nothing has slipped and nothing approaches */
  if (model->plan.dashpots)
    nb_forces(model);
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* `reverse velocities`: walls before this stage moves them otherwise, */
static void turn_walls(struct nb_model *model) {
  for (size_t w = 0; w < model->walls.count; w++) {
    model->walls.velocity[w] = vec_scale(-1, model->walls.velocity[w]);
    model->walls.spin[w] *= -1;
  }
}

/* and bodies when its step is known. */
static void turn_particles(struct nb_model *model) {
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  nb_motion_reverse(model);
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* ---- walls ---- */

static void wall_goes(struct nb_walls *walls, const struct nb_wall_motion *to) {
  walls->velocity[to->wall] = vec(to->vx, to->vy);
  walls->spin[to->wall] = to->spin;
}

/* What the stage before has ramped ends at what its page said. */
static void walls_arrive(struct nb_model *model) {
  if (!model->stage)
    return;
  for (size_t k = 0; k < model->stage->motion_count; k++) {
    const struct nb_wall_motion *to = &model->stage->motions[k];
    if (to->ramp)
      wall_goes(&model->walls, to);
  }
}

static void walls_begin(struct nb_model *model, const struct nb_stage *stage) {
  model->changes->driven = false;
  for (size_t k = 0; k < stage->motion_count; k++) {
    const struct nb_wall_motion *to = &stage->motions[k];
    model->changes->walls_from[k] =
        (struct nb_velocities){model->walls.velocity[to->wall], model->walls.spin[to->wall]};
    if (!to->ramp)
      wall_goes(&model->walls, to);
    model->changes->driven = model->changes->driven || to->ramp;
  }
}

void nb_stage_drive(struct nb_model *model) {
  const struct nb_stage *stage = model->stage;
  const double fraction = ((double)model->stage_cycle + 0.5) / (double)stage->cycles;
  for (size_t k = 0; k < stage->motion_count; k++) {
    const struct nb_wall_motion *to = &stage->motions[k];
    const struct nb_velocities *from = &model->changes->walls_from[k];
    if (!to->ramp)
      continue;
    model->walls.velocity[to->wall] = between(from->velocity, vec(to->vx, to->vy), fraction);
    model->walls.spin[to->wall] = from->spin + fraction * (to->spin - from->spin);
  }
}

/* ---- properties ---- */

/* As they are when what ramps has gone `share` of its way. */
static void properties_go(struct nb_model *model, double fraction) {
  for (size_t k = 0; k < model->stage->change_count; k++) {
    const struct nb_change *to = &model->stage->changes[k];
    nb_properties_change(&model->properties, to, model->changes->properties_from[k], to->ramp ? fraction : 1);
  }
}

/* The critical step and the safe one must hold from the stage's begin to its end. */
static void properties_begin(struct nb_model *model, struct nb_stable *apart) {
  const struct nb_stage *stage = model->stage;
  for (size_t k = 0; k < stage->change_count; k++)
    model->changes->properties_from[k] = nb_properties_before(&model->properties, &stage->changes[k]);
  model->critical = model->stability->stable_step = apart->step = INFINITY;
  for (int end = 0; end < 2; end++) {
    properties_go(model, end);
    model->critical = fmin(model->critical, nb_step_single_contact(model));
    model->stability->stable_step = fmin(model->stability->stable_step, nb_stable_step(model).step);
    const struct nb_stable now = nb_stable_step_apart(model);
    if (end == 0 || now.step < apart->step)
      *apart = now;
  }
  model->stability->stable_step = fmin(model->stability->stable_step, apart->step);
  properties_go(model, 0);
}

/* ---- gravity ---- */

/* What it is when `share` of the way from what it was to what the page says has been gone. */
static void gravity_go(struct nb_model *model, double fraction) {
  const struct nb_gravity *to = &model->stage->gravity;
  const struct nb_central *from = &model->changes->central_from;
  model->gravity =
      fraction < 1 ? between(model->changes->gravity_from, vec(to->x, to->y), fraction) : vec(to->x, to->y);
  model->central.acceleration =
      fraction < 1 ? from->acceleration + fraction * (to->central - from->acceleration) : to->central;
  if (to->central != 0)
    model->central.point = vec(to->about_x, to->about_y);
}

/* Of the kick around the stage's t_0, previous_step/2 lies before it and step/2 after it. */
static void gravity_begin(struct nb_model *model) {
  const struct nb_gravity *to = &model->stage->gravity;
  model->changes->gravity_from = model->gravity;
  model->changes->central_from = model->central;
  if (!to->line || to->ramp)
    return;
  const double before = model->previous_step, after = model->step;
  gravity_go(model, after / (before + after));
  model->gravity = vec_scale(1 / (before + after), vec_add(vec_scale(before, model->changes->gravity_from),
                                                           vec_scale(after, vec(to->x, to->y))));
}

/* ---- the stage ---- */

/* What it takes out, where measures begin anew, and what turns round or stops. */
static enum nb_status begin_assembly(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  const int index = (int)(stage - model->scene->stages);
  if (stage->removal_count > 0 && nb_remove(model, stage, error))
    return error->status;
  walls_arrive(model);
  model->stage = stage;
  if (nb_regions_stage(model, index, error))
    return error->status;
  if (model->configuration && !nb_configuration_begin(model, index))
    return nb_error_memory(error);
  if (stage->zero_velocities)
    stop_particles(model);
  if (stage->reverse_velocities)
    turn_walls(model);
  return NB_OK;
}

/* What it does to boundary, cell and box, once its step is known. */
static enum nb_status begin_loading(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  gravity_begin(model);
  if (model->affine)
    nb_affine_begin(model, stage);
  if (model->boundary && nb_boundary_begin(model, stage, error))
    return error->status;
  if (stage->servo.line)
    nb_servo_begin(model);
  if (stage->reverse_velocities)
    turn_particles(model);
  return NB_OK;
}

enum nb_status nb_stage_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  model->damping_before = model->damping;
  model->stage_time = model->time;
  model->stage_cycle = 0;
  if (begin_assembly(model, stage, error))
    return error->status;
  model->damping = stage->damping;
  model->next = nb_laws_of(stage, model->laws);
  model->properties.pieces = model->next.pieces;
  struct nb_stable apart;
  walls_begin(model, stage), properties_begin(model, &apart);
  if (nb_step_set(model, &stage->step, error) || begin_loading(model, stage, error))
    return error->status;
  model->changes->changing = stage->change_count > 0 || stage->gravity.line > 0 || nb_laws_normal_changes(model) ||
                             nb_laws_shear_changes(model);
  model->stability->allow_unstable = model->scene->allow_unstable || stage->allow_unstable;
  nb_hooks_plan(model);
  return nb_stability_begin(model, &apart, error);
}

/* Contacts of a pairing that has lost its shear forget what they remembered of it. */
static void forget_shear(struct nb_model *model) {
  for (size_t c = 0; c < model->contacts.count; c++)
    if (!model->material_pairs[model->contacts.material_pair[c]].shear)
      nb_history_forget(&model->contacts.shear_history, c);
}

/* The search makes the arrays that a new plan wants, and takes over what laws remember. */
static enum nb_status plan_anew(struct nb_model *model, struct nb_error *error) {
  if (nb_plan(model, error))
    return error->status;
  forget_shear(model);
  return nb_neighbours_search(model, error);
}

enum nb_status nb_stage_change(struct nb_model *model, struct nb_error *error) {
  const struct nb_stage *stage = model->stage;
  const double fraction = (double)model->stage_cycle / (double)stage->cycles;
  bool ramps = stage->gravity.ramp;
  if (stage->gravity.line)
    gravity_go(model, stage->gravity.ramp ? fraction : 1);
  for (size_t k = 0; k < stage->change_count; k++)
    ramps = ramps || stage->changes[k].ramp;
  model->changes->changing = ramps && fraction < 1;
  const bool others = nb_laws_normal_changes(model) || nb_laws_shear_changes(model);
  if (stage->change_count == 0 && !others) {
    nb_hooks_plan(model);
    return NB_OK;
  }
  properties_go(model, fraction);
  for (size_t p = 0; p < model->material_pair_count; p++)
    model->material_pairs[p].values =
        nb_properties_pair(&model->properties, model->material_pairs[p].a, model->material_pairs[p].b);
  nb_laws_change(model);
  const enum nb_status status = others || !nb_plan_stands(model) ? plan_anew(model, error) : NB_OK;
  nb_hooks_plan(model);
  return status;
}
