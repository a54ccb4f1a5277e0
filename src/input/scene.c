/* A page's scene blocks as a struct nb_scene: every name resolved, every number SI.
 *
 * Two passes. The first looks at `units`, `let` and `sweep` only: how long the sweeps are decides which values a run
 * takes. The second reads every statement by the table in scene_table.c. What needs the whole scene is checked at its
 * end.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool nb_too_many(struct nb_reader *reader, size_t count, int most, const char *what) {
  if (count < (size_t)most)
    return false;
  nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d %s, with this there are more", most, what);
  return true;
}

bool nb_watch_unsure(const struct nb_scene *scene, const char *name) {
  size_t length = strcspn(name, ".");
  for (size_t i = 0; i < scene->watch_count; i++) {
    const struct nb_watch *watch = &scene->watches[i];
    if (watch->a < 0 && strncmp(watch->name, name, length) == 0 && watch->name[length] == '\0')
      return true;
  }
  return false;
}

bool nb_asked_find(struct nb_scene_reading *reading, struct nb_quantity *quantity, const struct nb_asked *asked) {
  char nearest[2 * NB_NAME_SIZE] = "", hint[NB_HINT_SIZE] = "";
  if (nb_watch_unsure(reading->scene, asked->name))
    return false;
  if (nb_quantity_find(quantity, reading->scene, asked->name, nearest))
    return true;
  if (nearest[0])
    snprintf(hint, sizeof hint, "did you mean `%s`?", nearest);
  nb_mistake(reading->reader.mistakes, &reading->reader.page[0], asked->line, asked->column, asked->length, hint,
             "expected a quantity, found `%s`", asked->name);
  return false;
}

void nb_say_of_scene(struct nb_scene_reading *reading, const char *hint, const char *what) {
  const struct nb_page *page = reading->reader.page;
  const char *kind = reading->scene->path ? "path" : "scene";
  size_t fence = nb_page_fence(page, reading->scene->path ? NB_BLOCK_PATH : NB_BLOCK_SCENE);
  const char *word = fence ? strstr(page->lines[fence - 1], kind) : NULL;
  nb_mistake(reading->reader.mistakes, page, fence, word ? (int)(word - page->lines[fence - 1]) + 1 : 1,
             (int)strlen(kind), hint, "%s", what);
}

/* What a statement that was wrong leaves unknown. Of one that gives a name, and has it, that is known. */
static unsigned unsure_after(const struct nb_reader *reader) {
  static const struct {
    const char *word;
    bool names;
    unsigned unsure;
  } rows[] = {{"units", false, NB_UNSURE_UNITS},    {"let", true, NB_UNSURE_VALUES},
              {"sweep", true, NB_UNSURE_VALUES},    {"watch", true, NB_UNSURE_WATCHES},
              {"region", true, NB_UNSURE_WATCHES},  {"impact", false, NB_UNSURE_WATCHES},
              {"record", false, NB_UNSURE_COLUMNS}, {"stage", true, NB_UNSURE_STAGES},
              {"leg", true, NB_UNSURE_STAGES},      {"repeat", false, NB_UNSURE_STAGES}};
  const struct nb_token *name = reader->count > 1 ? &reader->tokens[1] : NULL;
  const bool several = reader->count > 2 && strcmp(reader->tokens[2].text, "with") == 0;
  const bool named = name && !name->hollow && nb_is_name(name->text) && !several;
  if (!reader->meant)
    return NB_UNSURE_ALL;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    if (strcmp(rows[k].word, reader->meant->word) == 0)
      return rows[k].names && named ? 0 : rows[k].unsure;
  return 0;
}

/* A statement, if there is one in that line. */
static void read_line(struct nb_scene_reading *reading, size_t line) {
  struct nb_reader *reader = &reading->reader;
  if (reader->page->kind_of[line - 1] != 1 + (reading->scene->path ? NB_BLOCK_PATH : NB_BLOCK_SCENE) ||
      !nb_line_read(reader, line))
    return;
  const char *verb = reader->tokens[0].text;
  bool value = strcmp(verb, "units") == 0 || strcmp(verb, "let") == 0 || strcmp(verb, "sweep") == 0;
  if (value ? reading->repeat.now > 0 : reading->survey)
    return;
  if (!value)
    nb_hash_line(reading);
  if (!value && nb_repeat_closed(reading))
    return;
  nb_statement_read(reader, nb_keywords(), reading->here, reading);
  reading->cell_unsure = reading->cell_unsure || (reader->bad && strcmp(verb, "cell") == 0);
  if (reading->lost)
    return;
  if (reader->bad && !reading->survey)
    reader->unsure |= unsure_after(reader);
  if (reading->scene->stage_count > 0 && !reading->survey)
    nb_stage_now(reading->scene)->hash = reading->hash;
}

