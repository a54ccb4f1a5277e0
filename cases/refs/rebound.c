/* Reference: the velocities and spins after a sphere or a disc has struck a wall, or another one, at an angle and spinning.
 *
 * The impulses J_n along the normal and J_t against the slip follow from the slip before and after, V_T and V_T',
 *
 *   J_n = (1 + e) M V_N,    J_t = (V_T - V_T')/B,    1/M = sum 1/m,    B = sum (1/m + R^2/I)
 *
 * and give each body  dv = (J_n n -+ J_t t)/m,  dw = -+ R J_t/I.  It remains to say e and V_T'.
 *
 *   e    of a dashpot of the share beta of critical: exp(-pi z/(1 - z^2)^(1/2)) with z = beta for a linear spring and
 *        z = (6/5)^(1/2) beta for Hertz's; 1 without. J_n is the impulse of the elastic force too: that of the dashpot,
 *        Int c(alpha) d(alpha) from 0 to 0, is none.
 *   V_T' where it slides throughout, J_t = mu J_n: the contact's velocity psi = V_T/(mu kappa V_N) goes from psi1 to
 *        psi2 = psi1 - 2 chi (1 + e),    chi = M B/(2 kappa),    kappa = (E* / G*)/4, or k_n/k_s of springs       [R89 5.14, 5.15]
 *        It does so from psi1 = 4 chi on, whatever the law, as long as that has Coulomb's limit and takes it at psi1 > 1 at once.
 *        A contact that arrives without slip, psi1 = 0, keeps none: nothing happens along it.
 *        Between, for `shear mindlin_deresiewicz` alone, psi2 is that of independent springs (impact_springs.c, impact_damped.c).
 *
 * Known: NAME.vx, NAME.vy, NAME.spin for watches of the bodies; impact.psi1, impact.psi2, impact.restitution (of the centre's
 * speed, relative to what is struck); energy.kinetic: all at the end. And energy.kinetic max, which is that at first.
 *
 * Error    in gross sliding rounding; psi2 of springs 1e-6 without dashpots, 5e-4 with them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_math.h>
#include <string.h>

#include "hertz.h"
#include "impact_springs.h"

enum { STEPS = 2000, DAMPED_STEPS = 8000 };

static const double no_slip = 1e-12; /* rounding, in psi1 */

struct meeting {
  const struct nb_particle *particle[2]; /* the second NULL: a wall */
  double m[2], i[2], r[2];               /* kg, kg m2, m; 0: does not move */
  double nx, ny;                         /* from what is struck to the first body; t is that turned clockwise */
  double vx, vy;                         /* of the first body, relative, m/s */
  double vn, vt, mass, yield;            /* V_N, V_T signed along t, m/s; M, kg; B, 1/kg */
  double mu, kappa, chi, e, beta;
};

static const char parts[] = "an impact that ends, with dashpots well below critical damping";

static double over(double a, double b) { return b > 0 ? a / b : 0; }

