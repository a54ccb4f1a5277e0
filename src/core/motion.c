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
 * A body that is carried along has a velocity u = v + c, c = L (x_N - x_0) over the step from t_N: what carries it, a strain
 * rate L about x_0 [R89 4.41]. Forces and damping act on v:
 *
 *   u_(N+1/2) = keep (u_(N-1/2) - c_(N-1/2)) + push (sum F / m)_N dt + c_(N+1/2)
 *
 * Contacts see u, so L z dt of two bodies that are z apart [R89 4.42], without knowing of it. What is held by a boundary has
 * no v. A scene in which nothing but a boundary is carried has the loop without c.
 *
 * The velocities of a page belong to time 0, those of the scheme to half steps: the first kick lasts half a step, and one
 * between two steps of unlike length the mean of both. BALL starts from rest without forces, where that is the same.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "motion.h"

/* What there is of a bunch of bodies while they are moved: it stays in the first-level cache. */
enum { BATCH_SIZE = 128 };
struct batch {
  struct nb_vec force[BATCH_SIZE], c[BATCH_SIZE];                            /* N, m/s */
  double moment[BATCH_SIZE];                                                 /* N: over the radius */
  double keep[2 * BATCH_SIZE], kick[2 * BATCH_SIZE], travel[2 * BATCH_SIZE]; /* for each component */
};

static inline NB_FORM void sum_forces(struct batch *batch, const struct nb_contact_forces *by,
                                      const struct nb_incidence *all, size_t from, size_t n, bool rotates) {
  const struct nb_contact_forces contact_forces = *by;
  const struct nb_incidence incidence = *all;
  const int *middle = incidence.middle + from, *end = incidence.first + from + 1;
  struct nb_contact_range its = {.end = incidence.entry + incidence.first[from]};
  for (size_t k = 0; k < n; k++) {
    its = (struct nb_contact_range){its.end, incidence.entry + middle[k], incidence.entry + end[k]};
    const struct nb_force sum = nb_contact_force_sum(contact_forces, its, rotates);
    batch->force[k] = sum.force;
    batch->moment[k] = sum.moment;
  }
}

/* m g, when there is any [CS79, Motion]. */
static void add_weight(struct batch *batch, const double *mass, struct nb_vec gravity, size_t n) {
  for (size_t k = 0; k < n; k++)
    batch->force[k] = vec_add(batch->force[k], vec_scale(mass[k], gravity));
}
static void add_central(struct batch *batch, const double *mass, const struct nb_vec *x,
                        const struct nb_central *gravity, size_t n) {
  for (size_t k = 0; k < n; k++)
    batch->force[k] = vec_add(batch->force[k], nb_central_force(gravity, mass[k], x[k]));
}

static void add_boundary_force(struct batch *batch, const struct nb_vec *boundary_force, size_t n) {
  for (size_t k = 0; k < n; k++)
    batch->force[k] = vec_add(batch->force[k], boundary_force[k]);
}

/* What one thread needs for its bodies. */
struct task {
  struct nb_particles particles; /* a copy: no store through one pointer can be thought to change another */
  const struct nb_incidence *incidence;
  struct nb_kick_factors factors;
  struct nb_vec gravity; /* m/s2 */
  struct nb_central central;
  const struct nb_vec *boundary_force; /* NULL: no stress on a boundary */
  const struct nb_affine *affine;      /* NULL: nothing is carried along */
  bool along;                          /* the step carries all bodies */
  bool cell;                           /* there is one */
  double time, step, travel_limit; /* of the kick and of the drift, s; how far a body may go without a new search, m */
};

/* v, without what carries the body, and c over the step to come, of which with `accumulated` nothing is remembered: it stays in v.
 * `alike`: one rate is that of all. */
static inline NB_FORM void add_affine(const struct task *task, struct batch *batch, size_t from, size_t n, bool alike) {
  struct nb_vec *velocity = task->particles.velocity + from, *imposed = task->particles.imposed + from;
  const struct nb_vec *position = task->particles.position + from;
  const struct nb_affine it = *task->affine;
  const unsigned char *source = it.source + from, first = source[0];
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    const int which = alike ? first : source[k];
    batch->c[k] = tensor_times(it.rate[which], vec_sub(position[k], it.centre));
    velocity[k] = vec_sub(velocity[k], imposed[k]);
    imposed[k] = vec_scale(it.separate[which], batch->c[k]);
  }
}

/* Kick and drift, 22, 22a, and what fixed bodies do: they go on as they go, no force and no damping reaches them. `along`: of
 * bodies that are carried along. Answers how many are out of reach of the last search, or nowhere: what is not a number is
 * within no reach. Components are taken one after the other, the loops are wide. */
static inline NB_FORM int drift(const struct task *task, struct batch *batch, size_t from, size_t n, bool along) {
  const double *mass = task->particles.inverse_mass + from,
               *search_position = vec_flat(task->particles.search_position + from);
  double *velocity = vec_flat(task->particles.velocity + from), *position = vec_flat(task->particles.position + from);
  double *keep = batch->keep, *kick = batch->kick, *travel = batch->travel;
  const double *force = vec_flat(batch->force), *c = vec_flat(batch->c);
  const double dt = task->step, impulse = task->factors.impulse * task->time, damped = task->factors.keep;
  const double travel_limit = task->travel_limit * task->travel_limit;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    keep[2 * k] = keep[2 * k + 1] = mass[k] > 0 ? damped : 1;
    kick[2 * k] = kick[2 * k + 1] = impulse * mass[k];
  }
  NB_WIDE
  for (size_t k = 0; k < 2 * n; k++) {
    const double own = keep[k] * velocity[k] + kick[k] * force[k];
    const double v = along ? own + c[k] : own, x = position[k] + dt * v;
    velocity[k] = v;
    position[k] = x;
    travel[k] = (x - search_position[k]) * (x - search_position[k]);
  }
  int out = 0;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    out += !(travel[2 * k] + travel[2 * k + 1] <= travel_limit);
  }
  return out;
}

