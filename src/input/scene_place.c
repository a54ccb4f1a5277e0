/* The whole scene mirrored, turned and shifted: the same physics in another place.
 *
 *   x' = S + Q M x        v' = Q M v        w' = w det M
 *
 *   M  changes the sign of x or of y     Q  turns by the angle, counterclockwise     S  shift, m
 *
 * Points are also shifted, directions are not, and a spin turns the other way in a mirror. Quarters of a turn are
 * exact: then Q holds nothing but 0, 1 and -1, and no bit of a run may differ but signs and the places of x and y.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/vec.h"
#include "scene.h"

/* Quarters as they come out of `90 deg`, `180 deg` ..., and as the nearest double to their radians. */
static int quarters_of(double angle, bool *exact) {
  const double degree = NB_PI / 180;
  for (int n = -4; n <= 4; n++) {
    *exact = angle == 90 * n * degree || angle == n * (90 * degree);
    if (*exact)
      return (n + 4) % 4;
  }
  return 0;
}

NB_APPLY(nb_apply_place) {
  struct nb_scene_reading *reading = subject;
  const struct nb_value *value = record->value;
  const struct nb_token *mirror = value[AT_NAME].token;
  const double angle = value[AT_ANGLE].number;
  struct nb_place *place = &reading->place;
  bool flip_x = mirror && strcmp(mirror->text, "x") == 0, flip_y = mirror && strcmp(mirror->text, "y") == 0, exact;
  if (mirror && !flip_x && !flip_y && strcmp(mirror->text, "none") != 0) {
    nb_not_known(reader, mirror, NULL, "`none`, `x` or `y`");
    return;
  }
  if (place->line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", reader->tokens[0].text,
                     place->line);
    return;
  }
  static const double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  const int quarters = quarters_of(angle, &exact);
  *place = (struct nb_place){
      .flip_x = flip_x ? -1 : 1,
      .flip_y = flip_y ? -1 : 1,
      .cosine = exact ? cosines[quarters] : cos(angle),
      .sine = exact ? sines[quarters] : sin(angle),
      .x = value[AT_X].number,
      .y = value[AT_Y].number,
      .line = (int)reader->line,
  };
}

/* + 0.0 makes the -0 of a product a plain 0. False: larger than a double can hold. */
static bool turn(const struct nb_place *place, double *x, double *y) {
  const double east = place->flip_x * *x, north = place->flip_y * *y;
  *x = place->cosine * east - place->sine * north + 0.0;
  *y = place->sine * east + place->cosine * north + 0.0;
  return isfinite(*x) && isfinite(*y);
}

static bool move(const struct nb_place *place, double *x, double *y) {
  turn(place, x, y);
  *x += place->x;
  *y += place->y;
  return isfinite(*x) && isfinite(*y);
}

/* L' = Q M L (Q M)^T: its columns are turned, then its rows. */
static bool turn_rate(const struct nb_place *place, struct nb_strain_rate *rate) {
  bool held = turn(place, &rate->xx, &rate->yx);
  held = turn(place, &rate->xy, &rate->yy) && held;
  held = turn(place, &rate->xx, &rate->xy) && held;
  return turn(place, &rate->yx, &rate->yy) && held;
}

static bool move_circle(const struct nb_place *place, struct nb_circle *circle) {
  return !circle->line || move(place, &circle->x, &circle->y);
}

static bool move_drives(const struct nb_place *place, struct nb_stage *stage) {
  struct nb_strain_rate *strains[] = {&stage->boundary.strain, &stage->continuum.strain, &stage->cell, &stage->box};
  struct nb_boundary *boundary = &stage->boundary;
  struct nb_strain_rate stress = {boundary->sxx, boundary->sxy, boundary->sxy, boundary->syy, false};
  bool held = move_circle(place, &stage->circle) && turn_rate(place, &stress);
  boundary->sxx = stress.xx, boundary->sxy = stress.xy, boundary->syy = stress.yy;
  for (size_t k = 0; k < 4; k++)
    held = turn_rate(place, strains[k]) && held;
  return held;
}

/* The axes of its components are turned, so the components stay as the page has them. */
static bool turn_servo(const struct nb_place *place, struct nb_servo *servo) {
  return turn(place, &servo->east[0], &servo->east[1]) && turn(place, &servo->north[0], &servo->north[1]);
}

static bool turn_gravity(const struct nb_place *place, struct nb_gravity *gravity) {
  return turn(place, &gravity->x, &gravity->y) && move(place, &gravity->about_x, &gravity->about_y);
}

bool nb_scene_place(struct nb_scene *scene, const struct nb_place *place) {
  if (!place->line)
    return true;
  bool held = true;
  const double hand = place->flip_x * place->flip_y; /* -1: what turned left turns right */
  for (size_t i = 0; i < scene->body_count; i++) {
    struct nb_body *body = &scene->bodies[i];
    held = move(place, &body->x, &body->y) && held;
    held = turn(place, &body->vx, &body->vy) && held;
    body->spin = hand * body->spin + 0.0;
  }
  for (size_t i = 0; i < scene->wall_count; i++) {
    struct nb_wall *wall = &scene->walls[i];
    held = move(place, &wall->x, &wall->y) && held;
    held = turn(place, &wall->ex, &wall->ey) && held;
    held = turn(place, &wall->inx, &wall->iny) && held;
    held = turn(place, &wall->vx, &wall->vy) && held;
    wall->spin = hand * wall->spin + 0.0;
    wall->h0 = hand * wall->h0 + 0.0;
  }
  for (size_t i = 0; i < scene->region_count; i++) {
    struct nb_region *region = &scene->regions[i];
    held = move(place, &region->x, &region->y) && held;
    held = turn(place, &region->ex, &region->ey) && held;
  }
  if (scene->cell.line) {
    held = move(place, &scene->cell.x, &scene->cell.y) && held;
    for (int side = 0; side < 2; side++)
      held = turn(place, &scene->cell.h[side], &scene->cell.h[2 + side]) && held;
  }
  held = turn_gravity(place, &scene->gravity) && held;
  held = move_circle(place, &scene->circle) && move(place, &scene->origin_x, &scene->origin_y) && held;
  for (size_t s = 0; s < scene->stage_count; s++) {
    held = turn_gravity(place, &scene->stages[s].gravity) && held;
    held = move_drives(place, &scene->stages[s]) && held;
    held = turn_servo(place, &scene->stages[s].servo) && held;
  }
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t m = 0; m < scene->stages[s].motion_count; m++) {
      struct nb_wall_motion *motion = &scene->stages[s].motions[m];
      held = turn(place, &motion->vx, &motion->vy) && held;
      motion->spin = hand * motion->spin + 0.0;
    }
  return held;
}
