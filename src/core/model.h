/* The state of a running simulation: the scene's data as arrays, and the planned passes. Internal to the library; for
 * users `struct nb_model` is an opaque type.
 *
 * A particle's slot is the index of its data in the arrays; its number (1, 2, ...) never changes. Results depend on
 * numbers only. Sums over a particle's contacts run in the order of the partners' numbers, walls last. So storage
 * order, searches and threads do not change a bit of the sums.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <limits.h>

#include "array.h"
#include "block.h"
#include "cell.h"
#include "contacts.h"
#include "energy_terms.h"
#include "tensor.h"
#include "vec.h"
#include "walls.h"

/* Velocity, m/s, and angular velocity, rad/s, of a particle or a wall. */
struct nb_velocities {
  struct nb_vec velocity;
  double spin;
  double filling; /* 0; fills the place that alignment leaves empty, because checkpoints contain the whole structure */
};

struct nb_particles {
  size_t count;
  int *number;                            /* number of the particle in each slot */
  int *slot;                              /* slot of each particle; index: its number - 1 */
  struct nb_vec *position;                /* m */
  struct nb_vec *velocity;                /* at the last half step, t_(N-1/2), m/s */
  double *radius;                         /* m */
  double *surface_speed;                  /* R omega at t_(N-1/2), m/s; 0 without rotation */
  double *spin, *angle;                   /* omega at t_(N-1/2), rad/s; rotation at t_N, rad. NULL without rotation */
  double *mass, *inertia;                 /* kg; kg m2 */
  double *inverse_mass, *inverse_inertia; /* 0 for fixed particles */
  int *material;
  struct nb_vec *search_position; /* positions at the last search, m */
  struct nb_velocities *ahead;    /* changes of velocity and of surface speed from t_(N-1/2) to t_N, m/s, predicted from
                                     * the last acceleration, for centred dashpots; NULL: no stage needs them */
  struct nb_vec *imposed;         /* c, the affine part of the velocity, m/s; NULL: none (affine.h) */
  const struct nb_vec *boundary_force; /* force of a boundary stress, N; NULL: none (loading/boundary.c) */
  bool *removed;                       /* removed from the scene (remove.c); NULL when no stage removes any */
};

/* M*, the reduced mass of the particles in the slots i and j, kg [R89 4.6]; if j < 0, of particle i and a wall. */
static inline double nb_reduced_mass(const struct nb_particles *particles, int i, int j) {
  return 1 / (particles->inverse_mass[i] + (j < 0 ? 0 : particles->inverse_mass[j]));
}

/* A pass of the force calculation, compiled for each instruction set. */
struct nb_pass {
  const char *name;
  nb_run_pass *run[NB_ISAS];
};
/* The most passes of a material pair, the most threads, and the least number of contacts of a thread. */
enum { NB_PASSES = 7, NB_THREADS = 256, NB_CONTACTS_PER_THREAD = 128 };
/* Parts into which the work of a cycle is divided: team.c. */
enum { NB_PARTS_PER_THREAD = 4, NB_MOST_PARTS = NB_THREADS * NB_PARTS_PER_THREAD };

/* The contacts between two materials, or between particles and walls of two materials: their parameters and passes. */
struct nb_material_pair {
  struct nb_pair values;               /* must be first: the parameters that laws read */
  int a, b;                            /* indices of the materials */
  bool wall;                           /* b is the material of walls */
  const struct nb_law *normal, *shear; /* shear NULL: no friction and no cohesion, or law `none` */
  struct nb_planned {
    nb_run_pass *run; /* compiled for the selected instruction set */
    char name[NB_NAME_SIZE];
    int line; /* line of the page that requires the pass; 0: another part of the scene requires it */
  } passes[NB_PASSES];
  int pass_count;
  struct nb_pair next;             /* parameters of the next force calculation: stable_step.c */
  const struct nb_law *next_shear; /* shear law of the next force calculation */
};

