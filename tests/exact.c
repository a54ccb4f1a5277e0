/* The exact law of two elastic spheres, compared with closed forms and with an independent implementation
 * (by_hand.h).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/laws/law.h"
#include "by_hand.h"
#include "chance.h"
#include "suites.h"

enum { MOST_PIECES = 256, HISTORY = 12 + 5 * MOST_PIECES };

struct exact {
  const struct nb_law *law;
  struct nb_pair pair;
  struct nb_normal n;
  struct nb_shear s;
  double memory[HISTORY];
  double dissipated, work; /* J, the work of T alone */
};

static const struct nb_pair steel = {
    .friction = 0.3, .young = 112e9, .shear = 23.4e9, .radius = 5e-3, .pieces = 16}; /* nu = 0.28, R = 10 mm */

static struct exact exact_of(struct nb_pair pair) {
  return (struct exact){.law = nb_law_find("shear", "mindlin_deresiewicz"), .pair = pair};
}

/* mu kappa, by which the tangential displacement is divided to give u. */
static double unit(struct nb_pair p) { return p.friction * p.young / (4 * p.shear); }

/* Makes one step to the overlap x, with the tangential increment `slip`. */
static void exact_go(struct exact *it, double x, double slip) {
  const double before = it->s.force;
  it->n = nb_law_find("normal", "hertz")->normal(it->pair, x, 0, NULL);
  it->n.overlap = x;
  it->s = it->law->shear(it->pair, it->n, slip, it->memory);
  it->dissipated += it->s.dissipated;
  it->work += (before + it->s.force) / 2 * slip;
}

/* Makes n equal steps to the overlap x, with the tangential displacement `slip` in all. */
static void exact_lead(struct exact *it, double x, double slip, int n) {
  const double from = it->n.overlap;
  for (int k = 1; k <= n; k++)
    exact_go(it, k == n ? x : from + (x - from) * k / n, slip / n);
}

static double fraction(const struct exact *it) { return it->s.force / (it->pair.friction * it->n.force); } /* T/mu N */
static double stored(const struct exact *it) { return it->law->stored(it->pair, it->n, it->memory); }

/* ---- closed forms ---- */

/* delta = A [1 - (1 - T/mu N)^(2/3)] with A = 3 mu N/16 G* a [R89 3.25]. Unloading from T*, and reloading from T**,
 * follow the same curve at twice its size [R89 3.40, 3.50]. */
static void mindlins_curves(void) {
  static const int steps[] = {1, 7, 1000};
  const double x = 1e-6;
  for (int k = 0; k < 3; k++) {
    struct exact it = exact_of(steel);
    exact_go(&it, x, 0);
    const double a = 3 * steel.friction * it.n.force / (16 * steel.shear * it.n.radius);
    exact_lead(&it, x, 0.6 * a, steps[k]);
    const double first = 1 - pow(1 - 0.6, 1.5);
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), first, 1e-12);
    exact_lead(&it, x, -0.7 * a, steps[k]);
    const double second = first - 2 * (1 - pow(1 - 0.7 / 2, 1.5));
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), second, 1e-12);
    exact_lead(&it, x, 0.3 * a, steps[k]);
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), second + 2 * (1 - pow(1 - 0.3 / 2, 1.5)), 1e-12);
    exact_lead(&it, x, 0.4 * a, steps[k]); /* back at T*, and further along the first curve */
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), first, 1e-12);
    exact_lead(&it, x, 0.2 * a, steps[k]);
    CU_ASSERT_DOUBLE_EQUAL(fraction(&it), 1 - pow(1 - 0.8, 1.5), 1e-12);
    CU_ASSERT_EQUAL(it.s.sliding, 0);
    exact_lead(&it, x, 0.3 * a, steps[k]);
    CU_ASSERT(fraction(&it) == 1 && it.s.sliding == 1);
  }
}

/* A cycle between T* and -T* loses mu N A (0.8 - 4 w^(2/3) + 4 w - 0.8 w^(5/3)) with w = 1 - |T*| / (mu N), from the
 * integral of the curves above. At constant N the law's loss is exact for any step. Sliding by d loses mu N d. */
