/* The search for the cheapest setting within a tolerance, and what it finds.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ADVISE_H
#define NB_ADVISE_H

#include "estimate.h"
#include "outcome.h"

/* The step of the page is divided by 2^level, or by the next larger number that divides its stages into whole numbers
 * of cycles. A trial is one phase, or one realization. */
enum { NB_LEVEL_LOW = -7, NB_LEVEL_HIGH = 12, NB_LEVELS = NB_LEVEL_HIGH - NB_LEVEL_LOW + 1 };
enum { NB_REALIZATIONS_MIN = 8, NB_VARIANTS_MAX = 500, NB_TRADES = 8 };

/* One variant at one step, run in some of the trials. */
struct nb_point {
  unsigned done;               /* bit set of the trials that were run */
  double *values;              /* of the quantity: NB_TRIALS for each run of the page; owned */
  double seconds;              /* shortest of the trials, all runs of the page; 0: none yet */
  double updates;              /* of contacts and particles, all runs; mean over the trials */
  double recorded;             /* values in the rows of all runs; of the last trial */
  double step;                 /* mean over the first run, s; 0: a contact test, which has no time */
  double stability[NB_TRIALS]; /* of each trial: the largest step over the guaranteed stable one, of all runs */
  char reason[512];            /* why it could not be run; empty: it could */
};

/* The page with other laws, softer contacts or centred dashpots, or with other values of names that it trades. */
struct nb_variant {
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* empty: as on the page */
  double soften;                                  /* the stiffness of the page is divided by it; 0: it is not */
  bool centred;                                   /* --set damping=centred */
  int history;                                    /* doubles that its laws store per contact */
  size_t value[NB_TRADES]; /* for each `trade` of the page: 0: the page's own value; k: its k-th one */
  struct nb_point points[NB_LEVELS];
  bool covered;     /* the reference of the page, if it has one, accepts it */
  bool equal;       /* it gives the same values as a variant before it */
  double distance;  /* from the anchor, over the tolerance, if it was left out for this reason; else 0 */
  char reason[512]; /* why it was left out; empty: it was not */
};

/* A setting with its estimated error. */
struct nb_setting {
  size_t variant;
  int level;
  double ratio;      /* the largest estimated error over the tolerance, of all runs */
  double step_ratio; /* the part of it that is due to the step; of a mean over realizations: without its scatter */
  size_t worst;      /* the run where it is */
};

struct nb_advise_query {
  const char *path;
  nb_settings settings; /* not NULL */
  struct nb_options options;
  const char *quantity; /* NULL: that of the first expectation */
  const char *within;   /* "1 %", "0.01", "20 N" */
  const char *over;     /* the name whose values 1, 2, … are realizations; NULL: each run counts */
  size_t realizations;  /* NB_REALIZATIONS_MIN to NB_TRIALS */
  double budget;        /* s */
  struct nb_progress progress;
};

struct nb_advice {
  const struct nb_advise_query *query;
  char text[512];             /* "impact.psi2 within 1 %" */
  const char **page_settings; /* those of the caller, and the first realization; owned */
  char first_realization[NB_NAME_SIZE + 8];
  struct nb_outcome page; /* as read with these settings */
  struct nb_tolerance tolerance;
  const char *unit;
  unsigned long divisor; /* the greatest common one of all numbers of cycles; 0: there are none */
  size_t runs;
  size_t trials;   /* realizations; or NB_PHASES; or 1: the page has no first touch whose moment could vary */
  double *allowed; /* the tolerance, for each run; owned */
  int anchor;      /* level of the coarsest anchor */
  struct nb_variant *variants; /* owned; the first one is the page's own */
  size_t variant_count;
  struct nb_setting *settings; /* owned; all that have an estimated error */
  size_t setting_count;
  int chosen;        /* the index of the cheapest one within the tolerance; -1: none */
  double began;      /* s */
  bool exhausted;    /* the budget ended the search */
  bool no_memory;    /* memory ran out, which ended the search, too */
  unsigned measured; /* runs of the page */
};

static inline const struct nb_point *nb_point_at(const struct nb_advice *advice, const struct nb_setting *setting) {
  return &advice->variants[setting->variant].points[setting->level - NB_LEVEL_LOW];
}

