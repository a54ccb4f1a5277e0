/* nineball: discs and spheres in the plane, simulated with the distinct element method.
 *
 * The public interface: the scene that a page describes (struct nb_scene), a running simulation (struct nb_model,
 * opaque), and its results (struct nb_table). All numbers are in SI units; with `units none` they are used unchanged.
 * Every structure states who owns its memory. There are no global variables, so a program may run many models at once.
 *
 * [CS79] Cundall and Strack, Geotechnique 29 (1979) 47-65.   [R89] Randall, PhD thesis, Aston (1989).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NINEBALL_H
#define NINEBALL_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { NB_NAME_SIZE = 64 }; /* bytes of the longest name that a page may use, with its terminating zero */

/* What a function returns to its caller; also the exit status of `nineball`. */
enum nb_status {
  NB_OK = 0,
  NB_FAILED = 1,   /* a check of a page failed */
  NB_BAD_USE = 2,  /* the command line or the page is wrong, or a file cannot be read or written */
  NB_BROKEN = 3,   /* run aborted: NaN, an unstable step, a stage that never ended */
  NB_NO_MEMORY = 4 /* memory ran out: the run or check has no result, whatever else was printed */
};

/* One error message. The caller owns the structure; a function that fails fills it once. */
struct nb_error {
  enum nb_status status;
  char text[512];
  int line; /* the line of the page that the message names; 0: none */
};

/* ---- warning.c: warnings; they change no exit status ---- */

enum { NB_WARNINGS = 16 };
struct nb_warning {
  char text[400];
  int line; /* line of the page; 0: none */
};
struct nb_warnings {
  struct nb_warning list[NB_WARNINGS];
  size_t count;
};

/* ---- mistakes.c: the list of all errors found in a page ---- */

struct nb_mistakes {
  char *text;                        /* the messages, ready to print; NULL while there are none; owned */
  size_t count;                      /* messages in `text` */
  size_t total;                      /* errors found, including those without a message */
  bool no_memory;                    /* memory ran out; counts as an error without a message, and stays set */
  struct nb_mistakes_inside *inside; /* private to mistakes.c; owned */
};
void nb_mistakes_free(struct nb_mistakes *mistakes);

/* ---- page.c: a Markdown file and its fenced blocks ---- */

struct nb_page {
  char *path;              /* as the caller gave it, for messages; owned */
  char name[NB_NAME_SIZE]; /* file name without directory and .md: `nine-discs` */
  char title[128];         /* first heading, without its `#` */
  char **lines;            /* the text, line by line, without line ends; owned */
  size_t line_count;       /* lines[0] is line 1 of the file */
  unsigned char *kind_of;  /* for each line, the kind of block that contains it (input/reader.h); owned */
  size_t misnamed;         /* blocks with a misspelt kind, which have been reported */
  unsigned long long hash; /* FNV-1a of the whole file; tables record it */
};
/* Reads the file and finds its blocks. Adds all errors to `mistakes`; after an error the page is empty. */
enum nb_status nb_page_read(struct nb_page *page, const char *path, struct nb_mistakes *mistakes);
/* Does the same, but after misspelt kinds of blocks alone the page is kept, and these blocks have the kinds that are
 * meant: so all mistakes of a page are reported at once. */
enum nb_status nb_page_read_kept(struct nb_page *page, const char *path, struct nb_mistakes *mistakes);
void nb_page_free(struct nb_page *page);

/* ---- names.c: quantities and their names ---- */

struct nb_model;
struct nb_scene;

/* A quantity that can be recorded, waited for or expected: `C.normal`, `time`, `energy.kinetic`. */
struct nb_quantity {
  const struct nb_quantity_kind *kind; /* its row of the table of quantities (core/names.h); NULL: none */
  int monitor;                         /* index of its monitor; -1: a quantity of the whole scene */
  const struct nb_suffix *suffix;      /* its suffix in a family of quantities (families.c); NULL: no family */
};

/* Finds the quantity with the name `text`. False: the scene has no such quantity. */
bool nb_quantity_find(struct nb_quantity *quantity, const struct nb_scene *scene, const char *text);
const char *nb_quantity_unit(struct nb_quantity quantity);                           /* "N", "m"; "1": dimensionless */
double nb_quantity_value(struct nb_quantity quantity, const struct nb_model *model); /* its current value, SI */

