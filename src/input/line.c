/* The tokens of a line: words separated by white space, up to a `#`, each with its column. A $NAME, or an expression in
 * parentheses, is replaced by its value. The file also has the messages at tokens, and hints for syntax of other
 * languages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "expression.h"
#include "old_words.h"

static bool is_space(char c) { return c == ' ' || c == '\t'; }
static bool name_letter(char c) { return isalnum((unsigned char)c) || c == '_'; }

bool nb_is_name(const char *text) {
  size_t n = 0;
  while (name_letter(text[n]) || text[n] == '-')
    n++;
  return isalpha((unsigned char)text[0]) && text[n] == '\0' && n < NB_NAME_SIZE;
}

/* ---- a line as tokens ---- */

static int characters(const char *text, size_t bytes) {
  int n = 0;
  for (size_t i = 0; i < bytes; i++)
    n += (text[i] & 0xC0) != 0x80;
  return n;
}

struct nb_token nb_token_at(const char *line, const char *at, size_t length) {
  return (struct nb_token){.column = characters(line, (size_t)(at - line)) + 1, .length = characters(at, length)};
}

/* Appends to the text of the last token; false if the store is full. */
static bool append_text(struct nb_reader *reader, const char *text, size_t length) {
  if (reader->used + length + 1 > sizeof reader->store)
    return false;
  memcpy(reader->store + reader->used, text, length);
  reader->used += length;
  reader->store[reader->used] = '\0';
  return true;
}

/* Begins a token; false if there are too many. */
static bool begin_token(struct nb_reader *reader, struct nb_token token) {
  reader->used += reader->count > 0; /* the text begins after the terminating zero of the last token */
  if (reader->count == NB_TOKENS_MAX - 1)
    return false;
  token.text = reader->store + reader->used;
  reader->tokens[reader->count++] = token;
  return append_text(reader, "", 0);
}

const struct nb_binding *nb_use_binding(struct nb_reader *reader, const char *name) {
  const int index = NB_FIND(reader->bindings, reader->binding_count, name);
  if (index < 0)
    return NULL;
  reader->bindings[index].used = true;
  return &reader->bindings[index];
}

/* The value of $NAME. NULL if NAME has no value: with a message, unless NAME is suppressed. */
static const struct nb_binding *binding_of(struct nb_reader *reader, const struct nb_token *token, const char *name) {
  char hint[NB_HINT_SIZE];
  const struct nb_binding *const it = nb_use_binding(reader, name);
  if (it)
    return it;
  if (nb_name_suppressed(reader->mistakes, name))
    nb_fail_silently(reader);
  const char *near = NB_NEAREST(hint, name, reader->bindings, reader->binding_count);
  char *const quote = near ? strchr(hint, '`') : NULL;
  if (quote && strchr(quote + 1, '`') == strrchr(quote, '`')) /* one name: as on the page, with `$` */
    memmove(quote + 2, quote + 1, strlen(quote)), quote[1] = '$';
  if (!near && nb_is_name(name)) {
    snprintf(hint, sizeof hint, "define it with `let %s = VALUE`", name);
    near = hint;
  }
  if (strlen(name) >= NB_NAME_SIZE)
    nb_token_mistake(reader, token, near, "expected a name of at most %d characters, found `$%.*s…`", NB_NAME_SIZE - 1,
                     NB_NAME_SIZE - 1, name);
  else
    nb_token_mistake(reader, token, near, "expected a $NAME that a `let` or `sweep` above defines, found `$%s`", name);
  nb_suppress_name(reader->mistakes, name);
  return NULL;
}

/* Appends a value to the last token, between the first `length` bytes of `before` and the first `rest` bytes of
 * `after`. The unit of the value becomes a token of its own. */
static bool append_value(struct nb_reader *reader, const struct nb_binding *value, const char *before, size_t length,
                         const char *after, size_t rest) {
  struct nb_token *token = &reader->tokens[reader->count - 1];
  const char *const unit = strchr(value->text, ' '), *text = value->text;
  const bool signs = length && before[length - 1] == '-' && (*text == '-' || *text == '+');
  token->name = value->name[0] ? value->name : NULL;
  token->computed = value->computed;
  const struct nb_token second = *token;
  return append_text(reader, before, length - (signs && *text == '-')) && /* `--` cancels, `-+` is `-` */
         append_text(reader, text + signs, strcspn(text + signs, " ")) && append_text(reader, after, rest) &&
         (!unit || (begin_token(reader, second) && append_text(reader, unit + 1, strlen(unit + 1))));
}

