/* Data of the two balances, shared by balance.c and balance_steps.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BALANCE_H
#define NB_BALANCE_H

#include "energy.h"

struct nb_balance {
  struct {
    struct nb_velocities before, now; /* velocities before the kick; at t_N */
    struct nb_vec position, imposed;  /* at t_N, m; imposed displacement over the kick, m */
  } * particles;                      /* per slot */
  struct nb_tensor copy_displacement; /* extra displacement of a neighbouring copy of the cell, m */
  struct {
    struct nb_vec pivot;        /* P at t_N, m */
    struct nb_velocities speed; /* over the step that ends at t_N */
  } * walls;
  struct nb_pair *values;     /* per material pair: constants at t_N before the stage */
  struct nb_active_laws laws; /* laws at t_N before the stage */
  struct nb_new_overlap {
    int a, b;
  } * overlaps;                    /* slots of pairs that overlapped already when they were listed; NULL: none ever */
  size_t overlap_count;            /* their number; 0 again after the next forces */
  bool changed, shear_law_changed; /* by the stage: constants or laws; the shear law */
  double initial_kinetic, initial_energy; /* K_0; (K + U)_0, J */
  struct nb_sum work;                     /* J */
};

/* Adds the half before t_N of the kick around t_N. */
void nb_balance_add_half_kick(struct nb_sum terms[], const struct nb_model *model);

#endif
