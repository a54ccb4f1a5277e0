/* Area, radius and roughness of the boundary of an assembly, and the stress on it: boundary.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BOUNDARY_MEASURE_H
#define NB_BOUNDARY_MEASURE_H

#include "core/boundary.h"

static inline bool nb_boundary_exists(const struct nb_model *model) {
  return model->boundary && model->boundary->ring.exists;
}
/* From the boundary's centre to its k-th particle, counterclockwise, k modulo the number of particles, m. */
static inline struct nb_vec nb_boundary_position(const struct nb_model *model, size_t k) {
  const struct nb_ring *ring = &model->boundary->ring;
  return vec_sub(model->particles.position[ring->member[k % ring->count]], model->affine->centre);
}
double nb_boundary_area(const struct nb_model *model); /* of the polygon through the centres, m2 */
/* Mean distance of the particles' centres from the boundary's centre, m. */
double nb_boundary_radius(const struct nb_model *model);
double nb_boundary_roughness(const struct nb_model *model);        /* their standard deviation over the mean, 1 */
struct nb_tensor nb_boundary_stress(const struct nb_model *model); /* from the forces on its particles, Pa */

#endif
