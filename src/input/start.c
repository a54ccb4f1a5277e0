/* `start PAGE stage NAME`: continues the scene of another page from the end of one of its stages.
 *
 * The scene has the other page's materials, particles, walls, laws and stages, so that reference solutions can read all
 * of them; all copies have the line of `start`. Regions, monitors and columns are only those of this page. Statements
 * before the first stage of this page belong to that stage.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/clean.h"
#include "hash.h"
#include "statement.h"

enum { AT_PAGE, AT_STAGE };
static const struct nb_argument start_fields[] = {WORD("PAGE", AT_PAGE, "the name of another page"),
                                                  {"stage", "NAME", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_STAGE,
                                                   1, NULL,
                                                   "The run begins at the end of that stage of the other page."},
                                                  END};

enum { CHAIN_MAX = 50 }; /* longest chain of pages that start from each other; they are read and run recursively */

/* ---- copies of the other scene ---- */

/* A copy of an array; *made becomes false if there is no memory. */
static void *copy_of(const void *array, size_t count, size_t element, bool *made) {
  void *copy = nb_array_reserve(NULL, 0, count + 1, element); /* the copy may grow by nb_array_reserve */
  if (copy && count > 0)
    memcpy(copy, array, count * element);
  *made = copy && *made;
  return copy;
}
#define COPY(to, from, things, count)                                                                                  \
  ((to)->things = copy_of((from)->things, (from)->count, sizeof *(from)->things, made),                                \
   (to)->count = *made ? (from)->count : 0)

/* Sets the lines of copied statements to that of `start`. */
#define LINES(things, count)                                                                                           \
  for (size_t k = 0; k < to->count; k++)                                                                               \
  to->things[k].line = line

/* The line of a copied statement; 0: the other page does not have the statement. */
static int replaced_line(int line, int start) { return line ? start : 0; }

static void copy_stage(struct nb_stage *to, const struct nb_stage *from, int line, bool *made) {
  *to = *from;
  COPY(to, from, motions, motion_count);
  COPY(to, from, changes, change_count);
  COPY(to, from, removals, removal_count);
  COPY(to, from, conditions, condition_count);
  if (!*made)
    return;
  LINES(motions, motion_count);
  LINES(changes, change_count);
  LINES(removals, removal_count);
  for (size_t k = 0; k < to->condition_count; k++)
    to->conditions[k].line = line, to->conditions[k].quantity.monitor = -1; /* monitors are not copied */
  int *const lines[] = {
      &to->gravity.line,         &to->damping.contact_line, &to->damping.walls_line, &to->damping.deep_line,
      &to->damping.centred_line, &to->damping.global_line,  &to->circle.line,        &to->boundary.line,
      &to->affine.line,          &to->rotation_line,        &to->cell_line,          &to->box_line,
      &to->laws.normal_line,     &to->laws.shear_line};
  for (size_t k = 0; k < sizeof lines / sizeof *lines; k++)
    *lines[k] = replaced_line(*lines[k], line);
  to->line = to->step.line = line, to->step.set = false;
  to->servo = (struct nb_servo){.box = from->servo.box}; /* the servo reads quantities of the other page */
}

