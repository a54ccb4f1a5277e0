/* Reference: particles without contacts in an affine strain, with a boundary, in closed form.
 *                                                                                        [R89 4.41-4.44, sec. 4.5.2]
 *
 * A particle of the boundary follows the strain rate L. A particle inside follows it too and also has its own velocity
 * v, which only damping changes. With A = 1 + L dt, the position x_N from the centre after N cycles, and k the fraction
 * of v that damping leaves in one cycle:
 *
 *   x_N = A^N x_0 + dt k (A - k)^-1 (A^N - k^N) v_0                      v_0 = 0 on the boundary
 *                                            N A^(N-1) for (A - k)^-1 (A^N - k^N) along an axis on which A is k
 *   v_N = k^N (1 + k)/2 v_0                                              N >= 1: the mean of the half steps
 *   kinetic energy  sum m v_N^2/2 over the particles inside
 *   the area of the boundary is proportional to (det A)^N
 *
 * `accumulated`, R89's code for 4.43, adds L x to the velocity in every cycle and keeps it:
 * x_(N+1) = (2 + L dt) x_N - x_(N-1), x_1 = A x_0. Along an axis of L with the eigenvalue s, from rest and undamped:
 *
 *   x_N = x_0 (sinh((N+1) q) - sinh(N q))/sinh q,   cosh q = 1 + s dt/2, sinh(q/2) = (s dt)^(1/2)/2
 *
 * with sin, cos and (-s dt)^(1/2) if s < 0.
 *
 * L is symmetric; its axes and eigenvalues are GSL's.
 *
 * Returns, versus cycle:  D.x, D.y for D that monitors a particle, boundary.area and, without `accumulated`,
 * energy.kinetic.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

enum quantity { X, Y, AREA, KINETIC };

struct strained {
  double axis[2][2];    /* axis[k]: unit vector along the axis of eigenvalue k */
  double gain[2];       /* s dt */
  double keep;          /* fraction of v left after a cycle */
  double x[2], step[2]; /* x_0 from the centre, and v_0 dt, along the axes, m */
  double centre[2];     /* m */
  double level;         /* at cycle 0: area, m2, or kinetic energy, J */
  bool accumulated;
  enum quantity quantity;
};

/* x_N/x_0 along an axis, with `accumulated`, for N = n and s dt = gain. */
static double accumulated_growth(double gain, double n) {
  const double q = gain > 0 ? 2 * asinh(sqrt(gain) / 2) : 2 * asin(sqrt(-gain) / 2);
  if (gain == 0)
    return 1;
  return gain > 0 ? (sinh((n + 1) * q) - sinh(n * q)) / sinh(q) : (sin((n + 1) * q) - sin(n * q)) / sin(q);
}

static double at(const void *data, double n) {
  const struct strained *it = data;
  double x = 0, y = 0;
  if (it->quantity == AREA)
    return it->level * pow((1 + it->gain[0]) * (1 + it->gain[1]), n);
  if (it->quantity == KINETIC)
    return it->level * (n > 0 ? pow(it->keep, 2 * n) * (1 + it->keep) * (1 + it->keep) / 4 : 1);
  for (int k = 0; k < 2; k++) {
    const double a = 1 + it->gain[k], grown = pow(a, n);
    const double moved = a == it->keep ? n * pow(a, n - 1) : (grown - pow(it->keep, n)) / (a - it->keep);
    const double own = it->keep * moved * it->step[k];
    const double along = it->accumulated ? accumulated_growth(it->gain[k], n) * it->x[k] : grown * it->x[k] + own;
    x += along * it->axis[k][0], y += along * it->axis[k][1];
  }
  return it->quantity == X ? it->centre[0] + x : it->centre[1] + y;
}

static void add_value(struct nb_solution *solution, const struct strained *it, const char *name) {
  struct strained *copy = malloc(sizeof *copy);
  if (copy)
    *copy = *it;
  solution_curve(solution, name, "cycle", at, copy);
}

static void find_axes(struct strained *it, const struct nb_strain_rate *rate) {
  double full[4] = {rate->xx, rate->xy, rate->yx, rate->yy}, values[2], vectors[4];
  gsl_matrix_view m = gsl_matrix_view_array(full, 2, 2), v = gsl_matrix_view_array(vectors, 2, 2);
  gsl_vector_view e = gsl_vector_view_array(values, 2);
  gsl_eigen_symmv_workspace *workspace = gsl_eigen_symmv_alloc(2);
  if (gsl_eigen_symmv(&m.matrix, &e.vector, &v.matrix, workspace) != GSL_SUCCESS)
    gsl_vector_set_all(&e.vector, NAN);
  gsl_eigen_symmv_free(workspace);
  for (int k = 0; k < 2; k++)
    it->gain[k] = values[k], it->axis[k][0] = vectors[k], it->axis[k][1] = vectors[2 + k];
}

