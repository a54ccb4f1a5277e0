/* Text that a terminal or a browser can be shown.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CLEAN_H
#define NB_CLEAN_H

#include <stdarg.h>
#include <stddef.h>

/* How many bytes of UTF-8 make the character at c (RFC 3629, without control characters but tab); 0: none. */
size_t nb_clean_character(const unsigned char *c, size_t left);
/* Replaces every byte that belongs to no such character by `?`. The column of the first one, from 1, and the byte; 0: none. */
int nb_clean(char *text, size_t length, unsigned *byte);

/* Behind what is in the text already, as far as its size goes. */
void nb_append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void nb_append_list(char *text, size_t size, const char *format, va_list list) __attribute__((format(printf, 3, 0)));

#endif
