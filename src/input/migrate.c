/* Rewrites a page of version 0.3. Every line of its blocks is rewritten by the table of old words; prose and line ends
 * stay.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "old_words.h"
#include "reader.h"

/* The kind of block that a fence begins; -1: prose. */
static int block_of(const char *info) {
  static const enum nb_old_block blocks[] = {[NB_BLOCK_SCENE] = NB_OLD_STATEMENTS,
                                             [NB_BLOCK_CONTACT_TEST] = NB_OLD_STATEMENTS,
                                             [NB_BLOCK_EXPECT] = NB_OLD_EXPECTATIONS,
                                             [NB_BLOCK_GNUPLOT] = NB_OLD_GNUPLOT};
  const int kind = nb_page_kind(info, strcspn(info, " \t\r"));
  return kind < 0 ? -1 : (int)blocks[kind];
}

void nb_migrate(struct nb_text *text, char *page, const char *path, FILE *warnings) {
  size_t number = 1;
  size_t open = 0; /* length of the fence of the open block; 0: the line is outside blocks */
  char sign = 0, s, *end;
  int block = -1;
  for (char *line = page; *line; line = end + (*end != '\0')) {
    const char *info;
    end = line + strcspn(line, "\n");
    const char ending[] = {*end, '\0'};
    *end = '\0';
    const size_t fence = nb_fence(line, &s, &info), start = text->length;
    const bool closes = open && fence >= open && s == sign && info[strspn(info, "\r")] == '\0';
    const bool words = open && !closes && block >= 0, opens = !open && fence;
    const enum nb_old_block kind = words ? (enum nb_old_block)block : opens ? NB_OLD_OPENING : NB_OLD_PROSE;
    nb_old_line(text, line, kind);
    nb_old_warn(warnings, path, number++, line, kind);
    if (opens && !text->failed && nb_fence(text->at + start, &s, &info))
      open = fence, sign = s, block = block_of(info);
    else if (closes)
      open = 0;
    nb_text_add(text, "%s", ending);
    *end = ending[0];
  }
}
