/* A saved state from text. First the checksum: a file that is cut off, or in which anything has changed, is not read at all. Then
 * record by record; whatever is not as docs/STATE.md says is an error with file, line, column and what was expected.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "state_reading.h"

/* "PATH:7:12: expected a number, found `x`" at the field that was taken last. */
void nb_saved_expected(struct nb_state_reading *reading, const char *format, ...) {
  char what[160];
  va_list list;
  if (reading->bad)
    return;
  reading->bad = true;
  va_start(list, format);
  vsnprintf(what, sizeof what, format, list);
  va_end(list);
  const char *from = reading->taken < reading->end ? reading->taken : reading->end;
  const int column = (int)(from - reading->line) + 1, length = (int)strcspn(from, " \n");
  if (length > 0)
    nb_error_set(reading->error, NB_BAD_USE, "%.150s:%zu:%d: expected %s, found `%.*s`", reading->path, reading->number,
                 column, what, length < 60 ? length : 60, from);
  else
    nb_error_set(reading->error, NB_BAD_USE, "%.150s:%zu:%d: expected %s, found the end of the line", reading->path,
                 reading->number, column, what);
}

/* ---- fields ---- */

/* The next field, as a text of its own; empty, and said, when there is none. */
void nb_saved_take_field(struct nb_state_reading *reading, char field[NB_STATE_FIELD], const char *what) {
  field[0] = 0;
  reading->taken = reading->at;
  const size_t length = reading->at < reading->end ? strcspn(reading->at, " \n") : 0;
  if (length == 0 || length >= NB_STATE_FIELD) {
    nb_saved_expected(reading, "%s", what);
    return;
  }
  memcpy(field, reading->at, length);
  field[length] = 0;
  reading->at += length;
  if (reading->at < reading->end)
    reading->at++;
}

bool nb_saved_ended(const struct nb_state_reading *reading) { return reading->at >= reading->end; }

double nb_saved_number(struct nb_state_reading *reading) {
  char field[NB_STATE_FIELD], *end;
  nb_saved_take_field(reading, field, "a number");
  if (strcmp(field, "-") == 0)
    return NAN;
  const double value = strtod(field, &end);
  if (*end || isnan(value))
    nb_saved_expected(reading, "a number");
  return value;
}

/* Neither unsaid nor infinite. */
double nb_saved_finite(struct nb_state_reading *reading) {
  const double value = nb_saved_number(reading);
  if (!isfinite(value))
    nb_saved_expected(reading, "a finite number");
  return value;
}

struct nb_vec nb_saved_vector(struct nb_state_reading *reading) {
  const double x = nb_saved_finite(reading);
  return vec(x, nb_saved_finite(reading));
}

double nb_saved_above_0(struct nb_state_reading *reading) {
  const double value = nb_saved_finite(reading);
  if (!(value > 0))
    nb_saved_expected(reading, "a number above 0");
  return value;
}

double nb_saved_not_negative(struct nb_state_reading *reading) {
  const double value = nb_saved_finite(reading);
  if (!(value >= 0))
    nb_saved_expected(reading, "0 or more");
  return value;
}

double nb_saved_not_negative_if_any(struct nb_state_reading *reading) {
  const double value = nb_saved_number(reading);
  if (value < 0)
    nb_saved_expected(reading, "0 or more");
  return value;
}

struct nb_vec nb_saved_unit_vector(struct nb_state_reading *reading) {
  const struct nb_vec e = nb_saved_vector(reading);
  if (!(fabs(hypot(e.x, e.y) - 1) < 1e-9))
    nb_saved_expected(reading, "a vector of length 1");
  return e;
}

unsigned long nb_saved_count(struct nb_state_reading *reading, unsigned long low, unsigned long high) {
  char field[NB_STATE_FIELD], *end;
  nb_saved_take_field(reading, field, "a whole number");
  const unsigned long value = strtoul(field, &end, 10);
  if (*end || field[0] < '0' || value < low || value > high)
    nb_saved_expected(reading, "a whole number from %lu to %lu", low, high);
  return reading->bad ? low : value;
}

void nb_saved_name(struct nb_state_reading *reading, char name[NB_NAME_SIZE], const char *what) {
  char field[NB_STATE_FIELD];
  nb_saved_take_field(reading, field, what);
  if (strlen(field) >= NB_NAME_SIZE)
    nb_saved_expected(reading, "%s", what);
  snprintf(name, NB_NAME_SIZE, "%.*s", NB_NAME_SIZE - 1, field);
}

/* Which of two or three words. */
int nb_saved_one_of(struct nb_state_reading *reading, const char *a, const char *b, const char *c) {
  char field[NB_STATE_FIELD];
  nb_saved_take_field(reading, field, a);
  if (strcmp(field, a) == 0)
    return 0;
  if (strcmp(field, b) == 0)
    return 1;
  if (c && strcmp(field, c) == 0)
    return 2;
  nb_saved_expected(reading, "`%s`, `%s`%s%s%s", a, b, c ? " or `" : "", c ? c : "", c ? "`" : "");
  return 0;
}

/* The rest of the line, blanks and all. */
void nb_saved_rest(struct nb_state_reading *reading, char *text, size_t size) {
  reading->taken = reading->at;
  const size_t length = reading->at < reading->end ? (size_t)(reading->end - reading->at) : 0;
  if (length == 0 || length >= size)
    nb_saved_expected(reading, "a text shorter than %zu bytes", size);
  snprintf(text, size, "%.*s", (int)(length < size ? length : 0), reading->at);
  reading->at = reading->end;
}

