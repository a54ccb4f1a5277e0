/* Functions shared by the programs of the fuzzer: `replay`, which `make check` runs, and one program of libFuzzer for
 * each reader, which `make fuzz` runs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

#include "../../src/nineball.h"

/* A reader of input that a user can change. */
struct fuzz_reader {
  const char *name; /* name of the reader and of the folder with its inputs */
  size_t longest;   /* largest number of bytes of an input */
  int changes;      /* number of randomly changed inputs that `make check` reads */
  /* Reads the bytes and aborts if an invariant is violated. True if the input is valid. */
  bool (*read)(const unsigned char *bytes, size_t size);
  /* Writes to `text`, which has `longest` bytes, the input k that the fuzzer itself makes. Returns its size; 0: there
   * are no more. */
  size_t (*seed)(size_t k, char *text);
};
extern const struct fuzz_reader fuzz_pages, fuzz_expressions, fuzz_paths, fuzz_packings, fuzz_states, fuzz_checkpoints,
    fuzz_tables;

/* hold.c: invariants of reading. If one is violated, the program ends with `not ok`, and the input of the last
 * fuzz_begin is in fuzz-broken. */
void fuzz_begin(const void *bytes, size_t size);
void fuzz_hold(bool holds, const char *what);
void fuzz_hold_mistakes(const struct nb_mistakes *mistakes, enum nb_status status);
/* For a slow test: true if the present input gets this test. To save time only one of `count` inputs gets it; in
 * `replay` all inputs do. */
bool fuzz_one_of(int count);
extern bool fuzz_saves_time;
/* Writes the input of the last fuzz_begin to a temporary file. Returns its path. */
const char *fuzz_file(void);
/* Reads a page that the fuzzer itself contains. It must be valid. */
void fuzz_read_page(struct nb_page *page, struct nb_scene *scene, const char *path, const char *statements);

/* states.c: gives a state the right last line, which has the checksum. It does so in about half of the inputs, so that
 * wrong checksums are read, too. Returns the new size; `text` has space for FUZZ_END further bytes. */
enum { FUZZ_END = 23 };
size_t fuzz_seal(char *text, size_t size);

/* change.c: makes one random change of a byte, a word or a line. Returns the new size, at most `most`. */
size_t fuzz_change(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance);
/* Makes one random change of a number. Returns the new size, at most `most`. */
size_t fuzz_change_number(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance);
unsigned long long fuzz_chance(unsigned long long *chance); /* a random number; updates the state (xorshift64*) */
void fuzz_print_words(void); /* prints the words of the page language as a dictionary of libFuzzer */
