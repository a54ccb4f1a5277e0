/* The folder of states. A state is named by page, stage, and a hash of all that it depends on: the program's version, what the
 * page says up to the stage's end with all values in place, and whatever that page starts from. So one that is there fits; one
 * that was made from another text has another name, and goes when the new one is made.
 *
 * Who makes a state holds a lock (flock) on a file beside it, which the system lets go of when the process ends, however it does.
 * Others that want the same state wait for it, in this process or in another, and then find it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _DEFAULT_SOURCE

#include "restart.h"

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

#include "core/clock.h"
#include "output_file.h"

enum { PATH_SIZE = 4096, HASH_SIZE = 16, LIMIT = 3600 /* s that a lock is waited for */ };
static const double PAUSE = 0.05; /* s between two looks at it */

static const char *folder_of(const struct nb_options *options) {
  return options && options->states ? options->states : "states";
}

static const struct nb_stage *last_of(const struct nb_scene *scene) {
  return &scene->start.scene->stages[scene->start.scene->stage_count - 1];
}

enum nb_status nb_start_path(char *path, size_t size, const struct nb_scene *scene, const struct nb_options *options,
                             struct nb_error *error) {
  const struct nb_stage *last = last_of(scene);
  const int n = snprintf(path, size, "%s/%s-%s-%016llx.state", folder_of(options), scene->start.page->name, last->name,
                         last->hash);
  if (n > 0 && (size_t)n < size)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE, "the name of the folder is too long: %.200s…", folder_of(options));
}

/* ---- what was made from an older text ---- */

/* "nine-discs-load-", which all states of this stage begin with. */
static int stem_of(char *stem, size_t size, const struct nb_scene *scene) {
  return snprintf(stem, size, "%s-%s-", scene->start.page->name, last_of(scene)->name);
}

/* Whether such a file was given the same values. */
static bool same_values(const char *path, const struct nb_start *start) {
  struct nb_saved saved;
  struct nb_error error;
  bool same = !nb_saved_read(&saved, path, &error) && saved.setting_count == start->setting_count;
  for (size_t k = 0; same && k < saved.setting_count; k++)
    same = strcmp(saved.settings[k], start->settings[k]) == 0;
  nb_saved_free(&saved);
  return same;
}

/* Looks through the folder for states of that stage from another text of the page; removes them when it is told to. */
static bool others(const struct nb_scene *scene, const struct nb_options *options, bool drop) {
  char stem[3 * NB_NAME_SIZE], path[PATH_SIZE], mine[PATH_SIZE];
  struct nb_error error;
  const size_t length = (size_t)stem_of(stem, sizeof stem, scene);
  DIR *folder = opendir(folder_of(options));
  bool found = false;
  if (!folder || nb_start_path(mine, sizeof mine, scene, options, &error)) {
    if (folder)
      closedir(folder);
    return false;
  }
  for (struct dirent *entry; (entry = readdir(folder));) {
    const char *name = entry->d_name;
    if (strncmp(name, stem, length) != 0 || strspn(name + length, "0123456789abcdef") != HASH_SIZE ||
        strcmp(name + length + HASH_SIZE, ".state") != 0 ||
        snprintf(path, sizeof path, "%s/%s", folder_of(options), name) >= (int)sizeof path)
      continue;
    if (strcmp(path, mine) == 0 || !same_values(path, &scene->start))
      continue;
    found = true;
    if (drop)
      remove(path); /* whoever reads it has it open */
  }
  closedir(folder);
  return found;
}

enum nb_found nb_start_look(const struct nb_scene *scene, const struct nb_options *options) {
  char path[PATH_SIZE];
  struct nb_error error;
  if (nb_start_path(path, sizeof path, scene, options, &error))
    return NB_ABSENT;
  return access(path, R_OK) == 0 ? NB_THERE : others(scene, options, false) ? NB_STALE : NB_ABSENT;
}

bool nb_start_there(const struct nb_scene *scene, const struct nb_options *options) {
  return scene->start.stages == 0 || nb_start_look(scene, options) == NB_THERE;
}

/* ---- the lock ---- */

struct lock {
  char path[PATH_SIZE + 8];
  int file;
};

static void say(const struct nb_progress *progress, const char *text) {
  if (progress && progress->note)
    progress->note(progress->data, text);
}

/* Waits for whoever holds it, and says for whom. */
static enum nb_status wait_for(struct lock *lock, const struct nb_progress *progress, struct nb_error *error) {
  char text[PATH_SIZE + 128], holder[32] = "";
  const char *wait = getenv("NINEBALL_WAIT");
  const double limit = wait ? strtod(wait, NULL) : LIMIT;
  if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
    return NB_OK;
  if (errno == EWOULDBLOCK) {
    const ssize_t n = pread(lock->file, holder, sizeof holder - 1, 0);
    holder[n > 0 ? strspn(holder, "0123456789") : 0] = 0;
    snprintf(text, sizeof text, "waits for process %s, which makes %.*s", holder[0] ? holder : "?",
             (int)(strlen(lock->path) - strlen(".lock")), lock->path);
    say(progress, text);
    for (double waited = 0; waited < limit; waited += PAUSE) {
      nanosleep(&(struct timespec){.tv_nsec = (long)(PAUSE * 1e9)}, NULL);
      if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
        return NB_OK;
      if (errno != EWOULDBLOCK)
        return nb_error_system(error, "cannot lock %s", lock->path);
    }
    return nb_error_set(
        error, NB_BAD_USE,
        "process %s has held %.200s for %g s: see what it does by `ps -p %s`; if it is stopped, `kill -CONT %s` lets "
        "it go on and `kill -KILL %s` ends it; NINEBALL_WAIT=SECONDS waits longer",
        holder, lock->path, limit, holder, holder, holder);
  }
  return nb_error_system(error, "cannot lock %s", lock->path);
}

