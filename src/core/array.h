/* Arrays: for wide loops, and ones that grow.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_ARRAY_H
#define NB_ARRAY_H

#include <stddef.h>

/* Zeroed and aligned for wide loads; NULL only when memory is out. Freed by free(). */
void *nb_array(size_t count, size_t size);
/* Room for `more` elements after `count` in an array that has grown by this function only: the array, moved perhaps, or NULL
 * when memory is out (the old one stays). Freed by free(). */
void *nb_room(void *array, size_t count, size_t more, size_t element);

#endif
