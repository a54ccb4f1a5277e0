/* The work balance and the energy balance of a run: sums since the start. Each term is computed from its own
 * definition.
 *
 * work      K_(N-1/2) - K_0 = sum over kicks of the work of all forces; K is the kinetic energy, J. The impulse
 *           P = F tau of the forces F, N, over the duration tau of a kick, s, and the impulse P_d of mass-proportional
 *           damping change a particle's velocity from v- to v+, and its energy by (P + P_d).(v- + v+)/2. This holds for
 *           any step, including the half kick at the start (tau = dt/2, v- = v_0); the residual is only rounding.
 *
 * energy    residual = K + U - (K + U)_0 + frictional + damped + removed - walls - gravity - imposed - changed, at t_N,
 *           J. U is the stored energy, a state function (energy.c). Forces that depend on velocity, and prescribed
 *           forces, act at t_N with the velocity at t_N, over the kick around t_N. Friction acts over the step from t_N
 *           to t_(N+1), with the mean of the forces at both ends:
 *
 *             damped      D_n dn + D_s ds  of dashpots; C v.v tau of mass-proportional damping, C = alpha m; over kicks
 *                                                                                                     [CS79 26-36]
 *             walls       F.V tau  of walls and fixed particles that move with the velocity V and exert the force F
 *                                  on particles, over kicks
 *             gravity     m g.(v + c) tau  over kicks
 *             imposed     work of the imposed motion; force of a boundary stress times v tau, over kicks
 *             frictional  F_s (ds - dF_s/k_s)  of contacts that slide, or open with a loaded shear spring, over steps;
 *                         with micro-slip the dissipation that the law returns
 *             sliding     the part of `frictional` in steps in which the contact slides as a whole
 *             shear       F_s ds  over steps
 *
 *           The residual is the error of the time integration. A kick lasts until half a step after t_N: a value at t_N
 *           contains only the half of the kick before t_N.
 *
 * The work of the imposed motion is -sum over particles of (F + m g).c + sum over contacts of f.(L H m):
 *
 *   F   sum of the contact forces on a particle, N         c     its imposed velocity, m/s (affine.h)
 *   f   force on the first particle of a contact, N        L H m velocity of the second particle's image minus that of
 *                                                                the second particle, in a cell, m/s (cell.c)
 *
 * K contains only the particles' own velocities v. So the imposed motion supplies the work of the forces along c, both
 * on free particles and on particles held by a boundary. In a cell without gravity this work is the sum of f.(L l) over
 * contacts, -V sigma_ij L_ij: V is the volume of the cell, m3, sigma the stress, Pa, compression positive, and l the
 * vector from centre to centre, m. During the kick around t_N the imposed velocity is c_(N-1/2) in the first half and
 * c_(N+1/2) in the second half.
 *
 * For a shear law without stored energy the residual contains the shear work instead of U_s and frictional. One thread
 * computes the sums over particles and contacts, in the order of their numbers and with compensation of rounding
 * (Neumaier 1974), so they have the same bits with any number of threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "balance.h"
#include "core/affine.h"
#include "core/motion.h"

/* ---- creation ---- */

/* The first law without stored energy, among the normal laws or among the shear laws of the material pairs; NULL:
 * none. */
static const struct nb_law *law_without_energy(const struct nb_model *model, bool normal) {
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_law *law = normal ? model->material_pairs[p].normal : model->material_pairs[p].shear;
    if (law && !law->stored)
      return law;
  }
  return NULL;
}

