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
 * A piece that makes delta(x) wrong by less than 1e-7 mu kappa alpha joins the one before it, keeping delta. With no room left
 * those two join whose union makes delta(x) least wrong as a share of x, |D_1 - D_2| x_1 x_2/(x_1 + x_2), x_1, x_2 their
 * spans, and what is wrong in them already. The joint beside them
 * then moves so that T is kept as well: what is wrong stays within those three pieces, and nothing adds up over the steps. With
 * 16 pieces T is off by less than 8e-4 mu N, and by 3e-5 mu N on average, on 1000 rough chance steps or 400 smooth ones that
 * turn every few (tests/exact.c).
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
 * Remembers  x R* for x, which is the square of a radius, m2, and of the rest what mu, E* and N have no part in:
 *            n = x^(3/2), m3; u = R* delta/(mu kappa), m2; t = Int D dn, m3, so that T/mu N = t/n at alpha
 *            m[0]  how many pieces; 0: none;  m[1]  mu kappa, which they are made with
 *            m[3 + 5k ...]  piece k, from inside to outside, the origin is piece 0: x, where it ends; D; a and b, with which
 *                           u = a + D x and t = b + D n on it; e, how wrong u is on it at most
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

enum { HEAD = 3 };
static const double little = 1e-7 / 1.5; /* of x, in u: 1e-7 mu N in T */

struct piece {
  double x, d, a, b, e;
};

static inline double n_of(double x) { return x * sqrt(x); }
static inline double u_at(const struct piece *piece, double x) { return piece->a + piece->d * x; }

/* Int t du over a piece, from x on. */
static inline double held(const struct piece *piece, double x) {
  return piece->d * (piece->b * (piece->x - x) + 0.4 * piece->d * (piece->x * n_of(piece->x) - x * n_of(x)));
}
static inline double held_by(const struct piece at[], int pieces) {
  double sum = 0;
  for (int k = 1; k <= pieces; k++)
    sum += held(&at[k], at[k - 1].x);
  return sum;
}

/* What u is wrong by at the joint of two pieces when it goes, times x1 + x2, their spans. */
static inline double bend(double d1, double d2, double x1, double x2) { return fabs(d1 - d2) * (x1 * x2); }

/* Two pieces in one, from x on, with the same delta. */
static inline struct piece both(const struct piece *one, const struct piece *two, double x) {
  const double u = u_at(two, two->x), x1 = one->x - x, x2 = two->x - one->x, d = (u - u_at(one, x)) / (two->x - x);
  return (struct piece){two->x, d, u - d * two->x, one->b + (one->d - d) * n_of(x),
                        one->e + two->e + bend(one->d, two->d, x1, x2) / (x1 + x2)};
}

/* What a leg of the path, to an overlap x and a slip u, makes of the pieces. */
struct leg {
  int pieces;
  double d, b; /* of the last one */
  double slid; /* as a whole, as u */
  double lost; /* to fronts that went in, to the slide and to pieces that joined; as Int t du */
};

/* Moves joint j along u, so that t behind piece j + 1 grows by `more`; false if a ring would carry more than its friction then. */
static inline bool move(struct piece at[], int j, double more) {
  const double x0 = at[j - 1].x, x1 = at[j].x, x2 = at[j + 1].x, n0 = n_of(x0), n1 = n_of(x1);
  const double by = more / ((n1 - n0) / (x1 - x0) - (n_of(x2) - n1) / (x2 - x1));
  const double d1 = at[j].d + by / (x1 - x0), d2 = at[j + 1].d - by / (x2 - x1);
  if (!(fabs(d1) <= 1 && fabs(d2) <= 1))
    return false;
  at[j].a += (at[j].d - d1) * x0, at[j].b += (at[j].d - d1) * n0, at[j].d = d1;
  at[j + 1].a += (at[j + 1].d - d2) * x2, at[j + 1].b = at[j].b + (d1 - d2) * n1, at[j + 1].d = d2;
  return true;
}

