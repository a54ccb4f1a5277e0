/* Integration of motion.                                             [CS79 20-25, 29-36]
 *
 *   v_(N+1/2) = v_(N-1/2) + (sum F / m)_N dt,    x_(N+1) = x_N + v_(N+1/2) dt            22, 22a
 *   w_(N+1/2) = w_(N-1/2) + (sum M / I)_N dt,    theta_(N+1) = theta_N + w_(N+1/2) dt    23, 23a
 *
 *   v, w  velocity, m/s, and angular velocity, rad/s      x, theta  position, m, and rotation, rad
 *
 * A change of the velocities is a kick, a change of the positions a drift.
 *
 * Gravity adds m g to sum F. Mass-proportional damping multiplies the old velocity by `keep` and the force by
 * `impulse`; alpha (1/s) is alpha_g of docs/METHOD.md:
 *
 *   C = alpha m        keep = (1 - alpha dt/2)/(1 + alpha dt/2),   impulse = 1/(1 + alpha dt/2)     34-36
 *   CON1, as CS79      keep = CON1/(2 - CON1),   impulse = 1/(2 - CON1)       as C = alpha m with alpha dt/2 = 1 - CON1
 *   CON1, velocity     keep = CON1,              impulse = 1
 *   CON1, all          keep = CON1,              impulse = CON1
 *
 * With affine motion the total velocity is u = v + c, where c = L (x_N - x_0) in the step from t_N, and L is a strain
 * rate about x_0 [R89 4.41]. Forces and damping act on v:
 *
 *   u_(N+1/2) = keep (u_(N-1/2) - c_(N-1/2)) + impulse (sum F / m)_N dt + c_(N+1/2)
 *
 * Contacts read u; the affine part of the relative displacement of two particles with separation z is L z dt
 * [R89 4.42]. Particles held by a boundary have v = 0. If only a boundary moves affinely, the loop without c is used:
 * the mass of its particles counts as infinite, and their stored velocity is c.
 *
 * Dashpots that are centred (pass/dashpots.c) need the velocity at t_(N+1). Its difference from v_(N+1/2) is predicted
 * from the acceleration at t_N: (v_(N+1/2) - v_(N-1/2)) dt/(2 tau), where tau is the duration of the kick.
 *
 * A page gives the velocities at time 0; this scheme needs the velocities at half steps. So the first kick lasts half a
 * step, and a kick between two steps of unequal length lasts their mean. CS79's program BALL starts from rest without
 * forces, so the half kick would change nothing there.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "motion.h"

/* Working memory for a batch of particles; it stays in the first-level cache. */
struct batch {
  struct nb_vec force[NB_BATCH_SIZE], c[NB_BATCH_SIZE]; /* N, m/s */
  double moment[NB_BATCH_SIZE];                         /* moment over radius, N */
  /* For x and y of each particle in turn: factor of the velocity, 1; factor of the force, s/kg; square of the
   * displacement since the last search, m2. */
  double keep[2 * NB_BATCH_SIZE], kick[2 * NB_BATCH_SIZE], travel[2 * NB_BATCH_SIZE];
};

/* The state of the summation in a batch, which runs group by group (incidence.c). */
struct sums {
  struct batch *batch;
  size_t from;             /* first slot of the batch */
  const int *slot, *entry; /* of the next particle */
  const struct nb_contact_force *force;
};

/* Sums the forces on the particles of a group. Each particle has `seconds` contacts as second particle, and `firsts`
 * contacts as first particle. */
static inline NB_FORM void sum_group(struct sums *sums, int particles, int seconds, int firsts) {
  const int *slot = sums->slot, *entry = sums->entry;
  for (int p = 0; p < particles; p++, entry += seconds + firsts) {
    const size_t k = (size_t)slot[p] - sums->from;
    struct nb_contact_force sum;
    nb_contact_force_sum(&sum, sums->force, entry, seconds, firsts);
    sums->batch->force[k] = vec(sum.x, sum.y);
    sums->batch->moment[k] = sum.shear;
  }
  sums->slot = slot + particles, sums->entry = entry;
}

/* Calls F(k) with a constant k if k is at most 4: the compiler then unrolls the loop over these contacts of a
 * particle. */
#define CONSTANT_CASE(k, F)                                                                                            \
  case k:                                                                                                              \
    F(k);                                                                                                              \
    break;