/* The current materials and pairs; stages change them. */
struct nb_properties {
  struct nb_material *materials; /* initially the materials of the scene */
  struct nb_pair_rule *rules;    /* rules of the scene, and rules that stages have added */
  size_t rule_count;
  double pieces; /* as in struct nb_pair; the same for all pairs */
};

/* The laws of all contacts. */
struct nb_active_laws {
  const struct nb_law *normal, *shear;
  int normal_line, shear_line; /* lines of the page; 0: none */
  double pieces;               /* as in struct nb_pair */
};

/* Use of the processor: machine.c. */
struct nb_machine {
  enum nb_isa isa;
  int threads;          /* upper limit */
  int threads_used;     /* threads in use now; of several, each has at least NB_CONTACTS_PER_THREAD contacts */
  struct nb_team *team; /* the threads; NULL: there never were several, or memory ran out */
  struct nb_rounding rounding;
};

/* Number of parts of the work of a cycle: several for each thread, so that a thread can take over those of another. */
static inline size_t nb_parts(int threads) { return threads > 1 ? (size_t)threads * NB_PARTS_PER_THREAD : 1; }
static inline size_t nb_most_parts(const struct nb_machine *machine) { return nb_parts(machine->threads); }

/* What the current stage requires of the contacts; run/plan.c determines it. */
struct nb_plan {
  unsigned requested; /* fields and NB_REQUEST_ bits that columns and conditions read */
  unsigned kept;      /* set of fields that are kept for all contacts */
  struct {
    int normal, shear, slip_sum;
  } history;         /* doubles per contact: histories of the two laws, sliding displacements for configuration.c */
  bool keep_all;     /* keep all fields that a saved state contains */
  bool elastic;      /* the normal law is for elastic spheres */
  bool has_friction; /* some material pair has a shear law now */
  bool rotates;      /* in this stage some particle rotates, or may begin to */
  unsigned dashpots; /* enum nb_dashpot_kind of pass/pass.h; 0: no contact damping */
  bool centred;      /* these dashpots use the velocity at t_N */
  bool affine_twice; /* the affine part is added to relative velocities again: pass/affine_twice.c */
};

/* Stiffnesses of a contact, N/m, and dashpot coefficients, N s/m. */
struct nb_coefficients {
  double kn, ks, cn, cs;
};

/* The blocks of the force calculation: blocks.c. */
struct nb_blocks {
  struct nb_block *list; /* one per block */
  size_t count;
  double *scratch; /* NB_FIELDS * NB_BLOCK_SIZE doubles for each part of the work of a cycle */
  struct nb_stable_overlap {
    double overlap;      /* smallest NB_STABLE_OVERLAP of the block, m */
    unsigned long above; /* number of contacts that overlap by more than their NB_STABLE_OVERLAP */
    double padding[6];   /* two threads must not write to the same cache line */
  } * stable_overlap;    /* for each block; NULL: no checked contact stiffens with overlap */
};

/* Two particles, as slots, and their overlap, m. */
struct nb_close_pair {
  int a, b;
  double overlap;
};

/* The neighbour search and its results: neighbours.c, guard.c. */
struct nb_search {
  double skin; /* pairs closer than this are listed, m [R89 TOL]; infinite: no pair can touch, and there is no search */
  double smallest_radius;               /* of all particles, m */
  unsigned long last_cycle;             /* cycle of the last search */
  unsigned long long count, candidates; /* number of searches; number of distances between particles computed in them */
  bool keep_forces; /* contacts keep their forces in the next search, because no force calculation follows it */
  bool check_walls; /* a centre was within the skin of a wall: test crossings in every cycle */
  bool check_pairs; /* a pair was within the skin of the overlap limit of guard.c: test pairs in every cycle */
  struct nb_close_pair too_deep; /* the first pair of this search beyond the overlap limit; overlap 0: no such pair */
  bool coarse_warned;            /* the warning about coarse positions has been given */
};

