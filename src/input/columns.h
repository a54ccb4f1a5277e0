/* Lengths from a file: lines of columns under a head line that names them as our own tables do, `slip/um`, in any unit of length.
 * Columns are parted by tabs; by blanks, where the head line has no tab. Others than those wanted are passed over, and so are
 * empty lines and those that begin with `#`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_COLUMNS_H
#define NB_COLUMNS_H

#include "reader.h"

enum { NB_COLUMNS_MAX = 3 };

/* The file that the token names, which may be NULL; false with a message when it cannot be opened. `path` has NB_PATH_SIZE bytes. */
bool nb_file_named(struct nb_reader *reader, const struct nb_token *token, char *path);

struct nb_wanted {
  const char *name, *also; /* "approach"; another name that will do, NULL: none */
  bool positive;           /* above 0 */
};

/* Row by row what `count` wanted columns hold, m; to be freed, in any case. False when there is a mistake, which has been said. */
bool nb_columns_read(double **lengths, size_t *rows, const char *path, const struct nb_wanted *wanted, int count,
                     bool unitless, struct nb_mistakes *mistakes);

#endif
