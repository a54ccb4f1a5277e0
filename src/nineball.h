/* nineball: discs and spheres in the plane, by the distinct element method.
 *
 * The public interface: what a page says (struct nb_scene), what runs (struct nb_model, opaque), what comes out
 * (struct nb_table). SI units throughout; a page that says `units none` is passed through unchanged.
 * Every structure says who owns it; nothing here is global, so one program may run many models at once.
 *
 * [CS79] Cundall and Strack, Geotechnique 29 (1979) 47-65.   [R89] Randall, PhD thesis, Aston (1989).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NINEBALL_H
#define NINEBALL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { NB_NAME_SIZE = 64 }; /* longest word a page may use as a name, with its terminating zero */

/* What a program answers to its caller; also the exit status of `nineball`. */
enum nb_status {
  NB_OK = 0,
  NB_FAILED = 1,   /* a check of a page failed */
  NB_BAD_USE = 2,  /* the command line or the page is wrong, or a file cannot be read or written */
  NB_BROKEN = 3,   /* run aborted: NaN, an unstable step, a stage that never ended */
  NB_NO_MEMORY = 4 /* memory ran out: whatever else is said, nothing has been decided */
};

/* One error, in words. The caller owns it; a function that fails fills it once. */
struct nb_error {
  enum nb_status status;
  char text[512];
};

/* ---- warning.c: what is doubtful; it changes no exit status -------------------------------------------------------- */

enum { NB_WARNINGS = 16 };
struct nb_warning {
  char text[400];
  int line; /* of the page; 0: of no line */
};
struct nb_warnings {
  struct nb_warning list[NB_WARNINGS];
  size_t count;
};
/* ---- mistakes.c: what is wrong with a page, every mistake of it at once ------------------------------------------ */

struct nb_mistakes {
  char *text;                        /* the messages, ready to print; NULL while there are none; owned here */
  size_t count;                      /* how many have been said */
  size_t made;                       /* how many there are, with those that are left unsaid */
  bool no_memory;                    /* memory ran out, which counts as made and has no text; it stays so */
  struct nb_mistakes_inside *inside; /* mistakes.c's own; owned here */
};
void nb_mistakes_free(struct nb_mistakes *mistakes);

/* ---- page.c: a Markdown file and its fenced blocks ---------------------------------------------------------------- */

struct nb_page {
  char *path;              /* as given, for messages; owned */
  char name[NB_NAME_SIZE]; /* file name without directory and .md: `nine-discs` */
  char title[128];         /* first heading, without its `#` */
  char **lines;            /* the text, line by line, without line ends; owned */
  size_t line_count;       /* lines[0] is line 1 of the file */
  unsigned char *kind_of;  /* per line, of which block it is (input/reader.h); owned */
  unsigned long long hash; /* FNV-1a of the whole file: what a table says it was made from */
};
enum nb_status nb_page_read(struct nb_page *page, const char *path, struct nb_mistakes *mistakes);
void nb_page_free(struct nb_page *page);

/* ---- names.c: dotted names ---------------------------------------------------------------------------------------- */

struct nb_model;
struct nb_scene;

/* A quantity that can be recorded, waited for or expected: `C.normal`, `time`, `energy.kinetic`. */
struct nb_quantity {
  const struct nb_quantity_kind *kind; /* one row of the table in names.c, NULL: none */
  int monitor;                         /* index of the watch it belongs to, -1: of the whole scene */
  const struct nb_suffix *suffix; /* of a family of quantities (families.c): which of them; NULL: it is one alone */
};

/* Finds `text`; false when the scene has no such name, then `hint` (NB_NAME_SIZE * 2 bytes) holds the nearest one, or is empty. */
bool nb_quantity_find(struct nb_quantity *quantity, const struct nb_scene *scene, const char *text, char *hint);
const char *nb_quantity_unit(struct nb_quantity quantity);                           /* "N", "m", "1" */
double nb_quantity_value(struct nb_quantity quantity, const struct nb_model *model); /* SI */
/* ---- scene.c: what a page says ------------------------------------------------------------------------------------ */

enum nb_shape {
  NB_DISC,  /* a cylinder 1 m thick: m = pi R^2 rho, I = m R^2 / 2 */
  NB_SPHERE /* moves in the plane: m = 4/3 pi R^3 rho, I = 2/5 m R^2 */
};

