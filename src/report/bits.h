/* The number of bits of an expected quantity that do not depend on rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "outcome.h"

enum { NB_ALL_BITS = 53 };

/* Number of leading bits, relative to the scale, that `value` has in common with `nearest`, the value of a run that
 * rounds to nearest: 0 to 53. */
int nb_common_bits(double value, double nearest, double scale);
/* True if the quantity of an expectation has leading bits to compare. A residual has none, and a quantity that is
 * within its absolute tolerance during the whole run has none. */
bool nb_expected_has_bits(const struct nb_page_run *nearest, size_t index);
/* The number of bits that the values of expectation number `index` have in common in two runs, of which the second one
 * rounds to nearest. For a curve it is the smallest number of all rows. 53 if the quantity has no leading bits to
 * compare, 0 if its value is undefined. */
int nb_expected_bits(const struct nb_page_run *run, const struct nb_page_run *nearest, size_t index);
