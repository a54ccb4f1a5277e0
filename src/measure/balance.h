/* Data of the work balance and the energy balance, shared by balance.c and balance_steps.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "energy.h"

struct nb_balance {
  struct {
    struct nb_velocities before, now; /* velocities before the kick; at t_N */
    struct nb_vec position, imposed;  /* position at t_N, m; imposed displacement over the kick, m */
  } * particles;                      /* per slot */
  struct nb_tensor copy_displacement; /* over the kick, of images one side away, relative to their particles, m */
  struct {
    struct nb_vec pivot;        /* P at t_N, m */
    struct nb_velocities speed; /* velocities of the wall over the step that ends at t_N */
  } * walls;
  struct {
    const struct nb_law *law; /* before a change of the stage; NULL: no friction */
    double work;              /* F_s ds/2 of all contacts in the first half of the step, J */
  } * shear;                  /* per material pair */
  double pieces;              /* of the shear law, before a change of the stage */
  struct nb_new_overlap {
    int a, b;
    bool wall;
  } * overlaps;                           /* pairs that already overlapped when they were listed; NULL: never sought */
  size_t overlap_count;                   /* number of these pairs; set to 0 after the next forces */
  bool changed;                           /* the stage has changed parameters or laws in this step */
  double initial_kinetic, initial_energy; /* K_0 plus the changes that nb_balance_exclude excludes; (K + U)_0, J */
  struct nb_sum work;                     /* J */
};

/* Adds the half before t_N of the kick around t_N to all terms if `sign` is 1; subtracts it if `sign` is -1. */
void nb_balance_add_half(struct nb_model *model, double sign);
