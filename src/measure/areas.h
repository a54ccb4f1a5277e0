/* Area of a disc inside a circle or a polygon, exact: areas.c. Areas in m2.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

#include "core/vec.h"

double nb_area_of_disc(double radius);
/* Common area of two circles, m2; `distance`: distance of their centres, m. */
double nb_area_of_lens(double radius_a, double radius_b, double distance);
/* Common area of a disc and a polygon, m2. The corners of the polygon are given counterclockwise. */
double nb_area_in_polygon(struct nb_vec centre, double radius, const struct nb_vec corners[], size_t count);
