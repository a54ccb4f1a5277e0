/* Values of a statement: numbers with their units, whole numbers, words and names.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "reader.h"

/* ---- numbers and their units ---- */

const char *nb_range_words(enum nb_range range) {
  static const char *const words[] = {[NB_ANY] = "",
                                      [NB_POSITIVE] = " above 0",
                                      [NB_NOT_NEGATIVE] = ", 0 or more",
                                      [NB_FRACTION] = " from 0 to 1",
                                      [NB_HALF] = " from 0 to 0.5"};
  return words[range];
}

static bool within(double value, enum nb_range range) {
  return range == NB_ANY || (range == NB_POSITIVE && value > 0) || (range == NB_NOT_NEGATIVE && value >= 0) ||
         (range == NB_FRACTION && value >= 0 && value <= 1) || (range == NB_HALF && value >= 0 && value <= 0.5);
}

/* An expected number: its unit; its name and possible units, for messages. */
struct wanted {
  struct nb_unit unit;
  const char *name, *units;
  bool per_cycle; /* the unit may be `per cycle` */
  bool tolerance; /* hints propose no number below 0 */
  bool relative;  /* a percentage may stand in place of the number and its unit */
};

static struct wanted wanted_of(enum nb_unit_kind kind) {
  struct wanted it = {
      .name = nb_unit_kind_name(kind), .units = nb_unit_list(kind), .per_cycle = kind == NB_UNIT_STRAIN_RATE};
  char si[NB_NAME_SIZE] = "";
  memcpy(si, it.units, strcspn(it.units, ","));
  nb_unit_read(&it.unit, si);
  return it;
}

static bool is_dimensionless(const struct wanted *it) {
  return !it->unit.angle && nb_dimension_same(it->unit.dimension, (struct nb_dimension){0});
}

/* Writes what is expected: "a length and its unit (m, mm, um, nm, cm, km)". */
static void expected_text(char *text, size_t size, const struct nb_reader *reader, const struct wanted *it) {
  if (is_dimensionless(it))
    snprintf(text, size, "a number (without a unit, or with %% or ppm)");
  else if (reader->unitless)
    snprintf(text, size, "%s as a number without a unit (the scene says `units none`)", it->name);
  else
    snprintf(text, size, "%s and its unit (%s)%s", it->name, it->units, it->relative ? ", or a percentage" : "");
}

/* Reports a number and its unit, which may be NULL: "expected WHAT, found `50 kg`". */
static bool number_mistake(struct nb_reader *reader, const struct nb_token *number, const struct nb_token *unit,
                           const char *hint, const char *what) {
  struct nb_token both = *number;
  if (unit && unit->column > number->column)
    both.length = unit->column + unit->length - number->column;
  char name[NB_NAME_SIZE + 8] = "";
  if (number->name)
    snprintf(name, sizeof name, " (`$%s`)", number->name);
  return nb_token_mistake(reader, &both, hint, "expected %s, found `%.80s%s%.80s`%s", what, number->text,
                          unit ? " " : "", unit ? unit->text : "", name);
}

/* True if the statement `units` has a mistake: then a number may have a unit or not. */
static bool are_units_unknown(const struct nb_reader *reader) { return nb_name_suppressed(reader->mistakes, "units"); }

static bool is_number(const struct nb_token *token) {
  double value;
  return token && nb_number_read(&value, token->text, 0) == NB_READ;
}

static const struct nb_token *token_after(const struct nb_reader *reader, size_t n) {
  return reader->next + n < reader->count ? &reader->tokens[reader->next + n] : NULL;
}

static bool is_clause(const struct nb_reader *reader, const struct nb_token *token) {
  for (const struct nb_argument *field = reader->keyword ? reader->keyword->arguments : NULL; field && field->count;
       field++)
    if (nb_begins_clause(field, token->text))
      return true;
  return false;
}

/* True if the words after a number are positional arguments of the row, such as the material of a disc, and not a
 * unit. The row of `contact` has no arguments: one word, the material, follows a radius, and then `with` or the end. */