/* A vertex, the common end of two walls, that a disc may touch. */
struct nb_vertex {
  int c, d;       /* the contacts of one particle with the two walls */
  int at_c, at_d; /* the end of each wall that is at the vertex, 0 or 1 */
};
struct nb_vertices {
  bool any;               /* two walls have a common end */
  struct nb_vertex *list; /* vertices that a disc may touch before the next search */
  size_t count;
};

/* Hooks are optional actions at fixed places of a cycle. run/hooks.c lists those that the scene uses. */
enum nb_when {
  NB_BEFORE_MOTION, /* sets the loading for the next step */
  NB_AFTER_MOTION,  /* forces and time step are still those of this motion */
  NB_BEFORE_SEARCH, /* positions and time are those of the next force calculation */
  NB_BEFORE_FORCES, /* positions, time and contact list are those of the next force calculation */
  NB_AFTER_FORCES,
  NB_WHENS
};
enum { NB_HOOKS = 8 }; /* the most hooks at one place of a cycle */
struct nb_hooks {
  size_t count;
  struct nb_hook {
    const char *name;
    enum nb_status (*run)(struct nb_model *model, struct nb_error *error);
  } list[NB_HOOKS];
};

/* A run. A member is changed only by the file that its comment names; "FILE, to `x`" names the file for all members
 * down to x. */
struct nb_model {
  const struct nb_scene *scene;
  struct nb_owner owner; /* of all memory that lives as long as the model */
  struct nb_machine machine;
  struct nb_particles particles;           /* motion.c */
  struct nb_walls walls;                   /* walls.c */
  struct nb_cell *cell;                    /* cell.c; NULL: not periodic */
  struct nb_vertices vertices;             /* wall_vertices.c */
  struct nb_properties properties;         /* properties.c */
  struct nb_active_laws laws, next_laws;   /* laws of the last and of the next force calculation (laws_now.c) */
  struct nb_material_pair *material_pairs; /* run/plan.c, to `plan` */
  size_t material_pair_count;
  struct nb_plan plan;
  struct nb_search search;         /* neighbours.c, guard.c */
  struct nb_contacts contacts;     /* contacts.c */
  struct nb_blocks blocks;         /* blocks.c */
  struct nb_hooks hooks[NB_WHENS]; /* run/hooks.c */

  unsigned long cycle;        /* cycle.c, to `updates`: number of the last cycle */
  unsigned long stage_cycle;  /* cycles since the beginning of the stage */
  double stage_time, time;    /* time at the beginning of the stage, s; current time, s */
  double step, previous_step; /* dt of the next step, and of the last one (0 at the start), s */
  unsigned long long updates; /* contact updates so far */
  double critical;            /* single-contact step 2 sqrt(m/k), s (measure/step.c) */

  const struct nb_stage *stage;                /* run/stage.c, to `central`: current stage; NULL before the first */
  struct nb_changes *changes;                  /* ramps of the current stage */
  struct nb_damping damping, previous_damping; /* of the current stage; of the previous stage */
  struct nb_vec gravity;                       /* uniform gravity in the next step, m/s2 */
  struct nb_central {
    double acceleration; /* towards the point, m/s2; 0: none */
    struct nb_vec point; /* m */
  } central;             /* gravity towards a point in the next step */