/* ---- scene.c: the scene that a page describes ---- */

enum nb_shape {
  NB_DISC,  /* a cylinder 1 m thick: m = pi R^2 rho, I = m R^2 / 2 */
  NB_SPHERE /* moves in the plane: m = 4/3 pi R^3 rho, I = 2/5 m R^2 */
};

/* The properties of a contact between two materials. A row has: the property's keyword, which is also its name in the
 * structures below; the letter that stands for its value in the manual; its unit and range; the default of `material`;
 * the rule that combines two materials (properties.c); and the help text. A new property needs only a new row: reading,
 * changes in stages, ramps, saved states and the manual use this table. Law files read the property NAME as p.NAME,
 * which is 0 if the page gives no value. */
#define NB_PAIR_ROWS(ROW)                                                                                              \
  ROW(kn, "K", STIFFNESS, NOT_NEGATIVE, "0", series, "Normal stiffness of a contact [CS79 16].")                       \
  ROW(ks, "K", STIFFNESS, NOT_NEGATIVE, "0", series, "Shear stiffness of a contact [CS79 17].")                        \
  ROW(friction, "F", NUMBER, NOT_NEGATIVE, "0", smaller, "Tangent of the angle of friction [CS79 19].")                \
  ROW(cohesion, "N", FORCE, NOT_NEGATIVE, "0", smaller,                                                                \
      "Cohesion, a force [CS79 19], which is added to the limit of the shear force. There are no bonds and no "        \
      "tension.")
#define NB_PAIR_MEMBER(name, ...) double name;

struct nb_material {
  char name[NB_NAME_SIZE];
  double density;              /* kg/m3 */
  NB_PAIR_ROWS(NB_PAIR_MEMBER) /* of a contact between two particles of this material */
  double young;                /* E, Pa, for laws of elastic spheres; INFINITY: rigid; 0: not given [R89 4.7] */
  double poisson;              /* nu, 1; the shear modulus is G = E/(2(1 + nu)), Pa */
  int line;                    /* line of the page, for messages */
};

/* `pair A B ...`: properties of contacts between two materials, which replace the results of the combination rules.
 * NAN: the combination rule applies. */
struct nb_pair_rule {
  int a, b; /* indices of the materials */
  NB_PAIR_ROWS(NB_PAIR_MEMBER)
  int line;
};

/* A particle keeps its number, 1, 2, ... in the order of the page; its index here is number - 1. */
struct nb_particle {
  enum nb_shape shape;
  double x, y, radius; /* m */
  double vx, vy;       /* m/s, at time 0 */
  double spin;         /* rad/s, counterclockwise, at time 0 */
  int material;
  int fixed; /* 1: fixed in place, its mass counts as infinite */
  int line;
};

/* `grading`: a number of particles for each size. */
struct nb_size {
  double radius;         /* m */
  size_t count;          /* particles of this size in one filling with the grading */
  size_t wanted, placed; /* particles in all fillings with the grading */
};
struct nb_grading {
  char name[NB_NAME_SIZE];
  struct nb_size *sizes; /* largest first; owned by the scene */
  size_t size_count;
  size_t count; /* particles of all sizes */
  int line;
};

/* `fill`: particles of a grading, placed at random in a circle or a box. Coordinates are those before `transform`. */
struct nb_fill {
  bool circle;
  double x, y;          /* centre of the circle, or lower left corner of the box, m */
  double radius;        /* radius of the circle, m */
  double x1, y1;        /* upper right corner of the box, m */
  double width, height; /* sides of the periodic cell, m, if the cell is filled; x, y and x1, y1 are then its corners;
                         * 0: the cell is not filled */
  int grading;
  unsigned long seed;
  unsigned long attempts;           /* largest number of attempts for each particle */
  bool skip;                        /* true: a size that does not fit is skipped; false: it is an error */
  size_t first, count;              /* index of its first particle; number of its particles */
  unsigned long long attempts_made; /* attempts for all its particles */
  int line;
};

/* `packing`: particles read from a file. */
struct nb_packing {
  char *path;          /* owned by the scene */
  size_t first, count; /* index of its first particle; number of its particles */
  int line;
};

