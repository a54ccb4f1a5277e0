/* What makes an assembly follow a stress: `servo`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

/* `on REGION|boundary|cell|box`: the components of the stress that is looked at. */
static bool take_place(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "xy", "yx", "yy"};
  const struct nb_token *place =
      nb_take_word(reader, "on") ? nb_take(reader, "a region, `boundary`, `cell` or `box`") : NULL;
  if (!place || place->hollow)
    return false;
  for (int k = 0; k < 4; k++) {
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%.63s.stress.%s", place->text, parts[k]);
    if (nb_quantity_find(&servo->quantity[k], reading->scene, name, NULL))
      continue;
    if (!(reading->reader.unsure & NB_UNSURE_WATCHES))
      nb_not_known(reader, place, NULL, "a region, `boundary`, `cell` or `box`");
    return false;
  }
  return true;
}

/* `by boundary {continuum}|cell|box at most RATE {every N cycles}` */
static bool take_means(struct nb_reader *reader, struct nb_servo *servo) {
  const struct nb_token *by = nb_take_word(reader, "by") ? nb_take(reader, "`boundary`, `cell` or `box`") : NULL;
  if (!by || by->hollow)
    return false;
  servo->cell = strcmp(by->text, "cell") == 0, servo->box = strcmp(by->text, "box") == 0;
  const bool boundary = strcmp(by->text, "boundary") == 0;
  if (!servo->cell && !servo->box && !boundary) {
    nb_not_known(reader, by, NULL, "`boundary`, `cell` or `box`");
    return false;
  }
  servo->continuum = boundary && nb_token_skip(reader, "continuum");
  if (!nb_take_word(reader, "at") || !nb_take_word(reader, "most") ||
      !nb_take_number(reader, NB_UNIT_STRAIN_RATE, NB_POSITIVE, &servo->most))
    return false;
  servo->per_cycle = strcmp(reader->tokens[reader->next - 1].text, NB_PER_CYCLE) == 0;
  if (!nb_token_skip(reader, "every"))
    return true;
  return nb_take_count(reader, 1, 1000000, &servo->every) &&
         (nb_token_skip(reader, "cycle") || nb_take_word(reader, "cycles"));
}

NB_APPLY(nb_apply_servo) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  const struct nb_value *value = record->value;
  const int variant = record->keyword->variant;
  struct nb_servo servo = {
      .east = {1, 0}, .north = {0, 1}, .every = 10, .mean = variant == 1, .line = (int)reader->line};
  static const int slots[] = {AT_X, AT_Y, AT_SHEAR};
  for (int k = 0; k < 3; k++) {
    servo.held[k] = variant < 2 || value[slots[k]].token;
    servo.stress[k] = variant == 2 ? value[slots[k]].number : k < 2 ? value[AT_SPEED].number : 0;
  }
  if (!stage || !take_place(reading, reader, &servo) || !take_means(reader, &servo))
    return;
  servo.held[2] = servo.held[2] && !(servo.box && variant == 0); /* walls do not turn */
  if (!servo.held[0] && !servo.held[1] && !servo.held[2])
    nb_token_mistake(reader, &reader->tokens[1], NULL, "expected `xx`, `yy` or `xy`, or several of them, found none");
  else if (stage->servo.line)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", reader->tokens[0].text,
                     stage->servo.line);
  else if (servo.cell)
    nb_scene_lacks_cell(reading, reader);
  else if (servo.box && variant == 2 && servo.held[2])
    nb_token_mistake(reader, value[AT_SHEAR].token, NULL, "expected `xx` or `yy` of a box: its walls do not turn");
  else if (servo.box)
    nb_scene_lacks_box(reading->scene, reader);
  else if (!nb_scene_bounded(reading->scene))
    nb_token_mistake(reader, &reader->tokens[0], "begin one with `boundary circle X Y radius R`",
                     "expected a scene with a boundary, found none");
  stage->servo = servo;
}
