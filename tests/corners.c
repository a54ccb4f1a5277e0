/* Tests of the history of the exact law, which is a path of corners in overlap and tangential displacement: when a step
 * adds a piece, and which corner is dropped when all pieces are in use. Further tests show what a closed loop erases,
 * and what a change of friction does. Results are compared with sums over the rings (by_hand.h), and with geometry.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "../src/laws/corners.h"
#include "by_hand.h"
#include "chance.h"
#include "suites.h"

enum { MOST = 40, ROW = 12 + 5 * MOST };

/* mu kappa = 1/4 with R* = 1 m and E* = 4 G*: u = slip/(mu kappa) is four times the slip, without rounding. x is the
 * overlap. */
static const struct nb_pair plain = {.friction = 0.25, .young = 4e9, .shear = 1e9, .radius = 1, .pieces = 32};

struct one {
  struct nb_pair pair;
  struct nb_normal n;
  struct nb_shear s;
  double before[ROW], m[ROW];
};

/* A contact. The array before its row has corners that look valid, like the row of another contact. */
static struct one one_of(struct nb_pair pair) {
  struct one it = {.pair = pair};
  for (int k = 0; 5 * k + 4 < ROW; k++)
    it.before[ROW - 3 - 5 * k] = 1e-3, it.before[ROW - 1 - 5 * k] = 0.5;
  return it;
}

static const struct nb_law *exact(void) { return nb_law_find("shear", "mindlin_deresiewicz"); }

/* Makes one step to the overlap x; u is the tangential increment over mu kappa. */
static void one_go(struct one *it, double x, double u) {
  it->n = nb_law_find("normal", "hertz")->normal(it->pair, x, 0, NULL);
  it->n.overlap = x;
  it->s = exact()->shear(it->pair, it->n, u / 4, it->m);
  CU_ASSERT_EQUAL(it->m[0], floor(it->m[0]));
}
static int pieces(const struct one *it) { return (int)it->m[0]; }
static double fraction(const struct one *it) { return it->s.force / (it->pair.friction * it->n.force); } /* T/mu N */

/* Which rows of a saved state are valid: at most max_pieces pieces, a number of doubles that fits, corners in ascending
 * order that begin at 0, and no ring beyond its friction limit. Each change of one double makes a valid row invalid. */
