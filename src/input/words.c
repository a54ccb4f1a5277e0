/* A line as tokens: words between white space, up to a `#`, each with its place, $NAME replaced by what it stands for.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <stdarg.h>
#include <string.h>

#include "reader.h"

static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
static bool name_letter(char c) { return isalnum((unsigned char)c) || c == '_' || c == '-'; }

bool nb_is_name(const char *text) {
  size_t n = 0;
  while (name_letter(text[n]))
    n++;
  return isalpha((unsigned char)text[0]) && text[n] == '\0' && n < NB_NAME_SIZE;
}

static int characters(const char *text, size_t bytes) {
  int n = 0;
  for (size_t i = 0; i < bytes; i++)
    n += (text[i] & 0xC0) != 0x80;
  return n;
}

/* Where the next token's text may be written, and what is left of the line's room. */
struct store {
  char *at;
  size_t left;
};

static bool put(struct store *store, const char *text, size_t length) {
  if (length + 1 > store->left)
    return false;
  memcpy(store->at, text, length);
  store->at[length] = '\0';
  store->at += length;
  store->left -= length;
  return true;
}

static const struct nb_binding *binding_of(const struct nb_reader *reader, const char *name, size_t length) {
  for (size_t i = 0; i < reader->binding_count; i++) {
    const struct nb_binding *binding = &reader->bindings[i];
    if (strncmp(binding->name, name, length) == 0 && binding->name[length] == '\0')
      return binding;
  }
  return NULL;
}

static void unknown_name(struct nb_reader *reader, const struct nb_token *token, const char *name) {
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(name);
  for (size_t i = 0; i < reader->binding_count; i++)
    nb_guess_offer(&guess, reader->bindings[i].name);
  nb_token_mistake(reader, token, nb_guess_hint(&guess, hint),
                   "expected a $NAME that a `let` or `sweep` above defines, found `$%s`", name);
}

/* A token that holds a $NAME: `$v`, `-$v`. A value with a unit gives two tokens, the second one begun here. False: no
 * room. */
static bool put_named(struct nb_reader *reader, struct nb_token *token, struct store *store, const char *word,
                      size_t length) {
  const char *dollar = memchr(word, '$', length), *name = dollar + 1, *end = word + length;
  const char *after = name;
  while (after < end && name_letter(*after))
    after++;
  char text[NB_NAME_SIZE] = "";
  if ((size_t)(after - name) < sizeof text)
    memcpy(text, name, (size_t)(after - name));
  const struct nb_binding *binding = binding_of(reader, name, (size_t)(after - name));
  if (!binding && !(reader->unsure & NB_UNSURE_VALUES))
    unknown_name(reader, token, text);
  token->hollow = !binding || !binding->text[0];
  if (token->hollow)
    return put(store, word, length);
  token->name = binding->name;
  size_t number = strcspn(binding->text, " ");
  bool unit = binding->text[number] != '\0';
  if (!put(store, word, (size_t)(dollar - word)) || !put(store, binding->text, number))
    return false;
  if (!unit || after < end)
    return put(store, after, (size_t)(end - after));
  if (reader->count + 1 >= NB_TOKENS_MAX)
    return false;
  store->at++, store->left--; /* past the number's terminating zero */
  struct nb_token *second = &reader->tokens[++reader->count];
  *second = *token;
  second->text = store->at;
  return put(store, binding->text + number + 1, strlen(binding->text + number + 1));
}

/* The last two tokens are one when they are the unit `per cycle`. */
static void join_per_cycle(struct nb_reader *reader) {
  if (reader->count < 2 || strcmp(reader->tokens[reader->count - 1].text, "cycle") != 0)
    return;
  const struct nb_token *last = &reader->tokens[reader->count - 1];
  struct nb_token *per = &reader->tokens[reader->count - 2];
  if (per->hollow || last->hollow || per->name || last->name || strcmp(per->text, "per") != 0)
    return;
  per->text = NB_PER_CYCLE;
  per->length = last->column + last->length - per->column;
  reader->count--;
}

bool nb_line_read(struct nb_reader *reader, size_t line) {
  const char *text = line > 0 && line <= reader->page->line_count ? reader->page->lines[line - 1] : "";
  /* In a --set text the first `=` parts name and value, as a blank would. */
  const char *equals = reader->page->kind_of ? NULL : strchr(text, '=');
  struct store store = {reader->store, sizeof reader->store};
  reader->line = line;
  reader->count = reader->next = 0;
  reader->bad = reader->muted = false;
  reader->keyword = NULL;
  for (size_t i = 0;;) {
    while (blank(text[i]) || (equals && text + i == equals))
      i++;
    if (!text[i] || text[i] == '#')
      break;
    size_t length = 1;
    while (text[i + length] && text[i + length] != '#' && !blank(text[i + length]) && text + i + length != equals)
      length++;
    struct nb_token *token = &reader->tokens[reader->count];
    *token = (struct nb_token){store.at, characters(text, i) + 1, characters(text + i, length), NULL, false};
    bool room = reader->count < NB_TOKENS_MAX - 1;
    if (room && memchr(text + i, '$', length))
      room = put_named(reader, token, &store, text + i, length);
    else if (room)
      room = put(&store, text + i, length);
    if (!room) {
      nb_mistake(reader->mistakes, reader->page, line, token->column, token->length, NULL,
                 "expected at most %d words in a line, found more", NB_TOKENS_MAX - 1);
      reader->bad = reader->muted = true;
      return reader->count > 0;
    }
    store.at++, store.left--;
    reader->count++;
    join_per_cycle(reader);
    i += length;
  }
  return reader->count > 0;
}

const struct nb_token *nb_token_peek(const struct nb_reader *reader) {
  return reader->next < reader->count ? &reader->tokens[reader->next] : NULL;
}

bool nb_token_is(const struct nb_reader *reader, const char *word) {
  const struct nb_token *token = nb_token_peek(reader);
  return token && strcmp(token->text, word) == 0;
}

bool nb_token_skip(struct nb_reader *reader, const char *word) {
  bool is = nb_token_is(reader, word);
  reader->next += is;
  return is;
}

void nb_token_mistake(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *format,
                      ...) {
  reader->bad = true;
  if (reader->muted)
    return;
  char text[1024];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  int column = 1, length = 1;
  if (token) {
    column = token->column;
    length = token->length;
  } else if (reader->count > 0) {
    const struct nb_token *last = &reader->tokens[reader->count - 1];
    column = last->column + last->length;
  }
  nb_mistake(reader->mistakes, reader->page, reader->line, column, length, hint, "%s", text);
}

void nb_line_mistake(struct nb_reader *reader, size_t line, const char *hint, const char *format, ...) {
  char text[1024];
  va_list list;
  va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  va_end(list);
  nb_token_mistake(reader, nb_line_read(reader, line) ? &reader->tokens[0] : NULL, hint, "%s", text);
}

void nb_expected(struct nb_reader *reader, const char *hint, const char *format, ...) {
  char what[512];
  const struct nb_token *token = nb_token_peek(reader);
  va_list list;
  va_start(list, format);
  vsnprintf(what, sizeof what, format, list);
  va_end(list);
  if (token && token->hollow)
    reader->bad = true;
  else if (!token)
    nb_token_mistake(reader, NULL, hint, "expected %s, found the end of the line", what);
  else if (token->name)
    nb_token_mistake(reader, token, hint, "expected %s, found `%.80s` (`$%s`)", what, token->text, token->name);
  else
    nb_token_mistake(reader, token, hint, "expected %s, found `%.80s`", what, token->text);
  reader->next = reader->count;
}
