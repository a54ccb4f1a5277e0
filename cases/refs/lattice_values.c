/* Values and curves of the forces at monitored contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_values.h"

#include <stdlib.h>

enum { TEXT = 3 * NB_NAME_SIZE };

/* Adds C.normal and C.shear of every monitored contact C, with the suffix after each name. */
static void add_value(struct nb_solution *solution, const struct nb_scene *scene, const struct lattice *lattice,
                      const gsl_vector *forces, const char *suffix) {
  static const char *const kinds[2] = {"normal", "shear"};
  char text[TEXT];
  for (size_t i = 0; i < scene->monitor_count; i++) {
    int contact = lattice_contact_of(lattice, &scene->monitors[i]);
    for (size_t k = 0; k < 2 && contact >= 0; k++) {
      snprintf(text, sizeof text, "%s.%s%s", scene->monitors[i].name, kinds[k], suffix);
      solution_value(solution, gsl_vector_get(forces, 2 * (size_t)contact + k), text);
    }
  }
}

enum nb_status lattice_add_equilibria(struct nb_solution *solution, const struct nb_scene *scene,
                                      enum nb_status (*equilibrium)(const struct lattice *lattice,
                                                                    const gsl_vector *travel, gsl_vector *forces,
                                                                    struct nb_error *error),
                                      struct nb_error *error) {
  struct lattice lattice;
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  gsl_vector *forces = gsl_vector_alloc(2 * lattice.contact_count);
  size_t at_rest = lattice_first_at_rest(&lattice, scene);
  for (size_t i = 0; i < scene->stage_count && status == NB_OK; i++) {
    char suffix[TEXT];
    status = equilibrium(&lattice, lattice.travel[i], forces, error);
    if (status != NB_OK)
      break;
    snprintf(suffix, sizeof suffix, " in %s", scene->stages[i].name);
    add_value(solution, scene, &lattice, forces, suffix);
    snprintf(suffix, sizeof suffix, " mean in %s", scene->stages[i].name);
    if (i >= at_rest)
      add_value(solution, scene, &lattice, forces, suffix);
    if (i + 1 < scene->stage_count)
      continue;
    add_value(solution, scene, &lattice, forces, "");
    if (i >= at_rest)
      add_value(solution, scene, &lattice, forces, " mean");
  }
  gsl_vector_free(forces);
  lattice_free(&lattice);
  return status == NB_OK ? solution_status(solution, error) : status;
}

enum nb_status lattice_add_curves(struct nb_solution *solution, const struct lattice *lattice,
                                  const struct oscillation_modes *modes, const char *quantity, size_t row,
                                  struct nb_error *error) {
  static const char *const along[2] = {"cycle", "time"};
  const double unit[2] = {1, lattice->step};
  for (size_t i = 0; i < 2; i++) {
    struct oscillation *oscillation = oscillation_create(lattice, modes, row, OSCILLATION_STEPS, unit[i], error);
    if (!oscillation)
      return error->status;
    solution_curve(solution, quantity, along[i], oscillation_at, oscillation);
  }
  return NB_OK;
}

enum nb_status lattice_check_run(const struct lattice *lattice, const struct oscillation_modes *modes,
                                 struct nb_error *error) {
  size_t rows = 2 * lattice->contact_count;
  struct oscillation **oscillations = calloc(rows, sizeof *oscillations);
  if (!oscillations)
    return nb_error_memory(error);
  gsl_vector *forces = gsl_vector_alloc(rows);
  enum nb_status status = NB_OK;
  for (size_t i = 0; i < rows && status == NB_OK; i++) {
    oscillations[i] = oscillation_create(lattice, modes, i, OSCILLATION_STEPS, 1, error);
    if (!oscillations[i])
      status = error->status;
  }
  for (unsigned long n = 1; n <= lattice->cycles && status == NB_OK; n++) {
    for (size_t i = 0; i < rows; i++)
      gsl_vector_set(forces, i, oscillation_at(oscillations[i], (double)n));
    status = lattice_check_forces(lattice, forces, (double)n, error);
  }
  for (size_t i = 0; i < rows; i++)
    free(oscillations[i]);
  free(oscillations);
  gsl_vector_free(forces);
  return status;
}
