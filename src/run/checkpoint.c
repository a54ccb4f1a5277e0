/* Checkpoints of a run. Each is a saved state (state.c) with further records: the list of contacts, sums, reference
 * configurations, the ramps of the stage, and everything that was recorded. So a run that continues from a checkpoint
 * has the same results as an uninterrupted run, to the last bit, and the same number of searches.
 *
 * The last two checkpoints are kept in the folder of saved states. The file name has the name of the page and a number
 * that identifies the settings and the run of a sweep. The file has a hash of the statements, so the checkpoint of a
 * page with other statements is refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "checkpoint.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/clock.h"
#include "measure/balance.h"
#include "measure/configuration.h"
#include "measure/region.h"
#include "measure/step.h"
#include "output_file.h"
#include "plan.h"

/* `spacing` and `stage_spacing`: smallest time between two checkpoints as a multiple of the time for saving one, during
 * a stage and at the end of a stage. If each checkpoint takes as long as the one before it, saving takes at most a
 * tenth of the time of the run during stages, and a fiftieth at their ends. `first_cost`: assumed time for saving the
 * first checkpoint, s. */
static const double spacing = 10, stage_spacing = 50, first_cost = 2e-3;

/* ---- the variables of the model ---- */

/* Saves or restores fields of contacts. The other fields are in the state, or the next force calculation computes
 * them. */
static void store_contacts(struct nb_store *store, struct nb_contacts *contacts) {
  const size_t n = contacts->count;
  struct nb_history *slip_sum = &contacts->slip_sum;
  NB_STORE(store, "image", contacts->image, contacts->image ? n : 0);
  NB_STORE_INTEGERS(store, "suppressed", contacts->suppressed, contacts->suppressed ? n : 0);
  NB_STORE(store, "stable_overlap", contacts->kept[NB_STABLE_OVERLAP], contacts->kept[NB_STABLE_OVERLAP] ? n : 0);
  for (int m = 0; m < NB_HISTORY; m++)
    NB_STORE(store, "slip_sum", slip_sum->field[m], slip_sum->field[m] ? n : 0);
  NB_STORE(store, "slip_sums", slip_sum->rows, slip_sum->rows ? n * (size_t)slip_sum->doubles : 0);
}

static void store_search(struct nb_store *store, struct nb_model *model) {
  struct nb_search *search = &model->search;
  NB_STORE_INTEGERS(store, "search", &search->last_cycle, 1);
  NB_STORE_INTEGERS(store, "search", &search->count, 1);
  NB_STORE_INTEGERS(store, "search", &search->check_walls, 1);
  NB_STORE_INTEGERS(store, "search", &search->check_pairs, 1);
  NB_STORE_INTEGERS(store, "search", &search->coarse_warned, 1);
  NB_STORE(store, "search.particles", model->particles.search_position, model->particles.count);
  NB_STORE(store, "search.walls", model->walls.search_position, 2 * model->walls.count);
  if (model->cell) {
    NB_STORE(store, "search.cell", &model->cell->deformation, 1);
    NB_STORE(store, "search.cell", &model->cell->travel_limit, 1);
  }
}

static void store_deep(struct nb_store *store, struct nb_model *model) {
  unsigned long long count = nb_deep_count(model);
  NB_STORE_INTEGERS(store, "deep", &count, 1);
  NB_STORE_INTEGERS(store, "deep", model->deep.first, sizeof model->deep.first);
  if (store->restoring)
    model->deep.count = count; /* the counters of the blocks are 0 */
  model->deep.first[sizeof model->deep.first - 1] = 0;
}

static void store_warnings(struct nb_store *store, struct nb_warnings *warnings) {
  NB_STORE_INTEGERS(store, "warnings", &warnings->count, 1);
  if (warnings->count > NB_WARNINGS)
    store->failed = true, warnings->count = 0;
  NB_STORE_INTEGERS(store, "warnings", (char *)warnings->list, warnings->count * sizeof *warnings->list);
  for (size_t k = 0; k < warnings->count; k++)
    warnings->list[k].text[sizeof warnings->list[k].text - 1] = 0;
}

