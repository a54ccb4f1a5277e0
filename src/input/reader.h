/* The reader of pages. A line is split into tokens, each with its column. A row of a table of keywords says which
 * tokens its statement takes; other tokens are mistakes, which are reported with a caret. The reader stops reading a
 * statement at its first mistake, and goes on with the next statement. An unknown name is reported once, and not at all
 * if the statement that should define it has a mistake.
 *
 *   mistakes.c     messages, suppressed names       value.c      values from tokens
 *   line.c         tokens                           statement.c  a statement from tokens, by a row of a table
 *   expression.c   expressions in parentheses       guess.c      the nearest known word
 *   units.c        numbers and units             foreign.c    whole lines of other programs
 *   page_names.c   the page's names in hints     fill_hint.c  random packings of other programs
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/array.h"
#include "core/error.h"
#include "core/guess.h"
#include "units.h"

enum {
  NB_LINE_MAX = 4096,          /* bytes in a line */
  NB_TOKENS_MAX = 256,         /* a line has fewer tokens */
  NB_RUNS_MAX = 10000,         /* runs of a page */
  NB_PARTICLES_MAX = 10000000, /* particles of a scene */
  NB_NAMED_MAX = 2000,         /* named objects of each kind, such as walls: the search by name is linear */
  NB_MATERIALS_MAX = 200,      /* the program stores all pairs of materials */
  NB_SLOTS = 24,               /* values of a statement */
  NB_COUNT_MAX = 1000000000,   /* largest whole number: 1e9 cycles take 28 hours if each takes 0.1 ms */
  NB_PAGE_MAX = 4 << 20        /* bytes in a page */
};

/* ---- mistakes.c ---- */

/* Reports a mistake. The messages of a page are sorted by line. `line` and `column` are counted from 1, `length` in
 * characters; line 0: the whole page. `hint` may be NULL. A page without kind_of consists of --set texts; its messages
 * show no line number. At most a thousand mistakes are reported. */
void nb_mistake(struct nb_mistakes *mistakes, const struct nb_page *page, size_t line, int column, int length,
                const char *hint, const char *format, ...) __attribute__((format(printf, 7, 8)));

/* True if the last message, in the order of lines, is about this line and has a hint with the text. */
bool nb_mistake_hinted(const struct nb_mistakes *mistakes, size_t line, const char *text);
void nb_mistake_memory(struct nb_mistakes *mistakes); /* records that memory ran out */
/* NB_BAD_USE if a mistake was found since mistakes->total was `before`. NB_NO_MEMORY if memory ran out, also before
 * that. */
enum nb_status nb_mistakes_status(const struct nb_mistakes *mistakes, size_t before);

/* nb_suppress_name suppresses messages about a name that a mistake leaves undefined, or that has been reported.
 * nb_name_suppressed is true if messages about a name, or about its part before the dot, are suppressed. */
void nb_suppress_name(struct nb_mistakes *mistakes, const char *name);
#define NB_ANYTHING "*" /* all names */
bool nb_name_suppressed(const struct nb_mistakes *mistakes, const char *name);
/* As nb_name_suppressed, for what the statements of this word define: particles, walls, a cell. It is also true if the
 * scene has an unknown statement, NB_UNKNOWN, which might define them. */
#define NB_UNKNOWN "?"
bool nb_statement_suppressed(const struct nb_mistakes *mistakes, const char *word);
void nb_suppress_no_name(struct nb_mistakes *mistakes); /* allows all messages again, before a page is read again */

/* Index of the structure with that name in an array of structures that begin with their name; -1: none. */
int nb_find(const void *things, size_t count, size_t size, const char *name);
#define NB_FIND(things, count, name) nb_find(things, count, sizeof *(things), name)
/* Writes the hint "did you mean" with the nearest name of such structures to a text of NB_HINT_SIZE; NULL: no name is
 * near. */
const char *nb_nearest(char *hint, const char *word, const void *things, size_t count, size_t size);
#define NB_NEAREST(hint, word, things, count) nb_nearest(hint, word, things, count, sizeof *(things))

/* ---- page_names.c ---- */

/* True if a line of a block `scene` or `contact-test` begins with this word; *rest: the text after it. */
bool nb_page_statement(const struct nb_page *page, size_t line, const char *verb, const char **rest);
/* Copies the name that lines `VERB NAME` of the page define: the name that `line` has, else the only one. False: neither. */
bool nb_page_name_of(char name[NB_NAME_SIZE], const struct nb_page *page, const char *verb, size_t line);
/* Copies a hint about a line to a text of NB_HINT_SIZE. In each line between backquotes MATERIAL, GRADING and STAGE become
 * names of the page, unless the line has another word that stands for a value. */
