/* Reference: two discs in a row between two walls that have approached, in equilibrium: three springs in series.
 *
 * The same force F acts at the contacts A, B, C, and their overlaps F/k add up to the approach of the walls:
 * F = approach / (1/k_A + 1/k_B + 1/k_C). With equal stiffnesses k and walls that move at v during t_load each, this is
 * 2 v t_load k / 3.
 *
 * Returns, for C that monitors a contact, once the walls are at rest:   C.normal, C.normal mean, C.overlap; C.shear = 0
 * Exact: nothing in a row rotates, and masses and damping have no effect.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_row.h"

static void add_value(struct nb_solution *solution, const char *monitor, const char *quantity, double value) {
  char text[3 * NB_NAME_SIZE];
  snprintf(text, sizeof text, "%s.%s", monitor, quantity);
  solution_value(solution, value, text);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice_row row;
  enum nb_status status = lattice_row_build(&row, scene, error);
  if (status != NB_OK)
    return status;
  double force = row.compression / (1 / row.k[0] + 1 / row.k[1] + 1 / row.k[2]);
  if (lattice_first_at_rest(&row.lattice, scene) == scene->stage_count)
    status = nb_error_set(error, NB_BAD_USE, "the reference `two_wall_statics` is for walls that stop");
  for (size_t i = 0; i < scene->monitor_count && status == NB_OK; i++) {
    int place = lattice_row_place(&row, lattice_contact_of(&row.lattice, &scene->monitors[i]));
    if (place < 0)
      continue;
    add_value(solution, scene->monitors[i].name, "normal", force);
    add_value(solution, scene->monitors[i].name, "normal mean", force);
    add_value(solution, scene->monitors[i].name, "overlap", force / row.k[place]);
    add_value(solution, scene->monitors[i].name, "shear", 0);
  }
  lattice_row_free(&row);
  return status == NB_OK ? solution_status(solution, error) : status;
}

const struct nb_reference reference_two_wall_statics = {
    .name = "two_wall_statics",
    .title = "two discs between two walls, at rest: three springs in series",
    .source = "[CS79 figure 1, 16]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_MOVING_WALLS, HAS_OFFSET_WALLS, HAS_FRICTION, HAS_ALL_DAMPING,
                HAS_DAMPING_CHANGE, HAS_STEP_CHANGE, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
