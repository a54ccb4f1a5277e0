/* Families of quantities: the meaning of each suffix, and the value of any quantity.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "names.h"

static double major(const struct nb_tensor *t) { return tensor_major(*t); }
static double minor(const struct nb_tensor *t) { return tensor_minor(*t); }
static double deviator(const struct nb_tensor *t) { return 2 * tensor_radius(*t); }
static double angle(const struct nb_tensor *t) { return tensor_angle(*t); }
static double mean(const struct nb_tensor *t) { return tensor_mean(*t); }

enum {
  STRESSES = 1 << NB_STRESSES,
  FABRICS = 1 << NB_FABRICS,
  TENSORS = 1 << NB_TENSOR | STRESSES | FABRICS,
  COMPONENTS = 1 << NB_COMPONENTS | TENSORS,
  FOURTH = 1 << NB_FOURTH,
  SPREAD = 1 << NB_STATISTICS
};
static const struct nb_suffix suffixes[] = {
    {COMPONENTS, "xx", "component", 0, NULL, NULL, 0},
    {COMPONENTS, "xy", "component", 1, NULL, NULL, 0},
    {COMPONENTS, "yx", "component", 2, NULL, NULL, 0},
    {COMPONENTS, "yy", "component", 3, NULL, NULL, 0},
    {TENSORS, "major", "major principal value [R89 4.52]", 0, major, NULL, 0},
    {TENSORS, "minor", "minor principal value [R89 4.53]", 0, minor, NULL, 0},
    {TENSORS & ~FABRICS, "deviator", "major minus minor principal value, never negative (yy minus xx can be negative)",
     0, deviator, NULL, NB_AT_LEAST_0},
    {FABRICS, "anisotropy", "major minus minor principal value", 0, deviator, NULL, NB_AT_LEAST_0},
    {TENSORS, "angle", "angle from x to the major principal axis [R89 4.54]", 0, angle, "rad"},
    {STRESSES, "mean", "mean (xx + yy)/2", 0, mean, NULL, 0},
    {FOURTH, "xxxx", "component", 0, NULL, NULL, 0},
    {FOURTH, "xxxy", "component", 1, NULL, NULL, 0},
    {FOURTH, "xxyy", "component", 2, NULL, NULL, 0},
    {FOURTH, "xyyy", "component", 3, NULL, NULL, 0},
    {FOURTH, "yyyy", "component", 4, NULL, NULL, 0},
    {SPREAD, "mean", "mean", 0, NULL, NULL, 0},
    {SPREAD, "max", "largest value", 1, NULL, NULL, 0},
    {SPREAD, "min", "smallest value", 2, NULL, NULL, 0},
    {SPREAD, "std", "standard deviation", 3, NULL, NULL, NB_AT_LEAST_0},
};

const struct nb_suffix *nb_suffix(enum nb_quantity_family family, size_t k) {
  for (size_t s = 0; s < sizeof suffixes / sizeof *suffixes; s++)
    if (suffixes[s].families & 1u << family && k-- == 0)
      return &suffixes[s];
  return NULL;
}

unsigned nb_quantity_bounds(struct nb_quantity quantity) {
  return quantity.kind->bounds | (quantity.suffix ? quantity.suffix->bounds : 0);
}

double nb_quantity_now(struct nb_quantity quantity, const struct nb_model *model) {
  const struct nb_quantity_kind *kind = quantity.kind;
  const struct nb_monitor *monitor = quantity.monitor < 0 ? NULL : &model->scene->monitors[quantity.monitor];
  double parts[NB_COMPONENTS_MAX];
  if (kind->value)
    return kind->value(model, monitor);
  kind->parts(parts, kind, model, monitor);
  if (!quantity.suffix)
    return parts[0];
  const struct nb_tensor t = tensor(parts[0], parts[1], parts[2], parts[3]);
  return quantity.suffix->function ? quantity.suffix->function(&t) : parts[quantity.suffix->part];
}