/* One more at the end of an array of the state; NULL, and said, when there is no memory. */
void *nb_saved_more(struct nb_state_reading *reading, void **array, size_t *count, size_t element, size_t most) {
  if (*count >= most) {
    nb_saved_expected(reading, "at most %zu such records", most);
    return NULL;
  }
  void *room = nb_room(*array, *count, 1, element);
  if (!room) {
    reading->bad = true;
    nb_error_memory(reading->error);
    return NULL;
  }
  *array = room;
  return memset((char *)room + element * (*count)++, 0, element);
}
static void read_record(struct nb_state_reading *reading) {
  char word[NB_STATE_FIELD];
  reading->at = reading->line;
  nb_saved_take_field(reading, word, "a record");
  size_t k = 0;
  while (nb_state_records[k].word && strcmp(nb_state_records[k].word, word) != 0)
    k++;
  const struct nb_state_record *record = &nb_state_records[k];
  if (!record->word) {
    nb_saved_expected(reading, "a record that this program knows");
    return;
  }
  if (reading->seen & 1U << k && (record->times == NB_ONCE || record->times == NB_AT_MOST_ONCE))
    nb_saved_expected(reading, "such a record once");
  reading->seen |= 1U << k;
  record->read(reading);
  reading->taken = reading->at;
  if (!nb_saved_ended(reading))
    nb_saved_expected(reading, "the end of the line");
}

/* At the last line, when all records have been read: what must be there is, and goes together. */
static void check_whole(struct nb_state_reading *reading) {
  const struct nb_saved *saved = reading->saved;
  reading->taken = reading->line;
  for (size_t k = 0; nb_state_records[k].word; k++)
    if (nb_state_records[k].times >= NB_ONCE && !(reading->seen & 1U << k))
      nb_saved_expected(reading, "a record `%s` above", nb_state_records[k].word);
  if (!saved->normal[0] || !saved->shear[0])
    nb_saved_expected(reading, "records `law normal` and `law shear` above");
  if (saved->carried_count != 0 && saved->carried_count != saved->body_count)
    nb_saved_expected(reading, "a record `carried` for each body, or for none");
  for (size_t k = 0; k < saved->carried_count; k++)
    if ((saved->carried[k].by == NB_CARRIER_CELL && !saved->cell.is) ||
        (saved->carried[k].by == NB_CARRIER_BOUNDARY && !saved->bodies[k].member))
      nb_saved_expected(reading, "body %zu to be carried by a cell or a boundary that there is", k + 1);
  if (saved->ring.is != (saved->ring.member_count > 0))
    nb_saved_expected(reading, "records `boundary` and `members`, or neither");
}

/* ---- the whole ---- */

static enum nb_status damaged(const char *path, const char *text, size_t size, size_t last, const char *what,
                              struct nb_error *error) {
  size_t line = 1;
  for (size_t i = 0; i < last && i < size; i++)
    line += text[i] == '\n';
  return nb_error_set(error, NB_BAD_USE, "%.200s:%zu:1: %s", path, line, what);
}

enum nb_status nb_saved_read_text(struct nb_saved *saved, const char *path, const char *text, size_t size,
                                  struct nb_error *error) {
  static const char head[] = "nineball state 1\n";
  char end[NB_STATE_END + 1];
  *saved = (struct nb_saved){.turns = true};
  if (size < sizeof head - 1 || memcmp(text, head, sizeof head - 1) != 0)
    return damaged(path, text, 0, 0, "expected `nineball state 1`: this is no saved state, or one of another version",
                   error);
  const size_t last = size - NB_STATE_END;
  if (size < sizeof head - 1 + NB_STATE_END || memcmp(text + last, "end ", 4) != 0)
    return damaged(path, text, size, size, "expected a last line `end` with its checksum: the file is cut off", error);
  snprintf(end, sizeof end, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, last));
  if (text[last - 1] != '\n' || memcmp(text + last, end, NB_STATE_END) != 0)
    return damaged(path, text, size, last, "expected another checksum: something in the file has changed", error);

  struct nb_state_reading reading = {
      .saved = saved, .path = path, .number = 1, .error = error, .line = text + sizeof head - 1};
  while (reading.line < text + last && !reading.bad) {
    reading.end = memchr(reading.line, '\n', (size_t)(text + last - reading.line)); /* the last line ends in one */
    reading.number++;
    read_record(&reading);
    reading.line = reading.end + 1;
  }
  reading.end = text + size - 1, reading.number++;
  if (!reading.bad)
    check_whole(&reading);
  if (!reading.bad)
    return NB_OK;
  nb_saved_free(saved);
  return error->status;
}

enum nb_status nb_saved_read(struct nb_saved *saved, const char *path, struct nb_error *error) {
  size_t size;
  *saved = (struct nb_saved){0};
  char *text = nb_file_read(path, NB_FILE_MAX, &size, error);
  const struct nb_error why = text ? (struct nb_error){NB_OK, ""} : *error;
  if (why.status == NB_BAD_USE)
    nb_error_set(error, NB_BAD_USE, "%.200s: %.200s", path, why.text);
  const enum nb_status status = text ? nb_saved_read_text(saved, path, text, size, error) : why.status;
  free(text);
  return status;
}
