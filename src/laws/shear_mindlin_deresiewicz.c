/* The exact law of Cattaneo and Mindlin for any loading path:
 *
 *   T = mu Int_0^alpha D dN(x),      delta = mu kappa Int_0^alpha D dx,      -1 <= D(x) <= 1,      kappa = E* / (4 G*)
 *
 *   alpha     a^2/R*, the overlap at which Hertz's law has the contact radius a, m;  R* effective radius, m
 *   N(x)      N (x/alpha)^(3/2), Hertz's force at the overlap x; N the present normal force, in newtons
 *   delta     tangential displacement of the contact without gross sliding, m;  T  shear force, in newtons
 *   E*, G*    effective moduli, Pa: normal_hertz.c, shear_mindlin.c
 *   D(x)      traction of the ring that joined the contact at the overlap x, as a fraction of its friction limit; 1 or
 *             -1 in a ring that has slipped
 *   mu        the smaller friction of the two materials, 1
 *
 * D is piecewise constant: delta(x) = mu kappa Int_0^x D is a polygonal path, the shortest loading path that leads to
 * the present state of the contact. A step to a new alpha and delta keeps each corner k, at x_k and delta_k, from which
 * a path with |D| <= 1 leads to the new state:
 *
 *   |delta - delta_k| <= mu kappa (alpha - x_k)
 *
 * If the last corner is kept, a new ring sticks, with D = d(delta)/(mu kappa d(alpha)). If only inner corners are kept,
 * the path follows the old piece that begins at the outermost kept corner, up to the overlap c of the slip front. From
 * c to alpha it has D = s, s = 1 or -1: the rings outside c have slipped. If no corner is kept, not even the one at 0,
 * the contact slides. The result does not depend on the step size: a step is exact if (alpha, delta) moves on a
 * straight line. A path of straight segments is exact as long as there are enough pieces for its segments.
 *
 * A new piece is merged with the piece before it, without a change of delta, if the merge changes T by less than 1e-7
 * mu N. If delta is below a hundredth of the delta at which the contact slides, this limit decreases in proportion to
 * delta. When all pieces are in use, two other pieces are merged (corners.h). In a set of decaying oscillations with 20
 * to 3000 reversals the largest error of T was 1.2e-4 mu N with 64 pieces, the default (docs/CONTACT.md); in another
 * such set it was 1.7e-4 mu N. These are measurements, not bounds. The decrease of the stored energy by a merge counts
 * as energy lost; it may be negative.
 *
 * Stores     Int_0^alpha T(x) d(delta). The tractions are those of flat punches with the radii a(x), each displaced by
 *            d(delta)(x), with the force 8 G* a(x) d(delta). A punch of radius a(x) displaces the whole area of a
 *            smaller punch, with the radius a(y), by its d(delta). So by reciprocity the interaction energy of the two
 *            punches is the force of the smaller one times the displacement of the larger one: U = Int d(delta)(x)
 *            Int_(y < x) 8 G* a(y) d(delta)(y), where the inner integral is T(x).
 * Dissipates by micro-slip and by sliding. A slip front that advances inwards from c to c - dc needs the displacement
 *            d(delta) = mu kappa (1 - s D) dc. Of the work T d(delta), the part mu^2 kappa (1 - s D) [N(alpha) - N(c) -
 *            N'(c)(alpha - c)] dc is lost. Sliding dissipates mu N times the displacement. Both terms use alpha at the
 *            time when the front passes c, so their sum is exact on a straight segment without a reversal.
 * Source     Jaeger (1993-1998); Aleshin, Bou Matar and Van Den Abeele (2015). All cases of Mindlin and Deresiewicz
 *            (1953) follow: [R89 3.25, 3.40, 3.50, 3.94].
 * Range      slip along one line; no coupling of normal and tangential motion. No cohesion, because friction alone
 *            limits the traction. When the friction changes, the path of the pieces is computed again; an increase of
 *            the friction makes no ring slip.
 * History    in variables that do not contain mu, E* and N. x stands for x R*, the square of a radius, m2;
 *            n = x^(3/2), m3; u = R* delta/(mu kappa), m2; t = Int D dn, m3, so that T/mu N = t/n at alpha
 *            m[0]  number of pieces; 0: none;  m[1]  mu kappa of these pieces
 *            m[2 + 5k ...]  the corner at which piece k begins, from the centre outwards (corners.h); piece 0 at 0
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>

#include "corners.h"

/* Two pieces are merged if u changes by at most merge_tolerance times x; T then changes by at most 1.5 mu N
 * merge_tolerance. If |u| is below small_fraction times x, T is far below mu N, and the limit must be smaller:
 * |u|/small_fraction replaces x. The value that replaces x is never below least_fraction times x. */
