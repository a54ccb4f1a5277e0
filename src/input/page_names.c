/* The names of the page in hints: a line between backquotes that a hint proposes has the material, the grading and the
 * stage of the page in place of MATERIAL, GRADING and STAGE, so that it can be typed as it stands. A line `start
 * THIS-PAGE stage NAME` has the name of the page, its last stage and, for each sweep, the first value.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "core/clean.h"
#include "reader.h"

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

/* The next word of a text before a comment; *length: its length, 0 at the end. */
static const char *next_word(const char *at, size_t *length) {
  while (is_blank(*at))
    at++;
  *length = strcspn(at, " \t#");
  return at;
}

bool nb_page_statement(const struct nb_page *page, size_t line, const char *verb, const char **rest) {
  const int kind = page->kind_of ? page->kind_of[line - 1] : 0;
  size_t length;
  if (kind != 1 + NB_BLOCK_SCENE && kind != 1 + NB_BLOCK_CONTACT_TEST)
    return false;
  const char *const word = next_word(page->lines[line - 1], &length);
  *rest = word + length;
  return strlen(verb) == length && strncmp(word, verb, length) == 0;
}

/* True if the line has the word. */
static bool line_has(const char *line, const char *word) {
  size_t length;
  for (const char *at = next_word(line, &length); length; at = next_word(at + length, &length))
    if (strlen(word) == length && strncmp(at, word, length) == 0)
      return true;
  return false;
}

bool nb_page_name_of(char name[NB_NAME_SIZE], const struct nb_page *page, const char *verb, size_t line) {
  const char *const typed = line > 0 && line <= page->line_count ? page->lines[line - 1] : "", *rest;
  char found[NB_NAME_SIZE];
  size_t count = 0, length;
  for (size_t k = 1; k <= page->line_count; k++) {
    if (!nb_page_statement(page, k, verb, &rest))
      continue;
    rest = next_word(rest, &length);
    if (length == 0 || length >= sizeof found)
      continue;
    snprintf(found, sizeof found, "%.*s", (int)length, rest);
    if (!nb_is_name(found) || (count > 0 && strcmp(found, name) == 0))
      continue; /* a stage changes the material */
    strcpy(name, found);
    count++;
    if (k != line && line_has(typed, found))
      return true;
  }
  return count == 1;
}

/* The name of the last stage or segment of the page. */
static bool last_stage(char name[NB_NAME_SIZE], const struct nb_page *page) {
  const char *rest, *last = "";
  size_t length;
  for (size_t k = 1; k <= page->line_count; k++)
    if (nb_page_statement(page, k, "stage", &rest) || nb_page_statement(page, k, "segment", &rest))
      last = rest;
  rest = next_word(last, &length);
  snprintf(name, NB_NAME_SIZE, "%.*s", length < NB_NAME_SIZE ? (int)length : 0, rest);
  return nb_is_name(name);
}

/* Appends ` with mu=0.1`, for each sweep of the page its first name and the first value. */
static void append_runs(char *text, const struct nb_page *page) {
  const char *rest;
  char name[NB_NAME_SIZE], value[NB_NAME_SIZE], unit[NB_NAME_SIZE] = "";
  struct nb_unit read;
  int count = 0;
  for (size_t k = 1; k <= page->line_count; k++) {
    if (!nb_page_statement(page, k, "sweep", &rest) || sscanf(rest, " %63s", name) != 1)
      continue;
    for (int used = 0; sscanf(rest, " %*s with%n", &used) == 0 && used > 0; used = 0) /* `sweep a with b` */
      rest += used;
    const int words = sscanf(rest, " %*s %63s %63s", value, unit);
    if (words > 0 && !strpbrk(value, "=,[]{}")) /* a list of another language is a mistake */
      nb_append(text, NB_HINT_SIZE, "%s%s=%s", count++ ? " " : " with ", name, value);
    if (words > 1 && isdigit((unsigned char)value[strspn(value, "+-.")]) && nb_unit_read(&read, unit))
      nb_append(text, NB_HINT_SIZE, " %s", unit);
  }
}