/* A wall is the segment from P + h0 l + h1 e to P + h0 l + h2 e, with l to the left of e; [CS79 figure 4] has h0 = 0.
 * It acts on particles on both sides. */
struct nb_wall {
  char name[NB_NAME_SIZE];
  double x, y;     /* P, m */
  double ex, ey;   /* e, unit vector */
  double h1, h2;   /* m */
  double h0;       /* distance of the wall's line from P, m; positive to the left of e */
  bool has_about;  /* the page gives P; otherwise P is the middle of the wall */
  double inx, iny; /* unit normal into the box that the wall belongs to; 0, 0: no box */
  double vx, vy;   /* velocity of P at time 0, m/s */
  double spin;     /* angular velocity about P at time 0, rad/s, counterclockwise */
  int material;
  int line;
};

/* Damping of contacts and of motion. The papers use four conventions; see docs/METHOD.md.
 *
 *   c   coefficient of a dashpot, N s/m        k  stiffness of the contact, N/m
 *   M*  reduced mass of two particles, kg      m  mass of a particle, kg
 *   C   coefficient of mass-proportional damping, N s/m
 *   v   velocity, m/s                          F  sum of the forces, N           dt  step, s */
enum nb_contact_damping {
  NB_CONTACT_UNDAMPED,
  NB_CONTACT_STIFFNESS,    /* c = beta k; beta is a time, s [CS79 28] */
  NB_CONTACT_R89_FRACTION, /* c = beta k t_c/2; t_c is the single-contact step 2 sqrt(m/k) [R89 4.3, 4.4] */
  NB_CONTACT_RATIO         /* c = beta 2 sqrt(M* k); beta is the damping ratio [R89 4.13] */
};
enum nb_global_damping {
  NB_GLOBAL_UNDAMPED,
  NB_GLOBAL_MASS,          /* C = alpha m; alpha in 1/s [CS79 34-36] */
  NB_GLOBAL_CON1_CS79,     /* v = (CON1 v + F dt/m) / (2 - CON1): CS79 35 with CON1 = 1 - alpha dt/2 */
  NB_GLOBAL_CON1_VELOCITY, /* v = CON1 v + F dt/m */
  NB_GLOBAL_CON1_ALL       /* v = CON1 (v + F dt/m): only here CON1 = 0 stops all motion [R89 sec. 6.5.1] */
};
struct nb_damping {
  enum nb_contact_damping contact_kind;
  double contact; /* beta, s or 1 */
  int contact_line;
  bool walls_separate; /* contacts with walls have their own damping, which the next three members give */
  enum nb_contact_damping walls_kind;
  double walls; /* beta, s or 1 */
  int walls_line;
  double deep; /* overlap beyond which a contact is critically damped, as a fraction of the smaller diameter; 0: none */
  int deep_line;
  /* Dashpots use the velocity at t_N and, in a new contact, the time since first touch: pass/dashpots.c. */
  bool centred;
  int centred_line;
  enum nb_global_damping global_kind;
  double global; /* alpha, 1/s; or CON1, 1 */
  int global_line;
};
/* Returns the kind of damping of a contact with a wall, or of one between particles, and sets `value` to its
 * coefficient, s or 1. */
enum nb_contact_damping nb_damping_at(const struct nb_damping *damping, bool wall, double *value);
/* The line of the page that sets the damping of contacts; 0: none. */
int nb_damping_contact_line(const struct nb_damping *damping);
bool nb_damping_equal(const struct nb_damping *a, const struct nb_damping *b); /* the lines of the page may differ */
bool nb_damping_none(const struct nb_damping *damping); /* neither contacts nor particles are damped */

/* The time that `value` of a step multiplies: measure/step.c, measure/rayleigh_step.c. MEAN: for a sphere with the mean
 * values of radius, density, G and nu. FIT: with R89's fit of the wave speed. R89 uses NB_STEP_RAYLEIGH_FIT_MEAN. */
enum nb_step_kind {
  NB_STEP_TIME,           /* 1 s */
  NB_STEP_SINGLE_CONTACT, /* 2 sqrt(m/k) of the smallest mass and the largest stiffness [CS79, Motion] */
  NB_STEP_STABLE,         /* the guaranteed stable step when the stage begins: measure/stable_step.c */
  NB_STEP_COLLISION,      /* the duration of the shortest possible collision */
  NB_STEP_RAYLEIGH,       /* the shortest travel time of a Rayleigh wave over half the circumference of a sphere */
  NB_STEP_RAYLEIGH_MEAN,
  NB_STEP_RAYLEIGH_FIT,
  NB_STEP_RAYLEIGH_FIT_MEAN
};
struct nb_step {
  enum nb_step_kind kind;
  double value;
  int line;
  bool set; /* by --set: used from the start, whatever the page says */
};

