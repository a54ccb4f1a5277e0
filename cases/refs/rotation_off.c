/* Reference: a rigid disc or sphere slides on a floor with Coulomb friction, with and without rotation.
 *
 * With the velocity v along the floor and the angular velocity w
 *
 *   v' = -mu g            while it slides
 *   w = 0                 without rotation: from the beginning of a stage with `rotation off`
 *   R w' = -q mu g        with rotation, while it slides; q = m R^2/I: 2 for a disc, 5/2 for a sphere
 *
 * The velocity of the contact point is s' = v + R w. With rotation it falls by (1 + q) mu g per second until the
 * particle rolls, v = -R w. Without rotation s' = v falls by mu g per second until the particle stops. A stage with
 * `until C.sliding below X` ends when the particle rolls or stops. mu is the friction of the contact, which the
 * statement `pair` in a stage may change.
 *
 * Returns, for D that monitors the particle:
 *   D.vx, D.spin in STAGE       at the end of each stage
 *   time in STAGE               of a stage with `until`
 *   energy.changed in STAGE     minus the rotational energy that `rotation off` has removed so far; each removal takes
 *                               I w^2/2, with the w before it
 *
 * Source   elementary; the end of sliding as in slide_to_roll.c [MFiX DEM-04].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "single.h"

struct motion {
  double x, v, w, slip;        /* m, m/s, rad/s; s', m/s */
  double q, r, g, mu, inertia; /* 1, m, m/s2, 1, kg m2 */
  double time, removed;        /* s; rotational energy, J */
  int particle, wall;          /* materials */
  bool rotates;
};

/* The time from now to the end of sliding, s. */
static double sliding_time(const struct motion *m) { return m->slip / ((m->rotates ? 1 + m->q : 1) * m->mu * m->g); }

static void advance(struct motion *m, double time) {
  const double sliding = sliding_time(m), t = fmin(time, sliding), deceleration = m->mu * m->g;
  m->x += (m->v - deceleration * t / 2) * t;
  m->v -= deceleration * t;
  if (m->rotates)
    m->w -= m->q * deceleration * t / m->r;
  if (t == sliding && !m->rotates)
    m->v = 0;
  m->x += m->v * (time - t);
  m->time += time;
}

/* Applies what the stage changes at its beginning. False: it changes something that the reference does not cover. */
static bool begin_stage(struct motion *m, const struct nb_stage *stage) {
  if (stage->rotation == NB_ROTATION_OFF) {
    m->removed += m->inertia * m->w * m->w / 2;
    m->w = 0, m->rotates = false;
  }
  m->rotates = m->rotates || stage->rotation == NB_ROTATION_ON;
  const double slip = m->v + m->r * m->w;
  m->slip = fabs(slip) > 1e-12 * fmax(m->v, fabs(m->r * m->w)) ? slip : 0; /* rolling: only rounding is left */
  for (size_t k = 0; k < stage->change_count; k++) {
    const struct nb_change *change = &stage->changes[k];
    const bool of_contact =
        (change->a == m->particle && change->b == m->wall) || (change->a == m->wall && change->b == m->particle);
    if (!of_contact || !isnan(change->kn) || !isnan(change->ks))
      return false;
    m->mu = change->friction;
  }
  return stage->step.kind == NB_STEP_TIME && !stage->motion_count;
}

static bool ends_with_sliding(const struct nb_stage *stage) {
  const char *quantity = strrchr(stage->conditions[0].name, '.');
  return stage->condition_count == 1 && stage->conditions[0].relation == NB_BELOW && quantity &&
         strcmp(quantity, ".sliding") == 0;
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
      scene->walls[0].y > particle->y || !single_faces(&scene->walls[0], particle->x, particle->y) ||
      scene->gravity.x != 0 || !(scene->gravity.y < 0) || !(particle->vx > 0) || particle->vy != 0)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `rotation_off` is for one particle that moves in +x on a level floor, under gravity");
  const struct matter_pair pair = matter_pair(scene, particle->material, scene->walls[0].material);
  struct motion m = {.x = particle->x,
                     .v = particle->vx,
                     .w = particle->spin,
                     .r = particle->radius,
                     .mu = pair.friction,
                     .particle = particle->material,
                     .wall = scene->walls[0].material,
                     .rotates = true};
  m.g = -scene->gravity.y, m.inertia = matter_inertia(scene, particle);
  m.q = matter_mass(scene, particle) * m.r * m.r / m.inertia;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    char name[2 * NB_NAME_SIZE];
    if (!begin_stage(&m, stage) || !(m.mu > 0) || m.slip < 0)
      return nb_error_set(
          error, NB_BAD_USE,
          "the reference `rotation_off` is for a step given as a time, stages that change only `rotation` and the "
          "friction of the pair, and a contact point that moves in +x");
    if (stage->condition_count && !ends_with_sliding(stage))
      return nb_error_set(error, NB_BAD_USE,
                          "the reference `rotation_off` is for stages that end with `until C.sliding below X`");
    advance(&m, stage->condition_count ? sliding_time(&m) : (double)stage->cycles * stage->step.value);
    if (!single_faces(&scene->walls[0], m.x, particle->y))
      return nb_error_set(
          error, NB_BAD_USE,
          "the reference `rotation_off` is for a floor so long that the particle does not reach its end");
    add_value(solution, scene, stage->name, "vx", m.v), add_value(solution, scene, stage->name, "spin", m.w);
    snprintf(name, sizeof name, "time in %s", stage->name);
    if (stage->condition_count)
      solution_value(solution, m.time, name);
    snprintf(name, sizeof name, "energy.changed in %s", stage->name);
    solution_value(solution, -m.removed, name);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_rotation_off = {
    .name = "rotation_off",
    .title = "a rigid particle sliding on a floor with Coulomb friction, with and without rotation",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_SPINS, HAS_FRICTION, HAS_CONTACT_DAMPING, HAS_ROTATION_OFF,
                HAS_UNTIL, HAS_DAMPING_CHANGE, HAS_MATERIAL_CHANGE},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
