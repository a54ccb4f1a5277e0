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
 * old force in the first half of the step.
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

/* Adds the work of the old law's force in the first half of the step, which the new law does not store. */
static void end_old_law(struct nb_model *model, double old_force, double ds) {
  const bool stored = model->balance->laws.shear->stored != NULL;
  nb_sum_add(&model->terms[NB_TERM_SHEAR], old_force * ds / 2);
  nb_sum_add(&model->terms[stored ? NB_TERM_CHANGED : NB_TERM_UNSTORED], (stored ? -old_force : old_force) * ds / 2);
}

static void add_shear_work(struct nb_model *model, size_t c) {
  const struct nb_law *law = model->material_pairs[model->contacts.material_pair[c]].shear;
  double old_force = nb_field_of(model, (long)c, NB_SHEAR_BEFORE),
         old_stiffness = nb_field_of(model, (long)c, NB_SHEAR_STIFFNESS_BEFORE);
  const double new_force = law ? nb_field_of(model, (long)c, NB_SHEAR) : 0,
               stiffness = law ? nb_field_of(model, (long)c, NB_SHEAR_STIFFNESS) : 0;
  model->contacts.kept[NB_SHEAR_BEFORE][c] = new_force, model->contacts.kept[NB_SHEAR_STIFFNESS_BEFORE][c] = stiffness;
  if (model->balance->shear_law_changed && law) {
    end_old_law(model, old_force, nb_field_of(model, (long)c, NB_TANGENTIAL_INCREMENT));
    old_force = old_stiffness = 0;
  }
  if (!law || (old_force == 0 && new_force == 0 && !law->dissipative))
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

/* U_n of a contact, J; the law may write into `history`. */
static double normal_energy(const struct nb_law *law, struct nb_pair values, double overlap, double history[]) {
  if (!(overlap > 0) || !law->stored)
    return 0;
  struct nb_normal n = law->normal(values, overlap, 0, history);
  n.overlap = overlap;
  return law->stored(values, n, history);
}

/* Copies the history of contact c's normal law. */
static void history_of(double history[], const struct nb_model *model, size_t c) {
  double buffer[NB_HISTORY];
  memcpy(history, nb_history_read(&model->contacts.normal_history, c, buffer), NB_HISTORY * sizeof *history);
}

static bool equal_properties(struct nb_pair a, struct nb_pair b) {
  bool all = true;
#define ROW(name, ...) all = all && a.name == b.name;
  NB_PAIR_ROWS(ROW)
#undef ROW
  return all;
}

/* Change of U_n of all contacts by the stage, at the current overlaps, J. */
static double normal_energy_change(const struct nb_model *model) {
  struct nb_sum sum = {0};
  for (size_t c = 0; c < model->contacts.count; c++) {
    const int p = model->contacts.material_pair[c];
    const struct nb_pair old = model->balance->values[p], new = model->material_pairs[p].values;
    const struct nb_law *before = model->balance->laws.normal, *after = model->laws.normal;
    if (before == after && equal_properties(old, new))
      continue;
    const double overlap = model->contacts.kept[NB_OVERLAP][c];
    double new_history[NB_HISTORY], old_history[NB_HISTORY];
    history_of(new_history, model, c), history_of(old_history, model, c);
    nb_sum_add(&sum, normal_energy(after, nb_contact_constants(model, c, new), overlap, new_history) -
                         normal_energy(before, nb_contact_constants(model, c, old), overlap, old_history));
  }
  return sum.sum + sum.rest;
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

void nb_balance_change(struct nb_model *model, bool before) {
  struct nb_balance *b = model->balance;
  if (!model->terms)
    return;
  nb_sum_add(&model->terms[NB_TERM_CHANGED], before ? -shear_energy(model) : shear_energy(model));
  if (before)
    for (size_t p = 0; p < model->material_pair_count; p++)
      b->values[p] = model->material_pairs[p].values;
  if (before)
    b->laws = model->laws;
  else
    nb_sum_add(&model->terms[NB_TERM_CHANGED], normal_energy_change(model) / 2);
  b->changed = !before;
  b->shear_law_changed = !before && (b->laws.shear != model->laws.shear || b->laws.pieces != model->laws.pieces);
}

/* ---- springs that appear loaded ---- */

/* U_n of contact c at an overlap, without history, J. */
static double normal_energy_at(const struct nb_model *model, size_t c, double overlap) {
  const struct nb_material_pair *material_pair = &model->material_pairs[model->contacts.material_pair[c]];
  double history[NB_HISTORY] = {0};
  return normal_energy(material_pair->normal, nb_contact_constants(model, c, material_pair->values), overlap, history);
}

enum nb_status nb_balance_new_overlaps(struct nb_model *model, struct nb_error *error) {
  struct nb_balance *b = model->balance;
  const struct nb_contacts *contacts = &model->contacts;
  if (!b || !model->terms)
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
    nb_sum_add(&model->terms[NB_TERM_CHANGED], normal_energy_at(model, c, overlap) / 2);
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
      nb_sum_add(&model->terms[NB_TERM_CHANGED],
                 normal_energy_at(model, (size_t)c, model->contacts.kept[NB_OVERLAP][c]) / 2);
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
    nb_sum_add(&model->terms[NB_TERM_CHANGED], normal_energy_change(model) / 2);
  b->changed = b->shear_law_changed = false;
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
