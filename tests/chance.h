/* Random numbers that are the same on every machine and in every run: xorshift64* with a seed that the test chooses.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>
#include <stdint.h>

struct chance {
  uint64_t state; /* never 0 */
};

static inline struct chance chance_begin(unsigned seed) {
  return (struct chance){0x9e3779b97f4a7c15u ^ seed * 0xd1342543de82ef95u};
}

/* Uniformly distributed in [low, high). */
static inline double chance_between(struct chance *chance, double low, double high) {
  chance->state ^= chance->state >> 12, chance->state ^= chance->state << 25, chance->state ^= chance->state >> 27;
  return low + (high - low) * ((double)(chance->state * 0x2545f4914f6cdd1du >> 11) / 9007199254740992.0);
}

/* A number in [low, high) whose logarithm is uniformly distributed, for quantities that span orders of magnitude. */
static inline double chance_scale(struct chance *chance, double low, double high) {
  return exp(chance_between(chance, log(low), log(high)));
}
