/* A hash of bytes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

/* FNV-1a, 64 bits (Fowler, Noll, Vo), continued from `hash`. */
#define NB_HASH_BEGIN 14695981039346656037ULL
static inline unsigned long long nb_hash(unsigned long long hash, const void *bytes, size_t size) {
  const unsigned char *c = bytes;
  for (size_t i = 0; i < size; i++)
    hash = (hash ^ c[i]) * 1099511628211ULL;
  return hash;
}
