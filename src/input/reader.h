/* The reader: a page is read line by line; a line becomes tokens, each with its place; a row of a table of keywords says what the
 * tokens must be; what they are not is a mistake with a caret. A statement stops at its first mistake, and the page goes on with the
 * next one. What the statement would have given a name to is not asked about any more, and a name that is not known is said once.
 *
 *   mistakes.c    messages, the nearest known word, names that nothing is said of    value.c      values taken from tokens
 *   line.c        tokens; expression.c computes those in parentheses                 statement.c  tokens + a row of a table -> values
 *   units.c       numbers and units
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_READER_H
#define NB_READER_H

#include "core/array.h"
#include "core/error.h"
#include "core/guess.h"
#include "units.h"

enum {
  NB_LINE_MAX = 4096,          /* bytes in a line */
  NB_TOKENS_MAX = 256,         /* tokens in a line */
  NB_RUNS_MAX = 10000,         /* of a page */
  NB_PARTICLES_MAX = 10000000, /* of a scene */
  NB_NAMED_MAX = 2000,         /* of each sort of thing with a name: they are looked up one by one */
  NB_MATERIALS_MAX = 200,      /* as every one may meet every other */
  NB_SLOTS = 24,               /* values that a row of a table may ask for */
  NB_COUNT_MAX = 1000000000,   /* of anything that is counted: 1e9 cycles of 1 us are a day of computing */
  NB_PAGE_MAX = 4 << 20        /* bytes in a page */
};

/* ---- mistakes.c ---- */

/* Says one mistake, in its place among those of the same page. line counts from 1, 0: of the page as a whole. column
 * and length count characters from 1. hint may be NULL. A page without kind_of is made of --set texts and shows no line
 * number. Past a thousand mistakes nothing is said. */
void nb_mistake(struct nb_mistakes *mistakes, const struct nb_page *page, size_t line, int column, int length,
                const char *hint, const char *format, ...) __attribute__((format(printf, 7, 8)));

void nb_mistake_memory(struct nb_mistakes *mistakes); /* memory ran out: the page cannot be judged */
/* Of what has been made since there were `before`. */
enum nb_status nb_mistakes_status(const struct nb_mistakes *mistakes, size_t before);

/* A name that a mistake leaves unknown, or that has been said to be unknown; and whether it is one, or its part before the dot. */
void nb_excuse(struct nb_mistakes *mistakes, const char *name);
#define NB_ANYTHING "*" /* every name is one */
bool nb_excused(const struct nb_mistakes *mistakes, const char *name);
void nb_excuse_none(struct nb_mistakes *mistakes); /* forgets them: a run of a page is read from its beginning */

/* Things with a name: structures that begin with it, side by side. Index of one; -1: there is none. */
int nb_find(const void *things, size_t count, size_t size, const char *name);
#define NB_FIND(things, count, name) nb_find(things, count, sizeof *(things), name)
/* "did you mean": the hint with the nearest of their names in a text of NB_HINT_SIZE, or NULL. */
const char *nb_nearest(char *hint, const char *word, const void *things, size_t count, size_t size);
#define NB_NEAREST(hint, word, things, count) nb_nearest(hint, word, things, count, sizeof *(things))

/* ---- line.c: tokens ---- */

struct nb_token {
  const char *text;
  int column, length; /* in characters of the line; of the $NAME when it came from one */
  const char *name;   /* the NAME that it stands for, NULL when written in the line itself */
  bool computed;      /* by an expression: text is the shortest decimal number that reads back to the value */
};

/* `let NAME = EXPRESSION`, `let NAME WORD` and `sweep NAME VALUES`: what $NAME stands for in this run. */
struct nb_binding {
  char name[NB_NAME_SIZE];
  char text[NB_NAME_SIZE]; /* a word; a number and its unit as written, or of a computed value the SI ones */
  double value;            /* SI; NaN: a word */
  struct nb_dimension dimension;
  bool computed; /* by an expression: in its dimension it is an angle or an angular velocity as well */
  bool swept;    /* it has several values: a column of the tables */
  int sweep;     /* which `sweep` of the page it comes from, though --set may have left it one value; -1: a `let` */
};

