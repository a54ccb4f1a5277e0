/* Head-on impact of two elastic spheres, or of a sphere and a wall, without other forces: shared by the references of
 * Hertz's impact. Everything is computed from the moduli, radii and densities of the page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reference.h"

/* The quantities of the equations of impact [R89 5.1-5.9]. */
struct hertz {
  double mass;                            /* m*, kg [R89 5.4] */
  double radius;                          /* R*, m */
  double young;                           /* E*, Pa */
  double k;                               /* K of N = K alpha^(3/2), N/m^(3/2) [R89 5.5] */
  double speed;                           /* V_N, m/s [R89 5.8] */
  double begin;                           /* time of first contact, s */
  double depth;                           /* alpha*, the largest overlap without damping, m [R89 5.9] */
  double unit;                            /* alpha* / V_N, s */
  double duration;                        /* T_c, s [R89 5.12] */
  double step;                            /* of the scene, s */
  double damping;                         /* beta of `damping ratio`, 1 [R89 4.13]; 0: none */
  const struct nb_particle *particles[2]; /* the second is NULL for a wall */
  double ex, ey;                          /* unit vector from the first to the second */
  const struct nb_scene *scene;
};

/* T_c V_N/alpha* = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) = 2.9432751843247047  [R89 5.12] */
double hertz_duration_factor(void);

/* The coefficient of restitution of a dashpot with the damping ratio beta, e = exp(-pi z/(1 - z^2)^(1/2)) with
 * z = (6/5)^(1/2) beta. In alpha^(5/4) and alpha' the damped equation of impact is that of a linear spring and dashpot
 * (Antypov and Elliott 2011). e = 0 for beta >= (5/6)^(1/2). hertz_ratio is the inverse. */
double hertz_restitution(double beta);
double hertz_ratio(double restitution);

/* The normal force at an overlap, N [R89 5.5] */
double hertz_force(const struct hertz *hertz, double overlap);

/* Reads the impact from the scene. NB_BAD_USE unless the impact is head-on and without spin, a wall has a constant
 * velocity, and the step is given as a time or as a fraction of the duration of the collision. */
enum nb_status hertz_read(struct hertz *hertz, const struct nb_scene *scene, const char *reference,
                          struct nb_error *error);

/* Adds C.overlap and C.normal at the end of each stage before the first one that ends with a condition or has another
 * step. Also adds their maxima: of the run, and of the stage that contains the time `when` of the largest overlap
 * `deepest`. */
void hertz_add_stages(struct nb_solution *solution, const struct hertz *hertz,
                      double (*overlap_at)(const void *data, double t), const void *data, double deepest, double when);
/* Add C.WHAT for the monitor of the contact, if there is one: a value, or a curve versus `time` or versus C.overlap.
 * `size` bytes of data are copied. */
void hertz_add(struct nb_solution *solution, const struct hertz *hertz, const char *what, double value);
void hertz_curve(struct nb_solution *solution, const struct hertz *hertz, const char *what, const char *along,
                 double (*at)(const void *data, double x), const void *data, size_t size);
