/* Rules that every registered law must satisfy. Each test runs over all laws with many random material pairs and paths.
 * A shear law is combined with every normal law that it allows.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <float.h>
#include <string.h>

#include "every_law.h"
#include "suites.h"

static void nothing_at_zero_overlap(struct contact it, struct chance *chance) {
  for (int k = 0; k < 3; k++) { /* at first touch, and after some loading */
    contact_go(&it, 0, chance_between(chance, -1e-4, 1e-4));
    CU_ASSERT(it.n.force == 0 && it.n.stiffness == 0 && it.n.radius == 0);
    CU_ASSERT(it.s.force == 0 && it.s.stiffness == 0 && it.s.sliding == 0);
    if (it.normal->stored)
      CU_ASSERT_EQUAL(it.normal->stored(it.pair, it.n, it.normal_history), 0);
    if (it.shear->stored)
      CU_ASSERT_EQUAL(it.shear->stored(it.pair, it.n, it.shear_history), 0);
    contact_lead(&it, chance_scale(chance, 1e-9, 1e-4), chance_between(chance, -1e-5, 1e-5), 3);
  }
}

/* At the largest overlap so far the force is repulsive. A law with a history may have no force if the overlap was
 * larger before. */
static void pushes_and_never_pulls(struct contact it, struct chance *chance) {
  double deepest = 0;
  for (int k = 0; k < 20; k++) {
    /* An incremental law sums its force from the first overlap on, which must not be too small. */
    const double overlap = chance_scale(chance, it.normal->incremental ? 1e-100 : 1e-300, 1e3);
    /* apart: the overlap was larger before, so the force may be 0; then the stiffness is 0 too */
    const bool apart = it.normal->incremental ? overlap < it.overlap : it.normal->history > 0 && overlap < deepest;
    deepest = overlap > deepest ? overlap : deepest;
    contact_go(&it, overlap, 0);
    CU_ASSERT(it.n.force >= 0 && it.n.stiffness >= 0 && isfinite(it.n.force) && isfinite(it.n.stiffness));
    if (overlap > 1e-12)
      CU_ASSERT(apart ? (it.n.force > 0) == (it.n.stiffness > 0) : it.n.force > 0 && it.n.stiffness > 0);
  }
}

/* A force F has the relative error epsilon, so a difference quotient over 2 h has the error F epsilon/h; h is so small
 * that the curvature can be neglected. The stiffness of an incremental law is the slope of the next step. */
static void stiffness_is_the_slope(struct contact it, struct chance *chance) {
  const double overlap = chance_scale(chance, 1e-9, 1e-3), h = ldexp(overlap, -17);
  contact_lead(&it, overlap - h, 0, 16);
  const double below = it.n.force;
  contact_go(&it, overlap, 0);
  const double force = it.n.force, stiffness = it.n.stiffness, tolerance = 8 * DBL_EPSILON * force / h;
  contact_go(&it, overlap + h, 0);
  const double slope = it.normal->incremental ? (it.n.force - force) / h : (it.n.force - below) / (2 * h);
  CU_ASSERT(fabs(slope - stiffness) <= tolerance);
}

/* A law that declares a constant stiffness returns the stiffness of the material pair, or 0. Dashpots rely on this: they
 * store coefficients that they compute from the stiffness. */
static void constant_stiffness_is_that_of_the_pair(struct contact it, struct chance *chance) {
  for (int k = 0; k < 20; k++) {
    contact_go(&it, k % 5 ? chance_scale(chance, 1e-9, 1e-3) : 0, chance_between(chance, -1e-4, 1e-4));
    if (it.normal->constant)
      CU_ASSERT(it.n.stiffness == (it.overlap > 0 ? it.pair.kn : 0));
    if (it.shear->constant)
      CU_ASSERT(it.s.stiffness == 0 || it.s.stiffness == it.pair.ks);
  }
}

/* After any history, a short step of the overlap in either direction changes the force by at most the step times the
 * largest stiffness that the law returns. The step is so short that the stiffness of elastic spheres changes by the
 * fraction 2^-17. */
static void never_stiffer_than_stated(struct contact it, struct chance *chance) {
  for (int k = 0; k < 20; k++) {
    const double overlap = chance_scale(chance, 1e-9, 1e-3), h = ldexp(overlap, -16);
    contact_lead(&it, overlap * chance_between(chance, 0.2, 3), 0, 16);
    contact_lead(&it, overlap, 0, 16);
    const double most = nb_normal_max_stiffness(it.n) * (1 + ldexp(1, -16)) + 8 * DBL_EPSILON * it.n.force / h;
    if (it.normal->incremental && it.n.force == 0)
      continue; /* the next step begins a new contact, whose stiffness depends on the step */
    CU_ASSERT(nb_normal_max_stiffness(it.n) > 0);
    for (int way = -1; way < 2; way += 2) {
      struct contact next = it;
      contact_go(&next, overlap + way * h, 0);
      CU_ASSERT(fabs(next.n.force - it.n.force) <= most * h);
    }
  }
}

/* The slope over two steps is compared with the mean of the two stiffnesses that the law returns, because an
 * incremental law returns the slope of its step. */
