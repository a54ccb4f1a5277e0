/* Runs that go on from a saved state beside the one that is not interrupted.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CONTINUED_H
#define NB_CONTINUED_H

#include "../src/run/state.h"
#include "written.h"

void continued_stages(struct nb_model *model, size_t from, size_t to); /* those stages, one after the other */
/* Runs all, and from the end of each stage on to the end again, in three ways; all must come to the same state. */
void continued_same(struct written *written, const char *what);

#endif