static bool are_words_of_row(const struct nb_reader *reader) {
  const struct nb_argument *const fields = reader->keyword ? reader->keyword->arguments : NULL;
  const bool contact = reader->here == NB_IN_CONTACT_TEST && strcmp(reader->tokens[0].text, "contact") == 0;
  size_t wanted = contact, words = 0;
  for (const struct nb_argument *field = fields; field && field->count; field++)
    wanted += !field->word && field->kind == NB_ARGUMENT_WORD && !(reader->given >> (field - fields) & 1);
  for (const struct nb_token *token; (token = token_after(reader, 1 + words)); words++)
    if (is_clause(reader, token) || is_number(token) || (contact && strcmp(token->text, "with") == 0))
      break;
  return words <= wanted;
}

static const char *without_comma(char bare[NB_NAME_SIZE], const char *text) {
  snprintf(bare, NB_NAME_SIZE, "%.*s", (int)strcspn(text, ",;"), text);
  return bare;
}

/* True if a token is a unit, or equals one of the units in messages except for upper and lower case. */
static bool resembles_unit(const char *text) {
  struct nb_unit unit;
  char bare[NB_NAME_SIZE];
  struct nb_guess guess = nb_guess_begin(without_comma(bare, text));
  for (int kind = 0; kind < NB_UNIT_KINDS; kind++)
    nb_unit_offer(&guess, nb_unit_list((enum nb_unit_kind)kind));
  return nb_unit_read(&unit, text) || (nb_guess_found(&guess) && guess.distance == 0);
}

static bool is_percent(const char *text) { return strcmp(text, "percent") == 0 || strcmp(text, "per-cent") == 0; }

/* True if a word after a number of an expectation is part of the expectation, `3 of`, and not a mistyped unit. */
static bool continues_expectation(const char *text) {
  static const char *const words[] = {"in",    "of",    "over",     "with",      "within",    "versus",
                                      "at",    "above", "below",    "increases", "decreases", "constant",
                                      "order", "every", "expected", NULL};
  size_t k = 0;
  while (words[k] && strcmp(words[k], text) != 0)
    k++;
  return words[k] || !isalpha((unsigned char)*text);
}

static bool is_unit_of_expectation(const struct nb_reader *reader, const struct wanted *it, const char *text) {
  return reader->here == NB_IN_EXPECT && !is_dimensionless(it) && !continues_expectation(text);
}

/* True if the token after a number is probably meant as the unit of the number. */
static bool meant_as_unit(const struct nb_reader *reader, const struct wanted *it) {
  const struct nb_token *token = token_after(reader, 1);
  if (!token || is_number(token) || is_clause(reader, token))
    return false;
  if (is_percent(token->text) || is_unit_of_expectation(reader, it, token->text))
    return true;
  const bool own = are_words_of_row(reader);
  if (reader->unitless)
    return !own && resembles_unit(token->text);
  char bare[NB_NAME_SIZE];
  const bool foreign = reader->here & (NB_IN_SCENE | NB_IN_STAGE | NB_IN_START) && /* elsewhere `in` has a meaning */
                       nb_unit_foreign(without_comma(bare, token->text), &it->unit.dimension);
  return foreign || resembles_unit(token->text) ||
         (reader->keyword && !own && !is_dimensionless(it) && !are_units_unknown(reader) && !nb_synonym(token->text));
}

static bool names_angle(const struct wanted *it, const char *text) {
  struct nb_unit unit;
  return is_dimensionless(it) && nb_unit_read(&unit, text) && unit.angle;
}

/* If `example`, adds the statement's example, ", for example `gravity 0 m/s2 -9.81 m/s2`"; if the page has had no unit
 * so far, also ", or begin the scene with `units none` instead of `units si`, the default". */
static void add_advice(char *text, const struct nb_reader *reader, bool example) {
  char as[NB_HINT_SIZE];
  if (example && nb_example_hint(as, reader))
    snprintf(text, NB_HINT_SIZE / 2, ", %.200s", as);
  if (!reader->has_units && !reader->starts)
    nb_append(text, NB_HINT_SIZE / 2, ", or begin the %s with `units none` instead of `units si`, the default",
              reader->here & (NB_IN_CONTACT_TEST | NB_IN_SEGMENT) ? "contact test" : "scene");
}

/* Writes the hint with two common units. For a number without a unit the hint also has the statement's example if the
 * number follows no word of a clause, or if another number follows. */
