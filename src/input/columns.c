/* A file of columns: a head line, then rows of numbers. Every mistake in a line is reported with file, line and column.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "columns.h"

#include <stdlib.h>
#include <string.h>

#include "core/clean.h"

/* A field of a line: `length` bytes; `column` is its column in characters, from 1. */
struct field {
  const char *at;
  size_t length;
  int column;
};

struct table {
  struct nb_page file;
  bool unitless, spaces; /* `units none`; spaces, not tabs, separate the fields */
  struct {
    int index; /* index of the field in a line; -1: the file has no such column */
    int shift; /* power of ten of the unit */
    const char *name;
  } columns[NB_COLUMNS_MAX];
  struct nb_mistakes *mistakes;
};

static void advance(struct field *field, size_t bytes) {
  for (size_t k = 0; k < bytes; k++)
    field->column += (field->at[k] & 0xC0) != 0x80;
  field->at += bytes;
}

/* Goes to the first or the next field of a line. `spaces`: spaces, not tabs, separate the fields; behind a space at the end
 * of the line there is an empty one. False if there is no such field; then *field is empty, at the end of the line. */
static bool next_field(struct field *field, bool spaces, bool first) {
  advance(field, field->length);
  const bool there = first || *field->at;
  advance(field, spaces ? strspn(field->at, " ") : !first && there);
  field->length = strcspn(field->at, spaces ? " " : "\t");
  return there;
}

static struct field line_begin(const struct table *table, size_t line) {
  return (struct field){table->file.lines[line - 1], 0, 1};
}

/* Finds field number `index`, from 0. If the line has fewer fields, the field is empty, at the end of the line. */
static void find_field(struct field *field, const struct table *table, size_t line, int index) {
  *field = line_begin(table, line);
  for (int k = 0; next_field(field, table->spaces, k == 0) && k < index; k++)
    continue;
}

static void report(const struct table *table, size_t line, struct field field, const char *expected) {
  const int shown = field.length < 80 ? (int)field.length : 80;
  if (field.length == 0)
    nb_mistake(table->mistakes, &table->file, line, field.column, 1, NULL, "expected %s, found nothing", expected);
  else
    nb_mistake(table->mistakes, &table->file, line, field.column, (int)field.length, NULL, "expected %s, found `%.*s`",
               expected, shown, field.at);
}

/* True if a field of the head line, such as `slip/um`, is the column `name`. Sets `shift` to the power of ten of its
 * unit. */
static bool is_column(const struct field *field, const char *name, bool unitless, int *shift) {
  char text[NB_NAME_SIZE];
  const size_t length = name ? strlen(name) : 0;
  if (!name || field->length <= length || field->length >= sizeof text || strncmp(field->at, name, length) != 0 ||
      field->at[length] != '/')
    return false;
  memcpy(text, field->at + length + 1, field->length - length - 1);
  text[field->length - length - 1] = '\0';
  struct nb_unit unit;
  nb_unit_read(&unit, "m");
  const struct nb_dimension of_length = unit.dimension;
  const bool here =
      unitless ? strcmp(text, "-") == 0 : nb_unit_read(&unit, text) && nb_dimension_same(unit.dimension, of_length);
  *shift = here ? unit.shift : *shift;
  return here;
}

static bool read_head(struct table *table, size_t line, const struct nb_wanted_column *wanted, int count) {
  struct field field;
  char names[256] = "", text[320];
  const char *head = table->file.lines[line - 1], *unit = table->unitless ? "-" : "m";
  bool whole = true;
  table->spaces = !strchr(head, '\t');
  for (int c = 0; c < count; c++) {
    table->columns[c].index = -1;
    field = line_begin(table, line);
    for (int k = 0; next_field(&field, table->spaces, k == 0); k++)
      for (int other = 0; other < 2; other++) {
        const char *const name = other ? wanted[c].alternative : wanted[c].name;
        if (is_column(&field, name, table->unitless, &table->columns[c].shift))
          table->columns[c].index = k, table->columns[c].name = name;
      }
    whole = whole && table->columns[c].index >= 0;
    nb_append(names, sizeof names, "%s`%s/%s`", !c ? "" : c + 1 < count ? ", " : " and ", wanted[c].name, unit);
  }
  if (whole)
    return true;
  snprintf(text, sizeof text, "a head line with columns %s%s", names, table->unitless ? "" : ", in a unit of length");
  report(table, line, (struct field){head, strlen(head), 1}, text);
  return false;
}

