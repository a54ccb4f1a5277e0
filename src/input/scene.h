/* A scene while it is read. The files of statements include this header.
 *
 * Each of these files has one statement or a family of statements: the rows of their arguments, the functions that
 * apply them, and at the end of the file the table NB_STATEMENTS (statement.h) with their words, help and examples.
 * STATEMENTS in build-aux/lists.mk lists these files, in the order of the manual. scene.c has the common parts: the two
 * passes over a page, and the checks at its end.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reader.h"

/* ---- a scene while it is read ---- */

/* A column that `record` requests, kept until all monitors are known. */
struct nb_requested {
  char name[2 * NB_NAME_SIZE];
  size_t line;
  int column, length;
};

/* `transform`: the scene is first mirrored, then rotated, then translated. */
struct nb_transform {
  double flip_x, flip_y; /* 1, or -1: mirrored */
  double cosine, sine;   /* of the angle of rotation, counterclockwise */
  double x, y;           /* translation, m */
  bool overflow;         /* a number that has been transformed is not finite */
  int line;
};

struct nb_scene_reading {
  struct nb_scene *scene;
  struct nb_reader reader;  /* reads the page */
  struct nb_reader setting; /* reads the --set texts, which are stored as the lines of a page */
  struct nb_page settings;
  bool before_start; /* the page has a `start`, which has not been read yet */
  /* --set gives the normal law, the shear law; the step. Those of the page are then only checked. */
  bool law_set[2], step_set;
  bool shear_written; /* the shear law of the scene is a word of its line, not the value of a name or of --set */

  bool survey;               /* the first pass: it reads only units, let and sweep, and reports no mistakes */
  size_t run;                /* index of the run that is read */
  size_t *rows;              /* number of rows of each sweep, in page order, from the first pass; owned */
  size_t sweep_count, sweep; /* number of sweeps; index of the next one in this pass */

  /* NB_IN_SCENE, after `start` NB_IN_START, from the first `stage` on NB_IN_STAGE; in a contact test NB_IN_CONTACT_TEST,
   * from the first `segment` on NB_IN_SEGMENT. */
  unsigned here;
  const struct nb_scene_reading *parent; /* the page that starts from this one, or NULL */
  size_t first_line;                     /* line of the first statement other than `units`, `let` and `sweep` */
  bool start_failed;                     /* `start` has a mistake: the rest of the page is not read */
  /* After `start`: the last stage of the scene is the first stage of this page, which has no name yet. */
  bool before_first_stage;
  unsigned long long hash; /* hash of the statements read so far */
  int units_line;
  struct nb_transform transform;
  bool ramping;                   /* the statement stands after `ramp` */
  struct nb_requested *requested; /* owned */
  size_t requested_count;
  struct nb_repeat {
    size_t from;         /* line of the first repeated stage or segment */
    unsigned long times; /* number of repetitions; 0: none */
    unsigned long now;   /* 2, 3, …: the current repetition; 0: the first reading */
    size_t until;        /* line of the last `repeat` */
  } repeat;
  const char *follow; /* `--set follow=FILE`: the name of the file, or NULL */
  int contact_line;   /* line of the statement `contact` of a contact test; 0: none */
  /* The last `servo` with a mistake: the condition on the stress that it wants to control, and its line. */
  char servo_wanted[4 * NB_NAME_SIZE];
  int servo_wanted_line;
};

/* The stage of the current line; NULL: before the first stage. */
struct nb_stage *nb_current_stage(const struct nb_scene *scene);

/* ---- mistakes common to several statements ---- Each function reports its mistake. Unless its comment says otherwise,
 * it returns true if the statement is bad, because of this mistake or an earlier one. */

/* The statement is given twice. line: the line of the first one; 0: there is none. */
bool nb_given_twice(struct nb_reader *reader, int line);
/* The same for a statement whose first word does not say what is given twice; `what` says it. */
bool nb_set_twice(struct nb_reader *reader, const char *what, int line);
bool nb_too_many(struct nb_reader *reader, size_t count, int most, const char *what); /* count has reached most */
bool nb_too_many_particles(struct nb_reader *reader, const struct nb_scene *scene, size_t more);
/* The name is taken. line: the line that defines it; 0: it is not taken. */
bool nb_exists(struct nb_reader *reader, const struct nb_token *name, const char *what, int line);
/* The first corner of a box does not have the smaller x and the smaller y, or the corners are infinitely far apart. */
bool nb_corners_swapped(struct nb_reader *reader, double x, double y, double x1, double y1);
/* True, without a report, if a statement that defines particles has a mistake, so that numbers of particles cannot be
 * checked. */
