/* A contact test: one contact whose approach and tangential displacement, or whose forces, are prescribed.
 *
 * A step calls the laws as the loop over a block of contacts does (laws/law_batch.h): an open contact has no history,
 * and the tangential increment counts only for the fraction of the step in which the contact is closed.
 *
 * A segment has two components, normal and tangential. In the steps of the segment each component goes linearly from
 * its current value to its target, which is a displacement or a force. With `follow` the file gives the two
 * displacements of each step instead. For a force, the displacement is found by trial steps on copies of the contact
 * history: first for the normal force, which does not depend on the tangential displacement, then for the shear force.
 *
 * With most laws the force never decreases as the approach or the tangential displacement grows, so bisection down to
 * adjacent doubles finds the displacement. The force is then exact to rounding. With `randall` and `randall_literal`
 * the shear force jumps down where the slip factor drops; bisection then finds one of the displacements with the given
 * force.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "contact_test.h"

#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clock.h"
#include "core/hertz_impact.h"
#include "restart.h"
#include "result.h"

enum nb_status nb_contact_test_create(struct nb_contact_test *contact_test, const struct nb_scene *scene,
                                      struct nb_error *error) {
  const struct nb_particle *particles = scene->particles;
  const bool wall = scene->particle_count == 1;
  const double radius = particles[0].radius;
  *contact_test = (struct nb_contact_test){
      .scene = scene, .normal = nb_law_find("normal", scene->normal), .shear = nb_law_find("shear", scene->shear)};
  contact_test->pair =
      nb_scene_pair(scene, particles[0].material, wall ? scene->walls[0].material : particles[1].material);
  contact_test->pair.radius = wall ? radius : nb_reduced_radius(radius, particles[1].radius);
  contact_test->pair.pieces = nb_law_pieces(contact_test->shear, scene->pieces);
  contact_test->normal_doubles = nb_law_history(contact_test->normal, contact_test->pair);
  contact_test->shear_doubles = nb_law_history(contact_test->shear, contact_test->pair);
  for (int k = 0; k < 2; k++) {
    struct nb_contact_test_state *state = k ? &contact_test->trial : &contact_test->now;
    state->normal_history =
        nb_own(&contact_test->owner, (size_t)contact_test->normal_doubles + NB_HISTORY, sizeof(double));
    state->shear_history =
        nb_own(&contact_test->owner, (size_t)contact_test->shear_doubles + NB_HISTORY, sizeof(double));
  }
  if (!contact_test->owner.failed)
    return NB_OK;
  nb_contact_test_free(contact_test);
  return nb_error_memory(error);
}

void nb_contact_test_free(struct nb_contact_test *contact_test) {
  nb_owner_free(&contact_test->owner);
  contact_test->now = contact_test->trial = (struct nb_contact_test_state){0};
}

/* Computes contact_test->trial: the contact after a step from contact_test->now to this approach and slip, in m. */
static void try_step(struct nb_contact_test *contact_test, double approach, double slip) {
  const struct nb_contact_test_state *now = &contact_test->now;
  struct nb_contact_test_state *next = &contact_test->trial;
  memcpy(next->normal_history, now->normal_history, (size_t)contact_test->normal_doubles * sizeof(double));
  memcpy(next->shear_history, now->shear_history, (size_t)contact_test->shear_doubles * sizeof(double));
  next->approach = approach, next->slip = slip;
  nb_rounding_begin(&contact_test->rounding, "step");

  const double overlap = approach > 0 ? approach : 0, dn = approach - now->approach;
  const bool touching = overlap > 0;
  next->n = contact_test->normal->normal(contact_test->pair, overlap, dn, next->normal_history);
  next->n.overlap = overlap;
  next->s = (struct nb_shear){0};
  if (touching)
    next->s = contact_test->shear->shear(contact_test->pair, next->n,
                                         (slip - now->slip) * nb_touch_fraction(overlap, dn), next->shear_history);
  if (!touching) {
    memset(next->normal_history, 0, (size_t)contact_test->normal_doubles * sizeof(double));
    memset(next->shear_history, 0, (size_t)contact_test->shear_doubles * sizeof(double));
  }
  nb_rounding_begin(&contact_test->rounding, NULL);
}

/* Accepts the last trial step. */
static void accept_step(struct nb_contact_test *contact_test) {
  const struct nb_contact_test_state before = contact_test->now, *after = &contact_test->trial;
  nb_rounding_begin(&contact_test->rounding, "step");
  const double fraction = nb_touch_fraction(after->n.overlap, after->approach - before.approach);
  contact_test->work_normal += (before.n.force + after->n.force) / 2 * (after->n.overlap - before.n.overlap);
  contact_test->work_shear += (before.s.force + after->s.force) / 2 * (after->slip - before.slip) * fraction;
  contact_test->dissipated += after->s.dissipated; /* 0 with laws that are not dissipative */
  nb_rounding_begin(&contact_test->rounding, NULL);
  contact_test->step++;
  contact_test->now = contact_test->trial;
  contact_test->trial = before;
}

