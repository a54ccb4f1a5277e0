/* Finds two particles in contact with each other, and one wall behind each, in a network.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_row.h"

#include <math.h>

/* Tolerance for parallel and perpendicular unit vectors and, relative, for equal speeds of walls: pages give coordinates
 * and velocities with a finite number of decimals. */
static const double straight = 1e-9;

/* Finds the contacts A, B, C. Other contacts must have no effect: perpendicular to the row, with k_s = 0. */
static bool sort_contacts(struct lattice_row *row) {
  const struct lattice *lattice = &row->lattice;
  size_t found[3] = {0}; /* B is the only contact of the two particles */
  const struct lattice_contact *between = NULL;
  for (size_t c = 0; c < lattice->contact_count; c++)
    if (!lattice->contacts[c].wall) {
      between = &lattice->contacts[c];
      row->contact[1] = c;
    }
  if (!between)
    return false;
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    if (!contact->wall)
      continue;
    double along = contact->ex * between->ex + contact->ey * between->ey;
    if (fabs(along) < straight && contact->pair.ks == 0)
      continue;
    size_t place = contact->a == between->a ? 0 : 2;
    if (fabs(along - (place == 0 ? -1 : 1)) > straight)
      return false;
    row->contact[place] = c;
    found[place]++;
  }
  return found[0] == 1 && found[2] == 1;
}

/* The component of a wall's displacement or velocity toward the particles, at contact A (place 0) or C (place 2).
 * `vector` has x, y and angle of each wall in turn. */
static double inward(const struct lattice_row *row, size_t place, const gsl_vector *vector) {
  const struct lattice_contact *contact = &row->lattice.contacts[row->contact[place]];
  size_t x = LATTICE_WALL * (size_t)contact->b;
  return -contact->ex * gsl_vector_get(vector, x) - contact->ey * gsl_vector_get(vector, x + 1);
}

static bool find_motion(struct lattice_row *row, const struct nb_scene *scene) {
  const struct lattice *lattice = &row->lattice;
  if (lattice->change_count == 0 || lattice->changes[0].cycle != 0)
    return false;
  row->v = inward(row, 0, lattice->changes[0].change);
  if (!(row->v > 0) || fabs(inward(row, 2, lattice->changes[0].change) - row->v) > straight * row->v)
    return false;
  row->steady = lattice->undamped;
  if (lattice->change_count > 1 && lattice->changes[1].cycle < row->steady)
    row->steady = lattice->changes[1].cycle;
  if (!lattice->one_step && scene->stages[0].cycles < row->steady)
    row->steady = scene->stages[0].cycles;
  const gsl_vector *end = lattice->travel[lattice->stage_count - 1];
  row->compression = inward(row, 0, end) + inward(row, 2, end);
  return true;
}

enum nb_status lattice_row_build(struct lattice_row *row, const struct nb_scene *scene, struct nb_error *error) {
  *row = (struct lattice_row){0};
  if (scene->particle_count != 2)
    return nb_error_set(error, NB_BAD_USE, "this reference is for two particles in a row");
  enum nb_status status = lattice_build(&row->lattice, scene, error);
  if (status != NB_OK)
    return status;
  if (!sort_contacts(row))
    status = nb_error_set(error, NB_BAD_USE,
                          "this reference is for two particles in contact, with one wall behind each; walls beside "
                          "them must exert no shear force");
  else if (!find_motion(row, scene))
    status = nb_error_set(error, NB_BAD_USE,
                          "this reference is for two walls that approach with equal speeds from the start");
  if (status != NB_OK) {
    lattice_row_free(row);
    return status;
  }
  for (size_t i = 0; i < 3; i++)
    row->k[i] = row->lattice.contacts[row->contact[i]].pair.kn;
  for (size_t i = 0; i < 2; i++)
    row->m[i] = matter_mass(scene, &scene->particles[i]);
  return NB_OK;
}

void lattice_row_free(struct lattice_row *row) { lattice_free(&row->lattice); }

int lattice_row_place(const struct lattice_row *row, int contact) {
  for (int place = 0; place < 3; place++)
    if (row->contact[place] == (size_t)contact)
      return place;
  return -1;
}
