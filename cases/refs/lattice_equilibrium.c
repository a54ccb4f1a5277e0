/* Equilibrium of a network of springs after a displacement of its walls, without and with sliding.
 *
 * Without sliding:  stretch^T S stretch u = - stretch^T S wall_stretch w.  The matrix is singular where nothing resists
 * a rotation. The singular value decomposition then gives the smallest u; the forces do not depend on that choice.
 *
 * With sliding, a contact has F_s = +-F_n tan phi instead of k_s s. The friction law has no length scale, so slow
 * proportional loading from zero keeps all ratios of forces constant: a contact slides from the first instant or never.
 * The sliding contacts are found by iteration: contacts beyond the friction limit become sliding until no contact is
 * beyond the limit. In the result every sliding contact must slide in the direction of its shear force; otherwise the
 * reference has no solution.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

/* Singular values below this fraction of the largest are degrees of freedom without stiffness. */
static const double singular = 1e-11;
/* allowed_residual: the fraction of the load that may remain. rounding: the fraction of the largest force by which a
 * limit may be exceeded. */
static const double allowed_residual = 1e-9, rounding = 1e-9;

/* Solves stretch^T forces = 0 for u, where stretches = stretch u + wall_stretch travel and forces = law stretches. Sets
 * stretches and forces. */
static enum nb_status solve_equations(const struct lattice *lattice, const gsl_matrix *law, const gsl_vector *travel,
                                      gsl_vector *stretches, gsl_vector *forces, struct nb_error *error) {
  size_t rows = lattice->stretch->size1, n = lattice->freedom_count;
  gsl_matrix *forces_of_u = gsl_matrix_alloc(rows, n), *a = gsl_matrix_alloc(n, n), *v = gsl_matrix_alloc(n, n);
  gsl_vector *load = gsl_vector_alloc(n), *u = gsl_vector_alloc(n);
  gsl_vector *values = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
  gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, law, lattice->stretch, 0, forces_of_u);
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, lattice->stretch, forces_of_u, 0, a);
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->wall_stretch, travel, 0, stretches);
  gsl_blas_dgemv(CblasNoTrans, 1, law, stretches, 0, forces);
  gsl_blas_dgemv(CblasTrans, -1, lattice->stretch, forces, 0, load);
  double whole = gsl_blas_dnrm2(load);
  bool solved = gsl_linalg_SV_decomp(a, v, values, work) == GSL_SUCCESS;
  for (size_t i = 0; i < n; i++)
    if (gsl_vector_get(values, i) < singular * gsl_vector_get(values, 0))
      gsl_vector_set(values, i, 0);
  solved = solved && gsl_linalg_SV_solve(a, v, values, load, u) == GSL_SUCCESS;
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->stretch, u, 1, stretches);
  gsl_blas_dgemv(CblasNoTrans, 1, law, stretches, 0, forces);
  gsl_blas_dgemv(CblasTrans, 1, lattice->stretch, forces, 0, load);
  double residual = gsl_blas_dnrm2(load);
  gsl_matrix_free(forces_of_u);
  gsl_matrix_free(a);
  gsl_matrix_free(v);
  gsl_vector_free(load);
  gsl_vector_free(u);
  gsl_vector_free(values);
  gsl_vector_free(work);
  if (!solved || !isfinite(whole))
    return nb_error_set(error, NB_BAD_USE,
                        "the network cannot be solved: its stiffnesses or masses differ too much or are too large");
  if (!(residual <= allowed_residual * whole))
    return nb_error_set(error, NB_BAD_USE, "the network has no equilibrium: %g of its load remains", residual / whole);
  return NB_OK;
}

/* The contact law as a matrix: springs, and F_s = slides[c] tan phi F_n where slides[c] is not 0. If `slides` is NULL,
 * no contact slides. */
