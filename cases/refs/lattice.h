/* Touching particles and the walls around them as a network of springs, for small displacements: contacts neither open
 * nor close, and their directions are constant. The error is of the order of displacement over radius. Shared by
 * several references; independent of the simulator.
 *
 * Each particle has three degrees of freedom, x, y and theta (counterclockwise). A contact of particles a and b has the
 * unit vector e from a to b and t = e turned clockwise [CS79 9, 10]. With the displacements d_a and d_b of the centres
 * its overlap n and its slip s are [CS79 12, 13]
 *
 *     n = (d_a - d_b).e        s = (d_a - d_b).t - (theta_a R_a + theta_b R_b)
 *
 * with F_n = k_n n, F_s = k_s s. If b is a wall, d_b is the given displacement of its point nearest to a, and
 * theta_b R_b is absent. Exchanging a and b changes neither n nor s. A wall turns about its point P. When it turns by a
 * small angle, each of its points moves with P, and in addition by this angle times the vector from P to the point,
 * turned counterclockwise.
 *
 * With u all degrees of freedom and w all wall displacements (x, y and angle),  (n, s) = stretch u + wall_stretch w.
 * The forces are S (n, s), where the diagonal matrix S has the stiffnesses. With ^T for the transpose,
 *
 *     M d^2u/dt^2 = - stretch^T S (stretch u + wall_stretch w).
 *
 * u stores the displacements times sqrt(m) and the rotations times sqrt(I), so that M = 1: the columns of `stretch` are
 * divided by sqrt(m) and sqrt(I).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include "reference.h"

enum { LATTICE_WALL = 3 }; /* numbers per wall: displacement of P in x and y, and angle about P */

struct lattice_contact {
  int a;                   /* particle index */
  int b;                   /* particle index, or wall index */
  bool wall;               /* b is a wall */
  double ex, ey;           /* unit vector from a to b */
  struct matter_pair pair; /* ks = 0 if the contact has no shear force */
};

/* A change of the velocities of the walls after `cycle` cycles: of x, y and spin of each wall in turn, m/s and
 * rad/s. */
struct lattice_velocity_change {
  unsigned long cycle;
  gsl_vector *change;
};

struct lattice {
  size_t freedom_count; /* three per particle */
  struct lattice_contact *contacts;
  size_t contact_count;
  gsl_matrix *stretch;      /* 2 contact_count x freedom_count; row 2c: overlap of contact c, row 2c + 1: its slip */
  gsl_matrix *wall_stretch; /* 2 contact_count x LATTICE_WALL wall_count; NULL without walls */
  gsl_vector *springs;      /* k_n, k_s of each contact in turn, N/m */
  struct lattice_velocity_change *changes;
  size_t change_count;
  gsl_vector **travel; /* per stage: displacements of the walls at its end, x, y and angle of each in turn, m, rad */
  size_t stage_count;
  double largest_travel; /* at the end of a stage: largest displacement of a P in x or y, or of an end by rotation, m */
  double step;           /* s; of the first stage */
  bool one_step;         /* all stages have that step */
  unsigned long undamped; /* number of cycles from the start without damping */
  unsigned long cycles;   /* number of cycles of all stages */
};

/* The scene has walls. NB_BAD_USE and an error in words when it is not such a network. */
enum nb_status lattice_build(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error);
/* The network of all pairs whose gap is smaller than `largest_gap`, m, except pairs without a free particle. It may
 * have any loading: only contacts, stretch, wall_stretch and springs are set. NB_BAD_USE: no pair, or too many
 * particles. */
enum nb_status lattice_build_pairs(struct lattice *lattice, const struct nb_scene *scene, double largest_gap,
                                   struct nb_error *error);
void lattice_free(struct lattice *lattice);

/* The index of the contact that the monitor names; -1: it does not name a contact, or the network does not have this
 * contact. */
int lattice_contact_of(const struct lattice *lattice, const struct nb_monitor *monitor);

/* ---- lattice_walls.c: the motion of the walls ---- */

/* Sets the members from `changes` to `cycles`. NB_BAD_USE: the displacements of the walls depend on the run, or a step
 * is neither a time nor a fraction of single-contact. */
enum nb_status lattice_read_walls(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error);
/* The index of the first stage from whose beginning all walls stay at rest; stage_count: there is none. */
size_t lattice_first_at_rest(const struct lattice *lattice, const struct nb_scene *scene);

/* ---- lattice_equilibrium.c ---- */

/* Forces k_n n, k_s s of all contacts in equilibrium after the displacements `travel` of the walls, without sliding. */
enum nb_status lattice_equilibrium(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                   struct nb_error *error);
/* Forces of all contacts in equilibrium with sliding: no |F_s| exceeds F_n tan phi; there is no cohesion [CS79 19]. For
 * slow proportional loading from zero. */
enum nb_status lattice_equilibrium_sliding(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                           struct nb_error *error);
/* NB_BAD_USE when a contact is in tension or a shear force exceeds the friction limit. The message names `cycle`. */
enum nb_status lattice_check_forces(const struct lattice *lattice, const gsl_vector *forces, double cycle,
                                    struct nb_error *error);

/* ---- lattice_oscillation.c: oscillation about equilibrium ---- */

/* A force as a function of time. For each change of the velocities of the walls it has terms
 * size (n - sin(n phase)/sine), where n is the number of cycles since the change; a term with phase 0 is size n. It is
 * one allocation, so that it can be the data of a curve. */
struct oscillation {
  double unit; /* x per cycle: 1 if x is a number of cycles, the step if x is a time in s */
  size_t count;
  struct oscillation_term {
    double start; /* cycle of the change */
    double size;  /* N per cycle */
    double phase; /* rad per cycle; 0: a straight line without a wave */
    double sine;  /* divisor of the wave: sin(phase) in steps, phase in continuous time */
  } terms[];
};

enum oscillation_time { OSCILLATION_STEPS, OSCILLATION_CONTINUOUS };

/* Normal modes of the network: d^2u/dt^2 = -A u with A = stretch^T S stretch. */
struct oscillation_modes {
  gsl_vector *square; /* omega^2, 1/s2, ascending; about 0 without a restoring force; NAN: GSL failed */
  gsl_matrix *shape;  /* one column per mode */
};
struct oscillation_modes oscillation_modes_create(const struct lattice *lattice);
void oscillation_modes_free(struct oscillation_modes *modes);

/* The force `row` (2c: normal, 2c + 1: shear of contact c) in a motion from rest. `unit`: see struct oscillation. NULL
 * and an error when memory runs out or, with OSCILLATION_STEPS, when the step is too long or the modes could not be
 * computed. Free with free(). */
struct oscillation *oscillation_create(const struct lattice *lattice, const struct oscillation_modes *modes, size_t row,
                                       enum oscillation_time time, double unit, struct nb_error *error);
double oscillation_at(const void *oscillation, double x);       /* N; x is cycles times unit */
double oscillation_mean(const struct oscillation *oscillation); /* N; once the walls are at rest */
/* The sum of the amplitudes of all waves, N, once the walls are at rest. */
double oscillation_amplitude(const struct oscillation *oscillation);
/* How often per cycle the mean is crossed upwards: the frequency of the dominant mode; 0: no mode dominates. */
double oscillation_frequency(const struct oscillation *oscillation);
