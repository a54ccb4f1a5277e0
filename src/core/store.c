/* Saves variables of a run in a list of named parts, and restores them from it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "store.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"

void nb_store_free(struct nb_store *store) {
  free(store->parts), free(store->values);
  *store = (struct nb_store){0};
}

/* The numbers of the next part: of a new part that the caller fills, or of the saved part that the caller reads. NULL:
 * the part has no numbers, or the store has failed. */
static double *next_part(struct nb_store *store, const char *name, size_t count) {
  if (store->failed)
    return NULL;
  if (store->restoring) {
    const struct nb_store_part *part = &store->parts[store->next];
    if (store->next == store->part_count || strcmp(part->name, name) != 0 || part->count != count) {
      store->failed = true;
      return NULL;
    }
    store->next++;
    return count ? store->values + part->at : NULL;
  }
  double *values = count ? nb_array_reserve(store->values, store->value_count, count, sizeof *values) : NULL;
  store->values = values ? values : store->values;
  struct nb_store_part *part = values || !count ? NB_ARRAY_APPEND(store->parts, store->part_count) : NULL;
  if (!part) {
    store->failed = true;
    return NULL;
  }
  snprintf(part->name, sizeof part->name, "%s", name);
  part->at = store->value_count, part->count = count;
  store->value_count += count;
  return count ? store->values + part->at : NULL;
}

void nb_store_doubles(struct nb_store *store, const char *name, double *values, size_t count) {
  double *own = next_part(store, name, count);
  if (own)
    memcpy(store->restoring ? values : own, store->restoring ? own : values, count * sizeof *values);
}

static bool integers(const double *values, size_t count, double least, double most) {
  for (size_t k = 0; k < count; k++)
    if (!(values[k] >= least && values[k] <= most && values[k] == nearbyint(values[k])))
      return false;
  return true;
}

void nb_store_integers(struct nb_store *store, const char *name, void *values, size_t count, size_t size, double most) {
  double *own = next_part(store, name, count);
  store->failed = store->failed || (own && store->restoring && !integers(own, count, size == 1 ? 0 : -most, most));
  for (size_t k = 0; own && !store->failed && k < count; k++) {
    unsigned char *byte = (unsigned char *)values + k;
    int32_t *word = (int32_t *)values + k;
    int64_t *longer = (int64_t *)values + k;
    if (!store->restoring)
      own[k] = size == 1 ? *byte : size == 4 ? *word : (double)*longer;
    else if (size == 1)
      *byte = (unsigned char)own[k];
    else if (size == 4)
      *word = (int32_t)own[k];
    else
      *longer = (int64_t)own[k];
  }
}

const struct nb_store_part *nb_store_find(const struct nb_store *store, const char *name) {
  for (size_t p = 0; p < store->part_count; p++)
    if (strcmp(store->parts[p].name, name) == 0)
      return &store->parts[p];
  return NULL;
}

size_t nb_store_length(const struct nb_store *store, const char *name, size_t now) {
  const struct nb_store_part *part = store->next < store->part_count ? &store->parts[store->next] : NULL;
  if (!store->restoring)
    return now;
  return part && strcmp(part->name, name) == 0 ? part->count : 0;
}
