/* Reference: Mindlin and Deresiewicz's loops of the shear force T against the tangential displacement delta, at a
 * constant normal force N, in closed form.
 *
 *   A = 3 mu N/(16 G* a)                                       displacement at which gross sliding begins, m
 *   delta           = A [1 - (1 - T/mu N)^(2/3)]               loading from T = 0                            [R89 3.25]
 *   delta* - delta  = 2A [1 - (1 - (T* - T)/2mu N)^(2/3)]      unloading from T*, delta*                     [R89 3.40]
 *   delta - delta** = 2A [1 - (1 - (T - T**)/2mu N)^(2/3)]     reloading from T**, delta**                   [R89 3.50]
 *   c/a             = (1 - T/mu N)^(1/3)                       stick radius in loading from T = 0            [R89 3.24]
 *                   = (1 - |T - T_begin|/2mu N)^(1/3)          on a branch that began by a reversal
 *
 * Each reversal begins a branch of the same shape. When a branch returns to the T at which the previous branch began,
 * both are erased: the curve continues as if the loop had not been made. So the state is a stack of branches. The
 * energy
 *
 *   W(t) = (6/5) mu N A [1 - (1 - t)^(5/3) - (5/6) t (1 + (1 - t)^(2/3))]
 *
 * is dissipated in loading to T = t mu N, and 2 W(t) on a later branch along which T changes by 2 t mu N. A loop
 * consists of two such branches, so it dissipates 4 W, the formula of Mindlin and Deresiewicz (1953).
 *
 * A law that stores two reversals (`randall`) has three branches; it moves back and forth on the third one elastically.
 * A law without micro-slip (`mindlin`, `mindlin_scaled`) has dT = 8 G* a d(delta) while |T| < mu N, and otherwise
 * T = mu N or -mu N: an elastic spring in series with a slider. At constant N both laws are the same, because
 * `mindlin_scaled` differs only when N decreases. In gross sliding the contact dissipates mu N times the sliding
 * displacement, and c = 0. A shear force above mu N cannot be reached; then there are no values.
 *
 * Returns slip (delta), shear (T), radius.stick (c), dissipated and work.shear (the integral of T d(delta)), as curves
 * versus step and at the end of each segment. Refuses a normal force that decreases, or that changes during or after
 * shear. Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum { BRANCHES = 1000 };
/* A shear force that is given may exceed mu N by this fraction, which then counts as rounding. The contact test allows
 * the same. */
static const double rounding = 1e-13;

struct branch {
  double shear, slip, lost, work; /* at its beginning: T/(mu N), delta/A; energy lost and work, divided by mu N A */
  double sense;                   /* 1 or -1, of its slip */
  double size;                    /* 1: the first loading; 2: any other */
};

