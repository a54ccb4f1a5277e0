/* The expect blocks of a page.
 *
 *   reference NAME
 *   MEASURE within TOLERANCE
 *   QUANTITY along COLUMN {in STAGE} within TOLERANCE
 *   MEASURE stated NUMBER {UNIT} {of MEASURE} within TOLERANCE [SOURCE]
 *   MEASURE below MEASURE    |  above
 *   MEASURE rises with NAME  |  falls with NAME  |  same over NAME within TOLERANCE
 *
 * MEASURE is QUANTITY {max|min|mean|last|amplitude|frequency|at N cycles|at TIME} {in STAGE}.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "expect.h"

#include <stdlib.h>
#include <string.h>

#include "expect_take.h"
#include "reference.h"

struct reading {
  struct nb_expectations *expectations;
  const struct nb_scene *scene;
};

static bool take_swept(struct nb_reader *reader, const struct reading *reading, struct nb_expectation *expectation) {
  char hint[NB_HINT_SIZE];
  const struct nb_token *token = nb_take(reader, "the name of a `sweep`");
  if (!token)
    return false;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (size_t k = 0; k < reading->scene->binding_count; k++) {
    const struct nb_binding *binding = &reading->scene->bindings[k];
    if (binding->sweep < 0)
      continue;
    if (strcmp(binding->name, token->text) == 0) {
      snprintf(expectation->along, sizeof expectation->along, "%s", token->text);
      return true;
    }
    nb_guess_offer(&guess, binding->name);
  }
  nb_token_mistake(reader, token, nb_guess_hint(&guess, hint), "expected the name of a `sweep`, found `%s`",
                   token->text);
  reader->next = reader->count;
  return false;
}

/* `[CS79 figure 6]`, several tokens. */
static bool take_source(struct nb_reader *reader, struct nb_expectation *expectation) {
  const struct nb_token *token = nb_token_peek(reader);
  if (!token || token->text[0] != '[') {
    nb_expected(reader, "a number from a paper names its place: `[CS79 figure 6]`", "the source in brackets");
    return false;
  }
  while ((token = nb_token_peek(reader))) {
    const size_t length = strlen(expectation->source);
    snprintf(expectation->source + length, sizeof expectation->source - length, "%s%s", length ? " " : "", token->text);
    reader->next++;
    if (token->text[strlen(token->text) - 1] == ']')
      return true;
  }
  nb_expected(reader, NULL, "a closing bracket `]`");
  return false;
}

static bool take_stated(struct nb_reader *reader, const struct reading *reading, struct nb_expectation *expectation) {
  const struct nb_token *number = nb_token_peek(reader);
  const bool share = number && reader->next + 1 < reader->count &&
                     (strcmp(number[1].text, "of") == 0 || strcmp(number[1].text, "%") == 0);
  if (!(share ? nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &expectation->stated)
              : nb_take_in(reader, expectation->measure.unit, &expectation->stated)))
    return false;
  if (nb_token_skip(reader, "of")) {
    expectation->has_scale = true;
    if (!nb_take_measure(reader, reading->scene, &expectation->other))
      return false;
  } else if (share) {
    nb_expected(reader, "a share is of something: `15 % of C.normal mean`", "`of` and a quantity");
    return false;
  }
  return nb_take_tolerance(reader, expectation->has_scale ? "1" : expectation->measure.unit, &expectation->tolerance) &&
         take_source(reader, expectation);
}

