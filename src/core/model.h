/* What runs: a scene made into arrays and a plan. Inside the library only; users see `struct nb_model` as a name.
 *
 * A body's slot is where its numbers are stored, its number (1, 2, ...) never changes. Results depend on
 * numbers alone: sums over a body's contacts run in the order of the other body's number, walls last, so neither storage
 * order nor search nor threads change a bit of them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_MODEL_H
#define NB_MODEL_H

#include "array.h"
#include "block.h"
#include "cell.h"
#include "contacts.h"
#include "energy_terms.h"
#include "tensor.h"
#include "vec.h"
#include "walls.h"

/* What a contact reads of a particle besides position and velocity. */
struct nb_surface {
  double radius, speed; /* R, m; w R, m/s: w as old as the velocity, 0 without rotation */
};
static inline struct nb_surface nb_surface(double radius, double speed) { return (struct nb_surface){radius, speed}; }

struct nb_particles {
  size_t count;
  int *number;                            /* slot -> number */
  int *slot;                              /* number - 1 -> slot */
  struct nb_vec *position;                /* m */
  struct nb_vec *velocity;                /* at the half step behind, t_(N-1/2), m/s */
  struct nb_surface *surface;             /* radius and surface speed */
  double *spin, *angle;                   /* rad/s, as old as the velocity; rad. NULL in a scene without spin */
  double *mass, *inertia;                 /* kg, kg m2 */
  double *inverse_mass, *inverse_inertia; /* 0 for what is fixed */
  int *material;
  struct nb_vec *search_position; /* where they were at the last search */
  struct nb_vec *imposed; /* c, the part of the velocity that carries it along, m/s; NULL: nothing does (affine.h) */
  const struct nb_vec
      *boundary_force; /* per slot: force of a stress on the boundary, N; NULL: there is none (loading/boundary.c) */
  bool *removed;       /* taken out of the scene (remove.c); NULL where no stage takes any out */
};

/* How a body or a wall moves. */
struct nb_velocities {
  struct nb_vec velocity;
  double spin;
};

/* A pass of the force half, for each instruction set. */
struct nb_pass {
  const char *name;
  nb_run_pass *run[NB_ISAS];
};
enum { NB_PASSES = 7, NB_THREADS = 256, NB_CONTACTS_PER_THREAD = 128 };

/* Contacts between two materials, or between a material and a wall's: their constants and the passes they need. */
struct nb_material_pair {
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
  struct nb_pair next;             /* values at the next forces, */
  const struct nb_law *next_shear; /* and the law that they ask for: for stable_step.c */
};

/* Materials and pairs as they are now; stages change them. */
struct nb_properties {
  struct nb_material *materials; /* as the scene's; */
  struct nb_pair_rule *rules;    /* the scene's and those that stages have added */
  size_t rule_count;
  double pieces; /* of struct nb_pair; the same for all pairs */
};

/* The laws that all contacts follow. */
struct nb_active_laws {
  const struct nb_law *normal, *shear;
  int normal_line, shear_line; /* of the page that says so; 0: none */
  double pieces;               /* as struct nb_pair has it */
};

/* What of the machine is used: machine.c. */
struct nb_machine {
  enum nb_isa isa;
  int threads;      /* there may be */
  int threads_used; /* threads that work on as many contacts as there are now, NB_CONTACTS_PER_THREAD each or more */
};

/* What contacts need now, as run/plan.c finds it. */
struct nb_plan {
  unsigned requested;        /* set of fields, and of NB_ASKS_, that columns and conditions read */
  unsigned kept;             /* set of fields that are kept */
  enum nb_field total_shear; /* holds the shear force that bodies feel: NB_DRAG, or NB_SHEAR without dashpots */
  struct {
    int normal, shear, slip_sum;
  } history;         /* doubles that a contact remembers: for its laws, and for configuration.c */
  bool keep_all;     /* all is kept that a saved state holds */
  bool elastic;      /* the normal law is one of elastic spheres */
  bool has_friction; /* some pairing has a shear law now */
  bool dashpots;     /* some stage has contact damping */
};

/* A contact's springs, N/m, and dashpots, N s/m. */
struct nb_coefficients {
  double kn, ks, cn, cs;
};

/* What the force calculation goes through: blocks.c. */
struct nb_blocks {
  struct nb_block *list; /* one per block */
  size_t count;
  double *scratch; /* per thread NB_FIELDS * NB_BLOCK doubles */
  struct nb_stable_overlap {
    double overlap;                     /* the smallest of a block's NB_SURE, m */
    unsigned long above;                /* its contacts that are deeper than theirs */
    double padding[6];                  /* those of two threads lie in lines of their own */
  } * stable_overlap;                   /* per block; NULL: nothing that is watched gets stiffer */
  struct nb_coefficients *coefficients; /* per contact: room for measure/stable_step.c */
};

