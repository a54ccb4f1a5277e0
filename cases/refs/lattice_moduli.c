/* Reference: a square or hexagonal lattice of equal particles in a periodic cell under small strains.
 *
 * Every particle is a centre of symmetry, so a uniform strain e moves all particles affinely and without rotation. The
 * contacts of one particle then give stress and moduli exactly for small strains (Born). t is the thickness, 1 m for
 * discs and 2 R for spheres, and s the spacing. Every contact has the overlap alpha, the normal force F and the
 * stiffnesses k_n = dF/d(alpha) and k_s:
 *
 *   square      sigma = F/(s t),     C_11 = k_n/t,               C_12 = 0,                2 G = k_s/t
 *   hexagonal   sigma = 4 b F/(s t), C_11 = b (3 k_n + k_s)/t, C_12 = b (k_n - k_s)/t, 2 G = C_11 - C_12, b = 3^(1/2)/4
 *
 * The hexagonal lattice has the bulk modulus 3^(1/2)/2 k_n/t in the plane and is isotropic. Stress is positive in
 * compression, strain in extension: sigma_xx decreases by C_11 e_xx + C_12 e_yy, sigma_xy by 2 G e_xy. Linear springs
 * have F = k_n alpha. Elastic spheres without shear have F = 4/3 E* R*^(1/2) alpha^(3/2), R* = R/2, k_n =
 * 2 E* (R* alpha)^(1/2), so all moduli are proportional to sigma^(1/3). An isotropic strain may have any size, because
 * its stress follows from F at the new spacing.
 *
 * Returns, at the end of each stage and of the run:   cell.stress.xx, .yy, .xy, .yx, .mean
 * Error: relative, of the order of the strain and of alpha/s, because the spacing changes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "reference.h"

struct lattice {
  bool hexagonal, hertz;
  double radius, spacing, thickness; /* m */
  struct matter_pair pair;
  double xx, yy, xy; /* stress, Pa */
};

static double overlap(const struct lattice *it) { return 2 * it->radius - it->spacing; }
static double stiffness(const struct lattice *it) {
  return it->hertz ? 2 * it->pair.young * sqrt(it->radius / 2 * overlap(it)) : it->pair.kn;
}
static double pressure(const struct lattice *it) {
  const double force = (it->hertz ? 2. / 3 : 1) * stiffness(it) * overlap(it);
  return (it->hexagonal ? sqrt(3) : 1) * force / (it->spacing * it->thickness);
}

static void strain(struct lattice *it, double exx, double eyy, double exy) {
  const double kn = stiffness(it) / it->thickness, ks = (it->pair.friction > 0 ? it->pair.ks : 0) / it->thickness;
  const double q = sqrt(3) / 4;
  const double c11 = it->hexagonal ? q * (3 * kn + ks) : kn, c12 = it->hexagonal ? q * (kn - ks) : 0;
  it->xy -= (it->hexagonal ? c11 - c12 : ks) * exy;
  if (exx == eyy) {
    const double before = pressure(it);
    it->spacing *= 1 + exx;
    it->xx += pressure(it) - before, it->yy += pressure(it) - before;
    return;
  }
  it->xx -= c11 * exx + c12 * eyy;
  it->yy -= c12 * exx + c11 * eyy;
}

static void add_value(struct nb_solution *solution, const struct lattice *it, const char *stage) {
  const struct {
    const char *name;
    double value;
  } all[] = {{"xx", it->xx}, {"yy", it->yy}, {"xy", it->xy}, {"yx", it->xy}, {"mean", (it->xx + it->yy) / 2}};
  for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "cell.stress.%s%s%s", all[k].name, stage ? " in " : "", stage ? stage : "");
    solution_value(solution, all[k].value, name);
  }
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `lattice_moduli` is for %s", what);
}

/* The number of particles that touch particle 1; of each particle the nearest periodic copy counts. *spacing: the
 * distance to the nearest particle. */
static int neighbours(const struct nb_scene *scene, double *spacing) {
  int count = 0;
  *spacing = INFINITY;
  for (size_t j = 1; j < scene->particle_count; j++) {
    double x = scene->particles[j].x - scene->particles[0].x, y = scene->particles[j].y - scene->particles[0].y;
    x -= scene->cell.h[0] * round(x / scene->cell.h[0]), y -= scene->cell.h[3] * round(y / scene->cell.h[3]);
    const double distance = hypot(x, y);
    count += distance < 2 * scene->particles[0].radius * (1 + 1e-9); /* also those that just touch */
    *spacing = fmin(*spacing, distance);
  }
  return count;
}

static enum nb_status read_lattice(struct lattice *it, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *first = &scene->particles[0];
  *it = (struct lattice){.radius = first->radius, .hertz = strcmp(scene->normal, "hertz") == 0};
  it->thickness = first->shape == NB_SPHERE ? 2 * first->radius : 1;
  it->pair = matter_pair(scene, first->material, first->material);
  for (size_t k = 0; k < scene->particle_count; k++)
    if (scene->particles[k].radius != first->radius || scene->particles[k].material != first->material ||
        scene->particles[k].shape != first->shape)
      return refuse(error, "equal particles");
  if (strcmp(scene->shear, it->hertz ? "none" : "linear") != 0)
    return refuse(error, "linear springs, or elastic spheres without shear");
  const int count = neighbours(scene, &it->spacing);
  if (count != 4 && count != 6)
    return refuse(error, "a lattice in which every particle touches four or six others");
  it->hexagonal = count == 6;
  const double cell = it->hexagonal ? sqrt(0.75) : 1;
  const double area = (double)scene->particle_count * cell * it->spacing * it->spacing;
  if (fabs(scene->cell.h[0] * scene->cell.h[3] / area - 1) > 1e-9)
    return refuse(error, "a lattice that fills the cell");
  it->xx = it->yy = pressure(it);
  return NB_OK;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  if (read_lattice(&lattice, scene, error))
    return error->status;
  struct nb_strain_rate rate = {0};
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    rate = stage->cell_line ? stage->cell : rate;
    if (stage->step.kind != NB_STEP_TIME || rate.xy != rate.yx)
      return refuse(error, "steps given as times, and strain rates without rotation");
    const double time = rate.per_cycle ? (double)stage->cycles : (double)stage->cycles * stage->step.value;
    strain(&lattice, time * rate.xx, time * rate.yy, time * rate.xy);
    add_value(solution, &lattice, stage->name);
  }
  add_value(solution, &lattice, NULL);
  return solution_status(solution, error);
}

const struct nb_reference reference_lattice_moduli = {
    .name = "lattice_moduli",
    .title = "square and hexagonal lattices in a periodic cell: stress from their elastic moduli in closed form",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FRICTION, HAS_CELL_STRAIN},
    .needs = {HAS_CELL},
    .normal = "linear hertz",
    .shear = "none linear",
    .solve = solve,
};
