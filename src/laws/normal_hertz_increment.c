/* Hertz's contact as R89 coded it, by increments:         N <- N + 2 E* a dn,      a = (3 N R* / 4 E*)^(1/3)
 *
 *   dn      approach over this step, m; of a step in which they came to touch, the share behind the touch
 *   a       radius of the contact circle, m, of the force before the step: forward Euler in N(alpha)
 *   E*, R*  as in normal_hertz.c
 *
 * Where there was no force there is no radius, and the first one is  N = (4/3) E* (R* dn^3)^(1/2)  [R89 4.11].
 *
 * Source     [R89 4.11, 4.12, 4.14]. The stiffness answered is that of the step to come, 2 E* a with the a of now; R89's dashpot
 *            [R89 4.13] has the a before it, which is the same to first order.
 * Order      first, and always to one side: dn at the old radius is too little while N grows and too much while it falls. A blow
 *            comes back with 0.971, 0.975 and 0.978 of its speed at 30, 35 and 40 steps a contact (cases/2-hertz/hertz-increment.md), and the force is
 *            gone before the overlap is, at a tenth of the largest one.
 * Parting    when N <= 0, and then "the contact data is set to zero" (4.3.1): N, a, and with them what a shear law
 *            remembers. The outlines may still overlap; R89's [4.11] would then want the root of a negative number. Read here:
 *            no force while they go apart, and a first touch anew, by 4.11, should they come closer before they have parted. An overlap that is
 *            there at time 0 has never been an increment, and presses with nothing.
 * Range      as normal_hertz.c.
 * Remembers  m[0]  N, N.
 * Stores     (2/5) N a^2/R*, the work of Hertz's contact under that N. A step never gives back more than it takes from there: with
 *            the mean of N over the step the work is more than that by a term of second order, going in and coming out.
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
#define TITLE "elastic spheres by increments, N += 2 E* a closing, as R89 coded it: loses 2-3 % of the speed"
#define SOURCE "[R89 4.11, 4.12, 4.14]"
#define PARAMETERS "young, poisson"
#define HISTORY 1
#define NEEDS NB_BIT(NB_NORMAL_INCREMENT)
#define BRANCHING
#define INCREMENTAL
#define STORED normal_hertz_increment_stored
#include "law_batch.h"
