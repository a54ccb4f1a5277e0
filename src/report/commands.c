/* The commands.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "commands.h"

#include <stdlib.h>
#include <string.h>

#include "core/guess.h"
#include "laws/law.h"
#include "run/save.h"
#include "tables.h"

static enum nb_status worse(enum nb_status a, enum nb_status b) { return a > b ? a : b; }

static const char *folder_of(const struct nb_use *use, const struct nb_outcome *outcome, char *text, size_t size) {
  if (use->folder)
    return use->folder;
  snprintf(text, size, "%s.out", outcome->page.name);
  return text;
}

static void carry_out(struct nb_outcome *outcome, const struct nb_use *use, const char *path) {
  struct nb_progress_line line = {.page = path};
  const struct nb_progress progress = nb_print_progress(&line);
  nb_outcome_make(outcome, path, use->settings, &use->options, &progress);
  nb_print_progress_end(&line);
}

/* What two pages write must not lie in one folder, where one would write over the other. */
static enum nb_status check_folders(const struct nb_use *use) {
  for (size_t k = 0; k < use->page_count; k++)
    for (size_t j = 0; j < k; j++) {
      const char *one, *other;
      const size_t length = nb_page_name(use->pages[k], &one);
      if (length == nb_page_name(use->pages[j], &other) && memcmp(one, other, length) == 0) {
        fprintf(stderr, "nineball: %s and %s have one name, so one folder: give them one after the other, with -o\n",
                use->pages[j], use->pages[k]);
        return NB_BAD_USE;
      }
    }
  return NB_OK;
}

static enum nb_status check_folder(const struct nb_use *use) {
  if (!use->folder || use->page_count == 1)
    return check_folders(use);
  fputs("nineball: -o FOLDER takes one page at a time; `nineball report` takes many\n", stderr);
  return NB_BAD_USE;
}

/* Whether there is anything to keep: also of a run that did not come to its end. */
static bool is_seen(const struct nb_outcome *outcome) {
  bool seen = outcome->status <= NB_FAILED;
  for (size_t r = 0; r < outcome->run_count && outcome->status == NB_BROKEN; r++)
    seen = seen || outcome->runs[r].result.table.row_count > 0;
  return seen;
}

static const char *incomplete(const struct nb_outcome *outcome) {
  return outcome->status > NB_FAILED ? ", up to where the run was stopped" : "";
}

static enum nb_status complain(const struct nb_error *error) {
  fprintf(stderr, "nineball: %s\n", error->text);
  return error->status;
}

static void next_step(const char *words, const char *folder, const char *file, const char *more) {
  printf("%s %s%s%s%s\n", words, folder, file[0] ? "/" : "", file, more);
}

enum nb_status nb_command_run(const struct nb_use *use) {
  enum nb_status worst = check_folder(use);
  for (size_t k = 0; k < use->page_count && worst < NB_BAD_USE; k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[NB_NAME_SIZE + 8];
    carry_out(&outcome, use, use->pages[k]);
    worst = worse(worst, outcome.status);
    nb_print_trouble(&outcome, use->pages[k]);
    if (outcome.status <= NB_FAILED)
      nb_print_verdict(&outcome);
    if (is_seen(&outcome)) {
      const char *folder = folder_of(use, &outcome, text, sizeof text);
      if (nb_tables_save(&outcome, folder, &error)) {
        worst = worse(worst, complain(&error));
      } else {
        next_step("tables are in", folder, "", incomplete(&outcome));
        if (nb_figure_wanted(&outcome.page))
          printf("to draw the figure: nineball figure %s\n", use->pages[k]);
      }
    }
    nb_outcome_free(&outcome);
  }
  return worst;
}

/* No page passes unless something is checked. */
static bool is_unchecked(const struct nb_outcome *outcome) {
  return outcome->status == NB_OK && !outcome->marked[NB_PASS];
}

enum nb_status nb_command_check(const struct nb_use *use) {
  enum nb_status worst = NB_OK;
  for (size_t k = 0; k < use->page_count; k++) {
    struct nb_outcome outcome;
    carry_out(&outcome, use, use->pages[k]);
    if (!use->tap && outcome.status <= NB_FAILED)
      nb_print_verdict(&outcome);
    if (is_unchecked(&outcome))
      outcome.status = nb_error_set(
          &outcome.error, NB_BAD_USE, "%s: no page passes unless something is checked; %s or use `nineball run`",
          outcome.check_count ? "none of its expectations was checked" : "nothing is expected",
          outcome.check_count ? "see the reasons," : "add a block of kind `expect`,");
    nb_print_trouble(&outcome, use->pages[k]);
    if (use->tap)
      nb_print_tap(&outcome, use->pages[k]);
    worst = worse(worst, outcome.status);
    nb_outcome_free(&outcome);
  }
  return worst;
}

enum nb_status nb_command_figure(const struct nb_use *use) {
  enum nb_status worst = check_folder(use);
  for (size_t k = 0; k < use->page_count && worst < NB_BAD_USE; k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[NB_NAME_SIZE + 8], name[NB_NAME_SIZE + 8];
    bool drawn = false;
    carry_out(&outcome, use, use->pages[k]);
    worst = worse(worst, outcome.status > NB_FAILED ? outcome.status : NB_OK);
    nb_print_trouble(&outcome, use->pages[k]);
    if (is_seen(&outcome)) {
      const char *folder = folder_of(use, &outcome, text, sizeof text);
      snprintf(name, sizeof name, "%s.svg", outcome.page.name);
      if (nb_figure_draw(&outcome, folder, use->trust, &drawn, &error))
        worst = worse(worst, complain(&error));
      else if (drawn)
        next_step("look at", folder, name, incomplete(&outcome));
      else
        printf("%s has no block of kind `gnuplot`\n", use->pages[k]);
    }
    nb_outcome_free(&outcome);
  }
  return worst;
}

