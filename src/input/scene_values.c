/* Values with a name: units, let, sweep, and --set, which overrides them.
 *
 * A sweep is a small table: its rows are taken in turn, its columns are names. The runs of a page are the product of
 * its sweeps, the last one fastest. Which row a run takes depends on the length of the sweeps below, so a page is read
 * twice.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

enum { SWEPT_MAX = 16 }; /* names in one sweep */

NB_APPLY(nb_apply_units) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *word = record->value[AT_NAME].token;
  char hint[NB_HINT_SIZE];
  bool none = strcmp(word->text, "none") == 0;
  if (!none && strcmp(word->text, "si") != 0) {
    struct nb_guess guess = nb_guess_begin(word->text);
    nb_guess_offer(&guess, "none");
    nb_guess_offer(&guess, "si");
    reader->next = (size_t)(word - reader->tokens);
    nb_expected(reader, nb_guess_hint(&guess, hint), "`none` or `si`");
  } else if (reading->units_line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`units` is said twice: first on line %d", reading->units_line);
  } else {
    reading->units_line = (int)reader->line;
    reading->reader.unitless = reading->setting.unitless = none;
  }
}

/* One word, or a number and its unit, as one text; where it began in *token. False: it is none, and that has been
 * said. */
static bool take_value(struct nb_reader *reader, char text[NB_NAME_SIZE], const struct nb_token **token) {
  double number;
  text[0] = '\0';
  *token = nb_take(reader, "a value: a word, or a number and its unit");
  if (!*token || (*token)->hollow)
    return false;
  bool counts = nb_number_read(&number, (*token)->text, 0) == NB_READ;
  const struct nb_token *unit = nb_token_peek(reader);
  bool with_unit = counts && unit && !unit->hollow && nb_unit_find(unit->text);
  int n = snprintf(text, NB_NAME_SIZE, "%s%s%s", (*token)->text, with_unit ? " " : "", with_unit ? unit->text : "");
  reader->next += with_unit;
  if (n < NB_NAME_SIZE)
    return true;
  text[0] = '\0';
  nb_token_mistake(reader, *token, NULL, "expected a value shorter than %d bytes, found `%.80s`", NB_NAME_SIZE,
                   (*token)->text);
  return false;
}

/* The name is taken even when the value is not known: then it is hollow. */
static void bind(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name,
                 const char *text, bool swept, int sweep) {
  struct nb_scene *scene = reading->scene;
  for (size_t i = 0; i < scene->binding_count; i++)
    if (strcmp(scene->bindings[i].name, name->text) == 0) {
      nb_token_mistake(reader, name, NULL, "the name `%s` already has a value", name->text);
      return;
    }
  if (nb_too_many(reader, scene->binding_count, NB_NAMED_MAX, "names for values"))
    return;
  struct nb_binding *bindings = nb_room(scene->bindings, scene->binding_count, 1, sizeof *bindings);
  if (!bindings) {
    nb_no_memory(reader);
    return;
  }
  scene->bindings = bindings;
  struct nb_binding *binding = &bindings[scene->binding_count++];
  memset(binding, 0, sizeof *binding);
  snprintf(binding->name, sizeof binding->name, "%s", name->text);
  snprintf(binding->text, sizeof binding->text, "%s", text);
  binding->swept = swept;
  binding->sweep = sweep;
  reading->reader.bindings = bindings;
  reading->reader.binding_count = scene->binding_count;
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

/* Whether a --set gives the value of that name; then it is in text, empty when it is wrong. */
static bool set_value(struct nb_scene_reading *reading, const char *name, char text[NB_NAME_SIZE]) {
  struct nb_reader *reader = &reading->setting;
  size_t line = nb_setting_find(reading, name);
  const struct nb_token *token;
  if (!line)
    return false;
  nb_line_read(reader, line);
  reader->next = 1;
  if (take_value(reader, text, &token) && nb_token_peek(reader)) {
    nb_expected(reader, NULL, "the end of the value");
    text[0] = '\0';
  }
  return true;
}

NB_APPLY(nb_apply_let) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *name = record->value[AT_NAME].token, *value;
  char text[NB_NAME_SIZE], set[NB_NAME_SIZE];
  if (!name)
    return;
  bool whole = take_value(reader, text, &value) && !nb_token_peek(reader);
  if (!whole && nb_token_peek(reader)) {
    nb_expected(reader, "several values want a `sweep`", "the end of the line");
    text[0] = '\0';
  }
  bind(reading, reader, name, set_value(reading, name->text, set) ? set : text, false, -1);
}

/* a b, but never more than one too many. */
static size_t times(size_t a, size_t b) { return a * b > NB_RUNS_MAX ? NB_RUNS_MAX + 1 : a * b; }

