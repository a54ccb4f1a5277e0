/* The parts of an expectation: what is measured, and how near it must be.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "expect_take.h"

#include <string.h>

static void append(struct nb_measure *measure, const char *format, const char *word) {
  const size_t length = strlen(measure->label);
  snprintf(measure->label + length, sizeof measure->label - length, format, word);
}

bool nb_find_column(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_token *token,
                    size_t *column, struct nb_quantity *quantity) {
  for (size_t c = 0; c < scene->column_count; c++)
    if (strcmp(scene->columns[c].name, token->text) == 0) {
      *column = c, *quantity = scene->columns[c].quantity;
      return true;
    }
  char nearest[2 * NB_NAME_SIZE] = "", hint[NB_HINT_SIZE];
  const bool known = nb_quantity_find(quantity, scene, token->text, nearest);
  if (nb_excused(reader->mistakes, token->text) || (known && nb_excused(reader->mistakes, "record")))
    return nb_silent(reader);
  nb_excuse(reader->mistakes, token->text);
  if (known)
    snprintf(hint, sizeof hint, "add `record %s` to the scene", token->text);
  else if (nearest[0])
    snprintf(hint, sizeof hint, "did you mean `%s`?", nearest);
  else
    snprintf(hint, sizeof hint, "`record` names the quantities that can be expected");
  return nb_token_mistake(reader, token, hint, "expected a quantity that the scene records, found `%s`", token->text);
}

bool nb_take_stage(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  measure->stage = -1;
  if (!nb_token_skip(reader, "in"))
    return true;
  const struct nb_token *token = nb_take(reader, "the name of a stage");
  if (!token)
    return false;
  measure->stage = NB_FIND(scene->stages, scene->stage_count, token->text);
  if (measure->stage < 0 && strcmp(token->text, "all") == 0)
    measure->stage = NB_STAGE_ALL;
  if (measure->stage == -1) {
    char hint[NB_HINT_SIZE];
    if (nb_excused(reader->mistakes, "repeat"))
      return nb_silent(reader);
    return nb_not_known(reader, token, NB_NEAREST(hint, token->text, scene->stages, scene->stage_count),
                        "the name of a stage");
  }
  append(measure, " in %s", token->text);
  return true;
}

static bool take_moment(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  char text[NB_NAME_SIZE];
  const struct nb_token *number = nb_token_peek(reader), *unit = number ? number + 1 : NULL;
  const bool cycles = number && reader->next + 1 < reader->count &&
                      (scene->path ? strcmp(unit->text, "steps") == 0 || strcmp(unit->text, "step") == 0
                                   : strcmp(unit->text, "cycles") == 0 || strcmp(unit->text, "cycle") == 0);
  if (scene->path && !cycles) {
    nb_expected(reader, "on the bench there is no time: `at 10 steps`", "a number and `steps`");
    return false;
  }
  if (cycles) {
    unsigned long count;
    if (!nb_take_count(reader, 0, 1000000000, &count))
      return false;
    reader->next++;
    measure->reducer = NB_AT_CYCLE, measure->at = (double)count;
    snprintf(text, sizeof text, "%lu %s", count, scene->path ? "steps" : "cycles");
  } else {
    if (!nb_take_number(reader, NB_UNIT_TIME, NB_NOT_NEGATIVE, &measure->at))
      return false;
    measure->reducer = NB_AT_TIME;
    snprintf(text, sizeof text, reader->unitless ? "%g" : "%g s", measure->at);
  }
  append(measure, " at %s", text);
  return true;
}

/* A word that is no reducer, and nothing that may follow one. */
static bool unknown_reducer(struct nb_reader *reader, bool reduced) {
  char hint[NB_HINT_SIZE], words[256] = "";
  const struct nb_token *token = nb_token_peek(reader);
  if (!token || strcmp(token->text, "in") == 0 || strcmp(token->text, "among") == 0 || token->text[0] == '[')
    return false; /* of a stated number the source may follow */
  struct nb_guess guess = nb_guess_begin(token->text);
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++) {
    if (strcmp(row->word, token->text) == 0)
      return false;
    nb_guess_offer(&guess, row->word);
    const size_t length = strlen(words);
    snprintf(words + length, sizeof words - length, "%s`%s`", length ? ", " : "", row->word);
  }
  nb_guess_offer(&guess, "in");
  if (reduced) {
    nb_expected(reader, nb_guess_hint(&guess, hint), "`in`, or what is expected (%s)", words);
    return true;
  }
  nb_guess_offer(&guess, "at");
  for (const struct nb_reducer_row *row = nb_reducer_rows(); row->word; row++)
    nb_guess_offer(&guess, row->word);
  nb_expected(reader, nb_guess_hint(&guess, hint),
              "`max`, `min`, `mean`, `last`, `amplitude`, `frequency`, `at`, `in`, or what is expected (%s)", words);
  return true;
}

