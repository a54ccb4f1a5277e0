/* The exact law of Cattaneo and Mindlin under any history of approach and slip:
 *
 *   T = mu Int_0^alpha D dN(x),      delta = mu kappa Int_0^alpha D dx,      -1 <= D(x) <= 1,      kappa = E* / 4 G*
 *
 *   alpha, N  overlap, m, and Hertz's force at it, N(x) = N (x/alpha)^(3/2); alpha = a^2/R*, what belongs to the force
 *   delta     tangential displacement since nothing slid as a whole, m;  T  the force that it makes, N
 *   D(x)      what the ring that grew at the overlap x carries, 1: a share of its friction; 1 or -1 where it has slipped
 *   mu        the smaller friction of the two materials, 1
 *
 * D is piecewise constant: delta(x) = mu kappa Int_0^x D is a path of straight pieces with corners, the path of approach and slip
 * that would make the contact. One step, to alpha and delta: of the corners those go from which no path with |D| <= 1 leads there, which
 *
 *   |delta - delta_k| <= mu kappa (alpha - x_k)
 *
 * says. If the last one stays, a new ring sticks, with D = d(delta)/(mu kappa d(alpha)). If an inner one does, the path goes on from
 * there on its old piece up to the front c, and from c to alpha with D = s, s = 1 or -1, which has slipped. If none stays, not
 * the one at 0 either, the contact slides. No step size enters: a step is exact where (alpha, delta) moves on a straight line,
 * and on a path of as many legs as there is room for pieces.
 *
 * A piece that makes delta(x) wrong by less than 1e-7 mu kappa alpha joins the one before it, keeping delta. With no room left two
 * others join (corners.h). On contacts that ring down in 20 to 3000 turns and come back, T is wrong by at most 1.2e-4 mu N with the 64
 * pieces of a contact by default, as measured (docs/CONTACT.md). What joining changes of the energy stored counts as lost, at times less than 0.
 *
 * Stores     Int_0^alpha T(x) d(delta). The tractions are a sum of flat punches of the radii a(x), each displaced by d(delta)(x):
 *            forces 8 G* a(x) d(delta). One of radius a(x) displaces all that a smaller one, at y, presses by the whole of its
 *            d(delta), so by reciprocity the energy of the two together is the smaller one's force times that, and
 *            U = Int d(delta)(x) Int_(y < x) 8 G* a(y) d(delta)(y), where the inner integral is T(x).
 * Loses      a front that goes in from c to c - dc takes d(delta) = mu kappa (1 - s D) dc, and of the work T d(delta)
 *            mu^2 kappa (1 - s D) [N(alpha) - N(c) - N'(c)(alpha - c)] dc  is not stored; a slide takes mu N of each metre. Both with
 *            alpha as it is when the front is there, so that the sum is exact on a straight leg on which slip keeps its sense.
 * Source     Jaeger (1993-1998); Aleshin, Bou Matar and Van Den Abeele (2015). All cases of Mindlin and Deresiewicz
 *            (1953) follow: [R89 3.25, 3.40, 3.50, 3.94].
 * Range      slip along one line; no coupling of normal and tangential motion; a friction of the stress, so no cohesion. When
 *            friction changes, the path of the pieces is gone anew: nothing moves where it grows.
 * Remembers  x R* for x, which is the square of a radius, m2, and of the rest what mu, E* and N have no part in:
 *            n = x^(3/2), m3; u = R* delta/(mu kappa), m2; t = Int D dn, m3, so that T/mu N = t/n at alpha
 *            m[0]  how many pieces; 0: none;  m[1]  mu kappa, which they are made with
 *            m[2 + 5k ...]  the corner at which piece k begins, from inside to outside (corners.h); piece 0 begins at 0
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>

#include "corners.h"

static const double little = 1e-7 / 1.5; /* of x, in u: 1e-7 mu N in T */
/* The largest ratio of the old friction to the new one: with a larger one all slides as well, and its square is finite. */
static const double most_fraction = 1e150;

static inline double unit_of(struct nb_pair p) { return p.friction * p.young / (4 * p.shear); }
static inline double u_of(struct nb_pair p, double ds) { return ds * p.radius * (1 / unit_of(p)); }

