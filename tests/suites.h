/* The suites of unit tests: a file of SUITES in Makefile.am, tests/X.c, defines `void suite_X(void)`, which adds its
 * suite and its tests to CUnit's register. The list is made from SUITES; nothing else has to know of a new suite.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SUITES_H
#define NB_SUITES_H

#define NB_SUITE(name) void suite_##name(void);
#include "suites-register.h"
#undef NB_SUITE

#endif
