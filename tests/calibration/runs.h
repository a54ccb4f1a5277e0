/* Runs of a page for the calibration of `nineball advise`: its limit, the true error and the cheapest setting.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../../src/report/advise.h"
#include "counts.h"

/* The first level that is tried as the truth, and the finest level of the grid. At level k the step of the page is
 * divided by 2^k (advise.h). */
enum { TRUTH_FIRST = 4, FINEST = 3, SETTINGS_MAX = 64 };

static inline const struct nb_point *point_of(const struct nb_variant *variant, int level) {
  return &variant->points[level - NB_LEVEL_LOW];
}

static inline double value_of(const struct nb_variant *variant, int level, size_t run, size_t trial) {
  return point_of(variant, level)->values[run * NB_TRIALS + trial];
}

static inline bool run_one(struct nb_advice *advice, struct nb_variant *variant, int level, size_t trial) {
  return level <= NB_LEVEL_HIGH && nb_trials_run(advice, variant, level, trial, 1, 1);
}

/* Runs `count` of the trials, evenly spaced. False: one of them cannot be run. */
static inline bool run_trials(struct nb_advice *advice, struct nb_variant *variant, int level, size_t count) {
  return level <= NB_LEVEL_HIGH && nb_trials_run(advice, variant, level, 0, advice->trials / count, count);
}

/* Allows the truth and the grid to take longer than the advice, by this time, s. */
void allow_time(struct nb_advice *advice, struct nb_advise_query *query, double seconds);

/* The limit of the page for a small step. */
struct truth {
  double *values; /* value of each run */
  double change;  /* largest change when the step was last halved, over the tolerance */
  int level;
  double tolerance; /* relative */
};

/* Takes the truth from this level and the one before. False: one of them cannot be run, and *truth stays as it is. */
bool take_truth(struct truth *truth, struct nb_advice *advice, int level);
/* Finds the truth. False: it is not known well enough. */
bool find_truth(struct truth *truth, struct nb_advice *advice);
/* The largest error of a setting over all runs and phases, over the tolerance. The computation ends when this error
 * exceeds `most`; if `most` is negative, only the first phase is computed. Infinite: the setting cannot be run. */
double true_error(struct nb_advice *advice, const struct truth *truth, struct nb_variant *variant, int level,
                  double most);
/* The fewest updates of a setting of the grid whose true error is within the tolerance; `most` if no setting has
 * fewer. */
double cheapest(struct nb_advice *advice, const struct truth *truth, double most);

/* ---- controls.c ---- */

/* A setting that an estimator chooses. */
struct chosen {
  struct nb_variant *variant; /* NULL: none */
  int level;
  double ratio; /* estimated error over the tolerance */
};

/* The setting that the estimator chooses, if there is advice. The estimator ALWAYS_FINE takes the finest setting
 * without running it, and counts the tolerance as its estimated error. */
struct chosen choose(struct nb_advice *advice, enum estimator estimator);
