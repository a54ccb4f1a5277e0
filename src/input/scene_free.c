/* What a scene owns.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "scene.h"

void nb_stages_free(struct nb_scene *scene, size_t from) {
  for (size_t i = from; i < scene->stage_count; i++) {
    free(scene->stages[i].motions);
    free(scene->stages[i].changes);
    free(scene->stages[i].removals);
    free(scene->stages[i].conditions);
    free(scene->stages[i].leg.points);
  }
  scene->stage_count = from < scene->stage_count ? from : scene->stage_count;
}

void nb_scene_free(struct nb_scene *scene) {
  nb_stages_free(scene, 0);
  nb_start_free(&scene->start);
  for (size_t i = 0; i < scene->grading_count; i++)
    free(scene->gradings[i].sizes);
  free(scene->gradings);
  for (size_t i = 0; i < scene->packing_count; i++)
    free(scene->packings[i].path);
  free(scene->packings);
  free(scene->fills);
  free(scene->materials);
  free(scene->pair_rules);
  free(scene->bodies);
  free(scene->walls);
  free(scene->watches);
  free(scene->regions);
  free(scene->columns);
  free(scene->stages);
  free(scene->bindings);
  memset(scene, 0, sizeof *scene);
}
