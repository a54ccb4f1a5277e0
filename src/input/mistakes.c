/* Messages about mistakes in a page, all together and in line order:
 *
 *   PATH:12:29: error: expected a length and its unit (m, mm, um, nm, cm, km), found `50`
 *      12 | lattice discs 3 by 3 radius 50 rock
 *         |                             ^~
 *     hint: write `50 m` or `50 mm`
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "reader.h"
#include "text.h"

enum { MISTAKES_MAX = 1000 };

/* The position of a message in the text, and its line and column in the page. */
struct position {
  size_t start;
  size_t line;
  int column;
};
struct name {
  char name[2 * NB_NAME_SIZE];
};

struct nb_mistakes_inside {
  struct position *positions; /* one for each message */
  struct name *suppressed;    /* names about which messages are suppressed */
  size_t suppressed_count;
};

void nb_mistakes_free(struct nb_mistakes *mistakes) {
  if (mistakes->inside)
    free(mistakes->inside->positions), free(mistakes->inside->suppressed);
  free(mistakes->inside);
  free(mistakes->text);
  memset(mistakes, 0, sizeof *mistakes);
}

static struct nb_mistakes_inside *inside(struct nb_mistakes *mistakes) {
  if (!mistakes->inside)
    mistakes->inside = calloc(1, sizeof *mistakes->inside);
  if (!mistakes->inside)
    nb_mistake_memory(mistakes);
  return mistakes->inside;
}

/* Number of bytes of the first n characters. */
static int bytes_of(const char *c, int n) {
  int bytes = 0;
  while (n > 0 && c[bytes]) {
    bytes++;
    while ((c[bytes] & 0xC0) == 0x80)
      bytes++; /* further bytes of the same character */
    n--;
  }
  return bytes;
}

/* Adds the line of the page, with its number unless that is 0, and below `column` a mark of `length` characters. Tabs
 * are copied, so that line and mark stay aligned. Only the part of a long line around the mark is shown. */
static void add_line(struct nb_text *text, const char *line, size_t number, int column, int length) {
  enum { WIDEST = 110 };
  int first = column > WIDEST - 30 ? column - 60 : 1;
  const char *shown = line + bytes_of(line, first - 1);
  int bytes = bytes_of(shown, WIDEST);
  bool before = shown > line, after = shown[bytes] != '\0';
  if (number)
    nb_text_add(text, "%5zu | ", number);
  else
    nb_text_add(text, "      | ");
  nb_text_add(text, "%s%.*s%s\n      | %s", before ? "…" : "", bytes, shown, after ? "…" : "", before ? " " : "");
  for (int i = first; i < column; i++) {
    nb_text_add(text, "%c", *shown == '\t' ? '\t' : ' ');
    shown += bytes_of(shown, 1);
  }
  nb_text_add(text, "^");
  for (int i = 1; i < length && column + i < first + WIDEST; i++)
    nb_text_add(text, "~");
  nb_text_add(text, "\n");
}

/* The position at which to insert a message: after the messages of other pages, and after those of this page for
 * earlier lines and columns. */
static size_t position_of(const struct nb_mistakes *mistakes, const char *path, size_t line, int column) {
  size_t at = mistakes->count, length = strlen(path);
  for (; at > 0; at--) {
    const struct position *before = &mistakes->inside->positions[at - 1];
    if (strncmp(mistakes->text + before->start, path, length) != 0)
      break;
    if (before->line < line || (before->line == line && before->column <= column))
      break;
  }
  return at;
}

/* True if the last message before this position is the same: a check of stages finds a mistake in a line again in each
 * stage that `repeat` makes of it. */
static bool is_known(const struct nb_mistakes *mistakes, size_t at, const struct nb_text *message) {
  return at > 0 &&
         strncmp(mistakes->text + mistakes->inside->positions[at - 1].start, message->at, message->length) == 0;
}

static void insert(struct nb_mistakes *mistakes, const char *path, size_t line, int column,
                   const struct nb_text *message) {
  struct nb_mistakes_inside *internals = inside(mistakes);
  size_t count = mistakes->count, at = internals ? position_of(mistakes, path, line, column) : 0;
  if (is_known(mistakes, at, message))
    return;
  size_t end = mistakes->text ? strlen(mistakes->text) : 0;
  struct position *positions = internals ? nb_array_reserve(internals->positions, count, 1, sizeof *positions) : NULL;
  char *text = positions ? realloc(mistakes->text, end + message->length + 1) : NULL;
  if (positions)
    internals->positions = positions;
  if (!text) {
    mistakes->no_memory = true;
    return;
  }
  const size_t start = at < count ? positions[at].start : end;
  mistakes->text = text;
  memmove(text + start + message->length, text + start, end - start);
  memcpy(text + start, message->at, message->length);
  text[end + message->length] = '\0';
  memmove(positions + at + 1, positions + at, (count - at) * sizeof *positions);
  positions[at] = (struct position){start, line, column};
  for (size_t i = at + 1; i <= count; i++)
    positions[i].start += message->length;
  mistakes->count++;
}

