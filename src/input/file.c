/* Files that are read: regular ones only.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "reader.h"

FILE *nb_file_open(const char *path, struct nb_error *error) {
  struct stat status;
  const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a pipe without a writer would block */
  FILE *file = NULL;
  if (descriptor < 0 || fstat(descriptor, &status) != 0)
    nb_error_system(error, "cannot be read");
  else if (!S_ISREG(status.st_mode))
    nb_error_set(error, NB_BAD_USE, "cannot be read: it is %s",
                 S_ISDIR(status.st_mode) ? "a folder" : "a pipe or a device, a regular file is expected");
  else if (!(file = fdopen(descriptor, "rb")))
    nb_error_system(error, "cannot be read");
  if (descriptor >= 0 && !file)
    close(descriptor);
  return file;
}

char *nb_file_read(const char *path, size_t most, size_t *size, struct nb_error *error) {
  struct stat status;
  FILE *file = nb_file_open(path, error);
  char *bytes = NULL;
  if (!file)
    return NULL;
  if (fstat(fileno(file), &status) != 0)
    nb_error_system(error, "cannot be read");
  else if ((*size = (size_t)status.st_size) > most)
    nb_error_set(error, NB_BAD_USE, "expected at most %zu bytes, found %zu", most, *size);
  else if (!(bytes = malloc(*size + 1)))
    nb_error_memory(error);
  else if (fread(bytes, 1, *size, file) != *size) {
    if (ferror(file))
      nb_error_system(error, "cannot be read");
    else
      nb_error_set(error, NB_BAD_USE, "cannot be read: it has become shorter meanwhile");
    free(bytes), bytes = NULL;
  } else {
    bytes[*size] = 0;
  }
  fclose(file);
  return bytes;
}