bool nb_particles_incomplete(const struct nb_scene_reading *reading);
/* These functions report: the scene has no cell; it has no box of walls; the current stage has no boundary. */
bool nb_lacks_cell(const struct nb_scene *scene, struct nb_reader *reader);
bool nb_lacks_box(const struct nb_scene *scene, struct nb_reader *reader);
bool nb_lacks_boundary(const struct nb_scene *scene, struct nb_reader *reader);
/* The token names a stage of the page from which this page starts. Returns true for this mistake only. */
bool nb_stage_before_start(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name);
/* Warns of a statement below `cycles` or `until` that acts when its stage begins. */
void nb_late_warn(struct nb_scene_reading *reading);
/* A statement of a stage is below a `repeat`, where it would belong to the last repeated stage only. Returns true
 * for this mistake only. */
bool nb_misplaced_after_repeat(struct nb_scene_reading *reading);
/* Reports a mistake of the whole scene, at its first fence, unless messages about `statement` are suppressed. */
void nb_scene_mistake(struct nb_scene_reading *reading, const char *statement, const char *hint, const char *what);

/* ---- arguments common to several statements ---- */

/* Index of the material or wall that the token names; -1 as nb_named. */
int nb_material_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
int nb_wall_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
/* wall.c: removes the wall with this name in the current stage. */
void nb_wall_remove(const struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name);
/* Takes NAME {radius R} after `grading`. Returns the index of the grading, or -1 with a message; *size: the index of
 * the size; -1 if the statement names no size or, with a message, one that the grading does not have. */
int nb_take_grading(const struct nb_scene *scene, struct nb_reader *reader, int *size);
/* The hint how to define what a statement lacks. After `cell strain`, `box strain` or `boundary strain` it also refers to
 * the help that compares them. */
#define NB_DEFINE(reader, how)                                                                                         \
  ((reader)->count > 1 && strcmp((reader)->tokens[1].text, "strain") == 0 ? how                                        \
       "; `nineball --help strain` compares the four statements"                                                       \
                                                                          : how)
/* nb_take_requested takes the name of a quantity from the line; nb_requested_find finds the quantity of this name, when
 * all monitors are known. Both return false with a message; the second one without a message if the name is
 * suppressed. */
bool nb_take_requested(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_requested *requested);
bool nb_requested_find(struct nb_scene_reading *reading, struct nb_quantity *quantity,
                       const struct nb_requested *requested);
/* Slots of a strain rate; NB_AT_AFTER_STRAIN: the next free slot. */
enum { NB_AT_XX, NB_AT_YY, NB_AT_XY, NB_AT_C12, NB_AT_C21, NB_AT_AFTER_STRAIN };
/* The strain rate EXX EYY, with `shear EXY` or with `c12 C` and `c21 C`. Either all components are per cycle or
 * none. */
struct nb_strain_rate nb_strain_rate_of(struct nb_reader *reader, const struct nb_value value[]);
/* True if the unit of a value is `per cycle`. */
bool nb_value_per_cycle(const struct nb_reader *reader, const struct nb_value *value);
/* A particle at (0, 0) for a statement that adds `count` such particles. Reports a count that is too large, and a
 * material without density for a free particle. */
struct nb_particle nb_particle_of(struct nb_reader *reader, const struct nb_scene *scene, enum nb_shape shape,
                                  const struct nb_token *material, bool fixed, size_t count);
/* Adds a monitor; false with a message if the name exists or there are too many. */
bool nb_monitor_add(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name,
                    struct nb_monitor monitor);
/* Sets the name of a stage or a segment: NAME, or NAME-2, NAME-3, … for the repeated ones. */
void nb_stage_name(struct nb_stage *stage, const struct nb_scene_reading *reading, const struct nb_token *name);

/* ---- settings and runs ---- */

/* The line, among the settings, of the last --set of this name; 0: none. */
size_t nb_setting_find(const struct nb_scene_reading *reading, const char *name);
/* nb_settings_read applies the settings that are not values of a `let` or `sweep`, and reports unknown names. On a page
 * with `start` the second function applies the setting of the step, when the units of the other page are known. */
