/* Reference: a column of spheres compressed slowly between two walls, or a contact test: the normal force against
 * overlap and wall position.
 *
 * The contact circle of radius a under a paraboloid f(r) = r^2/(2 R*), which has the curvature of the pair of spheres,
 * has
 *
 *   alpha = a Int_0^a f'(r) dr/(a^2 - r^2)^(1/2),    N = 2 E* Int_0^a r^2 f'(r) dr/(a^2 - r^2)^(1/2)     (Sneddon 1965)
 *
 * integrated with r = a sin(t) by the Gauss-Legendre rule; bisection finds a for a given alpha. This is the force of
 * [R89 3.13], found without its closed form.
 *
 * In equilibrium N is the same in all contacts of the column, and their overlaps add up to s, the approach of the walls
 * since all contacts just touched. Since N ~ alpha^(3/2) at each contact, each overlap is a constant fraction of s.
 *
 * Returns, for C that monitors a contact of the column and W the upper wall:
 *   C.normal versus C.overlap
 *   C.normal, C.overlap versus W.y     in equilibrium
 *   normal versus overlap              in a contact test
 *
 * Source   Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57; [R89 sec. 5.2].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hertz.h"
#include "single.h"

enum { POINTS = 16, CONTACTS = 8 };

struct contact {
  double radius, young; /* R*, m; E*, Pa */
  double fraction;      /* overlap of this contact over s, dimensionless */
  double touch;         /* y of the upper wall at which all contacts just touch, m */
};

/* alpha and N of a contact circle of radius a. */
static void sneddon(const struct contact *contact, double a, double *alpha, double *force) {
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
  *alpha = *force = rule ? 0 : NAN;
  for (size_t k = 0; rule && k < POINTS; k++) {
    double t, w;
    gsl_integration_glfixed_point(0, M_PI / 2, k, &t, &w, rule);
    const double r = a * sin(t), slope = r / contact->radius;
    *alpha += a * w * slope, *force += 2 * contact->young * w * r * r * slope;
  }
  if (rule)
    gsl_integration_glfixed_table_free(rule);
}

static double force_at(const void *data, double overlap) {
  const struct contact *contact = data;
  double low = 0, high = contact->radius, force = 0;
  while (overlap > 0) {
    const double middle = low + (high - low) / 2;
    double alpha;
    sneddon(contact, middle, &alpha, &force);
    if (!(middle > low && middle < high))
      return force;
    *(alpha < overlap ? &low : &high) = middle;
  }
  return 0;
}

/* s = 2 (touch - y), because both walls move. */
static double overlap_at_wall(const void *data, double y) {
  const struct contact *contact = data;
  return fmax(contact->fraction * 2 * (contact->touch - y), 0);
}
static double force_at_wall(const void *data, double y) { return force_at(data, overlap_at_wall(data, y)); }

static void add_value(struct nb_solution *solution, const char *name, const char *along,
                      double (*at)(const void *data, double x), const struct contact *contact) {
  struct contact *copy = malloc(sizeof *copy);
  if (copy)
    *copy = *contact;
  solution_curve(solution, name, along, at, copy);
}

/* Whether both walls are level, face the spheres, and move along y with opposite velocities in every stage. */
static bool symmetric(const struct nb_scene *scene) {
  for (int w = 0; w < 2; w++)
    if (scene->walls[w].ey != 0 || scene->walls[w].vx != 0 ||
        !single_faces(&scene->walls[w], scene->particles[0].x, scene->particles[0].y))
      return false;
  for (size_t s = 0; s < scene->stage_count; s++) {
    double v[2] = {0};
    for (size_t m = 0; m < scene->stages[s].motion_count; m++) {
      const struct nb_wall_motion *motion = &scene->stages[s].motions[m];
      v[motion->wall] += motion->vy;
      if (motion->vx != 0)
        return false;
    }
    if (v[0] + v[1] != 0)
      return false;
  }
  return scene->walls[0].vy + scene->walls[1].vy == 0;
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `hertz_curve` is for %s", what);
}

