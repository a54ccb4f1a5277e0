/* Reference: stress, fabric and porosity of an infinite lattice, in closed form.
 *
 * Equal discs of radius R, 1 m thick, are at i a_1 + j a_2, with springs of the stiffness k_n. For each pair +-d of
 * lattice vectors with |d| < 2R a disc has a contact along d and one along -d, both with the force N = k_n (2R - |d|).
 * With n = d/|d|, the area A = |a_1 x a_2| of the cell, and <> for the mean over the contacts, the stress sigma, the
 * fabric Phi, the contact density F_kk and the porosity are:
 *
 *   sigma_ij = (1/A) sum over pairs +-d of N |d| n_i n_j             Phi_ij = <n_i n_j>,   Phi_ijkl = <n_i n_j n_k n_l>
 *   F_kk = z R/A                 coordination z = twice the pairs +-d   porosity = 1 - pi R^2/A (overlaps count twice)
 *
 * a_1 is the vector from particle 1 to particle 2, a_2 the vector from particle 1 to the nearest particle off this
 * line. The values hold for any box of whole cells, wherever the box begins and whichever discs its edge cuts.
 *
 * Returns, for B that monitors such a box, at 0 cycles:
 *   B.stress.xx, xy, yy, mean, sinphi; B.fabric.xx, xy, yy, kk; B.fabric.fourth.xxxx, xxyy, yyyy
 *   B.coordination, B.porosity
 * Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "reference.h"

static const double pi = 3.14159265358979323846;

struct lattice {
  double x1, y1, x2, y2; /* a_1 and a_2, in m */
  double area;           /* m2 */
};

static bool find_lattice(struct lattice *lattice, const struct nb_scene *scene) {
  const struct nb_particle *b = scene->particles;
  double nearest = INFINITY;
  if (scene->particle_count < 2)
    return false;
  *lattice = (struct lattice){.x1 = b[1].x - b[0].x, .y1 = b[1].y - b[0].y};
  const double length = hypot(lattice->x1, lattice->y1);
  for (size_t k = 2; k < scene->particle_count; k++) {
    const double x = b[k].x - b[0].x, y = b[k].y - b[0].y, area = lattice->x1 * y - lattice->y1 * x;
    if (fabs(area) > 1e-6 * length * length && hypot(x, y) < nearest)
      nearest = hypot(x, y), lattice->x2 = x, lattice->y2 = y, lattice->area = area;
  }
  if (!(nearest < INFINITY))
    return false;
  for (size_t k = 0; k < scene->particle_count; k++) { /* all must be equal and lie on the lattice */
    const double x = b[k].x - b[0].x, y = b[k].y - b[0].y;
    const double i = (x * lattice->y2 - y * lattice->x2) / lattice->area;
    const double j = (lattice->x1 * y - lattice->y1 * x) / lattice->area;
    if (fabs(i - round(i)) > 1e-9 || fabs(j - round(j)) > 1e-9 || b[k].radius != b[0].radius ||
        b[k].material != b[0].material)
      return false;
  }
  lattice->area = fabs(lattice->area);
  return true;
}

static void add_value(struct nb_solution *solution, const char *region, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s at 0 cycles", region, what);
  solution_value(solution, value, name);
}

static void add_region(struct nb_solution *solution, const char *name, const struct lattice *a, double radius,
                       double kn) {
  double sigma[3] = {0}, phi[3] = {0}, fourth[3] = {0}, z = 0;
  /* d = i a_1 + j a_2 has |i| = |d x a_2|/A and |j| = |d x a_1|/A; |d| < 2R */
  const int most_i = (int)(2 * radius * hypot(a->x2, a->y2) / a->area);
  const int most_j = (int)(2 * radius * hypot(a->x1, a->y1) / a->area);
  for (int i = -most_i; i <= most_i; i++)
    for (int j = -most_j; j <= most_j; j++) {
      const double x = i * a->x1 + j * a->x2, y = i * a->y1 + j * a->y2, d = hypot(x, y);
      if ((i == 0 && j == 0) || d >= 2 * radius)
        continue;
      const double nx = x / d, ny = y / d, force = kn * (2 * radius - d);
      const double half = force * d / (2 * a->area); /* +d and -d make one pair */
      sigma[0] += half * nx * nx, sigma[1] += half * nx * ny, sigma[2] += half * ny * ny;
      phi[0] += nx * nx, phi[1] += nx * ny, phi[2] += ny * ny;
      fourth[0] += nx * nx * nx * nx, fourth[1] += nx * nx * ny * ny, fourth[2] += ny * ny * ny * ny;
      z++;
    }
  const double mean = (sigma[0] + sigma[2]) / 2;
  add_value(solution, name, "stress.xx", sigma[0]);
  add_value(solution, name, "stress.xy", sigma[1]);
  add_value(solution, name, "stress.yy", sigma[2]);
  add_value(solution, name, "stress.mean", mean);
  add_value(solution, name, "stress.sinphi", hypot((sigma[0] - sigma[2]) / 2, sigma[1]) / mean);
  add_value(solution, name, "fabric.xx", phi[0] / z);
  add_value(solution, name, "fabric.xy", phi[1] / z);
  add_value(solution, name, "fabric.yy", phi[2] / z);
  add_value(solution, name, "fabric.fourth.xxxx", fourth[0] / z);
  add_value(solution, name, "fabric.fourth.xxyy", fourth[1] / z);
  add_value(solution, name, "fabric.fourth.yyyy", fourth[2] / z);
  add_value(solution, name, "fabric.kk", z * radius / a->area);
  add_value(solution, name, "coordination", z);
  add_value(solution, name, "porosity", 1 - pi * radius * radius / a->area);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  if (!find_lattice(&lattice, scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `lattice_stress` is for equal discs with linear springs in a lattice, without walls");
  const int m = scene->particles[0].material;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    if (scene->monitors[w].kind != NB_MONITOR_REGION)
      continue;
    const struct nb_region *region = &scene->regions[scene->monitors[w].a];
    /* the rows of the lattice are along x, and the box has whole spacings along a row and whole distances of rows */
    const double columns = 2 * region->half_x / lattice.x1, rows = 2 * region->half_y * lattice.x1 / lattice.area;
    if (region->kind != NB_REGION_BOX || lattice.y1 != 0 || fabs(columns - round(columns)) > 1e-9 ||
        fabs(rows - round(rows)) > 1e-9)
      return nb_error_set(error, NB_BAD_USE,
                          "the reference `lattice_stress` is for regions that are boxes of whole cells");
    add_region(solution, scene->monitors[w].name, &lattice, scene->particles[0].radius, matter_pair(scene, m, m).kn);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_lattice_stress = {
    .name = "lattice_stress",
    .title = "stress, fabric and porosity of an infinite lattice, in closed form",
    .source = "[R89 4.45-4.53]",
    .accepts = {HAS_DISCS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
