/* The motion of Hertz's impact with a dashpot, integrated by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - 2 beta (m* 2 E* a)^(1/2) alpha',   a^2 = R* alpha                  [R89 4.13, 5.6]
 *
 * With s = alpha/alpha*, alpha* the largest overlap without damping, and t in units of alpha* / V_N, beta is the only
 * parameter:
 *
 *   s'' = -(5/4) s^(3/2) - (15/2)^(1/2) beta s^(1/4) s',     s(0) = 0, s'(0) = 1
 *
 * The method is the eighth-order one of Prince and Dormand, with the tolerance 1e-13. To find where an unknown reaches
 * a value, the equations are integrated over that unknown instead of time (Henon 1982).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>

enum { HERTZ_TIME, HERTZ_OVERLAP, HERTZ_SPEED, HERTZ_UNKNOWNS }; /* t, s, s' */
#define HERTZ_FIRST_CONTACT                                                                                            \
  { 0, 0, 1 }

/* Integrates y over its unknown `along`, until this unknown has the value `to`. False: GSL failed. */
bool hertz_integrate(double y[], double beta, int along, double to);
/* Integrates y until s, decreasing, is `end`; stops with s > `end` after the time `longest`. `deepest` receives the
 * state of largest overlap if the motion passes it. False: GSL failed. */
bool hertz_rebound(double y[], double beta, double end, double longest, double deepest[]);
