/* Errors and warnings: error.c, warning.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "nineball.h"

/* Fills `error` with the text that printf would write; `error` may be NULL. Returns the status, so that a function can
 * return the value of this call. */
enum nb_status nb_error_set(struct nb_error *error, enum nb_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Fills `error` with the message for a failed allocation. Returns NB_NO_MEMORY. */
enum nb_status nb_error_memory(struct nb_error *error);
static inline enum nb_status nb_worse(enum nb_status a, enum nb_status b) { return a > b ? a : b; }
/* Fills `error` with "WHAT: REASON". WHAT is the text that printf would write; REASON describes errno. Returns
 * NB_BAD_USE, or NB_NO_MEMORY if memory ran out. */
enum nb_status nb_error_system(struct nb_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The next two functions add a warning unless the list already has it (warning.c). `line`: of the page; 0: none. */
void nb_warn(struct nb_warnings *warnings, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));
void nb_warnings_add(struct nb_warnings *warnings, const struct nb_warning *warning);
