/* Loading of an assembly: the functions that run/ and input/ call.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/affine.h"
#include "core/boundary.h"

/* ---- boundary.c: boundary of an assembly; rotation of particles ---- */
void nb_rotation_begin(struct nb_model *model, bool rotates); /* `rotation on` or `rotation off` */
/* Creates the boundary of a scene that has one. Called before the first search. */
enum nb_status nb_boundary_create(struct nb_model *model, struct nb_error *error);
/* Carries out the statements of a stage that concern the boundary. */
enum nb_status nb_boundary_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
/* Adds the particles that have crossed the ellipse to a held boundary. */
enum nb_status nb_boundary_before_motion(struct nb_model *model, struct nb_error *error);
/* Deforms the ellipse of a held boundary, and sets the forces of a stress. */
void nb_boundary_after_motion(struct nb_model *model);
void nb_boundary_remove(struct nb_model *model, size_t slot); /* for a particle that is removed from the scene */
/* Sets the velocities of a held boundary's particles. Called before the motion if no other particle has an imposed
 * motion. */
void nb_boundary_set_velocities(struct nb_model *model);
/* Sets the forces of a stress on the boundary, from the current positions. */
void nb_boundary_set_forces(struct nb_model *model);

/* ---- affine.c: imposed affine motion ---- */
/* Creates model->affine, or leaves it NULL if the scene imposes no affine motion. */
enum nb_status nb_affine_create(struct nb_model *model, struct nb_error *error);
/* Sets the strain rates of a stage. Called after the step of the stage is set. */
void nb_affine_begin(struct nb_model *model, const struct nb_stage *stage);
/* The strain rate that a stage gives to the source. Sets *line to the line of the statement; 0: there is none. */
const struct nb_strain_rate *nb_affine_given(const struct nb_stage *stage, enum nb_affine_source source, int *line);
/* Index of the earlier stage whose strain rate of this source still applies in `stage` and is not 0; -1: none. Sets
 * *line to the line of its statement. */
int nb_affine_inherited(const struct nb_scene *scene, size_t stage, enum nb_affine_source source, int *line);
/* Prepares the imposed motion of the next step. Called before the motion. True: every particle has an imposed velocity;
 * false: only particles of a boundary may have one. */
bool nb_affine_step(struct nb_model *model);
/* Some particle moved affinely in the last step or moves so in this one, or a servo may make it move. */
bool nb_affine_moves(const struct nb_model *model);
bool nb_affine_ends(const struct nb_model *model); /* some particle moved affinely in the last step, none in this one */
void nb_affine_clear(struct nb_model *model);      /* sets all imposed velocities to 0 */
void nb_affine_remove(struct nb_model *model, size_t slot); /* for a particle that is removed from the scene */

/* ---- box.c: four walls that follow a strain rate, and the stress on them ---- */
enum { NB_BOX_SIDES = 4 }; /* walls of a box; sides w and w + 2 are opposite */
/* Index of the box's first wall; its walls are in the order south, east, north, west. -1: no box. */
int nb_box_first_wall(const struct nb_scene *scene);
/* True if the walls follow the box's strain rate in the stage with this index: this stage or an earlier one has `box
 * strain` or a servo through the box, and since then no stage has moved one of the walls. */
bool nb_box_strained_in(const struct nb_scene *scene, size_t stage);
bool nb_box_is_strained(const struct nb_model *model); /* the same for the current stage */
/* Sets the velocities of the box's walls for the next step. Called before the motion. */
void nb_box_set_velocities(struct nb_model *model);
struct nb_vec nb_box_sides(const struct nb_model *model);         /* current width and height of the box, m */
double nb_box_porosity(const struct nb_model *model);             /* areal porosity of the box, 1 */
struct nb_vec nb_box_initial_sides(const struct nb_scene *scene); /* width and height at time 0, m */
struct nb_tensor nb_box_stress(const struct nb_model *model);     /* stress of the box, Pa (box.c) */
struct nb_tensor nb_walls_stress(const struct nb_model *model);   /* mean traction of opposite walls, Pa */
/* Normal force on the east and the west wall over the normal force on the south and the north wall, 1; 0 if the latter
 * is 0. */
double nb_walls_ratio(const struct nb_model *model);
double nb_walls_residual(const struct nb_model *model); /* magnitude of the sum of the forces of the four walls, N */

/* ---- servo.c: strain rates that bring a stress to its target ---- */
/* Begins the servo of the current stage. Called after the other statements of the stage have been applied. */
void nb_servo_begin(struct nb_model *model);
/* True if the strain rate is not 0 in a component that the servo controls. */
bool nb_servo_opposes(const struct nb_servo *servo, const struct nb_strain_rate *rate);
/* Sets *b to B, Pa, and *t to T, s, of servo.c, for the current contacts. False: no boundary, or nothing
 * touches. */
bool nb_servo_scales(const struct nb_model *model, const struct nb_servo *servo, double *b, double *t);
/* Largest difference of a controlled stress from its target, over the largest target, 1; 0 in a stage without a servo
 * or with targets of 0. */
double nb_servo_error(const struct nb_model *model);
/* The fraction of a target from which on a controlled stress counts as near it. With 0.9 an isotropic stress ended up to 20 %
 * below its target on 120 discs, with 0.99 up to 1.2 %. */
#define NB_SERVO_NEAR 0.99
/* Writes the conditions of an `until` that the controlled stresses are near their targets: "cell.stress.xx above 990 Pa and
 * cell.stress.yy above 990 Pa". False: the servo controls no stress, or its targets are 0. */
bool nb_servo_condition(char *text, size_t size, const struct nb_scene *scene, const struct nb_servo *servo,
                        bool unitless);
void nb_servo_apply(struct nb_model *model); /* sets the strain rates of the next steps; called before the motion */

/* ---- remove.c: removes the particles and walls that a stage removes ---- */
/* Searches after pairs have ended or can touch now; called between nb_balance_exclude(model, true) and the next step.
 * Pairs that overlap without a force count in the balance as springs that appear loaded. */
enum nb_status nb_pairs_changed(struct nb_model *model, struct nb_error *error);
enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
