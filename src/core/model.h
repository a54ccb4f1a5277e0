/* What runs: a scene made into arrays and a plan. Inside the library only; users see `struct nb_model` as a name.
 *
 * A body's slot is where its numbers are stored, its number (1, 2, ...) is what it is called for ever. Results depend on
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
#include "joints.h"
#include "laws/law.h"
#include "laws/laws_now.h"
#include "run/impact.h"
#include "tensor.h"
#include "vec.h"
#include "walls.h"

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
  struct nb_vec *carried;  /* c, the part of the velocity that carries it along, m/s; NULL: nothing does (carry.h) */
  bool *gone;              /* taken out of the scene (remove.c); NULL where no stage takes any out */
};

/* How a body or a wall moves. */
struct nb_state {
  struct nb_vec velocity;
  double spin;
};

/* A pass of the force half, for each instruction set. */
struct nb_pass {
  const char *name;
  nb_run_pass *run[NB_ISAS];
};
enum { NB_PASSES = 7, NB_THREADS = 256, NB_THREAD_SHARE = 128 };

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
  struct nb_pair coming;             /* values at the next forces, */
  const struct nb_law *coming_shear; /* and the law that they ask for: for stable.c */
};

/* Materials and pairs as they are now; stages change them. */
struct nb_properties {
  struct nb_material *materials; /* as the scene's; */
  struct nb_pair_rule *rules;    /* the scene's and those that stages have added */
  size_t rule_count;
  double pieces; /* of struct nb_pair; the same for all pairs */
};

/* A contact's springs, N/m, and dashpots, N s/m. */
struct nb_stiff {
  double kn, ks, cn, cs;
};

struct nb_model {
  const struct nb_scene *scene;
  const char *states; /* folder of saved states; NULL: the usual one */
  int threads;        /* there may be */
  int busy;           /* threads that work on as many contacts as there are now, NB_THREAD_SHARE each or more */
  enum nb_isa isa;
  struct nb_bodies bodies;
  struct nb_walls walls;
  struct nb_cell *cell; /* NULL: the plane has no copies */
  struct nb_pairing *pairings;
  size_t pairing_count;
  struct nb_contacts contacts;
  struct nb_incidence incidence;
  struct nb_view *views; /* one per block */
  size_t view_count;
  double smallest;             /* radius of all particles, m */
  double fracc, *fracc_before; /* fracc.c: of the cycle behind; per slot |SF| then, N; NULL: nobody asks */
  struct nb_deep {
    unsigned long *counts;        /* per block since the last search, NB_DEEP_APART apart; NULL: nothing is elastic */
    unsigned long long count;     /* contact updates too deep until then */
    char first[3 * NB_NAME_SIZE]; /* the first of them, in words; empty: none yet */
  } deep;
  struct nb_sure {
    double overlap;      /* the smallest of a block's NB_SURE, m */
    unsigned long above; /* its contacts that are deeper than theirs */
    double apart[6];     /* those of two threads lie in lines of their own */
  } * sure;              /* per block; NULL: nothing that is watched gets stiffer */
  double *scratch;       /* per thread NB_FIELDS * NB_BLOCK doubles */
  unsigned kept;         /* set of fields that are kept */
  enum nb_field drag;    /* holds the shear force that bodies feel: NB_DRAG, or NB_SHEAR without dashpots */
  bool whole;            /* of contacts all is kept that a saved state holds */
  bool keeping;          /* no forces follow the search to come: contacts keep those that they have */
  bool rubs;             /* some pairing has a shear law now */
  bool joined;           /* two walls have a common end */
  bool pressed;  /* at the last search some centre was within the skin of a wall: it may cross it before the next one */
  bool squeezed; /* and some pair was within the skin of the overlap that guard.c allows */
  bool coarse;   /* positions are too coarse for the overlaps, and the warning has been given */
  bool dashpots; /* some stage has contact damping */
  size_t wall_contacts;    /* the first contact with a wall: they are the last ones of the list */
  struct nb_joint *joints; /* where a disc may touch a common end of two walls before the next search */
  size_t joint_count, joint_capacity;
  double skin; /* m: pairs closer than this are listed [R89 TOL]; infinite: nothing can touch, nothing is searched */
  double step, previous_step; /* dt of the step ahead, and of the one behind (0 at the start), s */
  int step_line;              /* of the statement that says how long a step is; -1: none has been worked out yet */
  double critical;            /* 2 sqrt(m/k), s */
  double safe;                /* largest step sure to be stable as this stage began, s */
  struct nb_load *loads;      /* per slot, and */
  struct nb_stiff *stiff;     /* per contact, room for stable.c */
  bool allow_unstable;        /* the step is not watched now */
  struct nb_damping damping, damping_before; /* of this stage; of the one before */
  struct nb_vec gravity;                     /* over the kick to come, m/s2 */
  struct nb_inward {
    double strength;      /* m/s2; 0: none */
    struct nb_vec to;     /* the point, m */
  } inward;               /* likewise */
  bool boxed;             /* the walls of the box follow its strain rate */
  struct nb_carry *carry; /* carry.h; NULL: nothing is carried along */
  struct nb_drive *drive; /* drive.h; NULL: there is no boundary, and bodies turn */
  struct nb_properties properties;
  struct nb_in_force laws, coming; /* of the forces behind, and of those ahead: a stage may change them */
  const struct nb_stage *stage;    /* the one that runs, NULL before the first */
  bool changing, driven;           /* it still changes properties or gravity; it ramps velocities of walls */
  struct nb_pair *properties_from; /* per change, wall motion, and of gravity: what it was when the stage began */
  struct nb_state *walls_from;
  struct nb_vec gravity_from;
  struct nb_inward inward_from;
  struct nb_warnings warnings; /* of this model, not of its scene */
  unsigned long cycle;
  double time, stage_time; /* of cycle 0 of this stage plus its steps; at its begin; s */
  double touch;            /* when what `impact` makes first touches, s */
  unsigned long stage_cycle;
  unsigned long looks;                              /* how often the watch has worked out the safe step */
  unsigned long long updates, searches, candidates; /* candidates: pairs whose distance a search has measured */
  struct nb_balance *balance;                       /* energy.h; NULL: no column and no condition asks for one */
  struct nb_regions *regions;                       /* region.h; NULL: the scene has none */
  struct nb_since *since;                           /* since.h; NULL: no snapshot asks what has changed */
};

