/* A box of four walls that follow a strain rate, and the stress on them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BOX_H
#define NB_BOX_H

#include <stdbool.h>
#include <stddef.h>

#include "core/tensor.h"

struct nb_model;
struct nb_scene;

int nb_box_of(
    const struct nb_scene *scene); /* index of its first wall, of south, east, north, west; -1: there is none */
/* Whether its walls follow the box's strain rate in that stage: a stage says so, or has a servo by the box, and none since then has
 * moved one of them otherwise. */
bool nb_box_follows(const struct nb_scene *scene, size_t stage);
bool nb_box_is_strained(const struct nb_model *model);    /* the same in the stage that runs */
void nb_box_drive(struct nb_model *model);                /* before the motion: how its walls go over the step ahead */
struct nb_vec nb_box_sides(const struct nb_model *model); /* from west to east, from south to north, m */
struct nb_vec nb_box_first(const struct nb_scene *scene); /* the same at time 0 */
struct nb_tensor nb_box_stress(const struct nb_model *model); /* from the forces on its walls, Pa */

#endif
