/* The commands of the program.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "commands.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/clean.h"
#include "core/names.h"
#include "input/old_words.h"
#include "input/scene.h"
#include "laws/law.h"
#include "run/restart.h"

/* ---- run, check, figure ---- */

#ifndef NB_RESULTS_KEPT
#define NB_RESULTS_KEPT (32 << 20) /* bytes of the results of a sweep that stay in memory; 0 in tests/faults */
#endif

/* What a command does with the outcome of a page: a set of flags. */
enum { VERDICT = 1, REQUIRE_CHECKS = 2, TABLES = 4, FIGURE = 8 };

void nb_run_page(struct nb_outcome *outcome, const struct nb_call *call, const char *path, const char *folder) {
  struct nb_progress_line line = {.page = path, .warnings = &outcome->warnings};
  const struct nb_progress progress = nb_print_progress(&line);
  const char *temporary = getenv("TMPDIR");
  struct nb_options options = call->options;
  options.results = (struct nb_results_kept){NB_RESULTS_KEPT,
                                             folder                      ? folder
                                             : temporary && temporary[0] ? temporary
                                                                         : "/tmp",
                                             !folder};
  nb_outcome_make(outcome, path, call->settings, &options, &progress);
  nb_print_progress_end(&line);
  if (nb_is_stopped(&options) && outcome->status > NB_FAILED && outcome->run_count)
    *call->repeats = outcome->runs[0].scene.contact_test;
}

/* The folder of the output files of a page: the folder that the call gives, or NAME.out. */
static const char *output_folder(char *name, size_t size, const struct nb_call *call, const char *path) {
  const char *page;
  const size_t length = nb_page_name(path, &page);
  snprintf(name, size, "%.*s.out", (int)length, page);
  return call->folder ? call->folder : name;
}

/* NB_BAD_USE if two pages of the call have the same name: they would overwrite each other's files. */
static enum nb_status check_folders(const struct nb_call *call) {
  for (size_t k = 0; k < call->page_count; k++)
    for (size_t j = 0; j < k; j++) {
      const char *one, *other;
      const size_t length = nb_page_name(call->pages[k], &one);
      if (length == nb_page_name(call->pages[j], &other) && memcmp(one, other, length) == 0) {
        fprintf(stderr,
                "nineball: %s and %s have the same name, so the same output folder: run them one at a time, with -o\n",
                call->pages[j], call->pages[k]);
        return NB_BAD_USE;
      }
    }
  return NB_OK;
}

bool nb_outcome_has_rows(const struct nb_outcome *outcome) {
  bool found = outcome->status <= NB_FAILED;
  for (size_t r = 0; r < outcome->run_count && outcome->status == NB_BROKEN; r++)
    found = found || nb_run_table(&outcome->runs[r])->row_count > 0;
  return found;
}

bool nb_outcome_is_unchecked(const struct nb_outcome *outcome) {
  return outcome->status == NB_OK && !outcome->mark_count[NB_PASS];
}

/* Warns of a table of very many rows. The warning names a `record every` for the stage with most rows, with which this
 * stage has at most half a million, so the table has at most a million if the other stages have half a million. */
static void warn_of_rows(const struct nb_outcome *outcome, const char *path) {
  const double most_rows = 1e6;
  const struct nb_scene *const scene = &outcome->runs[0].scene;
  double *const rows = calloc(scene->stage_count + 1, sizeof *rows), all = 0;
  size_t most = 0;
  for (size_t r = 0; rows && r < outcome->run_count; r++) {
    const struct nb_table *const table = nb_run_table(&outcome->runs[r]);
    for (size_t k = 0; k < table->row_count; k++)
      if (table->stage[k] >= 0 && table->stage[k] < (int)scene->stage_count)
        rows[table->stage[k]]++, all++;
  }
  for (size_t s = 0; rows && s < scene->stage_count; s++)
    most = rows[s] > rows[most] ? s : most;
  if (rows && all > most_rows) {
    const struct nb_stage *const stage = &scene->stages[most];
    double every = (double)stage->record_interval, left = rows[most];
    do
      every *= 10, left /= 10;
    while (left > most_rows / 2 - (double)outcome->run_count);
    fprintf(stderr,
            "%s:%d: warning: table.tsv has %.0f rows, most of them of stage `%s`: write `record every %.0f %s` in it\n",
            path, stage->line, all, stage->name, every, scene->contact_test ? "steps" : "cycles");
  }
  free(rows);
}

