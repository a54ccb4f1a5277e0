/* Reference: motion reversed after half of the cycles returns to its start with opposite velocities.
 *
 * This holds for the continuous motion without friction and damping, and for the leapfrog scheme, which is symmetric in
 * time.
 *
 * Returns, at the end, for D that monitors a particle:
 *   D.x, D.y, D.angle      as at the start; the angle is 0
 *   D.vx, D.vy, D.spin     as at the start, with the opposite sign
 * Accepts one stage with `reverse velocities`, equal numbers of cycles before and after its beginning, one time step,
 * and walls whose motion only the first stage sets. Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "reference.h"

static void add_value(struct nb_solution *solution, const char *monitor, const char *what, double value) {
  char text[3 * NB_NAME_SIZE];
  snprintf(text, sizeof text, "%s.%s", monitor, what);
  solution_value(solution, value, text);
}

static bool is_symmetric(const struct nb_scene *scene) {
  unsigned long cycles[2] = {0, 0};
  int turns = 0;
  bool plain = true;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    turns += stage->reverse_velocities;
    cycles[turns > 0] += stage->cycles;
    plain = plain && (!stage->motion_count || s == 0);
  }
  return plain && turns == 1 && cycles[0] == cycles[1];
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (!is_symmetric(scene))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `time_reversal` is for one `reverse velocities`, as many cycles before it as "
                        "after it, and walls "
                        "whose motion is set only in the first stage");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_PARTICLE)
      continue;
    const struct nb_particle *particle = &scene->particles[monitor->a];
    add_value(solution, monitor->name, "x", particle->x), add_value(solution, monitor->name, "y", particle->y);
    add_value(solution, monitor->name, "angle", 0);
    add_value(solution, monitor->name, "vx", -particle->vx), add_value(solution, monitor->name, "vy", -particle->vy);
    add_value(solution, monitor->name, "spin", -particle->spin);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_time_reversal = {
    .name = "time_reversal",
    .title = "motion reversed in time: the initial state with opposite velocities",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_WALLS, HAS_MOVING_WALLS, HAS_TURNING_WALLS,
                HAS_OFFSET_WALLS, HAS_GRAVITY},
    .needs = {HAS_REVERSE_VELOCITIES},
    .normal = "linear hertz",
    .shear = "none",
    .solve = solve,
};
