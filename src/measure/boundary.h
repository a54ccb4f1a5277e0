/* Area, radius and roughness of the boundary of an assembly, and the stress on it: boundary.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/boundary.h"

static inline bool nb_boundary_exists(const struct nb_model *model) {
  return model->boundary && model->boundary->ring.exists;
}
/* The vector from the boundary's centre to the boundary particle with the index k, m. The indices run counterclockwise;
 * k counts modulo the number of these particles. */
static inline struct nb_vec nb_boundary_position(const struct nb_model *model, size_t k) {
  const struct nb_ring *ring = &model->boundary->ring;
  return vec_sub(model->particles.position[ring->member[k % ring->count]], model->affine->centre);
}
double nb_boundary_area(const struct nb_model *model); /* area of the polygon through the particles' centres, m2 */
/* Mean distance of the particles' centres from the boundary's centre, m. */
double nb_boundary_radius(const struct nb_model *model);
/* Standard deviation of these distances over their mean, 1. */
double nb_boundary_roughness(const struct nb_model *model);
struct nb_tensor nb_boundary_stress(const struct nb_model *model); /* from the forces on the boundary's particles, Pa */
