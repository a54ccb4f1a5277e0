/* Plane waves in an endless lattice of equal discs: the modes of one wave vector.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_WAVES_H
#define NB_WAVES_H

#include <stdbool.h>

struct waves_lattice {
  double kn, ks;          /* N/m */
  double force;           /* of a contact at rest, N */
  double mass, inertia;   /* kg, kg m2 */
  double radius, spacing; /* m */
  bool hexagonal, turns;  /* six neighbours, one of them to the east, or four; bodies may turn */
};

enum { WAVES_MODES = 3 };
struct waves_modes {
  int count;                               /* 3, or 2 where nothing turns */
  double omega[WAVES_MODES];               /* rad/s, from the slowest */
  double shape[WAVES_MODES][WAVES_MODES];  /* shape[k][i]: of u_x, u_y and psi in mode k, m and rad; */
  double weight[WAVES_MODES][WAVES_MODES]; /* weight[k][i]: how much of mode k a velocity i has, so shape' weight = 1 */
};
struct waves_modes waves_modes(const struct waves_lattice *lattice, double qx, double qy); /* 1/m */

#endif
