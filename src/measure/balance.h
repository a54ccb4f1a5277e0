/* The two balances, inside: shared by balance.c and balance_steps.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BALANCE_H
#define NB_BALANCE_H

#include "energy.h"

/* A sum that carries what rounding cuts off (Neumaier 1974). */
struct nb_sum {
  double sum, rest;
};
static inline void nb_sum_add(struct nb_sum *to, double value) {
  const double sum = to->sum + value;
  to->rest += fabs(to->sum) >= fabs(value) ? (to->sum - sum) + value : (value - sum) + to->sum;
  to->sum = sum;
}

struct nb_balance {
  bool works, energies;
  struct nb_state *before, *now;        /* per slot: velocities before the kick; those of t_N */
  struct nb_vec *position;              /* per slot: at t_N, m */
  struct nb_vec *pivot, *wall_velocity; /* per wall: P at t_N, m; velocity over the step that ended there, m/s */
  double *wall_spin;                    /* likewise, rad/s */
  struct nb_vec *along;                 /* per slot: how far it is carried along over the kick, m; NULL: nothing is */
  struct nb_tensor parted;              /* and the copy a side on besides, m */
  struct nb_pair *values;               /* per pairing: what its laws were given at t_N; */
  struct nb_in_force laws;              /* which they were then; */
  struct nb_entered {
    int a, b;
  } * entered;                         /* slots of pairs that have come to the list overlapping; NULL: none ever have */
  size_t entered_count;                /* of the step ahead */
  bool changed, another;               /* some of that is something else now; the shear law is */
  double kinetic, level;               /* K_0; K + U at time 0: what the sums are counted from, J */
  struct nb_sum work, terms[NB_TERMS]; /* J */
};

/* ---- balance_carry.c ---- */
bool nb_balance_carry_create(struct nb_balance *balance, const struct nb_model *model); /* false: no memory */
/* Before a kick that lasts so long before t_N and after it, s: how far bodies are carried over it. */
void nb_balance_carry(const struct nb_model *model, double behind, double ahead);
struct nb_vec nb_balance_carried(const struct nb_model *model, size_t slot); /* so far, m; */
struct nb_vec nb_balance_parted(const struct nb_model *model,
                                size_t contact); /* the copy that it meets by so much more */
void nb_balance_carrying(struct nb_sum terms[], const struct nb_model *model); /* the work of that, over the kick */

/* ---- balance_bodies.c ---- */
/* Bodies, in a kick that lasts `time` and of which `share` is counted, at the velocities of t_N; */
void nb_balance_bodies(struct nb_sum terms[], const struct nb_model *model, double time, double share);
/* and all forces on free bodies, at the mean of the velocities before and after the kick. */
void nb_balance_work(struct nb_sum *work, const struct nb_model *model, double time);

/* ---- balance.c ---- */
/* Adds the half of the kick around t_N that lies behind it. */
void nb_balance_tail(struct nb_sum terms[], const struct nb_model *model);
void nb_balance_entry_ends(struct nb_model *model); /* balance_entry.c: after the forces of the step */
/* balance_jumps.c: what counts begins at t_N. */
void nb_balance_since(struct nb_model *model);

#endif