/* How much a geometry pass has to find out. */
enum nb_approach { NB_APPROACH_OVERLAP, NB_APPROACH_CLOSING, NB_APPROACH_SLIP };
/* What dashpots of some stage go with: k alone; sqrt(M* k) too; and whether the contact is deep. */
enum nb_dashpots { NB_DASHPOTS_TIME, NB_DASHPOTS_SWING, NB_DASHPOTS_DEEP };

/* machine.c: instruction set and threads, as the options say */
enum nb_status nb_machine_choose(struct nb_model *model, const struct nb_options *options, struct nb_error *error);

/* plan.c: which passes each pairing needs, and which fields are kept; then the blocks, after each search */
enum nb_status nb_plan(struct nb_model *model, struct nb_error *error);
enum nb_status nb_plan_views(struct nb_model *model, struct nb_error *error);
bool nb_plan_stands(const struct nb_model *model); /* whether it is still the one that the pairings' values ask for */

struct nb_saved;
/* The same as nb_model_create, from a state instead of what the page says of bodies and walls; NULL: from the page. The state is
 * that of the scene's stage `begun - 1`. */
struct nb_model *nb_model_resume(const struct nb_scene *scene, const struct nb_options *options,
                                 const struct nb_saved *saved, struct nb_error *error);

/* observe.c: fields that some column or condition of the scene reads, and what else is to be kept for it: */
#define NB_ASKS_FRACC (1u << 27)  /* fracc.c */
#define NB_ASKS_STRAIN (1u << 28) /* strain.c */
#define NB_ASKS_WORK (1u << 29)   /* the work balance, energy.h */
#define NB_ASKS_ENERGY (1u << 30) /* the energy balance */
#define NB_ASKS_STORED (1u << 31) /* energies that only a law with stored energy has */
unsigned nb_fields_watched(const struct nb_scene *scene);

/* region.c */
double nb_thickness(const struct nb_model *model); /* of discs 1 m, of spheres the mean diameter, m */

/* guard.c: particles do not pass through each other, or through walls */
bool nb_guard_turns(const struct nb_model *model, size_t wall, double angle); /* too far for one step, rad */
/* NB_BROKEN when a position is NaN or infinite; when a particle moved, or a wall turned, too far in the step behind. */
enum nb_status nb_guard_positions(const struct nb_model *model, struct nb_error *error);
enum nb_status nb_guard_motion(const struct nb_model *model, struct nb_error *error);
/* An error when a listed pair of particles overlaps by more than the smaller radius. */
enum nb_status nb_guard_pairs(const struct nb_model *model, struct nb_error *error);

/* All that must be asked in a cycle without a search. */
enum nb_status nb_guard_cycle(const struct nb_model *model, struct nb_error *error);

/* Warns when positions are too coarse for the overlaps that there are now. */
void nb_guard_digits(struct nb_model *model);

/* near.c: makes the list of contacts anew, if no guard objects */
enum nb_status nb_near(struct nb_model *model, struct nb_error *error);

/* properties.c */
bool nb_properties_create(struct nb_properties *now, const struct nb_scene *scene); /* as at time 0 */
void nb_properties_free(struct nb_properties *now);
struct nb_pair nb_properties_pair(const struct nb_properties *now, int material_a, int material_b);
/* What is now of the material or the pair that a change is about. */
struct nb_pair nb_properties_before(const struct nb_properties *now, const struct nb_change *change);
/* Makes what the change is about `share` (0 to 1) of its way from `from`. */
void nb_properties_change(struct nb_properties *now, const struct nb_change *change, struct nb_pair from, double share);

