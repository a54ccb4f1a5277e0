/* Reads the inputs of the fuzzer's corpus, and random changes of them, with every reader. For any bytes a reader
 * returns a valid value or a message.
 *
 *   tests/fuzz/replay                        all readers; TAP
 *   tests/fuzz/replay READER FILE ...        one reader, with these inputs
 *   tests/fuzz/replay --seeds READER FOLDER  writes the inputs that the program itself makes
 *   tests/fuzz/replay --words                prints the dictionary for libFuzzer
 *
 * The corpus is in tests/fuzz/corpus below $srcdir. The reader of pages also gets the pages of tests/bad and cases. An
 * input that violates an invariant is written to fuzz-broken.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "fuzz.h"

enum { INPUTS_MAX = 4000, CHANGES_MAX = 6, REPEATS = 8, PATH_SIZE = 4096 };

static const struct fuzz_reader *const readers[] = {&fuzz_pages,  &fuzz_expressions, &fuzz_paths, &fuzz_packings,
                                                    &fuzz_states, &fuzz_checkpoints, &fuzz_tables};
enum { READERS = sizeof readers / sizeof *readers };

struct corpus {
  const struct fuzz_reader *reader;
  unsigned char *bytes[INPUTS_MAX];
  size_t size[INPUTS_MAX], count;
  bool valid[INPUTS_MAX];
};

static void stop(const char *what, const char *path) {
  printf("Bail out! %s: %s\n", path, what);
  exit(1);
}

/* Reserves memory for one more input. */
static unsigned char *more(struct corpus *corpus, const char *path) {
  unsigned char *bytes = corpus->count < INPUTS_MAX ? malloc(corpus->reader->longest) : NULL;
  if (!bytes)
    stop("too many inputs, or no memory", path);
  return corpus->bytes[corpus->count] = bytes;
}

static void take_file(struct corpus *corpus, const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file)
    stop("cannot be read", path);
  corpus->size[corpus->count] = fread(more(corpus, path), 1, corpus->reader->longest, file);
  corpus->count++;
  fclose(file);
}

static int by_name(const void *a, const void *b) { return strcmp(a, b); }

/* Takes the files of a folder and of the folders in it, sorted by name, so that the random changes are the same on
 * every machine. `ending`: the names end in this text; "": any names. */
static void take_folder(struct corpus *corpus, const char *folder, const char *ending) {
  static const size_t longest = 256;
  char path[PATH_SIZE], *names = NULL;
  size_t count = 0;
  DIR *directory = opendir(folder);
  for (struct dirent *entry; directory && (entry = readdir(directory));)
    if (entry->d_name[0] != '.') {
      names = realloc(names, (count + 1) * longest);
      snprintf(names + count++ * longest, longest, "%s", entry->d_name);
    }
  if (!directory)
    stop("cannot be read", folder);
  closedir(directory);
  qsort(names, count, longest, by_name);
  for (size_t k = 0; k < count; k++) {
    struct stat status;
    snprintf(path, sizeof path, "%s/%s", folder, names + k * longest);
    const size_t length = strlen(path), end = strlen(ending);
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode))
      take_folder(corpus, path, ending);
    else if (length > end && strcmp(path + length - end, ending) == 0)
      take_file(corpus, path);
  }
  free(names);
}

static void take_all(struct corpus *corpus) {
  const char *top = getenv("srcdir");
  char path[PATH_SIZE];
  size_t size;
  while ((size = corpus->reader->seed(corpus->count, (char *)more(corpus, "seeds"))) > 0)
    corpus->size[corpus->count++] = size;
  free(corpus->bytes[corpus->count]);
  snprintf(path, sizeof path, "%s/tests/fuzz/corpus/%s", top ? top : ".", corpus->reader->name);
  take_folder(corpus, path, "");
  if (corpus->reader != &fuzz_pages)
    return;
  snprintf(path, sizeof path, "%s/tests/bad", top ? top : ".");
  take_folder(corpus, path, ".md");
  snprintf(path, sizeof path, "%s/cases", top ? top : ".");
  take_folder(corpus, path, ".md");
}

