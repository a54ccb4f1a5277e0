/* Energy and momentum at a time, and the two balances of a run: energy.c, balance.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"
#include "laws/laws_now.h"

/* ---- energy.c: energy and momentum at t_N ---- */

double nb_energy_kinetic(const struct nb_model *model);      /* of free particles, with the velocities at t_N, J */
double nb_energy_kinetic_half(const struct nb_model *model); /* the same with the velocities at the last half step, J */
/* Energy stored in all contacts, from the laws' state functions, J. Laws without a state function do not count. */
double nb_energy_stored(const struct nb_model *model);
double nb_energy_of_contact(const struct nb_model *model, size_t contact); /* energy stored in a contact, J */
double nb_energy_kinetic_of(const struct nb_model *model, size_t slot);    /* of a particle, J; 0 if it is not free */
/* Kinetic energy of a particle plus the energy stored in its contacts, J. */
double nb_energy_of_particle(const struct nb_model *model, size_t slot);
struct nb_vec nb_momentum(const struct nb_model *model);  /* of free particles, kg m/s */
double nb_momentum_angular(const struct nb_model *model); /* of free particles about the origin, kg m2/s */

/* Largest sum of forces on a free particle, including its weight and the force of a boundary stress, over the largest
 * contact force: dF/F of [CS79 tables 1-3]. 0 if all these sums are 0; infinite if forces act but all contact forces
 * are 0. */
double nb_unbalanced_max(const struct nb_model *model);

/* ---- balance.c: the balances since the start. Functions do nothing if model->balance is NULL, unless noted ---- */

struct nb_balance; /* balance.h */
/* Creates the balances that columns and conditions of the scene need; leaves model->balance NULL if there are none. */
enum nb_status nb_balance_create(struct nb_model *model, struct nb_error *error);
void nb_balance_free(struct nb_model *model);

/* The next three functions are called in a cycle, only if model->balance is not NULL. */
void nb_balance_before_motion(struct nb_model *model);       /* called before the motion */
void nb_balance_after_motion(struct nb_model *model);        /* called after the motion, before the next forces */
void nb_balance_after_forces(struct nb_model *model);        /* called after the forces */
void nb_balance_change(struct nb_model *model, bool before); /* before and after a stage changes properties or laws */
/* Called before and after velocities jump at the beginning of a stage: the change of kinetic energy is added to
 * `term`. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before);
/* Called before and after particles or walls are removed, or particles join a held boundary or are released: the change
 * of kinetic energy does not count as work. */
void nb_balance_exclude(struct nb_model *model, bool before);
/* Called after the search: finds the pairs that already overlap and have had no force, as those of a released boundary.
 * The energies of their springs count as changed. */
enum nb_status nb_balance_new_overlaps(struct nb_model *model, struct nb_error *error);

/* The next three functions are called only if the balance that they read has been created. */
double nb_balance_term(const struct nb_model *model, enum nb_term term); /* a term at t_N, J */
double nb_balance_work_residual(const struct nb_model *model);           /* residual at the last half step, J */
double nb_balance_energy_residual(const struct nb_model *model);         /* residual at t_N, J */
