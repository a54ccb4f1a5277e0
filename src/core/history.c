/* Contact histories: see struct nb_history in block.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "model.h"

struct nb_history nb_history_create(struct nb_owner *owner, int doubles, size_t contacts) {
  struct nb_history history = {.doubles = doubles};
  if (doubles > NB_HISTORY)
    history.rows = nb_own(owner, contacts * (size_t)doubles, sizeof(double));
  for (int m = 0; m < doubles && doubles <= NB_HISTORY; m++)
    history.field[m] = nb_own(owner, contacts, sizeof(double));
  return history;
}

struct nb_history nb_history_from(const struct nb_history *history, size_t first) {
  struct nb_history from = *history;
  for (int m = 0; m < NB_HISTORY; m++)
    if (from.field[m])
      from.field[m] += first;
  if (from.rows)
    from.rows += first * (size_t)from.doubles;
  return from;
}

void nb_history_copy(struct nb_history *to, size_t there, const struct nb_history *from, size_t here) {
  const int doubles = to->doubles < from->doubles ? to->doubles : from->doubles;
  if (to->rows && from->rows)
    memcpy(to->rows + there * (size_t)to->doubles, from->rows + here * (size_t)from->doubles,
           (size_t)doubles * sizeof(double));
  for (int m = 0; m < NB_HISTORY; m++)
    if (to->field[m] && from->field[m])
      to->field[m][there] = from->field[m][here];
}

void nb_history_keep(struct nb_history *now, const struct nb_history *old, const int from[], size_t contacts) {
  const size_t doubles = (size_t)(now->doubles < old->doubles ? now->doubles : old->doubles);
  for (size_t c = 0; c < contacts && now->rows && old->rows; c++)
    if (from[c] >= 0)
      memcpy(now->rows + c * (size_t)now->doubles, old->rows + (size_t)from[c] * (size_t)old->doubles,
             doubles * sizeof(double));
  for (int m = 0; m < NB_HISTORY; m++)
    for (size_t c = 0; c < contacts && now->field[m] && old->field[m]; c++)
      now->field[m][c] = from[c] >= 0 ? old->field[m][from[c]] : now->field[m][c];
}

void nb_history_forget(struct nb_history *history, size_t contact) {
  for (int m = 0; m < NB_HISTORY; m++)
    if (history->field[m])
      history->field[m][contact] = 0;
  if (history->rows)
    history->rows[contact * (size_t)history->doubles] = 0;
}

const double *nb_history_read(const struct nb_history *history, size_t contact, double buffer[NB_HISTORY]) {
  if (history->rows)
    return history->rows + contact * (size_t)history->doubles;
  for (int m = 0; m < NB_HISTORY; m++)
    buffer[m] = history->field[m] ? history->field[m][contact] : 0;
  return buffer;
}
