/* Functions that the verdict on one run (verdict.c) and the verdict on a sweep (verdict_sweep.c) share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "outcome.h"

/* Sets mark and message of a check. */
void nb_check_result(struct nb_check *check, bool passed, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* |computed - reference| over the tolerance: at most 1 if the check passes. A relative tolerance is a fraction of
 * `scale`. Infinite if a number is not finite. */
double nb_error_ratio(const struct nb_tolerance *tolerance, double computed, double reference, double scale);
/* Number of digits, from `least` to 17, that show two significant digits of the difference of a and b. */
int nb_digit_count(double a, double b, int least);
/* Writes a space and the unit of the measure to `text`, of NB_NAME_SIZE bytes; empty if the value is dimensionless or
 * the page has `units none`. */
const char *nb_check_unit(char *text, const struct nb_page_run *run, const struct nb_expectation *expectation);
/* Appends the error, called `what`, and the tolerance to the message. If the tolerance is absolute, both have the unit.
 * Otherwise both are fractions of the scale, in per cent unless the tolerance is tiny or huge. */
void nb_check_error(struct nb_check *check, const char *what, double error, double scale,
                    const struct nb_tolerance *tolerance, const char *unit);
/* Finds the computed value of the measure, or, if the expectation has a scale, its ratio to the other measure of the
 * expectation. False with a message if the value is undefined. */
bool nb_check_computed(double *value, struct nb_check *check, const struct nb_page_run *run,
                       const struct nb_expectation *expectation);
/* The value of the reference solution, or else 0 for a residual; NULL: there is none. */
const double *nb_check_solution(const struct nb_page_run *run, const struct nb_measure *measure);

/* Checks an expectation about one run. `given` replaces the value of its measure unless it is NULL. */
void nb_check_run(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *expectation,
                  const double *given);

/* ---- verdict_rows.c ---- */

/* Warns of a largest or smallest value that would have another verdict with all cycles than with the recorded rows. */
void nb_check_rows(struct nb_warnings *warnings, const struct nb_page_run *run,
                   const struct nb_expectation *expectation, const struct nb_check *check);

/* ---- verdict_sweep.c ---- */

bool nb_is_over_sweep(const struct nb_expectation *expectation); /* the expectation compares runs of a sweep */
/* True if the run is the first one of its group. Runs that differ only in the sweeps of the expectation are a group,
 * which is checked once, at its first run. */
bool nb_sweep_is_first(const struct nb_outcome *outcome, size_t run, const struct nb_expectation *expectation);
/* The name of a sweep that has only one value in the group, so that nothing can be compared; NULL: none. */
const char *nb_sweep_single_value(const struct nb_outcome *outcome, size_t first,
                                  const struct nb_expectation *expectation);
/* Checks expectation number `index` in the group of runs whose first one is number `first`. */
void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index);
