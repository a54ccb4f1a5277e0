/* Named values: `units`, `let`, `sweep`, and --set, which overrides them.
 *
 * A sweep is a small table: each row is one run, each column a name. The runs of a page are all combinations of the
 * rows of its sweeps; the last sweep varies fastest. The row of a run depends on the lengths of the sweeps below, so a
 * page is read twice (scene.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "expression.h"
#include "statement.h"

enum { SWEPT_MAX = 16 }; /* names in one sweep */

enum { AT_NAME };
static const struct nb_argument units_fields[] = {
    CHOICE(NULL, "none|si", AT_NAME, NULL, "`si`: numbers have units; `none`: they are written without units"), END};
static const struct nb_argument value_fields[] = {NAME(AT_NAME, "a name for the value"), END};
static const struct nb_argument trade_fields[] = {NAME(AT_NAME, "the name of a value"), END};

NB_APPLY(apply_units) {
  struct nb_scene_reading *reading = subject;
  if (nb_given_twice(reader, reading->units_line))
    return;
  reading->units_line = (int)reader->line;
  reading->scene->unitless = reading->reader.unitless = reading->setting.unitless = record->value[AT_NAME].number == 0;
}

/* Takes a word, or a number and its unit; *token is the first token of the value. False, with a message, if there is no
 * value, or if it is too long or out of the range of a double. */
static bool take_value(struct nb_reader *reader, struct nb_binding *value, const struct nb_token **token) {
  struct nb_unit read;
  *value = (struct nb_binding){.value = NAN};
  *token = nb_take_token(reader, "a value: a word, or a number and its unit");
  if (!*token)
    return false;
  const struct nb_token *next = nb_token_peek(reader);
  const char *unit =
      next && nb_unit_read(&read, next->text) && (!reader->unitless || nb_unit_without_dimension(next->text))
          ? next->text
          : NULL;
  const enum nb_reading reading = nb_literal(value, (*token)->text, unit, (*token)->computed);
  if (reading == NB_TOO_LARGE || reading == NB_TOO_SMALL)
    return nb_expected_at(reader, *token, NULL, nb_reading_words(reading));
  reader->next += reading == NB_READ && unit;
  if (reading == NB_READ)
    return true;
  value->value = NAN;
  return (size_t)snprintf(value->text, sizeof value->text, "%s", (*token)->text) < sizeof value->text ||
         nb_token_mistake(reader, *token, NULL, "expected a value shorter than %d bytes, found `%.80s`", NB_NAME_SIZE,
                          (*token)->text);
}

static void bind(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name,
                 struct nb_binding value) {
  struct nb_scene *scene = reading->scene;
  char hint[NB_HINT_SIZE];
  if (nb_name_reserved(name->text) || strchr(name->text, '-'))
    nb_token_mistake(reader, name,
                     strchr(name->text, '-') ? "write `_` instead of `-`, which is a minus sign in expressions"
                                             : "this name is a function or a constant of expressions",
                     "expected a valid name for a value, found `%s`", name->text);
  const int before = NB_FIND(scene->bindings, scene->binding_count, name->text);
  const bool same_line = before >= 0 && value.sweep >= 0 && scene->bindings[before].sweep == value.sweep;
  snprintf(hint, sizeof hint,
           same_line ? "the names of a sweep differ: remove one `%.60s`, and its values"
                     : "keep one of the two lines: a `let` gives one value, a `sweep` a run for each of its values; "
                       "`--set %.60s=VALUE` replaces either",
           name->text);
  if (before >= 0)
    nb_token_mistake(reader, name, hint, "expected a new name, `%s` already has a value", name->text);
  if (nb_too_many(reader, scene->binding_count, NB_NAMED_MAX, "names for values"))
    return;
  snprintf(value.name, sizeof value.name, "%s", name->text);
  value.line = (int)reader->line;
  NB_APPEND(reader, scene->bindings, scene->binding_count, value);
  reading->reader.bindings = reading->setting.bindings = scene->bindings;
  reading->reader.binding_count = reading->setting.binding_count = scene->binding_count;
}

