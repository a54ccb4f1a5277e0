/* A network of springs under slow motion of its walls. Contacts begin and cease to slide; there is no cohesion
 * [CS79 16-19].
 *
 * Slow means equilibrium at all times: stretch^T F = 0 (lattice.h). In an increment of the path in which the walls move
 * by dw, with dn, ds the increments of overlap and slip of a contact,
 *
 *   every closed contact     F_n + dF_n = k_n (n + dn)
 *   sticking contact         F_s + dF_s = F_s + k_s ds
 *   sliding contact          F_s + dF_s = +-tan phi (F_n + dF_n)
 *   open contact             no force; n + dn <= 0
 *
 * so the displacements du follow from a linear system. The states of the contacts are found by iteration from the
 * previous ones. A contact beyond the friction limit begins to slide in the direction of its shear force. A contact
 * that would slide against its shear force sticks. A contact in tension opens. An open contact that would overlap
 * closes and sticks, at first without shear force. If the states still change after 60 iterations of an increment, the
 * reference has no solution. The error is of the order of one increment.
 *
 * Where nothing resists a rotation, or all contacts of a disc slide, these equations do not determine du. So a weak
 * spring, whose stiffness is the fraction `weak` of the largest one, ties each particle to its place. It changes the
 * forces by about that fraction.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_path.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { INCREMENTS = 1000, ATTEMPTS = 60 };          /* increments of each stage; most iterations of an increment */
enum { OPEN = 2 };                                  /* a value of walk.slides */
static const double weak = 1e-10, rounding = 1e-10; /* rounding: see correct_states */

/* The state of the network, and workspace. K has the derivatives of the contact forces with respect to the overlaps and
 * slips, by the rules above. */
struct walk {
  const struct lattice *lattice;
  int *slides;                     /* per contact: 0 sticks; -1, 1 slides, the sign of F_s; OPEN */
  gsl_vector *overlap;             /* per contact, n before the increment */
  gsl_vector *forces, *next;       /* before the increment and after it */
  gsl_vector *imposed, *stretches; /* increments of overlap and slip: by the walls alone, and in all */
  gsl_vector *load, *du;
  gsl_matrix *forces_of_u, *a; /* K stretch; stretch^T K stretch */
  gsl_permutation *order;
};

static struct walk walk_begin(const struct lattice *lattice) {
  size_t rows = lattice->stretch->size1, n = lattice->freedom_count;
  return (struct walk){.lattice = lattice,
                       .slides = calloc(lattice->contact_count + 1, sizeof(int)),
                       .overlap = gsl_vector_calloc(lattice->contact_count),
                       .forces = gsl_vector_calloc(rows),
                       .next = gsl_vector_alloc(rows),
                       .imposed = gsl_vector_alloc(rows),
                       .stretches = gsl_vector_alloc(rows),
                       .load = gsl_vector_alloc(n),
                       .du = gsl_vector_alloc(n),
                       .forces_of_u = gsl_matrix_alloc(rows, n),
                       .a = gsl_matrix_alloc(n, n),
                       .order = gsl_permutation_alloc(n)};
}

static void walk_end(struct walk *walk) {
  free(walk->slides);
  gsl_vector_free(walk->overlap);
  gsl_vector_free(walk->forces), gsl_vector_free(walk->next);
  gsl_vector_free(walk->imposed), gsl_vector_free(walk->stretches);
  gsl_vector_free(walk->load), gsl_vector_free(walk->du);
  gsl_matrix_free(walk->forces_of_u), gsl_matrix_free(walk->a);
  gsl_permutation_free(walk->order);
}

/* Forces after the increments d, by the rules above. */
static void forces_after(const struct walk *walk, const gsl_vector *d, gsl_vector *forces) {
  for (size_t c = 0; c < walk->lattice->contact_count; c++) {
    const struct matter_pair *pair = &walk->lattice->contacts[c].pair;
    int slides = walk->slides[c];
    double normal = pair->kn * (gsl_vector_get(walk->overlap, c) + gsl_vector_get(d, 2 * c));
    double sticking = gsl_vector_get(walk->forces, 2 * c + 1) + pair->ks * gsl_vector_get(d, 2 * c + 1);
    gsl_vector_set(forces, 2 * c, slides == OPEN ? 0 : normal);
    gsl_vector_set(forces, 2 * c + 1, slides == OPEN ? 0 : slides ? slides * pair->friction * normal : sticking);
  }
}