/* Of k joints the one goes that makes u least wrong, as a share of x, and one beside it moves, so that neither delta nor T changes. */
static NB_SELDOM void make_room(struct piece at[], int k) {
  int j = 1;
  double lowest = INFINITY;
  for (int i = 1; i <= k; i++) {
    const double x1 = at[i].x - at[i - 1].x, x2 = at[i + 1].x - at[i].x;
    const double wrong = (at[i].e + at[i + 1].e) * (x1 + x2) + bend(at[i].d, at[i + 1].d, x1, x2);
    const double share = wrong / ((x1 + x2) * at[i].x);
    j = share < lowest ? i : j, lowest = share < lowest ? share : lowest;
  }
  const struct piece one = both(&at[j], &at[j + 1], at[j - 1].x);
  const double moved = one.b - at[j + 1].b + (one.d - at[j + 1].d) * n_of(one.x);
  at[j] = one;
  for (int i = j + 1; i <= k; i++)
    at[i] = at[i + 1];
  if ((j > 1 && move(at, j - 1, -moved)) || (j < k && move(at, j, -moved)))
    return;
  for (int i = j + 1; i <= k; i++)
    at[i].b += moved;
}

/* Another piece behind the k there are, unless it is little enough to join the last. */
static inline NB_FORM void append(struct leg *leg, struct piece at[], int k, struct piece last, int most) {
  const double x1 = at[k].x - at[k - 1].x, x2 = last.x - at[k].x;
  at[k + 1] = last;
  leg->lost += held_by(at, k + 1);
  leg->d = last.d, leg->b = last.b, leg->pieces = k + 1;
  const bool joins = bend(at[k].d, last.d, x1, x2) < (little * last.x - at[k].e) * (x1 + x2);
  if (joins || k == most) {
    if (joins)
      at[k] = both(&at[k], &last, at[k - 1].x);
    else
      make_room(at, k);
    leg->d = at[k].d, leg->b = at[k].b, leg->pieces = k;
  }
  leg->lost -= held_by(at, leg->pieces);
}

/* Int n(x) - n(x') - n'(x')(x - x') dx' up to x', at a middle overlap x: what a front that passes x' loses. */
static inline double passed(double to, double x, double n) { return n * to + n_of(to) * (to / 5 - x); }

static inline NB_FORM struct leg go(struct piece at[], int k, double x, double u, int most) {
  struct leg leg = {.pieces = k};
  const double middle = (at[k].x + x) / 2, force = n_of(middle);
  while (k > 1 && at[k - 1].x >= x) /* gone */
    k--;
  const double edge = at[k].x < x ? at[k].x : x, missing = u - u_at(&at[k], edge);
  if (fabs(missing) <= x - edge) { /* the new ring sticks, if there is one */
    const double d = x > edge ? missing / (x - edge) : at[k].d;
    const struct piece ring = {x, d, u - d * x, at[k].b + (at[k].d - d) * n_of(edge), 0};
    at[k].x = edge, leg.pieces = k, leg.d = d, leg.b = ring.b;
    if (k == 0)
      at[leg.pieces = 1] = ring;
    else if (x > edge)
      append(&leg, at, k, ring, most);
    return leg;
  }
  const double s = copysign(1, missing), line = s * u - x; /* behind the front, s u(x) = x + line */
  double outer = edge, inner = 0;                          /* the front is so far in from the end of piece k - 1 on */
  for (; k > 0; k--) {
    inner = s * u_at(&at[k], at[k - 1].x) - at[k - 1].x - line;
    if (inner >= 0)
      break;
    leg.lost += (1 - s * at[k].d) * (passed(outer, middle, force) - passed(at[k - 1].x, middle, force));
    outer = at[k - 1].x;
  }
  if (k == 0) { /* no front left */
    leg.slid = line, leg.lost += line * force, leg.pieces = 1, leg.d = s;
    at[1] = (struct piece){x, s, 0, 0, 0};
    return leg;
  }
  const double in = inner / (1 - s * at[k].d), c = at[k - 1].x + in < outer ? at[k - 1].x + in : outer;
  const struct piece slipped = {x, s, s * line, at[k].b + (at[k].d - s) * n_of(c), 0};
  leg.lost += (1 - s * at[k].d) * (passed(outer, middle, force) - passed(c, middle, force));
  at[k].x = c, leg.pieces = k, leg.d = s, leg.b = slipped.b;
  if (!(c > at[k - 1].x))
    at[k] = slipped;
  else if (c < x)
    append(&leg, at, k, slipped, most);
  return leg;
}

