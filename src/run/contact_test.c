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
#include "contact_test.h"

#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clock.h"
#include "core/hertz_impact.h"
#include "observe.h"

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

/* A row of memory is empty when its first double is 0; up to four doubles all are. */
static void forget(double *memory, int doubles) {
  memset(memory, 0, (doubles > NB_HISTORY ? 1 : (size_t)doubles) * sizeof *memory);
}

/* bench.trial: the contact as it would be after a straight step from bench.now to this place. */
static void try_step(struct nb_contact_test *contact_test, double approach, double slip) {
  const struct nb_contact_test_state *now = &contact_test->now;
  struct nb_contact_test_state *next = &contact_test->trial;
  memcpy(next->normal_history, now->normal_history, (size_t)contact_test->normal_doubles * sizeof(double));
  memcpy(next->shear_history, now->shear_history, (size_t)contact_test->shear_doubles * sizeof(double));
  next->approach = approach, next->slip = slip;

  const double overlap = approach > 0 ? approach : 0, dn = approach - now->approach;
  const bool touching = overlap > 0;
  if (!touching && contact_test->normal_doubles > NB_HISTORY)
    forget(next->normal_history, contact_test->normal_doubles);
  next->n = contact_test->normal->normal(contact_test->pair, overlap, dn, next->normal_history);
  next->n.overlap = overlap;
  next->s = (struct nb_shear){0};
  if (touching || contact_test->shear_doubles <= NB_HISTORY)
    next->s = contact_test->shear->shear(contact_test->pair, next->n,
                                         (slip - now->slip) * nb_touch_fraction(overlap, dn), next->shear_history);
  if (!touching) {
    forget(next->normal_history, contact_test->normal_doubles);
    forget(next->shear_history, contact_test->shear_doubles);
  }
}

/* Makes the step that was tried last. */
static void make_step(struct nb_contact_test *contact_test) {
  const struct nb_contact_test_state before = contact_test->now, *after = &contact_test->trial;
  const double touched = nb_touch_fraction(after->n.overlap, after->approach - before.approach);
  contact_test->work_normal += (before.n.force + after->n.force) / 2 * (after->n.overlap - before.n.overlap);
  contact_test->work_shear += (before.s.force + after->s.force) / 2 * (after->slip - before.slip) * touched;
  contact_test->dissipated += contact_test->shear->dissipative ? after->s.dissipated : 0;
  contact_test->step++;
  contact_test->now = contact_test->trial;
  contact_test->trial = before;
}

/* ---- legs ---- */

static double smaller_radius(const struct nb_scene *scene) {
  const double a = scene->particles[0].radius, b = scene->particle_count > 1 ? scene->particles[1].radius : a;
  return a < b ? a : b;
}

/* The side that is sought, and the place of the other one. */
struct side {
  bool shear;
  double approach, slip;
};

/* The force, were this side at x. */
static double force_at(struct nb_contact_test *contact_test, const struct side *side, double x) {
  if (side->shear)
    try_step(contact_test, side->approach, x);
  else
    try_step(contact_test, x, side->slip);
  return side->shear ? contact_test->trial.s.force : contact_test->trial.n.force;
}

/* Halves the interval from `near`, where the force has not come to `target`, to `beyond`, where it has. */
static double halve(struct nb_contact_test *contact_test, const struct side *side, double near, double beyond,
                    double target, double sense) {
  for (;;) {
    const double middle = near + (beyond - near) / 2;
    if (middle == near || middle == beyond)
      return beyond;
    if (sense * (force_at(contact_test, side, middle) - target) < 0)
      near = middle;
    else
      beyond = middle;
  }
}

/* The place nearest to `from` where the force has come to `target`; false: it never does, then *reached is as far as it comes.
 * A limit that is missed by rounding alone is reached. */
static bool seek(double *place, double *reached, struct nb_contact_test *contact_test, const struct side *side,
                 double from, double target) {
  static const double rounding = 1e-13;
  *reached = force_at(contact_test, side, from), *place = from;
  if (*reached == target)
    return true;
  const double sense = target > *reached ? 1 : -1;
  const double far = 2 * smaller_radius(contact_test->scene); /* what is farther is no contact */
  const double stiffness = side->shear ? contact_test->trial.s.stiffness : contact_test->trial.n.stiffness;
  double width = stiffness > 0 ? fabs(target - *reached) / stiffness : 0;
  width =
      width > 1e-12 * far && width < far ? width : 1e-12 * far; /* from some femtometres on, when nobody knows better */
  for (; sense * (*reached - target) < 0; width *= 2) {
    if (width > far && fabs(*reached - target) > rounding * fabs(target))
      return false;
    if (width > far)
      target = *reached;
    *place = from + sense * width;
    *reached = force_at(contact_test, side, *place);
  }
  *place = halve(contact_test, side, from, *place, target, sense);
  return true;
}