/* Writes tables and figure, and prints where they are. */
static enum nb_status save_outputs(const struct nb_outcome *outcome, const struct nb_call *call, const char *path,
                                   const char *folder, unsigned actions, double began) {
  struct nb_error error;
  char word[4096] = "";
  bool drawn = false;
  const char *incomplete = outcome->status > NB_FAILED ? ", up to where the run was stopped" : "";
  if (actions & TABLES) {
    struct nb_text names = {0};
    const enum nb_status status = nb_tables_save(outcome, folder, &names, &error);
    free(names.at);
    if (status)
      return nb_print_plain_error(&error);
    warn_of_rows(outcome, path);
    fputs("  ", stdout);
    nb_cost_print_actual(stdout, outcome, (nb_cost_clock() - began) / call->options.threads, &call->options);
    printf("tables are in %s%s\n", folder, incomplete);
    if (nb_page_has_figure(&outcome->page))
      nb_append_word(word, sizeof word, path), printf("to draw the figure: nineball figure %s\n", word);
  }
  if (actions & FIGURE) {
    if (nb_figure_draw(outcome, folder, call->trust, &drawn, &error))
      return nb_print_plain_error(&error);
    if (drawn)
      printf("look at %s/%s.svg%s\n", folder, outcome->page.name, incomplete);
    else
      printf("%s has no `gnuplot` block, so there is no figure\n", path);
    if (outcome->status == NB_FAILED)
      nb_append_word(word, sizeof word, path), printf("a check of this page failed: type `nineball check %s`\n", word);
  }
  return NB_OK;
}

void nb_remove_checkpoints(struct nb_outcome *outcome, enum nb_status status, const struct nb_call *call) {
  if (status <= NB_FAILED && fflush(stdout) == 0)
    nb_outcome_remove_checkpoints(outcome, &call->options);
}

/* True if a line of the page states an expectation, also one that was not checked; `report` states none. */
static bool has_expectation(const struct nb_outcome *outcome) {
  const struct nb_expectations *const all = &outcome->runs[0].expectations;
  bool found = outcome->mark_count[NB_SKIP];
  for (size_t k = 0; k < all->count; k++)
    found = found || all->list[k].kind != NB_REPORTED;
  return found;
}

/* Makes it an error that no expectation of the page was checked. */
static void report_unchecked(struct nb_outcome *outcome, const char *path) {
  char word[4096] = "";
  nb_append_word(word, sizeof word, path);
  if (has_expectation(outcome))
    outcome->status =
        nb_error_set(&outcome->error, NB_BAD_USE,
                     "nothing was checked, because no expectation of this page could fail; the run itself succeeded: "
                     "see the notes and reasons above, or use `nineball run %s`",
                     word);
  else
    outcome->status =
        nb_error_set(&outcome->error, NB_BAD_USE,
                     "nothing was checked, because the page has no expectation; the run itself succeeded, and "
                     "`nineball run %s` runs such a page%s; to check the page, add a line such as `QUANTITY max below "
                     "VALUE` to a block `expect`: see `nineball --help expect`",
                     word, outcome->check_count ? " and prints the values of its lines `report`" : "");
}

static enum nb_status process_page(const struct nb_call *call, const char *path, unsigned actions, double began) {
  struct nb_outcome outcome;
  char name[NB_NAME_SIZE + 8];
  const char *folder = actions & (TABLES | FIGURE) ? output_folder(name, sizeof name, call, path) : NULL;
  nb_run_page(&outcome, call, path, folder);
  if (actions & VERDICT && !call->tap && outcome.status <= NB_FAILED)
    nb_print_verdict(&outcome);
  if (actions & REQUIRE_CHECKS && nb_outcome_is_unchecked(&outcome))
    report_unchecked(&outcome, path);
  nb_print_errors(&outcome, path);
  if (actions & VERDICT && call->tap)
    nb_print_tap(&outcome, path);
  enum nb_status status = actions & VERDICT || outcome.status > NB_FAILED ? outcome.status : NB_OK;
  if (actions & (TABLES | FIGURE) && nb_outcome_has_rows(&outcome))
    status = nb_worse(status, save_outputs(&outcome, call, path, folder, actions, began));
  nb_remove_checkpoints(&outcome, status, call);
  nb_outcome_free(&outcome);
  return status;
}