/* With another friction: the path goes anew, in the same memory, since no leg makes more than one piece. */
static NB_SELDOM struct leg go_anew(struct piece at[], int pieces, double share, int most) {
  struct leg all = {.lost = share * share * held_by(at, pieces)};
  double from = 0;
  for (int k = 1; k <= pieces; k++) {
    const double x = at[k].x, u = u_at(&at[k], x), now = u_at(&at[all.pieces], at[all.pieces].x);
    all.pieces = go(at, all.pieces, x, now + share * (u - from), most).pieces;
    from = u;
  }
  all.lost -= held_by(at, all.pieces);
  return all;
}

/* The last three pieces: few steps need more. */
static inline void shear_mindlin_deresiewicz_ahead(const double m[]) {
  const double *last = m + HEAD + 5 * (int)m[0];
  __builtin_prefetch(last, 1);
  __builtin_prefetch(last + 5, 1);
  __builtin_prefetch(m[0] > 2 ? last - 10 : m, 1);
}

static inline NB_FORM struct nb_shear shear_mindlin_deresiewicz(struct nb_pair p, struct nb_normal n, double slip,
                                                                double m[]) {
  const double unit = p.friction * p.young / (4 * p.shear), limit = p.friction * n.force;
  const double root = n.radius, x = root * root, force = x * root;
  struct piece *at = (struct piece *)(m + HEAD);
  struct nb_shear out = {.stiffness = 8 * p.shear * n.radius};
  if (!(unit > 0 && force > 0)) { /* without friction; or let go by a normal law before the outlines part */
    m[0] = 0, out.sliding = unit > 0 ? 0 : 1;
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
  const double per_unit = 1 / unit, per_force = 1 / force; /* the first is the same for all contacts of a pairing */
  const struct leg leg = go(at, k, x, u_at(&at[k], at[k].x) + slip * p.radius * per_unit, most);
  m[0] = leg.pieces;
  const double share = leg.d + leg.b * per_force;
  out.force = limit * (share > 1 ? 1 : share < -1 ? -1 : share);
  out.sliding = leg.slid > 0 ? 1 : 0;
  out.lost = unit / p.radius * (limit / force) * (leg.lost + again);
  return out;
}

static double shear_mindlin_deresiewicz_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  const struct piece *at = (const struct piece *)(m + HEAD);
  const int pieces = (int)m[0];
  const double friction = m[1] * 4 * p.shear / p.young;
  return pieces > 0 ? m[1] / p.radius * friction * (n.force / n_of(at[pieces].x)) * held_by(at, pieces) : 0;
}

/* From inside to outside: where pieces end, m, and their D. */
static int shear_mindlin_deresiewicz_pieces(struct nb_pair p, struct nb_normal n, const double m[], double x[],
                                            double d[]) {
  (void)n;
  const struct piece *at = (const struct piece *)(m + HEAD);
  for (int k = 1; k <= (int)m[0]; k++)
    x[k - 1] = at[k].x / p.radius, d[k - 1] = at[k].d;
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
#define AHEAD shear_mindlin_deresiewicz_ahead
#define PIECES_OF shear_mindlin_deresiewicz_pieces
#include "law_batch.h"