/* NB_BAD_USE if a requested energy is not defined for a law of the scene. */
static enum nb_status check_stored_energy(const struct nb_model *model, struct nb_error *error) {
  const unsigned requested = model->plan.requested;
  const struct nb_law *normal = law_without_energy(model, true), *shear = law_without_energy(model, false);
  normal = normal ? normal : nb_laws_unstored(model->scene, true);
  shear = shear ? shear : nb_laws_unstored(model->scene, false);
  if (requested & NB_REQUEST_STORED && (normal || shear))
    return nb_error_set(
        error, NB_BAD_USE,
        "`%s %s` has no stored energy: record `energy.shear`, not `energy.stored` and `energy.friction`",
        normal ? "normal" : "shear", normal ? normal->name : shear->name);
  if (requested & NB_REQUEST_ENERGY && normal)
    return nb_error_set(error, NB_BAD_USE, "`normal %s` has no stored energy, so energies do not balance",
                        normal->name);
  return NB_OK;
}

/* False: no memory. */
static bool allocate(struct nb_model *model) {
  struct nb_balance *b = model->balance = calloc(1, sizeof *b);
  if (!b)
    return false;
  b->particles = nb_array(model->particles.count, sizeof *b->particles);
  b->walls = nb_array(model->walls.count, sizeof *b->walls);
  b->shear = nb_array(model->material_pair_count, sizeof *b->shear);
  const bool energy = model->plan.requested & NB_REQUEST_ENERGY;
  model->terms = energy ? nb_array(NB_TERMS, sizeof *model->terms) : NULL;
  return b->particles && b->walls && b->shear && (model->terms || !energy);
}

/* Records the velocities of the walls over the step that ends at t_N. */
static void record_walls(const struct nb_model *model) {
  for (size_t w = 0; w < model->walls.count; w++)
    model->balance->walls[w].speed = (struct nb_velocities){model->walls.velocity[w], model->walls.spin[w]};
}

enum nb_status nb_balance_create(struct nb_model *model, struct nb_error *error) {
  if (check_stored_energy(model, error))
    return error->status;
  if (!(model->plan.requested & (NB_REQUEST_WORK | NB_REQUEST_ENERGY)))
    return NB_OK;
  if (!allocate(model))
    return nb_error_memory(error);
  struct nb_balance *b = model->balance;
  b->initial_kinetic = nb_energy_kinetic_half(model);
  record_walls(model);
  if (!model->terms)
    return NB_OK;
  b->initial_energy = nb_energy_kinetic(model) + nb_energy_stored(model);
  nb_balance_add_half(model, -1); /* the last step of a saved state is not part of this run */
  return NB_OK;
}

void nb_balance_free(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  if (!b)
    return;
  free(b->particles), free(b->walls), free(b->shear), free(b->overlaps), free(b);
  free(model->terms);
  model->balance = NULL, model->terms = NULL;
}

/* ---- a kick: the forces at t_N act from half a step before to half a step after t_N ---- */

struct kick {
  double first_half, second_half; /* parts before and after t_N that count, s */
  double time, fraction;          /* duration of the whole kick, s; fraction of the kick that counts */
  double fraction_before;         /* fraction of the kick that has the damping of the previous stage */
};

static struct kick whole_kick(const struct nb_model *model) {
  const double first_half = model->previous_step / 2, second_half = model->step / 2;
  return (struct kick){first_half, second_half, first_half + second_half, 1, nb_kick_fraction_before(model)};
}

/* The half of the kick before t_N. It does not depend on the next stage. */
static struct kick half_kick(const struct nb_model *model) {
  return (struct kick){model->previous_step / 2, 0, model->previous_step, 0.5, 1};
}

/* Computes the imposed displacements over a kick. */
static void set_imposed_displacements(const struct nb_model *model, struct kick kick) {
  struct nb_balance *b = model->balance;
  const struct nb_cell *cell = model->cell;
  for (size_t i = 0; i < model->particles.count && model->affine; i++)
    b->particles[i].imposed =
        vec_add(vec_scale(kick.first_half, model->particles.imposed[i]),
                vec_scale(kick.second_half, nb_affine_separate(model->affine, i, model->particles.position[i])));
  if (cell)
    b->copy_displacement =
        tensor_add(tensor_scale(kick.first_half, cell->image_velocity),
                   tensor_scale(kick.second_half, tensor_product(model->affine->rate[NB_AFFINE_CELL], cell->h)));
}

