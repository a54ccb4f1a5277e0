/* Hertz's contact of two elastic spheres:                    N = (4/3) E* R*^(1/2) alpha^(3/2)
 *
 *   alpha   overlap, m, >= 0
 *   a       radius of the contact circle, a^2 = R* alpha, m
 *   E*, R*  1/E* = (1 - nu_x^2)/E_x + (1 - nu_y^2)/E_y, Pa;  1/R* = 1/R_x + 1/R_y, m
 *
 * Source     [R89 3.13]; a from [R89 3.12]; dN/d(alpha) = 2 E* a [R89 3.15]. The force is a function of the overlap, so
 *            it does not drift. R89 coded increments of the force: normal_hertz_increment.c.
 * Range      smooth elastic spheres whose contact radius a is small compared with R*. R89 assumes plastic flow above an
 *            overlap of 7 % of the smaller diameter [R89 sec. 6.4.3].
 * History    none.
 * Stores     the integral of N, (2/5) N alpha.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_normal normal_hertz(struct nb_pair p, double overlap, double dn, double m[]) {
  (void)dn, (void)m;
  const double a = sqrt(p.radius * overlap), stiffness = 2 * p.young * a;
  return (struct nb_normal){.force = 2.0 / 3.0 * (stiffness * overlap), .stiffness = stiffness, .radius = a};
}

static double normal_hertz_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  (void)p, (void)m;
  return 0.4 * (n.force * n.overlap);
}

#define LAW normal_hertz
#define NORMAL
#define ELASTIC
#define TITLE "elastic spheres, N = (4/3) E* R*^(1/2) overlap^(3/2)"
#define SOURCE "[R89 3.13]"
#define PARAMETERS "young, poisson"
#define HISTORY 0
#define STORED normal_hertz_stored
#include "law_batch.h"
