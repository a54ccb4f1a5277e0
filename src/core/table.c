/* Tables with named columns.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "nineball.h"
#include "store.h"

bool nb_table_create(struct nb_table *table, size_t column_count) {
  *table = (struct nb_table){.column_count = column_count};
  table->names = calloc(column_count + 1, sizeof *table->names);
  table->units = calloc(column_count + 1, sizeof *table->units);
  if (table->names && table->units)
    return true;
  nb_table_free(table);
  return false;
}

double *nb_table_row(struct nb_table *table, int stage, double cycle, double time) {
  const size_t row = table->row_count, columns = table->column_count;
  if (!nb_array_grow(&table->values, row, (columns + 1) * sizeof(double)) ||
      !nb_array_grow(&table->cycle, row, sizeof(double)) || !nb_array_grow(&table->time, row, sizeof(double)) ||
      !nb_array_grow(&table->stage, row, sizeof(int)))
    return NULL;
  table->row_count++;
  table->stage[row] = stage, table->cycle[row] = cycle, table->time[row] = time;
  return memset(table->values + row * columns, 0, columns * sizeof(double));
}

void nb_table_free(struct nb_table *table) {
  free(table->names), free(table->units), free(table->values), free(table->stage), free(table->cycle),
      free(table->time);
  *table = (struct nb_table){0};
}

void nb_store_table(struct nb_store *store, struct nb_table *table) {
  const size_t rows = nb_store_length(store, "rows", table->row_count);
  for (table->row_count = store->restoring ? 0 : rows; table->row_count < rows && !store->failed;)
    store->failed = !nb_table_row(table, 0, 0, 0);
  NB_STORE_INTEGERS(store, "rows", table->stage, rows);
  NB_STORE(store, "row.cycle", table->cycle, rows);
  NB_STORE(store, "row.time", table->time, rows);
  NB_STORE(store, "row.values", table->values, rows * table->column_count);
}