/* What a page says of the contact of two materials, a row for each property: its word, which is its name in the structures below;
 * its value as the manual shows it, unit and range; what it is when no `material` says it; what two materials make of it (properties.c);
 * and what it is. A row here is all that a property takes: reading, changing, ramping, states and the manual follow. Law files use it
 * as p.NAME, 0 where nothing says it. */
#define NB_PAIR_ROWS(ROW)                                                                                              \
  ROW(kn, "K", STIFFNESS, NOT_NEGATIVE, "0", series, "Normal stiffness of a contact [CS79 16].")                       \
  ROW(ks, "K", STIFFNESS, NOT_NEGATIVE, "0", series, "Shear stiffness of a contact [CS79 17].")                        \
  ROW(friction, "F", NUMBER, NOT_NEGATIVE, "0", smaller, "Tangent of the angle of friction [CS79 19].")                \
  ROW(cohesion, "N", FORCE, NOT_NEGATIVE, "0", smaller, "Cohesion, a force [CS79 19].")
#define NB_PAIR_MEMBER(name, ...) double name;

struct nb_material {
  char name[NB_NAME_SIZE];
  double density;              /* kg/m3 */
  NB_PAIR_ROWS(NB_PAIR_MEMBER) /* of a contact between like materials */
  double young;                /* E, Pa, of laws for elastic spheres; INFINITY: rigid; 0: not said [R89 4.7] */
  double poisson;              /* nu, 1; G = E/2(1 + nu) */
  int line;                    /* of the page, for messages */
};

/* `pair A B ...`: what the rules for unlike materials would say otherwise; NAN where the rule stands. */
struct nb_pair_rule {
  int a, b; /* materials */
  NB_PAIR_ROWS(NB_PAIR_MEMBER)
  int line;
};

/* A body is known by its number for ever: 1, 2, ... in the order of the page; here at index number - 1. */
struct nb_particle {
  enum nb_shape shape;
  double x, y, radius; /* m */
  double vx, vy;       /* m/s, at time 0 */
  double spin;         /* rad/s, counterclockwise, at time 0 */
  int material;
  int fixed; /* 1: held where it is, its mass counts as infinite */
  int line;
};

/* `grading`: how many bodies of which size. */
struct nb_size {
  double radius;         /* m */
  size_t count;          /* of one filling with this grading */
  size_t wanted, placed; /* in all fillings with it */
};
struct nb_grading {
  char name[NB_NAME_SIZE];
  struct nb_size *sizes; /* largest first; owned by the scene */
  size_t size_count;
  size_t count; /* of all sizes */
  int line;
};

/* `fill`: bodies of a grading at random in a circle or a box. Where it was before `transform` moved the scene. */
struct nb_fill {
  bool circle;
  double x, y;   /* m: the centre of the circle, or the south-west corner of the box */
  double radius; /* m, of the circle */
  double x1, y1; /* m, the north-east corner of the box */
  int grading;
  unsigned long seed;
  unsigned long attempts;  /* for each body */
  bool skip;               /* goes on with the next smaller size when one does not fit; else that is a mistake */
  size_t first, count;     /* the bodies it made */
  unsigned long long made; /* tries of all */
  int line;
};

/* `packing`: bodies that a file has put there. */
struct nb_packing {
  char *path;          /* owned by the scene */
  size_t first, count; /* the bodies that have come from it */
  int line;
};

/* A wall is the part of a line from P + h1 e to P + h2 e [CS79 figure 4]. It pushes on both sides. */
struct nb_wall {
  char name[NB_NAME_SIZE];
  double x, y;     /* P, m */
  double ex, ey;   /* e, of length 1 */
  double h1, h2;   /* m */
  double h0;       /* m: its line lies so far from P, along e turned counterclockwise; 0 for those of [CS79 figure 4] */
  double inx, iny; /* unit normal that points into the box that made it; 0, 0 when it is no box's wall */
  double vx, vy;   /* of P at time 0, m/s */
  double spin;     /* about P at time 0, rad/s, counterclockwise */
  int material;
  int line;
};