/* Writes the hint for `$v*$w`, which is `(v*w)`, for `v=$v*2`, which is `v=(v*2)`, for the comma of `$v,`, for `$v=2` or
 * for `"$v"`. The `$` is `before` bytes after the beginning of the word, `after` is the character after the name. */
static void expression_hint(char *hint, const char *word, size_t before, size_t length, char after) {
  const char *const equals = memchr(word, '=', before);
  const size_t from = equals ? (size_t)(equals - word) + 1 : 0;
  if (strchr(",;", word[length - 1])) {
    snprintf(hint, NB_HINT_SIZE, "leave out the `%c`", word[length - 1]);
    return;
  }
  if (strchr("=\"", after)) {
    snprintf(hint, NB_HINT_SIZE, after == '=' ? "leave out the `=`" : NB_NO_QUOTES);
    return;
  }
  snprintf(hint, NB_HINT_SIZE, "write the whole expression in parentheses: `%.*s(", (int)from, word);
  for (size_t k = from; k < length; k++)
    if (word[k] != '$')
      nb_append(hint, NB_HINT_SIZE, "%c", word[k]);
  nb_append(hint, NB_HINT_SIZE, ")`");
}

/* Appends the word of a token with a $NAME: `$v`, `-$v`, `v=$v`. `before` is the position of the `$` in the word. */
static bool append_variable(struct nb_reader *reader, const char *word, size_t before, size_t length) {
  const struct nb_token *token = &reader->tokens[reader->count - 1];
  const char *const name = word + before + 1, *const end = word + length, *end_of_name = name;
  char text[NB_NAME_SIZE + 1], hint[NB_HINT_SIZE]; /* a longer name is truncated to a name that cannot exist */
  while (end_of_name < end && name_letter(*end_of_name))
    end_of_name++;
  snprintf(text, sizeof text, "%.*s", (int)(end_of_name - name), name);
  const struct nb_binding *value = binding_of(reader, token, text);
  if (!value)
    return append_text(reader, word, length);
  if (!isnan(value->value) && end_of_name < end) {
    snprintf(hint, sizeof hint, "%.*s", (int)(end - end_of_name), end_of_name);
    char whole[NB_HINT_SIZE];
    expression_hint(whole, word, before, length, *end_of_name);
    nb_token_mistake(reader, token, whole, "expected a space after `$%s`, found `%.*s`", text, (int)(end - end_of_name),
                     end_of_name);
  }
  return append_value(reader, value, word, before, end_of_name, (size_t)(end - end_of_name));
}

/* Appends the word of a token with an expression in parentheses: `(2*v)`, `v=(2*v)`. `before` is the position of the
 * first `(` in the word. */
static bool append_expression(struct nb_reader *reader, const char *line, const char *word, size_t before,
                              size_t length) {
  struct nb_binding value;
  size_t close = before;
  int depth = 0;
  do
    depth += (word[close] == '(') - (word[close] == ')');
  while (++close < length && depth > 0);
  if (close < length) {
    const struct nb_token token = nb_token_at(line, word + close, length - close);
    nb_token_mistake(reader, &token,
                     reader->here == NB_IN_EXPECT && reader->count == 1
                         ? "a line has no arithmetic with measures: it begins with one measure, and a formula stands "
                           "after `expected`, `A.vx last  expected (2*v) within 1 % [SOURCE]`"
                         : "write the whole expression in parentheses, and a space before a unit",
                     "expected a space after `)`, found `%.*s`", (int)(length - close), word + close);
  }
  return nb_expression(reader, line, word + before, word + close, &value)
             ? append_value(reader, &value, word, before, "", 0)
             : append_text(reader, word, length);
}

