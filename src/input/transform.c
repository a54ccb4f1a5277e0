/* `transform`: mirrors, rotates and translates the whole scene.
 *
 *   x' = S + Q M x        v' = Q M v        w' = w det M
 *
 *   x position, m     v velocity, m/s     w angular velocity (spin), rad/s
 *   M changes the sign of x or of y     Q rotates by the angle, counterclockwise     S translation, m
 *
 * Velocities are not translated, and mirroring changes the sign of an angular velocity. Rotations by multiples of 90
 * deg, from -360 deg to 360 deg, are exact: Q consists of 0, 1 and -1. A run of the rotated scene then has the same
 * bits, except for signs and the exchange of x and y.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/vec.h"
#include "statement.h"

enum { AT_MIRROR, AT_ANGLE, AT_X, AT_Y };
enum mirror { MIRROR_NONE, MIRROR_X, MIRROR_Y };

/* clang-format off */
static const struct nb_argument transform_fields[] = {
  CHOICE("mirror", "none|x|y", AT_MIRROR, "none", "`x` changes the sign of x, `y` that of y"),
  CLAUSE("rotate", "ANGLE", NB_UNIT_ANGLE, NB_ANY, AT_ANGLE, 1, "0", "Counterclockwise; multiples of 90 deg up to 360 deg are exact."),
  CLAUSE("translate", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, "0 0", "Displacement in x and y."),
  END
};
/* clang-format on */

/* The number of quarter turns in the angle, rad, from 0 to 3. *exact: the angle is a multiple of 90 deg from -360 to 360
 * deg. 0 for any other angle. */
static int quarters_of(double angle, bool *exact) {
  const double degree = NB_PI / 180;
  for (int n = -4; n <= 4; n++) {
    *exact = angle == 90 * n * degree;
    if (*exact)
      return (n + 4) % 4;
  }
  return 0;
}

NB_APPLY(apply_transform) {
  struct nb_scene_reading *reading = subject;
  const struct nb_value *value = record->value;
  const double angle = value[AT_ANGLE].number;
  const enum mirror mirror = value[AT_MIRROR].token ? (enum mirror)value[AT_MIRROR].number : MIRROR_NONE;
  static const double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  bool exact;
  const int quarters = quarters_of(angle, &exact);
  if (nb_given_twice(reader, reading->transform.line))
    return;
  reading->transform = (struct nb_transform){
      .flip_x = mirror == MIRROR_X ? -1 : 1,
      .flip_y = mirror == MIRROR_Y ? -1 : 1,
      .cosine = exact ? cosines[quarters] : cos(angle),
      .sine = exact ? sines[quarters] : sin(angle),
      .x = value[AT_X].number,
      .y = value[AT_Y].number,
      .line = (int)reader->line,
  };
}

/* Mirrors and rotates a vector; + 0.0 turns -0 into 0. */
static void rotate(struct nb_transform *to, double *x, double *y) {
  const double east = to->flip_x * *x, north = to->flip_y * *y;
  *x = to->cosine * east - to->sine * north + 0.0;
  *y = to->sine * east + to->cosine * north + 0.0;
  to->overflow = to->overflow || !isfinite(*x) || !isfinite(*y);
}

static void transform_point(struct nb_transform *to, double *x, double *y) {
  rotate(to, x, y);
  *x += to->x;
  *y += to->y;
  to->overflow = to->overflow || !isfinite(*x) || !isfinite(*y);
}

/* Transforms a strain rate, L' = Q M L (Q M)^T: first the columns, then the rows. */
static void transform_rate(struct nb_transform *to, struct nb_strain_rate *rate) {
  rotate(to, &rate->xx, &rate->yx), rotate(to, &rate->xy, &rate->yy);
  rotate(to, &rate->xx, &rate->xy), rotate(to, &rate->yx, &rate->yy);
}

static void transform_circle(struct nb_transform *to, struct nb_circle *circle) {
  if (circle->line)
    transform_point(to, &circle->x, &circle->y);
}

