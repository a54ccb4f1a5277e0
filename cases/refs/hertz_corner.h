/* The error of leapfrog in Hertz's impact without damping, to the lowest order in the step.
 *
 * Within the contact leapfrog conserves a modified energy, which differs from the true one by
 *
 *   H_1 = dt^2 (p^2 U''/(12 m*^2) - U'^2/(24 m*)),    p = m* alpha',   U the stored energy,   U' = dU/d(alpha) = N
 *
 * E is the energy, B Euler's beta function and n = T_c/dt. alpha is the overlap, m; alpha*, T_c, K, m* and V_N are those
 * of hertz.c. The duration of the impact is
 *
 *   T_c - (dt^2/(24 m*)) d/dE Int N^2 dt = T_c - (11/96) B(8/5, 1/2) dt^2 V_N/alpha* = T_c (1 - 0.5104/n^2)
 *
 * At the two ends of the contact, the corners, the force is not smooth: at the time t from a corner it is
 * K (V_N t)^(3/2) inside the contact and 0 outside. The outermost step lies at the time phi dt from the corner. Then
 * the sum of the force over the steps, times dt, differs from the integral of the force over time by
 * zeta(-3/2, phi) K V_N^(3/2) dt^(5/2), with Hurwitz's zeta function (Euler-Maclaurin). The work differs by V_N times
 * this. With K/m* = (5/4) V_N^2/alpha*^(5/2), and phi_in and phi_out at the beginning and the end of the contact,
 *
 *   e - 1 = (5/4) (V_N dt/alpha*)^(5/2) (zeta(-3/2, phi_out) - zeta(-3/2, phi_in))
 *
 * Error    relative: the next order, n^(-5/2) for the duration and n^(-7/2) for the restitution.
 *
 * Source   Hairer, Lubich and Wanner (2006) for H_1; elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

/* T_c minus the duration, in steps of dt = fraction alpha* / V_N. */
double hertz_shortening(double fraction);
/* e - 1 for a first contact `in` steps after the run began and T_c = `steps` dt. */
double hertz_restitution_error(double fraction, double in, double steps);
