/* The report: one static HTML page with verdicts and figures of all pages. It needs no server and no script.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "commands.h"

enum { FOLD_LIMIT = 20 }; /* checks; longer lists are folded unless one failed */

/* Writes HTML, an escaped text, and HTML. */
static void text(FILE *out, const char *before, const char *words, const char *after) {
  static const struct nb_escape list[] = {{'<', "&lt;"},   {'>', "&gt;"},   {'&', "&amp;"},
                                          {'"', "&quot;"}, {'\'', "&#39;"}, {0, NULL}};
  fputs(before, out);
  nb_print_escaped(out, words, list);
  fputs(after, out);
}

/* An attribute with the URL FOLDER/NAME.KIND, percent-encoded (RFC 3986). */
static void address(FILE *out, const char *attribute, const char *folder, const char *name, const char *kind) {
  fprintf(out, "%s=\"", attribute);
  for (int k = 0; k < 2; k++) {
    for (const char *c = k == 0 ? folder : name; *c; c++)
      fprintf(out, isalnum((unsigned char)*c) || strchr("-_.", *c) ? "%c" : "%%%02X", (unsigned char)*c);
    fputs(k == 0 ? "/" : kind, out);
  }
  fputc('"', out);
}

static void write_link(FILE *out, const char *before, const struct nb_report_line *line, const char *file,
                       const char *kind, const char *word) {
  fprintf(out, "%s<a ", before);
  address(out, "href", line->name, file, kind);
  fprintf(out, ">%s</a>", word);
}

static const char style[] =
    "body{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{border-collapse:collapse;width:100%;margin:1rem 0;font-size:.85rem}"
    "td,th{text-align:left;padding:.25rem .6rem;border-bottom:1px solid #ddd;vertical-align:top}"
    "img{max-width:100%}.pass{color:#17652b}.fail{color:#a3123a;font-weight:bold}h2{margin-top:3rem}"
    "@media(prefers-color-scheme:dark){body{background:#111;color:#ddd}td,th{border-color:#444}.pass{color:#7ccf8f}"
    ".fail{color:#ff8095}a{color:#9cf}}";

static void write_summary(FILE *out, const struct nb_report_line *lines, size_t count) {
  fputs("<table><tr><th>page</th><th>about</th><th>checks</th><th>failed</th><th>noted</th><th>skipped</"
        "th><th>seconds</th></tr>\n",
        out);
  for (size_t k = 0; k < count; k++) {
    const struct nb_report_line *line = &lines[k];
    const size_t *mark_count = line->outcome.mark_count, checks = mark_count[NB_PASS] + mark_count[NB_FAIL];
    fprintf(out, "<tr><td><a href=\"#page%zu\">", k + 1);
    text(out, "", line->name, "</a></td><td>");
    text(out, "", line->outcome.page.title, "</td>");
    if (line->outcome.status > NB_FAILED) {
      fputs("<td colspan=\"5\" class=\"fail\">did not run to its end</td></tr>\n", out);
      continue;
    }
    fprintf(out, "<td>%zu</td><td class=\"%s\">%zu%s%s</td>", checks,
            mark_count[NB_FAIL] || !checks || line->message[0] ? "fail" : "pass", mark_count[NB_FAIL],
            checks ? "" : ", nothing was checked",
            !line->message[0] ? ""
            : line->saved     ? ", no figure"
                              : ", no tables");
    fprintf(out, "<td>%zu</td><td>%zu</td><td>%.2f</td></tr>\n", mark_count[NB_NOTE], mark_count[NB_SKIP],
            line->seconds);
  }
  fputs("</table>\n", out);
}