struct nb_keyword;
/* What reading needs: set page, mistakes, unitless and the bindings, zero the rest. It owns nothing. About 60 kB. */
struct nb_reader {
  const struct nb_page *page;
  struct nb_mistakes *mistakes;
  bool unitless;                     /* `units none` */
  const struct nb_binding *bindings; /* what $NAME stands for */
  size_t binding_count;

  size_t line; /* the statement: its line, from 1 */
  struct nb_token tokens[NB_TOKENS_MAX];
  size_t count, next; /* how many, and which one is to be read */
  bool bad;           /* a mistake was made in this statement: no other one is said, and there is nothing to be read */
  const struct nb_keyword *keyword; /* its row while the fields of the row are read, else NULL */
  const struct nb_keyword *twin;    /* a row of the same words that belongs elsewhere, or NULL */
  unsigned here;                    /* where the statement stands */
  unsigned given;                   /* set of the fields that have been read */
  size_t used;                      /* of the store, up to the zero of the last token */
  char store[NB_LINE_MAX + NB_TOKENS_MAX * (2 * NB_NAME_SIZE + 2)]; /* the texts of the tokens */
};

/* The place of so many bytes of a line, for a message. */
struct nb_token nb_token_at(const char *line, const char *at, size_t length);
/* Begins to read a line: there are no tokens, and nothing is wrong. */
void nb_line_begin(struct nb_reader *reader, size_t line);
/* Cuts a line of the page into tokens; behind `let NAME =` the rest of it is one. False when it has none, as line 0 has. */
bool nb_line_read(struct nb_reader *reader, size_t line);
const struct nb_token *nb_token_peek(const struct nb_reader *reader); /* NULL at the end of the line */
bool nb_token_is(const struct nb_reader *reader, const char *word);   /* whether the next one is that word */
bool nb_token_skip(struct nb_reader *reader, const char *word);       /* takes it if it is */
bool nb_is_name(const char *text); /* a letter, then letters, digits, _ and -; shorter than NB_NAME_SIZE */

/* What says a mistake of a statement answers false, so that what takes something can end with it. All but the first one of a
 * statement are silent, and move to the end of the line. */

