/* Between the verdict on one run (verdict.c), on a sweep (verdict_sweep.c), and on samples (verdict_sample.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_VERDICT_H
#define NB_VERDICT_H

#include "outcome.h"

void nb_check_say(struct nb_check *check, bool passed, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Of the reference, or 0 for a residual; NULL: not known. */
const double *nb_check_known(const struct nb_page_run *run, const struct nb_measure *measure);

bool nb_over_sweep(const struct nb_expectation *expectation);
/* A group of runs that differ in the swept names only is judged once, at its first run; one that --set has left a single value
 * has nothing to be judged by. */
bool nb_sweep_leads(const struct nb_outcome *outcome, size_t run, const struct nb_expectation *expectation);
/* There is one: expectations name only what is swept. */
const struct nb_binding *nb_sweep_binding(const struct nb_page_run *run, const char *name);
/* Whether two runs differ in nothing but these names, and in what goes with them in the same sweep. Empty: no such name. */
bool nb_sweep_same_but(const struct nb_page_run *a, const struct nb_page_run *b, const char *name, const char *other);
void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);
void nb_check_slope(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);

/* What all runs that it is about have in common, of what is swept: "v=0.12, n=40". */
void nb_sweep_group(char *text, size_t size, const struct nb_page_run *run, const struct nb_expectation *expectation);
void nb_check_sample(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);

#endif