/* Copies a scene; `line` is the line of all copies. False: out of memory. */
static bool copy_scene(struct nb_scene *to, const struct nb_scene *from, int line) {
  bool whole = true, *made = &whole;
  COPY(to, from, materials, material_count);
  COPY(to, from, pair_rules, pair_rule_count);
  COPY(to, from, particles, particle_count);
  COPY(to, from, walls, wall_count);
  COPY(to, from, gradings, grading_count);
  COPY(to, from, fills, fill_count);
  for (size_t k = 0; k < to->grading_count; k++) {
    const struct nb_grading *grading = &from->gradings[k];
    to->gradings[k].line = line;
    COPY(&to->gradings[k], grading, sizes, size_count);
  }
  for (size_t k = 0; k < to->fill_count; k++)
    to->fills[k].line = line;
  to->stages = nb_array_reserve(NULL, 0, from->stage_count + 1, sizeof *to->stages);
  for (size_t s = 0; to->stages && s < from->stage_count; s++)
    copy_stage(&to->stages[to->stage_count++], &from->stages[s], line, made);
  if (!to->stages || !whole)
    return false;
  LINES(materials, material_count);
  LINES(pair_rules, pair_rule_count);
  LINES(particles, particle_count);
  LINES(walls, wall_count);
  /* Laws that --set gives apply to the stages of this page only. */
  struct nb_laws set = {.pieces = to->pieces};
  snprintf(set.normal, sizeof set.normal, "%s", to->normal);
  snprintf(set.shear, sizeof set.shear, "%s", to->shear);
  memcpy(to->normal, from->normal, sizeof to->normal), memcpy(to->shear, from->shear, sizeof to->shear);
  to->normal_line = replaced_line(from->normal_line, line), to->shear_line = replaced_line(from->shear_line, line);
  to->pieces = from->pieces, to->allow_unstable = from->allow_unstable;
  to->damping = from->damping, to->gravity = from->gravity;
  to->gravity.line = replaced_line(to->gravity.line, line);
  to->cell = from->cell, to->cell.line = replaced_line(to->cell.line, line);
  to->circle = from->circle, to->circle.line = replaced_line(to->circle.line, line);
  to->origin_x = from->origin_x, to->origin_y = from->origin_y;
  const struct nb_stage *last = &to->stages[to->stage_count - 1];
  struct nb_stage *first_stage = &to->stages[to->stage_count]; /* the first `stage` of this page names it */
  *first_stage = (struct nb_stage){.record_interval = 1,
                                   .check_interval = 1,
                                   .snapshot_from = -1,
                                   .line = line,
                                   .step = to->step.set ? to->step : last->step,
                                   .damping = last->damping,
                                   .laws = set};
  to->step = to->stages[0].step;
  to->stage_count++;
  return true;
}

/* ---- the other page ---- */

