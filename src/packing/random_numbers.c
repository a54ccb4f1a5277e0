/* The random number generator SplitMix64. Each call adds an odd constant to the state, so the state takes all 2^64
 * values; the result is a bijective mix of the bits of the state. Source: Steele, Lea and Flood, Fast splittable
 * pseudorandom number generators, OOPSLA 2014, with the mixing constants of Stafford's variant 13, as in
 * java.util.SplittableRandom. The mixing separates neighbouring seeds, so 1, 2, 3 are good seeds.
 *
 * The generator uses integers and one exact multiplication by a power of two, so it gives the same bits with every
 * compiler on every machine.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "random_numbers.h"

uint64_t nb_random_bits(struct nb_random *random) {
  uint64_t z = random->state += UINT64_C(0x9e3779b97f4a7c15); /* 2^64 over the golden ratio */
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

double nb_random_fraction(struct nb_random *random) {
  return (double)(nb_random_bits(random) >> 11) * 0x1p-53; /* the upper 53 bits, as many as a double has */
}
