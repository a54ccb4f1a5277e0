/* A scene while it is read: what the files scene_*.c share.
 *
 *   scene.c         the two passes over a page, and what must hold at its end
 *   scene_table.c   the table of keywords
 *   scene_values.c  units, let, sweep and --set
 *   scene_world.c   materials, laws, walls
 *   scene_bodies.c  bodies and watches
 *   scene_fill.c    gradings, and what is filled with them
 *   scene_packing.c bodies from a file
 *   scene_cell.c    the periodic cell, and waves in it
 *   scene_impact.c  a sphere that flies at something
 *   scene_region.c  what is measured together
 *   scene_step.c    step and damping
 *   scene_stages.c  stages, walls in them, how they end; what is recorded
 *   scene_changes.c what else changes in them: materials, gravity; ramps
 *   scene_box.c     a box whose walls are strained
 *   scene_drive.c   what moves an assembly: its boundary, what carries it along
 *   scene_remove.c  bodies that stages take out
 *   scene_start.c   a scene that goes on where another page's stage ends
 *   scene_laws.c    what laws ask of materials and bodies
 *   scene_place.c   the whole scene mirrored, turned, shifted
 *   scene_path.c    of a path: the contact, its legs
 *   scene_follow.c  a path from a file
 *   columns.c       lengths from a file, for both
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SCENE_H
#define NB_SCENE_H

#include "reader.h"

/* Slots of a record: what the values of the statements are. */
enum {
  AT_NAME,
  AT_NAME2,
  AT_X,
  AT_Y,
  AT_X1,
  AT_Y1,
  AT_RADIUS,
  AT_MATERIAL,
  AT_VX,
  AT_VY,
  AT_SPIN,
  AT_FIXED,
  AT_NX,
  AT_NY,
  AT_SPACING,
  AT_DENSITY,
#define ROW(name, ...) AT_##name,
  NB_PAIR_ROWS(ROW)
#undef ROW
      AT_INWARD,
  AT_STOP,
  AT_CYCLES,
  AT_ANGLE,
  AT_ABOUT_X,
  AT_ABOUT_Y,
  AT_SKIN,
  AT_YOUNG,
  AT_POISSON,
  AT_RIGID,
  AT_PIECES,
  AT_SPEED,
  AT_PSI1,
  AT_PHASE,
  AT_GRADING,
  AT_SEED,
  AT_TRIES,
  AT_ELSE,
  AT_SQUARE,
  AT_HEXAGONAL,
  AT_SHEAR,
  AT_C12,
  AT_C21,
  AT_LITERAL,
  AT_APART
};

/* A column asked for by `record`, until all watches are known. */
struct nb_asked {
  char name[2 * NB_NAME_SIZE];
  size_t line;
  int column, length;
};

/* `place`: first mirrored, then turned, then shifted. */
struct nb_place {
  double flip_x, flip_y; /* 1, or -1: mirrored; 0, 0: no such statement */
  double cosine, sine;   /* of the angle that the scene is turned by, counterclockwise */
  double x, y;           /* m */
  int line;
};

struct nb_scene_reading {
  struct nb_scene *scene;
  struct nb_reader reader;  /* of the page */
  struct nb_reader setting; /* of the --set texts, which are kept as the lines of a page of their own */
  struct nb_page settings;
  bool normal_set, shear_set, step_set; /* by --set: what the page says about them is checked and not used */

  bool survey; /* first pass: only units, let and sweep; its mistakes are said in the second one */
  size_t run;
  size_t *rows;              /* of each sweep, in page order, from the survey; owned */
  size_t sweep_count, sweep; /* how many; the next one to come in this pass */

  unsigned here; /* NB_IN_SCENE, behind `start` NB_IN_START, from the first `stage` on NB_IN_STAGE */
  const struct nb_scene_reading *above; /* which starts from this one; NULL: nobody */
  size_t first;                         /* line of the first statement that is not about values */
  bool lost;                            /* `start` has failed: nothing is known of what follows */
  bool opening;            /* the last stage has no name yet: behind `start`, before the first stage of this page */
  unsigned long long hash; /* of what has been read so far */
  int units_line;
  struct nb_place place;
  bool cell_unsure;       /* the statement about the cell was wrong */
  bool bodies_unsure;     /* a statement about bodies was wrong: numbers of bodies cannot be checked */
  struct nb_asked *asked; /* owned */
  size_t asked_count;
  struct nb_repeat {
    size_t from;         /* line of the first stage or leg that is read again */
    unsigned long times; /* how often; 0: nothing is */
    unsigned long now;   /* 2, 3, …: which time this is, 0: the first */
    size_t until;        /* line of the last `repeat` */
  } repeat;
  const char *follow; /* --follow: the name of a file, NULL: none */
  int contact_line;   /* of a path */
};

