/* A page: a Markdown file and its fenced blocks.
 *
 * A fence is a line of three or more backticks or tildes, indented by at most three spaces. The block ends at a line
 * with at least as many of the same sign and nothing else. Without such a line the page is invalid; CommonMark 0.30,
 * section 4.5, would end the block at the end of the file. The first word after the opening fence is the kind of the
 * block. Blocks of unknown kinds are prose.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/clean.h"
#include "hash.h"
#include "old_words.h"
#include "reader.h"

static const char *const kinds[NB_BLOCK_KINDS] = {[NB_BLOCK_SCENE] = "scene",
                                                  [NB_BLOCK_EXPECT] = "expect",
                                                  [NB_BLOCK_GNUPLOT] = "gnuplot",
                                                  [NB_BLOCK_CONTACT_TEST] = "contact-test"};

void nb_page_free(struct nb_page *page) {
  for (size_t i = 0; i < page->line_count; i++)
    free(page->lines[i]);
  free(page->lines);
  free(page->kind_of);
  free(page->path);
  memset(page, 0, sizeof *page);
}

/* Replaces bytes that are not UTF-8 text by question marks, and reports the first one. */
static void check_text(struct nb_page *page, size_t line, char *text, size_t length, struct nb_mistakes *mistakes) {
  unsigned byte;
  const int first = nb_clean(text, length, &byte);
  if (first)
    nb_mistake(mistakes, page, line, first, 1, "save the page as plain text, UTF-8",
               "expected text, found the byte 0x%02X (shown as `?`)", byte);
}

static bool split_lines(struct nb_page *page, const char *bytes, size_t size, struct nb_mistakes *mistakes) {
  size_t at = size >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0; /* skip a byte order mark */
  while (at < size) {
    const char *end = memchr(bytes + at, '\n', size - at);
    size_t length = end ? (size_t)(end - bytes) - at : size - at, next = at + length + 1;
    if (length > 0 && bytes[at + length - 1] == '\r')
      length--;
    char **own = NB_ARRAY_APPEND(page->lines, page->line_count), *line = own ? malloc(length + 1) : NULL;
    if (!line)
      return false;
    *own = memcpy(line, bytes + at, length);
    line[length] = '\0';
    check_text(page, page->line_count, line, length, mistakes);
    if (length > NB_LINE_MAX) {
      line[60] = '\0'; /* shown in the message */
      nb_mistake(mistakes, page, page->line_count, 1, 1, NULL, "expected at most %d bytes in a line, found %zu",
                 NB_LINE_MAX, length);
    }
    at = next;
  }
  return true;
}

size_t nb_fence(const char *line, char *sign, const char **info) {
  *sign = '\0';
  *info = "";
  size_t spaces = strspn(line, " ");
  const char *c = line + spaces;
  if (spaces > 3 || (*c != '`' && *c != '~'))
    return 0;
  char both[2] = {*c, '\0'};
  size_t n = strspn(c, both);
  *sign = *c;
  *info = c + n + strspn(c + n, " \t");
  return n < 3 || (*sign == '`' && strchr(*info, '`')) ? 0 : n;
}

int nb_page_kind(const char *word, size_t length) {
  int kind = NB_BLOCK_KINDS - 1;
  while (kind >= 0 && !(strlen(kinds[kind]) == length && strncmp(word, kinds[kind], length) == 0))
    kind--;
  return kind;
}

/* The kind whose name is one typing error from the word, which the word means in another program, or with whose name
 * the word begins; NULL: none. */
static const char *near_kind(const char *word) {
  struct nb_guess guess = nb_guess_begin(word);
  for (int kind = 0; kind < NB_BLOCK_KINDS; kind++) {
    nb_guess_offer(&guess, kinds[kind]);
    if (guess.distance <= 1 || strncmp(word, kinds[kind], strlen(kinds[kind])) == 0)
      return kinds[kind];
  }
  return NULL;
}

/* The kind of block that an opening fence begins; -1: none. A misspelt kind is reported, because its block would be
 * ignored. */
