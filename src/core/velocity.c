/* What bodies feel, and how they move now: their velocities at t_N, between two half steps.                   [CS79 31]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "motion.h"

struct nb_force nb_force_on(const struct nb_model *model, size_t slot) {
  const struct nb_contact_forces contact_forces = nb_contact_forces_of(model);
  struct nb_force sum =
      nb_sum_of(contact_forces, nb_contacts_of(&model->contacts.of, slot), contact_forces.total_shear != NULL);
  sum.moment *= model->particles.surface[slot].radius;
  return sum;
}

struct nb_vec nb_weight(const struct nb_model *model, size_t slot, struct nb_vec x) {
  const struct nb_vec weight = vec_scale(model->particles.mass[slot], model->gravity);
  return model->central.strength != 0 ? vec_add(weight, nb_pull(&model->central, model->particles.mass[slot], x))
                                      : weight;
}

/* With m g and what presses on a boundary: all that a free body feels. */
static struct nb_force all_forces(const struct nb_model *model, size_t slot, struct nb_force sum) {
  if (nb_pulls(model->gravity) || model->central.strength != 0)
    sum.force = vec_add(sum.force, nb_weight(model, slot, model->particles.position[slot]));
  if (model->particles.pressed)
    sum.force = vec_add(sum.force, model->particles.pressed[slot]);
  return sum;
}

struct nb_vec nb_force_left(const struct nb_model *model, size_t slot) {
  return all_forces(model, slot, nb_force_on(model, slot)).force;
}

struct nb_state nb_velocity_half(const struct nb_model *model, size_t slot) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_vec whole = particles->velocity[slot];
  return (struct nb_state){particles->imposed ? vec_sub(whole, particles->imposed[slot]) : whole,
                           particles->spin ? particles->spin[slot] : 0};
}

/* Its own velocity after a kick. What is fixed goes on as it goes: no force and no damping reaches it. */
static struct nb_state kicked(const struct nb_model *model, size_t slot, struct nb_factors f, double time) {
  const struct nb_particles *particles = &model->particles;
  struct nb_state own = nb_velocity_half(model, slot);
  if (particles->inverse_mass[slot] > 0) {
    const struct nb_force sum = all_forces(model, slot, nb_force_on(model, slot));
    const double linear = f.total_normal * time * particles->inverse_mass[slot];
    const double turning = f.total_normal * time * particles->inverse_inertia[slot];
    const double spin_kept = particles->inverse_inertia[slot] > 0 ? f.keep : 1;
    own = (struct nb_state){vec_add(vec_scale(f.keep, own.velocity), vec_scale(linear, sum.force)),
                            spin_kept * own.spin + turning * sum.moment};
  }
  if (model->affine)
    own.velocity = vec_add(own.velocity, nb_affine_left(model->affine, slot, particles->position[slot]));
  return own;
}

struct nb_state nb_velocity_now(const struct nb_model *model, size_t slot) {
  const struct nb_state before = nb_velocity_half(model, slot);
  const double dt = model->previous_step;
  if (!(dt > 0))
    return before; /* the start: a page's velocities are those of time 0 */
  const struct nb_state next = kicked(model, slot, nb_factors(model, dt, 1), dt);
  return (struct nb_state){vec_scale(0.5, vec_add(before.velocity, next.velocity)), (before.spin + next.spin) / 2};
}

struct nb_vec nb_imposed_now(const struct nb_model *model, size_t slot) {
  if (!model->affine)
    return vec(0, 0);
  const struct nb_vec ahead = nb_affine_remembered(model->affine, slot, model->particles.position[slot]);
  return vec_scale(0.5, vec_add(model->previous_step > 0 ? model->particles.imposed[slot] : ahead, ahead));
}

struct nb_vec nb_velocity_whole(const struct nb_model *model, size_t slot) {
  return vec_add(nb_velocity_now(model, slot).velocity, nb_imposed_now(model, slot));
}

/* v_N = (v- + v+)/2 with v+ = keep v- + push (F/m) dt: a force less is made up for by so much more of v-. */
void nb_motion_release(struct nb_model *model, size_t slot, struct nb_force ending) {
  struct nb_particles *particles = &model->particles;
  const double dt = model->previous_step;
  const struct nb_factors f = nb_factors(model, dt, 1);
  const double time = f.total_normal * dt / (1 + f.keep);
  particles->velocity[slot] =
      vec_add(particles->velocity[slot], vec_scale(time * particles->inverse_mass[slot], ending.force));
  if (particles->spin)
    particles->spin[slot] += time * particles->inverse_inertia[slot] * ending.moment;
}

/* The velocity behind with which a body has this one at t_N, by the forces that it has now. */
void nb_motion_begin(struct nb_model *model, size_t slot, struct nb_state now) {
  struct nb_particles *particles = &model->particles;
  const double dt = model->previous_step;
  const struct nb_vec v = nb_velocity_half(model, slot).velocity;
  const struct nb_factors f = nb_factors(model, dt, 1);
  const struct nb_state next = kicked(model, slot, f, dt); /* keep v + what else there is */
  const double spin_kept = particles->inverse_inertia[slot] > 0 ? f.keep : 1;
  const struct nb_vec rest = vec_sub(next.velocity, vec_scale(f.keep, v));
  const double turned = next.spin - spin_kept * (particles->spin ? particles->spin[slot] : 0);
  if (!(dt > 0))
    return;
  const struct nb_vec behind = vec_scale(1 / (1 + f.keep), vec_sub(vec_scale(2, now.velocity), rest));
  particles->velocity[slot] = particles->imposed ? vec_add(behind, particles->imposed[slot]) : behind;
  if (particles->spin)
    particles->spin[slot] = (2 * now.spin - turned) / (1 + spin_kept);
}

/* A kick by the forces at t_N makes v_(N+1/2) of v_(N-1/2). For it to make -v_(N-1/2), which leads back to x_(N-1), the velocity
 * behind must become -v_(N+1/2). At the start there is none behind: the velocities are those of time 0. */
void nb_motion_reverse(struct nb_model *model) {
  struct nb_particles *particles = &model->particles;
  const double time = nb_kick_time(model);
  for (size_t i = 0; i < particles->count; i++) {
    struct nb_state v = nb_velocity_half(model, i);
    if (model->previous_step > 0)
      v = kicked(model, i, nb_factors(model, time, nb_kick_before(model)), time);
    particles->velocity[i] = vec_scale(-1, v.velocity);
    if (particles->imposed)
      particles->velocity[i] = vec_add(particles->velocity[i], particles->imposed[i]);
    if (particles->spin)
      particles->spin[i] = -v.spin; /* the next motion makes the speed of the rim of it */
  }
}
