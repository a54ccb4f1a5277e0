/* The engine: reads one statement by its row in a table of keywords. The longest row whose words it begins with is the one; if
 * there is none, what may have been meant is said. What stands by itself is read in the order of the row; clauses come in any order.
 * The last thing is the row's apply, which may read on by itself when the row has a tail.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "reader.h"

/* ---- the row of a statement ---- */

/* How many of a row's words stand at the token that is next, one after the other; *all of them. */
static size_t words_there(const struct nb_reader *reader, const char *words, size_t *all) {
  size_t there = 0;
  *all = 0;
  for (const char *word = words; *word; (*all)++) {
    const size_t length = strcspn(word, " "), at = reader->next + *all;
    const char *token = at < reader->count ? reader->tokens[at].text : "";
    if (there == *all && strlen(token) == length && strncmp(token, word, length) == 0)
      there++;
    word += length + strspn(word + length, " ");
  }
  return there;
}

const struct nb_keyword *nb_keyword_row(const struct nb_family *table, size_t k) {
  for (const struct nb_family *family = table; family->rows; family++)
    for (const struct nb_keyword *row = family->rows; row->apply; row++, k--)
      if (k == 0)
        return row;
  return NULL;
}

bool nb_first_word(char *first, const char *words) {
  const size_t length = strcspn(words, " ");
  snprintf(first, NB_NAME_SIZE, "%.*s", (int)length, words);
  return words[length] != 0;
}

static const char *where_words(unsigned where, unsigned here) {
  where &= ~(unsigned)(NB_IN_RAMP | NB_IN_CELL | NB_IN_START | NB_APART);
  if (here == NB_IN_START && where & NB_IN_SCENE)
    return "in a page that does not `start` from another";
  if (where == NB_IN_LEG)
    return "in a segment: below a line `segment NAME …`";
  if (!(where & ~(unsigned)(NB_IN_PATH | NB_IN_LEG)))
    return "in a block of kind `contact-test`";
  if (where & NB_IN_PATH && here == NB_IN_LEG)
    return "before the first `segment`";
  where &= ~(unsigned)(NB_IN_PATH | NB_IN_LEG);
  if (where == NB_IN_SCENE)
    return "before the first `stage`";
  if (where == NB_IN_STAGE)
    return "in a stage: below a line `stage NAME`";
  return where == NB_IN_EXPECT ? "in a block of kind `expect`" : "in a block of kind `scene`";
}

/* The first words of rows are there and none of the words that go on from them: `spheres fil`. Answers one of those rows. */
static const struct nb_keyword *wrong_word(struct nb_reader *reader, const struct nb_family *table, unsigned here) {
  char list[256] = "", hint[NB_HINT_SIZE], word[NB_NAME_SIZE];
  size_t most = 0, all;
  const struct nb_keyword *meant = NULL, *row;
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    const size_t there = row->where & here && row->word ? words_there(reader, row->word, &all) : 0;
    if (there > most)
      most = there, meant = row;
  }
  if (!meant)
    return NULL;
  const struct nb_token *token = reader->next + most < reader->count ? &reader->tokens[reader->next + most] : NULL;
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    if (!(row->where & here) || !row->word || words_there(reader, row->word, &all) < most)
      continue;
    const char *behind = row->word;
    for (size_t word_there = 0; word_there < most; word_there++)
      behind += strcspn(behind, " "), behind += strspn(behind, " ");
    nb_first_word(word, behind);
    nb_guess_offer(&guess, word);
    char quoted[NB_NAME_SIZE + 2];
    snprintf(quoted, sizeof quoted, "`%s`", word);
    const size_t used = strlen(list);
    if (!strstr(list, quoted))
      snprintf(list + used, sizeof list - used, "%s%s", used ? " or " : "", quoted);
  }
  reader->next += most;
  nb_expected(reader, token ? nb_guess_hint(&guess, hint) : NULL, "%s", list);
  return meant;
}

