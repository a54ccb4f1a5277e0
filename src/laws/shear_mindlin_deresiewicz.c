/* The exact law of Cattaneo and Mindlin under any history of approach and slip:
 *
 *   T = mu Int_0^alpha D dN(x),      delta = mu kappa Int_0^alpha D dx,      -1 <= D(x) <= 1,      kappa = E* / 4 G*
 *
 *   alpha, N  overlap, m, and Hertz's force at it, N(x) = N (x/alpha)^(3/2); alpha = a^2/R*, what belongs to the force
 *   delta     tangential displacement since nothing slid as a whole, m;  T  the force that it makes, N
 *   D(x)      what the ring that grew at the overlap x carries, 1: a share of its friction; 1 or -1 where it has slipped
 *   mu        the smaller friction of the two materials, 1
 *
 * D is piecewise constant, and its pieces are the path that would make it: approach from x = 0 to alpha, slip
 * delta(x) = mu kappa Int_0^x D. One step: what lies beyond alpha is gone, if alpha fell. If it grew, the new ring sticks with
 * D = d(delta)/(mu kappa d(alpha)), if that lies within [-1, 1]. Otherwise slip enters from the edge, up to the front c at which
 * D = s on (c, alpha), s = 1 or -1, makes delta right. Without such a c the contact slides. No step size enters: a step is
 * exact where (alpha, delta) moves on a straight line, and on a path of as many legs as there is room for pieces.
 *
 * A piece that makes t(x) wrong by less than 1e-7 of mu N joins the one before it, keeping delta. With no room left those two
 * join whose union does least harm: |D_1 - D_2| n_1 n_2/(n_1 + n_2), n their spans of force, and what is wrong in them already,
 * as a share of N at their joint. The joint beside them then moves so that T is kept as well: what is wrong stays within those
 * three pieces, and nothing adds up over the steps. With 16 pieces T is off by less than 6e-4 mu N, and
 * by 2e-5 mu N on average, on 1000 rough chance steps or 400 smooth ones that turn every few (tests/exact.c).
 * What joining changes of the energy stored counts as lost; it may be less than 0.
 *
 * Stores     Int_0^alpha T(x) d(delta). The tractions are a sum of flat punches of the radii a(x), each displaced by d(delta)(x):
 *            forces 8 G* a(x) d(delta). One of radius a(x) displaces all that a smaller one, at y, presses by the whole of its
 *            d(delta), so by reciprocity the energy of the two together is the smaller one's force times that, and
 *            U = Int d(delta)(x) Int_(y < x) 8 G* a(y) d(delta)(y), where the inner integral is T(x).
 * Loses      a front that goes in from c to c - dc takes d(delta) = mu kappa (1 - s D) dc, and of the work T d(delta)
 *            mu^2 kappa (1 - s D) [N(alpha) - N(c) - N'(c)(alpha - c)] dc  is not stored; a slide takes mu N of each metre. Both with
 *            alpha in the middle of the step, so that the sum is of second order.
 * Source     Jaeger (1993-1998); Aleshin, Bou Matar and Van Den Abeele (2015). All cases of Mindlin and Deresiewicz
 *            (1953) follow: [R89 3.25, 3.40, 3.50, 3.94].
 * Range      slip along one line; no coupling of normal and tangential motion; a friction of the stress, so no cohesion. When
 *            friction changes, the path of the pieces is gone anew: nothing moves where it grows.
 * Remembers  m[0]  pieces; 0: none;  m[1]  mu kappa, which u and D are made with
 *            m[3 + 5k ...]  the end of piece k, k = 0 the origin: x, m; n = x^(3/2); u = delta(x)/(mu kappa), m;
 *                           t = Int_0^x D dn, m^(3/2), which is to n as T to mu N; e, how wrong t is within it at most
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

enum { HEAD = 3 };
static const double little = 1e-7;

struct piece { /* its end; D is the slope of u(x) from the end of the one before */
  double x, n, u, t, e;
};

/* On the way from the end of the piece before to the end of this one. */
static inline struct piece within(const struct piece *piece, double x, double n) {
  const double share = (x - piece[-1].x) / (piece->x - piece[-1].x), up = piece->u - piece[-1].u;
  const double d = up / (piece->x - piece[-1].x);
  return (struct piece){x, n, piece[-1].u + share * up, piece[-1].t + d * (n - piece[-1].n), share * piece->e};
}

/* What t(x) is wrong by at most when the pieces that end at one and at two join. */
static inline double error(const struct piece *zero, const struct piece *one, const struct piece *two) {
  const double x1 = one->x - zero->x, x2 = two->x - one->x, n1 = one->n - zero->n, n2 = two->n - one->n;
  return one->e + two->e + fabs((one->u - zero->u) / x1 - (two->u - one->u) / x2) * (n1 * n2 / (n1 + n2));
}

/* Int (n - n_0) dx over a piece that begins at zero, up to its end. */
static inline double under(const struct piece *zero, const struct piece *end) {
  return 0.4 * (end->x * end->n - zero->x * zero->n) - zero->n * (end->x - zero->x);
}

