/* The largest stable step of a network of springs and dashpots, by three independent methods.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LIMIT_H
#define NB_LIMIT_H

#include "lattice.h"

/* Degrees of freedom in units of 1/sqrt(mass), as in lattice.h:  u'' = -K u - C u',  K = stretch' springs stretch, C likewise. */
struct limit {
  struct lattice lattice;
  gsl_vector *dashpots; /* c_n, c_s of each contact in turn, N s/m */
  double keep, gain;    /* of a cycle: v <- keep v + gain (F/m) dt; with `damping mass` at alpha dt = 0 */
  double
      critical; /* single-contact step 2 sqrt(m/k): lightest free mass, stiffest pair of materials, s [CS79, Motion] */
};

/* For all pairs whose gap is below `largest_gap`, m, with the given damping. NB_BAD_USE when there are none. */
enum nb_status limit_build(struct limit *limit, const struct nb_scene *scene, const struct nb_damping *damping,
                           double largest_gap, struct nb_error *error);
void limit_free(struct limit *limit);

/* The spectral radius of the cycle as a matrix from (u, v dt) to those of the next cycle: above 1 when a free
 * oscillation grows. */
double limit_radius(const struct limit *limit, double step);
/* The largest step for which it is 1, s. */
double limit_of_cycle(const struct limit *limit);
/* The same from theory: the largest eigenvalue of dt^2 K + 2 dt C reaches 2 (1 + keep)/gain. */
double limit_of_modes(const struct limit *limit);
/* The guaranteed stable step: the largest eigenvalue of each contact alone, with six degrees of freedom. A contact has
 * the fraction of the masses of its particles that its normal spring and dashpot have of all theirs, and of the moments
 * of inertia that its tangential ones have. */
double limit_of_contacts(const struct limit *limit, const struct nb_scene *scene);

#endif
