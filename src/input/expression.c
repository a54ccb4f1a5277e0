/* Expressions with units, by recursive descent:
 *
 *   sum       product {+|- product}          both sides have the same dimension
 *   product   sign {*|/ sign}
 *   sign      -|+ sign | power               -2^2 is -4
 *   power     operand {^ sign}               from right to left: 2^3^2 is 2^9; the exponent is a number
 *   operand   literal {unit} | ( sum ) {unit} | NAME | pi | FUNCTION( sum {, sum} )
 *
 * A unit is one word after a space: `2 N/m` is a stiffness, `2 N / m` is a force divided by the value named m. A number
 * and a name side by side are not a product. A literal is rounded once, together with the power of ten of its unit:
 * `0.3 mm` is the double nearest to 0.0003. All other operations are computed in double precision, in the written
 * order. Powers and functions are computed by the C library.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "core/clean.h"
#include "core/vec.h"
#include "expression.h"

enum {
  DEPTH_MAX = 100,
  SIXTIETHS = 60,
  POWER_MAX = 99,
  WORD_SIZE = NB_NAME_SIZE + 1 /* a longer word is truncated to a text that cannot be a name */
};

struct quantity {
  double value; /* SI */
  struct nb_dimension of;
};

struct parser {
  struct nb_reader *reader; /* reader->bad is true after the first mistake; then parsing ends */
  const char *line, *at, *end;
  int depth;
};

static struct quantity sum(struct parser *p);

/* ---- functions ---- */

static double smaller(double a, double b) { return a < b ? a : b; }
static double larger(double a, double b) { return a > b ? a : b; }

/* Dimensions of a function's arguments and of its value. */
enum rule {
  OF_NUMBERS, /* arguments and value are numbers */
  OF_ROOT,    /* value: the square root of the argument's dimension */
  OF_RATIO,   /* two arguments of the same dimension; the value is a number */
  OF_LIKE     /* arguments and value have the same dimension */
};
static const struct function {
  const char *name;
  enum rule rule;
  double (*one)(double), (*two)(double, double);
} functions[] = {{"sqrt", OF_ROOT, sqrt, NULL},    {"sin", OF_NUMBERS, sin, NULL},   {"cos", OF_NUMBERS, cos, NULL},
                 {"tan", OF_NUMBERS, tan, NULL},   {"asin", OF_NUMBERS, asin, NULL}, {"acos", OF_NUMBERS, acos, NULL},
                 {"atan", OF_NUMBERS, atan, NULL}, {"atan2", OF_RATIO, NULL, atan2}, {"hypot", OF_LIKE, NULL, hypot},
                 {"exp", OF_NUMBERS, exp, NULL},   {"log", OF_NUMBERS, log, NULL},   {"abs", OF_LIKE, fabs, NULL},
                 {"min", OF_LIKE, NULL, smaller},  {"max", OF_LIKE, NULL, larger}};
const char nb_function_names[] = "sqrt, sin, cos, tan, asin, acos, atan, atan2, hypot, exp, log, abs, min, max";

static const struct function *function_of(const char *name) {
  for (size_t k = 0; k < sizeof functions / sizeof *functions; k++)
    if (strcmp(functions[k].name, name) == 0)
      return &functions[k];
  return NULL;
}

bool nb_name_reserved(const char *name) { return function_of(name) || strcmp(name, "pi") == 0; }

/* ---- characters and mistakes ---- */

/* The next character that is not a space; 0 at the end and after a mistake. */
static char peek(struct parser *p) {
  while (p->at < p->end && (*p->at == ' ' || *p->at == '\t'))
    p->at++;
  return p->at < p->end && !p->reader->bad ? *p->at : 0;
}

static bool skip(struct parser *p, char sign) {
  const bool is = peek(p) == sign;
  p->at += is;
  return is;
}

/* Copies the letters, digits and `signs` at the current position to `text`; returns their number of bytes. */
static size_t read_word(const struct parser *p, const char *signs, char text[WORD_SIZE]) {
  size_t n = 0;
  while (p->at + n < p->end && (isalnum((unsigned char)p->at[n]) || p->at[n] & 0x80 || strchr(signs, p->at[n])))
    n++;
  snprintf(text, WORD_SIZE, "%.*s", (int)n, p->at);
  return n;
}

