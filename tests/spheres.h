/* A contact of two steel spheres with the shear law under test; the normal force is Hertz's.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <CUnit/CUnit.h>

#include "../src/laws/law.h"

/* Two steel spheres with the radius 10 mm and nu = 0.3, pressed together by 88 N [R89 figure 5.3]. E, G: E* and G*, Pa;
 * R: R*, m; N: normal force, N; mu: friction coefficient. The results of these tests are divided by mu N. */
static const double E = 210e9 / (2 * 0.91), G = 210e9 / 2.6 / (2 * 1.7), R = 5e-3, N = 88, mu = 0.2;

/* Hertz: the overlap under the normal force n, and the force at the overlap x. */
static inline double deep(double n) { return pow(0.75 * n / (E * sqrt(R)), 2. / 3); }
static inline double press(double x) { return x > 0 ? 4. / 3 * E * sqrt(R) * x * sqrt(x) : 0; }
static inline double slope(void) { return mu * E / (4 * G); } /* mu kappa */

/* A segment of a path, relative to the overlap deep(N) under the force N. `alpha`: the overlap at its end over deep(N).
 * `slip`: the tangential displacement in it over mu kappa deep(N). */
struct segment {
  double alpha, slip;
};

struct contact {
  const struct nb_law *law;
  struct nb_pair pair;
  double overlap, m[12 + 5 * 64], work; /* work: sum of the mean shear force of each step times its increment, J */
  struct nb_shear s;
};

static inline struct contact contact_of(const char *law) {
  struct contact it = {.law = nb_law_find("shear", law), .pair = {.young = E, .shear = G, .radius = R, .friction = mu}};
  it.pair.pieces = it.law->pieces;
  CU_ASSERT_FATAL(nb_law_history(it.law, it.pair) <= (int)(sizeof it.m / sizeof *it.m));
  return it;
}

/* Makes one step to this overlap, with this tangential increment. */
static inline void go(struct contact *it, double overlap, double slip) {
  const double before = it->s.force;
  const struct nb_normal n = {
      .force = press(overlap), .stiffness = 2 * E * sqrt(R * overlap), .radius = sqrt(R * overlap), .overlap = overlap};
  it->overlap = overlap;
  it->s = it->law->shear(it->pair, n, slip, it->m);
  it->work += (before + it->s.force) / 2 * slip;
}

/* Makes equal steps to this overlap, with this tangential displacement in all. */
static inline void lead(struct contact *it, double overlap, double slip, int steps) {
  const double from = it->overlap;
  for (int k = 1; k <= steps; k++)
    go(it, from + (overlap - from) * k / steps, slip / steps);
}
