/* Simplified laws in an oblique impact, each as the ordinary differential equation that it is in the limit of small steps.
 *
 *   mindlin          df = (3/2) xi^(1/2) dd                                   dT = 8 G* a d(delta): no slip but as a whole
 *   mindlin_scaled   and besides df = f dxi/(2 xi) while xi falls              T goes with a when N falls
 *   randall          df = (3/2) xi^(1/2) theta dd +- (1 - theta) dn            two reversals remembered [R89 3.94]
 *   linear           df = k dd                                                dT = k_s d(delta), k = k_s kappa alpha_max/N_max
 *   none             f = 0
 *
 * all with |f| <= n = xi^(3/2), Coulomb's law. In the scale of impact_springs.h, where the step of slip beside which a new ring
 * sticks, mu dN/(8 G* a), is dxi.
 *
 * Leapfrog; f and n at the end of a step, xi at its middle: of first order where f or theta are in the law, which is taken out of
 * what is known of the end by a second run with half of the steps.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impact_springs.h"

/* One step: slip dd, approach dxi, and where they lead. */
struct step {
  double f, dd, dxi, n, dn, root; /* root: xi^(1/2) at its middle */
  double spring;                  /* k_s kappa alpha_max/N_max */
};

/* What a law remembers; only `randall` does. */
struct memory {
  double sense;   /* of the loading: 1, -1; the text's CDF */
  bool unloading; /* UFL = -1; what an impact does not do, reloading, counts as loading */
  double star;    /* T*, the force at the reversal, and what has become of it */
  double deficit; /* DD, slip that the rings which stuck still have to make up for */
};

static double none(struct step s, struct memory *m) { return (void)m, 0 * s.f; }

static double linear(struct step s, struct memory *m) { return (void)m, s.f + s.spring * s.dd; }

static double mindlin(struct step s, struct memory *m) { return (void)m, s.f + 1.5 * s.root * s.dd; }

static double mindlin_scaled(struct step s, struct memory *m) {
  const double before = s.n - s.dn;
  return mindlin(s, m) + (s.dn < 0 ? cbrt(s.n / before) - 1 : 0) * s.f;
}

/* In the reading that agrees best with the exact contact (R89's THETA, and what must be read into it). */
static double randall(struct step s, struct memory *m) {
  if (m->sense == 0)
    m->sense = s.dd < 0 ? -1 : 1;
  if (m->unloading)
    m->star += m->sense * s.dn; /* 4.20 */
  double slip = (m->unloading ? -m->sense : m->sense) * s.dd;
  if (slip < 0 && -slip > -s.dxi) { /* while N falls slip goes on, unless the motion turns faster than that */
    m->unloading = !m->unloading;
    m->star = s.f + m->sense * s.dn;
    m->deficit = 0;
    slip = -slip;
  }
  const double fraction = m->unloading ? m->sense * (m->star - s.f) / (2 * s.n) : m->sense * s.f / s.n;
  const double theta = slip > s.dxi + m->deficit ? cbrt(fraction < 0   ? 1
                                                        : fraction > 1 ? 0
                                                                       : 1 - fraction)
                                                 : 1; /* 3.95, 3.96 */
  m->deficit = fmax(m->deficit + s.dxi - slip, 0);
  return s.f + 1.5 * s.root * theta * s.dd + (m->unloading ? -1 : 1) * m->sense * (1 - theta) * s.dn;
}

/* What makes it forget: sliding; a reversal undone in full, or one whose ring has left the contact. */
static void forget(struct memory *m, double f, bool slides) {
  if (slides)
    *m = (struct memory){.sense = copysign(1, f)};
  else if (m->unloading && (m->star * m->sense <= 0 || f * m->sense <= -m->star * m->sense))
    *m = (struct memory){.sense = -m->sense};
  else if (m->unloading && (m->star - f) * m->sense <= 0)
    *m = (struct memory){.sense = m->sense};
}

static const struct {
  const char *name;
  double (*force)(struct step s, struct memory *m);
} laws[] = {
    {"none", none}, {"linear", linear}, {"mindlin", mindlin}, {"mindlin_scaled", mindlin_scaled}, {"randall", randall}};
enum { LAWS = sizeof laws / sizeof *laws };

static int find(const char *law) {
  int k = 0;
  while (k < LAWS && strcmp(laws[k].name, law) != 0)
    k++;
  return k;
}

static bool run(struct impact_path *path, int which, double spring, double chi, double psi1, int steps) {
  const double dt = IMPACT_DURATION / steps;
  struct memory memory = {0};
  if (!impact_path_create(path, steps))
    return false;
  double psi = psi1;
  for (int k = 0; k < steps; k++) {
    const double from = path->xi[k], to = path->xi[k + 1], f = path->f[k], n = to * sqrt(to);
    psi -= 2.5 * chi * f * (k ? dt : dt / 2);
    const struct step step = {f, psi * dt, to - from, n, n - from * sqrt(from), sqrt((from + to) / 2), spring};
    const double elastic = laws[which].force(step, &memory);
    const bool slides = fabs(elastic) > n;
    path->f[k + 1] = slides ? copysign(n, elastic) : elastic;
    path->d[k + 1] = path->d[k] + step.dd;
    path->slides[k + 1] = slides;
    if (slides)
      path->slid += (f + path->f[k + 1]) / 2 * (elastic - path->f[k + 1]) /
                    (laws[which].force == linear ? spring : 1.5 * step.root);
    forget(&memory, path->f[k + 1], slides);
  }
  path->psi2 = psi;
  return true;
}

/* Twice, for 2 b - a has no error of first order. */
bool impact_law(struct impact_path *path, const char *law, double spring, double chi, double psi1, int steps) {
  struct impact_path coarse;
  const int which = find(law);
  bool made = run(&coarse, which, spring, chi, psi1, steps / 2);
  made = run(path, which, spring, chi, psi1, steps) && made;
  path->psi2 += path->psi2 - coarse.psi2;
  path->slid += path->slid - coarse.slid;
  impact_path_free(&coarse);
  return made;
}