static gsl_matrix *law_matrix(const struct lattice *lattice, const int slides[]) {
  gsl_matrix *law = gsl_matrix_calloc(2 * lattice->contact_count, 2 * lattice->contact_count);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct matter_pair *pair = &lattice->contacts[c].pair;
    gsl_matrix_set(law, 2 * c, 2 * c, pair->kn);
    if (slides && slides[c])
      gsl_matrix_set(law, 2 * c + 1, 2 * c, slides[c] * pair->friction * pair->kn);
    else
      gsl_matrix_set(law, 2 * c + 1, 2 * c + 1, pair->ks);
  }
  return law;
}

enum nb_status lattice_equilibrium(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                   struct nb_error *error) {
  gsl_matrix *law = law_matrix(lattice, NULL);
  gsl_vector *stretches = gsl_vector_alloc(forces->size);
  enum nb_status status = solve_equations(lattice, law, travel, stretches, forces, error);
  gsl_vector_free(stretches);
  gsl_matrix_free(law);
  return status;
}

static double force_scale(const gsl_vector *forces) { return fmax(gsl_vector_max(forces), -gsl_vector_min(forces)); }

enum nb_status lattice_check_forces(const struct lattice *lattice, const gsl_vector *forces, double cycle,
                                    struct nb_error *error) {
  double allowed = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    double normal = gsl_vector_get(forces, 2 * c), shear = fabs(gsl_vector_get(forces, 2 * c + 1));
    const char *other = contact->wall ? "wall" : "particle";
    if (normal < -allowed)
      return nb_error_set(
          error, NB_BAD_USE,
          "this reference is for contacts that stay closed; the contact of particle %d with %s %d opens at cycle %g",
          contact->a + 1, other, contact->b + 1, cycle);
    if (shear > normal * contact->pair.friction + contact->pair.cohesion + allowed)
      return nb_error_set(
          error, NB_BAD_USE,
          "this reference is for contacts that do not slip; the contact of particle %d with %s %d slips at cycle "
          "%g (shear over normal force %g)",
          contact->a + 1, other, contact->b + 1, cycle, shear / normal);
  }
  return NB_OK;
}

/* Marks contacts beyond the friction limit as sliding; true: at least one was not marked before. */
static bool mark_sliding(const struct lattice *lattice, const gsl_vector *forces, int slides[]) {
  bool more = false;
  double allowed = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct matter_pair *pair = &lattice->contacts[c].pair;
    double normal = gsl_vector_get(forces, 2 * c), shear = gsl_vector_get(forces, 2 * c + 1);
    if (normal < 0 || fabs(shear) <= pair->friction * normal + allowed)
      continue;
    slides[c] = shear > 0 ? 1 : -1;
    more = true;
  }
  return more;
}

/* True: every sliding contact slides in the direction of its F_s. The slip s of a contact consists of the elastic part
 * F_s/k_s and of sliding. */
static bool slides_along_force(const struct lattice *lattice, const gsl_vector *stretches, const gsl_vector *forces,
                               const int slides[]) {
  double allowed = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    double elastic = lattice->contacts[c].pair.ks * gsl_vector_get(stretches, 2 * c + 1);
    if (slides[c] * (elastic - gsl_vector_get(forces, 2 * c + 1)) < -allowed)
      return false;
  }
  return true;
}

enum nb_status lattice_equilibrium_sliding(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                           struct nb_error *error) {
  int *slides = calloc(lattice->contact_count, sizeof *slides);
  if (!slides)
    return nb_error_memory(error);
  gsl_vector *stretches = gsl_vector_alloc(forces->size);
  enum nb_status status;
  do {
    gsl_matrix *law = law_matrix(lattice, slides);
    status = solve_equations(lattice, law, travel, stretches, forces, error);
    gsl_matrix_free(law);
  } while (status == NB_OK && mark_sliding(lattice, forces, slides));
  if (status == NB_OK)
    status = lattice_check_forces(lattice, forces, (double)lattice->cycles, error);
  if (status == NB_OK && !slides_along_force(lattice, stretches, forces, slides))
    status = nb_error_set(error, NB_BAD_USE,
                          "no equilibrium was found: a contact would have to slide against its shear force");
  gsl_vector_free(stretches);
  free(slides);
  return status;
}
