/* Between a run (run.c) and what it sees (observe.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OBSERVE_H
#define NB_OBSERVE_H

#include "core/model.h"

/* All answer false when memory is out. */
bool nb_observe_begin(struct nb_table *table, const struct nb_scene *scene);
bool nb_observe(struct nb_table *table, const struct nb_model *model, int stage);
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

/* Largest force sum on a free body, weight included, over largest contact force: dF/F of [CS79 tables 1-3]; 0 while nothing
 * touches. */
double nb_unbalance(const struct nb_model *model);

#endif
