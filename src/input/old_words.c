/* Words of the page language of version 0.3 and their replacements, for `nineball migrate`, for hints, and for `--help
 * OLDWORD`. This file has the only list of old words.
 *
 * To rename something, add a row. A row of statements or expectations is matched from the first word of the line:
 *
 *   small words     stand for themselves
 *   CAPITALS        any one word except `=`; NUMBER: a number. In the new form the same CAPITALS stand for this word
 *   …               any number of words, also none. In the new form it stands for these words
 *
 * So {NB_OLD_STATEMENT, "step F of safe", "step F of stable"} renames one word of one statement, and {NB_OLD_STATEMENT,
 * "fill … tries", "fill … attempts"} renames a clause in any place. The words after the matched ones stay. Rows are
 * applied from the top. Each is repeated while the line matches its old form and not its new one. So no row may change a
 * line that has a new form already; a test checks this.
 *
 * A row of quantities renames one or several parts of a name between dots: {NB_OLD_QUANTITY, "deviation", "std"} turns
 * `A.stress.deviation` into `A.stress.std`. If the old part begins with a dot (".unbalance"), the name must have an
 * owner. In figures the column "A.stress.deviation/Pa", the variable A_stress_deviation and the data block $load_bodies
 * are rewritten, too. A row of kind NB_OLD_PLAIN renames the whole name of a quantity without an owner.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "old_words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "core/names.h"
#include "reader.h"

const struct nb_old_word *nb_old_words(void) {
  /* clang-format off */
  static const struct nb_old_word words[] = {
    {NB_OLD_STATEMENT, "discs fill", "fill discs"},
    {NB_OLD_STATEMENT, "spheres fill", "fill spheres"},
    {NB_OLD_STATEMENT, "fill … tries", "fill … attempts"},
    {NB_OLD_STATEMENT, "discs lattice", "lattice discs"},
    {NB_OLD_STATEMENT, "spheres lattice", "lattice spheres"},
    {NB_OLD_STATEMENT, "discs packing FILE", "packing FILE discs"},
    {NB_OLD_STATEMENT, "spheres packing FILE", "packing FILE spheres"},
    {NB_OLD_STATEMENT, "let NAME NUMBER", "let NAME = NUMBER"},
    {NB_OLD_STATEMENT, "step F of safe", "step F of stable"},
    {NB_OLD_STATEMENT, "step F of contact", "step F of collision"},
    {NB_OLD_STATEMENT, "step F of critical", "step F of single-contact",
     "the critical step 2/omega_max of the assembly is not computed; `stable` is a lower bound of it: write `step 0.2 of stable`, with "
     "elastic spheres `step 0.2 of rayleigh`; `single-contact` is 2 sqrt(m/k) of one particle on one spring, which can be unstable"},
    {NB_OLD_STATEMENT, "step N per contact", "step N per collision"},
    {NB_OLD_STATEMENT, "damping … contact-beta", "damping … stiffness"},
    {NB_OLD_STATEMENT, "damping … contact-ratio", "damping … ratio"},
    {NB_OLD_STATEMENT, "damping … contact-fraction", "damping … r89-fraction"},
    {NB_OLD_STATEMENT, "damping global", "damping mass",
     "damping of all particles is mass-proportional, a rate in 1/s: write `damping mass 50 1/s`, with which velocities decay as exp(-50 t)"},
    {NB_OLD_STATEMENT, "damping critical above", "damping critical beyond overlap"},
    {NB_OLD_STATEMENT, "damping con1 X reading", "damping con1 X as"},
    {NB_OLD_STATEMENT, "shear … pieces", "shear … memory"},
    {NB_OLD_STATEMENT, "place", "transform"},
    {NB_OLD_STATEMENT, "transform … turn", "transform … rotate"},
    {NB_OLD_STATEMENT, "transform … shift", "transform … translate"},
    {NB_OLD_STATEMENT, "cell … to", "periodic cell … to"},
    {NB_OLD_STATEMENT, "wave", "perturb wave"},
    {NB_OLD_STATEMENT, "watch", "monitor"},
    {NB_OLD_STATEMENT, "still", "zero velocities"},
    {NB_OLD_STATEMENT, "reverse", "reverse velocities"},
    {NB_OLD_STATEMENT, "boundary hold", "boundary fixed"},
    {NB_OLD_STATEMENT, "continuum … literal", "affine … accumulated"},
    {NB_OLD_STATEMENT, "continuum", "affine"},
    {NB_OLD_STATEMENT, "servo … by boundary continuum", "servo … through boundary affine"},
    {NB_OLD_STATEMENT, "servo … by", "servo … through"},
    {NB_OLD_STATEMENT, "ramp servo … by boundary continuum", "ramp servo … through boundary affine"},
    {NB_OLD_STATEMENT, "ramp servo … by", "ramp servo … through"},
    {NB_OLD_STATEMENT, "… servo stress xx", "… servo xx"},
    {NB_OLD_STATEMENT, "… servo stress yy", "… servo yy"},
    {NB_OLD_STATEMENT, "… servo stress xy", "… servo xy"},
    {NB_OLD_STATEMENT, "leg", "segment"},
    {NB_OLD_STATEMENT, "repeat from STAGE NUMBER times", "repeat from STAGE NUMBER more times", ""},
    {NB_OLD_STATEMENT, "repeat from STAGE NUMBER time", "repeat from STAGE NUMBER more time", ""},
    {NB_OLD_FENCE, "path", "contact-test"},
    {NB_OLD_EXPECT, "… stated", "… expected"},
    {NB_OLD_EXPECT, "… rises with", "… increases with"},
    {NB_OLD_EXPECT, "… falls with", "… decreases with"},
    {NB_OLD_EXPECT, "… same over", "… constant with"},
    {NB_OLD_EXPECT, "… order P over", "… order P in"},
    {NB_OLD_EXPECT, "… among", "… over"},
    {NB_OLD_EXPECT, "… along", "… versus"},
    {NB_OLD_FIGURE, "known", "reference"},
    {NB_OLD_PLAIN, "unbalance", "unbalanced.max"},
    {NB_OLD_QUANTITY, ".unbalance.force", ".unbalanced.force"},
    {NB_OLD_QUANTITY, ".unbalance", ".unbalanced.mean"},
    {NB_OLD_QUANTITY, ".voids", ".void_ratio"},
    {NB_OLD_QUANTITY, ".deviation", ".std"},
    {NB_OLD_QUANTITY, ".strain.turn", ".strain.rotation"},
    {NB_OLD_QUANTITY, "strain.volume", "strain.volumetric"},
    {NB_OLD_QUANTITY, ".share", ".fraction"},
    {NB_OLD_QUANTITY, ".chains.turn", ".chains.bend"},
    {NB_OLD_QUANTITY, ".coordination.loaded", ".coordination.mechanical"},
    {NB_OLD_QUANTITY, ".speed.carried", ".speed.imposed"},
    {NB_OLD_QUANTITY, ".bodies", ".particles"},
    {NB_OLD_QUANTITY, ".tries", ".attempts"},
    {NB_OLD_PLAIN, "boundary.unevenness", "boundary.roughness"},
    {NB_OLD_PLAIN, "energy.driven", "energy.imposed"},
    {NB_OLD_PLAIN, "energy.frictional", "energy.friction"},
    {NB_OLD_PLAIN, "energy.residual", "energy.balance"},
    {NB_OLD_PLAIN, "work.residual", "work.balance"},
    {NB_OLD_PLAIN, "step.safe", "step.stable"},
    {NB_OLD_PLAIN, "step.critical", "step.single-contact"},
    {NB_OLD_PLAIN, "lost", "dissipated"},
    {NB_OLD_COLUMN, "body", "particle"},
    {NB_OLD_COLUMN, "bodies", "particles"},
    {NB_OLD_STATEMENT, NULL, NULL},
  };
  /* clang-format on */
  return words;
}

