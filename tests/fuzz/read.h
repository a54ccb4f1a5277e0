/* What the two files of the fuzzer share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_FUZZ_READ_H
#define NB_FUZZ_READ_H

#include <stddef.h>

/* Reads the bytes as a page, and aborts when something does not hold. */
void fuzz_read(const unsigned char *bytes, size_t size);

/* change.c: one change at random, of a byte, a word or a line. Answers the new size, at most `most`. */
size_t fuzz_change(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance);
unsigned long long fuzz_chance(unsigned long long *chance); /* a number, and the next one from it (xorshift64*) */

#endif
