/* The suites of unit tests. A file of SUITES in build-aux/lists.mk, tests/X.c, defines `void suite_X(void)`, which
 * adds its suite and its tests to CUnit's registry. The build makes suites-register.h from SUITES, so a new suite
 * needs no other change.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#define NB_SUITE(name) void suite_##name(void);
#include "suites-register.h"
#undef NB_SUITE

/* Asserts |a - b| <= fraction * |b|. */
#define NEAR(a, b, fraction) CU_ASSERT(fabs((a) - (b)) <= (fraction)*fabs(b))
