/* Every page of PAGES in build-aux/lists.mk, run by run, for tests of properties that hold for any scene.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../src/nineball.h"

/* Calls `look` with the scenes of the pages and a `name` for messages: the first and the last run of each sweep. A
 * stage has at most as many cycles as `budget` updates of particles allow, but at least 20. Every quantity that the
 * scene can have is a column, with about twenty rows a stage. The test may change the scene. */
void every_page(void (*look)(struct nb_scene *scene, const char *name), double budget);
