/* Where a network of springs comes to rest once its walls have moved, without and with slip.
 *
 * Without slip:  stretch' S stretch u = - stretch' S push w.  The matrix is singular where nothing holds a spin; the
 * singular value decomposition then answers the smallest u, and the forces do not depend on the rest.
 *
 * With slip a contact that slides has F_s = sign F_n tan phi in place of k_s s. The law has no scale of its own, so
 * loading that grows in proportion from nothing, slowly, keeps every ratio of forces as it is at the end: a contact
 * slides from the first instant or never. Which ones is found by trying: what exceeds friction slides, until nothing
 * more does. At the end all that slides must do so with its shear force, else the answer is none.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

/* Singular values below this share of the largest are freedoms that nothing holds. */
static const double unheld = 1e-11;
/* Shares of the largest force: what may be missing in an equation, and what rounding may add to a limit. */
static const double missing = 1e-9, rounding = 1e-9;

/* stretches = stretch u + push w and forces = law stretches, with u such that stretch' forces = 0. */
static enum nb_status solve_equations(const struct lattice *lattice, const gsl_matrix *law, const gsl_vector *travel,
                                      gsl_vector *stretches, gsl_vector *forces, struct nb_error *error) {
  size_t rows = lattice->stretch->size1, n = lattice->freedom_count;
  gsl_matrix *pulled = gsl_matrix_alloc(rows, n), *a = gsl_matrix_alloc(n, n), *v = gsl_matrix_alloc(n, n);
  gsl_vector *load = gsl_vector_alloc(n), *u = gsl_vector_alloc(n);
  gsl_vector *values = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
  gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, law, lattice->stretch, 0, pulled);
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, lattice->stretch, pulled, 0, a);
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->push, travel, 0, stretches);
  gsl_blas_dgemv(CblasNoTrans, 1, law, stretches, 0, forces);
  gsl_blas_dgemv(CblasTrans, -1, lattice->stretch, forces, 0, load);
  double whole = gsl_blas_dnrm2(load);
  bool solved = gsl_linalg_SV_decomp(a, v, values, work) == GSL_SUCCESS;
  for (size_t i = 0; i < n; i++)
    if (gsl_vector_get(values, i) < unheld * gsl_vector_get(values, 0))
      gsl_vector_set(values, i, 0);
  solved = solved && gsl_linalg_SV_solve(a, v, values, load, u) == GSL_SUCCESS;
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->stretch, u, 1, stretches);
  gsl_blas_dgemv(CblasNoTrans, 1, law, stretches, 0, forces);
  gsl_blas_dgemv(CblasTrans, 1, lattice->stretch, forces, 0, load);
  double left = gsl_blas_dnrm2(load);
  gsl_matrix_free(pulled);
  gsl_matrix_free(a);
  gsl_matrix_free(v);
  gsl_vector_free(load);
  gsl_vector_free(u);
  gsl_vector_free(values);
  gsl_vector_free(work);
  if (!solved || !isfinite(whole))
    return nb_error_set(error, NB_BAD_USE, "the network cannot be solved: its numbers are too far apart, or too large");
  if (!(left <= missing * whole))
    return nb_error_set(error, NB_BAD_USE, "the network cannot be at rest: %g of its load is left", left / whole);
  return NB_OK;
}

/* The law as a matrix: springs, and where slides[c] is not 0, F_s = slides[c] tan phi F_n. */
static gsl_matrix *law_of(const struct lattice *lattice, const int slides[]) {
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

enum nb_status lattice_rest(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                            struct nb_error *error) {
  gsl_matrix *law = law_of(lattice, NULL);
  gsl_vector *stretches = gsl_vector_alloc(forces->size);
  enum nb_status status = solve_equations(lattice, law, travel, stretches, forces, error);
  gsl_vector_free(stretches);
  gsl_matrix_free(law);
  return status;
}

static double force_scale(const gsl_vector *forces) { return fmax(gsl_vector_max(forces), -gsl_vector_min(forces)); }

enum nb_status lattice_holds(const struct lattice *lattice, const gsl_vector *forces, double when,
                             struct nb_error *error) {
  double spare = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    double normal = gsl_vector_get(forces, 2 * c), shear = fabs(gsl_vector_get(forces, 2 * c + 1));
    const char *other = contact->wall ? "wall" : "body";
    if (normal < -spare)
      return nb_error_set(error, NB_BAD_USE,
                          "this reference is for contacts that stay closed; that of body %d with %s %d opens at cycle "
                          "%g",
                          contact->a + 1, other, contact->b + 1, when);
    if (contact->pair.ks > 0 && shear > normal * contact->pair.friction + contact->pair.cohesion + spare)
      return nb_error_set(error, NB_BAD_USE,
                          "this reference is for contacts that do not slip; that of body %d with %s %d slips at cycle "
                          "%g (shear over normal force %g)",
                          contact->a + 1, other, contact->b + 1, when, shear / normal);
  }
  return NB_OK;
}

/* Lets slide what friction cannot hold; true when there was something new. */
static bool let_slide(const struct lattice *lattice, const gsl_vector *forces, int slides[]) {
  bool more = false;
  double spare = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct matter_pair *pair = &lattice->contacts[c].pair;
    double normal = gsl_vector_get(forces, 2 * c), shear = gsl_vector_get(forces, 2 * c + 1);
    if (slides[c] || pair->ks <= 0 || normal < 0 || fabs(shear) <= pair->friction * normal + spare)
      continue;
    slides[c] = shear > 0 ? 1 : -1;
    more = true;
  }
  return more;
}

/* Of the slip s the spring keeps F_s / k_s; the rest is sliding and must have the sense of F_s. */
static bool slides_rightly(const struct lattice *lattice, const gsl_vector *stretches, const gsl_vector *forces,
                           const int slides[]) {
  double spare = rounding * force_scale(forces);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    double held = lattice->contacts[c].pair.ks * gsl_vector_get(stretches, 2 * c + 1);
    if (slides[c] * (held - gsl_vector_get(forces, 2 * c + 1)) < -spare)
      return false;
  }
  return true;
}

enum nb_status lattice_rest_slipping(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                     struct nb_error *error) {
  for (size_t c = 0; c < lattice->contact_count; c++)
    if (lattice->contacts[c].pair.cohesion != 0)
      return nb_error_set(error, NB_BAD_USE, "this reference is for friction without cohesion");
  int *slides = calloc(lattice->contact_count, sizeof *slides);
  if (!slides)
    return nb_error_memory(error);
  gsl_vector *stretches = gsl_vector_alloc(forces->size);
  enum nb_status status;
  do {
    gsl_matrix *law = law_of(lattice, slides);
    status = solve_equations(lattice, law, travel, stretches, forces, error);
    gsl_matrix_free(law);
  } while (status == NB_OK && let_slide(lattice, forces, slides));
  if (status == NB_OK)
    status = lattice_holds(lattice, forces, (double)lattice->cycles, error);
  if (status == NB_OK && !slides_rightly(lattice, stretches, forces, slides))
    status = nb_error_set(error, NB_BAD_USE, "a contact would have to slide against its shear force");
  gsl_vector_free(stretches);
  free(slides);
  return status;
}