static bool same_file(const char *a, const char *b) {
  struct stat one, other;
  return stat(a, &one) == 0 && stat(b, &other) == 0 && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

/* Number of pages that start from this path, directly or through other pages; -1 if the path is one of these pages, so
 * that reading would never end. */
static int nesting_depth(const struct nb_scene_reading *reading, const char *path) {
  int count = 0;
  for (const struct nb_scene_reading *parent = reading; parent; parent = parent->parent, count++)
    if (same_file(parent->reader.page->path, path))
      return -1;
  return count;
}

/* Takes `NAME=VALUE …` after `with`. The word `with` may be repeated. */
static bool take_settings(struct nb_reader *reader, struct nb_start *start) {
  while (nb_token_skip(reader, "with"), nb_token_peek(reader)) {
    const struct nb_token *token = nb_take_token(reader, "NAME=VALUE");
    if (!token)
      return false;
    if (!strchr(token->text, '=') || token->text[0] == '=') {
      reader->next--;
      return nb_expected(reader, "for example `with friction=0.5`", "NAME=VALUE");
    }
    const struct nb_token *unit = nb_token_peek(reader);
    struct nb_unit read;
    const bool with_unit = unit && nb_unit_read(&read, unit->text);
    const int name = (int)strcspn(token->text, "=");
    char(*setting)[2 * NB_NAME_SIZE] = NB_ARRAY_APPEND(start->settings, start->setting_count);
    if (!setting)
      return nb_no_memory(reader);
    const char *const form = token->computed ? "%.*s=(%s)%s%s" : "%.*s=%s%s%s";
    if ((size_t)snprintf(*setting, sizeof *setting, form, name, token->text, token->text + name + 1,
                         with_unit ? " " : "", with_unit ? unit->text : "") >= sizeof *setting) {
      nb_token_mistake(reader, token, NULL, "expected NAME=VALUE shorter than %zu bytes", sizeof *setting);
      return false;
    }
    reader->next += with_unit;
  }
  return true;
}

/* Finds the path of the other page; false with a message. */
static bool find_page(const struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *word,
                      char path[NB_PATH_SIZE]) {
  const size_t length = strlen(word->text);
  const bool whole = length > 3 && strcmp(word->text + length - 3, ".md") == 0;
  if (!nb_file_find(reader, word, whole ? "" : ".md", path))
    return false;
  const int parent = nesting_depth(reading, path);
  if (parent >= CHAIN_MAX)
    return nb_token_mistake(
        reader, word, "save a state of one of them with `nineball state`, and take its particles with `packing`",
        "expected a chain of at most %d pages that start from each other, found a longer one", CHAIN_MAX);
  if (parent < 0)
    return nb_token_mistake(reader, word, NULL, "expected another page: `%.200s` would start from itself", path);
  return true;
}

/* Reads the scene of the other page with its settings. */
static void read_scene(const struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_start *start,
                       const char *const *settings, const struct nb_token *word) {
  struct nb_mistakes *mistakes = reader->mistakes;
  const size_t before = mistakes->total;
  nb_scene_read_nested(start->scene, start->page, settings, mistakes, reading);
  if (mistakes->total == before && start->scene->contact_test)
    nb_token_mistake(reader, word, NULL, "expected a page with a scene, found a contact test");
  else if (mistakes->total == before && start->scene->runs > 1)
    nb_token_mistake(reader, word, "choose one run: `with NAME=VALUE`",
                     "expected a page of one run, found one of %zu runs", start->scene->runs);
}

static bool read_other(const struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_start *start,
                       const struct nb_token *word) {
  const size_t before = reader->mistakes->total;
  const char **settings = calloc(start->setting_count + 1, sizeof *settings);
  char path[NB_PATH_SIZE];
  start->page = calloc(1, sizeof *start->page), start->scene = calloc(1, sizeof *start->scene);
  if (!settings || !start->page || !start->scene) {
    free(settings);
    return nb_no_memory(reader);
  }
  for (size_t k = 0; k < start->setting_count; k++)
    settings[k] = start->settings[k];
  if (find_page(reading, reader, word, path) && !nb_page_read(start->page, path, reader->mistakes))
    read_scene(reading, reader, start, settings, word);
  free(settings);
  if (reader->mistakes->total > before)
    nb_token_mistake(reader, word, NULL,
                     "expected a page and settings without errors: the messages about them say what is wrong");
  return reader->mistakes->total == before;
}

void nb_scene_truncate(struct nb_scene *scene, size_t stage) {
  scene->column_count = 0;
  for (size_t k = 0; k <= stage; k++)
    scene->stages[k].record_interval = 0, scene->stages[k].snapshot = false, scene->stages[k].snapshot_from = -1;
  nb_stages_free(scene, stage + 1);
}

/* Removes the stages of the other page after the named one. */
static bool truncate_scene(struct nb_reader *reader, struct nb_scene *other, const struct nb_token *name) {
  char list[NB_HINT_SIZE / 2] = "", hint[NB_HINT_SIZE];
  for (size_t k = other->start.stages; k < other->stage_count; k++)
    nb_append_item(list, sizeof list, other->stages[k].name, k + 1 == other->stage_count);
  snprintf(hint, sizeof hint, "name a stage of that page: %s", list);
  const int s = NB_NAMED(reader, name, other->stages, other->stage_count, "the name of a stage of that page", hint);
  if (s < 0)
    return false;
  if (s < (int)other->start.stages)
    return nb_token_mistake(
        reader, name, "start from the page that defines this stage",
        "expected a stage that the other page defines itself; `%s` belongs to the page from which that page starts",
        name->text);
  nb_scene_truncate(other, (size_t)s);
  return true;
}

/* After a `start` with a mistake the rest of the page is not read, because it may depend on the other page. After a
 * word of another program that means `start`, the rest is read, but no name in it is unknown. */
static void leave_unjudged(struct nb_scene_reading *reading, const struct nb_reader *reader) {
  const bool start = strcmp(reader->tokens[0].text, "start") == 0;
  if (!start)
    nb_suppress_name(reader->mistakes, NB_ANYTHING);
  reading->start_failed = start && reading->here == NB_IN_SCENE;
}

NB_APPLY(apply_start) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_start *start = &scene->start;
  const struct nb_token *word = record->value[AT_PAGE].token, *name = record->value[AT_STAGE].token;
  if (reader->bad) {
    leave_unjudged(reading, reader);
    return;
  }
  reading->start_failed = true; /* set to false at the end, when `start` has succeeded */
  if (reading->first_line != reader->line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected one `start`, above all statements except `units`, `let` and `sweep`");
    return;
  }
  start->line = (int)reader->line;
  if (nb_token_peek(reader) && (!nb_take_word(reader, "with") || !take_settings(reader, start)))
    return;
  if (!read_other(reading, reader, start, word) || !truncate_scene(reader, start->scene, name))
    return;
  if (reading->units_line && reader->unitless != start->scene->unitless) {
    nb_token_mistake(reader, word, "remove the line `units`: without it this page has the units of the other page",
                     "expected a page with the same `units`, found one with `units %s`",
                     start->scene->unitless ? "none" : "si");
    return;
  }
  scene->unitless = reading->reader.unitless = reading->setting.unitless = start->scene->unitless;
  nb_setting_read_step(reading);
  reading->hash = nb_hash(reading->hash, &start->scene->stages[start->scene->stage_count - 1].hash,
                          sizeof start->scene->stages->hash);
  if (!copy_scene(scene, start->scene, start->line)) {
    nb_no_memory(reader);
    return;
  }
  start->stages = start->scene->stage_count;
  reading->start_failed = false;
  reading->before_first_stage = true;
  reading->here = NB_IN_START;
  reading->reader.starts = true;
}

