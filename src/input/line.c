/* A line as tokens: words between white space, up to a `#`, each with its place, $NAME replaced by what it stands for. Then what is
 * taken from it, one by one: numbers with their units, whole numbers, words, names; or, with a caret under it, said to be wrong.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "old_words.h"
#include "reader.h"

static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
static bool name_letter(char c) { return isalnum((unsigned char)c) || c == '_' || c == '-'; }

bool nb_is_name(const char *text) {
  size_t n = 0;
  while (name_letter(text[n]))
    n++;
  return isalpha((unsigned char)text[0]) && text[n] == '\0' && n < NB_NAME_SIZE;
}

static int characters(const char *text, size_t bytes) {
  int n = 0;
  for (size_t i = 0; i < bytes; i++)
    n += (text[i] & 0xC0) != 0x80;
  return n;
}

/* Where the next token's text may be written, and what is left of the line's room. */
struct store {
  char *at;
  size_t left;
};

static bool put(struct store *store, const char *text, size_t length) {
  if (length + 1 > store->left)
    return false;
  memcpy(store->at, text, length);
  store->at[length] = '\0';
  store->at += length;
  store->left -= length;
  return true;
}

/* The value of the NAME in a token that holds `$NAME`; NULL with a message when it has none. */
static const struct nb_binding *binding_of(struct nb_reader *reader, const struct nb_token *token, const char *name) {
  char hint[NB_HINT_SIZE];
  const int index = NB_FIND(reader->bindings, reader->binding_count, name);
  if (index >= 0)
    return &reader->bindings[index];
  if (nb_excused(reader->mistakes, name))
    nb_silent(reader);
  nb_token_mistake(reader, token, NB_NEAREST(hint, name, reader->bindings, reader->binding_count),
                   "expected a $NAME that a `let` or `sweep` above defines, found `$%s`", name);
  nb_excuse(reader->mistakes, name);
  return NULL;
}

/* A token that holds a $NAME: `$v`, `-$v`. A value with a unit gives two tokens, the second one begun here. False: no
 * room. */
static bool put_named(struct nb_reader *reader, struct nb_token *token, struct store *store, const char *word,
                      size_t length) {
  const char *dollar = memchr(word, '$', length), *name = dollar + 1, *end = word + length;
  const char *after = name;
  while (after < end && name_letter(*after))
    after++;
  char text[NB_NAME_SIZE] = "";
  if ((size_t)(after - name) < sizeof text)
    memcpy(text, name, (size_t)(after - name));
  const struct nb_binding *binding = binding_of(reader, token, text);
  if (!binding)
    return put(store, word, length);
  token->name = binding->name;
  size_t number = strcspn(binding->text, " ");
  bool unit = binding->text[number] != '\0';
  if (!put(store, word, (size_t)(dollar - word)) || !put(store, binding->text, number))
    return false;
  if (!unit || after < end)
    return put(store, after, (size_t)(end - after));
  if (reader->count + 1 >= NB_TOKENS_MAX)
    return false;
  store->at++, store->left--; /* past the number's terminating zero */
  struct nb_token *second = &reader->tokens[++reader->count];
  *second = *token;
  second->text = store->at;
  return put(store, binding->text + number + 1, strlen(binding->text + number + 1));
}

/* The last two tokens are one when they are the unit `per cycle`. */
static void join_per_cycle(struct nb_reader *reader) {
  if (reader->count < 2 || strcmp(reader->tokens[reader->count - 1].text, "cycle") != 0)
    return;
  const struct nb_token *last = &reader->tokens[reader->count - 1];
  struct nb_token *per = &reader->tokens[reader->count - 2];
  if (per->name || last->name || strcmp(per->text, "per") != 0)
    return;
  per->text = NB_PER_CYCLE;
  per->length = last->column + last->length - per->column;
  reader->count--;
}

