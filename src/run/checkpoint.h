/* Checkpoints: the state of a run at any cycle, with everything that it has recorded.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CHECKPOINT_H
#define NB_CHECKPOINT_H

#include "restart.h"

/* The checkpoints of one run. */
struct nb_checkpoint {
  const struct nb_checkpointing *options; /* NULL: none are saved */
  const struct nb_scene *scene;
  char path[NB_STATE_PATH];  /* of the last one; that before it has `.old` after its name */
  unsigned long until_check; /* cycles until the clock is read again */
  double saved, cost;        /* time of the last one, and how long it took, s */
};

/* Locks all runs of a page: NB_BAD_USE if another process saves checkpoints of them. `key` is that of no run. */
enum nb_status nb_checkpoint_lock(struct nb_lock *lock, const struct nb_scene *scene, const struct nb_options *options,
                                  unsigned long long key, struct nb_error *error);
/* NB_BAD_USE if there is a checkpoint of the run with options->checkpoint.key, unless it is to be resumed. */
enum nb_status nb_checkpoint_absent(const struct nb_scene *scene, const struct nb_options *options,
                                    struct nb_error *error);
/* Makes the folder and the path. No effect without `seconds`. The caller has the lock, or that of the state it
 * makes. */
enum nb_status nb_checkpoint_begin(struct nb_checkpoint *checkpoint, const struct nb_scene *scene,
                                   const struct nb_options *options, struct nb_error *error);
/* Reads the last one, or that before it if the last one is damaged; saved->store is empty if there is none. */
enum nb_status nb_checkpoint_read(struct nb_saved *saved, const struct nb_checkpoint *checkpoint,
                                  const struct nb_progress *progress, struct nb_error *error);
/* Saves the model and `store`, which has the other data of the run; frees `store`. */
enum nb_status nb_checkpoint_save(struct nb_checkpoint *checkpoint, const struct nb_model *model,
                                  struct nb_store *store, struct nb_error *error);
/* Every variable of the model that the state does not contain; to restore it, after nb_model_resume. */
void nb_model_store(struct nb_store *store, struct nb_model *model);
/* Whether so much time has passed since the last one that the run should save one. At the end of a stage this may be
 * sooner than after options->seconds. */
bool nb_checkpoint_is_due(struct nb_checkpoint *checkpoint, bool stage_ends);
/* Whether the run has been asked to stop. */
bool nb_checkpoint_stops(const struct nb_checkpoint *checkpoint);
/* Deletes the checkpoints of a run that has ended. */
void nb_checkpoint_remove(const struct nb_scene *scene, const struct nb_options *options, unsigned long long key);

#endif
