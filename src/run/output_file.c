/* Output files: written under a temporary name, then renamed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "output_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static void release(struct nb_save *save) {
  free(save->path), free(save->temporary);
  *save = (struct nb_save){0};
}

/* True if a temporary file is a leftover. A process that writes a temporary file holds a lock on it (flock), which ends
 * with the process. So a file that can be locked is a leftover. */
static bool is_leftover(int folder, const char *name) {
  const int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  const bool leftover = file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0;
  if (file >= 0)
    close(file);
  return leftover;
}

/* Removes temporary files NAME.NUMBER.new that killed processes have left. */
static void remove_leftovers(const char *path) {
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  const size_t length = strlen(name);
  char *where = slash ? strndup(path, (size_t)(slash - path) + 1) : NULL;
  DIR *folder = !slash ? opendir(".") : where ? opendir(where) : NULL;
  for (struct dirent *entry; folder && (entry = readdir(folder));) {
    const char *rest = entry->d_name + length;
    if (strncmp(entry->d_name, name, length) == 0 && *rest == '.') {
      const size_t digits = strspn(rest + 1, "0123456789");
      if (digits > 0 && strcmp(rest + 1 + digits, ".new") == 0 && is_leftover(dirfd(folder), entry->d_name))
        unlinkat(dirfd(folder), entry->d_name, 0);
    }
  }
  if (folder)
    closedir(folder);
  free(where);
}

/* Creates and locks a temporary file for `path`, and writes its name to `temporary`. Returns its descriptor; -1:
 * failure. The function never opens an existing file and follows no link. When it has the lock, the function tests that
 * the name still leads to the file, because another process may have removed the file as a leftover before it was
 * locked. */
static int create(char *temporary, size_t size, const char *path) {
  const unsigned long process = (unsigned long)getpid();
  for (unsigned long number = process; number < process + 1000; number++) {
    struct stat opened, named;
    snprintf(temporary, size, "%s.%lu.new", path, number);
    const int file = open(temporary, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST)
      return -1;
    if (file >= 0 && (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) && fstat(file, &opened) == 0 &&
        lstat(temporary, &named) == 0 && opened.st_ino == named.st_ino && opened.st_dev == named.st_dev)
      return file;
    if (file >= 0)
      close(file);
  }
  return -1;
}

enum nb_status nb_save_begin(struct nb_save *save, const char *path, struct nb_error *error) {
  const size_t size = strlen(path) + 32;
  *save = (struct nb_save){.path = strdup(path), .temporary = malloc(size)};
  if (!save->path || !save->temporary) {
    release(save);
    return nb_error_memory(error);
  }
  remove_leftovers(path);
  const int file = create(save->temporary, size, path);
  save->file = file < 0 ? NULL : fdopen(file, "w+");
  if (save->file)
    return NB_OK;
  const enum nb_status status = nb_error_system(error, "cannot write %s", path);
  if (file >= 0)
    close(file), remove(save->temporary);
  release(save);
  return status;
}

enum nb_status nb_save_replace_begin(struct nb_save *save, const char *path, struct nb_error *error) {
  struct stat old;
  char *target = realpath(path, NULL); /* the file to which a link leads is replaced, so that links stay */
  const bool writable = target && access(target, W_OK) == 0 && stat(target, &old) == 0;
  enum nb_status status =
      writable ? nb_save_begin(save, target, error) : nb_error_system(error, "cannot write %s", path);
  if (!status && fchmod(fileno(save->file), old.st_mode & 07777) != 0) {
    status = nb_error_system(error, "cannot write %s", path);
    nb_save_cancel(save);
  }
  free(target);
  return status;
}

void nb_save_cancel(struct nb_save *save) {
  fclose(save->file);
  remove(save->temporary);
  release(save);
}

enum nb_status nb_save_end(struct nb_save *save, struct nb_error *error) {
  const bool failed = ferror(save->file);
  errno = EIO;
  if (failed) /* an earlier write failed: another write sets errno to the reason */
    clearerr(save->file), fputc('\n', save->file);
  if (fflush(save->file) == 0 && !failed && fsync(fileno(save->file)) == 0 && rename(save->temporary, save->path) == 0)
    return fclose(save->file), release(save), NB_OK;
  const enum nb_status status = nb_error_system(error, "cannot write %s", save->path);
  nb_save_cancel(save);
  return status;
}

enum nb_status nb_folder_create(const char *path, struct nb_error *error) {
  char *part = strdup(path);
  if (!part)
    return nb_error_memory(error);
  for (char *slash = strchr(part + strspn(part, "/"), '/'); slash; slash = strchr(slash + 1, '/')) {
    *slash = 0;
    mkdir(part, 0777); /* the folder may exist; a failure shows at the last folder below */
    *slash = '/';
  }
  struct stat status;
  if (mkdir(part, 0777) != 0 && !(errno == EEXIST && stat(part, &status) == 0 && S_ISDIR(status.st_mode)))
    nb_error_system(error, "cannot make the folder %s", path);
  else
    error->status = NB_OK;
  free(part);
  return error->status;
}