/* A named object whose quantities a page records. */
enum nb_monitor_kind {
  NB_MONITOR_PARTICLE,
  NB_MONITOR_WALL,
  NB_MONITOR_PARTICLE_PARTICLE,
  NB_MONITOR_PARTICLE_WALL,
  NB_MONITOR_REGION,
  NB_MONITOR_GRADING,
  NB_MONITOR_SIZE
};
struct nb_monitor {
  char name[NB_NAME_SIZE];
  enum nb_monitor_kind kind;
  int a, b; /* index of a particle, wall, region, grading or size, by kind; -1: none */
  int line;
};

/* `region NAME ...`: a part of the plane whose particles are measured together; its monitor has the same name. */
enum nb_region_kind { NB_REGION_CIRCLE, NB_REGION_BOX, NB_REGION_ALL, NB_REGION_INSIDE };
struct nb_region {
  enum nb_region_kind kind;
  double x, y;             /* centre, m */
  double radius;           /* m; for NB_REGION_INSIDE, as a fraction of the boundary's mean radius, 1 */
  double ex, ey;           /* e, unit vector along one side of the rectangle; NB_REGION_BOX and NB_REGION_ALL */
  double half_x, half_y;   /* half the length of the rectangle along e, and at right angles to e, m */
  int rings;               /* number of rings of equal width that a snapshot measures; 0: none */
  char from[NB_NAME_SIZE]; /* stage at whose beginning the strain is 0; empty: the start of the run */
  int stage;               /* index of that stage; -1: the start of the run */
  int line;
};

/* `gravity GX GY`: uniform gravity; `gravity centripetal G about X Y`: gravity towards a point. Gravity acts on all
 * particles that are not fixed. */
struct nb_gravity {
  double x, y;             /* m/s2 */
  double central;          /* acceleration towards the point, m/s2 */
  double about_x, about_y; /* the point, m */
  bool ramp;               /* changes linearly and reaches these values at the end of the stage */
  int line;                /* line of the page; 0: not given here */
};

/* `material` or `pair` in a stage: new values from that stage on. NAN: unchanged. */
struct nb_change {
  int a, b;                    /* materials; b is -1 for a change of material a itself, not of the pair */
  NB_PAIR_ROWS(NB_PAIR_MEMBER) /* as in struct nb_material */
  bool ramp;                   /* the values change linearly and are reached at the end of the stage */
  int line;
};

/* `impact`: a sphere strikes another particle or a wall. The reader of the page places the sphere just in contact and
 * sets its velocity. The run starts earlier, by the fraction `phase` of a step. */
struct nb_impact {
  int monitor;  /* monitor of the contact; its first particle is the sphere that moves */
  double speed; /* speed of the sphere's centre relative to the other particle or the wall, m/s */
  double angle; /* angle of this velocity from the normal, rad; NAN: computed from psi1 */
  double psi1;  /* Maw's angle of incidence, 1 [R89 5.15]; NAN: computed from the angle */
  double phase; /* fraction of a step between the start and first touch, 0 to 1 */
  int line;     /* 0: no such statement */
};

/* What the lines of a stage have set for a wall: its velocity, its spin. NB_GIVEN_WALLS: a line `walls` has set its
 * motion, and a line `wall` below it may change the motion. */
enum { NB_GIVEN_VELOCITY = 1, NB_GIVEN_SPIN = 2, NB_GIVEN_WALLS = 4 };
/* Motion of a wall from the beginning of a stage until another stage changes it, or its removal. */
struct nb_wall_motion {
  int wall;       /* index */
  double vx, vy;  /* velocity of P, m/s */
  double spin;    /* angular velocity about P, rad/s, counterclockwise */
  unsigned given; /* what lines of this stage have set: NB_GIVEN_ bits */
  bool ramp;      /* the motion changes linearly and is reached at the end of the stage */
  bool removed;   /* `remove wall NAME`: the wall is removed when the stage begins; its velocity and spin are 0 */
  int line;
};

