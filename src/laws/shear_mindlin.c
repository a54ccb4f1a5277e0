/* Elastic spheres without micro-slip:        T <- T + 8 G* a ds,  limited to  |T| <= mu N + c
 *
 *   ds   tangential increment of this step, m, as in shear_linear.c
 *   a    radius of the contact circle at the end of the step, m
 *   G*   1/G* = (2 - nu_x)/G_x + (2 - nu_y)/G_y, Pa [R89 4.8-4.10]
 *   mu   the smaller friction, 1;  c the smaller cohesion, N
 *   N    the elastic normal force, without dashpots
 *
 * Source     the stiffness of a contact that sticks everywhere [R89 3.27; 3.94 with theta = 1], with Coulomb's limit
 *            for the whole contact. Widely used; it neglects the slip that begins at the edge.
 * Order      exact at constant N. While N changes, the law is of first order in the step, because it uses the radius at
 *            the end of the step: the error of T is half a step times 8 G* Int (da/dt) ds.
 * Range      as in normal_hertz.c.
 * History    m[0]  T, N.
 * Creates    energy, because T is kept when N falls, although a part of the contact area that carried T has separated.
 *            In the cycle "N increases up to the radius a2, displacement s, N decreases down to the radius a1,
 *            displacement -s" the work is -4 G* (a2 - a1) s^2 (cases/4-oblique/closed-squares.md). So the law has no
 *            stored energy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_shear shear_mindlin(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  const double stiffness = 8 * p.shear * n.radius;
  const double limit = n.force * p.friction + p.cohesion;
  const double trial = n.radius > 0 ? m[0] + stiffness * ds : 0;
  const double size = fabs(trial);
  m[0] = copysign(size > limit ? limit : size, trial);
  return (struct nb_shear){.force = m[0], .stiffness = stiffness, .sliding = size > limit ? 1 : 0};
}

#define LAW shear_mindlin
#define SHEAR
#define ELASTIC
#define TITLE "elastic spheres without micro-slip (mindlin_deresiewicz has it): T += 8 G* a ds, |T| <= mu N + c"
#define SOURCE "[R89 3.27]"
#define PARAMETERS "young, poisson, friction, cohesion"
#define HISTORY 1
#define NON_CONSERVATIVE
#include "law_batch.h"
