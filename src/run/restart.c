/* The folder of saved states.
 *
 * The name of a state file has the page, the stage, and a hash of everything on which the state depends: the version of
 * the program, the page up to the end of the stage with the values of its variables, and the state from which that page
 * starts. So a file with the expected name is valid. A state of an older text of the page has another name; its file is
 * deleted when the new one, with the same values, is written.
 *
 * A process that computes a state holds a lock (flock) on a file beside it; the system releases the lock when the
 * process ends. Other threads and processes that need the same state wait for the lock, then read the state.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "restart.h"

#include "checkpoint.h"
#include "plan.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "output_file.h"

enum { PATH_SIZE = NB_STATE_PATH, HASH_SIZE = 16, LOCK_TIMEOUT = 3600 /* s */ };
static const double POLL_INTERVAL = 0.05; /* s */

const char *nb_states_folder(const struct nb_options *options) {
  return options && options->states ? options->states : "states";
}

static const struct nb_stage *last_stage(const struct nb_scene *scene) {
  return &scene->start.scene->stages[scene->start.scene->stage_count - 1];
}

enum nb_status nb_start_path(char *path, size_t size, const struct nb_scene *scene, const struct nb_options *options,
                             struct nb_error *error) {
  const struct nb_stage *last = last_stage(scene);
  const int n = snprintf(path, size, "%s/%s-%s-%016llx.state", nb_states_folder(options), scene->start.page->name,
                         last->name, last->hash);
  if ((size_t)n < size)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE, "the name of the folder is too long: %.200s…", nb_states_folder(options));
}

/* ---- outdated states ---- */

/* Writes "nine-discs-load-", with which the names of all states of this stage begin. Returns its length. */
static int name_prefix(char *prefix, size_t size, const struct nb_scene *scene) {
  return snprintf(prefix, size, "%s-%s-", scene->start.page->name, last_stage(scene)->name);
}

/* True if the state in this file was computed with the same values of the variables. */
static bool same_values(const char *path, const struct nb_start *start) {
  struct nb_saved saved;
  struct nb_error error;
  bool same = !nb_saved_read(&saved, path, &error) && saved.setting_count == start->setting_count;
  for (size_t k = 0; same && k < saved.setting_count; k++)
    same = strcmp(saved.settings[k], start->settings[k]) == 0;
  nb_saved_free(&saved);
  return same;
}

/* True if the folder has states of the stage from an older text of the page, with the same values of its variables.
 * `current`: the path of the state of the present text. `delete`: deletes the older ones. */
static bool find_outdated(const char *current, const struct nb_scene *scene, const struct nb_options *options,
                          bool delete) {
  char prefix[3 * NB_NAME_SIZE], path[PATH_SIZE];
  const size_t length = (size_t)name_prefix(prefix, sizeof prefix, scene);
  DIR *folder = opendir(nb_states_folder(options));
  bool found = false;
  if (!folder)
    return false;
  for (struct dirent *entry; (entry = readdir(folder));) {
    const char *name = entry->d_name;
    if (strncmp(name, prefix, length) != 0 || strspn(name + length, "0123456789abcdef") != HASH_SIZE ||
        strcmp(name + length + HASH_SIZE, ".state") != 0)
      continue;
    snprintf(path, sizeof path, "%s/%s", nb_states_folder(options), name); /* as long as `current`, so it fits */
    if (strcmp(path, current) == 0 || !same_values(path, &scene->start))
      continue;
    found = true;
    if (delete)
      remove(path); /* a process that reads the file has it open and can read on */
  }
  closedir(folder);
  return found;
}

enum nb_state_presence nb_start_presence(const struct nb_scene *scene, const struct nb_options *options) {
  char path[PATH_SIZE];
  struct nb_error error;
  if (nb_start_path(path, sizeof path, scene, options, &error))
    return NB_STATE_MISSING;
  return access(path, R_OK) == 0                      ? NB_STATE_PRESENT
         : find_outdated(path, scene, options, false) ? NB_STATE_OUTDATED
                                                      : NB_STATE_MISSING;
}

