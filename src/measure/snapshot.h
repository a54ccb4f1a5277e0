/* Snapshots, and summaries of them: snapshot.c, summary.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SNAPSHOT_H
#define NB_SNAPSHOT_H

#include "core/model.h"

/* All answer false when memory is out. */
bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage);
void nb_snapshot_free(struct nb_snapshot *snapshot);

struct nb_head {
  const char *name, *unit;
};
bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_head *columns,
                       size_t count);

/* summary.c */
bool nb_summary_averages(struct nb_table *table, const struct nb_table *of, size_t skip);
bool nb_summary_types(struct nb_table *table, const struct nb_model *model, int stage);
bool nb_summary_rings(struct nb_table *table, const struct nb_model *model, int stage);

#endif
