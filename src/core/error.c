/* Error messages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "clean.h"
#include "error.h"

enum nb_status nb_error_set(struct nb_error *error, enum nb_status status, const char *format, ...) {
  if (error) {
    va_list arguments;
    unsigned byte;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    nb_clean(error->text, strlen(error->text), &byte); /* the text may quote file names and contents of files */
    error->status = status, error->line = 0;
  }
  return status;
}

enum nb_status nb_error_memory(struct nb_error *error) {
  return nb_error_set(error, NB_NO_MEMORY,
                      "out of memory; make fewer runs at the same time, for example with --jobs 1");
}

enum nb_status nb_error_system(struct nb_error *error, const char *format, ...) {
  const int why = errno;
  char what[sizeof error->text - 100];
  if (why == ENOMEM)
    return nb_error_memory(error);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  return nb_error_set(error, NB_BAD_USE, "%s: %s", what, strerror(why));
}