/* Searches. NB_BAD_USE: a mistake in the query, or in the page; the latter are in advice->page. NB_FAILED: the quantity
 * is not known well enough. Free the advice in any case; the query must outlive it. */
enum nb_status nb_advise(struct nb_advice *advice, const struct nb_advise_query *query, struct nb_error *error);
void nb_advice_free(struct nb_advice *advice);
/* Runs a trial of a variant at a level, unless it has been run. False: it cannot be run, or the budget is used up. */
bool nb_advice_run(struct nb_advice *advice, size_t variant, int level, size_t trial);

/* The divisor of the page's step at a level. */
double nb_level_refine(const struct nb_advice *advice, int level);
/* The steps of a level, of the next finer one and of that after it. */
struct nb_ratios nb_level_ratios(const struct nb_advice *advice, int level);

/* The numbers of updates decide. If they are nearly equal, as those of different laws with the same step, contacts as
 * stiff as those of the page count as cheaper than softer ones. After that, laws that store less per contact do.
 * Measured times do not decide, because another call would give other advice. */
bool nb_setting_cheaper(const struct nb_advice *advice, const struct nb_setting *a, const struct nb_setting *b);
/* The most expensive setting that is cheaper than this one, of equal ones the most accurate; NULL: none. */
const struct nb_setting *nb_advice_cheaper(const struct nb_advice *advice, const struct nb_setting *setting);
/* The first of the most accurate settings; NULL: none. */
const struct nb_setting *nb_advice_most_accurate(const struct nb_advice *advice);
/* The largest standard deviation of single realizations, of all runs, at the setting. */
double nb_advice_scatter(const struct nb_advice *advice, const struct nb_setting *setting);
/* The page's step divided by a number in words: "that of the page", "2 times as long as that of the page". */
void nb_refine_text(char *text, size_t size, double refine);
/* "0.023 s (0.022 to 0.025)": median and range of an odd number of times, which are sorted. */
void nb_times_text(char *text, size_t size, double times[], size_t count);
/* What to do if no setting is within the tolerance. */
const char *nb_advice_remedy(const struct nb_advice *advice);
/* Variants without a setting: equal to another one, refused by the page, too far from the anchor; the nearest of the
 * latter, or NULL. */
struct nb_left_out {
  size_t equal, refused, farther;
  const struct nb_variant *nearest;
};
struct nb_left_out nb_advice_left_out(const struct nb_advice *advice);
/* Whether softer contacts save nothing: the step is a fraction of the collision, so both of them become longer. */
bool nb_advice_softness_is_useless(const struct nb_advice *advice);
/* Whether the setting may fail checks of the page that the page passes as it is. */
static inline bool nb_setting_loosens(const struct nb_setting *setting) {
  return setting->level < 0 || setting->variant > 0;
}

/* ---- advice.c ---- */

/* The settings as options: "--set shear=mindlin --set refine=0.25". */
void nb_advice_options(char *text, size_t size, const struct nb_advice *advice, const struct nb_setting *setting);
/* The unit of its error: "%", that of the quantity, or "". */
const char *nb_advice_unit(const struct nb_advice *advice);
/* Draws FOLDER/NAME.svg and NAME.png: the estimated error against cost. */
enum nb_status nb_advice_draw(const struct nb_advice *advice, const char *folder, const char *name, bool trust,
                              struct nb_error *error);

/* ---- trials.c ---- */

size_t nb_phase_count(const struct nb_scene *scene);
/* Runs `count` trials of a variant at a level, from `first` on, `stride` apart, unless they have been run. False: one
 * cannot be run, or the budget is used up. */
bool nb_trials_run(struct nb_advice *advice, struct nb_variant *variant, int level, size_t first, size_t stride,
                   size_t count);
/* The time of the first trial, s: it is run once more, and no value is stored. NaN: it fails. */
double nb_trials_time(struct nb_advice *advice, struct nb_variant *variant, int level);
/* Memory that runs out ends the search; other failures belong to the candidate. Returns false. */
bool nb_advice_no_memory(struct nb_advice *advice);

#endif
