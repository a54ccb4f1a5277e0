/* Reference: a body that slides on a floor, while it may turn and while it may not; rigid bodies and Coulomb's friction.
 *
 *   v' = -mu g            as long as it slides, whatever it does besides
 *   w = 0                 with `rotation off`, from the moment on that a stage says so
 *   R w' = -q mu g        with rotation, q = m R^2/I: 2 for a disc, 5/2 for a sphere; so the slip s' = v + R w falls by (1 + q) mu g a
 *                         second, and is gone after s'/((1 + q) mu g): then it rolls, with v = -R w and no friction
 *
 * mu is what `pair` says of the two materials, in the scene and in stages. A stage with `until` ends when the slip is gone.
 *
 * Known, when NAME watches the body: NAME.vx, NAME.spin in each stage, at its end; `time in STAGE` of one that ends when the slip is gone;
 *   energy.changed in STAGE     -I w^2/2 of the spins that have been stopped
 *
 * Source   elementary; the end of sliding as in slide_to_roll.c [MFiX DEM-04].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

struct motion {
  double v, w, slip;           /* m/s, rad/s, m/s */
  double q, r, g, mu, inertia; /* 1, m, m/s2, 1, kg m2 */
  double time, stopped;        /* s; J */
  bool turns;
};

/* On for so long, sliding or rolling. */
static void go(struct motion *m, double time) {
  const double brake = m->mu * m->g, slides = m->turns ? m->slip / ((1 + m->q) * brake) : m->v / brake;
  const double t = fmin(time, slides);
  m->v -= brake * t;
  if (m->turns)
    m->w -= m->q * brake * t / m->r;
  m->slip = t < slides ? m->v + m->r * m->w : 0;
  m->time += time;
}

/* What the stage changes at its begin; false when it is something else too. */
static bool begin(struct motion *m, const struct nb_stage *stage) {
  if (stage->rotation == NB_ROTATION_OFF) {
    m->stopped += m->turns ? m->inertia * m->w * m->w / 2 : 0;
    m->w = 0, m->turns = false;
  }
  m->turns = m->turns || stage->rotation == NB_ROTATION_ON;
  m->slip = m->v + m->r * m->w;
  for (size_t k = 0; k < stage->change_count; k++) {
    const struct nb_change *change = &stage->changes[k];
    if (change->b < 0 || change->ramp || !isnan(change->kn) || !isnan(change->ks) || !isnan(change->cohesion))
      return false;
    m->mu = change->friction;
  }
  return stage->step.kind == NB_STEP_TIME && !stage->motion_count && !stage->gravity.line &&
         stage->condition_count <= 1;
}

static void add_value(struct nb_solution *solution, const struct nb_scene *scene, const char *stage, const char *what,
                      double value) {
  for (size_t w = 0; w < scene->monitor_count; w++)
    if (scene->monitors[w].kind == NB_MONITOR_PARTICLE) {
      char name[3 * NB_NAME_SIZE];
      snprintf(name, sizeof name, "%s.%s in %s", scene->monitors[w].name, what, stage);
      solution_value(solution, value, name);
    }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *particle = scene->particles;
  if (scene->particle_count != 1 || scene->wall_count != 1 || scene->walls[0].ey != 0 ||
      scene->walls[0].y > particle->y || scene->gravity.x != 0 || !(scene->gravity.y < 0) || !(particle->vx > 0) ||
      particle->vy != 0)
    return nb_error_set(error, NB_BAD_USE,
                        "rotation_off wants one body that moves east on a level floor, under gravity");
  const struct matter_pair pair = matter_pair(scene, particle->material, scene->walls[0].material);
  struct motion m = {.v = particle->vx, .w = particle->spin, .r = particle->radius, .mu = pair.friction, .turns = true};
  m.g = -scene->gravity.y, m.inertia = matter_inertia(scene, particle);
  m.q = matter_mass(scene, particle) * m.r * m.r / m.inertia;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    char name[2 * NB_NAME_SIZE];
    if (!begin(&m, stage) || !(m.mu > 0) || m.slip < 0)
      return nb_error_set(error, NB_BAD_USE,
                          "rotation_off wants stages of a step that is a time, which change rotation and the friction "
                          "of the pair alone, and slip to the east");
    go(&m, stage->condition_count ? m.slip / ((1 + m.q) * m.mu * m.g) : (double)stage->cycles * stage->step.value);
    add_value(solution, scene, stage->name, "vx", m.v), add_value(solution, scene, stage->name, "spin", m.w);
    snprintf(name, sizeof name, "time in %s", stage->name);
    if (stage->condition_count)
      solution_value(solution, m.time, name);
    snprintf(name, sizeof name, "energy.changed in %s", stage->name);
    solution_value(solution, -m.stopped, name);
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_rotation_off = {
    .name = "rotation_off",
    .title = "a body that slides, while it may turn and while it may not: Coulomb's friction of rigid bodies",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_FRICTION, HAS_CONTACT_DAMPING, HAS_ROTATION_OFF,
                HAS_UNTIL, HAS_DAMPING_CHANGE, HAS_MATERIAL_CHANGE},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
