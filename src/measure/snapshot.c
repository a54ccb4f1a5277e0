/* Snapshots: all bodies, walls and contacts at one moment, and summaries of them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "region.h"
#include "since.h"
#include "snapshot.h"

bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_head *columns,
                       size_t count) {
  if (!nb_table_create(table, count))
    return false;
  for (size_t c = 0; c < count; c++) {
    strcpy(table->names[c], columns[c].name);
    table->units[c] = scene->unitless ? "-" : columns[c].unit;
  }
  return true;
}

#define COUNT(array) (sizeof(array) / sizeof *(array))

static double touching(const struct nb_model *model, size_t slot) {
  const struct nb_contacts_of its = nb_contacts_of(&model->contacts.of, slot);
  double count = 0;
  for (const int *c = its.first; c < its.end; c++)
    count += model->contacts.kept[NB_OVERLAP][*c] > 0;
  return count;
}

static bool see_bodies(struct nb_table *table, const struct nb_model *model, int stage) {
  enum { SINCE = 3 }; /* columns of `from` */
  static const struct nb_head columns[] = {{"body", "1"},    {"x", "m"},        {"y", "m"},        {"radius", "m"},
                                           {"angle", "rad"}, {"vx", "m/s"},     {"vy", "m/s"},     {"fx", "N"},
                                           {"fy", "N"},      {"moment", "N.m"}, {"spin", "rad/s"}, {"contacts", "1"},
                                           {"fixed", "1"},   {"moved_x", "m"},  {"moved_y", "m"},  {"turned", "rad"}};
  const int from = model->scene->stages[stage].snapshot_from;
  const size_t count = COUNT(columns) - (from < 0 ? SINCE : 0);
  if (!nb_snapshot_table(table, model->scene, columns, count))
    return false;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (nb_gone(model, i))
      continue;
    const struct nb_vec x = nb_cell_place(model, i), v = nb_velocity_whole(model, i);
    const struct nb_force force = nb_force_on(model, i);
    const struct nb_vec moved = from < 0 ? vec(0, 0) : nb_since_moved(model, from, i);
    const double values[COUNT(columns)] = {(double)k + 1,
                                           x.x,
                                           x.y,
                                           bodies->rim[i].x,
                                           bodies->angle ? bodies->angle[i] : 0,
                                           v.x,
                                           v.y,
                                           force.force.x,
                                           force.force.y,
                                           force.moment,
                                           nb_velocity_now(model, i).spin,
                                           touching(model, i),
                                           !(bodies->inverse_mass[i] > 0),
                                           moved.x,
                                           moved.y,
                                           from < 0 ? 0 : nb_since_turned(model, from, i)};
    double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
    if (!row)
      return false;
    memcpy(row, values, count * sizeof *values);
  }
  return true;
}

static bool see_walls(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_head columns[] = {{"wall", "1"}, {"x1", "m"}, {"y1", "m"}, {"x2", "m"}, {"y2", "m"}};
  if (!nb_snapshot_table(table, model->scene, columns, COUNT(columns)))
    return false;
  const struct nb_walls *w = &model->walls;
  for (size_t k = 0; k < w->count; k++) {
    const struct nb_vec from = vec_add(w->point[k], vec_scale(w->h1[k], w->along[k]));
    const struct nb_vec to = vec_add(w->point[k], vec_scale(w->h2[k], w->along[k]));
    const double values[COUNT(columns)] = {(double)k + 1, from.x, from.y, to.x, to.y};
    double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
    if (!row)
      return false;
    memcpy(row, values, sizeof values);
  }
  return true;
}

/* Contacts that touch. b is 0 where the second is a wall, and then `wall` counts from 1. x, y is half-way between the two
 * outlines [CS79 figure 1]; ra, rb are the radii (0 for a wall), fx, fy the elastic force on the first; angle is e's.
 * radius is that of the contact circle, ratio the same over the smaller body's, limit mu F_n + c, obliquity |F_s| over it. */