/* A friction whose inverse a double cannot hold counts as none. */
static inline bool has_friction(struct nb_pair p) { return unit_of(p) >= DBL_MIN; }

/* Nothing rubs without friction, nor where a normal law lets go before the outlines part. */
static inline bool can_slide(struct nb_pair p, struct nb_normal n) {
  return has_friction(p) && n.radius * n.radius * n.radius > 0;
}

/* From where a leg of the path, to an overlap x and a slip u, goes on: the outermost corner that stays. */
struct met {
  double k;          /* the piece that comes to be: behind k others; below 0: none has been met */
  double x, u, d, b; /* the corner */
  double from;       /* where the piece before the new one begins */
};

/* The piece that comes to be, and u at its end. */
struct segment {
  double k; /* below 0: by rounding there may be none, or it may join the one before it */
  double x, u, d, b, end;
};

static inline NB_FORM struct segment makes(struct met at, bool ring, double x, double u) {
  const double h = x - at.x, wanted = u - at.u, s = copysign(1, wanted - at.d * h);
  const double v = fabs(wanted) > h ? s * h : wanted; /* more: it slides */
  const double part = (ring ? v : h - s * v) / (ring ? h : 1 - s * at.d), in = at.x + part;
  const double d = ring ? part : s, c = ring ? at.x : in < x ? in : x;
  const double x1 = c - at.from, x2 = x - c, end = at.u + v;
  const double k = bend(at.d, d, x1, x2) > little * x * (x1 + x2) ? at.k : -1;
  return (struct segment){k, c, end - d * x2, d, at.b + (at.d - d) * n_of(c), end};
}

/* Of all corners; if none stays, all slides from the one at 0. */
static inline struct met seek(const struct corner at[], int pieces, double x, double u) {
  int k = pieces;
  while (k > 0 && !stays(at[k].x, at[k].u, x, u))
    k--;
  const int piece = k < pieces ? k + 1 : k;
  return (struct met){piece, at[k].x, at[k].u, at[k].d, at[k].b, at[piece > 0 ? piece - 1 : 0].x};
}

static inline NB_FORM void lay(struct corner at[], int k, double x, const struct segment *segment) {
  at[k] = (struct corner){segment->x, segment->u, segment->d, segment->b, 0};
  at[k + 1] = (struct corner){x, segment->end, segment->d, segment->b, 0};
}

/* A piece that is little enough joins the last; so does one that there is no room for. Answers how many there are then. */
static int lay_or_join(struct corner at[], int k, double x, const struct segment *segment, int most,
                       double *dissipated) {
  if (!(segment->x < x)) { /* nothing new */
    at[k] = (struct corner){x, segment->end, at[k - 1].d, at[k - 1].b, 0};
    return k;
  }
  if (k > 0 && !(segment->x > at[k - 1].x)) /* nothing left of the one before */
    k--;
  lay(at, k, x, segment);
  const int pieces = k + 1;
  if (k == 0)
    return pieces;
  const double x1 = at[k].x - at[k - 1].x, x2 = x - at[k].x;
  const bool joins = bend(at[k - 1].d, segment->d, x1, x2) < little * x * (x1 + x2) - at[k - 1].e;
  if (!joins && k < most)
    return pieces;
  if (dissipated)
    *dissipated += held_by(at, pieces);
  if (joins)
    join(at, k, pieces);
  else
    make_room(at, pieces);
  if (dissipated)
    *dissipated -= held_by(at, k);
  at[k].d = at[k - 1].d, at[k].b = at[k - 1].b;
  return k;
}

/* What a leg loses, to the front, through the end of the piece before the new one and all behind it, and to a slide; as Int t du. With
 * slip in the sense s the front is where y - s u(y) is as much as x - s u at the edge, g, which falls along the leg; below 0 all slides. */
