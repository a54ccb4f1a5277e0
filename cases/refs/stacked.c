/* Reference: two spheres, one on the other, compressed between a floor and a ceiling: coupled oscillators, by GSL.
 *
 * Sphere 1 is below sphere 2, y is the height above the floor, h the height of the ceiling. P_1, P_12 and P_2 are the
 * forces of the floor, between the spheres, and of the ceiling:
 *
 *   m_1 y_1'' = -m_1 g + P_1 - P_12,    m_2 y_2'' = -m_2 g + P_12 - P_2
 *   P = k alpha + c alpha'  while alpha > 0
 *   alpha_1 = R_1 - y_1,  alpha_12 = R_1 + R_2 - (y_2 - y_1),  alpha_2 = R_2 - (h - y_2)
 *   c = 2 beta (m* k)^(1/2), m* of each contact                                                              [R89 4.13]
 *
 * The method is the eighth-order one of Prince and Dormand, with the tolerance 1e-13.
 *
 * Returns, versus time:   D.y, D.vy for D that monitors a sphere; C.overlap for C that monitors their contact
 *
 * Source   [MFiX DEM-03].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "single.h"

enum { Y1, Y2, V1, V2, UNKNOWNS };
enum { LOWER, MIDDLE, UPPER, CONTACTS };

struct stack {
  double mass[2], radius[2], floor, ceiling, gravity; /* kg, m, m/s2 */
  double k[CONTACTS], c[CONTACTS];                    /* N/m, N s/m */
  double start[UNKNOWNS], timescale;                  /* m, m/s; s */
};

static double normal_force(const struct stack *stack, int contact, double overlap, double dn) {
  return overlap > 0 ? stack->k[contact] * overlap + stack->c[contact] * dn : 0;
}

static int slope(double t, const double y[], double dydt[], void *data) {
  const struct stack *s = data;
  const double lower = normal_force(s, LOWER, s->radius[0] - (y[Y1] - s->floor), -y[V1]);
  const double middle = normal_force(s, MIDDLE, s->radius[0] + s->radius[1] - (y[Y2] - y[Y1]), y[V1] - y[V2]);
  const double upper = normal_force(s, UPPER, s->radius[1] - (s->ceiling - y[Y2]), y[V2]);
  (void)t;
  dydt[Y1] = y[V1], dydt[Y2] = y[V2];
  dydt[V1] = -s->gravity + (lower - middle) / s->mass[0];
  dydt[V2] = -s->gravity + (middle - upper) / s->mass[1];
  return GSL_SUCCESS;
}

static void state_at(const struct stack *stack, double t, double y[]) {
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, (void *)stack};
  double time = 0;
  memcpy(y, stack->start, sizeof stack->start);
  if (!(t > 0))
    return;
  gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, stack->timescale / 100,
                                                            stack->radius[0] * 1e-14, 1e-13);
  if (!driver || gsl_odeiv2_driver_set_nmax(driver, 1000000) ||
      gsl_odeiv2_driver_apply(driver, &time, t, y) != GSL_SUCCESS)
    y[Y1] = y[Y2] = y[V1] = y[V2] = NAN;
  if (driver)
    gsl_odeiv2_driver_free(driver);
}

static double unknown_at(const void *data, double t, int which) {
  double y[UNKNOWNS];
  state_at(data, t, y);
  return y[which];
}
static double lower_y(const void *data, double t) { return unknown_at(data, t, Y1); }
static double upper_y(const void *data, double t) { return unknown_at(data, t, Y2); }
static double lower_v(const void *data, double t) { return unknown_at(data, t, V1); }
static double upper_v(const void *data, double t) { return unknown_at(data, t, V2); }
static double overlap(const void *data, double t) {
  const struct stack *stack = data;
  double y[UNKNOWNS];
  state_at(stack, t, y);
  return fmax(stack->radius[0] + stack->radius[1] - (y[Y2] - y[Y1]), 0);
}

static void add_curve(struct nb_solution *solution, const char *monitor, const char *what,
                      double (*at)(const void *data, double t), const struct stack *stack) {
  char name[2 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%.*s.%s", NB_NAME_SIZE, monitor, what);
  struct stack *copy = malloc(sizeof *copy);
  if (copy)
    *copy = *stack;
  solution_curve(solution, name, "time", at, copy);
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `stacked` is for %s", what);
}

static enum nb_status build(struct stack *stack, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *b = scene->particles;
  const struct nb_wall *w = scene->walls;
  if (scene->particle_count != 2 || scene->wall_count != 2 || b[0].x != b[1].x || b[0].vx != 0 || b[1].vx != 0 ||
      !(w[0].y < b[0].y && b[0].y < b[1].y && b[1].y < w[1].y) || w[0].ey != 0 || w[1].ey != 0 ||
      !single_faces(&w[0], b[0].x, b[0].y) || !single_faces(&w[1], b[1].x, b[1].y))
    return refuse(error, "two spheres without horizontal velocity, sphere 1 vertically below sphere 2, between two "
                         "horizontal walls, first the floor, then the ceiling");
  if (scene->gravity.x != 0)
    return refuse(error, "vertical gravity");
  const int material[] = {w[0].material, b[0].material, b[1].material, w[1].material};
  const double beta = scene->damping.contact;
  const double m1 = matter_mass(scene, &b[0]), m2 = matter_mass(scene, &b[1]);
  const double reduced[] = {m1, m1 * m2 / (m1 + m2), m2};
  *stack = (struct stack){.mass = {m1, m2}, .radius = {b[0].radius, b[1].radius}, .gravity = -scene->gravity.y};
  stack->floor = w[0].y, stack->ceiling = w[1].y, stack->timescale = INFINITY;
  for (int c = 0; c < CONTACTS; c++) {
    stack->k[c] = matter_pair(scene, material[c], material[c + 1]).kn;
    stack->c[c] = 2 * beta * sqrt(reduced[c] * stack->k[c]);
    stack->timescale = fmin(stack->timescale, sqrt(reduced[c] / stack->k[c]));
  }
  stack->start[Y1] = b[0].y, stack->start[Y2] = b[1].y, stack->start[V1] = b[0].vy, stack->start[V2] = b[1].vy;
  return NB_OK;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct stack stack;
  if (build(&stack, scene, error))
    return error->status;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE) {
      add_curve(solution, monitor->name, "y", monitor->a ? upper_y : lower_y, &stack);
      add_curve(solution, monitor->name, "vy", monitor->a ? upper_v : lower_v, &stack);
    } else if (monitor->kind == NB_MONITOR_PARTICLE_PARTICLE) {
      add_curve(solution, monitor->name, "overlap", overlap, &stack);
    }
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_stacked = {
    .name = "stacked",
    .title = "two spheres compressed between floor and ceiling: coupled oscillators by GSL at 1e-13",
    .source = "[MFiX DEM-03]",
    .accepts = {HAS_SPHERES, HAS_VELOCITIES, HAS_GRAVITY, HAS_RATIO_DAMPING},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
