/* The time step: its units, and the stability check.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STEP_H
#define NB_STEP_H

#include "laws/laws_now.h"
#include "pass/pass.h"

/* State of the stability check: step.c, stable_step.c, stability.c. */
struct nb_stability {
  int step_line;                 /* line of the statement that has set the step; -1: none yet */
  double stable_step;            /* guaranteed stable step at the beginning of this stage, s */
  bool allow_unstable;           /* no check in this stage */
  bool damped;                   /* contacts have dashpots at the next force calculation */
  unsigned long checks;          /* number of checks so far */
  double largest;                /* step over the guaranteed stable one, the largest of these checks */
  struct nb_particle_sums *sums; /* workspace of stable_step.c, per slot */
};
bool nb_stability_create(struct nb_model *model); /* false: no memory */

/* stable_step.c */
struct nb_particle_sums {
  double kn, ks, cn, cs; /* sums over a particle's contacts: k_n, k_s R^2, and likewise c_n, c_s R^2 */
  double remainder;      /* the smallest part of the remainders of its contacts: stability.c */
};
/* The guaranteed stable step with the present contacts and damping, and the contact that limits it. */
struct nb_stable {
  double step;                                  /* s; infinite when nothing can vibrate */
  int a, b;                                     /* slots, b a wall if the material pair has one; b or both -1: none */
  bool apart;                                   /* a pair that counts as if it touched */
  bool rotational;                              /* limited by shear and rotation, not by normal motion */
  const struct nb_material_pair *material_pair; /* of that contact */
};
struct nb_stable nb_stable_step(const struct nb_model *model);
/* Of pairs that could meet later: the lightest particles of every two materials, as if they touched. */
struct nb_stable nb_stable_step_apart(const struct nb_model *model);
struct nb_stable nb_stable_step_stage(const struct nb_model *model); /* the smaller of both: limit for a stage */
double nb_stability_limit(const struct nb_damping *damping);         /* L of stable_step.c, 1 */

/* A contact with its part of the masses: the terms of dt^2 k + 2 dt c. */
struct nb_element {
  struct nb_coefficients own;
  double a, d; /* A, 1/s2; the same with c_n in place of k_n, 1/s */
  double q, p; /* Q_i/I_i + Q_j/I_j, 1/s2; the same with c_s in place of k_s, 1/s */
};
double nb_inverse_mass(const struct nb_model *model, size_t contact);          /* 1/M*, 1/kg */
struct nb_element nb_element_of(const struct nb_model *model, size_t contact); /* after nb_stable_step */
static inline double nb_element_normal(const struct nb_element *element, double dt) {
  return dt * (dt * element->a + 2 * element->d);
}
static inline double nb_element_rotational(const struct nb_element *element, double dt) {
  return dt * (dt * element->q + 2 * element->p);
}
/* Text for messages: what limits the step. */
void nb_stable_text(char *text, size_t size, const struct nb_model *model, const struct nb_stable *stable);

/* ---- stability.c ---- */
bool nb_stability_overlaps(struct nb_model *model); /* after the forces: no overlap exceeds its NB_STABLE_OVERLAP */
enum { NB_STABILITY_CYCLES = 1000 };                /* between two checks without a search */
/* NB_BROKEN if the step is above the stable one, unless the page allows it; else sets the stable overlaps. */
enum nb_status nb_stability_check(struct nb_model *model, struct nb_error *error);
/* The same when a stage begins, with pairs that could meet later. */
enum nb_status nb_stability_begin(struct nb_model *model, const struct nb_stable *apart, struct nb_error *error);

/* collision.c: the shortest collision of elastic spheres predicted at the present velocities */
struct nb_collision {
  double duration, speed; /* s, infinite without a collision; approach velocity at touch, m/s */
  int a, b;               /* slots, b a wall if `wall` */
  bool wall;
};
struct nb_collision nb_collision_shortest(const struct nb_model *model);

/* rayleigh_step.c */
double nb_rayleigh_root(double poisson); /* speed of Rayleigh waves over that of shear waves [R89 4.32] */
double nb_rayleigh_fit(double poisson);  /* R89's fit of it [R89 4.34] */
/* t_R, the shortest of all spheres or that of the mean sphere, s; infinite without elastic spheres [R89 4.33]. */
double nb_step_rayleigh(const struct nb_model *model, bool fit, bool mean);

/* fracc.c */
struct nb_fracc {
  double largest;         /* of the last cycle */
  double *previous_force; /* per slot |SF| of the last cycle, N */
};
bool nb_fracc_create(struct nb_model *model);       /* false: no memory */
void nb_fracc_after_forces(struct nb_model *model); /* after the forces */

/* step.c */
bool nb_step_elastic(const struct nb_model *model);     /* the next normal law is one of elastic spheres */
bool nb_step_loaded(const struct nb_model *model);      /* some contact overlaps by more than rounding */
double nb_step_collision(const struct nb_model *model); /* duration of the shortest possible collision, s */
double nb_step_single_contact(const struct nb_model *model);
/* Slots of the lightest particles of the two materials of a pair; -1: none, or the second is a wall. */
void nb_step_lightest(const struct nb_model *model, const struct nb_material_pair *material_pair, int lightest[2]);
enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error);

#endif