static bool see_contacts(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_head columns[] = {{"a", "1"},
                                           {"b", "1"},
                                           {"wall", "1"},
                                           {"x", "m"},
                                           {"y", "m"},
                                           {"ra", "m"},
                                           {"rb", "m"},
                                           {"ex", "1"},
                                           {"ey", "1"},
                                           {"overlap", "m"},
                                           {"normal", "N"},
                                           {"shear", "N"},
                                           {"sliding", "1"},
                                           {"fx", "N"},
                                           {"fy", "N"},
                                           {"angle", "rad"},
                                           {"radius", "m"},
                                           {"normal_stress", "Pa"},
                                           {"shear_stress", "Pa"},
                                           {"ratio", "1"},
                                           {"limit", "N"},
                                           {"obliquity", "1"},
                                           {"slid", "m"}};
  const int from = model->scene->stages[stage].snapshot_from;
  const size_t count = COUNT(columns) - (from < 0);
  if (!nb_snapshot_table(table, model->scene, columns, count))
    return false;
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t c = 0; c < contacts->count; c++) {
    const double overlap = contacts->kept[NB_OVERLAP][c];
    if (!(overlap > 0))
      continue;
    const bool wall = model->pairings[contacts->pairing[c]].wall;
    const int i = contacts->a[c], b = contacts->b[c];
    const struct nb_vec e = vec(contacts->kept[NB_EX][c], contacts->kept[NB_EY][c]), t = vec_clockwise(e);
    const double normal = contacts->kept[NB_NORMAL][c];
    const double shear = model->pairings[contacts->pairing[c]].shear ? contacts->kept[NB_SHEAR][c] : 0;
    const struct nb_contact_load load = nb_contact_load(model, c);
    const struct nb_vec x = nb_cell_place(model, (size_t)i);
    const double reach = bodies->rim[i].x - overlap / 2;
    const double values[COUNT(columns)] = {bodies->number[i],
                                           wall ? 0 : bodies->number[b],
                                           wall ? b + 1 : 0,
                                           x.x + reach * e.x,
                                           x.y + reach * e.y,
                                           bodies->rim[i].x,
                                           wall ? 0 : bodies->rim[b].x,
                                           e.x,
                                           e.y,
                                           overlap,
                                           normal,
                                           shear,
                                           load.sliding,
                                           -(normal * e.x + shear * t.x),
                                           -(normal * e.y + shear * t.y),
                                           atan2(e.y, e.x),
                                           load.radius,
                                           load.pressure,
                                           load.traction,
                                           load.ratio,
                                           load.limit,
                                           load.obliquity,
                                           from < 0 ? 0 : nb_since_slid(model, from, c)};
    double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
    if (!row)
      return false;
    memcpy(row, values, count * sizeof *values);
  }
  return true;
}

bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage) {
  const int from = model->scene->stages[stage].snapshot_from;
  *snapshot = (struct nb_snapshot){.stage = stage};
  return see_bodies(&snapshot->bodies, model, stage) && see_walls(&snapshot->walls, model, stage) &&
         see_contacts(&snapshot->contacts, model, stage) &&
         (from < 0 || nb_since_lattice(&snapshot->lattice, model, stage, from)) &&
         nb_summary_averages(&snapshot->body_averages, &snapshot->bodies, 4) &&
         nb_summary_averages(&snapshot->contact_averages, &snapshot->contacts, 9) &&
         (!model->regions ||
          (nb_summary_types(&snapshot->types, model, stage) && nb_summary_rings(&snapshot->rings, model, stage)));
}

static const struct {
  const char *name;
  size_t at;
} parts[] = {
    {"bodies", offsetof(struct nb_snapshot, bodies)},
    {"walls", offsetof(struct nb_snapshot, walls)},
    {"contacts", offsetof(struct nb_snapshot, contacts)},
    {"body_averages", offsetof(struct nb_snapshot, body_averages)},
    {"contact_averages", offsetof(struct nb_snapshot, contact_averages)},
    {"types", offsetof(struct nb_snapshot, types)},
    {"rings", offsetof(struct nb_snapshot, rings)},
    {"lattice", offsetof(struct nb_snapshot, lattice)},
    {"traction", offsetof(struct nb_snapshot, traction)},
    {"pieces", offsetof(struct nb_snapshot, pieces)},
};

void nb_snapshot_free(struct nb_snapshot *snapshot) {
  for (size_t k = 0; k < COUNT(parts); k++)
    nb_table_free((struct nb_table *)(void *)((char *)snapshot + parts[k].at));
}

bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table) {
  for (size_t k = 0; k < COUNT(parts); k++) {
    *table = (const struct nb_table *)(const void *)((const char *)snapshot + parts[k].at), *name = parts[k].name;
    if ((*table)->names && part-- == 0)
      return true;
  }
  return false;
}
