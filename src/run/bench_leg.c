/* A leg of a path, step by step: each side of the contact goes along a straight line from what it is to its aim. Where that is
 * a place, the step goes there. Where it is a force, the place is sought on copies of what the laws remember: the normal force
 * first, which does not ask about slip, then the shear force.
 *
 * A law's force never falls as the contact closes, nor as it slips on, so the place is found by halving an interval that holds
 * it until nothing is left to halve: the force is right to rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bench.h"

static double smaller_radius(const struct nb_scene *scene) {
  const double a = scene->bodies[0].radius, b = scene->body_count > 1 ? scene->bodies[1].radius : a;
  return a < b ? a : b;
}

/* The side that is sought, and the place of the other one. */
struct side {
  bool shear;
  double approach, slip;
};

/* The force, were this side at x. */
static double force_at(struct nb_bench *bench, const struct side *side, double x) {
  if (side->shear)
    nb_bench_try(bench, side->approach, x);
  else
    nb_bench_try(bench, x, side->slip);
  return side->shear ? bench->trial.s.force : bench->trial.n.force;
}

/* Halves the interval from `near`, where the force has not come to `target`, to `beyond`, where it has. */
static double halve(struct nb_bench *bench, const struct side *side, double near, double beyond, double target,
                    double sense) {
  for (;;) {
    const double middle = near + (beyond - near) / 2;
    if (middle == near || middle == beyond)
      return beyond;
    if (sense * (force_at(bench, side, middle) - target) < 0)
      near = middle;
    else
      beyond = middle;
  }
}

/* The place nearest to `from` where the force has come to `target`; false: it never does, then *reached is as far as it comes.
 * A limit that is missed by rounding alone is reached. */
static bool seek(double *place, double *reached, struct nb_bench *bench, const struct side *side, double from,
                 double target) {
  static const double rounding = 1e-13;
  *reached = force_at(bench, side, from), *place = from;
  if (*reached == target)
    return true;
  const double sense = target > *reached ? 1 : -1;
  const double far = 2 * smaller_radius(bench->scene); /* what is farther is no contact */
  const double stiffness = side->shear ? bench->trial.s.stiffness : bench->trial.n.stiffness;
  double width = stiffness > 0 ? fabs(target - *reached) / stiffness : 0;
  width =
      width > 1e-12 * far && width < far ? width : 1e-12 * far; /* from some femtometres on, when nobody knows better */
  for (; sense * (*reached - target) < 0; width *= 2) {
    if (width > far && fabs(*reached - target) > rounding * fabs(target))
      return false;
    if (width > far)
      target = *reached;
    *place = from + sense * width;
    *reached = force_at(bench, side, *place);
  }
  *place = halve(bench, side, from, *place, target, sense);
  return true;
}

static double end_of(const struct nb_aim *aim, double from) { return aim->by ? from + aim->value : aim->value; }

struct nb_bench_leg nb_bench_leg_begin(const struct nb_bench *bench, const struct nb_stage *stage) {
  const struct nb_bench_state *now = &bench->now;
  const struct nb_leg *leg = &stage->leg;
  const double normal = leg->normal.force ? now->n.force : now->approach;
  const double shear = leg->shear.force ? now->s.force : now->slip;
  return (struct nb_bench_leg){stage, normal, end_of(&leg->normal, normal), shear, end_of(&leg->shear, shear)};
}

static enum nb_status unreachable(const struct nb_bench *bench, const struct nb_stage *stage, unsigned long step,
                                  bool shear, double target, double reached, struct nb_error *error) {
  const char *unit = bench->scene->unitless ? "" : " N";
  char limit[128] = "";
  if (shear)
    snprintf(limit, sizeof limit, "; friction times the normal force is %g%s",
             bench->pair.friction * bench->trial.n.force, unit);
  return nb_error_set(
      error, NB_BROKEN, "leg `%s` (line %d), step %lu of %lu: a %s force of %g%s cannot be reached, it comes to %g%s%s",
      stage->name, stage->line, step, stage->cycles, shear ? "shear" : "normal", target, unit, reached, unit, limit);
}

enum nb_status nb_bench_leg_step(struct nb_bench *bench, const struct nb_bench_leg *leg, unsigned long step,
                                 struct nb_error *error) {
  const struct nb_stage *stage = leg->stage;
  const double share = (double)step / (double)stage->cycles;
  const bool last = step == stage->cycles;
  const double normal = last ? leg->normal_to : leg->normal_from + (leg->normal_to - leg->normal_from) * share;
  const double shear = last ? leg->shear_to : leg->shear_from + (leg->shear_to - leg->shear_from) * share;
  const struct nb_bench_state now = bench->now;
  double approach = normal, slip = shear, reached;
  if (stage->leg.points) {
    approach = stage->leg.points[step - 1].approach;
    slip = stage->leg.points[step - 1].slip;
  }
  if (stage->leg.normal.force &&
      !seek(&approach, &reached, bench, &(struct side){.slip = now.slip}, now.approach, normal))
    return unreachable(bench, stage, step, false, normal, reached, error);
  if (stage->leg.shear.force &&
      !seek(&slip, &reached, bench, &(struct side){.shear = true, .approach = approach}, now.slip, shear))
    return unreachable(bench, stage, step, true, shear, reached, error);
  nb_bench_try(bench, approach, slip);
  if (!isfinite(bench->trial.n.force) || !isfinite(bench->trial.s.force))
    return nb_error_set(error, NB_BROKEN, "leg `%s` (line %d), step %lu: the force is not a number", stage->name,
                        stage->line, step);
  nb_bench_go(bench);
  return NB_OK;
}
