/* `nineball state`: the state at the end of a stage, in a file where the user wants it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <string.h>
#include <sys/stat.h>

#include "commands.h"
#include "core/guess.h"
#include "input/scene.h"
#include "outcome.h"
#include "run/start.h"

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
    status = nb_saved_setting(&saved, use->settings[k], error);
  if (!status)
    saved.hash = scene->stages[stage].hash, status = nb_saved_write(&saved, path, error);
  nb_saved_free(&saved);
  return status;
}

/* A state takes the place of nothing but a state: a page or a table of that name stays. */
static bool may_be_replaced(const char *path) {
  static const char first[] = "nineball state ";
  char begin[sizeof first] = "";
  struct stat status;
  if (lstat(path, &status) != 0)
    return true;
  FILE *file = S_ISREG(status.st_mode) ? fopen(path, "r") : NULL;
  if (file) {
    begin[fread(begin, 1, sizeof first - 1, file)] = 0;
    fclose(file);
  }
  if (strcmp(begin, first) == 0)
    return true;
  fprintf(stderr, "nineball: %s is no state, and stays: expected the name of a state or of a new file\n", path);
  return false;
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
    struct nb_error error = {NB_OK, ""};
    snprintf(text, sizeof text, "%s-%s.state", outcome.page.name, scene->stages[stage].name);
    const char *path = use->folder ? use->folder : text;
    status = may_be_replaced(path) ? write_state(scene, (size_t)stage, path, use, &error) : NB_BAD_USE;
    if (error.status)
      fprintf(stderr, "nineball: %s: %s\n", use->pages[0], error.text);
    else if (!status)
      printf("the state at the end of stage `%s` is in %s\na page beside it takes the bodies: packing %s\n",
             scene->stages[stage].name, path, strrchr(path, '/') ? strrchr(path, '/') + 1 : path);
  }
  nb_outcome_free(&outcome);
  return stage < 0 && !status ? NB_BAD_USE : status;
}