/* Damping has four conventions in the two papers, so four words; see docs/METHOD.md. */
enum nb_contact_damping {
  NB_CONTACT_UNDAMPED,
  NB_CONTACT_STIFFNESS,    /* c = beta k, beta a time, s [CS79 28] */
  NB_CONTACT_R89_FRACTION, /* c = beta k t_c / 2, t_c the critical step: N dN beta/(2 FRAC) of [R89 4.3, 4.4] */
  NB_CONTACT_RATIO         /* c = beta 2 sqrt(M* k), a share of critical [R89 4.13] */
};
enum nb_global_damping {
  NB_GLOBAL_UNDAMPED,
  NB_GLOBAL_MASS,          /* C = alpha m, alpha in 1/s [CS79 34-36] */
  NB_GLOBAL_CON1_CS79,     /* v = (CON1 v + F dt/m) / (2 - CON1): CS79 35 with CON1 = 1 - alpha dt/2 */
  NB_GLOBAL_CON1_VELOCITY, /* v = CON1 v + F dt/m */
  NB_GLOBAL_CON1_ALL       /* v = CON1 (v + F dt/m): the reading in which CON1 = 0 damps completely [R89 6.5.1] */
};
struct nb_damping {
  enum nb_contact_damping contact_kind;
  double contact; /* s or 1 */
  int contact_line;
  bool walls_separate; /* contacts with walls have their own: */
  enum nb_contact_damping walls_kind;
  double walls; /* s or 1 */
  int walls_line;
  double
      deep; /* contacts that overlap by more than this share of the smaller diameter are damped critically; 0: none */
  int deep_line;
  enum nb_global_damping global_kind;
  double global; /* 1/s or 1 */
  int global_line;
};
/* What damps a contact of two bodies, or one with a wall, and how much, s or 1. */
enum nb_contact_damping nb_damping_at(const struct nb_damping *damping, bool wall, double *value);
bool nb_damping_equal(const struct nb_damping *a, const struct nb_damping *b);
bool nb_damping_none(const struct nb_damping *damping); /* neither contacts nor bodies are damped */

enum nb_step_kind {
  NB_STEP_TIME,           /* value in s */
  NB_STEP_SINGLE_CONTACT, /* value times 2 sqrt(m/k), smallest mass over largest stiffness [CS79, Motion] */
  NB_STEP_STABLE,         /* value times what is sure to be stable as the stage begins, see src/measure/stable_step.c */
  NB_STEP_COLLISION,      /* value times the duration of the shortest contact there can be, see src/measure/step.c */
  NB_STEP_RAYLEIGH, /* value times Rayleigh's wave's way half round the smallest sphere, see src/measure/rayleigh_step.c */
  NB_STEP_RAYLEIGH_MEAN,
  NB_STEP_RAYLEIGH_FIT, /* with R89's fit of that wave's speed; of the sphere that is the mean of all: R89's step */
  NB_STEP_RAYLEIGH_FIT_MEAN
};
struct nb_step {
  enum nb_step_kind kind;
  double value;
  int line;
  bool set; /* by --set: it holds from the start on, whatever the page says */
};

/* Something a page looks at, under a name of its own. */
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
  int a, b; /* index of a body, wall, region, grading or size of it, as the kind says; -1 where there is none */
  int line;
};

/* `region NAME ...`: a part of the plane whose bodies are measured together; its watch has its name. */
enum nb_region_kind { NB_REGION_CIRCLE, NB_REGION_BOX, NB_REGION_ALL, NB_REGION_INSIDE };
struct nb_region {
  enum nb_region_kind kind;
  double x, y;             /* centre, m */
  double radius;           /* m; of NB_REGION_INSIDE its share of the boundary's mean radius, 1 */
  double ex, ey;           /* of a box, and of all: unit vector along one side; */
  double half_x, half_y;   /* half its length along e and across, m */
  int rings;               /* how many rings of equal width a snapshot measures; 0: none */
  char from[NB_NAME_SIZE]; /* the stage with which strain begins; empty: the start */
  int stage;               /* its index; -1: the start */
  int line;
};

/* `gravity GX GY`: the same acceleration on all bodies that are free; `gravity centripetal G about X Y`: towards a point. */
struct nb_gravity {
  double x, y;             /* m/s2 */
  double central;          /* m/s2, towards the point: */
  double about_x, about_y; /* m */
  bool ramp;               /* reached at the end of the stage, along a straight line */
  int line;                /* of the page; 0: not said here */
};

/* `material` or `pair` in a stage: what holds from there on. NAN where nothing is said: it stays as it is. */
struct nb_change {
  int a, b;                    /* materials; b is -1 where the change is of material a itself, not of the pair */
  NB_PAIR_ROWS(NB_PAIR_MEMBER) /* as in struct nb_material */
  bool ramp;                   /* reached at the end of the stage, along a straight line */
  int line;
};

