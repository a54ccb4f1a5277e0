/* Energy and momentum of particles and contacts at t_N.
 *
 *   K = sum (m v^2 + I w^2)/2                   v, m/s, and w, rad/s, at t_N, the mean of the two half steps [CS79 31]
 *   U = sum (U_n + U_s)                         the laws' state functions, J: F_n^2/2k_n and F_s^2/2k_s for springs
 *   p = sum m v,   L = sum (m (x cross v) + I w)      about the origin
 *
 * The velocities exclude the imposed motion (affine.c). The sums of K, p and L run over free particles, in the order of
 * their numbers; the sum of U runs over contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "energy.h"

static double kinetic_of(const struct nb_particles *particles, size_t i, struct nb_velocities v) {
  return (particles->mass[i] * vec_dot(v.velocity, v.velocity) + particles->inertia[i] * (v.spin * v.spin)) / 2;
}

/* Loops over the free particles in the order of their numbers: for (size_t k = 0, i; next_free(particles, &k, &i);)
 * sets i to the slot of each. */
static bool next_free(const struct nb_particles *particles, size_t *k, size_t *slot) {
  while (*k < particles->count) {
    *slot = (size_t)particles->slot[(*k)++];
    if (particles->inverse_mass[*slot] > 0)
      return true;
  }
  return false;
}

static double kinetic(const struct nb_model *model,
                      struct nb_velocities (*velocity)(const struct nb_model *model, size_t slot)) {
  const struct nb_particles *particles = &model->particles;
  double sum = 0;
  for (size_t k = 0, i; next_free(particles, &k, &i);)
    sum += kinetic_of(particles, i, velocity(model, i));
  return sum;
}

double nb_energy_kinetic(const struct nb_model *model) { return kinetic(model, nb_velocity_now); }
double nb_energy_kinetic_half(const struct nb_model *model) { return kinetic(model, nb_velocity_half); }

double nb_energy_kinetic_of(const struct nb_model *model, size_t slot) {
  return model->particles.inverse_mass[slot] > 0 ? kinetic_of(&model->particles, slot, nb_velocity_now(model, slot))
                                                 : 0;
}

/* Adds the energy stored in contact c. */
static void add_stored(double *sum, const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  if (!nb_touches(contacts, c))
    return;
  const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
  const struct nb_normal n = {.force = contacts->kept[NB_NORMAL][c],
                              .stiffness = contacts->kept[NB_STIFFNESS][c],
                              .radius = contacts->kept[NB_RADIUS][c],
                              .overlap = contacts->kept[NB_OVERLAP][c]};
  const struct nb_pair values = nb_contact_constants(model, c, material_pair->values);
  double buffer[NB_HISTORY];
  if (material_pair->normal->stored)
    *sum += material_pair->normal->stored(values, n, nb_history_read(&contacts->normal_history, c, buffer));
  if (material_pair->shear && material_pair->shear->stored)
    *sum += material_pair->shear->stored(values, n, nb_history_read(&contacts->shear_history, c, buffer));
}

double nb_energy_stored(const struct nb_model *model) {
  double sum = 0;
  for (size_t c = 0; c < model->contacts.count; c++)
    add_stored(&sum, model, c);
  return sum;
}

double nb_energy_of_contact(const struct nb_model *model, size_t c) {
  double sum = 0;
  add_stored(&sum, model, c);
  return sum;
}

double nb_energy_of_particle(const struct nb_model *model, size_t slot) {
  const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, slot);
  double sum = nb_energy_kinetic_of(model, slot);
  for (const int *c = range.first; c < range.end; c++)
    add_stored(&sum, model, (size_t)*c);
  return sum;
}

struct nb_vec nb_momentum(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  struct nb_vec sum = vec(0, 0);
  for (size_t k = 0, i; next_free(particles, &k, &i);)
    sum = vec_add(sum, vec_scale(particles->mass[i], nb_velocity_now(model, i).velocity));
  return sum;
}

double nb_momentum_angular(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  double sum = 0;
  for (size_t k = 0, i; next_free(particles, &k, &i);) {
    const struct nb_velocities v = nb_velocity_now(model, i);
    const struct nb_vec x = particles->position[i];
    sum += particles->mass[i] * (x.x * v.velocity.y - x.y * v.velocity.x) + particles->inertia[i] * v.spin;
  }
  return sum;
}

double nb_unbalanced_max(const struct nb_model *model) {
  double sum = 0, contact = 0;
  for (size_t i = 0; i < model->particles.count; i++) {
    const double size = model->particles.inverse_mass[i] > 0 ? vec_length(nb_unbalanced_force(model, i)) : 0;
    sum = size > sum ? size : sum;
  }
  for (size_t c = 0; c < model->contacts.count; c++) {
    const double size = vec_length(nb_contact_force(&model->contacts, c));
    contact = size > contact ? size : contact;
  }
  return sum > 0 ? sum / contact : 0; /* infinite if forces act but all contact forces are 0 */
}
