/* R89's law of elastic spheres with micro-slip, in increments, with two reversals remembered, in its best reading:
 *
 *   dT = CDF (theta (8 G* a ds CDF - mu dN UFL) + mu dN UFL),       |T| <= mu N       [R89 4.15]
 *
 *   ds, dN  slip, m, and change of normal force, N, over this step;  a  the radius after it, m
 *   theta   c/a, c the front of slip: [R89 4.22-4.24], 1 while the step only makes up for what sticks outside of c [R89 4.25]
 *   CDF     sense of the virgin loading;  UFL  -1 in unloading, else 1
 *   T*, T** forces from which unloading and reloading began; they keep their places on the curves of the new N [R89 4.20, 4.21]
 *   DD      deficit of the rings that stuck as they grew, m: what they lack of full slip in the sense of the motion [R89 4.17]
 *   ds_c    mu dN/(8 G* a), the slip with which a new ring neither sticks nor lets the front go in [R89 4.16]
 *
 * The text of FORD and THETA contradicts itself and the exact contact in places; shear_randall_literal.c is the text as it
 * stands. Here:
 *
 *   - A reversal sets T* or T** before theta is asked for; whether they have a value is in the branch, for 0 is a force like any.
 *   - dN moves T* and T** in every step, the one that sets them too.
 *   - Slip is compared in the sense of the motion, |ds| > ds_c + DD, for N rising and falling; DD grows by ds_c - |ds| either
 *     way, not below 0. It starts anew with a reversal, virgin loading and sliding, and does not begin before something moves.
 *   - While N falls slip goes on in its sense, with ds = 0 and against slower motion than |ds_c|: only faster is a reversal.
 *   - Re-unloading, between T** and T*, goes back along the reloading curve, with UFL = 1 as in reloading.
 *   - T* is forgotten when reloading reaches T*, unloading -T*, or T* falls to T since N did; T** likewise. Virgin loading has
 *     the sense of T, also where T has come through 0 as N fell.
 *   - theta is never negative. Sliding is |T| > mu N, or no front left; it forgets all.
 *
 * Source     [R89 3.94-3.98, 4.15-4.25], FORD and THETA.
 * Order      first in the step, of the law that it is in the limit: theta is that of the step's beginning.
 * Range      as normal_hertz.c; friction of the stress, so no cohesion. Exact in that limit while N is constant or falls, and
 *            where it rises slower than slip goes on, |ds| > ds_c, for up to two nested reversals. Of more, the inner ones are
 *            elastic [R89 3.3]. Rings that stick as N grows are one number, DD, and forgotten at a reversal.
 * Remembers  m[0..6]  N of the step before, 0: nothing yet; T, T*, T**, N; DD, m; CDF, 0 before anything moved; branch.
 * Gains      energy: around a closed square of N and ds, from N to 2 N and out by A/5, A = 3 mu N/(16 G* a), 0.0074 mu N A in
 *            the second round and less in those after it. So it has no stored energy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "randall.h"

enum { LOADING, UNLOADING, RELOADING, REUNLOADING };

struct history {
  double n, t, t_star, t_star2, deficit, cdf, branch;
};

/* In the sense of the virgin loading, CDF; and UFL. */
static inline double along_virgin(const struct history *h, double x) { return flip_if(h->cdf < 0, x); }
static inline double unloading(const struct history *h, double x) { return flip_if(h->branch == UNLOADING, x); }

static inline void reverse(struct history *h) {
  if (h->branch == LOADING)
    h->t_star = h->t;
  if (h->branch == UNLOADING)
    h->t_star2 = h->t;
  h->branch = h->branch == REUNLOADING ? RELOADING : h->branch + 1;
  h->deficit = 0;
}

static inline double theta(const struct history *h, double rise, double limit) {
  const double fraction = h->branch == LOADING ? stuck_fraction(along_virgin(h, h->t), 1, rise, limit) /* 3.95 */
                          : h->branch == UNLOADING
                              ? stuck_fraction(along_virgin(h, h->t_star - h->t), 2, rise, limit)   /* 3.96 */
                              : stuck_fraction(along_virgin(h, h->t - h->t_star2), 2, rise, limit); /* 3.97 */
  return fraction < 0 ? 0 : fraction > 1 ? 1 : fraction;
}

/* What has been undone: reloading reaches T*, unloading T** or -T*, or N has fallen so that T* and T** come to T. */
static inline void forget(struct history *h) {
  const double t = along_virgin(h, h->t), t_star = along_virgin(h, h->t_star), t_star2 = along_virgin(h, h->t_star2);
  if (h->branch > UNLOADING && t <= t_star2)
    h->branch = UNLOADING;
  if (h->branch != LOADING && fabs(t) >= t_star)
    h->branch = LOADING, h->deficit = 0;
  if (h->branch == LOADING && t < 0)
    h->cdf = -h->cdf, h->deficit = 0;
}

static inline struct nb_shear shear_randall(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  struct history h = {0};
  if (m[0] > 0)
    memcpy(&h, m, sizeof h);
  const double stiffness = 8 * p.shear * n.radius, limit = p.friction * n.force, rise = p.friction * (n.force - h.n);
  const double critical = rise / stiffness; /* 4.16 */
  double fraction = 1;
  bool slides = false;
  h.n = n.force;
  if (!(limit > 0)) /* no friction */
    h = (struct history){.n = n.force}, slides = ds != 0;
  else if (h.cdf == 0)
    h.cdf = ds > 0 ? 1 : ds < 0 ? -1 : 0;
  if (h.cdf != 0) {
    double along = along_virgin(&h, h.branch == UNLOADING || h.branch == REUNLOADING ? -ds : ds); /* on in its sense */
    if (along < 0 && -along > -critical)
      reverse(&h), along = -along;
    fraction = along > critical + h.deficit ? theta(&h, rise, limit) : 1;
    const double deficit = h.deficit + critical - along; /* 4.17 */
    h.deficit = deficit > 0 ? deficit : 0;
    h.t += increment(fraction, stiffness * ds, unloading(&h, along_virgin(&h, rise)));
    h.t_star += along_virgin(&h, rise), h.t_star2 -= along_virgin(&h, rise); /* 4.20, 4.21 */
    slides = !(fabs(h.t) <= limit && fraction > 0);
    if (slides)
      h = (struct history){.n = h.n, .t = copysign(limit, h.t), .cdf = copysign(1, h.t)};
    else
      forget(&h);
  }
  memcpy(m, &h, sizeof h);
  return (struct nb_shear){.force = h.t, .stiffness = fraction * stiffness, .sliding = slides};
}

#define LAW shear_randall
#define SHEAR
#define ELASTIC
#define BRANCHING
#define COHESIONLESS
#define NON_CONSERVATIVE
#define TITLE "elastic spheres with micro-slip in increments, two reversals remembered, best reading"
#define SOURCE "[R89 3.94-3.98, 4.15-4.25]"
#define PARAMETERS "young, poisson, friction"
#define HISTORY 7
#include "law_batch.h"