/* ---- words of a line ---- */

enum { WORDS_MAX = 2 * NB_TOKENS_MAX, ROUNDS_MAX = NB_TOKENS_MAX };

struct word {
  const char *at;
  size_t length;
  const char *spaces; /* the spaces before the word on the line; NULL: the word is new */
  size_t gap, column; /* number of these spaces; column of the word in the line */
};
struct line {
  struct word words[WORDS_MAX];
  size_t count;
  struct word rest; /* a comment, or the source of an expectation */
};

/* Splits a line into words. False: too many words. */
static bool split(struct line *line, const char *text, enum nb_old_block block) {
  *line = (struct line){.count = 0};
  for (size_t at = 0;;) {
    const size_t gap = strspn(text + at, " \t"), length = strcspn(text + at + gap, " \t\r#");
    const struct word word = {text + at + gap, length, text + at, gap, at + gap};
    if (length == 0 || (block == NB_OLD_EXPECTATIONS && *word.at == '[')) {
      line->rest = word;
      return true;
    }
    if (line->count == NB_TOKENS_MAX)
      return false;
    line->words[line->count++] = word;
    at += gap + length;
  }
}

static size_t pattern_word(const char **pattern) {
  *pattern += strspn(*pattern, " ");
  return strcspn(*pattern, " ");
}

