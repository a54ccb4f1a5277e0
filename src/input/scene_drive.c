/* What moves an assembly from outside: its boundary, what carries it along, rotation.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

static bool said_twice(struct nb_reader *reader, int line) {
  if (line)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", reader->tokens[0].text,
                     line);
  return line != 0;
}

/* Before the first stage, or in one. */
NB_APPLY(nb_apply_circle) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  const struct nb_value *value = record->value;
  struct nb_circle *circle = stage ? &stage->circle : &scene->circle;
  if (!said_twice(reader, circle->line))
    *circle = (struct nb_circle){value[AT_X].number, value[AT_Y].number, value[AT_RADIUS].number, (int)reader->line};
}

/* Whether its unit is `per cycle`. */
static bool per_cycle(const struct nb_reader *reader, const struct nb_value *value) {
  const struct nb_token *unit = value->token ? value->token + 1 : NULL;
  return unit && unit < reader->tokens + reader->count && strcmp(unit->text, NB_PER_CYCLE) == 0;
}

bool nb_strain_of(struct nb_strain_rate *strain, struct nb_reader *reader, const struct nb_value value[]) {
  static const int slots[] = {AT_X, AT_Y, AT_SHEAR, AT_C12, AT_C21};
  const bool shear = value[AT_SHEAR].token;
  *strain = (struct nb_strain_rate){.xx = value[AT_X].number,
                                    .xy = value[shear ? AT_SHEAR : AT_C12].number,
                                    .yx = value[shear ? AT_SHEAR : AT_C21].number,
                                    .yy = value[AT_Y].number,
                                    .per_cycle = per_cycle(reader, &value[AT_X])};
  if (shear && (value[AT_C12].token || value[AT_C21].token)) {
    nb_token_mistake(reader, value[AT_SHEAR].token, NULL, "expected `shear`, or `c12` and `c21`, found both");
    return false;
  }
  for (size_t k = 1; k < sizeof slots / sizeof *slots; k++)
    if (value[slots[k]].token && per_cycle(reader, &value[slots[k]]) != strain->per_cycle) {
      nb_token_mistake(reader, value[slots[k]].token, NULL,
                       "expected all of a strain rate in the same way, `per cycle` or by time");
      return false;
    }
  return true;
}

/* Whether the stage that is being read has a boundary by now. */
bool nb_scene_bounded(const struct nb_scene *scene) {
  bool begun = scene->circle.line > 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    begun = begun || scene->stages[s].circle.line > 0;
    if (scene->stages[s].boundary.line && scene->stages[s].boundary.control == NB_CONTROL_NONE)
      begun = false;
  }
  return begun;
}

NB_APPLY(nb_apply_boundary) {
  const enum nb_control controls[] = {NB_CONTROL_STRAIN, NB_CONTROL_STRESS, NB_CONTROL_STRAIN, NB_CONTROL_NONE};
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  const struct nb_value *value = record->value;
  struct nb_boundary boundary = {.control = controls[record->keyword->variant], .line = (int)reader->line};
  if (record->keyword->variant == 0)
    nb_strain_of(&boundary.strain, reader, value);
  if (record->keyword->variant == 1)
    boundary.sxx = value[AT_X].number, boundary.syy = value[AT_Y].number, boundary.sxy = value[AT_SHEAR].number;
  if (!stage || said_twice(reader, stage->boundary.line))
    return;
  if (!nb_scene_bounded(scene))
    nb_token_mistake(reader, &reader->tokens[0], "begin one with `boundary circle X Y radius R`",
                     "expected a scene with a boundary, found none");
  stage->boundary = boundary;
}

NB_APPLY(nb_apply_continuum) {
  struct nb_stage *stage = nb_stage_now(((struct nb_scene_reading *)subject)->scene);
  struct nb_continuum continuum = {.line = (int)reader->line};
  if (record->keyword->variant == 0)
    nb_strain_of(&continuum.strain, reader, record->value);
  continuum.literal = record->value[AT_LITERAL].token != NULL;
  if (continuum.literal && record->value[AT_APART].token)
    nb_token_mistake(reader, record->value[AT_LITERAL].token, NULL, "expected `apart` or `literal`, not both");
  if (stage && !said_twice(reader, stage->continuum.line))
    stage->continuum = continuum;
}

NB_APPLY(nb_apply_rotation) {
  struct nb_stage *stage = nb_stage_now(((struct nb_scene_reading *)subject)->scene);
  if (!stage || said_twice(reader, stage->rotation_line))
    return;
  stage->rotation = record->keyword->variant ? NB_ROTATION_OFF : NB_ROTATION_ON;
  stage->rotation_line = (int)reader->line;
}

/* What is carried along comes a step later to where it is carried: that has no way back. A cell carries its bodies itself. */
void nb_drives_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  int first = scene->circle.line;
  for (size_t s = 0; s < scene->stage_count && !first; s++)
    first = scene->stages[s].circle.line ? scene->stages[s].circle.line : scene->stages[s].continuum.line;
  if (scene->cell.line && first) {
    nb_line_mistake(&reading->reader, first, "a cell has no boundary: say `cell strain`",
                    "expected a scene without a cell, found one on line %d", scene->cell.line);
  }
  int line = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const struct nb_strain_rate *rate = &stage->boundary.strain;
    const bool strained = rate->xx != 0 || rate->xy != 0 || rate->yx != 0 || rate->yy != 0;
    line = line ? line : strained ? stage->boundary.line : stage->continuum.line;
    line = line ? line : stage->box_line ? stage->box_line : stage->servo.box ? stage->servo.line : 0;
    if (!stage->reverse || !line)
      continue;
    nb_line_mistake(&reading->reader, stage->line, NULL,
                    "expected a stage without `reverse`: what line %d carries along does not go back", line);
  }
}
