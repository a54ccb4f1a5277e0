/* Reference: a standing wave in a periodic square or hexagonal lattice of equal discs or spheres, from given initial
 * velocities.
 *
 * In a wave of the wave vector q the particle at x, measured from the centre of the cell, has the displacement u =
 * U sin(q.x) and the rotation theta = psi cos(q.x). Neighbours i and j are s apart at rest, e is the unit vector from i
 * to j, and n is e turned counterclockwise. F is the normal force of their contact at rest. The displacements change
 * the force of this contact on i by
 *
 *   along e    k_n (u_j - u_i).e
 *   along n    k_s ((u_j - u_i).n - R (theta_i + theta_j)) - (F/s) (u_j - u_i).n
 *
 * The last term arises because F turns with the line of centres. Opposite directions e give equal terms, so the sums
 * run over one direction of each opposite pair, with the factor 2. With phi = s q.e the dynamical matrix K has the
 * blocks
 *
 *   K_uu = sum 2 (1 - cos phi) (k_n e e^T + (k_s - F/s) n n^T)
 *   K_up = -sum 2 k_s R sin phi n                K_pp = sum 2 k_s R^2 (1 + cos phi)
 *
 * for U and psi (^T for the transpose). The squares of the angular frequencies w are the eigenvalues of
 * M^(-1/2) K M^(-1/2), M = (m, m, I). Without rotation there is no psi. The motion begins with the velocities V and
 * without displacements, so the velocity in each mode varies as cos(w t).
 *
 * Returns, for D that monitors a particle:   D.vx, D.vy, D.spin versus time
 * Exact in continuous time for small amplitudes; terms of the order of u/s are neglected. A run of step dt is ahead of
 * this solution by the phase w t (w dt)^2/24.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"
#include "waves.h"

static void add(gsl_matrix *k, int i, int j, double value) { *gsl_matrix_ptr(k, (size_t)i, (size_t)j) += value; }

/* Adds the part of K that belongs to the contacts in the direction `angle`, rad, and in the opposite one. */
static void add_contacts(gsl_matrix *k, const struct waves_lattice *it, double angle, double qx, double qy) {
  const double e[2] = {cos(angle), sin(angle)}, n[2] = {-e[1], e[0]};
  const double phi = it->spacing * (qx * e[0] + qy * e[1]), across = it->ks - it->force / it->spacing;
  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 2; j++)
      add(k, i, j, 2 * (1 - cos(phi)) * (it->kn * e[i] * e[j] + across * n[i] * n[j]));
    if (it->rotates) /* GSL reads only the lower triangle of K */
      add(k, 2, i, -2 * it->ks * it->radius * sin(phi) * n[i]);
  }
  if (it->rotates)
    add(k, 2, 2, 2 * it->ks * it->radius * it->radius * (1 + cos(phi)));
}

/* A negative square of a frequency up to this fraction of the largest one is a rounding error of 0. */
static const double least_square = 1e-9;

struct waves_modes waves_modes(const struct waves_lattice *it, double qx, double qy) {
  struct waves_modes modes = {.count = it->rotates ? 3 : 2};
  const size_t n = (size_t)modes.count;
  const double root[WAVES_MODES] = {sqrt(it->mass), sqrt(it->mass), sqrt(it->inertia)};
  gsl_matrix *k = gsl_matrix_calloc(n, n), *shape = gsl_matrix_alloc(n, n);
  gsl_vector *square = gsl_vector_alloc(n);
  gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
  for (int d = 0; d < (it->hexagonal ? 3 : 2); d++)
    add_contacts(k, it, it->hexagonal ? d * M_PI / 3 : d * M_PI / 2, qx, qy);
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < n; j++)
      *gsl_matrix_ptr(k, i, j) /= root[i] * root[j];
  if (gsl_eigen_symmv(k, square, shape, work) != GSL_SUCCESS)
    gsl_matrix_set_all(shape, NAN);
  gsl_eigen_symmv_sort(square, shape, GSL_EIGEN_SORT_VAL_ASC);
  for (size_t m = 0; m < n; m++) {
    const double of_mode = gsl_vector_get(square, m);
    modes.omega[m] = of_mode < -least_square * gsl_vector_get(square, n - 1) ? NAN : sqrt(fmax(of_mode, 0));
    for (size_t i = 0; i < n; i++) {
      modes.shape[m][i] = gsl_matrix_get(shape, i, m) / root[i];
      modes.weight[m][i] = gsl_matrix_get(shape, i, m) * root[i];
    }
  }
  gsl_eigen_symmv_free(work);
  gsl_matrix_free(k), gsl_matrix_free(shape), gsl_vector_free(square);
  return modes;
}

/* ---- the scene ---- */

struct wave {
  struct waves_lattice lattice;
  double qx, qy;   /* 1/m */
  double start[2]; /* V, m/s */
};

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `lattice_waves` is for %s", what);
}

static double phase(const struct nb_scene *scene, const struct nb_particle *particle, double qx, double qy) {
  return qx * (particle->x - scene->cell.x) + qy * (particle->y - scene->cell.y);
}

