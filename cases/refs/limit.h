/* The largest stable step of a network of springs and dashpots, by three independent methods.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "lattice.h"

/* d^2u/dt^2 = -K u - C du/dt,   K = stretch^T diag(springs) stretch,   C = stretch^T diag(dashpots) stretch. Every
 * degree of freedom u_i is multiplied by the square root of its mass or moment of inertia (lattice.h), so the mass
 * matrix is the identity. */
struct limit {
  struct lattice lattice;
  gsl_vector *dashpots; /* c_n, c_s of contact 0, of contact 1, ..., N s/m */
  double keep, gain;    /* of a cycle, v <- keep v + gain (F/m) dt; both 1 with `damping mass` (see limit.c) */
  /* single-contact step 2 sqrt(m/k) with the lightest free mass and the stiffest pair of materials, s [CS79, Motion] */
  double single_contact;
};

/* Builds the network of all pairs with a gap below `largest_gap`, m, and the given damping. NB_BAD_USE: no pair, or
 * no spring that moves a particle. */
enum nb_status limit_build(struct limit *limit, const struct nb_scene *scene, const struct nb_damping *damping,
                           double largest_gap, struct nb_error *error);
void limit_free(struct limit *limit);

/* Method 1: the spectral radius of the matrix that maps (u, v dt) of one cycle to those of the next. If it is above 1,
 * a motion grows. INFINITY: GSL failed. */
double limit_radius(const struct limit *limit, double step);
/* The largest step, s, with a spectral radius of at most 1. This and the other two limits are NAN if none is found. */
double limit_of_cycle(const struct limit *limit);
/* Method 2: the step, s, at which the largest eigenvalue of dt^2 K + 2 dt C equals 2 (1 + keep)/gain. */
double limit_of_modes(const struct limit *limit);
/* Method 3: the guaranteed stable step, s. It is the smallest limit of any contact alone, with its two particles and
 * six degrees of freedom. The mass of a particle is divided among its contacts in proportion to their normal springs
 * and dashpots, its moment of inertia in proportion to the tangential ones. */
double limit_of_contacts(const struct limit *limit, const struct nb_scene *scene);
