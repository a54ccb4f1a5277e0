/* Reference: what the method of time steps gains or loses in Hertz's impact, to the lowest order in the step,
 * from hertz_corner.h.
 *
 * Known: impact.restitution, impact.duration. Left out is the next order, n^(-5/2) of the duration and n^(-7/2) of the speed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "hertz.h"
#include "hertz_corner.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_of(&hertz, scene, "hertz_phase", error))
    return error->status;
  const double fraction = hertz.step / hertz.unit;
  const double sooner = hertz_sooner(fraction) * hertz.step;
  const double gained = hertz_gain(fraction, hertz.begin / hertz.step, hertz.duration / hertz.step);
  solution_value(solution, hertz.duration - sooner, "impact.duration");
  solution_value(solution, 1 + gained, "impact.restitution");
  return solution_full(solution, error);
}

const struct nb_reference reference_hertz_phase = {
    .name = "hertz_phase",
    .title = "Hertz's impact in steps: rebound and duration to the lowest order in the step, any phase of first touch",
    .source = "[R89 5.6]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