/* What Int t du is more when the pieces that end at one and at two join, and u grows by `beyond` farther out. */
static inline double gain(const struct piece *zero, const struct piece *one, const struct piece *two, double beyond) {
  const double d1 = (one->u - zero->u) / (one->x - zero->x), d2 = (two->u - one->u) / (two->x - one->x);
  const double d = (two->u - zero->u) / (two->x - zero->x), n1 = one->n - zero->n, n2 = two->n - one->n;
  return d * d * under(zero, two) - d1 * d1 * under(zero, one) -
         d2 * (d1 * n1 * (two->x - one->x) + d2 * under(one, two)) + (d * (n1 + n2) - d1 * n1 - d2 * n2) * beyond;
}

/* What a leg of the path, to an overlap x and a slip u, makes of the pieces. */
struct leg {
  int pieces;
  double slid; /* as a whole, m; as u */
  double lost; /* to fronts that went in, to the slide and to pieces that joined; as Int t du */
};

/* The joint behind piece j goes, delta stays; t beyond it, up to piece k, follows. */
static inline void join(struct piece at[], int j, int k, double *lost) {
  const double d = (at[j + 1].u - at[j - 1].u) / (at[j + 1].x - at[j - 1].x);
  const double moved = at[j - 1].t + d * (at[j + 1].n - at[j - 1].n) - at[j + 1].t;
  *lost -= gain(&at[j - 1], &at[j], &at[j + 1], at[k].u - at[j + 1].u);
  at[j + 1].e = error(&at[j - 1], &at[j], &at[j + 1]);
  for (; j < k; j++)
    at[j] = at[j + 1], at[j].t += moved;
}

/* Int t du. */
static inline double held(const struct piece at[], int pieces) {
  double sum = 0;
  for (int k = 1; k <= pieces; k++) {
    const double d = (at[k].u - at[k - 1].u) / (at[k].x - at[k - 1].x);
    sum += (at[k].u - at[k - 1].u) * at[k - 1].t + d * d * under(&at[k - 1], &at[k]);
  }
  return sum;
}

/* Moves joint j along u, so that t behind it grows by `more`; false if a ring would carry more than its friction then. */
static inline bool move(struct piece at[], int j, double more) {
  const double x1 = at[j].x - at[j - 1].x, x2 = at[j + 1].x - at[j].x;
  const double n1 = at[j].n - at[j - 1].n, n2 = at[j + 1].n - at[j].n;
  const double u = at[j].u + more / (n1 / x1 - n2 / x2), d = (u - at[j - 1].u) / x1;
  if (!(fabs(d) <= 1 && fabs(at[j + 1].u - u) <= x2))
    return false;
  at[j].u = u, at[j].t = at[j - 1].t + d * n1;
  return true;
}

/* The joint behind piece j goes, and one beside it moves, so that neither delta nor T changes. */
static inline void join_kept(struct piece at[], int j, int k, double *lost) {
  const double before = held(at, k), t = at[j + 1].t;
  double with_it = 0;
  join(at, j, k, &with_it);
  const double moved = at[j].t - t;
  bool kept = j > 1 && move(at, j - 1, -moved);
  if (kept)
    at[j].t = t;
  else
    kept = j < k - 1 && move(at, j, -moved);
  for (int i = j + 1; kept && i < k; i++)
    at[i].t -= moved;
  *lost += before - held(at, k - 1);
}

/* Of k joints the one that goes with the least error, as a share of mu N where it lies. */
static inline int least(const struct piece at[], int k) {
  int best = 1;
  double lowest = INFINITY;
  for (int j = 1; j <= k; j++) {
    const double share = error(&at[j - 1], &at[j], &at[j + 1]) / at[j].n;
    if (share < lowest)
      best = j, lowest = share;
  }
  return best;
}

/* Piece k + 1 ends at `end`, unless it is little enough to join piece k. */
static inline void append(struct leg *leg, struct piece at[], int k, struct piece end, int most) {
  leg->pieces = k;
  if (!(end.x > at[k].x)) /* a slip too small to be one */
    return;
  at[k + 1] = end;
  if (k > 0 && error(&at[k - 1], &at[k], &end) < little * end.n)
    join(at, k, k + 1, &leg->lost);
  else if (k < most)
    leg->pieces++;
  else
    join_kept(at, least(at, k), k + 1, &leg->lost);
}

/* Int n(x) - n(x') - n'(x')(x - x') dx' up to x', at a middle overlap x: what a front that passes x' loses. */
static inline double passed(const struct piece *at, double x, double n) { return n * at->x + at->n * (at->x / 5 - x); }

