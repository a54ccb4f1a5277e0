/* Reference: bodies that are taken out, and what they were pressed between.
 *
 * First all is at rest or flies freely, pressed or not. What is taken out carries away
 *
 *   sum m v^2/2 + I w^2/2     its kinetic energy, v and w of the page, since nothing has changed them
 *   sum k_n alpha^2/2         what the springs of its contacts hold, each spring once; alpha the overlap at time 0, m
 *
 * A body that a wall pressed against one that is gone is then a mass m on the wall's spring, alpha from its rest, at rest:
 *
 *   x = x_0 + alpha (1 - cos q t),   v = alpha q sin q t,   q = sqrt(k_n/m),   away from the wall, until q t = pi/2
 *   v = alpha q, and straight on                            from then on
 *
 * Known, when NAME watches such a neighbour:
 *   energy.removed
 *   NAME.x, NAME.y           along time
 *   NAME.vx, NAME.vy         at the end
 * Exact. A run has the error of its step in NAME, none but rounding in energy.removed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

static double between(const struct nb_particle *a, const struct nb_particle *b) {
  return a->radius + b->radius - hypot(a->x - b->x, a->y - b->y);
}

/* How far the wall is pressed into the body; the unit normal from the wall to it. */
static double at_wall(const struct nb_particle *particle, const struct nb_wall *wall, double normal[2]) {
  const double dx = particle->x - wall->x, dy = particle->y - wall->y;
  const double along = fmin(fmax(dx * wall->ex + dy * wall->ey, wall->h1), wall->h2);
  const double nx = dx - along * wall->ex, ny = dy - along * wall->ey, away = hypot(nx, ny);
  normal[0] = nx / away, normal[1] = ny / away;
  return particle->radius - away;
}

/* The stage that takes a body out; the number of stages when none does. */
static size_t stage_of(const struct nb_scene *scene, size_t particle) {
  size_t s = 0;
  for (; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].removal_count; k++)
      if (scene->stages[s].removals[k].from <= particle && particle <= scene->stages[s].removals[k].to)
        return s;
  return s;
}

static double spring(double k, double overlap) { return overlap > 0 ? k * overlap * overlap / 2 : 0; }

static double imposed_away(const struct nb_scene *scene) {
  double sum = 0, normal[2];
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *a = &scene->particles[i];
    const bool removed = stage_of(scene, i) < scene->stage_count;
    for (size_t j = i + 1; j < scene->particle_count; j++)
      if (removed || stage_of(scene, j) < scene->stage_count)
        sum +=
            spring(matter_pair(scene, a->material, scene->particles[j].material).kn, between(a, &scene->particles[j]));
    if (!removed)
      continue;
    sum += (matter_mass(scene, a) * (a->vx * a->vx + a->vy * a->vy) + matter_inertia(scene, a) * a->spin * a->spin) / 2;
    for (size_t w = 0; w < scene->wall_count; w++)
      sum += spring(matter_pair(scene, a->material, scene->walls[w].material).kn, at_wall(a, &scene->walls[w], normal));
  }
  return sum;
}

struct oscillation {
  double from, along, overlap, q, begin; /* m, component of the normal, m, 1/s, s */
};

static double place(const void *data, double time) {
  const struct oscillation *it = data;
  const double t = time - it->begin, angle = it->q * t;
  if (!(t > 0))
    return it->from;
  return it->from + it->along * it->overlap * (angle < pi / 2 ? 1 - cos(angle) : 1 + angle - pi / 2);
}

/* Between one wall and one body that goes, if it is; then how it swings. */
static bool pressed(struct oscillation *oscillation, double normal[2], const struct nb_scene *scene,
                    const struct nb_particle *particle, double end) {
  size_t walls = 0, particles = 0;
  *oscillation = (struct oscillation){0};
  for (size_t j = 0; j < scene->particle_count; j++)
    if (&scene->particles[j] != particle && between(particle, &scene->particles[j]) > 0)
      particles += stage_of(scene, j) == 1 ? 1 : 2;
  for (size_t w = 0; w < scene->wall_count; w++) {
    double away[2];
    const double overlap = at_wall(particle, &scene->walls[w], away);
    if (!(overlap > 0))
      continue;
    walls++, oscillation->overlap = overlap, normal[0] = away[0], normal[1] = away[1];
    oscillation->q =
        sqrt(matter_pair(scene, particle->material, scene->walls[w].material).kn / matter_mass(scene, particle));
  }
  oscillation->begin = (double)scene->stages[0].cycles * scene->stages[0].step.value;
  return walls == 1 && particles == 1 && oscillation->q * (end - oscillation->begin) > pi / 2;
}

static void add_place(struct nb_solution *solution, const struct oscillation *oscillation, const char *monitor,
                      double from, double along, const char *axis) {
  char name[2 * NB_NAME_SIZE];
  struct oscillation *mine = malloc(sizeof *mine);
  if (mine)
    *mine = *oscillation, mine->from = from, mine->along = along;
  snprintf(name, sizeof name, "%s.%s", monitor, axis);
  solution_curve(solution, name, "time", place, mine);
  snprintf(name, sizeof name, "%s.v%s", monitor, axis);
  solution_value(solution, along * oscillation->overlap * oscillation->q, name);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *stages = scene->stages;
  if (scene->stage_count != 2 || stages[0].removal_count || stages[0].step.kind != NB_STEP_TIME)
    return nb_error_set(error, NB_BAD_USE,
                        "taken_out wants two stages of which the second takes bodies out, and a step that is a time");
  const double end = (double)stages[0].cycles * stages[0].step.value + (double)stages[1].cycles * stages[1].step.value;
  solution_value(solution, imposed_away(scene), "energy.removed");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    struct oscillation oscillation;
    double normal[2] = {0, 0};
    if (monitor->kind != NB_MONITOR_PARTICLE ||
        !pressed(&oscillation, normal, scene, &scene->particles[monitor->a], end))
      continue;
    add_place(solution, &oscillation, monitor->name, scene->particles[monitor->a].x, normal[0], "x");
    add_place(solution, &oscillation, monitor->name, scene->particles[monitor->a].y, normal[1], "y");
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_taken_out = {
    .name = "taken_out",
    .title = "bodies taken out of a row at rest: energy from the springs, neighbours on their walls' springs",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS},
    .needs = {HAS_REMOVE},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
