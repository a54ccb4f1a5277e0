/* Reference: what the calculation cycle with R89's step makes of two spheres that meet head-on by Hertz's law.
 *
 * The distance s of the centres and its rate u obey one equation, with the reduced mass M* and the overlap a = R_x + R_y - s:
 *
 *   u_(N+1/2) = u_(N-1/2) + (4/3) E* R*^(1/2) a_N^(3/2) dt/M*,   s_(N+1) = s_N + u_(N+1/2) dt          [CS79 22, 22a]
 *
 * until they are apart again; the first kick, at time 0, meets no force. The sum of their momenta stays. dt is a share of
 * pi R (rho/G)^(1/2)/(0.1631 nu + 0.876605) with the mean radius of all bodies [R89 4.33, 4.34].
 *
 * It judges no law but the step: how far a run with so few points is from Hertz is what it knows.
 *
 * Known    NAME.vx of bodies 1 and 2 where they are watched, at the end; exact but for rounding.
 * Range    one material; bodies 1 and 2 begin apart and meet along x, undisturbed; `step F of rayleigh-fit-mean`.
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

/* The rate at which the two part; NAN: not within so many cycles. */
static double parting(const struct nb_particle *x, const struct nb_particle *y, double young, double mass, double dt,
                      unsigned long most) {
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
      !(x->vx > y->vx) || !(y->x - x->x > x->radius + y->radius) || x->y < y->y || x->y > y->y)
    return nb_error_set(error, NB_BAD_USE,
                        "reference rayleigh_cycle is for two bodies of one material that meet along x, and `step F of "
                        "rayleigh-fit-mean`");
  const double m[2] = {matter_mass(scene, x), matter_mass(scene, y)}, sum = m[0] + m[1];
  const double young = matter_pair(scene, x->material, y->material).young;
  unsigned long cycles = 0;
  for (size_t k = 0; k < scene->stage_count; k++)
    cycles += scene->stages[k].cycles;
  const double apart = parting(x, y, young, m[0] * m[1] / sum, step_of(scene), cycles);
  if (!isfinite(apart))
    return nb_error_set(error, NB_BAD_USE, "the two have not met and parted in the %lu cycles of the scene", cycles);
  const double centre = (m[0] * x->vx + m[1] * y->vx) / sum;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    char name[3 * NB_NAME_SIZE];
    if (monitor->kind != NB_MONITOR_PARTICLE || monitor->a > 1)
      continue;
    snprintf(name, sizeof name, "%s.vx", monitor->name);
    solution_value(solution, centre + apart * (monitor->a ? m[0] : -m[1]) / sum, name);
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_rayleigh_cycle = {
    .name = "rayleigh_cycle",
    .title = "two spheres that meet head-on, by the calculation cycle with R89's step",
    .source = "[CS79 22, 22a] [R89 3.13, 4.33, 4.34]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