/* Tables and figure of one page, and its line of the report, which takes over the verdicts. */
static enum nb_status report_one(const struct nb_use *use, const char *path, const char *folder,
                                 struct nb_report_line *line) {
  struct nb_outcome outcome;
  struct nb_error error = {NB_OK, ""};
  char part[4096];
  const char *name;
  const size_t length = nb_page_name(path, &name);
  carry_out(&outcome, use, path);
  nb_print_trouble(&outcome, path);
  snprintf(line->name, sizeof line->name, "%.*s", (int)length, name); /* a page that cannot be read has one too */
  memcpy(line->title, outcome.page.title, sizeof line->title);
  line->status = outcome.status;
  if (outcome.status > NB_FAILED)
    snprintf(line->message, sizeof line->message, "%s",
             outcome.mistakes.text ? outcome.mistakes.text : outcome.error.text);
  if (is_seen(&outcome)) {
    snprintf(part, sizeof part, "%.3900s/%s", folder, outcome.page.name);
    line->kept = !nb_tables_save(&outcome, part, &error);
    if (line->kept)
      nb_figure_draw(&outcome, part, use->trust, &line->drawn, &error);
    if (error.status) {
      const size_t said = strlen(line->message);
      complain(&error);
      snprintf(line->message + said, sizeof line->message - said, "%s%s", said ? "; " : "", error.text);
    }
    for (size_t r = 0; r < outcome.run_count; r++)
      line->seconds += outcome.runs[r].result.seconds;
  }
  line->warnings = outcome.warnings;
  if (is_unchecked(&outcome)) /* its figure is drawn nevertheless */
    line->status = NB_BAD_USE;
  line->checks = outcome.check_count, line->stopped = outcome.status > NB_FAILED;
  memcpy(line->marked, outcome.marked, sizeof line->marked);
  line->verdicts = outcome.checks, outcome.checks = NULL;
  printf("%-28s %4zu checks, %zu failed%s%s\n", line->name, line->marked[NB_PASS] + line->marked[NB_FAIL],
         line->marked[NB_FAIL],
         line->stopped            ? "; did not run to its end"
         : is_unchecked(&outcome) ? "; nothing was checked"
                                  : "",
         error.status ? line->kept ? "; no figure" : "; no tables" : "");
  fflush(stdout);
  nb_outcome_free(&outcome);
  return worse(line->status, error.status);
}

enum nb_status nb_command_report(const struct nb_use *use) {
  const char *folder = use->folder ? use->folder : "report";
  enum nb_status worst = check_folders(use);
  struct nb_error error;
  if (worst)
    return worst;
  struct nb_report_line *lines = calloc(use->page_count, sizeof *lines);
  if (!lines)
    return nb_error_memory(&error), complain(&error);
  for (size_t k = 0; k < use->page_count; k++)
    worst = worse(worst, report_one(use, use->pages[k], folder, &lines[k]));
  if (nb_save_folder(folder, &error) || nb_report_write(folder, lines, use->page_count, &error))
    worst = worse(worst, complain(&error));
  else
    next_step("look at", folder, "index.html", "");
  for (size_t k = 0; k < use->page_count; k++)
    free(lines[k].verdicts);
  free(lines);
  return worst;
}

enum nb_status nb_command_explain(const struct nb_use *use) {
  enum nb_status worst = NB_OK;
  for (size_t k = 0; k < use->page_count; k++) {
    struct nb_outcome outcome;
    nb_outcome_read(&outcome, use->pages[k], use->settings);
    nb_print_trouble(&outcome, use->pages[k]);
    worst = worse(worst, outcome.status);
    for (size_t r = 0; r < outcome.run_count && !outcome.status; r++) {
      struct nb_error error;
      const struct nb_page_run *run = &outcome.runs[r];
      printf("%s%s%s%s\n", r ? "\n" : "", outcome.page.name, run->label[0] ? ", run " : "", run->label);
      if (nb_explain(stdout, &run->scene, &use->options, &outcome.warnings, &error)) {
        fprintf(stderr, "%s: error: %s\n", use->pages[k], error.text);
        worst = worse(worst, error.status);
      }
    }
    nb_repeat_warnings("", use->pages[k], &outcome.warnings);
    nb_outcome_free(&outcome);
  }
  return worst;
}

enum nb_status nb_command_laws(const struct nb_use *use) {
  (void)use;
  for (const struct nb_law *const *law = nb_laws(); *law; law++)
    printf("%-7s %-21s %s  %s\n%29s remembers %d%s, %s%s\n", (*law)->kind, (*law)->name, (*law)->title, (*law)->source,
           "", (*law)->memory + (*law)->piece * (*law)->pieces, (*law)->piece > 0 ? " or as many as wanted" : "",
           (*law)->stored ? "knows its stored energy" : "has no stored energy",
           (*law)->gains ? ", may create energy" : "");
  return NB_OK;
}

enum nb_status nb_command_list(const struct nb_use *use) {
  (void)use;
  puts("references, for `reference NAME` in a page:");
  for (const struct nb_reference *const *reference = nb_references(); *reference; reference++)
    printf("  %-24s %s  %s\n", (*reference)->name, (*reference)->title, (*reference)->source);
  puts("\nquantities, for `record`: WATCH.NAME for what is watched, the name alone for the scene");
  const char *name, *unit, *of, *help;
  for (size_t row = 0; nb_quantity_row(row, &name, &unit, &of, &help); row++)
    printf("  %-16s %-6s of %-10s %s\n", name, unit, of, help);
  return NB_OK;
}
