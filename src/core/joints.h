/* Where a disc may touch a common end of two walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_JOINTS_H
#define NB_JOINTS_H

#include "nineball.h"

struct nb_joint {
  int c, d;       /* contacts of one body with two walls */
  int at_c, at_d; /* which end of each wall is their common one, 0 or 1 */
};
struct nb_joints {
  bool any;              /* two walls have a common end */
  struct nb_joint *list; /* where a disc may touch one before the next search */
  size_t count, capacity;
};
bool nb_joints_meet(const struct nb_scene *scene); /* two walls have a common end */
bool nb_joints_find(struct nb_model *model);       /* after a search; false: no memory */
void nb_joints_settle(struct nb_model *model);     /* before the forces: which contacts are muted now */

#endif
