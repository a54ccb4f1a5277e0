/* Every page of the short list, run by run, for tests of what must hold of any scene.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_EVERY_PAGE_H
#define NB_EVERY_PAGE_H

#include "../src/nineball.h"

/* Calls `look` with the scenes of the pages, `name` for messages: the first and the last run of each sweep, and at most as many cycles
 * of each stage as can be made in `budget` updates of particles, but at least 20. Every quantity that the scene can have is a column,
 * with some twenty rows a stage. Scenes are the test's to change. */
void every_page(void (*look)(struct nb_scene *scene, const char *name), double budget);

#endif