/* The search for near pairs, and what it has found: neighbours.c, guard.c. */
struct nb_search {
  double
      skin; /* m: pairs closer than this are listed [R89 TOL]; infinite: nothing can touch, nothing is search_position */
  double smallest_radius;               /* radius of all particles, m */
  unsigned long last_cycle;             /* the cycle in which the list was made */
  unsigned long long count, candidates; /* searches; pairs whose distance they have measured */
  bool keep_forces;                     /* no forces follow the search to come: contacts keep those that they have */
  bool check_walls;   /* some centre was within the skin of a wall: it may cross it before the next search */
  bool check_pairs;   /* some pair was within the skin of the overlap that guard.c allows */
  bool coarse_warned; /* positions are too coarse for the overlaps, and the warning has been given */
};

/* Where a disc may touch a common end of two walls. */
struct nb_vertex {
  int c, d;       /* contacts of one body with two walls */
  int at_c, at_d; /* which end of each wall is their common one, 0 or 1 */
};
struct nb_vertices {
  bool any;               /* two walls have a common end */
  struct nb_vertex *list; /* where a disc may touch one before the next search */
  size_t count;
};

/* Something optional that a cycle does, in its place: what a scene does not use is not in the list. Made by run/hooks.c. */
enum nb_when {
  NB_BEFORE_MOTION, /* loads for the step ahead */
  NB_AFTER_MOTION,  /* while the forces and steps are still those of the kick */
  NB_BEFORE_SEARCH, /* positions and time are those of the forces to come */
  NB_BEFORE_FORCES, /* and the list of contacts is too */
  NB_AFTER_FORCES,
  NB_WHENS
};
enum { NB_HOOKS = 8 };
struct nb_hooks {
  size_t count;
  struct nb_hook {
    const char *name;
    enum nb_status (*run)(struct nb_model *model, struct nb_error *error);
  } list[NB_HOOKS];
};

/* A run. Each part has one owner, which alone changes it. */
struct nb_model {
  const struct nb_scene *scene;
  struct nb_owner owner; /* of all that is made once and lives as long as the model */
  struct nb_machine machine;
  struct nb_particles particles;    /* motion.c */
  struct nb_walls walls;            /* walls.c */
  struct nb_cell *cell;             /* cell.c; NULL: the plane has no copies */
  struct nb_vertices vertices;      /* wall_vertices.c */
  struct nb_properties properties;  /* properties.c */
  struct nb_active_laws laws, next; /* of the forces behind, and of those ahead: a stage may change them (laws_now.c) */
  struct nb_material_pair *material_pairs; /* plan.c */
  size_t material_pair_count;
  struct nb_plan plan;
  struct nb_search search;
  struct nb_contacts contacts; /* contacts.c */
  struct nb_blocks blocks;
  struct nb_hooks hooks[NB_WHENS];

  unsigned long cycle;        /* cycle.c, from here */
  unsigned long stage_cycle;  /* since the stage began */
  double stage_time, time;    /* at the begin of the stage; plus its cycles times the step, s */
  double step, previous_step; /* dt of the step ahead, and of the one behind (0 at the start), s */
  unsigned long long updates; /* of contacts; to here */
  double critical;            /* 2 sqrt(m/k), s (measure/step.c) */

  const struct nb_stage *stage;              /* run/stage.c, from here: the one that runs, NULL before the first */
  struct nb_changes *changes;                /* what it changes little by little */
  struct nb_damping damping, damping_before; /* of this stage; of the one before */
  struct nb_vec gravity;                     /* over the kick to come, m/s2 */
  struct nb_central {
    double acceleration; /* m/s2; 0: none */
    struct nb_vec point; /* the point, m */
  } central;             /* likewise; to here */

  struct nb_affine *affine;           /* affine.h; NULL: nothing is carried along */
  struct nb_boundary_state *boundary; /* boundary.h; NULL: there is no boundary, and bodies turn */
  struct nb_stability *stability;     /* measure/step.h */
  struct nb_sum *terms;               /* core/energy_terms.h, NB_TERMS of them; NULL: no column and no condition asks */
  struct nb_balance *balance;         /* measure/energy.h; NULL: no column and no condition asks for one */
  struct nb_regions *regions;         /* measure/region.h; NULL: the scene has none */
  struct nb_configuration *configuration; /* measure/configuration.h; NULL: no snapshot asks what has changed */
  struct nb_fracc *fracc;                 /* measure/fracc.c; NULL: nobody asks */
  struct nb_deep {
    unsigned long *counts;        /* per block since the last search, NB_DEEP_STRIDE apart; NULL: nothing is elastic */
    unsigned long long count;     /* contact updates too deep until then */
    char first[3 * NB_NAME_SIZE]; /* the first of them, in words; empty: none yet */
  } deep;                         /* deep.c */
  struct nb_warnings warnings;    /* of this model, not of its scene */
  double impact_time;             /* when what `impact` makes first touches, s (measure/impact.c) */
  const char *states;             /* folder of saved states; NULL: the usual one (run/restart.c) */
};

/* machine.c: instruction set and threads, as the options say */
enum nb_status nb_machine_choose(struct nb_model *model, const struct nb_options *options, struct nb_error *error);

/* blocks.c: the contacts in blocks of one pairing, after each search */
enum nb_status nb_blocks_create(struct nb_model *model, struct nb_error *error);