/* Finds the contacts, from the lower wall to the upper one. */
static enum nb_status column(struct contact *contact, const struct nb_scene *scene, struct nb_error *error) {
  const size_t n = scene->particle_count;
  double compliance = 0, height = 0;
  for (size_t c = 0; c <= n; c++) {
    const struct nb_particle *below = c ? &scene->particles[c - 1] : NULL, *above = c < n ? &scene->particles[c] : NULL;
    const int a = below ? below->material : scene->walls[0].material,
              b = above ? above->material : scene->walls[1].material;
    contact[c].radius = matter_radius(below ? below->radius : INFINITY, above ? above->radius : INFINITY);
    contact[c].young = matter_pair(scene, a, b).young;
    contact[c].fraction = pow(contact[c].young * sqrt(contact[c].radius), -2. / 3); /* up to a common factor */
    compliance += contact[c].fraction;
    height += above ? 2 * above->radius : 0;
    if (above && above->x != scene->particles[0].x)
      return refuse(error, "spheres one above the other, in the order of the page");
  }
  for (size_t c = 0; c <= n; c++)
    contact[c].fraction /= compliance, contact[c].touch = scene->walls[0].y + height;
  if (fabs(scene->walls[0].y + height - scene->walls[1].y) > 1e-12 * height)
    return refuse(error, "walls and spheres that just touch at first");
  return NB_OK;
}

/* Solves the contact test of particle 1 with particle 2, or with the wall. */
static enum nb_status solve_contact_test(struct nb_solution *solution, const struct nb_scene *scene,
                                         struct nb_error *error) {
  const struct nb_particle *a = &scene->particles[0], *b = scene->particle_count > 1 ? &scene->particles[1] : NULL;
  struct contact contact = {.radius = matter_radius(a->radius, b ? b->radius : INFINITY),
                            .young = matter_pair(scene, a->material, b ? b->material : scene->walls[0].material).young};
  add_value(solution, "normal", "overlap", force_at, &contact);
  return solution_status(solution, error);
}

/* The number of the monitored contact in a column of n spheres, counted from the lower wall; -1: it is not one of them. */
static int contact_number(const struct nb_monitor *monitor, int n) {
  const int a = monitor->a, b = monitor->b;
  if (monitor->kind == NB_MONITOR_PARTICLE_PARTICLE && (a == b + 1 || b == a + 1))
    return a > b ? a : b;
  if (monitor->kind == NB_MONITOR_PARTICLE_WALL && a == (b ? n - 1 : 0))
    return b ? n : 0;
  return -1;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct contact contact[CONTACTS];
  const char *upper = NULL;
  if (scene->contact_test)
    return solve_contact_test(solution, scene, error);
  if (scene->wall_count != 2 || scene->particle_count < 1 || scene->particle_count >= CONTACTS || !symmetric(scene))
    return refuse(error,
                  "up to seven spheres between level walls, a lower and an upper one, that approach with equal speeds");
  if (column(contact, scene, error))
    return error->status;
  for (size_t w = 0; w < scene->monitor_count; w++)
    if (scene->monitors[w].kind == NB_MONITOR_WALL && scene->monitors[w].a == 1)
      upper = scene->monitors[w].name;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const int c = contact_number(monitor, (int)scene->particle_count);
    char along[2 * NB_NAME_SIZE], normal[2 * NB_NAME_SIZE], overlap[2 * NB_NAME_SIZE];
    if (c < 0)
      continue;
    snprintf(normal, sizeof normal, "%s.normal", monitor->name);
    snprintf(overlap, sizeof overlap, "%s.overlap", monitor->name);
    add_value(solution, normal, overlap, force_at, &contact[c]);
    if (!upper)
      continue;
    snprintf(along, sizeof along, "%s.y", upper);
    add_value(solution, normal, along, force_at_wall, &contact[c]);
    add_value(solution, overlap, along, overlap_at_wall, &contact[c]);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_hertz_curve = {
    .name = "hertz_curve",
    .title = "a column of elastic spheres compressed between two walls: Sneddon's integrals, and equilibrium",
    .source = "[R89 3.13, sec. 5.2]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_MOVING_WALLS, HAS_CONTACT_TEST, HAS_RATIO_DAMPING, HAS_RAMP},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
