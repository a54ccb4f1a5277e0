/* What the terminal shows: verdicts, mistakes, progress.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "verdict/outcome.h"

void nb_print_verdict(const struct nb_outcome *outcome) {
  printf("%s: %s\n", outcome->page.name, outcome->page.title);
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    printf("  %s  %s\n        %s\n",
           check->passed  ? "pass"
           : check->noted ? "note"
                          : "FAIL",
           check->label, check->words);
  }
  size_t noted = 0;
  for (size_t k = 0; k < outcome->check_count; k++)
    noted += outcome->checks[k].noted && !outcome->checks[k].passed;
  if (outcome->check_count)
    printf("  %zu of %zu checks passed", outcome->check_count - outcome->failed - noted, outcome->check_count);
  if (noted)
    printf(", %zu noted", noted);
  if (outcome->check_count)
    puts("");
}

/* A `#` would begin a directive of TAP. */
static void tap_text(const char *words) {
  for (; *words; words++)
    putchar(*words == '#' ? ' ' : *words);
}

void nb_print_tap(const struct nb_outcome *outcome, const char *path) {
  if (outcome->status > NB_FAILED) {
    printf("1..1\nnot ok 1 - %s %s\n# %s\n", path, outcome->mistakes.count ? "has mistakes" : "did not run",
           outcome->mistakes.count ? "" : outcome->error.text);
    return;
  }
  printf("1..%zu\n", outcome->check_count);
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    printf("%s %zu - ", check->passed ? "ok" : "not ok", k + 1);
    tap_text(check->label);
    if (check->noted && !check->passed) /* TAP's word for what is not ok and yet fails nothing */
      fputs(" # TODO outside of the sample", stdout);
    printf("\n# line %d: ", check->line);
    tap_text(check->words);
    putchar('\n');
  }
}

/* Of all runs together, and which one was the first. */
static void warn_deep(const struct nb_outcome *outcome, const char *path) {
  unsigned long long count = 0;
  const struct nb_page_run *first = NULL;
  for (size_t r = 0; r < outcome->run_count; r++) {
    count += outcome->runs[r].result.deep;
    first = first || !outcome->runs[r].result.deep ? first : &outcome->runs[r];
  }
  if (first)
    fprintf(stderr,
            "%s: warning: overlaps above what elastic spheres are good for, in %llu contact updates; first %s%s%s "
            "[R89 6.4.3]\n",
            path, count, first->result.deep_first, first->label[0] ? ", run " : "", first->label);
}

void nb_print_trouble(const struct nb_outcome *outcome, const char *path) {
  if (outcome->mistakes.text)
    fputs(outcome->mistakes.text, stderr);
  if (outcome->error.text[0] && outcome->status > NB_FAILED)
    fprintf(stderr, "%s: %s: %s\n", path, outcome->status == NB_BROKEN ? "stopped" : "error", outcome->error.text);
  warn_deep(outcome, path);
}

static void progress(void *data, const char *stage, double share, double seconds) {
  struct nb_progress_line *line = data;
  if (seconds < 2 || seconds - line->shown < 0.5)
    return;
  line->shown = seconds;
  fprintf(stderr, "\r%s, stage %s: %3.0f %%, %.0f s left   ", line->page, stage, 100 * share,
          share > 0 ? seconds * (1 - share) / share : 0);
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