static void valid_rows(void) {
  static const struct {
    int at; /* index of the double that changes */
    double value;
    bool valid;
  } rows[] = {{0, 2, true},                         /* no change */
              {0, 0, false},         {0, 1, false}, /* the number of doubles is that of two pieces */
              {0, 2.5, false},       {0, 3, false},        {0, NAN, false},
              {1, 0, false},         {1, -1, false},       {1, 1e-300, true},
              {2, 0.1, false},       {2, -0.1, false},     {4, 1, true}, /* D of the first piece */
              {4, -1, true},         {4, 1 + 1e-10, true}, {4, 1 + 1e-8, false},
              {4, -1 - 1e-8, false}, {6, -1e-9, false}, /* e of the first piece */
              {7, 0, false},                            /* x of the second corner */
              {7, 2, false},         {7, 3, false},        {9, -1.1, false},
              {11, -1, false},       {12, 1, false},       {12, 0.5, false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    double m[HEAD + 5 * 4] = {2, 0.25, 0, 0, 0.5, 0, 0, 1, 0.5, -0.5, 0, 0, 2, 0, 0, 0, 0};
    m[rows[k].at] = rows[k].value;
    CU_ASSERT_EQUAL(corners_valid(m, HEAD + 5 * 3, 4), rows[k].valid);
    CU_ASSERT_EQUAL(corners_valid(m, HEAD + 5 * 3, 2), rows[k].valid);
    CU_ASSERT(!corners_valid(m, HEAD + 5 * 3, 1));
    m[0] = 0; /* no piece: the doubles would be those of one corner */
    CU_ASSERT(!corners_valid(m, HEAD + 5, 4));
    m[0] = 2;
    CU_ASSERT(!corners_valid(m, HEAD + 5 * 3 - 1, 4) && !corners_valid(m, HEAD, 4) && !corners_valid(m, 0, 4));
  }
}

/* ---- the pieces themselves ---- */

/* Makes a random path of `count` pieces with |D| up to `most`. The force at each corner is a sum over the pieces. */
static void path_of(struct corner at[], int count, struct chance *chance, double most) {
  double t = 0;
  at[0] = (struct corner){0};
  for (int k = 0; k < count; k++) {
    at[k].d = chance_between(chance, -most, most), at[k].e = chance_between(chance, 0, 0.05);
    const double x = at[k].x + chance_scale(chance, 0.01, 1);
    at[k].b = t - at[k].d * n_of(at[k].x), t += at[k].d * (n_of(x) - n_of(at[k].x));
    at[k + 1] = (struct corner){x, at[k].u + at[k].d * (x - at[k].x), at[k].d, at[k].b, 0};
  }
}

/* t at the outer end of a path; T/(mu N) = t/n there. */
static double force(const struct corner at[], int count) {
  double t = 0;
  for (int k = 0; k < count; k++)
    t += at[k].d * (n_of(at[k + 1].x) - n_of(at[k].x));
  return t;
}

/* Checks that u, d and b are consistent. Assertions in long loops are fatal, because CUnit stores every failure and
 * becomes slow. */
static void is_a_path(const struct corner at[], int count) {
  for (int k = 0; k < count; k++) {
    CU_ASSERT_DOUBLE_EQUAL_FATAL(at[k + 1].u, at[k].u + at[k].d * (at[k + 1].x - at[k].x), 1e-12);
    CU_ASSERT_DOUBLE_EQUAL_FATAL(at[k].b + at[k].d * n_of(at[k + 1].x), force(at, k + 1), 1e-11);
    CU_ASSERT_FATAL(fabs(at[k].d) <= 1);
  }
}

/* Twice the area by which u(x) changes when a corner is dropped: the triangle of the corner and its neighbours, plus
 * the errors that its two pieces already have. */
static double area(const struct corner *at) {
  const double all = at[1].x - at[-1].x, line = at[-1].u + (at[0].x - at[-1].x) / all * (at[1].u - at[-1].u);
  return at[-1].e + at[0].e + fabs(at[0].u - line) * all;
}

/* In a path of three to nine pieces, the dropped corner is the one with the least area over x^(1/2): its triangle, with
 * the earlier errors, changes T least. The displacement at the end is kept, and so is T if a neighbouring corner can
 * move. Only three pieces change. */
static void a_corner_is_dropped(void) {
  struct chance chance = chance_begin(8);
  int kept = 0, first = 0, last = 0, high = 0;
  for (int path = 0; path < 40000; path++) {
    struct corner old[12], at[12];
    const int count = 3 + path % 7;
    path_of(old, count, &chance, path % 3 ? 0.5 : 1);
    memcpy(at, old, sizeof at);
    int goes = 1;
    double least = INFINITY;
    for (int k = 1; k < count; k++) {
      const double wrong = area(&old[k]) / sqrt(old[k].x);
      goes = wrong < least ? k : goes, least = wrong < least ? wrong : least;
    }
    drop_corner(at, count);
    is_a_path(at, count - 1);
    CU_ASSERT_EQUAL_FATAL(at[count - 1].u, old[count].u);
    CU_ASSERT_EQUAL_FATAL(at[count - 1].x, old[count].x);
    CU_ASSERT_DOUBLE_EQUAL_FATAL(at[goes - 1].e, 0.75 * area(&old[goes]), 1e-12);
    for (int k = 1; k < count - 1; k++)
      CU_ASSERT_EQUAL_FATAL(at[k].x, old[k < goes ? k : k + 1].x);
    const bool same = fabs(force(at, count - 1) - force(old, count)) < 1e-11;
    struct corner one[12]; /* the next corner inside moves, or if it cannot, the one outside */
    memcpy(one, old, sizeof one);
    const double more = merge(one, goes, count);
    const int moves = goes > 1 && shift_corner(one, goes - 1, -more)       ? goes - 1
                      : goes < count - 1 && shift_corner(one, goes, -more) ? goes
                                                                           : 0;
    CU_ASSERT_FATAL(same || !moves);
    for (int k = 1; k < count - 1; k++)
      CU_ASSERT_FATAL(k == moves || fabs(at[k].u - old[k < goes ? k : k + 1].u) <= 1e-14);
    kept += same, first += goes == 1, last += goes == count - 1, high += !same;
    if (path % 3 && least < 1e-3)
      CU_ASSERT_FATAL(same);
  }
  CU_ASSERT_FATAL(kept > 1000 && first > 100 && last > 100 && high > 10);
}

/* shift_corner moves a corner so that the force changes by `more`. It refuses if a ring would then carry more than
 * its friction limit. */
static void corners_move(void) {
  struct chance chance = chance_begin(9);
  int done = 0, refused = 0;
  for (int path = 0; path < 20000; path++) {
    struct corner old[4], at[4];
    path_of(old, 3, &chance, 1);
    memcpy(at, old, sizeof at);
    /* a shift of u by y changes the two D by y/x1 and -y/x2 */
    const double x1 = old[1].x - old[0].x, x2 = old[2].x - old[1].x, n1 = n_of(old[1].x), n2 = n_of(old[2].x);
    const double full = copysign(chance_between(&chance, 0.9995, 1.0005), chance_between(&chance, -1, 1));
    const double y = path % 3 == 0   ? (full - old[0].d) * x1
                     : path % 3 == 1 ? (old[1].d - full) * x2
                                     : chance_between(&chance, -0.05, 0.05);
    const double more = y * ((n1 - n_of(old[0].x)) / x1 - (n2 - n1) / x2);
    const double d1 = fabs(old[0].d + y / x1), d2 = fabs(old[1].d - y / x2), larger = d1 > d2 ? d1 : d2;
    if (fabs(larger - 1) < 1e-6 || fabs(more) < 1e-3 * fabs(y))
      continue;
    CU_ASSERT_EQUAL_FATAL(shift_corner(at, 1, more), larger < 1);
    if (larger < 1) {
      CU_ASSERT_DOUBLE_EQUAL_FATAL(at[1].u, old[1].u + y, 1e-11);
      CU_ASSERT_DOUBLE_EQUAL_FATAL(force(at, 2), force(old, 2) + more, 1e-12);
      is_a_path(at, 2);
    } else {
      CU_ASSERT_FATAL(memcmp(at, old, sizeof at) == 0);
    }
    done += larger < 1, refused += larger >= 1 && larger < 1.05;
  }
  CU_ASSERT_FATAL(done > 300 && refused > 10);
}

/* ---- the law with its pieces ---- */

/* A step adds a piece if a merge with the piece before would change u by (1e-7/1.5) x or more, where x is the
 * overlap at the outer end of the new piece. The change is |D_1 - D_2|
 * x_1 x_2/(x_1 + x_2) for pieces of the lengths x_1 and x_2. The error that the piece before already has is subtracted
 * from the limit. If |u| is below x/100 at both ends of the new piece, 100 times the larger |u| replaces x in the
 * limit. The test covers both signs, rings and slip, a first piece and a later one, and small u. */
static void small_pieces_join(void) {
  static const struct {
    double first, before, d; /* x and -D of the piece before, D of the piece that is joined */
    bool slips;
  } ways[] = {{0, 0, 0.5, false},    {1e-3, 0.2, 0.5, false}, {0, 0, -0.25, false},
              {1e-3, 0.2, 0, false}, {1e-3, 0.4, 0, true},    {1e-3, 0.2, 0, true}};
  for (int sign = -1; sign < 2; sign += 2)
    for (int way = 0; way < 6; way++)
      for (int more = 0; more < 4; more++) {
        const double small = more < 2 ? 1 : 1e-3;
        const double first = ways[way].first, d = small * ways[way].d, x1 = 2e-3 - first;
        struct one it = one_of(plain);
        if (first > 0)
          one_go(&it, first, -small * ways[way].before * sign * first);
        one_go(&it, 2e-3, d * sign * x1);
        const int had = pieces(&it);
        const double u1 = d * x1 - small * ways[way].before * first, u2 = u1 + d * x1;
        const double x = ways[way].slips ? 2e-3 : 2e-3 + x1, u = fmax(fabs(u1), fabs(u2));
        const double limit = (more % 2 ? 1.0003 : 0.9997) * 1e-7 / 1.5 * fmin(x, 100 * u);
        if (!ways[way].slips) { /* a new ring with another D: equal spans, so that |D - D'| x_1/2 = limit */
          one_go(&it, 2e-3 + x1, sign * (d + (way < 2 ? -1 : 1) * 2 * limit / x1) * x1);
        } else { /* slip from the edge to c: (1 - D) x_1 x_2/(x_1 + x_2) with x_1 = c, x_2 = x - c */
          one_go(&it, 2e-3, sign * (x1 - sqrt(x1 * x1 - 4 * limit * x1)) / 2);
        }
        CU_ASSERT_EQUAL(pieces(&it), had + more % 2);
      }
}

/* The error of a joined piece counts until that piece is erased. */
static void joined_pieces_count(void) {
  const double little = 1e-7 / 1.5;
  for (int way = 0; way < 3; way++) {
    const double by = way == 0 ? 0.7999 : way == 1 ? 0.8001 : 0.9999;
    struct one it = one_of(plain);
    one_go(&it, 1e-3, 0.5e-3);
    one_go(&it, 2e-3,
           0.5e-3 + 0.8 * little * 4e-3); /* an error of 0.8 of the limit; in the next step it is 0.2 of the limit */
    CU_ASSERT_EQUAL(pieces(&it), 1);
    if (way == 2) { /* to the friction limit: D = 1 everywhere */
      one_go(&it, 2e-3, 4e-3);
      CU_ASSERT_EQUAL(pieces(&it), 1);
    }
    const double d = way == 2 ? 1 : 0.5 + 0.4 * little * 4;
    one_go(&it, 4e-3, (d - by * little * 4) * 2e-3);
    CU_ASSERT_EQUAL(pieces(&it), way == 1 ? 2 : 1);
  }
}

/* A closed loop is erased. When the contact returns to the point of reversal, the force has its earlier value, whatever
 * the rounding, and reloading has dissipated as much as unloading. */
static void closed_loops_are_erased(void) {
  struct chance chance = chance_begin(10);
  for (int path = 0; path < 2000; path++) {
    struct one it = one_of(plain);
    const double x = chance_between(&chance, 0.5e-3, 2e-3), u = x * chance_between(&chance, 0.1, 0.9);
    const double back = u * chance_scale(&chance, 1e-3, 1.8);
    one_go(&it, x, 0);
    one_go(&it, x, u);
    const double before = fraction(&it);
    one_go(&it, x, -back);
    const double there = it.s.dissipated;
    one_go(&it, x, back);
    CU_ASSERT_DOUBLE_EQUAL(it.s.dissipated, there, 1e-8 * there + 1e-15 * 0.25 * it.n.force * x / 4);
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), before, 1e-12);
  }
  struct one it = one_of(plain); /* without any rounding */
  one_go(&it, 0x1p-10, 0);
  one_go(&it, 0x1p-10, 0x1p-11);
  CU_ASSERT_EQUAL(pieces(&it), 2);
  one_go(&it, 0x1p-10, -0x1p-11);
  CU_ASSERT_EQUAL(pieces(&it), 3);
  one_go(&it, 0x1p-10, 0x1p-11);
  CU_ASSERT_EQUAL(pieces(&it), 2);
}