/* Computes du, the stretches and the forces of one increment of the path, for the present states of the contacts. */
static void solve_increment(struct walk *walk) {
  const struct lattice *lattice = walk->lattice;
  size_t n = lattice->freedom_count;
  gsl_matrix_memcpy(walk->forces_of_u, lattice->stretch);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct matter_pair *pair = &lattice->contacts[c].pair;
    gsl_vector_view normal = gsl_matrix_row(walk->forces_of_u, 2 * c),
                    shear = gsl_matrix_row(walk->forces_of_u, 2 * c + 1);
    gsl_vector_scale(&normal.vector, walk->slides[c] == OPEN ? 0 : pair->kn);
    gsl_vector_scale(&shear.vector, walk->slides[c] == OPEN ? 0 : pair->ks);
    if (!walk->slides[c] || walk->slides[c] == OPEN)
      continue;
    gsl_vector_memcpy(&shear.vector, &normal.vector);
    gsl_vector_scale(&shear.vector, walk->slides[c] * pair->friction);
  }
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, lattice->stretch, walk->forces_of_u, 0, walk->a);
  double largest = 0;
  for (size_t i = 0; i < n; i++)
    largest = fmax(largest, gsl_matrix_get(walk->a, i, i));
  for (size_t i = 0; i < n; i++)
    gsl_matrix_set(walk->a, i, i, gsl_matrix_get(walk->a, i, i) + weak * largest);
  forces_after(walk, walk->imposed, walk->next);
  gsl_blas_dgemv(CblasTrans, -1, lattice->stretch, walk->next, 0, walk->load);
  int sign;
  if (gsl_linalg_LU_decomp(walk->a, walk->order, &sign) != GSL_SUCCESS ||
      gsl_linalg_LU_solve(walk->a, walk->order, walk->load, walk->du) != GSL_SUCCESS)
    gsl_vector_set_all(walk->du, NAN);
  gsl_vector_memcpy(walk->stretches, walk->imposed);
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->stretch, walk->du, 1, walk->stretches);
  forces_after(walk, walk->stretches, walk->next);
}

/* Corrects the states of the contacts; false: there was nothing to correct. A force may exceed its limit by the
 * fraction `rounding` of the largest force. */
static bool correct_states(struct walk *walk) {
  double allowed = rounding * fmax(gsl_vector_max(walk->next), -gsl_vector_min(walk->next));
  bool more = false;
  for (size_t c = 0; c < walk->lattice->contact_count; c++) {
    const struct matter_pair *pair = &walk->lattice->contacts[c].pair;
    double normal = gsl_vector_get(walk->next, 2 * c), shear = gsl_vector_get(walk->next, 2 * c + 1);
    double sticking = gsl_vector_get(walk->forces, 2 * c + 1) + pair->ks * gsl_vector_get(walk->stretches, 2 * c + 1);
    double overlap = gsl_vector_get(walk->overlap, c) + gsl_vector_get(walk->stretches, 2 * c);
    if (walk->slides[c] == OPEN ? pair->kn * overlap > allowed : normal < -allowed)
      walk->slides[c] = walk->slides[c] == OPEN ? 0 : OPEN, more = true;
    else if (walk->slides[c] == OPEN)
      continue;
    else if (!walk->slides[c] && pair->ks > 0 && fabs(shear) > pair->friction * normal + allowed)
      walk->slides[c] = shear > 0 ? 1 : -1, more = true;
    else if (walk->slides[c] && walk->slides[c] * (sticking - shear) < -allowed)
      walk->slides[c] = 0, more = true;
  }
  return more;
}

enum nb_status lattice_path(const struct lattice *lattice, lattice_path_point *add_point, void *data,
                            struct nb_error *error) {
  struct walk walk = walk_begin(lattice);
  gsl_vector *travel = gsl_vector_calloc(lattice->wall_stretch->size2);
  enum nb_status status = walk.slides ? NB_OK : nb_error_memory(error);
  for (size_t s = 0; s < lattice->stage_count && status == NB_OK; s++) {
    gsl_vector_memcpy(travel, lattice->travel[s]);
    if (s > 0)
      gsl_vector_sub(travel, lattice->travel[s - 1]);
    gsl_blas_dgemv(CblasNoTrans, 1. / INCREMENTS, lattice->wall_stretch, travel, 0, walk.imposed);
    add_point(data, s, 0, walk.forces);
    for (int k = 1; k <= INCREMENTS && status == NB_OK; k++) {
      int attempts = 0;
      do
        solve_increment(&walk);
      while (correct_states(&walk) && ++attempts < ATTEMPTS);
      if (attempts == ATTEMPTS)
        status = nb_error_set(error, NB_BAD_USE, "no equilibrium was found in increment %d of stage %zu", k, s + 1);
      gsl_vector_memcpy(walk.forces, walk.next);
      gsl_vector_view dn = gsl_vector_subvector_with_stride(walk.stretches, 0, 2, lattice->contact_count);
      gsl_vector_add(walk.overlap, &dn.vector);
      add_point(data, s, (double)k / INCREMENTS, walk.forces);
    }
  }
  gsl_vector_free(travel);
  walk_end(&walk);
  return status;
}
