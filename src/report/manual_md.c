/* The manual as Markdown, docs/LANGUAGE.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "manual.h"

static void section(FILE *out, const char *title) { fprintf(out, "## %s\n\n", title); }
static void words(FILE *out, const char *text) { fprintf(out, "%s\n\n", text); }
static void item(FILE *out, const char *word, const char *syntax, const char *help) {
  fprintf(out, "### %s\n\n`%s`\n\n%s\n\n", word, syntax, help);
}
static void part(FILE *out, const char *name, const char *text) { fprintf(out, "- `%s`: %s\n", name, text); }
static void row(FILE *out, const char *name, const char *unit, const char *text) {
  fprintf(out, "- `%s`%s%s: %s\n", name, unit && *unit ? ", " : "", unit ? unit : "", text);
}
static void example(FILE *out, const char *block, const char *lines) {
  fprintf(out, "\n```%s\n%s\n```\n", block, lines);
}
static void end(FILE *out) { fputc('\n', out); }

const struct nb_manner nb_manner_md = {section, words, item, part, row, example, end, end};

void nb_manual_md(FILE *out) {
  fputs("# The language of pages\n\n"
        "Every word that a page may use. This document is made by the program, from the tables that it reads pages by: "
        "`make language` writes it anew. It is a page itself: its examples, one after the other, are a scene, and "
        "`nineball explain docs/LANGUAGE.md` says what would run. On the terminal: `nineball --help scene`, and "
        "`nineball --help disc` for one word.\n\n",
        out);
  nb_manual_language(out, &nb_manner_md, true);
}
