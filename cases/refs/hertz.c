/* Head-on impact of two elastic spheres, or of a sphere and a wall: read from the scene.
 *
 *   m* = 1/(1/m_1 + 1/m_2),   R* = 1/(1/R_1 + 1/R_2),   K = (4/3) E* R*^(1/2)           a wall: m_2 and R_2 infinite
 *   alpha* = (5 m* V_N^2/(4 K))^(2/5)                                                    [R89 5.9]
 *   T_c = 2 (alpha* / V_N) Int_0^1 ds/(1 - s^(5/2))^(1/2) = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) alpha* / V_N
 *                                                                                        [R89 5.11, 5.12]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "hertz.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double hertz_duration_factor(void) { return 4 * sqrt(M_PI) / 5 * gsl_sf_gamma(0.4) / gsl_sf_gamma(0.9); }

double hertz_restitution(double beta) {
  const double square = 1.2 * beta * beta;
  return square < 1 ? exp(-M_PI * sqrt(square / (1 - square))) : 0;
}

double hertz_ratio(double restitution) {
  const double l = log(restitution);
  return restitution > 0 ? sqrt(5. / 6) * -l / hypot(M_PI, l) : sqrt(5. / 6);
}

double hertz_force(const struct hertz *hertz, double overlap) {
  return overlap > 0 ? hertz->k * overlap * sqrt(overlap) : 0;
}

static enum nb_status refuse(const char *reference, const char *what, struct nb_error *error) {
  return nb_error_set(error, NB_BAD_USE, "the reference `%s` is for %s", reference, what);
}

/* Whether the wall has a constant velocity. */
static bool steady(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].motion_count)
      return false;
  return true;
}

/* Reads the direction, the speed and the beginning of the impact. False: the particles do not approach head-on, they
 * overlap at first, or the wall ends before the point of impact. */
static bool read_impact(struct hertz *hertz, const struct nb_wall *wall) {
  const struct nb_particle *a = hertz->particles[0], *b = hertz->particles[1];
  double x = b ? b->x - a->x : wall->x - a->x, y = b ? b->y - a->y : wall->y - a->y;
  if (!b) { /* the foot of the perpendicular must lie on the wall */
    const double s = -(x * wall->ex + y * wall->ey);
    if (!(s > wall->h1 && s < wall->h2))
      return false;
    x += s * wall->ex, y += s * wall->ey;
  }
  const double distance = hypot(x, y);
  hertz->ex = x / distance, hertz->ey = y / distance;
  const double vx = a->vx - (b ? b->vx : wall->vx), vy = a->vy - (b ? b->vy : wall->vy), v = hypot(vx, vy);
  hertz->speed = vx * hertz->ex + vy * hertz->ey;
  const double gap = distance - a->radius - (b ? b->radius : 0);
  hertz->begin = gap / hertz->speed;
  return hertz->speed > 0 && fabs(vx * hertz->ey - vy * hertz->ex) < 1e-12 * v && gap > -1e-12 * a->radius;
}

/* Computes the other members from masses, moduli and speed. */
static void solve_equations(struct hertz *hertz) {
  hertz->k = 4. / 3 * hertz->young * sqrt(hertz->radius);
  hertz->depth = pow(5 * hertz->mass * hertz->speed * hertz->speed / (4 * hertz->k), 0.4);
  hertz->unit = hertz->depth / hertz->speed;
  hertz->duration = hertz_duration_factor() * hertz->unit;
}