/* Reports a mistake and marks `length` bytes from `at` on. The returned value is never used. */
static struct quantity mistake(struct parser *p, const char *at, size_t length, const char *hint, const char *format,
                               ...) __attribute__((format(printf, 5, 6)));
static struct quantity mistake(struct parser *p, const char *at, size_t length, const char *hint, const char *format,
                               ...) {
  char text[512];
  const struct nb_token token = nb_token_at(p->line, at, length);
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  nb_token_mistake(p->reader, &token, hint, "%s", text);
  return (struct quantity){0};
}

static struct quantity expected(struct parser *p, const char *what) {
  static const char unit_place[] =
      "a unit follows a number or an expression in parentheses, `(2*n) mm`, and a value has one unit";
  char text[WORD_SIZE], hint[NB_HINT_SIZE];
  struct nb_unit unit;
  const char c = peek(p);
  if (!c)
    return mistake(p, p->at, 1, NULL, "expected %s, found the end of the expression", what);
  const size_t length = read_word(p, "_.%$", text);
  if (length == 0)
    snprintf(text, sizeof text, "%c", c);
  snprintf(hint, sizeof hint, "inside an expression a name has no `$`: `%s`; outside it is `$%s`", text + 1, text + 1);
  const char *const otherwise = c == '$'   ? hint
                                : c == '*' ? "a power is written `^`"
                                : c == ',' ? "the decimal point is `.`; `sweep` has several values, without commas"
                                : strcmp(what, "an operator") != 0 ? NULL
                                : isdigit((unsigned char)c)        ? "use `sweep` for several values"
                                : nb_unit_read(&unit, text)        ? unit_place
                                                                   : NULL;
  const char *const typed = length ? nb_syntax_hint(p->reader, hint, text) : NULL;
  return mistake(p, p->at, length ? length : 1, typed ? typed : otherwise, "expected %s, found `%s`", what, text);
}

/* Returns a value and its dimension after a check that both can be represented. m, kg and s are the powers of the units,
 * in sixtieths. Messages point at `from`. */
static struct quantity checked_value(struct parser *p, const char *from, size_t length, double value, double m,
                                     double kg, double s) {
  const double of[] = {m, kg, s};
  for (int k = 0; k < 3; k++)
    if (!(fabs(of[k] - nearbyint(of[k])) < 1e-6 && fabs(of[k]) <= POWER_MAX * SIXTIETHS))
      return mistake(p, from, length, NULL,
                     "expected powers of units that are simple fractions, such as 1/2, up to %d, found the power %g",
                     POWER_MAX, of[k] / SIXTIETHS);
  if (!isfinite(value))
    return mistake(p, from, length, NULL, "expected a finite value, found that `%.*s` gives %s", (int)length, from,
                   isnan(value) ? "NaN" : "infinity");
  return (struct quantity){value, {(int)nearbyint(m), (int)nearbyint(kg), (int)nearbyint(s)}};
}

/* True if two values have the same dimension; otherwise false with a message about the operator or function at
 * `from`. */
static bool same_dimension(struct parser *p, const char *from, size_t length, struct quantity left,
                           struct quantity right) {
  char one[2 * NB_NAME_SIZE], other[2 * NB_NAME_SIZE];
  if (p->reader->bad || nb_dimension_same(left.of, right.of))
    return !p->reader->bad;
  nb_dimension_words(one, sizeof one, left.of);
  nb_dimension_words(other, sizeof other, right.of);
  mistake(p, from, length, NULL,
          isalpha((unsigned char)*from)
              ? "expected two values of the same dimension in `%.*s()`, found %s and %s"
              : "expected the same dimension on both sides of `%.*s`, found %s on the left and %s on the right",
          (int)length, from, one, other);
  return false;
}

/* True if a value has no dimension; otherwise false with a message: "expected a number WHAT". */
static bool is_number(struct parser *p, const char *from, size_t length, const char *what, struct quantity it) {
  char words[2 * NB_NAME_SIZE];
  if (p->reader->bad || nb_dimension_same(it.of, (struct nb_dimension){0}))
    return !p->reader->bad;
  nb_dimension_words(words, sizeof words, it.of);
  mistake(p, from, length, NULL, "expected a number %s, found %s", what, words);
  return false;
}