  bool rotates;                           /* `rotation on`: loading/boundary.c */
  struct nb_affine *affine;               /* affine.h; NULL: no affine motion */
  bool all_affine;                        /* loading/affine.c: all particles move affinely in this step */
  struct nb_boundary_state *boundary;     /* boundary.h; NULL: no boundary */
  struct nb_stability *stability;         /* measure/step.h */
  struct nb_sum *terms;                   /* NB_TERMS sums, core/energy_terms.h; NULL: not requested */
  struct nb_balance *balance;             /* measure/energy.h; NULL: not requested */
  struct nb_regions *regions;             /* measure/region.h; NULL: the scene has none */
  struct nb_configuration *configuration; /* measure/configuration.h; NULL: no snapshot requests changes */
  struct nb_fracc *fracc;                 /* measure/fracc.c; NULL: not requested */
  struct nb_deep {
    /* As `count`, for each block since the last search, NB_DEEP_STRIDE apart; NULL: no law of elastic spheres. */
    unsigned long *counts;
    unsigned long long count;     /* contact updates with too large an overlap, up to the last search */
    char first[3 * NB_NAME_SIZE]; /* text: the first contact with too large an overlap; empty: none yet */
  } deep;                         /* deep.c */
  struct nb_warnings warnings;    /* of this model only; the scene has its own */
  double impact_time;             /* time at which the particle of `impact` touches, s (measure/impact.c) */
};

/* machine.c: instruction set and threads, from the options */
enum nb_status nb_machine_choose(struct nb_model *model, const struct nb_options *options, struct nb_error *error);

/* machine.c: sets the rounding mode of this thread for a part of the cycle, such as "motion"; part NULL: to nearest */
void nb_rounding_set(const struct nb_rounding *rounding, const char *part);
/* Called when a part of the cycle begins, or, with part NULL, when it ends: changes the rounding mode if the options
 * ask for it. */
static inline void nb_rounding_begin(const struct nb_rounding *rounding, const char *part) {
  if (rounding->mode != NB_TO_NEAREST)
    nb_rounding_set(rounding, part);
}

/* blocks.c: divides the contacts into blocks, after each search */
enum nb_status nb_blocks_create(struct nb_model *model, struct nb_error *error);

/* Bits of model->plan.requested for what columns and conditions read besides fields: */
#define NB_REQUEST_CLOCK (1u << 24)  /* no fields: the quantity depends on the number of cycles and the step alone */
#define NB_REQUEST_FRACC (1u << 27)  /* fracc.c */
#define NB_REQUEST_STRAIN (1u << 28) /* strain.c */
#define NB_REQUEST_WORK (1u << 29)   /* the work balance, energy.h */
#define NB_REQUEST_ENERGY (1u << 30) /* the energy balance */
#define NB_REQUEST_STORED (1u << 31) /* energies that require laws with stored energy */

/* A unit in a message, such as " m"; empty with `units none`. */
static inline const char *nb_unit(const struct nb_scene *scene, const char *unit) {
  return scene->unitless ? "" : unit;
}

/* True if a stage has removed the particle, or the wall (loading/remove.c). */
static inline bool nb_removed(const struct nb_model *model, size_t slot) {
  return model->particles.removed && model->particles.removed[slot];
}
static inline bool nb_wall_removed(const struct nb_walls *walls, size_t w) {
  return walls->removed && walls->removed[w];
}
/* True if the contact is one of a particle with a wall. */
static inline bool nb_with_wall(const struct nb_model *model, size_t contact) {
  return model->material_pairs[model->contacts.material_pair[contact]].wall;
}
/* A field of a contact; 0 if the pair is not listed (contact < 0) or the field is not kept. */
static inline double nb_field_of(const struct nb_model *model, long contact, enum nb_field field) {
  return contact < 0 || !model->contacts.kept[field] ? 0 : model->contacts.kept[field][contact];
}

/* materials.c */
double nb_particle_mass(const struct nb_scene *scene, const struct nb_particle *particle);    /* kg */
double nb_particle_inertia(const struct nb_scene *scene, const struct nb_particle *particle); /* kg m2 */
/* Thickness of the assembly, m: the mean over the particles of 1 m for a disc, the diameter for a sphere. */
double nb_thickness(const struct nb_model *model);

