/* What the motion of bodies is made of: shared by motion.c, which moves them, and velocity.c, which says how they move.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MOTION_H
#define NB_MOTION_H

#include "affine.h"

static inline double nb_kick_time(const struct nb_model *model) { return (model->previous_step + model->step) / 2; }

/* What global damping takes in a kick of dt seconds: shares of m v-, of m v+ and of the forces' impulse. */
struct nb_shares {
  double old, new, pushed;
};

static inline struct nb_shares nb_shares_of(const struct nb_damping *damping, double dt) {
  const double g = damping->global, half = g * dt / 2;
  switch (damping->global_kind) {
  case NB_GLOBAL_ALPHA: /* C = alpha m on the mean velocity [CS79 34] */
    return (struct nb_shares){half, half, 0};
  case NB_GLOBAL_CON1_CS79: /* alpha dt/2 = 1 - CON1 */
    return (struct nb_shares){1 - g, 1 - g, 0};
  case NB_GLOBAL_CON1_VELOCITY:
    return (struct nb_shares){1 - g, 0, 0};
  case NB_GLOBAL_CON1_ALL:
    return (struct nb_shares){1 - g, 0, 1 - g};
  case NB_GLOBAL_UNDAMPED:
    break;
  }
  return (struct nb_shares){0, 0, 0};
}

/* Of the kick around a stage's t_0 the part before t_0 is damped as the stage before was: `before` is its share of the kick. */
static inline struct nb_shares nb_shares(const struct nb_model *model, double dt, double before) {
  const struct nb_shares now = nb_shares_of(&model->damping, dt);
  if (model->stage_cycle > 0 || before == 0 ||
      (model->damping.global_kind == model->damping_before.global_kind &&
       model->damping.global == model->damping_before.global))
    return now;
  const struct nb_shares was = nb_shares_of(&model->damping_before, dt);
  const double after = 1 - before;
  return (struct nb_shares){before * was.old + after * now.old, before * was.new + after *now.new,
                            before *was.pushed + after *now.pushed};
}
static inline double nb_kick_before(const struct nb_model *model) {
  return model->previous_step / (model->previous_step + model->step);
}

struct nb_factors {
  double keep, total_normal;
};

static inline struct nb_factors nb_factors(const struct nb_model *model, double dt, double before) {
  const struct nb_shares taken = nb_shares(model, dt, before);
  return (struct nb_factors){(1 - taken.old) / (1 + taken.new), (1 - taken.pushed) / (1 + taken.new)};
}

/* Where the forces on bodies are found. */
struct nb_contact_forces {
  const struct nb_vec *force;
  const double *total_shear; /* NULL: no shear */
};

static inline struct nb_contact_forces nb_contact_forces_of(const struct nb_model *model) {
  return (struct nb_contact_forces){model->contacts.force,
                                    model->plan.has_friction ? model->contacts.kept[model->plan.total_shear] : NULL};
}

/* The force stored is the one on the contact's first body, so where a body is second it feels the opposite. The shear forces
 * F_s are counterclockwise on both [CS79, The force-displacement law]: their sum is left in `moment`, without the radius. */
static inline NB_FORM struct nb_force nb_sum_of(struct nb_contact_forces contact_forces, struct nb_contacts_of its,
                                                bool turned) {
  struct nb_force sum = {.moment = 0};
  nb_both both = {0, 0};
  const int *c = its.first;
  for (; c < its.middle; c++) {
    both -= vec_both(&contact_forces.force[*c]);
    sum.moment += turned ? contact_forces.total_shear[*c] : 0;
  }
  for (; c < its.end; c++) {
    both += vec_both(&contact_forces.force[*c]);
    sum.moment += turned ? contact_forces.total_shear[*c] : 0;
  }
  vec_put(&sum.force, both);
  return sum;
}

static inline bool nb_pulls(struct nb_vec gravity) { return gravity.x != 0 || gravity.y != 0; }

/* m G towards the point; nothing at the point itself. */
static inline struct nb_vec nb_pull(const struct nb_central *gravity, double mass, struct nb_vec x) {
  const struct nb_vec way = vec_sub(gravity->to, x);
  const double distance = vec_length(way);
  return vec_scale(distance > 0 ? mass * gravity->strength / distance : 0, way);
}

#endif