/* Whether a row above, the k-th, begins with the same word here. */
static bool same_verb(const struct nb_family *table, size_t k, const char *word, unsigned here) {
  char other[NB_NAME_SIZE];
  for (size_t above = 0; above < k; above++) {
    const struct nb_keyword *row = nb_keyword_row(table, above);
    if (row->word && row->where & here && (nb_first_word(other, row->word), strcmp(word, other) == 0))
      return true;
  }
  return false;
}

/* Whether the row is the bench's and another one of this word the scene's, where that is wanted; or the other way round. */
static bool other_side(const struct nb_family *table, const struct nb_keyword *row, unsigned here) {
  const unsigned bench = NB_IN_PATH | NB_IN_LEG, side = here & bench ? bench : ~bench;
  const struct nb_keyword *other;
  for (size_t k = 0; (other = nb_keyword_row(table, k)) && !(row->where & side); k++)
    if (other->word && strcmp(other->word, row->word) == 0 && other->where & side)
      return true;
  return false;
}

/* The verb is unknown, or known but not here. Answers the row that was probably meant, or NULL. */
static const struct nb_keyword *wrong_verb(struct nb_reader *reader, const struct nb_family *table, unsigned here) {
  static const char *const places[] = {[NB_IN_SCENE] = "a statement of the scene",
                                       [NB_IN_STAGE] = "a statement of a stage",
                                       [NB_IN_EXPECT] = "an expectation",
                                       [NB_IN_RAMP] = "something that can ramp",
                                       [NB_IN_PATH] = "a statement of a contact test",
                                       [NB_IN_LEG] = "a statement of a segment",
                                       [NB_IN_START] = "a statement of a page that starts from another"};
  char hint[NB_HINT_SIZE];
  char word[NB_NAME_SIZE];
  snprintf(hint, sizeof hint, "the %s word may be: ", here == NB_IN_RAMP ? "next" : "first");
  const struct nb_token *verb = nb_token_peek(reader);
  struct nb_guess guess = nb_guess_begin(verb->text);
  const struct nb_keyword *meant = NULL, *row;
  const struct nb_keyword *partly = wrong_word(reader, table, here);
  if (partly)
    return partly;
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    if (row->word)
      nb_first_word(word, row->word);
    if (here != NB_IN_RAMP && row->word && strcmp(word, verb->text) == 0 && !other_side(table, row, here)) {
      snprintf(hint, sizeof hint, "`%s` belongs %s", row->word, where_words(row->where, here));
      nb_expected(reader, hint, "%s", places[here]);
      return row;
    }
    if (!row->word || !(row->where & here) || same_verb(table, k, word, here))
      continue;
    int before = guess.distance;
    nb_guess_offer(&guess, word);
    if (guess.distance < before)
      meant = row;
    size_t used = strlen(hint);
    snprintf(hint + used, sizeof hint - used, "%s%s", before == 2 * NB_NAME_SIZE ? "" : ", ", word);
  }
  const bool near = nb_guess_found(&guess);
  nb_expected(reader, near ? nb_guess_hint(&guess, hint) : hint, "%s", places[here]);
  nb_excuse(reader->mistakes, near ? guess.best : NB_ANYTHING);
  return near ? meant : NULL;
}

/* ---- the fields of a row ---- */

