/* Between a run (run.c, contact_test.c) and what comes of it (observe.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_OBSERVE_H
#define NB_OBSERVE_H

#include "core/model.h"

/* All answer false when memory is out. */
bool nb_observe_begin(struct nb_result *result, const struct nb_scene *scene); /* nothing seen yet */
bool nb_observe(struct nb_table *table, const struct nb_model *model, int stage);
/* Fields that some column or condition of the scene reads, and what else is to be kept for it: NB_ASKS_ of model.h. */
unsigned nb_fields_watched(const struct nb_scene *scene);

/* Reports the progress of a run. `progress` may be NULL. */
struct nb_teller {
  const struct nb_progress *progress;
  double began, told; /* s */
};
struct nb_teller nb_tell_begin(const struct nb_progress *progress);
void nb_tell(struct nb_teller *teller, const char *stage,
             double fraction); /* at once, then not more than ten times a second */

#endif
