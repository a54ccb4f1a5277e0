/* Reads one statement by its row in a table of keywords. If the statement begins with the words of several rows, the
 * row with most words is taken; if there is no row, a message says what may stand here. Positional arguments are read
 * in the order of the row, clauses in any order. Then the row's apply is called, which may read more tokens if the row
 * has a tail.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "reader.h"

/* ---- the row of a statement ---- */

/* Number of words of a row that match the next tokens, from the first word on; *all: number of words of the row. */
static size_t matching_words(const struct nb_reader *reader, const char *words, size_t *all) {
  size_t there = 0;
  *all = 0;
  for (const char *word = words; *word; (*all)++) {
    const size_t at = reader->next + *all;
    const char *token = at < reader->count ? reader->tokens[at].text : "";
    while (*word && *word != ' ' && *word == *token)
      word++, token++;
    there += there == *all && !*token && (!*word || *word == ' ');
    while (*word && *word != ' ')
      word++;
    while (*word == ' ')
      word++;
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

bool nb_begins_clause(const struct nb_argument *field, const char *word) {
  char first[NB_NAME_SIZE] = "";
  if (field->word)
    nb_first_word(first, field->word);
  return *first && strcmp(first, word) == 0;
}

static bool number_next(const struct nb_reader *reader) {
  const struct nb_token *token = nb_token_peek(reader);
  double number;
  return token && nb_number_read(&number, token->text, 0) != NB_NO_NUMBER;
}

enum { CONTACT_TEST = NB_IN_CONTACT_TEST | NB_IN_SEGMENT };

/* Says where a row belongs that is not allowed here: if possible, a place in the same kind of block. */
static const char *where_words(const struct nb_reader *reader, unsigned where, unsigned here) {
  if (here & CONTACT_TEST && !(where & CONTACT_TEST))
    return "in a block of kind `scene`";
  if (here & CONTACT_TEST)
    return where & NB_IN_CONTACT_TEST ? "before the first `segment`" : "in a segment: below a line `segment NAME …`";
  if (!(where & ~(unsigned)CONTACT_TEST))
    return "in a block of kind `contact-test`";
  if ((here == NB_IN_START || reader->starts) && where & NB_IN_SCENE && !(where & NB_IN_START))
    return "in a page that does not `start` from another";
  return where & NB_IN_SCENE ? "before the first `stage`" : "in a stage: below a line `stage NAME`";
}

static size_t matching_here(const struct nb_reader *reader, const struct nb_keyword *row, unsigned here) {
  size_t all;
  return row->where & here && row->word ? matching_words(reader, row->word, &all) : 0;
}

/* The row with most words that match the next tokens; *most: number of these words. NULL: the first word matches no
 * row. */
static const struct nb_keyword *best_match(const struct nb_reader *reader, const struct nb_family *table, unsigned here,
                                           size_t *most) {
  const struct nb_keyword *meant = NULL, *row;
  *most = 0;
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    const size_t there = matching_here(reader, row, here);
    if (there > *most)
      *most = there, meant = row;
  }
  return meant;
}

/* Copies the word of `words` that follows the first `count` words. */
static void word_after(char *word, const char *words, size_t count) {
  for (; count; count--)
    words += strcspn(words, " "), words += strspn(words, " ");
  nb_first_word(word, words);
}

/* Appends a quoted word to a list, unless the list already has the word. */
static void list_word(char *list, size_t size, const char *between, const char *word) {
  char quoted[NB_NAME_SIZE + 2];
  snprintf(quoted, sizeof quoted, "`%s`", word);
  if (!strstr(list, quoted))
    nb_append(list, size, "%s%s", *list ? between : "", quoted);
}

/* Writes "the statement is `box X Y to X Y MATERIAL`". */
static void syntax_hint(char *hint, const struct nb_keyword *keyword) {
  char syntax[NB_HINT_SIZE / 2];
  nb_keyword_syntax(syntax, sizeof syntax, keyword);
  snprintf(hint, NB_HINT_SIZE, "the statement is `%s`", syntax);
}

/* Appends the first `length` bytes of an example, with the material of the page in place of those of the manual. */
static void append_example(char *hint, const struct nb_reader *reader, const char *example, size_t length) {
  char material[NB_NAME_SIZE];
  const bool defines = strncmp(example, "material", 8) == 0 || strncmp(example, "pair", 4) == 0;
  const bool known = !defines && nb_page_name_of(material, reader->page, "material", reader->line);
  for (size_t at = 0, n; at < length; at += n) {
    n = strspn(example + at, " ");
    n = n ? n : strcspn(example + at, " ");
    n = at + n > length ? length - at : n;
    const bool theirs = known && n == 5 && (!strncmp(example + at, "steel", n) || !strncmp(example + at, "glass", n));
    nb_append(hint, NB_HINT_SIZE, "%.*s", theirs ? (int)strlen(material) : (int)n, theirs ? material : example + at);
  }
}

const char *nb_example_hint(char *hint, const struct nb_reader *reader) {
  const char *line = reader->row && reader->row->example ? reader->row->example : "", *best = "";
  char first[NB_NAME_SIZE] = "", padded[NB_HINT_SIZE], word[NB_NAME_SIZE + 2];
  int most = 0, lines = 0;
  if (*line && reader->row->word)
    nb_first_word(first, reader->row->word);
  for (int same = 0; *line; line += strcspn(line, "\n"), line += *line == '\n', same = 0) {
    line += strspn(line, " ");
    snprintf(padded, sizeof padded, " %.*s ", (int)strcspn(line, "\n"), line);
    for (size_t k = 0; k < reader->count; k++) { /* numbers and names of one letter do not say which line is nearest */
      snprintf(word, sizeof word, " %.63s ", reader->tokens[k].text);
      same += !nb_number_length(word + 1) && word[2] != ' ' && strstr(padded, word);
    }
    const bool own = strncmp(line, first, strlen(first)) == 0;
    if (own && same > most)
      most = same, best = line;
    lines += own;
  }
  size_t length = strcspn(best, "$\n");
  if (best[length] == '$') /* the page may lack this name: the clause is left out, and the two spaces before it */
    while (strncmp(best + length, "  ", 2) != 0)
      length--;
  snprintf(hint, NB_HINT_SIZE, "for example `");
  append_example(hint, reader, best, length);
  nb_append(hint, NB_HINT_SIZE, "`");
  /* if the example has several lines, one common word, the first one, is not enough to choose a line */
  return most > (lines > 1) ? hint : NULL;
}

/* Reports a line whose first words match some rows and whose next word matches none of them: `fill sphres`. Returns one
 * of these rows. Returns NULL, without a report, if no row of this place has the first word, or if the line probably
 * means `whole`, a row of another place. This is so if `whole` matches more words. It is also so if the line ends, or
 * continues with a number; `cell shear` continues with a word. */
static const struct nb_keyword *wrong_word(struct nb_reader *reader, const struct nb_family *table, unsigned here,
                                           const struct nb_keyword *whole) {
  char list[256] = "", hint[NB_HINT_SIZE], word[NB_NAME_SIZE];
  size_t most, all;
  const struct nb_keyword *meant = best_match(reader, table, here, &most), *row;
  if (!meant || (whole && matching_words(reader, whole->word, &all) > most))
    return NULL;
  const struct nb_token *token = reader->next + most < reader->count ? &reader->tokens[reader->next + most] : NULL;
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    if (matching_here(reader, row, here) < most)
      continue;
    word_after(word, row->word, most);
    nb_guess_offer(&guess, word);
    list_word(list, sizeof list, " or ", word);
  }
  reader->next += most;
  if (whole && (!token || number_next(reader))) {
    reader->next -= most;
    return NULL;
  }
  syntax_hint(hint, meant);
  nb_expected(reader, nb_guess_hint(&guess, hint) || !strchr(list, ' ') ? hint : NULL, "%s", list);
  return meant;
}

