/* Which row of a table a statement is read by: the one whose words it begins with, of several the longest, or, when that is none, the one that was
 * probably meant.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "reader.h"

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
    return "in a leg: below a line `leg NAME …`";
  if (!(where & ~(unsigned)(NB_IN_PATH | NB_IN_LEG)))
    return "in a block of kind `path`";
  if (where & NB_IN_PATH && here == NB_IN_LEG)
    return "before the first `leg`";
  where &= ~(unsigned)(NB_IN_PATH | NB_IN_LEG);
  if (where == NB_IN_SCENE)
    return "before the first `stage`";
  if (where == NB_IN_STAGE)
    return "in a stage: below a line `stage NAME`";
  return where == NB_IN_EXPECT ? "in a block of kind `expect`" : "in a block of kind `scene`";
}

/* The first words of rows are there and none of the words that go on from them: `spheres fil`. Answers one of those rows. */
static const struct nb_keyword *wrong_word(struct nb_reader *reader, const struct nb_keyword *table, unsigned here) {
  char list[256] = "", hint[NB_HINT_SIZE], word[NB_NAME_SIZE];
  size_t most = 0, all;
  const struct nb_keyword *meant = NULL;
  for (const struct nb_keyword *row = table; row->apply; row++) {
    const size_t there = row->where & here && row->word ? words_there(reader, row->word, &all) : 0;
    if (there > most)
      most = there, meant = row;
  }
  if (!meant)
    return NULL;
  const struct nb_token *token = reader->next + most < reader->count ? &reader->tokens[reader->next + most] : NULL;
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (const struct nb_keyword *row = meant; row->apply; row++) {
    if (!(row->where & here) || !row->word || words_there(reader, row->word, &all) < most)
      continue;
    const char *behind = row->word;
    for (size_t k = 0; k < most; k++)
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
  if (token && token->hollow)
    reader->bad = true;
  else
    nb_expected(reader, token ? nb_guess_hint(&guess, hint) : NULL, "%s", list);
  return meant;
}

/* Whether a row above begins with the same word here. */
static bool same_verb(const struct nb_keyword *table, const struct nb_keyword *row, unsigned here) {
  char word[NB_NAME_SIZE], other[NB_NAME_SIZE];
  nb_first_word(word, row->word);
  for (const struct nb_keyword *above = table; above < row; above++)
    if (above->word && above->where & here && (nb_first_word(other, above->word), strcmp(word, other) == 0))
      return true;
  return false;
}

/* Whether the row is the bench's and another one of this word the scene's, where that is wanted; or the other way round. */
static bool other_side(const struct nb_keyword *table, const struct nb_keyword *row, unsigned here) {
  const unsigned bench = NB_IN_PATH | NB_IN_LEG, side = here & bench ? bench : ~bench;
  for (const struct nb_keyword *other = table; other->apply && !(row->where & side); other++)
    if (other->word && strcmp(other->word, row->word) == 0 && other->where & side)
      return true;
  return false;
}

/* The verb is unknown, or known but not here. Answers the row that was probably meant, or NULL. */
static const struct nb_keyword *wrong_verb(struct nb_reader *reader, const struct nb_keyword *table, unsigned here) {
  static const char *const places[] = {[NB_IN_SCENE] = "a statement of the scene",
                                       [NB_IN_STAGE] = "a statement of a stage",
                                       [NB_IN_EXPECT] = "an expectation",
                                       [NB_IN_RAMP] = "something that can ramp",
                                       [NB_IN_PATH] = "a statement of a path",
                                       [NB_IN_LEG] = "a statement of a leg",
                                       [NB_IN_START] = "a statement of a page that starts from another"};
  char hint[NB_HINT_SIZE];
  char word[NB_NAME_SIZE];
  snprintf(hint, sizeof hint, "the %s word may be: ", here == NB_IN_RAMP ? "next" : "first");
  const struct nb_token *verb = nb_token_peek(reader);
  struct nb_guess guess = nb_guess_begin(verb->text);
  const struct nb_keyword *meant = NULL;
  const struct nb_keyword *partly = wrong_word(reader, table, here);
  if (partly)
    return partly;
  for (const struct nb_keyword *row = table; row->apply; row++) {
    if (row->word)
      nb_first_word(word, row->word);
    if (here != NB_IN_RAMP && row->word && strcmp(word, verb->text) == 0 && !other_side(table, row, here)) {
      snprintf(hint, sizeof hint, "`%s` belongs %s", row->word, where_words(row->where, here));
      nb_expected(reader, hint, "%s", places[here]);
      return row;
    }
    if (!row->word || !(row->where & here) || same_verb(table, row, here))
      continue;
    int before = guess.distance;
    nb_guess_offer(&guess, word);
    if (guess.distance < before)
      meant = row;
    size_t used = strlen(hint);
    snprintf(hint + used, sizeof hint - used, "%s%s", before == 2 * NB_NAME_SIZE ? "" : ", ", word);
  }
  bool near = nb_guess_found(&guess);
  nb_expected(reader, near ? nb_guess_hint(&guess, hint) : hint, "%s", places[here]);
  return near ? meant : NULL;
}

const struct nb_keyword *nb_keyword_choose(struct nb_reader *reader, const struct nb_keyword *table, unsigned here) {
  const struct nb_keyword *fallback = NULL, *found = NULL;
  size_t words, most = 0;
  for (const struct nb_keyword *row = table; row->apply; row++) {
    if (!(row->where & here))
      continue;
    if (!row->word) {
      fallback = row;
    } else if (words_there(reader, row->word, &words) == words && words > most) {
      found = row, most = words;
    }
  }
  reader->next += most;
  if (found)
    return found;
  if (fallback)
    return fallback;
  const struct nb_keyword *meant = wrong_verb(reader, table, here);
  reader->muted = true; /* read on as what was meant, for the names that it defines */
  reader->next = 1;
  return meant;
}