/* stage.c */
enum nb_status nb_stage_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
void nb_stage_drive(struct nb_model *model); /* before the motion: velocities of walls over the step to come */
/* After it: properties and gravity at the time that has been reached. *searched: contacts have been looked for anew. */
enum nb_status nb_stage_change(struct nb_model *model, bool *searched, struct nb_error *error);

/* remove.c */
enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
bool nb_gone(const struct nb_model *model, size_t slot);

/* motion.c */
/* Both answer how many bodies or walls are farther from where the last search found them than half the skin, or nowhere. */
int nb_motion_part(struct nb_model *model, int part, int parts);
int nb_motion_walls(struct nb_model *model);    /* walls.c */
void nb_motion_reverse(struct nb_model *model); /* bodies go back the way they came; once the step ahead is known */
struct nb_force {
  struct nb_vec force; /* N */
  double moment;       /* N m, counterclockwise */
};
struct nb_force nb_force_on(const struct nb_model *model, size_t slot);      /* sum over its contacts, N, N m */
struct nb_state nb_velocity_half(const struct nb_model *model, size_t slot); /* at the half step behind, likewise */
struct nb_state nb_velocity_now(const struct nb_model *model,
                                size_t slot); /* at t_N: mean of the half steps [CS79 31]; without what carries it */
struct nb_vec nb_carried_now(const struct nb_model *model, size_t slot);    /* what carries it, likewise, m/s */
struct nb_vec nb_velocity_whole(const struct nb_model *model, size_t slot); /* with what carries it, likewise, m/s */

struct nb_vec nb_weight(const struct nb_model *model, size_t slot, struct nb_vec x); /* m g, were the body at x, N */
struct nb_vec nb_force_left(const struct nb_model *model, size_t slot);              /* all that a free body feels, N */

/* Gives a body what a force and a moment that end at t_N have done until then: its velocities at t_N stay what they were. */
void nb_motion_begin(struct nb_model *model, size_t slot, struct nb_state now);
void nb_motion_release(struct nb_model *model, size_t slot, struct nb_force ending);

/* walls.c */
void nb_walls_searched(struct nb_walls *walls); /* remembers where their ends are now */
/* NB_BROKEN when the centre of a body has crossed a wall in the step behind: of the pairs listed, or of all there are. */
enum nb_status nb_walls_crossed(const struct nb_model *model, bool all, struct nb_error *error);

/* passes */
extern const struct nb_pass nb_pass_disc_disc[3], nb_pass_periodic[3], nb_pass_disc_wall[3]; /* by enum nb_approach */
extern const struct nb_pass nb_pass_joints;
extern const struct nb_pass nb_pass_deep;
extern const struct nb_pass nb_pass_dashpots[3]; /* by enum nb_dashpots */
extern const struct nb_pass nb_pass_resolve[2];  /* without and with shear */
/* What a contact's dashpots are: D_n = time k_n dn/dt + ratio sqrt(M* k_n) dn/dt. */
struct nb_dashpot {
  double time, ratio;
};
struct nb_dashpot nb_dashpot(const struct nb_model *model, bool wall);

/* deep.c: overlaps that are too deep for elastic spheres */
enum { NB_DEEP_APART = 8 };                                /* counts of two threads lie in lines of their own */
double nb_deep_share(const struct nb_model *model);        /* of the smaller diameter: the page's, or 7 % [R89 6.4.3] */
bool nb_deep_begin(struct nb_model *model, size_t blocks); /* counts anew, after a search; false: no memory */
void nb_deep_end(struct nb_model *model);                  /* nothing is elastic any more */
void nb_deep_look(struct nb_model *model);                 /* after the forces: which is the first */
bool nb_deep_is(const struct nb_model *model, size_t contact);
unsigned long long nb_deep_count(const struct nb_model *model);

/* watch.c: whether the step is still sure to be stable */
bool nb_sure_begin(struct nb_model *model, size_t blocks); /* after a search; false: no memory */
void nb_sure_end(struct nb_model *model);                  /* the laws do not stiffen any more */
bool nb_sure_all(struct nb_model *model);                  /* after the forces: no contact is deeper than its NB_SURE */
/* NB_BROKEN when the step is above the safe one, unless the page allows it; what is sure from there on. */
enum { NB_WATCH_CYCLES = 1000 }; /* between two looks without a search */
enum nb_status nb_stable_watch(struct nb_model *model, struct nb_error *error);
struct nb_safe; /* the same as a stage begins, for pairs that are apart too: step.h */
enum nb_status nb_stable_begin(struct nb_model *model, const struct nb_safe *apart, struct nb_error *error);

/* cycle.c: the force half, for positions as they are */
void nb_forces(struct nb_model *model);

#endif
