/* A network of springs led slowly along its walls' path: which contacts slide may change as it goes  [CS79 16-19, c = 0].
 *
 * Slow means that the network is at rest all the time: stretch' F = 0. In a small piece of the path that takes the walls
 * dw farther, with dn, ds the stretches of a contact,
 *
 *   every closed contact     F_n + dF_n = k_n (n + dn)
 *   one that sticks          F_s + dF_s = F_s + k_s ds
 *   one that slides          F_s + dF_s = (sense) tan phi (F_n + dF_n)
 *   one that is open         no force; n + dn <= 0
 *
 * so du follows from one linear system. Who slides is found by trying, from who did so before: what friction cannot hold
 * begins to slide, in the sense of its shear force; what would have to slide against that sticks again; what would have to
 * pull opens; what is open and would overlap closes, and sticks, with no shear force yet. A piece in which
 * that comes to no end has no answer, and the reference says so. The error is that of a change within a piece: of the order
 * of one piece of the path. Where nothing holds a spin or a disc slides everywhere, du is not determined by the springs, and a
 * spring of `faint` of them, from each body to where it was, does: the forces notice no more than that share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice_path.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PIECES = 1000, TRIES = 60, OPEN = 2 }; /* pieces of each stage */
static const double faint = 1e-10, rounding = 1e-10;

/* All that changes, and room. */
struct walk {
  const struct lattice *lattice;
  int *slides;                    /* per contact: -1, 0, 1; OPEN */
  gsl_vector *overlap;            /* per contact, n before the piece */
  gsl_vector *forces, *next;      /* before the piece and after it */
  gsl_vector *wanted, *stretches; /* by the walls alone; in all */
  gsl_vector *load, *du;
  gsl_matrix *pulled, *a; /* law stretch; stretch' law stretch */
  gsl_permutation *order;
};

static struct walk walk_begin(const struct lattice *lattice) {
  size_t rows = lattice->stretch->size1, n = lattice->freedom_count;
  return (struct walk){.lattice = lattice,
                       .slides = calloc(lattice->contact_count + 1, sizeof(int)),
                       .overlap = gsl_vector_calloc(lattice->contact_count),
                       .forces = gsl_vector_calloc(rows),
                       .next = gsl_vector_alloc(rows),
                       .wanted = gsl_vector_alloc(rows),
                       .stretches = gsl_vector_alloc(rows),
                       .load = gsl_vector_alloc(n),
                       .du = gsl_vector_alloc(n),
                       .pulled = gsl_matrix_alloc(rows, n),
                       .a = gsl_matrix_alloc(n, n),
                       .order = gsl_permutation_alloc(n)};
}

static void walk_end(struct walk *walk) {
  free(walk->slides);
  gsl_vector_free(walk->overlap);
  gsl_vector_free(walk->forces), gsl_vector_free(walk->next);
  gsl_vector_free(walk->wanted), gsl_vector_free(walk->stretches);
  gsl_vector_free(walk->load), gsl_vector_free(walk->du);
  gsl_matrix_free(walk->pulled), gsl_matrix_free(walk->a);
  gsl_permutation_free(walk->order);
}

/* Forces after stretches d, by the rules above. */
static void forces_after(const struct walk *walk, const gsl_vector *d, gsl_vector *forces) {
  for (size_t c = 0; c < walk->lattice->contact_count; c++) {
    const struct matter_pair *pair = &walk->lattice->contacts[c].pair;
    int slides = walk->slides[c];
    double normal = pair->kn * (gsl_vector_get(walk->overlap, c) + gsl_vector_get(d, 2 * c));
    double held = gsl_vector_get(walk->forces, 2 * c + 1) + pair->ks * gsl_vector_get(d, 2 * c + 1);
    gsl_vector_set(forces, 2 * c, slides == OPEN ? 0 : normal);
    gsl_vector_set(forces, 2 * c + 1, slides == OPEN ? 0 : slides ? slides * pair->friction * normal : held);
  }
}

