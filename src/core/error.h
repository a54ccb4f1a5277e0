/* Errors and warnings, filled: error.c, warning.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ERROR_H
#define NB_ERROR_H

#include "nineball.h"

/* Fills `error` as printf would; returns its status, so that a function can end with it. */
enum nb_status nb_error_set(struct nb_error *error, enum nb_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
enum nb_status nb_error_memory(struct nb_error *error); /* every allocation that fails ends here: NB_NO_MEMORY */
/* "WHAT: reason", the reason by errno. */
enum nb_status nb_error_system(struct nb_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Adds one, unless it is there already. */
void nb_warn(struct nb_warnings *warnings, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));
void nb_warnings_add(struct nb_warnings *warnings, const struct nb_warning *warning);

#endif