static bool take_kind(struct nb_reader *reader, const struct reading *reading, struct nb_expectation *expectation) {
  const char *unit = expectation->measure.unit;
  if (nb_token_is(reader, "within")) {
    expectation->kind = NB_WITHIN;
    return nb_take_tolerance(reader, unit, &expectation->tolerance);
  }
  if (nb_token_skip(reader, "along")) {
    const struct nb_token *token = nb_take(reader, "a quantity that the scene records");
    expectation->kind = NB_ALONG;
    if (!token || !nb_find_column(reader, reading->scene, token, &expectation->along_column))
      return false;
    snprintf(expectation->along, sizeof expectation->along, "%s", token->text);
    return nb_take_stage(reader, reading->scene, &expectation->measure) &&
           nb_take_tolerance(reader, unit, &expectation->tolerance);
  }
  if (nb_token_skip(reader, "stated")) {
    expectation->kind = NB_STATED;
    return take_stated(reader, reading, expectation);
  }
  if (nb_token_is(reader, "below") || nb_token_is(reader, "above")) {
    expectation->kind = nb_token_is(reader, "below") ? NB_LESS : NB_MORE;
    reader->next++;
    return nb_take_measure(reader, reading->scene, &expectation->other);
  }
  if (nb_token_is(reader, "rises") || nb_token_is(reader, "falls")) {
    expectation->kind = nb_token_is(reader, "rises") ? NB_RISES : NB_FALLS;
    reader->next++;
    return nb_take_word(reader, "with") && take_swept(reader, reading, expectation);
  }
  if (nb_token_skip(reader, "same")) {
    expectation->kind = NB_SAME;
    return nb_take_word(reader, "over") && take_swept(reader, reading, expectation) &&
           nb_take_tolerance(reader, unit, &expectation->tolerance);
  }
  nb_expected(reader, NULL, "`within`, `along`, `stated`, `below`, `above`, `rises`, `falls` or `same`");
  return false;
}

static void apply_expectation(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  struct nb_expectations *all = reading->expectations;
  struct nb_expectation expectation = {.line = (int)reader->line};
  (void)record;
  if (!nb_take_measure(reader, reading->scene, &expectation.measure) || !take_kind(reader, reading, &expectation))
    return;
  struct nb_expectation *list = nb_room(all->list, all->count, 1, sizeof *list);
  if (!list) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "there is not enough memory for this");
    return;
  }
  all->list = list;
  all->list[all->count++] = expectation;
}

static void apply_reference(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  const struct nb_token *token = record->value[0].token;
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token->text);
  reading->expectations->reference = nb_reference_find(token->text);
  reading->expectations->reference_line = (int)reader->line;
  if (reading->expectations->reference)
    return;
  for (const struct nb_reference *const *reference = nb_references(); *reference; reference++)
    nb_guess_offer(&guess, (*reference)->name);
  const char *near = nb_guess_hint(&guess, hint);
  nb_token_mistake(reader, token, near ? near : "`nineball list` names them all",
                   "expected the name of a reference, found `%s`", token->text);
}

static const struct nb_argument reference[] = {
    {NULL, "NAME", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, 0, 1, NULL, "the name of a reference"},
    {NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL},
};
static const struct nb_argument nothing[] = {{NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL}};

static const struct nb_keyword table[] = {
    {"reference", NB_IN_EXPECT, reference, NULL, 0, false, apply_reference, "The judge: a file of cases/refs."},
    {NULL, NB_IN_EXPECT, nothing, "MEASURE EXPECTATION", 0, false, apply_expectation, "What should be seen."},
    {0},
};

enum nb_status nb_expectations_read(struct nb_expectations *expectations, const struct nb_page *page,
                                    const struct nb_scene *scene, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->count;
  *expectations = (struct nb_expectations){0};
  struct reading reading = {expectations, scene};
  struct nb_reader *reader = calloc(1, sizeof *reader);
  if (!reader) {
    nb_mistake(mistakes, page, 0, 0, 0, NULL, "there is not enough memory to read this page");
    return NB_BAD_USE;
  }
  reader->page = page, reader->mistakes = mistakes, reader->unitless = scene->unitless;
  reader->bindings = scene->bindings, reader->binding_count = scene->binding_count;
  for (size_t line = 1; line <= page->line_count; line++)
    if (page->kind_of[line - 1] == 1 + NB_BLOCK_EXPECT && nb_line_read(reader, line))
      nb_statement_read(reader, table, NB_IN_EXPECT, &reading);
  for (size_t k = 0; k < expectations->count; k++) {
    const enum nb_expectation_kind kind = expectations->list[k].kind;
    if ((kind == NB_WITHIN || kind == NB_ALONG) && !expectations->reference && mistakes->count == before) {
      nb_line_read(reader, (size_t)expectations->list[k].line);
      nb_token_mistake(reader, &reader->tokens[0], "put `reference NAME` before it; `nineball list` names them",
                       "expected a `reference` in this page, found none to compare with");
    }
  }
  free(reader);
  if (mistakes->count == before)
    return NB_OK;
  nb_expectations_free(expectations);
  return NB_BAD_USE;
}

void nb_expectations_free(struct nb_expectations *expectations) {
  free(expectations->list);
  *expectations = (struct nb_expectations){0};
}
