/* Captures, restores and writes saved states. Their contents: input/state_file.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STATE_H
#define NB_STATE_H

#include "core/model.h"
#include "input/state_file.h"

/* The model must have been made with options.keep_all. Free *saved in any case. */
enum nb_status nb_saved_capture(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error);
/* NB_BAD_USE, with what does not fit, if the state is not one of this scene; `path` is for the message. */
enum nb_status nb_saved_fits(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                             struct nb_error *error);
/* Before the plan: particles, walls, properties and time; then cell, boundary and affine motion. After the search: forces and
 * histories of contacts. */
void nb_saved_restore(struct nb_model *model, const struct nb_saved *saved);
enum nb_status nb_saved_restore_contacts(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
enum nb_status nb_saved_restore_loading(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
/* Reads the text back before it writes the file, so that no state is written that cannot be read. */
enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error);

#endif
