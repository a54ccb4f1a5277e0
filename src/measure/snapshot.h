/* Snapshots: snapshot.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SNAPSHOT_H
#define NB_SNAPSHOT_H

#include "core/model.h"

/* All answer false when memory is out. */
bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage);
void nb_snapshot_free(struct nb_snapshot *snapshot);
/* Its tables one by one, those that it has; false past the last. */
bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table);

/* A column. Where a table's columns are a list with name, unit and value, these make its heads and its rows. */
struct nb_table_column {
  const char *name, *unit;
};
#define NB_TABLE_COLUMN(name, unit, value) {name, unit},
#define NB_VALUE(name, unit, value) value,
bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_table_column columns[],
                       size_t count);
bool nb_snapshot_row(struct nb_table *table, const struct nb_model *model, int stage, const double values[]);

#endif
