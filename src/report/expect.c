/* The expect blocks of a page.
 *
 *   reference NAME            here
 *   MEASURE EXPECTATION       expect_table.c, what there is; expect_take.c, the parts
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

static bool take_kind(struct nb_reader *reader, const struct reading *reading, struct nb_expectation *expectation) {
  char words[256] = "";
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++) {
    if (nb_token_is(reader, row->word)) {
      expectation->kind = row->kind;
      return row->take(reader, reading->scene, expectation);
    }
    const size_t length = strlen(words);
    snprintf(words + length, sizeof words - length, "%s`%s`", !length ? "" : row[1].word ? ", " : " or ", row->word);
  }
  nb_expected(reader, NULL, "%s", words);
  return false;
}

static void apply_expectation(struct nb_reader *reader, const struct nb_record *record, void *subject) {
  const struct reading *reading = subject;
  struct nb_expectations *all = reading->expectations;
  struct nb_expectation expectation = {.line = (int)reader->line};
  (void)record;
  if (!nb_take_measure(reader, reading->scene, &expectation.measure) || !take_kind(reader, reading, &expectation))
    return;
  NB_APPEND(reader, all->list, all->count, expectation);
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
    {"reference", NB_IN_EXPECT, reference, NULL, 0, false, apply_reference,
     "The judge: a file of cases/refs; `nineball list` names them.", "reference  two_wall_compression"},
    {NULL, NB_IN_EXPECT, nothing, "MEASURE EXPECTATION", 0, false, apply_expectation, "What should be seen.", NULL},
    {0},
};

const struct nb_family *nb_expect_keywords(void) {
  static const struct nb_family families[] = {{table}, {NULL}};
  return families;
}

enum nb_status nb_expectations_read(struct nb_expectations *expectations, const struct nb_page *page,
                                    const struct nb_scene *scene, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->made;
  *expectations = (struct nb_expectations){0};
  struct reading reading = {expectations, scene};
  struct nb_reader *reader = calloc(1, sizeof *reader);
  if (!reader) {
    nb_mistake_memory(mistakes);
    return NB_NO_MEMORY;
  }
  reader->page = page, reader->mistakes = mistakes, reader->unitless = scene->unitless;
  reader->bindings = scene->bindings, reader->binding_count = scene->binding_count;
  bool sought = true; /* a wrong line of two words was meant to name a reference: an expectation has three or more */
  for (size_t line = 1; line <= page->line_count && !scene->followed; line++)
    if (page->kind_of[line - 1] == 1 + NB_BLOCK_EXPECT && nb_line_read(reader, line)) {
      nb_statement_read(reader, nb_expect_keywords(), NB_IN_EXPECT, &reading);
      sought = sought && !(reader->bad && reader->count == 2);
    }
  for (size_t k = 0; k < expectations->count && sought && !expectations->reference; k++) {
    const enum nb_expectation_kind kind = expectations->list[k].kind;
    const bool judged = kind == NB_WITHIN || kind == NB_ALONG || kind == NB_ORDER;
    if (judged && !expectations->list[k].measure.vanishes) {
      nb_line_mistake(reader, expectations->list[k].line, "put `reference NAME` before it; `nineball list` names them",
                      "expected a `reference` in this page, found none to compare with");
      sought = false;
    }
  }
  free(reader);
  const enum nb_status status = nb_mistakes_status(mistakes, before);
  if (status)
    nb_expectations_free(expectations);
  return status;
}

void nb_expectations_free(struct nb_expectations *expectations) {
  free(expectations->list);
  *expectations = (struct nb_expectations){0};
}
