/* What the program can do: one function for each word of the command line.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_COMMANDS_H
#define NB_COMMANDS_H

#include "nineball.h"

/* A call, read. */
struct nb_use {
  char **pages;
  size_t page_count;
  const char *folder;    /* or a file; NULL: the default */
  const char *stage;     /* at whose end; NULL: the last one */
  const char **settings; /* NULL-terminated */
  char *follow;          /* the one of --follow, owned; NULL: none */
  struct nb_options options;
  bool tap;
  bool trust; /* draw without confinement where there is none */
};

enum nb_status nb_command_run(const struct nb_use *use);
enum nb_status nb_command_check(const struct nb_use *use);
enum nb_status nb_command_figure(const struct nb_use *use);
enum nb_status nb_command_report(const struct nb_use *use);
enum nb_status nb_command_explain(const struct nb_use *use);
enum nb_status nb_command_state(const struct nb_use *use);
enum nb_status nb_command_laws(const struct nb_use *use);
enum nb_status nb_command_list(const struct nb_use *use);

/* manual.c: all words of pages, as Markdown with what they take and with examples; for a terminal with one sentence each. */
void nb_manual(FILE *out, bool markdown);
/* All about one word of a page: a statement, what follows a measure, a clause of statements, a quantity. False: there is none; then `hint`
 * (NB_NAME_SIZE * 2 bytes) holds the nearest one, or is empty. */
bool nb_manual_word(FILE *out, const char *word, char *hint);

/* print.c: verdicts and progress on the terminal */
struct nb_outcome;
/* One a line: "PAGE:7: warning: …", with `before` before it. */
void nb_print_warnings(FILE *out, const char *before, const char *path, const struct nb_warnings *warnings);
/* Likewise on stdout, of those that stderr has had already: not when both are one terminal. */
void nb_repeat_warnings(const char *before, const char *path, const struct nb_warnings *warnings);
void nb_print_verdict(const struct nb_outcome *outcome);
void nb_print_tap(const struct nb_outcome *outcome, const char *path);
void nb_print_trouble(const struct nb_outcome *outcome, const char *path); /* mistakes, or what broke, to stderr */
struct nb_progress_line {
  const char *page;
  double shown; /* s of the run when it was last written; 0: never */
};
struct nb_progress nb_print_progress(struct nb_progress_line *line); /* does nothing when stderr is no terminal */
void nb_print_progress_end(struct nb_progress_line *line);

#endif