/* When the friction changes, the path of the pieces is followed again from its start, with u divided by the ratio of
 * the new friction to the old one. */
static void friction_changes(void) {
  static struct by_hand hand;
  struct chance chance = chance_begin(12);
  int most = 0;
  for (int path = 0; path < 300; path++) {
    struct one it = one_of(plain);
    double x[MOST], d[MOST], begin = 0;
    for (int segment = 0; segment < 8; segment++)
      one_go(&it, chance_between(&chance, 0.5e-3, 2e-3), chance_between(&chance, -0.5e-3, 0.5e-3));
    const int count = exact()->pieces_of(it.pair, it.n, it.m, x, d);
    const double piece_energy = exact()->stored(it.pair, it.n, it.m), new = chance_between(&chance, 0.4, 1.5);
    it.pair.friction *= new;
    hand.count = 0;
    double wanted = 0;
    for (int k = 0; k < count; k++)
      wanted = by_hand_go(&hand, x[k], d[k] * (x[k] - begin) / new), begin = x[k];
    one_go(&it, it.n.overlap, 0);
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), wanted, 1e-6);
    CU_ASSERT_DOUBLE_EQUAL(it.s.dissipated, piece_energy - exact()->stored(it.pair, it.n, it.m), 1e-6 * piece_energy);
    CU_ASSERT_DOUBLE_EQUAL(it.m[1], it.pair.friction, 1e-15);
    most = count > most ? count : most;
  }
  CU_ASSERT(most > 4);
}

