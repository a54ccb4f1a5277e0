/* Energy and momentum at a time, and the two balances of a run: energy.c, balance.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ENERGY_H
#define NB_ENERGY_H

#include "core/model.h"
#include "laws/laws_now.h"

/* ---- energy.c: at t_N ---- */

double nb_energy_kinetic(const struct nb_model *model);      /* of free particles, with the velocities at t_N, J */
double nb_energy_kinetic_half(const struct nb_model *model); /* with the velocities of the last half step, J */
/* From the laws' state functions, J; laws without one do not count. */
double nb_energy_stored(const struct nb_model *model);
double nb_energy_of_contact(const struct nb_model *model, size_t contact); /* stored in its springs, J */
double nb_energy_kinetic_of(const struct nb_model *model, size_t slot);    /* of a free particle, else 0, J */
double nb_energy_of_particle(const struct nb_model *model, size_t slot);   /* kinetic, and stored in its contacts, J */
struct nb_vec nb_momentum(const struct nb_model *model);                   /* of free particles, kg m/s */
double nb_momentum_angular(const struct nb_model *model); /* of free particles about the origin, kg m2/s */

/* Largest force sum on a free particle, weight included, over the largest contact force: dF/F of [CS79 tables 1-3]. 0
 * if all force sums are 0, infinite if forces act but no contact carries any. */
double nb_unbalanced_max(const struct nb_model *model);

/* ---- balance.c: since the start. No effect if model->balance is NULL, unless noted ---- */

struct nb_balance; /* balance.h */
/* Sets up the balances that columns and conditions of the scene need; leaves model->balance NULL if there are none. */
enum nb_status nb_balance_create(struct nb_model *model, struct nb_error *error);
void nb_balance_free(struct nb_model *model);

/* In a cycle, only if model->balance is not NULL. */
void nb_balance_before_motion(struct nb_model *model);       /* before the motion */
void nb_balance_after_motion(struct nb_model *model);        /* while forces and steps are still those of the kick */
void nb_balance_change(struct nb_model *model, bool before); /* before and after a stage changes properties or laws */
void nb_balance_after_forces(struct nb_model *model);        /* after the forces */
/* Before and after velocities jump when a stage begins: the change of kinetic energy counts as this term. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before);
/* Before and after particles are removed, join a held boundary or are released: the change of kinetic energy does
 * not count as work. */
void nb_balance_exclude(struct nb_model *model, bool before);
/* After the search: pairs of a released boundary that overlap at once. */
enum nb_status nb_balance_new_overlaps(struct nb_model *model, struct nb_error *error);

double nb_balance_term(const struct nb_model *model, enum nb_term term); /* at t_N, J */
double nb_balance_work_residual(const struct nb_model *model);           /* at the last half step, J */
double nb_balance_energy_residual(const struct nb_model *model);         /* at t_N, J */

#endif
