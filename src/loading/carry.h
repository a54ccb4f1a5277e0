/* What stages do with the strain rates that carry particles along: carry.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CARRY_STAGES_H
#define NB_CARRY_STAGES_H

#include "core/carry.h"

enum nb_status nb_carry_create(struct nb_model *model,
                               struct nb_error *error);                    /* model->carry stays NULL: nothing is */
void nb_carry_begin(struct nb_model *model, const struct nb_stage *stage); /* once the stage's step is known */
/* Before the motion: whether it carries all bodies; else only a boundary's are carried. */
bool nb_carry_step(struct nb_model *model);
void nb_carry_still(struct nb_model *model);             /* nothing has been carried along so far */
void nb_carry_drop(struct nb_model *model, size_t slot); /* that is taken out of the scene */

#endif
