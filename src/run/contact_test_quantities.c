/* Quantities and snapshots of a contact test.
 *
 * The traction over the contact circle follows from the memory diagram D(x) of a law that stores D in pieces
 * (docs/CONTACT.md, equation v).
 *
 *   p(r; x)  Hertz's pressure at the radius r and the overlap x, (2 E* / (pi R*)) sqrt(R* x - r^2) inside the circle,
 *            Pa
 *   q(r)     traction, mu times the integral of D(x) dp(r; x), Pa
 *   T        shear force, N: the integral of q over the circle, which equals mu times the integral of D(x) dN(x)
 *
 * D is constant over a piece, so a piece contributes mu D (p(r; x_i) - p(r; x_(i-1))) to q: the difference of two Hertz
 * pressures, as in [R89 3.23, 3.35].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "contact_test.h"

#include "core/names.h"
#include "input/contact_test_quantities.h"
#include "measure/snapshot.h"

/* The memory diagram of the shear law: D is D[i] between the overlaps x[i-1], or 0 if i is 0, and x[i]. */
struct history {
  int count;                                 /* number of pieces; 0: the law has no pieces, or the contact is open */
  double x[NB_PIECES_MAX], D[NB_PIECES_MAX]; /* m, 1 */
};

static struct history history_of(const struct nb_contact_test *contact_test) {
  struct history history = {0};
  const struct nb_contact_test_state *now = &contact_test->now;
  if (contact_test->shear->pieces_of)
    history.count =
        contact_test->shear->pieces_of(contact_test->pair, now->n, now->shear_history, history.x, history.D);
  return history;
}

/* D of a ring that has slipped is 1 or -1, apart from rounding. */
static bool has_slipped(double D, double sense) { return D * sense > 1 - 1e-9; }

static double stick_radius(const struct nb_contact_test *contact_test) {
  const struct history history = history_of(contact_test);
  int edge = history.count; /* number of pieces inside the outer ones that have slipped in the same direction */
  const double sense = edge && history.D[edge - 1] < 0 ? -1 : 1;
  while (edge > 0 && has_slipped(history.D[edge - 1], sense))
    edge--;
  return edge > 0 ? sqrt(contact_test->pair.radius * history.x[edge - 1]) : 0;
}

/* p(r; x), Pa */
static double pressure(struct nb_pair p, double r, double x) {
  const double square = p.radius * x - r * r;
  return square > 0 ? 2 * p.young / (NB_PI * p.radius) * sqrt(square) : 0;
}

static double traction_at(const struct nb_contact_test *contact_test, const struct history *history, double r) {
  double q = 0, inner = 0;
  for (int i = 0; i < history->count; i++) {
    const double outer = pressure(contact_test->pair, r, history->x[i]);
    q += contact_test->pair.friction * history->D[i] * (outer - inner);
    inner = outer;
  }
  return q;
}

/* The integral of q dA with dA = pi d(r^2), N. Each piece is integrated by Simpson's rule in w. The substitution
 * r^2 = to - (to - from) w^2 makes the square root at the outer edge of a piece linear in w. */
static double traction(const struct nb_contact_test *contact_test) {
  enum { INTERVALS = 100 };
  const struct history history = history_of(contact_test);
  double sum = 0;
  for (int i = 0; i < history.count; i++) {
    const double from = i ? contact_test->pair.radius * history.x[i - 1] : 0,
                 to = contact_test->pair.radius * history.x[i];
    for (int k = 0; k <= INTERVALS; k++) {
      const double w = (double)k / INTERVALS, r = sqrt(k < INTERVALS ? to - (to - from) * w * w : from);
      const double weight = (k == 0 || k == INTERVALS ? 1 : k % 2 ? 4 : 2) / (3. * INTERVALS);
      sum += weight * traction_at(contact_test, &history, r) * 2 * NB_PI * (to - from) * w;
    }
  }
  return sum;
}

/* ---- quantities ---- */

#define ON_CONTACT_TEST(function, expression)                                                                          \
  static double function(const struct nb_contact_test *contact_test) { return expression; }
