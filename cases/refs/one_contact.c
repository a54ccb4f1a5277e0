/* Reference: two particles, or a particle and a wall, with one contact that does not slide: the equations of motion, by
 * GSL.
 *
 *   m x'' = -+(P e + Q t),  - for particle 1, + for 2,   I w' = Q R,   v = v_1 - v_2        [CS79 8-15, 20-23]
 *   P = k_n alpha + c_n (v.e),   Q = F_s + c_s s',   F_s' = k_s s',   s' = v.t - R_1 w_1 - R_2 w_2
 *   c = beta k,  or  beta 2 sqrt(M* k)                                                      [CS79 26-28] [R89 4.13]
 *
 * in continuous time, by the eighth-order method of Prince and Dormand with the tolerance 1e-13. e is the unit normal
 * and t the tangent of the contact, P and Q are its normal and tangential forces with the dashpots, and F_s is the
 * force of the shear spring. alpha is the overlap, s the slip, v the relative velocity of the centres, and w an angular
 * velocity. The time step enters only through the end of the run, after all cycles of all stages, and as a factor of
 * energy.balance. So a run differs from this solution by the error of its step.
 *
 * Returns, at the end:
 *   B.x, y, angle, vx, vy, spin    for B that monitors a particle
 *   C.overlap, normal, shear       for C that monitors the contact
 *   energy.kinetic, energy.stored, momentum.x, momentum.y, momentum.angular
 *   energy.balance                 h/2 Int F_s (v.t)(v.e)/D dt, h the time step, D the distance of the centres; 0 with
 *                                  a wall. [CS79 15] takes t at the end of the step. The
 *                                  work is computed with the forces at both ends. Between them
 *                                  t rotates with the angular velocity (v.t)/D. This gives the
 *                                  residual to first order in h
 *
 * The contact may open only while its shear spring is undeformed; otherwise the time of opening would have to be known.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

#include "reference.h"

/* The unknowns: six of each particle, the shear force of the spring, and the integral of energy.balance. */
enum { X, Y, VX, VY, ANGLE, SPIN, SECOND, SHEAR = 2 * SECOND, RESIDUAL, UNKNOWNS };
enum { SAMPLES = 1000 }; /* times at which the friction limit is checked */

struct pair {
  double mass[2], inertia[2]; /* kg, kg m2; infinite for a fixed particle or a wall */
  double radius[2];           /* m; 0 for a wall */
  const struct nb_wall *wall; /* NULL: two particles */
  struct matter_pair values;
  double cn, cs; /* N s/m */
  bool has_shear;
};

/* Kinematics of the contact in a state. */
struct kinematics {
  double ex, ey, tx, ty;    /* e and t, 1 */
  double distance, overlap; /* m */
  double dn, along, slip;   /* v.e, v.t, s', m/s */
};

static struct kinematics kinematics(const struct pair *pair, const double y[]) {
  double ax = y[SECOND + X] - y[X], ay = y[SECOND + Y] - y[Y];
  if (pair->wall) { /* to the foot of the perpendicular; the wall is the second particle of the state */
    const double s = ax * pair->wall->ex + ay * pair->wall->ey;
    ax -= s * pair->wall->ex, ay -= s * pair->wall->ey;
  }
  struct kinematics at = {.distance = hypot(ax, ay)};
  at.ex = ax / at.distance, at.ey = ay / at.distance, at.tx = at.ey, at.ty = -at.ex;
  at.overlap = pair->radius[0] + pair->radius[1] - at.distance;
  const double vx = y[VX] - y[SECOND + VX], vy = y[VY] - y[SECOND + VY];
  at.dn = vx * at.ex + vy * at.ey, at.along = vx * at.tx + vy * at.ty;
  at.slip = at.along - pair->radius[0] * y[SPIN] - pair->radius[1] * y[SECOND + SPIN];
  return at;
}

static int slope(double time, const double y[], double dydt[], void *data) {
  const struct pair *pair = data;
  const struct kinematics at = kinematics(pair, y);
  const bool touching = at.overlap > 0;
  const double normal = touching ? pair->values.kn * at.overlap + pair->cn * at.dn : 0;
  const double shear = touching && pair->has_shear ? y[SHEAR] + pair->cs * at.slip : 0;
  (void)time;
  for (int k = 0; k < 2; k++) {
    const double *b = y + k * SECOND, sign = k ? 1 : -1;
    double *d = dydt + k * SECOND;
    d[X] = b[VX], d[Y] = b[VY], d[ANGLE] = b[SPIN];
    d[VX] = sign * (normal * at.ex + shear * at.tx) / pair->mass[k];
    d[VY] = sign * (normal * at.ey + shear * at.ty) / pair->mass[k];
    d[SPIN] = shear * pair->radius[k] / pair->inertia[k];
  }
  dydt[SHEAR] = touching && pair->has_shear ? pair->values.ks * at.slip : 0;
  dydt[RESIDUAL] = !pair->wall ? y[SHEAR] * at.along * at.dn / at.distance : 0;
  return GSL_SUCCESS;
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `one_contact` is for %s", what);
}

