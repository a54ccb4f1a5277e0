/* An impact that a page asks for: what the scene says of it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_IMPACT_H
#define NB_IMPACT_H

#include "core/vec.h"
#include "nineball.h"

struct nb_impact_state {
  struct nb_vec point;           /* of what is struck: a body's centre, or the point of a wall that is nearest, m */
  struct nb_vec normal, tangent; /* unit vectors at first touch: from there to the body; clockwise of it */
  struct nb_vec velocity;        /* velocity of the body's centre relative to that point, m/s */
  double surface;                /* sum of R w, m/s */
  double normal_v, tangent_v;    /* V_N, and V_T of the contact along the tangent, m/s [R89 5.15] */
  double mass;                   /* M, reduced, kg */
  double friction, kappa;        /* mu, and kappa: psi = V_T/(mu kappa V_N), 1 */
  double peak, duration;         /* N_max, N; T_c, s: of the elastic impact [R89 5.9, 5.12] */
};
struct nb_impact_state nb_impact_incidence(const struct nb_scene *scene); /* what the scene says of its impact */

#endif
