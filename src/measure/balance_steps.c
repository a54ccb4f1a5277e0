/* Terms of the energy balance that belong to steps and stages: friction, springs that change under load or appear
 * loaded, and velocities that jump.
 *
 *   F_s, F_s'   shear force at t_N and at t_(N+1), N;  ds  tangential increment in this step, m;  k_s  stiffness, N/m
 *   U_n, U_s    energy stored in the normal and in the shear spring, J (energy.c)
 *
 *   shear       (F_s' + F_s)/2 ds
 *   frictional  (F_s' + F_s)/2 (ds - (F_s' - F_s)/k_s)        if the contact slides: ds minus the elastic displacement
 *               the dissipation that the law returns         for a law with micro-slip
 *   sliding     the part of frictional in steps at whose end the contact slides as a whole
 *
 * A contact that opens loses the energy of its shear spring: F_s' = 0. This energy counts as frictional, not as
 * sliding. If a contact sticks, the bracket is 0 except for rounding, and nothing is added.
 *
 * When a stage changes k_n or k_s, the energy of loaded springs changes by U_n(new) - U_n(old) at the same overlap and
 * by U_s(new) - U_s(old) at the same force. The normal force of the step is the mean of an old and a new force, so the
 * change of the normal energy is the mean of the changes at the two ends of the step. The shear spring has the new
 * stiffness during the whole step. A new normal law changes the energy in the same way: by U_n of the new law minus U_n
 * of the old one. A new shear law begins without displacement: U_s is lost at t_N, and so is the work F_s ds/2 of the
 * old force in the first half of the step. The same holds if the stage removes the friction of a contact.
 *
 * When a boundary is released, two of its particles may overlap although they were not listed. At t_N they overlap by
 * alpha, m, without a force; at t_(N+1) the overlap is alpha' and the force F_n(alpha'). The force of the step is the
 * mean of 0 and F_n(alpha'), so the energy supplied is the mean of the spring energies at the two ends:
 *
 *   energy.changed += (U_n(alpha) + U_n(alpha'))/2
 *
 * The shear springs of these pairs begin unloaded, so their work counts from the first step on.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "balance.h"

static void add_shear_work(struct nb_model *model, size_t c) {
  const struct nb_law *law = model->material_pairs[model->contacts.material_pair[c]].shear;
  const double old_force = nb_field_of(model, (long)c, NB_SHEAR_BEFORE),
               old_stiffness = nb_field_of(model, (long)c, NB_SHEAR_STIFFNESS_BEFORE);
  const double new_force = law ? nb_field_of(model, (long)c, NB_SHEAR) : 0,
               stiffness = nb_field_of(model, (long)c, NB_SHEAR_STIFFNESS);
  model->contacts.kept[NB_SHEAR_BEFORE][c] = new_force, model->contacts.kept[NB_SHEAR_STIFFNESS_BEFORE][c] = stiffness;
  if (!law || (old_force == 0 && new_force == 0))
    return;
  const double ds = nb_field_of(model, (long)c, NB_TANGENTIAL_INCREMENT), mean = (old_force + new_force) / 2;
  const bool sliding = nb_field_of(model, (long)c, NB_SLIDING) > 0;
  double dissipated = 0;
  nb_sum_add(&model->terms[NB_TERM_SHEAR], mean * ds);
  if (!law->stored)
    nb_sum_add(&model->terms[NB_TERM_UNSTORED], mean * ds);
  else if (law->dissipative)
    dissipated = nb_field_of(model, (long)c, NB_DISSIPATED);
  else if (!(stiffness > 0)) /* the contact has opened */
    dissipated = mean * (ds + old_force / old_stiffness);
  else if (sliding)
    dissipated = mean * (ds - (new_force - old_force) / stiffness);
  nb_sum_add(&model->terms[NB_TERM_FRICTIONAL], dissipated);
  if (sliding)
    nb_sum_add(&model->terms[NB_TERM_SLIDING], dissipated);
}

/* ---- changes of properties and laws ---- */

/* Copies the history of contact c's normal law. */
static void history_of(double history[], const struct nb_model *model, size_t c) {
  double buffer[NB_HISTORY];
  memcpy(history, nb_history_read(&model->contacts.normal_history, c, buffer), NB_HISTORY * sizeof *history);
}

/* U_n of contact c, J, with this overlap and this history, which the law may change; dn: increment of the overlap since
 * the history. */
