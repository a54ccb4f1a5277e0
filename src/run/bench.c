/* A contact on the bench, and one step of it, as a block's loop would make it (laws/law_batch.h): what does not touch
 * remembers nothing, and slip counts for the share of the step in which it touched.
 *
 * A leg of a path goes step by step: each side of the contact goes along a straight line from what it is to its aim. Where that is
 * a place, the step goes there. Where it is a force, the place is sought on copies of what the laws remember: the normal force
 * first, which does not ask about slip, then the shear force.
 *
 * A law's force never falls as the contact closes, nor as it slips on, so the place is found by halving an interval that holds
 * it until nothing is left to halve: the force is right to rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clock.h"
#include "core/hertz_impact.h"
#include "observe.h"

enum nb_status nb_bench_create(struct nb_bench *bench, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_body *bodies = scene->bodies;
  const bool wall = scene->body_count == 1;
  const double radius = bodies[0].radius;
  *bench = (struct nb_bench){
      .scene = scene, .normal = nb_law_find("normal", scene->normal), .shear = nb_law_find("shear", scene->shear)};
  bench->pair = nb_scene_pair(scene, bodies[0].material, wall ? scene->walls[0].material : bodies[1].material);
  bench->pair.radius = wall ? radius : nb_reduced_radius(radius, bodies[1].radius);
  bench->pair.pieces = nb_law_pieces(bench->shear, scene->pieces);
  bench->normal_doubles = nb_law_memory(bench->normal, bench->pair);
  bench->shear_doubles = nb_law_memory(bench->shear, bench->pair);
  for (int k = 0; k < 2; k++) {
    struct nb_bench_state *state = k ? &bench->trial : &bench->now;
    state->normal_memory = nb_own(&bench->owner, (size_t)bench->normal_doubles + NB_MEMORY, sizeof(double));
    state->shear_memory = nb_own(&bench->owner, (size_t)bench->shear_doubles + NB_MEMORY, sizeof(double));
  }
  if (!bench->owner.failed)
    return NB_OK;
  nb_bench_free(bench);
  return nb_error_memory(error);
}

void nb_bench_free(struct nb_bench *bench) {
  nb_owner_free(&bench->owner);
  bench->now = bench->trial = (struct nb_bench_state){0};
}

/* A row of memory is empty when its first double is 0; up to four doubles all are. */
static void forget(double *memory, int doubles) {
  memset(memory, 0, (doubles > NB_MEMORY ? 1 : (size_t)doubles) * sizeof *memory);
}

/* bench.trial: the contact as it would be after a straight step from bench.now to this place. */
static void try_step(struct nb_bench *bench, double approach, double slip) {
  const struct nb_bench_state *now = &bench->now;
  struct nb_bench_state *next = &bench->trial;
  memcpy(next->normal_memory, now->normal_memory, (size_t)bench->normal_doubles * sizeof(double));
  memcpy(next->shear_memory, now->shear_memory, (size_t)bench->shear_doubles * sizeof(double));
  next->approach = approach, next->slip = slip;

  const double overlap = approach > 0 ? approach : 0, closing = approach - now->approach;
  const bool touching = overlap > 0;
  if (!touching && bench->normal_doubles > NB_MEMORY)
    forget(next->normal_memory, bench->normal_doubles);
  next->n = bench->normal->normal(bench->pair, overlap, closing, next->normal_memory);
  next->n.overlap = overlap;
  next->s = (struct nb_shear){0};
  if (touching || bench->shear_doubles <= NB_MEMORY)
    next->s = bench->shear->shear(bench->pair, next->n, (slip - now->slip) * nb_touched(overlap, closing),
                                  next->shear_memory);
  if (!touching) {
    forget(next->normal_memory, bench->normal_doubles);
    forget(next->shear_memory, bench->shear_doubles);
  }
}

/* Makes the step that was tried last. */
static void make_step(struct nb_bench *bench) {
  const struct nb_bench_state before = bench->now, *after = &bench->trial;
  const double touched = nb_touched(after->n.overlap, after->approach - before.approach);
  bench->work_normal += (before.n.force + after->n.force) / 2 * (after->n.overlap - before.n.overlap);
  bench->work_shear += (before.s.force + after->s.force) / 2 * (after->slip - before.slip) * touched;
  bench->lost += bench->shear->loses ? after->s.lost : 0;
  bench->step++;
  bench->now = bench->trial;
  bench->trial = before;
}

