/* What follows from a body's shape and density.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

double nb_body_mass(const struct nb_scene *scene, const struct nb_body *body) {
  double density = scene->materials[body->material].density, r = body->radius;
  return body->shape == NB_DISC ? NB_PI * r * r * density : 4.0 / 3.0 * NB_PI * r * r * r * density;
}

double nb_body_inertia(const struct nb_scene *scene, const struct nb_body *body) {
  double share = body->shape == NB_DISC ? 0.5 : 0.4; /* of m R^2 */
  return share * nb_body_mass(scene, body) * body->radius * body->radius;
}

double nb_thickness(const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  double sum = 0, count = 0;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (nb_gone(model, i))
      continue;
    sum += model->scene->bodies[k].shape == NB_SPHERE ? 2 * bodies->rim[i].x : 1;
    count++;
  }
  return count > 0 ? sum / count : 1;
}
