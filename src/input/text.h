/* A text that grows. If memory runs out, the text becomes empty and `failed`, and later additions have no effect.
 * A stream of open_memstream drops characters in this case, and reports no error (glibc 2.36).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

struct nb_text {
  char *at; /* with a terminating zero; NULL while empty; owned */
  size_t length, capacity;
  bool failed;
};

void nb_text_add(struct nb_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
void nb_text_add_arguments(struct nb_text *text, const char *format, va_list list)
    __attribute__((format(printf, 2, 0)));
