/* Reference: R89's FRACC of one disc that swings between two walls which both press on it.
 *
 * With w^2 = 2 k_n/m and h = w dt/2 the cycle is  x_(n+1) = 2 x_n - x_(n-1) - 4 h^2 x_n,  x_1 = x_0 (1 - 2 h^2)  from rest,
 * and with the sum of forces -2 k_n x [R89 4.36-4.40]
 *
 *   FRACC = h (| |x_(n+1)| - |x_n| | / |x_(n+1) - x_n|)^(1/2)
 *
 * which is h while x keeps its sign. Where h > 1 the swing goes over to x_(n+1) = -g x_n with g = (h + (h^2 - 1)^(1/2))^2, and
 *
 *   FRACC = (h (h^2 - 1)^(1/2))^(1/2)
 *
 * Known    step.fracc max, and D.x max of the disc if it is watched as D, by the cycle.
 * Exact but for rounding.
 * Range    one disc amid two walls across x, linear springs, no shear, no damping, a step in s, one stage.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *stage = &scene->stages[0];
  if (scene->body_count != 1 || scene->wall_count != 2 || strcmp(scene->normal, "linear") ||
      strcmp(scene->shear, "none") || stage->step.kind != NB_STEP_CRITICAL || scene->stage_count != 1 ||
      stage->condition_count || !nb_damping_none(&stage->damping))
    return nb_error_set(error, NB_BAD_USE,
                        "reference fracc is for one disc between two walls, undamped, `step F of critical`");
  const double h = stage->step.value * sqrt(2); /* two springs: w^2 = 2 k/m */
  double before = 1, x = 1 - 2 * h * h, far = fmax(1, x), most = h * sqrt(fabs(fabs(x) - 1) / fabs(x - 1));
  for (unsigned long n = 1; n < stage->cycles; n++) {
    const double next = 2 * x - before - 4 * h * h * x;
    before = x, x = next, far = fmax(far, x);
    most = fmax(most, h * sqrt(fabs(fabs(x) - fabs(before)) / fabs(x - before)));
  }
  known_value(known, most, "step.fracc max");
  known_value(known, far * scene->bodies[0].x, "D.x max");
  return known_full(known, error);
}

const struct nb_reference reference_fracc = {
    .name = "fracc",
    .title = "FRACC of a disc that swings between two walls, by the cycle itself",
    .source = "[R89 4.35-4.40]",
    .know = know,
};