/* ---- operands ---- */

/* Reports the word `text`, which follows a number but cannot be its unit here. `length`: bytes of the word; `is`: the
 * word is a unit, but no space is before it, or the page has no units. */
static void wrong_unit(struct parser *p, size_t length, const char *text, bool is) {
  char hint[NB_HINT_SIZE], other[NB_HINT_SIZE];
  const bool has_none = p->reader->unitless && !nb_unit_without_dimension(text);
  int open = 0; /* parentheses */
  for (const char *c = p->line; c < p->at; c++)
    open += (*c == '(') - (*c == ')');
  const char *const form = is && !has_none ? "put a space between the number and the unit `%s`"
                           : is            ? "the scene has `units none`, so `%s` is not a unit"
                           : strpbrk(text, "/.")
                               ? "a unit is one word, such as `kg/m3`; to divide put spaces around `/`"
                           : open > 0 ? "add the missing `)`, or write a product as `* %s`"
                                      : "a product is written `* %s`";
  const struct nb_foreign_unit *const foreign = nb_unit_foreign(text, NULL);
  const int head = (int)nb_unit_before_operator(text);
  snprintf(hint, sizeof hint, form, text);
  if (head)
    nb_append(hint, sizeof hint, ": `%.*s %c %s`", head, text, text[head], text + head + 1);
  if (foreign)
    snprintf(hint, sizeof hint, "1 %s is %.10g %s", text, foreign->factor, foreign->ours);
  const char *const typed = nb_syntax_hint(p->reader, other, text);
  mistake(p, p->at, length, typed ? typed : hint, "expected a unit or an operator, found `%s`", text);
}

/* True if there is no word after a number, or a word that begins with an operator or a number. */
static bool is_no_unit(const char *text) {
  return !*text || *text == '/' || (strchr(".0123456789", *text) && text[1] != '/');
}

/* Refuses `3 mm^2` and `3 mm²`, which may mean `3 mm2` or `(3 mm)^2`; false: no such power follows the unit of `length`
 * bytes. */
static bool power_of_unit(struct parser *p, size_t length) {
  char hint[NB_HINT_SIZE], text[WORD_SIZE], ours[NB_NAME_SIZE];
  const size_t all = length + strcspn(p->at + length, " \t*/+-()");
  snprintf(text, sizeof text, "%.*s", (int)all, p->at);
  if (!nb_unit_respelt(ours, text))
    return false;
  snprintf(hint, sizeof hint, "write the unit as `%s`, or the power of a value as `(3 mm)^2`", ours);
  mistake(p, p->at, all, hint, "expected a unit or an operator, found `%s`", text);
  return true;
}

/* Reads the unit after a literal or a parenthesis. The unit may be missing; any other word is a mistake. */
static struct nb_unit unit_after(struct parser *p) {
  struct nb_unit unit;
  char text[WORD_SIZE];
  const char *const behind = p->at;
  peek(p);
  const bool glued = p->at == behind;
  size_t length = read_word(p, glued ? "_.%" : "_./%", text);
  if (length > 0 && length < sizeof text && text[length - 1] == '/')
    text[--length] = '\0'; /* this `/` divides: `1 m/(2*n)` */
  if (p->reader->bad || is_no_unit(text) || power_of_unit(p, length))
    return (struct nb_unit){.factor = 1};
  const bool is = nb_unit_read(&unit, text);
  if (is && !glued && (!p->reader->unitless || nb_unit_without_dimension(text)))
    return p->at += length, unit;
  wrong_unit(p, length, text, is);
  return (struct nb_unit){.factor = 1};
}

static struct quantity literal(struct parser *p) {
  char text[NB_LINE_MAX + 1];
  const char *const from = p->at;
  const size_t length = nb_number_length(from);
  double value = 0;
  snprintf(text, sizeof text, "%.*s", (int)length, from);
  p->at += length;
  const struct nb_unit unit = unit_after(p);
  const enum nb_reading reading = nb_quantity_read(&value, text, false, &unit);
  if (reading != NB_READ)
    return mistake(p, from, length, NULL, "expected %s, found `%.80s`", nb_reading_words(reading), text);
  return (struct quantity){value, unit.dimension};
}

