/* What is in the manual, and in which order.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "manual.h"

#include <string.h>

#include "expect_take.h"
#include "input/reader.h"

/* ---- one statement ---- */

/* As far as the full stop of the first sentence: there may be one within, in an equation's number. */
static int first_sentence(const char *help) {
  const char *end = strstr(help, ". ");
  const size_t all = strlen(help);
  return (int)(end ? (size_t)(end - help) : all - (all > 0 && help[all - 1] == '.'));
}

/* "a length above 0; 2R if it is not there. From centre to centre; 2R: touching." */
static void argument(FILE *out, const struct nb_manner *manner, const struct nb_argument *field) {
  char name[128], text[512];
  snprintf(name, sizeof name, "%s%s%s", field->word ? field->word : "", field->word && field->value ? " " : "",
           field->value ? field->value : "");
  const bool number = field->kind == NB_ARGUMENT_NUMBER, count = field->kind == NB_ARGUMENT_COUNT;
  char otherwise[128] = "";
  if (field->otherwise)
    snprintf(otherwise, sizeof otherwise, "; without it: %s", field->otherwise);
  if (number || count)
    snprintf(text, sizeof text, "%s%s%s. %s", number ? nb_unit_kind_name(field->unit) : "a whole number, 1 or more",
             number ? nb_range_words(field->range) : "", otherwise, field->help);
  else
    snprintf(text, sizeof text, "%.*s%s.", first_sentence(field->help), field->help, otherwise);
  manner->part(out, name, text);
}

static void statement(FILE *out, const struct nb_manner *manner, const struct nb_keyword *keyword, bool whole) {
  char syntax[512], help[1024];
  nb_keyword_syntax(syntax, sizeof syntax, keyword);
  const bool both = keyword->where & NB_IN_SCENE && keyword->where & NB_IN_STAGE;
  const bool shared = keyword->where & (NB_IN_SCENE | NB_IN_STAGE) && keyword->where & (NB_IN_PATH | NB_IN_LEG);
  snprintf(help, sizeof help, "%s%s%s%s", keyword->help, both ? " In the scene and in stages." : "",
           keyword->where & NB_IN_RAMP ? " Also behind `ramp`." : "", shared ? " Also on the bench." : "");
  manner->item(out, keyword->word, syntax, help);
  if (!whole)
    return;
  for (const struct nb_argument *field = keyword->arguments; field->count; field++)
    argument(out, manner, field);
  if (keyword->example)
    manner->example(out,
                    keyword->where == NB_IN_EXPECT                 ? "expect"
                    : keyword->where & NB_IN_CELL                  ? "text of a scene with a cell"
                    : keyword->where & NB_APART                    ? "text of another page"
                    : keyword->where & (NB_IN_SCENE | NB_IN_STAGE) ? "scene"
                                                                   : "text of a path",
                    keyword->example);
  manner->end_item(out);
}

static void expectation(FILE *out, const struct nb_manner *manner, const struct nb_expectation_row *row, bool whole) {
  manner->item(out, row->word, row->syntax, row->help);
  if (!whole)
    return;
  manner->example(out, "expect", row->example);
  manner->end_item(out);
}

/* ---- lists ---- */

static void measures(FILE *out, const struct nb_manner *manner) {
  manner->words(
      out, "A MEASURE is `QUANTITY {REDUCER} {in STAGE}`: a quantity that the scene records, and how the rows of a "
           "stage, the last one with rows if none is named, become one number. REDUCER:");
  for (const struct nb_reducer_row *row = nb_reducer_rows(); row->word; row++)
    manner->row(out, row->word, NULL, row->help);
  manner->row(out, "at N cycles", NULL,
              "in the row of that cycle, counted from the start of the run; on the bench `at N steps`");
  manner->row(out, "at TIME", NULL, "at that time, between two rows along a straight line");
  manner->row(out, "in all", NULL, "the rows of all stages");
  manner->end_list(out);
}

static void quantities(FILE *out, const struct nb_manner *manner) {
  const char *name, *unit, *of, *help, *before = "";
  manner->section(out, "Quantities");
  manner->words(out,
                "What can be recorded, waited for and expected: the name alone for the whole scene, `WATCH.NAME` for "
                "what a `watch` has named.");
  for (size_t row = 0; nb_quantity_row(row, &name, &unit, &of, &help); row++) {
    if (strcmp(of, before) != 0) {
      char text[64];
      snprintf(text, sizeof text, "Of %s:", of);
      if (before[0])
        manner->end_list(out);
      manner->words(out, text);
    }
    manner->row(out, name, strcmp(unit, "1") == 0 ? "" : unit, help);
    before = of;
  }
  manner->end_list(out);
}

static void units(FILE *out, const struct nb_manner *manner) {
  manner->section(out, "Units");
  manner->words(
      out, "A number and its unit are two words: `0.3 mm`. All but `deg` are powers of ten of the SI unit, so that "
           "`0.3 mm` is the same double as `0.0003 m`. With `units none` all numbers are bare.");
  for (int kind = 0; kind < NB_UNIT_KINDS; kind++) {
    char list[256];
    nb_unit_list(list, sizeof list, (enum nb_unit_kind)kind);
    manner->row(out, nb_unit_kind_name((enum nb_unit_kind)kind), NULL,
                kind == NB_UNIT_NUMBER ? "bare, or with % or ppm" : list);
  }
  manner->end_list(out);
}