/* du, the stretches and the forces of one piece, for those who slide now. */
static void step(struct walk *walk) {
  const struct lattice *lattice = walk->lattice;
  size_t n = lattice->freedom_count;
  gsl_matrix_memcpy(walk->pulled, lattice->stretch);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct matter_pair *pair = &lattice->contacts[c].pair;
    gsl_vector_view normal = gsl_matrix_row(walk->pulled, 2 * c), shear = gsl_matrix_row(walk->pulled, 2 * c + 1);
    gsl_vector_scale(&normal.vector, walk->slides[c] == OPEN ? 0 : pair->kn);
    gsl_vector_scale(&shear.vector, walk->slides[c] == OPEN ? 0 : pair->ks);
    if (!walk->slides[c] || walk->slides[c] == OPEN)
      continue;
    gsl_vector_memcpy(&shear.vector, &normal.vector);
    gsl_vector_scale(&shear.vector, walk->slides[c] * pair->friction);
  }
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, lattice->stretch, walk->pulled, 0, walk->a);
  double most = 0;
  for (size_t i = 0; i < n; i++)
    most = fmax(most, gsl_matrix_get(walk->a, i, i));
  for (size_t i = 0; i < n; i++)
    gsl_matrix_set(walk->a, i, i, gsl_matrix_get(walk->a, i, i) + faint * most);
  forces_after(walk, walk->wanted, walk->next);
  gsl_blas_dgemv(CblasTrans, -1, lattice->stretch, walk->next, 0, walk->load);
  int sign;
  if (gsl_linalg_LU_decomp(walk->a, walk->order, &sign) != GSL_SUCCESS ||
      gsl_linalg_LU_solve(walk->a, walk->order, walk->load, walk->du) != GSL_SUCCESS)
    gsl_vector_set_all(walk->du, NAN);
  gsl_vector_memcpy(walk->stretches, walk->wanted);
  gsl_blas_dgemv(CblasNoTrans, 1, lattice->stretch, walk->du, 1, walk->stretches);
  forces_after(walk, walk->stretches, walk->next);
}

/* Corrects who slides and who is open; false when all was right. */
static bool correct(struct walk *walk) {
  double spare = rounding * fmax(gsl_vector_max(walk->next), -gsl_vector_min(walk->next));
  bool more = false;
  for (size_t c = 0; c < walk->lattice->contact_count; c++) {
    const struct matter_pair *pair = &walk->lattice->contacts[c].pair;
    double normal = gsl_vector_get(walk->next, 2 * c), shear = gsl_vector_get(walk->next, 2 * c + 1);
    double held = gsl_vector_get(walk->forces, 2 * c + 1) + pair->ks * gsl_vector_get(walk->stretches, 2 * c + 1);
    double overlap = gsl_vector_get(walk->overlap, c) + gsl_vector_get(walk->stretches, 2 * c);
    if (walk->slides[c] == OPEN ? pair->kn * overlap > spare : normal < -spare)
      walk->slides[c] = walk->slides[c] == OPEN ? 0 : OPEN, more = true;
    else if (walk->slides[c] == OPEN)
      continue;
    else if (!walk->slides[c] && pair->ks > 0 && fabs(shear) > pair->friction * normal + spare)
      walk->slides[c] = shear > 0 ? 1 : -1, more = true;
    else if (walk->slides[c] && walk->slides[c] * (held - shear) < -spare)
      walk->slides[c] = 0, more = true;
  }
  return more;
}

enum nb_status lattice_path(const struct lattice *lattice, lattice_path_seen *seen, void *data,
                            struct nb_error *error) {
  struct walk walk = walk_begin(lattice);
  gsl_vector *way = gsl_vector_calloc(lattice->push->size2);
  enum nb_status status = walk.slides ? NB_OK : nb_error_memory(error);
  for (size_t s = 0; s < lattice->stage_count && status == NB_OK; s++) {
    gsl_vector_memcpy(way, lattice->travel[s]);
    if (s > 0)
      gsl_vector_sub(way, lattice->travel[s - 1]);
    gsl_blas_dgemv(CblasNoTrans, 1. / PIECES, lattice->push, way, 0, walk.wanted);
    seen(data, s, 0, walk.forces);
    for (int k = 1; k <= PIECES && status == NB_OK; k++) {
      int tries = 0;
      do
        step(&walk);
      while (correct(&walk) && ++tries < TRIES);
      if (tries == TRIES)
        status = nb_error_set(error, NB_BAD_USE, "the network finds no rest in piece %d of stage %zu", k, s + 1);
      gsl_vector_memcpy(walk.forces, walk.next);
      gsl_vector_view dn = gsl_vector_subvector_with_stride(walk.stretches, 0, 2, lattice->contact_count);
      gsl_vector_add(walk.overlap, &dn.vector);
      seen(data, s, (double)k / PIECES, walk.forces);
    }
  }
  gsl_vector_free(way);
  walk_end(&walk);
  return status;
}
