/* What bodies and contacts have at a moment, and the two balances of a run: energy.c, balance.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ENERGY_H
#define NB_ENERGY_H

#include "core/model.h"
#include "laws/laws_now.h"

/* ---- energy.c: at t_N ---- */

double nb_energy_kinetic(const struct nb_model *model);      /* of free bodies, with the velocities of t_N, J */
double nb_energy_kinetic_half(const struct nb_model *model); /* the same with those of the half step behind, J */
/* In springs, from the laws' state functions; contacts whose law has none are left out. J */
double nb_energy_stored(const struct nb_model *model);
double nb_energy_of_contact(const struct nb_model *model, size_t contact); /* what its springs hold, J */
double nb_energy_kinetic_of(const struct nb_model *model, size_t slot);    /* kinetic energy of a free body, J */
double nb_energy_of_particle(const struct nb_model *model,
                             size_t slot);               /* its kinetic energy and that of its springs, J */
struct nb_vec nb_momentum(const struct nb_model *model); /* of free bodies, kg m/s */
double
nb_momentum_angular(const struct nb_model *model); /* of free bodies about the origin, counterclockwise, kg m2/s */

/* Largest force sum on a free body, weight included, over largest contact force: dF/F of [CS79 tables 1-3]; 0 while nothing
 * touches. */
double nb_unbalanced_max(const struct nb_model *model);

/* ---- balance.c: since the start. Nothing is done where model->balance is NULL, unless it says otherwise ---- */

struct nb_balance; /* balance.h */
/* Sets up what the columns and conditions of the scene ask for; leaves model->balance NULL when that is nothing. */
enum nb_status nb_balance_create(struct nb_model *model, struct nb_error *error);
void nb_balance_free(struct nb_model *model);

/* In a cycle, called only where model->balance is not NULL. */
void nb_balance_before_motion(struct nb_model *model); /* before the motion */
void nb_balance_after_motion(
    struct nb_model *model); /* after it, while the forces and steps are still those of the kick */
void nb_balance_change(struct nb_model *model,
                       bool before);                  /* before and after a stage changes properties in a cycle */
void nb_balance_after_forces(struct nb_model *model); /* after the forces */
/* Around what makes velocities jump when a stage begins: the kinetic energy counts as that term. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before);
void nb_balance_exclude(struct nb_model *model, bool before); /* around what takes bodies out, or holds them */
/* After the search that follows: pairs of bodies that a boundary let go of and that overlap at once. */
enum nb_status nb_balance_new_overlaps(struct nb_model *model, struct nb_error *error);

double nb_balance_term(const struct nb_model *model, enum nb_term term); /* at t_N, J */
double nb_balance_work_residual(const struct nb_model *model);           /* at the half step behind, J */
double nb_balance_energy_residual(const struct nb_model *model);         /* at t_N, J */

#endif
