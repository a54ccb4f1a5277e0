/* What runs: a scene made into arrays and a plan. Inside the library only; users see `struct nb_model` as a name.
 *
 * A body's slot is where its numbers are stored, its number (1, 2, ...) is what it is called for ever. Results depend on
 * numbers alone: sums over a body's contacts run in the order of the other body's number, walls last, so neither storage
 * order nor search nor threads change a bit of them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MODEL_H
#define NB_MODEL_H

#include "block.h"
#include "laws/law.h"
#include "vec.h"

struct nb_bodies {
  size_t count;
  int *number;             /* slot -> number */
  int *slot;               /* number - 1 -> slot */
  struct nb_vec *position; /* m */
  struct nb_vec *velocity; /* at the half step behind, t_(N-1/2), m/s */
  struct nb_vec *rim; /* R and w R, since every contact reads both: m, m/s; w as old as the velocity, 0 without spin */
  double *spin, *angle;                   /* rad/s, as old as the velocity; rad. NULL in a scene without spin */
  double *mass, *inertia;                 /* kg, kg m2 */
  double *inverse_mass, *inverse_inertia; /* 0 for what is fixed */
  int *material;
  struct nb_vec *searched; /* where they were at the last search */
};

struct nb_walls {
  size_t count;
  struct nb_vec *point;    /* P, m */
  struct nb_vec *along;    /* unit vector along the wall */
  double *h1, *h2;         /* its ends, P + h1 along and P + h2 along, m */
  struct nb_vec *velocity; /* over the step behind; over the one ahead once a stage has begun, m/s */
  struct nb_vec *searched; /* P at the last search */
};

/* A pass of the force half, for each instruction set. */
struct nb_pass {
  const char *name;
  nb_run_pass *run[NB_ISAS];
};
enum { NB_PASSES = 5, NB_THREADS = 256 };

/* Contacts between two materials, or between a material and a wall's: their constants and the passes they need. */
struct nb_pairing {
  struct nb_pair values;               /* first: what laws are given */
  int a, b;                            /* materials; */
  bool wall;                           /* b belongs to walls */
  const struct nb_law *normal, *shear; /* shear NULL: no friction, or none asked for */
  struct nb_planned {
    nb_run_pass *run; /* the form for this machine */
    char name[NB_NAME_SIZE];
    int line; /* of the page that asked for it; 0: it follows from the rest */
  } passes[NB_PASSES];
  int pass_count;
};

/* Every pair that is near: touching, or closer than the skin. Sorted by pairing, then number of a, then of b. */
struct nb_contacts {
  size_t count;
  int *a, *b;              /* slots; a has the smaller number; b a wall's index where the pairing is with walls */
  int *pairing;            /* index */
  struct nb_vec *force;    /* on the first body, dashpots included, N */
  double *kept[NB_FIELDS]; /* the fields that outlive their block, else NULL */
  double *normal_memory[NB_MEMORY], *shear_memory[NB_MEMORY];
};

/* For the motion half: which contacts a body has. */
struct nb_incidence {
  size_t *first;  /* slot -> its first entry; one more than bodies */
  size_t *middle; /* slot -> the first entry in which it is the contact's first body */
  int *entry;     /* contact */
};

struct nb_model {
  const struct nb_scene *scene;
  int threads;
  enum nb_isa isa;
  struct nb_bodies bodies;
  struct nb_walls walls;
  struct nb_pairing *pairings;
  size_t pairing_count;
  struct nb_contacts contacts;
  struct nb_incidence incidence;
  struct nb_view *views; /* one per block */
  size_t view_count;
  double *scratch; /* per thread NB_FIELDS * NB_BLOCK doubles */
  unsigned kept;   /* set of fields that are kept */
  enum nb_field
      drag;      /* the field that holds the shear force which bodies feel: NB_DRAG, or NB_SHEAR without dashpots */
  bool dashpots; /* some stage has contact damping */
  double skin;   /* m: pairs closer than this are listed [R89 TOL] */
  double step, previous_step; /* dt of the step ahead, and of the one behind (0 at the start), s */
  double critical;            /* 2 sqrt(m/k), s */
  struct nb_damping damping;
  unsigned long cycle;
  double time;       /* of cycle 0 of this stage plus its steps, s */
  double stage_time; /* at its begin, s */
  unsigned long stage_cycle;
  unsigned long long updates, searches;
};

/* How much a geometry pass has to find out. */
enum nb_approach { NB_APPROACH_OVERLAP, NB_APPROACH_CLOSING, NB_APPROACH_SLIP };

/* alloc.c: zeroed and aligned for wide loads; NULL only when memory is out. Freed by free(). */
void *nb_array(size_t count, size_t size);

/* plan.c: which passes each pairing needs, and which fields are kept; then the blocks, after each search */
enum nb_status nb_plan(struct nb_model *model, struct nb_error *error);
enum nb_status nb_plan_views(struct nb_model *model, struct nb_error *error);

/* names.c: fields that some column or condition of the scene reads */
unsigned nb_fields_watched(const struct nb_scene *scene);

/* near.c: makes the list of contacts anew; an error when a body is nowhere */
enum nb_status nb_near(struct nb_model *model, struct nb_error *error);

/* contacts.c */
long nb_contacts_find(const struct nb_model *model, int a, int b, bool wall); /* of two slots; -1: not near */
void nb_contacts_free(struct nb_contacts *contacts);

/* step.c */
double nb_step_critical(const struct nb_model *model);
enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error);

/* motion.c */
/* Both answer how many bodies or walls are farther from where the last search found them than half the skin, or nowhere. */
int nb_motion_part(struct nb_model *model, int part, int parts);
int nb_motion_walls(struct nb_model *model);
struct nb_force {
  struct nb_vec force; /* N */
  double moment;       /* N m, counterclockwise */
};
struct nb_force nb_force_on(const struct nb_model *model, size_t slot); /* sum over its contacts, N, N m */
struct nb_state {
  struct nb_vec velocity;
  double spin;
};
struct nb_state nb_velocity_now(const struct nb_model *model,
                                size_t slot); /* at t_N: mean of the half steps [CS79 31] */

/* passes */
extern const struct nb_pass nb_pass_disc_disc[3], nb_pass_disc_wall[3]; /* by enum nb_approach */
extern const struct nb_pass nb_pass_dashpots;
extern const struct nb_pass nb_pass_resolve[2]; /* without and with shear */
/* What a contact's dashpots are: D_n = time k_n dn/dt + ratio sqrt(M* k_n) dn/dt. */
struct nb_dashpot {
  double time, ratio;
};
struct nb_dashpot nb_dashpot(const struct nb_model *model);

/* cycle.c: the force half, for positions as they are */
void nb_forces(struct nb_model *model);

#endif
