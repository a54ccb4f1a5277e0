/* Reads the `expect` blocks of a page.
 *
 *   reference NAME
 *   report MEASURE
 *   MEASURE EXPECTATION
 *
 * Each kind of expectation is a row of a table. `nineball --help` and the manual are made from the same table.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "expect.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "input/expression.h"
#include "input/reader.h"
#include "reference.h"

/* ---- the measure: QUANTITY {REDUCER} {in STAGE} ---- */

static const struct nb_reducer_row reducers[] = {
    {"last", NB_LAST, "the last row; the default"},
    {"max", NB_MAX, "the largest value of the recorded rows"},
    {"min", NB_MIN, "the smallest value of the recorded rows"},
    {"mean", NB_MEAN, "the mean of all rows"},
    {"amplitude", NB_AMPLITUDE, "half the difference between the largest and the smallest value"},
    {"frequency", NB_FREQUENCY,
     "number of upward crossings of the mean, minus one, over the time from the first to the last of them, 1/s"},
    {"at N cycles", NB_AT_CYCLE,
     "the row of that cycle, counted from the start of the run; in a contact test `at N steps`"},
    {"at TIME", NB_AT_TIME, "the value at that time, interpolated linearly between two rows"},
    {"in all", NB_LAST, "in place of `in STAGE`: the rows of all stages"},
    {NULL, NB_LAST, NULL},
};

const struct nb_reducer_row *nb_reducer_rows(void) { return reducers; }

/* The hint for a reducer that does not follow its quantity: `max C.normal`, `C.normal.max`. NULL: the token has no
 * reducer. */
static const char *reducer_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                                const struct nb_token *token) {
  const struct nb_token *const next = nb_token_peek(reader);
  const char *const dot = strrchr(token->text, '.');
  struct nb_guess guess = nb_guess_begin(dot ? dot + 1 : token->text);
  char name[3 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  for (const struct nb_reducer_row *row = reducers; row->word; row++)
    nb_guess_offer(&guess, row->word);
  if (guess.distance > 0 || !(dot || next))
    return NULL;
  snprintf(name, sizeof name, "%.*s", dot ? (int)(dot - token->text) : NB_NAME_SIZE, dot ? token->text : next->text);
  if (nb_quantity_find(&quantity, scene, name))
    snprintf(hint, NB_HINT_SIZE, "write `%s %s`", name, guess.best);
  else if (!dot) { /* `max normal` may be `M.normal.max` */
    nb_append(name, sizeof name, ".%s", guess.best), nb_quantity_hint(hint, scene, name);
    if (!strstr(hint, name + strcspn(name, ".")))
      snprintf(hint, NB_HINT_SIZE, "write the quantity before `%s`: `C.normal %s`", guess.best, guess.best);
  }
  return dot && !quantity.kind ? NULL : hint;
}

/* The hint for a magnitude, `abs(C.shear)`; NULL: the text is not a magnitude. */
static const char *magnitude_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const char *const from = strncmp(text, "abs(", 4) == 0 ? text + 4 : *text == '|' ? text + 1 : "";
  char name[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  snprintf(name, sizeof name, "%.*s", (int)strcspn(from, ")|"), from);
  snprintf(hint, NB_HINT_SIZE, "a magnitude below X is two lines: `%s max below X` and `%s min above -X`", name, name);
  return nb_quantity_find(&quantity, scene, name) ? hint : NULL;
}

/* The unit as a hint writes it after a number: "" for a number without a unit. */
static const char *shown_unit(const struct nb_reader *reader, const char *unit) {
  return reader->unitless || strcmp(unit, "1") == 0 ? "" : unit;
}

static bool begins_expectation(const char *word) {
  const struct nb_expectation_row *row = nb_expectation_rows();
  while (row->word && strcmp(row->word, word) != 0)
    row++;
  return row->word;
}

/* True if two quantities have different dimensions; false if one of the words is no quantity. */
static bool dimensions_differ(const struct nb_scene *scene, const char *one, const char *other) {
  struct nb_quantity a, b;
  struct nb_unit unit_a, unit_b;
  return !scene->unitless && nb_quantity_find(&a, scene, one) && nb_quantity_find(&b, scene, other) &&
         nb_unit_read(&unit_a, nb_quantity_unit(a)) && nb_unit_read(&unit_b, nb_quantity_unit(b)) &&
         !nb_dimension_same(unit_a.dimension, unit_b.dimension);
}

/* Writes the hint for a ratio, or a difference, of the measures `one` and `other`; `number` is a value of the ratio,
 * `unit` the unit of a difference. */
static const char *arithmetic_hint(char *hint, char sign, const char *one, const char *other, const char *number,
                                   const char *unit) {
  const bool difference = sign == '-' || sign == '+';
  snprintf(hint, NB_HINT_SIZE, "a line has no arithmetic with measures; ");
  if (difference)
    nb_append(hint, NB_HINT_SIZE,
              "compare the first one with a formula, `%.120s expected (%s) within 1 %% [SOURCE]`, with the second one, "
              "`let b = "
              "1%s%s`, and the %s, `let d = 3%s%s`, in the scene; or with ",
              one, sign == '-' ? "b + d" : "d - b", *unit ? " " : "", unit, sign == '-' ? "difference" : "sum",
              *unit ? " " : "", unit);
  nb_append(hint, NB_HINT_SIZE, "%s the second measure: `%.120s expected %s of %.120s within 1 %% [SOURCE]`",
            difference ? "a multiple of" : "a ratio is a fraction of", one, number, other);
  return hint;
}

/* Writes the hint for arithmetic with measures, `A.x max / B.x max`: `label` is the first measure, `first` the first
 * word of the second one. The next tokens of the line are the other words of the second measure. */
static const char *ratio_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene, char sign,
                              const char *label, const char *first) {
  char other[4 * NB_NAME_SIZE];
  const struct nb_token *const next = nb_token_peek(reader);
  struct nb_quantity quantity;
  if (dimensions_differ(scene, reader->tokens[0].text, *first || !next ? first : next->text))
    return strcpy(hint, NB_OTHER_DIMENSION);
  snprintf(other, sizeof other, "%s", first);
  for (size_t k = reader->next; k < reader->count && !begins_expectation(reader->tokens[k].text); k++)
    nb_append(other, sizeof other, "%s%s", *other ? " " : "",
              strcmp(reader->tokens[k].text, "first") ? reader->tokens[k].text : "at 0 cycles");
  return arithmetic_hint(
      hint, sign, label, *other ? other : "MEASURE", "0.5",
      nb_quantity_find(&quantity, scene, reader->tokens[0].text) ? shown_unit(reader, nb_quantity_unit(quantity)) : "");
}

/* The hint for arithmetic without spaces, `A.vx/A.vy`, and for a function of it, `atan2(A.vx, A.vy)`; NULL: the text is
 * neither. */
static const char *quotient_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                                 const char *text) {
  const char *const from = strchr(text, '(') ? strchr(text, '(') + 1 : text;
  const size_t length = strcspn(from, "/,-+");
  const char *const second = from + length + 1 + (from[length] && from[length + 1] == ' ');
  char one[2 * NB_NAME_SIZE], other[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  snprintf(one, sizeof one, "%.*s", (int)length, from);
  if (!from[length] || !nb_quantity_find(&quantity, scene, one))
    return NULL;
  snprintf(other, sizeof other, "%.*s", (int)strcspn(second, ")"), second);
  return dimensions_differ(scene, one, other) ? strcpy(hint, NB_OTHER_DIMENSION)
         : nb_quantity_find(&quantity, scene, other)
             ? arithmetic_hint(hint, from[length], one, other, strncmp(text, "atan", 4) == 0 ? "(tan(pi/9))" : "0.5",
                               shown_unit(reader, nb_quantity_unit(quantity)))
             : NULL;
}

/* The hint for a formula in place of a quantity, `sqrt(A.vx^2+A.vy^2)`; NULL: the text is no formula with a
 * quantity. The text does not begin with a parenthesis, because the reader takes that for an expression. */
static const char *formula_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                                const char *text) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
  char name[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  snprintf(name, sizeof name, "%.*s", (int)strcspn(text, "("), text);
  if (!strpbrk(text, "*^") && !nb_name_reserved(name))
    return NULL;
  for (size_t n; *(text += strcspn(text, letters)); text += n) {
    n = strspn(text, letters);
    snprintf(name, sizeof name, "%.*s", (int)n, text);
    if (!nb_quantity_find(&quantity, scene, name))
      continue;
    const char *const unit = shown_unit(reader, nb_quantity_unit(quantity));
    snprintf(
        hint, NB_HINT_SIZE,
        "the left side is one recorded quantity, and a formula stands on the right side, after `expected`: `%s last  "
        "expected (2*a) within 1 %% [SOURCE]`, with `let a = 1%s%s` in the scene",
        name, *unit ? " " : "", unit);
    return hint;
  }
  return NULL;
}