/* `impact`: a sphere flies at what its watch names with it. Reading puts it where it just touches and gives it its velocity;
 * the run begins the share `phase` of a step before that. */
struct nb_impact {
  int monitor;  /* the contact; its first body is the one that flies */
  double speed; /* of its centre relative to what it strikes, m/s */
  double angle; /* from the normal, rad; NAN: it follows from psi1 */
  double psi1;  /* Maw's angle of incidence, 1 [R89 5.15]; NAN: it follows from the angle */
  double phase; /* 0 to 1 */
  int line;     /* 0: there is no such statement */
};

/* What happens to a wall when a stage begins. It lasts until another stage says otherwise. */
struct nb_wall_motion {
  int wall;      /* index */
  double vx, vy; /* of P, m/s */
  double spin;   /* about P, rad/s */
  bool ramp;     /* reached at the end of the stage, along a straight line */
  int line;
};

/* `remove disc N`: bodies that are taken out when a stage begins. */
struct nb_removal {
  size_t from, to; /* indices of the first and the last one */
  int line;
};

/* `cell`: copies of it fill the plane. Its sides are the columns of H = (h[0] h[1], h[2] h[3]). */
struct nb_scene_cell {
  double x, y; /* its centre, m */
  double h[4]; /* m */
  int line;    /* 0: there is none */
};

/* A velocity gradient: x' = xx x + xy y, y' = yx x + yy y, extension positive [R89 4.43, 4.44]. */
struct nb_strain_rate {
  double xx, xy, yx, yy; /* 1/s; or, */
  bool per_cycle;        /* strain of one cycle: divided by the step when it is used */
};

/* Contact laws by the names of their files, `linear`, `none`; empty: as before. What is remembered of contacts by a law that is
 * another one from now on is forgotten. */
struct nb_laws {
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE];
  int normal_line, shear_line;
  int pieces; /* of a contact's history that the shear law keeps, at most; 0: as many as it likes best */
};

enum nb_relation { NB_BELOW, NB_ABOVE };
struct nb_condition {
  char name[2 * NB_NAME_SIZE]; /* as written */
  struct nb_quantity quantity;
  enum nb_relation relation;
  double value; /* SI */
  int line;
};

/* Where a leg of a path takes one side of the contact: the normal side, or the tangential one. */
struct nb_target {
  bool force;   /* it is the force that goes along a straight line, else overlap or slip */
  bool by;      /* from where it is, by `value`; else to `value` */
  double value; /* m or N; by 0: held */
};
struct nb_path_point {
  double approach, slip; /* m; an approach below 0 is a gap */
};

/* One leg of a path: what the contact on the bench goes through while a stage of a path page lasts. */
struct nb_segment {
  struct nb_target normal, shear;
  struct nb_path_point *points; /* `follow FILE`: instead of the aims, one step to each; owned by the scene */
  size_t point_count;
};

/* `boundary circle`: bodies whose centres are on it or beyond are the assembly's boundary. */
struct nb_circle {
  double x, y, radius; /* m */
  int line;            /* 0: none begins here */
};

/* What a stage does with the boundary, and with all other bodies; it lasts until another stage says otherwise. */
enum nb_control { NB_CONTROL_STRAIN, NB_CONTROL_STRESS, NB_CONTROL_NONE };
struct nb_boundary {
  enum nb_control control;
  struct nb_strain_rate strain; /* NB_CONTROL_STRAIN: its centres follow it; `hold`: 0 */
  double sxx, syy, sxy;         /* Pa, compression positive. NB_CONTROL_STRESS: forces on its bodies */
  int line;                     /* 0: as before */
};
struct nb_affine_motion {
  struct nb_strain_rate strain; /* `none`: 0 */
  bool accumulated; /* added to the velocity in every cycle and kept in it: R89 4.43, 4.44 as they are coded */
  int line;         /* 0: as before */
};

/* `servo`: strain rates are added to the stage's so that a stress comes to be what it should. */
struct nb_servo {
  struct nb_quantity quantity[4]; /* that are looked at: xx, xy, yx, yy */
  double stress[3];               /* what they should be, Pa */
  bool controlled[3];             /* which of them */
  double east[2], north[2];       /* x and y of the unit vectors that xx, yy and xy are about */
  bool mean;                      /* only (xx + yy)/2 */
  bool affine;                    /* the continuum's strain rate is changed as the boundary's is; or */
  bool cell;                      /* the cell's alone; or */
  bool box;                       /* the box's */
  bool ramp;                      /* reached at the end of the stage, along a straight line */
  double max_rate;                /* largest component of what is added, 1/s or, */
  bool per_cycle;                 /* strain of one cycle */
  unsigned long every;            /* cycles between one look and the next */
  int line;                       /* 0: none */
};

