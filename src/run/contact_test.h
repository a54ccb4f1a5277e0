/* One contact on a bench: no bodies, no time. Its law is called as the simulator's passes call it, one step after the other.
 *
 *   contact_test.c             a contact, one step of it, a leg, a path from its first leg to its last
 *   contact_test_quantities.c  what is seen of it; the traction over the contact, of a law that keeps its history
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CONTACT_TEST_H
#define NB_CONTACT_TEST_H

#include "laws/law.h"

/* A contact after a step, and what its laws remember. */
struct nb_contact_test_state {
  double approach; /* m; below 0 it is a gap */
  double slip;     /* since the start, m */
  struct nb_normal n;
  struct nb_shear s;
  double *normal_history, *shear_history;
};

struct nb_contact_test {
  struct nb_owner owner; /* of what laws remember */
  const struct nb_scene *scene;
  struct nb_pair pair;
  const struct nb_law *normal, *shear;
  int normal_doubles, shear_doubles;       /* of memory */
  struct nb_contact_test_state now, trial; /* trial: a step tried and not yet made */
  double work_normal, work_shear;          /* of the forces at the mean of each step's two ends, J */
  double dissipated;                       /* by a law that says it, J */
  unsigned long step;                      /* made so far */
};

enum nb_status nb_contact_test_create(struct nb_contact_test *contact_test, const struct nb_scene *scene,
                                      struct nb_error *error);
void nb_contact_test_free(struct nb_contact_test *contact_test);

/* All of a path. */
enum nb_status nb_contact_test_run(struct nb_result *result, const struct nb_scene *scene,
                                   const struct nb_progress *progress, struct nb_error *error);

/* ---- contact_test_quantities.c ---- */

double nb_contact_test_value(struct nb_quantity quantity,
                             const struct nb_contact_test *contact_test); /* of a path's contact, SI */
/* The traction over the contact, and D(x); false: no memory. */
bool nb_contact_test_snapshot(struct nb_snapshot *snapshot, const struct nb_contact_test *contact_test, int stage);

#endif