static void put_particle(struct pair *pair, double y[], const struct nb_scene *scene, int k) {
  const struct nb_particle *particle = &scene->particles[k];
  y += k * SECOND;
  y[X] = particle->x, y[Y] = particle->y, y[VX] = particle->vx, y[VY] = particle->vy, y[SPIN] = particle->spin;
  pair->mass[k] = particle->fixed ? INFINITY : matter_mass(scene, particle);
  pair->inertia[k] = particle->fixed ? INFINITY : matter_inertia(scene, particle);
  pair->radius[k] = particle->radius;
}

/* The duration of all stages, s; 0: unknown, because a stage moves the wall, or the step is not given as a time. */
static double duration(const struct nb_scene *scene) {
  double time = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->motion_count || stage->step.kind != NB_STEP_TIME)
      return 0;
    time += (double)stage->cycles * stage->step.value;
  }
  return time;
}

static enum nb_status build(struct pair *pair, double y[], const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_damping *damping = &scene->damping;
  memset(y, 0, UNKNOWNS * sizeof *y);
  *pair = (struct pair){.mass = {0, INFINITY}, .inertia = {0, INFINITY}};
  if (scene->particle_count + scene->wall_count != 2 || scene->particle_count < 1)
    return refuse(error, "two particles, or a particle and a wall");
  if (!(duration(scene) > 0))
    return refuse(error, "a step given as a time, and a wall whose velocity no stage changes");
  for (int k = 0; k < (int)scene->particle_count; k++)
    put_particle(pair, y, scene, k);
  const int a = scene->particles[0].material;
  if (scene->wall_count) {
    const struct nb_wall *wall = pair->wall = &scene->walls[0];
    y[SECOND + X] = wall->x, y[SECOND + Y] = wall->y, y[SECOND + VX] = wall->vx, y[SECOND + VY] = wall->vy;
  }
  pair->values = matter_pair(scene, a, pair->wall ? pair->wall->material : scene->particles[1].material);
  pair->has_shear = strcmp(scene->shear, "none") != 0 && (pair->values.friction > 0 || pair->values.cohesion > 0);
  const double reduced = 1 / (1 / pair->mass[0] + 1 / pair->mass[1]);
  double value;
  switch (nb_damping_at(damping, pair->wall != NULL, &value)) {
  case NB_CONTACT_STIFFNESS:
    pair->cn = value * pair->values.kn, pair->cs = value * pair->values.ks;
    break;
  case NB_CONTACT_RATIO:
    pair->cn = 2 * value * sqrt(reduced * pair->values.kn);
    pair->cs = 2 * value * sqrt(reduced * pair->values.ks);
    break;
  case NB_CONTACT_R89_FRACTION:
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return NB_OK;
}

/* NB_BAD_USE: the contact slides, opens with a deformed shear spring, or has reached an end of the wall. */
static enum nb_status check_contact(const struct pair *pair, const double y[], struct nb_error *error) {
  const struct kinematics at = kinematics(pair, y);
  if (at.overlap > 0 && fabs(y[SHEAR]) > pair->values.kn * at.overlap * pair->values.friction + pair->values.cohesion)
    return refuse(error, "a contact that does not slide");
  if (!(at.overlap > 0) && y[SHEAR] != 0)
    return refuse(
        error,
        "a contact that opens only with an undeformed shear spring: let the last stage end before the contact opens");
  const struct nb_wall *wall = pair->wall;
  const double s = wall ? (y[X] - y[SECOND + X]) * wall->ex + (y[Y] - y[SECOND + Y]) * wall->ey : 0;
  if (wall && !(s > wall->h1 && s < wall->h2))
    return refuse(error, "a wall so long that the contact does not reach its end");
  return NB_OK;
}

static enum nb_status solve_equations(struct pair *pair, double y[], double end, struct nb_error *error) {
  const double mass = pair->mass[0] < pair->mass[1] ? pair->mass[0] : pair->mass[1];
  const double timescale = sqrt(mass / (pair->values.kn + pair->values.ks)), radius = pair->radius[0];
  double fastest = radius / timescale * 1e-6, scale[UNKNOWNS];
  for (int k = 0; k < 2; k++)
    fastest = fmax(fastest, hypot(y[k * SECOND + VX], y[k * SECOND + VY]) + fabs(y[k * SECOND + SPIN]) * radius);
  for (int k = 0; k < 2; k++) { /* the scale of each unknown, for the error control */
    double *s = scale + k * SECOND;
    s[X] = s[Y] = timescale * fastest, s[VX] = s[VY] = fastest, s[ANGLE] = timescale * fastest / radius,
    s[SPIN] = fastest / radius;
  }
  scale[SHEAR] = mass / timescale * fastest, scale[RESIDUAL] = mass * fastest * fastest * fastest / radius;
  gsl_odeiv2_system system = {slope, NULL, UNKNOWNS, pair};
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_scaled_new(&system, gsl_odeiv2_step_rk8pd, timescale / 100, 1e-13, 0, 1, 0, scale);
  if (!driver)
    return nb_error_memory(error);
  gsl_odeiv2_driver_set_hmax(driver, timescale / 5);
  gsl_odeiv2_driver_set_nmax(driver, 100000);
  enum nb_status status = check_contact(pair, y, error);
  double time = 0;
  for (int k = 1; k <= SAMPLES && !status; k++) {
    if (gsl_odeiv2_driver_apply(driver, &time, end * k / SAMPLES, y) != GSL_SUCCESS)
      status = nb_error_set(error, NB_BROKEN, "the equations of motion could not be solved beyond %g s", time);
    else
      status = check_contact(pair, y, error);
  }
  gsl_odeiv2_driver_free(driver);
  return status;
}

static void add_value(struct nb_solution *solution, const char *monitor, const char *what, double value) {
  char text[3 * NB_NAME_SIZE];
  snprintf(text, sizeof text, "%s.%s", monitor, what);
  solution_value(solution, value, text);
}

static void add_sums(struct nb_solution *solution, const struct pair *pair, const double y[], double step) {
  const struct kinematics at = kinematics(pair, y);
  double kinetic = 0, px = 0, py = 0, angular = 0;
  for (int k = 0; k < 2; k++) {
    const double *b = y + k * SECOND, m = pair->mass[k];
    if (isinf(m))
      continue;
    kinetic += (m * (b[VX] * b[VX] + b[VY] * b[VY]) + pair->inertia[k] * b[SPIN] * b[SPIN]) / 2;
    px += m * b[VX], py += m * b[VY];
    angular += m * (b[X] * b[VY] - b[Y] * b[VX]) + pair->inertia[k] * b[SPIN];
  }
  const double normal = at.overlap > 0 ? pair->values.kn * at.overlap * at.overlap / 2 : 0;
  solution_value(solution, kinetic, "energy.kinetic");
  solution_value(solution, normal + (pair->values.ks > 0 ? y[SHEAR] * y[SHEAR] / (2 * pair->values.ks) : 0),
                 "energy.stored");
  solution_value(solution, step / 2 * y[RESIDUAL], "energy.balance");
  solution_value(solution, px, "momentum.x"), solution_value(solution, py, "momentum.y");
  solution_value(solution, angular, "momentum.angular");
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  static const char *const of_particle[] = {"x", "y", "vx", "vy", "angle", "spin"}; /* in the order of the unknowns */
  struct pair pair;
  double y[UNKNOWNS];
  enum nb_status status = build(&pair, y, scene, error);
  if (!status)
    status = solve_equations(&pair, y, duration(scene), error);
  if (status)
    return status;
  const struct kinematics at = kinematics(&pair, y);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE)
      for (int k = 0; k < SECOND; k++)
        add_value(solution, monitor->name, of_particle[k], y[monitor->a * SECOND + k]);
    if (monitor->kind != NB_MONITOR_PARTICLE_PARTICLE && monitor->kind != NB_MONITOR_PARTICLE_WALL)
      continue;
    add_value(solution, monitor->name, "overlap", fmax(at.overlap, 0));
    add_value(solution, monitor->name, "normal", pair.values.kn * fmax(at.overlap, 0));
    add_value(solution, monitor->name, "shear", y[SHEAR]);
  }
  add_sums(solution, &pair, y, scene->step.value);
  return solution_status(solution, error);
}

const struct nb_reference reference_one_contact = {
    .name = "one_contact",
    .title = "one contact that does not slide: the equations of motion in continuous time, by GSL at 1e-13",
    .source = "[CS79 8-23, 26-28] [R89 4.13]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_MOVING_WALLS,
                HAS_FRICTION, HAS_COHESION, HAS_STIFFNESS_DAMPING, HAS_RATIO_DAMPING, HAS_WALL_DAMPING,
                HAS_CENTRED_DASHPOTS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
