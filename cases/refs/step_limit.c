/* Reference: the stability limits of the time step in a scene with contacts.
 *
 * Returns, for all pairs in contact, with the damping of the scene:
 *   step.single-contact  2 sqrt(m/k) of the lightest free particle and the stiffest pair of materials [CS79, Motion]
 *   step.stable          the smallest limit of any contact alone, which gets a part of the mass of its particles
 *                        (limit.h): from the largest eigenvalue of its six degrees of freedom
 *   step max             the stability limit of the calculation cycle; a page compares its own largest step with it.
 *                        By bisection of the spectral radius of the cycle as a matrix; relative error 1e-6
 * The first two are exact. All three are for contacts that neither open nor slide nor rotate.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "limit.h"

/* Gap over radius below which there is a contact: pages round coordinates to decimals. */
static const double touch = 1e-9;

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct limit limit;
  if (limit_build(&limit, scene, &scene->damping, touch * scene->particles[0].radius, error))
    return error->status;
  solution_value(solution, limit.single_contact, "step.single-contact");
  const double stable = limit_of_contacts(&limit, scene), longest = limit_of_cycle(&limit);
  solution_value(solution, stable, "step.stable");
  solution_value(solution, longest, "step max");
  limit_free(&limit);
  if (isnan(stable) || isnan(longest))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `step_limit` finds no step at which these springs and dashpots are stable");
  return solution_status(solution, error);
}

const struct nb_reference reference_step_limit = {
    .name = "step_limit",
    .title = "stability limits of the time step for particles in contact: eigenvalues of the calculation cycle",
    .source = "[CS79 20-23a, 26-28]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_WALLS, HAS_MOVING_WALLS, HAS_FRICTION,
                HAS_CONTACT_DAMPING, HAS_MASS_DAMPING, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
