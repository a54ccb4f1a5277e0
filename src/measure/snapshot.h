/* Snapshots: snapshot.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"

/* Fills the tables of a snapshot with the current state. `stage`: index of the current stage. False: out of memory. The
 * caller calls nb_snapshot_free in any case. */
bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage);
void nb_snapshot_free(struct nb_snapshot *snapshot);
/* The table number `index` among all tables that a snapshot can have; NULL after the last. */
struct nb_table *nb_snapshot_table_at(struct nb_snapshot *snapshot, size_t index);
/* Sets name and table to those of part number `part` among the tables that the snapshot has; false after the last. */
bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table);

/* A column of a table. The macros make the heads and the rows of a table from a list of columns with name, unit and
 * value. */
struct nb_table_column {
  const char *name, *unit;
};
#define NB_TABLE_COLUMN(name, unit, value) {name, unit},
#define NB_VALUE(name, unit, value) value,
/* Creates a table with these columns. False: out of memory. */
bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_table_column columns[],
                       size_t count);
/* Adds a row with these values. `stage`: stage of the snapshot. False: out of memory. */
bool nb_snapshot_row(struct nb_table *table, const struct nb_model *model, int stage, const double values[]);
