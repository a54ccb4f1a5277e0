/* What is measured together: `region NAME circle …`, `box …`, `inside F`, `all`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

enum { RINGS_MAX = 1000 };

static bool take_place(struct nb_reader *reader, double *x, double *y) {
  return nb_take_number(reader, NB_UNIT_LENGTH, NB_ANY, x) && nb_take_number(reader, NB_UNIT_LENGTH, NB_ANY, y);
}

static bool take_circle(struct nb_reader *reader, struct nb_region *region) {
  region->kind = NB_REGION_CIRCLE;
  return take_place(reader, &region->x, &region->y) && nb_take_word(reader, "radius") &&
         nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &region->radius);
}

static bool take_box(struct nb_reader *reader, struct nb_region *region) {
  double x1, y1, x2, y2;
  region->kind = NB_REGION_BOX;
  if (!take_place(reader, &x1, &y1) || !nb_take_word(reader, "to") || !take_place(reader, &x2, &y2))
    return false;
  if (!(x2 > x1 && y2 > y1)) {
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected the south-west corner and then the north-east one, found them the other way");
    return false;
  }
  region->x = x1 + (x2 - x1) / 2, region->y = y1 + (y2 - y1) / 2;
  region->half_x = (x2 - x1) / 2, region->half_y = (y2 - y1) / 2;
  region->ex = 1, region->ey = 0;
  return true;
}

static bool take_region(struct nb_reader *reader, struct nb_region *region) {
  if (nb_token_skip(reader, "circle"))
    return take_circle(reader, region);
  if (nb_token_skip(reader, "box"))
    return take_box(reader, region);
  if (nb_token_skip(reader, "inside")) {
    region->kind = NB_REGION_INSIDE;
    return nb_take_number(reader, NB_UNIT_NUMBER, NB_SHARE, &region->radius);
  }
  if (!nb_token_skip(reader, "all"))
    return nb_expected(reader, NULL, "`circle X Y radius R`, `box X1 Y1 to X2 Y2`, `inside F` or `all`"), false;
  region->kind = NB_REGION_ALL;
  region->ex = 1, region->ey = 0;
  return true;
}

/* {rings N} {from STAGE} */
static void take_clauses(struct nb_reader *reader, struct nb_region *region) {
  unsigned long rings = 0;
  if (nb_token_is(reader, "rings") && region->kind != NB_REGION_CIRCLE && region->kind != NB_REGION_INSIDE)
    nb_expected(reader, "rings go round the centre of a circle", "the end of the line, or `from STAGE`");
  else if (nb_token_skip(reader, "rings") && nb_take_count(reader, 1, RINGS_MAX, &rings))
    region->rings = (int)rings;
  if (reader->bad || !nb_token_skip(reader, "from"))
    return;
  const struct nb_token *stage = nb_take(reader, "the name of a stage");
  if (stage && strlen(stage->text) < sizeof region->from)
    snprintf(region->from, sizeof region->from, "%s", stage->text);
}

NB_APPLY(nb_apply_region) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  struct nb_region region = {.stage = -1, .line = (int)reader->line};
  if (!name)
    return;
  if (take_region(reader, &region))
    take_clauses(reader, &region);
  struct nb_region *regions = nb_room(scene->regions, scene->region_count, 1, sizeof *regions);
  if (!regions) {
    nb_no_memory(reader);
    return;
  }
  scene->regions = regions;
  const struct nb_watch watch = {.kind = NB_WATCH_REGION, .a = (int)scene->region_count, .b = -1};
  if (nb_watch_add(reading, reader, name, watch))
    regions[scene->region_count++] = region;
}

/* Once all stages are known: which one `from` names. It is one that runs: those of another page, from which this one starts, do not. */
void nb_regions_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  for (size_t r = 0; r < scene->region_count; r++) {
    struct nb_region *region = &scene->regions[r];
    for (size_t s = scene->start.stages; s < scene->stage_count; s++)
      if (strcmp(scene->stages[s].name, region->from) == 0)
        region->stage = (int)s;
    if (!region->from[0] || region->stage >= 0 || reading->reader.unsure & NB_UNSURE_STAGES)
      continue;
    nb_line_read(&reading->reader, (size_t)region->line);
    const struct nb_token *name = &reading->reader.tokens[reading->reader.count - 1];
    if (!nb_stage_not_here(scene, &reading->reader, name))
      nb_token_mistake(&reading->reader, name, NULL, "expected the name of a stage of this page, found `%s`",
                       region->from);
  }
}