void nb_settings_read(struct nb_scene_reading *reading);
void nb_setting_read_step(struct nb_scene_reading *reading);
/* Number of runs that follows from the sweeps read so far; 1 if there are more than NB_RUNS_MAX. */
size_t nb_run_count(const struct nb_scene_reading *reading);
/* The hash of everything on which a state depends. It begins with the settings; nb_hash_line then adds each statement
 * on which a state depends. */
unsigned long long nb_hash_settings(nb_settings settings);
void nb_hash_line(struct nb_scene_reading *reading);

/* ---- checks at the end of a page: each reports a scene that does not satisfy the condition ---- */

/* Materials and particles satisfy the requirements of the laws. `complete`: the page has no mistake so far; otherwise
 * only the shapes of the particles are checked. */
void nb_laws_check(struct nb_scene_reading *reading, bool complete);
/* Regions name only stages of this page; the function stores the index of each. A scene with a region `inside` has a
 * boundary. */
void nb_regions_check(struct nb_scene_reading *reading);
/* A cell is wide enough, and has no walls. */
void nb_cell_check(struct nb_scene_reading *reading);
/* True if `repeat` has made the stage: an earlier one has the same line. */
bool nb_is_repeated(const struct nb_scene *scene, size_t s);
/* A stage with a ramp has a known number of cycles. */
void nb_ramps_check(struct nb_scene_reading *reading);
/* Walls that follow the strain of a box have no other motion. */
void nb_box_check(struct nb_scene_reading *reading);
/* Warns of an inherited strain rate against which a servo works, and of conditions: nb_servo_compare. */
void nb_servo_check(struct nb_scene_reading *reading);
/* The condition that the stress which the servo of the current stage controls is near its target; NULL: the stage has no
 * servo. Written to `text` if the statement `servo` has no mistake. */
const char *nb_servo_wanted(char *text, size_t size, const struct nb_scene_reading *reading);
/* Warns of conditions on a normal strain of the other sign than the strain rate of the stage. */
void nb_strain_check(struct nb_scene *scene);
/* The motion of a wall after the first `stages` stages; `reverse velocities` changes the sign of earlier motions. */
struct nb_wall_motion nb_wall_motion_after(const struct nb_scene *scene, size_t stages, size_t index);
/* The sign of the strain rate along x or y, axis 0 or 1, that the walls which move in a stage impose on the particles
 * between them; 0: none moves, or some compress and others extend. */
int nb_walls_strain_sign(const struct nb_scene *scene, size_t s, int axis);
/* Warns of free particles whose centres begin outside the box. */
void nb_outside_check(struct nb_scene *scene);
/* Warns of gravity upwards, away from all walls and fixed particles. Not called after `transform`, which rotates the
 * gravity of the page. */
void nb_fall_check(struct nb_scene *scene);
/* Warns of walls that rotate about their middle because their line does not say about which point. */
void nb_spin_check(struct nb_scene *scene);
/* Imposed motion other than that of a cell is not reversed; a scene with a cell has neither a boundary nor `affine
 * strain`. */
void nb_imposed_motion_check(struct nb_scene_reading *reading);
/* A contact test has a contact and a segment. The function also applies `--set follow=FILE`. */
void nb_contact_test_check(struct nb_scene_reading *reading);
/* The laws satisfy the requirements of the quantities of a contact test. */
void nb_contact_test_laws_check(struct nb_scene_reading *reading);
/* Applies `--set refine=R` to steps, numbers of cycles and strains per cycle (refine.c). */
void nb_refine(struct nb_scene_reading *reading);
/* Applies `--set soften=S`. */
void nb_soften(struct nb_scene_reading *reading);
/* Sets position and velocity of the particle of `impact`; materials, pairs and laws must be known. */
void nb_impact_set(struct nb_scene_reading *reading);
/* Applies `transform` to the whole scene, after all stages have been read. False: a coordinate is not finite. */
bool nb_scene_transform(struct nb_scene *scene, struct nb_transform *transform);

/* ---- a page from which another one starts ---- */

/* Reads the scene of another page for `start`. `parent`: the page that has the `start`. */
enum nb_status nb_scene_read_nested(struct nb_scene *scene, const struct nb_page *page, nb_settings settings,
                                    struct nb_mistakes *mistakes, const struct nb_scene_reading *parent);
void nb_start_free(struct nb_start *start);
void nb_stages_free(struct nb_scene *scene, size_t from); /* frees the stages from index `from` on */
/* Removes the stages after the one with index `stage`, and the output of the scene. */
void nb_scene_truncate(struct nb_scene *scene, size_t stage);
