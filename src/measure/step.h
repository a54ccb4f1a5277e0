/* How long a step is: what it may be a share of, and the watch over it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STEP_H
#define NB_STEP_H

#include "laws/laws_now.h"
#include "pass/pass.h"

/* What the stable step is found from, and the watch over it: step.c, stable_step.c, stability.c. */
struct nb_stability {
  int step_line;                 /* of the statement that says how long a step is; -1: none has been worked out yet */
  double stable_step;            /* largest step sure to be stable as this stage began, s */
  bool allow_unstable;           /* the step is not watched now */
  unsigned long checks;          /* how often the watch has worked out the safe step */
  struct nb_particle_sums *sums; /* per slot, room for stable_step.c */
};
bool nb_stability_create(struct nb_model *model); /* false: no memory */

/* stable_step.c */
struct nb_particle_sums {
  double kn, ks, cn, cs; /* sums over a body's contacts: k_n, k_s R^2, and the same of dashpots */
  double remainder;      /* of L by the contact that leaves least: stability.c */
};
/* The largest step that is sure to be stable with the contacts and the damping of now, and which contact sets it. */
struct nb_stable {
  double step;     /* s; infinite when nothing can vibrate */
  int a, b;        /* slots, b a wall where the pairing is with walls; b or both -1: nothing is near */
  bool apart;      /* of a pair as if it touched */
  bool rotational; /* its shear and spin set it, not its normal motion */
  const struct nb_material_pair *material_pair; /* of that contact */
};
struct nb_stable nb_stable_step(const struct nb_model *model);
/* Of all pairs that could meet: the lightest particles of each two materials, as if they touched, whether they are near or not. */
struct nb_stable nb_stable_step_apart(const struct nb_model *model);
struct nb_stable
nb_stable_step_stage(const struct nb_model *model); /* the smaller of both: what a stage may have as its step */
double nb_stability_limit(const struct nb_damping *damping); /* L of the global damping in force */

/* A contact with the shares of mass that it has: everything dt^2 k + 2 dt c is made of. */
struct nb_element {
  struct nb_coefficients own;
  double a, d; /* A, and the same of the dashpots: 1/s2, 1/s */
  double q, p; /* Q_i/I_i + Q_j/I_j, and the same of the dashpots */
};
struct nb_element nb_element_of(const struct nb_model *model, size_t contact); /* with what nb_stable_step has found */
static inline double nb_element_normal(const struct nb_element *element, double dt) {
  return dt * (dt * element->a + 2 * element->d);
}
static inline double nb_element_rotational(const struct nb_element *element, double dt) {
  return dt * (dt * element->q + 2 * element->p);
}
/* "turning of body 5 at wall east" */
void nb_stable_text(char *text, size_t size, const struct nb_model *model, const struct nb_stable *stable);

/* stability.c: whether the step is still sure to be stable */
bool nb_stability_overlaps(struct nb_model *model); /* after the forces: no contact is deeper than its NB_SURE */
/* NB_BROKEN when the step is above the safe one, unless the page allows it; what is sure from there on. */
enum { NB_STABILITY_CYCLES = 1000 }; /* between two looks without a search */
enum nb_status nb_stability_check(struct nb_model *model, struct nb_error *error);
/* The same as a stage begins, for pairs that are apart too. */
enum nb_status nb_stability_begin(struct nb_model *model, const struct nb_stable *apart, struct nb_error *error);

/* collision.c: of elastic spheres, what meets for the shortest time when all go straight on */
struct nb_collision {
  double duration, speed; /* s; infinite when nothing meets; closing at touch, m/s */
  int a, b;               /* slots, b a wall where */
  bool wall;
};
struct nb_collision nb_collision_shortest(const struct nb_model *model);

/* rayleigh_step.c */
double nb_rayleigh_root(double poisson); /* speed of Rayleigh's wave over that of shear waves [R89 4.32] */
double nb_rayleigh_fit(double poisson);  /* the same by [R89 4.34] */
/* Half round the smallest sphere, or one that is the mean of all, s; infinite where none is elastic [R89 4.33]. */
double nb_step_rayleigh(const struct nb_model *model, bool fit, bool mean);

/* fracc.c */
struct nb_fracc {
  double largest;         /* of the cycle behind */
  double *previous_force; /* per slot |SF| then, N */
};
bool nb_fracc_create(struct nb_model *model);       /* false: no memory */
void nb_fracc_after_forces(struct nb_model *model); /* after the forces */

/* step.c */
bool nb_step_elastic(const struct nb_model *model);     /* the normal law ahead is one of elastic spheres */
bool nb_step_loaded(const struct nb_model *model);      /* some of them are, by more than rounding */
double nb_step_collision(const struct nb_model *model); /* duration of the shortest contact there can be, s */
double nb_step_single_contact(const struct nb_model *model);
/* Slots of the lightest bodies of the two materials of a pairing; -1 where there is none, or the second is a wall. */
void nb_step_lightest(const struct nb_model *model, const struct nb_material_pair *material_pair, int lightest[2]);
enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error);

#endif
