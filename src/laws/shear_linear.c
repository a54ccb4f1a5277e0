/* The linear spring with a slider:                        F_s <- F_s + k_s ds,  limited to  |F_s| <= F_n tan(phi) + c
 *
 *   ds        tangential increment of this step, m, positive when the first particle moves along t past the second
 *             [CS79 13, 15]
 *   k_s       shear stiffness of the pair, N/m
 *   tan(phi)  the smaller friction of the two materials, 1
 *   c         the smaller cohesion, N; it increases the shear limit of a compressed contact and causes no attraction
 *   F_n       the elastic normal force, without dashpots
 *
 * Source     [CS79 17-19]. A force beyond the limit is reduced to the limit and keeps its sign.
 * Range      any displacement.
 * History    m[0]  F_s, N.
 * Stores     F_s^2 / (2 k_s).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_shear shear_linear(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  const bool touching = n.stiffness > 0;
  const double limit = n.force * p.friction + p.cohesion;
  const double trial = nb_where(touching, m[0] + p.ks * ds); /* without contact there is no sliding */
  const double size = fabs(trial);
  m[0] = copysign(size > limit ? limit : size, trial);
  return (struct nb_shear){
      .force = m[0],
      .stiffness = nb_where(touching, p.ks),
      .sliding = size > limit ? 1 : 0,
  };
}

static double shear_linear_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  (void)n;
  return p.ks > 0 ? m[0] * m[0] / (2 * p.ks) : 0;
}

#define LAW shear_linear
#define SHEAR
#define CONSTANT
#define TITLE "linear spring with Coulomb's limit, F_s += k_s ds, |F_s| <= F_n tan(phi) + c"
#define SOURCE "[CS79 17-19]"
#define PARAMETERS "ks, friction, cohesion"
#define HISTORY 1
#define STORED shear_linear_stored
#include "law_batch.h"
