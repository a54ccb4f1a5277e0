/* An oblique impact in pure numbers: what oblique_impact.c and its helpers share.
 *
 *   lengths     normal: alpha_max        tangential: mu kappa alpha_max        time: alpha_max/V_N
 *   forces      normal: N_max            tangential: mu N_max                  kappa = (E* / G*)/4
 *
 *   xi'' = -(5/4) xi^(3/2),   xi' = 1 at first                                 approach [R89 5.6]
 *   psi' = -(5/2) chi f,      psi = d' = V_T/(mu kappa V_N)                     slip of the contact [R89 5.15]
 *
 * chi = (1 + m R^2/I)/(2 kappa) [R89 5.14]; with psi1 it is all there is to choose. Hertz: N/N_max = xi^(3/2). What remains is
 * the law of f = T/(mu N_max).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_IMPACT_SPRINGS_H
#define NB_IMPACT_SPRINGS_H

#include <stdbool.h>

#define IMPACT_DURATION 2.9432751843247047 /* of xi > 0: (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) [R89 5.12] */

/* From touch to parting in equal times; steps + 1 entries each. Owns its arrays. */
struct impact_path {
  int steps;
  double psi2; /* at the end */
  double slid; /* integral of f over the sliding of the contact as a whole */
  double *xi, *f, *d;
  bool *slides; /* whether the contact slid as a whole at the end of the step before */
};

/* Nothing yet but xi; false: no memory. */
bool impact_path_create(struct impact_path *path, int steps);
/* Approach alone: xi at each of the steps + 1 times; NULL: no memory. By GSL's Runge-Kutta of order 8 to 1e-13. free() it. */
double *impact_approach(int steps);

/* Either: false when there is no memory; impact_path_free(path) in any case. */
bool impact_springs(struct impact_path *path, double chi, double psi1, int steps);
/* spring: of `linear` alone, k_s kappa alpha_max/N_max, which is 3/2 for k_s = 8 G* a at alpha_max. */
bool impact_law(struct impact_path *path, const char *law, double spring, double chi, double psi1, int steps);
/* Of the exact contact with its error of second order in the step taken out: from half of the steps and all of them. */
bool impact_exact(struct impact_path *path, double chi, double psi1, int steps);
/* With dashpots of the share beta of critical, normal and tangential (impact_damped.c): psi2; NAN: no memory, INFINITY: they
 * do not part, or it cannot be solved. */
double impact_damped(double chi, double kappa, double beta, double psi1, int steps);
/* The springs after xi has gone from `from` to `to` and d by `slip`: f. The spring i touches at xi = depth[i]. *slipped: of the
 * innermost one, which is the last to slip. */
double impact_press(double *u, const double *depth, int springs, double from, double to, double slip, double *slipped);
void impact_path_free(struct impact_path *path);

#endif
