/* Forces of watched contacts, by name: at rest, and as curves.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_tell.h"

#include <stdlib.h>

enum { TEXT = 3 * NB_NAME_SIZE };

/* `C.normal` and, with a suffix, `C.normal mean`. */
static void tell(struct nb_known *known, const struct nb_scene *scene, const struct lattice *lattice,
                 const gsl_vector *forces, const char *suffix) {
  static const char *const kinds[2] = {"normal", "shear"};
  char text[TEXT];
  for (size_t i = 0; i < scene->watch_count; i++) {
    int contact = lattice_watched(lattice, &scene->watches[i]);
    for (size_t k = 0; k < 2 && contact >= 0; k++) {
      snprintf(text, sizeof text, "%s.%s%s", scene->watches[i].name, kinds[k], suffix);
      known_value(known, gsl_vector_get(forces, 2 * (size_t)contact + k), text);
    }
  }
}

enum nb_status lattice_tell_rest(struct nb_known *known, const struct nb_scene *scene,
                                 enum nb_status (*rest)(const struct lattice *lattice, const gsl_vector *travel,
                                                        gsl_vector *forces, struct nb_error *error),
                                 struct nb_error *error) {
  struct lattice lattice;
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  gsl_vector *forces = gsl_vector_alloc(2 * lattice.contact_count);
  size_t standing = lattice_standing(&lattice, scene);
  for (size_t i = 0; i < scene->stage_count && status == NB_OK; i++) {
    char suffix[TEXT];
    status = rest(&lattice, lattice.travel[i], forces, error);
    if (status != NB_OK)
      break;
    snprintf(suffix, sizeof suffix, " in %s", scene->stages[i].name);
    tell(known, scene, &lattice, forces, suffix);
    snprintf(suffix, sizeof suffix, " mean in %s", scene->stages[i].name);
    if (i >= standing)
      tell(known, scene, &lattice, forces, suffix);
    if (i + 1 < scene->stage_count)
      continue;
    tell(known, scene, &lattice, forces, "");
    if (i >= standing)
      tell(known, scene, &lattice, forces, " mean");
  }
  gsl_vector_free(forces);
  lattice_free(&lattice);
  return status == NB_OK ? known_full(known, error) : status;
}

enum nb_status lattice_tell_curves(struct nb_known *known, const struct lattice *lattice,
                                   const struct swing_modes *modes, const char *quantity, size_t row,
                                   struct nb_error *error) {
  static const char *const along[2] = {"cycle", "time"};
  const double unit[2] = {1, lattice->step};
  for (size_t i = 0; i < 2; i++) {
    struct swing *swing = swing_create(lattice, modes, row, SWING_STEPS, unit[i], error);
    if (!swing)
      return error->status;
    known_curve(known, quantity, along[i], swing_at, swing);
  }
  return NB_OK;
}

enum nb_status lattice_stays(const struct lattice *lattice, const struct swing_modes *modes, struct nb_error *error) {
  size_t rows = 2 * lattice->contact_count;
  struct swing **swings = calloc(rows, sizeof *swings);
  if (!swings)
    return nb_error_memory(error);
  gsl_vector *forces = gsl_vector_alloc(rows);
  enum nb_status status = NB_OK;
  for (size_t i = 0; i < rows && status == NB_OK; i++) {
    swings[i] = swing_create(lattice, modes, i, SWING_STEPS, 1, error);
    if (!swings[i])
      status = error->status;
  }
  for (unsigned long n = 1; n <= lattice->cycles && status == NB_OK; n++) {
    for (size_t i = 0; i < rows; i++)
      gsl_vector_set(forces, i, swing_at(swings[i], (double)n));
    status = lattice_holds(lattice, forces, (double)n, error);
  }
  for (size_t i = 0; i < rows; i++)
    free(swings[i]);
  free(swings);
  gsl_vector_free(forces);
  return status;
}
