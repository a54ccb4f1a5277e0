/* Reference: free particles that interact only by contacts conserve their momentum.
 *
 *   p = sum m v                  for all laws and contact dashpots, because the two forces of a contact are opposite
 *   L = sum (m r x v + I w)      about the origin, with the position r and the angular velocity w; only without shear
 *                                forces, because with the moments F_s R of CS79 L' is F_s times the overlap
 *
 * Returns momentum.x, momentum.y and, with `shear none` and without a cell, momentum.angular, at any time; each also
 * with max, min and mean.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "reference.h"

static void add_value(struct nb_solution *solution, const char *what, double value) {
  static const char *const reducers[] = {"", " max", " min", " mean"};
  for (size_t k = 0; k < sizeof reducers / sizeof *reducers; k++) {
    char text[3 * NB_NAME_SIZE];
    snprintf(text, sizeof text, "momentum.%s%s", what, reducers[k]);
    solution_value(solution, value, text);
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  double x = 0, y = 0, angular = 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const double m = matter_mass(scene, particle);
    x += m * particle->vx, y += m * particle->vy;
    angular += m * (particle->x * particle->vy - particle->y * particle->vx) +
               matter_inertia(scene, particle) * particle->spin;
  }
  add_value(solution, "x", x), add_value(solution, "y", y);
  if (strcmp(scene->shear, "none") == 0 && !scene->cell.line) /* contacts across the edge of a cell change L */
    add_value(solution, "angular", angular);
  return solution_status(solution, error);
}

const struct nb_reference reference_momentum = {
    .name = "momentum",
    .title = "free particles conserve momentum; without shear forces also angular momentum",
    .source = "[CS79 20-23]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_CELL, HAS_CELL_STRAIN, HAS_FRICTION,
                HAS_COHESION, HAS_MEMORY, HAS_STIFFNESS_DAMPING, HAS_R89_FRACTION_DAMPING, HAS_RATIO_DAMPING,
                HAS_CRITICAL_DAMPING, HAS_UNTIL, HAS_STEP_CHANGE, HAS_DAMPING_CHANGE, HAS_MATERIAL_CHANGE},
    .normal = NB_ANY_LAW,
    .shear = NB_ANY_LAW,
    .solve = solve,
};
