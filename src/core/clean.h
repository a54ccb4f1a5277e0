/* Text that a terminal or a browser can be shown.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CLEAN_H
#define NB_CLEAN_H

#include <stdarg.h>
#include <stddef.h>

/* Replaces every byte that belongs to no character of UTF-8 that may be shown by `?`. The column of the first one, from 1, and the byte; 0: none. */
int nb_clean(char *text, size_t length, unsigned *byte);

/* Behind what is in the text already, as far as its size goes. */
void nb_append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void nb_append_list(char *text, size_t size, const char *format, va_list list) __attribute__((format(printf, 3, 0)));

#endif