/* Reads the expression after `(`, up to `)`. */
static struct quantity parenthesis(struct parser *p) {
  const struct quantity it = sum(p);
  return skip(p, ')') ? it : expected(p, "an operator or `)`");
}

/* The value of a function's argument that is a bare literal, or the name of one; 0 for any other argument. p.at is
 * behind the function's `(`. */
static double bare_argument(struct parser p) {
  const struct nb_reader *const reader = p.reader;
  char text[WORD_SIZE];
  double value;
  const bool minus = peek(&p) == '-';
  p.at += minus;
  const size_t digits = nb_number_length(p.at), length = digits ? digits : read_word(&p, "_", text);
  const int index = digits ? -1 : NB_FIND(reader->bindings, reader->binding_count, text);
  const struct nb_binding *const named = index < 0 ? NULL : &reader->bindings[index];
  if (named) /* the text of a number with a unit is no number */
    snprintf(text, sizeof text, "%s", named->computed ? "" : named->text);
  else
    snprintf(text, sizeof text, "%.*s", (int)digits, p.at);
  p.at += length;
  const bool bare = peek(&p) == ')' && nb_number_read(&value, text, 0) == NB_READ;
  return !bare ? 0 : minus ? -value : value;
}

/* Warns of `sin(20)`, in which 20 may be meant in degrees. Without units all angles are bare numbers. */
static void warn_of_angle(const struct parser *p, const struct function *f) {
  const struct nb_reader *const reader = p->reader;
  const bool of_angle = f->one == sin || f->one == cos || f->one == tan;
  const double value = of_angle && reader->warnings && !reader->unitless ? bare_argument(*p) : 0;
  if (value != 0)
    nb_warn(reader->warnings, (int)reader->line,
            "the argument of `%s()` has no unit, so it is in radians: write `%g deg` for degrees, or `%g rad`", f->name,
            value, value);
}

static struct quantity call(struct parser *p, const struct function *f, const char *from) {
  const size_t length = strlen(f->name);
  if (!skip(p, '('))
    return expected(p, "`(`");
  warn_of_angle(p, f);
  struct quantity a, b;
  if (f->two) {
    a = sum(p);
    if (!skip(p, ','))
      return expected(p, "`,` and a second value");
    b = parenthesis(p);
  } else {
    a = b = parenthesis(p);
  }
  char what[NB_NAME_SIZE];
  snprintf(what, sizeof what, "within `%s()`", f->name);
  if (f->rule == OF_NUMBERS ? !is_number(p, from, length, what, a) : !same_dimension(p, from, length, a, b))
    return a;
  const double fraction = f->rule == OF_ROOT ? 0.5 : f->rule == OF_RATIO ? 0 : 1;
  return checked_value(p, from, length, f->two ? f->two(a.value, b.value) : f->one(a.value), fraction * a.of.m,
                       fraction * a.of.kg, fraction * a.of.s);
}

const char *nb_arithmetic_hint(const struct nb_reader *reader) {
  if (reader->here == NB_IN_EXPECT)
    return "an expression has numbers and names of `let` and `sweep`, and no quantities; a ratio of two measures is "
           "`A.vx max expected 0.5 of B.vx max within 1 % [SOURCE]`, and a difference is part of a formula, `A.vx last "
           "expected (v + 3 m/s) within 1 % [SOURCE]`, with `let v = 1 m/s` in the scene";
  const char *statement = reader->count > 0 ? reader->tokens[0].text : "";
  if (strcmp(statement, "until") == 0)
    return "a condition compares one quantity, without arithmetic, with a number: `until D.vx below 0.1 m/s`";
  return strcmp(statement, "record") == 0
             ? "a quantity stands alone, without arithmetic: `record T.fy`; divide it in the figure, or compare it in "
               "a block `expect`"
             : NULL;
}

/* The hint for a word in place of an expression, `let law = linear`; NULL: the name is something else. */
static const char *word_hint(const struct nb_reader *reader, char *hint, const char *name) {
  const struct nb_token *const tokens = reader->tokens;
  snprintf(hint, NB_HINT_SIZE, "a value that is a word has no `=`: `let %.60s %.60s`",
           reader->count > 1 ? tokens[1].text : "", name);
  return reader->count == 4 && strcmp(tokens[0].text, "let") == 0 && strcmp(tokens[3].text, name) == 0 ? hint : NULL;
}

