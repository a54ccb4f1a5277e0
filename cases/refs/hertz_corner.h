/* What leapfrog gains or loses in Hertz's impact without damping, to the lowest order in the step.
 *
 * Inside the contact leapfrog keeps the energy, but for what goes to and fro: it follows exactly a motion that differs by
 *
 *   H_1 = dt^2 (p^2 V''/(12 m*^2) - V'^2/(24 m*)),    V' = N
 *
 * from the true one, so with E the energy and B Euler's function the impact takes, n = T_c/dt,
 *
 *   T_c - (dt^2/(24 m*)) d/dE Int N^2 dt = T_c - (11/96) B(8/5, 1/2) dt^2 V_N/alpha* = T_c (1 - 0.5104/n^2)
 *
 * At its two ends the force has a corner, K (V_N t)^(3/2) and nothing before. A sum over steps of which the first lies phi dt
 * inside misses the integral there by zeta(-3/2, phi) K V_N^(3/2) dt^(5/2), zeta Hurwitz's function (Euler and Maclaurin), and
 * the work by V_N times as much: with K/m* = (5/4) V_N^2/alpha*^(5/2)
 *
 *   e - 1 = (5/4) (V_N dt/alpha*)^(5/2) (zeta(-3/2, phi_out) - zeta(-3/2, phi_in))
 *
 * Left out is the next order, n^(-5/2) of the duration and n^(-7/2) of the speed.
 *
 * Source   Hairer, Lubich and Wanner (2006) for H_1; elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_HERTZ_CORNER_H
#define NB_HERTZ_CORNER_H

/* Of steps dt = share alpha* / V_N: by how many of them the impact is sooner over than T_c. */
double hertz_sooner(double fraction);
/* e - 1, when first touch is `in` steps after the run began and T_c is as many steps as said. */
double hertz_gain(double fraction, double in, double steps);

#endif