const char *nb_page_hint(char *text, const struct nb_page *page, size_t line, const char *hint);

/* ---- line.c: tokens ---- */

struct nb_token {
  const char *text;
  int column, length; /* position in the line, in characters; of `$NAME` if the token is a value of a $NAME */
  const char *name;   /* NAME if the token is the value of $NAME; else NULL */
  bool computed;      /* by an expression; text is then a number as nb_binding_write writes it */
};

/* The value of $NAME in this run, from `let NAME = EXPRESSION`, `let NAME WORD` or `sweep NAME VALUES`. */
struct nb_binding {
  char name[NB_NAME_SIZE];
  char text[NB_NAME_SIZE]; /* a word; or a number and its unit, as written or, if computed, in SI */
  double value;            /* SI; NaN if it is a word */
  struct nb_dimension dimension;
  bool computed; /* by an expression; the value is then accepted as an angle or an angular velocity, too */
  bool swept;    /* the name has several values and is a column of the tables */
  bool used;     /* some line of the page uses the value */
  int sweep;     /* index of its `sweep` in the page, also if --set has left one value only; -1: it is from a `let` */
  int line;      /* that defines it */
};

struct nb_keyword;
/* The state of the reader. The caller sets page, mistakes, warnings, unitless and the bindings, and the other members
 * to 0. The reader owns nothing; its size is about 46 kB. */
struct nb_reader {
  const struct nb_page *page;
  struct nb_mistakes *mistakes;
  struct nb_warnings *warnings; /* of the scene; NULL: doubtful expressions are not reported */
  bool unitless;                /* `units none` */
  bool starts;                  /* the page continues another one: it has a `start` */
  bool has_units;               /* a number with a unit has been read */
  struct nb_binding *bindings;  /* the values of $NAME */
  size_t binding_count;

  size_t line; /* line of the statement, from 1 */
  struct nb_token tokens[NB_TOKENS_MAX];
  size_t count, next;                /* number of tokens; index of the next one to read */
  bool bad;                          /* the statement has a mistake: no other mistake is reported, and reading ends */
  const char *otherwise;             /* the hint for an unexpected token without a hint of its own; NULL: none */
  const struct nb_keyword *keyword;  /* the row of the statement while its fields are read, else NULL */
  const struct nb_keyword *row;      /* the row of the statement, also after its fields; or NULL */
  const struct nb_keyword *namesake; /* a row with the same words for another place, or NULL */
  unsigned here;                     /* the place of the statement, one of NB_IN_… */
  unsigned given;                    /* bit set of the fields that have been read */
  size_t used;                       /* bytes of the store in use, without the zero of the last token */
  char store[NB_LINE_MAX + NB_TOKENS_MAX * (2 * NB_NAME_SIZE + 2)]; /* the texts of the tokens */
};

/* A token with the column and the length of `length` bytes at `at` in a line, for a message. */
struct nb_token nb_token_at(const char *line, const char *at, size_t length);
/* Begins a line: the reader has no tokens and no mistake. */
void nb_line_begin(struct nb_reader *reader, size_t line);
/* The value of NAME, which a line uses; NULL: no `let` or `sweep` above defines NAME. */
const struct nb_binding *nb_use_binding(struct nb_reader *reader, const char *name);
/* Splits a line of the page into tokens; after `let NAME =` the rest of the line is one token. False if the line has no
 * tokens; line 0 has none. */
bool nb_line_read(struct nb_reader *reader, size_t line);
bool nb_line_has(const struct nb_reader *reader, const char *text);   /* true if a token of the line is this text */
const struct nb_token *nb_token_peek(const struct nb_reader *reader); /* the next token; NULL at the end of the line */
bool nb_token_is(const struct nb_reader *reader, const char *word);   /* true if the next token is this word */
bool nb_token_skip(struct nb_reader *reader, const char *word);       /* takes the next token if it is this word */
bool nb_is_name(const char *text); /* a letter, then letters, digits, _ and -; shorter than NB_NAME_SIZE */

/* The functions that report a mistake of a statement return false, so that callers can return their result. Only the
 * first mistake of a statement is reported; each function moves to the end of the line. */

