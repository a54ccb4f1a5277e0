/* Oscillation of a network of springs after its walls have moved: the sum over its normal modes, exact in time steps.
 *
 * In the terms of lattice.h, with u = sum q_i shape_i each mode obeys  q'' + omega^2 q = g(t), omega^2 = `square`. If
 * the velocities of the walls change by c at t = 0, g = b t with b = - shape_i^T stretch^T S wall_stretch c. From rest
 *
 *     q = (b / omega^2) (t - sin(omega t) / omega).
 *
 * The calculation cycle [CS79 22, 22a] is  q_(n+1) - 2 q_n + q_(n-1) = dt^2 (g_n - omega^2 q_n)  with q_0 = q_1 = 0.
 * Its exact solution is
 *
 *     q_n = (b dt / omega^2) (n - sin(n phase) / sin(phase)),   sin(phase / 2) = omega dt / 2.
 *
 * It has the straight line of the solution in continuous time, and an oscillation of slightly higher frequency. A
 * program that follows the cycle agrees with this solution to rounding, except that in the program the directions of
 * contacts change a little. Every change of the velocities of the walls adds such a solution.
 *
 * For nine equal discs between four walls that approach with equal speeds only two of the 27 modes move, by symmetry. A
 * corner disc moves by d_c along both axes, the middle disc of a side by d_m towards the centre, and no disc rotates.
 * When each wall has moved by d, with r = k_s/k_n,
 *
 *     m d_c'' / k_n = d - (2 + 2 r) d_c + r d_m       m d_m'' / k_n = d - (2 + 2 r) d_m + 2 r d_c
 *
 * so omega^2 = (2 + 2 r -+ r sqrt 2) k_n/m with d_m = +- sqrt 2 d_c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "lattice.h"

/* Values below these fractions are rounding: no_stiffness of the largest omega^2, no_motion of an upper bound of the
 * terms. */
static const double no_stiffness = 1e-11, no_motion = 1e-12;
/* Modes whose phases differ by less than this fraction are one wave. */
static const double same_phase = 1e-9;

/* Multiplies row i by springs[i]. */
static void scale_rows(gsl_matrix *matrix, const gsl_vector *springs) {
  for (size_t i = 0; i < matrix->size1; i++) {
    gsl_vector_view row = gsl_matrix_row(matrix, i);
    gsl_vector_scale(&row.vector, gsl_vector_get(springs, i));
  }
}

struct oscillation_modes oscillation_modes_create(const struct lattice *lattice) {
  size_t n = lattice->freedom_count;
  struct oscillation_modes modes = {.square = gsl_vector_alloc(n), .shape = gsl_matrix_alloc(n, n)};
  gsl_matrix *forces_of_u = gsl_matrix_alloc(lattice->stretch->size1, n), *a = gsl_matrix_alloc(n, n);
  gsl_matrix_memcpy(forces_of_u, lattice->stretch);
  scale_rows(forces_of_u, lattice->springs);
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, lattice->stretch, forces_of_u, 0, a);
  gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
  if (gsl_eigen_symmv(a, modes.square, modes.shape, work) != GSL_SUCCESS)
    gsl_vector_set_all(modes.square, NAN); /* no step is stable then */
  gsl_eigen_symmv_sort(modes.square, modes.shape, GSL_EIGEN_SORT_VAL_ASC);
  gsl_eigen_symmv_free(work);
  gsl_matrix_free(forces_of_u);
  gsl_matrix_free(a);
  return modes;
}

void oscillation_modes_free(struct oscillation_modes *modes) {
  gsl_vector_free(modes->square);
  gsl_matrix_free(modes->shape);
  *modes = (struct oscillation_modes){0};
}

/* What a velocity change of the walls adds per cycle: `straight`, N, to each force if the particles do not move, and
 * `load`, which is b dt above, to the load of each mode. */
static void add_wall_loads(const struct lattice *lattice, const struct oscillation_modes *modes,
                           const gsl_vector *change, gsl_vector *straight, gsl_vector *load) {
  gsl_vector *force = gsl_vector_alloc(lattice->freedom_count);
  gsl_blas_dgemv(CblasNoTrans, lattice->step, lattice->wall_stretch, change, 0, straight);
  gsl_vector_mul(straight, lattice->springs);
  gsl_blas_dgemv(CblasTrans, -1, lattice->stretch, straight, 0, force);
  gsl_blas_dgemv(CblasTrans, 1, modes->shape, force, 0, load);
  gsl_vector_free(force);
}

/* The phase and the divisor `sine` of the wave of a mode with the angular frequency `omega`, rad/s. */
static struct oscillation_term wave_of(double omega, double step, enum oscillation_time time) {
  double angle = omega * step;
  if (time == OSCILLATION_CONTINUOUS)
    return (struct oscillation_term){.phase = angle, .sine = angle};
  double phase = 2 * asin(angle / 2);
  return (struct oscillation_term){.phase = phase, .sine = sin(phase)};
}

/* `top` is the omega^2 of the fastest mode. This mode limits the step even if it is at rest by symmetry, because
 * rounding excites it. */
