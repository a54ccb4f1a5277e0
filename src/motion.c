/* The motion half of a cycle.                                        [CS79 20-25, 29-36]
 *
 *   v_(N+1/2) = v_(N-1/2) + (sum F / m)_N dt,    x_(N+1) = x_N + v_(N+1/2) dt            22, 22a
 *   w_(N+1/2) = w_(N-1/2) + (sum M / I)_N dt,    theta_(N+1) = theta_N + w_(N+1/2) dt    23, 23a
 *
 * Gravity adds m g to sum F. With global damping the old velocity is multiplied by `keep`, the force by `push`:
 *
 *   C = alpha m        keep = (1 - alpha dt/2)/(1 + alpha dt/2),   push = 1/(1 + alpha dt/2)     34-36
 *   CON1, as CS79      keep = CON1/(2 - CON1),   push = 1/(2 - CON1)       the same with alpha dt/2 = 1 - CON1
 *   CON1, velocity     keep = CON1,              push = 1
 *   CON1, all          keep = CON1,              push = CON1
 *
 * Where something carries bodies along (cell.c), their whole velocity is v + c, and v is what the kick changes:
 *
 *   v_(N+1/2) = keep v_(N-1/2) + push (F/m)_N dt,   x_(N+1) = x_N + (v_(N+1/2) + c_(N+1/2)) dt,   c_(N+1/2) = L (x_N - x_0)
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

static inline bool pulls(struct nb_vec gravity) { return gravity.x != 0 || gravity.y != 0; }

struct nb_state nb_velocity_half(const struct nb_model *model, size_t slot) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct nb_vec whole = bodies->velocity[slot];
  return (struct nb_state){bodies->carried ? vec_sub(whole, bodies->carried[slot]) : whole,
                           bodies->spin ? bodies->spin[slot] : 0};
}

/* What is fixed goes on as it goes: no force and no damping reaches it. */
static inline struct nb_state kicked(const struct nb_model *model, const struct felt *felt, size_t slot,
                                     struct factors f, double time, struct nb_vec gravity) {
  const struct nb_bodies *bodies = &model->bodies;
  const struct nb_state before = nb_velocity_half(model, slot);
  if (!(bodies->inverse_mass[slot] > 0))
    return before;
  struct nb_force sum = force_on(felt, slot, bodies->rim[slot].x);
  if (pulls(gravity))
    sum.force = vec_add(sum.force, vec_scale(bodies->mass[slot], gravity));
  const double linear = f.push * time * bodies->inverse_mass[slot];
  const double turning = f.push * time * bodies->inverse_inertia[slot];
  return (struct nb_state){vec_add(vec_scale(f.keep, before.velocity), vec_scale(linear, sum.force)),
                           f.keep * before.spin + turning * sum.moment};
}

struct nb_state nb_velocity_now(const struct nb_model *model, size_t slot) {
  const struct nb_state before = nb_velocity_half(model, slot);
  const double dt = model->previous_step;
  if (!(dt > 0))
    return before; /* the start: a page's velocities are those of time 0 */
  const struct felt felt = felt_by(model);
  const struct nb_state next = kicked(model, &felt, slot, factors(model, dt), dt, model->gravity);
  return (struct nb_state){vec_scale(0.5, vec_add(before.velocity, next.velocity)), (before.spin + next.spin) / 2};
}

struct nb_vec nb_carried_now(const struct nb_model *model, size_t slot) {
  const struct nb_vec *carried = model->bodies.carried;
  if (!carried)
    return vec(0, 0);
  const struct nb_vec ahead = nb_cell_carries(model->cell, model->bodies.position[slot]);
  return vec_scale(0.5, vec_add(model->previous_step > 0 ? carried[slot] : ahead, ahead));
}

/* v_N = (v- + v+)/2 with v+ = keep v- + push (F/m) dt: a force less is made up for by so much more of v-. */
void nb_motion_release(struct nb_model *model, size_t slot, struct nb_force ending) {
  struct nb_bodies *bodies = &model->bodies;
  const double dt = model->previous_step;
  const struct factors f = factors(model, dt);
  const double time = f.push * dt / (1 + f.keep);
  bodies->velocity[slot] = vec_add(bodies->velocity[slot], vec_scale(time * bodies->inverse_mass[slot], ending.force));
  if (bodies->spin)
    bodies->spin[slot] += time * bodies->inverse_inertia[slot] * ending.moment;
}

/* A kick by the forces at t_N makes v_(N+1/2) of v_(N-1/2). For it to make -v_(N-1/2), which leads back to x_(N-1), the velocity
 * behind must become -v_(N+1/2). At the start there is none behind: the velocities are those of time 0. */
void nb_motion_reverse(struct nb_model *model) {
  struct nb_bodies *bodies = &model->bodies;
  const struct felt felt = felt_by(model);
  const double time = kick_time(model);
  for (size_t i = 0; i < bodies->count; i++) {
    struct nb_state v = nb_velocity_half(model, i);
    if (model->previous_step > 0)
      v = kicked(model, &felt, i, factors(model, time), time, model->gravity);
    bodies->velocity[i] = vec_scale(-1, v.velocity);
    if (bodies->carried)
      bodies->velocity[i] = vec_add(bodies->velocity[i], bodies->carried[i]);
    if (bodies->spin)
      bodies->spin[i] = -v.spin; /* the next motion makes the speed of the rim of it */
  }
}

/* The sums of a block of bodies, which stay in the first-level cache. */
enum { BODIES = 256 };
struct sums {
  struct nb_vec force[BODIES];
  double moment[BODIES];
};

static void sum_up(struct sums *sums, const struct felt *felt, const struct nb_vec *rim, size_t from, size_t n) {
  for (size_t k = 0; k < n; k++) {
    const struct nb_force sum = force_on(felt, from + k, rim[from + k].x);
    sums->force[k] = sum.force;
    sums->moment[k] = sum.moment;
  }
}