size_t nb_setting_find(const struct nb_scene_reading *reading, const char *name) {
  size_t length = strlen(name);
  for (size_t i = reading->settings.line_count; i > 0; i--) {
    const char *text = reading->settings.lines[i - 1];
    if (strncmp(text, name, length) == 0 && text[length] == '=')
      return i;
  }
  return 0;
}

/* True if a --set gives a value to the name; *value is then this value. `number`: the value must be an expression;
 * otherwise a word, or a number and its unit. An invalid value is reported, and the statement becomes bad. */
static bool set_value(struct nb_scene_reading *reading, struct nb_reader *reader, const char *name, bool number,
                      struct nb_binding *value) {
  struct nb_reader *setting = &reading->setting;
  const size_t line = nb_setting_find(reading, name);
  const struct nb_token *token;
  if (!line)
    return false;
  const char *const text = reading->settings.lines[line - 1];
  nb_line_begin(setting, line);
  if (number)
    nb_expression(setting, text, strchr(text, '=') + 1, text + strcspn(text, "#"), value);
  else if (nb_line_read(setting, line), setting->next = 1, take_value(setting, value, &token) && nb_token_peek(setting))
    nb_expected(setting, NULL, "the end of the value");
  if (setting->bad)
    nb_fail_silently(reader);
  return true;
}

/* Reads `let NAME = EXPRESSION` or `let NAME WORD`. */
NB_APPLY(apply_let) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *name = record->value[AT_NAME].token, *token;
  const char *const line = reader->page->lines[reader->line - 1];
  struct nb_binding value = {.value = NAN}, set;
  const bool expression = nb_token_skip(reader, "=");
  double number;
  if (expression) {
    nb_expression(reader, line, strchr(line, '=') + 1, line + strcspn(line, "#"), &value);
    reader->next = reader->count;
  } else if ((token = nb_token_peek(reader)) && nb_number_read(&number, token->text, 0) != NB_NO_NUMBER) {
    char hint[NB_HINT_SIZE];
    const struct nb_token *unit = reader->next + 1 < reader->count ? token + 1 : NULL;
    snprintf(hint, sizeof hint, "write `let %s = %.80s%s%.80s`", name->text, token->text, unit ? " " : "",
             unit ? unit->text : "");
    nb_expected(reader, hint, "`=` before a number, or a word");
  } else if (!token) {
    char hint[NB_HINT_SIZE];
    snprintf(hint, sizeof hint, "write `let %s = VALUE`, or `let %s WORD`", name->text, name->text);
    nb_expected(reader, hint, "`=` and a value, or a word");
  } else if (take_value(reader, &value, &token) && nb_token_peek(reader)) {
    nb_expected(reader, "use `sweep` for several values", "the end of the line");
  }
  const bool is_set = set_value(reading, reader, name->text, expression, &set);
  value = is_set ? set : value;
  value.sweep = -1;
  if (!reader->bad)
    bind(reading, reader, name, value);
}

/* The product a b, but at most NB_RUNS_MAX + 1. */
static size_t capped_product(size_t a, size_t b) { return a * b > NB_RUNS_MAX ? NB_RUNS_MAX + 1 : a * b; }

/* The row of this sweep for the current run. When the page is read for the first time, stores the number of rows and
 * returns the first row. */
static size_t row_of_run(struct nb_scene_reading *reading, struct nb_reader *reader, size_t rows) {
  size_t sweep = reading->sweep++, above = 1, below = 1;
  if (reading->survey) {
    NB_APPEND(reader, reading->rows, reading->sweep_count, rows);
    return 0;
  }
  for (size_t i = 0; i < sweep && i < reading->sweep_count; i++)
    above = capped_product(above, reading->rows[i]);
  for (size_t i = sweep + 1; i < reading->sweep_count; i++)
    below = capped_product(below, reading->rows[i]);
  if (above <= NB_RUNS_MAX && capped_product(above, rows) > NB_RUNS_MAX)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d runs, found %zu with this sweep",
                     NB_RUNS_MAX, above * rows);
  return reading->run / below % rows;
}

