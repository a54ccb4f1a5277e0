/* Words of the page language of 0.3 and those of today. The table is in old_words.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OLD_WORDS_H
#define NB_OLD_WORDS_H

#include "core/guess.h"
#include "text.h"

/* What a row is about. */
enum nb_old_kind {
  NB_OLD_STATEMENT, /* of a scene, a stage or a contact test: words of the line, from its first one on */
  NB_OLD_EXPECT,    /* the same of an expectation */
  NB_OLD_QUANTITY,  /* the name of a quantity without its owner: in `record`, `until`, expectations and figures */
  NB_OLD_PLAIN,     /* the same of a quantity without an owner: at the beginning of the name */
  NB_OLD_COLUMN,    /* a whole name in a figure: a column of a snapshot, or a variable that a recipe reads */
  NB_OLD_FIGURE,    /* what stands before such a name in a figure: `known C.normal/N`, `known_C_normal` */
  NB_OLD_FENCE      /* the kind of a block */
};

struct nb_old_word {
  enum nb_old_kind kind;
  const char *old, *now;
};
const struct nb_old_word *nb_old_words(void); /* ends in a row without words */

/* Adds the line to the text in the words of today: of a block `expect`, of `gnuplot`, or of statements; or the first line of a
 * block. Spacing and comments are kept, columns where they can be. What is in the words of today comes out as it is. */
enum nb_old_block { NB_OLD_STATEMENTS, NB_OLD_EXPECTATIONS, NB_OLD_GNUPLOT, NB_OLD_OPENING, NB_OLD_PROSE };
void nb_old_line(struct nb_text *text, const char *line, enum nb_old_block block);
/* The hint for a line of a page that has an old word, in a text of NB_HINT_SIZE; NULL: it has none. Likewise of a block's first line. */
const char *nb_old_hint(char *hint, const struct nb_page *page, size_t line);
const char *nb_old_fence(char *hint, const char *line);
const char *nb_old_name(char *hint, const char *name); /* likewise of the name of a quantity */
/* Says what has become of an old word; false: it is none. */
bool nb_old_help(FILE *out, const char *word);

/* migrate.c: adds the whole page, a text that is changed meanwhile. */
void nb_migrate(struct nb_text *text, char *page);

#endif