/* The hint for the time in an expectation, which is a number there; NULL: the name is no time. */
static const char *time_hint(const struct nb_reader *reader, const char *name) {
  const bool time = strcmp(name, "time") == 0 || strcmp(name, "t") == 0 || strcmp(name, "cycle") == 0;
  return time && reader->here == NB_IN_EXPECT
             ? "a line compares the value at one time: `A.vx at 0.1 s  expected (a*0.1 s) within 1 % [SOURCE]`, with "
               "`let a = 3 m/s2` in the scene; write a line for each time"
             : NULL;
}

/* Reads a function, pi, or a value named by `let` or `sweep`. */
static struct quantity named_value(struct parser *p) {
  char name[WORD_SIZE], hint[NB_HINT_SIZE];
  struct nb_unit unit;
  const char *const from = p->at;
  const size_t length = read_word(p, "_", name);
  struct nb_reader *reader = p->reader;
  const struct function *f = function_of(name);
  const struct nb_binding *const it = nb_use_binding(reader, name);
  p->at += length;
  if (f)
    return call(p, f, from);
  if (strcmp(name, "pi") == 0)
    return (struct quantity){NB_PI, {0, 0, 0}};
  if (it && !isnan(it->value))
    return (struct quantity){it->value, it->dimension};
  if (it)
    return mistake(p, from, length, NULL, "expected the name of a number, found `%s`, which stands for `%s`", name,
                   it->text);
  if (nb_name_suppressed(reader->mistakes, name))
    return nb_fail_silently(reader), (struct quantity){0};
  if (peek(p) == '(') {
    snprintf(hint, sizeof hint, "the functions are %s", nb_function_names);
    return mistake(p, from, length, hint, "expected the name of a function, found `%s`", name);
  }
  const char *near = nb_syntax_hint(reader, hint, name);
  near = near ? near : NB_NEAREST(hint, name, reader->bindings, reader->binding_count);
  if (!near && nb_unit_read(&unit, name))
    near = hint,
    snprintf(hint, sizeof hint,
             "a unit follows a number, without an operator: `2 mm`; or define `let %.40s = …` in the scene", name);
  near = near ? near : word_hint(reader, hint, name);
  near = near ? near : time_hint(reader, name);
  near = near ? near : nb_arithmetic_hint(reader);
  if (length >= NB_NAME_SIZE)
    mistake(p, from, length, near, "expected a name of at most %d characters, found `%.*s…`", NB_NAME_SIZE - 1,
            NB_NAME_SIZE - 1, name);
  else
    mistake(p, from, length, near, "expected a name that a `let` or `sweep` above defines, found `%s`", name);
  nb_suppress_name(reader->mistakes, name);
  return (struct quantity){0};
}

static struct quantity operand(struct parser *p) {
  const char c = peek(p), *const from = p->at;
  if (c && nb_number_length(from))
    return literal(p);
  if (!skip(p, '('))
    return isalpha((unsigned char)c) || c & 0x80 ? named_value(p) : expected(p, "a number, a name or `(`");
  const struct quantity it = parenthesis(p);
  const struct nb_unit unit = unit_after(p);
  return checked_value(p, from, (size_t)(p->at - from), nb_unit_to_si(it.value, &unit), it.of.m + unit.dimension.m,
                       it.of.kg + unit.dimension.kg, it.of.s + unit.dimension.s);
}

/* ---- operators ---- */

static struct quantity sign(struct parser *p);

static struct quantity power(struct parser *p) {
  const struct quantity base = operand(p);
  peek(p);
  const char *const from = p->at;
  if (!skip(p, '^'))
    return base;
  const struct quantity exponent = sign(p);
  if (!is_number(p, from, 1, "as an exponent", exponent))
    return base;
  const double n = exponent.value;
  return checked_value(p, from, 1, pow(base.value, n), n * base.of.m, n * base.of.kg, n * base.of.s);
}

