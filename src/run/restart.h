/* The saved state from which a page starts: it is read from the folder of states, or computed first.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "state.h"

enum { NB_STATE_PATH = 4096 };

/* The lock of a state, a checkpoint or an output folder: the file PATH.lock, which a process holds by flock while it
 * writes there. */
struct nb_lock {
  char path[NB_STATE_PATH + 8];
  int file;
  /* For the message if another process holds the lock: what that process does, and the option that selects another
   * folder. `use` is NULL for a state: nb_start_obtain waits until the lock is free. */
  const char *use, *option;
};
/* Acquires the lock without waiting. NB_BAD_USE if another process holds it. The texts must outlive the lock. After an
 * error there is nothing to release. */
enum nb_status nb_lock_own(struct nb_lock *lock, const char *path, const char *use, const char *option,
                           struct nb_error *error);
void nb_lock_release(struct nb_lock *lock);
/* options->states, or "states" if this or `options` is NULL. */
const char *nb_states_folder(const struct nb_options *options);
/* Passes the message to progress->note; `progress` may be NULL. */
void nb_note(const struct nb_progress *progress, const char *message);

enum nb_state_presence { NB_STATE_PRESENT, NB_STATE_OUTDATED, NB_STATE_MISSING };

/* The path of the state file, "states/nine-discs-load-0123456789abcdef.state", whether the file exists or not. */
enum nb_status nb_start_path(char *path, size_t size, const struct nb_scene *scene, const struct nb_options *options,
                             struct nb_error *error);
/* Whether the state exists. Outdated: there is only a state of an older text of the page, computed with the same values
 * of its variables. */
enum nb_state_presence nb_start_presence(const struct nb_scene *scene, const struct nb_options *options);
/* Reads the state. If the state does not exist, computes and writes it; with `make` false it returns NB_BAD_USE
 * instead. While another process computes the state, the function waits for at most an hour, or NINEBALL_WAIT seconds.
 * The caller frees *saved, also after an error. */
enum nb_status nb_start_obtain(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                               const struct nb_progress *progress, bool make, struct nb_error *error);
/* Creates a model of a scene that starts from a state; NULL with an error if this state does not exist or cannot be
 * read. */
struct nb_model *nb_start_model(const struct nb_scene *scene, const struct nb_options *options, struct nb_error *error);

/* True if this state exists, or if the scene does not start from a state. */
bool nb_start_is_ready(const struct nb_scene *scene, const struct nb_options *options);

/* run.c: runs the scene; *saved receives the state at the end of its last stage, and is not changed if the run fails.
 * The caller sets it to zero before, and frees it. */
enum nb_status nb_run_to(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                         const struct nb_progress *progress, struct nb_error *error);
/* run.c: true if the condition holds now */
bool nb_condition_met(const struct nb_condition *condition, const struct nb_model *model);
