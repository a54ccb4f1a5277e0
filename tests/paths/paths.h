/* Paths of overlap and tangential displacement, the tests along them, and the quantities measured on them
 * (tests/contact_paths.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../contact.h"

/* ---- kinds.c: random paths ---- */

struct path {
  int kind;
  struct chance chance;
  /* For the current contact: number of points left, and its random numbers. */
  int left, count;
  double x, u, amplitude, decay, depth, frequency, phase, drift, period;
};
/* A point of a path: overlap, in units of the mean overlap, and total tangential displacement, in units of the
 * displacement at which a contact with the mean overlap slides. */
struct point {
  double x, u;
  bool first; /* of a new contact; x = 0: the contact opens */
};

enum { KIND_WALK, KIND_IMPACT, KIND_RINGING, KIND_BOTH, KIND_RATCHET, KIND_ROLLING, KIND_DECADES, KINDS };
extern const char *const kind_names[KINDS], *const kind_titles[KINDS];
struct path path_of(int kind, unsigned seed);
struct point path_next(struct path *path);

/* ---- laws.c: what a law promises, tested on such paths ---- */

/* Violations of what a law promises (laws/law.h). Each contact has two energy accounts, one for the normal force and
 * one for the shear force. A law that promises to create no energy never returns more energy than it was given since
 * first touch, except for the error of the finite steps. */
struct findings {
  long steps, contacts;
  double excess;     /* largest |T|/(mu N + c) - 1 */
  long not_finite;   /* steps with a force, stiffness or history that is no finite number */
  long outside;      /* steps with a history that is longer than declared, or not valid */
  long not_emptied;  /* contacts that opened and kept a force */
  double created[2]; /* largest energy created by a contact, over the energy that it was given; [1]: friction above 1 */
  long creations;    /* segments at whose end a contact had created energy beyond the error of the steps */
  double grown;      /* largest growth of the stored energy beyond the work, over the energy given */
};
/* The findings for a normal law with a shear law. The steps of the kind DECADES are too large for an energy account. */
struct findings law_on_paths(const struct nb_law *normal, const struct nb_law *shear, int kind, long steps);
void findings_add(struct findings *sum, const struct findings *more);
/* Tolerance of `grown` for a law that merges pieces of its history. */
extern const double most_joined;
/* The first promise that is broken, in words; NULL: none. `joins`: the law merges pieces of its history. */
const char *broken_promise(const struct findings *findings, bool joins);

/* ---- memory.c: the exact law with a limited number of pieces, compared with a list of all rings ---- */

enum { MEMORIES = 5 };
extern const int memories[MEMORIES]; /* the last one is never full */

struct error {
  double worst, square; /* largest error of T over mu N; sum of the squares of these errors */
  long count, rings;    /* number of errors; largest number of rings in the list */
};
struct errors {
  struct error of[MEMORIES];
};
/* One contact under test. */
struct replay;
struct replay *replay_new(const struct nb_law *shear); /* `shear` is used as the exact law; free with replay_free */
void replay_free(struct replay *replay);
void replay_begin(struct replay *replay); /* a new contact begins */
/* Makes a step to this overlap, by the tangential increment ds. */
void replay_go(struct replay *replay, struct nb_pair pair, double overlap, double ds, struct errors *errors);
/* The errors in `steps` steps on random paths of this kind. */
struct errors exact_on_paths(const struct nb_law *shear, int kind, long steps);

/* ---- runs.c: the paths of contacts in runs of the program ---- */

enum { RUNS = 3 };
extern const char *const run_names[RUNS], *const run_titles[RUNS];
/* The errors of every contact of the run, in at most `cycles` cycles. */
struct errors exact_in_run(const struct nb_law *shear, int run, long cycles);
