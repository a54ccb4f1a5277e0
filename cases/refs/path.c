/* The path of a contact test, for references.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct path_contact path_contact(const struct nb_scene *scene) {
  const struct nb_particle *particles = scene->particles;
  const bool wall = scene->particle_count == 1;
  const struct matter_pair pair =
      matter_pair(scene, particles[0].material, wall ? scene->walls[0].material : particles[1].material);
  return (struct path_contact){
      .radius = matter_radius(particles[0].radius, wall ? INFINITY : particles[1].radius),
      .young = pair.young,
      .shear = pair.shear,
      .friction = pair.friction,
      .kappa = pair.young / (4 * pair.shear),
  };
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

static double interpolated(const struct nb_target *aim, double from, double fraction) {
  const double to = aim->relative ? from + aim->value : aim->value;
  return fraction == 1 ? to : from + (to - from) * fraction;
}

bool path_next(struct path_walk *walk, struct path_point now, struct path_target *target) {
  if ((size_t)walk->segment == walk->scene->stage_count)
    return false;
  const struct nb_stage *stage = &walk->scene->stages[walk->segment];
  const struct nb_segment *segment = &stage->segment;
  if (walk->step == 1)
    walk->begin = now;
  const double fraction = (double)walk->step / (double)stage->cycles;
  *target = (struct path_target){walk->segment, segment->normal.force, segment->shear.force, 0, 0};
  if (segment->points) {
    target->normal = segment->points[walk->step - 1].approach, target->shear = segment->points[walk->step - 1].slip;
  } else {
    target->normal =
        interpolated(&segment->normal, segment->normal.force ? walk->begin.normal : walk->begin.approach, fraction);
    target->shear =
        interpolated(&segment->shear, segment->shear.force ? walk->begin.shear : walk->begin.slip, fraction);
  }
  if (walk->step++ == stage->cycles)
    walk->segment++, walk->step = 1;
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

void path_add(struct nb_solution *solution, const struct nb_scene *scene, const char *name,
              struct path_column *column) {
  size_t row = 0;
  bool curve = true;
  for (size_t s = 0; s < scene->stage_count && column; s++) {
    char label[3 * NB_NAME_SIZE];
    row += scene->stages[s].cycles;
    snprintf(label, sizeof label, "%s in %s", name, scene->stages[s].name);
    if (!isnan(column->values[row]))
      solution_value(solution, column->values[row], label);
    if (s + 1 == scene->stage_count && !isnan(column->values[row]))
      solution_value(solution, column->values[row], name);
  }
  for (size_t k = 0; column && k < column->count; k++)
    curve = curve && !isnan(column->values[k]);
  if (curve)
    solution_curve(solution, name, "step", at, column);
  else
    free(column);
}