size_t nb_run_count(const struct nb_scene_reading *reading) {
  size_t runs = 1;
  for (size_t i = 0; i < reading->sweep_count; i++)
    runs = capped_product(runs, reading->rows[i]);
  return runs <= NB_RUNS_MAX ? runs : 1;
}

static const char *unit_of(const struct nb_binding *value) { return value->text + strcspn(value->text, " "); }

/* Reports a word among numbers. `unit`: it may be a mistyped unit. */
static bool word_mistake(struct nb_reader *reader, const struct nb_token *token, bool unit) {
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token->text);
  for (int kind = 0; kind < NB_UNIT_KINDS && unit; kind++)
    nb_unit_offer(&guess, nb_unit_list((enum nb_unit_kind)kind));
  return nb_expected_at(reader, token, nb_guess_hint(&guess, hint),
                        unit ? "a number or a unit, because the first value of this name is a number"
                             : "a number, because the first value of this name is a number");
}

/* Refuses a number after a word: `sweep mu from 0.1 to 0.3`, or a number in a column of words. */
static bool word_wanted(struct nb_reader *reader, const struct nb_token *token) {
  return strcmp(token[-1].text, "from") == 0 && strcmp(reader->tokens[0].text, "sweep") == 0
             ? nb_token_mistake(reader, token - 1, "a sweep lists each value: `sweep mu 0.1 0.3 0.5`",
                                "expected the first value of the sweep, found `from`")
             : nb_expected_at(reader, token, "all values of a name are words, or all are numbers",
                              "a word, because the first value of this name is a word");
}

/* True if a value has the type of the first one in its column. A column has either words or numbers of one dimension; a
 * word among numbers is a mistyped unit. */
static bool same_type(struct nb_reader *reader, const struct nb_binding *first, const struct nb_binding *value,
                      const struct nb_token *token) {
  char words[2 * NB_NAME_SIZE];
  const struct nb_token *next = nb_token_peek(reader);
  const bool number = !isnan(value->value);
  double other;
  if (isnan(first->value))
    return !number || word_wanted(reader, token);
  if (number && nb_dimension_same(first->dimension, value->dimension))
    return true;
  nb_dimension_words(words, sizeof words, first->dimension);
  if (number && (!next || *unit_of(value) || nb_number_read(&other, next->text, 0) == NB_READ))
    return nb_token_mistake(reader, token, NULL, "expected %s, as the first value of this name, found `%s`", words,
                            value->text);
  const bool after_number = number || nb_number_read(&other, token[-1].text, 0) == NB_READ;
  return word_mistake(reader, number ? next : token, after_number && !reader->unitless);
}

/* Reports two equal rows, because a statistic over the runs would count the run twice. */
static bool rows_differ(struct nb_reader *reader, const struct nb_binding *values,
                        const struct nb_token *const tokens[], size_t count, size_t columns) {
  for (size_t row = columns; row < count; row += columns)
    for (size_t above = 0; above < row; above += columns) {
      size_t equal = 0;
      while (equal < columns && nb_binding_same(&values[row + equal], &values[above + equal]))
        equal++;
      if (equal < columns)
        continue;
      return nb_token_mistake(reader, tokens[row], NULL,
                              columns > 1 ? "expected different rows, found the same values in rows %zu and %zu"
                                          : "expected different values, found the same value in places %zu and %zu",
                              above / columns + 1, row / columns + 1);
    }
  return true;
}