static bool is_many(const char *word, size_t length) {
  return length == strlen("…") && strncmp(word, "…", length) == 0;
}
static bool is_any(const char *word) { return isupper((unsigned char)*word); }
static bool may_be_any(const struct word *word, const char *pattern) {
  const bool number = strncmp(pattern, "NUMBER", strlen("NUMBER")) == 0;
  return number ? nb_number_length(word->at + strspn(word->at, "+-")) > 0 : word->length != 1 || *word->at != '=';
}

/* True if a pattern matches the line from word `first` on; at[k] is then the index in the line of the pattern's k-th
 * word. A value includes a `%` after it. */
static bool match(const char *pattern, const struct line *line, size_t first, size_t *at) {
  const size_t length = pattern_word(&pattern);
  *at = first;
  if (length == 0)
    return true;
  const char *behind = pattern + length;
  for (size_t next = first; is_many(pattern, length) && next < line->count; next++)
    if (match(behind, line, next, at + 1))
      return true;
  if (is_many(pattern, length) || first == line->count)
    return false;
  const struct word *word = &line->words[first];
  const bool same =
      is_any(pattern) ? may_be_any(word, pattern) : word->length == length && strncmp(word->at, pattern, length) == 0;
  const bool percent = is_any(pattern) && first + 1 < line->count && word[1].length == 1 && *word[1].at == '%';
  return same && (match(behind, line, first + 1, at + 1) || (percent && match(behind, line, first + 2, at + 1)));
}

/* Index of a word in the pattern; the number of words of the pattern if it does not contain the word. */
static size_t index_of(const char *pattern, const char *word, size_t length) {
  size_t k = 0;
  for (size_t n; (n = pattern_word(&pattern)); pattern += n, k++)
    if (n == length && strncmp(pattern, word, n) == 0)
      break;
  return k;
}

/* Rewrites the line by a row that matches at `at`. A new word takes the position of the old word with the same index.
 * False, without a change: the line would have too many words. */
static bool rewrite(struct line *line, const struct nb_old_word *row, const size_t *at) {
  struct line made = {.rest = line->rest};
  const size_t matched = index_of(row->old, "", 1);
  const char *pattern = row->now;
  for (size_t n, k = 0; (n = pattern_word(&pattern)); pattern += n, k++) {
    const size_t old = is_many(pattern, n) || is_any(pattern) ? index_of(row->old, pattern, n) : matched;
    const size_t from = old < matched ? at[old] : 0, to = old < matched ? at[old + 1] : 1;
    if (made.count + to - from + line->count > WORDS_MAX)
      return false;
    for (size_t w = from; w < to; w++) {
      struct word *word = &made.words[made.count++];
      const struct word *place = old < matched ? &line->words[w] : k < matched ? &line->words[at[k]] : NULL;
      *word = place ? *place : (struct word){.gap = 1};
      if (old == matched)
        word->at = pattern, word->length = n;
    }
  }
  for (size_t w = at[matched]; w < line->count; w++)
    made.words[made.count++] = line->words[w];
  *line = made;
  return true;
}

/* ---- names of quantities ---- */

/* True if the row matches whole parts of a name from byte `at` on. `dot`: the character between the parts, which is `_`
 * in a variable of gnuplot. */
static bool is_part(const struct nb_old_word *row, const char *name, size_t at, size_t length, char dot) {
  if (row->kind != NB_OLD_QUANTITY && !(row->kind == NB_OLD_PLAIN && at == 0))
    return false;
  const char *old = row->old + (*row->old == '.');
  const size_t n = strlen(old);
  if (at == strlen("box.") && strncmp(name, "box.strain", strlen("box.strain")) == 0)
    return false; /* the strain of a box has not been renamed */
  if (at + n > length || (at > 0 ? name[at - 1] != dot : *row->old == '.') || (at + n < length && name[at + n] != dot))
    return false;
  for (size_t k = 0; k < n; k++)
    if (name[at + k] != (old[k] == '.' ? dot : old[k]))
      return false;
  return true;
}

