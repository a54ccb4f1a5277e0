/* Gravity, uniform or towards a point, in the scene and in stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
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
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
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
  gravity->line = (int)reader->line;
}

/* clang-format off */
NB_STATEMENTS(gravity) = {
  {"gravity", NB_IN_SCENE | NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, uniform_fields, NULL, 0, false, apply_gravity,
   "Sets a uniform acceleration of all free particles; default none. In a stage it changes from this stage on.",
   "gravity   0 m/s2 -9.81 m/s2"},
  {"gravity centripetal", NB_IN_STAGE | NB_IN_RAMP, centripetal_fields, NULL, 1, false, apply_gravity,
   "Sets an acceleration of all free particles towards a point, from this stage on [R89 sec. 6.4.1]. It replaces `gravity`.",
   "  gravity centripetal 10 m/s2  about 40 mm 40 mm"},
  {0},
};
/* clang-format on */