/* Finds q and V such that the initial velocities are V sin(q.x); false: there are none. */
static bool find_wave(struct wave *it, const struct nb_scene *scene) {
  const int largest = (int)sqrt((double)scene->particle_count) / 2;
  for (int nx = 0; nx <= largest; nx++)
    for (int ny = nx > 0 ? -largest : 1; ny <= largest; ny++) {
      double vx = 0, vy = 0, squares = 0, error = 0, top = 0;
      it->qx = 2 * M_PI * nx / scene->cell.h[0], it->qy = 2 * M_PI * ny / scene->cell.h[3];
      for (size_t k = 0; k < scene->particle_count; k++) {
        const struct nb_particle *particle = &scene->particles[k];
        const double wave = sin(phase(scene, particle, it->qx, it->qy));
        vx += wave * particle->vx, vy += wave * particle->vy, squares += wave * wave;
      }
      it->start[0] = vx / squares, it->start[1] = vy / squares;
      for (size_t k = 0; k < scene->particle_count; k++) {
        const struct nb_particle *particle = &scene->particles[k];
        const double wave = sin(phase(scene, particle, it->qx, it->qy));
        error = fmax(error, hypot(particle->vx - wave * it->start[0], particle->vy - wave * it->start[1]));
        top = fmax(top, hypot(particle->vx, particle->vy));
      }
      if (error < 1e-9 * top)
        return true;
    }
  return false;
}

/* The number of the nearest neighbours of particle 1; of each particle the nearest periodic copy counts. *spacing:
 * their distance. */
static int neighbours(const struct nb_scene *scene, double *spacing) {
  int count = 0;
  *spacing = INFINITY;
  for (int pass = 0; pass < 2; pass++)
    for (size_t j = 1; j < scene->particle_count; j++) {
      double x = scene->particles[j].x - scene->particles[0].x, y = scene->particles[j].y - scene->particles[0].y;
      x -= scene->cell.h[0] * round(x / scene->cell.h[0]), y -= scene->cell.h[3] * round(y / scene->cell.h[3]);
      *spacing = pass ? *spacing : fmin(*spacing, hypot(x, y));
      count += pass && hypot(x, y) < *spacing * (1 + 1e-9);
    }
  return count;
}

static enum nb_status read_wave(struct wave *it, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *first = &scene->particles[0];
  const struct nb_stage *stage = &scene->stages[0];
  double spacing;
  if (scene->stage_count != 1)
    return refuse(error, "one stage");
  for (size_t k = 0; k < scene->particle_count; k++)
    if (scene->particles[k].radius != first->radius || scene->particles[k].material != first->material ||
        scene->particles[k].shape != first->shape)
      return refuse(error, "equal particles");
  const struct matter_pair pair = matter_pair(scene, first->material, first->material);
  if (pair.friction < 1e6)
    return refuse(error, "a friction of at least 1e6, so that no contact slides");
  const int count = neighbours(scene, &spacing);
  if ((count != 4 && count != 6) || spacing >= 2 * first->radius)
    return refuse(error, "a lattice in which every particle overlaps four or six others");
  it->lattice = (struct waves_lattice){.kn = pair.kn,
                                       .ks = pair.ks,
                                       .force = pair.kn * (2 * first->radius - spacing),
                                       .mass = matter_mass(scene, first),
                                       .inertia = matter_inertia(scene, first),
                                       .radius = first->radius,
                                       .spacing = spacing,
                                       .hexagonal = count == 6,
                                       .rotates = stage->rotation != NB_ROTATION_OFF};
  return find_wave(it, scene) ? NB_OK : refuse(error, "initial velocities that are one sine wave");
}

/* ---- curves ---- */

struct oscillation {
  int count;
  double omega[WAVES_MODES], amplitude[WAVES_MODES]; /* rad/s; m/s, for spin rad/s */
};

static double oscillation_at(const void *data, double time) {
  const struct oscillation *it = data;
  double sum = 0;
  for (int k = 0; k < it->count; k++)
    sum += it->amplitude[k] * cos(it->omega[k] * time);
  return sum;
}

static void add_curves(struct nb_solution *solution, const struct wave *it, const struct waves_modes *modes,
                       const char *monitor, double angle) {
  static const char *const names[WAVES_MODES] = {"vx", "vy", "spin"};
  for (int i = 0; i < WAVES_MODES; i++) {
    struct oscillation *oscillation = calloc(1, sizeof *oscillation);
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%s.%s", monitor, names[i]);
    for (int k = 0; oscillation && k < modes->count; k++) {
      const double mode = it->start[0] * modes->weight[k][0] + it->start[1] * modes->weight[k][1];
      oscillation->omega[k] = modes->omega[k];
      oscillation->amplitude[k] = mode * modes->shape[k][i] * (i < 2 ? sin(angle) : cos(angle));
      oscillation->count = modes->count;
    }
    solution_curve(solution, name, "time", oscillation_at, oscillation);
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct wave wave;
  if (read_wave(&wave, scene, error))
    return error->status;
  const struct waves_modes modes = waves_modes(&wave.lattice, wave.qx, wave.qy);
  for (int k = 0; k < modes.count; k++)
    if (isnan(modes.omega[k]))
      return refuse(error, "a stable lattice: this wave grows, because k_s is too small for the force of the contacts");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE)
      add_curves(solution, &wave, &modes, monitor->name, phase(scene, &scene->particles[monitor->a], wave.qx, wave.qy));
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_lattice_waves = {
    .name = "lattice_waves",
    .title = "standing waves in square and hexagonal lattices: eigenvalues of the dynamical matrix",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_FRICTION, HAS_ROTATION_OFF},
    .needs = {HAS_CELL},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
