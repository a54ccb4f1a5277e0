/* Words of the page language of version 0.3 and their replacements. The table is in old_words.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OLD_WORDS_H
#define NB_OLD_WORDS_H

#include "core/guess.h"
#include "text.h"

/* What a row renames. */
enum nb_old_kind {
  NB_OLD_STATEMENT, /* of a scene, a stage or a contact test: words of the line, from its first one on */
  NB_OLD_EXPECT,    /* the same in an expectation */
  NB_OLD_QUANTITY,  /* parts of a quantity's name after its owner: in `record`, `until`, expectations and figures */
  NB_OLD_PLAIN,     /* the same for a quantity without an owner: at the beginning of the name */
  NB_OLD_COLUMN,    /* a whole name in a figure: a column of a snapshot, or a variable that a plot recipe reads */
  NB_OLD_FIGURE,    /* a word before such a name in a figure: `known C.normal/N`, `known_C_normal` */
  NB_OLD_FENCE      /* the kind of a block */
};

struct nb_old_word {
  enum nb_old_kind kind;
  const char *old, *now;
  const char *note; /* for hints; NULL: none */
};
const struct nb_old_word *nb_old_words(void); /* the last row has no words */

/* Adds a rewritten line to the text. Spacing and comments are kept, and columns where possible; a line without old
 * words is not changed. */
enum nb_old_block { NB_OLD_STATEMENTS, NB_OLD_EXPECTATIONS, NB_OLD_GNUPLOT, NB_OLD_OPENING, NB_OLD_PROSE };
void nb_old_line(struct nb_text *text, const char *line, enum nb_old_block block);
/* The hint for the old word in a line of a page, written to a text of NB_HINT_SIZE; NULL: it has none. The same for the
 * first line of a block. */
const char *nb_old_hint(char *hint, const struct nb_page *page, size_t line);
const char *nb_old_fence(char *hint, const char *line);
const char *nb_old_name(char *hint, const char *name); /* the same for the name of a quantity */
/* Prints the replacement of an old word; false: it is none. */
bool nb_old_help(FILE *out, const char *word);

/* Prints a warning for each value of a `let` or `sweep` that no row can rewrite: a $NAME, and an old word. */
void nb_old_warn(FILE *out, const char *path, size_t number, const char *line, enum nb_old_block block);

/* migrate.c: adds the rewritten page; changes the page while it runs. */
void nb_migrate(struct nb_text *text, char *page, const char *path, FILE *warnings);

#endif
