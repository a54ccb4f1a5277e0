/* Reference: velocities and spins after oblique impact of a spinning sphere or disc on a wall or another particle.
 *
 * The impulses J_n along the normal and J_t against the tangential velocity of the contact follow from V_N, and from
 * the tangential velocities V_T before the impact and V_T' after it:
 *
 *   J_n = (1 + e) M V_N,    J_t = (V_T - V_T')/B,    1/M = sum 1/m,    B = sum (1/m + R^2/I)
 *
 * V_T, V_T' and J_t are positive along the tangent t. The impulses change the velocity of the first particle by
 * dv = (J_n n - J_t t)/m and its angular velocity by dw = -R J_t/I. The second particle receives the opposite impulse;
 * its dw follows from the same formula, with the same sign. The unknowns are e and V_T'.
 *
 *   e     With a dashpot of the damping ratio beta: exp(-pi z/(1 - z^2)^(1/2)), where z = beta for a linear spring and
 *         z = (6/5)^(1/2) beta for Hertz's law. Without a dashpot: 1. J_n is also the impulse of the elastic force,
 *         because that of the dashpot, Int c(alpha) d(alpha) from 0 to 0, is zero.
 *   V_T'  If the contact slides all the time, J_t = mu J_n, so psi = V_T/(mu kappa V_N) changes from psi1 to
 *         psi2 = psi1 - 2 chi (1 + e),    chi = M B/(2 kappa),    kappa = (E* / G*)/4 or k_n/k_s  [R89 5.14, 5.15]
 *         This holds where psi1 >= 4 chi and psi1 > 1, for any law with Coulomb's limit that slides at once for
 *         psi1 > 1. Only psi1 >= 4 chi is checked. A contact with psi1 = 0 has no tangential force. In between, for
 *         `shear mindlin_deresiewicz` only, psi2 is that of independent springs (impact_springs.c, impact_damped.c).
 *
 * Returns, at the end: D.vx, D.vy, D.spin for D that monitors a particle; impact.psi1, impact.psi2, impact.restitution
 * (ratio of the relative speeds of the centres); energy.kinetic. Also energy.kinetic max, the initial value, unless a
 * wall or a fixed particle moves, which could add energy.
 *
 * Error    of psi2: rounding if the contact slides all the time; 1e-6 by springs; with dashpots 5e-4 for e = 0.5 and
 *          2e-5 for e = 0.98 (tests/refs_damped.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_math.h>
#include <string.h>

#include "hertz.h"
#include "impact_springs.h"

enum { STEPS = 2000, DAMPED_STEPS = 8000 };

static const double no_slip = 1e-12; /* rounding, in psi1 */

struct impact {
  const struct nb_particle *particle[2]; /* the second is NULL for a wall */
  const struct nb_wall *wall;            /* NULL: the impact of two particles */
  double m[2], i[2], r[2];               /* kg, kg m2, m; 0: fixed */
  double nx, ny;                         /* normal toward the first particle; t is n turned clockwise */
  double vx, vy;                         /* of the first particle, relative to the other one or the wall, m/s */
  double vn, vt, mass, inverse_mass;     /* V_N, V_T signed along t, m/s; M, kg; B, 1/kg */
  double mu, kappa, chi, e, beta;
};

static const char separation[] = "an impact that ends, with dashpots well below critical damping";

/* a/b; 0 for a fixed particle, which has b = 0. */
static double over(double a, double b) { return b > 0 ? a / b : 0; }

/* Reads the pair. Returns NULL, or what the reference is for if it does not cover the scene. */
static const char *read_impact(struct impact *it, const struct nb_scene *scene) {
  const struct nb_monitor *monitor = &scene->monitors[scene->impact.monitor];
  const bool hertz = strcmp(scene->normal, "hertz") == 0;
  const struct nb_wall *wall = monitor->kind == NB_MONITOR_PARTICLE_WALL ? &scene->walls[monitor->b] : NULL;
  *it = (struct impact){.particle = {&scene->particles[monitor->a], wall ? NULL : &scene->particles[monitor->b]}};
  const struct nb_particle *a = it->particle[0], *b = it->particle[1];
  const struct matter_pair pair = matter_pair(scene, a->material, wall ? wall->material : b->material);
  if (!(pair.friction > 0) || (!hertz && !(pair.kn * pair.ks > 0)))
    return "a contact with friction";
  for (int k = 0; k < 2; k++)
    if (it->particle[k] && !it->particle[k]->fixed) {
      it->m[k] = matter_mass(scene, it->particle[k]), it->i[k] = matter_inertia(scene, it->particle[k]);
      it->r[k] = it->particle[k]->radius, it->mass += 1 / it->m[k];
      it->inverse_mass += 1 / it->m[k] + it->r[k] * it->r[k] / it->i[k];
    }
  it->wall = wall;
  it->mass = 1 / it->mass;
  it->nx = wall ? -wall->ey : a->x - b->x, it->ny = wall ? wall->ex : a->y - b->y;
  const double side = wall ? (a->x - wall->x) * it->nx + (a->y - wall->y) * it->ny : 1;
  const double size = copysign(hypot(it->nx, it->ny), side);
  it->nx /= size, it->ny /= size;
  it->vx = a->vx - (wall ? wall->vx : b->vx), it->vy = a->vy - (wall ? wall->vy : b->vy);
  it->vn = -(it->vx * it->nx + it->vy * it->ny);
  it->vt = it->vx * it->ny - it->vy * it->nx + a->spin * a->radius + (wall ? 0 : b->spin * b->radius);
  it->mu = pair.friction, it->kappa = hertz ? pair.young / (4 * pair.shear) : pair.kn / pair.ks;
  it->chi = it->mass * it->inverse_mass / (2 * it->kappa);
  it->beta = scene->damping.contact;
  it->e = hertz ? hertz_restitution(it->beta) : exp(-M_PI * it->beta / sqrt(1 - it->beta * it->beta));
  return it->e > 0 ? NULL : separation;
}