/* ---- segments ---- */

static double smaller_radius(const struct nb_scene *scene) {
  const double a = scene->particles[0].radius, b = scene->particle_count > 1 ? scene->particles[1].radius : a;
  return a < b ? a : b;
}

/* The displacement that is sought, and the given value of the other one, m. */
struct unknown {
  bool shear;            /* true: the tangential displacement is sought; false: the normal one */
  double approach, slip; /* the value of the given displacement; the value of the other one is not used */
};

/* The force, N, if the displacement that is sought is x, m. */
static double force_at(struct nb_contact_test *contact_test, const struct unknown *unknown, double x) {
  if (unknown->shear)
    try_step(contact_test, unknown->approach, x);
  else
    try_step(contact_test, x, unknown->slip);
  return unknown->shear ? contact_test->trial.s.force : contact_test->trial.n.force;
}

/* Bisects the interval from `before`, where the force has not reached `target`, to `after`, where it has; `sign` is 1
 * if the force increases in this direction, else -1. Returns the displacement nearest to `before` at which the force
 * has reached the target, m. */
static double bisect(struct nb_contact_test *contact_test, const struct unknown *unknown, double before, double after,
                     double target, double sign) {
  for (;;) {
    const double midpoint = before + (after - before) / 2;
    if (midpoint == before || midpoint == after)
      return after;
    if (sign * (force_at(contact_test, unknown, midpoint) - target) < 0)
      before = midpoint;
    else
      after = midpoint;
  }
}

/* Sets *place to the displacement nearest to `from`, m, at which the force reaches `target`, N. Returns false if the
 * force does not reach the target within a change of the displacement by twice the smaller radius; *reached is then the
 * force at the last displacement tried. A force that misses the target only by rounding counts as reached. */
static bool find_displacement(double *place, double *reached, struct nb_contact_test *contact_test,
                              const struct unknown *unknown, double from, double target) {
  static const double rounding = 1e-13;
  *reached = force_at(contact_test, unknown, from), *place = from;
  if (*reached == target)
    return true;
  const double sign = target > *reached ? 1 : -1;
  const double largest = 2 * smaller_radius(contact_test->scene); /* limit of the change of the displacement, m */
  const double stiffness = unknown->shear ? contact_test->trial.s.stiffness : contact_test->trial.n.stiffness;
  double width = stiffness > 0 ? fabs(target - *reached) / stiffness : 0;
  if (!(width > 1e-12 * largest && width < largest))
    width = 1e-12 * largest; /* the stiffness gives no usable estimate */
  for (; sign * (*reached - target) < 0; width *= 2) {
    if (width > largest && fabs(*reached - target) > rounding * fabs(target))
      return false;
    if (width > largest)
      target = *reached;
    *place = from + sign * width;
    *reached = force_at(contact_test, unknown, *place);
  }
  *place = bisect(contact_test, unknown, from, *place, target, sign);
  return true;
}

/* Start and end of a segment. */
struct segment {
  const struct nb_stage *stage;
  double normal_from, normal_to; /* m or N, depending on the target */
  double shear_from, shear_to;
};

static double target_value(const struct nb_target *target, double from) {
  return target->relative ? from + target->value : target->value;
}

static struct segment segment_begin(const struct nb_contact_test *contact_test, const struct nb_stage *stage) {
  const struct nb_contact_test_state *now = &contact_test->now;
  const struct nb_segment *targets = &stage->segment;
  const double normal = targets->normal.force ? now->n.force : now->approach;
  const double shear = targets->shear.force ? now->s.force : now->slip;
  return (struct segment){stage, normal, target_value(&targets->normal, normal), shear,
                          target_value(&targets->shear, shear)};
}

static enum nb_status force_unreachable(const struct nb_contact_test *contact_test, const struct nb_stage *stage,
                                        unsigned long step, bool shear, double target, double reached,
                                        struct nb_error *error) {
  const char *unit = contact_test->scene->unitless ? "" : " N";
  char limit[128] = "";
  if (shear)
    snprintf(limit, sizeof limit, "; friction times the normal force, plus cohesion, is %g%s",
             contact_test->pair.friction * contact_test->trial.n.force + contact_test->pair.cohesion, unit);
  return nb_error_set(
      error, NB_BROKEN,
      "segment `%s` (line %d), step %lu of %lu: a %s force of %g%s cannot be reached; the force is %g%s%s", stage->name,
      stage->line, step, stage->cycles, shear ? "shear" : "normal", target, unit, reached, unit, limit);
}

