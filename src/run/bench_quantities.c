/* What is seen of the contact on the bench.
 *
 * The traction over the contact circle, from D(x) of a law that keeps its history in pieces (docs/CONTACT.md, v).
 *
 *   p(r; x)  Hertz's pressure at the radius r when the overlap was x, (2 E* / (pi R*)) sqrt(R* x - r^2) inside the circle, Pa
 *   q(r)     mu times the integral of D(x) dp(r; x): each ring x carries D of what its pressure adds, Pa
 *   T        mu times the integral of D(x) dN(x), N: the integral of q over the circle
 *
 * D is constant over a piece, so its part of q is mu D (p(r; x_i) - p(r; x_(i-1))): the difference of two Hertz pressures, as
 * in [R89 3.23, 3.35].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bench.h"

#include "core/names.h"
#include "input/bench_quantities.h"
#include "measure/snapshot.h"

/* What the shear law keeps of its history: D is D[i] from the overlap x[i-1] (0 at first) to x[i]. */
struct history {
  int count;                                 /* 0: the law keeps none, or nothing touches */
  double x[NB_PIECES_MAX], D[NB_PIECES_MAX]; /* m, 1 */
};

static struct history history_of(const struct nb_bench *bench) {
  struct history history = {0};
  const struct nb_bench_state *now = &bench->now;
  if (bench->shear->pieces_of && now->n.overlap > 0)
    history.count = bench->shear->pieces_of(bench->pair, now->n, now->shear_memory, history.x, history.D);
  return history;
}

/* D of a ring that slipped is 1 or -1 but for the rounding of the law that worked it out. */
static bool slipped(double D, double sense) { return D * sense > 1 - 1e-9; }

static double stick(const struct nb_bench *bench) {
  const struct history history = history_of(bench);
  int edge = history.count; /* from the edge inwards, as far as all has slipped in one sense */
  const double sense = edge && history.D[edge - 1] < 0 ? -1 : 1;
  while (edge > 0 && slipped(history.D[edge - 1], sense))
    edge--;
  return edge > 0 ? sqrt(bench->pair.radius * history.x[edge - 1]) : 0;
}

/* p(r; x), Pa */
static double pressure(struct nb_pair p, double r, double x) {
  const double square = p.radius * x - r * r;
  return square > 0 ? 2 * p.young / (NB_PI * p.radius) * sqrt(square) : 0;
}

static double traction_at(const struct nb_bench *bench, const struct history *history, double r) {
  double q = 0, inner = 0;
  for (int i = 0; i < history->count; i++) {
    const double outer = pressure(bench->pair, r, history->x[i]);
    q += bench->pair.friction * history->D[i] * (outer - inner);
    inner = outer;
  }
  return q;
}

/* dA = pi d(r^2), from the centre to the edge of the contact, piece by piece by Simpson's rule in w: r^2 = to - (to - from) w^2
 * makes the root at a piece's edge a straight line. */
static double traction(const struct nb_bench *bench) {
  enum { HALVES = 100 };
  const struct history history = history_of(bench);
  double sum = 0;
  for (int i = 0; i < history.count; i++) {
    const double from = i ? bench->pair.radius * history.x[i - 1] : 0, to = bench->pair.radius * history.x[i];
    for (int k = 0; k <= HALVES; k++) {
      const double w = (double)k / HALVES, r = sqrt(k < HALVES ? to - (to - from) * w * w : from);
      const double weight = (k == 0 || k == HALVES ? 1 : k % 2 ? 4 : 2) / (3. * HALVES);
      sum += weight * traction_at(bench, &history, r) * 2 * NB_PI * (to - from) * w;
    }
  }
  return sum;
}

/* ---- quantities ---- */

#define ON_BENCH(function, expression)                                                                                 \
  static double function(const struct nb_bench *bench) { return expression; }
ON_BENCH(step, (double)bench->step)
ON_BENCH(approach, bench->now.approach)
ON_BENCH(overlap, bench->now.n.overlap)
ON_BENCH(slip, bench->now.slip)
ON_BENCH(normal, bench->now.n.force)
ON_BENCH(shear, bench->now.s.force)
ON_BENCH(limit, bench->pair.friction * bench->now.n.force + bench->pair.cohesion)
ON_BENCH(sliding, bench->now.s.sliding)
ON_BENCH(radius, bench->now.n.radius)
ON_BENCH(work, bench->work_normal + bench->work_shear)
ON_BENCH(work_normal, bench->work_normal)
ON_BENCH(work_shear, bench->work_shear)
ON_BENCH(stored_normal, bench->normal->stored(bench->pair, bench->now.n, bench->now.normal_memory))
ON_BENCH(stored_shear, bench->shear->stored(bench->pair, bench->now.n, bench->now.shear_memory))
ON_BENCH(stored, stored_normal(bench) + stored_shear(bench))
ON_BENCH(lost, bench->lost)
ON_BENCH(pieces, history_of(bench).count)

double nb_bench_value(struct nb_quantity quantity, const struct nb_bench *bench) {
#define ROW(function, name, unit, asks, help) function,
  static double (*const values[])(const struct nb_bench *bench) = {NB_BENCH_QUANTITIES(ROW)};
#undef ROW
  return values[quantity.kind - nb_bench_kinds](bench);
}

/* ---- snapshots ---- */

/* From the edge of the circle to its centre: pressure, traction, and what friction would allow. */
static bool see_traction(struct nb_table *table, const struct nb_bench *bench, const struct history *history,
                         int stage) {
  enum { POINTS = 400 };
  static const struct nb_head columns[] = {{"r", "m"}, {"pressure", "Pa"}, {"traction", "Pa"}, {"limit", "Pa"}};
  const double square = bench->pair.radius * bench->now.n.overlap;
  if (!nb_snapshot_table(table, bench->scene, columns, 4))
    return false;
  for (int k = 0; k <= POINTS; k++) {
    const double r = sqrt(square) * sin(NB_PI / 2 * k / POINTS), p = pressure(bench->pair, r, bench->now.n.overlap);
    double *row = nb_table_row(table, stage, (double)bench->step, 0);
    if (!row)
      return false;
    row[0] = r, row[1] = p, row[2] = traction_at(bench, history, r), row[3] = bench->pair.friction * p;
  }
  return true;
}

/* Two rows for each piece, its inner edge and its outer one, so that a line through them is D(x). */
static bool see_pieces(struct nb_table *table, const struct nb_bench *bench, const struct history *history, int stage) {
  static const struct nb_head columns[] = {{"x", "m"}, {"r", "m"}, {"D", "1"}};
  if (!nb_snapshot_table(table, bench->scene, columns, 3))
    return false;
  for (int k = 0; k < 2 * history->count; k++) {
    const int i = k / 2;
    double *row = nb_table_row(table, stage, (double)bench->step, 0);
    if (!row)
      return false;
    row[0] = k % 2 ? history->x[i] : i ? history->x[i - 1] : 0;
    row[1] = sqrt(bench->pair.radius * row[0]), row[2] = history->D[i];
  }
  return true;
}

bool nb_bench_snapshot(struct nb_snapshot *snapshot, const struct nb_bench *bench, int stage) {
  const struct history history = history_of(bench);
  *snapshot = (struct nb_snapshot){.stage = stage};
  return see_traction(&snapshot->traction, bench, &history, stage) &&
         see_pieces(&snapshot->pieces, bench, &history, stage);
}