static void write_checks(FILE *out, const struct nb_outcome *outcome) {
  const size_t *mark_count = outcome->mark_count;
  fprintf(out,
          "<details%s><summary>%zu checks, %zu "
          "failed, %zu noted, %zu skipped</summary>\n<table><tr><th></th><th>expected</th><th>computed</th></tr>\n",
          outcome->check_count < FOLD_LIMIT || mark_count[NB_FAIL] ? " open" : "",
          mark_count[NB_PASS] + mark_count[NB_FAIL], mark_count[NB_FAIL], mark_count[NB_NOTE], mark_count[NB_SKIP]);
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    fprintf(out, "<tr><td class=\"%s\">%s", /* note and skip have no style */
            check->mark == NB_FAIL ? "fail" : nb_mark_word(check->mark), nb_mark_word(check->mark));
    text(out, "</td><td>", check->label, "</td>");
    text(out, "<td>", check->message, "</td></tr>\n");
  }
  fputs("</table></details>\n", out);
}

static void write_page(FILE *out, const struct nb_report_line *line, size_t number) {
  const struct nb_outcome *outcome = &line->outcome;
  fprintf(out, "<h2 id=\"page%zu\">", number);
  text(out, "", outcome->page.title[0] ? outcome->page.title : line->name, "</h2>\n");
  if (line->message[0])
    text(out, "<p class=\"fail\">", line->message, "</p>\n");
  for (size_t k = 0; k < outcome->warnings.count; k++) {
    const struct nb_warning *warning = &outcome->warnings.list[k];
    fputs("<p>Warning: ", out);
    if (warning->line)
      fprintf(out, "line %d: ", warning->line);
    text(out, "", warning->text, "</p>\n");
  }
  if (line->drawn) {
    fputs("<p><img ", out);
    address(out, "src", line->name, line->name, ".svg");
    text(out, " alt=\"figure of ", line->name, "\"></p>\n");
  }
  if (outcome->check_count)
    write_checks(out, outcome);
  if (!line->saved)
    return;
  write_link(out, "<p>Files: ", line, "table", ".tsv", "table");
  write_link(out, ", ", line, "values", ".tsv", "values");
  write_link(out, ", ", line, "verdict", ".tsv", "verdict");
  if (line->drawn) {
    write_link(out, ", figure as ", line, line->name, ".png", "PNG");
    write_link(out, " and ", line, line->name, ".gp", "script");
  }
  fputs("</p>\n", out);
}

/* The heading, and the numbers of pages, checks and failures. */
static void write_head(FILE *out, const struct nb_report_line *lines, size_t count) {
  size_t checks = 0, failed = 0, broken = 0, bare = 0, unchecked = 0;
  for (size_t k = 0; k < count; k++) {
    const size_t *mark_count = lines[k].outcome.mark_count, compared = mark_count[NB_PASS] + mark_count[NB_FAIL];
    const bool stopped = lines[k].outcome.status > NB_FAILED;
    checks += compared, failed += mark_count[NB_FAIL], broken += stopped;
    bare += !stopped && lines[k].message[0];
    unchecked += !stopped && compared == 0;
  }
  fprintf(out,
          "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta http-equiv=\"Content-Security-Policy\" "
          "content=\"default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'\"><title>nineball "
          "report</title><style>%s</style>\n",
          style);
  fprintf(out, "<h1>nineball %s</h1>\n<p>%zu pages, %zu checks, <span class=\"%s\">%zu failed</span>", NB_VERSION,
          count, checks, failed ? "fail" : "pass", failed);
  const struct {
    size_t pages;
    const char *what;
  } wrong[] = {{broken, "did not run to their end"},
               {unchecked, "on which nothing was checked"},
               {bare, "without figure or tables"}};
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
    if (wrong[k].pages)
      fprintf(out, ", <span class=\"fail\">%zu %s</span>", wrong[k].pages, wrong[k].what);
  fputs(".</p>\n", out);
}

enum nb_status nb_report_write(const char *folder, const struct nb_report_line *lines, size_t count,
                               struct nb_error *error) {
  struct nb_save file;
  if (nb_save_begin_in(&file, error, folder, "index.html"))
    return error->status;
  write_head(file.file, lines, count);
  write_summary(file.file, lines, count);
  for (size_t k = 0; k < count; k++)
    write_page(file.file, &lines[k], k + 1);
  fputs("</html>\n", file.file);
  return nb_save_end(&file, error);
}