/* The fraction of v that damping leaves in one cycle; NAN: not known for this damping. */
static double kept_fraction(const struct nb_damping *damping) {
  switch (damping->global_kind) {
  case NB_GLOBAL_UNDAMPED:
    return 1;
  case NB_GLOBAL_CON1_CS79:
    return damping->global / (2 - damping->global);
  case NB_GLOBAL_CON1_VELOCITY:
  case NB_GLOBAL_CON1_ALL:
    return damping->global;
  default:
    return NAN;
  }
}

static bool equal_rates(const struct nb_strain_rate *a, const struct nb_strain_rate *b) {
  return a->xx == b->xx && a->xy == b->xy && a->yx == b->yx && a->yy == b->yy && a->per_cycle == b->per_cycle;
}

static bool on_boundary(const struct nb_scene *scene, const struct nb_particle *particle) {
  const struct nb_circle *circle = &scene->circle;
  return circle->line && hypot(particle->x - circle->x, particle->y - circle->y) >= circle->radius * (1 - 1e-12);
}

/* The area of the polygon through the particles of the boundary, which the page lists counterclockwise, m2. */
static double area(const struct nb_scene *scene) {
  const struct nb_particle *first = NULL, *last = NULL;
  double twice = 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    if (!on_boundary(scene, particle))
      continue;
    if (last)
      twice += last->x * particle->y - particle->x * last->y;
    first = first ? first : particle, last = particle;
  }
  return first ? (twice + last->x * first->y - first->x * last->y) / 2 : 0;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *stage = scene->stages;
  const struct nb_strain_rate *rate = &stage->affine.strain;
  struct strained it = {.centre = {scene->circle.x, scene->circle.y}, .accumulated = stage->affine.accumulated};
  if (scene->stage_count != 1 || !rate->per_cycle || rate->xy != rate->yx ||
      !equal_rates(rate, &stage->boundary.strain) || scene->step.kind != NB_STEP_TIME)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `ring_strain` is for one stage with the same symmetric strain per cycle in `boundary strain` "
        "and `affine strain`, and a step given as a time");
  it.keep = kept_fraction(&stage->damping);
  find_axes(&it, rate);
  double energy = 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    if (!on_boundary(scene, particle))
      energy += matter_mass(scene, particle) * (particle->vx * particle->vx + particle->vy * particle->vy) / 2;
  }
  if (!(it.keep < 1 || energy == 0) || (it.accumulated && (energy > 0 || it.keep < 1)))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `ring_strain` is for `damping con1` if particles have velocities, and for `accumulated` without "
        "damping and with "
        "particles at rest");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_PARTICLE)
      continue;
    const struct nb_particle *particle = &scene->particles[monitor->a];
    const double x = particle->x - it.centre[0], y = particle->y - it.centre[1];
    const double dt = on_boundary(scene, particle) ? 0 : scene->step.value;
    it.accumulated = stage->affine.accumulated && dt > 0;
    char name[2 * NB_NAME_SIZE];
    for (int k = 0; k < 2; k++) {
      it.x[k] = x * it.axis[k][0] + y * it.axis[k][1];
      it.step[k] = dt * (particle->vx * it.axis[k][0] + particle->vy * it.axis[k][1]);
    }
    it.quantity = X;
    snprintf(name, sizeof name, "%s.x", monitor->name), add_value(solution, &it, name);
    it.quantity = Y;
    snprintf(name, sizeof name, "%s.y", monitor->name), add_value(solution, &it, name);
  }
  it.quantity = AREA, it.level = area(scene);
  add_value(solution, &it, "boundary.area");
  it.quantity = KINETIC, it.level = energy;
  if (!stage->affine.accumulated)
    add_value(solution, &it, "energy.kinetic");
  return solution_status(solution, error);
}

const struct nb_reference reference_ring_strain = {
    .name = "ring_strain",
    .title = "particles in an affine strain, with velocities of their own, and R89's accumulated form, in closed form",
    .source = "[R89 4.41-4.44]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL,
                HAS_BOUNDARY_STRAIN, HAS_AFFINE_ACCUMULATED},
    .needs = {HAS_BOUNDARY, HAS_AFFINE_STRAIN},
    .normal = NB_ANY_LAW,
    .shear = "none",
    .solve = solve,
};