ON_CONTACT_TEST(step, (double)contact_test->step)
ON_CONTACT_TEST(approach, contact_test->now.approach)
ON_CONTACT_TEST(overlap, contact_test->now.n.overlap)
ON_CONTACT_TEST(slip, contact_test->now.slip)
ON_CONTACT_TEST(normal, contact_test->now.n.force)
ON_CONTACT_TEST(shear, contact_test->now.s.force)
ON_CONTACT_TEST(limit, contact_test->pair.friction * contact_test->now.n.force + contact_test->pair.cohesion)
ON_CONTACT_TEST(sliding, contact_test->now.s.sliding)
ON_CONTACT_TEST(radius, contact_test->now.n.radius)
ON_CONTACT_TEST(work, contact_test->work_normal + contact_test->work_shear)
ON_CONTACT_TEST(work_normal, contact_test->work_normal)
ON_CONTACT_TEST(work_shear, contact_test->work_shear)
ON_CONTACT_TEST(stored_normal,
                contact_test->normal->stored(contact_test->pair, contact_test->now.n, contact_test->now.normal_history))
ON_CONTACT_TEST(stored_shear,
                contact_test->shear->stored(contact_test->pair, contact_test->now.n, contact_test->now.shear_history))
ON_CONTACT_TEST(stored, stored_normal(contact_test) + stored_shear(contact_test))
ON_CONTACT_TEST(dissipated, contact_test->dissipated)
ON_CONTACT_TEST(pieces, history_of(contact_test).count)

double nb_contact_test_value(struct nb_quantity quantity, const struct nb_contact_test *contact_test) {
#define ROW(function, name, unit, requested, bounds, help) function,
  static double (*const values[])(const struct nb_contact_test *contact_test) = {NB_CONTACT_TEST_QUANTITIES(ROW)};
#undef ROW
  return values[quantity.kind - nb_contact_test_kinds](contact_test);
}

/* ---- snapshots ---- */

/* Makes the table of pressure, traction and friction limit against r, from the centre of the contact circle to its
 * edge. */
static bool tabulate_traction(struct nb_table *table, const struct nb_contact_test *contact_test,
                              const struct history *history, int stage) {
  enum { POINTS = 400 };
  static const struct nb_table_column columns[] = {{"r", "m"}, {"pressure", "Pa"}, {"traction", "Pa"}, {"limit", "Pa"}};
  const double square = contact_test->pair.radius * contact_test->now.n.overlap;
  if (!nb_snapshot_table(table, contact_test->scene, columns, 4))
    return false;
  for (int k = 0; k <= POINTS; k++) {
    const double r = sqrt(square) * sin(NB_PI / 2 * k / POINTS),
                 p = pressure(contact_test->pair, r, contact_test->now.n.overlap);
    double *row = nb_table_row(table, stage, (double)contact_test->step, 0);
    if (!row)
      return false;
    row[0] = r, row[1] = p, row[2] = traction_at(contact_test, history, r), row[3] = contact_test->pair.friction * p;
  }
  return true;
}

/* Makes the table of D. It has two rows for each piece, at its inner and its outer edge, so that a line through the
 * rows plots D(x). */
static bool tabulate_pieces(struct nb_table *table, const struct nb_contact_test *contact_test,
                            const struct history *history, int stage) {
  static const struct nb_table_column columns[] = {{"x", "m"}, {"r", "m"}, {"D", "1"}};
  if (!nb_snapshot_table(table, contact_test->scene, columns, 3))
    return false;
  for (int k = 0; k < 2 * history->count; k++) {
    const int i = k / 2;
    double *row = nb_table_row(table, stage, (double)contact_test->step, 0);
    if (!row)
      return false;
    row[0] = k % 2 ? history->x[i] : i ? history->x[i - 1] : 0;
    row[1] = sqrt(contact_test->pair.radius * row[0]), row[2] = history->D[i];
  }
  return true;
}

bool nb_contact_test_snapshot(struct nb_snapshot *snapshot, const struct nb_contact_test *contact_test, int stage) {
  const struct history history = history_of(contact_test);
  *snapshot = (struct nb_snapshot){.stage = stage};
  return tabulate_traction(&snapshot->traction, contact_test, &history, stage) &&
         tabulate_pieces(&snapshot->pieces, contact_test, &history, stage);
}