struct loops {
  double limit, scale, radius; /* mu N, in N; A and a, in m */
  int capacity;                /* branches stored; 0: spring and slider */
  bool sheared;                /* the contact has been displaced tangentially */
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

/* Shifts the energies of the branch so that they are `lost` and `work` at the force `shear`. */
static void set_energies(struct branch *b, double shear, double lost, double work) {
  b->lost += lost - lost_of(b, shear);
  b->work += work - work_of(b, shear);
}

/* The branch that leads from the present state to `target`, which is a force if `force` is true, otherwise a slip. Adds
 * and erases branches on the way. Before the first branch, the sense of branches[0] is 0. */
static struct branch *branch_to(struct loops *loops, double target, bool force) {
  const double sense = target > (force ? loops->shear : loops->slip) ? 1 : -1;
  struct branch *top = &loops->branches[loops->count > 0 ? loops->count - 1 : 0];
  if (sense != top->sense && loops->count < loops->capacity) {
    top = &loops->branches[loops->count++];
    *top = (struct branch){loops->shear, loops->slip, loops->lost, loops->work, sense, loops->count == 1 ? 1 : 2};
  }
  /* When a branch returns to the T at which the previous branch began, both are erased. The second branch, which began
   * at some T of the first loading, ends at -T. */
  while (loops->count > 1) {
    if (sense != top->sense) { /* all branches are in use: back along this one, at most to its beginning */
      if (!(sense * (target - (force ? top->shear : top->slip)) > 0))
        break;
      top--, loops->count--;
      continue;
    }
    struct branch *before = top - 1;
    const double end = loops->count == 2 ? -top->shear : before->shear;
    const double end_slip = loops->count == 2 ? 2 * before->slip - top->slip : before->slip;
    if (!(sense * (target - (force ? end : end_slip)) > 0))
      break;
    const double lost = lost_of(top, end), work = work_of(top, end);
    if (loops->count == 2) { /* virgin loading in the other sense */
      *before = (struct branch){0, before->slip, 0, 0, sense, 1};
      loops->count = 1, top = before;
    } else { /* continue on the branch before the two */
      top -= 2, loops->count -= 2;
    }
    set_energies(top, end, lost, work);
  }
  return top;
}

/* Spring and slider: in units of A and mu N the stiffness of the spring is 3/2, and the slider moves at |T| = 1. */
static void advance_spring(struct loops *loops, double target, bool force) {
  const double before = loops->shear, trial = force ? target : before + 1.5 * (target - loops->slip);
  const double shear = fabs(trial) > 1 ? copysign(1, trial) : trial, slides = fabs(trial - shear) / 1.5;
  loops->work += (shear * shear - before * before) / 3 + slides;
  loops->lost += slides;
  loops->slip = force ? loops->slip + (target - before) / 1.5 : target;
  loops->shear = shear;
}

/* Moves to `target`: T/(mu N) if `force` is true, otherwise delta/A. */
static void advance(struct loops *loops, double target, bool force) {
  if (force && fabs(target) > 1)
    target = fabs(target) > 1 + rounding ? NAN : copysign(1, target);
  if (target == (force ? loops->shear : loops->slip))
    return;
  loops->sheared = true;
  if (loops->capacity == 0) {
    advance_spring(loops, target, force);
    return;
  }
  const struct branch *branch = branch_to(loops, target, force);
  const double slides = force ? 0 : fabs(target - branch->slip) - branch->size;
  loops->shear = force ? target : shear_of(branch, target);
  loops->slip = force ? slip_of(branch, target) : target;
  loops->lost = lost_of(branch, loops->shear);
  loops->work = work_of(branch, loops->shear);
  if (slides > 0) { /* gross sliding: virgin loading up to the limit, from a shifted origin */
    const double sense = branch->sense;
    loops->lost += slides, loops->work += slides;
    loops->branches[0] = (struct branch){0, target - sense, 0, 0, sense, 1}; /* the only one that is left */
    set_energies(&loops->branches[0], sense, loops->lost, loops->work);
  }
}

static double stick_radius(const struct loops *loops) {
  if (loops->count == 0)
    return fabs(loops->shear) < 1 ? loops->radius : 0;
  const struct branch *top = &loops->branches[loops->count - 1];
  return loops->radius * cbrt(fmax(1 - fabs(loops->shear - top->shear) / top->size, 0));
}

enum { SLIP, SHEAR, STICK, LOST, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "radius.stick", "dissipated", "work.shear"};

/* False: the normal force decreases, or changes during or after shear. */
static bool walk_path(struct loops *loops, const struct path_contact *contact, const struct nb_scene *scene,
                      struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  for (size_t k = 1; path_next(&walk, now, &target); k++) {
    const double approach = target.normal_force ? path_overlap(contact, target.normal) : target.normal;
    if (fabs(approach - now.approach) > 1e-9 * now.approach) {
      if (loops->sheared || target.shear != 0 || approach < now.approach)
        return false;
      now.approach = approach, now.normal = path_normal(contact, approach);
      loops->radius = sqrt(contact->radius * approach);
      loops->limit = contact->friction * now.normal;
      loops->scale = 3 * loops->limit / (16 * contact->shear * loops->radius);
    }
    advance(loops, target.shear / (target.shear_force ? loops->limit : loops->scale), target.shear_force);
    now.shear = loops->shear * loops->limit, now.slip = loops->slip * loops->scale;
    const double joule = loops->limit * loops->scale;
    const double values[COLUMNS] = {now.slip, now.shear, stick_radius(loops), loops->lost * joule, loops->work * joule};
    for (int c = 0; c < COLUMNS; c++)
      columns[c]->values[k] = values[c];
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct path_contact contact = path_contact(scene);
  struct path_column *columns[COLUMNS];
  struct loops *loops = calloc(1, sizeof *loops);
  bool made = loops;
  const bool all = strcmp(scene->shear, "mindlin_deresiewicz") == 0, two = strcmp(scene->shear, "randall") == 0;
  if (loops)
    loops->capacity = all ? BRANCHES : two ? 3 : 0;
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
                        "the reference `mindlin_loops` is for a normal force that is constant once there is shear");
  return made ? solution_status(solution, error) : nb_error_memory(error);
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