/* The hint for arithmetic or a function in place of a quantity; NULL: the text is neither. */
static const char *expression_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                                   const char *text) {
  return magnitude_hint(hint, scene, text) || quotient_hint(hint, reader, scene, text) ||
                 formula_hint(hint, reader, scene, text)
             ? hint
             : NULL;
}

/* Finds the column of the scene's table that the token names, and its quantity. */
static bool find_column(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_token *token,
                        size_t *column, struct nb_quantity *quantity) {
  for (size_t c = 0; c < scene->column_count; c++)
    if (strcmp(scene->columns[c].name, token->text) == 0) {
      *column = c, *quantity = scene->columns[c].quantity;
      return true;
    }
  char hint[NB_HINT_SIZE];
  double number;
  const bool known = nb_quantity_find(quantity, scene, token->text);
  if (nb_name_suppressed(reader->mistakes, token->text) || (known && nb_name_suppressed(reader->mistakes, "record")))
    return nb_fail_silently(reader);
  if (known) { /* the line `record` corrects all lines; an unknown name must be corrected in each line */
    nb_suppress_name(reader->mistakes, token->text);
    snprintf(hint, sizeof hint, "add `record %s` to the %s%s", token->text,
             scene->contact_test ? "contact test" : "scene",
             strcmp(quantity->kind->name, "angle") == 0 ? "; this angle is the rotation since the start; a velocity at "
                                                          "20 degrees, pi/9, from the y axis is `A.vx last  expected "
                                                          "(tan(pi/9)) of A.vy last within 1 % [SOURCE]`"
                                                        : "");
  } else if (nb_number_read(&number, token->text, 0) != NB_NO_NUMBER)
    snprintf(hint, sizeof hint,
             "the quantity comes first, and then `expected NUMBER within TOLERANCE [SOURCE]`, `below NUMBER` or `above "
             "NUMBER`");
  else if (!expression_hint(hint, reader, scene, token->text) &&
           !nb_phrase_hint(hint, scene, token, reader->count - (size_t)(token - reader->tokens)) &&
           !nb_pair_hint(hint, "expect", token->text) && !reducer_hint(hint, reader, scene, token))
    nb_quantity_hint(hint, scene, token->text);
  return nb_token_mistake(reader, token, hint, "expected a quantity that the page records, found `%s`", token->text);
}

/* The hint for an unknown stage. For `rest/A.x` it is the hint for a ratio. */
static const char *stage_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                              const char *label, const char *text) {
  const char *const slash = strchr(text, '/');
  char measure[4 * NB_NAME_SIZE];
  snprintf(measure, sizeof measure, "%.120s in %.*s", label, slash ? (int)(slash - text) : 0, text);
  return slash && slash[1] ? ratio_hint(hint, reader, scene, '/', measure, slash + 1)
                           : NB_NEAREST(hint, text, scene->stages, scene->stage_count);
}

/* Takes the optional words `in STAGE`. */
static bool take_stage(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  char hint[NB_HINT_SIZE];
  measure->bare_length = strlen(measure->label);
  if (!nb_token_skip(reader, "in"))
    return true;
  const char *const what = scene->contact_test ? "the name of a segment" : "the name of a stage";
  const struct nb_token *token = nb_take_token(reader, what);
  if (!token)
    return false;
  measure->stage = NB_FIND(scene->stages, scene->stage_count, token->text);
  if (measure->stage < 0 && strcmp(token->text, "all") == 0)
    measure->stage = NB_STAGE_ALL;
  if (measure->stage == -1)
    return nb_name_suppressed(reader->mistakes, "repeat")
               ? nb_fail_silently(reader)
               : nb_unknown_name(reader, token, stage_hint(hint, reader, scene, measure->label, token->text), what);
  nb_append(measure->label, sizeof measure->label, " in %s", token->text);
  return true;
}

/* Takes the value after `at`: a number of cycles, a number of steps in a contact test, or a time. */
static bool take_time(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  const char *const words[] = {scene->contact_test ? "steps" : "cycles", scene->contact_test ? "step" : "cycle"};
  const struct nb_token *number = nb_token_peek(reader);
  const bool is_count = reader->next + 1 < reader->count &&
                        (strcmp(number[1].text, words[0]) == 0 || strcmp(number[1].text, words[1]) == 0);
  if (scene->contact_test && !is_count)
    return nb_expected(reader, "a contact test has no time: `at 10 steps`", "a number and `steps`");
  if (is_count) {
    unsigned long count;
    if (!nb_take_count(reader, 0, NB_COUNT_MAX, &count))
      return false;
    reader->next++;
    measure->reducer = NB_AT_CYCLE;
    if (!nb_refined_is_whole((double)count * scene->refine, &measure->at))
      return nb_token_mistake(reader, number, "choose another number for `refine`",
                              "expected a whole number of %s with --set refine=%.12g, found %.12g", words[0],
                              scene->refine, (double)count * scene->refine);
    nb_append(measure->label, sizeof measure->label, " at %lu %s", count, words[0]);
    return true;
  }
  if (nb_token_is(reader, "end"))
    reader->otherwise = "the last row is the default: write nothing, or `last`";
  if (!nb_take_time_at(reader, &measure->at))
    return false;
  measure->reducer = NB_AT_TIME;
  nb_append(measure->label, sizeof measure->label, reader->unitless ? " at %g" : " at %g s", measure->at);
  return true;
}

static bool take_measure(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  const struct nb_token *token = nb_take_token(reader, "a quantity that the page records");
  const struct nb_reducer_row *row = reducers;
  *measure = (struct nb_measure){.stage = -1};
  struct nb_quantity quantity;
  if (!token || !find_column(reader, scene, token, &measure->column, &quantity))
    return false;
  snprintf(measure->label, sizeof measure->label, "%s", token->text);
  while (row->word && !nb_token_skip(reader, row->word))
    row++;
  measure->reducer = row->reducer; /* NB_LAST if no word matches */
  if (measure->reducer != NB_LAST)
    nb_append(measure->label, sizeof measure->label, " %s", row->word);
  measure->unit = measure->reducer == NB_FREQUENCY ? "1/s" : nb_quantity_unit(quantity);
  measure->is_residual = nb_quantity_is_residual(quantity);
  measure->bounds = measure->reducer == NB_AMPLITUDE || measure->reducer == NB_FREQUENCY ? NB_AT_LEAST_0
                                                                                         : nb_quantity_bounds(quantity);
  if (!row->word && nb_token_skip(reader, "at"))
    return take_time(reader, scene, measure) && take_stage(reader, scene, measure);
  return take_stage(reader, scene, measure);
}

/* The reducer of a measure with the dimension of the one that begins the line. A frequency has another dimension than
 * its quantity. */
static const char *scale_reducer(const struct nb_reader *reader) {
  return strcmp(reader->tokens[1].text, "frequency") == 0 ? "frequency" : "max";
}

