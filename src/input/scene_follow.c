/* A path from a file of columns: `approach` (or `overlap`, from a table of our own) and `slip`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "columns.h"
#include "scene.h"

bool nb_follow_read(struct nb_leg *leg, const char *path, bool unitless, struct nb_mistakes *mistakes) {
  static const struct nb_wanted wanted[] = {{"approach", "overlap", false}, {"slip", NULL, false}};
  double *lengths;
  size_t rows;
  const bool whole = nb_columns_read(&lengths, &rows, path, wanted, 2, unitless, mistakes);
  leg->points = calloc(rows + 1, sizeof *leg->points);
  for (size_t k = 0; k < rows && leg->points; k++)
    leg->points[leg->point_count++] = (struct nb_point){.approach = lengths[2 * k], .slip = lengths[2 * k + 1]};
  free(lengths);
  return whole;
}

void nb_path_follow(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_stage stage = {.name = "follow", .record = 1, .look = 1, .cycles = 1, .snapshot_from = -1};
  for (size_t s = 0; s < scene->stage_count; s++) {
    stage.snapshot = stage.snapshot || scene->stages[s].snapshot;
    free(scene->stages[s].leg.points);
  }
  scene->stage_count = 0;
  scene->followed = true;
  struct nb_stage *stages = nb_room(scene->stages, 0, 1, sizeof *stages);
  if (!stages || !nb_follow_read(&stage.leg, reading->follow, reading->reader.unitless, reading->reader.mistakes)) {
    free(stage.leg.points);
    if (stages)
      scene->stages = stages;
    return;
  }
  stage.cycles = stage.leg.point_count;
  scene->stages = stages;
  scene->stages[scene->stage_count++] = stage;
}
