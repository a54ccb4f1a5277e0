/* A law on random paths: tests that forces are within the friction limit, numbers are finite, the history is within its
 * bounds, and no energy is created.
 *
 * The contact moves along each segment of a path twice from the same state, first in `COARSE` steps and then in twice
 * as many. The error of the work is estimated from the difference, as in laws_energy.c. The segments of
 * `KIND_DECADES` are one step each, too large for a test of the energy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>

#include "paths.h"

enum { COARSE = 4, FINE = 2 * COARSE };
static const double rounding = 256 * DBL_EPSILON; /* relative rounding of the sum of all works of a contact */
/* Relative rounding of mu N + c and of T, as in tests/laws.c. */
static const double limit_rounding = 2 * DBL_EPSILON;
const double most_joined = 1e-3;

/* The energy account of one force of a contact, J. */
struct account {
  double work, given, sum; /* work; energy given to the contact; sum of the magnitudes of all works */
  double error;            /* error of `work` because of the finite steps */
};
/* The work of the normal force and of the shear force in some steps. `sum` has the sums of the magnitudes of the work
 * of each step, [0] normal, [1] shear. */
struct works {
  double normal, shear, sum[2];
};

static void book(struct account *account, double fine, double coarse, double size) {
  account->work += fine, account->sum += size;
  account->given += fine > 0 ? fine : 0;
  account->error += 16 * fabs(fine - coarse) + rounding * size;
}

static bool is_finite(const struct contact *it) {
  bool is = isfinite(it->n.force) && isfinite(it->n.stiffness) && isfinite(it->n.radius);
  is = is && isfinite(it->s.force) && isfinite(it->s.stiffness) && isfinite(it->dissipated);
  const int used = it->shear->used && it->overlap > 0 ? it->shear->used(it->shear_history)
                   : it->shear->used                  ? 0
                                                      : it->shear->history;
  for (int m = 0; m < used && m < MOST; m++)
    is = is && isfinite(it->shear_history[m]);
  for (int m = 0; m < it->normal->history; m++)
    is = is && isfinite(it->normal_history[m]);
  return is;
}

/* True if the law has left the cache line after its declared variables unchanged, and if the values of the declared
 * variables would be valid in a saved state. */
static bool is_within(const struct contact *it) {
  const struct nb_law *law = it->shear;
  bool is = true;
  const int end = nb_law_history(law, it->pair);
  for (int m = end; m < end + 8 && m < MOST; m++)
    is = is && it->shear_history[m] == untouched;
  for (int m = it->normal->history; m < NB_HISTORY; m++)
    is = is && it->normal_history[m] == untouched;
  if (law->valid && it->overlap > 0 && it->shear_history[0] > 0)
    is = is && law->valid(it->shear_history, law->used(it->shear_history), (int)it->pair.pieces);
  return is;
}

static void inspect(const struct contact *it, struct findings *findings) {
  const double limit = it->n.force * it->pair.friction + it->pair.cohesion, force = fabs(it->s.force);
  const double excess = force > limit ? (limit > 0 ? force / limit - 1 : INFINITY) : 0;
  findings->steps++;
  findings->excess = excess > findings->excess ? excess : findings->excess;
  findings->not_finite += !is_finite(it);
  findings->outside += !is_within(it);
  findings->not_emptied += !(it->overlap > 0) && (it->s.force != 0 || it->n.force != 0);
}

/* Makes n equal steps to this overlap, with this tangential displacement in all, and returns their works. `findings` is
 * NULL if the steps are not to be tested. */
static struct works lead(struct contact *it, double overlap, double slip, int n, struct findings *findings) {
  const double from = it->overlap;
  struct works works = {0};
  for (int k = 1; k <= n; k++) {
    const double before = it->overlap, normal = it->n.force, shear = it->s.force;
    contact_go(it, k == n ? overlap : from + (overlap - from) * k / n, slip / n);
    const double push = (normal + it->n.force) / 2 * (it->overlap - before),
                 drag = (shear + it->s.force) / 2 * (slip / n);
    works.normal += push, works.shear += drag;
    works.sum[0] += fabs(push), works.sum[1] += fabs(drag);
    if (findings)
      inspect(it, findings);
  }
  return works;
}

static double stored_shear(const struct contact *it) {
  return it->shear->stored && it->overlap > 0 ? it->shear->stored(it->pair, it->n, it->shear_history) : 0;
}
static double stored_normal(const struct contact *it) {
  return it->normal->stored ? it->normal->stored(it->pair, it->n, it->normal_history) : 0;
}

/* The order of magnitude of the energy at which the whole contact slides. Stored energies are rounded relative to this
 * energy. */
static double slide_energy(const struct contact *it) {
  const double limit = it->n.force * it->pair.friction + it->pair.cohesion;
  return it->s.stiffness > 0 ? limit * limit / it->s.stiffness : 0;
}