static const char *common_units_hint(char *hint, const struct nb_reader *reader, const char *n, const struct wanted *it,
                                     bool has_unit) {
  const struct nb_token *const number = nb_token_peek(reader), *const next = has_unit ? NULL : token_after(reader, 1);
  const bool each = is_number(next), first = number > reader->tokens && !is_clause(reader, number - 1);
  const char *const second = strchr(it->units, ','), *const write = each ? "each number has its own unit: " : "write ";
  const int length = (int)strcspn(it->units, ",");
  char more[NB_HINT_SIZE / 2] = "";
  double value;
  if (!has_unit)
    add_advice(more, reader, each || first);
  if (strstr(it->units, NB_PER_CYCLE) && nb_line_has(reader, NB_PER_CYCLE))
    snprintf(hint, NB_HINT_SIZE, "write `%.40s %s`, as the other rates of the line", n, NB_PER_CYCLE);
  else if (second)
    snprintf(hint, NB_HINT_SIZE, "%s`%.40s %.*s` or `%.40s %.*s`%s", write, n, length, it->units, n,
             (int)strcspn(second + 2, ","), second + 2, more);
  else
    snprintf(hint, NB_HINT_SIZE, "%s`%.40s %s`%s", write, n, it->units, more);
  if (it->relative && !has_unit && nb_number_read(&value, n, 0) == NB_READ && value >= 1e-4 && value <= 100)
    nb_append(hint, NB_HINT_SIZE, "; a relative tolerance is a percentage, `%.6g %%`", value < 1 ? 100 * value : value);
  return hint;
}

/* Writes the hint for a comma behind the right unit, `5 mm,`; false: there is no such comma. */
static bool comma_hint(char *hint, const char *n, const char *unit, const struct wanted *it) {
  char bare[NB_NAME_SIZE];
  struct nb_unit read;
  const char comma = unit[strlen(without_comma(bare, unit))];
  snprintf(hint, NB_HINT_SIZE, "leave out the `%c`: `%.40s %.40s`", comma, n, bare);
  return comma && nb_unit_read(&read, bare) && nb_dimension_same(read.dimension, it->unit.dimension);
}

/* Writes the hint for an angle in degrees on a page without units; false: the number is no such angle. */
static bool radian_hint(char *hint, const char *n, const char *unit, const struct wanted *it) {
  snprintf(hint, NB_HINT_SIZE, "without units an angle is in rad: write `(%.40s*pi/180)`", n);
  return it->unit.angle && strcmp(unit, "deg") == 0;
}

/* Writes the hint for `1 percent`; false: the number has another unit, or cannot be a percentage. */
static bool percent_hint(char *hint, const char *n, const struct nb_token *next, const struct wanted *it) {
  snprintf(hint, NB_HINT_SIZE, "write `%.40s %%`", n);
  return next && is_percent(next->text) && (is_dimensionless(it) || it->relative);
}

/* Writes the hint for `9.81 m/s^2`; false: this is no other spelling of a unit that fits. */
static bool spelling_hint(char *hint, const char *n, const char *unit, const struct wanted *it) {
  char bare[NB_NAME_SIZE], ours[NB_NAME_SIZE];
  struct nb_unit read;
  if (!nb_unit_respelt(ours, without_comma(bare, unit)) || !nb_unit_read(&read, ours) ||
      !nb_dimension_same(read.dimension, it->unit.dimension))
    return false;
  snprintf(hint, NB_HINT_SIZE, "write `%.40s %s`", n, ours);
  return true;
}

/* Writes the hint for `1 m/2`, a quotient outside parentheses; false: no operator follows the unit. */
static bool quotient_hint(char *hint, const char *n, const struct nb_token *next) {
  struct nb_unit unit; /* `m/s2` is one unit */
  char bare[NB_NAME_SIZE], ours[NB_NAME_SIZE];
  const char *const text = next ? without_comma(bare, next->text) : "";
  const bool other = nb_unit_foreign(text, NULL) || nb_unit_read(&unit, text) || nb_unit_respelt(ours, text);
  const int head = next && !other && !strchr(next->text, '=') ? (int)nb_unit_before_operator(next->text) : 0;
  if (head)
    snprintf(hint, NB_HINT_SIZE, "put operators and their operands into parentheses: `(%.40s %.*s %c %.80s)`", n, head,
             next->text, next->text[head], next->text + head + 1);
  return head > 0;
}

