/* Reference: a disc or sphere that bounces repeatedly on a spring and a dashpot, with its weight also during the
 * contact.
 *
 * In contact the overlap d obeys  m d'' + c d' + k d = m g,  with d = 0 and d' = v at first. With w^2 = k/m, the time t
 * in units of 1/w, u = w d/v, the damping ratio b, s = (1 - b^2)^(1/2) and eps = g/(w v),
 *
 *   u = exp(-b t) sin(s t)/s + eps (1 - exp(-b t) (cos s t + b/s sin s t))
 *
 * The contact ends at the first root of u after 0, with the speed -u' v, and the particle rises by (u' v)^2/(2 g).
 * The root is between the largest u, where tan s t = s/(b - eps), and the next smallest u, half a period later. To first
 * order in eps the coefficient of restitution e = -u' is
 *
 *   e = e_0 - 2 b (1 + e_0) eps,    e_0 = exp(-pi b/s)
 *
 * Returns, for D that monitors the particle:   D.y in STAGE, of each stage that ends at the top (`until D.vy below 0`)
 * Exact in continuous time. In a run with the time step dt (in seconds) the dashpot's force begins and ends up to half
 * a step too early or too late, and lags by half a step. For b < 0.3 the relative error of e is up to about
 * b w dt (2 + pi b/2), with w in 1/s.
 *
 * Source   [MFiX DEM-02].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

static double overlap(double b, double eps, double t) {
  const double s = sqrt(1 - b * b), fade = exp(-b * t), sine = sin(s * t) / s;
  return fade * sine + eps * (1 - fade * (cos(s * t) + b * sine));
}
static double approach(double b, double eps, double t) {
  const double s = sqrt(1 - b * b), fade = exp(-b * t), sine = sin(s * t) / s;
  return fade * (cos(s * t) - b * sine) + eps * fade * sine;
}

/* The coefficient of restitution; NAN: the weight keeps the particle on the wall. */
static double restitution(double b, double eps) {
  const double s = sqrt(1 - b * b);
  double low = atan2(s, b - eps) / s, high = low + 3.14159265358979323846 / s; /* u' = 0 at both */
  if (overlap(b, eps, high) >= 0)
    return NAN;
  for (;;) {
    const double t = (low + high) / 2;
    if (t <= low || t >= high)
      return -approach(b, eps, t);
    *(overlap(b, eps, t) > 0 ? &low : &high) = t;
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct single particle;
  if (single_read(&particle, "many_bounces", scene, error))
    return error->status;
  if (scene->gravity.x != 0 || !(particle.height > particle.radius) || !(particle.gravity_n > 0) ||
      !(particle.cn < 2 * sqrt(particle.pair.kn * particle.m)))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `many_bounces` is for a particle dropped straight down, from rest, with less "
                        "than critical damping");
  const double w = sqrt(particle.pair.kn / particle.m), b = particle.cn / (2 * particle.m * w), g = particle.gravity_n;
  double rise = particle.height - particle.radius; /* of the centre above first contact, m */
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->condition_count != 1 || stage->conditions[0].relation != NB_BELOW)
      continue;
    const double v = sqrt(2 * g * rise), e = restitution(b, g / (w * v));
    if (!isfinite(e))
      return nb_error_set(error, NB_BAD_USE,
                          "the reference `many_bounces` is for a particle that leaves the wall again");
    rise *= e * e;
    single_add(solution, particle.particle, "y", stage->name, scene->walls[0].y + particle.radius + rise);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_many_bounces = {
    .name = "many_bounces",
    .title = "heights of repeated bounces on a spring and a dashpot, with weight",
    .source = "[MFiX DEM-02]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_CONTACT_DAMPING, HAS_UNTIL},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
