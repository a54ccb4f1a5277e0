/* The manual for the terminal.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "manual.h"

/* The text from column `indent` on, in lines of 100 characters, none before the last word that fits. */
static void wrapped(FILE *out, int indent, const char *text) {
  enum { WIDEST = 100 };
  int column = indent;
  fprintf(out, "%*s", indent, "");
  for (const char *word = text; *word;) {
    const size_t length = strcspn(word, " ");
    int letters = 0;
    for (size_t k = 0; k < length; k++)
      letters += (word[k] & 0xC0) != 0x80;
    if (column > indent && column + 1 + letters > WIDEST) {
      fprintf(out, "\n%*s", indent, "");
      column = indent;
    } else if (column > indent) {
      fputc(' ', out);
      column++;
    }
    fwrite(word, 1, length, out);
    column += letters;
    word += length + strspn(word + length, " ");
  }
  fputc('\n', out);
}

static void section(FILE *out, const char *title) { fprintf(out, "\n%s\n\n", title); }

static void words(FILE *out, const char *text) {
  wrapped(out, 2, text);
  fputc('\n', out);
}

static void item(FILE *out, const char *word, const char *syntax, const char *help) {
  (void)word;
  wrapped(out, 2, syntax);
  wrapped(out, 6, help);
}

static void part(FILE *out, const char *name, const char *text) {
  char line[1024];
  snprintf(line, sizeof line, "%s: %s", name, text);
  wrapped(out, 8, line);
}

static void row(FILE *out, const char *name, const char *unit, const char *text) {
  if (unit)
    fprintf(out, "  %-18s %-8s %s\n", name, unit, text);
  else
    fprintf(out, "  %-27s %s\n", name, text);
}

static void example(FILE *out, const char *block, const char *lines) {
  (void)block;
  fputs("\n        ", out);
  for (const char *c = lines; *c; c++)
    fputs(*c == '\n' ? "\n        " : (char[]){*c, 0}, out);
  fputs("\n", out);
}

static void end(FILE *out) { fputc('\n', out); }

const struct nb_manner nb_manner_text = {section, words, item, part, row, example, end, end};
