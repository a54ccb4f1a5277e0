/* What moves an assembly from outside: its boundary, and whether bodies turn.
 *
 *   drive.c   what stages do with it      ring.c   which bodies are the boundary, its polygon, its stress
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_DRIVE_H
#define NB_DRIVE_H

#include "carry.h"
#include "core/boundary.h"

/* ---- drive.c ---- */
enum nb_status nb_drive_create(struct nb_model *model, struct nb_error *error); /* before the first search */
enum nb_status nb_drive_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
/* Before the motion and after it. */
enum nb_status nb_drive_before(struct nb_model *model, struct nb_error *error);
void nb_drive_after(struct nb_model *model);
void nb_drive_hold(struct nb_model *model, size_t slot);   /* makes a body one of the boundary's */
void nb_drive_let_go(struct nb_model *model, size_t slot); /* and free again, with the velocity that it has */

enum nb_status nb_drive_search(struct nb_model *model,
                               struct nb_error *error); /* contacts anew, with forces as they are */

/* ---- remove.c ---- */
enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);

/* ---- ring.c ---- */
void nb_ring_begin(struct nb_model *model, const struct nb_circle *circle);
void nb_ring_hold(struct nb_model *model); /* its bodies are held again: it is the circle of their mean radius */
void nb_ring_free(struct nb_model *model, bool dissolve);
void nb_ring_drop(struct nb_model *model, size_t slot); /* that is taken out of the scene */
/* Takes in who has crossed the circle since it was last asked; NB_OK. */
enum nb_status nb_ring_take_in(struct nb_model *model, struct nb_error *error);
void nb_ring_carry(struct nb_model *model); /* before the motion, where nothing else is carried */
void nb_ring_press(struct nb_model *model); /* sets drive->pressed for where the bodies are now */

#endif
