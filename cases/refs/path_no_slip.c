/* Reference: the simplified laws along a path of the bench, in the limit of small steps: as equations, not as increments. Of the
 * exact law it asks path_springs.c.
 *
 *   linear          dT = k_s d(delta)
 *   mindlin         dT = 8 G* a d(delta)                                                                       [R89 3.27]
 *   mindlin_scaled  the same while a grows;  d(T/a) = 8 G* d(delta)  while a falls
 *
 * with a^2 = R* alpha, and alpha and delta along a straight line in each step, so that Int a d(delta) is
 * (2/3) R*^(1/2) (alpha_1^(3/2) - alpha_0^(3/2)) d(delta)/d(alpha). None of them may come to Coulomb's limit: the path is refused.
 *
 * Known at each step and at the end of each leg: slip, shear, work.shear. Work by Simpson's rule over the step, exact where only
 * one of alpha and delta moves.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

extern const struct nb_reference reference_path_springs;

struct contact {
  struct path_contact elastic;
  double ks;
  bool linear, scaled;
};

/* T after the share `share` of a step from a place to another. */
static double force(const struct contact *contact, struct path_place from, double approach, double slip,
                    double fraction) {
  const double way = fraction * (slip - from.slip), alpha = from.approach + fraction * (approach - from.approach);
  const double stiffness = 8 * contact->elastic.shear * sqrt(contact->elastic.radius), dn = alpha - from.approach;
  if (contact->linear)
    return from.shear + contact->ks * way;
  if (contact->scaled && dn < 0)
    return sqrt(alpha) * (from.shear / sqrt(from.approach) + stiffness * way);
  const double mean = fabs(dn) > 1e-9 * alpha ? 2. / 3 * (pow(alpha, 1.5) - pow(from.approach, 1.5)) / dn : sqrt(alpha);
  return from.shear + stiffness * mean * way;
}

static double work(const struct contact *contact, struct path_place from, double approach, double slip) {
  enum { HALVES = 32 };
  double sum = 0;
  for (int k = 0; k <= HALVES; k++)
    sum += (k == 0 || k == HALVES ? 1 : k % 2 ? 4 : 2) * force(contact, from, approach, slip, (double)k / HALVES);
  return sum / (3. * HALVES) * (slip - from.slip);
}

/* All three make T a straight line in slip, for a given approach. */
static double seek(const struct contact *contact, struct path_place from, double approach, double shear) {
  const double none = force(contact, from, approach, from.slip, 1),
               one = force(contact, from, approach, from.slip + 1, 1);
  return from.slip + (shear - none) / (one - none);
}

enum { SLIP, SHEAR, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "work.shear"};

static bool walk_path(const struct contact *contact, const struct nb_scene *scene, struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_place now = {0};
  struct path_aim aim;
  double done = 0;
  for (size_t k = 1; path_next(&walk, now, &aim); k++) {
    const double approach = aim.normal_force ? path_overlap(&contact->elastic, aim.normal) : aim.normal;
    const double slip = aim.shear_force ? seek(contact, now, approach, aim.shear) : aim.shear;
    const double shear = approach > 0 ? force(contact, now, approach, slip, 1) : 0;
    done += work(contact, now, approach, slip);
    now = (struct path_place){approach, slip, path_normal(&contact->elastic, approach), shear};
    if (fabs(shear) > contact->elastic.friction * now.normal)
      return false;
    columns[SLIP]->values[k] = slip, columns[SHEAR]->values[k] = shear, columns[WORK]->values[k] = done;
  }
  return true;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct contact contact = {.linear = strcmp(scene->shear, "linear") == 0,
                            .scaled = strcmp(scene->shear, "mindlin_scaled") == 0};
  struct path_column *columns[COLUMNS];
  if (strcmp(scene->shear, "mindlin_deresiewicz") == 0)
    return reference_path_springs.solve(solution, scene, error);
  if (path_contact(&contact.elastic, scene, "path_no_slip", error))
    return error->status;
  if (!contact.linear && !contact.scaled && strcmp(scene->shear, "mindlin") != 0)
    return nb_error_set(error, NB_BAD_USE, "path_no_slip knows no equation of `shear %s`", scene->shear);
  const struct nb_particle *particles = scene->particles;
  contact.ks = matter_pair(scene, particles[0].material,
                           scene->particle_count == 1 ? scene->walls[0].material : particles[1].material)
                   .ks;
  bool made = true;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  const bool sticks = made && walk_path(&contact, scene, columns);
  for (int c = 0; c < COLUMNS; c++)
    if (sticks)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  if (made && !sticks)
    return nb_error_set(error, NB_BAD_USE, "path_no_slip wants a path on which nothing slides");
  return made ? solution_full(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_path_no_slip = {
    .name = "path_no_slip",
    .title = "simplified shear laws along a path as equations, and the exact one by springs",
    .source = "[R89 3.27]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "linear mindlin mindlin_scaled mindlin_deresiewicz",
    .solve = solve,
};
