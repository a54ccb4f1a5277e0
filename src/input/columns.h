/* Lengths from a file of columns under a head line, as in the program's own tables: `slip/um`, in any unit of length.
 * Tabs separate the columns, or spaces if the head line has no tab. Other columns, empty lines and lines that begin
 * with `#` are ignored.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reader.h"

enum { NB_COLUMNS_MAX = 3 };

/* Finds the file that the token names and writes its path to `path`, which has NB_PATH_SIZE bytes. False if the token
 * is NULL, or, with a message, if the file cannot be opened. The hint of the message is `hint`; if `hint` is NULL, it
 * says where the program has searched. */
bool nb_file_named(struct nb_reader *reader, const struct nb_token *token, const char *hint, char *path);

struct nb_wanted_column {
  const char *name, *alternative; /* "approach"; another accepted name, or NULL */
  bool positive;                  /* all values must be above 0 */
};

/* Sets *lengths to the values of `count` columns, in m, row by row, and *rows to the number of rows. The caller frees
 * *lengths in any case. False after a mistake, which has been reported. */
bool nb_columns_read(double **lengths, size_t *rows, const char *path, const struct nb_wanted_column *wanted, int count,
                     bool unitless, struct nb_mistakes *mistakes);
