/* Declarations that the commands of the program share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "cost.h"
#include "input/text.h"
#include "outcome.h"
#include "run/output_file.h"

/* The command line. */
struct nb_call {
  char **pages;
  size_t page_count;
  const char *folder;    /* output folder, or file; NULL: the default */
  const char *stage;     /* the stage at whose end a state is taken; NULL: the last stage */
  const char **settings; /* NULL-terminated */
  const char **unrun;    /* pages that a report shows without running them; NULL-terminated */
  struct nb_options options;
  bool *repeats; /* set when a signal has stopped a page: whether it is a contact test, which has no checkpoint */
  bool tap;
  bool in_place;
  bool all;           /* `advise --all`: many pages */
  bool trust;         /* draw even if gnuplot cannot be confined; copy linked files of any folder */
  bool help, version; /* print help or version and do nothing else */
  const char *quantity, *within, *budget, *over; /* options of `advise` */
  int realizations;                              /* number of realizations for `advise --over`; 0: not given */
  const char *rounding;                          /* option of `check`: "all" or "parts"; NULL: to nearest only */
  unsigned given; /* bit set of the options that the call has, by their index in the table of main.c */
};

/* ---- commands.c: one function for each command ---- */

enum nb_status nb_command_run(const struct nb_call *call);
enum nb_status nb_command_check(const struct nb_call *call);
enum nb_status nb_command_figure(const struct nb_call *call);
enum nb_status nb_command_report(const struct nb_call *call); /* report.c */
enum nb_status nb_command_explain(const struct nb_call *call);
enum nb_status nb_command_state(const struct nb_call *call);
enum nb_status nb_command_migrate(const struct nb_call *call);
enum nb_status nb_command_advise(const struct nb_call *call);                                         /* advice.c */
enum nb_status nb_command_advise_all(const struct nb_call *call, double budget, size_t realizations); /* advise_all.c */
enum nb_status nb_command_laws(const struct nb_call *call);
enum nb_status nb_command_list(const struct nb_call *call);

/* Runs a page. If `folder` is NULL, there are no output files, and the outcome keeps only what the verdict needs. The
 * caller frees the outcome in any case. */
void nb_run_page(struct nb_outcome *outcome, const struct nb_call *call, const char *path, const char *folder);
/* True if tables can be written: all runs have ended, or a run was aborted and some run has rows. */
bool nb_outcome_has_rows(const struct nb_outcome *outcome);
/* True if the page ran without an error and none of its expectations was checked. Such a page must not pass. */
bool nb_outcome_is_unchecked(const struct nb_outcome *outcome);
/* Deletes the checkpoints of the outcome's runs. Called when all output has been written. Does nothing if the status is
 * an error, or if the output on stdout cannot be written. */
void nb_remove_checkpoints(struct nb_outcome *outcome, enum nb_status status, const struct nb_call *call);

/* ---- rounding.c ---- */

enum nb_status nb_rounding_check(const struct nb_call *call); /* `check --rounding` */

/* ---- manual.c ---- */

/* Prints the manual of the page language: as Markdown, with arguments and examples; or for a terminal, without them. */
void nb_manual(FILE *out, bool markdown);
/* Prints the help for a word that pages, version 0.3 or another program use, or for several words. False: there is no
 * help; `hint` (NB_HINT_SIZE bytes) then has the nearest word, or is empty. */
bool nb_manual_word(FILE *out, const char *text, char *hint);

/* ---- print.c: verdicts and progress on the terminal ---- */

/* Prints one warning per line: "PAGE:7: warning: …", each after the prefix `before`. */
void nb_print_warnings(FILE *out, const char *before, const char *path, const struct nb_warnings *warnings);
/* Repeats on stdout the warnings that were printed to stderr, unless both are the same terminal, file or pipe. */
void nb_repeat_warnings(const char *before, const char *path, const struct nb_warnings *warnings);
void nb_print_verdict(const struct nb_outcome *outcome);
void nb_print_tap(const struct nb_outcome *outcome, const char *path);
/* Prints to stderr an error that belongs to no page, and returns its status. */
enum nb_status nb_print_plain_error(const struct nb_error *error);
/* Prints to stderr the mistakes or the error of an outcome, and its warnings. */
void nb_print_errors(const struct nb_outcome *outcome, const char *path);
/* Prints to stderr an error of a page. */
void nb_print_error(const struct nb_error *error, const struct nb_page *page, const char *path);
struct nb_progress_line {
  const char *page;
  double shown;                       /* time of the run when the line was last written, s; 0: never */
  const struct nb_warnings *warnings; /* those found before the run, which precede the first line; NULL: none */
};
struct nb_progress nb_print_progress(struct nb_progress_line *line); /* only notes if stderr is not a terminal */
void nb_print_progress_end(struct nb_progress_line *line);