static const char *place_of(unsigned here) {
  switch (here) {
  case NB_IN_STAGE:
    return "a statement of a stage";
  case NB_IN_RAMP:
    return "a statement that can ramp";
  case NB_IN_CONTACT_TEST:
    return "a statement of a contact test";
  case NB_IN_SEGMENT:
    return "a statement of a segment";
  case NB_IN_START:
    return "a statement of a page that starts from another";
  default:
    return "a statement of the scene";
  }
}

/* The hint for a word that is a clause of statements of this place; NULL: the word is no clause. */
static const char *clause_hint(char *hint, const struct nb_family *table, unsigned here, const char *word) {
  const struct nb_keyword *row;
  char list[NB_HINT_SIZE / 2] = "";
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++)
    for (const struct nb_argument *field = row->arguments; field->count; field++)
      if (row->where & here && nb_begins_clause(field, word))
        list_word(list, sizeof list, " or ", row->word);
  snprintf(hint, NB_HINT_SIZE, "`%s` is a part of %s: see `nineball --help %s`", word, list, word);
  return *list ? hint : NULL;
}

/* The hint for a property of a material or a pair in place of a statement: for `friction steel glass 0.2` the line `pair
 * steel glass friction 0.2`; NULL: the line is none such. */
static const char *property_hint(char *hint, const struct nb_reader *reader, const struct nb_family *table,
                                 unsigned here) {
  const struct nb_token *const tokens = reader->tokens;
  size_t names = 1;
  if (!clause_hint(hint, table, here, tokens[0].text) || !strstr(hint, "`pair`"))
    return NULL;
  while (names < reader->count && nb_is_name(tokens[names].text))
    names++;
  if (names > 3 || names == reader->count)
    return NULL;
  snprintf(hint, NB_HINT_SIZE, "`%s` is a property of a material or of a pair of materials: write `%s %s%s%s %s",
           tokens[0].text, names == 3 ? "pair" : "material", names > 1 ? tokens[1].text : "NAME", names == 3 ? " " : "",
           names == 3 ? tokens[2].text : "", tokens[0].text);
  for (size_t k = names; k < reader->count; k++)
    nb_append(hint, NB_HINT_SIZE, " %.40s", tokens[k].text);
  nb_append(hint, NB_HINT_SIZE, "`");
  return hint;
}

