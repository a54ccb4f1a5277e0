/* The boundary of an assembly: which particles belong to it, and its loading.
 * loading/boundary.c sets it; measure/boundary.c computes the enclosed area and the stress on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "affine.h"

/* The particles of the boundary, and the ellipse inside which the free particles are. The ellipse is a circle when the
 * boundary begins, and then deforms with the strain rate of the boundary. */
struct nb_ring {
  bool exists, held;             /* there is a boundary; its particles follow its strain rate */
  double radius;                 /* of the circle, m */
  struct nb_tensor shape;        /* deformation of the circle: x = centre + shape X with |X| = radius */
  int *member;                   /* slots of its particles, counterclockwise; capacity for all particles */
  size_t count;                  /* number of its particles */
  int *candidates;               /* slots, by number, of particles that may soon cross the ellipse; capacity for all */
  size_t candidate_count;        /* number of candidates */
  struct nb_tensor listed_shape; /* shape when the candidates were listed */
  unsigned long long listed_search; /* 1 + number of searches when the candidates were listed; 0: list them again */
};

struct nb_boundary_state {
  /* Force on each slot from the stress on the boundary, N. model->particles points here while the stress acts. NULL: no
   * stage has a stress on the boundary. */
  struct nb_vec *boundary_force;
  struct nb_tensor stress; /* the stress on the boundary, Pa */
  struct nb_ring ring;
};
