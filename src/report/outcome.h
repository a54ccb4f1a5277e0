/* A page carried out: all its runs, what the reference knows of each, and the verdict.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OUTCOME_H
#define NB_OUTCOME_H

#include "expect.h"
#include "reference.h"

/* One run: one choice of the swept values. */
struct nb_page_run {
  struct nb_scene scene;
  struct nb_expectations expectations;
  struct nb_solution solution;
  struct nb_result result;
  char label[256];       /* "v=0.12 n=40", empty without a sweep */
  double done;           /* fraction, 1 */
  enum nb_status status; /* of the run itself; */
  struct nb_error error; /* in words */
};

/* What came of an expectation. Only the first two are judgements. */
enum nb_mark {
  NB_FAIL,
  NB_PASS,
  NB_NOTE, /* a value, or where a number lies in a sample: never a failure */
  NB_SKIP, /* not checked, and the words say why */
  NB_MARKS
};

/* One expectation compared with what was computed. */
struct nb_check {
  char label[640];   /* "C.normal mean within 0.1 %" and the run */
  char message[512]; /* "computed 1.002 N, reference 1.003 N, error 0.05 %, tolerance 0.1 %" */
  enum nb_mark mark;
  int line;
};

struct nb_outcome {
  struct nb_page page;
  nb_settings settings;        /* those it was made with: the caller's */
  struct nb_mistakes mistakes; /* of the page, when status is NB_BAD_USE */
  struct nb_page_run *runs;    /* owned, as is all below */
  size_t run_count;
  struct nb_check *checks;
  size_t check_count, mark_count[NB_MARKS]; /* checks in all, and of each mark */
  struct nb_warnings warnings;              /* of all runs, each once */
  enum nb_status status;                    /* the worst that came up */
  struct nb_error error;                    /* in words, when it is NB_BAD_USE without mistakes, or NB_BROKEN */
};

/* Reads the page, runs it, options->jobs of its runs at a time, judges it. What can be known of it is in the outcome whatever the status; free it in any case. */
enum nb_status nb_outcome_make(struct nb_outcome *outcome, const char *path, nb_settings settings,
                               const struct nb_options *options, const struct nb_progress *progress);
/* Only read: pages, scenes, expectations. What `run` and `explain` begin with. */
enum nb_status nb_outcome_read(struct nb_outcome *outcome, const char *path, nb_settings settings);
void nb_outcome_free(struct nb_outcome *outcome);
void nb_outcome_free_runs(struct nb_outcome *outcome); /* page, checks, warnings and error stay */

/* ---- reducers.c: from the rows of a table to one number ---- */

/* False when the table has no rows to reduce, or none at that moment, or when a value is not finite; then the error says so. */
bool nb_measure_value(double *value, const struct nb_measure *measure, const struct nb_table *table,
                      struct nb_error *error);
/* The rows of a stage, or of the last stage that has any: first and one past the last. */
void nb_measure_rows(const struct nb_measure *measure, const struct nb_table *table, size_t *from, size_t *to);
/* What the reference knows under the measure's label, with the stage or without; NULL: nothing. */
const double *nb_measure_solution(const struct nb_measure *measure, const struct nb_solution *solution);

/* What is swept, in this run: "v=0.12, n=40"; without what the expectation is judged over, if there is one. */
void nb_sweep_label(char *text, size_t size, const struct nb_page_run *run, const struct nb_expectation *expectation);

/* ---- verdict.c ---- */
enum nb_status nb_verdict(struct nb_outcome *outcome);
const char *nb_mark_word(enum nb_mark mark); /* "pass" */

#endif
