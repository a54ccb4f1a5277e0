/* Snapshots: snapshot.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SNAPSHOT_H
#define NB_SNAPSHOT_H

#include "core/model.h"

/* All return false if memory runs out. */
bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage);
void nb_snapshot_free(struct nb_snapshot *snapshot);
/* All possible tables of a snapshot, including those that it does not have; NULL after the last. */
struct nb_table *nb_snapshot_table_at(struct nb_snapshot *snapshot, size_t index);
/* The tables that the snapshot has, one by one; false after the last. */
bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table);

/* A column. The macros make the heads and the rows of a table from a list of columns with name, unit and value. */
struct nb_table_column {
  const char *name, *unit;
};
#define NB_TABLE_COLUMN(name, unit, value) {name, unit},
#define NB_VALUE(name, unit, value) value,
bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_table_column columns[],
                       size_t count);
bool nb_snapshot_row(struct nb_table *table, const struct nb_model *model, int stage, const double values[]);

#endif
