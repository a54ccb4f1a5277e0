/* Runs of a page for the calibration of `nineball advise`: its limit, the true error and the cheapest setting.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CALIBRATION_RUNS_H
#define NB_CALIBRATION_RUNS_H

#include "../../src/report/advise.h"
#include "counts.h"

/* Levels: the first one of the truth, and the finest one of the grid. */
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

/* `count` trials, evenly spaced. */
static inline bool run_trials(struct nb_advice *advice, struct nb_variant *variant, int level, size_t count) {
  return level <= NB_LEVEL_HIGH && nb_trials_run(advice, variant, level, 0, advice->trials / count, count);
}

/* The truth and the grid may take longer than the advice, by this time in s. */
void allow_time(struct nb_advice *advice, struct nb_advise_query *query, double seconds);

/* The limit of the page for a small step. */
struct truth {
  double *values; /* of each run */
  double change;  /* largest, when the step was last halved, over the tolerance */
  int level;
  double tolerance;
};

/* Runs this level and the one before. False: they cannot be run, and nothing is changed. */
bool take_truth(struct truth *truth, struct nb_advice *advice, int level);
/* False: it is not known well enough. */
bool find_truth(struct truth *truth, struct nb_advice *advice);
/* The largest error of a setting over all runs and phases, over the tolerance. The computation ends once it is above
 * `most`; if `most` is negative, only the first phase is computed. Infinite: the setting cannot be run. */
double true_error(struct nb_advice *advice, const struct truth *truth, struct nb_variant *variant, int level,
                  double most);
/* The fewest updates of a setting of the grid whose true error is within the tolerance; `most`: none has as few. */
double cheapest(struct nb_advice *advice, const struct truth *truth, double most);

/* ---- controls.c ---- */

/* A setting that an estimator chooses. */
struct chosen {
  struct nb_variant *variant; /* NULL: none */
  int level;
  double ratio; /* of the estimated error to the tolerance */
};

/* What the estimator chooses, where there is advice. One that takes the finest setting untried claims the tolerance. */
struct chosen choose(struct nb_advice *advice, enum estimator estimator);

#endif
