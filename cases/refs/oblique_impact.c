/* Reference: oblique impact of a sphere on a wall or on another sphere.
 *
 * `shear mindlin_deresiewicz` is computed as the exact contact, by independent springs (impact_springs.c). A simplified
 * law is computed in its limit for small steps (impact_laws.c). In dimensionless numbers the impact has two parameters,
 * and with `shear linear` also `spring` of impact_springs.h:
 *
 *   psi1 = V_T/(mu kappa V_N)       chi = (1 + m R^2/I)/(2 kappa)       kappa = (E* / G*)/4     [R89 5.14, 5.15]
 *
 * Two spheres x and y have chi = M (1/m_x + R_x^2/I_x + 1/m_y + R_y^2/I_y)/(2 kappa) with 1/M = 1/m_x + 1/m_y. With
 * `mindlin_deresiewicz`, `mindlin` and `randall`, if psi1 >= 4 chi - 1, the contact slides from first touch to
 * separation, and psi2 = psi1 - 4 chi. The dissipated energy follows from the velocities: it is
 * N_max mu^2 kappa alpha_max (psi1^2 - psi2^2)/(5 chi).
 *
 * Returns:
 *   impact.psi1, .psi2, .angle, .restitution, .duration, impact.energy.normal .tangential .rotational    at the end
 *   energy.friction, energy.sliding              dissipated in all, and in gross sliding, J
 *   impact.normal, .shear, .slip versus impact.time
 *   impact.time, .slip in STAGE                    of a stage that ends when gross sliding begins or ends, or
 *                                                  impact.time, .shear or .normal passes a value
 *   C.normal max, C.overlap max                    for C that monitors the contact
 *
 * Source   Maw, Barber and Fawcett (1976) for the numbers [R89 sec. 5.3.2]; Popov and Hess (2015) for the springs.
 * Error    of psi2, and of the curves:   exact contact 1e-6, 3e-5 (2000 steps)
 *                                        linear, mindlin and mindlin_scaled 1e-6, 1e-4;   randall 1e-4, 1e-3
 *                                        (20000 steps)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impact_springs.h"
#include "reference.h"

enum { STEPS = 2000, LAW_STEPS = 20000 };

/* The pair of the scene, in SI. */
struct pair {
  double mass, inverse;      /* M, kg; the sum of 1/m + R^2/I of both, 1/kg */
  double friction, kappa;    /* 1 */
  double spring;             /* k_s, N/m */
  double vn, vt;             /* V_N and V_T of the point of contact at first touch, m/s */
  double centre;             /* V_T of the centre at first touch, m/s */
  double depth, force, time; /* alpha_max, m; N_max, N; T_c, s */
  double rotation;           /* initial rotational energy, J */
};

static double inverse_mass(const struct nb_scene *scene, const struct nb_particle *particle) {
  return particle->fixed ? 0 : 1 / matter_mass(scene, particle);
}
static double inverse_rotational_mass(const struct nb_scene *scene, const struct nb_particle *particle) {
  return particle->fixed ? 0 : particle->radius * particle->radius / matter_inertia(scene, particle);
}

