/* Between a run (run.c) and what it sees (observe.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OBSERVE_H
#define NB_OBSERVE_H

#include "core/model.h"

/* All answer false when memory is out. */
bool nb_observe_begin(struct nb_table *table, const struct nb_scene *scene);
bool nb_observe(struct nb_table *table, const struct nb_model *model, int stage);
/* Fields that some column or condition of the scene reads, and what else is to be kept for it: NB_ASKS_ of model.h. */
unsigned nb_fields_watched(const struct nb_scene *scene);

#endif
