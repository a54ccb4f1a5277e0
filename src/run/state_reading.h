/* A saved state while it is read: between state_read.c, which takes fields one by one, and state_records.c, which knows what they
 * are. Whatever takes a field says what it expected when that is not there, once for each file, and answers something harmless.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STATE_READING_H
#define NB_STATE_READING_H

#include "input/reader.h"
#include "state.h"

enum { NB_STATE_FIELD = 2 * NB_NAME_SIZE, NB_STATE_END = 21 }; /* "end ", 16 digits and the line's end */

struct nb_state_reading {
  struct nb_saved *saved;
  const char *path, *line, *end; /* the record that is read, and one past its last character */
  const char *at, *taken;        /* what is to be read next; the last field, for messages */
  size_t number;                 /* of the line */
  enum nb_field fields[NB_FIELDS];
  int field_count;   /* of contacts; 0: not said yet */
  unsigned seen;     /* set of records that have been read, by their place in the table; */
  unsigned carriers; /* of carriers, likewise */
  struct nb_error *error;
  bool bad;
};

/* "PATH:7:12: expected a number, found `x`" at the field that was taken last. */
void nb_saved_expected(struct nb_state_reading *reading, const char *format, ...) __attribute__((format(printf, 2, 3)));
bool nb_saved_ended(const struct nb_state_reading *reading); /* no field is left in the line */
void nb_saved_take_field(struct nb_state_reading *reading, char field[NB_STATE_FIELD], const char *what);
double nb_saved_number(struct nb_state_reading *reading); /* `-`: not said, NAN */
double nb_saved_finite(struct nb_state_reading *reading);
double nb_saved_above_0(struct nb_state_reading *reading);
double nb_saved_not_negative(struct nb_state_reading *reading);
double nb_saved_not_negative_if_any(struct nb_state_reading *reading); /* or `-`, or infinite */
struct nb_vec nb_saved_unit_vector(struct nb_state_reading *reading);
struct nb_vec nb_saved_vector(struct nb_state_reading *reading);
unsigned long nb_saved_count(struct nb_state_reading *reading, unsigned long low, unsigned long high);
void nb_saved_name(struct nb_state_reading *reading, char name[NB_NAME_SIZE], const char *what);
int nb_saved_one_of(struct nb_state_reading *reading, const char *a, const char *b, const char *c);
void nb_saved_rest(struct nb_state_reading *reading, char *text, size_t size);

/* One more at the end of an array of the state; NULL, and said, when there are too many or no memory. */
void *nb_saved_more(struct nb_state_reading *reading, void **array, size_t *count, size_t element, size_t most);
#define NB_SAVED_MORE(reading, things, count, most)                                                                    \
  nb_saved_more(reading, (void **)&(reading)->saved->things, &(reading)->saved->count,                                 \
                sizeof *(reading)->saved->things, most)
enum { NB_SAVED_MANY = 1 << 30 };

void nb_state_fields(struct nb_state_reading *reading);
void nb_state_contact(struct nb_state_reading *reading);
void nb_state_normal(struct nb_state_reading *reading);
void nb_state_shear(struct nb_state_reading *reading);

struct nb_state_record {
  const char *word; /* NULL: behind the last one */
  void (*read)(struct nb_state_reading *reading);
  enum { NB_ANY_TIMES, NB_AT_MOST_ONCE, NB_ONCE, NB_MORE } times; /* NB_MORE: once or more */
};
extern const struct nb_state_record nb_state_records[];

#endif
