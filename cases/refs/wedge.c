/* Reference: a particle at rest in the wedge of two plane walls without friction, under gravity.
 *
 *   N_1 n_1 + N_2 n_2 + m g = 0          n_i: unit normal of wall i, from the wall to the centre
 *   n_i (c - P_i) = R - N_i/k_i          c: the centre; P_i: a point of wall i; k_i: the stiffness of the contact
 *
 * The particle has the mass m and the radius R, and N_i is the force of wall i.
 *
 * The stiffness matrix k_1 n_1 n_1^T + k_2 n_2 n_2^T has no eigenvalue above its trace k_1 + k_2, so the calculation
 * cycle is stable up to 2 (m/(k_1 + k_2))^(1/2) in a wedge of any angle.
 *
 * Returns:
 *   C.normal, C.overlap in STAGE    for C that monitors a contact, at the end of the first stage, at rest
 *   D.x, D.y in STAGE               for D that monitors the particle, also at the end of the first stage
 *   step.stable in STAGE            2 (m/(k_1 + k_2))^(1/2)
 * Exact. Damping has no effect at rest. step.stable is the value for contacts without dashpots.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"
#include "single.h"

struct side {
  double nx, ny;   /* n_i */
  double gap;      /* n_i P_i, m */
  double k, force; /* k_i, in N/m; N_i, in N */
};

static struct side side_of(const struct nb_scene *scene, const struct nb_wall *wall) {
  const struct nb_particle *particle = &scene->particles[0];
  /* h0 is the distance of the line of the wall from its point, along the left normal (-ey, ex). */
  const double height = (particle->y - wall->y) * wall->ex - (particle->x - wall->x) * wall->ey - wall->h0;
  const double sign = copysign(1, height);
  struct side side = {.nx = -sign * wall->ey, .ny = sign * wall->ex};
  side.gap = side.nx * wall->x + side.ny * wall->y + sign * wall->h0;
  side.k = matter_pair(scene, particle->material, wall->material).kn;
  return side;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (scene->particle_count != 1 || scene->wall_count != 2)
    return nb_error_set(error, NB_BAD_USE, "the reference `wedge` is for one particle and two walls");
  const struct nb_particle *particle = &scene->particles[0];
  struct side one = side_of(scene, &scene->walls[0]), two = side_of(scene, &scene->walls[1]);
  const struct nb_gravity *gravity = scene->stages[0].gravity.line ? &scene->stages[0].gravity : &scene->gravity;
  const double m = matter_mass(scene, particle), wx = m * gravity->x, wy = m * gravity->y;
  const double turn = one.nx * two.ny - one.ny * two.nx;
  one.force = -(wx * two.ny - wy * two.nx) / turn, two.force = -(one.nx * wy - one.ny * wx) / turn;
  const double d1 = particle->radius - one.force / one.k + one.gap, d2 = particle->radius - two.force / two.k + two.gap;
  const double x = (d1 * two.ny - d2 * one.ny) / turn, y = (one.nx * d2 - two.nx * d1) / turn;
  if (!(one.force > 0 && two.force > 0) || !single_faces(&scene->walls[0], x, y) ||
      !single_faces(&scene->walls[1], x, y))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `wedge` is for a particle that rests on the faces of both walls");
  const char *stage = scene->stages[0].name;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const struct side *side = monitor->b == 0 ? &one : &two;
    if (monitor->kind == NB_MONITOR_PARTICLE_WALL) {
      single_add(solution, monitor->name, "normal", stage, side->force);
      single_add(solution, monitor->name, "overlap", stage, side->force / side->k);
    } else if (monitor->kind == NB_MONITOR_PARTICLE) {
      single_add(solution, monitor->name, "x", stage, x);
      single_add(solution, monitor->name, "y", stage, y);
    }
  }
  char name[2 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "step.stable in %s", stage);
  solution_value(solution, 2 * sqrt(m / (one.k + two.k)), name);
  return solution_status(solution, error);
}

const struct nb_reference reference_wedge = {
    .name = "wedge",
    .title = "a particle at rest in a wedge of two walls without friction: statics, and the guaranteed step",
    .source = "[CS79 20-25]",
    .accepts = {HAS_OFFSET_WALLS, HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_MASS_DAMPING, HAS_DAMPING_CHANGE,
                HAS_STEP_CHANGE, HAS_GRAVITY_CHANGE, HAS_ZERO_VELOCITIES, HAS_UNTIL},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