/* Without a contact circle there is no shear force: a normal law may return the radius 0 before the surfaces part.
 * In this case `sliding` is 0. For a contact without friction it is 1. */
static void no_circle_or_no_friction(void) {
  struct one it = one_of(plain);
  it.m[1] = NAN;
  one_go(&it, 1e-3, 0.9995e-3);
  CU_ASSERT_EQUAL(it.s.sliding, 0);
  CU_ASSERT_EQUAL(it.m[1], 0.25);
  for (int k = 0; k < 3; k++) {
    const struct nb_normal removed = {.overlap = 1e-3, .radius = k == 2 ? 1e-120 : 0}; /* its cube is 0 */
    it.s = exact()->shear(it.pair, removed, k == 1 ? 0 : 1e-4, it.m);
    CU_ASSERT(it.m[0] == 0 && it.s.force == 0 && it.s.sliding == 0 && it.s.dissipated == 0);
  }
  it.pair.friction = 0;
  one_go(&it, 1e-3, 1e-4);
  CU_ASSERT(it.m[0] == 0 && it.s.force == 0 && it.s.sliding == 1 && it.s.dissipated == 0);
}

/* `used` returns the number of doubles written, and the contact continues from those alone. */
static void what_is_used(void) {
  for (int segments = 1; segments < 12; segments++) {
    struct one it = one_of(plain), other = one_of(plain);
    for (int k = 1; k < ROW; k++)
      it.m[k] = NAN, other.m[k] = 1e-3;
    one_go(&it, 1e-3, 0);
    double u = 0.9e-3;
    for (int segment = 1; segment < segments; segment++, u *= -0.9) /* loops within loops: each reversal adds a piece */
      one_go(&it, 1e-3, u);
    int written = ROW;
    while (isnan(it.m[written - 1]))
      written--;
    CU_ASSERT_EQUAL(pieces(&it), segments);
    CU_ASSERT_EQUAL(exact()->used(it.m), written);
    memcpy(other.m, it.m, sizeof *it.m * (size_t)exact()->used(it.m));
    one_go(&it, 0.99e-3, -0.3 * u), one_go(&other, 0.99e-3, -0.3 * u);
    CU_ASSERT(it.s.force == other.s.force && it.s.dissipated == other.s.dissipated && it.m[0] == other.m[0]);
  }
}

void suite_corners(void) {
  CU_pSuite suite = CU_add_suite("corners", NULL, NULL);
  CU_ADD_TEST(suite, valid_rows);
  CU_add_test(suite, "a corner is dropped when all pieces are in use", a_corner_is_dropped);
  CU_add_test(suite, "corners move", corners_move);
  CU_add_test(suite, "small pieces join", small_pieces_join);
  CU_add_test(suite, "the error of joined pieces counts", joined_pieces_count);
  CU_add_test(suite, "closed loops are erased", closed_loops_are_erased);
  CU_add_test(suite, "a change of friction follows the path again", friction_changes);
  CU_add_test(suite, "no contact circle, no friction", no_circle_or_no_friction);
  CU_add_test(suite, "number of doubles in use", what_is_used);
}
