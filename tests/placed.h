/* Discs at random positions that overlap by at most a given fraction of the smaller radius, because the program
 * refuses deep overlaps at the start.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>

#include "chance.h"

struct placed {
  double fraction, side; /* largest overlap allowed, over the smaller radius; side of a periodic square, or 0 */
  int count;
  double disc[2000][3]; /* x, y, radius */
};

/* Places one more disc of this radius, with its centre in the square from (low, low) to (high, high). */
static inline void placed_find(struct placed *placed, struct chance *chance, double low, double high, double radius) {
  double *to = placed->disc[placed->count];
  for (bool taken = true; taken;) {
    taken = false;
    to[0] = chance_between(chance, low, high), to[1] = chance_between(chance, low, high), to[2] = radius;
    for (int k = 0; k < placed->count && !taken; k++) {
      const double *other = placed->disc[k], side = placed->side;
      const double x = to[0] - other[0], y = to[1] - other[1];
      const double distance = side > 0 ? hypot(remainder(x, side), remainder(y, side)) : hypot(x, y);
      taken = radius + other[2] - distance > placed->fraction * fmin(radius, other[2]);
    }
  }
  placed->count++;
}