static void grammar(FILE *out, const struct nb_manner *manner) {
  char text[1024];
  manner->section(out, "Words");
  manner->words(out,
                "A page is Markdown. Its fenced blocks `scene` or `path`, `expect` and `gnuplot` are read; the rest is "
                "prose, which "
                "may say anything. Several blocks of a kind are read as one, in their order. A statement is a line: a "
                "first word, then what it takes, with blanks between; `#` begins a comment.");
  manner->words(
      out, "Below, CAPITALS stand for what you write there, `{...}` may be left out, and `a|b` is one of the two. "
           "Clauses (a word and its values) come in any order. `$NAME` stands for a value that `let` or `sweep` has "
           "named above.");
  snprintf(
      text, sizeof text,
      "A name is a letter, then letters, digits, `_` and `-`, less than %d in all. A number is decimal: `-1.5e3`. A "
      "page may have %d MB, lines of %d bytes and %d words, %d runs, %d bodies, %d materials, and %d of each other "
      "thing that has a name. A mistake is told with its line, what was expected and, where a known word is near, "
      "what was probably meant; all mistakes of a page at once.",
      NB_NAME_SIZE, NB_PAGE_MAX >> 20, NB_LINE_MAX, NB_TOKENS_MAX - 1, NB_RUNS_MAX, NB_BODIES_MAX, NB_MATERIALS_MAX,
      NB_NAMED_MAX);
  manner->words(out, text);
}

void nb_manual_language(FILE *out, const struct nb_manner *manner, bool whole) {
  grammar(out, manner);
  manner->section(out, "The scene");
  for (const struct nb_keyword *keyword = nb_keywords(); keyword->apply; keyword++)
    if (keyword->where & NB_IN_SCENE)
      statement(out, manner, keyword, whole);
  manner->section(out, "In a stage");
  for (const struct nb_keyword *keyword = nb_keywords(); keyword->apply; keyword++)
    if (keyword->where & NB_IN_STAGE && !(keyword->where & NB_IN_SCENE))
      statement(out, manner, keyword, whole);
  manner->section(out, "On the bench");
  manner->words(out,
                "A page with a block `path` instead of `scene` takes one contact through approach and slip, or through "
                "forces: no bodies, no time. Its legs are stages to what is expected: `shear max in load`.");
  for (const struct nb_keyword *keyword = nb_keywords(); keyword->apply; keyword++)
    if (keyword->where & (NB_IN_PATH | NB_IN_LEG) && !(keyword->where & (NB_IN_SCENE | NB_IN_STAGE)))
      statement(out, manner, keyword, whole);
  manner->section(out, "Expectations");
  measures(out, manner);
  for (const struct nb_keyword *keyword = nb_expect_keywords(); keyword->apply; keyword++)
    if (keyword->word)
      statement(out, manner, keyword, whole);
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++)
    expectation(out, manner, row, whole);
  quantities(out, manner);
  units(out, manner);
}

/* ---- one word ---- */

/* A word that is no statement but the clause of some: each of them, and what the clause takes. */
static bool clause(FILE *out, const char *word, const struct nb_keyword *keyword) {
  bool found = false;
  for (; keyword->apply; keyword++)
    for (const struct nb_argument *field = keyword->arguments; field->count; field++) {
      if (!field->word || strcmp(field->word, word) != 0)
        continue;
      statement(out, &nb_manner_text, keyword, false);
      argument(out, &nb_manner_text, field);
      found = true;
    }
  return found;
}

/* `C.normal` and `normal`: of whatever has a quantity of that name. */
static bool quantity(FILE *out, const char *word) {
  const char *name, *unit, *of, *help, *dot = strchr(word, '.');
  bool found = false;
  for (size_t row = 0; nb_quantity_row(row, &name, &unit, &of, &help); row++)
    if (strcmp(name, word) == 0 || (dot && strcmp(name, dot + 1) == 0)) {
      fprintf(out, "  %s of %s%s%s: %s\n", name, of, strcmp(unit, "1") == 0 ? "" : ", in ",
              strcmp(unit, "1") == 0 ? "" : unit, help);
      found = true;
    }
  return found;
}

bool nb_manual_word(FILE *out, const char *word, char *hint) {
  const struct nb_keyword *const tables[] = {nb_keywords(), nb_expect_keywords()};
  struct nb_guess guess = nb_guess_begin(word);
  bool found = false;
  for (size_t t = 0; t < sizeof tables / sizeof *tables; t++)
    for (const struct nb_keyword *keyword = tables[t]; keyword->apply; keyword++) {
      if (!keyword->word)
        continue;
      char first[NB_NAME_SIZE];
      nb_first_word(first, keyword->word);
      nb_guess_offer(&guess, first);
      if (strcmp(first, word) != 0 && strcmp(keyword->word, word) != 0)
        continue;
      statement(out, &nb_manner_text, keyword, true);
      found = true;
    }
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++) {
    nb_guess_offer(&guess, row->word);
    if (strcmp(row->word, word) != 0)
      continue;
    expectation(out, &nb_manner_text, row, true);
    found = true;
  }
  for (size_t t = 0; t < sizeof tables / sizeof *tables && !found; t++)
    found = clause(out, word, tables[t]);
  found = found || quantity(out, word);
  snprintf(hint, 2 * NB_NAME_SIZE, "%s", nb_guess_found(&guess) ? guess.best : "");
  return found;
}
