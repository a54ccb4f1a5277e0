/* Reference: a rigid particle on a plane whose inclination increases: it rolls, or slides and rotates.
 *
 * Gravity has the component p along the plane and n into it. v is the velocity along the plane, w the angular velocity
 * and q = m R^2/I. Friction F gives m v' = m p - F and R w' = -q F/m, so
 *
 *   rolling   F = m p/(1 + q),   v' = p q/(1 + q)      while F <= mu m n, that is p <= (1 + q) mu n:
 *                                                      tan of the angle at most 3 mu for a disc, 7/2 mu for a sphere
 *   sliding   F = mu m n,        v' = p - mu n,   R w' = -q mu n
 *
 * p and n change linearly in a stage that ramps gravity, and are constant otherwise. The velocities are their
 * integrals.
 *
 * Returns, for D that monitors the particle:   D.vx, D.spin versus time and at the end of each stage
 * Refuses a particle that rolls again after it has slid, or that slides in -x.
 * Error: with springs a rolling particle has v + R w = F'/k_s, the rate at which the deflection of the shear spring
 * grows. So v is larger by F'/((1 + q) k_s), and R |w| is smaller by q times this. When the ramp ends, the velocities
 * oscillate about their values; a dashpot damps this oscillation.
 *
 * Source   elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

enum { STAGES = 32 };

struct plane {
  double q, mu, radius;
  int count;
  double begin[STAGES + 1];          /* s */
  double p[STAGES][2], n[STAGES][2]; /* at the beginning and at the end of each stage, m/s2 */
};

/* The integral of p or n over the first `fraction` of a stage, divided by the length of the stage; `ends` are its first
 * and last value. */
static double integral(const double ends[2], double fraction) {
  return fraction * (ends[0] + (ends[1] - ends[0]) * fraction / 2);
}

/* The fraction of a stage after which p exceeds (1 + q) mu n; 1: p never does. */
static double sliding_begin(const struct plane *f, int s) {
  const double first = f->p[s][0] - (1 + f->q) * f->mu * f->n[s][0],
               last = f->p[s][1] - (1 + f->q) * f->mu * f->n[s][1];
  if (first > 0)
    return 0;
  return last > 0 ? first / (first - last) : 1;
}

static void velocities(const struct plane *f, double t, double *v, double *spin) {
  double w = 0;
  *v = 0;
  for (int s = 0; s < f->count && t > f->begin[s]; s++) {
    const double length = f->begin[s + 1] - f->begin[s];
    const double fraction = t < f->begin[s + 1] ? (t - f->begin[s]) / length : 1, slides = sliding_begin(f, s);
    const double rolls = fraction < slides ? fraction : slides;
    const double down = length * (integral(f->p[s], fraction) - integral(f->p[s], rolls));
    const double grip = f->mu * length * (integral(f->n[s], fraction) - integral(f->n[s], rolls));
    const double rolled = length * integral(f->p[s], rolls) * f->q / (1 + f->q);
    *v += rolled + down - grip;
    w -= (rolled + f->q * grip) / f->radius;
  }
  *spin = w;
}

static double vx_at(const void *data, double t) {
  double v, spin;
  velocities(data, t, &v, &spin);
  return v;
}
static double spin_at(const void *data, double t) {
  double v, spin;
  velocities(data, t, &v, &spin);
  return spin;
}

/* The reference does not cover a particle that slides in -x, or that rolls again after sliding. */
static bool slides_to_the_end(const struct plane *f) {
  bool slides = false;
  for (int s = 0; s < f->count; s++) {
    for (int end = 0; end < 2; end++)
      if (f->p[s][end] < -(1 + f->q) * f->mu * f->n[s][end])
        return false;
    slides = slides || sliding_begin(f, s) < 1;
    if (slides && !(f->p[s][1] > (1 + f->q) * f->mu * f->n[s][1]))
      return false;
  }
  return true;
}

/* False: there are more than STAGES stages. */
static bool read_stages(struct plane *f, const struct nb_scene *scene, double step) {
  double p = scene->gravity.x, n = -scene->gravity.y;
  if (scene->stage_count > STAGES)
    return false;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const bool changes = stage->gravity.line > 0, ramps = stage->gravity.ramp;
    f->p[s][1] = changes ? stage->gravity.x : p, f->n[s][1] = changes ? -stage->gravity.y : n;
    f->p[s][0] = ramps ? p : f->p[s][1], f->n[s][0] = ramps ? n : f->n[s][1];
    p = f->p[s][1], n = f->n[s][1];
    f->begin[s + 1] = f->begin[s] + step * (double)stage->cycles;
    f->count = (int)s + 1;
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct single particle;
  if (single_read(&particle, "incline", scene, error))
    return error->status;
  struct plane plane = {.q = particle.q, .mu = particle.pair.friction, .radius = particle.radius};
  if (!read_stages(&plane, scene, particle.step) || !slides_to_the_end(&plane))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `incline` is for up to %d stages, and a particle that slides only in +x and does not roll again",
        STAGES);
  for (int s = 0; s < plane.count; s++) {
    single_add(solution, particle.particle, "vx", scene->stages[s].name, vx_at(&plane, plane.begin[s + 1]));
    single_add(solution, particle.particle, "spin", scene->stages[s].name, spin_at(&plane, plane.begin[s + 1]));
  }
  single_curve(solution, particle.particle, "vx", vx_at, &plane, sizeof plane);
  single_curve(solution, particle.particle, "spin", spin_at, &plane, sizeof plane);
  return solution_status(solution, error);
}

const struct nb_reference reference_incline = {
    .name = "incline",
    .title = "a particle on a plane of increasing inclination: rolling, or sliding and rotating",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FRICTION, HAS_GRAVITY, HAS_CONTACT_DAMPING, HAS_GRAVITY_CHANGE, HAS_RAMP},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