static void read_field(struct nb_reader *reader, const struct nb_argument *field, struct nb_record *record) {
  reader->given |= 1U << (field - reader->keyword->arguments);
  for (int i = 0; i < field->count && !reader->bad; i++) {
    struct nb_value *value = &record->value[field->slot + i];
    unsigned long count = 0;
    value->token = nb_token_peek(reader);
    switch (field->kind) {
    case NB_ARGUMENT_NUMBER:
      nb_take_number(reader, field->unit, field->range, &value->number);
      break;
    case NB_ARGUMENT_COUNT:
      nb_take_count(reader, 1, NB_COUNT_MAX, &count);
      value->number = (double)count;
      break;
    case NB_ARGUMENT_NAME:
      nb_take_name(reader, field->help);
      break;
    case NB_ARGUMENT_WORD:
      nb_take(reader, field->help);
      break;
    case NB_ARGUMENT_CHOICE:
      value->number = nb_take_choice(reader, field->value);
      break;
    case NB_ARGUMENT_FLAG:
      value->token = &reader->tokens[reader->next - 1];
      break;
    }
  }
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
  if (leading->kind != NB_ARGUMENT_WORD || reader->next + 1 >= reader->count)
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
  const struct nb_token *token = nb_token_peek(reader); /* where the tail would begin */
  const struct nb_guess guess = guess_clause(reader, token ? token->text : "");
  if (nb_guess_found(&guess))
    nb_guess_hint(&guess, hint);
  if (!field->word)
    nb_expected(reader, hint, "%s (%s)", field->value, field->help);
  else
    nb_expected(reader, hint, "`%s%s%s`", field->word, field->value ? " " : "", field->value ? field->value : "");
}

static void read_fields(struct nb_reader *reader, struct nb_record *record) {
  const struct nb_token *token;
  while ((token = nb_token_peek(reader))) {
    const struct nb_argument *clause = clause_of(reader->keyword, token->text), *leading = next_leading(reader);
    if (clause && given(reader, clause))
      nb_token_mistake(reader, token, NULL, "expected `%s` once, found it twice", token->text);
    else if (clause)
      reader->next++, read_field(reader, clause, record);
    else if (leading && !mistyped_clause(reader, leading))
      read_field(reader, leading, record);
    else if (reader->keyword->tail)
      break;
    else
      unknown_word(reader);
  }
  for (const struct nb_argument *field = reader->keyword->arguments; field->count && !reader->bad; field++)
    if (!field->otherwise && !given(reader, field))
      missing_field(reader, field);
}

/* ---- the whole ---- */

/* The row of a statement, with reader->next behind its words; or, with a message, the one that was meant, and NULL when nothing was
 * near. */
static const struct nb_keyword *choose(struct nb_reader *reader, const struct nb_family *table, unsigned here) {
  const struct nb_keyword *fallback = NULL, *found = NULL, *row;
  size_t words, most = 0;
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    if (!(row->where & here))
      continue;
    if (!row->word) {
      fallback = row;
    } else if (words_there(reader, row->word, &words) == words && words > most) {
      found = row, most = words;
    }
  }
  reader->next += most;
  if (found || fallback)
    return found ? found : fallback;
  return wrong_verb(reader, table, here);
}

/* What a bad statement leaves unknown: what it says, by its first word, and what it would have given a name to. */
static void excuse_names(struct nb_reader *reader, const struct nb_keyword *keyword) {
  const bool sweep = strcmp(reader->tokens[0].text, "sweep") == 0;
  const bool names = !keyword || keyword->arguments->kind == NB_ARGUMENT_NAME;
  for (size_t k = 0; k < reader->count; k++)
    if (k == 0 || (k == 1 && names) || (sweep && strcmp(reader->tokens[k - 1].text, "with") == 0))
      nb_excuse(reader->mistakes, reader->tokens[k].text);
}

void nb_statement_read(struct nb_reader *reader, const struct nb_family *table, unsigned here, void *subject) {
  struct nb_record record = {0};
  reader->next = 0;
  const struct nb_keyword *keyword = record.keyword = choose(reader, table, here);
  if (keyword) {
    reader->keyword = keyword;
    reader->given = 0;
    read_fields(reader, &record);
    reader->keyword = NULL;
    if (!reader->bad || keyword->always)
      keyword->apply(reader, &record, subject);
    if (keyword->tail && nb_token_peek(reader))
      nb_expected(reader, NULL, "the end of the line");
  }
  if (reader->bad)
    excuse_names(reader, keyword);
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
