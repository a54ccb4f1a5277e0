/* The parts of the integration of motion that motion.c and velocity.c share. motion.c moves particles; velocity.c
 * computes velocities.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "affine.h"

/* Duration of the next kick, s: from the middle of the last step to the middle of the next one. */
static inline double nb_kick_time(const struct nb_model *model) { return (model->previous_step + model->step) / 2; }

/* In a kick, mass-proportional damping or CON1 removes the momentum old m v- + new m v+ + impulse J: v- and v+ are the
 * velocities before and after the kick, m/s, and J is the impulse of the forces, N s. */
struct nb_damping_losses {
  double old, new, impulse;
};

/* The losses with one damping in a kick of the duration dt, s. */
static inline struct nb_damping_losses nb_damping_losses_of(const struct nb_damping *damping, double dt) {
  const double g = damping->global, half = g * dt / 2;
  switch (damping->global_kind) {
  case NB_GLOBAL_MASS: /* C = alpha m, applied to the mean velocity [CS79 34] */
    return (struct nb_damping_losses){half, half, 0};
  case NB_GLOBAL_CON1_CS79: /* alpha dt/2 = 1 - CON1 */
    return (struct nb_damping_losses){1 - g, 1 - g, 0};
  case NB_GLOBAL_CON1_VELOCITY:
    return (struct nb_damping_losses){1 - g, 0, 0};
  case NB_GLOBAL_CON1_ALL:
    return (struct nb_damping_losses){1 - g, 0, 1 - g};
  case NB_GLOBAL_UNDAMPED:
    break;
  }
  return (struct nb_damping_losses){0, 0, 0};
}

/* The losses in a kick of the duration dt, of which the fraction `before` precedes t_N. If a stage begins at t_N, this
 * fraction has the damping of the previous stage. */
static inline struct nb_damping_losses nb_damping_losses(const struct nb_model *model, double dt, double before) {
  const struct nb_damping_losses now = nb_damping_losses_of(&model->damping, dt);
  if (model->stage_cycle > 0 || before == 0 ||
      (model->damping.global_kind == model->previous_damping.global_kind &&
       model->damping.global == model->previous_damping.global))
    return now;
  const struct nb_damping_losses was = nb_damping_losses_of(&model->previous_damping, dt);
  const double after = 1 - before;
  return (struct nb_damping_losses){before * was.old + after * now.old, before * was.new + after *now.new,
                                    before *was.impulse + after *now.impulse};
}
/* The fraction of the next kick that lies in the last step. */
static inline double nb_kick_fraction_before(const struct nb_model *model) {
  return model->previous_step / (model->previous_step + model->step);
}

/* The velocity after a kick of the duration dt by the force F is keep v- + impulse F dt/m. */
struct nb_kick_factors {
  double keep, impulse;
};

static inline struct nb_kick_factors nb_kick_factors(const struct nb_model *model, double dt, double before) {
  const struct nb_damping_losses lost = nb_damping_losses(model, dt, before);
  return (struct nb_kick_factors){(1 - lost.old) / (1 + lost.new), (1 - lost.impulse) / (1 + lost.new)};
}

/* Sums the contact forces on a particle. Its entries are `seconds` contacts in which it is the second particle, then
 * `firsts` contacts in which it is the first one. The stored force acts on the contact's first particle; its opposite
 * acts on the second one. The moment of a shear force is counterclockwise on both particles [CS79, The
 * force-displacement law]. So `shear` is the sum of the shear forces F_s + D_s, N, and the moment is this sum times the
 * radius. */
static inline NB_FORM void nb_contact_force_sum(struct nb_contact_force *sum, const struct nb_contact_force *force,
                                                const int *entry, int seconds, int firsts) {
  nb_lanes both = {0, 0, 0, 0};
  for (int k = 0; k < seconds; k++) { /* one instruction with AVX: x - x, shear + shear, y - y */
    const nb_lanes one = *(const nb_lanes *)(const void *)&force[entry[k]], less = both - one, more = both + one;
    both = __builtin_shufflevector(less, more, 0, 5, 2, 7);
  }
  for (int k = seconds; k < seconds + firsts; k++)
    both += *(const nb_lanes *)(const void *)&force[entry[k]];
  *sum = (struct nb_contact_force){both[0], both[1], both[2]};
}

static inline bool nb_has_gravity(struct nb_vec gravity) { return gravity.x != 0 || gravity.y != 0; }

/* The force of central gravity, mass times acceleration, N, towards the point; 0 at the point itself. */
static inline struct nb_vec nb_central_force(const struct nb_central *gravity, double mass, struct nb_vec x) {
  const struct nb_vec towards = vec_sub(gravity->point, x);
  const double distance = vec_length(towards);
  return vec_scale(distance > 0 ? mass * gravity->acceleration / distance : 0, towards);
}
