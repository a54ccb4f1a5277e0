/* Reference: elastic spheres in a row between two walls at rest.
 *
 * The force F is the same at all contacts, and the overlaps add up to the difference between the sum of the diameters
 * and the distance L of the walls:
 *
 *   sum (F/K_c)^(2/3) = sum 2 R_i - L,     K_c = (4/3) E* sqrt(R*)              [Hertz; R89 5.5]
 *
 * The stiffness of a contact is k_c = (3/2) K_c^(2/3) F^(1/3). S_i is the sum of the stiffnesses of the two contacts of
 * sphere i, divided by its mass m_i; S of a wall is 0. Let w^2 be the largest sum S_i + S_j over the contacts of i and
 * j. w^2 is an upper bound of the squares of the angular frequencies of the row.
 *
 * Returns:
 *   C.normal, C.overlap    for C that monitors the contact of two spheres
 *   step.stable            2/w, the guaranteed stable step without dashpots
 * Exact. Accepts a row along x whose spheres the page defines from left to right.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"
#include "single.h"

/* K_c between sphere c - 1 and sphere c, N/m^(3/2); walls are to the left of sphere 0 and to the right of the last
 * one. */
static double hertz_constant(const struct nb_scene *scene, size_t c) {
  const struct nb_particle *left = c > 0 ? &scene->particles[c - 1] : NULL;
  const struct nb_particle *right = c < scene->particle_count ? &scene->particles[c] : NULL;
  const struct nb_wall *wall = &scene->walls[left ? 1 : 0];
  const struct matter_pair pair =
      matter_pair(scene, left ? left->material : wall->material, right ? right->material : wall->material);
  const double radius = matter_radius(left ? left->radius : INFINITY, right ? right->radius : INFINITY);
  return 4 / 3. * pair.young * sqrt(radius);
}

static bool fits(const struct nb_scene *scene) {
  if (scene->wall_count != 2 || scene->walls[0].ex != 0 || scene->walls[1].ex != 0 || scene->particle_count < 2)
    return false;
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *p = &scene->particles[i];
    if (p->y != scene->particles[0].y || !(p->x > (i > 0 ? p[-1].x : scene->walls[0].x)))
      return false;
  }
  return scene->particles[scene->particle_count - 1].x < scene->walls[1].x;
}

/* S_i, 1/s2 */
static double rate2(const struct nb_scene *scene, size_t i, double force) {
  const double k =
      1.5 * cbrt(force) * (pow(hertz_constant(scene, i), 2 / 3.) + pow(hertz_constant(scene, i + 1), 2 / 3.));
  return k / matter_mass(scene, &scene->particles[i]);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const size_t n = scene->particle_count;
  if (!fits(scene))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `hertz_row` is for a row of spheres along x, from a first wall to a second one");
  double overlap = scene->walls[0].x - scene->walls[1].x, compliance = 0, largest = 0;
  for (size_t i = 0; i < n; i++)
    overlap += 2 * scene->particles[i].radius;
  for (size_t c = 0; c <= n; c++)
    compliance += pow(hertz_constant(scene, c), -2 / 3.);
  if (!(overlap > 0))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `hertz_row` is for a row that is longer than the distance between its walls");
  const double force = pow(overlap / compliance, 1.5);
  for (size_t i = 0; i + 1 < n; i++)
    largest = fmax(largest, rate2(scene, i, force) + rate2(scene, i + 1, force));
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const int a = monitor->a, b = monitor->b;
    if (monitor->kind != NB_MONITOR_PARTICLE_PARTICLE || (a != b + 1 && b != a + 1))
      continue;
    const size_t c = (size_t)(a > b ? a : b);
    single_add(solution, monitor->name, "normal", NULL, force);
    single_add(solution, monitor->name, "overlap", NULL, pow(force / hertz_constant(scene, c), 2 / 3.));
  }
  solution_value(solution, 2 / sqrt(largest), "step.stable");
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_row = {
    .name = "hertz_row",
    .title = "elastic spheres of unlike moduli in a row between two walls: Hertz's springs in series",
    .source = "[R89 5.5]",
    .accepts = {HAS_SPHERES, HAS_MASS_DAMPING, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
