/* Reference: R89's incremental law along a path of the bench in which approach and slip move by turns: its equations solved, piece
 * by piece, in the limit of small steps.
 *
 * With dN = 0 [R89 3.94] is dT = 8 G* a theta d(delta), and with theta = u^(1/3) and N = (4/3) E* a alpha
 *
 *   u = 1 - T/mu N                loading     [R89 3.95]      u^(2/3) falls by  d(delta)/(mu kappa alpha)
 *   u = 1 - (T* - T)/2 mu N       unloading   [R89 3.96]      by                |d(delta)|/(2 mu kappa alpha)
 *   u = 1 - (T - T**)/2 mu N      reloading   [R89 3.97]      likewise, and back along it on re-unloading [R89 3.3]
 *
 * With d(delta) = 0 and N falling it is dT = mu dN (1 - theta), of the other sign in unloading [R89 3.94], while T* falls and T**
 * rises by mu |dN| [R89 4.20, 4.21]. With zeta = alpha u^(2/3), the overlap at which the front would be the edge, mu N u is mu N(zeta)
 * and theta is dN(zeta)/dN for like steps of both, which leaves
 *
 *   d(zeta) = d(alpha)            loading                     d(zeta) = d(alpha)/2      unloading, reloading
 *
 * until zeta is alpha: there T* or T** has come to T, and is forgotten. With N rising nothing slips [R89 3.98]: T stays, and the
 * contact lacks mu kappa d(alpha) of slip [R89 3.70, 3.71, 4.16], which has to be made up for along 8 G* a, or undone by N falling.
 * A reversal forgets what is lacking.
 *
 * `randall_literal`, the text of FORD and THETA: with d(delta) = 0 it leaves T alone whatever N does; reloading and re-unloading
 * have u = 1 - (T - T*)/2 mu N [R89 4.24]; and nothing is lacking, since that is asked for only where slip and N move at once.
 * What its first step of unloading has for T* is of one step, and nothing in the limit.
 *
 * Known at each step and at the end of each leg: slip, shear, work.shear.
 * Range      mu N is never reached, T* is positive, and T does not come to -T*; else the path is refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum sense { LOADING, UNLOADING, RELOADING }; /* the last one also back along it */

struct contact {
  struct path_contact elastic;
  bool literal;
  enum sense sense;
  bool back;                 /* re-unloading */
  bool rubbed;               /* before that all that sticks is core, and lacks nothing */
  double alpha, force;       /* m; T, N */
  double star, star2, lacks; /* T*, T**, N; m */
  double work;               /* J */
};

/* T = from + sign times mu N (1 - u), with times = 1 or 2. */
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

/* On this curve by so much slip, N constant. */
static void glide(struct contact *it, double slip) {
  const struct curve on = curve_of(it);
  const double size = on.times * limit(it), reach = on.times * it->elastic.friction * it->elastic.kappa * it->alpha;
  const double before = pow(u_of(it), 2. / 3), after = before - on.sign * slip / reach;
  it->force = on.from + on.sign * size * (1 - pow(after, 1.5));
  /* Int T d(delta), d(delta) = -sign reach d(u^(2/3)) */
  it->work += (on.from + on.sign * size) * slip + size * reach * 0.4 * (pow(after, 2.5) - pow(before, 2.5));
}

/* The slip with which T comes to `force` on this curve. */
static double slip_to(const struct contact *it, double force) {
  const struct curve on = curve_of(it);
  const double size = on.times * limit(it), reach = on.times * it->elastic.friction * it->elastic.kappa * it->alpha;
  return on.sign * reach * (pow(u_of(it), 2. / 3) - pow(1 - on.sign * (force - on.from) / size, 2. / 3));
}

static void turn(struct contact *it) {
  if (it->sense == LOADING)
    it->star = it->force, it->sense = UNLOADING;
  else if (it->sense == UNLOADING)
    it->star2 = it->force, it->sense = RELOADING, it->back = false;
  else
    it->back = !it->back;
  it->lacks = 0;
}

