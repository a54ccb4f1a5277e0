/* The exact law of two elastic spheres (docs/CONTACT.md), implemented a second time for the tests: slow, with no
 * limit on the number of rings, and no two rings are joined. The rings are listed from inside to outside by the
 * overlap x (m) at which each was added; D is the fraction of its friction limit that a ring carries. Nothing is
 * summed in advance. The edge of the stick region is found by bisection, and forces use pow.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BY_HAND_H
#define NB_BY_HAND_H

#include <math.h>
#include <stdlib.h>

enum { BY_HAND_MOST = 4096 };

struct by_hand {
  int count;
  double end[BY_HAND_MOST], d[BY_HAND_MOST]; /* overlap at which ring k ends, m; its D */
  double slid;                               /* the part of u that slid as a whole in the last step, m */
};

static inline double by_hand_begin(const struct by_hand *it, int k) { return k > 0 ? it->end[k - 1] : 0; }

/* Int_0^x D dx, and Int_0^x D d(x^(3/2)). */
static inline double by_hand_slip(const struct by_hand *it, double x) {
  double sum = 0;
  for (int k = 0; k < it->count && by_hand_begin(it, k) < x; k++)
    sum += it->d[k] * ((it->end[k] < x ? it->end[k] : x) - by_hand_begin(it, k));
  return sum;
}
static inline double by_hand_force(const struct by_hand *it, double x) {
  double sum = 0;
  for (int k = 0; k < it->count && by_hand_begin(it, k) < x; k++)
    sum += it->d[k] * (pow(it->end[k] < x ? it->end[k] : x, 1.5) - pow(by_hand_begin(it, k), 1.5));
  return sum;
}

static inline void by_hand_cut(struct by_hand *it, double x) {
  while (it->count > 0 && by_hand_begin(it, it->count - 1) >= x)
    it->count--;
  if (it->count > 0 && it->end[it->count - 1] > x)
    it->end[it->count - 1] = x;
}

static inline void by_hand_ring(struct by_hand *it, double end, double d) {
  if (it->count == BY_HAND_MOST)
    abort();
  it->end[it->count] = end, it->d[it->count++] = d;
}

/* Advances to the overlap x and by u = slip/(mu kappa), m. Returns T/(mu N). */
static inline double by_hand_go(struct by_hand *it, double x, double u) {
  const double before = by_hand_begin(it, it->count), target = by_hand_slip(it, before) + u;
  it->slid = 0;
  by_hand_cut(it, x);
  const double edge = by_hand_begin(it, it->count), missing = target - by_hand_slip(it, edge);
  if (fabs(missing) <= x - edge) {
    if (x > edge)
      by_hand_ring(it, x, missing / (x - edge));
    return by_hand_force(it, x) / pow(x, 1.5);
  }
  const double s = missing > 0 ? 1 : -1;
  double low = 0, high = edge; /* lower and upper bound of the overlap at the edge of the stick region */
  for (int k = 0; k < 200; k++) {
    const double c = (low + high) / 2;
    if (s * (target - by_hand_slip(it, c)) <= x - c)
      low = c;
    else
      high = c;
  }
  if (s * target > x)
    it->slid = s * target - x, low = 0;
  by_hand_cut(it, low);
  by_hand_ring(it, x, s);
  return by_hand_force(it, x) / pow(x, 1.5);
}

#endif