static void losses_in_cycles(void) {
  for (int steps = 1; steps <= 100; steps += 33) {
    struct exact it = exact_of(steel);
    exact_go(&it, 1e-6, 0);
    const double limit = steel.friction * it.n.force, a = 3 * limit / (16 * steel.shear * it.n.radius);
    exact_lead(&it, 1e-6, 0.6 * a, steps);
    const double w = pow(0.4, 1.5), before = it.dissipated, held = stored(&it);
    exact_lead(&it, 1e-6, -2 * a * (1 - pow(w, 2. / 3)), steps);
    exact_lead(&it, 1e-6, 2 * a * (1 - pow(w, 2. / 3)), steps);
    const double loop = limit * a * (0.8 - 4 * pow(w, 2. / 3) + 4 * w - 0.8 * pow(w, 5. / 3));
    CU_ASSERT_DOUBLE_EQUAL(it.dissipated - before, loop, 1e-11 * loop);
    CU_ASSERT_DOUBLE_EQUAL(stored(&it), held, 1e-12 * held);
    exact_lead(&it, 1e-6, 2 * a, 1);
    const double slid = it.dissipated;
    exact_lead(&it, 1e-6, 3 * a, steps);
    CU_ASSERT_DOUBLE_EQUAL(it.dissipated - slid, 3 * a * limit, 1e-12 * 3 * a * limit);
  }
}

/* While N grows, every ring sticks if |d(delta)| < mu kappa d(alpha), and T/N is constant. When N falls back along the same
 * line, T/N is constant, too, and nothing is dissipated. */
static void proportional_loading(void) {
  struct exact it = exact_of(steel);
  exact_lead(&it, 2e-6, 0.7 * 2e-6 * unit(steel), 50);
  CU_ASSERT_DOUBLE_EQUAL(fraction(&it), 0.7, 1e-12);
  exact_lead(&it, 1e-6, -0.7 * 1e-6 * unit(steel), 50);
  CU_ASSERT_DOUBLE_EQUAL(fraction(&it), 0.7, 1e-12);
  CU_ASSERT(fabs(it.dissipated) <= 1e-12 * stored(&it));
  CU_ASSERT_DOUBLE_EQUAL(stored(&it), 0.4 * 0.7 * fraction(&it) * steel.friction * it.n.force * 1e-6 * unit(steel),
                         1e-12 * stored(&it));
}

/* One step to a smaller overlap without slip. T does no work, so the dissipation equals the decrease of the stored
 * energy, for any friction and step, whether the slip front passes all rings or the contact slides in the end. */
static void unloading_dissipates_the_stored_energy(void) {
  for (int k = 0; k < 24; k++) {
    struct exact it = exact_of(steel);
    it.pair.friction = k % 3 == 0 ? 0.3 : k % 3 == 1 ? 1e4 : 1e-3;
    const double x = 2e-6, u = (k % 2 ? -1 : 1) * (k % 4 < 2 ? 1e-3 : 0.6) * x;
    exact_go(&it, x, u * unit(it.pair));
    const double force = it.pair.friction * it.n.force;
    for (double held = stored(&it), to = k < 12 ? 0.7 * x : x; to > 1e-6 * x; to *= k < 12 ? 0.02 : 0.9) {
      exact_go(&it, to, 0);
      CU_ASSERT_DOUBLE_EQUAL(it.s.dissipated, held - stored(&it), 4e-16 * force * x * unit(it.pair));
      held = stored(&it);
    }
    CU_ASSERT_EQUAL(it.s.sliding, 1);
  }
}

/* On a straight segment with slip in one direction, one step dissipates as much as thousands of steps. */
static void dissipation_is_independent_of_the_step(void) {
  static const double to[][2] = {{1.5, 1.2}, {0.8, 0.5}, {0.6, -0.9}, {0.5, 0.3},
                                 {2, 3},     {0.3, -1},  {1.2, -4}}; /* final overlap and u, um */
  for (size_t k = 0; k < sizeof to / sizeof *to; k++)
    for (int first = 0; first < 3; first++) { /* before: sticks; has slipped in one direction; has slid in the other */
      struct exact one = exact_of(steel), many = exact_of(steel);
      struct exact *both[] = {&one, &many};
      for (int b = 0; b < 2; b++) {
        exact_go(both[b], 0.4e-6, 0.1e-6 * unit(steel));
        exact_go(both[b], 1e-6, (first == 2 ? -2 : first ? 0.8 : 0.1) * 1e-6 * unit(steel));
        exact_go(both[b], 1e-6, (first == 2 ? 0.3 : 0) * 1e-6 * unit(steel));
        both[b]->dissipated = 0;
        exact_lead(both[b], to[k][0] * 1e-6, to[k][1] * 1e-6 * unit(steel), b ? 4000 : 1);
      }
      CU_ASSERT(one.dissipated > 0);
      CU_ASSERT_DOUBLE_EQUAL(one.dissipated, many.dissipated, 1e-9 * one.dissipated);
    }
}