/* The hint for a word that is no clause of this line but begins another statement: `disc … rotation off`; NULL: the
 * word begins no other statement. */
static const char *other_statement(char *hint, const struct nb_reader *reader, const char *word) {
  const struct nb_keyword *found = NULL, *row;
  char first[NB_NAME_SIZE], syntax[NB_HINT_SIZE / 2];
  for (size_t k = 0; reader->here != NB_IN_EXPECT && (row = nb_keyword_row(nb_keywords(), k)); k++) {
    nb_first_word(first, row->word ? row->word : "");
    if (strcmp(first, word) == 0 && (!found || (row->where & reader->here && !(found->where & reader->here))))
      found = row;
  }
  if (!found)
    return NULL;
  if (found == reader->row) {
    snprintf(hint, NB_HINT_SIZE, "each statement `%s` has its own line", word);
    return hint;
  }
  nb_keyword_syntax(syntax, sizeof syntax, found);
  const char *const place = found->where & reader->here ? "" : where_words(reader, found->where, reader->here);
  snprintf(hint, NB_HINT_SIZE, "`%s` is a statement of its own%s%s", syntax, *place ? ", " : "", place);
  return hint;
}

/* The hint for a quantity in place of a statement: `porosity 0.3`; NULL: the word is no quantity. */
static const char *quantity_hint(char *hint, unsigned here, const char *word) {
  struct nb_quantity_row row;
  size_t k = 0;
  while (nb_quantity_row(&row, k) && strcmp(row.name, word) != 0)
    k++;
  if (!(here & (NB_IN_SCENE | NB_IN_STAGE)) || !nb_quantity_row(&row, k) || strcmp(row.of, "a contact test") == 0)
    return NULL;
  const char *const prefix = row.prefix ? row.prefix : "";
  snprintf(
      hint, NB_HINT_SIZE,
      "`%s` is a quantity of %s: %s%s%s`record %s%s`, and in a stage `until %s%s below|above VALUE at most N cycles`",
      word, row.of, row.statement ? "`" : "", row.statement ? row.statement : "", row.statement ? "`, " : "", prefix,
      word, prefix, word);
  return hint;
}

/* The name of a place in the table of words of other programs: `stage_duration` is the word `duration` in a stage. */
static const char *place_name(unsigned here) {
  return here & (NB_IN_STAGE | NB_IN_RAMP) ? "stage" : here & (unsigned)CONTACT_TEST ? "contact_test" : "scene";
}

/* Suppresses messages that would follow from an unknown first word: about the statements of `meant` or, if that is
 * NULL, about the statement `nearest`. If both are NULL, the line may define particles, walls or a cell, except in a
 * stage or a segment. */
static void suppress_unknown(struct nb_reader *reader, unsigned here, const struct nb_synonym *meant,
                             const char *nearest) {
  const char *list = meant ? meant->ours : "";
  char item[NB_NAME_SIZE];
  while (nb_item(&list, item))
    nb_suppress_name(reader->mistakes, item);
  if (!meant && (nearest || !(here & (NB_IN_STAGE | NB_IN_SEGMENT))))
    nb_suppress_name(reader->mistakes, nearest ? nearest : NB_UNKNOWN);
}

