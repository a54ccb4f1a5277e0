/* Reference: what the method of time steps gains or loses in Hertz's impact, to the lowest order in the step.
 *
 * Inside the contact leapfrog keeps the energy, but for what goes to and fro: it follows exactly a motion that differs by
 *
 *   H_1 = dt^2 (p^2 V''/(12 m*^2) - V'^2/(24 m*)),    V' = N
 *
 * from the true one, so with E the energy and B Euler's function the impact takes, n = T_c/dt,
 *
 *   T_c - (dt^2/(24 m*)) d/dE Int N^2 dt = T_c - (11/96) B(8/5, 1/2) dt^2 V_N/alpha* = T_c (1 - 0.5104/n^2)
 *
 * At its two ends the force has a corner, K (V_N t)^(3/2) and nothing before. A sum over steps of which the first lies phi dt
 * inside misses the integral there by zeta(-3/2, phi) K V_N^(3/2) dt^(5/2), zeta Hurwitz's function (Euler and Maclaurin), and
 * the work by V_N times as much: with K/m* = (5/4) V_N^2/alpha*^(5/2)
 *
 *   e - 1 = (5/4) (V_N dt/alpha*)^(5/2) (zeta(-3/2, phi_out) - zeta(-3/2, phi_in))
 *
 * Known: impact.restitution, impact.duration. Left out is the next order, n^(-5/2) of the duration and n^(-7/2) of the speed.
 *
 * Source   Hairer, Lubich and Wanner (2006) for H_1; elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_sf_gamma.h>
#include <math.h>

#include "hertz.h"

/* zeta(-3/2, a), a > 0: ten terms, and the rest by Euler and Maclaurin; error below 1e-9. */
static double zeta(double a) {
  enum { TERMS = 10 };
  double sum = 0;
  for (int k = 0; k < TERMS; k++)
    sum += pow(k + a, 1.5);
  const double x = TERMS + a;
  return sum - pow(x, 2.5) / 2.5 + pow(x, 1.5) / 2 - sqrt(x) / 8 - pow(x, -1.5) / 1920;
}

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_of(&hertz, scene, "hertz_phase", error))
    return error->status;
  if (hertz.damping > 0)
    return nb_error_set(error, NB_BAD_USE, "hertz_phase is for a contact without damping");
  const double share = hertz.step / hertz.unit;
  const double sooner = 11. / 96 * share * share * gsl_sf_beta(1.6, 0.5) * hertz.unit;
  const double in = hertz.begin / hertz.step, out = in + (hertz.duration - sooner) / hertz.step;
  const double gained = 1.25 * pow(share, 2.5) * (zeta(out - floor(out)) - zeta(ceil(in) - in));
  known_value(known, hertz.duration - sooner, "impact.duration");
  known_value(known, 1 + gained, "impact.restitution");
  return known_full(known, error);
}

const struct nb_reference reference_hertz_phase = {
    .name = "hertz_phase",
    .title = "Hertz's impact in steps: rebound and duration to the lowest order in the step, any phase of first touch",
    .source = "[R89 5.6]",
    .know = know,
};