static void read_pair(struct pair *p, const struct nb_scene *scene) {
  const struct nb_monitor *monitor = &scene->monitors[scene->impact.monitor];
  const struct nb_particle *a = &scene->particles[monitor->a];
  const struct nb_particle *b = monitor->kind == NB_MONITOR_PARTICLE_PARTICLE ? &scene->particles[monitor->b] : NULL;
  const struct nb_wall *wall = b ? NULL : &scene->walls[monitor->b];
  const struct matter_pair pair = matter_pair(scene, a->material, b ? b->material : wall->material);
  const double vx = a->vx - (b ? b->vx : wall->vx), vy = a->vy - (b ? b->vy : wall->vy);
  /* from the other sphere's centre, or normal to the wall, to the first sphere */
  double nx = b ? a->x - b->x : -wall->ey, ny = b ? a->y - b->y : wall->ex;
  const double side = b || (a->x - wall->x) * nx + (a->y - wall->y) * ny > 0 ? 1 / hypot(nx, ny) : -1;
  nx *= side, ny *= side;
  const double centre = vx * ny - vy * nx, surface = a->spin * a->radius + (b ? b->spin * b->radius : 0);
  const double radius = matter_radius(a->radius, b ? b->radius : INFINITY);
  *p = (struct pair){
      .mass = 1 / (inverse_mass(scene, a) + (b ? inverse_mass(scene, b) : 0)),
      .inverse = inverse_mass(scene, a) + inverse_rotational_mass(scene, a) +
                 (b ? inverse_mass(scene, b) + inverse_rotational_mass(scene, b) : 0),
      .friction = pair.friction,
      .kappa = pair.young / pair.shear / 4,
      .spring = pair.ks,
      .vn = -(vx * nx + vy * ny),
      .vt = fabs(centre + surface),
      .centre = centre + surface < 0 ? -centre : centre,
      .rotation =
          (matter_inertia(scene, a) * a->spin * a->spin + (b ? matter_inertia(scene, b) * b->spin * b->spin : 0)) / 2,
  };
  /* N = K alpha^(3/2), and at alpha_max the contact stores all of the normal energy [R89 5.5, 5.9]. */
  const double stiffness = 4. / 3 * sqrt(radius) * pair.young;
  p->depth = pow(5 * p->mass * p->vn * p->vn / (4 * stiffness), 0.4);
  p->force = stiffness * pow(p->depth, 1.5);
  p->time = IMPACT_DURATION * p->depth / p->vn;
}

static enum nb_status refuse(const struct nb_scene *scene, struct nb_error *error) {
  const char *why = NULL;
  for (size_t s = 0; s < scene->stage_count && !why; s++)
    if (scene->stages[s].motion_count)
      why = "a wall whose velocity no stage changes";
  return why ? nb_error_set(error, NB_BAD_USE, "the reference `oblique_impact` is for %s", why) : NB_OK;
}

/* A curve versus impact.time: equal steps from first contact to separation, then a straight line. */
struct curve {
  int steps;
  double rate; /* of the straight line, per T_c */
  double values[];
};

static double at(const void *data, double x) {
  const struct curve *c = data;
  if (!(x > 0))
    return 0;
  if (x >= 1)
    return c->values[c->steps] + c->rate * (x - 1);
  const int k = (int)(x * c->steps);
  return c->values[k] + (x * c->steps - k) * (c->values[k + 1] - c->values[k]);
}

static void add_curve(struct nb_solution *solution, const char *name, const double *values, int steps, double scale,
                      double rate) {
  struct curve *c = malloc(sizeof *c + ((size_t)steps + 1) * sizeof(double));
  if (c) {
    *c = (struct curve){.steps = steps, .rate = rate};
    for (int k = 0; k <= steps; k++)
      c->values[k] = scale * values[k];
  }
  solution_curve(solution, name, "impact.time", at, c);
}

/* True: the condition `until` of a stage holds at entry k of the path. Unknown conditions never hold. */
static bool holds(const struct nb_condition *condition, const struct impact_path *path, int k) {
  const char *name = condition->name, *part = strrchr(name, '.');
  double value = NAN;
  if (strcmp(name, "impact.time") == 0)
    value = (double)k / path->steps;
  else if (strcmp(name, "impact.shear") == 0)
    value = path->f[k];
  else if (part && strcmp(part, ".sliding") == 0)
    value = path->slides[k];
  else if (strcmp(name, "impact.normal") == 0)
    value = path->xi[k] * sqrt(path->xi[k]);
  return condition->relation == NB_ABOVE ? value > condition->value : value < condition->value;
}

/* Adds impact.time and impact.slip at the ends of stages that last until gross sliding begins or ends, or until
 * impact.time or a force passes a value. `scale` is the slip, m, for d = 1. */