/* Adds a rewritten name; returns a row that has changed it, or NULL. `dot`: as in is_part. */
static const struct nb_old_word *add_name(struct nb_text *text, const char *name, size_t length, char dot) {
  const struct nb_old_word *found = NULL;
  for (size_t at = 0; at < length;) {
    const struct nb_old_word *row = nb_old_words();
    while (row->old && !is_part(row, name, at, length, dot))
      row++;
    if (!row->old) {
      nb_text_add(text, "%c", name[at++]);
      continue;
    }
    for (const char *c = row->now + (*row->now == '.'); *c; c++)
      nb_text_add(text, "%c", *c == '.' || (*c == '-' && dot == '_') ? dot : *c);
    at += strlen(row->old) - (*row->old == '.');
    found = row;
  }
  return found;
}

/* Adds the present name of a quantity, or the name as it is if it has none; returns the row of the name, or NULL. */
static const struct nb_old_word *add_quantity(struct nb_text *text, const char *name, size_t length) {
  struct nb_text made = {0};
  const struct nb_old_word *row = add_name(&made, name, length, '.');
  const char *const now = made.at ? made.at : "", *const dot = strchr(now, '.');
  if (!nb_is_quantity(now) && !(dot && nb_is_quantity(dot + 1)))
    row = NULL;
  nb_text_add(text, "%.*s", row ? (int)strlen(now) : (int)length, row ? now : name);
  free(made.at);
  return row;
}

static bool is_word(const struct word *word, const char *text) {
  return word->length == strlen(text) && strncmp(word->at, text, word->length) == 0;
}

/* True if word w of a line may be the name of a quantity. */
static bool may_be_quantity(const struct line *line, size_t w, enum nb_old_block block) {
  if (block == NB_OLD_EXPECTATIONS)
    return w == 0 || !is_word(&line->words[w - 1], "in");
  return w > 0 && (is_word(&line->words[0], "record") || is_word(&line->words[0], "until"));
}

/* ---- figures ---- */

/* True if a quoted name is the name of a column with a unit: `C.normal/N`, `C.normal max in load/N`. `behind`: the text
 * after the first word of the name. */
static bool has_unit(const char *behind) {
  const size_t n = strcspn(behind, "'\"/");
  return behind[n] == '/' && (n == 0 || (*behind == ' ' && behind[n - 1] != ' '));
}

/* The row for the word before a column of a figure, `known C.normal/N`, or before a variable, known_C_normal; NULL:
 * no row. */
static const struct nb_old_word *figure_row(const char *run, size_t length, bool quoted) {
  const struct nb_old_word *row = nb_old_words();
  for (; row->old; row++) {
    const size_t n = strlen(row->old);
    if (row->kind != NB_OLD_FIGURE || n > length || strncmp(run, row->old, n) != 0)
      continue;
    if (quoted ? n == length && run[n] == ' ' && has_unit(run + n) : run[n] == '_')
      return row;
  }
  return NULL;
}

/* The row of that kind for the whole word; NULL: none. */
static const struct nb_old_word *row_of(enum nb_old_kind kind, const char *word, size_t length) {
  const struct nb_old_word *row = nb_old_words();
  while (row->old && !(row->kind == kind && strlen(row->old) == length && strncmp(word, row->old, length) == 0))
    row++;
  return row->old ? row : NULL;
}

/* Adds a run of letters. The run is rewritten if it is a quoted column with a unit, or a variable such as
 * known_C_normal. */
static void add_run(struct nb_text *text, const char *run, size_t length, bool quoted) {
  const struct nb_old_word *column = quoted && run[length] != '/' ? NULL : row_of(NB_OLD_COLUMN, run, length);
  if (column) {
    nb_text_add(text, "%s", column->now);
    return;
  }
  const struct nb_old_word *row = figure_row(run, length, quoted);
  if (row) {
    nb_text_add(text, "%s", row->now);
    run += strlen(row->old), length -= strlen(row->old);
  }
  if (quoted ? has_unit(run + length) : memchr(run, '_', length) != NULL)
    add_name(text, run, length, quoted ? '.' : '_');
  else
    nb_text_add(text, "%.*s", (int)length, run);
}