static void store_affine(struct nb_store *store, struct nb_affine *affine) {
  struct nb_servo_state *servo = &affine->servo_state;
  NB_STORE(store, "affine", affine->base_rate, NB_AFFINE_SOURCES);
  NB_STORE_INTEGERS(store, "affine", &affine->free_before, 1);
  NB_STORE_INTEGERS(store, "affine", &affine->any_before, 1);
  NB_STORE(store, "servo", servo->stress, 3);
  NB_STORE(store, "servo", &servo->integral, 1);
  NB_STORE_INTEGERS(store, "servo", &servo->phase, 1);
}

static void store_stability(struct nb_store *store, struct nb_model *model) {
  struct nb_stability *stability = model->stability;
  NB_STORE_INTEGERS(store, "stability", &stability->step_line, 1);
  NB_STORE(store, "stability", &stability->largest, 1);
  NB_STORE_INTEGERS(store, "stability", &stability->allow_unstable, 1);
  NB_STORE_INTEGERS(store, "stability", &stability->checks, 1);
  for (size_t v = 0; v < model->blocks.count && model->blocks.stable_overlap; v++)
    NB_STORE(store, "stability", &model->blocks.stable_overlap[v].overlap, 1);
}

static void store_balance(struct nb_store *store, struct nb_model *model) {
  struct nb_balance *balance = model->balance;
  NB_STORE(store, "balance", &balance->initial_kinetic, 1);
  NB_STORE(store, "balance", &balance->initial_energy, 1);
  NB_STORE(store, "balance", &balance->work, 1);
  NB_STORE(store, "balance", model->terms, model->terms ? NB_TERMS : 0);
}

static void store_region(struct nb_store *store, struct nb_region_state *region, struct nb_model *model) {
  const size_t n = model->particles.count;
  const size_t count = nb_store_length(store, "region", region->reference_position ? 2 * n : 0) / 2;
  if (count == n && !region->reference_position)
    region->reference_position = nb_array(n, sizeof *region->reference_position);
  store->failed = store->failed || (count > 0 && (count != n || !region->reference_position));
  NB_STORE(store, "region", region->reference_position, count == n ? n : 0);
  nb_pairs_store(store, "region.touching", &region->reference_pairs, model);
}

static void store_pairs(struct nb_store *store, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_neighbour_pairs pairs = {nb_array(contacts->count, sizeof *pairs.list), contacts->count};
  store->failed = store->failed || !pairs.list;
  for (size_t c = 0; c < pairs.count && pairs.list; c++)
    pairs.list[c] = (struct nb_neighbour_pair){contacts->a[c], contacts->b[c], contacts->material_pair[c]};
  if (pairs.list)
    nb_pairs_store(store, "contacts", &pairs, model);
  free(pairs.list);
}

void nb_model_store(struct nb_store *store, struct nb_model *model) {
  if (!store->restoring) /* nb_neighbours_restore has restored the pairs */
    store_pairs(store, model);
  store_contacts(store, &model->contacts);
  store_search(store, model);
  store_deep(store, model);
  NB_STORE(store, "times", &model->stage_time, 1);
  NB_STORE(store, "times", &model->step, 1);
  NB_STORE(store, "times", &model->critical, 1);
  NB_STORE_INTEGERS(store, "updates", &model->updates, 1);
  NB_STORE(store, "central", &model->central, 1);
  NB_STORE(store, "walls", model->walls.point, model->walls.count);
  store_warnings(store, &model->warnings);
  nb_changes_store(store, model);
  store_stability(store, model);
  if (model->affine)
    store_affine(store, model->affine);
  if (model->balance)
    store_balance(store, model);
  for (size_t r = 0; model->regions && r < model->scene->region_count; r++)
    store_region(store, &model->regions->list[r], model);
  nb_configuration_store(store, model);
  if (store->restoring)
    nb_hooks_plan(model);
}

/* ---- files ---- */