static enum nb_status process_pages(const struct nb_call *call, unsigned actions) {
  enum nb_status worst = actions & (TABLES | FIGURE) ? check_folders(call) : NB_OK;
  if (actions & (TABLES | FIGURE) && call->folder && call->page_count > 1) {
    fputs("nineball: -o FOLDER takes one page at a time; `nineball report` takes many\n", stderr);
    return NB_BAD_USE;
  }
  if (worst)
    return worst;
  for (size_t k = 0; k < call->page_count; k++)
    worst = nb_worse(worst, nb_is_stopped(&call->options)
                                ? NB_BROKEN
                                : process_page(call, call->pages[k], actions, k ? nb_cost_clock() : 0));
  return worst;
}

enum nb_status nb_command_run(const struct nb_call *call) { return process_pages(call, VERDICT | TABLES); }
enum nb_status nb_command_check(const struct nb_call *call) {
  return call->rounding ? nb_rounding_check(call) : process_pages(call, VERDICT | REQUIRE_CHECKS);
}
enum nb_status nb_command_figure(const struct nb_call *call) { return process_pages(call, FIGURE); }

/* ---- explain ---- */

enum { FILES_OF_A_PAGE = 3 }; /* table.tsv, values.tsv, verdict.tsv */

enum nb_status nb_command_explain(const struct nb_call *call) {
  enum nb_status worst = NB_OK;
  for (size_t k = 0; k < call->page_count; k++) {
    const double began = k ? nb_cost_clock() : 0;
    struct nb_outcome outcome;
    nb_outcome_read(&outcome, call->pages[k], call->settings);
    nb_print_errors(&outcome, call->pages[k]);
    worst = nb_worse(worst, outcome.status);
    nb_references_prepare();
    const double reading = nb_cost_clock() - began + FILES_OF_A_PAGE * nb_cost_file();
    struct nb_cost sum = {.reading = reading / (double)(outcome.run_count ? outcome.run_count : 1)};
    for (size_t r = 0; r < outcome.run_count && !outcome.status; r++) {
      struct nb_error error;
      const struct nb_page_run *run = &outcome.runs[r];
      printf("%s%s%s%s\n", r ? "\n" : "", outcome.page.name, run->label[0] ? ", run " : "", run->label);
      if (nb_explain(stdout, &run->scene, run, &call->options, &outcome.warnings, &sum, &error)) {
        nb_print_error(&error, &outcome.page, call->pages[k]);
        worst = nb_worse(worst, error.status);
      }
    }
    if (outcome.run_count > 1 && sum.cycles.to > 0) {
      printf("\nall %zu runs\n  ", outcome.run_count);
      nb_cost_print(stdout, &sum, outcome.runs[0].scene.contact_test ? " steps" : " cycles");
      puts("");
    }
    nb_repeat_warnings("", call->pages[k], &outcome.warnings);
    nb_outcome_free(&outcome);
  }
  return worst;
}

/* ---- state ---- */

/* Index of the stage at whose end the state is taken, by default the last stage; -1 with a message. */
static int stage_of(const struct nb_call *call, const struct nb_outcome *outcome) {
  const struct nb_scene *scene = &outcome->runs[0].scene;
  char hint[NB_HINT_SIZE];
  if (scene->contact_test || outcome->run_count > 1) {
    fprintf(stderr, "nineball: %s %s\n", call->pages[0],
            scene->contact_test ? "is a contact test: expected a page with a scene"
                                : "has several runs: choose one, with --set NAME=VALUE for each sweep");
    return -1;
  }
  if (!call->stage)
    return (int)scene->stage_count - 1;
  const struct nb_stage *own = scene->stages + scene->start.stages;
  const size_t count = scene->stage_count - scene->start.stages;
  const int found = NB_FIND(own, count, call->stage);
  if (found >= 0)
    return (int)scene->start.stages + found;
  const char *suggestion = NB_NEAREST(hint, call->stage, own, count);
  fprintf(stderr, "nineball: %s has no stage `%s` of its own%s%s\n", call->pages[0], call->stage,
          suggestion ? "; " : "", suggestion ? suggestion : "");
  return -1;
}

/* Runs the scene to the end of the stage, and writes the state together with the settings of the call. */
static enum nb_status write_state(struct nb_scene *scene, size_t stage, const char *path, const struct nb_call *call,
                                  struct nb_error *error) {
  struct nb_saved saved = {0};
  struct nb_progress_line line = {.page = call->pages[0]};
  const struct nb_progress progress = nb_print_progress(&line);
  nb_scene_truncate(scene, stage);
  enum nb_status status = nb_run_to(&saved, scene, &call->options, &progress, error);
  nb_print_progress_end(&line);
  for (size_t k = 0; call->settings[k] && !status; k++)
    status = nb_saved_setting(&saved, call->settings[k], error);
  if (!status)
    saved.hash = scene->stages[stage].hash, status = nb_saved_write(&saved, path, error);
  nb_saved_free(&saved);
  return status;
}

