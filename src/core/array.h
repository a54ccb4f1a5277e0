/* Arrays: for wide loops, and ones that grow.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ARRAY_H
#define NB_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/* Zeroed and aligned for wide loads; NULL only when memory is out. Freed by free(). */
void *nb_array(size_t count, size_t size);
/* Room for `more` elements after `count` in an array that has grown by this function only: the array, moved perhaps, or NULL
 * when memory is out (the old one stays). Freed by free(). */
void *nb_array_reserve(void *array, size_t count, size_t more, size_t element);
/* Room for one more element after `count` in such an array: `array` points to the pointer to it. False when memory is out; then nothing
 * has changed. */
bool nb_array_grow(void *array, size_t count, size_t element);
/* One more element, all bits 0, at the end of such an array. NULL when memory is out; then nothing has changed. */
void *nb_array_add(void *array, size_t *count, size_t element);
#define NB_ARRAY_APPEND(array, count) nb_array_add(&(array), &(count), sizeof *(array))

/* What is freed all at once, with its owner. */
struct nb_owner {
  void **list;
  size_t count;
  bool failed; /* memory was out once: asked when all is made */
};
/* As nb_array; freed with its owner. */
void *nb_own(struct nb_owner *owner, size_t count, size_t size);
void nb_owner_free(struct nb_owner *owner);

#endif
