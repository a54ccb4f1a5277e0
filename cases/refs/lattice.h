/* Discs that touch and the walls around them as a network of springs: small displacements, contacts that neither open
 * nor close, directions that do not turn. What is neglected is of the order of the displacement over the radius.
 * Several references share it; the simulator knows nothing of it.
 *
 * Each body has three freedoms, x, y and theta (counterclockwise). A contact between bodies a and b has a unit vector
 * e from a to b and t = e turned clockwise [CS79 9, 10]; its overlap n and its slip s are [CS79 12, 13]
 *     n = (x_a - x_b).e        s = (x_a - x_b).t - (theta_a R_a + theta_b R_b)
 * and F_n = k_n n, F_s = k_s s. At a wall b has no spin and its displacement is given. Exchanging a and b changes
 * neither n nor s.
 *
 * A wall's point there goes with P and, when the wall turns by a about P, by a times its arm turned counterclockwise.
 *
 * With u all freedoms and w all wall displacements: (n, s) = stretch u + push w, the forces are S (n, s) with S the
 * springs, and  M u'' = - stretch' S (stretch u + push w).  Freedoms are kept in units of 1/sqrt(mass), so that M = 1:
 * the columns of `stretch` are divided by sqrt(m), sqrt(I).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LATTICE_H
#define NB_LATTICE_H

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include "reference.h"

enum { LATTICE_WALL = 3 }; /* numbers for each wall: P's way to the east and to the north, and the turn about P */

struct lattice_contact {
  int a;                   /* body index */
  int b;                   /* body index, or wall index */
  bool wall;               /* b is a wall */
  double ex, ey;           /* unit vector from a to b */
  struct matter_pair pair; /* ks = 0 where the scene lets no shear force arise */
};

/* At `cycle` the velocities of the walls change by these, x, y and spin of each in turn, m/s and rad/s. */
struct lattice_turn {
  unsigned long cycle;
  gsl_vector *change;
};

struct lattice {
  size_t freedom_count; /* three per body */
  struct lattice_contact *contacts;
  size_t contact_count;
  gsl_matrix *stretch; /* 2 contact_count x freedom_count; row 2c: overlap of contact c, row 2c + 1: its slip */
  gsl_matrix *push;    /* 2 contact_count x LATTICE_WALL wall_count; NULL without walls */
  gsl_vector *springs; /* k_n, k_s of each contact in turn, N/m */
  struct lattice_turn *turns;
  size_t turn_count;
  gsl_vector *
      *travel; /* per stage: how far each wall has come by the stage's end: x, y and angle of each in turn, m, rad */
  size_t stage_count;
  double reach;           /* the longest way any end of a wall goes, m */
  double step;            /* s; of the first stage */
  bool one_step;          /* all stages have that step */
  unsigned long undamped; /* cycles from the start in which nothing is damped */
  unsigned long cycles;   /* of all stages */
};

/* NB_BAD_USE and an error in words when the scene is no such network. */
enum nb_status lattice_build(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error);
/* The network of all pairs whose gap is smaller than `reach`, m, whatever the scene does: contacts, stretch, push, springs. */
enum nb_status lattice_near(struct lattice *lattice, const struct nb_scene *scene, double reach,
                            struct nb_error *error);
void lattice_free(struct lattice *lattice);

/* The contact that a watch looks at; -1 when the watch is none of a contact, or nothing touches there. */
int lattice_watched(const struct lattice *lattice, const struct nb_monitor *monitor);

/* ---- lattice_walls.c: what the stages do to the walls ---- */

enum nb_status lattice_drive(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error);
/* The first stage of which all walls stand still from its beginning to the end of the scene; stage_count: none. */
size_t lattice_standing(const struct lattice *lattice, const struct nb_scene *scene);

/* ---- lattice_rest.c: where everything comes to rest ---- */

/* Forces k_n n, k_s s of every contact at rest after the walls have come `travel`; nothing slips. */
enum nb_status lattice_rest(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                            struct nb_error *error);
/* The same where |F_s| <= F_n tan phi [CS79 19, c = 0], for slow loading along a straight path from nothing. */
enum nb_status lattice_rest_slipping(const struct lattice *lattice, const gsl_vector *travel, gsl_vector *forces,
                                     struct nb_error *error);
/* NB_BAD_USE when a contact pulls or a shear force is above what friction holds; `when` ends the message. */
enum nb_status lattice_holds(const struct lattice *lattice, const gsl_vector *forces, double when,
                             struct nb_error *error);

/* ---- lattice_swing.c: how it swings about rest ---- */

/* A force in time, a sum of straight lines and waves that begin where the walls' velocities change.
 * One allocation, so that it can be the data of a curve. */
struct oscillation {
  double unit; /* what one cycle is on the axis: 1, or the step in s */
  size_t count;
  struct oscillation_term {
    double start; /* cycle */
    double size;  /* N per cycle */
    double phase; /* per cycle; 0: a straight line and no wave */
    double sine;  /* what the wave's size is divided by; sin(phase) in steps, phase in continuous time */
  } terms[];
};

enum oscillation_time { OSCILLATION_STEPS, OSCILLATION_CONTINUOUS };

/* Normal modes of the network: u'' = -A u with A = stretch' S stretch. */
struct oscillation_modes {
  gsl_vector *square; /* omega^2, 1/s2, ascending; below `still` of the largest: no restoring force at all */
  gsl_matrix *shape;  /* columns */
};
struct oscillation_modes oscillation_modes_create(const struct lattice *lattice);
void oscillation_modes_free(struct oscillation_modes *modes);

/* Force `row` (2c: normal, 2c + 1: shear of contact c) from rest. NULL and a filled error when memory runs out or the
 * step is too long. Free with free(). */
struct oscillation *oscillation_create(const struct lattice *lattice, const struct oscillation_modes *modes, size_t row,
                                       enum oscillation_time time, double unit, struct nb_error *error);
double oscillation_at(const void *oscillation, double x);       /* x in cycles times unit */
double oscillation_mean(const struct oscillation *oscillation); /* about which it swings once the walls stand */
double oscillation_amplitude(
    const struct oscillation *oscillation); /* the sum of the waves' amplitudes once the walls stand */
/* Waves per cycle of the mode that decides how often the mean is crossed; 0 when no mode does. */
double oscillation_beat(const struct oscillation *oscillation);

#endif