static bool read_number(double *value, const struct table *table, size_t line, int c,
                        const struct nb_wanted_column *wanted) {
  struct field field;
  char text[NB_NAME_SIZE] = "";
  find_field(&field, table, line, table->columns[c].index);
  if (field.length < sizeof text) {
    memcpy(text, field.at, field.length);
    text[field.length] = '\0';
  }
  const enum nb_reading reading = nb_number_read(value, text, table->columns[c].shift);
  if (reading == NB_READ && (*value > 0 || !wanted->positive))
    return true;
  if (reading == NB_TOO_LARGE || reading == NB_TOO_SMALL)
    return report(table, line, field, nb_reading_words(reading)), false;
  snprintf(text, sizeof text, "a number%s in the column `%.20s`", wanted->positive ? " above 0" : "",
           table->columns[c].name);
  report(table, line, field, text);
  return false;
}

bool nb_file_named(struct nb_reader *reader, const struct nb_token *token, const char *hint, char *path) {
  struct nb_error error;
  if (!token || !nb_file_find(reader, token, "", path))
    return false;
  FILE *file = nb_file_open(path, &error);
  const bool has_no_search = token->text[0] == '/' || strncmp(token->text, "../", 3) == 0 ||
                             strstr(token->text, "/../"); /* see nb_file_find */
  if (file)
    fclose(file);
  else if (error.status == NB_NO_MEMORY)
    nb_no_memory(reader);
  else
    nb_token_mistake(
        reader, token,
        hint                    ? hint
        : token->text[0] == '/' ? "a path that begins with `/` is used as it is; the program searches no other folders"
        : has_no_search ? "a path with `..` starts from the folder of the page; the program searches no other folders"
                        : "the program searches the folder of the page, then the nearest folder `cases` "
                          "above it, and all folders in `cases`",
        "expected a file that can be read, found `%s`, which %s", token->text, error.text);
  return file != NULL;
}

bool nb_columns_read(double **lengths, size_t *rows, const char *path, const struct nb_wanted_column *wanted, int count,
                     bool unitless, struct nb_mistakes *mistakes) {
  struct table table = {.unitless = unitless, .mistakes = mistakes};
  const size_t before = mistakes->total;
  bool head = false;
  *lengths = NULL, *rows = 0;
  if (nb_page_read_limited(&table.file, path, NB_FILE_MAX, mistakes))
    return false;
  *lengths = calloc(table.file.line_count + 1, (size_t)count * sizeof **lengths);
  if (!*lengths)
    nb_mistake_memory(mistakes);
  for (size_t line = 1; line <= table.file.line_count && *lengths; line++) {
    const char *text = table.file.lines[line - 1];
    bool whole = true;
    if (text[0] == '#' || !text[strspn(text, " \t")])
      continue;
    if (!head) {
      head = true;
      if (!read_head(&table, line, wanted, count))
        break;
      continue;
    }
    for (int c = 0; c < count; c++)
      whole = read_number(*lengths + *rows * (size_t)count + c, &table, line, c, &wanted[c]) && whole;
    *rows += whole;
  }
  if (*rows == 0 && mistakes->total == before)
    nb_mistake(mistakes, &table.file, 0, 0, 0, NULL,
               head ? "expected rows of numbers below the head line, found none"
                    : "expected a head line and rows of numbers below it, found neither");
  nb_page_free(&table.file);
  return mistakes->total == before;
}
