/* The outcome of a page: all its runs, the reference solutions, and the verdict.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "expect.h"
#include "reference.h"
#include "run/restart.h"

/* One run: one combination of the swept values. */
struct nb_page_run {
  struct nb_scene scene;
  struct nb_expectations expectations;
  struct nb_solution solution;
  struct nb_result result;
  /* has the recorded tables of the result, from byte `at` on; NULL: the tables are in `result` */
  struct nb_spool *spool;
  long at;
  char label[256];       /* "v=0.12, n=40", empty without a sweep */
  bool released;         /* the scene has its particles only during the run */
  double done;           /* completed fraction of the cycles, 0 to 1 */
  enum nb_status status; /* status of the run, without the verdict */
  struct nb_error error; /* message, if the run failed */
};

/* The result of an expectation. Only the first two count as checks. */
enum nb_mark {
  NB_FAIL,
  NB_PASS,
  NB_NOTE, /* a value, or the percentile of a number in a sample; if it is undefined, the mark is NB_FAIL */
  NB_SKIP, /* not checked; the message gives the reason */
  NB_MARKS
};

/* Numbers in the message of a check, with their units. */
enum nb_part_kind { NB_PART_COMPUTED, NB_PART_REFERENCE, NB_PART_ERROR, NB_PART_TOLERANCE, NB_PARTS };

/* One expectation and its result. */
struct nb_check {
  char label[640];   /* "C.normal mean within 0.1 %" and the run */
  char message[512]; /* "computed 1.002 N, reference 1.003 N, error 0.05 %, tolerance 0.1 %" */
  struct nb_part {
    unsigned short at, length;
  } parts[NB_PARTS]; /* parts of the message, for a table; length 0: the message has no such part */
  /* for a trend: pairs of a swept value, or of its position in the sweep if it is a word, and the computed value or its
   * error; owned */
  double *points;
  size_t point_count;
  enum nb_mark mark;
  int line;
};

struct nb_outcome {
  struct nb_page page;
  nb_settings settings;        /* settings of the caller, which must outlive the outcome */
  struct nb_mistakes mistakes; /* mistakes in the page, if status is NB_BAD_USE */
  struct nb_page_run *runs;    /* owned, like everything below */
  size_t run_count;
  struct nb_check *checks;
  size_t check_count, mark_count[NB_MARKS]; /* all, also notes and skips; those of each mark */
  struct nb_warnings warnings;              /* warnings of all runs, each once */
  /* the status of reading; nb_outcome_make replaces it by that of the locks, the runs or the verdict: of the first of
   * them that fails, or else of the verdict */
  enum nb_status status;
  struct nb_error error; /* the message, if status is above NB_FAILED and there are no mistakes */
  struct nb_lock lock;   /* lock of the checkpoints, until they are removed */
  bool locked;
  struct nb_lock output; /* lock of the folder of output files */
  bool output_locked;
  struct nb_spool {
    FILE *file;              /* NULL: no file was needed */
    long end;                /* number of bytes in the file */
    size_t kept;             /* number of bytes of results in memory */
    struct nb_result loaded; /* table and snapshots of the run that was read last */
    const struct nb_page_run *loaded_run;
    bool has_snapshots;
    struct nb_error error; /* error while reading; status NB_OK: none */
  } spool;
  bool noted; /* the user has been told that results stay in memory */
};

bool nb_is_stopped(const struct nb_options *options); /* a signal has stopped the program; options may be NULL */

/* Reads the page, runs it, options->jobs runs at a time, and checks its expectations. `options` and `progress` may be
 * NULL. After an error the outcome has the results that were computed before. The locks stay until the checkpoints are
 * removed or the outcome is freed. The caller frees the outcome in any case. */
enum nb_status nb_outcome_make(struct nb_outcome *outcome, const char *path, nb_settings settings,
                               const struct nb_options *options, const struct nb_progress *progress);
/* Only reads the page: the scenes and the expectations of all runs. */
enum nb_status nb_outcome_read(struct nb_outcome *outcome, const char *path, nb_settings settings);
/* Reads all runs of the page of the outcome, up to the first run with mistakes, because most mistakes would be in every
 * run. Only the first runs, which have `particles_kept` particles in all, keep their particles. */
void nb_outcome_read_runs(struct nb_outcome *outcome, size_t particles_kept);
/* Runs what has been read, without a verdict. */
enum nb_status nb_outcome_run(struct nb_outcome *outcome, const struct nb_options *options,
                              const struct nb_progress *progress);
/* Deletes the checkpoints of all runs, and releases the locks. */
void nb_outcome_remove_checkpoints(struct nb_outcome *outcome, const struct nb_options *options);
/* Number of threads for runs side by side, at least 1 and at most `most`. */
int nb_job_count(const struct nb_options *options, size_t most);
void nb_outcome_free(struct nb_outcome *outcome);
/* Frees the runs and releases the locks. Keeps page, checks, mistakes, warnings and error. */
void nb_outcome_free_runs(struct nb_outcome *outcome);

/* ---- spool.c: results of runs that are not in memory ---- */

/* Writes the tables that the run has recorded to the file of the spool, unless all results in memory and this one
 * together have at most limit->bytes. After an error the result stays in memory. */
enum nb_status nb_spool_put(struct nb_spool *spool, struct nb_page_run *run, const struct nb_results_kept *limit,
                            struct nb_error *error);
/* The first function returns the table of a run, the second one the result with its snapshots. They are valid until one
 * of these functions is called for another run. Only the recorded tables of the result may be used. If the file cannot
 * be read, the tables are empty and the spool has the error. */
const struct nb_table *nb_run_table(const struct nb_page_run *run);
const struct nb_result *nb_run_result(const struct nb_page_run *run);
/* The status of all readings so far. */
enum nb_status nb_spool_status(const struct nb_spool *spool, struct nb_error *error);
void nb_spool_free(struct nb_spool *spool);

/* ---- reducers.c: from the rows of a table to one number ---- */

/* Computes the value of the measure. False with an error if the table has no rows for the measure, or if a value or the
 * result is not finite; *value is then NaN. */
bool nb_measure_value(double *value, const struct nb_measure *measure, const struct nb_table *table,
                      struct nb_error *error);
/* Finds the rows of the measure's stage: *from is the first one, *to is one past the last one. Without a stage they are
 * the rows of the last stage that has rows; for `in all`, and for `at` without a stage, all rows. */
void nb_measure_rows(const struct nb_measure *measure, const struct nb_table *table, size_t *from, size_t *to);
/* The value that the reference solution has for the measure's label, with or without the stage; NULL: it has none. */
const double *nb_measure_solution(const struct nb_measure *measure, const struct nb_solution *solution);

/* Writes the swept values of the run, "v=0.12, n=40", without sweeps that --set has replaced and without those over
 * which the expectation compares runs; `expectation` may be NULL. */
void nb_sweep_label(char *text, size_t size, const struct nb_page_run *run, const struct nb_expectation *expectation);

/* ---- verdict.c ---- */

/* Checks all expectations: sets checks and mark_count. NB_FAILED: a check failed. */
enum nb_status nb_verdict(struct nb_outcome *outcome);
const char *nb_mark_word(enum nb_mark mark); /* "FAIL", "pass", "note", "skip" */
