/* Reference: a straight row of N equal particles between two fixed walls. All contacts have the same initial overlap,
 * and the initial velocities along the row are given. The solution is by normal modes in closed form, in the time steps
 * of the calculation cycle.
 *
 * u_l is the displacement of particle l from its initial position, with u_0 = u_(N+1) = 0 at the walls. The solution of
 * m u_l'' = k (u_(l-1) - 2 u_l + u_(l+1)) is, with the amplitude s_j of mode j = 1 ... N,
 *
 *   u_l = sum over j of  sin(q l) s_j,    q = j pi/(N + 1),    omega = 2 sqrt(k/m) sin(q/2)
 *
 * In the cycle [CS79 22, 22a], from s = 0 with the velocity v, the amplitude of a mode after n cycles is exactly
 *
 *   s_n = v dt sin(n phi)/sin(phi),   sin(phi/2) = omega dt/2                 if omega dt < 2: an oscillation
 *   s_n = v dt (-1)^(n-1) sinh(n g)/sinh(g),   cosh(g/2) = omega dt/2         if omega dt > 2: the mode grows
 *
 * Returns
 *   C.normal versus cycle, time             for C that monitors a contact
 *   C.normal mean, C.normal frequency       for C that monitors a contact, if a single mode moves and is stable
 *   D.x, D.vx.half versus cycle, time       for D that monitors a particle
 *   time in STAGE                           of a stage that lasts until one of these quantities is above a value, which
 *                                           is checked every cycle
 *   step.stable                             2/omega with omega^2 = 4 k/m, for N > 1
 * Exact while no contact opens, because a straight row of linear springs is a linear system. The reference does not
 * check that contacts stay closed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

struct chain {
  size_t n;         /* particles */
  double m, k;      /* kg, N/m */
  double overlap;   /* of every contact at time 0, m */
  double step;      /* s */
  double *velocity; /* of mode j = 1 to n at time 0, m/s; owned */
};

/* The data of a curve, in one allocation: `rest` plus the sum over the modes of sin(q l) s_n, or, for a velocity, of
 * sin(q l) (s_n - s_(n-1))/dt. */
struct mode_sum {
  double rest, step, unit; /* unit: the length of one cycle on the axis, 1 or the step */
  bool velocity;
  size_t count;
  struct mode {
    double amplitude; /* factor of sin(n phi)/sin(phi), such as sin(q l) v dt */
    double half;      /* omega dt/2 */
  } modes[];
};

static double mode_at(struct mode mode, double n) {
  if (mode.half < 1) {
    const double phase = 2 * asin(mode.half);
    return mode.amplitude * sin(n * phase) / sin(phase);
  }
  const double growth = 2 * acosh(mode.half), sign = fmod(n, 2) != 0 ? 1 : -1;
  return mode.amplitude * sign * (growth > 0 ? sinh(n * growth) / sinh(growth) : n);
}

static double mode_sum_at(const void *data, double x) {
  const struct mode_sum *sum_of = data;
  const double n = round(x / sum_of->unit);
  double sum = 0;
  for (size_t j = 0; j < sum_of->count; j++)
    sum += sum_of->velocity ? (mode_at(sum_of->modes[j], n) - mode_at(sum_of->modes[j], n - 1)) / sum_of->step
                            : mode_at(sum_of->modes[j], n);
  return sum_of->rest + sum;
}

static double omega(const struct chain *chain, size_t j) {
  return 2 * sqrt(chain->k / chain->m) * sin(pi * (double)j / (2 * (double)(chain->n + 1)));
}

/* sin(q l) of particle l, counted from 1; 0 at the walls. */
static double shape(const struct chain *chain, size_t j, size_t l) {
  return sin(pi * (double)(j * l) / (double)(chain->n + 1));
}

/* Adds two curves of rest + factor (u_a - u_b), one versus cycle and one versus time. If b = a, they are curves of rest
 * + factor u_a. If `velocity` is true, the velocity takes the place of u. */
