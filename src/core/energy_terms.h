/* Terms of the energy balance since the start. Each module adds its own terms; measure/balance.c owns and reads them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>

/* Each is computed from its own definition, J. */
enum nb_term {
  NB_TERM_DAMPED,     /* work of dashpots and of mass-proportional damping */
  NB_TERM_WALLS,      /* work done by walls, and by fixed particles that move */
  NB_TERM_GRAVITY,    /* work done by gravity */
  NB_TERM_FRICTIONAL, /* energy dissipated by friction, with shear laws that have stored energy */
  NB_TERM_SLIDING,    /* part of NB_TERM_FRICTIONAL in steps that end with the contact sliding */
  NB_TERM_SHEAR,      /* work against the shear forces of all laws */
  NB_TERM_UNSTORED,   /* part of NB_TERM_SHEAR that is done against laws without stored energy */
  NB_TERM_CHANGED,    /* energy that stages put in: velocities zeroed or reversed, loaded springs or laws changed */
  NB_TERM_REMOVED,    /* energy of removed particles, of springs at removed walls, of particles that join a boundary */
  NB_TERM_IMPOSED,    /* work done by the affine motion and by a stress on a boundary */
  NB_TERMS
};

/* A sum with compensation of rounding errors (Neumaier 1974). Its value is sum + rest. */
struct nb_sum {
  double sum, rest;
};
static inline void nb_sum_add(struct nb_sum *to, double value) {
  const double sum = to->sum + value;
  to->rest += fabs(to->sum) >= fabs(value) ? (to->sum - sum) + value : (value - sum) + to->sum;
  to->sum = sum;
}
