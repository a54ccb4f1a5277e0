/* Reference: measures of regions at time 0 by their definitions, for particles with linear springs without friction.
 *
 * All pairs of particles are examined, O(n^2). With the overlap a = R_i + R_j - |x_i - x_j| > 0, the force N = k_n a
 * and the normal n, a particle i in the region adds for each of its contacts
 *
 *   N l n n/V      to the stress, with the distance l = R_i - a/2 to the contact and the volume V of the region
 *   n n/2M         to the fabric, with the number 2M of the contact ends in the region
 *   N n n/sum N    to the fabric weighted by the normal force
 *
 * Principal values and directions are GSL's eigenvalues and eigenvectors. The area of a particle in a region is the
 * integral over y, by quadrature, of the length of the horizontal line that lies in both. Rattlers are removed one by
 * one until none is left.
 *
 * Returns, for A that monitors a circle or a box, at 0 cycles:
 *   all components of A.stress, A.stress.contacts, A.fabric, A.fabric.normal; A.fabric.kk
 *   A.particles, contacts, coordination, coordination.mechanical, rattlers, normal.mean, max, min
 *   A.porosity, porosity.volume
 * Error: rounding; of the area of a particle in a region 1e-12, the relative tolerance of the quadrature.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

static bool inside(const struct nb_region *region, const struct nb_particle *particle) {
  const double x = particle->x - region->x, y = particle->y - region->y;
  if (region->kind == NB_REGION_CIRCLE)
    return hypot(x, y) <= region->radius;
  return fabs(x * region->ex + y * region->ey) <= region->half_x &&
         fabs(y * region->ex - x * region->ey) <= region->half_y;
}

static double overlap(const struct nb_particle *a, const struct nb_particle *b) {
  return a->radius + b->radius - hypot(a->x - b->x, a->y - b->y);
}

/* ---- area of a particle in a region ---- */

struct cut {
  const struct nb_region *region;
  double x, y, radius; /* of the particle, in the axes of the region, from the region's centre */
};

/* The length of the part of the line at height y that lies in the region and in the particle. */
static double common_length(double y, void *data) {
  const struct cut *cut = data;
  const double up = y - cut->y, a = sqrt(fmax(0, cut->radius * cut->radius - up * up));
  const double R = cut->region->radius;
  const double b = cut->region->kind == NB_REGION_BOX ? cut->region->half_x : sqrt(fmax(0, R * R - y * y));
  return fmax(0, fmin(cut->x + a, b) - fmax(cut->x - a, -b));
}

static double area_inside(const struct nb_region *region, const struct nb_particle *particle) {
  const double x = particle->x - region->x, y = particle->y - region->y, R = region->radius;
  struct cut cut = {region, x, y, particle->radius};
  const bool box = region->kind == NB_REGION_BOX;
  if (box)
    cut.x = x * region->ex + y * region->ey, cut.y = y * region->ex - x * region->ey;
  else
    cut.x = hypot(x, y), cut.y = 0; /* rotated so that the particle lies in +x */
  const double half = box ? region->half_y : R;
  const double low = fmax(-half, cut.y - particle->radius), high = fmin(half, cut.y + particle->radius);
  if (!(high > low))
    return 0;
  gsl_integration_cquad_workspace *workspace = gsl_integration_cquad_workspace_alloc(200);
  gsl_function f = {common_length, &cut};
  double sum = 0, error = 0;
  if (!workspace || gsl_integration_cquad(&f, low, high, 1e-13 * pi * particle->radius * particle->radius, 1e-12,
                                          workspace, &sum, &error, NULL) != GSL_SUCCESS)
    sum = NAN;
  gsl_integration_cquad_workspace_free(workspace);
  return sum;
}

/* ---- values ---- */

static void add_value(struct nb_solution *solution, const char *region, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s at 0 cycles", region, what);
  solution_value(solution, value, name);
}

/* Adds components, principal values and the direction of the major one of t = (xx, xy, yy). `deviator` is the name of
 * major minus minor. */