/* "expected WHAT, found `token`" at a token that was read before. */
void nb_not_known(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what);
/* Index of the material or wall that the token names; -1 with a message when there is none. */
int nb_material_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
int nb_wall_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
struct nb_stage *nb_stage_now(const struct nb_scene *scene); /* the stage that statements belong to; NULL: the scene */
/* Says so, and is true, when the token names a stage that is run before the state from which this page starts. */
bool nb_stage_not_here(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name);
/* Says so when a scene has as many of them already as it may. */
bool nb_too_many(struct nb_reader *reader, size_t count, int most, const char *what);
bool nb_too_many_bodies(struct nb_reader *reader, const struct nb_scene *scene, size_t more);
/* Array growth that failed. */
/* The last --set of that name: its line among the settings; 0: none. */
size_t nb_setting_find(const struct nb_scene_reading *reading, const char *name);
/* Says every --set that nothing on the page answers to, and obeys those for laws and step. */
void nb_settings_read(struct nb_scene_reading *reading);
/* All runs of the page so far: the product of the sweeps. */
size_t nb_runs(const struct nb_scene_reading *reading);
/* A quantity by its name; false with a message in place when there is none, unless an earlier mistake explains that. */
bool nb_asked_find(struct nb_scene_reading *reading, struct nb_quantity *quantity, const struct nb_asked *asked);
/* Says so, and is true, when a line below a `repeat` would belong to what is repeated. */
bool nb_repeat_closed(struct nb_scene_reading *reading);
/* What a scene or a path must have that has been read to its end. */
void nb_whole_check(struct nb_scene_reading *reading);
/* What the laws ask of materials and bodies. */
void nb_laws_check(struct nb_scene_reading *reading);
/* Puts what `impact` names where it just touches, and gives it its velocity: materials, pairs and laws must be known. */
void nb_impact_aim(struct nb_scene_reading *reading);
/* What a path must have; and where --follow puts its own in the place of the legs. */
void nb_path_check(struct nb_scene_reading *reading);
void nb_path_follow(struct nb_scene_reading *reading);
/* What a path's quantities ask of the laws. */
void nb_path_laws_check(struct nb_scene_reading *reading);
/* The points of a file of approach and slip: false when there is a mistake, which has been said. */
bool nb_follow_read(struct nb_leg *leg, const char *path, bool unitless, struct nb_mistakes *mistakes);
/* A mistake of the scene as a whole, shown at the word of its first fence. */
void nb_say_of_scene(struct nb_scene_reading *reading, const char *hint, const char *what);
/* Adds something watched under that name; false with a message when there is one already, or too many. */
bool nb_watch_add(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name,
                  struct nb_watch watch);
/* Finds the stages that regions name. */
void nb_regions_check(struct nb_scene_reading *reading);
/* A cell is wide enough, and there are no walls in it. */
void nb_cell_check(struct nb_scene_reading *reading);
/* A ramp wants a stage whose length is known. */
void nb_ramps_check(struct nb_scene_reading *reading);
bool nb_scene_bounded(const struct nb_scene *scene); /* whether the stage that is being read has a boundary by now */
/* True, with a message, where the scene has no cell. */
bool nb_scene_lacks_cell(const struct nb_scene_reading *reading, struct nb_reader *reader);
bool nb_scene_lacks_box(const struct nb_scene *scene, struct nb_reader *reader); /* likewise a box of walls */
/* EXX EYY, and `shear EXY` or `c12 C` and `c21 C`: all of them per cycle, or none; false with a message. */
bool nb_strain_of(struct nb_strain_rate *strain, struct nb_reader *reader, const struct nb_value value[]);
/* What follows a box moves in one way, and does not turn. */
void nb_boxes_check(struct nb_scene_reading *reading);
/* What is carried along cannot be reversed, nor is there a boundary in a cell. */
void nb_drives_check(struct nb_scene_reading *reading);
/* Moves all that has been read as `place` says. At the end of reading: it wants the motions of walls in the stages too. */
bool nb_scene_place(struct nb_scene *scene, const struct nb_place *place); /* false: something is too far away */
/* What all bodies have in common, those of a lattice or a filling too: reads it into `body`, which will be so many; false with a
 * message. */
