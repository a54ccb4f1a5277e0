/* Reference: the error of the time steps in Hertz's impact, to the lowest order in the step, from hertz_corner.h.
 *
 * Returns impact.restitution and impact.duration.
 * Error, relative: the next order, n^(-5/2) for the duration and n^(-7/2) for the restitution, with n steps per
 * collision.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "hertz.h"
#include "hertz_corner.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_read(&hertz, scene, "hertz_phase", error))
    return error->status;
  const double fraction = hertz.step / hertz.unit;
  const double shortening = hertz_shortening(fraction) * hertz.step;
  const double error_of_e = hertz_restitution_error(fraction, hertz.begin / hertz.step, hertz.duration / hertz.step);
  solution_value(solution, hertz.duration - shortening, "impact.duration");
  solution_value(solution, 1 + error_of_e, "impact.restitution");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_phase = {
    .name = "hertz_phase",
    .title =
        "Hertz's impact in steps: restitution and duration to the lowest order in the step, any phase of first contact",
    .source = "[R89 5.6]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