struct nb_stage {
  char name[NB_NAME_SIZE];
  struct nb_servo servo;
  struct nb_circle circle;        /* a boundary that begins with this stage */
  struct nb_boundary boundary;    /* what is done with it */
  struct nb_affine_motion affine; /* what carries all others along */
  enum nb_rotation { NB_ROTATION_AS_BEFORE, NB_ROTATION_ON, NB_ROTATION_OFF } rotation;
  int rotation_line;
  struct nb_wall_motion *motions; /* owned by the scene */
  size_t motion_count;
  struct nb_change *changes; /* of materials and pairs; owned by the scene */
  size_t change_count;
  struct nb_gravity gravity;   /* line 0: as before */
  struct nb_strain_rate cell;  /* how the cell is strained */
  int cell_line;               /* 0: as before */
  struct nb_strain_rate box;   /* how the walls of the box follow */
  int box_line;                /* 0: as before */
  struct nb_removal *removals; /* owned by the scene */
  size_t removal_count;
  bool zero_velocities;            /* it begins with all bodies at rest */
  bool reverse_velocities;         /* it begins with all velocities turned round, of walls too */
  struct nb_condition *conditions; /* all must hold; owned by the scene */
  size_t condition_count;
  unsigned long cycles;          /* how many; with conditions: at most, and reaching it is a failure */
  unsigned long check_interval;  /* conditions are looked at every so many cycles */
  unsigned long record_interval; /* a row every so many cycles, 0: none */
  bool snapshot;                 /* keep bodies, walls and contacts as they are at its end, */
  int snapshot_from;             /* and what has changed since the stage of this index began; -1: not asked */
  struct nb_step step;           /* as the scene's, unless the stage says otherwise */
  bool allow_unstable;           /* the step is not watched in this stage */
  struct nb_damping damping;     /* as the stage before, unless this one says otherwise */
  struct nb_laws laws;           /* as the stage before where they are empty */
  unsigned long long hash;       /* of all that the page says up to the end of this stage, but what is only looked at */
  struct nb_segment segment;     /* of a path: `cycles` are its steps */
  int line;
};

