/* The boundary of an assembly, a ring of its outermost particles; and `rotation on|off`.  [R89 sec. 6.4.1, sec. 6.5.1]
 *
 * When a boundary begins, a circle defines its particles: all free ones with centres on the circle or outside it. While
 * these particles are held, they follow the boundary's strain rate L, 1/s (affine.c), and have no velocity of their
 * own. Their mass counts as infinite, they do not rotate, and there is no force between two of them. Their centres move
 * as
 *
 *   x_(N+1) - x_0 = (1 + L dt)(x_N - x_0)
 *
 * about the centre x_0 of the circle. The circle, of radius R, m, deforms with them into the ellipse x = x_0 + S y with
 * |y| = R and S_(N+1) = (1 + L dt) S_N. When the centre of another free particle reaches the ellipse or crosses it, the
 * particle becomes part of the boundary.
 *
 * After each search, and when the ellipse has moved by half the skin, the particles closer to the ellipse than the skin
 * are listed as candidates, because only these can cross the ellipse before the next list. So each cycle checks few
 * particles, and no result depends on the skin.
 *
 * The polygon through the centres of the boundary's particles, counterclockwise, has the area
 *
 *   A = sum (x_i y_(i+1) - x_(i+1) y_i)/2
 *
 * m2. Each particle represents half of each of the two sides that meet in its centre: with the outward normal n and the
 * length l, m, n l is (x_(i+1) - x_(i-1))/2 rotated clockwise. A stress s on the boundary, Pa, compression positive,
 * causes the force F = -s n l h on each particle, N, where h is the thickness, m. The sum of these forces is 0, and sum
 * F_i (x - x_0)_j = -s_ij A h. measure/boundary.c computes the area and the stress.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "loading.h"
#include "measure/boundary.h"
#include "measure/energy.h"

/* ---- the circle ---- */

/* A centre closer to the circle than this fraction of the radius counts as on the circle. A page may place particles on
 * the circle, and their positions are rounded (1e-16). */
static const double on_circle = 1e-12;

/* True if x is on the ellipse or outside, or inside by at most `margin`, m. This distance is measured after the ellipse
 * and x have been mapped back to the circle. */
static bool is_outside(const struct nb_model *model, struct nb_vec x, double margin) {
  const struct nb_ring *ring = &model->boundary->ring;
  const struct nb_vec reference = tensor_times(tensor_inverse(ring->shape), vec_sub(x, model->affine->centre));
  return vec_length(reference) >= ring->radius * (1 - on_circle) - margin;
}

/* True if particle i can become part of the boundary. Fixed and removed particles have the source NB_AFFINE_NONE. */
static bool may_join(const struct nb_model *model, size_t i) { return model->affine->source[i] == NB_AFFINE_FREE; }

/* ---- a particle joins or leaves ---- */

static void stop_spin(struct nb_particles *particles, size_t i) {
  if (particles->spin)
    particles->spin[i] = 0;
  particles->surface_speed[i] = 0;
}

static void attach(struct nb_model *model, int slot) {
  struct nb_particles *particles = &model->particles;
  const size_t i = (size_t)slot;
  if (model->terms) /* the energy balance has no kinetic energy of held particles */
    nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_kinetic_of(model, i));
  nb_affine_assign(model->affine, i, NB_AFFINE_BOUNDARY);
  particles->imposed[i] = particles->velocity[i] = nb_imposed_velocity(model->affine, i, particles->position[i]);
  particles->inverse_mass[i] = particles->inverse_inertia[i] = 0;
  stop_spin(particles, i);
}

static void detach(struct nb_model *model, int slot) {
  struct nb_particles *particles = &model->particles;
  const size_t i = (size_t)slot;
  nb_affine_assign(model->affine, i, NB_AFFINE_FREE);
  particles->imposed[i] = nb_affine_separate(model->affine, i, particles->position[i]);
  particles->inverse_mass[i] = 1 / particles->mass[i];
  particles->inverse_inertia[i] = model->rotates ? 1 / particles->inertia[i] : 0;
  nb_motion_set_velocity(model, i, nb_velocity_half(model, i));
  if (model->terms)
    nb_sum_add(&model->terms[NB_TERM_REMOVED], -nb_energy_kinetic_of(model, i));
}

/* ---- members ---- */

static bool in_lower_half(struct nb_vec a) { return a.y < 0 || (a.y == 0 && a.x < 0); }

/* True if slot i comes before slot j, counterclockwise from the x axis. */
static bool comes_before(const struct nb_model *model, int i, int j) {
  const struct nb_vec a = vec_sub(model->particles.position[i], model->affine->centre);
  const struct nb_vec b = vec_sub(model->particles.position[j], model->affine->centre);
  const double cross = vec_cross(a, b);
  if (in_lower_half(a) != in_lower_half(b))
    return in_lower_half(b);
  return cross != 0 ? cross > 0 : model->particles.number[i] < model->particles.number[j];
}

