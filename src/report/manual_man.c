/* The manual as a man page, docs/nineball.1: man(7), which groff and mandoc read.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "manual.h"

/* Letters that roff would take for its own, and `code` in bold. Non-ASCII ones are known to groff by names. */
static void roff(FILE *out, const char *text) {
  bool bold = false, first = true;
  for (const char *c = text; *c; c++) {
    if (first && (*c == '.' || *c == '\''))
      fputs("\\&", out);
    first = *c == '\n';
    if (*c == '`')
      fputs((bold = !bold) ? "\\fB" : "\\fR", out);
    else if (*c == '\\')
      fputs("\\e", out);
    else if (*c == '-')
      fputs("\\-", out);
    else if (strncmp(c, "…", strlen("…")) == 0)
      fputs("...", out), c += strlen("…") - 1;
    else
      fputc(*c, out);
  }
}

static void section(FILE *out, const char *title) {
  fputs(".SH ", out);
  for (const char *c = title; *c; c++)
    fputc(toupper((unsigned char)*c), out);
  fputc('\n', out);
}

static void paragraph(FILE *out, const char *request, const char *text) {
  fprintf(out, "%s\n", request);
  roff(out, text);
  fputc('\n', out);
}

static void words(FILE *out, const char *text) { paragraph(out, ".PP", text); }

static void term(FILE *out, const char *name, const char *text) {
  fputs(".TP\n\\fB", out);
  roff(out, name);
  fputs("\\fR\n", out);
  roff(out, text);
  fputc('\n', out);
}

static void item(FILE *out, const char *word, const char *syntax, const char *help) {
  (void)word;
  term(out, syntax, help);
  fputs(".RS\n", out);
}

static void part(FILE *out, const char *name, const char *text) { term(out, name, text); }

static void row(FILE *out, const char *name, const char *unit, const char *text) {
  char line[512];
  snprintf(line, sizeof line, "%s%s%s", unit ? unit : "", unit && *unit ? ": " : "", text);
  term(out, name, line);
}

static void example(FILE *out, const char *block, const char *lines) {
  (void)block;
  fputs(".PP\n.EX\n", out);
  roff(out, lines);
  fputs("\n.EE\n", out);
}

static void end_item(FILE *out) { fputs(".RE\n", out); }
static void end_list(FILE *out) { (void)out; }

const struct nb_manner nb_manner_man = {section, words, item, part, row, example, end_item, end_list};

static void rows(FILE *out, const struct nb_help_row *list) {
  for (; list->term; list++)
    term(out, list->term, list->help);
}

void nb_manual_man(FILE *out, const struct nb_help_row *commands, const struct nb_help_row *options) {
  static const struct nb_help_row statuses[] = {
      {"0", "all checks passed"},
      {"1", "a check failed"},
      {"2", "bad use, a mistake in a page, a figure that cannot be drawn, or a file that cannot be read or written"},
      {"3", "run aborted: NaN, an unstable step, a stage that never ended; results up to then are kept, and "
            "marked as incomplete"},
      {"4", "out of memory"},
      {NULL, NULL},
  };
  static const struct nb_help_row variables[] = {
      {"NINEBALL_STATES", "the folder of states, unless --states says one"},
      {"NINEBALL_CONFINE",
       "landlock, bwrap or none: the only way in which gnuplot may be confined, instead of the first of "
       "the two that is available; without any, --trust must be given"},
      {NULL, NULL},
  };
  static const struct nb_help_row files[] = {
      {"NAME.out/table.tsv",
       "what the page records, a row a cycle; numbers as %.17g, which read back to the same bits"},
      {"NAME.out/values.tsv", "every measure that is expected, seen and known, a row a run"},
      {"NAME.out/verdict.tsv", "every expectation, and whether it passed"},
      {"NAME.out/STAGE-bodies.tsv, -walls.tsv, -contacts.tsv", "what `snapshot` keeps"},
      {"NAME.out/NAME.gp, NAME.svg, NAME.png", "the figure, and the script that drew it"},
      {NULL, NULL},
  };
  fputs(".\\\" Made by the program itself: make language\n"
        ".TH NINEBALL 1 \"\" nineball \"User Commands\"\n"
        ".SH NAME\nnineball \\- discs and spheres in the plane, by the distinct element method\n"
        ".SH SYNOPSIS\n.B nineball\n\\fICOMMAND\\fR [\\fIOPTION\\fR ...] [\\fIPAGE\\fR ...]\n"
        ".br\n.B nineball \\-\\-help\n[\\fBscene\\fR|\\fIWORD\\fR]\n",
        out);
  section(out, "Description");
  words(out,
        "`nineball` runs pages. A page is a Markdown file that says what there is and what happens (blocks `scene`), "
        "what "
        "should be seen (blocks `expect`) and how to draw it (block `gnuplot`). What is seen is held against what a "
        "reference knows, and every page marks itself.");
  section(out, "Commands");
  rows(out, commands);
  section(out, "Options");
  rows(out, options);
  section(out, "Exit status");
  rows(out, statuses);
  section(out, "Pages of others");
  words(
      out,
      "A page's `gnuplot` block is a program. `figure` and `report` run it confined, by Landlock or by bubblewrap: it "
      "can read fonts, libraries and the installed recipes only, write nothing but the figure, and start no other "
      "program. Where neither is available nothing is drawn, unless `--trust` is given. All else that a page can do "
      "is to have files read that it names in `packing`, `start` and `follow`.");
  section(out, "Environment");
  rows(out, variables);
  section(out, "Files");
  rows(out, files);
  nb_manual_language(out, &nb_manner_man, true);
  section(out, "See also");
  words(out, "`gnuplot`(1). The method: docs/METHOD.md; a first half hour: docs/TUTORIAL.md; this language as a page: "
             "docs/LANGUAGE.md.");
  section(out, "Copyright");
  words(out, "Copyright (C) 2026 the nineball authors. GPL-3.0-or-later: free software, without any warranty.");
}
