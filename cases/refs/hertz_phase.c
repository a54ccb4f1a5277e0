/* Reference: what the method of time steps gains or loses in Hertz's impact, to the lowest order in the step,
 * from hertz_corner.h.
 *
 * Known: impact.restitution, impact.duration. Left out is the next order, n^(-5/2) of the duration and n^(-7/2) of the speed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "hertz.h"
#include "hertz_corner.h"

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  struct hertz hertz;
  if (hertz_of(&hertz, scene, "hertz_phase", error))
    return error->status;
  const double share = hertz.step / hertz.unit;
  const double sooner = hertz_sooner(share) * hertz.step;
  const double gained = hertz_gain(share, hertz.begin / hertz.step, hertz.duration / hertz.step);
  known_value(known, hertz.duration - sooner, "impact.duration");
  known_value(known, 1 + gained, "impact.restitution");
  return known_full(known, error);
}

const struct nb_reference reference_hertz_phase = {
    .name = "hertz_phase",
    .title = "Hertz's impact in steps: rebound and duration to the lowest order in the step, any phase of first touch",
    .source = "[R89 5.6]",
    .accepts = {HAS_SPHERES, HAS_FIXED_BODIES, HAS_VELOCITIES, HAS_IMPACT, HAS_WALLS, HAS_MOVING_WALLS, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .know = know,
};