/* Converts a column with several units to SI, because a column of a table has one unit. */
static void unify(struct nb_binding *values, size_t count, size_t columns) {
  for (size_t c = 0; c < columns; c++) {
    bool one = true;
    for (size_t i = c; i < count; i += columns)
      one = one && strcmp(unit_of(&values[i]), unit_of(&values[c])) == 0;
    for (size_t i = c; i < count && !one && !isnan(values[c].value); i += columns)
      nb_binding_write(&values[i]);
  }
}

static const char list_signs[] = ",;=[](){}";

/* Appends a word of a list of values, and after a number the unit of all values. */
static void append_value(char *hint, const struct nb_reader *reader, const char *word, const char *unit) {
  struct nb_unit read;
  if (*unit && nb_unit_read(&read, word))
    return; /* it follows the number already */
  nb_append(hint, NB_HINT_SIZE, " ");
  nb_append_operand(hint, reader, word);
  if (*unit && nb_number_length(word))
    nb_append(hint, NB_HINT_SIZE, " %s", unit);
}

/* The only unit of the values of the line, which then holds for all of them, `0, 5 kPa`; "": none or several. */
static const char *only_unit(const struct nb_reader *reader) {
  struct nb_unit read;
  const char *unit = "";
  for (size_t k = 2, count = 0; k < reader->count; k++)
    for (const char *at = reader->tokens[k].text; *(at += strspn(at, list_signs)); at += strcspn(at, list_signs)) {
      char word[NB_NAME_SIZE];
      snprintf(word, sizeof word, "%.*s", (int)strcspn(at, list_signs), at);
      if (nb_unit_read(&read, word))
        unit = count++ || at[strlen(word)] == ',' ? "" : at;
    }
  return unit;
}

/* True if the line has a function of another language, `linspace(0, 1, 5)`. */
static bool has_function(const struct nb_reader *reader) {
  bool found = false;
  for (size_t k = 2; k < reader->count; k++) {
    const char *const open = strchr(reader->tokens[k].text, '(');
    found = found || (open && open > reader->tokens[k].text && isalpha((unsigned char)open[-1]));
  }
  return found;
}

/* Writes the line with its values separated by spaces, for `sweep mu = [0, 0.2]`. */
static const char *values_hint(char *hint, const struct nb_reader *reader) {
  char word[NB_NAME_SIZE], unit[NB_NAME_SIZE];
  const char *const only = only_unit(reader);
  if (has_function(reader))
    return "write every value, separated by spaces: `sweep k 0 0.25 0.5 0.75 1`";
  snprintf(unit, sizeof unit, "%.*s", (int)strcspn(only, list_signs), only);
  snprintf(hint, NB_HINT_SIZE, "the values follow the name, separated by spaces: write `%.20s %.80s",
           reader->tokens[0].text, reader->tokens[1].text);
  for (size_t k = 2; k < reader->count; k++)
    for (const char *at = reader->tokens[k].text; *(at += strspn(at, list_signs)); at += strcspn(at, list_signs)) {
      snprintf(word, sizeof word, "%.*s", (int)strcspn(at, list_signs), at);
      if (k > 2 || strcmp(word, "in") != 0)
        append_value(hint, reader, word, unit);
    }
  nb_append(hint, NB_HINT_SIZE, "`");
  return hint;
}

/* Refuses a sign of a list, `=`, `,` or a bracket, and the word `in`. */
static bool is_list(struct nb_reader *reader, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  const bool first = token == &reader->tokens[2] && token + 1 < reader->tokens + reader->count;
  return (strpbrk(token->text, ",;=[]{}") || (first && strcmp(token->text, "in") == 0)) &&
         !nb_token_mistake(reader, token, values_hint(hint, reader), "expected one value, found `%.80s`", token->text);
}