#define WITH_CONSTANT(k, F)                                                                                            \
  switch (k) {                                                                                                         \
    CONSTANT_CASE(0, F)                                                                                                \
    CONSTANT_CASE(1, F)                                                                                                \
    CONSTANT_CASE(2, F)                                                                                                \
    CONSTANT_CASE(3, F)                                                                                                \
    CONSTANT_CASE(4, F)                                                                                                \
  default:                                                                                                             \
    F(k);                                                                                                              \
  }

static inline NB_FORM void sum_firsts(struct sums *sums, int particles, int seconds, int firsts) {
#define SUM(k) sum_group(sums, particles, seconds, k)
  WITH_CONSTANT(firsts, SUM)
#undef SUM
}
static inline NB_FORM void sum_seconds(struct sums *sums, struct nb_incidence_group group) {
#define SUM(k) sum_firsts(sums, group.particles, k, group.firsts)
  WITH_CONSTANT(group.seconds, SUM)
#undef SUM
}

/* Sums the forces on the particles of batch `which`, whose first slot is `from`. Each instruction set has a function of
 * its own for this, which is not inlined into `move`, because registers are scarce there. */
typedef void sum_function(struct batch *batch, const struct nb_contact_force *force, const struct nb_incidence *all,
                          size_t which, size_t from);
#define SUM_FORM(isa, target)                                                                                          \
  target static void sum_##isa(struct batch *batch, const struct nb_contact_force *force,                              \
                               const struct nb_incidence *all, size_t which, size_t from) {                            \
    const int *slot = all->order + from;                                                                               \
    struct sums sums = {batch, from, slot, all->entry + all->first[*slot], force};                                     \
    for (int g = all->batch[which]; g < all->batch[which + 1]; g++)                                                    \
      sum_seconds(&sums, all->group[g]);                                                                               \
  }
SUM_FORM(plain, )
#ifdef NB_X86
SUM_FORM(avx2, NB_TARGET_AVX2)
SUM_FORM(avx512, NB_TARGET_AVX512)
static sum_function *const sums[NB_ISAS] = {sum_plain, sum_avx2, sum_avx512};
#else
static sum_function *const sums[NB_ISAS] = {sum_plain, sum_plain, sum_plain};
#endif

/* Adds the weight m g to the forces [CS79, Motion]. */
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

/* The arguments of nb_motion_part for its loops. */
struct task {
  struct nb_particles particles; /* a copy, so that the compiler knows that writing particle data does not change it */
  const struct nb_contact_force *contact_force;
  const struct nb_incidence *incidence;
  sum_function *sum;
  struct nb_kick_factors factors;
  struct nb_vec gravity; /* m/s2 */
  struct nb_central central;
  const struct nb_vec *boundary_force; /* NULL: no stress on a boundary */
  const struct nb_affine *affine;      /* NULL: no affine motion */
  bool along;                          /* all particles have an affine motion */
  bool cell;                           /* the periodic cell moves affinely in this step */
  bool rotates;                        /* some particle rotates */
  bool predicts;                       /* centred dashpots need the velocity at the end of the step */
  double time, step;                   /* duration of the kick and of the drift, s */
  double travel_limit; /* a displacement since the last search beyond this limit requires a new search, m */
};

/* Subtracts c of the last step from the velocities, which gives v. Computes c of the next step. With `accumulated`, c
 * stays part of v. `alike`: all particles have the same L. */
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

/* Kick and drift, 22, 22a. Fixed particles keep their velocity: neither force nor damping acts on them. `along`: the
 * particles have an affine motion. Returns the number of particles that moved beyond the travel limit, or to NaN. The
 * loops process x and y components as one array, so they vectorise. */
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

/* Kick and drift of the rotation, 23, 23a. */
static inline NB_FORM void rotate(const struct task *task, const struct batch *batch, size_t from, size_t n) {
  const double *inertia = task->particles.inverse_inertia + from;
  double *spin = task->particles.spin + from, *angle = task->particles.angle + from;
  const double *radius = task->particles.radius + from;
  double *surface_speed = task->particles.surface_speed + from;
  const double dt = task->step, impulse = task->factors.impulse * task->time, damped = task->factors.keep;
  NB_WIDE
  for (size_t k = 0; k < n; k++) {
    const double keep = inertia[k] > 0 ? damped : 1;
    const double w = keep * spin[k] + impulse * inertia[k] * (batch->moment[k] * radius[k]);
    spin[k] = w;
    angle[k] += w * dt;
    surface_speed[k] = w * radius[k];
  }
}

/* Called before the kick: stores the velocities v of the particles. */
static inline NB_FORM void begin_prediction(const struct task *task, size_t from, size_t n) {
  const struct nb_particles *particles = &task->particles;
  for (size_t k = from; k < from + n; k++)
    particles->ahead[k] = (struct nb_velocities){particles->velocity[k], particles->surface_speed[k]};
}

