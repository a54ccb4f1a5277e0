/* The contract of a law, held by every one in the register: nothing here knows a law by name.
 *
 * Each test goes over all laws, and many pairs and paths drawn by chance; a shear law on top of every normal law.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <float.h>
#include <string.h>

#include "../src/laws/law.h"
#include "chance.h"
#include "suites.h"
enum { PAIRS = 200, MOST = 8 + 4 * 64 };    /* doubles that a law may remember, here */
static const double untouched = -12345.678; /* in the slots of memory that a law does not have */

/* A contact under test, with the laws' memory of it. */
struct contact {
  const struct nb_law *normal, *shear; /* shear NULL: none */
  struct nb_pair pair;
  double overlap;
  double normal_memory[NB_MEMORY], shear_memory[MOST];
  struct nb_normal n;
  struct nb_shear s;
  double lost; /* in all, by a law that says it, J */
};

static struct contact contact_of(const struct nb_law *normal, const struct nb_law *shear, struct nb_pair pair) {
  struct contact it = {.normal = normal, .shear = shear, .pair = pair};
  it.pair.pieces = shear ? shear->pieces : 0;
  if (shear && shear->cohesionless)
    it.pair.cohesion = 0;
  for (int m = 0; m < NB_MEMORY; m++)
    it.normal_memory[m] = m < normal->memory ? 0 : untouched;
  for (int m = 0; m < MOST; m++)
    it.shear_memory[m] = m < nb_law_memory(shear, it.pair) ? 0 : untouched;
  return it;
}

/* Over to this overlap, and on by this slip. */
static void contact_go(struct contact *it, double overlap, double slip) {
  const int remembered = nb_law_memory(it->shear, it->pair);
  it->n = it->normal->normal(it->pair, overlap, overlap - it->overlap, it->normal_memory);
  it->n.overlap = it->overlap = overlap;
  if (it->shear && (overlap > 0 || remembered <= NB_MEMORY))
    it->s = it->shear->shear(it->pair, it->n, slip, it->shear_memory);
  else
    it->s = (struct nb_shear){0};
  it->lost += it->shear && it->shear->loses ? it->s.lost : 0;
  if (overlap > 0)
    return;
  for (int m = 0; m < it->normal->memory; m++) /* what is remembered ends with the contact, as law_batch.h sees to */
    it->normal_memory[m] = 0;
  for (int m = 0; m < remembered; m++)
    it->shear_memory[m] = m > 0 && remembered > NB_MEMORY ? untouched : 0; /* there the first one tells */
}

/* Along a straight line of n steps; answers the work done on the contact, by the mean force of each step. */
static double contact_lead(struct contact *it, double overlap, double slip, int n) {
  const double from = it->overlap;
  double work = 0;
  for (int k = 1; k <= n; k++) {
    const double before = it->overlap;
    const struct nb_normal was = it->n;
    const struct nb_shear rubbed = it->s;
    contact_go(it, k == n ? overlap : from + (overlap - from) * k / n, slip / n);
    work += (was.force + it->n.force) / 2 * (it->overlap - before) + (rubbed.force + it->s.force) / 2 * (slip / n);
  }
  return work;
}

static struct nb_pair pair_by(struct chance *chance) {
  struct nb_pair pair = {.kn = chance_scale(chance, 1e-6, 1e10)};
  pair.ks = chance_between(chance, 0, 1) < 0.1 ? 0 : pair.kn * chance_between(chance, 0.2, 1.5);
  pair.friction = chance_between(chance, 0, 1) < 0.2 ? 0 : chance_between(chance, 0.05, 1);
  pair.cohesion = chance_between(chance, 0, 1) < 0.7 ? 0 : pair.kn * chance_scale(chance, 1e-9, 1e-4);
  pair.young = pair.kn * chance_scale(chance, 1e6, 1e9);        /* 1/m: contacts as stiff as k_n, or stiffer */
  pair.shear = pair.young * chance_between(chance, 0.16, 0.26); /* (1 - nu)/2(2 - nu) of like materials */
  pair.radius = chance_scale(chance, 1e-5, 1);
  return pair;
}

