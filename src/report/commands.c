/* The commands.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include "commands.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/guess.h"
#include "core/names.h"
#include "input/old_words.h"
#include "input/scene.h"
#include "laws/law.h"
#include "run/restart.h"

static enum nb_status worse(enum nb_status a, enum nb_status b) { return a > b ? a : b; }

static enum nb_status complain(const struct nb_error *error) {
  fprintf(stderr, "nineball: %s\n", error->text);
  return error->status;
}

/* ---- run, check, figure, report ---- */

/* What is done with the outcome of a page; a set. */
enum { VERDICT = 1, CHECKED = 2, TABLES = 4, FIGURE = 8 };

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
        fprintf(stderr,
                "nineball: %s and %s have the same name, so the same output folder: run them one at a time, with -o\n",
                use->pages[j], use->pages[k]);
        return NB_BAD_USE;
      }
    }
  return NB_OK;
}

/* Whether there is anything to keep: also of a run that did not come to its end. */
static bool is_seen(const struct nb_outcome *outcome) {
  bool seen = outcome->status <= NB_FAILED;
  for (size_t r = 0; r < outcome->run_count && outcome->status == NB_BROKEN; r++)
    seen = seen || outcome->runs[r].result.table.row_count > 0;
  return seen;
}

/* No page passes unless something is checked. */
static bool is_unchecked(const struct nb_outcome *outcome) {
  return outcome->status == NB_OK && !outcome->marked[NB_PASS];
}

/* Tables and figure, into the folder, and where they are. */
static enum nb_status keep(const struct nb_outcome *outcome, const struct nb_use *use, const char *path,
                           unsigned wanted) {
  struct nb_error error;
  char name[NB_NAME_SIZE + 8];
  bool drawn = false;
  snprintf(name, sizeof name, "%s.out", outcome->page.name);
  const char *folder = use->folder ? use->folder : name;
  const char *incomplete = outcome->status > NB_FAILED ? ", up to where the run was stopped" : "";
  if (wanted & TABLES) {
    if (nb_tables_save(outcome, folder, &error))
      return complain(&error);
    printf("tables are in %s%s\n", folder, incomplete);
    if (nb_figure_wanted(&outcome->page))
      printf("to draw the figure: nineball figure %s\n", path);
  }
  if (wanted & FIGURE) {
    if (nb_figure_draw(outcome, folder, use->trust, &drawn, &error))
      return complain(&error);
    if (drawn)
      printf("look at %s/%s.svg%s\n", folder, outcome->page.name, incomplete);
    else
      printf("%s has no `gnuplot` block, so there is no figure\n", path);
  }
  return NB_OK;
}

static enum nb_status one_page(const struct nb_use *use, const char *path, unsigned wanted) {
  struct nb_outcome outcome;
  carry_out(&outcome, use, path);
  if (wanted & VERDICT && !use->tap && outcome.status <= NB_FAILED)
    nb_print_verdict(&outcome);
  if (wanted & CHECKED && is_unchecked(&outcome))
    outcome.status =
        nb_error_set(&outcome.error, NB_BAD_USE, "%s, so nothing was checked; %s, or use `nineball run`",
                     outcome.check_count ? "no expectation of this page could fail" : "nothing is expected",
                     outcome.check_count ? "see the notes and reasons above" : "add a block `expect`");
  nb_print_trouble(&outcome, path);
  if (wanted & VERDICT && use->tap)
    nb_print_tap(&outcome, path);
  enum nb_status status = wanted & VERDICT || outcome.status > NB_FAILED ? outcome.status : NB_OK;
  if (wanted & (TABLES | FIGURE) && is_seen(&outcome))
    status = worse(status, keep(&outcome, use, path, wanted));
  nb_outcome_free(&outcome);
  return status;
}

static enum nb_status all_pages(const struct nb_use *use, unsigned wanted) {
  enum nb_status worst = wanted & (TABLES | FIGURE) ? check_folders(use) : NB_OK;
  if (wanted & (TABLES | FIGURE) && use->folder && use->page_count > 1) {
    fputs("nineball: -o FOLDER takes one page at a time; `nineball report` takes many\n", stderr);
    return NB_BAD_USE;
  }
  if (worst)
    return worst;
  for (size_t k = 0; k < use->page_count; k++)
    worst = worse(worst, one_page(use, use->pages[k], wanted));
  return worst;
}

enum nb_status nb_command_run(const struct nb_use *use) { return all_pages(use, VERDICT | TABLES); }
enum nb_status nb_command_check(const struct nb_use *use) { return all_pages(use, VERDICT | CHECKED); }
enum nb_status nb_command_figure(const struct nb_use *use) { return all_pages(use, FIGURE); }