/* True if the limit of a condition follows the number: `until time above 0.5 at most 100 cycles`. */
static bool limit_follows(const struct nb_reader *reader) {
  const struct nb_token *const at = token_after(reader, 1), *const most = token_after(reader, 2);
  return most && strcmp(at->text, "at") == 0 && strcmp(most->text, "most") == 0;
}

static bool special_hint(char *hint, const struct nb_reader *reader, const char *n, const char *unit,
                         const struct wanted *it) {
  const struct nb_token *const next = token_after(reader, 1);
  return percent_hint(hint, n, next, it) || quotient_hint(hint, n, next) || comma_hint(hint, n, unit, it) ||
         (reader->unitless ? radian_hint(hint, n, unit, it) : spelling_hint(hint, n, unit, it)) ||
         (next && !is_number(next) && !limit_follows(reader) && nb_pair_hint(hint, reader->tokens[0].text, next->text));
}

/* The number without its unit: as written, or its value in SI if the page has no units and the unit has the wanted
 * dimension. */
static const char *in_si(char si[NB_NAME_SIZE], const struct nb_reader *reader, const struct nb_token *number,
                         const struct nb_token *unit, const struct wanted *it) {
  struct nb_unit read;
  double value;
  if (!reader->unitless || !nb_unit_read(&read, unit->text) || !nb_dimension_same(read.dimension, it->unit.dimension) ||
      (read.shift == 0 && read.factor == 1) || nb_quantity_read(&value, number->text, false, &read) != NB_READ)
    return number->text;
  snprintf(si, NB_NAME_SIZE, "%.10g", value);
  return si;
}

/* The number that a hint proposes with another unit. A tolerance has no sign. */
static const char *proposed_number(const struct nb_token *number, const struct wanted *it) {
  return number->computed ? "(...)" : number->text + (it->tolerance && *number->text == '-');
}

/* Writes the hint for a number without a unit, or with the wrong unit; NULL: a computed number has a unit, for which
 * there is no hint. */
static const char *unit_hint(char *hint, const struct nb_reader *reader, const struct nb_token *number,
                             const struct nb_token *unit, const struct wanted *it) {
  char bare[NB_NAME_SIZE];
  const char *const text = unit ? unit->text : "";
  struct nb_guess guess = nb_guess_begin(without_comma(bare, text));
  const struct nb_foreign_unit *const foreign = nb_unit_foreign(bare, &it->unit.dimension);
  const char *const n = proposed_number(number, it);
  char si[NB_NAME_SIZE];
  double value;
  nb_unit_offer(&guess, it->units);
  if (unit && number->computed && !foreign)
    return NULL;
  if (special_hint(hint, reader, n, text, it))
    return hint;
  if (unit && names_angle(it, text))
    snprintf(hint, NB_HINT_SIZE, "write the tangent of this angle: `(tan(%.40s %.40s))`", number->text, text);
  else if (unit && (reader->unitless || is_dimensionless(it)))
    snprintf(hint, NB_HINT_SIZE, "write `%.40s`", in_si(si, reader, number, unit, it));
  else if (foreign && nb_number_read(&value, number->text, 0) == NB_READ)
    snprintf(hint, NB_HINT_SIZE, "1 %s is %.10g %s: write `%.10g %s`", bare, foreign->factor, foreign->ours,
             value * foreign->factor, foreign->ours);
  else
    return unit && nb_guess_found(&guess) ? nb_guess_hint(&guess, hint)
                                          : common_units_hint(hint, reader, n, it, unit != NULL);
  return hint;
}

/* True if the token after the number is a unit of the right dimension; *unit is then this unit, or the factor 1 for
 * `per cycle`. A computed value fits both as an angle and as a number. */
static bool unit_fits(struct nb_unit *unit, const struct nb_reader *reader, const struct wanted *it) {
  const struct nb_token *token = token_after(reader, 1);
  *unit = (struct nb_unit){.factor = 1};
  if (!token || (it->per_cycle && strcmp(token->text, NB_PER_CYCLE) == 0))
    return token;
  struct nb_unit read;
  if (!nb_unit_read(&read, token->text) ||
      (reader->unitless && !(is_dimensionless(it) && nb_unit_without_dimension(token->text))) ||
      !nb_dimension_same(read.dimension, it->unit.dimension) ||
      (read.angle != it->unit.angle && !nb_token_peek(reader)->computed))
    return false;
  *unit = read;
  return true;
}

