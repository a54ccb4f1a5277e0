/* Wall-clock time: for reports, for the budget of `advise`, and to decide when a checkpoint is due and whether threads
 * are worth their cost. No result of a run depends on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <time.h>

/* Seconds since an arbitrary time. */
static inline double nb_clock(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
