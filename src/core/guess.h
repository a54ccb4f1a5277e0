/* "Did you mean": for an unknown word, the most similar keyword of nineball, or the keyword for a term of another
 * program.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "error.h"

enum { NB_HINT_SIZE = 512, NB_RELATED_MAX = 3 };

/* Terms of other programs and textbooks that have the same meaning, and the keywords of nineball for this meaning. */
struct nb_synonym {
  const char *words, *ours; /* terms of other programs, "ball disk"; keywords of nineball, "disc, sphere" */
  const char *note;         /* "there is no local damping"; NULL: no note */
};
/* The note about arithmetic with measures of several dimensions. */
#define NB_OTHER_DIMENSION                                                                                             \
  "a line has no arithmetic with measures, and it compares only measures of the same dimension: compare each measure " \
  "with a number, in a line of its own"
/* The beginning of the notes about random packings. A hint that begins with it is replaced by that of nb_fill_hint, which
 * has the numbers of the line. */
#define NB_RANDOM_PACKING "a random packing is two lines"
/* True if two words are equal but for capitals and for the signs `_`, `-` and `.` between their parts. */
bool nb_same_spelling(const char *a, const char *b);
const struct nb_synonym *nb_synonym(const char *word); /* NULL: not a term of another program */
/* Writes "`ball` of other programs is `disc` or `sphere` here: …" to `hint`, which has NB_HINT_SIZE bytes. Returns
 * `hint`; NULL: the word is no term of another program. */
const char *nb_synonym_hint(char *hint, const char *word);
/* The same two functions for a pair of words: a term such as `contact model`; or the name of a statement, or of a place
 * such as `expect`, and a word that was found there. */
const struct nb_synonym *nb_pair_synonym(const char *first, const char *second);
const char *nb_pair_hint(char *hint, const char *first, const char *second);
/* Copies the next item of a list like "disc, sphere" and advances the list; false: the list is empty. */
bool nb_item(const char **list, char item[NB_NAME_SIZE]);

/* The search for a keyword: begin with the unknown word, offer every valid keyword, then request the hint. */
struct nb_guess {
  const char *word;
  const struct nb_synonym *synonym; /* keywords with the meaning of the word; NULL: none */
  unsigned marked;                  /* bit i: keyword i of `synonym->ours` has been offered */
  char best[2 * NB_NAME_SIZE];      /* the most similar keyword so far */
  /* Edits from the word to `best`; 1 if the word is a part of `best` between dots, 0 if `best` has its meaning. */
  int distance;
  int related_count; /* keywords of which the word is such a part; `related` lists the first NB_RELATED_MAX */
  char related[NB_HINT_SIZE / 2 - 8];
};
struct nb_guess nb_guess_begin(const char *word);
void nb_guess_offer(struct nb_guess *guess, const char *known);
bool nb_guess_found(const struct nb_guess *guess); /* `best` is similar enough to be suggested */
/* Writes the hint "did you mean `best`?" to `text`, which has NB_HINT_SIZE bytes, and returns it. NULL: no keyword is
 * similar. */
const char *nb_guess_hint(const struct nb_guess *guess, char *text);
