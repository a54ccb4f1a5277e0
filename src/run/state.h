/* A saved state from a model, and into one; and to a file. What stands in it: input/state_file.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STATE_H
#define NB_STATE_H

#include "core/model.h"
#include "input/state_file.h"

/* All of the model, which must have been made with options.keep_all; free it in any case. */
enum nb_status nb_saved_take(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error);
/* NB_BAD_USE when it is not of this scene, which says what does not fit; `path` for the message. */
enum nb_status nb_saved_fits(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                             struct nb_error *error);
/* Bodies, walls, properties and time, before the plan, and what carries them; then forces and what laws remember, after the search. */
void nb_saved_put(struct nb_model *model, const struct nb_saved *saved);
enum nb_status nb_saved_put_contacts(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
enum nb_status nb_saved_put_driven(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error);
/* Reads what it has written before it gives it a name: else the next page would find a state that it cannot use. */
enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error);

#endif
