/* Aligned arrays for vectorised loops, and growing arrays.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* gcc defines __SANITIZE_ADDRESS__ itself. */
#ifdef __has_feature
#if __has_feature(address_sanitizer) && !defined __SANITIZE_ADDRESS__
#define __SANITIZE_ADDRESS__ 1
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(from, bytes) ((void)0)
#endif

void *nb_array(size_t count, size_t size) {
  const size_t line = 64; /* a cache line, and the widest vector load */
  if (size && count > (SIZE_MAX - line) / size)
    return NULL;
  const size_t bytes = (count * size + line) / line * line; /* at least one line */
  void *array = aligned_alloc(line, bytes);
  if (!array)
    return NULL;
  memset(array, 0, bytes);
  /* The sanitizer then reports an access past the last element. */
  ASAN_POISON_MEMORY_REGION((char *)array + count * size, bytes - count * size);
  return array;
}

void *nb_array_reserve(void *array, size_t count, size_t more, size_t element) {
  /* If the array has elements, its capacity is at least 8, and at least the smallest power of two that is not below
   * `count`. So it need not be stored. */
  if (more == 1 && count > 8 && (count & (count - 1)) != 0)
    return array;
  size_t have = 0, need = 8;
  if (count > 0)
    for (have = 8; have < count;)
      have *= 2;
  while (need < count + more)
    need *= 2;
  return have >= need ? array : realloc(array, need * element);
}

bool nb_array_grow(void *array, size_t count, size_t element) {
  void *things; /* `array` points to a pointer of any type, which may have another representation than void * */
  memcpy(&things, array, sizeof things);
  things = nb_array_reserve(things, count, 1, element);
  if (things)
    memcpy(array, &things, sizeof things);
  return things != NULL;
}

void *nb_array_add(void *array, size_t *count, size_t element) {
  char *things;
  if (!nb_array_grow(array, *count, element))
    return NULL;
  memcpy(&things, array, sizeof things);
  return memset(things + (*count)++ * element, 0, element);
}

void *nb_own(struct nb_owner *owner, size_t count, size_t size) {
  void *array = nb_array(count, size), **place = array ? NB_ARRAY_APPEND(owner->list, owner->count) : NULL;
  if (place)
    return *place = array;
  free(array);
  owner->failed = true;
  return NULL;
}

void nb_owner_free(struct nb_owner *owner) {
  for (size_t k = 0; k < owner->count; k++)
    free(owner->list[k]);
  free(owner->list);
  *owner = (struct nb_owner){0};
}

static bool listed(const void *array, void *const list[], size_t count) {
  for (size_t k = 0; k < count; k++)
    if (list[k] == array)
      return true;
  return false;
}

void nb_owner_keep(struct nb_owner *owner, void *const kept[], size_t count) {
  for (size_t k = 0; k < owner->count; k++)
    if (!listed(owner->list[k], kept, count)) {
      free(owner->list[k]);
      owner->list[k] = NULL;
    }
}
