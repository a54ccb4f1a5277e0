/* Reads a page's scene blocks into a struct nb_scene, with all names resolved and all numbers in SI.
 *
 * There are two passes. The first reads only lines with `units`, `let`, `sweep` and `start`, because the lengths of the
 * sweeps determine the values of a run. The second reads every statement. Then the whole scene is checked: the kind of
 * page, its columns, missing statements.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "scene.h"
#include "core/clean.h"

#include <stdlib.h>
#include <string.h>

/* ---- the register ---- */

#define NB_STATEMENTS(file) extern const struct nb_keyword nb_statements_##file[];
#include "statements-register.h"
#undef NB_STATEMENTS

const struct nb_family *nb_keywords(void) {
  static const struct nb_family families[] = {
#define NB_STATEMENTS(file) {nb_statements_##file},
#include "statements-register.h"
#undef NB_STATEMENTS
      {NULL}};
  return families;
}

/* ---- mistakes common to several statements ---- */

bool nb_set_twice(struct nb_reader *reader, const char *what, int line) {
  char note[NB_HINT_SIZE], hint[NB_HINT_SIZE] = "keep one of the two lines";
  if (nb_pair_hint(note, reader->tokens[0].text, "twice"))
    nb_append(hint, sizeof hint, "; %s", note);
  if (line)
    nb_token_mistake(reader, &reader->tokens[0], hint, "%s is given twice, first on line %d", what, line);
  return reader->bad;
}

bool nb_given_twice(struct nb_reader *reader, int line) {
  char what[NB_NAME_SIZE + 2];
  snprintf(what, sizeof what, "`%.63s`", reader->tokens[0].text);
  return nb_set_twice(reader, what, line);
}

bool nb_too_many(struct nb_reader *reader, size_t count, int most, const char *what) {
  if (count >= (size_t)most)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d %s, found more", most, what);
  return reader->bad;
}

bool nb_exists(struct nb_reader *reader, const struct nb_token *name, const char *what, int line) {
  char hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint, "the word after `%.80s` is a name: choose another one", reader->tokens[0].text);
  if (line)
    nb_token_mistake(reader, name, hint, "there is a %s `%s` already, on line %d", what, name->text, line);
  return reader->bad;
}

void nb_scene_mistake(struct nb_scene_reading *reading, const char *statement, const char *hint, const char *what) {
  const struct nb_page *page = reading->reader.page;
  const char *kind = reading->scene->contact_test ? "contact-test" : "scene";
  size_t fence = nb_page_fence(page, reading->scene->contact_test ? NB_BLOCK_CONTACT_TEST : NB_BLOCK_SCENE);
  const char *word = fence ? strstr(page->lines[fence - 1], kind) : NULL;
  if (!nb_name_suppressed(reading->reader.mistakes, statement))
    nb_mistake(reading->reader.mistakes, page, fence, word ? (int)(word - page->lines[fence - 1]) + 1 : 1,
               (int)strlen(kind), hint, "%s", what);
}

/* ---- the passes ---- */

/* True if a statement defines values. Such statements are read in both passes, and not again when lines are
 * repeated. */
static bool defines_value(const char *verb) {
  return strcmp(verb, "units") == 0 || strcmp(verb, "let") == 0 || strcmp(verb, "sweep") == 0;
}

/* True if the first pass must read a line. A line that begins with a $NAME or an expression may be such a line, too. */
static bool is_surveyed(const char *text) {
  char first[NB_NAME_SIZE];
  text += strspn(text, " \t\r");
  snprintf(first, sizeof first, "%.*s", (int)strcspn(text, " \t\r#"), text);
  return defines_value(first) || strcmp(first, "start") == 0 || strpbrk(first, "$(");
}

/* True if this pass reads the line. */
static bool is_read(const struct nb_scene_reading *reading, size_t line) {
  const struct nb_page *page = reading->reader.page;
  const enum nb_block_kind kind = reading->scene->contact_test ? NB_BLOCK_CONTACT_TEST : NB_BLOCK_SCENE;
  return page->kind_of[line - 1] == 1 + kind && (!reading->survey || is_surveyed(page->lines[line - 1]));
}

static void note_start(struct nb_scene_reading *reading) {
  if (reading->survey && strcmp(reading->reader.tokens[0].text, "start") == 0)
    reading->before_start = true;
}

