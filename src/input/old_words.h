/* Words of the page language of version 0.3 and their replacements. The table is in old_words.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/guess.h"
#include "text.h"

/* What a row renames. */
enum nb_old_kind {
  NB_OLD_STATEMENT, /* words of a line of a scene, a stage or a contact test, from the first word on */
  NB_OLD_EXPECT,    /* words of an expectation, from the first word on */
  NB_OLD_QUANTITY,  /* parts of a quantity's name after its owner: in `record`, `until`, expectations and figures */
  NB_OLD_PLAIN,     /* the whole name of a quantity without an owner: in the same places */
  NB_OLD_COLUMN,    /* a whole name in a figure: a column of a snapshot, or a variable that a plot recipe reads */
  NB_OLD_FIGURE,    /* a word before the name of a quantity in a figure: `known C.normal/N`, `known_C_normal` */
  NB_OLD_FENCE      /* the kind of a block */
};

struct nb_old_word {
  enum nb_old_kind kind;
  const char *old, *now;
  const char *note; /* for hints; NULL: none; "": no hint, the message itself shows the new line */
};
const struct nb_old_word *nb_old_words(void); /* the last row has no words */

/* The kind of a line. nb_old_line adds a rewritten line to the text. It keeps spacing and comments, and columns if
 * possible; it does not change a line without old words. */
enum nb_old_block { NB_OLD_STATEMENTS, NB_OLD_EXPECTATIONS, NB_OLD_GNUPLOT, NB_OLD_OPENING, NB_OLD_PROSE };
void nb_old_line(struct nb_text *text, const char *line, enum nb_old_block block);
/* Writes the hint for the old word in a line of a block, or of the --set texts, to a text of NB_HINT_SIZE. NULL: the
 * line has no old word. */
const char *nb_old_hint(char *hint, const struct nb_page *page, size_t line);
/* Does the same for the line that opens a block, with its old kind. */
const char *nb_old_fence(char *hint, const char *line);
/* The hint for the old name of a quantity; NULL: not an old one. */
const char *nb_old_name(char *hint, const char *name);
/* Prints the replacement of an old word; false: the word is not an old one. */
bool nb_old_help(FILE *out, const char *word);

/* Prints a warning for each old word that no row can rewrite, because it is a value of a `let` or `sweep`; and for `let
 * NAME $OTHER`, which needs an `=` if the value is a number. */
void nb_old_warn(FILE *out, const char *path, size_t number, const char *line, enum nb_old_block block);

/* migrate.c: adds the rewritten page to the text. The function changes the characters of `page` while it runs. */
void nb_migrate(struct nb_text *text, char *page, const char *path, FILE *warnings);
