/* "Did you mean": the valid word most similar to the one on the page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_GUESS_H
#define NB_GUESS_H

#include "error.h"

/* Begin with the word, offer all valid ones, then ask for the best. */
struct nb_guess {
  const char *word;
  char best[2 * NB_NAME_SIZE];
  int distance;
};
struct nb_guess nb_guess_begin(const char *word);
void nb_guess_offer(struct nb_guess *guess, const char *word);
bool nb_guess_found(const struct nb_guess *guess); /* whether `best` is similar enough */
/* The hint "did you mean `best`?" in a text of NB_HINT_SIZE; NULL when no word is similar enough. */
enum { NB_HINT_SIZE = 512 };
const char *nb_guess_hint(const struct nb_guess *guess, char *text);

#endif