/* At a token, or behind the last one when it is NULL. */
bool nb_token_mistake(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* Of a statement that was read before: at the first word of its line, or of the page as a whole at line 0. */
bool nb_line_mistake(struct nb_reader *reader, size_t line, const char *hint, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* The most usual one: "expected WHAT, found `token`", at the next one. */
bool nb_expected(struct nb_reader *reader, const char *hint, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* What to type instead of what another language or a word processor would have there, or NULL; hint has room for NB_HINT_SIZE. */
const char *nb_typed_hint(const struct nb_reader *reader, char *hint, const char *text);
/* The same as nb_expected at a token that was read before. */
bool nb_expected_at(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what);
/* The same of a name that is not known: once for each name, and not where a mistake is why. */
bool nb_not_known(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what);
/* No mistake but what follows from one: the statement is bad, and nothing is said. */
bool nb_silent(struct nb_reader *reader);
/* nb_mistake_memory, and the statement is bad. */
bool nb_no_memory(struct nb_reader *reader);

/* ---- value.c: values one by one. Each takes what it names from the line, or says what it expected and answers false. ---- */

enum nb_range { NB_ANY, NB_POSITIVE, NB_NOT_NEGATIVE, NB_FRACTION, NB_HALF }; /* all, > 0, >= 0, 0 to 1, 0 to 0.5 */

/* " above 0", ", 0 or more", " from 0 to 1", or nothing. */
const char *nb_range_words(enum nb_range range);
bool nb_take_number(struct nb_reader *reader, enum nb_unit_kind kind, enum nb_range range, double *value); /* SI */
bool nb_take_in(struct nb_reader *reader, const char *si_unit,
                double *value); /* in a unit of that kind: "N", "kg.m/s" */
bool nb_take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value);
bool nb_take_counted(struct nb_reader *reader, const char *one, unsigned long *value); /* `1 cycle`, `5 cycles` */
bool nb_take_word(struct nb_reader *reader, const char *word);                         /* exactly that */
int nb_take_choice(struct nb_reader *reader, const char *words); /* which of "none|x|y", from 0; -1: none of them */
/* Any token, or a new name; `what` for the message; or NULL. */
const struct nb_token *nb_take(struct nb_reader *reader, const char *what);
const struct nb_token *nb_take_name(struct nb_reader *reader, const char *what);
/* Index of what a token names among things that begin with their name, -1 with a message; `otherwise` is the hint where none is near. */
int nb_named(struct nb_reader *reader, const struct nb_token *token, const void *things, size_t count, size_t size,
             const char *what, const char *otherwise);
#define NB_NAMED(reader, token, things, count, what, otherwise)                                                        \
  nb_named(reader, token, things, count, sizeof *(things), what, otherwise)

/* ---- statement.c: whole statements ---- */

/* Where a statement may stand; a set. */
enum {
  NB_IN_SCENE = 1,
  NB_IN_STAGE = 2,
  NB_IN_EXPECT = 4,
  NB_IN_RAMP = 8, /* behind the word `ramp` */
  NB_IN_PATH = 16,
  NB_IN_SEGMENT = 32,
  NB_IN_CELL =
      64, /* with one of the first two: of a scene without walls, so its example is none of the manual's page */
  NB_IN_START = 128, /* behind `start`, before the first stage */
  NB_APART = 256     /* its example is a page of its own, for the manual */
};

enum nb_argument_kind {
  NB_ARGUMENT_NUMBER, /* of `unit` and within `range` */
  NB_ARGUMENT_COUNT,  /* a whole number, 1 or more */
  NB_ARGUMENT_NAME,   /* a new name */
  NB_ARGUMENT_WORD,   /* a name that something has already */
  NB_ARGUMENT_CHOICE, /* one of the words of its value, "none|x|y": its number, from 0 */
  NB_ARGUMENT_FLAG    /* the clause word alone */
};

struct nb_argument {
  const char *word;  /* or words of the clause; NULL: a value that stands by itself, in the order of the row */
  const char *value; /* how the manual writes the value: "R", "VX VY" */
  enum nb_argument_kind kind;
  enum nb_unit_kind unit;
  enum nb_range range;
  int slot, count; /* where the values go in the record, and how many there are */
  const char
      *otherwise; /* what holds without it, for the manual; NULL: it must be there; "|…": it or another one such must */
  const char *help; /* for names and words also what is expected: "the name of a material" */
};

struct nb_value {
  const struct nb_token *token; /* where it was written; NULL: it was not */
  double number;                /* SI; 0 when not written */
};
struct nb_record {
  const struct nb_keyword *keyword;
  struct nb_value value[NB_SLOTS];
};

struct nb_keyword {
  const char
      *word; /* what it begins with: the verb, and words behind it; NULL: a line that begins with none of the others */
  unsigned where;
  const struct nb_argument *arguments; /* ends in a row with count 0 */
  const char *tail; /* how the manual writes what apply reads by itself from reader->next on; or NULL */
  int variant;      /* for an apply that serves several rows */
  bool always;      /* apply is called even if the statement is bad, for the lines below belong to what it begins */
  /* Every value is read, and checked for all that the row can say. subject: what the caller of nb_statement_read
   * gave. */
  void (*apply)(struct nb_reader *reader, const struct nb_record *record, void *subject);
  const char *help;
  const char *example; /* lines of a page; those of all rows, in their order, are the page docs/LANGUAGE.md */
};

/* A table of keywords is a list of families of rows; the rows of each end in one without apply, the list in a family without rows. */
struct nb_family {
  const struct nb_keyword *rows;
};
/* Row by row of all families; NULL past the last one. */
const struct nb_keyword *nb_keyword_row(const struct nb_family *table, size_t k);

/* Reads the statement in reader->tokens by its row in a table. `here` is one of NB_IN_…. */
void nb_statement_read(struct nb_reader *reader, const struct nb_family *table, unsigned here, void *subject);
bool nb_begins_clause(const struct nb_argument *field, const char *word); /* `at` of a clause `at most` */
/* Of "lattice discs" the first, into NB_NAME_SIZE bytes; whether there are more. */
bool nb_first_word(char *first, const char *words);
/* "disc X Y radius R MATERIAL {velocity VX VY} {spin W} {fixed}" */
void nb_keyword_syntax(char *text, size_t size, const struct nb_keyword *keyword);
/* The statements of scene and path blocks, for reading, --help and the manual. */
const struct nb_family *nb_keywords(void);

/* ---- page.c ---- */

enum nb_block_kind {
  NB_BLOCK_SCENE,
  NB_BLOCK_EXPECT,
  NB_BLOCK_GNUPLOT,
  NB_BLOCK_PATH,
  NB_BLOCK_KINDS,
  NB_BLOCK_HIDDEN =
      NB_BLOCK_KINDS /* an expect block that is not read: in a quote, in a list or indented by four spaces */
};
size_t nb_page_name(const char *path, const char **name); /* where in the path its name is, and how many bytes of it */

/* The kind of block that a word names; -1: none. */
int nb_page_kind(const char *word, size_t length);
/* The length of the fence that a line is, its sign and where its info string begins; 0: it is none. */
size_t nb_fence(const char *line, char *sign, const char **info);
/* Line of the fence of the first such block, 0: none. */
size_t nb_page_fence(const struct nb_page *page, enum nb_block_kind kind);
/* A page of at most so many bytes. */
enum nb_status nb_page_read_most(struct nb_page *page, const char *path, size_t most, struct nb_mistakes *mistakes);
/* A page from memory, under this path. */
enum nb_status nb_page_read_bytes(struct nb_page *page, const char *path, const char *bytes, size_t size,
                                  struct nb_mistakes *mistakes);

/* ---- file.c ---- */

enum {
  NB_FILE_MAX = 1 << 30, /* bytes that are read at most, of a list or a state */
  NB_PATH_SIZE = 4096
};

/* Where the file lies that the page names, with that ending: beside the page; else, unless the name begins with `/` or leads upward by
 * `..`, in whichever folder has it of the nearest `cases` that the page lies in and those below. What is nowhere is beside the page: to open
 * it is to hear so. False with a message when several folders have it. `path` has NB_PATH_SIZE bytes. */
bool nb_file_find(struct nb_reader *reader, const struct nb_token *token, const char *ending, char *path);
/* A regular file, open for reading; NULL with an error, "cannot be read: …", without the path. A folder is none, nor is a pipe or a device: one that never ends would
 * be waited for without end. */
FILE *nb_file_open(const char *path, struct nb_error *error);
/* All of a regular file of at most so many bytes, with a terminating zero; to be freed. NULL with an error. */
char *nb_file_read(const char *path, size_t most, size_t *size, struct nb_error *error);

/* ---- line.c: arrays that grow by nb_array_reserve ---- */

/* One more element, a copy of that one; false, with the statement bad, when there is no memory. */
bool nb_array_append(struct nb_reader *reader, void *array, size_t *count, const void *element, size_t size);
#define NB_APPEND(reader, array, count, element)                                                                       \
  nb_array_append(reader, &(array), &(count), &(element), sizeof *(array))

#endif
