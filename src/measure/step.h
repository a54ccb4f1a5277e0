/* The time step: its units, and the stability check.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "laws/laws_now.h"
#include "pass/pass.h"

/* State of the stability check: step.c, stable_step.c, stability.c. */
struct nb_stability {
  int step_line;                        /* line of the statement that has set the step; -1: none yet */
  double stable_step;                   /* guaranteed stable step at the beginning of the current stage, s */
  bool allow_unstable;                  /* no check in this stage */
  bool damped;                          /* contacts have dashpots at the next force calculation */
  struct nb_dashpot dashpots[2];        /* their coefficients: for two particles, and for a particle and a wall */
  unsigned long checks;                 /* number of checks so far */
  double largest;                       /* largest ratio of the step to the guaranteed stable step in these checks, 1 */
  struct nb_particle_sums *sums;        /* workspace of stable_step.c, per slot */
  double *remainder;                    /* workspace of stability.c, per slot; NULL: no contact stiffens with overlap */
  struct nb_coefficients *coefficients; /* of each contact, during a check; NULL: computed when needed */
};
bool nb_stability_create(struct nb_model *model); /* false: no memory */

/* stable_step.c */
struct nb_particle_sums {
  double kn, ks, cn, cs; /* sums over a particle's contacts of k_n, k_s R^2, c_n and c_s R^2 */
};
/* The guaranteed stable step for the current contacts and damping, and the contact that limits it. */
struct nb_stable {
  double step;     /* s; infinite if nothing can vibrate */
  int a, b;        /* slots; b is a wall's index in a pair with walls, or -1 if `apart`; a -1: no contact */
  bool apart;      /* the pair does not touch and counts as if it did */
  bool rotational; /* shear and rotation limit the step, not the normal motion */
  const struct nb_material_pair *material_pair; /* material pair of the contact */
};
struct nb_stable nb_stable_step(const struct nb_model *model);
/* As nb_stable_step, but keeps the coefficients of the contacts until nb_stable_step_end. It does not if there is no
 * memory for them, or if there are many linear springs. */
struct nb_stable nb_stable_step_begin(const struct nb_model *model);
void nb_stable_step_end(const struct nb_model *model);
/* The guaranteed stable step of pairs that could collide later: the lightest two particles of each pair of
 * materials, as if they touched. */
struct nb_stable nb_stable_step_apart(const struct nb_model *model);
/* The limit when a stage begins: the smaller of nb_stable_step and nb_stable_step_apart. */
struct nb_stable nb_stable_step_stage(const struct nb_model *model);
double nb_stability_limit(const struct nb_damping *damping); /* L of stable_step.c, 1 */

/* A contact with its part of the masses, for the terms of dt^2 k + 2 dt c (stable_step.c). */
struct nb_element {
  struct nb_coefficients own;
  double a, d; /* A, 1/s2; A with c_n instead of k_n, 1/s */
  double q, p; /* Q_i/I_i + Q_j/I_j, 1/s2; this sum with c_s instead of k_s, 1/s */
};
double nb_inverse_mass(const struct nb_model *model, size_t contact); /* 1/M*, 1/kg */
/* Valid from nb_stable_step_begin to nb_stable_step_end. */
struct nb_element nb_element_of(const struct nb_model *model, size_t contact);
static inline double nb_element_normal(const struct nb_element *element, double dt) {
  return dt * (dt * element->a + 2 * element->d);
}
static inline double nb_element_rotational(const struct nb_element *element, double dt) {
  return dt * (dt * element->q + 2 * element->p);
}
/* Writes to `text`, for messages, which contact limits the step. */
void nb_stable_text(char *text, size_t size, const struct nb_model *model, const struct nb_stable *stable);

/* ---- stability.c ---- */
bool nb_stability_overlaps(struct nb_model *model); /* after the forces: true if no overlap exceeds NB_STABLE_OVERLAP */
enum { NB_STABILITY_CYCLES = 1000 };                /* cycles between two checks without a search */
/* Checks the step and sets the stable overlaps. NB_BROKEN if the step is above the stable one and the page does not
 * allow this. */
enum nb_status nb_stability_check(struct nb_model *model, struct nb_error *error);
/* Checks the step when a stage begins; `apart` is the stable step of pairs that could collide later. */
enum nb_status nb_stability_begin(struct nb_model *model, const struct nb_stable *apart, struct nb_error *error);

/* collision.c: the shortest collision of elastic spheres that is predicted at their current velocities */
struct nb_collision {
  double duration; /* s; infinite without a collision */
  double speed;    /* approach velocity at first touch, m/s */
  int a, b;        /* slots; b is a wall's index if `wall`; a -1: no collision */
  bool wall;
};
/* NB_NO_MEMORY or NB_OK, as from nb_step_collision. */
enum nb_status nb_collision_shortest(struct nb_collision *shortest, const struct nb_model *model,
                                     struct nb_error *error);

/* rayleigh_step.c */
double nb_rayleigh_root(double poisson); /* speed of Rayleigh waves over that of shear waves, 1 [R89 4.32] */
double nb_rayleigh_fit(double poisson);  /* R89's fit of this ratio [R89 4.34] */
/* t_R, s [R89 4.33]: the shortest of all spheres, or with `mean` that of a sphere with mean properties; with `fit`, by
 * R89's fit. Infinite without elastic spheres. */
double nb_step_rayleigh(const struct nb_model *model, bool fit, bool mean);

/* fracc.c */
struct nb_fracc {
  double largest;         /* the largest FRACC of the last cycle, 1 */
  double *previous_force; /* |SF| of each slot in the last cycle, N */
};
bool nb_fracc_create(struct nb_model *model);       /* false: no memory */
void nb_fracc_after_forces(struct nb_model *model); /* computes FRACC; called after the forces */

/* step.c */
bool nb_step_elastic(const struct nb_model *model);          /* the next normal law is for elastic spheres */
bool nb_step_loaded(const struct nb_model *model);           /* some contact overlaps by more than rounding */
double nb_step_single_contact(const struct nb_model *model); /* t_c of step.c, s */
/* `collision` of step.c. Only for elastic spheres *shortest has the pair and its speed. */
enum nb_status nb_step_collision(struct nb_collision *shortest, const struct nb_model *model, struct nb_error *error);
/* Sets `lightest` to the slots of the lightest particles of the two materials of a pair; -1: there is none, or the
 * second is a wall. */
void nb_step_lightest(const struct nb_model *model, const struct nb_material_pair *material_pair, int lightest[2]);
/* Sets the step of the model as a statement `step` requires. */
enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error);