/* True if token k is a reducer without a quantity, `max` of `within 1e-6 of max`, or `peak`. */
static bool is_bare_reducer(const struct nb_reader *reader, size_t k) {
  const char *const word = k < reader->count ? reader->tokens[k].text : "";
  const char *const after = k + 1 < reader->count ? reader->tokens[k + 1].text : "[";
  const struct nb_reducer_row *row = reducers;
  while (row->word && strcmp(row->word, word) != 0)
    row++;
  return (row->word || strcmp(word, "peak") == 0 || strcmp(word, "maximum") == 0) &&
         (*after == '[' || strcmp(after, "within") == 0);
}

/* Takes a measure that is compared with a measure in `unit`. Both must have the same dimension, unless the page has
 * `units none`. */
static bool take_measure_like(struct nb_reader *reader, const struct nb_scene *scene, const char *unit,
                              struct nb_measure *measure) {
  const struct nb_token *token = nb_token_peek(reader);
  struct nb_unit wanted = {0}, found = {0};
  char wanted_words[NB_NAME_SIZE], found_words[NB_NAME_SIZE], hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint, "name the quantity of this value: `%.80s %s in all`", reader->tokens[0].text,
           scale_reducer(reader));
  if (is_bare_reducer(reader, reader->next))
    return nb_expected(reader, hint, "a quantity that the page records");
  if (!take_measure(reader, scene, measure))
    return false;
  nb_unit_read(&wanted, unit), nb_unit_read(&found, measure->unit);
  if (reader->unitless || nb_dimension_same(wanted.dimension, found.dimension))
    return true;
  nb_dimension_words(wanted_words, sizeof wanted_words, wanted.dimension);
  nb_dimension_words(found_words, sizeof found_words, found.dimension);
  return nb_token_mistake(reader, token, NULL, "expected %s, found `%s`, which is %s",
                          strcmp(unit, "1") == 0 ? "a quantity without a unit" : wanted_words, measure->label,
                          found_words);
}

/* ---- tolerances ---- */

/* The quantity that a hint proposes as the scale of a tolerance. It has the dimension of the measure that begins the
 * line: the kinetic energy for an energy of a scene, otherwise the quantity of the measure. */
static const char *scale_name(const struct nb_reader *reader, const struct nb_scene *scene, const char *unit) {
  return strcmp(unit, "J") == 0 && !scene->contact_test ? "energy.kinetic" : reader->tokens[0].text;
}

/* What a hint says about the scale of a tolerance that the page does not record. */
static const char *scale_note(const struct nb_scene *scene, const char *scale) {
  for (size_t c = 0; c < scene->column_count; c++)
    if (strcmp(scene->columns[c].name, scale) == 0)
      return "";
  return ", with `record energy.kinetic` in the scene";
}

/* Reports a mistyped `peak`, which may stand in place of a measure. No quantity has a name near it. */
static bool is_no_peak(struct nb_reader *reader) {
  char hint[NB_HINT_SIZE];
  const struct nb_token *const token = nb_token_peek(reader);
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  nb_guess_offer(&guess, "peak");
  return token && nb_guess_found(&guess) &&
         !nb_expected(reader, nb_guess_hint(&guess, hint), "a quantity that the page records, or `peak`");
}

/* Takes a fraction: `0.1 %`, `0.5 % of peak`, `1e-9 of energy.kinetic max`; the last two only if `scene` is not
 * NULL. */
static bool take_fraction(struct nb_reader *reader, const struct nb_scene *scene, const char *unit,
                          struct nb_tolerance *tolerance) {
  tolerance->kind = NB_RELATIVE;
  if (!nb_take_number(reader, NB_UNIT_NUMBER, NB_NOT_NEGATIVE, &tolerance->value))
    return false;
  if (!scene || !nb_token_skip(reader, "of"))
    return true;
  tolerance->kind = nb_token_skip(reader, "peak") ? NB_OF_PEAK : NB_OF_MEASURE;
  return tolerance->kind == NB_OF_PEAK ||
         (!is_no_peak(reader) && take_measure_like(reader, scene, unit, &tolerance->of));
}

/* True if the token after the next one is this word. */
static bool is_before(const struct nb_reader *reader, const char *word) {
  return reader->next + 1 < reader->count && strcmp(reader->tokens[reader->next + 1].text, word) == 0;
}

/* Takes `within` and a fraction, or `within` and a number in the unit of the measure: `within 2 nm`, `within 1e-12`.
 * `zero`: the reference is 0, so messages do not propose a percentage. */
static bool take_tolerance(struct nb_reader *reader, const struct nb_scene *scene, const char *unit, bool zero,
                           struct nb_tolerance *tolerance) {
  if (!nb_token_peek(reader)) {
    char hint[NB_HINT_SIZE];
    const char *const shown = shown_unit(reader, unit);
    snprintf(hint, sizeof hint, "a tolerance is a percentage, `within 1 %%`, or a number%s, `within 2%s%s`",
             *shown ? " with its unit" : "", *shown ? " " : "", shown);
    return nb_expected(reader, hint, "`within`");
  }
  if (!nb_take_word(reader, "within"))
    return false;
  const size_t from = reader->next;
  const bool fraction = is_before(reader, "%") || is_before(reader, "ppm") || (scene && is_before(reader, "of"));
  tolerance->kind = NB_ABSOLUTE;
  if (!(fraction ? take_fraction(reader, scene, unit, tolerance)
                 : nb_take_tolerance(reader, unit, !zero, &tolerance->value)))
    return false;
  for (size_t k = from; k < reader->next; k++)
    nb_append(tolerance->text, sizeof tolerance->text, "%s%s", k > from ? " " : "", reader->tokens[k].text);
  return tolerance->value >= 0 || nb_token_mistake(reader, &reader->tokens[from], NULL,
                                                   "expected a tolerance of 0 or more, found `%s`", tolerance->text);
}

/* Takes a tolerance. `zero`: the reference is 0; a percentage is then a mistake, because it would allow no error. */
static bool take_tolerance_of(struct nb_reader *reader, const struct nb_scene *scene, const char *unit, bool zero,
                              struct nb_tolerance *tolerance) {
  const size_t at = reader->next + 1;
  char hint[NB_HINT_SIZE] = "give a number, `within 1e-6`";
  if (!take_tolerance(reader, scene, unit, zero, tolerance))
    return false;
  if (strcmp(unit, "1") != 0) {
    const char *const scale = scale_name(reader, scene, unit), *const reducer = reader->tokens[1].text;
    /* the largest value of the quantity would be the measure itself, a frequency has no other scale */
    const bool own = strcmp(scale, reader->tokens[0].text) == 0 &&
                     (strcmp(reducer, "max") == 0 || strcmp(reducer, "frequency") == 0);
    snprintf(hint, sizeof hint, "give a number%s, `within 1e-6%s%s`", reader->unitless ? "" : " with its unit",
             reader->unitless ? "" : " ", shown_unit(reader, unit));
    if (!own)
      nb_append(hint, sizeof hint, ", or a fraction of a measure, `within 1 %% of %.80s max`%s", scale,
                scale_note(scene, scale));
  }
  return !zero || (tolerance->kind != NB_RELATIVE && tolerance->kind != NB_OF_PEAK) ||
         nb_token_mistake(reader, &reader->tokens[at], hint,
                          "expected an absolute tolerance, because the reference value is 0, found `%s`",
                          tolerance->text);
}

/* ---- the expectation ---- */

/* The first swept name of the page; NULL: there is none. */
static const struct nb_binding *first_sweep(const struct nb_scene *scene) {
  size_t k = 0;
  while (k < scene->binding_count && scene->bindings[k].sweep < 0)
    k++;
  return k < scene->binding_count ? &scene->bindings[k] : NULL;
}

/* The swept name that the expectation names, or else the first one of the page; NULL: there is none. */
static const struct nb_binding *swept_by(const struct nb_scene *scene, const struct nb_expectation *expectation) {
  const int k = NB_FIND(scene->bindings, scene->binding_count, expectation->against);
  return k < 0 ? first_sweep(scene) : &scene->bindings[k];
}

