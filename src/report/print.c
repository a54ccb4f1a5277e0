/* Verdicts, errors and progress on the terminal.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "commands.h"

/* Prints the expectations that were not checked, with line and reason. */
static void print_skipped(const struct nb_outcome *outcome) {
  const size_t skipped = outcome->mark_count[NB_SKIP];
  if (skipped)
    printf("  %zu expectation%s not checked:\n", skipped, skipped == 1 ? " was" : "s were");
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    if (check->mark == NB_SKIP)
      printf("        line %d: %s\n        %s\n", check->line, check->label, check->message);
  }
}

void nb_print_warnings(FILE *out, const char *before, const char *path, const struct nb_warnings *warnings) {
  for (size_t k = 0; k < warnings->count; k++) {
    const struct nb_warning *warning = &warnings->list[k];
    char line[16] = "";
    if (warning->line)
      snprintf(line, sizeof line, ":%d", warning->line);
    fprintf(out, "%s%s%s: warning: %s\n", before, path, line, warning->text);
  }
}

/* True if standard output and standard error are the same terminal, file or pipe. */
static bool is_one_stream(void) {
  struct stat out, err;
  return fstat(STDOUT_FILENO, &out) == 0 && fstat(STDERR_FILENO, &err) == 0 && out.st_dev == err.st_dev &&
         out.st_ino == err.st_ino;
}

void nb_repeat_warnings(const char *before, const char *path, const struct nb_warnings *warnings) {
  if (!is_one_stream())
    nb_print_warnings(stdout, before, path, warnings);
}

void nb_print_verdict(const struct nb_outcome *outcome) {
  const size_t *mark_count = outcome->mark_count;
  printf("%s: %s\n", outcome->page.name, outcome->page.title);
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    if (check->mark == NB_SKIP)
      continue;
    printf("  %s  %s\n        ", nb_mark_word(check->mark), check->label);
    if (check->mark == NB_FAIL)
      printf("%s:%d: ", outcome->page.path, check->line);
    puts(check->message);
  }
  if (mark_count[NB_PASS] + mark_count[NB_FAIL])
    printf("  %zu of %zu checks passed", mark_count[NB_PASS], mark_count[NB_PASS] + mark_count[NB_FAIL]);
  if (mark_count[NB_NOTE])
    printf("%s%zu noted", mark_count[NB_PASS] + mark_count[NB_FAIL] ? ", " : "  ", mark_count[NB_NOTE]);
  if (mark_count[NB_PASS] + mark_count[NB_FAIL] + mark_count[NB_NOTE])
    puts("");
  print_skipped(outcome);
  nb_repeat_warnings("  ", outcome->page.path, &outcome->warnings);
}

void nb_print_escaped(FILE *out, const char *text, const struct nb_escape *list) {
  for (; *text; text++) {
    const struct nb_escape *row = list;
    while (row->character && row->character != *text)
      row++;
    fputs(row->character ? row->by : (char[]){*text, 0}, out);
  }
}

void nb_print_tap(const struct nb_outcome *outcome, const char *path) {
  const size_t count = outcome->check_count;
  const bool stopped = outcome->status > NB_FAILED;
  printf("1..%zu\n", count + stopped);
  for (size_t k = 0; k < count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    /* A `#` would begin a directive of TAP. A label has none, because a `#` begins a comment in a page. */
    printf("%s %zu - %s", check->mark == NB_FAIL ? "not ok" : "ok", k + 1, check->label);
    if (check->mark == NB_NOTE)
      fputs(" # SKIP noted, not checked", stdout);
    if (check->mark == NB_SKIP)
      printf(" # SKIP %s", check->message);
    printf("\n# line %d: %s\n", check->line, check->message);
  }
  if (stopped) {
    printf("not ok %zu - %s %s\n# ", count + 1, path,
           outcome->mistakes.count ? "has mistakes"
           : count                 ? "was not checked"
                                   : "did not run");
    if (outcome->error.line)
      printf("line %d: ", outcome->error.line);
    puts(outcome->mistakes.count ? "" : outcome->error.text);
  }
  nb_repeat_warnings("# ", path, &outcome->warnings);
}

enum nb_status nb_print_plain_error(const struct nb_error *error) {
  fprintf(stderr, "nineball: %s\n", error->text);
  return error->status;
}

void nb_print_error(const struct nb_error *error, const struct nb_page *page, const char *path) {
  fputs(path, stderr);
  if (error->line > 0 && (size_t)error->line <= page->line_count) /* the column is that of the statement's first word */
    fprintf(stderr, ":%d:%zu", error->line, strspn(page->lines[error->line - 1], " \t") + 1);
  fprintf(stderr, ": %s: %s\n", error->status == NB_BROKEN ? "run aborted" : "error", error->text);
}

void nb_print_errors(const struct nb_outcome *outcome, const char *path) {
  if (outcome->mistakes.text)
    fputs(outcome->mistakes.text, stderr);
  if (outcome->error.text[0])
    nb_print_error(&outcome->error, &outcome->page, path);
  nb_print_warnings(stderr, "", path, &outcome->warnings);
}

static void progress(void *data, const char *stage, double fraction, double seconds) {
  struct nb_progress_line *line = data;
  if (seconds < 2 || seconds - line->shown < 0.5)
    return;
  if (line->shown == 0 && line->warnings)
    nb_print_warnings(stderr, "", line->page, line->warnings);
  line->shown = seconds;
  fprintf(stderr, "\r%s, stage %s: %3.0f %%, %.0f s left   ", line->page, stage, 100 * fraction,
          fraction > 0 ? seconds * (1 - fraction) / fraction : 0);
}

static void note(void *data, const char *text) {
  const struct nb_progress_line *line = data;
  fprintf(stderr, "%s%s: note: %s\n", line->shown > 0 ? "\r\033[K" : "", line->page, text);
}

struct nb_progress nb_print_progress(struct nb_progress_line *line) {
  return (struct nb_progress){isatty(STDERR_FILENO) ? progress : NULL, note, line};
}

void nb_print_progress_end(struct nb_progress_line *line) {
  if (line->shown > 0)
    fputs("\r\033[K", stderr);
}
