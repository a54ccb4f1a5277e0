/* How large a step a network of springs and dashpots stands: three ways to find out, that know nothing of each other.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LIMIT_H
#define NB_LIMIT_H

#include "lattice.h"

/* Freedoms in units of 1/sqrt(mass), as in lattice.h:  u'' = -K u - C u',  K = stretch' springs stretch, C likewise. */
struct limit {
  struct lattice lattice;
  gsl_vector *dashpots; /* c_n, c_s of each contact in turn, N s/m */
  double keep, push;    /* what a cycle does: v <- keep v + push (F/m) dt; with CS79's global damping at alpha dt = 0 */
  double critical;      /* 2 sqrt(m/k): lightest free mass, stiffest pair of materials, s [CS79, Motion] */
};

/* Of all pairs whose gap is below `reach`, m, damped as `damping` says. NB_BAD_USE when there is none. */
enum nb_status limit_build(struct limit *limit, const struct nb_scene *scene, const struct nb_damping *damping,
                           double reach, struct nb_error *error);
void limit_free(struct limit *limit);

/* The cycle as a matrix that takes (u, v dt) of one cycle to those of the next: the largest modulus of its eigenvalues,
 * above 1 when some free vibration grows. Asks nothing of theory. */
double limit_radius(const struct limit *limit, double step);
/* The largest step for which none grows, by that; s. */
double limit_of_cycle(const struct limit *limit);
/* The same by theory: the largest eigenvalue of dt^2 K + 2 dt C reaches 2 (1 + keep)/push. */
double limit_of_modes(const struct limit *limit);
/* The step that is sure to be stable: every contact by itself, with the share of its bodies' masses that its normal
 * spring and dashpot have in theirs, of their moments of inertia by the tangential ones; each of them six freedoms and
 * their largest eigenvalue. */
double limit_of_parts(const struct limit *limit, const struct nb_scene *scene);

#endif
