/* The terms of the energy balance that belong to steps and stages: what slides, springs that are changed under load or are there all at
 * once, and velocities that jump.
 *
 *   shear       (F_s' + F_s)/2 ds                             from t_N to t_(N+1), primes at its end
 *   frictional  (F_s' + F_s)/2 (ds - (F_s' - F_s)/k_s)        where it slides: slip less what the spring took of it;
 *               what the law says that it lost                of a law that knows micro-slip
 *   sliding     the same of steps at whose end the contact slides as a whole
 *
 * A contact whose outlines part loses what its spring still held: F_s' = 0, and it slides by that as well. Without
 * sliding the bracket is 0 but for rounding, and nothing is added.
 *
 * When a stage changes k_n or k_s, springs under load gain U_n(new) - U_n(old) at the same overlap and
 * U_s(new) - U_s(old) at the same force. The force of the step is the mean of an old and a new one, so the normal gain
 * is the mean of those at the two ends; the shear spring is new for the whole step. Another law is the same: U_n by the new one less
 * U_n by the old one. Another shear law begins with nothing: U_s is gone at t_N, and so is F_s ds/2, which the old force still does.
 *
 * Two bodies of a boundary that lets go of them may overlap although they were on no list. At t_N they have overlapped by alpha without a
 * force; at t_(N+1) they push with F_n(alpha'). The force of the step is the mean of none and that, so what is put in from outside is
 * the mean of what the spring would have held at the two ends:
 *
 *   energy.changed += (U_n(alpha) + U_n(alpha'))/2
 *
 * Their shear springs begin with nothing, and what they hold is work from the first step on.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "balance.h"

static double field(const struct nb_model *model, enum nb_field which, size_t c) {
  return model->contacts.kept[which] ? model->contacts.kept[which][c] : 0;
}

/* Half of the step goes against the force of the old law, which nothing holds any more. */
static void end_old_law(struct nb_model *model, double old_force, double ds) {
  const bool stored = model->balance->laws.shear->stored != NULL;
  nb_sum_add(&model->terms[NB_TERM_SHEAR], old_force * ds / 2);
  nb_sum_add(&model->terms[stored ? NB_TERM_CHANGED : NB_TERM_UNSTORED], (stored ? -old_force : old_force) * ds / 2);
}

static void add_shear_work(struct nb_model *model, size_t c) {
  const struct nb_law *law = model->material_pairs[model->contacts.material_pair[c]].shear;
  double old_force = field(model, NB_SHEAR_BEFORE, c), old_stiffness = field(model, NB_SHEAR_STIFFNESS_BEFORE, c);
  const double new_force = law ? field(model, NB_SHEAR, c) : 0,
               stiffness = law ? field(model, NB_SHEAR_STIFFNESS, c) : 0;
  model->contacts.kept[NB_SHEAR_BEFORE][c] = new_force, model->contacts.kept[NB_SHEAR_STIFFNESS_BEFORE][c] = stiffness;
  if (model->balance->shear_law_changed && law) {
    end_old_law(model, old_force, field(model, NB_TANGENTIAL_INCREMENT, c));
    old_force = old_stiffness = 0;
  }
  if (!law || (old_force == 0 && new_force == 0 && !law->dissipative))
    return;
  const double ds = field(model, NB_TANGENTIAL_INCREMENT, c), mean = (old_force + new_force) / 2;
  const bool sliding = field(model, NB_SLIDING, c) > 0;
  double dissipated = 0;
  nb_sum_add(&model->terms[NB_TERM_SHEAR], mean * ds);
  if (!law->stored)
    nb_sum_add(&model->terms[NB_TERM_UNSTORED], mean * ds);
  else if (law->dissipative)
    dissipated = field(model, NB_DISSIPATED, c);
  else if (!(stiffness > 0)) /* parted */
    dissipated = mean * (ds + old_force / old_stiffness);
  else if (sliding)
    dissipated = mean * (ds - (new_force - old_force) / stiffness);
  nb_sum_add(&model->terms[NB_TERM_FRICTIONAL], dissipated);
  if (sliding)
    nb_sum_add(&model->terms[NB_TERM_SLIDING], dissipated);
}

/* U_n of a contact by a law that is given `values` and remembers `memory`, which a law may write into. */
static double normal_energy(const struct nb_law *law, struct nb_pair values, double overlap, double history[]) {
  if (!(overlap > 0) || !law->stored)
    return 0;
  struct nb_normal n = law->normal(values, overlap, 0, history);
  n.overlap = overlap;
  return law->stored(values, n, history);
}

/* What contact c remembers for its normal law, copied. */
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

/* What the springs of overlaps have gained by the change, at the overlaps that contacts have now. */
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

/* What the shear springs hold: less when their stiffness rises, and nothing when a stage takes friction away or another law comes. */
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

/* ---- springs that are there all at once ---- */

/* U_n of contact c at an overlap, of a law that remembers nothing yet. */
static double normal_energy_at(const struct nb_model *model, size_t c, double overlap) {
  const struct nb_material_pair *material_pair = &model->material_pairs[model->contacts.material_pair[c]];
  double history[NB_HISTORY] = {0};
  return normal_energy(material_pair->normal, nb_contact_constants(model, c, material_pair->values), overlap, history);
}

static double overlap_of(const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_surface *surface = model->particles.surface;
  return surface[contacts->a[c]].radius + surface[contacts->b[c]].radius - vec_length(nb_contacts_branch(model, c));
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
    if (model->material_pairs[contacts->material_pair[c]].wall || nb_touches(contacts, c))
      continue;
    const double overlap = overlap_of(model, c);
    if (!(overlap > 0))
      continue;
    nb_sum_add(&model->terms[NB_TERM_CHANGED], normal_energy_at(model, c, overlap) / 2);
    b->overlaps[b->overlap_count++] = (struct nb_new_overlap){contacts->a[c], contacts->b[c]};
  }
  return NB_OK;
}

/* After the forces of the step. */
static void end_new_overlaps(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  for (size_t k = 0; k < b->overlap_count; k++) {
    const long c = nb_contacts_find(model, b->overlaps[k].a, b->overlaps[k].b, false);
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

/* ---- what makes velocities jump ---- */

/* Kinetic energy that is there or gone without a force does not count as work; what was read before is read after. */
void nb_balance_exclude(struct nb_model *model, bool before) {
  struct nb_balance *b = model->balance;
  const double sign = before ? -1 : 1;
  if (!b)
    return;
  b->initial_kinetic += sign * nb_energy_kinetic_half(model);
  if (!model->terms)
    return;
  struct nb_sum first_half[NB_TERMS] = {{0}};
  nb_balance_add_half_kick(first_half, model);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&model->terms[t], -sign * first_half[t].sum);
}

/* It is put in from outside. */
void nb_balance_jump(struct nb_model *model, enum nb_term term, bool before) {
  nb_balance_exclude(model, before);
  if (model->terms)
    nb_sum_add(&model->terms[term], (before ? -1 : 1) * nb_energy_kinetic(model));
}
