/* What the laws remember of their contacts: see struct nb_memory in block.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "model.h"

struct nb_memory nb_memory_create(struct nb_owner *owner, int doubles, size_t contacts) {
  struct nb_memory memory = {.doubles = doubles};
  if (doubles > NB_MEMORY)
    memory.rows = nb_own(owner, contacts * (size_t)doubles, sizeof(double));
  for (int m = 0; m < doubles && doubles <= NB_MEMORY; m++)
    memory.field[m] = nb_own(owner, contacts, sizeof(double));
  return memory;
}

struct nb_memory nb_memory_from(const struct nb_memory *memory, size_t first) {
  struct nb_memory from = *memory;
  for (int m = 0; m < NB_MEMORY; m++)
    if (from.field[m])
      from.field[m] += first;
  if (from.rows)
    from.rows += first * (size_t)from.doubles;
  return from;
}

void nb_memory_copy(struct nb_memory *to, size_t there, const struct nb_memory *from, size_t here) {
  const int doubles = to->doubles < from->doubles ? to->doubles : from->doubles;
  if (to->rows && from->rows)
    memcpy(to->rows + there * (size_t)to->doubles, from->rows + here * (size_t)from->doubles,
           (size_t)doubles * sizeof(double));
  for (int m = 0; m < NB_MEMORY; m++)
    if (to->field[m] && from->field[m])
      to->field[m][there] = from->field[m][here];
}

void nb_memory_forget(struct nb_memory *memory, size_t contact) {
  for (int m = 0; m < NB_MEMORY; m++)
    if (memory->field[m])
      memory->field[m][contact] = 0;
  if (memory->rows)
    memory->rows[contact * (size_t)memory->doubles] = 0;
}

const double *nb_memory_read(const struct nb_memory *memory, size_t contact, double room[NB_MEMORY]) {
  if (memory->rows)
    return memory->rows + contact * (size_t)memory->doubles;
  for (int m = 0; m < NB_MEMORY; m++)
    room[m] = memory->field[m] ? memory->field[m][contact] : 0;
  return room;
}
