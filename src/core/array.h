/* Aligned arrays for vectorised loops, and growing arrays.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Returns a zeroed array of `count` elements of `size` bytes, aligned for vector loads; NULL only when memory ran out.
 * Free it with free(). */
void *nb_array(size_t count, size_t size);
/* Reserves capacity for `more` elements after `count`, each of `element` bytes, in an array that only these functions
 * enlarge. Returns the array, perhaps moved, or NULL when memory ran out (the old array is then unchanged). Free it
 * with free(). */
void *nb_array_reserve(void *array, size_t count, size_t more, size_t element);
/* Reserves capacity for one more element; `array` points to the pointer to the array. False when memory ran out;
 * nothing has then changed. */
bool nb_array_grow(void *array, size_t count, size_t element);
/* Adds one zeroed element at the end, and returns it. NULL when memory ran out; nothing has then changed. */
void *nb_array_add(void *array, size_t *count, size_t element);
#define NB_ARRAY_APPEND(array, count) nb_array_add(&(array), &(count), sizeof *(array))

/* A list of arrays that are freed together. */
struct nb_owner {
  void **list;
  size_t count;
  bool failed; /* an allocation failed; tested once, after all arrays are made */
};
/* Returns an array as nb_array does. It is freed with its owner. NULL when memory ran out; `failed` is then set. */
void *nb_own(struct nb_owner *owner, size_t count, size_t size);
void nb_owner_free(struct nb_owner *owner);
/* Frees all arrays of the owner except those listed; an entry of `kept` may be NULL. */
void nb_owner_keep(struct nb_owner *owner, void *const kept[], size_t count);
