/* The impact of a scene: its state at first touch.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_IMPACT_H
#define NB_IMPACT_H

#include "core/vec.h"
#include "nineball.h"

struct nb_impact_state {
  struct nb_vec point;        /* of the other partner: centre of a particle, or nearest point of a wall, m */
  struct nb_vec normal;       /* unit vector at first touch, from that point to the particle */
  struct nb_vec tangent;      /* the normal rotated clockwise */
  struct nb_vec velocity;     /* of the particle's centre relative to that point, m/s */
  double surface;             /* sum of R w, m/s */
  double normal_v, tangent_v; /* V_N, and V_T of the contact along the tangent, m/s [R89 5.15] */
  double mass;                /* M, reduced, kg */
  double friction, kappa;     /* mu, and kappa: psi = V_T/(mu kappa V_N), 1 */
  double peak, duration;      /* N_max, N; T_c, s: of the elastic impact [R89 5.9, 5.12] */
};
struct nb_impact_state nb_impact_incidence(const struct nb_scene *scene);
#endif
