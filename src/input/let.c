/* Values with a name: `units`, `let`, `sweep`, and --set, which overrides them.
 *
 * A sweep is a small table: its rows are taken in turn, its columns are names. The runs of a page are the product of
 * its sweeps, the last one fastest. Which row a run takes depends on the length of the sweeps below, so a page is read
 * twice.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

enum { SWEPT_MAX = 16 }; /* names in one sweep */

enum { AT_NAME };
static const struct nb_argument units_fields[] = {CHOICE(NULL, "none|si", AT_NAME, NULL, "`none` or `si`"), END};
static const struct nb_argument value_fields[] = {NAME(AT_NAME, "a name for the value"), END};

NB_APPLY(apply_units) {
  struct nb_scene_reading *reading = subject;
  if (nb_said_twice(reader, reading->units_line))
    return;
  reading->units_line = (int)reader->line;
  reading->reader.unitless = reading->setting.unitless = record->value[AT_NAME].number == 0;
}

/* One word, or a number and its unit, as one text; where it began in *token. False: it is none, and that has been
 * said. */
static bool take_value(struct nb_reader *reader, char text[NB_NAME_SIZE], const struct nb_token **token) {
  double number;
  text[0] = '\0';
  *token = nb_take(reader, "a value: a word, or a number and its unit");
  if (!*token)
    return false;
  const bool counts = nb_number_read(&number, (*token)->text, 0) == NB_READ;
  const struct nb_token *unit = nb_token_peek(reader);
  const bool with_unit = counts && unit && nb_unit_find(unit->text);
  const int n =
      snprintf(text, NB_NAME_SIZE, "%s%s%s", (*token)->text, with_unit ? " " : "", with_unit ? unit->text : "");
  reader->next += with_unit;
  return n < NB_NAME_SIZE ||
         nb_token_mistake(reader, *token, NULL, "expected a value shorter than %d bytes, found `%.80s`", NB_NAME_SIZE,
                          (*token)->text);
}

static void bind(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name,
                 const char *text, bool swept, int sweep) {
  struct nb_scene *scene = reading->scene;
  struct nb_binding binding = {.swept = swept, .sweep = sweep};
  if (NB_FIND(scene->bindings, scene->binding_count, name->text) >= 0)
    nb_token_mistake(reader, name, NULL, "the name `%s` already has a value", name->text);
  if (nb_too_many(reader, scene->binding_count, NB_NAMED_MAX, "names for values"))
    return;
  snprintf(binding.name, sizeof binding.name, "%s", name->text);
  snprintf(binding.text, sizeof binding.text, "%s", text);
  NB_APPEND(reader, scene->bindings, scene->binding_count, binding);
  reading->reader.bindings = scene->bindings, reading->reader.binding_count = scene->binding_count;
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

/* Whether a --set gives the value of that name; then it is in text. One that is wrong is said, and the statement is bad. */
static bool set_value(struct nb_scene_reading *reading, struct nb_reader *reader, const char *name,
                      char text[NB_NAME_SIZE]) {
  struct nb_reader *setting = &reading->setting;
  size_t line = nb_setting_find(reading, name);
  const struct nb_token *token;
  if (!line)
    return false;
  nb_line_read(setting, line);
  setting->next = 1;
  if (take_value(setting, text, &token) && nb_token_peek(setting))
    nb_expected(setting, NULL, "the end of the value");
  if (setting->bad)
    nb_silent(reader);
  return true;
}

NB_APPLY(apply_let) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *name = record->value[AT_NAME].token, *token;
  char text[NB_NAME_SIZE], set[NB_NAME_SIZE];
  if (take_value(reader, text, &token) && nb_token_peek(reader))
    nb_expected(reader, "several values want a `sweep`", "the end of the line");
  const bool is_set = set_value(reading, reader, name->text, set);
  if (!reader->bad)
    bind(reading, reader, name, is_set ? set : text, false, -1);
}

/* a b, but never more than one too many. */
static size_t times(size_t a, size_t b) { return a * b > NB_RUNS_MAX ? NB_RUNS_MAX + 1 : a * b; }

