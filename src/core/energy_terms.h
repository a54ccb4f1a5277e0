/* Terms of the energy balance since the start: each part of the program adds its own (measure/balance.c keeps and reads them).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ENERGY_TERMS_H
#define NB_ENERGY_TERMS_H

#include <math.h>

/* Each from its own definition, J. */
enum nb_term {
  NB_TERM_DAMPED,     /* dashpot force times relative velocity, and what global damping takes */
  NB_TERM_WALLS,      /* force of walls and of fixed bodies that move, times their velocity */
  NB_TERM_GRAVITY,    /* weight times velocity */
  NB_TERM_FRICTIONAL, /* shear force times sliding displacement, or what the law says, of laws that store energy */
  NB_TERM_SLIDING,    /* of that, what is lost in steps that end with the contact sliding as a whole */
  NB_TERM_SHEAR,      /* work against the shear forces of all laws */
  NB_TERM_UNSTORED,   /* the same of laws that have no stored energy only */
  NB_TERM_CHANGED, /* put in from outside: `zero velocities`, `reverse velocities`, springs that a stage has made stiffer or softer */
  NB_TERM_REMOVED, /* kinetic energy of bodies that were taken out, and what their springs held; of those that are held */
  NB_TERM_IMPOSED, /* what carries bodies along, and stress on a boundary, times velocity */
  NB_TERMS
};

/* A sum that carries what rounding cuts off (Neumaier 1974). */
struct nb_sum {
  double sum, rest;
};
static inline void nb_sum_add(struct nb_sum *to, double value) {
  const double sum = to->sum + value;
  to->rest += fabs(to->sum) >= fabs(value) ? (to->sum - sum) + value : (value - sum) + to->sum;
  to->sum = sum;
}

#endif
