/* Checkpoints: the state of a run at any cycle, with everything that it has recorded.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "restart.h"

/* The checkpoints of one run. */
struct nb_checkpoint {
  const struct nb_checkpointing *options; /* NULL: none are saved */
  const struct nb_scene *scene;
  char path[NB_STATE_PATH];  /* path of the last checkpoint; the one before it has `.old` after its name */
  unsigned long until_check; /* cycles until the clock is read again */
  double saved, cost;        /* time at which the last checkpoint was saved, s; time for saving it, s */
};

/* Locks all runs of a page. NB_BAD_USE if another process saves checkpoints of them. */
enum nb_status nb_checkpoint_lock(struct nb_lock *lock, const struct nb_scene *scene, const struct nb_options *options,
                                  unsigned long long key, struct nb_error *error);
/* NB_BAD_USE if there is a checkpoint of the run with options->checkpoint.key and the options do not resume it. */
enum nb_status nb_checkpoint_absent(const struct nb_scene *scene, const struct nb_options *options,
                                    struct nb_error *error);
/* Makes the folder and the path; NB_BAD_USE as from nb_checkpoint_absent. If options->checkpoint.seconds or its key is
 * 0, no checkpoints are saved. The caller holds the lock of the checkpoints, or of the state that it computes. */
enum nb_status nb_checkpoint_begin(struct nb_checkpoint *checkpoint, const struct nb_scene *scene,
                                   const struct nb_options *options, struct nb_error *error);
/* Reads the last checkpoint, or the one before if the last one is damaged. saved->store is empty if there is none. */
enum nb_status nb_checkpoint_read(struct nb_saved *saved, const struct nb_checkpoint *checkpoint,
                                  const struct nb_progress *progress, struct nb_error *error);
/* Saves the model and `store`, which has the other data of the run; frees `store`. */
enum nb_status nb_checkpoint_save(struct nb_checkpoint *checkpoint, const struct nb_model *model,
                                  struct nb_store *store, struct nb_error *error);
/* Saves or restores every variable of the model that the state does not contain. Variables are restored after
 * nb_model_resume. */
void nb_model_store(struct nb_store *store, struct nb_model *model);
/* True if so much time has passed since the last checkpoint that the run should save one. At the end of a stage this
 * may be sooner than after options->seconds. */
bool nb_checkpoint_is_due(struct nb_checkpoint *checkpoint, bool stage_ends);
/* True if the run has been asked to stop. */
bool nb_checkpoint_stops(const struct nb_checkpoint *checkpoint);
/* Deletes the checkpoints of a run that has ended. */
void nb_checkpoint_remove(const struct nb_scene *scene, const struct nb_options *options, unsigned long long key);
