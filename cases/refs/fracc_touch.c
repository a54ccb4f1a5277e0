/* Reference: R89's FRACC of a disc at rest that an equal disc strikes head-on, with the velocity v along x.
 *
 * FRACC is the time step over a critical step that R89 estimates from the change of the force on each particle.
 *
 * The first force F_1 = k a_1 acts on a disc that has not moved yet; FRACC is defined as 0 as long as a disc has no
 * displacement. In the next step the disc moves by F_1 dt^2/m while the force grows to
 *
 *   F_2 = k (a_1 + (v - 2 F_1 dt/m) dt),      FRACC = (1/2) (|F_2 - F_1|/F_1)^(1/2)                     [R89 4.36-4.40]
 *
 * with the mass m and the stiffness k. This is the largest value for both discs during the contact if the step is
 * short. a_1 is the overlap after the smallest number of steps that closes the gap.
 *
 * Returns step.fracc max.
 * Accepts two equal discs, the second at rest, linear springs, no damping, `step F of single-contact`, and a run that
 * is long enough for two forces. Error: rounding of a_1.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *a = &scene->particles[0], *b = &scene->particles[1];
  if (scene->particle_count != 2 || a->vx <= 0 || b->vx != 0 || a->material != b->material || a->radius < b->radius ||
      a->radius > b->radius || a->vy != 0 || b->vy != 0 || a->y != b->y || scene->step.kind != NB_STEP_SINGLE_CONTACT)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `fracc_touch` is for two equal discs, the first of which strikes the second "
                        "head-on along x, and for `step F of single-contact`");
  const double mass = matter_mass(scene, a), k = matter_pair(scene, a->material, b->material).kn;
  const double step = scene->step.value * 2 * sqrt(mass / k), gap = b->x - a->x - a->radius - b->radius;
  const double steps = floor(gap / (a->vx * step)) + 1, first = steps * a->vx * step - gap;
  double cycles = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    cycles += (double)scene->stages[s].cycles;
  if (!(gap >= 0) || cycles < steps + 1)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `fracc_touch` is for discs that touch in the run, and not before it");
  const double growth = (a->vx - 2 * k * first * step / mass) * step;
  solution_value(solution, sqrt(fabs(growth) / first) / 2, "step.fracc max");
  return solution_status(solution, error);
}

const struct nb_reference reference_fracc_touch = {
    .name = "fracc_touch",
    .title = "FRACC of a disc hit by another one, from the first two forces",
    .source = "[R89 4.35-4.40]",
    .accepts = {HAS_DISCS, HAS_VELOCITIES},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
