/* The search for the cheapest setting within a tolerance, and its results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "estimate.h"
#include "outcome.h"

/* At a level the step of the page is divided by 2^level. If the stages would then not have whole numbers of cycles, it
 * is divided by the next larger number with which they have. A trial runs the page with one phase (estimate.c), or with
 * one realization. */
enum { NB_LEVEL_LOW = -7, NB_LEVEL_HIGH = 12, NB_LEVELS = NB_LEVEL_HIGH - NB_LEVEL_LOW + 1 };
enum { NB_REALIZATIONS_MIN = 8, NB_VARIANTS_MAX = 500, NB_TRADES = 8 };

/* One variant at one step, run in some of the trials. */
struct nb_point {
  unsigned done;               /* bit set of the trials that were run */
  double *values;              /* values of the quantity: NB_TRIALS for each run of the page; owned */
  double seconds;              /* time of all runs of the page in the shortest trial, s; 0: no trial yet */
  double updates;              /* updates of contacts and particles in all runs, mean over the trials */
  double recorded;             /* number of values in the rows of all runs, in the last trial */
  double step;                 /* mean step of the first run, s; 0: a contact test, which has no time */
  double stability[NB_TRIALS]; /* for each trial: largest ratio of the step to the guaranteed stable step in all runs */
  char reason[512];            /* the reason why the point could not be run; empty: it could be run */
};

/* The page with other laws, softer contacts or centred dashpots, or with other values of the names in its `trade`
 * statements. */
struct nb_variant {
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* empty: the laws of the page */
  double soften;                                  /* divisor of the page's stiffnesses; 0: they are not changed */
  bool centred;                                   /* --set damping=centred */
  int history;                                    /* number of doubles that the laws store per contact */
  size_t value[NB_TRADES]; /* for each `trade` of the page: 0: the page's own value; k: value number k of the `trade` */
  struct nb_point points[NB_LEVELS];
  bool covered;  /* the reference solution of the page, if there is one, accepts the variant */
  bool equal;    /* the variant gives the same values as an earlier one */
  bool too_late; /* the budget was used up before the variant had a result */
  /* distance from the anchor (estimate.h) over the tolerance, if the variant was left out for this reason; else 0 */
  double distance;
  char reason[512]; /* the reason why the variant was left out; empty: it was not left out */
};

/* A setting is a variant at a level. Its estimated error is stored with it. */
struct nb_setting {
  size_t variant;
  int level;
  double ratio; /* largest ratio of the estimated error to the tolerance in all runs */
  /* the part of this ratio that is due to the step; for a mean over realizations, the part that is due to the
   * difference between the means of the setting and of the anchor */
  double step_ratio;
  size_t worst; /* the run with the largest ratio */
};

struct nb_advise_query {
  const char *path;
  nb_settings settings; /* not NULL */
  struct nb_options options;
  const char *quantity; /* NULL: that of the first expectation of a single value */
  const char *within;   /* "1 %", "0.01", "20 N" */
  /* the name whose values 1, 2, … select the realizations; NULL: the quantity is not a mean over realizations */
  const char *over;
  size_t realizations; /* NB_REALIZATIONS_MIN to NB_TRIALS */
  double budget;       /* largest time of the search, s */
  struct nb_progress progress;
};

struct nb_advice {
  const struct nb_advise_query *query;
  char text[512];             /* "impact.psi2 within 1 %" */
  const char **page_settings; /* settings of the caller, and the first realization; owned */
  char first_realization[NB_NAME_SIZE + 8];
  struct nb_outcome page; /* the page, read with these settings */
  struct nb_tolerance tolerance;
  const char *unit;
  unsigned long divisor; /* greatest common divisor of all numbers of cycles that the page gives; 0: it gives none */
  size_t runs;
  size_t trials;   /* number of realizations; or NB_PHASES; or 1, if the moment of first touch cannot vary */
  double *allowed; /* the tolerance of each run, in the unit of the quantity; owned */
  int anchor;      /* level of the coarsest anchor that is certain enough */
  struct nb_variant *variants; /* owned; the first one is the page's own */
  size_t variant_count;
  struct nb_setting *settings; /* all settings that have an estimated error; owned */
  size_t setting_count;
  int chosen;        /* index of the cheapest setting within the tolerance; -1: none */
  double began;      /* time at which the search began, s */
  bool exhausted;    /* the budget ended the search */
  bool no_memory;    /* memory ran out, which also ended the search */
  unsigned measured; /* number of runs of the page so far */
};

static inline const struct nb_point *nb_point_at(const struct nb_advice *advice, const struct nb_setting *setting) {
  return &advice->variants[setting->variant].points[setting->level - NB_LEVEL_LOW];
}

