/* Reference: R89's incremental law along the path of a contact test in which overlap (alpha) and tangential
 * displacement (delta) change in turns, in the limit of small steps: its equations solved piece by piece. T* is the
 * shear force at which unloading began, T** that at which reloading began.
 *
 * With dN = 0, [R89 3.94] becomes dT = 8 G* a theta d(delta). With theta = u^(1/3) and N = (4/3) E* a alpha
 *
 *   u = 1 - T/mu N                loading     [R89 3.95]      u^(2/3) falls by  d(delta)/(mu kappa alpha)
 *   u = 1 - (T* - T)/2 mu N       unloading   [R89 3.96]      by                |d(delta)|/(2 mu kappa alpha)
 *   u = 1 - (T - T**)/2 mu N      reloading   [R89 3.97]      the same; re-unloading goes back along it [R89 sec. 3.3]
 *
 * With d(delta) = 0 and N decreasing, [R89 3.94] becomes dT = mu dN (1 - theta), with the opposite sign in unloading,
 * while T* decreases and T** increases by mu |dN| [R89 4.20, 4.21]. Let zeta = alpha u^(2/3): at this overlap the
 * contact would be as large as the stick region is now. Then N u = N(zeta), theta = N'(zeta)/N'(alpha), and
 *
 *   d(zeta) = d(alpha)            loading                     d(zeta) = d(alpha)/2      unloading, reloading
 *
 * until zeta = alpha: there T* or T** equals T and is dropped. With N increasing there is no micro-slip [R89 3.98]: T
 * is constant, and mu kappa d(alpha) adds to the deficit of the contact [R89 3.70, 3.71, 4.16]. The next displacement
 * first makes up for the deficit with the stiffness 8 G* a; a decrease of N reduces the deficit; a reversal sets it to
 * 0.
 *
 * `randall_literal` follows the text of FORD and THETA. With d(delta) = 0, T is constant for any N. Reloading and
 * re-unloading have u = 1 - (T - T*)/2 mu N [R89 4.24]. There is no deficit, because the text uses it only where delta
 * and N change at once. The value that the text gives T* in the first step of unloading has no effect in the limit of
 * small steps.
 *
 * Returns slip (delta), shear (T) and work.shear at each step and at the end of each segment.
 * Accepts paths on which mu N is not reached, T* is positive, T does not reach -T*, and no segment prescribes T.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum sense { LOADING, UNLOADING, RELOADING }; /* RELOADING also for re-unloading */

struct contact {
  struct path_contact elastic;
  bool literal;
  enum sense sense;
  bool back;           /* re-unloading; only in RELOADING */
  bool sheared;        /* there was a tangential displacement; before it there is no deficit */
  double alpha, force; /* in m; T, in N */
  double star, star2;  /* T* and T**, in N */
  double deficit;      /* DD, m */
  double work;         /* J */
};

/* T = from + sign * times * mu N (1 - u), with times = 1 or 2. */
struct curve {
  double from, sign, times;
};

static struct curve curve_of(const struct contact *it) {
  return it->sense == LOADING     ? (struct curve){0, 1, 1}
         : it->sense == UNLOADING ? (struct curve){it->star, -1, 2}
                                  : (struct curve){it->literal ? it->star : it->star2, 1, 2};
}

static double limit(const struct contact *it) { return it->elastic.friction * path_normal(&it->elastic, it->alpha); }

static double u_of(const struct contact *it) {
  const struct curve on = curve_of(it);
  return 1 - on.sign * (it->force - on.from) / (on.times * limit(it));
}

/* Moves along the present curve by the tangential displacement `slip`, at constant N. */
static void move_along(struct contact *it, double slip) {
  const struct curve on = curve_of(it);
  const double size = on.times * limit(it), scale = on.times * it->elastic.friction * it->elastic.kappa * it->alpha;
  const double before = pow(u_of(it), 2. / 3), after = before - on.sign * slip / scale;
  it->force = on.from + on.sign * size * (1 - pow(after, 1.5));
  /* Int T d(delta), d(delta) = -sign scale d(u^(2/3)) */
  it->work += (on.from + on.sign * size) * slip + size * scale * 0.4 * (pow(after, 2.5) - pow(before, 2.5));
}

/* The displacement after which T is `force` on the present curve. */
static double slip_to(const struct contact *it, double force) {
  const struct curve on = curve_of(it);
  const double size = on.times * limit(it), scale = on.times * it->elastic.friction * it->elastic.kappa * it->alpha;
  return on.sign * scale * (pow(u_of(it), 2. / 3) - pow(1 - on.sign * (force - on.from) / size, 2. / 3));
}

static void reverse(struct contact *it) {
  if (it->sense == LOADING)
    it->star = it->force, it->sense = UNLOADING;
  else if (it->sense == UNLOADING)
    it->star2 = it->force, it->sense = RELOADING, it->back = false;
  else
    it->back = !it->back;
  it->deficit = 0;
}

