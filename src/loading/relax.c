/* Relaxation without time: a stage that finds the equilibrium of an assembly under an isotropic stress.
 *
 * FIRE (fast inertial relaxation engine) is a motion with equal masses that stops whenever it goes uphill. The variables
 * are the displacements of all free particles and, as three more, the strain of the boundary or the cell, which all
 * particles follow. One cycle is one force calculation:
 *
 *   P = F.v
 *   P > 0   more than 5 cycles in succession: dt <- min(1.1 dt, 1), a <- 0.99 a
 *   else    v <- 0, dt <- dt/2, a <- 0.1
 *   v <- v + dt g F,   if P > 0:  v <- (1 - a) v + a |v| F/|F|,   x <- x + dt v
 *
 *   v, dt   displacement per unit of dt, m; dt in units of 0.6 of the stable step, 1
 *   F       of a particle: sum of its contact forces, N. Of the strain: V (s - s0)/L; its displacement is L times it
 *   s, s0   stress of the region and its target, compression positive, Pa; V volume of boundary or cell, m3
 *   L       (8 sum R^2)^(1/2), m: gives the strain the inertia of 8 sum R^2 equal masses per unit of length squared
 *   g       (2 0.6)^2/max(S_a + S_b), m/N, over the contacts that touch; S is the sum of k_n over the contacts of a free
 *           particle. The stable step of equal masses m is 2 (m/max(S_a + S_b))^(1/2) (stable_step.c).
 *
 * No strain increment exceeds 2e-4 and no displacement a tenth of the smallest radius, so that no particle passes
 * through another one. Without contacts the strain increment has the largest value.
 *
 * A particle that enters or leaves the region changes its stress by a jump, so the particles of the region are fixed
 * once the stress is near its target. In the end the stress is that of the particles that are inside then. The particles
 * have no velocities, so dashpots have no force.
 *
 * Source   E. Bitzek, P. Koskinen, F. Gaehler, M. Moseler and P. Gumbsch, Structural relaxation made simple, Phys. Rev.
 *          Lett. 97 (2006) 170201, with the authors' parameters.
 * Range    Forces that follow from the positions: no friction, no gravity, no normal law by increments (input/relax.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "loading.h"
#include "measure/boundary.h"
#include "measure/energy.h"
#include "measure/region.h"

static const double step_fraction = 0.6; /* of the stable step */
static const double first_step = 0.1, first_mixing = 0.1;
static const double largest_strain = 2e-4, largest_move = 0.1; /* in a cycle: 1; of the smallest radius */
/* Largest component of s - s0, and the unbalanced ratio, of a sample at rest. With 0.2 % of both, samples in the middle
 * of a rearrangement passed for samples at rest. */
static const double stress_tolerance = 1e-4, unbalanced_tolerance = 1e-5;
/* Largest component of s - s0 over s0 at which the particles of the region are fixed, and at which they are released. */
static const double fix_below = 0.01, release_above = 0.05;

struct nb_relaxation {
  struct nb_vec *velocity, *force; /* per slot: v, m, and F, N */
  double *stiffness;               /* per slot: S, N/m */
  bool *member;                    /* per slot: in the region when its particles were fixed */
  struct nb_tensor strain;         /* v of the strain, m; symmetric */
  double dt, mixing;               /* dt, a */
  int downhill;                    /* cycles in succession with P > 0 */
  double step;                     /* time step of the stage, s, used again after it */
};

static enum nb_status create(struct nb_model *model, struct nb_error *error) {
  const size_t n = model->particles.count;
  struct nb_relaxation *it = model->relaxation = nb_own(&model->owner, 1, sizeof *it);
  if (it) {
    it->velocity = nb_own(&model->owner, n, sizeof *it->velocity);
    it->force = nb_own(&model->owner, n, sizeof *it->force);
    it->stiffness = nb_own(&model->owner, n, sizeof *it->stiffness);
    it->member = nb_own(&model->owner, n, sizeof *it->member);
  }
  return model->owner.failed ? nb_error_memory(error) : NB_OK;
}

static void halt(struct nb_model *model) {
  struct nb_relaxation *it = model->relaxation;
  memset(it->velocity, 0, model->particles.count * sizeof *it->velocity);
  it->strain = tensor(0, 0, 0, 0);
  it->mixing = first_mixing, it->downhill = 0;
}

