/* The clock on the wall, for what a run costs; no result depends on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CLOCK_H
#define NB_CLOCK_H

#include <time.h>

/* Since some moment of the past, s. */
static inline double nb_clock(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#endif
