/* The parts of the integration of motion that motion.c and velocity.c share. motion.c moves particles; velocity.c
 * computes velocities.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "affine.h"

static inline double nb_kick_time(const struct nb_model *model) { return (model->previous_step + model->step) / 2; }

/* The momentum that mass-proportional damping removes in a kick of the duration dt, as fractions of m v-, of m v+, and
 * of the impulse of the forces; v- and v+ are the velocities before and after the kick, m/s. */
struct nb_damping_losses {
  double old, new, impulse;
};

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

/* The losses of the next kick. In the kick around t_0, where a stage begins, the part before t_0 has the damping of the
 * previous stage; `before` is the fraction of the kick before t_0. */
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
static inline double nb_kick_fraction_before(const struct nb_model *model) {
  return model->previous_step / (model->previous_step + model->step);
}

struct nb_kick_factors {
  double keep, impulse;
};

static inline struct nb_kick_factors nb_kick_factors(const struct nb_model *model, double dt, double before) {
  const struct nb_damping_losses lost = nb_damping_losses(model, dt, before);
  return (struct nb_kick_factors){(1 - lost.old) / (1 + lost.new), (1 - lost.impulse) / (1 + lost.new)};
}

/* Sums the contact forces on a particle. Its entries are `seconds` contacts in which it is the second particle, then
 * `firsts` contacts in which it is the first one. The stored force acts on the contact's first particle; its opposite
 * acts on the second one. The moment of the shear force F_s is counterclockwise on both particles [CS79, The
 * force-displacement law]: `shear` is the sum of F_s, N. The moment is this sum times the radius. */
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
  const struct nb_vec travel = vec_sub(gravity->point, x);
  const double distance = vec_length(travel);
  return vec_scale(distance > 0 ? mass * gravity->acceleration / distance : 0, travel);
}
