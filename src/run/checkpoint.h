/* Checkpoints: the state of a run at any cycle, with everything that it has recorded.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "restart.h"

/* The checkpoints of one run. */
struct nb_checkpoint {
  const struct nb_checkpointing *options; /* NULL: no checkpoints are saved */
  const struct nb_scene *scene;
  char path[NB_STATE_PATH];  /* path of the last checkpoint; the one before it has `.old` after its name */
  unsigned long until_check; /* cycles until the clock is read again */
  double saved; /* time at which the last checkpoint was saved, s; before the first one: at which the run began */
  double cost;  /* time for saving the last checkpoint, s; before the first one: an estimate */
};

/* Acquires the lock of the checkpoints of all runs of a page with the same settings; `key` identifies the settings.
 * NB_BAD_USE if another process holds the lock. */
enum nb_status nb_checkpoint_lock(struct nb_lock *lock, const struct nb_scene *scene, const struct nb_options *options,
                                  unsigned long long key, struct nb_error *error);
/* NB_BAD_USE if there is a checkpoint of the run with options->checkpoint.key and the options do not resume it. */
enum nb_status nb_checkpoint_absent(const struct nb_scene *scene, const struct nb_options *options,
                                    struct nb_error *error);
/* Sets up *checkpoint, and makes the folder of the run's checkpoints. If `options` is NULL, or
 * options->checkpoint.seconds or options->checkpoint.key is 0, no checkpoints are saved and no folder is made.
 * NB_BAD_USE as from nb_checkpoint_absent, or if the folder cannot be made. The calling process must hold the lock of
 * the page's checkpoints or, if it computes a state, the lock of this state. */
enum nb_status nb_checkpoint_begin(struct nb_checkpoint *checkpoint, const struct nb_scene *scene,
                                   const struct nb_options *options, struct nb_error *error);
/* Reads the last checkpoint into *saved, or the one before it if the last one is missing or cannot be read.
 * saved->store is empty if there is no checkpoint or the options do not resume it. NB_BAD_USE if the page has changed
 * since the checkpoint was saved. The caller frees *saved, also after an error. */
enum nb_status nb_checkpoint_read(struct nb_saved *saved, const struct nb_checkpoint *checkpoint,
                                  const struct nb_progress *progress, struct nb_error *error);
/* Saves the model and `store`, which has the other data of the run; frees `store`, also after an error. */
enum nb_status nb_checkpoint_save(struct nb_checkpoint *checkpoint, const struct nb_model *model,
                                  struct nb_store *store, struct nb_error *error);
/* Saves the variables of the model that the state does not contain; if store->restoring, restores them. Variables are
 * restored after nb_model_resume. */
void nb_model_store(struct nb_store *store, struct nb_model *model);
/* The next two functions are called only if checkpoints are saved. True if so much time has passed since the last
 * checkpoint that the run should save one. `stage_ends`: a stage has just ended; then a checkpoint may be due before
 * options->seconds have passed. */
bool nb_checkpoint_is_due(struct nb_checkpoint *checkpoint, bool stage_ends);
/* True if the run has been asked to stop. */
bool nb_checkpoint_stops(const struct nb_checkpoint *checkpoint);
/* Deletes the checkpoints of a run that has ended. `options` may be NULL; then, and if options->checkpoint.seconds is
 * 0, the function does nothing. */
void nb_checkpoint_remove(const struct nb_scene *scene, const struct nb_options *options, unsigned long long key);
