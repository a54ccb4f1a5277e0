/* Files written beside and renamed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include "save.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void forget(struct nb_save *save) {
  free(save->path), free(save->temporary);
  *save = (struct nb_save){0};
}

enum nb_status nb_save_begin(struct nb_save *save, const char *path, struct nb_error *error) {
  const size_t size = strlen(path) + 32;
  *save = (struct nb_save){.path = strdup(path), .temporary = malloc(size)};
  if (!save->path || !save->temporary) {
    forget(save);
    return nb_error_set(error, NB_BROKEN, "out of memory for %s", path);
  }
  snprintf(save->temporary, size, "%s.%ld.new", path, (long)getpid()); /* pages run side by side */
  save->file = fopen(save->temporary, "w");
  if (save->file)
    return NB_OK;
  nb_error_set(error, NB_BAD_USE, "cannot write %s: %s", path, strerror(errno));
  forget(save);
  return NB_BAD_USE;
}

enum nb_status nb_save_end(struct nb_save *save, struct nb_error *error) {
  bool whole = !ferror(save->file) && fflush(save->file) == 0 && fsync(fileno(save->file)) == 0;
  int reason = errno;
  if (fclose(save->file) != 0 && whole)
    whole = false, reason = errno;
  if (whole && rename(save->temporary, save->path) != 0)
    whole = false, reason = errno;
  if (!whole) {
    remove(save->temporary);
    nb_error_set(error, NB_BAD_USE, "cannot write %s: %s", save->path, strerror(reason));
  }
  forget(save);
  return whole ? NB_OK : NB_BAD_USE;
}

enum nb_status nb_save_folder(const char *path, struct nb_error *error) {
  char *part = strdup(path);
  if (!part)
    return nb_error_set(error, NB_BROKEN, "out of memory for %s", path);
  for (char *slash = strchr(part + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
    *slash = 0;
    mkdir(part, 0777); /* one that is there already is no mistake; the last one below tells */
    *slash = '/';
  }
  struct stat status;
  if (mkdir(part, 0777) != 0 && !(errno == EEXIST && stat(part, &status) == 0 && S_ISDIR(status.st_mode)))
    nb_error_set(error, NB_BAD_USE, "cannot make the folder %s: %s", path, strerror(errno));
  else
    error->status = NB_OK;
  free(part);
  return error->status;
}