static void add_curves(struct nb_solution *solution, const struct chain *chain, const char *name, double rest,
                       double factor, size_t a, size_t b, bool velocity) {
  for (int axis = 0; axis < 2; axis++) {
    struct mode_sum *data = calloc(1, sizeof *data + chain->n * sizeof data->modes[0]);
    if (data) {
      *data = (struct mode_sum){
          .rest = rest, .step = chain->step, .unit = axis ? chain->step : 1, .velocity = velocity, .count = chain->n};
      for (size_t j = 1; j <= chain->n; j++) {
        const double difference = shape(chain, j, a) - (b == a ? 0 : shape(chain, j, b));
        data->modes[j - 1] = (struct mode){factor * difference * chain->velocity[j - 1] * chain->step,
                                           omega(chain, j) * chain->step / 2};
      }
    }
    solution_curve(solution, name, axis ? "time" : "cycle", mode_sum_at, data);
  }
}

/* The number of the only mode that moves; 0: none or several. */
static size_t only_mode(const struct chain *chain) {
  size_t found = 0;
  double largest = 0;
  for (size_t j = 0; j < chain->n; j++)
    largest = fmax(largest, fabs(chain->velocity[j]));
  for (size_t j = 0; j < chain->n; j++)
    if (fabs(chain->velocity[j]) > 1e-12 * largest) {
      if (found)
        return 0;
      found = j + 1;
    }
  return found;
}

static void add_contact(struct nb_solution *solution, const struct chain *chain, const char *monitor, size_t a,
                        size_t b) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.normal", monitor);
  add_curves(solution, chain, name, chain->k * chain->overlap, chain->k, a, b, false);
  const size_t mode = only_mode(chain);
  const double half = mode ? omega(chain, mode) * chain->step / 2 : 1;
  if (!(half < 1))
    return;
  snprintf(name, sizeof name, "%s.normal frequency", monitor);
  solution_value(solution, asin(half) / (pi * chain->step), name);
  snprintf(name, sizeof name, "%s.normal mean", monitor);
  solution_value(solution, chain->k * chain->overlap, name);
}

/* `time in STAGE` of stages that last until a quantity of a curve is above a value. */
static void add_ends(struct nb_solution *solution, const struct nb_scene *scene, const struct chain *chain) {
  double n = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    char name[3 * NB_NAME_SIZE];
    const double longest = n + (double)stage->cycles;
    if (stage->condition_count == 0) {
      n += (double)stage->cycles;
      continue;
    }
    const struct nb_condition *until = &stage->conditions[0];
    const struct nb_solution_curve *curve = solution_find_curve(solution, until->name, "cycle");
    if (stage->condition_count > 1 || stage->check_interval > 1 || until->relation != NB_ABOVE || !curve)
      return;
    do
      n++;
    while (n < longest && !(curve->at(curve->data, n) > until->value));
    if (!(curve->at(curve->data, n) > until->value)) /* the run is aborted */
      return;
    snprintf(name, sizeof name, "time in %s", stage->name);
    solution_value(solution, n * chain->step, name);
  }
}

