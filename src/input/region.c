/* Regions of measurement: `region NAME circle …`, `box …`, `inside F`, `all`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

enum { RINGS_MAX = 1000 };

enum { AT_NAME };
static const struct nb_argument region_fields[] = {NAME(AT_NAME, "a name for the region"), END};

static bool take_point(struct nb_reader *reader, double *x, double *y) {
  return nb_take_number(reader, NB_UNIT_LENGTH, NB_ANY, x) && nb_take_number(reader, NB_UNIT_LENGTH, NB_ANY, y);
}

static bool take_circle(struct nb_reader *reader, struct nb_region *it) {
  it->kind = NB_REGION_CIRCLE;
  return take_point(reader, &it->x, &it->y) && nb_take_word(reader, "radius") &&
         nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &it->radius);
}

static bool take_box(struct nb_reader *reader, struct nb_region *it) {
  double x1, y1, x2, y2;
  it->kind = NB_REGION_BOX;
  if (!take_point(reader, &x1, &y1) || !nb_take_word(reader, "to") || !take_point(reader, &x2, &y2))
    return false;
  if (nb_corners_swapped(reader, x1, y1, x2, y2))
    return false;
  it->x = x1 + (x2 - x1) / 2, it->y = y1 + (y2 - y1) / 2;
  it->half_x = (x2 - x1) / 2, it->half_y = (y2 - y1) / 2;
  it->ex = 1, it->ey = 0;
  return true;
}

static bool take_region(struct nb_reader *reader, struct nb_region *it) {
  if (nb_token_skip(reader, "circle"))
    return take_circle(reader, it);
  if (nb_token_skip(reader, "box"))
    return take_box(reader, it);
  if (nb_token_skip(reader, "inside")) {
    it->kind = NB_REGION_INSIDE;
    return nb_take_number(reader, NB_UNIT_NUMBER, NB_FRACTION, &it->radius);
  }
  if (!nb_token_skip(reader, "all"))
    return nb_expected(reader, NULL, "`circle X Y radius R`, `box X1 Y1 to X2 Y2`, `inside F` or `all`");
  it->kind = NB_REGION_ALL;
  it->ex = 1, it->ey = 0;
  return true;
}

/* Takes the clauses {rings N} {from STAGE}. */
static void take_clauses(struct nb_reader *reader, struct nb_region *it) {
  unsigned long rings = 0;
  if (nb_token_is(reader, "rings") && it->kind != NB_REGION_CIRCLE && it->kind != NB_REGION_INSIDE)
    nb_expected(reader, "`rings` is for the regions `circle` and `inside`", "the end of the line, or `from STAGE`");
  else if (nb_token_skip(reader, "rings") && nb_take_count(reader, 1, RINGS_MAX, &rings))
    it->rings = (int)rings;
  const struct nb_token *stage = nb_token_skip(reader, "from") ? nb_take_name(reader, "the name of a stage") : NULL;
  if (stage)
    snprintf(it->from, sizeof it->from, "%s", stage->text);
}

NB_APPLY(apply_region) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_region one = {.stage = -1, .line = (int)reader->line};
  const struct nb_monitor monitor = {.kind = NB_MONITOR_REGION, .a = (int)scene->region_count, .b = -1};
  if (take_region(reader, &one))
    take_clauses(reader, &one);
  if (!reader->bad && nb_monitor_add(scene, reader, record->value[AT_NAME].token, monitor))
    NB_APPEND(reader, scene->regions, scene->region_count, one);
}

static bool has_boundary(const struct nb_scene *scene) {
  bool found = scene->circle.line > 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    found = found || scene->stages[s].circle.line > 0;
  return found;
}

/* Finds the stage that `from` names, when all stages are known. It must be a stage of this page, not of the page from
 * which this page starts. A region inside the boundary needs a boundary. */
void nb_regions_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_reader *reader = &reading->reader;
  for (size_t r = 0; r < scene->region_count; r++) {
    struct nb_region *it = &scene->regions[r];
    if (it->kind == NB_REGION_INSIDE && !has_boundary(scene) && !nb_statement_suppressed(reader->mistakes, "boundary"))
      nb_line_mistake(
          reader, (size_t)it->line,
          "`inside F` is for a scene with `boundary circle X Y radius R`; in a box or a cell write `box X1 Y1 to X2 "
          "Y2`, `circle X Y radius R` or `all`",
          "expected a scene with a boundary, found none");
    for (size_t s = scene->start.stages; s < scene->stage_count; s++)
      if (strcmp(scene->stages[s].name, it->from) == 0)
        it->stage = (int)s;
    if (!it->from[0] || it->stage >= 0 || nb_name_suppressed(reader->mistakes, "repeat"))
      continue;
    nb_line_read(reader, (size_t)it->line);
    const struct nb_token *name = &reader->tokens[reader->count - 1];
    if (!nb_stage_before_start(scene, reader, name))
      nb_unknown_name(reader, name, NULL, "the name of a stage of this page");
  }
}

/* clang-format off */
NB_STATEMENTS(region) = {
  {"region", NB_IN_SCENE | NB_IN_START, region_fields, "circle X Y radius R {rings N} {from STAGE} | box X1 Y1 to X2 Y2 {from STAGE} | inside F {rings N} {from STAGE} | all {from STAGE}", 0, false, apply_region,
   "Names a region of the plane for averages: `A.stress.mean`. A particle is inside if its centre is.\n"
   "circle X Y radius R: lengths. A circle about this centre.\n"
   "box X1 Y1 to X2 Y2: lengths. A rectangle between two opposite corners; the first corner has the smallest x and y.\n"
   "inside F: a number from 0 to 1. A circle about the centre of the boundary; its radius is the fraction F of the boundary's mean radius.\n"
   "all: the periodic cell; without a cell, the smallest rectangle around all particles, which `transform` rotates. It is not the box of walls, whose porosity is `box.porosity`.\n"
   "rings N: a whole number from 1 to 1000, for `circle` and `inside`. A snapshot then has the porosity of N rings of equal width about the centre.\n"
   "from STAGE: the name of a stage of this page, after any of the four shapes: `region S all from load`. The strains of the region, and its lost and new contacts, then count from the beginning of this stage; without it: from the start of the run.",
   "region    M  circle 40 mm 40 mm radius 30 mm  rings 6\nregion    T  all  from strike"},
  {0},
};
/* clang-format on */