static struct quantity sign(struct parser *p) {
  struct quantity it = {0};
  const bool minus = peek(p) == '-';
  if (++p->depth > DEPTH_MAX)
    mistake(p, p->at, 1, "define a part of it with `let`",
            "expected at most %d levels of parentheses and signs, found more", DEPTH_MAX);
  else
    it = skip(p, '-') || skip(p, '+') ? sign(p) : power(p);
  it.value = minus ? -it.value : it.value;
  p->depth--;
  return it;
}

static struct quantity product(struct parser *p) {
  struct quantity left = sign(p);
  for (char c; (c = peek(p)) == '*' || c == '/';) {
    const char *const from = p->at++;
    const struct quantity right = sign(p);
    const int times = c == '*' ? 1 : -1;
    left =
        checked_value(p, from, 1, c == '*' ? left.value * right.value : left.value / right.value,
                      left.of.m + times * right.of.m, left.of.kg + times * right.of.kg, left.of.s + times * right.of.s);
  }
  return left;
}

static struct quantity sum(struct parser *p) {
  struct quantity left = product(p);
  for (char c; (c = peek(p)) == '+' || c == '-';) {
    const char *const from = p->at++;
    const struct quantity right = product(p);
    if (same_dimension(p, from, 1, left, right))
      left = checked_value(p, from, 1, c == '+' ? left.value + right.value : left.value - right.value, left.of.m,
                           left.of.kg, left.of.s);
  }
  return left;
}

/* ---- literals and whole expressions ---- */

void nb_binding_write(struct nb_binding *value) {
  char number[32], unit[NB_NAME_SIZE];
  double back = NAN;
  for (int digits = 15; digits <= 17 && back != value->value; digits++) {
    snprintf(number, sizeof number, "%.*g", digits, value->value);
    nb_number_read(&back, number, 0);
  }
  nb_dimension_unit(unit, sizeof unit, value->dimension);
  snprintf(value->text, sizeof value->text, "%s%s%.30s", number, *unit ? " " : "", unit);
  value->computed = true;
}

bool nb_binding_same(const struct nb_binding *a, const struct nb_binding *b) {
  return a->value == b->value || strcmp(a->text, b->text) == 0;
}

enum nb_reading nb_literal(struct nb_binding *value, const char *number, const char *unit, bool computed) {
  struct nb_unit read = {.factor = 1};
  *value = (struct nb_binding){.value = NAN};
  if ((unit && !nb_unit_read(&read, unit)) || strlen(number) + (unit ? strlen(unit) : 0) + 2 > sizeof value->text)
    return NB_NO_NUMBER;
  const enum nb_reading reading = nb_quantity_read(&value->value, number, computed, &read);
  value->dimension = read.dimension;
  snprintf(value->text, sizeof value->text, "%s%s%s", number, unit ? " " : "", unit ? unit : "");
  if (reading == NB_READ && computed)
    nb_binding_write(value);
  return reading;
}

/* Reads an expression that is one literal: `-5`, `0.3 mm`; false if it is another expression. */
static bool read_plain_literal(const struct parser *p, struct nb_binding *value) {
  char number[NB_NAME_SIZE], unit[WORD_SIZE];
  const size_t minus = *p->at == '-' || *p->at == '+', length = minus + nb_number_length(p->at + minus);
  struct parser behind = *p;
  behind.at = p->at + length;
  if (length == minus || length >= sizeof number)
    return false;
  snprintf(number, sizeof number, "%.*s", (int)length, p->at);
  const bool bare = !peek(&behind);
  const size_t rest = read_word(&behind, "./%", unit), blanks = (size_t)(behind.at - p->at) - length;
  behind.at += rest;
  return (bare || (blanks && rest < sizeof unit && !peek(&behind) &&
                   (!p->reader->unitless || nb_unit_without_dimension(unit)))) &&
         nb_literal(value, number, bare ? NULL : unit, false) == NB_READ;
}

bool nb_expression(struct nb_reader *reader, const char *line, const char *at, const char *end,
                   struct nb_binding *value) {
  struct parser p = {reader, line, at, end, 0};
  peek(&p);
  if (reader->bad || read_plain_literal(&p, value))
    return !reader->bad;
  const struct quantity it = sum(&p);
  if (peek(&p))
    expected(&p, "an operator");
  *value = (struct nb_binding){.value = it.value, .dimension = it.of};
  nb_binding_write(value);
  return !reader->bad;
}