void nb_mistake_memory(struct nb_mistakes *mistakes) { mistakes->total++, mistakes->no_memory = true; }

enum nb_status nb_mistakes_status(const struct nb_mistakes *mistakes, size_t before) {
  return mistakes->no_memory ? NB_NO_MEMORY : mistakes->total > before ? NB_BAD_USE : NB_OK;
}

void nb_mistake(struct nb_mistakes *mistakes, const struct nb_page *page, size_t line, int column, int length,
                const char *hint, const char *format, ...) {
  mistakes->total++;
  if (mistakes->count > MISTAKES_MAX)
    return;
  struct nb_text message = {0};
  bool in_file = page->kind_of != NULL;
  if (line && in_file)
    nb_text_add(&message, "%s:%zu:%d: error: ", page->path, line, column);
  else
    nb_text_add(&message, "%s: error: ", page->path);
  va_list list;
  va_start(list, format);
  nb_text_add_arguments(&message, format, list);
  va_end(list);
  nb_text_add(&message, "\n");
  if (line && line <= page->line_count)
    add_line(&message, page->lines[line - 1], in_file ? line : 0, column, length);
  char named[NB_HINT_SIZE];
  if (hint && hint[0])
    nb_text_add(&message, "  hint: %s\n", nb_page_hint(named, page, line, hint));
  if (!message.failed && mistakes->count == MISTAKES_MAX) {
    line = page->line_count + 1, message.length = 0;
    nb_text_add(&message, "%s: error: more than %d mistakes; the others are not shown\n", page->path, MISTAKES_MAX);
  }
  if (message.failed)
    mistakes->no_memory = true;
  else
    insert(mistakes, page->path, line, column, &message);
  free(message.at);
}

bool nb_mistake_hinted(const struct nb_mistakes *mistakes, size_t line, const char *text) {
  const struct position *const last = mistakes->count ? &mistakes->inside->positions[mistakes->count - 1] : NULL;
  const char *const hint = last && last->line == line ? strstr(mistakes->text + last->start, "\n  hint: ") : NULL;
  return hint && strstr(hint, text);
}

/* ---- names ---- */

void nb_suppress_name(struct nb_mistakes *mistakes, const char *name) {
  struct nb_mistakes_inside *internals = inside(mistakes);
  if (!internals || nb_name_suppressed(mistakes, name) || strlen(name) >= sizeof internals->suppressed->name)
    return;
  struct name *suppressed = NB_ARRAY_APPEND(internals->suppressed, internals->suppressed_count);
  if (suppressed)
    strcpy(suppressed->name, name);
  else
    nb_mistake_memory(mistakes);
}

bool nb_name_suppressed(const struct nb_mistakes *mistakes, const char *name) {
  const struct nb_mistakes_inside *internals = mistakes->inside;
  char stem[2 * NB_NAME_SIZE];
  const char *const names[] = {name, stem, NB_ANYTHING};
  snprintf(stem, sizeof stem, "%.*s", (int)strcspn(name, "."), name);
  for (size_t k = 0; internals && k < sizeof names / sizeof *names; k++)
    if (NB_FIND(internals->suppressed, internals->suppressed_count, names[k]) >= 0)
      return true;
  return false;
}

bool nb_statement_suppressed(const struct nb_mistakes *mistakes, const char *word) {
  return nb_name_suppressed(mistakes, word) || nb_name_suppressed(mistakes, NB_UNKNOWN);
}

void nb_suppress_no_name(struct nb_mistakes *mistakes) {
  if (mistakes->inside)
    mistakes->inside->suppressed_count = 0;
}

int nb_find(const void *things, size_t count, size_t size, const char *name) {
  for (size_t i = 0; i < count; i++)
    if (strcmp((const char *)things + i * size, name) == 0)
      return (int)i;
  return -1;
}

/* ---- did you mean ---- */

const char *nb_nearest(char *hint, const char *word, const void *things, size_t count, size_t size) {
  struct nb_guess guess = nb_guess_begin(word);
  for (size_t i = 0; i < count; i++)
    nb_guess_offer(&guess, (const char *)things + i * size);
  return nb_guess_hint(&guess, hint);
}
