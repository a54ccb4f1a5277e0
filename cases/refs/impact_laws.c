/* Simplified shear laws in an oblique impact, each as the differential equation that it becomes for small steps.
 *
 *   none             f = 0
 *   linear           df = k dd,  k = k_s kappa alpha_max/N_max                dT = k_s d(delta)
 *   mindlin          df = (3/2) xi^(1/2) dd                                   dT = 8 G* a d(delta), without micro-slip
 *   mindlin_scaled   as mindlin; while xi decreases plus f dxi/(2 xi)         T proportional to a while N decreases
 *   randall          df = (3/2) xi^(1/2) theta dd +- (1 - theta) dn           two stored reversals [R89 3.94]
 *
 * in the units of impact_springs.h, with n = N/N_max = xi^(3/2). Coulomb's law limits f in all of them: |f| <= n. In
 * `randall`, theta is R89's slip factor [R89 3.95, 3.96]; the sign is the present direction. While N grows, new rings
 * stick (theta = 1) if dd <= dxi, which is d(delta) <= mu dN/(8 G* a) [R89 4.16].
 *
 * The integration is leapfrog, with f and n at the end of a step and xi at its middle. Where df depends on f or theta,
 * the error is of first order in the step. A second run with half the steps removes it from psi2 and from the integral
 * `slid`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impact_springs.h"

/* One step: f at its beginning, n at its end, and the increments of d, xi and n. */
struct step {
  double f, dd, dxi, n, dn, root; /* root: xi^(1/2) at the middle */
  double spring;                  /* k_s kappa alpha_max/N_max */
};

/* The history of `randall`; the other laws have none. */
struct history {
  double sense;   /* direction of the virgin loading, R89's CDF: 1 or -1; 0: none yet */
  bool unloading; /* R89's UFL = -1; reloading does not occur in an impact and counts as loading */
  double star;    /* T*, the force at the reversal, updated as N changes */
  double deficit; /* R89's DD, the displacement after which the rings that still stick begin to slip */
};

/* Each law returns f at the end of the step, before Coulomb's limit, and updates the history m. */
static double none(struct step s, struct history *m) { return (void)m, 0 * s.f; }

static double linear(struct step s, struct history *m) { return (void)m, s.f + s.spring * s.dd; }

static double mindlin(struct step s, struct history *m) { return (void)m, s.f + 1.5 * s.root * s.dd; }

static double mindlin_scaled(struct step s, struct history *m) {
  const double before = s.n - s.dn;
  return mindlin(s, m) + (s.dn < 0 ? cbrt(s.n / before) - 1 : 0) * s.f;
}

/* R89's THETA in the interpretation that agrees best with the exact contact. */
static double randall(struct step s, struct history *m) {
  if (m->sense == 0)
    m->sense = s.dd < 0 ? -1 : 1;
  if (m->unloading)
    m->star += m->sense * s.dn; /* [R89 4.20] */
  double slip = (m->unloading ? -m->sense : m->sense) * s.dd;
  /* A displacement against the present direction is a reversal, unless xi decreases by at least as much. In that case
   * the contact still slips in the present direction. */
  if (slip < 0 && -slip > -s.dxi) {
    m->unloading = !m->unloading;
    m->star = s.f + m->sense * s.dn;
    m->deficit = 0;
    slip = -slip;
  }
  const double fraction = m->unloading ? m->sense * (m->star - s.f) / (2 * s.n) : m->sense * s.f / s.n;
  const double theta = slip > s.dxi + m->deficit ? cbrt(fraction < 0   ? 1
                                                        : fraction > 1 ? 0
                                                                       : 1 - fraction)
                                                 : 1; /* [R89 3.95, 3.96] */
  m->deficit = fmax(m->deficit + s.dxi - slip, 0);
  return s.f + 1.5 * s.root * theta * s.dd + (m->unloading ? -1 : 1) * m->sense * (1 - theta) * s.dn;
}

/* Drops history that has no effect any more. Sliding erases all of it; the direction is then that of f. A reversal is
 * erased when f has reached -T* or come back to T*, and when T* has become 0 because N decreased. */
static void drop_history(struct history *m, double f, bool slides) {
  if (slides)
    *m = (struct history){.sense = copysign(1, f)};
  else if (m->unloading && (m->star * m->sense <= 0 || f * m->sense <= -m->star * m->sense))
    *m = (struct history){.sense = -m->sense};
  else if (m->unloading && (m->star - f) * m->sense <= 0)
    *m = (struct history){.sense = m->sense};
}

static const struct {
  const char *name;
  double (*force)(struct step s, struct history *m);
} laws[] = {
    {"none", none}, {"linear", linear}, {"mindlin", mindlin}, {"mindlin_scaled", mindlin_scaled}, {"randall", randall}};
enum { LAWS = sizeof laws / sizeof *laws };

static int index_of(const char *law) {
  int k = 0;
  while (k < LAWS && strcmp(laws[k].name, law) != 0)
    k++;
  return k;
}

/* One run with the law `which` of laws[]; for the other arguments and the result see impact_law. */
static bool run(struct impact_path *path, int which, double spring, double chi, double psi1, int steps) {
  const double dt = IMPACT_DURATION / steps;
  struct history history = {0};
  if (!impact_path_create(path, steps))
    return false;
  double psi = psi1;
  for (int k = 0; k < steps; k++) {
    const double before = path->xi[k], after = path->xi[k + 1], f = path->f[k], n = after * sqrt(after);
    psi -= 2.5 * chi * f * (k ? dt : dt / 2);
    const struct step step = {f,     psi * dt, after - before, n, n - before * sqrt(before), sqrt((before + after) / 2),
                              spring};
    const double elastic = laws[which].force(step, &history);
    const bool slides = fabs(elastic) > n;
    path->f[k + 1] = slides ? copysign(n, elastic) : elastic;
    path->d[k + 1] = path->d[k] + step.dd;
    path->slides[k + 1] = slides;
    if (slides)
      path->slid += (f + path->f[k + 1]) / 2 * (elastic - path->f[k + 1]) /
                    (laws[which].force == linear ? spring : 1.5 * step.root);
    drop_history(&history, path->f[k + 1], slides);
  }
  path->psi2 = psi;
  return true;
}

/* Two runs, with half of the steps (result a) and with all of them (result b): 2 b - a has no first-order error. */
bool impact_law(struct impact_path *path, const char *law, double spring, double chi, double psi1, int steps) {
  struct impact_path coarse;
  const int which = index_of(law);
  bool made = run(&coarse, which, spring, chi, psi1, steps / 2);
  made = run(path, which, spring, chi, psi1, steps) && made;
  path->psi2 += path->psi2 - coarse.psi2;
  path->slid += path->slid - coarse.slid;
  impact_path_free(&coarse);
  return made;
}
