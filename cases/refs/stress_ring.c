/* Reference: six elastic spheres around a seventh, compressed by a boundary stress.        [R89 4.7, 5.5, sec. 6.4.1]
 *
 * The six are the boundary. Their radii are R_1 and R_2 in turn (possibly equal), and their distances from the sphere
 * in the middle, of radius R_0, are d_1 and d_2. By symmetry there are three contact forces: middle with 1, middle with
 * 2, and 1 with 2. The centres of 1 and 2 are s = (d_1^2 + d_2^2 - d_1 d_2)^(1/2) apart. Equilibrium under the boundary
 * stress p requires
 *
 *   N_01 + 2 N_12 (d_1 - d_2/2)/s = p h d_2 3^(1/2)/2           and the same with 1 and 2 exchanged
 *   N = 4/3 E* R*^(1/2) (R_x + R_y - distance)^(3/2)            or 0 without overlap
 *
 * h is the mean diameter. p acts on the sides of the hexagon of the six centres. A particle carries the load of the
 * nearer half of each of its two sides. The chord of these two halves is half of the distance between its two
 * neighbours, which is 3^(1/2) d_2 for a particle 1. If all spheres are equal, N = 3^(1/2)/4 p d h. d_1 and d_2 are
 * found by Powell's hybrid method (GSL, hybrids). The boundary has
 *
 *   radius = (d_1 + d_2)/2,   roughness = |d_1 - d_2|/(d_1 + d_2),   area = 3/2 3^(1/2) d_1 d_2,   mean stress p
 *
 * Returns, at the end of the last stage:
 *   C.normal                                                        for C that monitors a contact
 *   boundary.radius, .roughness, .area, .stress.mean
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_multiroots.h>
#include <math.h>

#include "hertz.h"

struct ring {
  double radius[3]; /* of the middle one, of 1, of 2, m */
  double young;     /* E*, Pa */
  double load;      /* p h 3^(1/2)/2, N/m */
};

static double normal(const struct ring *ring, int a, int b, double distance) {
  const double ra = ring->radius[a], rb = ring->radius[b], overlap = ra + rb - distance;
  return overlap > 0 ? 4 / 3. * ring->young * sqrt(ra * rb / (ra + rb)) * overlap * sqrt(overlap) : 0;
}

static double between(double d1, double d2) { return sqrt(d1 * d1 + d2 * d2 - d1 * d2); }

/* Residuals of the two equations, divided by the load. The unknowns are the overlaps with the middle sphere, divided by
 * R_0, so that both are of similar size. */
static int residuals(const gsl_vector *at, void *data, gsl_vector *residual) {
  const struct ring *ring = data;
  const double r0 = ring->radius[0];
  const double d1 = r0 + ring->radius[1] - r0 * gsl_vector_get(at, 0);
  const double d2 = r0 + ring->radius[2] - r0 * gsl_vector_get(at, 1), s = between(d1, d2);
  const double side = 2 * normal(ring, 1, 2, s) / s;
  gsl_vector_set(residual, 0, (normal(ring, 0, 1, d1) + side * (d1 - d2 / 2)) / (ring->load * d2) - 1);
  gsl_vector_set(residual, 1, (normal(ring, 0, 2, d2) + side * (d2 - d1 / 2)) / (ring->load * d1) - 1);
  return GSL_SUCCESS;
}

static bool solve_equations(struct ring *ring, double *d1, double *d2) {
  gsl_multiroot_fsolver *solver = gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, 2);
  gsl_multiroot_function function = {residuals, 2, ring};
  gsl_vector *at = gsl_vector_alloc(2);
  const double force = ring->load * ring->radius[0]; /* the contact force if all spheres are equal */
  const double guess = pow(force / (4 / 3. * ring->young * sqrt(ring->radius[0] / 2)), 2 / 3.) / ring->radius[0];
  gsl_vector_set_all(at, guess);
  gsl_multiroot_fsolver_set(solver, &function, at);
  int status = GSL_CONTINUE;
  for (int n = 0; n < 100 && status == GSL_CONTINUE; n++)
    status = gsl_multiroot_fsolver_iterate(solver) ? GSL_EFAILED : gsl_multiroot_test_residual(solver->f, 1e-11);
  *d1 = ring->radius[0] + ring->radius[1] - ring->radius[0] * gsl_vector_get(solver->x, 0);
  *d2 = ring->radius[0] + ring->radius[2] - ring->radius[0] * gsl_vector_get(solver->x, 1);
  gsl_multiroot_fsolver_free(solver), gsl_vector_free(at);
  return status == GSL_SUCCESS;
}

/* The kind of a particle: 0 for the middle sphere, 1 and 2 in turn for the others. */
static int kind(size_t particle) { return particle == 0 ? 0 : particle % 2 ? 1 : 2; }

static bool is_ring(const struct nb_scene *scene) {
  if (scene->particle_count != 7)
    return false;
  for (size_t k = 0; k < 7; k++)
    if (scene->particles[k].radius != scene->particles[k < 3 ? k : 2 - k % 2].radius ||
        scene->particles[k].material != scene->particles[0].material)
      return false;
  return true;
}

static void add_value(struct nb_solution *solution, const struct nb_scene *scene, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%.100s in %.63s", what, scene->stages[scene->stage_count - 1].name);
  solution_value(solution, value, name);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_boundary *load = &scene->stages[scene->stage_count - 1].boundary;
  if (!is_ring(scene) || !load->line || load->sxx != load->syy || load->sxy != 0)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `stress_ring` is for six spheres of two sizes in turn around a seventh, and an "
                        "isotropic boundary "
                        "stress");
  struct ring ring;
  double h = 0, d1, d2;
  for (size_t k = 0; k < 7; k++)
    h += 2 * scene->particles[k].radius / 7;
  for (size_t k = 0; k < 3; k++)
    ring.radius[k] = scene->particles[k].radius;
  ring.young = matter_pair(scene, scene->particles[0].material, scene->particles[0].material).young;
  ring.load = load->sxx * h * sqrt(3) / 2;
  if (!solve_equations(&ring, &d1, &d2))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `stress_ring` finds no equilibrium of these spheres under this stress");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    char name[2 * NB_NAME_SIZE + 1];
    if (monitor->kind != NB_MONITOR_PARTICLE_PARTICLE)
      continue;
    const int a = kind((size_t)monitor->a), b = kind((size_t)monitor->b);
    const double distance = a && b ? between(d1, d2) : a + b == 1 ? d1 : d2;
    snprintf(name, sizeof name, "%.63s.normal", monitor->name);
    add_value(solution, scene, name, normal(&ring, a, b, distance));
  }
  add_value(solution, scene, "boundary.radius", (d1 + d2) / 2);
  add_value(solution, scene, "boundary.roughness", fabs(d1 - d2) / (d1 + d2));
  add_value(solution, scene, "boundary.area", 1.5 * sqrt(3) * d1 * d2);
  add_value(solution, scene, "boundary.stress.mean", load->sxx);
  return solution_status(solution, error);
}

const struct nb_reference reference_stress_ring = {
    .name = "stress_ring",
    .title = "six elastic spheres around a seventh under a boundary stress, from equilibrium",
    .source = "[R89 4.7, 5.5]",
    .accepts = {HAS_SPHERES, HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_UNTIL},
    .needs = {HAS_BOUNDARY, HAS_BOUNDARY_STRESS},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
