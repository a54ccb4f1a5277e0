/* Reference: head-on impact of two spheres with Hertz's law, computed with R89's time step.
 *
 * The distance s of the centres and its rate u obey one recursion, with the reduced mass M* and the overlap
 * a = R_x + R_y - s:
 *
 *   u_(N+1/2) = u_(N-1/2) + (4/3) E* R*^(1/2) a_N^(3/2) dt/M*,   s_(N+1) = s_N + u_(N+1/2) dt          [CS79 22, 22a]
 *
 * until they separate; there is no force at time 0. The sum of their momenta is constant. dt is a fraction of
 * pi R (rho/G)^(1/2)/(0.1631 nu + 0.876605) with the mean radius R of all particles [R89 4.33, 4.34].
 *
 * A collision has few steps, and the solution has the same discretization error as the run. So it checks the time step
 * and not the law.
 *
 * Returns D.vx at the end, for D that monitors particle 1 or 2.
 * Accepts one material, particles 1 and 2 that begin apart and collide along x without touching others, and
 * `step F of rayleigh-fit-mean`. Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

static double step_of(const struct nb_scene *scene) {
  const struct nb_material *of = &scene->materials[scene->particles[0].material];
  const double shear = of->young / (2 * (1 + of->poisson));
  double radius = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    radius += scene->particles[k].radius / (double)scene->particle_count;
  return scene->step.value * pi * radius * sqrt(of->density / shear) / (0.1631 * of->poisson + 0.876605);
}

/* The velocity of y relative to x after separation; NAN: they do not separate within `most` cycles. `young` is E*,
 * `mass` M*. */
static double separation_velocity(const struct nb_particle *x, const struct nb_particle *y, double young, double mass,
                                  double dt, unsigned long most) {
  const double touch = x->radius + y->radius, radius = x->radius * y->radius / touch;
  double s = y->x - x->x, u = y->vx - x->vx;
  do {
    if (most-- == 0)
      return NAN;
    const double a = touch - s;
    u += a > 0 ? 4. / 3 * young * sqrt(radius * a) * a * dt / mass : 0;
    s += u * dt;
  } while (s < touch || u < 0);
  return u;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *x = &scene->particles[0], *y = &scene->particles[1];
  if (scene->particle_count < 2 || scene->material_count != 1 || scene->step.kind != NB_STEP_RAYLEIGH_FIT_MEAN ||
      !(x->vx > y->vx) || !(y->x - x->x > x->radius + y->radius) || x->y != y->y || x->vy != 0 || y->vy != 0)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `rayleigh_cycle` is for two particles of one material that collide along x, and `step F of "
        "rayleigh-fit-mean`");
  const double m[2] = {matter_mass(scene, x), matter_mass(scene, y)}, sum = m[0] + m[1];
  const double young = matter_pair(scene, x->material, y->material).young;
  unsigned long cycles = 0;
  for (size_t k = 0; k < scene->stage_count; k++)
    cycles += scene->stages[k].cycles;
  const double apart = separation_velocity(x, y, young, m[0] * m[1] / sum, step_of(scene), cycles);
  if (!isfinite(apart))
    return nb_error_set(error, NB_BAD_USE,
                        "the particles have not collided and separated within the %lu cycles of the scene", cycles);
  const double centre = (m[0] * x->vx + m[1] * y->vx) / sum;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    char name[3 * NB_NAME_SIZE];
    if (monitor->kind != NB_MONITOR_PARTICLE || monitor->a > 1)
      continue;
    snprintf(name, sizeof name, "%s.vx", monitor->name);
    solution_value(solution, centre + apart * (monitor->a ? m[0] : -m[1]) / sum, name);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_rayleigh_cycle = {
    .name = "rayleigh_cycle",
    .title = "head-on impact of two spheres by the calculation cycle with R89's step",
    .source = "[CS79 22, 22a] [R89 3.13, 4.33, 4.34]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
