/* The options of the command line.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OPTIONS_H
#define NB_OPTIONS_H

#include "commands.h"

void nb_options_help(FILE *out); /* one a line */

/* A call, read. */
struct nb_call {
  struct nb_use use;
  unsigned given;     /* set of options, by their place in the table */
  bool help, version; /* one of them is all that is wanted */
};

/* What getopt leaves begins at words[optind]; use.settings has room for as many as there are words. A message on stderr, or NB_OK. */
enum nb_status nb_options_read(struct nb_call *call, int count, char **words);
/* Whether the command takes all that is given; a message on stderr names those that do. */
enum nb_status nb_options_check(const struct nb_call *call, const char *command);
/* "nineball: WHAT; nineball --help tells", with the word in the place of `%s`. */
enum nb_status nb_options_usage(const char *format, const char *word);
enum nb_status nb_options_no_memory(void);

#endif