/* `remove disc N`: particles removed when a stage begins. */
struct nb_removal {
  size_t from, to; /* indices of the first and the last one */
  int line;
};

/* `periodic cell`: the periodic cell. Its sides are the columns of the matrix H with the rows h[0] h[1] and h[2] h[3]. */
struct nb_scene_cell {
  double x, y; /* its centre, m */
  double h[4]; /* H, m */
  int line;    /* 0: the scene has no cell */
};

/* A velocity gradient: the velocity at (x, y) is (xx x + xy y, yx x + yy y), extension positive [R89 4.43, 4.44]. */
struct nb_strain_rate {
  double xx, xy, yx, yy; /* 1/s; if per_cycle, 1 */
  bool per_cycle;        /* the components are strains per cycle; the program divides them by the step */
};

/* Contact laws by the names of their files, `linear`, `none`; empty: unchanged. When a stage changes a law, the
 * contact history of the old one is discarded. */
struct nb_laws {
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE];
  int normal_line, shear_line;
  int pieces; /* most pieces of contact history that the shear law keeps; 0: the law's default */
};

enum nb_relation { NB_BELOW, NB_ABOVE };
struct nb_condition {
  char name[2 * NB_NAME_SIZE]; /* as written on the page */
  struct nb_quantity quantity;
  enum nb_relation relation;
  double value; /* SI */
  int line;
};

/* Target of one direction, normal or tangential, in a segment of a contact test. */
struct nb_target {
  bool force;    /* true: the force varies linearly; false: the overlap or the tangential displacement does */
  bool relative; /* the value is a change from the value at the beginning of the segment */
  double value;  /* m or N; relative 0: held constant */
};
struct nb_path_point {
  double approach, slip; /* overlap, below 0 for a gap, m; tangential displacement, m */
};

/* A segment of a contact test: the loading of the contact during one stage. */
struct nb_segment {
  struct nb_target normal, shear;
  struct nb_path_point *points; /* `follow FILE`: one step to each point; replaces the targets; owned by the scene */
  size_t point_count;
};

/* `boundary circle`: particles whose centres are on the circle or outside it form the assembly's boundary. */
struct nb_circle {
  double x, y, radius; /* m */
  int line;            /* 0: no boundary begins */
};

/* The next two structures: the loading of the boundary, and the affine motion of the free particles. Each stays until
 * another stage changes it. */
enum nb_control { NB_CONTROL_STRAIN, NB_CONTROL_STRESS, NB_CONTROL_NONE };
struct nb_boundary {
  enum nb_control control;
  struct nb_strain_rate strain; /* NB_CONTROL_STRAIN: imposed on its particles' centres; `boundary fixed`: 0 */
  double sxx, syy, sxy; /* NB_CONTROL_STRESS: stress applied as forces on its particles, Pa, compression positive */
  int line;             /* 0: unchanged */
};
struct nb_affine_motion {
  struct nb_strain_rate strain; /* `none`: 0 */
  bool accumulated; /* the affine velocity is added to the particle's velocity in every cycle and stays in it: R89 4.43,
                     * 4.44 taken literally */
  bool twice;       /* the affine velocity is also added to the relative velocities, as in R89's subroutine FORD;
                     * `accumulated` is then true */
  int line;         /* 0: unchanged */
};

/* `servo`: adjusts strain rates so that a stress reaches its target. */
struct nb_servo {
  struct nb_quantity quantity[4]; /* measured stresses: xx, xy, yx, yy */
  double stress[3];               /* targets of xx, yy, xy, Pa */
  bool controlled[3];             /* for xx, yy, xy: the servo controls this stress */
  double axis_x[2], axis_y[2];    /* components of the unit vectors to which xx, yy and xy refer */
  bool mean;                      /* only the mean (xx + yy)/2 is controlled */
  bool affine;                    /* adjusts the affine motion of the boundary and of the free particles */
  bool cell;                      /* adjusts the strain rate of the cell */
  bool box;                       /* adjusts the strain rate of the box; if all three are false: of the boundary only */
  bool ramp;                      /* the target changes linearly and is reached at the end of the stage */
  double max_rate;                /* largest component of the added strain rate, 1/s; if per_cycle, 1 */
  bool per_cycle;                 /* max_rate is a strain per cycle */
  unsigned long every;            /* cycles between two adjustments */
  int line;                       /* 0: none */
};

