/* Reference: Mindlin and Deresiewicz's loops under a constant normal force, in closed form.
 *
 *   A = 3 mu N/(16 G* a)                                       slip at which the whole contact slides, m
 *   delta           = A [1 - (1 - T/mu N)^(2/3)]               loading from T = 0                                 [R89 3.25]
 *   delta* - delta  = 2A [1 - (1 - (T* - T)/2mu N)^(2/3)]      unloading from T*, delta*                          [R89 3.40]
 *   delta - delta** = 2A [1 - (1 - (T - T**)/2mu N)^(2/3)]     reloading from T**, delta**                        [R89 3.50]
 *   c/a             = (1 - T/mu N)^(1/3)                       the stuck circle while loading;
 *                     (1 - |T - T_begin|/2mu N)^(1/3)          on a branch that began by a reversal               [R89 3.24]
 *
 * Each reversal begins a branch of the same shape. A branch that comes back to the T at which the one before it began is erased
 * together with it: the curve goes on as if the loop had not been. So all that counts is a stack of branches.
 *
 *   W(t) = (6/5) mu N A [1 - (1 - t)^(5/3) - (5/6) t (1 + (1 - t)^(2/3))]
 *
 * is lost while loading to T = t mu N, and twice that on a branch of |T - T_begin| = 2 t mu N: 4 W by a loop, the formula of
 * Mindlin and Deresiewicz (1953).
 *
 * A law that remembers two reversals (`randall`) knows three branches, and goes to and fro on the third as if that were elastic.
 * One without slip but as a whole (`mindlin`, `mindlin_scaled`) has T = 8 G* a delta; it is known below the limit.
 *
 * Past A the whole contact slides, and loses mu N of each metre.
 *
 * Known at each step along `step`, and at the end of each leg: slip, shear, radius.stick, dissipated, and work.shear,
 * the integral of T d(delta) in closed form. Rounding alone.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum { BRANCHES = 1000 };

struct branch {
  double shear, slip, lost, work; /* where it begins: T/mu N, delta/A, J/(mu N A) */
  double sense;                   /* 1 or -1: that of its slip */
  double size;                    /* 1: the first loading; 2: any other */
};

struct loops {
  double limit, way, radius; /* mu N, N; A, m; a, m */
  int most;                  /* branches remembered; 0: no law of branches, T = 8 G* a delta */
  struct branch branches[BRANCHES];
  int count;
  double shear, slip, lost, work; /* now, as in struct branch */
};

static double slip_of(const struct branch *b, double shear) {
  return b->slip + b->sense * b->size * (1 - pow(1 - fabs(shear - b->shear) / b->size, 2. / 3));
}

static double shear_of(const struct branch *b, double slip) {
  const double rest = 1 - fabs(slip - b->slip) / b->size;
  return b->shear + b->sense * b->size * (1 - (rest > 0 ? pow(rest, 1.5) : 0));
}

static double lost_of(const struct branch *b, double shear) {
  const double t = fmin(fabs(shear - b->shear) / b->size, 1);
  return b->lost + b->size * 1.2 * (1 - pow(1 - t, 5. / 3) - 5. / 6 * t * (1 + pow(1 - t, 2. / 3)));
}

/* The integral of T d(delta): with u = 1 - |delta - delta_begin|/size, T - T_begin is size (1 - u^(3/2)). */
static double work_of(const struct branch *b, double shear) {
  const double u = pow(fmax(1 - fabs(shear - b->shear) / b->size, 0), 2. / 3);
  return b->work + b->shear * b->sense * b->size * (1 - u) + b->size * b->size * (1 - u - 0.4 * (1 - pow(u, 2.5)));
}

/* It goes through that force, with that much lost and done. */
static void join(struct branch *b, double shear, double lost, double work) {
  b->lost += lost - lost_of(b, shear);
  b->work += work - work_of(b, shear);
}

/* The branch that leads from now to that force, or to that slip. */
static struct branch *branch_to(struct loops *loops, double shear, double slip, bool force) {
  const double sense = (force ? shear > loops->shear : slip > loops->slip) ? 1 : -1;
  struct branch *top = &loops->branches[loops->count > 0 ? loops->count - 1 : 0];
  if (loops->count == 0 || (sense != top->sense && loops->count < loops->most)) {
    top = &loops->branches[loops->count++];
    *top = (struct branch){loops->shear, loops->slip, loops->lost, loops->work, sense, loops->count == 1 ? 1 : 2};
  }
  /* Two go at once: the one that is on its way back, and the one that it began on. Of the first loading, the way back ends at
   * the same T with the other sign. */
  while (loops->count > 1) {
    if (sense != top->sense) { /* no branch could begin: back along this one, at most to where it began */
      const double end = top->shear, lost = top->lost, work = top->work;
      if (!(sense * ((force ? shear : slip) - (force ? end : top->slip)) > 0))
        break;
      top--, loops->count--;
      join(top, end, lost, work);
      continue;
    }
    struct branch *before = top - 1;
    const double end = loops->count == 2 ? -top->shear : before->shear;
    const double end_slip = loops->count == 2 ? 2 * before->slip - top->slip : before->slip;
    if (!(sense * ((force ? shear : slip) - (force ? end : end_slip)) > 0))
      break;
    const double lost = lost_of(top, end), work = work_of(top, end);
    if (loops->count == 2) { /* loading in the other sense, as if it had never been otherwise */
      *before = (struct branch){0, before->slip, 0, 0, sense, 1};
      loops->count = 1, top = before;
    } else { /* on along the branch before the two */
      top -= 2, loops->count -= 2;
    }
    join(top, end, lost, work);
  }
  return top;
}

