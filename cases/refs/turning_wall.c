/* Reference: a particle that rolls along a wall which turns about a fixed point  [CS79 figure 4].
 *
 * The wall turns about P with the angular velocity W. In the frame of the wall, the centre of the particle has the
 * coordinates s along the wall and n to the left of it, measured from P. It starts at s = s_0, at rest in this frame.
 * The angular velocity of the particle is w. The distance of the centre from the line of the wall is constant;
 * sigma = 1 if the particle is to the left of this line, else -1. The centrifugal and Coriolis forces and the forces N
 * and F of the wall (F on the particle, along the wall) balance its acceleration:
 *
 *   m (s'' - W^2 s) = F              m (2 W s' - W^2 n) = sigma N
 *   rolling:  s' + sigma R (w - W) = 0,     I w' = sigma R F      so     s'' = W^2 s / (1 + I/(m R^2))
 *
 *   s = s_0 cosh(q t),   q = W / sqrt(1 + I/(m R^2)),   F = -(I/R^2) s'',   w = W - sigma s'/R
 *
 * q/W is sqrt(2/3) for a disc and sqrt(5/7) for a sphere.
 *
 * Returns, versus time:
 *   D.x, D.y, D.spin      for D that monitors the particle
 *   C.normal, C.shear     for C that monitors its contact
 * Error: the overlap is neglected. The relative error is of the order of N/(k_n s_0).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

enum quantity { X, Y, SPIN, NORMAL, SHEAR, QUANTITIES };

struct rolling {
  double px, py, ex, ey;        /* P, and the unit vector along the wall at time 0 */
  double wall_spin;             /* W, rad/s */
  double q, s0, n, sigma;       /* 1/s, m, m, 1 */
  double radius, mass, inertia; /* m, kg, kg m2 */
  enum quantity quantity;
};

static double at(const void *data, double t) {
  const struct rolling *it = data;
  const double s = it->s0 * cosh(it->q * t), ds = it->s0 * it->q * sinh(it->q * t), dds = it->q * it->q * s;
  const double c = cos(it->wall_spin * t), b = sin(it->wall_spin * t);
  const double ex = c * it->ex - b * it->ey, ey = b * it->ex + c * it->ey;
  const double all[QUANTITIES] = {
      [X] = it->px + s * ex - it->n * ey,
      [Y] = it->py + s * ey + it->n * ex,
      [SPIN] = it->wall_spin - it->sigma * ds / it->radius,
      [NORMAL] = it->sigma * it->mass * (2 * it->wall_spin * ds - it->wall_spin * it->wall_spin * it->n),
      /* F_s acts on the particle in the direction sigma e, e along the wall. */
      [SHEAR] = -it->sigma * it->inertia / (it->radius * it->radius) * dds,
  };
  return all[it->quantity];
}

/* NULL if the particle moves with the wall at first and just touches it, and no stage changes the motion of the wall;
 * else what the reference is for. */
static const char *check_start(const struct nb_scene *scene, const struct rolling *it) {
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  const double speed = fabs(it->wall_spin) * hypot(particle->x - it->px, particle->y - it->py);
  const double difference = hypot(particle->vx + it->wall_spin * (particle->y - it->py),
                                  particle->vy - it->wall_spin * (particle->x - it->px));
  if (!(difference <= 1e-9 * speed) || particle->spin != it->wall_spin)
    return "a particle that turns with the wall at first";
  if (!(fabs(fabs(it->n - wall->h0) - it->radius) <= 1e-9 * it->radius))
    return "a particle that just touches the wall";
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].motion_count)
      return "a wall whose motion no stage changes";
  return NULL;
}

/* NULL if, until the end of the run, the particle does not slide and does not reach an end of the wall; else what the
 * reference is for. */
static const char *check_run(const struct nb_scene *scene, const struct rolling *it, double friction) {
  double end = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    if (scene->stages[s].step.kind != NB_STEP_TIME)
      return "a step given as a time, such as `step 1 us`";
    end += (double)scene->stages[s].cycles * scene->stages[s].step.value;
  }
  struct rolling shear = *it, normal = *it;
  shear.quantity = SHEAR, normal.quantity = NORMAL;
  for (int k = 0; k <= 1000; k++) {
    const double t = end * k / 1000, s = it->s0 * cosh(it->q * t);
    if (!(fabs(at(&shear, t)) < friction * at(&normal, t)))
      return "a particle that does not slide on the wall until the end of the run";
    if (!(s > scene->walls[0].h1 && s < scene->walls[0].h2))
      return "a wall so long that the particle does not reach its end during the run";
  }
  return NULL;
}

static void add_curve(struct nb_solution *solution, const struct rolling *it, const char *monitor, const char *what,
                      enum quantity quantity) {
  char name[2 * NB_NAME_SIZE];
  struct rolling *data = malloc(sizeof *data);
  if (data) {
    *data = *it;
    data->quantity = quantity;
  }
  snprintf(name, sizeof name, "%.60s.%s", monitor, what);
  solution_curve(solution, name, "time", at, data);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return nb_error_set(error, NB_BAD_USE, "the reference `turning_wall` is for one particle and one wall");
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  const double dx = particle->x - wall->x, dy = particle->y - wall->y;
  struct rolling it = {.px = wall->x,
                       .py = wall->y,
                       .ex = wall->ex,
                       .ey = wall->ey,
                       .wall_spin = wall->spin,
                       .radius = particle->radius};
  it.mass = matter_mass(scene, particle), it.inertia = matter_inertia(scene, particle);
  it.s0 = dx * wall->ex + dy * wall->ey, it.n = dy * wall->ex - dx * wall->ey;
  it.sigma = it.n > wall->h0 ? 1 : -1;
  it.q = it.wall_spin / sqrt(1 + it.inertia / (it.mass * it.radius * it.radius));
  const char *why = check_start(scene, &it);
  if (!why)
    why = check_run(scene, &it, matter_pair(scene, particle->material, wall->material).friction);
  if (why)
    return nb_error_set(error, NB_BAD_USE, "the reference `turning_wall` is for %s", why);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE)
      add_curve(solution, &it, monitor->name, "x", X), add_curve(solution, &it, monitor->name, "y", Y),
          add_curve(solution, &it, monitor->name, "spin", SPIN);
    if (monitor->kind == NB_MONITOR_PARTICLE_WALL)
      add_curve(solution, &it, monitor->name, "normal", NORMAL),
          add_curve(solution, &it, monitor->name, "shear", SHEAR);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_turning_wall = {
    .name = "turning_wall",
    .title = "a particle that rolls along a turning wall: its motion in the frame of the wall",
    .source = "[CS79 figure 4]",
    .accepts = {HAS_OFFSET_WALLS, HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_CONTACT_DAMPING,
                HAS_DAMPING_CHANGE},
    .needs = {HAS_WALLS, HAS_TURNING_WALLS, HAS_FRICTION},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
