/* What only the end of the page can tell: which kind of page it is, what its columns are, whether anything is missing.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "scene.h"

static void find_columns(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  if (reading->asked_count == 0)
    return;
  scene->columns = calloc(reading->asked_count, sizeof *scene->columns);
  if (!scene->columns) {
    nb_no_memory(&reading->reader);
    return;
  }
  for (size_t i = 0; i < reading->asked_count; i++) {
    struct nb_column *column = &scene->columns[i];
    memcpy(column->name, reading->asked[i].name, sizeof column->name);
    nb_asked_find(reading, &column->quantity, &reading->asked[i]);
  }
  scene->column_count = reading->asked_count;
}

/* A step that is wrong is a mistake already; one that is not there is none yet. */
static void check_step(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_page *page = reading->reader.page;
  bool missing = scene->stage_count > 0 ? scene->stages[0].step.value == 0 : scene->step.value == 0;
  for (size_t i = 0; i < page->line_count && missing; i++) {
    bool here = page->kind_of[i] == 1 + NB_BLOCK_SCENE && nb_line_read(&reading->reader, i + 1);
    const char *verb = reading->reader.tokens[0].text;
    if (here && (strcmp(verb, "step") == 0 || strcmp(verb, "start") == 0))
      missing = false;
  }
  if (missing)
    nb_say_of_scene(reading, "`step TIME` or `step F of safe`", "expected a scene with a `step`, found none");
}

void nb_whole_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_reader *reader = &reading->reader;
  if (scene->path && nb_page_fence(reader->page, NB_BLOCK_SCENE))
    nb_say_of_scene(reading, "a path is one contact on a bench, in a scene bodies move: make two pages of them",
                    "expected blocks of kind `scene` or `path`, found both");
  if (!scene->path && !nb_page_fence(reader->page, NB_BLOCK_SCENE)) {
    nb_say_of_scene(reading, "begin one with a line of three backticks and the word `scene`",
                    "expected a block of kind `scene`, found none");
    return;
  }
  find_columns(reading);
  if (scene->path) {
    nb_path_check(reading);
    return;
  }
  if (reading->opening)
    nb_stages_free(scene, scene->start.stages);
  nb_ramps_check(reading);
  nb_regions_check(reading);
  nb_cell_check(reading);
  nb_drives_check(reading);
  nb_boxes_check(reading);
  if (scene->body_count == 0 && !reading->bodies_unsure)
    nb_say_of_scene(reading, "`disc`, `sphere`, `discs` and `spheres` make them",
                    "expected a scene with bodies, found none");
  if (scene->stage_count == scene->start.stages && !(scene->start.line && reading->bodies_unsure))
    nb_say_of_scene(reading, "begin it with `stage NAME`, and say how long it is with `cycles N`",
                    "expected a scene with a stage, found none");
  for (size_t i = 0; i < scene->stage_count; i++) {
    if (scene->stages[i].cycles != 0)
      continue;
    nb_line_mistake(reader, scene->stages[i].line, "`cycles N`, or `until QUANTITY above|below VALUE at most N cycles`",
                    "expected a stage that ends, found neither `cycles` nor `until` in `%s`", scene->stages[i].name);
  }
  check_step(reading);
}
