/* Between the verdict on one run (verdict.c) and on those of a sweep (verdict_sweep.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_VERDICT_H
#define NB_VERDICT_H

#include "outcome.h"

void nb_check_result(struct nb_check *check, bool passed, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* The rule of every tolerance: |computed - reference| as a multiple of the error that is allowed, so at most 1 when the
 * expectation holds. `scale`: what a tolerance in per cent is a fraction of. Infinite when one of the numbers is not finite. */
double nb_error_ratio(const struct nb_tolerance *tolerance, double computed, double reference, double scale);
/* The unit of what is measured behind a space, or nothing; in a text of NB_NAME_SIZE. */
const char *nb_check_unit(char *text, const struct nb_page_run *run, const struct nb_expectation *expectation);
/* Behind a comma the error, called `what`, and its tolerance: with the unit, or as fractions of the scale, in per cent unless very small. */
void nb_check_error(struct nb_check *check, const char *what, double error, double scale,
                    const struct nb_tolerance *tolerance, const char *unit);
/* What is measured in this run, as a fraction of another measure where one is named; false with words when it is not a finite number. */
bool nb_check_computed(double *value, struct nb_check *check, const struct nb_page_run *run,
                       const struct nb_expectation *expectation);
/* Of the reference, or 0 for a residual; NULL: not known. */
const double *nb_check_solution(const struct nb_page_run *run, const struct nb_measure *measure);

/* ---- verdict_sweep.c ---- */

bool nb_is_over_sweep(const struct nb_expectation *expectation);
/* A group of runs that differ in the swept names only is judged once, at its first run. */
bool nb_sweep_is_first(const struct nb_outcome *outcome, size_t run, const struct nb_expectation *expectation);
/* The swept name of which all runs of the group have one value, so that nothing can be compared; NULL: none. */
const char *nb_sweep_single_value(const struct nb_outcome *outcome, size_t first,
                                  const struct nb_expectation *expectation);
void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);

#endif
