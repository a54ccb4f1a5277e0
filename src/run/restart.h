/* The state that a page starts from: looked up in the folder of states, or made first.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_START_H
#define NB_START_H

#include "state.h"

enum nb_found { NB_THERE, NB_STALE, NB_ABSENT };

/* Where the state is or would be, "states/nine-discs-load-0123456789abcdef.state"; size for the whole path. */
enum nb_status nb_start_path(char *path, size_t size, const struct nb_scene *scene, const struct nb_options *options,
                             struct nb_error *error);
/* Whether it is there; stale: only one of an older text of the page, or of other values. */
enum nb_found nb_start_look(const struct nb_scene *scene, const struct nb_options *options);
/* Takes it from there; when it is not there it is made first, with progress, or an error if `make` is false. */
enum nb_status nb_start_take(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                             const struct nb_progress *progress, bool make, struct nb_error *error);
/* A model of a scene that starts from a state which is there. */
struct nb_model *nb_start_model(const struct nb_scene *scene, const struct nb_options *options, struct nb_error *error);

bool nb_start_there(const struct nb_scene *scene, const struct nb_options *options); /* or nothing to be there */

/* run.c: the state at the end of the scene's last stage */
enum nb_status nb_run_to(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                         const struct nb_progress *progress, struct nb_error *error);

#endif