static double dissipative(const struct corner at[], int pieces, double x, double u, int piece,
                          const struct segment *segment) {
  const double s = at[piece].x < x ? copysign(1, u - at[piece].u) : segment->d; /* at a corner leg->d may be rounding */
  const double x0 = at[pieces].x, g0 = x0 - s * at[pieces].u, g1 = x - s * u, fall = g0 - g1;
  if (!(fall > 0))
    return 0;
  double g = g1 > 0 ? g1 : 0,
         y = segment->x < at[piece].x ? segment->x : at[piece].x; /* with D = s there the front may be anywhere */
  double now = g < g0 ? x + (x0 - x) * ((g - g1) / fall) : x0;    /* the overlap as the front is at y */
  double sum = g1 < 0 ? -g1 * mean_n(x, now) : 0;
  for (int k = piece > 0 ? piece - 1 : 0; k < pieces; k++) {
    const double to = at[k + 1].x;
    if (!(y < to))
      continue;
    g += (1 - s * at[k].d) * (to - y);
    const double then = g < g0 ? x + (x0 - x) * ((g - g1) / fall) : x0;
    sum += (1 - s * at[k].d) * passed(y, now, to, then);
    y = to, now = then;
  }
  return sum;
}

/* Any leg, one by one; answers how many pieces there are then. */
static NB_SELDOM int go(struct corner at[], int pieces, double x, double u, int most, double *dissipated) {
  const struct met met = seek(at, pieces, x, u);
  const int piece = (int)met.k;
  const struct segment segment = makes(met, stays(at[pieces].x, at[pieces].u, x, u), x, u);
  if (dissipated)
    *dissipated += dissipative(at, pieces, x, u, piece, &segment);
  return lay_or_join(at, piece, x, &segment, most, dissipated);
}

/* With another friction the path goes anew, in the same memory: a leg makes at most one piece. Returns the loss. */
static NB_SELDOM double go_anew(struct corner at[], double *count, double fraction, int most) {
  const int pieces = (int)*count;
  const double held = fraction * fraction * held_by(at, pieces);
  double from = 0;
  int k = 0;
  at[0] = (struct corner){0};
  for (int i = 1; i <= pieces; i++) {
    const double u = at[k].u + fraction * (at[i].u - from);
    from = at[i].u;
    k = go(at, k, at[i].x, u, most, NULL);
  }
  *count = k;
  return held - held_by(at, k);
}

/* ---- in a block, see law_stages.h: what is seen of the last four corners, of which one stays in most steps; what a leg
 * makes of them; and what is left of the leg ---- */

struct seen {
  double x, u, d, b;
};
struct found {
  double pieces;
  struct seen end, last, next, third;
};

static inline struct seen seen(const struct corner *at) { return (struct seen){at->x, at->u, at->d, at->b}; }

static inline NB_FORM struct found shear_mindlin_deresiewicz_look(struct nb_pair p, struct nb_normal n, double m[]) {
  struct corner *at = (struct corner *)(m + HEAD);
  if (!can_slide(p, n))
    m[0] = 0;
  if (m[0] == 0) {
    at[0] = (struct corner){0};
  } else if (m[1] != unit_of(p)) {
    const double dissipated = go_anew(at, &m[0], fmin(m[1] / unit_of(p), most_fraction), (int)p.pieces);
    at[(int)m[0]].e = dissipated; /* until it is told */
  }
  m[1] = unit_of(p);
  const int k = (int)m[0];
  return (struct found){m[0], seen(&at[k]), seen(&at[k > 0 ? k - 1 : 0]), seen(&at[k > 1 ? k - 2 : 0]),
                        seen(&at[k > 2 ? k - 3 : 0])};
}

/* This corner, of piece k, if it stays; else what has been met farther in. */
static inline struct met meets(struct seen at, double k, double x, double u, struct met inner) {
  const bool here = stays(at.x, at.u, x, u);
  return (struct met){.k = here ? k : inner.k,
                      .x = here ? at.x : inner.x,
                      .u = here ? at.u : inner.u,
                      .d = here ? at.d : inner.d,
                      .b = here ? at.b : inner.b};
}

static inline NB_FORM double force_of(struct nb_pair p, struct nb_normal n, double d, double b) {
  return p.friction * n.force * (d + b / (n.radius * n.radius * n.radius));
}

