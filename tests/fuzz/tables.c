/* The reader of a table that a later call of `advise --all` continues. Complete rows stay, and added rows can be found.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "../../src/input/reader.h"
#include "../../src/report/row_table.h"
#include "fuzz.h"

static const char version[] = "# nineball 1, advise --all\n", head[] = "page\thash\tresult\n";

/* Opens the table, looks for a row and adds it if it is missing. True if the row was there. *valid: whether the table
 * can be opened. */
static bool go_on(const char *path, const char *key, bool *valid) {
  struct nb_error error = {NB_OK, ""};
  struct nb_row_table table;
  const enum nb_status status = nb_row_table_open(&table, path, version, head, &error);
  fuzz_hold(status == NB_OK || (status == NB_BAD_USE && strncmp(error.text, path, strlen(path)) == 0),
            "an error of a table names the file");
  const char *row = status ? NULL : nb_row_table_find(&table, key);
  if (!status && !row)
    fprintf(table.file, "%syes\t1\n", key);
  *valid = !status;
  fuzz_hold(nb_row_table_close(&table), "the table is written");
  return row != NULL;
}

/* Tests that the complete lines, up to a zero byte, are still in the table. */
static void hold_lines(const char *path, const unsigned char *bytes, size_t size) {
  const unsigned char *zero = memchr(bytes, 0, size);
  struct nb_error error = {NB_OK, ""};
  size_t lines = zero ? (size_t)(zero - bytes) : size, now;
  while (lines > 0 && bytes[lines - 1] != '\n')
    lines--;
  char *text = nb_file_read(path, NB_PAGE_MAX, &now, &error);
  fuzz_hold(text && now >= lines && memcmp(text, bytes, lines) == 0, "complete rows stay");
  free(text);
}

static bool read_table(const unsigned char *bytes, size_t size) {
  static const char key[] = "cases/a.md\t0123456789abcdef\t";
  const char *path = fuzz_file();
  bool valid = false, again = false;
  go_on(path, key, &valid);
  if (valid) {
    fuzz_hold(go_on(path, key, &again) && again, "a row that was added is found");
    hold_lines(path, bytes, size);
  }
  return valid;
}

static size_t seed(size_t k, char *text) {
  static const char *const rows[] = {"", "cases/a.md\t0123456789abcdef\tyes\t2\n", "b.md\t0\tno\t-\ncases/a.md\t01",
                                     "cases/b.md\t0123456789abcdef\tno\t-\n\ncases/a.md\t0123456789abcdef\tno\t-\n"};
  if (k == 0)
    return (size_t)sprintf(text, "# another file\n");
  return k <= sizeof rows / sizeof *rows ? (size_t)sprintf(text, "%s%s%s", version, head, rows[k - 1]) : 0;
}

const struct fuzz_reader fuzz_tables = {"tables", 1024, 3000, read_table, seed};