/* Joins the last two tokens if they are the unit `per cycle`. */
static void join_per_cycle(struct nb_reader *reader) {
  if (reader->count < 2 || strcmp(reader->tokens[reader->count - 1].text, "cycle") != 0)
    return;
  const struct nb_token *last = &reader->tokens[reader->count - 1];
  struct nb_token *per = &reader->tokens[reader->count - 2];
  if (strcmp(per->text, "per") != 0)
    return;
  per->text = NB_PER_CYCLE;
  per->length = last->column + last->length - per->column;
  reader->count--;
}

/* Length of a word, which ends at a space outside parentheses, at `equals` or before a comment. `rest`: the length of
 * the rest of the line instead. */
static size_t word_length(const char *at, const char *equals, bool rest) {
  size_t n = 0;
  for (int depth = 0; at[n] && at[n] != '#' && (rest || depth > 0 || (!is_space(at[n]) && at + n != equals)); n++)
    depth += at[n] == '(' ? 1 : at[n] == ')' && depth > 0 ? -1 : 0;
  while (is_space(at[n - 1]))
    n--;
  return n;
}

static void find_no_break_space(struct nb_reader *reader, const char *line, const char *word, size_t length) {
  for (size_t i = 0; i < length; i++)
    if (strncmp(word + i, "\u00A0", 2) == 0 || strncmp(word + i, "\u202F", 3) == 0) {
      const struct nb_token token = nb_token_at(line, word + i, 1);
      nb_token_mistake(reader, &token, "type a plain space", "expected a space, found a no-break space");
    }
}

/* True if the line begins with `let NAME =`; then the rest of the line is one expression. */
static bool is_let(const struct nb_reader *reader) {
  return strcmp(reader->tokens[0].text, "let") == 0 && strcmp(reader->tokens[2].text, "=") == 0;
}

/* Adds the next token. `text`: the token is inside brackets, where neither a $NAME nor an expression is replaced. False
 * if there are too many tokens. */
static bool add_token(struct nb_reader *reader, const char *line, const char *word, size_t length, bool text) {
  size_t before = 0;
  while (before < length && word[before] != '$' && word[before] != '(')
    before++;
  const bool value = before == 0 || word[before - 1] == '=';
  if (!begin_token(reader, nb_token_at(line, word, length)))
    return false;
  if (!text)
    find_no_break_space(reader, line, word, length);
  const bool rest = reader->count == 4 && is_let(reader);
  if (text || rest || before == length || (word[before] == '(' && !value))
    return append_text(reader, word, length);
  return word[before] == '$' ? append_variable(reader, word, before, length)
                             : append_expression(reader, line, word, before, length);
}

void nb_line_begin(struct nb_reader *reader, size_t line) {
  reader->line = line;
  reader->count = reader->next = reader->used = 0;
  reader->bad = false;
  reader->keyword = reader->row = NULL, reader->otherwise = NULL;
}