static void shear_stiffness_is_the_slope(struct contact it, struct chance *chance) {
  if (it.shear->dissipative)
    return; /* laws with micro-slip are tested below */
  contact_lead(&it, chance_scale(chance, 1e-9, 1e-3), 0, 16);
  const double sign = chance_between(chance, -1, 1) < 0 ? -1 : 1;
  const double slip = sign * it.overlap * it.pair.friction * chance_between(chance, 0.1, 0.5), h = ldexp(slip, -17);
  if (h == 0)
    return;
  contact_lead(&it, it.overlap, slip - h, 64);
  const double before = it.s.force;
  contact_go(&it, it.overlap, h);
  const double stiffness = it.s.stiffness, tolerance = 64 * DBL_EPSILON * fabs(it.s.force / h);
  const bool sliding = it.s.sliding > 0;
  contact_go(&it, it.overlap, h);
  if (!sliding)
    CU_ASSERT(fabs((it.s.force - before) / (2 * h) - (stiffness + it.s.stiffness) / 2) <= tolerance);
}

/* Just after a reversal, the slope of a law with micro-slip is its stiffness. During micro-slip the slope is smaller.
 * The step after the reversal is 2^-12 of the displacement at which gross sliding begins, so its slope deviates from
 * the stiffness by a fraction of the same order. */
static void shear_stiffness_is_the_slope_at_stick(struct contact it, struct chance *chance) {
  if (!it.shear->dissipative || it.pair.friction == 0)
    return;
  contact_lead(&it, chance_scale(chance, 1e-9, 1e-3), 0, 16);
  const double slide = it.pair.friction * it.n.force / it.s.stiffness * 1.5; /* 3 mu N/16 G* a  [R89 3.25] */
  const double slip = (chance_between(chance, -1, 1) < 0 ? -1 : 1) * slide, fraction = chance_between(chance, 0.1, 0.9);
  contact_lead(&it, it.overlap, fraction * slip, 64);
  const double before = it.s.force, h = ldexp(slip, -12);
  contact_go(&it, it.overlap, h);
  CU_ASSERT((it.s.force - before) / h < 0.98 * it.s.stiffness && it.s.sliding == 0);
  CU_ASSERT((it.s.force - before) / h > 0.2 * it.s.stiffness);
  const double turned = it.s.force;
  contact_go(&it, it.overlap, -h);
  CU_ASSERT(fabs((turned - it.s.force) / h - it.s.stiffness) <= ldexp(it.s.stiffness, -12));
}

static void shear_stays_below_its_limit(struct contact it, struct chance *chance) {
  for (int k = 0; k < 50; k++) {
    contact_go(&it, chance_scale(chance, 1e-9, 1e-3),
               chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-2));
    const double limit = it.pair.friction * it.n.force + it.pair.cohesion;
    CU_ASSERT(fabs(it.s.force) <= limit * (1 + 2 * DBL_EPSILON));
    CU_ASSERT(it.s.sliding == 0 || it.s.sliding == 1);
    if (it.s.sliding > 0)
      CU_ASSERT(fabs(it.s.force) >= limit * (1 - 2 * DBL_EPSILON));
  }
}

static void mirrored_slip_gives_the_mirrored_force(struct contact it, struct chance *chance) {
  struct contact mirrored = it;
  for (int k = 0; k < 50; k++) {
    const double overlap = k % 17 == 16 ? 0 : chance_scale(chance, 1e-9, 1e-3);
    const double slip = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-3);
    contact_go(&it, overlap, slip);
    contact_go(&mirrored, overlap, -slip);
    CU_ASSERT(it.s.force == -mirrored.s.force && it.s.stiffness == mirrored.s.stiffness);
    CU_ASSERT(it.s.sliding == mirrored.s.sliding);
  }
}

/* A law has no stiffness of its own: if all stiffnesses and the cohesion are scaled by a power of two, so are all
 * forces, exactly. */
static void forces_scale_with_the_stiffnesses(struct contact it, struct chance *chance) {
  const double fraction = ldexp(1, -60);
  struct contact soft = it;
  soft.pair.kn *= fraction, soft.pair.ks *= fraction, soft.pair.cohesion *= fraction;
  soft.pair.young *= fraction, soft.pair.shear *= fraction;
  for (int k = 0; k < 20; k++) {
    const double overlap = chance_scale(chance, 1e-9, 1e-3);
    const double slip = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-3);
    contact_go(&it, overlap, slip);
    contact_go(&soft, overlap, slip);
    CU_ASSERT(soft.n.force == fraction * it.n.force && soft.n.stiffness == fraction * it.n.stiffness);
    CU_ASSERT(soft.s.force == fraction * it.s.force && soft.s.stiffness == fraction * it.s.stiffness);
    CU_ASSERT(soft.s.sliding == it.s.sliding);
    if (it.normal->stored && it.shear->stored)
      CU_ASSERT_EQUAL(stored(&soft), fraction * stored(&it));
  }
}

