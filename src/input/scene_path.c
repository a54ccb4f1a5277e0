/* A path: the contact on the bench, and the legs that it goes through. Its bodies and its wall are those of a scene, so that
 * whoever reads a scene finds them; its legs are stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "bench_quantities.h"
#include "columns.h"
#include "core/names.h"
#include "laws/law.h"
#include "packing/packing.h"
#include "scene.h"

enum { STEPS_MAX = 1000000000, STEPS_DEFAULT = 100 };

/* ---- contact ---- */

/* `sphere R MATERIAL`: a body that touches the plane x = 0 from the left; false with a message. */
static bool take_side(struct nb_body *body, const struct nb_scene *scene, struct nb_reader *reader) {
  const bool sphere = nb_token_skip(reader, "sphere");
  if (!sphere && !nb_token_skip(reader, "disc"))
    return nb_expected(reader, NULL,
                       scene->body_count ? "`sphere R MATERIAL`, `disc R MATERIAL` or `wall MATERIAL`"
                                         : "`sphere R MATERIAL` or `disc R MATERIAL`"),
           false;
  *body = (struct nb_body){.shape = sphere ? NB_SPHERE : NB_DISC, .line = (int)reader->line};
  if (!nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &body->radius))
    return false;
  const struct nb_token *material = nb_take(reader, "the name of a material");
  body->material = material && !material->hollow ? nb_material_of(scene, reader, material) : -1;
  return body->material >= 0;
}

static bool add_body(struct nb_scene *scene, struct nb_reader *reader, struct nb_body body) {
  const struct nb_lattice one = {1, 1, scene->body_count ? body.radius : -body.radius, 0, 0, false};
  if (!nb_fill_lattice(scene, one, body))
    return nb_no_memory(reader), false;
  return true;
}

static bool add_wall(struct nb_scene *scene, struct nb_reader *reader) {
  const struct nb_token *material = nb_take(reader, "the name of a material");
  const double half = scene->bodies[0].radius;
  struct nb_wall wall = {.name = "wall", .ey = 1, .h1 = -half, .h2 = half, .line = (int)reader->line};
  wall.material = material && !material->hollow ? nb_material_of(scene, reader, material) : -1;
  if (wall.material < 0)
    return false;
  struct nb_wall *walls = nb_room(scene->walls, scene->wall_count, 1, sizeof *walls);
  if (!walls)
    return nb_no_memory(reader), false;
  scene->walls = walls;
  walls[scene->wall_count++] = wall;
  return true;
}

NB_APPLY(nb_apply_contact) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_body body;
  (void)record;
  if (!scene->path) /* in a scene it is a mistake that has been reported, and defines nothing */
    return;
  if (reading->contact_line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`contact` is said twice: first on line %d",
                     reading->contact_line);
    return;
  }
  reading->contact_line = (int)reader->line;
  if (!take_side(&body, scene, reader) || !add_body(scene, reader, body) || !nb_take_word(reader, "with"))
    return;
  if (nb_token_skip(reader, "wall"))
    add_wall(scene, reader);
  else if (take_side(&body, scene, reader))
    add_body(scene, reader, body);
}

/* ---- legs ---- */

/* A stage of this name at the end; NULL with a message. */
static struct nb_stage *add_leg(struct nb_scene *scene, struct nb_reader *reader, struct nb_stage leg) {
  if (nb_too_many(reader, scene->stage_count, NB_NAMED_MAX, "legs"))
    return NULL;
  struct nb_stage *stages = nb_room(scene->stages, scene->stage_count, 1, sizeof *stages);
  if (!stages) {
    nb_no_memory(reader);
    return NULL;
  }
  scene->stages = stages;
  stages[scene->stage_count] = leg;
  return &stages[scene->stage_count++];
}

static int find_leg(const struct nb_scene *scene, const char *name) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (strcmp(scene->stages[s].name, name) == 0)
      return (int)s;
  return -1;
}

static bool take_aim(struct nb_reader *reader, struct nb_aim *aim, bool force, bool normal) {
  aim->force = force;
  aim->by = nb_token_skip(reader, "by");
  if (!aim->by && !nb_token_skip(reader, "to"))
    return nb_expected(reader, NULL, "`to` or `by`"), false;
  const bool push = normal && force && !aim->by; /* spheres do not pull */
  return nb_take_number(reader, force ? NB_UNIT_FORCE : NB_UNIT_LENGTH, push ? NB_NOT_NEGATIVE : NB_ANY, &aim->value);
}

