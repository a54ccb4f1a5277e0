/* The scenes of all pages of PAGES in build-aux/lists.mk, for tests of properties that hold for any scene.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../src/nineball.h"

/* Calls `look` with the scene of each page, of a sweep with the scenes of the first and the last run. `name` is for
 * messages. `look` may change the scene. Stages are shortened: a run has about `budget` updates of particles, divided
 * equally among its stages, but a stage is not shortened to less than 20 cycles. A stage has about twenty rows, and
 * every quantity that the scene can have is a column. */
void every_page(void (*look)(struct nb_scene *scene, const char *name), double budget);
