/* What moves an assembly from outside: what the run, and statements, call of each loading.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LOADING_H
#define NB_LOADING_H

#include "core/boundary.h"

/* ---- boundary.c: the boundary of an assembly, and whether bodies turn ---- */
enum nb_status nb_boundary_create(struct nb_model *model, struct nb_error *error); /* before the first search */
enum nb_status nb_boundary_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
/* Before the motion, takes in who has crossed the circle; and after it. */
enum nb_status nb_boundary_before_motion(struct nb_model *model, struct nb_error *error);
void nb_boundary_after_motion(struct nb_model *model);
void nb_boundary_remove(struct nb_model *model, size_t slot); /* that is taken out of the scene */
void nb_boundary_set_velocities(struct nb_model *model);      /* before the motion, where nothing else is carried */
void nb_boundary_set_forces(struct nb_model *model); /* sets drive->boundary_force for where the bodies are now */

/* ---- affine.c: imposed affine motion ---- */
/* model->carry stays NULL: nothing is. */
enum nb_status nb_affine_create(struct nb_model *model, struct nb_error *error);
void nb_affine_begin(struct nb_model *model, const struct nb_stage *stage); /* once the stage's step is known */
/* Before the motion: whether it carries all bodies; else only a boundary's are carried. */
bool nb_affine_step(struct nb_model *model);
void nb_affine_clear(struct nb_model *model);               /* no imposed motion so far */
void nb_affine_remove(struct nb_model *model, size_t slot); /* that is taken out of the scene */

/* ---- box.c: four walls that follow a strain rate, and the stress on them ---- */
/* Index of its first wall, of south, east, north, west; -1: there is none. */
int nb_box_first_wall(const struct nb_scene *scene);
/* Whether its walls follow the box's strain rate in that stage: a stage says so, or has a servo by the box, and none since then has
 * moved one of them otherwise. */
bool nb_box_strained_in(const struct nb_scene *scene, size_t stage);
bool nb_box_is_strained(const struct nb_model *model);    /* the same in the stage that runs */
void nb_box_set_velocities(struct nb_model *model);       /* before the motion: how its walls go over the step ahead */
struct nb_vec nb_box_sides(const struct nb_model *model); /* from west to east, from south to north, m */
struct nb_vec nb_box_initial_sides(const struct nb_scene *scene); /* the same at time 0 */
struct nb_tensor nb_box_stress(const struct nb_model *model);     /* from the forces on its walls, Pa */

/* ---- servo.c: strain rates that bring a stress to where it should be ---- */
void nb_servo_begin(struct nb_model *model); /* once the stage's other statements hold */
/* B, Pa, and T, s, that gains are made of now; false: there is nothing yet that a servo could move, or nothing is pressed. */
bool nb_servo_scales(const struct nb_model *model, const struct nb_servo *servo, double *b, double *t);
void nb_servo_apply(struct nb_model *model); /* before a motion: the strain rates over the steps to come */

/* ---- remove.c: bodies that a stage takes out ---- */
enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);

#endif
