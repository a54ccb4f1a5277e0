/* Tables: rows of named columns.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "nineball.h"

#include <stdlib.h>
#include <string.h>

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
