/* Tables that a test gives to the runs of a page as their results, and the verdict on them. Nothing is simulated.
 *
 * The page has one disc A. Its columns are A.x, A.y, A.vx and energy.balance, beside time and cycle, and its stages
 * are `one` and `two`. Row r has the cycle 10 r and the time r; rows 0 to 2 belong to stage one, the others to stage
 * two. The test chooses A.x, and energy.balance equals it; A.y is 1, 2, 4, 2, 1 and then 0, and A.vx is -4.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

#include "report/outcome.h"

#define COUNT(list) (sizeof list / sizeof *list)

enum { PLANTED_MOST = 12 }; /* the largest number of rows, and of runs of a sweep */

/* Reads the page with these statements in its scene, for example sweeps, and these expectations. Its runs have no rows
 * yet. */
void planted_page(struct nb_outcome *outcome, const char *statements, const char *expectations);
/* Sets A.x in each row of one run. */
void planted_rows(struct nb_outcome *outcome, size_t run, int count, const double *x);
/* Sets A.x in the only row of each run. */
void planted_runs(struct nb_outcome *outcome, const double *x);
/* Sets the value that the reference solution of each run returns for `name`. */
void planted_solution(struct nb_outcome *outcome, const char *name, double value);
/* Sets the reference curve of A.x against time: its value at row r is values[r]. */
void planted_curve(struct nb_outcome *outcome, int count, const double *values);
/* Computes the verdict. The test fails, and prints the text of the checks, unless the first check has this mark. */
void planted_is(struct nb_outcome *outcome, enum nb_mark mark);
/* The test fails unless the text of the first check contains this text. */
void planted_says(const struct nb_outcome *outcome, const char *text);

/* The test fails unless the first check has these parts: computed, reference, error, tolerance. */
void planted_parts(const struct nb_outcome *outcome, const char *const parts[NB_PARTS]);

/* One expectation over sweeps, and its verdict. The reference value of A.x is 0. */
struct planted_sweep {
  const char *statements, *expectation;
  double x[PLANTED_MOST]; /* A.x of each run; the last sweep varies fastest */
  enum nb_mark mark;
  const char *words; /* the text of the check must contain these words */
};
/* Tests each entry of the list: the verdict must have the mark and the words. */
void planted_sweeps(const struct planted_sweep *list, size_t count);

/* Tests one expectation of a page without sweeps. The run has `count` rows, in which A.x is x[0], x[1], …. The
 * reference solution returns `value` for `name`, or no value if `name` is NULL. The verdict must have the mark and the
 * words. */
void planted_one(const char *expectation, const char *name, double value, int count, const double *x, enum nb_mark mark,
                 const char *words);