/* Tables and figure of one page, and its line of the report, which keeps all of the outcome but the runs. */
static enum nb_status report_one(const struct nb_use *use, const char *path, const char *folder,
                                 struct nb_report_line *line) {
  struct nb_outcome *outcome = &line->outcome;
  struct nb_error error = {NB_OK, ""};
  char part[4096];
  const char *name;
  const size_t length = nb_page_name(path, &name);
  snprintf(line->name, sizeof line->name, "%.*s", (int)length, name); /* a page that cannot be read has one too */
  carry_out(outcome, use, path);
  nb_print_trouble(outcome, path);
  if (outcome->status > NB_FAILED)
    snprintf(line->message, sizeof line->message, "%s",
             outcome->mistakes.text ? outcome->mistakes.text : outcome->error.text);
  if (is_seen(outcome)) {
    snprintf(part, sizeof part, "%.3900s/%s", folder, outcome->page.name);
    line->kept = !nb_tables_save(outcome, part, &error);
    if (line->kept)
      nb_figure_draw(outcome, part, use->trust, &line->drawn, &error);
    if (error.status) {
      const size_t given = strlen(line->message);
      complain(&error);
      snprintf(line->message + given, sizeof line->message - given, "%s%s", given ? "; " : "", error.text);
    }
  }
  for (size_t r = 0; r < outcome->run_count; r++)
    line->seconds += outcome->runs[r].result.seconds;
  printf("%-28s %4zu checks, %zu failed%s%s\n", line->name, outcome->marked[NB_PASS] + outcome->marked[NB_FAIL],
         outcome->marked[NB_FAIL],
         outcome->status > NB_FAILED ? "; did not run to its end"
         : is_unchecked(outcome)     ? "; nothing was checked"
                                     : "",
         error.status ? line->kept ? "; no figure" : "; no tables" : "");
  fflush(stdout);
  nb_outcome_free_runs(outcome);
  return worse(is_unchecked(outcome) ? NB_BAD_USE : outcome->status, error.status);
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
  if (nb_folder_create(folder, &error) || nb_report_write(folder, lines, use->page_count, &error))
    worst = worse(worst, complain(&error));
  else
    printf("look at %s/index.html\n", folder);
  for (size_t k = 0; k < use->page_count; k++)
    nb_outcome_free(&lines[k].outcome);
  free(lines);
  return worst;
}

/* ---- explain ---- */

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

/* ---- state ---- */

/* Index of the stage whose end is wanted, by default the last one; -1 with a message. */
static int stage_of(const struct nb_use *use, const struct nb_outcome *outcome) {
  const struct nb_scene *scene = &outcome->runs[0].scene;
  char hint[NB_HINT_SIZE];
  if (scene->contact_test || outcome->run_count > 1) {
    fprintf(stderr, "nineball: %s %s\n", use->pages[0],
            scene->contact_test ? "is a contact test: expected a page with a scene"
                                : "has several runs: choose one, with --set NAME=VALUE for each sweep");
    return -1;
  }
  if (!use->stage)
    return (int)scene->stage_count - 1;
  struct nb_guess guess = nb_guess_begin(use->stage);
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    if (strcmp(scene->stages[s].name, use->stage) == 0)
      return (int)s;
    nb_guess_offer(&guess, scene->stages[s].name);
  }
  const char *near = nb_guess_hint(&guess, hint);
  fprintf(stderr, "nineball: %s has no stage `%s` of its own%s%s\n", use->pages[0], use->stage, near ? "; " : "",
          near ? near : "");
  return -1;
}

/* The state at the end of a stage in a file of its own, which says what the page was given. */
static enum nb_status write_state(struct nb_scene *scene, size_t stage, const char *path, const struct nb_use *use,
                                  struct nb_error *error) {
  struct nb_saved saved = {0};
  struct nb_progress_line line = {.page = use->pages[0]};
  const struct nb_progress progress = nb_print_progress(&line);
  nb_scene_cut(scene, stage);
  enum nb_status status = nb_run_to(&saved, scene, &use->options, &progress, error);
  nb_print_progress_end(&line);
  for (size_t k = 0; use->settings[k] && !status; k++)
    status = nb_saved_setting(&saved, use->settings[k], error);
  if (!status)
    saved.hash = scene->stages[stage].hash, status = nb_saved_write(&saved, path, error);
  nb_saved_free(&saved);
  return status;
}