/* Runs step number `step` of the segment, from 1. NB_BROKEN when a force cannot be reached or is not finite. */
static enum nb_status segment_step(struct nb_contact_test *contact_test, const struct segment *segment,
                                   unsigned long step, struct nb_error *error) {
  const struct nb_stage *stage = segment->stage;
  const double fraction = (double)step / (double)stage->cycles;
  const bool last = step == stage->cycles;
  const double normal =
      last ? segment->normal_to : segment->normal_from + (segment->normal_to - segment->normal_from) * fraction;
  const double shear =
      last ? segment->shear_to : segment->shear_from + (segment->shear_to - segment->shear_from) * fraction;
  const struct nb_contact_test_state now = contact_test->now;
  double approach = normal, slip = shear, reached;
  if (stage->segment.points) {
    approach = stage->segment.points[step - 1].approach;
    slip = stage->segment.points[step - 1].slip;
  }
  if (stage->segment.normal.force &&
      !find_displacement(&approach, &reached, contact_test, &(struct unknown){.slip = now.slip}, now.approach, normal))
    return force_unreachable(contact_test, stage, step, false, normal, reached, error);
  if (stage->segment.shear.force &&
      !find_displacement(&slip, &reached, contact_test, &(struct unknown){.shear = true, .approach = approach},
                         now.slip, shear))
    return force_unreachable(contact_test, stage, step, true, shear, reached, error);
  try_step(contact_test, approach, slip);
  if (!isfinite(contact_test->trial.n.force) || !isfinite(contact_test->trial.s.force))
    return nb_error_set(error, NB_BROKEN, "segment `%s` (line %d), step %lu: the force is NaN or infinite", stage->name,
                        stage->line, step);
  accept_step(contact_test);
  return NB_OK;
}

/* ---- the whole test ---- */

static bool add_row(struct nb_table *table, const struct nb_contact_test *contact_test, int stage) {
  double *row = nb_table_row(table, stage, (double)contact_test->step, 0);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_contact_test_value(contact_test->scene->columns[c].quantity, contact_test);
  return true;
}

static bool add_snapshot(struct nb_result *result, const struct nb_contact_test *contact_test, int stage) {
  struct nb_snapshot *snapshot = NB_ARRAY_APPEND(result->snapshots, result->snapshot_count);
  return snapshot && nb_contact_test_snapshot(snapshot, contact_test, stage);
}

static enum nb_status run_segment(struct nb_result *result, struct nb_contact_test *contact_test, int index,
                                  struct nb_reporter *reporter, struct nb_error *error) {
  const struct nb_stage *stage = &contact_test->scene->stages[index];
  const struct segment segment = segment_begin(contact_test, stage);
  struct nb_stage_cost *cost = &result->stages[index];
  const double segments = (double)contact_test->scene->stage_count;
  bool stored = true, goes_on = true;
  reporter->stage_began = nb_processor_clock();
  for (unsigned long step = 1; step <= stage->cycles && stored && goes_on; step++) {
    const enum nb_status status = segment_step(contact_test, &segment, step, error);
    if (status)
      return status;
    cost->cycles = step, cost->updates = step;
    if (contact_test->stop && *contact_test->stop)
      return nb_error_set(error, NB_BROKEN,
                          "stopped by a signal after step %lu; a contact test cannot be continued, so run it again",
                          contact_test->step);
    if (stage->record_interval && (step % stage->record_interval == 0 || step == stage->cycles))
      stored = add_row(&result->table, contact_test, index);
    goes_on = nb_reporter_update(reporter, stage->name, (index + (double)step / (double)stage->cycles) / segments);
  }
  result->shortened = result->shortened || cost->cycles < stage->cycles;
  cost->seconds = nb_processor_clock() - reporter->stage_began;
  if (stored && stage->snapshot)
    stored = add_snapshot(result, contact_test, index);
  return stored ? NB_OK : nb_error_memory(error);
}

enum nb_status nb_contact_test_run(struct nb_result *result, const struct nb_scene *scene,
                                   const struct nb_options *options, const struct nb_progress *progress,
                                   struct nb_error *error) {
  struct nb_reporter reporter = nb_reporter_begin(progress);
  struct nb_contact_test contact_test;
  *result = (struct nb_result){0};
  if (!nb_result_begin(result, scene))
    return nb_error_memory(error);
  enum nb_status status = nb_contact_test_create(&contact_test, scene, error);
  if (status)
    return status;
  if (options && options->checkpoint.seconds > 0)
    nb_note(progress, "a contact test has no checkpoints, because it takes seconds");
  if (options)
    contact_test.rounding = options->rounding, contact_test.stop = options->checkpoint.stop;
  if (!add_row(&result->table, &contact_test, 0))
    status = nb_error_memory(error);
  for (size_t s = 0; s < scene->stage_count && !status; s++)
    status = run_segment(result, &contact_test, (int)s, &reporter, error);
  result->cycles = result->updates = contact_test.step;
  result->seconds = nb_clock() - reporter.began;
  nb_contact_test_free(&contact_test);
  return status;
}
