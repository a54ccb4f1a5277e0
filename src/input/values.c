/* Values, one by one: numbers with their units, whole numbers, words, names. Each is taken from the line or, with a
 * caret under it, said to be wrong.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reader.h"

const char *nb_range_words(enum nb_range range) {
  static const char *const words[] = {[NB_ANY] = "",
                                      [NB_POSITIVE] = " above 0",
                                      [NB_NOT_NEGATIVE] = ", 0 or more",
                                      [NB_SHARE] = " from 0 to 1",
                                      [NB_HALF] = " from 0 to 0.5"};
  return words[range];
}

static bool within(double value, enum nb_range range) {
  return range == NB_ANY || (range == NB_POSITIVE && value > 0) || (range == NB_NOT_NEGATIVE && value >= 0) ||
         (range == NB_SHARE && value >= 0 && value <= 1) || (range == NB_HALF && value >= 0 && value <= 0.5);
}

/* Whether a mistake leaves open what the unit should be. */
static bool any_unit(const struct nb_reader *reader, enum nb_unit_kind kind) {
  return kind != NB_UNIT_NUMBER && reader->unsure & NB_UNSURE_UNITS;
}

/* "a length and its unit (m, mm, um, nm, cm, km)" */
static void expectation(char *text, size_t size, const struct nb_reader *reader, enum nb_unit_kind kind) {
  char units[128];
  nb_unit_list(units, sizeof units, kind);
  if (any_unit(reader, kind))
    snprintf(text, size, "a number and its unit");
  else if (kind == NB_UNIT_NUMBER)
    snprintf(text, size, "a number (bare, or with %% or ppm)");
  else if (reader->unitless)
    snprintf(text, size, "%s as a bare number (the scene says `units none`)", nb_unit_kind_name(kind));
  else
    snprintf(text, size, "%s and its unit (%s)", nb_unit_kind_name(kind), units);
}

/* A number and what was taken for its unit, which may be NULL: "expected WHAT, found `50 kg`". Goes on behind them. */
static bool refuse(struct nb_reader *reader, const struct nb_token *number, const struct nb_token *unit,
                   const char *hint, const char *what) {
  struct nb_token both = *number;
  if (unit && unit->column > number->column)
    both.length = unit->column + unit->length - number->column;
  char name[NB_NAME_SIZE + 8] = "";
  if (number->name)
    snprintf(name, sizeof name, " (`$%s`)", number->name);
  nb_token_mistake(reader, &both, hint, "expected %s, found `%.80s%s%.80s`%s", what, number->text, unit ? " " : "",
                   unit ? unit->text : "", name);
  reader->next += unit ? 2 : 1;
  return false;
}

static bool is_number(const struct nb_token *token) {
  double value;
  return token && !token->hollow && nb_number_read(&value, token->text, 0) == NB_READ;
}

static bool is_clause(const struct nb_reader *reader, const struct nb_token *token) {
  if (!reader->keyword)
    return false;
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (field->word && strcmp(field->word, token->text) == 0)
      return true;
  return false;
}

/* Whether the row still waits for a word that stands by itself, such as the material of a disc. */
static bool wants_word(const struct nb_reader *reader) {
  if (!reader->keyword)
    return false;
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++) {
    bool given = reader->given >> (field - reader->keyword->arguments) & 1;
    if (!field->word && !given && field->kind == NB_ARGUMENT_WORD)
      return true;
  }
  return false;
}

/* Whether the token behind a number was meant as its unit. It was not when it is the word that the row still waits for,
 * which it must be when nothing behind it can be. */
static bool meant_as_unit(const struct nb_reader *reader, const struct nb_token *token, const struct nb_token *behind) {
  if (!token || token->hollow || is_number(token) || is_clause(reader, token))
    return false;
  bool last_word = !behind || is_clause(reader, behind) || is_number(behind);
  if (reader->unitless && wants_word(reader) && last_word)
    return false;
  if (nb_unit_find(token->text))
    return true;
  if (reader->unitless)
    return false;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (const struct nb_unit *unit = nb_units(); unit->name; unit++)
    nb_guess_offer(&guess, unit->name);
  if (nb_guess_found(&guess) && (guess.distance == 0 || strchr(token->text, ',')))
    return true;
  return reader->keyword && !(wants_word(reader) && last_word);
}

