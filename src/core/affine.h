/* What carries bodies along: a velocity c = L (x - x_0) besides their own.      [R89 4.41]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_AFFINE_H
#define NB_AFFINE_H

#include "model.h"
#include "tensor.h"

/* What a body is carried along by: a cell carries all its bodies, else the boundary its own, the continuum what is free. A box has
 * a strain rate likewise, which carries its walls. */
enum nb_carrier {
  NB_CARRIER_NONE,
  NB_CARRIER_CONTINUUM,
  NB_CARRIER_BOUNDARY,
  NB_CARRIER_CELL,
  NB_CARRIER_BOX,
  NB_CARRIERS
};

struct nb_affine {
  struct nb_vec centre;                         /* what the strain rates are about, m */
  struct nb_tensor rate[NB_CARRIERS];           /* over the step ahead, 1/s */
  struct nb_tensor level[NB_CARRIERS];          /* what the stage asks for, before any servo, 1/s */
  struct nb_strain_rate requested[NB_CARRIERS]; /* by the page */
  double remembered[NB_CARRIERS]; /* 1: what carried a body is no part of its own velocity; 0: it stays in it */
  unsigned char *by;              /* per slot: enum nb_carrier */
  bool carries[NB_CARRIERS];      /* some body, now or before */
  bool all, free_before;          /* the step goes through all bodies; free ones were carried in the one behind */
  bool alike;                     /* all bodies have the same rate */
  struct nb_servo_from {
    double stress[3];          /* Pa: where the stresses that are servoed began */
    struct nb_tensor gathered; /* Z of servo.c, 1/s */
    bool begun;                /* it has been set */
  } servo_from;
};

/* c of what carries the body in that slot, were it at x. */
static inline struct nb_vec nb_imposed_at(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return tensor_times(affine->rate[affine->by[slot]], vec_sub(x, affine->centre));
}

static inline void nb_affine_by(struct nb_affine *affine, size_t slot, enum nb_carrier carrier) {
  affine->by[slot] = (unsigned char)carrier;
  affine->carries[carrier] = true;
}

/* Of the c of a body at x: what is no part of its own velocity afterwards, and what is (`accumulated`), m/s. */
static inline struct nb_vec nb_affine_remembered(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(affine->remembered[affine->by[slot]], nb_imposed_at(affine, slot, x));
}

static inline struct nb_vec nb_affine_left(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(1 - affine->remembered[affine->by[slot]], nb_imposed_at(affine, slot, x));
}

#endif
