/* Reference: the largest steps of a scene whose bodies touch.
 *
 * Known, of all pairs that touch, damped as in the first stage:
 *   step.single-contact   2 sqrt(m/k) of the lightest free body and the stiffest pair of materials            [CS79, Motion]
 *   step.stable       every contact by itself with its share of the masses, its six freedoms and their largest
 *                   eigenvalue
 *   step max        the largest step that the calculation cycle stands: what a page's own largest step is compared
 *                   with. The cycle as a matrix, its largest eigenvalue, halving until it leaves the circle: 1e-6
 *
 * The first two are exact. All three are for contacts that stay and do not slip, and that do not turn.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "limit.h"

/* Outlines closer than this share of the radius touch: a page writes centres in decimals. */
static const double touch = 1e-9;

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct limit limit;
  if (limit_build(&limit, scene, &scene->damping, touch * scene->particles[0].radius, error))
    return error->status;
  solution_value(solution, limit.critical, "step.single-contact");
  const double safe = limit_of_contacts(&limit, scene), longest = limit_of_cycle(&limit);
  solution_value(solution, safe, "step.stable");
  solution_value(solution, longest, "step max");
  limit_free(&limit);
  if (isnan(safe) || isnan(longest))
    return nb_error_set(error, NB_BAD_USE, "step_limit finds no step at which these springs and dashpots are stable");
  return solution_status(solution, error);
}

const struct nb_reference reference_step_limit = {
    .name = "step_limit",
    .title = "the longest step that touching bodies stand: eigenvalues of the calculation cycle",
    .source = "[CS79 20-23a, 26-28]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_WALLS, HAS_MOVING_WALLS, HAS_FRICTION,
                HAS_CONTACT_DAMPING, HAS_MASS_DAMPING, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