bool nb_line_read(struct nb_reader *reader, size_t line) {
  const char *text = line > 0 && line <= reader->page->line_count ? reader->page->lines[line - 1] : "";
  /* in a --set text the first `=` separates name and value */
  const char *equals = reader->page->kind_of ? NULL : strchr(text, '=');
  bool source = false, room = true;
  nb_line_begin(reader, line);
  for (const char *at = text; room;) {
    at += strspn(at, " \t");
    if (at == equals)
      at++, at += strspn(at, " \t");
    if (!*at || *at == '#')
      break;
    const bool rest = reader->count == 3 && is_let(reader);
    source = source || *at == '[';
    const size_t length = source ? strcspn(at, " \t#") : word_length(at, equals, rest);
    room = add_token(reader, text, at, length, source);
    if (!room) {
      const struct nb_token token = nb_token_at(text, at, length);
      nb_token_mistake(reader, &token, NULL, "expected at most %d words in a line, found more", NB_TOKENS_MAX - 1);
    }
    source = source && at[length - 1] != ']';
    join_per_cycle(reader);
    at += length;
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

bool nb_fail_silently(struct nb_reader *reader) {
  reader->bad = true;
  reader->next = reader->count;
  return false;
}

bool nb_no_memory(struct nb_reader *reader) {
  nb_mistake_memory(reader->mistakes);
  return nb_fail_silently(reader);
}

bool nb_array_append(struct nb_reader *reader, void *array, size_t *count, const void *element, size_t size) {
  void *place = nb_array_add(array, count, size);
  if (!place)
    return nb_no_memory(reader);
  memcpy(place, element, size);
  return true;
}

const char *nb_hint_without_units(char *bare, const char *hint) {
  char number[NB_NAME_SIZE], text[NB_NAME_SIZE];
  bool quoted = false;
  *bare = '\0';
  for (const char *at = hint; *at;) {
    const bool begins = at == hint || !(isalnum((unsigned char)at[-1]) || strchr("._", at[-1]));
    const size_t length = quoted && begins ? nb_number_length(at) : 0;
    struct nb_unit unit;
    double value;
    snprintf(number, sizeof number, "%.*s", (int)length, at);
    snprintf(text, sizeof text, "%.*s", at[length] == ' ' ? (int)strcspn(at + length + 1, " `),;*") : 0,
             at + length + 1);
    if (length && nb_unit_read(&unit, text) && !nb_unit_without_dimension(text) &&
        nb_quantity_read(&value, number, false, &unit) == NB_READ) {
      nb_append(bare, NB_HINT_SIZE, "%.10g", value);
      at += length + 1 + strlen(text);
    } else {
      nb_append(bare, NB_HINT_SIZE, "%.*s", (int)(length ? length : 1), at);
      quoted ^= *at == '`';
      at += length ? length : 1;
    }
  }
  return bare;
}

bool nb_token_mistake(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *format,
                      ...) {
  if (reader->bad)
    return nb_fail_silently(reader);
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
  char old[NB_HINT_SIZE], bare[NB_HINT_SIZE], packing[NB_HINT_SIZE];
  const char *const foreign = nb_foreign_hint(old, reader);
  const char *const now = foreign ? foreign : nb_old_hint(old, reader->page, reader->line);
  if (hint && strncmp(hint, NB_RANDOM_PACKING, strlen(NB_RANDOM_PACKING)) == 0)
    hint = nb_fill_hint(packing, reader);
  hint = now ? now : hint;
  hint = hint && reader->unitless ? nb_hint_without_units(bare, hint) : hint;
  nb_mistake(reader->mistakes, reader->page, reader->line, column, length, hint, "%s", text);
  return nb_fail_silently(reader);
}

bool nb_line_mistake(struct nb_reader *reader, size_t line, const char *hint, const char *format, ...) {
  char text[1024];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  return nb_token_mistake(reader, nb_line_read(reader, line) ? &reader->tokens[0] : NULL, hint, "%s", text);
}

/* ---- hints for syntax of other languages ---- */

/* Writes the hint for `6.5,2`, two numbers with a comma between them, which is byte n. A unit after them belongs to
 * both. */
static void two_numbers_hint(char *hint, const struct nb_reader *reader, const char *text, size_t n) {
  const struct nb_token *const token = nb_token_peek(reader);
  const char *const after = token && token + 1 < reader->tokens + reader->count ? token[1].text : "";
  struct nb_unit read;
  const char *const unit = nb_unit_read(&read, after) ? after : "", *const space = *unit ? " " : "";
  snprintf(hint, NB_HINT_SIZE, "put a space, not a comma, between two numbers: `%.*s%s%.40s %s%s%.40s`", (int)n, text,
           space, unit, text + n + 1, space, unit);
}

/* Writes the hint for `50mm`, a number with a unit, on a page without units; false: it is too large. */
static bool bare_number_hint(char *hint, const char *text, size_t n, const struct nb_unit *unit) {
  char number[NB_NAME_SIZE];
  double value;
  snprintf(number, sizeof number, "%.*s", (int)n, text);
  if (nb_quantity_read(&value, number, false, unit) != NB_READ)
    return false;
  snprintf(hint, NB_HINT_SIZE, "the scene has `units none`, so numbers are in SI: write `%.10g`", value);
  return true;
}

/* Writes the hint for a number with a comma after n bytes, which ends after `all` bytes. */
static void decimal_comma_hint(char *hint, const char *text, size_t n, size_t all) {
  const char *const rest = text + n + 1;
  if (all == n + 4) /* `1,500` may be one and a half */
    snprintf(hint, NB_HINT_SIZE, "write `%.*s%s`, or `%.*s.%s`, without a comma", (int)n, text, rest, (int)n, text,
             rest);
  else
    snprintf(hint, NB_HINT_SIZE, all > n + 1 ? "write `%.*s.%s`, without a comma" : "leave out the comma: `%.*s%s`",
             (int)n, text, rest);
}

/* Writes the hint for `50mm` or `50/s`, a number and its unit without a space, or for `1,5`, a decimal comma. */
static bool number_hint(char *hint, const struct nb_reader *reader, const char *text) {
  struct nb_unit read;
  const size_t sign = strspn(text, "+-"), number = nb_number_length(text + sign), n = sign + number;
  const size_t point = text[n] == ',', all = n + point + strspn(text + n + point, ".0123456789");
  char name[NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s%.40s", text[n] == '/' ? "1" : "", text + n);
  const bool unit = nb_unit_read(&read, name), comma = point && !text[all];
  if (number == 0 || n >= 40 || !(unit || comma))
    return false;
  if (unit && reader->unitless && !nb_unit_without_dimension(name))
    return bare_number_hint(hint, text, n, &read);
  if (memchr(text, '.', all) && all > n + 1)
    return two_numbers_hint(hint, reader, text, n), true;
  if (unit)
    snprintf(hint, NB_HINT_SIZE, "put a space between the number and its unit: `%.*s %s`", (int)n, text, name);
  else
    decimal_comma_hint(hint, text, n, all);
  return true;
}

/* True for arithmetic outside parentheses: `2*3` and `*`, and in place of a value also `pi/6`. */
static bool has_operator(const struct nb_reader *reader, const char *text) {
  const bool number = strchr("-+.0123456789()$", text[0]), sign = strchr("+-", text[0]);
  struct nb_unit unit;
  double value;
  if (sign && NB_FIND(reader->bindings, reader->binding_count, text + 1) >= 0)
    return false; /* `-R` lacks the `$` of a name */
  if (strchr(text, '='))
    return false;
  const size_t length = sign + nb_number_length(text + sign); /* `1e-6x` has no operator */
  const bool operators = strchr("*^", text[0]) || strcmp(text, "/") == 0 || (sign && (!text[1] || strchr(text, '('))) ||
                         strpbrk(text + (length ? length : 1), number ? "*/+^-" : "*/+^");
  return operators && (number || reader->keyword) && nb_number_read(&value, text, 0) == NB_NO_NUMBER &&
         !nb_unit_read(&unit, text);
}

/* True for a function outside parentheses, in place of a value: `exp(2)`. */
static bool is_call(const char *text) {
  char name[NB_NAME_SIZE];
  const size_t length = strcspn(text, "(");
  snprintf(name, sizeof name, "%.*s", (int)length, text);
  return text[length] && nb_name_reserved(name);
}

void nb_append_operand(char *hint, const struct nb_reader *reader, const char *text) {
  char word[81], name[NB_NAME_SIZE];
  struct nb_unit unit;
  double value;
  size_t length = strlen(text), letters = 0;
  while (length && strchr(",;", text[length - 1]))
    length--;
  snprintf(word, sizeof word, "%.*s", (int)length, text);
  const char *const at = word + strspn(word, "+-");
  const size_t number = nb_number_length(at);
  while (name_letter(at[letters]))
    letters++;
  snprintf(name, sizeof name, "%.*s", (int)letters, at);
  const bool begins = number || nb_name_reserved(name) || NB_FIND(reader->bindings, reader->binding_count, name) >= 0;
  const bool expression = begins && strpbrk(at + 1, "*/+^-(") && nb_number_read(&value, word, 0) == NB_NO_NUMBER &&
                          !nb_unit_read(&unit, word) && !nb_unit_read(&unit, at + number); /* `1/s`, `2N/m` */
  nb_append(hint, NB_HINT_SIZE, expression ? "(%s)" : "%s", word);
}

/* Writes the hint for an operator at token `at`, between numbers: `5 mm * 2`. False: a number is missing, or the unit of
 * a term of a sum. */
static bool echo_operator(const struct nb_reader *reader, char *hint, size_t at) {
  const struct nb_token *const tokens = reader->tokens;
  struct nb_unit unit;
  const size_t from = at - (at > 1 && nb_unit_read(&unit, tokens[at - 1].text) ? 2 : 1);
  const size_t to = at + 1 + (at + 2 < reader->count && nb_unit_read(&unit, tokens[at + 2].text));
  if (at < 1 || at + 1 >= reader->count || !nb_number_length(tokens[from].text) ||
      !nb_number_length(tokens[at + 1].text) || (strchr("+-", *tokens[at].text) && (at - from) != (to - at)))
    return false;
  snprintf(hint, NB_HINT_SIZE, "put the whole expression into parentheses: `(");
  for (size_t k = from; k <= to; k++) {
    if (tokens[k].name)
      return false;
    nb_append(hint, NB_HINT_SIZE, "%s%.60s", k > from ? " " : "", tokens[k].text);
  }
  nb_append(hint, NB_HINT_SIZE, ")`");
  return true;
}

/* Writes a hint with the word in parentheses. A single character gives the expression around it (echo_operator), or an
 * example if there is none; a word that has replaced a $NAME gives an example. After a quantity the hint is that of
 * nb_arithmetic_hint. */
static void operator_hint(const struct nb_reader *reader, char *hint, const char *text) {
  const struct nb_token *const token = nb_token_peek(reader);
  const long place = token ? token - reader->tokens : 0;
  int shown = (int)strlen(text) < 80 ? (int)strlen(text) : 80;
  while (shown > 1 && strchr(",;", text[shown - 1]))
    shown--;
  const char *const arithmetic = place == 2 && reader->here != NB_IN_EXPECT ? nb_arithmetic_hint(reader) : NULL;
  if (arithmetic)
    snprintf(hint, NB_HINT_SIZE, "%s", arithmetic);
  else if (token && token->name)
    snprintf(hint, NB_HINT_SIZE, "put operators into parentheses, where a name has no `$`: `(2*%.80s)`", token->name);
  else if (text[1] && !strchr("*/^", *text))
    snprintf(hint, NB_HINT_SIZE, "put operators and functions into parentheses: `(%.*s)`", shown, text);
  else if (text[1] || !echo_operator(reader, hint, (size_t)place))
    snprintf(hint, NB_HINT_SIZE, "put the whole expression into parentheses: `(%s * 2)`",
             reader->unitless ? "5" : "5 mm");
}

/* Writes the hint for `O.dt=1e-5`: the line to write for a word of another program; false: there is no such line. */
static bool program_hint(char *hint, const char *text, size_t length) {
  char word[NB_NAME_SIZE];
  snprintf(word, sizeof word, "%.*s", (int)length, text);
  const struct nb_synonym *const synonym = nb_synonym(word);
  return synonym && synonym->note && nb_synonym_hint(hint, word);
}

/* Writes the hint for `kn=10`; `length` is that of the part before the `=`. `let`: the statement is a `let` or a
 * `start`, which have an `=`. */
static void equals_hint(const struct nb_reader *reader, bool let, char *hint, const char *text, size_t length) {
  if (!reader->keyword && program_hint(hint, text, length))
    return;
  const bool start = let && strcmp(reader->tokens[0].text, "start") == 0;
  const int shown = length < 80 ? (int)length : 80;
  if (let) {
    snprintf(hint, NB_HINT_SIZE, start ? "write `with %.*s=%.80s`" : "put spaces around `=`: `%.*s = %.80s`", shown,
             text, text + length + 1);
    return;
  }
  snprintf(hint, NB_HINT_SIZE, "write `%.*s ", shown, text);
  nb_append_operand(hint, reader, text + length + 1);
  nb_append(hint, NB_HINT_SIZE, "`, without `=`");
}

/* Writes the hint for `kn=10`, `//` and arithmetic. */
static bool sign_hint(const struct nb_reader *reader, char *hint, const char *text) {
  const char *const verb = reader->count ? reader->tokens[0].text : "";
  const bool let = strcmp(verb, "let") == 0 || strcmp(verb, "start") == 0;
  const size_t name = strcspn(text, "=");
  if (strncmp(text, "//", 2) == 0)
    snprintf(hint, NB_HINT_SIZE, "a comment begins with `#`");
  else if (strcmp(text, "=") == 0 && !let && reader->here != NB_IN_EXPECT)
    snprintf(hint, NB_HINT_SIZE, "leave out the `=`");
  else if (name > 0 && text[name] && text[name + 1])
    equals_hint(reader, let, hint, text, name);
  else if (has_operator(reader, text) || is_call(text))
    operator_hint(reader, hint, text);
  else
    return false;
  return true;
}

const char *nb_syntax_hint(const struct nb_reader *reader, char *hint, const char *text) {
  static const struct {
    const char *sign, *hint;
  } signs[] = {{"\u2212", "this is not the minus sign of the keyboard: type `-`"},
               {"\u2013", "this is a dash, not a minus sign: type `-`"},
               {"\u00D7", "multiply with `*`: `let x = 2 * 3`, and elsewhere in parentheses, `(2 * 3)`"},
               {"\u00B7", "multiply numbers with `*` in parentheses, `(2 * 3)`, and units with a dot, `N.m`"},
               {"\u00B0", "write `deg` after a space: `30 deg`"},
               {"\u201C", NB_NO_QUOTES},
               {"\u2019", NB_NO_QUOTES},
               {"\"", NB_NO_QUOTES}};
  for (size_t k = 0; k < sizeof signs / sizeof *signs; k++)
    if (strstr(text, signs[k].sign))
      return reader->unitless && strcmp(signs[k].sign, "\u00B0") == 0
                 ? "without units an angle is in rad: write `(30*pi/180)` for 30 degrees"
                 : signs[k].hint;
  return number_hint(hint, reader, text) || sign_hint(reader, hint, text) ? hint : NULL;
}

/* Appends a tolerance for the value in token `at`. A percentage of 0 would allow no error. */
static void append_tolerance(char *hint, const struct nb_reader *reader, size_t at) {
  const char *const number = at < reader->count ? reader->tokens[at].text : "";
  const char *const unit =
      at + 1 < reader->count && reader->tokens[at + 1].text[0] != '[' ? reader->tokens[at + 1].text : "";
  double value;
  if (nb_number_read(&value, number, 0) == NB_READ && value == 0)
    nb_append(hint, NB_HINT_SIZE, " within 1e-6%s%.80s", *unit ? " " : "", unit);
  else
    nb_append(hint, NB_HINT_SIZE, " within 1 %%");
}

/* Writes the line with `expected` in place of a sign: "write `C.normal max expected 3 N within 1 % [SOURCE]`". */
static const char *compared_hint(char *hint, const struct nb_reader *reader) {
  const struct nb_token *const tokens = reader->tokens;
  bool within = false;
  snprintf(hint, NB_HINT_SIZE, "write `");
  for (size_t k = 0; k < reader->count && *tokens[k].text != '['; k++) {
    if (k == reader->next && strcmp(tokens[k - 1].text, "expected") == 0) /* `expected = 3 N` */
      continue;
    nb_append(hint, NB_HINT_SIZE, "%s", k ? " " : "");
    nb_append_operand(hint, reader, k == reader->next ? "expected" : tokens[k].text);
    within = within || strcmp(tokens[k].text, "within") == 0;
  }
  if (reader->next + 1 == reader->count)
    nb_append(hint, NB_HINT_SIZE, " VALUE");
  if (!within)
    append_tolerance(hint, reader, reader->next + 1);
  nb_append(hint, NB_HINT_SIZE, " [SOURCE]`; see `nineball --help expected`");
  return hint;
}

/* The hint for a word of another program in the statement of the line; NULL: there is none. */
static const char *statement_hint(const struct nb_reader *reader, char *hint, const struct nb_token *token) {
  const char *const verb = reader->tokens[0].text;
  if (!nb_number_length(token[-1].text) && nb_pair_synonym(verb, token->text) &&
      ((strcmp(verb, "servo") == 0 && nb_servo_hint(hint, reader)) ||
       (strcmp(verb, "box") == 0 && nb_open_box_hint(hint, reader, token))))
    return hint;
  /* In a `fill` in the words of the program a number is no number of particles. */
  return strcmp(verb, "fill") == 0 && nb_line_has(reader, "attempts") ? NULL : nb_pair_hint(hint, verb, token->text);
}

/* The hint for a word of another program in this statement, `fill 200`, or in any expectation; NULL: there is none. */
static const char *context_hint(const struct nb_reader *reader, char *hint, const struct nb_token *token) {
  const bool inside = token > reader->tokens && reader->here != NB_IN_EXPECT;
  const struct nb_synonym *const sign = inside ? NULL : nb_pair_synonym("expect", token->text);
  if (token > reader->tokens && sign && strstr(sign->words, "expect_="))
    return compared_hint(hint, reader);
  if (inside)
    return statement_hint(reader, hint, token);
  return reader->here == NB_IN_EXPECT ? nb_pair_hint(hint, "expect", token->text) : NULL;
}

/* The hint for a word without another hint: that of a word of another program, or the example of the statement; NULL:
 * there is none. `complete`: the line should end here. Then only a note about the word can be right. */
static const char *word_hint(const struct nb_reader *reader, char *hint, const char *word, bool complete) {
  const struct nb_synonym *const synonym = nb_synonym(word);
  const bool note = synonym && synonym->note;
  if (complete && !note)
    return NULL;
  const char *const example = note ? NULL : nb_example_hint(hint, reader);
  return example ? example : nb_synonym_hint(hint, word);
}

bool nb_expected(struct nb_reader *reader, const char *hint, const char *format, ...) {
  char what[512];
  const struct nb_token *token = nb_token_peek(reader);
  char text[NB_HINT_SIZE];
  va_list list;
  va_start(list, format);
  vsnprintf(what, sizeof what, format, list);
  va_end(list);
  if (!token) {
    const struct nb_token *const last = reader->count > 1 ? &reader->tokens[reader->count - 1] : NULL;
    const char *const pair = last && !hint ? nb_pair_hint(text, last[-1].text, last->text) : NULL;
    return nb_token_mistake(reader, NULL,
                            hint   ? hint
                            : pair ? pair
                                   : nb_example_hint(text, reader),
                            "expected %s, found the end of the line", what);
  }
  const char *const context = context_hint(reader, text, token);
  const char *const typed = context ? context : nb_syntax_hint(reader, text, token->text);
  hint = typed ? typed : hint ? hint : reader->otherwise;
  const bool complete = strcmp(what, "the end of the line") == 0; /* then an example could only contradict the line */
  hint = hint ? hint : word_hint(reader, text, token->text, complete);
  if (token->name)
    return nb_token_mistake(reader, token, hint, "expected %s, found `%.80s` (`$%s`)", what, token->text, token->name);
  return nb_token_mistake(reader, token, hint, "expected %s, found `%.80s`", what, token->text);
}

bool nb_line_has(const struct nb_reader *reader, const char *text) {
  size_t k = 0;
  while (k < reader->count && strcmp(reader->tokens[k].text, text) != 0)
    k++;
  return k < reader->count;
}

void nb_line_needs(struct nb_reader *reader, const char *begin, const char *hint, const char *what) {
  const struct nb_token *const last = &reader->tokens[reader->count - 1];
  for (size_t k = 0; k < reader->count; k++)
    if (strncmp(reader->tokens[k].text, begin, strlen(begin)) == 0)
      return;
  if (!nb_mistake_hinted(reader->mistakes, reader->line, begin))
    nb_mistake(reader->mistakes, reader->page, reader->line, last->column + last->length, 1, hint,
               "expected %s, found the end of the line", what);
}

bool nb_expected_at(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what) {
  reader->next = (size_t)(token - reader->tokens);
  return nb_expected(reader, hint, "%s", what);
}

bool nb_unknown_name(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what) {
  if (reader->bad || nb_name_suppressed(reader->mistakes, token->text))
    return nb_fail_silently(reader);
  nb_suppress_name(reader->mistakes, token->text);
  return nb_expected_at(reader, token, hint, what);
}
