/* The boundary of an assembly: which particles belong to it, and its loading.
 * loading/boundary.c sets it; measure/boundary.c computes the enclosed area and the stress on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BOUNDARY_H
#define NB_BOUNDARY_H

#include "affine.h"

struct nb_ring {
  bool exists, held;                /* there is a boundary; its particles follow the strain rate */
  double radius;                    /* of the circle when the boundary began, m */
  struct nb_tensor shape;           /* its deformation since then, 1: now x = centre + shape X, |X| = radius */
  int *member;                      /* slots of its particles, counterclockwise; capacity for all */
  size_t count;                     /* number of its particles */
  int *candidates;                  /* slots of particles that may soon cross the circle, by number; capacity for all */
  size_t candidate_count;           /* number of candidates */
  struct nb_tensor listed_shape;    /* shape when the candidates were listed */
  unsigned long long listed_search; /* number of searches made by then; 0: they must be listed again */
};

struct nb_boundary_state {
  /* For each slot, N: force of a stress on the boundary. model->particles points here while it acts. NULL: no stage has
   * one. */
  struct nb_vec *boundary_force;
  struct nb_tensor stress; /* that stress, Pa */
  struct nb_ring ring;
};

#endif
