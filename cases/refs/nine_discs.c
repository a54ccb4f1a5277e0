/* Reference: discs that touch, between walls that move and stop, without damping and without slip: the force at every
 * watched contact as the sum over the normal modes of the network [CS79 figures 6, 7].
 *
 * Known of a watched contact NAME:
 *   NAME.normal along cycle, time    the calculation cycle's own solution of the linear network, at its step
 *   NAME.normal mean                 about which it swings once the walls stand: the static force
 *   NAME.normal amplitude            half of highest minus lowest, ever: the sum of the amplitudes of its waves. A run
 *                                    of W cycles misses of it about 2 pi sqrt(A1 A2) / W
 *   NAME.normal frequency            how often it rises through its mean in unit time, in the long run; known only
 *                                    when one wave is higher and steeper than all others together
 * and the same of NAME.shear. Each with ` in STAGE` for every stage in which the walls stand, too.
 *
 * Not known where a contact would open, slip, or begin to touch: then the answer is an error. What the network leaves
 * out, the turning of contacts, is of the order of overlap over radius; nine discs: 0.01 (overlap / radius) of the mean
 * force and of the frequencies, which in a curve adds up from wave to wave.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "lattice_tell.h"

enum { TEXT = 3 * NB_NAME_SIZE };

/* ` mean` of `C.normal`, for the scene and for every stage in which the walls stand. */
static void add_value(struct nb_solution *solution, const struct nb_scene *scene, size_t standing, const char *quantity,
                      const char *reducer, double value) {
  char text[TEXT];
  if (standing >= scene->stage_count)
    return;
  snprintf(text, sizeof text, "%s %s", quantity, reducer);
  solution_value(solution, value, text);
  for (size_t i = standing; i < scene->stage_count; i++) {
    snprintf(text, sizeof text, "%s %s in %s", quantity, reducer, scene->stages[i].name);
    solution_value(solution, value, text);
  }
}

/* All that is known of one force; `row` as in struct lattice. */
static enum nb_status add_force(struct nb_solution *solution, const struct nb_scene *scene,
                                const struct lattice *lattice, const struct oscillation_modes *modes,
                                const char *quantity, size_t row, struct nb_error *error) {
  struct oscillation *oscillation = oscillation_create(lattice, modes, row, OSCILLATION_STEPS, 1, error);
  if (!oscillation)
    return error->status;
  size_t standing = lattice_standing(lattice, scene);
  double beat = oscillation_beat(oscillation) / lattice->step;
  add_value(solution, scene, standing, quantity, "mean", oscillation_mean(oscillation));
  add_value(solution, scene, standing, quantity, "amplitude", oscillation_amplitude(oscillation));
  if (beat > 0)
    add_value(solution, scene, standing, quantity, "frequency", beat);
  free(oscillation);
  return lattice_add_curves(solution, lattice, modes, quantity, row, error);
}

static enum nb_status know_network(struct nb_solution *solution, const struct nb_scene *scene,
                                   const struct lattice *lattice, struct nb_error *error) {
  struct oscillation_modes modes = oscillation_modes_create(lattice);
  enum nb_status status = lattice_stays(lattice, &modes, error);
  for (size_t i = 0; i < scene->monitor_count && status == NB_OK; i++) {
    int contact = lattice_watched(lattice, &scene->monitors[i]);
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
  return status == NB_OK ? solution_full(solution, error) : status;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  status = know_network(solution, scene, &lattice, error);
  lattice_free(&lattice);
  return status;
}

const struct nb_reference reference_nine_discs = {
    .name = "nine_discs",
    .title = "touching discs between walls, undamped: sum over the normal modes, in the steps of the calculation cycle",
    .source = "[CS79 22, 22a, figures 6, 7]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_FRICTION,
                HAS_COHESION, HAS_START},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
