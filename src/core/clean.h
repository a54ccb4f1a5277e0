/* Text that is safe to print to a terminal or a browser.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

/* Replaces by `?` every byte of the text that is not part of a valid UTF-8 character, and every byte of a control
 * character other than tab. Returns the column of the first replaced byte, counted in characters from 1, and sets
 * `byte` to its value. Returns 0 if it replaced no byte. `length`: of the text in bytes. */
int nb_clean(char *text, size_t length, unsigned *byte);

/* Appends a word to the text so that a POSIX shell reads it unchanged: in quotes if it is empty or has a
 * character other than letters, digits and the usual ones of names, numbers and paths. */
void nb_append_word(char *text, size_t size, const char *word);
/* Appends to the text as printf would. The array `text` has `size` bytes; what does not fit is cut off. */
void nb_append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Appends a word in backticks to a list such as "`a`, `b` or `c`". `last`: it is the last word of the list. */
void nb_append_item(char *list, size_t size, const char *word, bool last);
/* Does what nb_append does, with the arguments in a va_list. */
void nb_append_arguments(char *text, size_t size, const char *format, va_list list)
    __attribute__((format(printf, 3, 0)));
