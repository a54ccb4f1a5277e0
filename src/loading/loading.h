/* Loading of an assembly: the functions that run/ and input/ call.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LOADING_H
#define NB_LOADING_H

#include "core/boundary.h"

/* ---- boundary.c: boundary of an assembly; rotation of particles ---- */
void nb_rotation_begin(struct nb_model *model, bool rotates);                      /* `rotation on` or `off` */
enum nb_status nb_boundary_create(struct nb_model *model, struct nb_error *error); /* before the first search */
enum nb_status nb_boundary_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
/* Adds the particles that have crossed the circle to a held boundary. */
enum nb_status nb_boundary_before_motion(struct nb_model *model, struct nb_error *error);
void nb_boundary_after_motion(struct nb_model *model);
void nb_boundary_remove(struct nb_model *model, size_t slot); /* a particle that is removed from the scene */
/* Sets the velocities of a held boundary before the motion, if no other particle has an imposed motion. */
void nb_boundary_set_velocities(struct nb_model *model);
void nb_boundary_set_forces(struct nb_model *model); /* of a stress on the boundary, at the present positions */

/* ---- affine.c: imposed affine motion ---- */
/* Leaves model->affine NULL if the scene imposes no motion. */
enum nb_status nb_affine_create(struct nb_model *model, struct nb_error *error);
void nb_affine_begin(struct nb_model *model, const struct nb_stage *stage); /* after the stage's step is set */
/* Before the motion. True: every particle has an imposed velocity; false: only those of a boundary. */
bool nb_affine_step(struct nb_model *model);
bool nb_affine_moves(const struct nb_model *model); /* some particle in this step of the stage or in the last one */
bool nb_affine_ends(const struct nb_model *model);  /* only in the last one */
void nb_affine_clear(struct nb_model *model);       /* sets all imposed velocities to 0 */
void nb_affine_remove(struct nb_model *model, size_t slot); /* a particle that is removed from the scene */

/* ---- box.c: four walls that follow a strain rate, and the stress on them ---- */
/* Index of the first of its walls south, east, north, west; -1: no box. */
int nb_box_first_wall(const struct nb_scene *scene);
/* Whether the walls follow the box's strain rate in that stage: this stage or an earlier one has `box strain` or a
 * servo through the box, and no later one has moved one of the walls. */
bool nb_box_strained_in(const struct nb_scene *scene, size_t stage);
bool nb_box_is_strained(const struct nb_model *model);    /* in the present stage */
void nb_box_set_velocities(struct nb_model *model);       /* of its walls over the next step; before the motion */
struct nb_vec nb_box_sides(const struct nb_model *model); /* width and height, m */
struct nb_vec nb_box_initial_sides(const struct nb_scene *scene); /* at time 0, m */
struct nb_tensor nb_box_stress(const struct nb_model *model);     /* from the forces on its walls, Pa */
struct nb_tensor nb_walls_stress(const struct nb_model *model);   /* mean traction of opposite walls, Pa */
double nb_walls_ratio(const struct nb_model *model);    /* normal force on east and west over south and north */
double nb_walls_residual(const struct nb_model *model); /* sum of the forces of the four walls, magnitude, N */

/* ---- servo.c: strain rates that bring a stress to its target ---- */
void nb_servo_begin(struct nb_model *model); /* after the stage's other statements */
/* B, Pa, and T, s, for the present contacts; false: no boundary, or no contact that touches. */
bool nb_servo_scales(const struct nb_model *model, const struct nb_servo *servo, double *b, double *t);
void nb_servo_apply(struct nb_model *model); /* sets the strain rates of the next steps; before the motion */

/* ---- remove.c: particles that a stage removes ---- */
enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);

#endif
