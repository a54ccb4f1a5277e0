/* Affine (imposed) motion: a velocity c = L (x - x_0) in addition to the particle's own velocity.           [R89 4.41]
 *
 *   c   affine velocity, m/s         x    position of the particle, m
 *   L   velocity gradient, 1/s       x_0  the point that the motion leaves in place, m
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "model.h"
#include "tensor.h"

/* Which L a particle has. In a cell, all particles have the L of the cell. Without a cell, particles of the boundary
 * have the L of the boundary, and free particles that of `affine strain`. NB_AFFINE_BOX is not the source of a
 * particle: its L moves the walls of the box. */
enum nb_affine_source {
  NB_AFFINE_NONE,
  NB_AFFINE_FREE,
  NB_AFFINE_BOUNDARY,
  NB_AFFINE_CELL,
  NB_AFFINE_BOX,
  NB_AFFINE_SOURCES
};

struct nb_affine {
  struct nb_vec centre;                               /* x_0, m */
  struct nb_tensor rate[NB_AFFINE_SOURCES];           /* L in the next step, 1/s */
  struct nb_tensor base_rate[NB_AFFINE_SOURCES];      /* L of the stage, without the part that a servo adds, 1/s */
  struct nb_strain_rate requested[NB_AFFINE_SOURCES]; /* as the page gives them */
  /* 1: c is stored separately from the particle's own velocity; 0: c is added to that velocity (`accumulated`). */
  double separate[NB_AFFINE_SOURCES];
  bool twice;                   /* the affine part is added to relative velocities again: pass/affine_twice.c */
  unsigned char *source;        /* per slot: enum nb_affine_source */
  bool used[NB_AFFINE_SOURCES]; /* some particle has this source, or had it before */
  bool free_before;             /* the free particles moved affinely in the previous step */
  bool any_before;              /* some particles moved affinely in the previous step */
  bool uniform;                 /* all particles have the same L */
  struct nb_servo_state {
    double stress[3];          /* the stresses xx, yy, xy when a servo with `ramp` began; otherwise the targets, Pa */
    struct nb_tensor integral; /* Z of servo.c, 1/s */
    enum nb_servo_phase {
      NB_SERVO_BEGINS,  /* the integral has not been set */
      NB_SERVO_LIMITED, /* since the stage began, the added rate has always been limited by `at most` */
      NB_SERVO_FREE     /* the added rate has been below this limit */
    } phase;
  } servo_state;
};

/* Returns c of the particle in a slot if its position is x, m/s. */
static inline struct nb_vec nb_imposed_velocity(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return tensor_times(affine->rate[affine->source[slot]], vec_sub(x, affine->centre));
}

static inline void nb_affine_assign(struct nb_affine *affine, size_t slot, enum nb_affine_source source) {
  affine->source[slot] = (unsigned char)source;
  affine->used[source] = true;
}

/* The next two functions return the part of c that is stored separately from the particle's own velocity, and the part
 * that is added to that velocity (`accumulated`), m/s. */
static inline struct nb_vec nb_affine_separate(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(affine->separate[affine->source[slot]], nb_imposed_velocity(affine, slot, x));
}

static inline struct nb_vec nb_affine_accumulated(const struct nb_affine *affine, size_t slot, struct nb_vec x) {
  return vec_scale(1 - affine->separate[affine->source[slot]], nb_imposed_velocity(affine, slot, x));
}
