/* The impact of a scene: its state at first touch.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/vec.h"
#include "nineball.h"

struct nb_impact_state {
  struct nb_vec point;    /* centre of the other particle, or nearest point of the wall, m */
  struct nb_vec normal;   /* unit vector at first touch, from `point` to the particle's centre; NaN if they coincide */
  struct nb_vec tangent;  /* the normal rotated clockwise */
  struct nb_vec velocity; /* velocity of the particle's centre relative to the other centre or the wall's P, m/s */
  double surface;         /* sum of R w over the particles, m/s */
  double normal_v, tangent_v; /* V_N, and V_T of the contact along the tangent, m/s [R89 5.15] */
  double mass;                /* M, reduced mass, kg */
  double friction, kappa;     /* mu, 1; kappa, 1 (impact.c) */
  double peak, duration;      /* N_max, N, and T_c, s, of the elastic impact [R89 5.9, 5.12] */
};
struct nb_impact_state nb_impact_incidence(const struct nb_scene *scene);