struct nb_column {
  char name[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
};

/* `start PAGE stage NAME`: the scene goes on where a stage of another page ends. The scene has all that the other one has, its
 * stages too; those are not run again, but their end is looked up among the saved states, or made first. */
struct nb_start {
  struct nb_page *page;               /* the other one; owned, as is all below */
  struct nb_scene *scene;             /* and what it says, up to the end of that stage */
  char (*settings)[2 * NB_NAME_SIZE]; /* which it is given: "v=0.1 m/s" */
  size_t setting_count;
  size_t stages; /* so many of the stages are those of the other page; 0: no such statement */
  int line;
};

/* One run of a page: every name resolved, every number SI. Filled by nb_scene_read, constant from there on;
 * references read the same structure. Owns everything its pointers reach. */
struct nb_scene {
  const struct nb_page *page; /* not owned */
  bool unitless;              /* `units none` */
  bool contact_test;          /* one contact on a bench: of body 1 with body 2, or with the wall; stages are legs */
  bool path_replaced;         /* a path of the user's own instead of the page's legs: nothing is expected of it */
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
  int pieces; /* of a contact's history that the shear law keeps, at most; 0: as many as it likes best */
  struct nb_damping damping;
  struct nb_gravity gravity; /* at time 0 */
  struct nb_circle circle;   /* `boundary circle` before the first stage */
  double origin_x, origin_y; /* m: what strain rates are about where no boundary has a centre */
  struct nb_step step;
  bool allow_unstable; /* the step is not watched in any stage */
  double skin;         /* m: pairs closer than this are listed [R89 TOL]; 0: not said, a tenth of the mean radius */
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
  struct nb_binding *bindings; /* what $NAME stands for in this run: input/reader.h */
  size_t binding_count;
  struct nb_warnings warnings; /* found while it was read */
};

/* `--set NAME=VALUE`, as often as wanted: NULL-terminated array of such texts, or NULL for none. */
typedef const char *const *nb_settings;

/* How many runs the sweeps of a page make: the product of their lengths; 1 when those are wrong or too long. */
size_t nb_scene_runs(const struct nb_page *page, nb_settings settings, struct nb_mistakes *mistakes);
/* Reads run 0 <= run < runs. All mistakes of its scene blocks are said at once. When there are any the scene holds what could
 * be read: enough to read on, not to run; free it in any case. */
enum nb_status nb_scene_read(struct nb_scene *scene, const struct nb_page *page, size_t run, nb_settings settings,
                             struct nb_mistakes *mistakes);
void nb_scene_free(struct nb_scene *scene);

/* ---- model.c, cycle.c: what runs ----------------------------------------------------------------------------------- */

struct nb_options {
  int threads;        /* 0: as many as OpenMP would take */
  const char *isa;    /* "plain", "avx2", "avx512"; NULL: the widest this machine has */
  int jobs;           /* runs of a sweep side by side; 0: as many as there are processors for `threads` each */
  bool shuffle;       /* store the bodies in another order than their numbers: a test that order changes nothing */
  bool keep_all;      /* keep of contacts all that a saved state holds */
  const char *states; /* folder of saved states; NULL: `states` */
};

/* NULL and a filled error when it cannot be made. The scene must outlive the model. */
struct nb_model *nb_model_create(const struct nb_scene *scene, const struct nb_options *options,
                                 struct nb_error *error);
void nb_model_free(struct nb_model *model);

/* One calculation cycle at a time: forces at t_N, then motion to t_(N+1) [CS79, The calculation cycle]. */
enum nb_status nb_cycle(struct nb_model *model, struct nb_error *error);

/* ---- observe.c: what comes out --------------------------------------------------------------------------------------- */

/* Rows of numbers under named columns. */
struct nb_table {
  size_t column_count, row_count;
  char (*names)[2 * NB_NAME_SIZE]; /* owned */
  const char **units;              /* the texts are constants */
  double *values;                  /* row by row, column_count each; owned */
  int *stage;                      /* per row: index of the stage; owned */
  double *cycle, *time;            /* per row, whether the page records them or not; owned */
};

bool nb_table_create(struct nb_table *table, size_t column_count);
/* A new row, its values 0, at this stage, cycle and time; NULL: out of memory, the table is as it was. */
double *nb_table_row(struct nb_table *table, int stage, double cycle, double time);
void nb_table_free(struct nb_table *table);

/* The contacts, bodies and walls at one moment: what a picture of forces needs. */
struct nb_snapshot {
  int stage; /* index of the stage at whose end it was taken */
  struct nb_table particles, walls, contacts;
  struct nb_table rings;   /* of regions: porosity by radius */
  struct nb_table lattice; /* `snapshot from`: which contacts are kept, new and lost */
  struct nb_table traction,
      pieces; /* of a path's contact: q(r), and D(x) from the edge of each piece to that of the next */
};
struct nb_result {
  struct nb_table table;
  struct nb_snapshot *snapshots; /* owned */
  size_t snapshot_count;
  unsigned long cycles;        /* done in all */
  unsigned long *stage_cycles; /* per stage; owned */
  unsigned long long updates;  /* contact updates: contacts listed, summed over cycles */
  unsigned long long searches; /* for contacts, the first one included */
  unsigned long long deep;     /* contact updates with overlaps above what elastic spheres are good for [R89 6.4.3] */
  char deep_first[3 * NB_NAME_SIZE]; /* the first of them: "body 1 at body 2, cycle 7, 1e-06 s" */
  double seconds;                    /* of wall clock */
  struct nb_warnings warnings;       /* found while it ran */
};

/* Called about ten times a second while a run goes on, with the share done (0 to 1) and the seconds since its start. */
struct nb_progress {
  void (*call)(void *data, const char *stage, double fraction, double seconds); /* or NULL */
  void (*note)(void *data, const char *text);                                   /* what is worth a word; or NULL */
  void *data;
};

/* The whole scene, all stages. On NB_BROKEN the result holds what was seen until then. */
enum nb_status nb_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_options *options,
                      const struct nb_progress *progress, struct nb_error *error);
void nb_result_free(struct nb_result *result);

/* What `nineball explain` prints: the plan, what asked for it, bytes, the step and what sets it; of a path the contact, its laws, its
 * legs. Warnings of the plan are added to those that are there. */
enum nb_status nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_options *options,
                          struct nb_warnings *warnings, struct nb_error *error);

#endif
