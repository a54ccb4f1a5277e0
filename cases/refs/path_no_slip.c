/* Reference: the simplified laws along the path of a contact test in the limit of small steps: differential equations
 * instead of increments. For the exact law it calls path_springs.c.
 *
 *   linear          dT = k_s d(delta)
 *   mindlin         dT = 8 G* a d(delta)                                                                     [R89 3.27]
 *   mindlin_scaled  as mindlin while a increases;  d(T/a) = 8 G* d(delta)  while a decreases
 *
 * with a^2 = R* alpha. alpha and delta are linear in each step, so that from alpha_0 to alpha_1
 *
 *   Int a d(delta) = (2/3) R*^(1/2) (alpha_1^(3/2) - alpha_0^(3/2)) d(delta)/d(alpha)
 *
 * Returns slip (delta), shear (T) and work.shear at each step and at the end of each segment; for the exact law, what
 * path_springs.c returns. Simpson's rule integrates the work over the step; this is exact where only one of alpha and
 * delta changes. With a simplified law, refuses paths on which the shear force exceeds Coulomb's limit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

extern const struct nb_reference reference_path_springs;

struct contact {
  struct path_contact elastic;
  double ks; /* N/m */
  bool linear, scaled;
};

/* T after a fraction of the step that leads from the point `from` to `approach` and `slip`; 0 without contact. */
static double force(const struct contact *contact, struct path_point from, double approach, double slip,
                    double fraction) {
  const double ds = fraction * (slip - from.slip), alpha = from.approach + fraction * (approach - from.approach);
  const double stiffness = 8 * contact->elastic.shear * sqrt(contact->elastic.radius), dn = alpha - from.approach;
  if (!(alpha > 0))
    return 0;
  if (contact->linear)
    return from.shear + contact->ks * ds;
  if (contact->scaled && dn < 0)
    return sqrt(alpha) * (from.shear / sqrt(from.approach) + stiffness * ds);
  const double before = pow(fmax(from.approach, 0), 1.5);
  const double mean = fabs(dn) > 1e-9 * alpha ? 2. / 3 * (pow(alpha, 1.5) - before) / dn : sqrt(alpha);
  return from.shear + stiffness * mean * ds;
}

static double work(const struct contact *contact, struct path_point from, double approach, double slip) {
  enum { HALVES = 32 };
  double sum = 0;
  for (int k = 0; k <= HALVES; k++)
    sum += (k == 0 || k == HALVES ? 1 : k % 2 ? 4 : 2) * force(contact, from, approach, slip, (double)k / HALVES);
  return sum / (3. * HALVES) * (slip - from.slip);
}

/* The slip at which T is `shear`, by interpolation: T is linear in slip for all three laws. */
static double slip_of_force(const struct contact *contact, struct path_point from, double approach, double shear) {
  const double none = force(contact, from, approach, from.slip, 1),
               one = force(contact, from, approach, from.slip + 1, 1);
  return from.slip + (shear - none) / (one - none);
}

enum { SLIP, SHEAR, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"slip", "shear", "work.shear"};

static bool walk_path(const struct contact *contact, const struct nb_scene *scene, struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  double done = 0;
  for (size_t k = 1; path_next(&walk, now, &target); k++) {
    const double approach = target.normal_force ? path_overlap(&contact->elastic, target.normal) : target.normal;
    const double slip = target.shear_force ? slip_of_force(contact, now, approach, target.shear) : target.shear;
    const double shear = force(contact, now, approach, slip, 1);
    done += work(contact, now, approach, slip);
    now = (struct path_point){approach, slip, path_normal(&contact->elastic, approach), shear};
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
  contact.elastic = path_contact(scene);
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
    return nb_error_set(error, NB_BAD_USE, "the reference `path_no_slip` is for a path without sliding");
  return made ? solution_status(solution, error) : nb_error_memory(error);
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
