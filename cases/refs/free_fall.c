/* Reference: a particle falls on a wall with a spring and a dashpot and bounces: piecewise closed form.
 *
 * u is the height of the centre above the position where the particle just touches, v = u', and t is the time since the
 * beginning of the piece, where u = u0 and v = v0. m is the mass, k the stiffness, c the coefficient of the dashpot and
 * g the gravity.
 *
 *   flight    u = u0 + v0 t - g t^2/2                                            until u = 0
 *   contact   m u'' = -m g - k u - c u',  w^2 = k/m,  b = c/(2 m),  w'^2 = w^2 - b^2
 *             u = -g/w^2 + e^(-b t) (A cos w't + B sin w't),   A = g/w^2,  B = (v0 + b A)/w'
 *             until u = 0 again
 *
 * The dashpot acts, and may pull, while the overlap is positive, as in the simulator. The end of a contact is found by
 * bisection between the lowest point and the next highest one. If u is not above 0 at that highest point, the particle
 * stays in contact.
 *
 * Accepts a run with at most 128 contacts, because the pieces are stored.
 *
 * Returns, for D that monitors the particle and C its contact:   D.y, D.vy versus time; C.overlap max
 * Exact in continuous time. In a run a contact begins within a step, and the force of a dashpot jumps there: the error
 * is of first order in the step with a dashpot, of second order without.
 *
 * Source   [MFiX DEM-01], elementary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "single.h"

enum { PIECES = 256 };

struct piece {
  double begin, u0, v0; /* s, m, m/s */
  bool touching;
};

struct fall {
  double g, w, b, damped; /* g, m/s2; w, b and w', 1/s */
  double radius, floor;   /* m */
  struct piece pieces[PIECES];
  int count;
};

static void state_in(const struct fall *f, const struct piece *piece, double t, double *u, double *v) {
  if (!piece->touching) {
    *u = piece->u0 + piece->v0 * t - f->g * t * t / 2;
    *v = piece->v0 - f->g * t;
    return;
  }
  const double sag = f->g / (f->w * f->w), a = sag + piece->u0, b = (piece->v0 + f->b * a) / f->damped;
  const double c = cos(f->damped * t), s = sin(f->damped * t), fade = exp(-f->b * t);
  *u = -sag + fade * (a * c + b * s);
  *v = fade * ((f->damped * b - f->b * a) * c - (f->damped * a + f->b * b) * s);
}

/* The first time in the piece at which u' is 0. */
static double lowest_time(const struct fall *f, const struct piece *piece) {
  const double sag = f->g / (f->w * f->w), a = sag + piece->u0, b = (piece->v0 + f->b * a) / f->damped;
  const double angle = atan2(f->damped * b - f->b * a, f->damped * a + f->b * b);
  const double pi = 3.14159265358979323846;
  return (angle + pi) / f->damped;
}

/* The duration of the piece, s; INFINITY: the piece has no end. */
static double duration(const struct fall *f, const struct piece *piece) {
  if (!piece->touching)
    return f->g > 0 ? (piece->v0 + sqrt(piece->v0 * piece->v0 + 2 * f->g * piece->u0)) / f->g : INFINITY;
  double low = lowest_time(f, piece), high = low + 3.14159265358979323846 / f->damped, u, v;
  state_in(f, piece, high, &u, &v);
  if (!(u > 0))
    return INFINITY;
  for (int n = 0; n < 200; n++) {
    const double middle = low + (high - low) / 2;
    state_in(f, piece, middle, &u, &v);
    *(u > 0 ? &high : &low) = middle;
  }
  return high;
}

static void find_pieces(struct fall *f, double height) {
  struct piece *piece = &f->pieces[0];
  *piece = (struct piece){.u0 = height};
  f->count = 1;
  for (double last = duration(f, piece); isfinite(last) && f->count < PIECES; last = duration(f, piece)) {
    struct piece next = {.begin = piece->begin + last, .touching = !piece->touching};
    double u;
    state_in(f, piece, last, &u, &next.v0);
    piece = &f->pieces[f->count++];
    *piece = next;
  }
}

/* Whether the run ends before the last piece that is stored. */
static bool covers(const struct fall *f, const struct nb_scene *scene, double step) {
  const struct piece *last = &f->pieces[f->count - 1];
  double end = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    end += (double)scene->stages[s].cycles * step;
  return end <= last->begin + duration(f, last);
}

static void at(const struct fall *f, double t, double *u, double *v) {
  int k = 0;
  while (k + 1 < f->count && f->pieces[k + 1].begin <= t)
    k++;
  state_in(f, &f->pieces[k], t - f->pieces[k].begin, u, v);
}

static double y_at(const void *data, double t) {
  const struct fall *f = data;
  double u, v;
  at(f, t, &u, &v);
  return f->floor + f->radius + u;
}

static double vy_at(const void *data, double t) {
  double u, v;
  at(data, t, &u, &v);
  return v;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct single particle;
  if (single_read(&particle, "free_fall", scene, error))
    return error->status;
  if (scene->gravity.x != 0 || particle.height < particle.radius)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `free_fall` is for a particle dropped straight down, from rest, above the wall");
  const double w = sqrt(particle.pair.kn / particle.m), b = particle.cn / (2 * particle.m);
  if (!(b < w))
    return nb_error_set(error, NB_BAD_USE, "the reference `free_fall` is for less than critical damping");
  struct fall fall = {
      .g = particle.gravity_n, .w = w, .b = b, .damped = sqrt(w * w - b * b), .radius = particle.radius};
  fall.floor = scene->walls[0].y;
  find_pieces(&fall, particle.height - particle.radius);
  if (!covers(&fall, scene, particle.step))
    return nb_error_set(error, NB_BAD_USE, "the reference `free_fall` is for a run with at most %d contacts",
                        PIECES / 2);
  single_curve(solution, particle.particle, "y", y_at, &fall, sizeof fall);
  single_curve(solution, particle.particle, "vy", vy_at, &fall, sizeof fall);
  if (fall.count > 1) {
    double u, v;
    state_in(&fall, &fall.pieces[1], lowest_time(&fall, &fall.pieces[1]), &u, &v);
    single_add(solution, particle.contact, "overlap max", NULL, -u);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_free_fall = {
    .name = "free_fall",
    .title = "free fall and bouncing on a spring and a dashpot: piecewise closed form",
    .source = "[MFiX DEM-01]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_CONTACT_DAMPING, HAS_UNTIL},
    .needs = {HAS_WALLS, HAS_GRAVITY},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
