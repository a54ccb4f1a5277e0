/* The search for the cheapest setting within a tolerance, and what it finds.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ADVISE_H
#define NB_ADVISE_H

#include "estimate.h"
#include "outcome.h"

/* The step of the page is divided by 2^level. */
enum { NB_LEVEL_LOW = -7, NB_LEVEL_HIGH = 12, NB_LEVELS = NB_LEVEL_HIGH - NB_LEVEL_LOW + 1, NB_LAW_PAIRS = 40 };

/* One law pair at one step, run at some of the phases. */
struct nb_point {
  unsigned done;    /* bit set of the phases that were run */
  double *values;   /* of the quantity: NB_PHASES for each run of the page; owned */
  double seconds;   /* shortest of the phases, all runs of the page */
  double updates;   /* of contacts and particles, all runs */
  double step;      /* mean over the first run, s; 0: a contact test, which has no time */
  char reason[512]; /* why it could not be run; empty: it could */
};

struct nb_law_pair {
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* empty: as on the page */
  struct nb_point points[NB_LEVELS];
  bool covered;     /* the reference of the page, if it has one, accepts the laws */
  bool equal;       /* it gives the same values as a pair before it */
  double distance;  /* from the anchor, over the tolerance, if it was left out for this reason; else 0 */
  char reason[512]; /* why the pair was left out; empty: it was not */
};

/* A setting with its estimated error. */
struct nb_setting {
  size_t pair;
  int level;
  double ratio;      /* the largest estimated error over the tolerance, of all runs */
  double step_ratio; /* the part of it that is due to the step */
  size_t worst;      /* the run where it is */
};

struct nb_advise_query {
  const char *path;
  nb_settings settings; /* not NULL */
  struct nb_options options;
  const char *quantity; /* NULL: that of the first expectation */
  const char *within;   /* "1 %", "0.01", "20 N" */
  double budget;        /* s */
  struct nb_progress progress;
};

struct nb_advice {
  const struct nb_advise_query *query;
  char text[512];         /* "impact.psi2 within 1 %" */
  struct nb_outcome page; /* as read, with the settings of the caller */
  struct nb_tolerance tolerance;
  const char *unit;
  size_t runs;
  size_t phases;             /* NB_PHASES, or 1: the page has no first touch whose moment could vary */
  double *allowed;           /* the tolerance, for each run; owned */
  int anchor;                /* level of the coarsest anchor */
  struct nb_law_pair *pairs; /* owned; the first one is the page's own */
  size_t pair_count;
  struct nb_setting *settings; /* owned; all that have a estimated error */
  size_t setting_count;
  int chosen;        /* the index of the cheapest one within the tolerance; -1: none */
  double began;      /* s */
  bool exhausted;    /* the budget ended the search */
  bool no_memory;    /* memory ran out, which ended the search, too */
  unsigned measured; /* runs of the page */
};

static inline const struct nb_point *nb_point_at(const struct nb_advice *advice, const struct nb_setting *setting) {
  return &advice->pairs[setting->pair].points[setting->level - NB_LEVEL_LOW];
}

/* Searches. NB_BAD_USE: a mistake in the query, or in the page; the latter are in advice->page. NB_FAILED: the quantity
 * is not known well enough. Free the advice in any case; the query must outlive it. */
enum nb_status nb_advise(struct nb_advice *advice, const struct nb_advise_query *query, struct nb_error *error);
void nb_advice_free(struct nb_advice *advice);
/* Runs a pair of laws at a level and a phase, unless it has been run. False: it cannot be run, or the budget is used
 * up. */
bool nb_advice_run(struct nb_advice *advice, size_t pair, int level, size_t phase);

#endif
