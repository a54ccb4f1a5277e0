/* How many bits of an expected quantity do not depend on rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BITS_H
#define NB_BITS_H

#include "outcome.h"

enum { NB_ALL_BITS = 53 };

/* Leading bits that a value has in common with the one rounded to nearest, relative to the scale: 0 to 53. */
int nb_common_bits(double value, double nearest, double scale);
/* Whether the quantity has digits: not if it is a residual, or within its absolute tolerance during the whole run. */
bool nb_expected_has_bits(const struct nb_page_run *nearest, size_t index);
/* The bits that expectation number `index` has in common in two runs, the second one rounded to nearest: for a curve
 * the fewest of its rows. 53 if it has no digits, 0 if it is not defined. */
int nb_expected_bits(const struct nb_page_run *run, const struct nb_page_run *nearest, size_t index);

#endif