/* The step is 0 until the end, so that the cycle moves nothing, time stands still and dashpots have no force. */
enum nb_status nb_relaxation_begin(struct nb_model *model, struct nb_error *error) {
  if (!model->relaxation && create(model, error))
    return error->status;
  halt(model);
  model->relaxation->dt = first_step;
  model->relaxation->step = model->step;
  model->step = model->previous_step = 0;
  model->previous_damping = model->damping;
  return NB_OK;
}

void nb_relaxation_end(struct nb_model *model) {
  nb_region_fix(model, model->stage->relax.region, NULL);
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  model->step = model->previous_step = model->relaxation->step;
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* ---- the end ---- */

/* s - s0, Pa. */
static struct nb_tensor stress_error(const struct nb_model *model) {
  const struct nb_relax *relax = &model->stage->relax;
  const struct nb_region_state *region = nb_region_measured(model, relax->region, NB_STRESS);
  return tensor_symmetric(tensor_sub(region->stress.total, tensor(relax->stress, 0, 0, relax->stress)));
}

/* Largest component of the stress error over the target. */
static double relative_error(const struct nb_model *model) {
  return tensor_largest(stress_error(model)) / model->stage->relax.stress;
}

static double unbalanced(const struct nb_model *model) {
  return nb_region_measured(model, model->stage->relax.region, NB_LOADS)->loads.unbalanced_mean;
}

static bool is_at_rest(const struct nb_model *model) {
  return relative_error(model) <= stress_tolerance && unbalanced(model) < unbalanced_tolerance;
}

bool nb_relaxation_ends(struct nb_model *model) {
  const int region = model->stage->relax.region;
  bool *member = model->relaxation->member;
  if (!model->regions->list[region].member) {
    if (relative_error(model) < fix_below)
      nb_region_fix(model, region, member);
    return false;
  }
  if (is_at_rest(model)) {
    nb_region_fix(model, region, NULL);
    if (is_at_rest(model))
      return true;
    nb_region_fix(model, region, member); /* its particles are others now */
  } else if (relative_error(model) > release_above)
    nb_region_fix(model, region, NULL);
  return false;
}

enum nb_status nb_relaxation_failed(const struct nb_model *model, struct nb_error *error) {
  const struct nb_stage *stage = model->stage;
  return nb_error_set(
      error, NB_BROKEN,
      "stage `%s` (line %d) did not come to rest within %lu cycles: the stress is off its target by %.3g %% and should "
      "be by at most %g %%, the unbalanced force is %.3g of the mean contact force and should be below %g",
      stage->name, stage->line, stage->cycles, 100 * relative_error(model), 100 * stress_tolerance, unbalanced(model),
      unbalanced_tolerance);
}

/* ---- one cycle ---- */

/* g, m/N; 0 if nothing touches. */
static double compliance(const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *inverse_mass = model->particles.inverse_mass;
  double *s = model->relaxation->stiffness, largest = 0;
  memset(s, 0, model->particles.count * sizeof *s);
  for (size_t c = 0; c < contacts->count; c++) {
    const double k = nb_touches(contacts, c) ? contacts->kept[NB_STIFFNESS][c] : 0;
    s[contacts->a[c]] += inverse_mass[contacts->a[c]] > 0 ? k : 0;
    s[contacts->b[c]] += inverse_mass[contacts->b[c]] > 0 ? k : 0;
  }
  for (size_t c = 0; c < contacts->count; c++)
    if (nb_touches(contacts, c))
      largest = fmax(largest, s[contacts->a[c]] + s[contacts->b[c]]);
  return largest > 0 ? 4 * step_fraction * step_fraction / largest : 0;
}

/* L, m. */
static double strain_length(const struct nb_model *model) {
  double sum = 0;
  for (size_t i = 0; i < model->particles.count; i++)
    sum += model->particles.surface[i].radius * model->particles.surface[i].radius;
  return sqrt(8 * sum);
}

static double product(struct nb_tensor a, struct nb_tensor b) {
  return a.xx * b.xx + a.xy * b.xy + a.yx * b.yx + a.yy * b.yy;
}

/* Moves all particles by dt v and the strain; free ones, boundary and cell follow the strain. */
static void move(struct nb_model *model, struct nb_tensor strain, double dt) {
  struct nb_particles *particles = &model->particles;
  const struct nb_affine *affine = model->affine;
  double fastest = 0;
  for (size_t i = 0; i < particles->count; i++)
    fastest = fmax(fastest, dt * vec_length(model->relaxation->velocity[i]));
  const double limit = largest_move * model->search.smallest_radius;
  const double slower = fastest > limit ? dt * limit / fastest : dt;
  for (size_t i = 0; i < particles->count; i++) {
    const struct nb_vec x = particles->position[i], own = vec_scale(slower, model->relaxation->velocity[i]);
    if (affine->source[i] != NB_AFFINE_NONE)
      particles->position[i] = vec_add(vec_add(x, own), tensor_times(strain, vec_sub(x, affine->centre)));
    if (model->cell) /* as motion.c moves them */
      particles->search_position[i] = vec_add(
          particles->search_position[i], tensor_times(strain, vec_sub(particles->search_position[i], affine->centre)));
  }
  if (model->cell)
    nb_cell_strain_by(model->cell, strain);
  else
    nb_boundary_strain_by(model, strain);
}

/* F of all particles; returns P. */
static double find_forces(struct nb_model *model, struct nb_tensor pull) {
  struct nb_relaxation *it = model->relaxation;
  double power = product(pull, it->strain);
  for (size_t i = 0; i < model->particles.count; i++) {
    const bool free = model->particles.inverse_mass[i] > 0;
    it->force[i] = free ? nb_force_on(model, i).force : vec(0, 0);
    it->velocity[i] = free ? it->velocity[i] : vec(0, 0); /* the boundary may have taken it in */
    power += vec_dot(it->force[i], it->velocity[i]);
  }
  return power;
}

/* v <- keep v + add F; *ratio: |v|/|F| after it. */
static void kick(struct nb_model *model, struct nb_tensor pull, double keep, double add, double *ratio) {
  struct nb_relaxation *it = model->relaxation;
  it->strain = tensor_add(tensor_scale(keep, it->strain), tensor_scale(add, pull));
  double force = product(pull, pull), velocity = product(it->strain, it->strain);
  for (size_t i = 0; i < model->particles.count; i++) {
    it->velocity[i] = vec_add(vec_scale(keep, it->velocity[i]), vec_scale(add, it->force[i]));
    force += vec_dot(it->force[i], it->force[i]), velocity += vec_dot(it->velocity[i], it->velocity[i]);
  }
  *ratio = force > 0 ? sqrt(velocity / force) : 0;
}

static void step(struct nb_model *model, struct nb_tensor pull, double g, double length) {
  struct nb_relaxation *it = model->relaxation;
  const bool downhill = find_forces(model, pull) > 0;
  double ratio;
  if (!downhill)
    halt(model), it->dt /= 2;
  else if (++it->downhill > 5)
    it->dt = fmin(1.1 * it->dt, 1), it->mixing *= 0.99;
  kick(model, pull, 1, it->dt * g, &ratio);
  if (downhill)
    kick(model, pull, 1 - it->mixing, it->mixing * ratio, &ratio);
  const double requested = it->dt * tensor_largest(it->strain) / length;
  if (requested > largest_strain)
    it->strain = tensor_scale(largest_strain / requested, it->strain);
  move(model, tensor_scale(it->dt / length, it->strain), it->dt);
}

void nb_relaxation_step(struct nb_model *model) {
  const double area = model->cell ? nb_cell_area(model->cell) : nb_boundary_area(model);
  const double g = compliance(model), length = strain_length(model);
  const struct nb_tensor error = stress_error(model);
  if (model->terms)
    nb_sum_add(&model->terms[NB_TERM_CHANGED], -nb_energy_stored(model));
  if (g > 0)
    step(model, tensor_scale(area * nb_thickness(model) / length, error), g, length);
  else
    move(model, tensor_scale(largest_strain / tensor_largest(error), error), 0);
}

void nb_relaxation_after_forces(struct nb_model *model) {
  nb_sum_add(&model->terms[NB_TERM_CHANGED], nb_energy_stored(model));
}
