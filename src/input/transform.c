/* `transform`: the whole scene mirrored, rotated and translated: the same physics in another place.
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

#include "core/vec.h"
#include "statement.h"

enum { AT_MIRROR, AT_ANGLE, AT_X, AT_Y };
enum mirror { MIRROR_NONE, MIRROR_X, MIRROR_Y };

/* clang-format off */
static const struct nb_argument place_fields[] = {
  CHOICE("mirror", "none|x|y", AT_MIRROR, "none", "`none`, `x` or `y`"),
  CLAUSE("rotate", "ANGLE", NB_UNIT_ANGLE, NB_ANY, AT_ANGLE, 1, "0", "Counterclockwise; quarters of a turn are exact."),
  CLAUSE("translate", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, "0 0", "Displacement in x and y."),
  END
};
/* clang-format on */

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

NB_APPLY(apply_place) {
  struct nb_scene_reading *reading = subject;
  const struct nb_value *value = record->value;
  const double angle = value[AT_ANGLE].number;
  const enum mirror mirror = value[AT_MIRROR].token ? (enum mirror)value[AT_MIRROR].number : MIRROR_NONE;
  static const double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  bool exact;
  const int quarters = quarters_of(angle, &exact);
  if (nb_given_twice(reader, reading->place.line))
    return;
  reading->place = (struct nb_place){
      .flip_x = mirror == MIRROR_X ? -1 : 1,
      .flip_y = mirror == MIRROR_Y ? -1 : 1,
      .cosine = exact ? cosines[quarters] : cos(angle),
      .sine = exact ? sines[quarters] : sin(angle),
      .x = value[AT_X].number,
      .y = value[AT_Y].number,
      .line = (int)reader->line,
  };
}

/* + 0.0 makes the -0 of a product a plain 0. False: larger than a double can hold. */
static bool turn(const struct nb_place *to, double *x, double *y) {
  const double east = to->flip_x * *x, north = to->flip_y * *y;
  *x = to->cosine * east - to->sine * north + 0.0;
  *y = to->sine * east + to->cosine * north + 0.0;
  return isfinite(*x) && isfinite(*y);
}

static bool move(const struct nb_place *to, double *x, double *y) {
  turn(to, x, y);
  *x += to->x;
  *y += to->y;
  return isfinite(*x) && isfinite(*y);
}

/* L' = Q M L (Q M)^T: its columns are turned, then its rows. */
static bool turn_rate(const struct nb_place *to, struct nb_strain_rate *rate) {
  bool held = turn(to, &rate->xx, &rate->yx);
  held = turn(to, &rate->xy, &rate->yy) && held;
  held = turn(to, &rate->xx, &rate->xy) && held;
  return turn(to, &rate->yx, &rate->yy) && held;
}

static bool move_circle(const struct nb_place *to, struct nb_circle *circle) {
  return !circle->line || move(to, &circle->x, &circle->y);
}

static bool move_drives(const struct nb_place *to, struct nb_stage *stage) {
  struct nb_strain_rate *strains[] = {&stage->boundary.strain, &stage->affine.strain, &stage->cell, &stage->box};
  struct nb_boundary *boundary = &stage->boundary;
  struct nb_strain_rate stress = {boundary->sxx, boundary->sxy, boundary->sxy, boundary->syy, false};
  bool held = move_circle(to, &stage->circle) && turn_rate(to, &stress);
  boundary->sxx = stress.xx, boundary->sxy = stress.xy, boundary->syy = stress.yy;
  for (size_t k = 0; k < 4; k++)
    held = turn_rate(to, strains[k]) && held;
  return held;
}

/* The axes of its components are turned, so the components stay as the page has them. */
static bool turn_servo(const struct nb_place *to, struct nb_servo *servo) {
  return turn(to, &servo->axis_x[0], &servo->axis_x[1]) && turn(to, &servo->axis_y[0], &servo->axis_y[1]);
}

static bool turn_gravity(const struct nb_place *to, struct nb_gravity *gravity) {
  return turn(to, &gravity->x, &gravity->y) && move(to, &gravity->about_x, &gravity->about_y);
}

/* -1: what turned left turns right. */
static void turn_spin(const struct nb_place *to, double *spin) { *spin = to->flip_x * to->flip_y * *spin + 0.0; }

static bool move_particle(const struct nb_place *to, struct nb_particle *particle) {
  turn_spin(to, &particle->spin);
  const bool held = move(to, &particle->x, &particle->y);
  return turn(to, &particle->vx, &particle->vy) && held;
}

static bool move_wall(const struct nb_place *to, struct nb_wall *wall) {
  turn_spin(to, &wall->spin);
  turn_spin(to, &wall->h0);
  bool held = move(to, &wall->x, &wall->y);
  held = turn(to, &wall->ex, &wall->ey) && held;
  held = turn(to, &wall->inx, &wall->iny) && held;
  return turn(to, &wall->vx, &wall->vy) && held;
}

static bool move_cell(const struct nb_place *to, struct nb_scene_cell *cell) {
  bool held = !cell->line || move(to, &cell->x, &cell->y);
  for (int side = 0; side < 2 && cell->line; side++)
    held = turn(to, &cell->h[side], &cell->h[2 + side]) && held;
  return held;
}

static bool move_stage(const struct nb_place *to, struct nb_stage *stage) {
  bool held = turn_gravity(to, &stage->gravity);
  held = move_drives(to, stage) && held;
  held = turn_servo(to, &stage->servo) && held;
  for (size_t m = 0; m < stage->motion_count; m++) {
    held = turn(to, &stage->motions[m].vx, &stage->motions[m].vy) && held;
    turn_spin(to, &stage->motions[m].spin);
  }
  return held;
}

bool nb_scene_place(struct nb_scene *scene, const struct nb_place *to) {
  if (!to->line)
    return true;
  bool held = true;
  for (size_t i = 0; i < scene->particle_count; i++)
    held = move_particle(to, &scene->particles[i]) && held;
  for (size_t i = 0; i < scene->wall_count; i++)
    held = move_wall(to, &scene->walls[i]) && held;
  for (size_t i = 0; i < scene->region_count; i++) {
    held = move(to, &scene->regions[i].x, &scene->regions[i].y) && held;
    held = turn(to, &scene->regions[i].ex, &scene->regions[i].ey) && held;
  }
  held = move_cell(to, &scene->cell) && held;
  held = turn_gravity(to, &scene->gravity) && held;
  held = move_circle(to, &scene->circle) && move(to, &scene->origin_x, &scene->origin_y) && held;
  for (size_t s = 0; s < scene->stage_count; s++)
    held = move_stage(to, &scene->stages[s]) && held;
  return held;
}

/* clang-format off */
NB_STATEMENTS(transform) = {
  {"transform", NB_IN_SCENE, place_fields, NULL, 0, false, apply_place,
   "Transforms the whole scene, as it is at the end of the page: positions, velocities, walls and what they do in stages. "
   "First it is mirrored, then rotated about the origin, then translated. `mirror x` changes the sign of x, `mirror y` that of y. All that the page says with a direction turns with it, "
   "the components that a `servo` holds too. The physics stays the same; quantities with a direction, recorded or waited for by `until`, "
   "do not: they are those of the plane.",
   "transform mirror none  rotate 0 deg  translate 0.5 m 0 m"},
  {0},
};
/* clang-format on */