static enum nb_status add_monitors(struct nb_solution *solution, const struct nb_scene *scene,
                                   const struct chain *chain, struct nb_error *error) {
  if (chain->n > 1)
    solution_value(solution, sqrt(chain->m / chain->k), "step.stable");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const size_t a = (size_t)monitor->a + 1, b = (size_t)monitor->b + 1;
    char name[3 * NB_NAME_SIZE];
    if (monitor->kind == NB_MONITOR_PARTICLE) {
      snprintf(name, sizeof name, "%s.x", monitor->name);
      add_curves(solution, chain, name, scene->particles[monitor->a].x, 1, a, a, false);
      snprintf(name, sizeof name, "%s.vx.half", monitor->name);
      add_curves(solution, chain, name, 0, 1, a, a, true);
    } else if (monitor->kind == NB_MONITOR_PARTICLE_PARTICLE && (a + 1 == b || b + 1 == a)) {
      add_contact(solution, chain, monitor->name, a < b ? a : b, a < b ? b : a);
    } else if (monitor->kind == NB_MONITOR_PARTICLE_WALL) {
      /* The wall is fixed: the overlap changes by -u_1 at the first wall, by u_N at the last. */
      const bool first = scene->walls[monitor->b].x < scene->particles[monitor->a].x;
      if (a == (first ? 1 : chain->n))
        add_contact(solution, chain, monitor->name, first ? 0 : a, first ? a : chain->n + 1);
    }
  }
  add_ends(solution, scene, chain);
  return solution_status(solution, error);
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `chain` is for %s", what);
}

/* Sets the overlap. False: the contacts do not all have the same positive overlap, the particles are not numbered in
 * the order of x, or a wall is not normal to x. */
static bool read_overlap(struct chain *chain, const struct nb_scene *scene) {
  const double radius = scene->particles[0].radius;
  const struct nb_wall *west = &scene->walls[0], *east = &scene->walls[1];
  if (west->x > east->x)
    west = &scene->walls[1], east = &scene->walls[0];
  chain->overlap = west->x + radius - scene->particles[0].x;
  for (size_t l = 0; l < chain->n; l++) {
    const double next = l + 1 < chain->n ? scene->particles[l + 1].x - radius : east->x;
    if (fabs(scene->particles[l].x + radius - next - chain->overlap) > 1e-9 * radius)
      return false;
  }
  return chain->overlap > 0 && west->ex == 0 && east->ex == 0;
}

static enum nb_status read_chain(struct chain *chain, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_step *step = &scene->stages[0].step;
  const struct nb_particle *first = &scene->particles[0];
  if (scene->wall_count != 2)
    return refuse(error, "two walls");
  for (size_t l = 0; l < chain->n; l++) {
    const struct nb_particle *particle = &scene->particles[l];
    if (particle->y != first->y || particle->vy != 0 || particle->radius != first->radius ||
        particle->material != first->material || particle->shape != first->shape)
      return refuse(error, "a straight row of equal particles that move along it");
  }
  for (size_t w = 0; w < 2; w++)
    if (matter_pair(scene, first->material, scene->walls[w].material).kn != chain->k)
      return refuse(error, "walls as stiff as the particles");
  if (!read_overlap(chain, scene))
    return refuse(error, "a row in the order of x, with the same overlap at every contact");
  if (step->kind != NB_STEP_TIME && step->kind != NB_STEP_SINGLE_CONTACT)
    return refuse(error, "a step given as a time or as a fraction of single-contact");
  chain->step = step->kind == NB_STEP_TIME ? step->value : step->value * 2 * sqrt(chain->m / chain->k);
  return NB_OK;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *first = &scene->particles[0];
  struct chain chain = {.n = scene->particle_count, .m = matter_mass(scene, first)};
  chain.k = matter_pair(scene, first->material, first->material).kn;
  if (read_chain(&chain, scene, error))
    return error->status;
  chain.velocity = calloc(chain.n, sizeof *chain.velocity);
  if (!chain.velocity)
    return nb_error_memory(error);
  for (size_t j = 1; j <= chain.n; j++)
    for (size_t l = 1; l <= chain.n; l++)
      chain.velocity[j - 1] += 2 * shape(&chain, j, l) * scene->particles[l - 1].vx / (double)(chain.n + 1);
  const enum nb_status status = add_monitors(solution, scene, &chain, error);
  free(chain.velocity);
  return status;
}

const struct nb_reference reference_chain = {
    .name = "chain",
    .title = "equal particles in a row between two walls: normal modes in closed form, in the steps of the calculation "
             "cycle",
    .source = "[CS79 22, 22a]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_VELOCITIES, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
