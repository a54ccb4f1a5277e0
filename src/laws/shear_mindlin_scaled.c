/* The law of shear_mindlin.c, but T decreases with the contact radius when N falls:
 *
 *   T <- T a/a_before + 8 G* a ds,  limited to  |T| <= mu N + c
 *
 *   a, a_before   radius of the contact circle at the end of this step and of the previous one, m; the ratio is 1
 *                 unless N fell
 *   ds, G*, mu, c, N   as in shear_mindlin.c
 *
 * Source     used in other programs to avoid the energy that the law of shear_mindlin.c creates; the increment is
 *            [R89 3.27].
 * Order      exact at constant N, first order in the step while N changes, as in shear_mindlin.c.
 * Range      as in normal_hertz.c.
 * History    m[0]  T, N;   m[1]  a, m.
 * Energy     No closed path creates energy. T^2/(16 G* a), the work of applying T at this a, decreases when a grows at
 *            constant T, and when T decreases in proportion to a; otherwise it changes by at most T ds. So T^2/(16 G* a)
 *            never exceeds the work done on the contact. But a change of N loses energy without sliding, so the law has
 *            no stored energy; the energy balance counts the shear work instead.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_shear shear_mindlin_scaled(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  const double stiffness = 8 * p.shear * n.radius;
  const double limit = n.force * p.friction + p.cohesion;
  const double kept = n.radius < m[1] ? n.radius / m[1] : 1;
  const double trial = kept * m[0] + stiffness * ds; /* 0 where the radius is 0 */
  const double size = fabs(trial);
  m[0] = copysign(size > limit ? limit : size, trial);
  m[1] = n.radius;
  return (struct nb_shear){.force = m[0], .stiffness = stiffness, .sliding = size > limit ? 1 : 0};
}

#define LAW shear_mindlin_scaled
#define SHEAR
#define ELASTIC
#define TITLE "as mindlin, but T decreases with the contact radius when N falls"
#define SOURCE "[R89 3.27]"
#define PARAMETERS "young, poisson, friction, cohesion"
#define HISTORY 2
#include "law_batch.h"