/* Which row of this sweep the run takes; in the survey it is the first one, and the number of rows is kept. */
static size_t row_of(struct nb_scene_reading *reading, struct nb_reader *reader, size_t rows) {
  size_t sweep = reading->sweep++, above = 1, below = 1;
  if (reading->survey) {
    NB_APPEND(reader, reading->rows, reading->sweep_count, rows);
    return 0;
  }
  for (size_t i = 0; i < sweep && i < reading->sweep_count; i++)
    above = times(above, reading->rows[i]);
  for (size_t i = sweep + 1; i < reading->sweep_count; i++)
    below = times(below, reading->rows[i]);
  if (above <= NB_RUNS_MAX && times(above, rows) > NB_RUNS_MAX)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d runs, the sweeps up to this one make %zu",
                     NB_RUNS_MAX, above * rows);
  return reading->run / below % rows;
}

size_t nb_runs(const struct nb_scene_reading *reading) {
  size_t runs = 1;
  for (size_t i = 0; i < reading->sweep_count; i++)
    runs = times(runs, reading->rows[i]);
  return runs;
}

/* A column holds numbers or words, not both: a word among numbers is a mistyped unit. */
static bool same_sort(struct nb_reader *reader, const struct nb_token *first, const struct nb_token *token) {
  double number;
  char hint[NB_HINT_SIZE];
  const bool counts = nb_number_read(&number, token->text, 0) == NB_READ;
  if (counts == (nb_number_read(&number, first->text, 0) == NB_READ))
    return true;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (const struct nb_unit *unit = nb_units(); unit->name; unit++)
    nb_guess_offer(&guess, unit->name);
  if (counts)
    return nb_expected_at(reader, token, NULL, "a word as the value before it");
  return nb_expected_at(reader, token, nb_guess_hint(&guess, hint),
                        "a number or a unit, as the value before it is a number");
}

/* Two equal rows are one run made twice, which would count twice among the runs of a sample. */
static bool all_differ(struct nb_reader *reader, char (*texts)[NB_NAME_SIZE], const struct nb_token *const tokens[],
                       size_t count, size_t columns) {
  double numbers[NB_TOKENS_MAX];
  for (size_t i = 0; i < count; i++)
    numbers[i] = nb_value_number(texts[i]);
  for (size_t row = columns; row < count; row += columns)
    for (size_t above = 0; above < row; above += columns) {
      size_t equal = 0;
      while (equal < columns &&
             (numbers[row + equal] == numbers[above + equal] || strcmp(texts[row + equal], texts[above + equal]) == 0))
        equal++;
      if (equal < columns)
        continue;
      return nb_token_mistake(reader, tokens[row], NULL, "turns %zu and %zu of this sweep have equal values",
                              above / columns + 1, row / columns + 1);
    }
  return true;
}

/* The values, row by row. Answers how many rows; 0: they are wrong. texts must hold NB_TOKENS_MAX values. */
static size_t take_rows(struct nb_reader *reader, char (*texts)[NB_NAME_SIZE], size_t columns) {
  const struct nb_token *tokens[NB_TOKENS_MAX];
  size_t count = 0;
  do {
    if (!take_value(reader, texts[count], &tokens[count]) || !same_sort(reader, tokens[count % columns], tokens[count]))
      return 0;
    count++;
  } while (nb_token_peek(reader));
  if (count % columns == 0)
    return all_differ(reader, texts, tokens, count, columns) ? count / columns : 0;
  nb_expected(reader, NULL, "a value for each of the %zu names in every turn (%zu values are not a multiple)", columns,
              count);
  return 0;
}

/* Of several names that take their values together, one that is given its value from outside chooses the turns that have it; a value
 * that none has takes the place of its own in all of them. Answers how many are left; they move to the front. */
static size_t choose(char (*texts)[NB_NAME_SIZE], size_t rows, size_t columns, const bool is_set[],
                     char (*set)[NB_NAME_SIZE]) {
  for (size_t i = 0; i < columns; i++) {
    size_t left = 0;
    for (size_t row = 0; row < rows && is_set[i]; row++)
      left += strcmp(texts[row * columns + i], set[i]) == 0;
    if (left == 0)
      continue;
    left = 0;
    for (size_t row = 0; row < rows; row++)
      if (strcmp(texts[row * columns + i], set[i]) == 0)
        memmove(texts[left++ * columns], texts[row * columns], columns * sizeof *texts);
    rows = left;
  }
  return rows;
}

