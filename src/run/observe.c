/* What is seen of a run: rows of named columns.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "observe.h"
#include "core/names.h"

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

/* ---- the columns of a page, and what they read ---- */

unsigned nb_fields_watched(const struct nb_scene *scene) {
  unsigned fields = 0;
  for (size_t c = 0; c < scene->column_count; c++)
    fields |= scene->columns[c].quantity.kind->fields;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    for (size_t k = 0; k < stage->condition_count; k++)
      fields |= stage->conditions[k].quantity.kind->fields;
    for (int k = 0; k < 4 && stage->servo.line; k++)
      fields |= stage->servo.quantity[k].kind->fields | NB_BIT(NB_OVERLAP) | NB_BIT(NB_STIFFNESS);
    if (stage->snapshot)
      fields |= NB_BIT(NB_OVERLAP) | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_NORMAL) | NB_BIT(NB_SHEAR) |
                NB_BIT(NB_SLIDING) | NB_BIT(NB_RADIUS) | (stage->snapshot_from >= 0 ? NB_BIT(NB_SLIP) : 0);
  }
  return fields;
}

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
    const double size = model->bodies.inverse_mass[i] > 0 ? vec_length(nb_force_left(model, i)) : 0;
    sum = size > sum ? size : sum;
  }
  for (size_t c = 0; c < model->contacts.count; c++) {
    const double size = vec_length(model->contacts.force[c]);
    contact = size > contact ? size : contact;
  }
  return contact > 0 ? sum / contact : 0;
}