/* The hint for an unknown first word; NULL: there is none. `guess`: the search that has found a similar word, or
 * NULL. */
static const char *verb_hint(char *hint, const struct nb_reader *reader, const struct nb_family *table, unsigned here,
                             const struct nb_guess *guess) {
  const char *const text = nb_token_peek(reader)->text;
  if (nb_pair_hint(hint, place_name(here), text) ||
      (reader->count > 1 && nb_pair_hint(hint, text, reader->tokens[1].text)))
    return hint;
  if (guess)
    return nb_guess_hint(guess, hint);
  return property_hint(hint, reader, table, here) || clause_hint(hint, table, here, text) || nb_synonym_hint(hint, text)
             ? hint
             : quantity_hint(hint, here, text);
}

/* Reports a first word with which no row begins. Returns the row that was probably meant, or NULL. */
static const struct nb_keyword *unknown_verb(struct nb_reader *reader, const struct nb_family *table, unsigned here) {
  char words[NB_HINT_SIZE - 64] = "", hint[NB_HINT_SIZE], better[NB_HINT_SIZE], word[NB_NAME_SIZE];
  const char *const text = nb_token_peek(reader)->text;
  struct nb_guess guess = nb_guess_begin(text);
  const struct nb_keyword *meant = NULL, *row;
  for (size_t k = 0; (row = nb_keyword_row(table, k)); k++) {
    if (!row->word || !(row->where & here))
      continue;
    nb_first_word(word, row->word);
    const int before = guess.distance;
    nb_guess_offer(&guess, word);
    if (guess.distance < before)
      meant = row;
    list_word(words, sizeof words, ", ", word);
  }
  snprintf(hint, sizeof hint, "the %s word may be: %s", here == NB_IN_RAMP ? "next" : "first", words);
  const bool near = nb_guess_found(&guess) && !guess.synonym == !guess.marked;
  const char *const other = verb_hint(better, reader, table, here, near ? &guess : NULL);
  nb_expected(reader, other ? other : hint, "%s", place_of(here));
  suppress_unknown(reader, here, nb_pair_synonym(place_name(here), text), near ? guess.best : NULL);
  return near ? meant : NULL;
}

/* Reports a statement that is not allowed here; `row` is its row for another place. Returns this row. */
static const struct nb_keyword *misplaced(struct nb_reader *reader, const struct nb_family *table,
                                          const struct nb_keyword *row, unsigned here) {
  char hint[NB_HINT_SIZE], other[NB_HINT_SIZE], syntax[NB_HINT_SIZE / 2] = "";
  const char *const word = reader->tokens[0].text;
  size_t most;
  const struct nb_keyword *const begins = best_match(reader, table, here, &most);
  if (begins)
    nb_keyword_syntax(syntax, sizeof syntax, begins);
  if (reader->count < 2 || !nb_pair_hint(hint, word, reader->tokens[1].text)) {
    snprintf(hint, sizeof hint, "`%s` belongs %s%s%s%s", row->word, where_words(reader, row->where, here),
             begins ? "; the statement here is `" : "", syntax, begins ? "`" : "");
    if (nb_pair_hint(other, place_name(here), word))
      nb_append(hint, sizeof hint, "; %s", other);
  }
  nb_expected(reader, hint, "%s", place_of(here));
  return row;
}

/* Reports a statement that matches no row of this place. Returns the row that was probably meant, or NULL. */
static const struct nb_keyword *wrong_row(struct nb_reader *reader, const struct nb_family *table, unsigned here,
                                          const struct nb_keyword *whole) {
  const struct nb_keyword *partly = wrong_word(reader, table, here, whole);
  return partly ? partly : whole ? misplaced(reader, table, whole, here) : unknown_verb(reader, table, here);
}

/* ---- the fields of a row ---- */

static void expected_second(struct nb_reader *reader, const struct nb_argument *field) {
  char hint[NB_HINT_SIZE];
  syntax_hint(hint, reader->keyword);
  nb_expected(reader, hint, "the second value of `%s %s`", field->word, field->value);
}

