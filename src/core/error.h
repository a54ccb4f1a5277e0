/* Errors and warnings: error.c, warning.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ERROR_H
#define NB_ERROR_H

#include "nineball.h"

/* Fills `error` as printf would. Returns the status, so that a function can end with this call. */
enum nb_status nb_error_set(struct nb_error *error, enum nb_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
enum nb_status nb_error_memory(struct nb_error *error); /* NB_NO_MEMORY; called for each allocation that fails */
static inline enum nb_status nb_worse(enum nb_status a, enum nb_status b) { return a > b ? a : b; }
/* "WHAT: reason", the reason from errno. */
enum nb_status nb_error_system(struct nb_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Adds a warning that is not yet in the list. */
void nb_warn(struct nb_warnings *warnings, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));
void nb_warnings_add(struct nb_warnings *warnings, const struct nb_warning *warning);

#endif