/* A state takes the place of nothing but a state: a page or a table of that name stays. */
static bool may_be_replaced(const char *path) {
  struct stat status;
  if (lstat(path, &status) != 0)
    return true;
  FILE *file = S_ISREG(status.st_mode) ? fopen(path, "r") : NULL;
  const bool is = file && nb_saved_is(file);
  if (file)
    fclose(file);
  if (!is)
    fprintf(stderr,
            "nineball: %s is not a state, so it is not overwritten: expected the name of a state or of a new file\n",
            path);
  return is;
}

enum nb_status nb_command_state(const struct nb_use *use) {
  struct nb_outcome outcome;
  char text[3 * NB_NAME_SIZE];
  if (use->page_count > 1) {
    fputs("nineball: `nineball state` takes one page\n", stderr);
    return NB_BAD_USE;
  }
  enum nb_status status = nb_outcome_read(&outcome, use->pages[0], use->settings);
  nb_print_trouble(&outcome, use->pages[0]);
  const int stage = status ? -1 : stage_of(use, &outcome);
  if (stage >= 0) {
    struct nb_scene *scene = &outcome.runs[0].scene;
    struct nb_error error = {NB_OK, ""};
    snprintf(text, sizeof text, "%s-%s.state", outcome.page.name, scene->stages[stage].name);
    const char *path = use->folder ? use->folder : text;
    status = may_be_replaced(path) ? write_state(scene, (size_t)stage, path, use, &error) : NB_BAD_USE;
    if (error.status)
      fprintf(stderr, "nineball: %s: %s\n", use->pages[0], error.text);
    else if (!status)
      printf("the state at the end of stage `%s` is in %s\na page beside it takes the particles with: packing %s\n",
             scene->stages[stage].name, path, strrchr(path, '/') ? strrchr(path, '/') + 1 : path);
  }
  nb_outcome_free(&outcome);
  return stage < 0 && !status ? NB_BAD_USE : status;
}

/* ---- migrate ---- */

/* A page in the words of today, into its own file or to standard output. */
static enum nb_status migrate(const char *path, bool in_place, struct nb_error *error) {
  struct nb_text text = {0};
  struct nb_save save;
  size_t size;
  char *page = nb_file_read(path, NB_PAGE_MAX, &size, error);
  if (!page)
    return error->status;
  if (strlen(page) < size) {
    free(page);
    return nb_error_set(error, NB_BAD_USE, "expected a page, found a file that is no text");
  }
  nb_migrate(&text, page);
  enum nb_status status = text.failed ? nb_error_memory(error) : NB_OK;
  if (!status && !in_place) {
    fputs(text.at ? text.at : "", stdout);
  } else if (!status && text.at && strcmp(text.at, page) != 0) {
    status = nb_save_replace_begin(&save, path, error);
    if (!status)
      fputs(text.at, save.file), status = nb_save_end(&save, error);
  }
  free(text.at), free(page);
  return status;
}

enum nb_status nb_command_migrate(const struct nb_use *use) {
  enum nb_status worst = NB_OK;
  if (use->page_count > 1 && !use->in_place) {
    fputs("nineball: several pages are rewritten with --in-place\n", stderr);
    return NB_BAD_USE;
  }
  for (size_t k = 0; k < use->page_count; k++) {
    struct nb_error error;
    const enum nb_status status = migrate(use->pages[k], use->in_place, &error);
    if (status)
      fprintf(stderr, "%s: error: %s\n", use->pages[k], error.text);
    worst = worse(worst, status);
  }
  return worst;
}

/* ---- laws, list ---- */

enum nb_status nb_command_laws(const struct nb_use *use) {
  (void)use;
  for (const struct nb_law *const *law = nb_laws(); *law; law++)
    printf("%-7s %-21s %s  %s\n%29s parameters of the materials: %s\n%29s %d history variables%s; %s%s\n", (*law)->kind,
           (*law)->name, (*law)->title, (*law)->source, "", (*law)->parameters[0] ? (*law)->parameters : "none", "",
           (*law)->history + (*law)->piece * (*law)->pieces,
           (*law)->piece > 0 ? " or as many as `memory` asks for" : "",
           (*law)->stored ? "reports its stored energy" : "does not report stored energy",
           (*law)->non_conservative ? "; may create energy" : "");
  return NB_OK;
}

enum nb_status nb_command_list(const struct nb_use *use) {
  (void)use;
  puts("references, for `reference NAME` in a page:");
  for (const struct nb_reference *const *reference = nb_references(); *reference; reference++)
    printf("  %-24s %s  %s\n", (*reference)->name, (*reference)->title, (*reference)->source);
  return NB_OK;
}
