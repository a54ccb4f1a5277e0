/* A box whose walls a stage strains.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "loading/box.h"

#include "scene.h"

bool nb_scene_lacks_box(const struct nb_scene *scene, struct nb_reader *reader) {
  if (nb_box_of(scene) >= 0)
    return false;
  nb_token_mistake(reader, &reader->tokens[0], "define it before the stages with `box X Y to X Y MATERIAL`",
                   "expected a scene with a box of walls, found none");
  return true;
}

NB_APPLY(nb_apply_box_strain) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  if (!stage || nb_scene_lacks_box(scene, reader))
    return;
  if (stage->box_line)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`box strain` is said twice: first on line %d", stage->box_line);
  nb_strain_of(&stage->box, reader, record->value);
  stage->box_line = (int)reader->line;
}

static void say(struct nb_scene_reading *reading, int line, const char *hint, const char *what) {
  nb_line_mistake(&reading->reader, line, hint, "%s", what);
}

/* Walls that follow the box do nothing else. */
void nb_boxes_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const int first = nb_box_of(scene);
  bool turned = false;
  for (size_t s = 0; s < scene->stage_count && first >= 0; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const int line = stage->box_line ? stage->box_line : stage->servo.box ? stage->servo.line : 0;
    bool moved = false;
    for (size_t m = 0; m < stage->motion_count; m++) {
      const bool mine = stage->motions[m].wall >= first && stage->motions[m].wall < first + 4;
      moved = moved || mine, turned = turned || (mine && stage->motions[m].spin != 0);
    }
    if (!line || s < scene->start.stages)
      continue;
    if (moved)
      say(reading, line, NULL, "expected a stage that moves the walls of the box in one way, found two");
    if (turned)
      say(reading, line, NULL, "expected a box whose walls do not turn");
  }
}
