/* A path of the bench, for references.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum nb_status path_contact(struct path_contact *contact, const struct nb_scene *scene, const char *reference,
                            struct nb_error *error) {
  if (!scene->path || strcmp(scene->normal, "hertz") != 0)
    return nb_error_set(error, NB_BAD_USE, "%s wants a path, with `normal hertz`", reference);
  const struct nb_body *bodies = scene->bodies;
  const bool wall = scene->body_count == 1;
  const struct matter_pair pair =
      matter_pair(scene, bodies[0].material, wall ? scene->walls[0].material : bodies[1].material);
  *contact = (struct path_contact){
      .radius = matter_radius(bodies[0].radius, wall ? INFINITY : bodies[1].radius),
      .young = pair.young,
      .shear = pair.shear,
      .friction = pair.friction,
      .kappa = pair.young / (4 * pair.shear),
  };
  return NB_OK;
}

double path_normal(const struct path_contact *contact, double overlap) {
  return overlap > 0 ? 4. / 3 * contact->young * sqrt(contact->radius) * pow(overlap, 1.5) : 0;
}

double path_overlap(const struct path_contact *contact, double normal) {
  return pow(normal / (4. / 3 * contact->young * sqrt(contact->radius)), 2. / 3);
}

struct path_walk path_walk(const struct nb_scene *scene) {
  return (struct path_walk){.scene = scene, .step = 1};
}

static double on_the_way(const struct nb_aim *aim, double from, double share) {
  const double to = aim->by ? from + aim->value : aim->value;
  return share == 1 ? to : from + (to - from) * share;
}

bool path_next(struct path_walk *walk, struct path_place now, struct path_aim *aim) {
  if ((size_t)walk->leg == walk->scene->stage_count)
    return false;
  const struct nb_stage *stage = &walk->scene->stages[walk->leg];
  const struct nb_leg *leg = &stage->leg;
  if (walk->step == 1)
    walk->begin = now;
  const double share = (double)walk->step / (double)stage->cycles;
  *aim = (struct path_aim){walk->leg, leg->normal.force, leg->shear.force, 0, 0};
  if (leg->points) {
    aim->normal = leg->points[walk->step - 1].approach, aim->shear = leg->points[walk->step - 1].slip;
  } else {
    aim->normal = on_the_way(&leg->normal, leg->normal.force ? walk->begin.normal : walk->begin.approach, share);
    aim->shear = on_the_way(&leg->shear, leg->shear.force ? walk->begin.shear : walk->begin.slip, share);
  }
  if (walk->step++ == stage->cycles)
    walk->leg++, walk->step = 1;
  return true;
}

size_t path_steps(const struct nb_scene *scene) {
  size_t steps = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    steps += scene->stages[s].cycles;
  return steps;
}

struct path_column *path_column(const struct nb_scene *scene) {
  const size_t count = path_steps(scene) + 1;
  struct path_column *column = calloc(1, sizeof *column + count * sizeof *column->values);
  if (column)
    column->count = count;
  return column;
}

static double at(const void *data, double x) {
  const struct path_column *column = data;
  const double row = floor(x + 0.5);
  return row >= 0 && row < (double)column->count ? column->values[(size_t)row] : NAN;
}

void path_tell(struct nb_known *known, const struct nb_scene *scene, const char *name, struct path_column *column) {
  size_t row = 0;
  bool curve = true;
  for (size_t s = 0; s < scene->stage_count && column; s++) {
    char label[3 * NB_NAME_SIZE];
    row += scene->stages[s].cycles;
    snprintf(label, sizeof label, "%s in %s", name, scene->stages[s].name);
    if (!isnan(column->values[row]))
      known_value(known, column->values[row], label);
    if (s + 1 == scene->stage_count && !isnan(column->values[row]))
      known_value(known, column->values[row], name);
  }
  for (size_t k = 0; column && k < column->count; k++)
    curve = curve && !isnan(column->values[k]);
  if (curve)
    known_curve(known, name, "step", at, column);
  else
    free(column);
}