static const double merge_tolerance = 1e-7 / 1.5, small_fraction = 1e-2, least_fraction = 1e-15;
/* Upper limit of the ratio of old to new friction, so that its square stays finite. With a ratio near this limit the
 * contact slides anyway. */
static const double max_friction_ratio = 1e150;

/* The height that the triangle of a merge must not exceed: a change of u. x: overlap at the end of the new piece; u1,
 * u2: u at its two ends. */
static inline double merge_limit(double x, double u1, double u2) {
  const double one = fabs(u1), other = fabs(u2), larger = (one > other ? one : other) / small_fraction;
  const double least = least_fraction * x;
  return merge_tolerance * (larger > x ? x : larger > least ? larger : least);
}

static inline double mu_kappa(struct nb_pair p) { return p.friction * p.young / (4 * p.shear); }
static inline double u_increment(struct nb_pair p, double ds) { return ds * p.radius * (1 / mu_kappa(p)); }

/* True if there is friction. A mu_kappa so small that its inverse may overflow counts as 0. */
static inline bool has_friction(struct nb_pair p) { return mu_kappa(p) >= DBL_MIN; }

/* True if the contact can have a shear force: it has friction, and the normal force is above 0. */
static inline bool can_bear_shear(struct nb_pair p, struct nb_normal n) {
  return has_friction(p) && n.radius * n.radius * n.radius > 0;
}

/* The outermost corner that is kept in a step to (x, u), in the variables of the history. The new piece begins at this
 * corner if the new ring sticks; otherwise it begins farther outside, at the slip front. */
struct base {
  double k;          /* index of the new piece; below 0: not found yet */
  double x, u, d, b; /* the corner: struct corner */
  double from;       /* x of the inner end of the piece before the new one */
};

/* The new piece: x, u, d and b as in struct corner, and u at its end. */
struct piece {
  double k; /* index of the piece; below 0: general case, because the piece may vanish by rounding, or be merged */
  double x, u, d, b, end;
};

/* The new piece of a step to (x, u). `at`: the outermost kept corner; `sticks`: it is the last corner of all. */
static inline NB_FORM struct piece new_piece(struct base at, bool sticks, double x, double u) {
  const double h = x - at.x, wanted = u - at.u, s = copysign(1, wanted - at.d * h);
  const double v = fabs(wanted) > h ? s * h : wanted; /* beyond h the contact slides */
  const double part = (sticks ? v : h - s * v) / (sticks ? h : 1 - s * at.d), in = at.x + part;
  const double d = sticks ? part : s, c = sticks ? at.x : in < x ? in : x;
  const double x1 = c - at.from, x2 = x - c, end = at.u + v;
  const double k = kink(at.d, d, x1, x2) > merge_limit(x, at.u, end) * (x1 + x2) ? at.k : -1;
  return (struct piece){k, c, end - d * x2, d, at.b + (at.d - d) * n_of(c), end};
}

/* Searches all corners for the outermost one that is kept. If there is none, returns the corner at 0: the contact
 * slides. */
static inline struct base find_base(const struct corner at[], int pieces, double x, double u) {
  int k = pieces;
  while (k > 0 && !reachable(at[k].x, at[k].u, x, u))
    k--;
  const int index = k < pieces ? k + 1 : k;
  return (struct base){index, at[k].x, at[k].u, at[k].d, at[k].b, at[index > 0 ? index - 1 : 0].x};
}

