/* The changes that a stage makes: at its beginning, or with `ramp` linearly until its last cycle.
 *
 * A stage of N cycles goes from t_0 to t_N. A ramp has covered the fraction
 *
 *   n/N          for properties of materials and pairs, in the forces at t_n
 *   n/N          for gravity, in the kick around t_n
 *   (n - 1/2)/N  for velocities of walls, over the step that ends at t_n: then the displacement of the wall is exact
 *
 * Without a ramp the change is made at t_0. The forces at t_0 have been computed with the old properties and laws; the
 * new properties and laws apply from t_1 on. The kick around t_0 lasts half the old step and half the new one, so its
 * gravity is the mean of the old and the new gravity, weighted with these times. The same holds for mass-proportional
 * damping (motion.h) and for a stress on a boundary (boundary.c). `zero velocities` is a start from rest: the next kick
 * lasts half a step, and dashpot forces are 0.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/configuration.h"
#include "measure/energy.h"
#include "measure/region.h"
#include "measure/step.h"
#include "plan.h"

/* The values at the beginning of a stage, from which ramps start, and what the stage still changes. */
struct nb_changes {
  bool changing, ramping_walls;     /* properties, laws or gravity change; velocities of walls ramp */
  struct nb_pair *properties_from;  /* properties at the beginning, one for each change */
  struct nb_velocities *walls_from; /* velocities at the beginning, one for each wall motion */
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

void nb_changes_store(struct nb_store *store, struct nb_model *model) {
  struct nb_changes *changes = model->changes;
  NB_STORE_INTEGERS(store, "changing", &changes->changing, 1);
  NB_STORE_INTEGERS(store, "ramping_walls", &changes->ramping_walls, 1);
  NB_STORE(store, "properties_from", changes->properties_from, model->stage->change_count);
  NB_STORE(store, "walls_from", changes->walls_from, model->stage->motion_count);
  NB_STORE(store, "gravity_from", &changes->gravity_from, 1);
  NB_STORE(store, "central_from", &changes->central_from, 1);
}

bool nb_stage_ramps_walls(const struct nb_model *model) { return model->changes->ramping_walls; }
bool nb_stage_changes(const struct nb_model *model) { return model->changes->changing; }
bool nb_stage_changes_contacts(const struct nb_model *model) {
  return model->changes->changing &&
         (model->stage->change_count > 0 || nb_laws_normal_changes(model) || nb_laws_shear_changes(model));
}

static struct nb_vec interpolated(struct nb_vec from, struct nb_vec to, double fraction) {
  return vec_add(from, vec_scale(fraction, vec_sub(to, from)));
}

/* Sets the velocities of all particles to zero, including fixed ones. */
static void stop_particles(struct nb_model *model) {
  struct nb_particles *particles = &model->particles;
  nb_balance_jump(model, NB_TERM_CHANGED, true); /* not needed again after the change: all energies are then 0 */
  for (size_t i = 0; i < particles->count; i++) {
    particles->velocity[i] = vec(0, 0);
    particles->surface_speed[i] = 0;
    if (particles->spin)
      particles->spin[i] = 0;
  }
  if (model->affine)
    nb_affine_clear(model);
  model->previous_step = 0; /* as at time 0: all increments are 0 */
  if (model->plan.dashpots)
    nb_forces(model);
}

/* Applies `reverse velocities` to the walls, before the stage sets their velocities. */
static void reverse_walls(struct nb_model *model) {
  for (size_t w = 0; w < model->walls.count; w++) {
    model->walls.velocity[w] = vec_scale(-1, model->walls.velocity[w]);
    model->walls.spin[w] *= -1;
  }
}

/* Applies `reverse velocities` to the particles, when the step of the stage is known. */
static void reverse_particles(struct nb_model *model) {
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  nb_motion_reverse(model);
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* ---- walls ---- */

static void set_wall_velocity(struct nb_walls *walls, const struct nb_wall_motion *to) {
  walls->velocity[to->wall] = vec(to->vx, to->vy);
  walls->spin[to->wall] = to->spin;
}

/* Sets the walls with ramps in the previous stage to exactly the velocities of its statements. */
static void finish_wall_ramps(struct nb_model *model) {
  if (!model->stage)
    return;
  for (size_t k = 0; k < model->stage->motion_count; k++) {
    const struct nb_wall_motion *to = &model->stage->motions[k];
    if (to->ramp)
      set_wall_velocity(&model->walls, to);
  }
}

/* Stops the walls of a box that followed a strain rate until this stage moves or removes one of them. The walls that
 * the stage moves are left to it. */
static void end_box_strain(struct nb_model *model, const struct nb_stage *stage) {
  const struct nb_scene *scene = model->scene;
  const size_t s = (size_t)(stage - scene->stages);
  if (s == 0 || !nb_box_strained_in(scene, s - 1) || nb_box_strained_in(scene, s))
    return;
  const int first = nb_box_first_wall(scene);
  for (int w = first; w < first + NB_BOX_SIDES; w++) {
    bool moved = false;
    for (size_t k = 0; k < stage->motion_count; k++)
      moved = moved || stage->motions[k].wall == w;
    if (!moved)
      model->walls.velocity[w] = vec(0, 0);
  }
}

static void begin_wall_motions(struct nb_model *model, const struct nb_stage *stage) {
  end_box_strain(model, stage);
  model->changes->ramping_walls = false;
  for (size_t k = 0; k < stage->motion_count; k++) {
    const struct nb_wall_motion *to = &stage->motions[k];
    model->changes->walls_from[k] =
        (struct nb_velocities){model->walls.velocity[to->wall], model->walls.spin[to->wall]};
    if (!to->ramp)
      set_wall_velocity(&model->walls, to);
    model->changes->ramping_walls = model->changes->ramping_walls || to->ramp;
  }
}

void nb_stage_set_wall_velocities(struct nb_model *model) {
  const struct nb_stage *stage = model->stage;
  const double fraction = ((double)model->stage_cycle + 0.5) / (double)stage->cycles;
  for (size_t k = 0; k < stage->motion_count; k++) {
    const struct nb_wall_motion *to = &stage->motions[k];
    const struct nb_velocities *from = &model->changes->walls_from[k];
    if (!to->ramp)
      continue;
    model->walls.velocity[to->wall] = interpolated(from->velocity, vec(to->vx, to->vy), fraction);
    model->walls.spin[to->wall] = from->spin + fraction * (to->spin - from->spin);
  }
}

/* ---- properties ---- */

/* Sets the properties that the stage changes. Ramps have covered `fraction` of their change. */
static void interpolate_properties(struct nb_model *model, double fraction) {
  for (size_t k = 0; k < model->stage->change_count; k++) {
    const struct nb_change *to = &model->stage->changes[k];
    nb_properties_change(&model->properties, to, model->changes->properties_from[k], to->ramp ? fraction : 1);
  }
}

/* Begins changes of properties. The single-contact step and the stable step of the stage are those at its beginning or
 * those at its end, whichever are smaller. *apart receives the smaller stable step of pairs that could collide later
 * (nb_stable_step_apart). */
static void begin_property_changes(struct nb_model *model, struct nb_stable *apart) {
  const struct nb_stage *stage = model->stage;
  for (size_t k = 0; k < stage->change_count; k++)
    model->changes->properties_from[k] = nb_properties_before(&model->properties, &stage->changes[k]);
  model->critical = model->stability->stable_step = apart->step = INFINITY;
  for (int end = 0; end < 2; end++) {
    interpolate_properties(model, end);
    model->critical = fmin(model->critical, nb_step_single_contact(model));
    model->stability->stable_step = fmin(model->stability->stable_step, nb_stable_step(model).step);
    const struct nb_stable now = nb_stable_step_apart(model);
    if (end == 0 || now.step < apart->step)
      *apart = now;
  }
  model->stability->stable_step = fmin(model->stability->stable_step, apart->step);
  interpolate_properties(model, 0);
}

/* ---- gravity ---- */

/* Sets the gravity when its ramp has covered `fraction` of the change. */
static void interpolate_gravity(struct nb_model *model, double fraction) {
  const struct nb_gravity *to = &model->stage->gravity;
  const struct nb_central *from = &model->changes->central_from;
  model->gravity =
      fraction < 1 ? interpolated(model->changes->gravity_from, vec(to->x, to->y), fraction) : vec(to->x, to->y);
  model->central.acceleration =
      fraction < 1 ? from->acceleration + fraction * (to->central - from->acceleration) : to->central;
  if (to->central != 0)
    model->central.point = vec(to->about_x, to->about_y);
}

/* True if the point of central gravity moves. Neither the kick around t_0 nor a ramp could then use the mean of the two
 * accelerations, which have different directions. */
static bool central_point_moves(const struct nb_central *from, const struct nb_gravity *to) {
  return from->acceleration != 0 && to->central != 0 && (from->point.x != to->about_x || from->point.y != to->about_y);
}

/* Begins a change of gravity. The kick around t_0 lasts previous_step/2 before t_0 and step/2 after t_0. */
static enum nb_status begin_gravity_change(struct nb_model *model, struct nb_error *error) {
  const struct nb_gravity *to = &model->stage->gravity;
  const struct nb_central *central = &model->central;
  model->changes->gravity_from = model->gravity;
  model->changes->central_from = *central;
  if (to->line && central_point_moves(central, to))
    return nb_error_set(error, NB_BAD_USE,
                        "line %d: the point of central gravity moves from (%g, %g) to (%g, %g)%s. Expected the "
                        "same point, or a stage in between with `gravity` and two zeros",
                        to->line, central->point.x, central->point.y, to->about_x, to->about_y,
                        model->scene->unitless ? "" : " m");
  if (!to->line || to->ramp)
    return NB_OK;
  const double before = model->previous_step, after = model->step;
  interpolate_gravity(model, after / (before + after));
  model->gravity = vec_scale(1 / (before + after), vec_add(vec_scale(before, model->changes->gravity_from),
                                                           vec_scale(after, vec(to->x, to->y))));
  return NB_OK;
}

/* ---- the stage ---- */

/* Removes particles and walls, and resets measures. Stops the particles for `zero velocities`. Reverses the walls for
 * `reverse velocities`; begin_loading reverses the particles. */
static enum nb_status begin_assembly(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  const int index = (int)(stage - model->scene->stages);
  if (nb_remove(model, stage, error))
    return error->status;
  finish_wall_ramps(model);
  model->stage = stage;
  if (nb_regions_stage(model, index, error))
    return error->status;
  if (model->configuration && !nb_configuration_begin(model, index))
    return nb_error_memory(error);
  if (stage->zero_velocities)
    stop_particles(model);
  if (stage->reverse_velocities)
    reverse_walls(model);
  return NB_OK;
}

/* Begins the loading of the stage: gravity, imposed motion (also of cell and box), rotation, boundary, servo. Then
 * reverses the velocities of the particles if the stage asks for this. Called when the step is known. */
static enum nb_status begin_loading(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  if (begin_gravity_change(model, error))
    return error->status;
  if (model->affine)
    nb_affine_begin(model, stage);
  if (stage->rotation_line)
    nb_rotation_begin(model, stage->rotation == NB_ROTATION_ON);
  if (model->boundary && nb_boundary_begin(model, stage, error))
    return error->status;
  if (stage->servo.line)
    nb_servo_begin(model);
  if (stage->reverse_velocities)
    reverse_particles(model);
  return NB_OK;
}

/* The stable step depends on the listed pairs, and these on the time of the last search. A run that continues from a
 * state begins with a search. This search gives an uninterrupted run the same step. */
static enum nb_status search_for_step(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  const bool listed = model->search.last_cycle == model->cycle;
  return listed || stage->step.kind != NB_STEP_STABLE ? NB_OK : nb_neighbours_search_again(model, error);
}

enum nb_status nb_stage_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  model->previous_damping = model->damping;
  model->stage_time = model->time;
  model->stage_cycle = 0;
  if (begin_assembly(model, stage, error) || search_for_step(model, stage, error))
    return error->status;
  model->damping = stage->damping;
  model->next_laws = nb_laws_of(stage, model->laws);
  model->properties.pieces = model->next_laws.pieces;
  struct nb_stable apart;
  begin_wall_motions(model, stage), begin_property_changes(model, &apart);
  if (nb_step_set(model, &stage->step, error) || begin_loading(model, stage, error))
    return error->status;
  model->changes->changing = stage->change_count > 0 || stage->gravity.line > 0 || nb_laws_normal_changes(model) ||
                             nb_laws_shear_changes(model);
  model->stability->allow_unstable = model->scene->allow_unstable || stage->allow_unstable;
  nb_hooks_plan(model);
  return nb_stability_begin(model, &apart, error);
}

/* Clears the shear history of contacts whose material pair has lost its friction. */
static void clear_shear_history(struct nb_model *model) {
  for (size_t c = 0; c < model->contacts.count; c++)
    if (!model->material_pairs[model->contacts.material_pair[c]].shear)
      nb_history_forget(&model->contacts.shear_history, c);
}

/* Makes a new plan. A search then creates the arrays that the plan needs and copies the contact histories. */
static enum nb_status plan_again(struct nb_model *model, struct nb_error *error) {
  if (nb_plan(model, error))
    return error->status;
  clear_shear_history(model);
  return nb_neighbours_search(model, error);
}

/* Sets properties and laws when ramps have covered `fraction` of their changes. True: the contacts need another
 * plan. */
static bool change_properties(struct nb_model *model, double fraction) {
  const bool laws = nb_laws_normal_changes(model) || nb_laws_shear_changes(model);
  if (model->stage->change_count > 0 || laws) {
    interpolate_properties(model, fraction);
    nb_properties_apply(model);
    nb_laws_change(model);
  }
  return laws || ((model->stage_cycle == 1 || model->stage->change_count > 0) && !nb_plan_is_current(model));
}

enum nb_status nb_stage_change(struct nb_model *model, struct nb_error *error) {
  const struct nb_stage *stage = model->stage;
  const double fraction = (double)model->stage_cycle / (double)stage->cycles;
  const bool begins = model->stage_cycle == 1;
  bool ramps = stage->gravity.ramp;
  if (stage->gravity.line)
    interpolate_gravity(model, stage->gravity.ramp ? fraction : 1);
  for (size_t k = 0; k < stage->change_count; k++)
    ramps = ramps || stage->changes[k].ramp;
  model->changes->changing = ramps && fraction < 1;
  if (begins && !nb_affine_moves(model)) /* this cycle was the last one with an affine motion */
    model->all_affine = false;
  const bool plan = change_properties(model, fraction);
  if (plan && plan_again(model, error))
    return error->status;
  if (plan || begins || !model->changes->changing) /* not in each cycle of a ramp */
    nb_hooks_plan(model);
  return NB_OK;
}