static void add_figure(struct nb_text *text, const char *line) {
  char quote = 0;
  for (const char *c = line; *c;) {
    size_t n = 0;
    while (isalnum((unsigned char)c[n]) || c[n] == '_' || c[n] == '.')
      n++;
    if (n)
      add_run(text, c, n, quote && !(c > line && (c[-1] == '$' || c[-1] == '@')));
    else if (*c == '\'' || *c == '"')
      quote = quote ? quote == *c ? 0 : quote : *c;
    if (n == 0)
      nb_text_add(text, "%c", *c);
    c += n ? n : 1;
  }
}

/* ---- the whole line ---- */

/* The first row that has changed the line; NULL: none. */
static const struct nb_old_word *rewrite_line(struct line *line, enum nb_old_kind kind) {
  const struct nb_old_word *first = NULL;
  size_t at[WORDS_MAX], rounds = 0;
  for (const struct nb_old_word *row = nb_old_words(); row->old; row++)
    while (row->kind == kind && !match(row->now, line, 0, at) && match(row->old, line, 0, at) &&
           rounds++ < ROUNDS_MAX && rewrite(line, row, at))
      first = first ? first : row;
  return first;
}

/* Adds the spaces before a word. If there are more than `few`, their number is changed to keep the column of the word,
 * if possible. */
static void add_blanks(struct nb_text *text, size_t start, const struct word *word, size_t few) {
  const size_t now = text->length - start;
  size_t gap = word->gap;
  if (word->spaces && memchr(word->spaces, '\t', gap)) {
    nb_text_add(text, "%.*s", (int)gap, word->spaces);
    return;
  }
  if (gap > few)
    gap = word->column > now + few ? word->column - now : few;
  nb_text_add(text, "%*s", (int)gap, "");
}

/* Adds a rewritten line of a block; returns the first row that has changed it, or NULL. */
static const struct nb_old_word *add_words(struct nb_text *text, const char *text_line, enum nb_old_block block) {
  struct line line;
  const bool whole = split(&line, text_line, block);
  const struct nb_old_word *row =
      whole ? rewrite_line(&line, block == NB_OLD_EXPECTATIONS ? NB_OLD_EXPECT : NB_OLD_STATEMENT) : NULL;
  struct nb_text names = {0};
  for (size_t w = 0; whole && w < line.count; w++) {
    const struct nb_old_word *by =
        may_be_quantity(&line, w, block) ? add_quantity(&names, line.words[w].at, line.words[w].length) : NULL;
    row = row ? row : by;
  }
  free(names.at);
  if (!row) {
    nb_text_add(text, "%s", text_line);
    return NULL;
  }
  const size_t start = text->length;
  for (size_t w = 0; w < line.count; w++) {
    const struct word *word = &line.words[w];
    add_blanks(text, start, word, w == 1 ? 1 : 2);
    if (may_be_quantity(&line, w, block))
      add_quantity(text, word->at, word->length);
    else
      nb_text_add(text, "%.*s", (int)word->length, word->at);
  }
  add_blanks(text, start, &line.rest, 1);
  nb_text_add(text, "%s", line.rest.at);
  return row;
}

/* The row for the word of an opening fence; *at is the position of this word. NULL: the fence has no old word. */
static const struct nb_old_word *fence_row(const char *line, size_t *at) {
  *at = strspn(line, " `~");
  return row_of(NB_OLD_FENCE, line + *at, strcspn(line + *at, " \t\r"));
}

void nb_old_line(struct nb_text *text, const char *line, enum nb_old_block block) {
  size_t at;
  const struct nb_old_word *fence = block == NB_OLD_OPENING ? fence_row(line, &at) : NULL;
  if (fence)
    nb_text_add(text, "%.*s%s%s", (int)at, line, fence->now, line + at + strlen(fence->old));
  else if (block == NB_OLD_OPENING || block == NB_OLD_PROSE)
    nb_text_add(text, "%s", line);
  else if (block == NB_OLD_GNUPLOT)
    add_figure(text, line);
  else
    add_words(text, line, block);
}

/* ---- hints and help ---- */

#define NOW "`%s` of version 0.3 is `%s` now"

