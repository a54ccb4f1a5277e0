/* Reference: a body pressed between two plates that drag it against a frictionless stop: where it slips.
 *
 * A plate that has come nearer by d presses with F_n = k_n d/2: two equal springs in series. Then both plates move along by
 * s = v t. Each drags with F_s = k_s (s - u), u the body's own way into the stop, k_stop u = 2 F_s; the two moments cancel:
 *
 *   F_s = min(k_s s/(1 + 2 k_s/k_stop),  F_n tan phi + c)              c, tan phi the smaller ones of the two [CS79 19]
 *
 * Where the plates have parted from the body nothing is left: F_n = F_s = 0, whatever c is.
 *
 * The scene: one free body; the first two walls along x, one below and one above it, that just touch; a third one along y that
 * the body just touches, without friction and cohesion. Stages in this order: one that moves the second wall only, any that
 * move nothing, one that moves the first two along x alike, the last one moves the second wall away.
 *
 * Known, where LOW watches the body's contact with the first wall and HIGH with the second:
 *   LOW.normal, LOW.shear in the dragging stage, and HIGH the same; their size only, F_s of the two have opposite signs
 *   HIGH.normal, HIGH.shear in the last stage
 * At rest and slow: the body's inertia is neglected.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

static bool moves(const struct nb_stage *stage, int wall, double *vx, double *vy) {
  for (size_t k = 0; k < stage->motion_count; k++)
    if (stage->motions[k].wall == wall) {
      *vx = stage->motions[k].vx, *vy = stage->motions[k].vy;
      return true;
    }
  return false;
}

static double step_of(const struct nb_scene *scene) {
  return scene->step.kind == NB_STEP_TIME ? scene->step.value : NAN;
}

struct drag {
  double press, way; /* d, s: m */
  int dragging;      /* stage */
};

/* What the walls do, stage by stage; false when it is not what this reference is for. */
static bool read_stages(struct drag *drag, const struct nb_scene *scene) {
  double vx = 0, vy = 0, low = 0;
  drag->dragging = -1;
  for (size_t s = 0; s + 1 < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    double zero;
    moves(stage, 1, &vx, &vy);
    moves(stage, 0, &low, &zero);
    const double time = step_of(scene) * (double)stage->cycles;
    if (low != vx || (vx != 0 && vy != 0))
      return false;
    drag->press -= vy * time;
    drag->way += vx * time;
    if (vx != 0)
      drag->dragging = (int)s;
  }
  const struct nb_stage *last = &scene->stages[scene->stage_count - 1];
  return drag->dragging >= 0 && moves(last, 1, &vx, &vy) && vy * step_of(scene) * (double)last->cycles > drag->press;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct drag drag = {0};
  if (scene->particle_count != 1 || scene->wall_count != 3 || !read_stages(&drag, scene))
    return nb_error_set(error, NB_BAD_USE,
                        "cohesion is for one body between two plates that press, drag it and part, and a stop");
  const int particle = scene->particles[0].material;
  const struct matter_pair pair = matter_pair(scene, particle, scene->walls[0].material);
  const struct matter_pair stop = matter_pair(scene, particle, scene->walls[2].material);
  const double normal = pair.kn * drag.press / 2, limit = normal * pair.friction + pair.cohesion;
  const double stuck = pair.ks * drag.way / (1 + 2 * pair.ks / stop.kn);
  const double shear = fabs(stuck) < limit ? stuck : copysign(limit, stuck);
  const char *dragging = scene->stages[drag.dragging].name, *last = scene->stages[scene->stage_count - 1].name;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_PARTICLE_WALL || monitor->b > 1)
      continue;
    /* e points down at the first wall and up at the second, so t points west and then east. F_s is how far the body has gone
     * along t past the wall: the plates go east, the body falls behind, so F_s is positive below and negative above. */
    single_add(solution, monitor->name, "normal", dragging, normal);
    single_add(solution, monitor->name, "shear", dragging, monitor->b == 0 ? shear : -shear);
    if (monitor->b == 1) {
      single_add(solution, monitor->name, "normal", last, 0);
      single_add(solution, monitor->name, "shear", last, 0);
    }
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_cohesion = {
    .name = "cohesion",
    .title = "a body dragged by two plates: it slips at F_n tan(phi) + c",
    .source = "[CS79 19]",
    .accepts = {HAS_DISCS, HAS_MOVING_WALLS, HAS_FRICTION, HAS_COHESION, HAS_CONTACT_DAMPING},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