/* Writes the hint for a trend: the lines for an increase and for a power law, with the first sweep of the page. */
static const char *trend_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                              const struct nb_measure *measure) {
  const struct nb_binding *const swept = first_sweep(scene);
  const char *const name = swept ? swept->name : "k", *const unit = shown_unit(reader, measure->unit);
  *hint = '\0';
  nb_append(hint, NB_HINT_SIZE,
            "write `%.120s increases with %s`, or `decreases`; a power law is a formula, `%.120s expected "
            "(c*(%s/k0)^0.5) within 1 %% [SOURCE]`, with %s`let c = 3%s%s` and `let k0 = %s` in the scene",
            measure->label, name, measure->label, name, swept ? "" : "`sweep k 1 2 4`, ", *unit ? " " : "", unit,
            swept ? swept->text : "1");
  return hint;
}

static bool take_sweep_name(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_measure *measure,
                            char name[2 * NB_NAME_SIZE]) {
  static const char what[] = "the name of a `sweep`";
  const struct nb_token *token = nb_take_token(reader, what);
  char hint[NB_HINT_SIZE];
  const int k =
      NB_NAMED(reader, token, scene->bindings, scene->binding_count, what,
               token && strcmp(token->text, "step") == 0
                   ? "a step that is swept has a name: `sweep dt 1 us 2 us 4 us` and `step $dt` in the scene, then `dt`"
               : token && strpbrk(token->text, "^*/") ? trend_hint(hint, reader, scene, measure)
                                                      : "define it with `sweep NAME VALUE …`");
  if (k < 0)
    return false;
  snprintf(name, 2 * NB_NAME_SIZE, "%s", token->text);
  return scene->bindings[k].sweep >= 0 ||
         nb_expected_at(reader, token, "a `let` gives this name one value; a `sweep` gives several values", what);
}

/* Takes the optional words `over NAME`: the sweep whose runs are a sample. */
static bool take_sample(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  return !nb_token_skip(reader, "over") || take_sweep_name(reader, scene, &expectation->measure, expectation->sample);
}

static const char source_hint[] = "say where the number comes from, for example `[CS79 figure 6]` or `[a guess]`";

/* Takes a source such as `[CS79 figure 6]`, which may be several tokens. */
static bool take_source(struct nb_reader *reader) {
  const struct nb_token *token = nb_token_peek(reader);
  if (!token || token->text[0] != '[')
    return nb_expected(reader, source_hint, "the source in brackets");
  if (strcmp(token->text, "[]") == 0)
    return nb_expected(reader, source_hint, "a source between the brackets");
  while ((token = nb_token_peek(reader))) {
    reader->next++;
    if (token->text[strlen(token->text) - 1] == ']')
      return true;
  }
  return nb_expected(reader, NULL, "a closing bracket `]`");
}

static bool take_within(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const struct nb_measure *measure = &expectation->measure;
  return take_tolerance_of(reader, scene, measure->unit, measure->is_residual, &expectation->tolerance);
}

/* Appends how to compare a number with a quantity, in place of its curve. */
static void append_value(char *hint, const struct nb_measure *measure) {
  nb_append(hint, NB_HINT_SIZE,
            "; a number or a formula is compared with one value, such as `%.*s last%s expected (FORMULA) within 1 %% "
            "[SOURCE]`",
            (int)measure->bare_length, measure->label, measure->label + measure->bare_length);
}

/* Writes the hint for `versus mu` and for `for mu=0.5`, which is `without`: a line is checked in each run of a sweep. */
static const char *each_run_hint(char *hint, const char *without, const char *measure, const char *name) {
  *hint = '\0';
  nb_append(
      hint, NB_HINT_SIZE,
      "every line is checked in each run of a sweep, so it has no `%s`: write for example `%.100s expected "
      "(FORMULA) within 1 %% [SOURCE]`, or compare the runs by `%.100s increases with %s`. If each run has its own "
      "number, write it in the sweep, `sweep %s with p …`, and compare with `expected $p`",
      without, measure, measure, name, name);
  return hint;
}

/* True if `with` follows this word: `increases with mu`. */
static bool is_trend_word(const char *word) {
  return strcmp(word, "increases") == 0 || strcmp(word, "decreases") == 0 || strcmp(word, "constant") == 0;
}

/* Refuses `for mu=0.5` or `with mu = 0.5` in any place of the line; false: the line names no value of a sweep. */
static bool one_run_mistake(struct nb_reader *reader, const struct nb_scene *scene) {
  static const char *const words[] = {"for", "if", "where", "when", "with", "at"};
  char name[NB_NAME_SIZE], without[2 * NB_NAME_SIZE], hint[NB_HINT_SIZE];
  for (size_t k = 1; k + 1 < reader->count; k++)
    for (size_t w = 0; w < sizeof words / sizeof *words; w++) {
      const struct nb_token *const token = &reader->tokens[k];
      const char *const after = k + 2 < reader->count ? token[2].text : "";
      const size_t length = strcspn(token[1].text, "=");
      const bool equals = token[1].text[length], value = *after == '=' || nb_number_length(after);
      snprintf(name, sizeof name, "%.*s", (int)(length < NB_NAME_SIZE ? length : 0), token[1].text);
      const int b = NB_FIND(scene->bindings, scene->binding_count, name);
      if (strcmp(token->text, words[w]) != 0 || b < 0 || scene->bindings[b].sweep < 0 || !(equals || value) ||
          is_trend_word(token[-1].text))
        continue;
      snprintf(without, sizeof without, "%.40s %.60s%s", token->text, token[1].text, equals ? "" : " …");
      each_run_hint(hint, without, reader->tokens[0].text, name);
      return !nb_token_mistake(reader, token, hint, "expected a line for all runs of the sweep, found `%.80s`",
                               token->text);
    }
  return false;
}

/* Reports `versus` and the name of a sweep; false: the token is another. */
static bool is_versus_sweep(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_measure *measure,
                            const struct nb_token *token) {
  const int k = NB_FIND(scene->bindings, scene->binding_count, token->text);
  char hint[NB_HINT_SIZE], without[2 * NB_NAME_SIZE];
  if (k < 0 || scene->bindings[k].sweep < 0)
    return false;
  snprintf(without, sizeof without, "versus %.40s", token->text);
  each_run_hint(hint, without, measure->label, token->text);
  nb_token_mistake(reader, token, hint, "expected a quantity that the page records, found `%s`, the name of a sweep",
                   token->text);
  return true;
}

/* Refuses a reducer or a stage before `versus`. */
static bool is_no_curve(struct nb_reader *reader, const struct nb_measure *measure, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  if (strcmp(reader->tokens[1].text, "versus") == 0)
    return false;
  snprintf(hint, sizeof hint,
           "a curve is compared at every row, so it has no reducer, and its stage comes last: `%.80s versus %.80s%s`",
           reader->tokens[0].text, token->text, measure->label + measure->bare_length);
  nb_token_mistake(reader, &reader->tokens[1], hint, "expected `versus`, found `%s`", reader->tokens[1].text);
  return true;
}

/* Appends how the curve is drawn, without a comparison. */
static void append_plot(char *hint, const struct nb_scene *scene, const struct nb_expectation *e) {
  const struct nb_column *const x = &scene->columns[e->column], *const y = &scene->columns[e->measure.column];
  const struct nb_column *const columns[] = {x, y};
  nb_append(hint, NB_HINT_SIZE, "; to draw it write a block `gnuplot` with `plot %s using",
            first_sweep(scene) ? "for [i=1:runs] sprintf('$table_%d', i)" : "$table");
  for (size_t k = 0; k < 2; k++) {
    const char *const unit = nb_quantity_unit(columns[k]->quantity);
    nb_append(hint, NB_HINT_SIZE, "%s'%s/%s'", k ? ":" : " ", columns[k]->name,
              scene->unitless || strcmp(unit, "1") == 0 ? "-" : unit);
  }
  nb_append(hint, NB_HINT_SIZE, " with lines`");
}