bool nb_start_is_ready(const struct nb_scene *scene, const struct nb_options *options) {
  return scene->start.stages == 0 || nb_start_presence(scene, options) == NB_STATE_PRESENT;
}

/* ---- the lock ---- */

void nb_note(const struct nb_progress *progress, const char *message) {
  if (progress && progress->note)
    progress->note(progress->data, message);
}

/* Reads the number of the process that holds the lock. The process writes the number after it has taken the lock, so a
 * second attempt follows if there is no number yet. If it also fails, `holder` is `?`. */
static void read_holder(int file, char *holder, size_t size) {
  size_t digits = 0;
  for (int attempt = 0; attempt < 2 && digits == 0; attempt++) {
    if (attempt > 0)
      nanosleep(&(struct timespec){.tv_nsec = (long)(POLL_INTERVAL * 1e9)}, NULL);
    const ssize_t n = pread(file, holder, size - 1, 0);
    holder[n > 0 ? n : 0] = 0;
    digits = strspn(holder, "0123456789");
  }
  snprintf(holder + digits, size - digits, "%s", digits > 0 ? "" : "?");
}

/* Waits until the lock of a state is free, and reports which process holds it. NB_BAD_USE if the lock is not free
 * within LOCK_TIMEOUT, or NINEBALL_WAIT seconds. Does not wait for a lock with lock->use: NB_BAD_USE if another process
 * holds it. */
static enum nb_status lock_wait(struct nb_lock *lock, const struct nb_progress *progress, struct nb_error *error) {
  char message[PATH_SIZE + 128], holder[32];
  const char *wait = getenv("NINEBALL_WAIT");
  const double limit = wait ? strtod(wait, NULL) : LOCK_TIMEOUT;
  if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
    return NB_OK;
  if (errno == EWOULDBLOCK) {
    read_holder(lock->file, holder, sizeof holder);
    if (lock->use)
      return nb_error_set(error, NB_BAD_USE,
                          "process %s %s, %.300s: wait for its end, or choose another folder with %s", holder,
                          lock->use, lock->path, lock->option);
    snprintf(message, sizeof message, "waiting for process %s, which writes %.*s", holder,
             (int)(strlen(lock->path) - strlen(".lock")), lock->path);
    nb_note(progress, message);
    for (double waited = 0; waited < limit; waited += POLL_INTERVAL) {
      nanosleep(&(struct timespec){.tv_nsec = (long)(POLL_INTERVAL * 1e9)}, NULL);
      if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
        return NB_OK;
      if (errno != EWOULDBLOCK)
        return nb_error_system(error, "cannot lock %s", lock->path);
    }
    if (strcmp(holder, "?") == 0)
      return nb_error_set(error, NB_BAD_USE,
                          "an unknown process has held %.200s for %g s: `fuser %.200s` names it; "
                          "NINEBALL_WAIT=SECONDS waits longer",
                          lock->path, limit, lock->path);
    return nb_error_set(
        error, NB_BAD_USE,
        "process %s has held %.200s for %g s: `ps -p %s` shows what this process does; if it is stopped, `kill -CONT "
        "%s` lets it continue and `kill -KILL %s` ends it; NINEBALL_WAIT=SECONDS waits longer",
        holder, lock->path, limit, holder, holder, holder);
  }
  return nb_error_system(error, "cannot lock %s", lock->path);
}

/* Acquires the lock. If another process has written the state and removed the lock in the meantime, the function
 * returns NB_OK without a lock; lock->file is then -1. */
