/* The manual, made from the tables that the program itself reads: commands, options, statements, quantities, units.
 *
 *   manual.c        what is in it, in which order
 *   manual_text.c   for the terminal: nineball --help scene, nineball --help WORD
 *   manual_md.c     docs/LANGUAGE.md
 *   manual_man.c    docs/nineball.1
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MANUAL_H
#define NB_MANUAL_H

#include <stdbool.h>
#include <stdio.h>

struct nb_keyword;
struct nb_expectation_row;

/* How it is written. A text may hold `code` between backticks; an example is whole lines, the last without its end. */
struct nb_manner {
  void (*section)(FILE *out, const char *title);
  void (*words)(FILE *out, const char *text);                                      /* a paragraph */
  void (*item)(FILE *out, const char *word, const char *syntax, const char *help); /* a statement, a command */
  void (*part)(FILE *out, const char *name, const char *text);                     /* what belongs to an item */
  void (*row)(FILE *out, const char *name, const char *unit, const char *text);    /* of a list; unit or NULL */
  void (*example)(FILE *out, const char *block, const char *lines);                /* of an item */
  void (*end_item)(FILE *out);
  void (*end_list)(FILE *out);
};
extern const struct nb_manner nb_manner_text, nb_manner_md, nb_manner_man;

/* A line of the program's own help: "-o, --output FOLDER" and what that does. */
struct nb_help_row {
  const char *term, *help;
};

/* All words of a page, with what they take and examples, or only how they are written and one sentence each. */
void nb_manual_language(FILE *out, const struct nb_manner *manner, bool whole);
/* docs/LANGUAGE.md: a page too, whose blocks are the examples. */
void nb_manual_md(FILE *out);
/* docs/nineball.1. Both lists end in a row without a term. */
void nb_manual_man(FILE *out, const struct nb_help_row *commands, const struct nb_help_row *options);
/* All about one word of a page: a statement, what follows a measure, a clause of statements, a quantity. False: there is none; then `hint`
 * (NB_NAME_SIZE * 2 bytes) holds the nearest one, or is empty. */
bool nb_manual_word(FILE *out, const char *word, char *hint);

#endif
