/* Forces on particles, and velocities at t_N, the time between two half steps.          [CS79 31]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "motion.h"

struct nb_force nb_force_on(const struct nb_model *model, size_t slot) {
  const struct nb_contact_range entries = nb_contact_range(&model->contacts.incidence, slot);
  struct nb_contact_force sum;
  nb_contact_force_sum(&sum, model->contacts.force, entries.first, (int)(entries.middle - entries.first),
                       (int)(entries.end - entries.middle));
  return (struct nb_force){vec(sum.x, sum.y), sum.shear * model->particles.radius[slot]};
}

struct nb_vec nb_weight(const struct nb_model *model, size_t slot, struct nb_vec x) {
  const struct nb_vec weight = vec_scale(model->particles.mass[slot], model->gravity);
  return model->central.acceleration != 0
             ? vec_add(weight, nb_central_force(&model->central, model->particles.mass[slot], x))
             : weight;
}

/* Returns `sum` plus the weight and the force of a stress on the boundary, if there are any. */
static struct nb_force all_forces(const struct nb_model *model, size_t slot, struct nb_force sum) {
  if (nb_has_gravity(model->gravity) || model->central.acceleration != 0)
    sum.force = vec_add(sum.force, nb_weight(model, slot, model->particles.position[slot]));
  if (model->particles.boundary_force)
    sum.force = vec_add(sum.force, model->particles.boundary_force[slot]);
  return sum;
}

struct nb_vec nb_unbalanced_force(const struct nb_model *model, size_t slot) {
  return all_forces(model, slot, nb_force_on(model, slot)).force;
}

struct nb_velocities nb_velocity_half(const struct nb_model *model, size_t slot) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_vec whole = particles->velocity[slot];
  return (struct nb_velocities){particles->imposed ? vec_sub(whole, particles->imposed[slot]) : whole,
                                particles->spin ? particles->spin[slot] : 0};
}

/* Velocities of a particle after a kick with the factors f and the duration `time`, s, without the affine motion. A
 * fixed particle keeps its velocities, because neither force nor damping acts on it. */
static struct nb_velocities kicked_velocities(const struct nb_model *model, size_t slot, struct nb_kick_factors f,
                                              double time) {
  const struct nb_particles *particles = &model->particles;
  struct nb_velocities own = nb_velocity_half(model, slot);
  if (particles->inverse_mass[slot] > 0) {
    const struct nb_force sum = all_forces(model, slot, nb_force_on(model, slot));
    const double linear = f.impulse * time * particles->inverse_mass[slot];
    const double angular = f.impulse * time * particles->inverse_inertia[slot];
    own = (struct nb_velocities){vec_add(vec_scale(f.keep, own.velocity), vec_scale(linear, sum.force)),
                                 f.keep * own.spin + angular * sum.moment};
  }
  if (model->affine)
    own.velocity = vec_add(own.velocity, nb_affine_accumulated(model->affine, slot, particles->position[slot]));
  return own;
}

struct nb_velocities nb_velocity_now(const struct nb_model *model, size_t slot) {
  const struct nb_velocities before = nb_velocity_half(model, slot);
  const double dt = model->previous_step;
  if (!(dt > 0))
    return before; /* at the start the stored velocities are those of the page, at time 0 */
  const struct nb_velocities next = kicked_velocities(model, slot, nb_kick_factors(model, dt, 1), dt);
  return (struct nb_velocities){vec_scale(0.5, vec_add(before.velocity, next.velocity)), (before.spin + next.spin) / 2};
}

struct nb_vec nb_imposed_now(const struct nb_model *model, size_t slot) {
  if (!model->affine)
    return vec(0, 0);
  const struct nb_vec ahead = nb_affine_separate(model->affine, slot, model->particles.position[slot]);
  return vec_scale(0.5, vec_add(model->previous_step > 0 ? model->particles.imposed[slot] : ahead, ahead));
}

struct nb_vec nb_velocity_total(const struct nb_model *model, size_t slot) {
  return vec_add(nb_velocity_now(model, slot).velocity, nb_imposed_now(model, slot));
}

/* Let v- and v+ be the velocities before and after the kick: v_N = (v- + v+)/2, and v+ = keep v- + impulse (F/m) dt
 * (motion.c). When the force F ceases, v_N stays the same if v- increases by impulse (F/m) dt/(1 + keep). */
void nb_motion_offset_force(struct nb_model *model, size_t slot, struct nb_force ending) {
  struct nb_particles *particles = &model->particles;
  const double dt = model->previous_step;
  const struct nb_kick_factors f = nb_kick_factors(model, dt, 1);
  const double time = f.impulse * dt / (1 + f.keep);
  particles->velocity[slot] =
      vec_add(particles->velocity[slot], vec_scale(time * particles->inverse_mass[slot], ending.force));
  if (particles->spin)
    particles->spin[slot] += time * particles->inverse_inertia[slot] * ending.moment;
}

/* Solves for the velocity at t_(N-1/2) from which the current forces give the velocity `now` at t_N. At the start, and
 * after `zero velocities`, the stored velocities are those at t_N, and there is nothing to solve. */
void nb_motion_set_velocity(struct nb_model *model, size_t slot, struct nb_velocities now) {
  struct nb_particles *particles = &model->particles;
  const double dt = model->previous_step;
  if (!(dt > 0))
    return;
  const struct nb_vec v = nb_velocity_half(model, slot).velocity;
  const struct nb_kick_factors f = nb_kick_factors(model, dt, 1);
  const struct nb_velocities next = kicked_velocities(model, slot, f, dt); /* keep v + the other terms */
  const struct nb_vec rest = vec_sub(next.velocity, vec_scale(f.keep, v));
  const double turned = next.spin - f.keep * (particles->spin ? particles->spin[slot] : 0);
  const struct nb_vec behind = vec_scale(1 / (1 + f.keep), vec_sub(vec_scale(2, now.velocity), rest));
  particles->velocity[slot] = particles->imposed ? vec_add(behind, particles->imposed[slot]) : behind;
  if (particles->spin)
    particles->spin[slot] = (2 * now.spin - turned) / (1 + f.keep);
}

/* A kick by the forces at t_N changes v_(N-1/2) to v_(N+1/2). After the reversal the kick must give -v_(N-1/2), which
 * leads back to x_(N-1). So the velocity before the kick must be -v_(N+1/2). At the start the velocities are those of
 * time 0, and only change their sign. */
void nb_motion_reverse(struct nb_model *model) {
  struct nb_particles *particles = &model->particles;
  const double time = nb_kick_time(model);
  for (size_t i = 0; i < particles->count; i++) {
    struct nb_velocities v = nb_velocity_half(model, i);
    if (model->previous_step > 0)
      v = kicked_velocities(model, i, nb_kick_factors(model, time, nb_kick_fraction_before(model)), time);
    particles->velocity[i] = vec_scale(-1, v.velocity);
    if (particles->imposed)
      particles->velocity[i] = vec_add(particles->velocity[i], particles->imposed[i]);
    if (particles->spin)
      particles->spin[i] = -v.spin; /* the next motion updates the surface speed */
  }
}
