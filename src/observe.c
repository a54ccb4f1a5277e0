/* What is seen of a run: rows of named columns, and snapshots of everything.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "observe.h"

#include <stdlib.h>
#include <string.h>

/* ---- tables ---- */

bool nb_table_create(struct nb_table *table, size_t column_count) {
  *table = (struct nb_table){.column_count = column_count};
  table->names = calloc(column_count + 1, sizeof *table->names);
  table->units = calloc(column_count + 1, sizeof *table->units);
  if (table->names && table->units)
    return true;
  nb_table_free(table);
  return false;
}

static bool make_room(struct nb_table *table) {
  if (table->row_count < table->row_capacity)
    return true;
  const size_t capacity = table->row_capacity ? 2 * table->row_capacity : 64;
  double *values = realloc(table->values, capacity * (table->column_count + 1) * sizeof *values);
  if (values)
    table->values = values;
  double *cycle = realloc(table->cycle, capacity * sizeof *cycle);
  if (cycle)
    table->cycle = cycle;
  double *time = realloc(table->time, capacity * sizeof *time);
  if (time)
    table->time = time;
  int *stage = realloc(table->stage, capacity * sizeof *stage);
  if (stage)
    table->stage = stage;
  if (!values || !cycle || !time || !stage)
    return false;
  table->row_capacity = capacity;
  return true;
}

double *nb_table_row(struct nb_table *table, int stage, double cycle, double time) {
  if (!make_room(table))
    return NULL;
  const size_t row = table->row_count++;
  table->stage[row] = stage, table->cycle[row] = cycle, table->time[row] = time;
  double *values = table->values + row * table->column_count;
  memset(values, 0, table->column_count * sizeof *values);
  return values;
}

void nb_table_free(struct nb_table *table) {
  free(table->names), free(table->units), free(table->values), free(table->stage), free(table->cycle),
      free(table->time);
  *table = (struct nb_table){0};
}

/* ---- the columns of a page ---- */

bool nb_observe_begin(struct nb_table *table, const struct nb_scene *scene) {
  if (!nb_table_create(table, scene->column_count))
    return false;
  for (size_t c = 0; c < scene->column_count; c++) {
    memcpy(table->names[c], scene->columns[c].name, sizeof table->names[c]);
    table->units[c] = scene->unitless ? "-" : nb_quantity_unit(scene->columns[c].quantity);
  }
  return true;
}

bool nb_observe(struct nb_table *table, const struct nb_model *model, int stage) {
  double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_quantity_value(model->scene->columns[c].quantity, model);
  return true;
}

double nb_unbalance(const struct nb_model *model) {
  double sum = 0, contact = 0;
  for (size_t i = 0; i < model->bodies.count; i++) {
    const struct nb_vec weight = vec_scale(model->bodies.mass[i], model->gravity);
    const double size =
        model->bodies.inverse_mass[i] > 0 ? vec_length(vec_add(nb_force_on(model, i).force, weight)) : 0;
    sum = size > sum ? size : sum;
  }
  for (size_t c = 0; c < model->contacts.count; c++) {
    const double size = vec_length(model->contacts.force[c]);
    contact = size > contact ? size : contact;
  }
  return contact > 0 ? sum / contact : 0;
}

/* ---- snapshots ---- */

struct column {
  const char *name, *unit;
};

static bool begin(struct nb_table *table, const struct nb_scene *scene, const struct column *columns, size_t count) {
  if (!nb_table_create(table, count))
    return false;
  for (size_t c = 0; c < count; c++) {
    strcpy(table->names[c], columns[c].name);
    table->units[c] = scene->unitless ? "-" : columns[c].unit;
  }
  return true;
}

#define COUNT(array) (sizeof(array) / sizeof *(array))

static bool see_bodies(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct column columns[] = {{"body", "1"}, {"x", "m"},    {"y", "m"},  {"radius", "m"}, {"angle", "rad"},
                                          {"vx", "m/s"}, {"vy", "m/s"}, {"fx", "N"}, {"fy", "N"}};
  if (!begin(table, model->scene, columns, COUNT(columns)))
    return false;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (nb_gone(model, i))
      continue;
    const struct nb_state v = nb_velocity_now(model, i);
    const struct nb_force force = nb_force_on(model, i);
    const double values[COUNT(columns)] = {(double)k + 1,
                                           bodies->position[i].x,
                                           bodies->position[i].y,
                                           bodies->rim[i].x,
                                           bodies->angle ? bodies->angle[i] : 0,
                                           v.velocity.x,
                                           v.velocity.y,
                                           force.force.x,
                                           force.force.y};
    double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
    if (!row)
      return false;
    memcpy(row, values, sizeof values);
  }
  return true;
}

static bool see_walls(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct column columns[] = {{"wall", "1"}, {"x1", "m"}, {"y1", "m"}, {"x2", "m"}, {"y2", "m"}};
  if (!begin(table, model->scene, columns, COUNT(columns)))
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
 * outlines [CS79 figure 1]; ra, rb are the radii (0 for a wall), fx, fy the elastic force on the first. */
static bool see_contacts(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct column columns[] = {{"a", "1"},       {"b", "1"},       {"wall", "1"},   {"x", "m"},
                                          {"y", "m"},       {"ra", "m"},      {"rb", "m"},     {"ex", "1"},
                                          {"ey", "1"},      {"overlap", "m"}, {"normal", "N"}, {"shear", "N"},
                                          {"sliding", "1"}, {"fx", "N"},      {"fy", "N"}};
  if (!begin(table, model->scene, columns, COUNT(columns)))
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
    const double sliding = model->pairings[contacts->pairing[c]].shear ? contacts->kept[NB_SLIDING][c] : 0;
    const double reach = bodies->rim[i].x - overlap / 2;
    const double values[COUNT(columns)] = {bodies->number[i],
                                           wall ? 0 : bodies->number[b],
                                           wall ? b + 1 : 0,
                                           bodies->position[i].x + reach * e.x,
                                           bodies->position[i].y + reach * e.y,
                                           bodies->rim[i].x,
                                           wall ? 0 : bodies->rim[b].x,
                                           e.x,
                                           e.y,
                                           overlap,
                                           normal,
                                           shear,
                                           sliding,
                                           -(normal * e.x + shear * t.x),
                                           -(normal * e.y + shear * t.y)};
    double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
    if (!row)
      return false;
    memcpy(row, values, sizeof values);
  }
  return true;
}

bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage) {
  *snapshot = (struct nb_snapshot){.stage = stage};
  return see_bodies(&snapshot->bodies, model, stage) && see_walls(&snapshot->walls, model, stage) &&
         see_contacts(&snapshot->contacts, model, stage);
}

void nb_snapshot_free(struct nb_snapshot *snapshot) {
  nb_table_free(&snapshot->bodies), nb_table_free(&snapshot->walls), nb_table_free(&snapshot->contacts);
  nb_table_free(&snapshot->traction), nb_table_free(&snapshot->pieces);
}

bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table) {
  static const char *const names[] = {"bodies", "walls", "contacts", "traction", "pieces"};
  const struct nb_table *tables[] = {&snapshot->bodies, &snapshot->walls, &snapshot->contacts, &snapshot->traction,
                                     &snapshot->pieces};
  const int first = snapshot->bodies.names ? 0 : 3, end = snapshot->bodies.names ? 3 : 5;
  if (first + part >= end)
    return false;
  *name = names[first + part], *table = tables[first + part];
  return true;
}