/* Reads the values row by row, at most NB_TOKENS_MAX. Returns the number of rows; 0 after a mistake. */
static size_t take_rows(struct nb_reader *reader, struct nb_binding *values, size_t columns) {
  const struct nb_token *tokens[NB_TOKENS_MAX];
  size_t count = 0;
  do {
    if ((nb_token_peek(reader) && is_list(reader, nb_token_peek(reader))) ||
        !take_value(reader, &values[count], &tokens[count]) ||
        !same_type(reader, &values[count % columns], &values[count], tokens[count]))
      return 0;
    count++;
  } while (nb_token_peek(reader));
  unify(values, count, columns);
  if (count % columns == 0)
    return rows_differ(reader, values, tokens, count, columns) ? count / columns : 0;
  nb_token_mistake(reader, NULL, "write the values run by run: `sweep a with b  1 10  2 20` has two runs",
                   "expected a multiple of %zu values, one for each name in every run, found %zu", columns, count);
  return 0;
}

/* A value that --set gives to a name selects the rows with this value. If no row has the value, all rows stay, and
 * apply_sweep gives the value to the name in each of them. Returns the number of selected rows, which are moved to the
 * front. is_set[i]: --set gives the value set[i] to the name in column i. */
static size_t select_rows(struct nb_binding *values, size_t rows, size_t columns, const bool is_set[],
                          const struct nb_binding *set) {
  for (size_t i = 0; i < columns; i++) {
    size_t left = 0;
    for (size_t row = 0; row < rows && is_set[i]; row++)
      left += nb_binding_same(&values[row * columns + i], &set[i]);
    if (left == 0)
      continue;
    left = 0;
    for (size_t row = 0; row < rows; row++)
      if (nb_binding_same(&values[row * columns + i], &set[i]))
        memmove(&values[left++ * columns], &values[row * columns], columns * sizeof *values);
    rows = left;
  }
  return rows;
}

NB_APPLY(apply_sweep) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *names[SWEPT_MAX] = {record->value[AT_NAME].token};
  struct nb_binding values[NB_TOKENS_MAX], set[SWEPT_MAX];
  bool is_set[SWEPT_MAX], all_set = true;
  size_t columns = 1;
  while (nb_token_skip(reader, "with")) {
    if (columns == SWEPT_MAX)
      nb_expected(reader, NULL, "at most %d names in a sweep", SWEPT_MAX);
    else
      names[columns] = nb_take_name(reader, "a name for the value");
    columns += !reader->bad;
  }
  size_t rows = reader->bad ? 0 : take_rows(reader, values, columns);
  for (size_t i = 0; i < columns && !reader->bad; i++) {
    is_set[i] = set_value(reading, reader, names[i]->text, !isnan(values[i].value), &set[i]);
    all_set = all_set && is_set[i];
  }
  if (reader->bad)
    return;
  rows = select_rows(values, rows, columns, is_set, set);
  const size_t run_count = all_set ? 1 : rows, row = row_of_run(reading, reader, run_count);
  for (size_t i = 0; i < columns; i++) {
    struct nb_binding value = is_set[i] ? set[i] : values[row * columns + i];
    value.swept = run_count > 1 && !is_set[i];
    value.sweep = (int)reading->sweep - 1;
    bind(reading, reader, names[i], value);
  }
}

