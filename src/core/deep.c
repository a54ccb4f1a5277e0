/* Counts contacts of elastic spheres whose overlap is too large, and describes the first one; for other laws, warns of
 * such a contact at the start.                                                                         [R89 sec. 6.4.3]
 *
 * R89 assumes plastic flow above an overlap of 7 % of the smaller diameter, damps such contacts critically, and prints
 * their number as a warning. Hertz theory is inaccurate there too: with the effective radius R*, m, and the overlap
 * alpha, m, the contact radius a = (R* alpha)^(1/2) exceeds 0.26 of the smaller radius, and 0.37 of it at a wall.
 *
 * The other laws have no such limit, but an overlap above it at the start may be a mistake in a coordinate or a radius.
 * The overlap with a wall is the radius minus the distance of the centre from the wall. It is at most the radius,
 * because particles touch a wall from both sides.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "model.h"

/* Overlap over the smaller diameter at the onset of plastic flow [R89 sec. 6.4.3]. */
static const double default_fraction = 0.07;

double nb_deep_fraction(const struct nb_model *model) {
  return model->damping.deep > 0 ? model->damping.deep : default_fraction;
}

static unsigned long long count_since_search(const struct nb_model *model) {
  unsigned long long sum = 0;
  for (size_t v = 0; model->deep.counts && v < model->blocks.count; v++)
    sum += model->deep.counts[v * NB_DEEP_STRIDE];
  return sum;
}

unsigned long long nb_deep_count(const struct nb_model *model) { return model->deep.count + count_since_search(model); }

bool nb_deep_begin(struct nb_model *model, size_t blocks) {
  model->deep.count += count_since_search(model);
  free(model->deep.counts);
  model->deep.counts = nb_array(blocks * NB_DEEP_STRIDE, sizeof *model->deep.counts);
  return model->deep.counts != NULL;
}

void nb_deep_end(struct nb_model *model) {
  model->deep.count += count_since_search(model);
  free(model->deep.counts);
  model->deep.counts = NULL;
}

/* Radius of the smaller particle of a contact, or of the particle that touches a wall, m. */
static double smaller_radius(const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const double a = model->particles.radius[contacts->a[c]];
  const double b = nb_with_wall(model, c) ? a : model->particles.radius[contacts->b[c]];
  return a < b ? a : b;
}

/* This is the same test as in pass/deep.c. */
bool nb_is_deep(const struct nb_model *model, size_t c) {
  return nb_overlap(model, c) > 2 * nb_deep_fraction(model) * smaller_radius(model, c);
}

void nb_deep_warn(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  double largest = 0; /* overlap over the smaller diameter */
  size_t deepest = 0;
  for (size_t c = 0; c < contacts->count && !model->plan.elastic; c++) {
    const double relative = nb_is_deep(model, c) ? nb_overlap(model, c) / (2 * smaller_radius(model, c)) : 0;
    if (relative > largest)
      largest = relative, deepest = c;
  }
  if (largest == 0)
    return;
  const bool wall = nb_with_wall(model, deepest);
  const struct nb_scene *scene = model->scene;
  const int *number = model->particles.number;
  const int a = number[contacts->a[deepest]], one = wall ? a : number[contacts->b[deepest]];
  char other[2 * NB_NAME_SIZE];
  if (wall)
    snprintf(other, sizeof other, "wall `%s` (line %d)", scene->walls[contacts->b[deepest]].name,
             scene->walls[contacts->b[deepest]].line);
  else
    snprintf(other, sizeof other, "particle %d (line %d)", a, scene->particles[a - 1].line);
  nb_warn(
      &model->warnings, scene->particles[one - 1].line,
      "particle %d overlaps %s too much at the start: by %g%s, %.2g %% of the %sdiameter; above %g %% real particles "
      "deform plastically, and the force may be very large: move the particle away, or make it smaller",
      one, other, nb_overlap(model, deepest), nb_unit(scene, " m"), 100 * largest, wall ? "" : "smaller ",
      100 * nb_deep_fraction(model));
}

void nb_deep_record_first(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_deep *deep = &model->deep;
  if (!deep->counts || deep->first[0] || count_since_search(model) == 0)
    return;
  size_t c = 0;
  while (c + 1 < contacts->count && !nb_is_deep(model, c))
    c++;
  const bool wall = nb_with_wall(model, c);
  const char *s = nb_unit(model->scene, " s");
  const int n = snprintf(deep->first, sizeof deep->first, "particle %d and ", model->particles.number[contacts->a[c]]);
  char *rest = deep->first + n;
  const size_t left = sizeof deep->first - (size_t)n;
  if (wall)
    snprintf(rest, left, "wall %s, in cycle %lu, at time %g%s", model->scene->walls[contacts->b[c]].name, model->cycle,
             model->time, s);
  else
    snprintf(rest, left, "particle %d, in cycle %lu, at time %g%s", model->particles.number[contacts->b[c]],
             model->cycle, model->time, s);
}