/* What a leg says, in any order, each once. */
static bool take_leg(struct nb_reader *reader, struct nb_stage *stage) {
  static const char *const words[] = {"overlap", "normal", "slip", "shear", "hold", "in", "follow"};
  enum { OVERLAP, NORMAL, SLIP, SHEAR, HOLD, IN, FOLLOW, WORDS };
  struct nb_leg *leg = &stage->leg;
  char path[NB_PATH_SIZE];
  bool normal_said = false, shear_said = false, steps_said = false;
  while (nb_token_peek(reader)) {
    int word = 0;
    while (word < WORDS && !nb_token_skip(reader, words[word]))
      word++;
    if (word == HOLD) {
      const bool normal = nb_token_is(reader, "normal");
      if (!normal && !nb_token_is(reader, "shear"))
        return nb_expected(reader, "overlap and slip stay where they are without a word", "`normal` or `shear`"), false;
    }
    const bool normal = word == OVERLAP || word == NORMAL || (word == HOLD && nb_token_is(reader, "normal"));
    bool *said = word == IN ? &steps_said : normal ? &normal_said : &shear_said;
    if (word == WORDS || (word == FOLLOW && (normal_said || shear_said || steps_said)))
      return nb_expected(reader, NULL,
                         "`overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or the end of the line"),
             false;
    if (*said) {
      reader->next--;
      return nb_expected(reader, NULL,
                         normal       ? "one of `overlap`, `normal` and `hold normal`"
                         : word == IN ? "`in N steps` once"
                                      : "one of `slip`, `shear` and `hold shear`"),
             false;
    }
    *said = true;
    struct nb_aim *aim = normal ? &leg->normal : &leg->shear;
    if (word == FOLLOW)
      return nb_file_named(reader, nb_take(reader, "the name of a file"), path) &&
             nb_follow_read(leg, path, reader->unitless, reader->mistakes);
    if (word == IN) {
      if (!nb_take_count(reader, 1, STEPS_MAX, &stage->cycles))
        return false;
      if (!nb_token_skip(reader, "step") && !nb_take_word(reader, "steps"))
        return false;
    } else if (word == HOLD) {
      reader->next++;
      aim->force = true;
    } else if (!take_aim(reader, aim, word == NORMAL || word == SHEAR, normal)) {
      return false;
    }
  }
  if (normal_said || shear_said)
    return true;
  return nb_expected(reader, NULL, "`overlap`, `normal`, `slip`, `shear`, `hold` or `follow FILE`"), false;
}

NB_APPLY(nb_apply_leg) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  struct nb_stage stage = {.record = 1, .cycles = STEPS_DEFAULT, .line = (int)reader->line};
  stage.leg.normal.by = stage.leg.shear.by = true;
  if (!scene->path)
    return;
  reading->here = NB_IN_LEG;
  if (!name)
    return;
  nb_stage_name(&stage, reading, name);
  const int same = find_leg(scene, stage.name);
  if (same >= 0)
    nb_token_mistake(reader, name, NULL, "there is a leg `%s` already, on line %d", stage.name,
                     scene->stages[same].line);
  else if (!reader->bad && take_leg(reader, &stage) && stage.leg.points)
    stage.cycles = stage.leg.point_count;
  if (!add_leg(scene, reader, stage))
    free(stage.leg.points);
}

/* ---- quantities ---- */

const struct nb_quantity_kind nb_bench_kinds[] = {
#define ROW(function, name, unit, asks, help) {name, NB_OF_BENCH, unit, asks, NULL, help},
    NB_BENCH_QUANTITIES(ROW)
#undef ROW
        {NULL, 0, NULL, 0, NULL, NULL}};

/* ---- the whole ---- */

void nb_path_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  static const char *const usual[] = {"step", "overlap", "slip", "normal", "shear"};
  enum { USUAL = sizeof usual / sizeof *usual };
  if (!reading->contact_line)
    nb_say_of_scene(reading, "`contact sphere R MATERIAL with sphere R MATERIAL` puts one there",
                    "expected a path with a `contact`, found none");
  if (scene->stage_count == 0 && !reading->follow)
    nb_say_of_scene(reading, "`leg NAME overlap to 1 um in 10 steps`", "expected a path with a `leg`, found none");
  if (reading->follow)
    nb_path_follow(reading);
  if (scene->column_count || reading->asked_count)
    return;
  scene->columns = calloc(USUAL, sizeof *scene->columns);
  if (!scene->columns)
    nb_no_memory(&reading->reader);
  for (size_t k = 0; k < USUAL && scene->columns; k++) {
    struct nb_column *column = &scene->columns[scene->column_count++];
    strcpy(column->name, usual[k]);
    nb_quantity_find(&column->quantity, scene, usual[k], NULL);
  }
}

/* ---- what quantities and snapshots ask of the laws ---- */

/* At the name of the column. */
static void say_of_law(struct nb_scene_reading *reading, const struct nb_asked *asked, const struct nb_law *law) {
  nb_mistake(reading->reader.mistakes, reading->reader.page, asked->line, asked->column, asked->length,
             "`nineball laws` tells what each law knows", "expected laws that know `%s`, `%s %s` does not", asked->name,
             law->kind, law->name);
}

void nb_path_laws_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_law *normal = nb_law_find("normal", scene->normal), *shear = nb_law_find("shear", scene->shear);
  for (size_t k = 0; k < reading->asked_count; k++) {
    const unsigned asks = scene->columns[k].quantity.kind->fields;
    if (asks & NB_ASKS_STORE && !normal->stored)
      say_of_law(reading, &reading->asked[k], normal);
    if ((asks & NB_ASKS_STORE && !shear->stored) || (asks & NB_ASKS_LOSS && !shear->loses) ||
        (asks & NB_ASKS_PIECES && !shear->pieces_of))
      say_of_law(reading, &reading->asked[k], shear);
  }
}