/* Which row of this sweep the run takes; in the survey it is the first one, and the number of rows is kept. */
static size_t row_of(struct nb_scene_reading *reading, struct nb_reader *reader, size_t rows) {
  size_t sweep = reading->sweep++, above = 1, below = 1;
  if (reading->survey) {
    size_t *grown = nb_room(reading->rows, reading->sweep_count, 1, sizeof *grown);
    if (!grown)
      return nb_no_memory(reader), 0;
    reading->rows = grown;
    grown[reading->sweep_count++] = rows;
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
static bool same_sort(struct nb_reader *reader, const struct nb_token *first, const struct nb_token *value) {
  double number;
  char hint[NB_HINT_SIZE];
  bool counts = nb_number_read(&number, value->text, 0) == NB_READ;
  if (counts == (nb_number_read(&number, first->text, 0) == NB_READ))
    return true;
  struct nb_guess guess = nb_guess_begin(value->text);
  for (const struct nb_unit *unit = nb_units(); unit->name; unit++)
    nb_guess_offer(&guess, unit->name);
  reader->next = (size_t)(value - reader->tokens);
  if (counts)
    nb_expected(reader, NULL, "a word as the value before it");
  else
    nb_expected(reader, nb_guess_hint(&guess, hint), "a number or a unit, as the value before it is a number");
  return false;
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
      nb_token_mistake(reader, tokens[row], NULL, "turns %zu and %zu of this sweep have equal values",
                       above / columns + 1, row / columns + 1);
      return false;
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

NB_APPLY(nb_apply_sweep) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *names[SWEPT_MAX] = {record->value[AT_NAME].token};
  char texts[NB_TOKENS_MAX][NB_NAME_SIZE], set[SWEPT_MAX][NB_NAME_SIZE];
  bool is_set[SWEPT_MAX], all_set = true;
  size_t columns = 1;
  if (!names[0])
    return;
  while (nb_token_skip(reader, "with")) {
    if (columns == SWEPT_MAX) {
      nb_expected(reader, NULL, "at most %d names in a sweep", SWEPT_MAX);
      return;
    }
    names[columns] = nb_take_name(reader, "a name for the value");
    if (!names[columns])
      break;
    columns++;
  }
  size_t rows = reader->bad ? 0 : take_rows(reader, texts, columns);
  for (size_t i = 0; i < columns; i++) {
    is_set[i] = set_value(reading, names[i]->text, set[i]);
    all_set = all_set && is_set[i];
  }
  rows = choose(texts, rows, columns, is_set, set);
  size_t turns = rows == 0 || all_set ? 1 : rows, row = row_of(reading, reader, turns);
  for (size_t i = 0; i < columns; i++)
    bind(reading, reader, names[i],
         is_set[i]   ? set[i]
         : rows == 0 ? ""
                     : texts[row * columns + i],
         turns > 1 && !is_set[i], (int)reading->sweep - 1);
}

void nb_settings_read(struct nb_scene_reading *reading) {
  static const char *const statements[] = {"normal", "shear", "step"};
  enum { STATEMENTS = sizeof statements / sizeof *statements };
  const struct nb_scene *scene = reading->scene;
  struct nb_reader *reader = &reading->setting;
  for (size_t line = 1; line <= reading->settings.line_count; line++) {
    const char *text = reading->settings.lines[line - 1], *equals = strchr(text, '=');
    size_t length = equals ? (size_t)(equals - text) : strlen(text);
    char name[NB_NAME_SIZE] = "", hint[NB_HINT_SIZE];
    if (length < sizeof name)
      memcpy(name, text, length);
    if (!equals) {
      nb_mistake(reader->mistakes, &reading->settings, line, 1, (int)length, NULL, "expected NAME=VALUE, found `%.80s`",
                 text);
      continue;
    }
    struct nb_guess guess = nb_guess_begin(name);
    bool bound = false, statement = false;
    for (size_t i = 0; i < scene->binding_count && !bound; i++) {
      nb_guess_offer(&guess, scene->bindings[i].name);
      bound = strcmp(name, scene->bindings[i].name) == 0;
    }
    for (int i = 0; i < STATEMENTS && !bound && !statement; i++) {
      nb_guess_offer(&guess, statements[i]);
      statement = strcmp(name, statements[i]) == 0;
    }
    if (statement && line == nb_setting_find(reading, name)) {
      nb_line_read(reader, line);
      nb_statement_read(reader, nb_keywords(), reading->here, reading);
    } else if (equals && strcmp(name, "follow") == 0 && !bound) {
      reading->follow = equals + 1;
      if (!scene->path)
        nb_mistake(reader->mistakes, &reading->settings, line, 1, (int)length, "a path is a block of kind `path`",
                   "expected a page with a path for `follow`, found a scene");
    } else if (!bound && !statement) {
      nb_mistake(
          reader->mistakes, &reading->settings, line, 1, (int)length, nb_guess_hint(&guess, hint),
          "expected a name that the page gives by `let` or `sweep`, or `normal`, `shear` or `step`, found `%.*s`",
          (int)(length < 80 ? length : 80), text);
    }
  }
}