/* Finds the name of the page for a word in capitals; `before`: the word before it; `text`: the line of the hint. */
static bool find_name(char name[NB_NAME_SIZE], const struct nb_page *page, size_t line, const char *word,
                      const char *before, const char *text) {
  if (strcmp(word, "THIS-PAGE") == 0)
    return snprintf(name, NB_NAME_SIZE, "%s", page->name) > 0;
  if (strcmp(word, "NAME") == 0 && strncmp(text, "start ", 6) == 0)
    return last_stage(name, page);
  if (strcmp(word, "MATERIAL") == 0)
    return nb_page_name_of(name, page, "material", line);
  if (strcmp(word, "GRADING") == 0)
    return nb_page_name_of(name, page, "grading", line);
  return strcmp(word, "STAGE") == 0 && strcmp(before, "in") == 0 && last_stage(name, page);
}

/* True for a word in capitals that stands for a value: `MATERIAL`, `X`. After a number `N` is a unit, and after `monitor`
 * or `region` a letter is a name. */
static bool stands_for_value(const char *word, const char *before) {
  const size_t capitals = strspn(word, "ABCDEFGHIJKLMNOPQRSTUVWXYZ");
  return capitals > 0 && !word[capitals] && !nb_number_length(before) && strcmp(before, "monitor") != 0 &&
         strcmp(before, "region") != 0;
}

/* Appends a line of `length` bytes, with the names of the page; false, and nothing is appended, if another word stands
 * for a value: then the line is the syntax of a statement. */
static bool append_line(char *text, const char *line, size_t length, const struct nb_page *page, size_t number) {
  char word[NB_NAME_SIZE], before[NB_NAME_SIZE] = "", name[NB_NAME_SIZE], made[NB_HINT_SIZE] = "";
  bool found = false;
  if (strncmp(line, "in ", 3) == 0)
    return false; /* `in STAGE`, a part of a line */
  for (size_t at = 0, n; at < length; at += n) {
    const size_t blanks = strspn(line + at, " ");
    n = blanks ? blanks : strcspn(line + at, " ");
    n = at + n > length ? length - at : n;
    snprintf(word, sizeof word, "%.*s", n < sizeof word ? (int)n : 0, line + at);
    const bool known = !blanks && find_name(name, page, number, word, before, line);
    if (!blanks && !known && stands_for_value(word, before))
      return false;
    found = found || known;
    nb_append(made, sizeof made, "%.*s", known ? (int)strlen(name) : (int)n, known ? name : line + at);
    if (!blanks)
      strcpy(before, word);
  }
  if (found)
    nb_append(text, NB_HINT_SIZE, "%s", made);
  return found;
}

const char *nb_page_hint(char *text, const struct nb_page *page, size_t line, const char *hint) {
  *text = '\0';
  for (const char *at = hint; *at;) {
    const bool start = strncmp(at + strcspn(at, "`"), "`start THIS-PAGE ", strlen("`start THIS-PAGE ")) == 0;
    const size_t prose = strcspn(at, "`"), quoted = at[prose] ? strcspn(at + prose + 1, "`") : 0;
    nb_append(text, NB_HINT_SIZE, "%.*s", (int)prose + (at[prose] == '`'), at);
    at += prose + (at[prose] == '`');
    if (quoted && at[quoted] == '`' && !append_line(text, at, quoted, page, line))
      nb_append(text, NB_HINT_SIZE, "%.*s", (int)quoted, at);
    else if (quoted && at[quoted] != '`')
      nb_append(text, NB_HINT_SIZE, "%s", at);
    at += quoted;
    if (start)
      append_runs(text, page);
    if (quoted && *at == '`')
      nb_append(text, NB_HINT_SIZE, "`"), at++;
  }
  return text;
}