static bool may_be_bare(const struct nb_reader *reader, const struct wanted *it) {
  const bool computed =
      nb_token_peek(reader)->computed && nb_dimension_same(it->unit.dimension, (struct nb_dimension){0});
  return computed || reader->unitless || is_dimensionless(it) || are_units_unknown(reader);
}

/* The unit of a formula, `m^0.5`, if no number of a page can have it; NULL: the number is no formula with such a
 * unit. */
static const struct nb_token *unit_of_formula(const struct nb_reader *reader) {
  const struct nb_token *const number = nb_token_peek(reader), *const unit = token_after(reader, 1);
  struct nb_unit read;
  return number->computed && unit && unit->computed && unit->column == number->column &&
                 !nb_unit_read(&read, unit->text)
             ? unit
             : NULL;
}

/* Reports a number without a unit, or with the wrong one, unless the system of units is unknown. */
static bool unit_mistake(struct nb_reader *reader, const struct nb_token *unit, const struct wanted *it) {
  const struct nb_token *const number = nb_token_peek(reader);
  const struct nb_token *const formula = unit_of_formula(reader);
  char what[256], hint[NB_HINT_SIZE];
  expected_text(what, sizeof what, reader, it);
  if (formula && !are_units_unknown(reader)) {
    snprintf(hint, sizeof hint,
             "the formula has the unit `%.80s`, and `%.*s` is expected: check its powers and the unit of each name",
             formula->text, (int)strcspn(it->units, ","), it->units);
    return number_mistake(reader, number, formula, hint, what);
  }
  return are_units_unknown(reader)
             ? nb_fail_silently(reader)
             : number_mistake(reader, number, unit, unit_hint(hint, reader, number, unit, it), what);
}

/* Writes the hint for a name that a `let` or a `sweep` defines, `R` or `-R`, in place of its value; NULL: the token is
 * no such name. */
static const char *bare_name_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token) {
  const char *const sign = token && strchr("+-", token->text[0]) ? "-" : "", *const name = token ? token->text : "";
  const char *const bare = name + (*sign && *name);
  if (!*bare || NB_FIND(reader->bindings, reader->binding_count, bare) < 0)
    return NULL;
  snprintf(hint, NB_HINT_SIZE, "write `%s$%.60s`; in an expression the name has no `$`: `(2*%.60s)`",
           *name == '-' ? "-" : "", bare, bare);
  return hint;
}

/* Writes the hint for `3,`, a number that a comma follows, in place of a number and its unit; false: the token is
 * something else. */
static bool comma_after_number_hint(char *hint, const struct nb_reader *reader, const char *text,
                                    const struct wanted *it) {
  char bare[NB_NAME_SIZE];
  struct nb_unit unit;
  double value;
  const struct nb_token *const next = token_after(reader, 1);
  const bool has_unit = next && nb_unit_read(&unit, next->text);
  const size_t n = strlen(without_comma(bare, text));
  snprintf(hint, NB_HINT_SIZE, "leave out the comma%s: `%.40s %.*s`", has_unit ? "" : "; each number has its own unit",
           bare, has_unit ? (int)strlen(next->text) : (int)strcspn(it->units, ","), has_unit ? next->text : it->units);
  return !reader->unitless && !is_dimensionless(it) && text[n] == ',' && !text[n + 1] &&
         nb_number_read(&value, bare, 0) == NB_READ;
}

/* True for `*2` and `-`; `-1x` is a mistyped number. */
static bool begins_with_operator(const struct nb_token *token) {
  return token && strchr("+-*/^", token->text[0]) &&
         !(strchr("+-", token->text[0]) && nb_number_length(token->text + 1));
}

/* Reports a token that is no number in place of one. */
static bool no_number_mistake(struct nb_reader *reader, const struct wanted *it) {
  const struct nb_token *const token = nb_token_peek(reader);
  char what[256], hint[NB_HINT_SIZE];
  expected_text(what, sizeof what, reader, it);
  if (token && comma_after_number_hint(hint, reader, token->text, it))
    return number_mistake(reader, token, NULL, hint, what);
  return nb_expected(reader, bare_name_hint(hint, reader, token), "%s", what);
}