/* guard.c: stops a run before particles pass through each other or through walls */
/* NB_BROKEN when a position is NaN or infinite. */
enum nb_status nb_guard_positions(const struct nb_model *model, struct nb_error *error);
/* NB_BROKEN when a particle moved, or a wall rotated, too far in the last step. */
enum nb_status nb_guard_motion(const struct nb_model *model, struct nb_error *error);
/* NB_BROKEN (at cycle 0 NB_BAD_USE) when the particles overlap by more than the smaller radius. */
enum nb_status nb_guard_pair(const struct nb_model *model, struct nb_close_pair pair, struct nb_error *error);

/* Runs the guards of a cycle without a search. NB_BROKEN when one of them is violated. */
enum nb_status nb_guard_cycle(const struct nb_model *model, struct nb_error *error);

/* Warns when the resolution of positions is too coarse for the current overlaps. */
void nb_guard_resolution(struct nb_model *model);

/* neighbours.c: runs the guards, then builds a new contact list */
enum nb_status nb_neighbours_search(struct nb_model *model, struct nb_error *error);
/* As nb_neighbours_search, but contacts keep their forces, because no force calculation follows. */
enum nb_status nb_neighbours_search_again(struct nb_model *model, struct nb_error *error);
/* Replaces the first search of a resumed run: lists the contacts of a checkpoint, whose pairs are the next part of
 * `store`. */
enum nb_status nb_neighbours_restore(struct nb_model *model, struct nb_store *store, struct nb_error *error);

/* motion.c, and from nb_motion_reverse on velocity.c */
/* These two move particles and walls by one step: the particles of part `part` of `parts`, and all walls. They return
 * how many of them require a new search: those that have moved by more than half the skin since the last search (in a
 * cell: by more than its travel limit) or to NaN, and walls that rotated too far. */
int nb_motion_part(struct nb_model *model, int part, int parts);
int nb_motion_walls(struct nb_model *model); /* walls.c */
/* Reverses all velocities, so that the next steps retrace the motion. model->step must be that of the next step. */
void nb_motion_reverse(struct nb_model *model);
struct nb_force {
  struct nb_vec force; /* N */
  double moment;       /* N m, counterclockwise */
};
/* Sum of the forces and moments of the particle's contacts. */
struct nb_force nb_force_on(const struct nb_model *model, size_t slot);
/* Velocities of a particle at t_(N-1/2), without affine motion. */
struct nb_velocities nb_velocity_half(const struct nb_model *model, size_t slot);
/* Velocities of a particle at t_N, the mean of the two half steps [CS79 31], without affine motion. */
struct nb_velocities nb_velocity_now(const struct nb_model *model, size_t slot);
struct nb_vec nb_imposed_now(const struct nb_model *model, size_t slot); /* affine velocity at t_N, m/s */
/* Velocity at t_N with affine motion, m/s. */
struct nb_vec nb_velocity_total(const struct nb_model *model, size_t slot);

struct nb_vec nb_weight(const struct nb_model *model, size_t slot, struct nb_vec x); /* weight at the position x, N */
/* Sum of the contact forces, the weight and the force of a boundary stress on a free particle, N. */
struct nb_vec nb_unbalanced_force(const struct nb_model *model, size_t slot);

/* Changes the half-step velocities of a particle so that its velocities at t_N are `now`. */
void nb_motion_set_velocity(struct nb_model *model, size_t slot, struct nb_velocities now);
/* Called when a force and a moment cease at t_N: changes the half-step velocities so that the velocities at t_N stay
 * the same. */
void nb_motion_offset_force(struct nb_model *model, size_t slot, struct nb_force ending);

/* walls.c */
/* True if a rotation of the wall by `angle`, rad, in one step is too large for the guard (guard.c). */
bool nb_rotates_too_far(const struct nb_model *model, size_t wall, double angle);
void nb_walls_reset_travel(struct nb_walls *walls); /* measures the travel of walls from their current ends */
/* NB_BROKEN when the centre of a particle crossed a wall in the last step. `all`: tests all pairs of a particle and a
 * wall; otherwise the listed ones. */
