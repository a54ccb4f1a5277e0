/* Reference: a straight row of equal discs between two walls, compressed by the force F.
 *
 * All contacts have the same overlap a, also those of the outer discs with the walls, and the same force F = k_n a. Let
 * a region of the volume V (m3; discs are 1 m thick) contain the row and end at the walls, whose distance is L. With
 * the unit vector u along the row, stress, fabric and mobilized friction angle phi are
 *
 *   sigma_ij = F L u_i u_j/V          Phi_ij = u_i u_j,  Phi_xxxx = u_x^4          sin phi = 1
 *
 * because only the forces F at the two ends of the region act on it. All normal forces are F and there is no shear, so
 * the part `fabric` is the whole stress, and `variation` and `shear` are zero. n discs have n - 1 contacts with each
 * other and two with walls.
 *
 * Returns, for A that monitors a box that contains the row up to the walls, at 0 cycles:
 *   A.stress.xx, xy, yy, mean, sinphi, angle; xx, xy, yy, mean, angle of A.stress.contacts and A.stress.fabric
 *   A.stress.fabric.fraction, variation.fraction, shear.fraction
 *   A.fabric.xx, xy, yy, anisotropy, fourth.xxxx; A.coordination, A.contacts; A.normal.mean
 * Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

static void add_value(struct nb_solution *solution, const char *region, const char *of, const char *what,
                      double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s%s at 0 cycles", region, of, what);
  solution_value(solution, value, name);
}

/* Whether the discs are equal and at equal distances along (ux, uy). */
static bool is_row(const struct nb_scene *scene, double ux, double uy, double spacing) {
  const struct nb_particle *first = &scene->particles[0];
  for (size_t k = 1; k < scene->particle_count; k++) {
    const struct nb_particle *disc = &scene->particles[k];
    const double s = (double)k * spacing;
    if (hypot(disc->x - first->x - s * ux, disc->y - first->y - s * uy) > 1e-12 * s || disc->radius != first->radius ||
        disc->material != first->material)
      return false;
  }
  return true;
}

static bool contains(const struct nb_region *box, double x, double y) {
  const double dx = x - box->x, dy = y - box->y;
  return fabs(dx * box->ex + dy * box->ey) < box->half_x * (1 + 1e-9) &&
         fabs(dy * box->ex - dx * box->ey) < box->half_y * (1 + 1e-9);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const size_t n = scene->particle_count;
  if (n < 2 || scene->wall_count != 2)
    return nb_error_set(error, NB_BAD_USE, "the reference `force_chain` is for a row of discs between two walls");
  const struct nb_particle *first = &scene->particles[0], *last = &scene->particles[n - 1];
  const double length = hypot(last->x - first->x, last->y - first->y), R = first->radius;
  const double ux = (last->x - first->x) / length, uy = (last->y - first->y) / length;
  const double overlap = 2 * R - length / (double)(n - 1);
  if (!is_row(scene, ux, uy, length / (double)(n - 1)))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `force_chain` is for equal discs at equal distances on a straight line");
  const double stiffness = matter_pair(scene, first->material, first->material).kn, force = stiffness * overlap;
  const double outer = R - overlap, between_walls = length + 2 * outer; /* L */
  double place[2]; /* of the walls along the row, from the first disc */
  bool fit = overlap > 0;
  for (int w = 0; w < 2; w++) {
    const struct nb_wall *wall = &scene->walls[w];
    const double dx = wall->x - first->x, dy = wall->y - first->y, s = -(dx * wall->ex + dy * wall->ey);
    place[w] = dx * ux + dy * uy;
    fit = fit && fabs(wall->ex * ux + wall->ey * uy) < 1e-12 && s > wall->h1 && s < wall->h2 &&
          matter_pair(scene, first->material, wall->material).kn == stiffness;
  }
  if (!fit || fabs(fmin(place[0], place[1]) + outer) > 1e-9 * overlap ||
      fabs(fmax(place[0], place[1]) - length - outer) > 1e-9 * overlap)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `force_chain` is for walls normal to the row, one at each end, that overlap its end discs as "
        "much as the discs overlap each other, and are as stiff");
  const double u[] = {ux * ux, ux * uy, uy * uy};
  for (size_t k = 0; k < scene->monitor_count; k++) {
    const struct nb_monitor *monitor = &scene->monitors[k];
    if (monitor->kind != NB_MONITOR_REGION || scene->regions[monitor->a].kind != NB_REGION_BOX)
      continue;
    const struct nb_region *region = &scene->regions[monitor->a];
    if (!contains(region, first->x - outer * ux, first->y - outer * uy) ||
        !contains(region, last->x + outer * ux, last->y + outer * uy))
      continue;
    const double s = force * between_walls / (4 * region->half_x * region->half_y);
    static const char *const stresses[] = {"stress.", "stress.contacts.", "stress.fabric."};
    for (int t = 0; t < 3; t++) {
      add_value(solution, monitor->name, stresses[t], "xx", s * u[0]);
      add_value(solution, monitor->name, stresses[t], "xy", s * u[1]);
      add_value(solution, monitor->name, stresses[t], "yy", s * u[2]);
      add_value(solution, monitor->name, stresses[t], "mean", s / 2);
      add_value(solution, monitor->name, stresses[t], "angle", atan(uy / ux));
    }
    add_value(solution, monitor->name, "stress.", "sinphi", 1);
    add_value(solution, monitor->name, "stress.", "fabric.fraction", 1);
    add_value(solution, monitor->name, "stress.", "variation.fraction", 0);
    add_value(solution, monitor->name, "stress.", "shear.fraction", 0);
    add_value(solution, monitor->name, "fabric.", "xx", u[0]);
    add_value(solution, monitor->name, "fabric.", "xy", u[1]);
    add_value(solution, monitor->name, "fabric.", "yy", u[2]);
    add_value(solution, monitor->name, "fabric.", "anisotropy", 1);
    add_value(solution, monitor->name, "fabric.", "fourth.xxxx", u[0] * u[0]);
    add_value(solution, monitor->name, "", "coordination", 2);
    add_value(solution, monitor->name, "", "contacts", (double)n + 1);
    add_value(solution, monitor->name, "normal.", "mean", force);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_force_chain = {
    .name = "force_chain",
    .title = "a straight row of discs compressed between two walls: stress F L/V, fabric of one direction",
    .source = "[R89 4.48]",
    .accepts = {HAS_DISCS},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
