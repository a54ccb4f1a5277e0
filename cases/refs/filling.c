/* Reference: random fillings of circles and boxes, counted and measured particle by particle.
 *
 * Returns, for F that monitors a grading or one size of it:
 *   F.wanted     the number of particles that the grading asks for
 *   F.placed     the number of particles with these radii
 *   F.dropped    the difference
 * for F that monitors the region that was filled:
 *   F.porosity   1 - sum pi R^2/A over all particles, A the area of the region
 * and
 *   gap          the smallest |x_i - x_j| - R_i - R_j of all pairs, m
 * Error: rounding, because nothing has moved. All pairs are compared, without a search grid.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "reference.h"

static double count(const struct nb_scene *scene, double radius) {
  double n = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    n += scene->particles[k].radius == radius;
  return n;
}

static void add_value(struct nb_solution *solution, const char *of, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s", of, what);
  solution_value(solution, value, name);
}

static void add_sizes(struct nb_solution *solution, const struct nb_scene *scene, const struct nb_monitor *monitor) {
  const struct nb_grading *grading = &scene->gradings[monitor->a];
  double wanted = 0, placed = 0;
  for (int s = 0; s < (int)grading->size_count; s++)
    if (monitor->b < 0 || monitor->b == s)
      wanted += (double)grading->sizes[s].count, placed += count(scene, grading->sizes[s].radius);
  add_value(solution, monitor->name, "wanted", wanted);
  add_value(solution, monitor->name, "placed", placed);
  add_value(solution, monitor->name, "dropped", wanted - placed);
}

static void add_porosity(struct nb_solution *solution, const struct nb_scene *scene, const char *name) {
  const struct nb_fill *fill = &scene->fills[0];
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  const double area = fill->circle ? M_PI * gsl_pow_2(fill->radius) : (fill->x1 - fill->x) * (fill->y1 - fill->y);
  double covered = 0;
  for (size_t s = 0; s < grading->size_count; s++)
    covered += count(scene, grading->sizes[s].radius) * M_PI * gsl_pow_2(grading->sizes[s].radius);
  add_value(solution, name, "porosity", 1 - covered / area);
}

static bool is_filled_region(const struct nb_region *region, const struct nb_fill *fill) {
  if (fill->circle)
    return region->kind == NB_REGION_CIRCLE && region->x == fill->x && region->y == fill->y &&
           region->radius == fill->radius;
  return region->kind == NB_REGION_BOX && region->x == (fill->x + fill->x1) / 2 &&
         region->y == (fill->y + fill->y1) / 2 && fabs(2 * region->half_x / (fill->x1 - fill->x) - 1) < 1e-12 &&
         fabs(2 * region->half_y / (fill->y1 - fill->y) - 1) < 1e-12;
}

static double smallest_gap(const struct nb_scene *scene) {
  double smallest = INFINITY;
  for (size_t i = 0; i < scene->particle_count; i++)
    for (size_t j = 0; j < i; j++) {
      const struct nb_particle *a = &scene->particles[i], *b = &scene->particles[j];
      smallest = fmin(smallest, hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius);
    }
  return smallest;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const bool alone = scene->fill_count == 1 && scene->fills[0].count == scene->particle_count;
  if (!alone)
    return nb_error_set(error, NB_BAD_USE, "the reference `filling` is for one `fill` and no other particles");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_GRADING || monitor->kind == NB_MONITOR_SIZE)
      add_sizes(solution, scene, monitor);
    if (monitor->kind == NB_MONITOR_REGION && is_filled_region(&scene->regions[monitor->a], &scene->fills[0]))
      add_porosity(solution, scene, monitor->name);
  }
  const double gap = smallest_gap(scene);
  if (scene->particle_count > 1)
    solution_value(solution, gap, "gap");
  return solution_status(solution, error);
}

const struct nb_reference reference_filling = {
    .name = "filling",
    .title = "random filling: counts, porosity, and the smallest gap of all pairs",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FRICTION},
    .normal = NB_ANY_LAW,
    .shear = NB_ANY_LAW,
    .solve = solve,
};