/* Where a leg begins and ends, in its own terms. */
struct segment {
  const struct nb_stage *stage;
  double normal_from, normal_to; /* m or N, as the aims say */
  double shear_from, shear_to;
};

static double end_of(const struct nb_target *aim, double from) { return aim->by ? from + aim->value : aim->value; }

static struct segment segment_begin(const struct nb_contact_test *contact_test, const struct nb_stage *stage) {
  const struct nb_contact_test_state *now = &contact_test->now;
  const struct nb_segment *aims = &stage->segment;
  const double normal = aims->normal.force ? now->n.force : now->approach;
  const double shear = aims->shear.force ? now->s.force : now->slip;
  return (struct segment){stage, normal, end_of(&aims->normal, normal), shear, end_of(&aims->shear, shear)};
}

static enum nb_status unreachable(const struct nb_contact_test *contact_test, const struct nb_stage *stage,
                                  unsigned long step, bool shear, double target, double reached,
                                  struct nb_error *error) {
  const char *unit = contact_test->scene->unitless ? "" : " N";
  char limit[128] = "";
  if (shear)
    snprintf(limit, sizeof limit, "; friction times the normal force is %g%s",
             contact_test->pair.friction * contact_test->trial.n.force, unit);
  return nb_error_set(
      error, NB_BROKEN,
      "segment `%s` (line %d), step %lu of %lu: a %s force of %g%s cannot be reached, it comes to %g%s%s", stage->name,
      stage->line, step, stage->cycles, shear ? "shear" : "normal", target, unit, reached, unit, limit);
}

/* Step number `step` of the leg, from 1; NB_BROKEN when a force cannot be reached. */
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
      !seek(&approach, &reached, contact_test, &(struct side){.slip = now.slip}, now.approach, normal))
    return unreachable(contact_test, stage, step, false, normal, reached, error);
  if (stage->segment.shear.force &&
      !seek(&slip, &reached, contact_test, &(struct side){.shear = true, .approach = approach}, now.slip, shear))
    return unreachable(contact_test, stage, step, true, shear, reached, error);
  try_step(contact_test, approach, slip);
  if (!isfinite(contact_test->trial.n.force) || !isfinite(contact_test->trial.s.force))
    return nb_error_set(error, NB_BROKEN, "segment `%s` (line %d), step %lu: the force is not a number", stage->name,
                        stage->line, step);
  make_step(contact_test);
  return NB_OK;
}

/* ---- a path ---- */

static bool observe(struct nb_table *table, const struct nb_contact_test *contact_test, int stage) {
  double *row = nb_table_row(table, stage, (double)contact_test->step, 0);
  if (!row)
    return false;
  for (size_t c = 0; c < table->column_count; c++)
    row[c] = nb_contact_test_value(contact_test->scene->columns[c].quantity, contact_test);
  return true;
}

static bool keep_snapshot(struct nb_result *result, const struct nb_contact_test *contact_test, int stage) {
  struct nb_snapshot *snapshot = NB_ARRAY_APPEND(result->snapshots, result->snapshot_count);
  return snapshot && nb_contact_test_snapshot(snapshot, contact_test, stage);
}

static enum nb_status run_segment(struct nb_result *result, struct nb_contact_test *contact_test, int index,
                                  struct nb_error *error) {
  const struct nb_stage *stage = &contact_test->scene->stages[index];
  const struct segment segment = segment_begin(contact_test, stage);
  bool whole = true;
  for (unsigned long step = 1; step <= stage->cycles && whole; step++) {
    const enum nb_status status = segment_step(contact_test, &segment, step, error);
    if (status)
      return status;
    result->stage_cycles[index] = step;
    if (stage->record_interval && (step % stage->record_interval == 0 || step == stage->cycles))
      whole = observe(&result->table, contact_test, index);
  }
  if (whole && stage->snapshot)
    whole = keep_snapshot(result, contact_test, index);
  return whole ? NB_OK : nb_error_memory(error);
}

enum nb_status nb_contact_test_run(struct nb_result *result, const struct nb_scene *scene,
                                   const struct nb_progress *progress, struct nb_error *error) {
  struct nb_teller teller = nb_tell_begin(progress);
  struct nb_contact_test contact_test;
  *result = (struct nb_result){0};
  if (!nb_observe_begin(result, scene))
    return nb_error_memory(error);
  enum nb_status status = nb_contact_test_create(&contact_test, scene, error);
  if (status)
    return status;
  if (!observe(&result->table, &contact_test, 0))
    status = nb_error_memory(error);
  for (size_t s = 0; s < scene->stage_count && !status; s++) {
    status = run_segment(result, &contact_test, (int)s, error);
    nb_tell(&teller, scene->stages[s].name, (double)(s + 1) / (double)scene->stage_count);
  }
  result->cycles = result->updates = contact_test.step;
  result->seconds = nb_clock() - teller.began;
  nb_contact_test_free(&contact_test);
  return status;
}