static void add_tensor(struct nb_solution *solution, const char *region, const char *what, const double t[3],
                       const char *deviator) {
  double both[] = {t[0], t[1], t[1], t[2]}, major = 0, minor = 0, x = 1, y = 0;
  gsl_matrix_view matrix = gsl_matrix_view_array(both, 2, 2);
  gsl_eigen_symmv_workspace *workspace = gsl_eigen_symmv_alloc(2);
  gsl_vector *values = gsl_vector_alloc(2);
  gsl_matrix *vectors = gsl_matrix_alloc(2, 2);
  if (gsl_eigen_symmv(&matrix.matrix, values, vectors, workspace) != GSL_SUCCESS)
    gsl_vector_set_all(values, NAN);
  gsl_eigen_symmv_sort(values, vectors, GSL_EIGEN_SORT_VAL_DESC);
  major = gsl_vector_get(values, 0), minor = gsl_vector_get(values, 1);
  x = gsl_matrix_get(vectors, 0, 0), y = gsl_matrix_get(vectors, 1, 0);
  gsl_eigen_symmv_free(workspace), gsl_vector_free(values), gsl_matrix_free(vectors);
  const struct {
    const char *name;
    double value;
  } rows[] = {{"xx", t[0]},
              {"xy", t[1]},
              {"yx", t[1]},
              {"yy", t[2]},
              {"major", major},
              {"minor", minor},
              {deviator, major - minor},
              {"angle", atan(y / x)},
              {"mean", (major + minor) / 2},
              {"sinphi", (major - minor) / (major + minor)}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char name[2 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%s.%s", what, rows[k].name);
    add_value(solution, region, name, rows[k].value);
  }
}

/* ---- a region ---- */

struct sums {
  double stress[3], fabric[3], weighted[3];        /* xx, xy, yy */
  double particles, ends, contacts, force, radius; /* numbers; sum of N over contact ends, N; sum of radii, m */
  double covered, volume;                          /* area and volume of particles, m2 and m3 */
  double mean, largest, smallest;                  /* of the contact forces, N; `mean` is their sum */
};

static void add(double t[3], double weight, double x, double y) {
  t[0] += weight * x * x, t[1] += weight * x * y, t[2] += weight * y * y;
}

/* Adds the contact of particle i, which is in the region, with j, if they touch. If j is in the region, too, the pair
 * has two contact ends and counts as one contact. */
static void add_pair(struct sums *sums, const struct nb_scene *scene, const struct nb_region *region, size_t i,
                     size_t j) {
  const struct nb_particle *a = &scene->particles[i], *b = &scene->particles[j];
  const double deep = overlap(a, b), apart = hypot(b->x - a->x, b->y - a->y);
  if (!(deep > 0))
    return;
  const double force = matter_pair(scene, a->material, b->material).kn * deep;
  const double x = (b->x - a->x) / apart, y = (b->y - a->y) / apart;
  add(sums->stress, force * (a->radius - deep / 2), x, y);
  add(sums->fabric, 1, x, y);
  add(sums->weighted, force, x, y);
  sums->ends++, sums->force += force;
  if (inside(region, b) && j < i)
    return;
  sums->contacts++, sums->mean += force;
  sums->largest = fmax(sums->largest, force), sums->smallest = fmin(sums->smallest, force);
}

/* Sets rattles[i], and touching[i], the number of contacts with particles that are not rattlers. */
static void find_rattlers(const struct nb_scene *scene, bool rattles[], int touching[]) {
  for (bool more = true; more;) {
    more = false;
    for (size_t i = 0; i < scene->particle_count; i++) {
      touching[i] = 0;
      for (size_t j = 0; j < scene->particle_count; j++)
        touching[i] += i != j && !rattles[j] && overlap(&scene->particles[i], &scene->particles[j]) > 0;
      if (!rattles[i] && touching[i] < 2 && !scene->particles[i].fixed)
        rattles[i] = more = true;
    }
  }
}

static double thickness_of(const struct nb_scene *scene) {
  double sum = 0;
  for (size_t i = 0; i < scene->particle_count; i++)
    sum += scene->particles[i].shape == NB_SPHERE ? 2 * scene->particles[i].radius : 1;
  return sum / (double)scene->particle_count;
}

static void add_region(struct nb_solution *solution, const struct nb_scene *scene, const char *name,
                       const struct nb_region *region, const bool rattles[], const int touching[]) {
  struct sums sums = {.smallest = INFINITY};
  double rattlers = 0, loaded = 0;
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *particle = &scene->particles[i];
    const double part = area_inside(region, particle);
    sums.covered += part;
    sums.volume += part * (particle->shape == NB_SPHERE ? 4. / 3 * particle->radius : 1);
    if (!inside(region, particle))
      continue;
    sums.particles++, sums.radius += particle->radius;
    rattlers += rattles[i], loaded += rattles[i] ? 0 : touching[i];
    for (size_t j = 0; j < scene->particle_count; j++)
      if (j != i)
        add_pair(&sums, scene, region, i, j);
  }
  const bool box = region->kind == NB_REGION_BOX;
  const double area = box ? 4 * region->half_x * region->half_y : pi * region->radius * region->radius;
  const double thickness = thickness_of(scene), volume = area * thickness;
  for (int k = 0; k < 3; k++)
    sums.stress[k] /= volume, sums.fabric[k] /= sums.ends, sums.weighted[k] /= sums.force;
  add_tensor(solution, name, "stress", sums.stress, "deviator");
  add_tensor(solution, name, "stress.contacts", sums.stress, "deviator");
  add_tensor(solution, name, "fabric", sums.fabric, "anisotropy");
  add_tensor(solution, name, "fabric.normal", sums.weighted, "anisotropy");
  add_value(solution, name, "fabric.kk", sums.ends * sums.radius / sums.particles / volume);
  add_value(solution, name, "particles", sums.particles);
  add_value(solution, name, "contacts", sums.contacts);
  add_value(solution, name, "coordination", sums.ends / sums.particles);
  add_value(solution, name, "coordination.mechanical", loaded / (sums.particles - rattlers));
  add_value(solution, name, "rattlers", rattlers);
  add_value(solution, name, "normal.mean", sums.mean / sums.contacts);
  add_value(solution, name, "normal.max", sums.largest);
  add_value(solution, name, "normal.min", sums.smallest);
  add_value(solution, name, "porosity", 1 - sums.covered / area);
  add_value(solution, name, "porosity.volume", 1 - sums.volume / volume);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  bool *rattles = calloc(scene->particle_count, sizeof *rattles);
  int *touching = calloc(scene->particle_count, sizeof *touching);
  solution->incomplete = solution->incomplete || !rattles || !touching;
  if (rattles && touching)
    find_rattlers(scene, rattles, touching);
  for (size_t w = 0; w < scene->monitor_count && rattles && touching; w++)
    if (scene->monitors[w].kind == NB_MONITOR_REGION && scene->regions[scene->monitors[w].a].kind <= NB_REGION_BOX)
      add_region(solution, scene, scene->monitors[w].name, &scene->regions[scene->monitors[w].a], rattles, touching);
  free(rattles), free(touching);
  return solution_status(solution, error);
}

const struct nb_reference reference_measures = {
    .name = "measures",
    .title = "stress, fabric, coordination and porosity of regions at time 0, by their definitions, pair by pair",
    .source = "[R89 4.45-4.54]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
