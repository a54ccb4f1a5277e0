/* Reference: a particle without friction hits the end of a wall, which moves at a constant velocity.
 *
 * In the frame that moves with the end the force is central: k (R - r) along r, the vector from the end to the centre.
 * R is the radius of the particle, m its mass and k the stiffness. v is the relative speed, and the impact parameter b
 * is the distance between the end and the line on which the centre arrives. Energy and angular momentum give
 *
 *   r'^2 = v^2 (1 - b^2/r^2) - (k/m) (R - r)^2,          r^2 theta' = b v
 *
 * r falls from R to r_0, where r' = 0, and rises again. During the contact the vector r turns by
 *
 *   Theta = 2 integral from r_0 to R of (b v/r^2)/|r'| dr
 *
 * When the particle leaves, the component of its velocity along r is reversed, and the one perpendicular to r is the
 * same as at first contact. At r_0 the integrand is infinite; the substitution r = r_0 + (R - r_0) s^2 makes it finite.
 *
 * Returns, after the contact:
 *   D.vx, D.vy       for D that monitors the particle
 *   C.overlap max    R - r_0, for C that monitors the contact
 *   energy.walls     the work of the moving wall: the change of the kinetic energy
 * Relative error 1e-10.
 *
 * Source   elementary: motion in a central field, Landau and Lifshitz, Mechanics, section 14.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_integration.h>
#include <math.h>

#include "reference.h"
#include "single.h"

struct scatter {
  double v, b, rate2;     /* m/s, m, k/m in 1/s2 */
  double radius, closest; /* R and r_0, in m */
};

static double radial2(const struct scatter *it, double r) { /* r'^2 */
  const double depth = it->radius - r;
  return it->v * it->v * (1 - it->b * it->b / (r * r)) - it->rate2 * depth * depth;
}

/* r_0: radial2 rises from a negative value at r = |b| or near 0 to a positive one at R. */
static double closest(const struct scatter *it) {
  double low = fmax(it->b, 1e-9 * it->radius), high = it->radius;
  for (int n = 0; n < 200; n++) {
    const double middle = (low + high) / 2;
    *(radial2(it, middle) < 0 ? &low : &high) = middle;
  }
  return high;
}

static double turning(double s, void *data) { /* d(Theta/2)/ds */
  const struct scatter *it = data;
  const double span = it->radius - it->closest, r = it->closest + span * s * s;
  /* r'^2 with its zero at r_0 divided out: (r - r_0) times this */
  const double quotient = it->v * it->v * it->b * it->b * (r + it->closest) / (r * r * it->closest * it->closest) +
                          it->rate2 * (2 * it->radius - r - it->closest);
  return 2 * it->b * it->v / (r * r) * sqrt(span / quotient);
}

/* Theta, rad */
static double turned(struct scatter *it) {
  gsl_integration_workspace *space = gsl_integration_workspace_alloc(1000);
  gsl_function function = {turning, it};
  double half = NAN, error;
  if (gsl_integration_qag(&function, 0, 1, 0, 1e-12, 1000, GSL_INTEG_GAUSS61, space, &half, &error))
    half = NAN;
  gsl_integration_workspace_free(space);
  return 2 * half;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return nb_error_set(error, NB_BAD_USE, "the reference `wall_end` is for one particle and one wall");
  const double m = matter_mass(scene, particle), R = particle->radius;
  /* The end on the side of the particle, and the direction out of the wall there. */
  const double middle = (wall->h1 + wall->h2) / 2;
  const double along = (particle->x - wall->x) * wall->ex + (particle->y - wall->y) * wall->ey;
  const double sign = along > middle ? 1 : -1, h = along > middle ? wall->h2 : wall->h1;
  const double ox = sign * wall->ex, oy = sign * wall->ey;
  const double x = particle->x - wall->x - h * wall->ex, y = particle->y - wall->y - h * wall->ey;
  const double vx = particle->vx - wall->vx, vy = particle->vy - wall->vy, v = hypot(vx, vy);
  const double spin = (x * vy - y * vx) / v; /* b with the sign of the rotation */
  struct scatter it = {
      .v = v, .b = fabs(spin), .rate2 = matter_pair(scene, particle->material, wall->material).kn / m, .radius = R};
  const double travel = -(x * vx + y * vy) / v - sqrt(R * R - it.b * it.b); /* before contact, m; NAN: it passes by */
  if (!(travel >= 0))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `wall_end` is for a particle that moves toward the end of the wall");
  it.closest = closest(&it);
  const double angle = copysign(turned(&it), spin), c = cos(angle), s = sin(angle);
  const double ex = (x + travel * vx / v) / R, ey = (y + travel * vy / v) / R; /* r/R at the first contact */
  const double fx = c * ex - s * ey, fy = s * ex + c * ey;                     /* and at the last one */
  if (!(ex * ox + ey * oy > 0 && fx * ox + fy * oy > 0))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `wall_end` is for a particle that touches the end only, not the wall beside it");
  const double radial = -(vx * ex + vy * ey), across = vy * ex - vx * ey;
  const double nx = wall->vx + radial * fx - across * fy, ny = wall->vy + radial * fy + across * fx;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE) {
      single_add(solution, monitor->name, "vx", NULL, nx);
      single_add(solution, monitor->name, "vy", NULL, ny);
    } else if (monitor->kind == NB_MONITOR_PARTICLE_WALL)
      single_add(solution, monitor->name, "overlap max", NULL, R - it.closest);
  }
  const double before = particle->vx * particle->vx + particle->vy * particle->vy;
  solution_value(solution, m / 2 * (nx * nx + ny * ny - before), "energy.walls");
  return solution_status(solution, error);
}

const struct nb_reference reference_wall_end = {
    .name = "wall_end",
    .title = "a particle without friction that hits the end of a wall: scattering by a central force",
    .source = "[CS79 figure 4]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_MOVING_WALLS},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