bool nb_line_read(struct nb_reader *reader, size_t line) {
  const char *text = line > 0 && line <= reader->page->line_count ? reader->page->lines[line - 1] : "";
  /* In a --set text the first `=` parts name and value, as a blank would. */
  const char *equals = reader->page->kind_of ? NULL : strchr(text, '=');
  struct store store = {reader->store, sizeof reader->store};
  reader->line = line;
  reader->count = reader->next = 0;
  reader->bad = false;
  reader->keyword = NULL;
  for (size_t i = 0;;) {
    while (blank(text[i]) || (equals && text + i == equals))
      i++;
    if (!text[i] || text[i] == '#')
      break;
    size_t length = 1;
    while (text[i + length] && text[i + length] != '#' && !blank(text[i + length]) && text + i + length != equals)
      length++;
    struct nb_token *token = &reader->tokens[reader->count];
    *token = (struct nb_token){store.at, characters(text, i) + 1, characters(text + i, length), NULL};
    bool room = reader->count < NB_TOKENS_MAX - 1;
    if (room && memchr(text + i, '$', length))
      room = put_named(reader, token, &store, text + i, length);
    else if (room)
      room = put(&store, text + i, length);
    if (!room) {
      nb_token_mistake(reader, token, NULL, "expected at most %d words in a line, found more", NB_TOKENS_MAX - 1);
      return reader->count > 0;
    }
    store.at++, store.left--;
    reader->count++;
    join_per_cycle(reader);
    i += length;
  }
  reader->next = reader->bad ? reader->count : 0;
  return reader->count > 0;
}

const struct nb_token *nb_token_peek(const struct nb_reader *reader) {
  return reader->next < reader->count ? &reader->tokens[reader->next] : NULL;
}

bool nb_token_is(const struct nb_reader *reader, const char *word) {
  const struct nb_token *token = nb_token_peek(reader);
  return token && strcmp(token->text, word) == 0;
}

bool nb_token_skip(struct nb_reader *reader, const char *word) {
  bool is = nb_token_is(reader, word);
  reader->next += is;
  return is;
}

bool nb_silent(struct nb_reader *reader) {
  reader->bad = true;
  reader->next = reader->count;
  return false;
}

bool nb_no_memory(struct nb_reader *reader) {
  nb_mistake_memory(reader->mistakes);
  return nb_silent(reader);
}

bool nb_array_append(struct nb_reader *reader, void *array, size_t *count, const void *element, size_t size) {
  void *things;
  memcpy(&things, array, sizeof things);
  things = nb_room(things, *count, 1, size);
  if (!things)
    return nb_no_memory(reader);
  memcpy((char *)things + (*count)++ * size, element, size);
  memcpy(array, &things, sizeof things);
  return true;
}

bool nb_token_mistake(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *format,
                      ...) {
  if (reader->bad)
    return nb_silent(reader);
  char text[1024];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  int column = 1, length = 1;
  if (token) {
    column = token->column;
    length = token->length;
  } else if (reader->count > 0) {
    const struct nb_token *last = &reader->tokens[reader->count - 1];
    column = last->column + last->length;
  }
  char old[NB_HINT_SIZE];
  const char *now = nb_old_hint(old, reader->page, reader->line);
  nb_mistake(reader->mistakes, reader->page, reader->line, column, length, now ? now : hint, "%s", text);
  return nb_silent(reader);
}

bool nb_line_mistake(struct nb_reader *reader, size_t line, const char *hint, const char *format, ...) {
  char text[1024];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  return nb_token_mistake(reader, nb_line_read(reader, line) ? &reader->tokens[0] : NULL, hint, "%s", text);
}

bool nb_expected(struct nb_reader *reader, const char *hint, const char *format, ...) {
  char what[512];
  const struct nb_token *token = nb_token_peek(reader);
  va_list list;
  va_start(list, format);
  vsnprintf(what, sizeof what, format, list);
  va_end(list);
  if (!token)
    return nb_token_mistake(reader, NULL, hint, "expected %s, found the end of the line", what);
  if (token->name)
    return nb_token_mistake(reader, token, hint, "expected %s, found `%.80s` (`$%s`)", what, token->text, token->name);
  return nb_token_mistake(reader, token, hint, "expected %s, found `%.80s`", what, token->text);
}