/* Reads `trade laws all|none`, or a name and other values for it. */
NB_APPLY(apply_trade) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  if (strcmp(name->text, "laws") == 0) {
    scene->trade_laws = nb_token_skip(reader, "none")  ? NB_TRADE_LAWS_NONE
                        : nb_token_skip(reader, "all") ? NB_TRADE_LAWS_ALL
                                                       : NB_TRADE_LAWS_DEFAULT;
    if (scene->trade_laws == NB_TRADE_LAWS_DEFAULT)
      nb_expected(reader, "for example `trade laws all`", "`all` or `none`");
    return;
  }
  char hint[NB_HINT_SIZE];
  struct nb_binding values[NB_TOKENS_MAX];
  static const struct nb_binding soften = {.value = 1, .text = "1"};
  const int index = NB_FIND(scene->bindings, scene->binding_count, name->text);
  if (index < 0 && strcmp(name->text, "soften") != 0) {
    nb_unknown_name(reader, name, NB_NEAREST(hint, name->text, scene->bindings, scene->binding_count),
                    "a name that a `let` above defines, `soften` or `laws`");
    return;
  }
  const struct nb_binding *binding = index < 0 ? &soften : &scene->bindings[index];
  const struct nb_token *first = nb_token_peek(reader);
  if (binding->swept) {
    snprintf(hint, sizeof hint, "`%s` is swept, and `nineball advise` uses all its values, so `trade` cannot change it",
             name->text);
    nb_expected_at(reader, name, hint, "a name that is not swept");
  }
  const size_t count = reader->bad ? 0 : take_rows(reader, values, 1);
  if (count == 0 || nb_too_many(reader, count - 1, NB_TRADED_MAX, "values"))
    return;
  if (isnan(binding->value) != isnan(values[0].value) || !nb_dimension_same(binding->dimension, values[0].dimension)) {
    snprintf(hint, sizeof hint, "the value of `%s` is %.80s", name->text, binding->text);
    nb_expected_at(reader, first, hint,
                   isnan(binding->value) ? "words, as the present value is a word"
                                         : "values with the dimension of the present value");
    return;
  }
  struct nb_trade trade = {.count = count};
  snprintf(trade.name, sizeof trade.name, "%s", name->text);
  for (size_t k = 0; k < count; k++)
    snprintf(trade.values[k], sizeof trade.values[k], "%s", values[k].text);
  NB_APPEND(reader, scene->trades, scene->trade_count, trade);
}

/* Names that --set accepts without a `let` or `sweep`: first the statements that it overrides. `follow` is for contact
 * tests only. */
static const struct {
  char name[NB_NAME_SIZE];
} settable[] = {{"normal"}, {"shear"}, {"step"}, {"damping"}, {"trade"}, {"refine"}, {"soften"}, {"follow"}};
enum { OVERRIDDEN = 5, SETTABLE = sizeof settable / sizeof *settable };

/* Reads refine=R or soften=S. */
static void read_divisor(struct nb_reader *setting, size_t line, double *divisor) {
  if (!nb_line_read(setting, line))
    return;
  setting->next = 1;
  nb_take_number(setting, NB_UNIT_NUMBER, NB_POSITIVE, divisor);
  if (!setting->bad && nb_token_peek(setting))
    nb_expected(setting, NULL, "the end of the setting");
}

/* True if the setting on this line is the last one of its name, and the units of its value are known. */
static bool is_read_now(const struct nb_scene_reading *reading, size_t line, const char *name) {
  return line == nb_setting_find(reading, name) && !(reading->before_start && strcmp(name, "step") == 0);
}

