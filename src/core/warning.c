/* Warnings: doubtful statements of a page, and numbers with too few valid digits.
 *
 * Each warning is given once for a line of the page. Two texts that are the same up to the first `:` are one warning.
 * The numbers in a warning may differ between the runs of a sweep; the warning of the first run is kept. A list holds
 * the first NB_WARNINGS warnings and drops all others.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdarg.h>
#include <string.h>

#include "error.h"

void nb_warnings_add(struct nb_warnings *warnings, const struct nb_warning *warning) {
  const size_t subject = strcspn(warning->text, ":") + 1;
  for (size_t k = 0; k < warnings->count; k++)
    if (warnings->list[k].line == warning->line && strncmp(warnings->list[k].text, warning->text, subject) == 0)
      return;
  if (warnings->count < NB_WARNINGS)
    warnings->list[warnings->count++] = *warning;
}

void nb_warn(struct nb_warnings *warnings, int line, const char *format, ...) {
  struct nb_warning warning = {.line = line};
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(warning.text, sizeof warning.text, format, arguments);
  va_end(arguments);
  nb_warnings_add(warnings, &warning);
}