/* Searches for the cheapest setting. NB_OK: the search has ended; advice->chosen is -1 if no setting is within the
 * tolerance. NB_BAD_USE: a mistake in the query or in the page; mistakes of the page are in advice->page. NB_FAILED:
 * the page cannot be run with its own step and with half of it, or the uncertainty of the anchor is too large for the
 * tolerance. The caller frees the advice in any case; the query must outlive it. */
enum nb_status nb_advise(struct nb_advice *advice, const struct nb_advise_query *query, struct nb_error *error);
void nb_advice_free(struct nb_advice *advice);

/* The divisor of the page's step at a level. */
double nb_level_refine(const struct nb_advice *advice, int level);
/* The ratios of the steps of three levels: this level, the next finer one and the one after that. */
struct nb_ratios nb_level_ratios(const struct nb_advice *advice, int level);

/* True if setting a is cheaper than setting b. The setting with fewer updates is cheaper, if the numbers differ by more
 * than a tenth. For different laws with the same step they are nearly equal. Then the setting with the stiffer contacts
 * counts as cheaper. If the stiffnesses are equal too, the setting whose laws store less per contact counts as cheaper.
 * Measured times are not compared, because another call would then give other advice. */
bool nb_setting_cheaper(const struct nb_advice *advice, const struct nb_setting *a, const struct nb_setting *b);
/* The setting with the most updates of all that miss the tolerance and have fewer updates than `setting`; of several
 * with this number, the most accurate one. NULL: there is none. A setting that meets the tolerance with fewer updates
 * has nearly as many as the chosen one, and is not cheaper in the sense of nb_setting_cheaper. */
const struct nb_setting *nb_advice_cheaper(const struct nb_advice *advice, const struct nb_setting *setting);
/* The most accurate setting, the first one if there are several; NULL: none. */
const struct nb_setting *nb_advice_most_accurate(const struct nb_advice *advice);
/* The standard deviation of the quantity over the realizations at the setting; if the page has several runs, the
 * largest. */
double nb_advice_scatter(const struct nb_advice *advice, const struct nb_setting *setting);
/* Writes in words the page's step divided by a number: "that of the page", "2 times as long as that of the page". */
void nb_refine_text(char *text, size_t size, double refine);
/* Writes "0.023 s (0.022 to 0.025)", the median and the range of an odd number of times. Sorts the times. */
void nb_times_text(char *text, size_t size, double times[], size_t count);
/* The text that says what to do if no setting is within the tolerance. */
const char *nb_advice_remedy(const struct nb_advice *advice);
/* Numbers of variants without a setting: equal to another variant; cannot be run; have no result, because the budget
 * was used up; too far from the anchor. `nearest`: the nearest of the last kind, or NULL. */
struct nb_left_out {
  size_t equal, refused, too_late, farther;
  const struct nb_variant *nearest;
};
struct nb_left_out nb_advice_left_out(const struct nb_advice *advice);
/* True for a page with `impact` and without realizations in which softer contacts save nothing: its step is a fraction
 * of the duration of a collision, so that step and collision become longer in proportion. */
bool nb_advice_softness_is_useless(const struct nb_advice *advice);
/* True if the page may fail checks with this setting that it passes with its own step, laws and values. */
static inline bool nb_setting_loosens(const struct nb_setting *setting) {
  return setting->level < 0 || setting->variant > 0;
}

/* ---- advice.c ---- */

/* Writes the setting as options: "--set shear=mindlin --set refine=0.25". */
void nb_advice_options(char *text, size_t size, const struct nb_advice *advice, const struct nb_setting *setting);
/* The unit of estimated errors: "%", the unit of the quantity, or "". */
const char *nb_advice_unit(const struct nb_advice *advice);
/* Writes FOLDER/NAME.gp and draws NAME.svg and NAME.png: the estimated error against cost. */
enum nb_status nb_advice_draw(const struct nb_advice *advice, const char *folder, const char *name, bool trust,
                              struct nb_error *error);

/* ---- trials.c ---- */

size_t nb_phase_count(const struct nb_scene *scene); /* NB_PHASES, or 1 if the page allows no other phase */
/* Runs `count` trials of a variant at a level, from number `first` on, `stride` apart, unless they have been run.
 * False: one of them cannot be run, the budget is used up, or memory ran out. */
bool nb_trials_run(struct nb_advice *advice, struct nb_variant *variant, int level, size_t first, size_t stride,
                   size_t count);
/* Runs the first trial once more and returns its time, s. No value is stored. NaN: the trial fails. */
double nb_trials_time(struct nb_advice *advice, struct nb_variant *variant, int level);
/* Records that memory ran out, which ends the search; other failures only exclude a setting. Returns false. */
bool nb_advice_no_memory(struct nb_advice *advice);
