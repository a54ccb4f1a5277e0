/* Variables of a run that a checkpoint contains: each module lists its own once, and the same list saves and restores
 * them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STORE_H
#define NB_STORE_H

#include "nineball.h"

struct nb_store {
  struct nb_store_part {
    char name[NB_NAME_SIZE];
    size_t at, count; /* in `values` */
  } * parts;          /* owned, as `values` */
  size_t part_count;
  double *values;
  size_t value_count;
  bool restoring;
  size_t next; /* part to be restored */
  bool failed; /* no memory, or the parts are not those of the model */
};

void nb_store_free(struct nb_store *store);
/* Saves or restores numbers, in the order of the calls. A part of another name or length is a failure. */
void nb_store_doubles(struct nb_store *store, const char *name, double *values, size_t count);
/* Integers of 1, 4 or 8 bytes, of at most that absolute value. */
void nb_store_integers(struct nb_store *store, const char *name, void *values, size_t count, size_t size, double most);
/* Length of the next part if it has that name and is restored, else `now`. */
size_t nb_store_length(const struct nb_store *store, const char *name, size_t now);
const struct nb_store_part *nb_store_find(const struct nb_store *store, const char *name); /* NULL: none */

/* NB_STORE: objects that consist of doubles alone. NB_STORE_INTEGERS: integers, Boolean values and characters. */
#define NB_STORE(store, name, at, count)                                                                               \
  nb_store_doubles(store, name, (double *)(void *)(at), (count) * sizeof *(at) / sizeof(double))
#define NB_STORE_INTEGERS(store, name, at, count)                                                                      \
  nb_store_integers(store, name, at, count, sizeof *(at),                                                              \
                    _Generic(*(at), bool : 1, char : 255, unsigned char : 255, int : 0x7fffffff, default : 0x1p53))

void nb_store_table(struct nb_store *store, struct nb_table *table); /* table.c: the rows */

#endif
