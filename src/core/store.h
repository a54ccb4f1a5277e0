/* The variables of a run that a checkpoint contains. Each module lists its own variables once; the same list saves and
 * restores them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "nineball.h"

struct nb_store {
  struct nb_store_part {
    char name[NB_NAME_SIZE];
    size_t at, count; /* index of the first number in `values`; how many numbers */
  } * parts;          /* owned by the store, like `values` */
  size_t part_count;
  double *values;
  size_t value_count;
  bool restoring;
  size_t next; /* index of the next part to restore */
  bool failed; /* memory ran out, or a part is not the one that the model expects */
};

void nb_store_free(struct nb_store *store);
/* Saves `count` numbers, or restores them, as the part `name`. Parts are restored in the order in which they were
 * saved; another name or length sets store->failed. */
void nb_store_doubles(struct nb_store *store, const char *name, double *values, size_t count);
/* Saves or restores integers of 1, 4 or 8 bytes. A restored number must be an integer from -most to most, for 1 byte
 * from 0 to most. Any other number sets store->failed. */
void nb_store_integers(struct nb_store *store, const char *name, void *values, size_t count, size_t size, double most);
/* When restoring, the length of the next part, or 0 if its name is not `name`. When saving, `now`. */
size_t nb_store_length(const struct nb_store *store, const char *name, size_t now);
/* Returns the part `name`; NULL: there is none. */
const struct nb_store_part *nb_store_find(const struct nb_store *store, const char *name);

/* NB_STORE saves or restores objects that consist of doubles alone, NB_STORE_INTEGERS integers, Boolean values and
 * characters. */
#define NB_STORE(store, name, at, count)                                                                               \
  nb_store_doubles(store, name, (double *)(void *)(at), (count) * sizeof *(at) / sizeof(double))
#define NB_STORE_INTEGERS(store, name, at, count)                                                                      \
  nb_store_integers(store, name, at, count, sizeof *(at),                                                              \
                    _Generic(*(at), bool : 1, char : 255, unsigned char : 255, int : 0x7fffffff,                       \
                             unsigned : 0x7fffffff, default : 0x1p53))

void nb_store_table(struct nb_store *store, struct nb_table *table); /* table.c: saves or restores the rows */
