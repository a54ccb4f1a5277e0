/* Reference: energy removed with particles and walls by `remove`, and the motion of their neighbours.
 *
 * Initially every particle is either at rest in equilibrium or in free flight. Removed particles and walls take away
 *
 *   sum m v^2/2 + I w^2/2     the kinetic energy of the particles, with the velocities v and angular velocities w of
 *                             the page
 *   sum k_n alpha^2/2         the energy of the springs at their contacts, each spring once; alpha is the initial
 *                             overlap in m
 *
 * A particle at rest between a wall and a removed particle or wall becomes a mass m on the spring of the wall that
 * remains. At the removal this spring is compressed by alpha:
 *
 *   x = x_0 + alpha (1 - cos q t),   v = alpha q sin q t,   q = sqrt(k_n/m),   away from the wall, until q t = pi/2
 *   v = alpha q, constant                                   from then on
 *
 * Returns:
 *   energy.removed
 *   D.x, D.y versus time; D.vx, D.vy at the end   for D that monitors such a neighbour
 * Exact. In a run D has the error of the step, and energy.removed has only rounding errors.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

static double overlap_of(const struct nb_particle *a, const struct nb_particle *b) {
  return a->radius + b->radius - hypot(a->x - b->x, a->y - b->y);
}

/* The overlap of particle and wall, and the unit normal from the wall to the particle. */
static double wall_overlap(const struct nb_particle *particle, const struct nb_wall *wall, double normal[2]) {
  const double dx = particle->x - wall->x, dy = particle->y - wall->y;
  const double along = fmin(fmax(dx * wall->ex + dy * wall->ey, wall->h1), wall->h2);
  const double nx = dx - along * wall->ex, ny = dy - along * wall->ey, away = hypot(nx, ny);
  normal[0] = nx / away, normal[1] = ny / away;
  return particle->radius - away;
}

/* The stage that removes a particle; the number of stages if none does. */
static size_t removal_stage(const struct nb_scene *scene, size_t particle) {
  size_t s = 0;
  for (; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].removal_count; k++)
      if (scene->stages[s].removals[k].from <= particle && particle <= scene->stages[s].removals[k].to)
        return s;
  return s;
}

/* As removal_stage, for a wall. */
static size_t wall_removal_stage(const struct nb_scene *scene, size_t wall) {
  size_t s = 0;
  for (; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].motion_count; k++)
      if (scene->stages[s].motions[k].removed && scene->stages[s].motions[k].wall == (int)wall)
        return s;
  return s;
}

static double spring_energy(double k, double overlap) { return overlap > 0 ? k * overlap * overlap / 2 : 0; }

static double removed_energy(const struct nb_scene *scene) {
  double sum = 0, normal[2];
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *a = &scene->particles[i];
    const bool removed = removal_stage(scene, i) < scene->stage_count;
    for (size_t j = i + 1; j < scene->particle_count; j++)
      if (removed || removal_stage(scene, j) < scene->stage_count)
        sum += spring_energy(matter_pair(scene, a->material, scene->particles[j].material).kn,
                             overlap_of(a, &scene->particles[j]));
    for (size_t w = 0; w < scene->wall_count; w++)
      if (removed || wall_removal_stage(scene, w) < scene->stage_count)
        sum += spring_energy(matter_pair(scene, a->material, scene->walls[w].material).kn,
                             wall_overlap(a, &scene->walls[w], normal));
    if (removed)
      sum +=
          (matter_mass(scene, a) * (a->vx * a->vx + a->vy * a->vy) + matter_inertia(scene, a) * a->spin * a->spin) / 2;
  }
  return sum;
}

struct oscillation {
  double from, along, overlap, q, begin; /* m, component of the normal, m, 1/s, s */
};

static double position(const void *data, double time) {
  const struct oscillation *it = data;
  const double t = time - it->begin, angle = it->q * t;
  if (!(t > 0))
    return it->from;
  return it->from + it->along * it->overlap * (angle < pi / 2 ? 1 - cos(angle) : 1 + angle - pi / 2);
}

/* Reads the motion of a particle at rest between one wall that stays and one particle or wall that stage 2 removes, and
 * the normal of the wall that stays. `end` is the time of the end of the run, s. False: the particle is not such a
 * neighbour, or the run ends before it leaves the wall. */
static bool read_neighbour(struct oscillation *oscillation, double normal[2], const struct nb_scene *scene,
                           const struct nb_particle *particle, double end) {
  size_t walls = 0, removed = 0, others = 0;
  *oscillation = (struct oscillation){0};
  for (size_t j = 0; j < scene->particle_count; j++)
    if (&scene->particles[j] != particle && overlap_of(particle, &scene->particles[j]) > 0)
      removed += removal_stage(scene, j) == 1, others += removal_stage(scene, j) != 1;
  for (size_t w = 0; w < scene->wall_count; w++) {
    double away[2];
    const double overlap = wall_overlap(particle, &scene->walls[w], away);
    if (!(overlap > 0))
      continue;
    if (wall_removal_stage(scene, w) < scene->stage_count) {
      removed++;
      continue;
    }
    walls++, oscillation->overlap = overlap, normal[0] = away[0], normal[1] = away[1];
    oscillation->q =
        sqrt(matter_pair(scene, particle->material, scene->walls[w].material).kn / matter_mass(scene, particle));
  }
  oscillation->begin = (double)scene->stages[0].cycles * scene->stages[0].step.value;
  const bool rests = particle->vx == 0 && particle->vy == 0;
  return rests && walls == 1 && removed == 1 && others == 0 && oscillation->q * (end - oscillation->begin) > pi / 2;
}

static void add_axis(struct nb_solution *solution, const struct oscillation *oscillation, const char *monitor,
                     double from, double along, const char *axis) {
  char name[2 * NB_NAME_SIZE];
  struct oscillation *data = malloc(sizeof *data);
  if (data)
    *data = *oscillation, data->from = from, data->along = along;
  snprintf(name, sizeof name, "%s.%s", monitor, axis);
  solution_curve(solution, name, "time", position, data);
  snprintf(name, sizeof name, "%s.v%s", monitor, axis);
  solution_value(solution, along * oscillation->overlap * oscillation->q, name);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *stages = scene->stages;
  bool early = stages[0].removal_count > 0;
  for (size_t w = 0; w < scene->wall_count; w++)
    early = early || wall_removal_stage(scene, w) == 0;
  if (scene->stage_count != 2 || early || stages[0].step.kind != NB_STEP_TIME)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `taken_out` is for two stages, of which only the second removes something, and a "
        "step given as a time");
  const double end = (double)stages[0].cycles * stages[0].step.value + (double)stages[1].cycles * stages[1].step.value;
  solution_value(solution, removed_energy(scene), "energy.removed");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    struct oscillation oscillation;
    double normal[2] = {0, 0};
    if (monitor->kind != NB_MONITOR_PARTICLE ||
        !read_neighbour(&oscillation, normal, scene, &scene->particles[monitor->a], end))
      continue;
    add_axis(solution, &oscillation, monitor->name, scene->particles[monitor->a].x, normal[0], "x");
    add_axis(solution, &oscillation, monitor->name, scene->particles[monitor->a].y, normal[1], "y");
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_taken_out = {
    .name = "taken_out",
    .title =
        "particles and walls removed beside particles at rest: energy of the springs, neighbours on the springs of "
        "their walls",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_REMOVE_WALL},
    .needs = {HAS_REMOVE},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
