/* A contact on the bench, and one step of it, as a block's loop would make it (laws/law_batch.h): what does not touch
 * remembers nothing, and slip counts for the share of the step in which it touched.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bench.h"
#include "core/hertz_impact.h"

#include <stdlib.h>
#include <string.h>

static bool make_memory(struct nb_bench_state *state, const struct nb_bench *bench) {
  state->normal_memory = calloc((size_t)bench->normal_doubles + NB_MEMORY, sizeof(double));
  state->shear_memory = calloc((size_t)bench->shear_doubles + NB_MEMORY, sizeof(double));
  return state->normal_memory && state->shear_memory;
}

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
  if (make_memory(&bench->now, bench) && make_memory(&bench->trial, bench))
    return NB_OK;
  nb_bench_free(bench);
  return nb_error_memory(error);
}

void nb_bench_free(struct nb_bench *bench) {
  free(bench->now.normal_memory), free(bench->now.shear_memory);
  free(bench->trial.normal_memory), free(bench->trial.shear_memory);
  bench->now = bench->trial = (struct nb_bench_state){0};
}

/* A row of memory is empty when its first double is 0; up to four doubles all are. */
static void forget(double *memory, int doubles) {
  memset(memory, 0, (doubles > NB_MEMORY ? 1 : (size_t)doubles) * sizeof *memory);
}

void nb_bench_try(struct nb_bench *bench, double approach, double slip) {
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

void nb_bench_go(struct nb_bench *bench) {
  const struct nb_bench_state before = bench->now, *after = &bench->trial;
  const double touched = nb_touched(after->n.overlap, after->approach - before.approach);
  bench->work_normal += (before.n.force + after->n.force) / 2 * (after->n.overlap - before.n.overlap);
  bench->work_shear += (before.s.force + after->s.force) / 2 * (after->slip - before.slip) * touched;
  bench->lost += bench->shear->loses ? after->s.lost : 0;
  bench->step++;
  bench->now = bench->trial;
  bench->trial = before;
}
