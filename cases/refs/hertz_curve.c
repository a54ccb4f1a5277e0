/* Reference: spheres in a column between two walls that squeeze them slowly, or one contact on the bench; the normal force
 * against overlap and wall.
 *
 * A contact is pressed by N: the circle of radius a under a paraboloid of the pair's curvature, f(r) = r^2/(2 R*), has
 *
 *   alpha = a Int_0^a f'(r) dr/(a^2 - r^2)^(1/2),     N = 2 E* Int_0^a r^2 f'(r) dr/(a^2 - r^2)^(1/2)        (Sneddon 1965)
 *
 * worked out with r = a sin(t) by Gauss and Legendre's rule, and a sought for a given alpha by bisection. It is the force of
 * [R89 3.13], by another way than its closed form.
 *
 * In equilibrium N is the same in all contacts of the column and their overlaps are together what the walls have come nearer
 * since all just touched, s: N(s) is the root of sum alpha_i(N) = s. With N ~ alpha^(3/2) everywhere it is a share of s.
 *
 * Known, where NAME watches a contact of the column and W the upper wall:
 *   NAME.normal along NAME.overlap
 *   NAME.normal, NAME.overlap along W.y       in equilibrium
 *   normal along overlap                      on the bench
 *
 * Source   Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57; [R89 5.2].
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hertz.h"

enum { POINTS = 16, CONTACTS = 8 };

struct press {
  double radius, young; /* R*, m; E*, Pa */
  double fraction;      /* of s that is this contact's overlap, 1 */
  double touch;         /* y of the upper wall where all just touch, and how much s grows as it sinks, m, 1 */
  double pull;
};

/* alpha and N of a contact circle of radius a. */
static void sneddon(const struct press *press, double a, double *alpha, double *force) {
  gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
  *alpha = *force = rule ? 0 : NAN;
  for (size_t k = 0; rule && k < POINTS; k++) {
    double t, w;
    gsl_integration_glfixed_point(0, M_PI / 2, k, &t, &w, rule);
    const double r = a * sin(t), slope = r / press->radius;
    *alpha += a * w * slope, *force += 2 * press->young * w * r * r * slope;
  }
  if (rule)
    gsl_integration_glfixed_table_free(rule);
}

static double force_at(const void *data, double overlap) {
  const struct press *press = data;
  double low = 0, high = press->radius, force = 0;
  while (overlap > 0) {
    const double middle = low + (high - low) / 2;
    double alpha;
    sneddon(press, middle, &alpha, &force);
    if (!(middle > low && middle < high))
      return force;
    *(alpha < overlap ? &low : &high) = middle;
  }
  return 0;
}

static double overlap_under(const void *data, double y) {
  const struct press *press = data;
  return fmax(press->fraction * press->pull * (press->touch - y), 0);
}
static double force_under(const void *data, double y) { return force_at(data, overlap_under(data, y)); }

static void add_value(struct nb_solution *solution, const char *name, const char *along,
                      double (*at)(const void *data, double x), const struct press *press) {
  struct press *copy = malloc(sizeof *copy);
  if (copy)
    *copy = *press;
  solution_curve(solution, name, along, at, copy);
}

/* Whether each wall moves as fast as the other, against it, in every stage. */
static bool squeezes(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++) {
    double v[2] = {0};
    for (size_t m = 0; m < scene->stages[s].motion_count; m++) {
      const struct nb_wall_motion *motion = &scene->stages[s].motions[m];
      v[motion->wall] += motion->vy;
      if (motion->vx != 0 || motion->spin != 0)
        return false;
    }
    if (v[0] + v[1] != 0)
      return false;
  }
  return scene->walls[0].vy + scene->walls[1].vy == 0;
}

static enum nb_status refuse(struct nb_error *error, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "hertz_curve is for %s", what);
}