enum nb_status nb_walls_crossed(const struct nb_model *model, bool all, struct nb_error *error);

/* wall_vertices.c */
bool nb_vertices_exist(const struct nb_scene *scene); /* two walls have a common end */
bool nb_vertices_find(struct nb_model *model);        /* lists vertices after a search; false: out of memory */
void nb_vertices_suppress(struct nb_model *model);    /* before the force calculation: marks the suppressed contacts */

/* deep.c: overlaps beyond the range of Hertz theory, and of elastic deformation */
enum { NB_DEEP_STRIDE = 8 }; /* counters from block to block: two threads must not write to the same cache line */
/* Overlap over the smaller diameter above which a contact is deep: from the page, or 0.07 [R89 sec. 6.4.3]. */
double nb_deep_fraction(const struct nb_model *model);
bool nb_deep_begin(struct nb_model *model, size_t blocks); /* makes counters, after a search; false: out of memory */
void nb_deep_end(struct nb_model *model); /* called when a law of elastic spheres ends; the count is kept */
/* Called after the force calculation: describes the first deep contact in model->deep.first. */
void nb_deep_record_first(struct nb_model *model);
/* True if the contact is deep at the current positions. */
bool nb_is_deep(const struct nb_model *model, size_t contact);
/* Called after the first force calculation: warns of a deep contact of laws that are not for elastic spheres. */
void nb_deep_warn(struct nb_model *model);
/* Number of deep contacts since the start; a contact counts once per cycle. */
unsigned long long nb_deep_count(const struct nb_model *model);

/* cycle.c: the force calculation at the current positions */
void nb_forces(struct nb_model *model);

/* ---- contacts ---- */

/* Sort key of b among the partners of a: a particle's number; walls last, in the order of the page. */
static inline int nb_partner_rank(const struct nb_model *model, struct nb_neighbour_pair pair) {
  return model->material_pairs[pair.material_pair].wall ? INT_MAX / 2 + pair.b : model->particles.number[pair.b];
}

/* Compares p and q by material pair, then by the number of a, then by the number of b. Returns < 0, 0 or > 0, like
 * strcmp. */
static inline int nb_contacts_order(const struct nb_model *model, struct nb_neighbour_pair p,
                                    struct nb_neighbour_pair q) {
  const int *number = model->particles.number;
  if (p.material_pair != q.material_pair)
    return p.material_pair - q.material_pair;
  return p.a != q.a   ? number[p.a] - number[q.a]
         : p.b == q.b ? 0
                      : nb_partner_rank(model, p) - nb_partner_rank(model, q);
}

/* Branch vector between two particles: from the first centre to the second, or to its image, m. */
static inline struct nb_vec nb_contacts_branch(const struct nb_model *model, size_t contact) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec *x = model->particles.position;
  const struct nb_vec branch = vec_sub(x[contacts->b[contact]], x[contacts->a[contact]]);
  return model->cell ? vec_add(branch, tensor_times(model->cell->h, contacts->image[contact])) : branch;
}

/* The overlap of a contact at the current positions, m; below 0: a gap. */
static inline double nb_overlap(const struct nb_model *model, size_t contact) {
  const bool wall = nb_with_wall(model, contact);
  const struct nb_particles *particles = &model->particles;
  const int i = model->contacts.a[contact], j = model->contacts.b[contact];
  if (!wall)
    return particles->radius[i] + particles->radius[j] - vec_length(nb_contacts_branch(model, contact));
  return particles->radius[i] - vec_length(nb_wall_separation(&model->walls, j, particles->position[i]));
}

/* The parameters that a contact's laws read: those of its material pair, and its own R*. */
static inline struct nb_pair nb_contact_constants(const struct nb_model *model, size_t contact, struct nb_pair values) {
  if (model->contacts.kept[NB_REDUCED])
    values.radius = model->contacts.kept[NB_REDUCED][contact];
  return values;
}