static int kind_of_info(struct nb_page *page, size_t line, const char *info, struct nb_mistakes *mistakes) {
  char word[NB_NAME_SIZE], hint[NB_HINT_SIZE];
  const size_t signs = strspn(info, "{."), length = strcspn(info + signs, " \t}");
  if (length == 0 || length >= sizeof word)
    return -1;
  memcpy(word, info + signs, length);
  word[length] = '\0';
  const int kind = nb_page_kind(word, length);
  if (kind >= 0 && !signs)
    return kind;
  const char *near = near_kind(word), *old = nb_old_fence(hint, page->lines[line - 1]);
  const int whole = (int)strcspn(info, " \t");
  if (near && !old)
    snprintf(hint, sizeof hint, "did you mean `%s`?", near);
  if (near || old) {
    nb_mistake(mistakes, page, line, (int)(info + signs - page->lines[line - 1]) + 1, (int)length, hint,
               "expected a block of a known kind (scene, contact-test, expect, gnuplot), found `%.*s`", whole, info);
    page->misnamed++;
  }
  return near ? nb_page_kind(near, strlen(near)) : -1;
}

/* The length of the fence of an expect block that is not read, because it is in a quote, in a list, or indented by more
 * than three spaces; 0: the line is not such a fence. */
static size_t hidden_fence(const char *line, char *sign) {
  const char *info;
  const size_t n = nb_fence(line + strspn(line, " \t>*+-"), sign, &info);
  return strcspn(info, " \t") == strlen("expect") && strncmp(info, "expect", strlen("expect")) == 0 ? n : 0;
}

/* The block of the current line. */
struct open_block {
  size_t length, line; /* length and line of its fence; length 0: no block is open */
  char sign;
  int kind;
};

static bool closes(const struct open_block *block, const char *line) {
  char sign;
  const char *info;
  const size_t prefix = block->kind == NB_BLOCK_HIDDEN ? strspn(line, " \t>") : 0;
  return nb_fence(line + prefix, &sign, &info) >= block->length && sign == block->sign && *info == '\0';
}

static bool opens(struct open_block *block, struct nb_page *page, size_t line, struct nb_mistakes *mistakes) {
  const char *info, *text = page->lines[line - 1];
  block->line = line;
  if ((block->length = nb_fence(text, &block->sign, &info)))
    block->kind = kind_of_info(page, line, info, mistakes);
  else if ((block->length = hidden_fence(text, &block->sign)))
    block->kind = NB_BLOCK_HIDDEN;
  return block->length > 0;
}

/* Stores the first heading of level 1, truncated between characters. */
static void take_title(struct nb_page *page, const char *line) {
  if (page->title[0] || strncmp(line, "# ", 2) != 0)
    return;
  size_t length = strlen(line + 2);
  if (length >= sizeof page->title)
    length = sizeof page->title - 1;
  while (length > 0 && (line[2 + length] & 0xC0) == 0x80)
    length--;
  memcpy(page->title, line + 2, length);
  page->title[length] = '\0';
}

static void find_blocks(struct nb_page *page, struct nb_mistakes *mistakes) {
  struct open_block block = {.length = 0};
  for (size_t i = 0; i < page->line_count; i++) {
    const char *line = page->lines[i];
    if (block.length && block.kind == NB_BLOCK_HIDDEN && *line && strspn(line, " \t>") == 0)
      block.length = 0; /* the quote or the list ends */
    if (block.length && closes(&block, line))
      block.length = 0;
    else if (block.length)
      page->kind_of[i] = (unsigned char)(block.kind + 1);
    else if (!opens(&block, page, i + 1, mistakes))
      take_title(page, line);
  }
  if (block.length && block.kind != NB_BLOCK_HIDDEN) {
    char hint[NB_HINT_SIZE];
    const int column = (int)strspn(page->lines[block.line - 1], " ") + 1;
    snprintf(hint, sizeof hint, "close it with a line of nothing but %.*s", (int)block.length,
             page->lines[block.line - 1] + column - 1);
    nb_mistake(mistakes, page, block.line, column, (int)block.length, hint,
               "expected the end of the block that begins here, found the end of the page");
    /* the intended end of the block is unknown */
    memset(page->kind_of + block.line, 0, page->line_count - block.line);
  }
}

size_t nb_page_fence(const struct nb_page *page, enum nb_block_kind kind) {
  for (size_t i = 1; i < page->line_count; i++)
    if (page->kind_of[i] == 1 + kind)
      return i; /* the number, counted from 1, of the line before lines[i] */
  return 0;
}