/* The contacts from the lower wall to the upper one. */
static enum nb_status column(struct press *press, const struct nb_scene *scene, struct nb_error *error) {
  const size_t n = scene->particle_count;
  double soft = 0, top = scene->walls[0].y;
  for (size_t c = 0; c <= n; c++) {
    const struct nb_particle *below = c ? &scene->particles[c - 1] : NULL, *above = c < n ? &scene->particles[c] : NULL;
    const int a = below ? below->material : scene->walls[0].material,
              b = above ? above->material : scene->walls[1].material;
    press[c].radius = matter_radius(below ? below->radius : INFINITY, above ? above->radius : INFINITY);
    press[c].young = matter_pair(scene, a, b).young;
    press[c].fraction = pow(press[c].young * sqrt(press[c].radius), -2. / 3); /* of one over another, to be scaled */
    soft += press[c].fraction;
    top += above ? 2 * above->radius : 0;
    if (!(press[c].young > 0) || (above && (above->x != scene->particles[0].x || above->shape != NB_SPHERE)))
      return refuse(error, "elastic spheres one above the other, in the order of the page");
  }
  for (size_t c = 0; c <= n; c++)
    press[c].fraction /= soft, press[c].touch = top, press[c].pull = 2;
  if (fabs(top - scene->walls[1].y) > 1e-12 * top)
    return refuse(error, "walls and spheres that just touch at first");
  return NB_OK;
}

/* Body 1 with body 2, or with the wall. */
static enum nb_status know_contact_test(struct nb_solution *solution, const struct nb_scene *scene,
                                        struct nb_error *error) {
  const struct nb_particle *a = &scene->particles[0], *b = scene->particle_count > 1 ? &scene->particles[1] : NULL;
  struct press press = {.radius = matter_radius(a->radius, b ? b->radius : INFINITY),
                        .young = matter_pair(scene, a->material, b ? b->material : scene->walls[0].material).young};
  if (!(press.young > 0) || strcmp(scene->normal, "hertz") != 0)
    return refuse(error, "elastic spheres with `normal hertz`");
  add_value(solution, "normal", "overlap", force_at, &press);
  return solution_full(solution, error);
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct press press[CONTACTS];
  const char *upper = NULL;
  if (scene->contact_test)
    return know_contact_test(solution, scene, error);
  if (scene->wall_count != 2 || scene->particle_count < 1 || scene->particle_count >= CONTACTS || !squeezes(scene) ||
      scene->gravity.line)
    return refuse(error,
                  "up to seven spheres between two walls, lower and upper, that come nearer alike, without gravity");
  if (column(press, scene, error))
    return error->status;
  for (size_t w = 0; w < scene->monitor_count; w++)
    if (scene->monitors[w].kind == NB_MONITOR_WALL && scene->monitors[w].a == 1)
      upper = scene->monitors[w].name;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    const bool wall = monitor->kind == NB_MONITOR_PARTICLE_WALL;
    char along[2 * NB_NAME_SIZE], normal[2 * NB_NAME_SIZE], overlap[2 * NB_NAME_SIZE];
    if (!wall && monitor->kind != NB_MONITOR_PARTICLE_PARTICLE)
      continue;
    const int c = !wall             ? (monitor->a > monitor->b ? monitor->a : monitor->b)
                  : monitor->b == 0 ? 0
                                    : (int)scene->particle_count;
    snprintf(normal, sizeof normal, "%s.normal", monitor->name);
    snprintf(overlap, sizeof overlap, "%s.overlap", monitor->name);
    add_value(solution, normal, overlap, force_at, &press[c]);
    if (!upper)
      continue;
    snprintf(along, sizeof along, "%s.y", upper);
    add_value(solution, normal, along, force_under, &press[c]);
    add_value(solution, overlap, along, overlap_under, &press[c]);
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_hertz_curve = {
    .name = "hertz_curve",
    .title = "elastic spheres squeezed between two walls: Sneddon's integrals, and equilibrium",
    .source = "[R89 3.13, 5.2]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_MOVING_WALLS, HAS_CONTACT_TEST, HAS_CONTACT_RATIO, HAS_RAMP},
    .normal = "hertz",
    .shear = "none",
    .solve = solve,
};
