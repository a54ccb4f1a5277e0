/* Invariants of all readers. An input that violates one is written to a file.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../src/input/hash.h"
#include "../../src/input/reader.h"
#include "fuzz.h"

static const void *input; /* the present input */
static size_t input_size;
bool fuzz_saves_time;

void fuzz_begin(const void *bytes, size_t size) { input = bytes, input_size = size; }

bool fuzz_one_of(int count) {
  return !fuzz_saves_time || (nb_hash(NB_HASH_BEGIN, input, input_size) >> 40) % (unsigned)count == 0;
}

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

/* Tests that a message, which ends at `end`, has the form "PLACE: error: TEXT". */
static void hold_message(const char *message, const char *end) {
  static const char mark[] = ": error: ";
  const size_t length = sizeof mark - 1;
  const char *error = message; /* not strstr: with AddressSanitizer it reads all messages each time */
  while (error + length <= end && (*error != *mark || memcmp(error, mark, length) != 0))
    error++;
  fuzz_hold(error + length <= end && error > message, "an error has a place");
  fuzz_hold(error + length < end, "an error has a text");
}

void fuzz_hold_mistakes(const struct nb_mistakes *mistakes, enum nb_status status) {
  fuzz_hold(status == NB_OK || status == NB_BAD_USE, "the status is 0 or 2");
  fuzz_hold((status == NB_OK) == (mistakes->count == 0), "the status agrees with the number of errors");
  fuzz_hold((mistakes->text != NULL) == (mistakes->count > 0), "errors have a text");
  size_t given = 0, length = mistakes->text ? strlen(mistakes->text) : 0;
  for (const char *c = mistakes->text; c && *c; c = strchr(c, '\n') + 1) {
    const char *end = strchr(c, '\n');
    fuzz_hold(end != NULL, "every line of the messages ends");
    if (*c != ' ') /* a message about this page, or about a page from which it starts */
      hold_message(c, end), given++;
    for (const char *d = c; *d != '\n'; d++)
      fuzz_hold((unsigned char)*d >= 0x20 || *d == '\t', "no control characters in messages");
  }
  fuzz_hold(given == mistakes->count, "every error is reported once");
  fuzz_hold(length < (size_t)4 << 20, "the messages have a limited length");
}

static char path[NB_PATH_SIZE];

static void remove_file(void) { remove(path); }

const char *fuzz_file(void) {
  static int file = -1;
  const char *folder = getenv("TMPDIR");
  if (file < 0) {
    snprintf(path, sizeof path, "%s/nineball-fuzz-XXXXXX", folder ? folder : "/tmp");
    file = mkstemp(path);
    atexit(remove_file);
  }
  fuzz_hold(file >= 0 && pwrite(file, input, input_size, 0) == (ssize_t)input_size &&
                !ftruncate(file, (off_t)input_size),
            "the temporary file can be written");
  return path;
}

void fuzz_read_page(struct nb_page *page, struct nb_scene *scene, const char *name, const char *statements) {
  struct nb_mistakes mistakes = {0};
  char text[2000];
  const int n = snprintf(text, sizeof text, "# Seed\n\n%s```\n", statements);
  if (nb_page_read_bytes(page, name, text, (size_t)n, &mistakes) ||
      (scene && nb_scene_read(scene, page, 0, NULL, &mistakes))) {
    printf("%sBail out! a page of this test is wrong\n", mistakes.text);
    exit(1);
  }
}
