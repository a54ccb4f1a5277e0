/* The path of approach and slip that the exact law keeps of a contact: corners, from inside to outside, and a straight piece from
 * each to the next. Symbols and units as in shear_mindlin_deresiewicz.c.
 *
 * Where two pieces join, delta stays what it is at their ends. With no room left the corner goes that makes delta(x) least wrong as a
 * share of x, |D_1 - D_2| x_1 x_2/(x_1 + x_2), x_1, x_2 the spans of its pieces, and what is wrong in them already; one beside it
 * moves along u, so that T is kept as well: what is wrong stays within three pieces.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CORNERS_H
#define NB_CORNERS_H

#include "law.h"

/* Where piece k begins, and what it is. Behind the last piece its end: x and u; d and b as if it went on. */
struct corner {
  double x, u, d, b; /* on the piece u grows by d of each x, and t = b + d n */
  double e;          /* how wrong u is on it at most */
};

static inline double n_of(double x) { return x * sqrt(x); }

/* What D changes u by at the joint of two pieces when it goes, times x1 + x2, their spans. */
static inline double bend(double d1, double d2, double x1, double x2) { return fabs(d1 - d2) * (x1 * x2); }

/* Int t du over a piece. */
static inline double held(const struct corner *piece) {
  const double x0 = piece->x, x1 = piece[1].x;
  return piece->d * (piece->b * (x1 - x0) + 0.4 * piece->d * (x1 * n_of(x1) - x0 * n_of(x0)));
}
static inline double held_by(const struct corner at[], int pieces) {
  double sum = 0;
  for (int k = 0; k < pieces; k++)
    sum += held(&at[k]);
  return sum;
}

/* Corner k goes, and one piece lies where two were; answers what t behind them grows by. */
static inline double join(struct corner at[], int k, int pieces) {
  const struct corner one = at[k - 1], two = at[k], end = at[k + 1];
  const double x1 = two.x - one.x, x2 = end.x - two.x, d = (end.u - one.u) / (x1 + x2);
  at[k - 1].d = d, at[k - 1].b = one.b + (one.d - d) * n_of(one.x);
  at[k - 1].e = one.e + two.e + bend(one.d, two.d, x1, x2) / (x1 + x2);
  for (int i = k; i < pieces; i++)
    at[i] = at[i + 1];
  return at[k - 1].b - two.b + (d - two.d) * n_of(end.x);
}

/* Moves corner k along u, so that t behind piece k grows by `more`; false if a ring would carry more than its friction then. */
static inline bool move(struct corner at[], int k, double more) {
  const double x1 = at[k].x - at[k - 1].x, x2 = at[k + 1].x - at[k].x;
  const double n0 = n_of(at[k - 1].x), n1 = n_of(at[k].x), n2 = n_of(at[k + 1].x);
  const double turn = more / ((n1 - n0) * x2 - (n2 - n1) * x1);
  const double d1 = at[k - 1].d + turn * x2, d2 = at[k].d - turn * x1;
  if (!(fabs(d1) <= 1 && fabs(d2) <= 1))
    return false;
  at[k - 1].b += (at[k - 1].d - d1) * n0, at[k - 1].d = d1;
  at[k].u += turn * x1 * x2, at[k].b = at[k - 1].b + (d1 - d2) * n1, at[k].d = d2;
  return true;
}

/* Of the corners between pieces the one goes that makes u least wrong, as a share of x, and one beside it moves, so that neither
 * delta nor T changes. */
static NB_SELDOM void make_room(struct corner at[], int pieces) {
  int k = 1;
  double lowest = INFINITY;
  for (int i = 1; i < pieces; i++) {
    const double x1 = at[i].x - at[i - 1].x, x2 = at[i + 1].x - at[i].x;
    const double wrong = (at[i - 1].e + at[i].e) * (x1 + x2) + bend(at[i - 1].d, at[i].d, x1, x2);
    const double share = wrong / ((x1 + x2) * at[i].x);
    if (share < lowest)
      k = i, lowest = share;
  }
  const double moved = join(at, k, pieces);
  const int inner = k - 1, last = pieces - 1;
  if ((inner > 0 && move(at, inner, -moved)) || (k < last && move(at, k, -moved)))
    return;
  for (int i = k; i < last; i++)
    at[i].b += moved;
}

#endif
