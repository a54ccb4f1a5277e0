/* The motion half of a cycle.                                        [CS79 20-25, 29-36]
 *
 *   v_(N+1/2) = v_(N-1/2) + (sum F / m)_N dt,    x_(N+1) = x_N + v_(N+1/2) dt            22, 22a
 *   w_(N+1/2) = w_(N-1/2) + (sum M / I)_N dt,    theta_(N+1) = theta_N + w_(N+1/2) dt    23, 23a
 *
 * With global damping the old velocity is multiplied by `keep`, the force by `push`:
 *
 *   C = alpha m        keep = (1 - alpha dt/2)/(1 + alpha dt/2),   push = 1/(1 + alpha dt/2)     34-36
 *   CON1, as CS79      keep = CON1/(2 - CON1),   push = 1/(2 - CON1)       the same with alpha dt/2 = 1 - CON1
 *   CON1, velocity     keep = CON1,              push = 1
 *   CON1, all          keep = CON1,              push = CON1
 *
 * The velocities of a page belong to time 0, those of the scheme to half steps: the first kick lasts half a step, and one
 * between two steps of unlike length the mean of both. BALL starts from rest without forces, where that is the same.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

static double kick_time(const struct nb_model *model) { return (model->previous_step + model->step) / 2; }

struct factors {
  double keep, push;
};

static struct factors factors(const struct nb_model *model, double dt) {
  const double g = model->damping.global, half = g * dt / 2;
  switch (model->damping.global_kind) {
  case NB_GLOBAL_ALPHA:
    return (struct factors){(1 - half) / (1 + half), 1 / (1 + half)};
  case NB_GLOBAL_CON1_CS79:
    return (struct factors){g / (2 - g), 1 / (2 - g)};
  case NB_GLOBAL_CON1_VELOCITY:
    return (struct factors){g, 1};
  case NB_GLOBAL_CON1_ALL:
    return (struct factors){g, g};
  case NB_GLOBAL_UNDAMPED:
    break;
  }
  return (struct factors){1, 1};
}

/* Where the forces on bodies are found. */
struct felt {
  const size_t *first, *middle;
  const int *entry;
  const struct nb_vec *force;
  const double *drag; /* NULL: no shear */
};

static struct felt felt_by(const struct nb_model *model) {
  return (struct felt){model->incidence.first, model->incidence.middle, model->incidence.entry, model->contacts.force,
                       model->contacts.kept[model->drag]};
}

/* The force stored is the one on the contact's first body, so where a body is second it feels the opposite. The moment is
 * F_s R counterclockwise on both [CS79, The force-displacement law]. */
static inline struct nb_force force_on(const struct felt *felt, size_t slot, double radius) {
  const size_t first = felt->first[slot], middle = felt->middle[slot], end = felt->first[slot + 1];
  struct nb_force sum = {.moment = 0};
  nb_both both = {0, 0};
  for (size_t k = first; k < middle; k++)
    both -= vec_both(&felt->force[felt->entry[k]]);
  for (size_t k = middle; k < end; k++)
    both += vec_both(&felt->force[felt->entry[k]]);
  vec_put(&sum.force, both);
  if (!felt->drag)
    return sum;
  for (size_t k = first; k < end; k++)
    sum.moment += felt->drag[felt->entry[k]];
  sum.moment *= radius;
  return sum;
}

struct nb_force nb_force_on(const struct nb_model *model, size_t slot) {
  const struct felt felt = felt_by(model);
  return force_on(&felt, slot, model->bodies.rim[slot].x);
}

/* What is fixed goes on as it goes: no force and no damping reaches it. */
static inline struct nb_state kicked(const struct nb_bodies *bodies, const struct felt *felt, size_t slot,
                                     struct factors f, double time) {
  const struct nb_state before = {bodies->velocity[slot], bodies->spin ? bodies->spin[slot] : 0};
  if (!(bodies->inverse_mass[slot] > 0))
    return before;
  const struct nb_force sum = force_on(felt, slot, bodies->rim[slot].x);
  const double linear = f.push * time * bodies->inverse_mass[slot];
  const double turning = f.push * time * bodies->inverse_inertia[slot];
  return (struct nb_state){vec_add(vec_scale(f.keep, before.velocity), vec_scale(linear, sum.force)),
                           f.keep * before.spin + turning * sum.moment};
}

struct nb_state nb_velocity_now(const struct nb_model *model, size_t slot) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct nb_state before = {bodies->velocity[slot], bodies->spin ? bodies->spin[slot] : 0};
  const double dt = model->previous_step;
  if (!(dt > 0))
    return before; /* the start: a page's velocities are those of time 0 */
  const struct felt felt = felt_by(model);
  const struct nb_state next = kicked(bodies, &felt, slot, factors(model, dt), dt);
  return (struct nb_state){vec_scale(0.5, vec_add(before.velocity, next.velocity)), (before.spin + next.spin) / 2};
}

/* Bodies of one thread; answers the square of the largest speed, and in `lost` the first slot that is not a number. The
 * pointers are copied to where no store through one of them can be thought to change another. */
static double move_bodies(struct nb_model *model, size_t from, size_t to, size_t *lost) {
  const struct nb_bodies bodies = model->bodies;
  const struct felt felt = felt_by(model);
  const struct factors f = factors(model, kick_time(model));
  const double time = kick_time(model), dt = model->step;
  double fastest = 0;
  for (size_t i = from; i < to; i++) {
    const struct nb_state next = kicked(&bodies, &felt, i, f, time);
    const struct nb_vec x = vec_add(bodies.position[i], vec_scale(dt, next.velocity));
    double sum = x.x + x.y;
    bodies.velocity[i] = next.velocity;
    bodies.position[i] = x;
    if (bodies.spin) {
      bodies.spin[i] = next.spin;
      bodies.angle[i] += next.spin * dt;
      bodies.rim[i].y = next.spin * bodies.rim[i].x;
      sum += bodies.angle[i];
    }
    const double square = vec_dot(next.velocity, next.velocity);
    fastest = square > fastest ? square : fastest;
    if (!(sum - sum == 0) && i < *lost)
      *lost = i; /* infinity less itself is not a number either */
  }
  return fastest;
}

void nb_motion_part(struct nb_model *model, int part, int parts, struct nb_moved *moved) {
  const size_t n = model->bodies.count;
  moved->lost = n;
  moved->fastest =
      move_bodies(model, n * (size_t)part / (size_t)parts, n * ((size_t)part + 1) / (size_t)parts, &moved->lost);
}

void nb_motion_walls(struct nb_model *model) {
  struct nb_walls *walls = &model->walls;
  for (size_t w = 0; w < walls->count; w++)
    walls->point[w] = vec_add(walls->point[w], vec_scale(model->step, walls->velocity[w]));
}
