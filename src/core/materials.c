/* Mass and moment of inertia of a particle, from its shape and density.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

double nb_particle_mass(const struct nb_scene *scene, const struct nb_particle *particle) {
  double density = scene->materials[particle->material].density, r = particle->radius;
  return particle->shape == NB_DISC ? NB_PI * r * r * density : 4.0 / 3.0 * NB_PI * r * r * r * density;
}

double nb_particle_inertia(const struct nb_scene *scene, const struct nb_particle *particle) {
  double fraction = particle->shape == NB_DISC ? 0.5 : 0.4; /* I/(m R^2) */
  return fraction * nb_particle_mass(scene, particle) * particle->radius * particle->radius;
}

double nb_thickness(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  double sum = 0, count = 0;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    if (nb_removed(model, i))
      continue;
    sum += model->scene->particles[k].shape == NB_SPHERE ? 2 * particles->radius[i] : 1;
    count++;
  }
  return count > 0 ? sum / count : 1;
}