/* ---- legs ---- */

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
    try_step(bench, side->approach, x);
  else
    try_step(bench, x, side->slip);
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

/* Where a leg begins and ends, in its own terms. */
struct leg {
  const struct nb_stage *stage;
  double normal_from, normal_to; /* m or N, as the aims say */
  double shear_from, shear_to;
};

static double end_of(const struct nb_aim *aim, double from) { return aim->by ? from + aim->value : aim->value; }

static struct leg leg_begin(const struct nb_bench *bench, const struct nb_stage *stage) {
  const struct nb_bench_state *now = &bench->now;
  const struct nb_leg *aims = &stage->leg;
  const double normal = aims->normal.force ? now->n.force : now->approach;
  const double shear = aims->shear.force ? now->s.force : now->slip;
  return (struct leg){stage, normal, end_of(&aims->normal, normal), shear, end_of(&aims->shear, shear)};
}

static enum nb_status unreachable(const struct nb_bench *bench, const struct nb_stage *stage, unsigned long step,
                                  bool shear, double target, double reached, struct nb_error *error) {
  const char *unit = bench->scene->unitless ? "" : " N";
  char limit[128] = "";
  if (shear)
    snprintf(limit, sizeof limit, "; friction times the normal force is %g%s",
             bench->pair.friction * bench->trial.n.force, unit);
  return nb_error_set(
      error, NB_BROKEN,
      "segment `%s` (line %d), step %lu of %lu: a %s force of %g%s cannot be reached, it comes to %g%s%s", stage->name,
      stage->line, step, stage->cycles, shear ? "shear" : "normal", target, unit, reached, unit, limit);
}

/* Step number `step` of the leg, from 1; NB_BROKEN when a force cannot be reached. */
static enum nb_status leg_step(struct nb_bench *bench, const struct leg *leg, unsigned long step,
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
  try_step(bench, approach, slip);
  if (!isfinite(bench->trial.n.force) || !isfinite(bench->trial.s.force))
    return nb_error_set(error, NB_BROKEN, "segment `%s` (line %d), step %lu: the force is not a number", stage->name,
                        stage->line, step);
  make_step(bench);
  return NB_OK;
}

/* ---- a path ---- */

static bool observe(struct nb_table *table, const struct nb_bench *bench, int stage) {
  double *row = nb_table_row(table, stage, (double)bench->step, 0);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_bench_value(bench->scene->columns[c].quantity, bench);
  return true;
}

static bool keep_snapshot(struct nb_result *result, const struct nb_bench *bench, int stage) {
  struct nb_snapshot *snapshot = NB_MORE(result->snapshots, result->snapshot_count);
  return snapshot && nb_bench_snapshot(snapshot, bench, stage);
}

static enum nb_status run_leg(struct nb_result *result, struct nb_bench *bench, int index, struct nb_error *error) {
  const struct nb_stage *stage = &bench->scene->stages[index];
  const struct leg leg = leg_begin(bench, stage);
  bool whole = true;
  for (unsigned long step = 1; step <= stage->cycles && whole; step++) {
    const enum nb_status status = leg_step(bench, &leg, step, error);
    if (status)
      return status;
    result->stage_cycles[index] = step;
    if (stage->record && (step % stage->record == 0 || step == stage->cycles))
      whole = observe(&result->table, bench, index);
  }
  if (whole && stage->snapshot)
    whole = keep_snapshot(result, bench, index);
  return whole ? NB_OK : nb_error_memory(error);
}

enum nb_status nb_bench_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_progress *progress,
                            struct nb_error *error) {
  struct nb_teller teller = nb_tell_begin(progress);
  struct nb_bench bench;
  *result = (struct nb_result){0};
  if (!nb_observe_begin(result, scene))
    return nb_error_memory(error);
  enum nb_status status = nb_bench_create(&bench, scene, error);
  if (status)
    return status;
  if (!observe(&result->table, &bench, 0))
    status = nb_error_memory(error);
  for (size_t s = 0; s < scene->stage_count && !status; s++) {
    status = run_leg(result, &bench, (int)s, error);
    nb_tell(&teller, scene->stages[s].name, (double)(s + 1) / (double)scene->stage_count);
  }
  result->cycles = result->updates = bench.step;
  result->seconds = nb_clock() - teller.began;
  nb_bench_free(&bench);
  return status;
}
