/* The terms of the two balances that belong to bodies: what a kick gives each of them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "balance.h"
#include "core/motion.h"

/* A kick that lasts `time`, of which `before` is damped as before the stage. */
struct kick {
  double time, before;
};

/* What global damping gives a body in one kick, against its motion. */
static struct nb_state damping_impulse(const struct nb_model *model, size_t i, struct nb_state was, struct nb_state is,
                                       struct nb_force force, struct kick kick) {
  const double m = model->bodies.mass[i], inertia = model->bodies.inertia[i];
  const struct nb_shares by = nb_shares(model, kick.time, kick.before);
  const struct nb_vec linear = vec_scale(m, vec_add(vec_scale(by.old, was.velocity), vec_scale(by.new, is.velocity)));
  return (struct nb_state){vec_scale(-1, vec_add(linear, vec_scale(by.pushed * kick.time, force.force))),
                           -(inertia * (by.old * was.spin + by.new *is.spin) + by.pushed * kick.time * force.moment)};
}

/* What stays in a body's own velocity of what carries it along (carry.h), m/s. */
static struct nb_vec left(const struct nb_model *model, size_t i) {
  return model->carry ? nb_carry_left(model->carry, i, model->balance->position[i]) : vec(0, 0);
}

/* What global damping takes in such a kick, with its mean velocity. */
static double damped(const struct nb_model *model, size_t i, struct nb_state was, struct nb_state mean,
                     struct nb_force force, struct kick kick) {
  const struct nb_vec after = vec_sub(vec_scale(2, mean.velocity), was.velocity);
  const struct nb_state is = {vec_sub(after, left(model, i)), 2 * mean.spin - was.spin};
  const struct nb_state taken = damping_impulse(model, i, was, is, force, kick);
  return -(vec_dot(taken.velocity, mean.velocity) + taken.spin * mean.spin);
}

/* What that, and stress on a boundary, give a body in such a kick. */
static double driven(const struct nb_model *model, size_t i, struct nb_vec mean, double time) {
  struct nb_vec impulse = vec_scale(model->bodies.mass[i], left(model, i));
  if (model->bodies.pressed)
    impulse = vec_add(impulse, vec_scale(time, model->bodies.pressed[i]));
  return vec_dot(impulse, mean);
}

/* Weight and stress on a boundary, N. */
static struct nb_vec outer_forces(const struct nb_model *model, size_t i) {
  const struct nb_vec weight = nb_weight(model, i, model->balance->position[i]);
  return model->bodies.pressed ? vec_add(weight, model->bodies.pressed[i]) : weight;
}

/* Bodies, in a kick that lasts `time` and of which `share` is counted, at the velocities of t_N. */
void nb_balance_bodies(struct nb_sum terms[], const struct nb_model *model, double time, double share) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct kick kick = {time, share < 1 ? 1 : nb_kick_before(model)};
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    const struct nb_state was = model->balance->before[i], now = model->balance->now[i];
    struct nb_force force = nb_force_on(model, i);
    if (!(bodies->inverse_mass[i] > 0)) {
      const double held = vec_dot(force.force, now.velocity) + force.moment * now.spin;
      nb_sum_add(&terms[NB_TERM_WALLS], -share * time * held);
      continue;
    }
    const struct nb_vec weight = nb_weight(model, i, model->balance->position[i]);
    force.force = vec_add(force.force, outer_forces(model, i));
    nb_sum_add(&terms[NB_TERM_GRAVITY],
               share * time * vec_dot(weight, now.velocity) + vec_dot(weight, nb_balance_carried(model, i)));
    if (model->carry)
      nb_sum_add(&terms[NB_TERM_DRIVEN], share * driven(model, i, now.velocity, time));
    nb_sum_add(&terms[NB_TERM_DAMPED], share * damped(model, i, was, now, force, kick));
  }
}

/* All forces on free bodies, at the mean of the velocities before and after the kick. */
void nb_balance_work(struct nb_sum *work, const struct nb_model *model, double time) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct kick kick = {time, nb_kick_before(model)};
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (!(bodies->inverse_mass[i] > 0))
      continue;
    const struct nb_state was = model->balance->before[i], is = nb_velocity_half(model, i);
    const struct nb_state mean = {vec_scale(0.5, vec_add(was.velocity, is.velocity)), (was.spin + is.spin) / 2};
    struct nb_force force = nb_force_on(model, i);
    force.force = vec_add(force.force, nb_weight(model, i, model->balance->position[i]));
    if (model->carry)
      nb_sum_add(work, driven(model, i, mean.velocity, time));
    nb_sum_add(work, time * (vec_dot(force.force, mean.velocity) + force.moment * mean.spin));
    if (model->bodies.pressed)
      force.force = vec_add(force.force, model->bodies.pressed[i]);
    nb_sum_add(work, -damped(model, i, was, mean, force, kick));
  }
}
