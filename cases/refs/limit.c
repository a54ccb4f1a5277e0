/* The largest stable step of the calculation cycle for a network of springs and dashpots.
 *
 * One cycle without loads [CS79 20-23a, 26-28], in the symbols of limit.h, with w = v dt, is
 *
 *   w <- keep w - gain (dt^2 K u + dt C w),    u <- u + w
 *
 * The dashpot acts on the velocity of the previous half step. The cycle maps (u, w) to new values, and the step is too
 * long when the matrix of this map has an eigenvalue outside the unit circle. At the limit this eigenvalue is -1: u and
 * w change sign every cycle. Inserted into the cycle, this change of sign gives
 * det(dt^2 K + 2 dt C - 2 (1 + keep)/gain) = 0.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "limit.h"

#include <float.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>

/* A double eigenvalue 1, of a degree of freedom without stiffness, is computed as 1 + sqrt(rounding). */
static const double allowed_growth = 1e-6;

static double reduced_mass(const struct nb_scene *scene, const struct lattice_contact *contact) {
  const struct nb_particle *a = &scene->particles[contact->a];
  double inverse = a->fixed ? 0 : 1 / matter_mass(scene, a);
  if (!contact->wall && !scene->particles[contact->b].fixed)
    inverse += 1 / matter_mass(scene, &scene->particles[contact->b]);
  return 1 / inverse;
}

static double critical_step(const struct nb_scene *scene) {
  double lightest = INFINITY, max_stiffness = 0;
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *particle = &scene->particles[i];
    if (!particle->fixed)
      lightest = fmin(lightest, matter_mass(scene, particle));
    for (size_t j = 0; j < scene->particle_count; j++)
      max_stiffness = fmax(max_stiffness, matter_pair(scene, particle->material, scene->particles[j].material).kn);
    for (size_t j = 0; j < scene->wall_count; j++)
      max_stiffness = fmax(max_stiffness, matter_pair(scene, particle->material, scene->walls[j].material).kn);
  }
  return 2 * sqrt(lightest / max_stiffness);
}

/* c of a dashpot beside the spring k, N s/m, by the statements of the page. `mass` is the reduced mass of the contact,
 * `critical` the single-contact step; both are in SI units. */
static double dashpot(const struct nb_damping *damping, bool wall, double k, double mass, double critical) {
  double value;
  switch (nb_damping_at(damping, wall, &value)) {
  case NB_CONTACT_STIFFNESS:
    return value * k; /* [CS79 28] */
  case NB_CONTACT_R89_FRACTION:
    return value * k * critical / 2; /* [R89 4.3, 4.4] */
  case NB_CONTACT_RATIO:
    return value * 2 * sqrt(mass * k); /* [R89 4.13] */
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return 0;
}

/* `damping mass` does not change the limit: keep = (1 - h)/(1 + h) and gain = 1/(1 + h), h = alpha dt/2, give
 * 2 (1 + keep)/gain = 4 for all h. */
static void set_global_damping(struct limit *limit, const struct nb_damping *damping) {
  const double g = damping->global;
  limit->keep = limit->gain = 1;
  if (damping->global_kind == NB_GLOBAL_CON1_CS79)
    limit->keep = g / (2 - g), limit->gain = 1 / (2 - g);
  if (damping->global_kind == NB_GLOBAL_CON1_VELOCITY)
    limit->keep = g;
  if (damping->global_kind == NB_GLOBAL_CON1_ALL)
    limit->keep = limit->gain = g;
}

enum nb_status limit_build(struct limit *limit, const struct nb_scene *scene, const struct nb_damping *damping,
                           double largest_gap, struct nb_error *error) {
  *limit = (struct limit){0};
  if (lattice_build_pairs(&limit->lattice, scene, largest_gap, error))
    return error->status;
  const struct lattice *lattice = &limit->lattice;
  limit->single_contact = critical_step(scene);
  limit->dashpots = gsl_vector_alloc(2 * lattice->contact_count);
  for (size_t r = 0; r < 2 * lattice->contact_count; r++) {
    double k = gsl_vector_get(lattice->springs, r), mass = reduced_mass(scene, &lattice->contacts[r / 2]);
    gsl_vector_set(limit->dashpots, r, dashpot(damping, lattice->contacts[r / 2].wall, k, mass, limit->single_contact));
  }
  set_global_damping(limit, damping);
  if (limit->gain > 0 && gsl_vector_max(lattice->springs) > 0)
    return NB_OK;
  limit_free(limit);
  return nb_error_set(error, NB_BAD_USE, "no spring of this scene moves a particle, so no step is too long");
}

void limit_free(struct limit *limit) {
  gsl_vector_free(limit->dashpots);
  lattice_free(&limit->lattice);
  *limit = (struct limit){0};
}

/* stretch^T (a springs + b dashpots) stretch */
static gsl_matrix *assembled(const struct limit *limit, double a, double b) {
  const gsl_matrix *stretch = limit->lattice.stretch;
  gsl_matrix *forces_of_u = gsl_matrix_alloc(stretch->size1, stretch->size2);
  gsl_matrix *sum = gsl_matrix_alloc(stretch->size2, stretch->size2);
  gsl_matrix_memcpy(forces_of_u, stretch);
  for (size_t r = 0; r < stretch->size1; r++) {
    gsl_vector_view row = gsl_matrix_row(forces_of_u, r);
    gsl_vector_scale(&row.vector,
                     a * gsl_vector_get(limit->lattice.springs, r) + b * gsl_vector_get(limit->dashpots, r));
  }
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, stretch, forces_of_u, 0, sum);
  gsl_matrix_free(forces_of_u);
  return sum;
}