/* Stores a piece, which ends at x, with the index k. */
static inline NB_FORM void append_piece(struct corner at[], int k, double x, const struct piece *piece) {
  at[k] = (struct corner){piece->x, piece->u, piece->d, piece->b, 0};
  at[k + 1] = (struct corner){x, piece->end, piece->d, piece->b, 0};
}

/* Adds a piece, which ends at x, with the index k. Merges it with the piece before it if the change is small enough;
 * merges two other pieces if all max_pieces are in use. Unless `dissipated` is NULL, adds the energy lost by a merge to
 * it. Returns the number of pieces. */
static int append_or_merge(struct corner at[], int k, double x, const struct piece *piece, int max_pieces,
                           double *dissipated) {
  if (k > 0 && !(piece->x > at[k - 1].x)) /* the previous piece has vanished */
    k--;
  if (!(piece->x < x)) { /* no new ring */
    at[k] = (struct corner){x, piece->end, at[k - 1].d, at[k - 1].b, 0};
    return k;
  }
  append_piece(at, k, x, piece);
  const int pieces = k + 1;
  if (k == 0)
    return pieces;
  const double x1 = at[k].x - at[k - 1].x, x2 = x - at[k].x;
  const bool joins =
      kink(at[k - 1].d, piece->d, x1, x2) < merge_limit(x, at[k].u, at[k + 1].u) * (x1 + x2) - at[k - 1].e;
  if (!joins && k < max_pieces)
    return pieces;
  if (dissipated)
    *dissipated += stored_energy(at, pieces);
  if (joins)
    merge(at, k, pieces);
  else
    drop_corner(at, pieces);
  if (dissipated)
    *dissipated -= stored_energy(at, k);
  at[k].d = at[k - 1].d, at[k].b = at[k - 1].b;
  return k;
}

/* The energy lost at the slip front and by sliding in a step to (x, u), in the unit of Int t du. `at` is the path
 * before the step; `piece` is the new piece, with the index `index`. The front passes the outer part of the piece
 * before the new one, and all pieces outside that piece. For a displacement in the sense s the front is at the y where
 * y - s u(y) equals g, the value of x - s u at the edge. g decreases during the step; when g is below 0 the contact
 * slides. */
static double energy_loss(const struct corner at[], int pieces, double x, double u, int index,
                          const struct piece *piece) {
  /* The sense of the slip; not always piece->d, which consists of rounding errors if the front is at a corner. */
  const double s = at[index].x < x ? copysign(1, u - at[index].u) : piece->d;
  const double x0 = at[pieces].x, g0 = x0 - s * at[pieces].u, g1 = x - s * u, fall = g0 - g1;
  if (!(fall > 0))
    return 0;
  double g = g1 > 0 ? g1 : 0;
  double y = piece->x < at[index].x ? piece->x : at[index].x;  /* the front has no unique position where D = s */
  double now = g < g0 ? x + (x0 - x) * ((g - g1) / fall) : x0; /* the overlap when the front is at y */
  double sum = g1 < 0 ? -g1 * mean_n(x, now) : 0;
  for (int k = index > 0 ? index - 1 : 0; k < pieces; k++) {
    const double to = at[k + 1].x;
    if (!(y < to))
      continue;
    g += (1 - s * at[k].d) * (to - y);
    const double then = g < g0 ? x + (x0 - x) * ((g - g1) / fall) : x0;
    sum += (1 - s * at[k].d) * front_loss(y, now, to, then);
    y = to, now = then;
  }
  return sum;
}

/* Makes a step to (x, u) in the general case. Unless `dissipated` is NULL, adds the energy lost to it. Returns the
 * number of pieces. */
static NB_COLD int advance(struct corner at[], int pieces, double x, double u, int max_pieces, double *dissipated) {
  const struct base base = find_base(at, pieces, x, u);
  const int index = (int)base.k;
  const struct piece piece = new_piece(base, reachable(at[pieces].x, at[pieces].u, x, u), x, u);
  if (dissipated)
    *dissipated += energy_loss(at, pieces, x, u, index, &piece);
  return append_or_merge(at, index, x, &piece, max_pieces, dissipated);
}

