/* Simplified laws in an oblique impact, each as the ordinary differential equation that it is in the limit of small steps.
 *
 *   mindlin          df = (3/2) xi^(1/2) dd                                   dT = 8 G* a d(delta): no slip but as a whole
 *   mindlin_scaled   and besides df = f dxi/(2 xi) while xi falls              T goes with a when N falls
 *   none             f = 0
 *
 * all with |f| <= xi^(3/2), Coulomb's law. In the scale of impact_springs.h. The midpoint of each step; what is above the limit
 * is cut, which makes an error of one step where sliding begins or ends.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impact_springs.h"

static const char *const laws[] = {"none", "mindlin", "mindlin_scaled"};
enum { NONE, MINDLIN, MINDLIN_SCALED, LAWS };

static int find(const char *law) {
  int k = 0;
  while (k < LAWS && strcmp(laws[k], law) != 0)
    k++;
  return k;
}

bool impact_law_known(const char *law) { return find(law) < LAWS; }

bool impact_law(struct impact_path *path, const char *law, double chi, double psi1, int steps) {
  const int which = find(law);
  const double dt = IMPACT_DURATION / steps;
  const size_t n = (size_t)steps + 1;
  *path = (struct impact_path){
      .steps = steps, .xi = impact_approach(steps), .f = calloc(n, sizeof(double)), .d = calloc(n, sizeof(double))};
  if (!path->xi || !path->f || !path->d)
    return false;
  double psi = psi1;
  for (int k = 0; k < steps; k++) {
    const double from = path->xi[k], to = path->xi[k + 1], middle = (from + to) / 2, limit = to * sqrt(to);
    psi -= 2.5 * chi * path->f[k] * (k ? dt : dt / 2);
    const double kept = which == MINDLIN_SCALED && to < from ? sqrt(to / from) : 1;
    const double stiff = which == NONE ? 0 : 1.5 * sqrt(middle);
    const double elastic = kept * path->f[k] + stiff * psi * dt;
    path->f[k + 1] = fabs(elastic) > limit ? copysign(limit, elastic) : elastic;
    path->d[k + 1] = path->d[k] + psi * dt;
    if (fabs(elastic) > limit)
      path->slid += (path->f[k] + path->f[k + 1]) / 2 * (elastic - path->f[k + 1]) / stiff;
  }
  path->psi2 = psi;
  return true;
}