void nb_start_free(struct nb_start *start) {
  if (start->scene)
    nb_scene_free(start->scene);
  if (start->page)
    nb_page_free(start->page);
  free(start->scene), free(start->page), free(start->settings);
}

/* ---- hash of everything on which a state depends ---- */

/* The hash begins with the version of the program and the settings that override statements, `refine` and `soften`.
 * Values that --set gives to names are not added here, because the statements that use them contain them. */
unsigned long long nb_hash_settings(nb_settings settings) {
  static const char *const statements[] = {"normal=", "shear=", "step=", "damping=", "refine=", "soften="};
  unsigned long long hash = nb_hash(NB_HASH_BEGIN, NB_VERSION, sizeof NB_VERSION);
  for (size_t k = 0; settings && settings[k]; k++)
    for (size_t s = 0; s < sizeof statements / sizeof *statements; s++)
      if (strncmp(settings[k], statements[s], strlen(statements[s])) == 0)
        hash = nb_hash(hash, settings[k], strlen(settings[k]) + 1);
  return hash;
}

/* Adds a statement, in which values have replaced names, unless the statement concerns only output or advice. */
void nb_hash_line(struct nb_scene_reading *reading) {
  const struct nb_reader *reader = &reading->reader;
  const char *verb = reader->tokens[0].text;
  reading->first_line = reading->first_line ? reading->first_line : reader->line;
  static const char *const without[] = {"record", "snapshot", "trade",
                                        "start"}; /* `start` adds the hash of the other page */
  for (size_t k = 0; k < sizeof without / sizeof *without; k++)
    if (strcmp(verb, without[k]) == 0)
      return;
  for (size_t k = 0; k < reader->count; k++)
    reading->hash = nb_hash(reading->hash, reader->tokens[k].text, strlen(reader->tokens[k].text) + 1);
  reading->hash = nb_hash(reading->hash, "\n", 1);
}

/* clang-format off */
NB_STATEMENTS(start) = {
  {"start", NB_IN_SCENE | NB_OWN_EXAMPLE, start_fields, "{with NAME=VALUE …}", 0, true, apply_start,
   "Continues from the end of a stage of another page, PAGE.md. The program runs the other page up to there once and saves its state in a folder: docs/STATE.md. Particles, walls, a boundary or a cell, materials, laws, damping, gravity and step are those at the end of that stage; cycles and time continue. Monitors and columns are this page's own. Statements of this page before its first stage take effect when this first stage begins. Only `units`, `let` and `sweep` may precede `start`. The program searches for the page in the folder of this page, then in the nearest folder `cases` above it and all folders below that, where only one file may have that name. A name that begins with `../` or `/` is a path from this page's folder or from the root.\n"
   "with NAME=VALUE …: values for names of the other page, as --set gives them; without it: the values in that page.",
   "start     nine-discs stage load\nmonitor   C  disc 5 with disc 6\nrecord    cycle C.normal\nstage     rest\n  walls   stop\n  cycles  400"},
  {0},
};
/* clang-format on */
