/* R89's law of elastic spheres with micro-slip, in increments, with a memory of two reversals. Errors of R89's text are
 * corrected:
 *
 *   dT = CDF (theta (8 G* a ds CDF - mu dN UFL) + mu dN UFL),       |T| <= mu N       [R89 4.15]
 *
 *   ds, dN  tangential increment, m, and change of the normal force N, in newtons, in this step
 *   a, G*   radius of the contact circle after the step, m; effective shear modulus, Pa;  mu  the smaller friction, 1
 *   theta   slip factor c/a, c the radius of the stick region, m [R89 4.22-4.24]; 1 if the step only loads sticking
 *           rings outside c [R89 4.25]
 *   CDF     sense of the virgin loading, 1 or -1;  UFL  -1 in unloading, else 1
 *   T*, T** forces at which unloading and reloading began; a change of N moves them to the curves of the new N
 *           [R89 4.20, 4.21]
 *   DD      deficit, m: the rings outside c joined the contact without slip; they slip after a further displacement
 *           DD [R89 4.17]
 *   ds_c    mu dN/(8 G* a), the increment at which a new ring is just at its limit and c does not change
 *           [R89 4.16]
 *
 * The text of R89 on its subroutines FORD and THETA contradicts itself and the exact law in places.
 * shear_randall_literal.c follows the text; this file interprets it as follows:
 *
 *   - A reversal sets T* or T** before theta is computed. `branch` tells whether they have a value, because 0 is a
 *     valid force.
 *   - dN moves T* and T** in every step, including the one that sets them.
 *   - ds is taken in the sense of the branch, after a reversal in that of the new branch. It is negative only while N
 *     falls and a motion slower than |ds_c| opposes the slip. The contact slips if ds > ds_c + DD, whether N rises or
 *     falls. In each step ds_c - ds is added to DD, with either sign, but DD does not fall below 0. DD is 0 until the
 *     first motion; a reversal, the return to virgin loading, and sliding set it to 0 again.
 *   - While N falls, slip continues in the same sense even if ds = 0, and even against a motion with |ds| < |ds_c|.
 *     Only a faster motion is a reversal.
 *   - Re-unloading, between T** and T*, follows the reloading curve, with UFL = 1 as in reloading.
 *   - T* is deleted when reloading reaches T*, when unloading reaches -T*, or when a falling N brings T* to T. T** is
 *     deleted when unloading reaches T**, or when a falling N brings T** to T. Virgin loading has the sense of T, also
 *     if T changed its sign while N fell.
 *   - theta is never negative. Sliding means |T| > mu N, or no sticking region; sliding resets the history.
 *
 * Source     [R89 3.94-3.98, 4.15-4.25], FORD and THETA.
 * Order      first in the step, relative to the law's own limit of small steps, because theta is the value at the
 *            beginning of the step.
 * Range      as in normal_hertz.c. No cohesion, because friction alone limits the traction. In the limit of small steps
 *            the law is exact for up to two nested reversals, while N is constant, falls, or rises so slowly that
 *            |ds| > ds_c. Further inner reversals are elastic [R89 sec. 3.3]. DD is the only record of the rings that
 *            stick as N grows, and a reversal sets it to 0.
 * History    m[0..6]  N of the previous step, 0: none; T, T*, T**, N; DD, m; CDF, 0 before the first motion; branch.
 * Creates    energy: in the cycle N to 2 N, displacement A/5, 2 N to N, displacement -A/5, with A = 3 mu N/(16 G* a),
 *            the law creates 0.0074 mu N A in the second cycle and less in later ones. So it has no stored energy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "randall.h"

enum { LOADING, UNLOADING, RELOADING, REUNLOADING };

struct history {
  double n, t, t_star, t_star2, deficit, cdf, branch;
};

/* x multiplied by CDF; x multiplied by UFL. */
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

/* The slip factor of the current branch; stuck_fraction explains `rise` and `limit`. */
static inline double theta(const struct history *h, double rise, double limit) {
  const double fraction = h->branch == LOADING ? stuck_fraction(along_virgin(h, h->t), 1, rise, limit) /* 3.95 */
                          : h->branch == UNLOADING
                              ? stuck_fraction(along_virgin(h, h->t_star - h->t), 2, rise, limit)   /* 3.96 */
                              : stuck_fraction(along_virgin(h, h->t - h->t_star2), 2, rise, limit); /* 3.97 */
  return fraction < 0 ? 0 : fraction > 1 ? 1 : fraction;
}

/* Returns to an outer branch: when reloading reaches T*, when unloading reaches T** or -T*, or when a falling N brings
 * T* and T** to T. */
static inline void return_to_outer_branch(struct history *h) {
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
    double along =
        along_virgin(&h, h.branch == UNLOADING || h.branch == REUNLOADING ? -ds : ds); /* in the sense of the branch */
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
      return_to_outer_branch(&h);
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
#define TITLE "R89's law with micro-slip, in increments, with two stored reversals, its errors corrected"
#define SOURCE "[R89 3.94-3.98, 4.15-4.25]"
#define PARAMETERS "young, poisson, friction"
#define HISTORY 7
#include "law_batch.h"