/* Reads NAME=VALUE in a line of the settings. */
static void read_setting(struct nb_scene_reading *reading, size_t line) {
  const struct nb_scene *scene = reading->scene;
  struct nb_mistakes *mistakes = reading->setting.mistakes;
  char name[NB_NAME_SIZE] = "", hint[NB_HINT_SIZE];
  const char *text = reading->settings.lines[line - 1], *equals = strchr(text, '=');
  const size_t length = strcspn(text, "=");
  if (length < sizeof name)
    memcpy(name, text, length);
  const size_t last = nb_setting_find(reading, name);
  if (last > line)
    nb_warn(&reading->scene->warnings, 0, "--set %s has no effect: --set %s follows it", text,
            reading->settings.lines[last - 1]);
  const char *near = NB_NEAREST(hint, name, scene->bindings, scene->binding_count);
  if (!equals) {
    nb_mistake(mistakes, &reading->settings, line, 1, (int)length, NULL, "expected NAME=VALUE, found `%.80s`", text);
  } else if (NB_FIND(scene->bindings, scene->binding_count, name) >= 0 ||
             nb_name_suppressed(reading->reader.mistakes, name)) {
    return; /* the `let` or `sweep` of this name reads the setting */
  } else if (NB_FIND(settable, OVERRIDDEN, name) >= 0) {
    if (is_read_now(reading, line, name) && nb_line_read(&reading->setting, line))
      nb_statement_read(&reading->setting, nb_keywords(), reading->here, reading);
  } else if (strcmp(name, "refine") == 0) {
    read_divisor(&reading->setting, line, &reading->scene->refine);
  } else if (strcmp(name, "soften") == 0) {
    read_divisor(&reading->setting, line, &reading->scene->soften);
  } else if (strcmp(name, "follow") == 0) {
    reading->follow = equals + 1;
    if (!scene->contact_test)
      nb_mistake(mistakes, &reading->settings, line, 1, (int)length, "a contact test is a block of kind `contact-test`",
                 "expected a page with a contact test for `follow`, found a scene");
  } else {
    nb_mistake(
        mistakes, &reading->settings, line, 1, (int)length, near ? near : NB_NEAREST(hint, name, settable, SETTABLE),
        "expected a name that the page defines by `let` or `sweep`, or `normal`, `shear`, `step`, `damping`, `trade`, "
        "`refine`, `soften` or `follow`, found `%.*s`",
        (int)(length < 80 ? length : 80), text);
  }
}

void nb_settings_read(struct nb_scene_reading *reading) {
  for (size_t line = 1; line <= reading->settings.line_count; line++)
    read_setting(reading, line);
}

void nb_setting_read_step(struct nb_scene_reading *reading) {
  const size_t line = nb_setting_find(reading, "step");
  reading->before_start = false;
  if (line)
    read_setting(reading, line);
}

/* clang-format off */
NB_STATEMENTS(let) = {
  {"units", NB_IN_SCENE | NB_IN_CONTACT_TEST, units_fields, NULL, 0, false, apply_units,
   "Whether numbers have units. With `si`, the default, each number that has a dimension has a unit. With `none` all numbers are written without a unit, in consistent units such as those of SI. `units` holds for the whole page.",
   "units     si"},
  {"let", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_START, value_fields, "= EXPRESSION, or WORD", 0, false, apply_let,
   "Gives a name to a number or a word. In the lines below, $NAME stands for the value, and expressions use NAME. --set NAME=VALUE on the command line overrides the value.\n"
   "EXPRESSION: a number with its unit, or an expression such as `2*R`.\n"
   "WORD: a word such as the name of a law, without `=`: `let law linear`.",
   "let       angle = 17 deg\nlet       grip = tan(angle)"},
  {"sweep", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_START, value_fields, "{with NAME …} VALUE …", 0, false, apply_sweep,
   "Gives a name several values, one for each run. Several sweeps make all combinations; the last sweep varies fastest. --set NAME=VALUE selects the runs with this value; if there are none, all runs get this value.\n"
   "with NAME …: further names; a sweep has up to 16 names in all. Each run then takes one value for each name, in the order of the names.\n"
   "VALUE …: the values: all numbers, or all words.",
   "sweep     speed 0.1 m/s 0.2 m/s"},
  {"trade", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_START, trade_fields, "VALUE …, or laws all|none", 0, false, apply_trade,
   "Lists other values of a name, which `nineball advise` may choose if the run is then cheaper and the error stays within the tolerance. `trade` changes no run. On the command line: --set 'trade=NAME VALUE …'.\n"
   "VALUE …: other values of the name. The name `soften`, which a page need not define, divides all stiffnesses by the values.\n"
   "laws all|none: `all`: the advice may change the contact laws, also with `--over`; `none`: it keeps the contact laws of the page. Without this statement: `none` with `--over`, and where the page sweeps its laws; else `all`.",
   "let       rate = 1\ntrade     rate 3 10"},
  {0},
};
/* clang-format on */
