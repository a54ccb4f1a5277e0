/* A table of rows in a file. `nineball advise --all` writes its rows one by one; if it is interrupted, the next call of
 * the command adds the rows that are not yet in the file. The first line of the file names the version that wrote it,
 * the second line names the columns.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"

struct nb_row_table {
  FILE *file;   /* the file to which rows are added */
  char *before; /* the rows of earlier calls; NULL: none; owned */
};

/* Opens the table or makes it. `version` and `head` are the first two lines of a new table; an existing table must
 * begin with `version`. Complete rows stay; an incomplete last row is removed. The caller closes the table, also after
 * an error. */
enum nb_status nb_row_table_open(struct nb_row_table *table, const char *path, const char *version, const char *head,
                                 struct nb_error *error);
/* The text after `key` in the row of an earlier call that begins with `key`; NULL: there is no such row. */
const char *nb_row_table_find(const struct nb_row_table *table, const char *key);
bool nb_row_table_close(struct nb_row_table *table); /* false: it could not be written; frees everything in any case */
