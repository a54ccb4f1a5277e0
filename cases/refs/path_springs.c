/* Reference: the exact contact along any path of a contact test, as independent springs side by side.
 *
 * A Hertz contact has the same N, T and energies as a row of independent springs under a parabolic indenter (method of
 * dimensionality reduction, Popov and Hess). The spring at the distance y from the middle, from -a to a, touches while
 * y^2 < R* alpha, and has
 *
 *   |u| <= mu kappa (alpha - y^2/R*)     Coulomb's law for this spring, kappa = E* / (4 G*); u is its deflection, m
 *   du = d(delta)                        while it sticks; u = 0 without contact
 *   T = Int 4 G* u dy                    the sum of their forces, N;  U = Int 2 G* u^2 dy  of their energies, J
 *
 * The state of the springs is the only history. A step in which alpha and delta change linearly is computed exactly:
 * u + d(delta) is limited once, at the end of the step, and a spring that begins to touch takes only the part of
 * d(delta) that follows the first touch. A spring dissipates its friction, which changes linearly too, times its slip.
 *
 * Returns, as curves versus step and at the end of each segment:
 *   overlap, slip, normal, shear, traction.force (equal to shear), stored.shear, dissipated, work.shear
 * Bisection finds the slip for a prescribed force. work.shear is the sum of stored.shear and dissipated: the work along
 * the path itself, not a sum over the rows of the table. Error: with n springs the error of T is of the order of
 * mu N/n^2, 1e-7 of mu N, and the relative error of stored.shear is as small. The error of dissipated is up to 1e-6 of
 * its peak.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum { SPRINGS = 3000 };

struct row {
  struct path_contact contact;
  double dy;                   /* m */
  double depth[SPRINGS];       /* y^2/R*, m: overlap at which a spring begins to touch */
  double u[SPRINGS];           /* m */
  double approach, slip, lost; /* m, m; energy dissipated so far, J */
};

/* Writes the deflections after a step to `approach` and `slip` to u, and the energy that the step dissipates to *lost.
 * Returns T. */
static double update_springs(const struct row *row, double u[], double approach, double slip, double *lost) {
  const double limit = row->contact.friction * row->contact.kappa, stiffness = 4 * row->contact.shear * row->dy;
  const double from = row->approach, ds = slip - row->slip;
  double sum = 0;
  *lost = 0;
  for (int i = 0; i < SPRINGS; i++) {
    const double depth = row->depth[i], l0 = limit * (from - depth), l1 = limit * (approach - depth);
    const double before = row->u[i]; /* u may be row->u */
    u[i] = 0;
    if (l0 <= 0 && l1 <= 0)
      continue;
    const double touches = l0 < 0 ? l1 / (l1 - l0) : l1 < 0 ? l0 / (l0 - l1) : 1;
    const double begin = l0 > 0 ? l0 : 0, end = l1 > 0 ? l1 : 0, moved = ds * touches;
    const double sticking = before + moved;
    u[i] = sticking > end ? end : sticking < -end ? -end : sticking;
    sum += u[i];
    if (u[i] != sticking) {
      /* The spring reaches its limit at the fraction t, where before + t moved = s (begin + t (end - begin)). */
      const double s = sticking > u[i] ? 1 : -1;
      const double t = (s * begin - before) / (moved - s * (end - begin));
      const double at_limit = begin + (t > 0 ? t : 0) * (end - begin);
      *lost += stiffness * (at_limit + end) / 2 * fabs(sticking - u[i]);
    }
  }
  *lost *= 2;
  return 2 * stiffness * sum;
}

static void advance(struct row *row, double approach, double slip, struct path_point *now) {
  double lost;
  now->shear = update_springs(row, row->u, approach, slip, &lost);
  now->approach = row->approach = approach, now->slip = row->slip = slip;
  now->normal = path_normal(&row->contact, approach);
  row->lost += lost;
}

/* The slip at which T is `shear`; NAN: there is none. */
static double slip_of_force(const struct row *row, double workspace[], double approach, double shear) {
  const double largest = 4 * row->contact.friction * row->contact.kappa * (approach + row->approach);
  double low = row->slip - largest, high = row->slip + largest, lost;
  if (update_springs(row, workspace, approach, low, &lost) > shear ||
      update_springs(row, workspace, approach, high, &lost) < shear)
    return NAN;
  for (int k = 0; k < 60; k++) {
    const double middle = low + (high - low) / 2;
    if (update_springs(row, workspace, approach, middle, &lost) < shear)
      low = middle;
    else
      high = middle;
  }
  return high;
}

static double stored(const struct row *row) {
  double sum = 0;
  for (int i = 0; i < SPRINGS; i++)
    sum += row->u[i] * row->u[i];
  return 4 * row->contact.shear * row->dy * sum; /* both halves of the row */
}

/* The largest overlap of the path; it determines the length of the row of springs. */
static double largest_overlap(const struct path_contact *contact, const struct nb_scene *scene) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  double largest = 0;
  while (path_next(&walk, now, &target)) {
    now.approach = target.normal_force ? path_overlap(contact, target.normal) : target.normal;
    now.normal = path_normal(contact, now.approach);
    largest = now.approach > largest ? now.approach : largest;
  }
  return largest;
}

enum { OVERLAP, SLIP, NORMAL, SHEAR, TRACTION, STORED, LOST, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"overlap",        "slip",         "normal",     "shear",
                                           "traction.force", "stored.shear", "dissipated", "work.shear"};

static void walk_path(struct row *row, double workspace[], const struct nb_scene *scene,
                      struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  for (size_t k = 1; path_next(&walk, now, &target); k++) {
    const double approach = target.normal_force ? path_overlap(&row->contact, target.normal) : target.normal;
    advance(row, approach, target.shear_force ? slip_of_force(row, workspace, approach, target.shear) : target.shear,
            &now);
    const double energy = stored(row);
    const double values[COLUMNS] = {
        approach > 0 ? approach : 0, now.slip, now.normal, now.shear, now.shear, energy, row->lost, energy + row->lost};
    for (int c = 0; c < COLUMNS; c++)
      columns[c]->values[k] = values[c];
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct path_contact contact = path_contact(scene);
  struct path_column *columns[COLUMNS];
  struct row *row = calloc(1, sizeof *row);
  double *workspace = calloc(SPRINGS, sizeof *workspace);
  bool made = row && workspace;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  if (made) {
    row->contact = contact;
    row->dy = sqrt(contact.radius * largest_overlap(&contact, scene)) / SPRINGS;
    for (int i = 0; i < SPRINGS; i++)
      row->depth[i] = (i + 0.5) * row->dy * (i + 0.5) * row->dy / contact.radius;
    walk_path(row, workspace, scene, columns);
  }
  for (int c = 0; c < COLUMNS; c++)
    if (made)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  free(row), free(workspace);
  return made ? solution_status(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_path_springs = {
    .name = "path_springs",
    .title = "any path of two elastic spheres: independent springs, each with its own friction",
    .source = "Popov and Hess",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "mindlin_deresiewicz",
    .solve = solve,
};