static bool take_versus(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const struct nb_token *token = nb_take_token(reader, "a quantity that the page records");
  struct nb_quantity quantity;
  if (!token || is_versus_sweep(reader, scene, &expectation->measure, token) ||
      !find_column(reader, scene, token, &expectation->column, &quantity) ||
      is_no_curve(reader, &expectation->measure, token))
    return false;
  snprintf(expectation->against, sizeof expectation->against, "%s", token->text);
  if (!take_stage(reader, scene, &expectation->measure))
    return false;
  char hint[NB_HINT_SIZE] = "a curve is compared only with that of a `reference`";
  if (!nb_token_peek(reader)) {
    nb_append(hint, sizeof hint, ", by `within 1 %% of peak`");
    append_plot(hint, scene, expectation);
    return nb_expected(reader, hint, "`within`");
  }
  append_value(hint, &expectation->measure);
  if (nb_token_is(reader, "expected") || nb_token_is(reader, "above") || nb_token_is(reader, "below"))
    return nb_token_mistake(reader, nb_token_peek(reader), hint, "expected `within`, found `%s`",
                            nb_token_peek(reader)->text);
  return take_tolerance(reader, scene, expectation->measure.unit, false, &expectation->tolerance);
}

/* True, with a message, if the expectation can never hold or can never fail, because of the bounds of the quantity. */
static bool is_decided(struct nb_reader *reader, const struct nb_token *token, const struct nb_expectation *e) {
  const double least = e->measure.bounds & NB_AT_LEAST_0 ? 0 : -INFINITY;
  const double most = e->measure.bounds & NB_AT_MOST_1 ? 1 : INFINITY;
  const double allowed = e->tolerance.value * (e->tolerance.kind == NB_ABSOLUTE ? 1 : fabs(e->number));
  const double from = e->number - allowed, to = e->number + allowed;
  char hint[NB_HINT_SIZE];
  if (e->has_scale || e->sample[0] || e->tolerance.kind == NB_OF_MEASURE ||
      (to >= least && from <= most && (from > least || to < most)))
    return false;
  const bool never = to < least || from > most;
  snprintf(hint, sizeof hint,
           never ? "`%s` is never %s"
                 : "`%s` is from 0 to 1, so every value is within the tolerance: write a smaller tolerance",
           e->measure.label, to < least ? "below 0" : "above 1");
  nb_token_mistake(reader, token, hint, "expected an expectation that can %s, found `%s`", never ? "hold" : "fail",
                   token->text);
  return true;
}

/* Appends the tokens from number `from` up to the source, or up to number `end` if there is no source before it;
 * `first` of other programs becomes `at 0 cycles`. */
static void append_words(char *hint, const struct nb_reader *reader, size_t from, size_t end) {
  for (size_t k = from; k < end && reader->tokens[k].text[0] != '['; k++)
    nb_append(hint, NB_HINT_SIZE, " %s",
              strcmp(reader->tokens[k].text, "first") ? reader->tokens[k].text : "at 0 cycles");
}

/* Refuses `expected 0.5 * A.x max` and `expected A.x max`; the words of the other measure begin at `from`. */
static bool multiple_mistake(struct nb_reader *reader, const struct nb_measure *measure, const char *number,
                             size_t from, const char *what) {
  char hint[NB_HINT_SIZE];
  bool tolerance = false;
  for (size_t k = from; k < reader->count; k++)
    tolerance = tolerance || strcmp(reader->tokens[k].text, "within") == 0;
  snprintf(hint, sizeof hint, "a multiple of another measure has the word `of`: write `%s expected %.40s of",
           measure->label, number);
  append_words(hint, reader, from, reader->count);
  nb_append(hint, sizeof hint, "%s [SOURCE]`", tolerance ? "" : " within 1 %");
  return nb_expected(reader, hint, "%s", what);
}

/* Refuses `expected 15 %` without `of`. */
static bool percentage_mistake(struct nb_reader *reader, const struct nb_measure *measure, double fraction) {
  char hint[NB_HINT_SIZE];
  if (measure->bounds & NB_COUNTED)
    nb_count_hint(hint, reader->tokens[0].text, fraction);
  else if (strcmp(measure->unit, "1") == 0)
    snprintf(hint, sizeof hint,
             "a percentage is a fraction of another measure; a value of `%.80s` is a number without `%%`: write "
             "`expected %.6g`",
             measure->label, fraction);
  else
    snprintf(hint, sizeof hint, "a fraction of another quantity: `%.6g %% of %.80s max`", 100 * fraction,
             reader->tokens[0].text);
  return nb_expected(reader, hint, "`of` and a quantity");
}

/* Takes the other measure of a comparison. Refuses the measure itself, because then the numbers alone decide. */
static bool take_other_measure(struct nb_reader *reader, const struct nb_scene *scene,
                               struct nb_expectation *expectation) {
  const struct nb_token *const token = nb_token_peek(reader);
  if (!take_measure_like(reader, scene, expectation->measure.unit, &expectation->other))
    return false;
  return strcmp(expectation->other.label, expectation->measure.label) != 0 ||
         nb_token_mistake(reader, token, "the result would not depend on the run",
                          "expected another measure than `%s` itself", expectation->measure.label);
}

static bool take_expected(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const char *unit = expectation->measure.unit;
  const struct nb_token *const token = nb_token_peek(reader);
  struct nb_quantity quantity;
  char hint[NB_HINT_SIZE];
  if (token && nb_quantity_find(&quantity, scene, token->text))
    return multiple_mistake(reader, &expectation->measure, "1", reader->next, "a number, or `NUMBER of MEASURE`");
  expectation->has_scale = is_before(reader, "of") || is_before(reader, "%");
  if (expectation->has_scale) {
    unit = "1";
    if (!nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &expectation->number))
      return false;
    if (!nb_token_skip(reader, "of"))
      return percentage_mistake(reader, &expectation->measure, expectation->number);
    if (!take_other_measure(reader, scene, expectation))
      return false;
  } else if (is_before(reader, "*")) {
    reader->next++;
    return multiple_mistake(reader, &expectation->measure, token->text, reader->next + 1, "`of` and a measure");
  } else if (!nb_take_in_unit(reader, unit, &expectation->number)) {
    return false;
  } else if (nb_token_is(reader, "of")) {
    snprintf(hint, sizeof hint, "a number before `of` has no unit: `expected %.40s of`", token->text);
    return nb_expected(reader, hint, "`within`");
  }
  return take_sample(reader, scene, expectation) &&
         (expectation->sample[0] ||
          take_tolerance_of(reader, scene, unit, expectation->number == 0, &expectation->tolerance)) &&
         !is_decided(reader, token, expectation) && take_source(reader);
}

/* Refuses `below 0.1 % of MEASURE` and `below 1e-6 of MEASURE`, and proposes `expected 0 J within 0.1 % of MEASURE
 * [SOURCE]`. Without a measure, `below 1e-6 of max`, it proposes the largest value of the quantity. */
static bool fraction_mistake(struct nb_reader *reader, const struct nb_scene *scene,
                             const struct nb_expectation *expectation) {
  const struct nb_token *const number = nb_token_peek(reader);
  const struct nb_measure *const measure = &expectation->measure;
  const size_t from = reader->next, of = from + (is_before(reader, "of") ? 1 : 2); /* `of`: the index of this word */
  const bool less = expectation->kind == NB_LESS;
  const char *const unit = shown_unit(reader, measure->unit), *const scale = scale_name(reader, scene, measure->unit);
  char hint[NB_HINT_SIZE];
  const bool bare = is_bare_reducer(reader, of + 1);
  snprintf(hint, sizeof hint, "write `%s expected", measure->label);
  if (less)
    nb_append(hint, sizeof hint, " 0%s%s within", *unit ? " " : "", unit);
  append_words(hint, reader, from, bare ? of + 1 : reader->count);
  if (bare)
    nb_append(hint, sizeof hint, " %.80s %s in all", reader->tokens[0].text, scale_reducer(reader));
  else if (reader->count == from + 2)
    nb_append(hint, sizeof hint, " of %.80s %s in all", scale, scale_reducer(reader));
  nb_append(hint, sizeof hint, "%s [SOURCE]`%s; a line with `%s` compares with a number or with another measure",
            less ? "" : " within 1 %", reader->count == from + 2 ? scale_note(scene, scale) : "",
            less ? "below" : "above");
  return nb_token_mistake(reader, number, hint, "expected a number%s or a measure, found a fraction",
                          *unit ? " with its unit," : "");
}