static bool take_quantity(struct nb_reader *reader, const struct wanted *it, enum nb_range range, double *value) {
  char what[256];
  struct nb_unit unit;
  const struct nb_token *number = nb_token_peek(reader);
  *value = 1;
  if (!number || nb_number_read(value, number->text, 0) == NB_NO_NUMBER)
    return no_number_mistake(reader, it);
  const bool matches = unit_fits(&unit, reader, it);
  const struct nb_token *behind = matches || meant_as_unit(reader, it) ? token_after(reader, 1) : NULL;
  const enum nb_reading reading = nb_quantity_read(value, number->text, number->computed, &unit);
  if (reading != NB_READ)
    return number_mistake(reader, number, matches ? behind : NULL, NULL, nb_reading_words(reading));
  if (!matches && (behind || !may_be_bare(reader, it)))
    return unit_mistake(reader, behind, it);
  if (!within(*value, range)) {
    snprintf(what, sizeof what, "%s%s", it->name, nb_range_words(range));
    return number_mistake(reader, number, behind, NULL, what);
  }
  reader->next += matches ? 2 : 1;
  reader->has_units |= matches;
  return !begins_with_operator(nb_token_peek(reader)) || nb_expected(reader, NULL, "no operator outside parentheses");
}

bool nb_take_number(struct nb_reader *reader, enum nb_unit_kind kind, enum nb_range range, double *value) {
  const struct wanted it = wanted_of(kind);
  return take_quantity(reader, &it, range, value);
}

bool nb_take_time_at(struct nb_reader *reader, double *value) {
  struct wanted it = wanted_of(NB_UNIT_TIME);
  const struct nb_token *const number = nb_token_peek(reader);
  char what[256], units[NB_NAME_SIZE]; /* the hint has the first two units */
  const bool whole = !number || !number->text[strspn(number->text, "0123456789")];
  snprintf(units, sizeof units, whole ? "cycles, %s" : "%s, cycles", it.units);
  it.name = "a number of cycles or a time", it.units = units;
  expected_text(what, sizeof what, reader, &it);
  if (!number)
    return nb_expected(reader, "for example `at 5 cycles`", "%s", what);
  return take_quantity(reader, &it, NB_NOT_NEGATIVE, value);
}

/* As wanted_of, for a number in a unit of SI. */
static struct wanted wanted_in(const char *si_unit) {
  enum nb_unit_kind kind;
  struct wanted it = {.name = "a number", .units = si_unit};
  if (nb_unit_kind_of(&kind, si_unit))
    return wanted_of(kind);
  nb_unit_read(&it.unit, si_unit);
  return it;
}

bool nb_take_in_unit(struct nb_reader *reader, const char *si_unit, double *value) {
  const struct wanted it = wanted_in(si_unit);
  return take_quantity(reader, &it, NB_ANY, value);
}

bool nb_take_tolerance(struct nb_reader *reader, const char *si_unit, bool relative, double *value) {
  struct wanted it = wanted_in(si_unit);
  it.tolerance = true, it.relative = relative;
  return take_quantity(reader, &it, NB_ANY, value);
}

/* ---- whole numbers, words and names ---- */

/* Each operation of an expression rounds by up to 1.1e-16 of its result, so a result this near to a whole number is one. */
static const double count_rounding = 1e-12;

/* Reads a whole number from low to high, or a computed one that is whole but for rounding. */
static bool read_count(const struct nb_token *token, unsigned long low, unsigned long high, unsigned long *value) {
  const size_t digits = token ? strspn(token->text, "0123456789") : 0;
  double number;
  if (digits > 0 && digits < 19 && token->text[digits] == '\0')
    *value = strtoul(token->text, NULL, 10);
  else if (token && token->computed && nb_number_read(&number, token->text, 0) == NB_READ &&
           number < (double)high + 1 && fabs(number - round(number)) <= count_rounding * number)
    *value = (unsigned long)round(number);
  else
    return false;
  return *value >= low && *value <= high;
}

/* Writes the hint for a whole number from low to high in another form, `1e6` or `1,000,000`; false: this is none. */
static bool whole_hint(char *hint, const struct nb_token *token, unsigned long low, unsigned long high) {
  char bare[NB_NAME_SIZE] = "";
  double number;
  size_t group = strcspn(token->text, ",");
  if (token->computed || !token->text[strspn(token->text, "0123456789")])
    return false;
  nb_append(bare, sizeof bare, "%.*s", (int)group, token->text);
  for (const char *at = token->text + group; *at; at += group) {
    group = 1 + strspn(at + 1, "0123456789");
    if (group != 4) /* a comma and three digits */
      return false;
    nb_append(bare, sizeof bare, "%.3s", at + 1);
  }
  if (nb_number_read(&number, bare, 0) != NB_READ || number != floor(number))
    return false;
  snprintf(hint, NB_HINT_SIZE, "write `%.0f`", number);
  return number >= (double)low && number <= (double)high;
}

