/* Between the verdict on one run (verdict.c) and the verdict on a sweep (verdict_sweep.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_VERDICT_H
#define NB_VERDICT_H

#include "outcome.h"

void nb_check_say(struct nb_check *check, bool passed, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Of the reference, or 0 for a residual; NULL: not known. */
const double *nb_check_known(const struct nb_page_run *run, const struct nb_measure *measure);

bool nb_over_sweep(enum nb_expectation_kind kind);
/* A group of runs that differ in the swept name only is judged once, at its first run; one that --set has left a single value has
 * nothing to be judged by. */
bool nb_sweep_leads(const struct nb_outcome *outcome, size_t run, const char *name);
void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);
void nb_check_slope(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);

#endif
