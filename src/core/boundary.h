/* The boundary of an assembly: which particles belong to it, its loading, and whether particles rotate.
 * loading/boundary.c sets it; measure/boundary.c computes the enclosed area and the stress on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BOUNDARY_H
#define NB_BOUNDARY_H

#include "affine.h"

struct nb_ring {
  bool exists, held;             /* there is a boundary; its particles follow the strain rate */
  double radius;                 /* of the circle when the boundary began, m */
  struct nb_tensor shape;        /* deformation of the circle since then: x = centre + shape X, |X| = radius; 1 */
  int *member;                   /* slots of its particles, counterclockwise; capacity for all */
  size_t count;                  /* number of its particles */
  int *candidates;               /* slots of particles that may cross the circle before the next listing, by number */
  size_t candidate_count;        /* capacity for all */
  struct nb_tensor listed_shape; /* shape at the last listing */
  unsigned long long listed_search; /* number of the search before it; 0: never */
};

struct nb_boundary_state {
  /* For each slot, N: force of a stress on the boundary. model->particles points here while it acts. NULL: no stage has
   * one. */
  struct nb_vec *boundary_force;
  struct nb_tensor stress; /* that stress, Pa */
  bool rotates;            /* `rotation on` */
  struct nb_ring ring;
};

#endif