/* m g, when there is any [CS79, Motion]. */
static void add_weight(struct sums *sums, const double *mass, struct nb_vec gravity, size_t n) {
  for (size_t k = 0; k < n; k++)
    sums->force[k] = vec_add(sums->force[k], vec_scale(mass[k], gravity));
}

/* What one thread needs for its bodies. */
struct part {
  struct nb_bodies bodies; /* a copy: no store through one pointer can be thought to change another */
  struct factors factors;
  const struct nb_cell *cell; /* NULL: nothing carries them */
  struct nb_vec gravity;      /* m/s2 */
  double time, step, reach;   /* of the kick and of the drift, s; how far a body may go without a new search, m */
};

/* Kick and drift, 22, 22a, and what fixed bodies do: they go on as they go, no force and no damping reaches them. Answers how
 * many are out of reach of the last search, or nowhere: what is not a number is within no reach. */
static inline NB_FORM int drift(const struct part *part, const struct sums *sums, size_t from, size_t n) {
  const double *mass = part->bodies.inverse_mass + from;
  const struct nb_vec *searched = part->bodies.searched + from;
  struct nb_vec *velocity = part->bodies.velocity + from, *position = part->bodies.position + from;
  const double dt = part->step, push = part->factors.push * part->time, reach = part->reach * part->reach;
  int out = 0;
  for (size_t k = 0; k < n; k++) {
    const double keep = mass[k] > 0 ? part->factors.keep : 1;
    const nb_both v = keep * vec_both(&velocity[k]) + (push * mass[k]) * vec_both(&sums->force[k]);
    const nb_both x = vec_both(&position[k]) + dt * v, way = x - vec_both(&searched[k]), square = way * way;
    vec_put(&velocity[k], v);
    vec_put(&position[k], x);
    out += !(square[0] + square[1] <= reach);
  }
  return out;
}

/* The same for turning, 23, 23a. */
static inline NB_FORM void turn(const struct part *part, const struct sums *sums, size_t from, size_t n) {
  const double *inertia = part->bodies.inverse_inertia + from;
  double *spin = part->bodies.spin + from, *angle = part->bodies.angle + from;
  struct nb_vec *rim = part->bodies.rim + from;
  const double dt = part->step, push = part->factors.push * part->time;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    const double keep = inertia[k] > 0 ? part->factors.keep : 1;
    const double w = keep * spin[k] + push * inertia[k] * sums->moment[k];
    spin[k] = w;
    angle[k] += w * dt;
    rim[k].y = w * rim[k].x;
  }
}

/* Before the drift: what carries bodies is taken off their velocity, and moves them and where they were found at the last
 * search; so the drift sees what they do besides. */
static inline NB_FORM void carry(const struct part *part, size_t from, size_t n) {
  struct nb_vec *velocity = part->bodies.velocity + from, *position = part->bodies.position + from;
  struct nb_vec *carried = part->bodies.carried + from, *searched = part->bodies.searched + from;
  for (size_t k = 0; k < n; k++) {
    velocity[k] = vec_sub(velocity[k], carried[k]);
    carried[k] = nb_cell_carries(part->cell, position[k]);
    position[k] = vec_add(position[k], vec_scale(part->step, carried[k]));
    searched[k] = vec_add(searched[k], vec_scale(part->step, nb_cell_carries(part->cell, searched[k])));
  }
}

/* After it. */
static inline NB_FORM void carry_on(const struct part *part, size_t from, size_t n) {
  for (size_t k = from; k < from + n; k++)
    part->bodies.velocity[k] = vec_add(part->bodies.velocity[k], part->bodies.carried[k]);
}

static inline NB_FORM int move(const struct part *part, const struct felt *felt, size_t from, size_t to) {
  int out = 0;
  for (; from < to; from += BODIES) {
    const size_t n = to - from < BODIES ? to - from : BODIES;
    struct sums sums;
    sum_up(&sums, felt, part->bodies.rim, from, n);
    if (pulls(part->gravity))
      add_weight(&sums, part->bodies.mass + from, part->gravity, n);
    if (part->cell)
      carry(part, from, n);
    out += drift(part, &sums, from, n);
    if (part->cell)
      carry_on(part, from, n);
    if (part->bodies.spin)
      turn(part, &sums, from, n);
  }
  return out;
}

static int move_plain(const struct part *part, const struct felt *felt, size_t from, size_t to) {
  return move(part, felt, from, to);
}
#ifdef NB_X86
NB_TARGET_AVX2 static int move_avx2(const struct part *part, const struct felt *felt, size_t from, size_t to) {
  return move(part, felt, from, to);
}
NB_TARGET_AVX512 static int move_avx512(const struct part *part, const struct felt *felt, size_t from, size_t to) {
  return move(part, felt, from, to);
}
static int (*const moves[NB_ISAS])(const struct part *, const struct felt *, size_t, size_t) = {move_plain, move_avx2,
                                                                                                move_avx512};
#else
static int (*const moves[NB_ISAS])(const struct part *, const struct felt *, size_t, size_t) = {move_plain, move_plain,
                                                                                                move_plain};
#endif

int nb_motion_part(struct nb_model *model, int part, int parts) {
  const size_t n = model->bodies.count;
  const struct felt felt = felt_by(model);
  const struct part mine = {model->bodies,
                            factors(model, kick_time(model)),
                            model->cell,
                            model->gravity,
                            kick_time(model),
                            model->step,
                            model->cell ? model->cell->reach : model->skin / 2};
  return moves[model->isa](&mine, &felt, n * (size_t)part / (size_t)parts, n * ((size_t)part + 1) / (size_t)parts);
}
