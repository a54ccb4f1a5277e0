/* The exact law of two elastic spheres (docs/CONTACT.md), implemented a second time for the tests, without a limit on
 * the number of rings and without merging rings. A ring is a range of the overlap x (m) over which D, the value of the
 * memory diagram, is constant: the shear force of the ring as a fraction of its friction limit. The rings are listed
 * from the centre to the edge. Slip removes the rings outside its front, so a long path costs little. The front is the
 * boundary between slip and stick.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>
#include <stdlib.h>

/* n = x^(3/2), u = Int D dx and t = Int D dn, integrated from the centre to the outer end of the ring. The normal force
 * is proportional to n, the tangential displacement to u, and the shear force to t. */
struct ring {
  double end, d;  /* overlap at the outer end, m; D */
  double n, u, t; /* values at the outer end, in m^(3/2), m, m^(3/2) */
};

/* A contact, empty at first; `count` = 0 begins a new contact. Free it with by_hand_free. */
struct by_hand {
  int count, capacity;
  struct ring *ring;
  double slid; /* > 0 if the whole contact slid in the last step: the slid displacement over mu kappa, m */
};

static inline void by_hand_free(struct by_hand *it) {
  free(it->ring);
  *it = (struct by_hand){0};
}

/* Ring k; for k = -1, the centre, all members are 0. */
static inline struct ring by_hand_ring(const struct by_hand *it, int k) {
  return k >= 0 ? it->ring[k] : (struct ring){0};
}
/* The overlap at the inner end of ring k. */
static inline double by_hand_begin(const struct by_hand *it, int k) { return by_hand_ring(it, k - 1).end; }

/* Adds a ring outside all others, from the edge to the overlap `end`. Does nothing if this ring is empty. */
static inline void by_hand_add(struct by_hand *it, double end, double d) {
  const struct ring inner = by_hand_ring(it, it->count - 1);
  if (!(end > inner.end))
    return;
  if (it->count == it->capacity) {
    it->capacity = it->capacity ? 2 * it->capacity : 64;
    it->ring = realloc(it->ring, (size_t)it->capacity * sizeof *it->ring);
    if (!it->ring)
      abort();
  }
  const double n = pow(end, 1.5);
  it->ring[it->count++] = (struct ring){end, d, n, inner.u + d * (end - inner.end), inner.t + d * (n - inner.n)};
}

/* Removes the rings outside the overlap x, and cuts the ring that contains x. */
static inline void by_hand_cut(struct by_hand *it, double x) {
  while (it->count > 0 && by_hand_begin(it, it->count - 1) >= x)
    it->count--;
  if (it->count > 0 && it->ring[it->count - 1].end > x) {
    const double d = it->ring[--it->count].d;
    by_hand_add(it, x, d);
  }
}

/* Slips in the direction s, 1 or -1, until u is `target` at the edge, the overlap x. Outside the front D is then s. The
 * front is at the overlap c at which s (target - u(c)) = x - c; if there is no such c, the whole contact slides. */
static inline void by_hand_slip(struct by_hand *it, double x, double target, double s) {
  while (it->count > 0) {
    const struct ring inner = by_hand_ring(it, it->count - 2);
    const double beyond = x - inner.end - s * (target - inner.u); /* >= 0: front in this ring or at its inner end */
    if (beyond >= 0) {
      by_hand_cut(it, inner.end + beyond / (1 - s * it->ring[it->count - 1].d));
      break;
    }
    it->count--;
  }
  it->slid = it->count == 0 && s * target > x ? s * target - x : 0;
  by_hand_add(it, x, s);
}

/* Makes one step to the overlap x. u (m) is the tangential increment of the step, divided by mu kappa. Returns T/(mu
 * N). */
static inline double by_hand_go(struct by_hand *it, double x, double u) {
  const double target = by_hand_ring(it, it->count - 1).u + u;
  it->slid = 0;
  by_hand_cut(it, x);
  const struct ring edge = by_hand_ring(it, it->count - 1);
  const double missing = target - edge.u;
  if (fabs(missing) > x - edge.end)
    by_hand_slip(it, x, target, missing > 0 ? 1 : -1);
  else
    by_hand_add(it, x, missing / (x - edge.end));
  return it->count > 0 ? it->ring[it->count - 1].t / pow(x, 1.5) : 0;
}