/* True if a state may be written to the path: there is no such file, or it is a state file, not a page or a table. */
static bool is_replaceable(const char *path) {
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

enum nb_status nb_command_state(const struct nb_call *call) {
  struct nb_outcome outcome;
  char text[3 * NB_NAME_SIZE];
  if (call->page_count > 1) {
    fputs("nineball: `nineball state` takes one page\n", stderr);
    return NB_BAD_USE;
  }
  enum nb_status status = nb_outcome_read(&outcome, call->pages[0], call->settings);
  nb_print_errors(&outcome, call->pages[0]);
  const int stage = status ? -1 : stage_of(call, &outcome);
  if (stage >= 0) {
    struct nb_scene *scene = &outcome.runs[0].scene;
    struct nb_error error = {NB_OK, ""};
    snprintf(text, sizeof text, "%s-%s.state", outcome.page.name, scene->stages[stage].name);
    const char *path = call->folder ? call->folder : text;
    status = is_replaceable(path) ? write_state(scene, (size_t)stage, path, call, &error) : NB_BAD_USE;
    if (error.status)
      fprintf(stderr, "nineball: %s: %s\n", call->pages[0], error.text);
    else if (!status)
      printf(
          "the state at the end of stage `%s` is in %s\na page beside it takes the particles, without velocities and "
          "contact histories, with: packing %s\na page that continues the run needs no such file: start %s stage %s\n",
          scene->stages[stage].name, path, strrchr(path, '/') ? strrchr(path, '/') + 1 : path, outcome.page.name,
          scene->stages[stage].name);
  }
  nb_outcome_free(&outcome);
  return stage < 0 && !status ? NB_BAD_USE : status;
}

/* ---- migrate ---- */

/* Rewrites a page in the words of this version, into its own file or to standard output. */
static enum nb_status migrate(const char *path, bool in_place, struct nb_error *error) {
  struct nb_text text = {0};
  struct nb_save save;
  size_t size;
  char *page = nb_file_read(path, NB_PAGE_MAX, &size, error);
  if (!page)
    return error->status;
  if (strlen(page) < size) {
    free(page);
    return nb_error_set(error, NB_BAD_USE, "expected a page, found a file that is not text");
  }
  nb_migrate(&text, page, path, stderr);
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

enum nb_status nb_command_migrate(const struct nb_call *call) {
  enum nb_status worst = NB_OK;
  if (call->page_count > 1 && !call->in_place) {
    fputs("nineball: several pages can be rewritten only with --in-place: add it, or give one page\n", stderr);
    return NB_BAD_USE;
  }
  for (size_t k = 0; k < call->page_count; k++) {
    struct nb_error error;
    const enum nb_status status = migrate(call->pages[k], call->in_place, &error);
    if (status)
      fprintf(stderr, "%s: error: %s\n", call->pages[k], error.text);
    worst = nb_worse(worst, status);
  }
  return worst;
}

/* ---- laws, list ---- */

enum nb_status nb_command_laws(const struct nb_call *call) {
  (void)call;
  for (const struct nb_law *const *law = nb_laws(); *law; law++) {
    const int doubles = (*law)->history + (*law)->piece * (*law)->pieces;
    printf("%-7s %-21s %s  %s\n%29s parameters of the materials: %s\n%29s %d history variable%s%s; %s%s\n",
           (*law)->kind, (*law)->name, (*law)->title, (*law)->source, "",
           (*law)->parameters[0] ? (*law)->parameters : "none", "", doubles, doubles == 1 ? "" : "s",
           (*law)->piece > 0 ? " or as many as `memory` asks for" : "",
           (*law)->stored ? "reports its stored energy" : "does not report stored energy",
           (*law)->non_conservative ? "; may create energy" : "");
  }
  puts("A contact of two particles of one material has the kn and ks of this material. A contact of two materials\n"
       "with the stiffnesses a and b has 2ab/(a+b), twice that of two springs in series (PFC), unless `pair` gives\n"
       "another stiffness.");
  return NB_OK;
}

enum nb_status nb_command_list(const struct nb_call *call) {
  (void)call;
  puts("references, for `reference NAME` in a page:");
  for (const struct nb_reference *const *reference = nb_references(); *reference; reference++)
    printf("  %-24s %s  %s\n", (*reference)->name, (*reference)->title, (*reference)->source);
  return NB_OK;
}