/* Whether anything turns: without shear forces nothing begins to. */
static inline NB_FORM bool any_spin(const double *spin, size_t n) {
  unsigned long count = 0;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    count += spin[k] != 0;
  }
  return count > 0;
}

/* The same for turning, 23, 23a. */
static inline NB_FORM void rotate(const struct task *task, const struct batch *batch, size_t from, size_t n) {
  const double *inertia = task->particles.inverse_inertia + from;
  double *spin = task->particles.spin + from, *angle = task->particles.angle + from;
  struct nb_surface *surface = task->particles.surface + from;
  const double dt = task->step, impulse = task->factors.impulse * task->time, damped = task->factors.keep;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    const double keep = inertia[k] > 0 ? damped : 1;
    const double w = keep * spin[k] + impulse * inertia[k] * (batch->moment[k] * surface[k].radius);
    spin[k] = w;
    angle[k] += w * dt;
  }
  for (size_t k = 0; k < n; k++)
    surface[k].speed = spin[k] * surface[k].radius;
}

/* A cell carries the whole list of contacts: so the places of the last search, and the reach is for what bodies do besides. */
static inline NB_FORM void move_list(const struct task *task, size_t from, size_t n) {
  struct nb_vec *search_position = task->particles.search_position;
  for (size_t k = from; k < from + n; k++)
    search_position[k] =
        vec_add(search_position[k], vec_scale(task->step, nb_imposed_velocity(task->affine, k, search_position[k])));
}

static inline NB_FORM int move(const struct task *task, const struct nb_contact_forces *contact_forces, size_t from,
                               size_t to) {
  int out = 0;
  for (; from < to; from += BATCH_SIZE) {
    const size_t n = to - from < BATCH_SIZE ? to - from : BATCH_SIZE;
    struct batch batch;
    if (contact_forces->total_shear)
      sum_forces(&batch, contact_forces, task->incidence, from, n, true);
    else
      sum_forces(&batch, contact_forces, task->incidence, from, n, false);
    if (nb_has_gravity(task->gravity))
      add_weight(&batch, task->particles.mass + from, task->gravity, n);
    if (task->central.acceleration != 0)
      add_central(&batch, task->particles.mass + from, task->particles.position + from, &task->central, n);
    if (task->boundary_force)
      add_boundary_force(&batch, task->boundary_force + from, n);
    if (task->cell)
      move_list(task, from, n);
    if (task->along && task->affine->uniform)
      add_affine(task, &batch, from, n, true);
    else if (task->along)
      add_affine(task, &batch, from, n, false);
    out += task->along ? drift(task, &batch, from, n, true) : drift(task, &batch, from, n, false);
    if (task->particles.spin && (contact_forces->total_shear || any_spin(task->particles.spin + from, n)))
      rotate(task, &batch, from, n);
  }
  return out;
}

static int move_plain(const struct task *task, const struct nb_contact_forces *contact_forces, size_t from, size_t to) {
  return move(task, contact_forces, from, to);
}
#ifdef NB_X86
NB_TARGET_AVX2 static int move_avx2(const struct task *task, const struct nb_contact_forces *contact_forces,
                                    size_t from, size_t to) {
  return move(task, contact_forces, from, to);
}
NB_TARGET_AVX512 static int move_avx512(const struct task *task, const struct nb_contact_forces *contact_forces,
                                        size_t from, size_t to) {
  return move(task, contact_forces, from, to);
}
static int (*const moves[NB_ISAS])(const struct task *, const struct nb_contact_forces *, size_t,
                                   size_t) = {move_plain, move_avx2, move_avx512};
#else
static int (*const moves[NB_ISAS])(const struct task *, const struct nb_contact_forces *, size_t,
                                   size_t) = {move_plain, move_plain, move_plain};
#endif

int nb_motion_part(struct nb_model *model, int part, int parts) {
  const size_t n = model->particles.count;
  const struct nb_contact_forces contact_forces = nb_contact_forces_of(model);
  const double time = nb_kick_time(model);
  const struct task mine = {.particles = model->particles,
                            .incidence = &model->contacts.of,
                            .factors = nb_kick_factors(model, time, nb_kick_fraction_before(model)),
                            .gravity = model->gravity,
                            .central = model->central,
                            .boundary_force = model->particles.boundary_force,
                            .affine = model->affine,
                            .along = model->affine && model->affine->all,
                            .cell = model->cell != NULL,
                            .time = time,
                            .step = model->step,
                            .travel_limit = model->cell ? model->cell->travel_limit : model->search.skin / 2};
  return moves[model->machine.isa](&mine, &contact_forces, n * (size_t)part / (size_t)parts,
                                   n * ((size_t)part + 1) / (size_t)parts);
}