static inline struct leg go(struct piece at[], int k, double x, double n, double u, int most) {
  struct leg leg = {0};
  const double middle = (at[k].x + x) / 2, force = middle * sqrt(middle);
  if (x < at[k].x) {
    while (at[k - 1].x >= x)
      k--;
    at[k] = within(&at[k], x, n);
  }
  double beyond = fabs(u - at[k].u) - (x - at[k].x); /* what full slip from the end of piece k on falls short of u */
  if (beyond <= 0) {                                 /* the new ring sticks */
    const double d = x > at[k].x ? (u - at[k].u) / (x - at[k].x) : 0;
    append(&leg, at, k, (struct piece){x, n, u, at[k].t + d * (n - at[k].n), 0}, most);
    return leg;
  }
  const double s = u > at[k].u ? 1 : -1;
  double short_of = beyond;
  while (k > 0 && (short_of = s * (u - at[k - 1].u) - (x - at[k - 1].x)) > 0) {
    leg.lost += (1 - s * (at[k].u - at[k - 1].u) / (at[k].x - at[k - 1].x)) *
                (passed(&at[k], middle, force) - passed(&at[k - 1], middle, force));
    k--, beyond = short_of;
  }
  if (k == 0) { /* no front left */
    leg.slid = beyond;
    u = s * x;
  } else {
    const double c = at[k - 1].x + short_of / (short_of - beyond) * (at[k].x - at[k - 1].x);
    const struct piece front = within(&at[k], c, c * sqrt(c));
    leg.lost += (1 - s * (at[k].u - at[k - 1].u) / (at[k].x - at[k - 1].x)) *
                (passed(&at[k], middle, force) - passed(&front, middle, force));
    at[k] = front;
    if (!(c > at[k - 1].x))
      k--;
  }
  leg.lost += leg.slid * force;
  append(&leg, at, k, (struct piece){x, n, u, at[k].t + s * (n - at[k].n), 0}, most);
  return leg;
}

/* With another friction: the path goes anew, in the same memory, since no leg makes more than one piece. */
static inline struct leg go_anew(struct piece at[], int pieces, double share, int most) {
  struct leg all = {.lost = share * share * held(at, pieces)};
  double from = 0;
  for (int k = 1; k <= pieces; k++) {
    const struct piece end = at[k];
    all.pieces = go(at, all.pieces, end.x, end.n, at[all.pieces].u + share * (end.u - from), most).pieces;
    from = end.u;
  }
  all.lost -= held(at, all.pieces);
  return all;
}

static inline struct nb_shear shear_mindlin_deresiewicz(struct nb_pair p, struct nb_normal n, double slip, double m[]) {
  const double kappa = p.young / (4 * p.shear), unit = p.friction * kappa; /* m of slip in a metre of u */
  const double x = n.radius * n.radius / p.radius, force = x * sqrt(x), limit = p.friction * n.force;
  struct piece *at = (struct piece *)(m + HEAD);
  struct nb_shear out = {.stiffness = 8 * p.shear * n.radius};
  if (!(unit > 0) || !(x > 0)) { /* without friction; let go by a normal law before the outlines part */
    m[0] = 0, out.sliding = x > 0 ? 1 : 0;
    return out;
  }
  if (m[0] == 0)
    at[0] = (struct piece){0}, m[1] = unit;
  int k = (int)m[0];
  const int most = (int)p.pieces;
  double again = 0;
  if (m[1] != unit) {
    const struct leg anew = go_anew(at, k, m[1] / unit, most);
    k = anew.pieces, again = anew.lost, m[1] = unit;
  }
  const struct leg leg = go(at, k, x, force, at[k].u + slip / unit, most);
  m[0] = leg.pieces;
  const double share = force > 0 ? at[leg.pieces].t / force : 0; /* 0 of the smallest overlap there is */
  out.force = limit * (share > 1 ? 1 : share < -1 ? -1 : share);
  out.sliding = leg.slid > 0 ? 1 : 0;
  out.lost = unit * (limit / force) * (leg.lost + again);
  return out;
}

static double shear_mindlin_deresiewicz_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  const struct piece *at = (const struct piece *)(m + HEAD);
  const int pieces = (int)m[0];
  const double kappa = p.young / (4 * p.shear);
  return pieces > 0 ? m[1] * m[1] / kappa * (n.force / at[pieces].n) * held(at, pieces) : 0;
}

/* From inside to outside: where pieces end, m, and their D. */
static int shear_mindlin_deresiewicz_pieces(struct nb_pair p, struct nb_normal n, const double m[], double x[],
                                            double d[]) {
  (void)p, (void)n;
  const struct piece *at = (const struct piece *)(m + HEAD);
  for (int k = 1; k <= (int)m[0]; k++)
    x[k - 1] = at[k].x, d[k - 1] = (at[k].u - at[k - 1].u) / (at[k].x - at[k - 1].x);
  return (int)m[0];
}

#define LAW shear_mindlin_deresiewicz
#define SHEAR
#define ELASTIC
#define BRANCHING
#define LOSES
#define COHESIONLESS
#define TITLE "exact law of elastic spheres, Cattaneo and Mindlin's, under any history"
#define SOURCE "[R89 3.2-3.5]"
#define MEMORY 13
#define PIECE 5
#define PIECES 16
#define STORED shear_mindlin_deresiewicz_stored
#define PIECES_OF shear_mindlin_deresiewicz_pieces
#include "law_batch.h"
