/* The commands.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "commands.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "laws/law.h"
#include "page/guess.h"
#include "scene/scene.h"
#include "state/save.h"
#include "state/start.h"
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

/* Several pages into one folder would write over each other. */
static enum nb_status one_folder(const struct nb_use *use) {
  if (!use->folder || use->page_count == 1)
    return NB_OK;
  fputs("nineball: -o FOLDER takes one page at a time; `nineball report` takes many\n", stderr);
  return NB_BAD_USE;
}

static void next_step(const char *words, const char *folder, const char *file) {
  printf("%s %s%s%s\n", words, folder, file[0] ? "/" : "", file);
}

enum nb_status nb_command_run(const struct nb_use *use) {
  enum nb_status worst = one_folder(use);
  for (size_t k = 0; k < use->page_count && worst < NB_BAD_USE; k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[NB_NAME_SIZE + 8];
    carry_out(&outcome, use, use->pages[k]);
    worst = worse(worst, outcome.status);
    nb_print_trouble(&outcome, use->pages[k]);
    if (outcome.status <= NB_FAILED) {
      const char *folder = folder_of(use, &outcome, text, sizeof text);
      nb_print_verdict(&outcome);
      if (nb_tables_save(&outcome, folder, &error)) {
        fprintf(stderr, "nineball: %s\n", error.text);
        worst = worse(worst, error.status);
      } else {
        next_step("tables are in", folder, "");
        printf("to draw the figure: nineball figure %s\n", use->pages[k]);
      }
    }
    nb_outcome_free(&outcome);
  }
  return worst;
}

enum nb_status nb_command_check(const struct nb_use *use) {
  enum nb_status worst = NB_OK;
  for (size_t k = 0; k < use->page_count; k++) {
    struct nb_outcome outcome;
    carry_out(&outcome, use, use->pages[k]);
    if (!use->tap && outcome.status <= NB_FAILED)
      nb_print_verdict(&outcome);
    if (outcome.status == NB_OK && !outcome.marked[NB_PASS])
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
  enum nb_status worst = one_folder(use);
  for (size_t k = 0; k < use->page_count && worst < NB_BAD_USE; k++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char text[NB_NAME_SIZE + 8], name[NB_NAME_SIZE + 8];
    bool drawn = false;
    carry_out(&outcome, use, use->pages[k]);
    worst = worse(worst, outcome.status > NB_FAILED ? outcome.status : NB_OK);
    nb_print_trouble(&outcome, use->pages[k]);
    if (outcome.status <= NB_FAILED) {
      const char *folder = folder_of(use, &outcome, text, sizeof text);
      snprintf(name, sizeof name, "%s.svg", outcome.page.name);
      if (nb_figure_draw(&outcome, folder, &drawn, &error)) {
        fprintf(stderr, "nineball: %s\n", error.text);
        worst = worse(worst, error.status);
      } else if (drawn) {
        next_step("look at", folder, name);
      } else {
        printf("%s has no block of kind `gnuplot`\n", use->pages[k]);
      }
    }
    nb_outcome_free(&outcome);
  }
  return worst;
}

/* Tables and figure of one page, and its line of the report, which takes over the verdicts. */
static void report_one(const struct nb_use *use, const char *path, const char *folder, struct nb_report_line *line) {
  struct nb_outcome outcome;
  struct nb_error error = {NB_OK, ""};
  char part[4096];
  carry_out(&outcome, use, path);
  nb_print_trouble(&outcome, path);
  memcpy(line->name, outcome.page.name, sizeof line->name);
  memcpy(line->title, outcome.page.title, sizeof line->title);
  line->status = outcome.status;
  if (outcome.status <= NB_FAILED) {
    snprintf(part, sizeof part, "%.3900s/%s", folder, outcome.page.name);
    if (nb_tables_save(&outcome, part, &error) || nb_figure_draw(&outcome, part, &line->drawn, &error)) {
      fprintf(stderr, "nineball: %s\n", error.text);
      snprintf(line->message, sizeof line->message, "%s", error.text);
    }
    for (size_t r = 0; r < outcome.run_count; r++)
      line->seconds += outcome.runs[r].result.seconds;
  } else {
    snprintf(line->message, sizeof line->message, "%s",
             outcome.mistakes.text ? outcome.mistakes.text : outcome.error.text);
  }
  line->checks = outcome.check_count, line->failed = outcome.marked[NB_FAIL];
  line->verdicts = outcome.checks, outcome.checks = NULL;
  printf("%-28s %4zu checks, %zu failed%s\n", line->name, line->checks, line->failed,
         line->status > NB_FAILED ? "; did not run" : "");
  fflush(stdout);
  nb_outcome_free(&outcome);
}

enum nb_status nb_command_report(const struct nb_use *use) {
  const char *folder = use->folder ? use->folder : "report";
  enum nb_status worst = NB_OK;
  struct nb_error error;
  struct nb_report_line *lines = calloc(use->page_count, sizeof *lines);
  if (!lines) {
    nb_error_memory(&error);
    fprintf(stderr, "nineball: %s\n", error.text);
    return error.status;
  }
  for (size_t k = 0; k < use->page_count; k++) {
    report_one(use, use->pages[k], folder, &lines[k]);
    worst = worse(worst, lines[k].status);
  }
  if (nb_save_folder(folder, &error) || nb_report_write(folder, lines, use->page_count, &error)) {
    fprintf(stderr, "nineball: %s\n", error.text);
    worst = worse(worst, error.status);
  } else {
    next_step("look at", folder, "index.html");
  }
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
      struct nb_error error = {NB_OK, ""};
      const struct nb_page_run *run = &outcome.runs[r];
      const bool there = nb_start_there(&run->scene, &use->options);
      struct nb_model *model = run->scene.path || !there ? NULL : nb_model_create(&run->scene, &use->options, &error);
      printf("%s%s%s%s\n", r ? "\n" : "", outcome.page.name, run->label[0] ? ", run " : "", run->label);
      if (run->scene.path) {
        nb_explain_bench(stdout, &run->scene);
      } else if (!there) {
        nb_explain_start(stdout, &run->scene, &use->options);
        puts("  the plan can be told when it is there");
      } else if (model) {
        nb_explain_start(stdout, &run->scene, &use->options);
        if (!nb_explain(stdout, &run->scene, model))
          nb_error_memory(&error);
      }
      if (error.status)
        fprintf(stderr, "%s: error: %s\n", use->pages[k], error.text);
      worst = worse(worst, error.status);
      nb_model_free(model);
    }
    nb_outcome_free(&outcome);
  }
  return worst;
}