/* Calls `test` for every normal law alone (shear NULL) or with every shear law, many times each. */
static void every_law(bool shears, void (*test)(struct contact it, struct chance *chance)) {
  int tried = 0;
  for (const struct nb_law *const *normal = nb_laws(); *normal; normal++) {
    if (!(*normal)->normal)
      continue;
    for (const struct nb_law *const *shear = nb_laws(); *shear; shear++) {
      if (shears ? !(*shear)->shear || ((*shear)->elastic && !(*normal)->elastic) : *shear != *normal)
        continue;
      const unsigned before = CU_get_number_of_failures();
      struct chance chance = chance_begin(1);
      for (int k = 0; k < PAIRS && CU_get_number_of_failures() == before; k++, tried++) /* one failure says it */
        test(contact_of(*normal, shears ? *shear : NULL, pair_by(&chance)), &chance);
      if (CU_get_number_of_failures() > before)
        printf("# by law normal %s%s%s\n", (*normal)->name, shears ? " with shear " : "", shears ? (*shear)->name : "");
    }
  }
  CU_ASSERT(tried > 0);
}

static double stored(const struct contact *it) {
  double sum = it->normal->stored(it->pair, it->n, it->normal_memory);
  if (it->shear)
    sum += it->shear->stored(it->pair, it->n, it->shear_memory);
  return sum;
}

/* ---- one contact ---- */

static void nothing_at_zero_overlap(struct contact it, struct chance *chance) {
  for (int k = 0; k < 3; k++) { /* at first touch, and after a history */
    contact_go(&it, 0, chance_between(chance, -1e-4, 1e-4));
    CU_ASSERT(it.n.force == 0 && it.n.stiffness == 0 && it.n.radius == 0);
    CU_ASSERT(it.s.force == 0 && it.s.stiffness == 0 && it.s.sliding == 0);
    if (it.normal->stored)
      CU_ASSERT_EQUAL(it.normal->stored(it.pair, it.n, it.normal_memory), 0);
    if (it.shear->stored)
      CU_ASSERT_EQUAL(it.shear->stored(it.pair, it.n, it.shear_memory), 0);
    contact_lead(&it, chance_scale(chance, 1e-9, 1e-4), chance_between(chance, -1e-5, 1e-5), 3);
  }
}

static void pushes_and_never_pulls(struct contact it, struct chance *chance) {
  for (int k = 0; k < 20; k++) {
    const double overlap = chance_scale(chance, 1e-300, 1e3);
    contact_go(&it, overlap, 0);
    CU_ASSERT(it.n.force >= 0 && it.n.stiffness >= 0 && isfinite(it.n.force) && isfinite(it.n.stiffness));
    if (overlap > 1e-12)
      CU_ASSERT(it.n.force > 0 && it.n.stiffness > 0);
  }
}

/* A force is known to an epsilon of it, so a difference over 2h to F epsilon/h; the step is far too short for curvature
 * to count. */
static void stiffness_is_the_slope(struct contact it, struct chance *chance) {
  const double overlap = chance_scale(chance, 1e-9, 1e-3), h = ldexp(overlap, -17);
  contact_lead(&it, overlap - h, 0, 16);
  const double below = it.n.force;
  contact_go(&it, overlap, 0);
  const double stiffness = it.n.stiffness, tolerance = 8 * DBL_EPSILON * it.n.force / h;
  contact_go(&it, overlap + h, 0);
  CU_ASSERT(fabs((it.n.force - below) / (2 * h) - stiffness) <= tolerance);
}

static void shear_stiffness_is_the_slope(struct contact it, struct chance *chance) {
  if (it.shear->loses)
    return; /* it slips a little before it slides: tested below */
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
    CU_ASSERT(fabs((it.s.force - before) / (2 * h) - stiffness) <= tolerance);
}

/* A law that loses energy before it slides as a whole has its stiffness where slip has just turned round, and less in
 * micro-slip: over a way h, of what would make the contact slide, it has lost a share of it of the order of h. */
