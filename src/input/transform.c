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

/* Mirrors and rotates a vector; + 0.0 turns -0 into 0. False if the result is not finite. */
static bool rotate(const struct nb_transform *to, double *x, double *y) {
  const double east = to->flip_x * *x, north = to->flip_y * *y;
  *x = to->cosine * east - to->sine * north + 0.0;
  *y = to->sine * east + to->cosine * north + 0.0;
  return isfinite(*x) && isfinite(*y);
}

static bool transform_point(const struct nb_transform *to, double *x, double *y) {
  rotate(to, x, y);
  *x += to->x;
  *y += to->y;
  return isfinite(*x) && isfinite(*y);
}

/* Transforms a strain rate, L' = Q M L (Q M)^T: first the columns, then the rows. A component that is not finite after
 * the columns is not finite after the rows either, so only the rows are tested. */
static bool transform_rate(const struct nb_transform *to, struct nb_strain_rate *rate) {
  rotate(to, &rate->xx, &rate->yx), rotate(to, &rate->xy, &rate->yy);
  const bool finite = rotate(to, &rate->xx, &rate->xy);
  return rotate(to, &rate->yx, &rate->yy) && finite;
}

static bool transform_circle(const struct nb_transform *to, struct nb_circle *circle) {
  return !circle->line || transform_point(to, &circle->x, &circle->y);
}

static bool transform_boundary(const struct nb_transform *to, struct nb_stage *stage) {
  struct nb_strain_rate *strains[] = {&stage->boundary.strain, &stage->affine.strain, &stage->cell, &stage->box};
  struct nb_boundary *boundary = &stage->boundary;
  struct nb_strain_rate stress = {boundary->sxx, boundary->sxy, boundary->sxy, boundary->syy, false};
  bool finite = transform_circle(to, &stage->circle) && transform_rate(to, &stress);
  boundary->sxx = stress.xx, boundary->sxy = stress.xy, boundary->syy = stress.yy;
  for (size_t k = 0; k < 4; k++)
    finite = transform_rate(to, strains[k]) && finite;
  return finite;
}

/* Rotates the axes of the controlled components; the target stresses stay. */
static bool transform_servo(const struct nb_transform *to, struct nb_servo *servo) {
  return rotate(to, &servo->axis_x[0], &servo->axis_x[1]) && rotate(to, &servo->axis_y[0], &servo->axis_y[1]);
}

static bool transform_gravity(const struct nb_transform *to, struct nb_gravity *gravity) {
  return rotate(to, &gravity->x, &gravity->y) && transform_point(to, &gravity->about_x, &gravity->about_y);
}

/* Transforms an angular velocity: mirroring changes its sign. */
static void transform_spin(const struct nb_transform *to, double *spin) {
  *spin = to->flip_x * to->flip_y * *spin + 0.0;
}

static bool transform_particle(const struct nb_transform *to, struct nb_particle *particle) {
  transform_spin(to, &particle->spin);
  const bool finite = transform_point(to, &particle->x, &particle->y);
  return rotate(to, &particle->vx, &particle->vy) && finite;
}

static bool transform_wall(const struct nb_transform *to, struct nb_wall *wall) {
  transform_spin(to, &wall->spin);
  transform_spin(to, &wall->h0);
  bool finite = transform_point(to, &wall->x, &wall->y);
  finite = rotate(to, &wall->ex, &wall->ey) && finite;
  finite = rotate(to, &wall->inx, &wall->iny) && finite;
  return rotate(to, &wall->vx, &wall->vy) && finite;
}

static bool transform_cell(const struct nb_transform *to, struct nb_scene_cell *cell) {
  bool finite = !cell->line || transform_point(to, &cell->x, &cell->y);
  for (int side = 0; side < 2 && cell->line; side++)
    finite = rotate(to, &cell->h[side], &cell->h[2 + side]) && finite;
  return finite;
}

static bool transform_stage(const struct nb_transform *to, struct nb_stage *stage) {
  bool finite = transform_gravity(to, &stage->gravity);
  finite = transform_boundary(to, stage) && finite;
  finite = transform_servo(to, &stage->servo) && finite;
  for (size_t m = 0; m < stage->motion_count; m++) {
    finite = rotate(to, &stage->motions[m].vx, &stage->motions[m].vy) && finite;
    transform_spin(to, &stage->motions[m].spin);
  }
  return finite;
}

bool nb_scene_transform(struct nb_scene *scene, const struct nb_transform *to) {
  if (!to->line)
    return true;
  bool finite = true;
  for (size_t i = 0; i < scene->particle_count; i++)
    finite = transform_particle(to, &scene->particles[i]) && finite;
  for (size_t i = 0; i < scene->wall_count; i++)
    finite = transform_wall(to, &scene->walls[i]) && finite;
  for (size_t i = 0; i < scene->region_count; i++) {
    finite = transform_point(to, &scene->regions[i].x, &scene->regions[i].y) && finite;
    finite = rotate(to, &scene->regions[i].ex, &scene->regions[i].ey) && finite;
  }
  finite = transform_cell(to, &scene->cell) && finite;
  finite = transform_gravity(to, &scene->gravity) && finite;
  finite = transform_circle(to, &scene->circle) && transform_point(to, &scene->origin_x, &scene->origin_y) && finite;
  for (size_t s = 0; s < scene->stage_count; s++)
    finite = transform_stage(to, &scene->stages[s]) && finite;
  return finite;
}

/* clang-format off */
NB_STATEMENTS(transform) = {
  {"transform", NB_IN_SCENE, transform_fields, NULL, 0, false, apply_transform,
   "Transforms the whole scene after the last line of the page has been read: positions, velocities, walls, and all directions in stages, such as the components that a `servo` controls. The scene is first mirrored, then rotated about the origin, then translated. The physics stays the same. Quantities with a direction, in `record` and `until`, are not transformed: they are components in x and y.",
   "transform mirror none  rotate 0 deg  translate 0.5 m 0 m"},
  {0},
};
/* clang-format on */
