/* Functions that shear_randall.c and shear_randall_literal.c share: the increment of T and the slip factor theta.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdint.h>
#include <string.h>

#include "law.h"

/* x^(1/3), within three units of the last place. The function uses only sums, products and quotients, and returns the
 * same bits on all machines, whereas the functions cbrt of different libraries round differently. The start value, from
 * the exponent, has an error of at most 3.3 %; each step of Halley's method changes a relative error e to (2/3) e^3. */
static inline double cube_root(double x) {
  const double size = fabs(x);
  uint64_t bits;
  double y;
  memcpy(&bits, &size, sizeof bits);
  bits = bits / 3 + 0x2a9f7893782da1ceu;
  memcpy(&y, &bits, sizeof y);
  for (int k = 0; k < 3; k++)
    y *= (y * y * y + 2 * size) / (2 * (y * y * y) + size);
  return size > 0 ? copysign(y, x) : 0;
}

/* x times a sign, CDF or UFL of shear_randall.c. `back`: true if the sign is -1. */
static inline double flip_if(bool back, double x) { return back ? -x : x; }

/* theta = c/a; c is the radius of the stick region and a that of the contact circle, m. `force` is the change of T up
 * to the beginning of the step, N: since virgin loading began (times = 1, [R89 4.22]), or since the last reversal
 * (times = 2, [R89 4.23, 4.24]). `rise` is mu dN of the step, N; `limit` is mu N after the step, N. */
static inline double stuck_fraction(double force, double times, double rise, double limit) {
  return cube_root(1 - (force + times * rise) / (times * limit));
}

/* dT [R89 4.15], which equals [R89 3.94] because CDF CDF = 1: elastic = 8 G* a ds, frictional = CDF UFL mu dN. */
static inline double increment(double theta, double elastic, double frictional) {
  return theta * (elastic - frictional) + frictional;
}
