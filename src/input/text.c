/* A text that grows.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "text.h"

#include <stdio.h>
#include <stdlib.h>

void nb_text_add_arguments(struct nb_text *text, const char *format, va_list list) {
  va_list again;
  va_copy(again, list);
  const int n = vsnprintf(text->at ? text->at + text->length : NULL, text->capacity - text->length, format, list);
  text->failed = text->failed || n < 0;
  if (!text->failed && text->length + (size_t)n >= text->capacity) {
    const size_t capacity = 2 * (text->length + (size_t)n) + 64;
    char *longer = realloc(text->at, capacity);
    text->failed = !longer;
    if (longer) {
      text->at = longer, text->capacity = capacity;
      vsnprintf(text->at + text->length, capacity - text->length, format, again);
    }
  }
  va_end(again);
  if (text->failed) {
    free(text->at);
    *text = (struct nb_text){.failed = true};
  } else {
    text->length += (size_t)n;
  }
}

void nb_text_add(struct nb_text *text, const char *format, ...) {
  va_list list;
  va_start(list, format);
  nb_text_add_arguments(text, format, list);
  va_end(list);
}