/* What columns and conditions ask for besides fields, in model->plan.asked: */
#define NB_REQUEST_FRACC (1u << 27)  /* fracc.c */
#define NB_REQUEST_STRAIN (1u << 28) /* strain.c */
#define NB_REQUEST_WORK (1u << 29)   /* the work balance, energy.h */
#define NB_REQUEST_ENERGY (1u << 30) /* the energy balance */
#define NB_REQUEST_STORED (1u << 31) /* energies that only a law with stored energy has */

/* Whether a stage has taken it out of the scene (loading/remove.c). */
static inline bool nb_removed(const struct nb_model *model, size_t slot) {
  return model->particles.removed && model->particles.removed[slot];
}

/* materials.c */
double nb_particle_mass(const struct nb_scene *scene, const struct nb_particle *particle);    /* kg */
double nb_particle_inertia(const struct nb_scene *scene, const struct nb_particle *particle); /* kg m2 */
double nb_thickness(const struct nb_model *model); /* of discs 1 m, of spheres the mean diameter, m */

/* guard.c: particles do not pass through each other, or through walls */
/* NB_BROKEN when a position is NaN or infinite; when a particle moved, or a wall turned, too far in the step behind. */
enum nb_status nb_guard_positions(const struct nb_model *model, struct nb_error *error);
enum nb_status nb_guard_motion(const struct nb_model *model, struct nb_error *error);
/* An error when a listed pair of particles overlaps by more than the smaller radius. */
enum nb_status nb_guard_pairs(const struct nb_model *model, struct nb_error *error);

/* All that must be asked in a cycle without a search. */
enum nb_status nb_guard_cycle(const struct nb_model *model, struct nb_error *error);

/* Warns when positions are too coarse for the overlaps that there are now. */
void nb_guard_resolution(struct nb_model *model);

/* neighbours.c: makes the list of contacts anew, if no guard objects */
enum nb_status nb_neighbours_search(struct nb_model *model, struct nb_error *error);

/* motion.c */
/* Both answer how many bodies or walls are farther from where the last search found them than half the skin, or nowhere. */
int nb_motion_part(struct nb_model *model, int part, int parts);
int nb_motion_walls(struct nb_model *model);    /* walls.c */
void nb_motion_reverse(struct nb_model *model); /* bodies go back the way they came; once the step ahead is known */
struct nb_force {
  struct nb_vec force; /* N */
  double moment;       /* N m, counterclockwise */
};
struct nb_force nb_force_on(const struct nb_model *model, size_t slot); /* sum over its contacts, N, N m */
struct nb_velocities nb_velocity_half(const struct nb_model *model,
                                      size_t slot); /* at the half step behind, likewise */
struct nb_velocities
nb_velocity_now(const struct nb_model *model,
                size_t slot); /* at t_N: mean of the half steps [CS79 31]; without what carries it */
struct nb_vec nb_imposed_now(const struct nb_model *model, size_t slot);    /* what carries it, likewise, m/s */
struct nb_vec nb_velocity_total(const struct nb_model *model, size_t slot); /* with what carries it, likewise, m/s */

struct nb_vec nb_weight(const struct nb_model *model, size_t slot, struct nb_vec x); /* m g, were the body at x, N */
struct nb_vec nb_unbalanced_force(const struct nb_model *model, size_t slot);        /* all that a free body feels, N */

/* Gives a body what a force and a moment that end at t_N have done until then: its velocities at t_N stay what they were. */
void nb_motion_set_velocity(struct nb_model *model, size_t slot, struct nb_velocities now);
void nb_motion_offset_force(struct nb_model *model, size_t slot, struct nb_force ending);

/* walls.c */
bool nb_rotates_too_far(const struct nb_model *model, size_t wall, double angle); /* too far for one step, rad */
void nb_walls_reset_travel(struct nb_walls *walls); /* remembers where their ends are now */
/* NB_BROKEN when the centre of a body has crossed a wall in the step behind: of the pairs listed, or of all there are. */
enum nb_status nb_walls_crossed(const struct nb_model *model, bool all, struct nb_error *error);

/* wall_vertices.c */
bool nb_vertices_exist(const struct nb_scene *scene); /* two walls have a common end */
bool nb_vertices_find(struct nb_model *model);        /* after a search; false: no memory */
void nb_vertices_suppress(struct nb_model *model);    /* before the forces: which contacts are muted now */

/* deep.c: overlaps that are too deep for elastic spheres */
enum { NB_DEEP_STRIDE = 8 };                               /* counts of two threads lie in lines of their own */
double nb_deep_fraction(const struct nb_model *model);     /* of the smaller diameter: the page's, or 7 % [R89 6.4.3] */
bool nb_deep_begin(struct nb_model *model, size_t blocks); /* counts anew, after a search; false: no memory */
void nb_deep_end(struct nb_model *model);                  /* nothing is elastic any more */
void nb_deep_record_first(struct nb_model *model);         /* after the forces: which is the first */
bool nb_is_deep(const struct nb_model *model, size_t contact);
unsigned long long nb_deep_count(const struct nb_model *model);

/* cycle.c: the force calculation, for positions as they are */
void nb_forces(struct nb_model *model);

#endif