/* Adds a particle to the list of members, which is sorted counterclockwise. */
static void add_member(struct nb_model *model, int slot) {
  struct nb_ring *ring = &model->boundary->ring;
  size_t k = ring->count++;
  for (; k > 0 && comes_before(model, slot, ring->member[k - 1]); k--)
    ring->member[k] = ring->member[k - 1];
  ring->member[k] = slot;
}

static void join(struct nb_model *model, int slot) {
  attach(model, slot);
  add_member(model, slot);
}

/* Ends the hold: the particles of the boundary become free. `dissolve`: the boundary ends, too. */
static void boundary_release(struct nb_model *model, bool dissolve) {
  struct nb_ring *ring = &model->boundary->ring;
  for (size_t k = 0; k < ring->count && ring->held; k++)
    detach(model, ring->member[k]);
  ring->held = false;
  if (dissolve)
    ring->exists = false, ring->count = 0;
}

static void boundary_define(struct nb_model *model, const struct nb_circle *circle) {
  struct nb_ring *ring = &model->boundary->ring;
  boundary_release(model, true);
  model->affine->centre = vec(circle->x, circle->y);
  ring->exists = ring->held = true;
  ring->radius = circle->radius, ring->shape = tensor(1, 0, 0, 1), ring->listed_search = 0;
  for (size_t k = 0; k < model->particles.count; k++) {
    const int i = model->particles.slot[k];
    if (may_join(model, (size_t)i) && is_outside(model, model->particles.position[i], 0))
      join(model, i);
  }
}

/* Holds the particles of an existing boundary again. The circle gets their mean distance from the centre as radius. */
static void boundary_hold(struct nb_model *model) {
  struct nb_ring *ring = &model->boundary->ring;
  if (!ring->exists)
    return;
  if (ring->count > 0)
    ring->radius = nb_boundary_radius(model), ring->shape = tensor(1, 0, 0, 1);
  ring->held = true, ring->listed_search = 0;
  for (size_t k = 0; k < ring->count; k++)
    attach(model, ring->member[k]);
}

void nb_boundary_remove(struct nb_model *model, size_t slot) {
  struct nb_ring *ring = &model->boundary->ring;
  size_t left = 0;
  for (size_t k = 0; k < ring->count; k++)
    if (ring->member[k] != (int)slot)
      ring->member[left++] = ring->member[k];
  ring->count = left;
}

/* ---- a stress on the boundary ---- */

void nb_boundary_set_forces(struct nb_model *model) {
  struct nb_boundary_state *state = model->boundary;
  const size_t count = state->ring.count;
  const double thickness = nb_thickness(model);
  for (size_t i = 0; i < model->particles.count; i++)
    state->boundary_force[i] = vec(0, 0);
  for (size_t k = 0; k < count; k++) {
    const struct nb_vec along = vec_sub(nb_boundary_position(model, k + 1), nb_boundary_position(model, k + count - 1));
    state->boundary_force[state->ring.member[k]] =
        vec_scale(-thickness / 2, tensor_times(state->stress, vec_clockwise(along)));
  }
}

/* ---- creation ---- */

static bool needed(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].circle.line)
      return true;
  return scene->circle.line > 0;
}

static bool has_stress(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].boundary.control == NB_CONTROL_STRESS)
      return true;
  return false;
}

enum nb_status nb_boundary_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  const struct nb_particles *particles = &model->particles;
  if (!needed(scene))
    return NB_OK;
  struct nb_boundary_state *state = model->boundary = nb_own(&model->owner, 1, sizeof *state);
  if (state) {
    state->boundary_force =
        has_stress(scene) ? nb_own(&model->owner, particles->count, sizeof *state->boundary_force) : NULL;
    state->ring.member = nb_own(&model->owner, particles->count, sizeof *state->ring.member);
    state->ring.candidates = nb_own(&model->owner, particles->count, sizeof *state->ring.candidates);
  }
  if (model->owner.failed)
    return nb_error_memory(error);
  if (scene->circle.line && model->cycle == 0) /* later, the saved state contains the boundary */
    boundary_define(model, &scene->circle);
  return NB_OK;
}

/* ---- the beginning of a stage ---- */

/* Counts the energy of the springs between held particles, and between held particles and walls, as removed, because
 * the next search drops these contacts. */
static void count_removed_springs(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *inverse = model->particles.inverse_mass;
  for (size_t c = 0; c < contacts->count; c++)
    if (inverse[contacts->a[c]] == 0 && (nb_with_wall(model, c) || inverse[contacts->b[c]] == 0))
      nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_of_contact(model, c));
}

static enum nb_status search_again(struct nb_model *model, struct nb_error *error) {
  if (model->terms)
    count_removed_springs(model);
  return nb_pairs_changed(model, error);
}