/* Writes the hint for a row and the rewritten text: a line, or the name of a quantity. */
static const char *hint_of(char *hint, const struct nb_old_word *row, const char *text) {
  static const char migrate[] = "(`nineball migrate` rewrites pages of version 0.3)";
  if (!row || (row->note && !*row->note))
    return NULL;
  text += strspn(text, " \t");
  const size_t most = 160; /* a longer line is cut */
  size_t length = strcspn(text, "#");
  while (length > 0 && strchr(" \t\r", text[length - 1]))
    length--;
  if (row->note)
    snprintf(hint, NB_HINT_SIZE, "%s %s", row->note, migrate);
  else
    snprintf(hint, NB_HINT_SIZE, "did you mean `%.*s%s`? %s", (int)(length < most ? length : most), text,
             length > most ? "…" : "", migrate);
  return hint;
}

const char *nb_old_hint(char *hint, const struct nb_page *page, size_t number) {
  if (number == 0 || number > page->line_count)
    return NULL;
  char line[NB_LINE_MAX + 1];
  snprintf(line, sizeof line, "%s", page->lines[number - 1]);
  char *equals = page->kind_of ? NULL : strchr(line, '='); /* of a --set text, NAME=VALUE */
  if (equals)
    *equals = ' ';
  const bool expect = page->kind_of && page->kind_of[number - 1] == 1 + NB_BLOCK_EXPECT;
  struct nb_text text = {0};
  const struct nb_old_word *row = add_words(&text, line, expect ? NB_OLD_EXPECTATIONS : NB_OLD_STATEMENTS);
  const char *const found = hint_of(hint, row, text.at ? text.at : "");
  free(text.at);
  return found;
}

const char *nb_old_fence(char *hint, const char *line) {
  size_t at;
  const struct nb_old_word *const row = fence_row(line, &at);
  return hint_of(hint, row, row ? row->now : "");
}

const char *nb_old_name(char *hint, const char *name) {
  struct nb_text text = {0};
  const struct nb_old_word *row = add_quantity(&text, name, strlen(name));
  const char *const found = hint_of(hint, row, text.at ? text.at : "");
  free(text.at);
  return found;
}

static bool has_word(const char *pattern, const char *word, size_t length) {
  return index_of(pattern, word, length) < index_of(pattern, "", 1);
}

/* A row of statements that has the word in its old form and not in its new one; NULL: no row. */
static const struct nb_old_word *row_of_word(const char *word, size_t length) {
  const struct nb_old_word *row = nb_old_words();
  while (row->old && (row->kind != NB_OLD_STATEMENT || is_any(word) || !has_word(row->old, word, length) ||
                      has_word(row->now, word, length)))
    row++;
  return row->old ? row : NULL;
}

void nb_old_warn(FILE *out, const char *path, size_t number, const char *text, enum nb_old_block block) {
  struct line line;
  const bool whole = block == NB_OLD_STATEMENTS && split(&line, text, block) && line.count > 2;
  const bool let = whole && is_word(&line.words[0], "let");
  for (size_t w = 2; whole && (let || is_word(&line.words[0], "sweep")) && w < line.count; w++) {
    const struct word *word = &line.words[w];
    const struct nb_old_word *row = row_of_word(word->at, word->length);
    if (let && w == 2 && word->at[0] == '$')
      fprintf(out, "%s:%zu:%zu: warning: if `%.*s` is a number, write `let %.*s = %.*s`\n", path, number,
              word->column + 1, (int)word->length, word->at, (int)line.words[1].length, line.words[1].at,
              (int)word->length - 1, word->at + 1);
    else if (row)
      fprintf(out, "%s:%zu:%zu: warning: `%.*s` is not rewritten: with $%.*s, `%s` is `%s` now\n", path, number,
              word->column + 1, (int)word->length, word->at, (int)line.words[1].length, line.words[1].at, row->old,
              row->now);
  }
}

bool nb_old_help(FILE *out, const char *word) {
  bool found = false;
  for (const struct nb_old_word *row = nb_old_words(); row->old; row++) {
    const char *dot = strchr(word, '.'), *old = row->old + (*row->old == '.');
    if (!has_word(old, word, strlen(word)) && !(dot && strcmp(old, dot + 1) == 0))
      continue;
    if (has_word(row->now, word, strlen(word)) && row->kind <= NB_OLD_EXPECT)
      continue; /* the word is still in use */
    fprintf(out, "  " NOW "\n", row->old, row->now);
    found = true;
  }
  return found;
}