bool nb_expected_at(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what) {
  if (!reader->bad)
    reader->next = (size_t)(token - reader->tokens);
  return nb_expected(reader, hint, "%s", what);
}

bool nb_not_known(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what) {
  if (reader->bad || nb_excused(reader->mistakes, token->text))
    return nb_silent(reader);
  nb_excuse(reader->mistakes, token->text);
  return nb_expected_at(reader, token, hint, what);
}

/* ---- values ---- */

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

/* "a length and its unit (m, mm, um, nm, cm, km)" */
static void expectation(char *text, size_t size, const struct nb_reader *reader, enum nb_unit_kind kind) {
  char units[128];
  nb_unit_list(units, sizeof units, kind);
  if (kind == NB_UNIT_NUMBER)
    snprintf(text, size, "a number (bare, or with %% or ppm)");
  else if (reader->unitless)
    snprintf(text, size, "%s as a bare number (the scene says `units none`)", nb_unit_kind_name(kind));
  else
    snprintf(text, size, "%s and its unit (%s)", nb_unit_kind_name(kind), units);
}

/* A number and what was taken for its unit, which may be NULL: "expected WHAT, found `50 kg`". */
static bool refuse(struct nb_reader *reader, const struct nb_token *number, const struct nb_token *unit,
                   const char *hint, const char *what) {
  struct nb_token both = *number;
  if (nb_excused(reader->mistakes, "units")) /* whether there are any is not known */
    return nb_silent(reader);
  if (unit && unit->column > number->column)
    both.length = unit->column + unit->length - number->column;
  char name[NB_NAME_SIZE + 8] = "";
  if (number->name)
    snprintf(name, sizeof name, " (`$%s`)", number->name);
  return nb_token_mistake(reader, &both, hint, "expected %s, found `%.80s%s%.80s`%s", what, number->text,
                          unit ? " " : "", unit ? unit->text : "", name);
}

static bool is_number(const struct nb_token *token) {
  double value;
  return token && nb_number_read(&value, token->text, 0) == NB_READ;
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
  if (!token || is_number(token) || is_clause(reader, token))
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
  const struct nb_unit *known = unit ? nb_unit_of(unit->text, kind) : NULL;
  const bool pure = kind == NB_UNIT_NUMBER || (known && strcmp(known->name, NB_PER_CYCLE) == 0);
  const bool matches = known && known->kind == kind && (pure || !reader->unitless);
  *value = 1;
  expectation(what, sizeof what, reader, kind);
  enum nb_reading reading = number ? nb_number_read(value, number->text, 0) : NB_NO_NUMBER;
  if (reading == NB_NO_NUMBER)
    return nb_expected(reader, number ? number_hint(hint, number->text) : NULL, "%s", what);
  if (reading != NB_READ)
    return out_of_reach(reader, number, matches ? unit : NULL, reading);
  if (!matches && meant_as_unit(reader, unit, behind))
    return refuse(reader, number, unit, unit_hint(hint, reader, number, unit, kind), what);
  if (!matches && kind != NB_UNIT_NUMBER && !reader->unitless)
    return refuse(reader, number, NULL, unit_hint(hint, reader, number, NULL, kind), what);
  if (matches) {
    reading = nb_number_read(value, number->text, known->shift);
    if (reading != NB_READ)
      return out_of_reach(reader, number, unit, reading);
    *value *= known->factor;
  }
  if (!within(*value, range)) {
    snprintf(what, sizeof what, "%s%s", nb_unit_kind_name(kind), nb_range_words(range));
    return refuse(reader, number, matches ? unit : NULL, NULL, what);
  }
  reader->next += matches ? 2 : 1;
  return true;
}