static const char *refuse(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].motion_count)
      return "a wall whose velocity no stage changes";
  return NULL;
}

/* Returns psi2. NAN: out of memory; INFINITY: the contact does not end, or GSL failed. */
static double psi_after(const struct impact *it, double psi1) {
  if (psi1 < no_slip)
    return 0;
  if (psi1 >= 4 * it->chi)
    return psi1 - 2 * it->chi * (1 + it->e);
  if (it->beta > 0)
    return impact_damped(it->chi, it->kappa, it->beta, psi1, DAMPED_STEPS);
  struct impact_path path;
  const double psi2 = impact_exact(&path, it->chi, psi1, STEPS) ? path.psi2 : NAN;
  impact_path_free(&path);
  return psi2;
}

/* True if the wall or a fixed particle moves, so that it may add energy. */
static bool is_driven(const struct impact *it) {
  bool driven = it->wall && (it->wall->vx != 0 || it->wall->vy != 0);
  for (int k = 0; k < 2; k++) {
    const struct nb_particle *particle = it->particle[k];
    if (particle && particle->fixed)
      driven = driven || particle->vx != 0 || particle->vy != 0 || particle->spin != 0;
  }
  return driven;
}

static void add_values(struct nb_solution *solution, const struct nb_scene *scene, const struct impact *it, double psi1,
                       double psi2) {
  const double jn = (1 + it->e) * it->mass * it->vn;
  const double jt = copysign((psi1 - psi2) * it->mu * it->kappa * it->vn / it->inverse_mass, it->vt);
  const double jx = jn * it->nx - jt * it->ny,
               jy = jn * it->ny + jt * it->nx; /* on the first particle; t = (ny, -nx) */
  double first = 0, energy = 0;
  for (int k = 0; k < 2; k++) {
    const struct nb_particle *particle = it->particle[k];
    if (!particle)
      continue;
    const double sign = k ? -1 : 1;
    const double vx = particle->vx + sign * over(jx, it->m[k]), vy = particle->vy + sign * over(jy, it->m[k]);
    const double spin = particle->spin - over(it->r[k] * jt, it->i[k]);
    first += (it->m[k] * (particle->vx * particle->vx + particle->vy * particle->vy) +
              it->i[k] * particle->spin * particle->spin) /
             2;
    energy += (it->m[k] * (vx * vx + vy * vy) + it->i[k] * spin * spin) / 2;
    for (size_t w = 0; w < scene->monitor_count; w++) {
      const struct nb_monitor *monitor = &scene->monitors[w];
      if (monitor->kind != NB_MONITOR_PARTICLE || &scene->particles[monitor->a] != particle)
        continue;
      const struct {
        const char *what;
        double value;
      } now[] = {{"vx", vx}, {"vy", vy}, {"spin", spin}};
      for (int q = 0; q < 3; q++) {
        char name[3 * NB_NAME_SIZE];
        snprintf(name, sizeof name, "%s.%s", monitor->name, now[q].what);
        solution_value(solution, now[q].value, name);
      }
    }
  }
  const double vx = it->vx + jx / it->mass, vy = it->vy + jy / it->mass;
  solution_value(solution, psi1, "impact.psi1");
  solution_value(solution, psi2, "impact.psi2");
  solution_value(solution, hypot(vx, vy) / hypot(it->vx, it->vy), "impact.restitution");
  solution_value(solution, energy, "energy.kinetic");
  if (!is_driven(it))
    solution_value(solution, first, "energy.kinetic max");
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct impact it;
  const char *why = refuse(scene);
  if (!why)
    why = read_impact(&it, scene);
  const double psi1 = why ? 0 : fabs(it.vt) / (it.mu * it.kappa * it.vn);
  if (!why && psi1 >= no_slip && psi1 < 4 * it.chi &&
      strcmp(scene->shear, "mindlin_deresiewicz") != 0) /* it needs `normal hertz` */
    why = "`normal hertz` with `shear mindlin_deresiewicz`, or for gross sliding throughout, impact.psi1 >= 4 chi";
  if (why)
    return nb_error_set(error, NB_BAD_USE, "the reference `rebound` is for %s", why);
  const double psi2 = psi_after(&it, psi1);
  if (isnan(psi2))
    return nb_error_memory(error);
  if (isinf(psi2))
    return nb_error_set(error, NB_BAD_USE, "the reference `rebound` is for %s", separation);
  add_values(solution, scene, &it, psi1, psi2);
  return solution_status(solution, error);
}

const struct nb_reference reference_rebound = {
    .name = "rebound",
    .title = "velocities and spins after an impact: impulses in gross sliding, else the exact contact as springs",
    .source = "[R89 5.14, 5.15]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_MOVING_WALLS,
                HAS_MEMORY, HAS_RATIO_DAMPING, HAS_CENTRED_DASHPOTS, HAS_UNTIL},
    .needs = {HAS_IMPACT, HAS_FRICTION},
    .normal = "linear hertz",
    .shear = "linear mindlin mindlin_scaled mindlin_deresiewicz randall randall_literal",
    .solve = solve,
};