static enum nb_status lock_acquire(struct nb_lock *lock, const char *path, const struct nb_progress *progress,
                                   struct nb_error *error) {
  snprintf(lock->path, sizeof lock->path, "%s.lock", path);
  for (;;) {
    struct stat current, there;
    lock->file = open(lock->path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (lock->file < 0)
      return nb_error_system(error, "cannot write %s", lock->path);
    const enum nb_status status = lock_wait(lock, progress, error);
    if (status) {
      close(lock->file);
      return status;
    }
    /* If the process that held the lock has removed the file, the new lock is on a file without a name and has no
     * effect. */
    if (fstat(lock->file, &current) == 0 && stat(lock->path, &there) == 0 && current.st_ino == there.st_ino &&
        current.st_dev == there.st_dev)
      break;
    close(lock->file), lock->file = -1;
    if (!lock->use && access(path, F_OK) == 0)
      return NB_OK;
  }
  if (ftruncate(lock->file, 0) == 0)
    dprintf(lock->file, "%ld\n", (long)getpid()); /* without it, other processes cannot name the one they wait for */
  return NB_OK;
}

enum nb_status nb_lock_own(struct nb_lock *lock, const char *path, const char *use, const char *option,
                           struct nb_error *error) {
  *lock = (struct nb_lock){.use = use, .option = option};
  return lock_acquire(lock, path, NULL, error);
}

void nb_lock_release(struct nb_lock *lock) {
  if (lock->file < 0)
    return;
  remove(lock->path);
  close(lock->file);
}

/* ---- reading and computing ---- */

/* Computes the state, writes it, and keeps it in *saved. The caller holds the lock. */
static enum nb_status make_state(struct nb_saved *saved, const char *path, const struct nb_scene *scene,
                                 const struct nb_options *options, const struct nb_progress *progress,
                                 struct nb_error *error) {
  const struct nb_start *start = &scene->start;
  char message[3 * NB_NAME_SIZE];
  snprintf(message, sizeof message, "first running `%s` to the end of stage `%s`, where this page starts",
           start->page->name, last_stage(scene)->name);
  nb_note(progress, message);
  enum nb_status status = nb_run_to(saved, start->scene, options, progress, error);
  if (status) {
    const struct nb_error cause = *error;
    char at[NB_NAME_SIZE] = "";
    if (cause.line)
      snprintf(at, sizeof at, ", line %d", cause.line);
    return nb_error_set(error, status, "%s%s, from which this page starts: %.400s", start->page->name, at, cause.text);
  }
  saved->hash = last_stage(scene)->hash;
  for (size_t k = 0; k < start->setting_count && !status; k++)
    status = nb_saved_setting(saved, start->settings[k], error);
  if (!status)
    status = nb_saved_write(saved, path, error);
  if (!status) {
    find_outdated(path, scene, options, true);
    nb_checkpoint_remove(start->scene, options, saved->hash);
  }
  return status;
}

static enum nb_status read_state(struct nb_saved *saved, const char *path, const struct nb_scene *scene,
                                 struct nb_error *error) {
  enum nb_status status = nb_saved_read(saved, path, error);
  if (!status && saved->hash != last_stage(scene)->hash)
    status = nb_error_set(error, NB_BAD_USE,
                          "%.200s:4:6: expected the hash that is in the name of the file: the file was renamed", path);
  return status ? status : nb_saved_fits(saved, scene, path, error);
}

enum nb_status nb_start_obtain(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                               const struct nb_progress *progress, bool make, struct nb_error *error) {
  char path[PATH_SIZE];
  struct nb_lock lock = {.use = NULL};
  *saved = (struct nb_saved){0};
  enum nb_status status = nb_start_path(path, sizeof path, scene, options, error);
  if (status)
    return status;
  if (access(path, F_OK) == 0) { /* files get their name when they are complete */
    status = read_state(saved, path, scene, error);
    if (!status || access(path, F_OK) == 0)
      return status;
    nb_saved_free(saved); /* another process has just deleted it as outdated */
  }
  if (!make)
    return nb_error_set(error, NB_BAD_USE, "expected the state %.300s: `nineball run` writes it", path);
  status = nb_folder_create(nb_states_folder(options), error);
  if (!status)
    status = lock_acquire(&lock, path, progress, error);
  if (status)
    return status;
  if (access(path, F_OK) == 0)
    status = read_state(saved, path, scene, error);
  else
    status = make_state(saved, path, scene, options, progress, error);
  nb_lock_release(&lock);
  return status;
}

struct nb_model *nb_start_model(const struct nb_scene *scene, const struct nb_options *options,
                                struct nb_error *error) {
  struct nb_saved saved;
  struct nb_model *model = NULL;
  if (!nb_start_obtain(&saved, scene, options, NULL, false, error))
    model = nb_model_resume(scene, options, &saved, error);
  nb_saved_free(&saved);
  return model;
}