/* ---- by_hand.h ---- */

/* The smallest relative change of T if two neighbouring rings are joined. */
static double smallest_change(const struct by_hand *it) {
  double least = 1;
  for (int k = 0; k + 1 < it->count; k++) {
    const double n0 = by_hand_ring(it, k - 1).n, n1 = it->ring[k].n, n2 = it->ring[k + 1].n;
    const double change = fabs(it->ring[k].d - it->ring[k + 1].d) * (n1 - n0) * (n2 - n1) / (n2 - n0) / n2;
    least = change < least && change > 1e-13 ? change : least;
  }
  return least;
}

/* Random segments: N and T up and down, reversals, sliding. With any number of steps per segment the law agrees with
 * one step of by_hand.h. */
static void random_paths(void) {
  static struct by_hand hand;
  static const int steps[] = {1, 7, 1000};
  struct chance chance = chance_begin(5);
  int segments = 0, slides = 0, most = 0, kinds[2][2] = {{0}};
  for (int path = 0; path < 60; path++) {
    struct exact it[3];
    for (int k = 0; k < 3; k++)
      it[k] = exact_of(steel);
    hand.count = 0;
    double x = 0, before = 0;
    for (int segment = 0; segment < 14; segment++) {
      const double next = segment % 7 == 6 ? x : 1e-6 * chance_between(&chance, 0.3, 2);
      const double u = chance_between(&chance, -1, 1) * 1e-6 * (segment % 3 ? 0.3 : 1.2);
      const double wanted = by_hand_go(&hand, next, u);
      if (smallest_change(&hand) < 1e-6)
        break; /* the law would join these rings, with an error of this size */
      for (int k = 0; k < 3; k++) {
        exact_lead(&it[k], next, u * unit(steel), steps[k]);
        CU_ASSERT_DOUBLE_EQUAL(fraction(&it[k]), wanted, 1e-12);
      }
      CU_ASSERT_EQUAL(it[0].s.sliding, hand.slid > 0);
      kinds[next > x][fabs(wanted) > fabs(before)]++;
      segments++, slides += hand.slid > 0, x = next, before = wanted, most = hand.count > most ? hand.count : most;
    }
  }
  CU_ASSERT(segments > 400 && slides > 50 && most > 6);
  CU_ASSERT(kinds[0][0] > 50 && kinds[0][1] > 50 && kinds[1][0] > 50 && kinds[1][1] > 50);
}

/* ---- changes of friction, pieces ---- */

/* Friction that falls under load: the path of the pieces is followed again, and the dissipation is the decrease of
 * the stored energy. Friction that rises changes nothing. */