static bool take_other(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const struct nb_token *token = nb_token_peek(reader);
  double number;
  expectation->has_number = token && nb_number_read(&number, token->text, 0) != NB_NO_NUMBER;
  if (expectation->has_number &&
      (is_before(reader, "of") || (is_before(reader, "%") && strcmp(expectation->measure.unit, "1") != 0)))
    return fraction_mistake(reader, scene, expectation);
  if (expectation->has_number) {
    struct nb_comparison comparison = {.name = expectation->measure.label, .unit = expectation->measure.unit};
    comparison.relation = expectation->kind == NB_LESS ? NB_BELOW : NB_ABOVE;
    comparison.bounds = expectation->measure.bounds, comparison.token = token;
    if (!nb_take_in_unit(reader, expectation->measure.unit, &expectation->number))
      return false;
    comparison.value = expectation->number;
    return nb_comparison_is_open(reader, &comparison, "an expectation");
  }
  return take_other_measure(reader, scene, expectation);
}

static bool take_trend(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  char hint[NB_HINT_SIZE];
  if (!nb_token_skip(reader, "with"))
    return nb_expected(reader, trend_hint(hint, reader, scene, &expectation->measure),
                       "`with` and the name of a `sweep`");
  return take_sweep_name(reader, scene, &expectation->measure, expectation->against) &&
         take_sample(reader, scene, expectation);
}

/* The sum of mass times speed of all particles at the start, kg.m/s: the scale of a momentum, which may be 0 itself. */
static double momentum_scale(const struct nb_scene *scene) {
  double sum = 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *const it = &scene->particles[k];
    if (!it->fixed && it->material >= 0)
      sum += nb_particle_mass(scene, it) * hypot(it->vx, it->vy);
  }
  return sum;
}

/* Writes how to check that a quantity is constant in time: a fraction of its largest value if it is never below 0; else it
 * may be 0, or near 0, and the tolerance is absolute. */
static void append_constant(char *hint, const struct nb_reader *reader, const struct nb_scene *scene) {
  const char *const name = reader->tokens[0].text;
  struct nb_quantity quantity;
  nb_quantity_find(&quantity, scene, name); /* a quantity that the page records */
  const bool positive = nb_quantity_bounds(quantity) & NB_AT_LEAST_0,
             momentum = strcmp(nb_quantity_unit(quantity), "kg.m/s") == 0;
  const char *const unit = shown_unit(reader, nb_quantity_unit(quantity)), *const space = *unit ? " " : "";
  const double scale = momentum ? momentum_scale(scene) : 0;
  char tolerance[32] = "1e-9";
  if (nb_quantity_is_residual(quantity)) {
    nb_append(hint, NB_HINT_SIZE,
              "a residual should be 0: write `%.80s max in all  within 1e-6 of energy.kinetic max in all` and the same "
              "line with `min`%s",
              name, scale_note(scene, "energy.kinetic"));
    return;
  }
  if (scale > 0)
    snprintf(tolerance, sizeof tolerance, "%.1g", 1e-9 * scale);
  nb_append(hint, NB_HINT_SIZE,
            "to check that a quantity is constant in time, write `%.80s amplitude in all  expected 0%s%s within ", name,
            space, unit);
  if (positive)
    nb_append(hint, NB_HINT_SIZE,
              "1e-6 of %.80s max in all [SOURCE]`, or, if it is always near 0, a tolerance%s: `within 1e-9%s%s`", name,
              *unit ? " with its unit" : "", space, unit);
  else
    nb_append(hint, NB_HINT_SIZE,
              "%s%s%s [SOURCE]`%s; if it is far from 0, the tolerance may also be a fraction: `within 1e-6 of %.80s "
              "max in all`",
              tolerance, space, unit, scale > 0 ? ", 1e-9 of the sum of mass times speed at the start" : "", name);
}

static bool take_constant(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  char hint[NB_HINT_SIZE] = "`constant with NAME` compares the runs of a sweep; ";
  append_constant(hint, reader, scene);
  if (!nb_token_is(reader, "with"))
    return nb_expected(reader, hint, "`with` and the name of a `sweep`");
  return take_trend(reader, scene, expectation) &&
         take_tolerance(reader, NULL, expectation->measure.unit, false, &expectation->tolerance);
}

/* Appends how the error against a value is bounded by a power of the swept name. */
static void append_bound(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                         const struct nb_expectation *e) {
  const struct nb_binding *const swept = swept_by(scene, e);
  const char *const unit = shown_unit(reader, e->measure.unit), *const space = *unit ? " " : "";
  nb_append(hint, NB_HINT_SIZE,
            "; the error against a value is bounded by a formula, `%.120s expected 3%s%s within (c*(%s/k0)^%g) "
            "[SOURCE]`, with `let c = 1%s%s` and `let k0 = %s` in the scene",
            e->measure.label, space, unit, swept->name, e->number, space, unit, swept->text);
}

/* Writes the hint for an incomplete `order`: the whole line, with the order if it is known and the first sweep of the
 * page. */
static const char *order_hint(char *hint, const struct nb_scene *scene, const struct nb_expectation *expectation,
                              double order) {
  const struct nb_binding *const swept = swept_by(scene, expectation);
  snprintf(hint, NB_HINT_SIZE, "write `%.120s order %g in %s within 0.1`%s%s", expectation->measure.label, order,
           swept ? swept->name : "dt",
           expectation->measure.is_residual
               ? ""
               : " below a line `reference NAME`, because the order is that of the error against the reference",
           swept ? "" : "; in the scene write `sweep dt 1 us 2 us 4 us` and `step $dt`");
  return hint;
}

static bool take_order(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const struct nb_token *token = nb_token_peek(reader);
  char hint[NB_HINT_SIZE];
  double number;
  if (!token || nb_number_read(&number, token->text, 0) == NB_NO_NUMBER)
    return nb_expected(reader, order_hint(hint, scene, expectation, 2), "a number");
  if (!nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &expectation->number))
    return false;
  if (!nb_token_skip(reader, "in"))
    return nb_expected(reader, order_hint(hint, scene, expectation, expectation->number),
                       "`in` and the name of a `sweep`");
  if (!take_sweep_name(reader, scene, &expectation->measure, expectation->against))
    return false;
  order_hint(hint, scene, expectation, expectation->number);
  if (nb_token_is(reader, "within"))
    return take_tolerance(reader, NULL, "1", false, &expectation->tolerance);
  token = nb_token_peek(reader);
  if (!token)
    return nb_expected(reader, hint, "`within`");
  if (!expectation->measure.is_residual) /* a value, `expected 3 N`, which is no reference */
    append_bound(hint, reader, scene, expectation);
  return nb_token_mistake(reader, token, hint, "expected `within`, found `%.80s`", token->text);
}

