/* Random numbers that are the same on every machine.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdint.h>

struct nb_random {
  uint64_t state; /* initially the seed, any value */
};

uint64_t nb_random_bits(struct nb_random *random);   /* 64 random bits */
double nb_random_fraction(struct nb_random *random); /* uniform in [0, 1), a multiple of 2^-53 */