/* What sticks all over is a spring: in units of A and mu N its stiffness is 3/2. */
static void stretch(struct loops *loops, double target, bool force) {
  const double shear = force ? target : loops->shear + 1.5 * (target - loops->slip);
  const double slip = force ? loops->slip + (target - loops->shear) / 1.5 : target;
  loops->work += (loops->shear + shear) / 2 * (slip - loops->slip);
  loops->shear = shear, loops->slip = slip;
}

static void go(struct loops *loops, double target, bool force) {
  if (loops->most == 0) {
    stretch(loops, target, force);
    return;
  }
  if (target == (force ? loops->shear : loops->slip))
    return;
  const struct branch *branch = branch_to(loops, target, target, force);
  const double slides = force ? 0 : fabs(target - branch->slip) - branch->size;
  loops->shear = force ? target : shear_of(branch, target);
  loops->slip = force ? slip_of(branch, target) : target;
  loops->lost = lost_of(branch, loops->shear);
  loops->work = work_of(branch, loops->shear);
  if (slides > 0) { /* loaded up to the limit for the first time, from a place that has moved along */
    const double sense = branch->sense;
    loops->lost += slides, loops->work += slides;
    loops->branches[0] = (struct branch){0, target - sense, 0, 0, sense, 1};
    loops->count = 1;
    join(&loops->branches[0], sense, loops->lost, loops->work);
  }
}

static double stick(const struct loops *loops) {
  if (loops->count == 0)
    return loops->radius;
  const struct branch *top = &loops->branches[loops->count - 1];
  return loops->radius * cbrt(fmax(1 - fabs(loops->shear - top->shear) / top->size, 0));
}

enum { SLIP, SHEAR, STICK, LOST, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "radius.stick", "dissipated", "work.shear"};

/* False: the normal force changes where there is shear. */
static bool walk_path(struct loops *loops, const struct path_contact *contact, const struct nb_scene *scene,
                      struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_place now = {0};
  struct path_aim aim;
  for (size_t k = 1; path_next(&walk, now, &aim); k++) {
    const double approach = aim.normal_force ? path_overlap(contact, aim.normal) : aim.normal;
    if (fabs(approach - now.approach) > 1e-9 * now.approach) {
      if (loops->count || approach < now.approach)
        return false;
      now.approach = approach, now.normal = path_normal(contact, approach);
      loops->radius = sqrt(contact->radius * approach);
      loops->limit = contact->friction * now.normal;
      loops->way = 3 * loops->limit / (16 * contact->shear * loops->radius);
    }
    go(loops, aim.shear / (aim.shear_force ? loops->limit : loops->way), aim.shear_force);
    now.shear = loops->shear * loops->limit, now.slip = loops->slip * loops->way;
    const double joule = loops->limit * loops->way;
    const double values[COLUMNS] = {now.slip, now.shear, stick(loops), loops->lost * joule, loops->work * joule};
    for (int c = 0; c < COLUMNS; c++)
      columns[c]->values[k] = values[c];
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct path_contact contact;
  struct path_column *columns[COLUMNS];
  if (path_contact(&contact, scene, "mindlin_loops", error))
    return error->status;
  struct loops *loops = calloc(1, sizeof *loops);
  bool made = loops;
  const bool two = strcmp(scene->shear, "randall") == 0, none = strncmp(scene->shear, "mindlin", 7) == 0;
  if (loops)
    loops->most = two ? 3 : none && strcmp(scene->shear, "mindlin_deresiewicz") != 0 ? 0 : BRANCHES;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  const bool constant = made && walk_path(loops, &contact, scene, columns);
  for (int c = 0; c < COLUMNS; c++)
    if (constant)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  free(loops);
  if (made && !constant)
    return nb_error_set(error, NB_BAD_USE,
                        "mindlin_loops wants a normal force that stays what it is once there is shear");
  return made ? solution_full(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_mindlin_loops = {
    .name = "mindlin_loops",
    .title = "loops of two elastic spheres under a constant normal force, any number of reversals, in closed form",
    .source = "[R89 3.24, 3.25, 3.40, 3.50]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "mindlin mindlin_scaled mindlin_deresiewicz randall",
    .solve = solve,
};
