/* Functions shared by the programs of the fuzzer.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_FUZZ_H
#define NB_FUZZ_H

#include <stddef.h>

#include "../../src/nineball.h"

/* Reads the bytes as a page, and aborts if an invariant is violated. */
void fuzz_read(const unsigned char *bytes, size_t size);

/* hold.c: invariants of reading. If one is violated, the program ends with `not ok`, and the input of the last
 * fuzz_begin is in fuzz-broken. */
void fuzz_begin(const void *bytes, size_t size);
void fuzz_hold(bool holds, const char *what);
void fuzz_hold_mistakes(const struct nb_mistakes *mistakes, enum nb_status status);

/* change.c: one random change of a byte, a word or a line. Returns the new size, at most `most`. */
size_t fuzz_change(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance);
size_t fuzz_change_number(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance); /* of a number */
unsigned long long fuzz_chance(unsigned long long *chance); /* a random number; updates the state (xorshift64*) */

#endif