static bool read_bytes(const struct fuzz_reader *reader, const unsigned char *bytes, size_t size) {
  fuzz_begin(bytes, size);
  return reader->read(bytes, size);
}

/* Reads the inputs, and prints the result as test number `test`. Some inputs must be valid and others not; otherwise
 * the test proves nothing. */
static void replay(struct corpus *corpus, int test) {
  size_t valid = 0;
  for (size_t k = 0; k < corpus->count; k++)
    valid += corpus->valid[k] = read_bytes(corpus->reader, corpus->bytes[k], corpus->size[k]);
  printf("%s %d - %zu inputs of %s, %zu of them valid\n", valid > 0 && valid < corpus->count ? "ok" : "not ok", test,
         corpus->count, corpus->reader->name, valid);
}

/* Reads random changes of the inputs. Some of them must be valid. */
static void replay_changed(const struct corpus *corpus, int test) {
  const struct fuzz_reader *reader = corpus->reader;
  unsigned char *bytes = malloc(reader->longest);
  unsigned long long chance = 1;
  int valid = 0;
  for (int n = 0; n < reader->changes && bytes; n++) {
    size_t from = (size_t)(fuzz_chance(&chance) % corpus->count);
    for (int k = 0; k < REPEATS && !corpus->valid[from]; k++) /* valid inputs are few, and reach more code */
      from = (size_t)(fuzz_chance(&chance) % corpus->count);
    size_t size = corpus->size[from];
    memcpy(bytes, corpus->bytes[from], size);
    for (unsigned long long left = 1 + fuzz_chance(&chance) % CHANGES_MAX; left > 0; left--)
      size = (fuzz_chance(&chance) % 3 ? fuzz_change : fuzz_change_number)(bytes, size, reader->longest, &chance);
    valid += read_bytes(reader, bytes, size);
  }
  free(bytes);
  printf("%s %d - %d changed inputs of %s, %d of them valid\n", valid > 0 ? "ok" : "not ok", test, reader->changes,
         reader->name, valid);
}

static void free_corpus(struct corpus *corpus) {
  for (size_t k = 0; k < corpus->count; k++)
    free(corpus->bytes[k]);
  corpus->count = 0;
}

static const struct fuzz_reader *reader_named(const char *name) {
  for (int r = 0; r < READERS; r++)
    if (strcmp(readers[r]->name, name) == 0)
      return readers[r];
  stop("expected the name of a reader", name);
  return NULL;
}

static void write_seeds(const struct fuzz_reader *reader, const char *folder) {
  char *text = malloc(reader->longest), path[PATH_SIZE];
  size_t size;
  for (size_t k = 0; text && (size = reader->seed(k, text)) > 0; k++) {
    snprintf(path, sizeof path, "%s/seed%zu", folder, k);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(text, 1, size, file) != size || fclose(file) != 0)
      stop("cannot be written", path);
  }
  free(text);
}

int main(int count, char **words) {
  static struct corpus corpus;
  if (count == 2 && strcmp(words[1], "--words") == 0) {
    fuzz_print_words();
  } else if (count == 4 && strcmp(words[1], "--seeds") == 0) {
    write_seeds(reader_named(words[2]), words[3]);
  } else if (count > 2) {
    corpus.reader = reader_named(words[1]);
    for (int k = 2; k < count; k++) {
      take_file(&corpus, words[k]);
      printf("%s: %s\n", words[k],
             read_bytes(corpus.reader, corpus.bytes[k - 2], corpus.size[k - 2]) ? "valid" : "refused");
    }
    free_corpus(&corpus);
  } else {
    for (int r = 0; r < READERS; r++) {
      corpus.reader = readers[r];
      take_all(&corpus);
      replay(&corpus, 2 * r + 1), replay_changed(&corpus, 2 * r + 2);
      free_corpus(&corpus);
    }
    printf("1..%d\n", 2 * READERS);
  }
  return 0;
}
