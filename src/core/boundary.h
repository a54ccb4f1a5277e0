/* The boundary of an assembly: which particles belong to it, and whether particles turn. loading/boundary.c sets it; measure/boundary.c
 * says what it encloses and the stress on it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BOUNDARY_H
#define NB_BOUNDARY_H

#include "affine.h"

struct nb_ring {
  bool exists, held;      /* there is one; its bodies follow the strain rate */
  double radius;          /* of the circle as it was when it began, m */
  struct nb_tensor shape; /* what the circle has been carried to: x = centre + shape X, |X| = radius; 1 */
  int *member;            /* slots of its bodies, counterclockwise; room for all */
  size_t count;           /* how many */
  int *candidates;        /* slots of bodies that may come to cross it before they are looked for again, by number */
  size_t candidate_count; /* room for all */
  struct nb_tensor listed_shape;    /* its shape then, */
  unsigned long long listed_search; /* and after which search that was; 0: never */
};

struct nb_boundary_state {
  struct nb_vec *boundary_force; /* per slot: force of a stress on the boundary, N, in force where model->bodies.pressed
                            is this; NULL: no stage has one */
  struct nb_tensor stress;       /* and which, Pa */
  bool rotates;                  /* `rotation on` */
  struct nb_ring ring;
};

#endif
