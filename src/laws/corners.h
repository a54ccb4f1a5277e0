/* The loading path (overlap against tangential displacement) that the exact law stores for a contact: corners, in order
 * from the centre of the contact outwards, joined by straight pieces. shear_mindlin_deresiewicz.c defines the symbols
 * and their units.
 *
 * A merge removes the corner between two neighbouring pieces and joins their other ends by a straight piece. The change
 * of u, as a function of x, is a triangle. A change v(x) of u changes t by -Int v n'' dx with n'' = (3/4) x^(-1/2). So
 * the cost of a merge is the area of the triangle over x^(1/2), with the x of the removed corner. When all pieces are
 * in use, the corner with the lowest cost is removed. Its cost includes the errors of earlier merges in its two pieces.
 * A merge does not change delta, but it changes T. A change of u at a neighbouring corner restores T. So u has an error
 * only in the merged piece and in one neighbour of it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "law.h"

/* The corner at the inner end of a piece, and the straight line of the piece. The entry after the last piece has x and
 * u of the outer end of that piece, and d and b of the piece. */
struct corner {
  double x, u, d, b; /* on the piece, u increases by d per unit of x, and t = b + d n */
  double e;          /* twice the area by which merges have changed this piece; older merges count less: drop_corner */
};

/* True if a path with |D| <= 1 leads from (x0, u0) to (x, u). */
static inline bool reachable(double x0, double u0, double x, double u) { return fabs(u - u0) <= x - x0; }

static inline double n_of(double x) { return x * sqrt(x); }

/* Twice the area of the triangle by which a merge changes u, that is its height times its base x1 + x2. The two pieces
 * have the slopes d1 and d2 and the lengths x1 and x2 in x. */
static inline double kink(double d1, double d2, double x1, double x2) { return fabs(d1 - d2) * (x1 * x2); }

/* Int t du over a piece; stored_energy sums it over all pieces. */
static inline double piece_energy(const struct corner *piece) {
  const double x0 = piece->x, x1 = piece[1].x;
  return piece->d * (piece->b * (x1 - x0) + 0.4 * piece->d * (x1 * n_of(x1) - x0 * n_of(x0)));
}
static inline double stored_energy(const struct corner at[], int pieces) {
  double sum = 0;
  for (int k = 0; k < pieces; k++)
    sum += piece_energy(&at[k]);
  return sum;
}

/* The mean of n over overlaps from x0 to x1, 0.4 (x1^(5/2) - x0^(5/2))/(x1 - x0), without cancellation. */
static inline double mean_n(double x0, double x1) {
  const double a = sqrt(x0), b = sqrt(x1), sum = a + b;
  return sum > 0 ? 0.4 * ((a * a + b * b) * (a * a + a * b + b * b) - x0 * x1) / sum : 0;
}

/* Int (n(x) - n(y) - n'(y)(x - y)) dy, where x is the overlap when the slip front is at y: the front moves inwards from
 * y1 to y0 while the overlap changes linearly from x1 to x0. The energy lost is (1 - s D) times this integral. */
static inline double front_loss(double y0, double x0, double y1, double x1) {
  const double slope = (x1 - x0) / (y1 - y0), foot = x0 - slope * y0; /* x = foot + slope y */
  const double n0 = n_of(y0), n1 = n_of(y1);
  return mean_n(x0, x1) * (y1 - y0) - foot * (n1 - n0) + (0.2 - 0.6 * slope) * (n1 * y1 - n0 * y0);
}

/* A row holds the number of pieces, mu kappa, and the corners. */
enum { HEAD = 2 };
/* Number of doubles of a row m that are in use. */
static inline int corners_used(const double m[]) { return HEAD + 5 * ((int)m[0] + 1); }

/* Excess of |D| over 1 that rounding may cause: a slope is a quotient of differences of sums. */
static const double slope_rounding = 1e-9;

/* True if these doubles are a consistent row: at most max_pieces pieces, corners in ascending order, and no ring beyond
 * its friction limit, except by rounding. */
static inline bool corners_valid(const double m[], int doubles, int max_pieces) {
  const struct corner *at = (const struct corner *)(m + HEAD);
  bool is = doubles > HEAD && m[0] >= 1 && m[0] <= max_pieces && m[0] == floor(m[0]) && m[1] > 0;
  is = is && doubles == corners_used(m) && at[0].x == 0;
  for (int k = 0; is && k < (int)m[0]; k++)
    is = at[k + 1].x > at[k].x && fabs(at[k].d) <= 1 + slope_rounding && at[k].e >= 0;
  return is;
}

/* Removes corner k by merging the two pieces that meet there. Returns the change of t at all x beyond these pieces;
 * leaves b of the pieces there as it is. */
static inline double merge(struct corner at[], int k, int pieces) {
  const struct corner one = at[k - 1], two = at[k], end = at[k + 1];
  const double x1 = two.x - one.x, x2 = end.x - two.x, d = (end.u - one.u) / (x1 + x2);
  at[k - 1].d = d, at[k - 1].b = one.b + (one.d - d) * n_of(one.x);
  at[k - 1].e = one.e + two.e + kink(one.d, two.d, x1, x2);
  for (int i = k; i < pieces; i++)
    at[i] = at[i + 1];
  return at[k - 1].b - two.b + (d - two.d) * n_of(end.x);
}

/* Changes u of corner k so that t increases by `more` at all x beyond piece k; leaves b of the pieces there as it is.
 * Returns false and changes nothing if a ring would exceed its friction limit. */
static inline bool shift_corner(struct corner at[], int k, double more) {
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

/* Removes the corner with the lowest cost and moves a neighbouring corner, so that delta and T keep their values. If
 * neither neighbour can be moved, T changes. The member e of the merged piece is multiplied by three quarters. If e
 * were kept in full, old pieces would keep corners that new pieces need. If e were set to 0, the same pieces would be
 * merged again and again. In 549 decaying oscillations of 20 to 3000 reversals, with 64 pieces, these two choices gave
 * errors of T of up to 1.5e-3 and 3.6e-4 mu N, and three quarters gave 1.7e-4. */
static NB_COLD void drop_corner(struct corner at[], int pieces) {
  int k = 1;
  double lowest = INFINITY;
  for (int i = 1; i < pieces; i++) { /* compares the squares of the costs, which need no root */
    const double x1 = at[i].x - at[i - 1].x, x2 = at[i + 1].x - at[i].x;
    const double area = at[i - 1].e + at[i].e + kink(at[i - 1].d, at[i].d, x1, x2);
    if (area * area < lowest * at[i].x)
      k = i, lowest = area * area / at[i].x;
  }
  const double moved = merge(at, k, pieces);
  at[k - 1].e *= 0.75;
  const int inner = k - 1, last = pieces - 1;
  if ((inner > 0 && shift_corner(at, inner, -moved)) || (k < last && shift_corner(at, k, -moved)))
    return;
  for (int i = k; i < last; i++)
    at[i].b += moved;
}