static void read_field(struct nb_reader *reader, const struct nb_argument *field, struct nb_record *record) {
  reader->given |= 1U << (field - reader->keyword->arguments);
  for (int i = 0; i < field->count && !reader->bad; i++) {
    struct nb_value *value = &record->value[field->slot + i];
    unsigned long count = 0;
    value->token = nb_token_peek(reader);
    switch (field->kind) {
    case NB_ARGUMENT_NUMBER:
      if (i > 0 && !number_next(reader))
        expected_second(reader, field);
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
      nb_take_token(reader, field->help);
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

static bool given(const struct nb_reader *reader, const struct nb_argument *field) {
  return reader->given >> (field - reader->keyword->arguments) & 1;
}

/* The clause whose words are next; *words: their number. NULL: no clause begins here. */
static const struct nb_argument *next_clause(const struct nb_reader *reader, size_t *words) {
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (field->word && matching_words(reader, field->word, words) == *words)
      return field;
  return NULL;
}

static const struct nb_argument *next_positional(const struct nb_reader *reader) {
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

/* True if one of several such clauses is required: their default begins with `|`. */
static bool is_alternative(const struct nb_argument *field) { return field->otherwise && field->otherwise[0] == '|'; }

/* True if the clause is a part of the clause before it, as `to X Y` is of `box X Y`: its default begins with `+`. */
static bool is_part(const struct nb_argument *field) { return field->otherwise && field->otherwise[0] == '+'; }

/* True if the field is one of several clauses of which the line has another one, or a part of a clause that the line
 * does not have. */
static bool is_excluded(const struct nb_reader *reader, const struct nb_argument *field) {
  bool other = false;
  if (is_part(field))
    return !given(reader, field - 1);
  for (const struct nb_argument *it = reader->keyword->arguments; it->count; it++)
    other = other || (is_alternative(it) && given(reader, it));
  return is_alternative(field) && other;
}

/* True if the field is required and missing. */
static bool is_missing(const struct nb_reader *reader, const struct nb_argument *field) {
  const bool dependent = is_alternative(field) || is_part(field);
  return !given(reader, field) && (!field->otherwise || (dependent && !is_excluded(reader, field)));
}

/* True if some required field is missing; `clause`: some required clause. */
static bool is_incomplete(const struct nb_reader *reader, bool clause) {
  const struct nb_argument *field = reader->keyword->arguments;
  while (field->count && !(is_missing(reader, field) && (field->word || !clause)))
    field++;
  return field->count > 0;
}

/* True if the next tokens are a mistyped clause: a word and a number where one word is expected, `raduis 5`, or the
 * value of a clause without the word of the clause, `1 m`. */
static bool mistyped_clause(const struct nb_reader *reader, const struct nb_argument *positional) {
  const struct nb_token *token = nb_token_peek(reader);
  double number;
  if (positional->kind != NB_ARGUMENT_WORD || reader->next + 1 >= reader->count)
    return false;
  if (is_incomplete(reader, true) && reader->given && nb_number_read(&number, token->text, 0) == NB_READ)
    return true;
  if (nb_number_read(&number, token[1].text, 0) != NB_READ)
    return false;
  struct nb_guess guess = guess_clause(reader, token->text);
  return nb_guess_found(&guess) || (reader->given && nb_pair_synonym(reader->tokens[0].text, token->text));
}

/* Number of positional arguments in this bit set of arguments. */
static size_t positional_count(const struct nb_keyword *keyword, unsigned set) {
  size_t count = 0;
  for (const struct nb_argument *field = keyword->arguments; field->count; field++, set >>= 1)
    count += !field->word && set & 1;
  return count;
}

/* The hint for a statement of another place with the same words, such as `wall` in the scene and in a stage; NULL: no
 * hint. The hint is given in two cases: this line has too many positional arguments and the other statement takes more;
 * or this line has too few and the other statement takes exactly as many as this line has. */
static const char *namesake_hint(const struct nb_reader *reader, char *hint, const struct nb_argument *missing) {
  const size_t count = reader->namesake ? positional_count(reader->namesake, ~0u) : 0;
  const bool fits = nb_token_peek(reader) ? count > positional_count(reader->keyword, ~0u)
                                          : !missing->word && count == positional_count(reader->keyword, reader->given);
  char syntax[256];
  if (!reader->namesake || !fits)
    return NULL;
  nb_keyword_syntax(syntax, sizeof syntax, reader->namesake);
  snprintf(hint, NB_HINT_SIZE, "`%s` belongs %s", syntax, where_words(reader, reader->namesake->where, reader->here));
  return hint;
}

/* Lists all missing clauses with their values; returns the first missing field, or NULL. */
static const struct nb_argument *list_missing(const struct nb_reader *reader, char *list, size_t size) {
  const struct nb_argument *first = NULL, *before = NULL;
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++) {
    const bool either = before && is_alternative(before) && is_alternative(field);
    if (!is_missing(reader, field))
      continue;
    first = first ? first : field;
    if (!field->word)
      continue;
    nb_append(list, size, "%s`%s%s%s`",
              !before  ? ""
              : either ? " or "
                       : ", and ",
              field->word, field->value ? " " : "", field->value ? field->value : "");
    before = field;
  }
  return first;
}

/* The words for a positional argument: "a length", "the name of a material". */
static const char *value_words(const struct nb_argument *field) {
  return field->kind == NB_ARGUMENT_NUMBER  ? nb_unit_kind_name(field->unit)
         : field->kind == NB_ARGUMENT_COUNT ? "a whole number"
                                            : field->help;
}

/* Number of values, with or without their units, that end before token k; or, forward, that begin with it. */
static int values_around(const struct nb_reader *reader, size_t k, bool forward) {
  struct nb_unit unit;
  double number;
  int count = 0;
  for (size_t at = forward ? k : k - 1; at < reader->count; at += forward ? 1 : (size_t)-1) {
    const char *const text = reader->tokens[at].text;
    if (nb_number_read(&number, text, 0) != NB_NO_NUMBER)
      count++;
    else if (!nb_unit_read(&unit, text))
      break;
  }
  return count;
}

/* The hint for a value that is the third of three. The value is a third coordinate if no clause is missing, or if the
 * word of the missing clause follows later. Otherwise this word may have been left out before the value. NULL: the
 * value is no third coordinate. */
static const char *third_coordinate(char *hint, const struct nb_reader *reader, const struct nb_argument *missing) {
  const struct nb_argument *field = reader->keyword->arguments;
  char example[NB_HINT_SIZE];
  bool follows = !missing || !missing->word;
  while (field->count && field->kind != NB_ARGUMENT_NUMBER)
    field++;
  for (size_t k = reader->next; k < reader->count && !follows; k++)
    follows = nb_begins_clause(missing, reader->tokens[k].text);
  if (field->unit == NB_UNIT_STRAIN_RATE || !follows || values_around(reader, reader->next, false) != 2 ||
      values_around(reader, reader->next, true) != 1)
    return NULL;
  snprintf(hint, NB_HINT_SIZE,
           "the simulation is in the plane, with x to the right and y up: write two numbers, %.400s",
           nb_example_hint(example, reader) ? example : "x and y");
  return hint;
}

/* Writes the syntax of the statement and an example; or, before a number, the word of the clause that is missing. */
static void usage_hint(const struct nb_reader *reader, char *hint, const struct nb_token *token,
                       const struct nb_argument *missing) {
  char example[NB_HINT_SIZE];
  syntax_hint(hint, reader->keyword);
  if (nb_example_hint(example, reader))
    nb_append(hint, NB_HINT_SIZE, ", %s", example);
  if (number_next(reader) && missing && missing->word && !missing->otherwise && nb_example_hint(example, reader))
    snprintf(hint, NB_HINT_SIZE, "write `%s` before `%.40s`, %.300s", missing->word, token->text, example);
}

/* The hint for `fixed yes`, a word that follows a word without a value; NULL: the words are others. */
static const char *flag_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token) {
  const struct nb_synonym *const synonym = token ? nb_synonym(token->text) : NULL;
  const bool yes = token && (strcmp(token->text, "on") == 0 || (synonym && strcmp(synonym->ours, "on") == 0));
  for (const struct nb_argument *field = reader->keyword->arguments; yes && field->count; field++)
    if (field->kind == NB_ARGUMENT_FLAG && nb_begins_clause(field, token[-1].text)) {
      snprintf(hint, NB_HINT_SIZE, "`%s` has no value: leave out `%.40s`", field->word, token->text);
      return hint;
    }
  return NULL;
}

/* The hint for a clause with another name before it in an incomplete line, `servo stress.yy 20 kPa`; NULL: the word is no
 * such clause. */
static const char *part_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token,
                             const struct nb_argument *missing, const struct nb_guess *guess) {
  char example[NB_HINT_SIZE];
  if (!token || !missing || !strchr(token->text, '.') || !nb_guess_hint(guess, hint))
    return NULL;
  if (nb_example_hint(example, reader))
    nb_append(hint, NB_HINT_SIZE, " %s", example);
  return hint;
}

/* Writes the line that an incomplete `servo`, or one with a word of another program, means; false: there is none. */
static bool servo_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token,
                       const struct nb_guess *guess) {
  const char *const word = reader->keyword->word ? reader->keyword->word : "";
  const bool whole = nb_line_has(reader, "most"); /* only the mistyped word is wrong */
  return strcmp(word, "servo") == 0 &&
         (!token || strchr(token->text, '.') || nb_pair_synonym(word, token->text) || !whole ||
          !nb_guess_found(guess)) &&
         nb_servo_hint(hint, reader);
}