/* A quantity may have a unit that no page writes otherwise, such as kg.m/s: then exactly that one. */
bool nb_take_in(struct nb_reader *reader, const char *si_unit, double *value) {
  enum nb_unit_kind kind;
  const struct nb_token *number = nb_token_peek(reader);
  if (nb_unit_kind_of(&kind, si_unit))
    return nb_take_number(reader, kind, NB_ANY, value);
  *value = 1;
  const bool whole = number && nb_number_read(value, number->text, 0) == NB_READ;
  if (whole && reader->unitless)
    return reader->next++, true;
  if (whole && reader->next + 1 < reader->count && strcmp(number[1].text, si_unit) == 0)
    return reader->next += 2, true;
  if (nb_excused(reader->mistakes, "units"))
    return nb_silent(reader);
  if (reader->unitless)
    return nb_expected(reader, NULL, "a bare number");
  return nb_expected(reader, NULL, "a number and its unit (%s)", si_unit);
}

bool nb_take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value) {
  const struct nb_token *token = nb_token_peek(reader);
  *value = low;
  size_t digits = token ? strspn(token->text, "0123456789") : 0;
  if (token && digits > 0 && digits < 19 && token->text[digits] == '\0') {
    *value = strtoul(token->text, NULL, 10);
    if (*value >= low && *value <= high)
      return reader->next++, true;
  }
  char what[96];
  snprintf(what, sizeof what, "a whole number from %lu to %lu", low, high);
  return is_number(token) ? refuse(reader, token, NULL, NULL, what) : nb_expected(reader, NULL, "%s", what);
}

bool nb_take_counted(struct nb_reader *reader, const char *one, unsigned long *value) {
  char several[NB_NAME_SIZE];
  snprintf(several, sizeof several, "%ss", one);
  return nb_take_count(reader, 1, NB_COUNT_MAX, value) && (nb_token_skip(reader, one) || nb_take_word(reader, several));
}

int nb_take_choice(struct nb_reader *reader, const char *words) {
  const struct nb_token *token = nb_token_peek(reader);
  char list[256] = "", word[NB_NAME_SIZE], hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  int index = 0;
  for (const char *at = words; *at; index++) {
    const size_t length = strcspn(at, "|"), used = strlen(list);
    snprintf(word, sizeof word, "%.*s", (int)length, at);
    if (nb_token_skip(reader, word))
      return index;
    nb_guess_offer(&guess, word);
    at += length + (at[length] != '\0');
    snprintf(list + used, sizeof list - used, "%s`%s`", !used ? "" : *at ? ", " : " or ", word);
  }
  nb_expected(reader, token ? nb_guess_hint(&guess, hint) : NULL, "%s", list);
  return -1;
}

bool nb_take_word(struct nb_reader *reader, const char *word) { return nb_take_choice(reader, word) == 0; }

const struct nb_token *nb_take(struct nb_reader *reader, const char *what) {
  const struct nb_token *token = nb_token_peek(reader);
  if (!token)
    nb_expected(reader, NULL, "%s", what);
  else
    reader->next++;
  return token;
}

const struct nb_token *nb_take_name(struct nb_reader *reader, const char *what) {
  const struct nb_token *token = nb_token_peek(reader);
  if (token && nb_is_name(token->text))
    return nb_take(reader, what);
  nb_expected(reader, token ? "a name is a letter, then letters, digits, `_` and `-`, less than 64 in all" : NULL, "%s",
              what);
  return NULL;
}

int nb_named(struct nb_reader *reader, const struct nb_token *token, const void *things, size_t count, size_t size,
             const char *what, const char *otherwise) {
  char hint[NB_HINT_SIZE];
  const int index = token ? nb_find(things, count, size, token->text) : -1;
  if (token && index < 0) {
    const char *near = nb_nearest(hint, token->text, things, count, size);
    nb_not_known(reader, token, near ? near : otherwise, what);
  }
  return index;
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
