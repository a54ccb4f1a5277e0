/* Reference: free bodies that only touch each other keep their momentum.
 *
 *   p = sum m v         whatever the laws and the dashpots at contacts are: forces come in opposite pairs
 *   L = sum (m x x v + I w), about the origin, without shear forces only: with them CS79's moments F_s R add overlap
 *   times F_s to it
 *
 * Known at any moment: momentum.x, momentum.y and, without friction, momentum.angular; each with max and min as well.
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
  if (strcmp(scene->shear, "none") == 0 && !scene->cell.line) /* a step across the cell's edge moves m x x v */
    add_value(solution, "angular", angular);
  return solution_full(solution, error);
}

const struct nb_reference reference_momentum = {
    .name = "momentum",
    .title = "free bodies keep their momentum; without shear forces their angular momentum too",
    .source = "[CS79 20-23]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_CELL, HAS_CELL_STRAIN, HAS_FRICTION,
                HAS_COHESION, HAS_PIECES, HAS_CONTACT_BETA, HAS_CONTACT_FRACTION, HAS_CONTACT_RATIO, HAS_DEEP_DAMPING,
                HAS_UNTIL, HAS_STEP_CHANGE, HAS_DAMPING_CHANGE, HAS_MATERIAL_CHANGE},
    .normal = NB_ANY_LAW,
    .shear = NB_ANY_LAW,
    .solve = solve,
};
