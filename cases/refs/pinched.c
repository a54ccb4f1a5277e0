/* Reference: an elastic sphere between two others that approach each other, without friction.
 *
 * By symmetry this sphere moves along y alone, between spheres at x = -X and X:
 *
 *   m y'' = 2 F y/D,   X = X_0 - V t,   D = sqrt(X^2 + y^2),   F = (4/3) E* sqrt(R*) (R + r - D)^(3/2)          [Hertz]
 *
 *   m, r   of the small sphere, kg, m      R   radius of the two, m      V   speed of each, m/s
 *   E* = E/(2 (1 - nu^2)),  R* = R r/(R + r)
 *
 * integrated by the method of Prince and Dormand, with the tolerance 1e-12, until the contacts end, in steps of a
 * hundredth of (m^2/(K^2 V))^(1/5), K = (4/3) E* sqrt(R*). To find the end, the step in which it occurs is repeated with a
 * quarter of its length, until it is shorter than 1e-11 of the others.
 *
 * Returns:
 *   D.vy               after separation, for D that monitors the small sphere
 *   C.overlap max      for C that monitors one of its contacts
 *   energy.walls       m y'^2/2 after separation: the work of the two moving spheres
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

#include "reference.h"

struct pinch {
  double stiffness;   /* (4/3) E* sqrt(R*), N/m^(3/2) */
  double mass, sum;   /* kg; R + r, m */
  double from, speed; /* X_0, m; V, m/s */
};

static double overlap(const struct pinch *p, double t, double y) { return p->sum - hypot(p->from - p->speed * t, y); }

static int slope(double t, const double u[], double du[], void *data) {
  const struct pinch *p = data;
  const double alpha = overlap(p, t, u[0]), a = alpha > 0 ? alpha : 0;
  du[0] = u[1];
  du[1] = 2 * p->stiffness * a * sqrt(a) / p->mass * u[0] / (p->sum - alpha);
  return GSL_SUCCESS;
}

/* Integrates from rest at y to separation. *speed: y' then; *largest: the largest overlap. False: GSL failed. */
static bool integrate(struct pinch *p, double y, double *speed, double *largest) {
  const gsl_odeiv2_system system = {slope, NULL, 2, p};
  const double whole = pow(pow(p->mass / p->stiffness, 2) / p->speed, 0.2) / 100;
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, whole / 100, 1e-15 * p->sum, 1e-12);
  if (!driver)
    return false;
  gsl_odeiv2_driver_set_nmax(driver, 100000);
  double t = 0, u[2] = {y, 0}, step = whole;
  bool solved = true, touched = false;
  *largest = 0;
  for (long n = 0; n < 10000000 && solved; n++) {
    const double before = t, previous[2] = {u[0], u[1]};
    solved = gsl_odeiv2_driver_apply(driver, &t, t + step, u) == GSL_SUCCESS;
    const double alpha = overlap(p, t, u[0]);
    touched = touched || alpha > 1e-12 * p->sum;
    *largest = alpha > *largest ? alpha : *largest;
    if (!(touched && alpha <= 0))
      continue;
    if (step < 1e-11 * whole)
      break;
    t = before, u[0] = previous[0], u[1] = previous[1], step /= 4;
    gsl_odeiv2_driver_reset(driver);
  }
  gsl_odeiv2_driver_free(driver);
  *speed = u[1];
  return solved;
}

static bool fits(const struct nb_scene *scene) {
  const struct nb_particle *left = &scene->particles[0], *right = &scene->particles[1], *small = &scene->particles[2];
  return scene->particle_count == 3 && scene->material_count == 1 && left->fixed && right->fixed && !small->fixed &&
         left->radius == right->radius && left->x == -right->x && left->vx == -right->vx && left->vx > 0 &&
         small->x == 0 && small->vx == 0 && small->vy == 0 && left->y == 0 && right->y == 0 && small->y > 0 &&
         left->vy == 0 && right->vy == 0;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *left = &scene->particles[0], *right = &scene->particles[1], *small = &scene->particles[2];
  if (!fits(scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `pinched` is for spheres of one material: two equal fixed ones that approach each other along "
        "x, and a third one at rest between them, above the line of their centres");
  const struct nb_material *glass = &scene->materials[small->material];
  const double R = right->radius, r = small->radius;
  struct pinch pinch = {.stiffness =
                            4. / 3 * glass->young / (2 * (1 - glass->poisson * glass->poisson)) * sqrt(R * r / (R + r)),
                        .mass = matter_mass(scene, small),
                        .sum = R + r,
                        .from = right->x,
                        .speed = left->vx};
  double speed, largest;
  if (!integrate(&pinch, small->y, &speed, &largest))
    return nb_error_set(error, NB_BROKEN, "pinched: the equation of motion could not be integrated");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    char name[3 * NB_NAME_SIZE];
    const struct nb_monitor *monitor = &scene->monitors[w];
    const bool particle = monitor->kind == NB_MONITOR_PARTICLE;
    if (monitor->a != 2 && monitor->b != 2)
      continue;
    snprintf(name, sizeof name, "%s.%s", monitor->name, particle ? "vy" : "overlap max");
    solution_value(solution, particle ? speed : largest, name);
  }
  solution_value(solution, pinch.mass * speed * speed / 2, "energy.walls");
  return solution_status(solution, error);
}

const struct nb_reference reference_pinched = {
    .name = "pinched",
    .title = "a sphere pinched between two approaching ones, Hertz: its equation of motion",
    .source = "[R89 sec. 6.4.2]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .needs = {HAS_FIXED_PARTICLES},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