bool nb_take_measure(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure) {
  const struct nb_token *token = nb_take(reader, "a quantity that the scene records");
  *measure = (struct nb_measure){.stage = -1};
  struct nb_quantity quantity;
  if (!token || !nb_find_column(reader, scene, token, &measure->column, &quantity))
    return false;
  measure->unit = nb_quantity_unit(quantity);
  measure->vanishes = nb_quantity_vanishes(quantity);
  append(measure, "%s", token->text);
  bool reduced = false;
  for (const struct nb_reducer_row *row = nb_reducer_rows(); row->word && !reduced; row++) {
    reduced = nb_token_skip(reader, row->word);
    if (!reduced)
      continue;
    measure->reducer = row->reducer;
    if (measure->reducer != NB_LAST)
      append(measure, " %s", row->word);
    if (measure->reducer == NB_FREQUENCY)
      measure->unit = "1/s";
  }
  if (!reduced && nb_token_skip(reader, "at"))
    return take_moment(reader, scene, measure) && nb_take_stage(reader, scene, measure);
  return !unknown_reducer(reader, reduced) && nb_take_stage(reader, scene, measure);
}

/* `within 0.1 %`, `within 2 nm`, `within 1e-12`, `within 0.5 % of peak` */
bool nb_take_tolerance(struct nb_reader *reader, const struct nb_scene *scene, const char *unit,
                       struct nb_tolerance *tolerance) {
  if (!nb_take_word(reader, "within"))
    return false;
  const size_t from = reader->next;
  const struct nb_token *number = nb_token_peek(reader);
  const bool share = number && from + 1 < reader->count &&
                     (strcmp(number[1].text, "%") == 0 || strcmp(number[1].text, "ppm") == 0 ||
                      (scene && strcmp(number[1].text, "of") == 0));
  if (share) {
    if (!nb_take_number(reader, NB_UNIT_NUMBER, NB_NOT_NEGATIVE, &tolerance->value))
      return false;
    tolerance->kind = NB_RELATIVE;
    if (scene && nb_token_skip(reader, "of")) {
      const bool of_measure = !nb_token_is(reader, "peak");
      if (of_measure ? !nb_take_measure(reader, scene, &tolerance->of) : !nb_take_word(reader, "peak"))
        return false;
      tolerance->kind = of_measure ? NB_OF_MEASURE : NB_OF_PEAK;
    }
  } else {
    if (!nb_take_in(reader, unit, &tolerance->value))
      return false;
    tolerance->kind = NB_ABSOLUTE;
  }
  tolerance->text[0] = 0;
  for (size_t k = from; k < reader->next; k++) {
    const size_t length = strlen(tolerance->text);
    snprintf(tolerance->text + length, sizeof tolerance->text - length, "%s%s", k > from ? " " : "",
             reader->tokens[k].text);
  }
  if (!(tolerance->value >= 0)) {
    nb_token_mistake(reader, &reader->tokens[from], NULL, "expected a tolerance of 0 or more, found `%s`",
                     tolerance->text);
    return false;
  }
  return true;
}