/* What the pair is; NULL, or what it should have been. */
static const char *read_impact(struct meeting *it, const struct nb_scene *scene) {
  const struct nb_monitor *monitor = &scene->monitors[scene->impact.monitor];
  const bool hertz = strcmp(scene->normal, "hertz") == 0;
  const struct nb_wall *wall = monitor->kind == NB_MONITOR_PARTICLE_WALL ? &scene->walls[monitor->b] : NULL;
  *it = (struct meeting){.particle = {&scene->particles[monitor->a], wall ? NULL : &scene->particles[monitor->b]}};
  const struct nb_particle *a = it->particle[0], *b = it->particle[1];
  const struct matter_pair pair = matter_pair(scene, a->material, wall ? wall->material : b->material);
  if (!(pair.friction > 0) || (!hertz && !(pair.ks > 0)))
    return "a contact with friction";
  for (int k = 0; k < 2; k++)
    if (it->particle[k] && !it->particle[k]->fixed) {
      it->m[k] = matter_mass(scene, it->particle[k]), it->i[k] = matter_inertia(scene, it->particle[k]);
      it->r[k] = it->particle[k]->radius, it->mass += 1 / it->m[k];
      it->yield += 1 / it->m[k] + it->r[k] * it->r[k] / it->i[k];
    }
  it->mass = 1 / it->mass;
  it->nx = wall ? -wall->ey : a->x - b->x, it->ny = wall ? wall->ex : a->y - b->y;
  const double way = wall ? (a->x - wall->x) * it->nx + (a->y - wall->y) * it->ny : 1;
  const double size = copysign(hypot(it->nx, it->ny), way);
  it->nx /= size, it->ny /= size;
  it->vx = a->vx - (wall ? wall->vx : b->vx), it->vy = a->vy - (wall ? wall->vy : b->vy);
  it->vn = -(it->vx * it->nx + it->vy * it->ny);
  it->vt = it->vx * it->ny - it->vy * it->nx + a->spin * a->radius + (wall ? 0 : b->spin * b->radius);
  it->mu = pair.friction, it->kappa = hertz ? pair.young / (4 * pair.shear) : pair.kn / pair.ks;
  it->chi = it->mass * it->yield / (2 * it->kappa);
  it->beta = scene->damping.contact;
  it->e = hertz ? hertz_restitution(it->beta) : exp(-M_PI * it->beta / sqrt(1 - it->beta * it->beta));
  return !(it->vn > 0) ? "an impact" : it->e > 0 ? NULL : parts;
}

static const char *refuse(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].motion_count)
      return "a wall whose velocity no stage changes";
  return NULL;
}

/* NAN: out of memory; INFINITY: it does not end. */
static double psi_after(const struct meeting *it, double psi1) {
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

static void add_value(struct nb_solution *solution, const struct nb_scene *scene, const struct meeting *it, double psi1,
                      double psi2) {
  const double jn = (1 + it->e) * it->mass * it->vn;
  const double jt = copysign((psi1 - psi2) * it->mu * it->kappa * it->vn / it->yield, it->vt);
  const double jx = jn * it->nx - jt * it->ny, jy = jn * it->ny + jt * it->nx; /* on the first body; t = (ny, -nx) */
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
  solution_value(solution, first, "energy.kinetic max");
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct meeting it;
  const char *wants = refuse(scene);
  if (!wants)
    wants = read_impact(&it, scene);
  const double psi1 = wants ? 0 : fabs(it.vt) / (it.mu * it.kappa * it.vn);
  if (!wants && psi1 >= no_slip && psi1 < 4 * it.chi &&
      (strcmp(scene->shear, "mindlin_deresiewicz") != 0 || strcmp(scene->normal, "hertz") != 0))
    wants = "the exact law, or for an impact that slides from first touch to parting, psi1 >= 4 chi";
  if (wants)
    return nb_error_set(error, NB_BAD_USE, "rebound is for %s", wants);
  const double psi2 = psi_after(&it, psi1);
  if (isnan(psi2))
    return nb_error_memory(error);
  if (isinf(psi2))
    return nb_error_set(error, NB_BAD_USE, "rebound is for %s", parts);
  add_value(solution, scene, &it, psi1, psi2);
  return solution_status(solution, error);
}

const struct nb_reference reference_rebound = {
    .name = "rebound",
    .title = "velocities and spins after an impact: impulses in gross sliding, else the exact contact as springs",
    .source = "[R89 5.14, 5.15]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_MOVING_WALLS,
                HAS_MEMORY, HAS_RATIO_DAMPING, HAS_UNTIL},
    .needs = {HAS_IMPACT, HAS_FRICTION},
    .normal = "linear hertz",
    .shear = "linear mindlin mindlin_scaled mindlin_deresiewicz randall randall_literal",
    .solve = solve,
};