struct nb_stage {
  char name[NB_NAME_SIZE];
  struct nb_servo servo;
  struct nb_circle circle;        /* a boundary that begins with this stage */
  struct nb_boundary boundary;    /* its loading */
  struct nb_affine_motion affine; /* affine motion imposed on all other particles */
  enum nb_rotation { NB_ROTATION_AS_BEFORE, NB_ROTATION_ON, NB_ROTATION_OFF } rotation;
  int rotation_line;
  struct nb_wall_motion *motions; /* owned by the scene */
  size_t motion_count;
  struct nb_change *changes; /* of materials and pairs; owned by the scene */
  size_t change_count;
  struct nb_gravity gravity;   /* line 0: unchanged */
  struct nb_strain_rate cell;  /* strain rate of the cell */
  int cell_line;               /* 0: unchanged */
  struct nb_strain_rate box;   /* strain rate of the walls of the box */
  int box_line;                /* 0: unchanged */
  struct nb_removal *removals; /* owned by the scene */
  size_t removal_count;
  bool zero_velocities;            /* the stage begins with all particles at rest */
  bool reverse_velocities;         /* the stage begins with all velocities reversed, those of walls too */
  struct nb_condition *conditions; /* all must hold; owned by the scene */
  size_t condition_count;
  unsigned long cycles;          /* number of cycles; with conditions, a limit: a stage that reaches it has failed */
  unsigned long check_interval;  /* cycles between two tests of the conditions */
  unsigned long record_interval; /* cycles between two rows; 0: no rows */
  int record_line;               /* of `record` in the stage; 0: it has none */
  bool snapshot;                 /* keep particles, walls and contacts at the end of the stage */
  int snapshot_from;             /* index of the stage from whose beginning a snapshot measures changes; -1: none */
  struct nb_step step;           /* as in the stage before, unless the stage gives its own */
  bool allow_unstable;           /* the stability of the step is not checked in this stage */
  struct nb_damping damping;     /* as in the stage before, unless the stage gives its own */
  struct nb_laws laws;           /* an empty name: the law of the stage before */
  unsigned long long hash;       /* of the page up to the end of this stage, without statements that only record */
  struct nb_segment segment;     /* of a contact test; `cycles` is its number of steps */
  int line;
};