enum nb_status hertz_read(struct hertz *hertz, const struct nb_scene *scene, const char *reference,
                          struct nb_error *error) {
  if (scene->particle_count + scene->wall_count != 2 || scene->particle_count < 1 || scene->particles[0].fixed)
    return refuse(reference, "a free sphere that strikes another sphere or a wall", error);
  if (!steady(scene))
    return refuse(reference, "a wall whose velocity no stage changes", error);
  const struct nb_particle *a = &scene->particles[0], *b = scene->particle_count == 2 ? &scene->particles[1] : NULL;
  const struct nb_wall *wall = b ? NULL : &scene->walls[0];
  *hertz = (struct hertz){.particles = {a, b}, .scene = scene};
  hertz->mass = 1 / (1 / matter_mass(scene, a) + (b && !b->fixed ? 1 / matter_mass(scene, b) : 0));
  hertz->radius = matter_radius(a->radius, b ? b->radius : INFINITY);
  hertz->young = matter_pair(scene, a->material, b ? b->material : wall->material).young;
  if (!(hertz->young > 0) || !isfinite(hertz->young))
    return refuse(reference, "elastic spheres, whose materials have `young`", error);
  if (!read_impact(hertz, wall))
    return refuse(reference, "particles that collide head-on and do not overlap at first", error);
  solve_equations(hertz);
  hertz->step = scene->step.kind == NB_STEP_COLLISION ? scene->step.value * hertz->duration : scene->step.value;
  if (scene->step.kind != NB_STEP_TIME && scene->step.kind != NB_STEP_COLLISION)
    return refuse(reference, "a step given as a time or as a fraction of the duration of the collision", error);
  if (scene->impact.line)
    hertz->begin += scene->impact.phase * hertz->step;
  nb_damping_at(&scene->damping, wall != NULL, &hertz->damping);
  return NB_OK;
}

static const char *contact_of(const struct hertz *hertz) {
  for (size_t w = 0; w < hertz->scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &hertz->scene->monitors[w];
    if (monitor->kind == NB_MONITOR_PARTICLE_PARTICLE || monitor->kind == NB_MONITOR_PARTICLE_WALL)
      return monitor->name;
  }
  return NULL;
}

void hertz_add(struct nb_solution *solution, const struct hertz *hertz, const char *what, double value) {
  const char *contact = contact_of(hertz);
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s", contact ? contact : "", what);
  if (contact)
    solution_value(solution, value, name);
}

void hertz_curve(struct nb_solution *solution, const struct hertz *hertz, const char *what, const char *along,
                 double (*at)(const void *data, double x), const void *data, size_t size) {
  const char *contact = contact_of(hertz);
  const bool time = strcmp(along, "time") == 0;
  char name[2 * NB_NAME_SIZE], column[2 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%.*s.%s", NB_NAME_SIZE, contact ? contact : "", what);
  snprintf(column, sizeof column, "%.*s%s%s", NB_NAME_SIZE, time ? "" : contact ? contact : "", time ? "" : ".", along);
  if (!contact)
    return;
  void *copy = malloc(size);
  if (copy)
    memcpy(copy, data, size);
  solution_curve(solution, name, column, at, copy);
}

/* Adds overlap and elastic force; `behind` follows their names. */
static void add_both(struct nb_solution *solution, const struct hertz *hertz, const char *behind, const char *stage,
                     double overlap) {
  char what[2 * NB_NAME_SIZE];
  snprintf(what, sizeof what, "overlap%s%s%s", behind, stage ? " in " : "", stage ? stage : "");
  hertz_add(solution, hertz, what, overlap);
  snprintf(what, sizeof what, "normal%s%s%s", behind, stage ? " in " : "", stage ? stage : "");
  hertz_add(solution, hertz, what, hertz_force(hertz, overlap));
}

void hertz_add_stages(struct nb_solution *solution, const struct hertz *hertz,
                      double (*overlap_at)(const void *data, double t), const void *data, double deepest, double when) {
  const struct nb_scene *scene = hertz->scene;
  double begin = 0;
  add_both(solution, hertz, " max", NULL, deepest);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->condition_count || stage->step.kind != scene->step.kind || stage->step.value != scene->step.value)
      return;
    const double end = begin + (double)stage->cycles * hertz->step;
    if (begin <= when && when < end)
      add_both(solution, hertz, " max", stage->name, deepest);
    add_both(solution, hertz, "", stage->name, overlap_at(data, end));
    begin = end;
  }
}
