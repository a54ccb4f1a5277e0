/* What a page leaves behind: tables, values, snapshots, the figure's script.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_TABLES_H
#define NB_TABLES_H

#include "outcome.h"

/* Into the folder: table.tsv, values.tsv, verdict.tsv, and STAGE-bodies.tsv, -walls, -contacts for each snapshot,
 * of a path LEG-traction.tsv, -pieces. */
enum nb_status nb_tables_save(const struct nb_outcome *outcome, const char *folder, struct nb_error *error);

/* The rows of one run under one head row, known curves beside what was seen of them. */
void nb_table_write_run(FILE *out, const struct nb_page_run *run);
/* One row a run: swept values, then every measure that is expected, seen and known. */
void nb_values_write(FILE *out, const struct nb_outcome *outcome);
void nb_table_write(FILE *out, const struct nb_table *table);

/* What every file begins with, behind `# `: program, page, the settings it was given and the hash of both, and whether it is
 * incomplete. */
void nb_preamble_write(FILE *out, const struct nb_outcome *outcome);

/* figure.c: NAME.gp in the folder, and by gnuplot NAME.svg and NAME.png. NB_OK without doing anything when the page has no figure
 * (then *drawn is false). Only `figure` and `report` do this: gnuplot runs the page's own code, confined (confine.h), or also
 * unconfined where the page is trusted and nothing can confine it. */
bool nb_figure_wanted(const struct nb_page *page); /* whether it has a block of kind `gnuplot` */
enum nb_status nb_figure_draw(const struct nb_outcome *outcome, const char *folder, bool trust, bool *drawn,
                              struct nb_error *error);
/* gnuplot.c: runs FOLDER/NAME.gp, which may read `recipes`, after the given commands; what is drawn goes into `figure`, and what
 * gnuplot says to stderr if `aloud`. */
struct nb_gnuplot {
  const char *folder, *name, *recipes, *commands;
  int figure; /* file descriptor */
  bool trust, aloud;
};
enum nb_status nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error);

/* report.c: one page about all of them; folders are relative to it. */
struct nb_report_line {
  char name[NB_NAME_SIZE], title[128], message[512];
  size_t checks, marked[NB_MARKS]; /* in all, and of each mark */
  enum nb_status status;
  bool stopped, kept, drawn; /* it did not run to its end; there are tables, a figure */
  double seconds;
  struct nb_warnings warnings;
  struct nb_check *verdicts; /* owned by who reports */
};
enum nb_status nb_report_write(const char *folder, const struct nb_report_line *lines, size_t count,
                               struct nb_error *error);

#endif
