/* Normal impact of two elastic spheres without damping: largest overlap and duration.              [R89 4.5, 5.9, 5.12]
 *
 *   R*  effective radius, R_1 R_2/(R_1 + R_2), or R_1 for a sphere at a wall, m      v  approach velocity, m/s
 *   M*  reduced mass, kg      E*  effective Young's modulus, Pa      alpha_m  largest overlap, m
 *
 * alpha_m follows from the energy that the force [R89 3.13] stores,
 *
 *   M* v^2/2 = (8/15) E* R*^(1/2) alpha_m^(5/2),      alpha_m = (15 M* v^2/(16 E* R*^(1/2)))^(2/5)
 *
 * and the contact lasts
 *
 *   t = 2 integral from 0 to alpha_m of d(alpha)/(v (1 - (alpha/alpha_m)^(5/2))^(1/2)) = c alpha_m/v
 *   c = (4/5) B(2/5, 1/2) = (4/5) pi^(1/2) Gamma(2/5)/Gamma(9/10) = 2.9432751843247047
 *
 * c is a literal because libraries round tgamma differently.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>

static inline double nb_reduced_radius(double one, double other) { return one * other / (one + other); }

/* alpha_m, m, from E*, R*, M* and v. */
static inline double nb_hertz_depth(double young, double radius, double mass, double speed) {
  return pow(15 * mass * speed * speed / (16 * young * sqrt(radius)), 0.4);
}

/* t, s, from alpha_m and v. */
static inline double nb_hertz_duration(double depth, double speed) { return 2.9432751843247047 * depth / speed; }