static void add_stages(struct nb_solution *solution, const struct nb_scene *scene, const struct impact_path *path,
                       double scale) {
  int k = 0;
  for (size_t s = 0; s < scene->stage_count && k < path->steps; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->condition_count != 1)
      return;
    for (k++; k < path->steps && !holds(&stage->conditions[0], path, k); k++) {
    }
    if (k >= path->steps)
      return;
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "impact.time in %s", stage->name);
    solution_value(solution, (k - 0.5) / path->steps, name);
    snprintf(name, sizeof name, "impact.slip in %s", stage->name);
    solution_value(solution, scale * (path->d[k - 1] + path->d[k]) / 2, name);
  }
}

static void add_values(struct nb_solution *solution, const struct nb_scene *scene, const struct pair *p,
                       struct impact_path *path, double chi) {
  const double slope = p->friction * p->kappa, psi1 = p->vt / (slope * p->vn);
  const double impulse = (p->vt - path->psi2 * slope * p->vn) / p->inverse; /* of T, N s */
  const double after = p->centre - impulse / p->mass;
  const double unit = p->force * p->friction * slope * p->depth,
               all = (psi1 * psi1 - path->psi2 * path->psi2) / (5 * chi);
  solution_value(solution, psi1, "impact.psi1");
  solution_value(solution, path->psi2, "impact.psi2");
  solution_value(solution, atan2(fabs(p->centre), p->vn), "impact.angle");
  solution_value(solution, hypot(p->vn, after) / hypot(p->vn, p->centre), "impact.restitution");
  solution_value(solution, p->time, "impact.duration");
  solution_value(solution, p->mass * p->vn * p->vn / 2, "impact.energy.normal");
  solution_value(solution, p->mass * after * after / 2, "impact.energy.tangential");
  const double turned = p->rotation + p->mass * (p->centre * p->centre - after * after) / 2 - unit * all;
  solution_value(solution, turned, "impact.energy.rotational");
  solution_value(solution, unit * all, "energy.friction");
  solution_value(solution, unit * path->slid, "energy.sliding");
  add_curve(solution, "impact.shear", path->f, path->steps, 1, 0);
  add_curve(solution, "impact.slip", path->d, path->steps, slope * p->depth, path->psi2 * slope * p->vn * p->time);
  for (int k = 0; k <= path->steps; k++)
    path->xi[k] *= sqrt(path->xi[k]); /* the array holds N/N_max from here on */
  add_curve(solution, "impact.normal", path->xi, path->steps, 1, 0);
  char name[3 * NB_NAME_SIZE];
  const char *contact = scene->monitors[scene->impact.monitor].name;
  snprintf(name, sizeof name, "%s.normal max", contact);
  solution_value(solution, p->force, name);
  snprintf(name, sizeof name, "%s.overlap max", contact);
  solution_value(solution, p->depth, name);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (refuse(scene, error))
    return error->status;
  struct pair p;
  read_pair(&p, scene);
  if (!(p.vn > 0) || !(p.friction > 0))
    return nb_error_set(error, NB_BAD_USE, "the reference `oblique_impact` is for a contact with friction");
  struct impact_path path;
  const double chi = p.inverse * p.mass / (2 * p.kappa), psi1 = p.vt / (p.friction * p.kappa * p.vn);
  const bool exact = strcmp(scene->shear, "mindlin_deresiewicz") == 0;
  const double spring = p.spring * p.kappa * p.depth / p.force;
  const bool made =
      exact ? impact_exact(&path, chi, psi1, STEPS) : impact_law(&path, scene->shear, spring, chi, psi1, LAW_STEPS);
  if (made)
    add_stages(solution, scene, &path, p.friction * p.kappa * p.depth), add_values(solution, scene, &p, &path, chi);
  impact_path_free(&path);
  return made ? solution_status(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_oblique_impact = {
    .name = "oblique_impact",
    .title = "an oblique impact: exact contact as independent springs, simplified laws as differential equations",
    .source = "[R89 5.5, 5.6, 5.9, 5.12, 5.14, 5.15]",
    .accepts = {HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_MOVING_WALLS, HAS_FRICTION,
                HAS_MEMORY, HAS_UNTIL},
    .needs = {HAS_IMPACT},
    .normal = "hertz",
    .shear = "none linear mindlin mindlin_scaled mindlin_deresiewicz randall",
    .solve = solve,
};
