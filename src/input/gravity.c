/* Gravity, uniform or towards a point, in the scene and in stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/model.h"
#include "statement.h"

enum { AT_G, AT_GY, AT_X, AT_Y };

/* clang-format off */
static const struct nb_argument uniform_fields[] = {
  VALUE("GX", NB_UNIT_ACCELERATION, NB_ANY, AT_G, "Acceleration in x."),
  VALUE("GY", NB_UNIT_ACCELERATION, NB_ANY, AT_GY, "Acceleration in y."),
  END
};
static const struct nb_argument centripetal_fields[] = {
  VALUE("G", NB_UNIT_ACCELERATION, NB_ANY, AT_G, "Acceleration towards the point, the same at any distance."),
  CLAUSE("about", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, NULL, "The point."),
  END
};
/* clang-format on */

/* variant 1: centripetal */
NB_APPLY(apply_gravity) {
  const struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  struct nb_gravity *gravity = stage ? &stage->gravity : &scene->gravity;
  const struct nb_value *value = record->value;
  if (nb_given_twice(reader, gravity->line))
    return;
  if (record->keyword->variant)
    *gravity = (struct nb_gravity){
        .central = value[AT_G].number, .about_x = value[AT_X].number, .about_y = value[AT_Y].number};
  else
    *gravity = (struct nb_gravity){.x = value[AT_G].number, .y = value[AT_GY].number};
  gravity->ramp = reading->ramping, gravity->line = (int)reader->line;
}

/* The gravity at the start of the scene; NULL: none, or gravity that changes later. */
static const struct nb_gravity *only_gravity(const struct nb_scene *scene) {
  const struct nb_gravity *found = scene->gravity.line ? &scene->gravity : NULL;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_gravity *const it = &scene->stages[s].gravity;
    if (it->line && (s > 0 || it->ramp))
      return NULL;
    found = it->line ? it : found;
  }
  return found;
}

/* True if no stage moves walls or particles. */
static bool stages_stand_still(const struct nb_scene *scene) {
  bool still = true;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *const stage = &scene->stages[s];
    still = still && stage->motion_count == 0 && !stage->box_line && !stage->servo.line && !stage->circle.line &&
            !stage->affine.line && !stage->reverse_velocities;
  }
  return still;
}

/* True if nothing but gravity and contacts moves the particles, and no particle is placed during the run. */
static bool stands_still(const struct nb_scene *scene) {
  bool still = !scene->cell.line && !scene->circle.line && scene->fill_count == 0;
  for (size_t w = 0; w < scene->wall_count; w++)
    still = still && scene->walls[w].vx == 0 && scene->walls[w].vy == 0 && scene->walls[w].spin == 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    still = still && scene->particles[k].vx == 0 && scene->particles[k].vy == 0;
  return still && stages_stand_still(scene);
}

void nb_fall_check(struct nb_scene *scene) {
  const struct nb_gravity *const gravity = only_gravity(scene);
  if (!gravity || gravity->y <= 0 || !stands_still(scene))
    return;
  const double g = hypot(gravity->x, gravity->y), x = gravity->x / g, y = gravity->y / g;
  double lowest = -INFINITY, highest = INFINITY; /* largest place of a wall or fixed particle along g; smallest place of
                                                  * a free particle, m */
  for (size_t w = 0; w < scene->wall_count; w++) {
    const struct nb_wall *const wall = &scene->walls[w];
    const double px = wall->x - wall->h0 * wall->ey, py = wall->y + wall->h0 * wall->ex;
    const double along = wall->ex * x + wall->ey * y;
    lowest = fmax(lowest, px * x + py * y + fmax(wall->h1 * along, wall->h2 * along));
  }
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *const particle = &scene->particles[k];
    const double place = particle->x * x + particle->y * y;
    if (particle->fixed)
      lowest = fmax(lowest, place + particle->radius);
    else
      highest = fmin(highest, place);
  }
  if (lowest > -INFINITY && highest < INFINITY && highest > lowest)
    nb_warn(
        &scene->warnings, gravity->line,
        "gravity moves all free particles upwards, and away from all walls and fixed particles; y points up: gravity "
        "downwards is `gravity 0%s %g%s`",
        nb_unit(scene, " m/s2"), -g, nb_unit(scene, " m/s2"));
}

/* clang-format off */
NB_STATEMENTS(gravity) = {
  {"gravity", NB_IN_SCENE | NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, uniform_fields, NULL, 0, false, apply_gravity,
   "Sets a uniform acceleration of all free particles; default none. In a stage it changes from this stage on.",
   "gravity   0 m/s2 -9.81 m/s2"},
  {"gravity centripetal", NB_IN_STAGE | NB_IN_RAMP, centripetal_fields, NULL, 1, false, apply_gravity,
   "Sets an acceleration of all free particles towards a point, from this stage on [R89 sec. 6.4.1]. It replaces `gravity`. Before it acts towards another point, a stage must set `gravity` to zero.",
   "  gravity centripetal 10 m/s2  about 40 mm 40 mm"},
  {0},
};
/* clang-format on */
