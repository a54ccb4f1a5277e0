/* From a scene to what runs, and its stages: model.c, plan.c, hooks.c, stage.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_PLAN_H
#define NB_PLAN_H

#include "core/model.h"

/* plan.c: which passes each pairing needs, and which fields are kept */
enum nb_status nb_plan(struct nb_model *model, struct nb_error *error);
bool nb_plan_stands(const struct nb_model *model); /* whether it is still the one that the pairings' values ask for */

/* hooks.c: what else a cycle does, as long as nothing changes that it depends on */
void nb_hooks_plan(struct nb_model *model);

/* stage.c */
bool nb_changes_create(struct nb_model *model); /* false: no memory */
enum nb_status nb_stage_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
bool nb_stage_ramps_walls(const struct nb_model *model);
bool nb_stage_changes(const struct nb_model *model); /* still properties, laws or gravity */
void nb_stage_drive(struct nb_model *model);         /* before the motion: velocities of walls over the step to come */
/* After it: properties and gravity at the time that has been reached. */
enum nb_status nb_stage_change(struct nb_model *model, struct nb_error *error);

/* model.c */
struct nb_saved;
/* The same as nb_model_create, from a state instead of what the page says of bodies and walls; NULL: from the page. The state is
 * that of the scene's stage `begun - 1`. */
struct nb_model *nb_model_resume(const struct nb_scene *scene, const struct nb_options *options,
                                 const struct nb_saved *saved, struct nb_error *error);

#endif
