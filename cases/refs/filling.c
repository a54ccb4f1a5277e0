/* Reference: circles and boxes that were filled at random, counted and measured body by body.
 *
 *   NAME.wanted     sum of n_s over the sizes of the grading
 *   NAME.placed     how many bodies of the scene have such a radius
 *   NAME.dropped    the difference
 *   NAME.porosity   1 - sum n_s pi R_s^2/A, n_s the bodies there of radius R_s, A the area; of a region that is what was filled
 *   gap             the smallest of |x_i - x_j| - R_i - R_j over all pairs, m
 * for NAMEs that watch a grading or a size of it, or are regions.
 *
 * Exact but for rounding: nothing has moved when it is asked. All pairs are looked at, without cells.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "reference.h"

static double count(const struct nb_scene *scene, double radius) {
  double n = 0;
  for (size_t k = 0; k < scene->body_count; k++)
    n += scene->bodies[k].radius == radius;
  return n;
}

static void tell(struct nb_known *known, const char *of, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s", of, what);
  known_value(known, value, name);
}

static void tell_sizes(struct nb_known *known, const struct nb_scene *scene, const struct nb_watch *watch) {
  const struct nb_grading *grading = &scene->gradings[watch->a];
  double wanted = 0, placed = 0;
  for (int s = 0; s < (int)grading->size_count; s++)
    if (watch->b < 0 || watch->b == s)
      wanted += (double)grading->sizes[s].count, placed += count(scene, grading->sizes[s].radius);
  tell(known, watch->name, "wanted", wanted);
  tell(known, watch->name, "placed", placed);
  tell(known, watch->name, "dropped", wanted - placed);
}

static void tell_porosity(struct nb_known *known, const struct nb_scene *scene, const char *name) {
  const struct nb_fill *fill = &scene->fills[0];
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  const double area = fill->circle ? M_PI * gsl_pow_2(fill->radius) : (fill->x1 - fill->x) * (fill->y1 - fill->y);
  double covered = 0;
  for (size_t s = 0; s < grading->size_count; s++)
    covered += count(scene, grading->sizes[s].radius) * M_PI * gsl_pow_2(grading->sizes[s].radius);
  tell(known, name, "porosity", 1 - covered / area);
}

static bool is_filled(const struct nb_region *region, const struct nb_fill *fill) {
  if (fill->circle)
    return region->kind == NB_REGION_CIRCLE && region->x == fill->x && region->y == fill->y &&
           region->radius == fill->radius;
  return region->kind == NB_REGION_BOX && region->ex == 1 && region->x == (fill->x + fill->x1) / 2 &&
         region->y == (fill->y + fill->y1) / 2;
}

static double smallest_gap(const struct nb_scene *scene) {
  double least = INFINITY;
  for (size_t i = 0; i < scene->body_count; i++)
    for (size_t j = 0; j < i; j++) {
      const struct nb_body *a = &scene->bodies[i], *b = &scene->bodies[j];
      least = fmin(least, hypot(a->x - b->x, a->y - b->y) - a->radius - b->radius);
    }
  return least;
}

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  const bool alone = scene->fill_count == 1 && scene->fills[0].count == scene->body_count;
  if (!alone)
    return nb_error_set(error, NB_BAD_USE, "filling wants one `fill` and nothing else");
  for (size_t w = 0; w < scene->watch_count; w++) {
    const struct nb_watch *watch = &scene->watches[w];
    if (watch->kind == NB_WATCH_GRADING || watch->kind == NB_WATCH_SIZE)
      tell_sizes(known, scene, watch);
    if (watch->kind == NB_WATCH_REGION && is_filled(&scene->regions[watch->a], &scene->fills[0]))
      tell_porosity(known, scene, watch->name);
  }
  const double gap = smallest_gap(scene);
  if (scene->body_count > 1)
    known_value(known, gap, "gap");
  return known_full(known, error);
}

const struct nb_reference reference_filling = {
    .name = "filling",
    .title = "what was filled at random: counts, porosity, and the smallest gap of all pairs",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FRICTION},
    .normal = NB_ANY_LAW,
    .shear = NB_ANY_LAW,
    .know = know,
};
