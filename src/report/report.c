/* The report: one static page about all pages, with their verdicts and figures. It needs no server and no script.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "run/save.h"
#include "tables.h"

enum { MANY = 20 }; /* so many checks are folded away, unless one failed */

static void text(FILE *out, const char *words) {
  for (; *words; words++)
    switch (*words) {
    case '<':
      fputs("&lt;", out);
      break;
    case '>':
      fputs("&gt;", out);
      break;
    case '&':
      fputs("&amp;", out);
      break;
    case '"':
      fputs("&quot;", out);
      break;
    case '\'':
      fputs("&#39;", out);
      break;
    default:
      fputc(*words, out);
    }
}

/* NAME/FILE as an address: all but letters, digits, `-`, `_` and `.` as %XX (RFC 3986). */
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
    fprintf(out, "<tr><td><a href=\"#page%zu\">", k + 1);
    text(out, line->name);
    fputs("</a></td><td>", out);
    text(out, line->title);
    if (line->stopped) {
      fputs("</td><td colspan=\"5\" class=\"fail\">did not run to its end</td></tr>\n", out);
      continue;
    }
    const size_t failed = line->marked[NB_FAIL], checks = line->marked[NB_PASS] + failed;
    fprintf(out, "</td><td>%zu</td><td class=\"%s\">%zu%s%s</td>", checks,
            failed || !checks || line->message[0] ? "fail" : "pass", failed, checks ? "" : ", nothing was checked",
            !line->message[0] ? ""
            : line->kept      ? ", no figure"
                              : ", no tables");
    fprintf(out, "<td>%zu</td><td>%zu</td><td>%.2f</td></tr>\n", line->marked[NB_NOTE], line->marked[NB_SKIP],
            line->seconds);
  }
  fputs("</table>\n", out);
}

static void write_page(FILE *out, const struct nb_report_line *line, size_t number) {
  const size_t failed = line->marked[NB_FAIL];
  fprintf(out, "<h2 id=\"page%zu\">", number);
  text(out, line->title[0] ? line->title : line->name);
  fputs("</h2>\n", out);
  if (line->message[0]) {
    fputs("<p class=\"fail\">", out);
    text(out, line->message);
    fputs("</p>\n", out);
  }
  for (size_t k = 0; k < line->warnings.count; k++) {
    const struct nb_warning *warning = &line->warnings.list[k];
    fputs("<p>Warning: ", out);
    if (warning->line)
      fprintf(out, "line %d: ", warning->line);
    text(out, warning->text);
    fputs("</p>\n", out);
  }
  if (line->drawn) {
    fputs("<p><img ", out);
    address(out, "src", line->name, line->name, ".svg");
    fputs(" alt=\"figure of ", out);
    text(out, line->name);
    fputs("\"></p>\n", out);
  }
  if (line->checks)
    fprintf(out,
            "<details%s><summary>%zu checks, %zu "
            "failed, %zu noted, %zu skipped</summary>\n<table><tr><th></th><th>expected</th><th>seen</th></tr>\n",
            line->checks < MANY || failed ? " open" : "", line->marked[NB_PASS] + failed, failed, line->marked[NB_NOTE],
            line->marked[NB_SKIP]);
  for (size_t k = 0; k < line->checks; k++) {
    const struct nb_check *check = &line->verdicts[k];
    fprintf(out, "<tr><td class=\"%s\">%s</td><td>",
            check->mark == NB_FAIL   ? "fail"
            : check->mark == NB_PASS ? "pass"
                                     : "none",
            nb_mark_word(check->mark));
    text(out, check->label);
    fputs("</td><td>", out);
    text(out, check->words);
    fputs("</td></tr>\n", out);
  }
  if (line->checks)
    fputs("</table></details>\n", out);
  if (!line->kept)
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

enum nb_status nb_report_write(const char *folder, const struct nb_report_line *lines, size_t count,
                               struct nb_error *error) {
  char path[4096];
  struct nb_save file;
  if ((size_t)snprintf(path, sizeof path, "%s/index.html", folder) >= sizeof path)
    return nb_error_set(error, NB_BAD_USE, "the name of the folder is too long: %.200s…", folder);
  if (nb_save_begin(&file, path, error))
    return error->status;
  size_t checks = 0, failed = 0, broken = 0, bare = 0, unchecked = 0;
  for (size_t k = 0; k < count; k++) {
    const size_t *marked = lines[k].marked, judged = marked[NB_PASS] + marked[NB_FAIL];
    checks += judged, failed += marked[NB_FAIL], broken += lines[k].stopped;
    bare += !lines[k].stopped && lines[k].message[0];
    unchecked += !lines[k].stopped && judged == 0;
  }
  FILE *out = file.file;
  fprintf(out,
          "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta http-equiv=\"Content-Security-Policy\" "
          "content=\"default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'\"><title>nineball "
          "report</title><style>%s</style>\n",
          style);
  fprintf(out, "<h1>nineball %s</h1>\n<p>%zu pages, %zu checks, <span class=\"%s\">%zu failed</span>", NB_VERSION,
          count, checks, failed ? "fail" : "pass", failed);
  if (broken)
    fprintf(out, ", <span class=\"fail\">%zu did not run to their end</span>", broken);
  if (unchecked)
    fprintf(out, ", <span class=\"fail\">%zu on which nothing was checked</span>", unchecked);
  if (bare)
    fprintf(out, ", <span class=\"fail\">%zu without figure or tables</span>", bare);
  fputs(".</p>\n", out);
  write_summary(out, lines, count);
  for (size_t k = 0; k < count; k++)
    write_page(out, &lines[k], k + 1);
  fputs("</html>\n", out);
  return nb_save_end(&file, error);
}
