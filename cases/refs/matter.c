/* Mass, moment of inertia, and the constants of a contact, from the numbers of the page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "matter.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

double matter_mass(const struct nb_scene *scene, const struct nb_particle *particle) {
  const double section = pi * pow(particle->radius, 2);                              /* m2 */
  const double length = particle->shape == NB_SPHERE ? particle->radius * 4 / 3 : 1; /* m: volume over section */
  return scene->materials[particle->material].density * section * length;
}

double matter_inertia(const struct nb_scene *scene, const struct nb_particle *particle) {
  const double gyration = particle->radius * sqrt(particle->shape == NB_SPHERE ? 2. / 5 : 1. / 2); /* m */
  return matter_mass(scene, particle) * gyration * gyration;
}

double matter_radius(double a, double b) { return 1 / (1 / a + 1 / b); }

static double series(double a, double b) { return 1 / (1 / (2 * a) + 1 / (2 * b)); }

struct matter_pair matter_pair(const struct nb_scene *scene, int material_a, int material_b) {
  const struct nb_material *a = &scene->materials[material_a], *b = &scene->materials[material_b];
  const double shear_a = a->young / 2 / (1 + a->poisson), shear_b = b->young / 2 / (1 + b->poisson);
  struct matter_pair pair = {.kn = series(a->kn, b->kn),
                             .ks = series(a->ks, b->ks),
                             .friction = fmin(a->friction, b->friction),
                             .cohesion = fmin(a->cohesion, b->cohesion),
                             .young = 1 / ((1 - pow(a->poisson, 2)) / a->young + (1 - pow(b->poisson, 2)) / b->young),
                             .shear = 1 / ((2 - a->poisson) / shear_a + (2 - b->poisson) / shear_b)};
  for (size_t i = 0; i < scene->pair_rule_count; i++) {
    const struct nb_pair_rule *rule = &scene->pair_rules[i];
    if ((rule->a != material_a || rule->b != material_b) && (rule->a != material_b || rule->b != material_a))
      continue;
    pair.kn = isnan(rule->kn) ? pair.kn : rule->kn, pair.ks = isnan(rule->ks) ? pair.ks : rule->ks;
    pair.friction = isnan(rule->friction) ? pair.friction : rule->friction;
    pair.cohesion = isnan(rule->cohesion) ? pair.cohesion : rule->cohesion;
  }
  return pair;
}