/* Computes the path of *count pieces again for another friction; `fraction` is the old mu kappa over the new one. The
 * new corners can replace the old ones in the same array, because a step adds at most one piece. Returns the energy
 * lost. */
static NB_COLD double rebuild(struct corner at[], double *count, double fraction, int max_pieces) {
  const int pieces = (int)*count;
  const double before = fraction * fraction * stored_energy(at, pieces);
  double from = 0;
  int k = 0;
  at[0] = (struct corner){0};
  for (int i = 1; i <= pieces; i++) {
    const double u = at[k].u + fraction * (at[i].u - from);
    from = at[i].u;
    k = advance(at, k, at[i].x, u, max_pieces, NULL);
  }
  *count = k;
  return before - stored_energy(at, k);
}

/* ---- the three stages in a block (law_stages.h): read the last four corners, of which one is kept in most steps;
 * compute the new piece; update the row ---- */

struct corner_values {
  double x, u, d, b;
};
struct fetched {
  double pieces;
  struct corner_values end, last, next, third;
};

static inline struct corner_values corner_values(const struct corner *at) {
  return (struct corner_values){at->x, at->u, at->d, at->b};
}

static inline NB_FORM struct fetched shear_mindlin_deresiewicz_fetch(struct nb_pair p, struct nb_normal n, double m[]) {
  struct corner *at = (struct corner *)(m + HEAD);
  if (!can_bear_shear(p, n))
    m[0] = 0;
  if (m[0] == 0) {
    at[0] = (struct corner){0};
  } else if (m[1] != mu_kappa(p)) {
    const double dissipated = rebuild(at, &m[0], fmin(m[1] / mu_kappa(p), max_friction_ratio), (int)p.pieces);
    at[(int)m[0]].e = dissipated; /* stored there until the law returns it */
  }
  m[1] = mu_kappa(p);
  const int k = (int)m[0];
  return (struct fetched){m[0], corner_values(&at[k]), corner_values(&at[k > 0 ? k - 1 : 0]),
                          corner_values(&at[k > 1 ? k - 2 : 0]), corner_values(&at[k > 2 ? k - 3 : 0])};
}

/* The corner `at`, with the index k for the new piece, if the step keeps it; otherwise `inner`, a corner farther
 * inside. */
static inline struct base select_base(struct corner_values at, double k, double x, double u, struct base inner) {
  const bool here = reachable(at.x, at.u, x, u);
  return (struct base){.k = here ? k : inner.k,
                       .x = here ? at.x : inner.x,
                       .u = here ? at.u : inner.u,
                       .d = here ? at.d : inner.d,
                       .b = here ? at.b : inner.b};
}

/* T, if the last piece has these d and b. */
static inline NB_FORM double force_of(struct nb_pair p, struct nb_normal n, double d, double b) {
  return p.friction * n.force * (d + b / (n.radius * n.radius * n.radius));
}

static inline NB_FORM struct nb_shear shear_mindlin_deresiewicz_solve(struct nb_pair p, struct nb_normal n, double ds,
                                                                      struct fetched at, struct piece *piece) {
  const double x = n.radius * n.radius, u = at.end.u + u_increment(p, ds);
  struct base base = {.k = -1};
  base = select_base(at.third, at.pieces - 2, x, u, base);
  base = select_base(at.next, at.pieces - 1, x, u, base);
  base = select_base(at.last, at.pieces, x, u, base);
  base = select_base(at.end, at.pieces, x, u, base);
  const bool sticks = reachable(at.end.x, at.end.u, x, u);
  base.from = sticks ? at.last.x : base.x;
  *piece = new_piece(base, sticks, x, u);
  return (struct nb_shear){.force = force_of(p, n, piece->d, piece->b), .stiffness = 8 * p.shear * n.radius};
}

