/* An oblique impact in dimensionless numbers: shared by several references, such as oblique_impact.c and rebound.c.
 *
 *   overlap     xi = alpha/alpha_max            tangential displacement   d = delta/(mu kappa alpha_max)
 *   forces      N/N_max = xi^(3/2) [Hertz]      shear force               f = T/(mu N_max), by the shear law
 *   time        in units of alpha_max/V_N       compliance ratio          kappa = (E* / G*)/4
 *
 *   xi'' = -(5/4) xi^(3/2),   xi' = 1 at first                                 approach [R89 5.6]
 *   psi' = -(5/2) chi f,      psi = d' = V_T/(mu kappa V_N)                    tangential velocity [R89 5.15]
 *
 * V_N and V_T are the normal and the tangential velocity of the point of contact: V_N at first touch, V_T at the
 * present time. alpha_max and N_max are the largest overlap and normal force of the impact without damping. The
 * parameters are chi = (1 + m R^2/I)/(2 kappa) [R89 5.14] and psi1, the initial psi.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>

/* The time during which xi > 0: (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) [R89 5.12] */
#define IMPACT_DURATION 2.9432751843247047

/* An impact from first contact to separation in equal time steps. The arrays, which it owns, have steps + 1 entries. */
struct impact_path {
  int steps;
  double psi2; /* psi at the end */
  double slid; /* integral of f over the displacement of gross sliding */
  double *xi, *f, *d;
  bool *slides; /* entry k: gross sliding at the end of step k */
};

/* Allocates the arrays and computes xi only; false: out of memory. */
bool impact_path_create(struct impact_path *path, int steps);
/* Returns xi at each of the steps + 1 times, by GSL's Runge-Kutta method of order 8 with the relative tolerance 1e-13.
 * An entry is NAN where GSL failed. NULL: out of memory. Free with free(). */
double *impact_approach(int steps);

/* impact_springs computes the exact contact, impact_law a simplified law. False: out of memory. Call impact_path_free
 * in any case. */
bool impact_springs(struct impact_path *path, double chi, double psi1, int steps);
/* law: a name in impact_laws.c. spring: k_s kappa alpha_max/N_max, used by `linear` only; it is 3/2 if k_s equals
 * 8 G* a at alpha_max. */
bool impact_law(struct impact_path *path, const char *law, double spring, double chi, double psi1, int steps);
/* The exact contact, extrapolated from runs with half of the steps and with all of them. psi2, slid and every second
 * entry of f and d are then without their second-order error. `steps` is rounded down to an even number. */
bool impact_exact(struct impact_path *path, double chi, double psi1, int steps);
/* psi2 with normal and tangential dashpots of the damping ratio beta (impact_damped.c); NAN: out of memory, INFINITY:
 * the contact does not end, or GSL failed. */
double impact_damped(double chi, double kappa, double beta, double psi1, int steps);
/* Updates the deflections u of the springs for a change of xi from `from` to `to` and of d by `slip`. Returns f. Spring
 * i touches while xi > depth[i]; u[i] of a spring that does not touch is not read. *sliding: the gross sliding of the
 * contact. */
double impact_press(double *u, const double *depth, int springs, double from, double to, double slip, double *sliding);
void impact_path_free(struct impact_path *path);
