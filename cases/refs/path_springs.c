/* Reference: the exact contact along any path of the bench, as springs side by side that know nothing of each other.
 *
 * A Hertz contact has the same N, T and energies as a row of springs that a parabola is pressed into (Popov and Hess's
 * reduction): the one at y, from -a to a, touches while y^2 < R* alpha, and has
 *
 *   |u| <= mu kappa (alpha - y^2/R*)     Coulomb's law for it alone, kappa = E* / 4 G*; u is its deflection, m
 *   du = d(delta)                        while it sticks; u = 0 while it does not touch
 *   T = Int 4 G* u dy                    the sum of their forces, N;  U = Int 2 G* u^2 dy  of their energies, J
 *
 * No ring, no front, no history is in it, only the state of each spring. A step in which alpha and delta go along straight lines
 * is exact: u + d(delta) clipped at the end, of a spring that begins to touch in the step its share of d(delta). What a spring
 * loses is its friction times the way that it slips, the friction going along a straight line too.
 *
 * Known at each step, as curves along `step`, and as values at the end of each leg:
 *   overlap, slip, normal, shear, which is traction.force too, stored.shear, dissipated, work.shear
 * The place where a force is reached is found by halving. work.shear is stored.shear and lost together: the work of the path
 * itself, not of its rows. Error: with n springs T is off by the order of mu N/n^2, 1e-7 of mu N; so are the energies.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "path.h"

enum { SPRINGS = 3000 };

struct row {
  struct path_contact contact;
  double dy;             /* m */
  double depth[SPRINGS]; /* y^2/R*, m: overlap at which it begins to touch */
  double u[SPRINGS];
  double approach, slip, lost;
};

/* The springs after a straight step, written to `u`; *lost what they lose in it. Answers T. */
static double press(const struct row *row, double u[], double approach, double slip, double *lost) {
  const double limit = row->contact.friction * row->contact.kappa, stiffness = 4 * row->contact.shear * row->dy;
  const double from = row->approach, way = slip - row->slip;
  double sum = 0;
  *lost = 0;
  for (int i = 0; i < SPRINGS; i++) {
    const double depth = row->depth[i], l0 = limit * (from - depth), l1 = limit * (approach - depth);
    const double before = row->u[i]; /* u may be row->u */
    u[i] = 0;
    if (l0 <= 0 && l1 <= 0)
      continue;
    const double touches = l0 < 0 ? l1 / (l1 - l0) : l1 < 0 ? l0 / (l0 - l1) : 1;
    const double begin = l0 > 0 ? l0 : 0, end = l1 > 0 ? l1 : 0, moved = way * touches;
    const double wants = before + moved;
    u[i] = wants > end ? end : wants < -end ? -end : wants;
    sum += u[i];
    if (u[i] != wants) {
      const double s = wants > u[i] ? 1 : -1; /* it meets the limit where u0 + t moved = s (begin + t (end - begin)) */
      const double t = (s * begin - before) / (moved - s * (end - begin));
      const double meets = begin + (t > 0 ? t : 0) * (end - begin);
      *lost += stiffness * (meets + end) / 2 * fabs(wants - u[i]);
    }
  }
  *lost *= 2;
  return 2 * stiffness * sum;
}

static void go(struct row *row, double approach, double slip, struct path_place *now) {
  double lost;
  now->shear = press(row, row->u, approach, slip, &lost);
  now->approach = row->approach = approach, now->slip = row->slip = slip;
  now->normal = path_normal(&row->contact, approach);
  row->lost += lost;
}

/* The slip at which T is the shear force aimed at; NAN: there is none. */
static double seek(const struct row *row, double room[], double approach, double shear) {
  const double far = 4 * row->contact.friction * row->contact.kappa * (approach + row->approach);
  double low = row->slip - far, high = row->slip + far, lost;
  if (press(row, room, approach, low, &lost) > shear || press(row, room, approach, high, &lost) < shear)
    return NAN;
  for (int k = 0; k < 60; k++) {
    const double middle = low + (high - low) / 2;
    if (press(row, room, approach, middle, &lost) < shear)
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
  return 4 * row->contact.shear * row->dy * sum; /* both sides, a half each */
}

/* The largest overlap of the path: where the row of springs ends. */
static double deepest(const struct path_contact *contact, const struct nb_scene *scene) {
  struct path_walk walk = path_walk(scene);
  struct path_place now = {0};
  struct path_aim aim;
  double most = 0;
  while (path_next(&walk, now, &aim)) {
    now.approach = aim.normal_force ? path_overlap(contact, aim.normal) : aim.normal;
    now.normal = path_normal(contact, now.approach);
    most = now.approach > most ? now.approach : most;
  }
  return most;
}

enum { OVERLAP, SLIP, NORMAL, SHEAR, TRACTION, STORED, LOST, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"overlap",        "slip",         "normal",     "shear",
                                           "traction.force", "stored.shear", "dissipated", "work.shear"};

static void walk_path(struct row *row, double room[], const struct nb_scene *scene, struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_place now = {0};
  struct path_aim aim;
  for (size_t k = 1; path_next(&walk, now, &aim); k++) {
    const double approach = aim.normal_force ? path_overlap(&row->contact, aim.normal) : aim.normal;
    go(row, approach, aim.shear_force ? seek(row, room, approach, aim.shear) : aim.shear, &now);
    const double energy = stored(row);
    const double values[COLUMNS] = {
        approach > 0 ? approach : 0, now.slip, now.normal, now.shear, now.shear, energy, row->lost, energy + row->lost};
    for (int c = 0; c < COLUMNS; c++)
      columns[c]->values[k] = values[c];
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct path_contact contact;
  struct path_column *columns[COLUMNS];
  if (path_contact(&contact, scene, "path_springs", error))
    return error->status;
  struct row *row = calloc(1, sizeof *row);
  double *room = calloc(SPRINGS, sizeof *room);
  bool made = row && room;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  if (made) {
    row->contact = contact;
    row->dy = sqrt(contact.radius * deepest(&contact, scene)) / SPRINGS;
    for (int i = 0; i < SPRINGS; i++)
      row->depth[i] = (i + 0.5) * row->dy * (i + 0.5) * row->dy / contact.radius;
    walk_path(row, room, scene, columns);
  }
  for (int c = 0; c < COLUMNS; c++)
    if (made)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  free(row), free(room);
  return made ? solution_full(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_path_springs = {
    .name = "path_springs",
    .title = "any path of two elastic spheres: springs side by side, each with its own friction",
    .source = "Popov and Hess",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "mindlin_deresiewicz",
    .solve = solve,
};