/* The largest eigenvalue of a symmetric matrix, which is overwritten. */
static double largest_eigenvalue(gsl_matrix *matrix) {
  gsl_vector *values = gsl_vector_alloc(matrix->size1);
  gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(matrix->size1);
  const bool solved = gsl_eigen_symm(matrix, values, work) == GSL_SUCCESS;
  double largest = solved ? gsl_vector_max(values) : NAN;
  gsl_eigen_symm_free(work);
  gsl_vector_free(values);
  return largest;
}

double limit_radius(const struct limit *limit, double step) {
  size_t n = limit->lattice.freedom_count;
  gsl_matrix *cycle = gsl_matrix_calloc(2 * n, 2 * n);
  gsl_matrix *k = assembled(limit, limit->gain * step * step, 0), *c = assembled(limit, 0, limit->gain * step);
  for (size_t i = 0; i < n; i++) {
    gsl_matrix_set(cycle, i, i, 1);
    for (size_t j = 0; j < n; j++) {
      double from_u = -gsl_matrix_get(k, i, j), from_w = (i == j ? limit->keep : 0) - gsl_matrix_get(c, i, j);
      gsl_matrix_set(cycle, n + i, j, from_u);
      gsl_matrix_set(cycle, n + i, n + j, from_w);
      gsl_matrix_set(cycle, i, j, gsl_matrix_get(cycle, i, j) + from_u);
      gsl_matrix_set(cycle, i, n + j, from_w);
    }
  }
  gsl_vector_complex *values = gsl_vector_complex_alloc(2 * n);
  gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(2 * n);
  double radius = gsl_eigen_nonsymm(cycle, values, work) == GSL_SUCCESS ? 0 : INFINITY;
  for (size_t i = 0; i < 2 * n; i++)
    radius = fmax(radius, gsl_complex_abs(gsl_vector_complex_get(values, i)));
  gsl_eigen_nonsymm_free(work);
  gsl_vector_complex_free(values);
  gsl_matrix_free(cycle), gsl_matrix_free(k), gsl_matrix_free(c);
  return radius;
}

/* The largest stable step. It is found by `times` bisections between two steps that are the single-contact step times
 * consecutive powers of two. NAN: there are no such steps. */
static double bisect(const struct limit *limit, bool (*stable)(const struct limit *, const struct nb_scene *, double),
                     const struct nb_scene *scene, int times) {
  double high = limit->single_contact, low;
  while (stable(limit, scene, high))
    if (!((high *= 2) < INFINITY))
      return NAN;
  for (low = high / 2; !stable(limit, scene, low); low /= 2)
    if (!((high = low) > DBL_MIN))
      return NAN;
  for (int i = 0; i < times; i++) {
    double middle = (low + high) / 2;
    *(stable(limit, scene, middle) ? &low : &high) = middle;
  }
  return low;
}

