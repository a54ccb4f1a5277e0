/* Hertz's contact as R89 coded it, in increments:         N <- N + 2 E* a dn,      a = (3 N R* / 4 E*)^(1/3)
 *
 *   dn      approach in this step, m; in the step of first touch only the part after the touch
 *   a       radius of the contact circle, m, from the force before the step: forward Euler in N(alpha)
 *   E*, R*  as in normal_hertz.c
 *
 * At first touch a is 0, so the first force is  N = (4/3) E* (R* dn^3)^(1/2)  [R89 4.11].
 *
 * Source     [R89 4.11, 4.12, 4.14]. The returned stiffness 2 E* a uses the new a, which the next step reads. R89's
 *            dashpot [R89 4.13] uses the a before the step; the two values of a differ by a term of first order in the
 *            step.
 * Order      first, with an error of one sign: the increment at the old radius is too small while N increases, and too
 *            large while N decreases. After an impact the sphere has 0.971, 0.975 and 0.978 of its speed at 30, 35 and
 *            40 steps per collision (cases/2-hertz/hertz-increment.md), and the force ends while the overlap is still
 *            about a tenth of its largest value.
 * Separation when N <= 0, and then "the contact data is set to zero" (R89, section 4.3.1): N, a, and the history of the
 *            shear law. The particles may still overlap. While they separate, dn is negative, so [R89 4.11] would need
 *            the root of a negative number. Interpretation in this file: there is no force while the particles
 *            separate. If they approach again before the overlap has ended, the contact begins anew, with the force of
 *            4.11. An overlap at time 0 causes no force, because it was never an increment.
 * Range      as in normal_hertz.c.
 * History    m[0]  N of the previous step, N.
 * Stores     (2/5) N a^2/R*, the energy of Hertz's contact at the force N. No step creates energy: the work of the mean
 *            of N over the step exceeds the change of the stored energy by a second-order term, on loading and on
 *            unloading.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline double normal_hertz_increment_radius(struct nb_pair p, double force) {
  return cbrt(0.75 * force * p.radius / p.young);
}

static inline struct nb_normal normal_hertz_increment(struct nb_pair p, double overlap, double dn, double m[]) {
  const double since_touch = nb_touch_fraction(overlap, dn) * dn;
  double force = 0;
  if (m[0] > 0)
    force = m[0] + 2 * p.young * normal_hertz_increment_radius(p, m[0]) * since_touch;
  else if (since_touch > 0)
    force = 4.0 / 3.0 * p.young * (sqrt(p.radius * since_touch) * since_touch);
  m[0] = overlap > 0 && force > 0 ? force : 0;
  const double a = normal_hertz_increment_radius(p, m[0]);
  return (struct nb_normal){.force = m[0], .stiffness = 2 * p.young * a, .radius = a};
}

static double normal_hertz_increment_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  (void)m;
  return 0.4 * n.force * (n.radius * n.radius / p.radius);
}

#define LAW normal_hertz_increment
#define NORMAL
#define ELASTIC
#define TITLE "elastic spheres in increments, N += 2 E* a dn [R89]: an impact of 30-40 steps loses 2-3 % of the speed"
#define SOURCE "[R89 4.11, 4.12, 4.14]"
#define PARAMETERS "young, poisson"
#define HISTORY 1
#define NEEDS NB_BIT(NB_NORMAL_INCREMENT)
#define BRANCHING
#define INCREMENTAL
#define STORED normal_hertz_increment_stored
#include "law_batch.h"
