/* A table of rows that a later call continues.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "row_table.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "input/reader.h"

enum nb_status nb_row_table_open(struct nb_row_table *table, const char *path, const char *version, const char *head,
                                 struct nb_error *error) {
  size_t size = 0;
  *table = (struct nb_row_table){NULL, NULL};
  if (access(path, F_OK) == 0 && !(table->before = nb_file_read(path, NB_PAGE_MAX, &size, error)))
    return error->status;
  char *end = table->before ? strrchr(table->before, '\n') : NULL;
  if (table->before && *table->before && strncmp(table->before, version, strlen(version)) != 0)
    return nb_error_set(error, NB_BAD_USE,
                        "%s is not a table that this version wrote: remove it, or choose another folder with -o", path);
  if (end)
    end[1] = 0;
  table->file = fopen(path, end ? "r+" : "w");
  if (!table->file ||
      (end && (ftruncate(fileno(table->file), end + 1 - table->before) != 0 || fseek(table->file, 0, SEEK_END))))
    return nb_error_system(error, "cannot write %s", path);
  if (!end)
    fprintf(table->file, "%s%s", version, head);
  return NB_OK;
}

const char *nb_row_table_find(const struct nb_row_table *table, const char *key) {
  const size_t length = strlen(key);
  const char *line = table->before;
  while (line && strncmp(line, key, length) != 0)
    line = (line = strchr(line, '\n')) ? line + 1 : NULL;
  return line ? line + length : NULL;
}

bool nb_row_table_close(struct nb_row_table *table) {
  const bool failed = table->file && ferror(table->file);
  free(table->before);
  return !table->file || (fclose(table->file) == 0 && !failed);
}