/* Changes the tangential displacement by `slip` at constant N. False: the reference does not accept the path. */
static bool apply_slip(struct contact *it, double slip) {
  it->sheared = true;
  const bool on = it->sense == LOADING || (it->sense == RELOADING && !it->back);
  if ((slip > 0) != on)
    reverse(it);
  const double stiffness = 8 * it->elastic.shear * sqrt(it->elastic.radius * it->alpha);
  const double first = copysign(fmin(it->literal ? 0 : it->deficit, fabs(slip)), slip);
  it->work += (it->force + stiffness * first / 2) * first;
  it->force += stiffness * first, it->deficit -= fabs(first);
  double rest = slip - first;
  if (it->sense == RELOADING && rest != 0) {
    const double end = slip_to(it, slip > 0 ? it->star : it->star2);
    const double part = fabs(end) < fabs(rest) ? end : rest;
    move_along(it, part), rest -= part;
    if (part == end)
      it->sense = slip > 0 ? LOADING : UNLOADING;
  }
  if (rest != 0)
    move_along(it, rest);
  return it->sense == LOADING ? it->force >= 0 && it->force < limit(it)
                              : it->star > 0 && it->force > -it->star && it->force <= it->star;
}

static void set_overlap(struct contact *it, double alpha) {
  const double before = limit(it);
  it->alpha = alpha;
  it->star += limit(it) - before, it->star2 -= limit(it) - before;
}

/* Decreases the overlap to `alpha`. Micro-slip continues in the present direction. */
static void reduce_overlap(struct contact *it, double alpha) {
  const double zeta = it->alpha * pow(u_of(it), 2. / 3) + (alpha - it->alpha) / (it->sense == LOADING ? 1 : 2);
  set_overlap(it, alpha);
  const struct curve on = curve_of(it);
  it->force = on.from + on.sign * on.times * (limit(it) - it->elastic.friction * path_normal(&it->elastic, zeta));
}

/* Changes the overlap to `alpha` at constant tangential displacement. False: the reference does not accept the path. */
static bool apply_overlap(struct contact *it, double alpha) {
  const double slope = it->elastic.friction * it->elastic.kappa, decrease = it->alpha - alpha;
  const double free_part =
      it->literal ? decrease : fmin(decrease, it->deficit / slope); /* the part that leaves T unchanged */
  it->deficit -= it->sheared ? slope * free_part : 0;
  set_overlap(it, it->alpha - free_part);
  while (it->alpha > alpha) {
    const double end = it->sense == LOADING ? 0 : it->alpha * (2 * pow(u_of(it), 2. / 3) - 1); /* where zeta = alpha */
    reduce_overlap(it, fmax(end, alpha));
    if (end >= alpha)
      it->sense = it->sense == RELOADING ? UNLOADING : LOADING;
  }
  if (it->sense == RELOADING && it->force < it->star2) /* `randall_literal`: T is constant while T** increases */
    it->sense = UNLOADING;
  if (it->sense != LOADING && it->force >= it->star)
    it->sense = LOADING;
  return it->force >= (it->sense == LOADING ? 0 : -it->star) && it->force < limit(it);
}

enum { SLIP, SHEAR, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "work.shear"};

static bool walk_path(struct contact *it, const struct nb_scene *scene, struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  for (size_t k = 1; path_next(&walk, now, &target); k++) {
    const double approach = target.normal_force ? path_overlap(&it->elastic, target.normal) : target.normal;
    const double by = target.shear - now.slip;
    const bool moves = fabs(approach - it->alpha) > 1e-12 * approach;
    if (target.shear_force || !(approach > 0) || (moves && by != 0))
      return false;
    if (moves ? !apply_overlap(it, approach) : by != 0 && !apply_slip(it, by))
      return false;
    now = (struct path_point){approach, target.shear, path_normal(&it->elastic, approach), it->force};
    columns[SLIP]->values[k] = target.shear, columns[SHEAR]->values[k] = it->force, columns[WORK]->values[k] = it->work;
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct contact contact = {.literal = strcmp(scene->shear, "randall_literal") == 0};
  struct path_column *columns[COLUMNS];
  contact.elastic = path_contact(scene);
  bool made = true;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  const bool covered = made && walk_path(&contact, scene, columns);
  for (int c = 0; c < COLUMNS; c++)
    if (covered)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  if (made && !covered)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `path_randall` is for overlap and slip, or normal force and slip, that change in turns, without "
        "gross sliding, and without unloading to -T*, where T* is the shear force at which unloading began");
  return made ? solution_status(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_path_randall = {
    .name = "path_randall",
    .title = "R89's law in the limit of small steps, where approach and slip change in turns",
    .source = "[R89 3.70, 3.71, 3.94-3.98, 4.16, 4.20-4.24]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "randall randall_literal",
    .solve = solve,
};
