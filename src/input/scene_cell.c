/* The periodic cell, how stages strain it, and waves in it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "scene.h"

NB_APPLY(nb_apply_cell) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const double x = value[AT_X].number, y = value[AT_Y].number, x1 = value[AT_X1].number, y1 = value[AT_Y1].number;
  if (reader->bad)
    return;
  if (scene->cell.line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`cell` is said twice: first on line %d", scene->cell.line);
    return;
  }
  if (!(x1 > x && y1 > y && isfinite(x1 - x) && isfinite(y1 - y)))
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected the south-west corner and then the north-east one, found them the other way");
  scene->cell = (struct nb_scene_cell){
      .x = x + (x1 - x) / 2, .y = y + (y1 - y) / 2, .h = {x1 - x, 0, 0, y1 - y}, .line = (int)reader->line};
}

bool nb_scene_lacks_cell(const struct nb_scene_reading *reading, struct nb_reader *reader) {
  if (reading->scene->cell.line || reading->cell_unsure)
    return false;
  nb_token_mistake(reader, &reader->tokens[0], "define it before the stages with `cell X Y to X Y`",
                   "expected a scene with a cell, found none");
  return true;
}

NB_APPLY(nb_apply_cell_strain) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  if (!stage || nb_scene_lacks_cell(reading, reader) || reader->bad)
    return;
  if (!nb_strain_of(&stage->cell, reader, record->value))
    return;
  stage->cell_line = (int)reader->line;
}

NB_APPLY(nb_apply_wave) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_value *value = record->value;
  if (nb_scene_lacks_cell(reading, reader) || reader->bad)
    return;
  double nx, ny;
  if (!nb_take_word(reader, "periods") || !nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &nx) ||
      !nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &ny))
    return;
  const double most = 1e6; /* the sine of a number without digits behind the point is none */
  if (nx != round(nx) || ny != round(ny) || fabs(nx) > most || fabs(ny) > most) {
    nb_token_mistake(reader, &reader->tokens[reader->next - 1], NULL,
                     "expected whole numbers of periods, at most 1e6, or the wave would not fit the cell");
    return;
  }
  const double two_pi = 6.28318530717958647692;
  for (size_t i = 0; i < scene->body_count && !reading->cell_unsure; i++) {
    struct nb_body *body = &scene->bodies[i];
    const double wave = sin(two_pi * (nx * (body->x - scene->cell.x) / scene->cell.h[0] +
                                      ny * (body->y - scene->cell.y) / scene->cell.h[3]));
    if (body->fixed)
      continue;
    body->vx += wave * value[AT_VX].number;
    body->vy += wave * value[AT_VY].number;
  }
}

/* A mistake of the cell as a whole, at its line. */
static void say(struct nb_scene_reading *reading, const char *hint, const char *what) {
  nb_line_mistake(&reading->reader, reading->scene->cell.line, hint, "%s", what);
}

void nb_cell_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  double largest = 0, sum = 0;
  char what[2 * NB_NAME_SIZE];
  if (!scene->cell.line || reading->cell_unsure)
    return;
  if (scene->wall_count > 0)
    say(reading, "what a wall would be in every copy of the cell is not worked out",
        "expected a cell or walls, found both");
  for (size_t i = 0; i < scene->body_count; i++)
    largest = fmax(largest, scene->bodies[i].radius), sum += scene->bodies[i].radius;
  const double skin = scene->skin > 0 ? scene->skin : 0.1 * sum / (double)scene->body_count;
  const double least = 2 * (2 * largest + skin), width = fmin(scene->cell.h[0], scene->cell.h[3]);
  const char *unit = reading->reader.unitless ? "" : " m";
  if (reading->bodies_unsure || scene->body_count < 2 || width >= least)
    return;
  snprintf(what, sizeof what, "expected a cell twice as wide as the largest diameter and the skin, %g%s, found %g%s",
           least, unit, width, unit);
  say(reading, "in a narrower one a body would meet another in two places", what);
}
