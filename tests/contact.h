/* One contact with its laws, without particles. The tests of contact laws share it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "../src/laws/law.h"
#include "chance.h"
#include "laws/laws_now.h"

enum { MOST = 16 + 5 * 65 };                /* largest number of history variables of a shear law */
static const double untouched = -12345.678; /* value of history variables that a law does not have */

/* A contact under test, with the histories of its laws. */
struct contact {
  const struct nb_law *normal, *shear; /* shear NULL: none */
  struct nb_pair pair;
  double overlap;
  double normal_history[NB_HISTORY], shear_history[MOST];
  struct nb_normal n;
  struct nb_shear s;
  double dissipated; /* sum over the steps, for laws that return it, J */
};

static inline struct contact contact_of(const struct nb_law *normal, const struct nb_law *shear, struct nb_pair pair) {
  struct contact it = {.normal = normal, .shear = shear, .pair = pair};
  it.pair.pieces = shear ? shear->pieces : 0;
  if (shear && shear->cohesionless)
    it.pair.cohesion = 0;
  for (int m = 0; m < NB_HISTORY; m++)
    it.normal_history[m] = m < normal->history ? 0 : untouched;
  for (int m = 0; m < MOST; m++)
    it.shear_history[m] = m < nb_law_history(shear, it.pair) ? 0 : untouched;
  return it;
}

/* Makes one step to this overlap, with this tangential increment. */
static inline void contact_go(struct contact *it, double overlap, double slip) {
  const int remembered = nb_law_history(it->shear, it->pair);
  it->n = it->normal->normal(it->pair, overlap, overlap - it->overlap, it->normal_history);
  it->n.overlap = it->overlap = overlap;
  if (it->shear && (overlap > 0 || remembered <= NB_HISTORY))
    it->s = it->shear->shear(it->pair, it->n, slip, it->shear_history);
  else
    it->s = (struct nb_shear){0};
  it->dissipated += it->shear && it->shear->dissipative ? it->s.dissipated : 0;
  if (overlap > 0)
    return;
  for (int m = 0; m < it->normal->history; m++) /* the history ends with the contact, as in law_batch.h */
    it->normal_history[m] = 0;
  for (int m = 0; m < remembered; m++)
    it->shear_history[m] = m > 0 && remembered > NB_HISTORY ? untouched : 0; /* m[0]: the number of pieces */
}

/* Makes n equal steps to this overlap, with this tangential displacement in all. Returns the work (J); the force in a
 * step is the mean of the forces before and after it. */
static inline double contact_lead(struct contact *it, double overlap, double slip, int n) {
  const double from = it->overlap;
  double work = 0;
  for (int k = 1; k <= n; k++) {
    const double before = it->overlap;
    const struct nb_normal was = it->n;
    const struct nb_shear rubbed = it->s;
    contact_go(it, k == n ? overlap : from + (overlap - from) * k / n, slip / n);
    work += (was.force + it->n.force) / 2 * (it->overlap - before) + (rubbed.force + it->s.force) / 2 * (slip / n);
  }
  return work;
}

/* A random material pair. */
static inline struct nb_pair pair_by(struct chance *chance) {
#define ROW(name, ...) .name = 2.5, /* for members that are not drawn below */
  struct nb_pair pair = {NB_PAIR_ROWS(ROW)};
#undef ROW
  pair.kn = chance_scale(chance, 1e-6, 1e10);
  pair.ks = chance_between(chance, 0, 1) < 0.1 ? 0 : pair.kn * chance_between(chance, 0.2, 1.5);
  pair.friction = chance_between(chance, 0, 1) < 0.2 ? 0 : chance_between(chance, 0.05, 1);
  pair.cohesion = chance_between(chance, 0, 1) < 0.7 ? 0 : pair.kn * chance_scale(chance, 1e-9, 1e-4);
  pair.young = pair.kn * chance_scale(chance, 1e6, 1e9);        /* Pa; the factor has the unit 1/m */
  pair.shear = pair.young * chance_between(chance, 0.16, 0.26); /* G* over E* */
  pair.radius = chance_scale(chance, 1e-5, 1);
  return pair;
}

/* The elastic energy of the contact, J. */
static inline double stored(const struct contact *it) {
  double sum = it->normal->stored(it->pair, it->n, it->normal_history);
  if (it->shear)
    sum += it->shear->stored(it->pair, it->n, it->shear_history);
  return sum;
}
