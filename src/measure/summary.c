/* Summaries of a snapshot.
 *
 *   averages   the largest, the smallest and the mean, in this order, of what all bodies and all contacts have [R89 4.6]
 *   types      of each region, material and radius: how many bodies, and what they contribute to the ends of contacts [R89 4.6]
 *   rings      of each region that has some: porosity ring by ring, and of all within, about its centre [R89 figure 6.5]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "areas.h"
#include "region.h"
#include "snapshot.h"

bool nb_summary_averages(struct nb_table *table, const struct nb_table *of, size_t skip) {
  const size_t count = of->column_count - skip, rows = of->row_count;
  if (!nb_table_create(table, count))
    return false;
  for (size_t c = 0; c < count; c++) {
    memcpy(table->names[c], of->names[c + skip], sizeof table->names[c]);
    table->units[c] = of->units[c + skip];
  }
  if (rows == 0)
    return true;
  for (int k = 0; k < 3; k++)
    if (!nb_table_row(table, of->stage[0], of->cycle[0], of->time[0]))
      return false;
  for (size_t c = 0; c < count; c++) {
    double most = -INFINITY, least = INFINITY, sum = 0;
    for (size_t r = 0; r < rows; r++) {
      const double value = of->values[r * of->column_count + c + skip];
      most = value > most ? value : most, least = value < least ? value : least, sum += value;
    }
    table->values[c] = most, table->values[count + c] = least, table->values[2 * count + c] = sum / (double)rows;
  }
  return true;
}

/* ---- by size and material ---- */

struct type {
  int material;
  double radius, bodies, ends, loaded, rattlers;
};

static int before(const void *a, const void *b) {
  const struct type *x = a, *y = b;
  if (x->material != y->material)
    return x->material < y->material ? -1 : 1;
  return x->radius > y->radius ? -1 : x->radius < y->radius;
}

static struct type of_body(const struct nb_model *model, size_t i) {
  struct type type = {.material = model->bodies.material[i], .radius = model->bodies.rim[i].x, .bodies = 1};
  const struct nb_contacts_of its = nb_contacts_of(&model->contacts.of, i);
  for (const int *c = its.first; c < its.end; c++)
    type.ends += model->contacts.kept[NB_OVERLAP][*c] > 0;
  const int touching = model->regions->touching[i];
  type.rattlers = touching<0, type.loaded = touching> 0 ? touching : 0;
  return type;
}

/* The bodies inside, sorted, those of a type made one. */
static size_t types_of(struct type *types, const struct nb_model *model, const struct nb_region_now *region) {
  size_t bodies = 0, count = 0;
  for (size_t k = 0; k < model->bodies.count; k++) {
    const size_t i = (size_t)model->bodies.slot[k];
    if (nb_region_holds(model, region, i))
      types[bodies++] = of_body(model, i);
  }
  qsort(types, bodies, sizeof *types, before);
  for (size_t k = 0; k < bodies; k++) {
    struct type *last = count ? &types[count - 1] : NULL;
    if (!last || before(last, &types[k]) != 0)
      types[count++] = types[k];
    else
      last->bodies++, last->ends += types[k].ends, last->loaded += types[k].loaded, last->rattlers += types[k].rattlers;
  }
  return count;
}

bool nb_summary_types(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_head heads[] = {{"region", "1"},       {"material", "1"}, {"radius", "m"},
                                         {"bodies", "1"},       {"ends", "1"},     {"share", "1"},
                                         {"coordination", "1"}, {"loaded", "1"},   {"rattlers", "1"}};
  enum { COLUMNS = sizeof heads / sizeof *heads };
  struct type *types = malloc((model->bodies.count + 1) * sizeof *types);
  bool whole = types && nb_snapshot_table(table, model->scene, heads, COLUMNS);
  for (size_t r = 0; whole && r < model->scene->region_count; r++) {
    const struct nb_region_now *region = nb_region_measured(model, (int)r, NB_COORDINATION); /* finds rattlers */
    const size_t count = types_of(types, model, region);
    for (size_t k = 0; whole && k < count; k++) {
      const struct type t = types[k];
      const double ends = region->coordination.all * region->coordination.bodies, carrying = t.bodies - t.rattlers;
      double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
      whole = row;
      const double values[COLUMNS] = {(double)r + 1,
                                      t.material + 1,
                                      t.radius,
                                      t.bodies,
                                      t.ends,
                                      ends > 0 ? t.ends / ends : 0,
                                      t.ends / t.bodies,
                                      carrying > 0 ? t.loaded / carrying : 0,
                                      t.rattlers};
      if (row)
        memcpy(row, values, sizeof values);
    }
  }
  free(types);
  return whole;
}

/* ---- ring by ring ---- */

/* What outlines cover of a circle about the region's centre, m2. */
static double covered(const struct nb_model *model, struct nb_vec centre, double radius) {
  double area = 0;
  for (size_t k = 0; k < model->bodies.count; k++) {
    const size_t i = (size_t)model->bodies.slot[k];
    if (!nb_gone(model, i))
      area += nb_area_of_lens(model->bodies.rim[i].x, radius, vec_length(vec_sub(model->bodies.position[i], centre)));
  }
  return area;
}

bool nb_summary_rings(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_head heads[] = {
      {"region", "1"}, {"inner", "m"}, {"outer", "m"}, {"porosity", "1"}, {"within", "1"}};
  enum { COLUMNS = sizeof heads / sizeof *heads };
  if (!nb_snapshot_table(table, model->scene, heads, COLUMNS))
    return false;
  for (size_t r = 0; r < model->scene->region_count; r++) {
    const struct nb_region_now *region = nb_region_now(model, (int)r);
    const int rings = region->it->rings;
    double inner = 0, before_it = 0;
    for (int k = 1; k <= rings; k++) {
      const double outer = region->radius * k / rings, now = covered(model, region->centre, outer);
      const double all = nb_area_of_disc(outer), ring = all - nb_area_of_disc(inner);
      const double values[COLUMNS] = {(double)r + 1, inner, outer, 1 - (now - before_it) / ring, 1 - now / all};
      double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
      if (!row)
        return false;
      memcpy(row, values, sizeof values);
      inner = outer, before_it = now;
    }
  }
  return true;
}
