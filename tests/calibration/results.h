/* The results of the calibration of `nineball advise`, which accuracy.c collects and document.c writes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <gsl/gsl_rng.h>

#include "../../src/report/advise.h"
#include "counts.h"

/* Numbers of draws for each page: about step and laws, and about a mean over realizations. Then the number of
 * realizations of the true mean, and the largest number of draws of all pages. */
enum { DRAWS = 3, MEAN_DRAWS = 12, TRUTH_REALIZATIONS = 64, DRAWS_MAX = 4000 };
/* Limits of the computing time of a draw, s: for the search, the truth, and the grid. Then the range of tolerances for
 * steps and laws, and the smallest tolerance for means. */
static const double search_time = 2, truth_time = 1, grid_time = 3;
static const double lowest_tolerance = 1e-4, highest_tolerance = 0.3, lowest_of_mean = 0.005;
static const double truth_margin =
    10; /* a true error is known if it is at least this many times the truth's last change */

/* Errors of quantities at one phase, by the number of steps per collision, in bins of factors of two. */
enum { BINS = 10, ERRORS_MAX = 8000 };
static const double first_bin = 2;

enum { REALIZATIONS = 3 }; /* numbers of realizations that are drawn: the smallest, twice and four times as many */
/* The whole estimator, which uses Student's t, and two negative controls: the difference of the means alone, and the
 * difference of one realization. */
enum mean_control { WITH_STUDENT, MEAN_ALONE, ONE_REALIZATION, MEAN_CONTROLS };
struct mean_draw {
  char page[64];
  size_t realizations; /* 8, 16 or 32 */
  bool answered;
  double errors[MEAN_CONTROLS]; /* true error over the tolerance; infinite: cannot be run; NaN: no setting is chosen */
  double claim, cost;           /* of the whole estimator: estimated over true error; updates over those of the page */
};

/* Reasons why draws are not counted: the limit is not known well enough; the program refuses. */
enum { UNRESOLVED, REFUSED, UNCOUNTED };
struct results {
  struct draw draws[DRAWS_MAX];
  size_t draw_count, uncounted[UNCOUNTED], pages;
  double errors[BINS][ERRORS_MAX];
  size_t error_count[BINS];
  struct mean_draw means[DRAWS_MAX];
  size_t mean_count;
};

/* Takes a row of a file of results. */
void take_row(struct results *results, char *row);
/* Writes docs/ACCURACY.md and the rows of accuracy_rows.h. True if all criteria hold; those that do not hold are
 * printed to standard error. */
bool write_document(FILE *out, FILE *header, struct results *results);

/* ---- means.c ---- */

/* Makes the draws about means over the realizations of a page. `quantities`: the measures of the page. */
void draw_means(FILE *out, const char *path, struct nb_outcome *page, gsl_rng *random, const char *quantities[],
                size_t quantity_count);
/* Starts the random numbers of a draw. */
void seed_draw(gsl_rng *random, const char *page, int number);
