/* The motion of Hertz's impact with a dashpot, solved from state to state by GSL.
 *
 *   m* alpha'' = -K alpha^(3/2) - 2 beta (m* 2 E* a)^(1/2) alpha',   a^2 = R* alpha                  [R89 4.13, 5.6]
 *
 * With s = alpha/alpha*, t in alpha* / V_N, alpha* that of no damping, nothing is left of the pair but beta:
 *
 *   s'' = -(5/4) s^(3/2) - (15/2)^(1/2) beta s^(1/4) s',     s(0) = 0, s'(0) = 1
 *
 * by the eighth-order method of Prince and Dormand at 1e-13. What shall reach a value is what is integrated along, so that
 * the time when it does need not be sought (Henon 1982).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_HERTZ_MOTION_H
#define NB_HERTZ_MOTION_H

#include <stdbool.h>

enum { HERTZ_TIME, HERTZ_WAY, HERTZ_SPEED, HERTZ_UNKNOWNS }; /* t, s, s' */
#define HERTZ_TOUCH                                                                                                    \
  { 0, 0, 1 }

/* From y along one of its own unknowns to a value of that. False: GSL gave up. */
bool hertz_go(double y[], double beta, int along, double to);
/* On from y by a share of time. Where the way in ends on it, *lowest is the state there; untouched elsewhere. */
bool hertz_tick(double y[], double beta, double fraction, double lowest[]);

#endif
