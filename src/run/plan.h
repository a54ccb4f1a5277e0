/* Makes a model from a scene and begins its stages: model.c, plan.c, hooks.c, stage.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"

/* plan.c: the passes of each material pair, and the fields that are kept */
enum nb_status nb_plan(struct nb_model *model, struct nb_error *error);
bool nb_plan_is_current(const struct nb_model *model); /* false: friction, damping or affine motion need other passes */

/* hooks.c: selects the hooks. Must be called again after any change on which the selection depends. */
void nb_hooks_plan(struct nb_model *model);

/* stage.c */
bool nb_changes_create(struct nb_model *model); /* false: out of memory */
/* Saves model->changes for a checkpoint; if store->restoring, restores them. */
void nb_changes_store(struct nb_store *store, struct nb_model *model);
enum nb_status nb_stage_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
bool nb_stage_ramps_walls(const struct nb_model *model); /* true: the stage ramps the velocity of a wall */
/* True if properties, laws or gravity change in a later cycle of the stage. */
bool nb_stage_changes(const struct nb_model *model);
bool nb_stage_changes_contacts(const struct nb_model *model); /* properties or laws, not only the gravity */
/* Sets the velocities of the walls with ramps for the next step. Called before the motion. */
void nb_stage_set_wall_velocities(struct nb_model *model);
/* Sets properties, laws and gravity at the current time. Called after the motion. */
enum nb_status nb_stage_change(struct nb_model *model, struct nb_error *error);

/* model.c */
struct nb_saved;
/* Creates a model as nb_model_create does, but with particles, walls and contacts from `saved`: the state at the end of
 * the stage with the index scene->start.stages - 1, or a checkpoint. If `saved` is NULL, the model begins at time 0.
 * Returns NULL and fills `error` when the model cannot be created. The caller still owns `saved`. */
struct nb_model *nb_model_resume(const struct nb_scene *scene, const struct nb_options *options, struct nb_saved *saved,
                                 struct nb_error *error);
