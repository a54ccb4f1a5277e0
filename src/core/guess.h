/* "Did you mean": the known word nearest to the one that was written.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_GUESS_H
#define NB_GUESS_H

#include "error.h"

/* Begin with the word, offer all that would do, then ask. */
struct nb_guess {
  const char *word;
  char best[2 * NB_NAME_SIZE];
  int distance;
};
struct nb_guess nb_guess_begin(const char *word);
void nb_guess_offer(struct nb_guess *guess, const char *word);
bool nb_guess_found(const struct nb_guess *guess); /* whether best is near enough to be what was meant */
/* The hint "did you mean `best`?" in a text of NB_HINT_SIZE, or NULL when nothing is near. */
enum { NB_HINT_SIZE = 512 };
const char *nb_guess_hint(const struct nb_guess *guess, char *text);

#endif