/* Makes the step of a contact in the general case, or without friction, in place of the second stage: sets the force
 * and the sliding of `out`. Unless `dissipated` is NULL, adds the energy lost to it. */
static NB_COLD void advance_general(struct nb_pair p, struct nb_normal n, double ds, double m[], struct nb_shear *out,
                                    double *dissipated) {
  struct corner *at = (struct corner *)(m + HEAD);
  if (!can_bear_shear(p, n)) {
    out->force = 0, out->sliding = has_friction(p) ? 0 : 1;
    return;
  }
  const double x = n.radius * n.radius, u = at[(int)m[0]].u + u_increment(p, ds);
  const int pieces = advance(at, (int)m[0], x, u, (int)p.pieces, dissipated);
  m[0] = pieces;
  out->sliding = fabs(u) > x ? 1 : 0;
  out->force = force_of(p, n, at[pieces].d, at[pieces].b);
}

/* Updates the row. The general case is: none of the last four corners is kept, the new piece may vanish by rounding or
 * be merged, or no piece is free. */
static inline NB_FORM void shear_mindlin_deresiewicz_store(struct nb_pair p, struct nb_normal n, double ds, double m[],
                                                           struct piece piece, struct nb_shear *out, bool counts) {
  struct corner *at = (struct corner *)(m + HEAD);
  const double x = n.radius * n.radius;
  double dissipated = at[(int)m[0]].e; /* energy lost by a change of friction */
  if (piece.k >= 0 && piece.k < p.pieces) {
    if (counts)
      dissipated += energy_loss(at, (int)m[0], x, piece.end, (int)piece.k, &piece);
    append_piece(at, (int)piece.k, x, &piece);
    m[0] = piece.k + 1;
  } else {
    advance_general(p, n, ds, m, out, counts ? &dissipated : NULL);
  }
  if (counts && m[0] > 0)
    out->dissipated = mu_kappa(p) / p.radius * (p.friction * n.force / (x * n.radius)) * dissipated;
}

static double shear_mindlin_deresiewicz_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  const struct corner *at = (const struct corner *)(m + HEAD);
  const int pieces = (int)m[0];
  const double friction = m[1] * 4 * p.shear / p.young;
  return pieces > 0 ? m[1] / p.radius * friction * (n.force / n_of(at[pieces].x)) * stored_energy(at, pieces) : 0;
}

/* Sets x to the overlaps at which the pieces end, from the centre outwards, m, and d to their D. Returns their
 * number. */
static int shear_mindlin_deresiewicz_pieces(struct nb_pair p, struct nb_normal n, const double m[], double x[],
                                            double d[]) {
  (void)n;
  const struct corner *at = (const struct corner *)(m + HEAD);
  for (int k = 0; k < (int)m[0]; k++)
    x[k] = at[k + 1].x / p.radius, d[k] = at[k].d;
  return (int)m[0];
}

/* Prefetches the last four corners and the place of a new corner. */
static inline void shear_mindlin_deresiewicz_prefetch(const double m[]) {
  const double *from = &m[m[0] > 3 ? HEAD + 5 * ((int)m[0] - 3) : 0];
  for (int line = 0; line < 4; line++)
    __builtin_prefetch(&from[8 * line], 1);
}

#define LAW shear_mindlin_deresiewicz
#define SHEAR
#define ELASTIC
#define STAGED
#define FETCHED struct fetched
#define SOLVED struct piece
#define DISSIPATIVE
#define COHESIONLESS
#define TITLE "exact law of elastic spheres with micro-slip, by Cattaneo and Mindlin, for any loading history"
#define SOURCE "[R89 sec. 3.2-3.5]"
#define PARAMETERS "young, poisson, friction"
#define HISTORY 12
#define PIECE 5
#define PIECES 64
#define STORED shear_mindlin_deresiewicz_stored
#define PREFETCH shear_mindlin_deresiewicz_prefetch
#define USED corners_used
#define VALID corners_valid
#define PIECES_OF shear_mindlin_deresiewicz_pieces
#include "law_batch.h"