/* Prints the text with each character of the list replaced by its text `by`; the list ends in a row of zeros. */
struct nb_escape {
  char character;
  const char *by;
};
void nb_print_escaped(FILE *out, const char *text, const struct nb_escape *list);

/* ---- tables.c ---- */

/* Begins the output file FOLDER/NAME. */
enum nb_status nb_save_begin_in(struct nb_save *file, struct nb_error *error, const char *folder, const char *format,
                                ...) __attribute__((format(printf, 4, 5)));
/* Ends the file as nb_save_end does, unless a result of the outcome could not be read; then the file is discarded. */
enum nb_status nb_outcome_save_end(const struct nb_outcome *outcome, struct nb_save *file, struct nb_error *error);
/* Writes into the folder: table.tsv, values.tsv, verdict.tsv; for each snapshot STAGE-particles.tsv, -walls.tsv and
 * -contacts.tsv, if it has them also -rings.tsv, -boundary.tsv and -lattice.tsv, and of a contact test
 * SEGMENT-traction.tsv and -pieces.tsv. If the page has several runs, the names of snapshots end in the number of the
 * run: STAGE-particles-2.tsv. `names` receives the names of the files, one per line. */
enum nb_status nb_tables_save(const struct nb_outcome *outcome, const char *folder, struct nb_text *names,
                              struct nb_error *error);
/* Writes a head row and the rows of one run, with reference curves beside the computed quantities. */
void nb_table_write_run(FILE *out, const struct nb_page_run *run);
/* Writes a head row and one row for each run: the swept values, the number of the run, then every measure of the expect
 * blocks except curves, computed and reference. */
void nb_values_write(FILE *out, const struct nb_outcome *outcome);
void nb_table_write(FILE *out, const struct nb_table *table);
/* Writes the first lines of every file, after `# `: program, page, settings, the hash of page and settings, and whether
 * the file is incomplete. */
void nb_preamble_write(FILE *out, const struct nb_outcome *outcome);

/* ---- figure.c ---- */

/* Writes to `plots` the path of the folder with the figure style and the plot recipes, with a slash at the end. It is
 * the folder beside the program, as in the build tree, or the installed folder, but never a folder of the page. If
 * neither is found, `plots` is empty and *error says so. */
void nb_plots_find(char *plots, size_t size, struct nb_error *error);
bool nb_page_has_figure(const struct nb_page *page); /* the page has a `gnuplot` block */
/* Writes NAME.gp into the folder, and lets gnuplot draw NAME.svg and NAME.png. If the page has no figure, nothing is
 * written and NB_OK is returned. *drawn is true only if both were drawn. Only the commands `figure` and `report` call
 * it, because gnuplot then runs code of the page. gnuplot is confined (sandbox.h), or unconfined if the page is trusted
 * and the system cannot confine it. */
enum nb_status nb_figure_draw(const struct nb_outcome *outcome, const char *folder, bool trust, bool *drawn,
                              struct nb_error *error);

/* What nb_script_draw writes to FOLDER/NAME.gp: the style of figures, then the lines that `write` adds. Then
 * nb_script_draw draws NAME.svg and NAME.png, with gnuplot confined as in nb_figure_draw. */
struct nb_script {
  const char *name;
  const struct nb_outcome *outcome; /* for the first lines of the file */
  void (*write)(FILE *out, const struct nb_outcome *outcome, const void *data);
  const void *data;
};
enum nb_status nb_script_draw(const struct nb_script *script, const char *folder, bool trust, struct nb_error *error);

/* ---- gnuplot.c ---- */

/* A comment in a script: the next line of the script is this line of the page. */
#define NB_PAGE_LINE "# line %zu of the page:"
/* gnuplot runs `commands`, then FOLDER/NAME.gp, which may read `recipes`. The drawing goes to `figure`. The messages of
 * gnuplot go to stderr if `verbose`. */
struct nb_gnuplot {
  const char *folder, *name, *recipes, *commands;
  int figure; /* file descriptor */
  bool trust, verbose;
};
enum nb_status nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error);
