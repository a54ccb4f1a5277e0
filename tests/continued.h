/* Runs that continue from a saved state, compared with the uninterrupted run.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../src/run/state.h"
#include "written.h"

void continued_stages(struct nb_model *model, size_t from, size_t to); /* runs the stages `from` ... `to` - 1 */
/* Runs all stages, and continues from the state at the end of each stage but the last, with three sets of options. All
 * runs must end in the same state, with the same recorded quantities. `what` names the scene in messages. */
void continued_same(struct written *written, const char *what);