static void friction_changes(void) {
  const double x = 1e-6;
  struct exact it = exact_of(steel);
  exact_go(&it, x, 0);
  exact_go(&it, x, 0.3 * x * unit(steel));
  const double held = it.s.force, energy = stored(&it);
  it.pair.friction = 0.5;
  exact_go(&it, x, 0);
  CU_ASSERT_DOUBLE_EQUAL(it.s.force, held, 1e-12 * held);
  CU_ASSERT_DOUBLE_EQUAL(stored(&it), energy, 1e-12 * energy);
  it.pair.friction = 0.15; /* the same slip, for half the limit */
  exact_go(&it, x, 0);
  CU_ASSERT_DOUBLE_EQUAL(fraction(&it), 1 - pow(1 - 0.6, 1.5), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(it.s.dissipated, energy - stored(&it), 1e-12 * energy);
  it.pair.friction = 0.05;
  exact_go(&it, x, 0);
  CU_ASSERT(fraction(&it) == 1);
  CU_ASSERT(it.s.dissipated > 0);
  it.pair.friction = 0;
  exact_go(&it, x, 1e-8);
  CU_ASSERT(it.s.force == 0 && it.s.sliding == 1);
  it.pair = steel;
  exact_go(&it, x, 0);
  CU_ASSERT_EQUAL(it.s.force, 0);
}

/* The inverse of the friction 1e-320 is infinite. It counts as no friction: the contact slides without a force, and
 * the law reads nothing outside its history. With 1e-300 the contact slides at mu N, also when friction falls to it
 * from 1e100 under load. */
static void very_small_friction(void) {
  static const double friction[] = {1e-320, 1e-300};
  for (int k = 0; k < 2; k++)
    for (int from = 0; from < 2; from++) {
      struct exact it = exact_of(steel);
      if (from) {
        it.pair.friction = 1e100;
        exact_go(&it, 1e-6, 0);
        exact_go(&it, 1e-6, 1e-9);
        exact_go(&it, 1e-6, 0);
      }
      it.pair.friction = friction[k];
      exact_go(&it, 1e-6, 0);
      exact_go(&it, 1e-6, 0);
      exact_go(&it, 2e-6, 1e-9);
      CU_ASSERT_EQUAL(it.s.sliding, 1);
      CU_ASSERT(isfinite(it.dissipated));
      if (k == 0)
        CU_ASSERT_EQUAL(it.s.force, 0);
      if (k == 1)
        CU_ASSERT_DOUBLE_EQUAL(fraction(&it), 1, 1e-12);
    }
}

/* The friction is so high that the contact never comes near sliding. The error of T is small relative to T, not only
 * relative to mu N. The tangential displacement is less than the overlap, so u is less than a millionth of x. */
static void very_high_friction(void) {
  static struct by_hand hand;
  struct chance chance = chance_begin(8);
  struct exact it = exact_of(steel);
  it.pair.friction = 1e6, it.pair.pieces = 200;
  hand.count = 0;
  double x = 1e-6, worst = 0, largest = 0;
  for (int k = 0; k < 100; k++) {
    x = 1e-6 * chance_between(&chance, 0.5, 1.5);
    const double slip = chance_between(&chance, -1e-7, 1e-7), wanted = by_hand_go(&hand, x, slip / unit(it.pair));
    exact_go(&it, x, slip);
    worst = fmax(worst, fabs(fraction(&it) - wanted)), largest = fmax(largest, fabs(wanted));
  }
  CU_ASSERT(largest < 1e-5 && worst < 1e-6 * largest);
}

/* The contact returns to exactly the point of an earlier corner. No piece of width 0 remains, which the reader of a
 * saved state would refuse. */
static void back_to_a_corner(void) {
  struct exact it = exact_of(steel);
  const double u = 0.2e-6 * unit(steel);
  exact_go(&it, 1e-6, u);
  exact_go(&it, 2e-6, 2 * u);
  exact_go(&it, 3e-6, -u);
  exact_go(&it, 2e-6, u);
  CU_ASSERT(it.law->valid(it.memory, it.law->used(it.memory), (int)it.pair.pieces));
}

/* pieces_of returns the pieces from inside to outside, up to alpha; their forces sum to T. */
static void pieces_of_a_contact(void) {
  struct exact it = exact_of(steel);
  double x[16], d[16], force = 0, begin = 0;
  CU_ASSERT_EQUAL(it.law->pieces_of(it.pair, it.n, it.memory, x, d), 0);
  exact_go(&it, 1e-6, 0.2e-6 * unit(steel));
  exact_go(&it, 2e-6, -0.5e-6 * unit(steel));
  exact_go(&it, 2e-6, 0.1e-6 * unit(steel));
  const int count = it.law->pieces_of(it.pair, it.n, it.memory, x, d);
  CU_ASSERT_EQUAL_FATAL(count, 3);
  CU_ASSERT_DOUBLE_EQUAL(d[0], 0.2, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(d[1], -0.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(d[2], 1, 1e-12);
  for (int k = 0; k < count; k++)
    force += d[k] * (pow(x[k], 1.5) - pow(begin, 1.5)), begin = x[k];
  CU_ASSERT_EQUAL(begin, 2e-6);
  CU_ASSERT_DOUBLE_EQUAL(fraction(&it), force / pow(begin, 1.5), 1e-12);
}

void suite_exact(void) {
  CU_pSuite suite = CU_add_suite("exact", NULL, NULL);
  CU_add_test(suite, "Mindlin's curves", mindlins_curves);
  CU_add_test(suite, "loss of cycles and of sliding", losses_in_cycles);
  CU_add_test(suite, "proportional loading is reversible", proportional_loading);
  CU_add_test(suite, "unloading dissipates the stored energy", unloading_dissipates_the_stored_energy);
  CU_add_test(suite, "dissipation does not depend on the step", dissipation_is_independent_of_the_step);
  CU_add_test(suite, "random paths, against by_hand.h, at any step", random_paths);
  CU_add_test(suite, "friction changes under load", friction_changes);
  CU_add_test(suite, "very small friction", very_small_friction);
  CU_add_test(suite, "very high friction", very_high_friction);
  CU_add_test(suite, "back to a corner", back_to_a_corner);
  CU_add_test(suite, "pieces of a contact", pieces_of_a_contact);
}