static void shear_stiffness_is_the_slope_at_stick(struct contact it, struct chance *chance) {
  if (!it.shear->loses || it.pair.friction == 0)
    return;
  contact_lead(&it, chance_scale(chance, 1e-9, 1e-3), 0, 16);
  const double slide = it.pair.friction * it.n.force / it.s.stiffness * 1.5; /* 3 mu N/16 G* a  [R89 3.25] */
  const double slip = (chance_between(chance, -1, 1) < 0 ? -1 : 1) * slide, share = chance_between(chance, 0.1, 0.9);
  contact_lead(&it, it.overlap, share * slip, 64);
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

/* A law has no size of its own: what is softer by a power of two, in stiffness and cohesion, feels less by just that. */
static void forces_scale_with_the_stiffnesses(struct contact it, struct chance *chance) {
  const double share = ldexp(1, -60);
  struct contact soft = it;
  soft.pair.kn *= share, soft.pair.ks *= share, soft.pair.cohesion *= share;
  soft.pair.young *= share, soft.pair.shear *= share;
  for (int k = 0; k < 20; k++) {
    const double overlap = chance_scale(chance, 1e-9, 1e-3);
    const double slip = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-3);
    contact_go(&it, overlap, slip);
    contact_go(&soft, overlap, slip);
    CU_ASSERT(soft.n.force == share * it.n.force && soft.n.stiffness == share * it.n.stiffness);
    CU_ASSERT(soft.s.force == share * it.s.force && soft.s.stiffness == share * it.s.stiffness);
    CU_ASSERT(soft.s.sliding == it.s.sliding);
    if (it.normal->stored && it.shear->stored)
      CU_ASSERT_EQUAL(stored(&soft), share * stored(&it));
  }
}

static void memory_that_is_not_the_laws_own_is_left_alone(struct contact it, struct chance *chance) {
  for (int k = 0; k < 20; k++)
    contact_go(&it, k % 7 == 6 ? 0 : chance_scale(chance, 1e-9, 1e-3), chance_between(chance, -1e-4, 1e-4));
  for (int m = it.normal->memory; m < NB_MEMORY; m++)
    CU_ASSERT_EQUAL(it.normal_memory[m], untouched);
  for (int m = nb_law_memory(it.shear, it.pair); m < MOST; m++)
    CU_ASSERT_EQUAL(it.shear_memory[m], untouched);
}

/* ---- energy ---- */

struct corner {
  double overlap, slip; /* to this overlap, on by this slip */
};

/* Three times around, from a contact that carries no shear. Steps are finite, so the work is off by something that
 * falls with them: what it changes by when there are twice as many is taken for it, four times over. */
static void go_around(const struct contact *at, const struct corner *corners, int count) {
  struct contact coarse = *at, fine = *at;
  double work = 0, finer = 0, scale = 0;
  for (int round = 0; round < 3; round++) {
    for (int k = 0; k < count; k++) {
      const double before = fine.overlap;
      work += contact_lead(&coarse, corners[k].overlap, corners[k].slip, 128);
      finer += contact_lead(&fine, corners[k].overlap, corners[k].slip, 256);
      scale += fine.n.force * (fabs(fine.overlap - before) + fabs(corners[k].slip)) + fabs(finer);
    }
    CU_ASSERT(finer >= -4 * fabs(finer - work) - 256 * DBL_EPSILON * scale);
  }
}

static void closed_paths_give_no_energy(struct contact it, struct chance *chance) {
  if (it.normal->gains || (it.shear && it.shear->gains))
    return;
  const double low = chance_scale(chance, 1e-8, 1e-4), high = low * chance_between(chance, 1.1, 5);
  const double reach = low * chance_between(chance, 0.05, 4) * (chance_between(chance, -1, 1) < 0 ? -1 : 1);
  contact_lead(&it, low, 0, 128);
  go_around(&it, (struct corner[]){{high, 0}, {low, 0}}, 2);
  go_around(&it, (struct corner[]){{low, reach}, {low, -reach}}, 2);
  go_around(&it, (struct corner[]){{low, reach}, {low, -2 * reach}, {low, reach}}, 3);
  go_around(&it, (struct corner[]){{low, reach}, {high, 0}, {high, -reach}, {low, 0}}, 4);
  go_around(&it, (struct corner[]){{high, 0}, {high, reach}, {low, 0}, {low, -reach}}, 4);
  go_around(&it, (struct corner[]){{high, reach}, {low, -reach}}, 2);
  go_around(&it, (struct corner[]){{0, reach}, {low, -reach}}, 2);
}

