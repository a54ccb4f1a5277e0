/* The contact test: one contact without motion or time. It calls the contact laws as the passes of the force
 * calculation do, step by step.
 *
 *   contact_test.c             one step, a segment, the whole test
 *   contact_test_quantities.c  the quantities of the contact, and the traction over the contact circle
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "laws/law.h"

/* A contact after a step, with its contact history. */
struct nb_contact_test_state {
  double approach; /* overlap, m; a gap if negative */
  double slip;     /* tangential displacement since the start, m */
  struct nb_normal n;
  struct nb_shear s;
  double *normal_history, *shear_history;
};

struct nb_contact_test {
  struct nb_owner owner; /* of the contact histories */
  const struct nb_scene *scene;
  struct nb_pair pair;
  const struct nb_law *normal, *shear;
  int normal_doubles, shear_doubles;       /* lengths of the histories */
  struct nb_contact_test_state now, trial; /* trial: a step that is not yet accepted */
  double work_normal, work_shear;          /* work of the mean force of each step, J */
  double dissipated;                       /* energy that the shear law has reported as lost, J */
  unsigned long step;                      /* number of steps done */
  struct nb_rounding rounding;             /* rounding mode of the steps */
  const volatile sig_atomic_t *stop;       /* the test ends after a step in which *stop is not 0; NULL: never */
};

/* Creates the contact of a scene, before its first segment. */
enum nb_status nb_contact_test_create(struct nb_contact_test *contact_test, const struct nb_scene *scene,
                                      struct nb_error *error);
void nb_contact_test_free(struct nb_contact_test *contact_test);

/* Runs all segments of a scene. `options` and `progress` may be NULL. NB_BROKEN if a force cannot be reached or is not
 * finite, or if the test is stopped. */
enum nb_status nb_contact_test_run(struct nb_result *result, const struct nb_scene *scene,
                                   const struct nb_options *options, const struct nb_progress *progress,
                                   struct nb_error *error);

/* ---- contact_test_quantities.c ---- */

double nb_contact_test_value(struct nb_quantity quantity, const struct nb_contact_test *contact_test); /* SI units */
/* Tables of the traction q(r) and of the memory diagram D(x); false: out of memory. */
bool nb_contact_test_snapshot(struct nb_snapshot *snapshot, const struct nb_contact_test *contact_test, int stage);
