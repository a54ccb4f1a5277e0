/* How much of a disc lies inside a circle or a polygon: exact, by closed forms.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_AREAS_H
#define NB_AREAS_H

#include <stddef.h>

#include "core/vec.h"

double nb_area_of_disc(double radius);
/* What two circles have in common; `apart`: the distance of their centres. */
double nb_area_of_lens(double radius_a, double radius_b, double distance);
/* What a disc has in common with a polygon whose corners go round counterclockwise. */
double nb_area_in_polygon(struct nb_vec centre, double radius, const struct nb_vec corners[], size_t count);
double nb_area_of_polygon(const struct nb_vec corners[], size_t count);

#endif
