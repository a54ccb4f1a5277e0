/* The pieces of HTML that the pages of the report share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "report.h"

enum { FOLD_LIMIT = 20 }; /* a list of more checks is folded, unless one of them failed */

void nb_html_text(FILE *out, const char *before, const char *text, const char *after) {
  static const struct nb_escape list[] = {{'<', "&lt;"},   {'>', "&gt;"},   {'&', "&amp;"},
                                          {'"', "&quot;"}, {'\'', "&#39;"}, {0, NULL}};
  fputs(before, out);
  nb_print_escaped(out, text, list);
  fputs(after, out);
}

void nb_html_address(char *address, size_t size, const char *name) {
  for (const char *c = name; *c; c++)
    nb_append(address, size, isalnum((unsigned char)*c) || strchr("-_.", *c) ? "%c" : "%%%02X", (unsigned char)*c);
}

/* The page may load scripts and figures only from the report. The policy has both 'self' and `file:`, because browsers
 * differ in the meaning of 'self' for a file. */
void nb_html_begin(FILE *out, const char *title, const char *top, const char *script) {
  fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file:; "
        "style-src 'self' file: 'unsafe-inline'; script-src 'self' file:\">\n",
        out);
  nb_html_text(out, "<title>", title, "</title>\n");
  fprintf(out, "<link rel=\"stylesheet\" href=\"%sreport.css\">\n", top);
  if (script)
    fprintf(out, "<script defer src=\"%s%s\"></script>\n", top, script);
  fputs("</head><body>\n", out);
}

const char *nb_html_verdict(char *text, size_t size, const struct nb_report_page *page) {
  const size_t *count = page->outcome.mark_count, checks = count[NB_PASS] + count[NB_FAIL];
  const char *wrong = page->outcome.status > NB_FAILED ? "did not run to its end"
                      : !checks                        ? "nothing was checked"
                      : !page->message[0]              ? NULL
                      : page->saved                    ? "no figure"
                                                       : "no tables";
  if (page->document || page->unrun)
    return snprintf(text, size, "%s", page->document ? "" : "not run"), "none";
  if (count[NB_FAIL])
    snprintf(text, size, "%zu of %zu checks failed", count[NB_FAIL], checks);
  else if (wrong)
    snprintf(text, size, "%s", wrong);
  else
    snprintf(text, size, checks == 1 ? "%zu check passed" : "%zu checks passed", checks);
  return count[NB_FAIL] || wrong ? "fail" : "pass";
}

/* ---- checks ---- */

enum { WIDE = 140, HIGH = 50, MARGIN = 5 }; /* sizes of the picture of a trend, in units of its view box */

/* Fraction of the way from the smallest to the largest value. The scale is logarithmic if the smallest value is above 0
 * and log10(largest/smallest) is above `decades`. 0.5 if the values are equal. */
static double position(double value, double smallest, double largest, double decades) {
  if (smallest > 0 && log10(largest / smallest) > decades)
    return log(value / smallest) / log(largest / smallest);
  return largest > smallest ? (value - smallest) / (largest - smallest) : 0.5;
}

/* Writes a picture of the computed values against the swept values. The message of the check is its description. */
static void write_points(FILE *out, const struct nb_check *check) {
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
  for (size_t k = 0; k < 2 * check->point_count; k++) {
    least[k % 2] = fmin(least[k % 2], check->points[k]);
    most[k % 2] = fmax(most[k % 2], check->points[k]);
  }
  nb_html_text(out, "<svg class=\"points\" role=\"img\" aria-label=\"", check->message, "\"");
  fprintf(out, " viewBox=\"0 0 %d %d\">", WIDE, HIGH);
  for (int dots = 0; dots < 2; dots++) {
    fputs(dots ? "" : "<polyline fill=\"none\" points=\"", out);
    for (size_t k = 0; k < check->point_count; k++) {
      const double x = MARGIN + (WIDE - 2 * MARGIN) * position(check->points[2 * k], least[0], most[0], 1.5);
      const double y = HIGH - MARGIN - (HIGH - 2 * MARGIN) * position(check->points[2 * k + 1], least[1], most[1], 1.5);
      fprintf(out, dots ? "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2\"/>" : "%.1f,%.1f ", x, y);
    }
    fputs(dots ? "" : "\"/>", out);
  }
  fputs("</svg>", out);
}

static void write_check(FILE *out, const struct nb_check *check) {
  const char *word = nb_mark_word(check->mark);
  fprintf(out, "<tr><td class=\"%s\">%s", check->mark == NB_FAIL ? "fail" : word,
          word); /* `note` and `skip` have no style */
  nb_html_text(out, "</td><td>", check->label, "");
  const struct nb_part *last = &check->parts[NB_PART_TOLERANCE];
  if (last->length && check->message[last->at + last->length])
    nb_html_text(out, "<br><small>", check->message + last->at + last->length + strlen("; "), "</small>");
  fputs("</td>", out);
  const bool has_numbers = check->parts[NB_PART_COMPUTED].length && check->parts[NB_PART_ERROR].length;
  for (int k = 0; k < NB_PARTS && has_numbers; k++) {
    char part[sizeof check->message];
    snprintf(part, sizeof part, "%.*s", check->parts[k].length, check->message + check->parts[k].at);
    nb_html_text(out, "<td class=\"number\">", part, "</td>");
  }
  if (!has_numbers) {
    fprintf(out, "<td colspan=\"%d\">", NB_PARTS);
    if (check->point_count > 1)
      write_points(out, check), fputs("<br>", out);
    nb_html_text(out, "", check->message, "</td>");
  }
  fputs("</tr>\n", out);
}

void nb_html_checks(FILE *out, const struct nb_outcome *outcome) {
  const size_t *mark_count = outcome->mark_count;
  if (!outcome->check_count)
    return;
  fprintf(out,
          "<details%s><summary>Results: %zu checks, %zu failed, %zu noted, %zu "
          "skipped</summary>\n<table><thead><tr><th></th><th>expectation</th><th>computed</th><th>reference</"
          "th><th>error</th><th>tolerance</th></tr></thead><tbody>\n",
          outcome->check_count <= FOLD_LIMIT || mark_count[NB_FAIL] ? " open" : "",
          mark_count[NB_PASS] + mark_count[NB_FAIL], mark_count[NB_FAIL], mark_count[NB_NOTE], mark_count[NB_SKIP]);
  for (size_t k = 0; k < outcome->check_count; k++)
    write_check(out, &outcome->checks[k]);
  fputs("</tbody></table></details>\n", out);
}