static void transform_boundary(struct nb_transform *to, struct nb_boundary *boundary) {
  struct nb_strain_rate stress = {boundary->sxx, boundary->sxy, boundary->sxy, boundary->syy, false};
  transform_rate(to, &stress);
  boundary->sxx = stress.xx, boundary->sxy = stress.xy, boundary->syy = stress.yy;
  transform_rate(to, &boundary->strain);
}

static void transform_gravity(struct nb_transform *to, struct nb_gravity *gravity) {
  rotate(to, &gravity->x, &gravity->y);
  transform_point(to, &gravity->about_x, &gravity->about_y);
}

/* Transforms an angular velocity: mirroring changes its sign. */
static void transform_spin(const struct nb_transform *to, double *spin) {
  *spin = to->flip_x * to->flip_y * *spin + 0.0;
}

static void transform_particle(struct nb_transform *to, struct nb_particle *particle) {
  transform_point(to, &particle->x, &particle->y);
  rotate(to, &particle->vx, &particle->vy);
  transform_spin(to, &particle->spin);
}

static void transform_wall(struct nb_transform *to, struct nb_wall *wall) {
  transform_point(to, &wall->x, &wall->y);
  rotate(to, &wall->ex, &wall->ey);
  rotate(to, &wall->inx, &wall->iny);
  rotate(to, &wall->vx, &wall->vy);
  transform_spin(to, &wall->spin);
  transform_spin(to, &wall->h0);
}

static void transform_cell(struct nb_transform *to, struct nb_scene_cell *cell) {
  if (!cell->line)
    return;
  transform_point(to, &cell->x, &cell->y);
  for (int side = 0; side < 2; side++)
    rotate(to, &cell->h[side], &cell->h[2 + side]);
}

static void transform_stage(struct nb_transform *to, struct nb_stage *stage) {
  transform_gravity(to, &stage->gravity);
  transform_circle(to, &stage->circle);
  transform_boundary(to, &stage->boundary);
  transform_rate(to, &stage->affine.strain), transform_rate(to, &stage->cell), transform_rate(to, &stage->box);
  rotate(to, &stage->servo.axis_x[0], &stage->servo.axis_x[1]); /* the target stresses refer to these axes */
  rotate(to, &stage->servo.axis_y[0], &stage->servo.axis_y[1]);
  for (size_t m = 0; m < stage->motion_count; m++) {
    rotate(to, &stage->motions[m].vx, &stage->motions[m].vy);
    transform_spin(to, &stage->motions[m].spin);
  }
}

bool nb_scene_transform(struct nb_scene *scene, struct nb_transform *to) {
  if (!to->line)
    return true;
  for (size_t i = 0; i < scene->particle_count; i++)
    transform_particle(to, &scene->particles[i]);
  for (size_t i = 0; i < scene->wall_count; i++)
    transform_wall(to, &scene->walls[i]);
  for (size_t i = 0; i < scene->region_count; i++) {
    transform_point(to, &scene->regions[i].x, &scene->regions[i].y);
    rotate(to, &scene->regions[i].ex, &scene->regions[i].ey);
  }
  transform_cell(to, &scene->cell);
  transform_gravity(to, &scene->gravity);
  transform_circle(to, &scene->circle);
  transform_point(to, &scene->origin_x, &scene->origin_y);
  for (size_t s = 0; s < scene->stage_count; s++)
    transform_stage(to, &scene->stages[s]);
  return !to->overflow;
}

/* clang-format off */
NB_STATEMENTS(transform) = {
  {"transform", NB_IN_SCENE, transform_fields, NULL, 0, false, apply_transform,
   "Transforms the whole scene after the last line of the page has been read: positions, velocities, walls, and all directions in stages, such as the components that a `servo` controls. The scene is first mirrored, then rotated about the origin, then translated. The physics stays the same. Quantities with a direction, in `record` and `until`, are not transformed: they are components in x and y.",
   "transform mirror none  rotate 0 deg  translate 0.5 m 0 m"},
  {0},
};
/* clang-format on */