/* Displacement of the second particle's image in contact c minus that of the second particle, over a kick, m. */
static struct nb_vec copy_displacement(const struct nb_model *model, size_t c) {
  return model->cell ? tensor_times(model->balance->copy_displacement, model->contacts.image[c]) : vec(0, 0);
}

/* Records positions and velocities at t_N. */
static void record_state(const struct nb_model *model, struct kick kick) {
  struct nb_balance *b = model->balance;
  for (size_t i = 0; i < model->particles.count; i++) {
    b->particles[i].before = nb_velocity_half(model, i), b->particles[i].position = model->particles.position[i];
    if (model->terms)
      b->particles[i].now = nb_velocity_now(model, i);
  }
  for (size_t w = 0; w < model->walls.count; w++)
    b->walls[w].pivot = model->walls.pivot[w];
  set_imposed_displacements(model, kick);
}

/* The imposed velocity that is added to a particle's own velocity (`accumulated`, affine.h), m/s. */
static struct nb_vec accumulated(const struct nb_model *model, size_t i) {
  return model->affine ? nb_affine_accumulated(model->affine, i, model->balance->particles[i].position) : vec(0, 0);
}

/* Energy that mass-proportional damping takes from a particle in a kick, J: the impulse of the damping times the mean
 * velocity of the particle. `before`: velocities before the kick; `mean`: mean velocities in the kick; `force`: sum of
 * all forces. */
static double damping_loss(const struct nb_model *model, size_t i, struct nb_velocities before,
                           struct nb_velocities mean, struct nb_force force, struct kick kick) {
  const struct nb_vec velocity = vec_sub(vec_scale(2, mean.velocity), before.velocity);
  const struct nb_velocities after = {vec_sub(velocity, accumulated(model, i)), 2 * mean.spin - before.spin};
  const struct nb_damping_losses losses = nb_damping_losses(model, kick.time, kick.fraction_before);
  const struct nb_vec kept = vec_add(vec_scale(losses.old, before.velocity), vec_scale(losses.new, after.velocity));
  const struct nb_vec linear =
      vec_add(vec_scale(model->particles.mass[i], kept), vec_scale(losses.impulse * kick.time, force.force));
  const double angular = model->particles.inertia[i] * (losses.old * before.spin + losses.new *after.spin) +
                         losses.impulse * kick.time * force.moment;
  return vec_dot(linear, mean.velocity) + angular * mean.spin;
}

/* Energy that accumulated affine motion and a boundary stress give to a particle in a kick, J. `mean`: mean velocity of
 * the particle in the kick, m/s; `time`: duration of the kick, s. */
static double imposed_work(const struct nb_model *model, size_t i, struct nb_vec mean, double time) {
  struct nb_vec impulse = vec_scale(model->particles.mass[i], accumulated(model, i));
  if (model->particles.boundary_force)
    impulse = vec_add(impulse, vec_scale(time, model->particles.boundary_force[i]));
  return vec_dot(impulse, mean);
}

static void add_particles(struct nb_sum terms[], const struct nb_model *model, struct kick kick) {
  const struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    const struct nb_velocities before = model->balance->particles[i].before, now = model->balance->particles[i].now;
    struct nb_force force = nb_force_on(model, i);
    if (!(particles->inverse_mass[i] > 0)) {
      const double power = vec_dot(force.force, now.velocity) + force.moment * now.spin;
      nb_sum_add(&terms[NB_TERM_WALLS], -kick.fraction * kick.time * power);
      continue;
    }
    const struct nb_vec weight = nb_weight(model, i, model->balance->particles[i].position);
    force.force =
        vec_add(force.force, particles->boundary_force ? vec_add(weight, particles->boundary_force[i]) : weight);
    nb_sum_add(&terms[NB_TERM_GRAVITY], kick.fraction * kick.time * vec_dot(weight, now.velocity) +
                                            vec_dot(weight, model->balance->particles[i].imposed));
    if (model->affine)
      nb_sum_add(&terms[NB_TERM_IMPOSED], kick.fraction * imposed_work(model, i, now.velocity, kick.time));
    nb_sum_add(&terms[NB_TERM_DAMPED], kick.fraction * damping_loss(model, i, before, now, force, kick));
  }
}