/* Writes the hint for an unexpected word or a missing field. False: there is no such hint, and *hint is that of
 * usage_hint. */
static bool fields_hint(const struct nb_reader *reader, char *hint, const struct nb_token *token,
                        const struct nb_argument *missing) {
  const struct nb_guess guess = guess_clause(reader, token ? token->text : "");
  usage_hint(reader, hint, token, missing);
  return flag_hint(hint, reader, token) || servo_hint(hint, reader, token, &guess) ||
         part_hint(hint, reader, token, missing, &guess) ||
         (number_next(reader) && third_coordinate(hint, reader, missing)) || nb_guess_hint(&guess, hint) ||
         (token && reader->given && other_statement(hint, reader, token->text)) || namesake_hint(reader, hint, missing);
}

/* Lists the clauses that may follow, "`to`, `velocity` or `spin`"; `end`: also the end of the line. */
static void list_clauses(const struct nb_reader *reader, char *list, size_t size, bool end) {
  *list = '\0';
  for (const struct nb_argument *field = reader->keyword->arguments; field->count; field++)
    if (field->word && !given(reader, field) && !is_excluded(reader, field))
      list_word(list, size, ", ", field->word);
  char word[NB_NAME_SIZE], *const last = end ? NULL : strrchr(list, ',');
  if (last) {
    snprintf(word, sizeof word, "%s", last + 1);
    snprintf(last, size - (size_t)(last - list), " or%s", word);
  } else if (end) {
    nb_append(list, size, "%sthe end of the line", *list ? " or " : "");
  }
}

