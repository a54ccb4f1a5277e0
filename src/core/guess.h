/* "Did you mean": the known word nearest to the one that was written, or one that stands for a word of another program.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_GUESS_H
#define NB_GUESS_H

#include "error.h"

enum { NB_HINT_SIZE = 512 };

/* A row of words of other programs and textbooks, for which we say others. */
struct nb_synonym {
  const char *words, *ours; /* "ball disk", "disc, sphere" */
  const char *note;         /* "there is no local damping"; NULL: nothing to say */
};
const struct nb_synonym *nb_synonym(const char *word); /* NULL: none */
/* "`ball` is called `disc` or `sphere` here: …", in a text of NB_HINT_SIZE; NULL: it is no such word. */
const char *nb_synonym_hint(char *hint, const char *word);
/* Takes the next item of "disc, sphere"; false: there is none. */
bool nb_item(const char **list, char item[NB_NAME_SIZE]);

/* Begin with the word, offer all that would do, then ask. */
struct nb_guess {
  const char *word;
  const struct nb_synonym *synonym; /* of the word, and the set of our words in it that have been offered */
  unsigned marked;
  char best[2 * NB_NAME_SIZE];
  int distance;
};
struct nb_guess nb_guess_begin(const char *word);
void nb_guess_offer(struct nb_guess *guess, const char *known);
bool nb_guess_found(const struct nb_guess *guess); /* whether best is near enough to be what was meant */
/* The hint "did you mean `best`?" in a text of NB_HINT_SIZE, or NULL when nothing is near. */
const char *nb_guess_hint(const struct nb_guess *guess, char *text);

#endif