static inline NB_FORM struct nb_shear shear_mindlin_deresiewicz_solve(struct nb_pair p, struct nb_normal n, double ds,
                                                                      struct found at, struct segment *segment) {
  const double x = n.radius * n.radius, u = at.end.u + u_of(p, ds);
  struct met met = {.k = -1};
  met = meets(at.third, at.pieces - 2, x, u, met);
  met = meets(at.next, at.pieces - 1, x, u, met);
  met = meets(at.last, at.pieces, x, u, met);
  met = meets(at.end, at.pieces, x, u, met);
  const bool ring = stays(at.end.x, at.end.u, x, u);
  met.from = ring ? at.last.x : met.x;
  *segment = makes(met, ring, x, u);
  return (struct nb_shear){.force = force_of(p, n, segment->d, segment->b), .stiffness = 8 * p.shear * n.radius};
}

static NB_SELDOM void go_seldom(struct nb_pair p, struct nb_normal n, double ds, double m[], struct nb_shear *out,
                                double *dissipated) {
  struct corner *at = (struct corner *)(m + HEAD);
  if (!can_slide(p, n)) {
    out->force = 0, out->sliding = has_friction(p) ? 0 : 1;
    return;
  }
  const double x = n.radius * n.radius, u = at[(int)m[0]].u + u_of(p, ds);
  const int pieces = go(at, (int)m[0], x, u, (int)p.pieces, dissipated);
  m[0] = pieces;
  out->sliding = fabs(u) > x ? 1 : 0;
  out->force = force_of(p, n, at[pieces].d, at[pieces].b);
}

/* A leg that has not met its corner, or is no more than rounding or the piece too much, goes one by one. */
static inline NB_FORM void shear_mindlin_deresiewicz_settle(struct nb_pair p, struct nb_normal n, double ds, double m[],
                                                            struct segment segment, struct nb_shear *out, bool counts) {
  struct corner *at = (struct corner *)(m + HEAD);
  const double x = n.radius * n.radius;
  double dissipated = at[(int)m[0]].e; /* before, with another friction */
  if (segment.k >= 0 && segment.k < p.pieces) {
    if (counts)
      dissipated += dissipative(at, (int)m[0], x, segment.end, (int)segment.k, &segment);
    lay(at, (int)segment.k, x, &segment);
    m[0] = segment.k + 1;
  } else {
    go_seldom(p, n, ds, m, out, counts ? &dissipated : NULL);
  }
  if (counts && m[0] > 0)
    out->dissipated = unit_of(p) / p.radius * (p.friction * n.force / (x * n.radius)) * dissipated;
}

static double shear_mindlin_deresiewicz_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  const struct corner *at = (const struct corner *)(m + HEAD);
  const int pieces = (int)m[0];
  const double friction = m[1] * 4 * p.shear / p.young;
  return pieces > 0 ? m[1] / p.radius * friction * (n.force / n_of(at[pieces].x)) * held_by(at, pieces) : 0;
}

/* From inside to outside: where pieces end, m, and their D. */
static int shear_mindlin_deresiewicz_pieces(struct nb_pair p, struct nb_normal n, const double m[], double x[],
                                            double d[]) {
  (void)n;
  const struct corner *at = (const struct corner *)(m + HEAD);
  for (int k = 0; k < (int)m[0]; k++)
    x[k] = at[k + 1].x / p.radius, d[k] = at[k].d;
  return (int)m[0];
}

/* The last corners, and room for one more. */
static inline void shear_mindlin_deresiewicz_ahead(const double m[]) {
  for (int line = -2; line < 2; line++)
    __builtin_prefetch(&m[m[0] > 2 ? HEAD + 5 * (int)m[0] + 8 * line + 1 : 0], 1);
}

#define LAW shear_mindlin_deresiewicz
#define SHEAR
#define ELASTIC
#define STAGED
#define FOUND struct found
#define SOLVED struct segment
#define DISSIPATIVE
#define COHESIONLESS
#define TITLE "exact law of elastic spheres, Cattaneo and Mindlin's, under any history"
#define SOURCE "[R89 3.2-3.5]"
#define PARAMETERS "young, poisson, friction"
#define MEMORY 12
#define PIECE 5
#define PIECES 64
#define STORED shear_mindlin_deresiewicz_stored
#define AHEAD shear_mindlin_deresiewicz_ahead
#define USED corners_used
#define VALID corners_valid
#define PIECES_OF shear_mindlin_deresiewicz_pieces
#include "law_batch.h"