/* N constant. False: out of range. */
static bool rub(struct contact *it, double slip) {
  it->rubbed = true;
  const bool on = it->sense == LOADING || (it->sense == RELOADING && !it->back);
  if ((slip > 0) != on)
    turn(it);
  const double stiffness = 8 * it->elastic.shear * sqrt(it->elastic.radius * it->alpha);
  const double first = copysign(fmin(it->literal ? 0 : it->lacks, fabs(slip)), slip);
  it->work += (it->force + stiffness * first / 2) * first;
  it->force += stiffness * first, it->lacks -= fabs(first);
  double rest = slip - first;
  if (it->sense == RELOADING && rest != 0) {
    const double end = slip_to(it, slip > 0 ? it->star : it->star2);
    const double part = fabs(end) < fabs(rest) ? end : rest;
    glide(it, part), rest -= part;
    if (part == end)
      it->sense = slip > 0 ? LOADING : UNLOADING, it->back = false;
  }
  if (rest != 0)
    glide(it, rest);
  return it->sense == LOADING ? it->force >= 0 && it->force < limit(it)
                              : it->star > 0 && it->force > -it->star && it->force <= it->star;
}

static void move(struct contact *it, double alpha) {
  const double before = limit(it);
  it->alpha = alpha;
  it->star += limit(it) - before, it->star2 -= limit(it) - before;
}

/* To this overlap while slip goes on in its sense, N falling. */
static void creep(struct contact *it, double alpha) {
  const double zeta = it->alpha * pow(u_of(it), 2. / 3) + (alpha - it->alpha) / (it->sense == LOADING ? 1 : 2);
  move(it, alpha);
  const struct curve on = curve_of(it);
  it->force = on.from + on.sign * on.times * (limit(it) - it->elastic.friction * path_normal(&it->elastic, zeta));
}

/* No slip. False: out of range. */
static bool press(struct contact *it, double alpha) {
  const double slope = it->elastic.friction * it->elastic.kappa, down = it->alpha - alpha;
  const double stays = it->literal ? down : fmin(down, it->lacks / slope); /* of it T does not go with N */
  it->lacks -= it->rubbed ? slope * stays : 0;
  move(it, it->alpha - stays);
  while (it->alpha > alpha) {
    const double end = it->sense == LOADING ? 0 : it->alpha * (2 * pow(u_of(it), 2. / 3) - 1); /* there zeta is alpha */
    creep(it, fmax(end, alpha));
    if (end >= alpha)
      it->sense = it->sense == RELOADING ? UNLOADING : LOADING;
  }
  if (it->sense == RELOADING && it->force < it->star2) /* the text */
    it->sense = UNLOADING;
  if (it->sense != LOADING && it->force >= it->star)
    it->sense = LOADING, it->lacks = 0;
  return it->force >= (it->sense == LOADING ? 0 : -it->star) && it->force < limit(it);
}

enum { SLIP, SHEAR, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "work.shear"};

static bool walk_path(struct contact *it, const struct nb_scene *scene, struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_place now = {0};
  struct path_aim aim;
  for (size_t k = 1; path_next(&walk, now, &aim); k++) {
    const double approach = aim.normal_force ? path_overlap(&it->elastic, aim.normal) : aim.normal;
    const double by = aim.shear - now.slip;
    const bool moves = fabs(approach - it->alpha) > 1e-12 * approach;
    if (aim.shear_force || !(approach > 0) || (moves && by != 0))
      return false;
    if (moves ? !press(it, approach) : by != 0 && !rub(it, by))
      return false;
    now = (struct path_place){approach, aim.shear, path_normal(&it->elastic, approach), it->force};
    columns[SLIP]->values[k] = aim.shear, columns[SHEAR]->values[k] = it->force, columns[WORK]->values[k] = it->work;
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct contact contact = {.literal = strcmp(scene->shear, "randall_literal") == 0};
  struct path_column *columns[COLUMNS];
  if (path_contact(&contact.elastic, scene, "path_randall", error))
    return error->status;
  if (!contact.literal && strcmp(scene->shear, "randall") != 0)
    return nb_error_set(error, NB_BAD_USE, "path_randall knows `shear randall` and `shear randall_literal`, not `%s`",
                        scene->shear);
  bool made = true;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  const bool right = made && walk_path(&contact, scene, columns);
  for (int c = 0; c < COLUMNS; c++)
    if (right)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  if (made && !right)
    return nb_error_set(
        error, NB_BAD_USE,
        "path_randall wants overlap and slip, or the normal force and slip, to move by turns, first out, "
        "and nothing that slides or is rubbed back beyond the loading");
  return made ? solution_full(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_path_randall = {
    .name = "path_randall",
    .title = "R89's law in the limit of small steps, where approach and slip move by turns",
    .source = "[R89 3.70-3.98, 4.20-4.24]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "randall randall_literal",
    .solve = solve,
};