static void history_that_is_not_the_laws_own_is_unchanged(struct contact it, struct chance *chance) {
  for (int k = 0; k < 20; k++)
    contact_go(&it, k % 7 == 6 ? 0 : chance_scale(chance, 1e-9, 1e-3), chance_between(chance, -1e-4, 1e-4));
  for (int m = it.normal->history; m < NB_HISTORY; m++)
    CU_ASSERT_EQUAL(it.normal_history[m], untouched);
  for (int m = nb_law_history(it.shear, it.pair); m < MOST; m++)
    CU_ASSERT_EQUAL(it.shear_history[m], untouched);
}

/* Whether the word is in a list such as "ks, friction". */
static bool is_listed(const char *list, const char *word) {
  const size_t length = strlen(word);
  for (; *list; list += strcspn(list, " "), list += strspn(list, " "))
    if (strncmp(list, word, length) == 0 && (list[length] == ',' || !list[length]))
      return true;
  return false;
}

/* Changes the material parameter with this number and returns its name; NULL after the last one. */
static const char *change(struct nb_pair *pair, int number) {
  int k = 0;
#define ROW(name, ...)                                                                                                 \
  if (number == k++)                                                                                                   \
    return pair->name *= 1.5, #name;
  NB_PAIR_ROWS(ROW)
#undef ROW
  if (number > k + 1)
    return NULL;
  pair->young *= number == k ? 1.5 : 1.1, pair->shear *= number == k ? 1.5 : 0.9;
  return number == k ? "young" : "poisson";
}

/* A law's force along random histories depends on the parameters that the law declares, and on no others. Only the law
 * under test gets the changed pair. */
static void the_force_depends_on_the_stated_parameters(void) {
  for (const struct nb_law *const *law = nb_laws(); *law; law++) {
    const struct nb_law *normal = (*law)->normal ? *law : nb_law_find("normal", (*law)->elastic ? "hertz" : "linear");
    struct nb_pair none;
    const char *name;
    for (int number = 0; (name = change(&none, number)); number++) {
      struct chance chance = chance_begin(2);
      bool depends = false;
      for (int k = 0; k < PAIRS * 20; k++) {
        struct contact it = contact_of(normal, (*law)->shear ? *law : NULL, pair_by(&chance)), other = it;
        change(&other.pair, number);
        for (int step = 0; step < 4; step++) {
          const double slip = chance_between(&chance, -1, 1) * chance_scale(&chance, 1e-12, 1e-3);
          contact_go(&it, chance_scale(&chance, 1e-9, 1e-3), slip);
          if ((*law)->normal)
            contact_go(&other, it.overlap, slip);
          else
            other.s = (*law)->shear(other.pair, it.n, slip, other.shear_history);
          depends = depends || ((*law)->normal ? other.n.force != it.n.force : other.s.force != it.s.force);
        }
      }
      CU_ASSERT_EQUAL(depends, is_listed((*law)->parameters, name));
      if (depends != is_listed((*law)->parameters, name))
        printf("# failed for %s %s, parameter %s\n", (*law)->kind, (*law)->name, name);
    }
  }
}

OF_NORMAL(pushes_and_never_pulls)
OF_NORMAL(stiffness_is_the_slope)
OF_NORMAL(never_stiffer_than_stated)
OF_SHEAR(nothing_at_zero_overlap)
OF_SHEAR(constant_stiffness_is_that_of_the_pair)
OF_SHEAR(shear_stiffness_is_the_slope)
OF_SHEAR(shear_stiffness_is_the_slope_at_stick)
OF_SHEAR(shear_stays_below_its_limit)
OF_SHEAR(mirrored_slip_gives_the_mirrored_force)
OF_SHEAR(forces_scale_with_the_stiffnesses)
OF_SHEAR(history_that_is_not_the_laws_own_is_unchanged)

void suite_laws(void) {
  CU_pSuite suite = CU_add_suite("laws", NULL, NULL);
  CU_add_test(suite, "nothing at zero overlap", shear_nothing_at_zero_overlap);
  CU_add_test(suite, "the force depends on the stated parameters", the_force_depends_on_the_stated_parameters);
  CU_add_test(suite, "normal: pushes and never pulls", normal_pushes_and_never_pulls);
  CU_add_test(suite, "normal: stiffness is the slope", normal_stiffness_is_the_slope);
  CU_add_test(suite, "normal: never stiffer than the largest stiffness", normal_never_stiffer_than_stated);
  CU_add_test(suite, "constant stiffness is that of the pair", shear_constant_stiffness_is_that_of_the_pair);
  CU_add_test(suite, "shear: stiffness is the slope", shear_shear_stiffness_is_the_slope);
  CU_add_test(suite, "shear: stiffness is the slope at stick", shear_shear_stiffness_is_the_slope_at_stick);
  CU_add_test(suite, "shear: stays below its limit", shear_shear_stays_below_its_limit);
  CU_add_test(suite, "shear: mirrored slip, mirrored force", shear_mirrored_slip_gives_the_mirrored_force);
  CU_add_test(suite, "shear: forces scale with the stiffnesses", shear_forces_scale_with_the_stiffnesses);
  CU_add_test(suite, "history slots that a law does not declare are unchanged",
              shear_history_that_is_not_the_laws_own_is_unchanged);
}