static double normal_energy(const struct nb_model *model, size_t c, double overlap, double dn, double history[]) {
  const struct nb_material_pair *material_pair = &model->material_pairs[model->contacts.material_pair[c]];
  if (!(overlap > 0))
    return 0;
  const struct nb_pair values = nb_contact_constants(model, c, material_pair->values);
  struct nb_normal n = material_pair->normal->normal(values, overlap, dn, history);
  n.overlap = overlap;
  return material_pair->normal->stored(values, n, history);
}

/* Subtracts the mean of U_n at t_N and at t_(N+1), with the laws before the change. The positions are those at t_(N+1).
 */
static void subtract_old_normal_energy(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  for (size_t c = 0; c < contacts->count; c++) {
    const double overlap = contacts->kept[NB_OVERLAP][c];
    const double next = nb_is_suppressed(contacts, c) ? 0 : nb_overlap(model, c);
    double history[NB_HISTORY];
    history_of(history, model, c);
    nb_sum_add(&model->terms[NB_TERM_CHANGED], -normal_energy(model, c, overlap, 0, history) / 2);
    nb_sum_add(&model->terms[NB_TERM_CHANGED], -normal_energy(model, c, next, next - overlap, history) / 2);
  }
}

/* Adds half of U_n with the laws after the change. Called twice: with the overlaps at t_N and with those at t_(N+1). */
static void add_new_normal_energy(struct nb_model *model) {
  for (size_t c = 0; c < model->contacts.count; c++) {
    double history[NB_HISTORY];
    history_of(history, model, c);
    nb_sum_add(&model->terms[NB_TERM_CHANGED],
               normal_energy(model, c, model->contacts.kept[NB_OVERLAP][c], 0, history) / 2);
  }
}

/* ds of contact c in the step to t_(N+1), m [CS79 15]. The pass does not compute it if the new law is `none`. */
static double tangential_increment(const struct nb_model *model, size_t c) {
  const struct nb_particles *particles = &model->particles;
  const int i = model->contacts.a[c], j = model->contacts.b[c];
  const bool wall = nb_with_wall(model, c);
  const struct nb_vec apart =
      wall ? vec_scale(-1, nb_wall_separation(&model->walls, j, particles->position[i])) : nb_contacts_branch(model, c);
  struct nb_vec other =
      wall ? nb_wall_velocity(&model->walls, j, vec_add(particles->position[i], apart)) : particles->velocity[j];
  if (model->cell)
    other = vec_add(other, tensor_times(model->cell->image_velocity, model->contacts.image[c]));
  const double along = vec_dot(vec_sub(particles->velocity[i], other), vec_clockwise(apart)) / vec_length(apart);
  return (along - particles->surface_speed[i] - (wall ? 0 : particles->surface_speed[j])) * model->previous_step;
}

/* U_s of all contacts, J; called before and after a change by the stage. A larger stiffness makes U_s smaller; U_s is 0
 * if the stage removes friction or changes the law. */
static double shear_energy(const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_sum sum = {0};
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
    if (!nb_touches(contacts, c) || !material_pair->shear || !material_pair->shear->stored)
      continue;
    const struct nb_pair values = nb_contact_constants(model, c, material_pair->values);
    double history[NB_HISTORY], buffer[NB_HISTORY];
    history_of(history, model, c);
    struct nb_normal n = model->laws.normal->normal(values, contacts->kept[NB_OVERLAP][c], 0, history);
    n.overlap = contacts->kept[NB_OVERLAP][c];
    nb_sum_add(&sum, material_pair->shear->stored(values, n, nb_history_read(&contacts->shear_history, c, buffer)));
  }
  return sum.sum + sum.rest;
}

/* Work F_s ds/2 of the shear forces of each material pair in the first half of the step. */
static void record_shear(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  b->pieces = model->laws.pieces;
  for (size_t p = 0; p < model->material_pair_count; p++)
    b->shear[p].law = model->material_pairs[p].shear, b->shear[p].work = 0;
  for (size_t c = 0; c < model->contacts.count && model->contacts.kept[NB_SHEAR_BEFORE]; c++)
    b->shear[model->contacts.material_pair[c]].work +=
        model->contacts.kept[NB_SHEAR_BEFORE][c] * tangential_increment(model, c) / 2;
}