/* Until it is had, or what it is for is there. */
static enum nb_status lock_take(struct lock *lock, const char *path, const struct nb_progress *progress,
                                struct nb_error *error) {
  snprintf(lock->path, sizeof lock->path, "%s.lock", path);
  for (;;) {
    struct stat mine, there;
    lock->file = open(lock->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock->file < 0)
      return nb_error_system(error, "cannot write %s", lock->path);
    const enum nb_status status = wait_for(lock, progress, error);
    if (status) {
      close(lock->file);
      return status;
    }
    /* Who had it before has removed it when he was done: then there is another one by now, or none. */
    if (fstat(lock->file, &mine) == 0 && stat(lock->path, &there) == 0 && mine.st_ino == there.st_ino &&
        mine.st_dev == there.st_dev)
      break;
    close(lock->file), lock->file = -1;
    if (access(path, F_OK) == 0)
      return NB_OK;
  }
  char holder[32];
  const int n = snprintf(holder, sizeof holder, "%ld\n", (long)getpid());
  if (ftruncate(lock->file, 0) != 0 || pwrite(lock->file, holder, (size_t)n, 0) != n)
    holder[0] = 0; /* others will wait for somebody without a name */
  return NB_OK;
}

static void lock_leave(struct lock *lock) {
  if (lock->file < 0)
    return;
  remove(lock->path);
  close(lock->file);
}

/* ---- taking and making ---- */

/* Under the lock. */
static enum nb_status make_state(struct nb_saved *saved, const char *path, const struct nb_scene *scene,
                                 const struct nb_options *options, const struct nb_progress *progress,
                                 struct nb_error *error) {
  const struct nb_start *start = &scene->start;
  char text[3 * NB_NAME_SIZE];
  snprintf(text, sizeof text, "first the state of `%s` at the end of stage `%s` is made", start->page->name,
           last_of(scene)->name);
  say(progress, text);
  enum nb_status status = nb_run_to(saved, start->scene, options, progress, error);
  if (status) {
    const struct nb_error why = *error;
    return nb_error_set(error, status, "%s, from which this starts: %.400s", start->page->name, why.text);
  }
  saved->hash = last_of(scene)->hash;
  for (size_t k = 0; k < start->setting_count && !status; k++)
    status = nb_saved_setting(saved, start->settings[k], error);
  if (!status)
    status = nb_saved_write(saved, path, error);
  if (!status)
    others(scene, options, true);
  return status;
}

static enum nb_status read_state(struct nb_saved *saved, const char *path, const struct nb_scene *scene,
                                 struct nb_error *error) {
  enum nb_status status = nb_saved_read(saved, path, error);
  if (!status && saved->hash != last_of(scene)->hash)
    status = nb_error_set(error, NB_BAD_USE, "%.200s:4:6: expected the hash of its name: it was renamed", path);
  return status ? status : nb_saved_fits(saved, scene, path, error);
}

enum nb_status nb_start_take(struct nb_saved *saved, const struct nb_scene *scene, const struct nb_options *options,
                             const struct nb_progress *progress, bool make, struct nb_error *error) {
  char path[PATH_SIZE];
  struct lock lock;
  *saved = (struct nb_saved){0};
  enum nb_status status = nb_start_path(path, sizeof path, scene, options, error);
  if (status)
    return status;
  if (access(path, F_OK) == 0) { /* it got its name when it was whole */
    status = read_state(saved, path, scene, error);
    if (!status || access(path, F_OK) == 0)
      return status;
    nb_saved_free(saved); /* it went just now: some other text of the page has been run */
  }
  if (!make)
    return nb_error_set(error, NB_BAD_USE, "%.300s is not there: `nineball run` makes it", path);
  status = nb_save_folder(folder_of(options), error);
  if (!status)
    status = lock_take(&lock, path, progress, error);
  if (status)
    return status;
  if (access(path, F_OK) == 0)
    status = read_state(saved, path, scene, error);
  else
    status = make_state(saved, path, scene, options, progress, error);
  lock_leave(&lock);
  return status;
}

struct nb_model *nb_start_model(const struct nb_scene *scene, const struct nb_options *options,
                                struct nb_error *error) {
  struct nb_saved saved;
  struct nb_model *model = NULL;
  if (!nb_start_take(&saved, scene, options, NULL, false, error))
    model = nb_model_resume(scene, options, &saved, error);
  nb_saved_free(&saved);
  return model;
}