/* What to type instead of a number without a unit, or with the wrong one. */
static const char *unit_hint(char *hint, const struct nb_reader *reader, const struct nb_token *number,
                             const struct nb_token *unit, enum nb_unit_kind kind) {
  struct nb_guess guess = nb_guess_begin(unit ? unit->text : "");
  const char *first = NULL, *second = NULL;
  for (const struct nb_unit *row = nb_units() + 1; row->name; row++) {
    if (row->kind != kind)
      continue;
    if (!first)
      first = row->name;
    else if (!second)
      second = row->name;
    if (unit)
      nb_guess_offer(&guess, row->name);
  }
  if (unit && (reader->unitless || kind == NB_UNIT_NUMBER)) {
    snprintf(hint, NB_HINT_SIZE, "write `%.40s`", number->text);
    return hint;
  }
  if (unit && nb_guess_found(&guess))
    return nb_guess_hint(&guess, hint);
  const char *n = number->text, *where = unit ? "" : ", or begin the scene with `units none`";
  if (second)
    snprintf(hint, NB_HINT_SIZE, "write `%.40s %s` or `%.40s %s`%s", n, first, n, second, where);
  else
    snprintf(hint, NB_HINT_SIZE, "write `%.40s %s`%s", n, first, where);
  return hint;
}

/* `50mm`: the number and the unit that were glued together; `1,5`: a decimal comma. */
static const char *number_hint(char *hint, const char *text) {
  const size_t n = strspn(text, "+-.0123456789"), all = n + strspn(text + n, ",0123456789");
  const bool unit = nb_unit_find(text + n), comma = all > n + 1 && !text[all];
  if (n == 0 || n >= 40 || !(unit || comma))
    return NULL;
  const char *form =
      unit ? "put a blank between the number and its unit: `%.*s %s`" : "write `%.*s.%s`, without a comma";
  snprintf(hint, NB_HINT_SIZE, form, (int)n, text, text + n + comma);
  return hint;
}

static bool out_of_reach(struct nb_reader *reader, const struct nb_token *number, const struct nb_token *unit,
                         enum nb_reading reading) {
  return refuse(reader, number, unit, NULL,
                reading == NB_TOO_LARGE ? "a number that a double can hold, up to 1.7e308"
                                        : "a number that a double can hold, from 4.9e-324");
}

bool nb_take_number(struct nb_reader *reader, enum nb_unit_kind kind, enum nb_range range, double *value) {
  char what[256], hint[NB_HINT_SIZE];
  const struct nb_token *number = nb_token_peek(reader);
  const struct nb_token *unit = reader->next + 1 < reader->count ? number + 1 : NULL;
  const struct nb_token *behind = reader->next + 2 < reader->count ? number + 2 : NULL;
  const struct nb_unit *known = unit && !unit->hollow ? nb_unit_of(unit->text, kind) : NULL;
  bool any = any_unit(reader, kind);
  const bool pure = kind == NB_UNIT_NUMBER || (known && strcmp(known->name, NB_PER_CYCLE) == 0);
  bool matches = known && (any || (known->kind == kind && (pure || !reader->unitless)));
  *value = 1;
  if (number && number->hollow) {
    reader->bad = true;
    reader->next += matches ? 2 : 1;
    return true;
  }
  expectation(what, sizeof what, reader, kind);
  enum nb_reading reading = number ? nb_number_read(value, number->text, 0) : NB_NO_NUMBER;
  if (reading == NB_NO_NUMBER) {
    nb_expected(reader, number ? number_hint(hint, number->text) : NULL, "%s", what);
    return false;
  }
  if (reading != NB_READ)
    return out_of_reach(reader, number, matches ? unit : NULL, reading);

  bool bare = any || kind == NB_UNIT_NUMBER || reader->unitless;
  if (!matches && !any && meant_as_unit(reader, unit, behind))
    return refuse(reader, number, unit, unit_hint(hint, reader, number, unit, kind), what);
  if (!matches && !bare)
    return refuse(reader, number, NULL, unit_hint(hint, reader, number, NULL, kind), what);
  if (matches) {
    reading = nb_number_read(value, number->text, known->shift);
    if (reading != NB_READ)
      return out_of_reach(reader, number, matches ? unit : NULL, reading);
    *value *= known->factor;
  }
  if (!within(*value, range)) {
    snprintf(what, sizeof what, "%s%s", nb_unit_kind_name(kind), nb_range_words(range));
    return refuse(reader, number, matches ? unit : NULL, NULL, what);
  }
  reader->next += matches ? 2 : 1;
  return true;
}