static bool step_is_stable(const struct lattice *lattice, double top, struct nb_error *error) {
  if (sqrt(top) * lattice->step < 2)
    return true;
  if (isnan(top)) {
    nb_error_set(error, NB_BAD_USE,
                 "the modes of the network cannot be computed: its stiffnesses or masses differ too much");
    return false;
  }
  nb_error_set(error, NB_BAD_USE, "the step %g s is too long for this network: the limit is %g s", lattice->step,
               2 / sqrt(top));
  return false;
}

struct oscillation *oscillation_create(const struct lattice *lattice, const struct oscillation_modes *modes, size_t row,
                                       enum oscillation_time time, double unit, struct nb_error *error) {
  size_t n = lattice->freedom_count, most = lattice->change_count * (n + 1);
  double top = gsl_vector_get(modes->square, n - 1);
  if (time == OSCILLATION_STEPS && !step_is_stable(lattice, top, error))
    return NULL;
  struct oscillation *oscillation = calloc(1, sizeof *oscillation + most * sizeof oscillation->terms[0]);
  if (!oscillation) {
    nb_error_memory(error);
    return NULL;
  }
  oscillation->unit = unit;
  gsl_vector *straight = gsl_vector_alloc(lattice->stretch->size1), *load = gsl_vector_alloc(n);
  gsl_vector *mode_force = gsl_vector_alloc(n); /* the force when a mode's q is 1 */
  gsl_vector_const_view stretch = gsl_matrix_const_row(lattice->stretch, row);
  gsl_blas_dgemv(CblasTrans, gsl_vector_get(lattice->springs, row), modes->shape, &stretch.vector, 0, mode_force);
  for (size_t k = 0; k < lattice->change_count; k++) {
    add_wall_loads(lattice, modes, lattice->changes[k].change, straight, load);
    double start = (double)lattice->changes[k].cycle, own = gsl_vector_get(straight, row);
    double least = no_motion * (fabs(own) + gsl_blas_dnrm2(load) * gsl_blas_dnrm2(mode_force) / top);
    oscillation->terms[oscillation->count++] = (struct oscillation_term){.start = start, .size = own};
    for (size_t i = 0; i < n; i++) {
      double square = gsl_vector_get(modes->square, i);
      if (square < no_stiffness * top)
        continue;
      struct oscillation_term term = wave_of(sqrt(square), lattice->step, time);
      term.start = start;
      term.size = gsl_vector_get(mode_force, i) * gsl_vector_get(load, i) / square;
      if (fabs(term.size) > least)
        oscillation->terms[oscillation->count++] = term;
    }
  }
  gsl_vector_free(straight);
  gsl_vector_free(load);
  gsl_vector_free(mode_force);
  return oscillation;
}

double oscillation_at(const void *data, double x) {
  const struct oscillation *oscillation = data;
  double force = 0;
  for (size_t i = 0; i < oscillation->count; i++) {
    const struct oscillation_term *term = &oscillation->terms[i];
    double n = x / oscillation->unit - term->start;
    if (n <= 0)
      continue;
    force += term->size * (term->phase > 0 ? n - sin(n * term->phase) / term->sine : n);
  }
  return force;
}

/* The straight lines, size (n - start), add up to a constant once the walls are at rest. */
double oscillation_mean(const struct oscillation *oscillation) {
  double mean = 0;
  for (size_t i = 0; i < oscillation->count; i++)
    mean -= oscillation->terms[i].size * oscillation->terms[i].start;
  return mean;
}

/* The amplitude of the sum of all waves with the phase of term i; 0 if an earlier term has that phase. Waves that start
 * at different cycles add as vectors. */
static double wave_amplitude(const struct oscillation *oscillation, size_t i) {
  double phase = oscillation->terms[i].phase, along = 0, across = 0;
  if (phase <= 0)
    return 0;
  for (size_t j = 0; j < oscillation->count; j++) {
    const struct oscillation_term *term = &oscillation->terms[j];
    if (fabs(term->phase - phase) > same_phase * phase)
      continue;
    if (j < i)
      return 0;
    along += term->size / term->sine * cos(term->start * phase);
    across += term->size / term->sine * sin(term->start * phase);
  }
  return hypot(along, across);
}

double oscillation_amplitude(const struct oscillation *oscillation) {
  double sum = 0;
  for (size_t i = 0; i < oscillation->count; i++)
    sum += wave_amplitude(oscillation, i);
  return sum;
}

/* A wave dominates when its amplitude and its slope exceed those of all others together: then the sum crosses its mean
 * as often as that wave alone, in the long run. */
double oscillation_frequency(const struct oscillation *oscillation) {
  double height = 0, slope = 0;
  for (size_t i = 0; i < oscillation->count; i++) {
    height += wave_amplitude(oscillation, i);
    slope += wave_amplitude(oscillation, i) * oscillation->terms[i].phase;
  }
  for (size_t i = 0; i < oscillation->count; i++) {
    double own = wave_amplitude(oscillation, i);
    double phase = oscillation->terms[i].phase;
    if (2 * own > height && 2 * own * phase > slope)
      return phase / (2 * M_PI);
  }
  return 0;
}
