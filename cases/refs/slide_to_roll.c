/* Reference: a particle with the initial velocity u0 and without spin slides on a floor, then rolls; the solution
 * includes the shear spring and its dashpot.
 *
 * x and s are the displacements of the centre and of the contact point since the beginning. With q = m R^2/I (2 for a
 * disc, 5/2 for a sphere), the velocity v, the angular velocity w and the velocity s' = v + R w of the contact point,
 * friction F gives m v' = -F and R w' = -q F/m. So s'' = -(1 + q) F/m, and at all times and for any F
 *
 *   v = (s' + q u0)/(1 + q),     x = (s + q u0 t)/(1 + q)
 *
 * A rigid particle has F = F_m = mu m g + c, with the cohesion c, until s' = 0 at t_s = m u0/((1 + q) F_m). Then
 * v = q u0/(1 + q), which is 2/3 u0 for a disc and 5/7 u0 for a sphere. k_s is the stiffness of the shear spring and
 * c_s the coefficient of its dashpot. With d_m = F_m/k_s, b = (1 + q) c_s/(2 m), w_d^2 = (1 + q) k_s/m - b^2, and t from
 * the beginning of each phase:
 *
 *   stick   s = u0 e^(-b t) sin(w_d t)/w_d                           until s = d_m
 *   slide   s' decreases by (1 + q) F_m/m per second                 until s' = 0
 *   roll    the spring, stretched by d_m at first, oscillates:
 *           d = d_m e^(-b t) (cos w_d t + (b/w_d) sin w_d t), s' = d'
 *
 * Returns, for D that monitors the particle:
 *   D.vx, D.spin, D.x versus time
 *   time in STAGE, D.x in STAGE      of the stage that ends when sliding ends
 *   D.vx in STAGE                    of later stages, when the oscillation has decayed
 *
 * Accepts an initial normal force equal to the weight, within 1e-4 of it, and less than critical damping.
 *
 * Source   [MFiX DEM-04] for the rigid particle; the springs are elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

struct slide {
  double u0, q, radius, x0; /* m/s, 1, m, m */
  double b, damped;         /* b and w_d, in 1/s */
  double limit;             /* d_m, m */
  double brake;             /* (1 + q) F_m/m, m/s2 */
  double stick, slide;      /* times at which they end, s */
  double slip;              /* s' at the beginning of sliding, m/s */
};

/* Returns s at time t of the phase `stick`; *rate: s'. */
static double sticking_slip(const struct slide *f, double t, double *rate) {
  const double fade = f->u0 * exp(-f->b * t) / f->damped, s = sin(f->damped * t), c = cos(f->damped * t);
  *rate = fade * (f->damped * c - f->b * s);
  return fade * s;
}

/* Returns s at time t of the run; *rate: s'. */
static double slip_at(const struct slide *f, double t, double *rate) {
  if (t <= f->stick)
    return sticking_slip(f, t, rate);
  const double slid = f->slide - f->stick, end = f->limit + f->slip * slid - f->brake * slid * slid / 2;
  if (t <= f->slide) {
    t -= f->stick;
    *rate = f->slip - f->brake * t;
    return f->limit + f->slip * t - f->brake * t * t / 2;
  }
  t -= f->slide;
  const double fade = f->limit * exp(-f->b * t), s = sin(f->damped * t), c = cos(f->damped * t);
  *rate = -fade * (f->damped + f->b * f->b / f->damped) * s;
  return end - f->limit + fade * (c + f->b / f->damped * s);
}

static double vx_at(const void *data, double t) {
  const struct slide *f = data;
  double rate;
  slip_at(f, t, &rate);
  return (rate + f->q * f->u0) / (1 + f->q);
}
static double spin_at(const void *data, double t) {
  const struct slide *f = data;
  return -f->q * (f->u0 - vx_at(f, t)) / f->radius;
}
static double x_at(const void *data, double t) {
  const struct slide *f = data;
  double rate;
  const double s = slip_at(f, t, &rate);
  return f->x0 + (s + f->q * f->u0 * t) / (1 + f->q);
}

/* Finds the beginning and the end of sliding. False: s' is 0 before the spring reaches its limit, so the particle never
 * slides. */
static bool find_sliding(struct slide *f) {
  double low = 0, high = atan2(f->damped, f->b) / f->damped, rate;
  if (sticking_slip(f, high, &rate) < f->limit)
    return false;
  for (int n = 0; n < 200; n++) {
    const double middle = low + (high - low) / 2;
    *(sticking_slip(f, middle, &rate) < f->limit ? &low : &high) = middle;
  }
  f->stick = high;
  sticking_slip(f, high, &f->slip);
  f->slide = f->stick + f->slip / f->brake;
  return true;
}

static void add_values(struct nb_solution *solution, const struct nb_scene *scene, const struct single *particle,
                       const struct slide *f) {
  bool slid = false;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    char name[3 * NB_NAME_SIZE];
    if (slid)
      single_add(solution, particle->particle, "vx", stage->name, f->q * f->u0 / (1 + f->q));
    if (slid || stage->condition_count != 1 || stage->conditions[0].relation != NB_BELOW)
      continue;
    slid = true;
    snprintf(name, sizeof name, "time in %s", stage->name);
    solution_value(solution, f->slide, name);
    single_add(solution, particle->particle, "x", stage->name, x_at(f, f->slide));
  }
  single_curve(solution, particle->particle, "vx", vx_at, f, sizeof *f);
  single_curve(solution, particle->particle, "spin", spin_at, f, sizeof *f);
  single_curve(solution, particle->particle, "x", x_at, f, sizeof *f);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct single particle;
  if (single_read(&particle, "slide_to_roll", scene, error))
    return error->status;
  const double weight = particle.m * particle.gravity_n, force = particle.pair.kn * (particle.radius - particle.height);
  const double u0 = scene->particles[0].vx;
  if (scene->gravity.x != 0 || scene->particles[0].vy != 0 || !(u0 > 0) || !(fabs(force - weight) < 1e-4 * weight))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `slide_to_roll` is for a particle that moves along the floor without spin, with an initial "
        "normal force equal to its weight of %g N; the force is %g N",
        weight, force);
  const double b = (1 + particle.q) * particle.cs / (2 * particle.m),
               square = (1 + particle.q) * particle.pair.ks / particle.m - b * b;
  struct slide slide = {
      .u0 = u0,
      .q = particle.q,
      .radius = particle.radius,
      .x0 = scene->particles[0].x,
      .b = b,
      .damped = sqrt(square),
      .limit = (weight * particle.pair.friction + particle.pair.cohesion) / particle.pair.ks,
      .brake = (1 + particle.q) * (particle.pair.friction * particle.gravity_n + particle.pair.cohesion / particle.m),
  };
  if (!(square > 0) || !find_sliding(&slide))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `slide_to_roll` is for a particle that slides, with less than critical damping");
  double end = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    end = scene->stages[s].condition_count ? fmax(end, slide.slide)
                                           : end + (double)scene->stages[s].cycles * particle.step;
  if (!single_faces(&scene->walls[0], x_at(&slide, end), scene->particles[0].y))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `slide_to_roll` is for a floor so long that the particle does not reach its end");
  add_values(solution, scene, &particle, &slide);
  return solution_status(solution, error);
}

const struct nb_reference reference_slide_to_roll = {
    .name = "slide_to_roll",
    .title = "a particle that slides until it rolls: friction, spring and dashpot in closed form",
    .source = "[MFiX DEM-04]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_FRICTION, HAS_COHESION, HAS_CONTACT_DAMPING, HAS_UNTIL},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
