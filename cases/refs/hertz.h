/* Two elastic spheres, or a sphere and a wall, that meet head-on and nothing else: what the references of Hertz's impact
 * share. Everything is worked out here from the moduli, radii and densities of the page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_HERTZ_H
#define NB_HERTZ_H

#include "reference.h"

/* A pair, as the equations of impact want it [R89 5.1-5.9]. */
struct hertz {
  double mass;                            /* m*, kg [R89 5.4] */
  double radius;                          /* R*, m */
  double young;                           /* E*, Pa */
  double k;                               /* K of N = K alpha^(3/2), N/m^(3/2) [R89 5.5] */
  double speed;                           /* V_N, m/s [R89 5.8] */
  double begin;                           /* first touch, s from the beginning of the run */
  double depth;                           /* alpha*, m [R89 5.9] */
  double unit;                            /* alpha* / V_N, s */
  double duration;                        /* T_c, s [R89 5.12] */
  double step;                            /* the first one of the run, s */
  double damping;                         /* beta of `damping ratio`, 1 [R89 4.13]; 0: none */
  const struct nb_particle *particles[2]; /* the second NULL: a wall */
  double ex, ey;                          /* from the first to the second */
  const struct nb_scene *scene;
};

/* T_c V_N/alpha* = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) = 2.9432751843247047  [R89 5.12] */
double hertz_time(void);

/* What a dashpot of the share beta of critical leaves of the speed, e = exp(-pi z/(1 - z^2)^(1/2)), z = (6/5)^(1/2) beta: in the
 * plane of alpha^(5/4) and alpha' the damped equation of impact is that of a linear spring and dashpot (Antypov and Elliott 2011). 0
 * from beta = (5/6)^(1/2) on. And the beta that makes e. */
double hertz_restitution(double beta);
double hertz_ratio(double restitution);

/* N at an overlap, N [R89 5.5] */
double hertz_force(const struct hertz *hertz, double overlap);

/* The scene must hold the pair and nothing more: no gravity, no global damping, no spin; stages that change nothing. */
enum nb_status hertz_of(struct hertz *hertz, const struct nb_scene *scene, const char *who, struct nb_error *error);

/* C.overlap in STAGE and C.normal in STAGE, from the curve of overlap, for stages whose end is a number of cycles; and both
 * with `max`, of the overlap `deepest` at the time `when` of the run, alone and for the stage that has it, if that is known. */
void hertz_add_stages(struct nb_solution *solution, const struct hertz *hertz,
                      double (*overlap_at)(const void *data, double t), const void *data, double deepest, double when);
/* C.WHAT for the watch of the contact, nothing when there is none; likewise the curve along `time`, or along C.overlap when
 * that is what `along` says: `size` bytes of data are copied. */
void hertz_add(struct nb_solution *solution, const struct hertz *hertz, const char *what, double value);
void hertz_curve(struct nb_solution *solution, const struct hertz *hertz, const char *what, const char *along,
                 double (*at)(const void *data, double x), const void *data, size_t size);

#endif
