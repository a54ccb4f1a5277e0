/* Invariants of all readers. An input that violates one is written to a file.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

static const void *input; /* the present input */
static size_t input_size;

void fuzz_begin(const void *bytes, size_t size) { input = bytes, input_size = size; }

void fuzz_hold(bool holds, const char *what) {
  if (holds)
    return;
  FILE *file = fopen("fuzz-broken", "wb");
  if (file) {
    fwrite(input, 1, input_size, file);
    fclose(file);
  }
  printf("not ok 1 - %s\n# the input is in fuzz-broken\n1..1\n", what);
  fflush(stdout);
  abort();
}

void fuzz_hold_mistakes(const struct nb_mistakes *mistakes, enum nb_status status) {
  fuzz_hold((status == NB_OK) == (mistakes->count == 0), "the status agrees with the number of errors");
  fuzz_hold((mistakes->text != NULL) == (mistakes->count > 0), "errors have a text");
  size_t given = 0, length = mistakes->text ? strlen(mistakes->text) : 0;
  for (const char *c = mistakes->text; c && *c; c = strchr(c, '\n') + 1) {
    fuzz_hold(strchr(c, '\n') != NULL, "every line of the messages ends");
    const char *error = strstr(c, ": error: "); /* of this page, or of one that it starts from */
    given += *c != ' ' && error && error < strchr(c, '\n');
    for (const char *d = c; *d != '\n'; d++)
      fuzz_hold((unsigned char)*d >= 0x20 || *d == '\t', "no control characters in messages");
  }
  fuzz_hold(given == mistakes->count, "every error is reported once");
  fuzz_hold(length < (size_t)4 << 20, "the messages have a limited length");
}