/* Reports a mistake at a token; NULL: after the last token. */
bool nb_token_mistake(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* Copies a hint without the units of the numbers between its backquotes, for a page without units: `radius 5 mm` becomes
 * `radius 0.005`. */
const char *nb_hint_without_units(char *bare, const char *hint);
/* Reports a mistake at the first word of a line that was read before; line 0: a mistake of the whole page. */
bool nb_line_mistake(struct nb_reader *reader, size_t line, const char *hint, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* Reports "expected WHAT, found `token`" at the next token. */
bool nb_expected(struct nb_reader *reader, const char *hint, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Reports at the end of the line that no word of it begins with `begin`. No report if there is such a word, or if the
 * last message is about this line and its hint has `begin`. The line may already have another mistake. */
void nb_line_needs(struct nb_reader *reader, const char *begin, const char *hint, const char *what);
/* The hint for a word or number in quotes. */
#define NB_NO_QUOTES "write words and numbers without quotes"
/* Returns the hint for syntax of another language or a word processor, which is a constant or is written to `hint`, a
 * text of NB_HINT_SIZE; NULL: none. */
const char *nb_syntax_hint(const struct nb_reader *reader, char *hint, const char *text);
/* Appends at most 80 bytes of a word of the line to a hint, without a comma at its end, and with parentheses around an
 * expression: `0.2*2,` becomes `(0.2*2)`. */
void nb_append_operand(char *hint, const struct nb_reader *reader, const char *text);
/* Does the same as nb_expected, at a token that was read before. */
bool nb_expected_at(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what);
/* Does the same as nb_expected_at for an unknown name. Marks the statement as bad without a message if the name is
 * suppressed, and suppresses it otherwise. */
bool nb_unknown_name(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what);
/* Marks the statement as bad without a message, because the mistake follows from another one. */
bool nb_fail_silently(struct nb_reader *reader);
/* Records that memory ran out, and marks the statement as bad. */
bool nb_no_memory(struct nb_reader *reader);

/* ---- value.c ---- */

/* Each function takes one value from the line. If the line has no such value, the function reports what it expected and
 * returns false. */

enum nb_range { NB_ANY, NB_POSITIVE, NB_NOT_NEGATIVE, NB_FRACTION, NB_HALF }; /* all, > 0, >= 0, 0 to 1, 0 to 0.5 */

/* The words for a range in a message: " above 0", ", 0 or more", " from 0 to 1", … */
const char *nb_range_words(enum nb_range range);
bool nb_take_number(struct nb_reader *reader, enum nb_unit_kind kind, enum nb_range range, double *value); /* SI */
/* Takes the time after `at`; the message says that a number of cycles is possible, too. */
bool nb_take_time_at(struct nb_reader *reader, double *value); /* s */
/* Takes a number in a unit of the same dimension as `si_unit`, such as "N" or "kg.m/s". */
bool nb_take_in_unit(struct nb_reader *reader, const char *si_unit, double *value);
/* Takes such a number as a tolerance; `relative`: the message says that a percentage is possible, too. */
bool nb_take_tolerance(struct nb_reader *reader, const char *si_unit, bool relative, double *value);

/* names.c: a quantity or a measure `below` or `above` a number. */
struct nb_comparison {
  const char *name, *unit;
  unsigned bounds; /* set of enum nb_bound (core/names.h) */
  enum nb_relation relation;
  double value;                 /* SI */
  const struct nb_token *token; /* of the value */
};
/* Writes the hint for a percentage where the quantity `name` counts particles or contacts. */
const char *nb_count_hint(char *hint, const char *name, double fraction);
/* True if the comparison can hold and can fail, and a count is compared with a number. Otherwise, because of the bounds of
 * the quantity, false with a message. `what`: "a condition". */
bool nb_comparison_is_open(struct nb_reader *reader, const struct nb_comparison *comparison, const char *what);
/* Warns if the comparison always or never holds with all laws of the program; a law of the user's own with tensile forces
 * may change this. */
void nb_comparison_warn(struct nb_warnings *warnings, int line, const struct nb_comparison *comparison);
/* Warns of a negative normal stress, in a condition or an expectation of the quantity `name` (`relation`: "below",
 * "above" or "expected"), or in a statement `name` with the target `relation`, without a quantity. */
void nb_tension_warn(struct nb_scene *scene, const struct nb_quantity *quantity, const char *name, const char *relation,
                     double value, int line);
/* Warns of a condition or an expectation, `what`, that compares the stress `name` while the servo of stage `s` controls
 * another stress, if friction at the walls makes the two stresses differ. False: out of memory. */
bool nb_servo_compare(struct nb_scene *scene, size_t s, struct nb_quantity quantity, const char *name, const char *what,
                      int line);
bool nb_take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value);
bool nb_take_count_of(struct nb_reader *reader, const char *one, unsigned long *value); /* `1 cycle`, `5 cycles` */
bool nb_take_word(struct nb_reader *reader, const char *word);                          /* takes this word */
int nb_take_choice(struct nb_reader *reader, const char *words); /* index of one of "none|x|y", from 0; or -1 */
/* The first function takes any token, the second one a token that can be a name (nb_is_name). NULL with a message,
 * which says `what`. */
const struct nb_token *nb_take_token(struct nb_reader *reader, const char *what);
const struct nb_token *nb_take_name(struct nb_reader *reader, const char *what);
/* Index of the structure that a token names, found by nb_find. -1 if there is none: with a message, unless the token is
 * NULL or the name is suppressed. The hint of the message is the nearest name, or `otherwise` if no name is near. */
int nb_named(struct nb_reader *reader, const struct nb_token *token, const void *things, size_t count, size_t size,
             const char *what, const char *otherwise);
#define NB_NAMED(reader, token, things, count, what, otherwise)                                                        \
  nb_named(reader, token, things, count, sizeof *(things), what, otherwise)

/* ---- statement.c: whole statements ---- */

/* Where a statement may stand, a bit set. */
enum {
  NB_IN_SCENE = 1,
  NB_IN_STAGE = 2,
  NB_IN_EXPECT = 4,
  NB_IN_RAMP = 8, /* in a line after the word `ramp` */
  NB_IN_CONTACT_TEST = 16,
  NB_IN_SEGMENT = 32,
  NB_IN_CELL = 64,   /* for the manual: the example needs a scene with a cell, so it is no part of the manual's page */
  NB_IN_START = 128, /* after `start`, before the first stage */
  NB_OWN_EXAMPLE = 256 /* for the manual: the example of the row is a page of its own */
};

enum nb_argument_kind {
  NB_ARGUMENT_NUMBER, /* a number of the kind `unit` within `range` */
  NB_ARGUMENT_COUNT,  /* a whole number, 1 or more */
  NB_ARGUMENT_NAME,   /* a new name */
  NB_ARGUMENT_WORD,   /* a name that is defined above */
  NB_ARGUMENT_CHOICE, /* one of the words of `value`, "none|x|y"; its number is the index of the word */
  NB_ARGUMENT_FLAG    /* only the word of the clause, without a value */
};

struct nb_argument {
  const char *word;  /* word or words of the clause; NULL: a positional argument */
  const char *value; /* as shown in the manual: "R", "VX VY" */
  enum nb_argument_kind kind;
  enum nb_unit_kind unit;
  enum nb_range range;
  int slot, count;       /* first slot of the values in the record; number of values */
  const char *otherwise; /* default, for the manual; NULL: required; "|…": one of several such arguments is required;
                            "+…": required with the argument before it */
  const char *help;      /* for names and words, messages use this text too: "the name of a material" */
};

struct nb_value {
  const struct nb_token *token; /* NULL: the value is not given */
  double number;                /* SI; 0 if not given */
};
struct nb_record {
  const struct nb_keyword *keyword;
  struct nb_value value[NB_SLOTS];
};

struct nb_keyword {
  /* First word or words of the statement; NULL: for lines that begin with the words of no other row. */
  const char *word;
  unsigned where;
  const struct nb_argument *arguments; /* the last one has count 0 */
  const char *tail; /* syntax, for the manual, of the tokens that apply reads from reader->next on; or NULL */
  int variant;      /* distinguishes rows with the same apply */
  bool always;      /* apply is called after a mistake, too, because the lines below belong to this statement */
  /* Called when all values have been read and checked. subject: the argument of nb_statement_read. */
  void (*apply)(struct nb_reader *reader, const struct nb_record *record, void *subject);
  const char *help;
  const char *example; /* lines of a page; all examples of scenes together are the page in docs/LANGUAGE.md */
};

/* A table of keywords is an array of families of rows. The last row of each family has no apply; the last family has no
 * rows. */
struct nb_family {
  const struct nb_keyword *rows;
};
/* Row k of all families; NULL after the last one. */
const struct nb_keyword *nb_keyword_row(const struct nb_family *table, size_t k);

/* Reads the statement in reader->tokens by its row in a table; `here`: one of NB_IN_…. */
void nb_statement_read(struct nb_reader *reader, const struct nb_family *table, unsigned here, void *subject);
/* Writes "for example `EXAMPLE`", with the line of the statement's example that has most words of this line. NULL: the
 * statement has no example, or its example has several lines that have at most one word of this line. */
const char *nb_example_hint(char *hint, const struct nb_reader *reader);
/* Writes the hint for words such as `velocity of sphere 1`: the monitor and its quantities; or the hint for two words
 * that together mean a quantity in other programs. NULL: the words are neither. */
const char *nb_phrase_hint(char *hint, const struct nb_scene *scene, const struct nb_token *tokens, size_t count);
bool nb_begins_clause(const struct nb_argument *field, const char *word); /* such as `at` of `at most` */
/* Copies the first word into NB_NAME_SIZE bytes. True: there are more words. */
bool nb_first_word(char *first, const char *words);
/* Writes the syntax of a statement: "disc X Y radius R MATERIAL {velocity VX VY} {spin W} {fixed}". */
void nb_keyword_syntax(char *text, size_t size, const struct nb_keyword *keyword);
/* The statements of scene and contact-test blocks, for reading, --help and the manual. */
const struct nb_family *nb_keywords(void);

/* servo.c: writes the line `servo …` that the tokens mean, for the cell, the box or the boundary of the page. False: the
 * page has none of them, or the line has no number. */
bool nb_servo_hint(char *hint, const struct nb_reader *reader);
/* servo.c: the object of the page that a servo can strain, `cell`, `box` or `boundary`; NULL: the page defines none. */
const char *nb_page_place(const struct nb_page *page);
/* foreign.c: writes the line of the page language that a line of another program or of a textbook means, with its numbers
 * and names, and returns `hint`. NULL: the line is not known. */
const char *nb_foreign_hint(char *hint, const struct nb_reader *reader);
/* fill_hint.c: writes the lines `grading` and `fill` that the tokens mean, such as `random discs 200 radius 2 mm`. */
const char *nb_fill_hint(char *hint, const struct nb_reader *reader);
/* wall.c: writes three lines `wall …` for `box X Y to X Y MATERIAL open top`; `token` is the word after the material. False:
 * the line is another. */
bool nb_open_box_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token);

/* ---- page.c ---- */

enum nb_block_kind {
  NB_BLOCK_SCENE,
  NB_BLOCK_EXPECT,
  NB_BLOCK_GNUPLOT,
  NB_BLOCK_CONTACT_TEST,
  NB_BLOCK_KINDS,
  NB_BLOCK_HIDDEN = NB_BLOCK_KINDS /* an ignored expect block: in a quote, in a list or indented by four spaces */
};
/* Sets *name to the beginning of the page's name in the path. Returns the length of the name. */
size_t nb_page_name(const char *path, const char **name);

/* The kind of block that a word names; -1: none. */
int nb_page_kind(const char *word, size_t length);
/* Returns the length of a fence, and sets its sign and its info string; 0: the line is not a fence. */
size_t nb_fence(const char *line, char *sign, const char **info);
/* Line of the opening fence of the first block of this kind that has a line; 0: the page has none. */
size_t nb_page_fence(const struct nb_page *page, enum nb_block_kind kind);
/* Reads a page of at most `most` bytes. */
enum nb_status nb_page_read_limited(struct nb_page *page, const char *path, size_t most, struct nb_mistakes *mistakes);
/* Reads a page from memory; messages show the path. */
enum nb_status nb_page_read_bytes(struct nb_page *page, const char *path, const char *bytes, size_t size,
                                  struct nb_mistakes *mistakes);

/* ---- refine.c ---- */

/* True if a number of cycles that `--set refine=R` has multiplied is whole, except for the rounding of R. *whole: the
 * nearest whole number. */
bool nb_refined_is_whole(double product, double *whole);

/* ---- file.c ---- */

enum {
  NB_FILE_MAX = 1 << 30, /* bytes of a list or a state */
  NB_PATH_SIZE = 4096
};

/* Finds the file that a page names, and writes its path to `path`, which has NB_PATH_SIZE bytes. The search begins in
 * the folder of the page. Unless the name begins with `/` or has a part `..`, it continues in the nearest folder
 * `cases` above the page, and in the folders up to 8 levels below that one, without hidden folders and links. If there
 * is no such file, opening `path` fails. False with a message if several of these folders have such a file, or if the
 * path is too long. */
bool nb_file_find(struct nb_reader *reader, const struct nb_token *token, const char *ending, char *path);
/* Opens a regular file for reading; NULL with an error, "cannot be read: …", without the path. Pipes and devices are
 * refused because they may never end. */
FILE *nb_file_open(const char *path, struct nb_error *error);
/* Reads a regular file of at most `most` bytes and adds a terminating zero. The caller frees the text. NULL with an
 * error. */
char *nb_file_read(const char *path, size_t most, size_t *size, struct nb_error *error);

/* ---- line.c: arrays that grow by nb_array_reserve ---- */

/* Appends a copy of an element; false, with the statement bad, if there is no memory. */
bool nb_array_append(struct nb_reader *reader, void *array, size_t *count, const void *element, size_t size);
#define NB_APPEND(reader, array, count, element)                                                                       \
  nb_array_append(reader, &(array), &(count), &(element), sizeof *(array))
