/* A scene while it is read: what the statements share.
 *
 * A statement, or a family of them, is a file: the rows of what it takes, the function that applies it, and at its end its words with
 * help and example, NB_STATEMENTS (statement.h). STATEMENTS in build-aux/lists.mk names these files; the register is made from it, and
 * the manual has them in its order. What is common to all is in scene.c: the two passes over a page, and what must hold at its end.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SCENE_H
#define NB_SCENE_H

#include "reader.h"

/* ---- a scene while it is read ---- */

/* A column asked for by `record`, until all watches are known. */
struct nb_requested {
  char name[2 * NB_NAME_SIZE];
  size_t line;
  int column, length;
};

/* `transform`: first mirrored, then rotated, then translated. */
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
  bool law_set[2], step_set; /* by --set: what the page says about them is checked and not used */

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
  struct nb_requested *requested; /* owned */
  size_t requested_count;
  struct nb_repeat {
    size_t from;         /* line of the first stage or leg that is read again */
    unsigned long times; /* how often; 0: nothing is */
    unsigned long now;   /* 2, 3, …: which time this is, 0: the first */
    size_t until;        /* line of the last `repeat` */
  } repeat;
  const char *follow; /* --follow: the name of a file, NULL: none */
  int contact_line;   /* of a path */
};

struct nb_stage *nb_stage_now(const struct nb_scene *scene); /* the stage that statements belong to; NULL: the scene */

/* ---- mistakes that several statements may make: true when the statement is bad, now or before ---- */

bool nb_given_twice(struct nb_reader *reader, int line); /* line: of the first one, 0: there is none */
bool nb_too_many(struct nb_reader *reader, size_t count, int most, const char *what); /* as many as there may be */
bool nb_too_many_particles(struct nb_reader *reader, const struct nb_scene *scene, size_t more);
bool nb_exists(struct nb_reader *reader, const struct nb_token *name, const char *what, int line); /* 0: no */
/* The corners of a box are not south-west and north-east. */
bool nb_inside_out(struct nb_reader *reader, double x, double y, double x1, double y1);
/* A statement about bodies was wrong: numbers of bodies cannot be checked. */
bool nb_particles_incomplete(const struct nb_scene_reading *reading);
/* The scene has no cell; no box of walls; the stage that is being read no boundary. */
bool nb_lacks_cell(const struct nb_scene *scene, struct nb_reader *reader);
bool nb_lacks_box(const struct nb_scene *scene, struct nb_reader *reader);
bool nb_lacks_boundary(const struct nb_scene *scene, struct nb_reader *reader);
/* The token names a stage that is run before the state from which this page starts. */
bool nb_stage_not_here(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name);
/* A line below a `repeat` would belong to what is repeated. */
bool nb_repeat_closed(struct nb_scene_reading *reading);
/* A mistake of the scene as a whole, shown at the word of its first fence; excused by mistakes in statements of that name. */
void nb_say_of_scene(struct nb_scene_reading *reading, const char *statement, const char *hint, const char *what);

/* ---- what several statements take ---- */

/* Index of the material or wall that the token names; -1 with a message when there is none. */
int nb_material_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
int nb_wall_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token);
/* `grading NAME {radius R}`, behind the word: index of the grading, and of its size or -1; -1 with a message. */
int nb_take_grading(const struct nb_scene *scene, struct nb_reader *reader, int *size);
/* A quantity's name, with its place; and the quantity of that name: false with a message in place when there is none. */
bool nb_take_requested(struct nb_reader *reader, struct nb_requested *requested);
bool nb_requested_find(struct nb_scene_reading *reading, struct nb_quantity *quantity,
                       const struct nb_requested *requested);
enum { NB_AT_XX, NB_AT_YY, NB_AT_XY, NB_AT_C12, NB_AT_C21, NB_AT_BEHIND_STRAIN }; /* their slots */
/* EXX EYY, and `shear EXY` or `c12 C` and `c21 C`: all of them per cycle, or none. */
bool nb_is_per_cycle(const struct nb_reader *reader,
                     const struct nb_value *value); /* whether its unit is `per cycle` */
struct nb_strain_rate nb_strain_of(struct nb_reader *reader, const struct nb_value value[]);
/* A body of that shape and material, at (0, 0), of which there will be `count`: it is free, or fixed, and the material has mass then. */
struct nb_particle nb_particle_of(struct nb_reader *reader, const struct nb_scene *scene, enum nb_shape shape,
                                  const struct nb_token *material, bool fixed, size_t count);
/* Adds something watched under that name; not where there is one already, or too many. */
bool nb_monitor_add(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name,
                    struct nb_monitor monitor);
/* Names a stage or a leg; one that is read again NAME-2, NAME-3, … */
void nb_stage_name(struct nb_stage *stage, const struct nb_scene_reading *reading, const struct nb_token *name);

/* ---- settings and runs ---- */

/* The last --set of that name: its line among the settings; 0: none. */
size_t nb_setting_find(const struct nb_scene_reading *reading, const char *name);
/* Says every --set that nothing on the page answers to, and obeys those for laws and step. */
void nb_settings_read(struct nb_scene_reading *reading);
/* All runs of the page so far: the product of the sweeps. */
size_t nb_runs(const struct nb_scene_reading *reading);
/* What a state depends on: begun with the settings; then each statement. */
unsigned long long nb_hash_settings(nb_settings settings);
void nb_hash_line(struct nb_scene_reading *reading);

/* ---- what must hold at the end of a page ---- */

void nb_laws_check(struct nb_scene_reading *reading);    /* what the laws ask of materials and bodies */
void nb_regions_check(struct nb_scene_reading *reading); /* finds the stages that regions name */
void nb_cell_check(struct nb_scene_reading *reading);    /* a cell is wide enough, and there are no walls in it */
void nb_ramps_check(struct nb_scene_reading *reading);   /* a ramp wants a stage whose length is known */
void nb_boxes_check(struct nb_scene_reading *reading);   /* what follows a box moves in one way, and does not turn */
void nb_drives_check(
    struct nb_scene_reading *reading); /* what is carried along is not reversed, nor is a boundary in a cell */
void nb_path_check(struct nb_scene_reading *reading);      /* what a path must have; --follow replaces its legs */
void nb_path_laws_check(struct nb_scene_reading *reading); /* what a path's quantities ask of the laws */
/* Puts what `impact` names where it just touches, and gives it its velocity: materials, pairs and laws must be known. */
void nb_impact_aim(struct nb_scene_reading *reading);
/* Moves all that has been read as `transform` says. At the end of reading: it wants the motions of walls in the stages too. */
bool nb_scene_place(struct nb_scene *scene, const struct nb_place *place); /* false: something is too far away */

/* ---- a page that another one starts from ---- */

/* The scene of another page, for the one that is being read; *runs: how many its sweeps make. */
enum nb_status nb_scene_read_below(struct nb_scene *scene, const struct nb_page *page, nb_settings settings,
                                   struct nb_mistakes *mistakes, const struct nb_scene_reading *above, size_t *runs);
void nb_start_free(struct nb_start *start);
void nb_stages_free(struct nb_scene *scene, size_t from); /* those from there on */
void nb_scene_cut(struct nb_scene *scene, size_t stage);  /* behind that stage; nobody looks at it any more */

#endif
