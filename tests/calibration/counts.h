/* The counts of the calibration of `nineball advise` (tests/accuracy.c), and its criteria.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The whole estimator, and the negative controls, from which a part is missing and which must not pass. */
enum estimator { WHOLE, ONE_PHASE, NO_ANCHOR, TWO_STEPS, OWN_REFERENCE, ALWAYS_FINE, ESTIMATORS };

/* The setting that an estimator chooses. */
struct choice {
  double error; /* true error over the tolerance; infinite: the setting cannot be run; NaN: no setting is chosen */
  double cost;  /* cost over that of the cheapest setting with a true error within the tolerance; NaN: there is none */
  double claim; /* estimated error over the true error; NaN: the true error is too small to be known */
};

/* A page and a question about it that is drawn at random (tests/accuracy.c), and the answers of the estimators. */
struct draw {
  char page[64], kind[64];
  bool held_out;  /* the page was not used in tuning */
  bool met;       /* the true error of some setting is within the tolerance */
  double seconds; /* time of the search, s */
  struct choice choices[ESTIMATORS];
};

/* True if the page, by its name, belongs to the half that was not used in tuning. */
bool is_held_out(const char *page);

enum { QUANTILES = 3 };
extern const double quantile_fractions[QUANTILES]; /* 5 %, 50 %, 90 % */

/* The counts of one estimator. */
struct score {
  size_t draws, answered, within; /* number of draws; of answers; of answers whose true error is within the tolerance */
  size_t met, met_answered;       /* draws with `met`; those of them that are answered */
  /* The fraction of answers within the tolerance in the kind of page where this fraction is smallest; 1: no answers. */
  double worst_fraction;
  char worst_kind[64];
  size_t costs, claims; /* answers with a known `cost`; with a known `claim` */
  double cost[QUANTILES], claim[QUANTILES];
};

/* The half of the draws that is counted. */
enum half { TUNED, HELD_OUT, BOTH_HALVES };
struct score score_of(const struct draw draws[], size_t count, enum estimator estimator, enum half half);
/* The score of the draws of one kind of page; its members worst_… have no meaning. */
struct score score_of_kind(const struct draw draws[], size_t count, const char *kind);

/* True if the criterion WITHIN holds for `answered` answers, `within` of which are within the tolerance. */
bool is_enough(size_t within, size_t answered);

/* The criteria of the calibration. */
enum criterion { WITHIN, WITHIN_KIND, ANSWERS, COST_MEDIAN, COST_MOST, CLAIM_MEDIAN, CLAIM_LEAST, CRITERIA };
extern const char *const criterion_names[CRITERIA];
bool criterion_holds(const struct score *score, enum criterion criterion);
/* Prints the criteria that do not hold, separated by "; "; returns their number. */
size_t write_failures(FILE *out, const struct score *score);

/* The quantile of the values that are not NaN: the value with the nearest rank. NaN: there are no values. Sorts the
 * values, NaN last. */
double quantile(double *values, size_t count, double fraction);