static bool cycle_is_stable(const struct limit *limit, const struct nb_scene *scene, double step) {
  (void)scene;
  return limit_radius(limit, step) <= 1 + allowed_growth;
}

static bool modes_are_stable(const struct limit *limit, const struct nb_scene *scene, double step) {
  (void)scene;
  gsl_matrix *sum = assembled(limit, step * step, 2 * step);
  double largest = largest_eigenvalue(sum);
  gsl_matrix_free(sum);
  return largest <= 2 * (1 + limit->keep) / limit->gain;
}

double limit_of_cycle(const struct limit *limit) { return bisect(limit, cycle_is_stable, NULL, 24); }
double limit_of_modes(const struct limit *limit) { return bisect(limit, modes_are_stable, NULL, 50); }

/* The sum of dt^2 k + 2 dt c over the contacts of particle `index`: of the normal springs and dashpots (which = 0), or
 * of the tangential ones, times R^2 (which = 1). */
static double total_hardness(const struct limit *limit, const struct nb_scene *scene, int index, int which,
                             double step) {
  const struct lattice *lattice = &limit->lattice;
  double sum = 0, radius = scene->particles[index].radius;
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    size_t row = 2 * c + (size_t)which;
    if (contact->a == index || (!contact->wall && contact->b == index))
      sum += gsl_vector_get(lattice->springs, row) * step + 2 * gsl_vector_get(limit->dashpots, row);
  }
  return sum * step * (which ? radius * radius : 1);
}

/* The largest eigenvalue of dt^2 K + 2 dt C of one contact. Its particles have only the fractions of their masses and
 * moments of inertia that belong to this contact (method 3 of limit.h). Each degree of freedom in the rows of `stretch`
 * of the contact is divided by the root of its fraction. */
static double contact_eigenvalue(const struct limit *limit, const struct nb_scene *scene, size_t c, double step) {
  const struct lattice *lattice = &limit->lattice;
  const struct lattice_contact *contact = &lattice->contacts[c];
  gsl_matrix *part = gsl_matrix_calloc(6, 6);
  int particles[2] = {contact->a, contact->wall ? -1 : contact->b};
  double row[2][6] = {{0}}, hardness[2];
  for (int which = 0; which < 2; which++) {
    size_t r = 2 * c + (size_t)which;
    hardness[which] = step * (gsl_vector_get(lattice->springs, r) * step + 2 * gsl_vector_get(limit->dashpots, r));
  }
  for (int side = 0; side < 2; side++)
    for (int freedom = 0; freedom < 3 && particles[side] >= 0; freedom++) {
      double radius = scene->particles[particles[side]].radius;
      double own = freedom < 2 ? hardness[0] : hardness[1] * radius * radius;
      double fraction = own / total_hardness(limit, scene, particles[side], freedom < 2 ? 0 : 1, step);
      for (int which = 0; which < 2 && own > 0; which++)
        row[which][3 * side + freedom] =
            gsl_matrix_get(lattice->stretch, 2 * c + (size_t)which, 3 * (size_t)particles[side] + (size_t)freedom) /
            sqrt(fraction);
    }
  for (size_t i = 0; i < 6; i++)
    for (size_t j = 0; j < 6; j++)
      gsl_matrix_set(part, i, j, hardness[0] * row[0][i] * row[0][j] + hardness[1] * row[1][i] * row[1][j]);
  double largest = largest_eigenvalue(part);
  gsl_matrix_free(part);
  return largest;
}

static bool contacts_are_stable(const struct limit *limit, const struct nb_scene *scene, double step) {
  double largest = 0;
  for (size_t c = 0; c < limit->lattice.contact_count; c++)
    largest = fmax(largest, contact_eigenvalue(limit, scene, c, step));
  return largest <= 2 * (1 + limit->keep) / limit->gain;
}

double limit_of_contacts(const struct limit *limit, const struct nb_scene *scene) {
  return bisect(limit, contacts_are_stable, scene, 48);
}