static void read_lines(struct nb_scene_reading *reading) {
  struct nb_repeat *repeat = &reading->repeat;
  for (size_t line = 1; line <= reading->reader.page->line_count && !reading->lost; line++) {
    read_line(reading, line);
    const unsigned long times = repeat->times;
    repeat->times = 0;
    for (unsigned long k = 0; k < times && !reading->reader.bad; k++) {
      repeat->now = 2 + k;
      for (size_t again = repeat->from; again < line && !reading->reader.bad; again++)
        read_line(reading, again);
    }
    repeat->now = 0;
  }
}

/* First pass: how long are the sweeps, which names are there. */
static void survey(struct nb_scene_reading *reading, struct nb_mistakes *mistakes) {
  struct nb_mistakes unsaid = {0};
  reading->survey = true;
  reading->reader.mistakes = reading->setting.mistakes = &unsaid;
  read_lines(reading);
  reading->survey = false;
  reading->reader.mistakes = reading->setting.mistakes = mistakes;
  if (unsaid.no_memory)
    nb_mistake_memory(mistakes);
  nb_mistakes_free(&unsaid);
  nb_settings_read(reading);
  reading->scene->binding_count = reading->reader.binding_count = 0;
  reading->sweep = 0;
  reading->units_line = 0;
}

/* The settings as lines of a page that is no file. False: no memory. */
static bool keep_settings(struct nb_scene_reading *reading, nb_settings settings) {
  static char path[] = "--set";
  size_t count = 0;
  while (settings && settings[count])
    count++;
  reading->settings = (struct nb_page){.path = path, .line_count = count};
  reading->settings.lines = calloc(count + 1, sizeof *reading->settings.lines);
  for (size_t i = 0; i < count && reading->settings.lines; i++) {
    size_t size = strlen(settings[i]) + 1;
    char *line = malloc(size);
    if (!line)
      return false;
    reading->settings.lines[i] = memcpy(line, settings[i], size);
  }
  return reading->settings.lines != NULL;
}

static void read_scene(struct nb_scene_reading *reading, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->made;
  struct nb_scene *scene = reading->scene;
  survey(reading, mistakes);
  read_lines(reading);
  if (reading->lost) {
    scene->unsure = NB_UNSURE_ALL;
    return;
  }
  nb_whole_check(reading);
  if (!scene->normal[0])
    strcpy(scene->normal, "linear");
  if (!scene->shear[0])
    strcpy(scene->shear, "none");
  if (scene->impact.line && mistakes->made == before)
    nb_impact_aim(reading);
  if (!nb_scene_place(scene, &reading->place) && mistakes->made == before) {
    nb_line_mistake(&reading->reader, reading->place.line, NULL,
                    "expected a place that a double can hold, this one is too far away");
  }
  scene->unitless = reading->reader.unitless;
  scene->unsure =
      scene->path || nb_page_fence(reading->reader.page, NB_BLOCK_SCENE) ? reading->reader.unsure : NB_UNSURE_ALL;
  if (mistakes->made == before)
    nb_laws_check(reading);
  if (mistakes->made == before && scene->path)
    nb_path_laws_check(reading);
}

/* Reads one run, and says how many there are. */
static enum nb_status read_run(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                               struct nb_mistakes *mistakes, const struct nb_scene_reading *above, size_t *runs) {
  size_t before = mistakes->made;
  *scene = (struct nb_scene){.page = page};
  struct nb_scene_reading *reading = calloc(1, sizeof *reading);
  *runs = 1;
  if (reading && keep_settings(reading, settings)) {
    reading->scene = scene;
    reading->run = run;
    reading->above = above;
    reading->hash = nb_hash_settings(settings);
    scene->path = nb_page_fence(page, NB_BLOCK_PATH) != 0;
    reading->here = scene->path ? NB_IN_PATH : NB_IN_SCENE;
    reading->reader.page = page;
    reading->setting.page = &reading->settings;
    read_scene(reading, mistakes);
    *runs = nb_runs(reading);
  } else {
    nb_mistake_memory(mistakes);
  }
  if (reading) {
    for (size_t i = 0; reading->settings.lines && i < reading->settings.line_count; i++)
      free(reading->settings.lines[i]);
    free(reading->settings.lines);
    free(reading->rows);
    free(reading->asked);
    free(reading);
  }
  return nb_mistakes_status(mistakes, before);
}

size_t nb_scene_runs(const struct nb_page *page, nb_settings settings, struct nb_mistakes *mistakes) {
  struct nb_scene scene;
  size_t runs;
  read_run(&scene, page, 0, settings, mistakes, NULL, &runs);
  nb_scene_free(&scene);
  return runs <= NB_RUNS_MAX ? runs : 1;
}

enum nb_status nb_scene_read(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                             struct nb_mistakes *mistakes) {
  size_t runs;
  return read_run(scene, page, run, settings, mistakes, NULL, &runs);
}

enum nb_status nb_scene_read_below(struct nb_scene *scene, const struct nb_page *page, nb_settings settings,
                                   struct nb_mistakes *mistakes, const struct nb_scene_reading *above, size_t *runs) {
  return read_run(scene, page, 0, settings, mistakes, above, runs);
}