/* Called after the kick: replaces the stored velocities by the predicted change from t_(N+1/2) to t_(N+1). */
static inline NB_FORM void end_prediction(const struct task *task, const struct batch *batch, size_t from, size_t n) {
  const struct nb_particles *particles = &task->particles;
  const double fraction = task->step / (2 * task->time);
  for (size_t k = from; k < from + n; k++) {
    const struct nb_velocities before = particles->ahead[k];
    const struct nb_vec c = task->along ? batch->c[k - from] : vec(0, 0);
    const struct nb_vec change = vec_sub(vec_sub(particles->velocity[k], c), before.velocity);
    particles->ahead[k] =
        (struct nb_velocities){vec_scale(fraction, change), fraction * (particles->surface_speed[k] - before.spin)};
  }
}

/* Moves the positions of the last search affinely with the cell, so that the travel limit applies to displacements
 * relative to the affine motion. */
static inline NB_FORM void move_search_positions(const struct task *task, size_t from, size_t n) {
  struct nb_vec *search_position = task->particles.search_position;
  for (size_t k = from; k < from + n; k++)
    search_position[k] =
        vec_add(search_position[k], vec_scale(task->step, nb_imposed_velocity(task->affine, k, search_position[k])));
}

/* Moves the particles of the batches from `first` to `end` - 1. Returns the number of particles that moved beyond the
 * travel limit, or to NaN. */
static inline NB_FORM int move(const struct task *task, size_t first, size_t end) {
  int out = 0;
  const size_t size = task->incidence->batch_size, count = task->particles.count;
  for (size_t b = first; b < end; b++) {
    const size_t from = b * size, n = count - from < size ? count - from : size;
    struct batch batch;
    task->sum(&batch, task->contact_force, task->incidence, b, from);
    if (nb_has_gravity(task->gravity))
      add_weight(&batch, task->particles.mass + from, task->gravity, n);
    if (task->central.acceleration != 0)
      add_central(&batch, task->particles.mass + from, task->particles.position + from, &task->central, n);
    if (task->boundary_force)
      add_boundary_force(&batch, task->boundary_force + from, n);
    if (task->cell)
      move_search_positions(task, from, n);
    if (task->along && task->affine->uniform)
      add_affine(task, &batch, from, n, true);
    else if (task->along)
      add_affine(task, &batch, from, n, false);
    if (task->predicts)
      begin_prediction(task, from, n);
    out += task->along ? drift(task, &batch, from, n, true) : drift(task, &batch, from, n, false);
    if (task->rotates)
      rotate(task, &batch, from, n);
    if (task->predicts)
      end_prediction(task, &batch, from, n);
  }
  return out;
}

static int move_plain(const struct task *task, size_t first, size_t end) { return move(task, first, end); }
#ifdef NB_X86
NB_TARGET_AVX2 static int move_avx2(const struct task *task, size_t first, size_t end) {
  return move(task, first, end);
}
NB_TARGET_AVX512 static int move_avx512(const struct task *task, size_t first, size_t end) {
  return move(task, first, end);
}
static int (*const moves[NB_ISAS])(const struct task *, size_t, size_t) = {move_plain, move_avx2, move_avx512};
#else
static int (*const moves[NB_ISAS])(const struct task *, size_t, size_t) = {move_plain, move_plain, move_plain};
#endif

int nb_motion_part(struct nb_model *model, int part, int parts) {
  const size_t n = model->contacts.incidence.batches;
  const double time = nb_kick_time(model);
  const struct task mine = {.particles = model->particles,
                            .contact_force = model->contacts.force,
                            .incidence = &model->contacts.incidence,
                            .sum = sums[model->machine.isa],
                            .factors = nb_kick_factors(model, time, nb_kick_fraction_before(model)),
                            .gravity = model->gravity,
                            .central = model->central,
                            .boundary_force = model->particles.boundary_force,
                            .affine = model->affine,
                            .along = model->all_affine,
                            .cell = model->all_affine && model->cell,
                            .rotates = model->plan.rotates,
                            .predicts = model->damping.centred && nb_damping_contact_line(&model->damping) > 0,
                            .time = time,
                            .step = model->step,
                            .travel_limit = model->cell ? model->cell->travel_limit : model->search.skin / 2};
  return moves[model->machine.isa](&mine, n * (size_t)part / (size_t)parts, n * ((size_t)part + 1) / (size_t)parts);
}
