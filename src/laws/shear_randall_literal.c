/* R89's law exactly as the text of FORD and THETA gives it, to demonstrate its errors; for computations use
 * shear_randall.c, which also explains the symbols.
 *
 *   dT = CDF (theta (8 G* a ds CDF - mu dN UFL) + mu dN UFL)                         [R89 4.15]
 *
 * In the text T* and T** are 0 while they have no value. They are set after dT has been computed, and the dN of that
 * step does not move them. UFL is -1 in re-unloading too. theta of reloading uses T* instead of T** [R89 4.24], and
 * nothing limits theta to 1. The critical increment ds_c contains mu twice. DD decreases by |ds_c| in every step with a
 * displacement in which N falls [R89 4.18], increases by ds_c + |ds| in other steps of unloading, and is never set to 0.
 *
 * This file makes these choices where the text cannot be coded or says nothing:
 *
 *   - Chapter 3 has positive forces only. Sliding is |T| > mu N, with the sign of T; the increment compared with
 *     ds_c + DD is ds CDF.
 *   - CDF is the sign of T*, or the sign of T while T* is 0, or the sign of ds while both are 0.
 *   - Virgin loading resumes where |T| >= |T*|, by which THETA distinguishes it from reloading; T** is deleted where T
 *     CDF <= T** CDF.
 *   - If theta is the root of a negative number, the negative real root is used, and T is limited to mu N. The contact
 *     stiffness 8 G* a theta is then 0; otherwise critical damping, which uses the root of the stiffness, would have no
 *     value [R89 4.19].
 *
 * With mu twice in the critical increment, a contact that should stick slides from first touch on: T and mu N then
 * agree except for their last bits, and these bits decide whether dT < mu dN. In one impact the normalised angle of
 * rebound psi2 is then 0.369 or 0.195; the exact value is 0.045 (tests/randall_exact.c).
 *
 * Source     [R89 4.15-4.25], FORD and THETA.
 * Range      as in shear_randall.c. In the limit of small steps the law is exact in virgin loading at constant N, and
 *            almost nowhere else.
 * History    m[0..4]  N of the previous step, 0: none; T, T*, T**, N; DD, m.
 * Creates    energy: in the cycle given in shear_randall.c, 0.0067 mu N A the first time and 0.0113 mu N A in each of
 *            the next five cycles.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "randall.h"

struct history {
  double n, t, t_star, t_star2, deficit;
};

/* THE1, which selects the equation of theta. */
enum the1 { VIRGIN = 1, UNLOADING, RELOADING, STICKING };

/* `back`: CDF is -1; `along`: ds CDF. */
static inline enum the1 the1_of(const struct history *h, bool back, double along) {
  if (along > 0)
    return fabs(h->t) < fabs(h->t_star) ? RELOADING : VIRGIN;
  return h->t_star2 != 0 && flip_if(back, h->t) > flip_if(back, h->t_star2) ? RELOADING : UNLOADING;
}

/* The slip factor; `back`: CDF is -1; stuck_fraction explains `rise` and `limit`. */
static inline double theta(const struct history *h, enum the1 the1, bool back, double rise, double limit) {
  switch (the1) {
  case VIRGIN:
    return stuck_fraction(flip_if(back, h->t), 1, rise, limit); /* 4.22 */
  case UNLOADING:
    return stuck_fraction(flip_if(back, h->t_star - h->t), 2, rise, limit); /* 4.23 */
  case RELOADING:
    return stuck_fraction(flip_if(back, h->t - h->t_star), 2, rise, limit); /* 4.24 */
  case STICKING:
    break;
  }
  return 1; /* 4.25 */
}

/* FORD, from the direction of loading to the test for load reversals. Returns the stiffness. */
static inline double ford_increment(struct history *h, double ds, double stiffness, double rise, double limit,
                                    double mu, bool *reversed) {
  const bool back = h->t_star != 0 ? h->t_star < 0 : h->t != 0 ? h->t < 0 : ds < 0; /* CDF = -1 */
  const double along = flip_if(back, ds), critical = rise / stiffness;              /* 4.16 */
  enum the1 the1 = the1_of(h, back, along);
  if (rise > 0 && along < mu * critical + h->deficit)
    the1 = STICKING;
  const double fraction = theta(h, the1, back, rise, limit), before = h->t;
  const double dt = increment(fraction, stiffness * ds, flip_if(ds < 0, rise)); /* CDF UFL is the sense of ds */
  if (rise < 0)
    h->deficit += critical; /* 4.18 */
  else if (flip_if(back, dt) < rise || h->deficit > 0)
    h->deficit += critical - along; /* 4.17 */
  const bool unloads = along < 0 && h->t_star == 0 && h->t_star2 == 0;
  const bool reloads = along > 0 && h->t_star != 0 && h->t_star2 == 0;
  if (unloads)
    h->t_star = before;
  if (reloads)
    h->t_star2 = before;
  h->t += dt;
  *reversed = unloads || reloads;
  return fraction > 0 ? fraction * stiffness : 0;
}

static inline struct nb_shear shear_randall_literal(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  struct history h = {0};
  if (m[0] > 0)
    memcpy(&h, m, sizeof h);
  const double limit = p.friction * n.force, rise = p.friction * (n.force - h.n);
  double stiffness = 8 * p.shear * n.radius;
  bool reversed = false;
  if (ds != 0 && limit > 0)
    stiffness = ford_increment(&h, ds, stiffness, rise, limit, p.friction, &reversed);
  const bool slides = limit > 0 ? !(fabs(h.t) <= limit) : ds != 0;
  if (!(fabs(h.t) <= limit)) /* also if the limit is 0, when ford_increment is not called */
    h.t = copysign(limit, h.t);
  const bool back = h.t_star < 0;
  if (h.t_star != 0 && !reversed)
    h.t_star += flip_if(back, rise); /* 4.20 */
  if (h.t_star2 != 0 && !reversed)
    h.t_star2 -= flip_if(back, rise); /* 4.21 */
  if (fabs(h.t) >= fabs(h.t_star))
    h.t_star = h.t_star2 = 0;
  if (flip_if(back, h.t) <= flip_if(back, h.t_star2))
    h.t_star2 = 0;
  h.n = n.force;
  memcpy(m, &h, sizeof h);
  return (struct nb_shear){.force = h.t, .stiffness = stiffness, .sliding = slides};
}

#define LAW shear_randall_literal
#define SHEAR
#define ELASTIC
#define BRANCHING
#define COHESIONLESS
#define NON_CONSERVATIVE
#define TITLE "R89's law exactly as the text of FORD and THETA is printed, for comparison"
#define SOURCE "[R89 4.15-4.25]"
#define PARAMETERS "young, poisson, friction"
#define HISTORY 5
#include "law_batch.h"
