/* Arrays for wide loops.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"

void *nb_array(size_t count, size_t size) {
  const size_t line = 64; /* a cache line, and the widest load */
  if (size && count > (SIZE_MAX - line) / size)
    return NULL;
  const size_t bytes = (count * size + line) / line * line; /* never nothing */
  void *array = aligned_alloc(line, bytes);
  if (array)
    memset(array, 0, bytes);
  return array;
}