/* The shear law of material pair p has ended. */
static bool law_ended(const struct nb_model *model, size_t p) {
  const struct nb_balance *b = model->balance;
  return b->shear[p].law && (b->shear[p].law != model->material_pairs[p].shear || b->pieces != model->laws.pieces);
}

/* Adds the work of the forces whose law has ended. The new law begins without a force. */
static void end_shear(struct nb_model *model) {
  const struct nb_balance *b = model->balance;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    if (!law_ended(model, p))
      continue;
    const bool stored = b->shear[p].law->stored;
    nb_sum_add(&model->terms[NB_TERM_SHEAR], b->shear[p].work);
    nb_sum_add(&model->terms[stored ? NB_TERM_CHANGED : NB_TERM_UNSTORED], (stored ? -1 : 1) * b->shear[p].work);
  }
  for (size_t c = 0; c < model->contacts.count && model->contacts.kept[NB_SHEAR_BEFORE]; c++)
    if (law_ended(model, (size_t)model->contacts.material_pair[c]))
      model->contacts.kept[NB_SHEAR_BEFORE][c] = 0;
}

void nb_balance_change(struct nb_model *model, bool before) {
  if (!model->terms)
    return;
  nb_sum_add(&model->terms[NB_TERM_CHANGED], before ? -shear_energy(model) : shear_energy(model));
  if (before)
    subtract_old_normal_energy(model), record_shear(model);
  else
    add_new_normal_energy(model), end_shear(model);
  model->balance->changed = !before;
}

/* ---- springs that appear loaded ---- */

/* Adds U_n/2 of contact c at an overlap, without a history. */
static void add_half_energy(struct nb_model *model, size_t c, double overlap) {
  nb_sum_add(&model->terms[NB_TERM_CHANGED], normal_energy(model, c, overlap, 0, (double[NB_HISTORY]){0}) / 2);
}

enum nb_status nb_balance_new_overlaps(struct nb_model *model, struct nb_error *error) {
  struct nb_balance *b = model->balance;
  const struct nb_contacts *contacts = &model->contacts;
  if (!model->terms)
    return NB_OK;
  free(b->overlaps);
  b->overlap_count = 0;
  b->overlaps = nb_array(contacts->count, sizeof *b->overlaps);
  if (!b->overlaps)
    return nb_error_memory(error);
  for (size_t c = 0; c < contacts->count; c++) {
    if (nb_touches(contacts, c) || nb_is_suppressed(contacts, c))
      continue;
    const double overlap = nb_overlap(model, c);
    if (!(overlap > 0))
      continue;
    add_half_energy(model, c, overlap);
    b->overlaps[b->overlap_count++] = (struct nb_new_overlap){contacts->a[c], contacts->b[c], nb_with_wall(model, c)};
  }
  return NB_OK;
}

/* Called after the forces of the step: adds the energies of the pairs that overlapped when they were listed. */
static void end_new_overlaps(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  for (size_t k = 0; k < b->overlap_count; k++) {
    const long c = nb_contacts_find(model, b->overlaps[k].a, b->overlaps[k].b, b->overlaps[k].wall);
    if (c >= 0)
      add_half_energy(model, (size_t)c, model->contacts.kept[NB_OVERLAP][c]);
  }
  b->overlap_count = 0;
}

void nb_balance_after_forces(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  if (!model->terms)
    return;
  if (model->contacts.kept[NB_SHEAR_BEFORE])
    for (size_t c = 0; c < model->contacts.count; c++)
      add_shear_work(model, c);
  if (b->changed)
    add_new_normal_energy(model);
  b->changed = false;
  if (b->overlap_count > 0)
    end_new_overlaps(model);
}

/* ---- velocities that jump ---- */

/* Kinetic energy that appears or vanishes without a force does not count as work: the residual of the work balance and
 * the terms of the energy balance keep their values. The caller adds the change of the energy to a term. */
void nb_balance_exclude(struct nb_model *model, bool before) {
  struct nb_balance *b = model->balance;
  const double sign = before ? -1 : 1;
  if (!b)
    return;
  b->initial_kinetic += sign * nb_energy_kinetic_half(model);
  if (model->terms)
    nb_balance_add_half(model, -sign);
}

/* The change of the kinetic energy counts as energy supplied from outside. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before) {
  nb_balance_exclude(model, before);
  if (model->terms)
    nb_sum_add(&model->terms[term], (before ? -1 : 1) * nb_energy_kinetic(model));
}