/* Adds the work of all forces on free particles. The velocity is the mean of those before and after the kick. */
static void add_work(struct nb_sum *work, const struct nb_model *model, struct kick kick) {
  const struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    if (!(particles->inverse_mass[i] > 0))
      continue;
    const struct nb_velocities before = model->balance->particles[i].before, after = nb_velocity_half(model, i);
    const struct nb_velocities mean = {vec_scale(0.5, vec_add(before.velocity, after.velocity)),
                                       (before.spin + after.spin) / 2};
    struct nb_force force = nb_force_on(model, i);
    force.force = vec_add(force.force, nb_weight(model, i, model->balance->particles[i].position));
    if (model->affine)
      nb_sum_add(work, imposed_work(model, i, mean.velocity, kick.time));
    nb_sum_add(work, kick.time * (vec_dot(force.force, mean.velocity) + force.moment * mean.spin));
    if (model->particles.boundary_force)
      force.force = vec_add(force.force, model->particles.boundary_force[i]);
    nb_sum_add(work, -damping_loss(model, i, before, mean, force, kick));
  }
}

/* Displacement over a kick of the point of wall w that is at q, m. */
static struct nb_vec wall_displacement(const struct nb_model *model, struct kick kick, int w, struct nb_vec q) {
  const struct nb_velocities speed = model->balance->walls[w].speed;
  const struct nb_vec arm = vec_sub(q, model->balance->walls[w].pivot), perpendicular = vec(-arm.y, arm.x);
  const struct nb_vec before = vec_add(speed.velocity, vec_scale(speed.spin, perpendicular));
  const struct nb_vec after = vec_add(model->walls.velocity[w], vec_scale(model->walls.spin[w], perpendicular));
  return vec_add(vec_scale(kick.first_half, before), vec_scale(kick.second_half, after));
}

/* Adds the work of dashpots and walls. */
static void add_contacts(struct nb_sum terms[], const struct nb_model *model, struct kick kick) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_balance *b = model->balance;
  const double time = kick.first_half + kick.second_half;
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
    const struct nb_vec f =
        nb_contact_force(contacts, c); /* centred dashpots still act in the step in which a contact ends */
    if ((!model->plan.dashpots && !material_pair->wall) || (!nb_touches(contacts, c) && f.x == 0 && f.y == 0))
      continue;
    const int i = contacts->a[c], j = contacts->b[c];
    const struct nb_vec e = vec(contacts->kept[NB_EX][c], contacts->kept[NB_EY][c]);
    const double radius = model->particles.radius[i];
    struct nb_vec displacement = vec_add(vec_scale(time, b->particles[i].now.velocity), b->particles[i].imposed);
    double rolling = time * b->particles[i].now.spin * radius;
    if (material_pair->wall) {
      const double arm_length = radius - contacts->kept[NB_OVERLAP][c];
      const struct nb_vec wall =
          wall_displacement(model, kick, j, vec_add(b->particles[i].position, vec_scale(arm_length, e)));
      nb_sum_add(&terms[NB_TERM_WALLS], vec_dot(f, wall));
      displacement = vec_sub(displacement, wall);
    } else {
      const struct nb_vec imposed = vec_add(b->particles[j].imposed, copy_displacement(model, c));
      displacement = vec_sub(displacement, vec_add(vec_scale(time, b->particles[j].now.velocity), imposed));
      rolling += time * b->particles[j].now.spin * model->particles.radius[j];
    }
    if (!model->plan.dashpots)
      continue;
    nb_sum_add(&terms[NB_TERM_DAMPED],
               (contacts->kept[NB_TOTAL_NORMAL][c] - contacts->kept[NB_NORMAL][c]) * vec_dot(displacement, e));
    if (material_pair->shear)
      nb_sum_add(&terms[NB_TERM_DAMPED], (contacts->force[c].shear - contacts->kept[NB_SHEAR][c]) *
                                             (vec_dot(displacement, vec_clockwise(e)) - rolling));
  }
}

