/* Reference: force chains of a zigzag of equal discs between two walls, and of discs without load.
 *
 * Each contact of two discs makes the angle phi with the axis of the zigzag, which is y, and carries F. A wall supports
 * each disc laterally with 2 F sin phi. The stress of a disc is then, up to overlaps, F R over its volume times
 *
 *   along the axis    2 cos^2 phi                 across    2 sin^2 phi + 2 sin phi
 *
 * The major stress acts along the axis while cos 2 phi > sin phi, that is phi < 30 degrees. Then every contact of two
 * free discs is a link of a force chain, and the direction changes by 2 phi from one link to the next. Between 30 and
 * 45 degrees the major stress acts from wall to wall, no contact of two discs lies within 45 degrees of it, and there
 * is no chain. The discs that load the ends are fixed; they are not particles of the chain.
 *
 * Returns, for A that monitors a region of all particles:   A.chains, A.chains.length, A.chains.fraction, A.chains.bend
 * Accepts phi < 45 degrees. At larger angles the contacts of discs lie within 45 degrees of the major stress, but no
 * two links lie on opposite sides of a disc. Exact where |phi - 30 degrees| is above the order of overlap over radius.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>

#include "reference.h"

static bool touch(const struct nb_particle *a, const struct nb_particle *b) {
  return hypot(a->x - b->x, a->y - b->y) < a->radius + b->radius;
}

/* *phi: the angle of the contacts of discs with the y axis, rad. *touching: the number of free discs with such
 * contacts. False: the angles differ, or fewer than three free discs have such contacts. */
static bool contacts_alike(const struct nb_scene *scene, double *phi, double *touching) {
  double smallest = INFINITY, largest = 0;
  *touching = 0;
  for (size_t i = 0; i < scene->particle_count; i++) {
    bool has_contact = false;
    for (size_t j = 0; j < scene->particle_count; j++) {
      const struct nb_particle *a = &scene->particles[i], *b = &scene->particles[j];
      if (i == j || !touch(a, b))
        continue;
      const double angle = atan2(fabs(a->x - b->x), fabs(a->y - b->y));
      has_contact = true, smallest = fmin(smallest, angle), largest = fmax(largest, angle);
    }
    *touching += has_contact && !scene->particles[i].fixed;
  }
  *phi = largest;
  return *touching > 2 && largest - smallest < 1e-9;
}

static void add_value(struct nb_solution *solution, const char *region, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s", region, what);
  solution_value(solution, value, name);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  double phi, touching;
  if (scene->region_count == 0 || !contacts_alike(scene, &phi, &touching))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `zigzag` is for a region and three or more free discs whose contacts all make "
                        "the same angle with y");
  if (!(phi < atan(1) - 1e-9)) /* at 45 degrees rounding decides which contacts are links */
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `zigzag` is for contacts at less than 45 degrees to y; here they are at %g",
                        phi * 45 / atan(1));
  double free_particles = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    free_particles += !scene->particles[k].fixed;
  const bool chain = cos(2 * phi) > sin(phi);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_REGION || scene->regions[monitor->a].kind != NB_REGION_ALL)
      continue;
    add_value(solution, monitor->name, "chains", chain);
    add_value(solution, monitor->name, "chains.length", chain ? touching : 0);
    add_value(solution, monitor->name, "chains.fraction", chain ? touching / free_particles : 0);
    add_value(solution, monitor->name, "chains.bend", chain ? 2 * phi : 0);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_zigzag = {
    .name = "zigzag",
    .title = "force chains of a zigzag between two walls, from the balance of each disc",
    .source = "-",
    .accepts = {HAS_DISCS},
    .needs = {HAS_WALLS, HAS_FIXED_PARTICLES},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