/* clang-format off */
static const struct nb_expectation_row rows[] = {
  {"within", NB_WITHIN, "MEASURE within TOLERANCE", take_within,
   "The computed value agrees with the reference; a residual should be 0. TOLERANCE: `0.1 %` or `10 ppm` of the reference, `2 nm` with "
   "a unit, `1e-12` for a quantity without unit, or a fraction of another measure, `1e-12 of energy.kinetic max`.",
   "C.normal max in strike  within 0.1 %"},
  {"versus", NB_VERSUS, "QUANTITY versus COLUMN {in STAGE} within TOLERANCE", take_versus,
   "A curve agrees with that of the reference at every row. COLUMN is the independent variable. `0.5 % of peak` is a fraction of the "
   "largest magnitude of the reference.",
   "C.normal versus time in strike  within 0.5 % of peak"},
  {"expected", NB_EXPECTED, "MEASURE expected NUMBER {of MEASURE} within TOLERANCE [SOURCE]", take_expected,
   "The computed value agrees with NUMBER, which comes from SOURCE. With `of`, NUMBER is a fraction of another measure. `expected NUMBER "
   "over SAMPLE [SOURCE]` reports the percentile of NUMBER in the runs of the sweep SAMPLE, which are realizations of one case; it is "
   "a note, which fails only if a value is not a finite number.",
   "time at 0 cycles  expected 0 s within 0 s  [the clock starts]\n"
   "C.normal in part  expected 0 of C.normal max in strike within 0.01  [the discs separate]"},
  {"below", NB_LESS, "MEASURE below MEASURE|NUMBER", take_other,
   "The measure is less than the second one of the same run, or than a number with its unit. Equal is not below, and NaN is neither below nor above.",
   "C.overlap in part  below  C.overlap max in strike\n"
   "energy.kinetic in part  below  1 MJ"},
  {"above", NB_GREATER, "MEASURE above MEASURE|NUMBER", take_other,
   "The measure is greater than the second one of the same run, or than a number with its unit.",
   "C.normal max in strike  above  C.normal mean in strike"},
  {"increases", NB_INCREASES, "MEASURE increases with NAME {over SAMPLE}", take_trend,
   "The measure increases from each value of the sweep NAME to the next larger one, with all other swept values equal; values that are words "
   "count in the order of the sweep. With `over` the runs of the sweep SAMPLE are realizations of one case: the mean difference is above 0 with 95 % "
   "confidence (Student).",
   "C.normal max in strike  increases with speed"},
  {"decreases", NB_DECREASES, "MEASURE decreases with NAME {over SAMPLE}", take_trend, "As `increases`, for a measure that decreases.",
   "A.vx in strike  decreases with speed"},
  {"constant", NB_CONSTANT, "MEASURE constant with NAME {over SAMPLE} within TOLERANCE", take_constant,
   "The difference between the largest and the smallest value over the sweep NAME is within TOLERANCE. A percentage is a fraction of the mean of all values. "
   "With `over` the 95 % confidence interval of every mean difference lies within TOLERANCE.",
   "time at 100 cycles in strike  constant with speed within 1 ns"},
  {"order", NB_ORDER, "MEASURE order NUMBER in NAME within TOLERANCE", take_order,
   "The error is proportional to this power of the swept NAME: NUMBER is the slope of the least-squares line of log(error) against "
   "log(NAME). If the error falls as NAME grows, as with a number of steps, NUMBER is negative. The error is the computed value "
   "minus the reference; for a residual it is the value itself.",
   "C.normal max in strike  order 2 in speed  within 0.1"},
  {NULL, NB_WITHIN, NULL, NULL, NULL, NULL},
};
/* clang-format on */

const struct nb_expectation_row *nb_expectation_rows(void) { return rows; }

/* ---- the statements ---- */

/* A reader of expectations; the caller frees it. NULL: no memory, which is added to the mistakes. */
static struct nb_reader *reader_of(const struct nb_page *page, const struct nb_scene *scene,
                                   struct nb_mistakes *mistakes) {
  struct nb_reader *reader = calloc(1, sizeof *reader);
  if (!reader)
    return nb_mistake_memory(mistakes), NULL;
  reader->page = page, reader->mistakes = mistakes, reader->unitless = scene->unitless;
  reader->here = NB_IN_EXPECT;
  return reader;
}

struct reading {
  struct nb_expectations *expectations;
  const struct nb_scene *scene;
};

/* Offers the reducers that may still follow, and `in`, and lists them. Returns true if the next word is a reducer
 * although the measure has one: `C.normal max min`. */
static bool offer_reducers(const struct nb_reader *reader, const struct nb_measure *measure, struct nb_guess *guess,
                           char *words, size_t size) {
  bool again = false;
  char word[NB_NAME_SIZE], before[NB_NAME_SIZE] = "";
  for (const struct nb_reducer_row *row = reducers; row->word; row++) {
    nb_first_word(word, row->word);
    const bool stage = strcmp(word, "in") == 0;
    if (strcmp(word, before) != 0 && (stage ? measure->stage == -1 : reader->next == 1)) {
      nb_append_item(words, size, word, false);
      nb_guess_offer(guess, word);
    }
    again = again || (!stage && nb_token_is(reader, word));
    strcpy(before, word);
  }
  return again;
}

/* Writes the hint for a reducer after the stage, `C.normal in load max`; false: the word is no such reducer. */
static bool reducer_after_stage(char *hint, const struct nb_measure *measure, const char *word) {
  const struct nb_reducer_row *row = reducers;
  const bool at = strcmp(word, "at") == 0;
  while (row->word && strcmp(row->word, word) != 0)
    row++;
  snprintf(hint, NB_HINT_SIZE, "write `%.*s %s%s%s`", (int)measure->bare_length, measure->label, word, at ? " …" : "",
           measure->label + measure->bare_length);
  return (row->word || at) && measure->reducer == NB_LAST && measure->stage != -1;
}

/* The hint for a token that is no word of an expectation. `again`: it is a reducer although the measure has one. */
static const char *kind_hint(char *hint, const struct nb_measure *measure, const struct nb_token *token,
                             const struct nb_guess *guess, bool again) {
  if (!token)
    return "`report MEASURE` writes the value into the tables and checks nothing";
  return reducer_after_stage(hint, measure, token->text) ? hint
         : again ? "one line has one of `max`, `min`, `mean` …: write a line for each"
                 : nb_guess_hint(guess, hint);
}

/* True if the token is a word of that row of the table of words: a row of expectations with a hint of its own. */
static bool is_kind_of(const struct nb_token *token, const char *first) {
  const struct nb_synonym *const synonym = token ? nb_pair_synonym("expect", token->text) : NULL;
  return synonym && strncmp(synonym->words, first, strlen(first)) == 0;
}

/* True if the line has a word that says with what the measure is compared. */
static bool is_compared(const struct nb_reader *reader) {
  bool found = false;
  for (const struct nb_expectation_row *row = rows; row->word; row++)
    found = found || (row->kind != NB_WITHIN && nb_line_has(reader, row->word));
  return found;
}

/* Writes the hint for `conserved`; or, for a value, the line with `expected` before it. NULL: the token is neither, or
 * the line has another word of this kind. */
static const char *value_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                              const struct nb_token *token) {
  bool within = false;
  *hint = '\0';
  if (is_kind_of(token, "expect_conserved")) {
    append_constant(hint, reader, scene);
    return hint;
  }
  snprintf(hint, NB_HINT_SIZE, "write `");
  for (size_t k = 0; k < reader->count && *reader->tokens[k].text != '['; k++) {
    within = within || strcmp(reader->tokens[k].text, "within") == 0;
    nb_append(hint, NB_HINT_SIZE, "%s%s", k ? " " : "", k == reader->next ? "expected " : "");
    nb_append_operand(hint, reader, reader->tokens[k].text);
  }
  nb_append(hint, NB_HINT_SIZE, "%s [SOURCE]`", within ? "" : " within 1 %");
  return nb_number_length(token->text) && !is_compared(reader) ? hint : NULL;
}

/* Reads the rest of the expectation as the row of its word says. The hint for an unknown word also suggests reducers
 * and `in`. */