/* Adds the work of the imposed motion. */
static void add_imposed(struct nb_sum terms[], const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < particles->count && model->affine; k++) {
    const size_t i = (size_t)particles->slot[k];
    struct nb_vec force = nb_force_on(model, i).force;
    if (particles->inverse_mass[i] > 0)
      force = vec_add(force, nb_weight(model, i, model->balance->particles[i].position));
    nb_sum_add(&terms[NB_TERM_IMPOSED], -vec_dot(force, model->balance->particles[i].imposed));
  }
  for (size_t c = 0; c < model->contacts.count && model->cell; c++)
    nb_sum_add(&terms[NB_TERM_IMPOSED], vec_dot(nb_contact_force(&model->contacts, c), copy_displacement(model, c)));
}

static void add_terms(struct nb_sum terms[], const struct nb_model *model, struct kick kick) {
  add_particles(terms, model, kick);
  add_imposed(terms, model);
  add_contacts(terms, model, kick);
}

void nb_balance_before_motion(struct nb_model *model) { record_state(model, whole_kick(model)); }

void nb_balance_after_motion(struct nb_model *model) {
  const struct kick kick = whole_kick(model);
  add_work(&model->balance->work, model, kick);
  if (!model->terms)
    return;
  add_terms(model->terms, model, kick);
  record_walls(model);
}

static void add_half_kick(struct nb_sum terms[], const struct nb_model *model) {
  const struct kick kick = half_kick(model);
  if (!(kick.first_half > 0))
    return;
  record_state(model, kick);
  add_terms(terms, model, kick);
}

void nb_balance_add_half(struct nb_model *model, double sign) {
  struct nb_sum first_half[NB_TERMS] = {{0}};
  add_half_kick(first_half, model);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&model->terms[t], sign * first_half[t].sum);
}

/* ---- values ---- */

double nb_balance_term(const struct nb_model *model, enum nb_term term) {
  struct nb_sum now[NB_TERMS];
  memcpy(now, model->terms, sizeof now);
  add_half_kick(now, model);
  return now[term].sum + now[term].rest;
}

double nb_balance_work_residual(const struct nb_model *model) {
  struct nb_sum sum = model->balance->work;
  nb_sum_add(&sum, model->balance->initial_kinetic);
  nb_sum_add(&sum, -nb_energy_kinetic_half(model));
  return -(sum.sum + sum.rest);
}

double nb_balance_energy_residual(const struct nb_model *model) {
  static const double sign[NB_TERMS] = {
      [NB_TERM_DAMPED] = 1,   [NB_TERM_WALLS] = -1,   [NB_TERM_GRAVITY] = -1, [NB_TERM_FRICTIONAL] = 1,
      [NB_TERM_UNSTORED] = 1, [NB_TERM_CHANGED] = -1, [NB_TERM_REMOVED] = 1,  [NB_TERM_IMPOSED] = -1};
  struct nb_sum now[NB_TERMS], sum = {0};
  memcpy(now, model->terms, sizeof now);
  add_half_kick(now, model);
  nb_sum_add(&sum, nb_energy_kinetic(model));
  nb_sum_add(&sum, nb_energy_stored(model));
  nb_sum_add(&sum, -model->balance->initial_energy);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&sum, sign[t] * now[t].sum), nb_sum_add(&sum, sign[t] * now[t].rest);
  return sum.sum + sum.rest;
}