void nb_rotation_begin(struct nb_model *model, bool rotates) {
  struct nb_particles *particles = &model->particles;
  model->rotates = rotates;
  nb_balance_jump(model, NB_TERM_CHANGED, true);
  for (size_t i = 0; i < particles->count; i++) {
    if (!(particles->inverse_mass[i] > 0))
      continue;
    const struct nb_velocities now = nb_velocity_now(model, i);
    particles->inverse_inertia[i] = rotates ? 1 / particles->inertia[i] : 0;
    if (rotates)
      nb_motion_set_velocity(model, i, now);
    else
      stop_spin(particles, i);
  }
  nb_balance_jump(model, NB_TERM_CHANGED, false);
}

/* Begins or ends the stress at t_0, the start of the stage, without a change of the velocities at t_0. So the half kick
 * before t_0 excludes a stress that begins, and includes a stress that ends. */
static void switch_stress(struct nb_model *model, bool on) {
  struct nb_boundary_state *state = model->boundary;
  if (on)
    nb_boundary_set_forces(model);
  for (size_t i = 0; i < model->particles.count && (on || model->particles.boundary_force); i++)
    nb_motion_offset_force(model, i, (struct nb_force){vec_scale(on ? -1 : 1, state->boundary_force[i]), 0});
  model->particles.boundary_force = on ? state->boundary_force : NULL;
}

static void boundary_control(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_boundary_state *state = model->boundary;
  const struct nb_boundary *boundary = &stage->boundary;
  switch_stress(model, false);
  if (stage->circle.line)
    boundary_define(model, &stage->circle);
  if (!boundary->line)
    return;
  state->stress = tensor(boundary->sxx, boundary->sxy, boundary->sxy, boundary->syy);
  if (boundary->control == NB_CONTROL_STRAIN && !state->ring.held)
    boundary_hold(model);
  else if (boundary->control != NB_CONTROL_STRAIN)
    boundary_release(model, boundary->control == NB_CONTROL_NONE);
  if (boundary->control == NB_CONTROL_STRESS)
    switch_stress(model, true);
}

enum nb_status nb_boundary_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  if (!stage->circle.line && !stage->boundary.line)
    return NB_OK;
  nb_balance_exclude(model, true);
  boundary_control(model, stage);
  return search_again(model, error);
}

/* ---- particles that cross the ellipse ---- */

static void list_candidates(struct nb_model *model) {
  struct nb_ring *ring = &model->boundary->ring;
  const double margin = model->search.skin * tensor_size(tensor_inverse(ring->shape));
  ring->candidate_count = 0;
  for (size_t k = 0; k < model->particles.count; k++) {
    const int i = model->particles.slot[k];
    if (may_join(model, (size_t)i) && is_outside(model, model->particles.position[i], margin))
      ring->candidates[ring->candidate_count++] = i;
  }
  ring->listed_shape = ring->shape;
  ring->listed_search = model->search.count + 1;
}

enum nb_status nb_boundary_before_motion(struct nb_model *model, struct nb_error *error) {
  struct nb_ring *ring = &model->boundary->ring;
  if (ring->listed_search != model->search.count + 1 ||
      !(tensor_size(tensor_sub(ring->shape, ring->listed_shape)) * ring->radius <= model->search.skin / 2))
    list_candidates(model);
  bool joins = false;
  for (size_t k = 0; k < ring->candidate_count && !joins; k++)
    joins = is_outside(model, model->particles.position[ring->candidates[k]], 0);
  if (!joins)
    return NB_OK;
  nb_balance_exclude(model, true);
  for (size_t k = 0; k < ring->candidate_count; k++)
    if (is_outside(model, model->particles.position[ring->candidates[k]], 0))
      join(model, ring->candidates[k]);
  ring->listed_search = 0; /* the new members are no longer candidates */
  return search_again(model, error);
}

/* Changes the velocity of each held particle by c_(N+1/2) - c_(N-1/2), its only change (motion.c). */
void nb_boundary_set_velocities(struct nb_model *model) {
  const struct nb_ring *ring = &model->boundary->ring;
  struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < ring->count; k++) {
    const size_t i = (size_t)ring->member[k];
    const struct nb_vec c = nb_imposed_velocity(model->affine, i, particles->position[i]);
    particles->velocity[i] = vec_add(vec_sub(particles->velocity[i], particles->imposed[i]), c);
    particles->imposed[i] = nb_affine_separate(model->affine, i, particles->position[i]);
  }
}

void nb_boundary_after_motion(struct nb_model *model) {
  struct nb_boundary_state *state = model->boundary;
  struct nb_ring *ring = &state->ring;
  if (ring->held) {
    const struct nb_tensor step = tensor_scale(model->step, model->affine->rate[NB_AFFINE_BOUNDARY]);
    ring->shape = tensor_add(ring->shape, tensor_product(step, ring->shape));
  }
  if (model->particles.boundary_force)
    nb_boundary_set_forces(model);
}