/* Tests that a contact never returns more energy than it was given since first touch. */
static void compare_with_given(struct findings *findings, const struct contact *it, const struct nb_law *law,
                               const struct account *account) {
  const double created = -account->work - account->error;
  if (!(created > 0))
    return;
  double *most = &findings->created[it->pair.friction > 1];
  *most = fmax(*most, created / account->given);
  findings->creations += !law->non_conservative;
}

/* Tests that the stored energy grows by at most the work. */
static void compare_with_stored(struct findings *findings, double grown, double work, double error, double given) {
  if (grown > work + error)
    findings->grown = fmax(findings->grown, (grown - work - error) / given);
}

static void account_segment(struct contact *it, double overlap, double slip, struct account accounts[2],
                            struct findings *findings) {
  struct contact coarse = *it;
  const double shear_before = stored_shear(it), normal_before = stored_normal(it), slide_before = slide_energy(it);
  const struct works rough = lead(&coarse, overlap, slip, COARSE, NULL);
  const struct works fine = lead(it, overlap, slip, FINE, findings);
  book(&accounts[0], fine.normal, rough.normal, fine.sum[0]);
  book(&accounts[1], fine.shear, rough.shear, fine.sum[1]);
  compare_with_given(findings, it, it->normal, &accounts[0]);
  compare_with_given(findings, it, it->shear, &accounts[1]);
  const double shear = stored_shear(it), normal = stored_normal(it);
  if (it->shear->stored)
    compare_with_stored(findings, shear - shear_before, fine.shear,
                        16 * (fabs(fine.shear - rough.shear) + fabs(shear - stored_shear(&coarse))) +
                            rounding * (fine.sum[1] + slide_before + slide_energy(it)),
                        accounts[1].given);
  if (it->normal->stored)
    compare_with_stored(findings, normal - normal_before, fine.normal,
                        16 * (fabs(fine.normal - rough.normal) + fabs(normal - stored_normal(&coarse))) +
                            rounding * (fine.sum[0] + normal_before + normal),
                        accounts[0].given);
}

/* The displacement at which a contact of this overlap slides: 3 mu N/(16 G* a) for elastic spheres [R89 3.25], and 1.5
 * times the displacement of a spring otherwise. The result is at most the overlap, because contacts with high friction
 * do not move by more than that. */
static double slide_of(struct contact it, double overlap) {
  contact_go(&it, overlap, 0);
  const double slide = 1.5 * it.pair.friction * it.n.force / it.s.stiffness;
  return slide > 0 && slide < overlap ? slide : overlap;
}

static struct contact contact_by(const struct nb_law *normal, const struct nb_law *shear, struct chance *chance) {
  static const double extreme[] = {1e-12, 10, 1e6};
  struct nb_pair pair = pair_by(chance);
  const int which = (int)chance_between(chance, 0, 6);
  if (which < 3)
    pair.friction = extreme[which];
  return contact_of(normal, shear, pair);
}

struct findings law_on_paths(const struct nb_law *normal, const struct nb_law *shear, int kind, long steps) {
  struct findings findings = {0};
  struct path path = path_of(kind, 1);
  struct chance chance = chance_begin(2);
  struct contact it = {0};
  struct account accounts[2] = {0};
  double scale = 0, unit = 0, at = 0;
  while (findings.steps < steps) {
    const struct point point = path_next(&path);
    if (point.first) {
      it = contact_by(normal, shear, &chance);
      scale = it.pair.radius * chance_scale(&chance, 1e-9, 1e-3);
      unit = slide_of(it, scale), at = 0;
      accounts[0] = accounts[1] = (struct account){0};
      findings.contacts++;
    }
    if (kind == KIND_DECADES)
      lead(&it, scale * point.x, unit * (point.u - at), 1, &findings);
    else
      account_segment(&it, scale * point.x, unit * (point.u - at), accounts, &findings);
    at = point.u;
    if (!(point.x > 0))
      accounts[0] = accounts[1] = (struct account){0};
  }
  return findings;
}

void findings_add(struct findings *sum, const struct findings *more) {
  sum->steps += more->steps, sum->contacts += more->contacts;
  sum->excess = fmax(sum->excess, more->excess);
  sum->not_finite += more->not_finite, sum->outside += more->outside, sum->not_emptied += more->not_emptied;
  for (int k = 0; k < 2; k++)
    sum->created[k] = fmax(sum->created[k], more->created[k]);
  sum->creations += more->creations, sum->grown = fmax(sum->grown, more->grown);
}

const char *broken_promise(const struct findings *findings, bool joins) {
  return findings->not_finite                          ? "a number is not finite"
         : findings->not_emptied                       ? "an open contact has a force"
         : !(findings->excess <= limit_rounding)       ? "the shear force exceeds mu N"
         : findings->outside                           ? "the history leaves its bounds"
         : findings->creations                         ? "a contact returns more energy than it was given"
         : findings->grown > (joins ? most_joined : 0) ? "the stored energy grows by more than the work"
                                                       : NULL;
}