/* The hash of the statements of the page, and of what the run records: columns, rows and snapshots. */
static unsigned long long hash_of(const struct nb_scene *scene) {
  unsigned long long hash = scene->stages[scene->stage_count - 1].hash;
  for (size_t c = 0; c < scene->column_count; c++)
    hash = nb_hash(hash, scene->columns[c].name, strlen(scene->columns[c].name) + 1);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const unsigned long rows[] = {stage->record_interval, stage->snapshot, (unsigned long)(stage->snapshot_from + 1)};
    hash = nb_hash(hash, rows, sizeof rows);
  }
  return hash;
}

static enum nb_status set_path(char *path, const struct nb_scene *scene, const struct nb_options *options,
                               unsigned long long key, struct nb_error *error) {
  const int n = snprintf(path, NB_STATE_PATH, "%s/%s-%016llx.checkpoint", nb_states_folder(options),
                         scene->page ? scene->page->name : "-", key);
  return n < NB_STATE_PATH ? NB_OK : nb_error_set(error, NB_BAD_USE, "the name of the folder of states is too long");
}

static void old_path(char *old, const char *path) { snprintf(old, NB_STATE_PATH + 8, "%s.old", path); }

static bool exists(const char *path) { return access(path, F_OK) == 0; }

enum nb_status nb_checkpoint_absent(const struct nb_scene *scene, const struct nb_options *options,
                                    struct nb_error *error) {
  char path[NB_STATE_PATH], old[NB_STATE_PATH + 8];
  if (options->checkpoint.resume)
    return NB_OK;
  if (set_path(path, scene, options, options->checkpoint.key, error))
    return error->status;
  old_path(old, path);
  const bool last = exists(path), before = exists(old);
  if (!last && !before)
    return NB_OK;
  return nb_error_set(
      error, NB_BAD_USE,
      "the run of this page was interrupted; its checkpoint is %.300s: --resume continues from this checkpoint; to "
      "start from the beginning, remove this file%s",
      last ? path : old, last && before ? " and the file with `.old` after its name" : "");
}

enum nb_status nb_checkpoint_begin(struct nb_checkpoint *checkpoint, const struct nb_scene *scene,
                                   const struct nb_options *options, struct nb_error *error) {
  *checkpoint = (struct nb_checkpoint){.scene = scene, .saved = nb_clock(), .cost = first_cost};
  if (!options || !(options->checkpoint.seconds > 0) || !options->checkpoint.key)
    return NB_OK;
  if (set_path(checkpoint->path, scene, options, options->checkpoint.key, error) ||
      nb_checkpoint_absent(scene, options, error) || nb_folder_create(nb_states_folder(options), error))
    return error->status;
  checkpoint->options = &options->checkpoint;
  return NB_OK;
}

enum nb_status nb_checkpoint_lock(struct nb_lock *lock, const struct nb_scene *scene, const struct nb_options *options,
                                  unsigned long long key, struct nb_error *error) {
  char path[NB_STATE_PATH];
  if (set_path(path, scene, options, key, error) || nb_folder_create(nb_states_folder(options), error))
    return error->status;
  return nb_lock_own(lock, path, "runs this page with these settings and saves checkpoints", "--states", error);
}

void nb_checkpoint_remove(const struct nb_scene *scene, const struct nb_options *options, unsigned long long key) {
  char path[NB_STATE_PATH], old[NB_STATE_PATH + 8];
  struct nb_error error;
  if (!(options && options->checkpoint.seconds > 0) || set_path(path, scene, options, key, &error))
    return;
  old_path(old, path);
  remove(path), remove(old);
}

/* The first stage up to whose end the page differs from that of the checkpoint; NULL: there is none. */
static const struct nb_stage *changed_stage(const struct nb_saved *saved, const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++) {
    const unsigned char *hash = (const unsigned char *)&scene->stages[s].hash;
    char name[NB_NAME_SIZE];
    snprintf(name, sizeof name, "hash.%zu", s);
    const struct nb_store_part *part = nb_store_find(&saved->store, name);
    bool same = part && part->count == sizeof scene->stages[s].hash;
    for (size_t k = 0; same && k < part->count; k++)
      same = saved->store.values[part->at + k] == hash[k];
    if (!same)
      return &scene->stages[s];
  }
  return NULL;
}

