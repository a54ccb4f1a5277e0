/* What the motion of bodies is made of: shared by motion.c, which moves them, and velocity.c, which says how they move.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MOTION_H
#define NB_MOTION_H

#include "drive/drive.h"

static inline double nb_kick_time(const struct nb_model *model) { return (model->previous_step + model->step) / 2; }

struct nb_factors {
  double keep, push;
};

static inline struct nb_factors nb_factors(const struct nb_model *model, double dt) {
  const double g = model->damping.global, half = g * dt / 2;
  switch (model->damping.global_kind) {
  case NB_GLOBAL_ALPHA:
    return (struct nb_factors){(1 - half) / (1 + half), 1 / (1 + half)};
  case NB_GLOBAL_CON1_CS79:
    return (struct nb_factors){g / (2 - g), 1 / (2 - g)};
  case NB_GLOBAL_CON1_VELOCITY:
    return (struct nb_factors){g, 1};
  case NB_GLOBAL_CON1_ALL:
    return (struct nb_factors){g, g};
  case NB_GLOBAL_UNDAMPED:
    break;
  }
  return (struct nb_factors){1, 1};
}

/* Where the forces on bodies are found. */
struct nb_felt {
  const struct nb_vec *force;
  const double *drag; /* NULL: no shear */
};

static inline struct nb_felt nb_felt_by(const struct nb_model *model) {
  return (struct nb_felt){model->contacts.force, model->rubs ? model->contacts.kept[model->drag] : NULL};
}

/* The force stored is the one on the contact's first body, so where a body is second it feels the opposite. The shear forces
 * F_s are counterclockwise on both [CS79, The force-displacement law]: their sum is left in `moment`, without the radius. */
static inline NB_FORM struct nb_force nb_sum_of(struct nb_felt felt, struct nb_contacts_of its, bool turned) {
  struct nb_force sum = {.moment = 0};
  nb_both both = {0, 0};
  const int *c = its.first;
  for (; c < its.middle; c++) {
    both -= vec_both(&felt.force[*c]);
    sum.moment += turned ? felt.drag[*c] : 0;
  }
  for (; c < its.end; c++) {
    both += vec_both(&felt.force[*c]);
    sum.moment += turned ? felt.drag[*c] : 0;
  }
  vec_put(&sum.force, both);
  return sum;
}

static inline bool nb_pulls(struct nb_vec gravity) { return gravity.x != 0 || gravity.y != 0; }

/* m G towards the point; nothing at the point itself. */
static inline struct nb_vec nb_pull(const struct nb_inward *gravity, double mass, struct nb_vec x) {
  const struct nb_vec way = vec_sub(gravity->to, x);
  const double distance = vec_length(way);
  return vec_scale(distance > 0 ? mass * gravity->strength / distance : 0, way);
}

#endif