bool nb_body_of(struct nb_body *body, const struct nb_scene *scene, struct nb_reader *reader,
                const struct nb_record *record, size_t count);
/* `grading NAME {radius R}`, behind the word: index of the grading, and of its size or -1; -1 with a message. */
int nb_take_grading(const struct nb_scene *scene, struct nb_reader *reader, int *size);

/* The scene of another page, for the one that is being read; *runs: how many its sweeps make. */
enum nb_status nb_scene_read_below(struct nb_scene *scene, const struct nb_page *page, nb_settings settings,
                                   struct nb_mistakes *mistakes, const struct nb_scene_reading *above, size_t *runs);
void nb_start_free(struct nb_start *start);
/* What a state depends on: begun with the settings; then each statement. */
unsigned long long nb_hash_settings(nb_settings settings);
void nb_hash_line(struct nb_scene_reading *reading);
void nb_stages_free(struct nb_scene *scene, size_t from); /* those from there on */
void nb_scene_cut(struct nb_scene *scene, size_t stage);  /* behind that stage; nobody looks at it any more */

/* What the rows of the table call. subject is the struct nb_scene_reading. */
#define NB_APPLY(name) void name(struct nb_reader *reader, const struct nb_record *record, void *subject)
NB_APPLY(nb_apply_units);
NB_APPLY(nb_apply_let);
NB_APPLY(nb_apply_sweep);
NB_APPLY(nb_apply_material);
NB_APPLY(nb_apply_pair);
NB_APPLY(nb_apply_law);  /* variant 0: normal, 1: shear */
NB_APPLY(nb_apply_body); /* variant: enum nb_shape, here and below */
NB_APPLY(nb_apply_lattice);
NB_APPLY(nb_apply_grading);
NB_APPLY(nb_apply_fill);
NB_APPLY(nb_apply_packing); /* variant -1: as the file has them */
NB_APPLY(nb_apply_box);
NB_APPLY(nb_apply_wall);
NB_APPLY(nb_apply_skin);
NB_APPLY(nb_apply_place);
NB_APPLY(nb_apply_watch);
NB_APPLY(nb_apply_region);
NB_APPLY(nb_apply_impact);
NB_APPLY(nb_apply_step);
NB_APPLY(nb_apply_allow);
NB_APPLY(nb_apply_damping);
NB_APPLY(nb_apply_columns);
NB_APPLY(nb_apply_stage);
NB_APPLY(nb_apply_walls);
NB_APPLY(nb_apply_wall_motion);
NB_APPLY(nb_apply_cycles);
NB_APPLY(nb_apply_until);
NB_APPLY(nb_apply_record);
NB_APPLY(nb_apply_snapshot);
NB_APPLY(nb_apply_gravity); /* variant 1: centripetal */
NB_APPLY(nb_apply_change);  /* in a stage; variant 0: material, 1: pair */
NB_APPLY(nb_apply_still);   /* variant 1: reverse */
NB_APPLY(nb_apply_ramp);
NB_APPLY(nb_apply_contact);
NB_APPLY(nb_apply_leg);
NB_APPLY(nb_apply_repeat);
/* Names a stage or a leg; one that is read again NAME-2, NAME-3, … */
void nb_stage_name(struct nb_stage *stage, const struct nb_scene_reading *reading, const struct nb_token *name);
NB_APPLY(nb_apply_cell);
NB_APPLY(nb_apply_cell_strain);
NB_APPLY(nb_apply_box_strain);
NB_APPLY(nb_apply_wave);
NB_APPLY(nb_apply_remove);
NB_APPLY(nb_apply_circle);
NB_APPLY(nb_apply_boundary);  /* variant 0: strain, 1: stress, 2: hold, 3: none */
NB_APPLY(nb_apply_continuum); /* variant 1: none */
NB_APPLY(nb_apply_servo);     /* variant 0: isotropic, 1: mean, 2: stress */
NB_APPLY(nb_apply_rotation);  /* variant 1: off */
NB_APPLY(nb_apply_start);

#endif
