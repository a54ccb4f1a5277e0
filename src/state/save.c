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
    return nb_error_memory(error);
  }
  snprintf(save->temporary, size, "%s.%ld.new", path, (long)getpid()); /* pages run side by side */
  save->file = fopen(save->temporary, "w");
  if (save->file)
    return NB_OK;
  const enum nb_status status = nb_error_system(error, "cannot write %s", path);
  forget(save);
  return status;
}

enum nb_status nb_save_end(struct nb_save *save, struct nb_error *error) {
  enum nb_status status = NB_OK;
  errno = EIO; /* if nothing says more of a write that failed earlier */
  if (fflush(save->file) != 0 || ferror(save->file) || fsync(fileno(save->file)) != 0)
    status = nb_error_system(error, "cannot write %s", save->path);
  if (fclose(save->file) != 0 && !status)
    status = nb_error_system(error, "cannot write %s", save->path);
  if (!status && rename(save->temporary, save->path) != 0)
    status = nb_error_system(error, "cannot write %s", save->path);
  if (status)
    remove(save->temporary);
  forget(save);
  return status;
}

enum nb_status nb_save_folder(const char *path, struct nb_error *error) {
  char *part = strdup(path);
  if (!part)
    return nb_error_memory(error);
  for (char *slash = strchr(part + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
    *slash = 0;
    mkdir(part, 0777); /* one that is there already is no mistake; the last one below tells */
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