/* From step to step: never more than the work put in, and all of it while nothing slides. A law that says what it loses
 * stores the rest, sliding or not. */
static void stored_energy_is_the_work(struct contact it, struct chance *chance) {
  if (!it.normal->stored || (it.shear && !it.shear->stored))
    return;
  contact_lead(&it, chance_scale(chance, 1e-8, 1e-4), 0, 64);
  int stuck = 0;
  for (int leg = 0; leg < 40; leg++) {
    const double to = it.overlap * chance_between(chance, 0.7, 1.4);
    const double slip = chance_between(chance, -1, 1) * it.overlap * (leg % 2 ? 0.02 : 0.3);
    struct contact coarse = it;
    const double before = stored(&it), already = it.lost, work = contact_lead(&coarse, to, slip, 64);
    bool slid = false;
    double finer = 0;
    const double from = it.overlap;
    for (int k = 1; k <= 128; k++) {
      finer += contact_lead(&it, from + (to - from) * k / 128, slip / 128, 1);
      slid = slid || (it.s.sliding > 0 && !it.shear->loses);
    }
    const double lost = it.lost - already, less = coarse.lost - already;
    const double error = 4 * (fabs(finer - work) + fabs(lost - less)) + 1024 * DBL_EPSILON * (before + stored(&it));
    CU_ASSERT(stored(&it) - before <= finer + error && lost >= -error);
    if (!slid)
      CU_ASSERT(fabs(stored(&it) + lost - before - finer) <= error);
    stuck += !slid;
  }
  if (it.shear && it.pair.friction > 0.1)
    CU_ASSERT(stuck > 0);
}

#define OF_NORMAL(test)                                                                                                \
  static void normal_##test(void) { every_law(false, test); }
#define OF_SHEAR(test)                                                                                                 \
  static void shear_##test(void) { every_law(true, test); }
OF_NORMAL(pushes_and_never_pulls)
OF_NORMAL(stiffness_is_the_slope)
OF_NORMAL(closed_paths_give_no_energy)
OF_NORMAL(stored_energy_is_the_work)
OF_SHEAR(nothing_at_zero_overlap)
OF_SHEAR(shear_stiffness_is_the_slope)
OF_SHEAR(shear_stiffness_is_the_slope_at_stick)
OF_SHEAR(shear_stays_below_its_limit)
OF_SHEAR(mirrored_slip_gives_the_mirrored_force)
OF_SHEAR(forces_scale_with_the_stiffnesses)
OF_SHEAR(memory_that_is_not_the_laws_own_is_left_alone)
OF_SHEAR(closed_paths_give_no_energy)
OF_SHEAR(stored_energy_is_the_work)

void suite_laws(void) {
  CU_pSuite suite = CU_add_suite("laws", NULL, NULL);
  CU_add_test(suite, "nothing at zero overlap", shear_nothing_at_zero_overlap);
  CU_add_test(suite, "normal: pushes and never pulls", normal_pushes_and_never_pulls);
  CU_add_test(suite, "normal: stiffness is the slope", normal_stiffness_is_the_slope);
  CU_add_test(suite, "normal: closed paths give no energy", normal_closed_paths_give_no_energy);
  CU_add_test(suite, "normal: stored energy is the work", normal_stored_energy_is_the_work);
  CU_add_test(suite, "shear: stiffness is the slope", shear_shear_stiffness_is_the_slope);
  CU_add_test(suite, "shear: stiffness is the slope at stick", shear_shear_stiffness_is_the_slope_at_stick);
  CU_add_test(suite, "shear: stays below its limit", shear_shear_stays_below_its_limit);
  CU_add_test(suite, "shear: mirrored slip, mirrored force", shear_mirrored_slip_gives_the_mirrored_force);
  CU_add_test(suite, "shear: forces scale with the stiffnesses", shear_forces_scale_with_the_stiffnesses);
  CU_add_test(suite, "shear: closed paths give no energy", shear_closed_paths_give_no_energy);
  CU_add_test(suite, "shear: stored energy is the work", shear_stored_energy_is_the_work);
  CU_add_test(suite, "memory not declared is left alone", shear_memory_that_is_not_the_laws_own_is_left_alone);
}
