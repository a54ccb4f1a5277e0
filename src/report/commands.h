/* The program: what its commands share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_COMMANDS_H
#define NB_COMMANDS_H

#include "outcome.h"
#include "run/output_file.h"

/* A call, read. */
struct nb_call {
  char **pages;
  size_t page_count;
  const char *folder;    /* or a file; NULL: the default */
  const char *stage;     /* at whose end; NULL: the last one */
  const char **settings; /* NULL-terminated */
  struct nb_options options;
  bool tap;
  bool in_place;
  bool trust;         /* draw without confinement where there is none */
  bool help, version; /* one of them is all that is wanted */
  unsigned given;     /* set of options, by their place in the table */
};

/* ---- commands.c: one function for each word of the command line ---- */

enum nb_status nb_command_run(const struct nb_call *call);
enum nb_status nb_command_check(const struct nb_call *call);
enum nb_status nb_command_figure(const struct nb_call *call);
enum nb_status nb_command_report(const struct nb_call *call);
enum nb_status nb_command_explain(const struct nb_call *call);
enum nb_status nb_command_state(const struct nb_call *call);
enum nb_status nb_command_migrate(const struct nb_call *call);
enum nb_status nb_command_laws(const struct nb_call *call);
enum nb_status nb_command_list(const struct nb_call *call);

/* ---- manual.c ---- */

/* All words of pages, as Markdown with what they take and with examples; for a terminal with one sentence each. */
void nb_manual(FILE *out, bool markdown);
/* All about one word: of a page, of one of version 0.3, or of another program. False: it is none; then `hint` (NB_HINT_SIZE bytes) holds the
 * nearest one, or is empty. */
bool nb_manual_word(FILE *out, const char *word, char *hint);

/* ---- print.c: verdicts and progress on the terminal ---- */

/* One a line: "PAGE:7: warning: …", with `before` before it. */
void nb_print_warnings(FILE *out, const char *before, const char *path, const struct nb_warnings *warnings);
/* Likewise on stdout, of those that stderr has had already: not when both are one terminal. */
void nb_repeat_warnings(const char *before, const char *path, const struct nb_warnings *warnings);
void nb_print_verdict(const struct nb_outcome *outcome);
void nb_print_tap(const struct nb_outcome *outcome, const char *path);
void nb_print_errors(const struct nb_outcome *outcome, const char *path); /* mistakes, or what broke, to stderr */
void nb_print_error(const struct nb_error *error, const struct nb_page *page, const char *path); /* likewise one */
struct nb_progress_line {
  const char *page;
  double shown; /* s of the run when it was last written; 0: never */
};
struct nb_progress nb_print_progress(struct nb_progress_line *line); /* does nothing when stderr is no terminal */
void nb_print_progress_end(struct nb_progress_line *line);

/* The text, with some characters replaced; the list ends in a row without. */
struct nb_escape {
  char character;
  const char *by;
};
void nb_print_escaped(FILE *out, const char *text, const struct nb_escape *list);

/* ---- tables.c ---- */

/* FOLDER/NAME, begun. */
enum nb_status nb_save_begin_in(struct nb_save *file, struct nb_error *error, const char *folder, const char *format,
                                ...) __attribute__((format(printf, 4, 5)));
/* Into the folder: table.tsv, values.tsv, verdict.tsv, and STAGE-bodies.tsv, -walls.tsv, -contacts.tsv for each snapshot,
 * of a path LEG-traction.tsv, -pieces.tsv. */
enum nb_status nb_tables_save(const struct nb_outcome *outcome, const char *folder, struct nb_error *error);
/* The rows of one run under one head row, reference curves beside the computed quantities. */
void nb_table_write_run(FILE *out, const struct nb_page_run *run);
/* One row a run: swept values, then every measure of the expect blocks, computed and reference. */
void nb_values_write(FILE *out, const struct nb_outcome *outcome);
void nb_table_write(FILE *out, const struct nb_table *table);
/* What every file begins with, behind `# `: program, page, the settings it was given and the hash of both, and whether it is
 * incomplete. */
void nb_preamble_write(FILE *out, const struct nb_outcome *outcome);

/* ---- figure.c ---- */

bool nb_page_has_figure(const struct nb_page *page); /* whether it has a block of kind `gnuplot` */
/* NAME.gp in the folder, and by gnuplot NAME.svg and NAME.png. NB_OK without doing anything when the page has no figure (then *drawn
 * is false). Only `figure` and `report` do this: gnuplot runs the page's own code, confined (sandbox.h), or also unconfined where the
 * page is trusted and nothing can confine it. */
enum nb_status nb_figure_draw(const struct nb_outcome *outcome, const char *folder, bool trust, bool *drawn,
                              struct nb_error *error);

/* gnuplot.c: runs FOLDER/NAME.gp, which may read `recipes`, after the given commands; what is drawn goes into `figure`, and what
 * gnuplot says to stderr if `aloud`. */
struct nb_gnuplot {
  const char *folder, *name, *recipes, *commands;
  int figure; /* file descriptor */
  bool trust, verbose;
};
enum nb_status nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error);

/* ---- report.c: one page about all of them; folders are relative to it ---- */

struct nb_report_line {
  char name[NB_NAME_SIZE], message[512]; /* of the page; what went wrong besides checks, or nothing */
  struct nb_outcome outcome;             /* without its runs */
  bool saved, drawn;                     /* there are tables, a figure */
  double seconds;
};
enum nb_status nb_report_write(const char *folder, const struct nb_report_line *lines, size_t count,
                               struct nb_error *error);

#endif