/* `old`: the path of the checkpoint before the last one; `is_old`: that one has been read, not the last one. */
static enum nb_status check_page(const struct nb_saved *saved, const struct nb_checkpoint *checkpoint, const char *old,
                                 bool is_old, struct nb_error *error) {
  const struct nb_scene *const scene = checkpoint->scene;
  const char *const path = is_old ? old : checkpoint->path, *const other = is_old ? checkpoint->path : old;
  if (saved->hash == hash_of(scene) && saved->store.part_count > 0)
    return nb_saved_fits(saved, scene, path, error);
  const struct nb_stage *stage = changed_stage(saved, scene);
  char where[2 * NB_NAME_SIZE] = "in a statement `record` or `snapshot`";
  if (stage)
    snprintf(where, sizeof where, "in stage `%s` (line %d) or above this stage", stage->name, stage->line);
  return nb_error_set(error, NB_BAD_USE,
                      "the page has changed since %.200s was saved, %s: restore the text of the page, or remove this "
                      "file%s and run the page without --resume",
                      path, where,
                      !exists(other) ? ""
                      : is_old       ? " and the file without `.old` at the end of its name"
                                     : " and the file with `.old` after its name");
}

enum nb_status nb_checkpoint_read(struct nb_saved *saved, const struct nb_checkpoint *checkpoint,
                                  const struct nb_progress *progress, struct nb_error *error) {
  char old[NB_STATE_PATH + 8], message[sizeof error->text + 64];
  *saved = (struct nb_saved){0};
  if (!checkpoint->options || !checkpoint->options->resume)
    return NB_OK;
  old_path(old, checkpoint->path);
  const bool last = exists(checkpoint->path);
  if (!last && !exists(old)) {
    snprintf(message, sizeof message, "there is no checkpoint %.300s: the run starts from the beginning",
             checkpoint->path);
    nb_note(progress, message);
    return NB_OK;
  }
  const char *path = last ? checkpoint->path : old;
  enum nb_status status = nb_saved_read(saved, path, error);
  if (status == NB_BAD_USE && last && exists(old)) {
    snprintf(message, sizeof message, "%s; the run continues from the checkpoint before it", error->text);
    nb_note(progress, message);
    status = nb_saved_read(saved, path = old, error);
  }
  return status ? status : check_page(saved, checkpoint, old, path == old, error);
}

enum nb_status nb_checkpoint_save(struct nb_checkpoint *checkpoint, const struct nb_model *model,
                                  struct nb_store *store, struct nb_error *error) {
  struct nb_saved saved;
  char old[NB_STATE_PATH + 8], name[NB_NAME_SIZE];
  const double began = nb_clock();
  for (size_t s = 0; s < checkpoint->scene->stage_count; s++) {
    snprintf(name, sizeof name, "hash.%zu", s);
    NB_STORE_INTEGERS(store, name, (unsigned char *)&checkpoint->scene->stages[s].hash,
                      sizeof checkpoint->scene->stages[s].hash);
  }
  enum nb_status status = nb_saved_capture(&saved, model, error);
  saved.store = *store, saved.hash = hash_of(checkpoint->scene);
  if (!status && store->failed)
    status = nb_error_memory(error);
  old_path(old, checkpoint->path);
  if (!status) {
    if (exists(checkpoint->path))
      rename(checkpoint->path, old);
    status = nb_saved_write(&saved, checkpoint->path, error);
  }
  nb_saved_free(&saved);
  checkpoint->saved = nb_clock(), checkpoint->cost = checkpoint->saved - began;
  return status;
}

bool nb_checkpoint_is_due(struct nb_checkpoint *checkpoint, bool stage_ends) {
  const double passed = nb_clock() - checkpoint->saved;
  return passed >= checkpoint->cost * (stage_ends ? stage_spacing : spacing) &&
         (stage_ends || passed >= checkpoint->options->seconds);
}

bool nb_checkpoint_stops(const struct nb_checkpoint *checkpoint) {
  return checkpoint->options->stop && *checkpoint->options->stop;
}
