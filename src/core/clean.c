/* Cleans every text from a page, a file name, a state or gnuplot before it goes to a terminal: a control character
 * could move the cursor, hide earlier output, or act as typed input.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "clean.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Number of bytes of the UTF-8 character with this first byte; 0: no character begins with it. */
static size_t encoded_length(unsigned char first) {
  return first < 0x80 ? 1 : (first & 0xE0) == 0xC0 ? 2 : (first & 0xF0) == 0xE0 ? 3 : (first & 0xF8) == 0xF0 ? 4 : 0;
}

static bool is_control(unsigned long code) { return (code < 0x20 && code != '\t') || (code >= 0x7F && code < 0xA0); }

/* Number of bytes of the UTF-8 character at c, of which `left` can be read; 0: no valid character (RFC 3629), or a
 * control character other than tab. */
static size_t valid_length(const unsigned char *c, size_t left) {
  static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
  const size_t n = encoded_length(c[0]);
  if (n == 0 || n > left)
    return 0;
  unsigned long code = n == 1 ? c[0] : c[0] & (0x7FU >> n);
  for (size_t i = 1; i < n; i++) {
    if ((c[i] & 0xC0) != 0x80)
      return 0;
    code = code << 6 | (c[i] & 0x3FU);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < least[n] || code > 0x10FFFF || is_control(code) || surrogate ? 0 : n;
}

int nb_clean(char *text, size_t length, unsigned *byte) {
  int column = 0, first = 0;
  for (size_t i = 0; i < length;) {
    const size_t n = valid_length((const unsigned char *)text + i, length - i);
    column++;
    if (n == 0 && !first) {
      first = column;
      *byte = (unsigned char)text[i];
    }
    if (n == 0)
      text[i] = '?';
    i += n ? n : 1;
  }
  return first;
}

void nb_append_arguments(char *text, size_t size, const char *format, va_list list) {
  const size_t length = strlen(text);
  vsnprintf(text + length, size - length, format, list);
}

void nb_append(char *text, size_t size, const char *format, ...) {
  va_list list;
  va_start(list, format);
  nb_append_arguments(text, size, format, list);
  va_end(list);
}

void nb_append_item(char *list, size_t size, const char *word, bool last) {
  nb_append(list, size, "%s`%s`", !*list ? "" : last ? " or " : ", ", word);
}

void nb_append_word(char *text, size_t size, const char *word) {
  static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,%@";
  if (word[0] && !word[strspn(word, plain)]) {
    nb_append(text, size, "%s", word);
    return;
  }
  nb_append(text, size, "'");
  for (; *word; word++) /* an apostrophe ends the quotes, is escaped, and begins them again */
    nb_append(text, size, *word == '\'' ? "'\\%c'" : "%c", *word);
  nb_append(text, size, "'");
}
