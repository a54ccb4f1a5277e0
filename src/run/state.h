/* Captures, restores and writes saved states. input/state_file.h describes their contents.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"
#include "input/state_file.h"

/* Copies the state of a model. For a state from which another page starts, the model must have been created with
 * options.keep_all; a checkpoint needs only the fields that the run keeps. The caller frees *saved, also after an
 * error. */
enum nb_status nb_saved_capture(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error);
/* Checks that the state belongs to the scene. NB_BAD_USE if not; the message names the state file, `path`, and what was
 * expected. */
enum nb_status nb_saved_fits(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                             struct nb_error *error);
/* Restores the variables of all particles and walls, properties, laws, uniform gravity and time. Called before
 * nb_plan. */
void nb_saved_restore(struct nb_model *model, const struct nb_saved *saved);
/* Restores cell, boundary, affine motion, central gravity and whether particles rotate. Called after nb_saved_restore.
 * NB_BAD_USE if the model and the state do not agree in them. */
enum nb_status nb_saved_restore_loading(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
/* Restores forces and histories of the contacts. Called after the search has listed the contacts. NB_BAD_USE if the
 * state has an overlapping contact that is not listed. */
enum nb_status nb_saved_restore_contacts(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
/* Writes the state to a file as text. Before that it parses this text, so that every written state can be read
 * again. */
enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error);
