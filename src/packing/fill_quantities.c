/* Quantities of gradings, and the smallest gap.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/names.h"

/* Numbers of particles of the monitored grading, or of one of its sizes. */
struct sum {
  double wanted, placed;
};
static struct sum sum_of(const struct nb_model *model, const struct nb_monitor *monitor) {
  const struct nb_grading *grading = &model->scene->gradings[monitor->a];
  struct sum sum = {0, 0};
  for (size_t s = 0; s < grading->size_count; s++) {
    if (monitor->b >= 0 && (size_t)monitor->b != s)
      continue;
    sum.wanted += (double)grading->sizes[s].wanted, sum.placed += (double)grading->sizes[s].placed;
  }
  return sum;
}

static double wanted(const struct nb_model *model, const struct nb_monitor *monitor) {
  return sum_of(model, monitor).wanted;
}
static double placed(const struct nb_model *model, const struct nb_monitor *monitor) {
  return sum_of(model, monitor).placed;
}
static double dropped(const struct nb_model *model, const struct nb_monitor *monitor) {
  const struct sum sum = sum_of(model, monitor);
  return sum.wanted - sum.placed;
}
static double attempts(const struct nb_model *model, const struct nb_monitor *monitor) {
  double total = 0;
  for (size_t f = 0; f < model->scene->fill_count; f++)
    if (model->scene->fills[f].grading == monitor->a)
      total += (double)model->scene->fills[f].attempts_made;
  return total;
}
/* Gap between two particles, m; in a cell, between the nearest images. INFINITY: no force can act between the two. */
static double gap_between(const struct nb_model *model, const struct nb_wrap *wrap, int i, int j) {
  const struct nb_particles *particles = &model->particles;
  if (nb_removed(model, (size_t)i) || nb_removed(model, (size_t)j) ||
      !(particles->inverse_mass[i] > 0 || particles->inverse_mass[j] > 0))
    return INFINITY;
  const struct nb_vec apart = vec_sub(particles->position[j], particles->position[i]);
  const struct nb_vec nearest = model->cell ? nb_wrapped(wrap, apart) : apart;
  return vec_length(nearest) - (particles->radius[i] + particles->radius[j]);
}

/* The smallest gap, m, or the skin if that is smaller. If no listed pair overlaps, all pairs are compared: a pair that
 * is not listed does not touch, but its gap may be the smallest one. */
static double gap(const struct nb_model *model, const struct nb_monitor *monitor) {
  (void)monitor;
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_wrap wrap = model->cell ? nb_cell_wrap(model->cell) : (struct nb_wrap){.h = {0, 0, 0, 0}};
  const int n = (int)model->particles.count;
  double least = model->search.skin;
  wrap.centre = vec(0, 0); /* differences are wrapped, not positions */
  for (size_t c = 0; c < contacts->wall_from; c++)
    least = fmin(least, gap_between(model, &wrap, contacts->a[c], contacts->b[c]));
  for (int i = 0; i < n && least > 0; i++)
    for (int j = i + 1; j < n; j++)
      least = fmin(least, gap_between(model, &wrap, i, j));
  return least;
}

enum { GRADING = 1 << NB_MONITOR_GRADING, EITHER = 1 << NB_MONITOR_GRADING | 1 << NB_MONITOR_SIZE };

const struct nb_quantity_kind nb_fill_kinds[] = {
    {"gap", 0, "m", 0, gap, "smallest gap between two particles, at most the skin; below 0: they overlap"},
    {"wanted", EITHER, "1", 0, wanted, "number of particles to be placed", NB_AT_LEAST_0},
    {"placed", EITHER, "1", 0, placed, "number of particles placed", NB_AT_LEAST_0},
    {"dropped", EITHER, "1", 0, dropped, "number of particles that were not placed, for want of space", NB_AT_LEAST_0},
    {"attempts", GRADING, "1", 0, attempts, "number of placement attempts, for all particles", NB_AT_LEAST_0},
    {.name = NULL},
};
