/* What follows from a body's shape and density.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "nineball.h"
#include "vec.h"

double nb_body_mass(const struct nb_scene *scene, const struct nb_body *body) {
  double density = scene->materials[body->material].density, r = body->radius;
  return body->shape == NB_DISC ? NB_PI * r * r * density : 4.0 / 3.0 * NB_PI * r * r * r * density;
}

double nb_body_inertia(const struct nb_scene *scene, const struct nb_body *body) {
  double share = body->shape == NB_DISC ? 0.5 : 0.4; /* of m R^2 */
  return share * nb_body_mass(scene, body) * body->radius * body->radius;
}