/* As nb_take_count; `counted`: what the message expects, such as "a number of cycles". */
static bool take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value,
                       const char *hint, const char *counted) {
  const struct nb_token *token = nb_token_peek(reader);
  if (read_count(token, low, high, value))
    return reader->next++, true;
  *value = low;
  char what[192], text[NB_HINT_SIZE];
  const struct nb_token *const unit = token_after(reader, 1);
  snprintf(what, sizeof what, "%s from %lu to %lu", counted, low, high);
  if (!hint && unit && nb_pair_hint(text, reader->tokens[0].text, unit->text))
    hint = text;
  if (token && !is_number(token) && bare_name_hint(text, reader, token))
    hint = text;
  if (token && whole_hint(text, token, low, high))
    return number_mistake(reader, token, NULL, text, what);
  return is_number(token) ? number_mistake(reader, token, NULL, hint, what) : nb_expected(reader, hint, "%s", what);
}

bool nb_take_count(struct nb_reader *reader, unsigned long low, unsigned long high, unsigned long *value) {
  return take_count(reader, low, high, value, NULL, "a whole number");
}

bool nb_take_count_of(struct nb_reader *reader, const char *one, unsigned long *value) {
  char several[NB_NAME_SIZE], counted[2 * NB_NAME_SIZE], hint[NB_HINT_SIZE];
  snprintf(several, sizeof several, "%ss", one);
  snprintf(counted, sizeof counted, "a number of %s", several);
  snprintf(hint, sizeof hint, "write `100 %s`%s", several,
           strcmp(one, "cycle") == 0 ? "; a duration divided by the time step is a number of cycles" : "");
  if (!take_count(reader, 1, NB_COUNT_MAX, value, hint, counted) || nb_token_skip(reader, one) ||
      nb_token_skip(reader, several))
    return !reader->bad;
  const struct nb_token *const token = nb_token_peek(reader);
  struct nb_unit unit;
  if (!token || !nb_unit_read(&unit, token->text) || !nb_pair_hint(hint, reader->tokens[0].text, token->text))
    snprintf(hint, sizeof hint, "write `%lu %s`", *value, *value == 1 ? one : several);
  return nb_token_mistake(reader, token, hint, "expected `%s`, found %s%.80s%s", several, token ? "`" : "",
                          token ? token->text : "the end of the line", token ? "`" : "");
}

int nb_take_choice(struct nb_reader *reader, const char *words) {
  const struct nb_token *token = nb_token_peek(reader);
  char list[256] = "", word[NB_NAME_SIZE], hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  int index = 0;
  for (const char *at = words; *at; index++) {
    const size_t length = strcspn(at, "|");
    snprintf(word, sizeof word, "%.*s", (int)length, at);
    if (nb_token_skip(reader, word))
      return index;
    nb_guess_offer(&guess, word);
    at += length + (at[length] != '\0');
    nb_append_item(list, sizeof list, word, !*at);
  }
  nb_expected(reader, token ? nb_guess_hint(&guess, hint) : NULL, "%s", list);
  return -1;
}

bool nb_take_word(struct nb_reader *reader, const char *word) { return nb_take_choice(reader, word) == 0; }

const struct nb_token *nb_take_token(struct nb_reader *reader, const char *what) {
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
    return nb_take_token(reader, what);
  nb_expected(reader,
              token ? "a name begins with a letter (a to z, A to Z); letters, digits, `_` and `-` may follow; it has "
                      "fewer than 64 characters"
                    : NULL,
              "%s", what);
  return NULL;
}

int nb_named(struct nb_reader *reader, const struct nb_token *token, const void *things, size_t count, size_t size,
             const char *what, const char *otherwise) {
  char hint[NB_HINT_SIZE];
  const int index = token ? nb_find(things, count, size, token->text) : -1;
  if (token && index < 0) {
    const char *near = nb_nearest(hint, token->text, things, count, size);
    nb_unknown_name(reader, token, near ? near : otherwise, what);
  }
  return index;
}
