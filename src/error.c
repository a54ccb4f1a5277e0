/* One error, in words.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdarg.h>

#include "nineball.h"

enum nb_status nb_error_set(struct nb_error *error, enum nb_status status, const char *format, ...) {
  if (error) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    error->status = status;
  }
  return status;
}
