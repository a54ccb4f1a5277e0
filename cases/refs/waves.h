/* Plane waves in an infinite lattice of equal discs: the modes of one wave vector.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>

struct waves_lattice {
  double kn, ks;          /* N/m */
  double force;           /* of a contact at rest, N */
  double mass, inertia;   /* kg, kg m2 */
  double radius, spacing; /* m */
  bool hexagonal;         /* six neighbours, one of them in +x; else four */
  bool rotates;           /* the discs are free to rotate */
};

enum { WAVES_MODES = 3 };
struct waves_modes {
  int count;                               /* 3, or 2 without rotation */
  double omega[WAVES_MODES];               /* rad/s, ascending; NAN: the wave grows */
  double shape[WAVES_MODES][WAVES_MODES];  /* shape[k]: displacements u_x, u_y and rotation psi in mode k */
  double weight[WAVES_MODES][WAVES_MODES]; /* weight[k][i]: amplitude of mode k per unit of velocity i */
};
/* The modes of the wave vector (qx, qy), 1/m. Shapes and weights are NAN if GSL failed. */
struct waves_modes waves_modes(const struct waves_lattice *lattice, double qx, double qy);