NB_APPLY(apply_sweep) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *names[SWEPT_MAX] = {record->value[AT_NAME].token};
  char texts[NB_TOKENS_MAX][NB_NAME_SIZE], set[SWEPT_MAX][NB_NAME_SIZE];
  bool is_set[SWEPT_MAX], all_set = true;
  size_t columns = 1;
  while (nb_token_skip(reader, "with")) {
    if (columns == SWEPT_MAX)
      nb_expected(reader, NULL, "at most %d names in a sweep", SWEPT_MAX);
    else
      names[columns] = nb_take_name(reader, "a name for the value");
    columns += !reader->bad;
  }
  size_t rows = reader->bad ? 0 : take_rows(reader, texts, columns);
  for (size_t i = 0; i < columns && !reader->bad; i++) {
    is_set[i] = set_value(reading, reader, names[i]->text, set[i]);
    all_set = all_set && is_set[i];
  }
  if (reader->bad)
    return;
  rows = choose(texts, rows, columns, is_set, set);
  const size_t turns = all_set ? 1 : rows, row = row_of(reading, reader, turns);
  for (size_t i = 0; i < columns; i++)
    bind(reading, reader, names[i], is_set[i] ? set[i] : texts[row * columns + i], turns > 1 && !is_set[i],
         (int)reading->sweep - 1);
}

/* What stands in a --set for a statement of the page. */
static const struct { char name[NB_NAME_SIZE]; } settable[] = {{"normal"}, {"shear"}, {"step"}};
enum { SETTABLE = sizeof settable / sizeof *settable };

/* NAME=VALUE in a line of the settings. */
static void read_setting(struct nb_scene_reading *reading, size_t line) {
  const struct nb_scene *scene = reading->scene;
  struct nb_mistakes *mistakes = reading->setting.mistakes;
  char name[NB_NAME_SIZE] = "", hint[NB_HINT_SIZE];
  const char *text = reading->settings.lines[line - 1], *equals = strchr(text, '=');
  const size_t length = strcspn(text, "=");
  if (length < sizeof name)
    memcpy(name, text, length);
  const char *near = NB_NEAREST(hint, name, scene->bindings, scene->binding_count);
  if (!equals) {
    nb_mistake(mistakes, &reading->settings, line, 1, (int)length, NULL, "expected NAME=VALUE, found `%.80s`", text);
  } else if (NB_FIND(scene->bindings, scene->binding_count, name) >= 0 || nb_excused(reading->reader.mistakes, name)) {
    return; /* which `let` or `sweep` looks for */
  } else if (NB_FIND(settable, SETTABLE, name) >= 0) {
    if (line == nb_setting_find(reading, name) && nb_line_read(&reading->setting, line))
      nb_statement_read(&reading->setting, nb_keywords(), reading->here, reading);
  } else if (strcmp(name, "follow") == 0) {
    reading->follow = equals + 1;
    if (!scene->path)
      nb_mistake(mistakes, &reading->settings, line, 1, (int)length, "a path is a block of kind `path`",
                 "expected a page with a path for `follow`, found a scene");
  } else {
    nb_mistake(mistakes, &reading->settings, line, 1, (int)length,
               near ? near : NB_NEAREST(hint, name, settable, SETTABLE),
               "expected a name that the page gives by `let` or `sweep`, or `normal`, `shear` or `step`, found `%.*s`",
               (int)(length < 80 ? length : 80), text);
  }
}

void nb_settings_read(struct nb_scene_reading *reading) {
  for (size_t line = 1; line <= reading->settings.line_count; line++)
    read_setting(reading, line);
}

/* clang-format off */
NB_STATEMENTS(let) = {
  {"units", NB_IN_SCENE | NB_IN_PATH, units_fields, NULL, 0, false, apply_units,
   "Whether numbers carry units: `si`, the default, or `none`, with which all numbers are bare. It holds for the "
   "whole page.",
   "units     si"},
  {"let", NB_IN_SCENE | NB_IN_PATH | NB_IN_START, value_fields, "VALUE", 0, false, apply_let,
   "Gives a name to a value, a word or a number and its unit. $NAME stands for it below; --set NAME=VALUE "
   "overrides it.",
   "let       grip 0.3"},
  {"sweep", NB_IN_SCENE | NB_IN_PATH | NB_IN_START, value_fields, "{with NAME …} VALUE …", 0, false, apply_sweep,
   "Gives a name several values in turn, one run each; several names take their values together, and giving one of them a value by --set chooses what goes with it. Several sweeps make "
   "the product, the last one fastest.",
   "sweep     speed 0.1 m/s 0.2 m/s"},
  {0},
};
/* clang-format on */