struct nb_column {
  char name[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  int line;     /* of its statement `record`; 0: a default of a contact test */
  bool tracked; /* the run also keeps the smallest and the largest value of all cycles: struct nb_extremes */
};

/* `start PAGE stage NAME`: the scene continues from the end of a stage of another page. The scene includes the other
 * page's stages up to that one, but they are not run again: their end is read from a saved state, or computed first. */
struct nb_start {
  struct nb_page *page;               /* the other page; owned, as is all below */
  struct nb_scene *scene;             /* its scene, up to the end of that stage */
  char (*settings)[2 * NB_NAME_SIZE]; /* settings of the other page: "v=0.1 m/s" */
  size_t setting_count;
  size_t stages; /* number of stages that come from the other page; 0: no such statement */
  int line;
};

/* `trade NAME VALUE …`: other values that `nineball advise` may give to a name. */
enum { NB_TRADED_MAX = 16 };
struct nb_trade {
  char name[NB_NAME_SIZE];
  char values[NB_TRADED_MAX][NB_NAME_SIZE]; /* as --set takes them */
  size_t count;
};

/* One run of a page: every name resolved, every number in SI. nb_scene_read fills the structure, which is constant from
 * then on. Reference solutions read the same structure. It owns everything its pointers reach, except the page. */
struct nb_scene {
  const struct nb_page *page; /* not owned */
  bool unitless;              /* `units none` */
  size_t runs;                /* of the page: the product of the lengths of its sweeps; 1 if a sweep is invalid */
  bool contact_test;          /* a contact test: particle 1 with particle 2, or with the wall; stages are segments */
  double refine;              /* `--set refine=R`: the step of the page divided by R; 1: as written */
  double soften;              /* `--set soften=S`: the stiffnesses of the page divided by S; 1: as written */
  bool path_replaced;         /* a setting `follow=FILE` replaced the page's segments: expectations do not apply */
  struct nb_material *materials;
  size_t material_count;
  struct nb_pair_rule *pair_rules;
  size_t pair_rule_count;
  struct nb_particle *particles;
  size_t particle_count;
  struct nb_wall *walls;
  size_t wall_count;
  struct nb_grading *gradings;
  size_t grading_count;
  struct nb_fill *fills;
  size_t fill_count;
  struct nb_packing *packings;
  size_t packing_count;
  struct nb_scene_cell cell;
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* laws, by the names of their files: `linear`, `none` */
  int normal_line, shear_line;
  int pieces; /* most pieces of contact history that the shear law keeps; 0: the law's default */
  struct nb_damping damping;
  struct nb_gravity gravity; /* at time 0 */
  struct nb_circle circle;   /* `boundary circle` before the first stage */
  double origin_x, origin_y; /* m; origin of strain rates where no boundary has a centre */
  struct nb_step step;
  bool allow_unstable; /* the stability of the step is not checked in any stage */
  double skin;         /* m; pairs closer than this are listed [R89 TOL]; 0: default, a tenth of the mean radius */
  struct nb_monitor *monitors;
  size_t monitor_count;
  struct nb_region *regions;
  size_t region_count;
  struct nb_impact impact;
  struct nb_start start;
  struct nb_column *columns;
  size_t column_count;
  struct nb_stage *stages;
  size_t stage_count;
  struct nb_binding *bindings; /* values of $NAME in this run: input/reader.h */
  size_t binding_count;
  struct nb_trade *trades;
  size_t trade_count;
  enum { NB_TRADE_LAWS_DEFAULT, NB_TRADE_LAWS_ALL, NB_TRADE_LAWS_NONE } trade_laws;
  struct nb_warnings warnings; /* found while the page was read */
};

/* Settings `--set NAME=VALUE`: a NULL-terminated array of texts "NAME=VALUE", or NULL for none. */
typedef const char *const *nb_settings;

/* Reads the scene of one run, 0 <= run < scene->runs, and adds all errors of the scene blocks to `mistakes`. After an
 * error the scene is incomplete and must not be run. The caller frees the scene in any case. */
enum nb_status nb_scene_read(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                             struct nb_mistakes *mistakes);
void nb_scene_free(struct nb_scene *scene);

/* ---- model.c, cycle.c: a running simulation ---- */

/* A rounding mode of IEEE 754, and the part of the cycle to which it applies. */
struct nb_rounding {
  enum { NB_TO_NEAREST, NB_UPWARD, NB_DOWNWARD, NB_TOWARDS_ZERO, NB_ROUNDINGS } mode;
  const char *part; /* a pass, a hook, "motion", "search", or "step" of a contact test; NULL: the whole cycle */
};

struct nb_options {
  int threads;             /* 0: OpenMP's default */
  const char *isa;         /* "plain", "avx2", "avx512"; NULL: the best of this machine */
  int jobs;                /* runs of a sweep in parallel; 0: as many as there are processors for `threads` each */
  bool shuffle;            /* tests: store the particles in another order than their numbers, which changes no result */
  bool keep_all;           /* keep all contact fields that a saved state contains */
  const char *states;      /* folder of saved states; NULL: `states` */
  struct nb_results_kept { /* where the results of a sweep are kept */
    size_t bytes;          /* bytes kept in memory; further results go to a temporary file */
    const char *folder;    /* folder of that file; NULL: all results are kept in memory */
    bool verdict_only;     /* snapshots are not kept */
  } results;
  struct nb_rounding rounding; /* of cycles and of steps of contact tests; all other code rounds to nearest */
  struct nb_checkpointing {
    double seconds;                    /* between two checkpoints; 0: none are saved */
    bool resume;                       /* continue from the last checkpoint */
    const volatile sig_atomic_t *stop; /* when *stop is not 0, the run saves a checkpoint and stops; NULL: never */
    unsigned long stop_after;          /* tests: stop after so many cycles; 0: run to the end */
    unsigned long long key;            /* hash of settings and run, part of the file name; 0: none are saved */
  } checkpoint;
};

/* Creates a model of the scene at time 0, or, with `start`, at the end of the stage from which the scene starts; the
 * state of this end must exist. Returns NULL and fills `error` when the model cannot be created. The scene must outlive
 * the model. */
struct nb_model *nb_model_create(const struct nb_scene *scene, const struct nb_options *options,
                                 struct nb_error *error);
void nb_model_free(struct nb_model *model);

/* Computes one cycle: motion from t_N to t_(N+1), then the forces at t_(N+1) [CS79, The calculation cycle]. After an
 * error, for example NB_BROKEN from a guard (guard.c), the model must not be used any more. */
enum nb_status nb_cycle(struct nb_model *model, struct nb_error *error);

/* ---- table.c, run.c: results ---- */

/* A table of numbers with named columns. */
struct nb_table {
  size_t column_count, row_count;
  char (*names)[2 * NB_NAME_SIZE]; /* owned */
  const char **units;              /* constant texts */
  double *values;                  /* row by row, column_count numbers per row; owned */
  int *stage;                      /* for each row: index of the stage; owned */
  double *cycle, *time;            /* for each row: number of the cycle; time, s, also if no column shows them; owned */
};

bool nb_table_create(struct nb_table *table, size_t column_count); /* a table without rows; false: out of memory */
/* Adds a row of zeros at this stage, cycle and time. NULL: out of memory; the table is then unchanged. */
double *nb_table_row(struct nb_table *table, int stage, double cycle, double time);
void nb_table_free(struct nb_table *table);

/* Tables of the contacts, particles and walls at the end of a stage, for figures. */
struct nb_snapshot {
  int stage; /* index of the stage at whose end it was taken */
  struct nb_table particles, walls, contacts;
  struct nb_table rings;            /* porosity of the rings of each region, against radius */
  struct nb_table boundary;         /* the particles of a boundary, counterclockwise */
  struct nb_table lattice;          /* `snapshot from`: contacts kept, new and lost */
  struct nb_table traction, pieces; /* of a contact test: traction q(r), and D(x) of each piece */
};
struct nb_stage_cost {
  unsigned long cycles;
  unsigned long long updates; /* contact updates */
  double step, seconds;       /* time step, s; processor time of the cycles, with tests of conditions and rows, s */
};
/* Smallest and largest value of a tracked column in all cycles of a stage with `record every N cycles`, N > 1. INFINITY
 * and -INFINITY: there is no value; -INFINITY and INFINITY: not known, since a part of the run did not track the
 * column. */
struct nb_extremes {
  double smallest, largest; /* SI */
};
struct nb_result {
  struct nb_table table;
  struct nb_extremes *extremes;  /* for each stage, all columns; owned */
  struct nb_snapshot *snapshots; /* owned */
  size_t snapshot_count;
  unsigned long cycles;         /* number of cycles of all stages */
  struct nb_stage_cost *stages; /* for each stage; owned */
  unsigned long long updates;   /* contact updates: contacts listed, summed over the calculations of forces */
  unsigned long long searches;  /* number of neighbour searches, including the first one */
  unsigned long long deep;      /* contact updates with overlaps beyond the range of Hertz theory [R89 sec. 6.4.3] */
  char deep_first[3 * NB_NAME_SIZE]; /* the first of them: "particle 1 and particle 2, in cycle 7, at time 1e-06 s" */
  double stability;                  /* largest ratio of the step to the guaranteed stable step in any check, 1 */
  double seconds;                    /* wall-clock time, s */
  bool shortened;                    /* a trial ended a stage before its end */
  struct nb_warnings warnings;       /* found during the run */
};

struct nb_progress {
  /* Called at most ten times a second during a run, with the completed fraction, 0 to 1, and the seconds since the run
   * started; NULL: not called. */
  void (*call)(void *data, const char *stage, double fraction, double seconds);
  void (*note)(void *data, const char *text); /* receives messages of interest to the user; NULL: not called */
  void *data;
  double stage_seconds; /* processor time after which a trial ends each stage, s; 0: the stage runs to its end */
};

/* Runs all stages of the scene and fills `result`; the caller frees it in any case. After NB_BROKEN it contains
 * everything recorded until then. */
enum nb_status nb_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_options *options,
                      const struct nb_progress *progress, struct nb_error *error);
void nb_result_free(struct nb_result *result);
void nb_result_free_snapshots(struct nb_result *result); /* frees the snapshots and keeps the rest */

#endif
