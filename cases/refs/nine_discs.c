/* Reference: touching discs between walls that move and stop, without damping and sliding: the force at every monitored
 * contact as the sum over the normal modes of the network [CS79 figures 6, 7].
 *
 * Returns, for C that monitors a contact, and likewise for C.shear:
 *   C.normal versus cycle, time   the exact solution of the calculation cycle for the linear network
 *   C.normal mean                 the static force, about which the force oscillates when the walls are at rest
 *   C.normal amplitude            half of the difference between the largest and the smallest value in an infinitely
 *                                 long run: the sum of the amplitudes of the modes. With two modes of the amplitudes A1
 *                                 and A2 a run of W cycles gives a value smaller by about 2 pi sqrt(A1 A2)/W
 *   C.normal frequency            how often the force rises through its mean per unit time, in the long run; returned
 *                                 only when one mode has a larger amplitude and slope than all others together
 * Mean, amplitude and frequency are also returned `in STAGE` for each stage in which the walls are at rest.
 *
 * Refuses scenes in which a contact opens, slips or closes. The error is due to the rotation of contacts and grows
 * with overlap over radius. For nine discs with the step 0.12 of single-contact, the relative error of the frequencies
 * is about 0.01 times overlap over radius, and that of the mean force over 4000 cycles is about 0.06 times overlap over
 * radius. The errors of curve, mean and amplitude grow with the number of oscillations.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "lattice_values.h"

enum { TEXT = 3 * NB_NAME_SIZE };

/* Adds the values of one name, such as `C.normal mean`, of the run and of every stage in which the walls are at rest.
 * `at_rest` is the index of the first such stage. */
static void add_value(struct nb_solution *solution, const struct nb_scene *scene, size_t at_rest, const char *quantity,
                      const char *reducer, double value) {
  char text[TEXT];
  if (at_rest >= scene->stage_count)
    return;
  snprintf(text, sizeof text, "%s %s", quantity, reducer);
  solution_value(solution, value, text);
  for (size_t i = at_rest; i < scene->stage_count; i++) {
    snprintf(text, sizeof text, "%s %s in %s", quantity, reducer, scene->stages[i].name);
    solution_value(solution, value, text);
  }
}

/* Adds values and curves of one force; `row` as in struct lattice. */
static enum nb_status add_force(struct nb_solution *solution, const struct nb_scene *scene,
                                const struct lattice *lattice, const struct oscillation_modes *modes,
                                const char *quantity, size_t row, struct nb_error *error) {
  struct oscillation *oscillation = oscillation_create(lattice, modes, row, OSCILLATION_STEPS, 1, error);
  if (!oscillation)
    return error->status;
  size_t at_rest = lattice_first_at_rest(lattice, scene);
  double frequency = oscillation_frequency(oscillation) / lattice->step;
  add_value(solution, scene, at_rest, quantity, "mean", oscillation_mean(oscillation));
  add_value(solution, scene, at_rest, quantity, "amplitude", oscillation_amplitude(oscillation));
  if (frequency > 0)
    add_value(solution, scene, at_rest, quantity, "frequency", frequency);
  free(oscillation);
  return lattice_add_curves(solution, lattice, modes, quantity, row, error);
}

static enum nb_status add_forces(struct nb_solution *solution, const struct nb_scene *scene,
                                 const struct lattice *lattice, struct nb_error *error) {
  struct oscillation_modes modes = oscillation_modes_create(lattice);
  enum nb_status status = lattice_check_run(lattice, &modes, error);
  for (size_t i = 0; i < scene->monitor_count && status == NB_OK; i++) {
    int contact = lattice_contact_of(lattice, &scene->monitors[i]);
    char quantity[TEXT];
    if (contact < 0)
      continue;
    snprintf(quantity, sizeof quantity, "%s.normal", scene->monitors[i].name);
    status = add_force(solution, scene, lattice, &modes, quantity, 2 * (size_t)contact, error);
    snprintf(quantity, sizeof quantity, "%s.shear", scene->monitors[i].name);
    if (status == NB_OK)
      status = add_force(solution, scene, lattice, &modes, quantity, 2 * (size_t)contact + 1, error);
  }
  oscillation_modes_free(&modes);
  return status == NB_OK ? solution_status(solution, error) : status;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  status = add_forces(solution, scene, &lattice, error);
  lattice_free(&lattice);
  return status;
}

const struct nb_reference reference_nine_discs = {
    .name = "nine_discs",
    .title = "touching discs between walls, undamped: sum over the normal modes, in the steps of the calculation cycle",
    .source = "[CS79 22, 22a, figures 6, 7]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_OFFSET_WALLS,
                HAS_FRICTION, HAS_COHESION, HAS_START},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