/* Reads the statement of a line, if there is one. */
static void read_line(struct nb_scene_reading *reading, size_t line) {
  struct nb_reader *reader = &reading->reader;
  if (!is_read(reading, line) || !nb_line_read(reader, line))
    return;
  const bool value = defines_value(reader->tokens[0].text);
  note_start(reading);
  if (value ? reading->repeat.now > 0 : reading->survey)
    return;
  if (!value)
    nb_hash_line(reading);
  if (!value && nb_misplaced_after_repeat(reading))
    return;
  nb_statement_read(reader, nb_keywords(), reading->here, reading);
  nb_late_warn(reading);
  struct nb_stage *stage = nb_current_stage(reading->scene);
  if (stage && !reading->survey && !reading->start_failed)
    stage->hash = reading->hash;
  if (stage && reader->bad) /* the bad statement may be the one that gives the end of the stage */
    nb_suppress_name(reader->mistakes, stage->name);
}

static void read_lines(struct nb_scene_reading *reading) {
  struct nb_repeat *repeat = &reading->repeat;
  for (size_t line = 1; line <= reading->reader.page->line_count && !reading->start_failed; line++) {
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

/* The first pass, which finds the lengths of the sweeps and the names of all values. */
static void survey(struct nb_scene_reading *reading, struct nb_mistakes *mistakes) {
  struct nb_mistakes discarded = {0};
  reading->survey = true;
  reading->reader.mistakes = reading->setting.mistakes = &discarded;
  read_lines(reading);
  reading->survey = false;
  reading->setting.mistakes = mistakes;
  nb_settings_read(reading);
  reading->reader.mistakes = mistakes;
  if (discarded.no_memory)
    nb_mistake_memory(mistakes);
  nb_mistakes_free(&discarded);
  reading->scene->binding_count = reading->reader.binding_count = 0;
  reading->sweep = 0;
  reading->units_line = 0;
}

/* Stores the settings as lines of a page without a file: those of the command line, or those of `start … with` on a page
 * that another starts from. False: no memory. */
static bool store_settings(struct nb_scene_reading *reading, nb_settings settings) {
  static char set[] = "--set", with[] = "start … with";
  size_t count = 0;
  while (settings && settings[count])
    count++;
  reading->settings = (struct nb_page){.path = reading->parent ? with : set, .line_count = count};
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

/* ---- the whole scene ---- */

static void find_columns(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  for (size_t i = 0; i < reading->requested_count; i++) {
    struct nb_column column = {.tracked = false};
    memcpy(column.name, reading->requested[i].name, sizeof column.name);
    column.line = (int)reading->requested[i].line;
    if (nb_requested_find(reading, &column.quantity, &reading->requested[i]))
      NB_APPEND(&reading->reader, scene->columns, scene->column_count, column);
  }
}

/* True if the stage has no end, and this should be reported. A repeated stage is reported once. */
static bool lacks_end(const struct nb_scene *scene, const struct nb_mistakes *mistakes, size_t stage) {
  size_t first = 0;
  while (scene->stages[first].line != scene->stages[stage].line)
    first++;
  return first == stage && scene->stages[stage].cycles == 0 && !nb_name_suppressed(mistakes, scene->stages[stage].name);
}

static void check_step(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  size_t stepped = 0; /* the first stage with a step */
  while (stepped < scene->stage_count && scene->stages[stepped].step.value == 0)
    stepped++;
  if ((scene->stage_count > 0 ? scene->stages[0].step.value : scene->step.value) == 0)
    nb_scene_mistake(reading, "step", "add `step TIME` or `step F of stable` above the first `stage`",
                     stepped < scene->stage_count
                         ? "expected a `step` for the first stage, found one in a later stage only"
                         : "expected a scene with a `step`, found none");
}

static void check_whole(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_reader *reader = &reading->reader;
  if (scene->contact_test && nb_page_fence(reader->page, NB_BLOCK_SCENE))
    nb_scene_mistake(reading, "scene", "write two pages, one with the scene and one with the contact test",
                     "expected blocks of kind `scene` or `contact-test`, found both");
  if (!scene->contact_test && !nb_page_fence(reader->page, NB_BLOCK_SCENE)) {
    nb_scene_mistake(reading, "scene", "begin one with a line of three backticks and the word `scene`",
                     "expected a block of kind `scene`, found none");
    nb_suppress_name(reader->mistakes, NB_ANYTHING);
    return;
  }
  find_columns(reading);
  if (scene->contact_test) {
    nb_contact_test_check(reading);
    return;
  }
  if (reading->before_first_stage)
    nb_stages_free(scene, scene->start.stages);
  nb_ramps_check(reading);
  nb_regions_check(reading);
  nb_cell_check(reading);
  nb_imposed_motion_check(reading);
  nb_box_check(reading);
  if (scene->particle_count == 0 && !nb_particles_incomplete(reading))
    nb_scene_mistake(reading, "disc", "add particles with `disc`, `sphere`, `lattice`, `fill` or `packing`",
                     "expected a scene with particles, found none");
  if (scene->stage_count == scene->start.stages)
    nb_scene_mistake(reading, "stage", "begin one with `stage NAME`, and give its length with `cycles N`",
                     "expected a scene with a stage, found none");
  for (size_t i = 0; i < scene->stage_count; i++)
    if (lacks_end(scene, reader->mistakes, i))
      nb_line_mistake(reader, (size_t)scene->stages[i].line,
                      "add `cycles N`, or `until QUANTITY above|below VALUE at most N cycles`",
                      "expected a stage that ends, found neither `cycles` nor `until` in `%s`", scene->stages[i].name);
  check_step(reading);
}

static void read_scene(struct nb_scene_reading *reading, struct nb_mistakes *mistakes) {
  const size_t before = mistakes->total;
  struct nb_scene *scene = reading->scene;
  survey(reading, mistakes);
  read_lines(reading);
  if (reading->start_failed) {
    nb_suppress_name(mistakes, NB_ANYTHING);
    return;
  }
  check_whole(reading);
  if (!scene->normal[0])
    strcpy(scene->normal, "linear");
  if (!scene->shear[0])
    strcpy(scene->shear, "none");
  nb_soften(reading);
  if (scene->impact.line && mistakes->total == before)
    nb_impact_set(reading);
  if (!nb_scene_transform(scene, &reading->transform) && mistakes->total == before)
    nb_line_mistake(&reading->reader, (size_t)reading->transform.line, NULL,
                    "expected finite coordinates after `transform`; these are too large");
  if (mistakes->total == before)
    nb_refine(reading);
  nb_laws_check(reading, mistakes->total == before);
  if (mistakes->total == before)
    nb_servo_check(reading), nb_strain_check(scene);
  if (mistakes->total == before && !scene->start.line) {
    nb_outside_check(scene);
    if (!reading->transform.line)
      nb_fall_check(scene);
  }
  nb_spin_check(scene);
  if (mistakes->total == before && scene->contact_test)
    nb_contact_test_laws_check(reading);
}

static enum nb_status read_run(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                               struct nb_mistakes *mistakes, const struct nb_scene_reading *parent) {
  size_t before = mistakes->total;
  *scene = (struct nb_scene){.page = page, .runs = 1, .refine = 1, .soften = 1};
  struct nb_scene_reading *reading = calloc(1, sizeof *reading);
  if (reading)
    reading->parent = parent;
  if (reading && store_settings(reading, settings)) {
    reading->scene = scene;
    reading->run = run;
    reading->hash = nb_hash_settings(settings);
    scene->contact_test = nb_page_fence(page, NB_BLOCK_CONTACT_TEST) != 0;
    reading->here = scene->contact_test ? NB_IN_CONTACT_TEST : NB_IN_SCENE;
    reading->reader.page = page;
    reading->reader.warnings = &scene->warnings;
    reading->setting.page = &reading->settings;
    read_scene(reading, mistakes);
    scene->runs = nb_run_count(reading);
  } else {
    nb_mistake_memory(mistakes);
  }
  if (reading) {
    for (size_t i = 0; reading->settings.lines && i < reading->settings.line_count; i++)
      free(reading->settings.lines[i]);
    free(reading->settings.lines);
    free(reading->rows);
    free(reading->requested);
    free(reading);
  }
  return nb_mistakes_status(mistakes, before);
}

enum nb_status nb_scene_read(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                             struct nb_mistakes *mistakes) {
  nb_suppress_no_name(mistakes);
  return read_run(scene, page, run, settings, mistakes, NULL);
}

enum nb_status nb_scene_read_nested(struct nb_scene *scene, const struct nb_page *page, nb_settings settings,
                                    struct nb_mistakes *mistakes, const struct nb_scene_reading *parent) {
  return read_run(scene, page, 0, settings, mistakes, parent);
}

/* ---- memory of a scene ---- */

void nb_stages_free(struct nb_scene *scene, size_t from) {
  for (size_t i = from; i < scene->stage_count; i++) {
    free(scene->stages[i].motions);
    free(scene->stages[i].changes);
    free(scene->stages[i].removals);
    free(scene->stages[i].conditions);
    free(scene->stages[i].segment.points);
  }
  scene->stage_count = from < scene->stage_count ? from : scene->stage_count;
}

void nb_scene_free(struct nb_scene *scene) {
  nb_stages_free(scene, 0);
  nb_start_free(&scene->start);
  for (size_t i = 0; i < scene->grading_count; i++)
    free(scene->gradings[i].sizes);
  free(scene->gradings);
  for (size_t i = 0; i < scene->packing_count; i++)
    free(scene->packings[i].path);
  free(scene->packings);
  free(scene->fills);
  free(scene->materials);
  free(scene->pair_rules);
  free(scene->particles);
  free(scene->walls);
  free(scene->monitors);
  free(scene->regions);
  free(scene->columns);
  free(scene->stages);
  free(scene->bindings);
  free(scene->trades);
  memset(scene, 0, sizeof *scene);
}
