/* The engine: reads one statement by its row in a table of keywords. What stands by itself is read in the order of the
 * row; clauses come in any order. The last thing is the row's apply, which may read on by itself when the row has a
 * tail.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "reader.h"

enum { COUNT_MAX = 1000000000 }; /* of anything that is counted in a field: 1e9 cycles of 1 us are a day of computing */

static bool read_field(struct nb_reader *reader, const struct nb_argument *field, struct nb_record *record) {
  bool whole = true;
  size_t end;
  for (int i = 0; i < field->count; i++) {
    struct nb_value *value = &record->value[field->slot + i];
    unsigned long count;
    value->token = nb_token_peek(reader);
    switch (field->kind) {
    case NB_ARGUMENT_NUMBER: {
      whole = nb_take_number(reader, field->unit, field->range, &value->number) && whole;
      break;
    }
    case NB_ARGUMENT_COUNT:
      whole = nb_take_count(reader, 1, COUNT_MAX, &count) && whole;
      value->number = (double)count;
      break;
    case NB_ARGUMENT_NAME:
      value->token = nb_take_name(reader, field->help);
      whole = value->token && whole;
      break;
    case NB_ARGUMENT_WORD:
      value->token = nb_take(reader, field->help);
      whole = value->token && whole;
      break;
    case NB_ARGUMENT_FLAG:
      value->token = &reader->tokens[reader->next - 1];
      break;
    }
    end = reader->next;
    if (!whole && end == reader->count)
      return false;
  }
  reader->given |= 1U << (field - reader->keyword->arguments);
  return whole;
}

static const struct nb_argument *clause_of(const struct nb_keyword *keyword, const char *word) {
  for (const struct nb_argument *field = keyword->arguments; field->count; field++)
    if (field->word && strcmp(field->word, word) == 0)
      return field;
  return NULL;
}

static bool given(const struct nb_reader *reader, const struct nb_argument *field) {
  return reader->given >> (field - reader->keyword->arguments) & 1;
}

static const struct nb_argument *next_leading(const struct nb_reader *reader) {
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (!field->word && !given(reader, field))
      return field;
  return NULL;
}

static struct nb_guess guess_clause(const struct nb_reader *reader, const char *word) {
  struct nb_guess guess = nb_guess_begin(word);
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (field->word && !given(reader, field))
      nb_guess_offer(&guess, field->word);
  return guess;
}

/* `raduis 5`: a word and a number where a lone word may stand is a clause mistyped. */
static bool mistyped_clause(const struct nb_reader *reader, const struct nb_argument *leading) {
  const struct nb_token *token = nb_token_peek(reader);
  double number;
  if (leading->kind != NB_ARGUMENT_WORD || reader->next + 1 >= reader->count || token->hollow)
    return false;
  struct nb_guess guess = guess_clause(reader, token->text);
  return nb_guess_found(&guess) && nb_number_read(&number, token[1].text, 0) == NB_READ;
}

static void unknown_word(struct nb_reader *reader) {
  char words[256] = "", hint[NB_HINT_SIZE];
  size_t used = 0;
  bool may_end = true;
  struct nb_guess guess = guess_clause(reader, nb_token_peek(reader)->text);
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++) {
    if (given(reader, field))
      continue;
    if (!field->otherwise)
      may_end = false;
    if (!field->word || used >= sizeof words)
      continue;
    int n = snprintf(words + used, sizeof words - used, "%s`%s`", used ? ", " : "", field->word);
    if (n > 0)
      used += (size_t)n;
  }
  nb_expected(reader, nb_guess_hint(&guess, hint), "%s%s%s", words, used && may_end ? " or " : "",
              may_end ? "the end of the line" : "");
}

static void missing_field(struct nb_reader *reader, const struct nb_argument *field) {
  char syntax[256], hint[NB_HINT_SIZE];
  nb_keyword_syntax(syntax, sizeof syntax, reader->keyword);
  snprintf(hint, sizeof hint, "the statement is `%s`", syntax);
  reader->next = reader->count;
  if (!field->word)
    nb_expected(reader, hint, "%s (%s)", field->value, field->help);
  else
    nb_expected(reader, hint, "`%s%s%s`", field->word, field->value ? " " : "", field->value ? field->value : "");
}

static void read_fields(struct nb_reader *reader, struct nb_record *record) {
  const struct nb_token *token;
  while ((token = nb_token_peek(reader))) {
    const struct nb_argument *clause = clause_of(reader->keyword, token->text), *leading = next_leading(reader);
    if (clause && given(reader, clause)) {
      nb_token_mistake(reader, token, NULL, "expected `%s` once, found it twice", token->text);
      reader->next = reader->count;
    } else if (clause) {
      reader->next++;
      read_field(reader, clause, record);
    } else if (leading && !mistyped_clause(reader, leading)) {
      read_field(reader, leading, record);
      reader->given |= 1U << (leading - reader->keyword->arguments); /* right or wrong, its turn is over */
    } else if (reader->keyword->tail) {
      break;
    } else {
      if (token->hollow)
        reader->bad = true, reader->next = reader->count;
      else
        unknown_word(reader);
    }
  }
  if (reader->bad)
    return;
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (!field->otherwise && !given(reader, field)) {
      missing_field(reader, field);
      return;
    }
}

void nb_statement_read(struct nb_reader *reader, const struct nb_keyword *table, unsigned here, void *subject) {
  struct nb_record record = {0};
  reader->next = 0;
  reader->meant = NULL;
  if (reader->tokens[0].hollow) {
    reader->bad = true;
    return;
  }
  const struct nb_keyword *keyword = reader->meant = nb_keyword_choose(reader, table, here);
  if (!keyword)
    return;
  reader->keyword = record.keyword = keyword;
  reader->given = 0;
  read_fields(reader, &record);
  reader->keyword = NULL;
  if (reader->bad && !keyword->defines)
    return;
  keyword->apply(reader, &record, subject);
  if (keyword->tail && !reader->bad && nb_token_peek(reader))
    nb_expected(reader, NULL, "the end of the line");
}

void nb_keyword_syntax(char *text, size_t size, const struct nb_keyword *keyword) {
  size_t used = 0;
  int n = snprintf(text, size, "%s", keyword->word ? keyword->word : "");
  if (n > 0)
    used = (size_t)n;
  for (const struct nb_argument *field = keyword->arguments; field->count && used < size; field++) {
    bool both = field->word && field->value;
    n = snprintf(text + used, size - used, "%s%s%s%s%s%s", used ? " " : "", field->otherwise ? "{" : "",
                 field->word ? field->word : "", both ? " " : "", field->value ? field->value : "",
                 field->otherwise ? "}" : "");
    if (n > 0)
      used += (size_t)n;
  }
  if (keyword->tail && used < size)
    snprintf(text + used, size - used, "%s%s", used ? " " : "", keyword->tail);
}