static bool take_kind(struct nb_reader *reader, const struct reading *reading, struct nb_expectation *expectation) {
  char hint[NB_HINT_SIZE], words[512] = "";
  const struct nb_token *token = nb_token_peek(reader);
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (const struct nb_expectation_row *row = rows; row->word; row++)
    if (nb_token_is(reader, row->word)) {
      reader->next += row->kind != NB_WITHIN; /* `within` is part of the tolerance */
      expectation->kind = row->kind;
      return row->take(reader, reading->scene, expectation);
    }
  const bool again = offer_reducers(reader, &expectation->measure, &guess, words, sizeof words);
  for (const struct nb_expectation_row *row = rows; row->word; row++) {
    nb_append_item(words, sizeof words, row->word, !row[1].word);
    nb_guess_offer(&guess, row->word);
  }
  const bool is_trend = is_kind_of(token, "expect_trend");
  if (token && (is_trend || (strchr("+-*/", token->text[0]) && !token->text[1]))) {
    reader->next++;
    if (is_trend)
      trend_hint(hint, reader, reading->scene, &expectation->measure);
    else
      ratio_hint(hint, reader, reading->scene, *token->text, expectation->measure.label, "");
    return nb_token_mistake(reader, token, hint, "expected %s, found `%s`", words, token->text);
  }
  if (token && value_hint(hint, reader, reading->scene, token))
    return nb_token_mistake(reader, token, hint, "expected %s, found `%s`", words, token->text);
  return nb_expected(reader, kind_hint(hint, &expectation->measure, token, &guess, again), "%s", words);
}

/* Reads `report MEASURE`: the measure is written to the tables, without a check. */
static void apply_report(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  struct nb_expectation expectation = {.kind = NB_REPORTED, .line = (int)reader->line};
  (void)record;
  if (!take_measure(reader, reading->scene, &expectation.measure))
    return;
  const struct nb_token *const token = nb_token_peek(reader);
  if (token && strchr("+-*/", token->text[0]) && !token->text[1])
    nb_token_mistake(reader, token, "a line reports one measure: write a line for each",
                     "expected the end of the line, found `%s`", token->text);
  else
    NB_APPEND(reader, reading->expectations->list, reading->expectations->count, expectation);
}

static void apply_expectation(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  struct nb_expectations *expectations = reading->expectations;
  struct nb_expectation expectation = {.line = (int)reader->line};
  (void)record;
  const bool compared = nb_line_has(reader, "expected"); /* with a number */
  if (one_run_mistake(reader, reading->scene))
    return;
  if (!take_measure(reader, reading->scene, &expectation.measure)) {
    if (compared)
      nb_line_needs(reader, "[", source_hint, "the source in brackets");
  } else if (take_kind(reader, reading, &expectation)) {
    NB_APPEND(reader, expectations->list, expectations->count, expectation);
  }
}

static void apply_reference(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  const struct nb_token *token = record->value[0].token;
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token->text);
  reading->expectations->reference = nb_reference_find(token->text);
  if (reading->expectations->reference)
    return;
  for (const struct nb_reference *const *reference = nb_references(); *reference; reference++)
    nb_guess_offer(&guess, (*reference)->name);
  const char *suggestion = nb_guess_hint(&guess, hint);
  for (const struct nb_reference *const *reference = nb_references(); *reference && !suggestion; reference++)
    if (strncmp((*reference)->name, token->text, strlen(token->text)) == 0) {
      snprintf(hint, sizeof hint, "did you mean `%s`?", (*reference)->name);
      suggestion = hint;
    }
  nb_expected_at(reader, token, suggestion ? suggestion : "`nineball list` names all references",
                 "the name of a reference");
}

static const struct nb_argument reference[] = {
    {NULL, "NAME", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, 0, 1, NULL, "the name of a reference"},
    {NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL},
};
static const struct nb_argument no_arguments[] = {
    {NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL}};

static const struct nb_keyword table[] = {
    {"reference", NB_IN_EXPECT, reference, NULL, 0, false, apply_reference,
     "Selects the reference solution of the page, with which `within`, `versus` and `order` compare the results. "
     "`nineball list` lists the references; they are computed from theory, in the files of cases/refs.",
     "reference  two_wall_compression"},
    {"report", NB_IN_EXPECT, no_arguments, "MEASURE", 0, false, apply_report,
     "Writes the measure to values.tsv and to the verdict, and checks nothing.", "report  C.overlap max in strike"},
    {NULL, NB_IN_EXPECT, no_arguments, "MEASURE EXPECTATION", 0, false, apply_expectation,
     "What is expected of a measure.", NULL},
    {0},
};

const struct nb_family *nb_expect_keywords(void) {
  static const struct nb_family families[] = {{table}, {NULL}};
  return families;
}

/* The first expectation that needs a reference; NULL: none. */
static const struct nb_expectation *needing_reference(const struct nb_expectations *expectations) {
  for (size_t k = 0; k < expectations->count; k++) {
    const struct nb_expectation *e = &expectations->list[k];
    if ((e->kind == NB_WITHIN || e->kind == NB_VERSUS || e->kind == NB_ORDER) && !e->measure.is_residual)
      return e;
  }
  return NULL;
}

/* Writes the hint for an expectation that needs a reference. */
static void reference_hint(char *hint, const struct nb_reader *reader, const struct nb_scene *scene,
                           const struct nb_expectation *e) {
  strcpy(hint, "write `reference NAME` above this line; `nineball list` names the references");
  if (e->kind == NB_WITHIN)
    nb_append(hint, NB_HINT_SIZE,
              "; a number or a formula needs none: `%.120s expected (FORMULA) within 1 %% [SOURCE]`", e->measure.label);
  if (e->kind == NB_VERSUS)
    append_value(hint, &e->measure), append_plot(hint, scene, e);
  if (e->kind == NB_ORDER)
    append_bound(hint, reader, scene, e);
}

enum nb_status nb_expectations_read(struct nb_expectations *expectations, const struct nb_page *page,
                                    const struct nb_scene *scene, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->total;
  *expectations = (struct nb_expectations){0};
  struct reading reading = {expectations, scene};
  struct nb_reader *reader = reader_of(page, scene, mistakes);
  if (!reader)
    return NB_NO_MEMORY;
  reader->bindings = scene->bindings, reader->binding_count = scene->binding_count, reader->has_units = true;
  /* False after a wrong line of two words, which is probably a mistyped `reference NAME`. */
  bool reference_required = true;
  for (size_t line = 1; line <= page->line_count && !scene->path_replaced; line++)
    if (page->kind_of[line - 1] == 1 + NB_BLOCK_EXPECT && nb_line_read(reader, line)) {
      nb_statement_read(reader, nb_expect_keywords(), NB_IN_EXPECT, &reading);
      reference_required = reference_required && !(reader->bad && reader->count == 2);
    }
  const struct nb_expectation *const e =
      expectations->reference || !reference_required ? NULL : needing_reference(expectations);
  char hint[NB_HINT_SIZE];
  if (e) {
    reference_hint(hint, reader, scene, e);
    nb_line_mistake(reader, (size_t)e->line, hint, "expected a `reference` in this page to compare with, found none");
  }
  free(reader);
  const enum nb_status status = nb_mistakes_status(mistakes, before);
  if (status)
    nb_expectations_free(expectations);
  return status;
}

enum nb_status nb_expectation_read(struct nb_expectation *expectation, const char *name, const char *text,
                                   const struct nb_scene *scene, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->total;
  char *lines[] = {(char *)text};
  const struct nb_page page = {.path = (char *)name, .lines = lines, .line_count = 1};
  struct nb_reader *reader = reader_of(&page, scene, mistakes);
  *expectation = (struct nb_expectation){0};
  if (!reader)
    return NB_NO_MEMORY;
  reader->has_units = true;
  nb_line_read(reader, 1);
  if (take_measure(reader, scene, &expectation->measure) &&
      take_tolerance_of(reader, scene, expectation->measure.unit, expectation->measure.is_residual,
                        &expectation->tolerance) &&
      nb_token_peek(reader))
    nb_expected(reader, NULL, "the end of the text");
  free(reader);
  return nb_mistakes_status(mistakes, before);
}

void nb_expectations_free(struct nb_expectations *expectations) {
  free(expectations->list);
  *expectations = (struct nb_expectations){0};
}
