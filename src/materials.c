/* What follows from a scene's numbers: the contact of two materials, and the mass of a body.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "nineball.h"

static const double pi = 3.14159265358979323846;

/* Two springs in series, each half of the contact: 2ab/(a+b), which is k between like ones. A stiffness of 0 wins. */
static double series(double a, double b) { return a == b ? a : 2 * a * b / (a + b); }

struct nb_pair nb_scene_pair(const struct nb_scene *scene, int material_a, int material_b) {
  const struct nb_material *a = &scene->materials[material_a], *b = &scene->materials[material_b];
  struct nb_pair pair = {
      .kn = series(a->kn, b->kn),
      .ks = series(a->ks, b->ks),
      .friction = a->friction < b->friction ? a->friction : b->friction,
      .cohesion = a->cohesion < b->cohesion ? a->cohesion : b->cohesion,
  };
  for (size_t i = 0; i < scene->pair_rule_count; i++) {
    const struct nb_pair_rule *rule = &scene->pair_rules[i];
    bool same = rule->a == material_a && rule->b == material_b,
         swapped = rule->a == material_b && rule->b == material_a;
    if (!same && !swapped)
      continue;
    if (!isnan(rule->kn))
      pair.kn = rule->kn;
    if (!isnan(rule->ks))
      pair.ks = rule->ks;
    if (!isnan(rule->friction))
      pair.friction = rule->friction;
    if (!isnan(rule->cohesion))
      pair.cohesion = rule->cohesion;
  }
  return pair;
}

double nb_body_mass(const struct nb_scene *scene, const struct nb_body *body) {
  double density = scene->materials[body->material].density, r = body->radius;
  return body->shape == NB_DISC ? pi * r * r * density : 4.0 / 3.0 * pi * r * r * r * density;
}

double nb_body_inertia(const struct nb_scene *scene, const struct nb_body *body) {
  double share = body->shape == NB_DISC ? 0.5 : 0.4; /* of m R^2 */
  return share * nb_body_mass(scene, body) * body->radius * body->radius;
}
