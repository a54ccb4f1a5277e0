/* What carries bodies along: a velocity c = L (x - x_0) besides their own.      [R89 4.41]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_AFFINE_H
#define NB_AFFINE_H

#include "model.h"
#include "tensor.h"

/* What a body is carried along by: a cell carries all its bodies, else the boundary its own, the continuum what is free. A box has
 * a strain rate likewise, which carries its walls. */
enum nb_affine_source {
  NB_AFFINE_NONE,
  NB_AFFINE_FREE,
  NB_AFFINE_BOUNDARY,
  NB_AFFINE_CELL,
  NB_AFFINE_BOX,
  NB_AFFINE_SOURCES
};

struct nb_affine {
  struct nb_vec centre;                               /* what the strain rates are about, m */
  struct nb_tensor rate[NB_AFFINE_SOURCES];           /* over the step ahead, 1/s */
  struct nb_tensor base_rate[NB_AFFINE_SOURCES];      /* what the stage asks for, before any servo, 1/s */
  struct nb_strain_rate requested[NB_AFFINE_SOURCES]; /* by the page */
  double separate[NB_AFFINE_SOURCES]; /* 1: what carried a body is no part of its own velocity; 0: it stays in it */
  unsigned char *source;              /* per slot: enum nb_affine_source */
  bool used[NB_AFFINE_SOURCES];       /* some body, now or before */
  bool all, free_before;              /* the step goes through all bodies; free ones were carried in the one behind */
  bool uniform;                       /* all bodies have the same rate */
  struct nb_servo_from {
    double stress[3];          /* Pa: where the stresses that are servoed began */
    struct nb_tensor integral; /* Z of servo.c, 1/s */
    bool begun;                /* it has been set */
  } servo_from;
};

/* c of what carries the body in that slot, were it at x. */
static inline struct nb_vec nb_imposed_velocity(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return tensor_times(affine->rate[affine->source[slot]], vec_sub(x, affine->centre));
}

static inline void nb_affine_assign(struct nb_affine *affine, size_t slot, enum nb_affine_source carrier) {
  affine->source[slot] = (unsigned char)carrier;
  affine->used[carrier] = true;
}

/* Of the c of a body at x: what is no part of its own velocity afterwards, and what is (`accumulated`), m/s. */
static inline struct nb_vec nb_affine_separate(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(affine->separate[affine->source[slot]], nb_imposed_velocity(affine, slot, x));
}

static inline struct nb_vec nb_affine_accumulated(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(1 - affine->separate[affine->source[slot]], nb_imposed_velocity(affine, slot, x));
}

#endif
