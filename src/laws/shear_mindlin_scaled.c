/* As shear_mindlin.c, but when N falls T goes with the radius:    T <- T a/a_before + 8 G* a ds,  cut at  |T| <= mu N + c
 *
 *   a, a_before   radius of the contact circle at the end of this step and of the one before, m; a/a_before < 1 where N fell,
 *                 and 1 is put in its place where it did not
 *   ds, G*, mu, c, N   as in shear_mindlin.c
 *
 * Source     in use wherever shear_mindlin.c was seen to make energy; the increment is [R89 3.27].
 * Order      exact at constant N, first order in the step while N changes, as shear_mindlin.c.
 * Range      as normal_hertz.c.
 * Remembers  m[0]  T, N;   m[1]  a, m.
 * Energy     none is made around any closed path. T^2/(16 G* a), the work of bringing T on at this a, falls when a grows with T as
 *            it is, falls with a when T goes with it, and changes by T ds otherwise: it is never more than the work put in. But it is no
 *            state function of the path, what a change of N takes is lost without sliding: none is declared, shear work is recorded.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_shear shear_mindlin_scaled(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  const double stiffness = 8 * p.shear * n.radius;
  const double limit = n.force * p.friction + p.cohesion;
  const double kept = n.radius < m[1] ? n.radius / m[1] : 1;
  const double trial = kept * m[0] + stiffness * ds; /* 0 where the radius is */
  const double size = fabs(trial);
  m[0] = copysign(size > limit ? limit : size, trial);
  m[1] = n.radius;
  return (struct nb_shear){.force = m[0], .stiffness = stiffness, .sliding = size > limit ? 1 : 0};
}

#define LAW shear_mindlin_scaled
#define SHEAR
#define ELASTIC
#define TITLE "as mindlin, but T goes with the contact's radius when N falls"
#define SOURCE "[R89 3.27]"
#define PARAMETERS "young, poisson, friction, cohesion"
#define HISTORY 2
#include "law_batch.h"
