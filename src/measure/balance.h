/* The two balances, inside: shared by balance.c and balance_steps.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BALANCE_H
#define NB_BALANCE_H

#include "energy.h"

struct nb_balance {
  struct {
    struct nb_velocities before, now; /* velocities before the kick; those of t_N */
    struct nb_vec position, imposed;  /* at t_N, m; how far it is carried along over the kick, m */
  } * particles;                      /* per slot */
  struct nb_tensor copy_displacement; /* how far the copy a side on is carried besides, m */
  struct {
    struct nb_vec pivot;        /* P at t_N, m */
    struct nb_velocities speed; /* over the step that ended there */
  } * walls;
  struct nb_pair *values;     /* per pairing: what its laws were given at t_N; */
  struct nb_active_laws laws; /* which they were then; */
  struct nb_new_overlap {
    int a, b;
  } * overlaps;                    /* slots of pairs that have come to the list overlapping; NULL: none ever have */
  size_t overlap_count;            /* of the step ahead */
  bool changed, shear_law_changed; /* some of that is something else now; the shear law is */
  double initial_kinetic, initial_energy; /* K_0; K + U at time 0: what the sums are counted from, J */
  struct nb_sum work;                     /* J */
};

/* Adds the half of the kick around t_N that lies behind it. */
void nb_balance_add_half_kick(struct nb_sum terms[], const struct nb_model *model);

#endif