size_t nb_page_name(const char *path, const char **name) {
  const char *slash = strrchr(path, '/');
  *name = slash ? slash + 1 : path;
  const size_t length = strlen(*name);
  return length > 3 && strcmp(*name + length - 3, ".md") == 0 ? length - 3 : length;
}

static void name_page(struct nb_page *page, struct nb_mistakes *mistakes) {
  const char *name;
  size_t length = nb_page_name(page->path, &name);
  if (length >= sizeof page->name) {
    nb_mistake(mistakes, page, 0, 0, 0, NULL, "expected a file name shorter than %d bytes", NB_NAME_SIZE);
    length = sizeof page->name - 1;
  }
  memcpy(page->name, name, length);
  page->name[length] = '\0';
}

/* Begins a page with its path and its name; false: no memory. */
static bool begin(struct nb_page *page, const char *path, struct nb_mistakes *mistakes) {
  *page = (struct nb_page){.path = malloc(strlen(path) + 1)};
  if (!page->path)
    return nb_mistake_memory(mistakes), false;
  strcpy(page->path, path);
  name_page(page, mistakes);
  return true;
}

/* `kept`: a page whose only mistakes are misspelt kinds is kept. */
static enum nb_status end(struct nb_page *page, struct nb_mistakes *mistakes, size_t before, bool kept) {
  const enum nb_status status = nb_mistakes_status(mistakes, before);
  if (status && !(kept && status == NB_BAD_USE && mistakes->total - before == page->misnamed))
    nb_page_free(page);
  return status;
}

static void set_content(struct nb_page *page, const char *bytes, size_t size, struct nb_mistakes *mistakes) {
  page->hash = nb_hash(NB_HASH_BEGIN, bytes, size);
  page->kind_of = calloc(size + 1, 1); /* at least one byte per line; not NULL for a page from a file */
  if (page->kind_of && split_lines(page, bytes, size, mistakes))
    find_blocks(page, mistakes);
  else
    nb_mistake_memory(mistakes);
}

enum nb_status nb_page_read_bytes(struct nb_page *page, const char *path, const char *bytes, size_t size,
                                  struct nb_mistakes *mistakes) {
  const size_t before = mistakes->total;
  if (begin(page, path, mistakes))
    set_content(page, bytes, size, mistakes);
  return end(page, mistakes, before, false);
}

/* Writes the hint for a path such as `cases/order` if there is no such file, but a file cases/order.md; otherwise
 * returns NULL. */
static const char *md_hint(char *hint, const char *path) {
  snprintf(hint, NB_HINT_SIZE, "%.*s.md", NB_HINT_SIZE / 2, path);
  if (access(path, F_OK) == 0 || access(hint, F_OK) != 0)
    return NULL;
  snprintf(hint, NB_HINT_SIZE, "did you mean `%.*s.md`?", NB_HINT_SIZE / 2, path);
  return hint;
}

static enum nb_status read_file(struct nb_page *page, const char *path, size_t most, bool kept,
                                struct nb_mistakes *mistakes) {
  const size_t before = mistakes->total;
  struct nb_error error;
  char hint[NB_HINT_SIZE];
  size_t size;
  if (!begin(page, path, mistakes))
    return NB_NO_MEMORY;
  char *bytes = nb_file_read(path, most, &size, &error);
  if (bytes)
    set_content(page, bytes, size, mistakes);
  else if (error.status == NB_NO_MEMORY)
    nb_mistake_memory(mistakes);
  else
    nb_mistake(mistakes, page, 0, 0, 0, md_hint(hint, path), "%s", error.text);
  free(bytes);
  return end(page, mistakes, before, kept);
}

enum nb_status nb_page_read_limited(struct nb_page *page, const char *path, size_t most, struct nb_mistakes *mistakes) {
  return read_file(page, path, most, false, mistakes);
}

enum nb_status nb_page_read_kept(struct nb_page *page, const char *path, struct nb_mistakes *mistakes) {
  return read_file(page, path, NB_PAGE_MAX, true, mistakes);
}

enum nb_status nb_page_read(struct nb_page *page, const char *path, struct nb_mistakes *mistakes) {
  return nb_page_read_limited(page, path, NB_PAGE_MAX, mistakes);
}