/* With whatever unit stands there, if one does: none of the words that may follow a number has a dot or a slash in it. */
static bool take_in_any(struct nb_reader *reader, double *value) {
  const struct nb_token *number = nb_token_peek(reader), *unit = reader->next + 1 < reader->count ? number + 1 : NULL;
  *value = 1;
  if (number && number->hollow)
    reader->bad = true;
  else if (!is_number(number))
    return nb_expected(reader, NULL, "a number and its unit"), false;
  const bool is_unit =
      unit && unit->text[0] != '[' && !is_number(unit) && (nb_unit_find(unit->text) || strpbrk(unit->text, "./"));
  reader->next += is_unit ? 2 : 1;
  return true;
}

/* A quantity may have a unit that no page writes otherwise, such as kg.m/s: then exactly that one. */
bool nb_take_in(struct nb_reader *reader, const char *si_unit, double *value) {
  enum nb_unit_kind kind;
  const struct nb_token *number = nb_token_peek(reader);
  if (!si_unit || (reader->unsure & NB_UNSURE_UNITS && strcmp(si_unit, "1") != 0))
    return take_in_any(reader, value);
  if (nb_unit_kind_of(&kind, si_unit))
    return nb_take_number(reader, kind, NB_ANY, value);
  *value = 1;
  if (number && number->hollow) {
    reader->bad = true;
    reader->next++;
    return true;
  }
  bool whole = number && nb_number_read(value, number->text, 0) == NB_READ;
  if (whole && reader->unitless)
    return reader->next++, true;
  if (whole && reader->next + 1 < reader->count && strcmp(number[1].text, si_unit) == 0)
    return reader->next += 2, true;
  if (reader->unitless)
    nb_expected(reader, NULL, "a bare number");
  else
    nb_expected(reader, NULL, "a number and its unit (%s)", si_unit);
  return false;
}

bool nb_take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value) {
  const struct nb_token *token = nb_token_peek(reader);
  *value = low;
  if (token && token->hollow) {
    reader->bad = true;
    reader->next++;
    return true;
  }
  size_t digits = token ? strspn(token->text, "0123456789") : 0;
  if (token && digits > 0 && digits < 19 && token->text[digits] == '\0') {
    *value = strtoul(token->text, NULL, 10);
    if (*value >= low && *value <= high)
      return reader->next++, true;
  }
  char what[96];
  snprintf(what, sizeof what, "a whole number from %lu to %lu", low, high);
  if (is_number(token))
    return refuse(reader, token, NULL, NULL, what);
  nb_expected(reader, NULL, "%s", what);
  return false;
}

bool nb_take_word(struct nb_reader *reader, const char *word) {
  if (nb_token_skip(reader, word))
    return true;
  const struct nb_token *token = nb_token_peek(reader);
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  nb_guess_offer(&guess, word);
  nb_expected(reader, token ? nb_guess_hint(&guess, hint) : NULL, "`%s`", word);
  return false;
}

const struct nb_token *nb_take(struct nb_reader *reader, const char *what) {
  const struct nb_token *token = nb_token_peek(reader);
  if (!token) {
    nb_expected(reader, NULL, "%s", what);
    return NULL;
  }
  if (token->hollow)
    reader->bad = true;
  reader->next++;
  return token;
}

const struct nb_token *nb_take_name(struct nb_reader *reader, const char *what) {
  const struct nb_token *token = nb_token_peek(reader);
  if (token && (token->hollow || nb_is_name(token->text)))
    return nb_take(reader, what);
  nb_expected(reader, token ? "a name is a letter, then letters, digits, `_` and `-`, less than 64 in all" : NULL, "%s",
              what);
  return NULL;
}

double nb_value_number(const char *text) {
  char number[NB_NAME_SIZE];
  double value;
  const size_t length = strcspn(text, " ");
  const struct nb_unit *unit = text[length] ? nb_unit_find(text + length + 1) : NULL;
  snprintf(number, sizeof number, "%.*s", (int)length, text);
  if (nb_number_read(&value, number, unit ? unit->shift : 0) != NB_READ)
    return NAN;
  return unit ? value * unit->factor : value;
}