static bool is_clause_word(const struct nb_reader *reader, const char *word) {
  const struct nb_argument *field = reader->keyword->arguments;
  while (field->count && !nb_begins_clause(field, word))
    field++;
  return field->count;
}

/* Goes back to a word that was read as a name, but is a word of another program: in `lattice discs 10 by 10 triangular
 * radius 5 mm rock` `triangular` is wrong, and not `rock`. */
static void return_to_foreign_word(struct nb_reader *reader) {
  for (size_t k = reader->next; k-- > 1;)
    if (nb_is_name(reader->tokens[k].text) && !is_clause_word(reader, reader->tokens[k].text) &&
        nb_pair_synonym(reader->tokens[0].text, reader->tokens[k].text)) {
      reader->next = k;
      return;
    }
}

/* Reports all missing fields at the end of the line; or a word that is not a clause, with the possible clauses. */
static void expected_fields(struct nb_reader *reader) {
  if (nb_token_peek(reader) && !nb_pair_synonym(reader->tokens[0].text, nb_token_peek(reader)->text))
    return_to_foreign_word(reader);
  const struct nb_token *token = nb_token_peek(reader);
  char list[512] = "", hint[NB_HINT_SIZE];
  const struct nb_argument *const missing = list_missing(reader, list, sizeof list);
  const bool near = fields_hint(reader, hint, token, missing);
  if (!token && missing->word)
    nb_expected(reader, hint, "%s", list);
  else if (!token)
    nb_expected(reader, hint, "%s (%s)", missing->value, value_words(missing));
  if (!token)
    return;
  list_clauses(reader, list, sizeof list, missing == NULL);
  nb_expected(reader, missing || near ? hint : NULL, "%s", list);
}

static void given_again(struct nb_reader *reader, const struct nb_token *token, const struct nb_argument *clause) {
  char hint[NB_HINT_SIZE];
  if (!nb_pair_hint(hint, reader->tokens[0].text, token->text))
    syntax_hint(hint, reader->keyword);
  nb_token_mistake(reader, token, hint, "expected `%s` once, found it twice", clause->word);
}

static void read_fields(struct nb_reader *reader, struct nb_record *record) {
  const struct nb_token *token;
  while ((token = nb_token_peek(reader))) {
    size_t words = 0;
    const struct nb_argument *clause = next_clause(reader, &words), *positional = next_positional(reader);
    if (clause && given(reader, clause))
      given_again(reader, token, clause);
    else if (clause)
      reader->next += words, read_field(reader, clause, record);
    else if (positional && !mistyped_clause(reader, positional))
      read_field(reader, positional, record);
    else if (reader->keyword->tail)
      break;
    else
      expected_fields(reader);
  }
  if (!reader->bad && is_incomplete(reader, false))
    expected_fields(reader);
}