/* Index of the stage whose end is wanted, by default the last one; -1 with a message. */
static int stage_of(const struct nb_use *use, const struct nb_outcome *outcome) {
  const struct nb_scene *scene = &outcome->runs[0].scene;
  char hint[NB_HINT_SIZE];
  if (scene->path || outcome->run_count > 1) {
    fprintf(stderr, "nineball: %s %s\n", use->pages[0],
            scene->path ? "has a path: expected a scene"
                        : "makes several runs: give what it sweeps one value by --set NAME=VALUE");
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
    if (!nb_saved_setting(&saved, use->settings[k]))
      status = nb_error_memory(error);
  if (!status)
    saved.hash = scene->stages[stage].hash, status = nb_saved_write(&saved, path, error);
  nb_saved_free(&saved);
  return status;
}

enum nb_status nb_command_state(const struct nb_use *use) {
  struct nb_outcome outcome;
  char text[3 * NB_NAME_SIZE];
  if (use->page_count > 1) {
    fputs("nineball: a state is one of one page\n", stderr);
    return NB_BAD_USE;
  }
  enum nb_status status = nb_outcome_read(&outcome, use->pages[0], use->settings);
  nb_print_trouble(&outcome, use->pages[0]);
  const int stage = status ? -1 : stage_of(use, &outcome);
  if (stage >= 0) {
    struct nb_scene *scene = &outcome.runs[0].scene;
    struct nb_error error;
    snprintf(text, sizeof text, "%s-%s.state", outcome.page.name, scene->stages[stage].name);
    const char *path = use->folder ? use->folder : text;
    status = write_state(scene, (size_t)stage, path, use, &error);
    if (status)
      fprintf(stderr, "nineball: %s: %s\n", use->pages[0], error.text);
    else
      printf("the state at the end of stage `%s` is in %s\na page beside it takes the bodies: packing %s\n",
             scene->stages[stage].name, path, strrchr(path, '/') ? strrchr(path, '/') + 1 : path);
  }
  nb_outcome_free(&outcome);
  return stage < 0 ? NB_BAD_USE : status;
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