/* ---- statements ---- */

/* The row whose words all match and which has most words: of this place or, with `elsewhere`, of another place. *most:
 * number of these words. Of two such rows the one of this kind of block is returned. A row of this place without words
 * matches every line. */
static const struct nb_keyword *whole_match(const struct nb_reader *reader, const struct nb_family *table,
                                            unsigned here, bool elsewhere, size_t *most) {
  const struct nb_keyword *found = NULL;
  const unsigned side = here & CONTACT_TEST ? CONTACT_TEST : ~(unsigned)CONTACT_TEST;
  const char first = reader->next < reader->count ? *reader->tokens[reader->next].text : '\0';
  size_t words;
  *most = 0;
  for (const struct nb_family *family = table; family->rows; family++)
    for (const struct nb_keyword *row = family->rows; row->apply; row++) {
      if (!(row->where & here) != elsewhere || (row->word ? *row->word != first : elsewhere))
        continue;
      const bool whole = matching_words(reader, row->word ? row->word : "", &words) == words;
      if (whole && (!found || words > *most || (words == *most && !(found->where & side))))
        found = row, *most = words;
    }
  return found;
}

/* The row of a statement; reader->next is then after its words. If no row matches, reports this and returns the row
 * that was probably meant, or NULL. */
static const struct nb_keyword *find_row(struct nb_reader *reader, const struct nb_family *table, unsigned here) {
  size_t words, other = 0;
  const struct nb_keyword *found = whole_match(reader, table, here, false, &words);
  const struct nb_keyword *whole = here == NB_IN_RAMP ? NULL : whole_match(reader, table, here, true, &other);
  if (words && other > words)
    return misplaced(reader, table, whole, here);
  reader->namesake = words && other == words ? whole : NULL;
  reader->next += words;
  return found ? found : wrong_row(reader, table, here, whole);
}

/* Suppresses messages that would follow from a bad statement: messages about its first word, and about the names that
 * it defines. An unknown statement of the scene may define each of its words. */
static void suppress_names(struct nb_reader *reader, const struct nb_keyword *keyword, unsigned here) {
  const bool sweep = strcmp(reader->tokens[0].text, "sweep") == 0,
             name = keyword && keyword->arguments->kind == NB_ARGUMENT_NAME;
  const bool any = !keyword && !(here & (NB_IN_STAGE | NB_IN_SEGMENT));
  for (size_t k = 0; k < reader->count; k++)
    if (k == 0 || any || (k == 1 && name) || (sweep && strcmp(reader->tokens[k - 1].text, "with") == 0))
      nb_suppress_name(reader->mistakes, reader->tokens[k].text);
}

void nb_statement_read(struct nb_reader *reader, const struct nb_family *table, unsigned here, void *subject) {
  struct nb_record record = {0};
  reader->next = 0, reader->here = here, reader->namesake = NULL;
  const struct nb_keyword *keyword = record.keyword = find_row(reader, table, here);
  if (keyword) {
    reader->keyword = reader->row = keyword;
    reader->given = 0;
    read_fields(reader, &record);
    reader->keyword = NULL;
    if (!reader->bad || keyword->always)
      keyword->apply(reader, &record, subject);
    if (keyword->tail && nb_token_peek(reader))
      nb_expected(reader, NULL, "the end of the line");
  }
  if (reader->bad && here != NB_IN_EXPECT) /* an expectation defines no name */
    suppress_names(reader, keyword, here);
}

void nb_keyword_syntax(char *text, size_t size, const struct nb_keyword *keyword) {
  snprintf(text, size, "%s", keyword->word ? keyword->word : "");
  for (const struct nb_argument *field = keyword->arguments; field->count; field++) {
    const char *word = field->word ? field->word : "", *value = field->value ? field->value : "";
    const char *between = *word && *value ? " " : "", *open = field->otherwise ? "{" : "", *close = *open ? "}" : "";
    nb_append(text, size, "%s%s%s%s%s%s", *text ? " " : "", open, word, between, value, close);
  }
  if (keyword->tail && *keyword->tail)
    nb_append(text, size, "%s%s", *text ? " " : "", keyword->tail);
}
